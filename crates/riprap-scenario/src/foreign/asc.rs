//! Grids of heights as text: the ASCII raster of ESRI.
//!
//! A head of words with a number each, then one line of heights for each row of cells, the northern row first. Cells of the
//! height `NODATA_value`, -9999 where the head is silent, have no ground; neither have cells with `nan` or `null`, and those with the
//! largest number of 32 bits, in as many digits as a program cares to write.
//!
//! Source: ESRI, "Esri ASCII raster format" (ArcGIS documentation); `dx` and `dy` as the driver AAIGrid of GDAL writes them.

use super::{FileError, at_line, shown, without_mark};

/// Height of cells without ground where the head does not name one.
const NOTHING: f64 = -9999.0;
/// Beyond it no height is meant: the largest number of 32 bits, which stands for no ground, is 3.4e38.
const HIGHEST: f64 = 1e30;
/// Most cells of a grid.
const MOST: usize = 4_000_000;

/// Heights at the centres of the cells of a grid, in the length unit of the file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Heights {
    /// Places of the columns, ascending.
    pub x: Vec<f64>,
    /// Places of the rows, ascending.
    pub y: Vec<f64>,
    /// Heights, row by row from the southern one, x running fastest; `None` where there is none.
    pub z: Vec<Option<f64>>,
}

#[derive(Default)]
struct Head {
    columns: Option<usize>,
    rows: Option<usize>,
    /// Place of the lower left cell: the number, and whether it is its centre.
    x: Option<(f64, bool)>,
    y: Option<(f64, bool)>,
    /// Edges of a cell along x and y.
    size: [Option<f64>; 2],
    nothing: Option<f64>,
}

/// The heights that the bytes of a file describe.
///
/// # Errors
/// The first thing that is wrong, with its line.
pub fn parse_asc(bytes: &[u8]) -> Result<Heights, FileError> {
    let text = String::from_utf8_lossy(without_mark(bytes));
    let mut lines = (1..).zip(text.lines()).peekable();
    let mut head = Head::default();
    while let Some((line, text)) = lines.next_if(|(_, text)| is_head(text)) {
        head.read(line, text)?;
    }
    let at = lines.peek().map_or(1, |(line, _)| *line);
    let missing = |word: &str| at_line(at, format!("the header has no `{word}`"));
    let columns = head.columns.ok_or_else(|| missing("ncols"))?;
    let rows = head.rows.ok_or_else(|| missing("nrows"))?;
    let [Some(wide), Some(high)] = head.size else {
        return Err(missing("cellsize"));
    };
    let x = head.x.ok_or_else(|| missing("xllcorner"))?;
    let y = head.y.ok_or_else(|| missing("yllcorner"))?;
    // A product that wraps round would make a huge grid look small.
    if columns < 2 || rows < 2 || columns.saturating_mul(rows) > MOST {
        let text = format!(
            "the grid has {columns} by {rows} cells; it needs at least 2 along each side and at most {MOST} in total"
        );
        return Err(at_line(at, text));
    }
    if [wide, high].iter().any(|size| *size <= 0.0) {
        return Err(at_line(at, "`cellsize` must be greater than zero"));
    }
    let places = |(start, centre): (f64, bool), size: f64, count: usize| -> Vec<f64> {
        // Heights stand at the centres of cells, half a cell from the corner.
        let first = if centre { 0.0 } else { 0.5 };
        (0..count).map(|k| start + (first + k as f64) * size).collect()
    };
    let cells = columns * rows;
    let nothing = head.nothing.unwrap_or(NOTHING);
    // No file has more heights than bytes, whatever its head says.
    let mut north_first = Vec::with_capacity(cells.min(bytes.len()));
    let mut last = at;
    for (line, text) in lines {
        last = line;
        for word in text.split_whitespace() {
            let height = height(line, word)?;
            if north_first.len() == cells {
                let text = format!(
                    "{columns} by {rows} cells need {cells} heights, but more follow here; correct `ncols` and `nrows`, or remove the surplus"
                );
                return Err(at_line(line, text));
            }
            north_first.push(height.filter(|height| nothing != *height));
        }
    }
    if north_first.len() != cells {
        let text = format!(
            "{columns} by {rows} cells need {cells} heights, but the file has {}",
            north_first.len()
        );
        return Err(at_line(last, text));
    }
    let z = north_first.chunks(columns).rev().flatten().copied().collect();
    Ok(Heights { x: places(x, wide, columns), y: places(y, high, rows), z })
}

/// Whether a line belongs to the head: it begins with a letter, or is empty.
fn is_head(text: &str) -> bool {
    let Some(word) = text.split_whitespace().next() else {
        return true;
    };
    let letter = word.starts_with(|c: char| c.is_ascii_alphabetic());
    // `inf` is a number that is wrong, not a word.
    letter && !is_nothing(word) && word.parse::<f64>().is_err()
}

/// Whether a word says that there is no height.
fn is_nothing(word: &str) -> bool {
    let word = word.trim_start_matches(['+', '-']).to_ascii_lowercase();
    let words = ["nan", "null", "none", "nodata", "n/a", "na"];
    // As programs of Microsoft write it: `1.#QNAN`, `nan(ind)`.
    words.contains(&word.as_str()) || word.starts_with("1.#") || word.starts_with("nan(")
}

/// A number, whose decimal sign may be a comma.
fn number(line: usize, word: &str) -> Result<f64, FileError> {
    let comma = word.matches(',').count() == 1 && !word.contains('.');
    let number = if comma { word.replace(',', ".").parse::<f64>() } else { word.parse::<f64>() };
    let number = number.ok().filter(|x| x.is_finite());
    number.ok_or_else(|| at_line(line, format!("`{}` is not a finite number", shown(word))))
}

/// A height, or nothing where there is no ground.
fn height(line: usize, word: &str) -> Result<Option<f64>, FileError> {
    if is_nothing(word) {
        return Ok(None);
    }
    Ok(Some(number(line, word)?).filter(|height| height.abs() < HIGHEST))
}

impl Head {
    fn read(&mut self, line: usize, text: &str) -> Result<(), FileError> {
        let mut words = text.split_whitespace();
        let Some(key) = words.next() else {
            return Ok(());
        };
        let (Some(word), None) = (words.next(), words.next()) else {
            return Err(at_line(line, format!("`{}` needs one number", shown(key))));
        };
        let count = || {
            let count = word.parse::<usize>().ok();
            count
                .ok_or_else(|| at_line(line, format!("`{}` is not a number of cells", shown(word))))
        };
        match key.to_ascii_lowercase().as_str() {
            "ncols" => self.columns = Some(count()?),
            "nrows" => self.rows = Some(count()?),
            "xllcorner" => self.x = Some((number(line, word)?, false)),
            "xllcenter" => self.x = Some((number(line, word)?, true)),
            "yllcorner" => self.y = Some((number(line, word)?, false)),
            "yllcenter" => self.y = Some((number(line, word)?, true)),
            "cellsize" => self.size = [Some(number(line, word)?); 2],
            "dx" => self.size[0] = Some(number(line, word)?),
            "dy" => self.size[1] = Some(number(line, word)?),
            // A word or a number that no height is: nothing is compared with it.
            "nodata_value" => self.nothing = height(line, word)?.or(Some(f64::NAN)),
            _ => {
                let text = format!(
                    "unknown header word `{}`; valid words: ncols, nrows, xllcorner or xllcenter, yllcorner or yllcenter, cellsize (or dx and dy), \
                     NODATA_value",
                    shown(key)
                );
                return Err(at_line(line, text));
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SMALL: &str = "ncols 3\nnrows 2\nxllcorner 10\nyllcorner -5\ncellsize 2\nNODATA_value -9999\n1 2 -9999\n4 5 6\n";

    #[test]
    fn rows_come_from_the_north() {
        let read = parse_asc(SMALL.as_bytes()).unwrap();
        assert_eq!(read.x, [11.0, 13.0, 15.0]);
        assert_eq!(read.y, [-4.0, -2.0]);
        let some = |z: &[f64]| z.iter().map(|z| Some(*z)).collect::<Vec<_>>();
        assert_eq!(read.z[..5], some(&[4.0, 5.0, 6.0, 1.0, 2.0]));
        assert_eq!(read.z[5], None);
        let centre = SMALL.replace("xllcorner", "XLLCENTER");
        assert_eq!(parse_asc(centre.as_bytes()).unwrap().x[0], 10.0);
    }

    /// The format takes -9999 where its head is silent; the ground fell to that height there.
    #[test]
    fn cells_without_ground_need_no_word_in_the_head() {
        let silent = SMALL.replace("NODATA_value -9999\n", "");
        assert_eq!(parse_asc(silent.as_bytes()), parse_asc(SMALL.as_bytes()));
        let other = SMALL.replace("NODATA_value -9999", "NODATA_value 4");
        let read = parse_asc(other.as_bytes()).unwrap();
        assert_eq!((read.z[0], read.z[5]), (None, Some(-9999.0)));
    }

    /// GDAL, QGIS and ArcGIS each have their way to say that there is no ground.
    #[test]
    fn cells_without_ground_have_many_names() {
        let right = parse_asc(SMALL.as_bytes()).unwrap();
        for (word, cell) in [
            ("nan", "nan"),
            ("NaN", "-nan"),
            ("-9999", "null"),
            ("null", "null"),
            ("-3.4028234663852886e+38", "-3.4028234663852886e+38"),
            ("-3.4028234663852886e+38", "-3.40282e38"),
            ("-3.40282346639e+38", "-3.4028234663852886e+38"),
            ("3.4e38", "3.4028235e+38"),
            ("-9999", "1.#QNAN"),
            ("-32768", "-32768.0"),
        ] {
            let text = SMALL.replace("NODATA_value -9999", &format!("NODATA_value {word}"));
            let text = text.replace("1 2 -9999", &format!("1 2 {cell}"));
            assert_eq!(parse_asc(text.as_bytes()).as_ref(), Ok(&right), "{word} {cell}");
        }
        // In the first cell too, where it could be taken for a word of the head.
        let first = SMALL.replace("1 2 -9999", "nan 2 3");
        assert_eq!(parse_asc(first.as_bytes()).unwrap().z[3], None);
    }

    #[test]
    fn cells_may_be_longer_than_wide_and_numbers_may_have_commas() {
        let read = parse_asc(SMALL.replace("cellsize 2", "dx 2\nDY 3").as_bytes()).unwrap();
        assert_eq!((read.x[1] - read.x[0], read.y[1] - read.y[0]), (2.0, 3.0));
        let comma = SMALL.replace("cellsize 2", "cellsize 2,0").replace("4 5 6", "4,0 5 6");
        assert_eq!(parse_asc(comma.as_bytes()), parse_asc(SMALL.as_bytes()));
    }

    #[test]
    fn says_what_is_wrong() {
        let error = |from: &str, to: &str| {
            let text = SMALL.replace(from, to);
            assert!(text != SMALL);
            parse_asc(text.as_bytes()).unwrap_err().to_string()
        };
        assert!(error("ncols 3\n", "").contains("no `ncols`"));
        assert!(error("cellsize 2", "cellsize 0").contains("greater than zero"));
        assert!(error("4 5 6", "4 5").contains("need 6 heights, but the file has 5"));
        let long = error("4 5 6", "4 5 6\n7\nx");
        assert!(
            long.starts_with("line 9: 3 by 2 cells need 6 heights, but more follow here"),
            "{long}"
        );
        assert!(error("4 5 6", "4 5 x").contains("line 8"));
        assert!(error("1 2 -9999", "inf 2 3").contains("line 7: `inf` is not a finite number"));
        assert!(error("1 2 -9999", "1 2 -inf").contains("not a finite number"));
        assert!(error("nrows 2", "nrows two").contains("line 2"));
        assert!(error("nrows 2", "nrows 1").contains("2 along each side"));
        assert!(error("nrows 2", "nrows 99999999999").contains("4000000"));
        assert!(error("cellsize 2", "dx 2").contains("no `cellsize`"));
        assert!(error("cellsize 2", "size 2").contains("unknown header word"));
        assert!(error("cellsize 2", "dx 2\ndy 0").contains("greater than zero"));
        assert!(error("cellsize 2", "cellsize").contains("needs one number"));
        assert!(parse_asc(b"").is_err());
    }
}
