//! Rotations and their vectors.

use riprap_geom::{Quat, Vec3};

/// Rotation of a rotation vector.
#[must_use]
pub(crate) fn rotation(vector: Vec3) -> Quat {
    let half = 0.5 * vector.length();
    let (s, c) = libm::sincos(half);
    // From 1e-9 down the sine is its angle to the last bit.
    let scale = if half > 1e-9 { 0.5 * s / half } else { 0.5 };
    let v = scale * vector;
    Quat::from_xyzw(v.x, v.y, v.z, c)
}

/// Rotation vector of a rotation, length at most pi.
#[must_use]
pub(crate) fn rotation_vector(q: Quat) -> Vec3 {
    // `q` and `-q` are one rotation; that with a positive `w` is the shorter way round.
    let q = if q.w < 0.0 { -q } else { q };
    let v = Vec3::new(q.x, q.y, q.z);
    let sine = v.length();
    let scale = if sine > 1e-9 { 2.0 * libm::atan2(sine, q.w) / sine } else { 2.0 / q.w };
    scale * v
}
