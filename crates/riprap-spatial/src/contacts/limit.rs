//! How long a step may be for the contacts that are there, and for those that can form in it.
//!
//! A contact of the area A counts in the squared frequency of each of its blocks with `2 k A (1/m + (r² + J/A)/I)`, with k the larger
//! stiffness, r its distance from the centroid and J its polar second moment; where these are not known yet, with the distance of the farthest face
//! and 2 A/3 in their place. No point is farther away than the radius of the block. Pairs that do not touch yet count
//! only with what can happen in the coming step: two faces that can come flat onto each other from the moment they meet,
//! edges and corners with the area that the way of the blocks makes.
//!
//! No step may let two blocks pass through each other: those of a pair come nearer by no more than their gap and a tenth of
//! the smaller inscribed radius, and no block outruns the search that finds its pairs.

use riprap_geom::Vec3;

use crate::found::desk::Desk;
use crate::found::{Pose, Role, Shape};
use crate::world::World;

/// Share of the stable step: the stiffness grows with the area.
const SAFETY: f64 = 0.2;
/// Share of the time until two blocks can meet that a step may take. The kick of a step spans half of the step before it too, and
/// the limit is that of the last evaluation: steps shrink with the gap, so that the first kick of a contact is a short one.
const APPROACH: f64 = 0.25;
/// Share of the smaller inscribed radius by which two blocks that touch may approach in one step.
const TRANSIT: f64 = 0.1;
/// Share of the time in which a block uses up its margin that a step may take.
const FLIGHT: f64 = 0.25;
/// Cosine between normals of faces that can come flat onto each other before the next look of the search.
const FACING: f64 = -0.98;

/// Longest step, s.
pub(super) fn longest_step(world: &World, desk: &Desk) -> f64 {
    let gravity = world.gravity.length();
    let mut longest = transit(world, desk);
    for (at, &b) in desk.blocks.iter().enumerate() {
        let b = b as usize;
        let ease = Ease::of(world, desk, b);
        let (mut sum, mut damping) = (0.0, 0.0_f64);
        let pairs = desk.first_pair[at] as usize..desk.first_pair[at + 1] as usize;
        for &(k, second) in &desk.incidence[pairs] {
            let k = k as usize;
            let (slot, constants) = (&desk.slots[k], &desk.constants[k]);
            let law = &constants.law;
            let stiffness = 2.0 * law.normal_stiffness.max(law.shear_stiffness);
            let loss = (1.0 + law.damping_ratio * law.damping_ratio).sqrt() - law.damping_ratio;
            if slot.touching {
                let area = slot.area.max(constants.facing);
                let memory = &world.found.pairs[k].memory;
                let known = memory.area > 0.0 && constants.facing <= memory.area;
                sum += stiffness
                    * area
                    * if known {
                        let arm = memory.arms[usize::from(second)];
                        ease.of_extent(arm.length_squared() + memory.polar / memory.area)
                    } else {
                        ease.of_area(area)
                    };
                damping = damping.max(law.damping_ratio);
                continue;
            }
            let pair = &world.found.pairs[k];
            let gap = pair.gap.max(0.0);
            let speed: f64 = pair.ends.map(|e| speed(world, e as usize)).iter().sum();
            let meet = APPROACH * time_for(gap, speed, gravity);
            if constants.facing > 0.0 {
                let rate = stiffness * constants.facing * ease.of_area(constants.facing);
                longest = longest.min(meet.max(SAFETY * 2.0 * loss / rate.sqrt()));
            }
            // An edge: its area is its length times the way; dt² K v dt = (2 f)².
            let rate =
                stiffness * constants.largest.sqrt() * speed * ease.of_area(constants.largest);
            if rate > 0.0 {
                let allowed = 2.0 * SAFETY * loss;
                longest = longest.min(meet + libm::cbrt(allowed * allowed / rate));
            }
        }
        if sum > 0.0 {
            let loss = (1.0 + damping * damping).sqrt() - damping;
            longest = longest.min(SAFETY * 2.0 * loss / sum.sqrt());
        }
    }
    longest
}

/// Time that a way (m) takes from the speed `v` (m/s) on under the acceleration `g` (m/s²): `v t + g t²/2 = way` in the form without
/// cancellation, s.
fn time_for(way: f64, v: f64, g: f64) -> f64 {
    if way > 0.0 {
        2.0 * way / (v + (v * v + 2.0 * g * way).sqrt())
    } else {
        0.0
    }
}

/// Longest step in which no pair can pass through each other, s.
fn transit(world: &World, desk: &Desk) -> f64 {
    let g = world.gravity.length();
    let mut longest = f64::INFINITY;
    for (pair, constants) in world.found.pairs.iter().zip(&desk.constants) {
        let [i, j] = pair.ends.map(|b| b as usize);
        let gap = pair.gap.max(0.0);
        let apart = world.bodies.velocity(i) - world.bodies.velocity(j);
        let speed = apart.length() + turning(world, i) + turning(world, j);
        longest = longest.min(time_for(gap + TRANSIT * constants.inradius, speed, g));
    }
    longest
}

/// Longest step in which no block uses up more than a share of its margin: whom it can run into is known before, s.
///
/// A quarter of the time, because what the ledger takes for the kinetic energy of a falling block, `m v(n-1/2).v(n+1/2)/2`, is less than its own by
/// `m g² dt²/8`: where steps grow short before a contact that comes to light as a residual.
pub(super) fn reach(world: &World) -> f64 {
    let g = world.gravity.length();
    let search = &world.found.search;
    let mut longest = f64::INFINITY;
    for (b, role) in world.found.roles.iter().enumerate() {
        if *role != Role::Absent {
            longest = longest.min(FLIGHT * time_for(search.margin[b], speed(world, b), g));
        }
    }
    longest
}

/// How easily forces move and turn a block.
pub(super) struct Ease {
    /// 1/kg.
    mass: f64,
    /// 1/(kg m²).
    inertia: f64,
    /// Square of the distance of its farthest face, m².
    height: f64,
    /// Square of its radius, m².
    reach: f64,
}

impl Ease {
    pub(super) fn of(world: &World, desk: &Desk, b: usize) -> Self {
        let [free, turns] = world.freedoms(b);
        let solid = world.solid_of(b);
        let diagonal = Vec3::new(
            solid.inverse.x_axis.x,
            solid.inverse.y_axis.y,
            solid.inverse.z_axis.z,
        );
        let offsets = &desk.shapes[world.solid[b] as usize].offsets;
        let height = offsets.iter().copied().fold(0.0, f64::max);
        Self {
            mass: free.max_element() / solid.mass,
            inertia: turns.max_element() * diagonal.max_element(),
            height: height * height,
            reach: solid.radius * solid.radius,
        }
    }

    /// `1/m + (h² + 2 A/3)/I`.
    pub(super) fn of_area(&self, area: f64) -> f64 {
        self.of_extent(self.height + 2.0 * area / 3.0)
    }

    /// `1/m + extent/I`, with the mean square of the distances of a contact's points from the centroid, m².
    fn of_extent(&self, extent: f64) -> f64 {
        self.mass + extent.min(self.reach) * self.inertia
    }
}

/// Bound of the speed of the points of a block, m/s.
fn speed(world: &World, b: usize) -> f64 {
    world.bodies.velocity(b).length() + turning(world, b)
}

/// Bound of the speed of the points of a block against its centroid, m/s.
fn turning(world: &World, b: usize) -> f64 {
    world.bodies.spin(b).length() * world.solid_of(b).radius
}

/// Smaller one of the largest listed faces of both blocks, m².
pub(super) fn largest_area(shapes: [&Shape; 2], faces: [&[u16]; 2]) -> f64 {
    let [a, b] = [0, 1].map(|s| {
        let areas = faces[s].iter().map(|f| shapes[s].areas[*f as usize]);
        areas.fold(0.0, f64::max)
    });
    a.min(b)
}

/// Largest area of two of these faces that can come flat onto each other, m²: they face each other, and have moved by `margin` (m) at
/// most along themselves from these poses.
pub(super) fn facing_area<F: IntoIterator<Item = u16> + Clone>(
    shapes: [&Shape; 2],
    poses: [Pose; 2],
    margin: f64,
    faces: [F; 2],
) -> f64 {
    let mut most: f64 = 0.0;
    let [of_first, of_second] = faces;
    for f in of_first {
        let n = poses[0].rotation * shapes[0].normals[f as usize];
        let [_, e, h] = riprap_geom::polyhedron::frame(n);
        for g in of_second.clone() {
            let m = poses[1].rotation * shapes[1].normals[g as usize];
            if n.dot(m) > FACING {
                continue;
            }
            let sides = [e, h].map(|axis| {
                let reach = |s: usize, face: u16, axis: Vec3| {
                    let corners = shapes[s].outline(face as usize).iter();
                    corners
                        .map(|v| axis.dot(poses[s].place(shapes[s].vertices[*v as usize])))
                        .fold(f64::NEG_INFINITY, f64::max)
                };
                let high = reach(0, f, axis).min(reach(1, g, axis));
                let low = (-reach(0, f, -axis)).max(-reach(1, g, -axis));
                (high - low + margin).max(0.0)
            });
            let areas = shapes[0].areas[f as usize].min(shapes[1].areas[g as usize]);
            most = most.max(areas.min(sides[0] * sides[1]));
        }
    }
    most
}
