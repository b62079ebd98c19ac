//! The Python package: its wheel, built and tested.
//!
//! The wheel of the tests is built with the profile of the other tests in their target folder, so that nothing is compiled
//! twice. It is installed twice: alone into a fresh environment, where a small run must work, and
//! beside pandas and pyvista into `target/venv`, where pytest runs. Where no Python can be had the step is skipped
//! with the reason; `RIPRAP_REQUIRE_PYTHON=1` makes that a failure.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use crate::shell::{self, Counts};
use crate::steps::Outcome;
use crate::{venv, verify};

const CRATE: &str = "crates/riprap-py";
/// The C library that a portable wheel is linked against: that of every Linux of the last ten years.
const OLD_LINUX: &str = "manylinux_2_17";
/// The linker that knows old C libraries, as a Python wheel.
pub const ZIG: &str = "ziglang==0.17.1";

/// The `python` step of `cargo xtask test`.
pub fn step(root: &Path) -> Result<Outcome, String> {
    match tested(root) {
        Ok(outcome) => Ok(outcome),
        Err(Failed::NoPython(why)) if std::env::var_os("RIPRAP_REQUIRE_PYTHON").is_none() => {
            Ok(Outcome::Skipped(why))
        }
        Err(Failed::NoPython(why) | Failed::Broken(why)) => Err(why),
    }
}

/// `cargo xtask wheel`: a release wheel in `target/wheels`; a portable one runs on Linux with an old C library too.
pub fn wheel(root: &Path, portable: bool) -> Result<bool, String> {
    if portable && !cfg!(target_os = "linux") {
        return Err("a portable wheel is one for Linux: build it there".to_owned());
    }
    let wheel = if portable { self::portable(root)? } else { made(root, How::Release)? };
    println!("pip install {}", wheel.display());
    Ok(true)
}

/// A release wheel that runs on Linux with an old C library too.
pub fn portable(root: &Path) -> Result<PathBuf, String> {
    made(root, How::Portable)
}

fn made(root: &Path, how: How) -> Result<PathBuf, String> {
    let python = tools(root).map_err(Failed::text)?;
    if matches!(how, How::Portable) {
        pip(&python, &[ZIG])?;
    }
    build(root, &python, &root.join("target/wheels"), how).map_err(Failed::text)
}

/// How a wheel is built.
#[derive(Clone, Copy)]
enum How {
    /// With the profile of the tests.
    Tests,
    /// For this machine.
    Release,
    /// For Linux with an old C library too.
    Portable,
}

enum Failed {
    /// The machine lacks Python or the network.
    NoPython(String),
    /// Something of ours.
    Broken(String),
}

impl Failed {
    fn text(self) -> String {
        match self {
            Failed::NoPython(why) | Failed::Broken(why) => why,
        }
    }
}

fn tested(root: &Path) -> Result<Outcome, Failed> {
    let twice = compiled_twice(root).map_err(Failed::Broken)?;
    if !twice.is_empty() {
        return Err(Failed::Broken(format!(
            "compiled twice, because the wheel alone wants other features than the workspace: {}; name the features in {CRATE}/Cargo.toml",
            twice.join(", ")
        )));
    }
    let python = tools(root)?;
    let folder = root.join("target/python");
    let wheel = build(root, &python, &folder.join("wheels"), How::Tests)?;
    clean_install(root, &wheel, &folder.join("clean"))?;
    pip(&python, &["--no-deps", "--force-reinstall", &wheel.to_string_lossy()])
        .map_err(Failed::Broken)?;
    let tests = root.join(CRATE).join("tests");
    // An older binary would differ: the one of the other steps, built if need be.
    let binary = root.join(verify::ci_binary(root).map_err(Failed::Broken)?);
    // pytest's last line has no count of what did not happen: junit has all of them.
    let report = folder.join("report.xml");
    let mut pytest = Command::new(&python);
    pytest
        .env("RIPRAP_BINARY", binary)
        .args(["-m", "pytest", "-p", "no:cacheprovider", "--rootdir"])
        .arg(root.join(CRATE))
        .arg("-c")
        .arg(root.join(CRATE).join("pyproject.toml"))
        .arg(format!("--junit-xml={}", report.display()))
        .arg(tests);
    let done = shell::run(root, &mut pytest).map_err(Failed::Broken)?;
    let mut counts = std::fs::read_to_string(&report)
        .ok()
        .and_then(|text| read_junit(&text))
        .unwrap_or_default();
    if !done.success && counts.failed == 0 {
        counts.failed = 1;
    }
    // The clean installation.
    counts.passed += 1;
    Ok(Outcome::Counted(counts))
}

/// `target/venv` with what building and testing needs; pyvista and ezdxf are used where they can be had.
fn tools(root: &Path) -> Result<PathBuf, Failed> {
    let python = venv::python(root).map_err(Failed::NoPython)?;
    let list =
        |name: &str| root.join(CRATE).join("tests").join(name).to_string_lossy().into_owned();
    pip(&python, &["-r", &list("requirements.txt")]).map_err(|why| {
        Failed::NoPython(format!(
            "{why} (is there a network? Python 3.11 or newer is needed for the pinned versions)"
        ))
    })?;
    if let Err(why) = pip(&python, &["--no-deps", "-r", &list("requirements-tools.txt")]) {
        println!("{why}; the tests with pyvista and ezdxf are left out");
    }
    Ok(python)
}

pub fn pip(python: &Path, words: &[&str]) -> Result<(), String> {
    let mut command = Command::new(python);
    command.args(["-m", "pip", "install", "--quiet", "--disable-pip-version-check"]).args(words);
    match command.status() {
        Ok(status) if status.success() => Ok(()),
        Ok(_) | Err(_) => Err(format!("pip could not install {}", words.join(" "))),
    }
}

/// Dependencies of the wheel that the build of the whole workspace compiles with other features: each would be compiled twice, with
/// everything above it (five minutes for `rand` alone).
fn compiled_twice(root: &Path) -> Result<Vec<String>, String> {
    let listed = |of: &[&str]| -> Result<BTreeSet<String>, String> {
        let output = Command::new(shell::cargo())
            .args(["tree", "--locked", "--prefix", "none", "--no-dedupe"])
            .args(["--format", "{p} [{f}]"])
            .args(of)
            .current_dir(root)
            .stderr(Stdio::inherit())
            .output()
            .map_err(|e| format!("cargo tree: {e}"))?;
        if !output.status.success() {
            return Err("cargo tree failed".to_owned());
        }
        let text = String::from_utf8_lossy(&output.stdout);
        Ok(text.lines().map(str::to_owned).collect())
    };
    let workspace = listed(&["--workspace", "--edges", "normal,build,dev"])?;
    let wheel = listed(&["--package", "riprap-py", "--edges", "normal,build"])?;
    Ok(wheel.difference(&workspace).cloned().collect())
}

/// Builds the wheel into `out`, which holds nothing else afterwards.
fn build(root: &Path, python: &Path, out: &Path, how: How) -> Result<PathBuf, Failed> {
    let _ = std::fs::remove_dir_all(out);
    let mut maturin = Command::new(python);
    maturin
        .args(["-m", "maturin", "build", "--locked", "--manifest-path"])
        .arg(root.join(CRATE).join("Cargo.toml"))
        .arg("--interpreter")
        .arg(python)
        .arg("--out")
        .arg(out)
        .env("CARGO_TARGET_DIR", root.join("target"));
    if let (How::Portable, Some(tools)) = (how, python.parent()) {
        // zig is found as a module of the first Python on the path.
        let path = std::env::var_os("PATH").unwrap_or_default();
        let places = std::iter::once(tools.to_owned()).chain(std::env::split_paths(&path));
        let path = std::env::join_paths(places).map_err(|e| Failed::Broken(e.to_string()))?;
        maturin.env("PATH", path);
    }
    match how {
        How::Tests => maturin.args(["--profile", "ci"]),
        How::Release => maturin.args(["--release", "--strip"]),
        // maturin refuses a wheel that wants more of the system than its name says.
        How::Portable => {
            maturin.args(["--release", "--strip", "--zig", "--compatibility", OLD_LINUX])
        }
    };
    if !shell::run(root, &mut maturin).map_err(Failed::Broken)?.success {
        return Err(Failed::Broken("maturin could not build the wheel".to_owned()));
    }
    let wheels =
        std::fs::read_dir(out).map_err(|e| Failed::Broken(format!("{}: {e}", out.display())))?;
    wheels
        .filter_map(|entry| Some(entry.ok()?.path()))
        .find(|path| path.extension().is_some_and(|e| e == "whl"))
        .ok_or_else(|| Failed::Broken(format!("maturin left no wheel in {}", out.display())))
}

/// The wheel and its one dependency in a fresh environment: a small run must work without pandas and pyvista.
fn clean_install(root: &Path, wheel: &Path, folder: &Path) -> Result<(), Failed> {
    let _ = std::fs::remove_dir_all(folder);
    let python = venv::make(folder).map_err(Failed::NoPython)?;
    pip(&python, &[&wheel.to_string_lossy()]).map_err(Failed::Broken)?;
    let mut smoke = Command::new(&python);
    smoke.arg(root.join(CRATE).join("tests/smoke.py")).arg(folder.join("smoke.run"));
    let done = shell::run(root, &mut smoke).map_err(Failed::Broken)?;
    if done.success {
        Ok(())
    } else {
        Err(Failed::Broken("the wheel does not work in a fresh environment".to_owned()))
    }
}

/// Counts of `<testsuite tests= failures= errors= skipped=>`.
fn read_junit(text: &str) -> Option<Counts> {
    let suite = &text[text.find("<testsuite ")?..];
    let number = |name: &str| -> Option<u64> {
        let rest = &suite[suite.find(&format!(" {name}=\""))? + name.len() + 3..];
        rest[..rest.find('"')?].parse().ok()
    };
    let (failed, skipped) = (number("failures")? + number("errors")?, number("skipped")?);
    Some(Counts { passed: number("tests")?.saturating_sub(failed + skipped), failed, skipped })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn counts_are_read_from_pytest() {
        let text = r#"<testsuites><testsuite name="pytest" errors="1" failures="2" skipped="3" tests="10" time="1.5">"#;
        let expected = Counts { passed: 4, failed: 3, skipped: 3 };
        assert_eq!(read_junit(text), Some(expected));
        assert_eq!(read_junit("nothing"), None);
    }
}
