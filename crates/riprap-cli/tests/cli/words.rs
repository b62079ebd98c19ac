//! Help texts and wrong words.

use super::bench::{Bench, FALL};

const VERBS: [&str; 21] = [
    "new",
    "check",
    "run",
    "resume",
    "sweep",
    "bisect",
    "safety",
    "compare",
    "probe-contact",
    "verify",
    "plot",
    "view",
    "report",
    "paraview",
    "fields",
    "explain",
    "schema",
    "hash",
    "doctor",
    "completions",
    "man",
];

#[test]
fn help_lists_every_verb_and_the_exit_codes() {
    let said = Bench::new().run(&["--help"]).expect(0);
    for verb in VERBS {
        assert!(said.out.lines().any(|l| l.trim_start().starts_with(verb)), "{verb}\n{}", said.out);
    }
    assert!(said.out.contains("Exit codes:") && said.out.contains("First steps:"));
    assert_eq!(said.err, "");
}

#[test]
fn every_verb_has_a_help_text_with_an_example() {
    let bench = Bench::new();
    for verb in VERBS {
        let said = bench.run(&[verb, "--help"]).expect(0);
        assert!(said.out.contains(&format!("Usage: riprap {verb}")), "{}", said.out);
        if verb != "doctor" {
            assert!(said.out.contains("Example"), "{verb}: {}", said.out);
        }
    }
}

#[test]
fn wrong_words_are_bad_input() {
    let bench = Bench::new();
    let said = bench.run(&["chekc", "a.toml"]).expect(2);
    assert!(said.err.contains("check"), "{}", said.err);
    let said = bench.run(&["run"]).expect(2);
    assert!(said.err.contains("<FILE>"), "{}", said.err);
    let said = bench.run(&["run", "a.toml", "--threads", "none"]).expect(2);
    assert!(said.err.contains("--threads"), "{}", said.err);
    let said = bench.run(&["run", "a.toml", "--set", "x"]).expect(2);
    assert!(said.err.contains("KEY=VALUE"), "{}", said.err);
    bench.run(&[]).expect(2);
}

#[test]
fn negative_values_are_answered_by_what_reads_them() {
    let bench = Bench::with_scene();
    bench.run(&["run", "fall.toml", "-q"]).expect(0);
    for (words, said) in [
        (&["safety", "fall.toml", "--width", "-1"][..], "above zero"),
        (&["safety", "fall.toml", "--balance", "-1"], "above zero"),
        (&["safety", "fall.toml", "--moved", "-1 mm"], "above zero"),
        (&["trust", "fall.toml", "--budget", "-1s"], "budget"),
        (&["removable", "fall.toml", "--factor", "-1"], "positive number"),
        (&["probe-contact", "fall.toml", "--threshold", "-1 mm"], "is not a valid length"),
        (&["run", "fall.toml", "--threads", "-1"], "-1 is not in 1.."),
        (&["plot", "fall.run", "blocks", "--time", "-1 s"], "there is no frame at t = -1 s"),
        (&["plot", "fall.run", "--size", "-5 mm"], "from 1 mm to 100 m"),
        (&["plot", "fall.run", "blocks", "--percentiles", "-1", "2"], "two shares from 0 to 100"),
        (&["muckpile", "fall.run", "--cell", "-1 m"], "cell"),
        (&["strength", "fall.run", "--stress", "height", "--confining", "-5 MPa"], "Pa"),
        (&["strength", "fall.run", "--load", "height", "--area", "-1 m"], "above zero"),
    ] {
        let said_of = bench.run(words).expect(2);
        assert!(!said_of.err.contains("tip:"), "{words:?}: {}", said_of.err);
        said_of.warns(&[said]);
    }
    // Nothing was begun.
    for made in ["fall.safety", "fall.trust", "fall.muckpile"] {
        assert!(!bench.path(made).exists(), "{made}");
    }
    // An option is no value.
    bench.run(&["run", "fall.toml", "--threads", "--force"]).expect(2);
    bench.run(&["check", "fall.toml", "--set", "blocks.stone.velocity.1=-1 m/s"]).expect(0);
}

#[test]
fn the_version_says_package_commit_and_target() {
    let said = Bench::new().run(&["--version"]).expect(0);
    let rest = said
        .out
        .strip_prefix(&format!("riprap {} (commit ", env!("CARGO_PKG_VERSION")))
        .and_then(|rest| rest.strip_suffix(")\n"));
    let (commit, target) = rest.and_then(|r| r.split_once(", ")).expect(&said.out);
    let hex = commit.len() == 12 && commit.chars().all(|c| c.is_ascii_hexdigit());
    assert!(hex || commit == "unknown", "{commit}");
    assert!(target.contains(std::env::consts::ARCH), "{target}");
}

#[test]
fn wrong_verbs_get_a_suggestion() {
    let bench = Bench::new();
    for (word, verb) in [("rnu", "riprap run"), ("solve", "riprap run"), ("fos", "safety")] {
        bench.run(&[word, "a.toml"]).expect(2).warns(&[word, verb]);
    }
}

#[test]
fn resume_says_what_it_wanted() {
    let bench = Bench::with_scene();
    bench.run(&["resume", "fall.toml"]).expect(2).warns(&["is a scene", "riprap run fall.toml"]);
    bench.run(&["run", "fall.toml", "-q"]).expect(0);
    bench.run(&["resume", "fall.toml"]).expect(2).warns(&["riprap resume fall.run"]);
}

#[test]
fn a_name_that_is_nearly_right_is_answered_with_the_right_one() {
    let bench = Bench::with_scene();
    for (words, meant) in [
        (vec!["check", "fall"], "did you mean fall.toml?"),
        (vec!["run", "fal.toml"], "did you mean fall.toml?"),
        (vec!["sweep", "fall"], "did you mean fall.toml?"),
        (vec!["plot", "fall.toml"], "write riprap run fall.toml"),
        (vec!["report", "fall"], "for example riprap report hill.run"),
    ] {
        bench.run(&words).expect(2).warns(&[meant]);
    }
    bench.run(&["run", "fall.toml", "-q"]).expect(0);
    for (words, meant) in [
        (vec!["plot", "fall.run", "blocks", "velocity"], "--by velocity"),
        (vec!["plot", "fall"], "write riprap plot fall.run"),
        (vec!["report", "fall.toml"], "write riprap report fall.run"),
        (vec!["paraview", "fall.toml"], "write riprap paraview fall.run"),
    ] {
        bench.run(&words).expect(2).warns(&[meant]);
    }
}

#[test]
fn doctor_looks_at_all_that_riprap_meets() {
    let bench = Bench::new();
    let said = bench.run(&["doctor"]).expect(0);
    for word in [
        "riprap",
        "build",
        "system",
        "processor",
        "cores",
        "memory",
        "disk",
        "browser",
        "python",
        "devices",
    ] {
        let line = said.out.lines().find(|l| l.split_whitespace().next() == Some(word));
        assert!(line.is_some_and(|l| l.len() > 10), "{word}: {}", said.out);
    }
    assert!(said.out.contains("MB/s written"), "{}", said.out);
    let left = std::fs::read_dir(bench.path(".")).expect("a folder").count();
    assert_eq!(left, 0, "the sample of the disk is gone");
}

/// A pipe whose reader has gone, as that of `| head` does.
fn nobody_reads() -> std::process::Stdio {
    let (reader, writer) = std::io::pipe().expect("a pipe");
    drop(reader);
    writer.into()
}

#[test]
fn a_reader_that_goes_never_makes_a_panic() {
    let bench = Bench::with_scene();
    bench.run(&["run", "fall.toml", "-q"]).expect(0);
    let lines: &[&[&str]] = &[
        &["--help"],
        &["--version"],
        &["rnu"],
        &["new", "--list"],
        &["check", "fall.toml"],
        &["check", "fall.toml", "--json"],
        &["check", "missing.toml"],
        &["run", "fall.toml", "--out", "piped"],
        &["resume", "fall.run"],
        &["sweep", "fall.toml"],
        &["bisect", "fall.toml"],
        &["compare", "fall.toml"],
        &["probe-contact", "fall.toml"],
        &["verify", "fall.toml"],
        &["plot", "fall.run"],
        &["report", "fall.run"],
        &["paraview", "fall.run"],
        &["fields"],
        &["explain", "fall.toml"],
        &["explain", "phases"],
        &["schema"],
        &["hash", "fall.run"],
        &["doctor"],
        &["completions", "bash"],
        &["man"],
    ];
    for words in lines {
        for both in [false, true] {
            let mut command = bench.command(words);
            command.stdout(nobody_reads());
            if both {
                command.stderr(nobody_reads());
            }
            let output = command.output().expect("riprap starts");
            let code = output.status.code();
            // 101 is a panic, none a signal.
            assert!(code.is_some_and(|c| c <= 3), "{words:?} {both}: {code:?}");
            let said = String::from_utf8_lossy(&output.stderr);
            assert!(!said.contains("panicked"), "{words:?}: {said}");
        }
    }
}

#[test]
fn shells_complete_the_verbs() {
    for shell in ["bash", "zsh", "fish", "elvish", "powershell"] {
        let said = Bench::new().run(&["completions", shell]).expect(0);
        for verb in VERBS {
            assert!(said.out.contains(verb), "{shell}: {verb}");
        }
    }
    let said = Bench::new().run(&["completions", "cmd"]).expect(2);
    assert!(said.err.contains("powershell"), "{}", said.err);
}

#[test]
fn every_verb_has_a_manual_page() {
    let bench = Bench::new();
    let said = bench.run(&["man"]).expect(0);
    assert!(said.out.contains(".TH riprap 1"), "{}", said.out);
    bench.run(&["man", "--out", "pages"]).expect(0);
    for verb in VERBS {
        // Hyphens of names are written as minus signs.
        let page = bench.read(&format!("pages/riprap-{verb}.1")).replace("\\-", "-");
        assert!(page.contains(&format!("riprap-{verb}")), "{page}");
    }
}

#[test]
fn a_time_outside_the_run_is_no_frame() {
    let bench = Bench::with_scene();
    bench.run(&["run", "fall.toml", "-q"]).expect(0);
    let blocks = ["plot", "fall.run", "blocks"];
    for (time, code) in [("0.2 s", 0), ("0.21 s", 0), ("9 s", 2), ("-1 s", 2)] {
        let time = format!("--time={time}");
        let said = bench.run(&[&blocks[..], &[&time]].concat()).expect(code);
        assert!(code == 0 || said.err.contains("to 0.2 s"), "{}", said.err);
    }
}

#[test]
fn words_are_explained_by_what_speaks_of_them() {
    let bench = Bench::new();
    bench.run(&["explain", "friction"]).expect(0).says(&[
        "interfaces.*.friction_angle",
        "energy.friction",
        "docs/src/theory-planar.md",
        "scenes/verify/planar/a5_stop.toml",
    ]);
    bench.run(&["explain", "pore", "pressure"]).expect(0);
    bench.run(&["explain", "block.velocity"]).expect(0).says(&["a field of [space.spatial]"]);
    bench.run(&["explain", "nonsense"]).expect(2).warns(&["page or scene contains this word"]);
    bench.run(&["explain", "fricton_angel"]).expect(2).warns(&["friction_angle"]);
    bench.run(&["explain", "phases.fall.utnil"]).expect(2).warns(&["until"]);
}

#[test]
fn comparing_in_space_says_that_it_is_for_the_plane() {
    let bench = Bench::new();
    bench.run(&["new", "bricks", "--template", "bricks"]).expect(0);
    bench
        .run(&["compare", "bricks.toml"])
        .expect(2)
        .warns(&["compare works in the plane", "riprap sweep"]);
    assert!(!bench.path("bricks.compare").exists());
}

#[test]
fn a_wrong_formula_is_shown_at_its_character() {
    let bench = Bench::new();
    let text = FALL.replace("-0.5*10*t^2", "if(t < 1, -5*t^2, 0");
    bench.file("a.toml", &text);
    let said = bench.run(&["check", "a.toml"]).expect(2);
    let line = text.lines().position(|l| l.starts_with("formula")).unwrap() + 1;
    let column = text.lines().nth(line - 1).unwrap().len();
    assert!(said.err.contains("a parenthesis is not closed"), "{}", said.err);
    assert!(said.err.contains(&format!("a.toml:{line}:{column}")), "{}", said.err);
    let chosen = FALL.replace("-0.5*10*t^2", "if(t < 1, -5*min(t, 7)^2, sqrt(-1))");
    bench.file("a.toml", chosen);
    bench.run(&["run", "a.toml", "--out", "a.run"]).expect(0);
}

#[test]
fn gravity_upwards_and_steps_that_follow_nothing_are_warned_of() {
    let bench = Bench::new();
    let change = |old: &str, new: &str| {
        assert!(FALL.contains(old), "{old}");
        bench.file("a.toml", FALL.replace(old, new));
        bench.run(&["check", "a.toml"]).expect(0)
    };
    change("\"-10 m/s2\"]", "\"10 m/s2\"]").warns(&["gravity points up"]);
    let axis = "\"0 m/s2\", \"-10 m/s2\"";
    let said = change(axis, "\"10 m/s2\", \"0 m/s2\"");
    assert!(!said.err.contains("gravity"), "{}", said.err);
    let long = change("time_step = \"10 us\"", "time_step = \"0.1 s\"");
    long.warns(&["`fall` has only 2 steps of 1.000e-1 s"]);
    let whole = "until = { time = \"0.2 s\" }";
    for until in [whole, "until = { steps = 20 }"] {
        change(whole, &format!("{until}\ngravity_ramp = \"1 s\""))
            .warns(&["before its gravity has reached"]);
    }
}

#[test]
fn examples_of_gravity_point_down() {
    let bench = Bench::new();
    let gravity = "[\"0 m/s2\", \"-10 m/s2\"]";
    bench.file("a.toml", FALL.replace(gravity, "\"9.81 m/s2\""));
    let plane = "gravity = [\"0 m/s2\", \"-9.81 m/s2\"]";
    bench.run(&["check", "a.toml"]).expect(2).warns(&[plane]);
    bench.file("b.toml", FALL.replace("space.planar", "space.spatial"));
    let space = "gravity = \"9.81 m/s2\"";
    bench.run(&["check", "b.toml"]).expect(2).warns(&[space]);
}

#[test]
fn explained_keys_are_those_that_set_takes() {
    let bench = Bench::new();
    bench.run(&["new", "tun", "--template", "tunnel"]).expect(0);
    let key = "blocks.left.cut.joint_sets.0.dip";
    let set = format!("{key}=7 deg");
    let said = bench.run(&["explain", "tun.toml", "--set", &set]).expect(0);
    let line = said.out.lines().find(|line| line.starts_with(key));
    assert!(line.is_some_and(|line| line.contains("7 deg")), "{}", said.out);
}
