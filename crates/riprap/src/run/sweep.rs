//! All cases of a scene side by side, each in its own sub-folder, with one table.

use std::path::{Path, PathBuf};

use super::checks::{CheckResult, Status};
use super::drive::{Control, Ending, Look};
use super::job::{self, JobError, Outcome};
use super::scene::Scene;
use super::verify::Tally;
use crate::exec::side_by_side;
use crate::record::field::with_unit;
use crate::record::folder::Existing;
use crate::record::manifest::{Ended, Manifest};
use crate::record::read_plain_text;
use crate::record::table::Table;
use crate::scenario::{Case, Diagnostics, swept_and_set};

/// One row of the table.
#[derive(Clone, Debug)]
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
    let parsed = &scene.parsed;
    swept_and_set(&parsed.source, &parsed.scenario, &scene.changes)?;
    for case in &scene.cases {
        scene.prepare(case)?;
    }
    Ok(())
}

/// Runs all cases into sub-folders of `folder`, `jobs` at a time, and hands each row to `report` in
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
/// use riprap::run::sweep::{sweep, tally};
///
/// let path = Path::new("scenes/verify/planar/a5_stop.toml");
/// # let path = &Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(path);
/// # let results = tempfile::tempdir()?;
/// # let results = results.path();
/// let scene = Scene::load(path, &[])?;
/// let mut rows = Vec::new();
/// sweep(&scene, results, Existing::Refuse, 2, &|| false, |row| rows.push(row));
/// assert_eq!(rows.len(), scene.cases.len());
/// assert_eq!(tally(&rows).failed, 0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn sweep(
    scene: &Scene,
    folder: &Path,
    existing: Existing,
    jobs: usize,
    stop: &(dyn Fn() -> bool + Sync),
    mut report: impl FnMut(Row),
) {
    side_by_side(jobs, &scene.cases, |case| one(scene, case, folder, existing, stop), &mut report);
}

fn one(
    scene: &Scene,
    case: &Case,
    folder: &Path,
    existing: Existing,
    stop: &(dyn Fn() -> bool + Sync),
) -> Row {
    let mut row = Row {
        case: case.name.clone(),
        variant: case.variant.clone(),
        changes: as_run(&case.changes, &scene.changes),
        ended: "stopped by the user before it began".to_owned(),
        finished: false,
        kept: false,
        unwritten: false,
        steps: 0,
        last: Vec::new(),
        checks: Vec::new(),
    };
    if stop() {
        return row;
    }
    let folder = folder.join(&case.name);
    let mut look = |_: &mut Look<'_>| {
        if stop() { Control::Stop } else { Control::Continue }
    };
    let prepared = match scene.prepare(case) {
        Ok(prepared) => prepared,
        Err(wrong) => {
            row.ended = wrong.render();
            return row;
        }
    };
    let outcome = match (existing, before(&folder, &prepared.manifest)) {
        (Existing::Refuse, Before::Finished { steps, checks }) => {
            row.ended = "finished".to_owned();
            (row.finished, row.kept) = (true, true);
            (row.steps, row.checks) = (steps, checks);
            row.last = last_values(&folder);
            return row;
        }
        (Existing::Refuse, Before::CutShort) => match job::resume(&folder, 1, &mut look) {
            // Nothing to go on from: it begins again.
            Err(JobError::Checkpoint(_) | JobError::Ended { .. }) => {
                let replace = Existing::ReplaceRun;
                job::run(prepared.job(), &folder, replace, 1, &mut look)
            }
            gone_on => gone_on,
        },
        (existing, _) => job::run(prepared.job(), &folder, existing, 1, &mut look),
    };
    let outcome = outcome.map_err(|wrong: JobError| {
        row.unwritten = wrong.is_output();
        wrong.to_string()
    });
    match outcome {
        Err(why) => row.ended = why,
        Ok(Outcome { ending, manifest, checks, .. }) => {
            row.finished = ending == Ending::Finished;
            row.ended = match ending {
                Ending::Finished => "finished".to_owned(),
                Ending::Stopped => "stopped by the user".to_owned(),
                Ending::Unstable(why) => why.to_string(),
            };
            row.steps = manifest.steps;
            row.checks = checks;
            row.last = last_values(&folder);
        }
    }
    row
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

/// The checks of all rows, counted.
#[must_use]
pub fn tally(rows: &[Row]) -> Tally {
    let mut tally = Tally::default();
    rows.iter().flat_map(|row| &row.checks).for_each(|check| tally.add(check));
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
    let mut lines: Vec<Line> = rows.iter().map(Line::of).collect();
    let here: Vec<&str> = rows.iter().map(|row| row.case.as_str()).collect();
    let before = earlier.map(Line::all_of).unwrap_or_default();
    lines.extend(before.into_iter().filter(|line| !here.contains(&line.case())));
    let mut heads: [Vec<&str>; 3] = Default::default();
    for line in &lines {
        for (heads, cells) in heads.iter_mut().zip(&line.cells) {
            add_new(heads, cells.iter().map(|(head, _)| head.as_str()));
        }
    }
    let [keys, last, checks] = &heads;
    let mut out = csv::Writer::from_writer(Vec::new());
    let first = ["case", "variant"].into_iter().chain(keys.iter().copied());
    let all = first.chain(["ended", "steps"]).chain(last.iter().chain(checks).copied());
    out.write_record(all)?;
    for line in &lines {
        let cell = |of: usize, head: &&str| {
            let found = line.cells[of].iter().find(|(known, _)| known == head);
            found.map_or("", |(_, cell)| cell.as_str())
        };
        let [case, variant, ended, steps] = line.fixed.each_ref().map(String::as_str);
        let own = [case, variant].into_iter().chain(keys.iter().map(|head| cell(0, head)));
        let own = own.chain([ended, steps]).chain(last.iter().map(|head| cell(1, head)));
        out.write_record(own.chain(checks.iter().map(|head| cell(2, head))))?;
    }
    out.into_inner().map_err(|error| error.into_error().into())
}

/// A line of the table.
struct Line {
    /// Case, variant, how it ended, steps.
    fixed: [String; 4],
    /// Changed keys, last values, checks, each with the head of its column.
    cells: [Vec<(String, String)>; 3],
}

impl Line {
    fn case(&self) -> &str {
        &self.fixed[0]
    }

    fn of(row: &Row) -> Self {
        let keys = row.changes.iter();
        let keys = keys.map(|(key, value)| (key.clone(), value.trim_matches('"').to_owned()));
        let last = row.last.iter();
        let last = last.map(|(head, value)| (head.clone(), format!("{value}")));
        let checks = row.checks.iter().map(|check| {
            let status = match check.status {
                Status::Passed => "passed",
                Status::Failed => "failed",
                Status::Skipped => "skipped",
            };
            (format!("{CHECK}{}", check.check), status.to_owned())
        });
        Line {
            fixed: [
                row.case.clone(),
                row.variant.clone(),
                row.ended.clone(),
                row.steps.to_string(),
            ],
            cells: [keys.collect(), last.collect(), checks.collect()],
        }
    }

    /// The lines of a table; none of a text that is no such table.
    fn all_of(text: &str) -> Vec<Self> {
        let mut reader = csv::Reader::from_reader(text.as_bytes());
        let heads = reader.headers().cloned().unwrap_or_default();
        let place = |name: &str| heads.iter().position(|head| head == name);
        let (Some(0), Some(1), Some(ended)) = (place("case"), place("variant"), place("ended"))
        else {
            return Vec::new();
        };
        if place("steps") != Some(ended + 1) {
            return Vec::new();
        }
        let line = |record: csv::StringRecord| {
            let text = |k: usize| record.get(k).unwrap_or_default().to_owned();
            let mut line =
                Line { fixed: [0, 1, ended, ended + 1].map(text), cells: Default::default() };
            for (k, head) in heads.iter().enumerate() {
                let of = match k {
                    _ if [0, 1, ended, ended + 1].contains(&k) || text(k).is_empty() => continue,
                    _ if k < ended => 0,
                    _ if head.starts_with(CHECK) => 2,
                    _ => 1,
                };
                line.cells[of].push((head.to_owned(), text(k)));
            }
            line
        };
        reader.records().filter_map(Result::ok).map(line).collect()
    }
}

/// Head of the column of a check, before its name.
const CHECK: &str = "check: ";

fn add_new<'a>(list: &mut Vec<&'a str>, more: impl Iterator<Item = &'a str>) {
    for one in more {
        if !list.contains(&one) {
            list.push(one);
        }
    }
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
            sweep(&scene, folder, Existing::Refuse, 1, &stop, |row| {
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
