//! `riprap plot`.

use std::path::{Path, PathBuf};

use riprap::record::plot::{self, BlockOptions, PlotError, Which};
use riprap::scenario::units;

use crate::args::Plot;
use crate::failure::Failure;
use crate::screen;

pub fn run(args: &Plot) -> Result<(), Failure> {
    let folder = &args.run;
    let ending = if args.png { "png" } else { "svg" };
    let out = |name: &str| {
        args.output
            .clone()
            .unwrap_or_else(|| folder.join("plots").join(format!("{name}.{ending}")))
    };
    if args.output.is_none() && folder.join("manifest.json").exists() {
        let plots = folder.join("plots");
        std::fs::create_dir_all(&plots)
            .map_err(|e| Failure::Output(format!("could not make {}: {e}", plots.display())))?;
    }
    let frame = which(args.time.as_deref())?;
    let blocks = |out: &Path| plot::blocks(folder, frame, &args.by, BlockOptions::default(), out);
    let written: Vec<PathBuf> = match args.what.as_deref() {
        Some("histories") => plot::histories(folder, &[], &out("histories"))?,
        Some("energy") => plot::energy(folder, &out("energy"))?,
        Some("blocks") => blocks(&out(&format!("blocks_{}", args.by)))?,
        Some(name) => plot::histories(folder, &[name.to_owned()], &out(&file_name(name)))?,
        None => {
            let mut all = plot::energy(folder, &out("energy"))?;
            all.extend(blocks(&out(&format!("blocks_{}", args.by)))?);
            if folder.join("histories.csv").exists() {
                all.extend(plot::histories(folder, &[], &out("histories"))?);
            }
            all
        }
    };
    for path in written {
        screen::line(&path.display().to_string());
    }
    Ok(())
}

/// The frame at `time`, or the last.
fn which(time: Option<&str>) -> Result<Which, Failure> {
    let Some(text) = time else {
        return Ok(Which::Last);
    };
    let wrong = || {
        Failure::Input(format!(
            "{text:?} is no time; write for example --time '0.5 s'"
        ))
    };
    let (value, dim) = units::parse(text).map_err(|_| wrong())?;
    if dim == units::Dim::TIME {
        Ok(Which::Time(value))
    } else {
        Err(wrong())
    }
}

/// A history's name without what a file name cannot hold.
fn file_name(history: &str) -> String {
    let safe = |c: char| {
        if c.is_alphanumeric() || "-_.".contains(c) {
            c
        } else {
            '_'
        }
    };
    history.chars().map(safe).collect()
}

impl From<PlotError> for Failure {
    fn from(error: PlotError) -> Self {
        match error {
            PlotError::Output(_) => Failure::Output(error.to_string()),
            PlotError::Table(_)
            | PlotError::Frame(_)
            | PlotError::Manifest(_)
            | PlotError::Field(_)
            | PlotError::NoFrames { .. }
            | PlotError::NoSuchFrame { .. }
            | PlotError::NothingToDraw { .. }
            | PlotError::Ending { .. }
            | PlotError::Render { .. } => Failure::Input(error.to_string()),
        }
    }
}
