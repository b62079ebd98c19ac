//! The choice between explicit and implicit steps, and in static phases between relaxation and Newton's method.

use super::{RunError, Simulation};
use crate::dynamics::damping::Damping;
use crate::plan::{IMPLICIT_STEP, Integration, Phase, PhaseKind, TimeStep};
use crate::spatial::Obstacle;
use crate::spatial::read::{outlook, seams};
use crate::spatial::setup::{Boundary, BoundaryKind};

/// Explicit steps that one implicit step must stand for: it costs about as much as 20.
const WORTH: f64 = 20.0;

impl Simulation {
    /// Begins the integration that `phase` asks for.
    pub(super) fn choose_integration(&mut self, phase: &Phase) -> Result<(), RunError> {
        let implicit = match phase.integration {
            Integration::Explicit => false,
            Integration::Implicit => true,
            Integration::Automatic => {
                let damping = phase.damping_in(false);
                // Who can meet whom is known after a look.
                self.evaluate(&damping, 0.0)?;
                let against = self.against_implicit(phase, &damping);
                let implicit = against.is_none();
                let words = match against {
                    Some(why) => format!("explicitly: {why}"),
                    None if phase.kind == PhaseKind::Static => {
                        "implicitly, to equilibrium by Newton's method".to_owned()
                    }
                    None if phase.damping.stiffness > 0.0 => {
                        "implicitly; its `damping.stiffness` had no effect".to_owned()
                    }
                    None => "implicitly".to_owned(),
                };
                self.cursor.chosen.push(format!("phase `{}` was stepped {words}", phase.name));
                implicit
            }
        };
        self.engine.integrate_implicitly(implicit);
        Ok(())
    }

    /// Why a phase is better stepped explicitly, in words.
    fn against_implicit(&self, phase: &Phase, damping: &Damping) -> Option<String> {
        let settles = phase.kind == PhaseKind::Static;
        let Some(view) = self.view().spatial() else {
            return Some("it is in the plane".to_owned());
        };
        if phase.damping.local > 0.0 {
            return Some("it has local damping".to_owned());
        }
        if settles && phase.damping != Damping::default() {
            return Some("it has damping of its own".to_owned());
        }
        if let Some(Obstacle { what, .. }) = self.engine.obstacle() {
            return Some(what);
        }
        let takes_waves = |b: &&Boundary| matches!(b.kind, BoundaryKind::Viscous { .. });
        if let Some(boundary) = view.world.setup.boundaries.iter().find(takes_waves) {
            return Some(format!(
                "boundary `{}` takes waves, which long steps damp",
                boundary.name
            ));
        }
        // Not left to Newton's method unasked: where joints fail beside held faces its limits were found below those of relaxation
        // (template `mapped_joints`: 1.03 for 1.285, where tan 42/tan 35 = 1.2859).
        if let Some(boundary) = view.world.setup.boundaries.first() {
            return Some(format!(
                "boundary `{}` is a condition on faces, which implicit phases take where `integration = \"implicit\"` asks for them",
                boundary.name
            ));
        }
        if let Some(blocks) = seams::seam(view.world, settles) {
            let [block, first, second] = blocks.map(|b| view.name(b as usize));
            return Some(format!(
                "block `{block}` lies on `{first}` and `{second}` in one plane, and long steps brake what slides from one block onto the next"
            ));
        }
        if settles {
            // Tens of steps, where a relaxation has thousands.
            return None;
        }
        let meets = outlook::outlook(&view);
        // Dry joints, which an implicit phase makes contacts of, are not among what can meet.
        let joints = self.engine.stable(damping.stiffness).dt;
        let shortest = meets.iter().map(|meets| meets.step).fold(joints, f64::min);
        let long = match phase.time_step {
            TimeStep::Given { dt } => dt,
            TimeStep::Auto { .. } => IMPLICIT_STEP,
        };
        (long < WORTH * shortest)
            .then(|| format!("explicit steps are {shortest:.1e} s once blocks touch, and an implicit one costs as much as 20 of them"))
    }
}
