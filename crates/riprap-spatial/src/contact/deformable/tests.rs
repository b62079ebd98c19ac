//! Deformable blocks that meet: energy, momenta, rest, sliding, parting; threads and restart.

use std::f64::consts::PI;

use riprap_geom::height_field::HeightField;
use riprap_geom::polyhedron::{Polyhedron, hull};
use riprap_geom::{Quat, Vec3};

use crate::contact::tests::joint;
use crate::dynamics::damping::Damping;
use crate::exec::Exec;
use crate::query::view::View;
use crate::setup::deform::{BondFailure, BondLaw, BondSprings, DeformableSet, Deformables, Strain};
use crate::setup::{
    BlockName, BlockSpec, InterfaceLaw, Material, Motion, Setup, Shape, Solid, Strength, Support,
    Surface,
};
use crate::state::deform::Masses;
use crate::state::scratch::Scratch;
use crate::state::world::World;
use crate::step;

fn spec(shape: Shape) -> BlockSpec {
    BlockSpec {
        name: BlockName { base: 0, number: 0 },
        shape,
        material: 0,
        velocity: Vec3::ZERO,
        spin: Vec3::ZERO,
    }
}

fn brick(low: [f64; 3], size: [f64; 3]) -> BlockSpec {
    let half = 0.5 * Vec3::from_array(size);
    let centre = Vec3::from_array(low) + half;
    spec(Shape::Brick { centre, half })
}

/// A cube of a metre, turned.
fn cube(centre: Vec3, turn: Quat) -> BlockSpec {
    shaped(Polyhedron::brick(Vec3::ZERO, Vec3::splat(0.5)), centre, turn)
}

/// A solid, turned.
fn shaped(solid: Polyhedron, centre: Vec3, turn: Quat) -> BlockSpec {
    spec(Shape::Polyhedron(Box::new(Solid {
        vertices: solid.vertices.iter().map(|v| centre + turn * *v).collect(),
        faces: solid.faces,
    })))
}

/// Blocks of E = 100 MPa, nu = 0.25, those named deformable; contact stiffness 1e9 and 5e8 Pa/m; all bonds without strength.
fn model(blocks: Vec<BlockSpec>, deformable: &[u32], friction: f64, damping: f64) -> Setup {
    let mut setup = Setup {
        names: vec!["rock".into()],
        blocks,
        pair_table: vec![0],
        found_contacts: true,
        ..Setup::default()
    };
    setup.materials.push(Material {
        name: "rock".into(),
        density: 2500.0,
        young: Some(1e8),
        poisson: Some(0.25),
    });
    setup.interfaces.push(InterfaceLaw {
        name: "default".into(),
        bond: Some(BondLaw {
            springs: BondSprings::Thickness { thickness: 1e-3, moduli: Some([1e6, 5e5]) },
            strength: Some(Strength {
                tension: 0.0,
                cohesion: 0.0,
                friction,
                residual_friction: friction,
                ..Strength::default()
            }),
            cohesive: None,
            failure: BondFailure::Spring,
        }),
        friction: None,
        joint: joint(friction, damping),
    });
    setup.deform = Deformables {
        sets: vec![DeformableSet {
            blocks: deformable.to_vec(),
            strain: Strain::Large,
            displacement: [None, None, None],
            velocity: [None, None, None],
        }],
        ..Deformables::default()
    };
    for (k, block) in setup.blocks.iter_mut().enumerate() {
        block.name.number = k as u32 + 1;
    }
    setup
}

fn fixed(mut setup: Setup, blocks: &[u32]) -> Setup {
    setup.supports.push(Support {
        blocks: blocks.to_vec(),
        motion: Motion::Fixed { translation: [true; 3], rotation: [true; 3] },
    });
    setup
}

struct Run {
    world: World,
    scratch: Scratch,
    dt: f64,
}

impl Run {
    fn new(setup: Setup, threads: usize, dt: f64) -> Self {
        let (mut world, _) = World::new(setup, Exec::serial()).unwrap();
        if let Some(deform) = world.deform.as_deref_mut() {
            deform.masses = Masses::Inertia;
        }
        let scratch = Scratch::new(&mut world, Exec::new(threads).unwrap());
        Self { world, scratch, dt }
    }

    fn evaluate(&mut self) {
        let damping = Damping::default();
        step::evaluate(&mut self.world, &mut self.scratch, &damping, self.dt).unwrap();
    }

    fn until(&mut self, time: f64) {
        self.watch(time, |_| {});
    }

    fn watch(&mut self, time: f64, mut look: impl FnMut(&Self)) {
        self.evaluate();
        while self.world.time < time - 0.5 * self.dt {
            if self.world.start_energy.is_none() {
                self.world.start_energy = Some(self.view().balance().total());
            }
            step::advance(&mut self.world, &mut self.scratch, self.dt);
            self.evaluate();
            look(self);
        }
    }

    fn view(&self) -> View<'_> {
        View { world: &self.world, scratch: &self.scratch }
    }

    fn residual(&self) -> f64 {
        self.view().balance().residual_relative()
    }
}

/// Two deformable blocks that come together at 10 m/s: largest error of the energy over the energy, and drift of the momenta.
fn collision(mut blocks: Vec<BlockSpec>, dt: f64) -> [f64; 3] {
    blocks[0].velocity = Vec3::new(0.0, 0.0, 5.0);
    blocks[1].velocity = Vec3::new(0.0, 0.0, -5.0);
    let mut run = Run::new(model(blocks, &[0, 1], 0.0, 0.0), 1, dt);
    run.evaluate();
    let start = run.view().kinetic_energy();
    let spin = |run: &Run| run.view().angular_momentum();
    let (before, momentum) = (spin(&run), run.view().momentum());
    let (mut worst, mut pressed, mut turned) = (0.0_f64, 0.0_f64, 0.0_f64);
    let (mut drift, mut parted) = (0.0_f64, false);
    run.watch(0.16, |run| {
        let mut pairs = run.world.found.deformable.pairs.iter();
        parted |= pressed > 0.1 && pairs.all(|pair| pair.depth == 0.0);
        let balance = run.view().balance();
        worst = worst.max((balance.residual() / start).abs());
        pressed = pressed.max(balance.contact_normal / start);
        let change = run.view().momentum() - momentum;
        drift = drift.max(change.length() / (2500.0 * 10.0));
        turned = turned.max((spin(run) - before).length() / (2500.0 * 10.0));
    });
    // They have touched and come apart; a needle that turns may strike once more.
    assert!(pressed > 0.1 && parted, "{pressed}");
    [worst, drift, turned]
}

#[test]
fn elastic_collisions_keep_energy_and_momenta() {
    let turns = [
        Quat::from_rotation_arc(Vec3::ONE.normalize(), -Vec3::Z),
        Quat::from_rotation_x(0.9),
        Quat::from_scaled_axis(Vec3::new(0.3, -0.7, 0.5)),
    ];
    for turn in turns {
        let blocks =
            || vec![cube(Vec3::ZERO, Quat::IDENTITY), cube(Vec3::new(0.15, 0.2, 1.45), turn)];
        let found = [4e-5, 2e-5].map(|dt| collision(blocks(), dt));
        println!("{found:?}");
        let [[worst, drift, spin], [finer, ..]] = found;
        assert!(worst < 1e-5, "{worst:e}");
        assert!((worst / finer - 4.0).abs() < 0.6, "{worst:e} {finer:e}");
        assert!(drift < 1e-13, "{drift:e}");
        assert!(spin < 1e-12, "{spin:e}");
    }
}

/// The same for blocks whose cells are not their own tetrahedra: a long brick on a slab, a needle on its edge, a cell with many faces.
#[test]
fn blocks_of_any_shape_keep_energy_and_momenta() {
    let needle = [[0.0, 0.0, -0.5], [0.5, 0.1, 0.0], [-0.3, 0.4, 0.1], [0.0, 0.1, 2.0]];
    let cell = (0..14).map(|k| {
        let (height, turn) = (1.0 - (f64::from(k) + 0.5) / 7.0, 2.4 * f64::from(k));
        let (sine, cosine) = libm::sincos(turn);
        let round = libm::sqrt(1.0 - height * height);
        0.6 * Vec3::new(round * cosine, round * sine, height)
    });
    let cell = hull(&cell.collect::<Vec<_>>()).unwrap();
    let needle = hull(&needle.map(Vec3::from_array)).unwrap();
    let long = Polyhedron::brick(Vec3::ZERO, Vec3::new(0.3, 0.3, 1.2));
    let slab = Polyhedron::brick(Vec3::ZERO, Vec3::new(0.8, 1.0, 0.25));
    let turn = Quat::from_scaled_axis(Vec3::new(0.3, -0.2, 0.5));
    for (lower, upper, height) in [(&slab, &long, 1.7), (&cell, &needle, 1.4), (&long, &cell, 2.0)]
    {
        let blocks = || {
            vec![
                shaped(lower.clone(), Vec3::ZERO, Quat::IDENTITY),
                shaped(upper.clone(), Vec3::new(0.05, 0.1, height), turn),
            ]
        };
        let found = [2e-5, 1e-5].map(|dt| collision(blocks(), dt));
        println!("{found:?}");
        let [[worst, drift, spin], [finer, ..]] = found;
        assert!(worst < 1e-4, "{worst:e}");
        assert!((worst / finer - 4.0).abs() < 1.0, "{worst:e} {finer:e}");
        assert!(drift < 1e-13, "{drift:e}");
        assert!(spin < 1e-12, "{spin:e}");
    }
}

#[test]
fn a_cube_comes_to_rest_with_its_weight_on_a_rigid_floor() {
    let blocks =
        vec![brick([-2.0, -2.0, -0.5], [4.0, 4.0, 0.5]), brick([-0.1, 0.15, 0.02], [0.5; 3])];
    let mut setup = fixed(model(blocks, &[1], 0.5, 0.3), &[0]);
    setup.gravity = Vec3::new(0.0, 0.0, -9.81);
    let mut run = Run::new(setup, 1, 5e-5);
    let mut deepest = 0.0_f64;
    run.watch(1.0, |run| {
        for pair in &run.world.found.deformable.pairs {
            deepest = deepest.max(pair.depth);
        }
    });
    assert!(deepest > 1e-5, "it has landed: {deepest}");
    let weight = 2500.0 * 0.125 * 9.81;
    // The block itself swings on with nothing to damp it: mean over a while.
    let (mut sum, mut count) = (0.0, 0);
    run.watch(1.3, |run| {
        sum += run.world.found.deformable.pairs[0].force.z;
        count += 1;
    });
    let mean = sum / f64::from(count);
    assert!((mean / weight - 1.0).abs() < 0.02, "{mean} {weight}");
    let height = run.view().position(1).z;
    assert!((height - 0.25).abs() < 3e-4, "{height}");
    assert!(run.residual().abs() < 5e-4, "{:e}", run.residual());
    assert!(run.world.works.damping > 0.0);
}

/// A cube that lies on another one, joined without strength, slides off its edge and falls.
#[test]
fn a_cube_that_slides_off_another_one_falls() {
    let mut blocks = vec![brick([0.0, 0.0, 0.0], [0.5; 3]), brick([0.0, 0.0, 0.5], [0.5; 3])];
    blocks[1].velocity = Vec3::new(4.0, 0.0, 0.0);
    let mut setup = fixed(model(blocks, &[0, 1], 0.1, 0.0), &[0]);
    setup.gravity = Vec3::new(0.0, 0.0, -9.81);
    let mut run = Run::new(setup, 1, 5e-5);
    let mut highest = 0.0_f64;
    run.watch(0.1, |run| {
        highest = highest.max(run.view().displacement(1).z);
    });
    let deform = run.world.deform.as_deref().unwrap();
    assert!(deform.facets.iter().all(|f| f.parted));
    assert!(highest < 2e-3, "{highest}");
    run.until(0.6);
    let moved = run.view().displacement(1);
    assert!(moved.z < -0.3, "{moved}");
    assert!(moved.x > 1.5, "{moved}");
    assert!(run.residual().abs() < 1e-3, "{:e}", run.residual());
}

#[test]
fn friction_stops_a_cube_that_slides_on_a_rigid_floor_and_on_terrain() {
    for floor in [brick([-1.0, -1.0, -0.5], [4.0, 2.0, 0.5]), ground(|_, _| 0.0)] {
        let mut block = brick([-0.5, -0.2, 0.0], [0.4, 0.4, 0.2]);
        block.velocity = Vec3::new(2.0, 0.0, 0.0);
        let mut setup = fixed(model(vec![floor, block], &[1], 0.5, 0.1), &[0]);
        setup.gravity = Vec3::new(0.0, 0.0, -9.81);
        let mut run = Run::new(setup, 1, 5e-5);
        run.until(0.6);
        let way = run.view().displacement(1).x;
        let wanted = 4.0 / (2.0 * 0.5 * 9.81);
        assert!((way / wanted - 1.0).abs() < 0.03, "{way} {wanted}");
        assert!(run.residual().abs() < 2e-3, "{:e}", run.residual());
    }
}

/// Layers of cubes on a floor: the same bits with threads, and after a restart in the middle.
/// Cohesion of broken bonds holds what meets anew, by its area: a cube of half a metre that slides with 3 m/s without friction is slowed by
/// `c A/m`, which was missing.
#[test]
fn residual_cohesion_of_bonds_holds_what_meets_anew() {
    let way = |cohesion: f64| {
        let mut cube = brick([-0.25, -0.25, 0.0], [0.5; 3]);
        cube.velocity = Vec3::new(3.0, 0.0, 0.0);
        let floor = brick([-4.0, -4.0, -1.0], [8.0, 8.0, 1.0]);
        let mut setup = fixed(model(vec![floor, cube], &[1], 0.0, 0.5), &[0]);
        let bond = setup.interfaces[0].bond.as_mut().unwrap();
        bond.strength.as_mut().unwrap().residual_cohesion = cohesion;
        setup.gravity = Vec3::new(0.0, 0.0, -10.0);
        let mut run = Run::new(setup, 1, 1e-4);
        run.until(0.1);
        run.view().position(1).x
    };
    let (smooth, held) = (way(0.0), way(4e3));
    // 4 kPa on a quarter of a square metre, 312.5 kg: 3.2 m/s².
    assert!((smooth - 0.3).abs() < 1e-3, "{smooth}");
    assert!((held - (0.3 - 0.5 * 3.2 * 0.01)).abs() < 2e-3, "{held}");
}

#[test]
fn threads_and_restart_change_no_bit() {
    let setup = || {
        let mut blocks = vec![brick([-3.0, -3.0, -0.5], [6.0, 6.0, 0.5])];
        for k in 0..160_u32 {
            let at = |p: u32| f64::from(p);
            let (x, y, z) = (at(k % 8), at(k / 8 % 8), at(k / 64));
            let low = [0.45 * x - 2.0 + 0.02 * z, 0.45 * y - 2.0, 0.001 + 0.302 * z];
            let mut block = brick(low, [0.4, 0.3, 0.3]);
            block.spin = Vec3::new(0.3 * y, -0.2 * x, 0.1 * z);
            blocks.push(block);
        }
        let deformable: Vec<u32> = (1..161).filter(|b| b % 5 != 0).collect();
        let mut setup = fixed(model(blocks, &deformable, 0.5, 0.2), &[0]);
        setup.gravity = Vec3::new(0.0, 0.0, -9.81);
        setup
    };
    let mut one = Run::new(setup(), 1, 1e-4);
    one.until(0.03);
    let world = one.world.clone();
    one.until(0.045);
    let touching = one.world.found.deformable.pairs.iter().filter(|p| p.depth > 0.0);
    assert!(touching.count() > 30);
    let mut two = Run::new(setup(), 2, 1e-4);
    two.until(0.045);
    assert!(one.world.hash() == two.world.hash(), "threads change bits");
    let mut world = world;
    let scratch = Scratch::new(&mut world, Exec::serial());
    let mut again = Run { world, scratch, dt: 1e-4 };
    again.until(0.045);
    assert!(one.world.hash() == again.world.hash(), "a restart changes bits");
    assert_eq!(one.world.works, again.world.works);
}

/// Bricks that are whole and joined find nothing, and keep nothing.
#[test]
fn a_whole_lattice_has_no_pairs() {
    let blocks = (0..8).map(|k| {
        let at = |bit: u32| f64::from(k >> bit & 1) * 0.5;
        brick([at(0), at(1), at(2)], [0.5; 3])
    });
    let mut setup = model(blocks.collect(), &[0, 1, 2, 3, 4, 5, 6, 7], 0.5, 0.0);
    if let Some(law) = &mut setup.interfaces[0].bond {
        law.strength = None;
    }
    let mut run = Run::new(setup, 1, 1e-5);
    run.until(1e-3);
    assert!(run.world.found.deformable.pairs.is_empty());
    assert!(run.world.found.deformable.search.displacement.is_empty());
}

/// A square of 8 m with heights every half a metre.
fn ground(height: impl Fn(f64, f64) -> f64) -> BlockSpec {
    let line: Vec<f64> = (0..=16).map(|k| 0.5 * f64::from(k) - 4.0).collect();
    let field = HeightField::grid(&line, &line, |i, j| Some(height(line[i], line[j]))).unwrap();
    spec(Shape::Terrain(Box::new(Surface { points: field.points, triangles: field.triangles })))
}

/// A cube that falls askew and spins: on terrain as on a floor of one brick. (Springs along a contact act at the centres of its pieces, of which there are
/// more on terrain: with friction the two are not equal bit by bit.)
#[test]
fn a_flat_terrain_is_a_floor() {
    let run = |floor: BlockSpec| {
        let mut falling = cube(Vec3::new(-0.4, 0.1, 0.7), Quat::from_rotation_x(0.2));
        falling.velocity = Vec3::new(1.5, 0.3, -3.0);
        falling.spin = Vec3::new(0.0, 0.5, 2.0);
        let mut setup = fixed(model(vec![floor, falling], &[1], 0.0, 0.0), &[0]);
        setup.gravity = Vec3::new(0.0, 0.0, -9.81);
        let mut run = Run::new(setup, 1, 4e-5);
        run.until(0.15);
        run
    };
    // As high as the cube, which terrain is taken for where stiffness follows from depth.
    let floor = run(brick([-4.0, -4.0, -1.0], [8.0, 8.0, 1.0]));
    let terrain = run(ground(|_, _| 0.0));
    let [v, w] = [&floor, &terrain].map(|run| run.view().velocity(1));
    assert!((v - w).length() < 1e-8 && v.z > 0.0, "{v} {w}");
}

/// In a notch both flanks resist, each with its own pressure: with a half angle of 45 degrees a cube that slides along it is stopped by sqrt 2
/// times the friction of a floor.
#[test]
fn both_flanks_of_a_notch_resist_a_deformable_cube() {
    let height = 0.5_f64.sqrt();
    let mut block = cube(Vec3::new(0.0, -0.7, height), Quat::from_rotation_y(0.25 * PI));
    block.velocity = Vec3::new(0.0, 2.0, 0.0);
    let mut setup = model(vec![ground(|x, _| x.abs()), block], &[1], 0.5, 0.3);
    setup.gravity = Vec3::new(0.0, 0.0, -9.81);
    let mut run = Run::new(setup, 1, 1e-4);
    let weight = 2500.0 * 9.81;
    let (mut sum, mut count) = ([0.0; 2], 0.0);
    run.watch(0.5, |run| {
        let contacts: Vec<f64> = run.view().contacts().map(|c| c.force.dot(c.normal)).collect();
        if run.world.time > 0.1 {
            assert_eq!(contacts.len(), 2);
            sum = [0, 1].map(|k| sum[k] + contacts[k] / weight);
            count += 1.0;
        }
    });
    for pressure in sum.map(|sum| sum / count) {
        assert!((pressure / height - 1.0).abs() < 0.01, "{pressure}");
    }
    let way = run.view().displacement(1).y;
    let wanted = 4.0 / (2.0 * 0.5 * 2.0_f64.sqrt() * 9.81);
    assert!((way / wanted - 1.0).abs() < 0.03, "{way} {wanted}");
    assert!(run.residual().abs() < 2e-3, "{:e}", run.residual());
}

/// Triangles in one plane are one facet: a cube on a slope across many of them has one contact, and slides as on an inclined plane.
#[test]
fn a_slope_of_many_triangles_is_one_facet() {
    let turn = Quat::from_rotation_y(libm::atan(0.5));
    let block = cube(turn * Vec3::new(0.1, 0.15, 0.5), turn);
    let mut setup = model(vec![ground(|x, _| -0.5 * x), block], &[1], 0.25, 0.3);
    setup.gravity = Vec3::new(0.0, 0.0, -9.81);
    let mut run = Run::new(setup, 1, 1e-4);
    run.watch(0.4, |run| assert!(run.view().contacts().count() <= 1));
    let moved = run.view().displacement(1);
    let along = moved.dot(turn * Vec3::X);
    let wanted = 0.5 * 0.16 * 9.81 * (0.5 - 0.25) / 1.25_f64.sqrt();
    assert!((along / wanted - 1.0).abs() < 0.01, "{along} {wanted}");
    assert!(run.residual().abs() < 2e-3, "{:e}", run.residual());
}

fn on_hills(friction: f64, damping: f64) -> Setup {
    let hills = |x: f64, y: f64| 0.2 * libm::sin(2.0 * x) * libm::cos(1.7 * y);
    let mut blocks = vec![ground(hills)];
    for k in 0..9_u32 {
        let [x, y] = [k % 3, k / 3].map(|p| 1.6 * f64::from(p) - 1.6);
        let turn = Quat::from_scaled_axis(Vec3::new(0.3 + x, -0.7 * y, 0.5));
        let mut block = cube(Vec3::new(x, y, hills(x, y) + 1.0), turn);
        block.velocity = Vec3::new(0.3, 0.0, -5.0);
        blocks.push(block);
    }
    // One is rigid.
    let mut setup = model(blocks, &[1, 2, 3, 4, 6, 7, 8, 9], friction, damping);
    setup.gravity = Vec3::new(0.0, 0.0, -9.81);
    setup
}

/// Without friction and dashpots cubes keep their energy on rough ground: the error is of second order in the step.
#[test]
fn bounces_on_rough_ground_keep_energy() {
    let worst = |dt: f64| {
        let mut run = Run::new(on_hills(0.0, 0.0), 1, dt);
        run.evaluate();
        let start = run.view().kinetic_energy();
        let (mut worst, mut pressed) = (0.0_f64, 0.0_f64);
        run.watch(0.15, |run| {
            let balance = run.view().balance();
            worst = worst.max((balance.residual() / start).abs());
            pressed = pressed.max(balance.contact_normal / start);
        });
        assert!(pressed > 0.1, "{pressed}");
        worst
    };
    let [coarse, fine] = [8e-5, 4e-5].map(worst);
    assert!(coarse < 1e-4, "{coarse:e}");
    assert!((coarse / fine - 4.0).abs() < 1.0, "{coarse:e} {fine:e}");
}

#[test]
fn threads_and_restart_change_no_bit_on_terrain() {
    let setup = || on_hills(0.5, 0.1);
    let mut one = Run::new(setup(), 1, 8e-5);
    one.until(0.06);
    let world = one.world.clone();
    one.until(0.1);
    let pairs = one.world.found.deformable.pairs.iter();
    assert!(pairs.filter(|p| p.depth > 0.0).count() > 3);
    let mut two = Run::new(setup(), 2, 8e-5);
    two.until(0.1);
    assert!(one.world.hash() == two.world.hash(), "threads change bits");
    let mut world = world;
    let scratch = Scratch::new(&mut world, Exec::serial());
    let dt = 8e-5;
    let mut again = Run { world, scratch, dt };
    again.until(0.1);
    assert!(one.world.hash() == again.world.hash(), "a restart changes bits");
}

/// A block that comes from outside, half of it below the surface, meets the side of the terrain and goes back: no energy is made.
#[test]
fn the_side_of_terrain_is_a_wall() {
    let mut block = cube(Vec3::new(-5.0, 0.3, -0.1), Quat::from_rotation_x(0.3));
    block.velocity = Vec3::new(5.0, 0.4, 0.0);
    let mut run = Run::new(model(vec![ground(|_, _| 0.0), block], &[1], 0.0, 0.0), 1, 2e-5);
    run.evaluate();
    let start = run.view().kinetic_energy();
    let (mut worst, mut deepest) = (0.0_f64, 0.0_f64);
    run.watch(0.25, |run| {
        worst = worst.max((run.view().balance().residual() / start).abs());
        let pairs = run.world.found.deformable.pairs.iter();
        deepest = pairs.map(|p| p.depth).fold(deepest, f64::max);
    });
    assert!(deepest > 1e-3, "it has met the wall: {deepest}");
    assert!(worst < 1e-3, "{worst:e}");
    let velocity = run.view().velocity(1);
    assert!(velocity.x < 0.0, "{velocity}");
}

/// What a block that is wholly below the surface presses with nobody can say.
#[test]
fn a_cube_below_the_surface_stops_the_run() {
    let below = cube(Vec3::new(0.1, 0.2, -2.0), Quat::IDENTITY);
    let mut run = Run::new(model(vec![ground(|_, _| 0.0), below], &[1], 0.5, 0.1), 1, 1e-5);
    run.evaluate();
    let worst = run.view().worst_overlap();
    assert_eq!(worst, Some((f64::INFINITY, 0, 1)));
}
