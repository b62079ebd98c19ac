//! Rose diagrams: strikes of joints and cracks; in the plane the angles of their traces.

use super::drawing::short;
use super::frames::moment;
use super::load::{Which, crack_surfaces};
use super::planes;
use super::run::Run;
use super::svg::{Anchor, Page};
use super::{PlotError, Target, column, digits, table_csv, write};
use riprap_record::manifest::Manifest;
use riprap_record::names::Names;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// Width of a petal, degrees.
const PETAL: usize = 10;
const PETALS: usize = 180 / PETAL;
const RADIUS: f64 = 180.0;
const SIZE: f64 = 12.0;
/// Planes flatter than this have no strike worth the name, degrees.
const FLAT: f64 = 5.0;

/// One rose.
struct Rose {
    name: &'static str,
    colour: &'static str,
    /// Area (length in the plane) by petal, m² (m).
    petals: [f64; PETALS],
    count: usize,
    /// Area (length) without a strike.
    flat: f64,
}

impl Rose {
    fn new(name: &'static str, colour: &'static str) -> Self {
        Rose { name, colour, petals: [0.0; PETALS], count: 0, flat: 0.0 }
    }

    /// Adds a plane whose strike has this angle, degrees.
    fn add(&mut self, angle: f64, amount: f64) {
        // Petals are centred on whole multiples, so that sets along the axes fill one petal, not two.
        let k = (angle / PETAL as f64).round() as usize % PETALS;
        self.petals[k] += amount;
        self.count += 1;
    }

    fn sum(&self) -> f64 {
        self.petals.iter().sum()
    }
}

/// Draws roses of joints (shared faces or edges of blocks in the first frame) and of cracks (up to the chosen frame).
///
/// In space: strikes, clockwise from north (y). In the plane: angles of traces, anticlockwise from x, as `dip` of a
/// joint set. Petals are 10 degrees wide; their length is the share of the area (of the length).
///
/// # Errors
/// No joints and no cracks, files that cannot be read or written.
pub fn rose<'r, 't>(
    run: impl Into<Run<'r>>,
    frame: Which,
    out: impl Into<Target<'t>>,
) -> Result<Vec<PathBuf>, PlotError> {
    let run = run.into();
    let folder = run.folder;
    let manifest = Manifest::read(folder)?;
    let first = run.frame(Which::Index(1))?;
    let last = run.frame(frame)?;
    let flat = first.solids.is_none();
    let joints = planes::shared(&first);
    let mut roses = [Rose::new("joints", "#8a8a8a"), Rose::new("cracks", "#d55e00")];
    let mut add = |k: usize, normal, amount: f64| {
        let rose: &mut Rose = &mut roses[k];
        if flat {
            rose.add(planes::trace_angle(normal), amount);
            return;
        }
        let [dip, direction] = planes::dip(normal);
        if dip < FLAT {
            rose.flat += amount;
        } else {
            rose.add((direction + 90.0) % 180.0, amount);
        }
    };
    for joint in &joints {
        add(0, joint.normal, joint.area);
    }
    if flat {
        let by_pair: BTreeMap<[u32; 2], _> = joints.iter().map(|j| (j.blocks, j)).collect();
        for (pair, length) in broken_pairs(folder, last.time)? {
            if let Some(joint) = by_pair.get(&pair).or(by_pair.get(&[pair[1], pair[0]])) {
                add(1, joint.normal, length);
            }
        }
    } else {
        for crack in planes::cracks(&last, Some(&crack_surfaces(folder, frame)?), run.of.is_some())?
        {
            add(1, crack.normal, crack.area);
        }
    }
    if roses.iter().all(|r| r.sum() == 0.0) {
        let what = if flat {
            "no two blocks share an edge, and no joint is broken"
        } else {
            "no two blocks share a face that has a strike, and no face is broken"
        };
        let what = what.to_owned();
        return Err(PlotError::NothingToDraw { what });
    }
    let title = run.suffix(&manifest, &moment(folder, &last)?);
    let page = drawn((&manifest.title, &title), &roses, flat);
    let unit = if flat { "m" } else { "m2" };
    let middle = |k: usize| (k * PETAL) as f64;
    let name = if flat { "trace angle" } else { "strike" };
    let columns = [
        column(name, "deg", (0..PETALS).map(middle).collect()),
        column("joints", unit, roses[0].petals.to_vec()),
        column("cracks", unit, roses[1].petals.to_vec()),
        column("joints without strike", unit, vec![roses[0].flat]),
        column("cracks without strike", unit, vec![roses[1].flat]),
    ];
    let columns = if flat { &columns[..3] } else { &columns[..] };
    write(&page, &table_csv(&columns.iter().collect::<Vec<_>>()), out)
}

/// Joints of the plane that broke up to a time: numbers of their blocks and length, m.
fn broken_pairs(folder: &Path, time: f64) -> Result<Vec<([u32; 2], f64)>, PlotError> {
    let names = Names::read(folder)?;
    let path = folder.join("events.jsonl");
    let text = match riprap_record::read_plain_text(&path) {
        Ok(text) => text,
        Err(e) if e.kind() == std::io::ErrorKind::NotFound => String::new(),
        Err(e) => {
            let what = format!("{} cannot be read: {e}", path.display());
            return Err(PlotError::NothingToDraw { what });
        }
    };
    let read = |line: &str| {
        let event: serde_json::Value = serde_json::from_str(line).ok()?;
        let block = |k: usize| names.number(event["blocks"][k].as_str()?);
        let early = event["time"].as_f64()? <= time;
        let broken = event["event"] == "joint_broken" && early;
        let pair = [block(0)?, block(1)?];
        broken.then_some((pair, event["length"].as_f64()?))
    };
    // A last line without its end does not count, and is no JSON either.
    Ok(text.lines().filter_map(read).collect())
}

fn drawn((title, end): (&str, &str), roses: &[Rose; 2], flat: bool) -> Page {
    let shown: Vec<&Rose> = roses.iter().filter(|r| r.count > 0).collect();
    let width = (90.0 + shown.len() as f64 * (2.0 * RADIUS + 90.0)).max(560.0);
    let mut page = Page::new(width, 540.0);
    page.title([30.0, 30.0], 20.0, title, end);
    for (k, rose) in shown.iter().enumerate() {
        let middle = [90.0 + RADIUS + k as f64 * (2.0 * RADIUS + 90.0), 270.0];
        one(&mut page, rose, middle, flat);
    }
    let text = if flat {
        "angles of traces, anticlockwise from x; lengths add up to 100 %"
    } else {
        "strikes, clockwise from north (y); areas add up to 100 %"
    };
    page.text([30.0, 522.0], SIZE, Anchor::Start, text);
    page
}

/// Point at an angle (degrees) and a distance: clockwise from the top in space, anticlockwise from the right in the plane.
fn polar(middle: [f64; 2], r: f64, angle: f64, flat: bool) -> [f64; 2] {
    let (s, c) = libm::sincos(angle.to_radians());
    if flat {
        [middle[0] + r * c, middle[1] - r * s]
    } else {
        [middle[0] + r * s, middle[1] - r * c]
    }
}

/// What stands beside the rim at an angle, in degrees.
fn direction(angle: u32, flat: bool) -> String {
    match (flat, angle) {
        (true, a) => format!("{a}\u{b0}"),
        (false, 0) => "N".to_owned(),
        (false, 90) => "E".to_owned(),
        (false, 180) => "S".to_owned(),
        (false, 270) => "W".to_owned(),
        (false, a) => format!("{a:03}\u{b0}"),
    }
}

fn one(page: &mut Page, rose: &Rose, middle: [f64; 2], flat: bool) {
    let sum = rose.sum();
    let most = rose.petals.iter().fold(0.0_f64, |m, p| m.max(*p)) / sum;
    let step = [0.01, 0.02, 0.05, 0.1, 0.2, 0.25, 0.5]
        .into_iter()
        .find(|s| most / s <= 4.0)
        .unwrap_or(0.5);
    let rings = (most / step).ceil().max(1.0);
    let scale = RADIUS / (rings * step);
    for angle in (0..180).step_by(30) {
        let (a, b) = (f64::from(angle), f64::from(angle) + 180.0);
        page.line(
            polar(middle, RADIUS, a, flat),
            polar(middle, RADIUS, b, flat),
            "stroke=\"#e3e3e3\"",
        );
    }
    for ring in 1..=rings as usize {
        let r = scale * step * ring as f64;
        page.circle(middle, r, "fill=\"none\" stroke=\"#dcdcdc\"");
    }
    let fill = format!(
        "fill=\"{}\" fill-opacity=\"0.75\" stroke=\"#1a1a1a\" stroke-width=\"0.8\"",
        rose.colour
    );
    for (k, petal) in rose.petals.iter().enumerate().filter(|p| *p.1 > 0.0) {
        let r = scale * petal / sum;
        for turn in [0.0, 180.0] {
            let from = (k as f64 - 0.5) * PETAL as f64 + turn;
            let mut points = vec![middle];
            points.extend(
                (0..=8).map(|i| polar(middle, r, from + PETAL as f64 * f64::from(i) / 8.0, flat)),
            );
            page.polygon(&points, &fill);
        }
    }
    page.circle(middle, RADIUS, "fill=\"none\" stroke=\"#1a1a1a\"");
    for angle in (0..360).step_by(30) {
        let [x, y] = polar(middle, RADIUS + 20.0, f64::from(angle), flat);
        page.text([x, y + 4.2], SIZE, Anchor::Middle, &direction(angle, flat));
    }
    // Over the petals, beside the spoke that points up and right.
    for ring in 1..=rings as usize {
        let r = scale * step * ring as f64;
        let [x, y] = polar(middle, r, if flat { 15.0 } else { 75.0 }, flat);
        let text = format!("{} %", short(100.0 * step * ring as f64));
        page.text([x, y], 10.0, Anchor::Middle, &text);
    }
    let unit = if flat { "m" } else { "m\u{b2}" };
    let mut text = format!("{}: {}, {} {unit}", rose.name, rose.count, digits(sum, 4));
    if rose.flat > 0.0 {
        let share = 100.0 * rose.flat / (sum + rose.flat);
        text += &format!(" ({} % more is flatter than {FLAT}\u{b0})", digits(share, 2));
    }
    page.text([middle[0], 52.0], SIZE, Anchor::Middle, &text);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[cfg(unix)]
    #[test]
    fn events_that_are_no_plain_file_are_not_waited_for() {
        let dir = tempfile::tempdir().unwrap();
        assert!(broken_pairs(dir.path(), 1.0).unwrap().is_empty());
        std::os::unix::fs::symlink("/dev/null", dir.path().join("events.jsonl")).unwrap();
        let refused = broken_pairs(dir.path(), 1.0).unwrap_err().to_string();
        assert!(refused.contains("not a regular file"), "{refused}");
    }

    #[test]
    fn petals_are_centred_on_the_axes() {
        let mut rose = Rose::new("joints", "");
        for angle in [0.0, 4.9, 175.1, 179.999] {
            rose.add(angle, 1.0);
        }
        rose.add(90.0, 2.0);
        assert_eq!((rose.petals[0], rose.petals[9]), (4.0, 2.0));
    }
}
