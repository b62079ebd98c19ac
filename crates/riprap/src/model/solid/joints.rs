//! Laws of joints per pair of materials.

use crate::model::builder::Builder;
use crate::model::explain::{Provenance, with_unit};
use crate::scenario::language::{self, InterfaceChange};
use crate::scenario::quantity::Kind;
use crate::scenario::{Diagnostic, Quantity};
use crate::spatial::setup::{Interface, JointLaw, Stiffness, StiffnessRule, Strength};
use riprap_keys::Words;

/// Default of `damping_ratio`: the value with which the source's blasts were calibrated.
const DAMPING: f64 = 0.1;

impl Builder<'_> {
    /// Fills `interfaces` and `pair_table`.
    pub(super) fn joints(&mut self) {
        let table = &self.parsed.scenario.interfaces;
        let n = self.spatial.materials.len();
        let default = table.names().position(|name| name == "default");
        self.spatial.pair_table = vec![default.unwrap_or(0) as u16; n * n];
        for (row, (name, interface)) in table.iter().enumerate() {
            let Some(pair) = &interface.between else {
                continue;
            };
            let materials = &self.spatial.materials;
            let number = |name: &str| materials.iter().position(|m| m.name == name);
            let (Some(a), Some(b)) = (number(pair[0].as_str()), number(pair[1].as_str())) else {
                let message = format!("interfaces.{name} is between materials that do not exist");
                let error = Diagnostic::error("name.unknown", message);
                self.found.push(error.at(pair[0].span.clone()));
                continue;
            };
            self.spatial.pair_table[a * n + b] = row as u16;
            self.spatial.pair_table[b * n + a] = row as u16;
        }
        for (name, interface) in table.iter() {
            let joint = self.joint(name.as_str(), interface);
            self.spatial.interfaces.push(Interface {
                name: name.text.clone(),
                joint,
            });
        }
    }

    fn joint(&mut self, name: &str, said: &language::Interface) -> JointLaw {
        let key = |word: &str| format!("interfaces.{name}.{word}");
        let stiffness = self.stiffness(name, said);
        let bond = said.brittle_bond.as_ref();
        let strength = if said.elastic || bond.is_some_and(|b| b.elastic) {
            self.explain(key("elastic"), "true", Provenance::Given, "");
            None
        } else {
            Some(self.strength(name, said))
        };
        let failure = said.failure.unwrap_or_default();
        if strength.is_some() {
            let given = from(said.failure.is_some());
            self.explain(key("failure"), failure.word(), given, "");
        }
        let points = said.points.unwrap_or_default();
        let given = from(said.points.is_some());
        self.explain(key("points"), points.word(), given, "");
        let dashpots = said.dashpots.unwrap_or_default();
        if strength.is_some() {
            let given = from(said.dashpots.is_some());
            self.explain(key("dashpots"), dashpots.word(), given, "");
        }
        JointLaw {
            stiffness,
            strength,
            failure,
            points,
            damping: self.or(
                &key("damping_ratio"),
                said.damping_ratio.as_ref(),
                DAMPING,
                "",
            ),
            dashpots,
        }
    }

    fn stiffness(&mut self, name: &str, said: &language::Interface) -> Stiffness {
        let key = |word: &str| format!("interfaces.{name}.{word}");
        if let Some(normal) = &said.normal_stiffness {
            let raw = normal.raw.to_string();
            self.explain(key("normal_stiffness"), raw, Provenance::Given, "");
            let normal = normal.si();
            let shear = match &said.shear_stiffness {
                Some(shear) => {
                    let raw = shear.raw.to_string();
                    self.explain(key("shear_stiffness"), raw, Provenance::Given, "");
                    shear.si()
                }
                None => {
                    let (value, why) = (0.5 * normal, "half the normal stiffness");
                    let text = with_unit(value, "Pa/m");
                    self.explain(key("shear_stiffness"), text, Provenance::Derived, why);
                    value
                }
            };
            return Stiffness::Given { normal, shear };
        }
        let rule = said.stiffness.unwrap_or_default();
        let why = match rule {
            StiffnessRule::Material => "M/d and 2G/d, d the distance of the centroids",
            StiffnessRule::Uniaxial => "E/d and 2G/d, d the distance of the centroids",
        };
        let given = from(said.stiffness.is_some());
        self.explain(key("stiffness"), rule.word(), given, why);
        Stiffness::Rule(rule)
    }

    fn strength(&mut self, name: &str, said: &language::Interface) -> Strength {
        let key = |word: &str| format!("interfaces.{name}.{word}");
        let bond = said.brittle_bond.as_ref();
        let degrees = |tangent: f64| with_unit(libm::atan(tangent).to_degrees(), "deg");
        let friction = match (&said.friction_angle, &said.friction_coefficient) {
            (Some(angle), _) => {
                let raw = angle.raw.to_string();
                self.explain(key("friction_angle"), raw, Provenance::Given, "");
                libm::tan(angle.si())
            }
            (None, Some(coefficient)) => {
                let raw = coefficient.raw.to_string();
                self.explain(key("friction_coefficient"), raw, Provenance::Given, "");
                coefficient.si()
            }
            // Reported by the rules of the language, unless bonds have one.
            (None, None) => bond
                .and_then(|b| b.friction_angle.as_ref())
                .map_or(0.0, |angle| libm::tan(angle.si())),
        };
        let residual_friction = match &said.residual_friction_angle {
            Some(angle) => libm::tan(angle.si()),
            None => friction,
        };
        let given = from(said.residual_friction_angle.is_some());
        let text = degrees(residual_friction);
        self.explain(key("residual_friction_angle"), text, given, "");
        let dilation = self.or(
            &key("dilation_angle"),
            said.dilation_angle.as_ref(),
            0.0,
            "deg",
        );
        Strength {
            cohesion: self.or(
                &key("cohesion"),
                said.cohesion.as_ref(),
                bond.and_then(|b| b.cohesion.as_ref())
                    .map_or(0.0, Quantity::si),
                "Pa",
            ),
            tension: self.or(
                &key("tension"),
                said.tension.as_ref(),
                bond.and_then(|b| b.tension.as_ref())
                    .map_or(0.0, Quantity::si),
                "Pa",
            ),
            friction,
            residual_friction,
            residual_cohesion: self.or(
                &key("residual_cohesion"),
                said.residual_cohesion.as_ref(),
                0.0,
                "Pa",
            ),
            dilation: libm::tan(dilation),
            dilation_end: said.dilation_end.as_ref().map_or(0.0, Quantity::si),
        }
    }
}

fn from(given: bool) -> Provenance {
    if given {
        Provenance::Given
    } else {
        Provenance::Default
    }
}

/// Divides the strength of a joint by a factor.
pub(in crate::model) fn reduce_joint(law: &mut JointLaw, factor: f64) {
    let Some(strength) = &mut law.strength else {
        return;
    };
    for value in [
        &mut strength.cohesion,
        &mut strength.tension,
        &mut strength.friction,
        &mut strength.residual_friction,
        &mut strength.residual_cohesion,
    ] {
        *value /= factor;
    }
}

/// A law after the changes of a phase; keys that are not given stay. A new friction angle without a
/// residual one holds for both.
pub(in crate::model) fn changed_joint(law: &JointLaw, change: &InterfaceChange) -> JointLaw {
    fn si<K: Kind>(q: Option<&Quantity<K>>, old: f64) -> f64 {
        q.map_or(old, Quantity::si)
    }
    let friction = match (&change.friction_angle, &change.friction_coefficient) {
        (Some(angle), _) => Some(libm::tan(angle.si())),
        (None, Some(coefficient)) => Some(coefficient.si()),
        (None, None) => None,
    };
    let residual = change.residual_friction_angle.as_ref();
    let residual = residual.map(|angle| libm::tan(angle.si()));
    let strength = law.strength.map(|old| Strength {
        cohesion: si(change.cohesion.as_ref(), old.cohesion),
        tension: si(change.tension.as_ref(), old.tension),
        friction: friction.unwrap_or(old.friction),
        residual_friction: residual.or(friction).unwrap_or(old.residual_friction),
        residual_cohesion: si(change.residual_cohesion.as_ref(), old.residual_cohesion),
        ..old
    });
    let stiffness = match (&change.normal_stiffness, law.stiffness) {
        (Some(normal), old) => {
            let ratio = match old {
                Stiffness::Given { normal, shear } => shear / normal,
                Stiffness::Rule(_) => 0.5,
            };
            let normal = normal.si();
            let shear = si(change.shear_stiffness.as_ref(), ratio * normal);
            Stiffness::Given { normal, shear }
        }
        (None, Stiffness::Given { normal, shear }) => Stiffness::Given {
            normal,
            shear: si(change.shear_stiffness.as_ref(), shear),
        },
        (None, rule @ Stiffness::Rule(_)) => rule,
    };
    JointLaw {
        stiffness,
        strength,
        damping: si(change.damping_ratio.as_ref(), law.damping),
        ..*law
    }
}
