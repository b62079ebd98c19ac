//! The frames of a short run must open in the real VTK, the library under ParaView, and the script for ParaView must
//! name what they have.
//!
//! VTK comes from PyPI into `target/venv`, pinned; Python from the system, through apt-get where it
//! is missing and this user may install it. Where neither works (no network, no rights) the step is
//! skipped with the reason; `RIPRAP_REQUIRE_VTK=1` makes that a failure.

use std::path::{Path, PathBuf};
use std::process::Command;

use crate::shell;
use crate::steps::Outcome;
use crate::venv;
use crate::verify::ci_binary;

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
    let mut run = Command::new(ci_binary(root)?);
    run.args(["run", SCENE, "--quiet", "--force", "--out"]).arg(&out);
    // Checks of the scene that fail are the business of the step `scenes`.
    if !shell::run(root, &mut run)?.success && !out.join("checks.jsonl").exists() {
        return Err(format!("{SCENE} did not run"));
    }
    let mut script = Command::new(ci_binary(root)?);
    script.arg("paraview").arg(&out);
    if !shell::run(root, &mut script)?.success {
        return Err("riprap paraview wrote no script".to_owned());
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
    let python = venv::python(root)?;
    if imports_vtk(&python) {
        return Ok(python);
    }
    println!("installing {VTK} into target/venv");
    // --no-deps: VTK asks for matplotlib, which reading files does not need.
    let words =
        ["-m", "pip", "install", "--quiet", "--disable-pip-version-check", "--no-deps", VTK];
    let done = Command::new(&python).args(words).status();
    if done.is_ok_and(|s| s.success()) && imports_vtk(&python) {
        Ok(python)
    } else {
        Err(format!("pip could not install {VTK} (network? Python version?)"))
    }
}

fn imports_vtk(python: &Path) -> bool {
    let words = ["-c", "import vtkmodules.vtkIOXML"];
    Command::new(python).args(words).output().is_ok_and(|o| o.status.success())
}
