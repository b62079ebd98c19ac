//! Counts of the source's meshes, balance, what follows a split.

use super::*;
use crate::dynamics::TimeFunction;
use crate::setup::{
    BlockName, BlockSpec, Boundary, BoundaryKind, CavityPressure, FaceSet, Group, Load, LoadKind,
    Place, Shape, Solid, Source,
};

/// A lattice of unit cubes (times `edge`) from the origin.
pub(crate) fn lattice(cells: [u32; 3], edge: f64) -> Setup {
    let mut setup = Setup { names: vec!["rock".into()], ..Setup::default() };
    for z in 0..cells[2] {
        for y in 0..cells[1] {
            for x in 0..cells[0] {
                let corner = Vec3::new(f64::from(x), f64::from(y), f64::from(z));
                setup.blocks.push(BlockSpec {
                    name: BlockName { base: 0, number: setup.blocks.len() as u32 + 1 },
                    shape: Shape::Brick {
                        centre: edge * (corner + Vec3::splat(0.5)),
                        half: Vec3::splat(0.5 * edge),
                    },
                    material: 0,
                    velocity: Vec3::ZERO,
                    spin: Vec3::ZERO,
                });
            }
        }
    }
    setup
}

fn refine(setup: &mut Setup, around: Region, levels: u8) -> (Vec<Origin>, Forest) {
    setup.refinements.push(Refinement { around, levels, during: None });
    let lineage = before_run(setup).unwrap();
    let mut alive = vec![true; lineage.len()];
    for origin in &lineage {
        if origin.parent != Origin::NONE {
            alive[origin.parent as usize] = false;
        }
    }
    let forest = Forest::new(setup, &lineage, &alive);
    (lineage, forest)
}

/// Pairs of blocks that share a face.
fn contacts(forest: &mut Forest) -> usize {
    let leaves: Vec<u32> = forest.leaves().collect();
    let sides: usize = leaves.iter().map(|&b| forest.face_neighbours(b).len()).sum();
    sides / 2
}

fn worst_step(forest: &mut Forest) -> u8 {
    let leaves: Vec<u32> = forest.leaves().collect();
    let mut worst = 0;
    for b in leaves {
        for n in forest.face_neighbours(b) {
            let levels = [b, n].map(|k| forest.cells[k as usize].level);
            worst = worst.max(levels[0].abs_diff(levels[1]));
        }
    }
    worst
}

fn volume(setup: &Setup, forest: &Forest) -> f64 {
    forest
        .leaves()
        .map(|b| 8.0 * Bounds::of(&setup.blocks[b as usize].shape).half.element_product())
        .sum()
}

/// Tian & Li 4.2 (1), (3) and (2): 4376, 3480 and 3368 blocks.
#[test]
fn meshes_of_the_source_have_their_counts() {
    let mut setup = lattice([16, 16, 16], 1.0);
    let (_, mut forest) = refine(&mut setup, Region::Point(Vec3::splat(8.0)), 5);
    assert_eq!(forest.leaves().count(), 4376);
    assert_eq!(contacts(&mut forest), 12_540);
    assert_eq!(worst_step(&mut forest), 1);
    assert_eq!(volume(&setup, &forest), 4096.0);
    for (levels, count) in [(5, 3480), (3, 3368)] {
        let mut setup = lattice([20, 20, 8], 10.0);
        let (_, forest) = refine(&mut setup, Region::Point(Vec3::new(100.0, 100.0, 60.0)), levels);
        assert_eq!(forest.leaves().count(), count);
    }
}

#[test]
fn balance_splits_more_blocks_where_needed() {
    // Inside one block: its neighbours are reached from level 2 on.
    let mut setup = lattice([6, 6, 6], 1.0);
    let at = Vec3::new(3.01, 3.01, 3.01);
    let (_, mut forest) = refine(&mut setup, Region::Point(at), 4);
    assert_eq!(worst_step(&mut forest), 1);
    assert!((volume(&setup, &forest) - 216.0).abs() < 1e-12);
    let asked_only = 216 + 7 * 4;
    assert!(forest.leaves().count() > asked_only);
    // A plane, a ball and a line in one model, across the wrap.
    let mut setup = lattice([8, 8, 4], 1.0);
    setup.periodic = [Some(8.0), None, None];
    for (around, levels) in [
        (Region::Plane(Vec3::new(0.0, 0.0, 4.0), Vec3::Z), 2),
        (Region::Ball(Vec3::new(0.2, 4.0, 2.0), 0.5), 3),
    ] {
        setup.refinements.push(Refinement { around, levels, during: None });
    }
    let line = Region::Line(Vec3::new(6.1, 1.2, 0.0), Vec3::new(6.1, 1.2, 2.0));
    let (lineage, mut forest) = refine(&mut setup, line, 3);
    assert_eq!(worst_step(&mut forest), 1);
    assert!((volume(&setup, &forest) - 256.0).abs() < 1e-12);
    // The ball touches the plane x = 0; what lies across the wrap had to be split.
    let across = forest.leaves().any(|b| {
        let bounds = Bounds::of(&setup.blocks[b as usize].shape);
        lineage[b as usize].level >= 2
            && bounds.centre.x > 7.0
            && (bounds.centre.y - 4.0).abs() < 1.0
            && bounds.centre.z < 3.0
    });
    assert!(across);
}

#[test]
fn octants_and_names() {
    let mut setup = lattice([3, 1, 1], 2.0);
    setup.blocks[1].velocity = Vec3::new(1.0, 2.0, 3.0);
    setup.blocks[1].spin = Vec3::new(0.0, 0.0, 0.5);
    let (lineage, _) = refine(&mut setup, Region::Point(Vec3::new(3.0, 1.0, 1.0)), 2);
    assert_eq!(name(&setup, &lineage, 1), "rock.2");
    assert_eq!(name(&setup, &lineage, 3 + 6), "rock.2/6");
    let b = 3 + 6;
    let Shape::Brick { centre, half } = setup.blocks[b].shape else { panic!("no brick") };
    assert_eq!(centre, Vec3::new(2.5, 1.5, 1.5));
    assert_eq!(half, Vec3::splat(0.5));
    // v + w x r with r = (-0.5, 0.5, 0.5), w = 0.5 z.
    assert_eq!(setup.blocks[b].velocity, Vec3::new(0.75, 1.75, 3.0));
    assert_eq!(name(&setup, &lineage, lineage.len() - 1), "rock.2/7/7");
}

#[test]
fn lists_follow_the_split() {
    let mut setup = lattice([2, 1, 1], 2.0);
    setup.groups.push(Group { name: "all".into(), blocks: vec![0, 1] });
    setup.boundaries.push(Boundary {
        name: "top".into(),
        on: FaceSet::Blocks { blocks: vec![0], normal: None },
        kind: BoundaryKind::Held { normal: true, shear: true },
        in_situ: false,
    });
    setup.sources.push(Source {
        name: "hole".into(),
        place: Place::Blocks { blocks: vec![1] },
        delay: 0.0,
        hole: Default::default(),
        push: CavityPressure::Pressure { time: TimeFunction::Constant(1.0) },
    });
    let force = Vec3::new(8.0, 0.0, 0.0);
    let point = Vec3::new(0.1, 1.9, 1.6);
    for kind in [
        LoadKind::Point { force, at: Some(point) },
        LoadKind::Point { force, at: None },
        LoadKind::Moment { moment: force },
        LoadKind::BodyForce { acceleration: force },
    ] {
        setup.loads.push(Load {
            blocks: vec![0, 1],
            kind,
            account: None,
            time: TimeFunction::Constant(1.0),
        });
    }
    let (lineage, forest) = refine(&mut setup, Region::Point(Vec3::ZERO), 2);
    assert_eq!(forest.leaves().count(), 16);
    let everyone: Vec<u32> = (0..lineage.len() as u32).collect();
    assert_eq!(setup.groups[0].blocks, everyone);
    let living = |b: u32| forest.cells[b as usize].alive;
    let mut total = Vec3::ZERO;
    let mut holders = Vec::new();
    for load in &setup.loads {
        for &b in load.blocks.iter().filter(|&&b| living(b)) {
            match load.kind {
                LoadKind::Point { force, at: None } => total += force,
                LoadKind::Point { at: Some(_), .. } => holders.push(b),
                LoadKind::Moment { .. }
                | LoadKind::BodyForce { .. }
                | LoadKind::Nodes { .. }
                | LoadKind::Own { .. } => {}
            }
        }
    }
    // Block 1 is whole; block 0 hands its force to all its parts.
    assert_eq!(total, 2.0 * force);
    assert_eq!(holders.len(), 2);
    assert!(
        holders
            .iter()
            .any(|&b| { Bounds::of(&setup.blocks[b as usize].shape).distance(point) == 0.0 })
    );
}

#[test]
fn what_cannot_be_split_is_an_error() {
    let mut setup = lattice([2, 1, 1], 1.0);
    setup.blocks[1].shape = Shape::Polyhedron(Box::new(Solid {
        vertices: vec![Vec3::X, 2.0 * Vec3::X, Vec3::X + Vec3::Y, Vec3::X + Vec3::Z],
        faces: Vec::new(),
    }));
    let mut refinement = Refinement { around: Region::All, levels: 1, during: None };
    setup.refinements.push(refinement.clone());
    let error = before_run(&mut setup).unwrap_err().to_string();
    assert!(error.contains("rock.2"), "{error}");
    refinement.levels = 17;
    setup.refinements = vec![refinement];
    assert_eq!(before_run(&mut setup), Err(RefineError::TooDeep { levels: 17 }));
}
