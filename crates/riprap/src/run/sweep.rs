//! All cases of a scene side by side, each in its own sub-folder, with one table.

use std::collections::BTreeMap;
use std::path::Path;

use super::checks::{CheckResult, Status};
use super::drive::{Control, Ending, Look};
use super::job::{self, JobError, Outcome};
use super::scene::Scene;
use super::verify::Tally;
use crate::exec::side_by_side;
use crate::record::field::with_unit;
use crate::record::folder::Existing;
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
/// the order of the cases.
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
    side_by_side(
        jobs,
        &scene.cases,
        |case| one(scene, case, folder, existing, stop),
        &mut report,
    );
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
        if stop() {
            Control::Stop
        } else {
            Control::Continue
        }
    };
    let outcome = scene
        .prepare(case)
        .map_err(|wrong| wrong.render())
        .and_then(|prepared| {
            job::run(prepared.job(), &folder, existing, 1, &mut look).map_err(|wrong: JobError| {
                row.unwritten = wrong.is_output();
                wrong.to_string()
            })
        });
    match outcome {
        Err(why) => row.ended = why,
        Ok(Outcome {
            ending,
            manifest,
            checks,
            ..
        }) => {
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
    let columns = table
        .columns
        .iter()
        .filter(|c| c.name != "step" && c.name != "time");
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
    rows.iter()
        .flat_map(|row| &row.checks)
        .for_each(|check| tally.add(check));
    tally
}

/// The table as CSV: case, variant, every changed key, how it ended, last values, checks.
///
/// # Errors
/// Never in practice: it is written to memory.
pub fn table(rows: &[Row]) -> Result<Vec<u8>, csv::Error> {
    let mut keys: Vec<&str> = Vec::new();
    let mut heads: Vec<&str> = Vec::new();
    let mut checks: Vec<&str> = Vec::new();
    for row in rows {
        add_new(&mut keys, row.changes.iter().map(|(key, _)| key.as_str()));
        add_new(&mut heads, row.last.iter().map(|(head, _)| head.as_str()));
        add_new(
            &mut checks,
            row.checks.iter().map(|check| check.check.as_str()),
        );
    }
    let mut out = csv::Writer::from_writer(Vec::new());
    let mut line: Vec<String> = vec!["case".to_owned(), "variant".to_owned()];
    line.extend(keys.iter().map(|key| (*key).to_owned()));
    line.extend(["ended".to_owned(), "steps".to_owned()]);
    line.extend(heads.iter().map(|head| (*head).to_owned()));
    line.extend(checks.iter().map(|check| format!("check: {check}")));
    out.write_record(&line)?;
    for row in rows {
        let changes: BTreeMap<&str, &str> = row
            .changes
            .iter()
            .map(|(key, value)| (key.as_str(), value.as_str()))
            .collect();
        let last: BTreeMap<&str, f64> = row
            .last
            .iter()
            .map(|(head, value)| (head.as_str(), *value))
            .collect();
        let status: BTreeMap<&str, Status> = row
            .checks
            .iter()
            .map(|c| (c.check.as_str(), c.status))
            .collect();
        let mut line = vec![row.case.clone(), row.variant.clone()];
        line.extend(keys.iter().map(|key| {
            changes
                .get(key)
                .map_or_else(String::new, |v| v.trim_matches('"').to_owned())
        }));
        line.extend([row.ended.clone(), row.steps.to_string()]);
        line.extend(
            heads
                .iter()
                .map(|h| last.get(h).map_or_else(String::new, |v| format!("{v}"))),
        );
        line.extend(checks.iter().map(|c| match status.get(c) {
            Some(Status::Passed) => "passed".to_owned(),
            Some(Status::Failed) => "failed".to_owned(),
            Some(Status::Skipped) => "skipped".to_owned(),
            None => String::new(),
        }));
        out.write_record(&line)?;
    }
    out.into_inner().map_err(|error| error.into_error().into())
}

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
        assert_eq!(
            as_run(&of_variant, &set),
            [pair("a.b", "1"), pair("a.c", "4")]
        );
    }

    #[test]
    fn rows_of_different_cases_share_their_columns() {
        let row = |case: &str, key: &str, head: &str| Row {
            case: case.to_owned(),
            variant: "default".to_owned(),
            changes: vec![(key.to_owned(), "\"5 deg\"".to_owned())],
            ended: "finished".to_owned(),
            finished: true,
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
    }
}
