//! `riprap safety`: factor of safety by reduction of strengths, limits of other numbers.

use std::path::Path;

use riprap::record::folder::Existing;
use riprap::run::drive::{Control, Ending};
use riprap::run::job::{self, Job};
use riprap::run::safety::{self, Answer, Quantity, Rules, SafetyError, Trial};
use riprap::scenario::units::{self, Dim};

use crate::args::Safety;
use crate::commands::plot::{self, quantity};
use crate::commands::run::target;
use crate::commands::trials::make_folder;
use crate::commands::{threads, write_file};
use crate::diagnostics::{Style, print_line};
use crate::failure::Failure;
use crate::interrupt::Interrupt;
use crate::numbers::{duration, grouped, si};
use crate::{scenes, screen};

/// Frames of the run of the mechanism.
const FRAMES: u64 = 20;

/// `riprap safety`.
pub fn run(args: &Safety, style: Style) -> Result<(), Failure> {
    let prepared = scenes::prepare(&args.scene, style, args.how.quiet)?;
    let over = match (&args.quantity, &args.range) {
        (Some(key), Some(range)) => {
            let read = Quantity::read(key, range, args.width.as_deref());
            Some(read.map_err(SafetyError::from)?)
        }
        _ => None,
    };
    let factor = Rules::default().width;
    let width = match (&over, &args.width) {
        (Some(quantity), _) => quantity.width,
        (None, Some(text)) => match units::parse(text) {
            Ok((width, Dim::NONE)) => width,
            Ok(_) | Err(_) => {
                let text = format!(
                    "{text:?} is not a valid width of the factor; write for example --width 0.01"
                );
                return Err(Failure::Input(text));
            }
        },
        (None, None) => factor,
    };
    let rules = Rules {
        width,
        interfaces: args.interfaces.clone(),
        materials: args.materials.clone(),
        groups: args.groups.clone(),
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
    let stop = || interrupt.asked();
    let mut count = 0;
    let mut report = |trial: &Trial| {
        count += 1;
        if args.json {
            screen::line(&serde_json::json!(trial).to_string());
        } else if !args.how.quiet {
            screen::line(&line(count, trial, over.as_ref()));
        }
    };
    let threads = threads(&args.how);
    let (answer, job) = if let Some(quantity) = &over {
        let scene = scenes::load(&args.scene.file, &args.scene.change)?;
        let case = scenes::case(&scene, &args.scene.change)?;
        let answer =
            safety::over_quantity(&scene, &case, quantity, &rules, threads, &stop, &mut report)?;
        let value = answer.fails_at.unwrap_or(quantity.low);
        (answer, quantity.prepare(&scene, &case, value)?.job())
    } else {
        let job = prepared.job();
        let (setup, plan) = (&job.setup, &job.plan);
        let answer = safety::search(setup, plan, &rules, threads, &stop, &mut report)?;
        (answer, job)
    };
    // Before the mechanism is run, which takes as long again and may be stopped.
    write(&folder.join("safety.json"), &serde_json::json!(&answer).to_string())?;
    write(&folder.join("safety.csv"), &answer.table())?;
    if let Some(job) = safety::mechanism_job(job, &rules, &answer, FRAMES)? {
        mechanism(job, &folder, existing, threads, &interrupt)?;
    }
    if args.json {
        screen::line(&serde_json::json!(&answer).to_string());
    } else {
        screen::line(&answer.words());
        if let Some(text) = answer.mechanism_words() {
            screen::line(&text);
        }
        screen::line(&format!("{}", folder.display()));
    }
    if !answer.is_found() {
        return Err(Failure::Physics(missing(&answer)));
    }
    if answer.undecided {
        print_line(
            "warning",
            "trials inside the range were undecided; increase --steps, or examine the run of the mechanism",
        );
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
    threads: usize,
    interrupt: &Interrupt,
) -> Result<(), Failure> {
    let target = folder.join("mechanism.run");
    let outcome = job::run(job, &target, existing, threads, &mut |_| {
        if interrupt.asked() { Control::Stop } else { Control::Continue }
    })?;
    if matches!(outcome.ending, Ending::Stopped) {
        return Err(Failure::Interrupted(format!("the answer is in {}", folder.display())));
    }
    plot::all(&target)?;
    Ok(())
}

fn write(path: &Path, text: &str) -> Result<(), Failure> {
    write_file(path, format!("{}\n", text.trim_end()).as_bytes())
}

/// `F = 1.2500  failing    moved 12.3 mm (block wedge)  2 450 steps in 0.8 s`.
fn line(count: usize, trial: &Trial, over: Option<&Quantity>) -> String {
    let value = match over {
        None => format!("F = {:<8.4}", trial.value),
        Some(quantity) => format!("{:<12}", quantity.shown.text(trial.value, 6)),
    };
    let mut text = format!(
        "{count:>3}  {value} {:<9}  moved {} ({})  {} steps in {}",
        trial.state.word(),
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

impl From<SafetyError> for Failure {
    fn from(error: SafetyError) -> Self {
        match error {
            SafetyError::Stopped => Failure::Interrupted("no answer yet".to_owned()),
            SafetyError::Build(_)
            | SafetyError::Exec(_)
            | SafetyError::Unknown { .. }
            | SafetyError::NoStrength(_)
            | SafetyError::Range(_)
            | SafetyError::NotANumber => Failure::Input(error.to_string()),
            SafetyError::Scene(wrong) => Failure::Scene(wrong),
        }
    }
}
