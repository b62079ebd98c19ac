//! Cuts in every position: through corners, edges and faces, nearly so, again and again.

use std::collections::BTreeMap;

use super::*;
use crate::polyhedron::hull;
use crate::random::Chance;

fn direction(chance: &mut Chance) -> Vec3 {
    Vec3::new(chance.normal(), chance.normal(), chance.normal()).normalize()
}

fn stone(chance: &mut Chance) -> Polyhedron {
    let corners = chance.whole(5, 16);
    let points: Vec<Vec3> =
        (0..corners).map(|_| direction(chance) + Vec3::new(3.0, -2.0, 1.0)).collect();
    hull(&points).unwrap()
}

/// A solid as a part of itself.
fn part(solid: &Polyhedron) -> Part {
    Part {
        solid: solid.clone(),
        origins: (0..solid.faces.len() as u32).map(FaceOrigin::Parent).collect(),
        mesh: Tetrahedra::new(solid).unwrap(),
    }
}

/// The ways in which a plane can lie.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Family {
    Generic,
    Vertex,
    Edge,
    ThreeVertices,
    OnFace,
    /// 1e-10 off a face.
    NearFace,
    /// 1e-16 to 1e-3 off a face, a little tilted.
    AnyFace,
    /// 1e-16 to 1e-3 off a vertex.
    AnyVertex,
}

const FAMILIES: [Family; 6] = [
    Family::Generic,
    Family::Vertex,
    Family::Edge,
    Family::ThreeVertices,
    Family::OnFace,
    Family::NearFace,
];

fn plane(family: Family, solid: &Polyhedron, chance: &mut Chance) -> (Vec3, f64) {
    let any = |chance: &mut Chance| solid.vertices[chance.whole(0, solid.vertices.len() - 1)];
    let through = |n: Vec3, p: Vec3| (n, n.dot(p));
    let centre = solid.moments().centroid;
    match family {
        Family::Generic => {
            let n = direction(chance);
            let p = centre.lerp(any(chance), chance.between(-0.5, 0.9));
            through(n, p)
        }
        Family::Vertex => through(direction(chance), any(chance)),
        Family::Edge | Family::ThreeVertices => {
            let (p, q) = (any(chance), any(chance));
            let r =
                if family == Family::Edge { centre + 0.3 * direction(chance) } else { any(chance) };
            let n = (q - p).cross(r - p).normalize_or_zero();
            if n == Vec3::ZERO { through(Vec3::X, p) } else { through(n, p) }
        }
        Family::OnFace => solid.plane(chance.whole(0, solid.faces.len() - 1)),
        Family::NearFace => {
            let (n, d) = solid.plane(chance.whole(0, solid.faces.len() - 1));
            (n, d - 1e-10)
        }
        Family::AnyFace | Family::AnyVertex => {
            let size = libm::pow(10.0, chance.between(-16.0, -3.0));
            let shift = if chance.unit() < 0.5 { size } else { -size };
            if family == Family::AnyFace {
                let (n, d) = solid.plane(chance.whole(0, solid.faces.len() - 1));
                let tilted = (n + 0.1 * shift * direction(chance)).normalize();
                (tilted, tilted.dot(n * d) + shift)
            } else {
                let (n, d) = through(direction(chance), any(chance));
                (n, d + shift)
            }
        }
    }
}

/// What a run of random cuts found.
#[derive(Default)]
struct Tally {
    made: BTreeMap<Family, usize>,
    /// Largest relative error of the volume.
    volume: f64,
    /// Cuts that leave more than a micrometre on both sides (of metres) and were refused all the same.
    refused: usize,
}

/// Cuts solids, and the larger part again, six deep. Whatever is made is sound: [`halve`] has checked it.
fn cut_many(count: usize, seed: u64, families: &[Family]) -> Tally {
    let mut chance = Chance::new(seed);
    let mut tally = Tally::default();
    let mut cuts = 0;
    while cuts < count {
        let mut at = if chance.unit() < 0.3 {
            part(&Polyhedron::brick(Vec3::splat(0.7), Vec3::new(1.0, 1.0, 1.5)))
        } else {
            part(&stone(&mut chance))
        };
        for _ in 0..6 {
            let family = families[chance.whole(0, families.len() - 1)];
            let (n, d) = plane(family, &at.solid, &mut chance);
            let snap = least_snap(&at.solid);
            cuts += 1;
            let phi = || at.solid.vertices.iter().map(|v| n.dot(*v) - d);
            let depth = phi().fold(0.0, f64::max).min(phi().map(|p| -p).fold(0.0, f64::max));
            let Ok([below, above]) = halve(&at, n, d, snap, 0) else {
                tally.refused += usize::from(depth > 1e-6);
                continue;
            };
            *tally.made.entry(family).or_default() += 1;
            let sum = below.mesh.volume() + above.mesh.volume();
            tally.volume = tally.volume.max((sum / at.mesh.volume() - 1.0).abs());
            for half in [&below, &above] {
                assert_eq!(half.origins.len(), half.solid.faces.len());
                assert!(half.origins.contains(&FaceOrigin::Plane(0)));
                assert!(half.mesh.volumes.iter().all(|v| *v > 0.0));
            }
            let larger = below.mesh.volume() > above.mesh.volume();
            at = if larger { below } else { above };
        }
    }
    tally
}

#[test]
fn random_and_degenerate_cuts_leave_sound_parts() {
    let tally = cut_many(22_000, 2026, &FAMILIES);
    // Planes through three vertices of a part that has faces 1e-10 m wide: 1 of these 22,000, 25 of 200,000.
    assert!(tally.refused <= 3, "{}", tally.refused);
    assert!(tally.volume < 1e-13, "volume error {:e}", tally.volume);
    for family in FAMILIES {
        let made = tally.made.get(&family).copied().unwrap_or(0);
        let none = family == Family::OnFace || family == Family::NearFace;
        assert!(none || made > 1500, "{family:?}: {made}");
    }
}

/// Planes at all distances from vertices and faces, down to round-off.
#[test]
fn planes_at_any_distance_from_vertices_and_faces() {
    let families = [Family::Generic, Family::AnyFace, Family::AnyVertex];
    let tally = cut_many(6_000, 7, &families);
    assert!(tally.refused <= 3, "{}", tally.refused);
    assert!(tally.volume < 1e-9, "volume error {:e}", tally.volume);
    assert!(tally.made.values().all(|made| *made > 500));
}

/// Slivers a little thicker than the snap length are made, sound, and refused by volume.
#[test]
fn slivers_are_refused() {
    let cube = Polyhedron::brick(Vec3::ZERO, Vec3::ONE);
    let limits = Limits { snap: 0.0, sliver: 1e-3 };
    let at = Vec3::new(0.0, 0.0, -0.999);
    let planes = Planes::Anchored { count: 1, at };
    // Dropped: too near the end.
    let parts = cut(&cube, Vec3::Z, planes, &limits).unwrap();
    assert_eq!((parts.parts.len(), parts.offsets.len()), (1, 0));
    // A corner of 1/6 of the cube's 2 x 2 x 2 times 0.12³ ...
    let n = Vec3::ONE;
    let at = Vec3::splat(-0.8);
    let planes = Planes::Anchored { count: 1, at };
    let parts = cut(&cube, n, planes, &limits).unwrap();
    assert_eq!(parts.offsets.len(), 1);
    let strict = Limits { sliver: 0.01, ..limits };
    let parts = cut(&cube, n, planes, &strict).unwrap();
    assert_eq!((parts.parts.len(), parts.refused.len()), (1, 1));
}

#[test]
fn three_planes_make_four_parts_with_known_faces() {
    let mut chance = Chance::new(4);
    let cube = Polyhedron::brick(Vec3::splat(0.015), Vec3::splat(0.015));
    let (mut corners, mut faces, mut smallest) = (0, 0, 1.0_f64);
    for _ in 0..300 {
        let n = direction(&mut chance);
        let limits = Limits::default();
        let cut = cut(&cube, n, Planes::Spaced { count: 3 }, &limits).unwrap();
        assert_eq!((cut.parts.len(), cut.offsets.len()), (4, 3));
        let total: f64 = cut.parts.iter().map(|p| p.mesh.volume()).sum();
        assert!((total / 2.7e-5 - 1.0).abs() < 1e-13);
        for (k, part) in cut.parts.iter().enumerate() {
            corners = corners.max(part.solid.vertices.len());
            faces = faces.max(part.solid.faces.len());
            smallest = smallest.min(part.mesh.volume() / 2.7e-5);
            for (face, origin) in part.origins.iter().enumerate() {
                let (m, e) = part.solid.plane(face);
                match origin {
                    FaceOrigin::Parent(parent) => {
                        let (p, d) = cube.plane(*parent as usize);
                        assert!(m.dot(p) > 1.0 - 1e-9 && (e - d).abs() < 1e-12);
                    }
                    FaceOrigin::Plane(plane) => {
                        let plane = *plane as usize;
                        assert!(plane == k || plane + 1 == k);
                        let side = if plane == k { 1.0 } else { -1.0 };
                        assert!(side * m.dot(n) > 0.99, "{}", m.dot(n));
                    }
                }
            }
        }
        // The parts add up to the faces of the cube.
        for face in 0..6 {
            let area: f64 = cut
                .parts
                .iter()
                .flat_map(|p| p.origins.iter().enumerate().map(move |(f, o)| (p, f, o)))
                .filter(|(_, _, o)| **o == FaceOrigin::Parent(face))
                .map(|(p, f, _)| p.solid.area_vector(f).length())
                .sum();
            assert!((area / 9e-4 - 1.0).abs() < 1e-12);
        }
    }
    // The document on the method: at most 12 vertices, 8 faces, at least 7 % of the cube.
    assert!(corners <= 12 && faces <= 8, "{corners} {faces}");
    assert!(smallest > 0.06, "{smallest}");
}

#[test]
fn anchored_planes_go_through_the_point() {
    let brick = Polyhedron::brick(Vec3::ZERO, Vec3::new(1.0, 1.0, 2.0));
    let limits = Limits::default();
    let at = Vec3::new(0.3, 0.0, 0.25);
    let made = |count| {
        cut(&brick, Vec3::new(0.0, 0.0, 5.0), Planes::Anchored { count, at }, &limits).unwrap()
    };
    assert_eq!(made(1).offsets, [0.25]);
    assert_eq!(made(3).offsets, [-0.75, 0.25, 1.25]);
    // Five at 2/3: 0.25 + 4/3 is 1.583, kept; the lowest is at -1.083.
    let five = made(5);
    assert_eq!(five.offsets.len(), 5);
    assert!((five.offsets[4] - (0.25 + 4.0 / 3.0)).abs() < 1e-15);
    // One plane more above than below for even numbers.
    assert_eq!(made(2).offsets.len(), 2);
    assert!(made(2).offsets[0] == 0.25);
    // A point near the end: its own plane is dropped.
    let high = Vec3::new(0.0, 0.0, 1.95);
    let planes = Planes::Anchored { count: 3, at: high };
    let cut_high = cut(&brick, Vec3::Z, planes, &limits).unwrap();
    assert_eq!(cut_high.offsets, [0.95]);
}

/// Catalogue entry E7: a cube of 30 mm, cut as in the fracture paper. The outer part is a prism over a triangle whose sides are
/// in the ratio of tan 30 deg: `a^3 (cos + sin)^2/(32 sin cos)`.
#[test]
fn the_volumes_of_the_cut_of_the_fracture_paper() {
    let (a, [sin, cos]) = (0.03, [0.5, libm::sqrt(0.75)]);
    let cube = Polyhedron::brick(Vec3::ZERO, Vec3::splat(0.5 * a));
    let limits = Limits::default();
    let normal = Vec3::new(cos, sin, 0.0);
    let cut = cut(&cube, normal, Planes::Spaced { count: 3 }, &limits).unwrap();
    let outer = a * a * a * (cos + sin) * (cos + sin) / (32.0 * sin * cos);
    let inner = 0.5 * a * a * a - outer;
    assert!((outer - 3.636_057_159e-6).abs() < 1e-15);
    for (part, volume) in cut.parts.iter().zip([outer, inner, inner, outer]) {
        let found = part.mesh.volume();
        assert!((found / volume - 1.0).abs() < 1e-13, "{found} {volume}");
        let edges: usize = part.solid.faces.iter().map(Vec::len).sum();
        let (v, f) = (part.solid.vertices.len(), part.solid.faces.len());
        assert_eq!(v + f, edges / 2 + 2);
    }
    assert_eq!(cut.parts.len(), 4);
}

#[test]
fn bad_cuts_are_errors() {
    let cube = Polyhedron::brick(Vec3::ZERO, Vec3::ONE);
    let limits = Limits::default();
    let spaced = |count| Planes::Spaced { count };
    assert!(matches!(cut(&cube, Vec3::ZERO, spaced(3), &limits), Err(CutError::Normal { .. })));
    assert!(matches!(cut(&cube, Vec3::NAN, spaced(3), &limits), Err(CutError::Normal { .. })));
    for count in [0, 8] {
        assert_eq!(cut(&cube, Vec3::X, spaced(count), &limits), Err(CutError::Count { count }));
    }
    assert_eq!(cut(&cube, Vec3::X, spaced(7), &limits).unwrap().parts.len(), 8);
}

/// Snapping: the quality of random cuts with and without, and volumes that stay exact.
#[test]
fn snapping_removes_short_edges() {
    let cube = Polyhedron::brick(Vec3::ZERO, Vec3::splat(0.5));
    let mut shortest = Vec::new();
    for snap in [0.0, 0.03, 0.1] {
        let mut chance = Chance::new(8);
        let limits = Limits { snap, sliver: 1e-3 };
        let mut least = f64::INFINITY;
        for _ in 0..1000 {
            let n = direction(&mut chance);
            let cut = cut(&cube, n, Planes::Spaced { count: 3 }, &limits).unwrap();
            assert_eq!(cut.parts.len(), 4, "snap {snap}: {:?}", cut.refused);
            let total: f64 = cut.parts.iter().map(|p| p.mesh.volume()).sum();
            assert!((total - 1.0).abs() < 1e-13);
            for part in &cut.parts {
                for face in &part.solid.faces {
                    for (a, b) in edges_of(face) {
                        let v = &part.solid.vertices;
                        least = least.min(v[a as usize].distance(v[b as usize]));
                    }
                }
            }
        }
        shortest.push(least);
    }
    assert!(shortest[1] > 5e-3 && shortest[2] > 2e-2, "{shortest:?}");
    assert!(shortest[0] < 2e-3, "{shortest:?}");
}
