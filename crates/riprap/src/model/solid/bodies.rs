//! Rigid blocks with a mass and moments of inertia of their own.

use riprap_geom::{Mat3, Vec3};

use super::shapes::solid;
use super::turn::Turn;
use crate::model::builder::Builder;
use crate::scenario::Quantity;
use crate::scenario::language::Block;
use crate::scenario::read::{Provenance, with_unit};
use crate::spatial::read::fields::principal;
use crate::spatial::setup::GivenBody;

/// Share by which the largest principal moment may exceed the sum of the others: round-off of what is typed.
const ROUNDING: f64 = 1e-9;

impl Builder<'_> {
    /// Enters mass and inertia of the blocks of a table, the first of which has this number, where it gives them.
    pub(super) fn given_bodies(&mut self, block: &Block, first: u32) {
        if block.mass.is_none() && block.inertia.is_none() {
            return;
        }
        if !self.parsed.scenario.refine.is_empty() {
            let message =
                format!("`{}` has its own mass or inertia, and the scene has `refine`", block.name);
            let help = "split parts take the density of the material; leave one of the two out";
            self.error_at("key.forbidden", &block.name, message, help);
            return;
        }
        for number in first..self.spatial.blocks.len() as u32 {
            let spec = &self.spatial.blocks[number as usize];
            let density = self.spatial.materials[usize::from(spec.material)].density;
            let moments = solid(&spec.shape).moments();
            let mass = (block.mass.as_ref()).map_or(density * moments.volume, Quantity::si);
            let inertia = match &block.inertia {
                Some(said) => {
                    let [xx, yy, zz, yz, zx, xy] = said.symmetric();
                    let given = Mat3::from_cols(
                        Vec3::new(xx, xy, zx),
                        Vec3::new(xy, yy, yz),
                        Vec3::new(zx, yz, zz),
                    );
                    let turn = block.rotate.as_ref().map(|r| Turn::new(r, Vec3::ZERO));
                    turn.map_or(given, |turn| turn.of_tensor(&given))
                }
                None => mass / moments.volume * moments.inertia,
            };
            if number == first && !self.is_of_a_body(block, mass, &inertia) {
                return;
            }
            self.spatial.bodies.push(GivenBody { block: number, mass, inertia });
        }
    }

    /// Whether there is a body with this tensor of inertia: its principal moments are greater than 0, and none is greater than the sum of the others.
    fn is_of_a_body(&mut self, block: &Block, mass: f64, inertia: &Mat3) -> bool {
        let [high, middle, low] = principal(inertia);
        let words = [low, middle, high].map(|x| with_unit(x, "kg m2")).join(", ");
        if low > 0.0 && high <= (middle + low) * (1.0 + ROUNDING) {
            let key = format!("blocks.{}", block.name);
            let from = Provenance::given(block.mass.is_some());
            self.explain(format!("{key}.mass"), with_unit(mass, "kg"), from, "");
            let from = match block.inertia {
                Some(_) => Provenance::Given,
                None => Provenance::Derived,
            };
            self.explain(
                format!("{key}.inertia"),
                words,
                from,
                "principal moments about the centroid",
            );
            return true;
        }
        let message = format!(
            "the moments of inertia of `{}` are not physical: their principal values are {words}",
            block.name
        );
        let help = "all three must be positive, and none may exceed the sum of the other two; the order is [xx, yy, zz, yz, zx, xy], and yz is minus \
                    the sum of m y z";
        let span = block.inertia.as_ref().map_or(block.name.span.clone(), |i| i.span.clone());
        self.error_at("value.inertia", span, message, help);
        false
    }
}
