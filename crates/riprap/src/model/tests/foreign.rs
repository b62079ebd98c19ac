//! Blocks from the files of other tools, and joints that cut blocks in space.

use std::path::Path;

use super::*;
use crate::exec::Exec;
use crate::planar::setup::Setup as Planar;
use crate::record::field::FieldInfo;
use crate::spatial::setup::{FaceSet, Setup as Spatial, Shape};
use crate::spatial::world::World;
use riprap_geom::polyhedron::Polyhedron;

const GRAIN: &str = "[[blocks]]\nname = \"grain\"\nmaterial = \"rock\"\n";

/// Builds a text whose files are in `tests/data`.
fn built(text: String, fields: &[FieldInfo]) -> Result<Model, Diagnostics> {
    let mut parsed = parse(Source::new("t.toml", text))?;
    parsed.folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../riprap-scenario/tests/data");
    build(&parsed, "default", fields)
}

fn spatial(middle: &str) -> (Spatial, Vec<Explained>) {
    let fields = crate::run::engine::Kind::Spatial.fields();
    let model = built(format!("{SPACE}{GRAIN}{middle}{TAIL}"), fields);
    let model = model.unwrap_or_else(|error| panic!("{error}"));
    match model.setup {
        Setup::Spatial(setup) => (*setup, model.explained),
        Setup::Planar(_) => panic!("a model in space is expected"),
    }
}

fn planar(middle: &str) -> Planar {
    let model = built(text(&format!("{GRAIN}{middle}")), INFOS);
    match model.unwrap_or_else(|error| panic!("{error}")).setup {
        Setup::Planar(setup) => *setup,
        Setup::Spatial(_) => panic!("a model in the plane is expected"),
    }
}

fn refused(result: Result<Model, Diagnostics>, says: &str) {
    let error = result.expect_err("should be refused").render();
    assert!(error.contains(says), "{error}");
}

fn volume_of(shape: &Shape) -> f64 {
    match shape {
        Shape::Brick { half, .. } => 8.0 * half.element_product(),
        Shape::Polyhedron(solid) => {
            let (vertices, faces) = (solid.vertices.clone(), solid.faces.clone());
            Polyhedron { vertices, faces }.moments().volume
        }
        Shape::Terrain(_) | Shape::Glued(_) => 0.0,
    }
}

fn volume(setup: &Spatial) -> f64 {
    setup.blocks.iter().map(|b| volume_of(&b.shape)).sum()
}

fn area(setup: &Planar) -> f64 {
    let outlines = setup.blocks.iter().map(|b| &b.vertices);
    outlines.map(|o| signed_area(o)).sum()
}

#[test]
fn cells_of_a_tessellation_fill_its_domain() {
    let (setup, _) = spatial("mesh = { tess = \"shapes/grains3d.tess\", unit = \"2 m\" }\n");
    assert_eq!(setup.blocks.len(), 8);
    assert!((volume(&setup) - 8.0).abs() < 1e-9, "{}", volume(&setup));
    let setup = planar("polygons = { tess = \"shapes/grains2d.tess\" }\n");
    assert_eq!(setup.blocks.len(), 6);
    assert!((area(&setup) - 2.0).abs() < 1e-9, "{}", area(&setup));
    assert_eq!(setup.blocks[5].name, "grain.6");
}

#[test]
fn parts_of_a_surface_are_blocks() {
    for file in ["two_ascii", "two_binary"] {
        let (setup, _) = spatial(&format!("mesh.stl = \"shapes/{file}.stl\"\n"));
        assert_eq!(setup.blocks.len(), 2);
        let cube = volume_of(&setup.blocks[0].shape);
        assert!((cube - 24.0).abs() < 1e-5, "{cube}");
    }
}

#[test]
fn closed_polylines_are_blocks_and_layers_groups() {
    // The unit is that of the drawing, mm; in the drawing of release 12 there is none.
    let half_disk = std::f64::consts::PI / 8.0;
    for (file, unit) in [("R2010", ""), ("R2010_binary", ""), ("R12", ", unit = \"1 mm\"")] {
        let of = |more: &str| {
            format!("polygons = {{ dxf = \"shapes/section_{file}.dxf\"{unit}{more} }}\n")
        };
        let setup = planar(&of(", layers = [\"rock\"]"));
        assert!((area(&setup) - 3.0).abs() < 1e-12, "{}", area(&setup));
        let setup = planar(&of(", layers = [\"rock\", \"round\"], sagitta = \"0.1 mm\""));
        let all = 3.0 + 2.0 * half_disk;
        assert!((area(&setup) - all).abs() < 1e-3, "{}", area(&setup));
        let round = setup.groups.iter().find(|g| g.name == "round").unwrap();
        assert_eq!(round.blocks, [2, 3]);
        // A circle of 0.1 m that no layer of its own holds.
        let setup = planar(&of(", layers = [\"0\"], sagitta = \"0.01 mm\""));
        let disk = 0.01 * std::f64::consts::PI;
        assert!((area(&setup) - disk).abs() < 1e-5, "{}", area(&setup));
    }
    let file = "polygons = { dxf = \"shapes/section_R12.dxf\", layers = [\"rocks\"] }\n";
    refused(built(text(&format!("{GRAIN}{file}")), INFOS), "did you mean `rock`");
    let lines = "polygons = { dxf = \"shapes/section_R12.dxf\", layers = [\"joints\"] }\n";
    refused(built(text(&format!("{GRAIN}{lines}")), INFOS), "no closed polylines");
    let file = "polygons = { dxf = \"shapes/grains2d.tess\" }\n";
    refused(built(text(&format!("{GRAIN}{file}")), INFOS), "grains2d.tess`, line 1");
}

#[test]
fn open_polylines_cut() {
    let region =
        "region = [[\"0 m\", \"0 m\"], [\"2 m\", \"0 m\"], [\"2 m\", \"1 m\"], [\"0 m\", \"1 m\"]]";
    let traces = "traces = { dxf = \"shapes/section_R2010.dxf\", layers = [\"joints\"] }";
    let setup = planar(&format!("cut = {{ {region}, {traces} }}\n"));
    // The upright line and the one across it, which has a bend at x = 1.
    assert_eq!(setup.blocks.len(), 4);
    assert!((area(&setup) - 2.0).abs() < 1e-12);
    let both = format!("cut = {{ {region}, traces = {{ dxf = \"a.dxf\", csv = \"a.csv\" }} }}\n");
    refused(built(text(&format!("{GRAIN}{both}")), INFOS), "only one is possible");
}

#[test]
fn joints_cut_blocks_in_space() {
    let brick =
        "brick = { size = [\"4 m\", \"3 m\", \"2 m\"], corner = [\"1000 m\", \"0 m\", \"0 m\"] }\n";
    let set = |dip: u32, direction: u32, spacing: f64| {
        format!(
            "{{ dip = \"{dip} deg\", dip_direction = \"{direction} deg\", spacing = \"{spacing} m\", origin = [\"1000 m\", \"0 m\", \"0 m\"] }}"
        )
    };
    let cut = format!("{brick}cut.joint_sets = [{}, {}]\n", set(0, 0, 1.0), set(90, 90, 2.0));
    let (setup, explained) = spatial(&cut);
    assert_eq!(setup.blocks.len(), 4);
    assert!((volume(&setup) - 24.0).abs() < 1e-9);
    assert!(explained.iter().any(|e| e.key == "blocks.grain.cut.blocks" && e.value == "4"));
    let (again, _) = spatial(&cut);
    assert_eq!(setup.blocks, again.blocks);
    // A plane that dips at 45 deg to the east through the middle, and a small disk across it.
    let (setup, _) = spatial(&format!("{brick}cut.joints.csv = \"shapes/joints.csv\"\n"));
    assert_eq!(setup.blocks.len(), 3);
    // As other programs write them: strike, poles, diameters, other units.
    for file in ["joints_strike", "joints_pole"] {
        let (other, _) = spatial(&format!("{brick}cut.joints.csv = \"shapes/{file}.csv\"\n"));
        assert_eq!(other.blocks.len(), 3, "{file}");
        for (a, b) in setup.blocks.iter().zip(&other.blocks) {
            let (a, b) = (volume_of(&a.shape), volume_of(&b.shape));
            assert!((a - b).abs() < 1e-9, "{file}: {a} {b}");
        }
    }
    // The same two as polygons, a corner in each row: their number alone tells them apart.
    let (polygons, _) =
        spatial(&format!("{brick}cut.joints.csv = \"shapes/joints_polygons.csv\"\n"));
    assert_eq!(polygons.blocks.len(), 3);
    for (a, b) in setup.blocks.iter().zip(&polygons.blocks) {
        let (a, b) = (volume_of(&a.shape), volume_of(&b.shape));
        assert!((a - b).abs() < 1e-9, "{a} {b}");
    }
    let (setup, _) = spatial(&format!(
        "{brick}cut = {{ joints.csv = \"shapes/joints.csv\", smallest_edge = \"5 m\" }}\n"
    ));
    assert_eq!(setup.blocks.len(), 1);
    let fields = crate::run::engine::Kind::Spatial.fields();
    let of = |middle: &str| built(format!("{SPACE}{GRAIN}{brick}{middle}{TAIL}"), fields);
    let alone = "cut.joint_sets = [{ dip = \"30 deg\", spacing = \"1 m\" }]\n";
    refused(of(alone), "the key `dip_direction` is missing in");
    refused(of("cut = {}\n"), ".cut needs at least one of `joint_sets`, `joints`");
    refused(
        of("cut.joints.csv = \"../scenarios/good/traces.csv\"\n"),
        "has no columns with the orientation of the joints",
    );
    let flat = "cut.joints.csv = \"shapes/joints_flat.csv\"\n";
    refused(of(flat), "has no columns with the orientation of the joints");
    let bent = "cut.joints.csv = \"shapes/joints_bent.csv\"\n";
    refused(of(bent), "fracture 7 is not flat");
    let unknown = "cut.joints = { csv = \"shapes/joints_polygons.csv\", bridges = \"intact\" }\n";
    refused(of(unknown), "there is no interface `intact`");
    let partial = "cut.joint_sets = [{ dip = \"30 deg\", dip_direction = \"0 deg\", spacing = \"1 m\", persistence = 0.5, trace_length = \"1 m\" }]\n";
    refused(of(partial), "is a key of [space.planar]");
    let fine =
        "cut.joint_sets = [{ dip = \"30 deg\", dip_direction = \"0 deg\", spacing = \"1 um\" }]\n";
    refused(of(fine), "planes of a joint set");
}

#[test]
fn networks_of_other_programs_cut_blocks() {
    let brick =
        "brick = { size = [\"4 m\", \"4 m\", \"4 m\"], corner = [\"0 m\", \"0 m\", \"0 m\"] }\n";
    let fields = crate::run::engine::Kind::Spatial.fields();
    let of = |joints: &str| {
        let text = format!("{SPACE}{GRAIN}{brick}cut.joints = {{ {joints} }}\n{TAIL}");
        built(text, fields)
    };
    let data = "../../../../scenes/verify/engineering/data";
    for (joints, says) in [
        ("itasca = \"DATA/network_itasca.dat\"", "network_itasca.dat: read 2 of 2 fractures"),
        (
            "dfnworks = \"DATA/dfnworks\"",
            "dfnworks: read 2 of 3 fractures from radii_Final.dat, normal_vectors.dat, translations.dat, families.dat; left out 1 \
             because dfnGen removed them as isolated (R); ",
        ),
        (
            "dfnworks = \"DATA/dfnworks/translations.dat\"",
            "translations.dat: read 2 of 3 fractures",
        ),
        ("dfnworks = \"DATA/polygons.dat\"", "polygons.dat: read 2 of 2 fractures"),
    ] {
        let model = of(&joints.replace("DATA", data)).unwrap_or_else(|error| panic!("{error}"));
        let imports = &model.summary.imports;
        assert!(imports.iter().any(|i| i.contains(says)), "{imports:?}");
        let Setup::Spatial(setup) = model.setup else {
            panic!("a model in space is expected");
        };
        // The planes z = 2 m and x = 1 m.
        let mut volumes: Vec<f64> = setup.blocks.iter().map(|b| volume_of(&b.shape)).collect();
        volumes.sort_by(f64::total_cmp);
        assert_eq!(volumes.len(), 4, "{joints}");
        for (volume, expected) in volumes.iter().zip([8.0, 8.0, 24.0, 24.0]) {
            assert!((volume - expected).abs() < 1e-9, "{joints}: {volumes:?}");
        }
    }
    // A thousandth of the size: they still touch the corner of the block, and cut all through what they touch.
    let small = format!("itasca = \"{data}/network_itasca.dat\", unit = \"1 mm\"");
    let model = of(&small).unwrap_or_else(|error| panic!("{error}"));
    let Setup::Spatial(setup) = model.setup else {
        panic!("a model in space is expected");
    };
    let least = setup.blocks.iter().map(|b| volume_of(&b.shape));
    assert!((least.fold(f64::INFINITY, f64::min) - 0.002 * 0.001 * 4.0).abs() < 1e-9);
    refused(of("itasca = \"shapes/joints.csv\""), "not an Itasca DFN file");
    refused(of("dfnworks = \"shapes/joints.csv\""), "recognised by their names, radii_Final.dat");
    refused(of("dfnworks = \"shapes\""), "radii_Final.dat");
    refused(of("itasca = \"a.dat\", dfnworks = \"b.dat\""), "only one is possible");
}

/// What is read beside the file that a scene names is part of its input.
#[test]
fn lists_beside_a_named_list_count_in_the_hash() {
    let folder = tempfile::tempdir().unwrap();
    let write = |name: &str, text: &str| std::fs::write(folder.path().join(name), text).unwrap();
    for name in ["radii_Final.dat", "normal_vectors.dat", "translations.dat"] {
        write(name, "1 2 3\n");
    }
    for scene in ["joints = \"radii_Final.dat\"", "joints = \".\""] {
        let hash = || crate::run::scene::input_hash(scene, folder.path());
        write("translations.dat", "1 2 3\n");
        let before = hash();
        assert_eq!(before, hash());
        write("translations.dat", "1 2 4\n");
        assert_ne!(before, hash(), "{scene}");
    }
}

fn world_of(setup: Spatial) -> World {
    World::new(setup, Exec::serial()).unwrap().0
}

#[test]
fn physical_surfaces_are_sets_of_faces() {
    let on = "mesh.msh = \"msh/cylinder_41_ascii.msh\"\n[[boundaries]]\non.surface = \"ends\"\nroller = {}\n";
    let (setup, _) = spatial(on);
    let FaceSet::Surface { blocks, planes } = &setup.boundaries[0].on else {
        panic!("{:?}", setup.boundaries[0].on)
    };
    // Both ends of the cylinder, z = 0 and z = 2.
    let planes: Vec<[i64; 2]> =
        planes.iter().map(|(n, d)| [n.z.round() as i64, d.round() as i64]).collect();
    assert_eq!(planes.len(), 2, "{planes:?}");
    assert!(planes.contains(&[1, 2]) && planes.contains(&[-1, 0]));
    let group = setup.groups.iter().find(|g| g.name == "ends").unwrap();
    assert_eq!(&group.blocks, blocks);
    // The engine finds the faces: their area is that of the two ends.
    let world = world_of(setup.clone());
    let held = world.faces.iter().filter(|f| f.boundary == Some(0));
    let area: f64 = held.map(|f| f.area).sum();
    let exact = world.faces.iter().filter(|f| f.frame[0].z.abs() > 1.0 - 1e-9);
    let exact: f64 = exact.map(|f| f.area).sum();
    assert!(area > 4.0 && (area - exact).abs() < 1e-12, "{area}, {exact}");
    // Cut blocks hand their faces on.
    let cut = on.replace("[[boundaries]]", "cut.joint_sets = [{ dip = \"90 deg\", dip_direction = \"0 deg\", spacing = \"10 m\" }]\n[[boundaries]]");
    let (more, _) = spatial(&cut);
    assert!(more.blocks.len() > setup.blocks.len());
    let world = world_of(more);
    let held = world.faces.iter().filter(|f| f.boundary == Some(0));
    let again: f64 = held.map(|f| f.area).sum();
    assert!((again / area - 1.0).abs() < 1e-9, "{again}, {area}");
    let fields = crate::run::engine::Kind::Spatial.fields();
    let wrong = on.replace("\"ends\"", "\"end\"");
    refused(built(format!("{SPACE}{GRAIN}{wrong}{TAIL}"), fields), "there is no surface `end`");
}

#[test]
fn a_glued_mesh_keeps_its_groups() {
    let glued = "mesh.msh = \"msh/bricks_41_ascii.msh\"\nmesh.glued = true\n";
    let groups = |middle: &str| -> Vec<Vec<u32>> {
        let (setup, _) = spatial(middle);
        let of = |name| setup.groups.iter().find(move |g| g.name == name);
        ["left", "right"].map(|name| of(name).unwrap().blocks.clone()).to_vec()
    };
    assert_eq!(groups(glued), [[0], [0]]);
    // And so do copies of it.
    let copies = "copies = { count = 3, step = [\"5 m\", \"0 m\", \"0 m\"] }\n";
    assert_eq!(groups(&format!("{glued}{copies}")), [[0, 1, 2], [0, 1, 2]]);
    // The block is larger than what the file calls so.
    let fields = crate::run::engine::Kind::Spatial.fields();
    let model = built(format!("{SPACE}{GRAIN}{glued}{TAIL}"), fields).unwrap();
    let told = |w: &Diagnostic| w.message.contains("group `left` of the mesh contains");
    assert!(model.warnings.iter().any(told), "{:?}", model.warnings);
}

#[test]
fn a_profile_is_one_outline_of_a_drawing() {
    let asked = |profile: &str| {
        let text = format!(
            "{SPACE}{GRAIN}brick = {{ size = [\"8 m\", \"8 m\", \"8 m\"], corner = [\"0 m\", \"0 m\", \"0 m\"] }}\ncut.along.groups = [\"it\"]\n\
             [groups.it.excavation]\nfrom = [\"4 m\", \"0 m\", \"4 m\"]\nto = [\"4 m\", \"8 m\", \"4 m\"]\nprofile = {{ {profile} }}\n{TAIL}"
        );
        built(text, crate::run::engine::Kind::Spatial.fields())
    };
    let file = "dxf = \"shapes/section_R12.dxf\"";
    for (more, says) in [
        (", layer = \"rocks\"", "`shapes/section_R12.dxf` has no lines on layer `rocks`"),
        (", layer = \"joints\"", "has 0 closed outlines"),
        ("", "closed outlines"),
        (", layer = 3", "layer"),
    ] {
        let told = asked(&format!("{file}{more}")).expect_err(says).render();
        assert!(told.contains(says), "{more}: {told}");
        assert_eq!(told.matches("error[").count(), 1, "{more}: once: {told}");
    }
    refused(asked("dxf = \"shapes/none.dxf\""), "shapes/none.dxf");
}
