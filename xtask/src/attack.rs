//! `cargo xtask attack`: what careless and hostile input, kills, threads and speed do to the program, as a table.
//!
//! The program is attacked from outside, as a person or a script would: a process a try. A try fails if the process panics, dies by a
//! signal, leaves with a code that the manual does not have, or gives a wrong answer in silence (attack by attack, see [`ATTACKS`]).
//! Each attack has a seed of its own, so that a failure comes again; the input that failed is kept in `target/attack`.

mod clocks;
mod disks;
mod faults;
mod files;
mod laws;
pub mod process;
mod rock;
mod soak;

use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use crate::shell::{self, Counts};
use crate::steps::Outcome;
use crate::verify;
use process::{Ended, Program};
use riprap_fuzz::damage::Chance;

/// Tries of each attack on files, when nothing else is asked for: about ten minutes in all.
const TRIES: usize = 1500;
/// Longest that a run of an attack on runs may take: more than that is a failure.
const LONG: Duration = Duration::from_secs(300);
const PAGE: &str = "docs/src/reliability.md";

/// What an attack has found.
#[derive(Clone, Debug, Default)]
pub struct Found {
    pub tries: usize,
    /// Refused, or ended with an error that says what is wrong.
    pub refused: usize,
    /// Stopped by the attacker: it worked longer than the limit, which is no fault of a large model.
    pub slow: usize,
    pub failures: Vec<String>,
}

/// What attacks need.
pub struct Field<'a> {
    pub root: &'a Path,
    pub program: &'a Program,
    /// Where they work.
    pub folder: PathBuf,
    /// Tries for an attack on files; the others take a share that suits what one try costs.
    pub tries: usize,
}

impl Field<'_> {
    /// Whether this is the short form of CI.
    fn few(&self) -> bool {
        self.tries < 100
    }

    fn write(&self, name: &str, bytes: impl AsRef<[u8]>) -> Result<(), String> {
        write(&self.folder.join(name), bytes)
    }

    /// Runs a scene into `a.run` on one thread; how it ended.
    fn ran(&self, scene: &str) -> Result<Ended, String> {
        self.write("t.toml", scene)?;
        let words = ["run", "t.toml", "--out", "a.run", "--force", "--threads", "1", "--quiet"];
        self.program.run_within(&self.folder, &words, LONG)
    }

    /// The last value of the history of that run.
    fn last(&self) -> Result<f64, String> {
        let path = self.folder.join("a.run/histories.csv");
        let table = read_text(&path)?;
        let cell = table.lines().last().and_then(|l| l.rsplit(',').next());
        cell.and_then(|cell| cell.parse().ok())
            .ok_or_else(|| format!("{}: no number at its end", path.display()))
    }

    /// Keeps the scene that ran last, which failed.
    fn keep(&self, name: &str) {
        let _ = std::fs::copy(self.folder.join("t.toml"), self.folder.join(format!("{name}.toml")));
    }

    /// Lists of two runs that differ, and whether their states do.
    fn differ(&self, runs: [&str; 2]) -> Result<Vec<&'static str>, String> {
        let hash = |run: &str| self.program.answer(&self.folder, &["hash", run]);
        let mut differ = if hash(runs[0])? == hash(runs[1])? { vec![] } else { vec!["state"] };
        let lists = ["histories.csv", "energy.csv", "events.jsonl", "run.pvd"];
        differ.extend(lists.iter().filter(|list| {
            let [a, b] = runs.map(|run| std::fs::read(self.folder.join(run).join(list)).ok());
            a != b
        }));
        Ok(differ)
    }
}

fn write(path: &Path, bytes: impl AsRef<[u8]>) -> Result<(), String> {
    std::fs::write(path, bytes).map_err(|e| format!("{}: {e}", path.display()))
}

fn read_text(path: &Path) -> Result<String, String> {
    std::fs::read_to_string(path).map_err(|e| format!("{}: {e}", path.display()))
}

struct Attack {
    name: &'static str,
    /// What is done, and what counts as a failure.
    about: &'static str,
    run: fn(&Field<'_>, &mut Chance) -> Result<Found, String>,
}

const ATTACKS: [Attack; 14] = [
    Attack {
        name: "scenes",
        about: "scene files of this repository with a number in place of which stands nan, inf, 1e308, -1, 0, 1e-320, 10^18 or their kin, or with bytes, lines and words changed; \
                `riprap check`, and what it takes for three steps in `riprap run`. Also a failure: exit 0 with energies that are not numbers",
        run: files::scenes,
    },
    Attack {
        name: "inputs",
        about: "damaged meshes, surfaces, grids, tables and drawings that a scene reads (msh, tess, stl, dxf, asc, csv); `riprap check`",
        run: files::inputs,
    },
    Attack {
        name: "run folders",
        about: "one frame, table, list or manifest of a run damaged; `riprap plot`",
        run: files::run_folders,
    },
    Attack {
        name: "kills",
        about: "runs killed (SIGKILL) at random instants and resumed, in the plane, with rigid and with deformable blocks; a try is a kill. Failure: another \
                state, history or list at the end than without kills",
        run: faults::kills,
    },
    Attack {
        name: "threads",
        about: "scenes on 1 to 8 threads. Failure: another state at the end than on one thread",
        run: faults::threads,
    },
    Attack {
        name: "speed",
        about: "a 1 m block against a fixed 1 m floor, 1 MPa/m to 10 GPa/m, 1 to 300 m/s, in the plane and in space. Failure: it is below the floor and the run \
                ends with exit 0",
        run: faults::speed,
    },
    Attack {
        name: "full disks",
        about: "runs on a disk of 16 to 176 kB that fills up, resumed when there is room. Failure: an end without `could not write` and exit 3, another state, \
                history or list than on a large disk",
        run: disks::full,
    },
    Attack {
        name: "clocks",
        about: "runs whose clock jumps by hours and decades, forward and back, in the plane, with rigid and with deformable blocks. Failure: another exit code than 0, \
                another state, history or list than with a clock that goes on",
        run: clocks::jump,
    },
    Attack {
        name: "two laws",
        about: "every scene in the plane under `riprap compare`, the plain case under both normal laws. Those in a folder `long` or `bench`, and those that take more than \
                30 s (counted under *over*), with each phase ended after 3000 steps, or ten or a hundred times as many until something has met, and gravity there at once. \
                Failure: a stop, an error, another exit code than 0; nothing has met",
        run: laws::two,
    },
    Attack {
        name: "jointed rock",
        about: "rock in space cut at random by two to four joint sets, by disks or into cells, soft and stiff, smooth and rough, that settles and is excavated, slowly and at \
                once: two phases of 200 steps. Failure: a stop",
        run: rock::jointed,
    },
    Attack {
        name: "thin blocks",
        about: "layers of 1 and 10 cm and a prop of 30 cm between large blocks, 1 MPa/m to 100 GPa/m, joined and 1 mm apart, in the plane and in space. Failure: the roof sinks \
                by more than the thickness and the run ends with exit 0",
        run: rock::thin,
    },
    Attack {
        name: "folded blocks",
        about: "columns of deformable blocks of 2 kPa to 100 MPa under their weight, with both measures of strain, slowly and at once. Failure: the top is below the foot and the \
                run ends with exit 0",
        run: rock::folded,
    },
    Attack {
        name: "forces",
        about: "a block that gravity begins to pull on in a second phase, or that is released in one, in the plane and in space. Failure: another fall than g t^2/2",
        run: rock::forces,
    },
    Attack {
        name: "long run",
        about: "a run that never ends beside a viewer that is asked every ten seconds what a browser asks; a try is ten seconds. Failure: the run ends, a \
                question is not answered, memory grows by 5 % or descriptors by one over the last quarter",
        run: soak::soak,
    },
];

/// Attacks that CI leaves out: tests of the command line kill runs too, and a long run takes long.
const NOT_IN_CI: [&str; 2] = ["kills", "long run"];

/// `cargo xtask attack [--tries N] [--binary FILE] [--page] [ATTACK]...`: whether nothing failed.
pub fn run(root: &Path, words: &[&str]) -> Result<bool, String> {
    let mut chosen = words.to_vec();
    let tries = shell::number(&mut chosen, "--tries")?.map_or(TRIES, |n| n as usize);
    let program = Program::new(&verify::chosen_binary(root, &mut chosen)?);
    let page = chosen.iter().position(|w| *w == "--page").map(|at| chosen.remove(at)).is_some();
    if let Some(wrong) = chosen.iter().find(|c| ATTACKS.iter().all(|a| a.name != **c)) {
        let names: Vec<&str> = ATTACKS.iter().map(|a| a.name).collect();
        return Err(format!("there is no attack {wrong:?}; there are: {}", names.join(", ")));
    }
    let rows = attack(root, &program, tries, &chosen)?;
    if page {
        let version = program.answer(root, &["--version"])?;
        std::fs::write(root.join(PAGE), text(root, &rows, tries, &version))
            .map_err(|e| format!("{PAGE}: {e}"))?;
        println!("wrote {PAGE}");
    }
    let Counts { passed, failed, .. } = counts(&rows);
    println!("{passed} passed, {failed} failed, 0 skipped");
    Ok(failed == 0)
}

fn counts(rows: &[Row]) -> Counts {
    let failed: usize = rows.iter().map(|(_, found, _)| found.failures.len()).sum();
    let tries: usize = rows.iter().map(|(_, found, _)| found.tries).sum();
    Counts { passed: tries.saturating_sub(failed) as u64, failed: failed as u64, skipped: 0 }
}

type Row = (&'static Attack, Found, f64);

/// Carries out all attacks, or those chosen.
fn attack(
    root: &Path,
    program: &Program,
    tries: usize,
    chosen: &[&str],
) -> Result<Vec<Row>, String> {
    let kept = root.join("target/attack");
    let mut rows = Vec::new();
    for (k, attack) in ATTACKS.iter().enumerate() {
        if !chosen.is_empty() && !chosen.contains(&attack.name) {
            continue;
        }
        let folder = kept.join(attack.name.replace(' ', "_"));
        let _ = std::fs::remove_dir_all(&folder);
        std::fs::create_dir_all(&folder).map_err(|e| format!("{}: {e}", folder.display()))?;
        let field = Field { root, program, folder, tries };
        let begun = Instant::now();
        let found = (attack.run)(&field, &mut Chance::new(k as u64 + 1))?;
        let seconds = begun.elapsed().as_secs_f64();
        println!(
            "{:<12} {:>6} tries, {:>6} refused, {:>3} slow, {:>3} failures, {seconds:.0} s",
            attack.name,
            found.tries,
            found.refused,
            found.slow,
            found.failures.len()
        );
        for failure in &found.failures {
            println!("  FAILED  {failure}");
        }
        rows.push((attack, found, seconds));
    }
    Ok(rows)
}

/// The page.
fn text(root: &Path, rows: &[Row], tries: usize, version: &str) -> String {
    let mut text = format!(
        "# Reliability\n\nWhat careless and hostile input, kills, threads and speed do to riprap. This page is written by `cargo xtask attack --page`; the row of each attack \
         comes from the run of {} with {version} (`--tries {tries}`, one machine, seeds as in `xtask/src/attack.rs`). CI runs a short form of the same attacks.\n\n\
         A try is a process of its own. It fails if it panics, dies by a signal, leaves with a code that [the manual](cli.md) does not have, or is wrong in silence as the \
         row says. Models that are still being worked on after {} s are stopped and counted apart: a number may ask for a large model.\n\n\
         | attack | what is done | tries | refused or stopped with a reason | over {} s | failures |\n|---|---|---|---|---|---|\n",
        verify::this_run(root).join(" "),
        process::LIMIT.as_secs(),
        process::LIMIT.as_secs(),
    );
    for (attack, found, _) in rows {
        text += &format!(
            "| {} | {} | {} | {} | {} | {} |\n",
            attack.name,
            attack.about,
            found.tries,
            found.refused,
            found.slow,
            found.failures.len()
        );
    }
    text + "\nA failure found is cured with a test of its own; what failed lies in `target/attack` after the run. Not attacked here: the viewer's server (its tests do), the Python \
            package, and forged checkpoints whose checksum is right: they belong to whoever wrote them.\n"
}

/// The step `attack` of CI: a few tries of each attack but those of [`NOT_IN_CI`]. Under two laws every scene is begun, for a hundred
/// steps of each phase.
pub fn step(root: &Path) -> Result<Outcome, String> {
    const SMOKE: usize = 25;
    let program = Program::new(&verify::ci_binary(root)?);
    let names = ATTACKS.iter().map(|a| a.name);
    let chosen: Vec<&str> = names.filter(|name| !NOT_IN_CI.contains(name)).collect();
    Ok(Outcome::Counted(counts(&attack(root, &program, SMOKE, &chosen)?)))
}
