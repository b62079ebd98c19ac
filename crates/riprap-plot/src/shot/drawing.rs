//! The nearest face at each point, and its colour.

use riprap_geom::Vec3;
use riprap_record::frame::Frame;

use super::super::solid::bodies;
use super::camera::{Camera, Window};
use super::light::Light;
use super::wanted::{Cut, Shot};

/// Faces of a block whose normals have a smaller cosine than this have an edge between them.
const EDGE: f64 = 0.95;
/// The same of ground from a survey, of which only breaks of the slope are drawn.
const SLOPE: f64 = 0.766;
/// A face that lies in a cut, within this share of its size, is seen as a section.
const IN_CUT: f64 = 0.03;
/// With fewer points than this for a block, edges would hide the colours.
const CROWDED: usize = 40;
/// Nothing is drawn here.
const NONE: u32 = u32::MAX;

/// Corners of each block as drawn, m.
pub(super) fn corners(frame: &Frame, shot: &Shot) -> Vec<Vec<Vec3>> {
    let factor = shot.options.exaggeration.unwrap_or(1.0);
    let bodies = bodies(frame);
    let place = |i: usize, p: &[f64; 3]| match factor {
        1.0 => Vec3::from(*p),
        _ => bodies[i].moved(bodies[i].unmoved(Vec3::from(*p)), factor),
    };
    (0..frame.blocks()).map(|i| frame.outline(i).iter().map(|p| place(i, p)).collect()).collect()
}

/// Blocks with more faces than this are ground from a survey, as in the viewer.
const SURVEY: usize = 300;

/// Whether a block is ground from a survey.
pub(super) fn is_survey(frame: &Frame, block: usize) -> bool {
    frame.solids.as_ref().is_some_and(|solids| solids.of(block).len() > SURVEY)
}

/// Edge of a usual block, m: the median of the diagonals of their boxes over the root of 3.
pub(super) fn usual(frame: &Frame) -> f64 {
    let mut sizes: Vec<f64> = (0..frame.blocks())
        .map(|i| {
            let corners = frame.outline(i).iter().map(|p| Vec3::from(*p));
            let (low, high) = corners
                .fold((Vec3::INFINITY, Vec3::NEG_INFINITY), |(l, h), p| (l.min(p), h.max(p)));
            (high - low).length() / 3.0_f64.sqrt()
        })
        .filter(|size| size.is_finite())
        .collect();
    sizes.sort_by(f64::total_cmp);
    sizes.get(sizes.len() / 2).copied().unwrap_or(1.0)
}

/// A face that is drawn.
pub(super) struct Face {
    pub(super) block: u32,
    /// In the axes of the camera.
    pub(super) normal: Vec3,
    /// It looks away: what is seen is the section of its block.
    pub(super) section: bool,
    /// It has the plain colour of its block: a section, or a face in the cut.
    pub(super) plain: bool,
    /// Faces whose normals have a smaller cosine have an edge between them.
    edge: f64,
}

/// The drawing.
pub(super) struct Drawing {
    pub(super) faces: Vec<Face>,
    pub(super) nearest: Vec<u32>,
    pub(super) depth: Vec<f64>,
    pub(super) colours: Vec<[f64; 3]>,
    pub(super) wide: usize,
}

impl Drawing {
    pub(super) fn of(frame: &Frame, shot: &Shot, (camera, window): (&Camera, &Window)) -> Self {
        let [wide, high] = window.points;
        let (nearest, depth) = (vec![NONE; wide * high], vec![f64::NEG_INFINITY; wide * high]);
        let mut drawing = Self { faces: Vec::new(), nearest, depth, colours: Vec::new(), wide };
        let plane = shot.cut.map(unit);
        for (i, corners) in corners(frame, shot).iter().enumerate() {
            let edge = if is_survey(frame, i) { SLOPE } else { EDGE };
            for face in frame.solids.iter().flat_map(|solids| solids.of(i)) {
                let line: Vec<Vec3> = face.iter().map(|c| corners[*c as usize]).collect();
                let normal = camera.turned(newell(&line));
                let above = |slack: f64| {
                    move |p: Vec3| plane.map_or(-1.0, |(normal, at)| normal.dot(p) - at - slack)
                };
                // Of a cut along faces the block behind it is seen, not the one that is cut away.
                let seen = camera.polygon(&line, &above(window.slack));
                let away = newell_of(&seen).z <= 0.0;
                if away && plane.is_none() {
                    continue;
                }
                // What bounds a block is nearer than what touches it from behind.
                let (nearer, seen) = match away {
                    true => (window.slack, camera.polygon(&line, &above(-2.0 * window.slack))),
                    false => (0.0, seen),
                };
                let normal = match plane {
                    Some((plane, _)) if away => camera.turned(plane),
                    _ => normal,
                };
                let plain = away || plane.is_some_and(|plane| lies_in(&line, plane));
                drawing.faces.push(Face { block: i as u32, normal, section: away, plain, edge });
                for pair in seen.windows(2).skip(1) {
                    let three = [seen[0], pair[0], pair[1]];
                    drawing.triangle(
                        three.map(|(p, _)| p + nearer * Vec3::Z),
                        three.map(|c| c.1),
                        window,
                    );
                }
            }
        }
        drawing
    }

    /// Draws a triangle of the last face where `above`, given at its corners, is not positive.
    fn triangle(&mut self, corners: [Vec3; 3], above: [f64; 3], window: &Window) {
        let [a, b, c] = corners.map(|corner| window.at(corner));
        let twice = (b - a).truncate().perp_dot((c - a).truncate());
        if !(twice.abs() > 0.0 && twice.is_finite()) {
            return;
        }
        let span = |k: usize| {
            let ends = [a[k], b[k], c[k]];
            let low = ends.iter().copied().fold(f64::INFINITY, f64::min);
            let high = ends.iter().copied().fold(f64::NEG_INFINITY, f64::max);
            let last = window.points[k] as f64;
            (low - 0.5).ceil().clamp(0.0, last) as usize
                ..(high + 0.5).floor().clamp(0.0, last) as usize
        };
        let number = self.faces.len() as u32 - 1;
        for y in span(1) {
            for x in span(0) {
                let p = Vec3::new(x as f64 + 0.5, y as f64 + 0.5, 0.0).truncate();
                let share = |from: Vec3, to: Vec3| {
                    (to.truncate() - from.truncate()).perp_dot(p - from.truncate()) / twice
                };
                let shares = [share(b, c), share(c, a), share(a, b)];
                let mean =
                    |of: [f64; 3]| -> f64 { shares.iter().zip(of).map(|(s, v)| s * v).sum() };
                let depth = mean([a.z, b.z, c.z]);
                let at = y * self.wide + x;
                let inside = shares.iter().all(|s| *s >= 0.0) && mean(above) <= 0.0;
                if inside && depth > self.depth[at] {
                    (self.depth[at], self.nearest[at]) = (depth, number);
                }
            }
        }
    }

    /// Whether an edge lies between two points.
    fn edge(&self, one: usize, other: usize) -> bool {
        let [a, b] = [one, other].map(|at| self.faces.get(self.nearest[at] as usize));
        match (a, b) {
            (Some(a), Some(b)) => a.block != b.block || a.normal.dot(b.normal) < a.edge,
            (None, None) => false,
            (Some(_), None) | (None, Some(_)) => true,
        }
    }

    /// The face that is seen at a point.
    pub(super) fn face_at(&self, x: usize, y: usize) -> Option<&Face> {
        self.faces.get(*self.nearest.get(y * self.wide + x)? as usize)
    }

    /// Gives each point its red, green and blue, by the colours of the blocks. Sections have these plainly, to be read off.
    pub(super) fn paint(&mut self, of: &[[f64; 3]], light: &Light) {
        let face = |at: &u32| self.faces.get(*at as usize);
        let paint = |(k, at): (usize, &u32)| match face(at) {
            Some(face) if face.plain => of[face.block as usize],
            Some(face) => {
                let share = light.share(face.normal, [k % self.wide, k / self.wide]);
                of[face.block as usize].map(|part| share * part)
            }
            None => [255.0; 3],
        };
        let mut colours: Vec<[f64; 3]> = self.nearest.iter().enumerate().map(paint).collect();
        let seen = self.nearest.iter().filter(|at| **at != NONE).count();
        let mut blocks: Vec<u32> =
            self.nearest.iter().filter_map(|at| Some(face(at)?.block)).collect();
        blocks.sort_unstable();
        blocks.dedup();
        if seen >= CROWDED * blocks.len() {
            self.edges(&mut colours);
        }
        self.colours = colours;
    }

    fn edges(&self, colours: &mut [[f64; 3]]) {
        for at in 0..self.nearest.len() {
            let right = ((at + 1) % self.wide != 0).then_some(at + 1);
            let below = Some(at + self.wide).filter(|below| *below < self.nearest.len());
            for other in [right, below].into_iter().flatten().filter(|other| self.edge(at, *other))
            {
                colours[at] = [40.0; 3];
                colours[other] = [40.0; 3];
            }
        }
    }

    /// Red, green and blue at a point that was painted.
    pub(super) fn colour(&self, x: usize, y: usize) -> [f64; 3] {
        self.colours[y * self.wide + x]
    }
}

/// Unit normal and place of a plane.
pub(super) fn unit(cut: Cut) -> (Vec3, f64) {
    let normal = Vec3::from(cut.normal);
    let long = normal.length();
    (normal / long, cut.at / long)
}

/// Whether a face lies in a plane.
fn lies_in(line: &[Vec3], (normal, at): (Vec3, f64)) -> bool {
    let size = line.iter().map(|p| p.distance(line[0])).fold(0.0, f64::max);
    line.iter().all(|p| (normal.dot(*p) - at).abs() <= IN_CUT * size)
}

/// Unit normal of a face, by Newell's sum.
fn newell(line: &[Vec3]) -> Vec3 {
    let next = line.iter().cycle().skip(1);
    let sum = line
        .iter()
        .zip(next)
        .fold(Vec3::ZERO, |sum, (a, b)| sum + (*a - line[0]).cross(*b - line[0]));
    sum.normalize_or_zero()
}

/// The same in the picture.
fn newell_of(seen: &[(Vec3, f64)]) -> Vec3 {
    let line: Vec<Vec3> = seen.iter().map(|(p, _)| *p).collect();
    newell(&line)
}
