//! Stress at the start in the plane.

use super::{CUBE, FLOOR, bad, good};
use crate::planar::setup::LoadKind;

const BOND: &str = "[interfaces.default.bond]\ntension = \"0 Pa\"\ncohesion = \"0 Pa\"\n";

fn sides(words: &[&str]) -> String {
    let side = |word: &&str| format!("[[boundaries]]\non.plane = \"{word}\"\nin_situ = true\n");
    words.iter().map(side).collect()
}

/// A cube and the rock around it.
fn scene(stress: &str) -> String {
    let all = sides(&["x-min", "x-max", "y-min", "y-max"]);
    format!("{BOND}{CUBE}{stress}{all}")
}

#[test]
fn the_rock_outside_presses_on_the_sides() {
    let model = good(&scene(
        "[in_situ.tension_positive]\nstress = [\"-3 MPa\", \"-1 MPa\", \"2 MPa\"]\n\
         gradient = [\"-1 MPa/m\", \"0 Pa/m\", \"0 Pa/m\"]\n",
    ));
    let setup = model.setup.planar().unwrap();
    let stress = setup.in_situ.unwrap();
    assert_eq!(stress.stress, [-3e6, -1e6, 0.0, 0.0, 0.0, 2e6]);
    assert_eq!(stress.datum, 1.0);
    let tractions: Vec<[[f64; 2]; 2]> = setup
        .loads
        .iter()
        .map(|load| match &load.kind {
            LoadKind::Edge { traction, .. } => traction.map(Into::into),
            _ => panic!("{load:?}"),
        })
        .collect();
    // Left from the top down, right upwards, below to the right, above to the left.
    assert_eq!(
        tractions,
        [
            [[3e6, -2e6], [4e6, -2e6]],
            [[-4e6, 2e6], [-3e6, 2e6]],
            [[-2e6, 1e6], [-2e6, 1e6]],
            [[2e6, -1e6], [2e6, -1e6]],
        ]
    );
}

#[test]
fn weight_and_a_share_of_it_sideways() {
    let model = good(&scene("[in_situ.gravity_k0]\nk0 = 0.5\n"));
    let setup = model.setup.planar().unwrap();
    let (stress, density) = (setup.in_situ.unwrap(), setup.blocks[0].density);
    let weight = density * setup.gravity[1];
    assert_eq!(stress.gradient, [0.5 * weight, weight, 0.0, 0.0, 0.0, 0.0]);
    assert!(model.warnings.is_empty(), "{:?}", model.warnings);
}

#[test]
fn what_cannot_carry_stress_is_refused() {
    let stress = "[in_situ.compressive]\nx = \"2 MPa\"\n";
    // No joints.
    let bare = scene(stress).replace(BOND, "");
    assert!(bad(&bare).contains("interfaces.default has no joints to carry"));
    // Nobody on the right.
    let open = format!("{BOND}{CUBE}{stress}{}", sides(&["x-min"]));
    let found = bad(&open);
    assert!(
        found.contains("on side x-max is not balanced by any boundary: 2.000000e6 Pa"),
        "{found}"
    );
    assert!(found.contains("in_situ = true, or fixed blocks there"), "{found}");
    // Words of space.
    assert!(bad(&scene(stress).replace("y-max", "z-max")).contains("is a side of the model"));
    let held = scene(stress).replacen("in_situ = true", "held = {}", 1);
    assert!(bad(&held).contains("`held` is a key of [space.spatial]"));
    assert!(
        bad(&scene(&stress.replace("x =", "azimuth = \"3 deg\"\nx ="))).contains("use `angle`")
    );
    let six = "[in_situ.tension_positive]\nstress = [\"1 Pa\", \"1 Pa\", \"1 Pa\", \"1 Pa\", \"1 Pa\", \"1 Pa\"]\n";
    assert!(bad(&scene(six)).contains("a list of 3 is expected in [space.planar]"));
}

#[test]
fn a_ramp_needs_something_to_remove_and_time() {
    let text = |phase: &str| {
        format!("{CUBE}{FLOOR}[[phases]]\nname = \"dig\"\nremoval_ramp = \"1 s\"\n{phase}\n")
    };
    let model = good(&text("until = { time = \"1 s\" }"));
    let codes: Vec<&str> = model.warnings.iter().map(|w| w.code).collect();
    assert_eq!(codes, ["key.unused"]);
    let model = good(&text("remove = [\"cube\"]\nuntil = { time = \"1 s\" }"));
    assert_eq!(model.plan.phases[0].removal_ramp, Some(1.0));
    let short = text("remove = [\"cube\"]\nuntil = { time = \"0.5 s\" }");
    assert!(bad(&short).contains("phase `dig` ends before its `removal_ramp`"));
}
