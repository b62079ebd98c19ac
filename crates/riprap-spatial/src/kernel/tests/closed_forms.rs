//! Overlaps that a ball touches on all sides, prisms, and bricks that go on in one plane: forces against the energies they are slopes of.
//!
//! The law stores `U = 2 kn int_O dist`, with the distance from the boundary of the overlap `O`. Where a ball of radius r touches all faces
//! of `O` (any tetrahedron, any regular pyramid), `O` is made of pyramids of height r over its faces, the mean distance in each is r/4, and
//! `U = kn V r/2`. A prism of length L with such a section, of area a: `U = 2 kn a r (L/3 - r/6)`. Forces are `dU/dd` with the depth d.

use super::*;

/// Of a floor, so far below and beside that only its top at z = 0 counts.
const FAR: f64 = 40.0;
/// Forces go with up to the cube of a depth of 1e-3 m, which is the difference of coordinates of [`FAR`]: 4e-15 m of round-off is 1e-11 of it.
const EXACT: f64 = 1e-10;

/// The hull of points in space, and the pose that puts it there.
fn block(points: &[Vec3]) -> (Shape, Pose) {
    let solid = hull(points).unwrap();
    let centre = solid.moments().centroid;
    (Shape::new(&solid, centre).unwrap(), Pose::at(centre))
}

fn floor() -> (Shape, Pose) {
    let shape = Shape::brick(Vec3::splat(FAR)).unwrap();
    (shape, Pose::at(Vec3::new(0.0, 0.0, -FAR)))
}

fn find(a: &(Shape, Pose), b: &(Shape, Pose)) -> Found {
    Placed::new([&a.0, &b.0], [a.1, b.1]).find_all(&mut Walker::default())
}

/// Sums of two blocks, and the place that they are about.
fn touch(a: &(Shape, Pose), b: &(Shape, Pose)) -> (Sums, Vec3) {
    let placed = Placed::new([&a.0, &b.0], [a.1, b.1]);
    (placed.touch(&mut Walker::default()), placed.origin())
}

/// Volume of a tetrahedron, and radius of the ball in it: three times the volume over the surface.
fn ball([a, b, c, d]: [Vec3; 4]) -> (f64, f64) {
    let volume = ((b - a).cross(c - a).dot(d - a) / 6.0).abs();
    let area = |p: Vec3, q: Vec3, r: Vec3| 0.5 * (q - p).cross(r - p).length();
    let surface = area(a, b, c) + area(a, b, d) + area(a, c, d) + area(b, c, d);
    (volume, 3.0 * volume / surface)
}

/// Energy over kn that a block takes up on its way into the floor from `d = 0`: two points of Gauss, exact for forces up to the cube of d.
fn energy(depth: f64, force: impl Fn(f64) -> f64) -> f64 {
    let place = |sign: f64| 0.5 * depth * (1.0 + sign / 3.0_f64.sqrt());
    0.5 * depth * (force(place(-1.0)) + force(place(1.0)))
}

/// A bar of triangular section along y, its lowest edge at depth `d`. The sides lean outwards by the angles `lean` (deg) from the vertical.
fn edge(lean: [f64; 2], length: f64, d: f64) -> (Shape, Pose) {
    let [left, right] = lean.map(|angle| libm::tan(angle.to_radians()));
    let y = 0.5 * length;
    let at = |x: f64, z: f64| [Vec3::new(x, -y, z - d), Vec3::new(x, y, z - d)];
    block(&[at(0.0, 0.0), at(-left, 1.0), at(right, 1.0)].concat())
}

/// Section `a = t d²` with `t = tan b` and `r = rho d`, so that `F = kn (2 rho t L d² - 4/3 rho² t d³)`; its resultant is on the plane
/// above the edge, on the area `2 t d L` of the floor, and `2 r` is the largest depth.
#[test]
fn edge_of_any_half_angle() {
    let length = 1.3;
    for half in [10.0_f64, 30.0, 45.0, 60.0, 75.0, 85.0] {
        let (sin, cos) = libm::sincos(half.to_radians());
        let (tan, rho) = (sin / cos, sin / (1.0 + sin));
        for d in DEPTHS {
            let (sums, _) = touch(&floor(), &edge([half; 2], length, d));
            let exact = 2.0 * rho * tan * length * d * d - 4.0 / 3.0 * rho * rho * tan * d * d * d;
            near(2.0 * sums.force.z, exact, EXACT);
            near(sums.vector_area.z, 2.0 * tan * d * length, EXACT);
            near(sums.depth, 2.0 * rho * d, EXACT);
            assert!(sums.force.truncate().length() < 1e-12 * sums.weight);
        }
    }
}

/// The section of an edge that leans has the base `(t1 + t2) d`, the area `alpha d²` and the radius `rho d` with
/// `alpha = (t1 + t2)/2` and `rho = 2 alpha/(2 alpha + 1/c1 + 1/c2)`, sides over cosines: `F = 2 kn alpha rho (L d² - 2/3 rho d³)`.
/// The work on the way in is the energy of the prism.
#[test]
fn prism() {
    for (lean, length) in [([20.0_f64, 65.0_f64], 1.3), ([0.0, 50.0], 0.9), ([-25.0, 60.0], 2.0)] {
        let [first, second] = lean.map(|angle| libm::sincos(angle.to_radians()));
        let alpha = 0.5 * (first.0 / first.1 + second.0 / second.1);
        let rho = 2.0 * alpha / (2.0 * alpha + 1.0 / first.1 + 1.0 / second.1);
        let force = |d: f64| 2.0 * touch(&floor(), &edge(lean, length, d)).0.force.z;
        for d in DEPTHS {
            let exact = 2.0 * alpha * rho * (length * d * d - 2.0 / 3.0 * rho * d * d * d);
            near(force(d), exact, EXACT);
        }
        // Nearly to where its upper side comes to the surface.
        let d = 0.999;
        let (section, radius) = (alpha * d * d, rho * d);
        let stored = 2.0 * section * radius * (length / 3.0 - radius / 6.0);
        near(energy(d, force), stored, EXACT);
    }
    // A bar 0.3 m wide, pressed flat into the floor by as much: the section of its overlap is a square.
    let (length, side) = (1.1, 0.3);
    let flat = |d: f64| {
        let half = 0.5 * Vec3::new(length, side, 1.0);
        let at = Pose::at(Vec3::new(0.2, -0.1, half.z - d));
        2.0 * touch(&floor(), &(Shape::brick(half).unwrap(), at)).0.force.z
    };
    let radius = 0.5 * side;
    let stored = 2.0 * side * side * radius * (length / 3.0 - radius / 6.0);
    near(energy(side, flat), stored, EXACT);
}

/// A tetrahedron whose lowest corner is at depth `d` and whose opposite side is level at `1 - d`: what is in the floor is it, made smaller
/// by `d`. Corners that lean so far that their sides overhang are among them.
fn corner(chance: &mut Chance) -> [Vec3; 3] {
    loop {
        let edges = [0; 3].map(|_| {
            let (sin, cos) = libm::sincos(chance.between(0.0, std::f64::consts::TAU));
            let out = libm::tan(chance.between(5.0, 70.0).to_radians());
            Vec3::new(out * cos, out * sin, 1.0)
        });
        let [a, b, c] = edges.map(Vec3::normalize);
        if a.cross(b).dot(c).abs() > 0.1 {
            return edges;
        }
    }
}

fn on_corner(edges: [Vec3; 3], d: f64) -> (Shape, Pose) {
    let tip = Vec3::new(0.0, 0.0, -d);
    let [a, b, c] = edges.map(|edge| tip + edge);
    block(&[tip, a, b, c])
}

/// `V = c d³` and `r = rho d`: `F = 2 kn c rho d³ = 2 kn V r/d`, straight up and on the triangle that the floor shows. The moment is what
/// the energy loses as the block is turned about its corner.
#[test]
fn corner_of_three_faces() {
    let mut chance = Chance::new(31);
    let mut overhanging = 0;
    for _ in 0..20 {
        let edges = corner(&mut chance);
        let [a, b, c] = edges;
        let sides = [a.cross(b), b.cross(c), c.cross(a)].map(|n| n.z);
        overhanging += usize::from(sides.iter().any(|z| z.signum() != sides[0].signum()));
        for d in DEPTHS {
            let (sums, origin) = touch(&floor(), &on_corner(edges, d));
            let (volume, radius) = ball([Vec3::ZERO, d * a, d * b, d * c]);
            near(2.0 * sums.force.z, 2.0 * volume * radius / d, EXACT);
            near(sums.vector_area.z, 3.0 * volume / d, EXACT);
            near(sums.depth, 2.0 * radius, EXACT);
            assert!(sums.force.truncate().length() < 1e-11 * sums.weight);
            // U = V r/2 of the overlap when the block has been turned about its corner by an angle.
            let turned = |axis: Vec3, angle: f64| {
                let cut = edges.map(|edge| {
                    let edge = Quat::from_axis_angle(axis, angle) * edge;
                    d / edge.z * edge
                });
                let (volume, radius) = ball([Vec3::ZERO, cut[0], cut[1], cut[2]]);
                0.5 * volume * radius
            };
            let moment = 2.0 * (sums.moment + (origin + d * Vec3::Z).cross(sums.force));
            let size = 2.0 * sums.force.z * d;
            for axis in [Vec3::X, Vec3::Y] {
                // Central differences are off by the square of the angle, times the third derivative, which is large for flat edges.
                let angle = 1e-5;
                let slope = (turned(axis, angle) - turned(axis, -angle)) / (2.0 * angle);
                assert!(
                    (moment.dot(axis) + slope).abs() < 1e-6 * size,
                    "{:e} {slope:e} of {size:e}",
                    moment.dot(axis)
                );
            }
            assert!(moment.z.abs() < 1e-9 * size);
        }
    }
    assert!(overhanging > 3, "{overhanging}");
}

/// Regular pyramids of n sides whose middles lean by b from the axis: `c = n/3 tan² b tan(pi/n)` and `rho = sin b/(1 + sin b)`. The first is the
/// corner of a cube.
#[test]
fn corner_of_many_faces() {
    for (sides, lean) in [(3, 35.264_389_682_754_654_f64), (4, 45.0), (6, 20.0), (9, 70.0)] {
        let (sin, cos) = libm::sincos(lean.to_radians());
        let (tan, rho) = (sin / cos, sin / (1.0 + sin));
        let half = std::f64::consts::PI / f64::from(sides);
        let (half_sin, half_cos) = libm::sincos(half);
        let share = f64::from(sides) / 3.0 * tan * tan * half_sin / half_cos;
        for d in DEPTHS {
            let mut points = vec![Vec3::new(0.0, 0.0, -d)];
            points.extend((0..sides).map(|k| {
                let (sin, cos) = libm::sincos(2.0 * half * f64::from(k) + 0.1);
                Vec3::new(tan / half_cos * cos, tan / half_cos * sin, 1.0 - d)
            }));
            let (sums, _) = touch(&floor(), &block(&points));
            near(2.0 * sums.force.z, 2.0 * share * rho * d * d * d, EXACT);
            near(sums.vector_area.z, 3.0 * share * d * d, EXACT);
        }
    }
}

/// The work on the way in, until nothing is left above the floor, is the energy `kn V r/2` of the whole tetrahedron, whichever way it goes;
/// deeper there is no surface of equal pressure any more, and that is told with the ball that has gone in.
#[test]
fn whole_tetrahedron() {
    let mut chance = Chance::new(32);
    for _ in 0..20 {
        let edges = corner(&mut chance);
        let [a, b, c] = edges;
        let (volume, radius) = ball([Vec3::ZERO, a, b, c]);
        let push = |d: f64| {
            let mut tetrahedron = on_corner(edges, d);
            tetrahedron.1.position += d * Vec3::new(0.3, -0.2, 0.0);
            let force = 2.0 * touch(&floor(), &tetrahedron).0.force;
            // Against the way, per metre of depth.
            force.dot(Vec3::new(-0.3, 0.2, 1.0))
        };
        near(energy(1.0, push), 0.5 * volume * radius, EXACT);
        near(push(0.9999), 2.0 * volume * radius * 0.9999_f64.powi(3), 1e-9);
        match find(&floor(), &on_corner(edges, 1.1)) {
            Found::FullyPenetrated(depth) => near(depth, radius, EXACT),
            other => panic!("{other:?}"),
        }
    }
}

/// Edges of half angles `a` and `b` that cross at an angle `c`: the overlap has the edges `2 d tan b/sin c` and `2 d tan a/sin c`, and
/// `F = 4 U/d = 2 kn V r/d` as for a corner; half the cross product of its two edges is the area.
#[test]
fn crossed_edges_of_any_angles() {
    for (upper, lower, between) in
        [(45.0_f64, 45.0_f64, 90.0_f64), (30.0, 60.0, 90.0), (20.0, 70.0, 40.0), (75.0, 50.0, 25.0)]
    {
        let [upper, lower] = [upper, lower].map(|half| libm::tan(half.to_radians()));
        let (sin, cos) = libm::sincos(between.to_radians());
        // Edge of the upper block along x, of the lower one along u.
        let (u, beside) = (Vec3::new(cos, sin, 0.0), Vec3::new(-sin, cos, 0.0));
        let bar = |along: Vec3, aside: Vec3, up: f64, z: f64, tan: f64| {
            let edge = [-4.0, 4.0].map(|s| s * along + z * Vec3::Z);
            let far = |side: f64| edge.map(|p| p + side * tan * aside + up * Vec3::Z);
            block(&[edge, far(-1.0), far(1.0)].concat())
        };
        for d in DEPTHS {
            let below = bar(u, beside, -1.0, 0.0, lower);
            let above = bar(Vec3::X, Vec3::Y, 1.0, -d, upper);
            let (sums, _) = touch(&below, &above);
            let (low, high) = (d * lower / sin, d * upper / sin);
            let tip = Vec3::new(0.0, 0.0, -d);
            let overlap = [tip - low * Vec3::X, tip + low * Vec3::X, -high * u, high * u];
            let (volume, radius) = ball(overlap);
            near(2.0 * sums.force.z, 2.0 * volume * radius / d, EXACT);
            near(sums.vector_area.length(), 2.0 * low * high * sin, EXACT);
            near(sums.depth, 2.0 * radius, EXACT);
            assert!(sums.force.truncate().length() < 1e-11 * sums.weight);
        }
    }
}

/// Equal bricks, the upper one shifted by s along x: `U = kn (A d²/2 - P d³/12 + d⁴/12)` with `A = (a - |s|) b` and
/// `P = 2 (a - |s| + b)`, so that they push each other further by `kn (b d²/2 - d³/6)`, whichever way it is shifted. In the band of
/// ties, 1e-6 of the radius of a brick to either side, that force goes from one sign to the other in a straight line.
#[test]
fn sides_that_pass_each_other_push_aside() {
    let (a, b, c) = (1.0, 0.7, 0.5);
    let shape = Shape::brick(0.5 * Vec3::new(a, b, c)).unwrap();
    let at = |x: f64, z: f64| (shape.clone(), Pose::at(Vec3::new(x, 0.0, z)));
    for d in DEPTHS {
        let aside = b * d * d / 2.0 - d * d * d / 6.0;
        for s in [0.2, 1e-3, 1e-5, -1e-5, -0.03] {
            let (sums, _) = touch(&at(0.0, 0.0), &at(s, c - d));
            let (area, round) = ((a - s.abs()) * b, 2.0 * (a - s.abs() + b));
            let up = area * d - round * d * d / 4.0 + d * d * d / 3.0;
            near(2.0 * sums.force.z, up, EXACT);
            near(2.0 * sums.force.x, aside * s.signum(), 1e-9);
            assert!(sums.force.y.abs() < 1e-13);
        }
        for share in [-0.9, -0.5, 0.0, 0.25, 0.75] {
            let s = share * 1e-6 * shape.radius;
            let (sums, _) = touch(&at(0.0, 0.0), &at(s, c - d));
            let found = 2.0 * sums.force.x / aside;
            // The band is so narrow that round-off of the coordinate is 1e-10 of it.
            assert!((found - share).abs() < 1e-8, "{found} at {share}");
        }
    }
}
