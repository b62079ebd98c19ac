//! Rules of interfaces.

use riprap_core::laws::parameters::{FrictionLaw, NormalLaw};

use super::Rules;
use crate::diagnostic::Diagnostic;
use crate::language::{Interface, Scenario};
use crate::quantity::{Name, NotNegativePlain, Quantity, Restitution, Span};
use crate::vectors::InSpace;

/// Whether the rock bridges of some blocks have this interface.
fn is_of_bridges(name: &Name, scenario: &Scenario) -> bool {
    let cuts = scenario.blocks.iter().filter_map(|block| block.cut.as_ref());
    let joints = cuts.filter_map(|cut| cut.joints.as_ref());
    let mut bridges = joints.filter_map(|joints| joints.bridges.as_ref());
    bridges.any(|bridge| bridge.as_str() == name.as_str())
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
        self.rebound(&of, &interface.damping_ratio, &interface.restitution);
        match self.space {
            InSpace::Planar => self.contact(span, &of, interface, scenario),
            InSpace::Spatial => self.joint(span, &of, interface, scenario),
        }
    }

    fn contact(&mut self, span: &Span, of: &str, interface: &Interface, scenario: &Scenario) {
        self.friction(span, of, interface);
        self.friction_law(span, of, interface.friction_law, interface.clip_speed.is_some());
        self.behaviour(of, interface);
        if interface.reflex.is_some() && interface.law != Some(NormalLaw::PenetrationPotential) {
            let message = format!("`reflex` in {of} has no effect");
            let help = "it belongs to law = \"penetration_potential\"";
            self.found.push(Diagnostic::warning("key.unused", message).at(span.clone()).help(help));
        }
        self.elastic_constants(span, of, interface, scenario);
    }

    /// Found contacts have one pair of dashpots, said in one way.
    pub(super) fn rebound(
        &mut self,
        of: &str,
        ratio: &Option<Quantity<NotNegativePlain>>,
        restitution: &Option<Quantity<Restitution>>,
    ) {
        if let (Some(_), Some(second)) = (ratio, restitution) {
            let message = format!("{of} has `damping_ratio` and `restitution`");
            let help = "keep one of them: dashpots of found contacts follow from either";
            self.error("key.one_of", &second.span, message, help);
        }
    }

    /// Exactly one way to give friction.
    pub(super) fn friction(&mut self, span: &Span, of: &str, interface: &Interface) {
        self.one_of(
            span,
            of,
            &[
                ("friction_angle", interface.friction_angle.is_some()),
                ("friction_coefficient", interface.friction_coefficient.is_some()),
            ],
        );
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
                    let of = format!("phases.{}.interfaces.{name}", phase.name);
                    // A phase that brings the law without a speed has been refused.
                    self.friction_law(&speed.span, &of, law, true);
                }
            }
        }
    }

    pub(super) fn friction_law(
        &mut self,
        span: &Span,
        of: &str,
        law: Option<FrictionLaw>,
        speed: bool,
    ) {
        match (law == Some(FrictionLaw::Clipped), speed) {
            (true, false) => {
                let message = format!("the key `clip_speed` is missing in {of}");
                self.error(
                    "key.missing",
                    span,
                    message,
                    "write for example clip_speed = \"1 mm/s\"",
                );
            }
            (false, true) => {
                let message = format!("`clip_speed` in {of} has no effect");
                let help = "it belongs to friction_law = \"clipped\"";
                self.found
                    .push(Diagnostic::warning("key.unused", message).at(span.clone()).help(help));
            }
            (true, true) | (false, false) => {}
        }
    }
}
