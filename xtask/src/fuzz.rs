//! `cargo xtask fuzz`: the targets of `riprap-fuzz`, guided by coverage.
//!
//! The package `fuzz/` is built with the toolchain of the repository: the instrumentation is LLVM's, stable compilers pass it on. It needs a C++ compiler for libFuzzer, which
//! nothing else here does. `cargo fuzz run TARGET` understands the same package, with a nightly compiler and sanitizers.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode, Stdio};
use std::{fs, io};

use riprap_fuzz::corpus;

use crate::{licences, shell, source_tree};

/// The package, a workspace of its own.
const PACKAGE: &str = "fuzz";
/// What is written, under the root: programs, inputs that reached new code, inputs that failed, what libFuzzer said.
const RESULTS: &str = "target/fuzz";
/// What cargo-fuzz asks of the compiler, sanitizers apart.
const INSTRUMENTED: &str = "-Cpasses=sancov-module -Cllvm-args=-sanitizer-coverage-level=4 -Cllvm-args=-sanitizer-coverage-inline-8bit-counters \
    -Cllvm-args=-sanitizer-coverage-pc-table -Cllvm-args=-sanitizer-coverage-trace-compares --cfg fuzzing -Ccodegen-units=4";
/// Address space of a target, KiB: twice what blind damage gets, for libFuzzer keeps its inputs in it.
const MEMORY: u64 = 1 << 20;
/// Longest time of one input, s (three times that of blind damage, for what is instrumented is slower), and longest input, bytes.
const LIMITS: [&str; 2] = ["-timeout=60", "-max_len=65536"];
/// Largest input that is committed, bytes, and longest time that it may take, ms.
const KEPT: (u64, u64) = (8 << 10, 300);
/// Most inputs of a target that are committed, and bytes of them.
const MOST: (usize, u64) = (40, 96 << 10);
/// Folders of scenes that take long.
const SLOW: [&str; 3] = ["long", "mid", "bench"];

/// What is asked.
struct Asked {
    targets: Vec<String>,
    seconds: u64,
    seed: u64,
    keep: bool,
}

/// What libFuzzer said of a target.
#[derive(Debug, Default, PartialEq, Eq)]
struct Said {
    inputs: u64,
    edges: u64,
    features: u64,
    kept: u64,
}

/// `cargo xtask fuzz [TARGET]... [--seconds N] [--seed K] [--keep]`.
pub fn run(root: &Path, words: &[&str]) -> ExitCode {
    match fuzz(root, words) {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(why) => {
            eprintln!("{why}");
            ExitCode::FAILURE
        }
    }
}

fn asked(root: &Path, words: &[&str]) -> Result<Asked, String> {
    let known = names(root)?;
    let mut asked = Asked { targets: Vec::new(), seconds: 600, seed: 1, keep: false };
    let mut words = words.iter();
    while let Some(word) = words.next() {
        let mut number = || {
            let value = words.next().and_then(|w| w.parse().ok());
            value.ok_or_else(|| format!("{word} needs a whole number"))
        };
        match *word {
            "--seconds" => asked.seconds = number()?,
            "--seed" => asked.seed = number()?,
            "--keep" => asked.keep = true,
            name if known.iter().any(|k| k == name) => asked.targets.push(name.to_owned()),
            other => {
                return Err(format!(
                    "there is no target and no option {other}; targets are {}",
                    known.join(", ")
                ));
            }
        }
    }
    if asked.targets.is_empty() {
        asked.targets = known;
    }
    Ok(asked)
}

/// Targets: the programs of the package.
fn names(root: &Path) -> Result<Vec<String>, String> {
    let folder = root.join(PACKAGE).join("fuzz_targets");
    let files = corpus::listed(&folder).map_err(at(&folder))?;
    let names = files.iter().filter_map(|file| file.file_stem());
    Ok(names.map(|n| n.to_string_lossy().into_owned()).collect())
}

/// Says where something went wrong.
fn at(path: &Path) -> impl Fn(io::Error) -> String {
    move |error| format!("{}: {error}", path.display())
}

/// Whether nothing failed.
fn fuzz(root: &Path, words: &[&str]) -> Result<bool, String> {
    let asked = asked(root, words)?;
    if licences::check_metadata(root, &root.join(PACKAGE))? > 0 {
        return Err("deny.toml lists the licences that there may be".to_owned());
    }
    let programs = build(root)?;
    let mut sound = true;
    let mut table =
        "| target | inputs | edges | features | kept | failures |\n|---|---|---|---|---|---|\n"
            .to_owned();
    for name in &asked.targets {
        let target = Guided { name, program: programs.join(name), results: root.join(RESULTS) };
        let (said, failed) = target.look(root, &asked)?;
        let _ = writeln!(
            table,
            "| {name} | {} | {} | {} | {} | {} |",
            said.inputs,
            said.edges,
            said.features,
            said.kept,
            u64::from(failed)
        );
        sound &= !failed;
        if asked.keep && !failed {
            target.keep(root)?;
        }
    }
    println!("\n{table}");
    Ok(sound)
}

/// Builds all programs; their folder.
fn build(root: &Path) -> Result<PathBuf, String> {
    let host = licences::host()?;
    let folder = root.join(RESULTS).join("build");
    let mut command = Command::new(shell::cargo());
    command.args(["build", "--release", "--locked", "--manifest-path"]);
    command.arg(root.join(PACKAGE).join("Cargo.toml"));
    // With a target named, what runs while building (macros) is not instrumented.
    command.args(["--target", &host, "--target-dir"]).arg(&folder);
    command.env("RUSTFLAGS", INSTRUMENTED);
    if !shell::run(root, &mut command)?.success {
        return Err("the targets were not built; libFuzzer needs a C++ compiler (g++ or clang++)"
            .to_owned());
    }
    Ok(folder.join(host).join("release"))
}

/// One target.
struct Guided<'a> {
    name: &'a str,
    program: PathBuf,
    results: PathBuf,
}

impl Guided<'_> {
    /// Its own folder for `what`, made where it is missing.
    fn folder(&self, what: &str) -> Result<PathBuf, String> {
        let folder = self.results.join(what).join(self.name);
        fs::create_dir_all(&folder).map_err(at(&folder))?;
        Ok(folder)
    }

    /// Runs it with these words; whether it ended well, and what it said.
    fn call(&self, words: &[String], folders: &[PathBuf]) -> Result<(bool, String), String> {
        let place = self.folder("said")?.join("log.txt");
        let log = fs::File::create(&place).map_err(at(&place))?;
        let failures = self.folder("failures")?;
        let status = Command::new("sh")
            .args(["-c", &format!("ulimit -v {MEMORY}; exec \"$@\""), "sh"])
            .arg(&self.program)
            .args(words)
            .args(LIMITS)
            .arg(format!("-artifact_prefix={}/", failures.display()))
            .args(folders)
            // Files that a scene names are not there.
            .current_dir(self.folder("empty")?)
            .stdin(Stdio::null())
            .stdout(Stdio::null())
            .stderr(log)
            .status()
            .map_err(at(&self.program))?;
        let bytes = fs::read(&place).map_err(at(&place))?;
        let text = String::from_utf8_lossy(&bytes).into_owned();
        Ok((status.success(), text))
    }

    /// The folder of inputs besides those that it found itself.
    fn given(&self, root: &Path) -> Result<PathBuf, String> {
        let seeds = self.folder("seeds")?;
        let mut files =
            corpus::all(self.name).map_err(|e| format!("corpus of {}: {e}", self.name))?;
        if self.name == "scene" {
            let quick = |path: &PathBuf| !path.iter().any(|part| SLOW.iter().any(|s| part == *s));
            files.extend(
                source_tree::files(&root.join("scenes"), &["toml"]).into_iter().filter(quick),
            );
        }
        fill(&seeds, &small(files))?;
        Ok(seeds)
    }

    /// Looks for failures; what it said, and whether it found one.
    fn look(&self, root: &Path, asked: &Asked) -> Result<(Said, bool), String> {
        println!("{}: {} s", self.name, asked.seconds);
        let words = [
            format!("-max_total_time={}", asked.seconds),
            format!("-seed={}", asked.seed),
            "-print_final_stats=1".to_owned(),
        ];
        let (sound, text) = self.call(&words, &[self.folder("corpus")?, self.given(root)?])?;
        if !sound {
            let last: Vec<&str> = text.lines().rev().take(40).collect();
            last.iter().rev().for_each(|line| eprintln!("{line}"));
            let place = self.folder("failures")?;
            eprintln!("{}: failed; the input lies in {}", self.name, place.display());
        }
        Ok((read(&text), !sound))
    }

    /// Writes the fewest inputs that reach the code that was reached to the folder of what was found, up to a number; what somebody
    /// wrote counts and is not written again.
    fn keep(&self, root: &Path) -> Result<(), String> {
        let merged = self.folder("merged")?;
        let by_hand =
            corpus::by_hand(self.name).map_err(|e| format!("corpus of {}: {e}", self.name))?;
        fill(&merged, &by_hand)?;
        let before = corpus::listed(&merged).map_err(at(&merged))?;
        let mut all = Vec::new();
        for folder in [self.folder("corpus")?, self.given(root)?] {
            all.extend(corpus::listed(&folder).map_err(at(&folder))?);
        }
        let candidates = self.folder("candidates")?;
        fill(&candidates, &small(all))?;
        let words = ["-set_cover_merge=1", "-use_counters=0"].map(str::to_owned);
        let (sound, text) = self.call(&words, &[merged.clone(), candidates])?;
        if !sound {
            return Err(format!("{}: inputs were not merged:\n{text}", self.name));
        }
        let mut new = corpus::listed(&merged).map_err(at(&merged))?;
        new.retain(|path| !before.contains(path));
        let (_, text) = self.call(&["-runs=1".to_owned()], &new)?;
        new.retain(|path| !slow(&text, path));
        let reached = new.len();
        most(&mut new);
        let found = corpus::folder().join(corpus::FOUND).join(self.name);
        fs::create_dir_all(&found).map_err(at(&found))?;
        fill(&found, &new)?;
        println!("{}: {} of {reached} inputs in {}", self.name, new.len(), found.display());
        Ok(())
    }
}

/// Those of the files that are small enough to be kept.
fn small(files: Vec<PathBuf>) -> Vec<PathBuf> {
    let size = |path: &PathBuf| fs::metadata(path).map_or(u64::MAX, |about| about.len());
    files.into_iter().filter(|path| size(path) <= KEPT.0).collect()
}

/// Leaves those that bring most, which are written first when corpora are merged, up to the number and bytes that are committed.
fn most(files: &mut Vec<PathBuf>) {
    files.sort_by_key(|path| fs::metadata(path).and_then(|about| about.modified()).ok());
    let mut bytes = 0;
    files.retain(|path| {
        bytes += fs::metadata(path).map_or(0, |about| about.len());
        bytes <= MOST.1
    });
    files.truncate(MOST.0);
}

/// Makes a folder hold copies of these files and nothing else. Names that are taken get a number.
fn fill(folder: &Path, files: &[PathBuf]) -> Result<(), String> {
    for old in corpus::listed(folder).map_err(at(folder))? {
        fs::remove_file(&old).map_err(at(&old))?;
    }
    for (k, file) in files.iter().enumerate() {
        let mut to = folder.join(file.file_name().unwrap_or_default());
        if to.exists() {
            to.set_extension(k.to_string());
        }
        fs::copy(file, &to).map_err(at(file))?;
    }
    Ok(())
}

/// What stands in the log of libFuzzer.
fn read(log: &str) -> Said {
    let mut said = Said::default();
    for line in log.lines() {
        let words: Vec<&str> = line.split_whitespace().collect();
        let after = |label: &str| -> Option<u64> {
            let at = words.iter().position(|w| *w == label)?;
            words.get(at + 1)?.split('/').next()?.parse().ok()
        };
        if let Some(number) = after("stat::number_of_executed_units:") {
            said.inputs = number;
        }
        if line.starts_with('#') {
            said.edges = after("cov:").unwrap_or(said.edges);
            said.features = after("ft:").unwrap_or(said.features);
            said.kept = after("corp:").unwrap_or(said.kept);
            if said.inputs == 0 || words.get(1) != Some(&"DONE") {
                said.inputs = words[0][1..].parse().unwrap_or(said.inputs);
            }
        }
    }
    said
}

/// Whether the log says of a file that it took too long.
fn slow(log: &str, path: &Path) -> bool {
    let start = format!("Executed {} in ", path.display());
    let time = log.lines().find_map(|line| line.strip_prefix(&start));
    let ms = time.and_then(|rest| rest.split(' ').next()?.parse::<u64>().ok());
    // No time: it did not end.
    ms.is_none_or(|ms| ms > KEPT.1)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Lines `name = ...` of a lock file, each with its `version = ...`.
    fn locked(file: &Path) -> Vec<String> {
        let text = fs::read_to_string(file).unwrap();
        let lines: Vec<&str> = text.lines().collect();
        let named = lines.windows(2).filter(|w| w[0].starts_with("name = "));
        named.map(|w| w.join(", ")).collect()
    }

    /// What only libFuzzer brings.
    const OWN: [&str; 4] = ["riprap-fuzz-guided", "libfuzzer-sys", "arbitrary", "jobserver"];

    #[test]
    fn the_guided_targets_are_built_of_the_same_versions() {
        let root = source_tree::root();
        let all = locked(&root.join("Cargo.lock"));
        for package in locked(&root.join(PACKAGE).join("Cargo.lock")) {
            let own = OWN.iter().any(|name| package.contains(&format!("\"{name}\"")));
            assert!(
                own || all.contains(&package),
                "fuzz/Cargo.lock has {package}, Cargo.lock another: copy Cargo.lock over it, `cargo metadata --manifest-path fuzz/Cargo.toml` does the rest"
            );
        }
    }

    #[test]
    fn the_log_of_libfuzzer_is_read() {
        let log = "INFO: seed\n#2\tINITED cov: 22 ft: 23 corp: 1/1b exec/s: 0 rss: 31Mb\n\
            #1024\tpulse  cov: 30 ft: 40 corp: 5/66b lim: 4 exec/s: 512 rss: 33Mb\n\
            #3000\tDONE   cov: 31 ft: 42 corp: 6/70b lim: 4 exec/s: 512 rss: 33Mb\n\
            stat::number_of_executed_units: 3000\n";
        let said = Said { inputs: 3000, edges: 31, features: 42, kept: 6 };
        assert_eq!(read(log), said);
        let times = "Executed /a/b in 12 ms\nExecuted /a/c in 900 ms\n";
        assert!(!slow(times, Path::new("/a/b")));
        assert!(slow(times, Path::new("/a/c")) && slow(times, Path::new("/a/d")));
    }
}
