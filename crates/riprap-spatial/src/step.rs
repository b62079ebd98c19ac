//! One step of the spatial engine.
//!
//! Leapfrog in two halves, so that a caller can look at the state in between, when positions and
//! forces belong to the same time: [`evaluate`] finds forces and the velocity changes they will
//! make, [`advance`] applies them and moves the blocks.

use riprap_geom::Vec3;

use super::boundary::Push;
use super::cavity;
use super::deform::workspace::Kind;
use super::deform::{self, Workspace};
use super::forces::{self, First, Memory, Shared};
use super::gather;
use super::integrate;
use super::kick::{self, Acting, Change, Kick};
use super::lanes::Width;
use super::loads;
use super::patch::{self, Poses};
use super::setup::Kinematics;
use super::sums::Sums;
use super::tiles::Tiles;
use super::wide::Wide;
use super::world::{PatchClass, Turned, World, flag};
use crate::exec::Exec;
use crate::ledger::Works;
use crate::profile::Profile;

/// Damping of a phase besides that of the contacts.
pub use crate::dynamics::damping::Damping;

/// Everything that can be dropped and rebuilt without changing a result.
#[derive(Debug)]
pub struct Scratch {
    /// Thread pool.
    pub exec: Exec,
    /// Stage timers.
    pub profile: Profile,
    /// Pieces of the model.
    pub tiles: Tiles,
    /// Sums of forces and moments on blocks, without damping and supports.
    pub net: Sums,
    /// Sums of contact dashpots; empty without any.
    pub drag: Sums,
    /// External loads; empty without any.
    pub applied: Vec<Push>,
    /// Pushes of cavities, whose work the cavities book themselves; empty without any.
    pub pushed: Vec<Push>,
    /// Length of the step that the kick was found for, s.
    pub coming_dt: f64,
    /// Damping that the kick was found with.
    pub damping: Damping,
    /// Number of times the patches were laid out; whoever keeps something derived from them looks here.
    pub rebuilds: u64,
    /// Of deformable blocks, where there are any.
    pub deform: Option<Box<Workspace>>,
    pub(super) slots: [Sums; 2],
    wide: Vec<Wide>,
    strong: bool,
    pub(super) width: Width,
    /// Works of the half step after the present time, booked by `advance`.
    pub(super) departure: Works,
    works: Vec<Works>,
    pub(super) partial: Vec<Partial>,
    /// Whether a block has turned beyond the bound of small kinematics.
    pub(super) turning: bool,
}

/// Sums of one tile.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Partial {
    pub(super) arrival: Works,
    pub(super) departure: Works,
    pub(super) bad: Option<u32>,
    pub(super) turning: bool,
}

/// A block whose state is no longer finite.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("the forces on block {block} are not finite")]
pub struct NonFinite {
    /// Index of the block.
    pub block: u32,
}

impl Scratch {
    /// Scratch data for a world, as new or as read from a checkpoint.
    #[must_use]
    pub fn new(world: &mut World, exec: Exec) -> Self {
        let mut scratch = Self {
            exec,
            profile: Profile::default(),
            tiles: Tiles::default(),
            net: Sums::default(),
            drag: Sums::default(),
            applied: Vec::new(),
            pushed: Vec::new(),
            coming_dt: 0.0,
            damping: Damping::default(),
            rebuilds: 0,
            deform: None,
            slots: [Sums::default(), Sums::default()],
            wide: Vec::new(),
            strong: false,
            width: Width::detect(),
            departure: Works::default(),
            works: Vec::new(),
            partial: Vec::new(),
            turning: true,
        };
        scratch.rebuild(world, Vec::new());
        scratch
    }

    /// Lays out everything anew: blocks or patches have come or gone, or laws have changed.
    pub fn invalidate(&mut self, world: &mut World) {
        world.fresh = true;
        self.rebuild(world, Vec::new());
    }

    /// As [`Scratch::invalidate`] where deformable blocks of the `new` kinds have been appended or some have gone, and no
    /// shape or material has changed.
    pub(super) fn extend(&mut self, world: &mut World, new: impl Iterator<Item = Kind>) {
        world.fresh = true;
        let mut old = *self.deform.take().unwrap_or_default();
        old.kinds.extend(new);
        self.rebuild(world, old.kinds);
        if let Some(work) = &mut self.deform {
            work.alone = old.alone;
        }
    }

    /// Uses no wider instructions than `width` from now on; results stay the same bits.
    pub fn limit_width(&mut self, width: Width) {
        self.width = Width::detect().min(width);
    }

    /// Lays everything out; `kinds` of deformable blocks, the first ones, are taken over.
    fn rebuild(&mut self, world: &World, kinds: Vec<Kind>) {
        self.tiles = Tiles::new(world);
        let (blocks, count) = (world.alive.len(), self.tiles.list.len());
        self.net = Sums::zeros(blocks);
        self.drag = Sums::default();
        self.pushed = Vec::new();
        self.slots = [Sums::zeros(self.tiles.slots), Sums::default()];
        let interfaces = &world.setup.interfaces;
        let joint = |c: &PatchClass| &interfaces[c.row as usize].joint;
        let classes = world.classes.iter();
        self.wide = classes.map(|c| Wide::new(c, joint(c))).collect();
        self.strong = world.classes.iter().any(|c| joint(c).strength.is_some());
        self.works = vec![Works::default(); count];
        self.partial = vec![Partial::default(); count];
        self.turning = true;
        let deform = world.deform.as_deref();
        self.deform =
            deform.map(|d| Box::new(Workspace::grown(&world.setup, d, kinds, &self.exec)));
        self.rebuilds += 1;
    }

    /// Makes room for the sums of dashpots when there are any.
    fn need_drag(&mut self, world: &World, stiffness_damping: f64) {
        let damped = stiffness_damping > 0.0 || world.classes.iter().any(|c| c.beta > 0.0);
        if damped == self.drag.is_empty() {
            let (n, slots) = if damped {
                (world.alive.len(), self.tiles.slots)
            } else {
                (0, 0)
            };
            self.drag = Sums::zeros(n);
            self.slots[1] = Sums::zeros(slots);
        }
    }

    /// Whether nothing but patches and gravity acts on blocks in rows.
    pub(super) fn plain(&self) -> bool {
        let d = &self.damping;
        d.mass == 0.0 && d.rotation.unwrap_or(0.0) == 0.0 && d.local == 0.0
    }

    /// Forces on block `b`.
    #[must_use]
    pub fn acting(&self, b: usize) -> Acting {
        let damped = !self.drag.is_empty();
        Acting {
            force: self.net.force(b),
            moment: self.net.moment(b),
            drag: if damped {
                self.drag.force(b)
            } else {
                Vec3::ZERO
            },
            drag_moment: if damped {
                self.drag.moment(b)
            } else {
                Vec3::ZERO
            },
        }
    }

    /// The coming kick.
    #[must_use]
    pub fn kick<'a>(&self, world: &'a World) -> Kick<'a> {
        Kick {
            solids: &world.solids,
            solid: &world.solid,
            motion: &world.motion,
            gravity: world.gravity,
            time: world.time,
            damping: self.damping,
            half: [0.5 * world.pending, 0.5 * self.coming_dt],
            span: 0.5 * (world.last_dt + self.coming_dt),
        }
    }

    /// Velocity change of block `b` in the coming kick.
    #[must_use]
    pub fn change(&self, world: &World, b: usize) -> Change {
        if world.alive[b] && !world.deforms(b) {
            self.kick(world)
                .change(b, &world.moving(b), &self.acting(b))
        } else {
            Change::default()
        }
    }
}

/// Finds all forces at the present positions and the velocity changes for a step of `dt`.
///
/// Calling it again without moving changes nothing.
///
/// # Errors
/// A block with forces that are not finite.
pub fn evaluate(
    world: &mut World,
    scratch: &mut Scratch,
    damping: &Damping,
    dt: f64,
) -> Result<(), NonFinite> {
    let mut profile = std::mem::take(&mut scratch.profile);
    scratch.damping = *damping;
    scratch.coming_dt = dt;
    profile.stage("loads", || {
        if !world.setup.loads.is_empty() {
            scratch.applied.resize(world.alive.len(), Push::default());
            loads::apply(world, &mut scratch.applied);
        }
    });
    profile.stage("kinematics", || change_over(world, scratch));
    profile.stage("cavities", || cavity::act(world, scratch, dt));
    if world.deform.is_some() {
        profile.stage("bonds", || deform::bonds::update(world, scratch));
    }
    profile.stage("patches", || patches(world, scratch));
    let mut result = profile.stage("gather", || gather::gather(world, scratch));
    if world.deform.is_some() {
        let nodes = profile.stage("nodes", || deform::step::evaluate(world, scratch, dt));
        result = result.and(nodes);
    }
    world.pending = 0.0;
    world.fresh = false;
    scratch.profile = profile;
    result
}

/// Applies the velocity changes and moves the blocks by `dt`.
pub fn advance(world: &mut World, scratch: &mut Scratch, dt: f64) {
    let mut profile = std::mem::take(&mut scratch.profile);
    profile.stage("integrate", || integrate::integrate(world, scratch, dt));
    let mut passed = dt;
    if world.deform.is_some() {
        passed = profile.stage("move nodes", || deform::step::advance(world, scratch, dt));
    }
    let departure = std::mem::take(&mut scratch.departure);
    world.works.add(&departure);
    world.works.note_peak();
    world.time += passed;
    world.step += 1;
    world.last_dt = dt;
    world.pending = dt;
    scratch.profile = profile;
}

/// First pass: forces of patches.
fn patches(world: &mut World, scratch: &mut Scratch) {
    scratch.need_drag(world, scratch.damping.stiffness);
    if world.step == 0 && world.fresh && !scratch.drag.is_empty() && scratch.strong {
        start_sliding(world, scratch.damping.stiffness);
    }
    let live = world.pending > 0.0 || world.fresh;
    let (list, tiles) = (&mut world.patches, &scratch.tiles);
    let shared = Shared {
        poses: Poses {
            bodies: &world.bodies,
            turned: &world.turned,
        },
        interfaces: &world.setup.interfaces,
        classes: &world.classes,
        ends: &list.ends,
        class: &list.class,
        prestress: &list.prestress,
        tiles,
        elapsed: live.then_some(world.pending),
        stiffness_damping: scratch.damping.stiffness,
        damped: !scratch.drag.is_empty(),
        strong: scratch.strong,
        wide: &scratch.wide,
        width: scratch.width,
    };
    let [slots, drag_slots] = &mut scratch.slots;
    let work = First {
        tiles: &tiles.list,
        memory: Memory {
            flags: &mut list.flags,
            slip: &mut list.slip,
            lift: &mut list.lift,
            path: &mut list.path,
        },
        net: [scratch.net.whole(), scratch.drag.whole()],
        slots: [slots.whole(), drag_slots.whole()],
        works: &mut scratch.works,
    };
    let count = tiles.list.len();
    scratch
        .exec
        .divided(work, count, |_, piece| forces::tile(&shared, piece));
    for works in &scratch.works {
        world.works.add(works);
    }
}

/// Marks the points that slide from the first instant.
fn start_sliding(world: &mut World, stiffness_damping: f64) {
    for p in 0..world.patches.len() {
        let list = &world.patches;
        let class = &world.classes[list.class[p] as usize];
        let joint = patch::joint(&world.setup.interfaces, class);
        let poses = Poses {
            bodies: &world.bodies,
            turned: &world.turned,
        };
        let points = poses.points(class, list.ends[p], list.flags[p] & flag::FINITE != 0);
        let start = patch::start(class, list.prestress.get(p));
        let beta = class.beta + stiffness_damping;
        let slide = patch::starts_sliding(joint, class, &points, &start, beta);
        world.patches.flags[p] |= slide;
    }
}

/// Lets blocks that have turned beyond the bound, and the patches they touch, use finite rotations from
/// now on; patches store an offset so that their tractions go on.
fn change_over(world: &mut World, scratch: &mut Scratch) {
    if !std::mem::take(&mut scratch.turning) {
        return;
    }
    let bound = match world.setup.kinematics {
        Kinematics::Small => return,
        Kinematics::Automatic { bound } => bound,
        Kinematics::Finite => -1.0,
    };
    let mut changed = false;
    for b in 0..world.alive.len() {
        let vector = world.bodies.rotation(b);
        if !world.alive[b] || world.turned[b].is_some() || vector.length() <= bound {
            continue;
        }
        let attitude = patch::rotation(vector);
        let inertia = patch::turned_inertia(&world.solid_of(b).inertia, attitude);
        world.turned[b] = Some(Box::new(Turned {
            attitude,
            momentum: inertia * world.bodies.spin(b),
        }));
        changed = true;
    }
    if !changed {
        return;
    }
    scratch.tiles.make_rows(world);
    for p in 0..world.patches.len() {
        let ends = world.patches.ends[p];
        let finite = ends.iter().any(|b| world.turned[*b as usize].is_some());
        if finite && world.patches.flags[p] & flag::FINITE == 0 {
            world.make_finite(p);
        }
    }
}

impl World {
    /// Motion of block `b` half a step ago.
    #[must_use]
    pub fn moving(&self, b: usize) -> kick::Moving<'_> {
        kick::Moving {
            velocity: self.bodies.velocity(b),
            spin: self.bodies.spin(b),
            turned: self.turned[b].as_deref(),
        }
    }

    /// Changes a patch over to finite rotations with the tractions it has.
    fn make_finite(&mut self, p: usize) {
        let (class, ends) = (
            self.classes[self.patches.class[p] as usize],
            self.patches.ends[p],
        );
        let poses = Poses {
            bodies: &self.bodies,
            turned: &self.turned,
        };
        let [before, after] = [false, true].map(|finite| poses.points(&class, ends, finite));
        let shifts: [[f64; 3]; 4] =
            std::array::from_fn(|q| [0, 1, 2].map(|k| after.at[q][k] - before.at[q][k]));
        self.patches.flags[p] |= flag::FINITE;
        if shifts.as_flattened().iter().all(|s| *s == 0.0) {
            return;
        }
        self.patches.need_slip();
        self.patches.need_lift();
        self.patches.flags[p] |= flag::OFFSET;
        for (q, shift) in shifts.iter().enumerate() {
            self.patches.lift[p][q] += shift[0];
            self.patches.slip[p][0][q] += shift[1];
            self.patches.slip[p][1][q] += shift[2];
        }
    }
}
