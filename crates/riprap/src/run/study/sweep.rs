//! All cases of a scene side by side, each in its own sub-folder, with one table.

use std::path::{Path, PathBuf};

use super::Executor;
use super::verify::Tally;
use crate::plan::Check;
use crate::record::field::with_unit;
use crate::record::folder::Existing;
use crate::record::manifest::{Ended, Manifest};
use crate::record::table::Table;
use crate::record::{OutputError, read_plain_text, write_whole};
use crate::run::checks::{CheckResult, Status};
use crate::run::drive::{Ending, Look};
use crate::run::job::{self, JobError, Outcome};
use crate::run::scene::Scene;
use crate::scenario::{Case, Diagnostics, varied_and_set};

/// The table, in the folder of the sweep.
pub const TABLE: &str = "sweep.csv";

/// A share of the cases: those of one job of an array.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Part {
    /// Which one, from 1.
    pub number: usize,
    /// How many there are.
    pub of: usize,
}

impl Part {
    /// Reads `3/20`.
    ///
    /// # Errors
    /// A text for the user.
    ///
    /// # Examples
    ///
    /// ```
    /// use riprap::run::study::sweep::Part;
    ///
    /// assert_eq!(Part::read("3/20"), Ok(Part { number: 3, of: 20 }));
    /// assert!(Part::read("21/20").is_err() && Part::read("0/20").is_err());
    /// ```
    pub fn read(text: &str) -> Result<Self, String> {
        let numbers = text
            .split_once('/')
            .and_then(|(number, of)| Some((number.trim().parse().ok()?, of.trim().parse().ok()?)));
        match numbers {
            Some((number, of)) if (1..=of).contains(&number) => Ok(Self { number, of }),
            _ => Err(format!(
                "{text:?} is not a part; write for example 3/20: the third of 20 parts"
            )),
        }
    }

    /// Its cases: every `of`-th, so that parts of a sweep from small to large models take about the same time.
    #[must_use]
    pub fn of(self, cases: &[Case]) -> Vec<Case> {
        cases.iter().skip(self.number - 1).step_by(self.of).cloned().collect()
    }
}

/// One row of the table.
#[derive(Clone, Debug, Default)]
pub struct Row {
    /// Name of the case and of its folder.
    pub case: String,
    /// Variant of the scene.
    pub variant: String,
    /// Changed keys and their values, as written.
    pub changes: Vec<(String, String)>,
    /// How it ended, in words.
    pub ended: String,
    /// Whether it reached its end.
    pub finished: bool,
    /// What its run warned of.
    pub warnings: Vec<String>,
    /// Whether it was run before, by this program and with the same input, and is kept as it is.
    pub kept: bool,
    /// Whether results could not be written.
    pub unwritten: bool,
    /// Steps done.
    pub steps: u64,
    /// Last values of the histories: column head and value.
    pub last: Vec<(String, f64)>,
    /// Checks.
    pub checks: Vec<CheckResult>,
}

/// Models of all cases are built before the first one runs, so that mistakes show at once.
///
/// # Errors
/// A swept key that the user's changes fix; what is wrong with the first case that cannot be built.
pub fn check_all(scene: &Scene) -> Result<(), Diagnostics> {
    let swept: Vec<&str> = scene.parsed.scenario.sweep.names().collect();
    varied_and_set(&scene.parsed.source, ("sweep", &swept), &scene.changes)?;
    for case in &scene.cases {
        scene.prepare(case)?;
    }
    Ok(())
}

/// Runs all cases into sub-folders of `folder`, each on one thread, and hands each row to `report` in
/// the order of the cases. Unless what is there is to be replaced, a case that has finished there before, with the same input and
/// by the same program, is kept and not run again; one that was cut short goes on from its last checkpoint.
///
/// # Examples
///
/// ```
/// use std::path::Path;
///
/// use riprap::record::folder::Existing;
/// use riprap::run::scene::Scene;
/// use riprap::run::study::Executor;
/// use riprap::run::study::sweep::{sweep, tally};
///
/// let path = Path::new("scenes/verify/planar/a5_stop.toml");
/// # let path = &Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(path);
/// # let results = tempfile::tempdir()?;
/// # let results = results.path();
/// let scene = Scene::load(path, &[])?;
/// let mut rows = Vec::new();
/// sweep(&scene, results, Existing::Refuse, &Executor::ALONE.on(2), |row| rows.push(row));
/// assert_eq!(rows.len(), scene.cases.len());
/// assert_eq!(tally(&rows, None).failed, 0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn sweep(
    scene: &Scene,
    folder: &Path,
    existing: Existing,
    executor: &Executor<'_>,
    report: impl FnMut(Row),
) {
    executor.each(&scene.cases, |case| one(scene, case, folder, existing, executor), report);
}

fn one(
    scene: &Scene,
    case: &Case,
    folder: &Path,
    existing: Existing,
    executor: &Executor<'_>,
) -> Row {
    let mut row = Row::of(scene, case, "stopped by the user before it began");
    if (executor.stop)() {
        return row;
    }
    let folder = folder.join(&case.name);
    let prepared = match scene.prepare(case) {
        Ok(prepared) => prepared,
        Err(wrong) => return Row { ended: wrong.render(), ..row },
    };
    let before = before(&folder, &prepared.manifest);
    let known = prepared.manifest.clone();
    let mut look = |_: &mut Look<'_>| executor.control();
    let outcome = match (existing, before) {
        (Existing::Refuse, Before::Finished { steps, checks }) => {
            return row.finished(&folder, steps, checks, &prepared.manifest);
        }
        (Existing::Refuse, Before::CutShort) => match job::resume(&folder, 1, &mut look) {
            // Nothing to go on from: it begins again.
            Err(JobError::Checkpoint(_) | JobError::Ended { .. }) => {
                job::run(prepared.job(), &folder, Existing::ReplaceRun, 1, &mut look)
            }
            gone_on => gone_on,
        },
        (existing, _) => job::run(prepared.job(), &folder, existing, 1, &mut look),
    };
    match outcome {
        Err(why) => (row.ended, row.unwritten) = (why.to_string(), why.is_output()),
        Ok(Outcome { ending, manifest, checks, .. }) => {
            row.finished = ending == Ending::Finished;
            row.ended = match ending {
                Ending::Finished => "finished".to_owned(),
                Ending::Stopped => "stopped by the user".to_owned(),
                Ending::Unstable(why) => why.to_string(),
            };
            (row.steps, row.checks, row.last) = (manifest.steps, checks, last_values(&folder));
            if row.finished {
                row.warns(&manifest, &known);
            }
        }
    }
    row
}

impl Row {
    fn of(scene: &Scene, case: &Case, ended: &str) -> Self {
        Row {
            case: case.name.clone(),
            variant: case.variant.clone(),
            changes: as_run(&case.changes, &scene.changes),
            ended: ended.to_owned(),
            ..Row::default()
        }
    }

    /// The row of a case that has finished before.
    fn finished(
        self,
        folder: &Path,
        steps: u64,
        checks: Vec<CheckResult>,
        known: &Manifest,
    ) -> Self {
        let (ended, last) = ("finished".to_owned(), last_values(folder));
        let mut row = Row { ended, finished: true, kept: true, steps, last, checks, ..self };
        if let Ok(there) = Manifest::read(folder) {
            row.warns(&there, known);
        }
        row
    }

    /// Keeps what the run warned of besides its input.
    fn warns(&mut self, there: &Manifest, known: &Manifest) {
        let own = there.warnings.iter().filter(|warning| !known.warnings.contains(warning));
        self.warnings = own.cloned().collect();
        match self.warnings.len() {
            0 => {}
            1 => self.ended.push_str(" with a warning"),
            n => self.ended.push_str(&format!(" with {n} warnings")),
        }
    }
}

/// The rows of the cases that parts of the sweep have run into `folder`; nothing is run.
///
/// # Errors
/// A case that is no sound model.
pub fn merged(scene: &Scene, folder: &Path) -> Result<Vec<Row>, Diagnostics> {
    let row = |case: &Case| {
        let (row, folder) = (Row::of(scene, case, ""), folder.join(&case.name));
        let wanted = scene.prepare(case)?.manifest;
        let ended = match before(&folder, &wanted) {
            Before::Finished { steps, checks } => {
                return Ok(row.finished(&folder, steps, checks, &wanted));
            }
            Before::CutShort => "not finished",
            Before::Nothing => "not run",
            Before::Other => "a run of another input or program",
        };
        Ok(Row { ended: ended.to_owned(), ..row })
    };
    scene.cases.iter().map(row).collect()
}

/// What an earlier sweep has left of a case.
enum Before {
    Nothing,
    /// A run with the same input and by the same program, whose results can be read.
    Finished {
        steps: u64,
        checks: Vec<CheckResult>,
    },
    /// A run with the same input and by the same program that has not come to its end.
    CutShort,
    /// A run with another input or by another program.
    Other,
}

fn before(folder: &Path, wanted: &Manifest) -> Before {
    let Ok(there) = Manifest::read(folder) else {
        return Before::Nothing;
    };
    let same = there.input_hash == wanted.input_hash
        && there.riprap == wanted.riprap
        && there.variant == wanted.variant
        && there.preview == wanted.preview;
    if !same {
        return Before::Other;
    }
    let text = match read_plain_text(&folder.join("checks.jsonl")) {
        Err(error) if error.kind() == std::io::ErrorKind::NotFound => Ok(String::new()),
        read => read,
    };
    let checks = text.ok().and_then(|text| {
        let checks = text.lines().map(serde_json::from_str);
        checks.collect::<Result<Vec<_>, _>>().ok()
    });
    match checks {
        Some(checks) if there.ended == Ended::Finished => {
            Before::Finished { steps: there.steps, checks }
        }
        _ => Before::CutShort,
    }
}

/// A case for which `folder` holds a run with another input or by another program, which a sweep would not replace.
///
/// # Errors
/// A case that is no sound model.
pub fn other_run(scene: &Scene, folder: &Path) -> Result<Option<PathBuf>, Diagnostics> {
    for case in &scene.cases {
        let folder = folder.join(&case.name);
        if matches!(before(&folder, &scene.prepare(case)?.manifest), Before::Other) {
            return Ok(Some(folder));
        }
    }
    Ok(None)
}

/// The changes of a case with the values that ran: the user's changes win over those of a variant.
fn as_run(of_case: &[(String, String)], set: &[(String, String)]) -> Vec<(String, String)> {
    let ran = |(key, value): &(String, String)| {
        // The last change of a key is the one that holds.
        let won = set.iter().rev().find(|(set, _)| set == key);
        (key.clone(), won.map_or(value, |(_, won)| won).clone())
    };
    of_case.iter().map(ran).collect()
}

/// Last written value of every history of a run.
fn last_values(folder: &Path) -> Vec<(String, f64)> {
    let Ok(table) = Table::read(&folder.join("histories.csv")) else {
        return Vec::new();
    };
    let columns = table.columns.iter().filter(|c| c.name != "step" && c.name != "time");
    columns
        .filter_map(|c| {
            // Histories with other rhythms leave cells of a row empty.
            let last = c.values.iter().rev().find(|v| !v.is_nan())?;
            Some((with_unit(&c.name, &c.unit), *last))
        })
        .collect()
}

/// The table of an earlier sweep into the folder, of which what has finished is kept.
#[must_use]
pub fn earlier(folder: &Path, existing: Existing) -> Option<String> {
    let path = folder.join(TABLE);
    (existing == Existing::Refuse).then(|| read_plain_text(&path).ok()).flatten()
}

/// The checks of all rows, counted, without those that the study itself asks (`asks`).
#[must_use]
pub fn tally(rows: &[Row], asks: Option<&Check>) -> Tally {
    let mut tally = Tally::default();
    let checks = rows.iter().flat_map(|row| &row.checks);
    let own = checks.filter(|check| asks.is_none_or(|asks| asks.name != check.check));
    own.for_each(|check| tally.add(check));
    tally
}

/// The table as CSV: case, variant, every changed key, how it ended, last values, checks.
///
/// # Errors
/// Never in practice: it is written to memory.
pub fn table(rows: &[Row]) -> Result<Vec<u8>, csv::Error> {
    table_with(rows, None)
}

/// As [`table`], with the rows of an earlier table of the same folder whose cases are not among `rows`: a sweep over other values
/// leaves them where they are.
///
/// # Errors
/// As [`table`]; an earlier table that is none is left out.
pub fn table_with(rows: &[Row], earlier: Option<&str>) -> Result<Vec<u8>, csv::Error> {
    let mut lines: Vec<Line> = rows.iter().map(line_of).collect();
    let before = earlier.map(lines_of).unwrap_or_default();
    let is_again =
        |line: &Line| line.first().is_some_and(|of| rows.iter().any(|r| r.case == of.text));
    lines.extend(before.into_iter().filter(|line| !is_again(line)));
    let fixed = [(Section::Case, CASE), (Section::Outcome, OUTCOME)];
    let mut heads: Vec<(Section, &str)> =
        fixed.into_iter().flat_map(|(part, heads)| heads.map(|head| (part, head))).collect();
    for cell in lines.iter().flatten() {
        if !heads.contains(&(cell.part, &cell.head)) {
            heads.push((cell.part, &cell.head));
        }
    }
    // Within its part each column is where it came first.
    heads.sort_by_key(|(part, _)| *part);
    let mut out = csv::Writer::from_writer(Vec::new());
    out.write_record(heads.iter().map(|(_, head)| head))?;
    for line in &lines {
        let text = |(part, head): &(Section, &str)| {
            let found = line.iter().find(|cell| cell.part == *part && cell.head == *head);
            found.map_or("", |cell| cell.text.as_str())
        };
        out.write_record(heads.iter().map(text))?;
    }
    out.into_inner().map_err(|error| error.into_error().into())
}

/// Parts of the table, from left to right.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Section {
    Case,
    Keys,
    Outcome,
    Last,
    Checks,
}

/// Heads of the parts that every table has.
const CASE: [&str; 2] = ["case", "variant"];
const OUTCOME: [&str; 2] = ["ended", "steps"];

/// Head of the column of a check, before its name.
const CHECK: &str = "check: ";

/// A cell of the table with the head of its column.
struct Cell {
    part: Section,
    head: String,
    text: String,
}

/// The cells of a case, its name first.
type Line = Vec<Cell>;

fn line_of(row: &Row) -> Line {
    let cell = |part: Section, head: &str, text: &str| Cell {
        part,
        head: head.to_owned(),
        text: text.to_owned(),
    };
    let mut line = vec![
        cell(Section::Case, CASE[0], &row.case),
        cell(Section::Case, CASE[1], &row.variant),
        cell(Section::Outcome, OUTCOME[0], &row.ended),
        cell(Section::Outcome, OUTCOME[1], &row.steps.to_string()),
    ];
    line.extend(row.changes.iter().map(|(key, v)| cell(Section::Keys, key, v.trim_matches('"'))));
    line.extend(row.last.iter().map(|(head, value)| cell(Section::Last, head, &value.to_string())));
    line.extend(row.checks.iter().map(|check| {
        let status = match check.status {
            Status::Passed => "passed",
            Status::Failed => "failed",
            Status::Skipped => "skipped",
        };
        cell(Section::Checks, &format!("{CHECK}{}", check.check), status)
    }));
    line
}

/// The lines of a table; none of a text that is no such table.
fn lines_of(text: &str) -> Vec<Line> {
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    let heads = reader.headers().cloned().unwrap_or_default();
    let heads: Vec<&str> = heads.iter().collect();
    let Some(ended) = heads.windows(2).position(|pair| pair == OUTCOME) else {
        return Vec::new();
    };
    if !heads.starts_with(&CASE) {
        return Vec::new();
    }
    let part = |k: usize| match k {
        0 | 1 => Section::Case,
        k if k < ended => Section::Keys,
        k if k < ended + 2 => Section::Outcome,
        k if heads[k].starts_with(CHECK) => Section::Checks,
        _ => Section::Last,
    };
    let line = |record: csv::StringRecord| {
        let cells = heads.iter().zip(&record).enumerate();
        let written = cells.filter(|(_, (_, text))| !text.is_empty());
        let cell = |(k, (head, text)): (usize, (&&str, &str))| Cell {
            part: part(k),
            head: (*head).to_owned(),
            text: text.to_owned(),
        };
        written.map(cell).collect()
    };
    reader.records().filter_map(Result::ok).map(line).collect()
}

/// Writes the table as `sweep.csv` into `folder`; gives its text.
///
/// # Errors
/// The disk.
pub fn write_table(
    rows: &[Row],
    earlier: Option<&str>,
    folder: &Path,
) -> Result<String, OutputError> {
    let path = folder.join(TABLE);
    let at = |path: &Path, source: std::io::Error| OutputError { path: path.to_owned(), source };
    let table = table_with(rows, earlier).map_err(|wrong| at(&path, wrong.into()))?;
    // A link stays one.
    let target = path.canonicalize().unwrap_or_else(|_| path.clone());
    write_whole(&target, &table).map_err(|wrong| at(&path, wrong.source))?;
    Ok(String::from_utf8_lossy(&table).into_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_value_that_the_user_set_stands_in_the_table() {
        let pair = |key: &str, value: &str| (key.to_owned(), value.to_owned());
        let of_variant = [pair("a.b", "1"), pair("a.c", "2")];
        let set = [pair("a.c", "3"), pair("a.c", "4")];
        assert_eq!(as_run(&of_variant, &set), [pair("a.b", "1"), pair("a.c", "4")]);
    }

    #[test]
    fn what_was_cut_short_goes_on_and_what_has_finished_is_kept() {
        use std::sync::atomic::{AtomicUsize, Ordering};

        let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
        let file = root.join("scenes/verify/planar/a5_stop.toml");
        let mut scene = Scene::load(&file, &[]).expect("a scene");
        scene.cases.truncate(1);
        let run = |folder: &Path, looks: usize| {
            let count = AtomicUsize::new(0);
            let stop = || count.fetch_add(1, Ordering::Relaxed) >= looks;
            let mut rows = Vec::new();
            sweep(&scene, folder, Existing::Refuse, &Executor { threads: 1, stop: &stop }, |row| {
                rows.push(row);
            });
            rows.remove(0)
        };
        let folder = tempfile::tempdir().expect("a folder");
        let [whole, cut] = ["whole", "cut"].map(|name| folder.path().join(name));
        let all = run(&whole, usize::MAX);
        let short = run(&cut, 2);
        assert!(!short.finished && (1..all.steps).contains(&short.steps), "{short:?}");
        let on = run(&cut, usize::MAX);
        assert!(on.finished && !on.kept, "{}", on.ended);
        assert_eq!((on.steps, &on.last), (all.steps, &all.last));
        let again = run(&cut, 2);
        assert!(again.finished && again.kept);
        // Without a checkpoint there is nothing to go on from.
        let begun = folder.path().join("begun");
        run(&begun, 2);
        std::fs::remove_dir_all(begun.join(&scene.cases[0].name).join("checkpoints")).ok();
        assert!(run(&begun, usize::MAX).finished);
    }

    #[test]
    fn rows_of_different_cases_share_their_columns() {
        let row = |case: &str, key: &str, head: &str| Row {
            case: case.to_owned(),
            variant: "default".to_owned(),
            changes: vec![(key.to_owned(), "\"5 deg\"".to_owned())],
            ended: "finished".to_owned(),
            finished: true,
            warnings: Vec::new(),
            kept: false,
            unwritten: false,
            steps: 7,
            last: vec![(head.to_owned(), 0.5)],
            checks: Vec::new(),
        };
        let rows = [row("a", "k", "slip [m]"), row("b", "l", "slip [m]")];
        let text = String::from_utf8(table(&rows).unwrap()).unwrap();
        assert_eq!(
            text,
            "case,variant,k,l,ended,steps,slip [m]\na,default,5 deg,,finished,7,0.5\n\
             b,default,,5 deg,finished,7,0.5\n"
        );
        // Another sweep into the same folder: cases of its own are new, others stay.
        let more = [row("b", "l", "turn [rad]"), row("c", "l", "slip [m]")];
        let both = String::from_utf8(table_with(&more, Some(&text)).unwrap()).unwrap();
        assert_eq!(
            both,
            "case,variant,l,k,ended,steps,turn [rad],slip [m]\nb,default,5 deg,,finished,7,0.5,\n\
             c,default,5 deg,,finished,7,,0.5\na,default,,5 deg,finished,7,,0.5\n"
        );
        let foreign = table_with(&more, Some("hello\n1\n")).unwrap();
        assert_eq!(foreign, table(&more).unwrap());
    }
}
