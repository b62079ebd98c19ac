//! Models in space: `[space.spatial]` through `build`.

use super::*;
use crate::laws::jwl::Jwl;
use crate::record::field::{FieldInfo, Shape as FieldShape, Site};
use crate::spatial::setup::{
    BoundaryKind, CavityPressure, Coupling, Criterion, Dashpots, FaceSet, Kinematics, Motion,
    Place, Points, Products, Region, Setup, Shape, Stiffness, StiffnessRule,
};
use riprap_geom::Vec3;

mod bodies;
mod graded;
mod holes;
mod parts;
mod turn;

const GRID: &str = r#"
[[blocks]]
name = "rock"
material = "rock"
grid.box = { size = ["4 m", "4 m", "4 m"], cell = "1 m" }
"#;

const CHARGE: &str = r#"
[explosives.anfo]
density = "1000 kg/m3"
detonation_velocity = "4000 m/s"
heat_of_explosion = "4180 kJ/kg"
[sources.charge.gas_cavity]
centre = ["2 m", "2 m", "2 m"]
mass = "16 kg"
explosive = "anfo"
"#;

/// Fields that the engine will have, as far as the tests need them.
const FIELDS: &[FieldInfo] = &[
    FieldInfo {
        name: "block.velocity",
        unit: "m/s",
        site: Site::Block,
        shape: FieldShape::Vector3,
        meaning: "",
    },
    FieldInfo {
        name: "cavity.pressure",
        unit: "Pa",
        site: Site::Cavity,
        shape: FieldShape::Scalar,
        meaning: "",
    },
];

fn try_solid(text: &str) -> Result<Model, Diagnostics> {
    build(&parse(Source::new("t.toml", text))?, "default", FIELDS)
}

fn solid(middle: &str) -> (Setup, Model) {
    let model =
        try_solid(&format!("{SPACE}{middle}{TAIL}")).unwrap_or_else(|error| panic!("{error}"));
    let crate::model::Setup::Spatial(setup) = model.setup.clone() else { panic!("a planar setup") };
    (*setup, model)
}

fn refused(middle: &str) -> String {
    let text = format!("{SPACE}{middle}{TAIL}");
    try_solid(&text).expect_err("should be refused").render()
}

fn brick(shape: &Shape) -> (Vec3, Vec3) {
    match shape {
        Shape::Brick { centre, half } => (*centre, *half),
        Shape::Polyhedron(_) | Shape::Terrain(_) | Shape::Glued(_) => panic!("no brick"),
    }
}

#[test]
fn a_grid_in_numbers() {
    let (setup, model) = solid(GRID);
    assert_eq!(setup.gravity, Vec3::new(0.0, 0.0, -10.0));
    assert_eq!(setup.kinematics, Kinematics::Automatic);
    assert_eq!(setup.rotation_bound(), 0.01);
    assert_eq!((setup.blocks.len(), setup.names.len()), (64, 1));
    // x runs fastest; names count from 1.
    let second = &setup.blocks[1];
    assert_eq!(second.name.number, 2);
    assert_eq!(brick(&second.shape), (Vec3::new(1.5, 0.5, 0.5), Vec3::splat(0.5)));
    assert_eq!(brick(&setup.blocks[63].shape).0, Vec3::splat(3.5));
    let joint = setup.interfaces[0].joint;
    assert_eq!(
        (joint.stiffness, joint.points),
        (Stiffness::Rule(StiffnessRule::Material), Points::Gauss)
    );
    assert_eq!(joint.damping, 0.1);
    let strength = joint.strength.unwrap();
    assert!((strength.friction - 1.0).abs() < 1e-15 && strength.cohesion == 0.0);
    assert_eq!(setup.groups[0].blocks.len(), 64);
    let s = &model.summary;
    assert_eq!((s.blocks, s.mass), (64, 128_000.0));
    assert_eq!(s.solid_bounds, Some([[0.0; 3], [4.0; 3]]));
    let phase = &model.plan.phases[0];
    assert_eq!(phase.time_step, TimeStep::Auto { safety: 0.5 });
    assert!(model.warnings.is_empty(), "{:?}", model.warnings);
}

#[test]
fn shapes_are_shifted_and_copied() {
    let (setup, model) = solid(
        r#"
[[blocks]]
name = "row"
material = "rock"
brick = { size = ["1 m", "2 m", "3 m"], centre = ["0 m", "0 m", "0 m"] }
shift = ["0 m", "0 m", "10 m"]
copies = { count = 3, step = ["1 m", "0 m", "0 m"] }
spin = ["0 rad/s", "0 rad/s", "1 rad/s"]
[[blocks]]
name = "hull"
material = "rock"
polyhedron.vertices = [["0 m","0 m","0 m"], ["1 m","0 m","0 m"], ["0 m","1 m","0 m"], ["0 m","0 m","1 m"], ["0.1 m","0.1 m","0.1 m"]]
shift = ["0 m", "0 m", "1 m"]
"#,
    );
    assert_eq!(
        brick(&setup.blocks[2].shape),
        (Vec3::new(2.0, 0.0, 10.0), Vec3::new(0.5, 1.0, 1.5))
    );
    assert_eq!(setup.blocks[0].spin, Vec3::Z);
    let Shape::Polyhedron(hull) = &setup.blocks[3].shape else { panic!() };
    // The corner inside is dropped.
    assert_eq!((hull.vertices.len(), hull.faces.len()), (4, 4));
    let mass = 2000.0 * (18.0 + 1.0 / 6.0);
    assert!((model.summary.mass / mass - 1.0).abs() < 1e-12);
}

/// Cells of a disk: a prism with many sides inside the box; a box that is not square or a silly number is refused.
#[test]
fn cells_of_a_disk() {
    let cells = |keys: &str| {
        format!(
            "[[blocks]]\nname = \"disk\"\nmaterial = \"rock\"\ngrid.cells = {{ cell = \"0.5 m\", {keys} }}\n"
        )
    };
    let square = r#"size = ["2 m", "2 m", "1 m"]"#;
    let (setup, _) = solid(&cells(&format!("{square}, sides = 36")));
    let volume: f64 = setup
        .blocks
        .iter()
        .map(|b| match &b.shape {
            Shape::Brick { .. } | Shape::Terrain(_) | Shape::Glued(_) => f64::NAN,
            Shape::Polyhedron(s) => {
                let solid =
                    riprap_geom::polyhedron::Polyhedron::new(s.vertices.clone(), s.faces.clone());
                solid.map_or(f64::NAN, |solid| solid.moments().volume)
            }
        })
        .sum();
    let area = 36.0 * libm::tan(std::f64::consts::PI / 36.0);
    assert!((volume - area).abs() < 1e-9, "{volume}");
    assert!(refused(&cells(&format!("{square}, sides = 2"))).contains("sides"));
    let oblong = cells(r#"size = ["2 m", "1 m", "1 m"], sides = 36"#);
    assert!(refused(&oblong).contains("not square"));
}

#[test]
fn groups_and_targets_by_place() {
    let (setup, _) = solid(&format!(
        r#"{GRID}
[groups.low]
box = {{ min = ["0 m","0 m","0 m"], max = ["4 m","4 m","1 m"] }}
[groups.two]
blocks = ["rock.1", "rock.64"]
[[supports]]
on = {{ group = "low" }}
fixed = {{ rotation = false, rotation_z = true }}
[[supports]]
on.box = {{ min = ["0 m","0 m","3 m"], max = ["1 m","1 m","4 m"] }}
motion.velocity.z.constant = "1 m/s"
"#
    ));
    assert_eq!(setup.supports[0].blocks, (0..16).collect::<Vec<u32>>());
    assert_eq!(
        setup.supports[0].motion,
        Motion::Fixed { translation: [true; 3], rotation: [false, false, true] }
    );
    assert_eq!(setup.supports[1].blocks, [48]);
    let two = setup.groups.iter().find(|g| g.name == "two").unwrap();
    assert_eq!(two.blocks, [0, 63]);
}

#[test]
fn coordinates_far_away_get_an_origin_of_their_own() {
    let far = GRID.replace(
        "cell = \"1 m\"",
        "cell = \"1 m\", corner = [\"500000 m\", \"5200000 m\", \"0 m\"]",
    );
    let (setup, model) = solid(&format!(
        r#"{far}
[[checks]]
name = "v"
field = "block.velocity.x"
at_point = ["500003.5 m", "5200003.5 m", "0.5 m"]
value = "0 m/s"
absolute = "1 m/s"
"#
    ));
    assert!((setup.origin - Vec3::new(5e5, 5.2e6, 0.0)).length() < 10.0);
    let (centre, _) = brick(&setup.blocks[0].shape);
    assert_eq!(centre + setup.origin, Vec3::new(500_000.5, 5_200_000.5, 0.5));
    let at = Vec3::from(model.checks[0].gauge.at.unwrap()) + setup.origin;
    assert_eq!(at, Vec3::new(500_003.5, 5_200_003.5, 0.5));
    assert_eq!(model.warnings.len(), 1);
}

#[test]
fn charges_are_placed_coupled_and_weighed() {
    let coupled = format!("{CHARGE}coupling = \"coupled\"\n");
    let (setup, model) = solid(&format!(
        "{GRID}{coupled}\n[[refine]]\noctree = {{ around = \"charge\", levels = 2 }}\n"
    ));
    let source = &setup.sources[0];
    assert_eq!(source.place, Place::Point { centre: Vec3::splat(2.0) });
    assert!(matches!(
        source.push,
        CavityPressure::Gas { mass: 16.0, coupling: Coupling::Coupled, venting: None, .. }
    ));
    assert_eq!(setup.refinements[0].around, Region::Point(Vec3::splat(2.0)));
    // Eight cells of 1/4 m against 16 kg of density 1000.
    let charge = &model.summary.charges[0];
    assert_eq!((charge.blocks, charge.cavity), (8, 0.125));
    assert!((charge.ratio.unwrap() - 7.8125).abs() < 1e-12);
    // Its joints can fail.
    let codes: Vec<&str> = model.warnings.iter().map(|w| w.code).collect();
    assert_eq!(codes, ["source.lattice"], "{:?}", model.warnings);
}

#[test]
fn grids_are_fitted_to_a_charge() {
    let scene = format!("{GRID}{CHARGE}\n[[refine]]\noctree = {{ around = \"charge\" }}\n");
    let (setup, model) = solid(&scene);
    let charge = &model.summary.charges[0];
    assert_eq!(charge.blocks, 8);
    assert!((charge.ratio.unwrap() - 1.0).abs() < 1e-12, "{charge:?}");
    // 0.016 m3 / 8 = 0.002 m3 = (0.126 m)^3: three levels below 1.008 m.
    assert_eq!(setup.refinements[0].levels, 3);
    let (centre, half) = brick(&setup.blocks[0].shape);
    assert!((2.0 * half.x - 1.012).abs() < 1e-3, "{half}");
    // The depth of the charge is whole cells, exactly.
    assert_eq!(half.z, 0.5);
    assert!((centre - half).z.abs() < 1e-12);
    assert_eq!(setup.blocks.len(), 64);
    assert_eq!(model.warnings[0].code, "grid.fitted");
    let told = model.explained.iter().find(|e| e.key == "blocks.rock.grid.box.cell").unwrap();
    assert_eq!(told.from, Provenance::Derived);
    // On a side of the grid, as on a plane of symmetry, four cells make the volume.
    let side = scene
        .replace("[\"2 m\", \"2 m\", \"2 m\"]", "[\"0 m\", \"2 m\", \"2 m\"]")
        .replace("\"charge\" }", "\"charge\", levels = 3 }");
    let (setup, model) = solid(&side);
    assert_eq!(model.summary.charges[0].blocks, 4);
    assert!((model.summary.charges[0].ratio.unwrap() - 1.0).abs() < 1e-12);
    let (centre, half) = brick(&setup.blocks[0].shape);
    assert!((centre - half).x.abs() < 1e-12);
}

/// A charge with these lines in place of the constants of its explosive.
fn with_explosive(lines: &str) -> String {
    let constants = "density = \"1000 kg/m3\"\ndetonation_velocity = \"4000 m/s\"\nheat_of_explosion = \"4180 kJ/kg\"";
    assert!(CHARGE.contains(constants));
    format!("{GRID}{}coupling = \"coupled\"\n", CHARGE.replace(constants, lines))
}

#[test]
fn explosives_have_one_equation_of_state() {
    let (setup, model) = solid(&with_explosive("jwl = \"anfo\""));
    let CavityPressure::Gas { explosive, .. } = &setup.sources[0].push else { panic!("no gas") };
    assert_eq!(*explosive, Products::Jwl(Jwl::ANFO));
    // 16 kg in eight cells of 1 m3.
    assert!((model.summary.charges[0].ratio.unwrap() - 8.0 * 931.0 / 16.0).abs() < 1e-9);
    let own = "jwl = { a = \"49.46 GPa\", b = \"1.891 GPa\", r1 = 3.907, r2 = 1.118, omega = 0.33333, energy = \"2.484 GPa\" }";
    let (setup, _) = solid(&with_explosive(&format!("density = \"931 kg/m3\"\n{own}")));
    let CavityPressure::Gas { explosive, .. } = &setup.sources[0].push else { panic!("no gas") };
    assert_eq!(*explosive, Products::Jwl(Jwl::ANFO));
    for (lines, said) in [
        ("jwl = \"anfo\"\ngamma = 3", "belongs to the two-stage adiabat"),
        ("jwl = \"anfo\"\ndensity = \"900 kg/m3\"", "published constants are of 931 kg/m3"),
        ("jwl = \"anfo\"\ndetonation_velocity = \"5000 m/s\"", "detonate at 4159 m/s"),
        (own, "no density"),
        ("density = \"1000 kg/m3\"", "detonation_velocity"),
        ("jwl = \"dynamite\"", "emulsion"),
    ] {
        let text = refused(&with_explosive(lines));
        assert!(text.contains(said), "{lines}: {text}");
    }
    let weak = own.replace("r1 = 3.907", "r1 = 0.907");
    let text = refused(&with_explosive(&format!("density = \"931 kg/m3\"\n{weak}")));
    assert!(text.contains("no state of Chapman and Jouguet"), "{text}");
}

#[test]
fn boundaries_find_their_planes() {
    let (setup, _) = solid(&format!(
        r#"{GRID}
[in_situ]
gravity_k0 = {{ k0 = 0.5 }}
[[boundaries]]
on.plane = "x-min"
viscous = {{}}
[[boundaries]]
on.plane = {{ normal = [2, 0, 0], at = ["4 m", "0 m", "0 m"] }}
roller = {{}}
[[boundaries]]
on = {{ block = "rock.1", side = "y-min" }}
in_situ = true
[[boundaries]]
on.plane = "y-max"
held = {{}}
[[boundaries]]
on.plane = "z-min"
held = {{}}
[[boundaries]]
on.plane = "z-max"
pressure = {{ value = "1 kPa" }}
"#
    ));
    let b = &setup.boundaries;
    assert_eq!(b[0].on, FaceSet::Plane { normal: -Vec3::X, offset: 0.0 });
    assert!(matches!(b[0].kind, BoundaryKind::Viscous { half_cell: true }));
    assert_eq!(b[1].on, FaceSet::Plane { normal: Vec3::X, offset: 4.0 });
    assert_eq!(b[2].on, FaceSet::Blocks { blocks: vec![0], normal: Some(-Vec3::Y) });
    let in_situ: Vec<bool> = b.iter().map(|b| b.in_situ).collect();
    assert_eq!(in_situ, [true, true, true, true, true, false]);
    assert!(matches!(b[5].kind, BoundaryKind::Traction { pressure: 1000.0, .. }));
    let stress = setup.in_situ.unwrap();
    // Density times g times depth, half of it sideways; compression is negative.
    assert_eq!(stress.datum, 4.0);
    assert_eq!(stress.stress, [0.0; 6]);
    assert_eq!(stress.gradient, [-1e4, -1e4, -2e4, 0.0, 0.0, 0.0]);
}

#[test]
fn stresses_have_the_sign_of_their_name() {
    let side = |word: &str| format!("[[boundaries]]\non.plane = \"{word}\"\nheld = {{}}\n");
    let sides: String = ["x-min", "x-max", "y-min", "y-max", "z-min", "z-max"].map(side).concat();
    let (setup, model) = solid(&format!(
        "{GRID}{sides}[in_situ.compressive]\nvertical = \"2 MPa\"\nvertical_gradient = \"20 kPa/m\"\n\
         k0 = 0.5\nx = \"3 MPa\"\nsurface = \"4 m\"\n"
    ));
    let stress = setup.in_situ.unwrap();
    assert_eq!(stress.stress, [-3e6, -1e6, -2e6, 0.0, 0.0, 0.0]);
    assert_eq!(stress.gradient, [-1e4, -1e4, -2e4, 0.0, 0.0, 0.0]);
    assert!(model.warnings.is_empty(), "{:?}", model.warnings);
    // The larger one bears east of north by 120 degrees.
    let (setup, _) = solid(&format!(
        "{GRID}{sides}[in_situ.compressive]\nx = \"4 MPa\"\ny = \"2 MPa\"\nazimuth = \"120 deg\"\n"
    ));
    let found = setup.in_situ.unwrap().stress;
    let root = 0.75f64.sqrt() * 1e6;
    let wanted = [-3.5e6, -2.5e6, 0.0, 0.0, 0.0, root];
    for (found, wanted) in found.iter().zip(wanted) {
        assert!((found - wanted).abs() < 1e-6, "{found} {wanted}");
    }
    let tension = format!(
        "{GRID}{sides}[in_situ.tension_positive]\n\
         stress = [\"1 MPa\", \"2 MPa\", \"3 MPa\", \"4 MPa\", \"5 MPa\", \"6 MPa\"]\n"
    );
    let (setup, model) = solid(&tension);
    assert_eq!(setup.in_situ.unwrap().stress[5], 6e6);
    // Gravity is not in it.
    assert_eq!(model.warnings[0].code, "in_situ.weight");
    // What nobody carries is refused, unless a static phase comes first.
    let bare = tension.replace(&sides, "");
    assert!(refused(&bare).contains("is not balanced by any boundary"));
    let text =
        format!("{SPACE}{bare}{TAIL}").replace("name = \"go\"", "name = \"go\"\nkind = \"static\"");
    assert!(try_solid(&text).is_ok());
}

#[test]
fn joints_and_their_changes() {
    let (setup, model) = solid(&format!(
        r#"{GRID}
[interfaces.deformable]
between = ["rock", "soil"]
normal_stiffness = "4 GPa/m"
friction_coefficient = 1.5
residual_friction_angle = "45 deg"
tension = "1 MPa"
cohesion = "2 MPa"
dilation_angle = "45 deg"
dilation_end = "5 mm"
failure = "face"
dashpots = "closed"
[materials.soil]
density = "1800 kg/m3"
young = "1 GPa"
poisson = 0.3
[[phases]]
name = "weak"
until.steps = 1
[phases.interfaces.deformable]
tension = "0 Pa"
[[phases]]
name = "weaker"
until.steps = 1
[phases.interfaces.deformable]
friction_angle = "0 deg"
"#
    ));
    assert_eq!(setup.pair_table, [0, 1, 1, 0]);
    let deformable = setup.interfaces[1].joint;
    assert_eq!(deformable.stiffness, Stiffness::Given { normal: 4e9, shear: 2e9 });
    let dashpots = setup.interfaces.iter().map(|i| i.joint.dashpots);
    assert!(dashpots.eq([Dashpots::Sticking, Dashpots::Closed]));
    let strength = deformable.strength.unwrap();
    assert_eq!(strength.friction, 1.5);
    assert!((strength.residual_friction - 1.0).abs() < 1e-15);
    assert!((strength.dilation - 1.0).abs() < 1e-15 && strength.dilation_end == 5e-3);
    // TAIL is the last phase; changes add up.
    let (row, weak) = model.plan.phases[0].joints[0];
    assert_eq!((row, weak.strength.unwrap().tension), (1, 0.0));
    let (_, weaker) = model.plan.phases[1].joints[0];
    let weaker = weaker.strength.unwrap();
    assert_eq!((weaker.tension, weaker.friction, weaker.cohesion), (0.0, 0.0, 2e6));
    assert!(model.plan.phases[0].contacts.is_empty());
    // Dilation goes no further than friction, and is reported.
    assert_eq!((weaker.dilation > 0.9, weaker.dilating()), (true, 0.0));
    let told = |w: &crate::scenario::Diagnostic| w.message.contains("`weaker` lowers the friction");
    assert_eq!(model.warnings.iter().filter(|w| told(w)).count(), 1);
}

#[test]
fn strengths_of_joints_are_divided_by_the_factor() {
    let text = format!("{SPACE}cohesion = \"3 MPa\"\n{GRID}{TAIL}").replacen(
        "title",
        "strength_factor = 1.5\ntitle",
        1,
    );
    let model = try_solid(&text).unwrap();
    let crate::model::Setup::Spatial(setup) = model.setup else { panic!() };
    let strength = setup.interfaces[0].joint.strength.unwrap();
    assert!((strength.cohesion - 2e6).abs() < 1e-6);
    assert!((strength.friction - 1.0 / 1.5).abs() < 1e-15);
}

/// Bonds of deformable blocks kept their strength.
#[test]
fn strengths_of_bonds_are_divided_by_the_factor() {
    let bond = r#"
[interfaces.default.brittle_bond]
thickness = "1 mm"
tension = "1.5 MPa"
cohesion = "3 MPa"
friction_angle = "45 deg"
cohesive = { mode_1 = "5 kJ/m2", mode_2 = "50 kJ/m2" }
"#;
    let text = format!("{SPACE}{bond}{GRID}mechanics.deformable = {{}}\n{TAIL}");
    let model = try_solid(&text.replacen("title", "strength_factor = 1.5\ntitle", 1)).unwrap();
    let crate::model::Setup::Spatial(setup) = model.setup else { panic!() };
    let law = setup.interfaces[0].bond.unwrap();
    for strength in [law.strength.unwrap(), law.cohesive.unwrap().strength] {
        assert!((strength.tension - 1e6).abs() < 1e-6);
        assert!((strength.cohesion - 2e6).abs() < 1e-6);
        assert!((strength.friction - 1.0 / 1.5).abs() < 1e-15);
        assert!((strength.residual_friction - 1.0 / 1.5).abs() < 1e-15);
    }
}

#[test]
fn refinements_while_running() {
    let (setup, _) = solid(&format!(
        r#"{GRID}
[[refine]]
octree = {{ around.ball = {{ centre = ["2 m", "2 m", "2 m"], radius = "1 m" }}, levels = 2 }}
during = {{ broken = 0.3 }}
[[refine]]
octree = {{ around.all = {{}}, levels = 1 }}
during = {{ stress = "20 MPa", every = "10 steps" }}
"#
    ));
    let during = setup.refinements[0].during.unwrap();
    assert_eq!((during.criterion, during.above, during.every), (Criterion::Broken, 0.3, 50));
    let during = setup.refinements[1].during.unwrap();
    assert_eq!((during.criterion, during.above, during.every), (Criterion::Stress, 2e7, 10));
    assert_eq!(setup.refinements[1].around, Region::All);
}

#[test]
fn outputs_in_space() {
    let coupled = format!("{CHARGE}coupling = {{ scaled = 0.5 }}\n");
    let (_, model) = solid(&format!(
        r#"{GRID}{coupled}
[[refine]]
octree = {{ around = "charge", levels = 2 }}
[[outputs]]
history = {{ name = "v", field = "block.velocity", of = "rock.1", every = "1 us" }}
[[outputs]]
history = {{ name = "up", field = "block.velocity", at_point = ["0.1 m", "0.1 m", "0.1 m"], along = [0, 0, 2], every = "1 us" }}
[[outputs]]
history = {{ name = "p", field = "cavity.pressure", of = "charge", every = "1 us" }}
"#
    ));
    let h = &model.plan.histories;
    let names: Vec<&str> = h.iter().map(|h| h.name.as_str()).collect();
    assert_eq!(names, ["v.x", "v.y", "v.z", "up", "p"]);
    assert_eq!(h[2].gauge.field, "block.velocity.z");
    assert_eq!(h[3].gauge.along, Some([0.0, 0.0, 1.0]));
    assert_eq!(h[3].gauge.at, Some([0.1; 3]));
    assert_eq!(h[4].gauge.of, [0]);
    let check = |rest: &str| {
        refused(&format!(
            "{GRID}{coupled}[[refine]]\noctree = {{ around = \"charge\", levels = 2 }}\n\
             [[checks]]\nname = \"c\"\nrelative = 0.1\n{rest}\n"
        ))
    };
    let text = check("field = \"cavity.pressure\"\nof = \"rock.1\"\nvalue = \"1 Pa\"");
    assert!(text.contains("there is no source `rock.1`"), "{text}");
    let text = check("field = \"cavity.pressure\"\nvalue = \"1 Pa\"");
    assert!(text.contains("needs one source"), "{text}");
    let text = check("field = \"block.velocity\"\nof = \"rock.1\"\nvalue = \"1 m/s\"");
    assert!(text.contains("`.y`, `.z` or `.magnitude`"), "{text}");
    let text = check(
        "field = \"block.velocity.x\"\nat_point = [\"9 m\", \"0 m\", \"0 m\"]\nvalue = \"1 m/s\"",
    );
    assert!(text.contains("no block contains this point"), "{text}");
}

#[test]
fn a_large_grid_is_built_soon() {
    let start = std::time::Instant::now();
    let large = GRID.replace("\"4 m\", \"4 m\", \"4 m\"", "\"100 m\", \"100 m\", \"30 m\"");
    let beside = "[[blocks]]\nname = \"beside\"\nmaterial = \"rock\"\n\
                  grid.box = { size = [\"10 m\", \"100 m\", \"30 m\"], cell = \"1 m\", corner = [\"100 m\", \"0 m\", \"0 m\"] }\n";
    let (setup, _) = solid(&format!("{large}{beside}"));
    assert_eq!(setup.blocks.len(), 330_000);
    assert!(start.elapsed().as_secs_f64() < 20.0, "{:?}", start.elapsed());
    let inside = beside.replace("\"100 m\", \"0 m\", \"0 m\"", "\"99.5 m\", \"0 m\", \"0 m\"");
    let text = refused(&format!("{large}{inside}"));
    assert!(text.contains("overlap by 0.5 m"), "{text}");
}

/// What lies in other blocks across the end of a periodic model, and what is longer than it.
#[test]
fn overlaps_across_a_periodic_boundary_are_refused() {
    let brick = |name: &str, corner: &str, long: &str| {
        format!(
            "[[blocks]]\nname = \"{name}\"\nmaterial = \"rock\"\n\
             brick = {{ size = [\"{long} m\", \"1 m\", \"1 m\"], corner = [\"{corner} m\", \"0 m\", \"0 m\"] }}\n"
        )
    };
    let model = |rest: &str| {
        let periodic =
            "space.spatial.periodic = [\"4 m\", \"none\", \"none\"]\nspace.spatial.gravity";
        try_solid(&format!("{}{rest}{TAIL}", SPACE.replace("space.spatial.gravity", periodic)))
    };
    let refused = |rest: &str| model(rest).expect_err("should be refused").render();
    let two = |corner: &str| format!("{}{}", brick("a", "0", "1"), brick("b", corner, "1"));
    let text = refused(&two("3.25"));
    let wanted = "blocks `a` and `b` overlap by 0.25 m across a periodic boundary";
    assert!(text.contains(wanted), "{text}");
    let text = refused(&two("4.25"));
    assert!(text.contains("overlap by 0.75 m across"), "{text}");
    let text = refused(&brick("floor", "0", "4.5"));
    let wanted = "block `floor` overlaps itself by 0.5 m across a periodic boundary";
    assert!(text.contains(wanted), "{text}");
    assert!(text.contains("make the period longer, or the block shorter"), "{text}");
    // They touch there, or lie more than a period apart.
    for good in [two("3"), two("5.5"), brick("floor", "0", "4")] {
        if let Err(error) = model(&good) {
            panic!("{}", error.render());
        }
    }
}

/// The boxes around such blocks overlap far more often than the blocks do: counting boxes refused them.
#[test]
fn slender_blocks_of_joint_sets_are_no_overlap() {
    let cut = r#"
[[blocks]]
name = "rock"
material = "rock"
brick = { size = ["10 m", "10 m", "10 m"], corner = ["0 m", "0 m", "0 m"] }
cut.joint_sets = [
    { dip = "45 deg", dip_direction = "30 deg", spacing = "0.6 m" },
    { dip = "50 deg", dip_direction = "150 deg", spacing = "0.6 m" },
    { dip = "45 deg", dip_direction = "60 deg", spacing = "8 m" },
]
"#;
    let (setup, model) = solid(cut);
    assert!(setup.blocks.len() > 300, "{}", setup.blocks.len());
    assert!(model.summary.deepest_overlap.is_none());
    let twice = format!("{cut}{}", cut.replace("\"rock\"\nmaterial", "\"again\"\nmaterial"));
    let text = refused(&twice);
    assert!(text.contains("overlap by"), "{text}");
}
