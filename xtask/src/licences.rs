//! Every crate of the dependency tree must have a licence that `deny.toml` allows.
//!
//! `cargo deny check` does more (advisories, sources) and runs instead where it is installed: compiling it takes longer than all steps
//! of CI have.

use std::path::Path;
use std::process::{Command, Stdio};

use spdx::{Expression, Licensee, ParseMode};

use crate::shell;

/// Prints the crates of the workspace and of the guided fuzz targets whose licence is not allowed; returns how many there are.
pub fn check(root: &Path) -> Result<u64, String> {
    let deny = Command::new(shell::cargo()).args(["deny", "--version"]).output();
    if deny.is_ok_and(|o| o.status.success()) {
        let mut command = Command::new(shell::cargo());
        command.args(["deny", "check", "licenses", "bans", "sources"]);
        return Ok(u64::from(!shell::run(root, &mut command)?.success));
    }
    let allowed = allowed_licences(root)?;
    Ok(refused(root, &allowed)? + refused(&root.join("fuzz"), &allowed)?)
}

/// Crates of the workspace in `folder` with another licence, by what cargo has at hand.
fn refused(folder: &Path, allowed: &[Licensee]) -> Result<u64, String> {
    let output = Command::new(shell::cargo())
        .args(["metadata", "--format-version", "1", "--locked", "--filter-platform", &host()?])
        .current_dir(folder)
        .stderr(Stdio::inherit())
        .output()
        .map_err(|e| format!("cargo metadata: {e}"))?;
    let tree: serde_json::Value =
        serde_json::from_slice(&output.stdout).map_err(|e| format!("cargo metadata: {e}"))?;
    let packages = tree["packages"].as_array().ok_or("cargo metadata lists no packages")?;
    let mut refused = 0;
    for package in packages {
        let licence = package["license"].as_str().unwrap_or("");
        if !is_allowed(licence, allowed) {
            println!("{} {}: licence {licence:?}", package["name"], package["version"]);
            refused += 1;
        }
    }
    println!("{} crates, {refused} with a licence outside deny.toml", packages.len());
    Ok(refused)
}

/// The machine for which the compiler compiles.
fn host() -> Result<String, String> {
    let output = Command::new("rustc").arg("-vV").output().map_err(|e| format!("rustc: {e}"))?;
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    let host = text.lines().find_map(|l| l.strip_prefix("host: "));
    host.map(str::to_owned).ok_or_else(|| "rustc -vV names no host".to_owned())
}

/// The strings of `allow = [...]` under `[licenses]` in `deny.toml`.
fn allowed_licences(root: &Path) -> Result<Vec<Licensee>, String> {
    let text =
        std::fs::read_to_string(root.join("deny.toml")).map_err(|e| format!("deny.toml: {e}"))?;
    let list = text.split("allow = [").nth(1).and_then(|rest| rest.split(']').next());
    let list = list.ok_or("deny.toml has no `allow = [` list")?;
    let parse = |name| Licensee::parse(name).map_err(|e| format!("deny.toml: {name}: {e}"));
    list.split('"').skip(1).step_by(2).map(parse).collect()
}

/// Whether an SPDX expression (`/` read as OR) can be met with `allowed` licences alone.
fn is_allowed(expression: &str, allowed: &[Licensee]) -> bool {
    Expression::parse_mode(expression, ParseMode::LAX)
        .is_ok_and(|all| all.evaluate(|one| allowed.iter().any(|licence| licence.satisfies(one))))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn spdx_expressions() {
        let allowed = ["MIT", "Apache-2.0 WITH LLVM-exception", "Unicode-3.0"]
            .map(|name| Licensee::parse(name).unwrap());
        for good in
            ["MIT", "MIT/Apache-2.0", "GPL-3.0 OR MIT", "(MIT OR Apache-2.0) AND Unicode-3.0"]
        {
            assert!(is_allowed(good, &allowed), "{good}");
        }
        assert!(is_allowed("Apache-2.0 WITH LLVM-exception OR GPL-2.0", &allowed));
        for bad in ["", "GPL-3.0", "MIT AND GPL-3.0", "(MIT OR Apache-2.0) AND MPL-2.0"] {
            assert!(!is_allowed(bad, &allowed), "{bad}");
        }
    }

    #[test]
    fn the_list_is_read() {
        let allowed = allowed_licences(&crate::source_tree::root()).unwrap();
        assert!(is_allowed("MIT", &allowed) && !is_allowed("GPL-3.0", &allowed));
    }
}
