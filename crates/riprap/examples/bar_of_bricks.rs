//! A model in space built without a scene file: a wave runs along a bar of bricks. Prints its speed beside the one of the rock.
//!
//! `cargo run --release -p riprap --example bar_of_bricks`

use riprap::prelude::*;
use riprap::spatial::setup::{
    BlockName, BlockSpec, InterfaceLaw, JointLaw, Material, Points, Setup, Shape,
};

const BRICKS: u32 = 200;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let rock = Material {
        name: "rock".to_owned(),
        density: 2400.0,
        young: Some(18e9),
        poisson: Some(0.0),
    };
    let speed = (18e9_f64 / rock.density).sqrt();
    let blocks = (0..BRICKS)
        .map(|k| BlockSpec {
            name: BlockName { base: 0, number: k + 1 },
            shape: Shape::Brick {
                centre: Vec3::new(f64::from(k) + 0.5, 0.5, 0.5),
                half: Vec3::splat(0.5),
            },
            material: 0,
            // The first bricks fly into the rest.
            velocity: if k < 10 { Vec3::new(0.1, 0.0, 0.0) } else { Vec3::ZERO },
            spin: Vec3::ZERO,
        })
        .collect();
    let setup = Setup {
        materials: vec![rock],
        names: vec!["brick".to_owned()],
        blocks,
        interfaces: vec![InterfaceLaw {
            name: "joint".to_owned(),
            bond: None,
            friction: None,
            joint: JointLaw { points: Points::Quarter, ..JointLaw::default() },
        }],
        pair_table: vec![0],
        ..Setup::default()
    };
    let dynamic =
        Phase { time_step: TimeStep::Auto { safety: 0.5 }, ..Phase::dynamic("wave", 0.06) };
    let plan = Plan { phases: vec![dynamic], ..Plan::default() };
    let mut simulation = Simulation::new(setup, plan, Exec::serial())?;
    let mut arrivals = Vec::new();
    for (brick, at) in [("brick.60", 59.5), ("brick.160", 159.5)] {
        loop {
            simulation.advance(1)?;
            if simulation.field("block.velocity.x", &[brick])? > 0.025 {
                break;
            }
        }
        arrivals.push((at, simulation.time()));
    }
    let measured = (arrivals[1].0 - arrivals[0].0) / (arrivals[1].1 - arrivals[0].1);
    println!("wave speed {measured:.0} m/s, of the rock {speed:.0} m/s");
    Ok(())
}
