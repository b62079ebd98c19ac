//! `riprap bisect` and `riprap compare`: a scene run more than once.

use std::path::Path;
use std::time::Instant;

use riprap::record::folder::Existing;
use riprap::run::drive::Ending;
use riprap::run::scene::Scene;
use riprap::run::study::bisect::{self, Trial};
use riprap::run::study::find::{self, Wanted};
use riprap::run::study::range::Quantity;
use riprap::run::study::safety::Rules;
use riprap::run::study::trust::Question;
use riprap::run::study::{Executor, StudyError, laws};
use riprap::scenario::Case;

use crate::args::{Bisect, Compare};
use crate::commands::run::target;
use crate::commands::trust::{self, Told};
use crate::commands::{threads, write_file};
use crate::diagnostics::print_line;
use crate::failure::Failure;
use crate::interrupt::Interrupt;
use crate::numbers::ratio;
use crate::progress::Display;
use crate::{scenes, screen};

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
    if let (Some(key), Some(range), Some(wanted)) = (&args.vary, &args.range, &args.until) {
        let range = Quantity::read(key, range, args.width.as_deref()).map_err(StudyError::from)?;
        return find(args, (&scene, &case), (&range, wanted));
    }
    if args.errors.trust.is_some() {
        let text = "--trust needs --vary, --range and --until; the table [bisect] has no result to give an error to";
        return Err(Failure::Input(text.to_owned()));
    }
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

/// `riprap find`: until a result is as wanted.
fn find(
    args: &Bisect,
    (scene, case): (&Scene, &Case),
    (range, wanted): (&Quantity, &Wanted),
) -> Result<(), Failure> {
    let errors = trust::asked(&args.errors)?;
    let interrupt = Interrupt::listen()?;
    let executor = Executor { threads: threads(&args.how), stop: &|| interrupt.asked() };
    let key = |value: f64| bisect::words(range, value);
    let begun = Instant::now();
    let mut count = 0;
    let mut report = |trial: &find::Trial| {
        count += 1;
        let text = match trial.result {
            _ if args.json => serde_json::json!({
                "trial": count, "value": trial.value, "result": trial.result, "note": trial.note,
            })
            .to_string(),
            Some(result) => {
                let (key, result) = (key(trial.value), wanted.text(result));
                format!("trial {count}: {key}: {} = {result}", wanted.result)
            }
            None => format!("trial {count}: {}: no result; {}", key(trial.value), trial.note),
        };
        if args.json || !args.how.quiet {
            screen::line(&text);
        }
    };
    let rules = Rules::default();
    let found = find::find(scene, case, (range, wanted), &rules, &executor, &mut report)?;
    let seconds = begun.elapsed().as_secs_f64();
    tell_found(&found, (range, wanted), args.json);
    let Some(errors) = errors else {
        return Ok(());
    };
    let question = Question::Find { range, wanted, rules: &rules, known: Some((&found, seconds)) };
    let told = Told { quiet: args.how.quiet, json: args.json };
    trust::errors((scene, case), question, &errors, &executor, (None, told))
}

/// Says what was found.
fn tell_found(found: &find::Found, (range, wanted): (&Quantity, &Wanted), json: bool) {
    if json {
        let line = serde_json::json!({
            "key": range.key, "unit": range.unit, "at": found.at, "result": wanted.result,
            "wanted": wanted.value, "below": found.below, "above": found.above,
            "monotone": found.monotone, "undecided": found.undecided,
        });
        screen::line(&line.to_string());
        return;
    }
    let key = |value: f64| bisect::words(range, value);
    let end = |[value, result]: [f64; 2]| format!("{} at {}", wanted.text(result), key(value));
    screen::line(&format!(
        "{}: {} ({}: {}, {})",
        range.key,
        key(found.at),
        wanted.result,
        end(found.below),
        end(found.above)
    ));
    if !found.monotone {
        print_line(
            "warning",
            &format!(
                "`{}` neither rises nor falls all along the trials: other values of `{}` may give it too; search parts of the range",
                wanted.result, range.key
            ),
        );
    }
    if found.undecided {
        print_line("warning", "runs inside the range had no result; the answer is a wider range");
    }
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
            StudyError::Ended(_) => Failure::Physics(error.to_string()),
            StudyError::NoBisect { .. }
            | StudyError::NoResults { .. }
            | StudyError::Outside(_)
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
