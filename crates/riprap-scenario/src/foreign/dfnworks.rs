//! Networks of fractures of dfnWorks as lists of centres, normals and radii.
//!
//! Source: dfnWorks (lanl/dfnWorks), DFNGen: `output.cpp` for what stands in `radii_Final.dat`, `radii.dat`, `normal_vectors.dat`,
//! `translations.dat`, `families.dat` and `params.txt`; `insertShape.cpp` and `computationalGeometry.cpp` for how a fracture is drawn
//! in the plane z = 0, turned in it and turned to its normal.
//!
//! Deviation: fractures are whole, as they were before dfnGen cut them at the faces of its domain, and corners of ellipses stand at
//! even steps of the parameter, not of arc length. `polygons.dat` of the same run has them as they were cut.

use std::collections::BTreeMap;
use std::f64::consts::TAU;
use std::path::{Path, PathBuf};

use riprap_geom::Vec3;

use super::dfn::{Network, Shape, numbers, parse_polygons, words};
use super::{FileError, Refused, at_line, read};

const POLYGONS: &str = "polygons.dat";
const FINAL: &str = "radii_Final.dat";
const RADII: &str = "radii.dat";
const NORMALS: [&str; 2] = ["normal_vectors.dat", "normals.dat"];
const CENTRES: &str = "translations.dat";
const FAMILIES: &str = "families.dat";
const PARAMS: &str = "params.txt";

/// The folder of the output of dfnGen within that of a run.
const OUTPUT: &str = "dfnGen_output";

/// Most rows of a list.
const MOST_ROWS: usize = 1_000_000;

/// Most corners of the ellipses of a family.
const MOST_CORNERS: u32 = 1000;

/// Corners of an ellipse of a family that says nothing of them.
const CORNERS: u32 = 32;

/// Family of fractures that were given by their corners.
const BY_CORNERS: f64 = -2.0;

/// Family of rectangles that were given one by one.
const RECTANGLES: f64 = -1.0;

/// The files of a network, from the one that a scene names.
enum Found {
    Polygons(PathBuf),
    Lists(Box<Lists>),
}

struct Lists {
    radii: PathBuf,
    normals: PathBuf,
    centres: PathBuf,
    families: Option<PathBuf>,
    params: Option<PathBuf>,
}

/// What is read for `path`, a file or a folder.
fn found(path: &Path) -> Found {
    let name = path.file_name().and_then(|name| name.to_str());
    let name = name.filter(|_| !path.is_dir()).unwrap_or_default();
    let lists = [FINAL, RADII, CENTRES, FAMILIES, PARAMS];
    let known = lists.iter().chain(&NORMALS).any(|list| name == *list);
    if !known && !path.is_dir() {
        return Found::Polygons(path.to_owned());
    }
    let folder = if known { path.parent().unwrap_or(Path::new("")) } else { path };
    let within = folder.join(OUTPUT);
    let holds = |folder: &Path| [POLYGONS, CENTRES].iter().any(|n| folder.join(n).is_file());
    let folder = if (name == PARAMS || !known) && !holds(folder) && within.is_dir() {
        within.as_path()
    } else {
        folder
    };
    let there = |name: &str| folder.join(name).is_file();
    if !known && there(POLYGONS) {
        return Found::Polygons(folder.join(POLYGONS));
    }
    let all = name == RADII || (name != FINAL && !there(FINAL) && there(RADII));
    let other =
        name == NORMALS[1] || (name != NORMALS[0] && !there(NORMALS[0]) && there(NORMALS[1]));
    Found::Lists(Box::new(Lists {
        radii: folder.join(if all { RADII } else { FINAL }),
        normals: folder.join(NORMALS[usize::from(other)]),
        centres: folder.join(CENTRES),
        families: there(FAMILIES).then(|| folder.join(FAMILIES)),
        params: (name == PARAMS).then(|| path.to_owned()),
    }))
}

/// The files beside the one or in the folder that a scene names which make a network of dfnWorks with it, or none.
#[must_use]
pub fn companions(path: &Path) -> Vec<PathBuf> {
    match found(path) {
        Found::Polygons(file) if file != path && file.is_file() => vec![file],
        Found::Polygons(_) => Vec::new(),
        Found::Lists(lists) => {
            let Lists { radii, normals, centres, families, params } = *lists;
            let files = [Some(radii), Some(normals), Some(centres), families, params];
            let files = files.into_iter().flatten();
            files.filter(|file| file != path && file.is_file()).collect()
        }
    }
}

/// The network of dfnWorks in a file or a folder: its polygons, or what its lists say.
///
/// # Errors
/// What is wrong first, with its file and line.
pub fn read_dfnworks(path: &Path) -> Result<Network, Refused> {
    match found(path) {
        Found::Polygons(file) => {
            let mut network = read(&file, parse_polygons)?;
            if file != path {
                network.files = vec![named(&file)];
            }
            Ok(network)
        }
        Found::Lists(lists) => lists.network(),
    }
}

fn named(path: &Path) -> String {
    path.file_name().unwrap_or_default().to_string_lossy().into_owned()
}

/// A row of three numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Row {
    line: usize,
    numbers: [f64; 3],
    /// Whether its fracture was taken out of the network as isolated.
    removed: bool,
}

/// Rows of three numbers below lines of text; `R` behind them marks fractures that were removed.
///
/// # Errors
/// The first thing that is wrong, with its line.
pub fn parse_rows(bytes: &[u8]) -> Result<Vec<Row>, FileError> {
    let text = String::from_utf8_lossy(super::without_mark(bytes));
    let mut rows: Vec<Row> = Vec::new();
    for (line, text) in (1..).zip(text.lines()) {
        // The heads have `#` in them.
        let mut found: Vec<&str> = text.split_whitespace().collect();
        let head = |word: &&str| word.starts_with(|c: char| c.is_alphabetic());
        if found.is_empty() || rows.is_empty() && found.first().is_some_and(head) {
            continue;
        }
        let removed = found.last() == Some(&"R");
        if removed {
            found.pop();
        }
        let [x, y, z] = numbers(line, &found)?[..] else {
            let text = "a row needs three numbers, followed by `R` if its fracture was removed";
            return Err(at_line(line, text));
        };
        if rows.len() == MOST_ROWS {
            let text = format!("there are more than {MOST_ROWS} rows; generate a smaller network");
            return Err(at_line(line, text));
        }
        rows.push(Row { line, numbers: [x, y, z], removed });
    }
    Ok(rows)
}

/// How the fractures of a family are drawn.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Family {
    rectangles: bool,
    /// Corners of its ellipses.
    corners: Option<u32>,
    /// Angle by which its fractures are turned in their plane, rad, if it is the same for all.
    turn: Option<f64>,
}

/// The families of `families.dat` by their number in the lists.
///
/// # Errors
/// The first thing that is wrong, with its line.
pub fn parse_families(bytes: &[u8]) -> Result<BTreeMap<i64, Family>, FileError> {
    let text = String::from_utf8_lossy(super::without_mark(bytes));
    let mut families = BTreeMap::new();
    let mut shape = Family::default();
    let mut current: Option<i64> = None;
    for (line, text) in (1..).zip(text.lines()) {
        let Some((key, value)) = text.split_once(':') else {
            continue;
        };
        let value = value.trim();
        let wrong = |what: &str| at_line(line, format!("`{}` is {what}", super::shown(value)));
        match key.trim() {
            "Ellipse Family" | "Rectangular Family" => {
                shape.rectangles = key.trim().starts_with('R');
                current = None;
            }
            "Global Family" => {
                let number = value.parse().ok().filter(|number: &i64| *number > 0);
                let number = number.ok_or_else(|| wrong("not a family number"))?;
                families.insert(number, shape);
                current = Some(number);
            }
            "Number of Vertices" => {
                let count = value.parse().ok();
                let count = count.filter(|count| (3..=MOST_CORNERS).contains(count));
                let what = "not a number of corners from 3 to 1000";
                let count = count.ok_or_else(|| wrong(what))?;
                if let Some(family) = current.and_then(|number| families.get_mut(&number)) {
                    family.corners = Some(count);
                }
            }
            "Beta (Rotation Around Normal Vector)-rad" => {
                let angle = numbers(line, &[value])?;
                if let Some(family) = current.and_then(|number| families.get_mut(&number)) {
                    family.turn = angle.first().copied();
                }
            }
            _ => {}
        }
    }
    Ok(families)
}

/// Two axes of a fracture: those of the plane z = 0 turned to a normal, by the shortest way; a normal along -z leaves them.
fn frame(normal: Vec3) -> [Vec3; 2] {
    let Vec3 { x, y, z } = normal;
    if libm::hypot(x, y) < 1e-12 {
        return [Vec3::X, Vec3::Y];
    }
    // I + V + V V / (1 + z), with V of z cross the normal; written otherwise below, where 1 + z loses digits.
    let part = if z > 0.0 { 1.0 / (1.0 + z) } else { (1.0 - z) / (x * x + y * y) };
    [
        Vec3::new(1.0 - part * x * x, -part * x * y, -x),
        Vec3::new(-part * x * y, 1.0 - part * y * y, -y),
    ]
}

impl Lists {
    fn network(&self) -> Result<Network, Refused> {
        let radii = read(&self.radii, parse_rows)?;
        let normals = read(&self.normals, parse_rows)?;
        let centres = read(&self.centres, parse_rows)?;
        let families = match &self.families {
            Some(file) => read(file, parse_families)?,
            None => BTreeMap::new(),
        };
        let isolated = [&radii, &centres].map(|rows| rows.iter().filter(|r| r.removed).count());
        let kept = [radii, normals, centres].map(|mut rows| {
            rows.retain(|row| !row.removed);
            rows
        });
        self.one_run(&kept)?;
        let [radii, normals, centres] = &kept;
        let mut network = Network::default();
        let (mut by_corners, mut turned) = (0, 0);
        for ((radii, normal), centre) in radii.iter().zip(normals).zip(centres) {
            let [_, _, number] = radii.numbers;
            if number == BY_CORNERS {
                by_corners += 1;
                continue;
            }
            let family = families.get(&(number as i64)).copied();
            let one = Drawn {
                family: family.unwrap_or_default(),
                rectangle: number == RECTANGLES || family.is_some_and(|f| f.rectangles),
                normal: self.normal(normal)?,
                radii: self.radii(radii)?,
                centre: Vec3::from_array(centre.numbers),
            };
            turned += usize::from(one.unknown_turn());
            network.fractures.push((one.shape(), radii.line));
        }
        network.leave(isolated[0].max(isolated[1]), "dfnGen removed them as isolated (R)");
        let why = "they were given by their corners, which only polygons.dat contains";
        network.leave(by_corners, why);
        let files = [&self.radii, &self.normals, &self.centres];
        network.files = files.into_iter().chain(&self.families).map(|f| named(f)).collect();
        let stochastic = radii.iter().any(|row| row.numbers[2] > 0.0);
        if self.families.is_none() && stochastic {
            let text =
                format!("without {FAMILIES} all fractures of families are taken as ellipses");
            network.remarks.push(text);
        }
        if turned > 0 {
            network.remarks.push(format!(
                "these files do not give the in-plane angle of {turned} fractures; it is taken as 0 ({POLYGONS} has it)"
            ));
        }
        Ok(network)
    }

    /// Whether all lists are as long.
    fn one_run(&self, lists: &[Vec<Row>; 3]) -> Result<(), Refused> {
        let [radii, normals, centres] = lists.each_ref().map(Vec::len);
        let said = match &self.params {
            Some(file) => Some(read(file, |bytes| {
                let text = String::from_utf8_lossy(bytes);
                let count = words(&text).next().and_then(|word| word.parse::<usize>().ok());
                count.ok_or_else(|| at_line(1, "the number of fractures is expected"))
            })?),
            None => None,
        };
        if radii == normals && radii == centres && said.is_none_or(|said| said == radii) {
            return Ok(());
        }
        let [of_radii, of_normals, of_centres] =
            [&self.radii, &self.normals, &self.centres].map(|file| file.display());
        let mut message = format!(
            "`{of_radii}` has {radii} fractures, `{of_normals}` {normals} and `{of_centres}` {centres}"
        );
        if let Some(said) = said {
            message.push_str(&format!(", and {PARAMS} says {said}"));
        }
        Err(Refused { message, help: Some("all files must be from one run of dfnGen".to_owned()) })
    }

    fn normal(&self, row: &Row) -> Result<Vec3, Refused> {
        let normal = Vec3::from_array(row.numbers);
        normal.try_normalize().ok_or_else(|| {
            let what = "a normal must have non-zero length";
            refused(&self.normals, row, what)
        })
    }

    fn radii(&self, row: &Row) -> Result<[f64; 2], Refused> {
        let [x, y, family] = row.numbers;
        if x <= 0.0 || y <= 0.0 {
            return Err(refused(&self.radii, row, "radii must be above 0"));
        }
        if family.fract() != 0.0 || family.abs() > 1e9 {
            let what = "the third number of a row must be the family number, an integer";
            return Err(refused(&self.radii, row, what));
        }
        Ok([x, y])
    }
}

fn refused(file: &Path, row: &Row, what: &str) -> Refused {
    Refused { message: format!("`{}`, line {}: {what}", file.display(), row.line), help: None }
}

/// A fracture as the lists give it.
struct Drawn {
    family: Family,
    rectangle: bool,
    normal: Vec3,
    radii: [f64; 2],
    centre: Vec3,
}

impl Drawn {
    fn circle(&self) -> bool {
        !self.rectangle && self.radii[0] == self.radii[1]
    }

    /// Whether an angle matters that is not known.
    fn unknown_turn(&self) -> bool {
        self.family.turn.is_none() && !self.circle()
    }

    fn shape(&self) -> Shape {
        let at = self.centre;
        if self.circle() && self.family.corners.is_none() {
            return Shape::Disk { at, normal: self.normal, radius: self.radii[0] };
        }
        let [east, north] = frame(self.normal);
        // Clockwise, as dfnGen turns them.
        let angle = self.family.turn.unwrap_or(0.0) % TAU;
        let (sin, cos) = (libm::sin(angle), libm::cos(angle));
        let [long, short] = [
            self.radii[0] * (cos * east - sin * north),
            self.radii[1] * (sin * east + cos * north),
        ];
        if self.rectangle {
            let corners = [long + short, short - long, -long - short, long - short];
            return Shape::Corners(corners.map(|arm| at + arm).to_vec());
        }
        Shape::Ellipse { at, arms: [long, short], corners: self.family.corners.unwrap_or(CORNERS) }
    }
}

#[cfg(test)]
mod tests;
