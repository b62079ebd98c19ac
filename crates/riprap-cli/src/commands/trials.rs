//! `riprap sweep`, `riprap bisect` and `riprap compare`: a scene run more than once.

use std::path::Path;

use riprap::record::folder::Existing;
use riprap::run::drive::{Control, Ending};
use riprap::run::sweep::{self, Row};
use riprap::run::trials::{self, TrialError};
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
    let mut scene = scenes::load(&args.scene.file, &args.scene.change)?;
    if args.scene.change.case.is_some() {
        scene.cases = vec![scenes::case(&scene, &args.scene.change)?];
    }
    // A slip in the last case is reported now, not when all others have been run.
    sweep::check_all(&scene)?;
    let (folder, existing) = target(args.out.as_deref(), &args.scene.file, "sweep", args.force);
    let path = folder.join("sweep.csv");
    // Of an earlier sweep into this folder: what has finished is kept.
    let earlier = match existing {
        Existing::Refuse => riprap::record::read_plain_text(&path).ok(),
        Existing::ReplaceRun | Existing::Force => None,
    };
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
    let jobs = threads(&args.how);
    sweep::sweep(&scene, &folder, existing, jobs, &|| interrupt.asked(), |row: Row| {
        if !args.how.quiet {
            let (n, case, steps) = (rows.len() + 1, &row.case, grouped(row.steps));
            let kept = if row.kept { ", kept" } else { "" };
            screen::line(&format!("{n}/{count}  {case}: {}, {steps} steps{kept}", row.ended));
        }
        rows.push(row);
    });
    let table =
        sweep::table_with(&rows, earlier.as_deref()).map_err(|e| Failure::Output(e.to_string()))?;
    write_file(&path, &table)?;
    let tally = sweep::tally(&rows);
    if !args.how.quiet {
        screen::line(&format!(
            "\n{}\n{}",
            String::from_utf8_lossy(&table).trim_end(),
            path.display()
        ));
        screen::line(&format!("checks: {tally}"));
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
    let scene = scenes::load(&args.scene.file, &args.scene.change)?;
    let case = scenes::case(&scene, &args.scene.change)?;
    let interrupt = Interrupt::listen()?;
    let mut display = Display::new(args.how.quiet || args.json);
    let mut count = 0;
    let found = trials::search(
        &scene,
        &case,
        threads(&args.how),
        &|| interrupt.asked(),
        &mut |look| display.show(look),
        &mut |trial| {
            count += 1;
            let word = if trial.failed { "fails" } else { "holds" };
            if args.json {
                let line = serde_json::json!({
                    "trial": count, "value": trial.value, "failed": trial.failed,
                    "measured": trial.measured, "note": trial.note,
                });
                screen::line(&line.to_string());
            } else {
                let measured = match &trial.measured_words[..] {
                    "" => String::new(),
                    words => format!(" ({words})"),
                };
                let line =
                    format!("trial {count}: {} {word}{measured} {}", trial.words, trial.note);
                screen::line(line.trim_end());
            }
        },
    );
    display.close();
    let found = found?;
    if args.json {
        let line = serde_json::json!({
            "key": found.key, "unit": found.unit, "limit": found.limit(),
            "holds_at": found.holds_at, "fails_at": found.fails_at,
        });
        screen::line(&line.to_string());
        return Ok(());
    }
    let words = |value| found.shown.text(value, found.digits);
    screen::line(&format!(
        "{}: limit {} (holds at {}, fails at {})",
        found.key,
        words(found.limit()),
        words(found.holds_at),
        words(found.fails_at)
    ));
    Ok(())
}

/// `riprap compare`.
pub fn compare(args: &Compare) -> Result<(), Failure> {
    let scene = scenes::load(&args.scene.file, &args.scene.change)?;
    trials::comparable(&scene)?;
    // A case that does not exist is refused before a folder is made.
    scenes::case(&scene, &args.scene.change)?;
    let (folder, existing) = target(args.out.as_deref(), &args.scene.file, "compare", args.force);
    make_folder(&folder, existing)?;
    let interrupt = Interrupt::listen()?;
    let mut display = Display::new(args.how.quiet);
    let result = trials::both_laws(
        &scene,
        args.scene.change.case.as_deref(),
        &folder,
        existing,
        threads(&args.how),
        &mut |law, look| {
            display.label(&format!("{law}  "));
            display.show(look);
            if interrupt.asked() { Control::Stop } else { Control::Continue }
        },
    );
    display.close();
    let (sides, differences) = result?;
    let rows = differences.iter().map(|d| {
        let unit = if d.unit == "-" { "" } else { d.unit.as_str() };
        vec![
            d.what.clone(),
            format!("{:.6e} {unit}", d.first).trim().to_owned(),
            format!("{:.6e} {unit}", d.second).trim().to_owned(),
            format!("{:.3e} {unit}", d.largest).trim().to_owned(),
            format!("{} %", ratio(100.0 * d.share)),
            d.place.clone(),
        ]
    });
    let heads = [
        "",
        trials::LAWS[0],
        trials::LAWS[1],
        "largest difference",
        "relative to the largest",
        "where",
    ];
    let text = screen::table(&heads, rows);
    screen::print(&text);
    let path = folder.join("compare.txt");
    write_file(&path, text.as_bytes())?;
    for side in &sides {
        screen::line(&format!("{}: {}", side.law, side.folder.display()));
        if let Ending::Unstable(why) = &side.outcome.ending {
            return Err(Failure::Physics(format!("{}: {why}", side.law)));
        }
    }
    Ok(())
}

impl From<TrialError> for Failure {
    fn from(error: TrialError) -> Self {
        match error {
            TrialError::Scene(wrong) => Failure::Scene(wrong),
            TrialError::Job(wrong) => wrong.into(),
            TrialError::Stopped => Failure::Interrupted("no limit found yet".to_owned()),
            TrialError::NoBisect { .. }
            | TrialError::OneLaw { .. }
            | TrialError::NoLimit(_)
            | TrialError::Compare(_) => Failure::Input(error.to_string()),
        }
    }
}
