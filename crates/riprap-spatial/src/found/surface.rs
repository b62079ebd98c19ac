//! The whole surface of equal pressure of a pair, walked from piece to piece, and the sums over it.
//!
//! The walk starts from the piece that carried most in the last step (the *hint*) or from the peak, and goes over shared edges. The surface
//! can have two parts (a spike through the thin part near a sharp edge of the other block): each listed face that the walk has
//! not met is looked at afterwards. Where blocks lie in each other so deep that corners of both come out on several sides, parts share
//! all of their faces with others; then every pair of faces is looked at.
//!
//! **Ties.** Where faces f' of A and g' of B are coplanar and face the same way, `phi_f' = phi_g'` in a whole region and the
//! side on which the surface runs there is a matter of round-off. Their strips (f', g) and (f, g') then both count, with weights that
//! add up to 1 and change continuously as one face passes through the other.

use riprap_geom::Vec3;

use super::peak::{Peak, peak};
use super::piece::{self, BOUNDARY, Cutter, Frame, OPEN, PARALLEL, Polygon};
use super::planes::{Planes, origin};
use super::remnant::Remnant;
use super::shape::Body;

/// Half the width of the band in which coplanar faces are tied, over the radius of the smaller block.
const TIE_BAND: f64 = 1e-6;
/// Overlaps less deep than this, times the radius of the smaller block, are lost in round-off.
const LOST: f64 = 1e-14;
/// Overlaps less deep than this, times the radius of the smaller block, may have no piece that is left by round-off.
const UNSURE: f64 = 1e-10;

/// Overlaps thicker than this, times the radius of the largest ball inside the smaller block: all pairs of faces are looked at.
const DEEP: f64 = 1.0;

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
}

impl Sums {
    /// Adds a share of a piece; its weight, m³.
    pub(super) fn add(&mut self, polygon: &Polygon, frame: &Frame, share: f64) -> f64 {
        let i = piece::integrate(polygon);
        let (c, m, [e, h]) = (frame.foot, frame.normal, frame.axes);
        let weight = share * i.depth;
        let first = share * (c * i.depth + e * i.depth_first[0] + h * i.depth_first[1]);
        self.pieces += 1;
        self.force += weight * m;
        self.moment += first.cross(m);
        self.weight += weight;
        self.weight_first += first;
        self.weight_second += share * (c.length_squared() * i.depth + i.depth_second);
        self.area += share * i.area;
        self.area_first += share * (c * i.area + e * i.area_first[0] + h * i.area_first[1]);
        let [ss, st, tt] = i.area_second;
        let [a, b] = i.area_first;
        // (c + e s + h t)(c + e s + h t)ᵀ, column by column of e and h.
        let (along_e, along_h) = (c * a + e * ss + h * st, c * b + e * st + h * tt);
        let along_c = c * i.area + e * a + h * b;
        for (k, column) in self.area_second.iter_mut().enumerate() {
            *column += share * (c[k] * along_c + e[k] * along_e + h[k] * along_h);
        }
        self.vector_area += share * i.area * m;
        let deepest = polygon.depth().iter().copied();
        self.depth = self.depth.max(2.0 * deepest.fold(0.0, f64::max));
        weight
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
    }
}

/// What was found of a pair.
#[expect(
    clippy::large_enum_variant,
    reason = "it lives on the stack of one evaluation; a box would take memory in every step"
)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Found {
    /// They do not touch; at least so far apart, m (0 where it is not known).
    Apart(f64),
    /// They overlap.
    Touching(Sums),
    /// One block lies in the other so deep that they have no surface of equal pressure; radius of the largest ball in both, m.
    /// No force can be given: the run must stop.
    Swallowed(f64),
}

/// A pair to be evaluated.
#[derive(Clone, Copy, Debug)]
pub struct Pair<'a> {
    /// A and B.
    pub bodies: [&'a Body<'a>; 2],
    /// Faces of each that can take part, ascending. All listed faces cut all pieces, neighbours or not.
    pub faces: [&'a [u16]; 2],
    /// Whether some faces of A and B may be coplanar.
    pub ties: bool,
    /// Places in the lists of the faces of the piece to start from.
    pub hint: Option<[u16; 2]>,
}

/// Faces of A and B in one plane, and where their offset lies in the band of ties, from -1 to 1.
#[derive(Clone, Copy, Debug)]
struct Tie {
    faces: [u16; 2],
    offset: f64,
}

/// Workspace for evaluating pairs one after the other; kept, so that a pair takes no memory.
#[derive(Clone, Debug, Default)]
pub struct Walker {
    /// Listed planes of the pair evaluated last.
    pub planes: Planes,
    /// All planes of the pair that was last tested for separation.
    all: Planes,
    /// The largest piece of the pair evaluated last.
    pub largest: Polygon,
    /// Its frame.
    pub largest_frame: Frame,
    /// Makes the pieces.
    pub cutter: Cutter,
    queue: Vec<[u16; 2]>,
    /// Stamp of the pair that last looked at piece (f, g), at `f * faces of B + g`.
    seen: Vec<u32>,
    stamp: u32,
    /// Whether each plane has a piece.
    met: Vec<bool>,
    ties: Vec<Tie>,
    remnant: Remnant,
    radius: f64,
    largest_weight: f64,
    sums: Sums,
}

impl Walker {
    /// Finds the surface of a pair.
    pub fn find(&mut self, pair: &Pair) -> Found {
        self.begin(pair);
        if let Some(hint) = pair.hint {
            self.walk(hint);
        }
        if self.sums.pieces == 0
            && let Some(verdict) = self.start_from_peak(pair)
        {
            return verdict;
        }
        self.look_at_the_rest(pair);
        let inside = |side: usize| pair.bodies[side].shape.inradius;
        if self.sums.depth > DEEP * inside(0).min(inside(1)) {
            self.walk_all();
        }
        Found::Touching(self.sums)
    }

    /// Tests for separation and walks from the peak; a verdict when there is no surface.
    ///
    /// With all planes, not only the listed ones: those are enough where the blocks overlap, but without the others two blocks
    /// that are apart could seem to meet somewhere else.
    fn start_from_peak(&mut self, pair: &Pair) -> Option<Found> {
        let [a, b] = pair.bodies;
        self.all.gather_all(pair.bodies, origin(a, b));
        let (depth, start) = match peak(&self.all, 4.0 * (a.shape.radius + b.shape.radius)) {
            Peak::Apart { gap, .. } => return Some(Found::Apart(gap)),
            Peak::Overlap { depth, start, .. } => (depth, start),
        };
        if depth < LOST * self.radius {
            return Some(Found::Apart(0.0));
        }
        if let Some([f, g]) = start {
            let place = |side: usize, face: u16| pair.faces[side].binary_search(&face);
            if let (Ok(f), Ok(g)) = (place(0, f), place(1, g - self.all.split as u16)) {
                self.walk([f as u16, g as u16]);
            }
        }
        if self.sums.pieces == 0 {
            self.walk_all();
        }
        if self.sums.pieces > 0 {
            None
        } else if depth < UNSURE.max(TIE_BAND) * self.radius {
            // Faces of both that go on in one plane are tied in this band, and what they share between them is no piece.
            Some(Found::Apart(0.0))
        } else {
            Some(Found::Swallowed(depth))
        }
    }

    fn begin(&mut self, pair: &Pair) {
        let [a, b] = pair.bodies;
        self.planes.gather(pair.bodies, pair.faces, origin(a, b));
        self.radius = a.shape.radius.min(b.shape.radius);
        let (first, second) = (pair.faces[0].len(), pair.faces[1].len());
        if self.seen.len() < first * second {
            self.seen.resize(first * second, 0);
        }
        if self.stamp == u32::MAX {
            self.seen.fill(0);
            self.stamp = 0;
        }
        self.stamp += 1;
        self.met.clear();
        self.met.resize(first + second, false);
        self.sums = Sums::default();
        self.largest_weight = 0.0;
        self.ties.clear();
        if pair.ties {
            self.find_ties();
        }
    }

    fn find_ties(&mut self) {
        let planes = &self.planes;
        for f in 0..planes.split {
            for g in planes.split..planes.len() {
                let difference = planes.normal(f) - planes.normal(g);
                let offset = (planes.d[g] - planes.d[f]) / (TIE_BAND * self.radius);
                if difference.length_squared() < PARALLEL * PARALLEL && offset.abs() < 1.0 {
                    self.ties.push(Tie {
                        faces: [f as u16, (g - planes.split) as u16],
                        offset,
                    });
                }
            }
        }
    }

    /// Tries piece (f, g), counted in the two lists, and all that hang together with it.
    fn walk(&mut self, start: [u16; 2]) {
        self.queue.clear();
        self.enqueue(start);
        let mut next = 0;
        while next < self.queue.len() {
            let piece = self.queue[next];
            next += 1;
            self.visit(piece);
        }
    }

    fn walk_all(&mut self) {
        let split = self.planes.split;
        for f in 0..split {
            for g in 0..self.planes.len() - split {
                self.walk([f as u16, g as u16]);
            }
        }
    }

    fn enqueue(&mut self, [f, g]: [u16; 2]) {
        let width = self.planes.len() - self.planes.split;
        let seen = &mut self.seen[f as usize * width + g as usize];
        if *seen != self.stamp {
            *seen = self.stamp;
            self.queue.push([f, g]);
        }
    }

    fn visit(&mut self, [f, g]: [u16; 2]) {
        self.sums.tried += 1;
        let split = self.planes.split;
        let numbers = [f as usize, g as usize + split];
        let Some(frame) = Frame::between(&self.planes, numbers[0], numbers[1], self.radius) else {
            return;
        };
        // The strip of f beside its twin g', and that of g beside its twin f'.
        let beside = |side: usize, face: u16| self.ties.iter().find(move |t| t.faces[side] == face);
        let (of_a, of_b) = (beside(0, f), beside(1, g));
        let twins = [
            of_a.map_or(usize::MAX, |t| t.faces[1] as usize + split),
            of_b.map_or(usize::MAX, |t| t.faces[0] as usize),
        ];
        let share = of_a.map_or(1.0, |t| 0.5 * (1.0 + t.offset))
            * of_b.map_or(1.0, |t| 0.5 * (1.0 - t.offset));
        let tied = |k: usize| twins.contains(&k);
        if !self
            .cutter
            .make(&self.planes, &frame, numbers, self.radius, tied)
        {
            return;
        }
        self.met[numbers[0]] = true;
        self.met[numbers[1]] = true;
        self.add(&frame, [f, g], share);
        self.queue_neighbours([f, g]);
    }

    fn add(&mut self, frame: &Frame, piece: [u16; 2], share: f64) {
        let weight = self.sums.add(&self.cutter.polygon, frame, share);
        let sums = &mut self.sums;
        if sums.hint.is_none() || weight > self.largest_weight {
            self.largest_weight = weight;
            sums.hint = Some(piece);
            self.largest.copy(&self.cutter.polygon);
            self.largest_frame = *frame;
        }
    }

    /// Mean distance of the pressure on the largest piece of the pair evaluated last from a point (m from the origin of the
    /// planes), m.
    #[must_use]
    pub fn mean_radius(&self, point: Vec3) -> f64 {
        let frame = &self.largest_frame;
        let arm = point - frame.foot;
        piece::mean_radius(&self.largest, frame.axes.map(|axis| arm.dot(axis)))
    }

    fn queue_neighbours(&mut self, [f, g]: [u16; 2]) {
        let split = self.planes.split as u16;
        for edge in 0..self.cutter.polygon.len() {
            let label = self.cutter.polygon.label()[edge];
            if label == OPEN {
                self.sums.unlabelled += 1;
                continue;
            }
            if label == BOUNDARY {
                continue;
            }
            let side = usize::from(label >= split);
            let face = if side == 0 { label } else { label - split };
            self.enqueue(if side == 0 { [face, g] } else { [f, face] });
            for at in 0..self.ties.len() {
                let tie = self.ties[at].faces;
                if tie[side] == face {
                    self.enqueue(if side == 0 { [f, tie[1]] } else { [tie[0], g] });
                }
            }
        }
    }

    /// Listed faces that have no piece yet may belong to another part of the surface.
    fn look_at_the_rest(&mut self, pair: &Pair) {
        let split = self.planes.split;
        let count = self.planes.len();
        for k in 0..count {
            let side = usize::from(k >= split);
            let others = if side == 0 { split..count } else { 0..split };
            if self.met[k] || !self.reaches_in(pair, k, others.clone()) {
                continue;
            }
            for other in others {
                let (f, g) = if side == 0 { (k, other) } else { (other, k) };
                self.walk([f as u16, (g - split) as u16]);
            }
        }
    }

    /// Whether a part of face `k` lies inside the other block, by its planes `others`. Only such faces have a piece: the ball about
    /// a point of it that reaches to the nearest plane lies in the overlap and touches the face.
    fn reaches_in(&mut self, pair: &Pair, k: usize, others: std::ops::Range<usize>) -> bool {
        let side = usize::from(k >= self.planes.split);
        let place = k - side * self.planes.split;
        let body = pair.bodies[side];
        let shift = body.position - origin(pair.bodies[0], pair.bodies[1]);
        let corners = body.shape.outline(pair.faces[side][place] as usize);
        self.remnant.begin(others.len(), corners.len());
        for (column, other) in others.enumerate() {
            let normal = self.planes.normal(other);
            // Turned back into the body once, instead of every corner into space.
            let (own, room) = (
                body.turn.transpose() * normal,
                self.planes.d[other] - normal.dot(shift),
            );
            let mut beyond = true;
            for (row, v) in corners.iter().enumerate() {
                let height = own.dot(body.shape.vertices[*v as usize]) - room;
                self.remnant.set(row, column, height);
                beyond &= height >= 0.0;
            }
            if beyond {
                return false;
            }
        }
        // A face that is tied to one of the other block counts on either side of it.
        let slack = if pair.ties {
            TIE_BAND * self.radius
        } else {
            0.0
        };
        self.remnant.is_left(slack)
    }
}
