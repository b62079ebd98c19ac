//! Elements against closed forms, each other and the dense matrix; invariances; speed on request.

use super::*;
use crate::Vec3;
use crate::geom::polyhedron::{Polyhedron, hull};

const ROCK: (f64, f64) = (40e9, 0.25);

fn law() -> Elastic {
    Elastic::new(ROCK.0, ROCK.1)
}

fn cube() -> Tetrahedra {
    Tetrahedra::new(&Polyhedron::brick(Vec3::splat(0.1), Vec3::new(0.015, 0.02, 0.01))).unwrap()
}

/// Numbers in -0.5 to 0.5, always the same.
fn noise(state: &mut u64) -> f64 {
    *state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
    (*state >> 11) as f64 / (1u64 << 53) as f64 - 0.5
}

fn stone(seed: u64, corners: usize) -> Tetrahedra {
    let mut state = seed + 1;
    let points: Vec<Vec3> = (0..corners)
        .map(|_| {
            let mut next = || noise(&mut state);
            Vec3::new(next(), next(), next()).normalize()
        })
        .collect();
    Tetrahedra::new(&hull(&points).unwrap()).unwrap()
}

fn field(mesh: &Tetrahedra, mut u: impl FnMut(Vec3) -> Vec3) -> Vec<[f64; 3]> {
    mesh.nodes.iter().map(|x| u(*x).to_array()).collect()
}

fn random(mesh: &Tetrahedra, size: f64, seed: u64) -> Vec<[f64; 3]> {
    let mut state = seed;
    field(mesh, |_| size * Vec3::new(noise(&mut state), noise(&mut state), noise(&mut state)))
}

fn run(groups: &Groups, strain: Strain, u: &[[f64; 3]], width: Width) -> Vec<[f64; 3]> {
    let mut f = vec![[0.0; 3]; u.len()];
    forces(width, groups, &law(), strain, &StartStress::default(), u, &mut f);
    f
}

fn largest(f: &[[f64; 3]]) -> f64 {
    f.as_flattened().iter().fold(0.0, |m, x| x.abs().max(m))
}

fn apart(f: &[[f64; 3]], g: &[[f64; 3]]) -> f64 {
    let pairs = f.as_flattened().iter().zip(g.as_flattened());
    pairs.fold(0.0, |m: f64, (a, b)| m.max((a - b).abs())) / largest(g)
}

#[test]
fn groups_single_elements_and_the_matrix_agree() {
    for mesh in [cube(), stone(3, 13)] {
        let groups = Groups::new(&mesh);
        let u = random(&mesh, 1e-3, 5);
        for strain in [Strain::Small, Strain::Large] {
            let f = run(&groups, strain, &u, Width::detect());
            let mut g = vec![[0.0; 3]; u.len()];
            for (t, tet) in mesh.tets.iter().enumerate() {
                let at = tet.map(|k| u[k as usize]);
                let gradients = mesh.gradients[t].map(|g| g.to_array());
                let on = one(&law(), strain, mesh.volumes[t], &gradients, &at);
                for (k, f) in tet.iter().zip(on) {
                    for i in 0..3 {
                        g[*k as usize][i] += f[i];
                    }
                }
            }
            assert!(apart(&f, &g) < 1e-13, "{}", apart(&f, &g));
        }
        let matrix = Stiffness::new(&mesh, &law());
        let mut g = vec![[0.0; 3]; u.len()];
        matrix.forces(Width::detect(), &u, &mut g);
        assert!(apart(&run(&groups, Strain::Small, &u, Width::PLAIN), &g) < 1e-13);
    }
}

#[test]
fn all_widths_give_the_same_bits() {
    for mesh in [cube(), stone(8, 17)] {
        let groups = Groups::new(&mesh);
        let matrix = Stiffness::new(&mesh, &law());
        let u = random(&mesh, 1e-2, 2);
        let dense = |width: Width| {
            let mut f = vec![[0.0; 3]; u.len()];
            matrix.forces(width, &u, &mut f);
            f
        };
        for width in [4, 8].map(|numbers| Width::detect().at_most(numbers)) {
            for strain in [Strain::Small, Strain::Large] {
                let plain = run(&groups, strain, &u, Width::PLAIN);
                assert_eq!(plain, run(&groups, strain, &u, width));
            }
            assert_eq!(dense(Width::PLAIN), dense(width));
        }
    }
}

#[test]
fn uniform_strain_gives_hookes_stress_and_no_force_inside() {
    let mesh = stone(5, 12);
    let groups = Groups::new(&mesh);
    let h = [[1e-4, 2e-4, 0.0], [-1e-4, 3e-4, 5e-5], [2e-5, 0.0, -2e-4]];
    let u = field(&mesh, |x| Vec3::from_array(h.map(|row| Vec3::from_array(row).dot(x))));
    let none = StartStress::default();
    let (s, slope) = groups.average(&law(), Strain::Small, &none, &u);
    let Elastic { lambda, mu } = law();
    let trace = h[0][0] + h[1][1] + h[2][2];
    let expected = [
        lambda * trace + 2.0 * mu * h[0][0],
        lambda * trace + 2.0 * mu * h[1][1],
        lambda * trace + 2.0 * mu * h[2][2],
        mu * (h[1][2] + h[2][1]),
        mu * (h[2][0] + h[0][2]),
        mu * (h[0][1] + h[1][0]),
    ];
    for (a, b) in s.iter().zip(expected) {
        assert!((a - b).abs() < 1e-9 * lambda * 1e-4, "{a} {b}");
    }
    for (a, b) in slope.as_flattened().iter().zip(h.as_flattened()) {
        assert!((a - b).abs() < 1e-15);
    }
    for one in groups.stresses(&law(), Strain::Small, &none, &u) {
        assert!(one.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-3));
    }
    let f = run(&groups, Strain::Small, &u, Width::detect());
    let centre = f[f.len() - 1];
    assert!(centre.iter().all(|x| x.abs() < 1e-10 * largest(&f)));
    // Surface forces are the traction times the shares of the areas.
    let mut balance = f.clone();
    for face in 0..mesh.first.len() - 1 {
        for [m, a, b] in mesh.fan(face) {
            let at = |k: u32| mesh.nodes[k as usize];
            let third = (at(a) - at(m)).cross(at(b) - at(m)) / 6.0;
            let t = [
                s[0] * third.x + s[5] * third.y + s[4] * third.z,
                s[5] * third.x + s[1] * third.y + s[3] * third.z,
                s[4] * third.x + s[3] * third.y + s[2] * third.z,
            ];
            for k in [m, a, b] {
                for i in 0..3 {
                    balance[k as usize][i] += t[i];
                }
            }
        }
    }
    assert!(largest(&balance) < 1e-12 * largest(&f));
}

#[test]
fn forces_are_the_slope_of_the_energy() {
    let mesh = cube();
    let groups = Groups::new(&mesh);
    let u = random(&mesh, 1e-3, 11);
    let stresses: Vec<Symmetric> =
        (0..groups.tets()).map(|k| [1e6 * k as f64, 2e6, -3e6, 1e5, -4e5, 7e5]).collect();
    let start = StartStress::new(&stresses);
    for strain in [Strain::Small, Strain::Large] {
        let mut f = vec![[0.0; 3]; u.len()];
        forces(Width::detect(), &groups, &law(), strain, &start, &u, &mut f);
        for node in [0, 5, 9, 14] {
            for axis in 0..3 {
                let step = 1e-8;
                let at = |d: f64| {
                    let mut v = u.clone();
                    v[node][axis] += d;
                    groups.energy(&law(), strain, &start, &v)
                };
                let slope = (at(step) - at(-step)) / (2.0 * step);
                let error = (slope + f[node][axis]).abs() / largest(&f);
                assert!(error < 1e-8, "{strain:?} {node} {axis}: {error:e}");
            }
        }
    }
}

#[test]
fn a_turned_block_has_no_large_strain_and_balanced_moments() {
    let mesh = stone(2, 15);
    let groups = Groups::new(&mesh);
    let turn = crate::geom::Quat::from_scaled_axis(Vec3::new(1.0, -2.0, 0.5));
    let rigid = field(&mesh, |x| turn * x - x + Vec3::new(4.0, 5.0, 6.0));
    let stretched = field(&mesh, |x| 1.001 * x - x);
    let f = run(&groups, Strain::Large, &rigid, Width::detect());
    let scale = largest(&run(&groups, Strain::Large, &stretched, Width::detect()));
    assert!(largest(&f) < 1e-11 * scale, "{}", largest(&f) / scale);
    assert!(largest(&run(&groups, Strain::Small, &rigid, Width::detect())) > 100.0 * scale);
    // Objectivity: forces turn with the block.
    let noise = random(&mesh, 0.02, 4);
    let both: Vec<[f64; 3]> = mesh
        .nodes
        .iter()
        .zip(&noise)
        .map(|(x, d)| (turn * (*x + Vec3::from_array(*d)) - *x).to_array())
        .collect();
    let still = run(&groups, Strain::Large, &noise, Width::detect());
    let turned = run(&groups, Strain::Large, &both, Width::detect());
    let expected: Vec<[f64; 3]> =
        still.iter().map(|f| (turn * Vec3::from_array(*f)).to_array()).collect();
    assert!(apart(&turned, &expected) < 1e-11);
    let (mut sum, mut moment) = (Vec3::ZERO, Vec3::ZERO);
    for ((x, u), f) in mesh.nodes.iter().zip(&both).zip(&turned) {
        sum += Vec3::from_array(*f);
        moment += (*x + Vec3::from_array(*u)).cross(Vec3::from_array(*f));
    }
    assert!(sum.length() < 1e-12 * largest(&turned));
    assert!(moment.length() < 1e-11 * largest(&turned), "{moment}");
}

/// A free cube that turns three times: size, energy and angular momentum, as the acceptance numbers have it.
#[test]
fn a_spinning_cube_keeps_its_size_and_angular_momentum() {
    let mesh = Tetrahedra::new(&Polyhedron::brick(Vec3::ZERO, Vec3::splat(0.015))).unwrap();
    let groups = Groups::new(&mesh);
    let law = Elastic::new(1e9, 0.25);
    let density = 2650.0;
    let masses: Vec<f64> = mesh.inertial().iter().map(|v| density * v).collect();
    let omega = Vec3::new(300.0, 200.0, 500.0);
    let dt = 0.2 * 0.03 / law.p_speed(density);
    let steps = (3.0 * std::f64::consts::TAU / omega.length() / dt) as usize;
    let mut u = vec![Vec3::ZERO; 15];
    let mut v: Vec<Vec3> = mesh.nodes.iter().map(|x| omega.cross(*x)).collect();
    let spin = |u: &[Vec3], v: &[Vec3]| -> Vec3 {
        (0..15).map(|k| (mesh.nodes[k] + u[k]).cross(masses[k] * v[k])).sum()
    };
    let before = spin(&u, &v);
    for _ in 0..steps {
        let flat: Vec<[f64; 3]> = u.iter().map(Vec3::to_array).collect();
        let mut f = vec![[0.0; 3]; 15];
        let none = StartStress::default();
        forces(Width::detect(), &groups, &law, Strain::Large, &none, &flat, &mut f);
        for k in 0..15 {
            v[k] += dt / masses[k] * Vec3::from_array(f[k]);
            u[k] += dt * v[k];
        }
    }
    let drift = spin(&u, &v).distance(before) / before.length();
    assert!(drift < 1e-12, "{drift:e}");
    let edge = (mesh.nodes[7] + u[7]).distance(mesh.nodes[0] + u[0]);
    let change = edge / mesh.nodes[7].distance(mesh.nodes[0]) - 1.0;
    assert!(change.abs() < 1e-3, "{change:e}");
}

#[test]
fn row_sums_bound_the_frequency_of_a_block() {
    let h = 0.03;
    let mesh = Tetrahedra::new(&Polyhedron::brick(Vec3::ZERO, Vec3::splat(0.5 * h))).unwrap();
    let density = 2400.0;
    let sums = row_sums(&mesh, &law());
    let worst = sums
        .iter()
        .zip(mesh.lumped())
        .map(|(sum, volume)| sum / (density * volume))
        .fold(0.0, f64::max);
    let bound = 2.0 / worst.sqrt();
    // True largest frequency by power iteration.
    let matrix = Stiffness::new(&mesh, &law());
    let mut u = random(&mesh, 1.0, 3);
    let mut square = 0.0;
    for _ in 0..500 {
        let mut f = vec![[0.0; 3]; u.len()];
        matrix.forces(Width::detect(), &u, &mut f);
        for (f, m) in f.iter_mut().zip(mesh.lumped()) {
            *f = f.map(|x| -x / (density * m));
        }
        let norm = |u: &[[f64; 3]]| u.as_flattened().iter().map(|x| x * x).sum::<f64>().sqrt();
        square = norm(&f) / norm(&u);
        let scale = 1.0 / norm(&f);
        u = f.iter().map(|f| f.map(|x| x * scale)).collect();
    }
    let speed = (ROCK.0 / density).sqrt();
    let exact = 2.0 / square.sqrt() * speed / h;
    // 0.3456 is the measured value of a free cube with lumped mass.
    assert!((exact / 0.3456 - 1.0).abs() < 0.02, "{exact}");
    assert!(bound * speed / h <= exact);
}
