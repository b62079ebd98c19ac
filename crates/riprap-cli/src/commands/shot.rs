//! `riprap shot`.

use riprap::plot::{self, BlockOptions, Which};
use riprap::scenario::units::Dim;

use super::plot::{quantity, range};
use super::run_folder;
use crate::args::Shot;
use crate::failure::Failure;
use crate::screen;

pub fn run(args: &Shot) -> Result<(), Failure> {
    run_folder(&args.run, "shot")?;
    let time = |t: &String| Ok(Which::Time(quantity(t, Dim::TIME, "time", "--time '0.5 s'")?));
    let mut frames = args.time.iter().map(time).collect::<Result<Vec<_>, Failure>>()?;
    if frames.is_empty() && !args.all {
        frames.push(Which::Last);
    }
    let cut = match (args.cut, &args.at) {
        (Some(normal), Some(at)) => {
            Some((normal, quantity(at, Dim::LENGTH, "length", "--at '2 m'")?))
        }
        _ => None,
    };
    let pair = |of: &[f64]| [of[0], of[1]];
    let options = BlockOptions {
        log: args.log,
        range: range(
            args.range.as_deref(),
            &args.run,
            frames.first().copied().unwrap_or(Which::Last),
            &args.by,
        )?,
        percentiles: args.percentiles.as_deref().map(pair),
        exaggeration: args.exaggerate,
        ..BlockOptions::default()
    };
    let shot = plot::Shot {
        field: args.by.clone(),
        eye: pair(&args.view),
        size: [args.size[0], args.size[1]],
        cut,
        options,
    };
    let out = args.output.clone().unwrap_or_else(|| args.run.join("plots/shot.png"));
    if out.extension().is_none_or(|ending| !ending.eq_ignore_ascii_case("png")) {
        let text = format!("{} is no PNG; write for example -o shot.png", out.display());
        return Err(Failure::Input(text));
    }
    if let Some(folder) = out.parent().filter(|_| args.run.join("manifest.json").exists()) {
        std::fs::create_dir_all(folder)
            .map_err(|e| Failure::Output(format!("could not create {}: {e}", folder.display())))?;
    }
    for path in plot::shots(&args.run, &frames, &shot, &out)? {
        screen::line(&path.display().to_string());
    }
    Ok(())
}
