//! Pages that the program prints.

use std::fmt::Write as _;
use std::process::Command;

use super::{pages, read, writing};

const HOW: &str = "RIPRAP_WRITE_DOCS=1 cargo test -p riprap-cli --test all docs";

/// What `riprap WORDS` prints, as on a terminal of unknown width.
fn riprap(words: &[&str]) -> String {
    let output = Command::new(env!("CARGO_BIN_EXE_riprap"))
        .args(words)
        .env_remove("COLUMNS")
        .env_remove("LINES")
        .output()
        .expect("start riprap");
    assert!(output.status.success(), "riprap {words:?}");
    String::from_utf8_lossy(&output.stdout).replace("\r\n", "\n")
}

/// Compares a page with what it should be, or writes it.
#[track_caller]
fn page(name: &str, wanted: &str) {
    let path = pages().join(name);
    if writing() {
        std::fs::write(&path, wanted).expect("write a page");
        return;
    }
    let found = read(&path);
    if found == wanted {
        return;
    }
    let differs = found
        .lines()
        .zip(wanted.lines())
        .position(|(a, b)| a != b)
        .unwrap_or_else(|| found.lines().count().min(wanted.lines().count()));
    let line = |text: &str| text.lines().nth(differs).unwrap_or("(end)").to_owned();
    panic!(
        "docs/src/{name} is stale from line {}:\n  page:    {}\n  program: {}\nwrite it anew: {HOW}",
        differs + 1,
        line(&found),
        line(wanted)
    );
}

#[test]
fn the_scenario_reference_is_fresh() {
    let said = riprap(&["schema", "--markdown"]);
    page("scenario-reference.md", &format!("{}\n", said.trim_end()));
}

#[test]
fn the_fields_page_is_fresh() {
    let said = riprap(&["fields", "--json"]);
    let tables: serde_json::Map<String, serde_json::Value> =
        serde_json::from_str(&said).expect("a table of lists");
    let mut text = format!(
        "# Fields\n\nMade from `riprap fields --json`; do not edit, run `{HOW}`.\n\n\
         Histories, checks and criteria name a field. A vector takes `.x`, `.y`, `.magnitude` (in space `.z` too), or a \
         direction `along`; a field of a block can be read `at_point` instead of `of` a block. \
         Signs, counting and reference points of moments: [conventions](conventions.md). \
         The columns of frames are listed in the manifest of each run ([run folder](run-folder.md)).\n"
    );
    for space in ["planar", "spatial"] {
        let fields = tables[space].as_array().expect("a list of fields");
        let _ = write!(text, "\n## [space.{space}]\n");
        fields_of(fields, &mut text);
    }
    page("fields.md", &text);
}

/// The tables of one engine, site by site.
fn fields_of(fields: &[serde_json::Value], text: &mut String) {
    let about = [
        ("block", "One block: `of = \"name\"`."),
        ("pair", "Two blocks, summed over their contacts: `of = [\"first\", \"second\"]`."),
        ("group", "A group of blocks: `of = \"group\"`."),
        ("cavity", "A charge or another cavity: `of = \"source\"`."),
        ("boundary", "A condition on free faces: `of = \"its name\"`."),
        (
            "support",
            "A support: `of = \"its name\"`, without one the block or group that it is on.",
        ),
        ("load", "A load: `of = \"its name\"`, without one the block or group that it is on."),
        ("bolt", "Bolts: `of = \"name\"` of one, or of several alike."),
        ("model", "The whole model; without `of`."),
        ("energy", "The energy ledger; without `of`."),
    ];
    let word =
        |field: &serde_json::Value, key: &str| field[key].as_str().unwrap_or_default().to_owned();
    let mut shown = 0;
    for (site, sentence) in about {
        let mut own = fields.iter().filter(|f| word(f, "site") == site).peekable();
        if own.peek().is_none() {
            continue;
        }
        let _ = write!(
            text,
            "\n### {site}\n\n{sentence}\n\n| field | unit | shape | meaning |\n|---|---|---|---|\n"
        );
        for field in own {
            shown += 1;
            let _ = writeln!(
                text,
                "| `{}` | {} | {} | {} |",
                word(field, "name"),
                word(field, "unit"),
                word(field, "shape"),
                word(field, "meaning")
            );
        }
    }
    assert_eq!(shown, fields.len(), "a field with a site this page lacks");
}

/// Needs no package, only an interpreter: it reads the sources. Without one the page stays as it is.
#[test]
fn the_python_reference_is_fresh() {
    let script = super::repository().join("crates/riprap-py/reference.py");
    let made = ["python3", "python"].iter().find_map(|python| {
        let output = Command::new(python).arg(&script).output().ok()?;
        Some(output)
    });
    let Some(made) = made else {
        println!("there is no Python: the page was not looked at");
        return;
    };
    let said = String::from_utf8_lossy(&made.stderr);
    assert!(made.status.success(), "{}: {said}", script.display());
    let text = String::from_utf8_lossy(&made.stdout).replace("\r\n", "\n");
    page("python-reference.md", &text);
}

/// Verbs as the overview of `riprap --help` lists them.
fn verbs(help: &str) -> Vec<String> {
    help.lines()
        .skip_while(|line| *line != "Commands:")
        .skip(1)
        .take_while(|line| !line.trim().is_empty())
        .filter(|line| line.starts_with("  ") && !line.starts_with("   "))
        .filter_map(|line| line.split_whitespace().next().map(str::to_owned))
        .filter(|verb| verb != "help")
        .collect()
}

#[test]
fn the_command_line_page_is_fresh() {
    let help = |words: &[&str]| {
        let said = riprap(words);
        let lines: Vec<&str> = said.lines().map(str::trim_end).collect();
        lines.join("\n").trim_end().replace("riprap.exe", "riprap")
    };
    let overview = help(&["--help"]);
    let verbs = verbs(&overview);
    assert!(verbs.len() > 10, "verbs found: {verbs:?}");
    let mut text = format!(
        "# Command line\n\nMade from the help texts; do not edit, run `{HOW}`.\n\n```text\n{overview}\n```\n"
    );
    for verb in verbs {
        let _ = write!(text, "\n## riprap {verb}\n\n```text\n{}\n```\n", help(&[&verb, "--help"]));
    }
    page("cli.md", &text);
}
