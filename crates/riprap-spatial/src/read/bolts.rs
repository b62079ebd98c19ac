//! What fields ask of bolts.

use crate::laws::bolt::Design;
use crate::read::view::View;
use crate::state::bolts::Bolt;

/// The installed ones among bolts of the setup (ascending).
pub fn of<'a>(v: &View<'a>, numbers: &'a [u32]) -> impl Iterator<Item = &'a Bolt> {
    let bolts = v.world.bolts.iter();
    bolts.filter(|bolt| numbers.contains(&bolt.number))
}

/// The largest of a number over bolts, at least `least`; not a number where none is installed.
#[must_use]
pub fn largest(v: &View, numbers: &[u32], least: f64, get: impl Fn(&View, &Bolt) -> f64) -> f64 {
    let mut all = of(v, numbers).map(|bolt| get(v, bolt)).peekable();
    if all.peek().is_none() {
        return f64::NAN;
    }
    all.fold(least, f64::max)
}

/// Largest axial force, N.
#[must_use]
pub fn force(_: &View, bolt: &Bolt) -> f64 {
    bolt.chain.largest_force()
}

/// Force of the plate, N; not a number without one.
#[must_use]
pub fn plate(v: &View, bolt: &Bolt) -> f64 {
    bolt.chain.plate_force(design(v, bolt))
}

/// Largest shear force, N.
#[must_use]
pub fn shear(_: &View, bolt: &Bolt) -> f64 {
    let forces = bolt.dowels.iter().map(|d| d.force.length());
    forces.fold(0.0, f64::max)
}

/// Largest slip of the grout, m.
#[must_use]
pub fn slip(_: &View, bolt: &Bolt) -> f64 {
    bolt.chain.largest_slip()
}

/// Largest plastic elongation of a bar, m.
#[must_use]
pub fn yielded(_: &View, bolt: &Bolt) -> f64 {
    bolt.chain.largest_yield()
}

/// Largest axial force over that at which the bar yields.
#[must_use]
pub fn utilisation(v: &View, bolt: &Bolt) -> f64 {
    bolt.chain.utilisation(design(v, bolt))
}

fn design<'a>(v: &View<'a>, bolt: &Bolt) -> &'a Design {
    &v.world.setup.bolts[bolt.number as usize].design
}
