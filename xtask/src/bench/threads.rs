//! `cargo xtask bench threads`: how much of a run only one thread does, and what more threads can give at best.
//!
//! The program counts for each stage the wall time in which its threads had work. What is left of the stage is serial:
//! `s = serial / (serial + threads * pooled)` of its work, and `n` threads make it `1 / (s + (1 - s) / n)` times as fast at best (Amdahl 1967).
//! A busy machine stretches both parts alike, so that shares hold where seconds do not.

use std::fmt::Write;
use std::path::Path;

use serde_json::Value;

use super::{keep, manifest_of, release};

/// The end of the timed phase.
macro_rules! steps {
    ($count:literal) => {
        concat!("phases.timed.until.steps=", $count)
    };
}

/// Runs that are looked at: a name, the scene, and words for `riprap run`.
const RUNS: [(&str, &str, &[&str]); 6] = [
    ("wall of 100,000", "scenes/bench/wall.toml", &["--case", "large", "--set", steps!(400)]),
    (
        "lattice of 1,000,000",
        "scenes/bench/lattice.toml",
        &["--case", "large", "--set", steps!(60)],
    ),
    ("rubble of 2,000", "scenes/bench/rubble.toml", &["--case", "medium", "--set", steps!(300)]),
    ("masonry", "scenes/bench/masonry.toml", &["--case", "medium", "--set", steps!(300)]),
    ("blast", "scenes/bench/blast_throw.toml", &["--case", "medium", "--set", steps!(300)]),
    ("beam with bonds", "scenes/fracture/notched_beam_25kn.toml", &[]),
];

/// Numbers of threads for which the best gain is printed.
const THREADS: [f64; 2] = [16.0, 64.0];

/// A stage of the step.
pub(super) struct Stage<'a> {
    pub(super) name: &'a str,
    pub(super) wall: f64,
    pooled: f64,
}

/// The stages in a manifest.
pub(super) fn stages_of(manifest: &Value) -> impl Iterator<Item = Stage<'_>> {
    let stage = |stage: &'_ Value| -> Option<(f64, f64)> {
        Some((stage["seconds"].as_f64()?, stage["pooled"].as_f64()?))
    };
    manifest["profile"].as_array().into_iter().flatten().filter_map(move |of| {
        let (wall, pooled) = stage(of)?;
        Some(Stage { name: of["name"].as_str()?, wall, pooled })
    })
}

/// Runs what is in [`RUNS`] on all threads and prints the table.
pub fn threads(root: &Path) -> Result<bool, String> {
    release(root)?;
    let mut table =
        "run,stage,threads,wall_s,pooled_s,serial_percent_of_work,gain_of_16,gain_of_64\n"
            .to_owned();
    for (name, scene, words) in RUNS {
        let (manifest, _) = manifest_of(root, &root.join(scene), words)?;
        let threads = manifest["threads"].as_f64().unwrap_or(1.0);
        let number = |key: &str| manifest[key].as_f64().unwrap_or(f64::NAN);
        let mut outside = [number("wall_time"), number("pooled_time")];
        // Of all work, on one thread.
        let work = outside[0] + (threads - 1.0) * outside[1];
        for Stage { name: stage, wall, pooled } in stages_of(&manifest) {
            outside = [outside[0] - wall, outside[1] - pooled];
            row(&mut table, [name, stage], threads, [wall, pooled], work);
        }
        row(&mut table, [name, "outside"], threads, outside, work);
        let whole = [number("wall_time"), number("pooled_time")];
        row(&mut table, [name, "all"], threads, whole, work);
    }
    print!("{table}");
    keep(root, "bench-threads.csv", &table)?;
    Ok(true)
}

/// A stage: its serial part in percent of `work`, the CPU time of the run on one thread; what more threads make of the whole run if
/// nothing else were serial.
fn row(
    table: &mut String,
    [run, stage]: [&str; 2],
    threads: f64,
    [wall, pooled]: [f64; 2],
    work: f64,
) {
    let serial = (wall - pooled) / work;
    let [some, many] = THREADS.map(|n| 1.0 / (serial + (1.0 - serial) / n));
    let _ = writeln!(
        table,
        "{run},{stage},{threads},{wall:.3},{pooled:.3},{:.2},{some:.1},{many:.1}",
        100.0 * serial
    );
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_threads_do_not_share_bounds_what_more_of_them_give() {
        let mut table = String::new();
        // 1 s alone and 4 s on two threads: 9 s of work, a ninth serial.
        row(&mut table, ["a", "all"], 2.0, [5.0, 4.0], 9.0);
        assert_eq!(table, "a,all,2,5.000,4.000,11.11,6.0,8.0\n");
        let manifest = serde_json::json!({"profile": [
            {"name": "x", "seconds": 5.0, "pooled": 4.0, "calls": 1},
            {"name": "written by an old program", "seconds": 5.0},
        ]});
        let names: Vec<&str> = stages_of(&manifest).map(|stage| stage.name).collect();
        assert_eq!(names, ["x"]);
    }
}
