//! One plane piece of the surface of equal pressure: its polygon.
//!
//! Piece (f, g) lies where the depths below face f of A and below face g of B are equal, `(n_f - n_g) . x = d_f - d_g`. It is
//! cut by `phi_f >= 0` and by `phi_f <= phi_k` for every other listed k of A, `phi_g <= phi_k` for every other listed k of B.
//! Every edge carries the number of the plane that made it, which names the piece beyond it.

use riprap_geom::Vec3;

use crate::kernel::frame::Frame;
#[cfg(target_arch = "x86_64")]
use crate::kernel::octagon;
use crate::kernel::planes::Planes;
use crate::lanes::{LANES, Lanes, Width};

/// Label of an edge of the square that a piece starts from: none may be left at the end.
pub(crate) const OPEN: u16 = u16::MAX;
/// Label of an edge on the boundary of the overlap, where the depth is 0: nothing lies beyond it.
pub(crate) const BOUNDARY: u16 = u16::MAX - 1;
/// Half the side of the starting square over the radius of the smaller block; every piece lies within one radius of its centre.
const SQUARE: f64 = 2.2;

/// Corners of a polygon of at most [`LANES`] of them, a lane each; lanes beyond the last corner repeat it.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Few {
    /// First coordinate, second coordinate and depth, m.
    pub(super) lists: [Lanes; 3],
    /// Plane that made the edge which starts at each corner.
    pub(super) label: [u16; LANES],
}

/// Corners without a bound on their number. The lists keep more places than there are corners, so that cutting only writes into them.
#[derive(Clone, Debug, Default)]
struct Outline {
    len: usize,
    s: Vec<f64>,
    t: Vec<f64>,
    label: Vec<u16>,
}

impl Outline {
    /// The square with half the side `r` (m) that every piece is cut from.
    fn square(&mut self, r: f64) {
        self.make_room(4);
        self.len = 4;
        self.s[..4].copy_from_slice(&[-r, r, r, -r]);
        self.t[..4].copy_from_slice(&[-r, -r, r, r]);
        self.label[..4].fill(OPEN);
    }

    fn make_room(&mut self, corners: usize) {
        if self.s.len() < corners {
            self.s.resize(corners, 0.0);
            self.t.resize(corners, 0.0);
            self.label.resize(corners, OPEN);
        }
    }

    /// The corners of a polygon.
    fn load(&mut self, polygon: &Polygon) {
        let n = polygon.len;
        self.make_room(n);
        self.len = n;
        self.s[..n].copy_from_slice(polygon.s());
        self.t[..n].copy_from_slice(polygon.t());
        self.label[..n].copy_from_slice(polygon.label());
    }
}

/// A convex polygon in the plane of a piece. Edge `i` runs from corner `i` to the next one.
///
/// Few corners are kept in place: nearly all pieces have at most eight, and they are the innermost data of all contact in space.
#[derive(Clone, Debug, Default)]
pub struct Polygon {
    len: usize,
    few: Few,
    /// First coordinate, second coordinate and depth of each corner of a polygon of more than [`LANES`], and the plane of its edge.
    many: ([Vec<f64>; 3], Vec<u16>),
    /// The depth is `p[0] - p[1] s - p[2] t`.
    pub slope: [f64; 3],
}

impl Polygon {
    /// One with these corners (m), for tests.
    #[cfg(test)]
    pub fn of(corners: [[f64; 2]; 4], slope: [f64; 3]) -> Self {
        let mut outline = Outline::default();
        outline.square(1.0);
        for (k, [s, t]) in corners.into_iter().enumerate() {
            (outline.s[k], outline.t[k]) = (s, t);
        }
        let mut polygon = Self::default();
        polygon.take(&outline, slope);
        polygon
    }

    /// Leaves nothing of it.
    pub fn clear(&mut self) {
        self.len = 0;
    }

    /// Number of corners.
    #[must_use]
    pub fn len(&self) -> usize {
        self.len
    }

    /// Whether nothing is left of it.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len == 0
    }

    #[inline]
    fn list(&self, k: usize) -> &[f64] {
        let list = if self.len <= LANES { &self.few.lists[k].0[..] } else { &self.many.0[k] };
        &list[..self.len]
    }

    /// First coordinate of each corner, m.
    #[must_use]
    #[inline]
    pub fn s(&self) -> &[f64] {
        self.list(0)
    }

    /// Second coordinate, m.
    #[must_use]
    #[inline]
    pub fn t(&self) -> &[f64] {
        self.list(1)
    }

    /// Depth at each corner, m.
    #[must_use]
    #[inline]
    pub fn depth(&self) -> &[f64] {
        self.list(2)
    }

    /// Plane that made the edge which starts at each corner.
    #[must_use]
    #[inline]
    pub fn label(&self) -> &[u16] {
        let list = if self.len <= LANES { &self.few.label[..] } else { &self.many.1 };
        &list[..self.len]
    }

    /// The corners in lanes; meaningful where there are at most [`LANES`].
    #[inline]
    pub(super) fn few(&self) -> &Few {
        &self.few
    }

    /// Takes over corners in lanes.
    #[cfg(target_arch = "x86_64")]
    #[inline]
    pub(super) fn fill(&mut self, len: usize, slope: [f64; 3], few: Few) {
        (self.len, self.slope, self.few) = (len, slope, few);
    }

    /// Takes over an outline and finds the depths of its corners; whether there is a polygon.
    fn take(&mut self, outline: &Outline, slope: [f64; 3]) -> bool {
        let n = outline.len;
        if n < 3 {
            self.len = 0;
            return false;
        }
        (self.len, self.slope) = (n, slope);
        let [w, u, v] = slope;
        let depth = |k: usize| w - u * outline.s[k] - v * outline.t[k];
        if n <= LANES {
            for lane in 0..LANES {
                let k = lane.min(n - 1);
                self.few.label[lane] = outline.label[k];
                let values = [outline.s[k], outline.t[k], depth(k)];
                for (list, value) in self.few.lists.iter_mut().zip(values) {
                    list.0[lane] = value;
                }
            }
            return true;
        }
        let (lists, labels) = &mut self.many;
        labels.clear();
        labels.extend(&outline.label[..n]);
        for list in lists.iter_mut() {
            list.clear();
        }
        lists[0].extend(&outline.s[..n]);
        lists[1].extend(&outline.t[..n]);
        lists[2].extend((0..n).map(depth));
        true
    }

    /// Takes over the corners of another one.
    pub fn copy(&mut self, other: &Self) {
        (self.len, self.slope) = (other.len, other.slope);
        if other.len <= LANES {
            self.few = other.few;
        } else {
            // Not of the pair as a whole, which would take memory.
            for (to, from) in self.many.0.iter_mut().zip(&other.many.0) {
                to.clone_from(from);
            }
            self.many.1.clone_from(&other.many.1);
        }
    }
}

/// No plane is tied.
pub(crate) const UNTIED: [usize; 2] = [usize::MAX; 2];

/// Workspace for making pieces; kept, so that a piece takes no memory.
#[derive(Clone, Debug, Default)]
pub struct Cutter {
    /// Instructions that may be used; no bit of a result depends on them.
    width: Width,
    #[cfg(target_arch = "x86_64")]
    lines: octagon::Lines,
    outline: Outline,
    spare: Outline,
    beyond: Vec<f64>,
    u: Vec<f64>,
    v: Vec<f64>,
    w: Vec<f64>,
}

impl Cutter {
    /// Uses no wider instructions than `width` from now on.
    pub fn limit_width(&mut self, width: Width) {
        self.width = width;
    }

    /// Instructions that may be used.
    #[must_use]
    pub fn width(&self) -> Width {
        self.width
    }

    /// Makes piece (f, g) in the plane of `frame` into a polygon; whether anything is left. Planes that are `tied` do not cut.
    pub fn make(
        &mut self,
        planes: &Planes,
        frame: &Frame,
        [f, g]: [usize; 2],
        radius: f64,
        tied: [usize; 2],
        to: &mut Polygon,
    ) -> bool {
        to.clear();
        #[cfg(target_arch = "x86_64")]
        if self.width.is_eight() && planes.len() <= octagon::PLANES {
            let bit = |k: usize| if k < octagon::PLANES { 1 << k } else { 0 };
            let spared = bit(tied[0]) | bit(tied[1]);
            // Safety: there is no `Width` of eight but where the machine has these instructions.
            let left = unsafe {
                octagon::make(&mut self.lines, planes, frame, [f, g], SQUARE * radius, spared, to)
            };
            if let Some(left) = left {
                return left;
            }
        }
        self.project(planes, frame);
        self.outline.square(SQUARE * radius);
        let [u, v, w] = [self.u[f], self.v[f], self.w[f]];
        if !self.cut(u, v, w, BOUNDARY) {
            return false;
        }
        for k in 0..planes.len() {
            let own = if k < planes.split { f } else { g };
            if k == own || tied.contains(&k) {
                continue;
            }
            let (a, b) = (self.u[k] - self.u[own], self.v[k] - self.v[own]);
            if !self.cut(a, b, self.w[k] - self.w[own], k as u16) {
                return false;
            }
        }
        to.take(&self.outline, [w, u, v])
    }

    /// Cuts a piece by a further plane, `normal . x <= offset`, beyond which nothing is looked for; whether anything is left.
    pub fn clip(&mut self, frame: &Frame, normal: Vec3, offset: f64, piece: &mut Polygon) -> bool {
        let [a, b] = frame.axes.map(|axis| normal.dot(axis));
        let c = offset - normal.dot(frame.foot);
        let beyond = |(s, t): (&f64, &f64)| a * s + b * t > c;
        if !piece.s().iter().zip(piece.t()).any(beyond) {
            return true;
        }
        self.outline.load(piece);
        let left = self.cut(a, b, c, BOUNDARY) && piece.take(&self.outline, piece.slope);
        if !left {
            piece.clear();
        }
        left
    }

    /// All planes in the coordinates of the frame: `u s + v t <= w`.
    fn project(&mut self, planes: &Planes, frame: &Frame) {
        let n = planes.len();
        self.u.resize(n, 0.0);
        self.v.resize(n, 0.0);
        self.w.resize(n, 0.0);
        let ([e, h], c) = (frame.axes, frame.foot);
        let (x, y, z, d) = (&planes.x[..n], &planes.y[..n], &planes.z[..n], &planes.d[..n]);
        let (u, v, w) = (&mut self.u[..n], &mut self.v[..n], &mut self.w[..n]);
        for k in 0..n {
            // Added in the order of the vector form.
            u[k] = (x[k] * e.x + y[k] * e.y) + z[k] * e.z;
            v[k] = (x[k] * h.x + y[k] * h.y) + z[k] * h.z;
            w[k] = d[k] - ((x[k] * c.x + y[k] * c.y) + z[k] * c.z);
        }
    }

    /// Keeps what lies where `a s + b t <= c`; whether anything does.
    #[inline]
    fn cut(&mut self, a: f64, b: f64, c: f64, label: u16) -> bool {
        let n = self.outline.len;
        if self.beyond.len() < n {
            self.beyond.resize(2 * n, 0.0);
        }
        let (s, t) = (&self.outline.s[..n], &self.outline.t[..n]);
        let q = &mut self.beyond[..n];
        let (mut inside, mut outside) = (false, false);
        for i in 0..n {
            q[i] = (a * s[i] + b * t[i]) - c;
            inside |= q[i] <= 0.0;
            outside |= q[i] > 0.0;
        }
        if !outside {
            return inside;
        }
        if !inside {
            return false;
        }
        let labels = &self.outline.label[..n];
        // Every edge can leave two corners at most.
        self.spare.make_room(2 * n);
        let to = &mut self.spare;
        let (to_s, to_t, to_label) =
            (&mut to.s[..2 * n], &mut to.t[..2 * n], &mut to.label[..2 * n]);
        let mut m = 0;
        for i in 0..n {
            let next = if i + 1 < n { i + 1 } else { 0 };
            let (here, there) = (q[i] <= 0.0, q[next] <= 0.0);
            if here {
                (to_s[m], to_t[m], to_label[m]) = (s[i], t[i], labels[i]);
                m += 1;
            }
            if here != there {
                // From the start of the edge, so that every width of the kernel finds the same bits.
                let share = q[i] / (q[i] - q[next]);
                to_s[m] = s[i] + share * (s[next] - s[i]);
                to_t[m] = t[i] + share * (t[next] - t[i]);
                // On the way out the outline goes on along the line of the cut, on the way in along the old edge.
                to_label[m] = if here { label } else { labels[i] };
                m += 1;
            }
        }
        to.len = m;
        std::mem::swap(&mut self.outline, &mut self.spare);
        m >= 3
    }
}
