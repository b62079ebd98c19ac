//! Limits of found contact: stiffness that suits the rock, the stable time step, and when blocks go too far into each other
//! or could pass through each other.
//!
//! A contact of the area A resists an approach by no more than `k A`, `k` the larger of its two stiffnesses, and turning by
//! `k A (r² + J/A)` with `r` the lever arm and `J` the polar second moment of the area. A contact couples two blocks, so
//! the highest squared frequency of a block is at most twice the sum over its contacts, per mass and per smallest moment of
//! inertia. Areas are those that the contacts can have before the next look of the search, so that the step does not change
//! with every touch.

use super::friction::ContactLaw;
use super::grid::Role;
use super::search::{Blocks, Candidates, Search};
use crate::laws::damping;

/// Normal stiffness times block size, over the constrained modulus.
const STIFFNESS: f64 = 10.0;
/// Shear stiffness over normal stiffness.
const SHEAR: f64 = 0.5;
/// Depth of a corner, over the block size, that a given stiffness should not allow.
const CORNER_DEPTH: f64 = 0.05;
/// Energy of a cube's corner pressed in along its diagonal, over kn d⁴: (3 - sqrt 3)/8.
const CORNER_ENERGY: f64 = 0.158_493_649_053_890_3;
/// Share of the smaller inradius from which a depth is worth a warning.
const DEEP: f64 = 0.4;

/// Normal and shear stiffness (Pa/m) where neither scene nor joint gives any: 10 M/L and half of it, with the smaller
/// constrained modulus M = K + 4G/3 (Pa) of both materials and the median size L of the blocks (m).
#[must_use]
pub fn default_stiffness(constrained_modulus: f64, size: f64) -> [f64; 2] {
    let normal = STIFFNESS * constrained_modulus / size;
    [normal, SHEAR * normal]
}

/// How deep the corner of a cube goes into a flat face, without turning: mass (kg), closing speed (m/s), normal stiffness
/// (Pa/m); m.
///
/// Source: `m v²/2 = U(d) = (3 - sqrt 3)/8 kn d⁴`, the energy of the equal-pressure law with the space diagonal of a cube across the face.
#[must_use]
pub fn corner_depth(mass: f64, speed: f64, normal_stiffness: f64) -> f64 {
    let fourth = mass * speed * speed / (2.0 * CORNER_ENERGY * normal_stiffness);
    fourth.sqrt().sqrt()
}

/// The speed (m/s) at which the corner of a cube goes in by `depth` (m): the inverse of [`corner_depth`].
#[must_use]
pub fn corner_speed(mass: f64, depth: f64, normal_stiffness: f64) -> f64 {
    depth * depth * (2.0 * CORNER_ENERGY * normal_stiffness / mass).sqrt()
}

/// How deep a force (N) presses the corner of a cube into a flat face, m: `F = (3 - sqrt 3)/2 kn d³`, the derivative of the same
/// energy.
#[must_use]
pub fn corner_under(force: f64, normal_stiffness: f64) -> f64 {
    libm::cbrt(force / (4.0 * CORNER_ENERGY * normal_stiffness))
}

/// The normal stiffness (Pa/m) from which a corner of a block of this mass (kg) and size (m) at this speed (m/s) goes in by
/// a twentieth of the size at most.
#[must_use]
pub fn least_stiffness(mass: f64, speed: f64, size: f64) -> f64 {
    let depth = CORNER_DEPTH * size;
    mass * speed * speed / (2.0 * CORNER_ENERGY * depth * depth * depth * depth)
}

/// How deep two blocks lie in each other.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Depth {
    /// As it should be.
    Fine,
    /// The stiffness is too small for what presses: worth a warning.
    Deep,
    /// The force may soon point to the far side: the run must stop.
    TooDeep,
}

/// Judges a depth (m) by the smaller inradius of both blocks (m). Depths that are not numbers are too deep.
#[must_use]
pub fn judge(depth: f64, inradius: f64) -> Depth {
    if depth < DEEP * inradius {
        Depth::Fine
    } else if depth < inradius {
        Depth::Deep
    } else {
        Depth::TooDeep
    }
}

/// How easily a block is moved.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Ease {
    /// 1 over its mass, 1/kg; 0 for a block that no force can move.
    pub inverse_mass: f64,
    /// 1 over its smallest moment of inertia, 1/(kg m²); 0 for a block that nothing can turn.
    pub inverse_inertia: f64,
}

/// The stable step and the block that sets it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StableContact {
    /// Longest stable step of the contacts alone (safety 1), s; infinite when nothing can touch.
    pub dt: f64,
    /// The block with the highest frequency.
    pub block: Option<u32>,
}

/// Squared frequency (1/s²) and damping (1/s) of one block: bounds.
#[derive(Clone, Copy, Debug, Default)]
struct Rates {
    square: f64,
    damping: f64,
}

impl Rates {
    /// Adds a contact: stiffness (N/m), dashpot (N s/m), square of its lever arm with its own extent (m²).
    fn add(&mut self, ease: &Ease, stiffness: f64, dashpot: f64, arm: f64) {
        let moved = 2.0 * (ease.inverse_mass + arm * ease.inverse_inertia);
        self.square += moved * stiffness;
        self.damping += moved * dashpot;
    }

    /// `dt` with `dt² K + 2 dt C = 4` for `K` the squared frequency and `C` the damping, in the form without cancellation:
    /// the leapfrog with the velocity of half a step before in the dashpots.
    fn stable(&self) -> f64 {
        let c = self.damping;
        4.0 / (c + (c * c + 4.0 * self.square).sqrt())
    }
}

/// The stable step of all contacts that can form before the next look of the search.
///
/// `law(i, j)` is the law between two blocks. Every block that can be moved counts at least with one contact on its largest
/// face, as stiff as its stiffest law (`own(b)`), so that the step is found before anything touches.
pub fn stable_step(
    (blocks, search, candidates): (&Blocks, &Search, &Candidates),
    ease: &[Ease],
    law: impl Fn(u32, u32) -> ContactLaw,
    own: impl Fn(usize) -> ContactLaw,
) -> StableContact {
    let mut rates = vec![Rates::default(); ease.len()];
    for pair in &candidates.pairs {
        let law = law(pair.i, pair.j);
        let ends = [pair.i, pair.j].map(|b| b as usize);
        let Some(common) = candidates.common_box(pair) else {
            continue;
        };
        let (stiffness, dashpot) = resistance(&law, pair.area, ends.map(|b| ease[b].inverse_mass));
        let size = common.high - common.low;
        // Second moment of the widest rectangle in the box, over its area.
        let extent = (size.length_squared() - size.min_element() * size.min_element()) / 12.0;
        for b in ends {
            let arm = 0.5 * (common.low + common.high) - search.pose[b].position;
            let radius = blocks.shape(b).radius;
            let arm = (arm.length_squared() + extent).min(radius * radius);
            rates[b].add(&ease[b], stiffness, dashpot, arm);
        }
    }
    let mut worst = StableContact {
        dt: f64::INFINITY,
        block: None,
    };
    for (b, rates) in rates.iter().enumerate() {
        let fixed = ease[b].inverse_mass == 0.0 && ease[b].inverse_inertia == 0.0;
        if blocks.roles[b] == Role::Absent || fixed {
            continue;
        }
        let dt = rates.stable().min(alone(blocks, b, &ease[b], &own(b)));
        if dt < worst.dt {
            worst = StableContact {
                dt,
                block: Some(b as u32),
            };
        }
    }
    worst
}

/// The stable step of a block that lies on its largest face.
fn alone(blocks: &Blocks, b: usize, ease: &Ease, law: &ContactLaw) -> f64 {
    let shape = blocks.shape(b);
    let mut largest = (0.0, 0.0);
    for (&area, &offset) in shape.areas.iter().zip(&shape.offsets) {
        if area > largest.0 {
            largest = (area, offset);
        }
    }
    let (area, offset) = largest;
    let (stiffness, dashpot) = resistance(law, area, [ease.inverse_mass, 0.0]);
    let mut rates = Rates::default();
    // A square has the polar second moment area²/6.
    rates.add(ease, stiffness, dashpot, offset * offset + area / 6.0);
    rates.stable()
}

/// Stiffness (N/m) and dashpot (N s/m) of a contact of this area (m²) between blocks of these inverse masses (1/kg).
fn resistance(law: &ContactLaw, area: f64, inverse_masses: [f64; 2]) -> (f64, f64) {
    let stiffness = law.normal_stiffness.max(law.shear_stiffness) * area;
    let inverse = inverse_masses[0] + inverse_masses[1];
    let dashpot = if inverse > 0.0 {
        damping::dashpot(law.damping_ratio, stiffness, 1.0 / inverse)
    } else {
        0.0
    };
    (stiffness, dashpot)
}

#[cfg(test)]
mod tests {
    use riprap_geom::Vec3;

    use super::super::{Pose, Shape};
    use super::*;
    use crate::exec::Exec;

    const LAW: ContactLaw = ContactLaw {
        normal_stiffness: 1e9,
        shear_stiffness: 5e8,
        friction: 0.5,
        cohesion: 0.0,
        damping_ratio: 0.0,
    };

    /// Step for cubes of 1 m and 2500 kg with their centres at these places; the first one is fixed.
    fn step(places: &[Vec3], law: ContactLaw) -> StableContact {
        let shapes = [Shape::brick(Vec3::splat(0.5)).unwrap()];
        let (shape, roles) = (vec![0; places.len()], vec![Role::Seeker; places.len()]);
        let blocks = Blocks {
            shapes: &shapes,
            shape: &shape,
            roles: &roles,
        };
        let mut search = Search::default();
        search.renew(&blocks, |b| Pose::at(places[b]), |_| 0.0, 0.0);
        let mut candidates = Candidates::default();
        candidates.rebuild(
            &blocks,
            &search,
            |_, _| false,
            |_, _| false,
            &Exec::serial(),
        );
        let mut ease = vec![
            Ease {
                inverse_mass: 1.0 / 2500.0,
                inverse_inertia: 6.0 / 2500.0,
            };
            places.len()
        ];
        ease[0] = Ease::default();
        stable_step((&blocks, &search, &candidates), &ease, |_, _| law, |_| law)
    }

    #[test]
    fn the_step_stays_below_the_exact_ones_and_not_far() {
        // A cube on a fixed one: it heaves with kn A/m and rocks with kn (A/12)/I + ks A h²/I, all with L = 1.
        let heave = 1e9 / 2500.0;
        let rock = (1e9 / 12.0 + 5e8 / 4.0) * 6.0 / 2500.0;
        let exact = 2.0 / f64::max(heave, rock).sqrt();
        let found = step(&[Vec3::ZERO, Vec3::Z], LAW);
        assert_eq!(found.block, Some(1));
        let share = found.dt / exact;
        assert!(share < 1.0 && share > 0.4, "{share}");
        // Dashpots make it shorter: 2/w (sqrt(1 + xi²) - xi) for a single oscillator, more for the bound.
        let damped = step(
            &[Vec3::ZERO, Vec3::Z],
            ContactLaw {
                damping_ratio: 0.2,
                ..LAW
            },
        );
        let single = 1.04f64.sqrt() - 0.2;
        let share = damped.dt / found.dt;
        assert!(share <= single && share > 0.5, "{share}");
        // In the middle of a column each cube has two contacts.
        let column = step(&[0.0, 1.0, 2.0, 3.0].map(|z| z * Vec3::Z), LAW);
        assert!(column.dt < found.dt && column.dt > 0.6 * found.dt);
    }

    #[test]
    fn the_step_is_known_before_anything_touches() {
        let apart = step(&[Vec3::ZERO, 5.0 * Vec3::Z], LAW);
        let near = step(&[Vec3::ZERO, Vec3::Z], LAW);
        assert_eq!(apart.block, Some(1));
        assert!((apart.dt / near.dt - 1.0).abs() < 0.2, "{apart:?} {near:?}");
        // Nothing that can be moved: nothing bounds the step.
        assert_eq!(step(&[Vec3::ZERO], LAW).dt, f64::INFINITY);
    }

    #[test]
    fn corners_go_in_as_far_as_measured() {
        // A cube of 1 m falling on its corner at 2 m/s without turning.
        let depth = corner_depth(2500.0, 2.0, 1e10);
        assert!((corner_speed(2500.0, depth, 1e10) - 2.0).abs() < 1e-12);
        // The static depth has the force of the closed form.
        let under = corner_under(1e6, 1e10);
        let force = (3.0 - 3f64.sqrt()) / 2.0 * 1e10 * under * under * under;
        assert!((force - 1e6).abs() < 1e-6, "{force}");
        assert!((depth - 4.214_434e-2).abs() < 1e-7, "{depth}");
        let stiffness = least_stiffness(2500.0, 2.0, 1.0);
        assert!((corner_depth(2500.0, 2.0, stiffness) - 0.05).abs() < 1e-12);
        assert_eq!(default_stiffness(24e9, 0.5), [4.8e11, 2.4e11]);
    }

    #[test]
    fn depths_are_judged_by_the_inradius() {
        assert_eq!(judge(0.03, 0.1), Depth::Fine);
        assert_eq!(judge(0.05, 0.1), Depth::Deep);
        assert_eq!(judge(0.1, 0.1), Depth::TooDeep);
        assert_eq!(judge(f64::NAN, 0.1), Depth::TooDeep);
    }
}
