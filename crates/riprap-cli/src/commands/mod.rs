//! One file a verb. Each turns arguments into calls of the library and answers into text.

pub mod check;
pub mod doctor;
pub mod language;
pub mod muckpile;
pub mod new;
pub mod paraview;
pub mod plot;
pub mod probe;
mod ranks;
pub mod removable;
pub mod report;
pub mod run;
pub mod runout;
pub mod safety;
pub mod scratch;
pub mod self_test;
pub mod shell;
pub mod shot;
pub mod sizes;
pub mod strength;
pub mod sweep;
pub mod trials;
pub mod trust;
pub mod verify;
pub mod view;

use std::path::{Path, PathBuf};

use riprap::run::checks::{CheckResult, Status};
use riprap::run::study::verify::Tally;

use crate::args::How;
use crate::failure::Failure;
use crate::screen;

/// Where results of `scene` go when the user does not say: `hill.toml` gives `hill.run` in the
/// working folder, so that a scene library is never written into.
pub fn default_folder(scene: &Path, kind: &str) -> PathBuf {
    let stem = scene.file_stem().unwrap_or_default().to_string_lossy();
    PathBuf::from(format!("{stem}.{kind}"))
}

/// Writes a whole file aside and gives it its name then: what was there is never half overwritten. Pipes and devices are written as they are,
/// and so is the file that a link leads to.
pub fn write_file(path: &Path, bytes: &[u8]) -> Result<(), Failure> {
    let target = path.canonicalize().unwrap_or_else(|_| path.to_owned());
    if target.exists() && !target.is_file() {
        return std::fs::write(path, bytes)
            .map_err(|e| Failure::Output(format!("could not write {}: {e}", path.display())));
    }
    riprap::record::write_whole(&target, bytes).map_err(|error| {
        Failure::Output(format!("could not write {}: {}", path.display(), error.source))
    })
}

/// Says what a study has found: as JSON where that is asked for, else in words. Where a file is asked for, the table of all goes there.
fn answer(
    json: Option<serde_json::Value>,
    out: Option<&Path>,
    csv: impl FnOnce() -> Result<Vec<u8>, String>,
    words: impl FnOnce() -> String,
) -> Result<(), Failure> {
    if let Some(file) = out {
        write_file(file, &csv().map_err(Failure::Output)?)?;
    }
    if let Some(found) = json {
        screen::line(&found.to_string());
        return Ok(());
    }
    screen::line(&words());
    if let Some(file) = out {
        screen::line(&file.display().to_string());
    }
    Ok(())
}

/// Number of threads the user asked for, or of the machine.
pub fn threads(how: &How) -> usize {
    how.threads.map_or_else(cores, usize::from)
}

/// Cores of this machine.
pub fn cores() -> usize {
    std::thread::available_parallelism().map_or(1, std::num::NonZero::get)
}

/// Prints a line a check (those that failed even when `quiet`) and counts them.
pub fn check_lines(checks: &[CheckResult], quiet: bool) -> Tally {
    let mut tally = Tally::default();
    for check in checks {
        tally.add(check);
        if !quiet || check.status == Status::Failed {
            screen::line(&check_line(check, false));
        }
    }
    if !quiet && !checks.is_empty() {
        screen::line(&format!("checks: {tally}"));
    }
    tally
}

/// `passed  slides as the formula says: 2.11 m, expected 2.10 m (0.01 relative)`.
pub fn check_line(check: &CheckResult, with_scene: bool) -> String {
    let word = match check.status {
        Status::Passed => "passed ",
        Status::Failed => "FAILED ",
        Status::Skipped => "skipped",
    };
    let mut line = format!("{word} ");
    if with_scene {
        line.push_str(&check.scene);
        if !check.case.is_empty() {
            line.push_str(&format!(" [{}]", check.case));
        }
        line.push_str(": ");
    }
    line.push_str(&check.check);
    if !check.words.is_empty() {
        line.push_str(&format!(": {}", check.words));
    }
    if !check.note.is_empty() {
        line.push_str(&format!("; {}", check.note.replace('\n', "\n        ")));
    }
    line
}

/// Refuses what is no folder, and says what to write for `verb` instead: a scene is run, its run folder is looked at.
///
/// # Errors
/// A path that does not exist or is a file.
pub fn run_folder(path: &Path, verb: &str) -> Result<(), Failure> {
    if path.is_dir() {
        return Ok(());
    }
    let (shown, folder) = (path.display(), default_folder(path, "run"));
    let made = folder.join("manifest.json").exists();
    let scene = path.extension().is_some_and(|e| e == "toml");
    let next = match (made, scene && path.is_file()) {
        (true, _) => format!("write riprap {verb} {}", folder.display()),
        (false, true) => format!("write riprap run {shown}"),
        (false, false) => format!("for example riprap {verb} hill.run"),
    };
    let what = match (path.is_file(), scene) {
        (true, true) => "is a scene",
        (true, false) => "is a file",
        (false, _) => "does not exist",
    };
    Err(Failure::Input(format!(
        "{shown} {what}, but `{verb}` needs a run folder, written by `riprap run`; {next}"
    )))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[cfg(unix)]
    #[test]
    fn whole_files_are_replaced_and_links_and_devices_stay() {
        let dir = tempfile::tempdir().unwrap();
        let [file, link] = ["a.html", "link.html"].map(|name| dir.path().join(name));
        write_file(&file, b"one").unwrap();
        let before = std::fs::File::open(&file).unwrap();
        std::os::unix::fs::symlink(&file, &link).unwrap();
        write_file(&link, b"two").unwrap();
        assert_eq!(std::fs::read(&file).unwrap(), b"two");
        assert!(link.is_symlink());
        // Whoever has the old one open still reads it whole.
        assert_eq!(std::io::read_to_string(before).unwrap(), "one");
        write_file(Path::new("/dev/null"), b"three").unwrap();
        let told = write_file(&dir.path().join("no/a.html"), b"").unwrap_err();
        assert!(told.to_string().contains("no/a.html"), "{told}");
    }
}
