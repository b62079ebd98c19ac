//! `cargo xtask bench`: speed of the planar and the spatial step, as CSV.

use std::ffi::OsStr;
use std::path::Path;
use std::process::{Command, ExitCode};

use crate::shell::cargo;
use crate::source_tree::files;

/// Cases that a benchmark scene has: the scene as it stands and two variants.
const SIZES: [&str; 3] = ["default", "medium", "large"];

/// Builds the benchmark of the library and runs it on every scene under `scenes/bench` in three sizes, each
/// in its own process; the CSV is printed and kept in `target/bench.csv`.
pub fn run(root: &Path) -> ExitCode {
    match measure(root) {
        Ok(()) => ExitCode::SUCCESS,
        Err(why) => {
            eprintln!("{why}");
            ExitCode::FAILURE
        }
    }
}

fn measure(root: &Path) -> Result<(), String> {
    let mut kept: Vec<String> = Vec::new();
    for scene in files(&root.join("scenes").join("bench"), &["toml"]) {
        for size in SIZES {
            for line in timed(root, &scene, size)?.lines() {
                // The machine and the head of the table stand in every output, and once in the whole.
                if kept.iter().all(|known| known != line) {
                    println!("{line}");
                    kept.push(line.to_owned());
                }
            }
        }
    }
    let path = root.join("target").join("bench.csv");
    std::fs::write(&path, kept.join("\n") + "\n")
        .map_err(|error| format!("{} could not be written: {error}", path.display()))?;
    println!("kept in {}", path.display());
    for (name, file) in [
        ("bench_spatial", "bench-spatial.csv"),
        ("bench_deform", "bench-deform.csv"),
    ] {
        let table = example(root, name, &[])?;
        print!("{table}");
        let path = root.join("target").join(file);
        std::fs::write(&path, table)
            .map_err(|error| format!("{} could not be written: {error}", path.display()))?;
        println!("kept in {}", path.display());
    }
    Ok(())
}

/// What the benchmark prints about one size of one scene.
fn timed(root: &Path, scene: &Path, size: &str) -> Result<String, String> {
    example(root, "bench_planar", &[scene.as_os_str(), size.as_ref()])
        .map_err(|why| format!("{} ({size}): {why}", scene.display()))
}

/// What an example of the library prints.
fn example(root: &Path, name: &str, words: &[&OsStr]) -> Result<String, String> {
    let output = Command::new(cargo())
        .args(["run", "--release", "--quiet", "--package", "riprap"])
        .args(["--example", name, "--"])
        .args(words)
        .current_dir(root)
        .output()
        .map_err(|error| format!("cargo could not be started: {error}"))?;
    if !output.status.success() {
        return Err(String::from_utf8_lossy(&output.stderr).into_owned());
    }
    Ok(String::from_utf8_lossy(&output.stdout).into_owned())
}
