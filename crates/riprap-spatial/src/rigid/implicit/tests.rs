//! Implicit steps of a world: momentum, energy, threads, restart.

use riprap_geom::Vec3;
use riprap_geom::height_field::HeightField;

use crate::contact::tests::joint;
use crate::dynamics::damping::Damping;
use crate::exec::Exec;
use crate::laws::bolt::Design;
use crate::ledger::Balance;
use crate::push::bolts::install::install;
use crate::query::view::View;
use crate::rigid::implicit::choose;
use crate::setup::{
    BlockName, BlockSpec, Bolt, InterfaceLaw, Material, Motion, Setup, Shape, Support, Surface,
};
use crate::state::patches::flag;
use crate::state::scratch::Scratch;
use crate::state::world::World;
use crate::step;

fn brick(centre: [f64; 3], size: [f64; 3], velocity: Vec3, spin: Vec3) -> BlockSpec {
    let (centre, half) = (Vec3::from_array(centre), 0.5 * Vec3::from_array(size));
    BlockSpec {
        name: BlockName { base: 0, number: 0 },
        shape: Shape::Brick { centre, half },
        material: 0,
        velocity,
        spin,
    }
}

/// Blocks of a rock with friction, the first one held or not.
fn model(mut blocks: Vec<BlockSpec>, held: bool, gravity: f64) -> Setup {
    for (k, block) in blocks.iter_mut().enumerate() {
        block.name.number = k as u32 + 1;
    }
    let motion = Motion::Fixed { translation: [true; 3], rotation: [true; 3] };
    let rock = Material { name: "rock".into(), density: 2500.0, young: None, poisson: None };
    let law = joint(0.5, 0.0);
    Setup {
        gravity: Vec3::new(0.0, 0.0, -gravity),
        materials: vec![rock],
        names: vec!["rock".into()],
        blocks,
        interfaces: vec![InterfaceLaw {
            name: "default".into(),
            bond: None,
            friction: None,
            joint: law,
        }],
        pair_table: vec![0],
        supports: if held { vec![Support { blocks: vec![0], motion }] } else { Vec::new() },
        found_contacts: true,
        ..Setup::default()
    }
}

struct Run {
    world: World,
    scratch: Scratch,
    dt: f64,
}

impl Run {
    fn new(setup: Setup, threads: usize, dt: f64) -> Self {
        let (world, scratch) = World::new(setup, Exec::new(threads).unwrap()).unwrap();
        let mut run = Self { world, scratch, dt };
        choose(&mut run.world, &mut run.scratch, true);
        run.evaluate();
        run.world.start_energy = Some(run.balance().total());
        run
    }

    fn evaluate(&mut self) {
        let damping = Damping::default();
        step::evaluate(&mut self.world, &mut self.scratch, &damping, self.dt).unwrap();
    }

    fn steps(&mut self, count: usize) {
        for _ in 0..count {
            step::advance(&mut self.world, &mut self.scratch, self.dt);
            self.evaluate();
        }
    }

    fn balance(&self) -> Balance {
        View { world: &self.world, scratch: &self.scratch }.balance()
    }

    fn momentum(&self) -> [Vec3; 2] {
        let mut sums = [Vec3::ZERO; 2];
        for b in 0..self.world.alive.len() {
            let solid = self.world.solid_of(b);
            let pose = self.world.pose(b);
            let p = solid.mass * self.world.bodies.velocity(b);
            let spin = self.world.turning(b).momentum;
            sums[0] += p;
            sums[1] += pose.position.cross(p) + spin;
        }
        sums
    }
}

/// A floor and bricks of several sizes above it, askew.
fn heap() -> Vec<BlockSpec> {
    let mut blocks = vec![brick([0.0, 0.0, -0.5], [8.0, 8.0, 1.0], Vec3::ZERO, Vec3::ZERO)];
    for k in 0..24_u32 {
        let at = |n: u32, m: u32| f64::from((k * n) % m) / f64::from(m) - 0.5;
        let centre = [0.8 * at(5, 7), 0.8 * at(3, 5), 0.4 + 0.3 * f64::from(k)];
        let size = [0.3 + 0.1 * at(7, 11), 0.25 + 0.1 * at(4, 9), 0.2 + 0.1 * at(2, 13)];
        let spin = Vec3::new(at(3, 11), at(5, 13), at(2, 7));
        blocks.push(brick(centre, size, Vec3::new(0.0, 0.0, -1.0), spin));
    }
    blocks
}

/// The same on rough terrain, from which blocks rebound.
fn heap_on_ground() -> Setup {
    let mut setup = model(heap(), false, 9.81);
    let line: Vec<f64> = (0..=16).map(|k| 0.5 * f64::from(k) - 4.0).collect();
    let height = |i: usize, j: usize| 0.03 * ((i * 5 + j * 3) % 7) as f64 - 0.1;
    let field = HeightField::grid(&line, &line, |i, j| Some(height(i, j))).unwrap();
    setup.blocks[0].shape =
        Shape::Terrain(Box::new(Surface { points: field.points, triangles: field.triangles }));
    setup.interfaces[0].joint.rebound = 0.4;
    setup
}

#[test]
fn any_number_of_threads_and_a_restart_give_the_same_bits() {
    let on_floor: fn() -> Setup = || model(heap(), true, 9.81);
    for setup in [on_floor, heap_on_ground] {
        let run = |threads: usize| {
            let mut run = Run::new(setup(), threads, 1e-3);
            run.steps(600);
            run
        };
        let one = run(1);
        assert!(one.world.works.friction > 0.0);
        for threads in [2, 3, 5] {
            assert_eq!(run(threads).world.hash(), one.world.hash(), "{threads} threads");
        }
        let mut first = Run::new(setup(), 1, 1e-3);
        first.steps(333);
        // What a checkpoint holds, without any workspace; forces are found again.
        let mut world = first.world.clone();
        let scratch = Scratch::new(&mut world, Exec::new(3).unwrap());
        let mut again = Run { world, scratch, dt: 1e-3 };
        again.evaluate();
        again.steps(267);
        assert_eq!(again.world.hash(), one.world.hash());
        assert_eq!(again.world.works, one.world.works);
    }
}

/// A free row of six bricks with joints, which turns with a rate (rad/s).
fn turning_row(rate: f64) -> Setup {
    let row = (0..6_u32).map(|k| {
        let x = 0.4 * f64::from(k) - 1.0;
        let velocity = Vec3::new(0.0, rate * x, 0.0);
        brick([x, 0.0, 0.0], [0.4, 0.4, 0.3], velocity, Vec3::new(0.0, 0.0, rate))
    });
    let mut setup = model(row.collect(), false, 0.0);
    let strength = setup.interfaces[0].joint.strength.as_mut().unwrap();
    (strength.cohesion, strength.tension) = (300e3, 70e3);
    setup
}

/// The middle joint of a row bears `rho w^2 L^2/8`: 28.8 kPa at 4 rad/s and, since that comes at once, up to twice as much; at 8 rad/s 115 kPa, and those
/// beside it 102 kPa.
#[test]
fn joints_hold_what_they_can_bear_and_keep_momentum() {
    for (rate, broken) in [(4.0, 0), (8.0, 12)] {
        let mut run = Run::new(turning_row(rate), 1, 1e-3);
        let [p, l] = run.momentum();
        let start = run.balance().total();
        for _ in 0..200 {
            run.steps(1);
            // A turn in a step of 1 ms changes it in the second order.
            let total = run.balance().total();
            let most = start * (1.0 + (1e-3 * rate) * (1e-3 * rate));
            assert!(total <= most, "{rate}: {total} {start}");
        }
        let balance = run.balance();
        assert!(balance.residual_relative().abs() < 1e-3, "{balance:?}");
        let [q, m] = run.momentum();
        assert!((q - p).length() < 1e-9 * l.length(), "{p} {q}");
        assert!((m - l).length() < 5e-3 * l.length(), "{l} {m}");
        let failed: u32 =
            run.world.patches.flags.iter().map(|f| (f & flag::BROKEN).count_ones()).sum();
        let gone = 4 * (5 - run.world.patches.len() as u32);
        assert_eq!(failed + gone, broken, "{rate}");
        assert_eq!(balance.works.fracture > 0.0, broken > 0, "{balance:?}");
        let apart = run.world.pose(5).position.distance(run.world.pose(0).position);
        assert_eq!(apart > 2.01, broken > 0, "{apart}");
    }
}

/// A wall with joints on a floor, into which a brick flies: joints fail, and contacts take over.
fn wall_that_breaks() -> Setup {
    let mut blocks = vec![brick([0.0, 0.0, -0.5], [8.0, 8.0, 1.0], Vec3::ZERO, Vec3::ZERO)];
    for k in 0..9_u32 {
        let [column, row] = [k % 3, k / 3].map(f64::from);
        let centre = [0.0, 0.5 * column - 0.5, 0.15 + 0.3 * row];
        blocks.push(brick(centre, [0.25, 0.5, 0.3], Vec3::ZERO, Vec3::ZERO));
    }
    let fast = Vec3::new(6.0, 0.5, 1.0);
    blocks.push(brick([-0.6, 0.05, 0.7], [0.4, 0.3, 0.3], fast, Vec3::new(1.0, 2.0, 0.0)));
    let mut setup = model(blocks, true, 9.81);
    let strength = setup.interfaces[0].joint.strength.as_mut().unwrap();
    (strength.cohesion, strength.tension) = (60e3, 30e3);
    setup
}

#[test]
fn a_wall_that_breaks_has_the_same_bits_with_any_threads_and_after_restart() {
    let run = |threads: usize| {
        let mut run = Run::new(wall_that_breaks(), threads, 1e-3);
        run.steps(400);
        run
    };
    let one = run(1);
    let balance = one.balance();
    assert!(balance.works.fracture > 0.0 && balance.works.friction > 0.0, "{balance:?}");
    assert!(balance.residual_relative().abs() < 2e-3, "{balance:?}");
    // Some joints hold, others have become contacts.
    assert!((1..21).contains(&one.world.patches.len()), "{}", one.world.patches.len());
    assert_eq!(run(3).world.hash(), one.world.hash());
    for at in [40, 150] {
        let mut first = Run::new(wall_that_breaks(), 1, 1e-3);
        first.steps(at);
        let mut world = first.world.clone();
        let scratch = Scratch::new(&mut world, Exec::new(2).unwrap());
        let mut again = Run { world, scratch, dt: 1e-3 };
        again.evaluate();
        again.steps(400 - at);
        assert_eq!(again.world.hash(), one.world.hash(), "{at}");
        assert_eq!(again.world.works, one.world.works, "{at}");
    }
}

/// Three bricks in a row, apart, on two bolts; the last one flies away askew.
fn bolted(breaks: f64, threads: usize) -> Run {
    let spin = Vec3::new(0.1, 0.2, 0.3);
    let row = (0..3_u32).map(|k| {
        let moves = if k == 2 { 1.0 } else { 0.0 };
        let centre = [0.0, 0.0, 1.0 + 2.001 * f64::from(k)];
        brick(centre, [1.0, 1.0, 2.0], moves * Vec3::new(0.3, -0.1, 1.5), moves * spin)
    });
    let mut setup = model(row.collect(), false, 0.0);
    let design = Design {
        axial: 98e6,
        yields: 250e3,
        hardening: 0.0,
        breaks,
        grout: 1e9,
        bond: 200e3,
        grouted: f64::INFINITY,
        plate: None,
        pretension: 0.0,
        dowel: Some([5e7, 30e3]),
        piece: 0.05,
    };
    setup.bolts = [-0.3, 0.2]
        .map(|x| Bolt {
            name: format!("bolt {x}"),
            head: Vec3::new(x, 0.1, 6.0),
            toe: Vec3::new(x, 0.0, 0.0),
            design,
        })
        .to_vec();
    let mut run = Run::new(setup, threads, 1e-3);
    install(&mut run.world, &[0, 1]).unwrap();
    run.scratch.invalidate(&mut run.world);
    run.evaluate();
    run.world.start_energy = Some(run.balance().total());
    run
}

#[test]
fn bolts_yield_and_tear_and_keep_momentum() {
    for (breaks, torn) in [(f64::INFINITY, false), (1e-3, true)] {
        let mut run = bolted(breaks, 1);
        let [p, l] = run.momentum();
        let start = run.balance().total();
        for _ in 0..100 {
            run.steps(1);
            let balance = run.balance();
            assert!(balance.total() <= start * (1.0 + 1e-6), "{balance:?}");
            assert!(balance.residual_relative().abs() < 1e-3, "{balance:?}");
        }
        let works = run.balance().works;
        assert!(works.bolts > 0.0 && works.integrator > 0.0, "{works:?}");
        assert_eq!(run.world.bolts.iter().any(|bolt| bolt.toll.breaks > 0), torn);
        let [q, m] = run.momentum();
        assert!((q - p).length() < 1e-9 * p.length(), "{p} {q}");
        assert!((m - l).length() < 1e-3 * l.length(), "{l} {m}");
        for threads in [2, 3] {
            let mut other = bolted(breaks, threads);
            other.steps(37);
            let mut world = other.world.clone();
            let scratch = Scratch::new(&mut world, Exec::new(threads).unwrap());
            let mut other = Run { world, scratch, dt: 1e-3 };
            other.evaluate();
            other.steps(63);
            assert_eq!(other.world.hash(), run.world.hash(), "{threads} threads");
            assert_eq!(other.world.works, run.world.works);
        }
    }
}

/// Blocks that fall askew on two triangles in one plane: the motion is that on a brick.
#[test]
fn flat_terrain_is_a_floor() {
    let motion = |terrain: bool| {
        let falls =
            || brick([0.1, 0.2, 0.3], [0.4, 0.5, 0.3], Vec3::new(1.0, 0.3, -1.0), Vec3::ZERO);
        let floor = brick([0.0, 0.0, -0.5], [8.0, 8.0, 1.0], Vec3::ZERO, Vec3::ZERO);
        let mut setup = model(vec![floor, falls()], !terrain, 9.81);
        setup.blocks[1].spin = Vec3::new(0.4, 0.2, 1.0);
        if terrain {
            let line: Vec<f64> = (0..=13).map(|k| 8.0 / 13.0 * f64::from(k) - 4.0).collect();
            let field = HeightField::grid(&line, &line, |_, _| Some(0.0)).unwrap();
            let surface = Surface { points: field.points, triangles: field.triangles };
            setup.blocks[0].shape = Shape::Terrain(Box::new(surface));
        }
        let mut run = Run::new(setup, 1, 1e-3);
        run.steps(300);
        let balance = run.balance();
        assert!(balance.residual_relative().abs() < 1e-3, "{:e}", balance.residual_relative());
        (run.world.pose(1).position, run.world.bodies.velocity(1), balance.works.friction)
    };
    let [floor, ground] = [false, true].map(motion);
    // Pieces of a brick push along the normal that they have together, those of a facet along its own.
    assert!((floor.0 - ground.0).length() < 1e-3, "{} {}", floor.0, ground.0);
    assert!((floor.1 - ground.1).length() < 1e-2, "{} {}", floor.1, ground.1);
    assert!((floor.2 / ground.2 - 1.0).abs() < 0.05, "{} {}", floor.2, ground.2);
}

/// Two free bricks that meet face to face part with the share of their speed that is given, and momentum stays.
#[test]
fn an_impact_rebounds_as_given() {
    for rebound in [0.2, 0.5, 1.0] {
        let blocks = vec![
            brick([0.0; 3], [0.4, 0.4, 0.4], Vec3::new(1.0, 0.0, 0.0), Vec3::ZERO),
            brick([0.5, 0.0, 0.0], [0.4, 0.4, 0.2], Vec3::ZERO, Vec3::ZERO),
        ];
        let mut setup = model(blocks, false, 0.0);
        setup.interfaces[0].joint.rebound = rebound;
        let mut run = Run::new(setup, 1, 1e-3);
        let [p, _] = run.momentum();
        run.steps(300);
        let [a, b] = [0, 1].map(|b| run.world.bodies.velocity(b).x);
        assert!((b - a - rebound).abs() < 1e-3 * rebound, "{rebound}: {a} {b}");
        assert!((run.momentum()[0] - p).length() < 1e-12 * p.length());
        let lost = run.balance().works.integrator;
        // Of the energy of the relative motion of masses of 2 to 1.
        let energy = 0.5 * 2500.0 * (0.064 * 0.032 / 0.096);
        let most = energy * (1.0 - rebound * rebound);
        assert!((lost - most).abs() < 1e-3 * energy, "{rebound}: {lost} {most}");
    }
}

#[test]
fn evaluating_an_instant_again_changes_nothing() {
    let mut run = Run::new(model(heap(), true, 9.81), 1, 1e-3);
    run.steps(300);
    let (hash, works) = (run.world.hash(), run.world.works);
    for dt in [1e-4, 0.0, 1e-3] {
        run.dt = dt;
        run.evaluate();
    }
    assert_eq!((run.world.hash(), run.world.works), (hash, works));
}

#[test]
fn momentum_is_exact_and_energy_never_grows() {
    // Three bricks that fly into each other and touch with friction; nothing else acts.
    let blocks = vec![
        brick([0.0; 3], [0.4, 0.5, 0.3], Vec3::ZERO, Vec3::new(0.0, 0.3, 1.0)),
        brick([0.6, 0.1, 0.05], [0.3; 3], Vec3::new(-2.0, 0.1, 0.0), Vec3::new(0.5, 0.0, 0.0)),
        brick([0.1, 0.7, 0.0], [0.4, 0.3, 0.2], Vec3::new(0.0, -3.0, 0.2), Vec3::ZERO),
    ];
    let mut run = Run::new(model(blocks, false, 0.0), 1, 1e-3);
    let [p, l] = run.momentum();
    let start = run.balance().total();
    let (mut before, mut apart) = (run.balance(), start);
    for _ in 0..400 {
        run.steps(1);
        let now = run.balance();
        // A body that spins freely about no principal axis keeps its energy to the second order of the step.
        let most = start * (1.0 + 1e-7);
        assert!(now.total() <= most, "{} {start}", now.total());
        assert!(now.residual().abs() < 5e-5 * start, "{}", now.residual() / start);
        // While bodies press, what the step has taken and what they store are booked at different instants.
        if run.world.found.pairs.iter().all(|pair| pair.depth == 0.0) {
            assert!(now.total() <= apart + 1e-7 * start, "{} {apart}", now.total());
            apart = now.total();
        }
        before = now;
    }
    assert!(before.works.integrator > 0.01 * start && before.works.friction > 0.0);
    let [q, m] = run.momentum();
    assert!((q - p).length() < 1e-10 * p.length(), "{p} {q}");
    assert!((m - l).length() < 1e-3 * l.length(), "{l} {m}");
}

#[test]
fn a_brick_that_turns_on_its_edge_loses_little_to_the_integration() {
    // A brick that turns about its edge without an impact.
    let lost = |dt: f64| {
        let blocks = vec![
            brick([0.0, 0.0, -0.5], [4.0, 4.0, 1.0], Vec3::ZERO, Vec3::ZERO),
            // With its edge at rest.
            brick(
                [0.0, 0.0, 0.5],
                [0.25, 0.5, 1.0],
                Vec3::new(0.75, 0.0, 0.1875),
                Vec3::new(0.0, 1.5, 0.0),
            ),
        ];
        let mut run = Run::new(model(blocks, true, 9.81), 1, dt);
        // The edge takes up the weight at once, which shakes it a little.
        run.steps((0.1 / dt).round() as usize);
        let first = run.balance().works.integrator;
        run.steps((0.2 / dt).round() as usize);
        let spent = run.balance();
        let left = spent.residual_relative().abs();
        assert!(left < 40.0 * dt * dt, "{left}");
        spent.works.integrator - first
    };
    let [coarse, fine] = [4e-3, 2e-3].map(lost);
    // Of the 129 J with which it turns.
    assert!(0.0 < fine && fine < coarse && coarse < 0.13, "{coarse} {fine}");
}

/// A brick whose joint to the floor holds at two of four points turns about them: its edge goes into the floor, and when the joint is released at
/// 0.3 rad the depth there must not throw it, nor when an explicit phase takes over at once.
#[test]
fn the_depth_of_a_folded_joint_is_not_pressed_out() {
    for explicit_then in [false, true] {
        let rate = 4.0;
        let hinge = Vec3::new(0.25 / 3.0f64.sqrt(), 0.0, 0.0);
        let spin = Vec3::new(0.0, rate, 0.0);
        let velocity = spin.cross(Vec3::new(0.0, 0.0, 0.25) - hinge);
        let floor = brick([0.0, 0.0, -0.5], [8.0, 8.0, 1.0], Vec3::ZERO, Vec3::ZERO);
        let block = brick([0.0, 0.0, 0.25], [0.5; 3], velocity, spin);
        let mut setup = model(vec![floor, block], true, 0.0);
        let strength = setup.interfaces[0].joint.strength.as_mut().unwrap();
        (strength.cohesion, strength.tension) = (1e9, 1e9);
        let mut run = Run::new(setup, 1, 1e-3);
        let class = run.world.classes[run.world.patches.class[0] as usize];
        for q in 0..4 {
            if crate::joint::patch::place(&class, q).dot(Vec3::X) < 0.0 {
                run.world.patches.flags[0] |= flag::of(flag::BROKEN, q) | flag::of(flag::OPEN, q);
            }
        }
        run.steps(70);
        assert_eq!(run.world.patches.len(), 1);
        run.steps(30);
        assert!(run.world.patches.is_empty());
        let before = run.balance();
        let energy = before.total();
        let kept = run.world.implicit.as_ref().unwrap().kept.clone();
        assert!(kept.iter().any(|kept| kept.hidden > 1e6), "{kept:?}");
        if explicit_then {
            choose(&mut run.world, &mut run.scratch, false);
            run.dt = 2e-5;
            run.evaluate();
            run.steps(5_000);
        } else {
            run.steps(400);
        }
        let balance = run.balance();
        // Nothing but a blow on the floor takes from it what the hinge left.
        assert!(balance.kinetic <= 1.001 * energy, "{balance:?} {energy}");
        let taken = balance.works.integrator - before.works.integrator;
        assert!(taken.abs() < 0.1 * energy, "{balance:?} {before:?}");
    }
}
