//! Rules of interfaces.

use riprap_core::laws::parameters::FrictionLaw;

use super::Rules;
use crate::language::{Interface, Scenario};
use crate::quantity::{Name, Span};
use crate::rule::no_effect;
use crate::vectors::InSpace;

/// Whether the rock bridges of some blocks, or cuts along excavations, have this interface, or one by a wrong name: it may be this one.
fn is_of_bridges(name: &Name, scenario: &Scenario) -> bool {
    scenario
        .interfaces_of_bridges()
        .any(|of| of.as_str() == name.as_str() || scenario.interfaces.get(of.as_str()).is_none())
}

impl Rules {
    pub(super) fn interface(&mut self, name: &Name, interface: &Interface, scenario: &Scenario) {
        let span = &name.span;
        let of = format!("interfaces.{name}");
        match (&interface.between, name.as_str() == "default") {
            (Some([first, _]), true) => {
                let message = "interfaces.default cannot have `between`".to_owned();
                let help = "it is used by all pairs that no other interface names; call this \
                            interface otherwise";
                self.error("key.forbidden", &first.span, message, help);
            }
            // The law of rock bridges is chosen by place.
            (None, false) if is_of_bridges(name, scenario) => {}
            (None, false) => {
                let message = format!("the key `between` is missing in {of}");
                self.error(
                    "key.missing",
                    span,
                    message,
                    "say which materials meet: between = [\"rock\", \"steel\"]",
                );
            }
            (Some(_), false) | (None, true) => {}
        }
        match self.space {
            InSpace::Planar => self.contact(span, &of, interface, scenario),
            InSpace::Spatial => self.joint(span, &of, interface, scenario),
        }
    }

    fn contact(&mut self, span: &Span, of: &str, interface: &Interface, scenario: &Scenario) {
        self.behaviour(of, interface);
        self.elastic_constants(span, of, interface, scenario);
    }

    /// Speeds that phases give to interfaces whose friction is not clipped then.
    pub(super) fn clip_speeds(&mut self, scenario: &Scenario) {
        for (name, interface) in scenario.interfaces.iter() {
            let mut law = interface.friction_law;
            for phase in &scenario.phases {
                let Some(change) = phase.interfaces.get(name.as_str()) else {
                    continue;
                };
                law = change.friction_law.or(law);
                if let Some(speed) = change.clip_speed.as_ref() {
                    // A phase that brings the law without a speed has been refused.
                    if law != Some(FrictionLaw::Clipped) {
                        let of = format!("phases.{}.interfaces.{name}", phase.name);
                        let help = "it applies only with friction_law = \"clipped\"";
                        self.found.push(no_effect(&of, &["clip_speed"], speed.span.clone(), help));
                    }
                }
            }
        }
    }
}
