//! Whether the search for contacts can do without the blocks of other ranks.

use std::ops::Range;

use crate::kernel::Role;
use crate::state::scratch::Scratch;
use crate::state::share::apart::Own;
use crate::state::world::World;

/// Longest step that the blocks of a rank allow, s; 0 where [`super::release()`] or [`super::refresh`] would change something of its own, with `joints` or without.
pub(crate) fn quiet_for(world: &World, scratch: &Scratch, own: Own, joints: bool) -> f64 {
    let seek = world.found.roles.contains(&Role::Active);
    let stale = || {
        let (desk, search) = (&scratch.desk, &world.found.search);
        let leaves = |b: usize| {
            let radius = desk.shapes[world.solid[b] as usize].radius;
            world.found.roles[b] != Role::Absent
                && search.leaves(
                    b,
                    radius,
                    &world.pose(b),
                    super::speed(world, b) * scratch.coming_dt,
                )
        };
        !desk.ready
            || search.pose.len() != world.alive.len()
            || any(scratch, own.blocks.clone(), leaves)
    };
    let gives = |p: usize| super::release::change_of(world, p).is_some();
    if joints && any(scratch, own.patches.clone(), gives) || seek && stale() {
        return 0.0;
    }
    if seek { super::limit::reach(world, &scratch.exec, own.blocks) } else { f64::INFINITY }
}

/// Whether something is true of any of a range.
fn any(scratch: &Scratch, of: Range<usize>, is: impl Fn(usize) -> bool + Sync) -> bool {
    let start = of.start;
    let first = |mut chunk: Range<usize>| match chunk.any(|k| is(start + k)) {
        true => 0.0,
        false => f64::INFINITY,
    };
    scratch.exec.smallest(of.len(), first) == 0.0
}
