//! Probes of long scenes: the state after the first steps of each phase, kept beside their rows in `docs/src/verification_probes.csv`.
//!
//! Rows of long scenes are stale when somebody writes a *Numerics* entry. A change that nobody has noticed has no entry, so every run of
//! the tests begins each long scene in all its cases, with the phases cut short, and compares the fingerprint of the state, which is the
//! same on every machine, with that of the program that made the rows. Only what moves a result in the first steps is seen: stones that are
//! poured are still in the air then.

use std::collections::BTreeMap;
use std::path::Path;
use std::process::{Command, Stdio};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Instant;

use super::basis::Now;
use super::table::{self, Row};
use crate::cut;

/// The probes.
pub const DATA: &str = "docs/src/verification_probes.csv";
const HEAD: [&str; 4] = ["scene", "case", "steps", "state"];
/// What `steps` of a new probe may be.
const LADDER: [usize; 7] = [1, 3, 10, 30, 100, 300, 1000];
/// What the steps of one probe may take beside building the model, s.
const STEPPING: f64 = 0.2;
/// What all probes of a scene may take, s; its first case may take more.
const SCENE: f64 = 2.5;

/// What stands in place of the state of a case that has no probe.
const LEFT_OUT: &str = "left out: dear, and other cases of its scene are probed";

/// A case of a scene, as its rows name both.
type Case = (String, String);

/// One probe.
#[derive(Clone, Debug, PartialEq)]
struct Probe {
    /// Steps of each phase; 0 where the case is left out.
    steps: usize,
    state: String,
}

/// All probes.
#[derive(Debug, Default, PartialEq)]
pub struct Probes(BTreeMap<Case, Probe>);

/// Cases of long scenes that have rows, in the order of the rows; of fresh ones only, where `now` is given.
fn cases(rows: &[Row], now: Option<&Now>) -> Vec<Case> {
    let mut found: Vec<Case> = Vec::new();
    for row in rows.iter().filter(|row| table::is_long(row.scene())) {
        let case = (row.scene().to_owned(), row.case().to_owned());
        if now.is_none_or(|now| row.fresh(now)) && !found.contains(&case) {
            found.push(case);
        }
    }
    found
}

impl Probes {
    /// Of the file; none where it is not there.
    ///
    /// # Errors
    /// It cannot be read, or has other columns.
    pub fn read(root: &Path) -> Result<Self, String> {
        let path = root.join(DATA);
        if !path.exists() {
            return Ok(Self::default());
        }
        let text = std::fs::read_to_string(&path).map_err(|e| format!("{DATA}: {e}"))?;
        Self::parse(&text)
    }

    fn parse(text: &str) -> Result<Self, String> {
        let mut file = csv::Reader::from_reader(text.as_bytes());
        let mut probes = BTreeMap::new();
        for record in file.records() {
            let record = record.map_err(|e| format!("{DATA}: {e}"))?;
            let line = record.position().map_or(0, csv::Position::line);
            let cells: Vec<&str> = record.iter().collect();
            let [scene, case, steps, state] = cells[..] else {
                return Err(format!("{DATA}, line {line}: other columns than {HEAD:?}"));
            };
            let steps = steps.parse();
            let steps = steps.map_err(|e| format!("{DATA}, line {line}: `steps`: {e}"))?;
            let state = state.to_owned();
            probes.insert((scene.to_owned(), case.to_owned()), Probe { steps, state });
        }
        Ok(Self(probes))
    }

    /// As the file has them.
    ///
    /// # Errors
    /// None that a probe can cause.
    pub fn text(&self) -> Result<String, String> {
        let mut out = csv::Writer::from_writer(Vec::new());
        out.write_record(HEAD).map_err(|e| e.to_string())?;
        for ((scene, case), probe) in &self.0 {
            let record = [scene, case, &probe.steps.to_string(), &probe.state];
            out.write_record(record).map_err(|e| e.to_string())?;
        }
        let bytes = out.into_inner().map_err(|e| e.to_string())?;
        String::from_utf8(bytes).map_err(|e| e.to_string())
    }

    /// Takes out what belongs to no row.
    pub fn keep(&mut self, rows: &[Row]) {
        let known = cases(rows, None);
        self.0.retain(|case, _| known.contains(case));
    }

    /// Whether each case of fresh rows has a probe, and each probe rows.
    ///
    /// # Errors
    /// What is wrong, and what to do.
    pub fn judge(&self, rows: &[Row], now: &Now) -> Result<(), String> {
        let known = cases(rows, None);
        if let Some((scene, case)) = self.0.keys().find(|case| !known.contains(case)) {
            return Err(format!(
                "{DATA} has a probe of {scene} ({case}), which has no rows; `cargo xtask verify-all --table` takes it out"
            ));
        }
        let mut claimed = cases(rows, Some(now)).into_iter();
        match claimed.find(|case| !self.0.contains_key(case)) {
            None => Ok(()),
            Some((scene, case)) => Err(format!(
                "{DATA} has no probe of {scene} ({case}): `cargo xtask verify-all --probes` makes those that are missing, with the program as it is"
            )),
        }
    }

    /// Makes the probes of `chosen` scenes anew, with as many steps as they have, and those that are missing, with as many as are cheap;
    /// `None` makes only those that are missing.
    ///
    /// # Errors
    /// A scene that cannot be begun.
    pub fn make(
        &mut self,
        (root, binary): (&Path, &Path),
        rows: &[Row],
        chosen: Option<&dyn Fn(&str) -> bool>,
    ) -> Result<(), String> {
        let mut spent: BTreeMap<String, Spent> = BTreeMap::new();
        for case in cases(rows, None) {
            let old = self.0.get(&case).map(|probe| probe.steps);
            let wanted = match chosen {
                Some(chosen) => chosen(&case.0),
                None => old.is_none(),
            };
            if !wanted || old == Some(0) {
                continue;
            }
            let run = |steps| begin(root, binary, &case, steps, "made");
            let probe = match old {
                Some(steps) => Probe { steps, state: run(steps)? },
                None => new(run, spent.entry(case.0.clone()).or_default())?,
            };
            println!("{} ({}): {} steps of each phase", case.0, case.1, probe.steps);
            self.0.insert(case, probe);
        }
        Ok(())
    }

    /// Runs the probes of all fresh rows; what differs, and how many were run.
    ///
    /// # Errors
    /// A scene that cannot be begun.
    pub fn differences(
        &self,
        (root, binary): (&Path, &Path),
        rows: &[Row],
        now: &Now,
    ) -> Result<(Vec<String>, usize), String> {
        let claimed = cases(rows, Some(now));
        let probe = |case: &Case| self.0.get(case).filter(|p| p.steps > 0).cloned();
        let due: Vec<(Case, Probe)> =
            claimed.into_iter().filter_map(|case| Some((case.clone(), probe(&case)?))).collect();
        let next = AtomicUsize::new(0);
        let work = |worker: usize| -> Result<Vec<(usize, String)>, String> {
            let mut found = Vec::new();
            loop {
                let k = next.fetch_add(1, Ordering::Relaxed);
                let Some((case, probe)) = due.get(k) else {
                    return Ok(found);
                };
                let state = begin(root, binary, case, probe.steps, &worker.to_string())?;
                if state != probe.state {
                    found.push((k, differs(case, probe.steps)));
                }
            }
        };
        let workers = std::thread::available_parallelism().map_or(1, usize::from);
        let mut found = Vec::new();
        std::thread::scope(|scope| -> Result<(), String> {
            let work = &work;
            let threads: Vec<_> = (0..workers).map(|w| scope.spawn(move || work(w))).collect();
            for thread in threads {
                found.extend(thread.join().map_err(|_| "a probe panicked".to_owned())??);
            }
            Ok(())
        })?;
        found.sort();
        Ok((found.into_iter().map(|(_, what)| what).collect(), due.len()))
    }
}

/// What is said of a probe that differs.
fn differs((scene, case): &Case, steps: usize) -> String {
    let case = if case.is_empty() { String::new() } else { format!(" ({case})") };
    format!(
        "the first {steps} steps of each phase of {scene}{case} compute something else than when its rows were made: write an entry under *Numerics* in CHANGELOG.md that \
         concerns it (how an entry begins says which scenes it concerns) and `cargo xtask verify-all --table`, or find what changed"
    )
}

/// What the new probes of a scene cost and how long they are.
#[derive(Clone, Copy, Debug, Default)]
struct Spent {
    /// Those of its first case; 0 before it.
    steps: usize,
    seconds: f64,
}

/// A new probe: of the first case of a scene as many steps as are cheap, of the others as many; none when the scene has spent its time.
fn new(run: impl Fn(usize) -> Result<String, String>, spent: &mut Spent) -> Result<Probe, String> {
    let timed = |steps| -> Result<(Probe, f64), String> {
        let begun = Instant::now();
        let state = run(steps)?;
        Ok((Probe { steps, state }, begun.elapsed().as_secs_f64()))
    };
    if spent.steps > 0 {
        let (probe, seconds) = timed(spent.steps)?;
        if spent.seconds + seconds > SCENE {
            return Ok(Probe { steps: 0, state: LEFT_OUT.to_owned() });
        }
        spent.seconds += seconds;
        return Ok(probe);
    }
    let (mut best, first) = timed(LADDER[0])?;
    spent.seconds = first;
    for steps in LADDER.into_iter().skip(1) {
        let (more, seconds) = timed(steps)?;
        if seconds > first + STEPPING {
            break;
        }
        (best, spent.seconds) = (more, seconds);
    }
    spent.steps = best.steps;
    Ok(best)
}

/// The state of a case after `steps` steps of each phase, or up to where the physics stops it.
fn begin(
    root: &Path,
    binary: &Path,
    (scene, case): &Case,
    steps: usize,
    place: &str,
) -> Result<String, String> {
    let text = std::fs::read_to_string(root.join(scene)).map_err(|e| format!("{scene}: {e}"))?;
    let out = root.join("target/probes").join(format!("{place}.run"));
    let out = out.to_string_lossy();
    let mut words = vec!["run", scene, "--out", &out, "--force", "--quiet"];
    // Of a few steps no check can be said.
    words.extend(["--threads", "1", "--set", "checks=[]"]);
    let changes = cut::words(&text, steps);
    words.extend(changes.iter().map(String::as_str));
    if !case.is_empty() {
        words.extend(["--case", case]);
    }
    let said = |words: &[&str]| {
        let mut command = Command::new(binary);
        command.args(words).current_dir(root).stdin(Stdio::null());
        command.output().map_err(|e| format!("{}: {e}", binary.display()))
    };
    let run = said(&words)?;
    let hash = said(&["hash", &out])?;
    let stopped = matches!(run.status.code(), Some(0 | 1));
    if !stopped || !hash.status.success() {
        let why = String::from_utf8_lossy(&run.stderr);
        return Err(format!("{scene} ({case}) cannot be begun: {}", why.trim()));
    }
    Ok(String::from_utf8_lossy(&hash.stdout).trim().to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    use super::super::basis::Scene;

    const TEXT: &str =
        "scene,case,steps,state\nscenes/long/b.toml,,30,a1\nscenes/long/b.toml,two,0,\n";

    #[test]
    fn a_line_a_case() {
        let probes = Probes::parse(TEXT).unwrap();
        assert_eq!(probes.0.len(), 2);
        assert_eq!(probes.text().unwrap(), TEXT);
        assert!(Probes::parse("scene,case\na,b\n").is_err());
        assert!(Probes::parse("scene,case,steps,state\na,b,many,c\n").is_err());
    }

    #[test]
    fn a_new_probe_has_as_many_steps_as_are_cheap_and_a_dear_scene_few_cases() {
        let run = |steps| Ok(format!("after {steps}"));
        let mut spent = Spent::default();
        let first = new(run, &mut spent).unwrap();
        assert_eq!(first.state, format!("after {}", first.steps));
        assert_eq!(spent.steps, first.steps);
        assert_eq!(new(run, &mut spent).unwrap(), first);
        spent.seconds = 2.0 * SCENE;
        assert_eq!(new(run, &mut spent).unwrap().steps, 0);
        let slow = |steps| {
            if steps > 3 {
                std::thread::sleep(std::time::Duration::from_secs_f64(1.5 * STEPPING));
            }
            run(steps)
        };
        assert_eq!(new(slow, &mut Spent::default()).unwrap().steps, 3);
    }

    fn now(numerics: usize) -> Now {
        let scene = Scene {
            name: "scenes/long/b.toml".to_owned(),
            title: String::new(),
            digest: "d".to_owned(),
            numerics,
        };
        Now { scenes: vec![scene] }
    }

    fn rows() -> Vec<Row> {
        let check = |case: &str| serde_json::json!({ "scene": "scenes/long/b.toml", "case": case, "check": "x", "status": "passed" });
        table::merge(&[], &[check(""), check("two")], &now(3), ["day", "abc"])
    }

    #[test]
    fn fresh_rows_have_probes_and_probes_have_rows() {
        let mut probes = Probes::parse(TEXT).unwrap();
        assert_eq!(probes.judge(&rows(), &now(3)), Ok(()));
        let none = Probes::default();
        assert!(none.judge(&rows(), &now(3)).unwrap_err().contains("--probes"));
        // Stale rows claim nothing.
        assert_eq!(none.judge(&rows(), &now(4)), Ok(()));
        assert!(probes.judge(&rows()[..1], &now(3)).unwrap_err().contains("(two)"));
        probes.keep(&rows()[..1]);
        assert_eq!(probes.judge(&rows()[..1], &now(3)), Ok(()));
    }

    #[cfg(unix)]
    #[test]
    fn another_state_without_an_entry_is_told() {
        use std::os::unix::fs::PermissionsExt;
        let root = std::env::temp_dir().join(format!("riprap_probe_{}", std::process::id()));
        std::fs::create_dir_all(root.join("scenes/long")).unwrap();
        std::fs::write(root.join("scenes/long/b.toml"), "riprap = 1\n").unwrap();
        let program = |name: &str, script: &str| {
            let path = root.join(name);
            std::fs::write(&path, format!("#!/bin/sh\n{script}\n")).unwrap();
            std::fs::set_permissions(&path, std::fs::Permissions::from_mode(0o755)).unwrap();
            path
        };
        let same = program("same", "[ $1 = hash ] && echo a1; exit 0");
        let other = program("other", "[ $1 = hash ] && echo a2; exit 0");
        let broken = program("broken", "echo no key >&2; exit 2");
        let probes = Probes::parse(TEXT).unwrap();
        let run = |program: &Path, numerics| {
            probes.differences((&root, program), &rows(), &now(numerics))
        };
        // The case `two` is left out.
        assert_eq!(run(&same, 3), Ok((Vec::new(), 1)));
        let (told, _) = run(&other, 3).unwrap();
        assert!(told[0].contains("the first 30 steps of each phase of scenes/long/b.toml compute"));
        assert_eq!(run(&other, 4), Ok((Vec::new(), 0)));
        assert!(run(&broken, 3).unwrap_err().contains("no key"));
        std::fs::remove_dir_all(&root).unwrap();
    }
}
