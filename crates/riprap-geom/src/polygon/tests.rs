use super::*;
use proptest::prelude::*;

fn points(list: &[(f64, f64)]) -> Vec<Vec2> {
    list.iter().map(|&(x, y)| Vec2::new(x, y)).collect()
}

/// Star-shaped about (0, 0), so simple for any radii.
fn star(radii: &[f64]) -> Vec<Vec2> {
    let n = radii.len() as f64;
    let at = |(i, &r): (usize, &f64)| r * Vec2::from_angle(std::f64::consts::TAU * i as f64 / n);
    radii.iter().enumerate().map(at).collect()
}

#[test]
fn rectangle_has_the_handbook_moments() {
    let m = mass_properties(&points(&[(1.0, 2.0), (4.0, 2.0), (4.0, 4.0), (1.0, 4.0)]));
    assert_eq!(m.area, 6.0);
    assert_eq!(m.centroid, Vec2::new(2.5, 3.0));
    assert!((m.second_moment - 6.0 * (9.0 + 4.0) / 12.0).abs() < 1e-14);
}

#[test]
fn says_what_is_wrong() {
    let bow = points(&[(0.0, 0.0), (2.0, 2.0), (2.0, 0.0), (0.0, 2.0)]);
    assert!(matches!(
        validate(&bow),
        Err(GeomError::SelfIntersecting { edge_a: 0, edge_b: 2, .. })
    ));
    let line = points(&[(0.0, 0.0), (1.0, 1.0), (2.0, 2.0), (3.0, 3.0)]);
    assert!(matches!(validate(&line), Err(GeomError::ZeroArea { .. })));
    let spike = points(&[(0.0, 0.0), (4.0, 0.0), (2.0, 0.0), (2.0, 2.0)]);
    assert!(matches!(validate(&spike), Err(GeomError::Spike { vertex: 1, .. })));
    let nan = points(&[(0.0, 0.0), (f64::NAN, 0.0), (2.0, 0.0)]);
    assert!(matches!(validate(&nan), Err(GeomError::NonFinite { vertex: 1, .. })));
    assert!(matches!(validate(&nan[..1]), Err(GeomError::TooFewVertices { count: 1 })));
    let touch = points(&[(0.0, 0.0), (4.0, 0.0), (4.0, 3.0), (2.0, 0.0), (0.0, 3.0)]);
    assert!(matches!(validate(&touch), Err(GeomError::SelfIntersecting { .. })));
    let huge = points(&[(0.0, 0.0), (1e300, 0.0), (0.0, 1e300)]);
    assert!(matches!(validate(&huge), Err(GeomError::NonFinite { .. })));
    assert_eq!(validate(&star(&vec![1.0; tol::MAX_VERTICES])), Ok(()));
    assert!(validate(&star(&vec![1.0; tol::MAX_VERTICES + 1])).is_err());
}

#[test]
fn clean_up_tells_what_it_did() {
    let messy = points(&[(0.0, 0.0), (0.0, 2.0), (0.0, 2.0), (2.0, 2.0), (2.0, 0.0), (1.0, 0.0)]);
    let (clean, changes) = normalise(&messy, Collinear::Drop);
    assert_eq!(changes, Changes { repeated: 1, collinear: 1, reversed: true });
    assert_eq!(clean, points(&[(0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0)]));
    let (kept, changes) = normalise(&messy, Collinear::Keep);
    assert_eq!((kept.len(), changes.collinear), (5, 0));
    assert!(normalise(&[], Collinear::Drop).0.is_empty());
    assert_eq!(normalise(&[Vec2::ONE; 7], Collinear::Drop).0.len(), 1);
}

#[test]
fn edges_of_nanometres_are_no_edges() {
    let square = |edge: f64| {
        points(&[
            (0.0, 0.0),
            (10.0, 0.0),
            (10.0, 10.0),
            (10.0 - edge, 10.0),
            (0.0, 10.0),
            (0.0, edge),
        ])
    };
    for edge in [1e-12, 1e-9, 1e-7] {
        let (clean, changes) = normalise(&square(edge), Collinear::Keep);
        assert_eq!((clean.len(), changes.repeated), (4, 2), "{edge}");
    }
    // What is drawn stays.
    let (clean, changes) = normalise(&square(1e-6), Collinear::Keep);
    assert_eq!((clean.len(), changes.repeated), (6, 0));
}

#[test]
fn locates_on_a_concave_outline() {
    let l = points(&[(0.0, 0.0), (2.0, 0.0), (2.0, 1.0), (1.0, 1.0), (1.0, 2.0), (0.0, 2.0)]);
    assert_eq!(locate(&l, Vec2::new(0.5, 1.5)), Side::Inside);
    assert_eq!(locate(&l, Vec2::new(1.5, 1.5)), Side::Outside);
    assert_eq!(locate(&l, Vec2::new(0.5, 1.0)), Side::Inside);
    for &v in &l {
        assert_eq!(locate(&l, v), Side::Boundary);
    }
    for (a, b) in edges(&l) {
        assert_eq!(locate(&l, 0.5 * (a + b)), Side::Boundary);
    }
}

proptest! {
    #[test]
    fn moments_are_those_of_the_fan_and_do_not_feel_1e6(
        radii in prop::collection::vec(0.2..3.0f64, 3..24),
    ) {
        let shape = star(&radii);
        prop_assert_eq!(validate(&shape), Ok(()));
        let m = mass_properties(&shape);
        let (mut area, mut first) = (0.0, Vec2::ZERO);
        for (a, b) in edges(&shape) {
            let t = 0.5 * a.perp_dot(b);
            area += t;
            first += t * (a + b) / 3.0;
        }
        let c = first / area;
        let mut second = 0.0;
        for (a, b) in edges(&shape) {
            // Triangle about its own centroid, then Steiner.
            let g = (a + b) / 3.0;
            let t = 0.5 * a.perp_dot(b);
            let sides = a.length_squared() + b.length_squared() + a.distance_squared(b);
            second += t * (sides / 36.0 + g.distance_squared(c));
        }
        prop_assert!((m.area / area - 1.0).abs() < 1e-13);
        prop_assert!(m.centroid.distance(c) < 1e-13);
        prop_assert!((m.second_moment / second - 1.0).abs() < 1e-12);
        // A shift by a power of two, of vertices with the low bits free, changes nothing.
        let coarse: Vec<Vec2> =
            shape.iter().map(|v| (v * 1048576.0).round() / 1048576.0).collect();
        let shift = Vec2::new(1048576.0, -1048576.0);
        let far: Vec<Vec2> = coarse.iter().map(|&v| v + shift).collect();
        let (near, far) = (mass_properties(&coarse), mass_properties(&far));
        prop_assert_eq!(near.area.to_bits(), far.area.to_bits());
        prop_assert!((near.second_moment / far.second_moment - 1.0).abs() < 1e-13);
        prop_assert!((far.centroid - shift).distance(near.centroid) < 2e-10);
    }

    #[test]
    fn silly_numbers_do_not_panic(
        list in prop::collection::vec((any::<f64>(), any::<f64>()), 0..12),
    ) {
        let shape = points(&list);
        let _ = validate(&shape);
        let (clean, _) = normalise(&shape, Collinear::Drop);
        let _ = mass_properties(&clean);
        let _ = locate(&clean, Vec2::new(0.3, 0.2));
    }
}
