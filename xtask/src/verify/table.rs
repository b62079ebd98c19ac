//! The results of all checks, `docs/src/verification.csv`, which of them still count, and the page that sums them up scene by scene,
//! `docs/src/verification.md`.
//!
//! A row says when it was measured: date, commit, how many *Numerics* entries of `CHANGELOG.md` concerned its scene, and a digest of the scene
//! with the files that it reads. It is *stale* when the scene has changed since, and, for a long scene, when the changelog has got another
//! such entry: whatever changes results adds one. Rows of fast scenes are compared with what comes out in every run of the
//! tests, so they need no such sign. Nothing here asks git, but for the commit that goes into new rows.

use std::fmt::Write as _;
use std::path::Path;
use std::process::Command;

use serde_json::Value;

use super::basis::Now;
use super::probe::Probes;
use crate::source_tree::{files, shown};

/// The page.
pub const PAGE: &str = "docs/src/verification.md";
/// The first page, which says how many rows are fresh.
pub const INDEX: &str = "docs/src/index.md";
/// How its line of the table begins.
const LINE: &str = "| [Verification](verification.md) |";
/// The results.
pub const DATA: &str = "docs/src/verification.csv";

/// Columns that are read from a check.
const CELLS: [&str; 9] =
    ["scene", "case", "check", "status", "measured", "unit", "expected", "tolerance", "note"];
/// Columns that name a check.
const NAME: usize = 3;
/// The column of the result.
const STATUS: usize = 3;
/// Columns that say when a check was run and what its result rests on.
const RUN: [&str; 4] = ["date", "commit", "numerics", "digest"];

/// Whether one of its folders says that a scene takes long.
pub fn is_long(scene: &str) -> bool {
    scene.split('/').any(|part| part == "long")
}

/// Scenes with checks, relative to the root: the fast ones, then the long ones.
pub fn scenes(root: &Path) -> (Vec<String>, Vec<String>) {
    let all = files(&root.join("scenes"), &["toml"]).into_iter().filter(|path| {
        let text = std::fs::read_to_string(path).unwrap_or_default();
        let mut keys = text.lines().map(str::trim).filter(|l| !l.is_empty() && !l.starts_with('#'));
        keys.next().is_some_and(|l| l.starts_with("riprap"))
            && text.lines().any(|l| l.trim() == "[[checks]]")
    });
    let (long, fast) = all.map(|p| shown(root, &p)).partition(|name| is_long(name));
    (fast, long)
}

/// One row.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// [`CELLS`].
    cells: Vec<String>,
    /// [`RUN`]; empty where nobody wrote them down.
    run: [String; 4],
}

impl Row {
    /// Of a check that has just been run.
    fn new(check: &Value, run: [String; 4]) -> Self {
        Self { cells: CELLS.iter().map(|key| cell(check, key)).collect(), run }
    }

    /// Of a record of the file; `None` where it has other columns.
    fn read(record: &csv::StringRecord) -> Option<Self> {
        let cells: Vec<String> = record.iter().map(str::to_owned).collect();
        let (cells, run) = cells.split_at_checked(CELLS.len())?;
        Some(Self { cells: cells.to_vec(), run: run.to_vec().try_into().ok()? })
    }

    pub fn scene(&self) -> &str {
        &self.cells[0]
    }

    /// Its case; empty for the only one of a scene.
    pub fn case(&self) -> &str {
        &self.cells[1]
    }

    /// Scene, case and name of the check.
    fn name(&self) -> String {
        self.cells[..NAME].join(" | ")
    }

    /// Whether what was measured then is what would be measured now.
    pub fn fresh(&self, now: &Now) -> bool {
        let [_, _, numerics, digest] = &self.run;
        let same = now.digest(self.scene()) == digest;
        same && (!is_long(self.scene()) || numerics.parse() == Ok(now.numerics(self.scene())))
    }
}

/// What a check says under `key`.
fn cell(check: &Value, key: &str) -> String {
    match &check[key] {
        Value::String(text) if key == "unit" && text == "-" => String::new(),
        Value::String(text) => text.replace('\n', " "),
        Value::Number(number) => format!("{:.6e}", number.as_f64().unwrap_or(f64::NAN)),
        Value::Null => String::new(),
        other => other.to_string(),
    }
}

/// The rows of the file.
///
/// # Errors
/// It cannot be read, or has other columns.
pub fn read(root: &Path) -> Result<Vec<Row>, String> {
    let path = root.join(DATA);
    if !path.exists() {
        return Ok(Vec::new());
    }
    let mut file = csv::Reader::from_path(&path).map_err(|e| format!("{DATA}: {e}"))?;
    let record = |record: Result<csv::StringRecord, csv::Error>| {
        let record = record.map_err(|e| format!("{DATA}: {e}"))?;
        let line = record.position().map_or(0, csv::Position::line);
        Row::read(&record)
            .ok_or_else(|| format!("{DATA}, line {line}: other columns than the head says"))
    };
    file.records().map(record).collect()
}

/// The rows as text.
///
/// # Errors
/// None that a row can cause.
pub fn data(rows: &[Row]) -> Result<String, String> {
    let mut out = csv::Writer::from_writer(Vec::new());
    let head = CELLS.iter().chain(&RUN);
    out.write_record(head).map_err(|e| e.to_string())?;
    for row in rows {
        let record = row.cells.iter().chain(&row.run);
        out.write_record(record).map_err(|e| e.to_string())?;
    }
    let bytes = out.into_inner().map_err(|e| e.to_string())?;
    String::from_utf8(bytes).map_err(|e| e.to_string())
}

/// Puts the checks that were run in place of the rows of their scenes; a row that says the same of the same scene keeps its date.
/// Rows of scenes that are gone go.
pub fn merge(rows: &[Row], checks: &[Value], now: &Now, [date, commit]: [&str; 2]) -> Vec<Row> {
    let ran = |scene: &str| checks.iter().any(|c| c["scene"] == scene);
    let mut out: Vec<Row> = rows.to_vec();
    out.retain(|row| now.known(row.scene()) && !ran(row.scene()));
    for check in checks {
        let scene = check["scene"].as_str().unwrap_or("");
        let basis = [now.numerics(scene).to_string(), now.digest(scene).to_owned()];
        let [numerics, digest] = basis;
        let run = [date.to_owned(), commit.to_owned(), numerics, digest];
        let new = Row::new(check, run);
        let same = rows
            .iter()
            .find(|old| old.cells == new.cells && old.fresh(now) && !old.run[0].is_empty());
        out.push(same.cloned().unwrap_or(new));
    }
    // Stable: the checks of a scene stay in their order.
    out.sort_by_key(|row| now.place(row.scene()));
    out
}

/// What a run of checks has to say against the rows of the page that claim to be fresh, of scenes that have such rows: rows that are
/// missing or say something else, checks that are gone. Rows that are shown as stale claim nothing.
pub fn differences(rows: &[Row], checks: &[Value], now: &Now) -> Vec<String> {
    let mut out = Vec::new();
    let mut left: Vec<&Row> = rows.iter().filter(|row| row.fresh(now)).collect();
    let claimed: Vec<&str> = left.iter().map(|row| row.scene()).collect();
    let checks: Vec<&Value> = checks
        .iter()
        .filter(|c| c["scene"].as_str().is_some_and(|s| claimed.contains(&s)))
        .collect();
    for check in &checks {
        let new = Row::new(check, Default::default());
        let Some(at) = left.iter().position(|r| r.cells[..NAME] == new.cells[..NAME]) else {
            out.push(format!("no row: {}", new.name()));
            continue;
        };
        let old = left.remove(at);
        if old.cells != new.cells {
            let [was, is] = [&old.cells, &new.cells].map(|c| c[NAME..].join(", "));
            out.push(format!("{}: the row says {was}; it came out {is}", new.name()));
        }
    }
    let ran = |scene: &str| checks.iter().any(|c| c["scene"] == scene);
    let gone = left.into_iter().filter(|row| ran(row.scene()));
    out.extend(gone.map(|row| format!("no such check any more: {}", row.name())));
    out
}

/// How many rows have which result; stale ones count for none.
pub fn totals(rows: &[Row], now: &Now) -> String {
    let rows: Vec<&Row> = rows.iter().collect();
    let [passed, failed, skipped, stale] = counts(&rows, now);
    format!("{passed} passed, {failed} failed, {skipped} skipped; {stale} stale")
}

/// Passed, failed, skipped, stale.
fn counts(rows: &[&Row], now: &Now) -> [usize; 4] {
    let fresh = |row: &&&Row| row.fresh(now);
    let count = |what: &str| {
        let fresh = rows.iter().filter(fresh);
        fresh.filter(|row| row.cells[STATUS] == what).count()
    };
    let stale = rows.len() - rows.iter().filter(fresh).count();
    [count("passed"), count("failed"), count("skipped"), stale]
}

/// The page: one line a scene, then the checks that are known to fail.
pub fn page(rows: &[Row], now: &Now) -> String {
    let mut out = format!(
        "# Verification\n\nEvery scene with checks, one line each; written by `cargo xtask verify-all`. Every check with what was measured and expected, when, at which\n\
         commit and on what it rests is a row of [verification.csv](verification.csv). `riprap verify SCENE` runs a scene again, `cargo xtask verify-all SCENE` renews\n\
         its rows. Skipped = known failures, run and listed below with their reason. Stale = not run since the scene changed or, for scenes in a folder `long`, since\n\
         `CHANGELOG.md` got another *Numerics* entry that concerns them: such a row says what came out then and counts for nothing. What fast scenes give is held\n\
         against their rows in every test run; of long scenes the state after the first steps of each phase is, against [verification_probes.csv](verification_probes.csv),\n\
         so that no change of results goes without an entry.\n\n{}\n\n| scene | what it shows | passed | failed | skipped | stale | last run |\n|---|---|---|---|---|---|---|\n",
        totals(rows, now)
    );
    let escaped = |text: &str| text.replace('|', "\\|");
    for scene in &now.scenes {
        let of: Vec<&Row> = rows.iter().filter(|r| r.scene() == scene.name).collect();
        let numbers = counts(&of, now).map(|n| if n == 0 { String::new() } else { n.to_string() });
        let last = of.iter().map(|row| row.run[0].as_str()).max();
        let _ = writeln!(
            out,
            "| [{}](../../{}) | {} | {} | {} |",
            scene.name.trim_start_matches("scenes/").trim_end_matches(".toml"),
            scene.name,
            escaped(&scene.title),
            numbers.join(" | "),
            last.filter(|day| !day.is_empty()).unwrap_or("never")
        );
    }
    out.push_str("\n## Known failures\n\n| scene | case | check | measured | expected | why |\n|---|---|---|---|---|---|\n");
    for row in rows.iter().filter(|r| r.cells[STATUS] == "skipped") {
        let [_, case, check, _, measured, unit, expected, _, note] = &row.cells[..] else {
            continue;
        };
        let unit = if unit.is_empty() { String::new() } else { format!(" {unit}") };
        let cells = [row.scene(), case, check, &format!("{measured}{unit}"), expected, note];
        let _ = writeln!(out, "| {} |", cells.map(escaped).join(" | "));
    }
    out
}

/// The first page with the counts of fresh rows in its line of the table.
///
/// # Errors
/// A page without that line.
pub fn index(text: &str, rows: &[Row], now: &Now) -> Result<String, String> {
    let rows: Vec<&Row> = rows.iter().collect();
    let [passed, failed, skipped, stale] = counts(&rows, now);
    let due = format!(
        "{LINE} what every scene with checks gives: {passed} checks passed, {failed} failed, {skipped} known failures; {stale} not run since something that they \
         rest on changed. Each with its numbers is a row of a CSV file |"
    );
    let line = text.lines().find(|line| line.starts_with(LINE));
    let line = line.ok_or_else(|| format!("{INDEX} has no line that begins `{LINE}`"))?;
    Ok(text.replacen(line, &due, 1))
}

/// Whether the page says of every scene what the rows say: how many are fresh, how many stale; and the first page how many of all.
///
/// # Errors
/// What is wrong, and what to do.
pub fn judge(root: &Path) -> Result<String, String> {
    let now = Now::of(root);
    let rows = read(root)?;
    let text = std::fs::read_to_string(root.join(PAGE)).unwrap_or_default();
    if let Some(row) = rows.iter().find(|row| !now.known(row.scene())) {
        return Err(format!(
            "{DATA} has rows of {}, which is gone; `cargo xtask verify-all --table` takes them out",
            row.scene()
        ));
    }
    Probes::read(root)?.judge(&rows, &now)?;
    let due = page(&rows, &now);
    if due != text {
        let mut lines = due.lines().zip(text.lines());
        let wrong = lines.find(|(due, is)| due != is);
        let which = wrong.map_or("at its end", |(due, _)| due);
        return Err(format!(
            "{PAGE} does not show what is stale, first where it should say \"{which}\": run the scene again with `cargo xtask verify-all SCENE`, or show it as stale \
             with `cargo xtask verify-all --table`"
        ));
    }
    let text = std::fs::read_to_string(root.join(INDEX)).unwrap_or_default();
    if index(&text, &rows, &now)? != text {
        return Err(format!(
            "{INDEX} counts other rows than {DATA} has: `cargo xtask verify-all --table`"
        ));
    }
    Ok(totals(&rows, &now))
}

/// Date and commit for new rows; `+` where files differ from it.
pub fn this_run(root: &Path) -> [String; 2] {
    let said = |program: &str, words: &[&str]| {
        let output = Command::new(program).args(words).current_dir(root).output();
        output
            .ok()
            .filter(|o| o.status.success())
            .map(|o| String::from_utf8_lossy(&o.stdout).trim().to_owned())
    };
    let date = said("date", &["-u", "+%Y-%m-%d"]).unwrap_or_default();
    let commit = said("git", &["rev-parse", "--short=9", "HEAD"]);
    let changed = said("git", &["status", "--porcelain", "--untracked-files=no"]);
    let sign = if changed.is_some_and(|c| !c.is_empty()) { "+" } else { "" };
    let commit = commit.map_or("no commit".to_owned(), |c| format!("{c}{sign}"));
    [date, commit]
}

#[cfg(test)]
mod tests {
    use super::super::basis::Scene;
    use super::*;

    fn now(numerics: usize) -> Now {
        let scene = |name: &str| Scene {
            name: name.to_owned(),
            title: "a | b".to_owned(),
            digest: "d1".to_owned(),
            numerics,
        };
        Now { scenes: ["scenes/a.toml", "scenes/long/b.toml"].map(scene).to_vec() }
    }

    const DAY: [&str; 2] = ["2026-01-01", "abc"];
    const LATER: [&str; 2] = ["2026-01-02", "def"];

    fn check(scene: &str, measured: f64) -> Value {
        serde_json::json!({
            "scene": scene, "case": "", "check": "|v|", "status": "passed", "measured": measured, "unit": "m"
        })
    }

    #[test]
    fn a_row_a_check_and_a_line_a_scene() {
        let mut failing = check("scenes/a.toml", 2.5);
        (failing["status"], failing["note"]) = ("skipped".into(), "because, \"so\"".into());
        let rows = merge(&[], &[check("scenes/a.toml", 1.5), failing], &now(3), DAY);
        let text = data(&rows).unwrap();
        assert!(
            text.contains("\nscenes/a.toml,,|v|,passed,1.500000e0,m,,,,2026-01-01,abc,3,d1\n"),
            "{text}"
        );
        let mut file = csv::Reader::from_reader(text.as_bytes());
        let again: Vec<Row> = file.records().map(|r| Row::read(&r.unwrap()).unwrap()).collect();
        assert_eq!(again, rows);
        let page = page(&rows, &now(3));
        assert!(page.contains("1 passed, 0 failed, 1 skipped; 0 stale"));
        let line = "| [a](../../scenes/a.toml) | a \\| b | 1 |  | 1 |  | 2026-01-01 |";
        assert!(page.contains(line), "{page}");
        let known = "| scenes/a.toml |  | \\|v\\| | 2.500000e0 m |  | because, \"so\" |";
        assert!(page.contains(known), "{page}");
        assert!(
            page.contains("| [long/b](../../scenes/long/b.toml) | a \\| b |  |  |  |  | never |")
        );
    }

    #[test]
    fn long_rows_go_stale_with_the_numerics_and_all_with_their_scene() {
        let checks = [check("scenes/a.toml", 1.5), check("scenes/long/b.toml", 2.5)];
        let rows = merge(&[], &checks, &now(3), DAY);
        assert!(rows.iter().all(|r| r.fresh(&now(3))));
        let fresh: Vec<bool> = rows.iter().map(|r| r.fresh(&now(4))).collect();
        assert_eq!(fresh, [true, false]);
        assert!(page(&rows, &now(4)).contains("|  |  |  | 1 | 2026-01-01 |"));
        assert!(totals(&rows, &now(4)).contains("1 passed, 0 failed, 0 skipped; 1 stale"));
        let mut other = now(3);
        other.scenes[0].digest = "d2".to_owned();
        assert!(!rows[0].fresh(&other));
        // A row that says nothing of what it rests on is stale.
        let old = Row::new(&checks[0], Default::default());
        assert!(!old.fresh(&now(3)));
    }

    #[test]
    fn the_first_page_counts_fresh_rows() {
        let rows = merge(&[], &[check("scenes/long/b.toml", 1.0)], &now(3), ["", ""]);
        let text = format!("a\n{LINE} what it was |\nb\n");
        let fresh = index(&text, &rows, &now(3)).unwrap();
        assert!(fresh.starts_with("a\n") && fresh.ends_with(" |\nb\n"));
        assert!(fresh.contains("1 checks passed, 0 failed, 0 known failures; 0 not run"));
        let stale = index(&fresh, &rows, &now(4)).unwrap();
        assert!(stale.contains("0 checks passed, 0 failed, 0 known failures; 1 not run"));
        assert!(index("a\n", &rows, &now(3)).is_err());
    }

    #[test]
    fn a_run_that_says_something_else_is_told() {
        let rows = merge(&[], &[check("scenes/a.toml", 1.5)], &now(3), DAY);
        assert!(differences(&rows, &[check("scenes/a.toml", 1.5)], &now(3)).is_empty());
        let moved = differences(&rows, &[check("scenes/a.toml", 1.500_01)], &now(3));
        assert!(
            moved[0].contains("1.500000e0, m") && moved[0].contains("1.500010e0, m"),
            "{moved:?}"
        );
        let mut renamed = check("scenes/a.toml", 1.5);
        renamed["check"] = "w".into();
        assert_eq!(differences(&rows, &[renamed], &now(3)).len(), 2);
        // A row that is shown as stale claims nothing.
        let mut other = now(3);
        other.scenes[0].digest = "d2".to_owned();
        assert!(differences(&rows, &[check("scenes/a.toml", 9.0)], &other).is_empty());
        // What says the same keeps its date, what has moved gets a new one.
        let kept = merge(&rows, &[check("scenes/a.toml", 1.5)], &now(3), LATER);
        assert_eq!(kept[0].run[0], DAY[0]);
        let kept = merge(&rows, &[check("scenes/a.toml", 1.6)], &now(3), LATER);
        assert_eq!(kept[0].run[0], LATER[0]);
    }
}
