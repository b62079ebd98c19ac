//! Closed forms of a grouted bar, and usual values of dowels.

/// `1/lambda = sqrt(EA/k_g)`, m: the length over which the force in a long elastic bar falls by a factor e. `grout` in N/m² (force per length and
/// motion), `axial` stiffness EA in N.
#[must_use]
pub fn transfer_length(grout: f64, axial: f64) -> f64 {
    (axial / grout).sqrt()
}

/// Force over motion at the head of an elastic bar with a grouted length (m), N/m: `EA lambda tanh(lambda L)`.
#[must_use]
pub fn pull_out_stiffness(grout: f64, axial: f64, length: f64) -> f64 {
    let lambda = (grout / axial).sqrt();
    axial * lambda * libm::tanh(lambda * length)
}

/// Force (N) and motion (m) at the head of an elastic bar whose grout, of `strength` N/m, slips over the first `slipping` metres.
#[must_use]
pub fn pull_out_load(
    grout: f64,
    axial: f64,
    strength: f64,
    length: f64,
    slipping: f64,
) -> (f64, f64) {
    // Where slip ends the grout is just at its strength: the bar has moved by strength/grout there.
    let elastic = strength / grout * pull_out_stiffness(grout, axial, length - slipping);
    let force = elastic + strength * slipping;
    let motion =
        // The force grows evenly along what slips, which stretches by its mean.
        strength / grout + (elastic * slipping + 0.5 * strength * slipping * slipping) / axial;
    (force, motion)
}

/// Shear stiffness (N/m) of a bar of diameter `bar` (m) in a grouted hole of diameter `hole` (m) where it crosses a joint: two half-infinite
/// beams on springs without moment at the joint, `E_b I beta^3` with `K = 2 E_g/(d_2/d_1 - 1)` and `beta = (K/(4 E_b I))^(1/4)`. Moduli in Pa.
#[must_use]
pub fn dowel_stiffness(grout_young: f64, steel_young: f64, bar: f64, hole: f64) -> f64 {
    let bending = steel_young * std::f64::consts::PI * (bar * bar) * (bar * bar) / 64.0;
    let bed = 2.0 * grout_young / (hole / bar - 1.0);
    let beta = (bed / (4.0 * bending)).sqrt().sqrt();
    bending * beta * beta * beta
}

/// Shear force (N) that a dowel of diameter `bar` (m) carries at most: `0.67 d^2 sqrt(sigma_b sigma_c)`, with the yield stress of the steel and
/// the compressive strength of the rock, Pa. After Bjurstroem (1974), as quoted in later work; the original was not seen.
#[must_use]
pub fn dowel_limit(bar: f64, steel_yield: f64, rock_strength: f64) -> f64 {
    0.67 * bar * bar * (steel_yield * rock_strength).sqrt()
}
