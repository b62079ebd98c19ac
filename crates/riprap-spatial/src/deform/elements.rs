//! What the tetrahedra of a body say: forces, stress, strain, energy.

use riprap_geom::Mat3;

use crate::laws::tetrahedron::{Gradient, StartStress, Strain, tensor};
use crate::state::deform::{Body, Deform};
use crate::state::workspace::{BlockClass, Workspace};

/// Adds the forces (N) of the tetrahedra of a body with node displacements `u` (m). With small strain those of a start
/// stress are constant and not among them.
///
/// Small strain with a shared class takes the dense matrix. To be called inside `Width::run`.
#[inline(always)]
pub fn add_forces(
    class: &BlockClass,
    strain: Strain,
    start: &StartStress,
    u: &[[f64; 3]],
    f: &mut [[f64; 3]],
) {
    match (&class.stiffness, strain) {
        (Some(stiffness), Strain::Small) => stiffness.add_forces(u, f),
        (None, Strain::Small) => {
            class.groups.add_forces(&class.law, strain, &StartStress::none(), u, f);
        }
        (_, Strain::Large) => class.groups.add_forces(&class.law, strain, start, u, f),
    }
}

impl Deform {
    /// Displacements of the nodes of a body, m.
    #[must_use]
    pub fn displacement(&self, body: &Body) -> &[[f64; 3]] {
        &self.nodes.displacement[body.nodes()]
    }

    /// Mean Cauchy stress (Pa, tension-positive) and mean displacement gradient of a body.
    #[must_use]
    pub fn average(&self, work: &Workspace, body: &Body) -> (Mat3, Gradient) {
        let class = work.class(body);
        let u = self.displacement(body);
        let start = work.start_of(self.slot[body.block as usize] as usize);
        let (stress, gradient) = class.groups.average(&class.law, body.strain, start, u);
        (tensor(stress), gradient)
    }

    /// Strain energy of a body, J.
    #[must_use]
    pub fn strain_energy(&self, work: &Workspace, body: &Body) -> f64 {
        let class = work.class(body);
        let slot = self.slot[body.block as usize] as usize;
        let u = self.displacement(body);
        let held = self.start.get(slot).map_or(0.0, |s| s.energy);
        let start = work.start_of(slot);
        class.groups.energy(&class.law, body.strain, start, u) + held
    }
}
