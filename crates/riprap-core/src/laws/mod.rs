//! Pure functions on numbers, each citing its source. They know no world.

pub mod behaviour;
pub mod block_theory;
pub mod bolt;
pub mod bond;
pub mod bounds;
pub mod coulomb;
pub mod damping;
pub mod explosive;
pub mod face_joint;
pub mod fracture;
pub mod in_situ;
pub mod joint_point;
pub mod jwl;
pub mod mohr_coulomb;
pub mod parameters;
pub mod potential;
pub mod seepage;
pub mod softening_curve;
pub mod tetrahedron;
pub mod transfer;
pub mod water;

/// `sqrt(a^2 + b^2)`: the same bits on every machine, which `f64::hypot` is not. Stresses and displacements are far from where
/// their squares leave the range of numbers.
#[inline(always)]
#[must_use]
pub fn norm(a: f64, b: f64) -> f64 {
    (a * a + b * b).sqrt()
}
