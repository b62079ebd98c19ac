//! Groups by place, size, material and name.

use super::*;
use crate::setup::Setup;

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
