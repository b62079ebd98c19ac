//! Force chains as tubes, and vectors of blocks as arrows.

use std::collections::BTreeMap;

use riprap_geom::Vec3;
use riprap_record::frame::{Column, Frame};

use super::super::PlotError;
use super::camera::{Camera, Window};
use super::drawing::unit;
use super::rods::Rod;
use super::wanted::{Shot, rgb};

/// Forces below this share of the largest are no part of chains, as in the viewer.
const WEAK: f64 = 0.02;
/// Held blocks, and those so many times as large as the other one of a contact, are ground to it: the tube ends at the contact, since the
/// middle of a slab or of a slope is not where the force goes. As in the viewer.
const GROUND: f64 = 3.0;
/// Colours of small forces and of the largest one, as in the viewer.
const COLOURS: [&str; 2] = ["#f7c873", "#8c1313"];
/// The largest force is drawn so wide, and the longest arrow so long: shares of the model's diagonal.
const THICK: f64 = 0.015;
const LONG: f64 = 0.08;
/// Arrows at most: of more, every second, third, ... is drawn.
const ARROWS: usize = 4000;
/// Half of the width of an arrow and of its head, pixels.
const SHAFT: f64 = 0.9;
const HEAD: f64 = 3.2;

fn forces(frame: &Frame) -> Option<&Column> {
    frame.contact_columns.iter().find(|c| c.components == 3 && c.name.contains("force"))
}

/// The vectors of blocks of that name.
pub(super) fn vectors<'f>(frame: &'f Frame, name: &str) -> Option<&'f Column> {
    frame.column(name).filter(|c| c.components == 3)
}

fn longest(column: Option<&Column>) -> f64 {
    let all = column
        .iter()
        .flat_map(|c| c.data.chunks_exact(3))
        .map(|v| Vec3::new(v[0], v[1], v[2]).length());
    all.filter(|l| l.is_finite()).fold(0.0, f64::max)
}

/// The largest contact force of a frame, N, and its longest vector of that name.
pub(super) fn most(frame: &Frame, shot: &Shot) -> [f64; 2] {
    let chains = if shot.chains { longest(forces(frame)) } else { 0.0 };
    let arrows = shot.vectors.as_deref().map_or(0.0, |name| longest(vectors(frame, name)));
    [chains, arrows]
}

/// Unit of the vectors of that name.
///
/// # Errors
/// A frame without them, with those that it has.
pub(super) fn unit_of(frame: &Frame, name: &str) -> Result<String, PlotError> {
    if let Some(column) = vectors(frame, name) {
        return Ok(column.unit.clone());
    }
    let wanted = "give a field of vectors of the run: displacement, velocity or force";
    Err(PlotError::Option { option: "vectors", given: name.to_owned(), wanted })
}

/// What is said of chains and arrows.
pub(super) fn notes(shot: &Shot, [strongest, longest]: [f64; 2], unit: &str) -> Vec<String> {
    let sized = |value: f64| match unit {
        "m" | "m/s" if value < 0.1 => format!("{} m{unit}", super::super::digits(1e3 * value, 3)),
        "N" if value >= 1e3 => format!("{} kN", super::super::digits(1e-3 * value, 3)),
        _ => format!("{} {unit}", super::super::digits(value, 3)),
    };
    let mut out = Vec::new();
    if shot.chains {
        let most = super::super::digits(1e-3 * strongest, 3);
        out.push(format!("contact forces: tubes as thick and dark as they are, up to {most} kN"));
    }
    if let Some(name) = &shot.vectors {
        out.push(format!("arrows: {name}, up to {}", sized(longest)));
    }
    out
}

/// Middle and size of blocks, m, by their numbers.
type Middles = BTreeMap<u32, (Vec3, f64)>;

/// Middles of the blocks as drawn and the diagonals of the boxes around them, m, by their numbers; those of held ones are infinite.
fn middles(frame: &Frame, shot: &Shot) -> Middles {
    let numbers = frame.column("block").map(|c| &c.data);
    let corners = super::drawing::corners(frame, shot);
    let middle = |all: &[Vec3]| {
        let (low, high) = all
            .iter()
            .fold((Vec3::INFINITY, Vec3::NEG_INFINITY), |(l, h), p| (l.min(*p), h.max(*p)));
        (all.iter().sum::<Vec3>() / all.len().max(1) as f64, (high - low).length())
    };
    let number = |i: usize| numbers.and_then(|all| all.get(i)).map_or(i as u32, |n| *n as u32);
    let held = frame.column("held").map(|c| &c.data);
    let is_held = |i: usize| held.and_then(|all| all.get(i)).is_some_and(|v| *v > 0.0);
    let one = |(i, all): (usize, &Vec<Vec3>)| {
        let (at, size) = middle(all);
        (number(i), (at, if is_held(i) { f64::INFINITY } else { size }))
    };
    corners.iter().enumerate().map(one).collect()
}

/// Rods of the chains and arrows of a frame; `most` as [`most`] of all frames, `reach`: the model's diagonal, m.
pub(super) fn rods(
    frame: &Frame,
    shot: &Shot,
    seen: (&Camera, &Window),
    [strongest, longest]: [f64; 2],
    reach: f64,
) -> Vec<Rod> {
    let mut out = Vec::new();
    if strongest <= 0.0 && longest <= 0.0 {
        return out;
    }
    let middles = middles(frame, shot);
    let plane = shot.cut.map(unit);
    let away = |p: Vec3| plane.is_some_and(|(normal, at)| normal.dot(p) > at);
    if strongest > 0.0 {
        let places = super::contacts::places(frame, shot);
        chains(frame, seen, &places, (strongest, reach), (&middles, &away), &mut out);
    }
    if let Some(column) = shot.vectors.as_deref().and_then(|name| vectors(frame, name)) {
        let step = (frame.blocks() / ARROWS).max(1);
        for (v, (_, (from, _))) in column.data.chunks_exact(3).zip(&middles).step_by(step) {
            let way = Vec3::new(v[0], v[1], v[2]);
            let share = way.length() / longest;
            if share.is_nan() || share <= 0.01 || away(*from) {
                continue;
            }
            let way = way * (LONG * reach / longest);
            let neck = *from + 0.72 * way;
            let colour = [24.0; 3];
            out.extend(Rod::between([*from, neck], seen, [SHAFT; 2], colour));
            let head = HEAD * share.max(0.4);
            out.extend(Rod::between([neck, *from + way], seen, [head, 0.3], colour));
        }
    }
    out
}

fn chains(
    frame: &Frame,
    seen: (&Camera, &Window),
    places: &[Vec3],
    (strongest, reach): (f64, f64),
    (middles, away): (&Middles, &dyn Fn(Vec3) -> bool),
    out: &mut Vec<Rod>,
) {
    let column = |name: &str| super::contacts::column(frame, name);
    let (Some(forces), Some(a), Some(b)) = (forces(frame), column("block_a"), column("block_b"))
    else {
        return;
    };
    let [weak, strong] = COLOURS.map(rgb);
    let mut tubes = Vec::new();
    for (i, (v, at)) in forces.data.chunks_exact(3).zip(places).enumerate() {
        let share = Vec3::new(v[0], v[1], v[2]).length() / strongest;
        let at = *at;
        if share.is_nan() || share <= WEAK || !at.is_finite() || away(at) {
            continue;
        }
        let ends = [a, b].map(|side| side.data.get(i).and_then(|n| middles.get(&(*n as u32))));
        for [end, other] in [ends, [ends[1], ends[0]]] {
            let Some((end, size)) = end else { continue };
            let ground = other.is_some_and(|(_, other)| *size > GROUND * other);
            if !ground && !away(*end) {
                tubes.push((share, [at, *end]));
            }
        }
    }
    // The largest last, so that none is hidden by a smaller one.
    tubes.sort_by(|x, y| x.0.total_cmp(&y.0));
    for (share, line) in tubes {
        let half =
            (0.5 * THICK * reach * share * seen.1.zoom / super::wanted::FINE as f64).max(0.5);
        let colour = std::array::from_fn(|k| weak[k] + share * (strong[k] - weak[k]));
        out.extend(Rod::between(line, seen, [half; 2], colour));
    }
}
