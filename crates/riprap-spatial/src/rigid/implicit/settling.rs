//! The length of steps in which blocks settle.

use crate::state::world::World;

/// The first step, s: gravity moves a block by a quarter of a millimetre in it.
const FIRST: f64 = 1e-2;
/// Way of a block in a step at most, over half its shortest edge.
const WAY: f64 = 0.05;
/// A step over the last one at most.
const GROWTH: f64 = 2.0;

/// Longest step of a static phase, s.
///
/// Velocities do not last from step to step, so that a force `F` that is not balanced moves a block by `F h^2/2m`: the way grows with the square of
/// the step.
#[must_use]
pub fn settling_step(world: &World) -> f64 {
    let last = world.last_dt;
    if last <= 0.0 {
        return FIRST;
    }
    let way = settling_way(world);
    let longest = GROWTH * last;
    if way > 0.0 { longest.min(last * (WAY / way).sqrt()) } else { longest }
}

/// Way of a block in the last step at most, over half its shortest edge.
#[must_use]
pub fn settling_way(world: &World) -> f64 {
    let mut most = 0.0_f64;
    for b in (0..world.alive.len()).filter(|b| world.alive[*b] && !world.is_terrain(*b)) {
        let solid = world.solid_of(b);
        let turning = world.bodies.spin(b).length() * solid.radius;
        let speed = world.bodies.velocity(b).length() + turning;
        most = most.max(speed * world.last_dt / solid.half.min_element());
    }
    most
}
