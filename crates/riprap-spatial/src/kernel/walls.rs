//! Faces that other blocks cover: where they bound the surface of a pair.
//!
//! A face that lies wholly on faces of other blocks in place ([`crate::contact`] says which) is no surface: no depth is counted
//! from it, and it bounds the pieces where it lies. So the faces of two blocks beside each other in one plane are one face to what slides over
//! their joint, as those of one block would be. Each of the two blocks has its part of the pressure; normals, along which dashpots and friction
//! act, are those of the whole surface:
//!
//! ```text
//!      with depth from all faces              with the joint covered
//!   ----.        .-----------              ----------+-----------
//!        \      /                                    |
//!         \    /      what slides                   |        the plane goes on
//!          \  /       dips into it                  |
//!           ||                                      |
//! ```

use std::ops::Range;

use riprap_geom::Vec3;

use crate::kernel::frame::Frame;
use crate::kernel::piece::Polygon;
use crate::kernel::planes::origin;
use crate::kernel::sums::integrate;
use crate::kernel::surface::{Pair, Walker};

impl Walker {
    /// Finds the planes of covered faces that reach into the other block.
    pub(super) fn find_walls(&mut self, pair: &Pair) {
        let origin = origin(pair.bodies[0], pair.bodies[1]);
        for side in 0..2 {
            let (body, other) = (pair.bodies[side], pair.bodies[1 - side]);
            let count = body.shape.faces().min(u64::BITS as usize);
            for face in (0..count).filter(|face| pair.covered[side] >> face & 1 != 0) {
                let n = body.normals[face];
                let d = body.shape.offsets[face] + n.dot(body.position - origin);
                let reach = other.shape.radius + 2.0 * self.inflation;
                if n.dot(other.position - origin) + reach > d {
                    self.walls.push((n, d));
                    self.reach = body.shape.radius + other.shape.radius;
                }
            }
        }
    }

    /// Whether the centroid of a block is in the other one.
    pub(super) fn lies_inside(&self, pair: &Pair) -> bool {
        let (all, split) = (&self.all, self.all.split);
        let [a, b] = pair.bodies;
        let from = origin(a, b);
        let inside =
            |mut planes: Range<usize>, at: Vec3| planes.all(|k| all.normal(k).dot(at) <= all.d[k]);
        inside(0..split, b.position - from) || inside(split..all.len(), a.position - from)
    }

    /// Cuts a piece by the covered faces, after the whole of it has been counted and its neighbours are queued; whether anything is left.
    pub(super) fn bound(
        &mut self,
        frame: &Frame,
        piece: [u16; 2],
        share: f64,
        to: &mut Polygon,
    ) -> bool {
        let weight = share * integrate(to).depth;
        self.sums.whole += weight * frame.normal;
        self.sums.whole_weight += weight;
        self.queue_neighbours(piece, to);
        let Self { walls, cutter, .. } = self;
        walls.iter().all(|(n, d)| cutter.clip(frame, *n, *d, to))
    }
}

#[cfg(test)]
mod tests {
    use riprap_geom::Quat;
    use riprap_geom::polyhedron::Polyhedron;

    use super::*;
    use crate::kernel::kit::{Chance, Placed, all_faces};
    use crate::kernel::{Found, Pose, Shape, Sums};

    /// Outward along x on the left brick of a floor, on the right one, and neither.
    const SIDES: [f64; 2] = [1.0, -1.0];

    fn brick(half: Vec3) -> Shape {
        Shape::new(&Polyhedron::brick(Vec3::ZERO, half), Vec3::ZERO).unwrap()
    }

    /// What a block shares with a brick of which the face that looks along x times `side` is covered.
    fn shared(
        brick: (&Shape, f64),
        side: Option<f64>,
        block: (&Shape, Pose),
        walker: &mut Walker,
    ) -> (Found, Vec3) {
        let placed = Placed::new([brick.0, block.0], [Pose::at(brick.1 * Vec3::X), block.1]);
        let is_covered =
            |f: &u16| side.is_some_and(|side| brick.0.normals[usize::from(*f)].x * side > 0.5);
        let of_brick = all_faces(brick.0);
        let covered =
            of_brick.iter().filter(|f| is_covered(f)).fold(0, |bits, f| bits | 1_u64 << f);
        let listed: Vec<u16> = of_brick.iter().copied().filter(|f| !is_covered(f)).collect();
        let [a, b] = placed.bodies();
        let faces = [&listed[..], &all_faces(block.0)];
        let found = walker.find(&Pair {
            bodies: [&a, &b],
            faces,
            ties: true,
            hint: None,
            covered: [covered, 0],
            witnesses: &[],
        });
        (found, placed.origin())
    }

    /// Force, moment about the origin of space, weight and vector area.
    fn whole((found, origin): &(Found, Vec3)) -> Option<[Vec3; 4]> {
        let Found::Touching(Sums { force, moment, weight, vector_area, .. }) = found else {
            return None;
        };
        Some([*force, *moment + origin.cross(*force), *weight * Vec3::X, *vector_area])
    }

    #[test]
    fn two_bricks_of_a_floor_press_as_one() {
        let (one, half) = (brick(Vec3::new(1.0, 1.0, 0.5)), brick(Vec3::new(0.5, 1.0, 0.5)));
        let block = brick(Vec3::new(0.3, 0.2, 0.1));
        let mut walker = Walker::default();
        let mut chance = Chance::new(5);
        let (mut both, mut bare) = (0, 0.0_f64);
        for _ in 0..300 {
            let rotation = chance.rotation();
            let corner = |v: &Vec3| (rotation * *v).z;
            let low = block.vertices.iter().map(corner).fold(f64::INFINITY, f64::min);
            let z = 0.5 - low - chance.between(1e-6, 0.02);
            let at = Vec3::new(chance.between(-0.1, 0.1), chance.between(-0.3, 0.3), z);
            let pose = Pose { position: at, rotation };
            let expected = shared((&one, 0.0), None, (&block, pose), &mut walker);
            let Found::Touching(sums) = expected.0 else { panic!("{expected:?}") };
            let expected = whole(&expected).unwrap();
            let parts = [-0.5, 0.5].iter().zip(SIDES).filter_map(|(x, side)| {
                let part = shared((&half, *x), Some(side), (&block, pose), &mut walker);
                if let Found::Touching(part) = part.0 {
                    assert_eq!(part.unlabelled, 0);
                    // Parts press along the normal of the whole.
                    let normal = part.normal(0.0).unwrap();
                    assert!((normal - sums.normal(0.0).unwrap()).length() < 1e-9, "{normal}");
                }
                whole(&part)
            });
            let parts: Vec<[Vec3; 4]> = parts.collect();
            both += usize::from(parts.len() == 2);
            for k in 0..4 {
                let sum: Vec3 = parts.iter().map(|part| part[k]).sum();
                let size = expected[if k == 3 { 3 } else { 2 }].length();
                assert!((sum - expected[k]).length() < 1e-9 * size, "{k}: {sum} {}", expected[k]);
            }
            // With all faces of both bricks the joint is felt.
            let open =
                [-0.5, 0.5].map(|x| whole(&shared((&half, x), None, (&block, pose), &mut walker)));
            let weight: f64 = open.iter().flatten().map(|part| part[2].x).sum();
            bare = bare.max((weight - expected[2].x).abs() / expected[2].x);
        }
        assert!(both > 50, "{both}");
        assert!(bare > 0.05, "{bare}");
    }

    #[test]
    fn what_lies_in_a_brick_of_a_floor_as_a_whole_is_told() {
        let half = brick(Vec3::new(0.5, 1.0, 0.5));
        let block = brick(Vec3::splat(0.05));
        let mut walker = Walker::default();
        let pose =
            Pose { position: Vec3::new(-0.3, 0.0, 0.0), rotation: Quat::from_rotation_y(0.3) };
        let (found, _) = shared((&half, -0.5), Some(1.0), (&block, pose), &mut walker);
        assert!(matches!(found, Found::FullyPenetrated(_)), "{found:?}");
        // In the brick behind the joint it is not this one's.
        let beyond = Pose { position: Vec3::new(0.04, 0.0, 0.0), ..pose };
        let (found, _) = shared((&half, -0.5), Some(1.0), (&block, beyond), &mut walker);
        assert!(matches!(found, Found::Apart(_)), "{found:?}");
    }
}
