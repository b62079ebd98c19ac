//! Conditions on faces in implicit steps: what holds a face at the end of a step.
//!
//! ```text
//!   stress(end) = stress + drag v      spring:            k (u - a(end)) + k dt v
//!                                      and a dashpot:     (k (u - a) + k dt v)/(1 + dt k/Z)
//!                                      a dashpot alone:   Z v
//! ```
//!
//! A dashpot behind a spring gives way by the stress at the end of the step (backward Euler), where explicit phases take the mean: a step that is long for the
//! spring would throw the far end to and fro.

use riprap_geom::{Mat3, Vec3};

use crate::accounts::Account;
use crate::ledger::Works;
use crate::push::boundary::{Context, Face, parts};
use crate::setup::BoundaryKind;
use crate::state::push::Wrench;

/// What holds a point of a face in the coming step.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Ahead {
    /// From the centroid, m.
    pub(crate) arm: Vec3,
    /// What pulls it back where it does not move, N.
    pub(crate) pull: Vec3,
    /// What more where it does, N s/m.
    pub(crate) drag: Mat3,
}

impl Context<'_> {
    /// Present place of the far end of the spring at point `p`.
    fn anchor_ahead(&self, face: &Face, p: usize) -> Vec3 {
        let half = face.behind();
        let before = half.anchor[p];
        let Some(boundary) = face.boundary.map(|k| &self.boundaries[usize::from(k)]) else {
            return before;
        };
        let motion = self.motion(face, p);
        if !matches!(boundary.kind, BoundaryKind::Viscous { .. }) {
            return self.anchor(boundary, face, (p, before), [0.0; 2], &motion);
        }
        let (an, at) = parts(before, face.frame[0]);
        let (un, ut) = parts(motion.u, face.frame[0]);
        let way = |k: usize| self.pending * half.stiffness[k] / half.impedance[k];
        let towards = |a: Vec3, u: Vec3, r: f64| (a + r * u) / (1.0 + r);
        towards(an, un, way(0)) + towards(at, ut, way(1))
    }

    /// What holds the points of a face in the coming step of `dt` (s), and whether dashpots alone do; `None` where nothing but given tractions acts.
    pub(crate) fn ahead(&self, face: &Face, dt: f64) -> Option<([Ahead; 4], bool)> {
        let boundary = &self.boundaries[usize::from(face.boundary?)];
        let (half, n, share) = (face.behind(), face.frame[0], 0.25 * face.area);
        let dashpots = match boundary.kind {
            BoundaryKind::Traction { .. } => return None,
            BoundaryKind::Viscous { half_cell } => !half_cell,
            BoundaryKind::Held { .. } | BoundaryKind::Moved { .. } => false,
        };
        let viscous = matches!(boundary.kind, BoundaryKind::Viscous { .. });
        // In series with a dashpot a spring is softer the longer the step.
        let softer = |stress: Vec3| {
            let (along, across) = parts(stress, n);
            let by = |k: usize| 1.0 / (1.0 + dt * half.stiffness[k] / half.impedance[k]);
            if viscous { by(0) * along + by(1) * across } else { stress }
        };
        let points = std::array::from_fn(|p| {
            let motion = self.motion(face, p);
            let columns = |of: &dyn Fn(Vec3) -> Vec3| {
                Mat3::from_cols(share * of(Vec3::X), share * of(Vec3::Y), share * of(Vec3::Z))
            };
            if dashpots {
                let [zn, zt] = half.impedance;
                let drag = columns(&|v| {
                    let (along, across) = parts(v, n);
                    zn * along + zt * across
                });
                return Ahead { arm: motion.arm, pull: Vec3::ZERO, drag };
            }
            let mut anchor = self.anchor_ahead(face, p);
            if let BoundaryKind::Moved { velocity } = &boundary.kind {
                let start = self.reference[face.block as usize] + face.place(p);
                let at = (self.origin + start).to_array();
                for k in 0..3 {
                    if let Some(f) = &velocity[k] {
                        anchor[k] += dt * f.at_place(self.time + 0.5 * dt, at);
                    }
                }
            }
            let stress = |stretch: Vec3| softer(half.spring(boundary, n, stretch));
            Ahead {
                arm: motion.arm,
                pull: share * stress(motion.u - anchor),
                drag: columns(&|v| stress(dt * v)),
            }
        });
        Some((points, dashpots))
    }

    /// Given tractions on a face, those of the stress at the start included.
    pub(crate) fn given(&self, face: &Face) -> Wrench {
        let mut out = Wrench::default();
        if let Some(boundary) = face.boundary.map(|k| &self.boundaries[usize::from(k)]) {
            for p in 0..4 {
                let [_, dead] = self.forces(boundary, face, p, Vec3::ZERO);
                out.add(dead, self.motion(face, p).arm);
            }
        }
        out
    }

    /// Moves the far ends of the springs of a face on to the present time, and books what that does.
    pub(crate) fn move_on(&self, face: &mut Face, works: &mut Works) -> Account {
        let mut booked = Account::default();
        let Some(boundary) = face.boundary.map(|k| &self.boundaries[usize::from(k)]) else {
            return booked;
        };
        for p in 0..4 {
            let (half, motion) = (face.behind(), self.motion(face, p));
            let (before, after) = (half.anchor[p], self.anchor_ahead(face, p));
            if after == before {
                continue;
            }
            let spring = |stretch| half.spring(boundary, face.frame[0], stretch);
            let old = spring(motion.u - self.pending * motion.v - before);
            let work = 0.125 * face.area * (old + spring(motion.u - after)).dot(after - before);
            match boundary.kind {
                BoundaryKind::Viscous { .. } => {
                    works.absorbed += work;
                    booked.absorbed += work;
                }
                BoundaryKind::Held { .. }
                | BoundaryKind::Moved { .. }
                | BoundaryKind::Traction { .. } => {
                    works.supports -= work;
                    booked.supports -= work;
                }
            }
            if let Some(half) = &mut face.half_block {
                half.anchor[p] = after;
            }
        }
        booked
    }
}
