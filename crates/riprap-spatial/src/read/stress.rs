//! Average stress of blocks.

use riprap_geom::{Mat3, Vec3};

use crate::joint::patch;
use crate::push::boundary;
use crate::query::view::View;

/// Patches whose dyads are found before they are added.
const AT_ONCE: usize = 1 << 12;

fn outer(r: Vec3, f: Vec3) -> Mat3 {
    Mat3::from_cols(f.x * r, f.y * r, f.z * r)
}

impl View<'_> {
    /// Average stress of every block, Pa, tension-positive: of a deformable one over its elements, of a rigid one `(1/V) sum r (x) f`
    /// over patches, found contacts, terrain, boundary faces, bolts and walls of cavities, symmetrised. Where water stands it is the
    /// effective stress: the push of water on faces is left out.
    #[must_use]
    pub fn stresses(&self) -> Vec<Mat3> {
        let mut sum = vec![Mat3::ZERO; self.world.alive.len()];
        self.dyads(None, &mut |b, dyad| sum[b] += dyad);
        for (b, s) in sum.iter_mut().enumerate() {
            *s = self.average(b, *s);
        }
        sum
    }

    /// The same of one block.
    #[must_use]
    pub fn stress(&self, block: usize) -> Mat3 {
        let mut sum = Mat3::ZERO;
        if self.deformable(block).is_none() {
            self.dyads(Some(block), &mut |_, dyad| sum += dyad);
        }
        self.average(block, sum)
    }

    fn average(&self, b: usize, sum: Mat3) -> Mat3 {
        match self.deformable(b) {
            Some(deformable) => deformable.stress(),
            None => (0.5 / self.world.solid_of(b).volume) * (sum + sum.transpose()),
        }
    }

    /// `r (x) f` of each point of patch `p` on its blocks.
    fn patch_dyads(&self, p: usize, [i, j]: [usize; 2]) -> [[Mat3; 2]; 4] {
        let class = self.patch_class(p);
        let points = self.patch_points(p);
        let e = points.frame;
        let tractions = self.patch(p).tractions(&points);
        let mut dyads = [[Mat3::ZERO; 2]; 4];
        for (q, (on, t)) in dyads.iter_mut().zip(&tractions).enumerate() {
            let force = 0.25 * class.area * (t[0] * e[0] + t[1] * e[1] + t[2] * e[2]);
            let offset = patch::place(class, q);
            on[0] = outer(self.turned(i, class.arms[0] + offset), force);
            on[1] = outer(self.turned(j, class.arms[1] + offset), -force);
        }
        dyads
    }

    /// Hands over `r (x) f` of all that acts on the outline of a block, or of all blocks, r from their centroids.
    fn dyads(&self, only: Option<usize>, put: &mut dyn FnMut(usize, Mat3)) {
        let world = self.world;
        let wanted = |b: usize| only.is_none_or(|only| only == b);
        let ends = |p: usize| world.patches.ends[p].map(|b| b as usize);
        let mut put = |b: usize, dyad: Mat3| {
            if wanted(b) {
                put(b, dyad);
            }
        };
        let mut put_patch = |[i, j]: [usize; 2], dyads: [[Mat3; 2]; 4]| {
            for [on_i, on_j] in dyads {
                put(i, on_i);
                put(j, on_j);
            }
        };
        let count = world.patches.len();
        if only.is_some() {
            for (p, ends) in (0..count).map(|p| (p, ends(p))) {
                if ends.iter().any(|b| wanted(*b)) {
                    put_patch(ends, self.patch_dyads(p, ends));
                }
            }
        } else {
            // By all threads what a patch does, by one where it goes, in the order of the patches; so many at a time that they stay
            // in a cache.
            for first in (0..count).step_by(AT_ONCE) {
                let these = count.min(first + AT_ONCE) - first;
                let chunks = self.scratch.exec.chunked(these, |chunk| {
                    let mut found = Vec::with_capacity(chunk.len());
                    for p in chunk.start + first..chunk.end + first {
                        let ends = ends(p);
                        found.push((ends, self.patch_dyads(p, ends)));
                    }
                    found
                });
                for (ends, dyads) in chunks.into_iter().flatten() {
                    put_patch(ends, dyads);
                }
            }
        }
        for contact in self.contacts() {
            let [i, j] = contact.ends.map(|b| b as usize);
            put(i, outer(contact.arms[0], -contact.force));
            put(j, outer(contact.arms[1], contact.force));
        }
        let context = boundary::Context::new(world);
        for face in world.faces.iter().filter(|f| wanted(f.block as usize)) {
            put(face.block as usize, context.dyad(face));
        }
        for (b, arm, force) in world.bolt_forces() {
            put(b as usize, outer(arm, force));
        }
        for (b, arm, force) in self.cavity_forces().chain(self.bond_forces()) {
            put(b, outer(arm, force));
        }
    }
}
