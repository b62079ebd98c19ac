//! Where rocks were in the frames of a run.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use super::{Ground, Rules, RunoutError, name_of};
use crate::Vec3;
use crate::geom::polyhedron::Polyhedron;
use crate::geom::{Vec2, polygon};
use crate::record::frame::Frame;
use crate::record::manifest::Manifest;
use crate::record::names::Names;
use crate::record::vtu::{Wanted, read_blocks, read_pvd};
use crate::scenario;

/// Times at which the way between two frames is looked at.
const BETWEEN: usize = 8;
/// Share of gravity that may be horizontal.
const VERTICAL: f64 = 1e-6;

/// A rock in a frame.
#[derive(Clone, Copy, Debug)]
pub(super) struct State {
    pub(super) time: f64,
    /// Centroid, m; in the plane x and, as z, the height.
    pub(super) place: Vec3,
    pub(super) velocity: Vec3,
}

/// A rock in all frames that have it.
#[derive(Clone, Debug)]
pub(super) struct Track {
    pub(super) name: String,
    pub(super) mass: Option<f64>,
    states: Vec<State>,
}

/// The rocks of a run, and its ground.
#[derive(Debug)]
pub(super) struct Run {
    pub(super) name: String,
    pub(super) planar: bool,
    pub(super) ground: Ground,
    pub(super) tracks: Vec<Track>,
    /// Longest time between two frames, s.
    pub(super) longest: f64,
}

/// Run folders in a folder: itself, or those in it, in the order of their names.
pub(in crate::run) fn runs_in(folder: &Path) -> Result<Vec<PathBuf>, RunoutError> {
    let is_run = |folder: &Path| folder.join("run.pvd").is_file();
    if is_run(folder) {
        return Ok(vec![folder.to_owned()]);
    }
    let entries = std::fs::read_dir(folder).map_err(|_| RunoutError::NoRun(folder.to_owned()))?;
    let mut found: Vec<PathBuf> =
        entries.flatten().map(|entry| entry.path()).filter(|path| is_run(path)).collect();
    found.sort();
    if found.is_empty() {
        return Err(RunoutError::NoRun(folder.to_owned()));
    }
    Ok(found)
}

impl Run {
    /// Reads the frames of a run.
    pub(super) fn read(folder: &Path, rules: &Rules) -> Result<Self, RunoutError> {
        let manifest = Manifest::read(folder)?;
        let list = read_pvd(&folder.join("run.pvd"))?;
        if list.len() < 2 {
            return Err(RunoutError::Frames { folder: folder.to_owned(), frames: list.len() });
        }
        let column = |name: &str| matches!(name, "block" | "velocity" | "held" | "material");
        let wanted = Wanted { geometry: true, column: &column };
        let first = read_blocks(&folder.join(&list[0].file), wanted)?;
        let planar = first.solids.is_none();
        let up = if planar { 1 } else { 2 };
        let size = manifest.gravity.iter().map(|g| g * g).sum::<f64>().sqrt();
        if (manifest.gravity[up] + size).abs() > VERTICAL * size {
            return Err(RunoutError::Tilted(folder.to_owned()));
        }
        let mut tracks = chosen(&first, folder, rules, &densities(folder, &manifest))?;
        let mut longest = 0.0_f64;
        let mut before = first.time;
        for entry in &list[1..] {
            let frame = read_blocks(&folder.join(&entry.file), wanted)?;
            longest = longest.max(frame.time - before);
            before = frame.time;
            for (i, number) in numbers(&frame).enumerate() {
                if let Some(track) = tracks.get_mut(&number) {
                    track.states.push(state(&frame, i));
                }
            }
        }
        Ok(Self {
            name: name_of(folder),
            planar,
            ground: Ground::new(ground(&first)),
            tracks: tracks.into_values().collect(),
            longest,
        })
    }

    /// A place as the scene has it.
    pub(super) fn shown(&self, p: Vec3) -> [f64; 3] {
        if self.planar { [p.x, p.z, 0.0] } else { p.to_array() }
    }
}

impl Track {
    pub(super) fn first(&self) -> State {
        self.states[0]
    }

    pub(super) fn last(&self) -> State {
        self.states[self.states.len() - 1]
    }

    /// Places and velocities in the frames and between them.
    pub(super) fn samples(&self) -> impl Iterator<Item = (Vec3, Vec3)> + '_ {
        let first = self.first();
        let between = self.states.windows(2).flat_map(|pair| {
            let steps = if pair[1].time > pair[0].time { BETWEEN } else { 0 };
            (1..=steps).map(move |k| {
                // In a frame as it stands there.
                if k == BETWEEN {
                    return (pair[1].place, pair[1].velocity);
                }
                way(pair[0], pair[1], k as f64 / BETWEEN as f64)
            })
        });
        std::iter::once((first.place, first.velocity)).chain(between)
    }

    /// Time, place and velocity where it first passes a wall; `side` gives the distance to it and, from 0 to 1, the place along it.
    pub(super) fn passes(&self, side: impl Fn(Vec3) -> (f64, f64)) -> Option<(f64, Vec3, Vec3)> {
        for pair in self.states.windows(2) {
            let [a, b] = [pair[0], pair[1]];
            let near = |p: Vec3| side(p).0;
            if b.time <= a.time || (near(a.place) < 0.0) == (near(b.place) < 0.0) {
                continue;
            }
            let (mut low, mut high) = (0.0, 1.0);
            let behind = near(a.place) < 0.0;
            // As far as numbers go.
            for _ in 0..60 {
                let middle = 0.5 * (low + high);
                if (near(way(a, b, middle).0) < 0.0) == behind {
                    low = middle;
                } else {
                    high = middle;
                }
            }
            let (place, velocity) = way(a, b, high);
            if (0.0..=1.0).contains(&side(place).1) {
                return Some((a.time + high * (b.time - a.time), place, velocity));
            }
        }
        None
    }
}

/// Place and velocity on the cubic between two states, at a share of the time between them.
fn way(a: State, b: State, share: f64) -> (Vec3, Vec3) {
    let dt = b.time - a.time;
    let (t, s) = (share, 1.0 - share);
    let place = s * s * (1.0 + 2.0 * t) * a.place
        + t * t * (1.0 + 2.0 * s) * b.place
        + dt * s * t * (s * a.velocity - t * b.velocity);
    let velocity = 6.0 * s * t / dt * (b.place - a.place)
        + s * (1.0 - 3.0 * t) * a.velocity
        + t * (1.0 - 3.0 * s) * b.velocity;
    (place, velocity)
}

/// Numbers of the blocks of a frame.
pub(in crate::run) fn numbers(frame: &Frame) -> impl Iterator<Item = u32> + '_ {
    let column = frame.column("block");
    (0..frame.blocks())
        .map(move |i| column.and_then(|c| c.data.get(i)).map_or(i as u32, |b| *b as u32))
}

/// Whether block `i` of a frame is held.
pub(in crate::run) fn held(frame: &Frame, i: usize) -> bool {
    frame.column("held").and_then(|c| c.data.get(i)).is_some_and(|h| *h != 0.0)
}

/// Centroid (m) and volume (m³) of block `i` of a frame, in the plane with the height as z and an area.
pub(in crate::run) fn mass_centre(frame: &Frame, i: usize) -> (Vec3, f64) {
    let points = frame.outline(i);
    match &frame.solids {
        Some(solids) => {
            let vertices = points.iter().map(|p| Vec3::from(*p)).collect();
            let faces = solids.of(i).into_iter().map(<[u32]>::to_vec).collect();
            let moments = Polyhedron { vertices, faces }.moments();
            (moments.centroid, moments.volume)
        }
        None => {
            let flat: Vec<Vec2> = points.iter().map(|p| Vec2::new(p[0], p[1])).collect();
            let centroid = polygon::centroid(&flat);
            (Vec3::new(centroid.x, 0.0, centroid.y), polygon::signed_area(&flat))
        }
    }
}

fn state(frame: &Frame, i: usize) -> State {
    let velocity = frame.column("velocity").and_then(|c| {
        let v = c.data.chunks(c.components).nth(i)?;
        Some(match v {
            [x, y] => Vec3::new(*x, 0.0, *y),
            [x, y, z] if frame.solids.is_none() => Vec3::new(*x, *z, *y),
            [x, y, z] => Vec3::new(*x, *y, *z),
            _ => return None,
        })
    });
    State {
        time: frame.time,
        place: mass_centre(frame, i).0,
        velocity: velocity.unwrap_or(Vec3::ZERO),
    }
}

/// The rocks of the first frame, by their numbers.
fn chosen(
    first: &Frame,
    folder: &Path,
    rules: &Rules,
    densities: &[Option<f64>],
) -> Result<BTreeMap<u32, Track>, RunoutError> {
    let names = Names::read(folder)?;
    let group = |what| RunoutError::Group { folder: folder.to_owned(), what };
    let of = rules.of.as_ref().map(|of| names.chosen(of).map_err(group)).transpose()?;
    let materials = first.column("material");
    let mut tracks = BTreeMap::new();
    for (i, number) in numbers(first).enumerate() {
        let meant = of.as_ref().is_none_or(|of| of.has(number));
        if held(first, i) || !meant {
            continue;
        }
        let material = materials.and_then(|c| c.data.get(i)).map_or(0, |m| *m as usize);
        let density = densities.get(material).copied().flatten();
        let mass = density.map(|density| density * mass_centre(first, i).1);
        let name = names.block(number).unwrap_or_else(|| number.to_string());
        tracks.insert(number, Track { name, mass, states: vec![state(first, i)] });
    }
    if tracks.is_empty() {
        return Err(RunoutError::NoRock { folder: folder.to_owned(), of: rules.of.clone() });
    }
    Ok(tracks)
}

/// Triangles of what is held in a frame; in the plane edges, drawn out to both sides.
fn ground(frame: &Frame) -> Vec<[Vec3; 3]> {
    let mut all = Vec::new();
    for i in (0..frame.blocks()).filter(|i| held(frame, *i)) {
        let points = frame.outline(i);
        if let Some(solids) = &frame.solids {
            for face in solids.of(i) {
                let corner = |k: usize| Vec3::from(points[face[k] as usize]);
                all.extend((2..face.len()).map(|k| [corner(0), corner(k - 1), corner(k)]));
            }
            continue;
        }
        for (a, b) in points.iter().zip(points.iter().cycle().skip(1)) {
            let at = |p: &[f64; 3], y: f64| Vec3::new(p[0], y, p[1]);
            all.push([at(a, -1.0), at(b, -1.0), at(b, 1.0)]);
            all.push([at(a, -1.0), at(b, 1.0), at(a, 1.0)]);
        }
    }
    all
}

/// Densities of the materials of a run, by number; unknown where its scene cannot be read any more.
pub(in crate::run) fn densities(folder: &Path, manifest: &Manifest) -> Vec<Option<f64>> {
    let scene = scenario::load(&folder.join("scenario.resolved.toml"), &[]).ok();
    let of = |name: &String| {
        scene.as_ref().and_then(|s| s.scenario.materials.get(name)).map(|m| m.density.si())
    };
    manifest.materials.iter().map(of).collect()
}
