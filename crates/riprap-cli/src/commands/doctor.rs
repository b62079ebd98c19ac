//! `riprap doctor`: what this machine offers.

use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Instant;

use crate::args::VERSION;
use crate::failure::Failure;
use crate::screen;

/// Bytes written to see how fast the disk is.
const SAMPLE: usize = 32 << 20;

pub fn run() -> Result<(), Failure> {
    let cores = std::thread::available_parallelism().map_or(1, std::num::NonZero::get);
    let build = if cfg!(debug_assertions) { "debug (slow: use --release)" } else { "release" };
    let unknown = || "unknown".to_owned();
    let rows = [
        ("riprap", VERSION.to_owned()),
        ("build", build.to_owned()),
        ("system", format!("{} {}", std::env::consts::OS, std::env::consts::ARCH)),
        ("processor", first_of("/proc/cpuinfo", "model name").unwrap_or_else(unknown)),
        ("cores", cores.to_string()),
        ("memory", memory().unwrap_or_else(unknown)),
        ("disk", disk()),
        ("browser", browser()),
        ("python", python()),
        ("devices", devices()),
    ];
    for (what, found) in rows {
        screen::line(&format!("{what:<9} {found}"));
    }
    Ok(())
}

/// `24.7 GB, 20.1 GB free`.
fn memory() -> Option<String> {
    let size = |key| {
        let text = first_of("/proc/meminfo", key)?;
        let kib: f64 = text.split_whitespace().next()?.parse().ok()?;
        Some(1024e-9 * kib)
    };
    let total = size("MemTotal")?;
    Some(match size("MemAvailable") {
        Some(free) => format!("{total:.1} GB, {free:.1} GB free"),
        None => format!("{total:.1} GB"),
    })
}

/// How fast the working folder is written, and what is free there.
fn disk() -> String {
    let path = PathBuf::from(format!(".riprap-doctor-{}", std::process::id()));
    let begun = Instant::now();
    let written = std::fs::File::create_new(&path).and_then(|mut file| {
        file.write_all(&vec![0x5a; SAMPLE])?;
        // Else only memory would have been written.
        file.sync_all()
    });
    let seconds = begun.elapsed().as_secs_f64();
    let removed = std::fs::remove_file(&path);
    let speed = match written {
        Ok(()) => format!("{:.0} MB/s written", 1e-6 * SAMPLE as f64 / seconds),
        Err(error) => format!("cannot write to the working folder ({error})"),
    };
    let left = match removed {
        Err(error) if path.exists() => format!(" (could not remove {}: {error})", path.display()),
        Ok(()) | Err(_) => String::new(),
    };
    match free() {
        Some(free) => format!("{speed}, {free:.1} GB free in the working folder{left}"),
        None => format!("{speed}{left}"),
    }
}

/// GB free in the working folder, as `df` says.
fn free() -> Option<f64> {
    let told = said(Command::new("df").args(["-Pk", "."]))?;
    let kib: f64 = told.lines().nth(1)?.split_whitespace().nth(3)?.parse().ok()?;
    Some(1024e-9 * kib)
}

/// What would show `riprap view`.
fn browser() -> String {
    const KNOWN: [&str; 8] = [
        "firefox",
        "google-chrome",
        "google-chrome-stable",
        "chromium",
        "chromium-browser",
        "microsoft-edge",
        "safari",
        "xdg-open",
    ];
    let own = std::env::var("BROWSER").ok().filter(|b| !b.is_empty());
    let found = own
        .map(|named| format!("{named} (BROWSER)"))
        .or_else(|| KNOWN.iter().find_map(|name| in_path(name)).map(|p| p.display().to_string()));
    match found {
        Some(found) => found,
        // There it is part of the system and in no path.
        None if cfg!(any(target_os = "macos", target_os = "windows")) => {
            "system default".to_owned()
        }
        None => "none found; `riprap view` prints an address, `riprap report` writes a page for another machine"
            .to_owned(),
    }
}

/// Python, and whether it has what the package and its pictures need.
fn python() -> String {
    const ASK: &str = "import sys, importlib.util as u; print(sys.version.split()[0], \
        *[m for m in ('riprap', 'numpy', 'pyvista', 'matplotlib') if u.find_spec(m)])";
    for name in ["python3", "python"] {
        let Some(told) = said(Command::new(name).args(["-c", ASK])) else {
            continue;
        };
        let mut words = told.split_whitespace();
        let version = words.next().unwrap_or("?");
        let modules: Vec<&str> = words.collect();
        let with = |list: &[&str]| {
            if list.is_empty() { "none".to_owned() } else { list.join(", ") }
        };
        let without: Vec<&str> = ["riprap", "numpy", "pyvista", "matplotlib"]
            .into_iter()
            .filter(|module| !modules.contains(module))
            .collect();
        return format!("{version} with {}; without {}", with(&modules), with(&without));
    }
    "none found; only the Python package needs it".to_owned()
}

/// Accelerators: what the system has, and that none is used.
fn devices() -> String {
    let query = ["--query-gpu=name,memory.total", "--format=csv,noheader"];
    let seen = said(Command::new("nvidia-smi").args(query)).filter(|text| !text.trim().is_empty());
    match seen {
        Some(text) => {
            format!("{}: not used, riprap computes on the CPU", text.trim().replace('\n', "; "))
        }
        None => "none found; riprap computes on the CPU".to_owned(),
    }
}

/// What a program prints when it ends well.
fn said(command: &mut Command) -> Option<String> {
    let output = command.output().ok().filter(|o| o.status.success())?;
    Some(String::from_utf8_lossy(&output.stdout).into_owned())
}

/// A program of the search path.
fn in_path(name: &str) -> Option<PathBuf> {
    let paths = std::env::var_os("PATH")?;
    std::env::split_paths(&paths)
        .map(|folder| folder.join(name))
        .find(|path: &PathBuf| Path::is_file(path))
}

/// The value of the first line `key : value` of a system file (Linux only).
fn first_of(file: &str, key: &str) -> Option<String> {
    let text = std::fs::read_to_string(file).ok()?;
    let line = text.lines().find(|l| l.starts_with(key))?;
    line.split_once(':').map(|(_, value)| value.trim().to_owned())
}
