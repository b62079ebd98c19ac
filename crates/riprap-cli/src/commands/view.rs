//! `riprap view`.

use std::path::{Path, PathBuf};
use std::time::Duration;

use riprap::record::Manifest;
use riprap::run::job::{self, Live};
use riprap_view::{Server, ServerError};

use super::scratch::Scratch;
use crate::args::{Change, View};
use crate::diagnostics::{self, Style};
use crate::failure::Failure;
use crate::{scenes, screen};

pub fn run(args: &View, style: Style) -> Result<(), Failure> {
    if args.run.is_file() && args.run.extension().is_some_and(|e| e == "toml") {
        if args.other.is_some() {
            let text =
                "a scene can only be viewed alone; name one scene, or one or two run folders";
            return Err(Failure::Input(text.to_owned()));
        }
        return preview(args, style);
    }
    let runs: Vec<_> =
        [Some(&args.run), args.other.as_ref()].into_iter().flatten().cloned().collect();
    for run in &runs {
        exists(run)?;
    }
    serve(&runs, args)
}

/// Time between two looks at the file of a scene.
const CHECK_INTERVAL: Duration = Duration::from_millis(300);

/// Shows the model of a scene as it stands before its first step, and again when the file is saved.
fn preview(args: &View, style: Style) -> Result<(), Failure> {
    let scratch = Scratch::new()
        .map_err(|e| Failure::Output(format!("could not create a temporary folder: {e}")))?;
    let folder = scratch.path().join(args.run.file_stem().unwrap_or_default());
    let gone = scratch.path().to_owned();
    ctrlc::set_handler(move || {
        // What stays behind goes when the next preview begins.
        let _ = std::fs::remove_dir_all(&gone);
        std::process::exit(i32::from(crate::failure::INTERRUPTED));
    })
    .map_err(|e| Failure::Input(format!("could not listen for Ctrl-C: {e}")))?;
    let (scene, change) = (args.run.clone(), args.change.clone());
    let model = model(&scene, &change, &folder, style)?;
    let watched = folder.clone();
    std::thread::spawn(move || watch(&scene, &change, &watched, style, model));
    serve(&[folder], args)
}

/// Writes the model of a scene into `folder`.
fn model(file: &Path, change: &Change, folder: &Path, style: Style) -> Result<Live, Failure> {
    let prepared = scenes::prepare_file(file, change, style, false)?;
    let scene = prepared.parsed.clone();
    job::preview(prepared.job(), folder).map_err(|error| Failure::of_job(error, &scene))
}

/// Rewrites the model whenever the scene has been saved. What is wrong with it is reported here and on the page.
fn watch(file: &Path, change: &Change, folder: &Path, style: Style, shown: Live) {
    let mut shown = Some(shown);
    let saved = || std::fs::metadata(file).and_then(|m| m.modified()).ok();
    let mut last = saved();
    loop {
        std::thread::sleep(CHECK_INTERVAL);
        let now = saved();
        // Editors that put a new file in the place of the old one leave none for a moment.
        if now.is_none() || now == last {
            continue;
        }
        last = now;
        let Err(failure) = renew(file, change, folder, style, &mut shown) else {
            continue;
        };
        failure.print(style);
        if let Ok(mut manifest) = Manifest::read(folder) {
            manifest.message = failure.to_string();
            if let Err(error) = manifest.write(folder) {
                diagnostics::print_line("note", &error.to_string());
            }
        }
    }
}

/// Shows the scene as it is saved now. A model that cannot be made does not take the old one away.
fn renew(
    file: &Path,
    change: &Change,
    folder: &Path,
    style: Style,
    shown: &mut Option<Live>,
) -> Result<(), Failure> {
    let prepared = scenes::prepare_file(file, change, style, false)?;
    let scene = prepared.parsed.clone();
    let of_job = |error| Failure::of_job(error, &scene);
    let job = prepared.job();
    let mut tried = job.clone();
    tried.checks.clear();
    Live::unrecorded(tried, 1).map_err(of_job)?;
    // The folder is in use as long as the old one lives. The file is not read again: it may have been saved since.
    *shown = None;
    *shown = Some(job::preview(job, folder).map_err(of_job)?);
    Ok(())
}

fn serve(runs: &[PathBuf], args: &View) -> Result<(), Failure> {
    let server = Server::bind(runs, args.port)?;
    let url = server.url();
    screen::line(&format!("{url}  (Ctrl-C stops it)"));
    if !args.no_open && open::that_detached(server.url_once()).is_err() {
        diagnostics::print_line("note", "no browser was found; open the address manually");
    }
    Ok(server.run()?)
}

/// A folder that is broken is reported on the page; one that does not exist is a slip of the pen.
fn exists(run: &Path) -> Result<(), Failure> {
    if run.is_dir() {
        return Ok(());
    }
    let what = if run.exists() {
        "is a file, neither a run folder nor a scene (.toml)"
    } else {
        "does not exist"
    };
    Err(Failure::Input(format!(
        "{} {what}; name a folder written by `riprap run`, for example: riprap view hill.run",
        run.display()
    )))
}

impl From<ServerError> for Failure {
    fn from(error: ServerError) -> Self {
        match error {
            ServerError::Listen { .. } => Failure::Input(format!("{error} (--port)")),
            ServerError::Random(_) | ServerError::Serve(_) => Failure::Output(error.to_string()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const BLOCK: &str = r#"
riprap = 1
title = "a block"
[space.planar]
gravity = ["0 m/s2", "-9.81 m/s2"]
[materials.rock]
density = "2600 kg/m3"
[interfaces.default]
normal_stiffness = "1 GPa/m"
friction_angle = "30 deg"
[[blocks]]
name = "block"
material = "rock"
rectangle = { size = ["1 m", "1 m"], corner = ["0 m", "0 m"] }
[[phases]]
name = "fall"
until = { time = "1 s" }
"#;

    #[test]
    fn a_bad_save_leaves_the_old_model_and_a_good_one_is_shown_after_any_failure() {
        let dir = tempfile::tempdir().unwrap();
        let (file, folder) = (dir.path().join("a.toml"), dir.path().join("a"));
        let change = Change { set: Vec::new(), case: None };
        let save = |text: &str| std::fs::write(&file, text).unwrap();
        let mut shown = None;
        let mut renewed = || {
            let done = renew(&file, &change, &folder, Style::Plain, &mut shown);
            (done.map_err(|e| e.to_string()), shown.is_some())
        };
        save(BLOCK);
        assert_eq!(renewed(), (Ok(()), true));
        save(&BLOCK.replace("density", "densty"));
        assert!(matches!(renewed(), (Err(_), true)));
        assert_eq!(Manifest::read(&folder).unwrap().title, "a block");
        // A folder that cannot be written is no end either.
        std::fs::remove_dir_all(&folder).unwrap();
        std::fs::write(&folder, "in the way").unwrap();
        save(BLOCK);
        assert!(matches!(renewed(), (Err(_), false)));
        std::fs::remove_file(&folder).unwrap();
        assert_eq!(renewed(), (Ok(()), true));
    }
}
