//! Constants of a class of patches as eight of them are computed at a time.

use crate::setup::{Dashpots, Failure, JointLaw};
use crate::state::patches::PatchClass;

/// What the wide kernel needs of a class.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Wide {
    /// Arms of i and j (x, y, z), m.
    pub(crate) arms: [[f64; 3]; 2],
    /// Area times stiffness along x, y, z, N/m.
    pub(crate) stiffness: [f64; 3],
    /// Stiffness against relative rotation about x, y, z, N m.
    pub(crate) turning: [f64; 3],
    /// Area, m².
    pub(crate) area: f64,
    /// Moment of the in-situ stress about the centre, N m.
    pub(crate) moment: [f64; 3],
    /// Dashpot over spring, s.
    pub(crate) beta: f64,
    /// Normal and shear stiffness, Pa/m.
    pub(crate) springs: [f64; 2],
    /// Distances of the points along b and c, m.
    pub(crate) half_spacing: [f64; 2],
    /// Most that the in-situ stress of a point differs from that of the centre (n, b, c), Pa.
    pub(crate) spread: [f64; 3],
    /// Cohesion, tension and tan(phi); infinite strength when elastic.
    pub(crate) strength: [f64; 3],
    /// Residual cohesion and tan(phi).
    pub(crate) residual: [f64; 2],
    /// Change of the in-situ traction (n, b, c) along b and along c, Pa/m.
    pub(crate) slope: [[f64; 3]; 2],
    /// 1 where sliding points have no dashpots along the patch, else 0.
    pub(crate) sticking: f64,
    /// Whether the wide kernel knows the law: points fail by themselves, and the law is plain.
    pub(crate) plain: bool,
}

impl Wide {
    /// Constants of a class; meaningless for one that is not normal to an axis.
    #[must_use]
    pub(crate) fn new(class: &PatchClass, joint: &JointLaw) -> Self {
        let strength = joint.strength.as_ref();
        let axis = usize::from(class.axis % 3);
        // Component k of space is component (k - axis) mod 3 of n, b, c, which are the axes in turn.
        let along = [0, 1, 2].map(|k| (k + 3 - axis) % 3);
        let [kn, ks] = class.stiffness;
        let [b2, c2] = class.half_spacing.map(|r| r * r);
        let local = [kn, ks, ks];
        let turn = [ks * (b2 + c2), kn * c2, kn * b2];
        let [sb, sc] = class.slope;
        let moment = [b2 * sb[2] - c2 * sc[1], c2 * sc[0], -b2 * sb[0]];
        let [rb, rc] = class.half_spacing;
        Self {
            arms: class.arms.map(|a| a.to_array()),
            stiffness: along.map(|k| class.area * local[k]),
            turning: along.map(|k| class.area * turn[k]),
            area: class.area,
            moment: along.map(|k| class.area * moment[k]),
            beta: class.beta,
            springs: class.stiffness,
            half_spacing: class.half_spacing,
            spread: [0, 1, 2].map(|k| rb * sb[k].abs() + rc * sc[k].abs()),
            strength: if joint.is_plain() {
                strength.map_or([f64::INFINITY, f64::INFINITY, 0.0], |s| {
                    [s.cohesion, s.tension, s.friction]
                })
            } else {
                // Never certainly elastic: the general law is asked for every patch.
                [0.0, f64::NEG_INFINITY, 0.0]
            },
            residual: strength.map_or([0.0; 2], |s| [s.residual_cohesion, s.residual_friction]),
            slope: class.slope,
            sticking: match joint.dashpots {
                Dashpots::Sticking => 1.0,
                Dashpots::Closed => 0.0,
            },
            plain: joint.failure == Failure::Point && strength.is_some() && joint.is_plain(),
        }
    }
}
