//! Scenes with closed forms, and what is no result.

use std::path::Path;

use super::*;
use crate::scenario::Source;

/// Scenes with the checks whose expected value is a closed form of what is read, and the causes that are numbers of that form. Not taken: shares of
/// time above a threshold that the form has not, fields that are 0 by symmetry alone.
const KNOWN: [(&str, &[&str], &[Cause]); 12] = [
    ("planar/v6_eccentric", &["normal force", "the whole base carries"], &[]),
    ("planar/a3_corner_impact", &["rebound speed", "spin", "kinetic energy comes back"], &[]),
    ("planar/v5_corner_bounce", &["speed comes back", "no spin"], &[]),
    (
        "planar/g6_newmark_sine",
        &["slip during the first cycle", "slip after three cycles", "slip at the end"],
        &[],
    ),
    ("planar/g6_newmark_pulse", &["lag of the block"], &[]),
    (
        "planar/h9_damping",
        &["mass damping: place after 0.95 s", "mass damping brakes the fall"],
        &[Cause::Stiffness, Cause::Damping],
    ),
    ("spatial-contact/restitution", &[], &[Cause::Stiffness, Cause::Damping]),
    ("spatial-contact/gap", &["the floor carries its weight"], &[Cause::Damping]),
    ("spatial-rigid/air_drag", &["speed of the fall", "depth of the fall"], &[]),
    (
        "spatial-rigid/b2_frequencies",
        &["heave, 435.8638 Hz", "yaw, 275.6644 Hz", "sway and rock, low, 167.6350 Hz"],
        &[Cause::Stiffness, Cause::Damping],
    ),
    ("spatial-deformable/bar", &["extension", "stress of an inner block"], &[]),
    (
        "spatial-deformable/c4_column",
        &["stress in the middle of the lowest cube", "the lowest joint carries the column"],
        &[],
    ),
];

fn answer(name: &str, without: &[Cause]) -> Answer {
    let path = format!("{}/../../scenes/verify/{name}.toml", env!("CARGO_MANIFEST_DIR"));
    let scene = Scene::load(Path::new(&path), &[]).map_err(|wrong| wrong.render()).unwrap();
    let rules = Rules { without: without.to_vec(), ..Rules::default() };
    let found = trust(&scene, &scene.plain(), &rules, &Executor::ALONE.on(2), &mut |_| {});
    found.map_err(|wrong| wrong.to_string()).unwrap()
}

/// The promise of the command: of twelve scenes whose answer is known it lies inside the interval in eleven at least.
#[test]
fn the_true_value_lies_inside_the_interval() {
    let mut outside = Vec::new();
    for (name, checks, without) in KNOWN {
        let answer = answer(name, without);
        let of_name = |result: &&Result| checks.is_empty() || checks.contains(&&result.name[..]);
        let known = answer.results.iter().filter(of_name).filter(|of| of.expected.is_some());
        let known: Vec<&Result> = known.collect();
        assert!(known.len() >= checks.len().max(1), "{name}: {}", answer.words());
        // An interval that holds anything is no answer.
        let wide = |of: &&&Result| of.error > 0.2 * of.value.abs() + 1e-6;
        assert!(!known.iter().any(|of| wide(&of)), "{name}: {}", answer.words());
        if let Some(missed) = known.iter().find(|of| of.holds() != Some(true)) {
            outside.push(format!("{name}: {}", missed.words()));
        }
    }
    assert!(outside.len() <= 1, "{}", outside.join("\n"));
}

#[test]
fn an_order_moves_the_value_towards_the_truth() {
    let answer = answer("planar/a3_corner_impact", &[]);
    let spin = answer.results.iter().find(|of| of.name == "spin").unwrap();
    let step = spin.parts.iter().find(|part| part.cause == Cause::Step).unwrap();
    assert!(step.order.is_some_and(|order| order > 1.0), "{spin:?}");
    assert!(spin.advice.starts_with("interfaces.default.normal_stiffness: "), "{spin:?}");
    let share: f64 = Cause::ALL.into_iter().filter_map(|cause| spin.share(cause)).sum();
    assert!((share - 1.0).abs() < 1e-9);
    // The equilibrium of a scene without a static phase is no cause.
    assert!(answer.left_out.iter().any(|(cause, _)| *cause == Cause::Equilibrium));
    let table = String::from_utf8(answer.table().unwrap()).unwrap();
    assert!(table.lines().count() == answer.results.len() + 1, "{table}");
}

/// A column of random cells under its weight, with a result that the seed changes.
const CELLS: &str = r#"
riprap = 1
title = "random cells stand on a floor"
[space.planar]
gravity = ["0 m/s2", "-10 m/s2"]
[materials.rock]
density = "2500 kg/m3"
[interfaces.default]
normal_stiffness = "1 GPa/m"
friction_angle = "40 deg"
[[blocks]]
name = "floor"
material = "rock"
rectangle = { size = ["4 m", "0.5 m"], corner = ["-1.5 m", "-0.5 m"] }
[[blocks]]
name = "rock"
material = "rock"
voronoi = { region = [["0 m", "0 m"], ["1 m", "0 m"], ["1 m", "0.8 m"], ["0 m", "0.8 m"]], cell_size = "0.4 m", seed = 3 }
[[supports]]
on.block = "floor"
fixed = {}
[[phases]]
name = "settle"
kind = "static"
until = { unbalanced = 1e-4, steps = 20000 }
[[outputs]]
history = { name = "sunk", field = "model.max_displacement", every = "phase" }
"#;

fn scene(text: &str) -> Scene {
    Scene::parse(Source::new("cells.toml", text), ".".into(), &[])
        .map_err(|wrong| wrong.render())
        .unwrap()
}

#[test]
fn seeds_and_sizes_of_random_cells_are_varied() {
    let scene = scene(CELLS);
    let run = |threads: usize| {
        let executor = Executor::ALONE.on(threads);
        let answer = trust(&scene, &scene.plain(), &Rules::default(), &executor, &mut |_| {});
        answer.map_err(|wrong| wrong.to_string()).unwrap()
    };
    let answer = run(2);
    let causes: Vec<Cause> = answer.results[0].parts.iter().map(|part| part.cause).collect();
    assert!(causes.contains(&Cause::Seed) && causes.contains(&Cause::Size), "{answer:?}");
    assert_eq!(answer.results[0].name, "sunk at the end");
    assert_eq!(answer.results, run(1).results);
}

#[test]
fn blocks_that_are_named_by_number_keep_their_cells() {
    let numbered = CELLS.replace("on.block = \"floor\"", "on.blocks = [\"floor\", \"rock.2\"]");
    let numbered = scene(&numbered);
    let answer =
        trust(&numbered, &numbered.plain(), &Rules::default(), &Executor::ALONE, &mut |_| {});
    let left_out = answer.map_err(|wrong| wrong.to_string()).unwrap().left_out;
    for cause in [Cause::Size, Cause::Seed] {
        let why = left_out.iter().find(|one| one.0 == cause).map(|one| one.1.as_str());
        assert_eq!(why, Some("the scene names block `rock.2` by its number"));
    }
}

#[test]
fn a_scene_without_results_and_a_budget_of_nothing() {
    let (bare, _) = CELLS.split_once("[[outputs]]").unwrap();
    let scene_of = scene(bare);
    let none =
        trust(&scene_of, &scene_of.plain(), &Rules::default(), &Executor::ALONE, &mut |_| {});
    let told = none.unwrap_err().to_string();
    assert!(told.contains("cells.toml has no named result"), "{told}");
    let cells = scene(CELLS);
    let rules = Rules { budget: 0.0, ..Rules::default() };
    let answer = trust(&cells, &cells.plain(), &rules, &Executor::ALONE, &mut |_| {});
    let answer = answer.map_err(|wrong| wrong.to_string()).unwrap();
    assert_eq!(answer.trials.len(), 1);
    assert!(answer.left_out.iter().any(|(_, why)| why.contains("do not fit into the budget")));
    assert!(Cause::read("sted").is_err_and(|why| why.contains("valid names: step")));
}

/// A stone on a slope: friction angle 40 deg on 30 deg, F = tan 40 / tan 30.
const STONE: &str = r#"
riprap = 1
title = "a stone on a slope"
[space.planar]
gravity = ["0 m/s2", "-9.81 m/s2"]
tilt = "30 deg"
[materials.rock]
density = "2500 kg/m3"
[interfaces.default]
normal_stiffness = "1 GPa/m"
friction_angle = "40 deg"
[[blocks]]
name = "slope"
material = "rock"
rectangle = { size = ["20 m", "1 m"], corner = ["-10 m", "-1 m"] }
[[blocks]]
name = "stone"
material = "rock"
rectangle = { size = ["2 m", "1 m"], corner = ["0 m", "0 m"] }
[[supports]]
on = { block = "slope" }
fixed = {}
[[phases]]
name = "settle"
kind = "static"
until = { unbalanced = 1e-6, steps = 50000 }
"#;

/// A search has the error of its width besides those of its runs, and the closed form lies inside.
#[test]
fn the_answer_of_a_search_has_its_error() {
    use crate::run::study::find::Wanted;
    use crate::run::study::range::Quantity;
    use crate::run::study::safety;
    let scene = Scene::parse(Source::new("stone.toml", STONE), ".".into(), &[]).unwrap();
    let (case, rules) = (scene.plain(), Rules::default());
    let search = safety::Rules::default();
    let ask = |question: Question<'_>| {
        let executor = Executor::ALONE.on(2);
        let answer = trust_in((&scene, &case), question, &rules, &executor, &mut |_| {}).unwrap();
        assert_eq!(answer.results.len(), 1);
        (answer.results[0].clone(), answer)
    };
    let exact = 40f64.to_radians().tan() / 30f64.to_radians().tan();
    let (factor, answer) = ask(Question::Safety { rules: &search, over: None, known: None });
    assert!((factor.value - exact).abs() <= factor.error, "{factor:?}");
    assert!(factor.error < 0.05 && factor.share(Cause::Search).unwrap() > 0.0, "{factor:?}");
    // Its trials relax: with another step they would be the same ones.
    let of_step = |one: &&Trial| one.cause == Some(Cause::Step);
    assert_eq!(answer.trials.iter().filter(of_step).count(), 0, "{:?}", answer.trials);
    let left = answer.left_out.iter().find(|(cause, _)| *cause == Cause::Step);
    assert!(left.is_some_and(|(_, why)| why.contains("all phases are static")), "{left:?}");
    // The limit of a key, and the key for a factor: tan(phi) = 1.2 tan 30.
    let range =
        Quantity::read("interfaces.default.friction_angle", "20 deg..50 deg", Some("0.1 deg"));
    let range = range.unwrap();
    let (limit, _) = ask(Question::Safety { rules: &search, over: Some(&range), known: None });
    assert!((limit.value - 30f64.to_radians()).abs() <= limit.error, "{limit:?}");
    assert_eq!(
        (&limit.unit[..], &limit.name[..]),
        ("rad", "limit of interfaces.default.friction_angle")
    );
    let wanted = Wanted::read("safety = 1.2").unwrap();
    let find = Question::Find { range: &range, wanted: &wanted, rules: &search, known: None };
    let (angle, _) = ask(find);
    let exact = (1.2 * 30f64.to_radians().tan()).atan();
    // Each factor is 0.01 wide, which is a quarter of a degree.
    assert!((angle.value - exact).abs() <= angle.error && angle.error < 0.02, "{angle:?}, {exact}");
    assert!(angle.advice.contains("--width"), "{}", angle.advice);
}
