//! What patches, facets and found contacts between two blocks carry together.

use riprap_geom::Vec3;

use crate::laws::mohr_coulomb::Strength;
use crate::laws::norm;
use crate::query::view::View;
use crate::state::deform::{Deform, Facet};
use crate::state::patches::flag;

/// Share of the residual strength from which the point of a facet slides: what is less is no round-off.
const AT_LIMIT: f64 = 1.0 - 1e-9;

/// Forces between two blocks, without dashpots.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Borne {
    /// Across the surfaces, compression positive, N.
    pub normal: f64,
    /// On the first block along the surfaces, N.
    pub shear: Vec3,
    pressing: u32,
    sliding: u32,
}

impl Borne {
    /// Whether there is something that presses, and all of it slides.
    #[must_use]
    pub fn slides(&self) -> bool {
        self.pressing > 0 && self.sliding == self.pressing
    }

    /// Shear over normal force; 0 where nothing presses.
    #[must_use]
    pub fn ratio(&self) -> f64 {
        if self.normal > 0.0 { self.shear.length() / self.normal } else { 0.0 }
    }

    /// Adds a force on the first block across a surface whose unit normal points out of it.
    fn add(&mut self, force: Vec3, outward: Vec3) {
        let across = force.dot(outward);
        self.normal -= across;
        self.shear += force - across * outward;
    }

    /// Counts what presses, and what of it slides.
    fn count(&mut self, pressing: u32, sliding: u32) {
        self.pressing += pressing;
        self.sliding += sliding;
    }
}

/// 1 where ends are those asked for, -1 where they are the other way round.
fn sign(ends: [u32; 2], pair: [u32; 2]) -> Option<f64> {
    match ends {
        e if e == pair => Some(1.0),
        [i, j] if [j, i] == pair => Some(-1.0),
        _ => None,
    }
}

impl View<'_> {
    /// What patches, facets and found contacts between two blocks carry. Found contacts without one normal count along the surface.
    #[must_use]
    pub fn borne(&self, first: u32, second: u32) -> Borne {
        let (pair, mut sum) = ([first, second], Borne::default());
        for (contact, force) in self.contacts_of(first as usize) {
            if let Some(sign) = sign(contact.ends, pair) {
                sum.add(force, sign * contact.normal);
                sum.count(1, u32::from(contact.sliding));
            }
        }
        for (p, ends) in self.world.patches.ends.iter().enumerate() {
            if let Some(sign) = sign(*ends, pair) {
                self.add_patch(&mut sum, p, sign);
            }
        }
        if let Some((deform, work)) = self.deformables() {
            for facet in deform.facets.iter().filter(|f| !f.parted) {
                if let Some(sign) = sign(facet.blocks, pair) {
                    for p in facet.points() {
                        let force = Vec3::from_array(work.slots[p]);
                        sum.add(sign * force, sign * facet.now[0]);
                        self.count_point(&mut sum, deform, facet, p, force);
                    }
                }
            }
        }
        sum
    }

    fn add_patch(&self, sum: &mut Borne, p: usize, sign: f64) {
        let points = self.patch_points(p);
        let tractions = self.patch(p).tractions(&points);
        let force = points.resultant(self.patch_class(p), &tractions).force;
        sum.add(sign * force, sign * points.frame[0]);
        let flags = self.world.patches.flags[p];
        for (q, t) in tractions.iter().enumerate() {
            let slides = flags & flag::of(flag::SLIDING, q) != 0;
            if t[0] < 0.0 {
                sum.count(1, u32::from(slides));
            }
        }
    }

    /// Counts the point of a facet with this force: one that has broken slides where it bears all the shear that friction allows.
    fn count_point(&self, sum: &mut Borne, deform: &Deform, facet: &Facet, p: usize, force: Vec3) {
        let traction = facet.now.map(|e| e.dot(force) / deform.points[p].area);
        if traction[0] >= 0.0 {
            return;
        }
        let law = self.world.setup.interfaces[usize::from(facet.row)].bond;
        let strength = law.and_then(|law| law.strength);
        let limit = |s: Strength| s.residual(traction[0]);
        let shear = norm(traction[1], traction[2]);
        let slides =
            deform.memory[p].state.is_broken() && shear >= AT_LIMIT * strength.map_or(0.0, limit);
        sum.count(1, u32::from(slides));
    }
}
