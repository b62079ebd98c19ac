//! Splitting at any attitude: a lattice turned as a whole with all that acts on it splits as the one along the axes does, and
//! lattices of leaning blocks split with the same books.

use riprap::Vec3;
use riprap::geom::Mat3;
use riprap::geom::polyhedron::Polyhedron;
use riprap::spatial::setup::{
    Boundary, BoundaryKind, CavityPressure, Coupling, Criterion, During, FaceSet, InSitu,
    Kinematics, Place, Refinement, Region, Setup, Shape, Solid, Source, Venting,
};
use riprap::spatial::step::advance;
use riprap::spatial::topology;
use riprap::spatial::topology::EditKind;

use crate::spatial::blast::AMMONIUM;
use crate::spatial::rock::{CP, Draws, Run, elastic, lattice, rock, strength};

const DT: f64 = 0.1 * 0.6325 * 0.25 / CP;
/// Displacements of a turned lattice differ by less than this share of the largest: places of joints are rounded to 1e-11 of a block, which
/// is 1e-8 of what blocks move here.
const SAME: f64 = 1e-8;

/// No axis of the lattice stays near an axis of space.
fn turn() -> Mat3 {
    Mat3::from_axis_angle(Vec3::new(0.48, -0.6, 0.64), 0.83)
}

/// The blocks of a lattice as polyhedra under a linear map.
fn mapped(setup: &mut Setup, map: Mat3) {
    for block in &mut setup.blocks {
        let Shape::Brick { centre, half } = block.shape else {
            unreachable!("the lattice is made of bricks");
        };
        let mut solid = Polyhedron::brick(centre, half);
        solid.vertices.iter_mut().for_each(|v| *v = map * *v);
        block.shape =
            Shape::Polyhedron(Box::new(Solid { vertices: solid.vertices, faces: solid.faces }));
    }
}

/// A model turned about the origin with all that acts on it.
fn turned(setup: &Setup, by: Mat3) -> Setup {
    let mut setup = setup.clone();
    mapped(&mut setup, by);
    setup.gravity = by * setup.gravity;
    for block in &mut setup.blocks {
        block.velocity = by * block.velocity;
        block.spin = by * block.spin;
    }
    if let Some(in_situ) = &mut setup.in_situ {
        let s = by * in_situ.at(0.0) * by.transpose();
        in_situ.stress = [s.x_axis.x, s.y_axis.y, s.z_axis.z, s.y_axis.z, s.z_axis.x, s.x_axis.y];
    }
    for boundary in &mut setup.boundaries {
        let FaceSet::Plane { normal, .. } = &mut boundary.on else {
            unreachable!("boundaries of these models lie on planes");
        };
        *normal = by * *normal;
    }
    for source in &mut setup.sources {
        match &mut source.place {
            Place::Point { centre } => *centre = by * *centre,
            Place::Line { from, to } => (*from, *to) = (by * *from, by * *to),
            Place::Blocks { .. } => {}
        }
    }
    for refinement in &mut setup.refinements {
        refinement.around = match refinement.around {
            Region::Point(p) => Region::Point(by * p),
            Region::Line(a, b) => Region::Line(by * a, by * b),
            Region::Plane(p, n) => Region::Plane(by * p, by * n),
            Region::Ball(p, radius) => Region::Ball(by * p, radius),
            Region::Box(..) => unreachable!("boxes cannot be turned"),
            Region::All => Region::All,
        };
    }
    setup
}

fn around(place: Region, levels: u8) -> Refinement {
    Refinement { around: place, levels, during: None }
}

/// Both runs have the same blocks, in place and in motion; returns the largest difference, over the largest displacement.
fn compare(straight: &Run, leaning: &Run, by: Mat3) -> f64 {
    assert_eq!(straight.world.lineage, leaning.world.lineage);
    assert_eq!(straight.world.alive, leaning.world.alive);
    assert_eq!(straight.world.patches.len(), leaning.world.patches.len());
    let (a, b) = (straight.view(), leaning.view());
    let (mut largest, mut worst) = (0.0_f64, 0.0_f64);
    for k in 0..straight.world.alive.len() {
        let apart = by * straight.world.reference[k] - leaning.world.reference[k];
        assert!(apart.length() < 1e-13, "{k}: {apart}");
        let [one, two] = [&straight, &leaning].map(|run| run.world.solid_of(k));
        assert!((one.mass / two.mass - 1.0).abs() < 1e-12);
        let inertia = by * one.inertia * by.transpose() - two.inertia;
        let off = inertia.to_cols_array().map(f64::abs).into_iter();
        assert!(off.fold(0.0, f64::max) < 1e-12 * one.inertia.x_axis.x);
        if straight.world.alive[k] {
            largest = largest.max(a.displacement(k).length());
            worst = worst.max((by * a.displacement(k) - b.displacement(k)).length());
        }
    }
    worst / largest.max(f64::MIN_POSITIVE)
}

/// The surface of every living block is covered by what meets it, so that nothing overlaps or gapes; volumes add up to `volume`.
fn covered(run: &Run, volume: f64) {
    let world = &run.world;
    let mut area = vec![0.0; world.alive.len()];
    for (ends, class) in world.patches.ends.iter().zip(&world.patches.class) {
        for &b in ends {
            area[b as usize] += world.classes[*class as usize].area;
        }
    }
    for face in &world.faces {
        area[face.block as usize] += face.area;
    }
    for wall in world.cavities.iter().flat_map(|c| &c.walls) {
        area[wall.block as usize] += wall.area;
    }
    let mut sum = 0.0;
    for b in run.view().living() {
        let Shape::Polyhedron(solid) = &world.setup.blocks[b].shape else {
            unreachable!("all blocks lean");
        };
        let solid = Polyhedron { vertices: solid.vertices.clone(), faces: solid.faces.clone() };
        let faces = (0..solid.faces.len()).map(|f| solid.area_vector(f).length());
        let whole: f64 = faces.sum();
        assert!((area[b] / whole - 1.0).abs() < 1e-9, "{b}: {} {whole}", area[b]);
        sum += solid.moments().volume;
    }
    assert!((sum / volume - 1.0).abs() < 1e-12, "{sum} {volume}");
}

/// Largest difference of levels of blocks that share a patch.
fn worst_step(run: &Run) -> u8 {
    let level = |b: u32| run.world.lineage[b as usize].level;
    let ends = run.world.patches.ends.iter();
    ends.map(|[i, j]| level(*i).abs_diff(level(*j))).max().unwrap_or(0)
}

#[test]
fn before_a_run_a_turned_lattice_splits_as_the_straight_one() {
    for (place, levels) in [
        (Region::Point(Vec3::splat(3.0)), 4),
        (Region::Point(Vec3::splat(3.01)), 4),
        (Region::Line(Vec3::new(1.2, 1.1, 0.0), Vec3::new(4.7, 1.1, 3.0)), 3),
        (Region::Plane(Vec3::new(0.0, 0.0, 3.0), Vec3::Z), 2),
        (Region::Ball(Vec3::new(3.1, 2.0, 3.2), 1.3), 2),
        (Region::All, 1),
    ] {
        let mut setup = rock(lattice([6, 6, 6], 1.0), elastic());
        setup.refinements.push(around(place, levels));
        let by = turn();
        let (straight, leaning) = (Run::new(setup.clone()), Run::new(turned(&setup, by)));
        compare(&straight, &leaning, by);
        covered(&leaning, 216.0);
        let everywhere = matches!(setup.refinements[0].around, Region::All);
        assert_eq!(worst_step(&leaning), u8::from(!everywhere));
    }
}

/// A lattice with random motion whose blocks split where the stress passes a limit.
fn shaken(kinematics: Kinematics) -> Setup {
    let mut setup = Setup { kinematics, ..rock(lattice([4, 3, 3], 1.0), elastic()) };
    let mut draws = Draws::new(11);
    for block in &mut setup.blocks {
        block.velocity = draws.vector();
        block.spin = 0.5 * draws.vector();
    }
    setup.refinements.push(Refinement {
        around: Region::All,
        levels: 2,
        during: Some(During { criterion: Criterion::Stress, above: 3e6, every: 10 }),
    });
    setup
}

fn run_on(run: &mut Run, steps: usize, dt: f64) {
    for _ in 0..steps {
        run.evaluate(dt);
        topology::refine_running(&mut run.world, &mut run.scratch, dt).expect("exact edits");
        advance(&mut run.world, &mut run.scratch, dt);
    }
    run.evaluate(dt);
}

/// Steps and blocks of all splits.
fn splits(run: &Run) -> Vec<(u64, u32)> {
    let events = run.world.events.iter();
    let splits = events.filter(|e| e.kind == EditKind::Split);
    splits.map(|e| (e.step, e.subject)).collect()
}

#[test]
fn during_a_run_a_turned_lattice_splits_at_the_same_instants() {
    for kinematics in [Kinematics::Small, Kinematics::Finite] {
        for strong in [true, false] {
            let mut setup = shaken(kinematics);
            if !strong {
                setup.interfaces[0].joint.strength = Some(strength(2e6, 35.0, 1e6));
            }
            let by = turn();
            let (mut straight, mut leaning) =
                (Run::new(setup.clone()), Run::new(turned(&setup, by)));
            run_on(&mut straight, 120, DT);
            run_on(&mut leaning, 120, DT);
            assert!(splits(&straight).len() > 100, "{}", splits(&straight).len());
            assert_eq!(splits(&straight), splits(&leaning));
            let worst = compare(&straight, &leaning, by);
            let (a, b) = (straight.balance(), leaning.balance());
            println!(
                "{kinematics:?}, joints that break {}: {} splits, largest difference {worst:.1e}, edit defect {:.6e} {:.6e} J",
                !strong,
                splits(&straight).len(),
                a.works.edit_defect,
                b.works.edit_defect
            );
            assert!(worst < SAME, "{worst:e}");
            assert!((a.works.edit_defect - b.works.edit_defect).abs() < 1e-9 * a.total());
            assert!((a.total() / b.total() - 1.0).abs() < 1e-9);
        }
    }
}

/// A charge in a lattice under stress, between viscous and held sides: split around it before the run, and where it is broken later.
fn charged() -> Setup {
    let joint = riprap::spatial::setup::JointLaw {
        strength: Some(strength(1e6, 35.0, 0.5e6)),
        ..elastic()
    };
    let mut setup = rock(lattice([4, 4, 4], 1.0), joint);
    setup.in_situ = Some(InSitu {
        stress: [-3e6, -2e6, -1e6, 0.2e6, 0.1e6, -0.3e6],
        gradient: [0.0; 6],
        datum: 0.0,
    });
    for (normal, offset, kind) in [
        (-Vec3::Z, 0.0, BoundaryKind::Held { normal: true, shear: true }),
        (-Vec3::X, 0.0, BoundaryKind::Viscous { half_cell: true }),
        (Vec3::X, 4.0, BoundaryKind::Viscous { half_cell: true }),
        (-Vec3::Y, 0.0, BoundaryKind::Viscous { half_cell: false }),
        (Vec3::Y, 4.0, BoundaryKind::Viscous { half_cell: true }),
    ] {
        setup.boundaries.push(Boundary {
            name: "side".into(),
            on: FaceSet::Plane { normal, offset },
            kind,
            in_situ: true,
        });
    }
    setup.gravity = Vec3::new(0.0, 0.0, -9.81);
    let middle = Vec3::new(2.0, 2.0, 2.0);
    setup.refinements.push(around(Region::Point(middle), 2));
    setup.refinements.push(Refinement {
        around: Region::All,
        levels: 2,
        during: Some(During { criterion: Criterion::Broken, above: 0.3, every: 7 }),
    });
    setup.sources.push(Source {
        name: "charge".into(),
        place: Place::Point { centre: middle },
        delay: 0.0,
        hole: Default::default(),
        push: CavityPressure::Gas {
            explosive: AMMONIUM.into(),
            mass: 1.0,
            coupling: Coupling::Scaled { exponent: 0.667 },
            venting: Some(Venting::Heave { height: 1e-3 }),
        },
    });
    setup
}

#[test]
fn a_charge_in_a_turned_lattice_does_the_same() {
    let (setup, by) = (charged(), turn());
    let (mut straight, mut leaning) = (Run::new(setup.clone()), Run::new(turned(&setup, by)));
    let dt = 1.5e-6;
    for run in [&mut straight, &mut leaning] {
        run_on(run, 150, dt);
    }
    let cavities = [&straight, &leaning].map(|run| run.world.cavities[0].clone());
    let [one, two] = &cavities;
    assert_eq!(one.blocks, two.blocks);
    assert_eq!(one.walls.len(), two.walls.len());
    assert_eq!(one.above, two.above);
    assert!(splits(&straight).len() > 40, "{}", splits(&straight).len());
    assert_eq!(splits(&straight), splits(&leaning));
    let worst = compare(&straight, &leaning, by);
    println!(
        "{} splits, gas {:.6e} {:.6e} Pa, largest difference {worst:.1e}",
        splits(&straight).len(),
        one.pressure,
        two.pressure
    );
    assert!((one.pressure / two.pressure - 1.0).abs() < 1e-9);
    assert!(worst < SAME, "{worst:e}");
    covered(&leaning, 64.0 - one.removed);
}

/// Blocks of three sets of joints that are not at right angles.
fn leaning(cells: [usize; 3]) -> Setup {
    let mut setup = rock(lattice(cells, 1.0), elastic());
    mapped(
        &mut setup,
        Mat3::from_cols(
            Vec3::new(0.9, 0.2, -0.1),
            Vec3::new(-0.3, 1.1, 0.25),
            Vec3::new(0.35, -0.2, 0.8),
        ),
    );
    setup
}

#[test]
fn leaning_blocks_split_with_the_books_of_bricks() {
    for kinematics in [Kinematics::Small, Kinematics::Finite] {
        let mut setup = leaning([4, 3, 3]);
        setup.kinematics = kinematics;
        let mut draws = Draws::new(5);
        for block in &mut setup.blocks {
            block.velocity = 0.5 * draws.vector();
            block.spin = 0.5 * draws.vector();
        }
        let mut run = Run::new(setup);
        let volume: f64 = run.view().living().map(|b| run.world.solid_of(b).volume).sum();
        run.steps(40, DT);
        let (p, l, residual, stored) = {
            let view = run.view();
            let balance = view.balance();
            let stored = balance.contact_normal + balance.contact_shear;
            (view.momentum(), view.angular_momentum(), balance.residual(), stored)
        };
        let before = run.world.patches.len();
        // A block inside, its neighbour, a block at a corner, and a child of the first.
        topology::split(&mut run.world, &mut run.scratch, &[17, 18, 0, 36 + 5], DT)
            .expect("the split is exact");
        assert!(run.world.patches.len() > before + 48);
        covered(&run, volume);
        let view = run.view();
        let scale = 0.5 * 2400.0 * volume;
        assert!((view.momentum() - p).length() < 1e-13 * scale);
        let spun = (view.angular_momentum() - l).length() / (4.0 * scale);
        assert!(spun < 1e-12, "{spun:e}");
        let after = view.balance();
        let share = after.works.edit_defect / stored;
        println!("{kinematics:?}: edit defect / stored {share:.3}");
        assert!((after.residual() - residual).abs() < 1e-9 * after.total());
        assert!(share.abs() < 1.0);
        let total = run.beginning(DT);
        run.steps(400, DT);
        let view = run.view();
        assert!((view.momentum() - p).length() < 1e-12 * scale);
        let spun = (view.angular_momentum() - l).length() / (4.0 * scale);
        assert!(spun < 1e-11, "{spun:e}");
        let drift = view.balance().total() / total - 1.0;
        assert!(drift.abs() < 1e-4, "{kinematics:?}: {drift:e}");
    }
}

/// Uniform stress: the parts are in equilibrium as the wholes were, so nothing moves.
#[test]
fn leaning_blocks_under_uniform_stress_split_in_equilibrium() {
    let mut setup = leaning([3, 3, 3]);
    setup.interfaces[0].joint.strength = Some(strength(5e6, 30.0, 1e6));
    setup.in_situ = Some(InSitu {
        stress: [-3e6, -2e6, -1e6, 0.2e6, 0.1e6, -0.3e6],
        gradient: [0.0; 6],
        datum: 0.0,
    });
    let Shape::Polyhedron(corner) = &setup.blocks[0].shape else {
        unreachable!("all blocks lean");
    };
    let Shape::Polyhedron(far) = &setup.blocks[26].shape else {
        unreachable!("all blocks lean");
    };
    let sides = [corner, far]
        .map(|solid| Polyhedron { vertices: solid.vertices.clone(), faces: solid.faces.clone() });
    for (solid, first) in sides.iter().zip([0, 1]) {
        for face in [first, first + 2, first + 4] {
            let (normal, offset) = solid.plane(face);
            setup.boundaries.push(Boundary {
                name: "side".into(),
                on: FaceSet::Plane { normal, offset },
                kind: BoundaryKind::Held { normal: true, shear: true },
                in_situ: true,
            });
        }
    }
    let mut run = Run::new(setup);
    run.steps(3, DT);
    let moved = |run: &Run| {
        let view = run.view();
        let moved = view.living().map(|b| view.displacement(b).length());
        moved.fold(0.0, f64::max)
    };
    let before = moved(&run);
    // The middle one, a corner with three held faces, and a child.
    topology::split(&mut run.world, &mut run.scratch, &[13, 0, 27 + 3], DT)
        .expect("the split is exact");
    for b in run.view().living() {
        let force = run.scratch.net.force(b).length();
        assert!(force < 1e-9 * 3e6, "{b}: {force}");
    }
    run.steps(200, DT);
    println!("moved {before:.1e} m before, {:.1e} m after", moved(&run));
    assert!(moved(&run) < 1e-13);
}
