//! Joints for the implicit step: what the patches of the world give to it, and what comes back.
//!
//! The law of a patch is applied in every evaluation, as in explicit phases: it keeps the memory, and says what the joint carries now. The step asks
//! what it will carry at its end, so that what patches have added to the sums of the blocks is replaced by that.

use riprap_geom::Vec3;

use crate::implicit::joint::{Joint, Point};
use crate::implicit::pair::Pair;
use crate::joint::reading::Reading;
use crate::laws::face_joint::elastic;
use crate::setup::Failure;
use crate::state::patches::flag;
use crate::state::scratch::Scratch;
use crate::state::world::World;

/// Gives the joints to the solver, behind the pairs of found contact.
pub(super) fn find(world: &World, scratch: &mut Scratch) {
    let desk = &mut scratch.implicit;
    desk.joints.extend(0..world.patches.len() as u32);
    for p in 0..world.patches.len() {
        desk.solver.pairs.push(pair(world, p));
    }
}

fn pair(world: &World, p: usize) -> Pair {
    let reading = Reading { world, p };
    let (class, points) = (reading.class(), reading.points());
    let (start, memory) = (reading.start(), reading.memory());
    let law = reading.joint();
    let arms: [[Vec3; 2]; 4] = std::array::from_fn(|q| points.arms(class, q));
    let springs = class.stiffness;
    let whole = (law.failure == Failure::Face).then_some(class.half_spacing);
    // In the law of a face the shear of all points starts anew, or of none.
    let all_open = memory.iter().all(|memory| memory.open);
    let joint = Joint {
        frame: points.frame,
        area: 0.25 * class.area,
        springs,
        strength: law.strength,
        model: (!law.is_plain()).then_some(law.behaviour),
        whole: whole.filter(|_| law.strength.is_some()),
        points: std::array::from_fn(|q| {
            let [known, mut memory] = [memory[q]; 2];
            if memory.open && (whole.is_none() || all_open) {
                // Where it closes, its shear spring is stretched by the way of the step alone.
                memory.slip = [0, 1].map(|k| points.at[q][k + 1] + start[q][k + 1] / springs[1]);
            }
            let traction = elastic(springs, &start[q], &points.at[q], &memory);
            let mut point = Point::new(arms[q][0], traction, memory.broken);
            (point.at, point.start, point.memory) = (points.at[q], start[q], known);
            point
        }),
    };
    Pair {
        // From the centroid of i, about which the arms of all points agree.
        centres: [Vec3::ZERO, arms[0][0] - arms[0][1]],
        joint: Some(Box::new(joint)),
        ..Pair::default()
    }
}

/// Takes what patches have added to the sums of the blocks out of them.
pub(crate) fn withdraw(scratch: &mut Scratch) {
    scratch.net.whole().clear();
    scratch.drag.whole().clear();
    scratch.slots.iter_mut().for_each(|slots| slots.whole().clear());
}

/// Adds what the joints exert in the step to the sums of their blocks.
pub(super) fn hand_over(world: &World, scratch: &mut Scratch) {
    let (desk, mut net) = (&mut scratch.implicit, scratch.net.whole());
    let replies = desk.solver.pairs.iter().zip(&desk.solver.replies).skip(desk.pairs.len());
    for (p, (pair, reply)) in desk.joints.iter().zip(replies) {
        let [fx, fy, fz, mx, my, mz] = reply.elastic;
        let (force, moment) = (Vec3::new(fx, fy, fz), Vec3::new(mx, my, mz));
        for (side, b) in world.patches.ends[*p as usize].into_iter().enumerate() {
            let sign = [-1.0, 1.0][side];
            let own = moment - pair.centres[side].cross(force);
            net.add(b as usize, sign * force, sign * own);
            if let Some(at) = desk.place[b as usize] {
                desk.tied[at as usize] = true;
            }
        }
    }
}

/// Marks the points that have failed in the step that is made; what those that open have stored, J.
pub(super) fn remember(world: &mut World, scratch: &Scratch) -> f64 {
    let desk = &scratch.implicit;
    let mut lost = 0.0;
    let pairs = desk.solver.pairs.iter().skip(desk.pairs.len());
    for (p, pair) in desk.joints.iter().zip(pairs) {
        let flags = &mut world.patches.flags[*p as usize];
        let points = pair.joint.iter().flat_map(|joint| joint.points.iter().enumerate());
        for (q, point) in points.filter(|(_, point)| point.fails) {
            *flags |= flag::of(flag::BROKEN, q);
            if point.opens {
                *flags |= flag::of(flag::OPEN, q);
                lost += pair.joint.as_ref().map_or(0.0, |joint| joint.lost(q));
            }
        }
    }
    lost
}

/// Energy in the springs of all joints, J.
pub(super) fn stored(world: &World, scratch: &Scratch) -> f64 {
    let of = |p: usize| Reading { world, p }.energy();
    let [normal, shear] = scratch.exec.sums(world.patches.len(), of);
    normal + shear
}
