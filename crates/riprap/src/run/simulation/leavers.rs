//! Blocks that leave the model in the course of a phase.

use super::{RunError, Simulation};

impl Simulation {
    /// Takes out the blocks that have left the model at the present, prepared state. What they take along is booked; the others go on
    /// with half a kick of their own, as the forces of a block that touched them are gone.
    pub(super) fn let_leave(&mut self) -> Result<(), RunError> {
        let Some(phase) = self.phase() else {
            return Ok(());
        };
        let Some(bounds) = phase.leavers else {
            return Ok(());
        };
        let damping = phase.damping_in(self.engine.is_implicit());
        let gone = self.engine.leaving(&bounds);
        if gone.is_empty() {
            return Ok(());
        }
        let ended = self.engine.end_motion(&damping);
        ended.map_err(|block| self.no_force(block))?;
        self.evaluate(&damping, 0.0)?;
        let before = self.view().balance().residual();
        let told = self.engine.let_leave(&gone);
        self.cursor.departed.extend(told);
        self.evaluate(&damping, self.dt)?;
        let after = self.view().balance().residual();
        self.engine.works().left += before - after;
        Ok(())
    }
}
