//! What machines and people do to runs: processes that die, files that are damaged or full, two writers, readers that go away.

use std::time::Duration;

use super::bench::{Bench, FALL};

const RIGID: &str = include_str!("../../../../scenes/spatial/bricks.toml");
const DEFORMABLE: &str =
    include_str!("../../../../scenes/verify/spatial-deformable/hybrid_p_wave.toml");

/// A scene without its checks, with another end and a checkpoint every few steps.
fn kept(scene: &str, changes: &[(&str, &str)]) -> String {
    let mut scene = scene.split("[[checks]]").next().unwrap_or_default().to_owned();
    for (old, new) in changes {
        assert!(scene.contains(old), "{old}");
        scene = scene.replace(old, new);
    }
    scene + "\n[[outputs]]\ncheckpoints = { every = \"100 steps\" }\n"
}

/// Numbers that look like chance, the same in every test run.
struct Chance(u64);

impl Chance {
    fn below(&mut self, limit: u64) -> u64 {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) % limit
    }
}

/// Kills a run again and again, at instants that differ each time, and resumes it; in the end it has the bits of an undisturbed one.
fn survives_kills(scene: &str, seed: u64) {
    let bench = Bench::in_memory();
    bench.file("a.toml", scene);
    let run = |out: &'static str| ["run", "a.toml", "--threads", "1", "--out", out];
    bench.run(&run("whole.run")).expect(0);
    let mut chance = Chance(seed);
    let mut kills = 0;
    let mut going = bench.start(&run("died.run"));
    bench.wait_for("a checkpoint", || !bench.checkpoints("died.run").is_empty());
    let said = loop {
        if kills < 6 {
            std::thread::sleep(Duration::from_millis(20 + chance.below(200)));
            going.signal("KILL");
        }
        let said = going.end();
        if said.code.is_some() {
            break said;
        }
        kills += 1;
        going = bench.start(&["resume", "died.run", "--threads", "1"]);
    };
    assert!(matches!(said.code, Some(0 | 2)), "{said:?}");
    assert!(kills > 1, "the run was over too soon to be killed: {kills}");
    let hash = |run: &str| bench.run(&["hash", run]).expect(0).out;
    assert_eq!(hash("died.run"), hash("whole.run"), "after {kills} kills");
    for file in ["energy.csv", "events.jsonl", "run.pvd"] {
        let text = |run: &str| bench.read(&format!("{run}/{file}"));
        assert!(text("died.run") == text("whole.run"), "{file} differs after {kills} kills");
    }
}

#[test]
fn kills_at_any_instant_change_nothing_in_the_plane() {
    survives_kills(
        &kept(
            FALL,
            &[
                ("time = \"0.2 s\"", "time = \"6 s\""),
                ("[[outputs]]\ncheckpoints = { every = \"20 ms\" }\n", ""),
            ],
        ),
        1,
    );
}

#[test]
fn kills_at_any_instant_change_nothing_with_rigid_blocks_in_space() {
    let end = ("until = { unbalanced = 1e-9, steps = 20000 }", "until = { steps = 200000 }");
    survives_kills(&kept(RIGID, &[end]), 2);
}

#[test]
fn kills_at_any_instant_change_nothing_with_deformable_blocks() {
    let end = ("until = { time = \"72 ms\" }", "until = { time = \"200 ms\" }");
    survives_kills(&kept(DEFORMABLE, &[end]), 3);
}

#[test]
fn a_limit_of_file_sizes_is_an_error_of_writing() {
    let bench = Bench::with_scene();
    let program = env!("CARGO_BIN_EXE_riprap");
    // Blocks of 512 bytes or of 1024, as the shell likes: the histories outgrow both.
    let line = format!("ulimit -f 8; exec {program} run fall.toml --out a.run");
    let output = std::process::Command::new("sh")
        .args(["-c", &line])
        .current_dir(bench.path("."))
        .output()
        .unwrap();
    let err = String::from_utf8_lossy(&output.stderr);
    // It was a signal, without a word.
    assert_eq!(output.status.code(), Some(3), "{err}");
    assert!(err.contains("could not write"), "{err}");
}

#[test]
fn a_second_writer_is_refused_and_the_first_goes_on() {
    let bench = Bench::in_memory();
    bench.file("fall.toml", FALL.replace("time = \"0.2 s\"", "time = \"4 s\""));
    bench.run(&["run", "fall.toml", "--out", "alone.run"]).expect(0);
    let first = bench.start(&["run", "fall.toml", "--out", "a.run"]);
    bench.wait_for("the run", || bench.path("a.run/manifest.json").exists());
    for words in [&["run", "fall.toml", "--out", "a.run", "--force"][..], &["resume", "a.run"]] {
        let said = bench.run(words);
        assert!(matches!(said.code, Some(2 | 3)), "{words:?}: {said:?}");
        assert!(said.err.contains("a.run"), "{said:?}");
    }
    first.end().expect(0);
    let hash = |run: &str| bench.run(&["hash", run]).expect(0).out;
    assert_eq!(hash("a.run"), hash("alone.run"));
}

#[test]
fn damaged_checkpoints_are_passed_over_or_named() {
    let bench = Bench::in_memory();
    bench.file("fall.toml", FALL.replace("time = \"0.2 s\"", "time = \"1 s\""));
    bench.run(&["run", "fall.toml", "--out", "whole.run"]).expect(0);
    let whole = bench.run(&["hash", "whole.run"]).expect(0).out;
    let begin = || {
        let run = bench.start(&["run", "fall.toml", "--out", "a.run", "--force"]);
        bench.wait_for("two checkpoints", || bench.checkpoints("a.run").len() > 1);
        run.signal("KILL");
        run.end();
        bench.checkpoints("a.run")
    };
    // The newest: an earlier one serves, and the bits are the same.
    let newest = begin().pop().unwrap();
    let mut bytes = std::fs::read(&newest).unwrap();
    let middle = bytes.len() / 2;
    bytes[middle] ^= 0x10;
    std::fs::write(&newest, bytes).unwrap();
    bench.run(&["resume", "a.run"]).expect(0);
    assert_eq!(bench.run(&["hash", "a.run"]).expect(0).out, whole);
    // All of them.
    for file in begin() {
        std::fs::write(&file, b"not one of ours").unwrap();
    }
    let said = bench.run(&["resume", "a.run"]).expect(2);
    assert!(said.err.contains("a.run"), "{said:?}");
}

/// A run that was killed at a checkpoint of its own.
fn killed(bench: &Bench, scene: &str, out: &str, words: &[&str]) {
    let mut all = vec!["run", scene, "--out", out];
    all.extend_from_slice(words);
    let run = bench.start(&all);
    bench.wait_for("two checkpoints", || bench.checkpoints(out).len() > 1);
    run.signal("KILL");
    run.end();
}

/// Puts the newest checkpoint of one run into the folder of another, in the place of all that are there.
fn put(bench: &Bench, from: &str, to: &str) {
    let newest = bench.checkpoints(from).pop().unwrap();
    for file in bench.checkpoints(to) {
        std::fs::remove_file(file).unwrap();
    }
    let name = newest.file_name().unwrap();
    std::fs::copy(&newest, bench.path(&format!("{to}/checkpoints")).join(name)).unwrap();
}

#[test]
fn a_checkpoint_of_another_scene_is_refused_by_name() {
    let bench = Bench::in_memory();
    let slow = FALL.replace("time = \"0.2 s\"", "time = \"4 s\"");
    bench.file("fall.toml", &slow);
    let other = slow.replace("a block falls", "a stone drops");
    bench.file("drop.toml", other);
    killed(&bench, "fall.toml", "a.run", &[]);
    killed(&bench, "drop.toml", "b.run", &[]);
    put(&bench, "b.run", "a.run");
    let said = bench.run(&["resume", "a.run"]).expect(2);
    for part in ["another scene", "a stone drops", "drop.toml", "a block falls", "fall.toml"] {
        assert!(said.err.contains(part), "no {part:?} in\n{}", said.err);
    }
    // Beside a good one of its own it is passed over, with a word.
    killed(&bench, "fall.toml", "a.run", &["--force"]);
    let foreign = bench.checkpoints("b.run").pop().unwrap();
    let place = bench.path("a.run/checkpoints/checkpoint_000000999999.rck");
    std::fs::copy(&foreign, place).unwrap();
    bench.run(&["resume", "a.run"]).expect(0).warns(&[
        "skipped a checkpoint",
        "a stone drops",
        "is kept as",
    ]);
    let kept = bench.path("a.run/checkpoints/checkpoint_000000999999.rck.aside");
    assert!(std::fs::read(kept).unwrap() == std::fs::read(foreign).unwrap());
}

#[test]
fn a_scene_edited_since_is_told_with_its_keys() {
    let bench = Bench::in_memory();
    let slow = FALL.replace("time = \"0.2 s\"", "time = \"2 s\"");
    bench.file("fall.toml", &slow);
    bench.run(&["run", "fall.toml", "--out", "whole.run"]).expect(0);
    killed(&bench, "fall.toml", "a.run", &[]);
    // A comment changes nothing.
    bench.file("fall.toml", format!("# seen again\n{slow}"));
    let edited =
        slow.replace("2000 kg/m3", "2500 kg/m3").replace("friction_angle = \"30 deg\"\n", "");
    bench.file("fall.toml", edited);
    let said = bench.run(&["resume", "a.run"]).expect(0);
    let said = said.warns(&[
        "fall.toml was edited after the run had started: interfaces.default.friction_angle, materials.rock.density;",
        "values of its checkpoint",
    ]);
    assert!(!said.err.contains("scenario.resolved.toml"), "{}", said.err);
    assert!(bench.read("a.run/manifest.json").contains("materials.rock.density"));
    let hash = |run: &str| bench.run(&["hash", run]).expect(0).out;
    assert_eq!(hash("a.run"), hash("whole.run"));
}

#[test]
fn what_is_not_edited_is_not_told() {
    let bench = Bench::new();
    let slow = FALL.replace("time = \"0.2 s\"", "time = \"2 s\"");
    bench.file("fall.toml", &slow);
    killed(&bench, "fall.toml", "a.run", &["--set", "materials.rock.density=2100 kg/m3"]);
    bench.file("fall.toml", format!("# seen again\n{slow}"));
    let said = bench.run(&["resume", "a.run"]).expect(0);
    assert!(!said.err.contains("edited"), "{}", said.err);
}

#[test]
fn a_checkpoint_of_an_older_format_is_refused_by_number() {
    let bench = Bench::in_memory();
    bench.file("fall.toml", FALL.replace("time = \"0.2 s\"", "time = \"4 s\""));
    killed(&bench, "fall.toml", "a.run", &[]);
    for path in bench.checkpoints("a.run") {
        let mut bytes = std::fs::read(&path).unwrap();
        bytes[8..12].copy_from_slice(&2u32.to_le_bytes());
        std::fs::write(path, bytes).unwrap();
    }
    let said = bench.run(&["resume", "a.run"]).expect(2);
    let now = riprap::record::checkpoint::FORMAT_VERSION;
    let words = format!("format version 2, this riprap reads {now}");
    assert!(said.err.contains(&words), "{}", said.err);
}
