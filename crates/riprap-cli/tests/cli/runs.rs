//! Runs: what they leave behind, how they end, how they go on.

use super::bench::{Bench, FALL};

/// Forces, masses and energies are those of the slice, with its units; the motion is the same to the bit.
#[test]
fn a_thickness_scales_what_is_told_and_not_the_motion() {
    let bench = Bench::with_scene();
    let run = |out: &str, more: &[&str]| {
        let words = [&["run", "fall.toml", "--out", out][..], more].concat();
        bench.run(&words).expect(0);
        let table = bench.read(&format!("{out}/energy.csv"));
        let last = table.lines().last().unwrap_or_default().to_owned();
        let kinetic: f64 = last.split(',').nth(2).unwrap_or_default().parse().unwrap();
        let hash = bench.run(&["hash", out]).expect(0).out;
        (table, kinetic, hash)
    };
    let (plain, one, hash) = run("one.run", &[]);
    let (slice, thick, same) = run("thick.run", &["--set", "space.planar.thickness=2.5 m"]);
    assert!(plain.contains("kinetic [J/m]") && slice.contains("kinetic [J]"));
    assert!(one > 0.0 && thick == 2.5 * one, "{one} {thick}");
    assert_eq!(hash, same);
    let manifest = bench.read("thick.run/manifest.json");
    assert!(manifest.contains("\"N\"") && !manifest.contains("\"N/m\""));
    bench
        .run(&["check", "fall.toml", "--set", "space.planar.thickness=0 m"])
        .expect(2)
        .warns(&["thickness"]);
}

#[test]
fn a_run_leaves_everything_behind_and_says_what_next() {
    let bench = Bench::with_scene();
    let said = bench.run(&["run", "fall.toml"]).expect(0);
    let said = said.says(&["done: 20 000 steps", "passed", "riprap plot fall.run", "residual"]);
    // Not a terminal: plain lines, no escapes.
    assert!(!said.err.contains('\u{1b}') && !said.out.contains('\u{1b}'));
    said.warns(&["phase 1/1 \"fall\"", "steps/s", "ETA", "energy residual", "worst overlap"]);
    for file in [
        "manifest.json",
        "histories.csv",
        "energy.csv",
        "events.jsonl",
        "run.pvd",
        "scenario.resolved.toml",
        "checks.jsonl",
        "frames/frame_000001.vtu",
    ] {
        assert!(bench.path("fall.run").join(file).exists(), "{file}");
    }
    assert!(bench.read("fall.run/manifest.json").contains("\"ended\": \"finished\""));
    // The resolved scene is a scene that gives the same result.
    bench
        .run(&["run", "fall.run/scenario.resolved.toml", "--quiet", "--out", "again.run"])
        .expect(0);
    let hash = |run: &str| bench.run(&["hash", run]).expect(0).out;
    assert_eq!(hash("fall.run"), hash("again.run"));
    // Without --out nothing is overwritten.
    bench.run(&["run", "fall.toml", "--quiet"]).expect(0);
    assert!(bench.path("fall-2.run").exists());
}

/// Frames hold what is asked for; a plot of what is left out says so, and a field that does not exist is an error at its name.
#[test]
fn frames_hold_the_fields_that_are_chosen() {
    let bench = Bench::new();
    let scene =
        |keys: &str| FALL.replace("every = \"50 ms\" }", &format!("every = \"50 ms\"{keys} }}"));
    bench.file("some.toml", scene(", fields = [\"velocity\"], contacts = false"));
    bench.file("all.toml", FALL);
    bench.run(&["run", "some.toml", "-q"]).expect(0);
    bench.run(&["run", "all.toml", "-q"]).expect(0);
    let hash = |run: &str| bench.run(&["hash", run]).expect(0).out;
    assert_eq!(hash("some.run"), hash("all.run"));
    let head = |run: &str| {
        let bytes = std::fs::read(bench.path(run).join("frames/frame_000002.vtu")).unwrap();
        String::from_utf8_lossy(&bytes).into_owned()
    };
    let (some, all) = (head("some.run"), head("all.run"));
    for field in ["block", "material", "velocity"] {
        assert!(some.contains(&format!("Name=\"{field}\"")), "{field}");
    }
    for field in ["displacement", "held", "stress_normal"] {
        let name = format!("Name=\"{field}\"");
        assert!(all.contains(&name) && !some.contains(&name), "{field}");
    }
    bench.run(&["plot", "some.run", "blocks", "--field", "velocity"]).expect(0);
    bench.run(&["plot", "some.run", "blocks", "--field", "held"]).expect(2).warns(&["held"]);
    bench.file("wrong.toml", scene(", fields = [\"velocity\", \"speed\"]"));
    bench
        .run(&["check", "wrong.toml"])
        .expect(2)
        .warns(&["frames have no field `speed`", "valid fields: block, material, displacement"]);
}

#[test]
fn the_result_does_not_depend_on_the_threads() {
    let bench = Bench::with_scene();
    for (threads, out) in [("1", "one.run"), ("3", "three.run")] {
        bench.run(&["run", "fall.toml", "-q", "--threads", threads, "--out", out]).expect(0);
    }
    let hash = |run: &str| bench.run(&["hash", run]).expect(0).out;
    assert_eq!(hash("one.run"), hash("three.run"));
}

#[test]
fn quiet_runs_say_nothing() {
    let bench = Bench::with_scene();
    let said = bench.run(&["run", "fall.toml", "--quiet"]).expect(0);
    assert_eq!((said.out.as_str(), said.err.as_str()), ("", ""));
}

#[test]
fn old_results_are_kept_unless_forced() {
    let bench = Bench::with_scene();
    bench.run(&["run", "fall.toml", "-q", "--out", "a.run"]).expect(0);
    let said = bench.run(&["run", "fall.toml", "-q", "--out", "a.run"]).expect(2);
    said.warns(&["already contains a run", "--force"]);
    bench.run(&["run", "fall.toml", "-q", "--out", "a.run", "--force"]).expect(0);
    std::fs::create_dir(bench.path("mine")).unwrap();
    bench.file("mine/thesis.txt", "years of work");
    bench.run(&["run", "fall.toml", "-q", "--out", "mine"]).expect(2);
    assert_eq!(bench.read("mine/thesis.txt"), "years of work");
}

#[test]
fn a_failed_check_is_code_1() {
    let bench = Bench::new();
    bench.file("wrong.toml", FALL.replace("-0.5*10*t^2", "-0.5*9*t^2"));
    bench.run(&["run", "wrong.toml"]).expect(1).says(&["FAILED  free fall"]);
    bench
        .run(&["verify", "wrong.toml"])
        .expect(1)
        .says(&["FAILED  wrong.toml: free fall", "0 passed, 1 failed, 0 skipped"]);
}

#[test]
fn verifying_nothing_is_no_success() {
    let bench = Bench::new();
    let checks = FALL.find("[[checks]]").expect("the scene has checks");
    bench.file("bare.toml", &FALL[..checks]);
    bench.run(&["verify", "bare.toml"]).expect(2).warns(&["nothing was verified", "[[checks]]"]);
}

#[test]
fn physics_that_stops_a_run_is_code_1_and_leaves_a_checkpoint() {
    let bench = Bench::new();
    // A step far above the stable one; the check is switched off to get that far.
    let scene = FALL.replace("10 us", "20 ms").replace("0.2 s\" }", "20 s\" }");
    bench.file("wild.toml", scene);
    let said = bench.run(&["run", "wild.toml", "--out", "wild.run"]);
    if said.code == Some(2) {
        // Refused before it began: as good.
        said.warns(&["stable"]);
        return;
    }
    said.expect(1).warns(&["stone", "step"]);
    assert!(bench.read("wild.run/manifest.json").contains("\"ended\": \"unstable\""));
    assert!(!bench.checkpoints("wild.run").is_empty());
}

/// Two bricks, and a time step above the stable one: 2/omega = 0.61 L/c_P = 0.2 ms.
const LONG_STEP: &str = r#"
riprap = 1
title = "too long a step"

[space.spatial]
gravity = "9.81 m/s2"

[materials.rock]
density = "2400 kg/m3"
young = "18 GPa"
poisson = 0.25

[interfaces.default]
elastic = true

[[blocks]]
name = "rock"
material = "rock"
grid.box = { size = ["2 m", "2 m", "2 m"], cell = "1 m" }

[[phases]]
name = "go"
until = { steps = 10 }
time_step = "1 ms"
"#;

#[test]
fn a_step_above_the_stable_one_is_bad_input() {
    let bench = Bench::new();
    bench.file("long.toml", LONG_STEP);
    for verb in ["check", "run"] {
        bench.run(&[verb, "long.toml"]).expect(2).warns(&[
            "long.toml:24:13",
            "phase `go`",
            "stable step",
        ]);
    }
    assert!(!bench.path("long.run").exists());
    bench.file("short.toml", LONG_STEP.replace("1 ms", "0.1 ms"));
    bench.run(&["run", "short.toml"]).expect(0);
}

#[test]
fn results_that_cannot_be_written_are_code_3() {
    let bench = Bench::with_scene();
    bench.file("in_the_way", "a file");
    bench.run(&["run", "fall.toml", "-q", "--out", "in_the_way/a.run"]).expect(3);
    let templates = bench.run(&["new", "--list"]).expect(0).out;
    if let Some(name) = templates.split_whitespace().next() {
        bench.run(&["new", "in_the_way/x", "--template", name]).expect(3);
    }
    bench.run(&["sweep", "fall.toml", "-q", "--out", "in_the_way/a"]).expect(3);
}

#[cfg(unix)]
#[test]
fn ctrl_c_before_the_first_step_quits_at_once() {
    let bench = Bench::in_memory();
    // Large enough that its first checkpoint, picture and step take a while.
    let lattice = include_str!("../../../../scenes/bench/lattice.toml");
    bench.file("lattice.toml", lattice.replace("\"22 m\"", "\"30 m\""));
    let run = bench.start(&["run", "lattice.toml", "--out", "a.run"]);
    bench.wait_for("the folder", || bench.path("a.run/manifest.json").exists());
    run.signal("INT");
    let said = run.end().expect(130).warns(&["stopped before the first step"]);
    // Nobody has it any more: what was saved is gone on with, what was only begun is in nobody's way.
    let one = "phases.timed.until.steps=1";
    let again = ["run", "lattice.toml", "--out", "a.run", "--set", one];
    if !bench.checkpoints("a.run").is_empty() {
        said.warns(&["riprap resume a.run"]);
        bench.run(&again).expect(2).warns(&["--force"]);
        bench.run(&[&again[..], &["--force"]].concat()).expect(0);
    } else {
        said.warns(&["a.run can be reused"]);
        bench.run(&again).expect(0);
    }
}

#[cfg(unix)]
#[test]
fn ctrl_c_leaves_a_checkpoint_and_resume_goes_on() {
    let bench = Bench::with_long_scene();
    let run = bench.start(&["run", "long.toml", "--out", "a.run"]);
    bench.wait_for("a history", || {
        std::fs::metadata(bench.path("a.run/histories.csv")).is_ok_and(|m| m.len() > 2000)
    });
    run.signal("INT");
    let said = run.end().expect(130).warns(&["a checkpoint is in a.run", "riprap resume a.run"]);
    assert!(said.out.contains("stopped after "), "{}", said.out);
    // What can go on has not failed.
    assert!(!said.out.contains("FAILED"), "{}", said.out);
    assert!(bench.read("a.run/manifest.json").contains("\"ended\": \"interrupted\""));
    let before = bench.read("a.run/histories.csv").len();
    let resumed = bench.start(&["resume", "a.run"]);
    bench.wait_for("more history", || bench.read("a.run/histories.csv").len() > before + 2000);
    resumed.signal("TERM");
    resumed.end().expect(130);
}

#[cfg(unix)]
#[test]
fn a_killed_run_resumes_to_the_same_bits() {
    let bench = Bench::new();
    // Long enough to be killed in the middle, short enough to be run twice.
    bench.file("fall.toml", FALL.replace("time = \"0.2 s\"", "time = \"4 s\""));
    bench.run(&["run", "fall.toml", "-q", "--out", "whole.run"]).expect(0);
    let run = bench.start(&["run", "fall.toml", "--out", "died.run"]);
    bench.wait_for("a checkpoint after the first", || bench.checkpoints("died.run").len() > 1);
    run.signal("KILL");
    assert_eq!(run.end().code, None);
    assert!(bench.read("died.run/manifest.json").contains("\"ended\": \"running\""));
    bench.run(&["resume", "died.run"]).expect(0).says(&["done:"]);
    let hash = |run: &str| bench.run(&["hash", run]).expect(0).out;
    assert_eq!(hash("died.run"), hash("whole.run"));
    for file in ["histories.csv", "energy.csv", "events.jsonl", "run.pvd"] {
        let text = |run: &str| bench.read(&format!("{run}/{file}"));
        assert!(text("died.run") == text("whole.run"), "{file} differs");
    }
    bench.run(&["resume", "died.run"]).expect(2).warns(&["has already ended"]);
}

/// A process that dies after its last checkpoint: what dampers do at the end depends on the last phase and its step.
#[test]
fn a_run_resumed_at_its_end_checks_the_same_bits() {
    let scenes = concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenes/verify");
    let last = |balance: &str, unit: &str| {
        format!(
            "\n[[checks]]\nname = \"{balance}\"\nfield = \"energy.{balance}\"\nvalue = \"0 {unit}\"\n\
             absolute = \"1e30 {unit}\"\n"
        )
    };
    let damped = ["phases.p.damping.mass=3 1/s", "phases.p.time_step=1 ms"];
    for (scene, unit, keys) in [
        ("planar/drop_ledger", "J/m", &damped[..]),
        ("spatial-contact/drop_ledger", "J", &damped[..]),
        ("spatial-contact/drop_ledger", "J", &damped[..1]),
        ("spatial-deformable/true_mass", "J", &[]),
    ] {
        let bench = Bench::new();
        let text = std::fs::read_to_string(format!("{scenes}/{scene}.toml")).unwrap();
        let text = [text, last("kinetic", unit), last("damping", unit)].concat();
        bench.file("scene.toml", text);
        let mut words = vec!["run", "scene.toml", "-q", "--out", "end.run"];
        for key in keys {
            words.extend(["--set", key]);
        }
        bench.run(&words);
        let (before, manifest) =
            (bench.read("end.run/checks.jsonl"), bench.read("end.run/manifest.json"));
        assert!(before.lines().count() > 2, "{scene}: {before}");
        let died = manifest.replace("\"ended\": \"finished\"", "\"ended\": \"running\"");
        assert!(died != manifest, "{scene}: {manifest}");
        bench.file("end.run/manifest.json", died);
        bench.file("end.run/checks.jsonl", "");
        bench.run(&["resume", "end.run"]);
        assert_eq!(bench.read("end.run/checks.jsonl"), before, "{scene}");
    }
}

#[test]
fn nothing_to_resume_is_bad_input() {
    let bench = Bench::new();
    bench
        .run(&["resume", "nowhere"])
        .expect(2)
        .warns(&["nowhere does not exist", "needs a run folder"]);
}

/// The cases ran with the value of `--set`, under the names and values of the sweep.
#[test]
fn a_swept_key_cannot_be_set() {
    let bench = Bench::new();
    let sweep = "[sweep]\n\"blocks.stone.velocity\" = [[\"0 m/s\", \"0 m/s\"], [\"1 m/s\", \"0 m/s\"]]\n\n[bisect]";
    bench.file("two.toml", FALL.replace("[bisect]", sweep));
    // By its name, by its number, and a part of it.
    for set in [
        "blocks.stone.velocity=[\"2 m/s\", \"0 m/s\"]",
        "blocks.1.velocity=[\"2 m/s\", \"0 m/s\"]",
        "blocks.stone.velocity.0=2 m/s",
    ] {
        bench.run(&["sweep", "two.toml", "--set", set]).expect(2).warns(&[
            "fixes what the scene varies",
            "blocks.stone.velocity",
            "--set blocks.",
        ]);
        assert!(!bench.path("two.sweep").exists());
    }
    bench
        .run(&["sweep", "two.toml", "--set", "interfaces.default.friction_angle=20 deg", "-q"])
        .expect(0);
}

/// Where a run ends, with its velocities, is where another begins that reads its table, and a third that reads that one's.
#[test]
fn final_states_are_a_start() {
    const SPACE: &str = r#"
riprap = 1
title = "bricks fly"
[space.spatial]
found_contacts = true
gravity = "10 m/s2"
[materials.rock]
density = "2000 kg/m3"
[interfaces.default]
normal_stiffness = "100 MPa/m"
friction_angle = "30 deg"
[[blocks]]
name = "brick"
material = "rock"
brick = { size = ["1 m", "2 m", "3 m"], corner = ["0 m", "0 m", "50 m"] }
copies = { count = 2, step = ["10 m", "0 m", "0 m"] }
velocity = ["1 m/s", "2 m/s", "3 m/s"]
spin = ["0.5 rad/s", "1 rad/s", "-2 rad/s"]
[[phases]]
name = "fly"
until.time = "0.2 s"
time_step = "0.1 ms"
"#;
    const PLANE: &str = r#"
riprap = 1
title = "a stone flies"
[space.planar]
gravity = ["0 m/s2", "-10 m/s2"]
[materials.rock]
density = "2000 kg/m3"
[interfaces.default]
normal_stiffness = "100 MPa/m"
friction_angle = "30 deg"
[[blocks]]
name = "stone"
material = "rock"
rectangle = { size = ["1 m", "2 m"], corner = ["0 m", "0 m"] }
velocity = ["1 m/s", "2 m/s"]
spin = "-2 rad/s"
[[phases]]
name = "fly"
until.time = "0.2 s"
time_step = "0.1 ms"
"#;
    let bench = Bench::new();
    let rows = |run: &str| -> Vec<Vec<f64>> {
        let table = bench.read(&format!("{run}/final_states.csv"));
        let numbers = |line: &str| line.split(',').skip(1).map(|x| x.parse().unwrap()).collect();
        table.lines().skip(1).map(numbers).collect()
    };
    for (name, text, count) in [("space", SPACE, 2), ("plane", PLANE, 1)] {
        bench.file("whole.toml", text.replace("0.2 s", "0.6 s"));
        bench.run(&["run", "whole.toml", "-q", "--out", &format!("{name}.whole")]).expect(0);
        bench.file("first.toml", text);
        bench.run(&["run", "first.toml", "-q", "--out", &format!("{name}.1")]).expect(0);
        for k in [1, 2] {
            let start = format!("[start]\ncsv = \"{name}.{k}/final_states.csv\"\n");
            bench.file("next.toml", text.replace("[[phases]]", &format!("{start}[[phases]]")));
            let out = format!("{name}.{}", k + 1);
            bench.run(&["run", "next.toml", "-q", "--out", &out]).expect(0);
        }
        let (whole, parts) = (rows(&format!("{name}.whole")), rows(&format!("{name}.3")));
        assert_eq!((whole.len(), parts.len()), (count, count), "{name}");
        for (a, b) in whole.iter().flatten().zip(parts.iter().flatten()) {
            assert!((a - b).abs() < 2e-4, "{name}: {whole:?} {parts:?}");
        }
    }
    let asked = |csv: &str, words: &[&str]| {
        bench.file("states.csv", csv);
        let start = "[start]\ncsv = \"states.csv\"\n[[phases]]";
        bench.file("next.toml", SPACE.replace("[[phases]]", start));
        bench.run(&["check", "next.toml"]).expect(2).warns(words);
    };
    asked("block,x_m\nbrick.1,3\n", &["no column `y_m`", "x_m, y_m, z_m"]);
    asked(
        "block,vx_m_s,vy_m_s,vz_m_s\nbrick,3,0,0\n",
        &["name blocks that this scene does not have", "the first is `brick`"],
    );
    asked("block,qw,qx,qy,qz\nbrick.1,1,1,0,0\n", &["length 1.41"]);
    asked(
        "block,vx_m_s,vy_m_s,vz_m_s\nbrick.1,3,0,0\nbrick.1,4,0,0\n",
        &["two states", "rows 1 and 2"],
    );
    asked("block,colour\nbrick.1,3\n", &["has no column with a state of blocks"]);
    asked("name,x_m,y_m,z_m\nbrick.1,3,0,0\n", &["no column `block`"]);
}
