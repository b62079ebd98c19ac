//! `riprap muckpile`: what a blast has made.

use std::path::PathBuf;

use riprap::plot::{self, PlotError};
use riprap::run::muckpile::{Rules, muckpile};

use crate::args::Muckpile;
use crate::commands::run::target;
use crate::commands::trials::make_folder;
use crate::failure::Failure;
use crate::screen;

/// `riprap muckpile`.
pub fn run(args: &Muckpile) -> Result<(), Failure> {
    let rules = Rules::read(
        [args.moved.as_deref(), args.cell.as_deref()],
        args.along.as_deref(),
        args.rock_factor,
        [args.powder_factor.as_deref(), args.charge.as_deref()],
        args.strength,
        args.uniformity,
    );
    let mut rules = rules.map_err(Failure::Input)?;
    rules.of.clone_from(&args.of);
    let answer = muckpile(&args.run, &rules).map_err(|e| Failure::Input(e.to_string()))?;
    let (folder, existing) = target(args.out.as_deref(), &args.run, "muckpile", args.force);
    make_folder(&folder, existing)?;
    answer.write(&folder).map_err(|wrong| Failure::Output(wrong.to_string()))?;
    if let Some((surface, ground, labels)) = answer.profile() {
        drawn(plot::compare(&surface, &ground, &labels, &folder.join("profile.svg")))?;
    }
    if let Some((title, parts)) = answer.shares() {
        drawn(plot::partition(&title, &parts, &folder.join("energy_partition.svg")))?;
    }
    if args.json {
        screen::line(&serde_json::json!(answer).to_string());
        return Ok(());
    }
    screen::line(&answer.words());
    screen::line(&folder.display().to_string());
    Ok(())
}

/// A run need not have anything to draw.
fn drawn(picture: Result<Vec<PathBuf>, PlotError>) -> Result<(), Failure> {
    match picture {
        Ok(_) | Err(PlotError::NothingToDraw { .. }) => Ok(()),
        Err(wrong) => Err(wrong.into()),
    }
}
