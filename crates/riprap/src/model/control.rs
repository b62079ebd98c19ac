//! Servos of loads and supports.

use super::accounts::condition_name;
use super::builder::Builder;
use super::fields::Said;
use crate::accounts::Holder;
use crate::dynamics::TimeFunction;
use crate::plan::{Acts, Control};
use crate::scenario::language::{self, Target};
use crate::scenario::vectors::InSpace;
use crate::scenario::{Name, Quantity, target_span};
use crate::{planar, spatial};

impl Builder<'_> {
    /// The servos of the scene.
    pub(super) fn controls(&mut self) {
        let scenario = &self.parsed.scenario;
        for (number, load) in scenario.loads.iter().enumerate() {
            let Some(said) = &load.control else {
                continue;
            };
            let key = format!("loads.{number}.control");
            if load.time.is_some() {
                let help = "leave out `time`: the servo finds the factor";
                self.error_at("control.time", &said.field, "a load has `time` or `control`", help);
            }
            let Some(rise) = said.rise.as_ref().map(Quantity::si) else {
                let help = "write for example rise = \"10 ms\": the time in which the load grows to its full size";
                self.error_at(
                    "control.rise",
                    &said.field,
                    "the control of a load needs `rise`",
                    help,
                );
                continue;
            };
            let name = self.controlled(load.name.as_ref(), &load.on, number);
            if let Some((name, _)) = name {
                self.control(&key, name, said, Acts::Load { rise });
            }
        }
        for (number, support) in scenario.supports.iter().enumerate() {
            let Some(said) = &support.control else {
                continue;
            };
            let key = format!("supports.{number}.control");
            if let Some(rise) = &said.rise {
                let help = "leave it out: a support moves with its velocity at most";
                let message = "`rise` applies to the control of a load";
                self.error_at("control.rise", rise.span.clone(), message, help);
            }
            let Some((name, holder)) = self.controlled(support.name.as_ref(), &support.on, number)
            else {
                continue;
            };
            let velocity = match holder {
                Holder::Support(k) => self.constant_velocity(usize::from(k)),
                Holder::Load | Holder::Nodes(_) | Holder::Boundary(_) => None,
            };
            let Some(velocity) = velocity else {
                let message = "`control` needs a support of rigid blocks with a constant velocity";
                let help = "write for example motion.velocity.z = { constant = \"-1 mm/s\" }: the fastest that the servo moves them";
                self.error_at("control.motion", target_span(&support.on), message, help);
                continue;
            };
            self.control(&key, name, said, Acts::Velocity(velocity));
        }
    }

    /// Name and kind of a condition that a servo acts on; it must be the only one of that name.
    fn controlled(
        &mut self,
        name: Option<&Name>,
        on: &Target,
        number: usize,
    ) -> Option<(String, Holder)> {
        let name = condition_name(name, on, number);
        let list = match self.space {
            InSpace::Planar => &self.setup.accounts,
            InSpace::Spatial => &self.spatial.accounts,
        };
        let mut found = list.iter().filter(|c| c.name == name);
        match (found.next().map(|c| c.holder), found.next()) {
            (Some(holder), None) => Some((name, holder)),
            (Some(_), Some(_)) => {
                let message = format!("`{name}` is the name of several loads or supports");
                let help = "give the one with `control` a `name` of its own";
                self.error_at("name.ambiguous", target_span(on), message, help);
                None
            }
            // What it was to be has its own error.
            (None, _) => None,
        }
    }

    /// Velocity of a support of rigid blocks, m/s, if it is constant and not nothing.
    fn constant_velocity(&self, k: usize) -> Option<[f64; 3]> {
        let constant = |f: &Option<TimeFunction>| match f {
            None => Some(0.0),
            Some(f) => {
                if let TimeFunction::Constant(v) = f {
                    Some(*v)
                } else {
                    None
                }
            }
        };
        let velocity = match self.space {
            InSpace::Planar => match &self.setup.supports[k].motion {
                planar::setup::Motion::Velocity { x, y, .. } => [constant(x)?, constant(y)?, 0.0],
                planar::setup::Motion::Fixed { .. }
                | planar::setup::Motion::Acceleration { .. } => {
                    return None;
                }
            },
            InSpace::Spatial => {
                let support = &self.spatial.supports[k];
                let mut soft = self.spatial.deform.sets.iter().flat_map(|set| &set.blocks);
                if soft.any(|b| support.blocks.contains(b)) {
                    return None;
                }
                match &support.motion {
                    spatial::setup::Motion::Velocity { translation: [x, y, z], .. } => {
                        [constant(x)?, constant(y)?, constant(z)?]
                    }
                    spatial::setup::Motion::Fixed { .. }
                    | spatial::setup::Motion::Acceleration { .. } => return None,
                }
            }
        };
        (velocity != [0.0; 3]).then_some(velocity)
    }

    fn control(&mut self, key: &str, name: String, said: &language::Control, acts: Acts) {
        let place = Said {
            of: said.of.as_ref(),
            point: None,
            pins: None,
            along: said.along.as_ref(),
            relative_to: None,
        };
        let Some(used) = self.field(&said.field, place) else {
            return;
        };
        if used.is_vector() {
            let message = format!("`{}` is a vector", said.field);
            let help = "name one component, or give the direction with `along`";
            self.error_at("control.field", &said.field, message, help);
            return;
        }
        let Some(target) = self.in_unit(&said.target, used.unit, "the field") else {
            return;
        };
        if target == 0.0 {
            let help = "the band is a share of the target; to keep a force at nothing leave the block free";
            let message = "a target of zero has no band";
            self.error_at("control.target", said.target.span.clone(), message, help);
            return;
        }
        let band = self.reading(key, said).band();
        self.plan.controls.push(Control { name, gauge: used.gauge(), target, band, acts });
    }
}
