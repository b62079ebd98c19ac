//! The source's mutual penetration potentials on boundary pieces.
//!
//! Potentials are zero at crossings of the boundaries, the depth below the other block's *local*
//! edges at own corners and at the middle of a piece, and linear between. Local edges of a block are
//! those with a piece in the region or that cut a piece of the other block.
//!
//! The source has four contact types (claims 4 to 7); in these the middle counts only between two
//! crossings. In any other region it counts on every piece: a corner that is hardly inside then takes
//! nothing from the rest of its edge.
//!
//! **Faces.** Two corners, one of each block, whose edges run nearly parallel are no corner on corner
//! but the ends of faces that press (claim 2), and their middles count too. On a straight line from a
//! crossing to a corner the force would jump by a half when that corner lifts off, at a place that does
//! not move with it: such a contact feeds a vibration. With the middle, the force is continuous and its
//! stiffness against sinking and tilting is symmetric, and so is that of faces whose ends pass each other.
//!
//! A corner without an angle is none: pieces that meet in it are one ([`super::pieces::straighten`]).
//!
//! **Flush places.** Where sides of the two blocks lie on one line, or cross so gently that round-off or
//! a hundredth of the overlap decides which corner is inside, the corners of both blocks are one
//! place: each has half its depth below the faces that press, whoever is inside. This is the mean of the two
//! arrangements on either side, so the pressure has no moment of its own.
//!
//! Source: mutual penetration potentials, claims 4 to 8 (S301 to S43).
//! Deviation: the vertex function is the smallest distance (the printed formula is lost).
//! Deviation: overlaps with other numbers of inside corners than the four types are covered.
//! Deviation: the middle counts on faces that have one corner of each block between them.
//! Deviation: flush places, where the source's depths jump between zero and full with round-off.

use riprap_geom::Vec2;

use super::convex::Side;
use super::pieces::{Piece, TOUCH, first_of_side, nearest};
use super::setup::Reflex;

/// Cosine of [`super::classify::PARALLEL`]: sides that look the same way, faces that look at each other.
const ALIGNED: f64 = 0.999_847_695_156_391_3;

/// The parts of one piece with a linear potential: one, or two around its middle.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Linear {
    /// Start, relative to the first block's centroid, m.
    pub p: Vec2,
    /// End.
    pub q: Vec2,
    /// Potential (depth) at the start, m.
    pub at_p: f64,
    /// Potential at the end, m.
    pub at_q: f64,
}

/// What the potentials of one region rest on.
#[derive(Clone, Debug, Default)]
pub(crate) struct Local {
    /// Local edges of the first and of the second block, ascending.
    edges: [Vec<u16>; 2],
    /// Corners of each block inside the other (scratch).
    corners: [Vec<u16>; 2],
    /// Whether this is one of the source's four contact types.
    literal: bool,
}

impl Local {
    /// Looks at the pieces of region `number` between blocks i and j; `shift` is the centroid of i minus
    /// that of j, m.
    pub(crate) fn look(
        &mut self,
        pieces: &[Piece],
        number: u16,
        i: Side<'_>,
        j: Side<'_>,
        shift: Vec2,
    ) {
        for list in self.edges.iter_mut().chain(&mut self.corners) {
            list.clear();
        }
        let mut flush = false;
        for piece in pieces.iter().filter(|p| p.region == number) {
            let (own, other) = (usize::from(piece.second), usize::from(!piece.second));
            let ((block, against), shift) =
                if piece.second { ((j, i), -shift) } else { ((i, j), shift) };
            self.edges[own].push(first_of_side(block, piece.edge));
            let cuts = piece.cut.iter().flatten();
            self.edges[other].extend(cuts.map(|&edge| first_of_side(against, edge)));
            let edges = block.turned.len();
            if piece.depth <= TOUCH * block.turned[piece.edge as usize].length {
                // No deeper than round-off, which also decides whether the edge below has a piece.
                self.edges[other].push(first_of_side(against, piece.facing));
            }
            for end in 0..2 {
                if piece.cut[end].is_none() {
                    let corner = [piece.edge as usize, piece.last as usize + 1][end];
                    self.corners[own].push((corner % edges) as u16);
                }
                flush |= flush_edge(piece, end, block, against, shift).is_some();
            }
        }
        for list in self.edges.iter_mut().chain(&mut self.corners) {
            list.sort_unstable();
            list.dedup();
        }
        // Own corners inside, local edges: per type and block. One corner lies between two edges, two
        // between three; the crossings lie on the edges at the other block's corner, or on one edge.
        let seen = [0, 1].map(|k| (self.corners[k].len(), self.edges[k].len()));
        self.literal = !flush
            && match seen {
                [(1, 2), (1, 2)] => !self.faces(i, j),
                [(1, 2) | (2, 3), (0, 1)] | [(0, 1), (1, 2) | (2, 3)] => true,
                _ => false,
            };
    }

    /// Whether local edges of both blocks look at each other within one degree.
    fn faces(&self, i: Side<'_>, j: Side<'_>) -> bool {
        let normal = |block: Side<'_>, edge: u16| block.turned[usize::from(edge)].normal;
        self.edges[0].iter().any(|&e| {
            let facing = |&f: &u16| normal(i, e).dot(normal(j, f)) < -ALIGNED;
            self.edges[1].iter().any(facing)
        })
    }

    /// Splits `piece` of `own` into parts with linear potential; `other` is the block it is inside of,
    /// `shift` the centroid of `own` minus that of `other`, m.
    #[must_use]
    pub(crate) fn parts(
        &self,
        piece: &Piece,
        own: Side<'_>,
        other: Side<'_>,
        reflex: Reflex,
        shift: Vec2,
    ) -> ([Linear; 2], usize) {
        let local = &self.edges[usize::from(!piece.second)];
        // Points of pieces are given from the first block's centroid.
        let to_other = if piece.second { Vec2::ZERO } else { shift };
        let [p, q] = piece.ends;
        let end = |k: usize| {
            let x = piece.ends[k] + to_other;
            if let Some(along) = flush_edge(piece, k, own, other, shift) {
                return 0.5 * below_others(other, local, first_of_side(other, along), x);
            }
            if piece.cut[k].is_some() { 0.0 } else { depth(other, local, reflex, x) }
        };
        let (at_p, at_q) = (end(0), end(1));
        let crossings = piece.cut[0].is_some() && piece.cut[1].is_some();
        if self.literal && !crossings {
            return ([Linear { p, q, at_p, at_q }; 2], 1);
        }
        let middle = 0.5 * (p + q);
        let below = depth(other, local, reflex, middle + to_other);
        // Between two crossings the depth itself; where a corner ends the piece, no less than on a straight line.
        let at = below.max(0.5 * (at_p + at_q));
        let first = Linear { p, q: middle, at_p, at_q: at };
        let second = Linear { p: middle, q, at_p: at, at_q };
        ([first, second], 2)
    }
}

/// The edge of `other` on one line with the side of `own` that goes on from `piece` at its start
/// (`end` 0) or end (1), if the place is flush: the sides look the same way within one degree, lie beside
/// each other, and cross there or touch. `shift` is the centroid of `own` minus that of `other`, m.
fn flush_edge(
    piece: &Piece,
    end: usize,
    own: Side<'_>,
    other: Side<'_>,
    shift: Vec2,
) -> Option<u16> {
    let n = own.turned.len();
    let [first, next] = [piece.edge as usize, (piece.last as usize + 1) % n];
    let (side, corner) = if end == 0 { ((first + n - 1) % n, first) } else { (next, next) };
    let side = &own.turned[side];
    let corner = own.turned[corner].start + shift;
    other.nearest.iter().copied().find(|&g| {
        let line = &other.turned[g as usize];
        if line.normal.dot(side.normal) < ALIGNED || piece.cut[end].is_some_and(|cut| cut != g) {
            return false;
        }
        let along = line.normal.perp().dot(corner - line.start);
        let next = (g as usize + 1) % other.turned.len();
        // The other block's corner at this place, and how far beyond it the own one is.
        let (mate, beyond) = if end == 0 {
            (line.start, along)
        } else {
            (other.turned[next].start, line.length - along)
        };
        if beyond <= 0.0 || beyond >= line.length.min(side.length) {
            return false;
        }
        let touch = TOUCH * line.length.min(side.length);
        let inside = line.normal.dot(line.start - corner);
        let mate_inside = side.normal.dot(corner - mate);
        inside.abs() <= touch || mate_inside.abs() <= touch || inside * mate_inside > 0.0
    })
}

/// Smallest distance of `x` (relative to `block`'s centroid) to the local edge lines but one; 0 without any.
fn below_others(block: Side<'_>, local: &[u16], but: u16, x: Vec2) -> f64 {
    let least = local
        .iter()
        .filter(|&&m| m != but)
        .map(|&m| {
            let line = &block.turned[m as usize];
            line.normal.dot(line.start - x).abs()
        })
        .fold(f64::INFINITY, f64::min);
    if least.is_finite() { least } else { 0.0 }
}

/// Potential at `x` (relative to `block`'s centroid): the smallest distance to the local edge lines,
/// with the chosen reading at reflex corners.
fn depth(block: Side<'_>, local: &[u16], reflex: Reflex, x: Vec2) -> f64 {
    if reflex == Reflex::True {
        return nearest(block, x).depth.max(0.0);
    }
    let n = block.turned.len();
    let line = |m: usize| (block.turned[m].normal.dot(block.turned[m].start - x)).abs();
    let has = |m: usize| local.binary_search(&(m as u16)).is_ok();
    let mut least = f64::INFINITY;
    for &m in local {
        let m = m as usize;
        let mut d = line(m);
        if reflex == Reflex::Max {
            let (before, after) = ((m + n - 1) % n, (m + 1) % n);
            if block.turned[m].reflex && has(before) {
                d = d.max(line(before));
            }
            if block.turned[after].reflex && has(after) {
                d = d.max(line(after));
            }
        }
        least = least.min(d);
    }
    if least.is_finite() { least } else { nearest(block, x).depth.max(0.0) }
}
