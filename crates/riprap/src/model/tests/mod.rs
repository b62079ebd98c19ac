//! Small scenarios, good and bad, through `build`. Files are in `riprap-scenario/tests/scenarios/bad-model`.

use super::*;
use crate::plan::{Every, PhaseKind, TimeStep};
use crate::plan::{Expected, Window};
use crate::planar::fields::INFOS;
use crate::planar::setup::{LoadKind, Motion, NormalLaw};
use crate::scenario::diagnostic::{Diagnostics, Source};
use crate::scenario::{parse, units};
use riprap_geom::Vec2;
use riprap_geom::polygon::{Aabb, signed_area};

mod checks;
mod foreign;
mod in_situ;
mod integration;
mod interfaces;
mod loose;
mod numbers;
mod regions;
mod restitution;
mod solid;
mod terrain;
mod unused;

/// Begins a scenario in the plane.
const HEAD: &str = r#"
riprap = 1
title = "test"
space.planar.gravity = ["0 m/s2", "-10 m/s2"]
[materials.rock]
density = "2000 kg/m3"
young = "10 GPa"
poisson = 0.25
[interfaces.default]
friction_angle = "45 deg"
"#;

/// Begins a scenario in space.
const SPACE: &str = r#"
riprap = 1
title = "test"
space.spatial.gravity = "10 m/s2"
[materials.rock]
density = "2000 kg/m3"
young = "18 GPa"
poisson = 0.25
[interfaces.default]
friction_angle = "45 deg"
"#;

const TAIL: &str = r#"
[[phases]]
name = "go"
until = { time = "1 s" }
"#;

fn text(middle: &str) -> String {
    format!("{HEAD}{middle}{TAIL}")
}

fn try_build(middle: &str) -> Result<Model, Diagnostics> {
    build(&parse(Source::new("t.toml", text(middle)))?, "default", INFOS)
}

fn good(middle: &str) -> Model {
    try_build(middle).unwrap_or_else(|error| panic!("{error}"))
}

/// The errors, one line each: message and help.
fn bad(middle: &str) -> String {
    try_build(middle).expect_err("should be refused").render()
}

const FLOOR: &str = r#"
[[blocks]]
name = "floor"
material = "rock"
rectangle = { size = ["10 m", "1 m"], corner = ["-5 m", "-1 m"] }
[[supports]]
on = { block = "floor" }
fixed = {}
"#;

const CUBE: &str = r#"
[[blocks]]
name = "cube"
material = "rock"
rectangle = { size = ["1 m", "1 m"], corner = ["0 m", "0 m"] }
"#;

#[test]
fn a_cube_on_a_floor_in_numbers() {
    let model = good(&format!("{CUBE}{FLOOR}"));
    let [cube, floor] = &model.setup.planar().unwrap().blocks[..] else { panic!() };
    assert_eq!((cube.name.as_str(), floor.name.as_str()), ("cube", "floor"));
    assert_eq!(signed_area(&floor.vertices), 10.0);
    assert_eq!(model.setup.planar().unwrap().pair_table, [0]);
    let law = model.setup.planar().unwrap().interfaces[0].contact;
    // E = 10 GPa, nu = 0.25: K + 4G/3 = 12 GPa; L is the cube's, since the floor is fixed.
    assert!((law.normal_stiffness / 120e9 - 1.0).abs() < 1e-12, "{law:?}");
    assert_eq!(law.shear_stiffness, 0.5 * law.normal_stiffness);
    assert!((law.friction - 1.0).abs() < 1e-15);
    assert_eq!((law.normal, law.damping_ratio), (NormalLaw::DistancePotential, 0.2));
    let why =
        model.explained.iter().find(|e| e.key == "interfaces.default.normal_stiffness").unwrap();
    assert_eq!((why.from, why.value.as_str()), (Provenance::Derived, "1.200000e11 Pa/m"));
    assert!(matches!(
        &model.setup.planar().unwrap().supports[0].motion,
        Motion::Fixed { x: true, y: true, rotation: true }
    ));
    let phase = &model.plan.phases[0];
    assert_eq!((phase.kind, phase.until.time), (PhaseKind::Dynamic, Some(1.0)));
    assert_eq!(phase.time_step, TimeStep::Auto { safety: 0.2 });
    assert_eq!((model.summary.blocks, model.summary.supported), (2, 1));
    assert_eq!(model.summary.mass, 22_000.0);
    assert!(model.warnings.is_empty(), "{:?}", model.warnings);
}

#[test]
fn every_unit_of_the_field_table_is_a_unit() {
    for info in INFOS {
        assert!(units::dimension(info.unit).is_ok(), "{} {}", info.name, info.unit);
    }
}

#[test]
fn shapes_are_turned_shifted_and_copied() {
    let model = good(
        r#"
[[blocks]]
name = "row"
material = "rock"
groups = ["all"]
rectangle = { size = ["2 m", "1 m"], centre = ["0 m", "0 m"] }
rotate = { angle = "90 deg" }
shift = ["10 m", "0 m"]
copies = { count = 3, step = ["2 m", "0 m"] }
velocity = ["1 m/s", "0 m/s"]
[[blocks]]
name = "hexagon"
material = "rock"
groups = ["all"]
regular = { sides = 6, radius = "1 m", centre = ["0 m", "0 m"] }
"#,
    );
    let names: Vec<&str> =
        model.setup.planar().unwrap().blocks.iter().map(|b| b.name.as_str()).collect();
    assert_eq!(names, ["row.1", "row.2", "row.3", "hexagon"]);
    let bounds = Aabb::of(&model.setup.planar().unwrap().blocks[2].vertices);
    assert!(bounds.min.distance(Vec2::new(13.5, -1.0)) < 1e-14, "{bounds:?}");
    let groups: Vec<(&str, &[u32])> = model
        .setup
        .planar()
        .unwrap()
        .groups
        .iter()
        .map(|g| (g.name.as_str(), &g.blocks[..]))
        .collect();
    assert_eq!(groups, [("all", &[0, 1, 2, 3][..]), ("row", &[0, 1, 2])]);
    assert_eq!(model.setup.planar().unwrap().blocks[1].velocity, Vec2::X);
}

#[test]
fn generators_fill_their_regions() {
    let model = good(
        r#"
[[blocks]]
name = "cut"
material = "rock"
[blocks.cut]
region = [["0 m","0 m"],["10 m","0 m"],["10 m","5 m"],["0 m","5 m"]]
joint_sets = [{ dip = "0 deg", spacing = "1 m" }, { dip = "90 deg", spacing = "1 m" }]
[[blocks]]
name = "cells"
material = "rock"
voronoi = { region = [["20 m","0 m"],["25 m","0 m"],["25 m","5 m"],["20 m","5 m"]], cell_size = "1 m" }
[[blocks]]
name = "wall"
material = "rock"
wall = { corner = ["30 m","0 m"], block = ["0.4 m","0.2 m"], courses = 2, per_course = 3 }
[[blocks]]
name = "arch"
material = "rock"
arch = { centre = ["60 m","0 m"], radius = "10 m", thickness = "1 m", half_angle = "90 deg", voussoirs = 15 }
[[blocks]]
name = "grains"
material = "rock"
pour = { region = [["100 m","0 m"],["110 m","10 m"]], count = 100, size = ["0.2 m","0.4 m"] }
"#,
    );
    let counts: Vec<(&str, usize)> = model
        .setup
        .planar()
        .unwrap()
        .groups
        .iter()
        .map(|g| (g.name.as_str(), g.blocks.len()))
        .collect();
    assert_eq!(counts, [("arch", 15), ("cells", 25), ("cut", 50), ("grains", 100), ("wall", 6)]);
    assert_eq!(model.summary.regions.len(), 2);
    let again = model.clone();
    assert_eq!(model.setup.planar().unwrap(), again.setup.planar().unwrap());
    assert!(model.summary.deepest_overlap.is_none_or(|(d, _)| d < 1e-12));
}

#[test]
fn clockwise_far_and_repeated_corners_are_accepted_with_a_note() {
    let far = |x: &str, y: &str| {
        format!(
            r#"
[[blocks]]
name = "a"
material = "rock"
polygon.points = [["{x}0 m","{y}0 m"],["{x}0 m","{y}0 m"],["{x}0 m","{y}2 m"],["{x}2 m","{y}2 m"],["{x}2 m","{y}0 m"]]
[[loads]]
on = {{ block = "a" }}
point = {{ force = ["1 N/m","0 N/m"], at = ["{x}1 m","{y}1 m"] }}
"#
        )
    };
    let near = good(&far("", ""));
    assert_eq!(near.warnings.len(), 2, "{:?}", near.warnings);
    assert_eq!(near.setup.planar().unwrap().origin, [0.0, 0.0]);
    let model = good(&far("50000", "520000"));
    assert_eq!(model.warnings.len(), 3, "{:?}", model.warnings);
    let [x, y] = model.setup.planar().unwrap().origin;
    assert!((x - 500_000.0).abs() < 3.0 && (y - 5_200_000.0).abs() < 3.0);
    // The same block and load to the last bit, in coordinates of its own.
    let shift = Vec2::new(x - 500_000.0, y - 5_200_000.0);
    for (p, q) in model.setup.planar().unwrap().blocks[0]
        .vertices
        .iter()
        .zip(&near.setup.planar().unwrap().blocks[0].vertices)
    {
        assert_eq!(*p + shift, *q);
    }
    let LoadKind::Point { at: Some(at), .. } = model.setup.planar().unwrap().loads[0].kind else {
        panic!()
    };
    assert_eq!(at + shift, Vec2::ONE);
    assert_eq!(model.summary.bounds[0], [500_000.0, 5_200_000.0]);
}

#[test]
fn overlaps_are_errors_unless_excused() {
    let two = |x: &str, gravity: &str| {
        let text = text(&format!(
            r#"{CUBE}
[[blocks]]
name = "other"
material = "rock"
rectangle = {{ size = ["1 m", "1 m"], corner = ["{x} m", "0 m"] }}
"#
        ));
        text.replace("-10 m/s2", gravity)
    };
    let run = |text: String| {
        let parsed = parse(Source::new("t", text)).unwrap();
        build(&parsed, "default", INFOS)
    };
    assert!(run(two("1", "-10 m/s2")).is_ok());
    assert!(run(two("0.9999999", "0 m/s2")).is_ok());
    let text = run(two("0.9", "-10 m/s2")).unwrap_err().render();
    assert!(text.contains("`cube` and `other` overlap by 0.1 m"), "{text}");
    assert!(
        text.contains("kind = \"static\"") && text.contains("t.toml:") | text.contains("t:"),
        "{text}"
    );
    // Twins, one exactly on the other.
    assert!(run(two("0", "0 m/s2")).is_err());
    // 1e-5 m: too much without gravity and with stiff contacts, right for soft ones.
    assert!(run(two("0.99999", "0 m/s2")).is_err());
    let soft = "normal_stiffness = \"1 GPa/m\"\nfriction_angle";
    assert!(run(two("0.99999", "-10 m/s2").replace("friction_angle", soft)).is_ok());
    let settle =
        two("0.995", "0 m/s2").replace("name = \"go\"", "name = \"go\"\nkind = \"static\"");
    assert!(run(settle).is_ok());
    let said = two("0.9", "0 m/s2")
        .replace("[materials.rock]", "space.planar.allow_overlap = \"0.2 m\"\n[materials.rock]");
    assert!(run(said).is_ok());
}

#[test]
fn generated_names_are_known() {
    let wall = r#"
[[blocks]]
name = "wall"
material = "rock"
wall = { corner = ["0 m","0 m"], block = ["0.4 m","0.2 m"], courses = 2, per_course = 3 }
[[supports]]
on = { block = "wall.NUMBER" }
fixed = { rotation = false }
"#;
    let model = good(&wall.replace("NUMBER", "6"));
    assert_eq!(model.setup.planar().unwrap().supports[0].blocks, [5]);
    let text = bad(&wall.replace("NUMBER", "7"));
    assert!(text.contains("`wall` has the blocks wall.1 to wall.6"), "{text}");
}

#[test]
fn all_errors_come_at_once() {
    let text = bad(r#"
[[blocks]]
name = "bow"
material = "rock"
polygon.points = [["0 m","0 m"],["2 m","2 m"],["2 m","0 m"],["0 m","2 m"]]
[[blocks]]
name = "line"
material = "rock"
polygon.points = [["0 m","0 m"],["1 m","1 m"],["2 m","2 m"]]
[[blocks]]
name = "file"
material = "rock"
polygon.csv = "nowhere.csv"
[[blocks]]
name = "dust"
material = "rock"
voronoi = { region = [["0 m","0 m"],["1 km","0 m"],["1 km","1 km"],["0 m","1 km"]], cell_size = "1e-12 m" }
"#);
    for part in ["crosses itself", "no area", "nowhere.csv", "1.000e30 Voronoi cells"] {
        assert!(text.contains(part), "no {part:?} in\n{text}");
    }
}

#[test]
fn slivers_and_models_that_cannot_move_are_warned_of() {
    let model = good(
        r#"
[[blocks]]
name = "thin"
material = "rock"
rectangle = { size = ["1 m", "1 mm"], corner = ["0 m", "-2 m"] }
[[blocks]]
name = "wall"
material = "rock"
wall = { corner = ["0 m","0 m"], block = ["0.4 m","0.2 m"], courses = 2, per_course = 3 }
[[supports]]
on = { blocks = ["wall", "thin"] }
fixed = {}
"#,
    );
    let codes: Vec<&str> = model.warnings.iter().map(|w| w.code).collect();
    assert_eq!(codes, ["model.fixed", "geometry.sliver"]);
    assert_eq!(model.summary.slivers[0].block, 0);
    let (edge, name) = &model.summary.shortest_edge;
    assert!((edge / 1e-3 - 1.0).abs() < 1e-9 && name == "thin");
}

#[test]
fn edge_loads_must_lie_on_an_edge() {
    let load = |to: &str| {
        format!(
            "{CUBE}\n[[loads]]\non = {{ block = \"cube\" }}\nedge = {{ from = [\"0 m\", \"0 m\"], \
             to = [\"0 m\", \"{to}\"], pressure = [\"9 kPa\", \"0 Pa\"] }}\n"
        )
    };
    let model = good(&load("0.5 m"));
    assert!(matches!(
        model.setup.planar().unwrap().loads[0].kind,
        LoadKind::Edge { pressure: [9000.0, 0.0], .. }
    ));
    assert!(bad(&load("1.5 m")).contains("do not lie on one edge"));
}

/// Two cubes whose centroids are 2 m apart, as a group, with a prescribed motion.
fn driven_pair(motion: &str) -> String {
    let cube = |name: &str, x: &str| {
        format!(
            "[[blocks]]\nname = \"{name}\"\ngroups = [\"pair\"]\nmaterial = \"rock\"\n\
             rectangle = {{ size = [\"1 m\", \"1 m\"], corner = [\"{x}\", \"0 m\"] }}\n"
        )
    };
    let support = format!("[[supports]]\non.group = \"pair\"\nmotion.{motion}\n");
    format!("{}{}{support}", cube("a", "0 m"), cube("b", "2 m"))
}

#[test]
fn a_spin_turns_a_group_as_one_body() {
    let motion = |text: &str| {
        let model = good(&driven_pair(text));
        model.setup.planar().expect("a plane").supports[0].motion.clone()
    };
    let about = |text: &str| match motion(text) {
        Motion::Velocity { about, x, .. } => (about, x.is_some()),
        Motion::Fixed { .. } | Motion::Acceleration { .. } => panic!("a velocity is expected"),
    };
    let spin = "spin = { constant = \"1 rad/s\" }";
    // About the centroid of the group, held where nothing is given.
    let (point, held) = about(&format!("velocity = {{ {spin} }}"));
    assert!((point.expect("a point") - Vec2::new(1.5, 0.5)).length() < 1e-12 && held);
    let given = about(&format!("velocity = {{ {spin}, about = [\"3 m\", \"0 m\"] }}"));
    assert_eq!(given, (Some(Vec2::new(3.0, 0.0)), true));
    // Each about its own centroid, and what does not turn is as it was.
    assert_eq!(about(&format!("velocity = {{ {spin}, each = true }}")), (None, false));
    let still = "velocity = { spin = { constant = \"0 rad/s\" } }";
    assert_eq!(about(still), (None, false));
}

#[test]
fn how_a_group_turns_is_told_where_it_cannot_be_meant() {
    let acceleration = "acceleration = { spin = { constant = \"1 rad/s2\" } }";
    let told = bad(&driven_pair(acceleration));
    assert!(told.contains("rotates each of these blocks about its own centroid"), "{told}");
    good(&driven_pair("acceleration = { spin = { constant = \"1 rad/s2\" }, each = true }"));
    let both =
        "velocity = { spin = { constant = \"1 rad/s\" }, about = [\"0 m\", \"0 m\"], each = true }";
    let told = bad(&driven_pair(both));
    assert!(told.contains("has `about`, `each`"), "{told}");
    let idle = "velocity = { x = { constant = \"1 m/s\" }, about = [\"0 m\", \"0 m\"] }";
    let model = good(&driven_pair(idle));
    let idle = |w: &Diagnostic| {
        w.message.starts_with("`about` in supports.") && w.message.ends_with("has no effect")
    };
    assert!(model.warnings.iter().any(idle));
}

#[test]
fn blocks_of_one_table_spin_as_one_body_and_copies_do_not() {
    let start = "spin = \"2 rad/s\"\nvelocity = [\"1 m/s\", \"0 m/s\"]\n";
    let velocity = |blocks: &str| {
        let model = good(&format!("{blocks}{start}"));
        model.setup.planar().expect("a plane").blocks[0].velocity
    };
    assert_eq!(velocity(CUBE), Vec2::X);
    let copies = "copies = { count = 2, step = [\"2 m\", \"0 m\"] }\n";
    assert_eq!(velocity(&format!("{CUBE}{copies}")), Vec2::X);
    let wall = "[[blocks]]\nname = \"wall\"\nmaterial = \"rock\"\n\
                wall = { corner = [\"0 m\",\"0 m\"], block = [\"1 m\",\"1 m\"], courses = 1, per_course = 2 }\n";
    // Half a metre to the left of the centroid of both.
    assert!((velocity(wall) - Vec2::new(1.0, -1.0)).length() < 1e-12);
}
