//! `riprap runout`: run-out of rocks.

use riprap::plot::{self, PlotError, Sampled};
use riprap::run::runout::{Answer, Rules, runout};

use crate::args::Runout;
use crate::commands::run::target;
use crate::commands::trials::make_folder;
use crate::failure::Failure;
use crate::screen;

/// `riprap runout`.
pub fn run(args: &Runout) -> Result<(), Failure> {
    let rules = Rules { of: args.of.clone(), lines: args.line.clone() };
    let answer = runout(&args.runs, &rules).map_err(|e| Failure::Input(e.to_string()))?;
    let (folder, existing) = target(args.out.as_deref(), &args.runs[0], "runout", args.force);
    make_folder(&folder, existing)?;
    answer.write(&folder).map_err(|wrong| Failure::Output(wrong.to_string()))?;
    match plot::histograms("run-out", &numbers(&answer), &folder.join("runout.svg")) {
        Ok(_) | Err(PlotError::NothingToDraw { .. }) => {}
        Err(wrong) => return Err(wrong.into()),
    }
    if args.json {
        screen::line(&serde_json::json!(answer).to_string());
        return Ok(());
    }
    screen::line(&answer.words());
    screen::line(&folder.display().to_string());
    Ok(())
}

/// What is drawn: run-outs, then heights and speeds at each line.
fn numbers(answer: &Answer) -> Vec<Sampled> {
    let of = |name: &str, unit: &str, values: Vec<f64>| Sampled {
        name: name.to_owned(),
        unit: unit.to_owned(),
        values,
    };
    let mut all = vec![of("run-out", "m", answer.rocks.iter().map(|rock| rock.runout).collect())];
    for line in &answer.lines {
        let here = || answer.passages.iter().filter(|passage| passage.line == line.line);
        let heights = here().filter_map(|passage| passage.height).collect();
        all.push(of(&format!("{}: height above the ground", line.line), "m", heights));
        let speeds = here().map(|passage| passage.speed).collect();
        all.push(of(&format!("{}: speed", line.line), "m/s", speeds));
    }
    all
}
