//! What the beginning of a phase changes in blocks, supports and laws.

use super::Engine;
use crate::Vec2;
use crate::exec::Exec;

use crate::plan::{Damping, Phase};
use crate::spatial::bolts::install::InstallError;
use crate::{planar, spatial};

/// In the plane.
///
/// # Errors
/// A bolt that cannot be installed.
pub(super) fn planar(
    world: &mut planar::world::World,
    scratch: &planar::step::Scratch,
    phase: &Phase,
) -> Result<(), planar::bolts::InstallError> {
    use planar::setup::Motion;
    planar::removal::take_out(world, &phase.remove);
    for &b in &phase.fix {
        world.motion[b as usize] =
            Some(Box::new(Motion::Fixed { x: true, y: true, rotation: true }));
    }
    for &b in &phase.release {
        world.motion[b as usize] = None;
    }
    if let Some(table) = phase.water {
        world.water = table;
        world.seepage = None;
    }
    planar::change_laws(world, scratch, &phase.contacts);
    if let Some(reduction) = &phase.reduction {
        for &row in &reduction.rows {
            let interface = &mut world.setup.interfaces[row as usize];
            interface.contact = interface.contact.reduced(reduction.factor);
            interface.bond = interface.bond.map(|law| law.reduced(reduction.factor));
        }
    }
    if phase.zero_velocities {
        for body in &mut world.bodies {
            body.velocity = Vec2::ZERO;
            body.spin = 0.0;
        }
        world.last_dt = 0.0;
    }
    planar::step::hold_driven(world, &scratch.shapes);
    planar::bolts::follow(world);
    planar::bolts::install(world, &scratch.shapes, &phase.install)
}

/// In space.
pub(super) fn spatial(
    world: &mut spatial::world::World,
    scratch: &spatial::step::Scratch,
    phase: &Phase,
) -> Result<(), InstallError> {
    use spatial::setup::Motion;
    // Before anything else: its pairs are those of the last evaluation.
    if !phase.joints.is_empty() {
        spatial::change_laws(world, scratch, |world| {
            for (row, law) in &phase.joints {
                world.setup.interfaces[*row as usize].joint = *law;
            }
        });
    }
    spatial::topology::remove(world, &phase.remove);
    for &b in &phase.fix {
        world.motion[b as usize] =
            Some(Box::new(Motion::Fixed { translation: [true; 3], rotation: [true; 3] }));
    }
    for &b in &phase.release {
        world.motion[b as usize] = None;
    }
    if let Some(table) = phase.water {
        world.water = table;
        world.seepage = None;
    }
    if let Some(reduction) = &phase.reduction {
        spatial::topology::reduce_strengths(world, &reduction.rows, reduction.factor);
    }
    if !phase.joints.is_empty() {
        spatial::topology::renew_laws(world);
    }
    if phase.zero_velocities {
        world.halt();
    }
    world.hold_driven();
    let rules = phase.deform.map(|d| spatial::deform::phase::Rules {
        relax: d.relax.map(|r| r.tolerance),
        breaking: d.breaking,
        strain: d.strain,
    });
    spatial::deform::phase::enter(world, rules.as_ref());
    if let Some(relax) = phase.deform.and_then(|d| d.relax) {
        spatial::deform::phase::relax_by(world, relax.relaxation);
    }
    let cut = phase.deform.and_then(|d| d.cut);
    spatial::topology::cut::allow(world, cut.as_ref());
    spatial::bolts::install::install(world, &phase.install)
}

impl Engine {
    /// What keeps moduli of a material from being changed, in words.
    #[must_use]
    pub fn material_obstacle(
        &self,
        row: u16,
        material: &spatial::setup::Material,
    ) -> Option<String> {
        match self {
            Self::Planar(_) => None,
            Self::Spatial(_) if self.exec().peers().is_some() => {
                Some("the model is shared out among ranks; run it on one".to_owned())
            }
            Self::Spatial(e) => spatial::topology::material::obstacle(&e.world, row, material),
        }
    }

    /// Gives a material other moduli and another density, in the plane a density. Forces must be known, and re-evaluated afterwards.
    ///
    /// # Errors
    /// A law that lacks moduli, in words.
    pub fn set_material(
        &mut self,
        row: u16,
        material: spatial::setup::Material,
    ) -> Result<(), String> {
        let e = match self {
            Self::Planar(e) => {
                planar::density::change(&mut e.world, row, material.density);
                let exec = std::mem::replace(&mut e.scratch.exec, Exec::serial());
                let mut scratch = planar::step::Scratch::new(&mut e.world, exec);
                std::mem::swap(&mut scratch.profile, &mut e.scratch.profile);
                e.scratch = scratch;
                return Ok(());
            }
            Self::Spatial(e) => e,
        };
        spatial::topology::material::change(&mut e.world, &e.scratch, row, material)?;
        // Elements and what hangs on them are laid out by the moduli.
        let exec = std::mem::replace(&mut e.scratch.exec, Exec::serial());
        let mut scratch = spatial::step::Scratch::new(&mut e.world, exec);
        std::mem::swap(&mut scratch.profile, &mut e.scratch.profile);
        e.scratch = scratch;
        Ok(())
    }

    /// Takes blocks out; the forces that they gave to others fade over `span` (s). Forces must be known, and re-evaluated
    /// after the edit that follows.
    ///
    /// # Errors
    /// A block whose forces are not finite.
    pub fn remove_gradually(
        &mut self,
        blocks: &[u32],
        span: f64,
        damping: &Damping,
    ) -> Result<(), u32> {
        match self {
            Self::Planar(e) => {
                let (world, scratch) = (&mut e.world, &mut e.scratch);
                planar::removal::take_out_gradually(world, scratch, blocks, span, damping)
                    .map_err(|e| e.block)
            }
            Self::Spatial(e) => {
                let (world, scratch) = (&mut e.world, &mut e.scratch);
                spatial::topology::take_out_gradually(world, scratch, blocks, span, damping)
                    .map_err(|e| e.block)
            }
        }
    }
}
