//! A face whose four points fail together.

use super::{Loss, Memory, SIGNS, Springs, Strength, Traction, elastic, norm, released};

/// A face that fails as one: by the mean traction of its points and by its torsion moment.
///
/// `places` are the points along b and c, m. Intact, its points are elastic; failed, its points carry no
/// tension, and mean shear and torsion shrink together to the residual limit.
#[inline]
#[must_use]
pub fn face(
    law: &Strength,
    springs: Springs,
    start: &[Traction; 4],
    at: &[[f64; 3]; 4],
    moved: &[[f64; 3]; 4],
    half_spacing: [f64; 2],
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
            if memory[p].broken { [t[0].min(0.0), t[1], t[2]] } else { t }
        }
    });
    let sums = Sums::of(&t, half_spacing);
    let intact = !memory[0].broken;
    for m in memory.iter_mut() {
        m.sliding = false;
    }
    if intact {
        if law.holds(sums.normal, sums.shear_measure(half_spacing)) {
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
    let limit = if closed { law.residual(-pressed) } else { 0.0 };
    let measure = sums.shear_measure(half_spacing);
    let keep = if measure > limit { limit / measure } else { 1.0 };
    let slides = keep < 1.0;
    for p in 0..4 {
        let [b, c] = [SIGNS[0][p] * half_spacing[0], SIGNS[1][p] * half_spacing[1]];
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
#[derive(Clone, Copy, Debug)]
pub struct Sums {
    /// Mean normal traction, Pa.
    pub normal: f64,
    /// Mean shear traction along b and c, Pa.
    pub shear: [f64; 2],
    /// Shear traction per distance from the centre, Pa/m.
    pub twist: f64,
}

impl Sums {
    /// Of tractions at points that lie `half_spacing` (m) from the centre along b and c.
    #[inline]
    #[must_use]
    pub fn of(t: &[Traction; 4], half_spacing: [f64; 2]) -> Self {
        let mean = |k: usize| 0.25 * (t[0][k] + t[1][k] + t[2][k] + t[3][k]);
        let mut moment = 0.0;
        for p in 0..4 {
            moment += 0.25
                * (SIGNS[0][p] * half_spacing[0] * t[p][2]
                    - SIGNS[1][p] * half_spacing[1] * t[p][1]);
        }
        Self {
            normal: mean(0),
            shear: [mean(1), mean(2)],
            twist: moment / (half_spacing[0] * half_spacing[0] + half_spacing[1] * half_spacing[1]),
        }
    }

    /// Mean shear and torsion in one number: torsion counts as the shear it makes at the points.
    #[inline]
    #[must_use]
    pub fn shear_measure(&self, half_spacing: [f64; 2]) -> f64 {
        let twist = self.twist * norm(half_spacing[0], half_spacing[1]);
        norm(norm(self.shear[0], self.shear[1]), twist)
    }
}

#[cfg(test)]
mod tests {
    use super::super::tests::strength;
    use super::*;

    #[test]
    fn a_face_fails_by_shear_and_torsion_together() {
        let (law, springs, half_spacing) = (strength(), [2e10, 1e10], [0.25, 0.25]);
        let start = [[-1e6, 0.0, 0.0]; 4];
        // Pure twist: the points half_spacing the shear limit all at once.
        let radius = 0.25 * 2f64.sqrt();
        let limit = law.peak(-1e6);
        let twist = |angle: f64| -> [[f64; 3]; 4] {
            std::array::from_fn(|p| [0.0, -SIGNS[1][p] * 0.25 * angle, SIGNS[0][p] * 0.25 * angle])
        };
        for (share, broken) in [(0.999, false), (1.001, true)] {
            let mut memory = [Memory::default(); 4];
            let at = twist(share * limit / (1e10 * radius));
            let moved = [[0.0; 3]; 4];
            let (t, _) = face(&law, springs, &start, &at, &moved, half_spacing, &mut memory);
            assert_eq!(memory[0].broken, broken);
            let size = norm(t[0][1], t[0][2]);
            let residual = law.residual(-1e6);
            let expected = if broken { residual } else { share * limit };
            assert!((size / expected - 1.0).abs() < 1e-9);
        }
    }
}
