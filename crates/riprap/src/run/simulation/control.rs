//! Servos: loads and motions that keep fields at values.
//!
//! What they ask for is read from the forces of a step and acts from the next one on. It stands in the laws of loads and motions of the
//! world, so that a checkpoint holds it, and the work of it is booked as that of any load or support.

use super::{RunError, Simulation};
use crate::plan::{Acts, Control};
use crate::record::field::Site;
use crate::run::engine::Reading;
use crate::run::engine::steer::Steered;

/// Readings of the servos of a plan.
#[derive(Debug, Default)]
pub(super) struct Servos {
    readings: Vec<Reading>,
    /// The servo that could not act, and why.
    refused: Option<(usize, String)>,
}

impl Simulation {
    /// Finds what the servos read; at the start of a run loads begin with nothing, and supports at rest.
    pub(super) fn begin_controls(&mut self) -> Result<(), RunError> {
        let kind = self.kind();
        let mut servos = Servos::default();
        for control in self.plan.controls.clone() {
            let reading = Reading::new(kind, &control.gauge)
                .map_err(|wrong| self.idle(&control, wrong.to_string()))?;
            servos.readings.push(reading);
            if self.steps() > 0 || self.cursor.entered {
                continue;
            }
            let nothing = match control.acts {
                Acts::Load { .. } => Steered::Factor(0.0),
                Acts::Velocity(_) => Steered::Velocity([0.0; 3]),
            };
            let begun = self.engine.steer(&control.name, nothing);
            begun.map_err(|wrong| self.idle(&control, wrong.to_string()))?;
        }
        self.servos = Some(servos);
        Ok(())
    }

    /// What the servos ask for, by the forces of the present, prepared state.
    pub(super) fn asked_by_controls(&self) -> Vec<Steered> {
        self.controls()
            .map(|(control, reading)| {
                let off = self.off(control, reading);
                // What cannot be read (the stress between blocks that do not touch yet) is nothing.
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

    /// Gives loads and supports what the servos have asked for. Those whose blocks a phase has removed, released or fixed are over.
    pub(super) fn control(&mut self, asked: Vec<Steered>) {
        let Some(servos) = &mut self.servos else {
            return;
        };
        for (k, (control, to)) in self.plan.controls.iter().zip(asked).enumerate() {
            if !self.engine.acts(&control.name) {
                continue;
            }
            if let Err(wrong) = self.engine.steer(&control.name, to) {
                servos.refused = Some((k, wrong.to_string()));
            }
        }
    }

    /// Stops a run in which a servo acts that reads nothing any more, or could not act.
    pub(super) fn look_at_controls(&self) -> Result<(), RunError> {
        if let Some((k, reason)) = self.servos.as_ref().and_then(|s| s.refused.as_ref()) {
            return Err(self.idle(&self.plan.controls[*k], reason.clone()));
        }
        for (control, reading) in self.controls() {
            let alive = |b: &u32| self.engine.is_alive(*b);
            let of = &control.gauge.of;
            let gone = match reading.info().site {
                Site::Block | Site::Pair => !of.iter().all(alive),
                Site::Group => !of.iter().any(alive),
                _ => false,
            };
            if gone && self.engine.acts(&control.name) {
                let field = &control.gauge.field;
                let reason = format!(
                    "the blocks of which it reads `{field}` have been removed; remove, `release` or `fix` what it moves in the same phase"
                );
                return Err(self.idle(control, reason));
            }
        }
        Ok(())
    }

    /// The servos that act at the end of a run and have not reached what they were to keep, in words.
    pub(super) fn missed_targets(&self) -> Vec<String> {
        let acting = self.controls().filter(|(control, _)| self.engine.acts(&control.name));
        acting
            .filter_map(|(control, reading)| {
                let off = self.off(control, reading);
                // At the edge of its band a servo moves with all of its velocity, as it may.
                let kept = off.abs() <= 1.0 + 1e-9;
                (!kept).then(|| {
                    let (field, target) = (&control.gauge.field, control.target);
                    let value = reading.value(&self.view());
                    let now = if value.is_finite() {
                        format!("is {value:.4e}")
                    } else {
                        "cannot be read".to_owned()
                    };
                    let unit = reading.info().unit;
                    let [faster, slower] = match control.acts {
                        Acts::Load { .. } => ["a shorter `rise`", "a longer one"],
                        Acts::Velocity(_) => ["a larger velocity", "a smaller one"],
                    };
                    format!(
                        "the control of `{}` has not reached its target: `{field}` {now}, asked {target:.4e} {unit} (band {:.3} %) at t = {:.4e} s; \
                         examine its history: where the field still nears the target, more time or {faster}; where it swings about it, {slower}; \
                         where it moves away from it, the direction in which the control acts",
                        control.name,
                        100.0 * control.band,
                        self.time(),
                    )
                })
            })
            .collect()
    }

    fn controls(&self) -> impl Iterator<Item = (&Control, &Reading)> {
        let readings = self.servos.iter().flat_map(|servos| &servos.readings);
        self.plan.controls.iter().zip(readings)
    }

    /// How far the field is below its target, over the band.
    fn off(&self, control: &Control, reading: &Reading) -> f64 {
        (control.target - reading.value(&self.view())) / (control.band * control.target)
    }

    fn idle(&self, control: &Control, reason: String) -> RunError {
        let (step, time) = (self.steps(), self.time());
        RunError::Control { name: control.name.clone(), reason, step, time }
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

    fn with_phase(text: &str) -> Simulation {
        let (phase, checks) = ("until.time = \"0.3 s\"\n", "[[checks]]");
        let at = SCENE.find(checks).unwrap();
        let scene = SCENE[..at].replace(phase, "until.time = \"0.05 s\"\n");
        let later = format!("[[phases]]\nname = \"later\"\nuntil.time = \"0.05 s\"\n{text}\n");
        Simulation::from_toml(&format!("{scene}{later}")).unwrap()
    }

    #[test]
    fn a_servo_that_reads_nothing_any_more_stops_the_run() {
        let said = with_phase("remove = [\"core\"]").run().unwrap_err().to_string();
        assert!(said.contains("control of `platen` cannot act"), "{said}");
        assert!(said.contains("`pair.normal_force` have been removed"), "{said}");
        // Without what it moves it is over, however that comes about.
        for phase in [
            "remove = [\"right\", \"core\"]",
            "remove = [\"core\"]\nfix = [\"right\"]",
            "fix = [\"right\"]",
            "release = [\"right\"]",
            "remove = [\"stone\"]",
        ] {
            let mut run = with_phase(phase);
            run.run().unwrap();
            assert!(!run.warnings().iter().any(|w| w.contains("control of")), "{phase}");
        }
    }

    #[test]
    fn a_servo_that_does_not_reach_its_target_is_reported() {
        let mut whole = Simulation::from_toml(SCENE).unwrap();
        whole.run().unwrap();
        assert!(!whole.warnings().iter().any(|w| w.contains("control of")));
        let slow = SCENE.replace("rise = \"20 ms\"", "rise = \"20 s\"");
        let mut slow = Simulation::from_toml(&slow).unwrap();
        slow.run().unwrap();
        let said = slow.warnings().join("\n");
        assert!(said.contains("control of `press` has not reached its target"), "{said}");
        assert!(said.contains("a shorter `rise`"), "{said}");
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
