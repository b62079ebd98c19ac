//! The engines behind one face: what the run loop, the recorder and the checks ask of whichever engine
//! a scene needs. A closed choice: every question is a `match` over both.

use serde::{Deserialize, Serialize};
use thiserror::Error;

use super::plan::{Damping, Gauge, Phase};
use crate::exec::Exec;
use crate::ledger::{Balance, Works};
use crate::model::Setup;
use crate::profile::Profile;
use crate::record::field::{FieldError, FieldInfo};
use crate::record::frame::Frame;
use crate::record::frame::fragments::Fragments;
use crate::record::manifest::Source;
use crate::{Vec2, Vec3};
use crate::{planar, spatial};

/// A block may cross at most this share of its neighbourhood's inscribed radius in one step.
const TRANSIT: f64 = 0.2;

/// Which engine.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Kind {
    /// Polygons in the plane.
    Planar,
    /// Blocks in space.
    Spatial,
}

impl Kind {
    /// The engine a model needs.
    #[must_use]
    pub fn of(setup: &Setup) -> Self {
        match setup {
            Setup::Planar(_) => Kind::Planar,
            Setup::Spatial(_) => Kind::Spatial,
        }
    }

    /// Everything that can be read from it.
    #[must_use]
    pub fn fields(self) -> &'static [FieldInfo] {
        match self {
            Kind::Planar => planar::readings::INFOS,
            Kind::Spatial => spatial::readings::INFOS,
        }
    }

    /// Unit of energies: J per metre of thickness in the plane.
    #[must_use]
    pub fn energy_unit(self) -> &'static str {
        match self {
            Kind::Planar => "J/m",
            Kind::Spatial => "J",
        }
    }
}

/// Why an engine could not be made.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum BuildError {
    /// The spatial engine cannot build the model.
    #[error(transparent)]
    Spatial(#[from] spatial::build::BuildError),
}

/// State of an engine: what a checkpoint holds.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub enum State {
    /// Of the planar engine.
    Planar(Box<planar::world::World>),
    /// Of the spatial engine.
    Spatial(Box<spatial::world::World>),
}

/// An engine with its workspace.
#[derive(Debug)]
pub enum Engine {
    /// Polygons in the plane.
    Planar(Box<Planar>),
    /// Blocks in space.
    Spatial(Box<Spatial>),
}

/// The planar engine.
#[derive(Debug)]
pub struct Planar {
    world: planar::world::World,
    scratch: planar::step::Scratch,
}

impl Planar {
    fn view(&self) -> planar::fields::View<'_> {
        planar::fields::View {
            world: &self.world,
            scratch: &self.scratch,
        }
    }
}

/// The spatial engine.
#[derive(Debug)]
pub struct Spatial {
    world: spatial::world::World,
    scratch: spatial::step::Scratch,
}

impl Spatial {
    fn view(&self) -> spatial::fields::View<'_> {
        spatial::fields::View {
            world: &self.world,
            scratch: &self.scratch,
        }
    }
}

/// An engine with its forces evaluated, ready to be read.
#[derive(Clone, Copy)]
pub enum View<'a> {
    /// Of the planar engine.
    Planar(planar::fields::View<'a>),
    /// Of the spatial engine.
    Spatial(spatial::fields::View<'a>),
}

/// One number that is read again and again.
#[derive(Clone, Debug, PartialEq)]
pub enum Reading {
    /// From the planar engine.
    Planar(planar::readings::Reading),
    /// From the spatial engine.
    Spatial(spatial::readings::Reading),
}

/// A stable time step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stable {
    /// Longest stable step, s; infinite when nothing can touch.
    pub dt: f64,
    /// Block that sets it.
    pub block: Option<u32>,
}

/// State of a relaxing phase.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Relaxed {
    /// Whether the last look found it converged.
    pub converged: bool,
    /// Iterations since loads or bonds last changed.
    pub iterations: u64,
}

/// The fastest or the deepest: who, and how much.
pub type Who = (String, f64);

impl Engine {
    /// A new engine.
    ///
    /// # Errors
    /// A model that cannot be built.
    pub fn new(setup: Setup, exec: Exec) -> Result<Self, BuildError> {
        match setup {
            Setup::Planar(setup) => {
                let (world, scratch) = planar::world::World::new(setup, exec);
                Ok(Self::Planar(Box::new(Planar { world, scratch })))
            }
            Setup::Spatial(setup) => {
                let (world, scratch) = spatial::world::World::new(*setup, exec)?;
                Ok(Self::Spatial(Box::new(Spatial { world, scratch })))
            }
        }
    }

    /// An engine that goes on from a state.
    #[must_use]
    pub fn resume(state: State, exec: Exec) -> Self {
        match state {
            State::Planar(mut world) => {
                let scratch = planar::step::Scratch::new(&mut world, exec);
                Self::Planar(Box::new(Planar {
                    world: *world,
                    scratch,
                }))
            }
            State::Spatial(mut world) => {
                let scratch = spatial::step::Scratch::new(&mut world, exec);
                Self::Spatial(Box::new(Spatial {
                    world: *world,
                    scratch,
                }))
            }
        }
    }

    /// Which engine it is.
    #[must_use]
    pub fn kind(&self) -> Kind {
        match self {
            Self::Planar(_) => Kind::Planar,
            Self::Spatial(_) => Kind::Spatial,
        }
    }

    /// A copy of the state.
    #[must_use]
    pub fn state(&self) -> State {
        match self {
            Self::Planar(e) => State::Planar(Box::new(e.world.clone())),
            Self::Spatial(e) => State::Spatial(Box::new(e.world.clone())),
        }
    }

    /// For reading.
    #[must_use]
    pub fn view(&self) -> View<'_> {
        match self {
            Self::Planar(e) => View::Planar(e.view()),
            Self::Spatial(e) => View::Spatial(e.view()),
        }
    }

    /// Changes whenever the stable step may have changed.
    #[must_use]
    pub fn revision(&self) -> u64 {
        match self {
            Self::Planar(e) => e.scratch.rebuilds,
            Self::Spatial(e) => e.scratch.rebuilds,
        }
    }

    /// The stable step of the present contacts, with the stiffness-proportional damping of the phase (s).
    #[must_use]
    pub fn stable(&self, stiffness_damping: f64) -> Stable {
        match self {
            Self::Planar(e) => {
                let found = planar::stable::stable_step(
                    &e.world,
                    &e.scratch.shapes,
                    &e.scratch.candidates,
                    stiffness_damping,
                );
                Stable {
                    dt: found.dt,
                    block: found.block,
                }
            }
            Self::Spatial(e) => {
                let found = spatial::stable::stable_step(&e.world, &e.scratch, stiffness_damping);
                Stable {
                    dt: found.dt,
                    block: found.block,
                }
            }
        }
    }

    /// Longest step that the present motion allows whatever the rule of the phase, s: fast blocks in the
    /// plane, the gas of a cavity in space.
    #[must_use]
    pub fn step_limit(&self) -> f64 {
        match self {
            Self::Planar(e) => TRANSIT * e.scratch.transit,
            Self::Spatial(e) => spatial::cavity::step_limit(&e.world),
        }
    }

    /// Finds the forces at the present time and the velocity changes for a step of `dt` (s).
    ///
    /// # Errors
    /// A block whose forces are not finite.
    pub fn evaluate(&mut self, damping: &Damping, dt: f64) -> Result<(), u32> {
        match self {
            Self::Planar(e) => planar::step::evaluate(&mut e.world, &mut e.scratch, damping, dt)
                .map_err(|e| e.block),
            Self::Spatial(e) => spatial::step::evaluate(&mut e.world, &mut e.scratch, damping, dt)
                .map_err(|e| e.block),
        }
    }

    /// Splits blocks whose criterion is met, after [`Engine::evaluate`] with the same numbers.
    ///
    /// # Errors
    /// The edit is not exact, or makes too many blocks: what is wrong, in words.
    pub fn refine(&mut self, damping: &Damping, dt: f64) -> Result<(), String> {
        match self {
            Self::Planar(_) => Ok(()),
            Self::Spatial(e) => {
                spatial::edit::refine_running(&mut e.world, &mut e.scratch, damping, dt)
                    .map(|_| ())
                    .map_err(|error| error.to_string())
            }
        }
    }

    /// Moves on by `dt` (s).
    pub fn advance(&mut self, dt: f64) {
        match self {
            Self::Planar(e) => planar::step::advance(&mut e.world, &mut e.scratch, dt),
            Self::Spatial(e) => spatial::step::advance(&mut e.world, &mut e.scratch, dt),
        }
    }

    /// How far a relaxing phase of deformable blocks is; `None` if none is.
    #[must_use]
    pub fn relaxing(&self) -> Option<Relaxed> {
        match self {
            Self::Planar(_) => None,
            Self::Spatial(e) => {
                let relax = e.world.deform.as_ref()?.relax.as_ref()?;
                Some(Relaxed {
                    converged: relax.converged,
                    iterations: relax.iterations,
                })
            }
        }
    }

    /// Lets model time pass by `increment` (s) in the coming iteration of a relaxing phase.
    pub fn load_step(&mut self, increment: f64) {
        if let Self::Spatial(e) = self {
            spatial::deform::phase::load_step(&mut e.world, increment);
        }
    }

    /// Breaks the bonds that are due at the present state, after [`Engine::evaluate`] with the same step, and evaluates
    /// anew; returns how many facets lost some.
    ///
    /// # Errors
    /// A block whose forces are not finite.
    pub fn fracture(&mut self, dt: f64) -> Result<usize, u32> {
        match self {
            Self::Planar(_) => Ok(0),
            Self::Spatial(e) => spatial::deform::fracture::step(&mut e.world, &mut e.scratch, dt)
                .map_err(|e| e.block),
        }
    }

    /// Cuts the deformable blocks whose criterion is met, after [`Engine::evaluate`] with the same step, and evaluates anew;
    /// returns how many.
    ///
    /// # Errors
    /// Why it failed, in words.
    pub fn cut(&mut self, dt: f64) -> Result<usize, String> {
        match self {
            Self::Planar(_) => Ok(0),
            Self::Spatial(e) => spatial::deform::cut::step(&mut e.world, &mut e.scratch, dt)
                .map_err(|error| error.to_string()),
        }
    }

    /// Gravity now, m/s²; in the plane the third component is 0.
    #[must_use]
    pub fn gravity(&self) -> [f64; 3] {
        match self {
            Self::Planar(e) => [e.world.gravity.x, e.world.gravity.y, 0.0],
            Self::Spatial(e) => e.world.gravity.to_array(),
        }
    }

    /// Changes gravity, m/s².
    pub fn set_gravity(&mut self, gravity: [f64; 3]) {
        match self {
            Self::Planar(e) => e.world.gravity = Vec2::new(gravity[0], gravity[1]),
            Self::Spatial(e) => e.world.gravity = Vec3::from(gravity),
        }
    }

    /// Measures displacements from here on.
    pub fn zero_displacements(&mut self) {
        match self {
            Self::Planar(e) => e.world.zero_displacements(),
            Self::Spatial(e) => {
                let poses = e.view().present_poses();
                e.world.zero_displacements(poses);
            }
        }
    }

    /// Applies what a phase changes in blocks, supports and laws; forces must be evaluated anew afterwards.
    pub fn edit(&mut self, phase: &Phase) {
        match self {
            Self::Planar(e) => {
                planar_edit(&mut e.world, phase);
                e.scratch.invalidate(&mut e.world);
            }
            Self::Spatial(e) => {
                spatial_edit(&mut e.world, phase);
                e.scratch.invalidate(&mut e.world);
            }
        }
    }

    /// Takes what has happened since the last look, one JSON object each: joints broken, blocks split or
    /// removed, charges fired. `again`: the step has been looked at before.
    pub fn take_events(&mut self, again: bool) -> Vec<serde_json::Value> {
        match self {
            Self::Planar(_) if again => Vec::new(),
            Self::Planar(e) => planar_events(&e.view()),
            Self::Spatial(e) => {
                let events = std::mem::take(&mut e.world.events);
                let deform = e.world.deform.as_mut();
                let broken = deform.map(|d| std::mem::take(&mut d.broken));
                let view = e.view();
                let others = broken.iter().flatten().map(|b| break_event(&view, b));
                let edits = events.iter().map(|event| spatial_event(&view, event));
                edits.chain(others).collect()
            }
        }
    }

    /// The running sums of the ledger.
    pub fn works(&mut self) -> &mut Works {
        match self {
            Self::Planar(e) => &mut e.world.works,
            Self::Spatial(e) => &mut e.world.works,
        }
    }

    /// Kinetic and stored energy at the start, once known.
    pub fn start_energy(&mut self) -> &mut Option<f64> {
        match self {
            Self::Planar(e) => &mut e.world.start_energy,
            Self::Spatial(e) => &mut e.world.start_energy,
        }
    }

    /// Stage times.
    #[must_use]
    pub fn profile(&self) -> &Profile {
        match self {
            Self::Planar(e) => &e.scratch.profile,
            Self::Spatial(e) => &e.scratch.profile,
        }
    }

    /// blake3 of the state: equal hashes mean equal bits of motion and contact memory.
    #[must_use]
    pub fn hash(&self) -> String {
        match self {
            Self::Planar(e) => super::hash::planar(&e.world),
            Self::Spatial(e) => super::hash::spatial(&e.world),
        }
    }
}

fn planar_edit(world: &mut planar::world::World, phase: &Phase) {
    use planar::setup::Motion;
    for &b in &phase.remove {
        world.alive[b as usize] = false;
    }
    let alive = std::mem::take(&mut world.alive);
    world
        .bonds
        .retain(|k| alive[k.i as usize] && alive[k.j as usize]);
    world.alive = alive;
    for &b in &phase.fix {
        world.motion[b as usize] = Some(Box::new(Motion::Fixed {
            x: true,
            y: true,
            rotation: true,
        }));
    }
    for &b in &phase.release {
        world.motion[b as usize] = None;
    }
    for (row, law) in &phase.contacts {
        world.setup.interfaces[*row as usize].contact = *law;
    }
    if phase.zero_velocities {
        for body in &mut world.bodies {
            body.velocity = Vec2::ZERO;
            body.spin = 0.0;
        }
        world.last_dt = 0.0;
    }
    planar::step::hold_driven(world);
}

fn spatial_edit(world: &mut spatial::world::World, phase: &Phase) {
    use spatial::setup::Motion;
    spatial::edit::take_out(world, &phase.remove);
    for &b in &phase.fix {
        world.motion[b as usize] = Some(Box::new(Motion::Fixed {
            translation: [true; 3],
            rotation: [true; 3],
        }));
    }
    for &b in &phase.release {
        world.motion[b as usize] = None;
    }
    for (row, law) in &phase.joints {
        world.setup.interfaces[*row as usize].joint = *law;
    }
    if !phase.joints.is_empty() {
        spatial::edit::renew_laws(world);
    }
    if phase.zero_velocities {
        world.halt();
    }
    world.hold_driven();
    let rules = phase.deform.map(|d| spatial::deform::phase::Rules {
        relax: d.relax.map(|r| r.tolerance),
        breaking: d.breaking,
    });
    spatial::deform::phase::enter(world, &phase.remove, rules.as_ref());
    let cut = phase.deform.and_then(|d| d.cut);
    spatial::deform::cut::allow(world, cut.as_ref());
}

impl<'a> View<'a> {
    /// The planar view, for what only that engine has.
    #[must_use]
    pub fn planar(self) -> Option<planar::fields::View<'a>> {
        match self {
            Self::Planar(view) => Some(view),
            Self::Spatial(_) => None,
        }
    }

    /// The spatial view, for what only that engine has.
    #[must_use]
    pub fn spatial(self) -> Option<spatial::fields::View<'a>> {
        match self {
            Self::Planar(_) => None,
            Self::Spatial(view) => Some(view),
        }
    }

    /// Model time, s.
    #[must_use]
    pub fn time(&self) -> f64 {
        match self {
            Self::Planar(v) => v.world.time,
            Self::Spatial(v) => v.world.time,
        }
    }

    /// Steps done.
    #[must_use]
    pub fn step(&self) -> u64 {
        match self {
            Self::Planar(v) => v.world.step,
            Self::Spatial(v) => v.world.step,
        }
    }

    /// Length of the last step, s; 0 before the first.
    #[must_use]
    pub fn last_dt(&self) -> f64 {
        match self {
            Self::Planar(v) => v.world.last_dt,
            Self::Spatial(v) => v.world.last_dt,
        }
    }

    /// Name of a block.
    #[must_use]
    pub fn name(&self, block: u32) -> String {
        match self {
            Self::Planar(v) => v.world.setup.blocks[block as usize].name.clone(),
            Self::Spatial(v) => v.name(block as usize),
        }
    }

    /// Kinetic energy, J or J/m.
    #[must_use]
    pub fn kinetic(&self) -> f64 {
        match self {
            Self::Planar(v) => v.living().map(|b| v.kinetic(b)).sum(),
            Self::Spatial(v) => v.living().map(|b| v.kinetic(b)).sum(),
        }
    }

    /// Sum over the blocks of `m dv² + I dw²` of the coming half kick: what the books need at the start.
    #[must_use]
    pub fn half_kick(&self) -> f64 {
        match self {
            Self::Planar(v) => {
                let shapes = &v.scratch.shapes;
                let one = |b: usize| {
                    let change = &v.scratch.changes[b];
                    shapes.mass[b] * change.velocity.length_squared()
                        + shapes.inertia[b] * change.spin * change.spin
                };
                v.living().map(one).sum()
            }
            Self::Spatial(v) => v.half_kick(),
        }
    }

    /// Energy that has been put in so far, J or J/m: the scale of a blow-up.
    #[must_use]
    pub fn put_in(&self) -> f64 {
        match self {
            Self::Planar(v) => v
                .world
                .works
                .put_in(v.world.start_energy.unwrap_or_default()),
            Self::Spatial(v) => v
                .world
                .works
                .put_in(v.world.start_energy.unwrap_or_default()),
        }
    }

    /// Unbalanced-force ratio.
    #[must_use]
    pub fn unbalanced(&self) -> f64 {
        match self {
            Self::Planar(v) => v.unbalanced(),
            Self::Spatial(v) => v.unbalanced(),
        }
    }

    /// The energy ledger.
    #[must_use]
    pub fn balance(&self) -> Balance {
        match self {
            Self::Planar(v) => v.balance(),
            Self::Spatial(v) => v.balance(),
        }
    }

    /// Number of blocks that are there, after splitting and removal.
    #[must_use]
    pub fn blocks(&self) -> usize {
        match self {
            Self::Planar(v) => v.living().count(),
            Self::Spatial(v) => v.living().count(),
        }
    }

    /// Number of touching contacts, or of patches.
    #[must_use]
    pub fn contacts(&self) -> usize {
        match self {
            Self::Planar(v) => v.contacts().count(),
            Self::Spatial(v) => v.world.patches.len(),
        }
    }

    /// Deepest overlap over the smaller inscribed radius of its pair, with the pair.
    #[must_use]
    pub fn worst_overlap(&self) -> Option<(f64, u32, u32)> {
        match self {
            Self::Planar(v) => v.worst_overlap(),
            Self::Spatial(v) => v.worst_overlap(),
        }
    }

    /// Fastest block and its speed, m/s.
    #[must_use]
    pub fn fastest(&self) -> Option<Who> {
        match self {
            Self::Planar(v) => v
                .living()
                .map(|b| (b, v.velocity(b).length()))
                .max_by(|a, b| a.1.total_cmp(&b.1))
                .map(|(b, speed)| (v.world.setup.blocks[b].name.clone(), speed)),
            Self::Spatial(v) => v
                .living()
                .map(|b| (b, v.velocity(b).length()))
                .max_by(|a, b| a.1.total_cmp(&b.1))
                .map(|(b, speed)| (v.name(b), speed)),
        }
    }

    /// Charges and other cavities, for the manifest.
    #[must_use]
    pub fn sources(&self) -> Vec<Source> {
        match self {
            Self::Planar(_) => Vec::new(),
            Self::Spatial(v) => v.world.cavities.iter().map(|c| source_note(v, c)).collect(),
        }
    }

    /// Fragments now; `None` where no joints hold blocks together.
    #[must_use]
    pub fn fragments(&self) -> Option<Fragments> {
        match self {
            Self::Planar(v) => (!v.world.bonds.is_empty()).then(|| v.fragments()),
            Self::Spatial(v) => Some(v.fragments()),
        }
    }

    /// A picture.
    #[must_use]
    pub fn frame(&self, phase: &str) -> Frame {
        match self {
            Self::Planar(v) => planar::readings::frame(v, phase),
            Self::Spatial(v) => spatial::picture::frame(v, phase),
        }
    }
}

/// Joints that have broken since the last look.
fn planar_events(v: &planar::fields::View<'_>) -> Vec<serde_json::Value> {
    let world = v.world;
    let name = |b: u32| &world.setup.blocks[b as usize].name;
    world
        .bonds
        .iter()
        .filter(|b| b.broken_at == Some(world.step))
        .map(|bond| {
            serde_json::json!({
                "event": "joint_broken",
                "step": world.step,
                "time": world.time,
                "blocks": [name(bond.i), name(bond.j)],
                "length": bond.length,
            })
        })
        .collect()
}

/// A cavity as the manifest lists it, global coordinates.
fn source_note(v: &spatial::fields::View<'_>, cavity: &spatial::cavity::Cavity) -> Source {
    use crate::record::manifest::Place as Spot;
    use spatial::setup::{Place, Push};
    let setup = &v.world.setup;
    let source = &setup.sources[cavity.source as usize];
    let global = |p: Vec3| (p + setup.origin).to_array();
    let profile = v.profile(cavity);
    let place = match &source.place {
        Place::Point { centre } => Spot::Centre(global(*centre)),
        Place::Line { from, to } => Spot::Line([global(*from), global(*to)]),
        Place::Blocks { .. } => Spot::Centre(global(v.charge_centre(cavity))),
    };
    Source {
        name: source.name.clone(),
        place,
        delay: source.delay,
        mass: match source.push {
            Push::Gas { mass, .. } => Some(mass),
            Push::Pressure { .. } => None,
        },
        charge_volume: cavity.gas.map(|_| cavity.charge_volume()),
        cavity_volume: cavity.removed,
        depth: Some(profile.depth).filter(|d| *d > 0.0),
    }
}

fn break_event(
    v: &spatial::fields::View<'_>,
    event: &spatial::deform::store::Break,
) -> serde_json::Value {
    let blocks = v.softs().map(|(deform, _)| {
        let facet = &deform.facets[event.facet as usize];
        facet.blocks.map(|b| v.name(b as usize))
    });
    serde_json::json!({
        "event": "bond_broken", "step": event.step, "time": event.time,
        "blocks": blocks, "facet": event.facet,
        "area_tension": event.area[0], "area_shear": event.area[1],
        "utilisation": event.utilisation, "released": event.released,
    })
}

fn spatial_event(
    v: &spatial::fields::View<'_>,
    event: &spatial::edit::EditEvent,
) -> serde_json::Value {
    use spatial::edit::EditKind;
    let (step, time) = (event.step, event.time);
    let source = || {
        let cavity = &v.world.cavities[event.subject as usize];
        &v.world.setup.sources[cavity.source as usize].name
    };
    match event.kind {
        EditKind::Split => {
            let children: Vec<String> =
                event.children.iter().map(|&b| v.name(b as usize)).collect();
            serde_json::json!({
                "event": "block_split", "step": step, "time": time,
                "block": v.name(event.subject as usize),
                "children": children,
                "patches_before": event.patches[0], "patches_after": event.patches[1],
            })
        }
        EditKind::Cut => {
            let children: Vec<String> =
                event.children.iter().map(|&b| v.name(b as usize)).collect();
            let note = event.cut.as_ref();
            serde_json::json!({
                "event": "block_cut", "step": step, "time": time,
                "block": v.name(event.subject as usize),
                "children": children,
                "normal": note.map(|n| n.normal.to_array()),
                "way": note.map(|n| n.way),
                "excess": note.map(|n| n.excess),
                "facets_before": event.patches[0], "facets_after": event.patches[1],
            })
        }
        EditKind::Removed => serde_json::json!({
            "event": "block_removed", "step": step, "time": time,
            "block": v.name(event.subject as usize),
        }),
        EditKind::Ignited => serde_json::json!({
            "event": "charge_fired", "step": step, "time": time, "source": source(),
        }),
        EditKind::Vented => serde_json::json!({
            "event": "gas_vented", "step": step, "time": time, "source": source(),
        }),
    }
}

impl Reading {
    /// A reading of one engine.
    ///
    /// # Errors
    /// Unknown names and parts of scalars.
    pub fn new(kind: Kind, gauge: &Gauge) -> Result<Self, FieldError> {
        match kind {
            Kind::Planar => {
                let along = gauge.along.map(|[x, y, _z]| [x, y]);
                let reading = planar::readings::Reading::new(&gauge.field, &gauge.of, along)?;
                Ok(Self::Planar(reading))
            }
            Kind::Spatial => {
                let (at, along) = (gauge.at.map(Vec3::from), gauge.along.map(Vec3::from));
                let reading = spatial::readings::Reading::new(&gauge.field, &gauge.of, at, along)?;
                Ok(Self::Spatial(reading))
            }
        }
    }

    /// Table entry.
    #[must_use]
    pub fn info(&self) -> &'static FieldInfo {
        match self {
            Self::Planar(r) => r.info(),
            Self::Spatial(r) => r.info(),
        }
    }

    /// Whether reading it costs as much as a step.
    #[must_use]
    pub fn costly(&self) -> bool {
        match self {
            Self::Planar(r) => r.costly(),
            Self::Spatial(r) => r.costly(),
        }
    }

    /// The number; NaN from a view of another engine.
    #[must_use]
    pub fn value(&self, view: &View<'_>) -> f64 {
        match (self, view) {
            (Self::Planar(r), View::Planar(v)) => r.value(v),
            (Self::Spatial(r), View::Spatial(v)) => r.value(v),
            (Self::Planar(_), View::Spatial(_)) | (Self::Spatial(_), View::Planar(_)) => f64::NAN,
        }
    }
}
