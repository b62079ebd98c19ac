use super::*;

const G: f64 = 9.81;

fn table(points: &[[f64; 2]]) -> WaterTable {
    WaterTable {
        name: "water".to_owned(),
        density: 1000.0,
        along: [1.0, 0.0],
        points: points.to_vec(),
        seepage: None,
    }
}

/// A concave polygon (an L), from its centroid, and its area.
fn ell() -> (Vec<Vec2>, f64) {
    let outline = [
        [0.0, 0.0],
        [3.0, 0.0],
        [3.0, 1.0],
        [1.0, 1.0],
        [1.0, 4.0],
        [0.0, 4.0],
    ];
    let corners = outline.map(Vec2::from);
    let (area, centroid) = wet_part(&corners, [f64::NEG_INFINITY, f64::INFINITY], 0.0, 100.0);
    assert!((area - 6.0).abs() < 1e-14);
    (corners.iter().map(|c| *c - centroid).collect(), area)
}

fn on(table: &WaterTable, corners: &[Vec2], area: f64, centre: Vec2) -> (Vec2, f64) {
    let radius = corners.iter().map(|c| c.length()).fold(0.0, f64::max);
    table.on_polygon(G, centre, radius, area, corners.len(), |k| corners[k])
}

/// Force and moment by many thin pieces of the edges.
fn by_edges(table: &WaterTable, corners: &[Vec2], centre: Vec2) -> (Vec2, f64) {
    let (mut force, mut moment) = (Vec2::ZERO, 0.0);
    let pieces = 20_000;
    for (k, &a) in corners.iter().enumerate() {
        let along = corners[(k + 1) % corners.len()] - a;
        let inward = along.perp() / f64::from(pieces);
        for i in 0..pieces {
            let r = a + (f64::from(i) + 0.5) / f64::from(pieces) * along;
            let push = table.pressure(G, centre.x + r.x, centre.y + r.y) * inward;
            force += push;
            moment += r.perp_dot(push);
        }
    }
    (force, moment)
}

#[test]
fn the_table_is_found_at_any_distance() {
    let table = table(&[[0.0, 1.0], [2.0, 5.0], [3.0, 4.0]]);
    let heights = [
        (-9.0, 1.0),
        (0.0, 1.0),
        (1.0, 3.0),
        (2.0, 5.0),
        (2.5, 4.5),
        (7.0, 4.0),
    ];
    for (x, h) in heights {
        assert_eq!(table.height(x), h, "at {x}");
    }
    assert_eq!(table.strips(-1.0, 2.5).count(), 3);
    assert_eq!(table.strips(0.5, 1.0).count(), 1);
    assert_eq!(table.strips(2.0, 9.0).count(), 2);
    assert_eq!(table.heights(), [1.0, 5.0]);
    assert_eq!(table.pressure(G, 0.0, 2.0), 0.0);
    assert_eq!(table.pressure(G, 1.0, 1.0), 2000.0 * G);
}

#[test]
fn what_is_under_level_water_loses_the_weight_of_the_water() {
    let level = table(&[[0.0, 7.0]]);
    let (corners, area) = ell();
    for (x, y) in [(0.3, -20.0), (1e3, 0.5), (-4.0, 2.5)] {
        let (force, moment) = on(&level, &corners, area, Vec2::new(x, y));
        assert!((force - Vec2::new(0.0, 1000.0 * G * area)).length() < 1e-12 * force.length());
        assert!(moment.abs() < 1e-12 * force.length());
    }
    assert_eq!(
        on(&level, &corners, area, Vec2::new(0.0, 10.5)).0,
        Vec2::ZERO
    );
}

#[test]
fn the_push_is_the_sum_of_the_pressures_on_the_edges() {
    let (corners, area) = ell();
    let bent = table(&[[-1.0, 0.5], [0.4, 0.2], [1.3, 2.0], [4.0, 1.0]]);
    for (x, y, turn) in [
        (0.0, 0.0, 0.0),
        (0.7, 0.3, 0.4),
        (-1.5, -0.4, 2.0),
        (2.0, -3.0, -0.7),
    ] {
        let turned: Vec<Vec2> = corners
            .iter()
            .map(|c| Vec2::from_angle(turn).rotate(*c))
            .collect();
        let centre = Vec2::new(x, y);
        let (force, moment) = on(&bent, &turned, area, centre);
        let (expected, about) = by_edges(&bent, &turned, centre);
        let scale = expected.length();
        assert!(
            (force - expected).length() < 1e-6 * scale,
            "{force} {expected}"
        );
        assert!((moment - about).abs() < 1e-6 * scale, "{moment} {about}");
    }
}

#[test]
fn under_one_straight_line_the_push_is_the_same_everywhere() {
    let (corners, area) = ell();
    let slope = table(&[[-50.0, 0.0], [50.0, 30.0]]);
    let (force, moment) = on(&slope, &corners, area, Vec2::new(1.0, -20.0));
    let expected = 1000.0 * G * area * Vec2::new(-0.3, 1.0);
    assert!((force - expected).length() < 1e-12 * force.length());
    assert_eq!(moment, 0.0);
}

type Faces = Vec<Vec<Vec3>>;

/// Faces of a brick from its centre, turned.
fn brick(half: Vec3, turn: riprap_geom::Quat) -> Faces {
    let mut faces = Vec::new();
    for axis in 0..3 {
        for sign in [-1.0, 1.0] {
            let corner = |u: f64, v: f64| {
                let mut r = [0.0; 3];
                r[axis] = sign;
                r[(axis + 1) % 3] = u * sign;
                r[(axis + 2) % 3] = v;
                turn * (Vec3::from_array(r) * half)
            };
            faces.push(vec![
                corner(-1.0, -1.0),
                corner(1.0, -1.0),
                corner(1.0, 1.0),
                corner(-1.0, 1.0),
            ]);
        }
    }
    faces
}

fn on_faces(table: &WaterTable, faces: &Faces, volume: f64, centre: Vec3) -> (Vec3, Vec3) {
    let corners = faces.iter().flatten();
    let radius = corners.map(|c| c.length()).fold(0.0, f64::max);
    table.on_polyhedron(G, centre, radius, volume, |each| {
        for face in faces {
            each(face);
        }
    })
}

#[test]
fn a_floating_brick_displaces_what_is_below_the_water() {
    let level = table(&[[0.0, 2.0]]);
    let half = Vec3::new(1.0, 0.5, 0.75);
    let faces = brick(half, riprap_geom::Quat::IDENTITY);
    let (volume, draught) = (3.0, 0.6);
    let centre = Vec3::new(3.0, -1.0, 2.0 - draught + half.z);
    let (force, moment) = on_faces(&level, &faces, volume, centre);
    let expected = 1000.0 * G * 2.0 * draught;
    assert!((force - expected * Vec3::Z).length() < 1e-12 * expected);
    assert!(moment.length() < 1e-12 * expected);
}

#[test]
fn faces_and_volume_agree_in_space() {
    let turn = riprap_geom::Quat::from_scaled_axis(Vec3::new(0.4, -0.7, 1.1));
    let faces = brick(Vec3::new(1.0, 0.5, 0.75), turn);
    let mut slope = table(&[[-60.0, 0.0], [60.0, 24.0]]);
    slope.along = [0.6, 0.8];
    let centre = Vec3::new(1.0, 2.0, -10.0);
    let (force, moment) = on_faces(&slope, &faces, 3.0, centre);
    let expected = 3.0 * 1000.0 * G * Vec3::new(-0.12, -0.16, 1.0);
    assert!((force - expected).length() < 1e-12 * expected.length());
    assert_eq!(moment, Vec3::ZERO);
    // The same table with a corner above the block is no other table: now the faces are summed.
    slope.points.insert(1, [0.0, 12.0]);
    slope.points.insert(2, [2.5, 12.5]);
    let (force, moment) = on_faces(&slope, &faces, 3.0, centre);
    assert!((force - expected).length() < 1e-12 * expected.length());
    assert!(moment.length() < 1e-11 * expected.length());
}

#[test]
fn a_long_brick_across_the_table_is_pushed_as_its_section() {
    let bent = table(&[[-1.0, 0.5], [0.4, 0.2], [1.3, 2.0], [4.0, 1.0]]);
    let (half, angle) = (Vec3::new(1.5, 2.0, 0.8), 0.3);
    let turn = riprap_geom::Quat::from_scaled_axis(Vec3::new(0.0, -angle, 0.0));
    let centre = Vec3::new(0.7, 5.0, 0.4);
    let (force, moment) = on_faces(&bent, &brick(half, turn), 19.2, centre);
    let section = [[-1.5, -0.8], [1.5, -0.8], [1.5, 0.8], [-1.5, 0.8]];
    let section = section.map(|c| Vec2::from_angle(angle).rotate(Vec2::from(c)));
    let (flat, about) = on(&bent, &section, 4.8, Vec2::new(centre.x, centre.z));
    let expected = 4.0 * Vec3::new(flat.x, 0.0, flat.y);
    assert!((force - expected).length() < 1e-12 * force.length());
    // Anticlockwise in the x-z plane is about -y.
    assert!((moment + 4.0 * about * Vec3::Y).length() < 1e-11 * force.length());
}

#[test]
fn triangles_of_a_surface_add_up_to_what_its_faces_get() {
    let bent = table(&[[-1.0, 0.5], [0.4, 0.2], [1.3, 2.0], [4.0, 1.0]]);
    let turn = riprap_geom::Quat::from_scaled_axis(Vec3::new(0.4, -0.7, 1.1));
    let faces = brick(Vec3::new(1.0, 0.5, 0.75), turn);
    for centre in [
        Vec3::new(0.7, 5.0, 0.4),
        Vec3::new(2.0, 1.0, -9.0),
        Vec3::new(20.0, 1.0, 0.3),
        Vec3::new(0.0, 1.0, 30.0),
    ] {
        let (expected, about) = on_faces(&bent, &faces, 3.0, centre);
        let (mut force, mut moment) = (Vec3::ZERO, Vec3::ZERO);
        for face in &faces {
            for k in 2..4 {
                let corners = [face[0], face[k - 1], face[k]];
                let pushes = bent.on_triangle(G, corners.map(|r| centre + r));
                for (r, push) in corners.iter().zip(pushes) {
                    force += push;
                    moment += r.cross(push);
                }
            }
        }
        let scale = 3e4;
        assert!(
            (force - expected).length() < 1e-11 * scale,
            "{force} {expected}"
        );
        assert!(
            (moment - about).length() < 1e-11 * scale,
            "{moment} {about}"
        );
    }
}
