//! The state hash of a planar model.

use riprap_core::state_hash::StateHash;
use riprap_geom::Vec2;

use super::world::{Contact, Wear, World};

impl World {
    /// blake3 of motion and memory: equal hashes mean that two models go on alike, bit for bit.
    ///
    /// Contacts and joints come in the order of their blocks, however they are stored. The poses from which the candidates were found are
    /// not in it: what is not on the list touches nothing, and nothing else hangs on it.
    #[must_use]
    pub fn hash(&self) -> String {
        let mut hash = StateHash::default();
        hash.numbers(&[self.time, self.last_dt]);
        hash.count(self.step);
        for (b, body) in self.bodies.iter().enumerate() {
            hash.count(u64::from(self.alive[b]));
            let Vec2 { x, y } = body.position;
            let (u, v) = (body.velocity.x, body.velocity.y);
            hash.numbers(&[x, y, u, v, body.angle, body.spin]);
        }
        let pairs = self.pairs.iter().map(|p| ([p.i, p.j], 0, &p.contact));
        let general = self.general.iter().flat_map(|g| {
            let regions = g.regions.iter();
            regions.map(move |r| ([g.i, g.j], r.edges, &r.contact))
        });
        let mut contacts: Vec<_> = pairs.chain(general).filter(|c| c.2.touches()).collect();
        contacts.sort_by_key(|(blocks, edges, _)| (*blocks, *edges));
        hash.count(contacts.len() as u64);
        for (blocks, edges, contact) in contacts {
            blocks.iter().for_each(|b| hash.count(u64::from(*b)));
            hash.count(edges);
            remember(&mut hash, contact);
        }
        let mut bonds: Vec<_> = self.bonds.iter().collect();
        bonds.sort_by_key(|b| (b.i, b.j));
        hash.count(bonds.len() as u64);
        for bond in bonds {
            hash.pair([bond.i, bond.j]);
            hash.count(u64::from(bond.active) | u64::from(bond.torn) << 1);
            for point in &bond.points {
                hash.number(point.slip);
                hash.count(u64::from(point.failed));
                if point.wear != Wear::default() {
                    let wear = &point.wear;
                    hash.numbers(&[wear.accumulated_slip, wear.parted, wear.dilated]);
                    hash.count(u64::from(wear.open));
                }
            }
        }
        for bolt in &self.bolts {
            hash.count(u64::from(bolt.number));
            for list in bolt.chain.memory() {
                hash.numbers(list);
            }
            for dowel in &bolt.dowels {
                for v in [dowel.slip, dowel.force] {
                    hash.numbers(&[v.x, v.y]);
                }
            }
        }
        if let Some(found) = &self.seepage {
            for ends in &found.ends {
                hash.numbers(ends);
            }
        }
        hash.finish()
    }
}

fn remember(hash: &mut StateHash, contact: &Contact) {
    let handed = &contact.handed;
    hash.numbers(&[
        contact.shear,
        contact.springs,
        contact.offset,
        contact.offset_left,
        handed.force.x,
        handed.force.y,
        handed.moment_i,
        handed.moment_j,
    ]);
    hash.count(u64::from(contact.slipping));
}
