//! Which blocks are cut, and by which planes.

use riprap_geom::Vec3;
use riprap_geom::polyhedron::cut::{self, FaceOrigin, Limits, Part, Planes};

use crate::deform::build::stiffness;
use crate::faces::deformable::centred;
use crate::laws::fracture;
use crate::laws::fracture::Rock;
use crate::laws::tetrahedron::row_sums;
use crate::query::view::View;
use crate::setup::deform::{CutAnchor as Anchor, CutRules as Rules};
use crate::setup::{Shape, Solid};
use crate::state::deform::{Body, Deform};
use crate::state::event::Note;
use crate::state::workspace::{BODIES, BlockClass, Workspace};
use crate::state::world::World;
use crate::topology::cut::tip;
use crate::topology::cut::tip::Tip;
use crate::topology::cut::transfer::{self, Cut};

/// The parts together must have the volume of the block up to this share.
const SAME_VOLUME: f64 = 1e-11;
/// Largest ratio of the kinetic energies after and before; a block that would have more is not cut.
const KINETIC: f64 = 1.005;
/// A face of a part lies on a plane up to this share of the size of the part: snapping makes faces crooked.
const ON_PLANE: f64 = 1e-2;

/// Blocks whose criterion is met, in the order of their numbers, with their parts.
pub(super) fn plan(view: &View<'_>, rules: &Rules) -> Vec<Cut> {
    let Some(planner) = Planner::new(view, rules) else {
        return Vec::new();
    };
    let bodies = &planner.deform.bodies;
    let found = view.scratch.exec.map(bodies, BODIES, |some| {
        let living = some.iter().filter(|b| b.alive);
        living.filter_map(|b| planner.cut(b)).collect::<Vec<_>>()
    });
    let mut cuts: Vec<Cut> = found.into_iter().flatten().collect();
    cuts.sort_by_key(|c| c.block);
    cuts
}

/// What is the same for all blocks.
struct Planner<'a> {
    world: &'a World,
    deform: &'a Deform,
    work: &'a Workspace,
    rules: &'a Rules,
    /// Where cuts begin; `None` where they may begin anywhere.
    tips: Option<tip::Front>,
}

/// Blocks whose criterion is met and that stay whole because their faces are crooked ([`Uncut::Crooked`]).
pub(super) fn crooked(view: &View<'_>, rules: &Rules) -> usize {
    let Some(planner) = Planner::new(view, rules) else {
        return 0;
    };
    let living = planner.deform.bodies.iter().filter(|b| b.alive);
    let crooked = living.filter(|b| matches!(planner.divided(b), Some((_, Err(Uncut::Crooked)))));
    crooked.count()
}

impl<'a> Planner<'a> {
    /// `None` where nothing deforms.
    fn new(view: &View<'a>, rules: &'a Rules) -> Option<Self> {
        let (deform, work) = view.deformables()?;
        let world = view.world;
        let tips = match rules.anchor {
            Anchor::Spacing => None,
            Anchor::Tip => Some(tip::Front::new(world, deform)),
        };
        Some(Self { world, deform, work, rules, tips })
    }

    /// What planes make of a block whose criterion is met, and why they are cut there.
    fn divided(&self, body: &Body) -> Option<(Note, Result<Vec<Part>, Uncut>)> {
        let (world, deform, work, rules) = (self.world, self.deform, self.work, self.rules);
        let block = body.block;
        // Of deformable blocks, which are never split, the number of cuts.
        let generation = world.lineage[block as usize].level;
        if generation >= rules.generations {
            return None;
        }
        let rock = rock(world, block)?;
        let tip = match &self.tips {
            None => None,
            Some(front) => Some(front.touching(world, deform, block)?),
        };
        let (stress, gradient) = deform.average(work, body);
        let principal = fracture::principal(&stress, rules.along);
        let verdict = fracture::assess(&rock, rules.criterion, &rules.margins, &principal);
        if !verdict.cut() {
            return None;
        }
        let normal = fracture::cut_normal(&rock, verdict.mode, &principal, &gradient, None);
        // A part gets the plane that was missing, not a full set.
        let planes = if tip.is_some() && generation > 0 { 1 } else { rules.planes };
        let at = tip.map(|t| t.at);
        let limits = (rules.snap, rules.smallest);
        let volume = work.class(body).mesh.volume();
        let parts = divide(world, (block, volume), normal, planes, limits, at);
        if let (Ok(made), Some(tip)) = (&parts, &tip)
            && !goes_on(world, block, normal, made, tip)
        {
            return None;
        }
        let note = Note { normal, mode: verdict.mode, excess: verdict.excess };
        Some((note, parts))
    }

    /// The cut of a block whose criterion is met.
    fn cut(&self, body: &Body) -> Option<Cut> {
        let (world, deform, work, rules) = (self.world, self.deform, self.work, self.rules);
        let (note, parts) = self.divided(body)?;
        let cut = cut(world, (deform, work), body, note, parts.ok()?);
        // Velocities and time steps mean nothing while everything relaxes.
        let moving = deform.relax.is_none();
        let fast = |cut: &Cut| cut.handed.after.kinetic > KINETIC * cut.handed.before.kinetic;
        if moving && (fast(&cut) || too_slow(world, work.class(body), &cut, rules)) {
            return None;
        }
        Some(cut)
    }
}

/// The cut of a body into parts (about its centroid), with what they take over from it.
pub(super) fn cut(
    world: &World,
    (deform, work): (&Deform, &Workspace),
    body: &Body,
    note: Note,
    mut parts: Vec<Part>,
) -> Cut {
    let block = body.block;
    let centre = world.reference[block as usize];
    let shape = |part: &Part| {
        Shape::Polyhedron(Box::new(Solid {
            vertices: part.solid.vertices.iter().map(|v| *v + centre).collect(),
            faces: part.solid.faces.clone(),
        }))
    };
    let shapes: Vec<Shape> = parts.iter().map(shape).collect();
    let material = world.setup.blocks[block as usize].material;
    // As they will be made from the shapes after a restart, to the last bit.
    let class = |shape| BlockClass::new(&world.setup, deform, (shape, material), false);
    let classes: Vec<BlockClass> = shapes.iter().map(class).collect();
    let handed = transfer::hand_on(deform, work, body, &parts, &classes);
    for part in &mut parts {
        // Nobody asks for them any more, and there may be very many parts.
        part.mesh.gradients = Vec::new();
    }
    Cut { block, note, parts, shapes, classes, handed }
}

/// Whether a part would need a time step below the floor.
fn too_slow(world: &World, parent: &BlockClass, cut: &Cut, rules: &Rules) -> bool {
    if rules.step_floor <= 0.0 {
        return false;
    }
    let m = usize::from(world.setup.blocks[cut.block as usize].material);
    let Some(bond) = &world.setup.interfaces[usize::from(world.setup.row_of([m; 2]))].bond else {
        return false;
    };
    let Ok([across, along]) = stiffness(&world.setup, bond, [m; 2], [false; 2], [0.0; 2]) else {
        return false;
    };
    // Gershgorin's bound of the squared frequency, with a bond on every face.
    let bound = |class: &BlockClass| {
        let mut rows = row_sums(&class.mesh, &class.law);
        for face in 0..class.faces.len() {
            for (node, area) in class.mesh.tributary(face) {
                rows[node as usize] += 2.0 * area * across.max(along);
            }
        }
        let terms = rows.iter().zip(class.masses()).map(|(k, m)| k / m);
        terms.fold(0.0, f64::max)
    };
    let most = cut.classes.iter().map(bound).fold(0.0, f64::max);
    rules.step_floor * rules.step_floor * most > bound(parent)
}

/// Strength of a block: that of bonds within its material.
fn rock(world: &World, block: u32) -> Option<Rock> {
    let m = usize::from(world.setup.blocks[block as usize].material);
    let law = &world.setup.interfaces[usize::from(world.setup.row_of([m; 2]))];
    let strength = law.bond.as_ref()?.strength?;
    Some(Rock {
        tension: strength.tension,
        cohesion: strength.cohesion,
        friction: strength.friction,
    })
}

/// Whether the plane through a tip leads on from it within the block.
fn goes_on(world: &World, block: u32, normal: Vec3, parts: &[Part], tip: &Tip) -> bool {
    let centre = world.reference[block as usize];
    let n = normal.normalize();
    let height = n.dot(tip.at - centre);
    parts.iter().any(|part| {
        let faces = part.origins.iter().enumerate();
        let mut cuts = faces.filter(|(_, origin)| matches!(origin, FaceOrigin::Plane(_)));
        cuts.any(|(f, _)| {
            let middle = part.solid.face_centre(f);
            let through = (n.dot(middle) - height).abs() <= ON_PLANE * part.solid.size();
            through && tip.leads_to(middle + centre)
        })
    })
}

/// Why a block is not divided.
pub(super) enum Uncut {
    /// No plane can be cut, or a part would be too small.
    Small,
    /// An earlier cut has left its faces crooked: the parts together would not have its volume.
    Crooked,
}

/// Parts of a block about its centroid; `volume` (m³) is that of its tetrahedra, `at` (m, local) the tip that a plane must go through.
pub(super) fn divide(
    world: &World,
    (block, volume): (u32, f64),
    normal: Vec3,
    planes: u32,
    (snap, smallest): (f64, f64),
    at: Option<Vec3>,
) -> Result<Vec<Part>, Uncut> {
    let (solid, _) = centred(&world.setup.blocks[block as usize].shape);
    let at = at.map(|at| at - world.reference[block as usize]);
    let planes = match at {
        None => Planes::Spaced { count: planes },
        Some(at) => Planes::Anchored { count: planes, at },
    };
    let limits = Limits { snap, ..Limits::default() };
    let made = cut::cut(&solid, normal, planes, &limits).map_err(|_| Uncut::Small)?;
    let height = at.map(|at| normal.normalize().dot(at));
    let near = |d: &f64| height.is_none_or(|h| (d - h).abs() <= 1e-9 * solid.size());
    if made.parts.len() < 2 || !made.offsets.iter().any(near) {
        return Err(Uncut::Small);
    }
    let volumes = made.parts.iter().map(|p| p.mesh.volume());
    let least = volumes.clone().fold(f64::INFINITY, f64::min);
    if least < smallest * smallest * smallest {
        return Err(Uncut::Small);
    }
    // Both: mass is that of the tetrahedra, and the shapes are what a restart begins with.
    let total: f64 = volumes.sum();
    let same = |whole: f64| (total - whole).abs() <= SAME_VOLUME * whole;
    if same(solid.moments().volume) && same(volume) { Ok(made.parts) } else { Err(Uncut::Crooked) }
}
