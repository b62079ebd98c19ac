//! Law of a face patch with four points: elastic, or Mohr-Coulomb with tension cut-off.
//!
//! Stress is tension-positive; (n, b, c) is the frame of the patch and the traction that on its first
//! block. Total form: the elastic traction follows from the whole relative displacement less what is
//! irrecoverable, so that elastic forces are gradients and forget no step.
//!
//! Source: Tian & Li, equations (17) and (18): peak `|tau| <= c - sigma tan(phi)`, after failure
//! `|tau| <= -sigma tan(phi)` and no tension. Deviation: residual cohesion and dilation are added (non-associated
//! flow, closed-form return), and torsion counts when the whole face fails as one.

use serde::{Deserialize, Serialize};

/// Signs of the four points along b and along c.
pub const SIGNS: [[f64; 4]; 2] = [[-1.0, 1.0, 1.0, -1.0], [-1.0, -1.0, 1.0, 1.0]];

/// Mohr-Coulomb strength with tension cut-off.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Strength {
    /// Cohesion, Pa.
    pub cohesion: f64,
    /// Tensile strength, Pa.
    pub tension: f64,
    /// tan of the friction angle before failure.
    pub friction: f64,
    /// tan of the friction angle after failure.
    pub residual_friction: f64,
    /// Cohesion after failure, Pa.
    pub residual_cohesion: f64,
    /// tan of the dilation angle of a sliding point.
    pub dilation: f64,
    /// Plastic shear displacement at which dilation ends, m.
    pub dilation_end: f64,
}

/// Traction at a point: n, b, c, Pa.
pub type Traction = [f64; 3];

/// What a point remembers.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Memory {
    /// Irrecoverable shear displacement along b and c, m.
    pub slip: [f64; 2],
    /// Opening at which the normal spring is relaxed, m.
    pub lift: f64,
    /// Length of the path of plastic shear, m.
    pub path: f64,
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
        start[0] + springs[0] * (at[0] - memory.lift),
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
        let limit = (law.cohesion - sigma * law.friction).max(0.0);
        if sigma <= law.tension && tau <= limit {
            return (trial, loss);
        }
        memory.broken = true;
        if sigma > 0.0 {
            memory.open = true;
            loss.fracture = released(springs, &before, moved, 0);
            return ([0.0; 3], loss);
        }
    }
    if sigma >= 0.0 {
        memory.open = true;
        loss.friction = released(springs, &before, moved, 1);
        return ([0.0; 3], loss);
    }
    let limit = (law.residual_cohesion - sigma * law.residual_friction).max(0.0);
    if tau <= limit {
        return (trial, loss);
    }
    memory.sliding = true;
    let plastic = flow(law, springs, tau - limit, memory);
    let lifted = memory.lift;
    let more = (plastic).min((law.dilation_end - memory.path).max(0.0)) * law.dilation;
    memory.lift += more;
    memory.path += plastic;
    let keep = (tau - springs[1] * plastic).max(0.0) / tau;
    let t = [
        sigma - springs[0] * (memory.lift - lifted),
        keep * trial[1],
        keep * trial[2],
    ];
    for k in 0..2 {
        let slip = (trial[k + 1] - t[k + 1]) / springs[1];
        memory.slip[k] += slip;
        loss.friction += 0.5 * (before[k + 1] + t[k + 1]) * slip;
    }
    loss.friction += 0.5 * (before[0] + t[0]) * (memory.lift - lifted);
    (t, loss)
}

/// Plastic shear (m) that brings a point, `excess` (Pa) above its limit, back to it: dilation presses it
/// together, which raises the limit, until dilation ends.
fn flow(law: &Strength, springs: Springs, excess: f64, memory: &Memory) -> f64 {
    let left = (law.dilation_end - memory.path).max(0.0);
    if law.dilation <= 0.0 || left <= 0.0 {
        return excess / springs[1];
    }
    let rate = springs[1] + springs[0] * law.residual_friction * law.dilation;
    if excess <= rate * left {
        excess / rate
    } else {
        left + (excess - rate * left) / springs[1]
    }
}

/// Stored energy that a point loses when it opens, with the work of its last step; `from` = 0 counts all
/// components, 1 shear only.
fn released(springs: Springs, before: &Traction, moved: &[f64; 3], from: usize) -> f64 {
    (from..3)
        .map(|k| 0.5 * before[k] * (before[k] / springs[k.min(1)] + moved[k]))
        .sum()
}

/// A face that fails as one: by the mean traction of its points and by its torsion moment.
///
/// `places` are the points along b and c, m. Intact, its points are elastic; failed, its points carry no
/// tension, and mean shear and torsion shrink together to the residual limit.
#[must_use]
pub fn face(
    law: &Strength,
    springs: Springs,
    start: &[Traction; 4],
    at: &[[f64; 3]; 4],
    moved: &[[f64; 3]; 4],
    reach: [f64; 2],
    memory: &mut [Memory; 4],
) -> ([Traction; 4], Loss) {
    let mut loss = Loss::default();
    let was_open = memory[0].open && memory.iter().all(|m| m.open);
    let mut t: [Traction; 4] =
        std::array::from_fn(|p| elastic(springs, &start[p], &at[p], &memory[p]));
    if was_open {
        for p in 0..4 {
            for k in 0..2 {
                memory[p].slip[k] = at[p][k + 1] - moved[p][k + 1] + start[p][k + 1] / springs[1];
            }
            t[p] = elastic(springs, &start[p], &at[p], &memory[p]);
        }
    }
    let trial = t;
    let before: [Traction; 4] = std::array::from_fn(|p| {
        if was_open {
            [0.0; 3]
        } else {
            let t: Traction =
                std::array::from_fn(|k| trial[p][k] - springs[k.min(1)] * moved[p][k]);
            if memory[p].broken {
                [t[0].min(0.0), t[1], t[2]]
            } else {
                t
            }
        }
    });
    let sums = Sums::of(&t, reach);
    let intact = !memory[0].broken;
    for m in memory.iter_mut() {
        m.sliding = false;
    }
    if intact {
        let limit = (law.cohesion - sums.normal * law.friction).max(0.0);
        if sums.normal <= law.tension && sums.shear_measure(reach) <= limit {
            return (t, loss);
        }
        for m in memory.iter_mut() {
            m.broken = true;
        }
    }
    // Failed: no tension at any point.
    let mut pressed = 0.0;
    for (point, m) in t.iter_mut().zip(memory.iter_mut()) {
        point[0] = point[0].min(0.0);
        m.open = point[0] == 0.0;
        pressed -= 0.25 * point[0];
    }
    let closed = pressed > 0.0;
    let limit = if closed {
        law.residual_cohesion + pressed * law.residual_friction
    } else {
        0.0
    };
    let measure = sums.shear_measure(reach);
    let keep = if measure > limit {
        limit / measure
    } else {
        1.0
    };
    let slides = keep < 1.0;
    for p in 0..4 {
        let [b, c] = [SIGNS[0][p] * reach[0], SIGNS[1][p] * reach[1]];
        if slides {
            t[p][1] = keep * (sums.shear[0] - sums.twist * c);
            t[p][2] = keep * (sums.shear[1] + sums.twist * b);
        }
        if intact && trial[p][0] > 0.0 {
            loss.fracture += 0.25 * released(springs, &[before[p][0], 0.0, 0.0], &moved[p], 0);
        }
        for k in 0..2 {
            let slip = (trial[p][k + 1] - t[p][k + 1]) / springs[1];
            if slides {
                memory[p].slip[k] += slip;
                loss.friction += 0.125 * (before[p][k + 1] + t[p][k + 1]) * slip;
            }
        }
        memory[p].sliding = slides && closed;
    }
    (t, loss)
}

/// Mean traction and twist of four points.
struct Sums {
    normal: f64,
    shear: [f64; 2],
    /// Shear traction per distance from the centre, Pa/m.
    twist: f64,
}

impl Sums {
    fn of(t: &[Traction; 4], reach: [f64; 2]) -> Self {
        let mean = |k: usize| 0.25 * (t[0][k] + t[1][k] + t[2][k] + t[3][k]);
        let mut moment = 0.0;
        for p in 0..4 {
            moment += 0.25 * (SIGNS[0][p] * reach[0] * t[p][2] - SIGNS[1][p] * reach[1] * t[p][1]);
        }
        Self {
            normal: mean(0),
            shear: [mean(1), mean(2)],
            twist: moment / (reach[0] * reach[0] + reach[1] * reach[1]),
        }
    }

    /// Mean shear and torsion in one number: torsion counts as the shear it makes at the points.
    fn shear_measure(&self, reach: [f64; 2]) -> f64 {
        let twist = self.twist * norm(reach[0], reach[1]);
        norm(norm(self.shear[0], self.shear[1]), twist)
    }
}

/// Square root of a sum of squares, the same bits on every machine.
fn norm(a: f64, b: f64) -> f64 {
    (a * a + b * b).sqrt()
}

/// Traction that a point carries with the memory it has.
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
