//! Python environments: `target/venv` for the tools of the tests, others made fresh.

use std::path::{Path, PathBuf};
use std::process::Command;

/// The Python of `target/venv`, made when needed.
pub fn python(root: &Path) -> Result<PathBuf, String> {
    let folder = root.join("target/venv");
    let python = folder.join("bin/python");
    let works = Command::new(&python).args(["-m", "pip", "--version"]).output();
    if works.is_ok_and(|o| o.status.success()) { Ok(python) } else { make(&folder) }
}

/// Makes an environment; installs Python through apt-get where it is missing and this user may.
pub fn make(folder: &Path) -> Result<PathBuf, String> {
    if !makes(folder) {
        install()?;
        if !makes(folder) {
            return Err(
                "python3 -m venv does not work here: install python3 and python3-venv".to_owned()
            );
        }
    }
    Ok(folder.join("bin/python"))
}

fn makes(folder: &Path) -> bool {
    let done = Command::new("python3").args(["-m", "venv"]).arg(folder).output();
    done.is_ok_and(|o| o.status.success()) && folder.join("bin/python").exists()
}

fn install() -> Result<(), String> {
    let install = "apt-get install -y --no-install-recommends python3 python3-venv";
    let hint = format!("python3 with venv is missing; `{install}` (as root) would install it");
    println!("{hint}");
    // -n: never wait for a password.
    let script = format!(
        "if [ $(id -u) = 0 ]; then S=; else S='sudo -n'; fi; $S apt-get update -qq && $S {install}"
    );
    let done = Command::new("sh").args(["-c", &script]).status();
    if done.is_ok_and(|s| s.success()) { Ok(()) } else { Err(hint) }
}
