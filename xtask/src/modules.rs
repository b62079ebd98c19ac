//! Crates and modules: which crate may use which, circles of modules in a crate, and words that may not stand in its code.
//!
//! That a crate uses only what its `Cargo.toml` names is kept by the compiler; [`ARROWS`] keeps the `Cargo.toml`s. Circles
//! inside a crate and the words of [`FORBIDDEN`] are found by parsing every file with `syn`; what compiles in tests only is
//! left out by its attribute, wherever it stands.

mod floors;
mod graph;
mod source;

use std::path::{Path, PathBuf};

use crate::source_tree::shown;
use source::{Crate, Words};

/// Crate of the library, the crates of the library it may use, and why not more.
const ARROWS: [(&str, &[&str], &str); 12] = [
    ("riprap-keys-derive", &[], "a macro sees the struct it stands at and nothing else"),
    (
        "riprap-keys",
        &["riprap-keys-derive"],
        "what a word is does not depend on which words there are",
    ),
    ("riprap-geom", &[], "geometry knows no mechanics"),
    (
        "riprap-core",
        &["riprap-geom", "riprap-keys"],
        "laws and services know no engine, no file and no scenario",
    ),
    (
        "riprap-planar",
        &["riprap-core", "riprap-geom"],
        "an engine knows neither files nor scenarios nor the other engine",
    ),
    (
        "riprap-spatial",
        &["riprap-core", "riprap-geom"],
        "an engine knows neither files nor scenarios nor the other engine",
    ),
    (
        "riprap-scenario",
        &["riprap-core", "riprap-geom", "riprap-keys"],
        "the scenario is what the user said; it knows no engine",
    ),
    ("riprap-record", &["riprap-core"], "records are plain tables, never the inside of an engine"),
    (
        "riprap-plot",
        &["riprap-record", "riprap-core", "riprap-geom", "riprap-keys"],
        "figures are drawn from a run folder alone",
    ),
    (
        "riprap-view",
        &["riprap-record", "riprap-core", "riprap-geom"],
        "the viewer reads the run folder and nothing else",
    ),
    ("riprap-testkit", &["riprap-core"], "samples for tests of all"),
    ("riprap-fuzz", &["riprap"], "targets go in by the doors that everybody has"),
];

/// Crates in which the order of every sum matters.
const ENGINES: &[&str] = &["riprap-geom", "riprap-core", "riprap-planar", "riprap-spatial"];

/// The one file that names the thread pool.
const POOL: &str = "crates/riprap-core/src/exec.rs";
/// Why.
const ONE_POOL: &str = "only exec.rs names threads";

/// End of a path, crates in which it is forbidden (empty: all of the library), and why. What clippy can know stands in
/// `clippy.toml`; here it is also found in macros.
const FORBIDDEN: [(&[&str], &[&str], &str); 10] = [
    (&["mul_add"], &[], "rounds differently on machines with and without the instruction"),
    (&["HashMap"], ENGINES, "its order differs from run to run"),
    (&["HashSet"], ENGINES, "its order differs from run to run"),
    (&["rayon"], &[], ONE_POOL),
    (&["thread", "spawn"], ENGINES, ONE_POOL),
    (&["thread", "scope"], ENGINES, ONE_POOL),
    (&["thread", "Builder"], ENGINES, ONE_POOL),
    (&["AtomicF32"], &[], "sums of atomic floats depend on the threads"),
    (&["AtomicF64"], &[], "sums of atomic floats depend on the threads"),
    (&["thread_rng"], &[], "every random number comes from a seed in the scene"),
];

/// Largest circle of modules that a crate may have.
const LARGEST_CIRCLE: usize = 5;
/// Crates whose circle is larger still, with its present size: it may shrink, not grow.
const NOT_YET: [(&str, usize); 0] = [];

/// Prints every breach and the largest circle of each crate; returns how many breaches there are.
pub fn check(root: &Path) -> Result<u64, String> {
    let mut breaches = 0;
    let mut count = 0;
    for folder in crates(root)? {
        let name = folder.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let manifest = std::fs::read_to_string(folder.join("Cargo.toml"))
            .map_err(|e| format!("{}/Cargo.toml: {e}", folder.display()))?;
        for message in forbidden_arrows(&name, &manifest) {
            println!("crates/{name}/Cargo.toml: {message}");
            breaches += 1;
        }
        for file in ["src/lib.rs", "src/main.rs"] {
            let file = folder.join(file);
            if !file.exists() {
                continue;
            }
            let modules = source::read(&file)?;
            count += modules.len();
            for (at, message) in forbidden_words(root, &name, &modules) {
                println!("{at}: {message}");
                breaches += 1;
            }
            breaches += too_large(&name, &modules);
            breaches += floors::check(root, &folder, &name, &modules)?;
        }
    }
    println!("{count} modules, {breaches} breaches");
    Ok(breaches)
}

/// `cargo xtask arrows CRATE [rooms]`: prints each module, or room, with those it uses.
pub fn print_arrows(root: &Path, name: &str, rooms: bool) -> Result<(), String> {
    for file in ["src/lib.rs", "src/main.rs"] {
        let file = root.join("crates").join(name).join(file);
        if !file.exists() {
            continue;
        }
        let modules = source::read(&file)?;
        if rooms {
            floors::print(root, &modules);
            return Ok(());
        }
        for (module, to) in graph::graph(&modules) {
            let to: Vec<String> = to.iter().map(|w| w.join("::")).collect();
            println!("{} -> {}", module.join("::"), to.join(" "));
        }
        return Ok(());
    }
    Err(format!("there is no crate crates/{name}"))
}

/// Folders of the crates of the library, sorted.
fn crates(root: &Path) -> Result<Vec<PathBuf>, String> {
    let folder = root.join("crates");
    let failed = |e: std::io::Error| format!("{}: {e}", folder.display());
    let mut found = Vec::new();
    for entry in std::fs::read_dir(&folder).map_err(failed)? {
        let path = entry.map_err(failed)?.path();
        if path.join("Cargo.toml").exists() {
            found.push(path);
        }
    }
    if found.is_empty() {
        return Err(format!("no crates under {}", folder.display()));
    }
    found.sort();
    Ok(found)
}

/// Crates of the library that the manifest of `name` names among its dependencies and may not.
fn forbidden_arrows(name: &str, manifest: &str) -> Vec<String> {
    let Some((_, allowed, why)) = ARROWS.iter().find(|(n, ..)| *n == name) else {
        return Vec::new();
    };
    let mut inside = false;
    let mut found = Vec::new();
    for line in manifest.lines().map(str::trim) {
        if line.starts_with('[') {
            // Tests may use what they like.
            inside = line.ends_with("dependencies]") && !line.contains("dev-dependencies");
        } else if inside && line.starts_with("riprap") {
            let used = line.split(['.', ' ', '=']).next().unwrap_or(line);
            if !allowed.contains(&used) {
                found.push(format!("`{name}` may not use `{used}`: {why}"));
            }
        }
    }
    found
}

/// File and message for each forbidden word.
fn forbidden_words(root: &Path, name: &str, modules: &Crate) -> Vec<(String, String)> {
    let mut found = Vec::new();
    for module in modules.values() {
        let file = shown(root, &module.file);
        let imports = module.imports.iter().map(|i| &i.from);
        let all: Vec<&Words> = module.mentions.keys().chain(imports).collect();
        for (word, places, why) in FORBIDDEN {
            let here = places.is_empty() || places.contains(&name);
            if !here || (why == ONE_POOL && file == POOL) {
                continue;
            }
            let there = |w: &&&Words| w.windows(word.len()).any(|part| part == word);
            if all.iter().any(|w| there(&w)) {
                found.push((
                    file.clone(),
                    format!("`{}` is not allowed here: {why}", word.join("::")),
                ));
            }
        }
    }
    found
}

/// Prints the largest circle of a crate; 1 if it is larger than allowed.
fn too_large(name: &str, modules: &Crate) -> u64 {
    let circles = graph::circles(&graph::graph(modules));
    let Some(largest) = circles.first() else {
        return 0;
    };
    let bound = NOT_YET.iter().find(|(n, _)| *n == name).map_or(LARGEST_CIRCLE, |(_, size)| *size);
    let sizes: Vec<String> = circles.iter().map(|c| c.len().to_string()).collect();
    println!("{name}: {} modules, circles of {} (bound {bound})", modules.len(), sizes.join(", "));
    if largest.len() <= bound {
        return 0;
    }
    let members: Vec<String> = largest.iter().map(|m| m.join("::")).collect();
    println!(
        "{name}: {} modules use each other in a circle, at most {bound} may: {}",
        largest.len(),
        members.join(" ")
    );
    1
}

#[cfg(test)]
mod tests;
