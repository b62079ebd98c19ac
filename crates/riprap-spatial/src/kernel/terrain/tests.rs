//! Terrain against a floor of one brick, against its closed form on a slope, and along closed paths.

use riprap_geom::height_field::HeightField;
use riprap_geom::{Mat3, Quat, Vec3};

use super::*;
use crate::kernel::friction::Pieces;
use crate::kernel::kit::{Chance, KINDS, Placed, block};
use crate::kernel::lever::lever;
use crate::kernel::sums::integrate;
use crate::kernel::surface::Walker;
use crate::kernel::{Pose, Shape};

/// A grid over a square about the origin.
fn ground(half: f64, cells: usize, height: impl Fn(f64, f64) -> f64) -> Terrain {
    let step = 2.0 * half / cells as f64;
    let line: Vec<f64> = (0..=cells).map(|k| -half + step * k as f64).collect();
    let field = HeightField::grid(&line, &line, |i, j| Some(height(line[i], line[j])));
    Terrain::new(field.unwrap())
}

fn rough(x: f64, y: f64) -> f64 {
    0.12 * libm::sin(3.1 * x + 0.3) * libm::cos(2.3 * y) + 0.4 * x - 0.1 * y
}

fn find(treader: &mut Treader, terrain: &Terrain, shape: &Shape, pose: Pose) -> Reached {
    let mut normals = Vec::new();
    let turn = crate::kernel::turn(shape, pose.rotation, &mut normals);
    let body = Body { shape, normals: &normals, turn, position: pose.position };
    treader.find(terrain, &body, shape.radius)
}

fn all(treader: &Treader) -> (Vec3, Vec3) {
    let each = treader.facets.iter().map(|on| &on.sums);
    each.fold((Vec3::ZERO, Vec3::ZERO), |(force, moment), sums| {
        (force + sums.force, moment + sums.moment)
    })
}

fn near(found: f64, exact: f64, allowed: f64) {
    assert!((found - exact).abs() <= allowed, "{found:e} for {exact:e}");
}

/// Everything that the law asks of the surface, for blocks anyhow on a flat floor of 800 triangles.
#[test]
fn a_flat_floor_of_triangles_is_a_floor_of_one_brick() {
    let floor = Shape::brick(Vec3::new(3.0, 3.0, 3.0)).unwrap();
    let terrain = ground(3.0, 20, |_, _| 3.0);
    assert_eq!(terrain.facets(), 1);
    let (mut treader, mut walker) = (Treader::default(), Walker::default());
    let mut touched = 0;
    for (seed, kind) in KINDS.into_iter().enumerate() {
        let mut chance = Chance::new(seed as u64 + 1);
        for _ in 0..100 {
            let shape = block(kind, &mut chance).0;
            let rotation = chance.rotation();
            let low = shape.vertices.iter().map(|v| (rotation * *v).z);
            let low = low.fold(f64::INFINITY, f64::min);
            let depth = 0.001 * 60.0_f64.powf(chance.unit());
            let aside = chance.direction();
            let position = Vec3::new(aside.x, aside.y, 3.0 - low - depth);
            let pose = Pose { position, rotation };
            let sums =
                Placed::new([&floor, &shape], [Pose::at(Vec3::ZERO), pose]).touch(&mut walker);
            assert_eq!(find(&mut treader, &terrain, &shape, pose), Reached::Touching);
            let on = &treader.facets[0].sums;
            touched += on.pieces;
            let scale = 1e-12 * sums.weight.max(1e-6);
            assert!((on.force - sums.force).length() < scale);
            assert!((on.moment - sums.moment).length() < scale);
            near(on.weight_second, sums.weight_second, scale);
            near(on.depth, sums.depth, 1e-12);
            near(on.area, sums.area, 1e-11);
            assert!((on.vector_area - sums.vector_area).length() < 1e-11);
            let spread = |s: &Sums| Mat3::from_cols_array_2d(&s.area_second.map(|c| c.to_array()));
            assert!((spread(on) - spread(&sums)).abs_diff_eq(Mat3::ZERO, 1e-11));
            let centre = sums.weight_first / sums.weight;
            let radius = |show: &Pieces| {
                let (mut above, mut below) = (0.0, 0.0);
                show(&mut |polygon, frame| {
                    let at = frame.axes.map(|axis| axis.dot(centre - frame.foot));
                    above += lever(polygon, at, [1.0, 0.0]).value;
                    below += integrate(polygon).depth;
                });
                above / below
            };
            let found = radius(&|show| treader.rubbing(0, show));
            let exact = radius(&|show| walker.rubbing(show));
            near(found, exact, 1e-9 * exact);
        }
    }
    assert!(touched > 1500, "{touched}");
}

/// Flat on a slope: `2 c/(n_z + c)` times the stiffness of a brick, along the normal of the slope.
#[test]
fn a_slope_is_as_stiff_as_stated() {
    let shape = Shape::brick(Vec3::new(0.5, 0.4, 0.5)).unwrap();
    for angle in [0.0_f64, 20.0, 45.0, 60.0] {
        let rise = libm::tan(angle.to_radians());
        let terrain = ground(4.0, 7, |x, _| rise * x);
        let normal = Vec3::new(-rise, 0.0, 1.0).normalize();
        let rotation = Quat::from_rotation_arc(Vec3::Z, normal);
        let depth = 1e-6;
        let position = (0.5 - depth) * normal + Vec3::new(0.3 * normal.z, 0.2, -0.3 * normal.x);
        let mut treader = Treader::default();
        find(&mut treader, &terrain, &shape, Pose { position, rotation });
        let (force, _) = all(&treader);
        let exact = 0.8 * depth * DEPTH / (normal.z + DEPTH);
        assert!((force / exact - normal).length() < 1e-5, "{}", force / exact);
    }
}

/// Sliding over triangles in one plane changes nothing; so does another position of the block on the surface.
#[test]
fn edges_in_one_plane_are_not_felt() {
    let terrain = ground(4.0, 13, |x, y| 0.5 * x - 0.3 * y);
    assert_eq!(terrain.facets(), 1);
    let mut chance = Chance::new(3);
    let mut treader = Treader::default();
    for kind in KINDS {
        let shape = block(kind, &mut chance).0;
        let rotation = chance.rotation();
        let above = |v: &Vec3| {
            let v = rotation * *v;
            v.z - 0.5 * v.x + 0.3 * v.y
        };
        let low = shape.vertices.iter().map(above).fold(f64::INFINITY, f64::min);
        let mut first = None;
        for _ in 0..200 {
            let (x, y) = (chance.between(-1.5, 1.5), chance.between(-1.5, 1.5));
            let position = Vec3::new(x, y, 0.5 * x - 0.3 * y - low - 0.02);
            find(&mut treader, &terrain, &shape, Pose { position, rotation });
            let sums = treader.facets[0].sums;
            let (force, moment) = *first.get_or_insert((sums.force, sums.moment));
            assert!((sums.force - force).length() < 1e-12 * force.length(), "{kind:?}");
            assert!((sums.moment - moment).length() < 1e-12 * force.length());
            let across = sums.force.cross(Vec3::new(-0.5, 0.3, 1.0)).length();
            assert!(across < 1e-12 * force.length(), "{across:e}");
        }
    }
}

/// Work of the pressure round closed paths in all six freedoms over rough ground: none, to the error of the quadrature.
#[test]
fn no_work_is_done_round_closed_paths_over_rough_ground() {
    let terrain = ground(4.0, 23, rough);
    assert!(terrain.facets() > 500);
    let mut most = 0;
    for (seed, kind) in KINDS.into_iter().enumerate() {
        let mut chance = Chance::new(seed as u64 + 70);
        for _ in 0..4 {
            let (shape, rotation) = (block(kind, &mut chance).0, chance.rotation());
            let (x, y) = (chance.between(-2.0, 2.0), chance.between(-2.0, 2.0));
            // Down until it lies 0.06 deep.
            let mut treader = Treader::default();
            let mut at = Vec3::new(x, y, rough(x, y) + 1.2);
            let deep = |treader: &Treader| treader.facets.iter().any(|on| on.sums.depth > 0.06);
            while !deep(&treader) {
                at.z -= 0.005;
                find(&mut treader, &terrain, &shape, Pose { position: at, rotation });
            }
            most = most.max(treader.facets.len());
            let amplitude: Vec<f64> = (0..12).map(|_| chance.between(-0.01, 0.01)).collect();
            let (mut sum, mut size) = (0.0, 0.0);
            let intervals = 3000;
            let step = std::f64::consts::TAU / f64::from(intervals);
            for n in 0..intervals {
                for gauss in [-0.5, 0.5] {
                    let tau = (f64::from(n) + 0.5 + gauss / 3.0_f64.sqrt()) * step;
                    let (s, c) = libm::sincos(tau);
                    let place = |k: usize| amplitude[k] * (c - 1.0) + amplitude[k + 6] * s;
                    let rate = |k: usize| -amplitude[k] * s + amplitude[k + 6] * c;
                    let [rx, ry] =
                        [Quat::from_rotation_x(place(3)), Quat::from_rotation_y(place(4))];
                    let turned = rx * ry * Quat::from_rotation_z(place(5)) * rotation;
                    let spin = rate(3) * Vec3::X
                        + rx * (rate(4) * Vec3::Y)
                        + rx * (ry * (rate(5) * Vec3::Z));
                    let position = at + Vec3::new(place(0), place(1), place(2));
                    let pose = Pose { position, rotation: turned };
                    find(&mut treader, &terrain, &shape, pose);
                    let (force, moment) = all(&treader);
                    let work = force.dot(Vec3::new(rate(0), rate(1), rate(2))) + moment.dot(spin);
                    sum += work;
                    size += work.abs();
                }
            }
            assert!(size > 0.0);
            assert!(sum.abs() < 3e-7 * size, "{kind:?}: {:e}", sum.abs() / size);
            println!("{kind:?}: {:e}", sum.abs() / size);
        }
    }
    assert!(most > 2);
}

/// What is apart is at least as far away as said, and nothing that touches is called apart.
#[test]
fn gaps_are_bounds() {
    let terrain = ground(4.0, 16, rough);
    let mut treader = Treader::default();
    let mut chance = Chance::new(9);
    let (mut apart, mut touching) = (0, 0);
    for kind in KINDS {
        let (shape, rotation) = (block(kind, &mut chance).0, chance.rotation());
        for _ in 0..150 {
            let (x, y) = (chance.between(-3.0, 3.0), chance.between(-3.0, 3.0));
            let position = Vec3::new(x, y, rough(x, y) + chance.between(0.3, 2.0));
            let pose = Pose { position, rotation };
            match find(&mut treader, &terrain, &shape, pose) {
                Reached::Apart(gap) => {
                    apart += 1;
                    for _ in 0..10 {
                        let moved = position + 0.999 * gap * chance.direction();
                        let there = find(
                            &mut treader,
                            &terrain,
                            &shape,
                            Pose { position: moved, rotation },
                        );
                        assert!(matches!(there, Reached::Apart(_)), "{there:?} {gap}");
                    }
                }
                Reached::Touching => touching += 1,
                Reached::FullyPenetrated(_) => {}
            }
        }
    }
    assert!(apart > 100 && touching > 30, "{apart} {touching}");
}

#[test]
fn a_block_below_the_surface_is_swallowed() {
    let terrain = ground(4.0, 4, |_, _| 0.0);
    let shape = Shape::brick(Vec3::splat(0.5)).unwrap();
    let at =
        |z: f64| find(&mut Treader::default(), &terrain, &shape, Pose::at(Vec3::new(0.1, 0.2, z)));
    assert_eq!(at(0.4), Reached::Touching);
    assert_eq!(at(-3.0), Reached::FullyPenetrated(3.0));
    assert!(matches!(at(1.0), Reached::Apart(gap) if (gap - 0.5).abs() < 1e-12));
    let beside = Pose::at(Vec3::new(5.0, 0.0, -1.0));
    let beside = find(&mut Treader::default(), &terrain, &shape, beside);
    // From the wall, which leans out a little.
    assert!(matches!(beside, Reached::Apart(gap) if gap <= 0.5 && gap > 0.499), "{beside:?}");
}
