//! Plots of a small made-up run: what is written, and what is said when it cannot be.

mod blast;
mod shapes;

use super::*;
use riprap_record::folder::{Existing, RunFolder};
use riprap_record::frame::Frame;
use riprap_record::table::Table;
use riprap_testkit::sample;

fn run(dir: &Path) -> PathBuf {
    let path = dir.join("a.run");
    let manifest = Manifest {
        title: "two blocks & a contact".to_owned(),
        ..Manifest::default()
    };
    let mut run = RunFolder::create(&path, Existing::Refuse, &manifest).unwrap();
    run.begin_histories(&[("slip", "m"), ("opening", "m"), ("unbalanced", "-")])
        .unwrap();
    run.begin_energy(&[("kinetic", "J/m"), ("bond", "J/m"), ("residual", "J/m")])
        .unwrap();
    for i in 0..5u32 {
        let t = f64::from(i) * 0.1;
        let slow = (i % 2 == 0).then_some(10f64.powi(-(i as i32)));
        run.history_row(u64::from(i), t, &[Some(t * t), Some(-t), slow])
            .unwrap();
        run.energy_row(u64::from(i), t, &[5e6 * t, 0.0, 1e-9])
            .unwrap();
        run.frame(&Frame {
            time: t,
            step: u64::from(i),
            ..sample()
        })
        .unwrap();
    }
    path
}

fn svg(path: &Path) -> String {
    std::fs::read_to_string(path).unwrap()
}

#[test]
fn histories_are_grouped_by_unit() {
    let dir = tempfile::tempdir().unwrap();
    let folder = run(dir.path());
    let files = histories(&folder, &[], &dir.path().join("h")).unwrap();
    let names: Vec<_> = files
        .iter()
        .map(|f| f.file_name().unwrap().to_str().unwrap())
        .collect();
    assert_eq!(names, ["h.svg", "h.png", "h_data.csv"]);
    let text = svg(&files[0]);
    assert!(
        text.contains("two blocks &amp; a contact") && text.contains("10⁻⁴"),
        "{text}"
    );
    assert_eq!(text.matches("<polyline").count(), 3);
    let numbers = Table::read(&files[2]).unwrap();
    assert_eq!(numbers.column("slip").unwrap().values[4], 0.4 * 0.4);
    assert!(numbers.column("unbalanced").unwrap().values[1].is_nan());
    let one = histories(
        &folder,
        &["slip [m]".to_owned()],
        &dir.path().join("one.svg"),
    )
    .unwrap();
    assert_eq!(svg(&one[0]).matches("<polyline").count(), 1);
}

#[test]
fn energy_has_its_residual_apart_and_spares_nil_terms() {
    let dir = tempfile::tempdir().unwrap();
    let folder = run(dir.path());
    let before = std::fs::read(folder.join("energy.csv")).unwrap();
    let files = energy(&folder, &folder.join("energy.svg")).unwrap();
    assert_eq!(
        std::fs::read(folder.join("energy.csv")).unwrap(),
        before,
        "the run's own table"
    );
    let text = svg(&files[0]);
    assert_eq!(text.matches("clipPath id=\"panel").count(), 2);
    assert!(text.contains("10⁶ J/m") && text.contains("residual") && !text.contains("bond"));
    assert!(Table::read(&files[1]).unwrap().column("bond").is_ok());
}

#[test]
fn outlines_keep_their_aspect() {
    let dir = tempfile::tempdir().unwrap();
    let folder = run(dir.path());
    let options = BlockOptions {
        contacts: true,
        ..BlockOptions::default()
    };
    let files = blocks(
        &folder,
        Which::Last,
        "block.displacement",
        options,
        &dir.path().join("b"),
    )
    .unwrap();
    let text = svg(&files[0]);
    assert!(
        text.contains("displacement magnitude [m]") && text.contains("t = 0.4 s"),
        "{text}"
    );
    // Block 1 is 2 m wide and 1 m high.
    let line = text.lines().find(|l| l.starts_with("<polygon")).unwrap();
    let list = line.split('"').nth(1).unwrap();
    let p: Vec<Vec<f64>> = list
        .split(' ')
        .map(|p| p.split(',').map(|v| v.parse().unwrap()).collect())
        .collect();
    let (w, h) = (p[1][0] - p[0][0], p[1][1] - p[2][1]);
    assert!((w / h - 2.0).abs() < 1e-3, "{w} {h}");
    let numbers = Table::read(files.last().unwrap()).unwrap();
    assert_eq!(
        numbers.column("displacement magnitude").unwrap().values,
        vec![0.1, 0.5]
    );
    assert_eq!(numbers.column("x").unwrap().values[0], 1.0);
    let all: Vec<Which> = (1..=5).map(Which::Index).collect();
    let files = strip(
        &folder,
        &all,
        "rotation",
        options,
        &dir.path().join("s.svg"),
    )
    .unwrap();
    assert_eq!(svg(&files[0]).matches("<polygon").count(), 10);
}

#[test]
fn errors_say_what_there_is() {
    let dir = tempfile::tempdir().unwrap();
    let folder = run(dir.path());
    let out = dir.path().join("x.svg");
    let text = |e: Result<Vec<PathBuf>, PlotError>| e.unwrap_err().to_string();
    let o = BlockOptions::default();
    let e = text(histories(&folder, &["slipp".to_owned()], &out));
    assert!(e.contains("did you mean `slip`?"), "{e}");
    let e = text(blocks(&folder, Which::Last, "displacment.x", o, &out));
    assert!(
        e.contains("did you mean `displacement`?") && e.contains("rotation"),
        "{e}"
    );
    assert!(text(blocks(&folder, Which::Last, "rotation.x", o, &out)).contains("write `rotation`"));
    assert!(text(blocks(&folder, Which::Index(0), "rotation", o, &out)).contains("frames 1 to 5"));
    assert!(text(blocks(&folder, Which::Index(6), "rotation", o, &out)).contains("frames 1 to 5"));
    assert!(text(energy(&folder, &dir.path().join("x.pdf"))).contains(".svg or .png"));
    assert!(text(energy(dir.path(), &out)).contains("is this a run folder?"));
    assert!(text(energy(&folder, &dir.path().join("no/x.svg"))).contains("could not write"));
    assert!(!out.exists());
    let empty = dir.path().join("empty.run");
    RunFolder::create(&empty, Existing::Refuse, &Manifest::default()).unwrap();
    assert!(text(blocks(&empty, Which::Last, "rotation", o, &out)).contains("has no frames"));
    assert!(text(histories(&empty, &[], &out)).contains("histories.csv"));
}

#[test]
fn comparison_interpolates_the_reference() {
    let dir = tempfile::tempdir().unwrap();
    let computed = Line {
        name: "computed".to_owned(),
        x: vec![0.0, 0.5, 2.0],
        y: vec![0.0, 1.5, 9.0],
    };
    let reference = Line {
        name: "formula".to_owned(),
        x: vec![0.0, 1.0],
        y: vec![0.0, 2.0],
    };
    let labels = Labels {
        title: "slip".to_owned(),
        x: ("time".to_owned(), "s".to_owned()),
        y: ("slip".to_owned(), "m".to_owned()),
    };
    let files = compare(&computed, &reference, &labels, &dir.path().join("c")).unwrap();
    let difference = Table::read(&files[2])
        .unwrap()
        .column("difference")
        .unwrap()
        .values
        .clone();
    assert_eq!(difference[..2], [0.0, 0.5]);
    assert!(difference[2].is_nan());
    let none = Line {
        name: "none".to_owned(),
        x: vec![],
        y: vec![],
    };
    assert!(compare(&none, &reference, &labels, &dir.path().join("c")).is_err());
}
