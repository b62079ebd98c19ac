//! A water table as heights on a grid.

use riprap_geom::Vec3;
use serde::{Deserialize, Serialize};

use super::{Faces, Press, keep, pressed};

/// Heights at the places of a rectangular grid. Each cell is two triangles, on both sides of the diagonal whose ends differ less in height (the rising one of
/// equal ones); beyond the rim the height is that of the nearest place of the rim.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Grid {
    /// Its lines along x, m, ascending; two at least.
    pub x: Vec<f64>,
    /// Its lines along y, m, ascending; two at least.
    pub y: Vec<f64>,
    /// Height at `(x[i], y[j])` in `z[j * x.len() + i]`, m.
    pub z: Vec<f64>,
}

/// A part of the grid that is a plane, and the places above which it lies: where all `bounds` `[n_x, n_y, c]` have `n . x + c >= 0`.
struct Piece {
    bounds: Vec<[f64; 3]>,
    corner: Vec3,
    slope: [f64; 2],
}

impl Piece {
    fn holds(&self, x: f64, y: f64) -> bool {
        self.bounds.iter().all(|[a, b, c]| a * x + b * y + c >= 0.0)
    }

    fn height(&self, x: f64, y: f64) -> f64 {
        let [p, q] = self.slope;
        self.corner.z + p * (x - self.corner.x) + q * (y - self.corner.y)
    }
}

impl Grid {
    /// Height above a place, m.
    #[must_use]
    pub fn height(&self, x: f64, y: f64) -> f64 {
        let pieces = self.pieces([x, y], [x, y]);
        let piece = pieces.iter().find(|p| p.holds(x, y)).or(pieces.first());
        piece.map_or(f64::NEG_INFINITY, |p| p.height(x, y))
    }

    /// Its largest slope.
    #[must_use]
    pub fn steepest(&self) -> f64 {
        let infinite = [f64::NEG_INFINITY, f64::INFINITY].map(|v| [v; 2]);
        let pieces = self.pieces(infinite[0], infinite[1]);
        let slopes =
            pieces.iter().map(|p| (p.slope[0] * p.slope[0] + p.slope[1] * p.slope[1]).sqrt());
        slopes.fold(0.0, f64::max)
    }

    /// Whether a place lies within its rim.
    #[must_use]
    pub fn covers(&self, x: f64, y: f64) -> bool {
        let within = |list: &[f64], at: f64| {
            list.first().is_some_and(|low| at >= *low)
                && list.last().is_some_and(|high| at <= *high)
        };
        within(&self.x, x) && within(&self.y, y)
    }

    /// The pieces over a rectangle.
    fn pieces(&self, low: [f64; 2], high: [f64; 2]) -> Vec<Piece> {
        // Stretch k ends at line k; the last one has no end.
        let range = |list: &[f64], low: f64, high: f64| {
            let first = list.partition_point(|v| *v <= low);
            first..=list.partition_point(|v| *v < high).max(first)
        };
        let mut out = Vec::new();
        for j in range(&self.y, low[1], high[1]) {
            for i in range(&self.x, low[0], high[0]) {
                self.cell(i, j, &mut out);
            }
        }
        out
    }

    fn cell(&self, i: usize, j: usize, out: &mut Vec<Piece>) {
        let (nx, ny) = (self.x.len(), self.y.len());
        let [i0, i1] = [i.max(1) - 1, i.min(nx - 1)];
        let [j0, j1] = [j.max(1) - 1, j.min(ny - 1)];
        let at = |i: usize, j: usize| Vec3::new(self.x[i], self.y[j], self.z[j * nx + i]);
        let (a, b, c, d) = (at(i0, j0), at(i1, j0), at(i1, j1), at(i0, j1));
        let mut bounds = Vec::with_capacity(5);
        if i > 0 {
            bounds.push([1.0, 0.0, -a.x]);
        }
        if i < nx {
            bounds.push([-1.0, 0.0, c.x]);
        }
        if j > 0 {
            bounds.push([0.0, 1.0, -a.y]);
        }
        if j < ny {
            bounds.push([0.0, -1.0, c.y]);
        }
        let rise = |from: Vec3, to: Vec3, run: f64| {
            if run > 0.0 { (to.z - from.z) / run } else { 0.0 }
        };
        let (dx, dy) = (c.x - a.x, c.y - a.y);
        if i0 == i1 || j0 == j1 {
            let slope = [rise(a, b, dx), rise(a, d, dy)];
            out.push(Piece { bounds, corner: a, slope });
            return;
        }
        // To the right of the diagonal from `from` to `to` and to its left.
        let (from, to, right, left) = if (a.z - c.z).abs() <= (b.z - d.z).abs() {
            let right = [rise(a, b, dx), rise(b, c, dy)];
            (a, c, right, [rise(d, c, dx), rise(a, d, dy)])
        } else {
            let right = [rise(d, c, dx), rise(b, c, dy)];
            (b, d, right, [rise(a, b, dx), rise(a, d, dy)])
        };
        let (ex, ey) = (to.x - from.x, to.y - from.y);
        let side = [ey, -ex, ex * from.y - ey * from.x];
        for (sign, slope) in [(1.0, right), (-1.0, left)] {
            let mut bounds = bounds.clone();
            bounds.push(side.map(|v| sign * v));
            out.push(Piece { bounds, corner: from, slope });
        }
    }

    /// Calls `press` with the wet part of a flat convex polygon (corners from `centre`, m) below each piece and with the depth there, m.
    pub(super) fn each_wet(&self, centre: Vec3, face: &[Vec3], press: Press<'_>) {
        let start = (Vec3::INFINITY, Vec3::NEG_INFINITY);
        let (low, high) = face.iter().fold(start, |(l, h), r| (l.min(*r), h.max(*r)));
        let (low, high) = (centre + low, centre + high);
        for piece in self.pieces([low.x, low.y], [high.x, high.y]) {
            let depth = |r: Vec3| piece.height(centre.x + r.x, centre.y + r.y) - (centre.z + r.z);
            let mut wet = keep(face, &depth);
            for [a, b, c] in &piece.bounds {
                if wet.len() < 3 {
                    break;
                }
                let own = a * centre.x + b * centre.y + c;
                wet = keep(&wet, &|r: Vec3| a * r.x + b * r.y + own);
            }
            press(&wet, &depth);
        }
    }

    /// See [`super::WaterTable::on_face`].
    pub(super) fn on_face(&self, weight: f64, centre: Vec3, face: &[Vec3]) -> (Vec3, Vec3) {
        let (mut force, mut moment) = (Vec3::ZERO, Vec3::ZERO);
        self.each_wet(centre, face, &mut |wet, depth| {
            let (f, m) = pressed(wet, depth);
            force -= weight * f;
            moment -= weight * m;
        });
        (force, moment)
    }

    /// See [`super::WaterTable::on_polyhedron`].
    pub(super) fn on_polyhedron(
        &self,
        weight: f64,
        centre: Vec3,
        radius: f64,
        volume: f64,
        faces: Faces<'_>,
    ) -> (Vec3, Vec3) {
        let (low, high) =
            ([centre.x - radius, centre.y - radius], [centre.x + radius, centre.y + radius]);
        let pieces = self.pieces(low, high);
        if let [piece] = pieces.as_slice() {
            let [p, q] = piece.slope;
            let (depth, reach) = (
                piece.height(centre.x, centre.y) - centre.z,
                radius * (1.0 + p * p + q * q).sqrt(),
            );
            // All of it lies below one plane: pressure is linear there, and
            // its push that of the gradient on the volume.
            if depth >= reach {
                return (weight * volume * Vec3::new(-p, -q, 1.0), Vec3::ZERO);
            }
        }
        let above = |piece: &Piece| {
            let [p, q] = piece.slope;
            let reach = radius * (1.0 + p * p + q * q).sqrt();
            piece.height(centre.x, centre.y) - centre.z <= -reach
        };
        let (mut force, mut moment) = (Vec3::ZERO, Vec3::ZERO);
        if pieces.iter().all(above) {
            return (force, moment);
        }
        faces(&mut |face| {
            let (f, m) = self.on_face(weight, centre, face);
            force += f;
            moment += m;
        });
        (force, moment)
    }
}
