//! `riprap safety`: factor of safety by reduction of strengths.

use std::path::Path;

use riprap::plan::Every;
use riprap::record::folder::Existing;
use riprap::run::drive::{Control, Ending};
use riprap::run::job::{self, Job};
use riprap::run::safety::{self, Answer, Mechanism, Rules, SafetyError, State, Trial};
use riprap::scenario::units::Dim;

use crate::args::Safety;
use crate::commands::plot::{self, quantity};
use crate::commands::run::target;
use crate::commands::threads;
use crate::commands::trials::make_folder;
use crate::diagnostics::{Style, print_line};
use crate::failure::Failure;
use crate::interrupt::Interrupt;
use crate::numbers::{duration, grouped, si};
use crate::{scenes, screen};

/// Blocks of the mechanism that are named on the screen.
const NAMED: usize = 5;
/// Frames of the run of the mechanism.
const FRAMES: u64 = 20;

/// `riprap safety`.
pub fn run(args: &Safety, style: Style) -> Result<(), Failure> {
    let prepared = scenes::prepare(&args.scene, style, args.how.quiet)?;
    let rules = Rules {
        width: args.width,
        interfaces: args.interfaces.clone(),
        moved: (args.moved.as_deref())
            .map(|text| quantity(text, Dim::LENGTH, "length", "--moved '5 mm'"))
            .transpose()?,
        balance: args.balance,
        steps: args.steps,
        from_start: args.from_start,
    };
    let (folder, existing) = target(args.out.as_deref(), &args.scene.file, "safety", args.force);
    make_folder(&folder, existing)?;
    let interrupt = Interrupt::listen()?;
    let job = prepared.job();
    let mut count = 0;
    let answer = safety::search(
        &job.setup,
        &job.plan,
        &rules,
        threads(&args.how),
        &|| interrupt.asked(),
        &mut |trial| {
            count += 1;
            if args.json {
                screen::line(&serde_json::json!(trial).to_string());
            } else if !args.how.quiet {
                screen::line(&line(count, trial));
            }
        },
    )?;
    write(
        &folder.join("safety.json"),
        &serde_json::json!(&answer).to_string(),
    )?;
    write(&folder.join("safety.csv"), &table(&answer))?;
    if let Some(factor) = answer.fails_at {
        mechanism(
            job, &rules, factor, &answer, &folder, existing, args, &interrupt,
        )?;
    }
    if args.json {
        screen::line(&serde_json::json!(&answer).to_string());
    } else {
        screen::line(&in_words(&answer, &rules));
        if let Some(text) = mechanism_line(&answer) {
            screen::line(&text);
        }
        screen::line(&format!("{}", folder.display()));
    }
    match (answer.stable_at, answer.fails_at) {
        (Some(_), Some(_)) if answer.undecided => {
            print_line(
                "warning",
                "trials inside the range were undecided: give them more --steps, or look at the run of the mechanism",
            );
            Ok(())
        }
        (Some(_), Some(_)) => Ok(()),
        _ => Err(Failure::Physics("no factor of safety was found".to_owned())),
    }
}

/// Runs the scene with a last phase in which the mechanism moves, and draws it.
#[allow(
    clippy::too_many_arguments,
    reason = "one caller, and each is a thing of its own"
)]
fn mechanism(
    mut job: Job,
    rules: &Rules,
    factor: f64,
    answer: &Answer,
    folder: &Path,
    existing: Existing,
    args: &Safety,
    interrupt: &Interrupt,
) -> Result<(), Failure> {
    let trials = answer.trials.iter().filter(|t| t.factor == factor);
    let steps = trials.map(|t| t.steps).max().unwrap_or(1);
    job.plan = safety::plan_of_mechanism(&job.setup, &job.plan, rules, factor, steps)?;
    job.plan.frames = Some(Every::Steps(steps.div_ceil(FRAMES).max(1)));
    job.checks.clear();
    let target = folder.join("mechanism.run");
    let outcome = job::run(job, &target, existing, threads(&args.how), &mut |_| {
        if interrupt.asked() {
            Control::Stop
        } else {
            Control::Continue
        }
    })?;
    if matches!(outcome.ending, Ending::Stopped) {
        return Err(Failure::Interrupted(format!(
            "the answer is in {}",
            folder.display()
        )));
    }
    plot::all(&target)?;
    Ok(())
}

fn write(path: &Path, text: &str) -> Result<(), Failure> {
    std::fs::write(path, format!("{}\n", text.trim_end()))
        .map_err(|e| Failure::Output(format!("could not write {}: {e}", path.display())))
}

fn word(state: State) -> &'static str {
    match state {
        State::Stable => "stable",
        State::Failing => "failing",
        State::Undecided => "undecided",
    }
}

/// `F = 1.2500  failing    moved 12.3 mm (block wedge)  2 450 steps in 0.8 s`.
fn line(count: usize, trial: &Trial) -> String {
    let mut text = format!(
        "{count:>3}  F = {:<8.4} {:<9}  moved {} ({})  {} steps in {}",
        trial.factor,
        word(trial.state),
        si(trial.moved, "m"),
        trial.block,
        grouped(trial.steps),
        duration(trial.seconds)
    );
    if !trial.note.is_empty() {
        text.push_str(&format!("\n     {}", trial.note));
    }
    text
}

fn in_words(answer: &Answer, rules: &Rules) -> String {
    // One digit more than the width has.
    let mut digits = 1;
    let mut width = rules.width;
    while width < 1.0 && digits < 9 {
        width *= 10.0;
        digits += 1;
    }
    match (answer.stable_at, answer.fails_at) {
        (Some(low), Some(high)) => format!("factor of safety: {low:.digits$} .. {high:.digits$}"),
        (Some(low), None) => {
            format!(
                "factor of safety: above {low}: the model stands with next to no strength in these interfaces"
            )
        }
        (None, Some(high)) => {
            format!("factor of safety: below {high}: no strength that was tried holds the model")
        }
        (None, None) => "factor of safety: unknown, no trial was decided".to_owned(),
    }
}

/// What moves, and how.
fn mechanism_line(answer: &Answer) -> Option<String> {
    let count = answer.moving.len();
    let (noun, s) = if count == 1 {
        ("block", "s")
    } else {
        ("blocks", "")
    };
    let how = match answer.mechanism? {
        Mechanism::Sliding => format!("slide{s} or fall{s} without turning"),
        Mechanism::Turning => format!("turn{s}"),
        Mechanism::Both => format!("slide{s} and turn{s}"),
    };
    let names: Vec<&str> = (answer.moving.iter().take(NAMED))
        .map(|(name, _)| name.as_str())
        .collect();
    let more = if count > NAMED {
        format!(" and {} more", count - NAMED)
    } else {
        String::new()
    };
    Some(format!(
        "mechanism: {} {noun} {how}: {}{more}",
        grouped(count as u64),
        names.join(", ")
    ))
}

/// The trials as CSV.
fn table(answer: &Answer) -> String {
    let mut text = "factor,state,moved (m),block,unbalanced,steps,seconds\n".to_owned();
    for t in &answer.trials {
        text.push_str(&format!(
            "{},{},{:e},{},{:e},{},{:.3}\n",
            t.factor,
            word(t.state),
            t.moved,
            t.block,
            t.unbalanced,
            t.steps,
            t.seconds
        ));
    }
    text
}

impl From<SafetyError> for Failure {
    fn from(error: SafetyError) -> Self {
        match error {
            SafetyError::Stopped => Failure::Interrupted("no answer yet".to_owned()),
            SafetyError::Build(_)
            | SafetyError::Exec(_)
            | SafetyError::Interface { .. }
            | SafetyError::NoStrength(_)
            | SafetyError::NotANumber => Failure::Input(error.to_string()),
        }
    }
}
