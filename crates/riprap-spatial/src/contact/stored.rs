//! What found contacts store across themselves: known only as the work on them, and from above and below.
//!
//! Two blocks that are drawn apart along the force F of their contact have parted after the way D by which their projections on it overlap. F
//! falls on that way at least as fast as what is left of it, so that the energy is `F D/2` at most: all of it where faces meet flat, two thirds at
//! an edge, half at a corner. D is the depth of a face; it is more than the diameter of the largest ball in both blocks, by
//! which depths are measured, where edges are sharp: `(1 + 1/sin b)/2` times as much at an edge of the half angle b on a
//! face, `1/sin b` times between two such edges. A flat contact as deep as the largest ball in the thinner block is softer by its rim than a face without
//! end, and stores up to a fifth more than `F D/2`.

use riprap_geom::Vec3;

use crate::exec::Exec;
use crate::kernel::Shape;
use crate::kernel::glued::Glued;
use crate::ledger::Works;
use crate::state::contact_scratch::{ContactScratch, PairKind};
use crate::state::found::{ContactPatch, FoundPair};
use crate::state::world::World;

/// What the rim of a contact as deep as the largest ball in the thinner block may store beside it.
const RIM: f64 = 0.25;

/// How closely the energy of contacts is bounded.
#[derive(Clone, Copy, PartialEq)]
enum Bound {
    /// By the diameter of the largest ball in both blocks: too little where edges are sharp.
    Ball,
    /// By the way on which they part.
    Way,
}

/// What is stored in the pressure of found contacts lies between these, J. What a joint has handed over is known.
fn bounds(world: &World, desk: &ContactScratch, exec: &Exec, bound: Bound) -> [f64; 2] {
    let pairs = &world.found.pairs;
    exec.sums(pairs.len(), |k| {
        if desk.exerted(k).is_none() {
            return [0.0; 2];
        }
        let taken_over = pairs[k].offset.as_ref().map_or(0.0, |o| o.stored);
        let mut most = of_depth(desk, k, &pairs[k]);
        if bound == Bound::Way {
            most = most.max(of_way(world, desk, k));
        }
        [taken_over.min(0.0), most.max(taken_over)]
    })
}

/// What each pair stores in proportion to all others by its depth, J.
pub(super) fn at_most(world: &World, desk: &ContactScratch) -> Vec<f64> {
    let pairs = world.found.pairs.iter().enumerate();
    pairs.map(|(k, pair)| of_depth(desk, k, pair)).collect()
}

/// `F d/2` of a pair; on terrain, flat on each facet, `kn A d²/2`, J.
fn of_depth(desk: &ContactScratch, k: usize, pair: &FoundPair) -> f64 {
    if let PairKind::Terrain(_) = desk.constants[k].kind {
        return on_ground(desk, k, pair, |patch| patch.depth);
    }
    desk.exerted(k).map_or(0.0, |by| 0.5 * by.elastic.force.length() * pair.depth)
}

/// Energy of the patches of a pair with terrain that lie so deep (m), J.
fn on_ground(
    desk: &ContactScratch,
    k: usize,
    pair: &FoundPair,
    way: impl Fn(&ContactPatch) -> f64,
) -> f64 {
    let law = desk.constants[k].law(&desk.rows);
    let energy = |patch: &ContactPatch| {
        let way = way(patch);
        0.5 * law.normal_stiffness * patch.area * way * way * law.more_energy(way)
    };
    pair.patches.iter().map(energy).sum()
}

/// `F D/2` of a pair, J; patch by patch where it can have several.
fn of_way(world: &World, desk: &ContactScratch, k: usize) -> f64 {
    let pair = &world.found.pairs[k];
    let most = |force: f64, way: f64| {
        let rim = (way / desk.constants[k].inradius).min(1.0);
        0.5 * force * way * (1.0 + RIM * rim)
    };
    match desk.constants[k].kind {
        PairKind::Convex => {
            let of =
                |patch: &ContactPatch| most(patch.pressed, way(world, desk, pair, None, patch));
            pair.leading().map_or(0.0, of)
        }
        PairKind::Glued => {
            let of = |patch: &ContactPatch| {
                let force = patch.force.dot(patch.memory.normal).abs();
                most(force, way(world, desk, pair, Some(patch.key), patch))
            };
            pair.patches.iter().map(of).sum()
        }
        PairKind::Terrain(_) => {
            let deepest = |patch: &ContactPatch| patch.depth.max(below(world, desk, pair, patch));
            on_ground(desk, k, pair, deepest)
        }
    }
}

/// By how much the two blocks of a pair, or two pieces of them, overlap along their normal, m.
fn way(
    world: &World,
    desk: &ContactScratch,
    pair: &FoundPair,
    pieces: Option<[u32; 2]>,
    patch: &ContactPatch,
) -> f64 {
    let n = patch.memory.normal;
    let [first, second] = [0, 1].map(|side| {
        let b = pair.ends[side];
        let class = world.solid[b as usize] as usize;
        let at = desk.place[b as usize] as usize;
        let turn = desk.turns[at];
        let place = pair.key().place(side, desk.poses[at].position, &world.setup.periodic);
        let (shape, centre) = match pieces {
            Some(pieces) => of_piece(&desk.glued[class], pieces[side]),
            None => (&desk.shapes[class], Vec3::ZERO),
        };
        let outwards = if side == 0 { n } else { -n };
        let along = turn.transpose() * outwards;
        let heights = shape.vertices.iter().map(|v| along.dot(*v));
        let highest = heights.fold(f64::NEG_INFINITY, f64::max);
        highest + outwards.dot(place) + along.dot(centre)
    });
    (first + second).max(0.0)
}

/// Shape of a piece, and its centre from that of the block, m.
fn of_piece(glued: &Glued, piece: u32) -> (&Shape, Vec3) {
    let own = &glued.piece(piece as usize)[0];
    (&own.shape, own.centre)
}

/// How far a block, or a piece of it, reaches below a facet of terrain, m: as far as its sharpest edge does at this depth.
fn below(world: &World, desk: &ContactScratch, pair: &FoundPair, patch: &ContactPatch) -> f64 {
    let class = world.solid[pair.ends[1] as usize] as usize;
    let sharpest = match desk.glued.get(class).filter(|glued| !glued.is_convex()) {
        Some(glued) => of_piece(glued, patch.key[0]).0.sharpness(),
        None => desk.shapes[class].sharpness(),
    };
    patch.depth * sharpest
}

/// Energy of the pressure of found contacts less that at the start, J: the work on it, within what it can be. Steps that are long beside
/// an impact leave in that work what they made or lost, and blocks that are apart store nothing: what is left over is a defect of the law.
pub(crate) fn stored(world: &World, desk: &ContactScratch, exec: &Exec) -> f64 {
    let work = world.works.contact_path;
    // Those of implicit phases know their potential.
    if world.implicit.is_some() {
        return work;
    }
    if work == 0.0 || desk.slots.len() != world.found.pairs.len() {
        return work;
    }
    let [mut least, mut most] = bounds(world, desk, exec, Bound::Ball);
    // Most often this will do.
    if work > most {
        [least, most] = bounds(world, desk, exec, Bound::Way);
    }
    let at_start = (1.0 + 1e-9) * world.found.at_start;
    work.min(most).max(least - at_start)
}

/// Notes what contacts of blocks that are built into each other store at the start, which no work has put in.
pub(crate) fn begin(world: &mut World, desk: &ContactScratch, exec: &Exec) {
    if world.implicit.is_some() {
        return;
    }
    [_, world.found.at_start] = bounds(world, desk, exec, Bound::Way);
}

/// Energy of the normal springs of a joint whose load no contact has taken over yet, J.
pub(crate) fn left(pair: &FoundPair) -> f64 {
    let joint = pair.offset.as_ref().and_then(|offset| offset.joint);
    joint.map_or(0.0, |joint| joint.energy)
}

/// Books what a pair still holds that is no longer looked at: friction what its springs, an edit what a joint has left.
pub(super) fn drop_pair(works: &mut Works, pair: &FoundPair) {
    works.friction += pair.stored();
    works.edit_defect -= left(pair);
    if let Some(offset) = &pair.offset {
        works.contact_path -= offset.stored;
        works.edit_defect -= offset.stored;
    }
}

#[cfg(test)]
mod tests {
    use riprap_geom::Vec3;

    use crate::contact::tests::{Run, above_floor, brick};

    /// A brick that strikes the floor in steps that are long beside the impact: what the steps have made or lost is a defect of the law when
    /// it is off again, and no energy of a contact that is not there.
    #[test]
    fn blocks_that_are_apart_store_nothing() {
        let mut left = Vec::new();
        for dt in [2e-3, 1e-3] {
            let blocks = vec![brick([0.3, 0.2, 0.05], [0.4, 0.4, 0.4])];
            let mut run = Run::new(above_floor(blocks, 0.3, 0.0), 1, dt);
            run.world.bodies.set_velocity(1, Vec3::new(0.0, 0.0, -10.0), Vec3::ZERO);
            run.until(0.04);
            assert!(run.world.bodies.velocity(1).z > 5.0);
            let balance = run.view().balance();
            assert_eq!(balance.contact_normal, 0.0);
            assert_eq!(balance.works.law_defect, -run.world.works.contact_path);
            assert!(balance.residual_relative().abs() < 1e-5);
            left.push(balance.works.law_defect.abs() / balance.scale());
        }
        assert!(left.iter().any(|share| *share > 1e-3), "{left:?}");
    }

    /// A prism with an edge of this half angle along y, 1 mm above the floor, looking down, and what it is to fall with.
    fn wedge(half_angle: f64, damping: f64) -> Run {
        let side = half_angle.tan();
        let corners = [-0.5, 0.5].map(|y| {
            [[0.0, 0.0], [side, 1.0], [-side, 1.0]].map(|[x, z]| Vec3::new(x, y, z + 0.001))
        });
        let solid = riprap_geom::polyhedron::hull(&corners.concat()).unwrap();
        let mut block = brick([0.0; 3], [1.0; 3]);
        block.shape = crate::setup::Shape::Polyhedron(Box::new(crate::setup::Solid {
            vertices: solid.vertices,
            faces: solid.faces,
        }));
        let mut setup = above_floor(vec![block], 0.0, damping);
        setup.gravity = Vec3::ZERO;
        let mut run = Run::new(setup, 1, 2e-5);
        run.world.bodies.set_velocity(1, Vec3::new(0.0, 0.0, -1.0), Vec3::ZERO);
        run
    }

    /// An edge as sharp as a knife holds what it takes up, at any angle.
    #[test]
    fn a_sharp_edge_stores_what_it_takes_up() {
        for degrees in [8.0_f64, 15.0, 25.0, 45.0] {
            let mut run = wedge(degrees.to_radians(), 0.0);
            let mut worst = 0.0_f64;
            for k in 1..=120 {
                run.until(1e-3 * f64::from(k));
                let balance = run.view().balance();
                worst = worst.max(balance.works.law_defect.abs() / balance.scale());
            }
            assert!(worst < 2e-3, "{degrees} deg: {worst}");
            let back = run.world.bodies.velocity(1).z;
            assert!((back - 1.0).abs() < 2e-3, "{degrees} deg: {back}");
        }
    }

    /// Work that no contact can hold is still a defect: twice what the sharp edge has at its deepest.
    #[test]
    fn more_than_a_sharp_edge_can_hold_is_a_defect() {
        let mut run = wedge(15.0_f64.to_radians(), 0.0);
        while run.world.bodies.velocity(1).z < 0.0 {
            let now = run.world.time;
            run.until(now + 1e-4);
        }
        let held = run.world.works.contact_path;
        assert!(held > 0.0 && run.view().balance().works.law_defect.abs() < 1e-2 * held);
        run.world.works.contact_path = 2.0 * held;
        let lost = -run.view().balance().works.law_defect;
        assert!(lost > 0.4 * held, "{lost} {held}");
    }
}
