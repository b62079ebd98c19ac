//! Forces of patches, tile by tile: the first pass of the gathering.

use riprap_geom::Vec3;

use super::lanes::Width;
use super::patch::{self, Poses, Resultant, State};
use super::setup::Interface;
use super::sums::Part;
use super::tiles::{Packet, Tile, Tiles};
use super::wide::{self, Targets, Wide};
use super::world::{PatchClass, flag};
use crate::exec::Divide;
use crate::ledger::Works;

/// What all tiles read.
#[derive(Clone, Copy)]
pub struct Shared<'a> {
    /// Poses of the blocks.
    pub poses: Poses<'a>,
    /// Laws.
    pub interfaces: &'a [Interface],
    /// Classes of patches.
    pub classes: &'a [PatchClass],
    /// Blocks of patches.
    pub ends: &'a [[u32; 2]],
    /// Class of each patch.
    pub class: &'a [u32],
    /// Traction at the start, or empty.
    pub prestress: &'a [Vec3],
    /// Pieces.
    pub tiles: &'a Tiles,
    /// Time moved since the laws were last applied, s; `None` leaves the memory of patches alone.
    pub elapsed: Option<f64>,
    /// Stiffness-proportional damping of the phase, s.
    pub stiffness_damping: f64,
    /// Whether there are dashpots.
    pub damped: bool,
    /// Whether a law has a strength.
    pub strong: bool,
    /// Constants of the classes for the wide kernel.
    pub wide: &'a [Wide],
    /// Instruction set.
    pub width: Width,
}

impl Shared<'_> {
    /// Constants of the class of a lane of a packet; lanes beyond its count repeat the first.
    #[inline(always)]
    #[must_use]
    pub fn wide_of(&self, packet: &Packet, lane: usize) -> &Wide {
        let count = usize::from(packet.count);
        let lane = if lane < count { lane } else { 0 };
        &self.wide[self.class[packet.first as usize + lane] as usize]
    }
}

/// Lists of patches that tiles own parts of.
pub struct Memory<'a> {
    /// See [`super::world::Patches`].
    pub flags: &'a mut [u16],
    /// See [`super::world::Patches`].
    pub slip: &'a mut [[[f64; 4]; 2]],
    /// See [`super::world::Patches`].
    pub lift: &'a mut [[f64; 4]],
    /// See [`super::world::Patches`].
    pub path: &'a mut [[f64; 4]],
}

fn cut<T>(list: &mut [T], at: usize) -> (&mut [T], &mut [T]) {
    let at = at.min(list.len());
    list.split_at_mut(at)
}

impl<'a> Memory<'a> {
    fn split(self, at: usize) -> (Self, Self) {
        let (flags, slip) = (cut(self.flags, at), cut(self.slip, at));
        let (lift, path) = (cut(self.lift, at), cut(self.path, at));
        let part = |flags, slip, lift, path| Self {
            flags,
            slip,
            lift,
            path,
        };
        (
            part(flags.0, slip.0, lift.0, path.0),
            part(flags.1, slip.1, lift.1, path.1),
        )
    }

    /// Memory of patch number `at` of this part.
    pub fn state(&mut self, at: usize) -> State<'_> {
        State {
            flags: &mut self.flags[at],
            slip: self.slip.get_mut(at),
            lift: self.lift.get_mut(at),
            path: self.path.get_mut(at),
        }
    }
}

/// Piece of work of the first pass.
pub struct First<'a> {
    /// How the model is cut.
    pub tiles: &'a [Tile],
    /// Memory of the patches.
    pub memory: Memory<'a>,
    /// Sums of the blocks: elastic, then dashpots (empty without damping).
    pub net: [Part<'a>; 2],
    /// Parts for blocks of other tiles, likewise.
    pub slots: [Part<'a>; 2],
    /// Works of each tile.
    pub works: &'a mut [Works],
}

impl Divide for First<'_> {
    fn divide(self, middle: usize) -> (Self, Self) {
        let (a, b) = self.tiles.split_at(middle);
        let patches = b[0].patches.start - a[0].patches.start;
        let blocks = b[0].blocks.start - a[0].blocks.start;
        let slots = b[0].slots.start - a[0].slots.start;
        let memory = self.memory.split(patches);
        let [n0, n1] = self.net.map(|part| part.split(blocks));
        let [s0, s1] = self.slots.map(|part| part.split(slots));
        let works = self.works.split_at_mut(middle);
        (
            Self {
                tiles: a,
                memory: memory.0,
                net: [n0.0, n1.0],
                slots: [s0.0, s1.0],
                works: works.0,
            },
            Self {
                tiles: b,
                memory: memory.1,
                net: [n0.1, n1.1],
                slots: [s0.1, s1.1],
                works: works.1,
            },
        )
    }
}

/// Does the patches of one tile.
pub fn tile(shared: &Shared, work: First) {
    shared.width.run(
        #[inline(always)]
        || packets(shared, work),
    );
}

#[inline(always)]
fn packets(shared: &Shared, mut work: First) {
    let tile = &work.tiles[0];
    for part in &mut work.net {
        part.clear();
    }
    let works = &mut work.works[0];
    *works = Works::default();
    for (k, packet) in shared.tiles.packets[tile.packets.clone()]
        .iter()
        .enumerate()
    {
        let first = packet.first as usize - tile.patches.start;
        let crosses = tile.packets.start + k >= tile.crossing_packet;
        let slot = crosses.then(|| packet.first as usize - tile.crossing);
        let all = u8::MAX >> (8 - packet.count);
        // Patches with a history or with finite rotations, and those of any direction, one by one.
        let mut one_by_one = 0;
        for (lane, flags) in work.memory.flags[first..first + usize::from(packet.count)]
            .iter()
            .enumerate()
        {
            one_by_one |= u8::from(*flags != 0) << lane;
        }
        let mut to = Targets {
            net: &mut work.net,
            slots: &mut work.slots,
            base: tile.blocks.start,
            slot,
        };
        if packet.axis == 3 {
            one_by_one = all;
        }
        if one_by_one == all {
            to.clear_slots(usize::from(packet.count));
        } else {
            one_by_one = wide::packet(shared, shared.wide, packet, one_by_one, &mut to);
        }
        if packet.axis < 3 && shared.elapsed.is_some() {
            let chosen = one_by_one & plain(shared, packet, &work.memory.flags[first..]);
            if chosen.count_ones() > 1 {
                let memory = &mut work.memory;
                wide::points(shared, packet, chosen, memory, first, works, &mut to);
                one_by_one &= !chosen;
            }
        }
        for lane in 0..usize::from(packet.count) {
            if one_by_one & (1 << lane) == 0 {
                continue;
            }
            let p = packet.first as usize + lane;
            let state = work.memory.state(first + lane);
            single(shared, p, state, works, &mut to, lane);
        }
    }
}

/// Bits of the patches of a packet that [`wide::points`] can do.
#[inline(always)]
fn plain(shared: &Shared, packet: &Packet, flags: &[u16]) -> u8 {
    let mut bits = 0;
    for (lane, flags) in flags[..usize::from(packet.count)].iter().enumerate() {
        let usual = flags & (flag::FINITE | flag::OFFSET) == 0;
        bits |= u8::from(usual && shared.wide_of(packet, lane).plain) << lane;
    }
    bits
}

/// Patch `p`, number `lane` of its packet, by itself.
#[inline(never)]
fn single(
    shared: &Shared,
    p: usize,
    state: State,
    works: &mut Works,
    to: &mut Targets,
    lane: usize,
) {
    let (elastic, dashpot) = one(shared, p, state, works);
    let [i, j] = shared.ends[p].map(|b| (b as usize).wrapping_sub(to.base));
    for (kind, r) in [Some(elastic), dashpot].into_iter().flatten().enumerate() {
        to.net[kind].add(i, r.force, r.moments[0]);
        match to.slot {
            Some(slot) => to.slots[kind].add(slot + lane, -r.force, r.moments[1]),
            None => to.net[kind].add(j, -r.force, r.moments[1]),
        }
    }
}

/// Elastic resultant and, with damping, that of the dashpots of patch `p`.
fn one(
    shared: &Shared,
    p: usize,
    mut state: State,
    works: &mut Works,
) -> (Resultant, Option<Resultant>) {
    let class = &shared.classes[shared.class[p] as usize];
    let joint = patch::joint(shared.interfaces, class);
    let finite = *state.flags & flag::FINITE != 0;
    let points = shared.poses.points(class, shared.ends[p], finite);
    let start = patch::start(class, shared.prestress.get(p));
    let (t, loss) = patch::respond(joint, class, &points, &start, shared.elapsed, &mut state);
    works.friction += class.area * loss.friction;
    works.fracture += class.area * loss.fracture;
    let beta = class.beta + shared.stiffness_damping;
    let dashpot = shared.damped.then(|| {
        let t = patch::dashpots(joint, class, &points, beta, *state.flags);
        points.resultant(class, &t)
    });
    (points.resultant(class, &t), dashpot)
}
