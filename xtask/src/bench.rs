//! `cargo xtask bench`: speed of the planar and the spatial step, and of `riprap run`, as CSV.

mod gas;
mod threads;

use std::ffi::OsStr;
use std::path::Path;
use std::process::Command;
use std::time::Instant;

pub use gas::gas;
pub use threads::threads;

use crate::shell::cargo;
use crate::source_tree::files;
use threads::stages_of;

/// Cases that a benchmark scene has: the scene as it stands and two variants.
const SIZES: [&str; 3] = ["default", "medium", "large"];

/// Builds the benchmark of the library and runs it on every scene under `scenes/bench` in three sizes, each
/// in its own process; the CSV is printed and kept in `target/bench.csv`.
pub fn run(root: &Path) -> Result<bool, String> {
    let mut known: Vec<String> = Vec::new();
    for scene in files(&root.join("scenes").join("bench"), &["toml"]) {
        let text = std::fs::read_to_string(&scene)
            .map_err(|error| format!("{} could not be read: {error}", scene.display()))?;
        // Those of the viewer and of `riprap run` alone have no phase before the one that is timed.
        if text.matches("[[phases]]").count() < 2 {
            continue;
        }
        for size in SIZES {
            // The machine and the head of the table stand in every output, and once in the whole.
            for line in example(root, "bench_scene", &[scene.as_os_str(), size.as_ref()])?.lines() {
                if known.iter().all(|known| known != line) {
                    println!("{line}");
                    known.push(line.to_owned());
                }
            }
        }
    }
    keep(root, "bench.csv", &(known.join("\n") + "\n"))?;
    for (name, file) in
        [("bench_spatial", "bench-spatial.csv"), ("bench_deform", "bench-deform.csv")]
    {
        let table = example(root, name, &[])?;
        print!("{table}");
        keep(root, file, &table)?;
    }
    let table = commands(root)?;
    print!("{table}");
    keep(root, "bench-run.csv", &table)?;
    Ok(true)
}

fn keep(root: &Path, file: &str, table: &str) -> Result<(), String> {
    let path = root.join("target").join(file);
    std::fs::write(&path, table)
        .map_err(|error| format!("{} could not be written: {error}", path.display()))?;
    println!("kept in {}", path.display());
    Ok(())
}

/// Scenes on which `riprap run` is timed: name of the file, steps of its last phase in each of the [`SIZES`]: long enough
/// for looks, records and checkpoints to come in their rhythm.
const RUNS: [(&str, [u64; 3]); 5] = [
    ("wall", [20_000, 4_000, 600]),
    ("lattice", [20_000, 3_000, 300]),
    ("rubble", [2_000, 300, 100]),
    ("masonry", [2_000, 300, 100]),
    ("blast_throw", [2_000, 300, 100]),
];

/// Builds the command as users have it.
fn release(root: &Path) -> Result<(), String> {
    let built = Command::new(cargo())
        .args(["build", "--release", "--quiet", "--package", "riprap-cli"])
        .current_dir(root)
        .status()
        .map_err(|error| format!("cargo could not be started: {error}"))?;
    built.success().then_some(()).ok_or_else(|| "riprap-cli could not be built".to_owned())
}

/// Times the command itself: what it loses to everything outside the stages of a step.
fn commands(root: &Path) -> Result<String, String> {
    release(root)?;
    let mut table =
        "scene,case,threads,steps,loop_s,stages_s,outside_percent,process_s,state_hash\n"
            .to_owned();
    for (scene, steps) in RUNS {
        for (case, steps) in SIZES.into_iter().zip(steps) {
            table.push_str(&command(root, scene, case, steps)?);
        }
    }
    Ok(table)
}

/// The manifest of a run of the last phase of a scene with so many steps, and the time of the process, s.
fn manifest_of(
    root: &Path,
    scene: &Path,
    words: &[&str],
) -> Result<(serde_json::Value, f64), String> {
    let target = root.join("target");
    let folder = target.join("bench.run");
    let begun = Instant::now();
    let output = Command::new(target.join("release").join("riprap"))
        .arg("run")
        .arg(scene)
        .args(["-q", "--force"])
        .args(words)
        .arg("--out")
        .arg(&folder)
        .output()
        .map_err(|error| format!("riprap could not be started: {error}"))?;
    let process = begun.elapsed().as_secs_f64();
    // 1: a check of the whole motion, which is not run here, has failed.
    if !matches!(output.status.code(), Some(0 | 1)) {
        return Err(String::from_utf8_lossy(&output.stderr).into_owned());
    }
    let path = folder.join("manifest.json");
    let text = std::fs::read_to_string(&path)
        .map_err(|error| format!("{} could not be read: {error}", path.display()))?;
    let manifest = serde_json::from_str(&text)
        .map_err(|error| format!("{} is no manifest: {error}", path.display()))?;
    Ok((manifest, process))
}

/// One row: a run of a scene, from its manifest.
fn command(root: &Path, scene: &str, case: &str, steps: u64) -> Result<String, String> {
    let path = root.join("scenes").join("bench").join(format!("{scene}.toml"));
    let steps = format!("phases.timed.until.steps={steps}");
    let (manifest, process) = manifest_of(root, &path, &["--case", case, "--set", &steps])?;
    let number = |key: &str| manifest[key].as_f64().unwrap_or(f64::NAN);
    let stages: f64 = stages_of(&manifest).map(|stage| stage.wall).sum();
    let wall = number("wall_time");
    Ok(format!(
        "{scene},{case},{},{},{wall:.3},{stages:.3},{:.2},{process:.3},{}\n",
        number("threads"),
        number("steps"),
        100.0 * (1.0 - stages / wall),
        manifest["state_hash"].as_str().unwrap_or_default()
    ))
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
        let why = String::from_utf8_lossy(&output.stderr);
        return Err(format!("{name} {words:?}: {why}"));
    }
    Ok(String::from_utf8_lossy(&output.stdout).into_owned())
}
