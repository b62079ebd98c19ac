//! `riprap verify`.

use riprap::run::scene::Scene;
use riprap::run::study::trust::{Question, has_results};
use riprap::run::study::{Executor, verify};

use super::self_test::Shipped;
use crate::args::Verify;
use crate::commands::trust::{self, Told};
use crate::commands::{check_line, cores};
use crate::diagnostics::print_line;
use crate::failure::Failure;
use crate::interrupt::Interrupt;
use crate::{scenes, screen};

pub fn run(args: &Verify) -> Result<(), Failure> {
    let mut scenes = Vec::new();
    for path in &args.paths {
        if !path.exists() {
            return Err(Failure::Input(scenes::missing(path)));
        }
        let found = verify::scenes_under(path)
            .map_err(|error| Failure::Input(format!("{}: {error}", path.display())))?;
        if found.is_empty() {
            let shown = path.display();
            return Err(Failure::Input(format!("{shown} has no scenes with checks")));
        }
        scenes.extend(found);
    }
    let shipped = match &args.shipped[..] {
        [] => None,
        names => Some(Shipped::named(names)?),
    };
    scenes.extend(shipped.iter().flat_map(|shipped| shipped.scenes.iter().cloned()));
    let errors = trust::asked(&args.errors)?;
    let interrupt = Interrupt::listen()?;
    let threads = args.jobs.map_or_else(cores, usize::from);
    let executor = Executor { threads, stop: &|| interrupt.asked() };
    let tally = verify::verify(&scenes, &args.set, args.strict, &executor, |result| {
        let result = match &shipped {
            Some(shipped) => shipped.told(result),
            None => result,
        };
        if args.json {
            // A result is numbers and texts: it always has a JSON form.
            screen::line(&serde_json::to_string(&result).unwrap_or_default());
        } else {
            screen::line(&check_line(&result, true));
        }
    });
    if !args.json {
        screen::line(&tally.to_string());
    }
    for path in errors.iter().flat_map(|_| &scenes) {
        // What cannot be read has been reported as a check that failed.
        let Some((scene, rules)) = Scene::load(path, &args.set).ok().zip(errors.as_ref()) else {
            continue;
        };
        for case in &scene.cases {
            // Nor a model that cannot be built.
            let Ok(prepared) = scene.prepare(case) else { continue };
            let name = match scene.cases.len() {
                1 => path.display().to_string(),
                _ => format!("{}, case {}", path.display(), case.name),
            };
            if has_results(&scene, prepared).is_err() {
                print_line("note", &format!("{name}: no named results"));
                continue;
            }
            if !args.json {
                screen::line(&format!("{name}:"));
            }
            let told = Told { quiet: true, json: args.json };
            let of = (&scene, case);
            trust::errors(of, Question::Results, rules, &executor, (None, told))?;
        }
    }
    if interrupt.asked() {
        return Err(Failure::Interrupted("not all scenes were run".to_owned()));
    }
    if tally.failed > 0 && tally.failed == tally.unread {
        // Which, and why, has been said in its line.
        Err(Failure::Input("no check failed, but not all scenes can be read".to_owned()))
    } else if tally.failed > 0 {
        Err(Failure::Checks)
    } else if tally.passed + tally.skipped == 0 {
        Err(Failure::Input(
            "nothing was verified: no scene has a check; add [[checks]], or use `riprap run`"
                .to_owned(),
        ))
    } else {
        Ok(())
    }
}
