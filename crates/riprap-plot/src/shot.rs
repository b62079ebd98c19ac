//! Blocks in space as they stand, without a browser: a parallel projection, drawn point by point by its depth.
//!
//! Faces that look away are left out. Behind a cut they are not: as blocks do not overlap, a point whose nearest face looks away lies in a
//! block that the cut goes through, and has the plain colour of that block.

use std::path::{Path, PathBuf};

use resvg::tiny_skia::{ColorU8, Pixmap};
use riprap_geom::Vec3;
use riprap_record::frame::Frame;
use riprap_record::manifest::Manifest;
use riprap_record::write_whole;

use super::blocks::{bar, chips, colours};
use super::colour;
use super::drawing::{BlockOptions, Chosen, Normal, choose};
use super::frames::{Which, listed, load_frame, moment};
use super::section::need_space;
use super::solid::bodies;
use super::svg::Page;
use super::{Look, PlotError, suffix};

/// Points of the drawing along a side of a point of the picture.
const FINE: usize = 2;
/// Room for the legend and for the title, pixels.
const LEGEND: f64 = 140.0;
const TITLE: f64 = 34.0;
/// Most points along a side of the picture.
const MOST: u32 = 8000;
/// Share of the picture that stays free around the model.
const MARGIN: f64 = 0.04;
/// Faces of a block whose normals have a smaller cosine than this have an edge between them.
const EDGE: f64 = 0.95;
/// With fewer points than this for a block, edges would hide the colours.
const CROWDED: usize = 40;
/// Nothing is drawn here.
const NONE: u32 = u32::MAX;

/// What is drawn, and from where.
#[derive(Clone, Debug, PartialEq)]
pub struct Shot {
    /// Field that colours the blocks: one of amounts, `block` or `material`.
    pub field: String,
    /// Where the eye stands: clockwise from north (y), and above the horizon, deg.
    pub eye: [f64; 2],
    /// Width and height of the model's part of the picture, pixels.
    pub size: [u32; 2],
    /// Where the side nearer to the eye is cut away: normal and place along it, m.
    pub cut: Option<(Normal, f64)>,
    /// Of these range, percentiles, scale and exaggeration.
    pub options: BlockOptions,
}

/// Draws frames of a run in space as PNG, all of them where none is named; several with one window and one range of colours, numbered.
///
/// # Errors
/// A run in the plane, unknown fields, options without sense, files that cannot be read or written.
pub fn shots(
    folder: &Path,
    frames: &[Which],
    shot: &Shot,
    out: &Path,
) -> Result<Vec<PathBuf>, PlotError> {
    shot.checked()?;
    let manifest = Manifest::read(folder)?;
    let all: Vec<Which> = match frames {
        [] => (1..=listed(folder)?.len()).map(Which::Index).collect(),
        some => some.to_vec(),
    };
    let camera = Camera::new(shot.eye);
    let (mut low, mut high) = (Vec3::INFINITY, Vec3::NEG_INFINITY);
    let mut values = Vec::new();
    for which in &all {
        let frame = load_frame(folder, *which)?;
        need_space(&frame, "blocks in space")?;
        values.extend(choose(&frame, &shot.field)?.values);
        for corner in camera.corners(&frame, shot).iter().flatten().filter(|c| c.is_finite()) {
            (low, high) = (low.min(*corner), high.max(*corner));
        }
    }
    let window = Window::around(low, high, shot.size);
    let mut written = Vec::new();
    for (number, which) in (1..).zip(&all) {
        let frame = load_frame(folder, *which)?;
        let chosen = choose(&frame, &shot.field)?;
        let suffix = suffix(&manifest, &moment(folder, &frame)?);
        let words = [manifest.title.as_str(), &suffix];
        let png = picture(&frame, &chosen, (&values, &manifest.materials), words, shot, &window)?;
        let path = match all.len() {
            1 => out.to_owned(),
            _ => numbered(out, number),
        };
        write_whole(&path, &png)?;
        written.push(path);
    }
    Ok(written)
}

/// `a.png` as `a_0007.png`.
fn numbered(out: &Path, number: usize) -> PathBuf {
    let stem = out.file_stem().map_or_else(String::new, |s| s.to_string_lossy().into_owned());
    out.with_file_name(format!("{stem}_{number:04}.png"))
}

impl Shot {
    fn checked(&self) -> Result<(), PlotError> {
        self.options.checked()?;
        let wrong = |option, given, wanted| Err(PlotError::Option { option, given, wanted });
        let [azimuth, above] = self.eye;
        if !azimuth.is_finite() || !(-90.0..=90.0).contains(&above) {
            let given = format!("{azimuth} {above}");
            return wrong("view", given, "give an azimuth and an elevation from -90 to 90 degrees");
        }
        if self.size.iter().any(|side| !(16..=MOST).contains(side)) {
            let given = format!("{} {}", self.size[0], self.size[1]);
            return wrong("size", given, "give a width and a height from 16 to 8000 pixels");
        }
        match self.cut {
            Some((_, at)) if !at.is_finite() => {
                wrong("at", at.to_string(), "give a position along the normal in m")
            }
            Some(_) | None => Ok(()),
        }
    }
}

/// Unit vectors to the right, upwards and to the eye.
struct Camera([Vec3; 3]);

impl Camera {
    fn new([azimuth, above]: [f64; 2]) -> Self {
        let (sin, cos) = azimuth.to_radians().sin_cos();
        let (up, level) = above.to_radians().sin_cos();
        // From straight above, the azimuth is down in the picture.
        let right = Vec3::new(-cos, sin, 0.0);
        let eye = Vec3::new(level * sin, level * cos, up);
        Self([right, eye.cross(right), eye])
    }

    /// Corners of each block to the right, upwards and towards the eye, m.
    fn corners(&self, frame: &Frame, shot: &Shot) -> Vec<Vec<Vec3>> {
        let factor = shot.options.exaggeration.unwrap_or(1.0);
        let bodies = bodies(frame);
        let place = |i: usize, p: &[f64; 3]| match factor {
            1.0 => Vec3::from(*p),
            _ => bodies[i].moved(bodies[i].unmoved(Vec3::from(*p)), factor),
        };
        let seen = |p: Vec3| Vec3::from(self.0.map(|axis| axis.dot(p)));
        (0..frame.blocks())
            .map(|i| frame.outline(i).iter().map(|p| seen(place(i, p))).collect())
            .collect()
    }
}

/// From metres to points of the drawing.
struct Window {
    low: Vec3,
    high: Vec3,
    zoom: f64,
    /// Points to the right and downwards.
    points: [usize; 2],
}

impl Window {
    fn around(low: Vec3, high: Vec3, size: [u32; 2]) -> Self {
        let points = size.map(|side| FINE * side as usize);
        let room = |k: usize| (1.0 - 2.0 * MARGIN) * points[k] as f64 / (high[k] - low[k]);
        Self { low, high, zoom: room(0).min(room(1)), points }
    }

    /// To the right and downwards, points; towards the eye, m.
    fn at(&self, corner: Vec3) -> Vec3 {
        let middle = 0.5 * (self.low + self.high);
        let half = self.points.map(|side| 0.5 * side as f64);
        let away = self.zoom * (corner - middle);
        Vec3::new(half[0] + away.x, half[1] - away.y, corner.z)
    }
}

/// A face that is drawn.
struct Face {
    block: u32,
    normal: Vec3,
    /// Share of the colour of its block.
    light: f64,
}

/// The drawing: the nearest face at each point.
struct Drawing {
    faces: Vec<Face>,
    nearest: Vec<u32>,
    depth: Vec<f64>,
    wide: usize,
}

impl Drawing {
    fn of(frame: &Frame, shot: &Shot, window: &Window) -> Self {
        let camera = Camera::new(shot.eye);
        let [wide, high] = window.points;
        let (nearest, depth) = (vec![NONE; wide * high], vec![f64::NEG_INFINITY; wide * high]);
        let mut drawing = Self { faces: Vec::new(), nearest, depth, wide };
        // A plane in the axes of the picture, what lies above it is cut away.
        let cut = shot.cut.map(|(normal, at)| {
            let axis = Vec3::AXES[normal.index()];
            let side = if camera.0[2].dot(axis) < 0.0 { -1.0 } else { 1.0 };
            (side * Vec3::from(camera.0.map(|seen| seen.dot(axis))), side * at)
        });
        // Of a cut along faces the block behind it is seen, not the one that is cut away.
        let slack = 1e-6 * (window.high - window.low).length();
        let sun = Vec3::new(0.3, 0.5, 0.8).normalize();
        for (i, corners) in camera.corners(frame, shot).iter().enumerate() {
            for face in frame.solids.iter().flat_map(|solids| solids.of(i)) {
                let line: Vec<Vec3> = face.iter().map(|c| corners[*c as usize]).collect();
                let normal = newell(&line);
                let away = normal.z <= 0.0;
                let normal = match cut {
                    _ if !away => normal,
                    Some((plane, _)) => plane,
                    None => continue,
                };
                let light = if away { 1.0 } else { 0.62 + 0.38 * normal.dot(sun).max(0.0) };
                drawing.faces.push(Face { block: i as u32, normal, light });
                // What bounds a block is nearer than what touches it from behind.
                let (nearer, beside) = if away { (slack, -2.0 * slack) } else { (0.0, slack) };
                let line: Vec<Vec3> = line.iter().map(|p| *p + nearer * Vec3::Z).collect();
                let beside = cut.map(|(plane, at)| (plane, at + beside));
                for pair in line.windows(2).skip(1) {
                    drawing.triangle([line[0], pair[0], pair[1]], window, beside);
                }
            }
        }
        drawing
    }

    /// Draws a triangle of the last face.
    fn triangle(&mut self, corners: [Vec3; 3], window: &Window, cut: Option<(Vec3, f64)>) {
        let [a, b, c] = corners.map(|corner| window.at(corner));
        let twice = (b - a).truncate().perp_dot((c - a).truncate());
        if !(twice.abs() > 0.0 && twice.is_finite()) {
            return;
        }
        let above = corners.map(|corner| cut.map_or(-1.0, |(plane, at)| plane.dot(corner) - at));
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
            (Some(a), Some(b)) => a.block != b.block || a.normal.dot(b.normal) < EDGE,
            (None, None) => false,
            (Some(_), None) | (None, Some(_)) => true,
        }
    }

    /// Red, green and blue at each point, by the colours of the blocks.
    fn colours(&self, of: &[[f64; 3]]) -> Vec<[f64; 3]> {
        let face = |at: &u32| self.faces.get(*at as usize);
        let paint = |at: &u32| match face(at) {
            Some(face) => of[face.block as usize].map(|part| face.light * part),
            None => [255.0; 3],
        };
        let mut colours: Vec<[f64; 3]> = self.nearest.iter().map(paint).collect();
        let seen = self.nearest.iter().filter(|at| **at != NONE).count();
        let mut blocks: Vec<u32> =
            self.nearest.iter().filter_map(|at| Some(face(at)?.block)).collect();
        blocks.sort_unstable();
        blocks.dedup();
        if seen < CROWDED * blocks.len() {
            return colours;
        }
        for at in 0..self.nearest.len() {
            let right = ((at + 1) % self.wide != 0).then_some(at + 1);
            let below = Some(at + self.wide).filter(|below| *below < self.nearest.len());
            for other in [right, below].into_iter().flatten().filter(|other| self.edge(at, *other))
            {
                colours[at] = [40.0; 3];
                colours[other] = [40.0; 3];
            }
        }
        colours
    }
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

/// Red, green and blue of `#rrggbb`.
fn rgb(colour: &str) -> [f64; 3] {
    [1, 3, 5].map(|k| {
        let part = colour.get(k..k + 2).and_then(|part| u8::from_str_radix(part, 16).ok());
        f64::from(part.unwrap_or(255))
    })
}

/// The picture of a frame with title and legend, as PNG.
fn picture(
    frame: &Frame,
    chosen: &Chosen,
    (all, materials): (&[f64], &[String]),
    [title, suffix]: [&str; 2],
    shot: &Shot,
    window: &Window,
) -> Result<Vec<u8>, PlotError> {
    let [wide, high] = shot.size.map(f64::from);
    let mut page = Page::new(wide + LEGEND, high + TITLE);
    page.title([12.0, 22.0], 12.0, title, suffix);
    let bare = shot.field.strip_prefix("block.").unwrap_or(&shot.field);
    let is_kind = ["block", "material"].contains(&bare);
    let (map, scale) = colours(all, shot.options);
    let paint = |value: &f64| match is_kind {
        true => rgb(colour::kind(*value)),
        false => rgb(&map.at(scale.share(*value))),
    };
    let at = [wide + 8.0, TITLE + 0.15 * high];
    match bare {
        "material" => chips(&mut page, materials, all, at),
        "block" => {}
        _ => bar(&mut page, (map, &scale), chosen, at, 0.7 * high),
    }
    let look = Look { dpi: Some(96.0), ..Look::default() };
    let failed = |reason: String| PlotError::Render { reason };
    let mut map = Pixmap::decode_png(&page.png(&look)?).map_err(|e| failed(e.to_string()))?;
    let drawing = Drawing::of(frame, shot, window);
    let of: Vec<[f64; 3]> = chosen.values.iter().map(paint).collect();
    let points = drawing.colours(&of);
    let across = map.width() as usize;
    for y in 0..shot.size[1] as usize {
        for x in 0..shot.size[0] as usize {
            let mut sum = [0.0; 3];
            for k in 0..FINE * FINE {
                let point = points[(FINE * y + k / FINE) * drawing.wide + FINE * x + k % FINE];
                (0..3).for_each(|part| sum[part] += point[part]);
            }
            let [r, g, b] = sum.map(|part| (part / (FINE * FINE) as f64).round() as u8);
            let place = (y + TITLE as usize) * across + x;
            map.pixels_mut()[place] = ColorU8::from_rgba(r, g, b, 255).premultiply();
        }
    }
    map.encode_png().map_err(|e| failed(e.to_string()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use riprap_testkit::solid_sample;

    fn seen(eye: [f64; 2], cut: Option<(Normal, f64)>) -> (Drawing, Window) {
        let frame = solid_sample();
        let options = BlockOptions::default();
        let shot = Shot { field: "block".to_owned(), eye, size: [300, 200], cut, options };
        let all: Vec<Vec3> =
            Camera::new(eye).corners(&frame, &shot).into_iter().flatten().collect();
        let low = all.iter().copied().fold(Vec3::INFINITY, Vec3::min);
        let high = all.iter().copied().fold(Vec3::NEG_INFINITY, Vec3::max);
        let window = Window::around(low, high, shot.size);
        (Drawing::of(&frame, &shot, &window), window)
    }

    /// Area of what is seen of a block, m2.
    fn area((drawing, window): &(Drawing, Window), block: u32) -> f64 {
        let faces = drawing.nearest.iter().filter_map(|at| drawing.faces.get(*at as usize));
        faces.filter(|face| face.block == block).count() as f64 / (window.zoom * window.zoom)
    }

    #[test]
    fn what_is_seen_has_the_area_of_its_projection() {
        // A brick of 2 m, and a tetrahedron with edges of 1 m along the axes, to the right of it along x.
        let south = seen([180.0, 0.0], None);
        assert!((area(&south, 0) - 4.0).abs() < 0.04, "{}", area(&south, 0));
        assert!((area(&south, 1) - 0.5).abs() < 0.01, "{}", area(&south, 1));
        // From the east the tetrahedron hides half a square metre of the brick.
        let east = seen([90.0, 0.0], None);
        assert!((area(&east, 0) - 3.5).abs() < 0.04, "{}", area(&east, 0));
        // Isometric: a cube of 2 m is a hexagon of 4 sqrt 3; what the tetrahedron hides is its own.
        let high = (1.0 / 2.0_f64.sqrt()).atan().to_degrees();
        let corner = seen([225.0, high], None);
        assert!((area(&corner, 0) - 4.0 * 3.0_f64.sqrt()).abs() < 0.06, "{}", area(&corner, 0));
    }

    #[test]
    fn a_cut_shows_the_section_of_a_block_in_its_plain_colour() {
        let cut = seen([90.0, 0.0], Some((Normal::X, 0.3)));
        assert!((area(&cut, 0) - 4.0).abs() < 0.04 && area(&cut, 1) == 0.0);
        let (drawing, _) = &cut;
        let faces = drawing.nearest.iter().filter_map(|at| drawing.faces.get(*at as usize));
        assert!(faces.filter(|face| face.block == 0).all(|face| face.light == 1.0));
    }

    #[test]
    fn a_block_that_is_cut_is_seen_before_what_touches_it_from_behind() {
        // The brick twice, the second one behind the first as seen from the south.
        let mut frame = solid_sample();
        let solids = frame.solids.clone().unwrap();
        let brick: Vec<[f64; 3]> = frame.outline(0).to_vec();
        let behind = brick.iter().map(|[x, y, z]| [*x, y + 2.0, *z]);
        frame.points = brick.iter().copied().chain(behind).collect();
        frame.offsets = vec![0, brick.len() as u32, 2 * brick.len() as u32];
        let faces: Vec<u32> = solids.of(0).into_iter().flatten().copied().collect();
        let ends: Vec<u32> = solids
            .of(0)
            .iter()
            .scan(0, |sum, face| {
                *sum += face.len() as u32;
                Some(*sum)
            })
            .collect();
        let whole = ends.len() as u32;
        frame.solids = Some(riprap_record::frame::Solids {
            faces: vec![0, whole, 2 * whole],
            ends: std::iter::once(0)
                .chain(ends.iter().copied())
                .chain(ends.iter().map(|end| end + faces.len() as u32))
                .collect(),
            corners: faces.iter().chain(&faces).copied().collect(),
        });
        for (at, block) in [(0.2, 0), (1.0, 1), (1.4, 1)] {
            let cut = Some((Normal::Y, at));
            let options = BlockOptions::default();
            let shot = Shot {
                field: "block".to_owned(),
                eye: [170.0, 10.0],
                size: [120, 100],
                cut,
                options,
            };
            let all: Vec<Vec3> =
                Camera::new(shot.eye).corners(&frame, &shot).into_iter().flatten().collect();
            let low = all.iter().copied().fold(Vec3::INFINITY, Vec3::min);
            let high = all.iter().copied().fold(Vec3::NEG_INFINITY, Vec3::max);
            let drawing = Drawing::of(&frame, &shot, &Window::around(low, high, shot.size));
            // The section is upright, seen 10 deg from its normal each way; points on an outline may be of either face.
            let other = drawing.nearest.iter().filter_map(|at| drawing.faces.get(*at as usize));
            let section =
                other.clone().filter(|face| face.block == block && face.normal.z > 0.9).count();
            let beside = other.filter(|face| face.block != block && face.normal.z > 0.9).count();
            assert!(section > 1000 && beside < 5, "{at}: {section} and {beside}");
        }
    }

    #[test]
    fn options_without_sense_are_refused() {
        let sound = Shot {
            field: "block".to_owned(),
            eye: [225.0, 30.0],
            size: [300, 200],
            cut: None,
            options: BlockOptions::default(),
        };
        assert!(sound.checked().is_ok());
        for (wrong, word) in [
            (Shot { eye: [0.0, 91.0], ..sound.clone() }, "view"),
            (Shot { size: [300, 9], ..sound.clone() }, "size"),
            (Shot { cut: Some((Normal::X, f64::NAN)), ..sound.clone() }, "at"),
        ] {
            assert!(wrong.checked().unwrap_err().to_string().starts_with(word));
        }
    }
}
