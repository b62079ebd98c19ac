//! What a page of a release offers: programs for several systems, the wheel, licences, a container file and checksums.
//!
//! Programs are built on Linux, for other systems with zig as the linker. macOS is not among them: its program needs the frameworks of
//! Apple's SDK, which zig does not bring and nobody else may pass on; `.github/workflows/release.yml` builds it on a Mac.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use serde_json::Value;
use sha2::{Digest, Sha256};

use crate::{python, shell, venv};

/// Linux without a C library, for two processors, and Windows.
const TARGETS: [&str; 3] =
    ["x86_64-unknown-linux-musl", "aarch64-unknown-linux-musl", "x86_64-pc-windows-gnu"];
/// Lets cargo link with zig, as a Python wheel.
const ZIGBUILD: &str = "cargo-zigbuild==0.24.1";
const PROGRAM: &str = "riprap-cli";

/// `cargo xtask release [TARGET]... [--profile P] [--no-wheel]`: fills `target/packages`.
pub fn run(root: &Path, words: &[&str]) -> Result<bool, String> {
    let mut words = words.to_vec();
    let profile = shell::option(&mut words, "--profile")?.unwrap_or("release");
    let with_wheel = !words.contains(&"--no-wheel");
    words.retain(|word| *word != "--no-wheel");
    let targets = if words.is_empty() { TARGETS.to_vec() } else { words };
    if !cfg!(target_os = "linux") {
        return Err("a release is built on Linux".to_owned());
    }
    let tools = venv::python(root)?;
    python::pip(&tools, &[python::ZIG, ZIGBUILD])?;
    let out = root.join("target/packages");
    let _ = std::fs::remove_dir_all(&out);
    made(&out)?;
    let mut files = Vec::new();
    for target in &targets {
        let binary = built(root, &tools, target, profile)?;
        files.push(packed(root, &tools, &out, target, &binary)?);
    }
    if with_wheel {
        let wheel = python::portable(root)?;
        let name = wheel.file_name().ok_or("the wheel has no name")?;
        let to = out.join(name);
        copied(&wheel, &to)?;
        files.push(to);
    }
    if targets.contains(&TARGETS[0]) {
        let to = out.join("Containerfile");
        let folder = folder_of(TARGETS[0]);
        let text = format!(
            "# podman build -t riprap . && podman run --rm -v \"$PWD:/work\" riprap run hill.toml\nFROM scratch\nADD {folder}.tar.gz /\nWORKDIR /work\nENTRYPOINT [\"/{folder}/riprap\"]\n"
        );
        written(&to, &text)?;
        files.push(to);
    }
    written(&out.join("SHA256SUMS"), &sums(&files)?)?;
    for file in &files {
        println!("{}", file.display());
    }
    println!("{}", out.join("SHA256SUMS").display());
    Ok(true)
}

fn folder_of(target: &str) -> String {
    format!("riprap-{}-{target}", env!("CARGO_PKG_VERSION"))
}

/// Builds the program for a target; its path.
fn built(root: &Path, tools: &Path, target: &str, profile: &str) -> Result<PathBuf, String> {
    let mut add = Command::new("rustup");
    if !shell::run(root, add.args(["target", "add", target]))?.success {
        return Err(format!("rustup has no standard library for {target} (network?)"));
    }
    let path = std::env::var_os("PATH").unwrap_or_default();
    let beside = tools.parent().map(Path::to_owned);
    let path = std::env::join_paths(beside.into_iter().chain(std::env::split_paths(&path)))
        .map_err(|e| e.to_string())?;
    // A folder of its own: another linker would build everything anew in that of the tests.
    let folder = root.join("target/cross");
    let mut build = Command::new(shell::cargo());
    build
        .args(["zigbuild", "--locked", "--package", PROGRAM, "--profile", profile])
        .args(["--target", target])
        .env("PATH", path)
        .env("CARGO_TARGET_DIR", &folder);
    let done = shell::run(root, &mut build)?;
    // zig leaves it where it is called.
    let _ = std::fs::remove_file(root.join(".intentionally-empty-file.o"));
    if !done.success {
        return Err(format!("the program could not be built for {target}"));
    }
    let name = if target.contains("windows") { "riprap.exe" } else { "riprap" };
    let of = if profile == "dev" { "debug" } else { profile };
    Ok(folder.join(target).join(of).join(name))
}

/// Packs the program with its licences: a tar, for Windows a zip.
fn packed(
    root: &Path,
    tools: &Path,
    out: &Path,
    target: &str,
    binary: &Path,
) -> Result<PathBuf, String> {
    let folder = out.join(folder_of(target));
    made(&folder)?;
    let name = binary.file_name().ok_or("the program has no name")?;
    copied(binary, &folder.join(name))?;
    for file in ["README.md", "CHANGELOG.md", "LICENSE-APACHE", "LICENSE-MIT"] {
        copied(&root.join(file), &folder.join(file))?;
    }
    written(&folder.join("LICENSES-OF-LIBRARIES.txt"), &licences(root, target)?)?;
    let format = if target.contains("windows") { "zip" } else { "gztar" };
    let script = "import shutil, sys; print(shutil.make_archive(sys.argv[1], sys.argv[2], sys.argv[3], sys.argv[4]))";
    let output = Command::new(tools)
        .args(["-c", script])
        .arg(&folder)
        .arg(format)
        .arg(out)
        .arg(folder_of(target))
        .output()
        .map_err(|e| format!("python: {e}"))?;
    if !output.status.success() {
        return Err(String::from_utf8_lossy(&output.stderr).into_owned());
    }
    std::fs::remove_dir_all(&folder).map_err(|e| format!("{}: {e}", folder.display()))?;
    Ok(PathBuf::from(String::from_utf8_lossy(&output.stdout).trim()))
}

/// Names, versions and licences of all crates in the program, with the texts that they bring, each text once.
fn licences(root: &Path, target: &str) -> Result<String, String> {
    let output = Command::new(shell::cargo())
        .args(["metadata", "--format-version", "1", "--locked", "--filter-platform", target])
        .current_dir(root)
        .stderr(Stdio::inherit())
        .output()
        .map_err(|e| format!("cargo metadata: {e}"))?;
    let tree: Value =
        serde_json::from_slice(&output.stdout).map_err(|e| format!("cargo metadata: {e}"))?;
    let mut list = String::from(
        "The program contains these libraries. The texts of their licences follow, each once. The page of `riprap view` contains three.js,\nuPlot, fflate, mp4-muxer (MIT) and d3-scale-chromatic (ISC); their notices are in the page.\n\n",
    );
    let mut texts: BTreeMap<String, Vec<String>> = BTreeMap::new();
    for package in linked(&tree)? {
        let said = |key: &str| package[key].as_str().unwrap_or("");
        let title = format!("{} {}", said("name"), said("version"));
        let _ = writeln!(list, "{title}: {}", said("license"));
        let Some(folder) = Path::new(said("manifest_path")).parent() else { continue };
        for text in texts_in(folder)? {
            texts.entry(text).or_default().push(title.clone());
        }
    }
    for (text, of) in texts {
        let _ = write!(list, "\n{}\n{}\n\n{}\n", "-".repeat(80), of.join(", "), text.trim_end());
    }
    Ok(list)
}

/// Crates that are linked into the program, in the order of their names; ours are not among them.
fn linked(tree: &Value) -> Result<Vec<&Value>, String> {
    let all = |of: &'static str, list: &'static str| tree[of][list].as_array();
    let packages = tree["packages"].as_array().ok_or("cargo metadata lists no packages")?;
    let nodes = all("resolve", "nodes").ok_or("cargo metadata resolves nothing")?;
    let nodes: BTreeMap<&str, &Value> =
        nodes.iter().filter_map(|node| Some((node["id"].as_str()?, node))).collect();
    let program = packages.iter().find(|p| p["name"] == PROGRAM).ok_or("no riprap-cli")?;
    let mut waiting: Vec<&str> = program["id"].as_str().into_iter().collect();
    let mut seen = BTreeSet::new();
    while let Some(id) = waiting.pop() {
        if !seen.insert(id) {
            continue;
        }
        for dependency in nodes.get(id).into_iter().flat_map(|n| n["deps"].as_array()).flatten() {
            let kinds = dependency["dep_kinds"].as_array();
            let normal = kinds.into_iter().flatten().any(|kind| kind["kind"].is_null());
            waiting.extend(dependency["pkg"].as_str().filter(|_| normal));
        }
    }
    let theirs = packages.iter().filter(|p| !p["source"].is_null());
    let mut found: Vec<&Value> =
        theirs.filter(|p| p["id"].as_str().is_some_and(|id| seen.contains(id))).collect();
    found.sort_by_key(|p| (p["name"].to_string(), p["version"].to_string()));
    Ok(found)
}

/// The texts of licences in the folder of a crate.
fn texts_in(folder: &Path) -> Result<Vec<String>, String> {
    let entries = std::fs::read_dir(folder).map_err(|e| format!("{}: {e}", folder.display()))?;
    let mut paths: Vec<PathBuf> = entries.filter_map(|e| Some(e.ok()?.path())).collect();
    paths.sort();
    let is_licence = |path: &PathBuf| {
        let name = path.file_name().map(|n| n.to_string_lossy().to_uppercase()).unwrap_or_default();
        let begins =
            ["LICEN", "COPYING", "NOTICE", "COPYRIGHT"].iter().any(|w| name.starts_with(w));
        begins && path.is_file()
    };
    Ok(paths
        .iter()
        .filter(|p| is_licence(p))
        .filter_map(|p| std::fs::read_to_string(p).ok())
        .collect())
}

/// Lines that `sha256sum --check` reads.
fn sums(files: &[PathBuf]) -> Result<String, String> {
    let mut out = String::new();
    for file in files {
        let bytes = std::fs::read(file).map_err(|e| format!("{}: {e}", file.display()))?;
        let sum = Sha256::digest(&bytes).iter().fold(String::new(), |mut text, byte| {
            let _ = write!(text, "{byte:02x}");
            text
        });
        let name = file.file_name().unwrap_or_default().to_string_lossy();
        let _ = writeln!(out, "{sum}  {name}");
    }
    Ok(out)
}

fn made(folder: &Path) -> Result<(), String> {
    std::fs::create_dir_all(folder).map_err(|e| format!("{}: {e}", folder.display()))
}

fn copied(from: &Path, to: &Path) -> Result<(), String> {
    let done = std::fs::copy(from, to);
    done.map(|_| ()).map_err(|e| format!("{} to {}: {e}", from.display(), to.display()))
}

fn written(path: &Path, text: &str) -> Result<(), String> {
    std::fs::write(path, text).map_err(|e| format!("{}: {e}", path.display()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::source_tree;

    #[test]
    fn the_libraries_of_the_program_have_their_licences() {
        let text = licences(&source_tree::root(), TARGETS[0]).unwrap();
        for library in ["clap ", "resvg ", "rayon "] {
            assert!(text.lines().any(|line| line.starts_with(library)), "{library}");
        }
        // What only tests need is not in the program.
        assert!(!text.lines().any(|line| line.starts_with("proptest ")));
        assert!(text.contains("Permission is hereby granted"));
    }

    #[test]
    fn sums_are_those_of_sha256sum() {
        let file = std::env::temp_dir().join(format!("riprap-sums-{}", std::process::id()));
        std::fs::write(&file, "abc").unwrap();
        let line = sums(std::slice::from_ref(&file)).unwrap();
        std::fs::remove_file(&file).unwrap();
        assert!(
            line.starts_with("ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad  ")
        );
    }
}
