//! Work of single boundaries, supports and loads: they add up to the lines of the ledger, are the same bits for any number of threads
//! and after a restart, and have closed forms.

use riprap::accounts::Account;
use riprap::exec::Exec;
use riprap::ledger::Works;
use riprap::record::checkpoint;
use riprap::run::ask;
use riprap::run::engine::{Reading, View};
use riprap::run::scene::Scene;
use riprap::run::simulation::{Simulation, Snapshot, Stage};
use riprap::scenario::Source;

fn scene(text: &str) -> Scene {
    let source = Source { name: "scene.toml".to_owned(), text: text.to_owned() };
    Scene::parse(source, ".".into(), &[]).unwrap_or_else(|wrong| panic!("{wrong}"))
}

fn simulation(text: &str, threads: usize) -> Simulation {
    let scene = scene(text);
    let job = scene
        .prepare(&scene.case("default").unwrap())
        .unwrap_or_else(|wrong| panic!("{wrong}"))
        .job();
    Simulation::new(job.setup, job.plan, Exec::new(threads).unwrap()).unwrap()
}

/// Steps, past the ends of phases, and finds the forces there.
fn run(simulation: &mut Simulation, steps: u64) {
    let mut done = 0;
    loop {
        match simulation.prepare().unwrap() {
            Stage::Within if done == steps => return,
            Stage::Within => {
                simulation.step();
                done += 1;
            }
            Stage::PhaseEnd => simulation.next_phase(),
            Stage::Done => panic!("the run is over"),
        }
    }
}

fn accounts(simulation: &Simulation) -> (Vec<Account>, Works) {
    match simulation.view() {
        View::Planar(v) => (v.world.accounts.clone(), v.world.works),
        View::Spatial(v) => (v.world.accounts.clone(), v.world.works),
    }
}

/// A bar of joined blocks with ends that are driven apart, one of them turning, with a load of each kind.
const PLANE: &str = r#"
riprap = 1
title = "a bar in the plane"
[space.planar]
gravity = ["0 m/s2", "0 m/s2"]
[materials.rock]
density = "2500 kg/m3"
[interfaces.default]
normal_stiffness = "1 GPa/m"
friction_angle = "30 deg"
[interfaces.default.bond]
normal_stiffness = "10 GPa/m"
tension = "1 GPa"
cohesion = "1 GPa"
[[blocks]]
name = "bar"
material = "rock"
rectangle = { size = ["1 m", "1 m"], corner = ["0 m", "0 m"] }
copies = { count = 6, step = ["1 m", "0 m"] }
[[supports]]
name = "left"
on = { block = "bar.1" }
motion.velocity = { x = { constant = "-1 mm/s" }, y = { formula = "1e-3*sin(300*t)" } }
[[supports]]
on = { block = "bar.6" }
motion.velocity = { x = { constant = "3 mm/s" }, spin = { constant = "0.01 rad/s" } }
[[supports]]
name = "shaken"
on = { block = "bar.2" }
motion.acceleration = { y = { formula = "0.1*sin(200*t)" } }
[[loads]]
name = "push"
on = { block = "bar.3" }
point = { force = ["3 kN/m", "-2 kN/m"], at = ["2.2 m", "0.7 m"], follows = true }
[[loads]]
name = "twist"
on = { block = "bar.4" }
moment = "2 kN"
[[loads]]
name = "roof"
on = { blocks = ["bar.3"] }
edge = { from = ["2 m", "1 m"], to = ["3 m", "1 m"], pressure = ["10 kPa", "20 kPa"] }
time = { ramp = { from = 0, to = 1, end = "10 ms" } }
[[loads]]
name = "wind"
on = { group = "bar" }
body = { acceleration = ["0.3 m/s2", "0.1 m/s2"] }
[[phases]]
name = "pull"
damping = { mass = "10 1/s", local = 0.1 }
until = { time = "1 s" }
"#;

/// Rigid bricks between faces that are moved, loaded and absorb, with dashpots on corners that three of them share.
const RIGID: &str = r#"
riprap = 1
title = "bricks"
[space.spatial]
gravity = "0 m/s2"
[materials.rock]
density = "2500 kg/m3"
young = "30 GPa"
poisson = 0.25
[interfaces.default]
cohesion = "1 GPa"
tension = "1 GPa"
friction_angle = "30 deg"
[[blocks]]
name = "bar"
material = "rock"
grid.box = { size = ["5 m", "2 m", "2 m"], cell = "1 m" }
[[boundaries]]
name = "left"
on.plane = "x-min"
moved.velocity = { x = { constant = "-1 cm/s" } }
[[boundaries]]
name = "right"
on.plane = "x-max"
moved.velocity = { x = { formula = "0.03*(1+y)" }, y = { formula = "0.01*sin(500*t)" } }
[[boundaries]]
name = "quiet"
on.plane = "y-min"
viscous = {}
[[boundaries]]
name = "dashpots"
on.plane = "y-max"
viscous.half_cell = false
[[boundaries]]
name = "floor"
on.plane = "z-min"
viscous.half_cell = false
[[boundaries]]
name = "roof"
on.plane = "z-max"
pressure = { value = "1 MPa", time = { ramp = { from = 0, to = 1, end = "2 ms" } } }
[[supports]]
name = "core"
on = { block = "bar.8" }
motion.velocity = { z = { constant = "1 cm/s" }, spin_x = { constant = "0.02 rad/s" } }
[[loads]]
name = "push"
on = { block = "bar.3" }
point = { force = ["30 kN", "10 kN", "-20 kN"], at = ["2.2 m", "0.3 m", "0.9 m"] }
[[loads]]
name = "twist"
on = { block = "bar.4" }
moment = ["1 kN m", "2 kN m", "-3 kN m"]
[[loads]]
name = "wind"
on = { group = "bar" }
body = { acceleration = ["3 m/s2", "1 m/s2", "0 m/s2"] }
[[phases]]
name = "pull"
damping = { mass = "10 1/s" }
until = { time = "1 s" }
"#;

/// Deformable blocks: nodes that two conditions drive along different axes, driven nodes, viscous faces, tractions, a driven block.
const NODES: &str = r#"
riprap = 1
title = "deformable bricks"
[space.spatial]
gravity = "9.81 m/s2"
[materials.rock]
density = "2500 kg/m3"
young = "30 GPa"
poisson = 0.25
[interfaces.default.brittle_bond]
thickness = "1 mm"
elastic = true
[[blocks]]
name = "bar"
material = "rock"
grid.box = { size = ["5 m", "1 m", "1 m"], cell = "1 m" }
mechanics.deformable = {}
[[boundaries]]
name = "right"
on.plane = "x-max"
moved.velocity = { x = { constant = "2 cm/s" } }
[[boundaries]]
name = "side"
on.plane = "y-min"
moved.velocity = { y = { formula = "0.01*x" } }
[[boundaries]]
name = "roof"
on.plane = "z-max"
pressure = { value = "1 MPa", time = { ramp = { from = 0, to = 1, end = "2 ms" } } }
[[boundaries]]
name = "quiet"
on.plane = "y-max"
viscous = {}
[[boundaries]]
name = "floor"
on.plane = "z-min"
roller = {}
[[supports]]
name = "edge"
on.nodes = { min = ["1.9 m", "0.9 m", "0.9 m"], max = ["2.1 m", "1.1 m", "1.1 m"] }
motion.velocity = { z = { constant = "-1 cm/s" } }
[[supports]]
name = "first"
on = { block = "bar.1" }
motion.velocity = { x = { constant = "-1 cm/s" } }
[[loads]]
name = "push"
on = { block = "bar.4" }
point = { force = ["30 kN", "10 kN", "-20 kN"], at = ["3.2 m", "0.3 m", "0.9 m"] }
[[loads]]
name = "wind"
on = { group = "bar" }
body = { acceleration = ["3 m/s2", "1 m/s2", "0 m/s2"] }
[[phases]]
name = "relax"
kind = "static"
load_steps = 3
until = { time = "1 ms", unbalanced = 1e-2 }
[[phases]]
name = "pull"
damping = { mass = "10 1/s" }
until = { time = "1 s" }
"#;

const ALL: [(&str, &str); 3] = [(PLANE, "planar"), (RIGID, "spatial"), (NODES, "spatial")];

#[test]
fn accounts_add_up_to_the_lines_of_the_ledger() {
    for (text, _) in ALL {
        let mut simulation = simulation(text, 1);
        for leg in 0..5 {
            run(&mut simulation, if text == NODES { 300 } else { 100 });
            let (accounts, works) = accounts(&simulation);
            let view = simulation.view();
            let mut sum = Account::default();
            for (account, condition) in accounts.iter().zip(view.accounts()) {
                let still = ["floor"].contains(&condition.name.as_str()) && text == NODES;
                let nothing = account.work() == 0.0;
                assert!(leg < 4 || nothing == still, "{condition:?} {account:?}");
                sum.add(account);
            }
            for (line, own) in [
                (works.loads, sum.loads),
                (works.supports, sum.supports),
                (works.absorbed, sum.absorbed),
            ] {
                let off = (line - own).abs();
                assert!(off <= 1e-12 * works.peak, "{line} {own} of {}", works.peak);
            }
            assert!(leg < 4 || works.supports.abs() > 1e-3 * works.peak);
        }
    }
}

#[test]
fn accounts_are_the_same_bits_for_any_number_of_threads() {
    for (text, _) in ALL {
        let after = |threads| {
            let mut simulation = simulation(text, threads);
            run(&mut simulation, 200);
            format!("{:?}", accounts(&simulation).0)
        };
        let one = after(1);
        assert_eq!(after(3), one);
    }
}

#[test]
fn accounts_go_on_after_a_restart() {
    for (text, engine) in ALL {
        let mut straight = simulation(text, 1);
        run(&mut straight, 300);
        let folder = tempfile::tempdir().unwrap();
        let mut stopped = simulation(text, 1);
        for leg in 0..6 {
            run(&mut stopped, 50);
            let path = folder.path().join(format!("{leg}.ckpt"));
            checkpoint::write(&path, engine, &stopped.snapshot()).unwrap();
            let snapshot: Snapshot = checkpoint::read(&path, engine).unwrap();
            stopped = Simulation::resume(snapshot, Exec::serial());
        }
        run(&mut stopped, 0);
        let [straight, stopped] = [straight, stopped].map(|s| format!("{:?}", accounts(&s).0));
        assert_eq!(straight, stopped);
    }
}

#[test]
fn the_work_of_each_is_read_by_its_name() {
    let mut simulation = simulation(RIGID, 1);
    run(&mut simulation, 20);
    let view = simulation.view();
    for (field, name, number) in [
        ("boundary.work", "left", 0),
        ("boundary.work", "roof", 5),
        ("support.work", "core", 0),
        ("load.work", "wind", 2),
    ] {
        let gauge = ask::gauge(&view, field, &[name]).unwrap();
        let of_kind = |w: &&riprap::record::manifest::Work| field.starts_with(&w.of);
        let works = view.works();
        let work = works.iter().filter(of_kind).nth(number).unwrap();
        assert_eq!(work.name, name);
        assert_eq!(Reading::new(view.kind(), &gauge).unwrap().value(&view), work.work);
        assert!(work.work != 0.0, "{field} {name}");
    }
    let told = ask::gauge(&view, "support.work", &["cor"]).unwrap_err();
    assert!(told.to_string().contains("\"core\""), "{told}");
}

#[test]
fn two_of_one_name_are_told() {
    let parsed = |text: &str| {
        let source = Source { name: "scene.toml".to_owned(), text: text.to_owned() };
        Scene::parse(source, ".".into(), &[])
    };
    let twice = PLANE.replace("name = \"push\"", "name = \"wind\"");
    let told = parsed(&twice).unwrap_err().to_string();
    assert!(told.contains("there are two loads called `wind`"), "{told}");
    // Two without names on the same block: neither can be told by it.
    let alike = PLANE.replace("name = \"twist\"\n", "").replace("name = \"push\"\n", "")
        + "[[checks]]\nname = \"which\"\nfield = \"load.work\"\nof = \"bar.3\"\nvalue = \"0 J/m\"\nabsolute = \"1 J/m\"\n";
    let alike = alike.replace("on = { block = \"bar.4\" }", "on = { block = \"bar.3\" }");
    let scene = parsed(&alike).unwrap();
    let told = scene.prepare(&scene.case("default").unwrap()).unwrap_err();
    let told = told.to_string();
    assert!(told.contains("load name `bar.3` is ambiguous"), "{told}");
}

#[test]
fn blocks_that_are_divided_keep_the_accounts() {
    let refined = RIGID.replace(
        "[[supports]]",
        "[[refine]]\noctree = { around = [\"2.5 m\", \"0.5 m\", \"0.5 m\"], levels = 1 }\n[[supports]]",
    );
    let mut simulation = simulation(&refined, 1);
    run(&mut simulation, 50);
    let (accounts, works) = accounts(&simulation);
    let mut sum = Account::default();
    accounts.iter().for_each(|account| sum.add(account));
    assert!((sum.loads - works.loads).abs() <= 1e-12 * works.peak);
    assert!((sum.supports - works.supports).abs() <= 1e-12 * works.peak);
    assert!(accounts.iter().all(|a| a.work() != 0.0), "{accounts:?}");
}

/// Blocks that fall onto each other and tumble on, sticking and sliding, hardly damped; the engine and how blocks are given stand in for `ENGINE` and `BLOCKS`.
const TUMBLE: &str = r#"
riprap = 1
title = "blocks that tumble"
ENGINE
[materials.rock]
density = "2600 kg/m3"
young = "1 GPa"
poisson = 0.25
[interfaces.default]
normal_stiffness = "100 MPa/m"
friction_angle = "30 deg"
damping_ratio = 0.02
BLOCKS
[[supports]]
on = { block = "floor" }
fixed = {}
[[phases]]
name = "tumble"
max_residual = 1
until = { time = "10 s" }
"#;

fn tumbling(engine: &str, floor: &str, blocks: &[(&str, &str)]) -> String {
    let block = |(name, shape): &(&str, &str)| {
        format!("[[blocks]]\nname = \"{name}\"\nmaterial = \"rock\"\n{shape}\n")
    };
    let blocks: String = [("floor", floor)].iter().chain(blocks).map(block).collect();
    TUMBLE.replace("ENGINE", engine).replace("BLOCKS", &blocks)
}

#[test]
fn no_line_of_dissipation_ever_falls() {
    let plane = tumbling(
        "[space.planar]\ngravity = [\"0 m/s2\", \"-9.81 m/s2\"]",
        r#"rectangle = { size = ["40 m", "1 m"], corner = ["-20 m", "-1 m"] }"#,
        &[
            (
                "brick",
                "rectangle = { size = [\"1 m\", \"2 m\"], centre = [\"0 m\", \"1.5 m\"] }\nrotate = { angle = \"20 deg\" }\nvelocity = [\"3 m/s\", \"0 m/s\"]",
            ),
            (
                "other",
                "rectangle = { size = [\"1 m\", \"1 m\"], centre = [\"1.6 m\", \"1 m\"] }\nrotate = { angle = \"40 deg\" }",
            ),
        ],
    );
    let bricks = [
        "brick = { size = [\"1 m\", \"2 m\", \"1 m\"], corner = [\"0 m\", \"0 m\", \"0.6 m\"] }\nrotate = { axis = [1, 0.3, 0], angle = \"20 deg\" }\nvelocity = [\"3 m/s\", \"0 m/s\", \"0 m/s\"]",
        "brick = { size = [\"1 m\", \"1 m\", \"1 m\"], corner = [\"2.3 m\", \"0 m\", \"0.4 m\"] }\nrotate = { axis = [0, 1, 1], angle = \"40 deg\" }",
    ];
    let space = "[space.spatial]\ngravity = \"9.81 m/s2\"";
    let floor =
        r#"brick = { size = ["20 m", "20 m", "1 m"], corner = ["-10 m", "-10 m", "-1 m"] }"#;
    let rigid = tumbling(space, floor, &[("brick", bricks[0]), ("other", bricks[1])]);
    let soft = bricks.map(|brick| format!("{brick}\nmechanics.deformable = {{}}"));
    let soft = tumbling(space, floor, &[("brick", &soft[0]), ("other", &soft[1])]);
    let scenes = [(&*plane, 4000), (&*rigid, 4000), (&*soft, 2000)];
    for (text, steps) in scenes.into_iter().chain(ALL.map(|(text, _)| (text, 400))) {
        let mut simulation = simulation(text, 1);
        let mut before = [0.0; 5];
        for step in 0..steps {
            run(&mut simulation, 1);
            let (_, w) = accounts(&simulation);
            let lines = [w.friction, w.damping, w.fracture, w.absorbed, w.bolts];
            let falls = lines.iter().zip(&before).any(|(now, before)| now < before);
            assert!(!falls, "step {step}: {before:?}, {lines:?} in{text}");
            before = lines;
        }
        assert!(ALL.iter().any(|(other, _)| *other == text) || before[0] > 100.0);
    }
}
