//! Built patches: joints along edges that two blocks share at the start.
//!
//! Each point remembers a place on either block. Its opening and shear are the relative displacement
//! of the two places, measured along the mean rotation of the blocks, and its force acts at their
//! middle: with the mean frame exactly that point makes force and moments the gradient of the stored
//! energy, also for finite rotation.

use riprap_geom::{Vec2, Vec3};

use super::contact::Relative;
use super::search::{pair_mass, row_of};
use super::setup::{BondLaw, Setup};
use super::shapes::Shapes;
use super::world::{Body, World, Wrench};
pub use super::world::{Bond, BondPoint, Wear};
use crate::laws::behaviour::Law;
use crate::laws::damping;
use crate::laws::face_joint::Memory;
use crate::laws::joint_point::{self, Response};
use crate::ledger::Works;

/// Share of the length that a failed joint slides or opens before found contact takes over.
const SLIP_SHARE: f64 = 0.01;
/// Share of the length that a joint may open beyond its dilation, where it closes along a curve or dilates: what it gives way by then
/// is no measure.
const SLACK: f64 = 1e-4;
/// Opening of a failed point at which a joint is torn, over its elastic displacement at its
/// strength or under its present load.
const OPENING: f64 = 3.0;

/// Gauss points and weights on 0..1.
fn gauss(n: u8) -> &'static [(f64, f64)] {
    match n {
        0 | 1 => &[(0.5, 1.0)],
        2 => &[(0.211_324_865_405_187_1, 0.5), (0.788_675_134_594_812_9, 0.5)],
        3 => &[
            (0.112_701_665_379_258_3, 5.0 / 18.0),
            (0.5, 8.0 / 18.0),
            (0.887_298_334_620_741_7, 5.0 / 18.0),
        ],
        4 => &[
            (0.069_431_844_202_973_71, 0.173_927_422_568_726_9),
            (0.330_009_478_207_571_9, 0.326_072_577_431_273_1),
            (0.669_990_521_792_428_1, 0.326_072_577_431_273_1),
            (0.930_568_155_797_026_3, 0.173_927_422_568_726_9),
        ],
        _ => &[
            (0.046_910_077_030_668, 0.118_463_442_528_094_5),
            (0.230_765_344_947_158_5, 0.239_314_335_249_683_2),
            (0.5, 0.284_444_444_444_444_4),
            (0.769_234_655_052_841_5, 0.239_314_335_249_683_2),
            (0.953_089_922_969_332, 0.118_463_442_528_094_5),
        ],
    }
}

/// Share of the residual strength from which a point slides: what is less is no round-off.
const AT_LIMIT: f64 = 1.0 - 1e-9;

/// Builds joints along all shared edges of the pairs whose interface has a bond law. `close` lists
/// candidate pairs, sorted.
#[must_use]
pub fn build(setup: &Setup, shapes: &Shapes, close: &[(u32, u32)]) -> Vec<Bond> {
    let mut bonds = Vec::new();
    for &(i, j) in close {
        let (a, b) = (i as usize, j as usize);
        let row = row_of(setup, a, b);
        let Some(law) = setup.interfaces[row as usize].bond else {
            continue;
        };
        for edge in shared_edges(shapes, [a, b]) {
            let points = gauss(law.points)
                .iter()
                .map(|&(x, w)| {
                    let at = edge.at(x);
                    let apart = 0.5 * apart(setup, &law, at, edge.normal);
                    BondPoint {
                        on_i: at - apart - shapes.centroid[a],
                        on_j: at + apart - shapes.centroid[b],
                        weight: w * edge.length,
                        ..BondPoint::default()
                    }
                })
                .collect();
            bonds.push(Bond {
                i,
                j,
                row,
                normal: edge.normal,
                length: edge.length,
                mass: 0.0,
                points,
                active: true,
                torn: false,
                stress: Wrench::default(),
                damping: Wrench::default(),
                energy: 0.0,
                broken_at: None,
            });
        }
    }
    bonds
}

/// An edge, or a part of one, that two blocks share at the start.
pub(crate) struct SharedEdge {
    /// Start of the edge of the first block that it lies on (local, m).
    start: Vec2,
    /// Along that edge.
    along: Vec2,
    /// Where it begins there, m.
    low: f64,
    /// m.
    length: f64,
    /// Unit normal out of the first block.
    normal: Vec2,
}

impl SharedEdge {
    /// The place at this share of its length (local, m).
    fn at(&self, share: f64) -> Vec2 {
        self.start + (self.low + share * self.length) * self.along
    }

    /// Its middle (local, m).
    pub(crate) fn middle(&self) -> Vec2 {
        self.at(0.5)
    }
}

/// The edges that two blocks share at the start.
pub(crate) fn shared_edges(shapes: &Shapes, [a, b]: [usize; 2]) -> Vec<SharedEdge> {
    let tolerance = 1e-6 * shapes.radius[a].min(shapes.radius[b]);
    let mut shared = Vec::new();
    for ea in shapes.of(a) {
        for eb in shapes.of(b) {
            let start_a = ea.start + shapes.centroid[a];
            let start_b = eb.start + shapes.centroid[b];
            let (dir, opposite) = (ea.normal.perp(), eb.normal.dot(ea.normal) < -1.0 + 1e-9);
            if !opposite || ea.normal.dot(start_b - start_a).abs() > tolerance {
                continue;
            }
            // Edge b runs backwards along edge a.
            let s1 = dir.dot(start_b - start_a);
            let (low, high) = ((s1 - eb.length).max(0.0), s1.min(ea.length));
            if high - low > tolerance {
                shared.push(SharedEdge {
                    start: start_a,
                    along: dir,
                    low,
                    length: high - low,
                    normal: ea.normal,
                });
            }
        }
    }
    shared
}

/// How far the places of a point of a whole joint lie apart (m) under the stress of the rock at the start, at the place `at` (local, m)
/// on the face with the normal `n`.
///
/// The stress is in the springs from the beginning: places that lie as far apart as it presses and shears them about their common
/// middle carry it where the blocks stand, so that forces, moments and energy need no other rule.
fn apart(setup: &Setup, law: &BondLaw, at: Vec2, n: Vec2) -> Vec2 {
    let Some(in_situ) = &setup.in_situ else {
        return Vec2::ZERO;
    };
    let traction = in_situ.traction(at.y, Vec3::new(n.x, n.y, 0.0));
    let traction = Vec2::new(traction.x, traction.y);
    let (sigma, tau) = (traction.dot(n), traction.dot(n.perp()));
    let opening = match law.law() {
        Some(law) => law.opening(sigma),
        None => sigma / law.normal_stiffness,
    };
    opening * n + tau / law.shear_stiffness * n.perp()
}

/// Sets the effective masses after supports have changed.
pub fn set_masses(world: &mut World, shapes: &Shapes) {
    for bond in &mut world.bonds {
        bond.mass = pair_mass(&world.motion, shapes, [bond.i, bond.j].map(|b| b as usize));
    }
}

/// Force of one joint. `elapsed` is the time moved since the last evaluation; books the works.
pub fn force(
    bond: &mut Bond,
    law: &BondLaw,
    bodies: &[Body],
    stiffness_damping: f64,
    elapsed: f64,
    works: &mut Works,
) -> Wrench {
    if !bond.active {
        return Wrench::default();
    }
    let relative = Relative::of(bodies, bond.i, bond.j);
    let [angle_i, angle_j] = [bond.i, bond.j].map(|b| bodies[b as usize].angle);
    let [turn_i, turn_j, turn] = [angle_i, angle_j, 0.5 * (angle_i + angle_j)].map(turn);
    let normal = turn(bond.normal);
    let tangent = normal.perp();
    let (mut stress, mut damp, mut energy) = (Wrench::default(), Wrench::default(), 0.0);
    let general = law.law();
    let (mut failing, mut separation) = (false, 0.0);
    // A joint that is open or has slid at one point cannot be a hinge at another: the tip of the crack
    // runs through.
    let torn = bond.torn;
    for point in &mut bond.points {
        let (arm_i, arm_j) = (turn_i(point.on_i), turn_j(point.on_j));
        let u = arm_j - arm_i - relative.shift;
        // The force acts at the middle of the two places.
        let x = arm_i + 0.5 * u;
        let (at, rate) = ([u.dot(normal), u.dot(tangent)], relative.at(x));
        let moved = elapsed * rate;
        let moved = [moved.dot(normal), moved.dot(tangent), 0.0];
        let (r, [stored, parted]) = match &general {
            None => plain_point(law, at, point.slip, point.failed || torn),
            Some(general) => general_point(general, at, &moved, point, point.failed || torn),
        };
        failing |= r.failed && !point.failed;
        separation += point.weight * parted;
        remember(point, &r, at[0]);
        // Tension pulls i towards j.
        let pull = point.weight * (r.sigma * normal + r.tau * tangent);
        stress = stress.plus(&Wrench::at(pull, x, x + relative.shift));
        if r.sigma != 0.0 || r.tau != 0.0 {
            energy += point.weight * stored;
            let mass = bond.mass * point.weight / bond.length;
            let c = dashpots(law, point.weight, mass, stiffness_damping);
            let [pull, drag] = damped(&r, point.weight, c, [rate.dot(normal), rate.dot(tangent)]);
            let f = pull * normal - drag * tangent;
            damp = damp.plus(&Wrench::at(f, x, x + relative.shift));
        }
    }
    let half = 0.5 * elapsed;
    // Work done on the joint is minus that of its forces on the blocks; what it has not stored of it is lost.
    let lost = -half * relative.power_of(&bond.stress.plus(&stress)) + bond.energy - energy;
    let fracture = by_fracture(lost, failing, general.map(|_| separation));
    works.dissipate(lost - fracture, fracture);
    works.damping -= half * relative.power_of(&bond.damping.plus(&damp));
    (bond.stress, bond.damping, bond.energy) = (stress, damp, energy);
    bond.torn |= is_torn(bond, law);
    stress.plus(&damp)
}

/// Rotation by an angle (rad).
fn turn(angle: f64) -> impl Fn(Vec2) -> Vec2 {
    let (s, c) = libm::sincos(angle);
    move |v| Vec2::new(c * v.x - s * v.y, s * v.x + c * v.y)
}

/// What of a loss of energy is that of fracture, by what was lost above the residual strength where a law says so.
fn by_fracture(lost: f64, failing: bool, separation: Option<f64>) -> f64 {
    match separation {
        // No more than was lost at all.
        Some(separation) => separation.min(lost).max(0.0),
        None if failing => lost,
        None => 0.0,
    }
}

fn remember(point: &mut BondPoint, r: &Response, opening: f64) {
    (point.failed, point.slip, point.opening) = (r.failed, r.slip, opening);
    (point.sigma, point.tau) = (r.sigma, r.tau);
}

/// Dashpot coefficients of a point with a share of the mass, across and along the joint.
#[inline]
fn dashpots(law: &BondLaw, weight: f64, mass: f64, stiffness_damping: f64) -> [f64; 2] {
    [law.normal_stiffness, law.shear_stiffness].map(|stiffness| {
        let k = stiffness * weight;
        damping::dashpot(law.damping_ratio, k, mass) + stiffness_damping * k
    })
}

/// Dashpot forces of a point with the coefficients `c` whose sides part at the velocity `rate`, both across and along the joint: the
/// pull on the first block, and the drag against the sliding.
#[inline]
fn damped(r: &Response, weight: f64, c: [f64; 2], rate: [f64; 2]) -> [f64; 2] {
    // The normal points from i to j: a positive pull is tension.
    let pull = -c[0] * rate[0];
    if r.failed {
        // With the pressure there it must not pull; along the joint there is friction and nothing else.
        [pull.min(-r.sigma * weight), 0.0]
    } else {
        [pull, c[1] * rate[1]]
    }
}

/// A point of the plain law at its opening and shear displacement (m); what it returns is as in [`general_point`].
#[inline]
fn plain_point(law: &BondLaw, at: [f64; 2], slip: f64, failed: bool) -> (Response, [f64; 2]) {
    let r = joint_point::joint_point(law, at[0], at[1], slip, failed);
    let stored =
        0.5 * (r.sigma * r.sigma / law.normal_stiffness + r.tau * r.tau / law.shear_stiffness);
    (r, [stored, 0.0])
}

/// A point of a law that is not plain, at its opening and shear displacement (m): the response, and per area what it stores and what
/// was lost above the residual strength, J/m².
fn general_point(
    law: &Law,
    [opening, shear]: [f64; 2],
    moved: &[f64; 3],
    point: &mut BondPoint,
    failed: bool,
) -> (Response, [f64; 2]) {
    let mut memory = Memory {
        slip: [point.slip, 0.0],
        accumulated_slip: point.wear.accumulated_slip,
        parted: point.wear.parted,
        dilated: point.wear.dilated,
        broken: failed,
        open: point.wear.open,
        ..Memory::default()
    };
    let at = [opening, shear, 0.0];
    let (t, loss) = law.point(&[0.0; 3], &at, moved, &mut memory);
    let stored = law.energy(&[0.0; 3], &at, &memory);
    point.wear = Wear {
        accumulated_slip: memory.accumulated_slip,
        parted: memory.parted,
        dilated: memory.dilated,
        gap: law.opening_of(&[0.0; 3], &at, &memory),
        open: memory.open,
    };
    let response = Response { sigma: t[0], tau: t[1], slip: memory.slip[0], failed: memory.broken };
    (response, [stored[0] + stored[1], loss.fracture])
}

/// Whether a point has failed and slid by more than a small share of the length, or opened by more
/// than that or a few times what the joint gives way at its strength or under its present load.
///
/// A joint that opens at one end turns about the other, where the blocks overlap beyond its last
/// point. No point feels that overlap. With an opening of three times the closure of a point its energy
/// is less than half of what the point stores.
fn is_torn(bond: &Bond, law: &BondLaw) -> bool {
    let far = SLIP_SHARE * bond.length;
    let strength = (law.strength.tension / law.normal_stiffness)
        .max(law.strength.cohesion / law.shear_stiffness);
    let closure = bond.points.iter().map(|p| -p.opening).fold(0.0, f64::max);
    let open = far.min(OPENING * strength.max(closure));
    let mut failed = bond.points.iter().filter(|p| p.failed);
    if law.law().is_some() {
        let open = open.max(SLACK * bond.length);
        return failed.any(|p| p.slip.abs() > far || p.wear.gap > open);
    }
    failed.any(|p| p.slip.abs() > far || p.opening > open)
}

impl Bond {
    /// Whether all points have failed.
    #[must_use]
    pub fn broken(&self) -> bool {
        self.points.iter().all(|p| p.failed)
    }

    /// Number of points that have failed.
    #[must_use]
    pub fn failed_points(&self) -> u64 {
        self.points.iter().filter(|p| p.failed).count() as u64
    }

    /// Whether found contact should take over: all failed, and slid or opened enough somewhere. Not
    /// everywhere: blocks that turn about one end of a joint would overlap there, where no point of
    /// the joint feels it, until found contact throws them apart.
    #[must_use]
    pub fn gives_way(&self) -> bool {
        self.active && self.broken() && self.torn
    }

    /// Its normal from i to j now: turned by the mean rotation of its blocks.
    #[must_use]
    pub fn normal_now(&self, bodies: &[Body]) -> Vec2 {
        let angle = 0.5 * (bodies[self.i as usize].angle + bodies[self.j as usize].angle);
        let (s, c) = libm::sincos(angle);
        let n = self.normal;
        Vec2::new(c * n.x - s * n.y, s * n.x + c * n.y)
    }

    /// Whether all points that press have failed and bear all the shear that their residual friction allows; `None` where none presses.
    #[must_use]
    pub fn slides(&self, law: &BondLaw) -> Option<bool> {
        let mut pressed = self.points.iter().filter(|p| p.sigma < 0.0).peekable();
        pressed.peek()?;
        Some(pressed.all(|p| p.failed && p.tau.abs() >= AT_LIMIT * law.strength.residual(p.sigma)))
    }

    /// Shear force on the first block along the left-hand side of the normal, N/m.
    #[must_use]
    pub fn shear(&self) -> f64 {
        self.points.iter().map(|p| p.weight * p.tau).sum()
    }

    /// Normal force, N/m, compression positive.
    #[must_use]
    pub fn compression(&self) -> f64 {
        -self.points.iter().map(|p| p.weight * p.sigma).sum::<f64>()
    }
}
