//! Parameters of interfaces and materials that code changes.

use super::{live, on, speed, text, told};
use crate::run::drive::{Control, Pause};
use crate::run::job::{self, Live};

/// The slope of the scene in given steps.
fn slope(space: &str, step: &str) -> String {
    text(space).replace("[[phases]]", &format!("[[phases]]\ntime_step = \"{step}\""))
}

#[test]
fn friction_lowered_by_code_starts_a_slide_and_the_ledger_closes() {
    // Friction in space is that of the end of a step: what the ledger is left with falls with the step.
    for (space, step) in [("planar", "50 us"), ("spatial", "1 us")] {
        let mut live = live(&slope(space, step), None);
        on(&mut live, 0.05);
        assert!(speed(&live, "low") < 0.05, "{space}: {}", speed(&live, "low"));
        live.set_interface("default", "friction_angle = \"10 deg\"").unwrap();
        on(&mut live, 0.1);
        let before = speed(&live, "low");
        on(&mut live, 0.25);
        let (tilt, friction) = (20f64.to_radians(), 10f64.to_radians());
        let a = 10.0 * (tilt.sin() - tilt.cos() * friction.tan());
        let gained = speed(&live, "low") - before;
        assert!((gained - 0.15 * a).abs() < 2e-3 * 0.15 * a, "{space}: {gained} {}", 0.15 * a);
        let share = live.simulation().field::<&str>("energy.residual_relative", &[]).unwrap();
        assert!(share.abs() < 1e-6, "{space}: {share:e}");
    }
}

#[test]
fn a_run_with_changed_friction_goes_on_with_the_same_bits() {
    for space in ["planar", "spatial"] {
        let folder = tempfile::tempdir().unwrap();
        let script = |live: &mut Live| {
            on(live, 0.2);
            live.set_interface("default", "friction_angle = \"10 deg\"\ncohesion = \"1 kPa\"")
                .unwrap();
            on(live, 0.35);
        };
        let mut first = live(&slope(space, "50 us"), None);
        script(&mut first);
        first.advance(Pause::NEVER, &mut |_| Control::Continue).unwrap();
        let whole = first.simulation().engine().hash();
        let path = folder.path().join(space);
        let mut second = live(&slope(space, "50 us"), Some(&path));
        script(&mut second);
        second.close().unwrap();
        let again = job::resume(&path, 1, &mut |_| Control::Continue).unwrap();
        assert_eq!(again.manifest.state_hash, whole, "{space}");
        let events = std::fs::read_to_string(path.join("events.jsonl")).unwrap();
        assert_eq!(events.matches("\"changed\"").count(), 1, "{events}");
    }
}

/// A bar that is pulled in a static phase, moves in a short one and comes to rest in a static one.
fn bar() -> String {
    r#"
riprap = 1
title = "a bar of tetrahedra"
[space.spatial]
gravity = "0 m/s2"
[materials.rock]
density = "2500 kg/m3"
young = "10 GPa"
poisson = 0
[interfaces.default.brittle_bond]
thickness = "1 mm"
elastic = true
[[blocks]]
name = "bar"
material = "rock"
grid.box = { size = ["2 m", "1 m", "1 m"], cell = "1 m" }
mechanics.deformable = {}
[[boundaries]]
on.plane = "x-min"
roller = {}
[[boundaries]]
name = "end"
on.plane = "x-max"
traction.value = ["1 MPa", "0 MPa", "0 MPa"]
[[phases]]
name = "pull"
kind = "static"
until = { unbalanced = 1e-10 }
[[phases]]
name = "soften"
until.time = "2 ms"
time_step = "5 us"
[[phases]]
name = "rest"
kind = "static"
until = { unbalanced = 1e-10 }
"#
    .to_owned()
}

#[test]
fn a_modulus_changed_by_code_changes_the_energy_that_is_stored_and_the_extension() {
    let folder = tempfile::tempdir().unwrap();
    let script = |live: &mut Live| {
        while live.simulation().phase().is_some_and(|phase| phase.name == "pull") {
            let next = Pause { step: Some(live.simulation().steps() + 50), time: None };
            live.advance(next, &mut |_| Control::Continue).unwrap();
        }
        let read = |live: &Live, field: &str| live.simulation().field::<&str>(field, &[]).unwrap();
        let stored =
            |live: &Live| read(live, "model.strain_energy") + read(live, "model.bond_energy");
        let before = [stored(live), read(live, "energy.edit_defect")];
        let residual = read(live, "energy.residual");
        live.set_material("rock", "young = \"5 GPa\"").unwrap();
        let after = [stored(live), read(live, "energy.edit_defect")];
        for _ in 0..5 {
            let next = Pause { step: Some(live.simulation().steps() + 50), time: None };
            live.advance(next, &mut |_| Control::Continue).unwrap();
        }
        // While it swings: static phases do not keep energy.
        let added = read(live, "energy.residual") - residual;
        assert!(added.abs() < 1e-6 * before[0], "{added} {before:?}");
        (before, after)
    };
    let mut first = live(&bar(), None);
    let ([stored, defect], [stored_then, defect_then]) = script(&mut first);
    assert!((stored_then - 0.5 * stored).abs() < 1e-9 * stored, "{stored} {stored_then}");
    let booked = defect_then - defect;
    assert!((booked + 0.5 * stored).abs() < 1e-6 * stored, "{booked} {stored}");
    first.advance(Pause::NEVER, &mut |_| Control::Continue).unwrap();
    let end = first.simulation().field("boundary.displacement.x", &["end"]).unwrap();
    // sigma L/E, and a bond of 1 mm.
    let closed = 1e6 * 2.001 / 5e9;
    assert!((end - closed).abs() < 1e-6 * closed, "{end:e} {closed:e}");
    let path = folder.path().join("bar");
    let mut second = live(&bar(), Some(&path));
    script(&mut second);
    second.close().unwrap();
    let again = job::resume(&path, 1, &mut |_| Control::Continue).unwrap();
    assert_eq!(again.manifest.state_hash, first.simulation().engine().hash());
    let events = std::fs::read_to_string(path.join("events.jsonl")).unwrap();
    assert_eq!(events.matches("\"material changed\"").count(), 1, "{events}");
}

#[test]
fn what_cannot_change_is_refused_by_name() {
    let mut bar = live(&bar(), None);
    on(&mut bar, 0.0);
    let before = bar.simulation().engine().hash();
    for (name, keys, why) in [
        (
            "rock",
            "name = \"ore\"",
            "`materials.rock.name` cannot change within a phase; valid keys: density, young, poisson",
        ),
        ("rok", "young = \"1 GPa\"", "there is none of this name; did you mean \"rock\"?"),
        ("rock", "young = \"nan GPa\"", "nan GPa"),
        ("rock", "poisson = 0.7", "poisson"),
        ("rock", "", "no key is given"),
        ("rock", "density = \"-1 kg/m3\"", "density"),
        ("rock", "young = \"1 GPa\"", "the phase relaxes deformable blocks"),
        ("rock", "density = \"1000 kg/m3\"", "the phase relaxes deformable blocks"),
    ] {
        let said = told(bar.set_material(name, keys));
        assert!(said.contains(why), "{said}");
    }
    assert_eq!(bar.simulation().engine().hash(), before);
    let mut flat = live(&text("planar"), None);
    on(&mut flat, 0.1);
    let said = told(flat.set_material("rock", "young = \"1 GPa\""));
    assert!(said.contains("change `interfaces.NAME.normal_stiffness`"), "{said}");
    let said = told(flat.set_interface("defalt", "friction_angle = \"1 deg\""));
    assert!(said.contains("defalt"), "{said}");
    let said = told(flat.change("gravity_ramp = \"1 s\""));
    assert!(said.contains("gravity_ramp"), "{said}");
    let said = told(
        flat.change("interfaces.default.shear_stiffness = \"2 GPa/m\"\nremoval_ramp = \"1 s\""),
    );
    assert!(said.contains("removal_ramp"), "{said}");
}

/// Two stones in the void, one of which spins, of two materials.
fn void(space: &str) -> String {
    let planar = space == "planar";
    let (gravity, spin, more) = match planar {
        true => ("[\"0 m/s2\", \"0 m/s2\"]", "\"3 rad/s\"", ""),
        false => (
            "\"0 m/s2\"",
            "[\"0 rad/s\", \"0 rad/s\", \"3 rad/s\"]",
            "shear_stiffness = \"0.5 GPa/m\"",
        ),
    };
    let shape = |x: f64| match planar {
        true => {
            format!("rectangle = {{ size = [\"1 m\", \"1 m\"], corner = [\"{x} m\", \"0 m\"] }}")
        }
        false => format!(
            "brick = {{ size = [\"1 m\", \"1 m\", \"1 m\"], corner = [\"{x} m\", \"0 m\", \"0 m\"] }}"
        ),
    };
    let (first, second) = (shape(0.0), shape(9.0));
    format!(
        r#"
riprap = 1
title = "stones in the void"
[space.{space}]
gravity = {gravity}
[materials.rock]
density = "2000 kg/m3"
[materials.ore]
density = "2000 kg/m3"
[interfaces.default]
normal_stiffness = "1 GPa/m"
{more}
friction_angle = "30 deg"
[[blocks]]
name = "stone"
material = "rock"
{first}
spin = {spin}
[[blocks]]
name = "other"
material = "ore"
{second}
[[phases]]
name = "go"
until.time = "1 s"
time_step = "1 ms"
"#
    )
}

#[test]
fn a_density_changed_by_code_keeps_velocities_and_books_the_energy() {
    for space in ["planar", "spatial"] {
        let folder = tempfile::tempdir().unwrap();
        let read =
            |live: &Live, field: &str, of: &[&str]| live.simulation().field(field, of).unwrap();
        let script = |live: &mut Live| {
            live.set_force("stone", [4000.0, 0.0, 0.0], [0.0; 3]).unwrap();
            on(live, 0.5);
            // Of the whole run: at 1 m/s, and 3 rad/s with an inertia of m/6.
            let before = read(live, "energy.edit_defect", &[]);
            live.set_material("rock", "density = \"5000 kg/m3\"").unwrap();
            let booked = read(live, "energy.edit_defect", &[]) - before;
            let closed = 0.5 * 3000.0 * (1.0 + 9.0 / 6.0);
            assert!((booked - closed).abs() < 1e-6 * closed, "{space}: {booked} {closed}");
            assert!((speed(live, "stone") - 1.0).abs() < 1e-9, "{space}: {}", speed(live, "stone"));
            assert_eq!(read(live, "block.mass", &["other"]), 2000.0, "{space}");
            assert!((read(live, "block.mass", &["stone"]) - 5000.0).abs() < 1e-9, "{space}");
        };
        let mut first = live(&void(space), None);
        script(&mut first);
        first.advance(Pause::NEVER, &mut |_| Control::Continue).unwrap();
        // 2 m/s2 for half of a second, then 0.8 m/s2.
        assert!((speed(&first, "stone") - 1.4).abs() < 1e-9, "{space}: {}", speed(&first, "stone"));
        let spin = if space == "planar" { "block.spin" } else { "block.spin.z" };
        assert!((read(&first, spin, &["stone"]) - 3.0).abs() < 1e-9, "{space}");
        let share = read(&first, "energy.residual_relative", &[]);
        assert!(share.abs() < 1e-9, "{space}: {share:e}");
        let path = folder.path().join(space);
        let mut second = live(&void(space), Some(&path));
        script(&mut second);
        second.close().unwrap();
        let again = job::resume(&path, 1, &mut |_| Control::Continue).unwrap();
        assert_eq!(again.manifest.state_hash, first.simulation().engine().hash(), "{space}");
    }
}

#[test]
fn heavier_blocks_press_harder_at_rest() {
    for space in ["planar", "spatial"] {
        let mut live = live(
            &text(space).replace("tilt = \"20 deg\"", "").replace("3.42 m/s2", "0 m/s2"),
            None,
        );
        on(&mut live, 0.2);
        let pressing =
            |live: &Live| live.simulation().field("pair.normal_force", &["low", "table"]).unwrap();
        let before = pressing(&live);
        live.set_material("rock", "density = \"3750 kg/m3\"").unwrap();
        on(&mut live, 0.39);
        let after = pressing(&live);
        // Both still swing a little.
        assert!((after / before - 1.5).abs() < 0.1, "{space}: {before} {after}");
        let share = live.simulation().field::<&str>("energy.residual_relative", &[]).unwrap();
        assert!(share.abs() < 1e-4, "{space}: {share:e}");
    }
}

/// A brick of 1 m that is pushed against rock that carries its wave away moves at F/(sqrt(rho M) A).
#[test]
fn what_carries_waves_away_is_as_heavy_as_the_rock() {
    let scene = r#"
riprap = 1
title = "A brick that sends a wave"
[space.spatial]
gravity = "0 m/s2"
[materials.rock]
density = "2000 kg/m3"
young = "2 MPa"
poisson = 0
[interfaces.default]
cohesion = "1 MPa"
tension = "1 MPa"
friction_angle = "30 deg"
[[blocks]]
name = "stone"
material = "rock"
brick = { size = ["1 m", "1 m", "1 m"], corner = ["0 m", "0 m", "0 m"] }
[[boundaries]]
on.plane = "x-max"
viscous = {}
[[phases]]
name = "go"
until.time = "1 s"
time_step = "100 us"
"#;
    let folder = tempfile::tempdir().unwrap();
    let script = |live: &mut Live| {
        // Against sqrt(2000 * 2e6) Pa s/m.
        let slowness = 2000_f64 * 1e3_f64.sqrt();
        live.set_force("stone", [slowness, 0.0, 0.0], [0.0; 3]).unwrap();
        on(live, 0.4);
        let before = speed(live, "stone");
        assert!((before - 1.0).abs() < 1e-4, "{before}");
        live.set_material("rock", "density = \"8000 kg/m3\"").unwrap();
        on(live, 0.9);
    };
    let mut first = live(scene, None);
    script(&mut first);
    let after = speed(&first, "stone");
    assert!((after - 0.5).abs() < 1e-3, "{after}");
    first.advance(Pause::NEVER, &mut |_| Control::Continue).unwrap();
    let path = folder.path().join("wave");
    let mut second = live(scene, Some(&path));
    script(&mut second);
    second.close().unwrap();
    let again = job::resume(&path, 1, &mut |_| Control::Continue).unwrap();
    assert_eq!(again.manifest.state_hash, first.simulation().engine().hash());
}
