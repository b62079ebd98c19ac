//! How bonds of a cut block go on: with the stretch they had.

use riprap_geom::Vec3;

use crate::state::deform::{Deform, Facet, Memory, Point};
use crate::state::world::World;

/// Stretch of the points of an old facet, `jump + start / k` (n, b, c), m.
///
/// A linear field over the facet with the same mean and first moments where all points are whole, so that forces stay to
/// round-off; that of the nearest point where some have a history.
pub(super) struct Stretch {
    points: Vec<(Vec3, Memory, [f64; 3])>,
    /// Place, value there, slopes along b and c.
    fit: Option<(Vec3, [[f64; 3]; 3])>,
}

impl Stretch {
    /// Of a facet whose points were at `place` at the start.
    pub(super) fn new(
        world: &World,
        deform: &Deform,
        facet: &Facet,
        place: impl Fn(&Point) -> Vec3,
    ) -> Self {
        let freedoms = world.freedoms_with(deform);
        let [kn, ks] = facet.stiffness;
        let mut points = Vec::new();
        let mut areas = Vec::new();
        for p in facet.points() {
            let (point, memory) = (&deform.points[p], deform.memory[p]);
            let jump = freedoms.jump(&point.anchors);
            let at = facet.now.map(|e| e.dot(jump));
            let s = memory.start;
            let stretch = [at[0] + s[0] / kn, at[1] + s[1] / ks, at[2] + s[2] / ks];
            points.push((place(point), memory, stretch));
            areas.push(point.area);
        }
        let whole = points.iter().all(|p| p.1.law.damage == 0.0);
        Self { fit: whole.then(|| linear(facet, &points, &areas)), points }
    }

    /// Memory of a new point whose jump is `at` (m).
    pub(super) fn memory(&self, facet: &Facet, place: Vec3, at: &[f64; 3]) -> Memory {
        let distance = |k: &usize| self.points[*k].0.distance_squared(place);
        let nearest = (0..self.points.len()).min_by(|a, b| distance(a).total_cmp(&distance(b)));
        let Some((_, old, own)) = nearest.map(|k| &self.points[k]) else {
            return Memory::default();
        };
        let wanted = match &self.fit {
            None => *own,
            Some((centre, [mean, b, c])) => {
                let r = place - *centre;
                let (x, y) = (r.dot(facet.frame[1]), r.dot(facet.frame[2]));
                std::array::from_fn(|k| mean[k] + x * b[k] + y * c[k])
            }
        };
        let [kn, ks] = facet.stiffness;
        let start = [kn * (wanted[0] - at[0]), ks * (wanted[1] - at[1]), ks * (wanted[2] - at[2])];
        Memory { start, ..*old }
    }
}

/// Least squares with areas as weights.
fn linear(
    facet: &Facet,
    points: &[(Vec3, Memory, [f64; 3])],
    areas: &[f64],
) -> (Vec3, [[f64; 3]; 3]) {
    let whole: f64 = areas.iter().sum();
    let pairs = || points.iter().zip(areas);
    let centre = pairs().map(|(p, a)| *a * p.0).sum::<Vec3>() / whole;
    let mut mean = [0.0; 3];
    let (mut xx, mut xy, mut yy) = (0.0, 0.0, 0.0);
    let (mut x_of, mut y_of) = ([0.0; 3], [0.0; 3]);
    for ((at, _, e), a) in pairs() {
        let r = *at - centre;
        let (x, y) = (r.dot(facet.frame[1]), r.dot(facet.frame[2]));
        xx += a * x * x;
        xy += a * x * y;
        yy += a * y * y;
        for k in 0..3 {
            mean[k] += a * e[k] / whole;
            x_of[k] += a * x * e[k];
            y_of[k] += a * y * e[k];
        }
    }
    let det = xx * yy - xy * xy;
    let sound = det > 1e-9 * xx * yy;
    let slope = |u: [f64; 3], v: [f64; 3], p: f64, q: f64| {
        std::array::from_fn(|k| if sound { (p * u[k] - q * v[k]) / det } else { 0.0 })
    };
    let (b, c) = (slope(x_of, y_of, yy, xy), slope(y_of, x_of, xx, xy));
    (centre, [mean, b, c])
}
