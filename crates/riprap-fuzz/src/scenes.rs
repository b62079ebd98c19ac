//! Scenes, from the text to the third step.

use riprap::exec::Exec;
use riprap::run::scene::Scene;
use riprap::scenario::Source;

/// Steps that a scene is advanced by.
const STEPS: u64 = 3;
/// Models with more blocks are built, not run: they are slow for an honest reason.
const MOST: usize = 2000;

pub fn first_steps(bytes: &[u8]) -> bool {
    let Ok(text) = std::str::from_utf8(bytes) else {
        return false;
    };
    let source = Source::new("scene", text);
    let Ok(scene) = Scene::parse(source, ".".into(), &[]) else {
        return false;
    };
    let Ok(prepared) = scene.prepare(&scene.plain()) else {
        return false;
    };
    let Ok(mut simulation) = prepared.simulation(Exec::serial()) else {
        return false;
    };
    if simulation.view().blocks() > MOST {
        return true;
    }
    // A run that stops says why; one that goes on has energies that are numbers.
    if simulation.advance(STEPS).is_ok()
        && let Ok(energy) = simulation.field::<&str>("energy.kinetic", &[])
    {
        assert!(energy.is_finite(), "it goes on with a kinetic energy of {energy}");
    }
    true
}
