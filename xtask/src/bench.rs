//! `cargo xtask bench`: speed of the planar step, as CSV.

use std::path::Path;
use std::process::{Command, ExitCode};

/// Builds and runs the benchmark of the library; its CSV is printed and kept in `target/bench.csv`.
pub fn run(root: &Path) -> ExitCode {
    let output = Command::new("cargo")
        .args([
            "run",
            "--release",
            "--quiet",
            "--package",
            "riprap",
            "--example",
            "bench_planar",
        ])
        .current_dir(root)
        .output();
    let output = match output {
        Ok(output) => output,
        Err(error) => {
            eprintln!("cargo could not be started: {error}");
            return ExitCode::FAILURE;
        }
    };
    let text = String::from_utf8_lossy(&output.stdout);
    print!("{text}");
    if !output.status.success() {
        eprint!("{}", String::from_utf8_lossy(&output.stderr));
        return ExitCode::FAILURE;
    }
    let path = root.join("target").join("bench.csv");
    if let Err(error) = std::fs::write(&path, text.as_bytes()) {
        eprintln!("{} could not be written: {error}", path.display());
        return ExitCode::FAILURE;
    }
    println!("kept in {}", path.display());
    ExitCode::SUCCESS
}
