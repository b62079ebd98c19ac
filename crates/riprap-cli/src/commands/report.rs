//! `riprap report`.

use std::path::{Path, PathBuf};

use riprap::plot::{self as drawn, Asked, BlockOptions, Shot, Which};
use riprap_view::report::{self, Limits, SETUP, SETUP_SECTION, SETUP_VIEW, Signature};
use riprap_view::run::Run;

use crate::args::Report;
use crate::commands::{plot, run_folder, write_file};
use crate::diagnostics;
use crate::failure::Failure;
use crate::screen;

pub fn run(args: &Report) -> Result<(), Failure> {
    run_folder(&args.run, "report")?;
    let run = Run::new(&args.run);
    run.manifest()
        .map_err(|problem| Failure::Input(format!("{}; {}", problem.what, problem.hint)))?;
    set_up(&args.run)?;
    // A picture that cannot be drawn, as of a run without frames, does not stop the report.
    if let Err(error) = plot::all(&args.run) {
        match error {
            Failure::Input(text) => diagnostics::print_line("note", &text),
            other => return Err(other),
        }
    }
    let limits = Limits { frames: usize::from(args.frames), ..Limits::default() };
    let signature = Signature { author: args.author.clone(), project: args.project.clone() };
    let html = report::report(&run, &pictures(&args.run), &signature, limits)
        .map_err(|problem| Failure::Input(format!("{}; {}", problem.what, problem.hint)))?;
    let out = args.output.clone().unwrap_or_else(|| default_name(&args.run));
    write_file(&out, html.as_bytes())?;
    let size = html.len() as f64 / 1e6;
    screen::line(&format!("{}  ({size:.1} MB)", out.display()));
    Ok(())
}

/// Draws the model at its first frame, coloured by material; in space a view and a section. What cannot be drawn is reported and left out.
fn set_up(run: &Path) -> Result<(), Failure> {
    let plots = run.join("plots");
    std::fs::create_dir_all(&plots)
        .map_err(|e| Failure::Output(format!("could not create {}: {e}", plots.display())))?;
    let first = Which::Index(1);
    let view = || {
        let asked = Asked { field: Some("material"), ..Asked::default() };
        let shot = Shot::asked(run, first, &asked)?;
        drawn::shots(run, &[first], &shot, None, &plots.join(SETUP_VIEW).with_extension("png"))
    };
    let flat = |name: &str| {
        let out = plots.join(name).with_extension("svg");
        drawn::blocks(run, first, "material", BlockOptions::default(), &out)
    };
    let drawn = match view() {
        Ok(_) => flat(SETUP_SECTION),
        // A run in the plane.
        Err(drawn::PlotError::Unsuitable { .. }) => flat(SETUP),
        Err(error) => Err(error),
    };
    match drawn {
        Ok(_) => Ok(()),
        Err(error @ drawn::PlotError::Output(_)) => Err(error.into()),
        Err(error) => {
            diagnostics::print_line("note", &format!("no picture of the initial model: {error}"));
            Ok(())
        }
    }
}

/// `hill.run` gives `hill.html` in the working folder.
fn default_name(run: &Path) -> PathBuf {
    let whole = run.canonicalize().unwrap_or_else(|_| run.to_owned());
    let stem = whole.file_stem().unwrap_or_default().to_string_lossy();
    PathBuf::from(format!("{stem}.html"))
}

/// SVG pictures in the run's plots and the view of the set-up, by name. Of a run in space, reports of earlier versions left a section as
/// the set-up.
fn pictures(run: &Path) -> Vec<PathBuf> {
    let view = run.join("plots").join(SETUP_VIEW).with_extension("png");
    let stale = view.exists().then(|| run.join("plots").join(SETUP).with_extension("svg"));
    let mut found: Vec<PathBuf> = std::fs::read_dir(run.join("plots"))
        .into_iter()
        .flatten()
        .flatten()
        .map(|entry| entry.path())
        .filter(|path| path.extension().is_some_and(|e| e == "svg") || *path == view)
        .filter(|path| stale.as_ref() != Some(path))
        .collect();
    found.sort();
    found
}
