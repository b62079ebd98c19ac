//! Law of a face patch with four points: elastic, or Mohr-Coulomb with tension cut-off.
//!
//! Stress is tension-positive; (n, b, c) is the frame of the patch and the traction that on its first
//! block. Total form: the elastic traction follows from the whole relative displacement less what is
//! irrecoverable, so that elastic forces are gradients and forget no step.
//!
//! Source: Tian & Li, equations (17) and (18): peak `|tau| <= c - sigma tan(phi)`, after failure
//! `|tau| <= -sigma tan(phi)` and no tension. Deviation: residual cohesion is added, and torsion counts when
//! the whole face fails as one. Dilation, softening and curved closure: [`super::behaviour`].

mod whole;

use super::mohr_coulomb::shear_strength;
use super::norm;

pub use super::mohr_coulomb::Strength;
pub use whole::{Sums, face};

/// Signs of the four points along b and along c.
pub const SIGNS: [[f64; 4]; 2] = [[-1.0, 1.0, 1.0, -1.0], [-1.0, -1.0, 1.0, 1.0]];

/// Traction at a point: n, b, c, Pa.
pub type Traction = [f64; 3];

/// What a point remembers.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Memory {
    /// Irrecoverable shear displacement along b and c, m.
    pub slip: [f64; 2],
    /// Opening at which the normal spring is relaxed, m.
    pub normal_offset: f64,
    /// Accumulated slip, m.
    pub accumulated_slip: f64,
    /// Largest opening beyond the elastic one while it softened, m.
    pub parted: f64,
    /// How far the roughness of its sides has parted them, m.
    pub dilated: f64,
    /// Whether it has failed.
    pub broken: bool,
    /// Whether it is open: it carries nothing.
    pub open: bool,
    /// Whether it slid in the last step.
    pub sliding: bool,
}

/// Stiffness of a point: normal and shear, Pa/m.
pub type Springs = [f64; 2];

/// Energy that left the springs of a point in one step, J/m².
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Loss {
    /// By sliding.
    pub friction: f64,
    /// By tensile failure.
    pub fracture: f64,
}

/// Elastic traction at displacement `at` (n, b, c, m) with the traction `start` (Pa) at zero.
#[inline]
#[must_use]
pub fn elastic(springs: Springs, start: &Traction, at: &[f64; 3], memory: &Memory) -> Traction {
    [
        start[0] + springs[0] * (at[0] - memory.normal_offset),
        start[1] + springs[1] * (at[1] - memory.slip[0]),
        start[2] + springs[1] * (at[2] - memory.slip[1]),
    ]
}

/// Stored energy of a traction, J/m².
#[inline]
#[must_use]
pub fn stored(springs: Springs, t: &Traction) -> f64 {
    0.5 * (t[0] * t[0] / springs[0] + (t[1] * t[1] + t[2] * t[2]) / springs[1])
}

/// One point that fails by itself: updates its memory, returns traction and losses.
///
/// `at` is the relative displacement (m), `moved` its change in the last step (m).
#[inline]
#[must_use]
pub fn point(
    law: &Strength,
    springs: Springs,
    start: &Traction,
    at: &[f64; 3],
    moved: &[f64; 3],
    memory: &mut Memory,
) -> (Traction, Loss) {
    let mut loss = Loss::default();
    let was_open = memory.open;
    memory.sliding = false;
    if was_open {
        // Shear starts anew where the point closes.
        let sigma = elastic(springs, start, at, memory)[0];
        if sigma >= 0.0 {
            return ([0.0; 3], loss);
        }
        memory.open = false;
        // So that its spring is stretched by the way of this step alone.
        memory.slip = [0, 1].map(|k| at[k + 1] - moved[k + 1] + start[k + 1] / springs[1]);
    }
    let trial = elastic(springs, start, at, memory);
    let before = if was_open {
        [0.0; 3]
    } else {
        [0, 1, 2].map(|k| trial[k] - springs[k.min(1)] * moved[k])
    };
    let (sigma, tau) = (trial[0], norm(trial[1], trial[2]));
    if !memory.broken {
        if law.holds(sigma, tau) {
            return (trial, loss);
        }
        memory.broken = true;
        if sigma > 0.0 {
            memory.open = true;
            loss.fracture = released(springs, &before, moved, 0);
            return ([0.0; 3], loss);
        }
    }
    // It has no tension to lose any more: what its shear spring held was friction.
    if sigma >= 0.0 {
        memory.open = true;
        loss.friction = released(springs, &before, moved, 1);
        return ([0.0; 3], loss);
    }
    let limit = law.residual(sigma);
    if tau <= limit {
        return (trial, loss);
    }
    memory.sliding = true;
    let plastic = (tau - limit) / springs[1];
    let keep = (tau - springs[1] * plastic).max(0.0) / tau;
    let t = [sigma, keep * trial[1], keep * trial[2]];
    for k in 0..2 {
        let slip = (trial[k + 1] - t[k + 1]) / springs[1];
        memory.slip[k] += slip;
        // The traction has gone from `before` to `t`, so their mean has worked on the slip.
        loss.friction += 0.5 * (before[k + 1] + t[k + 1]) * slip;
    }
    (t, loss)
}

/// Constants of [`plain_point`].
#[derive(Clone, Copy, Debug, Default)]
pub struct PlainLaw {
    /// Normal and shear stiffness, Pa/m.
    pub springs: Springs,
    /// Cohesion and tensile strength, Pa, tan of the friction angle.
    pub peak: [f64; 3],
    /// Residual cohesion, Pa, and tan of the residual friction angle.
    pub residual: [f64; 2],
}

/// State of [`plain_point`]; broken, open and sliding are 1 or 0.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Plain {
    /// Irrecoverable shear displacement along b and c, m.
    pub slip: [f64; 2],
    /// Whether it has failed.
    pub broken: f64,
    /// Whether it is open.
    pub open: f64,
    /// Whether it slid in the last step.
    pub sliding: f64,
}

/// [`point`] without normal_offset, and without branches, so that many points can go side by side.
#[inline(always)]
#[must_use]
pub fn plain_point(
    law: &PlainLaw,
    start: &Traction,
    at: &[f64; 3],
    moved: &[f64; 3],
    before: &Plain,
) -> (Traction, Plain, Loss) {
    let [kn, ks] = law.springs;
    let was_open = before.open != 0.0;
    let was_whole = before.broken == 0.0;
    let sigma = start[0] + kn * at[0];
    // Shear starts anew where a point closes.
    let closes = was_open && sigma < 0.0;
    let anew = |k: usize| at[k + 1] - moved[k + 1] + start[k + 1] / ks;
    let slip = [0, 1].map(|k| if closes { anew(k) } else { before.slip[k] });
    let shear = [0, 1].map(|k| start[k + 1] + ks * (at[k + 1] - slip[k]));
    let tau = norm(shear[0], shear[1]);
    let old = |t: f64, k: f64, u: f64| if was_open { 0.0 } else { t - k * u };
    let old = [old(sigma, kn, moved[0]), old(shear[0], ks, moved[1]), old(shear[1], ks, moved[2])];
    let peak = shear_strength(law.peak[0], law.peak[2], sigma);
    let holds = was_whole & (sigma <= law.peak[1]) & (tau <= peak);
    let opens = !holds & (sigma >= 0.0);
    // Failed in shear without any pressure it opens too, but nothing has torn.
    let tears = opens & was_whole & (sigma > 0.0);
    let limit = shear_strength(law.residual[0], law.residual[1], sigma);
    let slides = !holds & !opens & (tau > limit);
    let keep = if slides { limit / tau } else { 1.0 };
    let keep = if opens { 0.0 } else { keep };
    let t = [if opens { 0.0 } else { sigma }, keep * shear[0], keep * shear[1]];
    let gone = [0, 1].map(|k| if slides { (shear[k] - t[k + 1]) / ks } else { 0.0 });
    let rubbed = 0.5 * ((old[1] + t[1]) * gone[0] + (old[2] + t[2]) * gone[1]);
    // What was stored, and the work of the last step, in which the traction falls to nothing.
    let lost = |k: usize, spring: f64| 0.5 * old[k] * (old[k] / spring + moved[k]);
    let shear_lost = lost(1, ks) + lost(2, ks);
    let loss = Loss {
        friction: if opens & !tears { shear_lost } else { rubbed },
        fracture: if tears { shear_lost + lost(0, kn) } else { 0.0 },
    };
    let after = Plain {
        slip: [slip[0] + gone[0], slip[1] + gone[1]],
        broken: if holds { 0.0 } else { 1.0 },
        open: if opens { 1.0 } else { 0.0 },
        sliding: if slides { 1.0 } else { 0.0 },
    };
    (t, after, loss)
}

/// Stored energy that a point loses when it opens, with the work of its last step; `from` = 0 counts all
/// components, 1 shear only.
#[inline]
fn released(springs: Springs, before: &Traction, moved: &[f64; 3], from: usize) -> f64 {
    (from..3).map(|k| 0.5 * before[k] * (before[k] / springs[k.min(1)] + moved[k])).sum()
}

/// Traction that a point carries with the memory it has.
#[inline]
#[must_use]
pub fn carried(
    springs: Springs,
    start: &Traction,
    at: &[f64; 3],
    memory: &Memory,
    alone: bool,
) -> Traction {
    let t = elastic(springs, start, at, memory);
    if memory.open && alone {
        [0.0; 3]
    } else if memory.open {
        [0.0, t[1], t[2]]
    } else {
        t
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    pub(super) fn strength() -> Strength {
        Strength {
            cohesion: 1e6,
            tension: 0.3e6,
            friction: 0.6,
            residual_friction: 0.5,
            residual_cohesion: 0.1e6,
            dilation: 0.0,
            dilation_end: 0.0,
        }
    }

    /// A path that tears, closes, slides, opens and closes again.
    fn path() -> Vec<[f64; 3]> {
        let wave = |k: usize, f: f64, a: f64| a * libm::sin(f * k as f64);
        (0..4000)
            .map(|k| {
                let n = match k {
                    0..30 => 2e-6 * k as f64,
                    _ => wave(k, 0.013, 4e-5) - 1.2e-5,
                };
                [n, wave(k, 0.0171, 2.5e-4), wave(k, 0.0093, 1.5e-4)]
            })
            .collect()
    }

    #[test]
    fn the_branch_free_point_is_the_same_law() {
        let (law, springs, start) = (strength(), [2e10, 1e10], [-1e5, 2e4, -3e4]);
        let plain = PlainLaw {
            springs,
            peak: [law.cohesion, law.tension, law.friction],
            residual: [law.residual_cohesion, law.residual_friction],
        };
        let (mut memory, mut state) = (Memory::default(), Plain::default());
        let mut before = [0.0; 3];
        let (mut slid, mut tore, mut opened) = (0, 0, 0);
        for at in path() {
            let moved = [0, 1, 2].map(|k| at[k] - before[k]);
            let (t, loss) = point(&law, springs, &start, &at, &moved, &mut memory);
            let (u, after, other) = plain_point(&plain, &start, &at, &moved, &state);
            state = after;
            before = at;
            for k in 0..3 {
                assert!((t[k] - u[k]).abs() < 1e-3, "{t:?} {u:?}");
            }
            assert_eq!(memory.broken, state.broken == 1.0);
            assert_eq!(memory.open, state.open == 1.0);
            assert_eq!(memory.sliding, state.sliding == 1.0);
            assert!((loss.friction - other.friction).abs() < 1e-6 * (1.0 + loss.friction.abs()));
            assert!((loss.fracture - other.fracture).abs() < 1e-6 * (1.0 + loss.fracture.abs()));
            slid += usize::from(memory.sliding);
            tore += usize::from(loss.fracture > 0.0);
            opened += usize::from(memory.open);
        }
        assert!(slid > 100 && tore == 1 && opened > 100, "{slid} {tore} {opened}");
    }

    #[test]
    fn losses_are_work_less_stored_energy() {
        // Friction and fracture over a path that stays closed or opens once: work done on the point is what it
        // stores and what it has lost.
        let (law, springs) = (strength(), [2e10, 1e10]);
        let mut memory = Memory::default();
        let (mut work, mut lost, mut before, mut old) = (0.0, 0.0, [0.0; 3], [0.0; 3]);
        for k in 0..20_000 {
            let x = 1e-8 * f64::from(k);
            let at = [-5e-5 + 0.2 * x, 1.3 * x, 0.4 * x];
            let moved = [0, 1, 2].map(|k| if x == 0.0 { 0.0 } else { at[k] - before[k] });
            let (t, loss) = point(&law, springs, &[0.0; 3], &at, &moved, &mut memory);
            if k > 0 {
                work += (0..3).map(|k| 0.5 * (old[k] + t[k]) * moved[k]).sum::<f64>();
                lost += loss.friction + loss.fracture;
            } else {
                work = stored(springs, &t);
            }
            (before, old) = (at, t);
        }
        let held = stored(springs, &old);
        assert!(lost > 0.0);
        assert!((work - held - lost).abs() < 1e-9 * work, "{work} {held} {lost}");
    }
}
