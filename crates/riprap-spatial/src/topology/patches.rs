//! What patches hand on when their blocks are split or taken out.

use riprap_geom::{Mat3, Vec3};

use crate::joint::patch;
use crate::joint::patch::Poses;
use crate::laws::face_joint::{SIGNS, Traction};
use crate::query::view::View;
use crate::state::interface::Origin;
use crate::state::patches::{PatchClass, flag};
use crate::state::world::World;

/// A patch whose block is about to be split.
#[derive(Clone, Debug)]
pub(super) struct Old {
    /// Blocks i and j.
    pub(super) ends: [u32; 2],
    /// Geometry and stiffness.
    class: PatchClass,
    /// Centre in the place of block i at the start, m.
    centre: Vec3,
    /// Tractions on i at the points (n, b, c), Pa.
    tractions: [Traction; 4],
    /// Tractions at zero displacement.
    start: [Traction; 4],
    flags: u16,
    normal_offset: [f64; 4],
    accumulated_slip: [f64; 4],
    wear: [[f64; 4]; 2],
    /// Openings of the points, m, where the law is not plain.
    openings: Option<[f64; 4]>,
    origin: Origin,
}

impl Old {
    pub(super) fn new(view: &View, p: usize) -> Self {
        let (world, list) = (view.world, &view.world.patches);
        let class = *view.patch_class(p);
        let ends = list.ends[p];
        Self {
            centre: world.reference[ends[0] as usize] + class.arms[0],
            tractions: view.patch_tractions(p),
            start: patch::start(&class, list.prestress.get(p)),
            flags: list.flags[p],
            normal_offset: list.normal_offset.get(p).copied().unwrap_or_default(),
            accumulated_slip: list.accumulated_slip.get(p).copied().unwrap_or_default(),
            wear: list.wear.get(p).copied().unwrap_or_default(),
            openings: patch::openings(
                patch::joint(&world.setup.interfaces, &class),
                &class,
                &view.patch_points(p),
                &patch::start(&class, list.prestress.get(p)),
                &view.patch_memory(p),
            ),
            origin: list.origin_of(p),
            ends,
            class,
        }
    }

    /// Unit normal from i to j.
    pub(super) fn normal(&self) -> Vec3 {
        self.class.frame[0]
    }

    /// Hands its state to patch `p`, which is a part of it.
    ///
    /// While all points hold, tractions are those of the bilinear field through the old points: force and moment
    /// stay exactly; where the axes of the part are others, so are the components. Where a point is broken or open,
    /// each new point takes state and traction of the nearest old point, so that none exceeds its limit.
    pub(super) fn hand_on(&self, world: &mut World, p: usize) {
        let class = world.classes[world.patches.class[p] as usize];
        let i = world.patches.ends[p][0] as usize;
        let shift = world.reference[i] + class.arms[0] - self.centre;
        let [_, b, c] = self.class.frame;
        let [_, along_b, along_c] = class.frame;
        let turned = along_b.dot(b).min(along_c.dot(c)) < 1.0 - 1e-9;
        let own = |[n, s, t]: Traction| match turned {
            true => [
                n,
                s * b.dot(along_b) + t * c.dot(along_b),
                s * b.dot(along_c) + t * c.dot(along_c),
            ],
            false => [n, s, t],
        };
        let whole = self.flags & (flag::BROKEN | flag::OPEN) == 0;
        let same = !turned
            && shift.length() < 1e-9 * self.class.half_spacing[0].max(self.class.half_spacing[1])
            && (class.area - self.class.area).abs() < 1e-9 * class.area;
        let mut flags = self.flags & flag::FINITE;
        let mut new = New::default();
        for q in 0..4 {
            let at = shift + patch::place(&class, q);
            let at =
                [at.dot(b) / self.class.half_spacing[0], at.dot(c) / self.class.half_spacing[1]];
            let nearest = if same { q } else { nearest(at) };
            // A law that is not plain is not linear: points go on from where the nearest one was.
            new.tractions[q] = own(if whole && !same && self.openings.is_none() {
                bilinear(&self.tractions, at)
            } else {
                self.tractions[nearest]
            });
            new.accumulated_slip[q] = self.accumulated_slip[nearest];
            new.wear = [0, 1].map(|k| {
                let mut wear = new.wear[k];
                wear[q] = self.wear[k][nearest];
                wear
            });
            if let Some(openings) = &self.openings {
                new.openings.get_or_insert([0.0; 4])[q] = openings[nearest];
            }
            for group in [flag::BROKEN, flag::OPEN, flag::SLIDING] {
                if self.flags & flag::of(group, nearest) != 0 {
                    flags |= flag::of(group, q);
                }
            }
            if self.flags & flag::of(flag::OPEN, nearest) != 0 {
                // An open point closes at the displacement at which it would have closed.
                let closes =
                    self.normal_offset[nearest] - self.start[nearest][0] / self.class.stiffness[0];
                new.normal_offset[q] = Some(closes);
            }
        }
        new.put(world, p, flags);
        world.patches.set_origin(p, self.origin);
    }
}

/// The point whose quarter holds a place given in units of the half_spacing.
fn nearest(at: [f64; 2]) -> usize {
    let side = |x: f64| if x < 0.0 { -1.0 } else { 1.0 };
    (0..4).find(|&q| SIGNS[0][q] == side(at[0]) && SIGNS[1][q] == side(at[1])).unwrap_or(0)
}

/// Bilinear field through the four points, at a place in units of the half_spacing.
fn bilinear(tractions: &[Traction; 4], at: [f64; 2]) -> Traction {
    let mut out = [0.0; 3];
    for (q, t) in tractions.iter().enumerate() {
        let weight = 0.25 * (1.0 + SIGNS[0][q] * at[0]) * (1.0 + SIGNS[1][q] * at[1]);
        for k in 0..3 {
            out[k] += weight * t[k];
        }
    }
    out
}

/// State of a new patch.
#[derive(Default)]
struct New {
    tractions: [Traction; 4],
    /// For open points: the opening displacement at which they close, m.
    normal_offset: [Option<f64>; 4],
    accumulated_slip: [f64; 4],
    wear: [[f64; 4]; 2],
    /// Openings of the points, m, where the law is not plain.
    openings: Option<[f64; 4]>,
}

impl New {
    /// Stores offsets so that the patch carries the tractions at the present displacements.
    fn put(&self, world: &mut World, p: usize, mut flags: u16) {
        let class = world.classes[world.patches.class[p] as usize];
        let poses = Poses { bodies: &world.bodies, turned: &world.turned };
        let finite = flags & flag::FINITE != 0;
        let at = poses.points(&class, world.patches.ends[p], finite).at;
        let start = patch::start(&class, world.patches.prestress.get(p));
        let [kn, ks] = class.stiffness;
        let (mut slip, mut normal_offset) = ([[0.0; 4]; 2], [0.0; 4]);
        let size = self.tractions.iter().flatten().fold(0.0_f64, |m, t| m.max(t.abs()));
        for q in 0..4 {
            let (t, s, u) = (&self.tractions[q], &start[q], &at[q]);
            normal_offset[q] = match self.normal_offset[q] {
                Some(closes) => closes + s[0] / kn,
                None => u[0] + (s[0] - t[0]) / kn,
            };
            for k in 0..2 {
                slip[k][q] = u[k + 1] + (s[k + 1] - t[k + 1]) / ks;
            }
        }
        let joint = patch::joint(&world.setup.interfaces, &class);
        if let Some(law) = joint.law(class.stiffness) {
            // Without a point that it goes on from: where its traction holds.
            let openings = (self.openings).unwrap_or(self.tractions.map(|t| law.opening(t[0])));
            let memory = patch::memories(
                flags,
                Some(&slip),
                None,
                Some(&self.accumulated_slip),
                Some(&self.wear),
            );
            // Without an offset points are this far open.
            let points = poses.points(&class, world.patches.ends[p], finite);
            if let Some(free) = patch::openings(joint, &class, &points, &start, &memory) {
                normal_offset = [0, 1, 2, 3].map(|q| free[q] - openings[q]);
            }
        }
        let list = &mut world.patches;
        let zero =
            size == 0.0 && normal_offset.iter().chain(slip.iter().flatten()).all(|x| *x == 0.0);
        if !zero {
            flags |= flag::OFFSET;
            list.need_slip();
            list.need_normal_offset();
            list.slip[p] = slip;
            list.normal_offset[p] = normal_offset;
        }
        if let Some(accumulated_slip) = list.accumulated_slip.get_mut(p) {
            *accumulated_slip = self.accumulated_slip;
        }
        if let Some(wear) = list.wear.get_mut(p) {
            *wear = self.wear;
        }
        list.flags[p] = flags;
    }
}

/// Gives patch `p` between two parts of one block the tractions of the block's average stress (frame of the start).
pub(super) fn inside(world: &mut World, p: usize, stress: &Mat3, finite: bool) {
    let class = world.classes[world.patches.class[p] as usize];
    let traction = *stress * class.frame[0];
    let t = class.frame.map(|e| e.dot(traction));
    let new = New { tractions: [t; 4], ..New::default() };
    new.put(world, p, if finite { flag::FINITE } else { 0 });
}
