//! Run-out of the rocks of runs: where each ends, how high and how fast it goes, who passes a line.
//!
//! Read from the frames of finished runs, one or many ([`study`](super::study)): the rocks of all of them are one population. Between
//! two frames a rock goes along the cubic that has its places and velocities at both: the parabola of free flight exactly, whatever their
//! distance. An impact between two frames is not seen, so frames should be denser than bounces.
//!
//! * The rocks are the blocks that are free in the first frame, those of a group if one is given; what is held is the ground.
//! * Run-out is the horizontal distance from the first to the last place of the centroid, and the angle of travel that of the line
//!   from the first place to the last below the horizon (the energy line of Heim 1932).
//! * Heights are of the centroid above the ground straight below it; energies are those of translation, with densities of the scene.

pub(in crate::run) mod ground;
mod record;
#[cfg(test)]
mod tests;
pub(in crate::run) mod track;

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use serde::Serialize;

use crate::Vec3;
use crate::record::manifest::ManifestError;
use crate::record::names::NamesError;
use crate::record::vtu::ReadError;
use crate::scenario::units::{self, Dim};
use ground::Ground;
use track::{Run, Track};

/// What is asked for.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Rules {
    /// Group of the rocks; `None` takes all free blocks.
    pub of: Option<String>,
    /// Lines whose passing is told.
    pub lines: Vec<Line>,
}

/// A vertical wall that rocks pass: a road, a fence, a property line.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    /// Name.
    pub name: String,
    /// A point of it, m.
    pub from: [f64; 2],
    /// Its other end in the plan, m; `None` is all along y, at an x.
    pub to: Option<[f64; 2]>,
}

/// What came of one rock.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Rock {
    /// Run folder.
    pub run: String,
    /// Name of the block.
    pub name: String,
    /// kg, in the plane kg/m; `None` where the scene cannot be read.
    pub mass: Option<f64>,
    /// Centroid in the first frame, m.
    pub start: [f64; 3],
    /// Centroid in the last frame that has it, m.
    pub end: [f64; 3],
    /// Horizontal distance between the two, m.
    pub runout: f64,
    /// Height lost, m.
    pub drop: f64,
    /// Angle of the line from start to end below the horizon, deg.
    pub travel_angle: f64,
    /// Largest speed, m/s.
    pub max_speed: f64,
    /// Largest height above the ground, m; `None` where it was never above any.
    pub max_height: Option<f64>,
    /// Largest kinetic energy of translation, J, in the plane J/m.
    pub max_energy: Option<f64>,
    /// Speed in the last frame, m/s.
    pub end_speed: f64,
}

/// A rock passes a line for the first time.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Passage {
    /// Name of the line.
    pub line: String,
    /// Run folder.
    pub run: String,
    /// Name of the block.
    pub rock: String,
    /// Model time, s.
    pub time: f64,
    /// Place of the centroid, m.
    pub at: [f64; 3],
    /// Height above the ground, m.
    pub height: Option<f64>,
    /// m/s.
    pub speed: f64,
    /// Kinetic energy of translation, J, in the plane J/m.
    pub energy: Option<f64>,
}

/// Values of some rocks by rank: half of them and nine in ten have no more, and the largest.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Ranks {
    /// Median.
    pub half: f64,
    /// 90th percentile.
    pub most: f64,
    /// Largest.
    pub largest: f64,
}

/// What came of a line.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Reached {
    /// Name.
    pub line: String,
    /// Rocks that passed it.
    pub passed: usize,
    /// Of how many.
    pub rocks: usize,
    /// Their share, the probability of reaching the line.
    pub share: f64,
    /// Interval of that probability with 95 % confidence (Wilson 1927).
    pub interval: [f64; 2],
    /// Heights above the ground, m.
    pub height: Option<Ranks>,
    /// Speeds, m/s.
    pub speed: Option<Ranks>,
    /// Energies of translation, J, in the plane J/m.
    pub energy: Option<Ranks>,
}

/// What was found.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Answer {
    /// Number of runs.
    pub runs: usize,
    /// Whether they are in the plane.
    pub planar: bool,
    /// Longest time between two frames, s.
    pub frames_every: f64,
    /// The rocks, by run and number.
    pub rocks: Vec<Rock>,
    /// First passages, by line, run and number.
    pub passages: Vec<Passage>,
    /// The lines.
    pub lines: Vec<Reached>,
    /// Run-outs, m.
    pub runout: Ranks,
    /// Least angle of travel, deg.
    pub least_angle: f64,
    /// Rocks still faster than [`MOVING`] at the end.
    pub moving: usize,
}

/// Speed (m/s) from which a rock counts as still moving.
pub const MOVING: f64 = 0.2;

/// Why there is no answer.
#[derive(Debug, thiserror::Error)]
pub enum RunoutError {
    /// Nothing to read.
    #[error(
        "{} holds no run; give run folders, or a folder of `riprap sweep` or `riprap monte-carlo`", .0.display()
    )]
    NoRun(PathBuf),
    /// Too little was recorded.
    #[error(
        "{} has {frames} frames; run-out needs two and more: give the scene [[outputs]] frames = {{ every = \"0.1 s\" }}", folder.display()
    )]
    Frames {
        /// The run.
        folder: PathBuf,
        /// How many there are.
        frames: usize,
    },
    /// No such block or group.
    #[error("{}: {what}", folder.display())]
    Group {
        /// The run.
        folder: PathBuf,
        /// What is wrong.
        what: String,
    },
    /// Nothing is free.
    #[error("{} has no free block{}", folder.display(), of.as_ref().map_or(String::new(), |g| format!(" in the group `{g}`")))]
    NoRock {
        /// The run.
        folder: PathBuf,
        /// Group that was asked for.
        of: Option<String>,
    },
    /// Gravity that is not vertical.
    #[error(
        "gravity of {} is not vertical, so that horizontal has no meaning; turn the scene instead of gravity", .0.display()
    )]
    Tilted(PathBuf),
    /// Runs in the plane and in space, or a line of the other kind.
    #[error("{0}")]
    Mixed(String),
    /// The frames.
    #[error(transparent)]
    Frame(#[from] ReadError),
    /// The manifest.
    #[error(transparent)]
    Manifest(#[from] ManifestError),
    /// The names.
    #[error(transparent)]
    Names(#[from] NamesError),
}

impl Line {
    /// Reads `NAME=X` or `NAME=X,Y..X,Y`, lengths with units.
    ///
    /// # Errors
    /// What is wrong with it, in words.
    pub fn read(text: &str) -> Result<Self, String> {
        let wrong = || {
            format!(
                "{text:?} is not a line; write NAME=X, for example 'road=40 m', or two points of the plan: 'fence=40 m,-10 m..45 m,10 m'"
            )
        };
        let length = |text: &str| match units::parse(text.trim()) {
            Ok((value, Dim::LENGTH)) if value.is_finite() => Ok(value),
            Ok(_) | Err(_) => Err(wrong()),
        };
        let (name, place) = text.split_once('=').ok_or_else(wrong)?;
        let name = name.trim().to_owned();
        if name.is_empty() {
            return Err(wrong());
        }
        let Some((from, to)) = place.split_once("..") else {
            return Ok(Self { name, from: [length(place)?, 0.0], to: None });
        };
        let point = |text: &str| {
            let (x, y) = text.split_once(',').ok_or_else(wrong)?;
            Ok::<_, String>([length(x)?, length(y)?])
        };
        let (from, to) = (point(from)?, point(to)?);
        if from == to {
            return Err(format!("the two ends of the line `{name}` are one point"));
        }
        Ok(Self { name, from, to: Some(to) })
    }

    /// Horizontal unit normal, and what a place has along the line: 0 at its beginning, 1 at its end.
    fn side(&self, p: Vec3) -> (f64, f64) {
        let [x, y] = self.from;
        let Some([to_x, to_y]) = self.to else {
            return (p.x - x, 0.5);
        };
        let (dx, dy) = (to_x - x, to_y - y);
        let square = dx * dx + dy * dy;
        let (px, py) = (p.x - x, p.y - y);
        ((px * dy - py * dx) / square.sqrt(), (px * dx + py * dy) / square)
    }
}

/// Run-out of the rocks of runs. A folder that holds runs stands for all of them.
///
/// # Errors
/// Folders without runs or with too few frames, unknown groups, runs without free blocks, gravity that is not vertical.
pub fn runout(folders: &[PathBuf], rules: &Rules) -> Result<Answer, RunoutError> {
    let mut names = rules.lines.iter().map(|line| line.name.as_str()).collect::<Vec<_>>();
    names.sort_unstable();
    if let Some(twice) = names.windows(2).find(|pair| pair[0] == pair[1]) {
        return Err(RunoutError::Mixed(format!("two lines are called `{}`", twice[0])));
    }
    let mut runs = Vec::new();
    let mut read = BTreeSet::new();
    for folder in folders {
        for found in track::runs_in(folder)? {
            if !read.insert(std::fs::canonicalize(&found).unwrap_or_else(|_| found.clone())) {
                let text =
                    format!("{} is given twice: its rocks would count twice", found.display());
                return Err(RunoutError::Mixed(text));
            }
            runs.push(Run::read(&found, rules)?);
        }
    }
    let planar = runs.first().is_some_and(|run| run.planar);
    if runs.iter().any(|run| run.planar != planar) {
        return Err(RunoutError::Mixed("some runs are in the plane, some in space".to_owned()));
    }
    if let Some(line) = rules.lines.iter().find(|line| planar && line.to.is_some()) {
        let name = &line.name;
        return Err(RunoutError::Mixed(format!(
            "the line `{name}` has two points, but the run is in the plane: write {name}=X"
        )));
    }
    let rocks: Vec<Rock> =
        (runs.iter()).flat_map(|run| run.tracks.iter().map(|track| rock(run, track))).collect();
    let passages: Vec<Passage> = (rules.lines.iter())
        .flat_map(|line| runs.iter().map(move |run| (line, run)))
        .flat_map(|(line, run)| run.tracks.iter().filter_map(move |t| passage(line, run, t)))
        .collect();
    let lines = rules.lines.iter().map(|line| reached(line, &passages, rocks.len())).collect();
    let ways = rocks.iter().map(|rock| rock.runout).collect();
    Ok(Answer {
        runs: runs.len(),
        planar,
        frames_every: runs.iter().map(|run| run.longest).fold(0.0, f64::max),
        runout: Ranks::of(ways).unwrap_or(Ranks { half: 0.0, most: 0.0, largest: 0.0 }),
        least_angle: rocks.iter().map(|rock| rock.travel_angle).fold(f64::INFINITY, f64::min),
        moving: rocks.iter().filter(|rock| rock.end_speed > MOVING).count(),
        rocks,
        passages,
        lines,
    })
}

/// What came of one rock.
fn rock(run: &Run, track: &Track) -> Rock {
    let (first, last) = (track.first(), track.last());
    let way = last.place - first.place;
    let runout = (way.x * way.x + way.y * way.y).sqrt();
    let mut highest: Option<f64> = None;
    let mut fastest = 0.0_f64;
    for (place, velocity) in track.samples() {
        fastest = fastest.max(velocity.length());
        if let Some(height) = run.ground.below(place) {
            highest = Some(highest.map_or(height, |most| most.max(height)));
        }
    }
    Rock {
        run: run.name.clone(),
        name: track.name.clone(),
        mass: track.mass,
        start: run.shown(first.place),
        end: run.shown(last.place),
        runout,
        drop: -way.z,
        travel_angle: libm::atan2(-way.z, runout).to_degrees(),
        max_speed: fastest,
        max_height: highest,
        max_energy: track.mass.map(|mass| 0.5 * mass * fastest * fastest),
        end_speed: last.velocity.length(),
    }
}

/// The first time that a rock passes a line.
fn passage(line: &Line, run: &Run, track: &Track) -> Option<Passage> {
    let (time, place, velocity) = track.passes(|p| line.side(p))?;
    let speed = velocity.length();
    Some(Passage {
        line: line.name.clone(),
        run: run.name.clone(),
        rock: track.name.clone(),
        time,
        at: run.shown(place),
        height: run.ground.below(place),
        speed,
        energy: track.mass.map(|mass| 0.5 * mass * speed * speed),
    })
}

fn reached(line: &Line, passages: &[Passage], rocks: usize) -> Reached {
    let here: Vec<&Passage> = passages.iter().filter(|p| p.line == line.name).collect();
    let passed = here.len();
    let all = |get: fn(&Passage) -> Option<f64>| {
        Ranks::of(here.iter().filter_map(|passage| get(passage)).collect())
    };
    Reached {
        line: line.name.clone(),
        passed,
        rocks,
        share: passed as f64 / rocks as f64,
        interval: wilson(passed, rocks),
        height: all(|p| p.height),
        speed: all(|p| Some(p.speed)),
        energy: all(|p| p.energy),
    }
}

/// Interval with 95 % confidence of a probability of which `hits` of `count` are known.
///
/// Source: E. B. Wilson, J. Am. Stat. Assoc. 22 (1927) 209-212.
fn wilson(hits: usize, count: usize) -> [f64; 2] {
    const Z: f64 = 1.959_963_985;
    let n = count as f64;
    let share = hits as f64 / n;
    let scale = 1.0 + Z * Z / n;
    let middle = (share + 0.5 * Z * Z / n) / scale;
    let half = Z / scale * (share * (1.0 - share) / n + 0.25 * Z * Z / (n * n)).sqrt();
    [(middle - half).max(0.0), (middle + half).min(1.0)]
}

impl Ranks {
    /// Of some values; `None` of nothing.
    fn of(mut values: Vec<f64>) -> Option<Self> {
        values.sort_by(f64::total_cmp);
        // As the fields `group.runout_50` and `group.runout_90` count.
        let rank = |share: f64| {
            let last = (share * values.len() as f64).ceil() as usize;
            values.get(last.max(1) - 1).copied()
        };
        Some(Self { half: rank(0.5)?, most: rank(0.9)?, largest: rank(1.0)? })
    }
}

/// Name of a run in tables: that of its folder.
fn name_of(folder: &Path) -> String {
    folder
        .file_name()
        .map_or_else(|| folder.display().to_string(), |n| n.to_string_lossy().into_owned())
}
