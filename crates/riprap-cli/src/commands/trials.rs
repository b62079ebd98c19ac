//! `riprap sweep`, `riprap bisect` and `riprap compare`: a scene run more than once.

use std::path::Path;

use riprap::record::folder::Existing;
use riprap::run::drive::Ending;
use riprap::run::study::bisect::{self, Trial};
use riprap::run::study::sweep::{self, Row};
use riprap::run::study::{Executor, StudyError, laws};
use riprap::scenario::Case;

use crate::args::{Bisect, Compare, Sweep};
use crate::commands::run::target;
use crate::commands::{threads, write_file};
use crate::failure::Failure;
use crate::interrupt::Interrupt;
use crate::numbers::{grouped, ratio};
use crate::progress::Display;
use crate::{scenes, screen};

/// `riprap sweep`.
pub fn sweep(args: &Sweep) -> Result<(), Failure> {
    let (mut scene, case) = scenes::chosen(&args.scene)?;
    if args.scene.change.case.is_some() {
        scene.cases = vec![case];
    }
    // A slip in the last case is reported now, not when all others have been run.
    sweep::check_all(&scene)?;
    let (folder, existing) = target(args.out.as_deref(), &args.scene.file, "sweep", args.force);
    let earlier = sweep::earlier(&folder, existing);
    // Also where it was killed before it could write its table.
    let begun = |case: &Case| folder.join(&case.name).join("manifest.json").is_file();
    let again = existing == Existing::Refuse && scene.cases.iter().any(begun);
    if earlier.is_none() && !again {
        make_folder(&folder, existing)?;
    }
    if existing == Existing::Refuse
        && let Some(other) = sweep::other_run(&scene, &folder)?
    {
        return Err(Failure::Input(format!(
            "{} contains a run of another input or program; choose another folder, or replace it with --force",
            other.display()
        )));
    }
    let interrupt = Interrupt::listen()?;
    let (count, mut rows) = (scene.cases.len(), Vec::new());
    let executor = Executor { threads: threads(&args.how), stop: &|| interrupt.asked() };
    sweep::sweep(&scene, &folder, existing, &executor, |row: Row| {
        if !args.how.quiet {
            let (n, case, steps) = (rows.len() + 1, &row.case, grouped(row.steps));
            let kept = if row.kept { ", kept" } else { "" };
            screen::line(&format!("{n}/{count}  {case}: {}, {steps} steps{kept}", row.ended));
        }
        rows.push(row);
    });
    let table = sweep::write_table(&rows, earlier.as_deref(), &folder)
        .map_err(|wrong| Failure::Output(wrong.to_string()))?;
    let (tally, path) = (sweep::tally(&rows), folder.join(sweep::TABLE));
    if !args.how.quiet {
        screen::line(&format!("\n{}\n{}\nchecks: {tally}", table.trim_end(), path.display()));
    }
    if let Some(row) = rows.iter().find(|row| row.unwritten) {
        return Err(Failure::Output(row.ended.clone()));
    }
    if interrupt.asked() {
        return Err(Failure::Interrupted(format!("completed cases are in {}", path.display())));
    }
    if let Some(row) = rows.iter().find(|row| !row.finished) {
        return Err(Failure::Physics(format!("case {}: {}", row.case, row.ended)));
    }
    if tally.failed > 0 { Err(Failure::Checks) } else { Ok(()) }
}

/// Makes the folder that holds the sub-folders of several runs.
pub fn make_folder(folder: &Path, existing: Existing) -> Result<(), Failure> {
    let occupied = std::fs::read_dir(folder).is_ok_and(|mut entries| entries.next().is_some());
    if occupied && existing == Existing::Refuse {
        return Err(Failure::Input(format!(
            "{} is not empty; choose another folder, or replace its contents with --force",
            folder.display()
        )));
    }
    std::fs::create_dir_all(folder)
        .map_err(|e| Failure::Output(format!("could not create {}: {e}", folder.display())))
}

/// `riprap bisect`.
pub fn bisect(args: &Bisect) -> Result<(), Failure> {
    let (scene, case) = scenes::chosen(&args.scene)?;
    let interrupt = Interrupt::listen()?;
    let mut display = Display::new(args.how.quiet || args.json);
    let mut count = 0;
    let executor = Executor { threads: threads(&args.how), stop: &|| interrupt.asked() };
    let mut report = |trial: &Trial| {
        count += 1;
        screen::line(&trial_line(count, trial, args.json));
    };
    let found =
        bisect::bisect(&scene, &case, &executor, &mut |look| display.show(look), &mut report);
    display.close();
    let found = found?;
    let range = &found.range;
    if args.json {
        let line = serde_json::json!({
            "key": range.key, "unit": range.unit, "limit": found.limit(),
            "holds_at": found.holds_at, "fails_at": found.fails_at,
        });
        screen::line(&line.to_string());
        return Ok(());
    }
    let [limit, holds, fails] =
        [found.limit(), found.holds_at, found.fails_at].map(|value| bisect::words(range, value));
    screen::line(&format!("{}: limit {limit} (holds at {holds}, fails at {fails})", range.key));
    Ok(())
}

/// `trial 3: 35 deg holds (0.01 m, allowed up to 0.1 m)`.
fn trial_line(count: usize, trial: &Trial, json: bool) -> String {
    if json {
        let line = serde_json::json!({
            "trial": count, "value": trial.value, "failed": trial.failed,
            "measured": trial.measured, "note": trial.note,
        });
        return line.to_string();
    }
    let word = if trial.failed { "fails" } else { "holds" };
    let measured = match &trial.measured_words[..] {
        "" => String::new(),
        words => format!(" ({words})"),
    };
    let line = format!("trial {count}: {} {word}{measured} {}", trial.words, trial.note);
    line.trim_end().to_owned()
}

/// `riprap compare`.
pub fn compare(args: &Compare) -> Result<(), Failure> {
    let (scene, case) = scenes::chosen(&args.scene)?;
    // What cannot be compared is refused before a folder is made.
    laws::comparable(&scene)?;
    let (folder, existing) = target(args.out.as_deref(), &args.scene.file, "compare", args.force);
    make_folder(&folder, existing)?;
    let interrupt = Interrupt::listen()?;
    let mut display = Display::new(args.how.quiet);
    let executor = Executor { threads: threads(&args.how), stop: &|| interrupt.asked() };
    let result = laws::both_laws(&scene, &case, &folder, existing, &executor, &mut |law, look| {
        display.label(&format!("{law}  "));
        display.show(look);
    });
    display.close();
    let (sides, differences) = result?;
    let rows = differences.iter().map(|d| {
        let unit = if d.unit == "-" { "" } else { d.unit.as_str() };
        let [first, second] =
            [d.first, d.second].map(|value| format!("{value:.6e} {unit}").trim().to_owned());
        let largest = format!("{:.3e} {unit}", d.largest).trim().to_owned();
        let share = format!("{} %", ratio(100.0 * d.share));
        vec![d.what.clone(), first, second, largest, share, d.place.clone()]
    });
    let [first, second] = laws::LAWS;
    let heads = ["", first, second, "largest difference", "relative to the largest", "where"];
    let text = screen::table(&heads, rows);
    screen::print(&text);
    write_file(&folder.join("compare.txt"), text.as_bytes())?;
    for side in &sides {
        screen::line(&format!("{}: {}", side.law, side.folder.display()));
        if let Ending::Unstable(why) = &side.outcome.ending {
            return Err(Failure::Physics(format!("{}: {why}", side.law)));
        }
    }
    Ok(())
}

impl From<StudyError> for Failure {
    fn from(error: StudyError) -> Self {
        match error {
            StudyError::Scene(wrong) => Failure::Scene(wrong),
            StudyError::Job(wrong) => wrong.into(),
            StudyError::Stopped => Failure::Interrupted("nothing was found yet".to_owned()),
            StudyError::NoBisect { .. }
            | StudyError::OneLaw { .. }
            | StudyError::NoLimit(_)
            | StudyError::Compare(_)
            | StudyError::Unknown { .. }
            | StudyError::NoStrength(_)
            | StudyError::Range(_)
            | StudyError::NotANumber => Failure::Input(error.to_string()),
        }
    }
}
