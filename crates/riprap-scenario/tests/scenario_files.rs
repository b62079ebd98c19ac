//! Good and bad scenario files, generated monsters, and random mutations: no text may make the
//! loader panic, hang or eat memory, and every refusal says what the file's author needs.

use std::fs;
use std::io::{Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use proptest::prelude::*;
use riprap_scenario::diagnostic::{Diagnostics, Source};
use riprap_scenario::{apply_overrides, cases, load, parse};

fn folder(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/scenarios").join(name)
}

fn toml_files(name: &str) -> Vec<PathBuf> {
    let mut files: Vec<PathBuf> = fs::read_dir(folder(name))
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .filter(|path| path.extension().is_some_and(|extension| extension == "toml"))
        .collect();
    files.sort();
    files
}

/// (line, text) of the `#^` comments; line 0 if there is none above.
fn expectations(text: &str) -> Vec<(usize, String)> {
    let mut above = 0;
    let mut wanted = Vec::new();
    for (index, line) in text.lines().enumerate() {
        match line.strip_prefix("#^ ") {
            Some(expected) => wanted.push((above, expected.trim().to_owned())),
            None => above = index + 1,
        }
    }
    wanted
}

/// All scenes of the repository, those of the benchmarks too, which no step of CI runs.
fn scenes() -> Vec<PathBuf> {
    let mut folders = vec![Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes")];
    let mut scenes = Vec::new();
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|ending| ending == "toml") {
                scenes.push(path);
            }
        }
    }
    scenes.sort();
    scenes
}

#[test]
fn good_files_and_all_scenes_are_accepted() {
    let scenes = scenes();
    assert!(scenes.len() > 100, "only {} scenes", scenes.len());
    for path in toml_files("good").into_iter().chain(scenes) {
        let parsed = load(&path, &[]).unwrap_or_else(|error| panic!("{}\n{error}", path.display()));
        let source = Source::new("case", parsed.source.text.clone());
        for case in cases(&source, &parsed.scenario).unwrap() {
            let text = case.source(&source, &[]).unwrap();
            parse(text).unwrap_or_else(|error| panic!("{} {}\n{error}", path.display(), case.name));
        }
    }
}

#[test]
fn bad_files_are_refused_with_their_message() {
    let files = toml_files("bad");
    assert!(files.len() >= 40, "only {} bad files", files.len());
    let mut wrong = Vec::new();
    for path in files {
        let text = fs::read_to_string(&path).unwrap();
        let wanted = expectations(&text);
        assert!(!wanted.is_empty(), "{} expects nothing", path.display());
        let name = path.file_name().unwrap().to_string_lossy().into_owned();
        let Err(diagnostics) = load(&path, &[]) else {
            wrong.push(format!("{name} was accepted"));
            continue;
        };
        for (line, expected) in wanted {
            let found = diagnostics.list.iter().any(|one| {
                let at = one.span.as_ref().map(|span| diagnostics.source.line_column(span.start).0);
                let alone =
                    Diagnostics { source: diagnostics.source.clone(), list: vec![one.clone()] };
                // A remark about the whole file has no line.
                (line == 0 || at == Some(line) || at.is_none())
                    && alone.render().replace(&format!("#^ {expected}"), "").contains(&expected)
            });
            if !found {
                wrong.push(format!("{name}: not \"{expected}\" at line {line}\n{diagnostics}"));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn bad_files_have_few_remarks() {
    for path in toml_files("bad") {
        if let Err(diagnostics) = load(&path, &[]) {
            assert!(diagnostics.list.len() <= 4, "{}\n{diagnostics}", path.display());
        }
    }
}

fn slope() -> String {
    fs::read_to_string(folder("good").join("slope.toml")).unwrap()
}

/// Loads a text from a file and gives the message of the refusal.
fn refused(bytes: &[u8]) -> String {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("x.toml");
    fs::write(&path, bytes).unwrap();
    let start = Instant::now();
    let message = load(&path, &[]).expect_err("should be refused").render();
    assert!(start.elapsed() < Duration::from_secs(20), "{:?}: {message}", start.elapsed());
    assert!(message.len() < 20_000, "{} bytes of message", message.len());
    message
}

#[test]
fn a_file_of_100_mb_is_refused_without_reading_it() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("huge.toml");
    let mut file = fs::File::create(&path).unwrap();
    file.seek(SeekFrom::Start(100 << 20)).unwrap();
    file.write_all(b"x").unwrap();
    drop(file);
    let start = Instant::now();
    let message = load(&path, &[]).unwrap_err().render();
    assert!(message.contains("larger than 16 MiB"), "{message}");
    assert!(start.elapsed() < Duration::from_millis(500));
}

#[test]
fn what_is_no_scenario_is_refused() {
    let missing = load(Path::new("/nowhere/x.toml"), &[]).unwrap_err().render();
    assert!(missing.contains("cannot read the file"), "{missing}");
    let directory = load(&std::env::temp_dir(), &[]).unwrap_err().render();
    assert!(directory.contains("this is a folder"), "{directory}");

    let mut state = 1u32;
    let rubbish: Vec<u8> = (0..100_000)
        .map(|_| {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (state >> 24) as u8
        })
        .collect();
    assert!(refused(&rubbish).contains("not a text file"));
    assert!(refused(b"\x7fELF\x02\x01\x01\0\0\0\0\0").contains("zero byte"));
    assert!(refused(b"title = \"a\0b\"\n").contains("zero byte"));
    assert!(refused(b"\x89PNG\r\n\x1a\n").contains("not a text file"));
    assert!(refused(b"{ \"json\": true }").contains("not a TOML text"));
    assert!(refused(b"once upon a time").contains("not a TOML text"));
    assert!(refused(b"").contains("is missing"));
    assert!(refused(b"\n\n").contains("is missing"));
    assert!(refused(&[0xef, 0xbb, 0xbf]).contains("is missing"));
}

#[test]
fn deep_nesting_is_refused() {
    for (open, close) in [("[", "]"), ("{ a = ", "}"), ("[[", "]]"), ("a.", "b")] {
        let text = format!("x = {}1{}\n", open.repeat(100_000), close.repeat(100_000));
        let message = refused(text.as_bytes());
        assert!(message.contains("error["), "{message}");
    }
    let deep = format!("x = {}{}\n", "[".repeat(100_000), "]".repeat(100_000));
    assert!(refused(deep.as_bytes()).contains("nested too deeply"));
    let header = format!("[{}b]\nx = 1\n", "a.".repeat(100_000));
    assert!(refused(header.as_bytes()).contains("nested too deeply"));
    let key = format!("{}b = 1\n", "a.".repeat(100_000));
    assert!(refused(key.as_bytes()).contains("nested too deeply"));
    refused("[".repeat(2_000_000).as_bytes());
}

#[test]
fn long_lines_are_refused_with_short_messages() {
    let megabyte = "x".repeat(1 << 20);
    refused(megabyte.as_bytes());
    refused(format!("title = \"{megabyte}").as_bytes());
    refused(format!("{megabyte} = 1\n").as_bytes());
    refused(slope().replace("\"30 deg\"", &format!("\"{megabyte}\"")).as_bytes());
    refused(slope().replace("name = \"block\"", &format!("name = \"{megabyte}\"")).as_bytes());
    refused(
        slope().replace("material = \"rock\"", &format!("material = \"{megabyte}\"")).as_bytes(),
    );
    let many = format!("{}oops = 1\n", "# a\n".repeat(100_000));
    refused(many.as_bytes());
    let unknown: String = (0..100_000).map(|index| format!("k{index} = 1\n")).collect();
    refused(unknown.as_bytes());
    let points = "[\"0 m\", \"0\"], ".repeat(100_000);
    refused(slope().replace("[\"10 m\", \"0 m\"],", &points).as_bytes());
}

#[test]
fn many_blocks_take_no_time_beyond_their_number() {
    let mut text = slope();
    for index in 0..20_000 {
        text += &format!(
            "[[blocks]]\nname = \"b{index}\"\nmaterial = \"rock\"\n\
             rectangle = {{ size = [\"1 m\", \"0.5 m\"], corner = [\"2 m\", \"5 m\"] }}\n\
             [[supports]]\non = {{ block = \"b{index}\" }}\nfixed = {{}}\n"
        );
    }
    let start = Instant::now();
    let parsed = parse(Source::new("a.toml", text)).unwrap();
    assert_eq!(parsed.scenario.blocks.len(), 20_002);
    // Seconds at most; a search through all names for each name would take minutes.
    assert!(start.elapsed() < Duration::from_secs(20), "{:?}", start.elapsed());
    let message = refused("[".repeat(8 << 20).as_bytes());
    assert!(message.contains("too many values"), "{message}");
}

#[test]
fn a_long_formula_is_refused() {
    let text = |formula: &str| {
        slope()
            + "[[checks]]\nname = \"a\"\nfield = \"model.time\"\nrelative = 1.0\nformula = \""
            + formula
            + "\"\n"
    };
    for formula in ["(".repeat(100_000), "-".repeat(100_000), "sin(".repeat(1_000)] {
        assert!(refused(text(&formula).as_bytes()).contains("formula"));
    }
    // Short enough to reach the parser of formulas.
    for formula in ["-".repeat(1_900), "sin ".repeat(450), "1+".repeat(900), "2^".repeat(900)] {
        let _ = parse(Source::new("a.toml", text(&formula)));
    }
}

#[test]
fn a_sweep_cannot_explode() {
    let values: Vec<String> = (0..80).map(|index| format!("\"{index} deg\"")).collect();
    let text = slope()
        + &format!(
            "[sweep]\n\"interfaces.default.friction_angle\" = [{0}]\n\"space.planar.tilt\" = [{0}]\n",
            values.join(", ")
        );
    let parsed = parse(Source::new("a.toml", text)).unwrap();
    let error = cases(&parsed.source, &parsed.scenario).unwrap_err().render();
    assert!(error.contains("more than 1000 cases"), "{error}");
}

#[test]
fn cases_have_names_and_texts() {
    let text = slope()
        + "[sweep]\n\"interfaces.default.friction_angle\" = [\"0 deg\", \"5.5 deg\"]\n\
           [variants.source]\n\"interfaces.default.law\" = \"penetration_potential\"\n\
           [[checks]]\nname = \"a\"\nfield = \"model.time\"\nvalue = \"1 s\"\nrelative = 1.0\n\
           when = { \"interfaces.default.friction_angle\" = [\"5.50 deg\"] }\n";
    let parsed = parse(Source::new("a.toml", text)).unwrap();
    let cases = cases(&parsed.source, &parsed.scenario).unwrap();
    let names: Vec<&str> = cases.iter().map(|case| case.name.as_str()).collect();
    assert_eq!(
        names,
        [
            "default_friction_angle=0deg",
            "default_friction_angle=5.5deg",
            "source_friction_angle=0deg",
            "source_friction_angle=5.5deg"
        ]
    );
    let last = parse(cases[3].source(&parsed.source, &[]).unwrap()).unwrap();
    assert!(last.source.text.contains("law = \"penetration_potential\""));
    assert!(!last.source.text.contains("sweep") && !last.source.text.contains("variants"));
    let angle = last.key_si("interfaces.default.friction_angle").unwrap();
    assert!((angle - 5.5_f64.to_radians()).abs() < 1e-15);
    assert!(last.check_applies(&last.scenario.checks[0]));
    let first = parse(cases[0].source(&parsed.source, &[]).unwrap()).unwrap();
    assert!(!first.check_applies(&first.scenario.checks[0]));
}

#[test]
fn overrides_reach_the_scenario() {
    let path = folder("good").join("slope.toml");
    let set = |key: &str, value: &str| load(&path, &[(key.to_owned(), value.to_owned())]);
    let parsed = set("interfaces.default.friction_angle", "10 deg").unwrap();
    let angle = parsed.scenario.interfaces.get("default").unwrap().friction_angle.as_ref().unwrap();
    assert!((angle.si() - 10.0_f64.to_radians()).abs() < 1e-15);
    let error = set("interfaces.default.friction_angle", "10").unwrap_err().render();
    assert!(error.contains("has no unit"), "{error}");
    let error = set("interfaces.default.frction_angle", "10 deg").unwrap_err().render();
    assert!(error.contains("did you mean `friction_angle`?"), "{error}");
    assert!(set("phases.slide.time_step", "10 us").is_ok());
    assert!(set("blocks.block.rectangle.size.0", "2 m").is_ok());
    assert!(set("units", "SI").is_ok());
    assert!(set("title", "[[[[").is_ok());
    assert!(set("title", &"[".repeat(100_000)).is_ok());
    assert!(set("title", &"[".repeat(1_000_000)).is_err());
    assert!(set(&"a.".repeat(100_000), "1").is_err());
}

/// Nothing that can be done with a text may panic.
fn exercise(text: &str) {
    if let Err(diagnostics) = parse(Source::new("a.toml", text)) {
        let _ = diagnostics.render();
    }
    let source = Source::new("a.toml", text);
    let change = ("blocks.0.name".to_owned(), "x".to_owned());
    if let Err(diagnostics) = apply_overrides(&source, &[change]) {
        let _ = diagnostics.render();
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 256, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn random_bytes_never_panic(bytes in proptest::collection::vec(any::<u8>(), 0..2000)) {
        exercise(&String::from_utf8_lossy(&bytes));
    }

    #[test]
    fn random_texts_never_panic(text in "[\\[\\]{}=\"'.,#a-z0-9 \n\\\\\u{e4}]{0,400}") {
        exercise(&text);
    }

    #[test]
    fn random_units_never_panic(text in "[-+0-9eE.,/*^²³µ°% mskgNPaGradj()1]{0,40}") {
        let _ = riprap_scenario::units::parse(&text);
    }

    #[test]
    fn random_keys_never_panic(text in "[-a-z.*\"\\[\\]0-9_]{0,60}") {
        let _ = riprap_scenario::explain_key(&text);
        let source = Source::new("a.toml", slope());
        let _ = apply_overrides(&source, &[(text.clone(), text)]);
    }

    #[test]
    fn mutations_of_a_good_file_never_panic(
        which in 0usize..1000,
        edits in proptest::collection::vec((any::<usize>(), any::<usize>(), "[\\[\\]{}=\"'.,#a-z0-9 \n-]{0,6}"), 1..6),
    ) {
        let files = toml_files("good");
        let mut text = fs::read_to_string(&files[which % files.len()]).unwrap();
        for (at, length, insert) in edits {
            let mut start = at % (text.len() + 1);
            while !text.is_char_boundary(start) { start -= 1; }
            let mut end = (start + length % 8).min(text.len());
            while !text.is_char_boundary(end) { end += 1; }
            text.replace_range(start..end, &insert);
        }
        exercise(&text);
    }

    #[test]
    fn swapped_lines_never_panic(which in 0usize..1000, a in any::<usize>(), b in any::<usize>()) {
        let files = toml_files("good");
        let text = fs::read_to_string(&files[which % files.len()]).unwrap();
        let mut lines: Vec<&str> = text.lines().collect();
        let (a, b) = (a % lines.len(), b % lines.len());
        lines.swap(a, b);
        exercise(&lines.join("\n"));
    }
}

#[test]
fn a_list_written_as_a_table_is_told_its_brackets() {
    let text = "riprap = 1\ntitle = \"a\"\n[supports]\non.block = \"a\"\n";
    let error = parse(Source::new("a.toml", text)).unwrap_err().render();
    assert!(error.contains("write [[supports]]"), "{error}");
}
