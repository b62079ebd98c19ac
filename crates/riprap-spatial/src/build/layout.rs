//! Lays out what a step works with: pieces of the model, constants of classes, room for sums.

use std::sync::OnceLock;

use crate::accounts::Entries;
use crate::deform::relax;
use crate::dynamics::damping::Damping;
use crate::exec::Exec;
use crate::flow::Desk;
use crate::kernel::cells::TetContactScratch;
use crate::lanes::Width;
use crate::ledger::Works;
use crate::profile::Profile;
use crate::push::bolts;
use crate::setup::JointLaw;
use crate::state::contact_scratch::ContactScratch;
use crate::state::push::Pushes;
use crate::state::scratch::{ImplicitDesk, Lost, Partial, Scratch};
use crate::state::share::Share;
use crate::state::sums::Sums;
use crate::state::tiles::{Cut, Tiles};
use crate::state::wide::Wide;
use crate::state::workspace::{BlockClass, Workspace};
use crate::state::world::{PatchClass, World};

impl Scratch {
    /// Scratch data for a world, as new or as read from a checkpoint.
    #[must_use]
    pub fn new(world: &mut World, exec: Exec) -> Self {
        let mut scratch = Self {
            exec,
            profile: Profile::default(),
            tiles: Tiles::default(),
            share: None,
            unread: false,
            net: Sums::default(),
            drag: Sums::default(),
            pushes: Pushes::default(),
            flow: Desk::default(),
            coming_dt: 0.0,
            damping: Damping::default(),
            rebuilds: 0,
            deform: None,
            implicit: ImplicitDesk::default(),
            desk: ContactScratch::default(),
            deformable: TetContactScratch::default(),
            inradii: Vec::new(),
            bolts: Vec::new(),
            slots: [Sums::default(), Sums::default()],
            wide: Vec::new(),
            strong: false,
            width: Width::detect(),
            departure: Works::default(),
            entries: Entries::default(),
            face_entries: Vec::new(),
            cut: None,
            lost: Vec::new(),
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

    /// Lays out anew what depends on which patches there are, and on faces: some have come or gone (the lists are in order already) and nothing
    /// else has changed. Bits are those of [`Scratch::invalidate`]. Sums, laws of old classes and deformable blocks stay, and so do the pushes of a step under way.
    pub(crate) fn relay_patches(&mut self, world: &World) {
        let cut = self.cut_of(world.alive.len());
        self.cut_tiles(world, cut);
        let drag_slots = if self.drag.is_empty() { 0 } else { self.tiles.slots };
        self.slots = [self.tiles.slots, drag_slots].map(Sums::zeros);
        let interfaces = &world.setup.interfaces;
        let new = &world.classes[self.wide.len().min(world.classes.len())..];
        for class in new {
            let joint = &interfaces[class.row as usize].joint;
            self.wide.push(Wide::new(class, joint));
            self.strong |= joint.strength.is_some() || !joint.is_plain();
        }
        self.desk.ready = false;
    }

    /// As [`Scratch::invalidate`] where deformable blocks of the `new` classes have been appended or some have gone, and no
    /// shape or material has changed.
    pub(crate) fn extend(&mut self, world: &mut World, new: impl Iterator<Item = BlockClass>) {
        world.fresh = true;
        let mut old = *self.deform.take().unwrap_or_default();
        old.classes.extend(new);
        self.rebuild(world, old.classes);
        if let Some(work) = &mut self.deform {
            work.alone = old.alone;
        }
    }

    /// Cuts the work in the given way from now on; results stay the same bits.
    pub fn set_cut(&mut self, world: &World, cut: Cut) {
        self.cut = Some(cut);
        self.rebuild(world, Vec::new());
    }

    /// How a model of so many blocks is cut: as it was asked for, or as suits the threads.
    fn cut_of(&self, blocks: usize) -> Cut {
        let workers = self.exec.workers();
        self.cut.unwrap_or_else(|| Cut::of(blocks, workers))
    }

    fn cut_tiles(&mut self, world: &World, cut: Cut) {
        self.tiles = Tiles::new(world, cut);
        self.share =
            self.exec.peers().map(|peers| Share::new(&self.tiles, peers, self.share.take()));
    }

    /// Lays everything out; `classes` of deformable blocks, the first ones, are taken over.
    fn rebuild(&mut self, world: &World, classes: Vec<BlockClass>) {
        let blocks = world.alive.len();
        self.cut_tiles(world, self.cut_of(blocks));
        let groups = self.tiles.groups();
        self.net = Sums::zeros(blocks);
        self.drag = Sums::default();
        self.pushes = Pushes::default();
        self.flow = Desk::default();
        self.slots = [Sums::zeros(self.tiles.slots), Sums::default()];
        let interfaces = &world.setup.interfaces;
        let joint = |c: &PatchClass| &interfaces[c.row as usize].joint;
        let patches = world.classes.iter();
        self.wide = patches.map(|c| Wide::new(c, joint(c))).collect();
        let strong = |joint: &JointLaw| joint.strength.is_some() || !joint.is_plain();
        self.strong = world.classes.iter().any(|c| strong(joint(c)));
        self.lost = vec![Lost::default(); groups];
        self.partial = vec![Partial::default(); groups];
        self.turning = true;
        self.bolts = Vec::new();
        let deform = world.deform.as_deref();
        self.deform =
            deform.map(|d| Box::new(Workspace::grown(&world.setup, d, classes, &self.exec)));
        if let Some(work) = self.deform.as_mut().filter(|w| !w.fictitious.is_empty()) {
            relax::add(&mut work.fictitious, &bolts::stiffness::row_sums(world));
        }
        self.inradii.resize_with(world.solids.len(), OnceLock::default);
        self.rebuilds += 1;
    }

    /// Makes room for the sums of dashpots when there are any.
    pub(crate) fn need_drag(&mut self, world: &World, stiffness_damping: f64) {
        let damped = stiffness_damping > 0.0
            || self.desk.damped
            || world.classes.iter().any(|c| c.beta > 0.0);
        if damped == self.drag.is_empty() {
            let (n, slots) = if damped { (world.alive.len(), self.tiles.slots) } else { (0, 0) };
            self.drag = Sums::zeros(n);
            self.slots[1] = Sums::zeros(slots);
        }
    }
}
