//! What pieces of the surface of equal pressure carry: exact integrals of one, or of eight side by side, and the sums over all.
//!
//! The arithmetic is written once, for a number or for lanes of them ([`Number`]): the bits of a piece do not hang on what stands beside it.

use riprap_geom::Vec3;

use crate::kernel::frame::{Frame, Frames};
#[cfg(target_arch = "x86_64")]
use crate::kernel::octagon;
use crate::kernel::piece::Polygon;
use crate::lanes::{LANES, Lanes, Number, cross, dot, plus, scaled};

/// Integrals over a piece, about the foot of its frame.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Integrals<T = f64> {
    /// Of the depth, m³.
    pub depth: T,
    /// Of depth times s and t, m⁴.
    pub depth_first: [T; 2],
    /// Of depth times s² + t², m⁵.
    pub depth_second: T,
    /// Area, m².
    pub area: T,
    /// Of s and t, m³.
    pub area_first: [T; 2],
    /// Of s², st and t², m⁴.
    pub area_second: [T; 3],
}

impl<T: Number> Integrals<T> {
    /// Adds a triangle: s, t and depth of its corners. The sums are undivided until [`Integrals::finish`].
    #[inline(always)]
    fn add(&mut self, [[s0, t0, p0], [s1, t1, p1], [s2, t2, p2]]: [[T; 3]; 3]) {
        let number = T::constant;
        let twice = (s1 - s0) * (t2 - t0) - (s2 - s0) * (t1 - t0);
        let (sp, ss, st) = (p0 + p1 + p2, s0 + s1 + s2, t0 + t1 + t2);
        let sps = p0 * s0 + p1 * s1 + p2 * s2;
        let spt = p0 * t0 + p1 * t1 + p2 * t2;
        let (q0, q1, q2) = (s0 * s0 + t0 * t0, s1 * s1 + t1 * t1, s2 * s2 + t2 * t2);
        let sq = q0 + q1 + q2;
        let spq = p0 * q0 + p1 * q1 + p2 * q2;
        let squares = ss * ss + st * st;
        let two = number(2.0);
        let [mut depth_s, mut depth_t] = self.depth_first;
        self.depth = self.depth + twice * sp;
        depth_s = depth_s + twice * (sp * ss + sps);
        depth_t = depth_t + twice * (sp * st + spt);
        self.depth_first = [depth_s, depth_t];
        self.depth_second = self.depth_second
            + twice * (sp * squares + two * (ss * sps + st * spt) + sp * sq + two * spq);
        self.area = self.area + twice;
        let [a, b] = self.area_first;
        self.area_first = [a + twice * ss, b + twice * st];
        let [a, b, c] = self.area_second;
        self.area_second = [
            a + twice * (ss * ss + (s0 * s0 + s1 * s1 + s2 * s2)),
            b + twice * (ss * st + (s0 * t0 + s1 * t1 + s2 * t2)),
            c + twice * (st * st + (t0 * t0 + t1 * t1 + t2 * t2)),
        ];
    }

    /// Divides what triangles have added up to by what is the same for all of them.
    #[inline(always)]
    fn finish(mut self) -> Self {
        let number = T::constant;
        let (sixth, part) = (number(1.0 / 6.0), number(1.0 / 24.0));
        self.depth = self.depth * sixth;
        self.depth_first = self.depth_first.map(|x| x * part);
        self.depth_second = self.depth_second * number(1.0 / 120.0);
        self.area = self.area * number(0.5);
        self.area_first = self.area_first.map(|x| x * sixth);
        self.area_second = self.area_second.map(|x| x * part);
        self
    }
}

/// Integrals over a polygon with a depth that is linear in it: exact sums over a fan of triangles from corner 0.
#[must_use]
pub(crate) fn integrate(polygon: &Polygon) -> Integrals {
    let mut sum = Integrals::default();
    let (s, t, depth) = (polygon.s(), polygon.t(), polygon.depth());
    let corner = |i: usize| [s[i], t[i], depth[i]];
    for i in 1..polygon.len() - 1 {
        sum.add([corner(0), corner(i), corner(i + 1)]);
    }
    sum.finish()
}

/// Foot and axes of a frame by these numbers.
#[inline(always)]
fn along<T: Number>([c, e, h]: [&[T; 3]; 3], [x, s, t]: [T; 3]) -> [T; 3] {
    plus(&plus(&scaled(x, c), &scaled(s, e)), &scaled(t, h))
}

/// Column `k` of a share of the second moments.
#[inline(always)]
fn column<T: Number>(share: T, [c, e, h]: [&[T; 3]; 3], of: &[[T; 3]; 3], k: usize) -> [T; 3] {
    let two = plus(&scaled(c[k], &of[0]), &scaled(e[k], &of[1]));
    scaled(share, &plus(&two, &scaled(h[k], &of[2])))
}

/// What a piece adds to the sums, about the origin of the planes.
#[derive(Clone, Copy, Debug, Default)]
struct Addend<T> {
    force: [T; 3],
    moment: [T; 3],
    weight: T,
    weight_first: [T; 3],
    weight_second: T,
    area: T,
    area_first: [T; 3],
    area_second: [[T; 3]; 3],
    vector_area: [T; 3],
}

impl<T: Number> Addend<T> {
    /// A share of a piece with this foot, normal and axes of its frame.
    #[inline(always)]
    fn new(i: &Integrals<T>, share: T, m: &[T; 3], frame: [&[T; 3]; 3]) -> Self {
        let c = frame[0];
        let weight = share * i.depth;
        let [depth_s, depth_t] = i.depth_first;
        let first = scaled(share, &along(frame, [i.depth, depth_s, depth_t]));
        let [ss, st, tt] = i.area_second;
        let [a, b] = i.area_first;
        // (c + e s + h t)(c + e s + h t)ᵀ, column by column of e and h.
        let along_c = along(frame, [i.area, a, b]);
        let of = [along_c, along(frame, [a, ss, st]), along(frame, [b, st, tt])];
        Self {
            force: scaled(weight, m),
            moment: cross(&first, m),
            weight,
            weight_first: first,
            weight_second: share * (dot(c, c) * i.depth + i.depth_second),
            area: share * i.area,
            area_first: scaled(share, &along_c),
            area_second: [
                column(share, frame, &of, 0),
                column(share, frame, &of, 1),
                column(share, frame, &of, 2),
            ],
            vector_area: scaled(share * i.area, m),
        }
    }
}

/// Sums over the surface of equal pressure, about the origin of the planes. Depths stand for pressures (p = 2 kn depth).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Sums {
    /// Integral of depth times normal (from A to B), m³.
    pub force: Vec3,
    /// Integral of x times (depth times normal), m⁴.
    pub moment: Vec3,
    /// Integral of the depth, m³.
    pub weight: f64,
    /// Integral of depth times x, m⁴.
    pub weight_first: Vec3,
    /// Integral of depth times |x|², m⁵.
    pub weight_second: f64,
    /// Area, m².
    pub area: f64,
    /// Integral of x, m³.
    pub area_first: Vec3,
    /// Integral of x xᵀ by columns, m⁴.
    pub area_second: [Vec3; 3],
    /// Integral of the normal, m².
    pub vector_area: Vec3,
    /// Integral of the energy over `2 kn` per area of a flat contact, m⁴; 0 where pressures grow no faster than depths.
    pub stored: f64,
    /// Twice the largest depth: how far the blocks lie in each other, m.
    pub depth: f64,
    /// Pieces that are not empty.
    pub pieces: u32,
    /// Pieces looked at.
    pub tried: u32,
    /// The piece with the largest weight: places of its faces in the lists.
    pub hint: Option<[u16; 2]>,
    /// Edges that no plane has made: the lists are wrong.
    pub unlabelled: u32,
    /// Where covered faces bound the surface, integral of depth times normal of all of it, also beyond them, m³; zero elsewhere.
    pub whole: Vec3,
    /// Integral of the depth of the same, m³.
    pub whole_weight: f64,
}

impl Sums {
    /// Unit normal of the surface from A to B: the direction in which all of it presses, also what covered faces bound, so that the parts that two
    /// blocks have of one surface press alike. `None` where opposite pressures cancel to less than `least` of what they would be side by side.
    pub(crate) fn normal(&self, least: f64) -> Option<Vec3> {
        let (force, weight) = match self.whole == Vec3::ZERO {
            true => (self.force, self.weight),
            false => (self.whole, self.whole_weight),
        };
        let length = force.length();
        (length >= least * weight && length > 0.0).then(|| force / length)
    }

    /// Component along the normal of one of the vectors of these sums; where no covered face bounds the surface, its length.
    pub(crate) fn across(&self, v: Vec3, normal: Vec3) -> f64 {
        if self.whole == Vec3::ZERO { v.length() } else { v.dot(normal) }
    }

    /// Adds a share of a piece; its weight, m³.
    pub(super) fn add(&mut self, polygon: &Polygon, frame: &Frame, share: f64) -> f64 {
        let of = [frame.foot, frame.axes[0], frame.axes[1]].map(|v| v.to_array());
        let normal = frame.normal.to_array();
        let addend = Addend::new(&integrate(polygon), share, &normal, of.each_ref());
        self.take(&addend, polygon)
    }

    fn take(&mut self, piece: &Addend<f64>, polygon: &Polygon) -> f64 {
        self.pieces += 1;
        self.force += Vec3::from_array(piece.force);
        self.moment += Vec3::from_array(piece.moment);
        self.weight += piece.weight;
        self.weight_first += Vec3::from_array(piece.weight_first);
        self.weight_second += piece.weight_second;
        self.area += piece.area;
        self.area_first += Vec3::from_array(piece.area_first);
        for (column, of_piece) in self.area_second.iter_mut().zip(piece.area_second) {
            *column += Vec3::from_array(of_piece);
        }
        self.vector_area += Vec3::from_array(piece.vector_area);
        let deepest = polygon.depth().iter().copied();
        // Both depths are equal on the surface: the blocks lie in each other by their sum.
        self.depth = self.depth.max(2.0 * deepest.fold(0.0, f64::max));
        piece.weight
    }

    /// Adds other sums `sign` times, whose origin lies at `shift` (m) from this one. Depth and hint stay.
    pub(super) fn plus(&mut self, other: &Self, sign: f64, shift: Vec3) {
        let (w, first) = (sign * other.weight, sign * other.weight_first);
        self.pieces += other.pieces;
        self.tried += other.tried;
        self.unlabelled += other.unlabelled;
        self.force += sign * other.force;
        self.moment += sign * (other.moment + shift.cross(other.force));
        self.weight += w;
        self.weight_first += first + w * shift;
        self.weight_second +=
            sign * other.weight_second + 2.0 * shift.dot(first) + w * shift.length_squared();
        let (a, at) = (sign * other.area, sign * other.area_first);
        self.area += a;
        self.area_first += at + a * shift;
        for (k, column) in self.area_second.iter_mut().enumerate() {
            *column +=
                sign * other.area_second[k] + at[k] * shift + shift[k] * at + a * shift[k] * shift;
        }
        self.vector_area += sign * other.vector_area;
        self.stored += sign * other.stored;
    }
}

/// Corner by corner what polygons have in list `k`. `wide`: whether registers hold eight numbers.
#[inline(always)]
fn columns(wide: bool, polygons: [&Polygon; LANES], k: usize) -> [Lanes; LANES] {
    let mut columns = [Lanes::default(); LANES];
    #[cfg(target_arch = "x86_64")]
    if wide {
        for (row, polygon) in columns.iter_mut().zip(polygons) {
            *row = polygon.few().lists[k];
        }
        // Safety: `wide` is only where the machine has these instructions.
        return unsafe { octagon::transpose(&columns) };
    }
    let _ = wide;
    for (lane, polygon) in polygons.into_iter().enumerate() {
        for (column, x) in columns.iter_mut().zip(polygon.few().lists[k].0) {
            column.0[lane] = x;
        }
    }
    columns
}

/// Pieces side by side, each in a lane.
#[derive(Clone, Debug, Default)]
pub(super) struct Batch {
    /// Their planes.
    pub(super) frames: Frames,
    /// Those that are not empty, in their lanes.
    pub(super) polygons: [Polygon; LANES],
    /// How much of each counts; nothing of what is empty.
    pub(super) share: [f64; LANES],
    addends: Addend<Lanes>,
}

impl Batch {
    /// Whether the piece in a lane has no more corners than there are lanes: others are added by themselves.
    pub(super) fn fits(&self, lane: usize) -> bool {
        self.polygons[lane].len() <= LANES
    }

    /// Finds what all pieces add.
    ///
    /// Where a polygon has fewer corners than another, its last one is repeated: the triangles beyond it have the area 0 exactly. What lanes
    /// without a piece hold goes nowhere. `wide`: whether registers hold eight numbers.
    #[inline(always)]
    pub(super) fn integrate(&mut self, wide: bool) {
        let few = self.polygons.iter().filter(|polygon| polygon.len() <= LANES);
        let most = few.map(Polygon::len).max().unwrap_or(0);
        let [a, b, c, d, e, f, g, h] = &self.polygons;
        let rows = [a, b, c, d, e, f, g, h];
        let (s, t, depth) =
            (columns(wide, rows, 0), columns(wide, rows, 1), columns(wide, rows, 2));
        let mut sum = Integrals::default();
        for i in 1..most.max(1) - 1 {
            let [one, two, three] = [0, i, i + 1];
            sum.add([
                [s[one], t[one], depth[one]],
                [s[two], t[two], depth[two]],
                [s[three], t[three], depth[three]],
            ]);
        }
        let sum = sum.finish();
        let Frames { foot, normal, axes, .. } = &self.frames;
        self.addends = Addend::new(&sum, Lanes(self.share), normal, [foot, &axes[0], &axes[1]]);
    }

    /// Adds the piece in a lane to sums; its weight, m³.
    pub(super) fn give(&self, lane: usize, sums: &mut Sums) -> f64 {
        let of = &self.addends;
        // Written out: closures over lists are calls where code is not inlined across units.
        let one = |x: &Lanes| x.0[lane];
        let three = |v: &[Lanes; 3]| [v[0].0[lane], v[1].0[lane], v[2].0[lane]];
        let [x, y, z] = &of.area_second;
        let addend = Addend {
            force: three(&of.force),
            moment: three(&of.moment),
            weight: one(&of.weight),
            weight_first: three(&of.weight_first),
            weight_second: one(&of.weight_second),
            area: one(&of.area),
            area_first: three(&of.area_first),
            area_second: [three(x), three(y), three(z)],
            vector_area: three(&of.vector_area),
        };
        sums.take(&addend, &self.polygons[lane])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Against Gauss points on a fine grid of the unit square: depth 1 + 2 s + 3 t.
    #[test]
    fn integrals_of_a_square() {
        let polygon =
            Polygon::of([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]], [1.0, -2.0, -3.0]);
        let i = integrate(&polygon);
        let near = |a: f64, b: f64| assert!((a - b).abs() < 1e-14, "{a} {b}");
        near(i.area, 1.0);
        near(i.area_first[0], 0.5);
        near(i.area_second[0], 1.0 / 3.0);
        near(i.area_second[1], 0.25);
        near(i.area_second[2], 1.0 / 3.0);
        near(i.depth, 3.5);
        near(i.depth_first[0], 0.5 + 2.0 / 3.0 + 0.75);
        near(i.depth_first[1], 0.5 + 0.5 + 1.0);
        // int (1 + 2s + 3t)(s^2 + t^2): 2/3 + 2 (1/4 + 1/6) + 3 (1/6 + 1/4).
        near(i.depth_second, 2.0 / 3.0 + 5.0 * 5.0 / 12.0);
    }
}
