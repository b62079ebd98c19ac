//! Printing results to stdout.

use std::io::{ErrorKind, Write};

use crate::diagnostics;

/// Prints `text` to stdout as it is.
///
/// A reader that has gone (`riprap fields | head`) ends the program quietly; any other error,
/// such as a full disk behind a redirection, ends it with the code for unwritten results.
pub fn print(text: &str) {
    let mut out = std::io::stdout().lock();
    // Flushed at once: at the end of the program nobody would see the error.
    if let Err(error) = out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        if error.kind() == ErrorKind::BrokenPipe {
            std::process::exit(0);
        }
        diagnostics::print_line("error", &format!("could not write to stdout: {error}"));
        std::process::exit(i32::from(crate::failure::NOT_WRITTEN));
    }
}

/// Prints `line` and a line end.
pub fn line(line: &str) {
    print(&format!("{line}\n"));
}

/// Rows in aligned columns: the first to the left, the others to the right.
pub fn table(heads: &[&str], rows: impl Iterator<Item = Vec<String>>) -> String {
    let rows: Vec<Vec<String>> = rows.collect();
    let mut widths: Vec<usize> = heads.iter().map(|head| head.chars().count()).collect();
    for row in &rows {
        for (width, cell) in widths.iter_mut().zip(row) {
            *width = (*width).max(cell.chars().count());
        }
    }
    let heads: Vec<String> = heads.iter().map(|head| (*head).to_owned()).collect();
    let mut text = String::new();
    for row in std::iter::once(&heads).chain(&rows) {
        let cells = row.iter().zip(&widths).enumerate().map(|(i, (cell, width))| {
            if i == 0 { format!("{cell:<width$}") } else { format!("{cell:>width$}") }
        });
        text.push_str(cells.collect::<Vec<_>>().join("  ").trim_end());
        text.push('\n');
    }
    text
}

#[cfg(test)]
mod tests {
    #[test]
    fn columns_are_aligned() {
        let rows = [vec!["a".to_owned(), "1".to_owned()], vec!["long".to_owned(), "20".to_owned()]];
        assert_eq!(super::table(&["x", "n"], rows.into_iter()), "x      n\na      1\nlong  20\n");
    }
}
