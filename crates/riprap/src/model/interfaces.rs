//! Laws of contact per pair of materials.

use riprap_geom::polygon;

use super::behaviour::dilates;
use super::builder::Builder;
use super::solid::reduce_joint;
use crate::laws::damping::ratio_of;
use crate::planar::setup::{self, BondLaw, ContactLaw, FrictionLaw, Motion, Strength};
use crate::scenario::language::{self, Bond, InterfaceChange};
use crate::scenario::quantity::FrictionAngle;
use crate::scenario::read::{Given, Provenance, Read, with_unit};
use crate::scenario::{Diagnostic, Quantity, Table};

impl Builder<'_> {
    /// Fills `interfaces` and `pair_table`; supports must be known.
    pub(super) fn interfaces(&mut self) {
        let table: &Table<language::Interface> = &self.parsed.scenario.interfaces;
        let materials = self.setup.materials.clone();
        self.setup.pair_table = self.pair_table(&materials);
        let size = self.median_size();
        for (row, (name, interface)) in table.iter().enumerate() {
            if let Some(law) = self.contact_law(row, name.as_str(), interface, size) {
                let angle = angle_shown(interface, law.friction);
                let bond = interface.bond.as_ref();
                let bond = bond.map(|bond| {
                    let behaviour = self.behaviour(name.as_str(), interface);
                    let mut law = self.bond(name.as_str(), bond, &law, angle);
                    let mut read = self.reading(format!("interfaces.{name}"), interface);
                    law.behaviour = behaviour;
                    law.strength = dilates(law.strength, &mut read);
                    law
                });
                let name = name.text.clone();
                self.setup.interfaces.push(setup::Interface { name, contact: law, bond });
            }
        }
    }

    /// Row of the table of interfaces for each two materials, the first of the pair outside.
    pub(super) fn pair_table(&mut self, materials: &[String]) -> Vec<u16> {
        let table = &self.parsed.scenario.interfaces;
        let n = materials.len();
        // Without a `default` the rules of the language have said so.
        let default = table.names().position(|name| name == "default");
        let mut rows = vec![default.unwrap_or(0) as u16; n * n];
        for (row, (name, interface)) in table.iter().enumerate() {
            let Some(pair) = &interface.between else {
                continue;
            };
            let number = |name: &str| materials.iter().position(|m| m == name);
            let (Some(a), Some(b)) = (number(pair[0].as_str()), number(pair[1].as_str())) else {
                let message = format!("interfaces.{name} refers to materials that do not exist");
                let error = Diagnostic::error("name.unknown", message);
                self.found.push(error.at(pair[0].span.clone()));
                continue;
            };
            rows[a * n + b] = row as u16;
            rows[b * n + a] = row as u16;
        }
        rows
    }

    /// Divides all strengths, those of later phases too, by `strength_factor`.
    pub(super) fn reduce_strength(&mut self) {
        let scenario = &self.parsed.scenario;
        let factor = self.reading("", scenario).strength_factor();
        if factor == 1.0 {
            return;
        }
        // The coefficient is the tangent of the angle: both parts of the strength fall by the same factor.
        let reduce = |law: &mut ContactLaw| {
            law.friction /= factor;
            law.cohesion /= factor;
        };
        for interface in &mut self.setup.interfaces {
            reduce(&mut interface.contact);
            if let Some(bond) = &mut interface.bond {
                *bond = bond.reduced(factor);
            }
        }
        for interface in &mut self.spatial.interfaces {
            reduce_joint(&mut interface.joint, factor);
            interface.bond = interface.bond.map(|bond| bond.reduced(factor));
        }
        for phase in &mut self.plan.phases {
            phase.contacts.iter_mut().for_each(|(_, law)| reduce(law));
            for (_, law) in &mut phase.joints {
                reduce_joint(law, factor);
            }
        }
    }

    fn contact_law(
        &mut self,
        row: usize,
        name: &str,
        interface: &language::Interface,
        size: f64,
    ) -> Option<ContactLaw> {
        let estimate = match &interface.normal_stiffness {
            Some(_) => None,
            None => Some(self.default_stiffness(row, name, size)?),
        };
        let friction = self.friction(name, interface)?;
        let mut read = self.reading(format!("interfaces.{name}"), interface);
        let normal = read.law();
        let (value, why) = estimate.unwrap_or_default();
        let normal_stiffness = read.normal_stiffness_or(value, Provenance::Derived, &why);
        let half = 0.5 * normal_stiffness;
        let shear_stiffness =
            read.shear_stiffness_or(half, Provenance::Derived, "half the normal stiffness");
        let friction_law = read.friction_law();
        let clip_speed = match friction_law {
            FrictionLaw::Clipped => read.clip_speed(),
            FrictionLaw::ShearSpring | FrictionLaw::RateSign => None,
        };
        Some(ContactLaw {
            normal,
            reflex: interface.reflex.unwrap_or_default(),
            normal_stiffness,
            shear_stiffness,
            friction,
            cohesion: read.cohesion(),
            friction_law,
            clip_speed: clip_speed.unwrap_or(0.0),
            damping_ratio: match read.restitution() {
                Some(wanted) => ratio_of(wanted),
                None => read.damping_ratio(),
            },
        })
    }

    /// Tangent of the friction angle, given by either key.
    fn friction(&mut self, name: &str, interface: &language::Interface) -> Option<f64> {
        let mut read = self.reading(format!("interfaces.{name}"), interface);
        let friction = friction(&mut read);
        if friction.is_none() {
            let message = format!("interfaces.{name} has no friction");
            let error = Diagnostic::error("key.missing", message);
            let help = "write for example friction_angle = \"30 deg\"";
            self.found.push(error.help(help));
        }
        friction
    }

    /// 10 (K + 4G/3)/L of the softest material that meets another one through this row.
    fn default_stiffness(&mut self, row: usize, name: &str, size: f64) -> Option<(f64, String)> {
        let scenario = &self.parsed.scenario;
        let n = self.setup.materials.len();
        let (mut softest, mut lacking): (Option<(f64, &str)>, Option<&str>) = (None, None);
        for (number, (material, properties)) in scenario.materials.iter().enumerate() {
            let used =
                (0..n).any(|other| self.setup.pair_table[number * n + other] as usize == row);
            if !used {
                continue;
            }
            let (Some(young), Some(poisson)) = (&properties.young, &properties.poisson) else {
                // It might be the softest: without its moduli nothing can be estimated, where it has blocks that meet others.
                if self.meets_in_row(number, row) {
                    lacking = Some(material.as_str());
                }
                continue;
            };
            // K + 4G/3 = E (1 - nu) / ((1 + nu)(1 - 2 nu))
            let (e, nu) = (young.si(), poisson.si());
            let modulus = e * (1.0 - nu) / ((1.0 + nu) * (1.0 - 2.0 * nu));
            if softest.is_none_or(|(least, _)| modulus < least) {
                softest = Some((modulus, material.as_str()));
            }
        }
        if let Some(material) = lacking {
            let message = format!("interfaces.{name} has no normal stiffness");
            let help = format!(
                "write for example normal_stiffness = \"10 GPa/m\", or give materials.{material} \
                 `young` and `poisson`, from which it is estimated"
            );
            self.found.push(Diagnostic::error("key.missing", message).help(help));
            return None;
        }
        let (modulus, material) = softest.unwrap_or((1e9, ""));
        let stiffness = 10.0 * modulus / size;
        let why = format!(
            "10 (K + 4G/3)/L with the median block size L = {} (material `{material}`)",
            with_unit(size, "m")
        );
        Some((stiffness, why))
    }

    /// Whether the model has blocks of a material, and others that they meet through this row.
    fn meets_in_row(&self, number: usize, row: usize) -> bool {
        let (n, blocks) = (self.setup.materials.len(), &self.setup.blocks);
        let count = |k: usize| blocks.iter().filter(|b| usize::from(b.material) == k).count();
        count(number) > 0
            && (0..n).any(|other| {
                let least = if other == number { 1 } else { 0 };
                usize::from(self.setup.pair_table[number * n + other]) == row
                    && count(other) > least
            })
    }

    /// Median of the square root of the area, of the blocks that are free to move if there are any:
    /// a floor says nothing about the contacts that matter.
    fn median_size(&self) -> f64 {
        let mut held = vec![false; self.setup.blocks.len()];
        for support in &self.setup.supports {
            let whole = match support.motion {
                Motion::Fixed { x, y, rotation } => x && y && rotation,
                Motion::Velocity { .. } | Motion::Acceleration { .. } => false,
            };
            support.blocks.iter().for_each(|&b| held[b as usize] |= whole);
        }
        let all_held = held.iter().all(|&h| h);
        let size = |v: &[riprap_geom::Vec2]| polygon::signed_area(v).abs().sqrt();
        let mut sizes: Vec<f64> = self
            .setup
            .blocks
            .iter()
            .zip(&held)
            .filter(|(_, held)| all_held || !**held)
            .map(|(block, _)| size(&block.vertices))
            .collect();
        sizes.sort_by(f64::total_cmp);
        sizes.get(sizes.len() / 2).copied().unwrap_or(1.0)
    }

    /// `angle` is that of the friction of the contact, rad.
    fn bond(&mut self, name: &str, bond: &Bond, contact: &ContactLaw, angle: f64) -> BondLaw {
        let mut read = self.reading(format!("interfaces.{name}.bond"), bond);
        let default = Provenance::Default;
        let normal_stiffness = read.normal_stiffness_or(contact.normal_stiffness, default, "");
        let shear_stiffness = read.shear_stiffness_or(contact.shear_stiffness, default, "");
        let of = |angle: &Option<Quantity<FrictionAngle>>| angle.as_ref().map(Quantity::tangent);
        let friction = of(&bond.friction_angle).unwrap_or(contact.friction);
        let angle = read.friction_angle_or(angle, default, "");
        let residual_friction = of(&bond.residual_friction_angle).unwrap_or(friction);
        read.residual_friction_angle_or(angle, default, "");
        BondLaw {
            normal_stiffness,
            shear_stiffness,
            strength: Strength {
                tension: read.tension(),
                cohesion: read.cohesion(),
                friction,
                residual_friction,
                residual_cohesion: read.residual_cohesion(),
                ..Strength::default()
            },
            behaviour: Default::default(),
            damping_ratio: read.damping_ratio(),
            points: read.points(),
        }
    }
}

/// Tangent of a changed friction angle, if it changes.
pub(super) fn changed_friction(change: &InterfaceChange) -> Option<f64> {
    let angle = change.friction_angle.as_ref().map(Quantity::tangent);
    let coefficient = change.friction_coefficient.as_ref().map(Quantity::si);
    angle.or(coefficient)
}

/// Damping ratio of changed contacts, if it changes.
pub(super) fn changed_damping(change: &InterfaceChange) -> Option<f64> {
    let restitution = change.restitution.as_ref().map(|wanted| ratio_of(wanted.si()));
    restitution.or(change.damping_ratio.as_ref().map(Quantity::si))
}

/// Tangent of the friction angle, given by either key.
pub(super) fn friction(read: &mut Read<'_, language::Interface>) -> Option<f64> {
    let angle = read.said().friction_angle.as_ref().map(Quantity::tangent);
    read.friction_angle();
    angle.or_else(|| read.friction_coefficient())
}

/// Angle of friction that defaults are shown with, rad.
pub(super) fn angle_shown(said: &language::Interface, friction: f64) -> f64 {
    let given = said.friction_angle.as_ref().map(Quantity::si);
    given.unwrap_or_else(|| libm::atan(friction))
}

/// Changes a law as a phase says; keys that are not given stay.
pub(super) fn change_contact(law: &mut ContactLaw, change: &InterfaceChange) {
    *law = ContactLaw {
        normal: change.law.unwrap_or(law.normal),
        reflex: change.reflex.unwrap_or(law.reflex),
        normal_stiffness: change.normal_stiffness.si_or(law.normal_stiffness),
        shear_stiffness: change.shear_stiffness.si_or(law.shear_stiffness),
        friction: changed_friction(change).unwrap_or(law.friction),
        cohesion: change.cohesion.si_or(law.cohesion),
        friction_law: change.friction_law.unwrap_or(law.friction_law),
        clip_speed: change.clip_speed.si_or(law.clip_speed),
        damping_ratio: changed_damping(change).unwrap_or(law.damping_ratio),
    };
}
