//! Principal values and axes of symmetric matrices.

use crate::{Mat3, Vec3};

/// Turns after which all three axes of a matrix of full digits stand; Jacobi's method converges quadratically.
const SWEEPS: usize = 30;

/// Principal values of a symmetric matrix, largest first, and unit vectors along them that form a right-handed frame.
///
/// Jacobi's method of plane turns (Golub & Van Loan, Matrix Computations, 8.5): the axes are perpendicular to round-off even where
/// values are equal. Only the symmetric part of `m` counts. What is not finite gives values that are not.
#[must_use]
pub fn principal_axes(m: &Mat3) -> ([f64; 3], [Vec3; 3]) {
    let mut a = [[0.0; 3]; 3];
    for (i, row) in a.iter_mut().enumerate() {
        for (j, entry) in row.iter_mut().enumerate() {
            *entry = 0.5 * (m.col(j)[i] + m.col(i)[j]);
        }
    }
    let mut axes = [Vec3::X, Vec3::Y, Vec3::Z];
    let size: f64 = a.iter().flatten().map(|v| v * v).sum();
    for _ in 0..SWEEPS {
        let off = a[0][1] * a[0][1] + a[0][2] * a[0][2] + a[1][2] * a[1][2];
        // Not finite: no turn would end.
        if off <= f64::EPSILON * f64::EPSILON * size || !size.is_finite() {
            break;
        }
        for (p, q) in [(0, 1), (0, 2), (1, 2)] {
            turn(&mut a, &mut axes, p, q);
        }
    }
    let mut order = [0, 1, 2];
    order.sort_by(|&i, &j| a[j][j].total_cmp(&a[i][i]));
    let [x, y, z] = order.map(|k| axes[k]);
    // An axis may look either way; the third gives in.
    let z = if x.cross(y).dot(z) < 0.0 { -z } else { z };
    (order.map(|k| a[k][k]), [x, y, z])
}

/// Turns the axes `p` and `q` so that their entry off the diagonal is gone.
fn turn(a: &mut [[f64; 3]; 3], axes: &mut [Vec3; 3], p: usize, q: usize) {
    if a[p][q] == 0.0 {
        return;
    }
    let theta = (a[q][q] - a[p][p]) / (2.0 * a[p][q]);
    // The smaller of the two angles that do it, 45 degrees at most: with it the method converges.
    let t = theta.signum() / (theta.abs() + (theta * theta + 1.0).sqrt());
    let c = 1.0 / (t * t + 1.0).sqrt();
    let s = t * c;
    let r = 3 - p - q;
    let (apq, arp, arq) = (a[p][q], a[r][p], a[r][q]);
    a[p][p] -= t * apq;
    a[q][q] += t * apq;
    (a[p][q], a[q][p]) = (0.0, 0.0);
    a[r][p] = c * arp - s * arq;
    a[r][q] = s * arp + c * arq;
    (a[p][r], a[q][r]) = (a[r][p], a[r][q]);
    (axes[p], axes[q]) = (c * axes[p] - s * axes[q], s * axes[p] + c * axes[q]);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Quat;

    fn matrix(values: [f64; 3], axes: &Mat3) -> Mat3 {
        *axes * Mat3::from_diagonal(values.into()) * axes.transpose()
    }

    #[test]
    fn turned_frames_come_back() {
        let turns = [[0.3, -0.7, 1.1], [0.0, 0.0, 2.0], [1e-9, 0.0, 0.0]];
        let cases = [[3.0, 1.0, -2.0], [5.0, 5.0, -1e3], [1e7, 1.0, 1.0], [0.0; 3]];
        for turn in turns {
            let frame = Mat3::from_quat(Quat::from_scaled_axis(turn.into()));
            for values in cases {
                let (got, axes) = principal_axes(&matrix(values, &frame));
                let size = values.iter().fold(1.0, |m: f64, v| m.max(v.abs()));
                for k in 0..3 {
                    assert!((got[k] - values[k]).abs() < 4e-15 * size, "{got:?}");
                }
                let axes = Mat3::from_cols(axes[0], axes[1], axes[2]);
                assert!((axes.determinant() - 1.0).abs() < 1e-14);
                let back = matrix(got, &axes) - matrix(values, &frame);
                let far = back.to_cols_array().iter().fold(0.0, |m: f64, v| m.max(v.abs()));
                assert!(far < 1e-14 * size, "{far}");
            }
        }
    }

    #[test]
    fn what_is_no_number_is_let_through() {
        let (values, _) = principal_axes(&Mat3::from_diagonal(Vec3::new(1.0, f64::NAN, 2.0)));
        assert!(values.iter().any(|v| v.is_nan()));
    }
}
