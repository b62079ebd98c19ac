//! The whole surface of equal pressure of a pair, walked from piece to piece, and the sums over it.
//!
//! The walk starts from the piece that carried most in the last step (the *hint*) or from the peak, and goes over shared edges. The surface
//! can have two parts (a spike through the thin part near a sharp edge of the other block): each listed face that the walk has
//! not met is looked at afterwards. Where blocks lie in each other so deep that corners of both come out on several sides, parts share
//! all of their faces with others; then every pair of faces is looked at.
//!
//! Faces that other blocks cover are no part of it, but bound it ([`super::walls`]).
//!
//! **Ties.** Where faces f' of A and g' of B are coplanar and face the same way, `phi_f' = phi_g'` in a whole region and the
//! side on which the surface runs there is a matter of round-off. Their strips (f', g) and (f, g') then both count, with weights that
//! add up to 1 and change continuously as one face passes through the other.

use std::sync::atomic::{AtomicU8, Ordering};

use riprap_geom::{Mat3, Vec3};

use crate::kernel::ContactLaw;
use crate::kernel::face_clip::{FaceClip, cut_face, is_beyond};
use crate::kernel::frame::{Frame, Frames, PARALLEL};
use crate::kernel::lateral;
use crate::kernel::peak::{Peak, peak};
use crate::kernel::piece::{BOUNDARY, Cutter, OPEN, Polygon, UNTIED};
use crate::kernel::planes::{Planes, origin};
use crate::kernel::shape::Body;
use crate::kernel::sums::{Batch, Sums};
use crate::lanes::LANES;

/// Half the width of the band in which coplanar faces are tied, over the radius of the smaller block.
const TIE_BAND: f64 = 1e-6;
/// Overlaps less deep than this, times the radius of the smaller block, are lost in round-off.
const LOST: f64 = 1e-14;
/// Overlaps less deep than this, times the radius of the smaller block, may have no piece that is left by round-off.
const UNSURE: f64 = 1e-10;

/// Overlaps thicker than this, times the radius of the largest ball inside the smaller block: all pairs of faces are looked at.
const DEEP: f64 = 1.0;

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
    /// They have no surface of equal pressure: one block lies in the other as a whole, or round-off has lost it. Radius of the largest ball
    /// in both, m. No force can be given: the run must stop.
    FullyPenetrated(f64),
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
    /// Faces of each that other blocks cover, a bit each; none of them is among `faces`.
    pub covered: [u64; 2],
    /// For each listed face (those of A first) the plane of the other block that had all of it beyond itself in the last evaluation, by its
    /// place in the list; tested first. No result depends on it. May be empty.
    pub witnesses: &'a [Witness],
}

/// A place in a list of planes, kept from step to step as a guess.
pub(crate) type Witness = AtomicU8;

/// Faces of A and B in one plane, and where their offset lies in the band of ties, from -1 to 1.
#[derive(Clone, Copy, Debug)]
struct Tie {
    faces: [u16; 2],
    offset: f64,
}

/// A piece as it was made.
#[derive(Clone, Debug, Default)]
struct Kept {
    polygon: Polygon,
    frame: Frame,
    /// How much of it counts.
    share: f64,
}

/// Workspace for evaluating pairs one after the other; kept, so that a pair takes no memory.
#[derive(Clone, Debug, Default)]
pub struct Walker {
    /// Listed planes of the pair evaluated last.
    pub planes: Planes,
    /// All planes of the pair that was last tested for separation.
    pub(super) all: Planes,
    /// The largest piece of the pair evaluated last.
    pub largest: Polygon,
    /// Its frame.
    pub largest_frame: Frame,
    /// Makes the pieces.
    pub cutter: Cutter,
    queue: Vec<[u16; 2]>,
    /// `None` until it is needed: many walkers never walk.
    batch: Option<Box<Batch>>,
    /// Stamp of the pair that last looked at piece (f, g), at `f * faces of B + g`.
    seen: Vec<u32>,
    stamp: u32,
    /// Whether each plane has a piece.
    met: Vec<bool>,
    /// The pieces that are not empty.
    pieces: Vec<[u16; 2]>,
    ties: Vec<Tie>,
    /// Planes of covered faces, `n . x <= d`, that reach into the other block.
    pub(super) walls: Vec<(Vec3, f64)>,
    clip: FaceClip,
    /// Of the smaller block, m.
    radius: f64,
    /// Distance from the origin within which pieces lie, m: beyond covered faces that of both blocks together.
    pub(super) reach: f64,
    /// How fast pressures grow beyond the depth (`ContactLaw::growth`), 1/m².
    pub growth: f64,
    /// How far all faces are moved outward, m.
    pub(super) inflation: f64,
    /// Whether pieces are kept as they are made.
    keeping: bool,
    /// The pieces themselves, in the order of `pieces`; the list only grows, so that a pair takes no memory.
    kept: Vec<Kept>,
    largest_weight: f64,
    pub(super) sums: Sums,
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

    /// As [`Walker::find`] with all faces of both blocks `by` (m) further out: depths are larger by as much, and blocks that are less than twice
    /// that apart have a surface too. Its pieces are kept.
    pub(crate) fn find_inflated(&mut self, pair: &Pair, by: f64) -> Found {
        (self.inflation, self.keeping, self.growth) = (by, true, 0.0);
        let found = self.find(pair);
        (self.inflation, self.keeping) = (0.0, false);
        found
    }

    /// The pieces of the pair that was last evaluated with faces further out: the numbers of their planes, and the share of them that counts.
    pub(crate) fn kept(&self) -> impl Iterator<Item = ([usize; 2], &Frame, &Polygon, f64)> {
        let pieces = self.pieces.iter().zip(&self.kept);
        pieces.map(|(piece, kept)| (self.numbers(*piece), &kept.frame, &kept.polygon, kept.share))
    }

    /// Tests for separation and walks from the peak; a verdict when there is no surface.
    ///
    /// With all planes, not only the listed ones: those are enough where the blocks overlap, but without the others two blocks
    /// that are apart could seem to meet somewhere else.
    fn start_from_peak(&mut self, pair: &Pair) -> Option<Found> {
        let [a, b] = pair.bodies;
        self.all.gather_all(pair.bodies, origin(a, b));
        self.all.inflate(self.inflation);
        let (depth, start) = match peak(&self.all, 4.0 * (a.shape.radius + b.shape.radius)) {
            Peak::Apart { gap, .. } => return Some(Found::Apart(gap)),
            Peak::Unsure => return self.look_for_proof(),
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
        // By round-off that piece can be empty, or one of faces that are not listed: then all of them are tried.
        if self.sums.pieces == 0 {
            self.walk_all();
        }
        if self.sums.pieces > 0 {
            None
        } else if !self.walls.is_empty() && !self.lies_inside(pair) {
            // What lies in the other block does so beyond a covered face: it is in the block that covers it.
            Some(Found::Apart(0.0))
        } else if depth < UNSURE.max(TIE_BAND) * self.radius {
            // Faces of both that go on in one plane are tied in this band, and what they share between them is no piece.
            Some(Found::Apart(0.0))
        } else {
            Some(Found::FullyPenetrated(depth))
        }
    }

    /// Where round-off has hidden the peak a piece that lies in both blocks proves that they touch; a verdict where there is none.
    #[cold]
    fn look_for_proof(&mut self) -> Option<Found> {
        self.walk_all();
        let (piece, frame) = (&self.largest, &self.largest_frame);
        let inside = self.sums.pieces > 0 && {
            let share = 1.0 / piece.len() as f64;
            let mean = |list: &[f64]| share * list.iter().sum::<f64>();
            let at = frame.point(mean(piece.s()), mean(piece.t()));
            let room = |k: usize| self.all.d[k] - self.all.normal(k).dot(at);
            // Of all planes: those that are not listed may leave nothing of it.
            (0..self.all.len()).all(|k| room(k) >= -UNSURE * self.radius)
        };
        if inside {
            None
        } else {
            self.sums = Sums::default();
            Some(Found::Apart(0.0))
        }
    }

    fn begin(&mut self, pair: &Pair) {
        let [a, b] = pair.bodies;
        self.planes.gather(pair.bodies, pair.faces, origin(a, b));
        self.planes.inflate(self.inflation);
        self.radius = a.shape.radius.min(b.shape.radius);
        let (first, second) = (pair.faces[0].len(), pair.faces[1].len());
        if self.seen.len() < first * second {
            self.seen.resize(first * second, 0);
        }
        // A stamp for each pair, so that the table needs no clearing before every one of them.
        if self.stamp == u32::MAX {
            self.seen.fill(0);
            self.stamp = 0;
        }
        self.stamp += 1;
        self.met.clear();
        self.met.resize(first + second, false);
        self.pieces.clear();
        self.sums = Sums::default();
        self.largest_weight = 0.0;
        self.ties.clear();
        if pair.ties {
            self.find_ties();
        }
        self.walls.clear();
        self.reach = self.radius;
        if pair.covered != [0; 2] {
            self.find_walls(pair);
        }
    }

    fn find_ties(&mut self) {
        let planes = &self.planes;
        for f in 0..planes.split {
            for g in planes.split..planes.len() {
                let difference = planes.normal(f) - planes.normal(g);
                let offset = (planes.d[g] - planes.d[f]) / (TIE_BAND * self.radius);
                if difference.length_squared() < PARALLEL * PARALLEL && offset.abs() < 1.0 {
                    self.ties.push(Tie { faces: [f as u16, (g - planes.split) as u16], offset });
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
            let some = (self.queue.len() - next).min(LANES);
            if some == 1 {
                self.visit(self.queue[next]);
            } else {
                self.visit_side_by_side(next, some);
            }
            next += some;
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

    fn visit(&mut self, piece: [u16; 2]) {
        self.sums.tried += 1;
        let [f, g] = self.numbers(piece);
        let mut batch = self.batch.take().unwrap_or_default();
        let polygon = &mut batch.polygons[0];
        if let Some(frame) = Frame::between(&self.planes, f, g, self.reach)
            && let Some(share) = self.make(&frame, piece, polygon)
        {
            let weight = self.sums.add(polygon, &frame, share);
            let weight = weight + self.stiffen(polygon, &frame, share);
            if self.takes_the_lead(weight, piece) {
                self.largest.copy(polygon);
                self.largest_frame = frame;
            }
            self.queue_neighbours(piece, polygon);
        }
        self.batch = Some(batch);
    }

    /// Tries `some` pieces of the queue from `first` on. What they add is found for all of them at once, and added one after the other.
    fn visit_side_by_side(&mut self, first: usize, some: usize) {
        self.sums.tried += some as u32;
        let mut numbers = [[0; 2]; LANES];
        for (number, piece) in numbers.iter_mut().zip(&self.queue[first..first + some]) {
            *number = self.numbers(*piece);
        }
        let width = self.cutter.width();
        let (planes, reach) = (&self.planes, self.reach);
        let mut batch = self.batch.take().unwrap_or_default();
        batch.frames = width.run(
            #[inline(always)]
            || Frames::between(planes, &numbers[..some], reach),
        );
        for lane in 0..LANES {
            batch.share[lane] = 0.0;
            // What the lane holds is of an earlier batch.
            batch.polygons[lane].clear();
            if lane < some
                && let Some(frame) = batch.frames.get(lane)
            {
                let piece = self.queue[first + lane];
                if let Some(share) = self.make(&frame, piece, &mut batch.polygons[lane]) {
                    self.queue_neighbours(piece, &batch.polygons[lane]);
                    batch.share[lane] = share;
                }
            }
        }
        let wide = width.is_eight();
        width.run(
            #[inline(always)]
            || batch.integrate(wide),
        );
        // In the order of the queue, so that the sums are those of one piece after the other.
        for lane in 0..some {
            let polygon = &batch.polygons[lane];
            let Some(frame) = batch.frames.get(lane).filter(|_| !polygon.is_empty()) else {
                continue;
            };
            let weight = if batch.fits(lane) {
                batch.give(lane, &mut self.sums)
            } else {
                self.sums.add(polygon, &frame, batch.share[lane])
            };
            let weight = weight + self.stiffen(polygon, &frame, batch.share[lane]);
            if self.takes_the_lead(weight, self.queue[first + lane]) {
                self.largest.copy(polygon);
                self.largest_frame = frame;
            }
        }
        self.batch = Some(batch);
    }

    /// Numbers of the planes of a piece, counted in the two lists.
    fn numbers(&self, [f, g]: [u16; 2]) -> [usize; 2] {
        [f as usize, g as usize + self.planes.split]
    }

    /// Makes the polygon of a piece; how much of it counts, `None` where nothing is left.
    fn make(&mut self, frame: &Frame, piece: [u16; 2], to: &mut Polygon) -> Option<f64> {
        let numbers = self.numbers(piece);
        let (tied, share) =
            if self.ties.is_empty() { (UNTIED, 1.0) } else { self.beside_twins(piece) };
        let mut left = self.cutter.make(&self.planes, frame, numbers, self.reach, tied, to);
        if left && !self.walls.is_empty() {
            left = self.bound(frame, piece, share, to);
        }
        if left {
            for number in numbers {
                self.met[number] = true;
            }
            if self.keeping {
                if self.kept.len() == self.pieces.len() {
                    self.kept.push(Kept::default());
                }
                let kept = &mut self.kept[self.pieces.len()];
                kept.polygon.copy(to);
                (kept.frame, kept.share) = (*frame, share);
            }
            self.pieces.push(piece);
        }
        left.then_some(share)
    }

    /// Planes tied to those of a piece, which do not cut it, and how much of it counts: the strip of f beside its twin g', and that of g beside
    /// its twin f'.
    fn beside_twins(&self, [f, g]: [u16; 2]) -> ([usize; 2], f64) {
        let beside = |side: usize, face: u16| self.ties.iter().find(move |t| t.faces[side] == face);
        let (of_a, of_b) = (beside(0, f), beside(1, g));
        let tied = [
            of_a.map_or(usize::MAX, |t| t.faces[1] as usize + self.planes.split),
            of_b.map_or(usize::MAX, |t| t.faces[0] as usize),
        ];
        let share = of_a.map_or(1.0, |t| 0.5 * (1.0 + t.offset))
            * of_b.map_or(1.0, |t| 0.5 * (1.0 - t.offset));
        (tied, share)
    }

    /// Whether a piece carries more than all before, which is noted.
    fn takes_the_lead(&mut self, weight: f64, piece: [u16; 2]) -> bool {
        // The first one leads even without any weight: the next walk has to start somewhere.
        let more = self.sums.hint.is_none() || weight > self.largest_weight;
        if more {
            self.largest_weight = weight;
            self.sums.hint = Some(piece);
        }
        more
    }

    /// Shows the piece that rubs: the largest one of the pair evaluated last.
    pub fn rubbing(&self, show: &mut dyn FnMut(&Polygon, &Frame)) {
        show(&self.largest, &self.largest_frame);
    }

    /// Negative stiffness along the surface of the pair evaluated last over the normal stiffness of its law, m², with the sums of the contact; 0
    /// where no springs are asked to hold it.
    pub fn falling(&mut self, law: &ContactLaw, sums: &Sums) -> f64 {
        let split = self.planes.split;
        let faces = |met: &[bool]| met.iter().filter(|met| **met).count();
        // Along the one face of a block that is touched nothing changes.
        if faces(&self.met[..split]) < 2 || faces(&self.met[split..]) < 2 {
            return 0.0;
        }
        // With the depth everything along the surface stiffens no more than across it.
        let grown = law.tangent(sums.depth);
        match law.least_falling() {
            Some(least) if lateral::is_narrow(sums, least / grown) => {
                grown * lateral::falls(&self.rate(), sums.force)
            }
            Some(_) | None => 0.0,
        }
    }

    /// Rate of the integral of depth times normal with the displacement of the second block, m².
    pub(super) fn rate(&mut self) -> Mat3 {
        let mut rate = Mat3::ZERO;
        let count = self.pieces.len();
        let mut batch = self.batch.take().unwrap_or_default();
        let polygon = &mut batch.polygons[0];
        for k in 0..count {
            let piece = self.pieces[k];
            let numbers = self.numbers(piece);
            if let Some(frame) = Frame::between(&self.planes, numbers[0], numbers[1], self.reach)
                && let Some(share) = self.make(&frame, piece, polygon)
            {
                rate += lateral::rate(&self.planes, &frame, polygon, numbers) * share;
            }
        }
        self.batch = Some(batch);
        // Those that were made again.
        self.pieces.truncate(count);
        rate
    }

    pub(super) fn queue_neighbours(&mut self, [f, g]: [u16; 2], polygon: &Polygon) {
        let split = self.planes.split as u16;
        for &label in polygon.label() {
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
            // A tied face does not cut: no edge has its label, and the strip beyond it has to be named.
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
        let face = body.shape.outline(pair.faces[side][place] as usize);
        let (planes, clip, width) = (&self.planes, &mut self.clip, self.cutter.width());
        let witness = pair.witnesses.get(k);
        if let Some(witness) = witness {
            let guess = others.start + usize::from(witness.load(Ordering::Relaxed));
            if guess < others.end && is_beyond(planes, guess, body, shift, face) {
                return false;
            }
        }
        let first = others.start;
        let beyond = width.run(
            #[inline(always)]
            || cut_face(planes, others, body, shift, face, clip),
        );
        if let Some(plane) = beyond {
            if let (Some(witness), Ok(place)) = (witness, u8::try_from(plane - first)) {
                witness.store(place, Ordering::Relaxed);
            }
            return false;
        }
        // A face that is tied to one of the other block counts on either side of it.
        let slack = if pair.ties { TIE_BAND * self.radius } else { 0.0 } + 2.0 * self.inflation;
        self.clip.is_left(slack)
    }
}
