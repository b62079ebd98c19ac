//! Any number in any key: an error or a run, never a panic.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;

use toml::Value;

use crate::exec::Exec;
use crate::run::scene::{Scene, SceneError};
use crate::scenario::Source;

/// What takes the place of a number.
const NUMBERS: [&str; 6] = ["0", "-1", "1e308", "1e-308", "inf", "nan"];

/// Places of all numbers of a document, also of those with a unit.
fn places(value: &Value, at: &mut Vec<String>, found: &mut Vec<Vec<String>>) {
    match value {
        Value::Table(table) => {
            for (key, inner) in table {
                at.push(key.clone());
                places(inner, at, found);
                at.pop();
            }
        }
        Value::Array(items) => {
            for (k, inner) in items.iter().enumerate() {
                at.push(k.to_string());
                places(inner, at, found);
                at.pop();
            }
        }
        Value::Integer(_) | Value::Float(_) => found.push(at.clone()),
        Value::String(text) => {
            let first = text.split(' ').next().unwrap_or_default();
            if first.parse::<f64>().is_ok() {
                found.push(at.clone());
            }
        }
        Value::Boolean(_) | Value::Datetime(_) => {}
    }
}

/// The value at a place.
fn at<'a>(mut value: &'a mut Value, path: &[String]) -> &'a mut Value {
    for word in path {
        value = match value {
            Value::Array(items) => &mut items[word.parse::<usize>().unwrap()],
            other => other.get_mut(word).unwrap(),
        };
    }
    value
}

/// Builds a scene and advances it by two steps.
fn go(text: &str, folder: &Path) -> Result<(), SceneError> {
    let scene = Scene::parse(Source::new("scene", text), folder.to_owned(), &[])?;
    let mut simulation = scene.prepare(&scene.plain())?.simulation(Exec::serial())?;
    simulation.advance(2)?;
    Ok(())
}

/// How many numbers were put in, and where the program panicked.
fn attack(text: &str, folder: &Path) -> (usize, Vec<String>) {
    let document: Value = toml::from_str(text).unwrap();
    go(text, folder).unwrap_or_else(|error| panic!("{error}"));
    let (mut found, mut panics) = (Vec::new(), Vec::new());
    places(&document, &mut Vec::new(), &mut found);
    for path in &found {
        for number in NUMBERS {
            let mut changed = document.clone();
            let value = at(&mut changed, path);
            let with = match &*value {
                Value::String(text) => match text.split_once(' ') {
                    Some((_, unit)) => Value::String(format!("{number} {unit}")),
                    None => Value::String(number.to_owned()),
                },
                Value::Integer(_) => match number.parse::<i64>() {
                    Ok(whole) => Value::Integer(whole),
                    Err(_) => Value::Integer(i64::MAX),
                },
                _ => Value::Float(number.parse().unwrap()),
            };
            *value = with;
            let text = toml::to_string(&changed).unwrap();
            // An error is an answer.
            if catch_unwind(AssertUnwindSafe(|| drop(go(&text, folder)))).is_err() {
                panics.push(format!("{} = {number}", path.join(".")));
            }
        }
    }
    (found.len() * NUMBERS.len(), panics)
}

const PLANAR: &str = r#"
riprap = 1
title = "two stones, pushed and shaken"
[space.planar]
gravity = ["0 m/s2", "-10 m/s2"]
tilt = "1 deg"
allow_overlap = "1 mm"
[materials.rock]
density = "2000 kg/m3"
young = "10 GPa"
poisson = 0.25
[interfaces.default]
normal_stiffness = "1 GPa/m"
shear_stiffness = "0.5 GPa/m"
friction_angle = "30 deg"
cohesion = "0 Pa"
damping_ratio = 0.2
[interfaces.default.bond]
tension = "1 MPa"
cohesion = "2 MPa"
points = 2
[[blocks]]
name = "base"
material = "rock"
rectangle = { size = ["4 m", "1 m"], corner = ["0 m", "0 m"] }
[[blocks]]
name = "stone"
material = "rock"
regular = { sides = 4, radius = "0.7071067811865476 m", centre = ["1 m", "1.5 m"] }
velocity = ["0.1 m/s", "0 m/s"]
spin = "0.1 rad/s"
[[blocks]]
name = "arch"
material = "rock"
arch = { centre = ["10 m", "0 m"], radius = "2 m", thickness = "0.5 m", half_angle = "60 deg", voussoirs = 5 }
[[blocks]]
name = "cells"
material = "rock"
voronoi = { region = [["20 m", "0 m"], ["22 m", "0 m"], ["22 m", "2 m"], ["20 m", "2 m"]], cell_size = "0.7 m", seed = 1, relax = 2 }
[[blocks]]
name = "cut"
material = "rock"
cut = { region = [["30 m", "0 m"], ["32 m", "0 m"], ["32 m", "2 m"], ["30 m", "2 m"]], joint_sets = [{ dip = "20 deg", spacing = "0.8 m", spacing_scatter = "0.1 m", angle_scatter = "1 deg" }] }
[[supports]]
on = { block = "base" }
motion.velocity = { x = { sine = { amplitude = "0.1 m/s", frequency = "2 Hz", phase = "10 deg" } }, y = { ramp = { from = "0 m/s", to = "0.1 m/s", end = "1 s" } } }
[[loads]]
on = { block = "stone" }
point = { force = ["1 kN/m", "0 N/m"], at = ["1 m", "1.5 m"] }
time.triangle = { peak = 1.0, rise = "1 s", fall = "1 s" }
[[phases]]
name = "p"
until = { time = "1 s", steps = 3 }
safety = 0.2
gravity_ramp = "1 ms"
damping = { mass = "1 1/s", stiffness = "1 us", local = 0.1 }
[[checks]]
name = "c"
field = "block.displacement.x"
of = "stone"
over = ["0 s", "1 s"]
reduce = "max"
between = ["-1 m", "1 m"]
"#;

const SPATIAL: &str = r#"
riprap = 1
title = "bricks"
[space.spatial]
gravity = "10 m/s2"
kinematics = "automatic"
rotation_bound = "0.01 rad"
[materials.rock]
density = "2000 kg/m3"
young = "18 GPa"
poisson = 0.25
[interfaces.default]
friction_angle = "30 deg"
cohesion = "1 MPa"
tension = "0.5 MPa"
dilation_angle = "5 deg"
dilation_end = "1 mm"
damping_ratio = 0.1
[[blocks]]
name = "rock"
material = "rock"
grid.box = { size = ["2 m", "2 m", "2 m"], cell = "1 m" }
velocity = ["0 m/s", "0 m/s", "0.1 m/s"]
spin = ["0 rad/s", "0 rad/s", "0.1 rad/s"]
[in_situ.gravity_k0]
k0 = 0.3
[[boundaries]]
on.plane = "z-min"
held = {}
[[boundaries]]
on.plane = "x-min"
viscous = {}
[[boundaries]]
on.plane = "x-max"
pressure = { value = "1 kPa", gradient = "1 kPa/m", datum = "2 m" }
in_situ = true
[[boundaries]]
on.plane = "y-min"
roller = {}
[[boundaries]]
on.plane = "y-max"
in_situ = true
traction = { value = ["0 Pa", "1 kPa", "0 Pa"], time.duvall = { peak = 1.0, decay = "10 1/s", rise = "100 1/s" } }
[[phases]]
name = "p"
until = { time = "1 s", unbalanced = 1e-9 }
safety = 0.5
damping = { mass = "1 1/s", rotation = "1 1/s", stiffness = "1 us", local = 0.1 }
"#;

const DEFORMABLE: &str = r#"
riprap = 1
title = "deformable bricks"
[space.spatial]
gravity = "10 m/s2"
[materials.rock]
density = "2000 kg/m3"
young = "18 GPa"
poisson = 0.25
[interfaces.default.brittle_bond]
thickness = "1 mm"
young = "18 GPa"
poisson = 0.25
tension = "1 MPa"
cohesion = "3 MPa"
friction_angle = "40 deg"
cohesive = { mode_1 = "50 J/m2", mode_2 = "500 J/m2" }
[[blocks]]
name = "rock"
material = "rock"
grid.box = { size = ["2 m", "1 m", "1 m"], cell = "1 m" }
mechanics.deformable = {}
[[boundaries]]
on.plane = "x-min"
held = {}
[[boundaries]]
on.plane = "x-max"
moved.velocity.x = { pulse = { value = "1 mm/s", start = "0 s", end = "1 s" } }
[[phases]]
name = "p"
kind = "static"
until = { time = "1 s", unbalanced = 1e-3 }
load_steps = 2
iterations = 100
cut = { planes = 1, margin_tension = "1 kPa", smallest = "0.1 m", snap = 0.03 }
"#;

#[test]
fn no_number_makes_a_panic() {
    let (mut tried, mut panics) = (0, Vec::new());
    for text in [PLANAR, SPATIAL, DEFORMABLE] {
        let (count, found) = attack(text, Path::new("."));
        tried += count;
        panics.extend(found);
    }
    assert!(tried > 500, "{tried}");
    assert!(panics.is_empty(), "{} of {tried}: {panics:#?}", panics.len());
}
