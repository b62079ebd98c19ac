//! Every template of `riprap new` runs.

use super::bench::Bench;

/// A scene that ends after a few steps of each phase and has no checks: those are for its end.
fn short(text: &str) -> String {
    let mut kept = String::new();
    let (mut wanted, mut ended) = (true, false);
    for line in text.lines() {
        if line.starts_with('[') {
            wanted = !["[[checks]]", "[bisect", "[sweep"].iter().any(|head| line.starts_with(head));
            ended = false;
        }
        if !wanted {
            continue;
        }
        if line.starts_with("until") {
            // Several `until.` keys are one end. What flies has no step but that of its time.
            if !ended {
                let time = line
                    .split_once("time = ")
                    .and_then(|(_, rest)| rest.split('"').nth(1))
                    .map_or(String::new(), |time| format!(", time = \"{time}\""));
                kept.push_str(&format!("until = {{ steps = 10{time} }}\n"));
            }
            ended = true;
            continue;
        }
        kept.push_str(line);
        kept.push('\n');
    }
    kept
}

#[test]
fn every_template_runs() {
    let bench = Bench::new();
    let list = bench.run(&["new", "--list"]).expect(0).out;
    let names: Vec<&str> = list.lines().filter_map(|line| line.split_whitespace().next()).collect();
    assert!(names.len() > 10, "{list}");
    for (name, line) in names.into_iter().zip(list.lines()) {
        bench.run(&["new", name, "--template", name]).expect(0);
        let file = format!("{name}.toml");
        let text = std::fs::read_to_string(bench.path(&file)).expect("read the template");
        let said = bench.run(&["check", &file, "--json"]).expect(0).out;
        let found: serde_json::Value = serde_json::from_str(&said).expect("JSON");
        let words: Vec<&str> = line.split_whitespace().collect();
        let blocks = found["model"]["blocks"].to_string();
        let space = if text.contains("[space.planar]") { "plane" } else { "space" };
        assert_eq!(words[1..4], [space, blocks.as_str(), "blocks"], "{line}");
        assert!(words[4].parse::<f64>().is_ok() && words[5] == "s", "{line}");
        bench.file(&file, short(&text));
        let out = format!("{name}.run");
        bench.run(&["run", &file, "--out", &out]).expect(0);
        assert!(bench.path(&out).join("run.pvd").exists(), "{name} left no frames");
    }
}

#[test]
fn the_program_checks_itself_and_its_scenes_where_there_are_none() {
    let bench = Bench::new();
    let said = bench.run(&["self-test"]).expect(0);
    said.says(&[" passed, 0 failed, 0 skipped in 10 scenes"]);
    bench
        .run(&["verify", "--shipped", "implicit/slope.toml"])
        .expect(0)
        .says(&["passed  verify/implicit/slope.toml", "0 failed"]);
    bench.run(&["verify", "--shipped", "implicit/slop.toml"]).expect(2);
}
