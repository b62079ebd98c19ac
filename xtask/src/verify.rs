//! Scenes check themselves; these tasks only choose which ones to run.
//!
//! A scene is a `*.toml` under `scenes/` whose first key is `riprap = `. It is *long* when one of
//! its folders is called `long`, *fast* otherwise. Only scenes with `[[checks]]` are run.

use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode, Stdio};

use serde_json::Value;

use crate::shell::{self, cargo};
use crate::source_tree::{files, shown};
use crate::steps::Outcome;

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

fn binary(root: &Path, build: &mut Command, profile: &str) -> Result<PathBuf, String> {
    if !shell::run(root, build)?.success {
        return Err(format!("the build with profile {profile} failed"));
    }
    let target =
        std::env::var("CARGO_TARGET_DIR").map_or_else(|_| root.join("target"), PathBuf::from);
    Ok(root
        .join(target)
        .join(profile)
        .join(format!("riprap{}", std::env::consts::EXE_SUFFIX)))
}

/// Scenes with checks, relative to the root: the fast ones, then the long ones.
fn scenes(root: &Path) -> (Vec<String>, Vec<String>) {
    let all = files(&root.join("scenes"), &["toml"])
        .into_iter()
        .filter(|path| {
            let text = std::fs::read_to_string(path).unwrap_or_default();
            let mut keys = text
                .lines()
                .map(str::trim)
                .filter(|l| !l.is_empty() && !l.starts_with('#'));
            keys.next().is_some_and(|l| l.starts_with("riprap"))
                && text.lines().any(|l| l.trim() == "[[checks]]")
        });
    let is_long = |p: &PathBuf| p.iter().any(|part| part == "long");
    let (long, fast): (Vec<PathBuf>, Vec<PathBuf>) = all.partition(is_long);
    let names = |paths: Vec<PathBuf>| paths.iter().map(|p| shown(root, p)).collect();
    (names(fast), names(long))
}

/// The `scenes` step of `cargo xtask test`.
pub fn fast(root: &Path) -> Result<Outcome, String> {
    let (fast, long) = scenes(root);
    if fast.is_empty() {
        return Ok(Outcome::Skipped(
            "there are no scenes with checks yet".to_owned(),
        ));
    }
    println!(
        "{} fast scenes; {} long ones run under `cargo xtask verify-all`",
        fast.len(),
        long.len()
    );
    let mut command = Command::new(ci_binary(root)?);
    command.arg("verify").args(&fast);
    let done = shell::run(root, &mut command)?;
    let mut counts = done.counts;
    if !done.success && counts.failed == 0 {
        counts.failed = 1;
    }
    Ok(Outcome::Counted(counts))
}

/// `cargo xtask verify-all [SCENE]...`: runs every scene, or those named, and writes the table.
pub fn all(root: &Path, chosen: &[&str]) -> ExitCode {
    match run_all(root, chosen) {
        Ok(0) => ExitCode::SUCCESS,
        Ok(_) => ExitCode::FAILURE,
        Err(why) => {
            eprintln!("{why}");
            ExitCode::FAILURE
        }
    }
}

fn run_all(root: &Path, chosen: &[&str]) -> Result<u64, String> {
    let (fast, long) = scenes(root);
    let known: Vec<String> = fast.into_iter().chain(long).collect();
    if known.is_empty() {
        return Err("there are no scenes with checks under scenes/".to_owned());
    }
    if let Some(wrong) = chosen.iter().find(|c| known.iter().all(|k| k != *c)) {
        return Err(format!(
            "`{wrong}` is no scene with checks; name it as the table does, e.g. `{}`",
            known[0]
        ));
    }
    let run: Vec<&str> = if chosen.is_empty() {
        known.iter().map(String::as_str).collect()
    } else {
        chosen.to_vec()
    };
    let output = Command::new(release_binary(root)?)
        .args(["verify", "--json"])
        .args(&run)
        .current_dir(root)
        .stderr(Stdio::inherit())
        .output()
        .map_err(|e| format!("riprap verify: {e}"))?;
    let rows: Vec<Value> = String::from_utf8_lossy(&output.stdout)
        .lines()
        .filter_map(|line| serde_json::from_str(line).ok())
        .collect();
    if rows.is_empty() {
        return Err("riprap verify --json printed no checks".to_owned());
    }
    let page = root.join("docs/src/verification.md");
    // Rows of scenes that were not run now stay; those of scenes that are gone do not.
    let earlier = std::fs::read_to_string(&page).unwrap_or_default();
    let stays = |line: &&str| {
        let scene = scene_of(line);
        known.iter().any(|k| k == scene) && !run.contains(&scene)
    };
    let mut lines: Vec<String> = earlier.lines().filter(stays).map(str::to_owned).collect();
    lines.extend(rows.iter().map(line));
    // Stable: the checks of a scene stay in their order.
    let place = |l: &String| known.iter().position(|k| k == scene_of(l));
    lines.sort_by_key(place);
    if let Some(folder) = page.parent() {
        std::fs::create_dir_all(folder).map_err(|e| format!("{}: {e}", folder.display()))?;
    }
    std::fs::write(&page, table(&lines)).map_err(|e| format!("{}: {e}", page.display()))?;
    println!("wrote {}", shown(root, &page));
    let failed = rows.iter().filter(|r| r["status"] == "failed").count() as u64;
    println!("{}", totals(&lines));
    Ok(failed + u64::from(!output.status.success() && failed == 0))
}

/// First cell of a row.
fn scene_of(line: &str) -> &str {
    line.split('|').nth(1).map_or("", str::trim)
}

/// How many rows have which result.
fn totals(lines: &[String]) -> String {
    let count = |what: &str| {
        let result =
            |l: &&String| l.replace("\\|", "").split('|').nth(4).map(str::trim) == Some(what);
        lines.iter().filter(result).count()
    };
    format!(
        "{} passed, {} failed, {} skipped",
        count("passed"),
        count("failed"),
        count("skipped")
    )
}

/// The page: one row a check.
fn table(lines: &[String]) -> String {
    format!(
        "# Verification\n\nWritten by `cargo xtask verify-all`; every row is a check inside a scene and can be run again\n\
         with `riprap verify SCENE`, the row itself written anew with `cargo xtask verify-all SCENE`.\n\
         Skipped = known failures, run and shown with their reason.\n\n\
         {}\n\n\
         | scene | case | check | result | measured | expected | tolerance | note |\n\
         |---|---|---|---|---|---|---|---|\n\
         {}\n",
        totals(lines),
        lines.join("\n")
    )
}

/// A row of the table.
fn line(row: &Value) -> String {
    let cell = |key: &str| match &row[key] {
        Value::String(text) => text.replace('|', "\\|").replace('\n', " "),
        Value::Number(number) => {
            let unit = row["unit"]
                .as_str()
                .filter(|unit| *unit != "-")
                .unwrap_or("");
            let value = number.as_f64().unwrap_or(f64::NAN);
            format!("{value:.6e} {unit}").trim_end().to_owned()
        }
        Value::Null => String::new(),
        other => other.to_string(),
    };
    let cells: Vec<String> = [
        "scene",
        "case",
        "check",
        "status",
        "measured",
        "expected",
        "tolerance",
        "note",
    ]
    .iter()
    .map(|key| cell(key))
    .collect();
    format!("| {} |", cells.join(" | "))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_row_a_check_and_bars_are_escaped() {
        let row: Value = serde_json::from_str(
            r#"{"scene":"a.toml","case":"","check":"|v|","status":"passed","measured":1.5,"unit":"m"}"#,
        )
        .unwrap();
        let page = table(&[line(&row)]);
        assert!(
            page.contains("| a.toml |  | \\|v\\| | passed | 1.500000e0 m |  |  |  |"),
            "{page}"
        );
        assert!(page.contains("1 passed, 0 failed, 0 skipped"));
    }
}
