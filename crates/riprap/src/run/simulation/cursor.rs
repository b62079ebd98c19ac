//! Where a run is in its plan, and what it needs to go on.

use serde::{Deserialize, Serialize};

use super::Spent;
use super::law_state::Held;
use crate::ledger::Unexplained;
use crate::plan::Plan;
use crate::run::engine::steer::{SteerError, Steered};
use crate::run::engine::{Departed, Stable, State, StateRef, View};

/// Where in the plan a run is.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Cursor {
    /// Index of the phase.
    pub phase: usize,
    /// Whether the phase has been entered.
    pub entered: bool,
    /// Model time at the start of the phase, s.
    pub start_time: f64,
    /// Step count at the start of the phase.
    pub start_step: u64,
    /// Gravity before the phase, m/s².
    pub gravity_before: [f64; 3],
    /// Gravity the phase ends with, m/s².
    pub gravity_after: [f64; 3],
    /// Steps shortened by the engine: fast blocks, expanding gas.
    pub shortened: u64,
    /// Relaxing phases that ended at their limit of iterations.
    pub unconverged: Vec<Unconverged>,
    /// The largest energies seen so far that the ledger does not account for, in the order of [`Unexplained::ALL`].
    pub unexplained: [Residual; 3],
    /// How the phases so far have ended.
    pub ends: Vec<PhaseEnd>,
    /// What was pressed deepest so far, where it was worth a warning.
    pub deepest: Option<Deep>,
    /// How phases were stepped that left the choice, in words.
    pub chosen: Vec<String>,
    /// What the run went through that its laws do not mean.
    pub noted: Noted,
    /// What the fastest block has crossed of its neighbourhood's inscribed radius since overlaps were last looked at.
    pub crossed: f64,
    /// The largest overlap over the smaller inscribed radius at the start of the run.
    pub overlap_at_start: f64,
    /// The stable step that was last looked for: joints that have given way since do not lengthen it, so that a run that is stopped
    /// goes on with the same.
    pub stable: Option<Stable>,
    /// The largest kinetic energy seen so far, J; in the plane per metre of thickness.
    pub kinetic_peak: f64,
    /// Time since which the model rests as the phase asks, s.
    pub resting_since: Option<f64>,
    /// The step for which the last forces of the last phase were found, s: dampers depend on it, and a run that is resumed at its end finds
    /// these forces again.
    pub closing_dt: f64,
    /// Blocks that have left the model and have not been recorded yet.
    pub departed: Vec<Departed>,
    /// What forces had done when the present phase began, if it is an implicit static one.
    pub spent: Spent,
    /// Laws of code, whose functions are not part of it.
    pub laws: Vec<Held>,
}

/// What a block is pressed into.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Into {
    /// Another block.
    Block,
    /// What a condition has put behind its face.
    Condition,
}

/// Two blocks that lay deep in each other, or one that was pressed into what holds its face.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Deep {
    /// Depth over the smaller inscribed radius; of deformable blocks over the distance of the centre from the surface.
    pub ratio: f64,
    /// Depth, m.
    pub depth: f64,
    /// Their names, the second that of the condition where it is one.
    pub blocks: [String; 2],
    /// What the second one is.
    pub into: Into,
    /// Step.
    pub step: u64,
    /// Model time, s.
    pub time: f64,
}

impl std::fmt::Display for Deep {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let [a, b] = &self.blocks;
        if self.into == Into::Condition {
            return write!(
                f,
                "block `{a}` was pressed {:.3e} m into boundary `{b}`, {:.0} % of its inscribed radius (step {}, t = {:.4e} s): the rock is too soft \
                 for the load; use a larger `young` or a smaller load",
                self.depth,
                100.0 * self.ratio,
                self.step,
                self.time
            );
        }
        write!(
            f,
            "blocks `{a}` and `{b}` were pressed {:.3e} m into each other, {:.0} % of the inscribed radius of the thinner one (step {}, t = {:.4e} \
             s): the contact is too soft for the load; use a larger `normal_stiffness` (for materials with a `brittle_bond` where one block is \
             deformable: that of the bond, or a smaller `thickness`), or `stiffening_depth` for contacts of rigid blocks",
            self.depth,
            100.0 * self.ratio,
            self.step,
            self.time
        )
    }
}

/// An energy that the ledger does not account for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Residual {
    /// Over the largest energy that had moved by then.
    pub share: f64,
    /// Step.
    pub step: u64,
    /// Model time, s.
    pub time: f64,
}

impl Residual {
    /// In words.
    #[must_use]
    pub fn told(&self, what: Unexplained) -> String {
        format!(
            "{what} reached {:.1} % of the largest energy exchanged (step {}, t = {:.4e} s); repeat the run with a shorter time step to see whether \
             the step causes it and whether results depend on it",
            100.0 * self.share,
            self.step,
            self.time
        )
    }
}

/// What ended a phase.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Reason {
    /// Its time has passed.
    Time,
    /// Its steps are used up.
    Steps,
    /// The unbalanced forces are small enough.
    Balanced,
    /// The kinetic energy is small enough.
    AtRest,
    /// Forces are balanced by dashpots alone, and have been for long: it sinks and never comes to rest.
    Sinking,
    /// The iterations of a relaxing phase are used up.
    Iterations,
}

/// How a phase has ended.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct PhaseEnd {
    /// Name of the phase.
    pub phase: String,
    /// Whether it was to come to rest.
    pub quiet: bool,
    /// What ended it.
    pub reason: Reason,
    /// Unbalanced-force ratio at its end.
    pub unbalanced: f64,
    /// Unbalanced-force ratio that was asked for.
    pub wanted: Option<f64>,
    /// The block that is farthest from balance, with its own ratio of net force to forces.
    pub worst: Option<(String, f64)>,
    /// The block that would go farthest in another such phase, with that way over its size.
    pub moving: Option<(String, f64)>,
    /// What may have been thrown by blocks that were built into each other.
    pub thrown: Option<Thrown>,
    /// What dashpots of viscous faces carry over all forces, and the condition whose faces carry most.
    pub sinking: Option<(f64, String)>,
    /// Share of the work of weight and loads that friction has taken, where blocks have slid in the long steps of an implicit static phase.
    pub rubbed: Option<f64>,
}

/// A block that has gone far while blocks that lay in each other gave back energy.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Thrown {
    /// Name of the block that has gone farthest since displacements were last set.
    pub block: String,
    /// That way over its size.
    pub way: f64,
    /// Energy that was given back, J.
    pub energy: f64,
}

/// A block with a larger ratio of net force to the forces on it than this is not held: it falls or slides.
const FALLS: f64 = 0.5;
/// Dashpots that carry a larger share of all forces than this let the model sink, where no other is asked for.
const SINKS: f64 = 1e-3;
/// A block that would go this share of its own size in another phase as long as the last one is not at rest.
const MOVES: f64 = 0.1;
/// Share of the energy put in that blocks which lay in each other must have given back for one of them to have been thrown by it.
const GAVE_BACK: f64 = 0.1;

impl Thrown {
    /// The free block that has gone farthest, if it is farther than its own size and overlaps have given back enough.
    pub(super) fn of(view: &View) -> Option<Self> {
        let energy = view.released_by_overlaps();
        if energy <= GAVE_BACK * view.put_in() {
            return None;
        }
        // The way since displacements were last set, not the speed: a block that was thrown may lie still by now.
        let ways = view.movements().into_iter().map(|m| {
            let [x, y, z] = m.shift;
            (m.block, (x * x + y * y + z * z).sqrt() / m.size)
        });
        let (block, way) = ways.max_by(|a, b| a.1.total_cmp(&b.1))?;
        (way > 1.0).then(|| Self { block: view.name(block), way, energy })
    }
}

impl PhaseEnd {
    /// What ended the phase, in words.
    #[must_use]
    pub fn words(&self) -> &'static str {
        match self.reason {
            Reason::Time => "its time has elapsed",
            Reason::Steps => "all its steps are done",
            Reason::Balanced if self.restless().is_some() => {
                "the forces are balanced overall, but not on every block"
            }
            Reason::Balanced => "the forces are balanced",
            Reason::AtRest if self.restless().is_some() => {
                "the model is at rest overall, but not every block"
            }
            Reason::AtRest => "it is at rest",
            Reason::Sinking => "it sinks into its viscous boundaries and cannot come to rest",
            Reason::Iterations => "all its iterations are done",
        }
    }

    /// What is not at rest, in words.
    #[must_use]
    pub fn restless(&self) -> Option<String> {
        let sinks = |(share, _): &&(f64, String)| *share > self.wanted.unwrap_or(SINKS);
        if let Some((share, boundary)) = self.sinking.as_ref().filter(sinks) {
            return Some(format!(
                "the dashpots of the viscous boundary `{boundary}` carry {share:.1e} of all forces, and the model sinks into them: dashpots carry no \
                 load at rest; hold the base in a static phase (`held`), or give `[in_situ]`, the stress that viscous faces balance"
            ));
        }
        if let Some((name, ratio)) = self.worst.as_ref().filter(|(_, ratio)| *ratio > FALLS) {
            return Some(format!(
                "the net force on block `{name}` is {:.0} % of the forces that act on it (it falls or slides)",
                100.0 * ratio
            ));
        }
        let (name, way) = self.moving.as_ref().filter(|(_, way)| *way > MOVES)?;
        Some(format!(
            "block `{name}` moves: in another phase of this length it would travel {way:.1e} times its own size"
        ))
    }

    /// That forces may be locked in, in words.
    #[must_use]
    pub fn locked_in(&self) -> Option<String> {
        let share = self.rubbed?;
        Some(format!(
            "blocks slid in the implicit static phase `{}`: friction took {:.0} % of the work of weight and loads. Long steps can drive blocks into each \
             other, where friction locks in forces that weight alone would not hold, and the equilibrium depends on the step; repeat the phase with \
             `integration = \"explicit\"`, or a dynamic phase after it, and compare",
            self.phase,
            100.0 * share
        ))
    }

    /// The block that may have been thrown, in words.
    #[must_use]
    pub fn thrown(&self) -> Option<String> {
        let Thrown { block, way, energy } = self.thrown.as_ref()?;
        Some(format!(
            "initial overlaps had released {energy:.1e} J at the end of phase `{}`, and block `{block}` had travelled {way:.1} times its own size: \
             check whether it was ejected; a smaller `normal_stiffness` separates blocks more gently",
            self.phase
        ))
    }

    /// What is wrong with the end of a static phase, if something is.
    #[must_use]
    pub fn warning(&self) -> Option<String> {
        if !self.quiet {
            return None;
        }
        let phase = &self.phase;
        let restless = self.restless();
        let unused = match self.reason {
            Reason::Time => Some("time"),
            Reason::Steps => Some("steps"),
            Reason::Iterations => Some("iterations"),
            Reason::Balanced | Reason::AtRest | Reason::Sinking => None,
        };
        // Iterations without balance are reported by `Unconverged`.
        if let (Some(what), Some(wanted)) = (unused, self.wanted)
            && self.unbalanced > wanted
            && self.reason != Reason::Iterations
        {
            let also = restless.map_or(String::new(), |words| format!("; {words}"));
            return Some(format!(
                "phase `{phase}` reached its limit of {what} without equilibrium: the unbalanced-force ratio is {:.1e}, the limit {wanted:.1e}{also}",
                self.unbalanced
            ));
        }
        restless.map(|words| match unused {
            Some(what) => format!(
                "phase `{phase}` reached its limit of {what} before every block was at rest: {words}"
            ),
            None if self.reason == Reason::Sinking => {
                format!("phase `{phase}` ended before the model was at rest: {words}")
            }
            None => format!(
                "phase `{phase}` ended in overall equilibrium, but not every block is in equilibrium: {words}"
            ),
        })
    }
}

/// A relaxing phase that ended at its limit of iterations.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Unconverged {
    /// Name of the phase.
    pub phase: String,
    /// Iterations since loads or bonds last changed.
    pub iterations: u64,
    /// Ratio of net to external forces at the end.
    pub ratio: f64,
    /// Ratio that was asked for.
    pub wanted: f64,
}

impl std::fmt::Display for Unconverged {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(
            f,
            "phase `{}` ended after {} iterations without equilibrium: the unbalanced forces are {:.1e} of the external forces, the limit is {:.1e}; \
             either the rock has failed, or `iterations` is too small",
            self.phase, self.iterations, self.ratio, self.wanted
        )
    }
}

/// Everything a run needs to go on.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Snapshot {
    /// Plan of the run.
    pub plan: Plan,
    /// Place in the plan.
    pub cursor: Cursor,
    /// State of the model.
    pub state: State,
}

impl Snapshot {
    /// The same, to be written.
    #[must_use]
    pub fn as_ref(&self) -> SnapshotRef<'_> {
        SnapshotRef { plan: &self.plan, cursor: &self.cursor, state: self.state.as_ref() }
    }

    /// Gives a load or a support another value.
    ///
    /// # Errors
    /// A name of nothing, a value that it does not take.
    pub(crate) fn steer(&mut self, name: &str, to: Steered) -> Result<(), SteerError> {
        self.state.steer(name, to)
    }

    /// Looks at the numbers that stand for blocks, rows, nodes and phases.
    ///
    /// # Errors
    /// The first that stands for nothing, in words.
    pub fn sound(&self) -> Result<(), String> {
        let (phase, phases) = (self.cursor.phase, self.plan.phases.len());
        if phase > phases {
            return Err(format!("phase {phase} of {phases} does not exist"));
        }
        match &self.state {
            State::Planar(world) => world.sound(),
            State::Spatial(world) => world.sound(),
        }
    }
}

/// A [`Snapshot`] to be written, of which nothing is copied: the same fields in the same order.
#[derive(Clone, Debug, Serialize)]
pub struct SnapshotRef<'a> {
    pub(super) plan: &'a Plan,
    pub(super) cursor: &'a Cursor,
    pub(super) state: StateRef<'a>,
}

/// What has just come to an end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stage {
    /// Within a phase: [`step`](super::Simulation::step) may be called.
    Within,
    /// A phase has reached its end: [`next_phase`](super::Simulation::next_phase) goes on.
    PhaseEnd,
    /// All phases are done.
    Done,
}

/// What was noted so far.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Noted {
    /// The largest turn of a block under kinematics for small ones.
    pub turned: Option<Turned>,
    /// The tetrahedron that was farthest beyond its law.
    pub strained: Option<Noticed>,
    /// The bolt that was drawn out by most of its length.
    pub drawn: Option<Noticed>,
    /// Since when forces of a static phase have been balanced by dashpots: step, and what they carried over all forces then.
    pub sinking: Option<(u64, f64)>,
}

/// A block that turned far.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Turned {
    /// Its name.
    pub block: String,
    /// How far, rad.
    pub angle: f64,
    /// Step.
    pub step: u64,
    /// Model time, s.
    pub time: f64,
}

/// Something that was noticed, in words.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Noticed {
    /// How far it was beyond what is meant.
    pub size: f64,
    /// What it was.
    pub words: String,
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::run::simulation::Simulation;

    const REST: &str = r#"
        friction_angle = "30 deg"
        [[phases]]
        name = "fall"
        until = { time = "1 s" }
        time_step = "1 ms"
        [[supports]]
        on = { block = "low" }
        fixed = {}
        [[blocks]]
        name = "low"
        material = "rock"
    "#;

    fn snapshot(head: &str, low: &str, high: &str) -> Snapshot {
        let text = format!(
            "riprap = 1\ntitle = \"two\"\n{head}\n[interfaces.default]\nnormal_stiffness = \"1 GPa/m\"\n{REST}\n{low}\n\
             [[blocks]]\nname = \"high\"\nmaterial = \"rock\"\n{high}\n"
        );
        Simulation::from_toml(&text).unwrap().snapshot()
    }

    fn plane() -> Snapshot {
        snapshot(
            "[space.planar]\ngravity = [\"0 m/s2\", \"-10 m/s2\"]\n[materials.rock]\ndensity = \"2500 kg/m3\"",
            "rectangle = { size = [\"1 m\", \"1 m\"], corner = [\"0 m\", \"0 m\"] }",
            "rectangle = { size = [\"1 m\", \"1 m\"], corner = [\"0 m\", \"1 m\"] }",
        )
    }

    fn space() -> Snapshot {
        snapshot(
            "[space.spatial]\ngravity = \"10 m/s2\"\n[materials.rock]\ndensity = \"2500 kg/m3\"\nyoung = \"20 GPa\"\npoisson = 0.2",
            "brick = { size = [\"1 m\", \"1 m\", \"1 m\"], corner = [\"0 m\", \"0 m\", \"0 m\"] }",
            "brick = { size = [\"1 m\", \"1 m\", \"1 m\"], corner = [\"0 m\", \"0 m\", \"1 m\"] }",
        )
    }

    /// A checkpoint made by hand, with a sound sum, made the engines read beyond their lists.
    #[test]
    fn numbers_that_stand_for_nothing_are_refused_in_the_plane() {
        let mutations: [fn(&mut crate::planar::world::World); 7] = [
            |world| world.alive.clear(),
            |world| world.setup.blocks[0].material = 9,
            |world| world.setup.pair_table[0] = 9,
            |world| world.setup.supports[0].blocks[0] = 9,
            |world| world.setup.interfaces.clear(),
            |world| world.water = Some(3),
            |world| world.bodies.clear(),
        ];
        assert_eq!(plane().sound(), Ok(()));
        for (k, mutate) in mutations.into_iter().enumerate() {
            let mut forged = plane();
            let State::Planar(world) = &mut forged.state else { panic!("a scene in the plane") };
            mutate(world);
            assert!(forged.sound().is_err(), "mutation {k}");
        }
        let mut forged = plane();
        forged.cursor.phase = 7;
        assert_eq!(forged.sound().unwrap_err(), "phase 7 of 1 does not exist");
    }

    #[test]
    fn numbers_that_stand_for_nothing_are_refused_in_space() {
        let mutations: [fn(&mut crate::spatial::world::World); 9] = [
            |world| world.alive.clear(),
            |world| world.solid[1] = 9,
            |world| world.patches.ends[0] = [0, 9],
            |world| world.patches.class[0] = 9,
            |world| world.patches.flags.clear(),
            |world| world.classes[0].row = 9,
            |world| world.faces[0].block = 9,
            |world| world.setup.names.clear(),
            |world| world.bodies.velocity[2].clear(),
        ];
        assert_eq!(space().sound(), Ok(()));
        for (k, mutate) in mutations.into_iter().enumerate() {
            let mut forged = space();
            let State::Spatial(world) = &mut forged.state else { panic!("a scene in space") };
            mutate(world);
            assert!(forged.sound().is_err(), "mutation {k}");
        }
    }
}
