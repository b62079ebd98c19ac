//! What patches hand on when their blocks are split or taken out.

use riprap_geom::Mat3;

use crate::joint::patch::{self, Poses};
use crate::joint::reading::Reading;
use crate::laws::face_joint::{SIGNS, Traction};
use crate::state::patches::flag;
use crate::state::world::World;

/// Hands the state of patch `k` of a split block on to patch `p`, which is a part of it.
///
/// While all points hold, tractions are those of the bilinear field through the old points: force and moment
/// stay exactly; where the axes of the part are others, so are the components. Where a point is broken or open,
/// each new point takes state and traction of the nearest old point, so that none exceeds its limit.
pub(super) fn hand_on(world: &mut World, p: usize, k: usize) {
    let old = Reading { world, p: k };
    let (list, was) = (&world.patches, *old.class());
    let class = world.classes[world.patches.class[p] as usize];
    let (start, tractions, openings) = (old.start(), old.tractions(&old.points()), old.openings());
    let [i, i_was] =
        [world.patches.ends[p][0], list.ends[k][0]].map(|b| world.reference[b as usize]);
    let shift = i + class.arms[0] - (i_was + was.arms[0]);
    let ([_, b, c], [_, along_b, along_c]) = (was.frame, class.frame);
    let turned = along_b.dot(b).min(along_c.dot(c)) < 1.0 - 1e-9;
    let own = |[n, s, t]: Traction| match turned {
        true => {
            [n, s * b.dot(along_b) + t * c.dot(along_b), s * b.dot(along_c) + t * c.dot(along_c)]
        }
        false => [n, s, t],
    };
    let same = !turned
        && shift.length() < 1e-9 * was.half_spacing[0].max(was.half_spacing[1])
        && (class.area - was.area).abs() < 1e-9 * class.area;
    let at = [0, 1, 2, 3].map(|q| {
        let at = shift + patch::place(&class, q);
        [at.dot(b) / was.half_spacing[0], at.dot(c) / was.half_spacing[1]]
    });
    // The old point that each new one takes its state of.
    let from = [0, 1, 2, 3].map(|q| if same { q } else { nearest(at[q]) });
    let is = |group: u16, o: usize| list.flags[k] & flag::of(group, o) != 0;
    // A law that is not plain is not linear: points go on from where the nearest one was.
    let linear = list.flags[k] & (flag::BROKEN | flag::OPEN) == 0 && !same && openings.is_none();
    let normal_offset = list.normal_offset.get(k).copied().unwrap_or_default();
    let accumulated_slip = list.accumulated_slip.get(k).copied().unwrap_or_default();
    let new = New {
        tractions: [0, 1, 2, 3]
            .map(|q| own(if linear { bilinear(&tractions, at[q]) } else { tractions[from[q]] })),
        // An open point closes at the displacement at which it would have closed.
        normal_offset: from
            .map(|o| is(flag::OPEN, o).then(|| normal_offset[o] - start[o][0] / was.stiffness[0])),
        accumulated_slip: from.map(|o| accumulated_slip[o]),
        wear: list.wear.get(k).copied().unwrap_or_default().map(|wear| from.map(|o| wear[o])),
        openings: openings.map(|openings| from.map(|o| openings[o])),
    };
    let mut flags = list.flags[k] & (flag::FINITE | flag::DISPLACED);
    for group in [flag::BROKEN, flag::OPEN, flag::SLIDING] {
        let set = (0..4).filter(|q| is(group, from[*q]));
        flags |= set.map(|q| flag::of(group, q)).sum::<u16>();
    }
    let origin = list.origin_of(k);
    new.put(world, p, flags);
    world.patches.set_origin(p, origin);
}

/// The point whose quarter holds a place given in units of the half_spacing.
pub(super) fn nearest(at: [f64; 2]) -> usize {
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
