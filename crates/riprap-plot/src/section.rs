//! Flat pictures of frames: cuts through solid blocks, and displacements made larger.
//!
//! A cut follows the material: the plane is laid through the blocks as they were before they moved, and what it met is
//! drawn where it is now. So neighbours stay neighbours, no gap opens where a plane runs along faces, and
//! displacements can be multiplied.

use super::PlotError;
use super::drawing::{BlockOptions, Chosen, Normal, choose, middle, short};
use super::solid::{self, Body};
use riprap_geom::Vec3;
use riprap_keys::Words;
use riprap_record::frame::{Column, Frame, SEEPAGE_FLOW, Surfaces, stress};
use riprap_record::manifest::Manifest;
use std::collections::BTreeMap;

/// Refuses a frame in the plane.
pub(super) fn need_space(frame: &Frame, picture: &'static str) -> Result<(), PlotError> {
    if frame.solids.is_some() {
        return Ok(());
    }
    let reason = "the run is in the plane; draw it with `riprap plot RUN blocks`".to_owned();
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
        if options.cracks {
            let reason = "the run is in the plane, which has no sections; leave the traces out";
            let picture = "traces of broken faces";
            return Err(PlotError::Unsuitable { picture, reason: reason.to_owned() });
        }
        let shifted = |f| if factor == 1.0 { f } else { shifted(f, factor) };
        let frames = frames.into_iter().map(shifted).collect();
        let (axes, sources, suffix) = (["x", "y"], Vec::new(), Vec::new());
        return Ok(Flat { frames, fields, axes, sources, suffix });
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
        chosen.push(Chosen { values: kept.iter().map(|&i| field.values[i]).collect(), ..field });
        cuts.push(cut);
    }
    if cuts.iter().any(|c| c.blocks() == 0) {
        let what = format!(
            "the plane {} = {} m intersects no block; block centres lie between {} and {} m",
            normal.word(),
            short(at),
            short(low),
            short(high)
        );
        return Err(PlotError::NothingToDraw { what });
    }
    let near = 0.02 * (high - low) + 1e-9;
    let [h, v] = normal.across();
    let centres = manifest.sources.iter().map(riprap_record::Source::centre);
    let sources = centres.filter(|c| (c[k] - at).abs() <= near).map(|c| [c[h], c[v]]);
    let at = short(at).replacen('-', "\u{2212}", 1);
    Ok(Flat {
        frames: cuts,
        fields: chosen,
        axes: normal.axes(),
        sources: sources.collect(),
        suffix: vec![format!("section {} = {at} m", normal.word())],
    })
}

/// Range of the centres before they moved.
fn reach(bodies: &[Body], k: usize) -> (f64, f64) {
    bodies
        .iter()
        .map(|b| b.start()[k])
        .filter(|v| v.is_finite())
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(v), h.max(v)))
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
    let owners = Owners::of(frame, bodies, factor);
    // Bars of bolts as seen along the normal.
    out.bolts = frame.bolts.clone().map(|mut bars| {
        owners.carry_bars(&mut bars);
        for p in &mut bars.points {
            *p = [p[h], p[v], 0.0];
        }
        bars
    });
    out.cracks = Some(traces(frame, &owners, normal, at));
    flows(frame, &owners, normal, at, &mut out);
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
        out.block_columns.push(Column::scalar(stress::SHEAR, "Pa", data));
    }
    (out, kept)
}

/// The blocks that joints and bars of bolts belong to, by their numbers: these move with them.
struct Owners<'a> {
    bodies: &'a [Body],
    places: BTreeMap<u32, usize>,
    /// Factor on displacements and rotations.
    factor: f64,
}

impl<'a> Owners<'a> {
    fn of(frame: &Frame, bodies: &'a [Body], factor: f64) -> Self {
        let numbers = frame.column("block").filter(|c| c.components == 1);
        let number = |i: usize| numbers.map_or(i as u32, |c| c.data[i] as u32);
        Owners { bodies, places: (0..bodies.len()).map(|i| (number(i), i)).collect(), factor }
    }

    /// The block of entry `i` of a column of numbers of blocks; none where a frame does not tell.
    fn owner(&self, column: Option<&Column>, i: usize) -> Option<&Body> {
        let number = *column?.data.get(i)?;
        let place = *self.places.get(&(number as u32))?;
        self.bodies.get(place)
    }

    /// A place that belongs to a block, with its displacement multiplied.
    fn carried(&self, owner: Option<&Body>, place: Vec3) -> Vec3 {
        match owner.filter(|_| self.factor != 1.0) {
            Some(body) => body.moved(body.unmoved(place), self.factor),
            None => place,
        }
    }

    /// Takes the ends of bars along with the blocks that they lie in.
    fn carry_bars(&self, bars: &mut Surfaces) {
        let column = |name: &str| bars.columns.iter().find(|c| c.name == name);
        let sides = [column("block_a"), column("block_b")];
        for (k, p) in bars.points.iter_mut().enumerate() {
            let owner = self.owner(sides[k % 2], k / 2);
            *p = self.carried(owner, Vec3::from(*p)).to_array();
        }
    }
}

/// The numbers of the first blocks of joints.
fn first_blocks(frame: &Frame) -> Option<&Column> {
    let mut columns = frame.contact_columns.iter();
    columns.find(|c| c.name == "block_a" && c.components == 1)
}

/// Where the plane meets faces that have broken: two points a line, in the axes of the picture. A face counts as a square of its area,
/// and lies where it was before its first block moved, as the blocks do that are cut.
fn traces(frame: &Frame, owners: &Owners, normal: Normal, at: f64) -> Surfaces {
    let column = |name: &str, components: usize| {
        let all = frame.contact_columns.iter();
        let mut found = all.filter(|c| c.name == name && c.components == components);
        found.next().map(|c| &c.data[..])
    };
    let mut out = Surfaces::default();
    let (Some(broken), Some(area), Some(directions)) =
        (column("broken_points", 1), column("area", 1), column("normal", 3))
    else {
        return out;
    };
    let first = first_blocks(frame);
    let ([h, v], k) = (normal.across(), normal.index());
    for (i, place) in frame.contact_points.iter().enumerate() {
        let owner = owners.owner(first, i);
        let (now, direction) =
            (Vec3::from(*place), Vec3::from_slice(&directions[3 * i..3 * i + 3]));
        let (place, direction) = match owner {
            Some(body) => (body.unmoved(now), body.unturned(direction)),
            None => (now, direction),
        };
        let [nh, nv] = [direction[h], direction[v]];
        let flat = nh.hypot(nv);
        let half = 0.5 * area[i].sqrt();
        // How far the face reaches to either side of the plane; one that lies in it has no trace.
        if broken[i] > 0.0 && (place[k] - at).abs() <= half * flat && flat > 1e-6 {
            for sign in [-1.0, 1.0] {
                let mut end = place;
                end[h] -= sign * nv / flat * half;
                end[v] += sign * nh / flat * half;
                let end = owner.map_or(end, |body| body.moved(end, owners.factor));
                out.points.push([end[h], end[v], 0.0]);
            }
            out.ends.push(out.points.len() as u32);
        }
    }
    out
}

/// Flows through the joints that the plane meets, in the axes of the picture. A joint counts as a square of its area, and lies where it was
/// before its first block moved.
fn flows(frame: &Frame, owners: &Owners, normal: Normal, at: f64, out: &mut Frame) {
    let column = |name: &str| frame.contact_columns.iter().find(|c| c.name == name);
    let (Some(flow), Some(area)) = (column(SEEPAGE_FLOW), column("area")) else {
        return;
    };
    let first = first_blocks(frame);
    let ([h, v], k) = (normal.across(), normal.index());
    let now = |i: usize| Vec3::from(frame.contact_points[i]);
    let met = |i: &usize| {
        let owner = owners.owner(first, *i);
        let place = owner.map_or(now(*i), |body| body.unmoved(now(*i)));
        (place[k] - at).abs() <= 0.5 * area.data[*i].sqrt()
    };
    let met: Vec<usize> = (0..frame.contact_points.len()).filter(met).collect();
    out.contact_columns.push(picked(flow, &met, [h, v]));
    let places = met.iter().map(|i| owners.carried(owners.owner(first, *i), now(*i)));
    out.contact_points = places.map(|p| [p[h], p[v], 0.0]).collect();
}

/// A column of the blocks of the cut; of vectors the two parts in its plane.
fn picked(column: &Column, kept: &[usize], [h, v]: [usize; 2]) -> Column {
    if column.components < 3 {
        let n = column.components;
        let data = kept.iter().flat_map(|&i| &column.data[n * i..n * (i + 1)]);
        return Column { data: data.copied().collect(), ..column.clone() };
    }
    let data: Vec<[f64; 2]> =
        kept.iter().map(|&i| [column.data[3 * i + h], column.data[3 * i + v]]).collect();
    Column::vector(&column.name, &column.unit, data)
}

/// A frame in the plane with displacements and rotations multiplied; contacts and bolts go with their blocks.
fn shifted(mut frame: Frame, factor: f64) -> Frame {
    let mut bodies = solid::bodies(&frame);
    for (i, body) in bodies.iter_mut().enumerate() {
        let [x, y] = middle(frame.outline(i));
        body.now = Vec3::new(x, y, 0.0);
    }
    let owners = Owners::of(&frame, &bodies, factor);
    let first = first_blocks(&frame);
    let contacts = frame.contact_points.iter().enumerate().map(|(i, p)| {
        let owner = owners.owner(first, i);
        owners.carried(owner, Vec3::from(*p)).to_array()
    });
    let contacts = contacts.collect();
    let bolts = frame.bolts.clone().map(|mut bars| {
        owners.carry_bars(&mut bars);
        bars
    });
    (frame.contact_points, frame.bolts) = (contacts, bolts);
    for (i, body) in bodies.iter().enumerate() {
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
                    [[1.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0]],
                ),
            ],
            ..Frame::default()
        };
        let found = traces(&frame, &Owners::of(&frame, &[], 1.0), Normal::Y, 0.0);
        assert_eq!(found.ends, [2]);
        let [a, b] = found.points[..] else { panic!("{found:?}") };
        assert!((a[0] - 0.2).abs() < 1e-12 && (b[0] - 0.2).abs() < 1e-12);
        assert!((a[1] - 0.2).abs() < 1e-12 && (b[1] - 0.4).abs() < 1e-12, "{a:?} {b:?}");
        let none = Frame::default();
        let found = traces(&none, &Owners::of(&none, &[], 1.0), Normal::X, 0.0);
        assert!(found.points.is_empty());
    }

    #[test]
    fn joints_and_bolts_go_with_their_blocks() {
        // A brick that has moved by 1 m along the normal and 0.1 m up, with a broken face at its end and a bar.
        let lift = Vec3::new(0.0, 1.0, 0.1);
        let body = Body { now: lift, displacement: lift, rotation: Vec3::ZERO };
        let frame = Frame {
            contact_points: vec![[0.5, 1.0, 0.1]],
            contact_columns: vec![
                Column::scalar("block_a", "-", vec![7.0]),
                Column::scalar("broken_points", "-", vec![4.0]),
                Column::scalar("area", "m2", vec![1.0]),
                Column::vector3("normal", "-", [[1.0, 0.0, 0.0]]),
                Column::vector3(SEEPAGE_FLOW, "m3/s", [[0.0, 0.0, 1.0]]),
            ],
            offsets: vec![0, 0],
            block_columns: vec![Column::scalar("block", "-", vec![7.0])],
            bolts: Some(Surfaces {
                ends: vec![2],
                points: vec![[0.0, 1.0, 0.1], [5.0, 0.0, 0.0]],
                columns: vec![
                    Column::scalar("block_a", "-", vec![7.0]),
                    Column::scalar("block_b", "-", vec![8.0]),
                ],
            }),
            ..Frame::default()
        };
        for (factor, up) in [(1.0, 0.1), (10.0, 1.0)] {
            let (cut, _) = sliced(&frame, &[body], Normal::Y, 0.0, factor);
            let near = |p: [f64; 3], x: f64, y: f64| {
                assert!((p[0] - x).hypot(p[1] - y) < 1e-12, "{p:?}, {x} {y}");
            };
            let traces = cut.cracks.unwrap();
            assert_eq!(traces.points.len(), 2, "cut where it was");
            near(traces.points[0], 0.5, up - 0.5);
            near(traces.points[1], 0.5, up + 0.5);
            near(cut.contact_points[0], 0.5, up);
            let bars = cut.bolts.unwrap();
            near(bars.points[0], 0.0, up);
            // The other end lies in no block of the frame.
            near(bars.points[1], 5.0, 0.0);
        }
    }

    #[test]
    fn contacts_and_bolts_of_the_plane_go_with_their_blocks() {
        let frame = Frame {
            points: vec![[1.0, 0.0, 0.0], [2.0, 0.0, 0.0], [1.0, 1.0, 0.0]],
            offsets: vec![0, 3],
            block_columns: vec![Column::vector("displacement", "m", [[1.0, 0.0]])],
            contact_points: vec![[1.5, 0.0, 0.0]],
            contact_columns: vec![Column::scalar("block_a", "-", vec![0.0])],
            ..Frame::default()
        };
        let moved = shifted(frame, 3.0);
        assert!((moved.contact_points[0][0] - 3.5).abs() < 1e-12);
        assert!((moved.points[0][0] - 3.0).abs() < 1e-12);
    }

    #[test]
    fn traces_in_the_plane_are_refused() {
        let options = BlockOptions { cracks: true, ..BlockOptions::default() };
        let refused = flattened(vec![Frame::default()], Vec::new(), &Manifest::default(), options);
        let text = refused.map(|_| ()).unwrap_err().to_string();
        assert!(text.contains("in the plane"), "{text}");
    }
}
