//! Exact energies, for the ledger at recording times.
//!
//! The distance potential stores `kn/2 int (phi_i + phi_j) dA` over the overlap. The overlap need
//! not be built: its boundary pieces, joined to closed outlines, span signed triangles with any
//! common apex, and the integral over those triangles is the integral over the overlap. In a convex
//! block the depth is the smallest of the depths below its lines, so each triangle is cut into the
//! parts nearest to each line and integrated exactly; in a concave block chords are integrated exactly
//! and summed across the region to a relative 1e-11.

use riprap_geom::Vec2;

use super::convex::Side;
use super::depths;
use super::pieces::{self, Piece};

/// `int (phi_i + phi_j) dA` over the overlap of two blocks, m³; `shift` is the centroid of i minus
/// that of j.
#[must_use]
pub(crate) fn overlap_potential(i: Side<'_>, j: Side<'_>, shift: Vec2, convex: [bool; 2]) -> f64 {
    let (mut pieces, mut cuts) = (Vec::new(), Vec::new());
    pieces::find(i, j, shift, &mut pieces, &mut cuts);
    outlines(&pieces)
        .iter()
        .map(|own| {
            depth_integral(i, own, Vec2::ZERO, convex[0]) + depth_integral(j, own, shift, convex[1])
        })
        .sum()
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
                outline.push(Piece {
                    second: true,
                    ends,
                    ..Piece::default()
                });
            }
            at = to;
        }
        if !outline.is_empty() {
            found.push(outline);
        }
    }
    found
}

fn depth_integral(block: Side<'_>, pieces: &[Piece], shift: Vec2, convex: bool) -> f64 {
    if !convex {
        return scan_integral(block, pieces, shift);
    }
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
            } else {
                twice.signum() * lowest_line_integral(block, &triangle)
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

/// Integral of the depth below any boundary over one region: chords along the contact, each exact
/// ([`depths::along`]), summed across it by halving until two rules agree.
fn scan_integral(block: Side<'_>, pieces: &[Piece], shift: Vec2) -> f64 {
    let chord: Vec2 = pieces
        .iter()
        .filter(|p| !p.second)
        .map(|p| p.ends[1] - p.ends[0])
        .sum();
    let along = chord.try_normalize().unwrap_or(Vec2::X);
    let across = along.perp();
    let mut levels: Vec<f64> = pieces
        .iter()
        .flat_map(|p| p.ends)
        .map(|x| across.dot(x + shift))
        .collect();
    levels.sort_by(f64::total_cmp);
    let (mut crossings, mut kinks) = (Vec::new(), Vec::new());
    // The nearest feature changes within a few depths of corners and crossings: extra levels there, so
    // that no rule steps over them.
    let deepest = pieces
        .iter()
        .map(|p| depths::along(block, p.ends[0] + shift, p.ends[1] + shift, &mut kinks).peak)
        .fold(0.0, f64::max);
    let (low, high) = (levels.first().copied(), levels.last().copied());
    let (low, high) = (low.unwrap_or(0.0), high.unwrap_or(0.0));
    for k in 0..levels.len() {
        for reach in [1.0, 3.0] {
            for v in [levels[k] - reach * deepest, levels[k] + reach * deepest] {
                if v > low && v < high {
                    levels.push(v);
                }
            }
        }
    }
    levels.sort_by(f64::total_cmp);
    levels.dedup();
    let mut chord_integral = |v: f64| {
        crossings.clear();
        for piece in pieces {
            let [p, q] = piece.ends.map(|x| x + shift);
            let (a, b) = (across.dot(p) - v, across.dot(q) - v);
            if (a > 0.0) != (b > 0.0) {
                crossings.push(along.dot(p) + a / (a - b) * along.dot(q - p));
            }
        }
        crossings.sort_by(f64::total_cmp);
        crossings
            .as_chunks::<2>()
            .0
            .iter()
            .map(|[from, to]| {
                let at = |u: f64| u * along + v * across;
                (to - from) * depths::along(block, at(*from), at(*to), &mut kinks).integral
            })
            .sum::<f64>()
    };
    let scale = deepest * (high - low) * (chord.length() + high - low);
    // Where a chord meets a boundary is known to the round-off of the coordinates, not of the height:
    // asking a thin overlap for more would halve without end.
    let size = pieces
        .iter()
        .flat_map(|p| p.ends)
        .map(|x| x.length().max((x + shift).length()))
        .fold(0.0, f64::max);
    let tolerance = scale * (64.0 * f64::EPSILON * size / (high - low)).max(1e-11);
    levels
        .windows(2)
        .map(|w| {
            let mut budget = MOST_HALVINGS;
            halving(&mut chord_integral, w[0], w[1], tolerance, 0, &mut budget)
        })
        .sum()
}

/// Halvings between two levels after which the sum is taken as it is.
const MOST_HALVINGS: u32 = 200;

/// Integral of `f` from `a` to `b` by the three-point Gauss rule, halving until two levels agree or
/// the budget is spent.
fn halving(
    f: &mut impl FnMut(f64) -> f64,
    a: f64,
    b: f64,
    tolerance: f64,
    level: u32,
    budget: &mut u32,
) -> f64 {
    let mut rule = |a: f64, b: f64| {
        let (middle, half) = (0.5 * (a + b), 0.5 * (b - a));
        let reach = half * 0.774_596_669_241_483_4;
        half * (5.0 * (f(middle - reach) + f(middle + reach)) + 8.0 * f(middle)) / 9.0
    };
    let middle = 0.5 * (a + b);
    let (whole, parts) = (rule(a, b), rule(a, middle) + rule(middle, b));
    // The first level always looks at both halves: a kink may hide from one look.
    let agreed = level > 0 && (whole - parts).abs() <= tolerance;
    if level >= 24 || agreed || *budget == 0 {
        return parts;
    }
    *budget -= 1;
    halving(f, a, middle, 0.5 * tolerance, level + 1, budget)
        + halving(f, middle, b, 0.5 * tolerance, level + 1, budget)
}
