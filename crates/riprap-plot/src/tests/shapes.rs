//! Stereonets, roses and fragment sizes of made-up runs with known answers.

use super::svg;
use crate::*;
use riprap_geom::Vec3;
use riprap_record::exec::Exec;
use riprap_record::folder::{Existing, RunFolder};
use riprap_record::frame::{BRICK, Column, Frame, Solids, Surfaces};
use riprap_record::manifest::Manifest;
use riprap_record::names::Names;
use riprap_record::table::Table;
use std::path::{Path, PathBuf};

fn folder(dir: &Path, frames: &[Frame]) -> (RunFolder, PathBuf) {
    let path = dir.join("a.run");
    let manifest = Manifest { title: "made up".to_owned(), ..Manifest::default() };
    let mut run = RunFolder::create(&path, Existing::Refuse, &manifest).unwrap();
    for frame in frames {
        run.frame(frame, &Exec::serial()).unwrap();
    }
    (run, path)
}

/// Two bricks of 2 m, their common face turned so that it falls to the east at 30 degrees; a crack of 3 m² that falls to
/// the north at 60 degrees.
fn leaning() -> Frame {
    let angle = 30f64.to_radians();
    let turn = |p: [f64; 3]| {
        let (s, c) = angle.sin_cos();
        [c * p[0] + s * p[2], p[1], -s * p[0] + c * p[2]]
    };
    let mut frame = Frame {
        offsets: vec![0, 8, 16],
        solids: Some(Solids { faces: vec![0; 3], ends: vec![0], corners: vec![] }),
        ..Frame::default()
    };
    for height in [-1.0, 1.0] {
        let corners = BRICK.map(|c| turn([c[0], c[1], c[2] + height]));
        frame.points.extend(corners);
    }
    let along = Vec3::new(0.0, 60f64.to_radians().cos(), -60f64.to_radians().sin());
    let (a, b) = (1.5 * Vec3::X, 2.0 * along);
    frame.cracks = Some(Surfaces {
        ends: vec![4],
        points: [Vec3::ZERO, a, a + b, b].map(|p| p.to_array()).to_vec(),
        columns: vec![
            Column::scalar("area", "m2", vec![3.0]),
            Column::scalar("mode", "-", vec![2.0]),
        ],
    });
    frame
}

#[test]
fn poles_of_a_leaning_joint_and_of_a_crack() {
    let dir = tempfile::tempdir().unwrap();
    let (_run, folder) = folder(dir.path(), &[leaning()]);
    for projection in [Projection::EqualArea, Projection::EqualAngle] {
        let out = dir.path().join("net.svg");
        let files = stereonet(&folder, Which::Last, projection, &out).unwrap();
        let numbers = Table::read(files.last().unwrap()).unwrap();
        let column = |name: &str| numbers.column(name).unwrap().values.clone();
        let close = |got: Vec<f64>, want: [f64; 2]| {
            assert!(
                got.len() == 2 && got.iter().zip(want).all(|(a, b)| (a - b).abs() < 1e-6),
                "{got:?}"
            );
        };
        close(column("dip"), [30.0, 60.0]);
        close(column("dip direction"), [90.0, 0.0]);
        close(column("pole trend"), [270.0, 180.0]);
        close(column("pole plunge"), [60.0, 30.0]);
        close(column("area"), [4.0, 3.0]);
        close(column("kind (0 joint, 1 crack, 2 sheared)"), [0.0, 2.0]);
        let text = svg(&files[0]);
        assert!(text.contains("30\u{b0} / 090\u{b0}") && text.contains("cracks by shear: 1"));
    }
    let files = rose(&folder, Which::Last, &dir.path().join("rose.svg")).unwrap();
    let numbers = Table::read(files.last().unwrap()).unwrap();
    // The joint strikes north-south, the crack east-west.
    assert!((numbers.column("joints").unwrap().values[0] - 4.0).abs() < 1e-9);
    assert!((numbers.column("cracks").unwrap().values[9] - 3.0).abs() < 1e-9);
}

#[test]
fn pictures_of_some_blocks_leave_out_the_others() {
    let dir = tempfile::tempdir().unwrap();
    let sample = || Frame { time: 0.25, ..riprap_testkit::sample() };
    let (run, folder) = folder(dir.path(), &[sample()]);
    let names = ["left", "right"].map(str::to_owned);
    run.write_names(&Names::pack(names, [("rock", &[0_u32, 1][..])])).unwrap();
    let out = dir.path().join("some.svg");
    let drawn = |of: &str| {
        let run = Run { folder: &folder, of: Some(of) };
        strip(run, &[Which::Last], "displacement", BlockOptions::default(), &out)
    };
    let blocks = |of: &str| {
        let files = drawn(of).unwrap();
        assert!(svg(&files[0]).contains(&format!("only {of}")));
        Table::read(files.last().unwrap()).unwrap().column("block").unwrap().values.clone()
    };
    assert_eq!(blocks("rock").len(), 2);
    assert_eq!(blocks("rock and not left"), [1.0]);
    let text = |of: &str| drawn(of).unwrap_err().to_string();
    assert!(text("rock and not (left or right)").contains("there is no block of"));
    assert!(text("rocks").contains("valid groups: rock"));
    // The joint of a block has its neighbour.
    let run = Run { folder: &folder, of: Some("left") };
    assert!(rose(run, Which::Last, &out).unwrap_err().to_string().contains("nothing to plot"));
}

#[test]
fn a_rose_in_the_plane_knows_which_joints_broke() {
    let dir = tempfile::tempdir().unwrap();
    let sample = || Frame { time: 0.25, ..riprap_testkit::sample() };
    let (mut run, folder) = folder(dir.path(), &[sample()]);
    let out = dir.path().join("rose.svg");
    let cracks = || {
        let files = rose(&folder, Which::Last, &out).unwrap();
        let numbers = Table::read(files.last().unwrap()).unwrap();
        let of = |name: &str| numbers.column(name).unwrap().values.clone();
        assert!((of("joints")[9] - 1.0).abs() < 1e-9);
        of("cracks").iter().sum::<f64>()
    };
    assert_eq!(cracks(), 0.0);
    let names = ["left", "right"].map(str::to_owned);
    run.write_names(&Names::pack(names, [])).unwrap();
    for (time, length) in [(0.1, 0.75), (0.3, 0.25)] {
        let blocks = ["right", "left"];
        run.event(&serde_json::json!({
            "event": "joint_broken", "step": 1, "time": time, "blocks": blocks, "length": length,
        }))
        .unwrap();
    }
    // The second one broke after the frame.
    assert_eq!(cracks(), 0.75);
    let text =
        stereonet(&folder, Which::Last, Projection::EqualArea, &out).unwrap_err().to_string();
    assert!(text.contains("in the plane"), "{text}");
}

#[test]
fn fragment_sizes_of_a_known_law() {
    let dir = tempfile::tempdir().unwrap();
    let (_run, folder) = folder(dir.path(), &[]);
    let out = dir.path().join("f");
    let text = |e: Result<Vec<PathBuf>, PlotError>| e.unwrap_err().to_string();
    assert!(text(fragments(&folder, &out)).contains("no fragments.csv"));
    let write = |rows: &[f64]| {
        let mut table = String::from("fragment,blocks,volume_m3,x_m,y_m,z_m\n");
        for (k, v) in rows.iter().enumerate() {
            table += &format!("{},1,{v},0,0,0\n", k + 1);
        }
        std::fs::write(folder.join("fragments.csv"), table).unwrap();
    };
    // As many fragments of each size as a Rosin-Rammler law of x50 = 0.4 m, n = 1.5 has mass there; all below 0.1 m in the first.
    let passing = |x: f64| 1.0 - 0.5f64.powf((x / 0.4).powf(1.5));
    let (mut volumes, mut below) = (Vec::new(), 0.0);
    for k in 0..48 {
        let size = 0.1 * 1.06f64.powi(k);
        let count = ((passing(size) - below) / size.powi(3) * 200.0).round() as usize;
        volumes.extend(std::iter::repeat_n(size.powi(3), count));
        below = passing(size);
    }
    write(&volumes);
    let files = fragments(&folder, &out).unwrap();
    assert_eq!(files.len(), 4);
    let fit = Table::read(&files[3]).unwrap();
    let of = |name: &str| fit.column(name).unwrap().values[0];
    assert!((of("x50") / 0.4 - 1.0).abs() < 0.05, "{}", of("x50"));
    assert!((of("Rosin-Rammler x50") / 0.4 - 1.0).abs() < 0.05);
    assert!((of("Rosin-Rammler n") / 1.5 - 1.0).abs() < 0.1);
    assert!(of("Rosin-Rammler R2") > 0.99 && of("Swebrec R2") > 0.98);
    assert!(svg(&files[0]).contains("Swebrec"));
    write(&[1.0, 1.0]);
    let files = fragments(&folder, &out).unwrap();
    assert!(svg(&files[0]).contains("too few sizes"));
    // What is held does not count; of a group what has a block of it.
    std::fs::write(
        folder.join("fragments.csv"),
        "fragment,blocks,volume_m3,x_m,y_m,z_m,held\n1,2,8,0,0,0,0\n2,1,1,0,0,0,0\n3,1,1000,0,0,0,1\n",
    )
    .unwrap();
    let largest = |group: Option<&str>| {
        let files = fragments(Run { folder: &folder, of: group }, &out).unwrap();
        let fit = files.iter().find(|f| f.to_string_lossy().ends_with("_fit.csv"));
        let table = Table::read(fit.unwrap()).unwrap();
        table.column("largest").unwrap().values[0]
    };
    assert!((largest(None) - 2.0).abs() < 1e-12);
    assert!(
        text(fragments(Run { folder: &folder, of: Some("rock") }, &out))
            .contains("fragment_blocks.csv")
    );
    let members = "block,fragment\n0,3\n1,1\n2,1\n3,2\n4,2\n";
    std::fs::write(folder.join("fragment_blocks.csv"), members).unwrap();
    let blocks = ["ground", "rock.1", "rock.2", "wall", "wall/1"].map(str::to_owned);
    let groups = [("rock", &[1_u32, 2][..]), ("ground", &[0])];
    riprap_record::names::Names::pack(blocks, groups).write(&folder).unwrap();
    assert!((largest(Some("rock")) - 2.0).abs() < 1e-12);
    assert!((largest(Some("wall")) - 1.0).abs() < 1e-12);
    assert!(
        text(fragments(Run { folder: &folder, of: Some("ground") }, &out))
            .contains("with a block of")
    );
    assert!(
        text(fragments(Run { folder: &folder, of: Some("rocks") }, &out))
            .contains("valid groups: rock, ground")
    );
    write(&[]);
    assert!(text(fragments(&folder, &out)).contains("lists no free fragments"));
    std::fs::write(folder.join("fragments.csv"), "fragment,blocks\n1,2\n").unwrap();
    assert!(text(fragments(&folder, &out)).contains("volume_m3"));
}

#[test]
fn tensors_are_drawn_by_component_only() {
    let dir = tempfile::tempdir().unwrap();
    let mut frame = riprap_testkit::sample();
    frame.block_columns.push(Column::vector("stress_normal", "Pa", [[-1e6, -2e6], [3e6, 4e6]]));
    let (_, path) = folder(dir.path(), &[frame]);
    let out = dir.path().join("b");
    let draw = |field| blocks(&path, Which::Last, field, BlockOptions::default(), &out);
    let error = draw("block.stress_normal").unwrap_err().to_string();
    assert!(error.contains("`stress_normal.x` (xx), `stress_normal.y` (yy)"), "{error}");
    assert!(draw("stress_normal.y").is_ok());
}
