//! Help texts and wrong words.

use crate::bench::Bench;

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
        assert!(
            said.out.lines().any(|l| l.trim_start().starts_with(verb)),
            "{verb}\n{}",
            said.out
        );
    }
    assert!(said.out.contains("Exit codes:") && said.out.contains("First steps:"));
    assert_eq!(said.err, "");
}

#[test]
fn every_verb_has_a_help_text_with_an_example() {
    let bench = Bench::new();
    for verb in VERBS {
        let said = bench.run(&[verb, "--help"]).expect(0);
        assert!(
            said.out.contains(&format!("Usage: riprap {verb}")),
            "{}",
            said.out
        );
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
fn the_version_is_that_of_the_package() {
    let said = Bench::new().run(&["--version"]).expect(0);
    assert_eq!(said.out, format!("riprap {}\n", env!("CARGO_PKG_VERSION")));
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
        let page = bench
            .read(&format!("pages/riprap-{verb}.1"))
            .replace("\\-", "-");
        assert!(page.contains(&format!("riprap-{verb}")), "{page}");
    }
}
