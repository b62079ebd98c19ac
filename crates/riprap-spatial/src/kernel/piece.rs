//! One plane piece of the surface of equal pressure: its polygon.
//!
//! Piece (f, g) lies where the depths below face f of A and below face g of B are equal, `(n_f - n_g) . x = d_f - d_g`. It is
//! cut by `phi_f >= 0` and by `phi_f <= phi_k` for every other listed k of A, `phi_g <= phi_k` for every other listed k of B.
//! Every edge carries the number of the plane that made it, which names the piece beyond it.

use riprap_geom::Vec3;

use crate::kernel::frame::Frame;
#[cfg(target_arch = "x86_64")]
use crate::kernel::octagon;
use crate::kernel::octagon::Lines;
use crate::kernel::planes::Planes;
use crate::lanes::Width;

/// Label of an edge of the square that a piece starts from: none may be left at the end.
pub(crate) const OPEN: u16 = u16::MAX;
/// Label of an edge on the boundary of the overlap, where the depth is 0: nothing lies beyond it.
pub(crate) const BOUNDARY: u16 = u16::MAX - 1;
/// Half the side of the starting square over the radius of the smaller block; every piece lies within one radius of its centre.
const SQUARE: f64 = 2.2;

/// A convex polygon in the plane of a piece. Edge `i` runs from corner `i` to the next one.
///
/// The lists keep more places than there are corners, so that cutting only writes into them: it is the innermost loop of all contact
/// in space.
#[derive(Clone, Debug, Default)]
pub struct Polygon {
    len: usize,
    s: Vec<f64>,
    t: Vec<f64>,
    depth: Vec<f64>,
    label: Vec<u16>,
    /// The depth is `p[0] - p[1] s - p[2] t`.
    pub slope: [f64; 3],
}

impl Polygon {
    /// The square with half the side `r` (m) that every piece is cut from.
    fn square(&mut self, r: f64) {
        self.make_room(4);
        self.len = 4;
        self.s[..4].copy_from_slice(&[-r, r, r, -r]);
        self.t[..4].copy_from_slice(&[-r, -r, r, r]);
        self.label[..4].fill(OPEN);
    }

    /// One with these corners (m), for tests.
    #[cfg(test)]
    pub fn of(corners: [[f64; 2]; 4], slope: [f64; 3]) -> Self {
        let mut polygon = Self::default();
        polygon.square(1.0);
        for (k, [s, t]) in corners.into_iter().enumerate() {
            (polygon.s[k], polygon.t[k]) = (s, t);
        }
        polygon.find_depths(slope);
        polygon
    }

    fn make_room(&mut self, corners: usize) {
        if self.s.len() < corners {
            self.s.resize(corners, 0.0);
            self.t.resize(corners, 0.0);
            self.depth.resize(corners, 0.0);
            self.label.resize(corners, OPEN);
        }
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

    /// First coordinate of each corner, m.
    #[must_use]
    pub fn s(&self) -> &[f64] {
        &self.s[..self.len]
    }

    /// Second coordinate, m.
    #[must_use]
    pub fn t(&self) -> &[f64] {
        &self.t[..self.len]
    }

    /// Depth at each corner, m.
    #[must_use]
    pub fn depth(&self) -> &[f64] {
        &self.depth[..self.len]
    }

    /// Plane that made the edge which starts at each corner.
    #[must_use]
    pub fn label(&self) -> &[u16] {
        &self.label[..self.len]
    }

    /// Finds the depths of all corners; whether there is a polygon.
    fn find_depths(&mut self, slope: [f64; 3]) -> bool {
        self.slope = slope;
        let (n, [w, u, v]) = (self.len, slope);
        let corners = self.s[..n].iter().zip(&self.t[..n]);
        for (depth, (s, t)) in self.depth[..n].iter_mut().zip(corners) {
            *depth = w - u * s - v * t;
        }
        n >= 3
    }

    /// Takes over corners from lanes: s, t, depth and label of each.
    #[cfg(target_arch = "x86_64")]
    #[inline]
    pub(super) fn fill<const N: usize>(
        &mut self,
        corners: usize,
        slope: [f64; 3],
        [s, t, depth, label]: [[f64; N]; 4],
    ) {
        self.make_room(N);
        self.len = corners;
        self.slope = slope;
        self.s[..N].copy_from_slice(&s);
        self.t[..N].copy_from_slice(&t);
        self.depth[..N].copy_from_slice(&depth);
        for (to, made) in self.label[..N].iter_mut().zip(label) {
            *to = made as u16;
        }
    }

    /// Takes over the corners of another one.
    pub fn copy(&mut self, other: &Self) {
        let n = other.len;
        self.make_room(n);
        self.len = n;
        self.s[..n].copy_from_slice(other.s());
        self.t[..n].copy_from_slice(other.t());
        self.depth[..n].copy_from_slice(other.depth());
        self.label[..n].copy_from_slice(other.label());
        self.slope = other.slope;
    }
}

/// Workspace for making pieces; kept, so that a piece takes no memory.
#[derive(Clone, Debug, Default)]
pub struct Cutter {
    /// The piece made last.
    pub polygon: Polygon,
    /// Instructions that may be used; no bit of a result depends on them.
    width: Width,
    #[cfg(target_arch = "x86_64")]
    lines: Lines,
    spare: Polygon,
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

    /// Makes piece (f, g) in the plane of `frame`; whether anything is left. `tied(k)` says that plane k does not cut.
    pub fn make(
        &mut self,
        planes: &Planes,
        frame: &Frame,
        [f, g]: [usize; 2],
        radius: f64,
        tied: impl Fn(usize) -> bool,
    ) -> bool {
        #[cfg(target_arch = "x86_64")]
        if self.width.is_eight()
            && planes.len() <= octagon::PLANES
            && let Some(left) = self.make_wide(planes, frame, [f, g], radius, &tied)
        {
            return left;
        }
        self.project(planes, frame);
        self.polygon.square(SQUARE * radius);
        let [u, v, w] = [self.u[f], self.v[f], self.w[f]];
        if !self.cut(u, v, w, BOUNDARY) {
            return false;
        }
        for k in 0..planes.len() {
            let own = if k < planes.split { f } else { g };
            if k == own || tied(k) {
                continue;
            }
            let (a, b) = (self.u[k] - self.u[own], self.v[k] - self.v[own]);
            if !self.cut(a, b, self.w[k] - self.w[own], k as u16) {
                return false;
            }
        }
        self.polygon.find_depths([w, u, v])
    }

    /// The same in vector registers; `None` where they have no room for it.
    #[cfg(target_arch = "x86_64")]
    fn make_wide(
        &mut self,
        planes: &Planes,
        frame: &Frame,
        piece: [usize; 2],
        radius: f64,
        tied: &impl Fn(usize) -> bool,
    ) -> Option<bool> {
        let spared = (0..planes.len()).fold(0, |bits, k| bits | u32::from(tied(k)) << k);
        // Safety: the caller has asked for a `Width` of eight, and there is none but where the machine has these instructions.
        unsafe {
            octagon::make(
                &mut self.lines,
                planes,
                frame,
                piece,
                SQUARE * radius,
                spared,
                &mut self.polygon,
            )
        }
    }

    /// Cuts the piece made last by a further plane, `normal . x <= offset`, beyond which nothing is looked for; whether
    /// anything is left.
    pub fn clip(&mut self, frame: &Frame, normal: Vec3, offset: f64) -> bool {
        let slope = self.polygon.slope;
        let [a, b] = frame.axes.map(|axis| normal.dot(axis));
        self.cut(a, b, offset - normal.dot(frame.foot), BOUNDARY) && self.polygon.find_depths(slope)
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
        let n = self.polygon.len;
        if self.beyond.len() < n {
            self.beyond.resize(2 * n, 0.0);
        }
        let (s, t) = (&self.polygon.s[..n], &self.polygon.t[..n]);
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
        let labels = &self.polygon.label[..n];
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
        std::mem::swap(&mut self.polygon, &mut self.spare);
        m >= 3
    }
}
