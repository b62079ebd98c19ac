//! `riprap safety`: factor of safety by reduction of strengths, limits of other numbers.

use std::path::Path;

use riprap::plan::Integration;
use riprap::record::folder::Existing;
use riprap::run::drive::{Ending, Look};
use riprap::run::job::{self, Job};
use riprap::run::study::safety::{self, Answer, Quantity, Rules, Trial};
use riprap::run::study::trust::Question;
use riprap::run::study::{Executor, StudyError};
use riprap::scenario::units::Dim;

use crate::args::Safety;
use crate::commands::plot::{self, quantity};
use crate::commands::run::target;
use crate::commands::threads;
use crate::commands::trials::make_folder;
use crate::commands::trust::{self, Told};
use crate::diagnostics::{Style, print_line};
use crate::failure::Failure;
use crate::interrupt::Interrupt;
use crate::numbers::{duration, grouped, si};
use crate::{scenes, screen};

/// `riprap safety`.
pub fn run(args: &Safety, style: Style) -> Result<(), Failure> {
    let (scene, case) = scenes::chosen(&args.scene)?;
    let prepared = scenes::prepare_case(&scene, &case, &args.scene.change, style, args.how.quiet)?;
    let over = match (&args.quantity, &args.range) {
        (Some(key), Some(range)) => {
            let read = Quantity::read(key, range, args.width.as_deref());
            Some(read.map_err(StudyError::from)?)
        }
        _ => None,
    };
    let rules = rules(args, over.as_ref())?;
    // Before there is a folder.
    safety::sound(&rules)?;
    let errors = trust::asked(&args.errors)?;
    let (folder, existing) = target(args.out.as_deref(), &args.scene.file, "safety", args.force);
    make_folder(&folder, existing)?;
    let interrupt = Interrupt::listen()?;
    let executor = Executor { threads: threads(&args.how), stop: &|| interrupt.asked() };
    let mut count = 0;
    let mut report = |trial: &Trial| {
        count += 1;
        if args.json {
            screen::line(&serde_json::json!(trial).to_string());
        } else if !args.how.quiet {
            screen::line(&line(count, trial, over.as_ref()));
        }
    };
    let of = over.as_ref().map(|quantity| (&scene, &case, quantity));
    let (answer, job) = safety::find(prepared.job(), of, &rules, &executor, &mut report)?;
    // Before the mechanism is run, which takes as long again and may be stopped.
    answer.write(&folder).map_err(|wrong| Failure::Output(wrong.to_string()))?;
    if let Some(job) = safety::mechanism_job(job, &rules, &answer)? {
        mechanism(job, &folder, existing, &executor)?;
    }
    tell(&answer, &folder, args.json)?;
    let Some(errors) = errors else {
        return Ok(());
    };
    let over = over.as_ref();
    let question = Question::Safety { rules: &rules, over, known: Some(&answer) };
    let told = Told { quiet: args.how.quiet, json: args.json };
    trust::errors((&scene, &case), question, &errors, &executor, (Some(&folder), told))
}

/// How the search is made.
fn rules(args: &Safety, over: Option<&Quantity>) -> Result<Rules, Failure> {
    let width = match (over, &args.width) {
        (Some(quantity), _) => quantity.width,
        (None, Some(text)) => quantity(text, Dim::NONE, "width of a factor", "--width 0.01")?,
        (None, None) => Rules::default().width,
    };
    let moved = args.moved.as_deref();
    Ok(Rules {
        width,
        interfaces: args.interfaces.clone(),
        materials: args.materials.clone(),
        groups: args.groups.clone(),
        moved: moved
            .map(|text| quantity(text, Dim::LENGTH, "length", "--moved '5 mm'"))
            .transpose()?,
        balance: args.balance,
        steps: args.steps,
        from_start: args.from_start,
        integration: match args.integration.as_str() {
            "explicit" => Integration::Explicit,
            "implicit" => Integration::Implicit,
            _ => Integration::Automatic,
        },
    })
}

/// Says what was found.
fn tell(answer: &Answer, folder: &Path, json: bool) -> Result<(), Failure> {
    if json {
        screen::line(&serde_json::json!(answer).to_string());
    } else {
        screen::line(&answer.words());
        if let Some(text) = answer.mechanism_words() {
            screen::line(&text);
        }
        screen::line(&format!("{}", folder.display()));
    }
    if !answer.is_found() {
        return Err(Failure::Physics(missing(answer)));
    }
    if answer.undecided {
        print_line(
            "warning",
            "trials inside the range were undecided; increase --steps, or examine the run of the mechanism",
        );
    }
    for text in [answer.far_words(), answer.lost_words()].into_iter().flatten() {
        print_line("warning", &text);
    }
    Ok(())
}

/// What was not found.
fn missing(answer: &Answer) -> String {
    match &answer.quantity {
        None => "no factor of safety was found".to_owned(),
        Some(key) => format!("no limit of `{key}` was found; give a wider --range"),
    }
}

/// Runs the scene until the mechanism has moved, and draws it.
fn mechanism(
    job: Job,
    folder: &Path,
    existing: Existing,
    executor: &Executor<'_>,
) -> Result<(), Failure> {
    let target = folder.join("mechanism.run");
    let control = &mut |_: &mut Look<'_>| executor.control();
    let outcome = job::run(job, &target, existing, executor.threads, control)?;
    if matches!(outcome.ending, Ending::Stopped) {
        return Err(Failure::Interrupted(format!("the answer is in {}", folder.display())));
    }
    plot::all(&target)?;
    Ok(())
}

/// `F = 1.2500  failing    moved 12.3 mm (block wedge)  2 450 steps in 0.8 s`.
fn line(count: usize, trial: &Trial, over: Option<&Quantity>) -> String {
    let value = match over {
        None => format!("F = {:<8.4}", trial.value),
        Some(quantity) => format!("{:<12}", quantity.shown.text(trial.value, 6)),
    };
    let mut text = format!(
        "{count:>3}  {value} {:<9}  moved {} ({})  {} steps{} in {}",
        trial.state.word(),
        si(trial.moved, "m"),
        trial.block,
        grouped(trial.steps),
        if trial.integration == Integration::Implicit { " by Newton's method" } else { "" },
        duration(trial.seconds)
    );
    if !trial.note.is_empty() {
        text.push_str(&format!("\n     {}", trial.note));
    }
    text
}
