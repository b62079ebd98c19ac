//! `rotate` in space: where corners come to lie, bricks that stay bricks, what is refused, and that a lattice turned with its
//! gravity moves as it did.

use super::*;
use crate::exec::Exec;
use crate::run::simulation::Simulation;
use crate::spatial::setup::Solid;
use riprap_geom::polyhedron::Polyhedron;
use riprap_geom::polyhedron::joints::normal_of_dip;

const BRICK: &str = r#"
[[blocks]]
name = "stone"
material = "rock"
brick = { size = ["1 m", "2 m", "3 m"], corner = ["1 m", "0 m", "0 m"] }
"#;

fn polyhedron(solid: &Solid) -> Polyhedron {
    Polyhedron { vertices: solid.vertices.clone(), faces: solid.faces.clone() }
}

fn only_solid(setup: &Setup) -> Polyhedron {
    match &setup.blocks[0].shape {
        Shape::Polyhedron(solid) => polyhedron(solid),
        Shape::Brick { .. } | Shape::Terrain(_) | Shape::Glued(_) => {
            panic!("a polyhedron is expected")
        }
    }
}

#[test]
fn a_brick_leans_in_its_direction_of_dip() {
    let dips = r#"rotate = { angle = "30 deg", dip_direction = "125 deg" }"#;
    let (setup, _) = solid(&format!("{BRICK}{dips}"));
    let stone = only_solid(&setup);
    let radians = f64::to_radians;
    let up = normal_of_dip(radians(30.0), radians(125.0));
    let top = (0..6).any(|face| (stone.plane(face).0 - up).length() < 1e-14);
    assert!(top, "no face dips by 30 deg to 125 deg: {stone:?}");
    let moments = stone.moments();
    assert!((moments.volume - 6.0).abs() < 1e-13);
    let middle = Vec3::new(1.5, 1.0, 1.5);
    assert!((moments.centroid - middle).length() < 1e-14, "about its centroid");
}

#[test]
fn turning_is_about_a_point_and_before_the_shift_and_the_copies() {
    let quarter = r#"
rotate = { angle = "90 deg", axis = [0, 0, 2], about = ["0 m", "0 m", "0 m"] }
shift = ["0 m", "0 m", "10 m"]
copies = { count = 2, step = ["5 m", "0 m", "0 m"] }
"#;
    let (setup, _) = solid(&format!("{BRICK}{quarter}"));
    // A quarter turn keeps a brick one, to the last digit: it can be split.
    let expected = (Vec3::new(-1.0, 1.5, 11.5), Vec3::new(1.0, 0.5, 1.5));
    assert_eq!(brick(&setup.blocks[0].shape), expected);
    assert_eq!(brick(&setup.blocks[1].shape).0, Vec3::new(4.0, 1.5, 11.5));
}

#[test]
fn joints_cut_what_was_turned() {
    let cut = r#"
rotate = { angle = "30 deg", dip_direction = "90 deg" }
cut.joint_sets = [{ dip = "30 deg", dip_direction = "90 deg", spacing = "1 m", origin = ["1.5 m", "1 m", "1.5 m"], offset = "0.5 m" }]
"#;
    let (setup, _) = solid(&format!("{BRICK}{cut}"));
    // Parallel to its bedding: three slabs of 1 x 2 x 1 m.
    assert_eq!(setup.blocks.len(), 3);
    for block in &setup.blocks {
        let Shape::Polyhedron(slab) = &block.shape else {
            panic!("a polyhedron is expected");
        };
        assert!((polyhedron(slab).moments().volume - 2.0).abs() < 1e-12);
    }
}

#[test]
fn what_cannot_be_turned_says_so() {
    for (rotate, words) in [
        (r#"rotate = { angle = "5 deg" }"#, "axis"),
        (
            r#"rotate = { angle = "5 deg", axis = [0, 0, 1], dip_direction = "3 deg" }"#,
            "dip_direction",
        ),
        (r#"rotate = { angle = "5 deg", axis = [0, 0, 0] }"#, "no direction"),
    ] {
        let told = refused(&format!("{BRICK}{rotate}"));
        assert!(told.contains(words), "{told}");
    }
}

#[test]
fn what_is_turned_can_be_split() {
    let split = r#"
rotate = { angle = "5 deg", axis = [0, 0, 1] }
[[refine]]
octree = { around = ["1.5 m", "1 m", "1.5 m"], levels = 1 }
"#;
    let (setup, _) = solid(&format!("{BRICK}{split}"));
    assert_eq!(setup.refinements.len(), 1);
}

const CUT: &str = r#"
[[blocks]]
name = "rock"
material = "rock"
brick = { size = ["6 m", "6 m", "6 m"], corner = ["0 m", "0 m", "0 m"] }
cut.joint_sets = [
    { dip = "20 deg", dip_direction = "40 deg", spacing = "1 m" },
    { dip = "75 deg", dip_direction = "130 deg", spacing = "1.2 m" },
    { dip = "65 deg", dip_direction = "250 deg", spacing = "1.1 m" },
]
"#;

/// What three joint sets cut whole can be split; what the sides cut off cannot: an error before a run, a warning during it.
#[test]
fn blocks_of_three_joint_sets_can_be_split() {
    let refine = |place: &str, during: &str| {
        format!("{CUT}\n[[refine]]\noctree = {{ around = {place}, levels = 1 }}\n{during}\n")
    };
    let middle = r#"["3.1 m", "3.1 m", "3.1 m"]"#;
    let (setup, model) = solid(&refine(middle, ""));
    assert_eq!(setup.refinements.len(), 1);
    assert!(model.warnings.is_empty(), "{:?}", model.warnings);
    let told = refused(&refine("{ all = {} }", ""));
    assert!(told.contains("cannot be split into eight"), "{told}");
    let (setup, model) = solid(&refine("{ all = {} }", r#"during = { broken = 0.5 }"#));
    assert_eq!(setup.refinements.len(), 1);
    let told = format!("{:?}", model.warnings);
    assert!(told.contains("in this region stay whole"), "{told}");
}

#[test]
fn deformable_blocks_are_not_split() {
    let refine = "[[refine]]\noctree = { around = { all = {} }, levels = 1 }\n";
    let told = refused(&format!("{BRICK}mechanics.deformable = {{}}\n{refine}"));
    assert!(told.contains("is deformable"), "{told}");
}

/// The cells of a turned grid fit a charge as those of a straight one, whatever it is turned about.
#[test]
fn a_turned_grid_fits_a_charge() {
    let straight = "centre = [\"2 m\", \"2 m\", \"2 m\"]";
    let (angle, at, axis) = (0.6_f64, Vec3::new(1.1, 2.3, 1.9), Vec3::new(0.6, 0.0, 0.8));
    let turn = riprap_geom::Mat3::from_axis_angle(axis, angle);
    for (about, centre) in [
        (r#", about = ["1 m", "0 m", "0 m"]"#, Vec3::X + turn * (at - Vec3::X)),
        ("", Vec3::splat(2.0) + turn * (at - Vec3::splat(2.0))),
    ] {
        let charge = CHARGE.replace(
            straight,
            &format!("centre = [\"{:?} m\", \"{:?} m\", \"{:?} m\"]", centre.x, centre.y, centre.z),
        );
        let rotate =
            format!(r#"rotate = {{ angle = "{angle:?} rad", axis = [0.6, 0, 0.8]{about} }}"#);
        let refine = "[[refine]]\noctree = { around = \"charge\" }\n";
        let (setup, model) = solid(&format!("{GRID}{rotate}\n{charge}\n{refine}"));
        let fitted = &model.summary.charges[0];
        assert_eq!(fitted.blocks, 8, "{about}");
        assert!((fitted.ratio.unwrap() - 1.0).abs() < 1e-12, "{fitted:?}");
        let (world, _) = crate::spatial::world::World::new(setup, Exec::new(1).unwrap()).unwrap();
        let cavity = &world.cavities[0];
        assert_eq!((cavity.blocks.len(), cavity.walls.len()), (8, 24), "{about}");
        assert!((cavity.volume_ratio() - 1.0).abs() < 1e-9);
    }
}

/// Displacement of every block of a lattice that is held at one corner, under gravity along a direction, m.
fn swung(rotate: &str, gravity: Vec3) -> Vec<Vec3> {
    let text = format!(
        r#"
riprap = 1
title = "a lattice"
space.spatial.gravity = ["{} m/s2", "{} m/s2", "{} m/s2"]
[materials.rock]
density = "2500 kg/m3"
young = "1 GPa"
poisson = 0.25
[interfaces.default]
friction_angle = "30 deg"
cohesion = "10 MPa"
tension = "10 MPa"
[[blocks]]
name = "rock"
material = "rock"
grid.box = {{ size = ["3 m", "2 m", "2 m"], cell = "1 m" }}
{rotate}
[[supports]]
on.block = "rock.1"
fixed = {{}}
[[phases]]
name = "swing"
until = {{ steps = 400 }}
time_step = "50 us"
"#,
        gravity.x, gravity.y, gravity.z
    );
    let model = try_solid(&text).unwrap_or_else(|error| panic!("{error}"));
    let exec = Exec::new(1).unwrap();
    let mut simulation = Simulation::new(model.setup.clone(), model.plan, exec).unwrap();
    simulation.run().unwrap();
    let along = |axis: char, block: usize| {
        let field = format!("block.displacement.{axis}");
        simulation.field(&field, &[format!("rock.{block}")]).unwrap()
    };
    let of = |block| Vec3::new(along('x', block), along('y', block), along('z', block));
    (1..=12).map(of).collect()
}

#[test]
fn a_lattice_turned_with_its_gravity_moves_as_it_did() {
    let gravity = Vec3::new(1.0, -2.0, -9.0);
    let still = swung("", gravity);
    let most = still.iter().map(|d| d.length()).fold(0.0, f64::max);
    assert!(most > 1e-5, "it moves: {most} m");
    // About [1, 2, 2] by 40 deg, the formula of Rodrigues once more.
    let axis = Vec3::new(1.0, 2.0, 2.0) / 3.0;
    let (sin, cos) = 40.0_f64.to_radians().sin_cos();
    let turned = |v: Vec3| cos * v + sin * axis.cross(v) + (1.0 - cos) * axis.dot(v) * axis;
    let rotate = r#"rotate = { angle = "40 deg", axis = [1, 2, 2] }"#;
    let moved = swung(rotate, turned(gravity));
    for (block, (a, b)) in still.iter().zip(&moved).enumerate() {
        let off = (turned(*a) - *b).length();
        assert!(off < 1e-9 * most, "block {block}: {off} of {most} m");
    }
}

/// Joints that have given way are not there when the stable step is searched for again: a run that went on from a checkpoint took another
/// step than the one that had not been stopped.
#[test]
fn the_time_step_goes_on_after_joints_have_given_way() {
    let charge = CHARGE
        .replace("16 kg", "6 kg")
        .replace("\"2 m\", \"2 m\", \"2 m\"", "\"3.1 m\", \"3.1 m\", \"3.1 m\"");
    let text = format!(
        r#"
riprap = 1
title = "a charge in jointed rock"
space.spatial.gravity = "0 m/s2"
[materials.rock]
density = "2400 kg/m3"
young = "18 GPa"
poisson = 0.25
[interfaces.default]
friction_angle = "35 deg"
cohesion = "2 MPa"
tension = "1 MPa"
{CUT}
{charge}
coupling = {{ scaled = 0.667 }}
[[phases]]
name = "blast"
until = {{ steps = 2000 }}
"#
    );
    let model = try_solid(&text).unwrap_or_else(|error| panic!("{error}"));
    let exec = || Exec::new(1).unwrap();
    let mut whole = Simulation::new(model.setup, model.plan, exec()).unwrap();
    let joints = |run: &Simulation| match run.engine().state() {
        crate::run::engine::State::Spatial(world) => world.patches.len(),
        crate::run::engine::State::Planar(_) => 0,
    };
    let advance = |run: &mut Simulation, steps: u32| {
        for _ in 0..steps {
            run.prepare().unwrap();
            run.step();
        }
    };
    let before = joints(&whole);
    while joints(&whole) == before {
        assert!(whole.steps() < 1000, "no joint has given way");
        advance(&mut whole, 10);
    }
    let bytes = postcard::to_allocvec(&whole.snapshot()).unwrap();
    let mut second = Simulation::resume(postcard::from_bytes(&bytes).unwrap(), exec());
    advance(&mut whole, 20);
    advance(&mut second, 20);
    assert_eq!(whole.dt(), second.dt());
    let [one, two] = [&whole, &second].map(|run| postcard::to_allocvec(&run.snapshot()).unwrap());
    assert!(one == two, "the states differ");
}
