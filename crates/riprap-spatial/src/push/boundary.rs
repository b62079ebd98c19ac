//! Conditions on free faces: held, moved, viscous, loaded.
//!
//! Springs and dashpots act at four points of a face through the half block behind it (`M/h` and `2G/h` per area,
//! h from centroid to face). A viscous face puts the dashpots of Lysmer & Kuhlemeyer (1969) behind these
//! springs: `s = k (u - a)`, `da/dt = s / Z`, by the trapezoidal rule in `a`; reflection is then of second order in
//! the size of the block, against first order for a dashpot on the face of the rigid block. In implicit steps: `ahead`. Dashpots without
//! springs take the mean of the velocities before and after the kick: a lag of half a step would reflect too.

mod ahead;

use std::collections::BTreeMap;

use riprap_geom::{Mat3, Vec3};

use crate::accounts::Account;
use crate::joint::patch::Poses;
use crate::ledger::Works;
use crate::push::traction::{Spot, traction};
use crate::setup::error::BuildError;
use crate::setup::{Boundary, BoundaryKind, FaceSet};
use crate::state::bodies::SolidClass;
pub(crate) use crate::state::face::{Face, HalfBlock, Overruled};
use crate::state::push::Wrench;
use crate::state::world::World;

/// Largest sine between a face normal and the one that is asked for.
const PARALLEL: f64 = 1e-6;

/// Gives free faces their conditions.
pub(crate) fn assign(world: &mut World, tolerance: f64) -> Result<(), BuildError> {
    let mut meant = vec![0; world.setup.boundaries.len()];
    let mut taken: BTreeMap<[u16; 2], u32> = BTreeMap::new();
    for (index, boundary) in world.setup.boundaries.iter().enumerate() {
        for face in &mut world.faces {
            let centre = world.reference[face.block as usize] + face.arm;
            if !is_on(&boundary.on, face, centre, tolerance) {
                continue;
            }
            meant[index] += 1;
            if let Some(earlier) = face.boundary.replace(index as u16) {
                *taken.entry([earlier, index as u16]).or_default() += 1;
            }
            // What an earlier condition has put behind the face goes with it.
            face.half_block = None;
            if matches!(boundary.kind, BoundaryKind::Traction { .. }) {
                continue;
            }
            let block = &world.setup.blocks[face.block as usize];
            let material = &world.setup.materials[block.material as usize];
            let moduli = material.constrained_modulus().zip(material.shear_modulus());
            let (m, g) = moduli.ok_or_else(|| BuildError::NoModulus {
                material: material.name.clone(),
                need: "the boundary on its faces",
            })?;
            let depth = face.arm.dot(face.frame[0]);
            face.half_block = Some(Box::new(HalfBlock {
                stiffness: [m / depth, 2.0 * g / depth],
                impedance: [m, g].map(|modulus| (material.density * modulus).sqrt()),
                ..HalfBlock::default()
            }));
        }
        if meant[index] == 0 {
            let boundary = boundary.name.clone();
            return Err(BuildError::NoFace { boundary });
        }
    }
    let taken = taken.into_iter();
    world.overruled = taken
        .map(|(boundaries, faces)| Overruled {
            boundaries,
            faces,
            of: meant[usize::from(boundaries[0])],
        })
        .collect();
    overruled(world)
}

/// A face has one condition, the last that is given for it; a condition that is left without any face is a mistake.
fn overruled(world: &World) -> Result<(), BuildError> {
    let boundaries = &world.setup.boundaries;
    let mut acts = vec![false; boundaries.len()];
    for face in &world.faces {
        if let Some(index) = face.boundary {
            acts[usize::from(index)] = true;
        }
    }
    let Some(index) = acts.iter().position(|acts| !acts) else {
        return Ok(());
    };
    Err(BuildError::Overruled {
        boundary: boundaries[index].name.clone(),
        later: boundaries[index + 1..]
            .iter()
            .map(|b| b.name.clone())
            .collect::<Vec<_>>()
            .join("`, `"),
    })
}

/// Whether a face belongs to a choice of faces.
fn is_on(set: &FaceSet, face: &Face, centre: Vec3, tolerance: f64) -> bool {
    let along = |normal: &Vec3| {
        face.frame[0].cross(*normal).length() < PARALLEL && face.frame[0].dot(*normal) > 0.0
    };
    match set {
        FaceSet::Plane { normal, offset } => {
            along(normal) && (centre.dot(*normal) - offset).abs() <= tolerance
        }
        FaceSet::Blocks { blocks, normal } => {
            blocks.binary_search(&face.block).is_ok() && normal.as_ref().is_none_or(along)
        }
        FaceSet::Surface { blocks, planes } => {
            let x = face.frame[0].x;
            let from = planes.partition_point(|(normal, _)| normal.x < x - PARALLEL);
            let near = planes[from..].iter();
            let mut near = near.take_while(|(normal, _)| normal.x <= x + PARALLEL);
            blocks.binary_search(&face.block).is_ok()
                && near.any(|(normal, offset)| {
                    along(normal) && (centre.dot(*normal) - offset).abs() <= tolerance
                })
        }
        FaceSet::Box { min, max, normal } => {
            centre.cmpge(*min - Vec3::splat(tolerance)).all()
                && centre.cmple(*max + Vec3::splat(tolerance)).all()
                && normal.as_ref().is_none_or(along)
        }
    }
}

/// What acts on a face, by the account it is booked on.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct FaceForces {
    /// Springs: held, moved and viscous faces.
    pub spring: Wrench,
    /// Tractions with a given value.
    pub dead: Wrench,
    /// Works that were booked, J.
    pub booked: Account,
}

/// Dashpots on one block: force and moment are minus this matrix times velocity and spin.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Dashpots {
    matrix: [[f64; 6]; 6],
}

impl Dashpots {
    /// Adds the dashpots at a point with a share of the area, m².
    fn add(&mut self, share: f64, impedance: [f64; 2], normal: Vec3, arm: Vec3) {
        // The point moves by v + w x arm for each of the six rates.
        let point = |k: usize| match k {
            0..3 => Vec3::AXES[k],
            _ => Vec3::AXES[k - 3].cross(arm),
        };
        for k in 0..6 {
            let (along, across) = parts(point(k), normal);
            let force = share * (impedance[0] * along + impedance[1] * across);
            for (l, row) in self.matrix.iter_mut().enumerate() {
                row[k] += point(l).dot(force);
            }
        }
    }

    /// Mean of the velocities and spins before and after the coming kick over `span` (s):
    /// `(M + span C / 2) dv = span (F - C v)`.
    #[must_use]
    pub(crate) fn mean(
        &self,
        solid: &SolidClass,
        velocity: [Vec3; 2],
        other: &Wrench,
        span: f64,
    ) -> [f64; 6] {
        let velocity: [f64; 6] = six(velocity);
        let drag = self.times(&velocity);
        let mut a = self.matrix.map(|row| row.map(|c| 0.5 * span * c));
        for k in 0..3 {
            a[k][k] += solid.mass;
            for l in 0..3 {
                a[k + 3][l + 3] += solid.inertia.col(l)[k];
            }
        }
        let force = six([other.force, other.moment]);
        let change = solve(a, std::array::from_fn(|k| span * (force[k] - drag[k])));
        std::array::from_fn(|k| velocity[k] + 0.5 * change[k])
    }

    fn times(&self, rates: &[f64; 6]) -> [f64; 6] {
        self.matrix.map(|row| (0..6).map(|k| row[k] * rates[k]).sum::<f64>())
    }

    /// What they do to a block in a kick with these mean rates.
    #[must_use]
    pub(crate) fn push(&self, mean: &[f64; 6]) -> Wrench {
        let t = self.times(mean);
        Wrench { force: -Vec3::new(t[0], t[1], t[2]), moment: -Vec3::new(t[3], t[4], t[5]) }
    }
}

fn six([a, b]: [Vec3; 2]) -> [f64; 6] {
    [a.x, a.y, a.z, b.x, b.y, b.z]
}

/// Solves a symmetric positive definite system by elimination.
fn solve(mut a: [[f64; 6]; 6], mut b: [f64; 6]) -> [f64; 6] {
    for k in 0..6 {
        let pivot = a[k];
        for l in k + 1..6 {
            let factor = a[l][k] / pivot[k];
            for (x, p) in a[l].iter_mut().zip(pivot) {
                *x -= factor * p;
            }
            b[l] -= factor * b[k];
        }
    }
    for k in (0..6).rev() {
        let known: f64 = (k + 1..6).map(|l| a[k][l] * b[l]).sum();
        b[k] = (b[k] - known) / a[k][k];
    }
    b
}

/// Motion of a point of a face.
struct PointMotion {
    /// From the centroid, m.
    arm: Vec3,
    /// Displacement, m.
    u: Vec3,
    /// Velocity, m/s.
    v: Vec3,
}

/// Context of the boundary stage.
#[derive(Clone, Copy)]
pub(crate) struct Context<'a> {
    /// Poses of the blocks.
    pub poses: Poses<'a>,
    /// Conditions.
    pub boundaries: &'a [Boundary],
    /// Stress at the start.
    pub in_situ: Option<&'a crate::setup::InSitu>,
    /// Centroids at the start, m.
    pub reference: &'a [Vec3],
    /// Where the local origin lies, m (global).
    pub origin: Vec3,
    /// Present time, s.
    pub time: f64,
    /// Halves of the steps before and after it that the kick spans, s.
    pub half: [f64; 2],
    /// Time moved since the last evaluation, s.
    pub pending: f64,
}

impl<'a> Context<'a> {
    /// Context of the present time of a world.
    #[must_use]
    pub(crate) fn new(world: &'a World) -> Self {
        Self {
            poses: Poses { bodies: &world.bodies, turned: &world.turned },
            boundaries: &world.setup.boundaries,
            in_situ: world.setup.in_situ.as_ref(),
            reference: &world.reference,
            origin: world.setup.origin,
            time: world.time,
            half: [0.0; 2],
            pending: world.pending,
        }
    }

    /// Moves the anchors of a face on to the present time and finds what acts on its block; books the works of
    /// anchors. Dashpots without springs are added to `dashpots`.
    pub(crate) fn act(
        &self,
        face: &mut Face,
        works: &mut Works,
        dashpots: &mut Option<Dashpots>,
    ) -> FaceForces {
        let mut out = FaceForces::default();
        let Some(boundary) = face.boundary.map(|k| &self.boundaries[k as usize]) else {
            return out;
        };
        let half = face.behind();
        let creep = [0, 1].map(|k| 0.5 * self.pending * half.stiffness[k] / half.impedance[k]);
        for p in 0..4 {
            let motion = self.motion(face, p);
            let before = half.anchor[p];
            let after = self.anchor(boundary, face, (p, before), creep, &motion);
            let spring = |stretch| half.spring(boundary, face.frame[0], stretch);
            let pull = spring(motion.u - after);
            if after != before {
                // A quarter of the area, and the mean of the pulls before and after the far end has moved.
                let old = spring(motion.u - self.pending * motion.v - before);
                let work = 0.125 * face.area * (old + pull).dot(after - before);
                match boundary.kind {
                    // What the far end takes out of the spring as it gives way: absorbed
                    // by its dashpot, or minus the work of what moves it.
                    BoundaryKind::Viscous { .. } => {
                        works.absorbed += work;
                        out.booked.absorbed += work;
                    }
                    BoundaryKind::Held { .. }
                    | BoundaryKind::Moved { .. }
                    | BoundaryKind::Traction { .. } => {
                        works.supports -= work;
                        out.booked.supports -= work;
                    }
                }
                if let Some(half) = &mut face.half_block {
                    half.anchor[p] = after;
                }
            }
            let [spring, dead] = self.forces(boundary, face, p, pull);
            out.spring.add(spring, motion.arm);
            out.dead.add(dead, motion.arm);
            if let BoundaryKind::Viscous { half_cell: false } = boundary.kind {
                let dashpots = dashpots.get_or_insert_default();
                dashpots.add(0.25 * face.area, half.impedance, face.frame[0], motion.arm);
            }
        }
        out
    }

    /// Force that the dashpots of a viscous face carry, N: through their springs, or by the speed of the face where they have none.
    #[must_use]
    pub(crate) fn dragged(&self, face: &Face) -> f64 {
        let Some(boundary) = face.boundary.map(|k| &self.boundaries[usize::from(k)]) else {
            return 0.0;
        };
        let BoundaryKind::Viscous { half_cell } = boundary.kind else {
            return 0.0;
        };
        let half = face.behind();
        let stress = |p: usize| {
            let motion = self.motion(face, p);
            if half_cell {
                return half.spring(boundary, face.frame[0], motion.u - half.anchor[p]);
            }
            let (along, across) = parts(motion.v, face.frame[0]);
            half.impedance[0] * along + half.impedance[1] * across
        };
        let mean = (0..4).map(stress).sum::<Vec3>();
        0.25 * face.area * mean.length()
    }

    /// Dashpots without springs on a face.
    #[must_use]
    pub(crate) fn dashpots(&self, face: &Face) -> Option<Dashpots> {
        let boundary = &self.boundaries[usize::from(face.boundary?)];
        let BoundaryKind::Viscous { half_cell: false } = boundary.kind else {
            return None;
        };
        let mut dashpots = Dashpots::default();
        for p in 0..4 {
            let arm = self.motion(face, p).arm;
            let impedance = face.behind().impedance;
            dashpots.add(0.25 * face.area, impedance, face.frame[0], arm);
        }
        Some(dashpots)
    }

    /// Motion of point `p` of a face.
    #[inline]
    fn motion(&self, face: &Face, p: usize) -> PointMotion {
        let (b, start, bodies) = (face.block as usize, face.place(p), self.poses.bodies);
        let (arm, moved) = match &self.poses.turned[b] {
            Some(turned) => {
                let arm = turned.attitude * start;
                (arm, arm - start)
            }
            None => (start, bodies.rotation(b).cross(start)),
        };
        PointMotion {
            arm,
            u: bodies.displacement(b) + moved,
            v: bodies.velocity(b) + bodies.spin(b).cross(arm),
        }
    }

    /// Forces (N) at point `p`, of the spring whose stress is `pull` (Pa) and of given tractions.
    #[inline]
    fn forces(&self, boundary: &Boundary, face: &Face, p: usize, pull: Vec3) -> [Vec3; 2] {
        let b = face.block as usize;
        let (start, share) = (face.frame[0], 0.25 * face.area);
        let height = self.reference[b].z + face.place(p).z;
        let turned = self.poses.turned[b].as_ref();
        let spot = Spot {
            start,
            normal: turned.map_or(start, |t| t.attitude * start),
            stress_at: height,
            pressure_at: height,
        };
        let dead = traction(boundary, self.in_situ, &spot, (self.time, self.half));
        let spring = match &boundary.kind {
            BoundaryKind::Viscous { half_cell: false } | BoundaryKind::Traction { .. } => {
                Vec3::ZERO
            }
            BoundaryKind::Viscous { half_cell: true }
            | BoundaryKind::Held { .. }
            | BoundaryKind::Moved { .. } => -pull,
        };
        [spring, dead].map(|t| share * t)
    }

    /// Energy in the springs of a face, J.
    #[must_use]
    pub(crate) fn stored(&self, face: &Face) -> f64 {
        let Some(boundary) = face.boundary.map(|k| &self.boundaries[k as usize]) else {
            return 0.0;
        };
        let half = face.behind();
        let energy = |p: usize| {
            let stretch = self.motion(face, p).u - half.anchor[p];
            let pull = half.spring(boundary, face.frame[0], stretch);
            0.125 * face.area * pull.dot(stretch)
        };
        (0..4).map(energy).sum()
    }

    /// Sum of the dyads of arm and force over the points of a face, N m; dashpots without springs, which follow
    /// from the kick, are left out.
    #[must_use]
    pub(crate) fn dyad(&self, face: &Face) -> Mat3 {
        let Some(boundary) = face.boundary.map(|k| &self.boundaries[k as usize]) else {
            return Mat3::ZERO;
        };
        let half = face.behind();
        let mut sum = Mat3::ZERO;
        for p in 0..4 {
            let motion = self.motion(face, p);
            let pull = half.spring(boundary, face.frame[0], motion.u - half.anchor[p]);
            let force: Vec3 = self.forces(boundary, face, p, pull).into_iter().sum();
            let r = motion.arm;
            sum += Mat3::from_cols(force.x * r, force.y * r, force.z * r);
        }
        sum
    }

    /// Present place of the far end of the spring at point `p`, from that `before`. `creep`: half the way, along the normal
    /// and across it, that a dashpot goes in the pending time for each metre its spring is stretched.
    #[inline]
    fn anchor(
        &self,
        boundary: &Boundary,
        face: &Face,
        (p, before): (usize, Vec3),
        creep: [f64; 2],
        motion: &PointMotion,
    ) -> Vec3 {
        match &boundary.kind {
            BoundaryKind::Viscous { .. } => {
                if self.pending == 0.0 {
                    return before;
                }
                let towards = |a: Vec3, u: Vec3, r: f64| ((1.0 - r) * a + 2.0 * r * u) / (1.0 + r);
                let (an, at) = parts(before, face.frame[0]);
                // In the middle of the step: so the rule is implicit in the far end
                // alone, and the block needs not be known ahead.
                let (un, ut) = parts(motion.u - 0.5 * self.pending * motion.v, face.frame[0]);
                towards(an, un, creep[0]) + towards(at, ut, creep[1])
            }
            BoundaryKind::Moved { velocity } => {
                // As for blocks: a given velocity holds in the middle of a step.
                let middle = self.time - 0.5 * self.pending;
                let start = self.reference[face.block as usize] + face.place(p);
                let at = (self.origin + start).to_array();
                let mut after = before;
                for k in 0..3 {
                    if let Some(f) = &velocity[k] {
                        after[k] += self.pending * f.at_place(middle, at);
                    }
                }
                after
            }
            BoundaryKind::Held { .. } | BoundaryKind::Traction { .. } => before,
        }
    }
}

impl HalfBlock {
    /// Stress (Pa) of the spring behind a face with this normal that is stretched by `stretch` (m).
    #[inline]
    fn spring(&self, boundary: &Boundary, face: Vec3, stretch: Vec3) -> Vec3 {
        let [kn, ks] = self.stiffness;
        let full = |stretch: Vec3| {
            let (n, t) = parts(stretch, face);
            kn * n + ks * t
        };
        match &boundary.kind {
            BoundaryKind::Held { normal, shear } => {
                let (n, t) = parts(stretch, face);
                f64::from(u8::from(*normal)) * kn * n + f64::from(u8::from(*shear)) * ks * t
            }
            BoundaryKind::Viscous { half_cell: true } => full(stretch),
            BoundaryKind::Moved { velocity } => {
                // A direction that is left free neither stretches nor pulls.
                let free = |v: Vec3| {
                    Vec3::from_array([0, 1, 2].map(|k| match velocity[k] {
                        Some(_) => v[k],
                        None => 0.0,
                    }))
                };
                free(full(free(stretch)))
            }
            BoundaryKind::Viscous { half_cell: false } | BoundaryKind::Traction { .. } => {
                Vec3::ZERO
            }
        }
    }
}

/// Parts of a vector along a unit normal and across it.
#[inline]
fn parts(v: Vec3, normal: Vec3) -> (Vec3, Vec3) {
    let along = normal.dot(v) * normal;
    (along, v - along)
}
