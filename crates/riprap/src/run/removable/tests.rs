use std::path::{Path, PathBuf};

use super::{Answer, Block, Kind, RemovableError, Rules, removable};
use crate::exec::Exec;
use crate::record::Manifest;
use crate::record::folder::{Existing, block_file};
use crate::record::vtu;
use crate::run::scene::Scene;
use crate::scenario::Source;

fn of(scene: &Scene, rules: &Rules) -> Result<Answer, RemovableError> {
    let job = scene.prepare(&scene.plain()).unwrap().job();
    removable(job.setup, job.plan, rules, Exec::serial())
}

fn shipped(name: &str, changes: &[(&str, &str)], rules: &Rules) -> Answer {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes").join(name);
    let changes: Vec<(String, String)> =
        changes.iter().map(|(k, v)| ((*k).to_owned(), (*v).to_owned())).collect();
    of(&Scene::load(&path, &changes).unwrap(), rules).unwrap()
}

fn text(text: &str, rules: &Rules) -> Result<Answer, RemovableError> {
    of(&Scene::parse(Source::new("scene", text), PathBuf::from("."), &[]).unwrap(), rules)
}

fn near(value: f64, expected: f64, relative: f64) {
    assert!((value - expected).abs() <= relative * expected.abs(), "{value}, not {expected}");
}

#[test]
fn a_roof_wedge_falls() {
    // Goodman, Shi & Boyle (1982): 11547 N on a free triangle with sides of 2 m.
    let rules = Rules { factor: 1.5, ..Rules::default() };
    let answer = shipped("verify/spatial-rigid/g4_roof_wedge.toml", &[], &rules);
    let [wedge] = &answer.blocks[..] else { panic!("{answer:?}") };
    assert_eq!((wedge.kind, wedge.mode, wedge.way().as_str()), (Kind::Key, "falling", "falls"));
    near(wedge.volume, 1.0 / 3.0_f64.sqrt(), 1e-9);
    near(wedge.support_force, 1.5 * 11_547.005_384, 1e-9);
    near(wedge.support_pressure.unwrap(), 1.5 * 11_547.005_384 / 3.0_f64.sqrt(), 1e-9);
    assert_eq!((answer.ground, answer.not_counted), (3, vec!["in_situ".to_owned()]));
}

#[test]
fn the_wedge_of_hoek_and_bray() {
    let on_its_planes = [("blocks.wedge.shift", "[\"0 m\", \"0 m\", \"0 m\"]")];
    let rules = Rules { factor: 2.5, ..Rules::default() };
    let answer = shipped("verify/spatial-contact/g2_hoek_bray.toml", &on_its_planes, &rules);
    let [wedge] = &answer.blocks[..] else { panic!("{answer:?}") };
    assert_eq!((wedge.kind, wedge.mode), (Kind::Potential, "wedge"));
    // The values of the scene, from chapter 8 of the book.
    near(wedge.factor_of_safety, 1.97332, 1e-5);
    near(wedge.planes[0].area, 868.403, 1e-5);
    near(wedge.planes[0].pressing, 0.797_855 * wedge.weight, 1e-5);
    near(wedge.planes[1].pressing, 0.489_834 * wedge.weight, 1e-5);
    assert_eq!(wedge.way(), "slides on 45/105 and 70/235");
    near(wedge.trend_and_plunge()[1], 31.1965, 1e-5);
    near(wedge.support_force, (2.5 - wedge.factor_of_safety) * wedge.driving, 1e-12);
    // Before the cohesion comes down it is held by more.
    let settle = Rules { phase: Some("settle".to_owned()), ..rules };
    let more = shipped("verify/spatial-contact/g2_hoek_bray.toml", &on_its_planes, &settle);
    assert!(more.blocks[0].factor_of_safety > 3.0, "{more:?}");
}

#[test]
fn what_a_key_block_has_held_goes_in_the_next_round() {
    let rules = Rules { factor: 1.1, rounds: 5, ..Rules::default() };
    let answer = shipped("spatial/wedge.toml", &[], &rules);
    let loose: Vec<&Block> =
        answer.blocks.iter().filter(|b| b.factor_of_safety < 1.1 && b.mode == "wedge").collect();
    let rounds: Vec<u32> = loose.iter().map(|block| block.round).collect();
    assert_eq!(rounds, [1, 2], "{loose:?}");
    for block in loose {
        // Hoek & Bray: tan(phi) / (c tan(psi)).
        let exact = 39.47_f64.to_radians().tan() / 38.470_f64.to_radians().tan();
        near(block.factor_of_safety, exact, 1e-4);
        near(block.support_force, (1.1 - block.factor_of_safety) * block.driving, 1e-9);
    }
    // One round tells of the front alone.
    let first = shipped("spatial/wedge.toml", &[], &Rules { rounds: 1, ..rules });
    let slides = first.blocks.iter().filter(|block| block.mode == "wedge");
    assert_eq!(slides.count(), 1);
}

/// A block of 2 m by 1 m by 1 m on a slope of 35 deg, drowned or not.
fn slide(water: &str) -> String {
    let at = |u: f64, v: f64, y: f64| {
        let (s, c) = 35.0_f64.to_radians().sin_cos();
        format!("[\"{:.12} m\", \"{y} m\", \"{:.12} m\"]", u * c + v * s, -u * s + v * c)
    };
    let body = |[u0, u1]: [f64; 2], [v0, v1]: [f64; 2]| {
        let corners = [u0, u1]
            .map(|u| [v0, v1].map(|v| [0.0, 1.0].map(|y| at(u, v, y)).join(", ")).join(", "));
        corners.join(", ")
    };
    format!(
        r#"
        riprap = 1
        title = "a block on a plane"
        [space.spatial]
        gravity = "9.81 m/s2"
        [materials.rock]
        density = "2600 kg/m3"
        young = "10 GPa"
        poisson = 0.25
        [interfaces.default]
        normal_stiffness = "1 GPa/m"
        shear_stiffness = "1 GPa/m"
        friction_angle = "30 deg"
        cohesion = "2 kPa"
        [[blocks]]
        name = "slope"
        material = "rock"
        polyhedron.vertices = [{}]
        [[blocks]]
        name = "block"
        material = "rock"
        polyhedron.vertices = [{}]
        [[supports]]
        on = {{ block = "slope" }}
        fixed = {{}}
        [[phases]]
        name = "slide"
        until = {{ time = "1 s" }}
        {water}
        "#,
        body([-3.0, 3.0], [-1.0, 0.0]),
        body([-1.0, 1.0], [0.0, 1.0]),
    )
}

#[test]
fn a_block_on_a_plane_dry_and_drowned() {
    let (s, c) = 35.0_f64.to_radians().sin_cos();
    let friction = 30.0_f64.to_radians().tan();
    let exact = |density: f64| {
        let weight = 2.0 * density * 9.81;
        (2e3 * 2.0 + weight * c * friction) / (weight * s)
    };
    let dry = text(&slide(""), &Rules::default()).unwrap();
    assert_eq!((dry.blocks[0].mode, dry.blocks[0].way().as_str()), ("sliding", "slides on 35/090"));
    near(dry.blocks[0].factor_of_safety, exact(2600.0), 1e-9);
    near(dry.blocks[0].planes[0].area, 2.0, 1e-9);
    let water = "[water.lake]\npoints = [[\"-50 m\", \"10 m\"], [\"50 m\", \"10 m\"]]\n";
    let wet = text(&slide(water), &Rules::default()).unwrap();
    near(wet.blocks[0].factor_of_safety, exact(1600.0), 1e-6);
    assert!(wet.blocks[0].factor_of_safety > dry.blocks[0].factor_of_safety);
}

/// Half of a symmetric wedge: its plane rises by `rise` over 1 m from the plane of symmetry at y = 0, their line dips by 35 deg. `holds` is what
/// holds that side.
fn half_wedge(rise: f64, holds: &str) -> String {
    let (s, c) = 35.0_f64.to_radians().sin_cos();
    let body = |section: [[f64; 2]; 3]| {
        let at = |u: f64, [y, v]: [f64; 2]| {
            format!("[\"{:.12} m\", \"{y} m\", \"{:.12} m\"]", u * c + v * s, -u * s + v * c)
        };
        let ends = [0.0, 2.0].map(|u| section.map(|corner| at(u, corner)).join(", "));
        ends.join(", ")
    };
    let plain = slide("");
    let (head, rest) = plain.split_once("[[blocks]]").unwrap();
    let tail = rest.split_once("[[supports]]").unwrap().1;
    format!(
        r#"{head}
        [[blocks]]
        name = "slope"
        material = "rock"
        polyhedron.vertices = [{}]
        [[blocks]]
        name = "block"
        material = "rock"
        polyhedron.vertices = [{}]
        {holds}
        [[supports]]{tail}"#,
        body([[0.0, 0.0], [1.0, 0.0], [1.0, rise]]),
        body([[0.0, 0.0], [1.0, rise], [0.0, rise]]),
    )
}

#[test]
fn a_block_goes_along_a_roller_as_along_a_plane_of_symmetry() {
    let (s, c) = 35.0_f64.to_radians().sin_cos();
    let face = "[[boundaries]]\non = { block = \"block\", side = \"y-min\" }\n";
    let roller = format!("{face}roller = {{}}\n");
    let support = "[[supports]]\non.block = \"block\"\nfixed = { x = false, z = false }\n";
    for (rise, holds) in [(1.0, roller.as_str()), (0.4, &roller), (1.0, support)] {
        let answer = text(&half_wedge(rise, holds), &Rules::default()).unwrap();
        let [block] = &answer.blocks[..] else { panic!("{answer:?}") };
        // The whole wedge of two planes: each is pressed by W c / (2 sin of half their angle).
        let weight = 2600.0 * 9.81 * rise;
        let slant = (1.0 + rise * rise).sqrt();
        let bears = 2e3 * 2.0 * slant + weight * c * slant * 30.0_f64.to_radians().tan();
        near(block.factor_of_safety, bears / (weight * s), 1e-9);
        near(block.trend_and_plunge()[1], 35.0, 1e-9);
        assert_eq!((block.mode, answer.rollers, answer.ground), ("wedge", 1, 1), "{answer:?}");
        assert!(
            block.way().ends_with("90/000 (roller)") || block.way().ends_with("90/180 (roller)")
        );
        assert!(answer.words().ends_with("or is held in some directions"), "{}", answer.words());
    }
    // What holds along the face too is rock that goes on.
    for holds in ["held = {}", "viscous = {}"] {
        let answer =
            text(&half_wedge(1.0, &format!("{face}{holds}\n")), &Rules::default()).unwrap();
        assert_eq!((answer.blocks.len(), answer.rollers, answer.ground), (0, 0, 2), "{holds}");
    }
    // Rollers beside the block on the plane take nothing from it.
    let plain = text(&slide(""), &Rules::default()).unwrap();
    let sides = ["y-min", "y-max"].map(|side| {
        format!("[[boundaries]]\non = {{ block = \"block\", side = \"{side}\" }}\nroller = {{}}\n")
    });
    let between = slide("").replacen("[[supports]]", &format!("{}[[supports]]", sides.concat()), 1);
    let between = text(&between, &Rules::default()).unwrap();
    assert_eq!(between.rollers, 1);
    assert_eq!(between.blocks[0].factor_of_safety, plain.blocks[0].factor_of_safety);
    assert_eq!(between.blocks[0].way(), "slides on 35/090");
}

/// The block in the middle of the roof of a brick, between planes that dip to the sides or to each other.
fn roof(directions: [&str; 2]) -> Block {
    let [east, west] = directions;
    let scene = format!(
        r#"
        riprap = 1
        title = "a block in a roof"
        [space.spatial]
        gravity = "9.81 m/s2"
        [materials.rock]
        density = "2600 kg/m3"
        young = "10 GPa"
        poisson = 0.25
        [interfaces.default]
        friction_angle = "30 deg"
        [[blocks]]
        name = "rock"
        material = "rock"
        brick = {{ size = ["6 m", "6 m", "3 m"], corner = ["-3 m", "-3 m", "0 m"] }}
        [blocks.cut]
        joint_sets = [
          {{ dip = "80 deg", dip_direction = "{east} deg", spacing = "100 m", origin = ["1 m", "0 m", "0 m"] }},
          {{ dip = "80 deg", dip_direction = "{west} deg", spacing = "100 m", origin = ["-1 m", "0 m", "0 m"] }},
          {{ dip = "90 deg", dip_direction = "0 deg", spacing = "2 m", origin = ["0 m", "1 m", "0 m"] }},
          {{ dip = "0 deg", dip_direction = "0 deg", spacing = "100 m", origin = ["0 m", "0 m", "1.5 m"] }},
        ]
        [[boundaries]]
        on.plane = "z-max"
        held = {{}}
        [[phases]]
        name = "fall"
        until = {{ time = "1 s" }}
        "#
    );
    let answer = text(&scene, &Rules::default()).unwrap();
    let middle = |b: &&Block| b.centroid[0].abs() < 0.1 && b.centroid[1].abs() < 0.1;
    answer.blocks.iter().find(middle).unwrap().clone()
}

#[test]
fn a_block_that_is_wider_inside_cannot_leave() {
    let falls = roof(["90", "270"]);
    assert_eq!((falls.kind, falls.factor_of_safety), (Kind::Key, 0.0));
    let tapered = roof(["270", "90"]);
    assert_eq!((tapered.kind, tapered.mode), (Kind::Tapered, "held"));
    assert!(tapered.free_area > 2.0);
}

#[test]
fn what_cannot_be_asked_is_told() {
    let scene = slide("");
    let phase = Rules { phase: Some("fall".to_owned()), ..Rules::default() };
    let told = text(&scene, &phase).unwrap_err().to_string();
    assert_eq!(told, "there is no phase `fall`; valid names: slide");
    for factor in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let rules = Rules { factor, ..Rules::default() };
        assert!(matches!(text(&scene, &rules), Err(RemovableError::Factor)));
    }
    let flat = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes/verify/planar/rest.toml");
    let flat = of(&Scene::load(&flat, &[]).unwrap(), &Rules::default());
    assert!(matches!(flat, Err(RemovableError::Planar)));
}

#[test]
fn a_picture_holds_what_was_found() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes/spatial/wedge.toml");
    let scene = Scene::load(&path, &[]).unwrap();
    let job = scene.prepare(&scene.plain()).unwrap().job();
    let (setup, plan) = (job.setup.clone(), job.plan.clone());
    let answer = removable(setup, plan, &Rules::default(), Exec::serial()).unwrap();
    let folder = tempfile::tempdir().unwrap();
    let run = folder.path().join("wedge.blocks");
    answer.show(job.clone(), &run, Existing::Refuse).unwrap();
    let frame = vtu::read(&run.join(block_file(1))).unwrap();
    let column = |name: &str| {
        let found = frame.cell_columns.iter().find(|column| column.name == name);
        found.unwrap_or_else(|| panic!("no {name}")).data.clone()
    };
    let count = |name: &str, value: f64| column(name).iter().filter(|v| **v == value).count();
    // One block that slides on two planes, one that its weight holds, nine that are ground.
    assert_eq!([0.0, 1.0, 2.0, 3.0].map(|kind| count("removable_type", kind)), [9, 0, 1, 1]);
    assert_eq!([0.0, 1.0, 3.0].map(|mode| count("removable_mode", mode)), [9, 1, 1]);
    let driven: Vec<f64> =
        column("removable_factor").into_iter().filter(|f| f.is_finite()).collect();
    assert_eq!(driven, [answer.blocks[0].factor_of_safety]);
    let fields = Manifest::read(&run).unwrap().fields;
    assert!(fields.iter().any(|field| field.name == "removable_support" && field.unit == "N"));
    // What is there stays.
    let again = answer.show(job, &run, Existing::Refuse).unwrap_err().to_string();
    assert!(again.contains("already contains a run"), "{again}");
}
