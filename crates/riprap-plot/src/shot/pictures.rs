//! Pictures of small models against stored ones: shading, colours of fields, cuts and marks.
//!
//! `RIPRAP_WRITE_PICTURES=1` writes them anew; look at them then.

use std::path::PathBuf;

use resvg::tiny_skia::Pixmap;
use riprap_record::frame::{BRICK, Column, Frame, Solids};

use super::super::drawing::Normal;
use super::*;

/// Points of which a channel differs by more than this are others.
const FAR: u8 = 20;
/// Share of points that may be others: rounding at edges.
const SHARE: f64 = 0.003;

/// A wall of three courses before a slab, with a gap, a displacement that grows upwards, and contact forces between two courses.
fn wall() -> Frame {
    let mut frame = Frame { offsets: vec![0], ..Frame::default() };
    let mut shifts = Vec::new();
    let mut put = |middle: [f64; 3], size: [f64; 3], shift: f64| {
        let corner = |c: [f64; 3]| std::array::from_fn(|k| middle[k] + 0.5 * size[k] * c[k]);
        frame.points.extend(BRICK.map(corner));
        frame.offsets.push(frame.points.len() as u32);
        shifts.push([0.0, -shift, 0.0]);
    };
    put([0.0, 0.0, -0.25], [8.0, 5.0, 0.5], 0.0);
    for course in 0..3 {
        let offset = if course % 2 == 0 { -2.0 } else { -1.0 };
        for brick in 0..(if course == 1 { 2 } else { 3 }) {
            let x = offset + 2.0 * f64::from(brick);
            let z = 0.5 + f64::from(course);
            put([x, 0.8, z], [1.96, 1.0, 1.0], 0.01 * f64::from(course));
        }
    }
    let count = shifts.len();
    frame.solids = Some(Solids { faces: vec![0; count + 1], ends: vec![0], corners: vec![] });
    let materials = (0..count).map(|i| f64::from(u8::from(i == 0))).collect();
    frame.block_columns = vec![
        Column::scalar("block", "-", (0..count).map(|i| i as f64).collect()),
        Column::vector3("displacement", "m", shifts),
        Column::scalar("material", "-", materials),
    ];
    // The upper course on the one below it.
    frame.contact_points = (0..3).map(|i| [-1.5 + 1.5 * f64::from(i), 0.8, 2.0]).collect();
    frame.contact_columns = vec![
        Column::scalar("block_a", "-", vec![6.0, 7.0, 8.0]),
        Column::scalar("block_b", "-", vec![4.0, 4.0, 5.0]),
        Column::vector3("force_on_a", "N", [[0.0, 0.0, 1e3], [0.0, 0.0, 4e3], [0.0, 0.0, 2e3]]),
    ];
    frame
}

fn drawn(shot: &Shot) -> Pixmap {
    let frame = wall();
    let materials = ["brick".to_owned(), "floor".to_owned()];
    let frames = std::slice::from_ref(&frame);
    let seen = Seen::of(frames.iter().map(|f| Ok(f.clone())), shot, &materials).unwrap();
    seen.picture(&frame, ["wall", ""], shot).unwrap()
}

fn shot(field: &str) -> Shot {
    Shot { field: field.to_owned(), size: [220, 150], ..Shot::default() }
}

fn file(name: &str) -> PathBuf {
    [env!("CARGO_MANIFEST_DIR"), "tests/pictures", &format!("{name}.png")].iter().collect()
}

/// Share of the points that differ from those of a stored picture.
fn different(name: &str, picture: &Pixmap) -> f64 {
    let stored = Pixmap::load_png(file(name)).unwrap();
    assert_eq!((stored.width(), stored.height()), (picture.width(), picture.height()), "{name}");
    let far = |(a, b): &(&[u8], &[u8])| a.iter().zip(*b).any(|(a, b)| a.abs_diff(*b) > FAR);
    let points = stored.data().chunks_exact(4).zip(picture.data().chunks_exact(4));
    points.clone().filter(far).count() as f64 / points.count() as f64
}

fn same(name: &str, shot: &Shot) {
    let picture = drawn(shot);
    if std::env::var_os("RIPRAP_WRITE_PICTURES").is_some() {
        std::fs::write(file(name), picture.encode_png().unwrap()).unwrap();
    }
    let share = different(name, &picture);
    assert!(share <= SHARE, "{name}.png: {:.2} % of the points are others", 100.0 * share);
}

#[test]
fn materials_in_light_and_shadow_are_those_of_the_stored_picture() {
    let eye = Eye::From { direction: [215.0, 50.0], angle: None };
    let with = Shot { eye, ..shot("material") };
    same("materials", &with);
    let dull = different("materials", &drawn(&Shot { shadows: false, ..with.clone() }));
    assert!(dull > 2.0 * SHARE, "a picture without shadows must differ: {dull}");
    let other = drawn(&Shot { field: "block".to_owned(), ..with });
    assert!(different("materials", &other) > 0.05, "other colours must differ");
}

#[test]
fn a_field_with_a_cut_is_that_of_the_stored_picture() {
    let eye = Eye::From { direction: [215.0, 28.0], angle: Some(40.0) };
    let cut = Cut::nearer(Normal::X, -0.4, &eye);
    let with = Shot { eye, cut: Some(cut), ..shot("displacement") };
    same("cut", &with);
    let whole = drawn(&Shot { cut: None, ..with.clone() });
    assert!(different("cut", &whole) > 0.05, "a whole model must differ");
    let deeper = Cut::nearer(Normal::X, 0.4, &eye);
    assert!(different("cut", &drawn(&Shot { cut: Some(deeper), ..with })) > 0.02);
}

#[test]
fn chains_arrows_and_notes_are_those_of_the_stored_picture() {
    let note = Note { text: "lintel".to_owned(), at: [0.0, 0.3, 2.5], block: Some(7) };
    let with = Shot {
        chains: true,
        vectors: Some("displacement".to_owned()),
        notes: vec![note],
        ..shot("material")
    };
    same("marks", &with);
    for without in [
        Shot { chains: false, ..with.clone() },
        Shot { vectors: None, ..with.clone() },
        Shot { notes: Vec::new(), ..with.clone() },
    ] {
        // Without a line below the picture is lower.
        let picture = drawn(&without);
        let lower = picture.height() < drawn(&with).height();
        assert!(lower || different("marks", &picture) > 0.005);
    }
    let wrong = Shot { vectors: Some("mass".to_owned()), ..shot("material") };
    let frame = wall();
    let error = Seen::of([Ok(frame)].into_iter(), &wrong, &[]).err().unwrap();
    assert!(error.to_string().contains("displacement, velocity or force"), "{error}");
}

#[test]
fn tubes_end_at_contacts_with_ground() {
    let mut frame = wall();
    // A brick of the lowest course on the slab.
    frame.contact_points = vec![[-2.0, 0.8, 0.0]];
    frame.contact_columns = vec![
        Column::scalar("block_a", "-", vec![1.0]),
        Column::scalar("block_b", "-", vec![0.0]),
        Column::vector3("force_on_a", "N", [[0.0, 0.0, 1e3]]),
    ];
    let count = |frame: &Frame| {
        let with = Shot { chains: true, ..shot("material") };
        let seen = Seen::of([Ok(frame.clone())].into_iter(), &with, &[]).unwrap();
        let look = (&seen.camera, &seen.window);
        chains::rods(frame, &with, look, seen.strongest, seen.window.reach()).len()
    };
    assert_eq!(count(&frame), 1, "into the brick alone");
    frame.contact_columns[1] = Column::scalar("block_b", "-", vec![4.0]);
    assert_eq!(count(&frame), 2, "from brick to brick");
    let held = (0..frame.blocks()).map(|i| f64::from(u8::from(i == 4))).collect();
    frame.block_columns.push(Column::scalar("held", "-", held));
    assert_eq!(count(&frame), 1, "the other is held");
}

#[test]
fn lines_below_a_narrow_picture_are_broken() {
    let with = Shot { chains: true, ..shot("material") };
    let [narrow, wide] = [220, 900].map(|wide| {
        let picture = drawn(&Shot { size: [wide, 150], ..with.clone() });
        // Ink in the last pixels of the lines below.
        let foot = TITLE as u32 + 150..picture.height();
        let edge = picture.width() - 6..picture.width();
        let dark = |x, y| picture.pixel(x, y).is_some_and(|p| p.red() < 128);
        assert!(!foot.clone().any(|y| edge.clone().any(|x| dark(x, y))));
        foot.len()
    });
    assert!(narrow > wide, "{narrow} {wide}");
}
