//! Forces of patches, piece by piece: the first pass of the gathering.
//!
//! Which kernel finds the forces of a patch, and every operation in it, depends on the patch alone (its class, its memory
//! and the motion of its blocks), never on the patches beside it in the packet:
//!
//! - no memory, normal to an axis, and certainly elastic: [`wide::springs`], all four points at once;
//! - else, normal to an axis, small rotations, and a law that [`wide::points`] knows: that, point by point;
//! - else: `single`, for any state.
//!
//! A packet runs each kernel for eight patches and each lane takes from it what is its own.

use riprap_geom::Vec3;

use riprap_core::cut;

use crate::exec::{Cut, Divide};
use crate::joint::patch;
use crate::joint::patch::{Poses, Resultant, State};
use crate::joint::wide;
use crate::joint::wide::{Class, Places, Response, Shares, Targets};
use crate::lanes::{Lanes, Width, fetch};
use crate::setup::InterfaceLaw;
use crate::state::patches::{PatchClass, flag};
use crate::state::scratch::Lost;
use crate::state::sums::Part;
use crate::state::tiles::{GROUP, Packet, Tile, Tiles};
use crate::state::wide::Wide;

/// What all tiles read.
#[derive(Clone, Copy)]
pub(crate) struct Shared<'a> {
    /// Poses of the blocks.
    pub poses: Poses<'a>,
    /// Laws.
    pub interfaces: &'a [InterfaceLaw],
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
    pub(crate) fn wide_of(&self, packet: &Packet, lane: usize) -> &Wide {
        let count = usize::from(packet.count);
        let lane = if lane < count { lane } else { 0 };
        &self.wide[self.class[packet.first as usize + lane] as usize]
    }
}

/// Lists of patches that tiles own parts of.
pub(crate) struct Memory<'a> {
    /// See [`crate::state::patches::Patches`].
    pub flags: &'a mut [u16],
    /// See [`crate::state::patches::Patches`].
    pub slip: &'a mut [[[f64; 4]; 2]],
    /// See [`crate::state::patches::Patches`].
    pub normal_offset: &'a mut [[f64; 4]],
    /// See [`crate::state::patches::Patches`].
    pub accumulated_slip: &'a mut [[f64; 4]],
    /// See [`crate::state::patches::Patches`].
    pub wear: &'a mut [[[f64; 4]; 2]],
}

// Memories that no patch of the model has are empty lists.
impl Cut for Memory<'_> {
    fn cut(self, at: usize) -> (Self, Self) {
        cut!(self, flags: at, slip: at, normal_offset: at, accumulated_slip: at, wear: at)
    }
}

impl Memory<'_> {
    /// Memory of patch number `at` of this part.
    pub(crate) fn state(&mut self, at: usize) -> State<'_> {
        State {
            flags: &mut self.flags[at],
            slip: self.slip.get_mut(at),
            normal_offset: self.normal_offset.get_mut(at),
            accumulated_slip: self.accumulated_slip.get_mut(at),
            wear: self.wear.get_mut(at),
        }
    }
}

/// Piece of work of the first pass.
pub(crate) struct First<'a> {
    /// How the model is cut.
    pub tiles: &'a [Tile],
    /// Memory of the patches.
    pub memory: Memory<'a>,
    /// Sums of the blocks: elastic, then dashpots (empty without damping).
    pub net: [Part<'a>; 2],
    /// Parts of the patches with slots for their blocks j, likewise.
    pub slots: [Part<'a>; 2],
    /// Losses of each group.
    pub lost: &'a mut [Lost],
}

impl Divide for First<'_> {
    fn divide(self, middle: usize) -> (Self, Self) {
        let [a, b] = [&self.tiles[0], &self.tiles[middle]];
        let blocks = b.blocks.start - a.blocks.start;
        cut!(
            self,
            tiles: middle,
            memory: b.patches.start - a.patches.start,
            net: blocks,
            slots: b.slots.start - a.slots.start,
            lost: blocks / GROUP,
        )
    }
}

/// Does the patches of one tile.
pub(crate) fn tile(shared: &Shared, work: First) {
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
    work.lost.fill(Lost::default());
    let all = &shared.tiles.packets[tile.packets.clone()];
    for (number, packet) in all.iter().enumerate() {
        if let Some(later) = all.get(number + AHEAD) {
            fetch_for(shared, &work, later);
        }
        let at = packet.first as usize - tile.patches.start;
        let mut to = Targets {
            net: &mut work.net,
            slots: &mut work.slots,
            base: tile.blocks.start,
            slot: packet.slot().map(|s| s - tile.slots.start),
        };
        let places = Places::of(shared, packet);
        let class = Class::load(shared, packet);
        let flags = &work.memory.flags[at..at + usize::from(packet.count)];
        let rest = with_memory(packet, flags);
        if rest == 0 {
            let (elastic, doubtful) = wide::springs(shared, packet, &places, &class);
            if doubtful == 0 {
                // Most packets of most models: nothing of this may pass through memory.
                to.add(0, packet, &places, &Shares::new(&class, &elastic));
                if shared.damped {
                    let drag = wide::dashpots(shared, &places, &class);
                    to.add(1, packet, &places, &Shares::new(&class, &drag));
                }
                continue;
            }
        }
        // A packet never crosses from one group of blocks to the next, so its first patch says where losses go.
        let block = shared.ends[packet.first as usize][0] as usize;
        let lost = &mut work.lost[tile.group(block)];
        let memory = (&mut work.memory, at);
        mixed(shared, packet, (&places, &class), rest, memory, lost, &mut to);
    }
}

/// How many packets ahead data are asked for.
const AHEAD: usize = 8;

/// Asks for what a packet will read and write.
///
/// Groups are done from the last to the first, and their patches reach far away along the slower axes of a lattice: too many
/// places at once for the machine to see where they go on. A lattice of 262,144 blocks takes 15 to 20 % less time with this.
#[inline(always)]
fn fetch_for(shared: &Shared, work: &First, packet: &Packet) {
    let (first, tile) = (packet.first as usize, &work.tiles[0]);
    let (j, at) = (shared.ends[first][1] as usize, first - tile.patches.start);
    let bodies = shared.poses.bodies;
    for list in &bodies.displacement {
        fetch(list, j);
    }
    if packet.slot().is_none() {
        for list in &work.net[0].0 {
            fetch(list, j - tile.blocks.start);
        }
    }
    // With a memory comes the law, which looks at velocities.
    if work.memory.flags[at] != 0 {
        for list in &bodies.velocity {
            fetch(list, j);
        }
        for lane in 0..usize::from(packet.count) {
            fetch(work.memory.slip, at + lane);
        }
    }
}

/// Bits of the patches of a packet that remember something or are not normal to an axis.
#[inline(always)]
fn with_memory(packet: &Packet, flags: &[u16]) -> u8 {
    if packet.axis == 3 {
        return packet.all();
    }
    let mut bits = 0;
    for (lane, flags) in flags.iter().enumerate() {
        bits |= u8::from(*flags != 0) << lane;
    }
    bits
}

/// A packet of which some patches are not certainly elastic: those of `rest`, which remember something, and perhaps others.
#[inline(always)]
fn mixed(
    shared: &Shared,
    packet: &Packet,
    (places, class): (&Places, &Class),
    mut rest: u8,
    (memory, at): (&mut Memory, usize),
    lost: &mut Lost,
    to: &mut Targets,
) {
    let mut elastic = Response::default();
    if rest != packet.all() {
        let (springs, doubtful) = wide::springs(shared, packet, places, class);
        rest |= doubtful;
        elastic.0[0] = springs;
        if shared.damped {
            elastic.0[1] = wide::dashpots(shared, places, class);
        }
    }
    let mut chosen = 0;
    // `points` always asks the law; where memory must stay as it is, `single` reads what it says.
    if packet.axis < 3 && shared.elapsed.is_some() {
        chosen = rest & plain(shared, packet, &memory.flags[at..]);
    }
    let (mut answer, mut gone) = (Response::default(), [Lanes::default(); 2]);
    if chosen != 0 {
        let memory = (&mut *memory, at);
        (answer, gone) = wide::points(shared, packet, chosen, memory, (places, class));
    }
    if chosen == packet.all() {
        to.add(0, packet, places, &Shares::new(class, &answer.0[0]));
        if shared.damped {
            to.add(1, packet, places, &Shares::new(class, &answer.0[1]));
        }
        book(lost, packet, gone);
        return;
    }
    let mut response = elastic;
    response.take(chosen, &answer);
    rest &= !chosen;
    let mut springs = Shares::new(class, &response.0[0]);
    let mut dashpots = Shares::new(class, &response.0[1]);
    let mut loss = gone;
    for lane in 0..usize::from(packet.count) {
        if rest & (1 << lane) != 0 {
            let state = memory.state(at + lane);
            let alone = single(shared, packet.first as usize + lane, state);
            springs.set(lane, &alone.resultants[0]);
            dashpots.set(lane, &alone.resultants[1]);
            loss[0].0[lane] = alone.lost.friction;
            loss[1].0[lane] = alone.lost.fracture;
        }
    }
    to.add(0, packet, places, &springs);
    if shared.damped {
        to.add(1, packet, places, &dashpots);
    }
    book(lost, packet, loss);
}

/// Books the losses of a packet patch after patch: how a group is cut into packets does not matter then.
#[inline(always)]
fn book(lost: &mut Lost, packet: &Packet, [friction, fracture]: [Lanes; 2]) {
    let mut sum = *lost;
    for lane in 0..usize::from(packet.count) {
        sum.friction += friction.0[lane];
        sum.fracture += fracture.0[lane];
    }
    *lost = sum;
}

/// Bits of the patches of a packet that [`wide::points`] can do.
#[inline(always)]
fn plain(shared: &Shared, packet: &Packet, flags: &[u16]) -> u8 {
    let mut bits = 0;
    for (lane, flags) in flags[..usize::from(packet.count)].iter().enumerate() {
        // `points` has the arithmetic of small rotations, without normal offsets.
        let usual = flags & (flag::FINITE | flag::OFFSET) == 0;
        bits |= u8::from(usual && shared.wide_of(packet, lane).plain) << lane;
    }
    bits
}

/// What one patch does by itself.
struct Alone {
    /// Of its springs and of its dashpots.
    resultants: [Resultant; 2],
    lost: Lost,
}

/// Patch `p` in any state.
#[inline(never)]
fn single(shared: &Shared, p: usize, mut state: State) -> Alone {
    let class = &shared.classes[shared.class[p] as usize];
    let joint = patch::joint(shared.interfaces, class);
    let finite = *state.flags & flag::FINITE != 0;
    let points = shared.poses.points(class, shared.ends[p], finite);
    let start = patch::start(class, shared.prestress.get(p));
    let (t, loss) = patch::respond(joint, class, &points, &start, shared.elapsed, &mut state);
    let mut resultants = [points.resultant(class, &t), Resultant::default()];
    if shared.damped {
        let beta = class.beta + shared.stiffness_damping;
        let t = patch::dashpots(joint, class, &points, beta, *state.flags);
        resultants[1] = points.resultant(class, &t);
    }
    Alone {
        resultants,
        lost: Lost { friction: class.area * loss.friction, fracture: class.area * loss.fracture },
    }
}
