//! Flat pictures of frames: cuts through solid blocks, and displacements made larger.
//!
//! A cut follows the material: the plane is laid through the blocks as they were before they moved, and what it met is
//! drawn where it is now. So neighbours stay neighbours, no gap opens where a plane runs along faces, and
//! displacements can be multiplied.

use super::PlotError;
use super::drawing::{BlockOptions, Chosen, Normal, choose, middle, short};
use super::solid::{self, Body};
use riprap_geom::Vec3;
use riprap_record::frame::{Column, Frame, SEEPAGE_FLOW, Surfaces, stress};
use riprap_record::manifest::Manifest;

/// Refuses a frame in the plane.
pub(super) fn need_space(frame: &Frame, picture: &'static str) -> Result<(), PlotError> {
    if frame.solids.is_some() {
        return Ok(());
    }
    let reason = "the run is in the plane; `blocks` draws its blocks".to_owned();
    Err(PlotError::Unsuitable { picture, reason })
}

/// Frames ready to be drawn on paper.
pub(super) struct Flat {
    pub(super) frames: Vec<Frame>,
    pub(super) fields: Vec<Chosen>,
    pub(super) axes: [&'static str; 2],
    pub(super) sources: Vec<[f64; 2]>,
    /// For the title: where the cut lies.
    pub(super) suffix: Vec<String>,
}

/// Cuts frames in space; frames in the plane stay as they are, but for an exaggeration.
pub(super) fn flattened(
    frames: Vec<Frame>,
    fields: Vec<Chosen>,
    manifest: &Manifest,
    options: BlockOptions,
) -> Result<Flat, PlotError> {
    let factor = options.exaggeration.unwrap_or(1.0);
    if let Some(frame) = frames.first().filter(|_| factor != 1.0) {
        choose(frame, "displacement")?;
    }
    if frames.iter().all(|f| f.solids.is_none()) {
        let frames = frames
            .into_iter()
            .map(|f| if factor == 1.0 { f } else { shifted(f, factor) })
            .collect();
        return Ok(Flat {
            frames,
            fields,
            axes: ["x", "y"],
            sources: Vec::new(),
            suffix: Vec::new(),
        });
    }
    let normal = options.normal;
    let k = normal.index();
    let all: Vec<Vec<Body>> = frames.iter().map(solid::bodies).collect();
    let (low, high) = reach(all.first().map_or(&[], Vec::as_slice), k);
    let at = options
        .at
        .or_else(|| manifest.sources.first().map(|s| s.centre()[k]))
        .unwrap_or(0.5 * (low + high));
    let (mut cuts, mut chosen) = (Vec::new(), Vec::new());
    for ((frame, bodies), field) in frames.iter().zip(&all).zip(fields) {
        let (cut, kept) = sliced(frame, bodies, normal, at, factor);
        chosen.push(Chosen {
            values: kept.iter().map(|&i| field.values[i]).collect(),
            ..field
        });
        cuts.push(cut);
    }
    if cuts.iter().any(|c| c.blocks() == 0) {
        let what = format!(
            "the plane {} = {} m meets no block; centres of blocks lie between {} and {} m",
            normal.name(),
            short(at),
            short(low),
            short(high)
        );
        return Err(PlotError::NothingToDraw { what });
    }
    let near = 0.02 * (high - low) + 1e-9;
    let [h, v] = normal.across();
    let sources = manifest
        .sources
        .iter()
        .map(riprap_record::Source::centre)
        .filter(|c| (c[k] - at).abs() <= near)
        .map(|c| [c[h], c[v]])
        .collect();
    Ok(Flat {
        frames: cuts,
        fields: chosen,
        axes: normal.axes(),
        sources,
        suffix: vec![format!(
            "section {} = {} m",
            normal.name(),
            short(at).replacen('-', "\u{2212}", 1)
        )],
    })
}

/// Range of the centres before they moved.
fn reach(bodies: &[Body], k: usize) -> (f64, f64) {
    bodies
        .iter()
        .map(|b| b.start()[k])
        .filter(|v| v.is_finite())
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| {
            (l.min(v), h.max(v))
        })
}

/// The cut as a frame in the plane of the picture, and the block of each line in it.
fn sliced(
    frame: &Frame,
    bodies: &[Body],
    normal: Normal,
    at: f64,
    factor: f64,
) -> (Frame, Vec<usize>) {
    let [h, v] = normal.across();
    let mut out = Frame {
        step: frame.step,
        time: frame.time,
        phase: frame.phase.clone(),
        offsets: vec![0],
        ..Frame::default()
    };
    let mut kept = Vec::new();
    for (i, body) in bodies.iter().enumerate() {
        // Parts and holes of one block follow each other: `outlines` knows them by its number.
        for corners in solid::cut(frame, i, body, normal.index(), at) {
            kept.push(i);
            out.points.extend(corners.iter().map(|c| {
                let p = body.moved(*c, factor);
                [p[h], p[v], 0.0]
            }));
            out.offsets.push(out.points.len() as u32);
        }
    }
    // Bars of bolts as seen along the normal; they do not move with exaggerated displacements.
    out.bolts = frame
        .bolts
        .clone()
        .filter(|_| factor == 1.0)
        .map(|mut bars| {
            bars.points = bars.points.iter().map(|p| [p[h], p[v], 0.0]).collect();
            bars
        });
    out.cracks = (factor == 1.0).then(|| traces(frame, normal, at));
    flows(frame, normal, at, &mut out);
    for name in ["block", "displacement", "velocity"] {
        if let Some(column) = frame.column(name) {
            out.block_columns.push(picked(column, &kept, [h, v]));
        }
    }
    if let (Some(direct), Some(shear)) = (frame.column(stress::NORMAL), frame.column(stress::SHEAR))
    {
        out.block_columns.push(picked(direct, &kept, [h, v]));
        // Of yz, zx, xy the one whose name lacks the normal.
        let k = normal.index();
        let data = kept.iter().map(|&i| shear.data[3 * i + k]).collect();
        out.block_columns
            .push(Column::scalar(stress::SHEAR, "Pa", data));
    }
    (out, kept)
}

/// Where the plane meets faces that have broken: two points a line, in the axes of the picture. A face counts as a square of its area.
fn traces(frame: &Frame, normal: Normal, at: f64) -> Surfaces {
    let column = |name: &str, components: usize| {
        let all = frame.contact_columns.iter();
        let mut found = all.filter(|c| c.name == name && c.components == components);
        found.next().map(|c| &c.data[..])
    };
    let mut out = Surfaces::default();
    let (Some(broken), Some(area), Some(directions)) = (
        column("broken_points", 1),
        column("area", 1),
        column("normal", 3),
    ) else {
        return out;
    };
    let ([h, v], k) = (normal.across(), normal.index());
    for (i, place) in frame.contact_points.iter().enumerate() {
        let [nh, nv] = [directions[3 * i + h], directions[3 * i + v]];
        let flat = nh.hypot(nv);
        let half = 0.5 * area[i].sqrt();
        // How far the face reaches to either side of the plane; one that lies in it has no trace.
        if broken[i] > 0.0 && (place[k] - at).abs() <= half * flat && flat > 1e-6 {
            let along = [-nv / flat * half, nh / flat * half];
            for sign in [-1.0, 1.0] {
                let end = [place[h] + sign * along[0], place[v] + sign * along[1], 0.0];
                out.points.push(end);
            }
            out.ends.push(out.points.len() as u32);
        }
    }
    out
}

/// Flows through the joints that the plane meets, in the axes of the picture. A joint counts as a square of its area.
fn flows(frame: &Frame, normal: Normal, at: f64, out: &mut Frame) {
    let column = |name: &str| frame.contact_columns.iter().find(|c| c.name == name);
    let (Some(flow), Some(area)) = (column(SEEPAGE_FLOW), column("area")) else {
        return;
    };
    let ([h, v], k) = (normal.across(), normal.index());
    let met = |i: &usize| (frame.contact_points[*i][k] - at).abs() <= 0.5 * area.data[*i].sqrt();
    let met: Vec<usize> = (0..frame.contact_points.len()).filter(met).collect();
    out.contact_columns.push(picked(flow, &met, [h, v]));
    let places = met.iter().map(|i| frame.contact_points[*i]);
    out.contact_points = places.map(|p| [p[h], p[v], 0.0]).collect();
}

/// A column of the blocks of the cut; of vectors the two parts in its plane.
fn picked(column: &Column, kept: &[usize], [h, v]: [usize; 2]) -> Column {
    if column.components < 3 {
        let n = column.components;
        let data = kept.iter().flat_map(|&i| &column.data[n * i..n * (i + 1)]);
        return Column {
            data: data.copied().collect(),
            ..column.clone()
        };
    }
    let data: Vec<[f64; 2]> = kept
        .iter()
        .map(|&i| [column.data[3 * i + h], column.data[3 * i + v]])
        .collect();
    Column::vector(&column.name, &column.unit, &data)
}

/// A frame in the plane with displacements and rotations multiplied.
fn shifted(mut frame: Frame, factor: f64) -> Frame {
    let bodies = solid::bodies(&frame);
    for (i, body) in bodies.iter().enumerate() {
        let [x, y] = middle(frame.outline(i));
        let body = Body {
            now: Vec3::new(x, y, 0.0),
            ..*body
        };
        let range = frame.offsets[i] as usize..frame.offsets[i + 1] as usize;
        for p in &mut frame.points[range] {
            *p = body.moved(body.unmoved(Vec3::from(*p)), factor).to_array();
        }
    }
    frame
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn broken_faces_have_traces_where_the_plane_meets_them() {
        // Upright, broken and whole; lying in the plane; beyond it.
        let frame = Frame {
            contact_points: vec![
                [0.2, 0.05, 0.3],
                [1.2, 0.0, 0.3],
                [2.0, 0.0, 0.0],
                [3.0, 0.2, 0.0],
            ],
            contact_columns: vec![
                Column::scalar("broken_points", "-", vec![4.0, 0.0, 4.0, 4.0]),
                Column::scalar("area", "m2", vec![0.04; 4]),
                Column::vector3(
                    "normal",
                    "-",
                    &[
                        [1.0, 0.0, 0.0],
                        [1.0, 0.0, 0.0],
                        [0.0, 1.0, 0.0],
                        [1.0, 0.0, 0.0],
                    ],
                ),
            ],
            ..Frame::default()
        };
        let found = traces(&frame, Normal::Y, 0.0);
        assert_eq!(found.ends, [2]);
        let [a, b] = found.points[..] else {
            panic!("{found:?}")
        };
        assert!((a[0] - 0.2).abs() < 1e-12 && (b[0] - 0.2).abs() < 1e-12);
        assert!(
            (a[1] - 0.2).abs() < 1e-12 && (b[1] - 0.4).abs() < 1e-12,
            "{a:?} {b:?}"
        );
        assert!(traces(&Frame::default(), Normal::X, 0.0).points.is_empty());
    }
}
