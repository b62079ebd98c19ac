//! State hashes: equal hashes mean equal bits of motion and contact memory.

use crate::Vec2;
use crate::planar::world::World;
use crate::spatial;

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

/// blake3 of the state of a spatial model.
#[must_use]
pub fn spatial(world: &spatial::world::World) -> String {
    let mut hasher = blake3::Hasher::new();
    let mut put = |x: f64| {
        hasher.update(&x.to_bits().to_le_bytes());
    };
    put(world.time);
    put(world.step as f64);
    let bodies = &world.bodies;
    for list in bodies.pose.iter().chain(&bodies.rate) {
        list.iter().for_each(|&x| put(x));
    }
    for (alive, turned) in world.alive.iter().zip(&world.turned) {
        put(f64::from(u8::from(*alive)));
        if let Some(t) = turned {
            t.attitude.to_array().into_iter().for_each(&mut put);
            t.momentum.to_array().into_iter().for_each(&mut put);
        }
    }
    let patches = &world.patches;
    for (ends, flags) in patches.ends.iter().zip(&patches.flags) {
        ends.iter().for_each(|&b| put(f64::from(b)));
        put(f64::from(*flags));
    }
    patches
        .slip
        .iter()
        .flatten()
        .flatten()
        .for_each(|&x| put(x));
    patches.lift.iter().flatten().for_each(|&x| put(x));
    patches.path.iter().flatten().for_each(|&x| put(x));
    for cavity in &world.cavities {
        for x in [cavity.volume, cavity.pressure, cavity.work, cavity.base] {
            put(x);
        }
    }
    for anchor in world.faces.iter().flat_map(|f| f.anchor) {
        anchor.to_array().into_iter().for_each(&mut put);
    }
    if let Some(deform) = &world.deform {
        let nodes = [&deform.nodes.moved, &deform.nodes.rate];
        nodes.into_iter().flatten().flatten().for_each(|&x| put(x));
        for m in &deform.memory {
            m.law.slip.iter().for_each(|&x| put(x));
            put(m.law.damage);
            put(f64::from(u8::from(m.state.is_broken())));
        }
    }
    hasher.finalize().to_hex().to_string()
}
