//! Servos: loads and motions that keep fields at values.
//!
//! What they ask for is read from the forces of a step and acts from the next one on. It stands in the laws of loads and motions of the
//! world, so that a checkpoint holds it, and the work of it is booked as that of any load or support.

use super::{RunError, Simulation};
use crate::plan::{Acts, Control};
use crate::run::engine::Reading;
use crate::run::engine::steer::Steered;

impl Simulation {
    /// Finds what the servos read; at the start of a run loads begin with nothing, and supports at rest.
    pub(super) fn begin_controls(&mut self) -> Result<(), RunError> {
        let kind = self.kind();
        let fails = |control: &Control, reason: String, now: &Self| RunError::Control {
            name: control.name.clone(),
            reason,
            step: now.steps(),
            time: now.time(),
        };
        let mut readings = Vec::new();
        for control in self.plan.controls.clone() {
            let reading = Reading::new(kind, &control.gauge)
                .map_err(|wrong| fails(&control, wrong.to_string(), self))?;
            readings.push(reading);
            if self.steps() > 0 || self.cursor.entered {
                continue;
            }
            let nothing = match control.acts {
                Acts::Load { .. } => Steered::Factor(0.0),
                Acts::Velocity(_) => Steered::Velocity([0.0; 3]),
            };
            let begun = self.engine.steer(&control.name, nothing);
            begun.map_err(|wrong| fails(&control, wrong.to_string(), self))?;
        }
        self.readings = Some(readings);
        Ok(())
    }

    /// What the servos ask for, by the forces of the present, prepared state.
    pub(super) fn asked_by_controls(&self) -> Vec<Steered> {
        let readings = self.readings.iter().flatten();
        let view = self.view();
        let pairs = self.plan.controls.iter().zip(readings);
        pairs
            .map(|(control, reading)| {
                let value = reading.value(&view);
                let off = (control.target - value) / (control.band * control.target);
                // What cannot be read (blocks that do not touch yet) is nothing.
                let off = if off.is_finite() { off.clamp(-1.0, 1.0) } else { 1.0 };
                match control.acts {
                    Acts::Load { rise } => {
                        let now = self.engine.factor(&control.name).unwrap_or(0.0);
                        Steered::Factor((now + off * self.dt / rise).max(0.0))
                    }
                    Acts::Velocity(velocity) => Steered::Velocity(velocity.map(|v| off * v)),
                }
            })
            .collect()
    }

    /// Gives loads and supports what the servos have asked for.
    pub(super) fn control(&mut self, asked: Vec<Steered>) {
        for (control, to) in self.plan.controls.iter().zip(asked) {
            // Names and values have been tried when the run began.
            let done = self.engine.steer(&control.name, to);
            debug_assert!(done.is_ok(), "{done:?}");
        }
    }
}

#[cfg(all(test, feature = "scenario"))]
mod tests {
    use std::path::PathBuf;

    use super::*;
    use crate::exec::Exec;
    use crate::run::scene::Scene;
    use crate::scenario::Source;

    const SCENE: &str = include_str!("../../../../../scenes/verify/planar/servo.toml");

    #[test]
    fn a_servo_goes_on_with_the_same_bits() {
        let mut whole = Simulation::from_toml(SCENE).unwrap();
        whole.advance(400).unwrap();
        let mut parts = Simulation::from_toml(SCENE).unwrap();
        parts.advance(150).unwrap();
        let mut rest = Simulation::resume(parts.snapshot(), Exec::serial());
        rest.advance(250).unwrap();
        assert_eq!(rest.engine().hash(), whole.engine().hash());
        assert!(whole.field("pair.normal_force", &["right", "core"]).unwrap() > 1e5);
    }

    #[test]
    fn servos_that_cannot_act_are_refused() {
        for (from, to, said) in [
            (
                "target = \"1 MN/m\"\nband = 0.04",
                "target = \"0 N/m\"\nband = 0.04",
                "target of zero",
            ),
            ("target = \"1 MN/m\"\nband = 0.04", "target = \"1 MPa\"\nband = 0.04", "in N/m"),
            ("target = \"1 MN/m\"\nband = 0.04", "target = \"1 MN/m\"\nband = 0", "band"),
            ("rise = \"20 ms\"", "", "needs `rise`"),
            ("band = 0.04", "band = 0.04\nrise = \"1 ms\"", "applies to the control of a load"),
            (
                "field = \"pair.normal_force\"\nof = [\"right\"",
                "field = \"pair.normal_fork\"\nof = [\"right\"",
                "no field",
            ),
            (
                "field = \"pair.normal_force\"\nof = [\"right\"",
                "field = \"pair.force\"\nof = [\"right\"",
                "is a vector",
            ),
            (
                "name = \"press\"",
                "name = \"press\"\ntime = { constant = 1 }",
                "`time` or `control`",
            ),
            ("name = \"press\"", "name = \"platen\"", "several loads or supports"),
            (
                "x = { constant = \"-5 mm/s\" }",
                "x = { ramp = { from = \"0 m/s\", to = \"1 m/s\", end = \"1 s\" } }",
                "constant velocity",
            ),
        ] {
            assert!(SCENE.contains(from), "{from}");
            let text = SCENE.replace(from, to);
            let scene = Scene::parse(Source::new("scene", &text), PathBuf::from("."), &[]);
            let told = match scene.and_then(|scene| scene.prepare(&scene.plain())) {
                Ok(_) => panic!("{to} was taken"),
                Err(told) => told.render(),
            };
            assert!(told.contains(said), "{said} is not in {told}");
        }
    }
}
