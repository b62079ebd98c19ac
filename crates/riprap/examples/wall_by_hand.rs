//! A model of the plane built without a scene file: a wall of bricks settles, then its key is taken out.
//!
//! `cargo run --release -p riprap --example wall_by_hand`

use riprap::planar::setup::{
    BlockSpec, ContactLaw, FrictionLaw, Interface, Motion, NormalLaw, Reflex, Setup, Support,
};
use riprap::prelude::*;

/// A rectangle of rock with corners (m) `from` and `to`.
fn block(name: &str, from: [f64; 2], to: [f64; 2]) -> BlockSpec {
    let corners = [from, [to[0], from[1]], to, [from[0], to[1]]];
    BlockSpec {
        name: name.to_owned(),
        vertices: corners.map(Vec2::from).to_vec(),
        material: 0,
        density: 2500.0,
        velocity: Vec2::ZERO,
        spin: 0.0,
    }
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut blocks = vec![block("floor", [-1.0, -1.0], [6.0, 0.0])];
    for row in 0..4 {
        for column in 0..5 {
            let shift = if row % 2 == 0 { 0.0 } else { 0.5 };
            let (x, y) = (f64::from(column) + shift, 0.5 * f64::from(row));
            blocks.push(block(&format!("brick.{row}.{column}"), [x, y], [x + 1.0, y + 0.5]));
        }
    }
    let setup = Setup {
        gravity: [0.0, -9.81],
        materials: vec!["rock".to_owned()],
        blocks,
        interfaces: vec![Interface {
            name: "default".to_owned(),
            contact: ContactLaw {
                normal: NormalLaw::DistancePotential,
                reflex: Reflex::Min,
                normal_stiffness: 1e9,
                shear_stiffness: 1e9,
                friction: 0.6,
                cohesion: 0.0,
                friction_law: FrictionLaw::ShearSpring,
                clip_speed: 0.0,
                damping_ratio: 0.2,
            },
            bond: None,
        }],
        pair_table: vec![0],
        supports: vec![Support {
            blocks: vec![0],
            motion: Motion::Fixed { x: true, y: true, rotation: true },
        }],
        ..Setup::default()
    };
    let take_out = Phase {
        // The second brick of the lowest row: numbers count from the floor, 0.
        remove: vec![2],
        zero_displacements: true,
        ..Phase::dynamic("take out", 0.3)
    };
    let plan = Plan { phases: vec![Phase::settle("settle", 1e-4), take_out], ..Plan::default() };
    let mut simulation = Simulation::new(setup, plan, Exec::new(2)?)?;
    simulation.run()?;
    for name in ["brick.1.0", "brick.1.1", "brick.3.1"] {
        let down = simulation.field("block.displacement.y", &[name])?;
        println!("{name} has moved {down:+.5} m");
    }
    println!("steps: {}", simulation.steps());
    Ok(())
}
