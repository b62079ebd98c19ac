//! `cargo xtask mutate`: scenes broken on purpose, and the checks that do not notice.
//!
//! A check that passes whatever is done to its scene checks nothing, or an invariant (a ledger that closes, a momentum that is kept), which no
//! wrong input can break. Each scene is run as it is and, one after the other, with its gravity, stiffnesses, friction, strength, density, loads,
//! speeds, stress at the start, bolts, water, sizes, what drives it or duration changed; what none of these makes fail is listed, to be looked at by a person. A check whose
//! expected value is a formula that follows the change, and that passes again, has noticed it.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::time::Duration;

use serde_json::Value;

use crate::attack::process::Program;
use crate::{shell, verify};
use riprap_fuzz::damage::numbers;

/// What is changed: keys, and the factor on the numbers behind them.
const CHANGES: [(&[&str], f64); 15] = [
    (&["gravity", "acceleration"], 1.1),
    (&["normal_stiffness", "shear_stiffness", "young"], 2.0),
    (&["friction_angle", "friction_coefficient", "residual_friction_angle"], 0.8),
    (&["friction_angle", "friction_coefficient"], 0.05),
    (&["cohesion", "tension", "tensile_strength", "fracture_energy", "yield_force"], 0.5),
    (&["density"], 1.2),
    (&["force", "pressure", "traction", "moment", "mass"], 1.2),
    (&["velocity", "spin"], 1.1),
    (&["damping_ratio", "restitution", "local", "mass_damping"], 0.5),
    (&["time", "steps"], 0.5),
    (&["vertical", "in_situ.x", "in_situ.y", "k0", "stress"], 1.2),
    (&["diameter", "bolts.stiffness", "bolts.strength", "pretension"], 0.5),
    (&["level", "points", "head"], 0.8),
    // What drives over time: motions and loads in tables of their own.
    (&["value", "constant", "to", "formula"], 1.2),
    (&["size", "cell", "radius", "thickness", "spacing"], 1.1),
];

/// Slowest scene that is broken, s, when nothing else is asked for.
const SECONDS: f64 = 3.0;

/// `cargo xtask mutate [--seconds S] [--binary FILE] [SCENE]...`.
pub fn run(root: &Path, words: &[&str]) -> Result<(), String> {
    let mut words = words.to_vec();
    let seconds = shell::number(&mut words, "--seconds")?.unwrap_or(SECONDS);
    let program = Program::new(&verify::chosen_binary(root, &mut words)?);
    let mut chosen: Vec<String> = words.into_iter().map(str::to_owned).collect();
    if chosen.is_empty() {
        chosen = verify::fast_scenes(root);
    }
    let (mut checks, mut blind, mut slow) = (0, 0, 0);
    for scene in &chosen {
        let Some(result) = broken(root, &program, scene, seconds)? else {
            slow += 1;
            continue;
        };
        checks += result.len();
        for (check, _) in result.iter().filter(|(_, noticed)| !**noticed) {
            blind += 1;
            println!("{scene}: nothing makes {check:?} fail");
        }
    }
    println!(
        "{checks} checks of {} scenes: {blind} never fail; {slow} scenes are slower than {seconds} s",
        chosen.len() - slow
    );
    Ok(())
}

/// Whether a change makes each check fail; `None` for a scene that is too slow.
fn broken(
    root: &Path,
    program: &Program,
    scene: &str,
    seconds: f64,
) -> Result<Option<BTreeMap<String, bool>>, String> {
    let text = std::fs::read_to_string(root.join(scene)).map_err(|e| format!("{scene}: {e}"))?;
    let copy = copied(root, scene)?;
    // A scene that cannot be run, or takes longer, has no checks.
    let checks = |text: &str, seconds: f64| -> Result<Vec<Value>, String> {
        std::fs::write(&copy, text).map_err(|e| format!("{}: {e}", copy.display()))?;
        let file = copy.to_string_lossy();
        let words = ["verify", "--json", "--jobs", "1", &file];
        let folder = copy.parent().unwrap_or(root);
        let ended = program.run_within(folder, &words, Duration::from_secs_f64(seconds))?;
        let lines = ended.printed.lines().filter(|_| !ended.slow);
        Ok(lines.filter_map(|line| serde_json::from_str(line).ok()).collect())
    };
    let sound = checks(&text, seconds)?;
    if sound.is_empty() {
        return Ok(None);
    }
    let sound: BTreeMap<String, Value> = (sound.iter().filter(|c| c["status"] == "passed"))
        .map(|c| (name(c), c["expected"].clone()))
        .collect();
    let mut noticed: BTreeMap<String, bool> =
        sound.keys().map(|name| (name.clone(), false)).collect();
    for (keys, factor) in CHANGES {
        let changed = scaled(&text, keys, factor);
        if changed == text {
            continue;
        }
        for check in checks(&changed, 10.0 * seconds)? {
            let name = name(&check);
            // A formula that followed the change, and was met again, has held the scene to its law.
            let follows = check["status"] == "passed"
                && sound.get(&name).is_some_and(|e| *e != check["expected"]);
            if let Some(noticed) = noticed.get_mut(&name) {
                *noticed |= check["status"] == "failed" || follows;
            }
        }
    }
    Ok(Some(noticed))
}

fn name(check: &Value) -> String {
    let words = ["case", "check"].map(|key| check[key].as_str().unwrap_or_default());
    words.join(": ").trim_start_matches(": ").to_owned()
}

/// Where a scene is copied to, in a folder of its own with the data beside it.
fn copied(root: &Path, scene: &str) -> Result<PathBuf, String> {
    let folder = root.join("target/mutate");
    let _ = std::fs::remove_dir_all(&folder);
    let data = folder.join("data");
    std::fs::create_dir_all(&data).map_err(|e| format!("{}: {e}", data.display()))?;
    let original = root.join(scene);
    let beside = original.parent().unwrap_or(root).join("data");
    for file in crate::source_tree::files(&beside, &[]) {
        let to = data.join(file.file_name().unwrap_or_default());
        std::fs::copy(&file, to).map_err(|e| format!("{}: {e}", file.display()))?;
    }
    Ok(folder.join(original.file_name().unwrap_or_default()))
}

/// The text with the numbers behind these keys multiplied, checks apart. A key with a dot is looked for in tables of that name alone.
fn scaled(text: &str, keys: &[&str], factor: f64) -> String {
    let mut checks = false;
    let mut own: Vec<&str> = Vec::new();
    let lines = text.split_inclusive('\n').map(|line| {
        let start = line.trim_start();
        if start.starts_with('[') && !line.starts_with(' ') {
            checks = ["[[checks]]", "[checks", "[[outputs]]", "[bisect"]
                .iter()
                .any(|t| start.starts_with(t));
            let table = start.trim_start_matches('[');
            own = (keys.iter())
                .filter_map(|key| match key.split_once('.') {
                    Some((name, key)) => table.starts_with(name).then_some(key),
                    None => Some(*key),
                })
                .collect();
        }
        if checks || start.starts_with('#') {
            line.to_owned()
        } else {
            scaled_line(line, &own, factor)
        }
    });
    lines.collect()
}

fn scaled_line(line: &str, keys: &[&str], factor: f64) -> String {
    let mut done = line.to_owned();
    // From the back, so that places stay.
    for (begin, end) in numbers(line).into_iter().rev() {
        let key = line[..begin].rfind('=').map(|at| line[..at].trim_end_matches([' ', '"']));
        let last =
            key.and_then(|key| key.rsplit(|c: char| !(c.is_alphanumeric() || c == '_')).next());
        let counts = keys.contains(&"steps") && last == Some("steps");
        let Ok(number) = line[begin..end].replace('_', "").parse::<f64>() else {
            continue;
        };
        if last.is_some_and(|last| keys.contains(&last)) {
            let new = if counts { (number * factor).floor().max(1.0) } else { number * factor };
            done.replace_range(begin..end, &new.to_string());
        }
    }
    done
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_behind_keys_are_multiplied() {
        let text = "[a]\ngravity = [\"0 m/s2\", \"-10 m/s2\"]\na = { density = \"2e3 kg/m3\", steps = 7 }\n\"a.density\" = [\"2e3 kg/m3\"]\n[[checks]]\ngravity = 1\n";
        let gravity = scaled(text, &["gravity"], 1.5);
        assert_eq!(gravity, text.replace("-10 m", "-15 m"));
        assert_eq!(scaled(text, &["steps"], 0.5), text.replace("steps = 7", "steps = 3"));
        assert_eq!(scaled(text, &["density"], 2.0), text.replace("2e3", "4000"));
        let text = "[[bolts]]\ngrout = { stiffness = \"4 MPa\" }\n[b]\nstiffness = 4\n[[checks]]\nstiffness = 4\n";
        let bolts = scaled(text, &["bolts.stiffness"], 2.0);
        assert_eq!(bolts, text.replace("4 MPa", "8 MPa"));
    }
}
