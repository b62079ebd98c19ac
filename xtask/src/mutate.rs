//! `cargo xtask mutate`: scenes broken on purpose, and the checks that do not notice.
//!
//! A check that passes whatever is done to its scene checks nothing, or an invariant (a ledger that closes, a momentum that is kept), which no
//! wrong input can break. Each scene is run as it is and, one after the other, with its gravity, stiffnesses, friction, strength, density, loads,
//! speeds, stress at the start, bolts, water, sizes, what drives it or duration changed; what none of these makes fail is listed, to be looked at by a person. A check whose
//! expected value is a formula that follows the change, and that passes again, has noticed it.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode, Stdio};
use std::time::Instant;

use serde_json::Value;

use crate::verify;
use riprap_fuzz::damage::numbers;

/// What is changed: a name, the keys, and the factor on the numbers behind them.
const CHANGES: [(&str, &[&str], f64); 15] = [
    ("gravity", &["gravity", "acceleration"], 1.1),
    ("stiffness", &["normal_stiffness", "shear_stiffness", "young"], 2.0),
    ("friction", &["friction_angle", "friction_coefficient", "residual_friction_angle"], 0.8),
    ("hardly any friction", &["friction_angle", "friction_coefficient"], 0.05),
    (
        "strength",
        &["cohesion", "tension", "tensile_strength", "fracture_energy", "yield_force"],
        0.5,
    ),
    ("density", &["density"], 1.2),
    ("loads", &["force", "pressure", "traction", "moment", "mass"], 1.2),
    ("speed", &["velocity", "spin"], 1.1),
    ("damping", &["damping_ratio", "restitution", "local", "mass_damping"], 0.5),
    ("half the time", &["time", "steps"], 0.5),
    ("stress at the start", &["vertical", "in_situ.x", "in_situ.y", "k0", "stress"], 1.2),
    ("bolts", &["diameter", "bolts.stiffness", "bolts.strength", "pretension"], 0.5),
    ("water", &["level", "points", "head"], 0.8),
    // What drives over time: motions and loads in tables of their own.
    ("what drives", &["value", "constant", "to", "formula"], 1.2),
    ("sizes", &["size", "cell", "radius", "thickness", "spacing"], 1.1),
];

/// Slowest scene that is broken, s, when nothing else is asked for.
const SECONDS: f64 = 3.0;

/// `cargo xtask mutate [--seconds S] [--binary FILE] [SCENE]...`.
pub fn run(root: &Path, words: &[&str]) -> ExitCode {
    match all(root, words) {
        Ok(()) => ExitCode::SUCCESS,
        Err(why) => {
            eprintln!("{why}");
            ExitCode::FAILURE
        }
    }
}

fn all(root: &Path, words: &[&str]) -> Result<(), String> {
    let (mut seconds, mut binary, mut chosen) = (SECONDS, None, Vec::new());
    let mut words = words.iter();
    while let Some(word) = words.next() {
        match *word {
            "--seconds" => {
                let given = words.next().and_then(|n| n.parse().ok());
                seconds = given.ok_or("--seconds needs a number")?;
            }
            "--binary" => binary = Some(root.join(words.next().ok_or("--binary needs a file")?)),
            scene => chosen.push(scene.to_owned()),
        }
    }
    let binary = match binary {
        Some(binary) => binary,
        None => verify::ci_binary(root)?,
    };
    if chosen.is_empty() {
        chosen = verify::fast_scenes(root);
    }
    let (mut checks, mut blind, mut slow) = (0, 0, 0);
    for scene in &chosen {
        match broken(root, &binary, scene, seconds)? {
            None => slow += 1,
            Some(result) => {
                checks += result.len();
                for (check, noticed) in result {
                    if noticed.is_empty() {
                        blind += 1;
                        println!("{scene}: nothing makes {check:?} fail");
                    }
                }
            }
        }
    }
    println!(
        "{checks} checks of {} scenes: {blind} never fail; {slow} scenes are slower than {seconds} s",
        chosen.len() - slow
    );
    Ok(())
}

/// The changes that make each check fail.
type Noticed = BTreeMap<String, Vec<&'static str>>;

/// `None` for a scene that is too slow.
fn broken(
    root: &Path,
    binary: &Path,
    scene: &str,
    seconds: f64,
) -> Result<Option<Noticed>, String> {
    let text = std::fs::read_to_string(root.join(scene)).map_err(|e| format!("{scene}: {e}"))?;
    let copy = Copy::new(root, scene)?;
    let begun = Instant::now();
    let sound = copy.checks(binary, &text, seconds)?;
    if sound.is_empty() || begun.elapsed().as_secs_f64() > seconds {
        return Ok(None);
    }
    let mut noticed: Noticed = BTreeMap::new();
    let mut expected = BTreeMap::new();
    for check in sound.iter().filter(|c| c["status"] == "passed") {
        noticed.insert(name(check), Vec::new());
        expected.insert(name(check), check["expected"].clone());
    }
    for (what, keys, factor) in CHANGES {
        let changed = scaled(&text, keys, factor);
        if changed == text {
            continue;
        }
        // A scene that cannot be run any more, or takes ten times as long, has noticed nothing.
        for check in copy.checks(binary, &changed, 10.0 * seconds)? {
            let name = name(&check);
            // A formula that followed the change, and was met again, has held the scene to its law.
            let follows = check["status"] == "passed"
                && expected.get(&name).is_some_and(|e| *e != check["expected"]);
            if (check["status"] == "failed" || follows)
                && let Some(by) = noticed.get_mut(&name)
            {
                by.push(what);
            }
        }
    }
    Ok(Some(noticed))
}

fn name(check: &Value) -> String {
    let word = |key: &str| check[key].as_str().unwrap_or_default();
    let (case, name) = (word("case"), word("check"));
    if case.is_empty() || case == "default" { name.to_owned() } else { format!("{case}: {name}") }
}

/// A scene in a folder of its own, with the data beside it.
struct Copy {
    path: PathBuf,
}

impl Copy {
    fn new(root: &Path, scene: &str) -> Result<Self, String> {
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
        let file = original.file_name().unwrap_or_default();
        Ok(Self { path: folder.join(file) })
    }

    /// Its checks with that text; none where it cannot be run, or not in that time.
    fn checks(&self, binary: &Path, text: &str, seconds: f64) -> Result<Vec<Value>, String> {
        std::fs::write(&self.path, text).map_err(|e| format!("{}: {e}", self.path.display()))?;
        let said = self.path.with_extension("jsonl");
        let out = std::fs::File::create(&said).map_err(|e| e.to_string())?;
        let mut child = Command::new(binary)
            .args(["verify", "--json", "--jobs", "1"])
            .arg(&self.path)
            .stdin(Stdio::null())
            .stdout(out)
            .stderr(Stdio::null())
            .spawn()
            .map_err(|e| format!("{}: {e}", binary.display()))?;
        let begun = Instant::now();
        while child.try_wait().map_err(|e| e.to_string())?.is_none() {
            if begun.elapsed().as_secs_f64() > seconds {
                child.kill().map_err(|e| e.to_string())?;
                child.wait().map_err(|e| e.to_string())?;
                return Ok(Vec::new());
            }
            std::thread::sleep(std::time::Duration::from_millis(5));
        }
        let text = std::fs::read_to_string(&said).map_err(|e| e.to_string())?;
        Ok(text.lines().filter_map(|line| serde_json::from_str(line).ok()).collect())
    }
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
