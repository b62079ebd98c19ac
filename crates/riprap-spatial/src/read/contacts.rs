//! Found contacts, as they are read.

use riprap_geom::Vec3;

use crate::found::Memory;
use crate::found::desk::Exerted;
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
    /// The found contacts that touch, in the order of their blocks; those of glued parts for each two pieces.
    pub fn contacts(&self) -> impl Iterator<Item = Contact> + '_ {
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
        let arms = if memory.normal == Vec3::ZERO {
            let [a, b] = ends.map(|b| self.position(b as usize));
            [0.5 * (b - a), 0.5 * (a - b)]
        } else {
            memory.arms
        };
        Contact {
            ends,
            force,
            arms,
            normal: memory.normal,
            area,
            depth,
            sliding: memory.sliding,
        }
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

    /// The found contact of two blocks, with the force of the second on the first, N. Of several between pieces the one that
    /// presses most, with the force and the area of all.
    #[must_use]
    pub fn contact_between(&self, first: u32, second: u32) -> Option<(Contact, Vec3)> {
        let found = self.contacts_of(first as usize);
        let found = found.filter(|(contact, _)| contact.ends.contains(&second));
        found.reduce(|(a, force), (b, other)| {
            let most = if other.length() > force.length() {
                b
            } else {
                a
            };
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
