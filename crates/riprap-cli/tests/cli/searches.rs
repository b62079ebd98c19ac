//! Searches for a limit, a factor or a key, and the errors of what they find.

use super::bench::{Bench, FALL};

#[test]
fn bisect_finds_the_limit() {
    let bench = Bench::with_scene();
    // v^2 = v0^2 + 2 g h with h = 0.2 m: 6 m/s are reached from v0 = 5.66 m/s.
    let said = bench.run(&["bisect", "fall.toml", "--json"]).expect(0);
    let last: serde_json::Value =
        serde_json::from_str(said.out.lines().last().unwrap_or("")).expect("JSON");
    let limit = last["limit"].as_f64().expect("a limit");
    assert!((-7.5..-4.5).contains(&limit), "{limit}");
    // Every case has its own limit: v0 = 2.83 m/s at seven times the gravity.
    let heavy =
        "[variants.heavy]\n\"space.planar.gravity\" = [\"0 m/s2\", \"-70 m/s2\"]\n\n[bisect]";
    bench.file("cases.toml", FALL.replace("[bisect]", heavy));
    let limit_of = |case: &str| {
        let said = bench.run(&["bisect", "cases.toml", "--json", "--case", case]);
        let said = said.expect(0);
        let last: serde_json::Value =
            serde_json::from_str(said.out.lines().last().unwrap_or("")).expect("JSON");
        last["limit"].as_f64().expect("a limit")
    };
    assert_eq!(limit_of("default"), limit);
    assert!((-4.0..-1.5).contains(&limit_of("heavy")));
    bench.run(&["bisect", "cases.toml", "--case", "light"]).expect(2).warns(&["valid cases:"]);
    bench.file("none.toml", FALL.split("[bisect]").next().unwrap_or_default());
    bench.run(&["bisect", "none.toml"]).expect(2).warns(&["no [bisect] table"]);
}

#[test]
fn safety_finds_the_factor_and_leaves_a_run_of_the_mechanism() {
    let bench = Bench::new();
    bench.file("stone.toml", STONE);
    let said = bench.run(&["safety", "stone.toml", "--width", "0.02"]).expect(0);
    assert!(said.out.contains("factor of safety: 1.4"), "{}", said.out);
    assert!(
        said.out.contains("mechanism: 1 block slides or falls without rotation: stone"),
        "{}",
        said.out
    );
    for file in ["safety.csv", "safety.json", "mechanism.run/manifest.json"] {
        assert!(bench.path("stone.safety").join(file).exists(), "{file}");
    }
    bench.run(&["safety", "stone.toml", "--out", "stone.safety"]).expect(2);
    bench
        .run(&["safety", "stone.toml", "--force", "--out", "stone.safety", "--moved", "5 kg"])
        .expect(2)
        .warns(&["length"]);
    bench
        .run(&["safety", "stone.toml", "--interfaces", "plane"])
        .expect(2)
        .warns(&["plane", "default"]);
}

/// On 30 deg with a friction angle of 40 deg: F = 1.4534.
const STONE: &str = r#"
riprap = 1
title = "A stone on a slope"
[space.planar]
gravity = ["0 m/s2", "-9.81 m/s2"]
tilt = "30 deg"
[materials.rock]
density = "2500 kg/m3"
[interfaces.default]
normal_stiffness = "1 GPa/m"
shear_stiffness = "1 GPa/m"
friction_angle = "40 deg"
damping_ratio = 0.2
[[blocks]]
name = "slope"
material = "rock"
rectangle = { size = ["20 m", "1 m"], corner = ["-10 m", "-1 m"] }
[[blocks]]
name = "stone"
material = "rock"
rectangle = { size = ["2 m", "1 m"], corner = ["0 m", "0 m"] }
[[supports]]
on = { block = "slope" }
fixed = {}
[[phases]]
name = "settle"
kind = "static"
until = { unbalanced = 1e-6, steps = 50000 }
"#;

#[test]
fn trust_gives_each_result_its_error() {
    let bench = Bench::with_scene();
    let said = bench.run(&["trust", "fall.toml", "--without", "stiffness,damping"]).expect(0);
    said.says(&[
        "free fall: -",
        "expected",
        ": inside",
        "not varied: size",
        "fall.trust/trust.csv",
    ]);
    for (file, head) in [
        ("fall.trust/trust.csv", "result,unit,as_run,value,error,low,high,error_step"),
        ("fall.trust/trials.csv", "cause,factor,steps,seconds,note,free fall"),
    ] {
        assert!(bench.read(file).starts_with(head), "{}", bench.read(file));
    }
    let json = bench.run(&["trust", "fall.toml", "--json", "--out", "other"]).expect(0);
    let last: serde_json::Value =
        serde_json::from_str(json.out.lines().last().unwrap_or("")).expect("JSON");
    // Five centimetres of free fall in a tenth of a second.
    let value = last["results"][0]["value"].as_f64().expect("a value");
    assert!((value + 0.05).abs() < 1e-6, "{value}");
    bench
        .run(&["trust", "fall.toml", "--without", "steps"])
        .expect(2)
        .warns(&["valid names: step"]);
    bench
        .run(&["trust", "fall.toml", "--budget", "10 m"])
        .expect(2)
        .warns(&["is not a valid time"]);
    let model = FALL.split("[[outputs]]").next().expect("the model");
    bench.file("bare.toml", model);
    bench.run(&["trust", "bare.toml"]).expect(2).warns(&["no named result", "history"]);
    bench.run(&["run", "bare.toml", "--trust"]).expect(2).warns(&["no named result"]);
    assert!(!bench.path("bare.trust").exists() && !bench.path("bare.run").exists());
}

#[test]
fn runs_and_searches_give_their_results_an_error_too() {
    let bench = Bench::with_scene();
    let left = "--without=stiffness,damping";
    bench.run(&["run", "fall.toml", "--trust=1min", left]).expect(0).says(&[
        "results in fall.run",
        "free fall: -",
        " +- ",
        "fall.run/trust.csv",
    ]);
    assert!(bench.read("fall.run/trust.json").contains("\"shown\": \"-"));
    bench.run(&["report", "fall.run"]).expect(0);
    let page = bench.read("fall.html");
    assert!(page.contains("<h2>Errors of the results</h2>"));
    assert!(page.contains("<small>not varied: stiffness (it was left out)</small>"));
    bench.run(&["verify", "fall.toml", "--trust", left]).expect(0).says(&["fall.toml:", " +- "]);
    let key = ["--vary", "blocks.stone.velocity.1", "--range", "-2 m/s..0 m/s"];
    let find = [&["find", "fall.toml", "--until", "free fall = -15 cm", "--trust"], &key[..]];
    bench.run(&find.concat()).expect(0).says(&[
        "blocks.stone.velocity.1 for free fall = -15 cm: -1",
        " +- ",
        "search",
    ]);
    // A range of a key has a result of its own, the table [bisect] has none.
    bench.run(&["find", "fall.toml", "--trust"]).expect(2).warns(&["--trust needs --vary"]);
    bench.run(&["run", "fall.toml", "--trust=much"]).expect(2).warns(&["--trust=10min"]);
    bench
        .run(&["run", "fall.toml", "--trust", "--ranks", "2"])
        .expect(2)
        .warns(&["leave --ranks out"]);
    bench.run(&["run", "fall.toml", left]).expect(2).warns(&["--trust"]);
}

#[test]
fn find_searches_until_a_result_is_as_wanted() {
    let bench = Bench::with_scene();
    let of = |range: &str, until: &str| {
        let key = "blocks.stone.velocity.1";
        bench.run(&["find", "fall.toml", "--vary", key, "--range", range, "--until", until])
    };
    // -0.05 m of free fall and v t: 0.15 m in a tenth of a second from 1 m/s downwards on.
    of("-2 m/s..0 m/s", "free fall = -15 cm")
        .expect(0)
        .says(&["blocks.stone.velocity.1: -1", "trial 1"]);
    of("-2 m/s..0 m/s", "free fall = 1 m").expect(2).warns(&[
        "`free fall` is",
        "at -2 m/s",
        "at 0 m/s",
        "does not lie between them",
    ]);
    of("-2 m/s..0 m/s", "free fell = 1 m").expect(2).warns(&["unknown result", "free fall"]);
    of("-2 m/s..0 m/s", "free fall = 1 kg").expect(2).warns(&["is in m"]);
    of("-2 m/s..0 m/s", "free fall").expect(2).warns(&["is not a condition"]);
}
