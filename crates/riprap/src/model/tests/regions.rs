//! Groups by place, size, material and name.

use super::*;
use crate::setup::Setup;
use riprap_geom::Vec3;

/// Four by four bricks of a metre; the upper row of another material.
const BRICKS: &str = r#"
[materials.ore]
density = "3000 kg/m3"
young = "18 GPa"
poisson = 0.25
[[blocks]]
name = "low"
material = "rock"
grid.box = { size = ["4 m", "4 m", "3 m"], cell = "1 m" }
[[blocks]]
name = "high"
material = "ore"
grid.box = { size = ["4 m", "4 m", "2 m"], cell = "2 m", corner = ["0 m", "0 m", "3 m"] }
"#;

fn try_space(groups: &str) -> Result<Model, Diagnostics> {
    let fields = crate::run::engine::Kind::Spatial.fields();
    let text = format!("{SPACE}{BRICKS}{groups}{TAIL}");
    build(&parse(Source::new("t.toml", text))?, "default", fields)
}

/// Number of blocks of the group `it`.
fn count(groups: &str) -> usize {
    let model = try_space(groups).unwrap_or_else(|error| panic!("{error}"));
    let Setup::Spatial(setup) = &model.setup else { panic!("a scene in space") };
    let it = setup.groups.iter().find(|group| group.name == "it");
    it.map_or(0, |group| group.blocks.len())
}

#[test]
fn every_shape_holds_the_blocks_whose_centroid_lies_in_it() {
    for (shape, blocks) in [
        ("box = { min = [\"0 m\", \"0 m\", \"0 m\"], max = [\"1 m\", \"4 m\", \"1 m\"] }", 4),
        ("half_space = { at = [\"0 m\", \"0 m\", \"1 m\"], normal = [0, 0, -2] }", 16),
        ("sphere = { centre = [\"0.5 m\", \"0.5 m\", \"0.5 m\"], radius = \"1.1 m\" }", 4),
        (
            "cylinder = { from = [\"2 m\", \"2 m\", \"0 m\"], to = [\"2 m\", \"2 m\", \"3 m\"], radius = \"0.8 m\" }",
            12,
        ),
        (
            "near = { from = [\"0.5 m\", \"0.5 m\", \"0.5 m\"], to = [\"3.5 m\", \"0.5 m\", \"0.5 m\"], distance = \"0.1 m\" }",
            4,
        ),
        (
            "prism = { points = [[\"0 m\", \"0 m\"], [\"4 m\", \"0 m\"], [\"0 m\", \"4 m\"]], to = \"1 m\" }",
            6,
        ),
        (
            "excavation = { from = [\"2 m\", \"0 m\", \"0 m\"], to = [\"2 m\", \"4 m\", \"0 m\"], horseshoe = { width = \"2 m\", height = \"2 m\" } }",
            16,
        ),
        (
            "excavation = { from = [\"1 m\", \"2 m\", \"3 m\"], to = [\"1 m\", \"2 m\", \"0 m\"], polygon = [[\"1 m\", \"0 m\"], [\"3 m\", \"0 m\"], [\"3 m\", \"1 m\"], [\"1 m\", \"1 m\"]] }",
            6,
        ),
        (
            "near_face = { points = [[\"0 m\", \"0 m\", \"0 m\"], [\"2 m\", \"0 m\", \"0 m\"], [\"2 m\", \"4 m\", \"0 m\"], [\"0 m\", \"4 m\", \"0 m\"]], distance = \"0.6 m\" }",
            8,
        ),
        ("size = { above = \"1.5 m\" }", 4),
        ("size = { above = \"0.9 m\", below = \"1.5 m\" }", 48),
        ("material = \"ore\"", 4),
        ("blocks = [\"low.1\", \"high\"]", 5),
        // All that one of the keys holds.
        ("material = \"ore\"\nblocks = [\"low.1\"]", 5),
    ] {
        assert_eq!(count(&format!("[groups.it]\n{shape}\n")), blocks, "{shape}");
    }
}

#[test]
fn conditions_make_groups_of_groups() {
    let shapes = "[groups.east]\nhalf_space = { at = [\"2 m\", \"0 m\", \"0 m\"], normal = [1, 0, 0] }\n\
        [groups.'far away']\nhalf_space = { at = [\"0 m\", \"2 m\", \"0 m\"], normal = [0, 1, 0] }\n";
    for (condition, blocks) in [
        ("east and low", 24),
        ("not east", 24 + 2),
        ("east and not ore", 24),
        ("east or 'far away' and ore", 24 + 2 + 1),
        ("(east or 'far away') and ore", 3),
        ("not (east or 'far away')", 12 + 1),
        ("later and ore", 2),
    ] {
        let text = format!(
            "[groups.it]\nwhere = \"{condition}\"\n{shapes}[groups.later]\nwhere = \"east\"\n"
        );
        assert_eq!(count(&text), blocks, "{condition}");
    }
}

#[test]
fn faults_of_conditions_are_told() {
    let told = |condition: &str| {
        try_space(&format!("[groups.it]\nwhere = \"{condition}\"\n")).unwrap_err().render()
    };
    for (condition, words) in [
        ("low and", "a name is missing"),
        ("low high", "`high` is not expected here"),
        ("(low or high", "a parenthesis is not closed"),
        ("lou", "there is no group, block or material `lou`"),
        ("it", "refer to each other in a circle"),
    ] {
        assert!(told(condition).contains(words), "{condition}: {}", told(condition));
    }
    let material = try_space("[groups.it]\nmaterial = \"oar\"\n").unwrap_err().render();
    assert!(material.contains("`oar`") && material.contains("ore"), "{material}");
    let normal =
        "[groups.it]\nhalf_space = { at = [\"0 m\", \"0 m\", \"0 m\"], normal = [0, 0, 0] }\n";
    assert!(try_space(normal).unwrap_err().render().contains("has no length"));
}

#[test]
fn a_group_of_a_broken_file_is_no_second_fault() {
    let told = try_space(
        "[groups.top]\nabove.asc = \"not_there.asc\"\n[groups.some]\nwhere = \"top and low\"\n\
         [[supports]]\non.group = \"some and high\"\nfixed = {}\n",
    );
    let told = told.unwrap_err().render();
    assert!(told.contains("not_there.asc"), "{told}");
    assert_eq!(told.matches("group.empty").count(), 0, "{told}");
}

/// A scene whose keys take `low and not (ore or low.1)` in place of the name of a group.
fn inline(condition: &str) -> Result<Model, Diagnostics> {
    try_space(&format!(
        "[[supports]]\non.group = \"{condition}\"\nfixed = {{}}\n\
         [[loads]]\non.group = \"not ({condition})\"\npoint.force = [\"1 N\", \"0 N\", \"0 N\"]\n\
         [[outputs]]\nhistory = {{ name = \"v\", field = \"group.volume\", of = \"{condition}\", every = \"1 s\" }}\n\
         [[phases]]\nname = \"first\"\nuntil.steps = 1\nremove = [\"high and 'ore'\"]\n"
    ))
}

#[test]
fn a_condition_stands_wherever_a_group_does() {
    let model = inline("low and not (ore or low.1)").unwrap_or_else(|error| panic!("{error}"));
    let Setup::Spatial(setup) = &model.setup else { panic!("a scene in space") };
    assert_eq!(setup.supports.iter().map(|s| s.blocks.len()).sum::<usize>(), 47);
    assert_eq!(setup.loads.iter().map(|l| l.blocks.len()).sum::<usize>(), 5);
    assert_eq!(model.plan.histories[0].gauge.of.len(), 47);
    assert_eq!(model.plan.phases[0].remove.len(), 4);
}

#[test]
fn a_wrong_word_of_a_condition_is_shown_at_its_place() {
    for (condition, words, marks) in [
        ("low and not (ore or kow)", "there is no group, block or material `kow`", "^^^"),
        ("low and and ore", "a name is missing", "^^^"),
        ("low and ore)", "`)` is not expected here", "^"),
        ("low and ore", "no block fulfils `low and ore`", "^^^^^^^^^^^^^"),
    ] {
        let told = inline(condition).map(|_| ()).unwrap_err().render();
        assert!(told.contains(words), "{condition}: {told}");
        let marked = told.lines().any(|l| l.split_whitespace().any(|word| word == marks));
        assert!(marked, "{condition}: {told}");
    }
}

#[test]
fn an_empty_region_names_the_nearest_blocks() {
    let far =
        "[groups.it]\nsphere = { centre = [\"0.5 m\", \"0.5 m\", \"-9 m\"], radius = \"1 m\" }\n";
    let model = try_space(far).unwrap_or_else(|error| panic!("{error}"));
    let note = model.warnings.iter().find(|note| note.code == "group.empty").unwrap();
    assert_eq!(note.message, "no block centroid lies in the sphere of `it`");
    let help = note.help.clone().unwrap();
    assert!(
        help.contains("nearest to its middle: `low.1` at (0.5000, 0.5000, 0.5000) m"),
        "{help}"
    );
    let none = "[groups.it]\nwhere = \"low and high\"\n";
    let model = try_space(none).unwrap_or_else(|error| panic!("{error}"));
    let note = model.warnings.iter().find(|note| note.code == "group.empty").unwrap();
    assert_eq!(
        note.help.as_deref(),
        Some("`low` has 48 blocks, `high` has 4 blocks; the group is empty")
    );
}

#[test]
fn the_plane_has_regions_too() {
    let wall = "[[blocks]]\nname = \"wall\"\nmaterial = \"rock\"\n\
        wall = { corner = [\"0 m\",\"0 m\"], block = [\"1 m\",\"1 m\"], courses = 3, per_course = 4, bond = \"stack\" }\n";
    for (shape, blocks) in [
        ("half_space = { at = [\"0 m\", \"1 m\"], normal = [0, 1] }", 8),
        ("sphere = { centre = [\"0.5 m\", \"0.5 m\"], radius = \"1.1 m\" }", 3),
        (
            "near = { from = [\"0.5 m\", \"0.5 m\"], to = [\"3.5 m\", \"0.5 m\"], distance = \"0.1 m\" }",
            4,
        ),
        (
            "prism = { points = [[\"0 m\", \"0 m\"], [\"2 m\", \"0 m\"], [\"2 m\", \"3 m\"], [\"0 m\", \"3 m\"]] }",
            6,
        ),
        ("size = { below = \"1.1 m\" }", 12),
    ] {
        let model = good(&format!("{wall}[groups.it]\n{shape}\n"));
        let Setup::Planar(setup) = &model.setup else { panic!("a scene in the plane") };
        let it = setup.groups.iter().find(|group| group.name == "it").unwrap();
        assert_eq!(it.blocks.len(), blocks, "{shape}");
    }
}

#[test]
fn the_model_must_lie_within_the_bounds_that_blocks_leave() {
    let text = |leavers: &str| {
        format!(
            "{CUBE}{FLOOR}[[phases]]\nname = \"fly\"\nuntil = {{ time = \"1 s\" }}\nleavers = {{ {leavers} }}\n"
        )
    };
    let wide = "outside = { min = [\"-9 m\", \"-9 m\"], max = [\"9 m\", \"9 m\"] }";
    let model = good(&text(wide));
    let bounds = model.plan.phases[0].leavers.expect("bounds");
    assert!(bounds.outside.is_some() && bounds.beyond.is_none());
    let narrow = "outside = { min = [\"-9 m\", \"-9 m\"], max = [\"0.4 m\", \"9 m\"] }";
    assert!(bad(&text(narrow)).contains("before anything moves, `cube` first"));
    let over = "beyond = { at = [\"0 m\", \"0 m\"], normal = [0, 1] }";
    assert!(bad(&text(over)).contains("before anything moves, `cube` first"));
    let none = "beyond = { at = [\"0 m\", \"9 m\"], normal = [0, 0] }";
    assert!(bad(&text(none)).contains("is zero"));
    assert!(bad(&text("")).contains("outside"));
}

/// A block of 8 m cut by the surface of a drift and by two joints that dip east.
fn drift(group: &str, along: &str) -> String {
    format!(
        "[interfaces.intact]\nnormal_stiffness = \"1 GPa/m\"\nfriction_angle = \"50 deg\"\n\
         [[blocks]]\nname = \"rock\"\nmaterial = \"rock\"\n\
         brick = {{ size = [\"8 m\", \"8 m\", \"8 m\"], corner = [\"10 m\", \"0 m\", \"0 m\"] }}\n\
         [blocks.cut]\njoint_sets = [{{ dip = \"0 deg\", dip_direction = \"90 deg\", spacing = \"20 m\", origin = [\"0 m\", \"0 m\", \"6 m\"] }}]\n\
         along = {{ groups = [{along}], interface = \"intact\" }}\n[groups.it]\n{group}\n"
    )
}

const LINE: &str = "from = [\"14 m\", \"0 m\", \"2 m\"], to = [\"14 m\", \"8 m\", \"2 m\"]";

#[test]
fn rock_is_cut_along_a_drift_into_rounds() {
    let group = format!(
        "excavation = {{ {LINE}, horseshoe = {{ width = \"4 m\", height = \"3 m\", sides = 4 }}, rounds = 2 }}"
    );
    let model = try_space(&drift(&group, "\"it\"")).unwrap_or_else(|error| panic!("{error}"));
    let Setup::Spatial(setup) = &model.setup else { panic!("a scene in space") };
    let volume = |name: &str| -> f64 {
        let group = setup.groups.iter().find(|group| group.name == name).unwrap();
        let blocks = group.blocks.iter().map(|b| &setup.blocks[*b as usize].shape);
        blocks.map(crate::model::solid::volume).sum()
    };
    // Floor to spring line, and four triangles of the arch.
    let area = 4.0 + 4.0 * 2.0 * libm::sin(std::f64::consts::FRAC_PI_4);
    for (name, length) in [("it", 8.0), ("it.1", 4.0), ("it.2", 4.0)] {
        assert!((volume(name) - area * length).abs() < 1e-9, "{name}: {}", volume(name));
    }
    assert!((volume("rock") - 512.0).abs() < 1e-9);
    // The cuts are whole rock, the joint is not.
    let row = |at: [f64; 3], normal: [f64; 3]| {
        setup.row_at([0, 0], Vec3::from(at) - setup.origin, normal.into())
    };
    let intact = row([12.0, 4.0, 2.5], [1.0, 0.0, 0.0]);
    assert_ne!(intact, row([12.0, 4.0, 6.0], [0.0, 0.0, 1.0]));
    assert_eq!(intact, row([12.0, 7.0, 7.0], [-1.0, 0.0, 0.0]), "beyond the drift too");
}

#[test]
fn a_joint_set_holds_the_blocks_along_its_joints() {
    let set =
        |number: u32| drift(&format!("joint_set = {{ of = \"rock\", number = {number} }}"), "");
    // The joint at 6 m divides the block in two: `along` is empty.
    assert_eq!(count(&set(1)), 2);
    let wrong = try_space(&set(2)).unwrap_err().render();
    assert!(wrong.contains("`rock` has 1 joint set"), "{wrong}");
}

#[test]
fn faults_of_excavations_are_told() {
    let ramp = |said: &str| {
        format!(
            "excavation = {{ {LINE}, benches = {{ height = \"1 m\", face_angle = \"60 deg\", berm = \"1 m\", count = 2, floor = \"2 m\", ramps = [{{ {said} }}] }} }}"
        )
    };
    for (group, words) in [
        (
            format!("excavation = {{ {LINE}, polygon = [[\"0 m\", \"0 m\"], [\"1 m\", \"1 m\"], [\"1 m\", \"0 m\"], [\"0 m\", \"1 m\"]] }}"),
            "the profile is no polygon",
        ),
        (
            format!("excavation = {{ {LINE}, horseshoe = {{ width = \"4 m\", height = \"1 m\" }} }}"),
            "at least half as high as wide",
        ),
        (
            format!("excavation = {{ {LINE}, benches = {{ height = \"4 m\", face_angle = \"100 deg\", berm = \"1 m\", count = 1, floor = \"1 m\" }} }}"),
            "a face cannot rise by",
        ),
        (ramp("width = \"3 m\", grade = 1"), "wider than the floor it stands on"),
        (ramp("width = \"2 m\", grade = 1, bench = 3"), "no bench 3 for a ramp"),
        (ramp("width = \"1.5 m\", grade = 1, bench = 2"), "wider than the berm it stands on"),
        (ramp("width = \"2 m\", grade = 0.05"), "the ramp ends 20"),
        (format!("excavation = {{ {LINE} }}"), "circle"),
        (
            "sphere = { centre = [\"14 m\", \"4 m\", \"4 m\"], radius = \"1 m\" }".to_owned(),
            "no surface to cut along",
        ),
        (
            "near_face = { points = [[\"0 m\", \"0 m\", \"0 m\"], [\"1 m\", \"0 m\", \"0 m\"], [\"2 m\", \"0 m\", \"0 m\"]], distance = \"1 m\" }\nbox = { min = [\"10 m\", \"0 m\", \"0 m\"], max = [\"12 m\", \"8 m\", \"8 m\"] }"
                .to_owned(),
            "the face has no area",
        ),
    ] {
        let told = try_space(&drift(&group, "\"it\"")).unwrap_err().render();
        assert!(told.contains(words), "{group}: {told}");
    }
    let pattern = "[[bolts]]\nname = \"b\"\npattern = { group = \"drift\", length = \"2 m\", spacing = \"1 m\", rows = \"1 m\" }\n\
        steel = { diameter = \"25 mm\" }\ngrout = { stiffness = \"1 GN/m2\" }\n[groups.drifts]\nexcavation = { from = [\"0 m\", \"0 m\", \"0 m\"], to = [\"0 m\", \"1 m\", \"0 m\"], circle = { radius = \"1 m\" } }\n";
    let told = try_space(pattern).unwrap_err().render();
    assert!(
        told.contains("no group with an `excavation` `drift`") && told.contains("drifts"),
        "{told}"
    );
}

#[test]
fn bolts_are_chosen_by_the_block_of_their_collar() {
    let with = |condition: &str| {
        try_space(&format!(
            "[groups.it]\nbox = {{ min = [\"0 m\", \"0 m\", \"0 m\"], max = [\"1 m\", \"1 m\", \"3 m\"] }}\n\
             [[bolts]]\nname = \"b\"\nhead = [\"0 m\", \"0.5 m\", \"0.5 m\"]\ntoe = [\"1.8 m\", \"0.5 m\", \"0.5 m\"]\n\
             repeat = [{{ step = [\"0 m\", \"1 m\", \"0 m\"], count = 4 }}, {{ step = [\"0 m\", \"0 m\", \"1 m\"], count = 3 }}]\n\
             where = \"{condition}\"\nsteel = {{ diameter = \"25 mm\" }}\ngrout = {{ stiffness = \"1 GN/m2\" }}\n"
        ))
    };
    let names = |condition: &str| -> Vec<String> {
        let model = with(condition).unwrap_or_else(|error| panic!("{error}"));
        let Setup::Spatial(setup) = &model.setup else { panic!("a scene in space") };
        setup.bolts.iter().map(|bolt| bolt.name.clone()).collect()
    };
    // Three rows of four; the first column begins in `it`, all go on behind it.
    assert_eq!(names("it"), ["b.1", "b.2", "b.3"]);
    assert_eq!((names("low and not it").len(), names("not ore").len()), (9, 12));
    for (condition, words) in [
        ("high", "no bolt of `b` has its collar in `high`"),
        ("low and lower", "`lower`"),
        ("low and and it", "a name is missing"),
        ("it and high", "no block fulfils"),
    ] {
        let told = with(condition).unwrap_err().render();
        assert!(told.contains(words) && told.contains("where ="), "{condition}: {told}");
    }
}

#[test]
fn faults_of_walls_and_vaults_are_told() {
    let made = |shape: &str| {
        let block = format!(
            "[[blocks]]\nname = \"w\"\nmaterial = \"rock\"\n{shape}\nshift = [\"20 m\", \"0 m\", \"0 m\"]\n"
        );
        try_space(&block).unwrap_err().render()
    };
    let wall = |opening: &str| {
        made(&format!(
            "masonry = {{ length = \"2 m\", brick = [\"0.4 m\", \"0.2 m\", \"0.2 m\"], courses = 5, openings = [{{ {opening} }}] }}"
        ))
    };
    let rows = wall("left = \"0 m\", width = \"1 m\", height = \"0.5 m\"");
    assert!(rows.contains("2.5") && rows.contains("0.4 m or 0.6"), "{rows}");
    let beyond = wall("left = \"1.5 m\", width = \"1 m\", height = \"0.4 m\"");
    assert!(beyond.contains("reaches beyond the wall"), "{beyond}");
    let vault = made(
        "vault = { from = [\"0 m\", \"0 m\", \"0 m\"], to = [\"0 m\", \"1 m\", \"1 m\"], radius = \"2 m\", thickness = \"0.2 m\", half_angle = \"60 deg\", voussoirs = 5 }",
    );
    assert!(vault.contains("is not level"), "{vault}");
    let pier = |said: &str| {
        made(&format!(
            "masonry = {{ length = \"2 m\", brick = [\"0.4 m\", \"0.2 m\", \"0.2 m\"], courses = 5, openings = [{{ left = \"1 m\", width = \"0.5 m\", height = \"0.4 m\" }}], buttresses = [{{ {said} }}] }}"
        ))
    };
    for (said, words) in [
        (
            "left = \"1.8 m\", width = \"0.4 m\", foot = \"1 m\", top = \"0.5 m\"",
            "reaches beyond the wall",
        ),
        (
            "left = \"0.8 m\", width = \"0.4 m\", foot = \"1 m\", top = \"0.5 m\"",
            "stands before an opening",
        ),
        ("left = \"0 m\", width = \"0.4 m\", foot = \"0.5 m\", top = \"1 m\"", "deeper at its top"),
        (
            "left = \"0 m\", width = \"0.4 m\", foot = \"1 m\", top = \"0.5 m\", height = \"0.5 m\"",
            "2.5",
        ),
    ] {
        let told = pier(said);
        assert!(told.contains(words), "{said}: {told}");
    }
    for (said, words) in [
        ("thickness = \"4 m\", half_angle = \"90 deg\"", "thick as the sphere"),
        ("thickness = \"0.2 m\", half_angle = \"180 deg\"", "lowest point"),
        (
            "thickness = \"0.2 m\", half_angle = \"60 deg\", oculus = \"60 deg\"",
            "reaches to the springing",
        ),
    ] {
        let told =
            made(&format!("dome = {{ radius = \"2 m\", {said}, rings = 3, voussoirs = 8 }}"));
        assert!(told.contains(words), "{said}: {told}");
    }
}

#[test]
fn a_surface_that_holds_nothing_names_the_blocks_nearest_to_it() {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../../scenes/verify/engineering/data");
    let built = |group: &str| {
        let fields = crate::run::engine::Kind::Spatial.fields();
        let text = format!("{SPACE}{BRICKS}[groups.it]\n{group}\n{TAIL}");
        let mut parsed = parse(Source::new("t.toml", text)).unwrap_or_else(|e| panic!("{e}"));
        parsed.folder.clone_from(&folder);
        build(&parsed, "default", fields).unwrap_or_else(|error| panic!("{error}"))
    };
    let told = |group: &str| {
        let found = built(group).warnings;
        found
            .iter()
            .map(|d| format!("{} {}", d.message, d.help.as_deref().unwrap_or("")))
            .collect::<String>()
    };
    // In mm the ore is 6 mm large, about the origin.
    let told = told("inside = { stl = \"ore.stl\", unit = \"1 mm\" }");
    assert!(told.contains("no block centroid lies in the inside of the surface of `it`"), "{told}");
    assert!(told.contains("`low.1` at (0.5000, 0.5000, 0.5000) m"), "{told}");
}
