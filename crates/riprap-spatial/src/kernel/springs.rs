//! Shear springs of a contact, of rigid blocks and of those that bend alike.

use riprap_geom::Vec3;

/// Energy (J) in shear springs of this stiffness (Pa/m) over an area (m²) with its polar second moment (m⁴) that carry a shear force (N) and a
/// torsion (N m).
#[must_use]
pub(crate) fn stored(stiffness: f64, shear: Vec3, torsion: f64, [area, polar]: [f64; 2]) -> f64 {
    let share = |squared: f64, amount: f64| {
        if amount > 0.0 { squared / (2.0 * stiffness * amount) } else { 0.0 }
    };
    share(shear.length_squared(), area) + share(torsion * torsion, polar)
}

/// Force of shear springs whose normal has turned from the first to the second, and the contact about it by `turning` (rad), with the mean
/// spin of both blocks: as large as before.
pub(crate) fn turned(shear: Vec3, [before, normal]: [Vec3; 2], turning: f64) -> Vec3 {
    let length = shear.length();
    let mut shear = shear + before.cross(normal).cross(shear);
    shear += turning * normal.cross(shear);
    shear -= shear.dot(normal) * normal;
    // Turned to first order a force grows, step after step: energy from nothing.
    let now = shear.length();
    if now > 0.0 {
        shear *= length / now;
    }
    shear
}

/// What is left of springs on an area: those of a part that has opened are gone; a part that has closed adds unloaded ones. (Scaling up as
/// well would make energy.)
pub(crate) fn shrunk(old: f64, new: f64) -> f64 {
    if new < old { new / old } else { 1.0 }
}
