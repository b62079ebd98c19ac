//! Pairs that the joints around them hold in place.
//!
//! In a lattice most pairs of blocks that are near each other share an edge or a corner only. While blocks that both of them
//! are joined to hold them, small kinematics hold between them too: they overlap by a small share of their size, in a rim, and what they
//! would exert there is nothing beside what their faces do. Such pairs are not looked at. Joints hold, broken or not, until they have slid
//! or opened by a thousandth of their side ([`mod@super::release`]), and a pair is looked at from the instant on at which no chain of
//! joints that hold is left. It starts without force then ([`super::rebuild`]).

use crate::contact::facing::facing;
use crate::kernel::{Image, PairKey, Pose, Shape};
use crate::state::patches::flag;
use crate::state::world::World;

/// Areas of faces on each other below this, over the largest one of the pair, are those of an edge.
const RIM: f64 = 1e-6;

/// A block as another one sees it: its number, and which image of it.
type Partner = (u32, Image);

/// Which blocks patches join.
pub(super) struct Joints {
    all: Partners,
    /// Those whose patches hold them in place; `None` where all do.
    in_place: Option<Partners>,
}

/// The partners of each block.
struct Partners {
    /// Where the partners of each block start in `partners`.
    first: Vec<u32>,
    /// Ascending for each block.
    partners: Vec<Partner>,
}

/// The pair of blocks that patch `p` joins, and whether they have changed sides in it. Across the ends of a periodic model its faces lie on each
/// other by their image.
pub(super) fn pair_of_patch(world: &World, p: usize) -> (PairKey, bool) {
    let (ends, periods) = (world.patches.ends[p], &world.setup.periodic);
    if *periods == [None; 3] {
        return PairKey::sorted(ends, Image::SELF);
    }
    let arms = world.classes[world.patches.class[p] as usize].arms;
    let [first, second] = [0, 1].map(|k| world.reference[ends[k] as usize] + arms[k]);
    PairKey::sorted(ends, Image::nearest(first - second, periods))
}

impl Partners {
    /// Those that the patches of `chosen` join.
    fn new(world: &World, chosen: impl Iterator<Item = usize>) -> Self {
        let pairs = chosen.map(|p| pair_of_patch(world, p).0);
        let both = pairs.flat_map(|PairKey { ends: [i, j], image }| {
            [(i, (j, image)), (j, (i, image.to(Image::SELF)))]
        });
        let mut both: Vec<(u32, Partner)> = both.collect();
        both.sort_unstable();
        both.dedup();
        let mut first = vec![0u32; world.alive.len() + 1];
        for (i, _) in &both {
            first[*i as usize + 1] += 1;
        }
        for b in 1..first.len() {
            first[b] += first[b - 1];
        }
        let partners = both.into_iter().map(|(_, partner)| partner).collect();
        Self { first, partners }
    }

    fn of(&self, b: u32) -> &[Partner] {
        &self.partners[self.first[b as usize] as usize..self.first[b as usize + 1] as usize]
    }

    /// The partners of an image of a block.
    fn of_image(&self, (b, image): Partner) -> impl Iterator<Item = Partner> + '_ {
        self.of(b).iter().map(move |(k, from)| (*k, image.plus(*from)))
    }

    /// Whether the two are joined by way of one block, as about an edge, or of two, as about a corner.
    fn chained(&self, key: &PairKey) -> bool {
        let [i, j] = key.ends;
        let of_second = || self.of_image((j, key.image));
        share(self.of(i).iter().copied(), of_second())
            || self.of(i).iter().any(|k| share(self.of_image(*k), of_second()))
    }
}

impl Joints {
    /// Those that are there now.
    pub(super) fn new(world: &World) -> Self {
        let all = || 0..world.patches.len();
        let in_place = |p: &usize| world.patches.flags[*p] & flag::DISPLACED == 0;
        let some = (!all().all(|p| in_place(&p))).then(|| all().filter(in_place));
        Self {
            all: Partners::new(world, all()),
            in_place: some.map(|some| Partners::new(world, some)),
        }
    }

    /// Whether a patch joins the two.
    pub(super) fn joins(&self, key: &PairKey) -> bool {
        let [i, j] = key.ends;
        self.all.of(i).binary_search(&(j, key.image)).is_ok()
    }

    /// Whether joints hold a pair that shares an edge or a corner at most: blocks that face each other across a gap can close it while
    /// their joints hold.
    pub(super) fn hold(&self, world: &World, shapes: &[Shape], key: &PairKey) -> bool {
        if !self.in_place.as_ref().unwrap_or(&self.all).chained(key) {
            return false;
        }
        // Faces at the start do not change: what was held has none that face each other, however its joints have changed since.
        if world.found.held.binary_search(key).is_ok() {
            return true;
        }
        let ends = key.ends.map(|b| b as usize);
        let pair = ends.map(|b| &shapes[world.solid[b] as usize]);
        let place =
            |side: usize| key.place(side, world.reference[ends[side]], &world.setup.periodic);
        let start = [0, 1].map(|side| Pose::at(place(side)));
        let largest = |s: &Shape| s.areas.iter().copied().fold(0.0, f64::max);
        let rim = RIM * largest(pair[0]).min(largest(pair[1]));
        let faces = pair.map(|shape| 0..shape.faces() as u16);
        facing(pair, start, 0.0, faces).is_none_or(|facing| facing.area <= rim)
    }
}

/// Whether two ascending lists have a number in common.
fn share(a: impl Iterator<Item = Partner>, b: impl Iterator<Item = Partner>) -> bool {
    let (mut a, mut b) = (a.peekable(), b.peekable());
    while let (Some(x), Some(y)) = (a.peek(), b.peek()) {
        match x.cmp(y) {
            std::cmp::Ordering::Less => a.next(),
            std::cmp::Ordering::Greater => b.next(),
            std::cmp::Ordering::Equal => return true,
        };
    }
    false
}

#[cfg(test)]
mod tests {
    use riprap_geom::Vec3;

    use crate::contact::release::release_pairs;
    use crate::contact::tests::{Run, above_floor, brick};
    use crate::kernel::PairKey;
    use crate::state::patches::flag;

    /// Four bricks of half a metre about an edge, in the air, joined without strength.
    fn four() -> Run {
        let at = |k: u32| [0.5 * f64::from(k % 2), 0.5 * f64::from(k / 2), 1.0];
        let blocks = (0..4).map(|k| brick(at(k), [0.5; 3])).collect();
        let mut setup = above_floor(blocks, 0.5, 0.0);
        setup.gravity = Vec3::ZERO;
        let mut run = Run::new(setup, 1, 1e-5);
        assert_eq!(run.world.patches.len(), 4);
        for flags in &mut run.world.patches.flags {
            *flags |= flag::BROKEN;
        }
        run
    }

    #[test]
    fn pairs_about_an_edge_are_no_candidates_while_joints_hold_them() {
        let mut run = four();
        run.until(1e-3);
        assert_eq!(run.world.found.held, [[1, 4], [2, 3]].map(PairKey::plain));
        assert!(run.world.found.pairs.is_empty());
    }

    /// The fourth is shifted along the second and away from the third, while their joints stay.
    #[test]
    fn joints_that_have_slid_and_opened_hold_no_pair() {
        for (share, held) in [(0.9, vec![[1, 4], [2, 3]]), (1.1, vec![[2, 3]])] {
            let mut run = four();
            run.world.bodies.displacement[0][4] = share * 1e-3 * 0.5;
            run.until(1e-3);
            assert_eq!(run.world.patches.len(), 4);
            let keys: Vec<PairKey> = held.into_iter().map(PairKey::plain).collect();
            assert_eq!(run.world.found.held, keys, "{share}");
            let slid = run.world.patches.flags.iter().filter(|f| **f & flag::DISPLACED != 0);
            assert_eq!(slid.count(), if share > 1.0 { 2 } else { 0 });
        }
    }

    #[test]
    fn a_pair_that_nothing_holds_any_more_starts_without_force() {
        let mut run = four();
        run.evaluate();
        // The fourth moves onto the edge of the first, and lets go of its neighbours.
        let depth = 1e-4;
        for axis in [0, 1] {
            run.world.bodies.displacement[axis][4] = -depth;
        }
        run.evaluate();
        release_pairs(&mut run.world, &mut run.scratch, &[[2, 4], [3, 4]].map(PairKey::plain));
        run.evaluate();
        assert_eq!(run.world.found.held, [PairKey::plain([2, 3])]);
        let pair = |run: &Run| {
            let mut pairs = run.world.found.pairs.iter();
            pairs.find(|pair| pair.ends == [1, 4]).cloned().unwrap()
        };
        let first = pair(&run);
        assert!(first.depth > 0.9 * depth && first.offset.is_some(), "{first:?}");
        assert!(first.force().length() < 1e-9, "{first:?}");
        // Only what comes on top presses.
        for axis in [0, 1] {
            run.world.bodies.displacement[axis][4] = -2.0 * depth;
        }
        run.evaluate();
        // A square prism of overlap of side s and length L: E = kn s³ L/3, and s grows by 1/root 2 of the way. The energy of the first
        // depth stays hidden, which leaves 1 - sqrt(1/8) of the force.
        let whole = 1e9 * 0.5 * 4.0 * depth * depth / 2.0_f64.sqrt();
        let wanted = (1.0 - 8.0_f64.powf(-0.5)) * whole;
        let force = pair(&run).force().length();
        assert!((force / wanted - 1.0).abs() < 1e-2, "{force} {wanted}");
    }

    #[test]
    fn blocks_that_face_each_other_across_a_gap_meet_while_a_floor_holds_both() {
        let blocks = [0.0, 0.501].map(|x| brick([x, 0.0, 0.0], [0.5; 3]));
        let mut run = Run::new(above_floor(blocks.into(), 0.5, 0.1), 1, 1e-4);
        for flags in &mut run.world.patches.flags {
            *flags |= flag::BROKEN;
        }
        assert_eq!(run.world.patches.len(), 2);
        run.until(1e-3);
        assert!(run.world.found.held.is_empty());
        assert_eq!(run.world.found.pairs[0].ends, [1, 2]);
    }
}
