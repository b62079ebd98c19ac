//! No allocation in a steady step in space: settled piles of found contacts.

use std::path::Path;

use riprap::exec::Exec;
use riprap::run::scene::Scene;
use riprap::run::simulation::{Simulation, Stage};
use riprap_testkit::Counting;

fn run(simulation: &mut Simulation, steps: u64) {
    for _ in 0..steps {
        assert_eq!(simulation.prepare().unwrap(), Stage::Within);
        simulation.step();
    }
}

/// Pairs that touch, and those that could.
fn pairs(simulation: &Simulation) -> [usize; 2] {
    let view = simulation.view();
    let found = &view.spatial().unwrap().world.found;
    let touching = found.pairs.iter().filter(|pair| pair.depth > 0.0);
    [touching.count(), found.pairs.len()]
}

/// A dry wall in running bond, and two drums of 20 faces on each other, more than vector registers have room for; all of them a hundredth of a
/// millimetre apart, so that no joint is built.
fn wall() -> String {
    let mut text = r#"
riprap = 1
title = "Settled bricks and drums"

[space.spatial]
gravity = "9.81 m/s2"

[materials.rock]
density = "2400 kg/m3"
young = "20 GPa"
poisson = 0.25

[interfaces.default]
normal_stiffness = "2 GPa/m"
friction_coefficient = 0.6
damping_ratio = 0.2

[[blocks]]
name = "floor"
material = "rock"
brick = { size = ["20 m", "20 m", "1 m"], corner = ["-10 m", "-10 m", "-1 m"] }

[[supports]]
on = { block = "floor" }
fixed = {}

[[phases]]
name = "settle"
until = { time = "10 s" }
damping = { mass = "20 1/s" }
"#
    .to_owned();
    for course in 0..6 {
        let (x, z) = (0.25 * f64::from(course % 2), 1e-5 + 0.20001 * f64::from(course));
        text += &format!(
            r#"
[[blocks]]
name = "course{course}"
material = "rock"
brick = {{ size = ["0.5 m", "0.25 m", "0.2 m"], corner = ["{x} m", "0 m", "{z} m"] }}
copies = {{ count = 12, step = ["0.50001 m", "0 m", "0 m"] }}
"#
        );
    }
    for drum in 0..2 {
        let low = 1e-5 + 0.30001 * f64::from(drum);
        let corners = (0..36).map(|k| {
            let angle = f64::from(k / 2) * std::f64::consts::TAU / 18.0 + 0.1 * f64::from(drum);
            let (x, y) = (0.4 * angle.cos(), 0.4 * angle.sin() - 3.0);
            format!(r#"["{x} m", "{y} m", "{} m"]"#, low + 0.3 * f64::from(k % 2))
        });
        let corners: Vec<String> = corners.collect();
        text += &format!(
            "\n[[blocks]]\nname = \"drum{drum}\"\nmaterial = \"rock\"\npolyhedron.vertices = [{}]\n",
            corners.join(", ")
        );
    }
    text
}

#[test]
fn a_steady_step_allocates_nothing() {
    let mut simulation = Simulation::from_toml(&wall()).unwrap();
    run(&mut simulation, 2000);
    let [touching, all] = pairs(&simulation);
    // Twelve bricks on the floor; each of the five other courses is shifted by half a brick: 2 x 12 - 1; two drums.
    assert_eq!(touching, 12 + 5 * 23 + 2, "of {all}");
    let before = Counting::allocations_here();
    run(&mut simulation, 200);
    assert_eq!(Counting::allocations_here() - before, 0);
}

/// Bricks on joints without strength, which are looked at for whether they give way.
#[test]
fn a_steady_step_of_joined_bricks_allocates_nothing() {
    let bricks = r#"
[[blocks]]
name = "bricks"
material = "rock"
grid.box = { size = ["2 m", "2 m", "3 m"], cell = "0.5 m", corner = ["0 m", "2 m", "0 m"] }
"#;
    let mut simulation = Simulation::from_toml(&(wall() + bricks)).unwrap();
    run(&mut simulation, 2000);
    let patches = |simulation: &Simulation| {
        let view = simulation.view();
        view.spatial().unwrap().world.patches.len()
    };
    let joints = patches(&simulation);
    assert!(joints > 200, "{joints}");
    let before = Counting::allocations_here();
    run(&mut simulation, 200);
    assert_eq!(Counting::allocations_here() - before, 0);
    assert_eq!(patches(&simulation), joints);
}

/// A table, a brick of halves and an L of glued parts, and a whole brick, at rest on terrain.
#[test]
fn a_steady_step_of_glued_parts_on_terrain_allocates_nothing() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../../scenes/verify/spatial-contact/glued_terrain.toml");
    let scene = Scene::load(&path, &[]).unwrap();
    let prepared = scene.prepare(&scene.plain()).unwrap();
    let mut simulation = prepared.simulation(Exec::serial()).unwrap();
    // The L has stopped at 0.15 s.
    while simulation.time() < 0.4 {
        run(&mut simulation, 1);
    }
    let before = Counting::allocations_here();
    run(&mut simulation, 200);
    assert_eq!(Counting::allocations_here() - before, 0);
}
