//! What a blaster asks of a run: muckpile, swell, throw, fragments beside Kuz-Ram, back-break, crater, flyrock, gas, energy.
//!
//! Read from the run folder alone: first and last frame, `fragments.csv`, `events.jsonl`, `energy.csv`, `manifest.json`.
//!
//! * **Thrown** is a free block whose centroid lies farther from its place at the start than half the edge of the cube of its volume, or than
//!   a given length. All others, held or not, are the ground that the pile lies on: a pile needs no fixed floor.
//! * The **pile** is looked at from above, on a grid: its height in a cell is that of the highest thrown block over the ground below it. Volume of the pile over
//!   that of its blocks is the swell; hollows below the upper surface count, as in a survey.
//! * The **crater** (on a bench: what is missing) are the cells whose surface lies lower than at the start, by half a cell at least. What has fallen back
//!   counts, which is the apparent crater; with a last frame at rest it is that at rest.
//! * **Along** is the mean direction of the throw, or a given one. The last row is the charge that is farthest back in it; back-break is how far behind
//!   it blocks were thrown, damage how far behind it joints have failed, by centroids at the start.

mod energy;
mod pile;
mod record;
mod sieve;
#[cfg(test)]
mod tests;

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use serde::Serialize;

use super::runout::track;
use super::runout::{MOVING, RunoutError};
use crate::Vec3;
use crate::record::frame::Frame;
use crate::record::manifest::{Gas, Manifest, ManifestError};
use crate::record::names::{Names, NamesError};
use crate::record::table::TableError;
use crate::record::vtu::{ReadError, Wanted, read_blocks, read_pvd};
use crate::scenario::units::{self, Dim};

pub use energy::{Part, Partition};
pub use pile::{Crater, Pile, Station};
pub use sieve::{Fragments, KuzRam};

/// Rock factors of Kuz-Ram (Cunningham 2005).
const ROCK_FACTORS: [f64; 2] = [0.8, 22.0];
/// Exponents of the curve of fragments: measured ones lie between 0.7 and 2.
const UNIFORMITIES: [f64; 2] = [0.3, 5.0];

/// What is asked for.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Rules {
    /// Way from which on a block counts as thrown, m; `None` is half the edge of the cube of its volume.
    pub moved: Option<f64>,
    /// Direction of the throw in the plan; `None` is the mean one.
    pub along: Option<[f64; 2]>,
    /// Cell of the grid, m; `None` is a quarter of the edge of the cube of the mean thrown block.
    pub cell: Option<f64>,
    /// The Kuz-Ram curve to stand beside the fragments; `None` is without.
    pub kuz_ram: Option<Pattern>,
    /// Group, block or condition of both whose blocks alone make the pile: all others are ground. `None` is all.
    pub of: Option<String>,
}

/// What Kuz-Ram needs of a pattern.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pattern {
    /// Rock factor A, 0.8 to 22.
    pub rock_factor: f64,
    /// Explosive over the rock that it breaks, kg/m3; `None` is that of the run: all charges over all thrown rock.
    pub powder_factor: Option<f64>,
    /// Charge of a hole, kg; `None` is the mean one of the run.
    pub charge: Option<f64>,
    /// Strength by weight relative to ANFO, %.
    pub strength: f64,
    /// Uniformity n; `None` gives the median alone.
    pub uniformity: Option<f64>,
}

/// A block in the last frame.
#[derive(Clone, Debug)]
struct Piece {
    number: u32,
    name: String,
    start: Vec3,
    place: Vec3,
    speed: f64,
    volume: f64,
    mass: Option<f64>,
    broken: f64,
    held: bool,
    thrown: bool,
    points: Vec<Vec3>,
    faces: Vec<Vec<u32>>,
}

/// How far rock was thrown, shares by volume.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Throw {
    /// Number of thrown blocks that are still there.
    pub blocks: usize,
    /// Their volume, m3.
    pub volume: f64,
    /// Their mass, kg; `None` where the scene cannot be read.
    pub mass: Option<f64>,
    /// Way of their common centroid, m.
    pub shift: [f64; 3],
    /// Direction of the throw in the plan.
    pub along: [f64; 2],
    /// Horizontal way that half of the volume has not exceeded, m.
    pub half: f64,
    /// The same of nine tenths.
    pub most: f64,
    /// The block that has gone farthest.
    pub farthest: Flyer,
    /// The largest of the blocks that have gone farther than nine tenths of the volume.
    pub largest_far: Flyer,
    /// Blocks faster than 0.2 m/s: not at rest.
    pub moving: usize,
    /// Blocks that have left the model (`phases.*.leavers`), and their mass, kg.
    pub left: (usize, f64),
}

/// A block that has flown far.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Flyer {
    /// Its name.
    pub block: String,
    /// Horizontal way, m.
    pub way: f64,
    /// Horizontal distance from the nearest charge, m; `None` without charges.
    pub from_charge: Option<f64>,
    /// Edge of the cube of its volume, m.
    pub size: f64,
    /// kg.
    pub mass: Option<f64>,
}

/// Rock behind the last row, m; 0 where there is none.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Behind {
    /// Farthest thrown block.
    pub back_break: f64,
    /// Farthest block that no joint connects to the largest of what stays; `None` without `fragment_blocks.csv`.
    pub loose: Option<f64>,
    /// Farthest block with a failed point of a joint that it still has.
    pub damaged: f64,
}

/// What was found.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Answer {
    /// Run folder.
    pub run: String,
    /// Time of the last frame, s.
    pub time: f64,
    /// `None` where nothing was thrown.
    pub throw: Option<Throw>,
    /// The pile; `None` where nothing was thrown.
    pub pile: Option<Pile>,
    /// `None` where the surface is nowhere lower than before.
    pub crater: Option<Crater>,
    /// Behind the last row; `None` without charges, or where nothing was thrown.
    pub behind: Option<Behind>,
    /// Fragments with a thrown block; `None` without `fragments.csv`.
    pub fragments: Option<Fragments>,
    /// The Kuz-Ram curve, if asked for.
    pub kuz_ram: Option<KuzRam>,
    /// Gas that may enter cracks.
    pub gas: Option<Gas>,
    /// Where the energy went; `None` without rows in `energy.csv`.
    pub energy: Option<Partition>,
}

/// Why there is no answer.
#[derive(Debug, thiserror::Error)]
pub enum MuckpileError {
    /// No run, or its frames.
    #[error(transparent)]
    Run(#[from] RunoutError),
    /// Of the plane.
    #[error("{} is in the plane; a muckpile is read in [space.spatial]", .0.display())]
    Planar(PathBuf),
    /// No such group.
    #[error("{}: {}", .0.display(), .1)]
    Of(PathBuf, String),
    /// Several runs in a folder.
    #[error("{} holds several runs; give one of them", .0.display())]
    Several(PathBuf),
    /// A number that cannot be.
    #[error("{what} must be above zero{help}")]
    Number {
        /// Which.
        what: &'static str,
        /// What to do.
        help: &'static str,
    },
    /// A number beyond all that was ever measured.
    #[error("{what} is {value}; it lies between {low} and {high}")]
    Range {
        /// Which.
        what: &'static str,
        /// What was given.
        value: f64,
        /// The smallest.
        low: f64,
        /// The largest.
        high: f64,
    },
    /// The frames.
    #[error(transparent)]
    Frame(#[from] ReadError),
    /// The manifest.
    #[error(transparent)]
    Manifest(#[from] ManifestError),
    /// The names.
    #[error(transparent)]
    Names(#[from] NamesError),
    /// A table.
    #[error(transparent)]
    Table(#[from] TableError),
}

/// Results of a blast of a run in space.
///
/// # Errors
/// Folders without a run or with several, runs in the plane or without frames, numbers that cannot be.
pub fn muckpile(folder: &Path, rules: &Rules) -> Result<Answer, MuckpileError> {
    rules.sound()?;
    let runs = track::runs_in(folder)?;
    let [folder] = &runs[..] else {
        return Err(MuckpileError::Several(folder.to_owned()));
    };
    let manifest = Manifest::read(folder)?;
    let list = read_pvd(&folder.join("run.pvd"))?;
    let ([first, ..], [.., last]) = (&list[..], &list[..]) else {
        return Err(RunoutError::Frames { folder: folder.clone(), frames: 0 }.into());
    };
    let column = |name: &str| {
        matches!(name, "block" | "velocity" | "displacement" | "held" | "material" | "broken_share")
    };
    let wanted = Wanted { geometry: true, column: &column };
    let before = read_blocks(&folder.join(&first.file), wanted)?;
    let after = read_blocks(&folder.join(&last.file), wanted)?;
    if after.solids.is_none() {
        return Err(MuckpileError::Planar(folder.clone()));
    }
    let names = Names::read(folder)?;
    let chosen = rules.of.as_deref().map(|of| names.chosen(of)).transpose();
    let chosen = chosen.map_err(|what| MuckpileError::Of(folder.clone(), what))?;
    let counts = |b: u32| chosen.as_ref().is_none_or(|of| of.has(b));
    let pieces = pieces(&after, &names, &track::densities(folder, &manifest), rules, &counts);
    let charges: Vec<Vec3> = manifest.sources.iter().map(|s| Vec3::from(s.centre())).collect();
    let throw = throw(&pieces, &charges, rules, left(folder));
    let along = throw.as_ref().map_or([1.0, 0.0], |throw| throw.along);
    let cell = cell(&pieces, rules);
    let start = triangles(&before, |_| true);
    let members = sieve::members(folder)?;
    let fragments = members.as_ref().and_then(|of| sieve::fragments(of, &pieces));
    let stays = members.as_ref().map(|of| sieve::largest_that_stays(of, &pieces));
    let kuz_ram = match &rules.kuz_ram {
        Some(pattern) => Some(sieve::kuz_ram(pattern, &manifest, throw.as_ref())?),
        None => None,
    };
    Ok(Answer {
        run: track_name(folder),
        time: after.time,
        pile: throw.as_ref().map(|_| pile::pile(&pieces, along, cell)),
        crater: pile::crater(&start, &pieces, cell),
        behind: throw.as_ref().and_then(|_| behind(&pieces, &charges, along, stays.as_ref())),
        fragments,
        kuz_ram,
        gas: manifest.gas,
        energy: energy::partition(folder)?,
        throw,
    })
}

impl Rules {
    /// Reads what was written: lengths (`moved`, `cell`), the direction `X,Y`, and for Kuz-Ram the rock factor, powder factor and charge of a hole with
    /// their units, strength and uniformity.
    ///
    /// # Errors
    /// What is wrong, in words.
    pub fn read(
        [moved, cell]: [Option<&str>; 2],
        along: Option<&str>,
        rock_factor: Option<f64>,
        [powder, charge]: [Option<&str>; 2],
        strength: f64,
        uniformity: Option<f64>,
    ) -> Result<Self, String> {
        let number = |text: Option<&str>, dim: Dim, like: &str| {
            let read = |text: &str| match units::parse(text.trim()) {
                Ok((value, found)) if found == dim => Ok(value),
                Ok(_) | Err(_) => Err(format!("{text:?} is not like '{like}'")),
            };
            text.map(read).transpose()
        };
        let plan = |text: &str| {
            let wrong =
                || format!("{text:?} is not a direction in the plan; write X,Y, for example '1,0'");
            let (x, y) = text.split_once(',').ok_or_else(wrong)?;
            let part = |text: &str| text.trim().parse::<f64>().map_err(|_| wrong());
            Ok::<_, String>([part(x)?, part(y)?])
        };
        let powder_factor = number(powder, Dim::DENSITY, "0.5 kg/m3")?;
        let charge = number(charge, Dim::MASS, "40 kg")?;
        let kuz_ram = rock_factor.map(|rock_factor| Pattern {
            rock_factor,
            powder_factor,
            charge,
            strength,
            uniformity,
        });
        Ok(Self {
            moved: number(moved, Dim::LENGTH, "0.5 m")?,
            along: along.map(plan).transpose()?,
            cell: number(cell, Dim::LENGTH, "0.1 m")?,
            kuz_ram,
            of: None,
        })
    }

    /// Numbers that cannot be.
    fn sound(&self) -> Result<(), MuckpileError> {
        let above = |what, value: Option<f64>| match value {
            Some(value) if !(value > 0.0 && value.is_finite()) => {
                Err(MuckpileError::Number { what, help: "" })
            }
            Some(_) | None => Ok(()),
        };
        above("the way from which on blocks are thrown", self.moved)?;
        above("the cell of the grid", self.cell)?;
        let direction = self.along.map(|[x, y]| (x * x + y * y).sqrt());
        above("the length of the direction of the throw", direction)?;
        let Some(pattern) = self.kuz_ram else { return Ok(()) };
        above("the rock factor", Some(pattern.rock_factor))?;
        let within = |what, value: Option<f64>, [low, high]: [f64; 2]| match value {
            Some(value) if !(low..=high).contains(&value) => {
                Err(MuckpileError::Range { what, value, low, high })
            }
            Some(_) | None => Ok(()),
        };
        within("the rock factor", Some(pattern.rock_factor), ROCK_FACTORS)?;
        within("the uniformity", pattern.uniformity, UNIFORMITIES)?;
        above("the powder factor", pattern.powder_factor)?;
        above("the charge of a hole", pattern.charge)?;
        above("the strength of the explosive", Some(pattern.strength))?;
        above("the uniformity", pattern.uniformity)
    }
}

fn track_name(folder: &Path) -> String {
    folder.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned())
}

/// The blocks of a frame that are not held, and those that are as blocks that are not thrown.
/// `counts`: which of them may make the pile.
fn pieces(
    frame: &Frame,
    names: &Names,
    densities: &[Option<f64>],
    rules: &Rules,
    counts: &dyn Fn(u32) -> bool,
) -> Vec<Piece> {
    let value = |name: &str, i: usize| {
        frame.column(name).and_then(|column| column.data.get(i)).copied().unwrap_or(0.0)
    };
    let vector = |name: &str, i: usize| {
        let column = frame.column(name);
        let part = column.and_then(|column| column.data.get(3 * i..3 * i + 3));
        part.map_or(Vec3::ZERO, |p| Vec3::new(p[0], p[1], p[2]))
    };
    let piece = |(i, number): (usize, u32)| {
        let (place, volume) = track::mass_centre(frame, i);
        let way = vector("displacement", i);
        let edge = 0.5 * libm::cbrt(volume);
        let density = densities.get(value("material", i) as usize).copied().flatten();
        let faces = frame.solids.iter().flat_map(|solids| solids.of(i));
        Piece {
            number,
            name: names.block(number).unwrap_or_else(|| number.to_string()),
            start: place - way,
            place,
            speed: vector("velocity", i).length(),
            volume,
            mass: density.map(|density| density * volume),
            broken: value("broken_share", i),
            held: track::held(frame, i),
            thrown: !track::held(frame, i)
                && way.length() > rules.moved.unwrap_or(edge)
                && counts(number),
            points: frame.outline(i).iter().map(|p| Vec3::from(*p)).collect(),
            faces: faces.map(<[u32]>::to_vec).collect(),
        }
    };
    track::numbers(frame).enumerate().map(piece).collect()
}

/// Triangles of the blocks of a frame.
fn triangles(frame: &Frame, counts: impl Fn(usize) -> bool) -> Vec<[Vec3; 3]> {
    let mut all = Vec::new();
    let Some(solids) = &frame.solids else { return all };
    for i in (0..frame.blocks()).filter(|i| counts(*i)) {
        let points = frame.outline(i);
        for face in solids.of(i) {
            let corner = |k: usize| Vec3::from(points[face[k] as usize]);
            all.extend((2..face.len()).map(|k| [corner(0), corner(k - 1), corner(k)]));
        }
    }
    all
}

/// Cell of the grid over the plan, m.
fn cell(pieces: &[Piece], rules: &Rules) -> f64 {
    rules.cell.unwrap_or_else(|| {
        let thrown = pieces.iter().filter(|piece| piece.thrown).count();
        let some = |piece: &&Piece| piece.thrown || thrown == 0;
        let (sum, count) = pieces
            .iter()
            .filter(some)
            .fold((0.0, 0.0), |(sum, count), piece| (sum + piece.volume, count + 1.0));
        0.25 * libm::cbrt(sum / f64::max(count, 1.0))
    })
}

/// Number and mass (kg) of the blocks that have left the model.
fn left(folder: &Path) -> (usize, f64) {
    let text = std::fs::read_to_string(folder.join("events.jsonl")).unwrap_or_default();
    let events = text.lines().filter_map(|line| serde_json::from_str(line).ok());
    let gone = events.filter(|event: &serde_json::Value| event["event"] == "block_left");
    gone.fold((0, 0.0), |(count, mass), event| {
        (count + 1, mass + event["mass"].as_f64().unwrap_or(0.0))
    })
}

fn flat(v: Vec3) -> f64 {
    (v.x * v.x + v.y * v.y).sqrt()
}

/// How far blocks were thrown; `None` where none was.
fn throw(pieces: &[Piece], charges: &[Vec3], rules: &Rules, left: (usize, f64)) -> Option<Throw> {
    let mut thrown: Vec<&Piece> = pieces.iter().filter(|piece| piece.thrown).collect();
    let volume: f64 = thrown.iter().map(|piece| piece.volume).sum();
    let moment: Vec3 = thrown.iter().map(|p| p.volume * (p.place - p.start)).sum();
    let shift = moment / volume;
    let [x, y] = rules.along.unwrap_or([shift.x, shift.y]);
    let length = (x * x + y * y).sqrt();
    let along = if length > 0.0 { [x / length, y / length] } else { [1.0, 0.0] };
    let way = |piece: &Piece| flat(piece.place - piece.start);
    let moving = thrown.iter().filter(|piece| piece.speed > MOVING).count();
    let mass = thrown.iter().map(|piece| piece.mass).sum();
    thrown.sort_by(|a, b| way(a).total_cmp(&way(b)).then(a.number.cmp(&b.number)));
    let rank = |share: f64| {
        let mut sum = 0.0;
        let reached = |piece: &&&Piece| {
            sum += piece.volume;
            sum >= share * volume * (1.0 - 1e-12)
        };
        thrown.iter().find(reached).map_or(0.0, |piece| way(piece))
    };
    let flyer = |piece: &Piece| Flyer {
        block: piece.name.clone(),
        way: way(piece),
        from_charge: charges.iter().map(|c| flat(piece.place - *c)).reduce(f64::min),
        size: libm::cbrt(piece.volume),
        mass: piece.mass,
    };
    let (half, most) = (rank(0.5), rank(0.9));
    let farthest = flyer(thrown.last()?);
    let far = thrown.iter().filter(|piece| way(piece) >= most);
    let largest_far = far.max_by(|a, b| a.volume.total_cmp(&b.volume)).map(|piece| flyer(piece))?;
    Some(Throw {
        blocks: thrown.len(),
        volume,
        mass,
        shift: shift.to_array(),
        along,
        half,
        most,
        farthest,
        largest_far,
        moving,
        left,
    })
}

/// What has happened behind the last row of charges.
fn behind(
    pieces: &[Piece],
    charges: &[Vec3],
    along: [f64; 2],
    stays: Option<&BTreeSet<u32>>,
) -> Option<Behind> {
    let back = |at: Vec3| -(at.x * along[0] + at.y * along[1]);
    let row = charges.iter().map(|c| back(*c)).reduce(f64::max)?;
    let farthest = |counts: &dyn Fn(&Piece) -> bool| {
        let all = pieces.iter().filter(|piece| counts(piece));
        all.map(|piece| back(piece.start) - row).fold(0.0, f64::max)
    };
    Some(Behind {
        back_break: farthest(&|piece| piece.thrown),
        loose: stays.map(|stays| farthest(&|piece| !stays.contains(&piece.number))),
        damaged: farthest(&|piece| piece.broken > 0.0),
    })
}
