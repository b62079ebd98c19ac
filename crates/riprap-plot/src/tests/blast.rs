//! Pictures of a made-up blast: bricks around a charge, with fields that have known answers.

use super::svg;
use crate::*;
use riprap_record::exec::Exec;
use riprap_record::folder::{Existing, RunFolder};
use riprap_record::frame::{BRICK, Column, Frame, Solids};
use riprap_record::manifest::{Manifest, Place, Source};
use riprap_record::table::Table;
use std::path::{Path, PathBuf};

/// Edge of the large bricks, m; those near the charge have half of it.
const EDGE: f64 = 0.5;
const DEPTH: f64 = 2.0;
const MASS: f64 = 8.0;
/// Site law that the peak velocities follow without scatter, m/s.
const K: f64 = 1.2;
/// Its exponent.
const N: f64 = 1.6;

/// Uplift of the surface in m: 0.12 m over the charge, falling as exp(-(r / 1.8 m)^2).
fn dome(r: f64, time: f64) -> f64 {
    0.12 * (time / 0.02) * (-(r / 1.8) * (r / 1.8)).exp()
}

/// Centres and edges of bricks: a box of 12 x 12 x 5 m with z = 0 on top, without the eight around the charge.
fn bricks() -> Vec<([f64; 3], f64)> {
    let mut out = Vec::new();
    let places = |n: i32| (-n..n).map(|i| (f64::from(i) + 0.5) * EDGE);
    for x in places(12) {
        for y in places(12) {
            for z in (0..10).map(|k| -(f64::from(k) + 0.5) * EDGE) {
                let near = x.abs().max(y.abs()).max((z + DEPTH).abs()) < 2.0 * EDGE;
                if !near {
                    out.push(([x, y, z], EDGE));
                    continue;
                }
                for c in BRICK {
                    let place = [0, 1, 2].map(|k| [x, y, z][k] + 0.25 * EDGE * c[k]);
                    let far = [place[0], place[1], place[2] + DEPTH].map(f64::abs);
                    if far.iter().any(|d| *d > 0.3 * EDGE) {
                        out.push((place, 0.5 * EDGE));
                    }
                }
            }
        }
    }
    out
}

fn frame(time: f64, step: u64) -> Frame {
    let mut f =
        Frame { step, time, phase: "blast".to_owned(), offsets: vec![0], ..Frame::default() };
    let (mut u, mut v, mut ppv, mut top, mut level) = (vec![], vec![], vec![], vec![], vec![]);
    let mut noise = 1_u64;
    for (c, edge) in bricks() {
        let way = [c[0], c[1], c[2] + DEPTH];
        let r = way.iter().map(|w| w * w).sum::<f64>().sqrt();
        let ground = c[0].hypot(c[1]);
        let outward = way.map(|w| 0.01 * (time / 0.02) * w / r / r.max(0.5));
        let lift = dome(ground, time) * ((c[2] + 4.0) / 4.0).clamp(0.0, 1.0);
        let shift = [outward[0], outward[1], lift];
        for corner in BRICK {
            f.points.push([0, 1, 2].map(|k| c[k] + 0.5 * edge * corner[k] + shift[k]));
        }
        f.offsets.push(f.points.len() as u32);
        noise = noise.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        let scatter = (noise >> 11) as f64 / (1_u64 << 53) as f64 - 0.5;
        let law = K * (r / MASS.sqrt()).powf(-N);
        u.push(shift);
        v.push(way.map(|w| 0.3 * law * w / r));
        ppv.push(law * (0.8 * scatter).exp());
        let cavity_floor = c[2] < -DEPTH && c[2] > -DEPTH - 0.3 && ground < 0.2;
        let above = c[2] + 0.5 * edge > -1e-9;
        top.push(f64::from(u8::from(above || cavity_floor)));
        level.push((EDGE / edge).log2());
    }
    let blocks = f.offsets.len() - 1;
    f.solids = Some(Solids { faces: vec![0; blocks + 1], ends: vec![0], corners: vec![] });
    f.block_columns = vec![
        Column::scalar("block", "-", (0..blocks).map(|i| i as f64).collect()),
        Column::scalar("level", "-", level),
        Column::vector3("displacement", "m", u),
        Column::vector3("rotation", "rad", vec![[0.0; 3]; blocks]),
        Column::vector3("velocity", "m/s", v),
        Column::scalar("peak_speed", "m/s", ppv),
        Column::scalar("surface", "-", top),
    ];
    f
}

/// A run folder with eight frames and the histories of a cavity and a house.
pub(super) fn blast(dir: &Path) -> PathBuf {
    let path = dir.join("blast.run");
    let manifest = Manifest {
        title: "made-up blast".to_owned(),
        sources: vec![Source {
            name: "charge".to_owned(),
            place: Place::Centre([0.0, 0.0, -DEPTH]),
            delay: 0.0,
            mass: Some(MASS),
            charge_volume: Some(0.008),
            cavity_volume: 0.125,
            depth: Some(DEPTH),
        }],
        ..Manifest::default()
    };
    let mut run = RunFolder::create(&path, Existing::Refuse, &manifest).unwrap();
    for k in 1..=8u32 {
        run.frame(&frame(2.5e-3 * f64::from(k), u64::from(k) * 100), &Exec::serial()).unwrap();
    }
    run.begin_histories(&[
        ("charge.pressure", "Pa"),
        ("charge.volume", "m3"),
        ("charge.volume_ratio", "-"),
        ("house.velocity", "m/s"),
    ])
    .unwrap();
    run.begin_energy(&[("kinetic", "J")]).unwrap();
    for i in 0..800u32 {
        let t = 2.5e-5 * f64::from(i);
        let p = 2e9 * ((-900.0 * t).exp() - (-12_000.0 * t).exp()) + 4e8;
        let ratio = 3.1 - 2.1 * (-1500.0 * t).exp();
        let shake = (2.0 * std::f64::consts::PI * 410.0 * t).sin();
        let house = 0.02 * (-((t - 8e-3) / 3e-3).powi(2)).exp() * shake;
        let row = [Some(p), Some(0.125 * ratio), Some(ratio), Some(house)];
        run.history_row(u64::from(i), t, &row).unwrap();
        run.energy_row(u64::from(i), t, &[1.0]).unwrap();
    }
    path
}

fn values(path: &Path, name: &str) -> Vec<f64> {
    Table::read(path).unwrap().column(name).unwrap().values.clone()
}

#[test]
fn a_section_shows_the_blocks_that_the_plane_meets() {
    let dir = tempfile::tempdir().unwrap();
    let folder = blast(dir.path());
    let options = BlockOptions { vectors: Some(Vectors::Velocity), ..BlockOptions::default() };
    let files =
        section(&folder, &[Which::Last], "displacement.z", options, &dir.path().join("s")).unwrap();
    let text = svg(&files[0]);
    // 24 x 10 large bricks; 16 of them are 64 small ones, 4 of which went for the cavity.
    let heads = text.matches("fill=\"#1a1a1a\"/>").count();
    let drawn = text.matches("<polygon").count() - heads;
    assert_eq!(drawn, 240 - 16 + 64 - 4, "{heads} arrows");
    assert!(heads > 50 && text.contains("longest arrow: velocity"));
    assert!(text.contains("section y = 0 m, t = 0.02 s") && text.contains(">z [m]<"));
    let numbers = files.last().unwrap();
    let (x, z) = (values(numbers, "x"), values(numbers, "z"));
    let lift = values(numbers, "displacement, z");
    let top = (0..x.len()).max_by(|a, b| z[*a].total_cmp(&z[*b])).unwrap();
    assert!((lift[top] - dome(0.25f64.hypot(0.25), 0.02) * 0.9375).abs() < 1e-6);
    let plan =
        BlockOptions { normal: Normal::Z, at: Some(-0.25), log: true, ..BlockOptions::default() };
    let files = section(
        &folder,
        &[Which::Index(1), Which::Last],
        "peak_speed",
        plan,
        &dir.path().join("p.svg"),
    )
    .unwrap();
    assert_eq!(values(&files[1], "block").len(), 2 * 576);
    // Blocks twice as far moved as they are; the reference does not change.
    let twice = BlockOptions { exaggeration: Some(2.0), ..BlockOptions::default() };
    let files = blocks(&folder, Which::Last, "level", twice, &dir.path().join("e.svg")).unwrap();
    let moved = values(&files[1], "z");
    assert!(svg(&files[0]).contains("displacements × 2"));
    assert!((moved[top] - z[top] - lift[top]).abs() < 1e-9);
}

#[test]
fn the_site_law_comes_back() {
    let dir = tempfile::tempdir().unwrap();
    let folder = blast(dir.path());
    let files = ppv(&folder, Which::Last, false, &dir.path().join("ppv")).unwrap();
    let fit = files.last().unwrap();
    assert!(fit.ends_with("ppv_fit.csv"));
    let of = |name: &str| values(fit, name)[0];
    assert!((of("n") - N).abs() < 3.0 * of("standard error of n"), "{}", of("n"));
    // Even scatter of width 0.8 has the deviation 0.8 / sqrt(12).
    assert!((of("deviation of ln v") / (0.8 / 12f64.sqrt()) - 1.0).abs() < 0.05);
    assert!((of("K") / (1e3 * K) - 1.0).abs() < 0.02, "{}", of("K"));
    assert_eq!(values(fit, "root"), [2.0, 3.0]);
    let data = files.iter().find(|f| f.ends_with("ppv_data.csv")).unwrap();
    assert_eq!(values(data, "block").len() as f64, of("samples"));
    let surface = ppv(&folder, Which::Last, true, &dir.path().join("surface")).unwrap();
    let count = values(surface.last().unwrap(), "samples")[0];
    assert!(count < 700.0 && svg(&surface[0]).contains("surface blocks"));
}

#[test]
fn the_crater_has_the_radius_of_its_dome() {
    let dir = tempfile::tempdir().unwrap();
    let folder = blast(dir.path());
    let files =
        crater(&folder, Which::Last, CraterOptions::default(), &dir.path().join("c")).unwrap();
    let radius = values(files.last().unwrap(), "crater radius")[0];
    // Of the blocks' centres at 0.25 m below the surface the dome has 0.9375.
    let wanted = 1.8 * (0.12 * 0.9375 / 0.04f64).ln().sqrt();
    assert!((radius / wanted - 1.0).abs() < 0.03, "{radius} {wanted}");
    let text = svg(&files[0]);
    assert!(text.contains("r/W = ") && text.contains("W = 2.00 m"), "{text}");
    for uplift in [0.0, -0.1, f64::NAN] {
        let none = CraterOptions { uplift: Some(uplift), ..CraterOptions::default() };
        let refused = crater(&folder, Which::Last, none, &dir.path().join("n"));
        let text = refused.unwrap_err().to_string();
        assert!(text.contains("uplift cannot be"), "{text}");
    }
    let high = CraterOptions { uplift: Some(0.5), source: Some("charge") };
    let files = crater(&folder, Which::Last, high, &dir.path().join("n.svg")).unwrap();
    assert!(svg(&files[0]).contains("no crater"));
    let files = heave(&folder, &[], None, Normal::Y, &dir.path().join("h")).unwrap();
    assert_eq!(svg(&files[0]).matches("<polyline").count(), 6);
    let x = values(files.last().unwrap(), "x, t = 0.02 s");
    let y = values(files.last().unwrap(), "uplift, t = 0.02 s");
    assert_eq!(x.len(), 24);
    let middle = x.iter().position(|x| (*x - 0.25).abs() < 1e-9).unwrap();
    assert!((y[middle] - dome(0.25f64.hypot(0.25), 0.02) * 0.9375).abs() < 1e-9);
}

#[test]
fn pressures_are_fitted_and_histories_have_spectra() {
    let dir = tempfile::tempdir().unwrap();
    let folder = blast(dir.path());
    let files = cavity(&folder, &dir.path().join("cavity")).unwrap();
    let one = |name: &str| values(files.last().unwrap(), name)[0];
    assert!((one("charge a") / 900.0 - 1.0).abs() < 1e-3);
    assert!((one("charge b") / 12_000.0 - 1.0).abs() < 1e-3);
    assert!((one("charge plateau") / 4e8 - 1.0).abs() < 1e-3 && one("charge R2") > 0.9999);
    let text = svg(&files[0]);
    assert!(text.contains("R² = 1.000") && text.matches("clipPath id").count() == 3);
    let files = spectrum(&folder, "house.velocity", &dir.path().join("f")).unwrap();
    let found = values(files.last().unwrap(), "dominant frequency")[0];
    assert!((found - 410.0).abs() < 2.0, "{found}");
    assert!(svg(&files[0]).contains("(m/s)/Hz"));
}

#[test]
fn unsuitable_runs_are_told() {
    let dir = tempfile::tempdir().unwrap();
    let (flat, folder) = (super::run(dir.path()), blast(dir.path()));
    let out = dir.path().join("x.svg");
    let text = |e: Result<Vec<PathBuf>, PlotError>| e.unwrap_err().to_string();
    let o = BlockOptions::default();
    let last = Which::Last;
    assert!(text(section(&flat, &[last], "rotation", o, &out)).contains("in the plane"));
    assert!(text(ppv(&flat, last, false, &out)).contains("in the plane"));
    assert!(text(crater(&flat, last, CraterOptions::default(), &out)).contains("in the plane"));
    assert!(text(heave(&flat, &[], None, Normal::Y, &out)).contains("no sources"));
    assert!(text(cavity(&flat, &out)).contains(".pressure"));
    assert!(text(spectrum(&flat, "slipp", &out)).contains("did you mean `slip`?"));
    assert!(text(spectrum(&flat, "slip", &out)).contains("5 usable samples"));
    let other = CraterOptions { source: Some("other"), ..CraterOptions::default() };
    assert!(text(crater(&folder, last, other, &out)).contains("valid sources: charge"));
    assert!(text(heave(&folder, &[], None, Normal::Z, &out)).contains("along x or y"));
    let far = BlockOptions { at: Some(99.0), ..o };
    let e = text(section(&folder, &[last], "level", far, &out));
    assert!(e.contains("y = 99 m intersects no block"), "{e}");
    assert!(text(section(&folder, &[last], "levle", o, &out)).contains("did you mean `level`?"));
    let mut manifest = Manifest::read(&folder).unwrap();
    manifest.sources[0].mass = None;
    manifest.sources[0].depth = None;
    manifest.write(&folder).unwrap();
    assert!(text(ppv(&folder, last, false, &out)).contains("a source with a mass"));
    assert!(text(crater(&folder, last, CraterOptions::default(), &out)).contains("has no depth"));
    manifest.sources.clear();
    manifest.write(&folder).unwrap();
    assert!(text(ppv(&folder, last, false, &out)).contains("has no sources"));
    assert!(!out.exists());
    assert!(section(&folder, &[last], "level", o, &out).is_ok());
}
