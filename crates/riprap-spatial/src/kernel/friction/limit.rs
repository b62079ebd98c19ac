//! How much friction a contact can carry, along it and against turning at once.

use riprap_geom::Vec3;

use crate::kernel::frame::Frame;
use crate::kernel::friction::{Contact, ContactInput};
use crate::kernel::lever::{FAR, Lever, for_points, lever};
use crate::kernel::piece::Polygon;
use crate::kernel::slip::{Rub, Rubbing, Rubs, Three, hold};
use crate::kernel::sums::integrate;
use crate::lanes::{Lanes, Width};

/// No pressure that is linear on a convex face has, about the centre that suits it best, a mean radius below this, times its radius of
/// gyration: 0.79 on a triangle pressed towards its tip, 0.866 on a strip, 0.937 on a square.
const LEAST_MEAN_RADIUS: f64 = 0.75;
/// Moments below this share of the largest one do not turn the slip.
const NO_MOMENT: f64 = 1e-9;

/// Share of the largest force that a load within the limit may be above it by round-off.
const BEYOND: f64 = 1e-6;

/// Mean radius of a line over its radius of gyration.
const LINE_MEAN_RADIUS: f64 = 0.866;
/// A surface with less area than this, over the square of its radius of gyration, is a line: 1000 times as long as wide.
const NEEDLE: f64 = 1e-2;
/// Shows all pieces of a surface that rub.
pub(crate) type Pieces<'a> = dyn Fn(&mut dyn FnMut(&Polygon, &Frame)) + 'a;

/// Largest friction of a contact.
pub(super) struct Limit<'a> {
    /// Largest shear force, N.
    pub(super) force: f64,
    /// Share of it that does not depend on the pressure.
    pub(super) cohesive: f64,
    pub(super) contact: &'a Contact,
    pub(super) pieces: &'a Pieces<'a>,
    /// Rate of slip along the contact (m/s) and about its normal (rad/s), if nothing sticks: the search begins in this direction, also where an instant
    /// is evaluated again without a step.
    pub(super) motion: (Vec3, f64),
}

impl<'a> Limit<'a> {
    /// For a contact pressed by `normal` (N) with this largest shear force (N), cohesion included, and force of the cohesion alone (N).
    pub(super) fn new(
        [force, cohesion]: [f64; 2],
        contact: &'a Contact,
        q: &ContactInput<'a>,
        motion: (Vec3, f64),
    ) -> Self {
        Self {
            force,
            cohesive: if cohesion > 0.0 { (cohesion / force).min(1.0) } else { 0.0 },
            contact,
            pieces: q.pieces,
            motion,
        }
    }

    /// Lets a shear force and a torsion go down to what friction holds; whether they had to.
    ///
    /// What turns not at all slides where the force is the largest one. The rest is Coulomb's law at every point of the surface.
    pub(super) fn hold(&self, shear: &mut Vec3, torsion: &mut f64) -> bool {
        // A NaN lets nothing through.
        if self.force.is_nan() || self.force <= 0.0 {
            (*shear, *torsion) = (*shear / f64::INFINITY, *torsion / f64::INFINITY);
            return true;
        }
        let radius = self.contact.gyration.sqrt();
        let moment = self.force * radius;
        let f = shear.length() / self.force;
        let m = *torsion / (LEAST_MEAN_RADIUS * moment);
        // A convex limit that has both of its ends has all between them.
        if f + m.abs() <= 1.0 {
            return false;
        }
        if m.abs() <= NO_MOMENT {
            return shrink(shear, torsion, (f * f + m * m).sqrt(), 1.0);
        }
        if self.contact.area < NEEDLE * self.contact.gyration {
            // The integrals over a line cancel; its ellipse is within some per cent.
            let m = *torsion / (LINE_MEAN_RADIUS * moment);
            return shrink(shear, torsion, (f * f + m * m).sqrt(), 1.0);
        }
        let Some(face) = Face::new(self, radius) else {
            let excess = f + m.abs();
            *shear /= excess;
            *torsion /= excess;
            return true;
        };
        // Friction resists: what springs carry against the slip counts along it.
        let trial = [
            -shear.dot(face.axes[0]) / self.force,
            -shear.dot(face.axes[1]) / self.force,
            -*torsion / moment,
        ];
        let (way, angle) = self.motion;
        let motion = [way.dot(face.axes[0]), way.dot(face.axes[1]), angle * radius];
        let turn = self.contact.polar / (self.contact.area * self.contact.gyration);
        let held = hold(&face, trial, turn, motion);
        let Some([s, t, turned]) = held.filter(|held| held.iter().all(|x| x.is_finite())) else {
            // No surface holds more than this, whatever round-off makes of one.
            return shrink(shear, torsion, f.max(torsion.abs() / moment), 1.0 + BEYOND);
        };
        *shear = -self.force * (s * face.axes[0] + t * face.axes[1]);
        *torsion = -moment * turned;
        true
    }
}

/// Divides a load that is more than `least` times what friction carries by how much it is; whether it was.
fn shrink(shear: &mut Vec3, torsion: &mut f64, excess: f64, least: f64) -> bool {
    if excess > least {
        *shear /= excess;
        *torsion /= excess;
    }
    excess > least
}

/// The surface laid flat into the plane of the contact.
struct Face<'a> {
    pieces: &'a Pieces<'a>,
    /// Unit of length, m.
    radius: f64,
    /// Axes of the first piece, turned into the plane of the contact.
    axes: [Vec3; 2],
    /// Those axes as they are.
    own: [Vec3; 2],
    /// Centre of the traction, m from the origin of the planes.
    centre: Vec3,
    /// Traction over depth, and the rest of it, for a force of 1.
    share: [f64; 2],
    /// Largest distance of a corner from the centre, radii.
    reach: f64,
    /// Instructions that may be used; no bit of a result depends on them.
    width: Width,
}

impl<'a> Face<'a> {
    /// `None` where nothing rubs.
    fn new(limit: &Limit<'a>, radius: f64) -> Option<Self> {
        let normal = limit.contact.normal;
        let mut first: Option<Frame> = None;
        let (mut depth, mut area) = (0.0, 0.0);
        let (mut deep, mut at) = (Vec3::ZERO, Vec3::ZERO);
        (limit.pieces)(&mut |polygon, frame| {
            let i = integrate(polygon);
            let place = |whole: f64, [s, t]: [f64; 2]| {
                whole * frame.foot + s * frame.axes[0] + t * frame.axes[1]
            };
            depth += i.depth;
            deep += place(i.depth, i.depth_first);
            area += i.area;
            at += place(i.area, i.area_first);
            first.get_or_insert(*frame);
        });
        let frame = first?;
        // Written so that a NaN is no surface either.
        if !(depth > 0.0 && area > 0.0) {
            return None;
        }
        let share = [(1.0 - limit.cohesive) / depth, limit.cohesive / area];
        let both = frame.normal + normal;
        let laid = |axis: Vec3| axis - axis.dot(normal) / (1.0 + frame.normal.dot(normal)) * both;
        let centre = share[0] * deep + share[1] * at;
        let mut reach = 0.0_f64;
        (limit.pieces)(&mut |polygon, other| {
            let arm = centre - other.foot;
            let [s, t] = other.axes.map(|axis| arm.dot(axis));
            for (x, y) in polygon.s().iter().zip(polygon.t()) {
                reach = reach.max((x - s) * (x - s) + (y - t) * (y - t));
            }
        });
        Some(Self {
            pieces: limit.pieces,
            radius,
            axes: frame.axes.map(laid),
            own: frame.axes,
            centre,
            share,
            reach: reach.sqrt() / radius,
            width: Width::detect(),
        })
    }

    /// Integrals of all pieces about a place (in lengths from the centre).
    fn lever(&self, [s, t]: [f64; 2]) -> Lever {
        let at = self.centre + self.radius * (s * self.own[0] + t * self.own[1]);
        let mut sum = Lever::default();
        (self.pieces)(&mut |polygon, frame| {
            let arm = at - frame.foot;
            let own = lever(polygon, frame.axes.map(|axis| arm.dot(axis)), self.share);
            sum.add(&own.turned(self.own.map(|e| frame.axes.map(|axis| e.dot(axis)))));
        });
        sum.value /= self.radius;
        sum.stiffness = sum.stiffness.map(|x| x * self.radius);
        sum
    }
}

impl Rubs for Face<'_> {
    fn rub(&self, [s, t, turn]: Three) -> Rub {
        let way = (s * s + t * t).sqrt();
        if turn.abs() * self.reach > FAR * way {
            return Rub::about([s, t], turn, &self.lever([-t / turn, s / turn]));
        }
        let ratio = turn.abs() * self.reach / way;
        let mut sum = Rub::default();
        (self.pieces)(&mut |polygon, frame| {
            let arm = self.centre - frame.foot;
            let at = frame.axes.map(|axis| arm.dot(axis));
            let turned = self.own.map(|e| frame.axes.map(|axis| e.dot(axis)));
            let [[ps, pt], [qs, qt]] = turned.map(|e| e.map(|x| Lanes::all(x / self.radius)));
            let mut rubbing = Rubbing::default();
            self.width.run(
                #[inline(always)]
                || {
                    for_points(
                        polygon,
                        ratio,
                        at,
                        self.share,
                        #[inline(always)]
                        |share, [x, y]| {
                            let (p, q) = (ps * x + pt * y, qs * x + qt * y);
                            rubbing.add(share, [s, t, turn], [-q, p]);
                        },
                    );
                },
            );
            rubbing.give(&mut sum);
        });
        sum
    }
}
