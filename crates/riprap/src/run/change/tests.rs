//! Scripts that change a run.

mod adding;
mod bolts;
mod laws;
mod nodes;
mod own;

use std::path::Path;

use crate::record::folder::Existing;
use crate::run::drive::{Control, DriveError, Ending, Pause};
use crate::run::job::{self, JobError, Live};
use crate::run::scene::Scene;
use crate::scenario::Source;

/// A stone lies on another one on a table; in the second phase all friction is 5 deg.
fn text(space: &str) -> String {
    let head = match space {
        "planar" => "gravity = [\"0 m/s2\", \"-10 m/s2\"]\ntilt = \"20 deg\"",
        _ => "gravity = [\"3.42 m/s2\", \"0 m/s2\", \"-9.397 m/s2\"]",
    };
    let shape = |size: [f64; 2], corner: [f64; 2]| match space {
        "planar" => format!(
            "rectangle = {{ size = [\"{} m\", \"{} m\"], corner = [\"{} m\", \"{} m\"] }}",
            size[0], size[1], corner[0], corner[1]
        ),
        _ => format!(
            "brick = {{ size = [\"{} m\", \"1 m\", \"{} m\"], corner = [\"{} m\", \"0 m\", \"{} m\"] }}",
            size[0], size[1], corner[0], corner[1]
        ),
    };
    let moduli = if space == "planar" { "" } else { "young = \"10 GPa\"\npoisson = 0.25" };
    let shear = if space == "planar" { "" } else { "shear_stiffness = \"0.5 GPa/m\"" };
    format!(
        r#"
riprap = 1
title = "two stones"
[space.{space}]
{head}
[materials.rock]
density = "2500 kg/m3"
{moduli}
[interfaces.default]
normal_stiffness = "1 GPa/m"
{shear}
friction_angle = "35 deg"
damping_ratio = 0.3
[[blocks]]
name = "table"
material = "rock"
{}
[[blocks]]
name = "low"
material = "rock"
{}
[[blocks]]
name = "high"
material = "rock"
{}
[[supports]]
name = "table"
on.block = "table"
fixed = {{}}
[[phases]]
name = "lie"
until = {{ time = "0.4 s" }}
[[phases]]
name = "slide"
until = {{ time = "0.2 s" }}
interfaces.default.damping_ratio = 0.2
[[outputs]]
history = {{ name = "speed", field = "block.speed", of = "low", every = "20 ms" }}
"#,
        shape([12.0, 1.0], [-4.0, -1.0]),
        shape([1.0, 1.0], [0.0, 0.0]),
        shape([1.0, 0.5], [0.0, 1.0]),
    )
}

fn live(text: &str, folder: Option<&Path>) -> Live {
    let scene = Scene::parse(Source::new("two.toml", text), ".".into(), &[]);
    let scene = scene.map_err(|wrong| wrong.render()).unwrap();
    let job = scene.prepare(&scene.plain()).map_err(|wrong| wrong.render()).unwrap().job();
    match folder {
        Some(folder) => Live::begin(job, folder, Existing::Refuse, 1).unwrap(),
        None => Live::unrecorded(job, 1).unwrap(),
    }
}

fn on(live: &mut Live, time: f64) {
    let pause = Pause { time: Some(time), step: None };
    assert_eq!(live.advance(pause, &mut |_| Control::Continue).unwrap(), None);
}

fn speed(live: &Live, block: &str) -> f64 {
    live.simulation().field("block.speed", &[block]).unwrap()
}

fn told(result: Result<(), JobError>) -> String {
    match result.unwrap_err() {
        JobError::Drive(DriveError::Change(wrong)) => wrong.to_string(),
        other => panic!("{other}"),
    }
}

/// All that a script can do.
fn script(live: &mut Live, text_of_laws: &str) {
    on(live, 0.1);
    live.set_force("high", [2000.0, 0.0, 0.0], [0.0; 3]).unwrap();
    on(live, 0.15);
    live.set_force("high", [0.0; 3], [0.0; 3]).unwrap();
    live.set_velocity("high", Some([0.1, 0.0, 0.0]), None).unwrap();
    on(live, 0.2);
    live.change("remove = [\"high\"]").unwrap();
    on(live, 0.25);
    live.change(text_of_laws).unwrap();
    on(live, 0.3);
}

const LAWS: &str =
    "interfaces.default.friction_angle = \"5 deg\"\ndamping = { mass = \"0.1 1/s\" }";

#[test]
fn the_same_script_gives_the_same_bits_and_a_restart_too() {
    for space in ["planar", "spatial"] {
        let folder = tempfile::tempdir().unwrap();
        let end = |mut live: Live| {
            live.advance(Pause::NEVER, &mut |_| Control::Continue).unwrap();
            assert_eq!(live.ending(), Some(&Ending::Finished), "{space}");
            live.simulation().engine().hash()
        };
        let mut first = live(&text(space), None);
        script(&mut first, LAWS);
        let whole = end(first);
        let path = folder.path().join(space);
        let mut second = live(&text(space), Some(&path));
        script(&mut second, LAWS);
        // Closed at the pause after the last change, and gone on with.
        second.close().unwrap();
        let again = job::resume(&path, 1, &mut |_| Control::Continue).unwrap();
        assert_eq!(again.manifest.state_hash, whole, "{space}");
        let events = std::fs::read_to_string(path.join("events.jsonl")).unwrap();
        assert_eq!(events.matches("\"changed\"").count(), 2, "{space}: {events}");
        assert_eq!(events.matches("\"force set\"").count(), 2, "{space}");
        assert_eq!(events.matches("\"velocity set\"").count(), 1, "{space}");
    }
}

#[test]
fn changes_do_what_phases_do_and_the_ledger_closes() {
    for space in ["planar", "spatial"] {
        let mut live = live(&text(space), None);
        on(&mut live, 0.1);
        let rest = speed(&live, "low");
        live.change("interfaces.default.friction_angle = \"5 deg\"").unwrap();
        on(&mut live, 0.3);
        // On a slope of 20 degrees with 5 degrees of friction.
        let a =
            10.0 * (20f64.to_radians().sin() - 20f64.to_radians().cos() * 5f64.to_radians().tan());
        let slides = speed(&live, "low");
        assert!(rest < 0.02 && (slides - 0.2 * a).abs() < 0.03 * a, "{space}: {rest} {slides}");
        // The phase to come changes the damping alone, and knows of the friction.
        on(&mut live, 0.5);
        let still = speed(&live, "low");
        assert!((still - 0.4 * a).abs() < 0.03 * a, "{space}: {still}");
        let share = live.simulation().field::<&str>("energy.residual_relative", &[]).unwrap();
        assert!(share.abs() < 1e-3, "{space}: {share}");
    }
}

#[test]
fn a_force_set_by_code_does_the_work_of_its_account() {
    for space in ["planar", "spatial"] {
        let weightless = text(space)
            .replace("\"-10 m/s2\"", "\"0 m/s2\"")
            .replace("[\"3.42 m/s2\", \"0 m/s2\", \"-9.397 m/s2\"]", "\"0 m/s2\"");
        let mut live = live(&weightless, None);
        live.set_force("low", [0.0, 0.0, 0.0], [0.0; 3]).unwrap();
        live.set_force("high", [1250.0, 0.0, 0.0], [0.0; 3]).unwrap();
        on(&mut live, 0.4);
        // A metre per second squared.
        assert!((speed(&live, "high") - 0.4).abs() < 2e-3, "{space}: {}", speed(&live, "high"));
        let work = live.simulation().field("load.work", &["force on high"]).unwrap();
        assert!((work - 0.5 * 1250.0 * 0.4 * 0.4).abs() < 1.0, "{space}: {work}");
    }
}

#[test]
fn what_is_wrong_with_a_change_is_said_and_changes_nothing() {
    let mut live = live(&text("planar"), None);
    on(&mut live, 0.1);
    let before = live.simulation().engine().hash();
    let wrong = told(live.change("integration = \"implicit\""));
    assert!(
        wrong.contains("`integration` cannot change within a phase; valid keys: remove"),
        "{wrong}"
    );
    let wrong = told(live.change("remove = [\"low\", \"hig\"]"));
    assert!(
        wrong.contains("remove.1: there is no block or group \"hig\"; did you mean \"high\"?"),
        "{wrong}"
    );
    let wrong = told(live.change("remove = [\"low and not low\"]"));
    assert!(wrong.contains("remove.0: \"low and not low\": no block fulfils it"), "{wrong}");
    let wrong = told(live.change("remove = [\"low and or high\"]"));
    assert!(wrong.contains("a name is missing, behind \"low and \""), "{wrong}");
    let wrong = told(live.change("interfaces.default.friction_angle = \"nan deg\""));
    assert!(wrong.contains("nan deg"), "{wrong}");
    let wrong = told(live.change("interfaces.default.friction_angel = \"5 deg\""));
    assert!(wrong.contains("did you mean"), "{wrong}");
    let wrong = told(live.change("install = [\"bolt\"]"));
    assert!(wrong.contains("install.0: there is no bolt \"bolt\""), "{wrong}");
    let wrong = told(live.change("gravity = ["));
    assert!(wrong.contains("the change"), "{wrong}");
    let wrong = told(live.set_force("low", [f64::NAN, 0.0, 0.0], [0.0; 3]));
    assert_eq!(wrong, "the force is not finite");
    let wrong = told(live.set_velocity("table", Some([1.0, 0.0, 0.0]), None));
    assert!(wrong.contains("held or moved by a support"), "{wrong}");
    assert_eq!(live.simulation().engine().hash(), before);
    live.change("remove = [\"high\"]").unwrap();
    for wrong in [
        told(live.change("fix = [\"high\"]")),
        told(live.set_force("high", [1.0, 0.0, 0.0], [0.0; 3])),
    ] {
        assert!(wrong.contains("\"high\" has been removed"), "{wrong}");
    }
    live.advance(Pause::NEVER, &mut |_| Control::Continue).unwrap();
    assert!(told(live.change("fix = [\"low\"]")).contains("the run has ended"));
}

/// A charge in the middle of 27 bricks.
fn hole(mass: &str, delay: &str) -> String {
    format!(
        r#"
riprap = 1
title = "a hole"
[space.spatial]
gravity = "0 m/s2"
[materials.rock]
density = "2400 kg/m3"
young = "18 GPa"
poisson = 0.25
[interfaces.default]
cohesion = "4 MPa"
friction_angle = "30 deg"
[[blocks]]
name = "rock"
material = "rock"
grid.box = {{ size = ["3 m", "3 m", "3 m"], cell = "1 m" }}
[explosives.anfo]
density = "1000 kg/m3"
detonation_velocity = "4000 m/s"
heat_of_explosion = "3688 kJ/kg"
[sources.charge.gas_cavity]
centre = ["1.5 m", "1.5 m", "1.5 m"]
mass = "{mass}"
delay = "{delay}"
explosive = "anfo"
coupling = {{ scaled = 0.6667 }}
[[phases]]
name = "blast"
until.time = "1 ms"
time_step = "2 us"
"#
    )
}

#[test]
fn a_hole_is_charged_by_code_as_by_the_scene() {
    let pressure = |live: &Live| live.simulation().field("cavity.pressure", &["charge"]).unwrap();
    let end = |live: &mut Live| live.advance(Pause::NEVER, &mut |_| Control::Continue).unwrap();
    let mut scene = live(&hole("2 kg", "0.2 ms"), None);
    end(&mut scene);
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("hole");
    let mut code = live(&hole("1 kg", "1 s"), Some(&path));
    on(&mut code, 1e-4);
    code.charge("charge", 2.0, 1e-4).unwrap();
    on(&mut code, 1.5e-4);
    assert_eq!(pressure(&code), 0.0);
    on(&mut code, 5e-4);
    assert!(pressure(&code) > 1e8, "{}", pressure(&code));
    let told_of = told(code.charge("charge", 2.0, 0.0));
    assert!(told_of.contains("\"charge\" cannot be charged: it has gone off"), "{told_of}");
    assert!(told(code.charge("charg", 2.0, 0.0)).contains("did you mean \"charge\"?"));
    assert!(told(code.charge("charge", -2.0, 0.0)).contains("a mass of -2 kg is none"));
    // Closed, gone on with, and the same as the scene that has it from the start.
    code.close().unwrap();
    let again = job::resume(&path, 1, &mut |_| Control::Continue).unwrap();
    let source = &again.manifest.sources[0];
    assert!(source.mass == Some(2.0) && (source.delay - 2e-4).abs() < 1e-15, "{source:?}");
    let mut second = live(&hole("1 kg", "1 s"), None);
    on(&mut second, 1e-4);
    second.charge("charge", 2.0, 1e-4).unwrap();
    end(&mut second);
    assert_eq!(again.manifest.state_hash, second.simulation().engine().hash());
    let (a, b) = (pressure(&scene), pressure(&second));
    assert!((a - b).abs() < 1e-6 * a, "{a} {b}");
    let events = std::fs::read_to_string(path.join("events.jsonl")).unwrap();
    assert_eq!(events.matches("\"charged\"").count(), 1, "{events}");
}
