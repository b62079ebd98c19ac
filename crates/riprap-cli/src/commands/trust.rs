//! `riprap trust`: each named result with its error.

use std::path::{Path, PathBuf};

use riprap::plot::{self, PlotError, Tornado};
use riprap::run::scene::Scene;
use riprap::run::study::Executor;
use riprap::run::study::trust::{self, Answer, Cause, Question, Rules, TABLE, Trial};
use riprap::scenario::Case;
use riprap::scenario::units::Dim;

use crate::args::{Errors, Trust};
use crate::commands::plot::quantity;
use crate::commands::run::target;
use crate::commands::threads;
use crate::commands::trials::make_folder;
use crate::diagnostics::Style;
use crate::failure::Failure;
use crate::interrupt::Interrupt;
use crate::numbers::{duration, grouped};
use crate::{scenes, screen};

/// `riprap trust`.
pub fn run(args: &Trust, style: Style) -> Result<(), Failure> {
    let (scene, case) = scenes::chosen(&args.scene)?;
    let quiet = args.how.quiet || args.json;
    let prepared = scenes::prepare_case(&scene, &case, &args.scene.change, style, quiet)?;
    trust::has_results(&scene, prepared)?;
    let rules = rules(&args.budget, &args.without, "--budget")?;
    let (folder, existing) = target(args.out.as_deref(), &args.scene.file, "trust", args.force);
    make_folder(&folder, existing)?;
    let interrupt = Interrupt::listen()?;
    let executor = Executor { threads: threads(&args.how), stop: &|| interrupt.asked() };
    let told = Told { quiet: args.how.quiet, json: args.json };
    errors((&scene, &case), Question::Results, &rules, &executor, (Some(&folder), told))
}

/// How much is said.
#[derive(Clone, Copy)]
pub struct Told {
    pub quiet: bool,
    pub json: bool,
}

/// What `--trust` of other commands asks for; `None` without it.
pub fn asked(errors: &Errors) -> Result<Option<Rules>, Failure> {
    let budget = errors.trust.as_ref();
    budget.map(|budget| rules(budget, &errors.without, "--trust")).transpose()
}

fn rules(budget: &str, without: &[Cause], option: &str) -> Result<Rules, Failure> {
    let seconds = quantity(budget, Dim::TIME, "time", &format!("{option}=10min"))?;
    if seconds < 0.0 {
        let text = format!("{option} is a wall time, and {budget} is below zero");
        return Err(Failure::Input(text));
    }
    Ok(Rules { budget: seconds, without: without.to_vec() })
}

/// Gives what `question` asks its error: on the screen, and as tables and a picture in a folder.
pub fn errors(
    (scene, case): (&Scene, &Case),
    question: Question<'_>,
    rules: &Rules,
    executor: &Executor<'_>,
    (folder, told): (Option<&Path>, Told),
) -> Result<(), Failure> {
    let mut count = 0;
    let mut report = |trial: &Trial| {
        count += 1;
        if told.json {
            screen::line(&serde_json::json!(trial).to_string());
        } else if !told.quiet {
            screen::line(&line(count, trial));
        }
    };
    let answer = trust::trust_in((scene, case), question, rules, executor, &mut report)?;
    let mut files = Vec::new();
    if let Some(folder) = folder {
        answer.write(folder).map_err(|wrong| Failure::Output(wrong.to_string()))?;
        files.push(folder.join(TABLE));
        files.extend(picture(&scene.parsed.scenario.title, &answer, folder)?);
    }
    if told.json {
        screen::line(&serde_json::json!(answer).to_string());
        return Ok(());
    }
    screen::print(&format!("\n{}\n", answer.words()));
    for path in files {
        screen::line(&path.display().to_string());
    }
    Ok(())
}

/// `  3  step x 0.5: 2 450 steps in 0.8 s`.
fn line(count: usize, trial: &Trial) -> String {
    let what = match trial.cause {
        None => "as it stands".to_owned(),
        Some(trust::Cause::Seed) => format!("seed + {}", trial.factor),
        Some(cause) => format!("{} x {:.3}", cause.word(), trial.factor),
    };
    // Of a search for a key the steps are not known.
    let steps = match trial.steps {
        0 => String::new(),
        steps => format!("{} steps in ", grouped(steps)),
    };
    let mut text = format!("{count:>3}  {what}: {steps}{}", duration(trial.seconds));
    if !trial.note.is_empty() {
        text.push_str(&format!("\n     no results: {}", trial.note.replace('\n', "\n     ")));
    }
    text
}

/// A bar a cause for each result that has an error.
fn picture(title: &str, answer: &Answer, folder: &Path) -> Result<Option<PathBuf>, Failure> {
    let bars: Vec<Tornado> = answer
        .results
        .iter()
        .map(|result| Tornado {
            name: if result.unit.is_empty() {
                result.name.clone()
            } else {
                format!("{} [{}]", result.name, result.unit)
            },
            mean: result.value,
            swings: (result.parts.iter())
                .map(|part| {
                    let ends = [result.value - part.error, result.value + part.error];
                    (part.cause.word().to_owned(), ends)
                })
                .collect(),
        })
        .collect();
    let legend = "value of each result with what each cause of error adds to its interval";
    match plot::tornado_with(title, legend, &bars, &folder.join("trust.svg")) {
        Ok(made) => Ok(made.into_iter().next()),
        Err(PlotError::NothingToDraw { .. }) => Ok(None),
        Err(wrong) => Err(wrong.into()),
    }
}
