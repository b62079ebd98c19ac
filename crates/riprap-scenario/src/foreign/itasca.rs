//! Networks of fractures as 3DEC and PFC write them with `fracture export`.
//!
//! Source: Itasca, UDEC 7.0 documentation (that of 3DEC and PFC has the same page), Program Guide, "DFN-Related File Formats",
//! section "Itasca File Format": a header line and the number of fractures; for each its number, that of its properties and how many
//! corners it has; with one a disk by its position, dip, dip direction (degrees) and diameter; otherwise the corners, a line each,
//! and a line with dip and dip direction. The example of the page has numbers whose exponent follows without a letter (`2.03+00`).

use riprap_geom::Vec3;
use riprap_geom::polyhedron::joints::normal_of_dip;

use super::dfn::{Network, Shape, words};
use super::{FileError, at_line, shown};

/// A number; the letter before the exponent may be missing.
fn number(line: usize, word: &str) -> Result<f64, FileError> {
    let written = || {
        let sign = word.rfind(['+', '-']).filter(|place| *place > 0)?;
        let (mantissa, exponent) = word.split_at(sign);
        format!("{mantissa}e{exponent}").parse().ok()
    };
    let number = word.parse().ok().or_else(written);
    let number = number.filter(|x: &f64| x.is_finite());
    number.ok_or_else(|| at_line(line, format!("`{}` is not a finite number", shown(word))))
}

/// The numbers of a row that has `N`.
fn row<const N: usize>(line: usize, text: &str, what: &str) -> Result<[f64; N], FileError> {
    let mut numbers = [0.0; N];
    let mut found = words(text);
    for place in &mut numbers {
        let word = found.next().ok_or_else(|| at_line(line, what))?;
        *place = number(line, word)?;
    }
    match found.next() {
        Some(_) => Err(at_line(line, what)),
        None => Ok(numbers),
    }
}

/// The whole numbers of a row that has `N`.
fn whole<const N: usize>(text: &str) -> Option<[usize; N]> {
    let numbers: Option<Vec<usize>> = words(text).map(|word| word.parse().ok()).collect();
    numbers?.try_into().ok()
}

/// The fractures of a file of Itasca for models in space. The numbers of properties are not used.
///
/// # Errors
/// The first thing that is wrong, with its line.
pub fn parse_itasca(bytes: &[u8]) -> Result<Network, FileError> {
    let text = String::from_utf8_lossy(super::without_mark(bytes));
    // The first line is a comment, whatever it says.
    let lines = (1..).zip(text.lines()).skip(1);
    let mut lines = lines.filter(|(_, text)| words(text).next().is_some());
    let (begin, head) = lines.next().unwrap_or((1, ""));
    let [claimed] = whole(head).ok_or_else(|| {
        let text = "the number of fractures is expected after a header line: this is not an Itasca DFN file; FracMan files (BEGIN FORMAT) are read \
                    by the key `fab`";
        at_line(begin, text)
    })?;
    let mut network = Network::default();
    while let Some((line, text)) = lines.next() {
        let [_, _, count] = whole(text).ok_or_else(|| {
            let text = "a fracture begins with three integers: its number, that of its properties and its number of corners";
            at_line(line, text)
        })?;
        let shape = match count {
            1 => disk(&mut lines, line)?,
            0 | 2 => {
                let text = format!(
                    "a fracture in space has one corner (a disk) or at least three, not {count}; two corners belong to a model in the plane; export \
                     the network from 3DEC or PFC3D"
                );
                return Err(at_line(line, text));
            }
            _ => polygon(&mut lines, line, count)?,
        };
        network.fractures.push((shape, line));
    }
    let found = network.fractures.len();
    if found != claimed {
        let text = format!("{claimed} fractures are declared, but the file has {found}");
        return Err(at_line(begin, text));
    }
    Ok(network)
}

fn cut_off(begin: usize) -> FileError {
    let text = "the fracture that begins here is incomplete: the file is truncated";
    at_line(begin, text)
}

fn disk<'a>(
    lines: &mut impl Iterator<Item = (usize, &'a str)>,
    begin: usize,
) -> Result<Shape, FileError> {
    let (line, text) = lines.next().ok_or_else(|| cut_off(begin))?;
    let what = "a disk needs x, y, z, dip, dip direction and diameter";
    let [x, y, z, dip, direction, diameter] = row(line, text, what)?;
    if !(0.0..=180.0).contains(&dip) {
        let text = format!("the dip of a disk must be from 0 to 180 degrees, not {dip}");
        return Err(at_line(line, text));
    }
    if diameter <= 0.0 {
        let text = format!("the diameter of a disk must be above 0, not {diameter}");
        return Err(at_line(line, text));
    }
    Ok(Shape::Disk {
        at: Vec3::new(x, y, z),
        normal: normal_of_dip(dip.to_radians(), direction.to_radians()),
        radius: 0.5 * diameter,
    })
}

/// A polygon; its dip and dip direction follow from the corners.
fn polygon<'a>(
    lines: &mut impl Iterator<Item = (usize, &'a str)>,
    begin: usize,
    count: usize,
) -> Result<Shape, FileError> {
    let mut corners = Vec::new();
    for _ in 0..count {
        let (line, text) = lines.next().ok_or_else(|| cut_off(begin))?;
        let corner = row(line, text, "a corner needs x, y and z")?;
        corners.push(Vec3::from_array(corner));
    }
    let (line, text) = lines.next().ok_or_else(|| cut_off(begin))?;
    let what = "a row with dip and dip direction is expected after the corners of a fracture";
    let [_dip, _direction] = row(line, text, what)?;
    Ok(Shape::Corners(corners))
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = ";ITASCA DFN Geometry File \n3\n1 2 1 \n1.0 2.0+00 -3.0e+00 9.0+01 9.0000000+01 5.0-01\n\
        2 2 3\n0 0 0\n1.0+00 0 0\n0 0 2\n90 0\n7 1 1\n0 0 0 135 270 2\n";

    #[test]
    fn disks_and_polygons_are_read() {
        let network = parse_itasca(TEXT.as_bytes()).unwrap();
        assert_eq!(network.note(), "read 3 of 3 fractures");
        let lines: Vec<usize> = network.fractures.iter().map(|(_, line)| *line).collect();
        assert_eq!(lines, [3, 5, 10]);
        let disk = |k: usize| match network.fractures[k].0 {
            Shape::Disk { at, normal, radius } => (at, normal, radius),
            _ => panic!("a disk is expected"),
        };
        let (at, normal, radius) = disk(0);
        assert_eq!((at, radius), (Vec3::new(1.0, 2.0, -3.0), 0.25));
        // It dips to the east, x.
        assert!((normal - Vec3::X).length() < 1e-12);
        // Overturned: as a plane that dips at 45 deg to the east.
        let (_, normal, _) = disk(2);
        assert!((normal + Vec3::new(1.0, 0.0, 1.0).normalize()).length() < 1e-12);
        let corners = vec![Vec3::ZERO, Vec3::X, 2.0 * Vec3::Z];
        assert_eq!(network.fractures[1].0, Shape::Corners(corners));
        // Windows, blank lines and commas make no difference.
        let other = TEXT.replace('\n', "\r\n\r\n").replace(' ', ", ");
        let other = parse_itasca(other.as_bytes()).unwrap();
        assert!(other.fractures.iter().map(|f| &f.0).eq(network.fractures.iter().map(|f| &f.0)));
        assert!(parse_itasca(b"; none\n0\n").unwrap().fractures.is_empty());
    }

    #[test]
    fn says_what_is_wrong() {
        let said = |from: &str, to: &str| {
            let text = TEXT.replacen(from, to, 1);
            assert_ne!(text, TEXT, "{from}");
            parse_itasca(text.as_bytes()).unwrap_err().to_string()
        };
        for text in ["", "hello", "BEGIN FORMAT\n Format = Ascii\n"] {
            let error = parse_itasca(text.as_bytes()).unwrap_err().to_string();
            assert!(error.contains("not an Itasca DFN file"), "{error}");
        }
        for (from, to, says) in [
            ("\n3\n", "\n4\n", "line 2: 4 fractures are declared, but the file has 3"),
            (
                "\n3\n",
                "\n99999999999999999999\n",
                "line 2: the number of fractures is expected after a header line",
            ),
            ("1 2 1 ", "1 2", "line 3: a fracture begins with three integers"),
            (
                "2 2 3\n",
                "2 2 2\n",
                "line 5: a fracture in space has one corner (a disk) or at least three, not 2",
            ),
            ("2 2 3\n", "2 2 0\n", "at least three, not 0"),
            ("2 2 3\n", "2 2 18446744073709551615\n", "line 9: a corner needs x, y and z"),
            ("7 1 1", "7 1 3", "line 11: a corner needs x, y and z"),
            ("5.0-01", "", "line 4: a disk needs x, y, z, dip, dip direction and diameter"),
            ("5.0-01", "-5.0-01", "line 4: the diameter of a disk must be above 0, not -0.5"),
            (
                "9.0+01",
                "9.1+02",
                "line 4: the dip of a disk must be from 0 to 180 degrees, not 910",
            ),
            ("1.0+00 0 0", "1.0+00 0 x", "line 7: `x` is not a finite number"),
            ("1.0+00 0 0", "inf 0 0", "line 7: `inf` is not a finite number"),
            ("1.0+00 0 0", "1.0+999 0 0", "line 7: `1.0+999` is not a finite number"),
            ("90 0\n", "", "line 9: a row with dip and dip direction is expected"),
            ("0 0 0 135 270 2\n", "", "line 10: the fracture that begins here is incomplete"),
        ] {
            let error = said(from, to);
            assert!(error.contains(says), "{error}");
        }
    }
}
