//! `riprap doctor`: what this machine offers.

use crate::failure::Failure;
use crate::screen;

pub fn run() -> Result<(), Failure> {
    let cores = std::thread::available_parallelism().map_or(1, std::num::NonZero::get);
    let build = if cfg!(debug_assertions) {
        "debug (slow: use --release)"
    } else {
        "release"
    };
    screen::print(&format!(
        "riprap    {} ({build})\nsystem    {} {}\nprocessor {}\ncores     {cores}\nmemory    {}\n",
        env!("CARGO_PKG_VERSION"),
        std::env::consts::OS,
        std::env::consts::ARCH,
        first_of("/proc/cpuinfo", "model name").unwrap_or_else(|| "unknown".to_owned()),
        first_of("/proc/meminfo", "MemTotal").unwrap_or_else(|| "unknown".to_owned()),
    ));
    Ok(())
}

/// The value of the first line `key : value` of a system file (Linux only).
fn first_of(file: &str, key: &str) -> Option<String> {
    let text = std::fs::read_to_string(file).ok()?;
    let line = text.lines().find(|l| l.starts_with(key))?;
    line.split_once(':')
        .map(|(_, value)| value.trim().to_owned())
}
