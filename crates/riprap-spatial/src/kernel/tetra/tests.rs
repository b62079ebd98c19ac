//! The law on whole blocks, without integration in time.

use riprap_geom::Vec3;
use riprap_geom::polyhedron::{Polyhedron, Tetrahedra};

use crate::kernel::kit;
use crate::kernel::kit::{Chance, KINDS, Kind};
use crate::kernel::tetra::{Cell, Overlap, Piece, Workspace};

const KN: f64 = 1e9;

/// A block of tetrahedra from its centre, with the depth that its centre has at the start.
struct TetFan {
    mesh: Tetrahedra,
    nodes: Vec<Vec3>,
    peak: f64,
}

impl TetFan {
    fn new(solid: &Polyhedron) -> Self {
        let mesh = Tetrahedra::new(solid).unwrap();
        let height = |g: &[Vec3; 3]| 1.0 / (g[0] + g[1] + g[2]).length();
        let peak = mesh.gradients.iter().map(height).fold(f64::MAX, f64::min);
        Self { nodes: mesh.nodes.clone(), mesh, peak }
    }

    fn cube() -> Self {
        Self::new(&Polyhedron::brick(Vec3::ZERO, Vec3::splat(0.5)))
    }

    fn map(mut self, f: impl FnMut(Vec3) -> Vec3) -> Self {
        self.nodes = self.nodes.into_iter().map(f).collect();
        self
    }

    /// Nodes of each tetrahedron.
    fn tets(&self) -> Vec<[u32; 4]> {
        self.mesh.tets.clone()
    }

    fn cell(&self, k: usize) -> Cell {
        let corners = self.mesh.tets[k].map(|n| self.nodes[n as usize]);
        Cell::new(corners, [self.peak, 0.0, 0.0, 0.0]).unwrap()
    }
}

/// What two blocks do to each other.
struct Contact {
    energy: f64,
    forces: [Vec<Vec3>; 2],
    surface: Piece,
    touching: usize,
}

fn contact(stars: [&TetFan; 2]) -> Contact {
    let mut workspace = Workspace::default();
    let mut out = Contact {
        energy: 0.0,
        forces: stars.map(|s| vec![Vec3::ZERO; s.nodes.len()]),
        surface: Piece::default(),
        touching: 0,
    };
    for (i, ta) in stars[0].tets().iter().enumerate() {
        for (j, tb) in stars[1].tets().iter().enumerate() {
            let cells = [stars[0].cell(i), stars[1].cell(j)];
            let Some(overlap) = workspace.overlap([&cells[0], &cells[1]]) else {
                continue;
            };
            out.touching += 1;
            out.surface.add(&overlap.surface);
            for (side, tet) in [ta, tb].into_iter().enumerate() {
                let (cell, half) = (&cells[side], overlap.halves[side]);
                out.energy += 2.0 * KN * half.volume * cell.depth(half.centroid);
                for (node, weight) in tet.iter().zip(cell.weights(half.centroid)) {
                    out.forces[side][*node as usize] +=
                        2.0 * KN * half.volume * weight * cell.slope;
                }
            }
        }
    }
    out
}

/// Two random blocks, bent a little, that overlap.
fn bent(chance: &mut Chance, kind: Kind) -> [TetFan; 2] {
    loop {
        let pair = [0, 1].map(|side| {
            let solid = loop {
                let (_, solid) = kit::block(kind, chance);
                if Tetrahedra::new(&solid).is_ok() {
                    break solid;
                }
            };
            let turn = chance.rotation();
            let shift = f64::from(side) * 0.75 * chance.direction();
            TetFan::new(&solid).map(|x| turn * x + shift + 0.02 * chance.direction())
        });
        let sound = pair.iter().all(|s| {
            (0..s.mesh.tets.len())
                .all(|k| Cell::new(s.mesh.tets[k].map(|n| s.nodes[n as usize]), [0.0; 4]).is_some())
        });
        if sound && contact([&pair[0], &pair[1]]).energy > 1e3 {
            return pair;
        }
    }
}

#[test]
fn forces_are_minus_the_gradient_of_the_energy() {
    let mut chance = Chance::new(1);
    for kind in KINDS {
        for _ in 0..4 {
            let mut pair = bent(&mut chance, kind);
            let forces = contact([&pair[0], &pair[1]]).forces;
            let size = forces[0].iter().map(|f| f.length()).fold(0.0, f64::max);
            for (side, forces) in forces.iter().enumerate() {
                for (node, found) in forces.iter().enumerate() {
                    for axis in 0..3 {
                        let at = pair[side].nodes[node];
                        let mut energy = |step: f64| {
                            pair[side].nodes[node][axis] = at[axis] + step;
                            let energy = contact([&pair[0], &pair[1]]).energy;
                            pair[side].nodes[node] = at;
                            energy
                        };
                        // Fourth order: the energy is smooth but for kinks in its third derivative.
                        let h = 1e-5;
                        let slope = (8.0 * (energy(h) - energy(-h)) - energy(2.0 * h)
                            + energy(-2.0 * h))
                            / (12.0 * h);
                        let found = found[axis];
                        assert!(
                            (found + slope).abs() < 2e-6 * size,
                            "{kind:?} {side} {node} {axis}: {found} {slope} of {size}"
                        );
                    }
                }
            }
        }
    }
}

#[test]
fn momentum_and_angular_momentum_are_kept() {
    let mut chance = Chance::new(2);
    for kind in KINDS {
        for _ in 0..40 {
            let pair = bent(&mut chance, kind);
            let found = contact([&pair[0], &pair[1]]);
            let (mut force, mut moment, mut scale) = (Vec3::ZERO, Vec3::ZERO, 0.0);
            for (star, forces) in pair.iter().zip(&found.forces) {
                for (at, f) in star.nodes.iter().zip(forces) {
                    force += *f;
                    moment += at.cross(*f);
                    scale += f.length();
                }
            }
            assert!(force.length() < 1e-13 * scale, "{kind:?} {force} {scale}");
            assert!(moment.length() < 1e-13 * scale, "{kind:?} {moment}");
            // The pressure on the surface of equal depth has the same resultant.
            let on_first: Vec3 = found.forces[0].iter().copied().sum();
            assert!(found.surface.weight > 0.0);
            let along = on_first.normalize().dot(found.surface.vector.normalize());
            assert!(along < -0.8, "{along}");
        }
    }
}

/// Equal cubes face to face, turned as a whole and off each other by round-off: all of their side faces lie in planes of the other.
#[test]
fn cubes_in_line_keep_momentum() {
    let mut chance = Chance::new(5);
    let mut worst = 0.0_f64;
    for round in 0..400 {
        let turn = chance.rotation();
        let aside = [0.0, 1e-16, 1e-12, 1e-9][round % 4];
        let depth = [1e-5, 1e-3][round / 4 % 2];
        let pair = [0.0, 1.0 - depth].map(|along| {
            TetFan::cube().map(|x| turn * (x + along * Vec3::X) + aside * chance.direction())
        });
        let forces = contact([&pair[0], &pair[1]]).forces;
        let all = || forces.iter().flatten();
        let (sum, scale) =
            all().fold((Vec3::ZERO, 0.0), |(sum, scale), f| (sum + *f, scale + f.length()));
        worst = worst.max(sum.length() / scale);
    }
    assert!(worst < 1e-8, "{worst:e}");
}

#[test]
fn exchanged_blocks_feel_opposite_forces() {
    let mut chance = Chance::new(3);
    for kind in KINDS {
        let pair = bent(&mut chance, kind);
        let (one, two) = (contact([&pair[0], &pair[1]]), contact([&pair[1], &pair[0]]));
        assert!((one.energy / two.energy - 1.0).abs() < 1e-12);
        for (first, second) in one.forces.iter().zip(two.forces.iter().rev()) {
            for (a, b) in first.iter().zip(second) {
                assert!((*a - *b).length() < 1e-11 * one.energy, "{a} {b}");
            }
        }
        let [a, b] = [&one, &two].map(|c| c.surface.vector);
        assert!((a + b).length() < 1e-11 * a.length());
    }
}

#[test]
fn flat_faces_press_with_stiffness_times_area_and_depth() {
    for d in [1e-1, 1e-3, 1e-6] {
        let (a, b) = (TetFan::cube(), TetFan::cube().map(|x| x + Vec3::new(0.0, 0.0, 1.0 - d)));
        let found = contact([&a, &b]);
        let force: Vec3 = found.forces[1].iter().copied().sum();
        // Equal faces, depth to the nearest face: rims give way.
        let exact = KN * (d - d * d + d * d * d / 3.0);
        assert!((force.z / exact - 1.0).abs() < 1e-9, "{d}: {force} {exact}");
        assert!(force.truncate().length() < 1e-9 * exact);
        let surface = &found.surface;
        // The strips along the rims are as wide as deep and lean by 45 degrees.
        let pressed = 2.0 * KN * surface.weight;
        assert!((pressed / exact - 1.0).abs() < 1.2 * d, "{pressed} {exact}");
        let expected = 0.5 * d;
        assert!((surface.depth / expected - 1.0).abs() < 1e-9);
        let centre = surface.weight_first / surface.weight;
        let away = centre - Vec3::new(0.0, 0.0, 0.5 - 0.5 * d);
        assert!(away.length() < 0.1 * d * d + 1e-9, "{centre}");
    }
}

#[test]
fn a_corner_has_its_closed_form() {
    // Cube with its space diagonal down, pressed by d into a wide plate: (3 - sqrt 3)/2 kn d³.
    let turn = riprap_geom::Quat::from_rotation_arc(Vec3::ONE.normalize(), -Vec3::Z);
    let d = 0.01;
    let plate =
        TetFan::new(&Polyhedron::brick(Vec3::new(0.0, 0.0, -0.5), Vec3::new(0.5, 0.5, 0.5)));
    let lift = Vec3::new(0.02, 0.03, 0.75f64.sqrt() - d);
    let cube = TetFan::cube().map(|x| turn * x + lift);
    let force: Vec3 = contact([&plate, &cube]).forces[1].iter().copied().sum();
    let exact = (3.0 - 3f64.sqrt()) / 2.0 * KN * d * d * d;
    assert!((force.z / exact - 1.0).abs() < 1e-9, "{} {exact}", force.z);
}

#[test]
fn a_smaller_face_off_the_middle_keeps_its_resultant() {
    let d = 1e-4;
    let small = TetFan::new(&Polyhedron::brick(Vec3::ZERO, Vec3::new(0.1, 0.1, 0.1)));
    let shift = Vec3::new(0.17, -0.22, 0.6 - d);
    let small = small.map(|x| x + shift);
    let found = contact([&TetFan::cube(), &small]);
    let force: Vec3 = found.forces[1].iter().copied().sum();
    let (area, rim) = (0.04, 0.8);
    let exact = KN * (area * d - rim * d * d / 4.0 + d * d * d / 3.0);
    assert!((force.z / exact - 1.0).abs() < 1e-9, "{force} {exact}");
    let surface = &found.surface;
    let centre = surface.weight_first / surface.weight;
    assert!((centre - shift).truncate().length() < 1e-9, "{centre}");
    let polar = surface.area_second - surface.area_first.length_squared() / surface.area;
    assert!((polar / (0.04 * 0.08 / 12.0) - 1.0).abs() < 1e-2, "{polar}");
}

#[test]
fn touching_and_separate_cells_have_no_overlap() {
    let mut workspace = Workspace::default();
    for gap in [0.0, 1e-3] {
        let upper = TetFan::cube().map(|x| x + Vec3::new(0.0, 0.0, 1.0 + gap));
        let found = contact([&TetFan::cube(), &upper]);
        assert_eq!(found.touching, 0);
        assert_eq!(found.energy, 0.0);
    }
    let cell = TetFan::cube().cell(0);
    let far = cell.shifted(Vec3::new(3.0, 0.0, 0.0));
    assert_eq!(workspace.overlap([&cell, &far]), None::<Overlap>);
    // A cell and itself share everything, half of it to each.
    let all = workspace.overlap([&cell, &cell]).unwrap();
    let volume = all.halves[0].volume + all.halves[1].volume;
    assert!((volume * 24.0 - 1.0).abs() < 1e-14, "{volume}");
    let centre = cell.corners.iter().copied().sum::<Vec3>() / 4.0;
    assert!((all.halves[0].centroid - centre).length() < 1e-14);
}

#[test]
fn cells_turned_inside_out_are_refused() {
    let cell = TetFan::cube().cell(0);
    let [a, b, c, d] = cell.corners;
    assert!(Cell::new([a, c, b, d], [0.5; 4]).is_none());
    assert!(Cell::new([a, b, c, Vec3::NAN], [0.5; 4]).is_none());
    let moved = cell.shifted(Vec3::new(0.1, -0.2, 0.3));
    let at = Vec3::new(0.05, 0.02, -0.1);
    let (near, far) = (cell.weights(at), moved.weights(at + Vec3::new(0.1, -0.2, 0.3)));
    for (x, y) in near.iter().zip(far) {
        assert!((x - y).abs() < 1e-14);
    }
}

/// `cargo test --release -p riprap-spatial --lib -- --ignored --nocapture time_of_a_pair`
#[test]
#[ignore = "a measurement"]
fn time_of_a_pair_of_tetrahedra() {
    let mut chance = Chance::new(7);
    let turn = chance.rotation();
    let a = TetFan::cube();
    for (name, b) in [
        ("face to face", TetFan::cube().map(|x| x + Vec3::new(0.21, 0.13, 0.999))),
        ("turned", TetFan::cube().map(|x| turn * x + Vec3::new(0.1, 0.2, 1.2))),
    ] {
        let cells = [&a, &b].map(|s| (0..s.mesh.tets.len()).map(|k| s.cell(k)).collect::<Vec<_>>());
        let pairs: Vec<[&Cell; 2]> =
            cells[0].iter().flat_map(|a| cells[1].iter().map(move |b| [a, b])).collect();
        let mut workspace = Workspace::default();
        let touching: Vec<[&Cell; 2]> =
            pairs.iter().copied().filter(|pair| workspace.overlap(*pair).is_some()).collect();
        for (what, list) in [("touching", &touching), ("all", &pairs)] {
            let rounds = 2_000_000 / list.len();
            let start = std::time::Instant::now();
            let mut sum = 0.0;
            for _ in 0..rounds {
                for pair in list {
                    sum += workspace.overlap(*pair).map_or(0.0, |o| o.halves[0].volume);
                }
            }
            let time = start.elapsed().as_secs_f64() / (rounds * list.len()) as f64;
            println!(
                "{name}, {what}: {} pairs, {:.0} ns a pair ({sum:.3})",
                list.len(),
                1e9 * time
            );
        }
    }
}
