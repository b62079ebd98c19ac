//! Strain, stress and energy of a point, written once for one number and for eight.

use std::ops::{Add, Mul, Sub};

use riprap_keys::Words;
use serde::{Deserialize, Serialize};

use crate::geom::Mat3;
use crate::lanes::Lanes;

/// Components xx, yy, zz, yz, zx, xy of a symmetric tensor (no factor 2 in strains): how the kernels keep many of them.
/// Everywhere else a tensor is a matrix, see [`tensor`].
pub type Symmetric = [f64; 6];
/// Displacement gradient `H_ij = du_i / dX_j`, row by row.
pub type Gradient = [[f64; 3]; 3];

/// The symmetric tensor of components.
#[must_use]
pub fn tensor([xx, yy, zz, yz, zx, xy]: Symmetric) -> Mat3 {
    Mat3::from_cols_array(&[xx, xy, zx, xy, yy, yz, zx, yz, zz])
}

/// Isotropic linear elasticity: Lame's constants, Pa.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Elastic {
    /// First constant.
    pub lambda: f64,
    /// Shear modulus.
    pub mu: f64,
}

impl Elastic {
    /// From Young's modulus (Pa) and Poisson's ratio (in -1 to 0.5, ends excluded).
    #[inline]
    #[must_use]
    pub fn new(young: f64, poisson: f64) -> Self {
        Self {
            lambda: young * poisson / ((1.0 + poisson) * (1.0 - 2.0 * poisson)),
            mu: young / (2.0 * (1.0 + poisson)),
        }
    }

    /// Speed of P waves at `density` (kg/m³), m/s.
    #[inline]
    #[must_use]
    pub fn p_speed(&self, density: f64) -> f64 {
        ((self.lambda + 2.0 * self.mu) / density).sqrt()
    }
}

/// Measure of strain of tetrahedra.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Words)]
pub enum Strain {
    /// Small strain and rotation (linear); a block that turns freely swells.
    ///
    /// The symmetric part of the displacement gradient.
    #[default]
    Small,
    /// Green's strain with St. Venant-Kirchhoff's law: any rotation.
    #[word("total_lagrangian")]
    Large,
}

/// One number or one per lane: what the formulas below are written for.
pub(super) trait Number:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self>
{
    fn of(x: f64) -> Self;
}

impl Number for f64 {
    #[inline(always)]
    fn of(x: f64) -> Self {
        x
    }
}

impl Number for Lanes {
    #[inline(always)]
    fn of(x: f64) -> Self {
        Lanes::all(x)
    }
}

/// Where the off-diagonal components yz, zx, xy stand in a 3 x 3 matrix.
const OFF: [(usize, usize); 3] = [(1, 2), (2, 0), (0, 1)];

/// Strain from the displacement gradient.
#[inline(always)]
pub(super) fn measure<T: Number, const LARGE: bool>(h: &[[T; 3]; 3]) -> [T; 6] {
    let half = T::of(0.5);
    let mut e = [T::of(0.0); 6];
    for k in 0..3 {
        e[k] = h[k][k];
        let (i, j) = OFF[k];
        e[k + 3] = half * (h[i][j] + h[j][i]);
    }
    if LARGE {
        for k in 0..3 {
            let (i, j) = OFF[k];
            let square = h[0][k] * h[0][k] + h[1][k] * h[1][k] + h[2][k] * h[2][k];
            let mixed = h[0][i] * h[0][j] + h[1][i] * h[1][j] + h[2][i] * h[2][j];
            e[k] = e[k] + half * square;
            e[k + 3] = e[k + 3] + half * mixed;
        }
    }
    e
}

/// Hooke's law plus a start stress.
#[inline(always)]
pub(super) fn hooke<T: Number>(law: &Elastic, e: &[T; 6], start: &[T; 6]) -> [T; 6] {
    let two_mu = T::of(2.0 * law.mu);
    let pressure = T::of(law.lambda) * (e[0] + e[1] + e[2]);
    let mut s = *start;
    for k in 0..3 {
        s[k] = s[k] + (pressure + two_mu * e[k]);
        s[k + 3] = s[k + 3] + two_mu * e[k + 3];
    }
    s
}

/// `(1 + H) S` for large strain, `S` for small.
#[inline(always)]
pub(super) fn first_piola<T: Number, const LARGE: bool>(
    h: &[[T; 3]; 3],
    s: &[T; 6],
) -> [[T; 3]; 3] {
    let full = [[s[0], s[5], s[4]], [s[5], s[1], s[3]], [s[4], s[3], s[2]]];
    if !LARGE {
        return full;
    }
    let mut p = full;
    for i in 0..3 {
        for j in 0..3 {
            p[i][j] =
                p[i][j] + (h[i][0] * full[0][j] + h[i][1] * full[1][j] + h[i][2] * full[2][j]);
        }
    }
    p
}

/// Stress at a displacement gradient, Pa: Cauchy's. `start` is a second Piola-Kirchhoff stress in the undeformed
/// state. `None` when the element is turned inside out.
#[inline]
#[must_use]
pub fn stress(law: &Elastic, strain: Strain, start: &Symmetric, h: &Gradient) -> Option<Symmetric> {
    match strain {
        Strain::Small => Some(hooke(law, &measure::<f64, false>(h), start)),
        Strain::Large => {
            let s = hooke(law, &measure::<f64, true>(h), start);
            let p = first_piola::<f64, true>(h, &s);
            let mut f = *h;
            for (k, row) in f.iter_mut().enumerate() {
                row[k] += 1.0;
            }
            let minor = |j: usize, k: usize| f[1][j] * f[2][k] - f[1][k] * f[2][j];
            let det = f[0][0] * minor(1, 2) + f[0][1] * minor(2, 0) + f[0][2] * minor(0, 1);
            // P F^T / det F.
            let c = |i: usize, j: usize| {
                (p[i][0] * f[j][0] + p[i][1] * f[j][1] + p[i][2] * f[j][2]) / det
            };
            (det > 0.0).then(|| [c(0, 0), c(1, 1), c(2, 2), c(1, 2), c(2, 0), c(0, 1)])
        }
    }
}

/// Second Piola-Kirchhoff stress at a displacement gradient, Pa; with small strain just the stress.
#[inline]
#[must_use]
pub fn second_piola(law: &Elastic, strain: Strain, start: &Symmetric, h: &Gradient) -> Symmetric {
    match strain {
        Strain::Small => hooke(law, &measure::<f64, false>(h), start),
        Strain::Large => hooke(law, &measure::<f64, true>(h), start),
    }
}

/// Strain energy per undeformed volume, J/m³; a start stress adds its work.
#[inline]
#[must_use]
pub fn energy_density(law: &Elastic, strain: Strain, start: &Symmetric, h: &Gradient) -> f64 {
    let e = match strain {
        Strain::Small => measure::<f64, false>(h),
        Strain::Large => measure::<f64, true>(h),
    };
    density(law, &e, start)
}

#[inline(always)]
pub(super) fn density<T: Number>(law: &Elastic, e: &[T; 6], start: &[T; 6]) -> T {
    let elastic = hooke(law, e, &[T::of(0.0); 6]);
    let (half, two) = (T::of(0.5), T::of(2.0));
    // The elastic stress has grown with the strain from nothing; that of the start was whole all the way.
    let each = |k: usize| (half * elastic[k] + start[k]) * e[k];
    // Components off the diagonal stand twice in the tensor.
    (each(0) + each(1) + each(2)) + two * (each(3) + each(4) + each(5))
}
