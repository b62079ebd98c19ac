//! The engines behind one face: what the run loop, the recorder and the checks ask of whichever engine
//! a scene needs. A closed choice: every question is a `match` over both.

mod add;
mod edit;
mod leave;
mod nodes;
mod notes;
mod own;
mod pins;
mod reading;
pub mod steer;
mod step_error;
mod view;

use serde::{Deserialize, Serialize};
use thiserror::Error;

pub use add::NewBlock;
pub(in crate::run) use add::{Addition, NewBolt};
pub use leave::Departed;
pub use nodes::Nodes;
pub(in crate::run) use own::{Met, Wrenches, wrench};
pub use reading::Reading;
pub use view::{Drawn, Movement, View};

use crate::exec::Exec;
use crate::ledger::Works;
use crate::plan::{Damping, Phase, TimeStep};
use crate::profile::Profile;
use crate::record::field::FieldInfo;
use crate::setup::Setup;
use crate::{Vec2, Vec3};
use crate::{planar, spatial};

/// A block may cross at most this share of its neighbourhood's inscribed radius in one step.
const TRANSIT: f64 = 0.2;

/// Which engine.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Kind {
    /// Polygons in the plane, results for each metre of thickness.
    Planar,
    /// Polygons in the plane, results of a slice of given thickness.
    Slice,
    /// Blocks in space.
    Spatial,
}

impl Kind {
    /// The engine a model needs.
    #[must_use]
    pub fn of(setup: &Setup) -> Self {
        match setup {
            Setup::Planar(setup) => Kind::in_plane(setup),
            Setup::Spatial(_) => Kind::Spatial,
        }
    }

    fn in_plane(setup: &planar::setup::Setup) -> Self {
        match setup.thickness {
            None => Kind::Planar,
            Some(_) => Kind::Slice,
        }
    }

    /// Everything that can be read from it.
    #[must_use]
    pub fn fields(self) -> &'static [FieldInfo] {
        match self {
            Kind::Planar => planar::fields::INFOS,
            Kind::Slice => &planar::fields::INFOS_OF_SLICE,
            Kind::Spatial => spatial::fields::INFOS,
        }
    }

    /// Unit of energies: J per metre of thickness in the plane without a thickness.
    #[must_use]
    pub fn energy_unit(self) -> &'static str {
        match self {
            Kind::Planar => "J/m",
            Kind::Slice | Kind::Spatial => "J",
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

impl State {
    /// The same, to be written.
    #[must_use]
    pub fn as_ref(&self) -> StateRef<'_> {
        match self {
            Self::Planar(world) => StateRef::Planar(world),
            Self::Spatial(world) => StateRef::Spatial(world),
        }
    }
}

/// A [`State`] to be written, of which nothing is copied: the same variants in the same order.
#[derive(Clone, Copy, Debug, Serialize)]
pub enum StateRef<'a> {
    /// Of the planar engine.
    Planar(&'a planar::world::World),
    /// Of the spatial engine.
    Spatial(&'a spatial::world::World),
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
    fn view(&self) -> planar::view::View<'_> {
        planar::view::View { world: &self.world, scratch: &self.scratch }
    }
}

/// The spatial engine.
#[derive(Debug)]
pub struct Spatial {
    world: spatial::world::World,
    scratch: spatial::step::Scratch,
}

impl Spatial {
    fn view(&self) -> spatial::view::View<'_> {
        spatial::view::View { world: &self.world, scratch: &self.scratch }
    }
}

/// A stable time step.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Stable {
    /// Longest stable step, s; infinite when nothing can touch.
    pub dt: f64,
    /// Block that sets it.
    pub block: Option<u32>,
}

/// State of a relaxing phase.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Relaxed {
    /// Whether the last look found it converged.
    pub converged: bool,
    /// Iterations since loads or bonds last changed.
    pub iterations: u64,
    /// Ratio of net to external forces at the last look.
    pub ratio: f64,
    /// Whether the present state is an equilibrium that a load step is about to leave.
    pub leaving: bool,
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
                let (world, scratch) = planar::world::World::new(*setup, exec);
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
                // Lists and workspace are not part of the state: what they hold follows from it.
                let scratch = planar::step::Scratch::new(&mut world, exec);
                Self::Planar(Box::new(Planar { world: *world, scratch }))
            }
            State::Spatial(mut world) => {
                let scratch = spatial::step::Scratch::new(&mut world, exec);
                Self::Spatial(Box::new(Spatial { world: *world, scratch }))
            }
        }
    }

    /// Goes to a state of this model; timers go on.
    pub fn restore(&mut self, state: State) {
        let exec = either!(self, e => std::mem::replace(&mut e.scratch.exec, Exec::serial()));
        let mut there = Self::resume(state, exec);
        std::mem::swap(there.timers(), self.timers());
        *self = there;
    }

    /// Which engine it is.
    #[must_use]
    pub fn kind(&self) -> Kind {
        match self {
            Self::Planar(e) => Kind::in_plane(&e.world.setup),
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

    /// The state, to be written.
    #[must_use]
    pub fn state_ref(&self) -> StateRef<'_> {
        match self {
            Self::Planar(e) => StateRef::Planar(&e.world),
            Self::Spatial(e) => StateRef::Spatial(&e.world),
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
            // New neighbours or an edit can shorten it, and both rebuild the lists.
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
                Stable { dt: found.dt, block: found.block }
            }
            Self::Spatial(e) => {
                let found = spatial::stable::stable_step(&e.world, &e.scratch, stiffness_damping);
                Stable { dt: found.dt, block: found.block }
            }
        }
    }

    /// Longest step that the present motion allows whatever the rule of the phase, s: fast blocks in the
    /// plane, the gas of a cavity and the found contacts (see [`Self::contact_step_limit`]) in space.
    #[must_use]
    pub fn step_limit(&self, rule: TimeStep) -> f64 {
        match self {
            Self::Planar(e) => TRANSIT * e.scratch.transit,
            Self::Spatial(e) => {
                spatial::charge::step_limit(&e.world).min(self.contact_step_limit(rule))
            }
        }
    }

    /// What [`Self::step_limit`] comes from, in words.
    #[must_use]
    pub fn limited_by(&self, rule: TimeStep) -> &'static str {
        match self {
            Self::Planar(_) => "a block that moves fast for its size",
            Self::Spatial(e) => {
                let gas = spatial::charge::step_limit(&e.world) < self.contact_step_limit(rule);
                if gas { "expanding gas" } else { "blocks in contact, or fast for their size" }
            }
        }
    }

    /// What the fastest block has crossed of its neighbourhood's inscribed radius in the step of `dt` (s) that was just done; in space,
    /// where the depth of contacts is known at every step, 0.
    #[must_use]
    pub fn crossed(&self, dt: f64) -> f64 {
        match self {
            Self::Planar(e) => dt / e.scratch.transit,
            Self::Spatial(_) => 0.0,
        }
    }

    /// Longest step that contacts found in space allow, s; infinite where there are none. Under a rule with less than the usual
    /// share of the stable step they are given that much less as well.
    #[must_use]
    pub fn contact_step_limit(&self, rule: TimeStep) -> f64 {
        match self {
            Self::Planar(_) => f64::INFINITY,
            Self::Spatial(e) => rule.of_contacts() * spatial::step_limit(&e.world),
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

    /// Splits and cuts the blocks whose criterion is met, after [`Engine::evaluate`] with the same step, and re-evaluates.
    ///
    /// # Errors
    /// The edit is not exact, or makes too many blocks: what is wrong, in words.
    pub fn divide(&mut self, dt: f64) -> Result<(), String> {
        match self {
            Self::Planar(_) => Ok(()),
            Self::Spatial(e) => spatial::topology::divide(&mut e.world, &mut e.scratch, dt)
                .map_err(|error| error.to_string()),
        }
    }

    /// Whether nobody reads the coming evaluation and the step after it: ranks may keep to themselves then, and [`Engine::settle`] comes
    /// before the next reading that no evaluation precedes.
    pub fn set_unread(&mut self, unread: bool) {
        if let Self::Spatial(e) = self {
            e.scratch.unread = unread;
        }
    }

    /// Lets all ranks know the whole state again, after a step that nobody was to read; all of them must call it.
    pub fn settle(&mut self) {
        if let Self::Spatial(e) = self {
            spatial::settle(&mut e.world, &mut e.scratch);
        }
    }

    /// Moves on by `dt` (s).
    pub fn advance(&mut self, dt: f64) {
        match self {
            Self::Planar(e) => planar::step::advance(&mut e.world, &mut e.scratch, dt),
            Self::Spatial(e) => spatial::step::advance(&mut e.world, &mut e.scratch, dt),
        }
    }

    /// Ends a motion with the half kick of the forces that act now: what comes next begins with half a kick of its own.
    ///
    /// # Errors
    /// A block whose forces are not finite.
    pub fn end_motion(&mut self, damping: &Damping) -> Result<(), u32> {
        match self {
            Self::Planar(e) => {
                planar::step::end_motion(&mut e.world, &mut e.scratch, damping).map_err(|e| e.block)
            }
            Self::Spatial(e) => spatial::step::end_motion(&mut e.world, &mut e.scratch, damping)
                .map_err(|e| e.block),
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
                    ratio: relax.ratio,
                    leaving: relax.increment > 0.0,
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
            Self::Spatial(e) => spatial::topology::fracture::step(&mut e.world, &mut e.scratch, dt)
                .map_err(|e| e.block),
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

    /// Steps implicitly, or explicitly, from here on.
    pub fn integrate_implicitly(&mut self, implicit: bool) {
        match self {
            Self::Planar(_) => {}
            Self::Spatial(e) => spatial::choose_integration(&mut e.world, &mut e.scratch, implicit),
        }
    }

    /// What of the model implicit phases do not take.
    #[must_use]
    pub fn obstacle(&self) -> Option<spatial::Obstacle> {
        match self {
            Self::Planar(_) => None,
            Self::Spatial(e) => spatial::obstacle(&e.world),
        }
    }

    /// Whether steps are implicit.
    #[must_use]
    pub fn is_implicit(&self) -> bool {
        match self {
            Self::Planar(_) => false,
            Self::Spatial(e) => e.world.implicit.is_some(),
        }
    }

    /// Longest step of a static implicit phase, s: twice the last one, and such that no block moves far for its size in it.
    #[must_use]
    pub fn settling_step(&self) -> f64 {
        match self {
            Self::Planar(_) => f64::INFINITY,
            Self::Spatial(e) => spatial::settling_step(&e.world),
        }
    }

    /// Way of a block in the last step at most, over half its shortest edge.
    #[must_use]
    pub fn settling_way(&self) -> f64 {
        match self {
            Self::Planar(_) => f64::INFINITY,
            Self::Spatial(e) => spatial::settling_way(&e.world),
        }
    }

    /// Blocks (twice the same one where it is one alone) whose contact has kept the last implicit step from a solution, and its rounds.
    #[must_use]
    pub fn not_solved(&self) -> Option<spatial::NotSolved> {
        match self {
            Self::Planar(_) => None,
            Self::Spatial(e) => e.scratch.not_solved(),
        }
    }

    /// Measures displacements from here on.
    pub fn zero_displacements(&mut self) {
        match self {
            Self::Planar(e) => e.world.zero_displacements(),
            Self::Spatial(e) => {
                // Taken out first: the view borrows the world that the next line changes.
                let poses = e.view().present_poses();
                e.world.zero_displacements(poses);
            }
        }
    }

    /// Applies what a phase changes in blocks, supports, bolts and laws; forces must be re-evaluated afterwards.
    ///
    /// # Errors
    /// A bolt that cannot be installed, in words.
    pub fn edit(&mut self, phase: &Phase) -> Result<(), String> {
        match self {
            Self::Planar(e) => {
                edit::planar(&mut e.world, &e.scratch, phase).map_err(|error| error.to_string())?;
                // Supports, laws and the number of blocks may have changed, and the lists were built for those before.
                e.scratch.invalidate(&mut e.world);
            }
            Self::Spatial(e) => {
                edit::spatial(&mut e.world, &e.scratch, phase)
                    .map_err(|error| error.to_string())?;
                e.scratch.invalidate(&mut e.world);
            }
        }
        Ok(())
    }

    /// Takes what has happened since the last look, one JSON object each: joints broken, blocks split or
    /// removed, charges fired. `again`: the step has been looked at before.
    pub fn take_events(&mut self, again: bool) -> Vec<serde_json::Value> {
        match self {
            // The plane keeps no list of events that a look would empty: it compares
            // steps, and would find the same ones again.
            Self::Planar(_) if again => Vec::new(),
            Self::Planar(e) => notes::planar_events(&e.view()),
            Self::Spatial(e) => {
                let events = std::mem::take(&mut e.world.events);
                let deform = e.world.deform.as_mut();
                let broken = deform.map(|d| std::mem::take(&mut d.broken));
                let view = e.view();
                let others = broken.iter().flatten().map(|b| notes::break_event(&view, b));
                let edits = events.iter().map(|event| notes::spatial_event(&view, event));
                edits.chain(others).collect()
            }
        }
    }

    /// The running sums of the ledger.
    pub fn works(&mut self) -> &mut Works {
        either!(self, e => &mut e.world.works)
    }

    /// Kinetic and stored energy at the start, once known.
    pub fn start_energy(&mut self) -> &mut Option<f64> {
        either!(self, e => &mut e.world.start_energy)
    }

    /// How the model is shared out among so many ranks at the start; `None` where all compute all of it.
    #[must_use]
    pub fn parts(&self, ranks: usize) -> Option<Vec<spatial::Part>> {
        match self {
            Self::Planar(_) => None,
            Self::Spatial(e) => Some(spatial::parts(&e.world, ranks)),
        }
    }

    /// Threads, and the ranks that compute the same model.
    #[must_use]
    pub fn exec(&self) -> &Exec {
        either!(self, e => &e.scratch.exec)
    }

    fn timers(&mut self) -> &mut Profile {
        either!(self, e => &mut e.scratch.profile)
    }

    /// Stage times.
    #[must_use]
    pub fn profile(&self) -> &Profile {
        either!(self, e => &e.scratch.profile)
    }

    /// blake3 of the state: equal hashes mean equal bits of motion and contact memory.
    #[must_use]
    pub fn hash(&self) -> String {
        either!(self, e => e.world.hash())
    }
}
