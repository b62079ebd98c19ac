//! Plots of a small made-up run: what is written, and what is said when it cannot be.

mod blast;
mod shapes;

use super::*;
use riprap_record::exec::Exec;
use riprap_record::folder::{Existing, RunFolder};
use riprap_record::frame::Frame;
use riprap_record::table::Table;
use riprap_testkit::sample;

fn run(dir: &Path) -> PathBuf {
    let path = dir.join("a.run");
    let manifest = Manifest { title: "two blocks & a contact".to_owned(), ..Manifest::default() };
    let mut run = RunFolder::create(&path, Existing::Refuse, &manifest).unwrap();
    run.begin_histories(&[("slip", "m"), ("opening", "m"), ("unbalanced", "-")]).unwrap();
    run.begin_energy(&[("kinetic", "J/m"), ("bond", "J/m"), ("residual", "J/m")]).unwrap();
    for i in 0..5u32 {
        let t = f64::from(i) * 0.1;
        let slow = (i % 2 == 0).then_some(10f64.powi(-(i as i32)));
        run.history_row(u64::from(i), t, &[Some(t * t), Some(-t), slow]).unwrap();
        run.energy_row(u64::from(i), t, &[5e6 * t, 0.0, 1e-9]).unwrap();
        run.frame(&Frame { time: t, step: u64::from(i), ..sample() }, &Exec::serial()).unwrap();
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
    let files = histories(&folder, &[], None, &dir.path().join("h")).unwrap();
    let names: Vec<_> = files.iter().map(|f| f.file_name().unwrap().to_str().unwrap()).collect();
    assert_eq!(names, ["h.svg", "h.png", "h_data.csv"]);
    let text = svg(&files[0]);
    assert!(text.contains("two blocks &amp; a contact") && text.contains("10⁻⁴"), "{text}");
    assert_eq!(text.matches("<polyline").count(), 3);
    let numbers = Table::read(&files[2]).unwrap();
    assert_eq!(numbers.column("slip").unwrap().values[4], 0.4 * 0.4);
    assert!(numbers.column("unbalanced").unwrap().values[1].is_nan());
    let one =
        histories(&folder, &["slip [m]".to_owned()], None, &dir.path().join("one.svg")).unwrap();
    assert_eq!(svg(&one[0]).matches("<polyline").count(), 1);
}

#[test]
fn a_history_is_drawn_over_another() {
    let dir = tempfile::tempdir().unwrap();
    let folder = run(dir.path());
    let out = dir.path().join("path.svg");
    let files = histories(&folder, &["opening".to_owned()], Some("slip"), &out).unwrap();
    assert!(svg(&files[0]).contains("slip [m]"), "{}", svg(&files[0]));
    let numbers = Table::read(&files[1]).unwrap();
    let names: Vec<&str> = numbers.columns.iter().map(|c| c.name.as_str()).collect();
    assert_eq!(names, ["slip", "opening"]);
    // All the others, when none is named.
    let files = histories(&folder, &[], Some("slip"), &out).unwrap();
    let numbers = Table::read(&files[1]).unwrap();
    let names: Vec<&str> = numbers.columns.iter().map(|c| c.name.as_str()).collect();
    assert_eq!(names, ["slip", "opening", "unbalanced"]);
    let unknown = histories(&folder, &[], Some("slipp"), &out).unwrap_err();
    assert!(unknown.to_string().contains("slip"), "{unknown}");
}

#[test]
fn energy_has_its_residual_apart_and_spares_nil_terms() {
    let dir = tempfile::tempdir().unwrap();
    let folder = run(dir.path());
    let before = std::fs::read(folder.join("energy.csv")).unwrap();
    let files = energy(&folder, &folder.join("energy.svg")).unwrap();
    assert_eq!(std::fs::read(folder.join("energy.csv")).unwrap(), before, "the run's own table");
    let text = svg(&files[0]);
    assert_eq!(text.matches("clipPath id=\"panel").count(), 2);
    assert!(text.contains("10⁶ J/m") && text.contains("residual") && !text.contains("bond"));
    assert!(Table::read(&files[1]).unwrap().column("bond").is_ok());
}

#[test]
fn outlines_keep_their_aspect() {
    let dir = tempfile::tempdir().unwrap();
    let folder = run(dir.path());
    let options = BlockOptions { contacts: true, ..BlockOptions::default() };
    let files =
        blocks(&folder, Which::Last, "block.displacement", options, &dir.path().join("b")).unwrap();
    let text = svg(&files[0]);
    assert!(text.contains("displacement magnitude [m]") && text.contains("t = 0.4 s"), "{text}");
    // Block 1 is 2 m wide and 1 m high.
    let line = text.lines().find(|l| l.starts_with("<polygon")).unwrap();
    let list = line.split('"').nth(1).unwrap();
    let p: Vec<Vec<f64>> =
        list.split(' ').map(|p| p.split(',').map(|v| v.parse().unwrap()).collect()).collect();
    let (w, h) = (p[1][0] - p[0][0], p[1][1] - p[2][1]);
    assert!((w / h - 2.0).abs() < 1e-3, "{w} {h}");
    let numbers = Table::read(files.last().unwrap()).unwrap();
    assert_eq!(numbers.column("displacement magnitude").unwrap().values, vec![0.1, 0.5]);
    assert_eq!(numbers.column("x").unwrap().values[0], 1.0);
    let all: Vec<Which> = (1..=5).map(Which::Index).collect();
    let files = strip(&folder, &all, "rotation", options, &dir.path().join("s.svg")).unwrap();
    assert_eq!(svg(&files[0]).matches("<polygon").count(), 10);
}

#[test]
fn errors_say_what_there_is() {
    let dir = tempfile::tempdir().unwrap();
    let folder = run(dir.path());
    let out = dir.path().join("x.svg");
    let text = |e: Result<Vec<PathBuf>, PlotError>| e.unwrap_err().to_string();
    let o = BlockOptions::default();
    let e = text(histories(&folder, &["slipp".to_owned()], None, &out));
    assert!(e.contains("did you mean `slip`?"), "{e}");
    let e = text(blocks(&folder, Which::Last, "displacment.x", o, &out));
    assert!(e.contains("did you mean `displacement`?") && e.contains("rotation"), "{e}");
    assert!(text(blocks(&folder, Which::Last, "rotation.x", o, &out)).contains("write `rotation`"));
    assert!(text(blocks(&folder, Which::Index(0), "rotation", o, &out)).contains("frames 1 to 5"));
    // A run without stress in its frames says so, and not how to ask for a part of it.
    let e = text(blocks(&folder, Which::Last, "stress_normal", o, &out));
    assert!(e.contains("no field `stress_normal`"), "{e}");
    assert!(text(blocks(&folder, Which::Index(6), "rotation", o, &out)).contains("frames 1 to 5"));
    assert!(text(energy(&folder, &dir.path().join("x.eps"))).contains(".svg, .png or .pdf"));
    assert!(text(energy(dir.path(), &out)).contains("is this a run folder?"));
    assert!(text(energy(&folder, &dir.path().join("no/x.svg"))).contains("could not write"));
    assert!(!out.exists());
    let empty = dir.path().join("empty.run");
    RunFolder::create(&empty, Existing::Refuse, &Manifest::default()).unwrap();
    assert!(text(blocks(&empty, Which::Last, "rotation", o, &out)).contains("has no frames"));
    assert!(text(histories(&empty, &[], None, &out)).contains("histories.csv"));
}

#[test]
fn comparison_interpolates_the_reference() {
    let dir = tempfile::tempdir().unwrap();
    let computed =
        Line { name: "computed".to_owned(), x: vec![0.0, 0.5, 2.0], y: vec![0.0, 1.5, 9.0] };
    let reference = Line { name: "formula".to_owned(), x: vec![0.0, 1.0], y: vec![0.0, 2.0] };
    let labels = Labels {
        title: "slip".to_owned(),
        x: ("time".to_owned(), "s".to_owned()),
        y: ("slip".to_owned(), "m".to_owned()),
    };
    let files = compare(&computed, &reference, &labels, &dir.path().join("c")).unwrap();
    let difference = Table::read(&files[2]).unwrap().column("difference").unwrap().values.clone();
    assert_eq!(difference[..2], [0.0, 0.5]);
    assert!(difference[2].is_nan());
    let none = Line { name: "none".to_owned(), x: vec![], y: vec![] };
    assert!(compare(&none, &reference, &labels, &dir.path().join("c")).is_err());
}

#[test]
fn a_window_shows_a_part() {
    let dir = tempfile::tempdir().unwrap();
    let folder = run(dir.path());
    let options = BlockOptions { window: Some([0.0, 0.0, 0.5, 0.25]), ..BlockOptions::default() };
    let out = dir.path().join("w.svg");
    let files = blocks(&folder, Which::Last, "rotation", options, &out).unwrap();
    let text = svg(&files[0]);
    // Twice as wide as high, and larger than the whole: two metres were 2 x 1 of it.
    let clip = text.lines().find(|l| l.contains("clipPath")).unwrap();
    let size = |name: &str| -> f64 {
        let rest = clip.split(&format!(" {name}=\"")).nth(1).unwrap();
        rest.split('"').next().unwrap().parse().unwrap()
    };
    assert!((size("width") / size("height") - 2.0).abs() < 1e-2, "{clip}");
    let polygon = text.lines().find(|l| l.starts_with("<polygon")).unwrap();
    let first = polygon.split('"').nth(1).unwrap();
    let x: Vec<f64> =
        first.split(' ').map(|p| p.split(',').next().unwrap().parse().unwrap()).collect();
    assert!((x[1] - x[0]).abs() > 3.9 * size("width"), "{first}");
}

#[test]
fn a_time_outside_the_run_is_an_error() {
    let dir = tempfile::tempdir().unwrap();
    let folder = run(dir.path());
    let draw = |t: f64| {
        let out = dir.path().join("t.svg");
        blocks(&folder, Which::Time(t), "rotation", BlockOptions::default(), &out)
    };
    // Frames from 0 to 0.4 s; half a frame beyond the end still means the last one.
    assert!(draw(0.44).is_ok() && draw(0.0).is_ok());
    for t in [0.46, -0.06, 9.0, f64::NAN] {
        let said = draw(t).unwrap_err().to_string();
        assert!(said.contains("span t = 0 s to 0.4 s"), "{said}");
    }
}

#[test]
fn arrows_of_flow_begin_at_joints() {
    let mut frame = Frame {
        points: [[0.0, 0.0], [4.0, 0.0], [4.0, 2.0], [0.0, 2.0]].map(|[x, y]| [x, y, 0.0]).to_vec(),
        offsets: vec![0, 4],
        contact_points: vec![[1.0, 1.0, 0.0], [3.0, 1.0, 0.0]],
        ..Frame::default()
    };
    let flows = [[0.0, 2e-6], [1e-6, 0.0]];
    let column = riprap_record::frame::Column::vector("seepage_flow", "m2/s", flows);
    frame.contact_columns = vec![column];
    let longest = arrows::longest(std::slice::from_ref(&frame), Some(Vectors::Flow));
    assert_eq!(longest, 2e-6);
    let mut page = Page::new(400.0, 200.0);
    let pixel = |p: [f64; 2]| [100.0 * p[0], 200.0 - 100.0 * p[1]];
    let size = [400.0, 200.0];
    arrows::draw(&mut page, &frame, Vectors::Flow, longest, &pixel, size);
    let svg = page.svg(&crate::Look::default());
    assert_eq!(svg.matches("<polygon").count(), 2);
    // Upwards from the first joint.
    assert!(svg.contains("x1=\"100.00\" y1=\"100.00\" x2=\"100.00\""), "{svg}");
}

#[test]
fn one_block_that_flies_off_does_not_shorten_the_other_arrows() {
    let mut frame = Frame { offsets: vec![0], ..Frame::default() };
    let mut speeds = vec![[1.0, 0.0]; 200];
    speeds[7] = [0.0, 500.0];
    for k in 0..200 {
        let (x, y) = (f64::from(k % 20), f64::from(k / 20));
        let corners = [[x, y], [x + 1.0, y], [x + 1.0, y + 1.0], [x, y + 1.0]];
        frame.points.extend(corners.map(|[x, y]| [x, y, 0.0]));
        frame.offsets.push(frame.points.len() as u32);
    }
    frame.block_columns = vec![riprap_record::frame::Column::vector("velocity", "m/s", speeds)];
    let frames = [frame];
    let longest = arrows::longest(&frames, Some(Vectors::Velocity));
    assert_eq!(longest, 1.0);
    assert_eq!(arrows::beyond(&frames, Vectors::Velocity, longest), 1);
    let mut page = Page::new(400.0, 200.0);
    let pixel = |p: [f64; 2]| [20.0 * p[0], 200.0 - 20.0 * p[1]];
    arrows::draw(&mut page, &frames[0], Vectors::Velocity, longest, &pixel, [400.0, 200.0]);
    // Each block has its arrow, and none leaves the picture: the stray one is as long as the others.
    let svg = page.svg(&crate::Look::default());
    assert_eq!(svg.matches("<polygon").count(), 200);
    let ends = svg.lines().filter(|l| l.starts_with("<line"));
    let size = |l: &str| -> f64 {
        let v: Vec<f64> =
            l.split('"').skip(1).step_by(2).take(4).map(|v| v.parse().unwrap()).collect();
        (v[2] - v[0]).hypot(v[3] - v[1])
    };
    let sizes: Vec<f64> = ends.map(size).collect();
    let (least, most) =
        sizes.iter().fold((f64::INFINITY, 0.0_f64), |(a, b), v| (a.min(*v), b.max(*v)));
    assert!(least > 0.9 * most, "{least} {most}");
}
