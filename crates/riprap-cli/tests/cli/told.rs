//! What commands tell of scenes that come out otherwise than they seem.

use super::bench::Bench;

/// A block glued to a plane that dips by 35 deg, F = (c A + W cos a tan phi)/(W sin a) = 1.235, under gravity that is there at once.
const GLUED: &str = r#"
riprap = 1
title = "a block glued to a plane"
[space.spatial]
gravity = ["5.62678 m/s2", "0 m/s2", "-8.03588 m/s2"]
[materials.rock]
density = "2600 kg/m3"
[interfaces.default]
normal_stiffness = "1 GPa/m"
shear_stiffness = "0.3 GPa/m"
friction_angle = "30 deg"
cohesion = "6 kPa"
[[blocks]]
name = "plane"
material = "rock"
brick = { size = ["6 m", "3 m", "1 m"], corner = ["-3 m", "-1 m", "-1 m"] }
[[blocks]]
name = "block"
material = "rock"
brick = { size = ["2 m", "1 m", "1 m"], corner = ["-1 m", "0 m", "0 m"] }
[[supports]]
on.block = "plane"
fixed = {}
[[phases]]
name = "load"
until = { time = "0.3 s" }
"#;

#[test]
fn joints_that_broke_before_the_first_trial_are_told() {
    let bench = Bench::new();
    bench.file("glued.toml", GLUED);
    let words = ["safety", "glued.toml", "-q", "--force"];
    let broken = bench.run(&words);
    broken.warns(&["points of joints had failed before the first trial", "gravity_ramp"]);
    for slow in [
        "phases.load.gravity_ramp=0.2 s",
        "phases.load={ name = 'load', kind = 'static', integration = 'implicit', until = { unbalanced = 1e-6, steps = 100 } }",
    ] {
        let words = [&words[..], &["--set", slow]].concat();
        let said = bench.run(&words).expect(0).says(&["factor of safety: 1.2"]);
        assert!(!said.err.contains("had failed"), "{slow}: {}", said.err);
    }
    // What has no cohesion loses none.
    let words = [&words[..], &["--set", "interfaces.default.cohesion=0 Pa"]].concat();
    let said =
        bench.run(&[&words[..], &["--set", "interfaces.default.friction_angle=45 deg"]].concat());
    assert!(!said.err.contains("had failed"), "{}", said.err);
}

#[test]
fn steps_that_grow_towards_an_equilibrium_are_told_with_the_longest() {
    let bench = Bench::new();
    bench.file("glued.toml", GLUED);
    let set = |phase: &str| {
        let phase = format!("phases.load={{ name = 'load', {phase} }}");
        bench.run(&["check", "glued.toml", "--set", &phase]).expect(0).out
    };
    let line =
        |out: &str| out.lines().find(|l| l.contains("time step")).unwrap_or_default().to_owned();
    let implicit =
        "kind = 'static', integration = 'implicit', until = { unbalanced = 1e-6, steps = 100 }";
    let grows = "at first, then longer towards equilibrium, at most";
    assert!(line(&set(implicit)).ends_with(&format!("{grows} 1 s")), "{}", set(implicit));
    let given = format!("{implicit}, time_step = '40 s'");
    assert!(line(&set(&given)).ends_with(&format!("{grows} 40 s")), "{}", set(&given));
    // One that is as long as the first is all there is, as in a phase that is no search for an equilibrium.
    for one in [
        format!("{implicit}, time_step = '1 ms'"),
        "integration = 'implicit', until = { time = '1 s' }".to_owned(),
        "kind = 'static', until = { unbalanced = 1e-6, steps = 100 }".to_owned(),
    ] {
        assert!(!line(&set(&one)).contains(grows), "{}", set(&one));
    }
}

#[test]
fn a_criterion_that_falls_back_is_told() {
    let bench = Bench::new();
    for (field, above, told) in [("pair.broken", "0.1", true), ("pair.broken_points", "0.5", false)]
    {
        let bisect = format!(
            "{GLUED}\n[bisect]\nkey = \"materials.rock.density\"\nlow = \"2 t/m3\"\nhigh = \"9 t/m3\"\ntolerance = \"1 t/m3\"\n\
             fails_when = {{ field = \"{field}\", of = [\"block\", \"plane\"], above = {above} }}\n"
        );
        bench.file("limit.toml", bisect);
        let said = bench.run(&["check", "limit.toml"]).expect(0);
        let words = "`pair.broken` is 0 again once a broken joint has been released";
        assert_eq!(said.err.contains(words), told, "{field}: {}", said.err);
    }
}

/// A block of 60 kN that hangs on an anchor which yields from 50 kN on.
const HANGS: &str = r#"
riprap = 1
title = "a block hangs on one anchor"
[space.spatial]
gravity = "10 m/s2"
[materials.rock]
density = "6000 kg/m3"
[interfaces.default]
normal_stiffness = "10 GPa/m"
shear_stiffness = "5 GPa/m"
friction_angle = "30 deg"
[[blocks]]
name = "roof"
material = "rock"
brick = { size = ["3 m", "3 m", "2.5 m"], corner = ["-1.5 m", "-1.5 m", "0 m"] }
[[blocks]]
name = "key"
material = "rock"
brick = { size = ["1 m", "1 m", "1 m"], corner = ["-0.5 m", "-0.5 m", "-1 m"] }
[[bolts]]
name = "anchor"
head = ["0 m", "0 m", "-1 m"]
toe = ["0 m", "0 m", "2 m"]
steel = { area = "200 mm2", young = "200 GPa", yield_force = "50 kN", hardening = 0.02 }
grout = { stiffness = "0.5 GN/m2", length = "1 m" }
plate = {}
piece = "10 cm"
[[supports]]
on.block = "roof"
fixed = {}
[[phases]]
name = "hang"
kind = "static"
until = { unbalanced = 1e-6, steps = 100000 }
[[checks]]
name = "as low as the closed form, within the length of the pieces"
field = "block.displacement.z"
of = "key"
value = "-28.66 mm"
relative = 0.01
"#;

#[test]
fn a_bolt_that_yielded_as_relaxation_swung_is_told() {
    let bench = Bench::new();
    bench.file("hangs.toml", HANGS);
    let swung = "bolt `anchor` has yielded up to";
    let run = |set: &str, code: i32| {
        let words = ["run", "hangs.toml", "-q", "--force", "--set", set];
        bench.run(&words).expect(code)
    };
    // 42.8 mm.
    run("phases.hang.integration=explicit", 1).warns(&[swung, "bears 6.0000e4 N", "implicit"]);
    let right = run("phases.hang.integration=implicit", 0);
    assert!(!right.err.contains(swung), "{}", right.err);
    let elastic = run("bolts.anchor.steel.yield_force=500 kN", 1);
    assert!(!elastic.err.contains(swung), "{}", elastic.err);
}
