//! Frequencies, series stiffness and moduli of small assemblies; equilibrium under gravity.

use std::f64::consts::TAU;

use riprap::Vec3;
use riprap::spatial::setup::{
    Boundary, BoundaryKind, FaceSet, InSitu, JointLaw, Motion, Points, Refinement, Region,
    Stiffness, StiffnessRule, Support,
};

use crate::rock::{Run, brick, elastic, lattice, rock};

fn given(normal: f64, shear: f64, points: Points) -> JointLaw {
    JointLaw {
        stiffness: Stiffness::Given { normal, shear },
        points,
        ..elastic()
    }
}

fn fixed(blocks: Vec<u32>) -> Support {
    Support {
        blocks,
        motion: Motion::Fixed {
            translation: [true; 3],
            rotation: [true; 3],
        },
    }
}

/// Frequencies (Hz) in a signal that is a sum of one or two undamped oscillations, by the least-squares recurrence
/// `q(n+2) + q(n-2) = a (q(n+1) + q(n-1)) + b q(n)`, sampled every `stride` steps; the
/// leapfrog's own error is taken back.
fn frequencies(q: &[f64], dt: f64, stride: usize) -> [f64; 2] {
    let q: Vec<f64> = q.iter().copied().step_by(stride).collect();
    let (mut aa, mut ab, mut bb, mut ay, mut by) = (0.0, 0.0, 0.0, 0.0, 0.0);
    for w in q.windows(5) {
        let (a, b, y) = (w[1] + w[3], w[2], w[0] + w[4]);
        aa += a * a;
        ab += a * b;
        bb += b * b;
        ay += a * y;
        by += b * y;
    }
    let det = aa * bb - ab * ab;
    let (a, b) = ((ay * bb - by * ab) / det, (by * aa - ay * ab) / det);
    // 2 cos(2 x) = 2 a cos(x) + b, with c = cos(x): 4 c^2 - 2 a c - (2 + b) = 0.
    let root = (a * a + 4.0 * (2.0 + b)).sqrt();
    [a + root, a - root].map(|c| {
        let turn = (0.25 * c).clamp(-1.0, 1.0).acos() / stride as f64;
        2.0 / dt * (0.5 * turn).sin() / TAU
    })
}

#[test]
fn a_block_on_a_fixed_base_has_its_natural_frequencies() {
    for (points, yaw, sway) in [
        (Points::Quarter, 238.7324, [150.6549, 488.3869]),
        (Points::Gauss, 275.6644, [167.6350, 506.8179]),
    ] {
        let make = || {
            let mut setup = rock(
                vec![
                    brick(Vec3::new(0.0, 0.0, -0.5), Vec3::splat(0.5)),
                    brick(Vec3::new(0.0, 0.0, 0.5), Vec3::splat(0.5)),
                ],
                given(18e9, 7.2e9, points),
            );
            setup.supports.push(fixed(vec![0]));
            Run::new(setup)
        };
        let dt = 1e-5;
        let record = |v: Vec3, w: Vec3, read: &dyn Fn(&Run) -> f64| {
            let mut run = make();
            run.world.bodies.set_velocity(1, v, w);
            let mut q = Vec::new();
            for _ in 0..4000 {
                run.steps(1, dt);
                q.push(read(&run));
            }
            q
        };
        let single = |q: &[f64]| {
            let (mut top, mut bottom) = (0.0, 0.0);
            for w in q.windows(3) {
                top += (w[2] + w[0]) * w[1];
                bottom += w[1] * w[1];
            }
            2.0 / dt * (0.5 * (0.5 * top / bottom).acos()).sin() / TAU
        };
        let heave = single(&record(1e-3 * Vec3::Z, Vec3::ZERO, &|r| {
            r.world.bodies.displacement(1).z
        }));
        let found_yaw = single(&record(Vec3::ZERO, 1e-3 * Vec3::Z, &|r| {
            r.world.bodies.rotation(1).z
        }));
        let q = record(1e-3 * Vec3::X, 1e-3 * Vec3::Y, &|r| {
            r.world.bodies.displacement(1).x
        });
        let mut found_sway = frequencies(&q, dt, 40);
        found_sway.sort_by(f64::total_cmp);
        println!("{points:?}: heave {heave:.4}, yaw {found_yaw:.4}, sway-rock {found_sway:.4?} Hz");
        for (found, expected) in [
            (heave, 435.8638),
            (found_yaw, yaw),
            (found_sway[0], sway[0]),
            (found_sway[1], sway[1]),
        ] {
            assert!((found / expected - 1.0).abs() < 2e-3, "{found} {expected}");
        }
    }
}

fn traction(name: &str, normal: Vec3, offset: f64, traction: Vec3) -> Boundary {
    Boundary {
        name: name.into(),
        on: FaceSet::Plane { normal, offset },
        kind: BoundaryKind::Traction {
            traction,
            pressure: 0.0,
            gradient: 0.0,
            datum: 0.0,
            time: riprap::dynamics::TimeFunction::Constant(1.0),
        },
        in_situ: false,
    }
}

/// Runs with damping until the forces balance.
fn settle(run: &mut Run) {
    let dt = 0.5 * riprap::spatial::stable::stable_step(&run.world, &run.scratch, 0.0).dt;
    run.damping.local = 0.8;
    for _ in 0..400 {
        run.steps(50, dt);
        if run.view().unbalanced() < 1e-14 {
            return;
        }
    }
    println!("unbalanced {:.1e}", run.view().unbalanced());
}

#[test]
fn a_large_block_on_four_small_ones_is_pressed_evenly() {
    let mut blocks = vec![brick(Vec3::new(0.5, 0.5, 1.0), Vec3::splat(0.5))];
    for (x, y) in [(0.25, 0.25), (0.75, 0.25), (0.25, 0.75), (0.75, 0.75)] {
        blocks.push(brick(Vec3::new(x, y, 0.25), Vec3::splat(0.25)));
    }
    let mut setup = rock(blocks, elastic());
    setup.boundaries = vec![
        traction("top", Vec3::Z, 1.5, -1e6 * Vec3::Z),
        Boundary {
            name: "base".into(),
            on: FaceSet::Plane {
                normal: -Vec3::Z,
                offset: 0.0,
            },
            kind: BoundaryKind::Held {
                normal: true,
                shear: true,
            },
            in_situ: false,
        },
    ];
    let mut run = Run::new(setup);
    settle(&mut run);
    let view = run.view();
    for p in 0..run.world.patches.len() {
        let level = view.patch_class(p).frame[0].z == 1.0;
        for t in view.patch_tractions(p) {
            let expected = if level { -1e6 } else { 0.0 };
            assert!((t[0] - expected).abs() < 1e-3, "{t:?}");
            assert!(t[1].abs() + t[2].abs() < 1e-3);
        }
    }
    for b in 0..5 {
        assert!(run.world.bodies.rotation(b).length() < 1e-12);
    }
    let stress = view.stresses()[0];
    assert!((stress.col(2).z + 1e6).abs() < 1e-3, "{stress}");
}

#[test]
fn half_blocks_act_in_series() {
    let mut blocks = Vec::new();
    let mut z = 0.0;
    for edge in [1.0, 1.0, 0.5, 0.5, 1.0] {
        let half = Vec3::new(0.5, 0.5, 0.5 * edge);
        blocks.push(brick(Vec3::new(0.5, 0.5, z + 0.5 * edge), half));
        z += edge;
    }
    let law = JointLaw {
        stiffness: Stiffness::Rule(StiffnessRule::Uniaxial),
        ..elastic()
    };
    let mut setup = rock(blocks, law);
    setup.supports.push(fixed(vec![0]));
    setup.boundaries = vec![traction("top", Vec3::Z, 4.0, -1e6 * Vec3::Z)];
    let mut run = Run::new(setup);
    settle(&mut run);
    let found = -run.world.bodies.displacement(4).z;
    println!("{found:.10e} m");
    assert!((found / (1e6 * 3.0 / 18e9) - 1.0).abs() < 1e-9);
}

#[test]
fn a_lattice_has_the_moduli_of_its_springs() {
    let n = 6;
    let law = given(21.6e9, 7.2e9, Points::Quarter);
    // Uniform compression along z.
    let mut setup = rock(lattice([n; 3], 1.0), law);
    let size = n as f64;
    setup.boundaries = vec![
        traction("top", Vec3::Z, size, -1e6 * Vec3::Z),
        traction("base", -Vec3::Z, 0.0, 1e6 * Vec3::Z),
    ];
    let mut run = Run::new(setup);
    settle(&mut run);
    let at = |run: &Run, b: usize| run.world.bodies.displacement(b);
    let top = n * n * (n - 1);
    let strain = (at(&run, 0).z - at(&run, top).z) / (size - 1.0);
    println!("strain {strain:.6e}");
    assert!((strain / 4.62963e-5 - 1.0).abs() < 5e-3);
    assert!(at(&run, 0).x.abs() < 1e-9);
    // Complementary shear in x and z on four faces.
    let mut setup = rock(lattice([n; 3], 1.0), law);
    setup.boundaries = vec![
        traction("top", Vec3::Z, size, 1e6 * Vec3::X),
        traction("base", -Vec3::Z, 0.0, -1e6 * Vec3::X),
        traction("east", Vec3::X, size, 1e6 * Vec3::Z),
        traction("west", -Vec3::X, 0.0, -1e6 * Vec3::Z),
    ];
    let mut run = Run::new(setup);
    settle(&mut run);
    // Shear strain from the corner blocks: du_x/dz + du_z/dx.
    let gamma =
        (at(&run, top).x - at(&run, 0).x + at(&run, n - 1).z - at(&run, 0).z) / (size - 1.0);
    println!("gamma {gamma:.6e}, G {:.4e}", 1e6 / gamma);
    assert!((gamma / 2.77778e-4 - 1.0).abs() < 5e-3);
}

#[test]
fn gravity_and_in_situ_stress_balance_at_the_start() {
    let g = 9.81;
    let weight = 2400.0 * g;
    let (n, edge) = (8usize, 0.5);
    let size = n as f64 * edge;
    let mut setup = rock(lattice([n; 3], edge), elastic());
    setup.gravity = Vec3::new(0.0, 0.0, -g);
    setup.refinements = vec![Refinement {
        around: Region::Point(Vec3::splat(0.5 * size)),
        levels: 2,
        during: None,
    }];
    let k0 = 1.0 / 3.0;
    setup.in_situ = Some(InSitu {
        stress: [0.0; 6],
        gradient: [-k0 * weight, -k0 * weight, -weight, 0.0, 0.0, 0.0],
        datum: size,
    });
    let side = |name: &str, normal: Vec3, offset: f64, kind: BoundaryKind| Boundary {
        name: name.into(),
        on: FaceSet::Plane { normal, offset },
        kind,
        in_situ: true,
    };
    let viscous = BoundaryKind::Viscous { half_cell: true };
    let held = BoundaryKind::Held {
        normal: true,
        shear: true,
    };
    setup.boundaries = vec![
        side("east", Vec3::X, size, viscous.clone()),
        side("west", -Vec3::X, 0.0, viscous.clone()),
        side("north", Vec3::Y, size, viscous.clone()),
        side("south", -Vec3::Y, 0.0, viscous),
        side("base", -Vec3::Z, 0.0, held),
    ];
    let mut run = Run::new(setup);
    run.evaluate(0.0);
    println!("unbalanced at the start {:.1e}", run.view().unbalanced());
    assert!(run.view().unbalanced() < 1e-12);
    run.steps(2000, 2e-5);
    let far = (0..run.world.alive.len())
        .map(|b| run.world.bodies.displacement(b).length())
        .fold(0.0, f64::max);
    println!("largest displacement {far:.1e} m");
    assert!(far < 1e-12, "{far:e}");
    let stress = run.view().stresses();
    for b in run.view().living() {
        let depth = size - run.world.reference[b].z;
        let s = stress[b];
        assert!((s.col(2).z + weight * depth).abs() < 1e-6 * weight, "{s}");
        assert!((s.col(0).x + k0 * weight * depth).abs() < 1e-6 * weight);
    }
}
