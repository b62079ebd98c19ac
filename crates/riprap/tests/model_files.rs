//! Scenario files through the model builder: what parses but cannot be built is refused with its
//! reason at its place, and nothing takes long.

use std::fs;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use riprap::model::{Model, build};
use riprap::planar::readings::INFOS;
use riprap::scenario::diagnostic::{Diagnostics, Severity, Source};
use riprap::scenario::{load, parse};

fn files(folder: &str) -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("tests/scenarios")
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
    build(&load(path, &[])?, "default", INFOS)
}

/// Line and expected text of every `#^` comment; see `tests/scenarios/README.md`.
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
        let start = Instant::now();
        let Err(found) = built(&path) else {
            wrong.push(format!("{name} was accepted"));
            continue;
        };
        let long = start.elapsed() > Duration::from_secs(5);
        if long || found.errors() > 3 {
            wrong.push(format!("{name}: {:?}\n{found}", start.elapsed()));
        }
        for (line, expected) in wanted {
            let said = found.list.iter().any(|one| {
                let alone = Diagnostics {
                    source: Source::default(),
                    list: vec![one.clone()],
                };
                let at = one
                    .span
                    .as_ref()
                    .map(|s| found.source.line_column(s.start).0);
                at == Some(line) && alone.render().contains(&expected)
            });
            if !said {
                wrong.push(format!(
                    "{name}: not \"{expected}\" at line {line}\n{found}"
                ));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn good_files_that_name_no_missing_file_are_built() {
    for path in files("good") {
        match built(&path) {
            Ok(model) => assert!(!model.setup.blocks.is_empty()),
            Err(found) => {
                let mut errors = found
                    .list
                    .iter()
                    .filter(|one| one.severity == Severity::Error);
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
    let start = Instant::now();
    let parsed = parse(Source::new("large.toml", format!("{HEAD}{blocks}"))).unwrap();
    let result = build(&parsed, "default", INFOS);
    (result, start.elapsed().as_secs_f64())
}

#[test]
fn large_models_are_built_in_seconds() {
    let (wall, seconds) = timed(
        "[[blocks]]\nname = \"wall\"\nmaterial = \"rock\"\n\
         wall = { corner = [0, 0], block = [0.4, 0.2], courses = 100, per_course = 100, half_blocks = true }\n",
    );
    let wall = wall.unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(wall.setup.blocks.len(), 100 * 100 + 50);
    assert!(seconds < 20.0, "{seconds} s");
    let (slope, seconds) = timed(
        "[[blocks]]\nname = \"slope\"\nmaterial = \"rock\"\n[blocks.cut]\n\
         region = [[0, 0], [100, 0], [100, 20], [60, 80], [0, 80]]\nsmallest_edge = 0.1\n\
         joint_sets = [{ dip = 1.1, spacing = 1.5, spacing_scatter = 0.2, angle_scatter = 0.03 }, \
         { dip = -0.4, spacing = 2.0, persistence = 0.8, trace_length = 15, spacing_scatter = 0.2 }]\n",
    );
    let slope = slope.unwrap_or_else(|error| panic!("{error}"));
    assert!(
        slope.setup.blocks.len() > 1000,
        "{}",
        slope.setup.blocks.len()
    );
    assert!(seconds < 20.0, "{seconds} s");
    assert!(
        (slope.summary.mass / (2600.0 * 6800.0) - 1.0).abs() < 1e-12,
        "{}",
        slope.summary.mass
    );
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
