//! Peak speeds around a charge: how they fall with the distance, and how round their contours are.
//!
//! Springs along the axes carry waves at different speeds in different directions, so that around a charge the contours of a
//! lattice are not spheres. Blocks are bricks along the axes of space; so are the directions looked at.

use riprap_geom::Vec3;

use crate::query::view::View;
use crate::setup::Place;
use crate::state::cavity::Cavity;

/// Cosine of 15 degrees, half the opening of the cones that are looked at.
const CONE: f64 = 0.965_925_826_289_068_3;
/// Shells for each doubling of the distance.
const SHELLS: f64 = 4.0;

/// Distances over the radius of a ball as large as the cavity between which the attenuation is fitted.
const RANGE: std::ops::RangeInclusive<f64> = 2.0..=16.0;

/// Directions in which unevenness is looked for: to the neighbours of a cell in a lattice, or evenly round the axis of a line.
const DIRECTIONS: u32 = 26;
/// Cosines of half the opening of their cones: 22.5 and 15 degrees.
const CONES: [f64; 2] = [0.923_879_532_511_286_7, CONE];
/// Half the thickness of the shell that is looked at, as a logarithm of the distance.
const SHELL: f64 = 0.25 * std::f64::consts::LN_2;
/// Share of the length of a line charge about its middle beside which blocks are looked at.
const BESIDE: f64 = 0.5;
/// Widths of a cavity between which the attenuation across it is fitted.
const ACROSS: std::ops::RangeInclusive<f64> = 2.0..=12.0;

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

    /// Centre of a cavity; axis and half the length of that of a line; width: the diameter of the ball or cylinder with the volume of the
    /// removed blocks, m.
    fn form(&self, cavity: &Cavity) -> (Vec3, Option<(Vec3, f64)>, f64) {
        let centre = self.charge_centre(cavity);
        let pi = std::f64::consts::PI;
        match &self.world.setup.sources[usize::from(cavity.source)].place {
            Place::Line { from, to } => {
                let length = from.distance(*to);
                let width = 2.0 * (cavity.removed / (pi * length)).sqrt();
                (centre, Some(((*to - *from) / length, 0.5 * length)), width)
            }
            Place::Point { .. } | Place::Blocks { .. } => {
                (centre, None, 2.0 * libm::cbrt(0.75 * cavity.removed / pi))
            }
        }
    }

    /// Direction from the charge, or across its axis beside the middle of a line, and logarithms of distance over its width and peak speed
    /// (m/s), of the blocks that have moved.
    fn around(&self, cavity: &Cavity) -> Vec<(Vec3, [f64; 2])> {
        let (centre, line, width) = self.form(cavity);
        let point = |b: usize| {
            let mut arm = self.world.reference[b] - centre;
            if let Some((axis, half)) = line {
                let along = arm.dot(axis);
                if along.abs() > BESIDE * half {
                    return None;
                }
                arm -= along * axis;
            }
            let (r, v) = (arm.length(), self.peak_speed(b));
            (r > 0.0 && v > 0.0).then(|| (arm / r, [libm::log(r / width), libm::log(v)]))
        };
        self.living().filter_map(point).collect()
    }

    /// Exponent n of the law v = K r^-n of the peak speed across a charge, from 2 to 12 widths of the cavity: r is the distance from
    /// the axis of a line, beside the middle half of it, else from the centre. Least squares in logarithms over the means of shells.
    #[must_use]
    pub fn attenuation_across(&self, cavity: &Cavity) -> f64 {
        let within = |p: &[f64; 2]| ACROSS.contains(&libm::exp(p[0]));
        let points = self.around(cavity).into_iter().map(|(_, p)| p);
        -slope(&shells(points.filter(within).collect()))
    }

    /// Largest departure, as a share of their mean, of the peak speeds in 26 directions at a distance of `widths` of the cavity: means
    /// over the blocks within a cone and a shell, brought to that distance by the attenuation there. NaN with an empty cone.
    #[must_use]
    pub fn unevenness(&self, cavity: &Cavity, widths: f64) -> f64 {
        let axis = self.form(cavity).1.map(|(axis, _)| axis);
        uneven(&self.around(cavity), axis, libm::log(widths))
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

/// Unevenness of points around a centre or an axis at a distance, as a logarithm.
fn uneven(points: &[(Vec3, [f64; 2])], axis: Option<Vec3>, distance: f64) -> f64 {
    let near = |reach: f64| points.iter().filter(move |(_, p)| (p[0] - distance).abs() <= reach);
    let power = slope(&near(4.0 * SHELL).map(|(_, p)| *p).collect::<Vec<_>>());
    let cone = CONES[usize::from(axis.is_some())];
    let speeds = directions(axis).into_iter().map(|direction| {
        let (mut sum, mut count) = (0.0, 0.0);
        for (_, p) in near(SHELL).filter(|(to, _)| to.dot(direction) >= cone) {
            sum += p[1] - power * (p[0] - distance);
            count += 1.0;
        }
        libm::exp(sum / count)
    });
    let speeds: Vec<f64> = speeds.collect();
    let mean = speeds.iter().sum::<f64>() / f64::from(DIRECTIONS);
    // An empty cone makes all of it NaN.
    speeds.iter().fold(0.0 * mean, |worst, v| f64::max(worst, (v / mean - 1.0).abs()))
}

fn directions(axis: Option<Vec3>) -> Vec<Vec3> {
    if let Some(axis) = axis {
        let (b, c) = axis.any_orthonormal_pair();
        let step = std::f64::consts::TAU / f64::from(DIRECTIONS);
        let at = |k| libm::cos(step * f64::from(k)) * b + libm::sin(step * f64::from(k)) * c;
        return (0..DIRECTIONS).map(at).collect();
    }
    let steps = [-1.0, 0.0, 1.0];
    let all = steps.into_iter().flat_map(|x| {
        steps.into_iter().flat_map(move |y| steps.into_iter().map(move |z| Vec3::new(x, y, z)))
    });
    all.filter(|d| *d != Vec3::ZERO).map(Vec3::normalize).collect()
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

    /// A field whose speed is half as large again along one axis is uneven by what the cones there depart from the mean; an even one
    /// is not, whatever its decay, and a gap is not a number.
    #[test]
    fn unevenness_is_the_largest_departure() {
        for axis in [None, Some(Vec3::Y)] {
            let field = |more: f64| -> Vec<(Vec3, [f64; 2])> {
                let to = directions(axis);
                let mut points = Vec::new();
                for k in -4..=4 {
                    let r = 1.0 + 0.1 * f64::from(k);
                    for d in &to {
                        let v = if d.dot(to[0]) > 0.999 { more } else { 1.0 } / r;
                        points.push((*d, [libm::log(3.0 * r), libm::log(v)]));
                    }
                }
                points
            };
            let at = libm::log(3.0);
            assert!(uneven(&field(1.0), axis, at) < 1e-9);
            let one = uneven(&field(1.5), axis, at);
            // Cones about a line overlap: three directions take part in each.
            let wanted = if axis.is_some() { 0.12 } else { 0.47 };
            assert!((one - wanted).abs() < 0.05, "{one}");
            let mut gap = field(1.0);
            let first = directions(axis)[0];
            gap.retain(|(d, _)| d.dot(first) < 0.7);
            assert!(uneven(&gap, axis, at).is_nan());
        }
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
