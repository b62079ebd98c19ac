//! Attacks on runs by the clock: it is set forward and back while they run.
//!
//! The machine's own clock is left alone. A small library that is loaded before the program's others answers in the place of the
//! system, for that one process.

use std::path::{Path, PathBuf};
use std::process::Command;

use super::faults::engines;
use super::{Field, Found, LONG, read_text};
use crate::cut;
use riprap_fuzz::damage::Chance;

/// The library: real clocks, to which whatever `JUMPS` says is added, s, in turn, for `STRETCH` questions each. Time of day begins 31 years
/// from now, so that one sees that the library is asked.
const LIBRARY: &str = r#"
use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};

#[repr(C)]
pub struct Time { seconds: i64, nanoseconds: i64 }

unsafe extern "C" { fn syscall(number: i64, ...) -> i64; }

#[cfg(target_arch = "x86_64")]
const CLOCK_GETTIME: i64 = 228;
#[cfg(target_arch = "aarch64")]
const CLOCK_GETTIME: i64 = 113;
const LATER: i64 = 1_000_000_000;
const JUMPS: [i64; 6] = [0, 86_400, -72_000, LATER, -3 * LATER, 7];

#[unsafe(no_mangle)]
pub unsafe extern "C" fn clock_gettime(clock: i32, time: *mut Time) -> i32 {
    static ASKED: AtomicUsize = AtomicUsize::new(0);
    let code = unsafe { syscall(CLOCK_GETTIME, i64::from(clock), time) };
    // Time of day, and time that has passed; not what a thread has computed.
    if code == 0 && (clock == 0 || clock == 1) {
        let asked = ASKED.fetch_add(1, Relaxed);
        let day = if clock == 0 && asked < STRETCH { LATER } else { 0 };
        unsafe { (*time).seconds += JUMPS[asked / STRETCH % JUMPS.len()] + day };
    }
    code as i32
}
"#;

/// Questions between two jumps.
const STRETCHES: [usize; 4] = [50, 3000, 7, 400];

/// Runs of each engine under clocks that jump. Skipped, with a line, where nothing can be loaded before a program.
pub fn jump(field: &Field<'_>, _: &mut Chance) -> Result<Found, String> {
    let mut found = Found::default();
    if !cfg!(target_os = "linux") {
        println!("clocks skipped: this system does not load a library before a program");
        return Ok(found);
    }
    let (stretches, steps) =
        if field.few() { (&STRETCHES[..1], 300) } else { (&STRETCHES[..], 20_000) };
    let libraries: Vec<PathBuf> = stretches
        .iter()
        .map(|stretch| library(&field.folder, *stretch))
        .collect::<Result<_, _>>()?;
    for (name, scene) in engines(field.root)? {
        field.write("t.toml", &scene)?;
        let run = |out: &str, clock: Option<&Path>| -> Result<(), String> {
            let mut words = vec!["run", "t.toml", "--out", out, "--force", "--threads", "1"];
            let changes = cut::words(&scene, steps);
            words.push("--quiet");
            words.extend(changes.iter().map(String::as_str));
            let preload = clock.map(|library| ("LD_PRELOAD", library));
            let how = field.program.run_with(&field.folder, &words, LONG, preload.as_slice())?;
            match how.code {
                Some(0) if !how.slow => Ok(()),
                code => Err(format!("exit {code:?}: {}", how.said)),
            }
        };
        run("whole.run", None)?;
        for (stretch, library) in stretches.iter().zip(&libraries) {
            found.tries += 1;
            let at = format!("{name}, a jump every {stretch} questions");
            let differ = run("jumps.run", Some(library))
                .and_then(|()| field.differ(["jumps.run", "whole.run"]));
            match differ {
                Err(why) => found.failures.push(format!("{at}: {why}")),
                Ok(differ) => {
                    found
                        .failures
                        .extend(differ.iter().map(|what| format!("{at}: another {what}")));
                }
            }
            if begun(field, "jumps.run")? < begun(field, "whole.run")? + 20 {
                return Err(format!("{at}: the clock has not been asked for the time of day"));
            }
        }
    }
    Ok(found)
}

/// Builds the library for jumps every `stretch` questions.
fn library(folder: &Path, stretch: usize) -> Result<PathBuf, String> {
    let (source, built) =
        (folder.join(format!("clock_{stretch}.rs")), folder.join(format!("libclock_{stretch}.so")));
    let text = format!("{LIBRARY}const STRETCH: usize = {stretch};\n");
    std::fs::write(&source, text).map_err(|e| format!("{}: {e}", source.display()))?;
    let output = Command::new("rustc")
        .args(["--edition", "2024", "--crate-type", "cdylib", "-C", "panic=abort", "-o"])
        .args([&built, &source])
        .output()
        .map_err(|e| format!("rustc: {e}"))?;
    if !output.status.success() {
        return Err(String::from_utf8_lossy(&output.stderr).into_owned());
    }
    Ok(built)
}

/// Year in which a run says that it began.
fn begun(field: &Field<'_>, run: &str) -> Result<u32, String> {
    let path = field.folder.join(run).join("manifest.json");
    let text = read_text(&path)?;
    let year = text.split("\"started\": \"").nth(1).and_then(|rest| rest.get(..4));
    year.and_then(|year| year.parse().ok()).ok_or_else(|| format!("{}: no year", path.display()))
}
