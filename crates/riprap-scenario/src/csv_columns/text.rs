//! The text of a CSV file: its letters, its separator, its head, its rows.

use super::CsvError;

/// Byte order marks of texts of two bytes a letter.
const LITTLE: [u8; 2] = [0xff, 0xfe];
const BIG: [u8; 2] = [0xfe, 0xff];

/// A table of texts, read row by row.
pub(super) struct Rows<'a> {
    /// What stands between cells.
    pub separator: u8,
    /// Names of the columns.
    pub head: Vec<String>,
    /// Cells of the row that was read last.
    pub row: csv::StringRecord,
    /// Its line in the file, counted from 1.
    pub line: usize,
    /// Rows so far without any text in their cells.
    pub empty: usize,
    reader: csv::Reader<&'a [u8]>,
    /// Lines in front of the text of the reader.
    skipped: usize,
}

/// The letters of a file: UTF-8, or UTF-16 with its mark, or Latin-1.
pub(super) fn decode(bytes: &[u8]) -> Result<String, CsvError> {
    let wide = |rest: &[u8], letter: fn([u8; 2]) -> u16| {
        let letters = rest.chunks_exact(2).map(|pair| letter([pair[0], pair[1]]));
        String::from_utf16_lossy(&letters.collect::<Vec<u16>>())
    };
    let text = if let Some(rest) = bytes.strip_prefix(&LITTLE) {
        wide(rest, u16::from_le_bytes)
    } else if let Some(rest) = bytes.strip_prefix(&BIG) {
        wide(rest, u16::from_be_bytes)
    } else {
        match std::str::from_utf8(bytes) {
            Ok(text) => text.to_owned(),
            Err(_) => bytes.iter().map(|byte| char::from(*byte)).collect(),
        }
    };
    let strange = |c: char| c.is_ascii_control() && !matches!(c, '\t' | '\n' | '\r' | '\u{c}');
    if text.contains(strange) {
        return Err(CsvError::new("this is not a text file", "save it as CSV in UTF-8"));
    }
    Ok(match text.strip_prefix('\u{feff}') {
        Some(rest) => rest.to_owned(),
        None => text,
    })
}

/// Divides a text into head and rows.
///
/// The separator is the one of tab, semicolon and comma that the line of the head has most of, outside of quotes; a
/// first line `sep=;` names it. Lines that begin with `#` are comments; the last of them before rows of numbers may be
/// the head.
pub(super) fn rows(text: &str) -> Result<Rows<'_>, CsvError> {
    let (named, text, skipped) = named_separator(text);
    let lines = text.lines().filter(|line| !line.trim().is_empty());
    let is_comment = |line: &&str| line.starts_with('#');
    let first = lines.clone().find(|line| !is_comment(line));
    let first = first.ok_or_else(empty)?;
    let separator = named.unwrap_or_else(|| separator_of(first));
    // Behind the `#` of the last comment before the numbers, as some programs write the names.
    let above = lines
        .take_while(is_comment)
        .last()
        .map(|line| cells_of(line.trim_start_matches('#'), separator));
    let own = cells_of(first, separator);
    let numbers = |cells: &[String]| cells.iter().all(|cell| looks_like_number(cell));
    let (head, in_rows) = match above {
        Some(above) if numbers(&own) && above.len() == own.len() && !numbers(&above) => {
            (above, true)
        }
        Some(_) | None => (own, false),
    };
    if head.iter().all(String::is_empty) {
        return Err(empty());
    }
    if numbers(&head) {
        return Err(CsvError::new(
            "there are numbers where column names are expected",
            "the first line must name the columns, for example `t_s,a_m_s2`",
        ));
    }
    let reader = csv::ReaderBuilder::new()
        .comment(Some(b'#'))
        .delimiter(separator)
        .has_headers(!in_rows)
        .flexible(true)
        .trim(csv::Trim::All)
        .from_reader(text.as_bytes());
    Ok(Rows { separator, head, row: csv::StringRecord::new(), line: 0, empty: 0, reader, skipped })
}

impl Rows<'_> {
    /// Reads the next row that has any text; false at the end.
    pub(super) fn next(&mut self) -> Result<bool, CsvError> {
        loop {
            let read = self.reader.read_record(&mut self.row);
            if !read.map_err(|error| CsvError::new(&error.to_string(), ""))? {
                return Ok(false);
            }
            let line = self.row.position().map_or(0, csv::Position::line);
            self.line = line as usize + self.skipped;
            if self.row.iter().all(str::is_empty) {
                self.empty += 1;
                continue;
            }
            let mut spare = self.row.iter().skip(self.head.len());
            if self.row.len() < self.head.len() || !spare.all(str::is_empty) {
                return Err(self.ragged(self.line, self.row.len()));
            }
            return Ok(true);
        }
    }

    /// A row with another number of cells than the head.
    fn ragged(&self, line: usize, cells: usize) -> CsvError {
        let head = self.head.len();
        let help = match self.separator {
            b',' if cells > head => {
                "every row needs one cell per column; with decimal commas separate cells by semicolons or tabs"
            }
            _ => "every row needs one cell per column",
        };
        let message = format!("line {line} has {cells} cells, but the header has {head}");
        CsvError::new(&message, help)
    }
}

fn empty() -> CsvError {
    CsvError::new("the file is empty", "the first line names the columns, for example `t_s,a_m_s2`")
}

/// The separator that a first line `sep=;` names, the text behind that line, and the number of lines taken.
fn named_separator(text: &str) -> (Option<u8>, &str, usize) {
    let (first, rest) = text.split_once('\n').unwrap_or((text, ""));
    let named = first.trim_end_matches('\r').trim_matches('"');
    match named.strip_prefix("sep=").map(str::as_bytes) {
        Some([byte @ (b',' | b';' | b'\t')]) => (Some(*byte), rest, 1),
        Some(_) | None => (None, text, 0),
    }
}

/// The separator of a line of names.
fn separator_of(line: &str) -> u8 {
    let mut quoted = false;
    let mut counts = [(b'\t', 0_usize), (b';', 0), (b',', 0)];
    for byte in line.bytes() {
        if byte == b'"' {
            quoted = !quoted;
        } else if let Some((_, count)) = counts.iter_mut().find(|(c, _)| *c == byte && !quoted) {
            *count += 1;
        }
    }
    let most = counts.iter().map(|(_, count)| *count).max().unwrap_or(0);
    match counts.iter().find(|(_, count)| *count == most) {
        Some((separator, 1..)) => *separator,
        Some(_) | None => b',',
    }
}

/// Cells of one line.
fn cells_of(line: &str, separator: u8) -> Vec<String> {
    let mut reader = csv::ReaderBuilder::new()
        .delimiter(separator)
        .has_headers(false)
        .trim(csv::Trim::All)
        .from_reader(line.as_bytes());
    let record = reader.records().next().and_then(Result::ok);
    let record = record.unwrap_or_default();
    record.iter().map(str::to_owned).collect()
}

/// Whether a cell is a number with either decimal sign.
fn looks_like_number(cell: &str) -> bool {
    cell.replacen(',', ".", 1).parse::<f64>().is_ok()
}
