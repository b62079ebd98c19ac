//! Laws of joints per pair of materials.

use crate::laws::damping::{FREE_RESTITUTION, ratio_of, restitution};
use crate::model::behaviour::dilates;
use crate::model::builder::Builder;
use crate::model::interfaces::{angle_shown, changed_damping, changed_friction, friction};
use crate::scenario::language::{self, InterfaceChange};
use crate::scenario::read::{Given, Provenance, Read};
use crate::scenario::{Quantity, quantity};
use crate::spatial::setup::{InterfaceLaw, JointLaw, Stiffness, StiffnessRule, Strength};

impl Builder<'_> {
    /// Fills `interfaces` and `pair_table`.
    pub(super) fn joints(&mut self) {
        let table = &self.parsed.scenario.interfaces;
        let materials: Vec<String> =
            (self.spatial.materials.iter().map(|m| m.name.clone())).collect();
        self.spatial.pair_table = self.pair_table(&materials);
        for (name, interface) in table.iter() {
            let joint = self.joint(name.as_str(), interface);
            let friction = joint.strength.is_none().then(|| {
                let mut read = self.reading(format!("interfaces.{name}"), interface);
                friction(&mut read)
            });
            self.spatial.interfaces.push(InterfaceLaw {
                name: name.text.clone(),
                joint,
                bond: None,
                friction: friction.flatten(),
            });
        }
    }

    fn joint(&mut self, name: &str, said: &language::Interface) -> JointLaw {
        let behaviour = self.behaviour(name, said);
        let found_contacts = self.spatial.found_contacts;
        let mut read = self.reading(format!("interfaces.{name}"), said);
        let stiffness = stiffness(&mut read);
        let bond = said.brittle_bond.as_ref();
        let strength = if said.elastic || bond.is_some_and(|b| b.elastic) {
            read.note("elastic", "true", Provenance::Given, "");
            None
        } else {
            Some(strength(&mut read))
        };
        // An elastic joint does not fail, and no point of it slides.
        let (failure, dashpots) = match strength {
            Some(_) => (read.failure(), read.dashpots()),
            None => (said.failure.unwrap_or_default(), said.dashpots.unwrap_or_default()),
        };
        let damping = read.damping_ratio();
        let contact_damping = match (&said.restitution, &said.damping_ratio) {
            (Some(wanted), _) => ratio_of(wanted.si()),
            (None, Some(_)) => damping,
            (None, None) => ratio_of(FREE_RESTITUTION),
        };
        if found_contacts {
            read.because(&rebound(contact_damping));
        }
        read.restitution();
        let stiffening = read.stiffening_depth();
        JointLaw {
            stiffness,
            strength,
            behaviour,
            failure,
            points: read.points(),
            damping,
            contact_damping,
            rebound: said.restitution.as_ref().map_or(0.0, Quantity::si),
            dashpots,
            stiffening: stiffening.unwrap_or(0.0),
        }
    }
}

/// What blocks that meet under this share of critical damping keep of their speed, in words.
fn rebound(ratio: f64) -> String {
    let kept = restitution(ratio);
    format!(
        "a face-to-face impact of free blocks rebounds with {kept:.2} of their relative speed (`restitution`)"
    )
}

fn stiffness(read: &mut Read<'_, language::Interface>) -> Stiffness {
    if let Some(normal) = read.normal_stiffness() {
        let (half, why) = (0.5 * normal, "half the normal stiffness");
        let shear = read.shear_stiffness_or(half, Provenance::Derived, why);
        return Stiffness::Given { normal, shear };
    }
    let rule = read.stiffness();
    let why = match rule {
        StiffnessRule::Material => "M/d and 2G/d, d the distance between centroids",
        StiffnessRule::Uniaxial => "E/d and 2G/d, d the distance between centroids",
    };
    read.because(why);
    Stiffness::Rule(rule)
}

/// Strength of joints; what the interface does not give is that of its bonds.
fn strength(read: &mut Read<'_, language::Interface>) -> Strength {
    let said = read.said();
    let bond = said.brittle_bond.as_ref();
    let friction = friction(read);
    // Without any it is reported by the rules of the language, unless bonds have one.
    let of_bond = bond.and_then(|b| b.friction_angle.as_ref());
    let friction = friction.or(of_bond.map(Quantity::tangent)).unwrap_or(0.0);
    let residual = said.residual_friction_angle.as_ref();
    let residual_friction = residual.map_or(friction, Quantity::tangent);
    let shown = angle_shown(said, friction);
    read.residual_friction_angle_or(shown, Provenance::Default, "");
    let of_bond = |key: fn(&language::BrittleBond) -> &Option<Quantity<quantity::Strength>>| {
        bond.and_then(|b| key(b).as_ref()).map(Quantity::si)
    };
    let cohesion = match of_bond(|b| &b.cohesion) {
        Some(value) => read.cohesion_or(value, Provenance::Default, ""),
        None => read.cohesion(),
    };
    let tension = match of_bond(|b| &b.tension) {
        Some(value) => read.tension_or(value, Provenance::Default, ""),
        None => read.tension(),
    };
    let strength = Strength {
        cohesion,
        tension,
        friction,
        residual_friction,
        residual_cohesion: read.residual_cohesion(),
        ..Strength::default()
    };
    dilates(strength, read)
}

/// Divides the strength of a joint by a factor.
pub(in crate::model) fn reduce_joint(law: &mut JointLaw, factor: f64) {
    *law = law.reduced(factor);
}

/// Changes a law as a phase says; keys that are not given stay. A new friction angle without a
/// residual one holds for both.
pub(in crate::model) fn change_joint(law: &mut JointLaw, change: &InterfaceChange) {
    let friction = changed_friction(change);
    let residual = change.residual_friction_angle.as_ref();
    let residual = residual.map(Quantity::tangent);
    if let Some(strength) = &mut law.strength {
        *strength = Strength {
            cohesion: change.cohesion.si_or(strength.cohesion),
            tension: change.tension.si_or(strength.tension),
            friction: friction.unwrap_or(strength.friction),
            residual_friction: residual.or(friction).unwrap_or(strength.residual_friction),
            residual_cohesion: change.residual_cohesion.si_or(strength.residual_cohesion),
            ..*strength
        };
    }
    law.stiffness = match (&change.normal_stiffness, law.stiffness) {
        (Some(normal), old) => {
            let ratio = match old {
                Stiffness::Given { normal, shear } => shear / normal,
                Stiffness::Rule(_) => 0.5,
            };
            let normal = normal.si();
            let shear = change.shear_stiffness.si_or(ratio * normal);
            Stiffness::Given { normal, shear }
        }
        (None, Stiffness::Given { normal, shear }) => {
            Stiffness::Given { normal, shear: change.shear_stiffness.si_or(shear) }
        }
        (None, rule @ Stiffness::Rule(_)) => rule,
    };
    law.damping = change.damping_ratio.si_or(law.damping);
    law.contact_damping = changed_damping(change).unwrap_or(law.contact_damping);
    if changed_damping(change).is_some() {
        law.rebound = change.restitution.as_ref().map_or(0.0, Quantity::si);
    }
}
