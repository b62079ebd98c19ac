//! Same bits for any thread count, across a checkpoint, and no allocation in a steady step.

use crate::common::{DISTANCE, block, comb, hold, l_shape, law, moved, rectangle, setup};
use riprap::Vec2;
use riprap::exec::Exec;
use riprap::plan::{Damping, Integration, Phase, PhaseKind, Plan, TimeStep, Until};
use riprap::planar::bond::Bond;
use riprap::planar::setup::{BondLaw, Setup, Strength};
use riprap::record::checkpoint;
use riprap::run::simulation::{Simulation, Snapshot, Stage};
use riprap_testkit::Counting;

fn plan(time_step: TimeStep) -> Plan {
    Plan {
        phases: vec![Phase {
            name: "fall".into(),
            kind: PhaseKind::Dynamic,
            until: Until { time: Some(10.0), ..Until::default() },
            integration: Integration::Explicit,
            time_step,
            damping: Damping::default(),
            remove: vec![],
            fix: vec![],
            release: vec![],
            install: vec![],
            gravity: None,
            step_error: None,
            levels: 0,
            gravity_ramp: None,
            removal_ramp: None,
            leavers: None,
            water: None,
            contacts: vec![],
            joints: vec![],
            reduction: None,
            zero_velocities: false,
            zero_displacements: false,
            deform: None,
            max_residual: 0.1,
        }],
        ..Plan::default()
    }
}

/// A wall on narrow feet that falls apart, with concave blocks and joints in it.
fn collapse(rows: usize, columns: usize) -> Setup {
    let mut contact = law(DISTANCE, 1e8);
    contact.friction = 0.5;
    contact.damping_ratio = 0.2;
    let mut blocks = vec![block(&rectangle(-50.0, -2.0, columns as f64 + 50.0, 0.0))];
    for r in 0..rows {
        for c in 0..columns {
            let x = c as f64 + 0.5 * (r % 2) as f64;
            let y = 0.8 + 0.5 * r as f64;
            let mut one = block(&rectangle(x, y, x + 1.0, y + 0.5));
            one.velocity = Vec2::new(0.4 * (r as f64 - 3.0), 0.1 * c as f64);
            blocks.push(one);
        }
    }
    let top = 1.5 + 0.5 * rows as f64;
    for k in 0..columns / 2 {
        let shape = if k % 2 == 0 { l_shape() } else { comb() };
        blocks.push(block(&moved(&shape, 0.4, Vec2::new(2.0 * k as f64, top))));
    }
    let mut setup = setup(blocks, contact);
    setup.gravity = [0.0, -9.81];
    setup.interfaces[0].bond = Some(BondLaw {
        normal_stiffness: 1e8,
        shear_stiffness: 5e7,
        strength: Strength {
            tension: 2e3,
            cohesion: 4e3,
            friction: 0.5,
            residual_friction: 0.4,
            ..Strength::default()
        },
        behaviour: Default::default(),
        damping_ratio: 0.2,
        points: 2,
    });
    hold(&mut setup, &[0]);
    setup
}

fn run(simulation: &mut Simulation, steps: u64) {
    for _ in 0..steps {
        assert_eq!(simulation.prepare().unwrap(), Stage::Within);
        simulation.step();
    }
}

#[test]
fn same_bits_for_any_number_of_threads() {
    let hash = |threads| {
        let exec = Exec::new(threads).unwrap();
        let mut simulation =
            Simulation::new(collapse(30, 50), plan(TimeStep::Auto { safety: 0.2 }), exec).unwrap();
        run(&mut simulation, 1200);
        let broken =
            simulation.view().planar().unwrap().world.bonds.iter().filter(|b| b.broken()).count();
        (simulation.engine().hash(), broken)
    };
    let one = hash(1);
    assert!(one.1 > 10, "only {} joints broke", one.1);
    for threads in [2, 4, 7] {
        assert_eq!(hash(threads), one, "{threads} threads");
    }
}

#[test]
fn a_checkpoint_changes_nothing() {
    let setup = collapse(6, 10);
    let rule = TimeStep::Auto { safety: 0.2 };
    let mut straight = Simulation::new(setup.clone(), plan(rule), Exec::serial()).unwrap();
    run(&mut straight, 4000);
    let folder = tempfile::tempdir().unwrap();
    let mut stopped = Simulation::new(setup, plan(rule), Exec::serial()).unwrap();
    for leg in 0..8 {
        run(&mut stopped, 500);
        let path = folder.path().join(format!("{leg}.ckpt"));
        checkpoint::write(&path, "planar", &stopped.snapshot()).unwrap();
        let snapshot: Snapshot = checkpoint::read(&path, "planar").unwrap();
        stopped = Simulation::resume(snapshot, Exec::serial());
    }
    let world = |s: &Simulation| s.view().planar().unwrap().world.clone();
    let (a, b) = (world(&straight), world(&stopped));
    assert!(a.bonds.iter().any(Bond::broken));
    assert_eq!(straight.engine().hash(), stopped.engine().hash());
    assert_eq!(a.works, b.works);
}

#[test]
fn a_steady_step_allocates_nothing() {
    let mut contact = law(DISTANCE, 1e10);
    contact.friction = 0.6;
    contact.damping_ratio = 0.2;
    let mut blocks = vec![block(&rectangle(-5.0, -1.0, 45.0, 0.0))];
    for k in 0..1000 {
        let (r, c) = ((k / 40) as f64, (k % 40) as f64);
        let x = c + 0.5 * (r % 2.0);
        blocks.push(block(&rectangle(x, 0.5 * r, x + 1.0, 0.5 * r + 0.5)));
    }
    // A concave block on top: the general road must not allocate either.
    blocks.push(block(&moved(&comb(), 0.0, Vec2::new(10.0, 12.5))));
    let mut setup = setup(blocks, contact);
    setup.gravity = [0.0, -9.81];
    hold(&mut setup, &[0]);
    let mut simulation =
        Simulation::new(setup, plan(TimeStep::Auto { safety: 0.2 }), Exec::serial()).unwrap();
    run(&mut simulation, 400);
    let before = Counting::allocations_here();
    run(&mut simulation, 100);
    assert_eq!(Counting::allocations_here() - before, 0);
}
