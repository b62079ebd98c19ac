//! Files made by ezdxf, pyvista and Neper (`tests/data/shapes/make.py`), whole and broken.

use proptest::prelude::*;

use super::asc::parse_asc;
use super::dxf::{Drawing, parse_dxf};
use super::stl::parse_stl;
use super::tess::{Cells, parse_tess};

const TESS3: &[u8] = include_bytes!("../../tests/data/shapes/grains3d.tess");
const TESS2: &[u8] = include_bytes!("../../tests/data/shapes/grains2d.tess");
const STL: [&[u8]; 2] = [
    include_bytes!("../../tests/data/shapes/two_ascii.stl"),
    include_bytes!("../../tests/data/shapes/two_binary.stl"),
];
const DXF: [&[u8]; 3] = [
    include_bytes!("../../tests/data/shapes/section_R12.dxf"),
    include_bytes!("../../tests/data/shapes/section_R2010.dxf"),
    include_bytes!("../../tests/data/shapes/section_R2010_binary.dxf"),
];

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).unwrap()
}

#[test]
fn cells_of_neper_are_read() {
    let Cells::Space(cells) = parse_tess(TESS3).unwrap() else {
        panic!("cells in space are expected")
    };
    let numbers: Vec<i64> = cells.iter().map(|c| c.number).collect();
    assert_eq!(numbers, [1, 2, 3, 4, 5, 6, 7, 8]);
    for cell in &cells {
        let edges: usize = cell.faces.iter().map(Vec::len).sum();
        assert_eq!(cell.vertices.len() + cell.faces.len(), edges / 2 + 2);
    }
    let Cells::Plane(cells) = parse_tess(TESS2).unwrap() else {
        panic!("cells in the plane are expected")
    };
    assert_eq!(cells.len(), 6);
}

#[test]
fn broken_tessellations_have_their_line() {
    let good = text(TESS3);
    let wrong = |text: &str| parse_tess(text.as_bytes()).unwrap_err().to_string();
    assert!(wrong("nonsense").starts_with("line 1: `***tess`"));
    assert!(wrong("").starts_with("line 1"));
    assert!(
        wrong(&good.replace("   3 standard", "   7 standard"))
            .starts_with("line 5: cells of dimension 7")
    );
    let half = &good[..good.len() / 2];
    assert!(wrong(half).contains("line "), "{}", wrong(half));
    let count = good.replace(" **polyhedron\n 8", " **polyhedron\n 2000000");
    assert!(wrong(&count).contains("entries in a file of"), "{}", wrong(&count));
    let more = good.replace(" **polyhedron\n 8", " **polyhedron\n 9");
    assert!(wrong(&more).contains("the next section begins"), "{}", wrong(&more));
    let none = "***tess\n **format\n 3.4\n **general\n 3 standard\n **vertex\n 0\n **face\n 0\n **polyhedron\n 0\n";
    assert!(wrong(none).contains("no cells"));
    assert!(wrong(&good.replace("**face", "**fac")).contains("no section **face"));
    assert!(
        parse_tess(&[b"***tess\n"[..].to_vec(), vec![0xff]].concat())
            .unwrap_err()
            .to_string()
            .starts_with("byte 8")
    );
}

/// Each copies its corners: a short file could ask for any memory.
#[test]
fn a_face_has_two_sides_and_no_more_corners_than_a_block() {
    let file = |ring: usize, cells: &[&str]| {
        let vertices: String = (1..=ring).map(|k| format!("{k} {k} 0 0 0\n")).collect();
        let numbers: Vec<String> = (1..=ring).map(|k| k.to_string()).collect();
        let rows = cells.join("\n");
        format!(
            "***tess\n **general\n 3 standard\n **vertex\n {ring}\n{vertices} **face\n 1\n 1 {ring} {}\n 0\n 0\n 0\n \
             **polyhedron\n {}\n{rows}\n***end\n",
            numbers.join(" "),
            cells.len()
        )
    };
    let wrong = |text: String| parse_tess(text.as_bytes()).unwrap_err().to_string();
    let thrice = "face 1 is used for the third time";
    let one = wrong(file(3, &["1 3 1 1 1"]));
    assert!(one.starts_with(&format!("line 17: {thrice}")), "{one}");
    let two = wrong(file(3, &["1 3 1 -1 1"]));
    assert!(two.contains(thrice), "{two}");
    let long = wrong(file(10_001, &["1 3 1 1 1"]));
    let right = "line 10009: face 1 has 10001 corners; a block has at most 10000";
    assert_eq!(long, right);
}

#[test]
fn surfaces_of_pyvista_are_read() {
    for bytes in STL {
        let parts = parse_stl(bytes).unwrap();
        let corners: Vec<usize> = parts.iter().map(|p| p.points.len()).collect();
        assert_eq!(corners, [8, 4]);
        let most = parts[0].points.iter().map(|p| p[2]).fold(0.0, f64::max);
        assert_eq!(most, 4.0);
    }
}

#[test]
fn broken_surfaces_have_their_line_or_byte() {
    let good = text(STL[0]);
    let wrong = |bytes: &[u8]| parse_stl(bytes).unwrap_err().to_string();
    assert!(wrong(b"").starts_with("byte 0"));
    assert!(wrong(&[b'x'; 200]).starts_with("byte 200"));
    let cut = &good.as_bytes()[..good.len() / 2];
    assert!(wrong(cut).contains("truncated"), "{}", wrong(cut));
    assert!(
        wrong(&STL[1][..300]).starts_with("byte 300: 16 triangles need 884 bytes"),
        "{}",
        wrong(&STL[1][..300])
    );
    for numbers in ["0 zero 4", "0 inf 0 4", "0 0 4 0", "0 0 4 x", "0 0"] {
        let number = good.replacen("vertex 0 0 4", &format!("vertex {numbers}"), 1);
        assert!(
            wrong(number.as_bytes()).starts_with("line 5: `vertex` and three finite"),
            "{numbers}: {}",
            wrong(number.as_bytes())
        );
    }
    let mut long = STL[1].to_vec();
    long.extend([0; 7]);
    assert!(
        wrong(&long).starts_with("byte 884: 16 triangles end here, but 7 more bytes follow"),
        "{}",
        wrong(&long)
    );
    // Heads of binary files may begin as texts do.
    long[..6].copy_from_slice(b"solid ");
    assert!(wrong(&long).contains("7 more bytes"), "{}", wrong(&long));
    // Without its first triangle.
    let end = good.find("endfacet").unwrap() + "endfacet".len();
    let open = format!("solid a{}", &good[end..]);
    assert!(
        wrong(open.as_bytes()).contains("part 1 is not closed: 3 edges"),
        "{}",
        wrong(open.as_bytes())
    );
    // Turned inside out.
    let mut inside = STL[1].to_vec();
    for record in inside[84..].chunks_exact_mut(50) {
        let (a, b) = record.split_at_mut(24);
        a[12..24].swap_with_slice(&mut b[..12]);
    }
    assert!(wrong(&inside).contains("not convex"), "{}", wrong(&inside));
}

fn summary(drawing: &Drawing) -> Vec<(&str, bool, usize)> {
    let lines = drawing.lines.iter();
    lines.map(|l| (l.layer.as_str(), l.closed, l.points.len())).collect()
}

#[test]
fn lines_of_ezdxf_are_read() {
    for (k, bytes) in DXF.into_iter().enumerate() {
        let drawing = parse_dxf(bytes, None).unwrap();
        assert_eq!(drawing.unit, [None, Some(1e-3), Some(1e-3)][k]);
        let round = ("round", true, 13);
        assert_eq!(
            summary(&drawing),
            [
                ("rock", true, 4),
                ("rock", true, 4),
                round,
                round,
                ("joints", false, 2),
                ("joints", false, 3),
                ("0", true, 24)
            ]
        );
        // A half disk bulges to the right of its chord; the one seen from behind lies at -x.
        let disk = &drawing.lines[2].points;
        let low = disk.iter().map(|p| p[1]).fold(f64::INFINITY, f64::min);
        assert!((low - 1500.0).abs() < 1e-9, "{low}");
        assert!(drawing.lines[3].points.iter().all(|p| p[0] <= 1e-9));
        let fine = parse_dxf(bytes, Some(0.01)).unwrap();
        let area = |points: &[[f64; 2]]| {
            let next = points.iter().cycle().skip(1);
            0.5 * points.iter().zip(next).map(|(p, q)| p[0] * q[1] - p[1] * q[0]).sum::<f64>()
        };
        let exact = std::f64::consts::PI * 500.0 * 500.0 / 2.0;
        assert!((area(&fine.lines[2].points) / exact - 1.0).abs() < 1e-4);
        // Seen from behind, anticlockwise becomes clockwise.
        assert!((area(&fine.lines[3].points) / exact + 1.0).abs() < 1e-4);
    }
}

/// All layers with such letters had one name, and none that could be asked for.
#[test]
fn letters_of_layers_are_read_as_the_drawing_writes_them() {
    // A drawing of release 12 with its layer `joints` renamed.
    let layers = |page: &str, name: &[u8]| {
        let text = text(DXF[0]).replace("ANSI_1252", page);
        let parts: Vec<&str> = text.split("joints").collect();
        let bytes = parts.iter().map(|p| p.as_bytes()).collect::<Vec<_>>().join(name);
        let drawing = parse_dxf(&bytes, None).unwrap();
        drawing.layers()[2].to_owned()
    };
    assert_eq!(layers("ANSI_1252", b"Kl\xfcfte \x80"), "Klüfte €");
    assert_eq!(layers("ANSI_1252", "Klüfte".as_bytes()), "Klüfte");
    assert_eq!(layers("ANSI_1252", b"Kl\\U+00FCfte\\U+"), "Klüfte\\U+");
    assert_eq!(layers("ANSI_1251", b"Kl\xfcfte"), "Kl\\xFCfte");
}

#[test]
fn a_byte_order_mark_is_no_damage() {
    let marked = |bytes: &[u8]| [b"\xef\xbb\xbf", bytes].concat();
    assert_eq!(parse_tess(&marked(TESS3)), parse_tess(TESS3));
    assert_eq!(parse_stl(&marked(STL[0])), parse_stl(STL[0]));
    assert_eq!(parse_dxf(&marked(DXF[1]), None), parse_dxf(DXF[1], None));
    let raster = b"ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 1\n1 2\n3 4\n";
    assert_eq!(parse_asc(&marked(raster)), parse_asc(raster));
    assert!(parse_asc(raster).is_ok());
}

#[test]
fn broken_drawings_have_their_line_or_byte() {
    let wrong = |bytes: &[u8]| parse_dxf(bytes, None).unwrap_err().to_string();
    assert!(wrong(b"").starts_with("line 1"));
    assert!(wrong(b"nonsense").starts_with("line 1"));
    for bytes in DXF {
        for length in [bytes.len() / 3, bytes.len() - 12] {
            assert!(
                wrong(&bytes[..length]).contains("truncated")
                    || wrong(&bytes[..length]).contains("group code")
            );
        }
    }
    let broken = text(DXF[1]).replacen("\n2000.0\n", "\ntwo\n", 1);
    assert!(
        wrong(broken.as_bytes()).contains("a number is expected, not \"two\""),
        "{}",
        wrong(broken.as_bytes())
    );
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    /// Changed bytes give an error or cells, never a panic.
    #[test]
    fn changed_bytes_do_no_harm(changes in prop::collection::vec((0_usize..1 << 20, any::<u8>()), 1..6)) {
        let all = [TESS3, TESS2, STL[0], STL[1], DXF[0], DXF[1], DXF[2]];
        for (k, bytes) in all.into_iter().enumerate() {
            let mut bytes = bytes.to_vec();
            let length = bytes.len();
            for (at, byte) in &changes {
                bytes[at % length] = *byte;
            }
            match k {
                0 | 1 => drop(parse_tess(&bytes)),
                2 | 3 => drop(parse_stl(&bytes)),
                _ => drop(parse_dxf(&bytes, Some(0.1))),
            }
        }
    }
}
