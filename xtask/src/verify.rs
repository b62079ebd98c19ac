//! Scenes check themselves; these tasks only choose which ones to run.
//!
//! A scene is a `*.toml` under `scenes/` whose first key is `riprap = `. It is *long* when one of
//! its folders is called `long`, *fast* otherwise. Only scenes with `[[checks]]` are run.

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::Instant;

use serde_json::Value;

mod basis;
mod probe;
mod table;

use crate::shell::{self, Counts, cargo};
use crate::steps::Outcome;
use basis::Now;
use probe::Probes;
use table::Row;
pub use table::this_run;

/// Builds the release binary; `Err` when it does not build.
fn release_binary(root: &Path) -> Result<PathBuf, String> {
    let mut command = Command::new(cargo());
    command.args(["build", "--release", "--locked", "--package", "riprap-cli"]);
    binary(root, &mut command, "release")
}

/// The binary of the tests, built if the step `build` has not: with debug assertions, engines as fast as in a release.
pub fn ci_binary(root: &Path) -> Result<PathBuf, String> {
    let mut command = Command::new(cargo());
    command.args(["test", "--workspace", "--locked", "--profile", "ci"]);
    command.args(["--no-run", "--quiet"]);
    binary(root, &mut command, "ci")
}

/// The binary that `--binary FILE` names among `words`, or that of the tests.
pub fn chosen_binary(root: &Path, words: &mut Vec<&str>) -> Result<PathBuf, String> {
    let given = shell::option(words, "--binary")?;
    given.map_or_else(|| ci_binary(root), |file| Ok(root.join(file)))
}

fn binary(root: &Path, build: &mut Command, profile: &str) -> Result<PathBuf, String> {
    if !shell::run(root, build)?.success {
        return Err(format!("the build with profile {profile} failed"));
    }
    let target =
        std::env::var("CARGO_TARGET_DIR").map_or_else(|_| root.join("target"), PathBuf::from);
    Ok(root.join(target).join(profile).join(format!("riprap{}", std::env::consts::EXE_SUFFIX)))
}

/// Scenes that CI runs, as the table names them.
pub fn fast_scenes(root: &Path) -> Vec<String> {
    table::scenes(root).0
}

/// The `scenes` step of `cargo xtask test`.
pub fn fast(root: &Path) -> Result<Outcome, String> {
    let (fast, long) = table::scenes(root);
    if fast.is_empty() {
        return Ok(Outcome::Skipped("there are no scenes with checks yet".to_owned()));
    }
    println!(
        "{} fast scenes; {} long ones run under `cargo xtask verify-all`",
        fast.len(),
        long.len()
    );
    let fast: Vec<&str> = fast.iter().map(String::as_str).collect();
    let binary = ci_binary(root)?;
    let (checks, success) = run(root, &binary, &fast)?;
    write(&root.join(LAST), &lines(&checks))?;
    let count = |what: &str| checks.iter().filter(|c| c["status"] == what).count() as u64;
    let mut counts =
        Counts { passed: count("passed"), failed: count("failed"), skipped: count("skipped") };
    if !success && counts.failed == 0 {
        counts.failed = 1;
    }
    let rows = table::read(root)?;
    let now = Now::of(root);
    for difference in table::differences(&rows, &checks, &now) {
        println!("{}: {difference}", table::DATA);
        counts.failed += 1;
    }
    if counts.failed > count("failed") {
        println!(
            "{} is older than the program. Where the change is meant: an entry under *Numerics* in CHANGELOG.md if results moved, and \
             `cargo xtask verify-all --from {LAST}`",
            table::DATA
        );
    }
    counts.add(probed(root, &binary, &rows, &now)?);
    println!(
        "{}: {}; stale rows of fast scenes are made fresh by `cargo xtask verify-all --from {LAST}`",
        table::PAGE,
        table::totals(&rows, &now)
    );
    Ok(Outcome::Counted(counts))
}

/// Begins long scenes and holds their states against those of the program that made their rows.
fn probed(root: &Path, binary: &Path, rows: &[Row], now: &Now) -> Result<Counts, String> {
    let begun = Instant::now();
    let (different, run) = Probes::read(root)?.differences((root, binary), rows, now)?;
    for difference in &different {
        println!("{}: {difference}", probe::DATA);
    }
    let seconds = begun.elapsed().as_secs_f64();
    println!(
        "the first steps of {run} cases of long scenes: {} differ ({seconds:.0} s)",
        different.len()
    );
    Ok(Counts {
        passed: (run - different.len()) as u64,
        failed: different.len() as u64,
        skipped: 0,
    })
}

/// What the step `scenes` found last, one check a line, as `riprap verify --json` prints it.
const LAST: &str = "target/scenes.jsonl";

/// Runs scenes; prints what did not pass, a line a scene, and returns all checks, and whether the command thinks that all is well.
fn run(root: &Path, binary: &Path, scenes: &[&str]) -> Result<(Vec<Value>, bool), String> {
    let output = Command::new(binary)
        .args(["verify", "--json"])
        .args(scenes)
        .current_dir(root)
        .stdin(Stdio::null())
        .stderr(Stdio::inherit())
        .output()
        .map_err(|e| format!("riprap verify: {e}"))?;
    let checks = parse(&String::from_utf8_lossy(&output.stdout))?;
    if checks.is_empty() {
        return Err("riprap verify --json printed no checks".to_owned());
    }
    for check in checks.iter().filter(|c| c["status"] == "failed") {
        println!("FAILED  {check}");
    }
    Ok((checks, output.status.success()))
}

fn parse(text: &str) -> Result<Vec<Value>, String> {
    let checks = text.lines().filter(|l| !l.trim().is_empty());
    checks.map(|line| serde_json::from_str(line).map_err(|e| format!("{line}: {e}"))).collect()
}

fn lines(checks: &[Value]) -> String {
    checks.iter().map(|c| format!("{c}\n")).collect()
}

fn write(path: &Path, text: &str) -> Result<(), String> {
    if let Some(folder) = path.parent() {
        std::fs::create_dir_all(folder).map_err(|e| format!("{}: {e}", folder.display()))?;
    }
    std::fs::write(path, text).map_err(|e| format!("{}: {e}", path.display()))
}

/// The step `table`: the page shows which of its rows are stale.
pub fn table_step(root: &Path) -> Result<Outcome, String> {
    println!("{}", table::judge(root)?);
    Ok(Outcome::Counted(Counts { passed: 1, ..Counts::default() }))
}

/// `cargo xtask verify-all [SCENE]...`: runs every scene, or those named, and writes the table; `--from FILE`: takes what has been
/// run already; `--table`: runs nothing, and shows what is stale; `--probes`: makes the probes that are missing.
pub fn all(root: &Path, words: &[&str]) -> Result<bool, String> {
    match words {
        ["--table"] => rewrite(root, &[], None).map(|()| true),
        ["--probes"] => rewrite(root, &[], Some(&ci_binary(root)?)).map(|()| true),
        ["--from", file] => taken(root, file),
        chosen => run_all(root, chosen),
    }
}

/// Whether no check failed.
fn none_failed(checks: &[Value]) -> bool {
    checks.iter().all(|c| c["status"] != "failed")
}

/// A check that stands in the list twice, as where two files were joined: it would be counted twice.
fn twice(checks: &[Value]) -> Option<&Value> {
    let mut seen = std::collections::BTreeSet::new();
    let key = |c: &Value| ["scene", "case", "check"].map(|k| c[k].to_string());
    checks.iter().find(|c| !seen.insert(key(c)))
}

/// Writes the page with the checks that were run in place of the rows of their scenes. With the `binary` that ran them come probes of these
/// scenes, without checks those that are missing.
fn rewrite(root: &Path, checks: &[Value], binary: Option<&Path>) -> Result<(), String> {
    if let Some(check) = twice(checks) {
        return Err(format!("it stands there twice: {check}"));
    }
    let now = Now::of(root);
    let stranger =
        checks.iter().filter_map(|c| c["scene"].as_str()).find(|scene| !now.known(scene));
    if let Some(scene) = stranger {
        return Err(format!("`{scene}` is no scene with checks of this repository"));
    }
    let [date, commit] = table::this_run(root);
    let rows = table::merge(&table::read(root)?, checks, &now, [&date, &commit]);
    write(&root.join(table::DATA), &table::data(&rows)?)?;
    write(&root.join(table::PAGE), &table::page(&rows, &now))?;
    let index = root.join(table::INDEX);
    let text = std::fs::read_to_string(&index).map_err(|e| format!("{}: {e}", table::INDEX))?;
    write(&index, &table::index(&text, &rows, &now)?)?;
    // Last: rows may be the work of hours.
    let mut probes = Probes::read(root)?;
    probes.keep(&rows);
    if let Some(binary) = binary {
        let ran = |scene: &str| checks.iter().any(|c| c["scene"] == scene);
        let chosen: Option<&dyn Fn(&str) -> bool> = (!checks.is_empty()).then_some(&ran);
        probes.make((root, binary), &rows, chosen)?;
    }
    write(&root.join(probe::DATA), &probes.text()?)?;
    println!("wrote {}, {}, {} and {}", table::DATA, probe::DATA, table::PAGE, table::INDEX);
    println!("{}", table::totals(&rows, &now));
    Ok(())
}

fn taken(root: &Path, file: &str) -> Result<bool, String> {
    let text = std::fs::read_to_string(root.join(file)).map_err(|e| format!("{file}: {e}"))?;
    let checks = parse(&text)?;
    let long = checks.iter().any(|check| check["scene"].as_str().is_some_and(table::is_long));
    let binary = if long { Some(ci_binary(root)?) } else { None };
    rewrite(root, &checks, binary.as_deref())?;
    Ok(none_failed(&checks))
}

fn run_all(root: &Path, chosen: &[&str]) -> Result<bool, String> {
    let (fast, long) = table::scenes(root);
    let known: Vec<&str> = fast.iter().chain(&long).map(String::as_str).collect();
    let first = known.first().ok_or("there are no scenes with checks under scenes/")?;
    if let Some(wrong) = chosen.iter().find(|c| !known.contains(c)) {
        return Err(format!(
            "`{wrong}` is no scene with checks; name it as the table does, e.g. `{first}`"
        ));
    }
    let binary = release_binary(root)?;
    let (checks, success) = run(root, &binary, if chosen.is_empty() { &known } else { chosen })?;
    rewrite(root, &checks, Some(&binary))?;
    Ok(success && none_failed(&checks))
}
