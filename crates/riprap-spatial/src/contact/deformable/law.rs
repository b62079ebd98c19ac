//! Friction, torsion and dashpots of a contact between blocks of cells.
//!
//! As between rigid blocks (`found::friction`): a shear force and a torsion about the normal are springs on the area of the contact, and slide
//! together where Coulomb's law at every point lets them (`found::slip`). They act at **spots**, the centres of pressure of the pieces
//! of the surface of equal depth, with the shape functions of both cells there: opposite forces in the same points, so momentum and
//! angular momentum stay, and the velocities that belong to shear and torsion are the means over the spots with the same weights.
//!
//! Deviations: the points of Coulomb's law are the spots, each as wide as what they leave of the spread of the pressure, with a mean radius of
//! all of [`MEAN_RADIUS`] times the radius of gyration (0.866 for a line, 0.943 for a disc, 0.937 for a square); dashpots are tuned to the masses that the contact moves at once, those of the nodes, not to whole blocks; those across the
//! contact act spot by spot, which damps rocking too; those along it act while springs and dashpots together are within the ellipse, and not at all
//! beyond it, where between rigid blocks both are shrunk onto it.

use riprap_geom::Vec3;

use crate::kernel::ContactLaw;
use crate::kernel::cells::{CellPatch, Member, PairSlot, Spot};
use crate::kernel::slip::{Rub, Rubs, Three, hold};
use crate::kernel::springs::{shrunk, turned};
use crate::laws::mohr_coulomb::shear_limit;
use crate::state::bodies::Bodies;
use crate::state::deform::Deform;
use crate::state::deformable::{DeformableContact, DeformableMemory};
use crate::state::workspace::Workspace;

/// Mean radius of the pressure over its radius of gyration.
const MEAN_RADIUS: f64 = 0.93;
/// Moments below this share of the largest one do not turn the slip.
const NO_MOMENT: f64 = 1e-9;
/// Least square of the width of a spot over that of the radius of gyration: none is a point, at which friction would jump.
const LEAST_WIDTH: f64 = 1e-3;
/// Below this share of the force over the sum of the pressure, opposite pressures cancel and there is no one normal.
const CANCELLED: f64 = 0.05;
/// Overlaps less deep than this times the root of their area have no direction that can be trusted.
const LOST: f64 = 1e-13;
/// Spots nearer together than this share of the radius of gyration carry no torsion.
const TOGETHER: f64 = 1e-3;

/// The blocks of a contact and how they move.
#[derive(Clone, Copy)]
pub(super) struct Sides<'a> {
    pub(super) deform: &'a Deform,
    pub(super) bodies: &'a Bodies,
    pub(super) work: &'a Workspace,
    pub(super) members: [&'a Member; 2],
}

impl Sides<'_> {
    /// Hands out the nodes of a deformable block with their shares in what acts at a point of a cell.
    fn share(&self, body: u32, cell: u32, weights: &[f64; 4], to: impl FnMut(u32, f64)) {
        let body = &self.deform.bodies[body as usize];
        self.work.class(body).depths().share(cell, weights, to);
    }

    /// Adds a force (N) at a point of a cell, `arm` (m) from the centre of the block, to those on a side.
    pub(super) fn add(
        &self,
        side: usize,
        forces: &mut [Vec3],
        cell: u32,
        weights: &[f64; 4],
        arm: Vec3,
        force: Vec3,
    ) {
        match self.members[side].body {
            Some(body) => self.share(body, cell, weights, |node, weight| {
                forces[node as usize] += weight * force;
            }),
            None => {
                forces[0] += force;
                forces[1] += arm.cross(force);
            }
        }
    }

    /// Velocity of a side at a spot half a step ago, m/s.
    fn velocity(&self, side: usize, spot: &Spot) -> Vec3 {
        let member = self.members[side];
        match member.body {
            Some(body) => {
                let first = self.deform.bodies[body as usize].first;
                let rates = &self.deform.nodes.velocity;
                let mut sum = Vec3::ZERO;
                self.share(body, spot.cells[side], &spot.weights[side], |node, weight| {
                    sum += weight * Vec3::from_array(rates[(first + node) as usize]);
                });
                sum
            }
            None => {
                let b = member.block as usize;
                self.bodies.velocity(b) + self.bodies.spin(b).cross(spot.arms[side])
            }
        }
    }

    /// Velocity of the second block against the first at a spot, m/s.
    pub(super) fn relative_velocity(&self, spot: &Spot) -> Vec3 {
        self.velocity(1, spot) - self.velocity(0, spot)
    }
}

/// What a pair is asked.
pub(super) struct Asked<'a> {
    pub(super) sides: Sides<'a>,
    /// Whether its contacts are those with facets of terrain.
    pub(super) facets: bool,
    /// Time since the last evaluation, s.
    pub(super) dt: f64,
}

/// The answer of all contacts of a pair.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct ContactOutput {
    /// Energy in the springs along the contacts, J.
    pub(super) stored: f64,
    /// Work against these springs in the half step before, J.
    pub(super) friction: f64,
    /// Work against dashpots in the half step before, J.
    pub(super) damping: f64,
}

/// Geometry and motion of a contact.
struct Contact {
    normal: Vec3,
    /// Sum of the pressure over the spots, N.
    pressure: f64,
    point: Vec3,
    area: f64,
    polar: f64,
    /// Square of the radius of gyration of the pressure, m².
    gyration: f64,
    /// Sum over the spots of pressure times the square of the distance from the point, N m²; 0 where they carry no torsion.
    moment: f64,
    /// Velocity of the second block against the first, m/s.
    velocity: Vec3,
    /// Spin of the second block against the first about the normal, and mean of both, rad/s.
    twist: [f64; 2],
}

impl Contact {
    /// Arm of a spot about the normal, turned by 90 degrees: what a spin of one moves the spot by, m.
    fn lever(&self, spot: &Spot) -> Vec3 {
        self.normal.cross(spot.arms[0] - self.point)
    }

    /// Share of a spot in a shear force and a torsion.
    fn share(&self, spot: &Spot, shear: Vec3, torsion: f64) -> Vec3 {
        let mut force = spot.pressure / self.pressure * shear;
        if self.moment > 0.0 {
            force += torsion * spot.pressure / self.moment * self.lever(spot);
        }
        force
    }

    /// `None` where the surface has no one normal.
    fn new(sides: &Sides, patch: &CellPatch, spots: &[Spot]) -> Option<Self> {
        let s = &patch.surface;
        let pressure: f64 = spots.iter().map(|spot| spot.pressure).sum();
        let (length, area) = (patch.elastic.length(), s.vector.length());
        // Written so that a NaN is no contact either.
        if !(pressure > 0.0 && length > CANCELLED * pressure && area > 0.0)
            || s.depth < LOST * area.sqrt()
        {
            return None;
        }
        let point = s.weight_first / s.weight;
        let polar = s.area_second - 2.0 * point.dot(s.area_first) + point.length_squared() * s.area;
        let gyration = s.weight_second / s.weight - point.length_squared();
        if !(polar > 0.0 && gyration > 0.0) {
            return None;
        }
        let mut contact = Self {
            normal: patch.elastic / length,
            pressure,
            point,
            area,
            polar,
            gyration,
            moment: 0.0,
            velocity: Vec3::ZERO,
            twist: [0.0; 2],
        };
        let (mut moment, mut spins) = (0.0, [0.0; 2]);
        for spot in spots {
            let lever = contact.lever(spot);
            let two = [0, 1].map(|side| sides.velocity(side, spot));
            contact.velocity += spot.pressure / pressure * (two[1] - two[0]);
            moment += spot.pressure * lever.length_squared();
            for (spin, v) in spins.iter_mut().zip(two) {
                *spin += spot.pressure * lever.dot(v);
            }
        }
        if moment > TOGETHER * TOGETHER * gyration * pressure {
            contact.moment = moment;
            let [a, b] = spins.map(|s| s / moment);
            contact.twist = [b - a, 0.5 * (a + b)];
        }
        Some(contact)
    }
}

/// 1 over the mass that a force shared out over the spots of a pair moves at once, 1/kg.
fn ease(sides: &Sides, spots: &[Spot], shares: &mut [Vec<f64>; 2]) -> f64 {
    let pressure: f64 = spots.iter().map(|spot| spot.pressure).sum();
    let mut sum = 0.0;
    for (side, shares) in shares.iter_mut().enumerate() {
        let member = sides.members[side];
        let Some(body) = member.body else {
            sum += member.ease;
            continue;
        };
        let own = &sides.deform.bodies[body as usize];
        shares.clear();
        shares.resize(own.count as usize, 0.0);
        for spot in spots {
            sides.share(body, spot.cells[side], &spot.weights[side], |node, weight| {
                shares[node as usize] += weight * spot.pressure / pressure;
            });
        }
        let masses = sides.work.class(own).masses();
        let parts = shares.iter().zip(masses).map(|(w, m)| w * w / m);
        sum += parts.sum::<f64>();
    }
    sum
}

/// Dashpots of a pair.
struct Dashpots {
    ratio: f64,
    /// The mass that they are tuned to, kg; not finite between blocks that nothing can move.
    mass: f64,
    /// Area across the normals of all contacts, m².
    whole: f64,
}

impl Dashpots {
    /// Dashpot of an area (m²) along a stiffness (Pa/m), N s/m: those of all contacts together are that of one contact of the whole, spread
    /// evenly over it.
    fn of(&self, stiffness: f64, area: f64) -> f64 {
        if self.ratio > 0.0 && self.mass.is_finite() {
            let ratio = self.ratio * (area / self.whole).sqrt();
            2.0 * ratio * (stiffness * area * self.mass).sqrt()
        } else {
            0.0
        }
    }

    /// Normal of the dashpots across a contact, with those that it shares them with, and their rate over the pressure, s/m.
    fn across(
        &self,
        law: &ContactLaw,
        patches: &[CellPatch],
        spots: &[Spot],
        ridge: usize,
    ) -> (Vec3, f64) {
        let (mut elastic, mut vector, mut pressure) = (Vec3::ZERO, Vec3::ZERO, 0.0);
        for patch in patches.iter().filter(|patch| patch.ridge == ridge) {
            elastic += patch.elastic;
            vector += patch.surface.vector;
            pressure += spots[patch.spots.clone()].iter().map(|s| s.pressure).sum::<f64>();
        }
        let length = elastic.length();
        if length > CANCELLED * pressure {
            (elastic / length, self.of(law.normal_stiffness, vector.length()) / pressure)
        } else {
            (Vec3::ZERO, 0.0)
        }
    }
}

/// Finds which facets of terrain share their dashpots across, as `kernel::ridges` does for rigid blocks: those between which the ground is convex.
fn find_ridges(patches: &mut [CellPatch], facets: bool) {
    for (k, patch) in patches.iter_mut().enumerate() {
        patch.ridge = k;
    }
    if !facets {
        return;
    }
    for k in 1..patches.len() {
        for other in 0..k {
            let two = [k, other].map(|k| &patches[k]);
            let ridges = two.map(|patch| patch.ridge);
            if ridges[0] != ridges[1] && is_ridge(two) {
                let [from, to] = [ridges[0].max(ridges[1]), ridges[0].min(ridges[1])];
                patches.iter_mut().filter(|p| p.ridge == from).for_each(|p| p.ridge = to);
            }
        }
    }
}

/// Whether the plane of either facet lies above the ground where the block presses on the other one.
fn is_ridge([a, b]: [&CellPatch; 2]) -> bool {
    let above = |plane: &CellPatch, place: &CellPatch| {
        let at = place.surface.weight_first / place.surface.weight;
        let depth = |patch: &CellPatch| patch.plane.0.dot(at) + patch.plane.1;
        depth(plane) >= depth(place)
    };
    above(a, b) && above(b, a)
}

/// Finds what springs and dashpots of the contacts of a pair do at their spots; takes their memories on by the time asked for.
pub(super) fn respond(
    law: &ContactLaw,
    asked: &Asked,
    slot: &mut PairSlot,
    shares: &mut [Vec<f64>; 2],
    contacts: &mut [DeformableContact],
) -> ContactOutput {
    let PairSlot { spots, patches, .. } = slot;
    find_ridges(patches, asked.facets);
    let ratio = law.damping_ratio;
    let dashpots = Dashpots {
        ratio,
        mass: if ratio > 0.0 { 1.0 / ease(&asked.sides, spots, shares) } else { 0.0 },
        whole: patches.iter().map(|patch| patch.surface.vector.length()).sum(),
    };
    let mut reply = ContactOutput::default();
    for (k, DeformableContact { memory, .. }) in contacts.iter_mut().enumerate() {
        let across = dashpots.across(law, patches, spots, patches[k].ridge);
        let patch = &mut patches[k];
        let own = &mut spots[patch.spots.clone()];
        patch.area = 0.0;
        patch.force = patch.elastic;
        let Some(c) = Contact::new(&asked.sides, patch, own) else {
            memory.forget();
            continue;
        };
        patch.area = c.area;
        rub(law, asked, (&c, &dashpots, across), own, memory);
        reply.stored += memory.stored(law.shear_stiffness);
        for spot in own {
            let velocity = asked.sides.relative_velocity(spot);
            patch.force += spot.spring;
            reply.friction -= 0.5 * asked.dt * spot.spring.dot(velocity);
            reply.damping -= 0.5 * asked.dt * spot.drag.dot(velocity);
        }
    }
    reply
}

/// Finds what springs and dashpots of one contact do at its spots; `across`: see [`Dashpots::across`].
fn rub(
    law: &ContactLaw,
    asked: &Asked,
    (c, dashpots, across): (&Contact, &Dashpots, (Vec3, f64)),
    spots: &mut [Spot],
    memory: &mut DeformableMemory,
) {
    // Across the contact: never tension.
    let mut normal = 0.0;
    for spot in spots.iter_mut() {
        let opening = asked.sides.relative_velocity(spot).dot(across.0);
        let drag = (-across.1 * spot.pressure * opening).max(-spot.pressure);
        normal += spot.pressure + drag;
        spot.drag = drag * across.0;
    }
    let along = c.velocity - c.velocity.dot(c.normal) * c.normal;
    // Infinite times no pressure would be no number.
    let largest = if law.friction.is_infinite() {
        f64::INFINITY
    } else {
        shear_limit(law.cohesion * c.area, law.friction, -normal)
    };
    let motion = (along, c.twist[0]);
    // Asked again at the same instant, springs are what they are to the last bit.
    let same = memory.normal == c.normal && memory.area == c.area && memory.polar == c.polar;
    if asked.dt > 0.0 || !same {
        take_on(law, c, along, asked.dt, memory);
        let DeformableMemory { shear, torsion, .. } = memory;
        memory.sliding = limit(c, spots, largest, motion, shear, torsion);
    }
    let viscous = dashpots.of(law.shear_stiffness, c.area);
    let mut sticking = (-viscous * along, -viscous * c.polar / c.area * c.twist[0]);
    if c.moment == 0.0 {
        sticking.1 = 0.0;
    }
    let (mut shear, mut torsion) = (memory.shear + sticking.0, memory.torsion + sticking.1);
    if memory.sliding || limit(c, spots, largest, motion, &mut shear, &mut torsion) {
        sticking = (Vec3::ZERO, 0.0);
    }
    for spot in spots {
        spot.spring = c.share(spot, memory.shear, memory.torsion);
        spot.drag += c.share(spot, sticking.0, sticking.1);
    }
}

/// Lets a shear force and a torsion go down to what friction of this largest force (N) holds, by the rate of slip if nothing sticks (m/s,
/// rad/s); whether they had to.
fn limit(
    c: &Contact,
    spots: &[Spot],
    largest: f64,
    (way, angle): (Vec3, f64),
    shear: &mut Vec3,
    torsion: &mut f64,
) -> bool {
    if largest == f64::INFINITY {
        return false;
    }
    let radius = c.gyration.sqrt();
    let (f, m) = (shear.length() / largest, *torsion / (largest * MEAN_RADIUS * radius));
    // A NaN lets nothing through.
    if largest.is_nan() || largest <= 0.0 || m.abs() <= NO_MOMENT {
        let excess = (f * f + m * m).sqrt();
        if excess <= 1.0 && largest > 0.0 {
            return false;
        }
        let excess = if largest > 0.0 { excess } else { f64::INFINITY };
        *shear /= excess;
        *torsion /= excess;
        return true;
    }
    // A convex limit that has both of its ends has all between them.
    if f + m.abs() <= 1.0 {
        return false;
    }
    let first = c.normal.any_orthonormal_vector();
    let axes = [first, c.normal.cross(first)];
    let points = Points::new(c, spots, axes, radius);
    let trial = [
        -shear.dot(axes[0]) / largest,
        -shear.dot(axes[1]) / largest,
        -*torsion / (largest * radius),
    ];
    let motion = [way.dot(axes[0]), way.dot(axes[1]), angle * radius];
    let Some([s, t, turned]) = hold(&points, trial, c.polar / (c.area * c.gyration), motion) else {
        return false;
    };
    *shear = -largest * (s * axes[0] + t * axes[1]);
    *torsion = -largest * radius * turned;
    true
}

/// Spots as points of Coulomb's law.
struct Points<'a> {
    contact: &'a Contact,
    spots: &'a [Spot],
    axes: [Vec3; 2],
    /// Places of the spots over their distance in the contact, 1/m: without units, and stretched to the mean radius of all.
    stretch: f64,
    /// Square of the width of each spot, in the same measure.
    width: f64,
}

impl<'a> Points<'a> {
    fn new(contact: &'a Contact, spots: &'a [Spot], axes: [Vec3; 2], radius: f64) -> Self {
        let spread = contact.moment / contact.pressure / contact.gyration;
        let mut points = Self {
            contact,
            spots,
            axes,
            stretch: 1.0 / radius,
            width: (1.0 - spread).max(LEAST_WIDTH),
        };
        let factor = MEAN_RADIUS / points.rub([0.0, 0.0, 1.0]).work;
        points.stretch *= factor;
        points.width *= factor * factor;
        points
    }
}

impl Rubs for Points<'_> {
    fn rub(&self, [s, t, w]: Three) -> Rub {
        let mut sum = Rub::default();
        for spot in self.spots {
            let share = spot.pressure / self.contact.pressure;
            let lever = self.stretch * self.contact.lever(spot);
            let [x, y] = self.axes.map(|axis| lever.dot(axis));
            sum.add(share, [s, t, w], [x, y], self.width);
        }
        sum
    }
}

/// Turns the springs with the contact, lets go what has opened, and stretches them.
fn take_on(law: &ContactLaw, c: &Contact, along: Vec3, dt: f64, memory: &mut DeformableMemory) {
    let shear = turned(memory.shear, [memory.normal, c.normal], dt * c.twist[1]);
    memory.shear = shear * shrunk(memory.area, c.area) - law.shear_stiffness * c.area * dt * along;
    memory.torsion = memory.torsion * shrunk(memory.polar, c.polar)
        - law.shear_stiffness * c.polar * dt * c.twist[0];
    if c.moment == 0.0 {
        memory.torsion = 0.0;
    }
    memory.normal = c.normal;
    memory.area = c.area;
    memory.polar = c.polar;
}
