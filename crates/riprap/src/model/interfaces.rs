//! Laws of contact per pair of materials.

use riprap_geom::polygon;
use riprap_keys::Words;

use super::builder::Builder;
use super::explain::{Provenance, with_unit};
use super::solid::reduce_joint;
use crate::planar::setup::{self, BondLaw, ContactLaw, FrictionLaw, Motion};
use crate::scenario::language::{self, Bond, InterfaceChange};
use crate::scenario::{Diagnostic, Quantity, Table};

impl Builder<'_> {
    /// Fills `interfaces` and `pair_table`; supports must be known.
    pub(super) fn interfaces(&mut self) {
        let table: &Table<language::Interface> = &self.parsed.scenario.interfaces;
        let n = self.setup.materials.len();
        let default = table
            .names()
            .position(|name| name == "default")
            .unwrap_or(0);
        self.setup.pair_table = vec![default as u16; n * n];
        for (row, (name, interface)) in table.iter().enumerate() {
            let Some(pair) = &interface.between else {
                continue;
            };
            let number = |name: &str| self.setup.materials.iter().position(|m| m == name);
            let (Some(a), Some(b)) = (number(pair[0].as_str()), number(pair[1].as_str())) else {
                let message = format!("interfaces.{name} is between materials that do not exist");
                let error = Diagnostic::error("name.unknown", message);
                self.found.push(error.at(pair[0].span.clone()));
                continue;
            };
            self.setup.pair_table[a * n + b] = row as u16;
            self.setup.pair_table[b * n + a] = row as u16;
        }
        let size = self.median_size();
        for (row, (name, interface)) in table.iter().enumerate() {
            if let Some(law) = self.contact_law(row, name.as_str(), interface, size) {
                let bond = interface
                    .bond
                    .as_ref()
                    .map(|bond| self.bond(name.as_str(), bond, &law));
                let name = name.text.clone();
                self.setup.interfaces.push(setup::Interface {
                    name,
                    contact: law,
                    bond,
                });
            }
        }
    }

    /// Divides all strengths, those of later phases too, by `strength_factor`.
    pub(super) fn reduce_strength(&mut self) {
        let given = self.parsed.scenario.strength_factor.as_ref();
        let factor = self.or("strength_factor", given, 1.0, "");
        if factor == 1.0 {
            return;
        }
        let reduce = |law: &mut ContactLaw| {
            law.friction /= factor;
            law.cohesion /= factor;
        };
        for interface in &mut self.setup.interfaces {
            reduce(&mut interface.contact);
            if let Some(bond) = &mut interface.bond {
                for strength in [
                    &mut bond.tension,
                    &mut bond.cohesion,
                    &mut bond.friction,
                    &mut bond.residual_friction,
                    &mut bond.residual_cohesion,
                ] {
                    *strength /= factor;
                }
            }
        }
        for interface in &mut self.spatial.interfaces {
            reduce_joint(&mut interface.joint, factor);
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
        let key = |word: &str| format!("interfaces.{name}.{word}");
        let normal = interface.law.unwrap_or_default();
        let from = if interface.law.is_some() {
            Provenance::Given
        } else {
            Provenance::Default
        };
        self.explain(key("law"), normal.word(), from, "");
        let normal_stiffness = match &interface.normal_stiffness {
            Some(given) => {
                self.explain(
                    key("normal_stiffness"),
                    given.raw.to_string(),
                    Provenance::Given,
                    "",
                );
                given.si()
            }
            None => self.default_stiffness(row, name, size)?,
        };
        let shear_stiffness = match &interface.shear_stiffness {
            Some(given) => {
                self.explain(
                    key("shear_stiffness"),
                    given.raw.to_string(),
                    Provenance::Given,
                    "",
                );
                given.si()
            }
            None => {
                let value = 0.5 * normal_stiffness;
                let why = "half the normal stiffness";
                let text = with_unit(value, "Pa/m");
                self.explain(key("shear_stiffness"), text, Provenance::Derived, why);
                value
            }
        };
        let friction = match (&interface.friction_angle, &interface.friction_coefficient) {
            (Some(angle), _) => {
                self.explain(
                    key("friction_angle"),
                    angle.raw.to_string(),
                    Provenance::Given,
                    "",
                );
                libm::tan(angle.si())
            }
            (None, Some(coefficient)) => {
                let text = coefficient.raw.to_string();
                self.explain(key("friction_coefficient"), text, Provenance::Given, "");
                coefficient.si()
            }
            (None, None) => {
                let message = format!("interfaces.{name} has no friction");
                let error = Diagnostic::error("key.missing", message);
                self.found
                    .push(error.help("write for example friction_angle = \"30 deg\""));
                return None;
            }
        };
        let given = interface.friction_law.is_some();
        let from = if given {
            Provenance::Given
        } else {
            Provenance::Default
        };
        let friction_law = interface.friction_law.unwrap_or_default();
        self.explain(key("friction_law"), friction_law.word(), from, "");
        let clip_speed = interface.clip_speed.as_ref().map_or(0.0, Quantity::si);
        if let (FrictionLaw::Clipped, Some(speed)) = (friction_law, &interface.clip_speed) {
            let raw = speed.raw.to_string();
            self.explain(key("clip_speed"), raw, Provenance::Given, "");
        }
        Some(ContactLaw {
            normal,
            reflex: interface.reflex.unwrap_or_default(),
            normal_stiffness,
            shear_stiffness,
            friction,
            cohesion: self.or(&key("cohesion"), interface.cohesion.as_ref(), 0.0, "Pa"),
            friction_law,
            clip_speed,
            damping_ratio: self.or(
                &key("damping_ratio"),
                interface.damping_ratio.as_ref(),
                0.2,
                "",
            ),
        })
    }

    /// 10 (K + 4G/3)/L of the softest material that meets another one through this row.
    fn default_stiffness(&mut self, row: usize, name: &str, size: f64) -> Option<f64> {
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
                lacking = Some(material.as_str());
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
            self.found
                .push(Diagnostic::error("key.missing", message).help(help));
            return None;
        }
        let (modulus, material) = softest.unwrap_or((1e9, ""));
        let stiffness = 10.0 * modulus / size;
        let why = format!(
            "10 (K + 4G/3)/L with the median block size L = {} (material `{material}`)",
            with_unit(size, "m")
        );
        let key = format!("interfaces.{name}.normal_stiffness");
        self.explain(key, with_unit(stiffness, "Pa/m"), Provenance::Derived, &why);
        Some(stiffness)
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
            support
                .blocks
                .iter()
                .for_each(|&b| held[b as usize] |= whole);
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

    fn bond(&mut self, name: &str, bond: &Bond, contact: &ContactLaw) -> BondLaw {
        let key = |word: &str| format!("interfaces.{name}.bond.{word}");
        let kn = contact.normal_stiffness;
        let normal_stiffness = self.or(
            &key("normal_stiffness"),
            bond.normal_stiffness.as_ref(),
            kn,
            "Pa/m",
        );
        let ks = contact.shear_stiffness;
        let shear_stiffness = self.or(
            &key("shear_stiffness"),
            bond.shear_stiffness.as_ref(),
            ks,
            "Pa/m",
        );
        let friction = match &bond.friction_angle {
            Some(angle) => libm::tan(angle.si()),
            None => contact.friction,
        };
        let degrees = |tangent: f64| with_unit(libm::atan(tangent).to_degrees(), "deg");
        let from = |given: bool| {
            if given {
                Provenance::Given
            } else {
                Provenance::Default
            }
        };
        let given = from(bond.friction_angle.is_some());
        self.explain(key("friction_angle"), degrees(friction), given, "");
        let residual_friction = match &bond.residual_friction_angle {
            Some(angle) => libm::tan(angle.si()),
            None => friction,
        };
        let given = from(bond.residual_friction_angle.is_some());
        self.explain(
            key("residual_friction_angle"),
            degrees(residual_friction),
            given,
            "",
        );
        let points = bond.points.unwrap_or(2);
        if !(1..=5).contains(&points) {
            let message = format!("`points` of interfaces.{name}.bond is {points}");
            let error = Diagnostic::error("value.range", message);
            self.found.push(
                error
                    .at(bond.tension.span.clone())
                    .help("from 1 to 5 is possible"),
            );
        }
        self.explain(
            key("points"),
            points.to_string(),
            from(bond.points.is_some()),
            "",
        );
        self.explain(
            key("tension"),
            bond.tension.raw.to_string(),
            Provenance::Given,
            "",
        );
        self.explain(
            key("cohesion"),
            bond.cohesion.raw.to_string(),
            Provenance::Given,
            "",
        );
        BondLaw {
            normal_stiffness,
            shear_stiffness,
            tension: bond.tension.si(),
            cohesion: bond.cohesion.si(),
            friction,
            residual_friction,
            residual_cohesion: self.or(
                &key("residual_cohesion"),
                bond.residual_cohesion.as_ref(),
                0.0,
                "Pa",
            ),
            damping_ratio: self.or(&key("damping_ratio"), bond.damping_ratio.as_ref(), 0.2, ""),
            points,
        }
    }
}

/// A law after the changes of a phase; keys that are not given stay.
pub(super) fn changed(law: &ContactLaw, change: &InterfaceChange) -> ContactLaw {
    fn si<K: crate::scenario::quantity::Kind>(q: Option<&Quantity<K>>, old: f64) -> f64 {
        q.map_or(old, Quantity::si)
    }
    let friction = match (&change.friction_angle, &change.friction_coefficient) {
        (Some(angle), _) => libm::tan(angle.si()),
        (None, Some(coefficient)) => coefficient.si(),
        (None, None) => law.friction,
    };
    ContactLaw {
        normal: change.law.unwrap_or(law.normal),
        reflex: change.reflex.unwrap_or(law.reflex),
        normal_stiffness: si(change.normal_stiffness.as_ref(), law.normal_stiffness),
        shear_stiffness: si(change.shear_stiffness.as_ref(), law.shear_stiffness),
        friction,
        cohesion: si(change.cohesion.as_ref(), law.cohesion),
        friction_law: change.friction_law.unwrap_or(law.friction_law),
        clip_speed: si(change.clip_speed.as_ref(), law.clip_speed),
        damping_ratio: si(change.damping_ratio.as_ref(), law.damping_ratio),
    }
}
