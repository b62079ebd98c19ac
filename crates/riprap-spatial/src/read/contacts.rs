//! Found contacts, as they are read.

use riprap_geom::Vec3;

use crate::read::view::View;

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

impl View<'_> {
    /// The found contacts that touch, in the order of their blocks.
    pub fn contacts(&self) -> impl Iterator<Item = Contact> + '_ {
        let pairs = self.world.found.pairs.iter().zip(&self.scratch.desk.slots);
        pairs.filter(|(_, slot)| slot.touching).map(|(pair, slot)| {
            let memory = &pair.memory;
            // A touch without a normal acts where the pressure does; its blocks hardly overlap.
            let arms = if memory.normal == Vec3::ZERO {
                let [a, b] = pair.ends.map(|b| self.position(b as usize));
                [0.5 * (b - a), 0.5 * (a - b)]
            } else {
                memory.arms
            };
            Contact {
                ends: pair.ends,
                force: slot.elastic.force + slot.spring.force,
                arms,
                normal: memory.normal,
                area: slot.area,
                depth: pair.depth,
                sliding: memory.sliding,
            }
        })
    }

    /// Found contacts of block `b`, with the force on it, N.
    pub fn contacts_of(&self, b: usize) -> impl Iterator<Item = (Contact, Vec3)> + '_ {
        let b = b as u32;
        self.contacts()
            .filter_map(move |contact| match contact.ends {
                [_, j] if j == b => Some((contact, contact.force)),
                [i, _] if i == b => Some((contact, -contact.force)),
                _ => None,
            })
    }

    /// The found contact of two blocks, with the force of the second on the first, N.
    #[must_use]
    pub fn contact_between(&self, first: u32, second: u32) -> Option<(Contact, Vec3)> {
        let found = self.contacts_of(first as usize);
        let mut found = found.filter(|(contact, _)| contact.ends.contains(&second));
        found.next()
    }
}
