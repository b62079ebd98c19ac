//! The pages of `docs/` say what is true: generated ones are fresh, commands work, links lead somewhere.
//!
//! With `RIPRAP_WRITE_DOCS=1` generated pages and pictures are written instead of compared.

mod console;
mod crates;
mod generated;
mod links;
mod quotes;

use std::path::{Path, PathBuf};

/// The root of the repository.
fn repository() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().and_then(Path::parent).expect("two levels up")
}

/// `docs/src`.
fn pages() -> PathBuf {
    repository().join("docs/src")
}

/// Whether pages are to be written rather than compared.
fn writing() -> bool {
    std::env::var_os("RIPRAP_WRITE_DOCS").is_some_and(|v| v == "1")
}

fn read(path: &Path) -> String {
    std::fs::read_to_string(path)
        .unwrap_or_else(|e| panic!("{}: {e}", path.display()))
        .replace("\r\n", "\n")
}
