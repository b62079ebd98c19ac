//! Patches between rigid blocks and the classes that equal ones share.

use riprap_geom::Vec3;
use serde::{Deserialize, Serialize};

use crate::state::interface::Origin;

/// Patches: rectangles or polygons where two blocks share a face. Lists of equal length, except
/// those that are empty when no patch needs them.
///
/// Stress is tension-positive; the normal points from block `i` to block `j`; the traction is that
/// on block `i`.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Patches {
    /// Blocks i and j; may be the same block in a periodic model one block wide.
    pub ends: Vec<[u32; 2]>,
    /// Index into `World::classes`.
    pub class: Vec<u32>,
    /// State bits, see [`flag`].
    pub flags: Vec<u16>,
    /// Traction at the centre at zero displacement, Pa, global axes at the start; empty without
    /// in-situ stress.
    pub prestress: Vec<Vec3>,
    /// Irrecoverable shear displacement along b and c of the four points, m; empty while all is
    /// elastic.
    pub slip: Vec<[[f64; 4]; 2]>,
    /// Opening at which the normal spring of each point is relaxed, m: edits and changes of
    /// kinematics; empty when there is none.
    pub normal_offset: Vec<[f64; 4]>,
    /// Accumulated slip of each point, m; empty without softening and roughness.
    pub accumulated_slip: Vec<[f64; 4]>,
    /// What softening and roughness remember of each point, m: the largest opening beyond the elastic one, and how far its sides have
    /// been parted; empty without such laws.
    pub wear: Vec<[[f64; 4]; 2]>,
    /// Where each comes from; empty while all were built with the model.
    pub origin: Vec<Origin>,
}

impl Patches {
    /// Number of patches.
    #[must_use]
    pub fn len(&self) -> usize {
        self.ends.len()
    }

    /// Whether patch `p` is not as it was built: a softening joint wears and slips before any of its bits says so.
    #[must_use]
    pub(crate) fn remembers(&self, p: usize) -> bool {
        let any = |list: Option<&[f64]>| list.is_some_and(|l| l.iter().any(|x| x.to_bits() != 0));
        self.flags[p] != 0
            || any(self.slip.get(p).map(|slip| slip.as_flattened()))
            || any(self.wear.get(p).map(|wear| wear.as_flattened()))
            || any(self.accumulated_slip.get(p).map(|slip| &slip[..]))
            || any(self.normal_offset.get(p).map(|offset| &offset[..]))
    }

    /// Whether there are none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.ends.is_empty()
    }

    /// Keeps the patches `chosen`, in that order.
    pub fn keep(&mut self, chosen: &[u32]) {
        fn pick<T: Copy>(list: &mut Vec<T>, chosen: &[u32]) {
            if !list.is_empty() {
                *list = chosen.iter().map(|&p| list[p as usize]).collect();
            }
        }
        pick(&mut self.ends, chosen);
        pick(&mut self.class, chosen);
        pick(&mut self.flags, chosen);
        pick(&mut self.prestress, chosen);
        pick(&mut self.slip, chosen);
        pick(&mut self.normal_offset, chosen);
        pick(&mut self.accumulated_slip, chosen);
        pick(&mut self.wear, chosen);
        pick(&mut self.origin, chosen);
    }

    /// Lets the patches `gone` (ascending) go; the others keep their order. What stands before the first of them is not touched.
    pub fn drop_some(&mut self, gone: &[usize]) {
        fn close<T: Copy>(list: &mut Vec<T>, gone: &[usize]) {
            if list.is_empty() {
                return;
            }
            let ends = gone.iter().skip(1).copied().chain([list.len()]);
            let mut to = gone.first().copied().unwrap_or(list.len());
            for (from, end) in gone.iter().map(|p| p + 1).zip(ends) {
                list.copy_within(from..end, to);
                to += end - from;
            }
            list.truncate(to);
        }
        close(&mut self.ends, gone);
        close(&mut self.class, gone);
        close(&mut self.flags, gone);
        close(&mut self.prestress, gone);
        close(&mut self.slip, gone);
        close(&mut self.normal_offset, gone);
        close(&mut self.accumulated_slip, gone);
        close(&mut self.wear, gone);
        close(&mut self.origin, gone);
    }

    /// Where patch `p` comes from.
    #[must_use]
    pub fn origin_of(&self, p: usize) -> Origin {
        self.origin.get(p).copied().unwrap_or_default()
    }

    /// Says where patch `p` comes from.
    pub fn set_origin(&mut self, p: usize, origin: Origin) {
        if origin != Origin::Built || !self.origin.is_empty() {
            self.origin.resize(self.ends.len(), Origin::Built);
            self.origin[p] = origin;
        }
    }

    /// Makes room for slip where there is none yet.
    pub fn need_slip(&mut self) {
        self.slip.resize(self.ends.len(), [[0.0; 4]; 2]);
    }

    /// Makes room for lifts where there is none yet.
    pub fn need_normal_offset(&mut self) {
        self.normal_offset.resize(self.ends.len(), [0.0; 4]);
    }

    /// Makes room for what softening and roughness remember where there is none yet.
    pub fn need_wear(&mut self) {
        self.accumulated_slip.resize(self.ends.len(), [0.0; 4]);
        self.wear.resize(self.ends.len(), [[0.0; 4]; 2]);
    }
}

/// Bits of [`Patches::flags`]; bits 0 to 11 are one per point.
pub mod flag {
    /// The four points have failed (bits 0 to 3).
    pub const BROKEN: u16 = 0x000f;
    /// The four points are open now (bits 4 to 7).
    pub const OPEN: u16 = 0x00f0;
    /// The four points slid in the last step (bits 8 to 11).
    pub const SLIDING: u16 = 0x0f00;
    /// The patch uses finite rotations.
    pub const FINITE: u16 = 0x1000;
    /// `slip` or `normal_offset` are in use.
    pub const OFFSET: u16 = 0x2000;
    /// A point has slid or opened so far that the patch no longer holds its blocks in place against others.
    pub const DISPLACED: u16 = 0x4000;

    /// Bits of points that slid by `before`, and go on doing so by `after`: a law that is applied again at the same instant
    /// sees no motion, but closed points have not come to rest.
    #[must_use]
    pub const fn slide_on(before: u16, after: u16) -> u16 {
        before & SLIDING & !((after & OPEN) << 4)
    }

    /// Bit of `point` (0 to 3) in the group that starts at the lowest bit of `group`.
    #[must_use]
    pub const fn of(group: u16, point: usize) -> u16 {
        (1 << point) << group.trailing_zeros()
    }
}

/// Geometry and stiffness shared by equal patches, at the start.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct PatchClass {
    /// Unit vectors n (from i to j), b and c: right-handed.
    pub frame: [Vec3; 3],
    /// Area, m².
    pub area: f64,
    /// Distance of the points from the centre along b and c, m.
    pub half_spacing: [f64; 2],
    /// Centre of the patch from the centroids of i and j, m.
    pub arms: [Vec3; 2],
    /// Normal and shear stiffness, Pa/m.
    pub stiffness: [f64; 2],
    /// Dashpot over spring of closed points, s.
    pub beta: f64,
    /// Materials of i and j.
    pub materials: [u16; 2],
    /// Index into `Setup::interfaces`.
    pub row: u16,
    /// Axis of the normal, 0 to 2, with b and c the next two axes; 3 for any other direction.
    pub axis: u8,
    /// Distance of the centroids across the patch, m.
    pub distance: f64,
    /// In-situ traction (n, b, c) per metre along b and along c, Pa/m; scaled so that four points have
    /// its exact moment.
    pub slope: [[f64; 3]; 2],
}

#[cfg(test)]
mod tests {
    use super::Patches;

    #[test]
    fn what_is_left_keeps_its_order() {
        let all = Patches {
            ends: (0..10).map(|k| [k, k + 1]).collect(),
            class: (0..10).collect(),
            flags: (0..10).collect(),
            normal_offset: (0..10).map(|k| [f64::from(k); 4]).collect(),
            ..Patches::default()
        };
        for gone in
            [&[][..], &[0], &[9], &[0, 1, 2], &[3, 4, 8], &[0, 9], &[0, 1, 2, 3, 4, 5, 6, 7, 8, 9]]
        {
            let (mut short, mut picked) = (all.clone(), all.clone());
            short.drop_some(gone);
            let keep: Vec<u32> = (0..10).filter(|k| !gone.contains(&(*k as usize))).collect();
            picked.keep(&keep);
            assert_eq!(short, picked, "{gone:?}");
        }
    }
}
