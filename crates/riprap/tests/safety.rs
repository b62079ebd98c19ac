//! Factors of safety against closed forms.

use std::path::Path;

use riprap::run::safety::{Answer, Mechanism, Rules, SafetyError, State, search};
use riprap::run::scene::Scene;
use riprap::scenario::Source;

fn scene(text: &str) -> Scene {
    let source = Source {
        name: "scene.toml".to_owned(),
        text: text.to_owned(),
    };
    Scene::parse(source, ".".into(), &[]).unwrap()
}

fn safety(scene: &Scene, case: &str, rules: &Rules) -> Result<Answer, SafetyError> {
    let job = scene
        .prepare(&scene.case(case).unwrap())
        .unwrap_or_else(|wrong| panic!("{wrong}"))
        .job();
    search(&job.setup, &job.plan, rules, 1, &|| false, &mut |_| {})
}

/// A stone on a slope of 30 deg with a friction angle of 40 deg: F = tan(40 deg)/tan(30 deg) = 1.45338.
const STONE: &str = r#"
riprap = 1
title = "A stone on a slope"
[space.planar]
gravity = ["0 m/s2", "-9.81 m/s2"]
tilt = "30 deg"
[materials.rock]
density = "2500 kg/m3"
[interfaces.default]
normal_stiffness = "1 GPa/m"
shear_stiffness = "1 GPa/m"
friction_angle = "40 deg"
damping_ratio = 0.2
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

fn agrees(answer: &Answer, wanted: f64, width: f64) {
    let (low, high) = (answer.stable_at.unwrap(), answer.fails_at.unwrap());
    assert!(!answer.undecided, "{answer:?}");
    assert!(high - low <= width, "{low} {high}");
    // The width, and 0.2 % for what the model is not rigid.
    let slack = 2e-3 * wanted;
    assert!(
        low - slack <= wanted && wanted <= high + slack,
        "{low} .. {high}, {wanted}"
    );
}

#[test]
fn a_stone_on_a_slope_whatever_counts_as_moved() {
    let scene = scene(STONE);
    let wanted = libm::tan(40f64.to_radians()) / libm::tan(30f64.to_radians());
    for moved in [2e-3, 4e-3, 2e-2] {
        let rules = Rules {
            width: 0.005,
            moved: Some(moved),
            ..Rules::default()
        };
        let answer = safety(&scene, "default", &rules).unwrap();
        agrees(&answer, wanted, rules.width);
        assert_eq!(answer.mechanism, Some(Mechanism::Sliding));
        assert_eq!(answer.moving.len(), 1);
        assert_eq!(answer.moving[0].0, "stone");
    }
}

#[test]
fn from_the_start_the_same_answer() {
    let rules = Rules {
        width: 0.005,
        from_start: true,
        ..Rules::default()
    };
    let answer = safety(&scene(STONE), "default", &rules).unwrap();
    agrees(
        &answer,
        libm::tan(40f64.to_radians()) / libm::tan(30f64.to_radians()),
        rules.width,
    );
}

#[test]
fn below_one_it_is_found_too() {
    let weak = STONE.replace("\"40 deg\"", "\"20 deg\"");
    let answer = safety(&scene(&weak), "default", &Rules::default()).unwrap();
    agrees(
        &answer,
        libm::tan(20f64.to_radians()) / libm::tan(30f64.to_radians()),
        0.01,
    );
    assert_ne!(answer.trials[0].state, State::Stable);
}

#[test]
fn what_cannot_be_reduced_is_told() {
    let smooth = STONE.replace("friction_angle = \"40 deg\"", "friction_angle = \"0 deg\"");
    let smooth = smooth.replace("tilt = \"30 deg\"", "");
    let wrong = safety(&scene(&smooth), "default", &Rules::default());
    assert!(
        matches!(wrong, Err(SafetyError::NoStrength(_))),
        "{wrong:?}"
    );
    let rules = Rules {
        interfaces: vec!["plane".to_owned()],
        ..Rules::default()
    };
    let wrong = safety(&scene(STONE), "default", &rules)
        .unwrap_err()
        .to_string();
    assert!(
        wrong.contains("`plane`") && wrong.contains("default"),
        "{wrong}"
    );
    let rules = Rules {
        width: 0.0,
        ..Rules::default()
    };
    assert!(matches!(
        safety(&scene(STONE), "default", &rules),
        Err(SafetyError::NotANumber)
    ));
}

/// Plane failure with a tension crack (Hoek and Bray): dry, with cohesion, with water in the crack.
#[test]
fn plane_failure() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../../scenes/verify/planar/g1_plane_failure.toml");
    let scene = Scene::load(&path, &[]).unwrap();
    let rules = Rules {
        width: 0.002,
        ..Rules::default()
    };
    for (case, wanted) in [
        ("default", 1.076_187),
        ("cohesion", 1.205_961),
        ("water", 1.100_313),
    ] {
        let answer = safety(&scene, case, &rules).unwrap();
        agrees(&answer, wanted, rules.width);
    }
}

/// The same with a water table, in the plane and in space.
#[test]
fn plane_failure_under_a_water_table() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes/verify/engineering");
    let rules = Rules {
        width: 0.002,
        ..Rules::default()
    };
    for file in ["water_plane_failure", "water_plane_failure_space"] {
        let scene = Scene::load(&folder.join(file).with_extension("toml"), &[]).unwrap();
        for (case, wanted) in [("default", 1.100_313), ("dry", 1.205_961)] {
            let answer = safety(&scene, case, &rules).unwrap();
            agrees(&answer, wanted, rules.width);
        }
    }
}
