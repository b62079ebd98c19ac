use super::*;

fn line(count: usize, step: f64) -> Vec<f64> {
    (0..count).map(|k| step * k as f64).collect()
}

fn hill(x: f64, y: f64) -> f64 {
    0.1 * x * y - 0.2 * y
}

#[test]
fn a_grid_becomes_triangles_that_look_up() {
    let (x, y) = (line(4, 1.0), line(3, 2.0));
    let field = HeightField::grid(&x, &y, |i, j| Some(hill(x[i], y[j]))).unwrap();
    assert_eq!(field.points.len(), 12);
    assert_eq!(field.triangles.len(), 12);
    for t in 0..12 {
        let [a, b, c] = field.corners(t);
        assert!((cross(a, b, c) - 2.0).abs() < 1e-12);
    }
    let bins = Bins::new(&field);
    for (i, &x) in x.iter().enumerate() {
        for (j, &y) in y.iter().enumerate() {
            let z = field.height(&bins, x, y).unwrap();
            assert!((z - hill(x, y)).abs() < 1e-12, "{i} {j}");
        }
    }
    assert_eq!(field.height(&bins, -0.1, 1.0), None);
    assert_eq!(field.height(&bins, 1.0, 4.1), None);
}

#[test]
fn the_body_is_closed_and_has_the_volume_under_the_surface() {
    let (x, y) = (line(5, 1.0), line(4, 1.0));
    let field = HeightField::grid(&x, &y, |_, _| Some(3.0)).unwrap();
    let (points, faces) = field.body();
    let solid = crate::polyhedron::Polyhedron { vertices: points, faces };
    // 4 m by 3 m, and a foot of 0.02 of the longer side.
    assert!((solid.moments().volume - 12.0 * 0.08).abs() < 1e-12);
}

#[test]
fn a_wall_goes_round_and_down() {
    let (x, y) = (line(5, 1.0), line(4, 1.0));
    // One corner is missing: the rim has a notch.
    let field = HeightField::grid(&x, &y, |i, j| (i + j > 1).then_some(0.5 * x[i])).unwrap();
    let walled = field.walled();
    let count = field.triangles.len();
    assert_eq!(walled.triangles[..count], field.triangles);
    assert_eq!(walled.triangles.len(), count + 2 * field.rim().len());
    // Still one height per place, without a hole; continuous with the surface, and low outside.
    let checked = HeightField::new(walled.points.clone(), walled.triangles.clone()).unwrap();
    assert_eq!(checked, walled);
    let bins = Bins::new(&walled);
    let edge = walled.height(&bins, 4.0 + 1e-9, 1.3).unwrap();
    assert!((edge - 2.0).abs() < 1e-4, "{edge}");
    assert!(walled.bounds().0.z < -4.0);
    assert_eq!(walled.height(&bins, 4.01, 1.3), None);
}

#[test]
fn the_steepest_place_is_found() {
    let (x, y) = (line(3, 1.0), line(2, 1.0));
    let field = HeightField::grid(&x, &y, |i, _| Some([0.0, 0.5, 2.0][i])).unwrap();
    let (angle, at) = field.steepest();
    assert!((angle - libm::atan(1.5)).abs() < 1e-12);
    assert!(at.x > 1.0);
}

#[test]
fn missing_heights_at_the_rim_are_left_out_and_inside_refused() {
    let (x, y) = (line(5, 1.0), line(5, 1.0));
    let corner = HeightField::grid(&x, &y, |i, j| (i + j > 1).then_some(0.0)).unwrap();
    assert_eq!(corner.triangles.len(), 32 - 4);
    let hole = HeightField::grid(&x, &y, |i, j| ((i, j) != (2, 2)).then_some(0.0));
    let Err(HeightFieldError::Hole { at, width }) = hole else {
        panic!("{hole:?}");
    };
    assert!((at[0] - 2.0).abs() < 0.5 && (at[1] - 2.0).abs() < 0.5 && width == 2.0);
    // A hole that meets the rim in one point.
    let touching =
        HeightField::grid(&x, &y, |i, j| (![(1, 1), (2, 2)].contains(&(i, j))).then_some(0.0));
    assert!(matches!(touching, Err(HeightFieldError::Hole { .. })), "{touching:?}");
    let parts = HeightField::grid(&x, &y, |i, _| (i != 2).then_some(0.0));
    assert!(matches!(parts, Err(HeightFieldError::Parts { parts: 2, .. })));
}

#[test]
fn folds_walls_and_shared_edges_are_refused() {
    let p = |x: f64, y: f64, z: f64| Vec3::new(x, y, z);
    let points = vec![
        p(0.0, 0.0, 0.0),
        p(2.0, 0.0, 0.0),
        p(0.0, 2.0, 0.0),
        p(2.0, 2.0, 0.0),
        p(0.5, 0.5, 1.0),
    ];
    let error = |triangles: Vec<[u32; 3]>| HeightField::new(points.clone(), triangles).unwrap_err();
    // The last corner lies above the first triangle.
    assert!(matches!(error(vec![[0, 1, 2], [2, 1, 4]]), HeightFieldError::SharedEdge { .. }));
    assert!(matches!(error(vec![[0, 1, 2], [0, 3, 4]]), HeightFieldError::Upright { .. }));
    assert!(matches!(error(vec![[0, 1, 2], [3, 2, 4]]), HeightFieldError::Folded { .. }));
    assert!(matches!(error(vec![[0, 1, 9]]), HeightFieldError::NoSuchCorner { .. }));
    assert!(matches!(error(Vec::new()), HeightFieldError::Empty));
    let mut bad = points.clone();
    bad[1].z = f64::NAN;
    let bad = HeightField::new(bad, vec![[0, 1, 2]]);
    assert_eq!(bad, Err(HeightFieldError::NonFinite { corner: 1 }));
    // Clockwise triangles are turned; corners that nobody has go.
    let turned = HeightField::new(points.clone(), vec![[0, 2, 1], [1, 2, 3]]).unwrap();
    assert_eq!((turned.triangles[0], turned.points.len()), ([0, 1, 2], 4));
}

#[test]
fn bins_name_every_triangle_near_a_rectangle() {
    let (x, y) = (line(20, 0.7), line(15, 1.3));
    let field = HeightField::grid(&x, &y, |i, j| Some(hill(x[i], y[j]))).unwrap();
    let bins = Bins::new(&field);
    let mut found = Vec::new();
    for (low, high) in
        [([1.0, 1.0], [2.0, 5.0]), ([-9.0, 3.0], [99.0, 3.1]), ([50.0; 2], [60.0; 2])]
    {
        bins.near(low, high, &mut found);
        assert!(found.windows(2).all(|w| w[0] < w[1]));
        for t in 0..field.triangles.len() {
            let [a, b, c] = field.corners(t);
            let (min, max) = (a.min(b).min(c), a.max(b).max(c));
            let meets = min.x <= high[0] && max.x >= low[0] && min.y <= high[1] && max.y >= low[1];
            assert!(!meets || found.contains(&(t as u32)));
        }
    }
}

/// Thin triangles around one corner: the boxes of those askew reach all over the surface, and their lists took gigabytes.
#[test]
fn bins_of_a_fan_stay_small() {
    let count = 20_000;
    let angle = |k: u32| std::f64::consts::FRAC_PI_2 * f64::from(k) / f64::from(count);
    let mut points = vec![Vec3::ZERO];
    points.extend((0..=count).map(|k| Vec3::new(libm::cos(angle(k)), libm::sin(angle(k)), 0.0)));
    let triangles = (1..=count).map(|k| [0, k, k + 1]).collect();
    let field = HeightField { points, triangles };
    let bins = Bins::new(&field);
    let entries: usize = bins.lists().map(<[u32]>::len).sum();
    assert!(entries <= 64 * count as usize, "{entries}");
    let mut found = Vec::new();
    for k in [1, 300, 10_000, 19_999] {
        let (s, c) = libm::sincos(angle(k) + 0.5 * angle(1));
        assert!(bins.at(0.9 * c, 0.9 * s).contains(&k));
        bins.near([0.9 * c, 0.9 * s], [0.95 * c, 0.95 * s], &mut found);
        assert!(found.contains(&k));
    }
}
