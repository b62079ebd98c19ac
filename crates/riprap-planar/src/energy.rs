//! Exact energies, for the ledger at recording times.
//!
//! The distance potential stores `kn/2 int (phi_i + phi_j) dA` over the overlap. The overlap need
//! not be built. Of two convex blocks its boundary pieces, joined to closed outlines, span signed triangles with any
//! common apex, and the integral over those triangles is the integral over the overlap; the depth is the smallest
//! of the depths below the lines of a block, so each triangle is cut into the parts nearest to each line and
//! integrated exactly. Concave blocks may coincide along many sides, where such outlines cannot be told from
//! round-off: their integrals are sums over strips ([`strips`]).

use riprap_geom::Vec2;

use super::convex::Side;
use super::pieces::{self, Piece};
use super::strips;

/// `int (phi_i + phi_j) dA` over the overlap of two blocks, m³; `shift` is the centroid of i minus
/// that of j.
#[must_use]
pub(crate) fn overlap_potential(i: Side<'_>, j: Side<'_>, shift: Vec2, convex: [bool; 2]) -> f64 {
    let (mut pieces, mut cuts) = (Vec::new(), Vec::new());
    pieces::find(i, j, shift, &mut pieces, &mut cuts);
    if convex == [true; 2] {
        let overlap = outlines(&pieces);
        let both =
            |own: &Vec<Piece>| depth_integral(i, own, Vec2::ZERO) + depth_integral(j, own, shift);
        return overlap.iter().map(both).sum();
    }
    strips::depth_integral([i, j], false, shift, &pieces)
        + strips::depth_integral([i, j], true, shift, &pieces)
}

/// The pieces joined into closed outlines, each to the nearest that begins where it ends: a piece
/// of either boundary inside the other block runs anticlockwise around the overlap. Gaps are
/// bridged by pieces of their own.
///
/// Where edges of the two blocks lie on one line, round-off decides whether the short pieces at
/// the ends of a contact are found. They carry no force, but the outline has to be closed all the
/// same: with a gap half of the overlap may be missing.
fn outlines(pieces: &[Piece]) -> Vec<Vec<Piece>> {
    let mut gaps: Vec<(f64, usize, usize)> = Vec::new();
    for (from, a) in pieces.iter().enumerate() {
        for (to, b) in pieces.iter().enumerate() {
            gaps.push(((b.ends[0] - a.ends[1]).length_squared(), from, to));
        }
    }
    gaps.sort_by(|a, b| a.0.total_cmp(&b.0).then((a.1, a.2).cmp(&(b.1, b.2))));
    let mut next = vec![None; pieces.len()];
    let mut taken = vec![false; pieces.len()];
    for (_, from, to) in gaps {
        if next[from].is_none() && !taken[to] {
            next[from] = Some(to);
            taken[to] = true;
        }
    }
    let mut found = Vec::new();
    for start in 0..pieces.len() {
        let mut outline = Vec::new();
        let mut at = start;
        while let Some(to) = next[at].take() {
            outline.push(pieces[at]);
            let ends = [pieces[at].ends[1], pieces[to].ends[0]];
            if ends[0] != ends[1] {
                outline.push(Piece { second: true, ends, ..Piece::default() });
            }
            at = to;
        }
        if !outline.is_empty() {
            found.push(outline);
        }
    }
    found
}

/// Integral of the depth below the boundary of a convex block over one outline.
fn depth_integral(block: Side<'_>, pieces: &[Piece], shift: Vec2) -> f64 {
    let Some(first) = pieces.first() else {
        return 0.0;
    };
    let apex = first.ends[0] + shift;
    pieces
        .iter()
        .map(|piece| {
            let triangle = [apex, piece.ends[0] + shift, piece.ends[1] + shift];
            let twice = (triangle[1] - apex).perp_dot(triangle[2] - apex);
            if twice == 0.0 { 0.0 } else { twice.signum() * lowest_line_integral(block, &triangle) }
        })
        .sum()
}

/// Integral of the smallest depth below the listed lines over a triangle of either orientation.
fn lowest_line_integral(block: Side<'_>, triangle: &[Vec2; 3]) -> f64 {
    let depth =
        |m: u16, x: Vec2| block.turned[m as usize].normal.dot(block.turned[m as usize].start - x);
    let mut sum = 0.0;
    for (rank, &m) in block.nearest.iter().enumerate() {
        let mut part = triangle.to_vec();
        for (other, &o) in block.nearest.iter().enumerate() {
            if o == m {
                continue;
            }
            // Equal lines (collinear edges): the first of the list has it all.
            let equal = triangle.iter().all(|&x| depth(o, x) == depth(m, x));
            if equal && other < rank {
                part.clear();
            } else {
                part = clip(&part, |x| depth(o, x) - depth(m, x));
            }
            if part.len() < 3 {
                break;
            }
        }
        for k in 1..part.len().saturating_sub(1) {
            let (a, b, c) = (part[0], part[k], part[k + 1]);
            let area = 0.5 * (b - a).perp_dot(c - a).abs();
            sum += area * (depth(m, a) + depth(m, b) + depth(m, c)) / 3.0;
        }
    }
    sum
}

fn clip(polygon: &[Vec2], keep: impl Fn(Vec2) -> f64) -> Vec<Vec2> {
    let mut out = Vec::with_capacity(polygon.len() + 1);
    for k in 0..polygon.len() {
        let (p, q) = (polygon[k], polygon[(k + 1) % polygon.len()]);
        let (a, b) = (keep(p), keep(q));
        if a >= 0.0 {
            out.push(p);
        }
        if (a > 0.0 && b < 0.0) || (a < 0.0 && b > 0.0) {
            out.push(p + a / (a - b) * (q - p));
        }
    }
    out
}
