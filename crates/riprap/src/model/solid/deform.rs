//! Deformable blocks: their sets, bond laws, held nodes.

use super::supports::held_along;
use crate::accounts::Holder;
use crate::dynamics::TimeFunction;
use crate::model::accounts::condition_name;
use crate::model::builder::Builder;
use crate::scenario::language::{self, Mechanics, Support, Target};
use crate::scenario::read::{Given, Provenance, Read};
use crate::scenario::{Diagnostic, Name, Quantity, target_span};
use crate::spatial::setup::deform::{
    BondLaw, BondSprings, Cohesive, DeformableSet, NodeHold, Notch, Strength,
};

impl Builder<'_> {
    /// Enters the blocks of one table, numbers `first` and following, if they are deformable.
    pub(super) fn enter_deformable(&mut self, block: &language::Block, first: u32) {
        let Some(Mechanics::Deformable(said)) = &block.mechanics else {
            return;
        };
        let path = format!("blocks.{}.mechanics.deformable", block.name);
        let strain = self.reading(path, &**said).strain();
        let mut field = |names: &Option<[Name; 3]>| {
            [0, 1, 2].map(|k: usize| {
                let text = &names.as_ref()?[k];
                self.formula(text, &["x", "y", "z"])
            })
        };
        let (displacement, velocity) = (field(&said.displacement), field(&said.velocity));
        let last = self.spatial.blocks.len() as u32;
        self.spatial.deform.sets.push(DeformableSet {
            blocks: (first..last).collect(),
            strain,
            displacement,
            velocity,
        });
    }

    /// Laws of the bonds of all interfaces, and where bonds are broken at the start.
    pub(super) fn bonds(&mut self) {
        for (row, (name, interface)) in self.parsed.scenario.interfaces.iter().enumerate() {
            let said = interface.brittle_bond.as_ref();
            let law = said.map(|said| self.bond_law(name.as_str(), said));
            self.spatial.interfaces[row].bond = law;
        }
        for notch in &self.parsed.scenario.notches {
            let corners = [&notch.region.min, &notch.region.max];
            let corners = corners.map(|corner| self.local(corner.xyz()));
            let springs = match notch.breaks.unwrap_or_default() {
                language::NotchBreaks::Springs => true,
                language::NotchBreaks::Facets => false,
            };
            self.spatial.deform.notches.push(Notch { corners, springs });
        }
    }

    fn bond_law(&mut self, name: &str, said: &language::BrittleBond) -> BondLaw {
        let mut read = self.reading(format!("interfaces.{name}.brittle_bond"), said);
        let springs = bond_springs(&mut read);
        if said.elastic {
            return BondLaw {
                springs,
                strength: None,
                cohesive: None,
                failure: said.failure.unwrap_or_default(),
            };
        }
        let failure = read.failure();
        let friction = said.friction_angle.as_ref().map_or(0.0, Quantity::tangent);
        let residual = said.residual_friction_angle.as_ref();
        let strength = Strength {
            tension: said.tension.si_or(0.0),
            cohesion: said.cohesion.si_or(0.0),
            friction,
            residual_friction: residual.map_or(friction, Quantity::tangent),
            residual_cohesion: read.residual_cohesion(),
            ..Strength::default()
        };
        let cohesive = said.cohesive.as_ref().map(|said| Cohesive {
            strength,
            energy: [said.mode_1.si(), said.mode_2.si()],
            softening: read.within("cohesive", said).softening(),
            // Looked at with the rules of the language.
            curve: (said.curve.as_ref()).and_then(|c| language::curve(c).ok()),
        });
        BondLaw { springs, strength: Some(strength), cohesive, failure }
    }

    /// Reports what deformable blocks cannot do; whether one of `blocks` is deformable.
    pub(super) fn any_deforms(&mut self, blocks: &[u32], target: &Target, what: &str) -> bool {
        let sets = &self.spatial.deform.sets;
        let deforms = |b: &u32| sets.iter().any(|s| s.blocks.binary_search(b).is_ok());
        let Some(&block) = blocks.iter().find(|b| deforms(b)) else {
            return false;
        };
        let name = self.directory.name(block);
        let message = format!("block `{name}` is deformable, and deformable blocks {what}");
        let error = Diagnostic::error("mechanics.deformable", message);
        self.found.push(error.at(target_span(target)));
        true
    }

    /// A support for nodes; whether it was one.
    pub(super) fn node_support(&mut self, support: &Support, number: usize) -> bool {
        let Target::Nodes(nodes) = &support.on else {
            return false;
        };
        if self.spatial.deform.sets.is_empty() {
            let message = "no block is deformable, so there are no nodes";
            let help = "write mechanics.deformable = {} for blocks, or name the blocks to hold";
            self.error_at("target.empty", nodes.min.span.clone(), message, help);
            return true;
        }
        let names: Vec<Name> = nodes.block.iter().chain(&nodes.group).cloned().collect();
        let blocks = if names.is_empty() {
            None
        } else {
            let found = self.directory.all(&names);
            match self.take(found) {
                Some(blocks) => Some(blocks),
                None => return true,
            }
        };
        let still = || Some(TimeFunction::Constant(0.0));
        let velocity = match (&support.fixed, &support.motion) {
            (Some(fixed), _) => held_along(fixed).map(|held| held.then(still).flatten()),
            (None, Some(language::Motion::Velocity(m))) => self.point_velocity(m),
            (None, Some(language::Motion::Acceleration(_))) => {
                let message = "nodes can only be driven by a velocity";
                let help = "write motion.velocity = { x = ... }";
                self.error_at("key.forbidden", nodes.min.span.clone(), message, help);
                return true;
            }
            // Reported by the rules of the language.
            (None, None) => return true,
        };
        let (min, max) = (self.local(nodes.min.xyz()), self.local(nodes.max.xyz()));
        let name = condition_name(support.name.as_ref(), &support.on, number);
        self.account(name, Holder::Nodes(self.spatial.deform.holds.len() as u16));
        self.spatial.deform.holds.push(NodeHold { min, max, blocks, velocity });
        true
    }
}

/// Springs of bonds: given, or from a thickness (that one of both is there is a rule of the language).
fn bond_springs(read: &mut Read<'_, language::BrittleBond>) -> BondSprings {
    if let Some(normal) = read.normal_stiffness() {
        let (half, why) = (0.5 * normal, "half the normal stiffness");
        let shear = read.shear_stiffness_or(half, Provenance::Derived, why);
        return BondSprings::Given([normal, shear]);
    }
    let said = read.said();
    let moduli = said.young.as_ref().zip(said.poisson.as_ref());
    BondSprings::Thickness {
        thickness: read.thickness().unwrap_or(0.0),
        moduli: moduli.map(|(young, poisson)| {
            let young = young.si();
            [young, 0.5 * young / (1.0 + poisson.si())]
        }),
    }
}
