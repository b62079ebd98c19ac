//! The page on embedding says how many crates the library brings.

use std::collections::BTreeSet;
use std::process::Command;

use super::{pages, read, repository};

/// Crates besides those of riprap that the library needs with these features.
fn crates(features: &[&str]) -> usize {
    let output = Command::new(env!("CARGO"))
        .args(["tree", "--package", "riprap", "--edges", "normal", "--prefix", "none"])
        .args(["--locked", "--offline", "--target", "x86_64-unknown-linux-gnu"])
        .args(features)
        .current_dir(repository())
        .output()
        .expect("cargo runs");
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let names = text.lines().map(|line| line.trim_end_matches(" (*)"));
    let foreign: BTreeSet<&str> = names.filter(|name| !name.starts_with("riprap")).collect();
    foreign.len()
}

#[test]
fn the_crates_of_the_library_are_counted() {
    let page = read(&pages().join("embedding.md"));
    for (features, row) in [
        (&["--no-default-features"][..], "| `default-features = false` |"),
        (&["--no-default-features", "--features", "scenario"], "| `scenario` |"),
        (&[], "| `scenario`, `plot` (default) |"),
    ] {
        let line = page.lines().find(|line| line.starts_with(row)).expect(row);
        let told = line.trim_end_matches('|').rsplit('|').next().unwrap_or_default().trim();
        assert_eq!(told, crates(features).to_string(), "{line}");
    }
}
