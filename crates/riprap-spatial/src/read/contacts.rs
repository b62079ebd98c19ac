//! Found contacts, as they are read.

use riprap_geom::Vec3;

use crate::kernel::Memory;
use crate::kernel::cells::{ContactPatch, Spot};
use crate::query::view::View;
use crate::state::contact_scratch::Exerted;
use crate::state::deformable::DeformableMemory;

/// A found contact that touches.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contact {
    /// The blocks; the smaller number first.
    pub ends: [u32; 2],
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
    /// The same, told from the other block.
    fn turned(self) -> Self {
        let Self { ends: [i, j], arms: [a, b], .. } = self;
        Self { ends: [j, i], force: -self.force, arms: [b, a], normal: -self.normal, ..self }
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
        self.of_rigid().chain(self.on_facets()).chain(deformable)
    }

    /// Of rigid blocks on facets of terrain.
    fn on_facets(&self) -> impl Iterator<Item = Contact> + '_ {
        let grounds = &self.scratch.desk.terrain.blocks;
        let blocks = (0..).zip(&self.world.found.terrain);
        blocks.flat_map(move |(b, on): (u32, _)| {
            on.facets.iter().map(move |facet| {
                let ground = grounds[facet.terrain()];
                let (memory, size) = (&facet.memory, [facet.area, facet.depth]);
                let on_block = self.contact([ground, b], memory, facet.force, size);
                if ground < b { on_block } else { on_block.turned() }
            })
        })
    }

    fn of_rigid(&self) -> impl Iterator<Item = Contact> + '_ {
        let desk = &self.scratch.desk;
        let pairs = self.world.found.pairs.iter().zip(&desk.slots).enumerate();
        let pairs = pairs.filter(|(_, (_, slot))| slot.touching);
        pairs.flat_map(|(k, (pair, slot))| {
            let plain = pair.pieces.is_empty().then(|| {
                let sides = |by: &Exerted| by.elastic.force + by.spring.force;
                let force = desk.exerted(k).map_or(Vec3::ZERO, sides);
                self.contact(pair.ends, &pair.memory, force, [slot.area, pair.depth])
            });
            let pieces = pair.pieces.iter().map(|piece| {
                let size = [piece.area, piece.depth];
                self.contact(pair.ends, &piece.memory, piece.force, size)
            });
            plain.into_iter().chain(pieces)
        })
    }

    fn contact(
        &self,
        ends: [u32; 2],
        memory: &Memory,
        force: Vec3,
        [area, depth]: [f64; 2],
    ) -> Contact {
        // A touch without a normal acts where the pressure does; its blocks hardly overlap.
        let arms = if memory.normal == Vec3::ZERO { self.midway(ends) } else { memory.arms };
        Contact { ends, force, arms, normal: memory.normal, area, depth, sliding: memory.sliding }
    }

    /// A contact of which one block at least deforms: its point is the centre of the pressure. `centres`: where the tetrahedra of each block
    /// meet, from where spots are counted.
    fn of_deformable(
        &self,
        ends: [u32; 2],
        (patch, spots): (&ContactPatch, &[Spot]),
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
            self.midway(ends)
        };
        Contact {
            ends,
            force: patch.force,
            arms,
            normal: memory.normal,
            area: patch.area,
            depth: patch.depth,
            sliding: memory.sliding,
        }
    }

    /// From the centroids of two blocks to the middle between them, m.
    fn midway(&self, ends: [u32; 2]) -> [Vec3; 2] {
        let [a, b] = ends.map(|b| self.position(b as usize));
        [0.5 * (b - a), 0.5 * (a - b)]
    }

    /// Found contacts of block `b`, with the force on it, N.
    pub fn contacts_of(&self, b: usize) -> impl Iterator<Item = (Contact, Vec3)> + '_ {
        let b = b as u32;
        self.contacts().filter_map(move |contact| match contact.ends {
            [_, j] if j == b => Some((contact, contact.force)),
            [i, _] if i == b => Some((contact, -contact.force)),
            _ => None,
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
