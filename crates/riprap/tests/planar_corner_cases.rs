//! Configurations in which contact codes break: shared edges, vertices on vertices, slivers, containment, far
//! coordinates, huge angles. For both laws: finite, action equals reaction at the same points, the order of
//! the blocks does not matter, and (distance potential) no jump under tiny moves.

use crate::common::{
    DISTANCE, Model, SOURCE, block, comb, general, l_shape, law, moved, notched, points, rectangle,
    setup, u_shape,
};
use riprap::Vec2;
use riprap::planar::setup::ContactLaw;

const STIFFNESS: f64 = 1e9;

/// Name and two outlines.
fn cases() -> Vec<(String, Vec<Vec2>, Vec<Vec2>)> {
    let square = rectangle(0.0, 0.0, 1.0, 1.0);
    let mut list = vec![
        ("identical squares", square.clone(), square.clone()),
        ("shared edge", square.clone(), rectangle(1.0, 0.0, 2.0, 1.0)),
        ("shared part of an edge", square.clone(), rectangle(1.0, 0.3, 2.0, 1.6)),
        ("collinear edges, overlapping", square.clone(), rectangle(0.4, 0.999, 1.4, 1.999)),
        ("vertex on vertex", square.clone(), rectangle(1.0, 1.0, 2.0, 2.0)),
        ("vertex on edge", square.clone(), points(&[(0.5, 1.0), (1.0, 2.0), (0.0, 2.0)])),
        ("crossed bars", rectangle(-1.0, -0.05, 1.0, 0.05), rectangle(-0.05, -1.0, 0.05, 1.0)),
        ("containment", rectangle(0.0, 0.0, 4.0, 4.0), rectangle(1.5, 1.7, 2.0, 2.0)),
        (
            "comb on a flat",
            moved(&comb(), 0.0, Vec2::new(0.0, 0.999)),
            rectangle(-1.0, 0.0, 2.0, 1.0),
        ),
        ("wedge in a notch", notched(), points(&[(0.6, 0.299), (0.7, 0.8), (0.5, 0.8)])),
        ("reflex corner on a peak", l_shape(), points(&[(0.399, 0.399), (0.9, 0.6), (0.6, 0.9)])),
        ("block in a slot", u_shape(), rectangle(0.299, 0.299, 0.901, 1.2)),
        (
            "sliver of 0.1 deg",
            points(&[(0.0, 0.999), (3.0, 1.5), (3.0, 1.505_236)]),
            rectangle(-1.0, 0.0, 1.0, 1.0),
        ),
        (
            "edge shorter than the depth",
            points(&[(0.5, 0.99), (0.501, 0.99), (0.6, 1.5), (0.4, 1.5)]),
            square.clone(),
        ),
        (
            "size ratio 1e4",
            rectangle(0.5, 0.999_99, 0.5001, 1.000_09),
            rectangle(-0.5, -1.0, 1.5, 1.0),
        ),
        (
            "collinear vertices",
            points(&[(0.0, 0.0), (0.3, 0.0), (0.5, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)]),
            rectangle(0.2, -1.0, 0.7, 1e-3),
        ),
        ("two combs", comb(), moved(&comb(), std::f64::consts::PI, Vec2::new(1.3, 0.28))),
    ]
    .into_iter()
    .map(|(name, a, b)| (name.to_owned(), a, b))
    .collect::<Vec<_>>();
    for exponent in [-12, -9, -6, -4, -2] {
        let d = 10f64.powi(exponent);
        list.push((
            format!("flat, depth {d:e}"),
            rectangle(0.2, 1.0 - d, 0.8, 2.0),
            square.clone(),
        ));
    }
    list
}

fn laws() -> [ContactLaw; 3] {
    [law(DISTANCE, STIFFNESS), general(law(DISTANCE, STIFFNESS)), law(SOURCE, STIFFNESS)]
}

#[test]
fn forces_are_finite_and_balanced_in_either_order() {
    for (name, a, b) in cases() {
        for law in laws() {
            let model = Model::pair(&a, &b, law);
            let w = model.wrench();
            assert!(
                w.force.is_finite() && w.moment_i.is_finite() && w.moment_j.is_finite(),
                "{name}"
            );
            let (left, scale) = model.leftover_moment();
            assert!(left.abs() <= 1e-12 * scale + 1e-9, "{name}: moment {left} of {scale}");
            let swapped = Model::pair(&b, &a, law).wrench();
            // What round-off of the overlap itself (1e-16 m) can carry.
            let noise = STIFFNESS * 1e-14;
            let off = (w.force + swapped.force).length();
            assert!(off <= 1e-12 * w.force.length() + noise, "{name}: {w:?} {swapped:?}");
            assert!(
                (w.moment_i - swapped.moment_j).abs() <= 1e-11 * scale + noise,
                "{name}: {w:?} {swapped:?}"
            );
        }
    }
}

#[test]
fn both_roads_give_the_same_force() {
    for (name, a, b) in cases() {
        let fast = Model::pair(&a, &b, law(DISTANCE, STIFFNESS)).wrench();
        let slow = Model::pair(&a, &b, general(law(DISTANCE, STIFFNESS))).wrench();
        let scale = fast.force.length() + fast.moment_i.abs();
        let off = (fast.force - slow.force).length();
        // Identical squares: every point of either boundary lies on the other; only round-off differs.
        assert!(off <= 1e-10 * scale + 1e-4, "{name}: {fast:?} {slow:?}");
    }
}

#[test]
fn tiny_moves_change_the_force_a_little() {
    for (name, a, b) in cases() {
        let mut model = Model::pair(&a, &b, law(DISTANCE, STIFFNESS));
        let (before, x) = (model.wrench(), model.world.bodies[0].position);
        for direction in [Vec2::X, Vec2::Y, -Vec2::X, -Vec2::Y, Vec2::new(0.6, -0.8)] {
            model.place(0, x + 1e-9 * direction, 0.0);
            let jump = (model.wrench().force - before.force).length();
            // Contact lengths here are below 4 m on each of two boundaries: kn L dx.
            assert!(jump <= STIFFNESS * 8.0 * 1e-9, "{name}: jump {jump} N/m");
        }
    }
}

#[test]
fn far_from_the_origin_and_turned_often() {
    for (name, a, b) in cases().into_iter().filter(|(name, ..)| !name.contains("depth 1e-")) {
        let law = law(DISTANCE, STIFFNESS);
        let near = Model::pair(&a, &b, law).wrench();
        let shift = Vec2::splat(1e5);
        let far = Model::pair(&moved(&a, 0.0, shift), &moved(&b, 0.0, shift), law).wrench();
        // Corners given at 1e5 m are rounded to 1.5e-11 m.
        let off = (near.force - far.force).length();
        assert!(off <= STIFFNESS * 8.0 * 3e-11, "{name}: {near:?} {far:?}");
    }
    // A block that has turned a million radians is where its angle says.
    let mut one = setup(
        vec![block(&rectangle(0.0, -1e-3, 1.0, 1.0)), block(&rectangle(-3.0, -2.0, 4.0, 0.0))],
        law(DISTANCE, STIFFNESS),
    );
    one.blocks[0].spin = 0.0;
    let mut model = Model::new(one);
    model.evaluate(1e-9);
    let (straight, x) = (model.wrench(), model.world.bodies[0].position);
    let turns = 159_155.0 * std::f64::consts::TAU;
    model.place(0, x, turns);
    let off = (model.wrench().force - straight.force).length();
    assert!(off <= 1e-3 * straight.force.length(), "{off}");
}
