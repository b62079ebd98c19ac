//! A scene written in the program: two stacked stones, the upper one pushed. Prints how far it slides.
//!
//! `cargo run --release -p riprap --example scene_from_text`

use riprap::prelude::*;

const SCENE: &str = r#"
riprap = 1
title = "a stone slides on another"
[space.planar]
gravity = ["0 m/s2", "-9.81 m/s2"]
[materials.rock]
density = "2500 kg/m3"
[interfaces.default]
normal_stiffness = "1 GPa/m"
friction_angle = "30 deg"
damping_ratio = 0.2
[[blocks]]
name = "base"
material = "rock"
rectangle = { size = ["4 m", "1 m"], corner = ["0 m", "0 m"] }
[[blocks]]
name = "stone"
material = "rock"
rectangle = { size = ["1 m", "1 m"], corner = ["1 m", "1 m"] }
velocity = ["1 m/s", "0 m/s"]
[[supports]]
on = { blocks = ["base"] }
fixed = {}
[[phases]]
name = "slide"
until = { time = "0.5 s" }
"#;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut simulation = Simulation::from_toml(SCENE)?;
    println!("time [s]  moved [m]  speed [m/s]");
    loop {
        let reached = simulation.run_for(0.05)?;
        println!(
            "{:8.3}  {:9.5}  {:11.5}",
            simulation.time(),
            simulation.field("block.displacement.x", &["stone"])?,
            simulation.field("block.velocity.x", &["stone"])?,
        );
        if reached == Reached::End {
            break;
        }
    }
    // v²/(2 g tan(30 deg))
    println!("a rigid slider would stop after {:.5} m", 1.0 / (2.0 * 9.81 * 0.577_350_27));
    Ok(())
}
