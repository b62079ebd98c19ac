//! Velocities that are given and jump where the step changes: no energy comes from it. Each block stands alone: springs beside it
//! would have the leapfrog's own error where the step changes.

use riprap::exec::Exec;
use riprap::run::scene::Scene;
use riprap::run::simulation::{Simulation, Stage};
use riprap::scenario::Source;

/// Two phases with steps of 10 and 40 us; the velocity jumps between them.
const PHASES: &str = r#"
[[phases]]
name = "slow"
time_step = "10 us"
until = { time = "1 ms" }
[[phases]]
name = "fast"
time_step = "40 us"
until = { time = "3 ms" }
"#;

const PLANE: &str = r#"
riprap = 1
title = "a driven block in the plane"
[space.planar]
gravity = ["0 m/s2", "0 m/s2"]
[materials.rock]
density = "2500 kg/m3"
[interfaces.default]
normal_stiffness = "1 GPa/m"
friction_angle = "30 deg"
[interfaces.default.bond]
normal_stiffness = "10 GPa/m"
tension = "1 GPa"
cohesion = "1 GPa"
[[blocks]]
name = "block"
material = "rock"
rectangle = { size = ["1 m", "1 m"], corner = ["0 m", "0 m"] }
[[supports]]
on = { block = "block" }
motion.velocity = { x = { formula = "if(t < 1e-3, 1, -2)" }, spin = { formula = "if(t < 1e-3, 0, 0.5)" } }
"#;

const SPACE: &str = r#"
riprap = 1
title = "a driven block in space"
[space.spatial]
gravity = "0 m/s2"
[materials.rock]
density = "2500 kg/m3"
young = "1 GPa"
poisson = 0.25
[interfaces.default]
cohesion = "1 GPa"
tension = "1 GPa"
friction_angle = "30 deg"
[interfaces.default.brittle_bond]
thickness = "1 mm"
elastic = true
[[blocks]]
name = "block"
material = "rock"
grid.box = { size = ["1 m", "1 m", "1 m"], cell = "1 m" }
MECHANICS
[[supports]]
on = { block = "block.1" }
motion.velocity = { x = { formula = "if(t < 1e-3, 1, -2)" }, SPIN }
"#;

/// Largest residual of the ledger over the kinetic energy, and how often it was read.
fn residual(text: &str) -> (f64, usize) {
    let source = Source { name: "scene.toml".to_owned(), text: format!("{text}{PHASES}") };
    let scene = Scene::parse(source, ".".into(), &[]).unwrap_or_else(|wrong| panic!("{wrong}"));
    let job = scene
        .prepare(&scene.case("default").unwrap())
        .unwrap_or_else(|wrong| panic!("{wrong}"))
        .job();
    let mut simulation = Simulation::new(job.setup, job.plan, Exec::serial()).unwrap();
    let (mut largest, mut count) = (0.0_f64, 0);
    loop {
        match simulation.prepare().unwrap() {
            Stage::Within => {
                let balance = simulation.view().balance();
                if count > 0 {
                    largest = largest.max((balance.residual() / balance.kinetic).abs());
                }
                count += 1;
                simulation.step();
            }
            Stage::PhaseEnd => simulation.next_phase(),
            Stage::Done => return (largest, count),
        }
    }
}

#[test]
fn no_energy_comes_from_a_given_velocity_that_jumps_where_the_step_changes() {
    let rigid = SPACE
        .replace("MECHANICS", "")
        .replace("SPIN", "spin_x = { formula = \"if(t < 1e-3, 0, 0.5)\" }");
    let nodes = SPACE
        .replace("MECHANICS", "mechanics.deformable = {}")
        .replace("SPIN", "y = { formula = \"if(t < 1e-3, 0, 0.5)\" }");
    for text in [PLANE, &rigid, &nodes] {
        let (residual, count) = residual(text);
        assert!(count > 140, "{count}");
        assert!(residual < 1e-9, "{residual:e}: {text}");
    }
}
