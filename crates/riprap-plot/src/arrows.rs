//! Arrows: displacement or velocity of blocks, flow through joints.

use super::drawing::{Vectors, middle};
use super::svg::Page;
use riprap_record::frame::{Column, Frame, usual};
use std::collections::BTreeSet;

/// The longest arrow is not longer than this share of the mean of width and height of the picture,
const LONGEST: f64 = 0.12;
/// nor than so many times the mean distance of the blocks.
const SPACINGS: f64 = 2.5;
/// Of several arrows that begin in one cell of this size the first is drawn, pixels.
const CELL: f64 = 11.0;
/// Shorter arrows are not drawn, pixels.
const SHORTEST: f64 = 3.0;

/// The vectors of a frame.
pub(super) fn column(frame: &Frame, vectors: Vectors) -> Option<&Column> {
    let name = vectors.column();
    let mut of_joints = frame.contact_columns.iter();
    let column = match vectors {
        Vectors::Displacement | Vectors::Velocity => frame.column(name),
        Vectors::Flow => of_joints.find(|c| c.name == name),
    };
    column.filter(|c| c.components >= 2)
}

/// Where arrow `i` begins: in the middle of its block, or at its joint.
fn place(frame: &Frame, vectors: Vectors, i: usize) -> [f64; 2] {
    match vectors {
        Vectors::Displacement | Vectors::Velocity => middle(frame.outline(i)),
        Vectors::Flow => {
            let [x, y, _] = frame.contact_points[i];
            [x, y]
        }
    }
}

/// Lengths in the picture plane of the vectors of all frames.
fn lengths(frames: &[Frame], vectors: Vectors) -> Vec<f64> {
    let columns = frames.iter().filter_map(|f| column(f, vectors));
    let all = columns.flat_map(|c| c.data.chunks(c.components).map(|v| v[0].hypot(v[1])));
    all.filter(|v| v.is_finite()).collect()
}

/// The length that is drawn longest: the largest of all frames, or what most vectors do not exceed. 0 without vectors.
pub(super) fn longest(frames: &[Frame], vectors: Option<Vectors>) -> f64 {
    vectors.map_or(0.0, |v| usual(&lengths(frames, v)))
}

/// Number of vectors that are longer than that.
pub(super) fn beyond(frames: &[Frame], vectors: Vectors, longest: f64) -> usize {
    let all = lengths(frames, vectors);
    all.iter().filter(|v| **v > 1.001 * longest).count()
}

/// Draws arrows from the middles of blocks or joints; vectors of the length `longest` and above are equally long everywhere.
pub(super) fn draw(
    page: &mut Page,
    frame: &Frame,
    vectors: Vectors,
    longest: f64,
    pixel: &dyn Fn([f64; 2]) -> [f64; 2],
    size: [f64; 2],
) {
    let Some(column) = column(frame, vectors).filter(|_| longest > 0.0) else {
        return;
    };
    // As if the blocks shared the picture evenly.
    let spacing = (size[0] * size[1] / frame.blocks().max(1) as f64).sqrt();
    let reach = (LONGEST * 0.5 * (size[0] + size[1])).min((SPACINGS * spacing).max(20.0));
    let mut taken = BTreeSet::new();
    for (i, v) in column.data.chunks(column.components).enumerate() {
        let size = v[0].hypot(v[1]).max(longest);
        let (dx, dy) = (v[0] * reach / size, -v[1] * reach / size);
        let [x, y] = pixel(place(frame, vectors, i));
        let length = dx.hypot(dy);
        let cell = [x, y].map(|v| (v / CELL).floor() as i64);
        // Asked last: an arrow that is not drawn takes no place from others.
        if length.is_finite() && length >= SHORTEST && taken.insert(cell) {
            arrow(page, [x, y], [x + dx, y + dy], length);
        }
    }
}

fn arrow(page: &mut Page, from: [f64; 2], to: [f64; 2], length: f64) {
    let head = (0.35 * length).clamp(2.0, 6.0).min(length);
    let (ux, uy) = ((to[0] - from[0]) / length, (to[1] - from[1]) / length);
    let neck = [to[0] - head * ux, to[1] - head * uy];
    let side = 0.4 * head;
    let tip = [
        to,
        [neck[0] - side * uy, neck[1] + side * ux],
        [neck[0] + side * uy, neck[1] - side * ux],
    ];
    // A pale rim, or arrows would be lost on dark blocks.
    page.line(from, neck, "stroke=\"#ffffff\" stroke-width=\"2.2\" stroke-opacity=\"0.6\"");
    page.line(from, neck, "stroke=\"#1a1a1a\" stroke-width=\"1\"");
    page.polygon(&tip, "fill=\"#1a1a1a\"");
}
