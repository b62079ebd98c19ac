//! A joint law of one's own, in Rust: a hyperbolic joint holds a stone that is pulled, and code between steps says its force.
//!
//!     F = k u / (1 + u/u0)
//!
//! Under a constant pull P from rest the stone stops first where the work of the pull is the energy of the joint,
//!
//!     P u = k u0 (u - u0 ln(1 + u/u0)).
//!
//! `cargo run --release -p riprap --example own_joint_law`

use riprap::prelude::*;

const SCENE: &str = r#"
riprap = 1
title = "a stone on a joint of one's own"
[space.planar]
gravity = ["0 m/s2", "0 m/s2"]
[materials.rock]
density = "2500 kg/m3"
[interfaces.default]
normal_stiffness = "1 GPa/m"
friction_angle = "30 deg"
[[blocks]]
name = "stone"
material = "rock"
rectangle = { size = ["1 m", "1 m"], corner = ["0 m", "0 m"] }
[[phases]]
name = "pull"
time_step = "0.1 ms"
until = { time = "2 s" }
"#;

/// The law: force per thickness (N/m) and energy (J/m) at a displacement (m).
struct Hyperbola {
    stiffness: f64,
    scale: f64,
}

impl Hyperbola {
    fn force(&self, u: f64) -> f64 {
        self.stiffness * u / (1.0 + u / self.scale)
    }

    fn energy(&self, u: f64) -> f64 {
        self.stiffness * self.scale * (u - self.scale * libm::log1p(u / self.scale))
    }
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let joint = Hyperbola { stiffness: 1e6, scale: 0.01 };
    let pull = 4e3;
    let mut simulation = Simulation::from_toml(SCENE)?;
    let mut most: f64 = 0.0;
    loop {
        let moved = simulation.field("block.displacement.x", &["stone"])?;
        if moved < most {
            break;
        }
        most = moved;
        simulation.set_force("stone", [pull - joint.force(moved), 0.0, 0.0], [0.0; 3])?;
        simulation.advance(1)?;
    }
    let (work, stored) = (pull * most, joint.energy(most));
    println!("it stops at {:.4} mm: work {work:.3} J/m, energy {stored:.3} J/m", 1e3 * most);
    assert!((work - stored).abs() < 1e-3 * work, "{work} {stored}");
    Ok(())
}
