//! Rules of joints in `[space.spatial]`.

use super::Rules;
use crate::diagnostic::Diagnostic;
use crate::language::{Interface, Scenario};
use crate::names::Name;
use crate::quantity::{Quantity, Span};

impl Rules {
    pub(super) fn joint(
        &mut self,
        span: &Span,
        of: &str,
        interface: &Interface,
        scenario: &Scenario,
    ) {
        if let Some(bond) = &interface.brittle_bond {
            let meant = |name: &str| {
                let between = interface.between.as_ref();
                between.is_none_or(|pair| pair.iter().any(|one| one.as_str() == name))
            };
            let materials: Vec<(f64, f64)> = scenario
                .materials
                .iter()
                .filter(|(name, _)| meant(name.as_str()))
                .filter_map(|(_, m)| Some((m.young.as_ref()?.si(), m.poisson.as_ref()?.si())))
                .collect();
            self.bond(of, bond, &materials);
        }
        self.behaviour(of, interface);
        self.tension(of, interface);
        self.elastic_constants(span, of, interface, scenario);
    }

    /// Dilation has an end.
    pub(super) fn dilation(&mut self, of: &str, interface: &Interface) {
        if let (Some(angle), None) = (&interface.dilation_angle, &interface.dilation_end)
            && angle.si() > 0.0
        {
            let message = format!("the key `dilation_end` is missing in {of}");
            let help = "write the slip at which dilation ends, for example dilation_end = \"5 mm\"";
            self.error("key.missing", &angle.span, message, help);
        }
    }

    /// Beyond the tip of the cone a joint would have no shear strength at all.
    fn tension(&mut self, of: &str, interface: &Interface) {
        let Some(tension) = interface.tension.as_ref().filter(|_| self.values_sound) else {
            return;
        };
        let friction = match (&interface.friction_angle, &interface.friction_coefficient) {
            (Some(angle), _) => angle.tangent(),
            (None, Some(coefficient)) => coefficient.si(),
            (None, None) => return,
        };
        let cohesion = interface.cohesion.as_ref().map_or(0.0, Quantity::si);
        // A tension calculated from the tip itself is off by a rounding.
        if tension.si() * friction > cohesion * (1.0 + 1e-12) {
            let message = format!(
                "the tensile strength of {of} lies beyond the tip of the Mohr-Coulomb cone"
            );
            let help = "above cohesion / tan(friction_angle) a joint in tension has no shear \
                        strength; lower `tension` or raise `cohesion`";
            self.found.push(
                Diagnostic::warning("value.tip", message).at(tension.span.clone()).help(help),
            );
        }
    }

    /// A stiffness from the material needs elastic constants: of the materials of the pairs that the interface is for.
    pub(super) fn elastic_constants(
        &mut self,
        span: &Span,
        of: &str,
        interface: &Interface,
        scenario: &Scenario,
    ) {
        if interface.normal_stiffness.is_some() {
            return;
        }
        let Some([one, other]) = pairs_of(interface, scenario)
            .into_iter()
            .find(|pair| pair.iter().any(|name| lacks_moduli(scenario, name)))
        else {
            return;
        };
        let lacking = if lacks_moduli(scenario, one) { one } else { other };
        let message =
            format!("{of} has no normal stiffness, which blocks of `{one}` and `{other}` need");
        let help = format!(
            "write for example normal_stiffness = \"10 GPa/m\", or give materials.{lacking} `young` and \
             `poisson`, from which it is estimated"
        );
        self.error("key.missing", span, message, &help);
    }
}

/// Whether a material has not both elastic constants.
fn lacks_moduli(scenario: &Scenario, name: &str) -> bool {
    let material = scenario.materials.get(name);
    material.is_some_and(|m| m.young.is_none() || m.poisson.is_none())
}

/// Pairs of materials that an interface is for and that blocks of the scene have: two blocks of one material, or one of each.
fn pairs_of<'a>(interface: &'a Interface, scenario: &'a Scenario) -> Vec<[&'a str; 2]> {
    let many = |name: &str| {
        let tables = scenario.blocks.iter().filter(|b| b.material.as_str() == name);
        tables.map(|b| 1 + usize::from(b.is_generator())).sum::<usize>()
    };
    let meet = |[a, b]: &[&str; 2]| match a == b {
        true => many(a) > 1,
        false => many(a) > 0 && many(b) > 0,
    };
    if let Some([a, b]) = &interface.between {
        return [[a.as_str(), b.as_str()]].into_iter().filter(meet).collect();
    }
    let named = |[a, b]: &[&str; 2]| {
        let pairs = scenario.interfaces.iter().filter_map(|(_, i)| i.between.as_ref());
        let mut pairs = pairs.map(|pair| pair.each_ref().map(Name::as_str));
        pairs.any(|pair| pair == [*a, *b] || pair == [*b, *a])
    };
    let names: Vec<&str> = scenario.materials.names().collect();
    let pairs = names.iter().enumerate();
    let pairs = pairs.flat_map(|(k, a)| names[k..].iter().map(move |b| [*a, *b]));
    pairs.filter(|pair| meet(pair) && !named(pair)).collect()
}
