//! How long a step may be for found contacts of deformable blocks.
//!
//! A flat contact presses on a node with `kn` times the area that the node stands for, the other side yields as much: the squared
//! frequency of a block grows by at most `2 k max(A/m)` over its nodes, and no more than that of its own, however many blocks touch
//! it. Rigid blocks count with `1/m + (r² + 2 A/3)/I` for the largest area that can touch them.

use riprap_geom::Vec3;

use crate::contact::deformable::search::fastest;
use crate::kernel::cells::{Member, TetContactScratch};
use crate::laws::damping::stable_share;
use crate::state::world::World;

/// Share of the stable step: bonds of the same nodes come on top.
const SAFETY: f64 = 0.5;
/// Share of the depth of the thinner block that two may approach each other by in one step.
const TRANSIT: f64 = 0.1;

/// Longest step, s.
pub(super) fn longest_step(world: &World, desk: &TetContactScratch) -> f64 {
    let Some(deform) = world.deform.as_deref().filter(|d| d.relax.is_none()) else {
        return f64::INFINITY;
    };
    let gravity = world.gravity.length();
    let mut longest = f64::INFINITY;
    for constants in &desk.constants {
        let law = &constants.law;
        let stiffness = 2.0 * law.normal_stiffness.max(law.shear_stiffness);
        let two = constants.members.map(|k| &desk.members[k as usize]);
        // Glued parts can press on several faces of the other block at once.
        let whole = |m: &Member| match m.body {
            Some(_) => 0.5 * m.areas.iter().sum::<f64>(),
            None => m.largest,
        };
        let area = if two.iter().any(|m| !m.pieces.is_empty()) {
            whole(two[0]).min(whole(two[1]))
        } else {
            two[0].largest.min(two[1].largest)
        };
        let squares = two.map(|m| match m.body {
            Some(_) => m.own + stiffness * m.ease,
            None if world.is_terrain(m.block as usize) => 0.0,
            None => stiffness * area * ease(world, m, area),
        });
        let loss = stable_share(law.damping_ratio);
        let square = squares[0].max(squares[1]);
        longest = longest.min(SAFETY * 2.0 * loss / square.sqrt());
        // v t + g t²/2 = way, in the form without cancellation.
        let speed: f64 = two.map(|m| fastest(world, deform, m.block as usize)).iter().sum();
        let way = TRANSIT * constants.peak;
        longest = longest.min(2.0 * way / (speed + (speed * speed + 2.0 * gravity * way).sqrt()));
    }
    longest
}

/// How easily a force at the surface of a rigid block moves that point, 1/kg.
fn ease(world: &World, member: &Member, area: f64) -> f64 {
    let b = member.block as usize;
    let [free, turns] = world.freedoms(b);
    let solid = world.solid_of(b);
    let inverse = Vec3::new(solid.inverse.x_axis.x, solid.inverse.y_axis.y, solid.inverse.z_axis.z);
    let arm = solid.radius * solid.radius + 2.0 * area / 3.0;
    free.max_element() / solid.mass + arm * turns.max_element() * inverse.max_element()
}
