//! Networks of fractures as the programs that make them write them: FracMan (`.fab`) and dfnWorks. Its lists of centres, normals
//! and radii are read by [`super::dfnworks`], files of Itasca by [`super::itasca`].
//!
//! Sources: the sections and rows of `.fab` as public readers of the format take them (a row `number, corners, set, properties`, a
//! row with each corner, a row `0` with the normal); dfnWorks, "dfnGen: output files" (`polygons.dat`).

use riprap_geom::Vec3;

use super::{FileError, at_line, shown};

/// What a file of fractures holds.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Network {
    /// Fractures and the lines in which they begin.
    pub fractures: Vec<(Shape, usize)>,
    /// Length of a unit of the file, m, if it says so.
    pub unit: Option<f64>,
    /// Fractures that are not read, and why.
    pub left: Vec<(usize, &'static str)>,
    /// The files it was read from if they were found beside the one that was named; lines are those of the first.
    pub files: Vec<String>,
    /// What else the reader should know: what was assumed.
    pub remarks: Vec<String>,
}

/// A fracture, in the length unit of its file.
#[derive(Clone, Debug, PartialEq)]
pub enum Shape {
    /// A polygon: its corners in their order.
    Corners(Vec<Vec3>),
    /// A disk.
    Disk {
        /// Its centre.
        at: Vec3,
        /// Its unit normal.
        normal: Vec3,
        /// Its radius.
        radius: f64,
    },
    /// An ellipse, as a polygon inscribed into it.
    Ellipse {
        /// Its centre.
        at: Vec3,
        /// From the centre to the ends of its axes.
        arms: [Vec3; 2],
        /// Corners of the polygon, the first at the end of the first axis.
        corners: u32,
    },
}

impl Network {
    /// Notes that `count` fractures are not read, if there are any.
    pub(super) fn leave(&mut self, count: usize, why: &'static str) {
        if count > 0 {
            self.left.push((count, why));
        }
    }

    /// How much was read, and what was left out and why.
    #[must_use]
    pub fn note(&self) -> String {
        let read = self.fractures.len();
        let all = read + self.left.iter().map(|(count, _)| count).sum::<usize>();
        let mut note = format!("read {read} of {all} fractures");
        if !self.files.is_empty() {
            note.push_str(&format!(" from {}", self.files.join(", ")));
        }
        for (count, why) in &self.left {
            note.push_str(&format!("; left out {count} because {why}"));
        }
        for remark in &self.remarks {
            note.push_str(&format!("; {remark}"));
        }
        note
    }
}

/// Words of a line with its number, without a comment behind `#` or `;`.
pub(super) fn words(line: &str) -> impl Iterator<Item = &str> {
    let text = line.split(['#', ';']).next().unwrap_or_default();
    text.split(|c: char| c.is_whitespace() || c == ',').filter(|word| !word.is_empty())
}

pub(super) fn numbers(line: usize, found: &[&str]) -> Result<Vec<f64>, FileError> {
    let number = |word: &&str| {
        let number = word.parse::<f64>().ok().filter(|x| x.is_finite());
        number.ok_or_else(|| at_line(line, format!("`{}` is not a finite number", shown(word))))
    };
    found.iter().map(number).collect()
}

/// The fractures of a file of FracMan.
///
/// # Errors
/// The first thing that is wrong, with its line.
pub fn parse_fab(bytes: &[u8]) -> Result<Network, FileError> {
    let text = String::from_utf8_lossy(super::without_mark(bytes));
    let mut network = Network::default();
    let mut lines = (1..).zip(text.lines());
    let (mut sections, mut last, mut tessellated) = (0, 1, 0);
    while let Some((line, text)) = lines.next() {
        last = line;
        let mut first = text.split_whitespace();
        if !first.next().is_some_and(|word| word.eq_ignore_ascii_case("BEGIN")) {
            continue;
        }
        sections += 1;
        match first.next().unwrap_or_default().to_uppercase().as_str() {
            "FORMAT" => format_section(&mut lines, &mut network)?,
            "FRACTURE" => fracture_section(&mut lines, line, &mut network)?,
            "TESSFRACTURE" => tessellated += tessellated_section(&mut lines, line)?,
            // Names of properties and sets, blocks of rock.
            _ => {}
        }
    }
    if sections == 0 {
        return Err(at_line(
            last,
            "there is no section `BEGIN FRACTURE`: this is not a FracMan file",
        ));
    }
    network.leave(tessellated, "they are surfaces of triangles");
    if network.fractures.is_empty() && network.left.is_empty() {
        return Err(at_line(last, "there are no fractures"));
    }
    Ok(network)
}

/// Whether a line ends its section.
fn is_end(text: &str) -> bool {
    let first = text.split_whitespace().next();
    first.is_some_and(|word| word.eq_ignore_ascii_case("END"))
}

fn format_section<'a>(
    lines: &mut impl Iterator<Item = (usize, &'a str)>,
    network: &mut Network,
) -> Result<(), FileError> {
    for (line, text) in lines {
        if is_end(text) {
            return Ok(());
        }
        let Some((key, value)) = text.split_once('=') else {
            continue;
        };
        let (key, value) = (key.trim().to_lowercase(), value.trim().trim_matches('"'));
        match key.as_str() {
            "format" if !value.eq_ignore_ascii_case("ascii") => {
                let text = format!("the format is `{}`: save the file as ASCII", shown(value));
                return Err(at_line(line, text));
            }
            "length_unit" => {
                let unit = crate::units::spelled(&value.to_lowercase());
                let read = crate::units::parse(&format!("1 {unit}"));
                match read {
                    Ok((unit, crate::units::Dim::LENGTH)) => network.unit = Some(unit),
                    Ok(_) | Err(_) => {
                        let text = format!("`{}` is not a unit of length", shown(value));
                        return Err(at_line(line, text));
                    }
                }
            }
            _ => {}
        }
    }
    Ok(())
}

/// Rows of the section of fractures: a head, as many corners as it says, and the normal.
fn fracture_section<'a>(
    lines: &mut impl Iterator<Item = (usize, &'a str)>,
    begin: usize,
    network: &mut Network,
) -> Result<(), FileError> {
    while let Some((line, text)) = lines.next() {
        if is_end(text) {
            return Ok(());
        }
        let head: Vec<&str> = words(text).collect();
        if head.is_empty() {
            continue;
        }
        let count = head.get(1).and_then(|word| word.parse::<usize>().ok());
        let count = count.filter(|count| *count >= 3);
        let count = count.ok_or_else(|| {
            at_line(
                line,
                "a fracture begins with its number and its number of corners, at least three",
            )
        })?;
        let mut corners = Vec::new();
        for _ in 0..count {
            let (line, text) = lines.next().ok_or_else(|| cut_off(begin))?;
            let row: Vec<&str> = words(text).collect();
            let [_, x, y, z] = numbers(line, &row)?[..] else {
                return Err(at_line(line, "a corner needs its number and x, y, z"));
            };
            corners.push(Vec3::new(x, y, z));
        }
        let (_, normal) = lines.next().ok_or_else(|| cut_off(begin))?;
        if words(normal).next() != Some("0") {
            let text = "a row `0` with the normal is expected after the corners of a fracture";
            return Err(at_line(line + count + 1, text));
        }
        network.fractures.push((Shape::Corners(corners), line));
    }
    Err(cut_off(begin))
}

/// Counts the fractures that are surfaces of triangles: a head `number, corners, triangles, set` and a row for each.
fn tessellated_section<'a>(
    lines: &mut impl Iterator<Item = (usize, &'a str)>,
    begin: usize,
) -> Result<usize, FileError> {
    let mut count = 0;
    while let Some((_, text)) = lines.next() {
        if is_end(text) {
            return Ok(count);
        }
        let mut head = words(text).skip(1).map_while(|word| word.parse::<usize>().ok());
        let (Some(corners), Some(triangles)) = (head.next(), head.next()) else {
            continue;
        };
        count += 1;
        for _ in 0..corners.saturating_add(triangles) {
            let row = lines.next().ok_or_else(|| cut_off(begin))?;
            if is_end(row.1) {
                return Ok(count);
            }
        }
    }
    Err(cut_off(begin))
}

fn cut_off(begin: usize) -> FileError {
    at_line(begin, "the section that begins here has no end: the file is truncated")
}

/// The polygons of dfnWorks: `nPolygons: n`, then for each its number of corners and these in braces.
///
/// # Errors
/// The first thing that is wrong, with its line.
pub fn parse_polygons(bytes: &[u8]) -> Result<Network, FileError> {
    let text = String::from_utf8_lossy(super::without_mark(bytes));
    let mut lines = (1..).zip(text.lines()).filter(|(_, text)| words(text).next().is_some());
    let (line, head) = lines.next().unwrap_or((1, ""));
    let claimed =
        head.split_once(':').filter(|(key, _)| key.trim().eq_ignore_ascii_case("nPolygons"));
    let claimed = claimed.and_then(|(_, count)| count.trim().parse::<usize>().ok());
    let claimed = claimed.ok_or_else(|| {
        at_line(
            line,
            "`nPolygons:` and a number are expected: this is not a polygons.dat of dfnWorks; its lists are recognised by their names, \
             radii_Final.dat, normal_vectors.dat and translations.dat",
        )
    })?;
    let mut network = Network::default();
    for (line, text) in lines {
        let row = text.replace(['{', '}', '(', ')'], " ");
        let row: Vec<&str> = words(&row).collect();
        let row = numbers(line, &row)?;
        // Braces alone make a line without a number.
        let places = row.get(1..).unwrap_or_default().chunks_exact(3);
        let places: Vec<Vec3> = places.map(Vec3::from_slice).collect();
        if row.len() % 3 != 1 || row[0] != places.len() as f64 || places.len() < 3 {
            let text = "a polygon needs its number of corners, at least three, and x, y, z of each";
            return Err(at_line(line, text));
        }
        network.fractures.push((Shape::Corners(places), line));
    }
    if network.fractures.len() != claimed {
        let text = format!(
            "{claimed} polygons are declared, but the file has {}",
            network.fractures.len()
        );
        return Err(at_line(line, text));
    }
    Ok(network)
}

#[cfg(test)]
mod tests {
    use super::*;

    const FAB: &str = "BEGIN FORMAT\n  Format = Ascii\n  Length_Unit = Meter\n  No_Fractures = 2\nEND FORMAT\n\
        BEGIN PROPERTIES\n Prop1 = (Real*4) \"Transmissivity\"\nEND PROPERTIES\nBEGIN FRACTURE\n\
        1 4 1 1e-9 0.5\n 1 0 0 1\n 2 1 0 1\n 3 1 1 1\n 4 0 1 1\n 0 0 0 1\n\
        2 3 1 1e-9 0.5\n 1 0 0 0\n 2 1 0 0\n 3 0 0 1\n 0 0 1 0\nEND FRACTURE\n\
        BEGIN TESSFRACTURE\n5 3 1 1\n 1 0 0 0\n 2 1 0 0\n 3 0 1 0\n 1 2 3\nEND TESSFRACTURE\nBEGIN ROCKBLOCK\nEND ROCKBLOCK\n";
    const POLYGONS: &str = "nPolygons: 2\n4 {0, 0, 1} {1, 0, 1} {1, 1, 1} {0, 1, 1}\n3 {0, 0, 0} {1, 0, 0} {0, 0, 1}\n";

    #[test]
    fn both_programs_write_the_same_fractures() {
        let fab = parse_fab(FAB.as_bytes()).unwrap();
        assert_eq!(fab.unit, Some(1.0));
        let note = "read 2 of 3 fractures; left out 1 because they are surfaces of triangles";
        assert_eq!(fab.note(), note);
        let polygons = parse_polygons(POLYGONS.as_bytes()).unwrap();
        let corners = |network: &Network| -> Vec<Shape> {
            let shapes = network.fractures.iter().map(|(shape, _)| shape);
            shapes.cloned().collect()
        };
        assert_eq!(corners(&fab), corners(&polygons));
        assert_eq!(fab.fractures[1].1, 16);
        let feet = FAB.replace("Meter", "Feet");
        assert_eq!(parse_fab(feet.as_bytes()).unwrap().unit, Some(0.3048));
    }

    #[test]
    fn says_what_is_wrong() {
        let fab = |from: &str, to: &str| {
            let text = FAB.replace(from, to);
            assert_ne!(text, FAB);
            parse_fab(text.as_bytes()).unwrap_err().to_string()
        };
        assert!(parse_fab(b"hello").unwrap_err().to_string().contains("not a FracMan file"));
        assert!(fab("= Ascii", "= Binary").contains("line 2: the format is `Binary`"));
        assert!(fab("Meter", "Cubits").contains("line 3: `Cubits` is not a unit"));
        assert!(fab("1 4 1 1e-9", "1 2 1 1e-9").contains("line 10: a fracture begins"));
        assert!(fab(" 2 1 0 1\n", " 2 1 0\n").contains("line 12: a corner needs its number"));
        assert!(fab(" 2 1 0 1\n", " 2 1 x 1\n").contains("line 12: `x` is not a finite number"));
        assert!(fab(" 4 0 1 1\n", "").contains("line 15: a row `0`"), "{}", fab(" 4 0 1 1\n", ""));
        assert!(
            fab("END FRACTURE", "").contains("truncated")
                || fab("END FRACTURE", "").contains("a fracture begins")
        );
        let polygons = |from: &str, to: &str| {
            let text = POLYGONS.replace(from, to);
            parse_polygons(text.as_bytes()).unwrap_err().to_string()
        };
        assert!(polygons("nPolygons", "n").contains("not a polygons.dat"));
        assert!(polygons("2\n4", "3\n4").contains("3 polygons are declared, but the file has 2"));
        assert!(polygons("3 {", "4 {").contains("line 3: a polygon needs its number of corners"));
        assert!(polygons("0, 0, 0}", "0, 0, a}").contains("line 3: `a`"));
        assert!(polygons("\n3 {", "\n{}\n3 {").contains("line 3: a polygon needs its number"));
    }
}
