//! What fields ask of bolts.

use crate::laws::bolt;
use crate::query::view::View;
use crate::setup::Bolt as Spec;
use crate::state::bolts::Bolt;

/// The installed ones among bolts of the setup (ascending).
pub fn of<'a>(v: &View<'a>, numbers: &'a [u32]) -> impl Iterator<Item = &'a Bolt> {
    let bolts = v.world.bolts.iter();
    bolts.filter(|bolt| numbers.contains(&bolt.number))
}

/// The largest of a number over the installed ones among bolts of the setup (ascending), at least `least`; not a number where none is installed.
#[must_use]
pub fn largest(v: &View, numbers: &[u32], least: f64, get: impl Fn(&Spec, &Bolt) -> f64) -> f64 {
    let spec = |bolt: &Bolt| &v.world.setup.bolts[bolt.number as usize];
    bolt::largest(of(v, numbers).map(|bolt| get(spec(bolt), bolt)), least)
}

/// Largest axial force, N.
#[must_use]
pub fn force(_: &Spec, bolt: &Bolt) -> f64 {
    bolt.chain.largest_force()
}

/// Force of the plate, N; not a number without one.
#[must_use]
pub fn plate(spec: &Spec, bolt: &Bolt) -> f64 {
    bolt.chain.plate_force(&spec.design)
}

/// Largest shear force, N.
#[must_use]
pub fn shear(_: &Spec, bolt: &Bolt) -> f64 {
    let forces = bolt.dowels.iter().map(|d| d.force.length());
    forces.fold(0.0, f64::max)
}
