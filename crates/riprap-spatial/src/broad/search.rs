//! Which pairs of blocks can touch, and with which of their faces: the candidate list.
//!
//! The list is a function of [`Search`] alone (poses and margins at the last rebuild), so that it can be dropped and made
//! again at any time. It holds while no point of any block has moved by more than the block's margin. Then
//!
//! - a pair whose distance was more than the sum `m` of its two margins cannot touch: it is no candidate;
//! - a face that lay wholly beyond a plane of the other block by more than `m` cannot touch the overlap: a point of it
//!   that is in the other block now was within `m` of the same point of that block then. Such a face is left out. The
//!   ball about a point of the overlap that reaches to the nearest plane lies in the overlap and touches that plane there,
//!   so a face that does not touch the overlap is nearest nowhere in it, and leaving it out changes no depth. Provided
//!   that **all** listed faces cut: faces that are no neighbours in the whole block can be neighbours once the one
//!   between them is left out.
//!
//! This says nothing of blocks that are apart: their listed planes alone can have a point in common far away from both.
//! Whether two blocks touch is asked of all their planes ([`crate::kernel::peak::peak()`]).

use riprap_geom::Vec3;
use serde::{Deserialize, Serialize};

use crate::broad::covered::{Covered, has};
use crate::broad::images::Images;
use crate::exec::{CHUNK, Exec};
use crate::kernel::grid::{Box3, Grid, Role};
use crate::kernel::image::{Image, PairKey, Periods};
use crate::kernel::peak::{Peak, peak};
use crate::kernel::planes;
use crate::kernel::planes::Planes;
use crate::kernel::shape::{Body, Pose, Shape, turn};
use crate::kernel::surface::Witness;

/// Margin of a block over its size (the smaller of its radius and twice the median radius).
const MARGIN: f64 = 0.04;
/// Margin of the fastest blocks over their size.
const FAST_MARGIN: f64 = 0.4;
/// Faces are left out beyond this times the sum of the margins: more than 1, so that blocks that have just parted are
/// still judged rightly by the faces listed.
const REACH: f64 = 1.5;
/// Faces that are parallel within this (difference of the normals) at least are looked at for ties.
const PARALLEL: f64 = 1e-2;

/// Blocks as the search sees them.
#[derive(Clone, Copy, Debug)]
pub struct Blocks<'a> {
    /// Shapes, shared by equal blocks.
    pub shapes: &'a [Shape],
    /// Index into `shapes`, per block.
    pub shape: &'a [u32],
    /// Who can meet whom, per block.
    pub roles: &'a [Role],
    /// Faces that other blocks in place cover: they are not listed.
    pub covered: &'a Covered,
}

impl<'a> Blocks<'a> {
    /// Shape of block `b`.
    #[must_use]
    pub fn shape(&self, b: usize) -> &'a Shape {
        &self.shapes[self.shape[b] as usize]
    }
}

/// What the candidate list is made of; state, kept in checkpoints.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Search {
    /// Poses at the last rebuild.
    pub pose: Vec<Pose>,
    /// How far a point of each block may move until the next rebuild, m.
    pub margin: Vec<f64>,
}

impl Search {
    /// Takes over the present poses. `speed` bounds the speed of the points of a block (m/s); the margin of a block grows
    /// with the way that it will go in `lookahead` (s), within bounds, so that one fast block does not force all others to
    /// be looked at anew every few steps.
    pub fn renew(
        &mut self,
        blocks: &Blocks,
        pose: impl Fn(usize) -> Pose,
        speed: impl Fn(usize) -> f64,
        lookahead: f64,
    ) {
        self.take(blocks.roles, |b| blocks.shape(b).radius, pose, |b| speed(b) * lookahead);
    }

    /// The same for blocks of these radii (m); `way` is how far a block is expected to move, m.
    pub fn take(
        &mut self,
        roles: &[Role],
        radius: impl Fn(usize) -> f64,
        pose: impl Fn(usize) -> Pose,
        way: impl Fn(usize) -> f64,
    ) {
        let count = roles.len();
        let there = |b: &usize| roles[*b] != Role::Absent;
        let mut radii: Vec<f64> = (0..count).filter(there).map(&radius).collect();
        let middle = radii.len() / 2;
        let median = if radii.is_empty() {
            0.0
        } else {
            *radii.select_nth_unstable_by(middle, f64::total_cmp).1
        };
        self.pose.clear();
        self.pose.extend((0..count).map(pose));
        self.margin.clear();
        self.margin.extend((0..count).map(|b| {
            // One block much larger than all others must not get a margin that takes in many of them.
            let size = radius(b).min(2.0 * median);
            way(b).min(FAST_MARGIN * size).max(MARGIN * size)
        }));
    }

    /// Whether block `b` at `pose` will have left its margin when it has gone the way `next` (m) further.
    #[must_use]
    pub fn leaves(&self, b: usize, radius: f64, pose: &Pose, next: f64) -> bool {
        self.is_beyond(b, path_bound(&self.pose[b], pose, radius) + next)
    }

    /// Whether a way (m) is more than the margin of block `b`.
    #[must_use]
    pub fn is_beyond(&self, b: usize, way: f64) -> bool {
        way > self.margin[b] || way.is_nan()
    }
}

/// Bound of the way between two poses for the points of a block of this radius (m), m.
///
/// A turn by the angle a changes the quaternion by 2 sin(a/4) and moves a point at the radius by 2 R sin(a/2).
#[must_use]
pub(crate) fn path_bound(from: &Pose, to: &Pose, radius: f64) -> f64 {
    let turned = (to.rotation - from.rotation)
        .length_squared()
        .min((to.rotation + from.rotation).length_squared());
    (to.position - from.position).length() + 2.0 * turned.sqrt() * radius
}

/// A pair that can touch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Candidate {
    /// The blocks; the smaller number first.
    pub ends: [u32; 2],
    /// Which image of the second one.
    image: Image,
    /// Numbers of listed faces of both.
    counts: [u16; 2],
    start: u32,
    /// Whether a face of one can become coplanar with one of the other that looks the same way.
    pub ties: bool,
    /// Bound of the area that the contact can have before the list is made anew, across its normal, m².
    pub area: f64,
}

impl Candidate {
    /// The pair among all.
    #[must_use]
    pub fn key(&self) -> PairKey {
        PairKey { ends: self.ends, image: self.image }
    }

    /// The faces of `i` and of `j` that can take part, ascending.
    #[must_use]
    pub fn faces<'a>(&self, lists: &'a [u16]) -> [&'a [u16]; 2] {
        let [m, n] = self.counts.map(usize::from);
        let (of_i, rest) = lists[self.start as usize..].split_at(m);
        [of_i, &rest[..n]]
    }

    /// What is kept beside these faces.
    #[must_use]
    pub fn witnesses<'a>(&self, witnesses: &'a [Witness]) -> &'a [Witness] {
        let [m, n] = self.counts.map(usize::from);
        let start = self.start as usize;
        &witnesses[start..start + m + n]
    }
}

/// The candidate list; scratch that keeps its room.
#[derive(Debug, Default)]
pub struct Candidates {
    /// Pairs that can touch, sorted.
    pub pairs: Vec<Candidate>,
    /// Faces of all pairs.
    pub lists: Vec<u16>,
    /// Guesses for each of them ([`Pair::witnesses`](crate::kernel::Pair::witnesses)).
    pub witnesses: Vec<Witness>,
    /// Pairs that would be candidates by their boxes, but are held; sorted.
    pub held: Vec<PairKey>,
    /// The smallest inradius of each block and of those that it can touch, m.
    pub reach: Vec<f64>,
    grid: Grid,
    images: Images,
    boxes: Vec<Box3>,
    workspaces: Vec<Workspace>,
    outside: Vec<bool>,
}

impl Candidates {
    /// Makes the list from `search`. `excluded` rules pairs out, e.g. those that a living patch joins; `held` too, and they
    /// are remembered.
    pub fn rebuild(
        &mut self,
        blocks: &Blocks,
        search: &Search,
        periods: &Periods,
        excluded: impl Fn(&PairKey) -> bool + Sync,
        held: impl Fn(&PairKey) -> bool + Sync,
        exec: &Exec,
    ) {
        self.find_boxes(blocks, search, exec);
        let (boxes, grid) = (&self.boxes, &mut self.grid);
        let close: Vec<PairKey> = if *periods == [None; 3] {
            let out = |i: u32, j: u32| excluded(&PairKey::plain([i, j]));
            let close = grid.close_pairs(boxes, blocks.roles, out, exec);
            close.iter().map(|ends| PairKey::plain(*ends)).collect()
        } else {
            self.images.close_pairs(grid, boxes, blocks.roles, periods, excluded, exec)
        };
        let runs = close.len().div_ceil(CHUNK);
        if self.workspaces.len() < runs {
            self.workspaces.resize_with(runs, Workspace::default);
        }
        exec.ranges(close.len(), &mut self.workspaces, |range, workspace| {
            workspace.pairs.clear();
            workspace.lists.clear();
            workspace.held.clear();
            for pair in &close[range] {
                if held(pair) {
                    workspace.held.push(*pair);
                    continue;
                }
                workspace.add(blocks, search, periods, boxes, pair);
            }
        });
        let found = || self.workspaces[..runs].iter();
        renew(&mut self.pairs, found().map(|workspace| workspace.pairs.len()).sum());
        renew(&mut self.lists, found().map(|workspace| workspace.lists.len()).sum());
        self.held.clear();
        for workspace in &mut self.workspaces[..runs] {
            self.held.append(&mut workspace.held);
            let start = self.lists.len() as u32;
            // What has been taken over is not kept twice until the next time.
            let pairs = std::mem::take(&mut workspace.pairs);
            self.pairs.extend(
                pairs.into_iter().map(|pair| Candidate { start: start + pair.start, ..pair }),
            );
            self.lists.append(&mut std::mem::take(&mut workspace.lists));
        }
        // None yet: no list of planes is so long.
        renew(&mut self.witnesses, self.lists.len());
        self.witnesses.resize_with(self.lists.len(), || Witness::new(u8::MAX));
        self.reach.clear();
        self.reach.extend((0..blocks.roles.len()).map(|b| blocks.shape(b).inradius));
        for pair in &self.pairs {
            let ends = pair.ends.map(|b| b as usize);
            let reach = ends.map(|b| blocks.shape(b).inradius);
            for b in ends {
                self.reach[b] = self.reach[b].min(reach[0]).min(reach[1]);
            }
        }
    }

    /// Whether a block has left its margin or will in the coming step, so that poses must be taken over and the list made
    /// anew. `next` bounds the way of the points of a block in that step, m: so the list names whoever it may run into
    /// before it does.
    pub fn outdated(
        &mut self,
        blocks: &Blocks,
        search: &Search,
        pose: impl Fn(usize) -> Pose + Sync,
        next: impl Fn(usize) -> f64 + Sync,
        exec: &Exec,
    ) -> bool {
        let leaves = |b: usize| search.leaves(b, blocks.shape(b).radius, &pose(b), next(b));
        search.pose.len() != blocks.roles.len()
            || any_leaves(blocks.roles, &mut self.outside, leaves, exec)
    }

    /// The states of the pairs in `self`, in their order, from those of the last list (sorted by pair). Pairs that are new
    /// get `fresh`; states of pairs that are no longer here go to `lost`.
    pub fn carry<S>(
        &self,
        old: impl IntoIterator<Item = (PairKey, S)>,
        fresh: impl Fn(&Candidate) -> S,
        lost: impl FnMut(PairKey, S),
    ) -> Vec<S> {
        carry(&self.pairs, Candidate::key, old, fresh, lost)
    }

    /// Boxes of all blocks, grown by their margins.
    fn find_boxes(&mut self, blocks: &Blocks, search: &Search, exec: &Exec) {
        let count = blocks.roles.len();
        self.boxes.resize(count, Box3::EMPTY);
        exec.chunks(&mut self.boxes, |first, boxes| {
            for (b, grown) in (first..).zip(boxes) {
                *grown = match blocks.roles[b] {
                    Role::Absent => Box3::EMPTY,
                    Role::Passive | Role::Active => {
                        grown_box(blocks.shape(b), &search.pose[b], search.margin[b])
                    }
                };
            }
        });
    }
}

/// Whether any block that takes part leaves its margin; `outside` is room for the answers of the threads.
pub(crate) fn any_leaves(
    roles: &[Role],
    outside: &mut Vec<bool>,
    leaves: impl Fn(usize) -> bool + Sync,
    exec: &Exec,
) -> bool {
    outside.resize(roles.len().div_ceil(CHUNK), false);
    exec.ranges(roles.len(), outside, |mut range, outside| {
        *outside = range.any(|b| roles[b] != Role::Absent && leaves(b));
    });
    outside.contains(&true)
}

/// States of the pairs of a list from those of the last one, see [`Candidates::carry`]; both are sorted by pair.
pub(crate) fn carry<P, K: Ord, S>(
    pairs: &[P],
    key: impl Fn(&P) -> K,
    old: impl IntoIterator<Item = (K, S)>,
    fresh: impl Fn(&P) -> S,
    mut lost: impl FnMut(K, S),
) -> Vec<S> {
    // Both lists are in the order of their pairs: one walk through the two does it.
    let mut old = old.into_iter().peekable();
    let mut states = Vec::with_capacity(pairs.len());
    for pair in pairs {
        let key = key(pair);
        while let Some((gone, state)) = old.next_if(|(other, _)| *other < key) {
            lost(gone, state);
        }
        states.push(match old.next_if(|(other, _)| *other == key) {
            Some((_, state)) => state,
            None => fresh(pair),
        });
    }
    old.for_each(|(gone, state)| lost(gone, state));
    states
}

/// Empties a list and gives it room for so many.
fn renew<T>(list: &mut Vec<T>, count: usize) {
    list.clear();
    list.shrink_to(count);
    list.reserve_exact(count);
}

/// What two boxes have in common.
fn common(a: &Box3, b: &Box3) -> Option<Box3> {
    let (low, high) = (a.low.max(b.low), a.high.min(b.high));
    low.cmple(high).all().then_some(Box3 { low, high })
}

/// Largest area that something in a box can show to any direction, m².
fn section(common: &Box3) -> f64 {
    let size = common.high - common.low;
    Vec3::new(size.y * size.z, size.z * size.x, size.x * size.y).length()
}

/// Box of a block at a pose, grown by its margin.
fn grown_box(shape: &Shape, pose: &Pose, margin: f64) -> Box3 {
    let turn = riprap_geom::Mat3::from_quat(pose.rotation);
    let (mut low, mut high) = (Vec3::INFINITY, Vec3::NEG_INFINITY);
    for vertex in &shape.vertices {
        let at = turn * *vertex;
        low = low.min(at);
        high = high.max(at);
    }
    let grow = Vec3::splat(margin);
    Box3 { low: pose.position + (low - grow), high: pose.position + (high + grow) }
}

/// Workspace of a run of pairs, and what it found.
#[derive(Clone, Debug, Default)]
struct Workspace {
    normals: [Vec<Vec3>; 2],
    planes: Planes,
    /// Corners of each block about the origin of the pair, m.
    corners: [Vec<Vec3>; 2],
    /// How far each corner of a block is beyond each plane of the other, m; planes of the other, then corners.
    beyond: Vec<f64>,
    pairs: Vec<Candidate>,
    lists: Vec<u16>,
    held: Vec<PairKey>,
}

impl Workspace {
    /// Adds the pair if it can touch.
    fn add(
        &mut self,
        blocks: &Blocks,
        search: &Search,
        periods: &Periods,
        boxes: &[Box3],
        key: &PairKey,
    ) {
        let ends = key.ends.map(|b| b as usize);
        let margins = ends.map(|b| search.margin[b]);
        let gap = margins[0] + margins[1];
        let shapes = ends.map(|b| blocks.shape(b));
        let turns = [0, 1].map(|s: usize| {
            self.normals[s].clear();
            turn(shapes[s], search.pose[ends[s]].rotation, &mut self.normals[s])
        });
        let bodies = [0, 1].map(|s: usize| Body {
            shape: shapes[s],
            normals: &self.normals[s],
            turn: turns[s],
            position: key.place(s, search.pose[ends[s]].position, periods),
        });
        let origin = planes::origin(&bodies[0], &bodies[1]);
        self.planes.gather_all([&bodies[0], &bodies[1]], origin);
        for (body, corners) in bodies.iter().zip(&mut self.corners) {
            let shift = body.position - origin;
            corners.clear();
            corners.extend(body.shape.vertices.iter().map(|v| body.turn * *v + shift));
        }
        let far = 4.0 * (shapes[0].radius + shapes[1].radius);
        let axis = match peak(&self.planes, far) {
            // Both together can come nearer by no more than that before the list is made anew.
            Peak::Apart { gap: found, .. } if found > gap => return,
            Peak::Apart { axis, .. } => axis,
            Peak::Unsure => Vec3::ZERO,
            Peak::Overlap { start, .. } => start.map_or(Vec3::ZERO, |[f, g]| {
                let normal = |k: u16| self.planes.normal(usize::from(k));
                (normal(f) - normal(g)).normalize_or_zero()
            }),
        };
        let start = self.lists.len();
        let covered = blocks.covered.of_pair(key.ends);
        self.list(0, shapes[0], covered, REACH * gap);
        let middle = self.lists.len();
        self.list(1, shapes[1], covered, REACH * gap);
        let counts = [middle - start, self.lists.len() - middle].map(|n| n as u16);
        // No more than this can the blocks turn against each other before the next rebuild.
        let turning = margins[0] / shapes[0].radius + margins[1] / shapes[1].radius;
        let parallel = turning.max(PARALLEL);
        let (of_i, of_j) = self.lists[start..].split_at(middle - start);
        let ties = of_i.iter().any(|&f| {
            let n = self.normals[0][f as usize];
            let near = |&g: &u16| (self.normals[1][g as usize] - n).length_squared();
            of_j.iter().any(|g| near(g) < parallel * parallel)
        });
        // The area vector of the surface of equal pressure is that of the part of either block's surface that is inside the
        // other: no more than what the listed faces show to each other.
        let shown = |s: usize, faces: &[u16], axis: Vec3| -> f64 {
            let show = |&f: &u16| {
                let f = f as usize;
                shapes[s].areas[f] * self.normals[s][f].dot(axis).max(0.0)
            };
            faces.iter().map(show).sum()
        };
        let second = boxes[ends[1]];
        let second = match key.image {
            Image::SELF => second,
            image => second.moved(image.shift(periods)),
        };
        let within = common(&boxes[ends[0]], &second).map_or(0.0, |common| section(&common));
        let area = if axis == Vec3::ZERO {
            within
        } else {
            within.min(shown(0, of_i, axis)).min(shown(1, of_j, -axis))
        };
        self.pairs.push(Candidate {
            ends: key.ends,
            image: key.image,
            counts,
            start: start as u32,
            ties,
            area,
        });
    }

    /// Appends the faces of block `side` that no plane of the other block has wholly beyond it by more than `reach`. `covered`: faces of both that
    /// are none, and have nothing beyond them.
    fn list(&mut self, side: usize, shape: &Shape, covered: [u64; 2], reach: f64) {
        let planes = match side {
            0 => self.planes.split..self.planes.len(),
            _ => 0..self.planes.split,
        };
        let corners = &self.corners[side];
        self.beyond.clear();
        for (face, k) in planes.enumerate() {
            if has(covered[1 - side], face) {
                continue;
            }
            let (n, d) = (self.planes.normal(k), self.planes.d[k]);
            self.beyond.extend(corners.iter().map(|v| n.dot(*v) - d));
        }
        for face in (0..shape.faces()).filter(|face| !has(covered[side], *face)) {
            let outline = shape.outline(face);
            let wholly = |row: &[f64]| outline.iter().all(|&v| row[v as usize] > reach);
            if !self.beyond.chunks(corners.len()).any(wholly) {
                self.lists.push(face as u16);
            }
        }
    }
}

#[cfg(test)]
mod tests;
