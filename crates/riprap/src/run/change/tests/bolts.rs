//! Bolts that the scene does not have.

use super::{live, on, told};
use crate::run::drive::{Control, Pause};
use crate::run::job::{self, Live};

const KEYS: &str =
    "steel = { diameter = \"20 mm\", young = \"200 GPa\" }\ngrout = { stiffness = \"1 GN/m2\" }\n";

/// A block that hangs in the void below one that is held, with a bolt of the scene far away from both.
fn hanging(space: &str) -> String {
    let (head, far) = match space {
        "planar" => (
            "gravity = [\"0 m/s2\", \"-10 m/s2\"]",
            "head = [\"9.5 m\", \"2 m\"]\ntoe = [\"9.5 m\", \"0.1 m\"]\nspacing = \"1 m\"",
        ),
        _ => (
            "gravity = \"10 m/s2\"",
            "head = [\"9.5 m\", \"0.5 m\", \"2 m\"]\ntoe = [\"9.5 m\", \"0.5 m\", \"0.1 m\"]",
        ),
    };
    let block = |name: &str, [x, z]: [f64; 2]| match space {
        "planar" => format!(
            "[[blocks]]\nname = \"{name}\"\nmaterial = \"rock\"\nrectangle = {{ size = [\"1 m\", \"1 m\"], corner = [\"{x} m\", \"{z} m\"] }}\n"
        ),
        _ => format!(
            "[[blocks]]\nname = \"{name}\"\nmaterial = \"rock\"\nbrick = {{ size = [\"1 m\", \"1 m\", \"1 m\"], corner = [\"{x} m\", \"0 m\", \"{z} m\"] }}\n"
        ),
    };
    let blocks =
        [("top", [0.0, 1.0]), ("low", [0.0, 0.0]), ("far", [9.0, 0.0]), ("cap", [9.0, 1.0])];
    let blocks: String = blocks.map(|(name, at)| block(name, at)).concat();
    format!(
        r#"
riprap = 1
title = "a block that hangs"
[space.{space}]
{head}
[materials.rock]
density = "2000 kg/m3"
[interfaces.default]
normal_stiffness = "1 GPa/m"
friction_angle = "30 deg"
{blocks}
[[supports]]
on.group = "top or far or cap"
fixed = {{}}
[[bolts]]
name = "anchor"
{far}
{KEYS}
[[phases]]
name = "fall"
until.time = "0.02 s"
time_step = "10 us"
[[phases]]
name = "hang"
kind = "static"
until = {{ unbalanced = 1e-6, steps = 200000 }}
"#
    )
}

/// Both ends of a bolt through two blocks.
fn ends(space: &str, x: f64) -> String {
    match space {
        "planar" => format!("head = [\"{x} m\", \"0.01 m\"]\ntoe = [\"{x} m\", \"1.9 m\"]\n"),
        _ => format!(
            "head = [\"{x} m\", \"0.5 m\", \"0.01 m\"]\ntoe = [\"{x} m\", \"0.5 m\", \"1.9 m\"]\n"
        ),
    }
}

#[test]
fn a_bolt_by_code_carries_the_block_and_is_kept_by_a_restart() {
    for space in ["planar", "spatial"] {
        let folder = tempfile::tempdir().unwrap();
        let script = |live: &mut Live| {
            on(live, 0.01);
            let keys = format!("name = \"late\"\nlike = \"anchor\"\n{}", ends(space, 0.5));
            live.install_bolt(&keys).unwrap();
            on(live, 0.015);
            // A second one by its own keys, between blocks that are held, and a change after both.
            let own = format!("{}{KEYS}dowel.stiffness = \"100 MN/m\"", ends(space, 9.2));
            live.install_bolt(&own).unwrap();
            live.set_interface("default", "friction_angle = \"20 deg\"").unwrap();
        };
        let mut first = live(&hanging(space), None);
        script(&mut first);
        first.advance(Pause::NEVER, &mut |_| Control::Continue).unwrap();
        let force =
            |name: &str| -> f64 { first.simulation().field("bolt.axial_force", &[name]).unwrap() };
        let weight = 20_000.0;
        assert!((force("late") - weight).abs() < 1e-3 * weight, "{space}: {}", force("late"));
        assert!(force("anchor").abs() < 1.0 && force("bolt by code 1").abs() < 1.0, "{space}");
        let path = folder.path().join(space);
        let mut second = live(&hanging(space), Some(&path));
        script(&mut second);
        second.close().unwrap();
        let again = job::resume(&path, 1, &mut |_| Control::Continue).unwrap();
        assert_eq!(again.manifest.state_hash, first.simulation().engine().hash(), "{space}");
        let events = std::fs::read_to_string(path.join("events.jsonl")).unwrap();
        assert_eq!(events.matches("\"bolt installed\"").count(), 2, "{events}");
        let bolts = std::fs::read_to_string(path.join("bolts.csv")).unwrap();
        assert!(bolts.contains("late,") && bolts.contains("bolt by code 1,"), "{bolts}");
    }
}

#[test]
fn a_bolt_that_cannot_be_is_refused_and_nothing_has_changed() {
    for space in ["planar", "spatial"] {
        let mut live = live(&hanging(space), None);
        on(&mut live, 0.01);
        let before = live.simulation().engine().hash();
        let here = ends(space, 0.5);
        for (keys, why) in [
            (format!("like = \"anker\"\n{here}"), "did you mean \"anchor\"?"),
            (format!("name = \"anchor\"\nlike = \"anchor\"\n{here}"), "a bolt has this name"),
            (format!("like = \"anchor\"\nphase = \"hang\"\n{here}"), "`bolts.phase` cannot change"),
            (here.clone(), "steel"),
            (format!("like = \"anchor\"\npiece = \"-1 m\"\n{here}"), "piece"),
            (
                format!("like = \"anchor\"\n{}", here.replace("1.9 m", "9 m")),
                "its toe lies outside the rock",
            ),
        ] {
            let said = told(live.install_bolt(&keys));
            assert!(said.contains(why), "{space}: {said}");
        }
        assert_eq!(live.simulation().engine().hash(), before, "{space}");
    }
}
