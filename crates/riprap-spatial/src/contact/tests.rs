//! Separate blocks that fall, slide and rebound in the engine; threads and restart.

mod periodic;

use riprap_geom::{Quat, Vec3};

use crate::broad::search::Candidate;
use crate::dynamics::damping::Damping;
use crate::exec::Exec;
use crate::frame::Content;
use crate::kernel::offset::{Carried, Offset};
use crate::query::view::View;
use crate::setup::{
    BlockName, BlockSpec, InterfaceLaw, JointLaw, Material, Motion, Setup, Shape, Solid, Stiffness,
    Strength, Support,
};
use crate::state::found::{ContactPatch, FoundPair};
use crate::state::scratch::Scratch;
use crate::state::world::World;
use crate::step;

pub(super) fn brick(low: [f64; 3], size: [f64; 3]) -> BlockSpec {
    let half = 0.5 * Vec3::from_array(size);
    BlockSpec {
        name: BlockName { base: 0, number: 0 },
        shape: Shape::Brick { centre: Vec3::from_array(low) + half, half },
        material: 0,
        velocity: Vec3::ZERO,
        spin: Vec3::ZERO,
    }
}

pub(super) fn turned(low: [f64; 3], size: [f64; 3], rotation: Quat) -> BlockSpec {
    let mut block = brick(low, size);
    if let Shape::Brick { centre, half } = block.shape {
        let solid = riprap_geom::polyhedron::Polyhedron::brick(Vec3::ZERO, half);
        let vertices = solid.vertices.iter().map(|v| rotation * *v + centre);
        block.shape =
            Shape::Polyhedron(Box::new(Solid { vertices: vertices.collect(), faces: solid.faces }));
    }
    block
}

/// Joints and contacts of 1e9 and 5e8 Pa/m without strength but for friction; tan of its angle, and damping ratio of both.
pub(crate) fn joint(friction: f64, damping: f64) -> JointLaw {
    JointLaw {
        stiffness: Stiffness::Given { normal: 1e9, shear: 5e8 },
        strength: Some(Strength {
            cohesion: 0.0,
            tension: 0.0,
            friction,
            residual_friction: friction,
            residual_cohesion: 0.0,
            dilation: 0.0,
            dilation_end: 1.0,
        }),
        damping,
        contact_damping: damping,
        ..JointLaw::default()
    }
}

/// A fixed floor with its top at z = 0, and blocks above it; tan of the friction angle and damping ratio of all contacts.
pub(super) fn above_floor(blocks: Vec<BlockSpec>, friction: f64, damping: f64) -> Setup {
    let mut setup = Setup {
        gravity: Vec3::new(0.0, 0.0, -9.81),
        names: vec!["rock".into()],
        blocks: vec![brick([-4.0, -4.0, -1.0], [8.0, 8.0, 1.0])],
        pair_table: vec![0],
        found_contacts: true,
        ..Setup::default()
    };
    setup.materials.push(Material {
        name: "rock".into(),
        density: 2500.0,
        young: None,
        poisson: None,
    });
    setup.interfaces.push(InterfaceLaw {
        name: "default".into(),
        bond: None,
        friction: None,
        joint: joint(friction, damping),
    });
    setup.supports.push(Support {
        blocks: vec![0],
        motion: Motion::Fixed { translation: [true; 3], rotation: [true; 3] },
    });
    setup.blocks.extend(blocks);
    for (k, block) in setup.blocks.iter_mut().enumerate() {
        block.name.number = k as u32 + 1;
    }
    setup
}

/// Gives all contacts this stiffness, Pa/m.
fn stiff(setup: &mut Setup, stiffness: f64) {
    setup.interfaces[0].joint.stiffness = Stiffness::Given { normal: stiffness, shear: stiffness };
}

pub(super) struct Run {
    pub(super) world: World,
    pub(super) scratch: Scratch,
    pub(super) dt: f64,
}

impl Run {
    pub(super) fn new(setup: Setup, threads: usize, dt: f64) -> Self {
        let (world, scratch) = World::new(setup, Exec::new(threads).unwrap()).unwrap();
        Self { world, scratch, dt }
    }

    /// What two bodies share.
    pub(super) fn patches(&self, ends: [u32; 2]) -> &[ContactPatch] {
        let pair = self.world.found.pairs.iter().find(|pair| pair.ends == ends);
        pair.map_or(&[], |pair| &pair.patches)
    }

    pub(super) fn evaluate(&mut self) {
        step::evaluate(&mut self.world, &mut self.scratch, &Damping::default(), self.dt).unwrap();
    }

    /// On to `time`; the forces there are found.
    pub(super) fn until(&mut self, time: f64) {
        self.evaluate();
        if self.world.start_energy.is_none() {
            self.world.start_energy = Some(self.view().balance().total());
        }
        while self.world.time < time - 0.5 * self.dt {
            step::advance(&mut self.world, &mut self.scratch, self.dt);
            self.evaluate();
        }
    }

    /// One step, no longer than the contacts allow; the forces there are found. As a run does it.
    fn limited_step(&mut self, longest: f64) {
        let mut dt = longest.min(super::step_limit(&self.world));
        let mut find = |dt| {
            let damping = Damping::default();
            step::evaluate(&mut self.world, &mut self.scratch, &damping, dt).unwrap();
            super::step_limit(&self.world)
        };
        let limit = find(dt);
        if limit < 0.5 * dt {
            dt = limit;
            find(dt);
        }
        if self.world.start_energy.is_none() {
            let half_kick = self.view().half_kick();
            let total = self.view().balance().total();
            self.world.start_energy = Some(total - 0.5 * half_kick);
        }
        step::advance(&mut self.world, &mut self.scratch, dt);
    }

    /// As [`Run::until`], where all that can be laid out anew is laid out anew before each step.
    pub(super) fn until_laid_out_each_step(&mut self, time: f64) {
        while self.world.time < time - 0.5 * self.dt {
            self.scratch = Scratch::new(&mut self.world, Exec::serial());
            self.evaluate();
            step::advance(&mut self.world, &mut self.scratch, self.dt);
            self.scratch = Scratch::new(&mut self.world, Exec::serial());
        }
        self.evaluate();
    }

    pub(super) fn view(&self) -> View<'_> {
        View { world: &self.world, scratch: &self.scratch }
    }

    pub(super) fn place(&self, b: usize) -> Vec3 {
        self.world.pose(b).position
    }
}

#[test]
fn frames_hold_every_number_of_found_contacts() {
    let block = brick([0.0, 0.0, 1e-4], [0.5; 3]);
    let mut run = Run::new(above_floor(vec![block], 0.5, 0.2), 1, 1e-4);
    run.until(0.1);
    let frame = crate::read::picture::frame(&run.view(), "fall", &Content::default());
    assert_eq!(frame.contact_points.len(), 1);
    for column in &frame.contact_columns {
        assert_eq!(column.data.len(), column.components, "{}", column.name);
    }
    let fields: Vec<_> = frame.block_columns.iter().map(|c| c.name.as_str()).collect();
    assert_eq!(fields, crate::read::picture::FIELDS);
    let some = Content {
        fields: Some(vec!["velocity".to_owned()]),
        contacts: false,
        ..Content::default()
    };
    let frame = crate::read::picture::frame(&run.view(), "fall", &some);
    let fields: Vec<_> = frame.block_columns.iter().map(|c| c.name.as_str()).collect();
    assert_eq!(fields, ["block", "material", "velocity"]);
    assert!(frame.contact_points.is_empty() && frame.contact_columns.is_empty());
}

#[test]
fn two_bricks_fall_on_a_floor_and_rest_on_each_other() {
    let blocks = vec![brick([-0.25, -0.25, 0.05], [0.5; 3]), brick([-0.2, -0.25, 0.65], [0.5; 3])];
    let mut run = Run::new(above_floor(blocks, 0.6, 0.2), 1, 1e-4);
    run.until(1.5);
    // Pressed in by their weight over the stiffness.
    let (low, high) = (run.place(1), run.place(2));
    assert!((low.z - 0.25).abs() < 1e-4, "{low}");
    assert!((high.z - 0.75).abs() < 1e-4, "{high}");
    // It has rocked a little as it landed.
    assert!((high.x - 0.05).abs() < 2e-2, "{high}");
    // The rocking of the column fades slowly.
    assert!(run.view().kinetic(1) + run.view().kinetic(2) < 0.1);
    // The floor carries both.
    let weight = 2.0 * 2500.0 * 0.125 * 9.81;
    let floor = run.world.found.pairs.iter().find(|p| p.ends == [0, 1]);
    let force = floor.map_or(0.0, |p| p.force().z);
    assert!((force / weight - 1.0).abs() < 1e-2, "{force} {weight}");
    let balance = run.view().balance();
    assert!(balance.residual_relative().abs() < 1e-5, "{:e}", balance.residual_relative());
}

#[test]
fn a_thrown_brick_hands_its_speed_over() {
    let mut thrown = brick([0.0, 0.0, 1.0], [0.5; 3]);
    thrown.velocity = Vec3::new(2.0, 0.0, 0.0);
    let still = brick([1.0, 0.0, 1.0], [0.5; 3]);
    let mut setup = above_floor(vec![thrown, still], 0.6, 0.0);
    setup.gravity = Vec3::ZERO;
    let mut run = Run::new(setup, 1, 5e-5);
    run.until(0.5);
    let [a, b] = [1, 2].map(|b| run.world.bodies.velocity(b));
    assert!(a.length() < 0.01, "{a}");
    assert!((b.x - 2.0).abs() < 0.01, "{b}");
    assert!(run.view().balance().residual_relative().abs() < 1e-9);
    assert!(run.world.found.pairs.iter().all(|p| p.depth == 0.0));
}

#[test]
fn a_sliding_brick_is_stopped_by_friction() {
    let mut sliding = brick([-2.0, -0.25, 0.0005], [0.5, 0.5, 0.25]);
    sliding.velocity = Vec3::new(2.0, 0.0, 0.0);
    let mut run = Run::new(above_floor(vec![sliding], 0.5, 0.2), 1, 1e-4);
    run.until(1.0);
    let way = run.place(1).x + 1.75;
    assert!((way / (4.0 / (2.0 * 0.5 * 9.81)) - 1.0).abs() < 0.02, "{way}");
    let works = &run.world.works;
    assert!(works.friction > 0.9 * 0.5 * 2500.0 * 0.0625 * 4.0);
    let residual = run.view().balance().residual_relative();
    assert!(residual.abs() < 1e-6, "{residual:e}");
}

/// Many bricks that fall in disorder: the same bits with threads, and after a restart in the middle.
#[test]
fn threads_and_restart_change_no_bit() {
    let setup = || {
        let mut blocks = Vec::new();
        for k in 0..700_u32 {
            let at = |p: u32| f64::from(p);
            let (x, y, z) = (at(k % 9), at(k / 9 % 9), at(k / 81));
            let low = [0.45 * x - 2.0 + 0.02 * z, 0.45 * y - 2.0, 0.001 + 0.301 * z];
            let mut block = brick(low, [0.4, 0.3, 0.3]);
            block.spin = Vec3::new(0.3 * y, -0.2 * x, 0.1 * z);
            blocks.push(block);
        }
        above_floor(blocks, 0.5, 0.2)
    };
    let bits = |run: &Run| -> Vec<u64> {
        let bodies = &run.world.bodies;
        let lists = bodies.displacement.iter().chain(&bodies.velocity).flatten();
        let shear =
            run.world.found.pairs.iter().flat_map(|p| &p.patches).map(|p| &p.memory.shear.x);
        lists.chain(shear).map(|x| x.to_bits()).collect()
    };
    let mut one = Run::new(setup(), 1, 2e-4);
    one.until(0.06);
    let world = one.world.clone();
    one.until(0.1);
    let touching = one.world.found.pairs.iter().filter(|p| p.depth > 0.0);
    assert!(touching.count() > 100);
    let mut two = Run::new(setup(), 2, 2e-4);
    two.until(0.1);
    assert!(bits(&one) == bits(&two), "threads change bits");
    let mut world = world;
    let scratch = Scratch::new(&mut world, Exec::serial());
    let mut again = Run { world, scratch, dt: 2e-4 };
    again.until(0.1);
    assert!(bits(&one) == bits(&again), "a restart changes bits");
}

/// Blocks of one lattice whose joints are whole are no candidates: nothing is searched, nothing kept.
#[test]
fn a_whole_lattice_has_no_candidates() {
    let mut setup = above_floor(
        vec![
            brick([0.0, 0.0, 0.0], [0.5; 3]),
            brick([0.5, 0.0, 0.0], [0.5; 3]),
            brick([0.0, 0.5, 0.0], [0.5; 3]),
            brick([0.5, 0.5, 0.0], [0.5; 3]),
        ],
        0.6,
        0.1,
    );
    setup.interfaces[0].joint.strength = None;
    let mut run = Run::new(setup, 1, 1e-5);
    run.until(1e-3);
    assert!(run.world.found.pairs.is_empty());
    assert!(run.world.found.search.pose.is_empty());
}

/// A block of 1 m against a fixed floor of 1 m, from soft to stiff and from slow to fast: it comes back with its speed, or it is told
/// before it could pass through. The depth that its energy asks for, `1/2 m v² = 1/2 k A d²`, says which.
#[test]
fn nothing_passes_through_a_floor_in_silence() {
    for stiffness in [1e6, 1e7, 1e8, 1e9, 1e10] {
        for speed in [1.0, 3.0, 10.0, 30.0, 100.0, 300.0] {
            let mut block = brick([-0.5, -0.5, 0.05], [1.0; 3]);
            block.velocity = Vec3::new(0.0, 0.0, -speed);
            let mut setup = above_floor(vec![block], 0.0, 0.0);
            setup.gravity = Vec3::ZERO;
            stiff(&mut setup, stiffness);
            let mut run = Run::new(setup, 1, 0.0);
            let stopped = loop {
                run.limited_step(1.0 / speed);
                let deepest = run.scratch.desk.deepest;
                if let Some(deepest) = deepest.filter(|d| d.ratio >= 1.0) {
                    assert_eq!(deepest.ends, [0, 1]);
                    // Told before it comes out on the far side.
                    assert!(deepest.depth < 0.75, "{deepest:?}");
                    break true;
                }
                let place = run.place(1).z;
                assert!(place > -0.1, "{stiffness:e} Pa/m, {speed} m/s: {place}");
                if place > 0.55 && run.world.bodies.velocity(1).z > 0.0 {
                    break false;
                }
                assert!(run.world.step < 20_000);
            };
            let depth = speed * (2500.0_f64 / stiffness).sqrt();
            if depth > 0.6 {
                assert!(stopped, "{stiffness:e} Pa/m, {speed} m/s: {depth} m");
            } else if depth < 0.4 {
                let back = run.world.bodies.velocity(1).z / speed;
                assert!(
                    !stopped && (back - 1.0).abs() < 2e-3,
                    "{stiffness:e} Pa/m, {speed} m/s: {back}"
                );
                let residual = run.view().balance().residual_relative();
                assert!(residual.abs() < 2e-3, "{stiffness:e} Pa/m, {speed} m/s: {residual:e}");
            }
        }
    }
}

/// Dashpots of a joint without strength do not hold back blocks that part from the first instant on.
#[test]
fn blocks_that_part_at_the_start_keep_their_speed() {
    let mut block = brick([-0.25, -0.25, 0.0], [0.5; 3]);
    block.velocity = Vec3::new(0.0, 0.0, 2.0);
    let mut setup = above_floor(vec![block], 0.5, 0.2);
    setup.gravity = Vec3::ZERO;
    let mut run = Run::new(setup, 1, 1e-4);
    assert_eq!(run.world.patches.len(), 1);
    run.until(0.01);
    assert_eq!(run.world.bodies.velocity(1), Vec3::new(0.0, 0.0, 2.0));
}

/// The length of a step hangs on how far pairs are apart: a restart between steps that adapt changes no bit.
#[test]
fn a_restart_takes_the_same_steps() {
    let mut blocks = Vec::new();
    for k in 0..12_u32 {
        let k = f64::from(k);
        let mut block = brick([0.3 * k - 2.0, 0.1 * k - 1.0, 0.02 + 0.4 * k], [0.4, 0.5, 0.3]);
        block.spin = Vec3::new(0.5, -0.1 * k, 1.0);
        block.velocity = Vec3::new(0.1 * k, 0.0, -2.0);
        blocks.push(block);
    }
    let mut run = Run::new(above_floor(blocks, 0.5, 0.2), 1, 0.0);
    for _ in 0..400 {
        run.limited_step(1e-3);
    }
    let mut world = run.world.clone();
    let scratch = Scratch::new(&mut world, Exec::serial());
    let mut again = Run { world, scratch, dt: 0.0 };
    for step in 0..400 {
        run.limited_step(1e-3);
        again.limited_step(1e-3);
        assert_eq!(run.world.last_dt, again.world.last_dt, "step {step}");
    }
    assert_eq!(run.world.hash(), again.world.hash());
}

/// A brick that hits the floor flat: its impact shortens the step, unless it is nothing beside what has moved in the run.
#[test]
fn slight_impacts_do_not_shorten_the_step() {
    let mut block = brick([0.0, 0.0, 0.0], [0.5; 3]);
    block.velocity = Vec3::new(0.0, 0.0, -0.1);
    let mut run = Run::new(above_floor(vec![block], 0.5, 0.1), 1, 1e-4);
    // The joint of the start is gone.
    run.evaluate();
    super::release::release_pairs(
        &mut run.world,
        &mut run.scratch,
        &[crate::kernel::PairKey::plain([0, 1])],
    );
    run.world.found.pairs[0].seated = false;
    run.until(5e-4);
    assert!(run.world.found.pairs[0].depth > 0.0);
    let mut limit = |peak: f64| {
        run.world.works.peak = peak;
        run.evaluate();
        super::step_limit(&run.world)
    };
    // 312.5 kg at 0.1 m/s: 1.6 J.
    let [short, long] = [1e2, 1e5].map(&mut limit);
    assert!(long > 1.5 * short, "{short:e} {long:e}");
    assert_eq!(limit(1e2), short);
}

/// A brick on its edge, turned by 45 deg.
fn on_edge(height: f64) -> BlockSpec {
    let turn = Quat::from_rotation_y(std::f64::consts::FRAC_PI_4);
    let below = 0.25 * 2f64.sqrt();
    turned([-0.25, -0.25, height + below - 0.25], [0.5; 3], turn)
}

/// The impact of a lone edge: steps are as short as it asks, though no face is near and nothing else moves.
#[test]
fn an_edge_that_strikes_keeps_its_energy() {
    for (speed, stiffness) in [(1.0, 1e8), (4.0, 1e9), (4.0, 1e11)] {
        let mut block = on_edge(0.3);
        block.velocity = Vec3::new(0.0, 0.0, -speed);
        let mut setup = above_floor(vec![block], 0.0, 0.0);
        setup.gravity = Vec3::ZERO;
        stiff(&mut setup, stiffness);
        let mut run = Run::new(setup, 1, 0.0);
        while run.world.time < 0.8 / speed {
            run.limited_step(0.05 / speed);
        }
        run.evaluate();
        let back = run.world.bodies.velocity(1).z / speed;
        assert!((back - 1.0).abs() < 3e-3, "{speed} {stiffness:e}: {back}");
        assert!(run.world.step < 4000);
    }
}

/// A block at rest just above the floor: the first step knows that it will fall.
#[test]
fn an_edge_at_rest_above_the_floor_does_not_fall_into_it() {
    let mut setup = above_floor(vec![on_edge(1e-4)], 0.0, 0.0);
    stiff(&mut setup, 1e11);
    let mut run = Run::new(setup, 1, 0.0);
    let mut deepest = 0.0_f64;
    while run.world.time < 0.05 {
        run.limited_step(0.02);
        deepest = run.world.found.pairs.iter().map(|p| p.depth).fold(deepest, f64::max);
    }
    // Its energy m g h of 0.3 J goes in by U = kn L d³ / 6 at least.
    assert!(deepest < 5e-4, "{deepest}");
    let balance = run.view().balance();
    let made = balance.works.law_defect + balance.residual();
    assert!(made.abs() < 0.02 * balance.scale(), "{made} of {}", balance.scale());
}

/// Ten cubes on each other, shifted by up to 0.05 m and twisted by up to 0.1 rad: each contact carries the weight above it, straight below
/// the centre of that weight, and nothing sideways.
#[test]
fn a_crooked_stack_carries_its_weight() {
    let (side, count) = (0.5, 10_u32);
    let weight = 2500.0 * side * side * side * 9.81;
    let blocks = (0..count).map(|k| {
        let k = f64::from(k);
        // By the golden angle, so that none is as the one below.
        let (sin, cos) = libm::sincos(2.399_963 * k);
        let low = [0.04 * cos - 0.5 * side, 0.05 * sin - 0.5 * side, 1e-4 + (side + 1e-4) * k];
        turned(low, [side; 3], Quat::from_rotation_z(0.1 * libm::sin(1.7 * k)))
    });
    let mut setup = above_floor(blocks.collect(), 0.6, 0.2);
    stiff(&mut setup, 1e10);
    let mut run = Run::new(setup, 1, 5e-5);
    // Contacts hardly damp the swaying of the whole.
    let damping = Damping { mass: 20.0, ..Damping::default() };
    while run.world.time < 1.5 {
        step::evaluate(&mut run.world, &mut run.scratch, &damping, run.dt).unwrap();
        step::advance(&mut run.world, &mut run.scratch, run.dt);
    }
    step::evaluate(&mut run.world, &mut run.scratch, &damping, run.dt).unwrap();
    let (mut worst, mut aside) = (0.0_f64, 0.0_f64);
    for k in 0..count as usize {
        let above = count as usize - k;
        let pairs = &run.world.found.pairs;
        let pair = pairs.iter().find(|p| p.ends == [k as u32, k as u32 + 1]).unwrap();
        let carried = pair.force() / (weight * above as f64);
        worst = worst.max((carried - Vec3::Z).length());
        let centre = (k + 1..=count as usize).map(|b| run.place(b)).sum::<Vec3>() / above as f64;
        let point = run.place(k) + pair.patches[0].memory.arms[0];
        aside = aside.max((point - centre).truncate().length());
    }
    println!("force off by {worst:.1e}, point by {aside:.1e} m");
    // What is left of the swaying after 15 times the time in which it falls to 1/e.
    assert!(worst < 1e-7, "{worst:e}");
    // Along its sides a contact is bevelled as far as it is deep, up to 1.2e-5 m, and presses there at an angle.
    assert!(aside < 5e-6, "{aside:e}");
}

/// Two bricks that have fallen onto the floor, beside each other.
#[test]
fn the_state_hash_covers_what_contacts_remember() {
    let blocks =
        vec![brick([0.0, 0.0, 1e-3], [1.0, 1.0, 1.0]), brick([1.05, 0.0, 1e-3], [1.0, 1.0, 1.0])];
    let mut run = Run::new(above_floor(blocks, 0.5, 0.1), 1, 1e-4);
    run.until(0.5);
    let pairs = &run.world.found.pairs;
    let touching = pairs.iter().position(|p| p.depth > 0.0).expect("lies on the floor");
    let apart = pairs.iter().position(|p| p.depth == 0.0).expect("are neighbours");
    let whole = run.world.hash();
    let change = |what: &str, f: &dyn Fn(&mut World)| {
        let mut other = run.world.clone();
        f(&mut other);
        assert_ne!(other.hash(), whole, "{what}");
    };
    let joint = Offset::new(Carried::default());
    change("springs", &|w| {
        w.found.pairs[touching].patches[0].memory.shear.x += 1.0;
    });
    change("arms", &|w| {
        w.found.pairs[touching].patches[0].memory.arms[1].z += 1e-3;
    });
    change("sliding", &|w| {
        let sliding = &mut w.found.pairs[touching].patches[0].memory.sliding;
        *sliding = !*sliding;
    });
    change("gap", &|w| w.found.pairs[apart].gap += 1e-3);
    change("in place", &|w| w.found.pairs[apart].seated = true);
    change("faces", &|w| w.found.pairs[apart].next = Some([7, 7]));
    change("offset", &|w| {
        w.found.pairs[touching].offset = Some(Box::new(joint));
    });
    change("longest step", &|w| w.found.longest_step = Some(1.0));
    change("search", &|w| w.found.search.pose[1].position.x += 1e-3);
    change("margin", &|w| w.found.search.margin[1] += 1e-3);
}

/// Walls have several times as many pairs as contacts: what each takes is bounded.
#[test]
fn pairs_take_little_memory() {
    // 80 until steps had levels: the clock of a pair is a pointer in each.
    assert!(size_of::<FoundPair>() <= 88, "{}", size_of::<FoundPair>());
    assert!(size_of::<Candidate>() <= 32, "{}", size_of::<Candidate>());
    let mut run = Run::new(above_floor(vec![brick([0.0, 0.0, 1e-4], [0.5; 3])], 0.5, 0.2), 1, 1e-4);
    run.until(0.1);
    let pair = run.world.found.pairs.iter().find(|pair| pair.depth > 0.0).expect("it has landed");
    assert_eq!((pair.patches.len(), pair.patches.capacity()), (1, 1));
}
