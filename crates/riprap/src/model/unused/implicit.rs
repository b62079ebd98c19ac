//! Dampings that implicit phases do not read: contacts and joints have no dashpots there, and a static phase has no motion to damp. What such phases damp
//! themselves: waves.

use crate::model::builder::Builder;
use crate::plan::{Integration, PhaseKind, TimeStep};
use crate::scenario::quantity::Span;
use crate::spatial::setup::{Boundary, BoundaryKind};

/// Frequency of the wave whose amplitude implicit steps halve in a period, times their length: a step takes the factor `1/sqrt(1 + (w h)^2)`, a period
/// `exp(-pi w h)`.
const HALVED: f64 = std::f64::consts::LN_2 / (2.0 * std::f64::consts::PI * std::f64::consts::PI);

impl Builder<'_> {
    /// Tells a dynamic implicit phase with a viscous face what its steps take of a wave.
    pub(super) fn waves_in_implicit_phases(&mut self) {
        let viscous = |b: &&Boundary| matches!(b.kind, BoundaryKind::Viscous { .. });
        let Some(boundary) = self.spatial.boundaries.iter().find(viscous) else { return };
        let boundary = boundary.name.clone();
        let mut told = Vec::new();
        for (said, plan) in self.parsed.scenario.phases.iter().zip(&self.plan.phases) {
            let TimeStep::Given { dt } = plan.time_step else { continue };
            if plan.integration == Integration::Implicit && plan.kind != PhaseKind::Static {
                told.push((
                    said.name.span.clone(),
                    format!(
                        "phase `{}` is implicit, and boundary `{boundary}` is there for waves: steps of {dt:.1e} s halve a wave of {:.2e} Hz in each period, and faster ones sooner",
                        said.name,
                        HALVED / dt
                    ),
                ));
            }
        }
        for (span, message) in told {
            self.warn_at(
                "phase.waves",
                span,
                message,
                "use `integration = \"explicit\"` where waves matter",
            );
        }
    }

    /// Warns of dampings that no implicit phase reads.
    pub(super) fn unused_in_implicit_phases(&mut self) {
        let of_phases = self.parsed.scenario.phases.iter().zip(&self.plan.phases);
        let of_phases: Vec<_> =
            of_phases.filter(|(_, plan)| plan.integration == Integration::Implicit).collect();
        let mut idle = Vec::new();
        for (said, plan) in of_phases {
            let quiet = plan.kind == PhaseKind::Static;
            let damping = said.damping.clone().unwrap_or_default();
            let given = [
                ("mass", quiet && damping.mass.is_some()),
                ("rotation", quiet && damping.rotation.is_some()),
                ("stiffness", damping.stiffness.is_some()),
            ];
            let help = match quiet {
                true => {
                    "a static implicit phase seeks its equilibrium without motion; leave it out"
                }
                false => {
                    "contacts and joints have no dashpots in implicit phases; use `damping.mass`"
                }
            };
            idle.push((
                format!("`damping` of phase `{}`", said.name),
                given,
                &said.name.span,
                help,
            ));
        }
        for (of, given, span, help) in idle {
            self.no_effect(&of, &given, &span.clone(), help);
        }
        for (of, span) in self.idle_ratios() {
            let help = "contacts and joints have no dashpots in implicit phases: impacts are plastic unless the interface has `restitution`";
            self.no_effect(&of, &[("damping_ratio", true)], &span, help);
        }
    }

    /// Whether no phase of the scene, nor of a variant of it, has dashpots.
    pub(super) fn is_wholly_implicit(&self) -> bool {
        let mut variants = self.parsed.scenario.variants.iter();
        // Another case may be explicit, and reads the keys of this one.
        let others = variants.any(|(_, keys)| keys.names().any(|key| key.starts_with("phases")));
        let mut phases = self.plan.phases.iter();
        let implicit = phases.all(|phase| phase.integration == Integration::Implicit);
        self.variant == "default" && !others && implicit && !self.plan.phases.is_empty()
    }

    /// Places of `damping_ratio` that no explicit phase reads.
    fn idle_ratios(&self) -> Vec<(String, Span)> {
        let scenario = &self.parsed.scenario;
        let mut found = Vec::new();
        if self.is_wholly_implicit() {
            for (name, said) in scenario.interfaces.iter() {
                let ratio = said.damping_ratio.iter();
                found.extend(ratio.map(|ratio| (format!("interfaces.{name}"), ratio.span.clone())));
            }
        }
        let is_implicit = |k: usize| self.plan.phases[k].integration == Integration::Implicit;
        let count = self.plan.phases.len();
        // What a phase changes lasts.
        for (k, said) in scenario.phases.iter().enumerate() {
            if !(k..count).all(is_implicit) {
                continue;
            }
            for (name, change) in said.interfaces.iter() {
                let of = format!("phases.{}.interfaces.{name}", said.name);
                let ratio = change.damping_ratio.iter();
                found.extend(ratio.map(|ratio| (of.clone(), ratio.span.clone())));
            }
        }
        found
    }
}
