//! Standing water: same bits for any number of threads and after a restart, and what `check` says of wrong words.

use riprap::exec::Exec;
use riprap::ledger::Balance;
use riprap::record::checkpoint;
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

/// What is wrong with a scene, errors and warnings.
fn told(text: &str) -> String {
    let source = Source { name: "scene.toml".to_owned(), text: text.to_owned() };
    let scene = match Scene::parse(source, ".".into(), &[]) {
        Ok(scene) => scene,
        Err(wrong) => return wrong.to_string(),
    };
    match scene.prepare(&scene.case("default").unwrap()) {
        Ok(prepared) => {
            let all = prepared.model.warnings.iter();
            all.map(|w| w.message.clone()).collect::<Vec<_>>().join("\n")
        }
        Err(wrong) => wrong.to_string(),
    }
}

/// Steps, past the ends of phases.
fn run(simulation: &mut Simulation, steps: u64) {
    let mut done = 0;
    while done < steps {
        match simulation.prepare().unwrap() {
            Stage::Within => {
                simulation.step();
                done += 1;
            }
            Stage::PhaseEnd => simulation.next_phase(),
            Stage::Done => panic!("the run is over"),
        }
    }
}

/// A heap of blocks in water that is drawn down in a second phase.
const PLANE: &str = r#"
riprap = 1
title = "blocks in water"
[space.planar]
gravity = ["0 m/s2", "-9.81 m/s2"]
[materials.rock]
density = "2500 kg/m3"
[interfaces.default]
normal_stiffness = "1 GPa/m"
friction_angle = "20 deg"
[[blocks]]
name = "floor"
material = "rock"
rectangle = { size = ["40 m", "1 m"], corner = ["-20 m", "-1 m"] }
[[blocks]]
name = "rock"
material = "rock"
[blocks.cut]
region = [["0 m", "0 m"], ["12 m", "0 m"], ["10 m", "8 m"], ["6 m", "8 m"]]
smallest_edge = "0.05 m"
seed = 5
joint_sets = [
  { dip = "20 deg", spacing = "0.5 m", spacing_scatter = "0.1 m" },
  { dip = "100 deg", spacing = "0.5 m", spacing_scatter = "0.1 m" },
]
[[supports]]
on = { block = "floor" }
fixed = {}
[water.high]
points = [["0 m", "1 m"], ["3.3 m", "5 m"], ["8 m", "6.1 m"], ["15 m", "0 m"]]
[water.low]
level = "1.2 m"
[[phases]]
name = "wet"
until = { steps = 150 }
water = "high"
[[phases]]
name = "drained"
until = { steps = 1000 }
water = "low"
"#;

/// Bricks, a block that floats and deformable ones, the table through all of them.
const SPACE: &str = r#"
riprap = 1
title = "blocks in water"
[space.spatial]
gravity = "9.81 m/s2"
[materials.rock]
density = "2500 kg/m3"
young = "10 GPa"
poisson = 0.2
[materials.wood]
density = "500 kg/m3"
young = "10 GPa"
poisson = 0.2
[interfaces.default]
friction_angle = "20 deg"
[interfaces.default.brittle_bond]
thickness = "10 mm"
elastic = true
[[blocks]]
name = "rock"
material = "rock"
grid.box = { size = ["7 m", "7 m", "7 m"], cell = "1 m" }
[[blocks]]
name = "soft"
material = "rock"
grid.box = { size = ["2 m", "2 m", "4 m"], cell = "2 m", corner = ["10 m", "0 m", "0 m"] }
mechanics.deformable = {}
[[blocks]]
name = "log"
material = "wood"
polyhedron.vertices = [["0 m", "20 m", "5 m"], ["3 m", "20 m", "5 m"], ["0 m", "22 m", "5 m"], ["0 m", "20 m", "7 m"]]
[[boundaries]]
on.plane = "z-min"
held = {}
[water.high]
points = [["-5 m", "2 m"], ["3.3 m", "5 m"], ["8 m", "6.1 m"], ["15 m", "2.2 m"]]
azimuth = "70 deg"
[water.low]
level = "1.2 m"
[[phases]]
name = "wet"
until = { steps = 60 }
water = "high"
[[phases]]
name = "drained"
until = { steps = 1000 }
water = "low"
"#;

/// The heap with water that seeps through its joints while they open.
fn seeping() -> String {
    let rules = "\n[water.high.seepage]\naperture = \"1 mm\"\nevery = 40\ndrains = [{ from = [\"9 m\", \"0.5 m\"], to = [\"9 m\", \"3 m\"] }]\n";
    let table = "[\"15 m\", \"0 m\"]]\n";
    assert!(PLANE.contains(table));
    PLANE.replace(table, &format!("{table}{rules}"))
}

/// Cut blocks and bricks in space that water seeps through, with a row of drains, while joints open and a block is taken out.
const SEEPING_SPACE: &str = r#"
riprap = 1
title = "seepage in space"
[space.spatial]
gravity = "9.81 m/s2"
[materials.rock]
density = "2500 kg/m3"
young = "1 GPa"
poisson = 0.2
[interfaces.default]
friction_angle = "30 deg"
[[blocks]]
name = "floor"
material = "rock"
grid.box = { size = ["12 m", "6 m", "1 m"], cell = "1 m", corner = ["-2 m", "-1 m", "-1 m"] }
[[blocks]]
name = "rock"
material = "rock"
brick = { size = ["8 m", "4 m", "5 m"], corner = ["0 m", "0 m", "0 m"] }
[blocks.cut]
smallest_edge = "0.1 m"
joint_sets = [
  { dip = "15 deg", dip_direction = "80 deg", spacing = "1.2 m" },
  { dip = "80 deg", dip_direction = "270 deg", spacing = "1.5 m" },
  { dip = "85 deg", dip_direction = "10 deg", spacing = "1.5 m" },
]
[[supports]]
on.group = "floor"
fixed = {}
[water.high]
points = [["-2 m", "4.5 m"], ["0 m", "4.5 m"], ["8 m", "1 m"], ["10 m", "1 m"]]
[water.high.seepage]
aperture = "1 mm"
every = 20
closed = ["z-min"]
drains = [{ from = ["6 m", "0.1 m", "3 m"], to = ["6.5 m", "0.1 m", "-0.5 m"], row_end = ["6 m", "3.9 m", "3 m"] }]
[[phases]]
name = "wet"
until = { steps = 100 }
[[phases]]
name = "pit"
remove = ["rock.2"]
until = { steps = 1000 }
"#;

/// Perched water and deep water in turn with both, and a table on a grid from a file in this folder.
fn several(folder: &std::path::Path) -> String {
    let grid = folder.join("heads.csv");
    let heads = "x [m],y [m],z [m]\n-9,-9,5\n4,-9,6\n12,-9,3\n-9,9,4\n4,9,4.5\n12,9,2\n";
    std::fs::write(&grid, heads).unwrap();
    let high = "[water.high]\npoints = [[\"-5 m\", \"2 m\"], [\"3.3 m\", \"5 m\"], [\"8 m\", \"6.1 m\"], [\"15 m\", \"2.2 m\"]]\nazimuth = \"70 deg\"\n";
    assert!(SPACE.contains(high));
    let both = format!(
        "{high}within = {{ min = [\"-9 m\", \"-9 m\", \"3.5 m\"], max = [\"99 m\", \"99 m\", \"9 m\"] }}\n[water.grid]\ncsv = \"{}\"\n\
         within = {{ min = [\"-9 m\", \"-9 m\", \"-1 m\"], max = [\"99 m\", \"99 m\", \"3.4 m\"] }}\n",
        grid.display().to_string().replace('\\', "/")
    );
    SPACE
        .replace(high, &both)
        .replace("water = \"high\"", "water = [\"high\", \"grid\"]")
        .replace("water = \"low\"", "water = \"grid\"")
}

#[test]
fn same_bits_for_any_number_of_threads() {
    let folder = tempfile::tempdir().unwrap();
    let (seeping, several) = (seeping(), several(folder.path()));
    for text in [PLANE, SPACE, SEEPING_SPACE, &seeping, &several] {
        let hash = |threads| {
            let mut simulation = simulation(text, threads);
            run(&mut simulation, 300);
            simulation.engine().hash()
        };
        let one = hash(1);
        for threads in [2, 5] {
            assert_eq!(hash(threads), one, "{threads} threads");
        }
    }
}

#[test]
fn a_checkpoint_changes_nothing() {
    let files = tempfile::tempdir().unwrap();
    let (seeping, several) = (seeping(), several(files.path()));
    for (text, engine) in [
        (PLANE, "planar"),
        (SPACE, "spatial"),
        (&seeping, "planar"),
        (SEEPING_SPACE, "spatial"),
        (&several, "spatial"),
    ] {
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
        assert_eq!(straight.engine().hash(), stopped.engine().hash());
    }
}

/// Bricks in rows, of which nothing but gravity and water is asked, and the same with a load of nothing on each, which are done one by one.
#[test]
fn bricks_in_rows_are_pushed_as_others_are() {
    let lattice = r#"
riprap = 1
title = "wet bricks"
[space.spatial]
gravity = "9.81 m/s2"
[materials.rock]
density = "2500 kg/m3"
young = "1 GPa"
poisson = 0.2
[interfaces.default]
friction_angle = "40 deg"
cohesion = "1 GPa"
tension = "1 GPa"
[[blocks]]
name = "rock"
groups = ["all"]
material = "rock"
grid.box = { size = ["4 m", "4 m", "4 m"], cell = "1 m" }
[[boundaries]]
on.plane = "z-min"
held = {}
[water.high]
points = [["0 m", "1.3 m"], ["2.5 m", "3.1 m"], ["9 m", "3.6 m"]]
[[phases]]
name = "wet"
water = "high"
until = { steps = 100 }
[[phases]]
name = "dry"
water = "none"
until = { steps = 100 }
"#;
    let idle = "[[loads]]\non = { group = \"all\" }\nbody.acceleration = [\"0 m/s2\", \"0 m/s2\", \"0 m/s2\"]\n[water.high]";
    let told = |text: &str| {
        let mut simulation = simulation(text, 1);
        let mut seen = Vec::new();
        for _ in 0..2 {
            run(&mut simulation, 100);
            let riprap::run::engine::View::Spatial(view) = simulation.view() else {
                panic!("a model in space");
            };
            let moved = |b| (view.displacement(b), view.velocity(b));
            let all: Vec<_> = (0..view.world.alive.len()).map(moved).collect();
            seen.push((all, view.balance()));
        }
        seen
    };
    let (rows, single) = (told(lattice), told(&lattice.replace("[water.high]", idle)));
    for ((rows, ledger), (single, other)) in rows.into_iter().zip(single) {
        let size = rows.iter().map(|(u, _)| u.length()).fold(0.0, f64::max);
        let speed = rows.iter().map(|(_, v)| v.length()).fold(0.0, f64::max);
        assert!(size > 1e-5 && speed > 1e-4, "{size} {speed}");
        for ((u, v), (x, w)) in rows.into_iter().zip(single) {
            assert!((u - x).length() < 1e-10 * size, "{u} {x}");
            assert!((v - w).length() < 1e-10 * speed, "{v} {w}");
        }
        let scale = other.works.loads.abs();
        assert!(
            (ledger.works.loads - other.works.loads).abs() < 1e-9 * scale,
            "{ledger:?} {other:?}"
        );
        let [residual, same] = [&ledger, &other].map(Balance::residual);
        assert!((residual - same).abs() < 1e-9 * scale, "{residual} {same}");
    }
}

#[test]
fn seepage_in_space_pushes_both_sides_of_a_joint_alike() {
    let mut simulation = simulation(SEEPING_SPACE, 1);
    run(&mut simulation, 130);
    let riprap::run::engine::View::Spatial(view) = simulation.view() else {
        panic!("a model in space");
    };
    let world = view.world;
    assert!(world.seepage_inflow() > 0.0);
    let found = world.seepage.as_ref().unwrap();
    assert!(found.is_found() && found.joints.len() > 100, "{}", found.left);
    // A closed box of blocks is pushed from outside alone: here by still water under a level table, all of it wet, with Archimedes' force in the end.
    let dry = found.pressures.iter().filter(|p| p[0] <= 0.0).count();
    assert!(dry > 0 && dry < found.joints.len(), "{dry}");
    let level = SEEPING_SPACE.replace(
        "points = [[\"-2 m\", \"4.5 m\"], [\"0 m\", \"4.5 m\"], [\"8 m\", \"1 m\"], [\"10 m\", \"1 m\"]]",
        "level = \"9 m\"",
    );
    let level = level.replace("closed = [\"z-min\"]\ndrains", "closed = []\n#");
    let mut still = self::simulation(&level, 1);
    run(&mut still, 1);
    let riprap::run::engine::View::Spatial(view) = still.view() else {
        panic!("a model in space");
    };
    for b in 0..view.world.alive.len() {
        let wanted = 1000.0 * 9.81 * view.world.solid_of(b).volume;
        let force = view.water_force(b);
        let off = force - riprap::Vec3::new(0.0, 0.0, wanted);
        assert!(off.length() < 1e-6 * wanted, "{b}: {force} {wanted}");
    }
}

#[test]
fn what_is_wrong_with_seepage_in_space_is_told() {
    let with = |from: &str, to: &str| {
        assert!(SEEPING_SPACE.contains(from), "{from}");
        told(&SEEPING_SPACE.replace(from, to))
    };
    let row = ", row_end = [\"6 m\", \"3.9 m\", \"3 m\"]";
    for (told, words) in [
        (with(row, ""), "is a single hole"),
        (with(row, ", row_end = [\"6.5 m\", \"0.1 m\", \"-0.5 m\"]"), "lie on one line"),
        (
            with("to = [\"6.5 m\", \"0.1 m\", \"-0.5 m\"]", "to = [\"6 m\", \"0.1 m\", \"3 m\"]"),
            "has no length",
        ),
        (
            with(
                "grid.box = { size = [\"12 m\", \"6 m\", \"1 m\"]",
                "mechanics.deformable = {}\ngrid.box = { size = [\"12 m\", \"6 m\", \"1 m\"]",
            ),
            "is not possible in models with deformable blocks",
        ),
        (
            with(
                "gravity = \"9.81 m/s2\"\n",
                "gravity = \"9.81 m/s2\"\nperiodic = [\"none\", \"6 m\", \"none\"]\n",
            ),
            "is not possible in periodic models",
        ),
        (with("from = [\"6 m\", \"0.1 m\", \"3 m\"]", "from = [\"6 m\", \"3 m\"]"), "from"),
    ] {
        assert!(told.contains(words), "{words}: {told}");
    }
}

#[test]
fn what_is_wrong_with_water_is_told() {
    let tables = "[water.high]\npoints = [[\"0 m\", \"1 m\"], [\"3.3 m\", \"5 m\"], [\"8 m\", \"6.1 m\"], [\"15 m\", \"0 m\"]]\n[water.low]\nlevel = \"1.2 m\"\n";
    assert!(PLANE.contains(tables));
    let with = |other: &str| told(&PLANE.replace(tables, other));
    let high = "[water.high]\nlevel = \"2 m\"\n";
    let low = "[water.low]\nlevel = \"1 m\"\n";
    let sound = with(&format!("{high}{low}"));
    assert!(!sound.contains("water"), "{sound}");
    for (tables, words) in [
        (format!("{high}[water.low]\n"), "needs one of"),
        (
            format!("{high}points = [[\"0 m\", \"1 m\"], [\"1 m\", \"1 m\"]]\n{low}"),
            "only one is possible",
        ),
        (format!("{low}[water.high]\npoints = [[\"0 m\", \"1 m\"]]\n"), "fewer than two corners"),
        (
            format!("{low}[water.high]\npoints = [[\"2 m\", \"1 m\"], [\"1 m\", \"1 m\"]]\n"),
            "is not less than",
        ),
        (low.to_owned(), "there is no water table `high`"),
        (format!("{high}{low}[water.none]\nlevel = \"1 m\"\n"), "cannot be called `none`"),
        (
            format!("{high}[water.low]\nlevel = \"-2 m\"\n"),
            "water.low has no effect: it lies below all blocks",
        ),
        (
            format!("{high}[water.low]\nlevel = \"-2 m\"\nseepage.aperture = \"1 mm\"\n"),
            "water.low has no effect: it lies below all blocks",
        ),
        (format!("{low}{high}seepage.aperture = \"0 mm\"\n"), "aperture"),
        (
            format!("{low}{high}seepage = {{ aperture = \"1 mm\", aperture_min = \"2 mm\" }}\n"),
            "lies outside of its limits",
        ),
        (
            format!("{low}{high}seepage = {{ aperture = \"1 mm\", closed = [\"z-min\"] }}\n"),
            "names a side of space",
        ),
        (
            format!(
                "{low}{high}seepage = {{ aperture = \"1 mm\", drains = [{{ from = [\"1 m\", \"1 m\"], to = [\"1 m\", \"1 m\"] }}] }}\n"
            ),
            "has no length",
        ),
        (format!("{high}density = \"0 kg/m3\"\n{low}"), "density"),
        (format!("{high}azimuth = \"0 deg\"\n{low}"), "distances run along x"),
    ] {
        let told = with(&tables);
        assert!(told.contains(words), "{words}: {told}");
    }
    let phases =
        |water: &str| told(&PLANE.replace("water = \"high\"", &format!("water = {water}")));
    let boxed = |low: &str, high: &str| {
        let tables = format!(
            "[water.high]\nlevel = \"5 m\"\nwithin = {{ min = [\"-20 m\", \"{high}\"], max = [\"20 m\", \"9 m\"] }}\n\
             [water.low]\nlevel = \"1 m\"\nwithin = {{ min = [\"-20 m\", \"-1 m\"], max = [\"20 m\", \"{low}\"] }}\n"
        );
        let text = PLANE.replace("water = \"high\"", "water = [\"high\", \"low\"]");
        told(&text.replace(
            "[water.high]\npoints = [[\"0 m\", \"1 m\"], [\"3.3 m\", \"5 m\"], [\"8 m\", \"6.1 m\"], [\"15 m\", \"0 m\"]]\n[water.low]\nlevel = \"1.2 m\"\n",
            &tables,
        ))
    };
    assert!(!boxed("1 m", "1.01 m").contains("both act"));
    for (told, words) in [
        (phases("[\"high\", \"low\"]"), "water tables `high` and `low` both act on faces of block"),
        (boxed("1.1 m", "1 m"), "both act on faces of block"),
        // The joint between floor and rocks lies in both boxes.
        (boxed("0 m", "0 m"), "both act on faces of block"),
        (boxed("-2 m", "1 m"), "is empty"),
        (phases("[\"high\", \"high\"]"), "stands twice"),
        (phases("[\"high\", \"none\"]"), "beside other water tables"),
        (phases("[]"), "empty list"),
        (phases("[\"high\", \"middle\"]"), "there is no water table `middle`"),
    ] {
        assert!(told.contains(words), "{words}: {told}");
    }
    let seeps = seeping().replace("water = \"high\"", "water = [\"low\", \"high\"]");
    assert!(told(&seeps).contains("seeps and stands beside others"));
    let seeps = seeping().replace(
        "[water.high.seepage]",
        "within = { min = [\"0 m\", \"0 m\"], max = [\"1 m\", \"1 m\"] }\n[water.high.seepage]",
    );
    assert!(
        told(&seeps).contains("`within` in water.high cannot be used with `seepage`"),
        "{}",
        told(&seeps)
    );
    let folder = tempfile::tempdir().unwrap();
    let several = several(folder.path());
    assert!(told(&several).contains("ends 13.000 m inside the model"), "{}", told(&several));
    for (heads, words) in [
        ("x [m],y [m],z [m]\n0,0,1\n1,0,1\n0,1,1\n", "has no height at (1 m, 1 m)"),
        ("x [m],y [m],z [m]\n0,0,1\n1,0,1\n", "only one grid line"),
        ("x,y,z [kg]\n0,0,1\n1,0,1\n", "kg"),
    ] {
        std::fs::write(folder.path().join("heads.csv"), heads).unwrap();
        assert!(told(&several).contains(words), "{words}: {}", told(&several));
    }
    let silent = PLANE.replace("water = \"high\"\n", "");
    assert!(told(&silent).contains("does not say which water table stands"));
    let spatial = SPACE.replace("azimuth = \"70 deg\"\n", "seepage.aperture = \"1 mm\"\n");
    assert!(told(&spatial).contains("seepage"), "{}", told(&spatial));
    let tilted = PLANE.replace(
        "gravity = [\"0 m/s2\", \"-9.81 m/s2\"]",
        "gravity = [\"0 m/s2\", \"-9.81 m/s2\"]\ntilt = \"5 deg\"",
    );
    assert!(told(&tilted).contains("gravity along -"));
    let later =
        PLANE.replace("water = \"low\"", "water = \"low\"\ngravity = [\"1 m/s2\", \"-9.81 m/s2\"]");
    assert!(told(&later).contains("gravity along -"));
}
