//! Steps in batches with nothing read between, and a table of the energies after each: what a coupled program would do.
//!
//! `cargo run --release -p riprap --example batches -- scenes/planar/topple.toml`

use std::path::PathBuf;

use riprap::prelude::*;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let path = std::env::args_os()
        .nth(1)
        .map_or_else(|| PathBuf::from("scenes/planar/topple.toml"), PathBuf::from);
    let scene = Scene::load(&path, &[])?;
    let mut simulation = scene.prepare(&scene.plain())?.simulation(Exec::new(2)?)?;
    println!("step,time_s,kinetic,residual_relative");
    for _ in 0..20 {
        let reached = simulation.advance(500)?;
        let balance = simulation.view().balance();
        println!(
            "{},{:.6},{:.6e},{:.2e}",
            simulation.steps(),
            simulation.time(),
            balance.kinetic,
            balance.residual_relative()
        );
        if reached == Reached::End {
            break;
        }
    }
    Ok(())
}
