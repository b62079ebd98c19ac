//! Cutting and breaking while waves run: the same bits for any number of threads and over a restart.

use std::path::Path;

use riprap::exec::Exec;
use riprap::record::checkpoint;
use riprap::run::scene::Scene;
use riprap::run::simulation::{Simulation, Snapshot, Stage};

/// The bar that is cut and spalled, up to a little after it has broken.
fn bar() -> (riprap::model::Setup, riprap::plan::Plan) {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenes/fracture");
    let changes = [("phases.0.until.time".to_owned(), "\"745 us\"".to_owned())];
    let path = Path::new(folder).join("spall_cut.toml");
    let scene = Scene::load(&path, &changes).expect("a scene");
    let prepared = scene.prepare(&scene.plain()).expect("a model");
    (prepared.model.setup, prepared.model.plan)
}

/// Runs to the end, through a checkpoint after the `pause`-th step.
fn run(threads: usize, pause: Option<u64>) -> (String, usize, f64) {
    let (setup, plan) = bar();
    let exec = || Exec::new(threads).expect("threads");
    let mut simulation = Simulation::new(setup, plan, exec()).expect("a model");
    loop {
        if simulation.prepare().expect("a sound run") != Stage::Within {
            break;
        }
        simulation.step();
        if pause == Some(simulation.steps()) {
            let dir = tempfile::tempdir().expect("a folder");
            let file = dir.path().join("state.rck");
            checkpoint::write(&file, "test", &simulation.snapshot()).expect("written");
            let snapshot: Snapshot = checkpoint::read(&file, "test").expect("read");
            simulation = Simulation::resume(snapshot, exec());
        }
    }
    let view = simulation.view().spatial().expect("a model in space");
    let broken = view.world.deform.as_ref().map(|d| d.broken_area[0]);
    let blocks = view.world.alive.iter().filter(|a| **a).count();
    (simulation.engine().hash(), blocks, broken.unwrap_or(0.0))
}

#[test]
fn cuts_and_breaks_have_the_same_bits_on_any_threads_and_over_a_restart() {
    let (hash, blocks, broken) = run(1, None);
    assert!(blocks > 50 && broken > 0.0, "{blocks} blocks, {broken} m2");
    let (setup, plan) = bar();
    let mut simulation = Simulation::new(setup, plan, Exec::serial()).expect("a model");
    // The first step after the first cut.
    let cut = loop {
        assert_eq!(simulation.prepare().expect("a sound run"), Stage::Within);
        simulation.step();
        let view = simulation.view().spatial().expect("a model in space");
        if view.world.alive.len() > 50 {
            break simulation.steps();
        }
    };
    assert_eq!(run(2, None).0, hash);
    assert_eq!(run(3, Some(cut + 3)).0, hash);
    assert_eq!(run(1, Some(cut)).0, hash);
}
