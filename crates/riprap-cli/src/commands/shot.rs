//! `riprap shot`.

use riprap::plot::{self, BlockOptions, Which};
use riprap::scenario::units::Dim;

use super::plot::{quantity, range};
use super::run_folder;
use crate::args::{ContactPoints, Shot, TrailColour};
use crate::failure::Failure;
use crate::screen;

pub fn run(args: &Shot) -> Result<(), Failure> {
    run_folder(&args.run, "shot")?;
    let out = args.output.clone().unwrap_or_else(|| args.run.join("plots/shot.png"));
    let film = plot::is_film(&out);
    if !film && out.extension().is_none_or(|ending| !ending.eq_ignore_ascii_case("png")) {
        let text =
            format!("{} is no PNG; write for example -o shot.png or -o film.apng", out.display());
        return Err(Failure::Input(text));
    }
    let time = |t: &String| Ok(Which::Time(quantity(t, Dim::TIME, "time", "--time '0.5 s'")?));
    let mut frames = args.time.iter().map(time).collect::<Result<Vec<_>, Failure>>()?;
    if frames.is_empty() && !args.all && !film {
        frames.push(Which::Last);
    }
    let shot = asked(args, frames.first().copied().unwrap_or(Which::Last))?;
    if let Some(folder) = out.parent().filter(|_| args.run.join("manifest.json").exists()) {
        std::fs::create_dir_all(folder)
            .map_err(|e| Failure::Output(format!("could not create {}: {e}", folder.display())))?;
    }
    let run = plot::Run { folder: &args.run, of: args.of.as_deref() };
    for path in plot::shots(run, &frames, &shot, args.fps, &out)? {
        screen::line(&path.display().to_string());
    }
    Ok(())
}

/// What is to be drawn: a saved view or a new one, and what the command line says otherwise.
fn asked(args: &Shot, first: Which) -> Result<plot::Shot, Failure> {
    let pair = |of: &[f64]| [of[0], of[1]];
    let asked = plot::Asked {
        saved: args.saved.as_deref(),
        views: args.views.as_deref(),
        field: args.by.as_deref(),
        view: args.view.as_deref().map(pair),
        perspective: args.perspective,
    };
    let mut shot = plot::Shot::asked(&args.run, first, &asked)?;
    if let (Some(normal), Some(at)) = (args.cut, &args.at) {
        let at = quantity(at, Dim::LENGTH, "length", "--at '2 m'")?;
        shot.cut = Some(plot::Cut::nearer(normal, at, &shot.eye));
    }
    let old = shot.options;
    shot.options = BlockOptions {
        log: old.log || args.log,
        range: range(args.range.as_deref(), &args.run, first, &shot.field)?
            .or(old.range.filter(|_| args.percentiles.is_none())),
        percentiles: args.percentiles.as_deref().map(pair),
        exaggeration: args.exaggerate.or(old.exaggeration),
        ..old
    };
    shot.bolts &= !args.no_bolts;
    shot.shadows &= !args.no_shadows;
    shot.chains |= args.chains;
    if let Some(which) = args.contacts {
        shot.contacts = Some(match which {
            ContactPoints::Changed => plot::CHANGED,
            ContactPoints::All => plot::CHANGED.map(|_| true),
        });
    }
    if let Some(by) = args.trails {
        shot.trails = Some(plot::Trails { by_block: matches!(by, TrailColour::Block), only: None });
    }
    if args.vectors.is_some() {
        shot.vectors.clone_from(&args.vectors);
    }
    if let Some(size) = &args.size {
        shot.size = [size[0], size[1]];
    }
    Ok(shot)
}
