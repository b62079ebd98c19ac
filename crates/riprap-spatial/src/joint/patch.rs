//! One patch at a time: kinematics, law and resultant, for any state. The wide kernel takes over where
//! all points are certainly elastic; this module is what it must agree with.

use crate::setup::rotation::rotation;
use riprap_geom::{Mat3, Quat, Vec3};

use crate::laws::face_joint;
use crate::laws::face_joint::{Loss, Memory, SIGNS, Traction};
use crate::setup::{Dashpots, Failure, InterfaceLaw, JointLaw};
use crate::state::bodies::{Bodies, Turned};
use crate::state::patches::{PatchClass, flag};

/// Forces of a patch on its blocks.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Resultant {
    /// Force on block i, N; block j gets the opposite.
    pub force: Vec3,
    /// Moments on i and on j about their centroids, N m.
    pub moments: [Vec3; 2],
}

impl Resultant {
    /// Force `force` and moment `moment` about the patch centre on i, with the arms of the centre.
    #[inline]
    #[must_use]
    pub fn at(force: Vec3, moment: Vec3, arms: [Vec3; 2]) -> Self {
        Self { force, moments: [arms[0].cross(force) + moment, -(arms[1].cross(force) + moment)] }
    }

    /// Sum of two resultants.
    #[inline]
    #[must_use]
    pub fn plus(&self, other: &Self) -> Self {
        Self {
            force: self.force + other.force,
            moments: [self.moments[0] + other.moments[0], self.moments[1] + other.moments[1]],
        }
    }
}

/// Kinematics of the four points of a patch, in the frame of the patch.
#[derive(Clone, Copy, Debug)]
pub struct Points {
    /// Unit vectors n, b, c now.
    pub frame: [Vec3; 3],
    /// Relative displacement (j minus i), m.
    pub at: [[f64; 3]; 4],
    /// Relative velocity, m/s.
    pub velocity: [[f64; 3]; 4],
    /// Places of the points from the centroids of i and j, m; `None` with small kinematics.
    arms: Option<[[Vec3; 2]; 4]>,
}

/// What kinematics reads.
#[derive(Clone, Copy)]
pub(crate) struct Poses<'a> {
    /// Displacements and velocities.
    pub bodies: &'a Bodies,
    /// Attitudes of the blocks with finite rotations.
    pub turned: &'a [Option<Box<Turned>>],
}

impl Poses<'_> {
    /// Turns the frame of the start into the present one.
    #[must_use]
    pub(crate) fn attitude(&self, b: usize) -> Quat {
        match &self.turned[b] {
            Some(turned) => turned.attitude,
            None => rotation(self.bodies.rotation(b)),
        }
    }

    /// Points of a patch, with finite rotations or with small ones.
    #[must_use]
    pub(crate) fn points(&self, class: &PatchClass, ends: [u32; 2], finite: bool) -> Points {
        if finite { self.finite_points(class, ends) } else { self.small_points(class, ends) }
    }

    /// Physics of small displacements: arms and frame of the start, rotations as vectors.
    fn small_points(&self, class: &PatchClass, ends: [u32; 2]) -> Points {
        let [i, j] = ends.map(|b| b as usize);
        let bodies = self.bodies;
        let between = |shift: &dyn Fn(usize) -> Vec3, turn: &dyn Fn(usize) -> Vec3| {
            let centre =
                shift(j) - shift(i) + turn(j).cross(class.arms[1]) - turn(i).cross(class.arms[0]);
            spread(class, centre, turn(j) - turn(i))
        };
        Points {
            frame: class.frame,
            at: between(&|b| bodies.displacement(b), &|b| bodies.rotation(b)),
            velocity: between(&|b| bodies.velocity(b), &|b| bodies.spin(b)),
            arms: None,
        }
    }

    /// Finite rotations: normal is the mean of both turned normals, each pair of points acts at its middle.
    fn finite_points(&self, class: &PatchClass, ends: [u32; 2]) -> Points {
        let blocks = ends.map(|b| b as usize);
        let q = blocks.map(|b| self.attitude(b));
        let [n, b, _] = class.frame;
        // Sides turned half a turn against each other have no mean: that of the first block stands in.
        let normal = (q[0] * n + q[1] * n).normalize_or(q[0] * n);
        let along = q[0] * b + q[1] * b;
        // The mean of two turned axes is not square to the mean normal by itself.
        let along = (along - normal * normal.dot(along)).normalize_or(q[0] * b);
        let frame = [normal, along, normal.cross(along)];
        let mut points = Points {
            frame,
            at: [[0.0; 3]; 4],
            velocity: [[0.0; 3]; 4],
            arms: Some([[Vec3::ZERO; 2]; 4]),
        };
        let mut arms = [[Vec3::ZERO; 2]; 4];
        for (p, arms) in arms.iter_mut().enumerate() {
            let offset = place(class, p);
            let start = class.arms.map(|a| a + offset);
            let now = [q[0] * start[0], q[1] * start[1]];
            // Places at the start cancel in the gap. Taken as differences of
            // places it would lose digits far from the origin.
            let moved = [0, 1].map(|k| self.bodies.displacement(blocks[k]) + (now[k] - start[k]));
            let gap = moved[1] - moved[0];
            // Both sides act at one point in space, the middle: else opposite forces
            // across a gap would be a couple from nothing.
            *arms = [now[0] + 0.5 * gap, now[1] - 0.5 * gap];
            let speed = [0, 1].map(|k| {
                self.bodies.velocity(blocks[k]) + self.bodies.spin(blocks[k]).cross(arms[k])
            });
            points.at[p] = frame.map(|e| e.dot(gap));
            points.velocity[p] = frame.map(|e| e.dot(speed[1] - speed[0]));
        }
        points.arms = Some(arms);
        points
    }
}

/// Place of point `p` relative to the patch centre at the start, m.
#[must_use]
pub(crate) fn place(class: &PatchClass, p: usize) -> Vec3 {
    SIGNS[0][p] * class.half_spacing[0] * class.frame[1]
        + SIGNS[1][p] * class.half_spacing[1] * class.frame[2]
}

/// Spreads the motion of the centre and the relative rotation over the four points, patch frame.
fn spread(class: &PatchClass, centre: Vec3, turn: Vec3) -> [[f64; 3]; 4] {
    let d = class.frame.map(|e| e.dot(centre));
    let w = class.frame.map(|e| e.dot(turn));
    std::array::from_fn(|p| {
        let (b, c) = (SIGNS[0][p] * class.half_spacing[0], SIGNS[1][p] * class.half_spacing[1]);
        [d[0] + w[1] * c - w[2] * b, d[1] - w[0] * c, d[2] + w[0] * b]
    })
}

impl Points {
    /// Places of point `p` from the centroids of i and j, m: one point in space for finite rotations, that of the start for small ones.
    #[must_use]
    pub(crate) fn arms(&self, class: &PatchClass, p: usize) -> [Vec3; 2] {
        self.arms.map_or_else(|| class.arms.map(|arm| arm + place(class, p)), |arms| arms[p])
    }

    /// Resultant of tractions (on i, patch frame) at the points.
    #[must_use]
    pub fn resultant(&self, class: &PatchClass, t: &[Traction; 4]) -> Resultant {
        let share = 0.25 * class.area;
        let global =
            |v: [f64; 3]| v[0] * self.frame[0] + v[1] * self.frame[1] + v[2] * self.frame[2];
        if let Some(arms) = &self.arms {
            let mut sum = Resultant::default();
            for (t, arms) in t.iter().zip(arms) {
                sum = sum.plus(&Resultant::at(share * global(*t), Vec3::ZERO, *arms));
            }
            return sum;
        }
        // All points share one frame and the arms of the centre: their sums need one product with each.
        let (mut force, mut moment) = ([0.0; 3], [0.0; 3]);
        for (p, t) in t.iter().enumerate() {
            let (b, c) = (SIGNS[0][p] * class.half_spacing[0], SIGNS[1][p] * class.half_spacing[1]);
            for k in 0..3 {
                force[k] += t[k];
            }
            moment[0] += b * t[2] - c * t[1];
            moment[1] += c * t[0];
            moment[2] -= b * t[0];
        }
        Resultant::at(share * global(force), share * global(moment), class.arms)
    }
}

/// Traction at the points at zero displacement: in-situ stress, linear over the patch.
#[must_use]
pub(crate) fn start(class: &PatchClass, prestress: Option<&Vec3>) -> [Traction; 4] {
    let Some(centre) = prestress else {
        return [[0.0; 3]; 4];
    };
    let mean = class.frame.map(|e| e.dot(*centre));
    std::array::from_fn(|p| {
        let (b, c) = (SIGNS[0][p] * class.half_spacing[0], SIGNS[1][p] * class.half_spacing[1]);
        std::array::from_fn(|k| mean[k] + b * class.slope[0][k] + c * class.slope[1][k])
    })
}

/// Memory of one patch, taken out of the lists and put back.
pub(crate) struct State<'a> {
    /// Bits of [`flag`].
    pub flags: &'a mut u16,
    /// Slip of the points, where the model has any.
    pub slip: Option<&'a mut [[f64; 4]; 2]>,
    /// Lift of the points, where the model has any.
    pub normal_offset: Option<&'a mut [f64; 4]>,
    /// Accumulated slip of the points, where the model has any.
    pub accumulated_slip: Option<&'a mut [f64; 4]>,
    /// What softening and roughness remember, where the model has any.
    pub wear: Option<&'a mut [[f64; 4]; 2]>,
}

/// Memories of the four points from the lists of a patch.
#[must_use]
pub(crate) fn memories(
    flags: u16,
    slip: Option<&[[f64; 4]; 2]>,
    normal_offset: Option<&[f64; 4]>,
    accumulated_slip: Option<&[f64; 4]>,
    wear: Option<&[[f64; 4]; 2]>,
) -> [Memory; 4] {
    std::array::from_fn(|p| Memory {
        slip: slip.map_or([0.0; 2], |s| [s[0][p], s[1][p]]),
        normal_offset: normal_offset.map_or(0.0, |l| l[p]),
        accumulated_slip: accumulated_slip.map_or(0.0, |l| l[p]),
        parted: wear.map_or(0.0, |w| w[0][p]),
        dilated: wear.map_or(0.0, |w| w[1][p]),
        broken: flags & flag::of(flag::BROKEN, p) != 0,
        open: flags & flag::of(flag::OPEN, p) != 0,
        sliding: flags & flag::of(flag::SLIDING, p) != 0,
    })
}

impl State<'_> {
    /// Memories of the four points.
    #[must_use]
    pub(crate) fn read(&self) -> [Memory; 4] {
        memories(
            *self.flags,
            self.slip.as_deref(),
            self.normal_offset.as_deref(),
            self.accumulated_slip.as_deref(),
            self.wear.as_deref(),
        )
    }

    /// Stores the memories.
    pub(crate) fn write(&mut self, memories: &[Memory; 4]) {
        // Bits of the patch as a whole (`FINITE`, `OFFSET`) are not the law's.
        let mut flags = *self.flags & !(flag::BROKEN | flag::OPEN | flag::SLIDING);
        for (p, m) in memories.iter().enumerate() {
            for (set, group) in
                [(m.broken, flag::BROKEN), (m.open, flag::OPEN), (m.sliding, flag::SLIDING)]
            {
                if set {
                    flags |= flag::of(group, p);
                }
            }
            if let Some(slip) = self.slip.as_deref_mut() {
                slip[0][p] = m.slip[0];
                slip[1][p] = m.slip[1];
            }
            if let Some(normal_offset) = self.normal_offset.as_deref_mut() {
                normal_offset[p] = m.normal_offset;
            }
            if let Some(accumulated_slip) = self.accumulated_slip.as_deref_mut() {
                accumulated_slip[p] = m.accumulated_slip;
            }
            if let Some(wear) = self.wear.as_deref_mut() {
                wear[0][p] = m.parted;
                wear[1][p] = m.dilated;
            }
        }
        *self.flags = flags;
    }
}

/// Tractions at the points of a patch, after its law has seen the motion of the last `elapsed` seconds; with
/// `frozen` memory the law is not asked.
#[must_use]
pub(crate) fn respond(
    joint: &JointLaw,
    class: &PatchClass,
    points: &Points,
    start: &[Traction; 4],
    elapsed: Option<f64>,
    state: &mut State,
) -> ([Traction; 4], Loss) {
    let springs = class.stiffness;
    let mut memory = state.read();
    let general = joint.law(springs);
    let (Some(strength), Some(elapsed)) = (&joint.strength, elapsed) else {
        return (carried(joint, class, points, start, &memory), Loss::default());
    };
    let slid = *state.flags;
    // The displacement of the step before is not kept; it has changed
    // by the velocity in between times the time since.
    let moved = points.velocity.map(|r| r.map(|v| v * elapsed));
    let mut each = |law: &dyn Fn(usize, &mut Memory) -> (Traction, Loss)| {
        let (mut t, mut loss) = ([[0.0; 3]; 4], Loss::default());
        for (p, memory) in memory.iter_mut().enumerate() {
            let (traction, lost) = law(p, memory);
            t[p] = traction;
            loss.friction += 0.25 * lost.friction;
            loss.fracture += 0.25 * lost.fracture;
        }
        (t, loss)
    };
    let result = match (joint.failure, &general) {
        (Failure::Point, None) => each(&|p, memory| {
            let (at, moved) = (&points.at[p], &moved[p]);
            face_joint::point(strength, springs, &start[p], at, moved, memory)
        }),
        (Failure::Point, Some(law)) => {
            each(&|p, memory| law.point(&start[p], &points.at[p], &moved[p], memory))
        }
        (Failure::Face, Some(law)) => {
            law.face(start, &points.at, &moved, class.half_spacing, &mut memory)
        }
        (Failure::Face, None) => face_joint::face(
            strength,
            springs,
            start,
            &points.at,
            &moved,
            class.half_spacing,
            &mut memory,
        ),
    };
    state.write(&memory);
    // A law that sees no motion takes all points for sticking.
    if elapsed == 0.0 {
        *state.flags |= flag::slide_on(slid, *state.flags);
    }
    result
}

/// Tractions at the points with the memory they have.
#[must_use]
pub(crate) fn carried(
    joint: &JointLaw,
    class: &PatchClass,
    points: &Points,
    start: &[Traction; 4],
    memory: &[Memory; 4],
) -> [Traction; 4] {
    let alone = joint.failure == Failure::Point;
    if let Some(law) = joint.law(class.stiffness) {
        // In the law of a face the tractions of its points hang together.
        return if alone {
            std::array::from_fn(|p| law.carried(&start[p], &points.at[p], &memory[p]))
        } else {
            law.carried_face(start, &points.at, memory)
        };
    }
    std::array::from_fn(|p| {
        face_joint::carried(class.stiffness, &start[p], &points.at[p], &memory[p], alone)
    })
}

/// Openings of the points (m), where the law is not plain.
#[must_use]
pub(crate) fn openings(
    joint: &JointLaw,
    class: &PatchClass,
    points: &Points,
    start: &[Traction; 4],
    memory: &[Memory; 4],
) -> Option<[f64; 4]> {
    let law = joint.law(class.stiffness)?;
    Some(if joint.failure == Failure::Point {
        std::array::from_fn(|p| law.opening_of(&start[p], &points.at[p], &memory[p]))
    } else {
        law.openings_of_face(start, &points.at, memory)
    })
}

/// Energy per area in the normal and in the shear spring of the points with the memory they have, J/m².
#[must_use]
pub(crate) fn stored(
    joint: &JointLaw,
    class: &PatchClass,
    points: &Points,
    start: &[Traction; 4],
    memory: &[Memory; 4],
) -> [[f64; 2]; 4] {
    if let Some(law) = joint.law(class.stiffness) {
        return if joint.failure == Failure::Point {
            std::array::from_fn(|p| law.energy(&start[p], &points.at[p], &memory[p]))
        } else {
            law.energy_of_face(start, &points.at, memory)
        };
    }
    carried(joint, class, points, start, memory).map(|t| {
        let normal = 0.5 * t[0] * t[0] / class.stiffness[0];
        [normal, face_joint::stored(class.stiffness, &t) - normal]
    })
}

/// Dashpot tractions at the closed points: `beta` (s) times spring times relative velocity, along the patch where its law has
/// them.
#[must_use]
pub(crate) fn dashpots(
    joint: &JointLaw,
    class: &PatchClass,
    points: &Points,
    beta: f64,
    flags: u16,
) -> [Traction; 4] {
    let springs = match joint.law(class.stiffness) {
        Some(law) => law.initial(),
        None => class.stiffness,
    };
    std::array::from_fn(|p| {
        if flags & flag::of(flag::OPEN, p) != 0 {
            return [0.0; 3];
        }
        let slides = flags & flag::of(flag::SLIDING, p) != 0;
        let along = match joint.dashpots {
            Dashpots::Sticking => !slides,
            Dashpots::Closed => true,
        };
        std::array::from_fn(|k| {
            if k == 0 || along { beta * springs[k.min(1)] * points.velocity[p][k] } else { 0.0 }
        })
    })
}

/// Bits of [`flag`] for the points of a patch that slide or open from the first instant. Only a point that has moved shows that it does,
/// and blocks may start with a speed: a dashpot would hold them back for the half step before.
///
/// It slides where spring and dashpot together would pass its strength. It opens where its blocks part and it has neither pressure nor
/// tensile strength.
#[must_use]
pub(crate) fn starts_moving(
    joint: &JointLaw,
    class: &PatchClass,
    points: &Points,
    start: &[Traction; 4],
    beta: f64,
) -> u16 {
    let Some(strength) = &joint.strength else {
        return 0;
    };
    let dashpots = dashpots(joint, class, points, beta, 0);
    // A point that is pressed at the start opens later, if at all, and shows it then.
    let parts = |p: &usize| start[*p][0] == 0.0 && points.velocity[*p][0] > 0.0;
    let opens = |p: &usize| {
        strength.tension == 0.0
            && match joint.failure {
                Failure::Point => parts(p),
                Failure::Face => (0..4).all(|p| parts(&p)),
            }
    };
    let slides = |p: &usize| {
        let limit = match joint.law(class.stiffness) {
            Some(law) => law.first_limit(start[*p][0]),
            None => strength.peak(start[*p][0]),
        };
        let [b, c] = [1, 2].map(|k| start[*p][k] + dashpots[*p][k]);
        joint.dashpots == Dashpots::Sticking && b * b + c * c > limit * limit
    };
    (0..4).fold(0, |bits, p| {
        let more = if opens(&p) {
            flag::of(flag::OPEN, p) | flag::of(flag::BROKEN, p)
        } else if slides(&p) {
            flag::of(flag::SLIDING, p)
        } else {
            0
        };
        bits | more
    })
}

/// Law of a class.
#[must_use]
pub(crate) fn joint<'a>(interfaces: &'a [InterfaceLaw], class: &PatchClass) -> &'a JointLaw {
    &interfaces[class.row as usize].joint
}

/// Inertia tensor of a turned block, kg m².
#[must_use]
pub(crate) fn turned_inertia(inertia: &Mat3, attitude: Quat) -> Mat3 {
    let r = Mat3::from_quat(attitude);
    r * *inertia * r.transpose()
}
