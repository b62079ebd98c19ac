//! The frames of a short run must open in the real VTK, the library under ParaView.
//!
//! VTK comes from PyPI into `target/venv`, pinned; Python from the system, through apt-get where it
//! is missing and this user may install it. Where neither works (no network, no rights) the step is
//! skipped with the reason; `RIPRAP_REQUIRE_VTK=1` makes that a failure.

use std::path::{Path, PathBuf};
use std::process::Command;

use crate::shell;
use crate::steps::Outcome;
use crate::verify::release_binary;

const VTK: &str = "vtk==9.7.2";
/// The scene whose frames are read: the one the README runs.
const SCENE: &str = "scenes/planar/topple.toml";

/// The `vtk` step of `cargo xtask test`.
pub fn step(root: &Path) -> Result<Outcome, String> {
    if !root.join(SCENE).exists() {
        return Ok(Outcome::Skipped(format!("{SCENE} does not exist yet")));
    }
    let python = match python_with_vtk(root) {
        Ok(python) => python,
        Err(why) if std::env::var_os("RIPRAP_REQUIRE_VTK").is_some() => return Err(why),
        Err(why) => return Ok(Outcome::Skipped(why)),
    };
    let out = root.join("target/xtask/vtk.run");
    let mut run = Command::new(release_binary(root)?);
    run.args(["run", SCENE, "--quiet", "--force", "--out"])
        .arg(&out);
    // Checks of the scene that fail are the business of the step `scenes`.
    if !shell::run(root, &mut run)?.success && !out.join("checks.jsonl").exists() {
        return Err(format!("{SCENE} did not run"));
    }
    let mut check = Command::new(python);
    check.arg(root.join("tests/python/check_vtk.py")).arg(&out);
    let done = shell::run(root, &mut check)?;
    if !done.success && done.counts.failed == 0 {
        return Err("the VTK check did not finish".to_owned());
    }
    Ok(Outcome::Counted(done.counts))
}

/// The Python of `target/venv`, made and filled when needed.
fn python_with_vtk(root: &Path) -> Result<PathBuf, String> {
    let venv = root.join("target/venv");
    let python = venv.join("bin/python");
    if imports_vtk(&python) {
        return Ok(python);
    }
    if !makes_venv(&venv) {
        install_python()?;
        if !makes_venv(&venv) {
            return Err(
                "python3 -m venv does not work here: install python3 and python3-venv".to_owned(),
            );
        }
    }
    println!("installing {VTK} into {}", venv.display());
    // --no-deps: VTK asks for matplotlib, which reading files does not need.
    let words = [
        "-m",
        "pip",
        "install",
        "--quiet",
        "--disable-pip-version-check",
        "--no-deps",
        VTK,
    ];
    let done = Command::new(&python).args(words).status();
    if done.is_ok_and(|s| s.success()) && imports_vtk(&python) {
        Ok(python)
    } else {
        Err(format!(
            "pip could not install {VTK} (network? Python version?)"
        ))
    }
}

fn imports_vtk(python: &Path) -> bool {
    let words = ["-c", "import vtkmodules.vtkIOXML"];
    Command::new(python)
        .args(words)
        .output()
        .is_ok_and(|o| o.status.success())
}

fn makes_venv(venv: &Path) -> bool {
    let done = Command::new("python3")
        .args(["-m", "venv"])
        .arg(venv)
        .output();
    done.is_ok_and(|o| o.status.success()) && venv.join("bin/python").exists()
}

fn install_python() -> Result<(), String> {
    let install = "apt-get install -y --no-install-recommends python3 python3-venv";
    let hint = format!("python3 with venv is missing; `{install}` (as root) would install it");
    println!("{hint}");
    // -n: never wait for a password.
    let script = format!(
        "if [ $(id -u) = 0 ]; then S=; else S='sudo -n'; fi; $S apt-get update -qq && $S {install}"
    );
    let done = Command::new("sh").args(["-c", &script]).status();
    if done.is_ok_and(|s| s.success()) {
        Ok(())
    } else {
        Err(hint)
    }
}
