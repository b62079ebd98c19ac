//! Pressure that grows faster than the depth, so that nothing is driven through a block.
//!
//! A contact with the depths `phi` on its surface presses with any function of them that begins at 0:
//!
//! ```text
//! p(phi) = 2 kn phi (1 + (2 phi/D)²)          U = int_O P(min(phi_A, phi_B)) dV,   dP/dphi = ... = p
//!
//!   flat, d = 2 phi deep:  p = kn d (1 + (d/D)²),   dp/dd = kn (1 + 3 (d/D)²),   U = kn A (d²/2 + d⁴/(4 D²))
//! ```
//!
//! The energy density in the overlap `O` is `p(min(phi_A, phi_B))`: moved, each block carries its own field along, and the divergence theorem leaves `p n` on the
//! surface where both are equal, as for `2 kn phi` (`p` is 0 on the rim of `O`). So the pressure has a potential whatever shapes and rotations, and no
//! depth has to be remembered. Sums of polynomials of the fifth degree over triangles by seven points are exact.
//!
//! Source: J. Radon (1948), Monatshefte fuer Mathematik 52, 286-300, the seven points.

use crate::kernel::ContactLaw;
use crate::kernel::frame::Frame;
use crate::kernel::piece::Polygon;
use crate::kernel::sums::Sums;
use crate::kernel::surface::Walker;

/// Points of a triangle: its corners' shares, and the weight of the point as a share of the area.
const POINTS: [([f64; 3], f64); 7] = {
    const THIRD: f64 = 1.0 / 3.0;
    // (6 - sqrt 15)/21 and (6 + sqrt 15)/21.
    const A: f64 = 0.101_286_507_323_456_34;
    const B: f64 = 0.470_142_064_105_115_1;
    // (155 - sqrt 15)/1200 and (155 + sqrt 15)/1200.
    const OF_A: f64 = 0.125_939_180_544_827_15;
    const OF_B: f64 = 0.132_394_152_788_506_2;
    const A2: f64 = 1.0 - 2.0 * A;
    const B2: f64 = 1.0 - 2.0 * B;
    [
        ([THIRD, THIRD, THIRD], 0.225),
        ([A2, A, A], OF_A),
        ([A, A2, A], OF_A),
        ([A, A, A2], OF_A),
        ([B2, B, B], OF_B),
        ([B, B2, B], OF_B),
        ([B, B, B2], OF_B),
    ]
};

impl ContactLaw {
    /// Stiffness of a flat contact of this depth (m) over that of one without depth.
    #[must_use]
    pub(crate) fn tangent(&self, depth: f64) -> f64 {
        1.0 + 3.0 * self.growth * depth * depth
    }

    /// The law of springs as stiff as a flat contact of this depth (m).
    #[must_use]
    pub(crate) fn at_depth(self, depth: f64) -> Self {
        Self { normal_stiffness: self.normal_stiffness * self.tangent(depth), ..self }
    }

    /// Energy of a flat contact of this depth (m) over that of one that does not stiffen.
    #[must_use]
    pub(crate) fn more_energy(&self, depth: f64) -> f64 {
        1.0 + 0.5 * self.growth * depth * depth
    }
}

impl Walker {
    /// Adds what pressures that grow faster than depths have more; its weight, m³.
    pub(super) fn stiffen(&mut self, polygon: &Polygon, frame: &Frame, share: f64) -> f64 {
        match self.growth > 0.0 {
            true => self.sums.stiffen(self.growth, polygon, frame, share),
            false => 0.0,
        }
    }
}

impl Sums {
    /// Adds what the pressure of a share of a piece, which is in the sums already, has beyond the depth: with this growth (`1/D²`, 1/m²) the depth that stands for the pressure is
    /// `phi + 4 phi³/D²`. The weight that this adds, m³.
    pub(super) fn stiffen(
        &mut self,
        growth: f64,
        polygon: &Polygon,
        frame: &Frame,
        share: f64,
    ) -> f64 {
        let (s, t, depth) = (polygon.s(), polygon.t(), polygon.depth());
        let mut more = 0.0;
        for i in 1..polygon.len() - 1 {
            let corners = [0, i, i + 1];
            let at = |list: &[f64], of: &[f64; 3]| -> f64 {
                of[0] * list[corners[0]] + of[1] * list[corners[1]] + of[2] * list[corners[2]]
            };
            let [o, a, b] = corners;
            let area = 0.5 * ((s[a] - s[o]) * (t[b] - t[o]) - (s[b] - s[o]) * (t[a] - t[o]));
            for (of, weight) in &POINTS {
                let phi = at(depth, of);
                let square = phi * phi;
                let part = share * weight * area;
                self.stored += part * square * (1.0 + 2.0 * growth * square);
                let extra = part * 4.0 * growth * square * phi;
                let place = frame.point(at(s, of), at(t, of));
                more += extra;
                self.moment += place.cross(extra * frame.normal);
                self.weight_first += extra * place;
                self.weight_second += extra * place.length_squared();
            }
        }
        self.force += more * frame.normal;
        self.weight += more;
        more
    }
}

#[cfg(test)]
mod tests {
    use riprap_geom::Vec3;

    use super::*;
    use crate::kernel::Pose;
    use crate::kernel::kit::{Chance, KINDS, Placed, overlapping};
    use crate::kernel::sums::integrate;
    use crate::kernel::surface::Walker;

    /// Seven points find what the closed sums of a linear depth find, and the cube of a depth over a triangle.
    #[test]
    fn seven_points_are_exact() {
        let triangle =
            Polygon::of([[0.0, 0.0], [2.0, 0.5], [0.3, 1.0], [0.3, 1.0]], [0.1, -0.3, -0.2]);
        let total: f64 = POINTS.iter().map(|(_, weight)| weight).sum();
        assert!((total - 1.0).abs() < 1e-15);
        let frame = Frame { normal: Vec3::Z, foot: Vec3::ZERO, axes: [Vec3::X, Vec3::Y] };
        let mut sums = Sums::default();
        let more = sums.stiffen(1.0, &triangle, &frame, 1.0);
        // Complete homogeneous polynomials of the depths at the corners: int phi^k = 2 A k!/(k + 2)! h_k.
        let d = triangle.depth();
        let h = |k: i32| -> f64 {
            let mut sum = 0.0;
            for a in 0..=k {
                for b in 0..=k - a {
                    sum += d[0].powi(a) * d[1].powi(b) * d[2].powi(k - a - b);
                }
            }
            sum
        };
        let area = integrate(&triangle).area;
        let cube = 2.0 * area / 20.0 * h(3);
        let stored = 2.0 * area * (h(2) / 12.0 + 2.0 * h(4) / 30.0);
        assert!((more - 4.0 * cube).abs() < 1e-14, "{more} {cube}");
        assert!((sums.stored - stored).abs() < 1e-14);
        assert!((sums.force.z - more).abs() < 1e-15);
    }

    /// Forces are the slope of an energy: the work on a closed way of displacements is nil.
    #[test]
    fn a_closed_way_does_no_work() {
        for (seed, kind) in KINDS.into_iter().enumerate() {
            let mut chance = Chance::new(seed as u64 + 11);
            let mut walker = Walker::default();
            walker.growth = 400.0;
            let (shapes, poses) = overlapping(kind, 0.05, &mut chance);
            let shapes = [&shapes[0], &shapes[1]];
            let (mut work, mut all) = (0.0, 0.0);
            let count = 400;
            let at = |k: usize| {
                let angle = std::f64::consts::TAU * k as f64 / count as f64;
                0.004 * Vec3::new(angle.cos() - 1.0, angle.sin(), 0.3 * (2.0 * angle).sin())
            };
            for k in 0..count {
                let [from, to] = [at(k), at(k + 1)];
                let moved = Pose { position: poses[1].position + 0.5 * (from + to), ..poses[1] };
                let force = Placed::new(shapes, [poses[0], moved]).touch(&mut walker).force;
                work += force.dot(to - from);
                all += force.dot(to - from).abs();
            }
            assert!(work.abs() < 1e-4 * all, "{kind:?} {work} {all}");
        }
    }
}
