//! Found contacts, as they are read.

use riprap_geom::Vec3;

use crate::kernel::PairKey;
use crate::kernel::cells::{CellPatch, Spot};
use crate::query::view::View;
use crate::state::deformable::DeformableMemory;
use crate::state::found::ContactPatch;

/// A found contact that touches.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contact {
    /// The blocks; the smaller number first.
    pub ends: [u32; 2],
    /// From the second block to the image of it that touches the first, m: zero but across the ends of a periodic model.
    pub shift: Vec3,
    /// Force of the first on the second without dashpots, N.
    pub force: Vec3,
    /// Its point from the centroids of both, m.
    pub arms: [Vec3; 2],
    /// Unit normal from the first to the second; zero where the surface has no one normal.
    pub normal: Vec3,
    /// Area across the normal, m².
    pub area: f64,
    /// How far the blocks lie in each other, m.
    pub depth: f64,
    /// Whether it slides.
    pub sliding: bool,
}

impl Contact {
    /// Where a place of the second block (m) is as the first one meets it.
    #[must_use]
    pub fn placed(&self, at: Vec3) -> Vec3 {
        if self.shift == Vec3::ZERO { at } else { at + self.shift }
    }

    /// The same, told from the other block.
    fn turned(self) -> Self {
        let Self { ends: [i, j], arms: [a, b], .. } = self;
        Self {
            ends: [j, i],
            shift: -self.shift,
            force: -self.force,
            arms: [b, a],
            normal: -self.normal,
            ..self
        }
    }
}

impl View<'_> {
    /// The found contacts that touch: of rigid blocks in their order, those of glued parts for each two pieces; of rigid blocks on terrain, one
    /// a facet and piece; then of deformable ones, on terrain one a facet.
    pub fn contacts(&self) -> impl Iterator<Item = Contact> + '_ {
        let desk = &self.scratch.deformable;
        let pairs = self.world.found.deformable.pairs.iter();
        let pairs = pairs.zip(desk.slots.iter().zip(&desk.constants));
        let touching = pairs.filter(|(_, (slot, _))| slot.touching);
        let deformable = touching.flat_map(move |(pair, (slot, constants))| {
            let centres = constants.members.map(|m| desk.stars[m as usize].origin);
            let contacts = slot.patches.iter().zip(&pair.contacts);
            contacts.map(move |(patch, contact)| {
                let spots = &slot.spots[patch.spots.clone()];
                self.of_deformable(pair.ends, (patch, spots), &contact.memory, centres)
            })
        });
        self.of_rigid().chain(deformable)
    }

    /// Of rigid blocks, with each other and with terrain.
    fn of_rigid(&self) -> impl Iterator<Item = Contact> + '_ {
        let pairs = self.world.found.pairs.iter().zip(&self.scratch.desk.slots);
        let touching = pairs.filter(|(_, slot)| slot.touching);
        touching.flat_map(|(pair, _)| {
            pair.patches.iter().map(|patch| {
                let contact = self.contact(&pair.key(), patch);
                // Terrain comes first, whatever its number.
                if pair.ends[0] < pair.ends[1] { contact } else { contact.turned() }
            })
        })
    }

    fn contact(&self, key: &PairKey, patch: &ContactPatch) -> Contact {
        let &PairKey { ends, image } = key;
        let shift = image.shift(&self.world.setup.periodic);
        let &ContactPatch { ref memory, force, area, depth, .. } = patch;
        // A touch without a normal acts where the pressure does; its blocks hardly overlap.
        let arms = if memory.normal == Vec3::ZERO { self.midway(key) } else { memory.arms };
        let (normal, sliding) = (memory.normal, memory.sliding);
        Contact { ends, shift, force, arms, normal, area, depth, sliding }
    }

    /// A contact of which one block at least deforms: its point is the centre of the pressure. `centres`: where the tetrahedra of each block
    /// meet, from where spots are counted.
    fn of_deformable(
        &self,
        ends: [u32; 2],
        (patch, spots): (&CellPatch, &[Spot]),
        memory: &DeformableMemory,
        centres: [Vec3; 2],
    ) -> Contact {
        let pressure: f64 = spots.iter().map(|spot| spot.pressure).sum();
        let arms = if pressure > 0.0 {
            [0, 1].map(|side| {
                let parts = spots.iter().map(|s| s.pressure * s.arms[side]);
                let from_centre = parts.sum::<Vec3>() / pressure;
                from_centre + centres[side] - self.position(ends[side] as usize)
            })
        } else {
            self.midway(&PairKey::plain(ends))
        };
        Contact {
            ends,
            shift: Vec3::ZERO,
            force: patch.force,
            arms,
            normal: memory.normal,
            area: patch.area,
            depth: patch.depth,
            sliding: memory.sliding,
        }
    }

    /// From the centroids of two blocks to the middle between them, m.
    fn midway(&self, key: &PairKey) -> [Vec3; 2] {
        let periods = &self.world.setup.periodic;
        let [a, b] =
            [0, 1].map(|side| key.place(side, self.position(key.ends[side] as usize), periods));
        [0.5 * (b - a), 0.5 * (a - b)]
    }

    /// Found contacts of block `b`, with the force on it, N.
    pub fn contacts_of(&self, b: usize) -> impl Iterator<Item = (Contact, Vec3)> + '_ {
        let b = b as u32;
        self.contacts().flat_map(move |contact| {
            let [i, j] = contact.ends;
            // A block that meets its own image feels both sides.
            let sides = [(j, contact.force), (i, -contact.force)].into_iter();
            sides.filter(move |(end, _)| *end == b).map(move |(_, force)| (contact, force))
        })
    }

    /// The found contact of two blocks, with the force of the second on the first, N. Of several between pieces the one that
    /// presses most, with the force and the area of all.
    #[must_use]
    pub fn contact_between(&self, first: u32, second: u32) -> Option<(Contact, Vec3)> {
        let found = self.contacts_of(first as usize);
        let found = found.filter(|(contact, _)| contact.ends.contains(&second));
        found.reduce(|(a, force), (b, other)| {
            let most = if other.length() > force.length() { b } else { a };
            let together = Contact {
                force: a.force + b.force,
                area: a.area + b.area,
                depth: a.depth.max(b.depth),
                sliding: a.sliding && b.sliding,
                ..most
            };
            (together, force + other)
        })
    }
}
