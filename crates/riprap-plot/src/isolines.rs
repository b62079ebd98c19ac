//! Lines of equal value over the blocks of a picture.
//!
//! Values belong to blocks, lines need them everywhere: a corner has the mean of the blocks that it touches, the middle of a block its
//! own value, and between them it is linear over the triangles of middle and edges. So lines go on from block to block where blocks
//! touch, and end at gaps. Over powers of ten they are linear in the logarithm, as the colours are.

use std::collections::BTreeMap;

use super::drawing::middle;
use super::svg::{Anchor, Page, text_width};
use super::ticks::Scale;
use riprap_record::frame::Frame;

/// Corners that lie nearer to an outline than this share of the usual size of a block touch it.
const TOUCH: f64 = 0.02;
/// Blocks over more cells of the grid than this are compared with all corners.
const MANY_CELLS: f64 = 200.0;
/// Labels of one level, and the least distance between any two labels, pixels.
const LABELS: usize = 3;
const APART: f64 = 56.0;
const SIZE: f64 = 10.0;

/// A place, m, and the value there.
type Corner = ([f64; 2], f64);
/// Straight pieces of lines, two ends each.
type Pieces = Vec<[[f64; 2]; 2]>;

/// Draws about `count` lines at round values of the scale, with their numbers. `place` leads from metres to pixels.
pub(super) fn draw(
    page: &mut Page,
    frame: &Frame,
    values: &[f64],
    (scale, count): (&Scale, usize),
    place: &dyn Fn([f64; 2]) -> [f64; 2],
) {
    let shares: Vec<f64> = values.iter().map(|v| scale.share(*v)).collect();
    let corners = carried(frame, &shares);
    let mut labels: Vec<[f64; 2]> = Vec::new();
    let levels: Vec<(Pieces, String)> = scale
        .ticks(count)
        .into_iter()
        .map(|(value, text)| (pieces(frame, &shares, &corners, scale.share(value)), text))
        .collect();
    let drawn = |pieces: &Pieces| -> Pieces { pieces.iter().map(|p| p.map(place)).collect() };
    for (line, _) in &levels {
        // A light rim keeps a dark line to be seen on dark blocks.
        for style in [
            "fill=\"none\" stroke=\"#ffffff\" stroke-width=\"2.6\" stroke-opacity=\"0.75\" stroke-linecap=\"round\"",
            "fill=\"none\" stroke=\"#1a1a1a\" stroke-width=\"1.1\" stroke-linecap=\"round\"",
        ] {
            page.pieces(&drawn(line), style);
        }
    }
    for (line, text) in &levels {
        label(page, &drawn(line), text, &mut labels);
    }
}

fn median_size(boxes: &[[f64; 4]]) -> Option<f64> {
    let sizes = boxes.iter().map(|[x, y, u, v]| (u - x).max(v - y));
    let mut sizes: Vec<f64> = sizes.filter(|s| s.is_finite() && *s > 0.0).collect();
    sizes.sort_by(f64::total_cmp);
    sizes.get(sizes.len() / 2).copied()
}

/// The rims of all blocks with values at their corners.
fn carried(frame: &Frame, values: &[f64]) -> Vec<Vec<Corner>> {
    let boxes: Vec<[f64; 4]> = (0..frame.blocks()).map(|b| around(frame.outline(b))).collect();
    let Some(usual) = median_size(&boxes) else {
        return vec![Vec::new(); frame.blocks()];
    };
    let near = TOUCH * usual;
    let cell = |v: f64| (v / usual).floor() as i64;
    let (mut cells, mut large): (BTreeMap<[i64; 2], Vec<usize>>, Vec<usize>) = Default::default();
    for (b, [x, y, u, v]) in boxes.iter().enumerate() {
        if ![x, y, u, v].iter().all(|n| n.is_finite()) {
            continue;
        }
        let across = |low: f64, high: f64| (high - low + 2.0 * near) / usual + 1.0;
        if across(*x, *u) * across(*y, *v) > MANY_CELLS {
            large.push(b);
            continue;
        }
        for i in cell(x - near)..=cell(u + near) {
            for j in cell(y - near)..=cell(v + near) {
                cells.entry([i, j]).or_default().push(b);
            }
        }
    }
    let touched = |p: [f64; 2]| -> Vec<usize> {
        let there = cells.get(&p.map(cell)).into_iter().flatten();
        // A base under small stones is in thousands of cells.
        let beside = large.iter().filter(|b| {
            let [x, y, u, v] = boxes[**b];
            let inside = |k: f64, low: f64, high: f64| (low - near..=high + near).contains(&k);
            inside(p[0], x, u) && inside(p[1], y, v)
        });
        there
            .chain(beside)
            .copied()
            .filter(|b| values[*b].is_finite() && distance(frame.outline(*b), p) <= near)
            .collect()
    };
    // Corners of others on the edges of a block are corners of its rim too, or lines would jump there.
    let mut hanging: Vec<Vec<Corner>> = vec![Vec::new(); frame.blocks()];
    let mut rims: Vec<Vec<Corner>> = Vec::with_capacity(frame.blocks());
    for b in 0..frame.blocks() {
        let own = frame.outline(b).iter().map(|p| {
            let at = [p[0], p[1]];
            let blocks = touched(at);
            let sum: f64 = blocks.iter().map(|t| values[*t]).sum();
            let corner = (at, sum / blocks.len() as f64);
            for other in blocks.into_iter().filter(|t| *t != b) {
                hanging[other].push(corner);
            }
            corner
        });
        rims.push(own.collect());
    }
    rims.iter().zip(&hanging).map(|(rim, more)| with_hanging(rim, more, near)).collect()
}

/// A rim with further corners that lie on its edges, in their order; those nearer than `near` to its own, m, are left out.
fn with_hanging(rim: &[Corner], more: &[Corner], near: f64) -> Vec<Corner> {
    let mut out = Vec::with_capacity(rim.len() + more.len());
    for (k, (a, value)) in rim.iter().enumerate() {
        out.push((*a, *value));
        let b = rim[(k + 1) % rim.len()].0;
        let d = [b[0] - a[0], b[1] - a[1]];
        let length = (d[0] * d[0] + d[1] * d[1]).sqrt();
        let along = |(p, value): &Corner| {
            let r = [p[0] - a[0], p[1] - a[1]];
            let far = (d[0] * r[1] - d[1] * r[0]).abs() / length;
            let t = (d[0] * r[0] + d[1] * r[1]) / length;
            (far <= near && t > near && t < length - near).then_some((t, (*p, *value)))
        };
        let mut between: Vec<(f64, Corner)> = more.iter().filter_map(along).collect();
        between.sort_by(|x, y| x.0.total_cmp(&y.0));
        between.dedup_by(|x, y| x.0 - y.0 < near);
        out.extend(between.into_iter().map(|(_, corner)| corner));
    }
    out
}

/// Left, bottom, right and top of an outline.
fn around(outline: &[[f64; 3]]) -> [f64; 4] {
    let start = [f64::INFINITY, f64::INFINITY, f64::NEG_INFINITY, f64::NEG_INFINITY];
    outline
        .iter()
        .fold(start, |[x, y, u, v], p| [x.min(p[0]), y.min(p[1]), u.max(p[0]), v.max(p[1])])
}

/// Distance of a place from the edges of an outline.
fn distance(outline: &[[f64; 3]], p: [f64; 2]) -> f64 {
    let next = outline.iter().cycle().skip(1);
    let to_edge = |(a, b): (&[f64; 3], &[f64; 3])| {
        let (d, r) = ([b[0] - a[0], b[1] - a[1]], [p[0] - a[0], p[1] - a[1]]);
        let length2 = d[0] * d[0] + d[1] * d[1];
        let t = if length2 > 0.0 {
            ((d[0] * r[0] + d[1] * r[1]) / length2).clamp(0.0, 1.0)
        } else {
            0.0
        };
        let (x, y) = (r[0] - t * d[0], r[1] - t * d[1]);
        (x * x + y * y).sqrt()
    };
    outline.iter().zip(next).map(to_edge).fold(f64::INFINITY, f64::min)
}

/// Where the field has a value, in all triangles of middles and edges; those that a hollow outline turns over are left out.
fn pieces(frame: &Frame, values: &[f64], rims: &[Vec<Corner>], level: f64) -> Pieces {
    let mut out = Pieces::new();
    for (b, (value, rim)) in values.iter().zip(rims).enumerate() {
        let centre = middle(frame.outline(b));
        let turn = |p: [f64; 2], q: [f64; 2]| {
            (p[0] - centre[0]) * (q[1] - centre[1]) - (p[1] - centre[1]) * (q[0] - centre[0])
        };
        let edges = || rim.iter().zip(rim.iter().cycle().skip(1));
        // Cuts go round either way.
        let round: f64 = edges().map(|(p, q)| turn(p.0, q.0)).sum();
        for (p, q) in edges().filter(|(p, q)| turn(p.0, q.0) * round > 0.0) {
            out.extend(crossed([(centre, *value), *p, *q], level));
        }
    }
    out
}

/// The piece of a level in a triangle whose corners have values; none where it is not crossed or a value is missing.
fn crossed(triangle: [Corner; 3], level: f64) -> Option<[[f64; 2]; 2]> {
    if triangle.iter().any(|(_, v)| !v.is_finite()) {
        return None;
    }
    let mut ends = [[0.0; 2]; 2];
    let mut found = 0;
    for k in 0..3 {
        let ((p, a), (q, b)) = (triangle[k], triangle[(k + 1) % 3]);
        // What lies on the level counts as above it, so that every line has two ends.
        if (a < level) == (b < level) {
            continue;
        }
        let t = (level - a) / (b - a);
        *ends.get_mut(found)? = [p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1])];
        found += 1;
    }
    (found == 2).then_some(ends)
}

/// Writes a number on a line, at most [`LABELS`] times, away from other numbers.
fn label(page: &mut Page, line: &Pieces, text: &str, labels: &mut Vec<[f64; 2]>) {
    let mut written = 0;
    // From the middle of the list on, which is seldom at the rim.
    let middle = line.len() / 2;
    for [a, b] in line[middle..].iter().chain(&line[..middle]) {
        let at = [0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])];
        let clear = |p: &[f64; 2]| (p[0] - at[0]).powi(2) + (p[1] - at[1]).powi(2) > APART * APART;
        if written == LABELS {
            return;
        }
        if !labels.iter().all(clear) {
            continue;
        }
        let width = text_width(text, SIZE) + 4.0;
        let back = "fill=\"#ffffff\" fill-opacity=\"0.85\"";
        page.rect(at[0] - 0.5 * width, at[1] - 6.5, width, 13.0, back);
        page.text([at[0], at[1] + 3.6], SIZE, Anchor::Middle, text);
        labels.push(at);
        written += 1;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Unit squares in a grid of `n` by `n`, and the values of `f` at their middles.
    fn grid(n: usize, f: impl Fn(f64, f64) -> f64) -> (Frame, Vec<f64>) {
        let mut frame = Frame { offsets: vec![0], ..Frame::default() };
        let mut values = Vec::new();
        for (i, j) in (0..n * n).map(|k| ((k % n) as f64, (k / n) as f64)) {
            let corners = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
            frame.points.extend(corners.map(|[x, y]| [i + x, j + y, 0.0]));
            frame.offsets.push(frame.points.len() as u32);
            values.push(f(i + 0.5, j + 0.5));
        }
        (frame, values)
    }

    #[test]
    fn lines_of_a_plane_are_straight_inside_and_as_long_as_the_model() {
        // Each corner inside is the mean of four blocks: a linear field is met exactly there.
        let (frame, values) = grid(8, |x, _| x);
        let corners = carried(&frame, &values);
        let line = pieces(&frame, &values, &corners, 3.25);
        assert!(line.iter().flatten().all(|p| (p[0] - 3.25).abs() < 1e-12));
        let long: f64 = line.iter().map(|[a, b]| (a[1] - b[1]).abs()).sum();
        assert!((long - 8.0).abs() < 1e-12, "{long}");
    }

    #[test]
    fn outlines_that_go_round_the_other_way_have_the_same_lines() {
        let (mut frame, values) = grid(4, |x, y| x + y);
        let long = |frame: &Frame| -> f64 {
            let line = pieces(frame, &values, &carried(frame, &values), 3.3);
            line.iter().map(|[a, b]| (a[0] - b[0]).abs()).sum()
        };
        let one_way = long(&frame);
        assert!(one_way > 2.0);
        frame.points.chunks_mut(4).for_each(<[_]>::reverse);
        assert!((long(&frame) - one_way).abs() < 1e-12);
    }

    #[test]
    fn a_level_outside_or_a_value_that_is_missing_gives_no_line() {
        let (frame, mut values) = grid(3, |x, y| x + y);
        let corners = carried(&frame, &values);
        assert!(pieces(&frame, &values, &corners, 9.0).is_empty());
        values.fill(f64::NAN);
        let corners = carried(&frame, &values);
        assert!(pieces(&frame, &values, &corners, 1.0).is_empty());
    }

    #[test]
    fn a_large_base_takes_no_more_room_than_a_stone() {
        // Ten stones of 1 m on a base of 10^6 m by 10^6 m: 10^12 cells.
        let mut frame = Frame { offsets: vec![0], ..Frame::default() };
        let stones = (0..10).map(|k| [f64::from(k), 0.0, f64::from(k) + 1.0, 1.0]);
        for [x, y, u, v] in stones.chain([[-5e5, -1e6, 5e5, 0.0]]) {
            frame.points.extend([[x, y, 0.0], [u, y, 0.0], [u, v, 0.0], [x, v, 0.0]]);
            frame.offsets.push(frame.points.len() as u32);
        }
        let values: Vec<f64> = (0..11).map(f64::from).collect();
        let corners = carried(&frame, &values);
        // The foot between the first two stones touches both and the base.
        let foot = |rim: &[Corner]| {
            let found = rim.iter().find(|(p, _)| *p == [1.0, 0.0]).map(|c| c.1);
            assert_eq!(found, Some((0.0 + 1.0 + 10.0) / 3.0));
        };
        foot(&corners[0]);
        foot(&corners[10]);
    }

    #[test]
    fn a_corner_on_an_edge_counts_that_block_too() {
        // Two squares on a plank.
        let mut frame = Frame { offsets: vec![0], ..Frame::default() };
        for [x, y, u, v] in [[0.0, 0.0, 2.0, 1.0], [0.0, 1.0, 1.0, 2.0], [1.0, 1.0, 2.0, 2.0]] {
            frame.points.extend([[x, y, 0.0], [u, y, 0.0], [u, v, 0.0], [x, v, 0.0]]);
            frame.offsets.push(frame.points.len() as u32);
        }
        let corners = carried(&frame, &[3.0, 6.0, 9.0]);
        // The corner between the squares lies on the edge of the plank.
        assert_eq!(corners[1][1].1, 6.0);
        assert_eq!(corners[2][0].1, 6.0);
        assert_eq!(corners[0][0].1, 3.0);
        // It is a corner of the rim of the plank, where both squares have it.
        let plank: Vec<f64> = corners[0].iter().map(|(p, _)| p[0]).collect();
        assert_eq!(plank, [0.0, 2.0, 2.0, 1.0, 0.0]);
        assert_eq!(corners[0][3], ([1.0, 1.0], 6.0));
    }
}
