//! The same slope for many friction angles, side by side on all cores: at which does the block stay?
//!
//! `cargo run --release -p riprap --example friction_sweep`

use riprap::prelude::*;

/// A block on a slope of 30 deg.
fn scene(friction_deg: f64) -> String {
    format!(
        r#"
riprap = 1
title = "a block on a slope"
[space.planar]
gravity = ["4.905 m/s2", "-8.495709 m/s2"]
[materials.rock]
density = "2500 kg/m3"
[interfaces.default]
normal_stiffness = "1 GPa/m"
friction_angle = "{friction_deg} deg"
damping_ratio = 0.3
[[blocks]]
name = "slope"
material = "rock"
rectangle = {{ size = ["10 m", "1 m"], corner = ["0 m", "-1 m"] }}
[[blocks]]
name = "block"
material = "rock"
rectangle = {{ size = ["1 m", "0.5 m"], corner = ["1 m", "0 m"] }}
[[supports]]
on = {{ blocks = ["slope"] }}
fixed = {{}}
[[phases]]
name = "slide"
until = {{ time = "0.5 s" }}
"#
    )
}

fn slid(friction_deg: &f64) -> Result<(f64, f64), String> {
    let run = || -> Result<f64, Box<dyn std::error::Error>> {
        let mut simulation = Simulation::from_toml(&scene(*friction_deg))?;
        simulation.run()?;
        Ok(simulation.field("block.displacement.x", &["block"])?)
    };
    run().map(|x| (*friction_deg, x)).map_err(|e| e.to_string())
}

fn main() -> Result<(), String> {
    let angles: Vec<f64> = (0..=8).map(|k| 26.0 + f64::from(k)).collect();
    let cores = std::thread::available_parallelism().map_or(1, std::num::NonZero::get);
    let mut results = Vec::new();
    side_by_side(cores, &angles, slid, |one| results.push(one));
    for one in results {
        let (angle, x) = one?;
        println!("{angle:4.1} deg: slid {x:.4} m in 0.5 s");
    }
    Ok(())
}
