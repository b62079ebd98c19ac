//! Blocks that a script adds.

use super::{live, on};
use crate::exec::Exec;
use crate::run::drive::{Control, DriveError, Ending, Pause};
use crate::run::engine::NewBlock;
use crate::run::job::{self, JobError, Live};
use crate::run::scene::Scene;
use crate::run::simulation::Simulation;
use crate::scenario::Source;

/// A floor, and a pebble far to the side, the one member of its group, whose mass a history follows.
fn text(space: &str) -> String {
    let lengths = |v: &[f64]| {
        let all: Vec<String> = v.iter().map(|x| format!("\"{x} m\"")).collect();
        format!("[{}]", all.join(", "))
    };
    let shape = |size: [f64; 3], corner: [f64; 3]| match space {
        "planar" => {
            let [size, corner] = [size, corner].map(|[x, _, z]| lengths(&[x, z]));
            format!("rectangle = {{ size = {size}, corner = {corner} }}")
        }
        _ => format!("brick = {{ size = {}, corner = {} }}", lengths(&size), lengths(&corner)),
    };
    let gravity = match space {
        "planar" => "[\"0 m/s2\", \"-10 m/s2\"]",
        _ => "[\"0 m/s2\", \"0 m/s2\", \"-10 m/s2\"]",
    };
    let moduli = if space == "planar" { "" } else { "young = \"10 GPa\"\npoisson = 0.25" };
    let shear = if space == "planar" { "" } else { "shear_stiffness = \"0.1 GPa/m\"" };
    format!(
        r#"
riprap = 1
title = "a floor"
[space.{space}]
gravity = {gravity}
[materials.rock]
density = "2500 kg/m3"
{moduli}
[interfaces.default]
normal_stiffness = "0.2 GPa/m"
{shear}
friction_angle = "35 deg"
damping_ratio = 0.5
[[blocks]]
name = "floor"
material = "rock"
{}
[[blocks]]
name = "pebble"
material = "rock"
groups = ["loose"]
{}
[[supports]]
on.block = "floor"
fixed = {{}}
[[phases]]
name = "first"
until = {{ time = "0.2 s" }}
time_step = "0.1 ms"
[[phases]]
name = "second"
until = {{ time = "1 s" }}
time_step = "0.1 ms"
[[outputs]]
history = {{ name = "mass", field = "group.mass", of = "loose", every = "20 ms" }}
"#,
        shape([12.0, 8.0, 1.0], [-6.0, -4.0, -1.0]),
        shape([0.2, 0.2, 0.2], [5.0, 0.0, 0.0]),
    )
}

/// A cube, in the plane a square, with the lowest corner at x, y, z.
fn cube(space: &str, name: &str, size: f64, [x, y, z]: [f64; 3]) -> NewBlock {
    let low = [x, y, z];
    let vertices = match space {
        "planar" => [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]
            .map(|[a, b]| [x + size * a, z + size * b, 0.0])
            .to_vec(),
        _ => {
            let far = |k: u32, axis: usize| f64::from(k >> axis & 1);
            let corner = |k| std::array::from_fn(|axis| low[axis] + size * far(k, axis));
            (0..8).map(corner).collect()
        }
    };
    NewBlock {
        name: name.to_owned(),
        material: "rock".to_owned(),
        groups: vec!["loose".to_owned()],
        vertices,
        ..NewBlock::default()
    }
}

fn told(result: Result<f64, JobError>) -> String {
    match result.unwrap_err() {
        JobError::Drive(DriveError::Change(wrong)) => wrong.to_string(),
        other => panic!("{other}"),
    }
}

fn up(space: &str) -> &'static str {
    if space == "planar" { "y" } else { "z" }
}

fn field(live: &Live, name: &str, of: &[&str]) -> f64 {
    live.simulation().field(name, of).unwrap()
}

/// Falls from a height of 0.45 m at 10 m/s2: it lands after 0.3 s with 3 m/s, and its weight is on the floor then.
#[test]
fn an_added_block_falls_lands_and_rests() {
    for space in ["planar", "spatial"] {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join(space);
        let mut run = live(&text(space), Some(&path));
        on(&mut run, 0.1);
        let before = field(&run, "group.mass", &["loose"]);
        let stone = cube(space, "stone", 1.0, [0.0, 0.0, 0.45]);
        assert!((run.add_block(&stone).unwrap() - 2500.0).abs() < 1e-9);
        assert_eq!(field(&run, "energy.edit_defect", &[]), 0.0, "{space}: it is at rest");
        let mass = field(&run, "group.mass", &["loose"]) - before;
        assert!((mass - 2500.0).abs() < 1e-9, "{space}: {mass}");
        on(&mut run, 0.4);
        let speed = field(&run, &format!("block.velocity.{}", up(space)), &["stone"]);
        assert!((speed + 3.0).abs() < 2e-3, "{space}: lands with {speed} m/s");
        assert!(field(&run, "energy.residual_relative", &[]).abs() < 1e-6, "{space}");
        on(&mut run, 1.19);
        let weight = format!("pair.force.{}", up(space));
        let weight = field(&run, &weight, &["stone", "floor"]);
        assert!((weight - 25e3).abs() < 1.0, "{space}: {weight} N on the floor");
        assert!(field(&run, "block.speed", &["stone"]) < 1e-6, "{space}");
        let residual = field(&run, "energy.residual_relative", &[]);
        // In the plane an impact in steps of 0.1 ms makes 7e-6 of its energy.
        let most = if space == "planar" { 1e-5 } else { 1e-6 };
        assert!(residual.abs() < most, "{space}: {residual}");
        run.advance(Pause::NEVER, &mut |_| Control::Continue).unwrap();
        assert_eq!(run.ending(), Some(&Ending::Finished), "{space}");
        run.close().unwrap();
        let read = |file: &str| std::fs::read_to_string(path.join(file)).unwrap();
        let events = read("events.jsonl");
        assert_eq!(events.matches("\"block_added\"").count(), 1, "{space}: {events}");
        assert!(events.contains("\"mass\":2500.0"), "{space}: {events}");
        let histories = read("histories.csv");
        let masses: Vec<f64> =
            histories.lines().filter_map(|line| line.rsplit(',').next()?.parse().ok()).collect();
        let [first, last] = [masses[0], masses[masses.len() - 1]];
        assert!((last - first - 2500.0).abs() < 1e-9, "{space}: {histories}");
    }
}

/// Blocks with velocities and spins, one after the other, one of them taken out again, one fixed.
fn script(run: &mut Live, space: &str) {
    on(run, 0.05);
    let mut stone = cube(space, "stone.1", 0.5, [-2.0, 0.3, 0.2]);
    stone.velocity = if space == "planar" { [1.0, -0.5, 0.0] } else { [1.0, 0.2, -0.5] };
    stone.spin = [0.0, 0.0, 0.7];
    run.add_block(&stone).unwrap();
    on(run, 0.1);
    run.add_block(&cube(space, "stone.2", 0.25, [-1.5, 0.1, 1.1])).unwrap();
    run.add_block(&cube(space, "peg", 0.25, [1.0, 0.1, 0.5])).unwrap();
    run.change("fix = [\"peg\"]").unwrap();
    on(run, 0.15);
    run.add_block(&cube(space, "crumb", 0.1, [-3.0, 0.0, 0.0])).unwrap();
    run.change("remove = [\"crumb\"]").unwrap();
    on(run, 0.3);
}

#[test]
fn the_same_blocks_give_the_same_bits_on_any_threads_and_after_a_restart() {
    for space in ["planar", "spatial"] {
        let folder = tempfile::tempdir().unwrap();
        let text = text(space).replace("time_step = \"0.1 ms\"\n", "");
        let on_threads = |threads: usize| {
            let scene = Scene::parse(Source::new("floor.toml", &text[..]), ".".into(), &[]);
            let scene = scene.map_err(|wrong| wrong.render()).unwrap();
            let job = scene.prepare(&scene.plain()).map_err(|wrong| wrong.render()).unwrap().job();
            let mut run = Live::unrecorded(job, threads).unwrap();
            script(&mut run, space);
            run.advance(Pause::NEVER, &mut |_| Control::Continue).unwrap();
            assert_eq!(run.ending(), Some(&Ending::Finished), "{space}");
            let residual = field(&run, "energy.residual_relative", &[]);
            assert!(residual.abs() < 1e-3, "{space}: {residual}");
            assert_eq!(field(&run, "block.displacement.x", &["peg"]), 0.0);
            run.simulation().engine().hash()
        };
        let whole = on_threads(1);
        assert!((2..=3).all(|threads| on_threads(threads) == whole), "{space}");
        let path = folder.path().join(space);
        let mut second = live(&text, Some(&path));
        script(&mut second, space);
        second.close().unwrap();
        let again = job::resume(&path, 2, &mut |_| Control::Continue).unwrap();
        assert_eq!(again.manifest.state_hash, whole, "{space}");
        // From the very instant at which a block was added, too.
        let mut third = live(&text, None);
        on(&mut third, 0.1);
        third.add_block(&cube(space, "stone", 0.5, [-2.0, 0.3, 0.2])).unwrap();
        let kept = third.simulation().snapshot();
        let end = |mut simulation: Simulation| {
            simulation.run().unwrap();
            simulation.engine().hash()
        };
        let on_from = |snapshot| end(Simulation::resume(snapshot, Exec::new(1).unwrap()));
        let through = on_from(kept.clone());
        assert_eq!(through, on_from(kept), "{space}");
    }
}

#[test]
fn the_energy_of_motion_of_an_added_block_is_an_edit() {
    for space in ["planar", "spatial"] {
        let mut run = live(&text(space), None);
        on(&mut run, 0.1);
        let mut stone = cube(space, "stone", 1.0, [-2.0, 0.3, 0.5]);
        (stone.velocity, stone.spin) = ([2.0, 0.0, 0.0], [0.0, 0.0, 3.0]);
        run.add_block(&stone).unwrap();
        let kinetic = 0.5 * 2500.0 * (2.0 * 2.0 + 3.0 * 3.0 / 6.0);
        let booked = field(&run, "energy.edit_defect", &[]);
        assert!((booked - kinetic).abs() < 1e-9 * kinetic, "{space}: {booked} {kinetic}");
        assert!((field(&run, "block.speed", &["stone"]) - 2.0).abs() < 1e-12, "{space}");
        assert!(field(&run, "energy.residual_relative", &[]).abs() < 1e-9, "{space}");
    }
}

#[test]
fn what_is_wrong_with_a_block_is_said_and_changes_nothing() {
    for space in ["planar", "spatial"] {
        let mut run = live(&text(space), None);
        on(&mut run, 0.1);
        let before = run.simulation().engine().hash();
        let good = || cube(space, "stone", 1.0, [0.0, 0.0, 0.5]);
        let mut wrong = |expected: &str, change: &dyn Fn(&mut NewBlock)| {
            let mut block = good();
            change(&mut block);
            let told = told(run.add_block(&block));
            assert!(told.starts_with("the block \""), "{told}");
            assert!(told.contains(expected), "{space}: {told}");
        };
        wrong("inside block \"floor\"", &|b| *b = cube(space, "stone", 1.0, [0.0, 0.0, -0.1]));
        wrong("1.000e-1 m inside block \"pebble\"; move it away by as much", &|b| {
            *b = cube(space, "stone", 1.0, [4.1, 0.0, 0.0]);
        });
        wrong("there is no material \"rok\"; did you mean \"rock\"?", &|b| {
            b.material = "rok".to_owned();
        });
        wrong("there is no group \"lose\"; did you mean \"loose\"?", &|b| {
            b.groups = vec!["lose".to_owned()];
        });
        wrong("a block or group has this name", &|b| b.name = "floor".to_owned());
        wrong("a block or group has this name", &|b| b.name = "loose".to_owned());
        wrong("its name is empty", &|b| b.name = " ".to_owned());
        wrong("reads as a part of a block or as a condition", &|b| b.name = "a and b".to_owned());
        wrong("vertex 2 has non-finite coordinates", &|b| b.vertices[2][0] = f64::NAN);
        wrong("its velocity is not finite", &|b| b.velocity[1] = f64::INFINITY);
        wrong(if space == "planar" { "at least 3" } else { "at least 4" }, &|b| {
            b.vertices.truncate(2);
        });
        if space == "planar" {
            wrong("third component", &|b| b.vertices[1][2] = 1.0);
            wrong("`faces`", &|b| b.faces = vec![vec![0, 1, 2]]);
            wrong("edge", &|b| b.vertices.swap(1, 2));
        } else {
            let sides = [[0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1]];
            let sides: Vec<Vec<u32>> = sides.iter().map(|side| side.to_vec()).collect();
            wrong("the surface is open", &|b| b.faces = sides.clone());
            let closed = |last: [u32; 4]| {
                let mut all = sides.clone();
                all.push(last.to_vec());
                all
            };
            wrong("wrong orientation", &|b| b.faces = closed([6, 7, 5, 4]));
            wrong("not flat", &|b| {
                b.faces = closed([4, 5, 7, 6]);
                b.vertices[7][2] -= 0.3;
            });
            // All corners in one plane.
            wrong("", &|b| b.vertices.iter_mut().for_each(|v| v[2] = 0.5));
        }
        assert_eq!(run.simulation().engine().hash(), before, "{space}");
        // A face that lies on another one is no overlap.
        run.add_block(&cube(space, "stone", 1.0, [0.0, 0.0, 0.0])).unwrap();
        run.add_block(&cube(space, "on top", 1.0, [0.0, 0.0, 1.0])).unwrap();
        run.advance(Pause::NEVER, &mut |_| Control::Continue).unwrap();
        assert!(told(run.add_block(&good())).contains("the run has ended"), "{space}");
    }
}

/// Bricks in joints that never fail are one body, and no candidates for contact before.
#[test]
fn an_added_block_lies_on_bricks_in_joints_and_goes_with_its_group() {
    let rock = text("spatial")
        .replace(
            "brick = { size = [\"12 m\", \"8 m\", \"1 m\"], corner",
            "grid.box = { cell = \"2 m\", size = [\"12 m\", \"8 m\", \"2 m\"], corner",
        )
        .replace(
            "[interfaces.default]\n",
            "[interfaces.default]\ncohesion = \"5 MPa\"\ntension = \"5 MPa\"\n",
        )
        .replace("\"-1 m\"]", "\"-2 m\"]")
        .replace(
            "[[supports]]\non.block = \"floor\"\nfixed = {}",
            "[[boundaries]]\non.plane = \"z-min\"\nheld = {}",
        )
        .replace("time_step = \"0.1 ms\"\n", "");
    let mut run = live(&rock, None);
    on(&mut run, 0.1);
    // With that of the pebble, which lies on them at the start.
    assert_eq!(field(&run, "model.patches", &[]), 39.0);
    run.add_block(&cube("spatial", "stone", 1.0, [0.3, 0.2, 0.05])).unwrap();
    on(&mut run, 1.0);
    let weight = field(&run, "block.contact_force.z", &["stone"]);
    // Joints that never fail let the bricks ring.
    assert!((weight - 25e3).abs() < 1e3, "{weight}");
    assert_eq!(field(&run, "group.blocks", &["loose"]), 2.0);
    assert_eq!(field(&run, "model.patches", &[]), 39.0, "it has no joint");
    run.change("remove = [\"loose and rock\"]").unwrap();
    assert_eq!(field(&run, "group.blocks", &["loose"]), 0.0);
    run.advance(Pause::NEVER, &mut |_| Control::Continue).unwrap();
    let residual = field(&run, "energy.residual_relative", &[]);
    assert!(residual.abs() < 1e-3, "{residual}");
}

#[test]
fn an_implicit_phase_takes_an_added_block() {
    let implicit =
        text("spatial").replace("time_step = \"0.1 ms\"\n", "integration = \"implicit\"\n");
    let end = |mut run: Live| {
        run.advance(Pause::NEVER, &mut |_| Control::Continue).unwrap();
        assert_eq!(run.ending(), Some(&Ending::Finished));
        let weight = field(&run, "block.contact_force.z", &["stone"]);
        assert!((weight - 25e3).abs() < 25.0, "{weight}");
        let residual = field(&run, "energy.residual_relative", &[]);
        assert!(residual.abs() < 1e-2, "{residual}");
        run.simulation().engine().hash()
    };
    let begun = |path: Option<&std::path::Path>| {
        let mut run = live(&implicit, path);
        on(&mut run, 0.1);
        run.add_block(&cube("spatial", "stone", 1.0, [0.3, 0.2, 0.05])).unwrap();
        on(&mut run, 0.15);
        run
    };
    let whole = end(begun(None));
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("implicit");
    begun(Some(&path)).close().unwrap();
    let again = job::resume(&path, 1, &mut |_| Control::Continue).unwrap();
    assert_eq!(again.manifest.state_hash, whole);
}

#[test]
fn without_contact_no_block_is_added() {
    let off = text("spatial").replace("[space.spatial]", "[space.spatial]\nfound_contacts = false");
    let mut run = live(&off, None);
    on(&mut run, 0.1);
    let told = told(run.add_block(&cube("spatial", "stone", 1.0, [0.0, 0.0, 0.5])));
    assert!(told.contains("contact detection is switched off"), "{told}");
}

/// Blocks of all kinds are in the way of an added one, and carry it.
#[test]
fn an_added_block_meets_terrain_glued_parts_and_what_deforms() {
    let folder = tempfile::tempdir().unwrap();
    let mut points = "x_m,y_m,z_m\n".to_owned();
    for (x, y) in [-9, 0, 9].into_iter().flat_map(|x| [-9, 0, 9].map(|y| (x, y))) {
        points.push_str(&format!("{x},{y},0\n"));
    }
    std::fs::write(folder.path().join("ground.csv"), points).unwrap();
    let brick = |x: i32| {
        format!(
            "brick = {{ size = [\"3 m\", \"6 m\", \"1 m\"], corner = [\"{x} m\", \"-3 m\", \"-1 m\"] }}"
        )
    };
    let held = "[[supports]]\non.block = \"under\"\nfixed = {}\n";
    let kinds = [
        ("terrain.csv = \"ground.csv\"".to_owned(), ""),
        (format!("parts = [{{ {} }}, {{ {} }}]", brick(-3), brick(0)), held),
        (
            format!("{}\nmechanics.deformable = {{}}", brick(-1)),
            "[[boundaries]]\non.plane = \"z-min\"\nheld = {}\n",
        ),
    ];
    for (shape, rest) in kinds {
        let text = format!(
            r#"
riprap = 1
title = "in the way"
[space.spatial]
gravity = ["0 m/s2", "0 m/s2", "-10 m/s2"]
[materials.rock]
density = "2500 kg/m3"
young = "1 GPa"
poisson = 0.25
[interfaces.default]
normal_stiffness = "0.2 GPa/m"
shear_stiffness = "0.1 GPa/m"
friction_angle = "35 deg"
damping_ratio = 0.5
[interfaces.default.brittle_bond]
thickness = "10 mm"
tension = "0 MPa"
cohesion = "0 MPa"
friction_angle = "30 deg"
[[blocks]]
name = "under"
material = "rock"
{shape}
{rest}
[[phases]]
name = "go"
until = {{ time = "0.4 s" }}
"#
        );
        let text = if shape.contains("deformable") {
            text
        } else {
            let from = text.find("[interfaces.default.brittle_bond]").unwrap();
            let to = text.find("[[blocks]]").unwrap();
            format!("{}{}", &text[..from], &text[to..])
        };
        let scene = Scene::parse(Source::new("way.toml", &text[..]), folder.path().into(), &[]);
        let scene = scene.map_err(|wrong| wrong.render()).unwrap();
        let job = scene.prepare(&scene.plain()).map_err(|wrong| wrong.render()).unwrap().job();
        let mut run = Live::unrecorded(job, 1).unwrap();
        on(&mut run, 0.02);
        let stone = |z: f64| NewBlock {
            groups: Vec::new(),
            ..cube("spatial", "stone", 1.0, [0.2, 0.3, z])
        };
        let told = told(run.add_block(&stone(-0.1)));
        assert!(told.contains("inside block \"under\""), "{told}");
        run.add_block(&stone(0.02)).unwrap();
        run.advance(Pause::NEVER, &mut |_| Control::Continue).unwrap();
        assert_eq!(run.ending(), Some(&Ending::Finished), "{shape}");
        let fallen = field(&run, "block.displacement.z", &["stone"]);
        assert!((fallen + 0.02).abs() < 2e-3, "{shape}: {fallen}");
        let residual = field(&run, "energy.residual_relative", &[]);
        assert!(residual.abs() < 1e-2, "{shape}: {residual}");
    }
}
