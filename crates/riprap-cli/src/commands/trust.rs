//! `riprap trust`: each named result with its error.

use std::path::{Path, PathBuf};

use riprap::plot::{self, PlotError, Tornado};
use riprap::run::study::Executor;
use riprap::run::study::trust::{self, Answer, Rules, TABLE, Trial};
use riprap::scenario::units::Dim;

use crate::args::Trust;
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
    scenes::prepare_case(&scene, &case, &args.scene.change, style, args.how.quiet || args.json)?;
    let budget = quantity(&args.budget, Dim::TIME, "time", "--budget 10min")?;
    if budget < 0.0 {
        let text = format!("--budget is a wall time, and {} is below zero", args.budget);
        return Err(Failure::Input(text));
    }
    let rules = Rules { budget, without: args.without.clone() };
    let (folder, existing) = target(args.out.as_deref(), &args.scene.file, "trust", args.force);
    make_folder(&folder, existing)?;
    let interrupt = Interrupt::listen()?;
    let executor = Executor { threads: threads(&args.how), stop: &|| interrupt.asked() };
    let mut count = 0;
    let mut report = |trial: &Trial| {
        count += 1;
        if args.json {
            screen::line(&serde_json::json!(trial).to_string());
        } else if !args.how.quiet {
            screen::line(&line(count, trial));
        }
    };
    let answer = trust::trust(&scene, &case, &rules, &executor, &mut report)?;
    answer.write(&folder).map_err(|wrong| Failure::Output(wrong.to_string()))?;
    let picture = picture(&scene.parsed.scenario.title, &answer, &folder)?;
    if args.json {
        screen::line(&serde_json::json!(answer).to_string());
        return Ok(());
    }
    screen::print(&format!("\n{}\n", answer.words()));
    for path in std::iter::once(folder.join(TABLE)).chain(picture) {
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
    let mut text = format!(
        "{count:>3}  {what}: {} steps in {}",
        grouped(trial.steps),
        duration(trial.seconds)
    );
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
