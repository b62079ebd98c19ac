//! The embedded page was made from the sources in `viewer/`. Needs no Node: the hash was recorded when it was built.

use sha2::{Digest, Sha256};
use std::path::{Path, PathBuf};

fn viewer() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../viewer")
}

/// Names of all files under `folder`, relative to `viewer/`, with slashes.
fn names(folder: &Path, prefix: &str, found: &mut Vec<String>) {
    for entry in std::fs::read_dir(folder).expect("viewer/src") {
        let entry = entry.expect("an entry");
        let name = format!("{prefix}/{}", entry.file_name().to_string_lossy());
        if entry.path().is_dir() {
            names(&entry.path(), &name, found);
        } else {
            found.push(name);
        }
    }
}

#[test]
fn the_bundle_is_not_stale() {
    let viewer = viewer();
    let mut all: Vec<String> = ["build.mjs", "package.json", "package-lock.json", "tsconfig.json"]
        .map(str::to_owned)
        .to_vec();
    names(&viewer.join("src"), "src", &mut all);
    all.sort();
    let mut hash = Sha256::new();
    for name in &all {
        let text = std::fs::read_to_string(viewer.join(name)).expect("a source of the page");
        hash.update(format!("{name}\n"));
        hash.update(text.replace("\r\n", "\n"));
    }
    let now = hash.finalize().iter().fold(String::new(), |text, b| format!("{text}{b:02x}"));
    let recorded = include_str!("../assets/sources.sha256").trim();
    assert_eq!(
        now, recorded,
        "the page was changed and not built: cd viewer && npm ci && npm run build, then commit crates/riprap-view/assets"
    );
}

#[test]
fn the_bundle_asks_nobody_else() {
    let assets = Path::new(env!("CARGO_MANIFEST_DIR")).join("assets");
    let page = std::fs::read_to_string(assets.join("index.html")).expect("the page");
    assert!(!page.contains("http"), "the page names another address");
    let style = std::fs::read_to_string(assets.join("app.css")).expect("the style");
    assert!(!style.contains("@import") && !style.contains("url(http"));
}
