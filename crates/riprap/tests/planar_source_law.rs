//! Unit values of both normal laws, and what the source's law gives up for locality.

use crate::common::{DISTANCE, Model, Random, SOURCE, law, moved, points, rectangle, turned};
use riprap::Vec2;
use riprap::planar::world::Wrench;

const PN: f64 = 300e9;

fn wrench(a: &[Vec2], b: &[Vec2]) -> Wrench {
    Model::pair(a, b, law(SOURCE, PN)).wrench()
}

fn close(value: f64, exact: f64, relative: f64, what: &str) {
    assert!((value - exact).abs() <= relative * exact.abs(), "{what}: {value} against {exact}");
}

/// A right-angled corner `d` below y = 0.
fn corner(d: f64, h: f64) -> Vec<Vec2> {
    points(&[(0.0, -d), (h, h - d), (-h, h - d)])
}

#[test]
fn a_corner_in_a_long_edge() {
    let d = 1e-4;
    let w = wrench(&corner(d, 0.7), &rectangle(-4.0, -3.0, 5.0, 0.0));
    close(w.force.y, PN * d * d * (1.0 + 0.5f64.sqrt()), 1e-10, "total");
    close(w.force.y, 5_121.320_343_559_643, 1e-10, "printed total");
    assert!(w.force.x.abs() < 1e-10 * w.force.y);
}

#[test]
fn an_edge_in_a_longer_edge() {
    let (l, h) = (1.0, 1e-6);
    let w = wrench(&rectangle(0.0, -h, l, 1.0), &rectangle(-4.0, -3.0, 5.0, 0.0));
    close(w.force.y, 1.5 * PN * l * h, 1e-9, "total");
    assert!(w.force.x.abs() < 1e-10 * w.force.y);
}

#[test]
fn a_corner_against_a_corner() {
    let d = 1e-4;
    let w = wrench(&corner(d, 0.7), &points(&[(0.0, 0.0), (-0.9, -0.9), (0.9, -0.9)]));
    close(w.force.y, PN * d * d / 2f64.sqrt(), 1e-10, "total");
    close(w.force.y, 2_121.320_343_559_643, 1e-10, "printed total");
    assert!(w.force.x.abs() < 1e-10 * w.force.y);
}

/// Wrench about a fixed global point, so that blocks with other centroids can be compared.
fn about_origin(a: &[Vec2], b: &[Vec2]) -> (Vec2, f64) {
    let model = Model::pair(a, b, law(SOURCE, PN));
    let w = model.wrench();
    let arm = model.world.bodies[0].position;
    (w.force, arm.perp_dot(w.force) + w.moment_i)
}

#[test]
fn the_source_law_does_not_see_size_or_shape() {
    let (d, tilt) = (1e-3, 0.1);
    let tip = Vec2::new(0.03, -d);
    let small = moved(&points(&[(0.0, 0.0), (0.5, 0.4), (-0.3, 0.6)]), tilt, tip);
    // Same two edges at the tip, ten times as long, other far side.
    let large =
        moved(&points(&[(0.0, 0.0), (5.0, 4.0), (4.0, 9.0), (1.0, 8.0), (-3.0, 6.0)]), tilt, tip);
    let base = rectangle(-2.0, -1.0, 2.0, 0.0);
    let other_base = points(&[(-20.0, 0.0), (-19.0, -3.0), (3.0, -40.0), (25.0, 0.0)]);
    let (force, moment) = about_origin(&small, &base);
    assert!(force.y > 0.0);
    for (a, b) in [(&large, &base), (&small, &other_base), (&large, &other_base)] {
        let (f, m) = about_origin(a, b);
        // The larger bodies are placed to 1e-15 of their size, 1e-12 of the depth.
        let tolerance = 1e-11;
        assert!((f - force).length() <= tolerance * force.length(), "{f} {force}");
        assert!((m - moment).abs() <= tolerance * force.length(), "{m} {moment}");
    }
    let (f, m) = about_origin(&base, &small);
    assert!((f + force).length() <= 1e-13 * force.length());
    assert!((m + moment).abs() <= 1e-13 * force.length());
}

#[test]
fn both_laws_turn_and_shift_with_the_pair() {
    let mut random = Random(7);
    for normal in [DISTANCE, SOURCE] {
        for _ in 0..50 {
            let a = random.convex(1.0);
            let b = moved(&random.convex(1.0), 0.0, Vec2::new(0.6, 0.1));
            let w = Model::pair(&a, &b, law(normal, 1e9)).wrench();
            let (angle, shift) = (
                random.between(-3.0, 3.0),
                Vec2::new(random.between(-1.0, 1.0), random.between(-1.0, 1.0)),
            );
            let (c, d) = (moved(&a, angle, shift), moved(&b, angle, shift));
            let v = Model::pair(&c, &d, law(normal, 1e9)).wrench();
            let scale = w.force.length().max(1e9 * 1e-3);
            assert!((v.force - turned(w.force, angle)).length() < 1e-12 * scale);
            assert!((v.moment_i - w.moment_i).abs() < 1e-12 * scale);
            assert!((v.moment_j - w.moment_j).abs() < 1e-12 * scale);
        }
    }
}

/// A 10 degree half-angle wedge, 0.1 deep, at a distance from a side edge of the base.
fn wedge_near_a_side(normal: riprap::planar::setup::NormalLaw, distance: f64) -> Vec2 {
    let (d, h) = (0.1, 1.0);
    let w = h * 10f64.to_radians().tan();
    let wedge = points(&[(0.0, -d), (w, h - d), (-w, h - d)]);
    let base = rectangle(-distance, -2.0, 3.0, 0.0);
    Model::pair(&wedge, &base, law(normal, 1.0)).wrench().force
}

#[test]
fn the_distance_law_feels_a_nearby_side_and_the_source_law_does_not() {
    for (s, x, y) in [
        (1.0, 0.0, 1.035e-3),
        (0.1, 0.0, 1.035e-3),
        (0.05, -0.23e-3, 0.81e-3),
        (0.02, -0.58e-3, 0.45e-3),
    ] {
        let f = wedge_near_a_side(DISTANCE, s);
        assert!((f - Vec2::new(x, y)).length() < 1e-5, "distance {s}: {f} against ({x}, {y})");
    }
    let far = wedge_near_a_side(SOURCE, 1.0);
    for s in [0.1, 0.05, 0.02] {
        let f = wedge_near_a_side(SOURCE, s);
        assert!((f - far).length() < 1e-12 * far.length(), "{s}: {f} {far}");
    }
}

/// Normal force of a brick on a longer one whose end its own end passes by `x`.
fn passing(normal: riprap::planar::setup::NormalLaw, x: f64) -> f64 {
    let top = rectangle(x, -1e-6, 1.0 + x, 0.5);
    let base = rectangle(0.0, -0.5, 3.0, 0.0);
    Model::pair(&top, &base, law(normal, 1e9)).wrench().force.y
}

#[test]
fn both_laws_press_alike_on_either_side_of_an_end_that_passes_an_end() {
    for (normal, factor) in [(SOURCE, 1.5), (DISTANCE, 1.0)] {
        for x in [1e-4, 1e-7, -1e-7, -1e-4] {
            let ratio = passing(normal, x) / (factor * 1e9 * 1e-6);
            assert!((ratio - 1.0).abs() < 2e-4, "{normal:?} at {x}: {ratio}");
        }
    }
}

#[test]
fn the_distance_law_does_not_jump_as_a_corner_slides_over_a_corner() {
    // From corner-edge past the end of the base in 1e-7 m steps: 2 % of the full force at most.
    let d = 1e-5;
    for normal in [DISTANCE] {
        let mut last: Option<f64> = None;
        for k in -200..400 {
            let x = f64::from(k) * 1e-7;
            let top = moved(&corner(d, 0.5), 0.05, Vec2::new(x, 0.0));
            let base = rectangle(-3.0, -1.0, 0.0, 0.0);
            let f = Model::pair(&top, &base, law(normal, 1e9)).wrench().force;
            if let Some(before) = last {
                assert!(
                    (f.length() - before).abs() < 0.02 * 1e9 * d * d,
                    "{normal:?} at {x}: {before} -> {}",
                    f.length()
                );
            }
            last = Some(f.length());
        }
    }
}
