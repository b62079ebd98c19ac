//! A field along a line through the rock: the blocks that the line meets where they were before they moved, so that several moments can be compared.

use super::chart::{self, Curve, Mark, Panel};
use super::drawing::{choose, middle, short};
use super::frames::moment;
use super::load::Which;
use super::run::Run;
use super::solid::{self, Body};
use super::{PlotError, Target, column, table_csv, write};
use riprap_geom::Vec3;
use riprap_record::frame::Frame;
use riprap_record::manifest::Manifest;
use riprap_record::table::Series;
use std::path::PathBuf;

/// Stretches shorter than this share of the line are none.
const NONE: f64 = 1e-7;
/// The line is moved aside by this share of its length, so that it runs along no face, edge or corner of what was built on round numbers.
const ASIDE: [f64; 3] = [1.7e-9, 2.9e-9, 2.3e-9];

/// A line from one place to another, m: x, y and in space z.
#[derive(Debug, Clone, PartialEq)]
pub struct Along {
    /// Where it begins.
    pub from: Vec<f64>,
    /// Where it ends.
    pub to: Vec<f64>,
}

/// A stretch of the line inside a block: shares of its length.
struct Piece {
    from: f64,
    to: f64,
    block: usize,
}

/// Draws a field (`displacement.x`, `sigma1`...) along a line, a curve for each frame; each block has one value.
///
/// # Errors
/// Unknown fields (with the nearest name), frames that do not exist, places with too many or too few coordinates for the space of the
/// run, a line without length or that meets no block, files that cannot be read or written.
pub fn along<'r, 't>(
    run: impl Into<Run<'r>>,
    frames: &[Which],
    field: &str,
    line: &Along,
    out: impl Into<Target<'t>>,
) -> Result<Vec<PathBuf>, PlotError> {
    let run = run.into();
    let manifest = Manifest::read(run.folder)?;
    let (mut curves, mut columns): (Vec<Curve>, Vec<Series>) = (Vec::new(), Vec::new());
    let mut unit = String::new();
    for which in frames {
        let frame = run.frame(*which)?;
        let chosen = choose(&frame, field)?;
        let [a, b] = [within(&frame, &line.from)?, within(&frame, &line.to)?];
        let length = a.distance(b);
        if length.is_nan() || length <= 0.0 {
            let what = "the line has zero length; give two different points".to_owned();
            return Err(PlotError::NothingToDraw { what });
        }
        let pieces = pieces(&frame, a, b);
        if pieces.is_empty() {
            let what = format!(
                "the line from {} to {} meets no block of the undeformed model",
                place(&line.from),
                place(&line.to)
            );
            return Err(PlotError::NothingToDraw { what });
        }
        let (mut x, mut y, mut last) = (Vec::new(), Vec::new(), None);
        for piece in &pieces {
            if last.is_some_and(|end| piece.from - end > NONE) {
                // Nothing is drawn between blocks.
                x.push(length * piece.from);
                y.push(f64::NAN);
            }
            x.extend([piece.from, piece.to].map(|share| length * share));
            y.extend([chosen.values[piece.block]; 2]);
            last = Some(piece.to);
        }
        let name = moment(run.folder, &frame)?;
        let own =
            |name: &str| format!("{name}, {}", moment(run.folder, &frame).unwrap_or_default());
        columns.push(column(&own("distance"), "m", x.clone()));
        columns.push(column(&own(&chosen.name), &chosen.unit, y.clone()));
        unit = chosen.unit;
        curves.push(Curve { name, x, y, mark: Mark::Line });
    }
    let panel = Panel { name: field.to_owned(), unit, curves, height: 340.0, ..Panel::default() };
    let title = run.suffix(&manifest, &format!("{field} along a line"));
    let page = chart::draw((&manifest.title, &title), ("distance", "m"), &[panel]);
    write(&page, &table_csv(&columns.iter().collect::<Vec<_>>()), out)
}

fn place(at: &[f64]) -> String {
    let all: Vec<String> = at.iter().map(|x| short(*x)).collect();
    format!("({}) m", all.join(", "))
}

/// A place in the space of a frame.
fn within(frame: &Frame, at: &[f64]) -> Result<Vec3, PlotError> {
    match (frame.solids.is_some(), at) {
        (false, &[x, y]) => Ok(Vec3::new(x, y, 0.0)),
        (true, &[x, y, z]) => Ok(Vec3::new(x, y, z)),
        (in_space, _) => {
            let (wanted, space) = match in_space {
                true => ("x, y and z", "in space"),
                false => ("x and y", "in the plane"),
            };
            let given = at.len();
            let place = place(at);
            let what = format!(
                "the run is {space}, where a point has {wanted}; {place} has {given} coordinates"
            );
            Err(PlotError::NothingToDraw { what })
        }
    }
}

/// The stretches of the line that lie in blocks, in their order.
fn pieces(frame: &Frame, a: Vec3, b: Vec3) -> Vec<Piece> {
    let aside = a.distance(b) * Vec3::from(ASIDE);
    let mut out = Vec::new();
    for (block, body) in solid::bodies(frame).iter().enumerate() {
        let ends = [a, b].map(|end| end + aside);
        let mut crossings = match frame.solids.is_some() {
            true => in_space(frame, block, body, ends),
            false => {
                let [x, y] = middle(frame.outline(block));
                let now = Vec3::new(x, y, 0.0);
                in_plane(frame, block, &Body { now, ..*body }, ends)
            }
        };
        crossings.sort_by(f64::total_cmp);
        for pair in crossings.chunks_exact(2) {
            let (from, to) = (pair[0].max(0.0), pair[1].min(1.0));
            if to - from > NONE {
                out.push(Piece { from, to, block });
            }
        }
    }
    out.sort_by(|p, q| p.from.total_cmp(&q.from).then(p.to.total_cmp(&q.to)));
    out
}

/// Shares at which the straight line through two places crosses the outline of a polygon.
fn in_plane(frame: &Frame, i: usize, body: &Body, [a, b]: [Vec3; 2]) -> Vec<f64> {
    let way = b - a;
    let corner = |p: &[f64; 3]| body.unmoved(Vec3::from(*p)) - a;
    let corners: Vec<Vec3> = frame.outline(i).iter().map(corner).collect();
    let side = |p: Vec3| way.x * p.y - way.y * p.x;
    let mut out = Vec::new();
    for (k, &p) in corners.iter().enumerate() {
        let q = corners[(k + 1) % corners.len()];
        let (sp, sq) = (side(p), side(q));
        if (sp >= 0.0) != (sq >= 0.0) {
            let at = p + sp / (sp - sq) * (q - p);
            out.push((at.x * way.x + at.y * way.y) / (way.x * way.x + way.y * way.y));
        }
    }
    out
}

/// Shares at which the straight line through two places crosses the faces of a solid of any form, triangle by triangle.
fn in_space(frame: &Frame, i: usize, body: &Body, [a, b]: [Vec3; 2]) -> Vec<f64> {
    let way = b - a;
    let corner = |p: &[f64; 3]| body.unmoved(Vec3::from(*p)) - a;
    let corners: Vec<Vec3> = frame.outline(i).iter().map(corner).collect();
    let mut out = Vec::new();
    for face in frame.solids.iter().flat_map(|s| s.of(i)) {
        for pair in face.windows(2).skip(1) {
            let [p, q, r] = [face[0], pair[0], pair[1]].map(|c| corners[c as usize]);
            // On which side of each edge the line passes; edges that two triangles share are judged alike by both.
            let sides = [q.cross(r), r.cross(p), p.cross(q)].map(|n| n.dot(way));
            let inside = |sign: f64| sides.iter().all(|s| sign * s >= 0.0);
            let normal = (q - p).cross(r - p);
            let slope = normal.dot(way);
            if slope != 0.0 && (inside(1.0) || inside(-1.0)) {
                out.push(normal.dot(p) / slope);
            }
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use riprap_record::frame::{Column, Solids};

    fn shares(frame: &Frame, a: [f64; 3], b: [f64; 3]) -> Vec<(usize, f64, f64)> {
        let all = pieces(frame, Vec3::from(a), Vec3::from(b));
        let round = |x: f64| (1e6 * x).round() / 1e6;
        all.iter().map(|p| (p.block, round(p.from), round(p.to))).collect()
    }

    #[test]
    fn a_line_through_a_notch_leaves_it_out_and_blocks_count_where_they_were() {
        // A square of 4 m with a notch from above in its middle, then a square of 1 m beside it that has moved by 10 m.
        let notched = [
            [0.0, 0.0],
            [4.0, 0.0],
            [4.0, 4.0],
            [3.0, 4.0],
            [3.0, 1.0],
            [1.0, 1.0],
            [1.0, 4.0],
            [0.0, 4.0],
        ];
        let square = [[14.0, 0.0], [15.0, 0.0], [15.0, 4.0], [14.0, 4.0]];
        let points = notched.iter().chain(&square).map(|[x, y]| [*x, *y, 0.0]);
        let frame = Frame {
            points: points.collect(),
            offsets: vec![0, 8, 12],
            block_columns: vec![Column::vector("displacement", "m", [[0.0, 0.0], [10.0, 0.0]])],
            ..Frame::default()
        };
        let line = shares(&frame, [-1.0, 2.0, 0.0], [9.0, 2.0, 0.0]);
        assert_eq!(line, [(0, 0.1, 0.2), (0, 0.4, 0.5), (1, 0.5, 0.6)]);
        // Along the bottom of both: moved aside into them.
        let line = shares(&frame, [-1.0, 0.0, 0.0], [9.0, 0.0, 0.0]);
        assert_eq!(line, [(0, 0.1, 0.5), (1, 0.5, 0.6)]);
        assert!(shares(&frame, [-1.0, 5.0, 0.0], [9.0, 5.0, 0.0]).is_empty());
    }

    #[test]
    fn a_line_along_an_edge_of_bricks_meets_each_once() {
        let mut frame = Frame { offsets: vec![0], ..Frame::default() };
        let mut solids = Solids { faces: vec![0], ends: vec![0], corners: Vec::new() };
        for x in [0.0, 1.0, 3.0] {
            for corner in 0..8_u32 {
                let bit = |k: u32| f64::from(corner >> k & 1);
                frame.points.push([x + bit(0), bit(1), bit(2)]);
            }
            frame.offsets.push(frame.points.len() as u32);
            for face in
                [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]
            {
                solids.corners.extend(face);
                solids.ends.push(solids.corners.len() as u32);
            }
            solids.faces.push(solids.ends.len() as u32 - 1);
        }
        frame.solids = Some(solids);
        let row = [(0, 0.2, 0.4), (1, 0.4, 0.6), (2, 0.8, 1.0)];
        for (y, z) in [(0.5, 0.5), (0.0, 0.0), (0.0, 0.5), (0.3, 0.3)] {
            let line = shares(&frame, [-1.0, y, z], [4.0, y, z]);
            assert_eq!(line, row, "{y} {z}");
        }
    }
}
