//! The table of all checks, `docs/src/verification.md`, and which of its rows still count.
//!
//! A row says when it was measured: date, commit, how many *Numerics* entries `CHANGELOG.md` had, and a digest of the scene with the
//! files that it reads. It is *stale* when the scene has changed since, and, for a long scene, when the changelog has got another
//! *Numerics* entry: whatever changes results adds one. Rows of fast scenes are compared with what comes out in every run of the
//! tests, so they need no such sign. Nothing here asks git, but for the commit that goes into new rows.

use std::fmt::Write as _;
use std::path::Path;
use std::process::Command;

use serde_json::Value;

use crate::source_tree::{files, shown};

/// The page.
pub const PAGE: &str = "docs/src/verification.md";

/// Cells of a row that are read from a check.
const CELLS: [&str; 8] = [
    "scene",
    "case",
    "check",
    "status",
    "measured",
    "expected",
    "tolerance",
    "note",
];
/// Before the result of a row that does not count.
const STALE: &str = "stale: ";

/// Whether one of its folders says that a scene takes long.
pub fn is_long(scene: &str) -> bool {
    scene.split('/').any(|part| part == "long")
}

/// Scenes with checks, relative to the root: the fast ones, then the long ones.
pub fn scenes(root: &Path) -> (Vec<String>, Vec<String>) {
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
    let (long, fast) = all.map(|p| shown(root, &p)).partition(|name| is_long(name));
    (fast, long)
}

/// One row.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// [`CELLS`], escaped, the result without [`STALE`].
    cells: Vec<String>,
    /// Date and commit; empty where nobody wrote them down.
    run: String,
    /// Number of *Numerics* entries, digest of the scene.
    basis: String,
}

impl Row {
    /// Of a check that has just been run.
    fn new(check: &Value, run: &str, basis: &str) -> Self {
        Self {
            cells: CELLS.iter().map(|key| cell(check, key)).collect(),
            run: run.to_owned(),
            basis: basis.to_owned(),
        }
    }

    /// Of a line of the page.
    fn read(line: &str) -> Option<Self> {
        let line = line.strip_prefix("| ")?.strip_suffix(" |")?;
        let mut cells: Vec<String> = Vec::new();
        let mut rest = line;
        while let Some((cell, after)) = rest.split_once(" | ") {
            cells.push(cell.trim().to_owned());
            rest = after;
        }
        cells.push(rest.trim().to_owned());
        if !cells.first()?.starts_with("scenes/") {
            return None;
        }
        cells.resize(CELLS.len() + 2, String::new());
        let basis = cells.pop()?;
        let run = cells.pop()?;
        if let Some(bare) = cells[3].strip_prefix(STALE) {
            cells[3] = bare.to_owned();
        }
        Some(Self { cells, run, basis })
    }

    pub fn scene(&self) -> &str {
        &self.cells[0]
    }

    /// Whether what was measured then is what would be measured now.
    fn fresh(&self, now: &Now) -> bool {
        let Some((numerics, digest)) = self.basis.split_once('/') else {
            return false;
        };
        let same = now.digest(self.scene()) == digest;
        same && (!is_long(self.scene()) || numerics.parse() == Ok(now.numerics))
    }

    fn line(&self, now: &Now) -> String {
        let mut out = String::from("|");
        for (k, cell) in self.cells.iter().enumerate() {
            let sign = if k == 3 && !self.fresh(now) {
                STALE
            } else {
                ""
            };
            let _ = write!(out, " {sign}{cell} |");
        }
        let _ = write!(out, " {} | {} |", self.run, self.basis);
        out
    }
}

/// A cell of the table: what a check says under `key`.
fn cell(check: &Value, key: &str) -> String {
    match &check[key] {
        Value::String(text) => text.replace('|', "\\|").replace('\n', " "),
        Value::Number(number) => {
            let unit = check["unit"].as_str().filter(|unit| *unit != "-");
            let value = number.as_f64().unwrap_or(f64::NAN);
            let unit = unit.unwrap_or("");
            format!("{value:.6e} {unit}").trim_end().to_owned()
        }
        Value::Null => String::new(),
        other => other.to_string(),
    }
}

/// What rows rest on today.
#[derive(Debug)]
pub struct Now {
    numerics: usize,
    digests: Vec<(String, String)>,
}

impl Now {
    /// Of the repository as it lies there.
    pub fn of(root: &Path) -> Self {
        let changes = std::fs::read_to_string(root.join("CHANGELOG.md")).unwrap_or_default();
        let (fast, long) = scenes(root);
        let digest = |name: String| {
            let digest = digest(root, &name);
            (name, digest)
        };
        Self {
            numerics: numerics(&changes),
            digests: fast.into_iter().chain(long).map(digest).collect(),
        }
    }

    fn digest(&self, scene: &str) -> &str {
        let found = self.digests.iter().find(|(name, _)| name == scene);
        found.map_or("", |(_, digest)| digest)
    }

    fn place(&self, scene: &str) -> Option<usize> {
        self.digests.iter().position(|(name, _)| name == scene)
    }

    pub fn known(&self, scene: &str) -> bool {
        self.place(scene).is_some()
    }
}

/// Number of entries under all headings *Numerics* of a changelog.
fn numerics(changes: &str) -> usize {
    let mut inside = false;
    let mut count = 0;
    for line in changes.lines() {
        if line.starts_with('#') {
            inside = line.trim_start_matches('#').trim() == "Numerics";
        } else if inside && line.starts_with("- ") {
            count += 1;
        }
    }
    count
}

/// Digest of a scene and of the files whose names stand in it between quotes (FNV-1a, 64 bits).
fn digest(root: &Path, scene: &str) -> String {
    let path = root.join(scene);
    let text = std::fs::read_to_string(&path).unwrap_or_default();
    let mut hash = 0xcbf2_9ce4_8422_2325_u64;
    let mut add = |bytes: &[u8]| {
        for byte in bytes {
            hash = (hash ^ u64::from(*byte)).wrapping_mul(0x100_0000_01b3);
        }
    };
    // Remarks and empty lines say nothing to the program.
    let said = text.lines().map(str::trim);
    for line in said.filter(|l| !l.is_empty() && !l.starts_with('#')) {
        add(line.as_bytes());
        add(b"\n");
    }
    let folder = path.parent().unwrap_or(root);
    for name in text.split('"').skip(1).step_by(2) {
        let file = folder.join(name);
        if name.contains('.') && file.is_file() {
            add(&std::fs::read(file).unwrap_or_default());
        }
    }
    format!("{hash:016x}")
}

/// The rows of the page.
pub fn read(root: &Path) -> Vec<Row> {
    let page = std::fs::read_to_string(root.join(PAGE)).unwrap_or_default();
    page.lines().filter_map(Row::read).collect()
}

/// Puts the checks that were run in place of the rows of their scenes; a row that says the same of the same scene keeps its date.
/// Rows of scenes that are gone go.
pub fn merge(rows: &[Row], checks: &[Value], now: &Now, run: &str) -> Vec<Row> {
    let ran = |scene: &str| checks.iter().any(|c| c["scene"] == scene);
    let mut out: Vec<Row> = rows.to_vec();
    out.retain(|row| now.known(row.scene()) && !ran(row.scene()));
    for check in checks {
        let scene = check["scene"].as_str().unwrap_or("");
        let basis = format!("{}/{}", now.numerics, now.digest(scene));
        let new = Row::new(check, run, &basis);
        let same = rows
            .iter()
            .find(|old| old.cells == new.cells && old.fresh(now) && !old.run.is_empty());
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
        let new = Row::new(check, "", "");
        let Some(at) = left.iter().position(|r| r.cells[..3] == new.cells[..3]) else {
            out.push(format!("no row: {}", new.cells[..3].join(" | ")));
            continue;
        };
        let old = left.remove(at);
        if old.cells != new.cells {
            let name = new.cells[..3].join(" | ");
            let [was, is] = [&old.cells, &new.cells].map(|c| c[3..].join(", "));
            out.push(format!("{name}: the row says {was}; it came out {is}"));
        }
    }
    let ran = |scene: &str| checks.iter().any(|c| c["scene"] == scene);
    let gone = left.into_iter().filter(|row| ran(row.scene()));
    out.extend(gone.map(|row| format!("no such check any more: {}", row.cells[..3].join(" | "))));
    out
}

/// How many rows have which result; stale ones count for none.
pub fn totals(rows: &[Row], now: &Now) -> String {
    let (fresh, stale): (Vec<&Row>, Vec<&Row>) = rows.iter().partition(|row| row.fresh(now));
    let count = |what: &str| fresh.iter().filter(|row| row.cells[3] == what).count();
    format!(
        "{} passed, {} failed, {} skipped; {} stale",
        count("passed"),
        count("failed"),
        count("skipped"),
        stale.len()
    )
}

/// The page: one row a check.
pub fn page(rows: &[Row], now: &Now) -> String {
    let lines: Vec<String> = rows.iter().map(|row| row.line(now)).collect();
    format!(
        "# Verification\n\nWritten by `cargo xtask verify-all`; every row is a check inside a scene and can be run again\n\
         with `riprap verify SCENE`, the row itself with `cargo xtask verify-all SCENE`.\n\
         Skipped = known failures, run and shown with their reason. Stale = not run since the scene changed or, for scenes in a folder `long`, since the\n\
         [changelog](../../CHANGELOG.md) got another *Numerics* entry: such a row says what came out then and counts for nothing. The last column is what the row\n\
         rests on: the number of those entries, and a digest of the scene with its files. What fast scenes give is held against their rows in every test run.\n\n\
         {}\n\n\
         | scene | case | check | result | measured | expected | tolerance | note | run | basis |\n\
         |---|---|---|---|---|---|---|---|---|---|\n\
         {}\n",
        totals(rows, now),
        lines.join("\n")
    )
}

/// Whether the page shows every row as it is: fresh or stale, and counted so.
///
/// # Errors
/// What is wrong, and what to do.
pub fn judge(root: &Path) -> Result<String, String> {
    let now = Now::of(root);
    let rows = read(root);
    let text = std::fs::read_to_string(root.join(PAGE)).unwrap_or_default();
    if let Some(row) = rows.iter().find(|row| !now.known(row.scene())) {
        return Err(format!(
            "{PAGE} has rows of {}, which is gone; `cargo xtask verify-all --table` takes them out",
            row.scene()
        ));
    }
    if page(&rows, &now) != text {
        let shown: Vec<&str> = text
            .lines()
            .filter(|l| l.starts_with("| scenes/"))
            .collect();
        let wrong = rows
            .iter()
            .zip(shown)
            .find(|(row, line)| row.line(&now) != *line);
        let which = wrong.map_or("its head".to_owned(), |(row, _)| {
            format!("the row of {}", row.scene())
        });
        return Err(format!(
            "{PAGE} does not show what is stale, first {which}: run the scene again with `cargo xtask verify-all SCENE`, or show it as stale with \
             `cargo xtask verify-all --table`"
        ));
    }
    Ok(totals(&rows, &now))
}

/// Date and commit for new rows; `+` where files differ from it.
pub fn this_run(root: &Path) -> String {
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
    let sign = if changed.is_some_and(|c| !c.is_empty()) {
        "+"
    } else {
        ""
    };
    let commit = commit.map_or("no commit".to_owned(), |c| format!("{c}{sign}"));
    format!("{date} {commit}")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn now(numerics: usize) -> Now {
        let known = ["scenes/a.toml", "scenes/long/b.toml"];
        Now {
            numerics,
            digests: known.map(|n| (n.to_owned(), "d1".to_owned())).to_vec(),
        }
    }

    fn check(scene: &str, measured: f64) -> Value {
        serde_json::json!({
            "scene": scene, "case": "", "check": "|v|", "status": "passed", "measured": measured, "unit": "m"
        })
    }

    #[test]
    fn a_row_a_check_and_bars_are_escaped() {
        let rows = merge(
            &[],
            &[check("scenes/a.toml", 1.5)],
            &now(3),
            "2026-01-01 abc",
        );
        let text = page(&rows, &now(3));
        let line = "| scenes/a.toml |  | \\|v\\| | passed | 1.500000e0 m |  |  |  | 2026-01-01 abc | 3/d1 |";
        assert!(text.contains(line), "{text}");
        assert!(text.contains("1 passed, 0 failed, 0 skipped; 0 stale"));
        let again: Vec<Row> = text.lines().filter_map(Row::read).collect();
        assert_eq!(again, rows);
    }

    #[test]
    fn long_rows_go_stale_with_the_numerics_and_all_with_their_scene() {
        let checks = [
            check("scenes/a.toml", 1.5),
            check("scenes/long/b.toml", 2.5),
        ];
        let rows = merge(&[], &checks, &now(3), "day");
        assert!(rows.iter().all(|r| r.fresh(&now(3))));
        let fresh: Vec<bool> = rows.iter().map(|r| r.fresh(&now(4))).collect();
        assert_eq!(fresh, [true, false]);
        assert!(page(&rows, &now(4)).contains("| stale: passed |"));
        assert!(totals(&rows, &now(4)).contains("1 passed, 0 failed, 0 skipped; 1 stale"));
        let mut other = now(3);
        other.digests[0].1 = "d2".to_owned();
        assert!(!rows[0].fresh(&other));
        // A row that says nothing of what it rests on is stale.
        let old = Row::read("| scenes/a.toml |  | x | passed | 1 m |  |  |  |").unwrap();
        assert!(!old.fresh(&now(3)));
    }

    #[test]
    fn a_run_that_says_something_else_is_told() {
        let rows = merge(&[], &[check("scenes/a.toml", 1.5)], &now(3), "day");
        assert!(differences(&rows, &[check("scenes/a.toml", 1.5)], &now(3)).is_empty());
        let moved = differences(&rows, &[check("scenes/a.toml", 1.500_01)], &now(3));
        assert!(
            moved[0].contains("1.500000e0 m") && moved[0].contains("1.500010e0 m"),
            "{moved:?}"
        );
        let mut renamed = check("scenes/a.toml", 1.5);
        renamed["check"] = "w".into();
        assert_eq!(differences(&rows, &[renamed], &now(3)).len(), 2);
        // A row that is shown as stale claims nothing.
        let mut other = now(3);
        other.digests[0].1 = "d2".to_owned();
        assert!(differences(&rows, &[check("scenes/a.toml", 9.0)], &other).is_empty());
        // What says the same keeps its date, what has moved gets a new one.
        let kept = merge(&rows, &[check("scenes/a.toml", 1.5)], &now(3), "later");
        assert_eq!(kept[0].run, "day");
        let kept = merge(&rows, &[check("scenes/a.toml", 1.6)], &now(3), "later");
        assert_eq!(kept[0].run, "later");
    }

    #[test]
    fn entries_of_all_releases_count() {
        let text = "## Unreleased\n### Fixed\n- a\n### Numerics\n- b\n  more\n- c\n## 0.1\n### Numerics\n- d\n### Added\n- e\n";
        assert_eq!(numerics(text), 3);
    }
}
