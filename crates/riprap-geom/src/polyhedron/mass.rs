//! Volume, centroid and inertia of a solid, exactly: sums over tetrahedra from a point to the triangles of the faces.

use super::Polyhedron;
use crate::{Mat3, Vec3};

/// Moments of a solid of unit density.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Moments {
    /// Volume, m³; negative when the faces point inward.
    pub volume: f64,
    /// Centroid, m.
    pub centroid: Vec3,
    /// Inertia tensor about the centroid, `int (r.r 1 - r r^T) dV`, m⁵.
    pub inertia: Mat3,
}

impl Polyhedron {
    /// Volume, centroid and inertia tensor.
    #[must_use]
    pub fn moments(&self) -> Moments {
        // Relative to the middle of the vertices, so that digits are kept far from the origin.
        let origin = self.vertices.iter().sum::<Vec3>() / self.vertices.len() as f64;
        let (mut six_volumes, mut first, mut second) = (0.0, Vec3::ZERO, Mat3::ZERO);
        for corners in &self.faces {
            let at = |k: usize| self.vertices[corners[k] as usize] - origin;
            let a = at(0);
            for k in 1..corners.len().saturating_sub(1) {
                let (b, c) = (at(k), at(k + 1));
                let six = a.dot(b.cross(c));
                let sum = a + b + c;
                six_volumes += six;
                first += six * sum;
                // Tetrahedron (0, a, b, c): int x x^T = V/20 (sum of x x^T over its corners + sum sum^T).
                second += six * (outer(a) + outer(b) + outer(c) + outer(sum));
            }
        }
        let volume = six_volumes / 6.0;
        let offset = first / (4.0 * six_volumes);
        let about_origin = second * (1.0 / 120.0);
        let covariance = about_origin - outer(offset) * volume;
        let trace = covariance.x_axis.x + covariance.y_axis.y + covariance.z_axis.z;
        Moments { volume, centroid: origin + offset, inertia: Mat3::IDENTITY * trace - covariance }
    }
}

/// `v v^T`.
fn outer(v: Vec3) -> Mat3 {
    Mat3::from_cols(v.x * v, v.y * v, v.z * v)
}

/// Principal values, ascending, and right-handed unit axes (columns) of a symmetric matrix.
///
/// Jacobi's rotations; exact zeros stay zeros, so a diagonal matrix keeps its axes.
#[must_use]
pub fn principal(matrix: &Mat3) -> (Vec3, Mat3) {
    let mut a = matrix.to_cols_array_2d();
    let mut axes = Mat3::IDENTITY.to_cols_array_2d();
    for _ in 0..50 {
        let off = a[0][1] * a[0][1] + a[0][2] * a[0][2] + a[1][2] * a[1][2];
        let all = a[0][0] * a[0][0] + a[1][1] * a[1][1] + a[2][2] * a[2][2];
        if off <= 1e-32 * all || off == 0.0 {
            break;
        }
        for (p, q) in [(0, 1), (0, 2), (1, 2)] {
            if a[p][q] == 0.0 {
                continue;
            }
            let ratio = (a[q][q] - a[p][p]) / (2.0 * a[p][q]);
            let t = ratio.signum() / (ratio.abs() + (ratio * ratio + 1.0).sqrt());
            let c = 1.0 / (t * t + 1.0).sqrt();
            let s = t * c;
            for row in &mut a {
                (row[p], row[q]) = (c * row[p] - s * row[q], s * row[p] + c * row[q]);
            }
            // The rows of the matrix, and the axes, which are stored as rows here.
            for rows in [&mut a, &mut axes] {
                let (x, y) = (rows[p], rows[q]);
                rows[p] = [0, 1, 2].map(|k| c * x[k] - s * y[k]);
                rows[q] = [0, 1, 2].map(|k| s * x[k] + c * y[k]);
            }
        }
    }
    let mut order = [0, 1, 2];
    order.sort_by(|&x, &y| a[x][x].total_cmp(&a[y][y]));
    let axis = |k: usize| Vec3::from_array(axes[order[k]]);
    let (x, y) = (axis(0), axis(1));
    let values = Vec3::from_array(order.map(|k| a[k][k]));
    (values, Mat3::from_cols(x, y, x.cross(y)))
}
