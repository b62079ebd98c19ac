//! Runs that are not to be believed: they stop, and say why.

use crate::bench::{Bench, FALL, Said};

/// Runs a changed scene of a falling block into `a.run`.
fn run(changes: &[(&str, &str)]) -> (Bench, Said) {
    let bench = Bench::new();
    let mut scene = FALL.to_owned();
    for (old, new) in changes {
        assert!(scene.contains(old), "{old}");
        scene = scene.replace(old, new);
    }
    bench.file("a.toml", scene);
    let said = bench.run(&["run", "a.toml", "--out", "a.run", "-q"]);
    (bench, said)
}

#[test]
fn a_formula_that_is_no_number_is_named_with_its_line() {
    let motion = "motion = { velocity = { x = { formula = \"0.1*log(0.15 - t)\" } } }";
    let (bench, said) = run(&[("fixed = {}", motion)]);
    let said = said.expect(1);
    let said = said.warns(&["`floor`", "velocity along x", "0.1*log(0.15 - t)", "line "]);
    assert!(!said.err.contains("time step"), "{}", said.err);
    // The free fall was over before that, but the run is not what it should have been.
    let checks = bench.read("a.run/checks.jsonl");
    assert!(
        checks.contains("failed") && !checks.contains("passed"),
        "{checks}"
    );
    assert!(checks.contains("before its end"), "{checks}");
}

#[test]
fn numbers_that_overflow_stop_the_run() {
    let still = "velocity = [\"0 m/s\", \"0 m/s\"]";
    let spinning = format!("{still}\nspin = \"1e308 rad/s\"");
    let said = run(&[(still, &spinning)]).1.expect(1);
    said.warns(&["`stone`", "not finite"]);
    // These were panics, exit code 101.
    let dashpot = (
        "time_step = \"10 us\"",
        "time_step = \"10 us\"\ndamping = { stiffness = \"1e308 s\" }",
    );
    let touching = ("\"0.2 m\"]", "\"0 m\"]");
    let heavy = ("2000 kg/m3", "1e300 kg/m3");
    for change in [dashpot, heavy] {
        let said = run(&[change, touching]).1;
        assert!(matches!(said.code, Some(0..=2)), "{said:?}");
    }
}

#[test]
fn a_step_far_above_the_stable_one_stops_the_run_and_is_named() {
    let long = (
        "time_step = \"10 us\"",
        "time_step = \"20 ms\"\nmax_residual = 0.1",
    );
    let touching = ("\"0.2 m\"]", "\"0 m\"]");
    let end = ("time = \"0.2 s\"", "time = \"2 s\"");
    let (bench, said) = run(&[long, touching, end]);
    said.expect(1).warns(&["times the stable one"]);
    assert!(
        bench
            .read("a.run/manifest.json")
            .contains("\"ended\": \"unstable\"")
    );
}

#[test]
fn never_writes_no_frame() {
    let (bench, said) = run(&[("every = \"50 ms\"", "every = \"never\"")]);
    said.expect(0);
    let frames = bench.path("a.run/frames").read_dir().unwrap();
    assert_eq!(frames.count(), 0);
    assert!(!bench.read("a.run/run.pvd").contains("DataSet"));
}

#[test]
fn the_end_of_a_phase_says_why() {
    let (bench, said) = run(&[("time = \"0.2 s\"", "time = \"1 s\", steps = 30")]);
    // The check is read later than that.
    said.expect(1);
    let events = bench.read("a.run/events.jsonl");
    assert!(events.contains("\"reason\":\"steps\""), "{events}");
}
