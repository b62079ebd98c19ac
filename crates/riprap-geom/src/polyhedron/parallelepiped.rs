//! Solids with six faces in three parallel pairs: the convex solids that eight halves of themselves fill.

use super::{BRICK_FACES, Polyhedron};
use crate::Vec3;

/// A corner farther than this, times the size, from where three pairs of parallel faces would have it makes a solid no
/// parallelepiped.
pub(super) const SKEW: f64 = 1e-10;

/// A parallelepiped: all points `centre + x half[0] + y half[1] + z half[2]` with x, y and z from -1 to 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parallelepiped {
    /// Centre, m.
    pub centre: Vec3,
    /// Half the edges, right-handed, m.
    pub half: [Vec3; 3],
}

impl Parallelepiped {
    /// The parallelepiped that a solid is; `None` for any other.
    ///
    /// Its axes are the edges in the order of the faces, from the first face of each pair to the second; a brick that was
    /// turned has the axes of the brick. Where that is left-handed the last two axes change places.
    #[must_use]
    pub fn of(vertices: &[Vec3], faces: &[Vec<u32>]) -> Option<Self> {
        if vertices.len() != 8 || faces.len() != 6 || faces.iter().any(|face| face.len() != 4) {
            return None;
        }
        let centre = vertices.iter().sum::<Vec3>() / 8.0;
        let most = |length: fn(Vec3, Vec3) -> f64| {
            let lengths = vertices.iter().map(|v| length(*v, centre));
            lengths.fold(0.0, f64::max)
        };
        // Far from the origin, corners are rounded by more than that share of a small block.
        let rounded = 16.0 * f64::EPSILON * most(|v, _| v.abs().max_element());
        let near = 2.0 * SKEW * most(Vec3::distance) + rounded;
        let middle = |face: &Vec<u32>| -> Vec3 {
            let corners = face.iter().map(|&v| vertices[v as usize] - centre);
            corners.sum::<Vec3>() / 4.0
        };
        let middles: Vec<Vec3> = faces.iter().map(middle).collect();
        let mut half = Vec::with_capacity(3);
        for (k, first) in middles.iter().enumerate() {
            let opposite = |other: &Vec3| (*first + *other).length() <= near;
            if let Some(second) = middles[k + 1..].iter().find(|other| opposite(other)) {
                half.push(0.5 * (*second - *first));
            }
        }
        let &[a, b, c] = half.as_slice() else {
            return None;
        };
        let half = if a.dot(b.cross(c)) < 0.0 { [a, c, b] } else { [a, b, c] };
        let made = Self { centre, half };
        let is_corner = |k: u8| {
            let corner = made.corner(k);
            vertices.iter().any(|v| v.distance(corner) <= near)
        };
        (0..8).all(is_corner).then_some(made)
    }

    /// Corner `k`: at the upper end along axis a where bit a is set, m.
    #[must_use]
    pub fn corner(&self, k: u8) -> Vec3 {
        self.at(signs(k))
    }

    /// The eighth that holds corner `k`.
    #[must_use]
    pub fn octant(&self, k: u8) -> Self {
        Self { centre: self.at(0.5 * signs(k)), half: self.half.map(|h| 0.5 * h) }
    }

    /// The eighth that holds a point; of several the one farther along each axis.
    #[must_use]
    pub fn octant_of(&self, point: Vec3) -> u8 {
        let arm = point - self.centre;
        (0..3).filter(|&a| self.normal(a).dot(arm) >= 0.0).map(|a| 1 << a).sum()
    }

    /// Volume, m³.
    #[must_use]
    pub fn volume(&self) -> f64 {
        8.0 * self.half[0].dot(self.half[1].cross(self.half[2]))
    }

    /// Area of its surface, m².
    #[must_use]
    pub fn surface(&self) -> f64 {
        8.0 * (0..3).map(|a| self.normal(a).length()).sum::<f64>()
    }

    /// As a solid, with faces and corners in the order of those of a brick.
    #[must_use]
    pub fn solid(&self) -> Polyhedron {
        Polyhedron {
            vertices: (0..8).map(|k| self.corner(k)).collect(),
            faces: BRICK_FACES.map(|f| f.map(u32::from).to_vec()).to_vec(),
        }
    }

    fn at(&self, along: Vec3) -> Vec3 {
        let [a, b, c] = self.half;
        self.centre + (along.x * a + along.y * b + along.z * c)
    }

    /// Outward normal of the upper face of an axis, as long as a quarter of its area (m²).
    fn normal(&self, axis: usize) -> Vec3 {
        self.half[(axis + 1) % 3].cross(self.half[(axis + 2) % 3])
    }
}

/// 1 where the bit of an axis is set, -1 elsewhere.
fn signs(k: u8) -> Vec3 {
    let sign = |bit: u8| if k & bit == 0 { -1.0 } else { 1.0 };
    Vec3::new(sign(1), sign(2), sign(4))
}

#[cfg(test)]
mod tests {
    use super::*;

    const LEANING: Parallelepiped = Parallelepiped {
        centre: Vec3::new(1.0, -2.0, 0.5),
        half: [Vec3::new(1.0, 0.2, -0.1), Vec3::new(-0.3, 0.8, 0.1), Vec3::new(0.4, 0.3, 0.6)],
    };

    #[test]
    fn a_solid_gives_back_its_axes() {
        let solid = LEANING.solid();
        assert_eq!(solid.validate(), Ok(()));
        let found = Parallelepiped::of(&solid.vertices, &solid.faces).unwrap();
        assert!((found.centre - LEANING.centre).length() < 1e-15);
        for (a, b) in found.half.iter().zip(LEANING.half) {
            assert!((*a - b).length() < 1e-15);
        }
        assert!((solid.moments().volume - LEANING.volume()).abs() < 1e-14);
        let area: f64 = (0..6).map(|f| solid.area_vector(f).length()).sum();
        assert!((area - LEANING.surface()).abs() < 1e-14);
    }

    #[test]
    fn faces_in_any_order_make_right_handed_axes() {
        let mut solid = LEANING.solid();
        solid.faces.swap(0, 3);
        solid.faces.swap(1, 4);
        solid.faces.rotate_left(1);
        let found = Parallelepiped::of(&solid.vertices, &solid.faces).unwrap();
        assert!((found.volume() - LEANING.volume()).abs() < 1e-14);
        assert_eq!(found.solid().validate(), Ok(()));
    }

    /// Parts of parts are known again, however small they are and far away.
    #[test]
    fn small_parts_far_away_are_known_again() {
        let mut part = Parallelepiped { centre: Vec3::new(1e4, -2e4, 7e3), ..LEANING };
        for level in 0..20 {
            part = part.octant(level % 8);
            let solid = part.solid();
            let found = Parallelepiped::of(&solid.vertices, &solid.faces);
            assert!(found.is_some(), "level {level}");
        }
    }

    #[test]
    fn others_are_none() {
        let mut solid = LEANING.solid();
        solid.vertices[3] += 1e-8 * Vec3::X;
        assert_eq!(Parallelepiped::of(&solid.vertices, &solid.faces), None);
        // A frustum: six faces with four corners each.
        let mut solid = Polyhedron::brick(Vec3::ZERO, Vec3::ONE);
        for v in &mut solid.vertices[4..] {
            *v *= Vec3::new(0.5, 0.5, 1.0);
        }
        assert_eq!(solid.validate(), Ok(()));
        assert_eq!(Parallelepiped::of(&solid.vertices, &solid.faces), None);
    }

    /// Volume, centroid and inertia of the eighths add up to those of the whole (parallel axes).
    #[test]
    fn eighths_fill_the_whole() {
        let whole = LEANING.solid().moments();
        let (mut volume, mut first) = (0.0, Vec3::ZERO);
        let mut inertia = crate::Mat3::ZERO;
        for k in 0..8 {
            let part = LEANING.octant(k);
            let moments = part.solid().moments();
            assert!((moments.volume - LEANING.volume() / 8.0).abs() < 1e-15);
            assert_eq!(LEANING.octant_of(part.centre), k);
            let arm = moments.centroid - whole.centroid;
            let outer = crate::Mat3::from_cols(arm.x * arm, arm.y * arm, arm.z * arm);
            let steiner = crate::Mat3::from_diagonal(Vec3::splat(arm.length_squared())) - outer;
            volume += moments.volume;
            first += moments.volume * moments.centroid;
            inertia += moments.inertia + moments.volume * steiner;
        }
        assert!((volume - whole.volume).abs() < 1e-14);
        assert!((first / volume - whole.centroid).length() < 1e-14);
        let off = (inertia - whole.inertia).to_cols_array();
        assert!(off.iter().all(|x| x.abs() < 1e-13), "{off:?}");
    }
}
