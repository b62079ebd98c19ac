//! The error of a step, by a step and two halves.

use crate::dynamics::damping::Damping;
use crate::exec::Exec;
use crate::state::scratch::Scratch;
use crate::state::world::World;
use crate::step::{advance, evaluate};

/// How far from each other the blocks lie that one step of `dt` (s) moves and two of half of it, m, their turns counted at the farthest corner; infinite where a
/// step has no solution. Both are made on a copy of the state, which stays as it is.
#[must_use]
pub fn error(world: &World, scratch: &mut Scratch, damping: &Damping, dt: f64) -> f64 {
    let mut exec = std::mem::replace(&mut scratch.exec, Exec::serial());
    let mut ends = [1_u32, 2].map(|parts| {
        let mut copy = world.clone();
        let mut work = Scratch::new(&mut copy, std::mem::replace(&mut exec, Exec::serial()));
        let step = dt / f64::from(parts);
        let done = (0..parts).all(|_| {
            let found = evaluate(&mut copy, &mut work, damping, step).is_ok();
            if found {
                advance(&mut copy, &mut work, step);
            }
            found
        });
        exec = std::mem::replace(&mut work.exec, Exec::serial());
        done.then_some(copy)
    });
    scratch.exec = exec;
    let [Some(one), Some(two)] = ends.each_mut().map(Option::take) else {
        return f64::INFINITY;
    };
    let apart = |b: usize| {
        let [p, q] = [&one, &two].map(|world| world.pose(b));
        let turned = p.rotation.to_array().into_iter().zip(q.rotation.to_array());
        // Twice the chord of unit quaternions is the angle between them.
        let angle = 2.0 * turned.map(|(a, b)| (a - b) * (a - b)).sum::<f64>().sqrt();
        (p.position - q.position).length() + angle * world.solid_of(b).radius
    };
    let blocks = (0..world.alive.len()).filter(|b| world.alive[*b] && !world.is_terrain(*b));
    blocks.map(apart).fold(0.0, f64::max)
}
