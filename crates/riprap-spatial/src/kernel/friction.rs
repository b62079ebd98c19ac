//! From the sums over the surface to forces: pressure, dashpots, friction along the surface and against spinning about it.
//!
//! The contact carries a shear force and a torsion about its normal as springs on its area. Both slide together when they reach what Coulomb's
//! law at every point of the surface allows, and along the slip that belongs to it (`limit`). Dashpots across the contact and against rocking act on the
//! pressure, those along it only while it sticks. Surfaces of a block on a ridge share those across, see [`share`].
//!
//! Deviation: the couple of the dashpots against rocking follows the second moments of the area about each axis instead of half
//! the polar one.
//!
//! Source: limit surface of Goyal, Ruina and Papadopoulos (1991), integrated exactly.

use riprap_geom::{Mat3, Vec3};
use serde::{Deserialize, Serialize};

use crate::kernel::offset;
use crate::kernel::offset::Offset;
use crate::kernel::springs::{shrunk, stored, turned};
use crate::kernel::sums::Sums;
use crate::laws::mohr_coulomb::shear_limit;

mod limit;
mod shared;

use limit::Limit;
pub(crate) use limit::Pieces;
pub(crate) use shared::{Pressing, Shared, pressing, share};

/// Below this share of |S_F| over the integral of the depth, opposite pressures cancel and there is no one normal.
const CANCELLED: f64 = 0.05;
/// Overlaps less deep than this, times the radius of the smaller block, have no direction that can be trusted.
const LOST: f64 = 1e-14;

/// Stiffness of the springs along a contact that sticks, over the negative one of its pressure: what slides needs the friction to be overcome, less
/// one part of this.
const HOLD: f64 = 8.0;
/// The springs along a contact are no stiffer than this, times its normal stiffness.
const STIFFEST: f64 = 100.0;

/// Parameters of a contact.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct ContactLaw {
    /// Normal stiffness kn, Pa/m: force over area and depth of a flat contact.
    pub normal_stiffness: f64,
    /// Shear stiffness ks, Pa/m.
    pub shear_stiffness: f64,
    /// Tangent of the friction angle.
    pub friction: f64,
    /// Cohesion on the contact area, Pa.
    pub cohesion: f64,
    /// Share of critical damping.
    pub damping_ratio: f64,
    /// Speed after an impact over that before it, in implicit steps.
    pub rebound: f64,
    /// How fast pressures grow beyond the depth, `1/D²`, 1/m²: twice the pressure at the depth D; 0: they do not (`stiffening`).
    pub growth: f64,
}

impl ContactLaw {
    /// The same with another normal and shear stiffness, Pa/m.
    #[must_use]
    pub fn with_stiffness(self, [normal_stiffness, shear_stiffness]: [f64; 2]) -> Self {
        Self { normal_stiffness, shear_stiffness, ..self }
    }

    /// The law of a part of a surface with this share of its area: all parts together have the dashpot of one contact of the whole, spread
    /// evenly over it.
    #[must_use]
    pub fn part(self, share: f64) -> Self {
        Self {
            // c = 2 xi sqrt(k A m): with a share s of the area and sqrt(s) of the ratio a part has the share s of c.
            damping_ratio: self.damping_ratio * share.sqrt(),
            ..self
        }
    }

    /// Negative stiffness along a contact, over the normal one, from which its springs have to be stiffer than their law says to hold it; `None` where
    /// no springs hold.
    #[must_use]
    pub fn least_falling(&self) -> Option<f64> {
        let holds = self.shear_stiffness > 0.0 && (self.friction > 0.0 || self.cohesion > 0.0);
        holds.then(|| self.shear_stiffness / (HOLD * self.normal_stiffness))
    }

    /// Dashpot of a contact of an area (m²) between blocks of this reduced mass (kg) along a stiffness (Pa/m), N s/m, that acts on the velocity
    /// half a step of `dt` (s) ago.
    ///
    /// With `c` itself that is a dashpot on the velocity of now and a mass less by `c dt/2`: too much damping. `c/(1 + c dt/(4 m))` has the
    /// share of critical damping asked for, to the second order of the step, and takes no longer steps to be stable.
    fn dashpot(&self, stiffness: f64, area: f64, mass: f64, dt: f64) -> f64 {
        let c = 2.0 * self.damping_ratio * (stiffness * area * mass).sqrt();
        if mass > 0.0 { c / (1.0 + 0.25 * c * dt / mass) } else { c }
    }
}

/// What a contact remembers from step to step.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Memory {
    /// Shear force on B, N.
    pub shear: Vec3,
    /// Torsion on B about the normal, N m.
    pub torsion: f64,
    /// Unit normal of the last step, from A to B; zero before the first.
    pub normal: Vec3,
    /// Area of the last step that its springs stand for, m²: more than its own where its pressure falls along it.
    pub area: f64,
    /// Polar second moment of that area, m⁴.
    pub polar: f64,
    /// Whether it slid in the last step.
    pub sliding: bool,
    /// Point of the last step from the centroids of A and B, m.
    pub arms: [Vec3; 2],
}

impl Memory {
    /// Work done on the springs in half a step of `dt` with these velocities and the forces they have, J. Both halves of a step,
    /// each with its own forces, are the trapezoid that the ledger books.
    #[must_use]
    pub fn work(&self, motion: &[Motion; 2], dt: f64) -> f64 {
        let [a, b] = motion;
        let velocity =
            (b.velocity + b.spin.cross(self.arms[1])) - (a.velocity + a.spin.cross(self.arms[0]));
        let twist = (b.spin - a.spin).dot(self.normal);
        -0.5 * dt * (self.shear.dot(velocity) + self.torsion * twist)
    }

    /// Energy in shear springs of this stiffness (Pa/m), J.
    #[must_use]
    pub fn stored(&self, stiffness: f64) -> f64 {
        stored(stiffness, self.shear, self.torsion, [self.area, self.polar])
    }
}

/// Motion of a block.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Motion {
    /// Velocity of its centroid, m/s.
    pub velocity: Vec3,
    /// Spin, rad/s.
    pub spin: Vec3,
    /// 1 over its mass, 1/kg; 0 for a block that no contact can move.
    pub inverse_mass: f64,
}

/// Force and moment on B; A gets the opposite force at the same point.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Wrench {
    /// Force on B, N.
    pub force: Vec3,
    /// Moment on A about its centroid, N m.
    pub moment_a: Vec3,
    /// Moment on B about its centroid, N m.
    pub moment_b: Vec3,
}

impl Wrench {
    /// The same, `by` times as large.
    #[must_use]
    pub fn times(&self, by: f64) -> Self {
        Self { force: by * self.force, moment_a: by * self.moment_a, moment_b: by * self.moment_b }
    }

    /// Power on the first and second body with these motions, W.
    #[must_use]
    pub fn power(&self, [a, b]: &[Motion; 2]) -> f64 {
        self.force.dot(b.velocity - a.velocity)
            + self.moment_a.dot(a.spin)
            + self.moment_b.dot(b.spin)
    }

    /// Both together.
    #[must_use]
    pub fn plus(&self, other: &Self) -> Self {
        Self {
            force: self.force + other.force,
            moment_a: self.moment_a + other.moment_a,
            moment_b: self.moment_b + other.moment_b,
        }
    }
}

/// The answer of a contact.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct ContactOutput {
    /// Everything together.
    pub wrench: Wrench,
    /// The pressure alone.
    pub elastic: Wrench,
    /// The shear springs alone.
    pub spring: Wrench,
    /// What goes on of a joint's load.
    pub offset: Wrench,
    /// What the contact stores across itself beyond what its forces have taken up in this step, J: the energy of a joint where it has
    /// just taken over from it, and the difference to its own law where what the joint had left has ended.
    pub booked: f64,
    /// Energy of the shear springs as they were when this step began: where a joint has let go, about the point of the pressure, J.
    pub sprung: f64,
    /// All dashpots.
    pub drag: Wrench,
    /// Normal force, N: pressure and dashpot, never negative.
    pub normal: f64,
    /// Shear force on B, N: spring and dashpot.
    pub shear: Vec3,
    /// Heat of friction in this step, J.
    pub friction: f64,
    /// Change of the energy in the shear springs in this step, J.
    pub stored: f64,
    /// Power of all dashpots at the velocities given, W; never positive but for round-off.
    pub damping: f64,
    /// Where the resultant acts, m.
    pub point: Vec3,
    /// Area across the normal, m².
    pub area: f64,
    /// Polar second moment of the area about the point, m⁴.
    pub polar: f64,
}

/// Lever arms and geometry of a contact at this instant.
struct Contact {
    /// Unit normal from A to B.
    normal: Vec3,
    /// Elastic normal force, N.
    elastic: f64,
    /// Point from the origin of the planes, m.
    point: Vec3,
    area: f64,
    polar: f64,
    /// Second moments of the area about its own centre, m⁴.
    spread: Mat3,
    /// Squared radius of gyration of the pressure, m².
    gyration: f64,
    /// Stiffness of the springs along it over that of the law, at least 1.
    hold: f64,
}

/// What the law is asked.
#[derive(Clone, Copy)]
pub struct ContactInput<'a> {
    /// Sums over the surface.
    pub sums: &'a Sums,
    /// Shows the pieces of the surface that rub; asked only near slip.
    pub pieces: &'a Pieces<'a>,
    /// Origin of the planes in space, m.
    pub origin: Vec3,
    /// Centroids of A and B, m.
    pub centres: [Vec3; 2],
    /// Motion of A and B, half a step ago.
    pub motion: [Motion; 2],
    /// Radius of the smaller block, m.
    pub radius: f64,
    /// Time since the last evaluation, s; 0 when nothing has moved: then the memory stays as it is.
    pub dt: f64,
    /// Length of the last step, s: velocities belong to half of it ago.
    pub last_dt: f64,
    /// What dashpots across add to the pressure, over it, where the surface shares them with others ([`Shared::ratio`]); `None`: it has its
    /// own.
    pub shared: Option<f64>,
    /// Negative stiffness of the pressure along the surface, over the normal stiffness of the law, m².
    pub falls: f64,
}

/// A contact, what moves in it and what resists.
struct Meeting {
    contact: Contact,
    /// Where the pressure acts, m.
    at: Vec3,
    /// From the centroids of A and B to there, m.
    arms: [Vec3; 2],
    velocity: Relative,
    /// Reduced mass, kg.
    mass: f64,
}

/// Velocities across and along the contact.
struct Relative {
    normal: f64,
    along: Vec3,
    twist: f64,
    rock: Vec3,
}

/// What goes on of a joint's load beside the pressure.
struct Inherited {
    wrench: Wrench,
    /// Normal force with that of the pressure, N.
    pressed: f64,
    /// See [`ContactOutput::booked`], J.
    booked: f64,
}

/// Forces of a contact; `memory` goes on to this instant.
///
/// The friction of a step is the work on the shear springs less the change of what they store; springs that a shrinking
/// contact loses take their share with them, which is friction too. `offset` is what remains of a joint that has been released; it is
/// removed where nothing remains of it.
pub(crate) fn contact_force(
    law: &ContactLaw,
    q: &ContactInput,
    memory: &mut Memory,
    offset: &mut Option<Box<Offset>>,
) -> ContactOutput {
    let k = 2.0 * law.normal_stiffness;
    let elastic = wrench(q, k * q.sums.force, k * q.sums.moment);
    let mut work = memory.work(&q.motion, q.dt);
    let Some(meeting) = meeting(law, q) else {
        let lost = memory.stored(law.shear_stiffness);
        let booked = part(offset.take(), &q.motion, memory, q.dt);
        *memory = Memory::default();
        return ContactOutput {
            wrench: elastic,
            elastic,
            booked,
            sprung: lost,
            friction: work + lost,
            stored: -lost,
            point: q.origin,
            ..ContactOutput::default()
        };
    };
    let inherited = inherited_force(law, q, &meeting, &elastic, memory, offset);
    let Meeting { contact: c, at, arms, velocity: v, mass } = meeting;
    let pressed = inherited.pressed;
    let across = law.dashpot(law.normal_stiffness, c.area, mass, q.last_dt);
    let (normal, rocking) = if let Some(ratio) = q.shared {
        (pressed * (1.0 + ratio), Vec3::ZERO)
    } else {
        let normal = (pressed - across * v.normal).max(0.0);
        (normal, against_rocking(across, &c, &v, normal))
    };
    let cohesion = law.cohesion * c.area;
    let limit = Limit::new(
        [shear_limit(cohesion, law.friction, -normal), cohesion],
        &c,
        q,
        (v.along, v.twist),
    );
    let before = memory.stored(law.shear_stiffness);
    // Found for the first time without a move (at the start, after an edit), it still has to learn where it is.
    if q.dt > 0.0 || memory.normal == Vec3::ZERO {
        let [a, b] = q.motion;
        let turning = 0.5 * (a.spin + b.spin).dot(c.normal) * q.dt;
        memory.arms = arms;
        advance(law, memory, &v, [q.dt, turning], &limit);
    }
    work += memory.work(&q.motion, q.dt);
    let (mut shear, mut torsion) = (memory.shear, memory.torsion);
    if !memory.sliding {
        let along = law.dashpot(law.shear_stiffness, c.hold * c.area, mass, q.last_dt);
        shear -= along * v.along;
        torsion -= along * c.polar / c.area * v.twist;
        // Only this answer is cut: the springs are within the limit, and keep what they have.
        limit.hold(&mut shear, &mut torsion);
    }
    let stored = memory.stored(law.shear_stiffness);
    let spring = about(arms, memory.shear, memory.torsion * c.normal);
    let (damped, held) = (shear - memory.shear, torsion - memory.torsion);
    let drag = about(arms, (normal - pressed) * c.normal + damped, rocking + held * c.normal);
    ContactOutput {
        wrench: elastic.plus(&spring).plus(&inherited.wrench).plus(&drag),
        elastic,
        spring,
        offset: inherited.wrench,
        booked: inherited.booked,
        sprung: before,
        drag,
        normal,
        shear,
        friction: work - (stored - before),
        stored: stored - before,
        damping: (normal - pressed) * v.normal
            + rocking.dot(v.rock)
            + damped.dot(v.along)
            + held * v.twist,
        point: at,
        area: c.area,
        polar: c.polar,
    }
}

/// Takes what remains of a joint to this instant; the shear of one that has just been released moves to the point of the contact.
fn inherited_force(
    law: &ContactLaw,
    q: &ContactInput,
    meeting: &Meeting,
    elastic: &Wrench,
    memory: &mut Memory,
    offset: &mut Option<Box<Offset>>,
) -> Inherited {
    let Meeting { contact: c, at, arms, velocity, .. } = meeting;
    let [a, b] = q.motion;
    let mut found = Inherited { wrench: Wrench::default(), pressed: c.elastic, booked: 0.0 };
    if let Some(offset) = offset {
        offset.pass(&q.motion, memory.arms, q.dt);
        if let Some(joint) = offset.joint {
            // The shear of the joint acted at its own point.
            memory.torsion += (joint.at - *at).cross(memory.shear).dot(c.normal);
        }
        let here = offset::Here {
            normal: c.normal,
            elastic: c.elastic,
            pressure: [elastic.force, elastic.moment_b - arms[1].cross(elastic.force)],
            energy: energy(law, q.sums, c),
            overlap: q.sums.force.length(),
            point: *at,
            area: c.area,
            sliding: velocity.along.length(),
            turning: c.normal.cross(b.spin - a.spin).length(),
            before: memory.normal,
        };
        found.booked = offset.advance(&here, q.dt);
        offset.pass(&q.motion, *arms, q.dt);
        found.wrench = about(*arms, offset.force, offset.couple);
        found.pressed += offset.force.dot(c.normal);
    }
    if let Some(gone) = offset.take_if(|offset| offset.is_gone(c.area)) {
        found.booked += energy(law, q.sums, c) - gone.stored;
    }
    found
}

/// Couple of dashpots `across` (N s/m) spread evenly over the area. Half its polar moment for both axes would be many times too much about
/// the long axis of a narrow contact, and unstable.
fn against_rocking(across: f64, c: &Contact, v: &Relative, normal: f64) -> Vec3 {
    let uneven = (c.spread * c.normal.cross(v.rock)).cross(c.normal);
    let couple = -(across / c.area) * uneven;
    // A pressure that nowhere pulls acts within the contact: on a rectangle half its length off the middle at most.
    let aside = couple.cross(c.normal).normalize_or_zero();
    let reach = (3.0 * aside.dot(c.spread * aside).max(0.0) / c.area).sqrt();
    shorten(couple, normal * reach)
}

fn meeting(law: &ContactLaw, q: &ContactInput) -> Option<Meeting> {
    let contact = contact(law, q)?;
    let at = q.origin + contact.point;
    let arms = q.centres.map(|centre| at - centre);
    let inverse: f64 = q.motion.iter().map(|m| m.inverse_mass).sum();
    Some(Meeting {
        velocity: relative(&contact, q.motion, midway(arms, q.motion, q.last_dt)),
        contact,
        at,
        arms,
        mass: if inverse > 0.0 { 1.0 / inverse } else { 0.0 },
    })
}

/// Force and couple on B at a point with these arms from the centroids.
fn about(arms: [Vec3; 2], force: Vec3, couple: Vec3) -> Wrench {
    Wrench {
        force,
        moment_a: -(arms[0].cross(force) + couple),
        moment_b: arms[1].cross(force) + couple,
    }
}

/// Ends what a joint has left where its blocks have parted, or where there is no contact with one normal any more, after the last half
/// step; what is to be booked, J (see [`ContactOutput::booked`]).
pub(crate) fn part(
    offset: Option<Box<Offset>>,
    motion: &[Motion; 2],
    memory: &Memory,
    dt: f64,
) -> f64 {
    offset.map_or(0.0, |mut offset| {
        offset.pass(motion, memory.arms, dt);
        -offset.stored
    })
}

/// Energy of the pressure of a plane contact, J.
fn energy(law: &ContactLaw, s: &Sums, c: &Contact) -> f64 {
    if law.growth > 0.0 {
        return 2.0 * law.normal_stiffness * s.stored;
    }
    let centre = s.area_first / s.area;
    let second = spread(s, centre);
    let eccentricity = c.point - centre;
    offset::energy(law.normal_stiffness, c.elastic, c.area, eccentricity, &second, c.normal)
}

/// Arms of the contact half a step ago, when the blocks had these velocities. With those of now two blocks that turn together about a point
/// far away would slide on each other by half a step of their centripetal acceleration, and creep inwards for ever.
fn midway(arms: [Vec3; 2], motion: [Motion; 2], dt: f64) -> [Vec3; 2] {
    let [a, b] = [0, 1].map(|s| motion[s].velocity + motion[s].spin.cross(arms[s]));
    let point = 0.5 * (a + b);
    [0, 1].map(|s| arms[s] - 0.5 * dt * (point - motion[s].velocity))
}

fn relative(c: &Contact, [a, b]: [Motion; 2], arms: [Vec3; 2]) -> Relative {
    let velocity = (b.velocity + b.spin.cross(arms[1])) - (a.velocity + a.spin.cross(arms[0]));
    let spin = b.spin - a.spin;
    let (normal, twist) = (velocity.dot(c.normal), spin.dot(c.normal));
    Relative { normal, along: velocity - normal * c.normal, twist, rock: spin - twist * c.normal }
}

/// Turns, shrinks and loads the shear springs and lets them slide.
fn advance(
    law: &ContactLaw,
    memory: &mut Memory,
    v: &Relative,
    [dt, turning]: [f64; 2],
    limit: &Limit,
) {
    let c = limit.contact;
    // First with the contact, then less what has opened: only then the
    // way of this step is one along the contact of now.
    let shear = turned(memory.shear, [memory.normal, c.normal], turning);
    let torsion = memory.torsion;
    let (area, polar) = (c.hold * c.area, c.hold * c.polar);
    memory.shear = shear * shrunk(memory.area, area) - law.shear_stiffness * area * dt * v.along;
    memory.torsion =
        torsion * shrunk(memory.polar, polar) - law.shear_stiffness * polar * dt * v.twist;
    memory.sliding = limit.hold(&mut memory.shear, &mut memory.torsion);
    memory.normal = c.normal;
    memory.area = area;
    memory.polar = polar;
}

fn wrench(q: &ContactInput, force: Vec3, moment: Vec3) -> Wrench {
    Wrench {
        force,
        moment_a: -(moment + (q.origin - q.centres[0]).cross(force)),
        moment_b: moment + (q.origin - q.centres[1]).cross(force),
    }
}

/// `None` where the surface has no one normal: opposite pressures that cancel, or a touch lost in round-off.
fn contact(law: &ContactLaw, q: &ContactInput) -> Option<Contact> {
    let s = q.sums;
    let normal = s.normal(CANCELLED).filter(|_| s.depth >= LOST * q.radius)?;
    // The vector area: no approach is resisted by more than kn times it, also where the surface bends about an edge.
    let area = s.across(s.vector_area, normal);
    let point = s.weight_first / s.weight;
    let about = spread(s, point);
    let polar = about.x_axis.x + about.y_axis.y + about.z_axis.z;
    let gyration = s.weight_second / s.weight - point.length_squared();
    // Written so that a NaN is no contact either.
    if !(area > 0.0 && polar > 0.0 && gyration > 0.0) {
        return None;
    }
    Some(Contact {
        normal,
        elastic: 2.0 * law.normal_stiffness * s.across(s.force, normal).max(0.0),
        point,
        area,
        polar,
        spread: spread(s, s.area_first / s.area),
        gyration,
        hold: hold(law, q.falls / area),
    })
}

/// Stiffness of the springs along a contact over that of the law, from the negative stiffness of the pressure along it over the normal one.
///
/// Edges and tips that stick to each other must not slip past while friction holds them: the springs outweigh the pressure, which
/// pushes aside (`lateral`). What has less negative stiffness than that keeps the springs of the law to the last bit.
pub(crate) fn hold(law: &ContactLaw, falls: f64) -> f64 {
    if falls > 0.0 && law.shear_stiffness > 0.0 {
        (HOLD * falls).min(STIFFEST) * law.normal_stiffness / law.shear_stiffness
    } else {
        1.0
    }
    .max(1.0)
}

/// Second moments of the area about a point, `int (x - point)(x - point)ᵀ dS`, m⁴.
fn spread(s: &Sums, point: Vec3) -> Mat3 {
    let outer = |a: Vec3, b: Vec3| Mat3::from_cols(b.x * a, b.y * a, b.z * a);
    let [x, y, z] = s.area_second;
    Mat3::from_cols(x, y, z) - outer(s.area_first, point) - outer(point, s.area_first)
        + s.area * outer(point, point)
}

fn shorten(v: Vec3, longest: f64) -> Vec3 {
    let length = v.length();
    if length > longest { v * (longest / length) } else { v }
}

#[cfg(test)]
mod tests;
