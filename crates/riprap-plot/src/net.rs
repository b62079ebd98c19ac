//! Stereonets: poles of joints and cracks on the lower hemisphere.

use super::frames::moment;
use super::load::{Which, crack_surfaces};
use super::planes::{self, Crack};
use super::run::Run;
use super::section::need_space;
use super::svg::{Anchor, Page};
use super::{PlotError, Target, column, digits, table_csv, write};
use riprap_geom::Vec3;
use riprap_keys::Words;
use riprap_record::manifest::Manifest;
use std::collections::BTreeMap;
use std::path::PathBuf;

const PICTURE: &str = "a stereonet";
/// Radius of the net and where its middle lies.
const RADIUS: f64 = 250.0;
const MIDDLE: [f64; 2] = [320.0, 360.0];
const SIZE: f64 = 12.0;
/// Poles closer than this are one dot, degrees.
const MERGE: f64 = 0.5;
/// Sets named in the legend.
const NAMED: usize = 8;
/// Joints, cracks by tension (or unknown), cracks by shear.
const COLOURS: [&str; 3] = ["#4d4d4d", "#d55e00", "#0072b2"];

/// How the hemisphere is laid flat.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Words)]
pub enum Projection {
    /// Schmidt net: densities of poles can be compared.
    ///
    /// Lambert's azimuthal projection.
    #[default]
    EqualArea,
    /// Wulff net: angles are true.
    ///
    /// The stereographic projection: circles stay circles.
    EqualAngle,
}

impl Projection {
    fn name(self) -> String {
        self.word().replace('_', " ")
    }

    /// Distance from the middle, as a share of the radius, of a line `angle` (rad) from the vertical.
    fn radius(self, angle: f64) -> f64 {
        match self {
            Projection::EqualArea => std::f64::consts::SQRT_2 * libm::sin(0.5 * angle),
            Projection::EqualAngle => libm::tan(0.5 * angle),
        }
    }

    /// Where a line with this direction meets the lower hemisphere, as shares of the radius: east, north.
    fn place(self, line: Vec3) -> [f64; 2] {
        let down = if line.z > 0.0 { -line } else { line };
        let across = down.x.hypot(down.y);
        if across == 0.0 {
            return [0.0; 2];
        }
        let r = self.radius(libm::atan2(across, -down.z));
        [r * down.x / across, r * down.y / across]
    }
}

/// Poles that fall together.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Dot {
    /// Dip and dip direction of their plane, degrees: the mean by area.
    dip: [f64; 2],
    area: f64,
    count: usize,
}

/// Draws the poles of joints (the shared faces of blocks in the first frame) and of cracks (in the chosen frame) on the
/// lower hemisphere: x is east, y north, z up. Dots are larger for larger areas.
///
/// # Errors
/// A run in the plane, a run of one block, files that cannot be read or written.
pub fn stereonet<'r, 't>(
    run: impl Into<Run<'r>>,
    frame: Which,
    projection: Projection,
    out: impl Into<Target<'t>>,
) -> Result<Vec<PathBuf>, PlotError> {
    let run = run.into();
    let folder = run.folder;
    let manifest = Manifest::read(folder)?;
    let first = run.frame(Which::Index(1))?;
    need_space(&first, PICTURE)?;
    let last = run.frame(frame)?;
    let joints = planes::shared(&first);
    let cracks = planes::cracks(&last, Some(&crack_surfaces(folder, frame)?), run.of.is_some())?;
    if joints.is_empty() && cracks.is_empty() {
        let what = "no two blocks share a face, and no face is broken".to_owned();
        return Err(PlotError::NothingToDraw { what });
    }
    let modes = cracks.iter().any(|c| c.sheared.is_some());
    let groups = [
        ("joints", merged(joints.iter().map(|j| (j.normal, j.area)))),
        (
            if modes { "cracks by tension" } else { "cracks" },
            merged(of_mode(&cracks, &|s| s != Some(true))),
        ),
        ("cracks by shear", merged(of_mode(&cracks, &|s| s == Some(true)))),
    ];
    let title = run.suffix(&manifest, &moment(folder, &last)?);
    let page = drawn((&manifest.title, &title), projection, &groups);
    let kinds = groups.iter().enumerate();
    let all: Vec<(f64, &Dot)> =
        kinds.flat_map(|(k, g)| g.1.iter().map(move |d| (k as f64, d))).collect();
    let numbers = |name: &str, unit: &str, f: &dyn Fn(&(f64, &Dot)) -> f64| {
        column(name, unit, all.iter().map(f).collect())
    };
    let columns = [
        numbers("kind (0 joint, 1 crack, 2 sheared)", "-", &|d| d.0),
        numbers("dip", "deg", &|d| d.1.dip[0]),
        numbers("dip direction", "deg", &|d| d.1.dip[1]),
        numbers("pole trend", "deg", &|d| (d.1.dip[1] + 180.0) % 360.0),
        numbers("pole plunge", "deg", &|d| 90.0 - d.1.dip[0]),
        numbers("area", "m2", &|d| d.1.area),
        numbers("planes", "-", &|d| d.1.count as f64),
    ];
    write(&page, &table_csv(&columns.iter().collect::<Vec<_>>()), out)
}

fn of_mode<'a>(
    cracks: &'a [Crack],
    wanted: &'a dyn Fn(Option<bool>) -> bool,
) -> impl Iterator<Item = (Vec3, f64)> + 'a {
    let of = cracks.iter().filter(move |c| wanted(c.sheared));
    of.map(|c| (c.normal, c.area))
}

/// Poles in cells of half a degree, the largest area first.
fn merged(planes: impl Iterator<Item = (Vec3, f64)>) -> Vec<Dot> {
    let mut cells: BTreeMap<[i64; 2], (Vec3, f64, usize)> = BTreeMap::new();
    for (normal, area) in planes {
        let [dip, direction] = planes::dip(normal);
        // Towards the vertical a degree of dip direction is short.
        let turns = (direction * libm::sin(dip.to_radians()) / MERGE).round() as i64;
        let key = [(dip / MERGE).round() as i64, turns];
        let (sin, cos) = libm::sincos(dip.to_radians());
        let (s, c) = libm::sincos(direction.to_radians());
        let cell = cells.entry(key).or_default();
        cell.0 += area * Vec3::new(sin * s, sin * c, cos);
        cell.1 += area;
        cell.2 += 1;
    }
    let mut out: Vec<Dot> = cells
        .into_values()
        .map(|(sum, area, count)| Dot { dip: planes::dip(sum), area, count })
        .collect();
    out.sort_by(|a, b| b.area.total_cmp(&a.area));
    out
}

/// Unit normal of a plane, upwards.
fn normal([dip, direction]: [f64; 2]) -> Vec3 {
    let (sin, cos) = libm::sincos(dip.to_radians());
    let (s, c) = libm::sincos(direction.to_radians());
    Vec3::new(sin * s, sin * c, cos)
}

fn at([east, north]: [f64; 2]) -> [f64; 2] {
    [MIDDLE[0] + RADIUS * east, MIDDLE[1] - RADIUS * north]
}

fn drawn((title, end): (&str, &str), projection: Projection, groups: &[(&str, Vec<Dot>)]) -> Page {
    let mut page = Page::new(900.0, 660.0);
    page.title([30.0, 30.0], 20.0, title, end);
    net(&mut page, projection);
    let largest = |dots: &[Dot]| dots.first().map_or(1.0, |d| d.area);
    for (k, (_, dots)) in groups.iter().enumerate() {
        let top = largest(dots);
        for dot in dots.iter().rev() {
            let r = 2.0 + 6.0 * (dot.area / top).sqrt();
            let place = at(projection.place(-normal(dot.dip)));
            page.circle(place, r, &style(k));
        }
    }
    legend(&mut page, projection, groups);
    page
}

fn style(kind: usize) -> String {
    let colour = COLOURS[kind];
    if kind == 0 {
        format!("fill=\"{colour}\" fill-opacity=\"0.25\" stroke=\"{colour}\" stroke-width=\"1.2\"")
    } else {
        format!("fill=\"{colour}\" fill-opacity=\"0.55\" stroke=\"#ffffff\" stroke-width=\"0.6\"")
    }
}

/// Great and small circles every ten degrees about the north-south axis, and the rim with its directions.
fn net(page: &mut Page, projection: Projection) {
    let steps = 60;
    let arc = |f: &dyn Fn(f64) -> Vec3| -> Vec<[f64; 2]> {
        let angle = |i: i32| std::f64::consts::PI * f64::from(i) / f64::from(steps);
        (0..=steps).map(|i| at(projection.place(f(angle(i))))).collect()
    };
    for degrees in (10..180).step_by(10) {
        let a = f64::from(degrees).to_radians();
        let (sin, cos) = libm::sincos(a);
        let stroke = if degrees % 30 == 0 { "#d0d0d0" } else { "#ececec" };
        let style = format!("fill=\"none\" stroke=\"{stroke}\"");
        let great = arc(&|t| {
            let (s, c) = libm::sincos(t);
            // A hair below the horizon at both ends, so that none of them jumps to the other side.
            Vec3::new(s * cos, c, -s * sin - 1e-12)
        });
        page.polyline(&great, &style);
        let small = arc(&|t| {
            let (s, c) = libm::sincos(t);
            Vec3::new(sin * c, cos, -sin * s - 1e-12)
        });
        page.polyline(&small, &style);
    }
    let cross = "stroke=\"#bdbdbd\"";
    page.line(at([-1.0, 0.0]), at([1.0, 0.0]), cross);
    page.line(at([0.0, -1.0]), at([0.0, 1.0]), cross);
    page.circle(MIDDLE, RADIUS, "fill=\"none\" stroke=\"#1a1a1a\" stroke-width=\"1.2\"");
    for degrees in (0..360).step_by(30) {
        let (s, c) = libm::sincos(f64::from(degrees).to_radians());
        page.line(at([s, c]), at([1.025 * s, 1.025 * c]), "stroke=\"#1a1a1a\"");
        let name = match degrees {
            0 => "N".to_owned(),
            90 => "E".to_owned(),
            180 => "S".to_owned(),
            270 => "W".to_owned(),
            other => format!("{other:03}\u{b0}"),
        };
        let [x, y] = at([1.085 * s, 1.085 * c]);
        page.text([x, y + 4.2], SIZE, Anchor::Middle, &name);
    }
}

fn legend(page: &mut Page, projection: Projection, groups: &[(&str, Vec<Dot>)]) {
    let left = 640.0;
    let mut y = 96.0;
    let mut line = |page: &mut Page, text: &str, kind: Option<usize>| {
        if let Some(kind) = kind {
            page.circle([left + 7.0, y - 4.2], 5.0, &style(kind));
        }
        page.text([left + 20.0, y], SIZE, Anchor::Start, text);
        y += 18.0;
    };
    line(page, &format!("lower hemisphere, {}", projection.name()), None);
    line(page, "poles: dip / dip direction", None);
    line(page, "x east, y north, z up", None);
    line(page, "", None);
    for (k, (name, dots)) in groups.iter().enumerate() {
        if dots.is_empty() {
            continue;
        }
        let count: usize = dots.iter().map(|d| d.count).sum();
        let area: f64 = dots.iter().map(|d| d.area).sum();
        line(page, &format!("{name}: {count}, {} m\u{b2}", digits(area, 4)), Some(k));
        for dot in dots.iter().take(NAMED) {
            let share = 100.0 * dot.area / area;
            let text =
                format!("{:02.0}\u{b0} / {:03.0}\u{b0}   {share:.1} %", dot.dip[0], dot.dip[1]);
            line(page, &text, None);
        }
        if dots.len() > NAMED {
            line(page, &format!("and {} more directions", dots.len() - NAMED), None);
        }
        line(page, "", None);
    }
    if groups[1..].iter().all(|g| g.1.is_empty()) {
        line(page, "no cracks", None);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_horizontal_line_lies_on_the_rim_and_a_vertical_one_in_the_middle() {
        for p in [Projection::EqualArea, Projection::EqualAngle] {
            let [e, n] = p.place(Vec3::new(0.6, 0.8, 0.0));
            assert!((e.hypot(n) - 1.0).abs() < 1e-12 && (e / n - 0.75).abs() < 1e-12);
            assert_eq!(p.place(Vec3::Z), [0.0; 2]);
        }
    }

    #[test]
    fn radii_at_45_degrees() {
        // Equal area: sqrt 2 sin 22.5 deg; equal angle: tan 22.5 deg.
        let line = Vec3::new(1.0, 0.0, -1.0);
        let area = Projection::EqualArea.place(line)[0];
        let angle = Projection::EqualAngle.place(line)[0];
        assert!((area - 0.541_196_100_146_197).abs() < 1e-12, "{area}");
        assert!((angle - 0.414_213_562_373_095).abs() < 1e-12, "{angle}");
    }

    #[test]
    fn equal_area_means_equal_area() {
        // The cap within 60 degrees of the vertical has half the area of the hemisphere.
        let r = Projection::EqualArea.radius(60f64.to_radians());
        assert!((r * r - 0.5).abs() < 1e-12);
    }

    #[test]
    fn parallel_planes_are_one_dot() {
        let n = normal([40.0, 130.0]);
        let dots = merged([(n, 1.0), (-n, 3.0), (Vec3::Z, 2.0)].into_iter());
        assert_eq!(dots.len(), 2);
        assert_eq!((dots[0].count, dots[0].area), (2, 4.0));
        assert!((dots[0].dip[0] - 40.0).abs() < 1e-9 && (dots[0].dip[1] - 130.0).abs() < 1e-9);
        assert_eq!(dots[1].dip, [0.0, 0.0]);
    }
}
