//! Limits of found contact: stiffness that suits the rock, and depths at which contacts are too soft.

/// Depth of a corner, over the block size, that a given stiffness should not allow.
const CORNER_DEPTH: f64 = 0.05;
/// Energy of a cube's corner pressed in along its diagonal, over kn d⁴: (3 - sqrt 3)/8.
const CORNER_ENERGY: f64 = 0.158_493_649_053_890_3;
/// What stiffening adds to that energy, over `(d/D)²`: (sqrt 3 - 1)²/5.
const CORNER_GROWTH: f64 = 0.107_179_676_972_449_1;
/// Share of the smaller inradius from which a depth is worth a warning.
const DEEP: f64 = 0.4;

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

/// Energy of a cube's corner at this depth (m) over that without stiffening; `growth` is `1/D²`, 1/m².
#[must_use]
pub fn corner_gain(depth: f64, growth: f64) -> f64 {
    1.0 + CORNER_GROWTH * growth * depth * depth
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

#[cfg(test)]
mod tests {
    use super::*;

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
        // Force of the stiffened corner: (3 - sqrt 3)/2 kn d³ (1 + 1.2 h²/D²), its deepest point at h = (sqrt 3 - 1)/2 d.
        let (d, growth) = (0.1_f64, 300.0);
        let energy = |d: f64| CORNER_ENERGY * d.powi(4) * corner_gain(d, growth);
        let slope = (energy(d + 1e-6) - energy(d - 1e-6)) / 2e-6;
        let h = (3f64.sqrt() - 1.0) / 2.0 * d;
        let wanted = (3.0 - 3f64.sqrt()) / 2.0 * d.powi(3) * (1.0 + 1.2 * growth * h * h);
        assert!((slope / wanted - 1.0).abs() < 1e-8, "{slope} {wanted}");
        let stiffness = least_stiffness(2500.0, 2.0, 1.0);
        assert!((corner_depth(2500.0, 2.0, stiffness) - 0.05).abs() < 1e-12);
    }

    #[test]
    fn depths_are_judged_by_the_inradius() {
        assert_eq!(judge(0.03, 0.1), Depth::Fine);
        assert_eq!(judge(0.05, 0.1), Depth::Deep);
        assert_eq!(judge(0.1, 0.1), Depth::TooDeep);
        assert_eq!(judge(f64::NAN, 0.1), Depth::TooDeep);
    }
}
