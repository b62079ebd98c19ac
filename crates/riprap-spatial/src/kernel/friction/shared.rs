//! Dashpots that several surfaces of two blocks share.

use riprap_geom::Vec3;

use crate::kernel::friction::{ContactInput, ContactLaw, Wrench, about, against_rocking, meeting};

/// The pressure of a surface.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Pressing {
    /// Normal force, N.
    pub force: f64,
    /// Velocity at which its sides part, m/s.
    pub parting: f64,
    /// Where it acts from the origin of the planes, m.
    pub point: Vec3,
}

/// Dashpots that several surfaces share.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Shared {
    /// What they add to the pressure of each, over it; at least -1.
    pub ratio: f64,
    /// Against rocking about all of them.
    pub rocking: Wrench,
}

/// Pressure of a surface, and how fast its sides part; `None` where it has no one normal.
#[must_use]
pub(crate) fn pressing(law: &ContactLaw, q: &ContactInput) -> Option<Pressing> {
    meeting(law, q).map(|met| Pressing {
        force: met.contact.elastic,
        parting: met.velocity.normal,
        point: met.contact.point,
    })
}

/// Dashpots of several surfaces as if they were one; `None` where their pressures cancel.
///
/// On a ridge a block that slides goes into one flank as it leaves the other, and takes no energy up: dashpots of each flank would hold it
/// back. So they act on the rate of the energy of all of them, `power` (W, the sum of force times velocity of parting), and press along the
/// gradient of that energy: in proportion to the pressure of each. `q` has the sums of all.
#[must_use]
pub(crate) fn share(law: &ContactLaw, q: &ContactInput, power: f64) -> Option<Shared> {
    let met = meeting(law, q)?;
    let c = &met.contact;
    let across = law.dashpot(law.normal_stiffness, c.area, met.mass, q.last_dt);
    let normal = (c.elastic - across * power / c.elastic).max(0.0);
    let rocking = against_rocking(across, c, &met.velocity, normal);
    Some(Shared { ratio: normal / c.elastic - 1.0, rocking: about(met.arms, Vec3::ZERO, rocking) })
}
