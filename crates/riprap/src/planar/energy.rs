//! Exact energies, for the ledger at recording times.
//!
//! The distance potential stores `kn/2 int (phi_i + phi_j) dA` over the overlap. The overlap need
//! not be built: its boundary pieces, taken anticlockwise around it, span signed triangles with any
//! common apex, and the integral over those triangles is the integral over the overlap. In a convex
//! block the depth is the smallest of the depths below its lines, so each triangle is cut into the
//! parts nearest to each line and integrated exactly; near concave blocks triangles are halved until
//! the rule agrees with itself.

use riprap_geom::Vec2;

use super::convex::Side;
use super::pieces::{self, Piece, nearest};

/// `int (phi_i + phi_j) dA` over the overlap of two blocks, m³; `shift` is the centroid of i minus
/// that of j.
#[must_use]
pub fn overlap_potential(i: Side<'_>, j: Side<'_>, shift: Vec2, convex: [bool; 2]) -> f64 {
    let (mut pieces, mut cuts) = (Vec::new(), Vec::new());
    pieces::find(i, j, shift, &mut pieces, &mut cuts);
    // A piece of either boundary inside the other block runs anticlockwise around the overlap.
    depth_integral(i, &pieces, Vec2::ZERO, convex[0]) + depth_integral(j, &pieces, shift, convex[1])
}

fn depth_integral(block: Side<'_>, pieces: &[Piece], shift: Vec2, convex: bool) -> f64 {
    let Some(first) = pieces.first() else {
        return 0.0;
    };
    let apex = first.ends[0] + shift;
    pieces
        .iter()
        .map(|piece| {
            let triangle = [apex, piece.ends[0] + shift, piece.ends[1] + shift];
            let twice = (triangle[1] - apex).perp_dot(triangle[2] - apex);
            if twice == 0.0 {
                0.0
            } else if convex {
                twice.signum() * lowest_line_integral(block, &triangle)
            } else {
                0.5 * twice * mean_depth(block, &triangle, 0)
            }
        })
        .sum()
}

/// Integral of the smallest depth below the listed lines over a triangle of either orientation.
fn lowest_line_integral(block: Side<'_>, triangle: &[Vec2; 3]) -> f64 {
    let depth = |m: u16, x: Vec2| {
        block.turned[m as usize]
            .normal
            .dot(block.turned[m as usize].start - x)
    };
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

/// Mean of the signed depth over a triangle, by halving until the rule agrees with itself.
fn mean_depth(block: Side<'_>, t: &[Vec2; 3], level: u32) -> f64 {
    let at = |x: Vec2| nearest(block, x).depth;
    let mids = [
        0.5 * (t[0] + t[1]),
        0.5 * (t[1] + t[2]),
        0.5 * (t[2] + t[0]),
    ];
    let inner = [
        [t[0], mids[0], mids[2]],
        [mids[0], t[1], mids[1]],
        [mids[2], mids[1], t[2]],
        [mids[1], mids[2], mids[0]],
    ];
    let rule = |t: &[Vec2; 3]| {
        // Three points, exact for quadratics.
        let c = (t[0] + t[1] + t[2]) / 6.0;
        (at(c + 0.5 * t[0]) + at(c + 0.5 * t[1]) + at(c + 0.5 * t[2])) / 3.0
    };
    let fine = inner.iter().map(rule).sum::<f64>() / 4.0;
    let size = (t[1] - t[0]).length().max((t[2] - t[0]).length());
    if level >= 9 || (fine - rule(t)).abs() <= 1e-9 * size {
        return fine;
    }
    inner
        .iter()
        .map(|part| mean_depth(block, part, level + 1))
        .sum::<f64>()
        / 4.0
}
