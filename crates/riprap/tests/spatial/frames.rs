//! Found contact seen from other frames: turned, far away, from a train. Catalogue entry H8 for blocks that meet.

use riprap::spatial::setup::{
    InterfaceLaw, Motion, Setup, Shape, Solid, Stiffness, StiffnessRule, Support,
};
use riprap::{Vec3, geom};

use crate::spatial::rock::{Run, brick, elastic, rock, strength};

type Quat = geom::Quat;

/// Steps of the impact, and of the heap, whose many edges and corners make the most of round-off.
const STEPS: [usize; 2] = [1500, 7500];
const DT: f64 = 4e-5;

fn meeting(blocks: Vec<riprap::spatial::setup::BlockSpec>, friction_angle: f64) -> Setup {
    let mut setup = rock(blocks, elastic());
    let law: &mut InterfaceLaw = &mut setup.interfaces[0];
    law.joint.strength = Some(strength(0.0, friction_angle, 0.0));
    law.joint.contact_damping = 0.2;
    law.joint.stiffness = match law.joint.stiffness {
        Stiffness::Rule(StiffnessRule::Material) => Stiffness::Given { normal: 1e9, shear: 5e8 },
        given => given,
    };
    setup.found_contacts = true;
    setup.supports = vec![Support { blocks: vec![0], motion: still(Vec3::ZERO) }];
    setup.gravity = Vec3::new(0.0, 0.0, -9.81);
    setup
}

fn still(velocity: Vec3) -> Motion {
    Motion::Velocity {
        translation: velocity.to_array().map(|v| Some(constant(v))),
        spin: [0.0; 3].map(|v| Some(constant(v))),
        about: None,
    }
}

fn constant(value: f64) -> riprap::dynamics::time_function::TimeFunction {
    riprap::dynamics::time_function::TimeFunction::Constant(value)
}

/// B3: a box that falls on its corner with spin, meets the floor at 2 m/s, rubs and rebounds.
fn impact() -> Setup {
    let floor = brick(Vec3::new(0.0, 0.0, -0.5), Vec3::new(3.0, 3.0, 0.5));
    let mut thrown = brick(Vec3::new(0.1, -0.2, 0.62), Vec3::new(0.5, 0.3, 0.2));
    thrown.shape = turned(
        &thrown.shape,
        Quat::from_axis_angle(Vec3::new(0.5, 0.8, 0.2).normalize(), 0.9),
        Vec3::new(0.1, -0.2, 0.62),
    );
    thrown.velocity = Vec3::new(0.4, 0.1, -2.0);
    thrown.spin = Vec3::new(0.5, -1.0, 0.7);
    meeting(vec![floor, thrown], 35.0)
}

/// A wedge between two bricks, and a brick that falls on the three of them.
fn heap() -> Setup {
    let mut blocks = vec![brick(Vec3::new(0.0, 0.0, -0.5), Vec3::new(3.0, 3.0, 0.5))];
    blocks.push(brick(Vec3::new(-0.7, 0.0, 0.3), Vec3::splat(0.3)));
    blocks.push(brick(Vec3::new(0.7, 0.05, 0.3), Vec3::splat(0.3)));
    let wedge = [
        [-0.6, -0.3, 0.95],
        [-0.6, 0.3, 0.95],
        [0.6, 0.3, 0.95],
        [0.6, -0.3, 0.95],
        [0.0, -0.3, 0.25],
        [0.0, 0.3, 0.25],
    ];
    let wedge = geom::polyhedron::hull(&wedge.map(Vec3::from_array)).expect("a wedge");
    let mut between = brick(Vec3::ZERO, Vec3::ONE);
    between.shape =
        Shape::Polyhedron(Box::new(Solid { vertices: wedge.vertices, faces: wedge.faces }));
    between.velocity = Vec3::new(0.0, 0.0, -0.5);
    blocks.push(between);
    let mut last = brick(Vec3::new(0.15, 0.1, 1.2), Vec3::new(0.3, 0.2, 0.2));
    last.velocity = Vec3::new(0.2, 0.0, -1.0);
    last.spin = Vec3::new(0.3, 0.5, 0.1);
    blocks.push(last);
    meeting(blocks, 25.0)
}

/// A shape turned about a point.
fn turned(shape: &Shape, q: Quat, about: Vec3) -> Shape {
    let solid = match shape {
        Shape::Brick { centre, half } => {
            let body = geom::polyhedron::Polyhedron::brick(*centre, *half);
            Solid { vertices: body.vertices, faces: body.faces }
        }
        Shape::Polyhedron(solid) => (**solid).clone(),
        Shape::Terrain(_) | Shape::Glued(_) => panic!("neither terrain nor glued parts are turned"),
    };
    Shape::Polyhedron(Box::new(Solid {
        vertices: (solid.vertices.iter()).map(|v| about + q * (*v - about)).collect(),
        faces: solid.faces,
    }))
}

/// The model seen from elsewhere: turned by `q` about the origin, then shifted (m), then with a speed added to all of it (m/s).
fn seen(mut setup: Setup, q: Quat, shift: Vec3, boost: Vec3) -> Setup {
    for block in &mut setup.blocks {
        block.shape = turned(&block.shape, q, Vec3::ZERO);
        if let Shape::Polyhedron(solid) = &mut block.shape {
            solid.vertices.iter_mut().for_each(|v| *v += shift);
        }
        block.velocity = q * block.velocity + boost;
        block.spin = q * block.spin;
    }
    setup.gravity = q * setup.gravity;
    setup.supports[0].motion = still(boost);
    setup
}

/// Largest difference of the ways and of the velocities of all blocks, over the largest of each.
fn difference(here: &Run, there: &Run, q: Quat, boost: Vec3) -> f64 {
    let way = |run: &Run, b: usize| run.world.bodies.displacement(b);
    let (mine, theirs) = (here.view(), there.view());
    let longest = mine.living().map(|b| way(here, b).length()).fold(0.0, f64::max);
    let fastest = mine.living().map(|b| mine.velocity(b).length()).fold(0.0, f64::max);
    let one = |b: usize| {
        let u = way(there, b) - there.world.time * boost;
        let v = theirs.velocity(b) - boost;
        let in_way = (u - q * way(here, b)).length() / longest;
        in_way.max((v - q * mine.velocity(b)).length() / fastest)
    };
    mine.living().map(one).fold(0.0, f64::max)
}

#[test]
fn blocks_that_meet_move_alike_in_every_frame() {
    let q = Quat::from_axis_angle(Vec3::new(0.3, -0.7, 0.5).normalize(), 2.1);
    let shift = 1e4 * Vec3::new(0.6, -0.8, 0.3);
    let boost = 100.0 * Vec3::new(0.3, 0.5, -0.8);
    let models = [("impact", impact()), ("heap", heap())];
    for ((name, setup), steps) in models.into_iter().zip(STEPS) {
        // Bricks as polyhedra in all frames: they are other classes than bricks.
        let mut here = Run::new(seen(setup.clone(), Quat::IDENTITY, Vec3::ZERO, Vec3::ZERO));
        here.steps(steps, DT);
        let works = &here.world.works;
        assert!(works.friction > 1.0 && works.damping > 1.0, "{name}: nothing meets");
        for (frame, q, shift, boost, bound) in [
            ("turned", q, Vec3::ZERO, Vec3::ZERO, 1e-8),
            ("far", Quat::IDENTITY, shift, Vec3::ZERO, 1e-6),
            ("boosted", Quat::IDENTITY, Vec3::ZERO, boost, 1e-8),
        ] {
            let mut there = Run::new(seen(setup.clone(), q, shift, boost));
            there.steps(steps, DT);
            let worst = difference(&here, &there, q, boost);
            println!("{name}, {frame}: {worst:.1e} ({bound:.0e})");
            assert!(worst < bound, "{name}, {frame}: {worst:e}");
        }
    }
}
