//! Overlays: areas, equal fans, the patch test of cut blocks, momentum.

use super::*;
use crate::face_overlap::face_overlap;
use crate::polyhedron::{Polyhedron, Sliced, slice};
use crate::random::Chance;

fn brick(at: [f64; 3], half: f64) -> Polyhedron {
    Polyhedron::brick(Vec3::from_array(at), Vec3::splat(half))
}

/// The parts that three planes in a random direction leave of a block.
fn cut(solid: Polyhedron, chance: &mut Chance) -> Vec<Polyhedron> {
    let n = Vec3::new(chance.normal(), chance.normal(), chance.normal()).normalize();
    let heights: Vec<f64> = solid.vertices.iter().map(|v| n.dot(*v)).collect();
    let low = heights.iter().copied().fold(f64::INFINITY, f64::min);
    let high = heights.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let mut rest = solid;
    let mut parts = Vec::new();
    for k in 1..4 {
        let d = low + 0.25 * f64::from(k) * (high - low);
        let (Sliced::Part(below), Sliced::Part(above)) = (slice(&rest, n, d), slice(&rest, -n, -d))
        else {
            panic!("three planes leave four parts")
        };
        parts.push(below);
        rest = above;
    }
    parts.push(rest);
    parts
}

/// Faces of blocks that look at each other in one plane.
fn pairs(meshes: &[(Polyhedron, Tetrahedra)]) -> Vec<[(usize, usize); 2]> {
    let mut found = Vec::new();
    for i in 0..meshes.len() {
        for j in i + 1..meshes.len() {
            for fi in 0..meshes[i].0.faces.len() {
                for fj in 0..meshes[j].0.faces.len() {
                    let (n, d) = meshes[i].0.plane(fi);
                    let (m, e) = meshes[j].0.plane(fj);
                    if n.dot(m) < -1.0 + 1e-9 && (d + e).abs() < 1e-9 {
                        found.push([(i, fi), (j, fj)]);
                    }
                }
            }
        }
    }
    found
}

#[test]
fn equal_fans_give_the_five_springs_of_the_source() {
    let meshes = [0.3, 0.33].map(|x| Tetrahedra::new(&brick([x, 0.17, -0.7], 0.015)).unwrap());
    // Faces +x of the first and -x of the second.
    let (a, b) = (meshes[0].face_fan(1), meshes[1].face_fan(0));
    for points in [overlay(&a, &b, Vec3::X, 0.0), node_to_face(&a, &b, Vec3::X, 0.0)] {
        assert_eq!(points.len(), 5);
        for point in &points {
            assert_eq!(point.sides.map(|s| s.count), [1, 1]);
            let [i, j] = point.sides.map(|s| s.nodes[0] as usize);
            assert!(meshes[0].nodes[i].distance(meshes[1].nodes[j]) < 1e-12);
            let share = if i >= 8 { 1.0 / 3.0 } else { 1.0 / 6.0 };
            assert!((point.area / 9e-4 - share).abs() < 1e-12);
        }
    }
}

#[test]
fn faces_that_share_an_edge_are_not_joined() {
    let a = Tetrahedra::new(&brick([0.5, 0.5, 0.5], 0.5)).unwrap();
    let b = Tetrahedra::new(&brick([1.5, 1.5, 0.5], 0.5)).unwrap();
    assert!(overlay(&a.face_fan(1), &b.face_fan(0), Vec3::X, 1e-9).is_empty());
    assert!(node_to_face(&a.face_fan(1), &b.face_fan(0), Vec3::X, 1e-9).is_empty());
}

/// Eight cubes, all cut in random directions: areas, the patch test and the loss of the source's rule.
#[test]
fn cut_blocks_pass_the_patch_test() {
    let mut chance = Chance::new(12);
    let mut meshes = Vec::new();
    for k in 0..8 {
        let bit = |b: u32| f64::from(u8::from(k & b != 0));
        for part in cut(brick([bit(1), bit(2), bit(4)], 0.5), &mut chance) {
            let mesh = Tetrahedra::new(&part).unwrap();
            meshes.push((part, mesh));
        }
    }
    let mut shares: Vec<Vec<Vec<f64>>> = meshes
        .iter()
        .map(|(solid, mesh)| vec![vec![0.0; mesh.nodes.len()]; solid.faces.len()])
        .collect();
    let (mut area, mut exact, mut lost) = (0.0, 0.0, 0.0);
    for [(i, fi), (j, fj)] in pairs(&meshes) {
        let (n, _) = meshes[i].0.plane(fi);
        let (a, b) = (meshes[i].1.face_fan(fi), meshes[j].1.face_fan(fj));
        let points = overlay(&a, &b, n, 1e-12);
        let direct = face_overlap(&meshes[i].0.outline(fi), &meshes[j].0.outline(fj), n, 1e-12)
            .map_or(0.0, |o| o.area);
        let here: f64 = points.iter().map(|p| p.area).sum();
        assert!((here - direct).abs() < 1e-13, "{here} {direct}");
        area += here;
        exact += direct;
        let simple = node_to_face(&a, &b, n, 1e-12);
        lost += direct - simple.iter().map(|p| p.area).sum::<f64>();
        for p in &points {
            let mut ends = [Vec3::ZERO; 2];
            for (side, (block, face)) in [(i, fi), (j, fj)].into_iter().enumerate() {
                let anchor = &p.sides[side];
                assert!((anchor.weights.iter().sum::<f64>() - 1.0).abs() < 1e-15);
                for (node, w) in anchor.nodes.iter().zip(anchor.weights) {
                    assert!(w > -1e-11);
                    ends[side] += w * meshes[block].1.nodes[*node as usize];
                    shares[block][face][*node as usize] += p.area * w;
                }
            }
            // Equal places on both sides: no moment from a force and its reaction.
            assert!(ends[0].distance(ends[1]) < 1e-13);
            assert!(ends[0].distance(p.at) < 1e-13);
        }
    }
    assert!((area / exact - 1.0).abs() < 1e-13);
    // Three faces of four cubes each, and the cuts.
    assert!(area > 12.0);
    let outside = |solid: &Polyhedron, face: usize| {
        let from_middle = solid.face_centre(face) - Vec3::splat(0.5);
        from_middle.abs().max_element() > 1.0 - 1e-9
    };
    let mut worst: f64 = 0.0;
    for ((solid, mesh), shares) in meshes.iter().zip(&shares) {
        for (face, got) in shares.iter().enumerate() {
            if outside(solid, face) {
                continue;
            }
            let tributary = mesh.tributary(face);
            let scale: f64 = tributary.iter().map(|t| t.1).sum();
            for (node, area) in tributary {
                worst = worst.max((got[node as usize] - area).abs() / scale);
            }
        }
    }
    assert!(worst < 1e-12, "{worst:e}");
    assert!(lost.abs() / exact > 0.01, "{}", lost / exact);
}
