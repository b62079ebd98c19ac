//! Terrain from files, and what is refused there.

use super::*;
use crate::spatial::setup::{Setup as Spatial, Shape, Surface};

const HEAD: &str = "riprap = 1\ntitle = \"t\"\n[space.spatial]\nfound_contacts = true\ngravity = \"9.81 m/s2\"\n\
    [materials.rock]\ndensity = \"2500 kg/m3\"\nyoung = \"20 GPa\"\npoisson = 0.25\n[interfaces.default]\nnormal_stiffness = \"1 GPa/m\"\nfriction_angle = \"30 deg\"\n\
    [[phases]]\nname = \"fall\"\nuntil = { time = \"1 s\" }\n";
const BALL: &str = "[[blocks]]\nname = \"ball\"\nmaterial = \"rock\"\nbrick = { size = [\"1 m\", \"1 m\", \"1 m\"], centre = [\"5 m\", \"3 m\", \"9 m\"] }\n";

/// A scene with a file beside it.
fn build_with(file: (&str, &str), more: &str) -> Result<Model, Diagnostics> {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join(file.0), file.1).unwrap();
    let key = file.0.rsplit('.').next().unwrap();
    let ground = format!(
        "[[blocks]]\nname = \"ground\"\nmaterial = \"rock\"\nterrain.{key} = \"{}\"\n",
        file.0
    );
    let mut parsed = parse(Source::new("t.toml", format!("{HEAD}{ground}{more}")))?;
    parsed.folder = folder.path().to_path_buf();
    build(&parsed, "default", crate::run::engine::Kind::Spatial.fields())
}

fn surface(file: (&str, &str)) -> (Surface, Model) {
    let model = build_with(file, BALL).unwrap_or_else(|error| panic!("{error}"));
    let Setup::Spatial(setup) = &model.setup else {
        panic!("a model in space is expected");
    };
    let setup: &Spatial = setup;
    match &setup.blocks[0].shape {
        Shape::Terrain(surface) => ((**surface).clone(), model.clone()),
        Shape::Brick { .. } | Shape::Polyhedron(_) | Shape::Glued(_) => {
            panic!("terrain is expected")
        }
    }
}

#[track_caller]
fn refused(file: (&str, &str), more: &str, says: &[&str]) {
    let error = build_with(file, more).expect_err("should be refused").render();
    for text in says {
        assert!(error.contains(text), "{error}");
    }
}

fn asc(rows: &str) -> String {
    let count = rows.lines().count();
    format!(
        "ncols 5\nnrows {count}\nxllcorner -1\nyllcorner -1\ncellsize 2\nNODATA_value -9\n{rows}"
    )
}

const PLAIN: &str = "0 1 2 3 4\n0 1 2 3 4\n0 1 2 3 4\n0 1 2 3 4\n";

fn csv(rows: &[(f64, f64, f64)]) -> String {
    let lines = rows.iter().map(|(x, y, z)| format!("{x},{y},{z}\n"));
    format!("x_m,y_m,z_cm\n{}", lines.collect::<String>())
}

fn grid() -> Vec<(f64, f64, f64)> {
    let places = (0..20).map(|k| (f64::from(k % 5), f64::from(k / 5)));
    places.map(|(x, y)| (2.0 * x, 2.0 * y, 100.0 * x)).collect()
}

fn stl(triangles: &[[[f64; 3]; 3]]) -> String {
    let corner = |c: &[f64; 3]| format!("vertex {} {} {}\n", c[0], c[1], c[2]);
    let one = |t: &[[f64; 3]; 3]| {
        let corners: String = t.iter().map(corner).collect();
        format!("facet normal 0 0 0\nouter loop\n{corners}endloop\nendfacet\n")
    };
    let all: String = triangles.iter().map(one).collect();
    format!("solid t\n{all}endsolid t\n")
}

/// A square of 8 m by 6 m that rises with x, from four triangles about a middle; both senses of rotation.
fn square() -> Vec<[[f64; 3]; 3]> {
    let [a, b, c, d, m] =
        [[0.0, 0.0, 0.0], [8.0, 0.0, 4.0], [8.0, 6.0, 4.0], [0.0, 6.0, 0.0], [4.0, 3.0, 2.0]];
    vec![[a, b, m], [b, m, c], [c, d, m], [d, m, a]]
}

#[test]
fn one_slope_in_three_formats() {
    let files = [("g.asc", asc(PLAIN)), ("g.csv", csv(&grid())), ("g.stl", stl(&square()))];
    for (name, text) in files {
        let (surface, model) = surface((name, &text));
        let (low, high) = surface.field().bounds();
        assert_eq!((low.to_array(), high.to_array()), ([0.0; 3], [8.0, 6.0, 4.0]));
        assert!((surface.field().steepest().0 - libm::atan(0.5)).abs() < 1e-12);
        assert_eq!(model.summary.blocks, 2);
        assert_eq!(model.summary.supported, 1);
        assert!((model.summary.mass - 2500.0).abs() < 1e-9, "terrain has no weight");
        assert!(
            model.summary.terrain[0].contains("steepest 26.6 deg"),
            "{:?}",
            model.summary.terrain
        );
    }
    // In any order.
    let mut rows = grid();
    rows.reverse();
    rows.swap(3, 11);
    assert_eq!(surface(("g.csv", &csv(&rows))).0, surface(("g.csv", &csv(&grid()))).0);
}

#[test]
fn holes_folds_and_bad_numbers_are_refused_with_their_place() {
    let hole = asc(&PLAIN.replace("0 1 2 3 4\n0 1 2", "0 1 2 3 4\n0 1 -9"));
    refused(("g.asc", &hole), BALL, &["`g.asc` is not a terrain", "hole near (4, 4)"]);
    refused(("g.asc", &asc("0 1 2 3 inf\n0 0 0 0 0\n")), BALL, &["line 7", "not a finite number"]);
    let mut rows = grid();
    rows.remove(7);
    refused(("g.csv", &csv(&rows)), BALL, &["hole"]);
    rows = grid();
    rows.push((2.0, 2.0, 5.0));
    refused(("g.csv", &csv(&rows)), BALL, &["line 22: a second height at (2 m, 2 m)"]);
    let scattered: Vec<_> =
        (0..20).map(|k| (0.7 * f64::from(k * k), 1.3 * f64::from(k), 0.0)).collect();
    refused(("g.csv", &csv(&scattered)), BALL, &["not a grid", "STL"]);
    refused(("g.csv", "x_m,y_m\n1,2\n"), BALL, &["`z`"]);
    let mut triangles = square();
    triangles[1][1][2] = 9.0;
    refused(("g.stl", &stl(&triangles)), BALL, &["not a terrain"]);
    let mut triangles = square();
    triangles.push([[1.0, 1.0, 3.0], [7.0, 1.0, 3.0], [4.0, 5.0, 3.0]]);
    refused(("g.stl", &stl(&triangles)), BALL, &["folded"]);
    triangles = square();
    triangles.push([[0.0, 0.0, 0.0], [8.0, 0.0, 4.0], [8.0, 0.0, 9.0]]);
    refused(("g.stl", &stl(&triangles)), BALL, &["is vertical"]);
}

#[test]
fn blocks_start_on_or_above_terrain() {
    let text = asc(PLAIN);
    let ball = |centre: &str| BALL.replace("[\"5 m\", \"3 m\", \"9 m\"]", centre);
    let file = ("g.asc", text.as_str());
    refused(
        file,
        &ball("[\"5 m\", \"3 m\", \"3 m\"]"),
        &["block `ball` starts", "0.25 m below the surface of terrain `ground`"],
    );
    refused(
        file,
        &ball("[\"15 m\", \"3 m\", \"9 m\"]"),
        &["block `ball` starts outside the rim of the terrain"],
    );
    // It stands just on the slope: its highest corner below is at 5.5 m, 2.75 m high.
    assert!(build_with(file, &ball("[\"5 m\", \"3 m\", \"3.25 m\"]")).is_ok());
    // Held blocks may be anywhere.
    let held = "[[supports]]\non = { block = \"ball\" }\nfixed = {}\n";
    assert!(build_with(file, &format!("{}{held}", ball("[\"15 m\", \"3 m\", \"9 m\"]"))).is_ok());
}

#[test]
fn terrain_does_not_move() {
    let text = asc(PLAIN);
    for key in ["velocity = [\"1 m/s\", \"0 m/s\", \"0 m/s\"]", "mechanics.deformable = {}"] {
        refused(("g.asc", &text), &format!("{key}\n{BALL}"), &["cannot be used with `terrain`"]);
    }
    let release = "[[phases]]\nname = \"on\"\nuntil = { time = \"1 s\" }\nrelease = [\"ground\"]\n";
    refused(
        ("g.asc", &text),
        &format!("{BALL}{release}"),
        &["`ground` is terrain, which cannot move"],
    );
}

/// Flat rasters `[x, y, cells, cell size, height]` of corners (m), one terrain each; a ball above the first.
fn tiles(places: &[[f64; 5]]) -> Model {
    let folder = tempfile::tempdir().unwrap();
    let mut more = String::from(BALL);
    for (k, [x, y, cells, size, z]) in places.iter().enumerate() {
        let count = *cells as usize;
        let row = vec![z.to_string(); count].join(" ");
        let rows = vec![row; count].join("\n");
        let text = format!(
            "ncols {count}\nnrows {count}\nxllcorner {x}\nyllcorner {y}\ncellsize {size}\n{rows}\n"
        );
        std::fs::write(folder.path().join(format!("{k}.asc")), text).unwrap();
        more += &format!(
            "[[blocks]]\nname = \"tile{k}\"\nmaterial = \"rock\"\nterrain.asc = \"{k}.asc\"\n"
        );
    }
    let mut parsed = parse(Source::new("t.toml", format!("{HEAD}{more}"))).unwrap();
    parsed.folder = folder.path().to_path_buf();
    let fields = crate::run::engine::Kind::Spatial.fields();
    build(&parsed, "default", fields).unwrap_or_else(|error| panic!("{error}"))
}

/// Triangles of each terrain.
fn triangles(model: &Model) -> Vec<usize> {
    let Setup::Spatial(setup) = &model.setup else {
        panic!("a model in space is expected");
    };
    let shapes = setup.blocks.iter().filter_map(|b| match &b.shape {
        Shape::Terrain(surface) => Some(surface.triangles.len()),
        Shape::Brick { .. } | Shape::Polyhedron(_) | Shape::Glued(_) => None,
    });
    shapes.collect()
}

#[test]
fn tiles_of_one_survey_are_joined() {
    // Four tiles of 5 by 5 cells about a corner: 4 by 4 squares between the middles of cells, and strips of a square between tiles.
    let four = [
        [0.0, 0.0, 5.0, 2.0, 0.0],
        [10.0, 0.0, 5.0, 2.0, 0.0],
        [0.0, 10.0, 5.0, 2.0, 0.0],
        [10.0, 10.0, 5.0, 2.0, 0.0],
    ];
    let model = tiles(&four);
    assert!(model.warnings.is_empty(), "{:?}", model.warnings);
    assert_eq!(triangles(&model), [50, 40, 40, 32]);
    let told = model.summary.terrain.join("\n");
    let says =
        "tile0: joined to tile1, tile2, tile3 across the cell between them; 50 triangles in total";
    assert!(told.contains(says), "{told}");
    // Beside each other, half a tile apart: two whole cells between them, and half of a cell at both ends.
    let model = tiles(&[four[0], [10.0, 4.0, 5.0, 2.0, 0.0]]);
    assert!(model.warnings.is_empty(), "{:?}", model.warnings);
    assert_eq!(triangles(&model), [32 + 2 * 2 + 2, 32]);
    // The western one comes second.
    let model = tiles(&[four[1], four[0]]);
    assert_eq!(triangles(&model), [32, 40]);
}

#[test]
fn gaps_and_ground_that_is_there_twice_are_reported() {
    let seam = |places: &[[f64; 5]]| {
        let model = tiles(places);
        let seams = model.warnings.iter().filter(|w| w.code == "terrain.seam");
        seams.map(|w| w.message.clone()).collect::<Vec<_>>()
    };
    let first = [0.0, 0.0, 5.0, 2.0, 0.0];
    // Another cell size; cells out of line; a part of the ground twice.
    let told = seam(&[first, [10.0, 0.0, 10.0, 1.0, 0.0]]);
    assert!(told[0].contains("leave a gap of 1.5 m between their rims"), "{told:?}");
    let told = seam(&[first, [10.5, 0.0, 5.0, 2.0, 0.0]]);
    assert!(told[0].contains("leave a gap of 2.5 m between their rims"), "{told:?}");
    let told = seam(&[first, [5.0, 1.0, 5.0, 2.0, 0.0]]);
    assert!(told[0].contains("cover the same ground"), "{told:?}");
    // Far apart; touching; a bench above a floor: nothing to say.
    assert!(seam(&[first, [40.0, 0.0, 5.0, 2.0, 0.0]]).is_empty());
    assert!(seam(&[first, [8.0, 0.0, 5.0, 2.0, 0.0]]).is_empty());
    assert!(seam(&[first, [4.0, 0.0, 5.0, 2.0, 3.0]]).is_empty());
}
