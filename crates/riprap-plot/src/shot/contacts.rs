//! Contacts as points, coloured by state.

use std::collections::BTreeMap;

use riprap_geom::Vec3;
use riprap_record::contacts::{STATES, states};
use riprap_record::frame::{Column, Frame};

use super::super::foot::Piece;
use super::camera::{Camera, Window};
use super::drawing::unit;
use super::rods::Rod;
use super::wanted::{Shot, rgb};

/// Colours of the states by their numbers, those of the viewer.
const COLOURS: [&str; STATES.len()] =
    ["#4b8fd6", "#f0a020", "#3aa88f", "#e0483e", "#d62728", "#2c4fb8", "#b05cd0", "#c062a8"];
/// Half of the width of a point, pixels, and the share of its colour where rock lies before it.
const HALF: f64 = 2.5;
const PALE: f64 = 0.45;

/// Numbers of a contact.
pub(super) fn column<'f>(frame: &'f Frame, name: &str) -> Option<&'f Column> {
    frame.contact_columns.iter().find(|c| c.name == name && c.components == 1)
}

/// Where contacts are drawn, m: with the exaggerated displacement of the first block.
pub(super) fn places(frame: &Frame, shot: &Shot) -> Vec<Vec3> {
    let places = frame.contact_points.iter().map(|p| Vec3::from(*p));
    let more = shot.options.exaggeration.unwrap_or(1.0) - 1.0;
    let shifts = frame.column("displacement").filter(|c| c.components == 3 && more != 0.0);
    let (Some(shifts), Some(first)) = (shifts, column(frame, "block_a")) else {
        return places.collect();
    };
    let numbers = frame.column("block").map(|c| &c.data);
    let number = |i: usize| numbers.and_then(|all| all.get(i)).map_or(i as u32, |n| *n as u32);
    let shifts = shifts.data.chunks_exact(3).map(Vec3::from_slice);
    let of: BTreeMap<u32, Vec3> = shifts.enumerate().map(|(i, v)| (number(i), v)).collect();
    let shift = |i: usize| first.data.get(i).and_then(|block| of.get(&(*block as u32)));
    places.enumerate().map(|(i, p)| p + more * *shift(i).unwrap_or(&Vec3::ZERO)).collect()
}

/// How many contacts of a frame are in each state.
pub(super) fn counts(frame: &Frame) -> [usize; STATES.len()] {
    let mut out = [0; STATES.len()];
    for state in states(&frame.contact_columns, frame.contact_points.len()).0 {
        out[usize::from(state)] += 1;
    }
    out
}

/// What is said of the points; `most`: as [`counts`], the largest of all frames.
pub(super) fn note(shot: &Shot, most: &[usize; STATES.len()], frames: usize) -> Vec<Piece> {
    let Some(wanted) = shot.contacts else { return Vec::new() };
    let there = (0..STATES.len()).filter(|k| wanted[*k] && most[*k] > 0);
    let one = |k: usize| {
        let upto = if frames > 1 { "up to " } else { "" };
        Piece { colour: Some(COLOURS[k]), text: format!("{} {upto}{}", STATES[k], most[k]) }
    };
    let chips: Vec<Piece> = there.map(one).collect();
    let text = match (most.iter().sum::<usize>(), chips.len()) {
        (0, _) => "contacts: the frames have none",
        (_, 0) => "contacts: none slides, has broken or is open",
        (_, _) => "contacts, pale behind rock:",
    };
    std::iter::once(Piece::plain(text)).chain(chips).collect()
}

/// Points of the contacts in the wanted states, the worst state last.
pub(super) fn rods(frame: &Frame, shot: &Shot, seen: (&Camera, &Window)) -> Vec<Rod> {
    let Some(wanted) = shot.contacts else { return Vec::new() };
    let plane = shot.cut.map(unit);
    let above = |p: Vec3| plane.map_or(-1.0, |(normal, at)| normal.dot(p) - at);
    let (states, _) = states(&frame.contact_columns, frame.contact_points.len());
    let mut points: Vec<(u8, Vec3)> = states.into_iter().zip(places(frame, shot)).collect();
    points.retain(|(state, at)| wanted[usize::from(*state)] && at.is_finite() && above(*at) <= 0.0);
    points.sort_by_key(|(state, _)| *state);
    let rod = |(state, at): (u8, Vec3)| {
        Rod::laid([at; 2], seen, [HALF; 2], rgb(COLOURS[usize::from(state)]), (PALE, &above))
    };
    points.into_iter().filter_map(rod).collect()
}
