//! Entering phases: which masses, whether it relaxes, whether bonds may break.

use crate::deform::relax::Relaxation;
use crate::laws::tetrahedron::Strain;
use crate::state::deform::Masses;
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

/// Begins a phase: supports are looked at anew, the masses suit it, and nodes stop where it relaxes or has relaxed. Everything must be laid
/// out anew afterwards.
pub fn enter(world: &mut World, rules: Option<&Rules>) {
    super::beside(world, |world, deform| {
        if let Some(strain) = rules.and_then(|r| r.strain) {
            deform.bodies.iter_mut().for_each(|body| body.strain = strain);
        }
        super::build::hold_anew(world, deform);
        let Some(rules) = rules else {
            return;
        };
        deform.breaking = rules.breaking;
        if deform.relax.is_some() || rules.relax.is_some() {
            deform.nodes.velocity.fill([0.0; 3]);
            // The leapfrog starts again.
            world.last_dt = 0.0;
        }
        deform.relax = rules.relax.map(Relax::new);
        deform.masses = if rules.relax.is_some() { Masses::Lumped } else { Masses::Inertia };
        super::build::hold_now(deform, world.time, world.setup.origin);
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
