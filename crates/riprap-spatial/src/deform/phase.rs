//! Entering phases: which masses, whether it relaxes, whether bonds may break.

use riprap_geom::Vec3;

use crate::deform::relax::Relaxation;
use crate::laws::tetrahedron::Strain;
use crate::state::deform::{Deform, Masses};
use crate::state::relax::Relax;
use crate::state::world::World;

/// Rules of a phase for deformable blocks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rules {
    /// Ratio of net to external forces at which a relaxing phase is converged; `None` in dynamic phases.
    pub relax: Option<f64>,
    /// Whether bonds may break.
    pub breaking: bool,
    /// Measure of strain from now on; `None` leaves it as it is.
    pub strain: Option<Strain>,
}

/// Begins a phase; everything must be laid out anew afterwards. Nodes stop where it relaxes or has relaxed (then this
/// returns true: the leapfrog starts again); the masses suit it. `origin` is where the local one lies, m.
pub fn begin(deform: &mut Deform, rules: &Rules, time: f64, origin: Vec3) -> bool {
    deform.breaking = rules.breaking;
    let stops = deform.relax.is_some() || rules.relax.is_some();
    if stops {
        deform.nodes.velocity.fill([0.0; 3]);
    }
    match rules.relax {
        Some(tolerance) => {
            deform.relax = Some(Relax::new(tolerance));
            deform.masses = Masses::Lumped;
        }
        None => {
            deform.relax = None;
            deform.masses = Masses::Inertia;
        }
    }
    super::build::hold_now(deform, time, origin);
    stops
}

/// Begins a phase of a world: supports are looked at anew; everything must be laid out anew afterwards.
pub fn enter(world: &mut World, rules: Option<&Rules>) {
    super::beside(world, |world, deform| {
        if let Some(strain) = rules.and_then(|r| r.strain) {
            for body in &mut deform.bodies {
                body.strain = strain;
            }
        }
        super::build::hold_anew(world, deform);
        if let Some(rules) = rules
            && begin(deform, rules, world.time, world.setup.origin)
        {
            world.last_dt = 0.0;
        }
    });
}

/// Chooses how the present phase relaxes.
pub fn relax_by(world: &mut World, relaxation: Relaxation) {
    if let Some(relax) = world.deform.as_mut().and_then(|d| d.relax.as_mut()) {
        relax.relaxation = relaxation;
        relax.damping = relaxation.damping.unwrap_or(relax.damping);
    }
}

/// Lets model time pass in the coming iteration of a relaxing phase.
pub fn load_step(world: &mut World, increment: f64) {
    if let Some(relax) = world.deform.as_mut().and_then(|d| d.relax.as_mut()) {
        relax.disturb();
        relax.increment = increment;
    }
}
