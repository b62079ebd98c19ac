//! The source's mutual penetration potentials on boundary pieces.
//!
//! Potentials are zero at crossings of the boundaries, the depth below the other block's *local*
//! edges at own corners and (where both ends are crossings) at the middle of the piece, and linear
//! between. That holds the source's four contact types and everything between them. Local edges of
//! a block are those with a piece in the region or that cut a piece of the other block: with the
//! first set alone round-off on collinear faces drops the nearest edge and the force jumps.
//!
//! Source: mutual penetration potentials, claims 4 to 8 (S301 to S43).
//! Deviation: the vertex function is the smallest distance (the printed formula is lost).
//! Deviation: overlaps with other numbers of inside corners than the four types are covered.

use riprap_geom::Vec2;

use super::convex::Side;
use super::pieces::{Piece, nearest};
use super::setup::Reflex;

/// The parts of one piece with a linear potential: one, or two around its middle.
#[derive(Clone, Copy, Debug)]
pub struct Linear {
    /// Start, relative to the first block's centroid, m.
    pub p: Vec2,
    /// End.
    pub q: Vec2,
    /// Potential (depth) at the start, m.
    pub at_p: f64,
    /// Potential at the end, m.
    pub at_q: f64,
}

/// Marks the local edges of both blocks for region `region` in `local[0]` (first block) and
/// `local[1]`.
pub fn local_edges(pieces: &[Piece], region: u16, local: &mut [Vec<u16>; 2]) {
    for list in local.iter_mut() {
        list.clear();
    }
    for piece in pieces.iter().filter(|p| p.region == region) {
        let (own, other) = (usize::from(piece.second), usize::from(!piece.second));
        local[own].push(piece.edge);
        local[other].extend(piece.cut.iter().flatten());
    }
    for list in local.iter_mut() {
        list.sort_unstable();
        list.dedup();
    }
}

/// Splits `piece` into parts with linear potential; `other` is the block it is inside of, `shift`
/// brings a point from the first block's centroid to `other`'s.
pub fn parts(
    piece: &Piece,
    other: Side<'_>,
    local: &[u16],
    reflex: Reflex,
    shift: Vec2,
) -> ([Linear; 2], usize) {
    let value = |x: Vec2| depth(other, local, reflex, x + shift);
    let [p, q] = piece.ends;
    let end = |k: usize| {
        if piece.cut[k].is_some() {
            0.0
        } else {
            value(piece.ends[k])
        }
    };
    let whole = Linear {
        p,
        q,
        at_p: end(0),
        at_q: end(1),
    };
    if piece.cut[0].is_some() && piece.cut[1].is_some() {
        let middle = 0.5 * (p + q);
        let at = value(middle);
        return (
            [
                Linear {
                    p,
                    q: middle,
                    at_p: 0.0,
                    at_q: at,
                },
                Linear {
                    p: middle,
                    q,
                    at_p: at,
                    at_q: 0.0,
                },
            ],
            2,
        );
    }
    ([whole, whole], 1)
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
    if least.is_finite() {
        least
    } else {
        nearest(block, x).depth.max(0.0)
    }
}
