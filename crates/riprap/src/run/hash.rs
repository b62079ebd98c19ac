//! State hashes: equal hashes mean equal bits of motion and contact memory.

use crate::Vec2;
use crate::planar::world::World;

/// blake3 of the state of a planar model.
#[must_use]
pub fn planar(world: &World) -> String {
    let mut hasher = blake3::Hasher::new();
    let mut put = |x: f64| {
        hasher.update(&x.to_bits().to_le_bytes());
    };
    put(world.time);
    put(world.step as f64);
    for (b, body) in world.bodies.iter().enumerate() {
        let alive = f64::from(u8::from(world.alive[b]));
        let Vec2 { x, y } = body.position;
        for v in [
            alive,
            x,
            y,
            body.velocity.x,
            body.velocity.y,
            body.angle,
            body.spin,
        ] {
            put(v);
        }
    }
    let pairs = world.pairs.iter().map(|p| (p.i, p.j, &p.contact));
    let general = world
        .general
        .iter()
        .flat_map(|g| g.regions.iter().map(move |r| (g.i, g.j, &r.contact)));
    for (i, j, c) in pairs.chain(general).filter(|(_, _, c)| c.touches()) {
        for v in [f64::from(i), f64::from(j), c.shear, c.offset] {
            put(v);
        }
    }
    for bond in &world.bonds {
        for p in &bond.points {
            put(p.slip);
            put(f64::from(u8::from(p.failed)));
        }
    }
    hasher.finalize().to_hex().to_string()
}
