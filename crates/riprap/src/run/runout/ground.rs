//! Height of the ground below a place.

use crate::Vec3;

/// Triangles in a bin of the plan, on average.
const FILL: f64 = 2.0;

/// Faces of what is held, with bins over the plan in which they are looked up.
#[derive(Clone, Debug, Default)]
pub(in crate::run) struct Ground {
    triangles: Vec<[Vec3; 3]>,
    low: [f64; 2],
    width: [f64; 2],
    counts: [usize; 2],
    bins: Vec<Vec<u32>>,
}

impl Ground {
    /// Ground of these triangles; vertical ones carry nothing.
    pub(in crate::run) fn new(triangles: Vec<[Vec3; 3]>) -> Self {
        let flat = |p: &Vec3| [p.x, p.y];
        let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
        for p in triangles.iter().flatten() {
            for (k, x) in flat(p).into_iter().enumerate() {
                (low[k], high[k]) = (low[k].min(x), high[k].max(x));
            }
        }
        if triangles.is_empty() {
            return Self::default();
        }
        let each = (triangles.len() as f64 / FILL).sqrt().ceil().clamp(1.0, 2000.0);
        let counts = [each as usize; 2];
        let width = [0, 1].map(|k| ((high[k] - low[k]) / each).max(f64::MIN_POSITIVE));
        let mut ground =
            Self { bins: vec![Vec::new(); counts[0] * counts[1]], triangles, low, width, counts };
        for k in 0..ground.triangles.len() {
            let corners = ground.triangles[k].map(|p| [ground.bin(0, p.x), ground.bin(1, p.y)]);
            let span = |axis: usize| {
                let of = corners.map(|c| c[axis]);
                of[0].min(of[1]).min(of[2])..=of[0].max(of[1]).max(of[2])
            };
            for y in span(1) {
                for x in span(0) {
                    ground.bins[y * counts[0] + x].push(k as u32);
                }
            }
        }
        ground
    }

    fn bin(&self, axis: usize, x: f64) -> usize {
        let at = ((x - self.low[axis]) / self.width[axis]).floor();
        (at.max(0.0) as usize).min(self.counts[axis] - 1)
    }

    /// Height of a place above the highest ground straight below it, m; `None` where there is none.
    pub(in crate::run) fn below(&self, at: Vec3) -> Option<f64> {
        if self.bins.is_empty() {
            return None;
        }
        let bin = &self.bins[self.bin(1, at.y) * self.counts[0] + self.bin(0, at.x)];
        let heights = bin.iter().filter_map(|k| height(&self.triangles[*k as usize], at));
        heights.filter(|z| *z <= at.z).reduce(f64::max).map(|z| at.z - z)
    }
}

/// Height of a triangle at the plan of a place.
fn height([a, b, c]: &[Vec3; 3], at: Vec3) -> Option<f64> {
    let cross = |u: Vec3, v: Vec3| u.x * v.y - u.y * v.x;
    let (u, v, p) = (*b - *a, *c - *a, at - *a);
    let twice = cross(u, v);
    if twice == 0.0 {
        return None;
    }
    let (s, t) = (cross(p, v) / twice, cross(u, p) / twice);
    // A place on an edge belongs to both sides.
    let slack = 1e-12;
    let inside = s >= -slack && t >= -slack && s + t <= 1.0 + slack;
    inside.then_some(a.z + s * u.z + t * v.z)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_highest_ground_below_counts() {
        let level = |z: f64, size: f64| {
            let p = |x: f64, y: f64| Vec3::new(x, y, z);
            [[p(0.0, 0.0), p(size, 0.0), p(size, size)], [p(0.0, 0.0), p(size, size), p(0.0, size)]]
        };
        let slope =
            [Vec3::new(10.0, 0.0, 0.0), Vec3::new(20.0, 0.0, 10.0), Vec3::new(20.0, 10.0, 10.0)];
        let mut all = level(0.0, 10.0).to_vec();
        all.extend(level(3.0, 4.0));
        all.push(slope);
        let ground = Ground::new(all);
        let above = |x: f64, y: f64, z: f64| ground.below(Vec3::new(x, y, z));
        assert_eq!(above(1.0, 1.0, 5.0), Some(2.0));
        assert_eq!(above(1.0, 1.0, 2.0), Some(2.0));
        assert_eq!(above(5.0, 5.0, 5.0), Some(5.0));
        assert!((above(15.0, 1.0, 8.0).unwrap() - 3.0).abs() < 1e-12);
        assert_eq!(above(15.0, 8.0, 8.0), None);
        assert_eq!((above(-1.0, 1.0, 8.0), above(1.0, 1.0, -1.0)), (None, None));
        assert_eq!(Ground::new(Vec::new()).below(Vec3::ZERO), None);
    }
}
