//! What is told before a run, of small scenes.

use super::{Forecast, forecast};
use crate::run::scene::Scene;
use crate::scenario::Source;

fn told(text: String) -> Forecast {
    let scene = Scene::parse(Source::new("t.toml", text), ".".into(), &[]).unwrap();
    let job = scene.prepare(&scene.plain()).unwrap().job();
    forecast(&job.setup, &job.plan).unwrap()
}

/// A bar of four bricks, with keys of its blocks, its interface and its phase, and more tables.
fn bar(block: &str, interface: &str, phase: &str, more: &str) -> Vec<String> {
    let text = format!(
        "riprap = 1\ntitle = \"t\"\nspace.spatial.gravity = \"0 m/s2\"\n\
         [materials.rock]\ndensity = \"2500 kg/m3\"\nyoung = \"20 GPa\"\npoisson = 0\n[interfaces.default]\n{interface}\n\
         [[blocks]]\nname = \"bar\"\nmaterial = \"rock\"\ngrid.box = {{ size = [\"4 m\", \"1 m\", \"1 m\"], cell = \"1 m\" }}\n{block}\n\
         {more}[[phases]]\nname = \"run\"\nuntil.time = \"50 ms\"\n{phase}\n"
    );
    told(text).warnings
}

#[test]
fn steps_near_the_limit_are_told_where_bonds_can_break() {
    let soft = "mechanics.deformable = {}";
    let bond = "brittle_bond = { thickness = \"10 mm\", tension = \"8 MPa\", cohesion = \"80 MPa\", friction_angle = \"30 deg\" }";
    let elastic = "brittle_bond = { thickness = \"10 mm\", elastic = true }";
    let tells = |block: &str, bond: &str, phase: &str| {
        let wanted = "the steps of phase `run` are 95 % of the stable step, and bonds can break";
        bar(block, bond, phase, "").iter().any(|s| s.starts_with(wanted))
    };
    assert!(tells(soft, bond, "safety = 0.95"));
    assert!(!tells(soft, bond, "safety = 0.8"));
    assert!(!tells(soft, elastic, "safety = 0.95"));
    assert!(!tells(soft, bond, "safety = 0.95\nbreaking = false"));
    assert!(!tells("", bond, "safety = 0.95"));
}

#[test]
fn a_safety_that_found_contacts_leave_without_effect_is_told() {
    let tells = |more: &str, phase: &str| {
        let text = format!(
            "riprap = 1\ntitle = \"t\"\nspace.spatial.gravity = \"9.81 m/s2\"\n\
             [materials.rock]\ndensity = \"2500 kg/m3\"\nyoung = \"20 GPa\"\npoisson = 0.25\n\
             [interfaces.default]\nnormal_stiffness = \"1 GPa/m\"\nfriction_angle = \"30 deg\"\n\
             [[blocks]]\nname = \"floor\"\nmaterial = \"rock\"\nbrick = {{ size = [\"4 m\", \"4 m\", \"1 m\"], corner = [\"-2 m\", \"-2 m\", \"-1 m\"] }}\n\
             {more}[[supports]]\non.block = \"floor\"\nfixed = {{}}\n\
             [[phases]]\nname = \"run\"\nuntil.time = \"0.5 s\"\n{phase}\n"
        );
        let wanted = "`safety` = 0.8 in phase `run` gives no longer steps than 0.5";
        told(text).warnings.iter().any(|s| s.starts_with(wanted))
    };
    let brick = |z: &str| {
        format!(
            "[[blocks]]\nname = \"b\"\nmaterial = \"rock\"\nbrick = {{ size = [\"1 m\", \"1 m\", \"1 m\"], corner = [\"0 m\", \"0 m\", \"{z}\"] }}\n"
        )
    };
    assert!(tells(&brick("1 mm"), "safety = 0.8"));
    // A smaller one has its effect, a given step its own word, and joints take what they are given.
    assert!(!tells(&brick("1 mm"), "safety = 0.3"));
    assert!(!tells(&brick("1 mm"), ""));
    assert!(!tells(&brick("0 m"), "safety = 0.8"));
}

#[test]
fn a_boundary_that_moves_on_in_a_static_phase_is_told() {
    let tells = |velocity: &str, phase: &str| {
        let more = format!(
            "[[boundaries]]\nname = \"push\"\non.plane = \"x-min\"\nmoved.velocity.x = {velocity}\n"
        );
        let wanted = "the boundary `push` is driven in the static phase `run`";
        let told = bar("", "elastic = true", phase, &more);
        told.iter().any(|s| s.starts_with(wanted))
    };
    let on = "{ constant = \"1 mm/s\" }";
    assert!(tells(on, "kind = \"static\""));
    assert!(!tells(on, ""));
    assert!(!tells("{ constant = \"0 m/s\" }", "kind = \"static\""));
    let ramp = "{ ramp = { from = \"1 mm/s\", to = \"0 m/s\", end = \"1 ms\" } }";
    assert!(!tells(ramp, "kind = \"static\""));
}
