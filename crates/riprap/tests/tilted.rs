//! Random jointed models on a tilting table: explicit and implicit steps agree on the angle at which they fail.
//!
//! A stack of two to five blocks of random sizes, off each other's middle, with joints of random cohesion, tensile strength and friction. Gravity turns until the
//! uppermost block has gone 20 mm. Six of them in ordinary runs; all: `cargo test -p riprap --test main --release -- --ignored tilted --nocapture` prints the table of
//! `docs/src/how-to/integration.md`.

use std::fmt::Write;

use riprap::run::simulation::Simulation;

/// Numbers from 0 to 1, the same on all machines.
struct Dice(u64);

impl Dice {
    fn roll(&mut self) -> f64 {
        // splitmix64
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^= z >> 31;
        (z >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.roll()
    }
}

/// Way of the uppermost block at which a model has failed, m.
const FAILED: f64 = 0.02;
/// Horizontal gravity at the end (m/s²) and the time to get there, s.
const TILT: [f64; 2] = [14.0, 7.0];

/// The model with this number, and how many blocks lie on its table.
fn model(number: u64, integration: &str) -> (String, usize) {
    let mut dice = Dice(number.wrapping_mul(7919) + 1);
    let courses = 2 + (4.0 * dice.roll()) as usize;
    let friction = dice.between(25.0, 45.0);
    let cohesion = if dice.roll() < 0.25 { 0.0 } else { dice.between(500.0, 5000.0) };
    let tension = dice.between(0.0, cohesion);
    let mut blocks = String::new();
    let (mut middle, mut height) = ([0.0, 0.0], 0.0);
    for k in 1..=courses {
        let size = [dice.between(0.3, 0.6), dice.between(0.3, 0.5), dice.between(0.15, 0.4)];
        if k > 1 {
            middle[0] += dice.between(-0.05, 0.05);
            middle[1] += dice.between(-0.03, 0.03);
        }
        let corner = [middle[0] - 0.5 * size[0], middle[1] - 0.5 * size[1], height];
        let list = |of: [f64; 3]| of.map(|x| format!("\"{x:.6} m\"")).join(", ");
        let _ = writeln!(
            blocks,
            "[[blocks]]\nname = \"stone{k}\"\nmaterial = \"rock\"\nbrick = {{ size = [{}], corner = [{}] }}",
            list(size),
            list(corner)
        );
        // As written.
        height = format!("{:.6}", height + format!("{:.6}", size[2]).parse::<f64>().unwrap())
            .parse()
            .unwrap();
    }
    let [tilt, time] = TILT;
    let text = format!(
        r#"
riprap = 1
title = "A jointed stack on a tilting table"
[space.spatial]
gravity = "10 m/s2"
[materials.rock]
density = "2500 kg/m3"
young = "20 GPa"
poisson = 0.25
[interfaces.default]
normal_stiffness = "20 GPa/m"
friction_angle = "{friction:.3} deg"
cohesion = "{cohesion:.1} Pa"
tension = "{tension:.1} Pa"
damping_ratio = 0.5
[[blocks]]
name = "table"
material = "rock"
brick = {{ size = ["6 m", "6 m", "0.5 m"], corner = ["-3 m", "-3 m", "-0.5 m"] }}
{blocks}
[[supports]]
on.block = "table"
fixed = {{}}
[[phases]]
name = "stand"
until.time = "0.1 s"
integration = "{integration}"
[[phases]]
name = "tilt"
until.time = "{time} s"
integration = "{integration}"
gravity = ["{tilt} m/s2", "0 m/s2", "-10 m/s2"]
gravity_ramp = "{time} s"
"#
    );
    (text, courses)
}

/// Tilt at which a model fails, deg.
fn fails_at(number: u64, integration: &str) -> f64 {
    let (text, courses) = model(number, integration);
    let mut simulation = Simulation::from_toml(&text).unwrap();
    let top = [format!("stone{courses}")];
    let [tilt, time] = TILT;
    let mut before = [0.1, 0.0];
    simulation.run_for(0.1).unwrap();
    while simulation.time() < 0.1 + time - 0.01 {
        simulation.run_for(0.005).unwrap();
        let now = [simulation.time(), simulation.field("block.displacement.x", &top).unwrap()];
        if now[1] > FAILED {
            let share = (FAILED - before[1]) / (now[1] - before[1]);
            let at = before[0] + share * (now[0] - before[0]) - 0.1;
            return (at / time * tilt / 10.0).atan().to_degrees();
        }
        before = now;
    }
    panic!("model {number} stands at the end of {integration} steps");
}

/// Largest difference of the angles over the explicit one, and a row for each model.
fn compare(numbers: impl Iterator<Item = u64>) -> (f64, Vec<[f64; 2]>) {
    let mut most: f64 = 0.0;
    let mut rows = Vec::new();
    for number in numbers {
        let [explicit, implicit] = ["explicit", "implicit"].map(|form| fails_at(number, form));
        println!(
            "{number:4} {explicit:8.3} {implicit:8.3} {:+.2} %",
            100.0 * (implicit / explicit - 1.0)
        );
        most = most.max((implicit / explicit - 1.0).abs());
        rows.push([explicit, implicit]);
    }
    (most, rows)
}

#[test]
fn six_random_jointed_stacks_fail_at_the_same_tilt_in_both_forms() {
    let (most, rows) = compare(1..=6);
    assert!(most < 0.02, "{most} {rows:?}");
    // They are not one model.
    assert!(rows.iter().any(|row| (row[0] / rows[0][0] - 1.0).abs() > 0.1), "{rows:?}");
}

#[test]
#[ignore = "some minutes"]
fn nearly_all_of_three_hundred_random_jointed_stacks_fail_at_the_same_tilt_in_both_forms() {
    let (most, rows) = compare(1..=300);
    let beyond = |share: f64| rows.iter().filter(|r| (r[1] / r[0] - 1.0).abs() > share).count();
    println!(
        "most {most:.4}, beyond 0.5, 1, 2 %: {} {} {}",
        beyond(0.005),
        beyond(0.01),
        beyond(0.02)
    );
    // A joint of which two points have failed is a hinge about the others, where they hold. Whether they do hangs on the overshoot of the springs when it breaks,
    // which long steps do not have: one model in twenty tips about such a hinge in one of both forms, and breaks and goes on standing in the other.
    assert!(15 * beyond(0.02) <= rows.len(), "{} of {}", beyond(0.02), rows.len());
}
