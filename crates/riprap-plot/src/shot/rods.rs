//! Bolts in a picture of blocks in space: rods in the colour of their axial force, pale where rock lies before them.

use std::collections::BTreeMap;

use riprap_geom::Vec3;
use riprap_record::frame::Frame;

use super::super::bolts::{colour, forces};
use super::super::solid::bodies;
use super::camera::{Camera, Window};
use super::drawing::{Drawing, unit};
use super::wanted::{FINE, Shot, rgb};

/// Half of the width of a bolt, and of a dark rim beyond what it is around, pixels.
const HALF: f64 = 1.6;
const RIM: f64 = 0.8;
/// Share of the colour of a bolt, and of a tube or an arrow, where rock lies before it.
const PALE: f64 = 0.45;
const SEEN: f64 = 0.8;
/// A bar whose rod has this state is broken.
const BROKEN: f64 = 3.0;

/// What the rods are, in words; `most`: the largest force, N.
pub(super) fn note(most: f64) -> String {
    let most = super::super::digits(1e-3 * most, 3);
    format!(
        "bolts: red in tension, blue in compression, up to {most} kN; grey if broken, pale behind rock"
    )
}

/// A bar as drawn.
pub(super) struct Rod {
    /// In points, with the depth, m.
    ends: [Vec3; 2],
    /// How far its ends are beyond the plane of the cut, m; none is.
    above: [f64; 2],
    /// Half of its width at its ends, pixels.
    half: [f64; 2],
    colour: [f64; 3],
    /// Share of its colour where rock lies before it.
    pale: f64,
}

impl Rod {
    /// One between two places of the model that no cut takes away; `None`: behind the eye.
    pub(super) fn between(
        line: [Vec3; 2],
        seen: (&Camera, &Window),
        half: [f64; 2],
        colour: [f64; 3],
    ) -> Option<Self> {
        Self::laid(line, seen, half, colour, (SEEN, &|_| -1.0))
    }

    /// The same with the share of its colour where rock lies before it, and how far places are beyond the cut, m.
    pub(super) fn laid(
        line: [Vec3; 2],
        (camera, window): (&Camera, &Window),
        half: [f64; 2],
        colour: [f64; 3],
        (pale, above): (f64, &dyn Fn(Vec3) -> f64),
    ) -> Option<Self> {
        let seen = camera.polygon(&line, above);
        let [a, b, ..] = seen[..] else { return None };
        let ends = [a, b].map(|end| window.at(end.0));
        let there = ends.iter().all(|end| end.is_finite());
        there.then_some(Self { ends, above: [a.1, b.1], half, colour, pale })
    }
}

impl Drawing {
    /// Draws the bolts of a frame over the blocks; `most` is the force of full colour, N. Those that are cut away are left out.
    pub(super) fn rods(&mut self, frame: &Frame, shot: &Shot, seen: (&Camera, &Window), most: f64) {
        self.lay(&rods(frame, shot, seen, most), seen.1, RIM);
    }

    /// Draws rods over the blocks, with a dark rim so wide, pixels.
    pub(super) fn lay(&mut self, rods: &[Rod], window: &Window, rim: f64) {
        // The bars of a bolt overlap at their ends, where pale ones must not be painted twice.
        let mut points = BTreeMap::new();
        if rim > 0.0 {
            for rod in rods {
                self.stamp(&mut points, rod, (rim, [26.0; 3]), window);
            }
        }
        for rod in rods {
            self.stamp(&mut points, rod, (0.0, rod.colour), window);
        }
        for (at, (colour, part)) in points {
            for (old, new) in self.colours[at].iter_mut().zip(colour) {
                *old += part * (new - *old);
            }
        }
    }

    /// Gives all points of a rod, and around it nearer than `rim`, pixels, a colour.
    fn stamp(
        &self,
        points: &mut BTreeMap<usize, ([f64; 3], f64)>,
        rod: &Rod,
        (rim, colour): (f64, [f64; 3]),
        window: &Window,
    ) {
        let halves = rod.half.map(|half| (half + rim) * FINE as f64);
        let half = halves[0].max(halves[1]);
        let [a, b] = rod.ends.map(Vec3::truncate);
        let way = b - a;
        let long = way.length_squared();
        let span = |k: usize| {
            let (low, high) = (a[k].min(b[k]) - half, a[k].max(b[k]) + half);
            let last = window.points[k] as f64;
            low.floor().clamp(0.0, last) as usize..high.ceil().clamp(0.0, last) as usize
        };
        for y in span(1) {
            for x in span(0) {
                let p = Vec3::new(x as f64 + 0.5, y as f64 + 0.5, 0.0).truncate();
                let share =
                    if long > 0.0 { ((p - a).dot(way) / long).clamp(0.0, 1.0) } else { 0.0 };
                let mean = |[a, b]: [f64; 2]| a + share * (b - a);
                if (a + share * way).distance(p) > mean(halves) {
                    continue;
                }
                let at = y * self.wide + x;
                let section = self.faces.get(self.nearest[at] as usize).is_some_and(|f| f.section);
                let behind = match section {
                    // The depth is that of the face behind the section.
                    true => mean(rod.above) < -4.0 * window.slack,
                    false => self.depth[at] > mean(rod.ends.map(|end| end.z)) + window.slack,
                };
                let part = if behind { rod.pale } else { 1.0 };
                // What is hidden hides nothing.
                if part > 0.0 {
                    points.insert(at, (colour, part));
                }
            }
        }
    }
}

/// The bars of a frame that are not cut away, ends moved along with their blocks.
fn rods(frame: &Frame, shot: &Shot, (camera, window): (&Camera, &Window), most: f64) -> Vec<Rod> {
    let Some(bolts) = &frame.bolts else { return Vec::new() };
    let column = |name: &str| bolts.columns.iter().find(|c| c.name == name).map(|c| &c.data[..]);
    let sides = [column("block_a"), column("block_b")];
    let states = column("state");
    let factor = shot.options.exaggeration.unwrap_or(1.0);
    let bodies = if factor == 1.0 { Vec::new() } else { bodies(frame) };
    let numbers = frame.column("block").map(|c| &c.data);
    let body = |number: f64| match numbers {
        Some(all) => all.iter().position(|n| *n == number).and_then(|i| bodies.get(i)),
        None => bodies.get(number as usize),
    };
    let moved = |bar: usize, side: usize, p: Vec3| {
        let number = sides[side].and_then(|all| all.get(bar));
        number.and_then(|n| body(*n)).map_or(p, |body| body.moved(body.unmoved(p), factor))
    };
    let plane = shot.cut.map(unit);
    let above = |p: Vec3| plane.map_or(-1.0, |(normal, at)| normal.dot(p) - at - window.slack);
    let mut out = Vec::new();
    for (bar, (ends, force)) in bolts.points.chunks_exact(2).zip(forces(frame)).enumerate() {
        let mut line = [0, 1].map(|side| moved(bar, side, Vec3::from(ends[side])));
        let [from, to] = line.map(above);
        if from > 0.0 && to > 0.0 {
            continue;
        }
        if (from > 0.0) != (to > 0.0) {
            let place = line[0].lerp(line[1], from / (from - to));
            line[usize::from(to > 0.0)] = place;
        }
        let seen = camera.polygon(&line, &above);
        let [a, b, ..] = seen[..] else { continue };
        let broken = states.and_then(|all| all.get(bar)) == Some(&BROKEN);
        let share = if most > 0.0 { force / most } else { 0.0 };
        let colour = if broken { [128.0; 3] } else { rgb(&colour(share)) };
        let (ends, above) = ([a, b].map(|end| window.at(end.0)), [a.1, b.1]);
        out.push(Rod { ends, above, half: [HALF; 2], colour, pale: PALE });
    }
    out
}
