//! Trails: the ways that blocks have taken from frame to frame, as lines up to the frame that is drawn.

use std::collections::BTreeMap;

use riprap_geom::Vec3;
use riprap_record::frame::Frame;

use super::super::drawing::choose;
use super::super::solid::{Body, bodies};
use super::super::{PlotError, colour};
use super::camera::{Camera, Window};
use super::drawing::{unit, usual};
use super::rods::Rod;
use super::wanted::{Shot, Trails, rgb};

/// A block that has gone farther than this share of a usual block has moved, as in the viewer.
const MOVED: f64 = 0.25;
/// Trails at most: of more blocks, those that went farthest.
const MOST: usize = 1500;
/// Half of the width, pixels.
const HALF: f64 = 1.25;

/// The way of a block from one frame to the next.
struct Piece {
    /// Step of the frame that it ends in.
    step: u64,
    /// As drawn, m.
    ends: [Vec3; 2],
    /// Mean speed, m/s; 0 where model time does not pass.
    speed: f64,
    block: u32,
}

/// The trails of a run.
pub(super) struct Ways {
    pieces: Vec<Piece>,
    count: usize,
    left: usize,
    fastest: f64,
    by_block: bool,
}

/// Blocks of a frame by their numbers.
fn numbered(frame: &Frame) -> impl Iterator<Item = (u32, Body)> {
    let numbers = frame.column("block").map(|c| c.data.clone());
    let number =
        move |i: usize| numbers.as_ref().and_then(|n| n.get(i)).map_or(i as u32, |n| *n as u32);
    bodies(frame).into_iter().enumerate().map(move |(i, body)| (number(i), body))
}

impl Ways {
    /// Those of all frames of a run, which are read twice: a large run does not fit into memory.
    ///
    /// # Errors
    /// Frames that cannot be read or have no displacement.
    pub(super) fn of<I: Iterator<Item = Result<Frame, PlotError>>>(
        frames: impl Fn() -> I,
        shot: &Shot,
        wanted: Trails,
    ) -> Result<Self, PlotError> {
        let (mut far, mut least) = (BTreeMap::new(), 0.0);
        for frame in frames() {
            let frame = frame?;
            choose(&frame, "displacement")?;
            least = MOVED * usual(&frame);
            for (block, body) in numbered(&frame) {
                let long = body.displacement.length();
                let of = far.entry(block).or_insert(0.0_f64);
                *of = of.max(if long.is_finite() { long } else { 0.0 });
            }
        }
        match wanted.only {
            Some(only) => far.retain(|block, _| *block == only),
            None => far.retain(|_, way| *way > least),
        }
        let mut order: Vec<(u32, f64)> = far.into_iter().collect();
        order.sort_by(|a, b| b.1.total_cmp(&a.1).then(a.0.cmp(&b.0)));
        let left = order.len().saturating_sub(MOST);
        order.truncate(MOST);
        let count = order.len();
        // Where each was last: as drawn, truly, and when.
        let mut last: BTreeMap<u32, Option<(Vec3, Vec3, f64)>> =
            order.into_iter().map(|(block, _)| (block, None)).collect();
        let factor = shot.options.exaggeration.unwrap_or(1.0);
        let mut pieces = Vec::new();
        for frame in frames() {
            let frame = frame?;
            for (block, body) in numbered(&frame).filter(|(_, body)| body.now.is_finite()) {
                let Some(before) = last.get_mut(&block) else { continue };
                let drawn = body.start() + factor * body.displacement;
                if let Some((from, place, time)) = *before {
                    let took = frame.time - time;
                    let speed = if took > 0.0 { place.distance(body.now) / took } else { 0.0 };
                    pieces.push(Piece { step: frame.step, ends: [from, drawn], speed, block });
                }
                *before = Some((drawn, body.now, frame.time));
            }
        }
        let fastest = pieces.iter().map(|piece| piece.speed).fold(0.0, f64::max);
        Ok(Self { pieces, count, left, fastest, by_block: wanted.by_block })
    }

    /// What is said of them.
    pub(super) fn note(&self) -> String {
        let Self { count, left, .. } = self;
        if self.pieces.is_empty() {
            return "trails: no block has moved by a quarter of a block".to_owned();
        }
        let blocks = if *count == 1 {
            "trail of 1 block".into()
        } else {
            format!("trails of {count} blocks")
        };
        let more =
            if *left > 0 { format!(" ({left} more that moved less)") } else { String::new() };
        if self.by_block || self.fastest == 0.0 {
            return format!("{blocks}{more}");
        }
        let fastest = super::super::digits(self.fastest, 3);
        format!("{blocks}{more}, from slow (blue) to fast (red), up to {fastest} m/s")
    }

    /// Those up to a frame; rock hides them.
    pub(super) fn rods(&self, frame: &Frame, shot: &Shot, seen: (&Camera, &Window)) -> Vec<Rod> {
        let plane = shot.cut.map(unit);
        let above = |p: Vec3| plane.map_or(-1.0, |(normal, at)| normal.dot(p) - at);
        let colour = |piece: &Piece| match self.by_block {
            true => rgb(colour::kind(f64::from(piece.block))),
            false => {
                let share = if self.fastest > 0.0 { piece.speed / self.fastest } else { 0.0 };
                colour::turbo(0.05 + 0.9 * share)
            }
        };
        let there = self.pieces.iter().filter(|piece| piece.step <= frame.step);
        let rod = |p: &Piece| Rod::laid(p.ends, seen, [HALF; 2], colour(p), (0.0, &above));
        there.filter_map(rod).collect()
    }
}
