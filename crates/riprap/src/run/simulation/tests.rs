use super::{Simulation, Stage};
use crate::exec::Exec;
use crate::run::scene::Scene;
use crate::scenario::Source;

/// An interface that opens and slides.
const ROUGH: &str = "friction_angle = \"30 deg\"";

/// A scene of the plane or of space: a block above a floor that it slides and turns over where it has a `start`, or joined to it; with more tables.
fn scene(space: &str, gap: &str, law: &str, start: bool, phases: &str) -> Simulation {
    let (gravity, moduli, blocks) = match space {
        "planar" => (
            "[\"0 m/s2\", \"0 m/s2\"]",
            "",
            format!(
                "[[blocks]]\nname = \"q\"\nmaterial = \"r\"\npolygon.points = [[\"-4 m\", \"-1 m\"], [\"4 m\", \"-1 m\"], [\"4 m\", \"0 m\"], [\"-4 m\", \"0 m\"]]\n\
                 [[blocks]]\nname = \"b\"\nmaterial = \"r\"\npolygon.points = [[\"0 m\", \"0 m\"], [\"1 m\", \"0 m\"], [\"1 m\", \"1 m\"], [\"0 m\", \"1 m\"]]\n\
                 shift = [\"0 m\", \"{gap}\"]\n{}",
                if start {
                    "velocity = [\"0.1 m/s\", \"0 m/s\"]\nspin = \"0.02 rad/s\"\n"
                } else {
                    ""
                }
            ),
        ),
        _ => (
            "\"0 m/s2\"",
            "young = \"20 GPa\"\npoisson = 0.25\n",
            format!(
                "[[blocks]]\nname = \"q\"\nmaterial = \"r\"\nbrick = {{ corner = [\"-4 m\", \"-4 m\", \"-1 m\"], size = [\"8 m\", \"8 m\", \"1 m\"] }}\n\
                 [[blocks]]\nname = \"b\"\nmaterial = \"r\"\nbrick = {{ corner = [\"0 m\", \"0 m\", \"{gap}\"], size = [\"1 m\", \"1 m\", \"1 m\"] }}\n\
                 {}",
                if start {
                    "velocity = [\"0.1 m/s\", \"0 m/s\", \"0 m/s\"]\nspin = [\"0 rad/s\", \"0.02 rad/s\", \"0 rad/s\"]\n"
                } else {
                    ""
                }
            ),
        ),
    };
    let text = format!(
        "riprap = 1\ntitle = \"t\"\nspace.{space}.gravity = {gravity}\n[materials.r]\ndensity = \"2600 kg/m3\"\n{moduli}\
         [interfaces.default]\n{law}\nnormal_stiffness = \"100 MPa/m\"\ndamping_ratio = 0\n{blocks}\
         [[supports]]\non.block = \"q\"\nfixed = {{}}\n{phases}"
    );
    let scene = Scene::parse(Source::new("t.toml", text), ".".into(), &[]).expect("a scene");
    let job = scene.prepare(&scene.plain()).expect("a model").job();
    Simulation::new(job.setup.clone(), job.plan.clone(), Exec::serial()).expect("a model")
}

/// Two phases between which damping, gravity and laws change.
fn phases(gravity: &str) -> String {
    format!(
        "[[phases]]\nname = \"a\"\nuntil.time = \"20 ms\"\ntime_step = \"1 ms\"\ndamping = {{ mass = \"2 1/s\", local = 0.2 }}\n\
         [[phases]]\nname = \"b\"\nuntil.steps = 40\ngravity = {gravity}\ninterfaces.default.normal_stiffness = \"0.2 GPa/m\"\n"
    )
}

/// The state at the end, taken up anew from a snapshot where `stop` says so, before the forces are found, or after that at the end of a phase.
fn end(mut simulation: Simulation, stop: Option<(u64, bool)>) -> String {
    loop {
        let due = |prepared: bool, s: &Simulation| stop == Some((s.steps(), prepared));
        if due(false, &simulation) {
            simulation = Simulation::resume(simulation.snapshot(), Exec::serial());
        }
        let mut stage = simulation.prepare().expect("a sound run");
        // Within a phase the step that is prepared depends on the contacts of the instant before, which only the next `prepare` replaces.
        if stage != Stage::Within && due(true, &simulation) {
            simulation = Simulation::resume(simulation.snapshot(), Exec::serial());
            stage = simulation.prepare().expect("a sound run");
        }
        match stage {
            Stage::Within => simulation.step(),
            Stage::PhaseEnd => simulation.next_phase(),
            Stage::Done => return simulation.engine().hash(),
        }
    }
}

#[test]
fn a_run_goes_on_with_the_same_bits_from_about_the_end_of_a_phase() {
    for (space, gravity) in [("planar", "[\"0 m/s2\", \"-10 m/s2\"]"), ("spatial", "\"10 m/s2\"")] {
        let new = || scene(space, "3 mm", ROUGH, true, &phases(gravity));
        let whole = end(new(), None);
        for step in 18..23 {
            for prepared in [false, true] {
                let resumed = end(new(), Some((step, prepared)));
                assert_eq!(resumed, whole, "{space}, step {step}, {prepared}");
            }
        }
    }
}

#[test]
fn steps_of_changing_length_keep_the_second_order() {
    // A block that swings on its joint, in phases of steps that are by turns longer and shorter.
    let error = |dt: f64| {
        let mut phases = String::new();
        for k in 0..8 {
            let dt = dt * if k % 2 == 0 { 1.0 } else { 0.4 };
            let of = format!("name = \"p{k}\"\nuntil.time = \"8 ms\"\ntime_step = \"{dt} s\"\n");
            phases += &format!("[[phases]]\n{of}");
        }
        phases += "[[loads]]\non.block = \"b\"\nbody.acceleration = [\"0 m/s2\", \"0 m/s2\", \"-9 m/s2\"]\n";
        let mut simulation = scene("spatial", "0 m", "elastic = true", false, &phases);
        simulation.run().expect("a sound run");
        let field = |name: &str| simulation.field(name, &["b"]).expect("a field");
        let (m, k) = (2600.0, 1e8_f64);
        let w = (k / m).sqrt();
        let wanted = -9.0 * m / k * (1.0 - (w * simulation.time()).cos());
        (field("block.displacement.z") - wanted).abs() / (9.0 * m / k)
    };
    let [coarse, fine] = [error(1e-3), error(5e-4)];
    assert!(coarse < 0.05 && fine < 0.3 * coarse, "{coarse} {fine}");
}

#[test]
fn a_load_that_jumps_within_a_step_moves_a_block_as_far_as_it_should() {
    for (space, way, force) in [
        ("planar", "block.displacement.x", "[\"2600 N/m\", \"0 N/m\"]"),
        ("spatial", "block.displacement.x", "[\"2600 N\", \"0 N\", \"0 N\"]"),
    ] {
        let pulse = "time = { pulse = { value = 1, start = \"33 ms\", end = \"71 ms\" } }";
        let phases = format!(
            "[[phases]]\nname = \"a\"\nuntil.time = \"0.2 s\"\ntime_step = \"10 ms\"\n\
             [[loads]]\non.block = \"b\"\npoint.force = {force}\n{pulse}\n"
        );
        let mut simulation = scene(space, "1 m", ROUGH, true, &phases);
        simulation.run().expect("a sound run");
        let gone = simulation.field(way, &["b"]).expect("a field") - 0.1 * 0.2;
        // 1 m/s2 over 38 ms, then that speed: the way of the pulse is off by the second order of the step.
        let wanted = 0.5 * 0.038_f64.powi(2) + 0.038 * (0.2 - 0.071);
        assert!((gone - wanted).abs() < 0.125 * 0.01_f64.powi(2), "{space}: {gone} {wanted}");
    }
}
