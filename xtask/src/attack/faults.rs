//! Attacks on runs: kills, threads, speed.

use std::path::Path;
use std::time::{Duration, Instant};

use super::process::Ended;
use super::{Field, Found, LONG, read_text};
use crate::cut;
use riprap_fuzz::damage::Chance;

/// A block that falls in the plane.
pub const FALL: &str = "riprap = 1\ntitle = \"a block falls\"\n[space.planar]\ngravity = [\"0 m/s2\", \"-10 m/s2\"]\n[materials.rock]\ndensity = \"2000 kg/m3\"\n\
    [interfaces.default]\nnormal_stiffness = \"100 MPa/m\"\nfriction_angle = \"30 deg\"\n[[blocks]]\nname = \"floor\"\nmaterial = \"rock\"\n\
    rectangle = { size = [\"4 m\", \"1 m\"], corner = [\"-2 m\", \"-1 m\"] }\n[[blocks]]\nname = \"stone\"\nmaterial = \"rock\"\n\
    rectangle = { size = [\"1 m\", \"1 m\"], corner = [\"-0.5 m\", \"0.2 m\"] }\n[[supports]]\non = { block = \"floor\" }\nfixed = {}\n[[phases]]\nname = \"fall\"\n\
    until = { time = \"3 s\" }\ntime_step = \"10 us\"\n[[outputs]]\nhistory = { name = \"height\", field = \"block.displacement.y\", of = \"stone\", every = \"1 ms\" }\n\
    [[outputs]]\nframes = { every = \"50 ms\" }\n";

/// A scene of each engine, without its checks, long enough to be killed.
pub fn engines(root: &Path) -> Result<[(&'static str, String); 3], String> {
    let read = |file: &str, end: &str, longer: &str| {
        let text = read_text(&root.join(file))?;
        let text = text.split("[[checks]]").next().unwrap_or_default();
        if !text.contains(end) {
            return Err(format!("{file} has no `{end}`"));
        }
        Ok(text.replace(end, longer))
    };
    Ok([
        ("plane", FALL.to_owned()),
        (
            "rigid",
            read(
                "scenes/spatial/bricks.toml",
                "until = { unbalanced = 1e-9, steps = 20000 }",
                "until = { steps = 20000 }",
            )?,
        ),
        (
            "deformable",
            read(
                "scenes/verify/spatial-deformable/hybrid_p_wave.toml",
                "until = { time = \"72 ms\" }",
                "until = { time = \"20 ms\" }",
            )?,
        ),
    ])
}

pub fn kills(field: &Field<'_>, chance: &mut Chance) -> Result<Found, String> {
    let mut found = Found::default();
    for (name, scene) in engines(field.root)? {
        let file = format!("{name}.toml");
        // Rarely enough that the disk does not decide when the run is killed.
        let every = if name == "plane" { 5000 } else { 500 };
        let scene =
            format!("{scene}\n[[outputs]]\ncheckpoints = {{ every = \"{every} steps\" }}\n");
        field.write(&file, &scene)?;
        let begun = Instant::now();
        ended(&field.program.run_within(
            &field.folder,
            &["run", &file, "--out", "whole.run", "--force", "--threads", "1"],
            LONG,
        )?)?;
        let whole = begun.elapsed();
        let wanted = (field.tries / 50).clamp(2, 60);
        let mut kills = 0;
        while kills < wanted {
            let before = kills;
            let died = one_death(field, chance, &file, whole, wanted, &mut kills)?;
            let differ = field.differ(["died.run", "whole.run"])?;
            if let Some(why) = died.wrong() {
                found.failures.push(format!("{name}: {why}"));
            }
            if !differ.is_empty() {
                found
                    .failures
                    .push(format!("{name}, after {kills} kills: {} differ", differ.join(", ")));
            }
            if kills == before {
                return Err(format!("{name}: the run is over before it can be killed"));
            }
        }
        found.tries += kills;
    }
    Ok(found)
}

/// A run that is killed up to eight times, and goes on to its end.
fn one_death(
    field: &Field<'_>,
    chance: &mut Chance,
    file: &str,
    whole: Duration,
    wanted: usize,
    kills: &mut usize,
) -> Result<Ended, String> {
    let most = (*kills + 8).min(wanted);
    // What an earlier run has left there must not be taken for a checkpoint of this one.
    let died = field.folder.join("died.run");
    if died.exists() {
        std::fs::remove_dir_all(&died).map_err(|e| format!("{}: {e}", died.display()))?;
    }
    let begin = ["run", file, "--out", "died.run", "--force", "--threads", "1"];
    let mut child = field.program.start(&field.folder, &begin)?;
    // From here on there is something to resume.
    let checkpoints = field.folder.join("died.run/checkpoints");
    let begun = Instant::now();
    let whole_file = |entry: std::io::Result<std::fs::DirEntry>| {
        entry.is_ok_and(|e| e.path().extension().is_some_and(|e| e == "rck"))
    };
    while !std::fs::read_dir(&checkpoints).is_ok_and(|mut files| files.any(whole_file)) {
        if begun.elapsed() > LONG {
            return Err("no checkpoint comes".to_owned());
        }
        std::thread::sleep(Duration::from_millis(2));
    }
    let resume = ["resume", "died.run", "--threads", "1"];
    while *kills < most {
        let share = whole.as_millis() as usize / 5;
        std::thread::sleep(Duration::from_millis(chance.below(share.max(20)) as u64));
        child.kill().map_err(|e| e.to_string())?;
        let status = child.wait().map_err(|e| e.to_string())?;
        if status.code().is_some() {
            // It was over.
            break;
        }
        *kills += 1;
        child = field.program.start(&field.folder, &resume)?;
    }
    child.wait().map_err(|e| e.to_string())?;
    // Whoever has ended says so.
    field.program.run_within(&field.folder, &resume, LONG)
}

fn ended(how: &Ended) -> Result<(), String> {
    match how.code {
        Some(0) => Ok(()),
        code => Err(format!("exit {code:?}: {}", how.said)),
    }
}

pub fn threads(field: &Field<'_>, _: &mut Chance) -> Result<Found, String> {
    let mut found = Found::default();
    let (counts, steps): (&[&str], _) =
        if field.few() { (&["3"], 100) } else { (&["2", "3", "4", "5", "6", "7", "8"], 2000) };
    let mut scenes: Vec<(&str, String)> = engines(field.root)?.into();
    if !field.few() {
        for file in [
            "scenes/spatial/hybrid.toml",
            "scenes/verify/spatial-contact/stack.toml",
            "scenes/verify/spatial-contact/soft_shear.toml",
        ] {
            scenes.push((file, read_text(&field.root.join(file))?));
        }
    }
    for (name, scene) in scenes {
        field.write("t.toml", &scene)?;
        let run = |threads: &str, out: &str| -> Result<(), String> {
            let mut words = vec!["run", "t.toml", "--out", out, "--force", "--threads", threads];
            words.extend(["--quiet", "--set", "checks=[]"]);
            let changes = cut::words(&scene, steps);
            words.extend(changes.iter().map(String::as_str));
            ended(&field.program.run_within(&field.folder, &words, LONG)?)
        };
        run("1", "one.run").map_err(|why| format!("{name}: {why}"))?;
        for count in counts {
            found.tries += 1;
            let differ = run(count, "a.run").and_then(|()| field.differ(["a.run", "one.run"]));
            match differ {
                Ok(differ) if differ.is_empty() => {}
                Ok(differ) => found
                    .failures
                    .push(format!("{name} on {count} threads: another {}", differ.join(", "))),
                Err(why) => found.failures.push(format!("{name} on {count} threads: {why}")),
            }
        }
    }
    Ok(found)
}

pub fn speed(field: &Field<'_>, _: &mut Chance) -> Result<Found, String> {
    let mut found = Found::default();
    let stiffnesses = ["1 MPa/m", "10 MPa/m", "100 MPa/m", "1 GPa/m", "10 GPa/m"];
    let speeds = ["1", "3", "10", "30", "100", "300"];
    for plane in [true, false] {
        for (k, stiffness) in stiffnesses.iter().enumerate() {
            for (l, speed) in speeds.iter().enumerate() {
                if field.few() && (k + l) % 5 != 0 {
                    continue;
                }
                found.tries += 1;
                let how = field.ran(&falling(plane, stiffness, speed))?;
                let name = format!("plane {plane}, {stiffness}, {speed} m/s");
                found.refused += usize::from(how.code == Some(1));
                match how.code {
                    // Its centre begins half a metre above the floor.
                    Some(0) if how.wrong().is_none() => {
                        let low = field.last()?;
                        if low < -0.5 {
                            found.failures.push(format!("{name}: {low} m and exit 0"));
                        }
                    }
                    Some(1) if how.wrong().is_none() => {}
                    _ => found.failures.push(format!("{name}: {how:?}")),
                }
            }
        }
    }
    Ok(found)
}

/// A block that flies against a fixed floor.
fn falling(plane: bool, stiffness: &str, speed: &str) -> String {
    let head = format!(
        "riprap = 1\ntitle = \"t\"\n[materials.rock]\ndensity = \"2000 kg/m3\"\nyoung = \"20 GPa\"\npoisson = 0.25\n[interfaces.default]\nnormal_stiffness = \"{stiffness}\"\n\
         friction_angle = \"30 deg\"\n[[supports]]\non = {{ block = \"floor\" }}\nfixed = {{}}\n[[phases]]\nname = \"fall\"\nuntil = {{ time = \"0.2 s\" }}\n"
    );
    if plane {
        format!(
            "{head}[space.planar]\ngravity = [\"0 m/s2\", \"-10 m/s2\"]\n[[blocks]]\nname = \"floor\"\nmaterial = \"rock\"\n\
             rectangle = {{ size = [\"4 m\", \"1 m\"], corner = [\"-2 m\", \"-1 m\"] }}\n[[blocks]]\nname = \"stone\"\nmaterial = \"rock\"\n\
             rectangle = {{ size = [\"1 m\", \"1 m\"], corner = [\"-0.5 m\", \"0 m\"] }}\nvelocity = [\"0 m/s\", \"-{speed} m/s\"]\n\
             [[outputs]]\nhistory = {{ name = \"h\", field = \"block.displacement.y\", of = \"stone\", every = \"1 ms\" }}\n"
        )
    } else {
        format!(
            "{head}[space.spatial]\nfound_contacts = true\ngravity = \"10 m/s2\"\n[[blocks]]\nname = \"floor\"\nmaterial = \"rock\"\n\
             brick = {{ size = [\"4 m\", \"4 m\", \"1 m\"], corner = [\"-2 m\", \"-2 m\", \"-1 m\"] }}\n[[blocks]]\nname = \"stone\"\nmaterial = \"rock\"\n\
             brick = {{ size = [\"1 m\", \"1 m\", \"1 m\"], corner = [\"-0.5 m\", \"-0.5 m\", \"0.01 m\"] }}\nvelocity = [\"0 m/s\", \"0 m/s\", \"-{speed} m/s\"]\n\
             [[outputs]]\nhistory = {{ name = \"h\", field = \"block.displacement.z\", of = \"stone\", every = \"1 ms\" }}\n"
        )
    }
}
