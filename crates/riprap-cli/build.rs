//! Embeds the scenes of `scenes/planar` and `scenes/spatial` as the templates of `riprap new`: whoever adds a
//! scene there adds a template. Names are those of the files, so no name may stand in both folders.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};

fn main() {
    let manifest = PathBuf::from(std::env::var_os("CARGO_MANIFEST_DIR").unwrap_or_default());
    println!("cargo::rerun-if-changed=build.rs");
    let mut table = String::from("pub const TEMPLATES: &[Template] = &[\n");
    for folder in ["planar", "spatial"] {
        let scenes = manifest.join("../../scenes").join(folder);
        // A folder that is not there (a packaged crate) adds nothing.
        println!("cargo::rerun-if-changed={}", scenes.display());
        add_templates(&scenes, &mut table);
    }
    table.push_str("];\n");
    let out = PathBuf::from(std::env::var_os("OUT_DIR").unwrap_or_default());
    if let Err(error) = std::fs::write(out.join("templates.rs"), table) {
        println!("cargo::error=could not write the templates: {error}");
    }
}

/// One entry for each scene of a folder.
fn add_templates(scenes: &Path, table: &mut String) {
    for path in toml_files(scenes) {
        let Ok(text) = std::fs::read_to_string(&path) else {
            continue;
        };
        let (Some(name), Some(about)) = (path.file_stem(), title(&text)) else {
            continue;
        };
        // Writing to a String cannot fail.
        let _ = writeln!(
            table,
            "Template {{ name: {:?}, about: {about:?}, text: include_str!({path:?}), files: &[",
            name.to_string_lossy()
        );
        for file in csv_files(&text) {
            let full = scenes.join(&file);
            if full.exists() {
                let _ = writeln!(table, "({file:?}, include_str!({full:?})),");
            }
        }
        table.push_str("] },\n");
    }
}

fn toml_files(folder: &Path) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder).into_iter().flatten().flatten();
    let mut paths: Vec<PathBuf> = entries
        .map(|e| e.path())
        .filter(|p| p.extension().is_some_and(|e| e == "toml"))
        .collect();
    paths.sort();
    paths
}

/// The value of the first `title = "…"`.
fn title(text: &str) -> Option<String> {
    let line = text.lines().find(|line| line.starts_with("title"))?;
    line.split('"').nth(1).map(str::to_owned)
}

/// Every quoted name that ends in `.csv`, once.
fn csv_files(text: &str) -> Vec<String> {
    let mut names: Vec<String> = text
        .lines()
        .filter(|line| !line.trim_start().starts_with('#'))
        .flat_map(|line| line.split('"').skip(1).step_by(2))
        .filter(|word| word.ends_with(".csv"))
        .map(str::to_owned)
        .collect();
    names.sort();
    names.dedup();
    names
}
