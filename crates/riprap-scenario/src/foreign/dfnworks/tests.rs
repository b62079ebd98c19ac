//! Lists of dfnWorks: where fractures lie, which files are taken, what is refused.

use super::*;

const RADII_TEXT: &str = "Fracture Radii List After Isolated Fracture and Cluster Removal\n\
        Format: xRadius yRadius Family# (-2 = userPolygon, -1 = userRectangle, 0 = userEllipse, > 0 is family in order of famProb)\n\
        2 1 1\n3 3 2\n1 0.5 -1\n1.5 1.5 0\n1 1 -2\n";
const NORMALS_TEXT: &str = " 1 0 0\n 0 0 1\n 0 0 -1\n 0 0.6 0.8\n 0 1 0\n";
const CENTRES_TEXT: &str = "Format: x y z  (R = removed from domain due to fracture isolation)\n\
        1 2 3\n9 9 9 R\n0 0 0\n0 0 1\n0 0 2\n0 0 3\n";
const FAMILIES_TEXT: &str = "UserDefined Ellipse Family: 0\n\nRectangular Family: 1\nGlobal Family: 1\nNumber of Vertices: 4\n\
        Beta (Rotation Around Normal Vector)-rad: 1.5707963267948966\nBeta (Rotation Around Normal Vector)-deg: 90\n\n\
        Ellipse Family: 1\nGlobal Family: 2\nNumber of Vertices: 8\nBeta Distribution (Rotation Around Normal Vector): Uniform\n";

/// A folder as dfnGen leaves it.
fn folder(files: &[(&str, &str)]) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    std::fs::create_dir(folder.path().join(OUTPUT)).unwrap();
    for (name, text) in files {
        std::fs::write(folder.path().join(name), text).unwrap();
    }
    folder
}

fn lists() -> [(&'static str, &'static str); 4] {
    [
        ("radii_Final.dat", RADII_TEXT),
        ("normal_vectors.dat", NORMALS_TEXT),
        ("translations.dat", CENTRES_TEXT),
        ("families.dat", FAMILIES_TEXT),
    ]
}

fn near(a: Vec3, b: Vec3) -> bool {
    (a - b).length() < 1e-12
}

#[test]
fn fractures_lie_where_dfngen_drew_them() {
    let folder = folder(&lists());
    let network = read_dfnworks(&folder.path().join("radii_Final.dat")).unwrap();
    assert_eq!(
        network.note(),
        "read 4 of 6 fractures from radii_Final.dat, normal_vectors.dat, translations.dat, families.dat; left out 1 because dfnGen removed them as \
         isolated (R); left out 1 because they were given by their corners, which only polygons.dat contains; these files do not give the in-plane \
         angle of 1 fractures; it is taken as 0 (polygons.dat has it)"
    );
    let lines: Vec<usize> = network.fractures.iter().map(|(_, line)| *line).collect();
    assert_eq!(lines, [3, 4, 5, 6]);
    let shapes: Vec<&Shape> = network.fractures.iter().map(|(shape, _)| shape).collect();
    // A rectangle of 4 x 2 in the plane z = 0, turned by 90 deg in it: 2 along x, 4 along y; then x turned to -z.
    let Shape::Corners(corners) = shapes[0] else {
        panic!("a rectangle is expected: {:?}", shapes[0]);
    };
    assert_eq!(corners.len(), 4);
    for corner in corners {
        let arm = (*corner - Vec3::new(1.0, 2.0, 3.0)).abs();
        assert!(near(arm, Vec3::new(0.0, 2.0, 1.0)), "{arm}");
    }
    // A circle of a family of octagons.
    let Shape::Ellipse { at, arms, corners } = shapes[1] else {
        panic!("an ellipse is expected: {:?}", shapes[1]);
    };
    assert_eq!((*at, *corners), (Vec3::ZERO, 8));
    assert!(near(arms[0], 3.0 * Vec3::X) && near(arms[1], 3.0 * Vec3::Y));
    // A normal that points down leaves x and y as they are.
    let Shape::Corners(corners) = shapes[2] else {
        panic!("a rectangle is expected: {:?}", shapes[2]);
    };
    assert!(near(corners[0], Vec3::new(1.0, 0.5, 1.0)));
    let (at, normal) = (Vec3::new(0.0, 0.0, 2.0), Vec3::new(0.0, 0.6, 0.8));
    let radius = 1.5;
    assert_eq!(*shapes[3], Shape::Disk { at, normal, radius });
}

#[test]
fn the_turn_to_a_normal_is_the_shortest() {
    for normal in [
        Vec3::new(0.48, -0.64, 0.6),
        Vec3::new(-0.48, 0.64, -0.6),
        Vec3::new(1e-5, 2e-5, -1.0).normalize(),
        Vec3::new(0.0, 1e-9, 1.0),
    ] {
        let [x, y] = frame(normal);
        assert!(near(x.cross(y), normal), "{normal}");
        assert!((x.length() - 1.0).abs() < 1e-12);
        // What lies along the axis of the turn stays: z cross the normal.
        let axis = Vec3::Z.cross(normal).normalize();
        assert!((axis.x * x + axis.y * y - axis).length() < 1e-9, "{normal}");
    }
}

#[test]
fn any_of_the_files_or_their_folder_names_the_network() {
    let [radii, normals, centres, families] = lists().map(|(_, text)| text);
    let all = "Format: xRadius yRadius Family# Removed (-2 = userPolygon)\n2 1 1\n7 7 2 R\n3 3 2\n1 0.5 -1\n1.5 1.5 0\n1 1 -2\n";
    let run = folder(&[
        ("params.txt", "5\n0.1\n0\n12\n10\n10\n10\n"),
        ("dfnGen_output/radii_Final.dat", radii),
        ("dfnGen_output/radii.dat", all),
        ("dfnGen_output/normals.dat", normals),
        ("dfnGen_output/translations.dat", centres),
        ("dfnGen_output/families.dat", families),
    ]);
    let place = |name: &str| run.path().join(name);
    let read = |name: &str| read_dfnworks(&place(name)).unwrap();
    let shapes = |network: &Network| -> Vec<Shape> {
        network.fractures.iter().map(|(shape, _)| shape.clone()).collect()
    };
    let first = shapes(&read("dfnGen_output/radii_Final.dat"));
    for name in [
        "",
        "params.txt",
        "dfnGen_output",
        "dfnGen_output/radii.dat",
        "dfnGen_output/normals.dat",
        "dfnGen_output/translations.dat",
        "dfnGen_output/families.dat",
    ] {
        assert_eq!(shapes(&read(name)), first, "{name}");
    }
    assert!(read("dfnGen_output/radii.dat").note().contains("from radii.dat, normals.dat"));
    let beside = companions(&place("dfnGen_output/radii_Final.dat"));
    let names: Vec<String> = beside.iter().map(|file| named(file)).collect();
    assert_eq!(names, ["normals.dat", "translations.dat", "families.dat"]);
    assert_eq!(companions(&place("params.txt")).len(), 4);
    // Polygons go first where a folder is named, and alone where they are.
    let polygons = "nPolygons: 1\n3 {0, 0, 0} {1, 0, 0} {0, 0, 1}\n";
    std::fs::write(place("dfnGen_output/polygons.dat"), polygons).unwrap();
    assert_eq!(read("").note(), "read 1 of 1 fractures from polygons.dat");
    assert_eq!(companions(&place("")), [place("dfnGen_output/polygons.dat")]);
    let note = read("dfnGen_output/polygons.dat").note();
    assert_eq!(note, "read 1 of 1 fractures");
    assert!(companions(&place("dfnGen_output/polygons.dat")).is_empty());
    assert_eq!(shapes(&read("dfnGen_output/radii_Final.dat")), first);
    std::fs::write(place("params.txt"), "6\n").unwrap();
    let error = read_dfnworks(&place("params.txt")).unwrap_err().message;
    assert!(error.ends_with(" 5, and params.txt says 6"), "{error}");
}

#[test]
fn says_what_is_wrong() {
    let said = |file: usize, from: &str, to: &str| {
        let mut files = lists();
        let text = files[file].1.replacen(from, to, 1);
        assert_ne!(text, files[file].1, "{from}");
        files[file].1 = &text;
        let folder = folder(&files);
        read_dfnworks(&folder.path().join("radii_Final.dat")).unwrap_err().message
    };
    for (file, from, to, says) in [
        (0, "2 1 1\n", "", "radii_Final.dat` has 4 fractures, "),
        (0, "2 1 1\n", "2 1\n", "radii_Final.dat`, line 3: a row needs three numbers"),
        (0, "3 3 2\n", "3 x 2\n", "radii_Final.dat`, line 4: `x` is not a finite number"),
        (0, "3 3 2\n", "3 -3 2\n", "radii_Final.dat`, line 4: radii must be above 0"),
        (0, "3 3 2\n", "3 0 2\n", "radii_Final.dat`, line 4: radii must be above 0"),
        (0, "3 3 2\n", "3 3 2.5\n", "radii_Final.dat`, line 4: the third number"),
        (1, "0 0 -1", "0 0 0", "normal_vectors.dat`, line 3: a normal must have non-zero length"),
        (1, "0 0 -1", "0 0 nan", "normal_vectors.dat`, line 3: `nan` is not a finite"),
        (2, "9 9 9 R", "9 9 9", "and `"),
        (2, "9 9 9 R", "9 9 9 Q", "translations.dat`, line 3: `Q` is not a finite number"),
        (3, "Vertices: 8", "Vertices: 2", "families.dat`, line 11: `2` is not a number of corners"),
        (3, "Vertices: 8", "Vertices: 4000000000", "`4000000000` is not a number of corners"),
        (3, "-rad: 1.57", "-rad: y", "families.dat`, line 6: `y07963"),
        (
            3,
            "Global Family: 2",
            "Global Family: two",
            "families.dat`, line 10: `two` is not a family number",
        ),
    ] {
        let error = said(file, from, to);
        assert!(error.contains(says), "{error}");
    }
    let [radii, normals, ..] = lists();
    let lone = folder(&[radii, normals]);
    let error = read_dfnworks(&lone.path().join("radii_Final.dat")).unwrap_err();
    assert!(error.message.contains("cannot read") && error.message.contains("translations.dat"));
    // A folder without a network, and a file of another name.
    let error = read_dfnworks(folder(&[]).path()).unwrap_err().message;
    assert!(error.contains("radii_Final.dat"), "{error}");
    std::fs::write(lone.path().join("radii_All.dat"), RADII_TEXT).unwrap();
    let error = read_dfnworks(&lone.path().join("radii_All.dat")).unwrap_err().message;
    assert!(error.contains("line 1: `nPolygons:` and a number are expected"), "{error}");
    let many = "1 1 1\n".repeat(MOST_ROWS + 1);
    let error = parse_rows(many.as_bytes()).unwrap_err().to_string();
    assert!(error.contains("more than 1000000 rows"), "{error}");
}
