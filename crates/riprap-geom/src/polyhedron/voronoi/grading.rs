//! How large cells are where: sizes that grow with the distance from places, random sites as dense as that asks, and the sites
//! that stay where they are because their cells are the room of a charge.

use crate::Vec3;
use crate::random::Chance;

/// Where cells are finest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Finest {
    /// A segment, m; a point where both ends are one.
    Segment(Vec3, Vec3),
    /// A plane through a point, m, with a unit normal.
    Plane(Vec3, Vec3),
    /// A ball: centre and radius, m.
    Ball(Vec3, f64),
    /// A box: lowest and highest corner, m.
    Box(Vec3, Vec3),
}

impl Finest {
    /// Its point that is nearest to another one.
    fn nearest(&self, point: Vec3) -> Vec3 {
        match *self {
            Self::Segment(from, to) => {
                let along = to - from;
                let square = along.length_squared();
                let share = if square > 0.0 { (point - from).dot(along) / square } else { 0.0 };
                from + share.clamp(0.0, 1.0) * along
            }
            Self::Plane(at, normal) => point - (point - at).dot(normal) * normal,
            Self::Ball(centre, radius) => centre + (point - centre).clamp_length_max(radius),
            Self::Box(min, max) => point.clamp(min, max),
        }
    }
}

/// Edge of a cell, about, as a function of the place: `from` at the places `at`, growing evenly to `to` at the distance `over`, m.
#[derive(Clone, Debug, PartialEq)]
pub struct Grading {
    /// Edge of the finest cells, m.
    pub from: f64,
    /// Edge of the others, m.
    pub to: f64,
    /// Distance over which it grows, m.
    pub over: f64,
    /// Where cells are finest.
    pub at: Vec<Finest>,
}

impl Grading {
    /// Growth of the edge with the distance.
    #[must_use]
    pub fn slope(&self) -> f64 {
        (self.to - self.from) / self.over
    }

    /// Edge of a cell at a place, m.
    #[must_use]
    pub fn size(&self, at: Vec3) -> f64 {
        self.size_and_slope(at).0
    }

    /// Edge of a cell at a place, m, and how it changes with the place.
    pub(super) fn size_and_slope(&self, at: Vec3) -> (f64, Vec3) {
        let away = self.at.iter().map(|finest| at - finest.nearest(at));
        let least = away.min_by(|a, b| a.length_squared().total_cmp(&b.length_squared()));
        let distance = least.map_or(f64::INFINITY, Vec3::length);
        if distance >= self.over {
            return (self.to, Vec3::ZERO);
        }
        let direction = least.unwrap_or(Vec3::ZERO).normalize_or_zero();
        (self.from + self.slope() * distance, self.slope() * direction)
    }

    /// About how many cells a box gets; no more than about `most` are counted.
    #[must_use]
    pub fn count(&self, min: Vec3, max: Vec3, most: f64) -> f64 {
        let mut count = 0.0;
        self.leaves(min, max, |_, _, expected| {
            count += expected;
            count <= most
        });
        count
    }

    /// Along which edges a box has one layer of cells.
    fn flat(&self, min: Vec3, max: Vec3) -> [bool; 3] {
        [0, 1, 2].map(|a: usize| (max - min)[a] < 1.5 * self.from)
    }

    /// Halves a box until cells have about one size in each part, and hands the parts over, neighbours one after the other,
    /// with the number of cells expected there, while it is answered with yes.
    fn leaves(&self, min: Vec3, max: Vec3, mut visit: impl FnMut(Vec3, Vec3, f64) -> bool) {
        let flat = self.flat(min, max);
        let mut waiting = vec![(min, max)];
        while let Some((low, high)) = waiting.pop() {
            let extent = high - low;
            let longest = (0..3).filter(|a| !flat[*a]).max_by(|a, b| {
                // The first of equal ones.
                extent[*a].total_cmp(&extent[*b]).then(b.cmp(a))
            });
            let middle = 0.5 * (low + high);
            let size = self.size(middle);
            // The least size in the part: sizes change by no more than the slope.
            let least = (size - self.slope() * 0.5 * extent.length()).max(self.from);
            match longest.filter(|a| extent[*a] > least) {
                Some(axis) => {
                    let (mut below, mut above) = (high, low);
                    (below[axis], above[axis]) = (middle[axis], middle[axis]);
                    waiting.push((above, high));
                    waiting.push((low, below));
                }
                None => {
                    let sides = (0..3).filter(|a| !flat[*a]).map(|a| extent[a] / size);
                    if !visit(low, high, sides.product()) {
                        return;
                    }
                }
            }
        }
    }

    /// Random sites in a box, as dense as cells are small, none nearer to a charge than its own.
    pub(super) fn sites(&self, min: Vec3, max: Vec3, charges: &[Charge], seed: u64) -> Vec<Vec3> {
        let (flat, middle) = (self.flat(min, max), 0.5 * (min + max));
        let (mut chance, mut owed, mut sites) = (Chance::new(seed), 0.5, Vec::new());
        self.leaves(min, max, |low, high, expected| {
            owed += expected;
            while owed >= 1.0 {
                owed -= 1.0;
                let site = Vec3::from_array([0, 1, 2].map(|a: usize| {
                    let at = chance.between(low[a], high[a]);
                    if flat[a] { middle[a] } else { at }
                }));
                let clear = |charge: &Charge| {
                    let away = site - Finest::Segment(charge.from, charge.to).nearest(site);
                    away.length() >= charge.width() + 0.5 * self.from
                };
                if charges.iter().all(clear) {
                    sites.push(site);
                }
            }
            true
        });
        sites
    }
}

/// The part of a hole that is charged; a ball where both ends are one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Charge {
    /// One end, m.
    pub from: Vec3,
    /// The other end, m.
    pub to: Vec3,
    /// Volume of the explosive, m³.
    pub volume: f64,
}

/// An end of the room of an elongated charge lies this share of a layer beyond the charge, which would else touch the next cell.
const BEYOND: f64 = 1e-3;

impl Charge {
    /// Diameter of the ball or the cylinder with this volume, m.
    #[must_use]
    pub fn width(&self) -> f64 {
        let length = self.from.distance(self.to);
        if length == 0.0 {
            return 2.0 * libm::cbrt(0.75 * self.volume / std::f64::consts::PI);
        }
        2.0 * (self.volume / (std::f64::consts::PI * length)).sqrt()
    }

    /// Power of its width with which the volume of its room grows.
    pub(super) fn power(&self) -> f64 {
        if self.from == self.to { 3.0 } else { 2.0 }
    }

    /// The sites whose cells are the room of the charge, and those around, which make its walls: `width` (m) away. As many as are
    /// about `edge` (m) from each other where `width` is that of the charge.
    pub(super) fn room(&self, width: f64, edge: f64) -> [Vec<Vec3>; 2] {
        if self.from == self.to {
            let around = directions(
                std::f64::consts::PI * (2.0 * self.width() / edge) * (2.0 * self.width() / edge),
            );
            let walls = around.into_iter().map(|direction| self.from + width * direction);
            return [vec![self.from], walls.collect()];
        }
        let length = self.from.distance(self.to);
        let along = (self.to - self.from) / length;
        let (b, c) = along.any_orthonormal_pair();
        let sides = (std::f64::consts::TAU * self.width() / edge).round().clamp(6.0, 24.0) as u32;
        let layers = (length / edge).round().max(1.0) as u32;
        let layer = length / f64::from(layers);
        let own = (0..layers).map(|k| self.from + (f64::from(k) + 0.5) * layer * along).collect();
        let cap = (0.5 + 2.0 * BEYOND) * layer * along;
        let caps = [self.from - cap, self.to + cap];
        let mut walls = caps.to_vec();
        for at in caps.into_iter().chain(Vec::clone(&own)) {
            walls.extend((0..sides).map(|k| {
                let angle = std::f64::consts::TAU * f64::from(k) / f64::from(sides);
                at + width * (libm::cos(angle) * b + libm::sin(angle) * c)
            }));
        }
        [own, walls]
    }
}

/// About `count` unit vectors, evenly round about: the corners of an icosahedron, and the middles of its faces or of its
/// edges with them.
fn directions(count: f64) -> Vec<Vec3> {
    let golden = 0.5 * (1.0 + 5f64.sqrt());
    let mut corners = Vec::new();
    for (x, y) in [(1.0, golden), (1.0, -golden), (-1.0, golden), (-1.0, -golden)] {
        corners.extend([Vec3::new(0.0, x, y), Vec3::new(x, y, 0.0), Vec3::new(y, 0.0, x)]);
    }
    // Neighbours are 2 apart.
    let near = |a: Vec3, b: Vec3| (a.distance(b) - 2.0).abs() < 0.1;
    let mut found = corners.clone();
    for (j, &a) in corners.iter().enumerate() {
        for (k, &b) in corners.iter().enumerate().skip(j + 1).filter(|(_, b)| near(a, **b)) {
            if count >= 37.0 {
                found.push(a + b);
            } else if count >= 20.0 {
                let third = corners[k + 1..].iter().filter(|c| near(a, **c) && near(b, **c));
                found.extend(third.map(|c| a + b + *c));
            }
        }
    }
    found.into_iter().map(Vec3::normalize).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_and_numbers() {
        let grading = Grading {
            from: 0.1,
            to: 0.5,
            over: 2.0,
            at: vec![Finest::Segment(Vec3::ZERO, Vec3::Z), Finest::Ball(Vec3::splat(9.0), 1.0)],
        };
        for (at, size) in [
            (Vec3::new(0.0, 0.0, 0.3), 0.1),
            (Vec3::new(1.0, 0.0, 0.3), 0.3),
            (Vec3::new(0.0, 0.0, 2.0), 0.3),
            (Vec3::new(5.0, 0.0, 0.3), 0.5),
            (Vec3::splat(9.3), 0.1),
        ] {
            assert!((grading.size(at) - size).abs() < 1e-12, "{at}");
        }
        // Of one size a box has its volume over that of a cell, and a plate its area.
        let even = Grading { from: 0.25, to: 0.25, over: 1.0, at: Vec::new() };
        let (low, high) = (Vec3::splat(-1.0), Vec3::new(1.0, 1.0, 2.0));
        assert!((even.count(low, high, 1e9) - 768.0).abs() < 1e-9);
        assert!((even.count(low, Vec3::new(1.0, 1.0, -0.9), 1e9) - 64.0).abs() < 1e-9);
        assert_eq!(even.sites(low, high, &[], 1).len(), 768);
        assert!(grading.count(low, high, 100.0) < 200.0);
        for (count, found) in [(1.0, 12), (25.0, 32), (50.0, 42)] {
            let all = directions(count);
            assert_eq!(all.len(), found);
            assert!(all.iter().sum::<Vec3>().length() < 1e-12);
        }
    }
}
