//! Closed places in space and the blocks that touch them; bins that find boxes near a box.

use riprap_geom::Vec3;
use riprap_geom::polyhedron::Polyhedron;

use crate::setup::{Region, Shape, Solid};

/// Two boxes nearer than this share of the smaller one's half edge touch: coordinates that are meant to be equal
/// differ by round-off.
pub const TOUCH: f64 = 1e-6;

/// Whether a shape at its start holds a point, its surface included.
#[must_use]
pub fn holds(shape: &Shape, point: Vec3) -> bool {
    match shape {
        Shape::Brick { centre, half } => {
            ((point - *centre).abs() - *half).max_element() <= 1e-9 * half.max_element()
        }
        Shape::Polyhedron(solid) => in_convex(solid, point),
        Shape::Glued(parts) => parts.iter().any(|part| in_convex(part, point)),
        // Points of terrain do not move, and nothing holds in it.
        Shape::Terrain(_) => false,
    }
}

fn in_convex(solid: &Solid, point: Vec3) -> bool {
    solid.faces.iter().all(|face| {
        let corner = |k: usize| solid.vertices[face[k] as usize];
        let normal = (corner(1) - corner(0)).cross(corner(2) - corner(0));
        // The normal is an area, and its root the length of which the slack is a share.
        normal.dot(point - corner(0)) <= 1e-9 * normal.length() * normal.length().sqrt()
    })
}

/// What a block fills at its start.
#[derive(Clone, Debug)]
pub enum Extent {
    /// A brick; terrain and glued parts are their box.
    Box(Bounds),
    /// A convex solid and the box around it.
    Solid(Polyhedron, Bounds),
}

impl Extent {
    /// That of a shape.
    #[must_use]
    pub fn of(shape: &Shape) -> Self {
        match shape {
            Shape::Brick { .. } | Shape::Terrain(_) | Shape::Glued(_) => {
                Self::Box(Bounds::of(shape))
            }
            Shape::Polyhedron(solid) => {
                let (vertices, faces) = (solid.vertices.clone(), solid.faces.clone());
                Self::Solid(Polyhedron { vertices, faces }, Bounds::of(shape))
            }
        }
    }

    /// The box around it.
    #[must_use]
    pub fn bounds(&self) -> &Bounds {
        match self {
            Self::Box(bounds) | Self::Solid(_, bounds) => bounds,
        }
    }

    /// Volume, m³.
    #[must_use]
    pub fn volume(&self) -> f64 {
        match self {
            Self::Box(bounds) => 8.0 * bounds.half.element_product(),
            Self::Solid(solid, _) => solid.moments().volume,
        }
    }

    /// Whether two extents overlap as seen along the first of three axes at right angles.
    #[must_use]
    pub fn overlaps_along(&self, other: &Self, [up, b, c]: [Vec3; 3]) -> bool {
        if let (Self::Box(own), Self::Box(other)) = (self, other) {
            let apart = own.centre - other.centre;
            let overlaps =
                // A little less than the whole: boxes side by side do not overlap.
                |t: Vec3| t.dot(apart).abs() < (1.0 - TOUCH) * t.abs().dot(own.half + other.half);
            return overlaps(b) && overlaps(c);
        }
        let (own, other) = (self.clone().solid(Vec3::ZERO), other.clone().solid(Vec3::ZERO));
        // Their shadows are convex: some edge of one of them parts them if anything does.
        own.directions()
            .into_iter()
            .chain(other.directions())
            .map(|edge| up.cross(edge))
            .filter(|across| across.length() > TOUCH)
            .all(|across| {
                let ([a, b], [c, d]) = (own.reach(across), other.reach(across));
                let depth = b.min(d) - a.max(c);
                depth > 0.5 * TOUCH * (b - a + d - c)
            })
    }

    /// As a solid, moved by `shift` (m).
    #[must_use]
    pub fn solid(self, shift: Vec3) -> Polyhedron {
        let mut solid = match self {
            Self::Box(Bounds { centre, half }) => Polyhedron::brick(centre, half),
            Self::Solid(solid, _) => solid,
        };
        if shift != Vec3::ZERO {
            solid.vertices.iter_mut().for_each(|v| *v += shift);
        }
        solid
    }

    /// Whether it, with its surface, and the region have a point in common.
    #[must_use]
    pub fn touches(&self, region: &Region) -> bool {
        let (solid, bounds) = match self {
            Self::Box(bounds) => return bounds.touches(region),
            Self::Solid(solid, bounds) => (solid, bounds),
        };
        let slack = TOUCH * bounds.half.min_element();
        bounds.touches(region)
            && match region {
                Region::Point(p) => solid.distance(*p) <= slack,
                Region::Line(from, to) => solid.meets_segment(*from, *to, slack),
                Region::Plane(through, normal) => solid.meets_plane(*through, *normal, slack),
                Region::Ball(centre, radius) => solid.distance(*centre) <= radius + slack,
                Region::Box(min, max) => {
                    let other = Polyhedron::brick(0.5 * (*min + *max), 0.5 * (*max - *min));
                    solid.meets(&other, slack)
                }
                Region::All => true,
            }
    }
}

/// A box with faces normal to the axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// Centre, m.
    pub centre: Vec3,
    /// Half the edge lengths, m.
    pub half: Vec3,
}

impl Bounds {
    /// The smallest box around a shape at its start.
    #[must_use]
    pub fn of(shape: &Shape) -> Self {
        match shape {
            Shape::Brick { centre, half } => Self { centre: *centre, half: *half },
            Shape::Polyhedron(solid) => Self::around(&solid.vertices),
            Shape::Terrain(surface) => Self::around(&surface.points),
            Shape::Glued(parts) => Self::around(&Solid::all(parts).vertices),
        }
    }

    /// The smallest box around points.
    #[must_use]
    pub fn around(points: &[Vec3]) -> Self {
        let (mut min, mut max) = (Vec3::INFINITY, Vec3::NEG_INFINITY);
        for &p in points {
            min = min.min(p);
            max = max.max(p);
        }
        Self { centre: 0.5 * (min + max), half: 0.5 * (max - min) }
    }

    /// Distances between the two boxes along the axes; negative where they overlap, m.
    #[must_use]
    pub fn gaps(&self, other: &Self) -> Vec3 {
        (self.centre - other.centre).abs() - self.half - other.half
    }

    /// Whether the boxes share part of a face: they touch along one axis and overlap along the others.
    #[must_use]
    pub fn share_face(&self, other: &Self) -> bool {
        let slack = TOUCH * self.half.min(other.half);
        let gaps = self.gaps(other);
        let touching = (0..3).filter(|&a| gaps[a].abs() <= slack[a]).count();
        // Along two axes they share an edge, along three a corner.
        touching == 1 && (0..3).all(|a| gaps[a] <= slack[a])
    }

    /// Whether the box, with its surface, and the region have a point in common.
    #[must_use]
    pub fn touches(&self, region: &Region) -> bool {
        let slack = TOUCH * self.half.min_element();
        match region {
            Region::Point(p) => self.distance(*p) <= slack,
            Region::Line(from, to) => self.meets_segment(*from, *to, slack),
            Region::Plane(through, normal) => {
                let reach = self.half.dot(normal.abs());
                normal.dot(self.centre - *through).abs() <= reach + slack
            }
            Region::Ball(centre, radius) => self.distance(*centre) <= radius + slack,
            Region::Box(min, max) => {
                let other = Self { centre: 0.5 * (*min + *max), half: 0.5 * (*max - *min) };
                self.gaps(&other).max_element() <= slack
            }
            Region::All => true,
        }
    }

    /// Distance of a point from the box, 0 inside, m.
    #[must_use]
    pub fn distance(&self, p: Vec3) -> f64 {
        ((p - self.centre).abs() - self.half).max(Vec3::ZERO).length()
    }

    /// Whether a segment comes within `slack` of the box: the parts of the segment between the three pairs of
    /// planes have a common point.
    fn meets_segment(&self, from: Vec3, to: Vec3, slack: f64) -> bool {
        let along = to - from;
        let (mut enter, mut leave) = (0.0_f64, 1.0_f64);
        for a in 0..3 {
            let (low, high) = (
                self.centre[a] - self.half[a] - slack - from[a],
                self.centre[a] + self.half[a] + slack - from[a],
            );
            if along[a] == 0.0 {
                if low > 0.0 || high < 0.0 {
                    return false;
                }
            } else {
                let (s, t) = (low / along[a], high / along[a]);
                enter = enter.max(s.min(t));
                leave = leave.min(s.max(t));
            }
        }
        enter <= leave
    }
}

/// Boxes sorted into a grid of bins.
#[derive(Clone, Debug, Default)]
pub struct Bins {
    min: Vec3,
    size: Vec3,
    count: [usize; 3],
    first: Vec<u32>,
    items: Vec<u32>,
}

impl Bins {
    /// Bins for boxes, about as many as boxes; box `k` keeps the number `numbers[k]`.
    #[must_use]
    pub fn new(boxes: &[Bounds], numbers: &[u32]) -> Self {
        let (mut min, mut max) = (Vec3::INFINITY, Vec3::NEG_INFINITY);
        let mut mean = Vec3::ZERO;
        for b in boxes {
            min = min.min(b.centre - b.half);
            max = max.max(b.centre + b.half);
            mean += 2.0 * b.half / boxes.len() as f64;
        }
        if boxes.is_empty() {
            return Self::default();
        }
        let extent = max - min;
        // Never more bins along an axis than boxes, so that one far block costs no memory.
        let count = [0, 1, 2].map(|a| {
            let wanted = (extent[a] / mean[a]).ceil();
            (wanted as usize).clamp(1, boxes.len().min(1024))
        });
        let mut bins = Self {
            min,
            size: Vec3::from_array([0, 1, 2].map(|a| extent[a] / count[a] as f64)),
            count,
            first: Vec::new(),
            items: Vec::new(),
        };
        let total = count[0] * count[1] * count[2];
        let mut first = vec![0u32; total + 1];
        for b in boxes {
            bins.each_bin(b, |bin| first[bin + 1] += 1);
        }
        for k in 0..total {
            first[k + 1] += first[k];
        }
        let mut next = first.clone();
        let mut items = vec![0; first[total] as usize];
        for (b, &number) in boxes.iter().zip(numbers) {
            bins.each_bin(b, |bin| {
                items[next[bin] as usize] = number;
                next[bin] += 1;
            });
        }
        bins.first = first;
        bins.items = items;
        bins
    }

    /// Numbers of the boxes that may touch `around`, ascending, each once.
    pub fn near(&self, around: &Bounds, found: &mut Vec<u32>) {
        found.clear();
        if self.items.is_empty() {
            return;
        }
        self.each_bin(around, |bin| {
            let range = self.first[bin] as usize..self.first[bin + 1] as usize;
            found.extend_from_slice(&self.items[range]);
        });
        found.sort_unstable();
        found.dedup();
    }

    fn each_bin(&self, b: &Bounds, mut visit: impl FnMut(usize)) {
        // A little wider, so that boxes that only touch have a bin in common.
        let slack = TOUCH * b.half.min_element();
        let index = |x: f64, a: usize| {
            let k = ((x - self.min[a]) / self.size[a]).floor();
            (k.max(0.0) as usize).min(self.count[a] - 1)
        };
        let low = [0, 1, 2].map(|a| index(b.centre[a] - b.half[a] - slack, a));
        let high = [0, 1, 2].map(|a| index(b.centre[a] + b.half[a] + slack, a));
        for z in low[2]..=high[2] {
            for y in low[1]..=high[1] {
                for x in low[0]..=high[0] {
                    visit((z * self.count[1] + y) * self.count[0] + x);
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const CUBE: Bounds =
        Bounds { centre: Vec3::new(0.5, 0.5, 0.5), half: Vec3::new(0.5, 0.5, 0.5) };

    fn v(x: f64, y: f64, z: f64) -> Vec3 {
        Vec3::new(x, y, z)
    }

    #[test]
    fn regions_are_closed() {
        let yes = [
            Region::Point(v(1.0, 1.0, 1.0)),
            Region::Line(v(1.0, -3.0, 1.0), v(1.0, 3.0, 1.0)),
            Region::Line(v(-1.0, 0.5, 0.5), v(2.0, 0.6, 0.5)),
            Region::Plane(v(7.0, 3.0, 1.0), Vec3::Z),
            Region::Ball(v(2.0, 0.5, 0.5), 1.0),
            Region::Box(v(1.0, 0.2, 0.2), v(2.0, 0.3, 0.3)),
            Region::All,
        ];
        for region in yes {
            assert!(CUBE.touches(&region), "{region:?}");
        }
        let no = [
            Region::Point(v(1.0001, 1.0, 1.0)),
            Region::Line(v(1.2, -3.0, 0.5), v(0.5, 3.0, 2.2)),
            Region::Line(v(2.0, 0.5, 0.5), v(3.0, 0.5, 0.5)),
            Region::Plane(v(7.0, 3.0, 1.1), Vec3::Z),
            Region::Ball(v(2.0, 2.0, 0.5), 1.4),
            Region::Box(v(1.1, 0.2, 0.2), v(2.0, 0.3, 0.3)),
        ];
        for region in no {
            assert!(!CUBE.touches(&region), "{region:?}");
        }
    }

    #[test]
    fn faces_edges_and_corners_differ() {
        let at = |x, y, z| Bounds { centre: v(x, y, z), half: Vec3::splat(0.25) };
        assert!(CUBE.share_face(&at(1.25, 0.5, 0.75)));
        assert!(!CUBE.share_face(&at(1.25, 1.25, 0.75)));
        assert!(!CUBE.share_face(&at(1.25, 1.25, 1.25)));
        assert!(!CUBE.share_face(&at(1.5, 0.5, 0.5)));
        assert!(!CUBE.share_face(&at(0.5, 0.5, 0.5)));
    }
}
