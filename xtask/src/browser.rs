//! The viewer in a real browser: Playwright drives the distribution's Chromium over real runs.
//!
//! Node, npm and Chromium come through apt-get where they are missing and this user may install them; Playwright and
//! the tools that check and bundle the page come from npm, pinned by `viewer/package-lock.json`. What cannot be had fails
//! the step: `RIPRAP_SKIP_BROWSER=1` leaves it out and says so.

use std::path::Path;
use std::process::Command;

use crate::shell;
use crate::steps::Outcome;
use crate::verify::release_binary;

/// Oldest version of Node that will do.
const NODE: u32 = 20;
/// Programs, one of which must be there, and the package that brings them.
const PROGRAMS: [(&[&str], &str); 3] = [
    (&["node"], "nodejs"),
    (&["npm"], "npm"),
    (
        &["chromium", "chromium-browser", "google-chrome"],
        "chromium",
    ),
];

/// The `browser` step of `cargo xtask test`.
pub fn step(root: &Path) -> Result<Outcome, String> {
    if std::env::var_os("RIPRAP_SKIP_BROWSER").is_some_and(|v| v == "1") {
        return Ok(Outcome::Skipped("RIPRAP_SKIP_BROWSER=1".to_owned()));
    }
    programs()?;
    new_enough()?;
    let viewer = root.join("viewer");
    packages(&viewer)?;
    npm(
        &viewer,
        &["run", "check"],
        "the page has mistakes (npm run check)",
    )?;
    same_bundle(root, &viewer)?;
    let binary = root.join(release_binary(root)?);
    let mut command = Command::new("npx");
    command
        .args(["--no-install", "playwright", "test"])
        .env("RIPRAP_BIN", binary);
    let done = shell::run(&viewer, &mut command)?;
    if !done.success && done.counts.failed == 0 {
        return Err("the browser tests did not finish".to_owned());
    }
    println!("pictures to look at: target/xtask/browser/pictures");
    Ok(Outcome::Counted(done.counts))
}

fn there(program: &str) -> bool {
    let done = Command::new(program).arg("--version").output();
    done.is_ok_and(|o| o.status.success())
}

fn programs() -> Result<(), String> {
    let missing: Vec<&str> = PROGRAMS
        .iter()
        .filter(|(names, _)| !names.iter().any(|n| there(n)))
        .map(|(_, package)| *package)
        .collect();
    if missing.is_empty() {
        return Ok(());
    }
    let install = format!(
        "apt-get install -y --no-install-recommends {}",
        missing.join(" ")
    );
    println!("{} missing; trying: {install}", missing.join(", "));
    // -n: never wait for a password.
    let script = format!(
        "if [ $(id -u) = 0 ]; then S=; else S='sudo -n'; fi; $S apt-get update -qq && $S {install}"
    );
    let done = Command::new("sh").args(["-c", &script]).status();
    if done.is_ok_and(|s| s.success()) {
        Ok(())
    } else {
        Err(format!(
            "{} missing and apt-get could not bring it (network? rights?); install it by hand: {install}",
            missing.join(", ")
        ))
    }
}

/// Old distributions bring a Node that the tools of the page do not run on.
fn new_enough() -> Result<(), String> {
    let said = Command::new("node").arg("--version").output();
    let said = said.map_err(|e| format!("node could not be started: {e}"))?;
    let version = String::from_utf8_lossy(&said.stdout).trim().to_owned();
    let digits = version.trim_start_matches('v').split('.').next();
    match digits.and_then(|d| d.parse::<u32>().ok()) {
        Some(major) if major >= NODE => Ok(()),
        Some(_) | None => Err(format!(
            "node is {version}, but the tools of viewer/ need {NODE} or newer: install it from https://nodejs.org"
        )),
    }
}

/// Fills `viewer/node_modules` when it does not match the lock file.
fn packages(viewer: &Path) -> Result<(), String> {
    let read = |name: &str| std::fs::read(viewer.join(name));
    let stamp = viewer.join("node_modules/.riprap-lock");
    let lock = read("package-lock.json").map_err(|e| format!("viewer/package-lock.json: {e}"))?;
    if std::fs::read(&stamp).is_ok_and(|installed| installed == lock) {
        return Ok(());
    }
    let words = ["ci", "--no-audit", "--no-fund", "--loglevel=error"];
    npm(
        viewer,
        &words,
        "npm could not install the packages of viewer/package-lock.json (network?)",
    )?;
    std::fs::write(&stamp, lock).map_err(|e| format!("{}: {e}", stamp.display()))
}

/// The committed bundle must be, byte for byte, what its sources give.
fn same_bundle(root: &Path, viewer: &Path) -> Result<(), String> {
    let assets = root.join("crates/riprap-view/assets");
    let files = ["app.js", "app.css", "index.html", "sources.sha256"];
    let read = || -> Result<Vec<Vec<u8>>, String> {
        let one =
            |name: &&str| std::fs::read(assets.join(name)).map_err(|e| format!("{name}: {e}"));
        files.iter().map(one).collect()
    };
    let committed = read()?;
    npm(
        viewer,
        &["run", "build"],
        "the page cannot be bundled (npm run build)",
    )?;
    if read()? == committed {
        Ok(())
    } else {
        Err("crates/riprap-view/assets was not built from viewer/: commit what npm run build has just written there".to_owned())
    }
}

fn npm(viewer: &Path, words: &[&str], what: &str) -> Result<(), String> {
    let mut command = Command::new("npm");
    // Playwright brings no browser of its own.
    command
        .args(words)
        .env("PLAYWRIGHT_SKIP_BROWSER_DOWNLOAD", "1");
    if shell::run(viewer, &mut command)?.success {
        Ok(())
    } else {
        Err(what.to_owned())
    }
}
