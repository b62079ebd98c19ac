//! Scenario files through the model builder: what parses but cannot be built is refused with its
//! reason at its place, and nothing takes long.

use std::fs;
use std::path::{Path, PathBuf};
use std::time::Duration;

use proptest::prelude::*;
use riprap::model::{Model, build};
use riprap::planar::fields::INFOS;
use riprap::run::cpu::Work;
use riprap::run::engine::Kind;
use riprap::scenario::diagnostic::{Diagnostics, Severity, Source};
use riprap::scenario::language::Space;
use riprap::scenario::{load, parse};

fn files(folder: &str) -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../riprap-scenario/tests/scenarios")
        .join(folder);
    let mut files: Vec<PathBuf> = fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .filter(|path| path.extension().is_some_and(|e| e == "toml"))
        .collect();
    files.sort();
    files
}

fn built(path: &Path) -> Result<Model, Diagnostics> {
    let parsed = load(path, &[])?;
    let kind = match parsed.scenario.space {
        Space::Planar(_) => Kind::Planar,
        Space::Spatial(_) => Kind::Spatial,
    };
    build(&parsed, "default", kind.fields())
}

/// Line and expected text of every `#^` comment; see `riprap-scenario/tests/scenarios/README.md`.
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

#[test]
fn bad_models_are_refused_with_their_message() {
    let files = files("bad-model");
    assert!(files.len() >= 20, "only {} files", files.len());
    let mut wrong = Vec::new();
    for path in files {
        let name = path.file_name().unwrap().to_string_lossy().into_owned();
        let wanted = expectations(&fs::read_to_string(&path).unwrap());
        assert!(!wanted.is_empty(), "{name} expects nothing");
        // The text itself is in order: only then this is the model's business.
        load(&path, &[]).unwrap_or_else(|error| panic!("{name} does not parse\n{error}"));
        let start = Work::begin();
        let Err(found) = built(&path) else {
            wrong.push(format!("{name} was accepted"));
            continue;
        };
        let long = start.done() > Duration::from_secs(5);
        if long || found.errors() > 3 {
            wrong.push(format!("{name}: {:?}\n{found}", start.done()));
        }
        for (line, expected) in wanted {
            let said = found.list.iter().any(|one| {
                let alone = Diagnostics { source: Source::default(), list: vec![one.clone()] };
                let at = one.span.as_ref().map(|s| found.source.line_column(s.start).0);
                at == Some(line) && alone.render().contains(&expected)
            });
            if !said {
                wrong.push(format!("{name}: not \"{expected}\" at line {line}\n{found}"));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn good_files_that_name_no_missing_file_are_built() {
    for path in files("good") {
        match built(&path) {
            Ok(model) => assert!(model.summary.blocks > 0),
            Err(found) => {
                let mut errors = found.list.iter().filter(|one| one.severity == Severity::Error);
                let missing = errors.all(|one| one.code == "file.csv");
                assert!(missing, "{}\n{found}", path.display());
            }
        }
    }
}

const HEAD: &str = r#"
riprap = 1
title = "large"
units = "SI"
space.planar.gravity = [0, -9.81]
materials.rock.density = 2600
interfaces.default = { normal_stiffness = 1e10, friction_angle = 0.5 }
phases = [{ name = "go", until = { steps = 1 } }]
"#;

/// Builds from text and gives the seconds it took.
fn timed(blocks: &str) -> (Result<Model, Diagnostics>, f64) {
    let start = Work::begin();
    let parsed = parse(Source::new("large.toml", format!("{HEAD}{blocks}"))).unwrap();
    let result = build(&parsed, "default", INFOS);
    (result, start.done().as_secs_f64())
}

#[test]
fn large_models_are_built_in_seconds() {
    let (wall, seconds) = timed(
        "[[blocks]]\nname = \"wall\"\nmaterial = \"rock\"\n\
         wall = { corner = [0, 0], block = [0.4, 0.2], courses = 100, per_course = 100, half_blocks = true }\n",
    );
    let wall = wall.unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(wall.setup.planar().unwrap().blocks.len(), 100 * 100 + 50);
    assert!(seconds < 20.0, "{seconds} s");
    let (slope, seconds) = timed(
        "[[blocks]]\nname = \"slope\"\nmaterial = \"rock\"\n[blocks.cut]\n\
         region = [[0, 0], [100, 0], [100, 20], [60, 80], [0, 80]]\nsmallest_edge = 0.1\n\
         joint_sets = [{ dip = 1.1, spacing = 1.5, spacing_scatter = 0.2, angle_scatter = 0.03 }, \
         { dip = -0.4, spacing = 2.0, persistence = 0.8, trace_length = 15, spacing_scatter = 0.2 }]\n",
    );
    let slope = slope.unwrap_or_else(|error| panic!("{error}"));
    assert!(
        slope.setup.planar().unwrap().blocks.len() > 1000,
        "{}",
        slope.setup.planar().unwrap().blocks.len()
    );
    assert!(seconds < 20.0, "{seconds} s");
    assert!((slope.summary.mass / (2600.0 * 6800.0) - 1.0).abs() < 1e-12, "{}", slope.summary.mass);
}

#[test]
fn heaps_of_blocks_in_one_place_end_in_time() {
    let (result, seconds) = timed(
        "[[blocks]]\nname = \"heap\"\nmaterial = \"rock\"\n\
         rectangle = { size = [1, 1], corner = [0, 0] }\ncopies = { count = 100000, step = [0, 0] }\n",
    );
    assert!(result.unwrap_err().render().contains("coincide"));
    assert!(seconds < 20.0, "{seconds} s");
}

#[test]
fn polygons_with_very_many_corners_end_in_time() {
    let circle = |x: f64| {
        let corner = |k: usize| {
            let angle = std::f64::consts::TAU * k as f64 / 5000.0;
            format!("[{}, {}]", x + angle.cos(), angle.sin())
        };
        (0..5000).map(corner).collect::<Vec<_>>().join(", ")
    };
    let block = |name: &str, x: f64| {
        format!(
            "[[blocks]]\nname = \"{name}\"\nmaterial = \"rock\"\npolygon.points = [{}]\n",
            circle(x)
        )
    };
    let (result, seconds) = timed(&format!("{}{}", block("a", 0.0), block("b", 0.1)));
    assert!(result.unwrap_err().render().contains("overlap"));
    assert!(seconds < 20.0, "{seconds} s");
}

/// Texts to put in place of numbers.
const SILLY: &[&str] =
    &["0", "-1", "1e-300", "1e300", "1e-12", "1e12", "123456789", "-0.5", "1", "0.999999"];

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]
    /// Whatever numbers stand in a scenario: an answer, soon.
    #[test]
    fn silly_numbers_get_an_answer(changes in prop::collection::vec((any::<prop::sample::Index>(), any::<prop::sample::Index>()), 1..4)) {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../riprap-scenario/tests/scenarios/good/everything.toml");
        let mut text = fs::read_to_string(path).unwrap();
        for (place, value) in changes {
            let numbers: Vec<(usize, usize)> = numbers(&text);
            let (start, end) = numbers[place.index(numbers.len())];
            text.replace_range(start..end, SILLY[value.index(SILLY.len())]);
        }
        let tables = tables();
        let start = Work::begin();
        if let Ok(mut parsed) = parse(Source::new("silly.toml", text.clone())) {
            parsed.folder = tables.path().to_owned();
            let _ = build(&parsed, "default", INFOS);
        }
        prop_assert!(start.done() < Duration::from_secs(20), "{:?}\n{text}", start.done());
    }
}

/// A folder with the tables that the scenario names.
fn tables() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("block.csv"), "x_m,y_m\n20,0\n21,0\n20,1\n").unwrap();
    fs::write(folder.path().join("quake.csv"), "t_s,a_m_s2\n0,0\n1,1\n").unwrap();
    folder
}

/// Places of the numbers in the blocks of a text.
fn numbers(text: &str) -> Vec<(usize, usize)> {
    let from = text.find("[[blocks]]").unwrap_or(0);
    let mut found = Vec::new();
    let bytes = text.as_bytes();
    let mut at = from;
    while at < bytes.len() {
        let alone = at == 0 || !(bytes[at - 1].is_ascii_alphanumeric() || bytes[at - 1] == b'_');
        if bytes[at].is_ascii_digit() && alone {
            let start = at;
            while at < bytes.len() && (bytes[at].is_ascii_digit() || bytes[at] == b'.') {
                at += 1;
            }
            found.push((start, at));
        } else {
            at += 1;
        }
    }
    found
}
