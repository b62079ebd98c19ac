use super::super::drawing::Normal;
use super::*;
use riprap_testkit::solid_sample;

fn drawn(frame: &Frame, eye: Eye, cut: Option<Cut>, size: [u32; 2]) -> (Drawing, Window) {
    let shot = Shot { field: "block".to_owned(), eye, size, cut, ..Shot::default() };
    let axes = camera::axes(&eye);
    let all: Vec<Vec3> = drawing::corners(frame, &shot).into_iter().flatten().collect();
    let along: Vec<Vec3> = all.iter().map(|p| Vec3::from(axes.map(|axis| axis.dot(*p)))).collect();
    let low = along.iter().copied().fold(Vec3::INFINITY, Vec3::min);
    let high = along.iter().copied().fold(Vec3::NEG_INFINITY, Vec3::max);
    let (camera, window) = camera::fitted(&eye, axes, [low, high], size);
    (Drawing::of(frame, &shot, (&camera, &window)), window)
}

fn from(direction: [f64; 2]) -> Eye {
    Eye::From { direction, angle: None }
}

fn seen(direction: [f64; 2], cut: Option<(Normal, f64)>) -> (Drawing, Window) {
    let eye = from(direction);
    let cut = cut.map(|(axis, at)| Cut::nearer(axis, at, &eye));
    drawn(&solid_sample(), eye, cut, [300, 200])
}

/// Area of what is seen of a block, m2.
fn area((drawing, window): &(Drawing, Window), block: u32) -> f64 {
    let faces = drawing.nearest.iter().filter_map(|at| drawing.faces.get(*at as usize));
    faces.filter(|face| face.block == block).count() as f64 / (window.zoom * window.zoom)
}

#[test]
fn what_is_seen_has_the_area_of_its_projection() {
    // A brick of 2 m, and a tetrahedron with edges of 1 m along the axes, to the right of it along x.
    let south = seen([180.0, 0.0], None);
    assert!((area(&south, 0) - 4.0).abs() < 0.04, "{}", area(&south, 0));
    assert!((area(&south, 1) - 0.5).abs() < 0.01, "{}", area(&south, 1));
    // From the east the tetrahedron hides half a square metre of the brick.
    let east = seen([90.0, 0.0], None);
    assert!((area(&east, 0) - 3.5).abs() < 0.04, "{}", area(&east, 0));
    // Isometric: a cube of 2 m is a hexagon of 4 sqrt 3; what the tetrahedron hides is its own.
    let high = (1.0 / 2.0_f64.sqrt()).atan().to_degrees();
    let corner = seen([225.0, high], None);
    assert!((area(&corner, 0) - 4.0 * 3.0_f64.sqrt()).abs() < 0.06, "{}", area(&corner, 0));
}

#[test]
fn a_cut_shows_the_section_of_a_block_in_its_plain_colour() {
    let cut = seen([90.0, 0.0], Some((Normal::X, 0.3)));
    assert!((area(&cut, 0) - 4.0).abs() < 0.04 && area(&cut, 1) == 0.0);
    let (drawing, _) = &cut;
    let faces = drawing.nearest.iter().filter_map(|at| drawing.faces.get(*at as usize));
    assert!(faces.filter(|face| face.block == 0).all(|face| face.section));
}

#[test]
fn a_block_that_is_cut_is_seen_before_what_touches_it_from_behind() {
    // The brick twice, the second one behind the first as seen from the south.
    let mut frame = solid_sample();
    let solids = frame.solids.clone().unwrap();
    let brick: Vec<[f64; 3]> = frame.outline(0).to_vec();
    let behind = brick.iter().map(|[x, y, z]| [*x, y + 2.0, *z]);
    frame.points = brick.iter().copied().chain(behind).collect();
    frame.offsets = vec![0, brick.len() as u32, 2 * brick.len() as u32];
    let faces: Vec<u32> = solids.of(0).into_iter().flatten().copied().collect();
    let ends: Vec<u32> = solids
        .of(0)
        .iter()
        .scan(0, |sum, face| {
            *sum += face.len() as u32;
            Some(*sum)
        })
        .collect();
    let whole = ends.len() as u32;
    frame.solids = Some(riprap_record::frame::Solids {
        faces: vec![0, whole, 2 * whole],
        ends: std::iter::once(0)
            .chain(ends.iter().copied())
            .chain(ends.iter().map(|end| end + faces.len() as u32))
            .collect(),
        corners: faces.iter().chain(&faces).copied().collect(),
    });
    for (at, block) in [(0.2, 0), (1.0, 1), (1.4, 1)] {
        let eye = from([170.0, 10.0]);
        let (drawing, _) = drawn(&frame, eye, Some(Cut::nearer(Normal::Y, at, &eye)), [120, 100]);
        // The section is upright, seen 10 deg from its normal each way; points on an outline may be of either face.
        let other = drawing.nearest.iter().filter_map(|at| drawing.faces.get(*at as usize));
        let section =
            other.clone().filter(|face| face.block == block && face.normal.z > 0.9).count();
        let beside = other.filter(|face| face.block != block && face.normal.z > 0.9).count();
        assert!(section > 1000 && beside < 5, "{at}: {section} and {beside}");
    }
}

#[test]
fn in_perspective_what_is_nearer_is_larger() {
    // The front face of a cube of 2 m, seen from 5 m before its middle, has 5/4 of its width at the middle.
    let frame = solid_sample();
    let corners = frame.outline(0);
    let middle =
        corners.iter().fold(Vec3::ZERO, |sum, p| sum + Vec3::from(*p)) / corners.len() as f64;
    let at = |distance: f64, angle: f64| Eye::At {
        place: (middle - distance * Vec3::Y).to_array(),
        target: middle.to_array(),
        up: [0.0, 0.0, 1.0],
        angle,
    };
    let near = drawn(&frame, at(5.0, 60.0), None, [400, 300]);
    assert!((area(&near, 0) - 6.25).abs() < 0.05, "{}", area(&near, 0));
    // At twice the tangent everything is half as wide in the picture.
    let wide = drawn(
        &frame,
        at(5.0, 2.0 * (2.0 * 30.0_f64.to_radians().tan()).atan().to_degrees()),
        None,
        [400, 300],
    );
    assert!((near.1.zoom / wide.1.zoom - 2.0).abs() < 1e-12);
    // A section through the middle has its true width, and its plain colour.
    let cut = Cut { normal: [0.0, -2.0, 0.0], at: -2.0 * middle.y };
    let cut = drawn(&frame, at(5.0, 60.0), Some(cut), [400, 300]);
    assert!((area(&cut, 0) - 4.0).abs() < 0.04, "{}", area(&cut, 0));
    // From inside, the walls around fill the picture behind a cut that takes nothing of them.
    let inside =
        drawn(&frame, at(0.5, 90.0), Some(Cut { normal: [0.0, 0.0, 1.0], at: 1e3 }), [40, 40]);
    assert!(inside.0.nearest.iter().all(|at| inside.0.faces[*at as usize].block == 0));
    // All of a model fits into its picture.
    let all =
        drawn(&frame, Eye::From { direction: [215.0, 28.0], angle: Some(60.0) }, None, [200, 150]);
    let rim = |x: usize, y: usize| all.0.nearest[y * 400 + x] == u32::MAX;
    assert!(
        (0..400).all(|x| rim(x, 0) && rim(x, 299)) && (0..300).all(|y| rim(0, y) && rim(399, y))
    );
}

#[test]
fn a_rod_is_pale_behind_rock_and_gone_where_it_is_cut_away() {
    use riprap_record::frame::{Column, Surfaces};
    let mut frame = solid_sample();
    let corners = frame.outline(0);
    let middle =
        corners.iter().fold(Vec3::ZERO, |sum, p| sum + Vec3::from(*p)) / corners.len() as f64;
    // From 1 m before the southern face of the cube to its middle.
    frame.bolts = Some(Surfaces {
        ends: vec![2],
        points: vec![(middle - 2.0 * Vec3::Y).to_array(), middle.to_array()],
        columns: vec![Column::scalar("axial_force", "N", vec![1e4])],
    });
    let red = |cut: Option<Cut>| {
        let eye = from([90.0, 0.0]);
        let shot =
            Shot { eye, cut, size: [300, 200], field: "block".to_owned(), ..Shot::default() };
        let axes = camera::axes(&eye);
        let [low, high] =
            [-4.0, 4.0].map(|v| Vec3::splat(v) + Vec3::from(axes.map(|a| a.dot(middle))));
        let (camera, window) = camera::fitted(&eye, axes, [low, high], shot.size);
        let mut drawing = Drawing::of(&frame, &shot, (&camera, &window));
        drawing.paint(&[[255.0; 3]; 2], &Light::even());
        drawing.rods(&frame, &shot, (&camera, &window), 1e4);
        let colours = drawing.colours.iter();
        let full = colours.clone().filter(|c| **c == rgb("#d01c1c")).count();
        let pale = colours.filter(|c| c[0] - c[1] > 40.0 && **c != rgb("#d01c1c")).count();
        [full, pale]
    };
    let [full, pale] = red(None);
    assert!(full > 100 && pale > 100, "{full} {pale}");
    let cut = Cut { normal: [0.0, -1.0, 0.0], at: 1.0 - middle.y };
    let [full, pale] = red(Some(cut));
    // Its round end sticks out of the plane.
    assert!(full < 30 && pale > 100, "{full} {pale}");
    // It lies in the plane of a section, or behind it.
    for (at, visible) in [(0.0, true), (0.1, false)] {
        let cut = Cut { normal: [1.0, 0.0, 0.0], at: middle.x + at };
        let [full, pale] = red(Some(cut));
        assert!(full > 200 && (pale < 50) == visible, "{at}: {full} {pale}");
    }
}

#[test]
fn a_saved_view_is_found_by_its_name() {
    let folder = tempfile::tempdir().unwrap();
    let told = |text: &str, name: &str| {
        std::fs::write(folder.path().join("views.json"), text).unwrap();
        Shot::saved(folder.path(), None, name).map_err(|error| error.to_string())
    };
    let text = r#"{"views": [
        {"name": "south", "eye": [0, -9, 1], "target": [0, 0, 1], "up": [0, 0, 1], "angle": 40, "zoom": 1, "field": "velocity",
         "log": false, "range": [0, 2.5], "exaggeration": 20, "cut": {"normal": [0, -1, 0], "at": -0.5}, "bolts": false, "settings": {}},
        {"name": "flat", "eye": [0, 0, 100], "target": [0, 0, 0], "angle": null}]}"#;
    let marks = r#"{"views": [{"name": "marks", "eye": [0, -9, 1], "target": [0, 0, 1], "picked": 12, "settings":
        {"trails": "picked", "trailColour": "block", "contacts": true, "states": [true, false]}}]}"#;
    let marks = told(marks, "marks").unwrap();
    assert_eq!(marks.trails, Some(Trails { by_block: true, only: Some(12) }));
    let states = [true, false, true, true, true, true, true, true];
    assert_eq!(marks.contacts, Some(states));
    let south = told(text, "south").unwrap();
    assert_eq!((south.trails, south.contacts), (None, None));
    let up = [0.0, 0.0, 1.0];
    let eye = Eye::At { place: [0.0, -9.0, 1.0], target: up, up, angle: 40.0 };
    assert_eq!((south.eye, south.field.as_str(), south.bolts), (eye, "velocity", false));
    assert_eq!(south.cut, Some(Cut { normal: [0.0, -1.0, 0.0], at: -0.5 }));
    assert_eq!((south.options.range, south.options.exaggeration), (Some([0.0, 2.5]), Some(20.0)));
    for (text, name, words) in [
        (text, "north", "no view is named `north`; valid names: south, flat"),
        (text, "flat", "in the plane"),
        ("{", "south", "EOF"),
        ("{}", "south", "no list `views`"),
        (
            r#"{"views": [{"name": "south", "eye": [1, 2]}]}"#,
            "south",
            "`eye` must be three numbers",
        ),
    ] {
        let error = told(text, name).unwrap_err();
        assert!(error.contains("views.json") && error.contains(words), "{error}");
    }
    let none = Shot::saved(folder.path(), Some(Path::new("none.json")), "a").unwrap_err();
    assert!(none.to_string().starts_with("none.json"), "{none}");
}

#[test]
fn options_without_sense_are_refused() {
    let sound = Shot::default();
    assert!(sound.checked().is_ok());
    let up = [0.0, 0.0, 1.0];
    let above = Eye::At { place: [0.0, 0.0, 9.0], target: [0.0; 3], up, angle: 30.0 };
    let wide = Eye::From { direction: [0.0; 2], angle: Some(180.0) };
    for (wrong, word) in [
        (Shot { eye: from([0.0, 91.0]), ..sound.clone() }, "view"),
        (Shot { eye: above, ..sound.clone() }, "eye"),
        (Shot { eye: wide, ..sound.clone() }, "perspective"),
        (Shot { size: [300, 9], ..sound.clone() }, "size"),
        (Shot { cut: Some(Cut { normal: [1.0, 0.0, 0.0], at: f64::NAN }), ..sound.clone() }, "at"),
        (Shot { cut: Some(Cut { normal: [0.0; 3], at: 0.0 }), ..sound.clone() }, "at"),
    ] {
        assert!(wrong.checked().unwrap_err().to_string().starts_with(word));
    }
    for (rate, animated) in [(10.0, false), (0.0, true), (f64::NAN, true), (61.0, true)] {
        assert!(check_rate(Some(rate), animated).unwrap_err().to_string().starts_with("fps"));
    }
}

/// The brick and the tetrahedron of the sample: `far` is how far the second has gone along x, m.
fn gone(step: u64, far: f64) -> Frame {
    let mut frame = solid_sample();
    (frame.step, frame.time) = (step, 0.5 * step as f64);
    let from = frame.offsets[1] as usize;
    for corner in &mut frame.points[from..] {
        corner[0] += far;
    }
    let shifts = vec![[0.0; 3], [far, 0.0, 0.0]];
    frame.block_columns = vec![
        riprap_record::Column::scalar("block", "-", vec![3.0, 7.0]),
        riprap_record::Column::vector3("displacement", "m", shifts),
    ];
    frame
}

#[test]
fn trails_are_the_ways_of_what_moved_up_to_the_frame() {
    let frames = [gone(0, 0.0), gone(1, 1.0), gone(2, 4.0)];
    let all = || frames.iter().map(|frame| Ok(frame.clone()));
    let trails = Trails::default();
    let shot = Shot { eye: from([180.0, 0.0]), ..Shot::default() };
    let ways = Ways::of(all, &shot, trails).unwrap();
    assert_eq!(
        ways.note(),
        "trail of 1 block, from slow (blue) to fast (red), up to 6.00 m/s",
        "3 m in half a second"
    );
    let axes = camera::axes(&shot.eye);
    let (camera, window) =
        camera::fitted(&shot.eye, axes, [Vec3::splat(-5.0), Vec3::splat(5.0)], [200, 200]);
    let count = |k: usize| ways.rods(&frames[k], &shot, (&camera, &window)).len();
    assert_eq!([0, 1, 2].map(count), [0, 1, 2]);
    // The brick stays.
    let only = |block| Ways::of(all, &shot, Trails { only: Some(block), ..trails }).unwrap().note();
    assert_eq!(only(9), "trails: no block has moved by a quarter of a block");
    assert!(only(3).starts_with("trail of 1 block"));
    let by_block = Ways::of(all, &shot, Trails { by_block: true, ..trails }).unwrap();
    assert_eq!(by_block.note(), "trail of 1 block");
    let bare = || std::iter::once(Ok(solid_sample_without_columns()));
    let error = Ways::of(bare, &shot, trails).err().unwrap().to_string();
    assert!(error.contains("displacement"), "{error}");
}

fn solid_sample_without_columns() -> Frame {
    Frame { block_columns: Vec::new(), ..solid_sample() }
}

#[test]
fn contacts_are_points_in_the_colour_of_their_state() {
    let mut frame = gone(0, 0.0);
    frame.contact_points = vec![[0.0; 3], [0.5, 0.0, 0.0], [1.0, 0.0, 0.0]];
    let column = |name: &str, of: [f64; 3]| riprap_record::Column::scalar(name, "-", of.to_vec());
    frame.contact_columns = vec![
        column("sliding_points", [0.0, 2.0, 0.0]),
        column("open_points", [0.0, 0.0, 4.0]),
        column("block_a", [3.0; 3]),
        column("block_b", [7.0; 3]),
    ];
    let counts = contacts::counts(&frame);
    assert_eq!(counts, [1, 1, 0, 0, 0, 0, 0, 1]);
    let eye = from([180.0, 0.0]);
    let (camera, window) =
        camera::fitted(&eye, camera::axes(&eye), [Vec3::splat(-5.0), Vec3::splat(5.0)], [200, 200]);
    let drawn = |wanted: Option<[bool; 8]>, cut: Option<Cut>| {
        let shot = Shot { eye, contacts: wanted, cut, ..Shot::default() };
        let said: Vec<String> =
            contacts::note(&shot, &counts, 1).into_iter().map(|piece| piece.text).collect();
        (contacts::rods(&frame, &shot, (&camera, &window)).len(), said.join("|"))
    };
    assert_eq!(drawn(None, None), (0, String::new()));
    let words = "contacts, pale behind rock:|sliding 1|open 1";
    assert_eq!(drawn(Some(CHANGED), None), (2, words.to_owned()));
    let cut = Cut { normal: [1.0, 0.0, 0.0], at: 0.7 };
    assert_eq!(drawn(Some([true; 8]), Some(cut)).0, 2, "one is cut away");
}
