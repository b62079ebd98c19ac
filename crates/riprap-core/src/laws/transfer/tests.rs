//! Cut blocks: what is kept, and what is never gained.

use super::*;
use crate::geom::polyhedron::Polyhedron;
use crate::geom::polyhedron::cut::{Limits, Planes, cut};

fn noise(state: &mut u64) -> f64 {
    *state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
    (*state >> 11) as f64 / (1u64 << 53) as f64 - 0.5
}

fn vector(state: &mut u64) -> Vec3 {
    Vec3::new(noise(state), noise(state), noise(state))
}

/// A cube and its parts, three planes in a random direction.
fn random_cut(state: &mut u64) -> (Tetrahedra, Vec<Tetrahedra>) {
    let cube = Polyhedron::brick(Vec3::new(0.4, -0.2, 0.7), Vec3::splat(0.015));
    let limits = Limits::default();
    let made = cut(&cube, vector(state), Planes::Spaced { count: 3 }, &limits).unwrap();
    let parts = made.parts.into_iter().map(|p| p.mesh).collect();
    (Tetrahedra::new(&cube).unwrap(), parts)
}

#[test]
fn linear_fields_are_handed_on_exactly() {
    let mut state = 3;
    for _ in 0..20 {
        let (parent, parts) = random_cut(&mut state);
        let field = |x: Vec3| [x.x - 2.0 * x.y, 0.5 * x.z, x.x + x.y + 3.0];
        let values: Vec<[f64; 3]> = parent.nodes.iter().map(|x| field(*x)).collect();
        let location = PointLocation::new(&parent);
        for x in parts.iter().flat_map(|p| &p.nodes) {
            let place = location.locate(*x);
            // The place in all tetrahedra that the point lies well inside of is the same; between them any will do.
            let (best, inside) = nearest(&parent, *x, 0..parent.tets.len());
            assert!(place == best || inside < WELL_INSIDE);
            assert!(place.weights.iter().all(|w| *w > -1e-9));
            let got = interpolate(&place, &values);
            assert!((0..3).all(|k| (got[k] - field(*x)[k]).abs() < 1e-13));
        }
    }
}

/// Spin, stretching and noise: momenta exact, kinetic energy at most 0.5 % more with inertial masses.
#[test]
fn momenta_are_kept_and_no_energy_is_made() {
    let mut state = 1;
    let (mut worst, mut lumped_worst) = (0.0_f64, 0.0_f64);
    for case in 0..80 {
        let (parent, parts) = random_cut(&mut state);
        let (spin, shift) = (vector(&mut state), 0.01 * vector(&mut state));
        let rough = if case % 2 == 0 { 0.0 } else { 0.003 };
        let centre = parent.nodes[14];
        let v: Vec<[f64; 3]> = parent
            .nodes
            .iter()
            .map(|x| (shift + spin.cross(*x - centre) + rough * vector(&mut state)).to_array())
            .collect();
        let at: Vec<Vec3> = parts.iter().flat_map(|p| p.nodes.clone()).collect();
        let location = PointLocation::new(&parent);
        let places: Vec<Place> = at.iter().map(|x| location.locate(*x)).collect();
        for inertial in [true, false] {
            let masses = |mesh: &Tetrahedra| {
                let shares = if inertial { mesh.inertial() } else { mesh.lumped() };
                shares.into_iter().map(|s| 2400.0 * s).collect::<Vec<f64>>()
            };
            let before = motion(&masses(&parent), &parent.nodes, &v);
            let new: Vec<f64> = parts.iter().flat_map(masses).collect();
            assert!((new.iter().sum::<f64>() / before.mass - 1.0).abs() < 1e-13);
            let mut w: Vec<[f64; 3]> = places.iter().map(|p| interpolate(p, &v)).collect();
            let gain = conserve(&before, &new, &at, &mut w);
            let after = motion(&new, &at, &w);
            let scale = before.mass * (0.05 * spin.length() + shift.length());
            assert!(after.momentum.distance(before.momentum) < 1e-13 * scale);
            assert!(after.spin.distance(before.spin) < 1e-13 * scale);
            assert!((after.kinetic - before.kinetic - gain).abs() < 1e-12 * before.kinetic);
            let ratio = after.kinetic / before.kinetic;
            if inertial {
                worst = worst.max(ratio);
            } else {
                lumped_worst = lumped_worst.max(ratio);
            }
        }
    }
    assert!(worst <= 1.005, "{worst}");
    assert!(lumped_worst > 1.01, "plain lumped masses would do: {lumped_worst}");
}

/// The mean of any stress stays; a linear one stays linear, with a little less slope than it had.
#[test]
fn the_mean_stress_stays() {
    let mut state = 9;
    for _ in 0..10 {
        let (parent, parts) = random_cut(&mut state);
        let rough: Vec<Symmetric> =
            parent.tets.iter().map(|_| [0; 6].map(|_| noise(&mut state))).collect();
        let total = |mesh: &Tetrahedra, stresses: &[Symmetric], k: usize| -> f64 {
            let pairs = mesh.volumes.iter().zip(stresses);
            pairs.map(|(v, s)| v * s[k]).sum()
        };
        let field = LinearStress::new(&parent, &rough);
        for k in 0..6 {
            let before = total(&parent, &rough, k);
            let after: f64 = parts.iter().map(|p| total(p, &field.means(p), k)).sum();
            assert!((after - before).abs() < 1e-13 * parent.volume());
        }
        let (slope, centre) = (vector(&mut state), parent.nodes[14]);
        let linear: Vec<Symmetric> = parent
            .tets
            .iter()
            .map(|tet| {
                let at: Vec3 = tet.map(|k| parent.nodes[k as usize]).into_iter().sum();
                [3.0 + slope.dot(0.25 * at - centre); 6]
            })
            .collect();
        let field = LinearStress::new(&parent, &linear);
        for x in parts.iter().flat_map(|p| &p.nodes) {
            let (got, exact) = (field.at(*x)[2] - 3.0, slope.dot(*x - centre));
            // 24 constant pieces of a cube have 13/16 of the first moments.
            assert!((got - 13.0 / 16.0 * exact).abs() < 1e-12, "{}", got / exact);
        }
    }
}

/// Strain energy after a cut over that before, by mean stresses and by interpolation alone.
#[test]
fn mean_stresses_never_gain_energy() {
    let law = Elastic::new(40e9, 0.25);
    let mut state = 17;
    let (mut worst, mut plain_worst) = (0.0_f64, 0.0_f64);
    for strain in [Strain::Small, Strain::Large] {
        for _ in 0..40 {
            let (parent, parts) = random_cut(&mut state);
            let groups = Groups::new(&parent);
            let u: Vec<[f64; 3]> =
                parent.nodes.iter().map(|_| (1e-5 * vector(&mut state)).to_array()).collect();
            let none = StartStress::default();
            let old = stresses(&groups, &law, strain, &none, &u);
            let energy = |s: &[Symmetric], v: &[f64]| -> f64 {
                s.iter().zip(v).map(|(s, v)| v * stress_energy(&law, s)).sum()
            };
            let before = energy(&old, &parent.volumes);
            assert!((before / groups.energy(&law, strain, &none, &u) - 1.0).abs() < 1e-12);
            let (mut after, mut plain) = (0.0, 0.0);
            let field = LinearStress::new(&parent, &old);
            let location = PointLocation::new(&parent);
            for part in &parts {
                let groups = Groups::new(part);
                let new_u: Vec<[f64; 3]> =
                    part.nodes.iter().map(|x| interpolate(&location.locate(*x), &u)).collect();
                let wanted = field.means(part);
                let start = start_stresses(&groups, &law, strain, &new_u, &wanted);
                let carried = stresses(&groups, &law, strain, &start, &new_u);
                for (a, b) in carried.iter().zip(&wanted) {
                    assert!((0..6).all(|k| (a[k] - b[k]).abs() < 1e-3));
                }
                after += energy(&carried, &part.volumes);
                plain += groups.energy(&law, strain, &none, &new_u);
            }
            worst = worst.max(after / before);
            plain_worst = plain_worst.max(plain / before);
        }
    }
    assert!(worst <= 1.0, "{worst}");
    assert!(plain_worst > 1.0, "interpolation would do: {plain_worst}");
}
