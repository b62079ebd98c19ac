//! Printing results to stdout.

use std::io::{ErrorKind, Write};

/// Prints `text` to stdout as it is.
///
/// A reader that has gone (`riprap fields | head`) ends the program quietly; any other error,
/// such as a full disk behind a redirection, ends it with the code for unwritten results.
pub fn print(text: &str) {
    let mut out = std::io::stdout().lock();
    if let Err(error) = out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        if error.kind() == ErrorKind::BrokenPipe {
            std::process::exit(0);
        }
        eprintln!("error: could not write to stdout: {error}");
        std::process::exit(i32::from(crate::failure::NOT_WRITTEN));
    }
}

/// Prints `line` and a line end.
pub fn line(line: &str) {
    print(&format!("{line}\n"));
}
