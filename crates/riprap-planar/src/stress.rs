//! Average stress of blocks, from what pushes and pulls at their outlines.

use riprap_geom::Vec2;

use super::loads;
use super::view::View;
use super::world::Contact;

impl View<'_> {
    /// Average stress xx, yy, xy of every block, Pa, tension positive: `(1/A) sum r (x) f` over found contacts, joint points, bolts, loads
    /// and faces under tractions, without dashpots, symmetrised. Weight and inertia act at the centroid and count for nothing, and
    /// so does the force of a support. Standing water is left out: where there is some, the stress is the effective one.
    #[must_use]
    pub fn stresses(&self) -> Vec<[f64; 3]> {
        let mut sums = vec![[0.0; 3]; self.world.alive.len()];
        self.pushes(&mut |b, arm, force| add(&mut sums[b], arm, force));
        for (b, sum) in sums.iter_mut().enumerate() {
            *sum = self.over_area(b, *sum);
        }
        sums
    }

    /// The same of one block.
    #[must_use]
    pub fn stress(&self, block: usize) -> [f64; 3] {
        let mut sum = [0.0; 3];
        self.pushes(&mut |b, arm, force| {
            if b == block {
                add(&mut sum, arm, force);
            }
        });
        self.over_area(block, sum)
    }

    fn over_area(&self, b: usize, sum: [f64; 3]) -> [f64; 3] {
        let area = self.scratch.shapes.mass[b] / self.world.setup.blocks[b].density;
        sum.map(|v| v / area)
    }

    /// Hands over block, arm from its centroid (m) and force (N/m) of all that acts on outlines. Of tractions that vary along a
    /// face a second pair tells the variation: along the face, without a resultant.
    fn pushes(&self, put: &mut dyn FnMut(usize, Vec2, Vec2)) {
        let world = self.world;
        let shift =
            |i: u32, j: u32| world.bodies[i as usize].position - world.bodies[j as usize].position;
        let carried = |c: &Contact| c.normal.force + c.tangential.force + c.handed.force;
        for (i, j, contact) in self.contacts() {
            let force = carried(contact);
            put(i as usize, contact.centre, force);
            put(j as usize, contact.centre + shift(i, j), -force);
        }
        for bond in world.bonds.iter().filter(|bond| bond.active) {
            let (i, j) = (&world.bodies[bond.i as usize], &world.bodies[bond.j as usize]);
            let normal = turned(bond.normal, 0.5 * (i.angle + j.angle));
            for point in &bond.points {
                // As in `bond::force`: at the middle of the two places of the point.
                let (on_i, on_j) = (turned(point.on_i, i.angle), turned(point.on_j, j.angle));
                let apart = on_j - on_i - (i.position - j.position);
                let arm = on_i + 0.5 * apart;
                let pull = point.weight * (point.sigma * normal + point.tau * normal.perp());
                put(bond.i as usize, arm, pull);
                put(bond.j as usize, arm + (i.position - j.position), -pull);
            }
        }
        for bolt in &world.bolts {
            bolt.pulls(&world.bodies, &mut |from, to, force| {
                put(from.block as usize, from.lever(&world.bodies), force);
                put(to.block as usize, to.lever(&world.bodies), -force);
            });
        }
        loads::pushes(world, &self.scratch.shapes, put);
    }
}

fn turned(v: Vec2, angle: f64) -> Vec2 {
    let (s, c) = libm::sincos(angle);
    Vec2::new(c * v.x - s * v.y, s * v.x + c * v.y)
}

fn add(sum: &mut [f64; 3], arm: Vec2, force: Vec2) {
    sum[0] += arm.x * force.x;
    sum[1] += arm.y * force.y;
    sum[2] += 0.5 * (arm.x * force.y + arm.y * force.x);
}
