//! Closed forms of a pressure that varies linearly along a straight boundary piece.

/// Integral and centre of a linear profile on a piece of length `length` (m): returns
/// `(length (f0 + f1)/2, xi)`, `xi` in 0..1 from the start. For a zero profile `xi` is 1/2.
///
/// Source: mutual penetration potentials, S43: `f = pn L (fP + fQ)/2`,
/// `xi = (fP + 2 fQ)/(3 (fP + fQ))`.
#[inline]
#[must_use]
pub fn linear_piece(length: f64, f0: f64, f1: f64) -> (f64, f64) {
    let sum = f0 + f1;
    let xi = if sum > 0.0 { (f0 + 2.0 * f1) / (3.0 * sum) } else { 0.5 };
    (0.5 * length * sum, xi)
}

/// Force (N/m) of the distance potential for a flat contact: an edge of length `length` (m) of a
/// rectangle pushed `depth` (m) into a half plane, `kn (L d - d²/2)`.
///
/// Source: derived in the theory page from `U = kn/2 int (phi1 + phi2) dA`.
#[inline]
#[must_use]
pub fn flat_force(kn: f64, length: f64, depth: f64) -> f64 {
    kn * (length * depth - 0.5 * depth * depth)
}

/// Force (N/m) of the distance potential for a symmetric corner of half angle `half_angle` (rad)
/// pushed `depth` (m) into a long edge: `kn/2 tan(b)(1 + sin b) d²`.
#[inline]
#[must_use]
pub fn corner_force(kn: f64, half_angle: f64, depth: f64) -> f64 {
    0.5 * kn * libm::tan(half_angle) * (1.0 + libm::sin(half_angle)) * depth * depth
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn triangle_profile_centre_is_two_thirds() {
        assert_eq!(linear_piece(3.0, 0.0, 2.0), (3.0, 2.0 / 3.0));
        assert_eq!(linear_piece(3.0, 1.0, 1.0), (3.0, 0.5));
        assert_eq!(linear_piece(3.0, 0.0, 0.0), (0.0, 0.5));
    }
}
