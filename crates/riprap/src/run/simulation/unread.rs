//! States that nobody reads. Several ranks keep to themselves in them ([`crate::run::engine::Engine::set_unread`]).

use super::{Rules, RunError, Simulation, Stage};

impl Simulation {
    /// Whether several ranks compute this run.
    #[must_use]
    pub(in crate::run) fn is_shared(&self) -> bool {
        self.engine.exec().peers().is_some()
    }

    /// As [`Simulation::prepare`], for a state that nobody outside is going to read.
    pub(in crate::run) fn prepare_unread(&mut self) -> Result<Stage, RunError> {
        self.unread = true;
        let stage = self.prepare();
        self.unread = false;
        stage
    }

    /// Lets this rank know the whole state, after one that nobody was to read. All ranks must call it.
    pub(in crate::run) fn settle(&mut self) {
        self.engine.settle();
    }

    /// Finds the forces of the coming step, for nobody to read where nobody outside does and nothing between two steps does either.
    pub(super) fn evaluate_unread(&mut self, phase: &Rules) -> Result<(), RunError> {
        self.engine.set_unread(self.unread && self.reads_nothing(phase));
        let found = self.evaluate_step(phase);
        self.engine.set_unread(false);
        found
    }

    /// Whether no rule of the phase, guard or edit reads what the coming evaluation finds.
    fn reads_nothing(&self, phase: &Rules) -> bool {
        let plain = phase.relax.is_none() && phase.step_error.is_none() && !phase.settles;
        let leaves = self.phase().is_some_and(|phase| phase.leavers.is_some());
        let steered = !self.plan.controls.is_empty() || !self.cursor.laws.is_empty();
        // A change of the step is booked with the forces on all blocks.
        let same = self.dt == self.view().last_dt();
        plain && same && !leaves && !steered && !self.looks_at(phase)
    }
}
