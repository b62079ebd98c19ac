//! What is the same for a pair of the candidate list in all steps.

use riprap_geom::Vec3;

use crate::contact::{facing, glued, limit};
use crate::exec::Exec;
use crate::joint::classes::stiffness;
use crate::kernel::glued::Glued;
use crate::kernel::{ContactLaw, PairKey, Pose, Shape};
use crate::setup::{InterfaceLaw, Setup};
use crate::state::contact_scratch::{Constants, ContactScratch, FacePair, PairKind};
use crate::state::found::FoundPair;
use crate::state::world::World;

/// Finds what is the same for all pairs of the candidate list until the next one.
pub(super) fn find(world: &World, desk: &mut ContactScratch, exec: &Exec) {
    desk.rows = world.setup.interfaces.iter().map(of_row).collect();
    let blocks = 0..world.alive.len();
    desk.inverse_masses = blocks.map(|b| inverse_mass(world, b)).collect();
    let on_ground: Vec<Constants> = world.found.pairs[desk.candidates.pairs.len()..]
        .iter()
        .map(|pair| of_ground(world, desk, pair.ends))
        .collect();
    let (lists, shapes, glued) = (&desk.candidates.lists, &desk.shapes, &desk.glued);
    let candidates = &desk.candidates.pairs;
    let rows = &desk.rows;
    let of_run = |run: std::ops::Range<usize>| -> (Vec<Constants>, Vec<FacePair>) {
        let mut constants = Vec::with_capacity(run.len());
        let mut facings = Vec::new();
        for c in &candidates[run] {
            let ends = c.ends;
            let (mut found, facing) = if ends.iter().any(|b| world.is_glued(*b as usize)) {
                constants_of_glued(world, (shapes, glued), &c.key(), rows)
            } else {
                constants_of(world, shapes, &c.key(), rows, c.faces(lists))
            };
            if let Some(facing) = facing {
                found.facing = facings.len() as u32;
                facings.push(facing);
            }
            constants.push(found);
        }
        (constants, facings)
    };
    let runs = exec.chunked(candidates.len(), of_run);
    desk.constants = Vec::with_capacity(world.found.pairs.len());
    desk.facings = Vec::with_capacity(runs.iter().map(|run| run.1.len()).sum());
    for (constants, facings) in runs {
        let first = desk.facings.len() as u32;
        desk.constants.extend(constants.into_iter().map(|mut found| {
            if found.facing != Constants::NO_FACING {
                found.facing += first;
            }
            found
        }));
        desk.facings.extend(facings);
    }
    desk.constants.extend(on_ground);
    let damps = |c: &Constants| desk.rows[usize::from(c.row)].damping_ratio > 0.0;
    desk.damped = desk.constants.iter().any(damps);
}

/// 1 over the mass of a block, 1/kg; 0 for what no contact can move.
pub(super) fn inverse_mass(world: &World, b: usize) -> f64 {
    let [free, _] = world.freedoms(b);
    if free == Vec3::ZERO { 0.0 } else { 1.0 / world.solid_of(b).mass }
}

/// Poses of the blocks of a pair when the candidate list was made, and the way that both together may go until the next one, m.
fn placed(world: &World, key: &PairKey) -> ([Pose; 2], f64) {
    let search = &world.found.search;
    let margins = key.ends.map(|b| search.margin[b as usize]);
    let pose = |side: usize| {
        let Pose { position, rotation } = search.pose[key.ends[side] as usize];
        Pose { position: key.place(side, position, &world.setup.periodic), rotation }
    };
    ([pose(0), pose(1)], margins.iter().sum())
}

/// What is the same in all steps for a pair, and faces of both that can come flat onto each other.
fn constants_of(
    world: &World,
    shapes: &[Shape],
    key: &PairKey,
    rows: &[ContactLaw],
    faces: [&[u16]; 2],
) -> (Constants, Option<FacePair>) {
    let (poses, margin) = placed(world, key);
    let ends = key.ends;
    let shape = ends.map(|b| &shapes[world.solid[b as usize] as usize]);
    let constants = Constants {
        largest: facing::largest_area(shape, faces),
        ..plain(&world.setup, ends, shape.map(|s| s.inradius))
    };
    let law = constants.law(rows);
    let facing = facing::facing(shape, poses, margin, faces.map(|f| f.iter().copied()));
    let eases = || ends.map(|b| limit::InverseInertia::of(world, shapes, b as usize));
    let with_square = |found: FacePair| found.with_square(eases(), poses, &law);
    (constants, facing.map(with_square))
}

/// The same for a pair with a block of glued parts.
fn constants_of_glued(
    world: &World,
    (shapes, glued): (&[Shape], &[Glued]),
    key: &PairKey,
    rows: &[ContactLaw],
) -> (Constants, Option<FacePair>) {
    let (poses, margin) = placed(world, key);
    let ends = key.ends;
    let of = ends.map(|b| &glued[world.solid[b as usize] as usize]);
    let constants = Constants {
        largest: of[0].largest.min(of[1].largest),
        kind: PairKind::Glued,
        ..plain(&world.setup, ends, of.map(|glued| glued.inradius))
    };
    let law = constants.law(rows);
    let eases = || ends.map(|b| limit::InverseInertia::of(world, shapes, b as usize));
    let with_square = |found: FacePair| found.with_square(eases(), poses, &law);
    let facing = glued::facing(of, poses, margin, with_square);
    (constants, facing)
}

/// The same for a block on terrain: behind terrain there is no centroid, so it counts as deep as the block.
fn of_ground(world: &World, desk: &ContactScratch, ends: [u32; 2]) -> Constants {
    let place = desk.terrain.blocks.binary_search(&ends[0]).unwrap_or_default();
    let inradius = desk.inradius(world.solid[ends[1] as usize]);
    Constants { kind: PairKind::Terrain(place as u16), ..plain(&world.setup, ends, [inradius; 2]) }
}

/// The interface of two blocks and its stiffness; `depths` are their inradii, m.
fn plain(setup: &Setup, ends: [u32; 2], depths: [f64; 2]) -> Constants {
    let materials = ends.map(|b| setup.blocks[b as usize].material as usize);
    let row = setup.pair_table[materials[0] * setup.materials.len() + materials[1]];
    // Checked when the model was built; NaN would stop the run at once.
    let stiffness = stiffness(setup, row, materials, depths).map_or([f64::NAN; 2], |found| found.0);
    Constants {
        stiffness,
        inradius: depths[0].min(depths[1]),
        largest: 0.0,
        facing: Constants::NO_FACING,
        row,
        kind: PairKind::Convex,
    }
}

/// The law of a pair as the setup has it now.
pub(super) fn present(world: &World, desk: &ContactScratch, pair: &FoundPair) -> ContactLaw {
    let [i, j] = pair.ends.map(|b| desk.inradius(world.solid[b as usize]));
    let ground = world.is_terrain(pair.ends[0] as usize);
    law(&world.setup, pair.ends, [if ground { j } else { i }, j])
}

/// The law between two blocks; `depths` are their inradii, m.
pub(crate) fn law(setup: &Setup, ends: [u32; 2], depths: [f64; 2]) -> ContactLaw {
    let found = plain(setup, ends, depths);
    let row = of_row(&setup.interfaces[usize::from(found.row)]);
    Constants { row: 0, ..found }.law(&[row])
}

/// The law of an interface but for its stiffness, which hangs on the blocks: residual strength and damping, and the growth of pressures at the depth of the smaller inradius.
fn of_row(interface: &InterfaceLaw) -> ContactLaw {
    let joint = &interface.joint;
    // An elastic joint neither opens nor slides; a found contact under its law must open, and slides if it is told when.
    let elastic = interface.friction.unwrap_or(f64::INFINITY);
    let (friction, cohesion) =
        joint.strength.map_or((elastic, 0.0), |s| (s.residual_friction, s.residual_cohesion));
    ContactLaw {
        normal_stiffness: f64::NAN,
        shear_stiffness: f64::NAN,
        friction,
        cohesion,
        damping_ratio: joint.contact_damping,
        rebound: joint.rebound,
        growth: if joint.stiffening > 0.0 {
            1.0 / (joint.stiffening * joint.stiffening)
        } else {
            0.0
        },
    }
}
