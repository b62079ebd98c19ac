//! Where a line passes through blocks.

use riprap_geom::Vec3;

use crate::setup::Shape;

/// From where to where a line is inside a shape at its start: distances (m) from `from` along the unit direction `along`, within
/// `range`; `None` where it does not meet the shape, and for terrain.
#[must_use]
pub fn span(shape: &Shape, from: Vec3, along: Vec3, range: [f64; 2]) -> Option<[f64; 2]> {
    let [mut low, mut high] = range;
    let mut clip = |normal: Vec3, through: Vec3| {
        let (height, rate) = (normal.dot(from - through), normal.dot(along));
        if rate > 0.0 {
            high = high.min(-height / rate);
        } else if rate < 0.0 {
            low = low.max(-height / rate);
        } else if height > 0.0 {
            high = f64::NEG_INFINITY;
        }
    };
    match shape {
        Shape::Brick { centre, half } => {
            for axis in Vec3::AXES {
                clip(axis, *centre + half.dot(axis) * axis);
                clip(-axis, *centre - half.dot(axis) * axis);
            }
        }
        Shape::Polyhedron(solid) => {
            for face in &solid.faces {
                let corner = |k: usize| solid.vertices[face[k % face.len()] as usize];
                let normal: Vec3 = (0..face.len())
                    .map(|k| (corner(k) - corner(0)).cross(corner(k + 1) - corner(0)))
                    .sum();
                clip(normal, corner(0));
            }
        }
        // Bolts beside glued parts are refused.
        Shape::Terrain(_) | Shape::Glued(_) => return None,
    }
    (high > low).then_some([low, high])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::setup::Solid;
    use riprap_geom::polyhedron::Polyhedron;

    #[test]
    fn a_line_is_clipped_by_bricks_and_polyhedra_alike() {
        let (centre, half) = (Vec3::new(1.0, 2.0, 3.0), Vec3::new(0.5, 1.0, 1.5));
        let brick = Shape::Brick { centre, half };
        let same = Polyhedron::brick(centre, half);
        let solid =
            Shape::Polyhedron(Box::new(Solid { vertices: same.vertices, faces: same.faces }));
        let from = Vec3::new(0.2, 1.5, 2.0);
        let along = Vec3::new(1.0, 0.3, 0.5).normalize();
        let [a, b] = [&brick, &solid].map(|s| span(s, from, along, [-10.0, 10.0]).unwrap());
        assert!((a[0] - b[0]).abs() < 1e-12 && (a[1] - b[1]).abs() < 1e-12);
        assert!((from + a[0] * along).x - 0.5 < 1e-12);
        assert_eq!(span(&brick, from + 9.0 * Vec3::Y, Vec3::X, [-10.0, 10.0]), None);
    }
}
