//! Peak speeds around a charge: how they fall with the distance, and how round their contours are.
//!
//! Springs along the axes carry waves at different speeds in different directions, so that around a charge the contours of a
//! lattice are not spheres. Blocks are bricks along the axes of space; so are the directions looked at.

use riprap_geom::Vec3;

use crate::query::view::View;
use crate::state::cavity::Cavity;

/// Cosine of 15 degrees, half the opening of the cones that are looked at.
const CONE: f64 = 0.965_925_826_289_068_3;
/// Shells for each doubling of the distance.
const SHELLS: f64 = 4.0;

/// Distances over the radius of a ball as large as the cavity between which the attenuation is fitted.
const RANGE: std::ops::RangeInclusive<f64> = 2.0..=16.0;

/// Mean logarithms of distance (m) and peak speed (m/s) over shells, from the inside outwards.
type Curve = Vec<[f64; 2]>;

impl View<'_> {
    /// Exponent n of the law v = K r^-n of the peak speed around a cavity, from 2 to 16 radii of a ball with the
    /// volume of the removed blocks: least squares in logarithms over the means of shells; NaN with fewer than two.
    #[must_use]
    pub fn attenuation(&self, cavity: &Cavity) -> f64 {
        let radius = libm::cbrt(3.0 * cavity.removed / (4.0 * std::f64::consts::PI));
        let within = |p: &[f64; 2]| RANGE.contains(&(libm::exp(p[0]) / radius));
        let points = self.peaks(cavity).filter(|(_, p)| within(p));
        -slope(&shells(points.map(|(_, p)| p).collect()))
    }

    /// Direction (without signs) from the charge, and logarithms of distance (m) and peak speed (m/s), of the blocks
    /// that have moved.
    fn peaks(&self, cavity: &Cavity) -> impl Iterator<Item = (Vec3, [f64; 2])> + '_ {
        let centre = self.charge_centre(cavity);
        self.living().filter_map(move |b| {
            let arm = (self.world.reference[b] - centre).abs();
            let (r, v) = (arm.length(), self.peak_speed(b));
            (r > 0.0 && v > 0.0).then(|| (arm / r, [libm::log(r), libm::log(v)]))
        })
    }

    /// Radius along the axes over that along the diagonals of space of the contours of the peak speed around a
    /// cavity (geometric mean over contours); 1 is round, NaN without contours that reach both.
    #[must_use]
    pub fn roundness(&self, cavity: &Cavity) -> f64 {
        let (mut axes, mut diagonals) = (Vec::new(), Vec::new());
        for (direction, point) in self.peaks(cavity) {
            if direction.max_element() > CONE {
                axes.push(point);
            } else if direction.dot(Vec3::ONE) > 3f64.sqrt() * CONE {
                diagonals.push(point);
            }
        }
        ratio(&shells(axes), &shells(diagonals))
    }
}

/// Sorts by distance and averages over shells.
fn shells(mut points: Curve) -> Curve {
    points.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
    let shell = |p: &[f64; 2]| (SHELLS * p[0] / std::f64::consts::LN_2).floor();
    points
        .chunk_by(|a, b| shell(a) == shell(b))
        .map(|s| [0, 1].map(|k| s.iter().map(|p| p[k]).sum::<f64>() / s.len() as f64))
        .collect()
}

/// Slope of the line through the points, least squares.
fn slope(points: &[[f64; 2]]) -> f64 {
    let n = points.len() as f64;
    let mean = |k: usize| points.iter().map(|p| p[k]).sum::<f64>() / n;
    let [x, y] = [mean(0), mean(1)];
    let product: f64 = points.iter().map(|p| (p[0] - x) * (p[1] - y)).sum();
    let square: f64 = points.iter().map(|p| (p[0] - x) * (p[0] - x)).sum();
    product / square
}

/// Geometric mean of the distances along `a` over those along `b` at which both have the same speed; for each
/// shell of `a` the first place on `b`, from the inside, where the speed falls below that of the shell.
fn ratio(a: &[[f64; 2]], b: &[[f64; 2]]) -> f64 {
    let place = |level: f64| {
        let pair = b.windows(2).find(|w| w[0][1] >= level && w[1][1] < level)?;
        let share = (pair[0][1] - level) / (pair[0][1] - pair[1][1]);
        Some(pair[0][0] + share * (pair[1][0] - pair[0][0]))
    };
    let (mut sum, mut count) = (0.0, 0.0);
    for [distance, level] in a {
        if let Some(other) = place(*level) {
            sum += distance - other;
            count += 1.0;
        }
    }
    if count > 0.0 { libm::exp(sum / count) } else { f64::NAN }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// v = c/r²; along `b` the waves have gone 1.2 times as far.
    fn curve(stretch: f64) -> Curve {
        let radius = |k: i32| stretch * libm::exp(0.05 * f64::from(k));
        let point = |k| [radius(k), 7.0 * (stretch / radius(k)).powi(2)].map(libm::log);
        shells((0..60).map(point).collect())
    }

    #[test]
    fn contours_of_equal_speed_are_compared() {
        assert!((ratio(&curve(1.0), &curve(1.0)) - 1.0).abs() < 1e-12);
        let found = ratio(&curve(1.2), &curve(1.0));
        assert!((found - 1.2).abs() < 1e-9, "{found}");
        assert!(ratio(&curve(1.0), &[]).is_nan());
        assert!((slope(&curve(1.2)) + 2.0).abs() < 1e-9);
        assert!(slope(&[]).is_nan());
    }
}
