//! Rules that no other test reaches.

use crate::diagnostic::Source;
use crate::load::parse;

const PLANAR: &str = r#"
riprap = 1
title = "test"
space.planar.gravity = ["0 m/s2", "-10 m/s2"]
materials.rock.density = "2000 kg/m3"
interfaces.default = { normal_stiffness = "1 GPa/m", friction_angle = "30 deg" }
[[blocks]]
name = "rock"
material = "rock"
rectangle = { size = ["2 m", "1 m"], corner = ["0 m", "0 m"] }
"#;

const SPATIAL: &str = r#"
riprap = 1
title = "test"
space.spatial.gravity = "10 m/s2"
materials.rock = { density = "2000 kg/m3", young = "18 GPa", poisson = 0.25 }
[[blocks]]
name = "rock"
material = "rock"
brick = { size = ["2 m", "1 m", "1 m"], corner = ["0 m", "0 m", "0 m"] }
mechanics.deformable = {}
"#;

const PHASE: &str = "[[phases]]\nname = \"p\"\nuntil.time = \"1 ms\"\n";

/// What is told of a scene, in lines.
fn told(text: &str) -> String {
    match parse(Source::new("t.toml", text)) {
        Ok(parsed) => {
            let lines = parsed.warnings.iter().map(|w| w.message.clone());
            lines.collect::<Vec<_>>().join("\n")
        }
        Err(errors) => errors.render(),
    }
}

/// 700 ms are 0.7000000000000001 s.
#[test]
fn times_in_other_units_are_the_same_times() {
    let phase = |until: &str| {
        format!(
            "{PLANAR}[[phases]]\nname = \"p\"\nremove = [\"rock\"]\nuntil.time = \"{until}\"\nremoval_ramp = \"700 ms\"\n"
        )
    };
    assert_eq!(told(&phase("0.7 s")), "");
    assert!(told(&phase("0.69 s")).contains("ends before its `removal_ramp`"));
    let load = |start: &str, end: &str| {
        format!(
            "{PLANAR}{PHASE}[[loads]]\non.block = \"rock\"\nmoment = \"1 N\"\n\
             time.pulse = {{ value = 1.0, start = \"{start}\", end = \"{end}\" }}\n"
        )
    };
    let late = "`end` does not come after `start`";
    assert!(told(&load("0.7 s", "700 ms")).contains(late), "{}", told(&load("0.7 s", "700 ms")));
    assert_eq!(told(&load("0.7 s", "701 ms")), "");
}

#[test]
fn elastic_bonds_tell_what_they_do_not_read() {
    let bond = |keys: &str| {
        told(&format!(
            "{SPATIAL}[interfaces.default.brittle_bond]\nthickness = \"1 mm\"\nelastic = true\n{keys}\n{PHASE}"
        ))
    };
    assert_eq!(bond(""), "");
    let energies = "cohesive = { mode_1 = \"100 J/m2\", mode_2 = \"100 J/m2\" }";
    assert_eq!(
        bond(&format!("{energies}\nfailure = \"facet\"")),
        "`cohesive`, `failure` in interfaces.default.brittle_bond have no effect"
    );
    for (one, needed) in [
        ("young = \"1 GPa\"", "`young` in interfaces.default.brittle_bond needs `poisson`"),
        ("poisson = 0.2", "`poisson` in interfaces.default.brittle_bond needs `young`"),
    ] {
        let found = bond(one);
        assert!(found.contains(needed), "{found}");
    }
}

#[test]
fn a_phase_gives_a_speed_to_friction_that_is_clipped() {
    let scene = |law: &str, change: &str| {
        let head = PLANAR.replace("friction_angle", &format!("{law}friction_angle"));
        told(&format!("{head}{PHASE}interfaces.default = {{ {change} }}\n"))
    };
    let clipped = "friction_law = \"clipped\", clip_speed = \"1 mm/s\", ";
    let speed = "clip_speed = \"2 mm/s\"";
    assert_eq!(scene("", speed), "`clip_speed` in phases.p.interfaces.default has no effect");
    assert_eq!(scene(clipped, speed), "");
    assert_eq!(scene("", &format!("friction_law = \"clipped\", {speed}")), "");
    let other = scene(clipped, &format!("friction_law = \"rate_sign\", {speed}"));
    assert!(other.contains("has no effect"), "{other}");
}

/// Coordinates that are rounded are never exactly on one line.
#[test]
fn drain_holes_in_the_line_of_their_row_are_refused() {
    let row = |end: &str| {
        told(&format!(
            "{SPATIAL}[interfaces.default.brittle_bond]\nthickness = \"1 mm\"\nelastic = true\n\
             [water.table]\nlevel = \"1 m\"\n\
             seepage = {{ aperture = \"0.1 mm\", drains = [{{ from = [\"0.1 m\", \"0.2 m\", \"0.3 m\"], to = [\"0.4 m\", \"0.6 m\", \"0.8 m\"], \
             row_end = {end} }}] }}\n{PHASE}"
        ))
    };
    let line = "the drain holes of a row of water.table.seepage lie on one line";
    let found = row("[\"0.7 m\", \"1.0 m\", \"1.3 m\"]");
    assert!(found.contains(line), "{found}");
    let found = row("[\"0.7 m\", \"1.0 m\", \"1.31 m\"]");
    assert!(!found.contains(line), "{found}");
}
