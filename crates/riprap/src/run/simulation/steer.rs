//! Changes by code in the loop.

use super::{Simulation, Snapshot};
use crate::run::engine::steer::{SteerError, Steered};

impl Simulation {
    /// Gives a load or a support that the scene names another value from the present instant on, in place of its function of time. The
    /// same changes at the same steps give the same bits.
    ///
    /// # Errors
    /// A name of nothing, a value that it does not take.
    ///
    /// # Examples
    ///
    /// ```
    /// use riprap::run::engine::steer::Steered;
    /// use riprap::run::simulation::Simulation;
    ///
    /// let mut simulation = Simulation::from_toml(
    ///     r#"
    ///     riprap = 1
    ///     title = "a pushed stone"
    ///     [space.planar]
    ///     gravity = ["0 m/s2", "0 m/s2"]
    ///     [materials.rock]
    ///     density = "2500 kg/m3"
    ///     [interfaces.default]
    ///     normal_stiffness = "1 GPa/m"
    ///     friction_angle = "30 deg"
    ///     [[blocks]]
    ///     name = "stone"
    ///     material = "rock"
    ///     rectangle = { size = ["1 m", "1 m"], corner = ["0 m", "0 m"] }
    ///     [[loads]]
    ///     name = "push"
    ///     on.block = "stone"
    ///     point = { force = ["2500 N/m", "0 N/m"] }
    ///     [[phases]]
    ///     name = "go"
    ///     until = { time = "1 s" }
    ///     time_step = "1 ms"
    ///     "#,
    /// )?;
    /// // One metre per second squared, then nothing.
    /// simulation.advance(100)?;
    /// simulation.steer("push", Steered::Factor(0.0))?;
    /// simulation.run()?;
    /// assert!((simulation.field("block.velocity.x", &["stone"])? - 0.1).abs() < 1e-3);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn steer(&mut self, name: &str, to: Steered) -> Result<(), SteerError> {
        self.engine.steer(name, to)?;
        self.standing = false;
        Ok(())
    }

    /// Goes back to a snapshot of this run.
    pub(crate) fn restore(&mut self, snapshot: Snapshot) {
        let Snapshot { plan, cursor, state } = snapshot;
        (self.plan, self.cursor) = (plan, cursor);
        self.engine.restore(state);
        self.standing = false;
        self.stable = None;
        self.reason = None;
    }
}
