//! Attacks on runs by the disk: it fills up at any place, then there is room again.

use std::process::{Command, Stdio};

use super::faults::FALL;
use super::{Field, Found};
use riprap_fuzz::damage::Chance;

/// Smallest disk, kB, and by how much the largest is larger: from one on which hardly the folder fits to one on which all does.
const SIZE: [usize; 2] = [16, 160];
/// Exit code of a shell that may not make a disk.
const NO_DISK: i32 = 77;

/// A disk in memory of `$1` kB, seen by this shell alone; a run on it that fills it, and one that goes on when there is room.
const SCRIPT: &str = "mount -t tmpfs -o size=$1k none disk 2>/dev/null || exit 77\n\
    \"$2\" run t.toml --quiet --threads 1 --out disk/a.run; code=$?\n\
    [ $code = 0 ] && exit 0\n\
    [ $code = 3 ] || { echo \"exit $code\"; exit 1; }\n\
    mount -o remount,size=16m disk || exit 77\n\
    if ls disk/a.run/checkpoints/*.rck >/dev/null 2>&1; then \"$2\" resume disk/a.run --quiet --threads 1\n\
    else \"$2\" run t.toml --quiet --threads 1 --out disk/a.run --force; fi || { echo \"afterwards: exit $?\"; exit 1; }\n\
    [ \"$(\"$2\" hash disk/a.run)\" = \"$(\"$2\" hash whole.run)\" ] || { echo \"another state\"; exit 1; }\n\
    for file in histories.csv energy.csv events.jsonl run.pvd; do\n\
    cmp -s disk/a.run/$file whole.run/$file || { echo \"another $file\"; exit 1; }; done; exit 3\n";

/// Runs on disks that are too small. Skipped, with a line, where nobody may mount.
pub fn full(field: &Field<'_>, chance: &mut Chance) -> Result<Found, String> {
    let mut found = Found::default();
    let scene = FALL
        .replace("time = \"3 s\"", "time = \"0.2 s\"")
        .replace("every = \"50 ms\"", "every = \"10 ms\"")
        + "[[outputs]]\ncheckpoints = { every = \"20 ms\" }\n";
    field.write("t.toml", scene)?;
    let disk = field.folder.join("disk");
    std::fs::create_dir_all(&disk).map_err(|e| format!("{}: {e}", disk.display()))?;
    let whole = ["run", "t.toml", "--quiet", "--threads", "1", "--out", "whole.run"];
    field.program.answer(&field.folder, &whole)?;
    for _ in 0..(field.tries / 10).clamp(4, 100) {
        let size = SIZE[0] + chance.below(SIZE[1]);
        let ended = Command::new("unshare")
            .args(["-rm", "sh", "-c", SCRIPT, "sh", &size.to_string()])
            .arg(field.program.path())
            .current_dir(&field.folder)
            .stdin(Stdio::null())
            .output();
        let ended = match ended {
            Ok(ended) if ended.status.code() != Some(NO_DISK) => ended,
            Ok(_) | Err(_) => {
                println!(
                    "full disks skipped: this machine lets nobody mount a disk of his own (unshare -rm)"
                );
                return Ok(found);
            }
        };
        found.tries += 1;
        let told = String::from_utf8_lossy(&ended.stderr);
        match ended.status.code() {
            Some(0) => {}
            Some(3) if told.contains("could not write") => found.refused += 1,
            code => {
                let why = String::from_utf8_lossy(&ended.stdout);
                let why = format!("{} {}", why.trim(), told.lines().last().unwrap_or(""));
                found.failures.push(format!("{size} kB, {code:?}: {why}"));
            }
        }
    }
    Ok(found)
}
