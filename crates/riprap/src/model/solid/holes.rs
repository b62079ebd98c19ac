//! What a charge along a line has of its hole: detonation and stemming.

use riprap_geom::Vec3;

use super::global;
use crate::laws::explosive::Products;
use crate::model::builder::Builder;
use crate::scenario::language::{self, GasCavity, Primer, span_of};
use crate::scenario::read::{Provenance, with_unit};
use crate::scenario::{Name, Quantity};
use crate::spatial::setup::{Detonation, Hole, Place, Region, Stemming};

/// A primer may lie beside the line of its charge by this share of its length.
const BESIDE: f64 = 0.05;
/// Pressure of the air where no gas enters cracks, Pa.
const AIR: f64 = 1e5;
/// A column of stemming is looked for in the rock up to this share of its length.
const UPPER: f64 = 0.99;

impl Builder<'_> {
    /// The hole of a charge; `above`: its number and the length above it without explosive (m), where it is one of several. `None` after an error.
    pub(super) fn hole(
        &mut self,
        name: &Name,
        gas: &GasCavity,
        explosive: &Products,
        place: &Place,
        above: Option<(u32, f64)>,
    ) -> Option<Hole> {
        // On other places detonation and stemming are reported by the rules of the language.
        let Place::Line { from, to } = place else { return Some(Hole::default()) };
        let soft = !self.spatial.deform.sets.is_empty();
        if soft && (gas.detonation.is_some() || gas.stemming.is_some()) {
            let message = format!("the hole of `{name}` is in a model with deformable blocks");
            let help = "detonation and stemming need rigid blocks; leave them out";
            self.error_at("source.hole", name, message, help);
            return None;
        }
        let detonation = match &gas.detonation {
            None => None,
            Some(said) => Some(self.detonation(name, said, explosive, [*from, *to], above)?),
        };
        let stemming = match &gas.stemming {
            // Between decks it stays.
            Some(said) if above.is_none_or(|(k, _)| k == 1 || gas.decks.is_none()) => {
                Some(self.stemming(name, gas, said, [*from, *to], above)?)
            }
            Some(_) | None => None,
        };
        Some(Hole { detonation, stemming })
    }

    fn detonation(
        &mut self,
        name: &Name,
        said: &language::Detonation,
        explosive: &Products,
        [from, to]: [Vec3; 2],
        above: Option<(u32, f64)>,
    ) -> Option<Detonation> {
        let path = format!("sources.{name}.gas_cavity.detonation");
        let mut read = self.reading(path.as_str(), said);
        let own = explosive.detonation_velocity();
        let velocity = read.velocity_or(own, Provenance::Derived, &with_unit(own, "m/s"));
        let end = read.primer();
        let length = from.distance(to);
        let Some(at) = &said.at else {
            let primer = match end {
                Primer::Collar => 0.0,
                Primer::Toe => length,
            };
            return Some(Detonation { primer, velocity });
        };
        let off = global(at) - self.spatial.origin - from;
        let along = (to - from) / length;
        let depth = off.dot(along);
        let beside = (off - depth * along).length();
        let help = if above.is_some() {
            "give `primer = \"toe\"` or `\"collar\"`: a point belongs to a single charge"
        } else {
            "give a point on the line of the charge, or `primer = \"toe\"` or `\"collar\"`"
        };
        if above.is_some() || !(0.0..=length).contains(&depth) || beside > BESIDE * length {
            let message = match above {
                Some(_) => format!("the primer of `{name}` is one point for several charges"),
                None => format!("the primer of `{name}` lies outside its charge"),
            };
            self.error_at("source.primer", span_of(at), message, help);
            return None;
        }
        Some(Detonation { primer: depth, velocity })
    }

    fn stemming(
        &mut self,
        name: &Name,
        gas: &GasCavity,
        said: &language::Stemming,
        [from, to]: [Vec3; 2],
        above: Option<(u32, f64)>,
    ) -> Option<Stemming> {
        use crate::scenario::language::Venting;
        let length = match (said.length.as_ref().map(Quantity::si), above) {
            (Some(length), _) => length,
            (None, Some((_, stemmed))) => stemmed,
            (None, None) => 0.0,
        };
        let at = said.length.as_ref().map_or(name.span.clone(), |length| length.span.clone());
        let outer = from + (from - to).normalize() * (UPPER * length);
        let wrong = match (&gas.venting, above) {
            (Some(Venting::Heave(_) | Venting::Time(_)), _) => Some((
                format!("the gas of `{name}` vents by a rule and by its hole"),
                "leave `venting.heave` and `venting.time` out: gas leaves once the stemming is out",
            )),
            _ if length == 0.0 => Some((
                format!("the stemming of `{name}` has no length"),
                "give its `length`, or the column stemming_m of the pattern",
            )),
            (_, Some((k, stemmed))) if length > stemmed * (1.0 + 1e-9) => Some((
                format!(
                    "the stemming of `{name}` is {} long, but charge {k} begins {} from the collar",
                    with_unit(length, "m"),
                    with_unit(stemmed, "m")
                ),
                "give a shorter `length`, or leave it out: then it reaches up to the collar",
            )),
            _ if self.touching(&Region::Point(outer)).is_empty() => Some((
                format!(
                    "the stemming of `{name}`, {} long, leaves the rock",
                    with_unit(length, "m")
                ),
                "give a shorter `length`: it stands above the end `from` of the charge, in line with it",
            )),
            _ => None,
        };
        if let Some((message, help)) = wrong {
            self.error_at("source.stemming", at, message, help);
            return None;
        }
        let mut read = self.reading(format!("sources.{name}.gas_cavity.stemming"), said);
        let (density, diameter, friction) = (read.density(), read.diameter(), read.friction());
        let air = match &gas.venting {
            Some(Venting::Cracks(cracks)) => cracks.air_pressure.as_ref().map_or(AIR, Quantity::si),
            _ => AIR,
        };
        Some(Stemming { length, diameter, density, friction, air })
    }
}
