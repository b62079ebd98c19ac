//! A joint law of one's own, in Rust: a hyperbolic spring along the joints of a stone, beside the friction that the scene gives.
//!
//!     tau = k u / (1 + u/u0)
//!
//! A law is asked once a step for all contacts of a group. What it gives is the traction on the first block of each; the second gets the opposite at the same
//! point, and its work is a line of the ledger. Under a constant pull P from rest the stone stops first where the work of the pull is the energy of
//! the joint of area A,
//!
//!     P u = A k u0 (u - u0 ln(1 + u/u0)).
//!
//! `cargo run --release -p riprap --example own_joint_law`

use riprap::prelude::*;

const SCENE: &str = r#"
riprap = 1
title = "a stone on a joint of one's own"
[space.planar]
gravity = ["0 m/s2", "-10 m/s2"]
[materials.rock]
density = "2500 kg/m3"
[interfaces.default]
normal_stiffness = "1 GPa/m"
friction_angle = "0 deg"
[[blocks]]
name = "floor"
material = "rock"
rectangle = { size = ["9 m", "1 m"], corner = ["-4 m", "-1 m"] }
[[blocks]]
name = "stone"
material = "rock"
rectangle = { size = ["2 m", "0.5 m"], corner = ["0 m", "0 m"] }
[[supports]]
on.block = "floor"
fixed = {}
[[phases]]
name = "pull"
time_step = "0.1 ms"
until = { time = "2 s" }
"#;

/// Traction (Pa) and energy per area (J/m²) at a displacement (m).
#[derive(Clone, Copy, Debug)]
struct Hyperbola {
    stiffness: f64,
    scale: f64,
}

impl Hyperbola {
    fn traction(&self, u: f64) -> f64 {
        self.stiffness * u / (1.0 + u.abs() / self.scale)
    }

    fn energy(&self, u: f64) -> f64 {
        self.stiffness * self.scale * (u - self.scale * libm::log1p(u / self.scale))
    }
}

impl ContactLaw for Hyperbola {
    fn tractions(&mut self, contacts: &mut Contacts) -> Result<Vec<[f64; 3]>, String> {
        let pairs = contacts.displacement.iter().zip(&contacts.normal);
        Ok(pairs
            .map(|(u, n)| {
                let across: f64 = u.iter().zip(n).map(|(u, n)| u * n).sum();
                let along = [0, 1, 2].map(|k| u[k] - across * n[k]);
                let way = along.iter().map(|u| u * u).sum::<f64>().sqrt();
                let per_way = if way > 0.0 { self.traction(way) / way } else { 0.0 };
                // The second block is drawn back by what the first one is drawn along.
                along.map(|u| per_way * u)
            })
            .collect())
    }
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let law = Hyperbola { stiffness: 5e5, scale: 0.01 };
    let (pull, area) = (4e3, 2.0);
    let mut simulation = Simulation::from_toml(SCENE)?;
    simulation.contact_law("hyperbola", &["stone", "floor"], Box::new(law))?;
    simulation.set_force("stone", [pull, 0.0, 0.0], [0.0; 3])?;
    let mut most: f64 = 0.0;
    loop {
        let moved = simulation.field("block.displacement.x", &["stone"])?;
        if moved < most {
            break;
        }
        most = moved;
        simulation.advance(1)?;
    }
    let (work, stored) = (pull * most, area * law.energy(most));
    let booked = simulation.field("load.work", &["law hyperbola"])?;
    println!(
        "it stops at {:.4} mm: work {work:.3} J/m, energy {stored:.3} J/m, booked {booked:.3} J/m",
        1e3 * most
    );
    assert!((work - stored).abs() < 5e-3 * work, "{work} {stored}");
    assert!((booked + stored).abs() < 5e-3 * stored, "{booked} {stored}");
    let cost = &simulation.law_costs()[0];
    println!("the law was asked {} times and took {:.1e} s", cost.calls, cost.seconds);
    Ok(())
}

#[cfg(test)]
mod tests {
    #[test]
    fn the_stone_stops_where_the_energy_says() {
        super::main().unwrap();
    }
}
