//! Forces on nodes of deformable blocks, and spins, by code.

use super::{live, on, told};
use crate::record::folder::Existing;
use crate::run::drive::{Control, Pause};
use crate::run::job::{self, Live};
use crate::run::scene::Scene;
use crate::scenario::Source;

/// A bar of two cubes of 1 m with bonds; `end` is a key of the pulled face.
fn bar(end: &str, phase: &str) -> String {
    format!(
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
grid.box = {{ size = ["2 m", "1 m", "1 m"], cell = "1 m" }}
mechanics.deformable = {{}}
[[boundaries]]
on.plane = "x-min"
roller = {{}}
[[boundaries]]
on.plane = "y-min"
roller = {{}}
[[boundaries]]
on.plane = "z-min"
roller = {{}}
{end}
[[phases]]
name = "pull"
{phase}
"#
    )
}

const STATIC: &str = "kind = \"static\"\nuntil = { unbalanced = 1e-10 }";
const DYNAMIC: &str = "until.time = \"4 ms\"\ntime_step = \"5 us\"";

/// What a traction (Pa) of the face gives its nodes: forces (N) along x as the consistent shares of a face with a centre.
fn pulled(live: &Live, traction: f64) -> Vec<(u32, [f64; 3])> {
    let nodes = live.simulation().nodes("bar.2").unwrap();
    let end: Vec<u32> =
        (0..).zip(&nodes.points).filter(|(_, p)| p[0] > 1.999).map(|(n, _)| n).collect();
    assert_eq!(end.len(), 5, "four corners and the centre of the face");
    // Four triangles of a quarter of a square metre, a third to each corner of theirs.
    let share = |n: u32| if n < 8 { 2.0 / 12.0 } else { 4.0 / 12.0 };
    end.into_iter().map(|n| (n, [traction * share(n), 0.0, 0.0])).collect()
}

fn end_of(live: &mut Live) -> f64 {
    live.advance(Pause::NEVER, &mut |_| Control::Continue).unwrap();
    let nodes = live.simulation().nodes("bar.2").unwrap();
    let end = nodes.points.iter().zip(&nodes.displacements).filter(|(p, _)| p[0] > 1.9);
    let moved: Vec<f64> = end.map(|(_, u)| u[0]).collect();
    moved.iter().sum::<f64>() / moved.len() as f64
}

#[test]
fn nodes_pulled_by_code_stretch_a_bar_as_a_traction_and_as_the_closed_form() {
    for phase in [STATIC, DYNAMIC] {
        let key = "[[boundaries]]\nname = \"end\"\non.plane = \"x-max\"\ntraction.value = [\"1 MPa\", \"0 MPa\", \"0 MPa\"]";
        let mut scene = live(&bar(key, phase), None);
        let by_key = end_of(&mut scene);
        let mut code = live(&bar("", phase), None);
        on(&mut code, 0.0);
        let forces = pulled(&code, 1e6);
        code.set_node_forces("bar.2", &forces).unwrap();
        let by_code = end_of(&mut code);
        assert!((by_code - by_key).abs() < 1e-9 * by_key.abs(), "{by_code:e} {by_key:e}");
        let simulation = code.simulation();
        let residual = simulation.field::<&str>("energy.residual_relative", &[]).unwrap();
        assert!(residual.abs() < 1e-9, "{residual:e}");
        let work = simulation.field("load.work", &["force on nodes of bar.2"]).unwrap();
        if phase == STATIC {
            // sigma L/E, and one bond of 1 mm between the two.
            let closed = 1e6 * (2.0 + 1e-3) / 10e9;
            assert!((by_code - closed).abs() < 1e-6 * closed, "{by_code:e} {closed:e}");
        } else {
            let end = scene.simulation().field("boundary.work", &["end"]).unwrap();
            assert!((work - end).abs() < 1e-9 * end, "{work} {end}");
        }
    }
}

#[test]
fn forces_on_nodes_stand_in_events_and_survive_a_restart_on_any_threads() {
    let folder = tempfile::tempdir().unwrap();
    let text = bar("", DYNAMIC);
    let script = |live: &mut Live| {
        on(live, 1e-3);
        let forces = pulled(live, 1e6);
        live.set_node_forces("bar.2", &forces).unwrap();
        on(live, 2e-3);
    };
    let scene = Scene::parse(Source::new("bar.toml", &text[..]), ".".into(), &[]).unwrap();
    let job = || scene.prepare(&scene.plain()).unwrap().job();
    let mut hashes = Vec::new();
    for threads in [1, 3] {
        let mut whole = Live::unrecorded(job(), threads).unwrap();
        script(&mut whole);
        whole.advance(Pause::NEVER, &mut |_| Control::Continue).unwrap();
        hashes.push(whole.simulation().engine().hash());
    }
    let path = folder.path().join("bar");
    let mut first = Live::begin(job(), &path, Existing::Refuse, 2).unwrap();
    script(&mut first);
    first.close().unwrap();
    let again = job::resume(&path, 1, &mut |_| Control::Continue).unwrap();
    hashes.push(again.manifest.state_hash);
    assert!(hashes.iter().all(|hash| *hash == hashes[0]), "{hashes:?}");
    let events = std::fs::read_to_string(path.join("events.jsonl")).unwrap();
    assert_eq!(events.matches("\"node forces set\"").count(), 1, "{events}");
}

#[test]
fn what_nodes_do_not_take_is_said_and_changes_nothing() {
    let mut live = live(&bar("", DYNAMIC), None);
    on(&mut live, 0.0);
    let before = live.simulation().engine().hash();
    let one = [1.0, 0.0, 0.0];
    for (of, forces, why) in [
        (
            "bar.2",
            vec![(99, one)],
            "nodes of \"bar.2\" cannot be pushed: it has nodes 0 to 14, not 99",
        ),
        ("bar.2", vec![(1, one), (1, one)], "node 1 is named twice"),
        ("bar.2", vec![(1, [f64::NAN; 3])], "the force on node 1 is not finite"),
        ("bar", vec![(1, one)], "it names several blocks"),
        (
            "bat.2",
            vec![(1, one)],
            "set_node_forces: there is no block or group \"bat.2\"; did you mean \"bar.2\"?",
        ),
    ] {
        let said = told(live.set_node_forces(of, &forces));
        assert!(said.contains(why), "{said}");
    }
    let said = told(live.set_force("bar.1", [0.0; 3], one));
    assert!(said.contains("it deforms, and nodes take no moment"), "{said}");
    assert_eq!(live.simulation().engine().hash(), before);
    live.change("remove = [\"bar.2\"]").unwrap();
    let said = told(live.set_node_forces("bar.2", &[(1, one)]));
    assert!(said.contains("\"bar.2\" has been removed"), "{said}");
    let mut rigid = super::live(&super::text("spatial"), None);
    on(&mut rigid, 0.0);
    let said = told(rigid.set_node_forces("low", &[(1, one)]));
    assert!(said.contains("it is rigid; use `set_force`"), "{said}");
}

#[test]
fn a_spin_set_by_code_turns_a_block_and_its_energy_is_booked() {
    for space in ["planar", "spatial"] {
        let weightless = super::text(space)
            .replace("\"-10 m/s2\"", "\"0 m/s2\"")
            .replace("[\"3.42 m/s2\", \"0 m/s2\", \"-9.397 m/s2\"]", "\"0 m/s2\"");
        let mut live = live(&weightless, None);
        on(&mut live, 0.1);
        // In space it leaves the other behind, upwards, and has turned before it is told again.
        let (away, spin) = match space {
            "planar" => ([0.0, 20.0, 0.0], [0.0, 0.0, 3.0]),
            _ => ([0.0, 0.0, 20.0], [0.0, 3.0, 0.0]),
        };
        live.set_velocity("high", Some(away), None).unwrap();
        on(&mut live, 0.15);
        let up = if space == "planar" { "block.velocity.y" } else { "block.velocity.z" };
        let rises = live.simulation().field(up, &["high"]).unwrap();
        live.set_velocity("high", None, Some(spin)).unwrap();
        on(&mut live, 0.3);
        live.set_velocity("high", None, Some(spin.map(|w| 2.0 * w))).unwrap();
        on(&mut live, 0.35);
        let read = |field: &str| live.simulation().field(field, &["high"]).unwrap();
        let turned =
            if space == "planar" { read("block.rotation") } else { read("block.rotation.y") };
        // 0.15 s at 3 rad/s and 0.05 s at 6.
        assert!((turned - 0.75).abs() < 0.02, "{space}: {turned}");
        assert!((read(up) - rises).abs() < 1e-9, "{space}: {} {rises}", read(up));
        // A metre by half a metre: m (a2 + b2)/12 = 1250/12 * 1.25 kg m2, per metre or of a metre.
        let energy = 0.5 * (1250.0 / 12.0 * 1.25) * 36.0 + 0.5 * 1250.0 * 400.0;
        let booked = live.simulation().field::<&str>("energy.edit_defect", &[]).unwrap();
        assert!((booked - energy).abs() < 1e-6 * energy, "{space}: {booked} {energy}");
        let said = told(live.set_velocity("high", None, Some([f64::NAN; 3])));
        assert_eq!(said, "the spin is not finite");
    }
    let mut flat = live(&super::text("planar"), None);
    let said = told(flat.set_velocity("high", None, Some([1.0, 0.0, 0.0])));
    assert!(said.contains("spins about z alone"), "{said}");
}
