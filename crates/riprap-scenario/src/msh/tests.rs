//! Files written by Gmsh 4.15.2 (`tests/data/msh/make.py`), broken in many ways.

use super::*;

const CYLINDER: [&[u8]; 4] = [
    include_bytes!("../../tests/data/msh/cylinder_22_ascii.msh"),
    include_bytes!("../../tests/data/msh/cylinder_22_binary.msh"),
    include_bytes!("../../tests/data/msh/cylinder_41_ascii.msh"),
    include_bytes!("../../tests/data/msh/cylinder_41_binary.msh"),
];
const BRICKS: [&[u8]; 4] = [
    include_bytes!("../../tests/data/msh/bricks_22_ascii.msh"),
    include_bytes!("../../tests/data/msh/bricks_22_binary.msh"),
    include_bytes!("../../tests/data/msh/bricks_41_ascii.msh"),
    include_bytes!("../../tests/data/msh/bricks_41_binary.msh"),
];

fn volume(mesh: &Mesh) -> f64 {
    let solids = mesh.cells.iter().map(|c| c.solid(&mesh.nodes).unwrap());
    solids.map(|s| s.moments().volume).sum()
}

#[test]
fn tetrahedra_of_a_cylinder_in_all_formats() {
    let meshes = CYLINDER.map(|bytes| parse_msh(bytes).unwrap());
    for mesh in &meshes {
        assert!(mesh.cells.iter().all(|c| c.kind == CellKind::Tetrahedron));
        // A prism on a polygon with few corners inside the circle.
        let share = volume(mesh) / std::f64::consts::TAU;
        assert!(share > 0.7 && share < 1.0, "{share}");
        let names: Vec<(u8, &str)> =
            mesh.groups.iter().map(|g| (g.dimension, g.name.as_str())).collect();
        assert_eq!(names, [(2, "ends"), (3, "rock core")]);
        assert!(mesh.cells.iter().all(|c| mesh.groups_of(c.set) == [1]));
        assert!(mesh.facets.len() > 8);
        for facet in &mesh.facets {
            let z = mesh.nodes[facet.nodes[0] as usize][2];
            assert!(z.abs() < 1e-12 || (z - 2.0).abs() < 1e-12);
        }
    }
    // The text of 2.2 and 4.1 has 16 digits, binary all.
    assert_eq!(meshes[1].cells.len(), meshes[3].cells.len());
    assert_eq!(meshes[0].nodes.len(), meshes[1].nodes.len());
    assert!((volume(&meshes[0]) - volume(&meshes[3])).abs() < 1e-12);
}

#[test]
fn sheared_bricks_in_all_formats() {
    for bytes in BRICKS {
        let mesh = parse_msh(bytes).unwrap();
        assert_eq!(mesh.cells.len(), 4);
        assert!(mesh.cells.iter().all(|c| c.kind == CellKind::Hexahedron));
        assert!((volume(&mesh) - 2.0).abs() < 1e-12);
        let of = |name: &str| {
            let group = mesh.groups.iter().position(|g| g.name == name).unwrap();
            mesh.cells.iter().filter(|c| mesh.groups_of(c.set) == [group as u32]).count()
        };
        assert_eq!((of("left"), of("right")), (2, 2));
    }
}

#[test]
fn prisms_and_pyramids_are_solids() {
    let at: Vec<[f64; 3]> = vec![
        [0.0, 0.0, 0.0],
        [1.0, 0.0, 0.0],
        [1.0, 1.0, 0.0],
        [0.0, 1.0, 0.0],
        [0.0, 0.0, 1.0],
        [1.0, 0.0, 1.0],
        [1.0, 1.0, 1.0],
    ];
    let cell = |kind, nodes| Cell { kind, nodes, set: 0 };
    let prism = cell(CellKind::Prism, [0, 1, 2, 4, 5, 6, 0, 0]);
    let pyramid = cell(CellKind::Pyramid, [0, 1, 2, 3, 4, 0, 0, 0]);
    let volume = |cell: &Cell| cell.solid(&at).unwrap().moments().volume;
    assert!((volume(&prism) - 0.5).abs() < 1e-15);
    assert!((volume(&pyramid) - 1.0 / 3.0).abs() < 1e-15);
    for kind in [CellKind::Prism, CellKind::Pyramid, CellKind::Tetrahedron, CellKind::Hexahedron] {
        let edges: usize = kind.faces().iter().map(|f| f.len()).sum();
        assert_eq!(kind.nodes() + kind.faces().len(), edges / 2 + 2);
    }
}

fn error(text: &str) -> String {
    parse_msh(text.as_bytes()).unwrap_err().to_string()
}

#[test]
fn errors_name_the_line_and_what_to_do() {
    let good = std::str::from_utf8(BRICKS[0]).unwrap();
    assert_eq!(
        error("OFF\n3 1 0"),
        "line 1: this is not a .msh file: it does not begin with $MeshFormat"
    );
    assert!(error("").starts_with("line 1: this is not a .msh file"));
    let old = good.replacen("2.2 0 8", "4.0 0 8", 1);
    assert!(
        error(&old).starts_with("line 2: the format is \"4.0\", but only 4.1 and 2.2 can be read"),
        "{}",
        error(&old)
    );
    let word = good.replacen("\n2 1 0 0\n", "\n2 1 zero 0\n", 1);
    assert_ne!(word, good);
    assert!(
        error(&word).contains("a coordinate is \"zero\"; it must be a number"),
        "{}",
        error(&word)
    );
    let nan = good.replacen("\n2 1 0 0\n", "\n2 1 nan 0\n", 1);
    assert!(error(&nan).contains("a coordinate is NaN"));
    let twice = good.replacen("\n2 1 0 0\n", "\n1 1 0 0\n", 1);
    assert!(error(&twice).contains("two nodes have the number 1"));
    let (head, _) = good.split_once("$Elements").unwrap();
    assert!(error(head).contains("the mesh has no volume elements"));
    let huge = format!("{head}$Elements\n18446744073709551615\n");
    assert!(
        error(&huge).contains("18446744073709551615 elements are declared"),
        "{}",
        error(&huge)
    );
    let second = format!("{head}$Elements\n1\n1 11 0 1 2 3 4 1 2 3 4 1 2\n$EndElements\n");
    assert!(error(&second).contains("Mesh.ElementOrder = 1"));
    let gone = format!("{head}$Elements\n1\n1 4 0 1 2 3 99\n$EndElements\n");
    assert!(error(&gone).contains("node 99, which does not exist"));
    let open = format!("{head}$Comment\nno end\n");
    assert!(error(&open).contains("has no $EndComment"));
}

#[test]
fn repeated_elements_count_once() {
    let good = std::str::from_utf8(BRICKS[0]).unwrap();
    let (head, _) = good.split_once("$Elements").unwrap();
    let text = format!("{head}$Elements\n2\n1 4 2 1 1 1 2 3 5\n2 4 2 2 1 1 2 3 5\n$EndElements\n");
    let mesh = parse_msh(text.as_bytes()).unwrap();
    assert_eq!(mesh.cells.len(), 1);
    let groups = mesh.groups_of(mesh.cells[0].set).iter();
    let names: Vec<&str> = groups.map(|k| mesh.groups[*k as usize].name.as_str()).collect();
    assert_eq!(names, ["left", "right"]);
}

/// Format 4.1 lists all groups of an entity at once: those behind the first were lost.
#[test]
fn entities_in_several_groups_keep_all_of_them() {
    let good = std::str::from_utf8(CYLINDER[2]).unwrap();
    let whole = parse_msh(good.as_bytes()).unwrap();
    // The volume is in the group 7, the surfaces of the ends in 8: both in a second one now, named twice.
    let (head, rest) = good.split_once("$Entities").unwrap();
    let (entities, rest) = rest.split_once("$EndEntities").unwrap();
    let lines = entities.lines().map(|line| {
        let mut words: Vec<&str> = line.split_whitespace().collect();
        if words.len() > 9 && words[7] == "1" {
            words[7] = "3";
            words.splice(9..9, ["5", "-5"]);
        }
        words.join(" ")
    });
    let lines: Vec<String> = lines.collect();
    let text = format!("{head}$Entities{}\n$EndEntities{rest}", lines.join("\n"));
    let mesh = parse_msh(text.as_bytes()).unwrap();
    let names = |set: u32| -> Vec<&str> {
        let groups = mesh.groups_of(set).iter();
        groups.map(|k| mesh.groups[*k as usize].name.as_str()).collect()
    };
    assert!(mesh.cells.iter().all(|c| names(c.set) == ["rock core", "5"]));
    assert!(mesh.facets.iter().all(|f| names(f.set) == ["ends", "5"]));
    assert_eq!(mesh.facets.len(), whole.facets.len());
    let many = text.replacen(" 3 8 5 -5", " 33 8 5 -5", 1);
    let found = error(&many);
    assert!(found.contains("in 33 physical groups; at most 32"), "{found}");
}

/// Files cut off anywhere and with any byte changed: an error or a mesh, never a panic, and no memory for made-up counts.
#[test]
fn broken_files_are_errors() {
    for bytes in CYLINDER.into_iter().chain(BRICKS) {
        let whole = parse_msh(bytes).unwrap();
        for end in (0..bytes.len()).step_by(7) {
            if let Ok(mesh) = parse_msh(&bytes[..end]) {
                assert_eq!(mesh, whole);
            }
        }
        for place in (0..bytes.len()).step_by(5) {
            for change in [0x01, 0x80, 0xff] {
                let mut broken = bytes.to_vec();
                broken[place] ^= change;
                if let Ok(mesh) = parse_msh(&broken) {
                    assert!(mesh.cells.len() <= whole.cells.len());
                    for cell in &mesh.cells {
                        // A bad shape is an error of its own.
                        let _solid = cell.solid(&mesh.nodes).is_ok();
                    }
                }
            }
        }
    }
}
