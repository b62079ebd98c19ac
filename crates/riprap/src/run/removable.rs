//! Removable blocks and key blocks of a model in space, by block theory ([`crate::laws::block_theory`]).
//!
//! No step is made. The blocks are those of a phase as it begins, with its removals made and its laws and water in place; the planes are the
//! joints that each of them shares with others, and contacts that touch. A block with a held, moved or viscous face goes on beyond
//! the model, and one that is fixed or terrain is ground: neither is finite in the sense of the theory. A roller, and a support that holds some
//! directions, is a smooth plane that a block does not leave to either side, as a plane of symmetry.
//!
//! The resultant is the weight and the push of the water on all faces. The factor of safety is the shear strength of the planes that a
//! block slides along over the force along its way: each plane by its law under the mean pressure on it, none where the law is elastic.
//! Cohesion counts on planes that are slid along without pressure; tensile strength, bolts, loads and in-situ stress do not.
//!
//! Blocks below the wanted factor are taken out, and what they uncover is looked at in the next round: progressive failure.

mod error;
mod picture;
mod record;
#[cfg(test)]
mod tests;

use std::collections::BTreeMap;

use serde::Serialize;

use super::engine::View as Either;
use super::simulation::Simulation;
use crate::Vec3;
use crate::exec::Exec;
use crate::laws::behaviour::Law;
use crate::laws::block_theory::{self as theory, Mode};
use crate::plan::{Phase, Plan};
use crate::setup::Setup;
use crate::spatial::setup::{BoundaryKind, InterfaceLaw, Motion};
use crate::spatial::view::View;

pub use error::RemovableError;

/// What is asked for.
#[derive(Clone, Debug, PartialEq)]
pub struct Rules {
    /// Factor of safety that support is to give; blocks below it are taken out between rounds.
    pub factor: f64,
    /// Most rounds.
    pub rounds: u32,
    /// Phase whose beginning is looked at; `None` takes the last one.
    pub phase: Option<String>,
}

impl Default for Rules {
    fn default() -> Self {
        Self { factor: 1.0, rounds: 1, phase: None }
    }
}

/// Types of blocks of Goodman & Shi (1985), chapter 4.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Kind {
    /// Type I: removable, and the resultant moves it in spite of its strength.
    Key,
    /// Type II: removable, held by the strength of its joints.
    Potential,
    /// Type III: removable, but the resultant presses it into its place.
    Safe,
    /// Type IV: has a free face, but tapers towards it.
    Tapered,
    /// Inside the rock: no free face.
    Inside,
    /// Type V: goes on beyond the model, or is fixed.
    Ground,
}

/// A plane that a block slides on.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Plane {
    /// Interfaces of its joints, each once.
    pub interfaces: Vec<String>,
    /// Dip, deg.
    pub dip: f64,
    /// Dip direction, deg clockwise from north (y).
    pub dip_direction: f64,
    /// Area, m².
    pub area: f64,
    /// Force that presses the block on it, N.
    pub pressing: f64,
    /// Shear force that it bears, N; infinite where the joint is elastic.
    pub strength: f64,
}

/// A block.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Block {
    /// Its name.
    pub name: String,
    /// Type.
    pub kind: Kind,
    /// Round in which it was looked at, from 1.
    pub round: u32,
    /// m³.
    pub volume: f64,
    /// N.
    pub weight: f64,
    /// Centroid, m.
    pub centroid: [f64; 3],
    /// Area of its free faces, m².
    pub free_area: f64,
    /// `falling`, `sliding` on one plane, `wedge` on two, `held` by the resultant.
    pub mode: &'static str,
    /// The planes it slides along.
    pub planes: Vec<Plane>,
    /// Unit vector of its motion under the resultant, of a held one the middle of the ways out.
    pub direction: [f64; 3],
    /// Force along it, N.
    pub driving: f64,
    /// What the planes bear along it, N.
    pub resisting: f64,
    /// Resisting over driving; infinite where nothing drives it.
    pub factor_of_safety: f64,
    /// Force against the direction of motion that gives the wanted factor, N.
    pub support_force: f64,
    /// Pressure on the free faces that it goes out by whose part against the motion is that force, Pa; `None` where there are none.
    pub support_pressure: Option<f64>,
}

/// What was found.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Answer {
    /// Phase at whose beginning.
    pub phase: String,
    /// Factor that the support gives.
    pub factor: f64,
    /// Removable and tapered blocks: by round, removable ones first, by factor of safety and volume.
    pub blocks: Vec<Block>,
    /// Blocks without a free face at the beginning.
    pub inside: usize,
    /// Blocks that are ground at the beginning.
    pub ground: usize,
    /// Blocks among the others that end at rollers, or are held in some directions.
    pub rollers: usize,
    /// Things of the scene that do not count.
    pub not_counted: Vec<String>,
}

/// The removable blocks of a model.
///
/// # Errors
/// A model in the plane, an unknown phase, a factor that is none, a model that cannot be built.
///
/// # Examples
///
/// ```
/// use std::path::Path;
///
/// use riprap::exec::Exec;
/// use riprap::run::removable::{Kind, Rules, removable};
/// use riprap::run::scene::Scene;
///
/// let path = Path::new("scenes/verify/spatial-rigid/g4_roof_wedge.toml");
/// # let path = &Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(path);
/// let scene = Scene::load(path, &[])?;
/// let job = scene.prepare(&scene.plain())?.job();
/// let answer = removable(job.setup, job.plan, &Rules::default(), Exec::serial())?;
/// let wedge = &answer.blocks[0];
/// assert_eq!((wedge.kind, wedge.mode), (Kind::Key, "falling"));
/// assert!((wedge.support_force - 11_547.005).abs() < 0.01);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn removable(
    setup: impl Into<Setup>,
    plan: Plan,
    rules: &Rules,
    exec: Exec,
) -> Result<Answer, RemovableError> {
    if !(rules.factor > 0.0 && rules.factor.is_finite()) {
        return Err(RemovableError::Factor);
    }
    let Setup::Spatial(mut setup) = setup.into() else {
        return Err(RemovableError::Planar);
    };
    let (plan, phase) = as_begins(plan, rules.phase.as_deref(), &mut setup.interfaces)?;
    let mut simulation = Simulation::new(Setup::Spatial(setup), plan, exec)?;
    simulation.prepare()?;
    let Either::Spatial(view) = simulation.view() else {
        return Err(RemovableError::Planar);
    };
    let mut rock = Rock::of(&view);
    let mut answer = Answer {
        phase,
        factor: rules.factor,
        blocks: Vec::new(),
        inside: 0,
        ground: 0,
        rollers: 0,
        not_counted: not_counted(&view),
    };
    for round in 1..=rules.rounds.max(1) {
        let all: Vec<(usize, Block)> = view
            .living()
            .filter(|b| !rock.gone[*b])
            .map(|b| (b, rock.block(b, rules, round)))
            .collect();
        if round == 1 {
            // What is not examined is not inside.
            let examined = || all.iter().filter(|(b, _)| !view.world.is_glued(*b));
            let count = |kind| examined().filter(|(_, block)| block.kind == kind).count();
            (answer.inside, answer.ground) = (count(Kind::Inside), count(Kind::Ground));
            let rolls = |b: usize| !rock.ground[b] && !rock.rollers[b].is_empty();
            answer.rollers = examined().filter(|(b, _)| rolls(*b)).count();
        }
        let falls =
            |block: &Block| block.kind <= Kind::Safe && block.factor_of_safety < rules.factor;
        let out: Vec<usize> = all.iter().filter(|(_, b)| falls(b)).map(|(b, _)| *b).collect();
        let last = round == rules.rounds.max(1) || out.is_empty();
        // Of earlier rounds only what goes is told: the others are looked at again.
        let told = all
            .into_iter()
            .filter(|(_, block)| block.kind <= Kind::Tapered && (last || falls(block)));
        let mut told: Vec<Block> = told.map(|(_, block)| block).collect();
        told.sort_by(|a, b| {
            let taper = (a.kind == Kind::Tapered).cmp(&(b.kind == Kind::Tapered));
            let factor = a.factor_of_safety.total_cmp(&b.factor_of_safety);
            taper.then(factor).then(b.volume.total_cmp(&a.volume))
        });
        answer.blocks.extend(told);
        if last {
            break;
        }
        rock.take_out(&out);
    }
    Ok(answer)
}

/// A plan of one phase that changes at its beginning what all phases up to the one of that name change, and its name; laws are changed
/// in the table itself.
fn as_begins(
    plan: Plan,
    name: Option<&str>,
    laws: &mut [InterfaceLaw],
) -> Result<(Plan, String), RemovableError> {
    let last = match name {
        None => plan.phases.len(),
        Some(name) => {
            1 + plan.phases.iter().position(|p| p.name == name).ok_or_else(|| {
                let known: Vec<&str> = plan.phases.iter().map(|p| p.name.as_str()).collect();
                RemovableError::Phase { name: name.to_owned(), known: known.join(", ") }
            })?
        }
    };
    let shown = plan.phases[..last].last().map_or_else(String::new, |p| p.name.clone());
    let mut all = Phase::dynamic(&shown, 1.0);
    // What holds each block that a phase fixes or releases, by the last that does.
    let mut fixed: BTreeMap<u32, bool> = BTreeMap::new();
    for phase in &plan.phases[..last] {
        all.remove.extend(&phase.remove);
        fixed.extend(phase.fix.iter().map(|b| (*b, true)));
        fixed.extend(phase.release.iter().map(|b| (*b, false)));
        all.gravity = phase.gravity.or(all.gravity);
        all.water = phase.water.or(all.water);
        for (row, law) in &phase.joints {
            laws[usize::from(*row)].joint = *law;
        }
        if let Some(reduction) = &phase.reduction {
            for row in &reduction.rows {
                let law = &mut laws[usize::from(*row)];
                law.joint = law.joint.reduced(reduction.factor);
                law.bond = law.bond.map(|bond| bond.reduced(reduction.factor));
                law.friction = law.friction.map(|friction| friction / reduction.factor);
            }
        }
    }
    all.remove.sort_unstable();
    all.remove.dedup();
    all.fix = fixed.iter().filter(|(_, holds)| **holds).map(|(b, _)| *b).collect();
    all.release = fixed.iter().filter(|(_, holds)| !**holds).map(|(b, _)| *b).collect();
    Ok((Plan { phases: vec![all], ..plan }, shown))
}

/// What a scene has beside weight, water and joints.
fn not_counted(view: &View<'_>) -> Vec<String> {
    let setup = &view.world.setup;
    let pressed = setup.boundaries.iter().filter(|b| goes_on(&b.kind).is_none()).count();
    let things = [
        (setup.bolts.len(), "bolts"),
        (setup.loads.len(), "loads"),
        (setup.sources.len(), "sources"),
        (pressed, "tractions"),
        (usize::from(setup.in_situ.is_some()), "in_situ"),
        (view.living().filter(|b| view.world.is_glued(*b)).count(), "blocks of glued parts"),
    ];
    things.into_iter().filter(|(count, _)| *count > 0).map(|(_, word)| word.to_owned()).collect()
}

/// Along a face with this condition a block goes freely, and away from it to neither side.
const ROLLER: BoundaryKind = BoundaryKind::Held { normal: true, shear: false };

/// The axes along which a block is held that others leave free; `None` for one that is held along all, or driven.
fn held_axes(motion: &Motion) -> Option<Vec<Vec3>> {
    let Motion::Fixed { translation, .. } = motion else { return None };
    let axes = translation.iter().zip(Vec3::AXES);
    let held: Vec<Vec3> = axes.filter(|(holds, _)| **holds).map(|(_, axis)| axis).collect();
    (held.len() < 3).then_some(held)
}

/// Whether the rock goes on beyond a face with this condition.
fn goes_on(kind: &BoundaryKind) -> Option<()> {
    match kind {
        BoundaryKind::Held { .. } | BoundaryKind::Moved { .. } | BoundaryKind::Viscous { .. } => {
            Some(())
        }
        BoundaryKind::Traction { .. } => None,
    }
}

/// A part of a face by which two blocks touch.
#[derive(Clone, Copy, Debug)]
struct Touch {
    ends: [usize; 2],
    /// Unit normal from the first to the second.
    normal: Vec3,
    area: f64,
    row: usize,
    law: Shear,
}

/// Which of the strengths of an interface acts.
#[derive(Clone, Copy, Debug)]
enum Shear {
    Joint,
    Contact,
    Bond,
}

/// The blocks and what holds them.
struct Rock<'a> {
    view: &'a View<'a>,
    touches: Vec<Touch>,
    /// Touches of each block.
    of: Vec<Vec<usize>>,
    gone: Vec<bool>,
    /// Whether the block is no finite one.
    ground: Vec<bool>,
    /// Unit normals of the planes that each block does not leave to either side.
    rollers: Vec<Vec<Vec3>>,
    /// Free faces of each block: outward unit normal and area (m²).
    free: Vec<Vec<(Vec3, f64)>>,
}

impl<'a> Rock<'a> {
    fn of(view: &'a View<'a>) -> Self {
        let world = view.world;
        let count = world.alive.len();
        let touches = touches(view);
        let mut of = vec![Vec::new(); count];
        for (k, touch) in touches.iter().enumerate() {
            touch.ends.iter().for_each(|b| of[*b].push(k));
        }
        let mut rollers: Vec<Vec<Vec3>> = (0..count)
            .map(|b| world.motion[b].as_deref().and_then(held_axes).unwrap_or_default())
            .collect();
        let fixed = |b: usize| world.motion[b].as_deref().is_some_and(|m| held_axes(m).is_none());
        let mut ground: Vec<bool> = (0..count).map(|b| fixed(b) || world.is_terrain(b)).collect();
        let mut free = vec![Vec::new(); count];
        for face in &world.faces {
            let b = face.block as usize;
            let boundary = face.boundary.map(|k| &world.setup.boundaries[usize::from(k)]);
            let roller = boundary.is_some_and(|f| ROLLER == f.kind);
            if roller {
                rollers[b].push(face.frame[0]);
            }
            let beyond = boundary.is_some_and(|f| goes_on(&f.kind).is_some() || f.in_situ);
            ground[b] |= beyond && !roller;
            if !beyond && !face.parted {
                free[b].push((face.frame[0], face.area));
            }
        }
        Self { view, touches, of, gone: vec![false; count], ground, rollers, free }
    }

    /// Takes blocks out; what they have covered of others is free.
    fn take_out(&mut self, blocks: &[usize]) {
        for &b in blocks {
            self.gone[b] = true;
        }
        for &b in blocks {
            for touch in self.of[b].iter().map(|k| self.touches[*k]) {
                let first = touch.ends[0] == b;
                let other = touch.ends[usize::from(first)];
                if !self.gone[other] {
                    let outward = if first { -touch.normal } else { touch.normal };
                    self.free[other].push((outward, touch.area));
                }
            }
        }
    }
}

/// How a block would go.
struct Way {
    motion: theory::Motion,
    /// A direction in which it can leave, if there is one.
    way_out: Option<Vec3>,
    /// The planes that it slides along: first those that press.
    planes: Vec<Plane>,
}

impl Rock<'_> {
    /// What becomes of a block.
    fn block(&self, b: usize, rules: &Rules, round: u32) -> Block {
        let world = self.view.world;
        let solid = world.solid_of(b);
        let weight = solid.mass * world.gravity;
        let Way { motion, way_out, planes } = self.way(b, weight + self.view.water_force(b));
        let resisting: f64 = planes.iter().map(|plane| plane.strength).sum();
        let held = motion.mode == Mode::Held;
        let factor = if held { f64::INFINITY } else { resisting / motion.driving };
        let free = &self.free[b];
        let kind = match way_out {
            _ if self.ground[b] => Kind::Ground,
            _ if free.is_empty() => Kind::Inside,
            None => Kind::Tapered,
            Some(_) if held => Kind::Safe,
            Some(_) if factor < 1.0 => Kind::Key,
            Some(_) => Kind::Potential,
        };
        let lacks = (rules.factor * motion.driving - resisting).max(0.0);
        // Force against the motion of a unit pressure on the faces that it goes out by.
        let facing = free.iter().map(|(n, area)| (n.dot(motion.direction) * area).max(0.0));
        let lever: f64 = facing.sum();
        let free_area: f64 = free.iter().map(|(_, area)| area).sum();
        let direction = if held { way_out.unwrap_or(Vec3::ZERO) } else { motion.direction };
        Block {
            name: self.view.name(b),
            kind,
            round,
            volume: solid.volume,
            weight: weight.length(),
            centroid: (world.setup.origin + self.view.position(b)).to_array(),
            free_area,
            mode: match motion.mode {
                Mode::Falling => "falling",
                Mode::Sliding(_) => "sliding",
                Mode::Wedge(_) => "wedge",
                Mode::Held => "held",
            },
            planes,
            direction: direction.to_array(),
            driving: motion.driving,
            resisting,
            factor_of_safety: factor,
            support_force: lacks,
            support_pressure: (lever > ALONG * free_area).then(|| lacks / lever),
        }
    }

    /// How a force (N) would move a block, and what it slides along.
    fn way(&self, b: usize, force: Vec3) -> Way {
        let touching: Vec<(Vec3, &Touch)> = self.inward(b).collect();
        let sides = self.rollers[b].iter().flat_map(|n| [*n, -*n]);
        let normals: Vec<Vec3> = touching.iter().map(|(n, _)| *n).chain(sides).collect();
        let (different, of) = theory::planes(&normals);
        let motion = theory::motion(&different, force);
        let pressed: Vec<(usize, f64)> = match motion.mode {
            Mode::Falling | Mode::Held => Vec::new(),
            Mode::Sliding(k) => vec![(k, motion.pressing[0])],
            Mode::Wedge(pair) => pair.into_iter().zip(motion.pressing).collect(),
        };
        // Planes that the motion only runs along: their cohesion.
        let along = (0..different.len()).filter(|k| {
            motion.mode != Mode::Held
                && pressed.iter().all(|(p, _)| p != k)
                && different[*k].dot(motion.direction).abs() < ALONG
        });
        let all = pressed.iter().copied().chain(along.map(|k| (k, 0.0)));
        let planes = all.filter_map(|(k, pressing)| {
            let parts = of.iter().zip(&touching).filter(|(p, _)| **p == k);
            let parts: Vec<&Touch> = parts.map(|(_, (_, touch))| *touch).collect();
            // A roller that does not press bears nothing.
            let tells = pressing > 0.0 || !parts.is_empty();
            tells.then(|| self.plane(different[k], &parts, pressing))
        });
        Way { motion, way_out: theory::way_out(&different), planes: planes.collect() }
    }

    /// By what a block touches those that are there, with unit normals into it.
    fn inward(&self, b: usize) -> impl Iterator<Item = (Vec3, &Touch)> {
        self.of[b].iter().filter_map(move |k| {
            let touch = &self.touches[*k];
            let first = touch.ends[0] == b;
            let there = !self.gone[touch.ends[usize::from(first)]];
            there.then_some((if first { -touch.normal } else { touch.normal }, touch))
        })
    }

    /// A plane with unit normal `normal` into the block, pressed by a force (N).
    fn plane(&self, normal: Vec3, parts: &[&Touch], pressing: f64) -> Plane {
        let laws = &self.view.world.setup.interfaces;
        let area: f64 = parts.iter().map(|touch| touch.area).sum();
        let pressure = if area > 0.0 { pressing.max(0.0) / area } else { 0.0 };
        let bears = |touch: &&Touch| touch.area * touch.law.strength(&laws[touch.row], pressure);
        let mut interfaces: Vec<String> = Vec::new();
        for name in parts.iter().map(|touch| &laws[touch.row].name) {
            if !interfaces.contains(name) {
                interfaces.push(name.clone());
            }
        }
        let (dip, dip_direction) = dip(normal);
        let strength = parts.iter().map(bears).sum();
        Plane { interfaces, dip, dip_direction, area, pressing, strength }
    }
}

/// Cosine below which a motion runs along a plane.
const ALONG: f64 = 1e-6;

impl Shear {
    /// Shear strength (Pa) under a pressure (Pa).
    fn strength(self, law: &InterfaceLaw, pressure: f64) -> f64 {
        let joint = &law.joint;
        let strength = match self {
            Self::Joint | Self::Contact => joint.strength,
            Self::Bond => law.bond.map_or(joint.strength, |bond| bond.strength),
        };
        match (self, strength, law.friction) {
            (Self::Contact, None, Some(friction)) => friction * pressure,
            (Self::Bond, Some(strength), _) => strength.peak(-pressure),
            // Stiffness has no part in the limit.
            (_, strength, _) => {
                Law::new(strength.as_ref(), &joint.behaviour, [1.0; 2]).first_limit(-pressure)
            }
        }
    }
}

/// All by which blocks touch: joints, facets of deformable blocks, found contacts.
fn touches(view: &View<'_>) -> Vec<Touch> {
    let world = view.world;
    let setup = &world.setup;
    let ends = |ends: [u32; 2]| ends.map(|b| b as usize);
    let joints = (0..world.patches.len()).map(|p| {
        let class = view.patch_class(p);
        let (normal, area, row) = (class.frame[0], class.area, usize::from(class.row));
        Touch { ends: ends(world.patches.ends[p]), normal, area, row, law: Shear::Joint }
    });
    let facets = world.deform.iter().flat_map(|deform| &deform.facets).filter(|f| !f.parted);
    let facets = facets.map(|f| {
        let (normal, area, row) = (f.frame[0], f.area, usize::from(f.row));
        Touch { ends: ends(f.blocks), normal, area, row, law: Shear::Bond }
    });
    let found = view.contacts().filter(|contact| contact.normal != Vec3::ZERO);
    let found = found.map(|contact| {
        let of = contact.ends.map(|b| usize::from(setup.blocks[b as usize].material));
        let (normal, area, row) = (contact.normal, contact.area, usize::from(setup.row_of(of)));
        Touch { ends: ends(contact.ends), normal, area, row, law: Shear::Contact }
    });
    let mut all: Vec<Touch> = joints.chain(facets).chain(found).collect();
    // Across the ends of a periodic model a block may touch itself, which holds it from nothing.
    all.retain(|touch| touch.ends[0] != touch.ends[1]);
    all
}

/// Dip and dip direction of a plane, deg.
fn dip(normal: Vec3) -> (f64, f64) {
    let up = if normal.z < 0.0 { -normal } else { normal };
    let level = (up.x * up.x + up.y * up.y).sqrt();
    (libm::atan2(level, up.z).to_degrees(), azimuth(up))
}

/// Degrees clockwise from north (y) of what a vector points to from above.
fn azimuth(v: Vec3) -> f64 {
    let angle = libm::atan2(v.x, v.y).to_degrees();
    // North is 0 from either side, not -0.
    if angle < 0.0 { angle + 360.0 } else { angle + 0.0 }
}
