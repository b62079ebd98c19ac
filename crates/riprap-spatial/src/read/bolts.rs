//! What fields ask of bolts.

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

fn over(list: impl Iterator<Item = f64>, least: f64) -> f64 {
    list.fold(least, f64::max)
}

/// Largest axial force, N.
#[must_use]
pub fn force(_: &View, bolt: &Bolt) -> f64 {
    over(bolt.chain.force.iter().copied(), f64::NEG_INFINITY)
}

/// Force of the plate, N; not a number without one.
#[must_use]
pub fn plate(v: &View, bolt: &Bolt) -> f64 {
    let has_one = bolt.chain.holds.first().is_some_and(|hold| hold.lifts);
    let spec = &v.world.setup.bolts[bolt.number as usize];
    match spec.design.plate {
        Some(_) if has_one => bolt.chain.held(0),
        Some(_) | None => f64::NAN,
    }
}

/// Largest shear force, N.
#[must_use]
pub fn shear(_: &View, bolt: &Bolt) -> f64 {
    over(bolt.dowels.iter().map(|d| d.force.length()), 0.0)
}

/// Largest slip of the grout, m.
#[must_use]
pub fn slip(_: &View, bolt: &Bolt) -> f64 {
    let chain = &bolt.chain;
    let nodes = chain.holds.iter().zip(&chain.slip);
    let grout = nodes.filter(|(hold, _)| !hold.lifts);
    over(grout.map(|(_, slip)| slip.abs()), 0.0)
}

/// Largest plastic elongation of a bar, m.
#[must_use]
pub fn yielded(_: &View, bolt: &Bolt) -> f64 {
    over(bolt.chain.plastic.iter().map(|p| p.abs()), 0.0)
}

/// Largest axial force over that at which the bar yields.
#[must_use]
pub fn utilisation(v: &View, bolt: &Bolt) -> f64 {
    let yields = v.world.setup.bolts[bolt.number as usize].design.yields;
    over(bolt.chain.force.iter().map(|n| n.abs() / yields), 0.0)
}
