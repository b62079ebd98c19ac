//! What found contacts store across themselves: known only as the work on them, and from above and below.

use crate::exec::Exec;
use crate::found::desk::Desk;
use crate::state::found::{FacetContact, FoundPair};
use crate::world::World;

/// What is stored in the pressure of found contacts lies between these, J. The force of a contact grows at least as fast as its depth d, so
/// that F d / 2 is never less than its energy; it is the energy itself where two faces meet flat. What a joint has handed over is known.
fn bounds(world: &World, desk: &Desk, exec: &Exec) -> [f64; 2] {
    let pair = |k: usize| {
        let Some(by) = desk.exerted(k) else {
            return [0.0; 2];
        };
        let pair = &world.found.pairs[k];
        let taken_over = pair.offset.as_ref().map_or(0.0, |o| o.stored);
        let most = 0.5 * by.elastic.force.length() * pair.depth;
        [taken_over.min(0.0), most.max(taken_over)]
    };
    let [least, most] = exec.sums(world.found.pairs.len(), pair);
    let terrain = world.found.terrain.iter().enumerate();
    let facets = terrain.flat_map(|(b, on)| on.facets.iter().map(move |on| facet(desk, b, on)));
    [least, most + facets.sum::<f64>()]
}

/// The same from above for each pair, and for each facet on terrain in turn, J.
pub(super) fn at_most(world: &World, desk: &Desk) -> (Vec<f64>, Vec<f64>) {
    let pair = |(k, pair): (usize, &FoundPair)| {
        let by = desk.exerted(k);
        by.map_or(0.0, |by| 0.5 * by.elastic.force.length() * pair.depth)
    };
    let terrain = world.found.terrain.iter().enumerate();
    let facets = terrain.flat_map(|(b, on)| on.facets.iter().map(move |on| facet(desk, b, on)));
    let pairs = world.found.pairs.iter().enumerate();
    (pairs.map(pair).collect(), facets.collect())
}

/// Energy of a facet of block `b` on terrain, J.
fn facet(desk: &Desk, b: usize, on: &FacetContact) -> f64 {
    let laws = desk.terrain.laws.get(b);
    let law = laws.and_then(|laws| laws.get(on.terrain()));
    let stiffness = law.map_or(0.0, |law| law.normal_stiffness);
    0.5 * stiffness * on.area * on.depth * on.depth
}

/// Energy of the pressure of found contacts less that at the start, J: the work on it, within what it can be. Steps that are long beside
/// an impact leave in that work what they made or lost, and blocks that are apart store nothing: what is left over is a defect of the law.
pub(crate) fn stored(world: &World, desk: &Desk, exec: &Exec) -> f64 {
    let work = world.works.contact_path;
    if work == 0.0 || desk.slots.len() != world.found.pairs.len() {
        return work;
    }
    let [least, most] = bounds(world, desk, exec);
    let at_start = (1.0 + 1e-9) * world.found.at_start;
    work.min(most).max(least - at_start)
}

/// Notes what contacts of blocks that are built into each other store at the start, which no work has put in.
pub(crate) fn begin(world: &mut World, desk: &Desk, exec: &Exec) {
    [_, world.found.at_start] = bounds(world, desk, exec);
}

#[cfg(test)]
mod tests {
    use riprap_geom::Vec3;

    use crate::contacts::tests::{Run, above_floor, brick};

    /// A brick that strikes the floor in steps that are long beside the impact: what the steps have made or lost is a defect of the law when
    /// it is off again, and no energy of a contact that is not there.
    #[test]
    fn blocks_that_are_apart_store_nothing() {
        let mut left = Vec::new();
        for dt in [2e-3, 1e-3] {
            let blocks = vec![brick([0.3, 0.2, 0.05], [0.4, 0.4, 0.4])];
            let mut run = Run::new(above_floor(blocks, 0.3, 0.0), 1, dt);
            run.world
                .bodies
                .set_velocity(1, Vec3::new(0.0, 0.0, -10.0), Vec3::ZERO);
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
}
