//! Solids: what is refused, moments against closed forms, cutting adds up.

use proptest::prelude::*;

use super::*;
use crate::random::Chance;
use crate::{Mat3, Quat};

fn unit() -> Polyhedron {
    Polyhedron::brick(Vec3::splat(0.5), Vec3::splat(0.5))
}

/// Hull of random points on a sphere.
fn stone(seed: u64, corners: usize) -> Polyhedron {
    let mut chance = Chance::new(seed);
    let points: Vec<Vec3> = (0..corners)
        .map(|_| {
            Vec3::new(chance.normal(), chance.normal(), chance.normal()).normalize()
                + Vec3::new(3.0, -2.0, 1.0)
        })
        .collect();
    hull(&points).unwrap()
}

#[test]
fn bricks_are_solids() {
    let brick = Polyhedron::brick(Vec3::new(7.0, 8.0, 9.0), Vec3::new(1.0, 2.0, 3.0));
    assert_eq!(brick.validate(), Ok(()));
    let m = brick.moments();
    assert!((m.volume - 48.0).abs() < 1e-12);
    assert!(m.centroid.distance(Vec3::new(7.0, 8.0, 9.0)) < 1e-12);
    // V/3 (half b² + half c²).
    let expected = Mat3::from_diagonal(Vec3::new(208.0, 160.0, 80.0));
    assert!(m.inertia.abs_diff_eq(expected, 1e-10), "{:?}", m.inertia);
}

#[test]
fn errors_say_what_is_wrong() {
    let cube = unit();
    let mut open = cube.clone();
    open.faces.pop();
    assert_eq!(
        open.validate().unwrap_err().to_string(),
        "the surface is open: the edge from vertex 4 to vertex 6 (face 0) has no face on its other side"
    );
    let mut turned = cube.clone();
    turned.faces[2].reverse();
    assert!(matches!(turned.validate(), Err(SolidError::WrongWay { .. })));
    let mut crooked = cube.clone();
    crooked.vertices[7] += Vec3::new(0.0, 0.0, 0.01);
    assert!(matches!(crooked.validate(), Err(SolidError::CrookedFace { .. })));
    let mut missing = cube.clone();
    missing.faces[1][2] = 8;
    assert!(missing.validate().unwrap_err().to_string().contains("face 1 names vertex 8"));
    let mut nowhere = cube.clone();
    nowhere.vertices[3].y = f64::NAN;
    assert!(matches!(nowhere.validate(), Err(SolidError::NonFinite { vertex: 3, .. })));
    let flat = Polyhedron {
        vertices: cube.vertices.iter().map(|v| *v * Vec3::new(1.0, 1.0, 1e-13)).collect(),
        faces: cube.faces.clone(),
    };
    assert!(matches!(flat.validate(), Err(SolidError::ZeroVolume { .. })));
    let mut spare = cube.clone();
    spare.vertices.push(Vec3::ZERO);
    assert_eq!(spare.validate(), Err(SolidError::Unused { vertex: 8 }));
    // A roof with a valley: closed and flat, not convex.
    let mut valley = Vec::new();
    for y in [0.0, 1.0] {
        for (x, z) in [(0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (1.0, 1.0), (0.0, 2.0)] {
            valley.push(Vec3::new(x, y, z));
        }
    }
    let mut faces = vec![vec![0, 1, 2, 3, 4], vec![9, 8, 7, 6, 5]];
    for k in 0..5u32 {
        let n = (k + 1) % 5;
        faces.push(vec![k, k + 5, n + 5, n]);
    }
    let error = Polyhedron::new(valley, faces).unwrap_err();
    assert!(matches!(error, SolidError::NotConvex { .. }), "{error}");
}

#[test]
fn faces_that_all_point_inward_are_turned() {
    let mut cube = unit();
    for face in &mut cube.faces {
        face.reverse();
    }
    assert!(cube.validate().is_err());
    let turned = Polyhedron::new(cube.vertices, cube.faces).unwrap();
    assert!((turned.moments().volume - 1.0).abs() < 1e-15);
}

#[test]
fn hull_of_a_cube_has_six_faces() {
    let mut points = unit().vertices;
    points.push(Vec3::splat(0.3));
    points.push(Vec3::new(0.5, 0.5, 1.0));
    points.push(Vec3::new(0.5, 0.0, 0.0));
    points.push(Vec3::new(1.0, 1.0, 1.0));
    let solid = hull(&points).unwrap();
    assert_eq!((solid.vertices.len(), solid.faces.len()), (8, 6));
    assert!((solid.moments().volume - 1.0).abs() < 1e-15);
    assert!(hull(&points[..3]).is_err());
    let plane: Vec<Vec3> =
        (0..9).map(|k| Vec3::new(f64::from(k % 3), f64::from(k / 3), 1.0)).collect();
    assert!(matches!(hull(&plane), Err(SolidError::ZeroVolume { .. })));
}

#[test]
fn planes_make_an_octahedron() {
    let mut planes = Vec::new();
    for k in 0..8 {
        let sign = |bit: i32| if k & bit == 0 { -1.0 } else { 1.0 };
        planes.push((Vec3::new(sign(1), sign(2), sign(4)), 1.0));
    }
    let solid = from_half_spaces(&planes, 10.0).unwrap();
    assert_eq!((solid.vertices.len(), solid.faces.len()), (6, 8));
    assert_eq!(solid.validate(), Ok(()));
    assert!((solid.moments().volume - 4.0 / 3.0).abs() < 1e-13);
    assert!(matches!(from_half_spaces(&planes[..4], 10.0), Err(SolidError::Unbounded { .. })));
    planes.push((Vec3::X, -2.0));
    assert_eq!(from_half_spaces(&planes, 10.0), Err(SolidError::Nothing { plane: 8 }));
}

#[test]
fn cuts_through_corners_edges_and_faces_leave_no_slivers() {
    let cube = unit();
    let part = |n: Vec3, d: f64| match slice(&cube, n, d) {
        Sliced::Part(part) => part,
        other => panic!("{other:?}"),
    };
    assert_eq!(slice(&cube, Vec3::X, 1.0), Sliced::Whole);
    assert_eq!(slice(&cube, Vec3::X, 1.0 - 1e-12), Sliced::Whole);
    assert_eq!(slice(&cube, Vec3::X, 0.0), Sliced::Nothing);
    assert_eq!(slice(&cube, Vec3::X, 1e-12), Sliced::Nothing);
    assert_eq!(slice(&cube, Vec3::X, -0.1), Sliced::Nothing);
    // Through two edges: a prism.
    let diagonal = Vec3::new(1.0, -1.0, 0.0).normalize();
    let prism = part(diagonal, 0.0);
    assert_eq!((prism.vertices.len(), prism.faces.len()), (6, 5));
    assert!((prism.moments().volume - 0.5).abs() < 1e-15);
    // Through three corners, and through one corner only.
    let n = Vec3::ONE.normalize();
    let corner = part(n, 1.0 / 3f64.sqrt());
    assert_eq!((corner.vertices.len(), corner.faces.len()), (4, 4));
    assert!((corner.moments().volume - 1.0 / 6.0).abs() < 1e-15);
    assert_eq!(slice(&cube, n, 0.0), Sliced::Nothing);
    for part in [&prism, &corner] {
        assert_eq!(part.validate(), Ok(()));
    }
}

#[test]
fn a_tetrahedron_has_its_textbook_inertia() {
    let solid = hull(&[Vec3::ZERO, Vec3::X, Vec3::Y, Vec3::Z]).unwrap();
    let m = solid.moments();
    assert!((m.volume - 1.0 / 6.0).abs() < 1e-16);
    assert!(m.centroid.distance(Vec3::splat(0.25)) < 1e-15);
    // About the centroid: diagonal 1/80, products 1/480.
    assert!((m.inertia.x_axis.x - 1.0 / 80.0).abs() < 1e-15);
    assert!((m.inertia.x_axis.y - 1.0 / 480.0).abs() < 1e-15);
    let (values, axes) = principal(&m.inertia);
    // Along the diagonal 1/80 + 2/480, across it 1/80 - 1/480.
    let expected = Vec3::new(5.0 / 480.0, 5.0 / 480.0, 8.0 / 480.0);
    assert!(values.distance(expected) < 1e-15, "{values}");
    assert!(axes.z_axis.cross(Vec3::ONE.normalize()).length() < 1e-12);
    assert!((axes.determinant() - 1.0).abs() < 1e-12);
}

/// A corner in the middle of an edge (the third point) is dropped by both faces, though one of them, laid flat, has
/// that edge upright, so that rounding alone says which of its three points is the first.
/// Corners as files have them: rounded to micrometres, so off their faces by as much as what counts as flat for blocks of a metre.
#[test]
fn rounded_corners_of_faces_make_a_hull() {
    let mut chance = Chance::new(5);
    let mut unit = || chance.between(-1.0, 1.0);
    for _ in 0..200 {
        let planes: Vec<(Vec3, f64)> = (0..14)
            .map(|_| (Vec3::new(unit(), unit(), unit()).normalize(), 0.5 + 0.1 * unit()))
            .collect();
        let Ok(solid) = from_half_spaces(&planes, 2.0) else {
            continue;
        };
        let round = |v: &Vec3| (*v * 1e6).round() / 1e6;
        let rounded: Vec<Vec3> = solid.vertices.iter().map(round).collect();
        let again = hull(&rounded).unwrap();
        let volumes = [&solid, &again].map(|s| s.moments().volume);
        assert!((volumes[1] / volumes[0] - 1.0).abs() < 1e-4, "{volumes:?}");
    }
}

#[test]
fn a_point_in_an_upright_edge_is_no_corner() {
    let points =
        [[1, 0, -4], [1, -3, 1], [0, -1, 4], [-4, 0, 0], [-4, -2, 4], [0, 0, 0], [4, 0, 4]];
    let points = points.map(|p| Vec3::from_array(p.map(f64::from)));
    let solid = hull(&points).unwrap();
    assert_eq!((solid.vertices.len(), solid.faces.len()), (5, 6));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    /// Two halves have the moments of the whole, and share the cut face bit for bit.
    #[test]
    fn parts_add_up(
        seed in any::<u64>(),
        corners in 4usize..40,
        normal in prop::array::uniform3(-1.0..1.0f64),
        through in prop::sample::select(vec![0, 1, 2, 3]),
        shift in -0.6..0.6f64,
    ) {
        let solid = stone(seed, corners);
        let n = Vec3::from_array(normal);
        prop_assume!(n.length() > 0.1);
        let mut n = n.normalize();
        let m = solid.moments();
        // Through the middle, a vertex, an edge, or along a face.
        let v = |k: usize| solid.vertices[k % solid.vertices.len()];
        let d = match through {
            0 => n.dot(m.centroid) + shift,
            1 => n.dot(v(3)),
            2 => {
                let face = &solid.faces[0];
                let (a, b) = (v(face[0] as usize), v(face[1] as usize));
                n = (b - a).cross(n).normalize();
                n.dot(a)
            }
            _ => { n = solid.plane(0).0; solid.plane(0).1 }
        };
        match (slice(&solid, n, d), slice(&solid, -n, -d)) {
            (Sliced::Part(below), Sliced::Part(above)) => {
                prop_assert_eq!(below.validate(), Ok(()));
                prop_assert_eq!(above.validate(), Ok(()));
                let (p, q) = (below.moments(), above.moments());
                prop_assert!((p.volume + q.volume - m.volume).abs() < 1e-12);
                let middle = (p.volume * p.centroid + q.volume * q.centroid) / m.volume;
                prop_assert!(middle.distance(m.centroid) < 1e-11);
                let sorted = |s: &Polyhedron| {
                    let mut c = s.outline(s.faces.len() - 1);
                    c.sort_by(|a, b| a.to_array().map(f64::to_bits).cmp(&b.to_array().map(f64::to_bits)));
                    c
                };
                prop_assert_eq!(sorted(&below), sorted(&above));
            }
            (Sliced::Whole, Sliced::Nothing) | (Sliced::Nothing, Sliced::Whole) => {}
            other => prop_assert!(false, "{:?}", other),
        }
    }

    /// Moments follow a rigid motion.
    #[test]
    fn moments_move_with_the_solid(
        seed in any::<u64>(),
        turn in prop::array::uniform4(-1.0..1.0f64),
        place in prop::array::uniform3(-1e4..1e4f64),
    ) {
        let q = Quat::from_array(turn);
        prop_assume!(q.length() > 0.1);
        let (q, t) = (q.normalize(), Vec3::from_array(place));
        let solid = stone(seed, 12);
        let moved = Polyhedron {
            vertices: solid.vertices.iter().map(|&v| t + q * v).collect(),
            faces: solid.faces.clone(),
        };
        let (a, b) = (solid.moments(), moved.moments());
        prop_assert!((a.volume - b.volume).abs() < 1e-10);
        prop_assert!(b.centroid.distance(t + q * a.centroid) < 1e-9);
        let r = Mat3::from_quat(q);
        prop_assert!((r * a.inertia * r.transpose()).abs_diff_eq(b.inertia, 1e-9));
        let (values, axes) = principal(&b.inertia);
        let back = axes * Mat3::from_diagonal(values) * axes.transpose();
        prop_assert!(back.abs_diff_eq(b.inertia, 1e-12));
        prop_assert!(values.x <= values.y && values.y <= values.z);
    }

    /// The hull holds all points, and its vertices are among them.
    #[test]
    fn hulls_hold_their_points(
        points in prop::collection::vec(prop::array::uniform3(-4i32..5), 5..60),
        far in prop::sample::select(vec![0.0, 1e5]),
    ) {
        // Whole numbers: many points in one plane and on one line.
        let points: Vec<Vec3> = points.iter().map(|p| Vec3::from_array(p.map(f64::from)) + Vec3::splat(far)).collect();
        match hull(&points) {
            Ok(solid) => {
                for face in 0..solid.faces.len() {
                    let (n, d) = solid.plane(face);
                    prop_assert!(points.iter().all(|p| n.dot(*p) - d < 1e-9 * (1.0 + far)));
                }
                prop_assert!(solid.vertices.iter().all(|v| points.contains(v)));
            }
            Err(SolidError::ZeroVolume { .. }) => {
                let p = points[0];
                let spread: Vec<Vec3> = points.iter().map(|q| *q - p).collect();
                let n = spread.iter().flat_map(|a| spread.iter().map(|b| a.cross(*b)))
                    .fold(Vec3::ZERO, |m, c| if c.length() > m.length() { c } else { m });
                prop_assert!(spread.iter().all(|q| n.dot(*q).abs() < 1e-9));
            }
            Err(other) => prop_assert!(false, "{}", other),
        }
    }
}
