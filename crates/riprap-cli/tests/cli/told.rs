//! What commands tell of scenes that come out otherwise than they seem.

use super::bench::Bench;

/// A slab glued to a plane that dips by 35 deg, under gravity that is there at once. F = (c A + W cos a tan phi)/(W sin a) = 1.235 with the same
/// stress everywhere, 1.21 where the lower points begin.
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
cohesion = "0.3 kPa"
[[blocks]]
name = "plane"
material = "rock"
brick = { size = ["6 m", "3 m", "1 m"], corner = ["-3 m", "-1 m", "-1 m"] }
[[blocks]]
name = "block"
material = "rock"
brick = { size = ["2 m", "1 m", "5 cm"], corner = ["-1 m", "0 m", "0 m"] }
[[supports]]
on.block = "plane"
fixed = {}
[[phases]]
name = "load"
until = { time = "0.3 s" }
"#;

/// The keys of its phase that seek an equilibrium by Newton's method.
const SETTLES: &str =
    "kind = \"static\"\nintegration = \"implicit\"\nuntil = { unbalanced = 1e-6, steps = 100 }";

/// The block with other keys of its phase.
fn glued(phase: &str) -> String {
    GLUED.replace("until = { time = \"0.3 s\" }", phase)
}

#[test]
fn joints_that_broke_before_the_first_trial_are_told() {
    let bench = Bench::new();
    bench.file("glued.toml", GLUED);
    let words = ["safety", "glued.toml", "-q", "--force"];
    bench
        .run(&words)
        .warns(&["points of joints had failed before the first trial", "`gravity_ramp`"]);
    let slow = "gravity_ramp = \"0.2 s\"\nuntil = { time = \"0.3 s\" }";
    for phase in [slow, SETTLES] {
        bench.file("glued.toml", glued(phase));
        let said = bench.run(&words).expect(0).says(&["factor of safety: 1.2"]);
        assert!(!said.err.contains("had failed"), "{phase}: {}", said.err);
    }
    // What has no cohesion loses none.
    let plain = GLUED.replace("30 deg", "45 deg").replace("0.3 kPa", "0 Pa");
    bench.file("glued.toml", plain);
    let said = bench.run(&words);
    assert!(!said.err.contains("had failed"), "{}", said.err);
}

#[test]
fn steps_that_grow_towards_an_equilibrium_are_told_with_the_longest() {
    let bench = Bench::new();
    let line = |phase: &str| {
        bench.file("glued.toml", glued(phase));
        let out = bench.run(&["check", "glued.toml"]).expect(0).out;
        out.lines().find(|l| l.contains("time step")).unwrap_or_default().to_owned()
    };
    let grows = "at first, then longer towards equilibrium, at most";
    let (usual, given) = (line(SETTLES), line(&format!("{SETTLES}\ntime_step = \"40 s\"")));
    assert!(usual.ends_with(&format!("{grows} 1 s")), "{usual}");
    assert!(given.ends_with(&format!("{grows} 40 s")), "{given}");
    // One that is as long as the first is all there is, as in a phase that is no search for an equilibrium.
    for one in [
        &format!("{SETTLES}\ntime_step = \"1 ms\""),
        "integration = \"implicit\"\nuntil = { time = \"1 s\" }",
        "kind = \"static\"\nuntil = { unbalanced = 1e-6, steps = 100 }",
    ] {
        assert!(!line(one).contains(grows), "{one}: {}", line(one));
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
relative = 0.02
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
