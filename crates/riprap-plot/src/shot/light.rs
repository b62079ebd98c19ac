//! How much light comes to the points of a drawing: from the sky, part of which near faces hide, and from the sun.
//!
//! The sky is that of the viewer: after McGuire and others, The Alchemy screen-space ambient obscurance algorithm (2011), from the depths of
//! the points around. For the sun the blocks are drawn once more as it sees them (Williams, Casting curved shadows on curved surfaces,
//! 1978), and several of its points are compared.

use riprap_geom::Vec3;
use riprap_record::frame::Frame;

use super::camera::{Camera, Window};
use super::drawing::Drawing;
use super::wanted::{FINE, Shot};

/// To the sun, in the axes of the camera: over the left shoulder.
const SUN: [f64; 3] = [-0.45, 0.62, 0.64];
/// Shares of a colour that come from the sky, from a lamp at the eye and from the sun.
const SKY: f64 = 0.6;
const LAMP: f64 = 0.16;
const SUNLIGHT: f64 = 0.36;
/// Samples of the sky around a point, and of the sun.
const SAMPLES: usize = 14;
const SUNS: usize = 8;
/// Points along a side of the picture from the sun.
const FROM_SUN: u32 = 1000;
/// Turns of the samples, in a square of so many points a side, over which their mean is taken.
const TURNS: usize = 4;

/// Light at each point of the picture (not of the finer drawing): shares of sky and sun.
pub(super) struct Light {
    wide: usize,
    of: Vec<[f64; 2]>,
    sun: Vec3,
}

/// Direction to the sun in the axes of the camera.
fn sun() -> Vec3 {
    Vec3::from(SUN).normalize()
}

impl Light {
    /// Everywhere the same: what looks at the sun is lit.
    pub(super) fn even() -> Self {
        Self { wide: 0, of: Vec::new(), sun: sun() }
    }

    /// Light on a drawing. `size`: of a usual block, m.
    pub(super) fn on(
        drawing: &Drawing,
        frame: &Frame,
        shot: &Shot,
        (camera, window): (&Camera, &Window),
        size: f64,
    ) -> Self {
        let [wide, high] = window.points.map(|side| side / FINE);
        let place = |x: usize, y: usize| -> Option<Vec3> {
            let at = FINE * y * window.points[0] + FINE * x;
            let depth = *drawing.depth.get(at)?;
            let p = Vec3::new((FINE * x) as f64 + 0.5, (FINE * y) as f64 + 0.5, depth);
            depth.is_finite().then(|| camera.place(window.back(p)))
        };
        let reach = size.max(0.02 * window.reach());
        let shadows = Shadows::of(frame, shot, camera, window.reach());
        let mut raw = vec![[1.0; 2]; wide * high];
        for y in 0..high {
            for x in 0..wide {
                let face = drawing.face_at(FINE * x, FINE * y);
                let (Some(p), Some(face)) = (place(x, y), face) else { continue };
                if face.plain {
                    continue;
                }
                let turn = ((x % TURNS + TURNS * (y % TURNS)) * 7 % 16) as f64 / 16.0;
                let turn = std::f64::consts::TAU * turn;
                let radius = (reach * window.scale(camera, p) / FINE as f64).clamp(2.0, 60.0);
                let mut hidden = 0.0;
                for i in 0..SAMPLES {
                    let share = (i as f64 + 0.5) / SAMPLES as f64;
                    let (sin, cos) = (turn + 2.399_963 * i as f64).sin_cos();
                    let [u, v] = [cos, sin].map(|s| (radius * share * s).round());
                    let (u, v) = (x as f64 + u, y as f64 + v);
                    if u < 0.0 || v < 0.0 || u >= wide as f64 || v >= high as f64 {
                        continue;
                    }
                    let Some(q) = place(u as usize, v as usize) else { continue };
                    let way = q - p;
                    let near = (1.0 - way.length_squared() / (reach * reach)).max(0.0);
                    let up = way.dot(face.normal) / way.length().max(1e-6 * reach);
                    hidden += near * (up - 0.12).max(0.0);
                }
                let sky = (1.0 - 2.1 * hidden / SAMPLES as f64).clamp(0.0, 1.0);
                raw[y * wide + x] = [sky, shadows.share(camera.world(p), face.normal, turn)];
            }
        }
        Self { wide, of: smooth(&raw, drawing, [wide, high]), sun: sun() }
    }

    /// Share of its colour that a face shows at a point of the drawing.
    pub(super) fn share(&self, normal: Vec3, at: [usize; 2]) -> f64 {
        let [x, y] = at.map(|v| v / FINE);
        let [sky, sun] = self.of.get(y * self.wide + x).copied().unwrap_or([1.0; 2]);
        let sun = sun * SUNLIGHT * normal.dot(self.sun).max(0.0);
        ((0.3 + 0.7 * sky) * (SKY + LAMP * normal.z.abs()) + (0.5 + 0.5 * sky) * sun).min(1.0)
    }
}

/// The mean over all turns of the samples, of what belongs to one plane.
fn smooth(raw: &[[f64; 2]], drawing: &Drawing, [wide, high]: [usize; 2]) -> Vec<[f64; 2]> {
    let half = TURNS / 2;
    let mut out = raw.to_vec();
    for y in 0..high {
        for x in 0..wide {
            let Some(own) = drawing.face_at(FINE * x, FINE * y) else { continue };
            let (mut sum, mut count) = ([0.0; 2], 0.0);
            for v in y.saturating_sub(half)..(y + half).min(high) {
                for u in x.saturating_sub(half)..(x + half).min(wide) {
                    let face = drawing.face_at(FINE * u, FINE * v);
                    if face.is_some_and(|f| !f.plain && f.normal.dot(own.normal) > 0.9) {
                        let [sky, sun] = raw[v * wide + u];
                        sum = [sum[0] + sky, sum[1] + sun];
                        count += 1.0;
                    }
                }
            }
            if count > 0.0 {
                out[y * wide + x] = sum.map(|s| s / count);
            }
        }
    }
    out
}

/// The blocks as the sun sees them.
struct Shadows {
    camera: Camera,
    window: Window,
    depth: Vec<f64>,
    wide: usize,
    /// Width of a point, m.
    point: f64,
}

impl Shadows {
    fn of(frame: &Frame, shot: &Shot, seen: &Camera, reach: f64) -> Self {
        let way = seen.world_way(sun());
        let other = if way.z.abs() < 0.9 { Vec3::Z } else { Vec3::X };
        let right = other.cross(way).normalize();
        let axes = [right, way.cross(right), way];
        let (mut low, mut high) = (Vec3::INFINITY, Vec3::NEG_INFINITY);
        for p in super::drawing::corners(frame, shot).iter().flatten().filter(|p| p.is_finite()) {
            let along = Vec3::from(axes.map(|axis| axis.dot(*p)));
            (low, high) = (low.min(along), high.max(along));
        }
        let size = [FROM_SUN; 2];
        let eye = super::wanted::Eye::From { direction: [0.0; 2], angle: None };
        let (camera, window) = super::camera::fitted(&eye, axes, [low, high], size);
        let drawing = Drawing::of(frame, shot, (&camera, &window));
        let point = (1.0 / window.zoom).max(1e-9 * reach);
        Self { depth: drawing.depth, wide: window.points[0], camera, window, point }
    }

    /// Share of the sun that comes to a place of a face; `normal` in the axes of the picture's camera.
    fn share(&self, place: Vec3, normal: Vec3, turn: f64) -> f64 {
        if normal.dot(sun()) <= 0.0 {
            return 0.0;
        }
        let at = self.window.at(self.camera.turned(place));
        // A face that the sun grazes is steep in depth.
        let steep = (1.0 / normal.dot(sun()).max(0.15)).min(6.0);
        let bias = 3.5 * steep * self.point;
        let mut lit = 0.0;
        for i in 0..SUNS {
            let (sin, cos) = (turn + std::f64::consts::TAU * i as f64 / SUNS as f64).sin_cos();
            let far = if i % 2 == 0 { 1.2 } else { 3.0 };
            let (x, y) = (at.x + far * cos, at.y + far * sin);
            let inside = x >= 0.0 && y >= 0.0 && (x as usize) < self.wide;
            let depth = inside.then(|| self.depth.get(y as usize * self.wide + x as usize));
            if depth.flatten().is_none_or(|depth| *depth <= at.z + bias) {
                lit += 1.0;
            }
        }
        lit / SUNS as f64
    }
}
