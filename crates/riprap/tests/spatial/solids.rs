//! Convex polyhedra: the same answers as bricks, whole models turned in space, wedges.

use riprap::spatial::setup::{
    Boundary, BoundaryKind, FaceSet, InSitu, Kinematics, Setup, Shape, Solid,
};
use riprap::{Vec3, geom};

use crate::spatial::rock::{CP, Draws, Run, elastic, lattice, rock, strength};

type Quat = geom::Quat;

/// Bricks as polyhedra, turned about the origin.
fn turned(setup: Setup, q: Quat) -> Setup {
    let mut setup = setup;
    for block in &mut setup.blocks {
        let Shape::Brick { centre, half } = block.shape else {
            continue;
        };
        let body = geom::polyhedron::Polyhedron::brick(centre, half);
        block.shape = Shape::Polyhedron(Box::new(Solid {
            vertices: body.vertices.iter().map(|v| q * *v).collect(),
            faces: body.faces,
        }));
        block.velocity = q * block.velocity;
        block.spin = q * block.spin;
    }
    setup
}

fn shaken() -> Setup {
    let law = riprap::spatial::setup::JointLaw {
        strength: Some(strength(0.05e6, 30.0, 0.02e6)),
        damping: 0.1,
        contact_damping: 0.1,
        ..elastic()
    };
    let mut setup = rock(lattice([4, 3, 3], 1.0), law);
    let mut draws = Draws::new(2);
    for block in &mut setup.blocks {
        block.velocity = 0.02 * draws.vector();
        block.spin = 0.02 * draws.vector();
    }
    setup
}

#[test]
fn polyhedra_move_as_the_bricks_they_are() {
    let dt = 0.2 / CP;
    for kinematics in [Kinematics::Small, Kinematics::Finite] {
        let setup = Setup { kinematics, ..shaken() };
        let mut bricks = Run::new(setup.clone());
        bricks.steps(200, dt);
        assert!(bricks.world.works.friction + bricks.world.works.fracture > 0.0);
        for q in [Quat::IDENTITY, Quat::from_axis_angle(Vec3::new(1.0, 2.0, -0.5).normalize(), 0.7)]
        {
            let mut solids = Run::new(turned(setup.clone(), q));
            assert_eq!(solids.world.patches.len(), bricks.world.patches.len());
            solids.steps(200, dt);
            let mut worst = 0.0f64;
            for b in 0..solids.world.alive.len() {
                let u = solids.world.bodies.displacement(b);
                let expected = q * bricks.world.bodies.displacement(b);
                worst = worst.max((u - expected).length() / expected.length());
            }
            println!("{kinematics:?}, turned {:.1}: {worst:.1e}", q.w);
            assert!(worst < 1e-8, "{worst:e}");
        }
    }
}

/// A cube cut by its diagonal plane into two wedges on a base of four cubes.
fn wedges() -> Setup {
    let mut setup = rock(lattice([2, 2, 1], 1.0), elastic());
    let v = |x: f64, y: f64, z: f64| Vec3::new(x, y, z);
    let lower = vec![
        v(0.0, 0.0, 1.0),
        v(2.0, 0.0, 1.0),
        v(2.0, 2.0, 1.0),
        v(0.0, 2.0, 1.0),
        v(0.0, 0.0, 3.0),
        v(0.0, 2.0, 3.0),
    ];
    let upper = vec![
        v(2.0, 0.0, 1.0),
        v(2.0, 2.0, 1.0),
        v(2.0, 0.0, 3.0),
        v(2.0, 2.0, 3.0),
        v(0.0, 0.0, 3.0),
        v(0.0, 2.0, 3.0),
    ];
    let faces = [
        vec![vec![0, 3, 2, 1], vec![0, 1, 4], vec![3, 5, 2], vec![0, 4, 5, 3], vec![1, 2, 5, 4]],
        vec![vec![0, 2, 4], vec![1, 5, 3], vec![0, 1, 3, 2], vec![2, 3, 5, 4], vec![0, 4, 5, 1]],
    ];
    for (vertices, faces) in [lower, upper].into_iter().zip(faces) {
        let mut block = setup.blocks[0].clone();
        block.shape = Shape::Polyhedron(Box::new(Solid { vertices, faces }));
        setup.blocks.push(block);
    }
    setup
}

#[test]
fn in_situ_stress_balances_wedges_with_gravity() {
    let weight = 2400.0 * 9.81;
    let mut setup = wedges();
    setup.gravity = Vec3::new(0.0, 0.0, -9.81);
    setup.in_situ = Some(InSitu {
        stress: [0.0; 6],
        gradient: [-0.4 * weight, -0.7 * weight, -weight, 0.0, 0.0, 0.0],
        datum: 3.0,
    });
    let side = |name: &str, normal: Vec3, offset: f64| Boundary {
        name: name.into(),
        on: FaceSet::Plane { normal, offset },
        kind: BoundaryKind::Held { normal: true, shear: true },
        in_situ: true,
    };
    setup.boundaries = vec![
        side("west", -Vec3::X, 0.0),
        side("east", Vec3::X, 2.0),
        side("south", -Vec3::Y, 0.0),
        side("north", Vec3::Y, 2.0),
        side("base", -Vec3::Z, 0.0),
    ];
    let mut run = Run::new(setup);
    let volume: f64 = (0..6).map(|b| run.world.solid_of(b).volume).sum();
    assert!((volume - 12.0).abs() < 1e-12);
    // Four among the cubes, four under the wedge that stands on them, one between the wedges.
    assert_eq!(run.world.patches.len(), 9);
    run.evaluate(0.0);
    println!("unbalanced {:.1e}", run.view().unbalanced());
    // Lengths of patches are rounded to 6e-11 of the finest half edge.
    assert!(run.view().unbalanced() < 1e-11);
    run.steps(1000, 2e-5);
    for b in 0..6 {
        assert!(run.world.bodies.displacement(b).length() < 1e-15);
    }
}
