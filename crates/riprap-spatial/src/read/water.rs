//! Where interfaces are, and the pressure of the standing water there.

use riprap_geom::Vec3;

use crate::push::water;
use crate::query::view::View;
use crate::read::contacts::Contact;
use crate::state::deform::Facet;

impl View<'_> {
    /// Centre of a patch, m (local).
    #[must_use]
    pub fn patch_place(&self, p: usize) -> Vec3 {
        let arm = self.patch_class(p).arms[0];
        let i = self.world.patches.ends[p][0] as usize;
        let arm = match &self.world.turned[i] {
            Some(turned) => turned.attitude * arm,
            None => arm,
        };
        self.position(i) + arm
    }

    /// Centre of a facet of deformable blocks, m (local).
    #[must_use]
    pub fn facet_place(&self, facet: &Facet) -> Vec3 {
        let first = facet.blocks[0] as usize;
        facet.centre + (self.position(first) - self.world.reference[first])
    }

    /// Centre of a found contact, m (local).
    #[must_use]
    pub fn contact_place(&self, contact: &Contact) -> Vec3 {
        let [i, j] = contact.ends.map(|b| self.position(b as usize));
        0.5 * (i + contact.arms[0] + contact.placed(j) + contact.arms[1])
    }

    /// Force of the standing water on all faces of a block, N; nothing on one that was removed or split.
    #[must_use]
    pub fn water_force(&self, b: usize) -> Vec3 {
        if !self.world.alive[b] {
            return Vec3::ZERO;
        }
        water::on_block(self.world, self.scratch.deform.as_deref(), b)
    }

    /// Largest pressure of the standing water at the centres of the interfaces between two blocks, Pa.
    #[must_use]
    pub fn pore_pressure_between(&self, a: u32, b: u32) -> f64 {
        let between = |ends: &[u32; 2]| *ends == [a, b] || *ends == [b, a];
        let ends = self.world.patches.ends.iter().enumerate();
        let patches = ends.filter(|(_, e)| between(e));
        let patches = patches.map(|(p, _)| self.patch_place(p));
        let deform = self.world.deform.as_deref();
        let facets = deform.into_iter().flat_map(|d| &d.facets);
        let facets = facets.filter(|f| between(&f.blocks));
        let facets = facets.map(|f| self.facet_place(f));
        let contacts = self.contacts().filter(|c| between(&c.ends));
        let contacts = contacts.map(|c| self.contact_place(&c));
        let places = patches.chain(facets).chain(contacts);
        let pressures = places.map(|at| self.world.pressure_between([a, b], at));
        pressures.fold(0.0, f64::max)
    }
}
