//! What is told before a run, of small scenes.

use super::ahead::{Ahead, Known, ahead};
use super::trial::Mark;
use super::{Forecast, forecast, within};
use crate::exec::Exec;
use crate::plan::Phase;
use crate::run::cpu::Work;
use crate::run::scene::Scene;
use crate::run::simulation::Simulation;
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

/// Ten bricks of four sizes that fall into each other above a floor.
const HEAP: &str = "riprap = 1\ntitle = \"t\"\nspace.spatial.gravity = \"9.81 m/s2\"\n\
    [materials.rock]\ndensity = \"2500 kg/m3\"\nyoung = \"20 GPa\"\npoisson = 0.25\n\
    [interfaces.default]\nnormal_stiffness = \"1 GPa/m\"\nfriction_angle = \"35 deg\"\nrestitution = 0.2\n\
    [[blocks]]\nname = \"floor\"\nmaterial = \"rock\"\nbrick = { size = [\"9 m\", \"9 m\", \"1 m\"], corner = [\"-4 m\", \"-4 m\", \"-1 m\"] }\n\
    [[blocks]]\nname = \"a\"\nmaterial = \"rock\"\nbrick = { size = [\"1 m\", \"0.8 m\", \"0.6 m\"], corner = [\"0 m\", \"0 m\", \"0.1 m\"] }\n\
    copies = { count = 5, step = [\"0.21 m\", \"0.13 m\", \"0.8 m\"] }\n\
    [[blocks]]\nname = \"b\"\nmaterial = \"rock\"\nbrick = { size = [\"0.7 m\", \"0.7 m\", \"0.7 m\"], corner = [\"-0.9 m\", \"0.2 m\", \"0.1 m\"] }\n\
    copies = { count = 5, step = [\"0.05 m\", \"0.11 m\", \"0.9 m\"] }\n\
    [[supports]]\non.block = \"floor\"\nfixed = {}\n[[phases]]\nname = \"fall\"\nuntil.time = \"3 s\"\n";

/// Blocks that fall and come to rest, a wall that is hit and one that is shaken: by less than a tenth of the run.
#[test]
fn a_forecast_of_loose_blocks_is_right_within_a_factor_of_two() {
    let template = |file: &str| {
        let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenes/");
        std::fs::read_to_string(format!("{path}{file}.toml")).unwrap()
    };
    for text in [HEAP.to_owned(), template("planar/wall"), template("spatial/shaken_wall")] {
        let scene = Scene::parse(Source::new("t.toml", text), ".".into(), &[]).unwrap();
        let job = scene.prepare(&scene.plain()).unwrap().job();
        let work = Work::begin();
        let mut run = Simulation::new(job.setup.clone(), job.plan.clone(), Exec::serial()).unwrap();
        run.run().unwrap();
        let took = work.done();
        let told = within(&job.setup, &job.plan, took / 12).unwrap().reckoned.unwrap();
        let title = &scene.parsed.scenario.title;
        let steps = told.steps as f64 / run.steps() as f64;
        assert!(steps > 0.5 && steps < 2.0, "{title}: {steps}, {told:?}");
        // The share of a core that the run and the trial had differs on a busy machine.
        let time = told.cpu_time / took.as_secs_f64();
        assert!(time > 0.4 && time < 2.5, "{title}: {time}, {told:?}, {took:?}");
    }
}

fn phases(more: &str) -> Vec<Phase> {
    let text = HEAP.replace("until.time = \"3 s\"", more);
    let scene = Scene::parse(Source::new("t.toml", text), ".".into(), &[]).unwrap();
    scene.prepare(&scene.plain()).unwrap().job().plan.phases
}

fn mark(cpu: f64, steps: u64, share: f64, unbalanced: f64, contacts: usize) -> Mark {
    let time = steps as f64 * 1e-4;
    Mark { cpu, steps, time, phase: 0, share: Some(share), unbalanced: Some(unbalanced), contacts }
}

#[test]
fn the_rest_is_reckoned_from_the_later_half_of_the_trial() {
    let job = {
        let scene = Scene::parse(Source::new("t.toml", HEAP.to_owned()), ".".into(), &[]).unwrap();
        scene.prepare(&scene.plain()).unwrap().job()
    };
    let reckon = |phases: Vec<Phase>, marks: &[Mark], falling| {
        let plan = crate::plan::Plan { phases, ..job.plan.clone() };
        let known = Known { falling, contacts: 1e-4, rest: Some(0.5) };
        ahead(&plan, marks, &|_| 1e-3, known)
    };
    // A tenth of the phase took 100 cheap steps, the second tenth 400 dear ones.
    let marks =
        [mark(0.0, 0, 0.0, 1.0, 0), mark(1.0, 100, 0.1, 1.0, 0), mark(2.0, 500, 0.2, 1.0, 5)];
    let close = |found: Option<Ahead>, steps: f64, cpu: f64| {
        let found = found.unwrap();
        assert!((found.steps / steps - 1.0).abs() < 1e-9, "{found:?}");
        assert!((found.cpu / cpu - 1.0).abs() < 1e-9, "{found:?}");
    };
    close(reckon(phases("until.time = \"3 s\""), &marks, 0), 3200.0, 8.0);
    // Contacts shorten the steps of the next phase: 1e-4 s.
    let two = "until.time = \"3 s\"\n[[phases]]\nname = \"more\"\nuntil.time = \"0.1 s\"\n";
    close(reckon(phases(two), &marks, 0), 4200.0, 8.0 + 1000.0 * 1.0 / 400.0);
    // Ten blocks at rest touch three times as often as five contacts do.
    let cheap =
        [mark(0.0, 0, 0.0, 1.0, 0), mark(1.0, 1000, 0.1, 1.0, 0), mark(2.0, 1400, 0.2, 1.0, 5)];
    let rests = (1e-3 + 1.5e-3 * 3.0) / 2.5e-3;
    close(reckon(phases("until.time = \"3 s\""), &cheap, 10), 3200.0, 8.0 * rests);
    // The force falls by 10 in 400 steps, and has to fall by 100 more.
    let falls =
        [mark(0.0, 0, 0.0, 1.0, 9), mark(1.0, 100, 0.01, 0.1, 9), mark(2.0, 500, 0.02, 0.01, 9)];
    let still = "kind = \"static\"\nuntil = { unbalanced = 1e-4, steps = 50000 }\n";
    close(reckon(phases(still), &falls, 0), 800.0, 2.0);
    // Where it does not fall, the count of steps is the end.
    let stays = falls.map(|mark| Mark { unbalanced: Some(1.0), ..mark });
    close(reckon(phases(still), &stays, 0), 400.0 * 98.0, 98.0);
    assert!(reckon(phases(still), &stays, 0).unwrap().at_most);
    assert!(!reckon(phases(still), &falls, 0).unwrap().at_most);
    // What goes on until it rests is taken to rest after 0.5 s: 0.45 s of steps of 0.1 ms, and a phase to come after 500 steps of 1 ms.
    let throw = "until = { rest = {}, time = \"3 s\" }\n";
    let early = marks.map(|mark| Mark { share: Some(mark.time / 3.0), ..mark });
    close(reckon(phases(throw), &early, 0), 4500.0, 4500.0 / 400.0);
    assert!(!reckon(phases(throw), &early, 0).unwrap().at_most);
    // Where its time ends before, that is the end.
    close(reckon(phases(throw), &marks, 0), 3200.0, 8.0);
    let two = "until.time = \"3 s\"\n[[phases]]\nname = \"more\"\nuntil = { rest = {}, time = \"3 s\" }\n";
    close(reckon(phases(two), &marks, 0), 3200.0 + 5000.0, 8.0 + 5000.0 / 400.0);
    // A trial without time says nothing.
    assert_eq!(reckon(phases(still), &stays[..1], 0), None);
}
