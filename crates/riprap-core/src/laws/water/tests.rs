use super::*;

const G: f64 = 9.81;

fn table(points: &[[f64; 2]]) -> WaterTable {
    WaterTable {
        name: "water".to_owned(),
        density: 1000.0,
        along: [1.0, 0.0],
        points: points.to_vec(),
        ..WaterTable::default()
    }
}

/// A concave polygon (an L), from its centroid, and its area.
fn ell() -> (Vec<Vec2>, f64) {
    let outline = [[0.0, 0.0], [3.0, 0.0], [3.0, 1.0], [1.0, 1.0], [1.0, 4.0], [0.0, 4.0]];
    let corners = outline.map(Vec2::from);
    let (area, centroid) = wet_part(&corners, [f64::NEG_INFINITY, f64::INFINITY], 0.0, 100.0);
    assert!((area - 6.0).abs() < 1e-14);
    (corners.iter().map(|c| *c - centroid).collect(), area)
}

fn on(table: &WaterTable, corners: &[Vec2], area: f64, centre: Vec2) -> (Vec2, f64) {
    let radius = corners.iter().map(|c| c.length()).fold(0.0, f64::max);
    table.on_polygon(G, centre, radius, area, corners.len(), |k| corners[k], &|r| centre + r)
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
            let push = table.pressure(G, Vec3::new(centre.x + r.x, 0.0, centre.y + r.y)) * inward;
            force += push;
            moment += r.perp_dot(push);
        }
    }
    (force, moment)
}

#[test]
fn the_table_is_found_at_any_distance() {
    let table = table(&[[0.0, 1.0], [2.0, 5.0], [3.0, 4.0]]);
    let heights = [(-9.0, 1.0), (0.0, 1.0), (1.0, 3.0), (2.0, 5.0), (2.5, 4.5), (7.0, 4.0)];
    for (x, h) in heights {
        assert_eq!(table.height(x), h, "at {x}");
    }
    assert_eq!(table.strips(-1.0, 2.5).count(), 3);
    assert_eq!(table.strips(0.5, 1.0).count(), 1);
    assert_eq!(table.strips(2.0, 9.0).count(), 2);
    assert_eq!(table.pressure(G, Vec3::new(0.0, 0.0, 2.0)), 0.0);
    assert_eq!(table.pressure(G, Vec3::new(1.0, 0.0, 1.0)), 2000.0 * G);
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
    assert_eq!(on(&level, &corners, area, Vec2::new(0.0, 10.5)).0, Vec2::ZERO);
}

#[test]
fn the_push_is_the_sum_of_the_pressures_on_the_edges() {
    let (corners, area) = ell();
    let bent = table(&[[-1.0, 0.5], [0.4, 0.2], [1.3, 2.0], [4.0, 1.0]]);
    for (x, y, turn) in [(0.0, 0.0, 0.0), (0.7, 0.3, 0.4), (-1.5, -0.4, 2.0), (2.0, -3.0, -0.7)] {
        let turned: Vec<Vec2> = corners.iter().map(|c| Vec2::from_angle(turn).rotate(*c)).collect();
        let centre = Vec2::new(x, y);
        let (force, moment) = on(&bent, &turned, area, centre);
        let (expected, about) = by_edges(&bent, &turned, centre);
        let scale = expected.length();
        assert!((force - expected).length() < 1e-6 * scale, "{force} {expected}");
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
    let each = |each: &mut dyn FnMut(&[Vec3])| faces.iter().for_each(|face| each(face));
    table.on_polyhedron(G, centre, radius, volume, each, &|r| centre + r)
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

/// Nodes of a grid on a plane, and one that bends.
fn grid(height: impl Fn(f64, f64) -> f64) -> WaterTable {
    let (x, y) = (vec![-3.0, -1.0, 0.3, 2.0, 4.0], vec![-2.0, 0.1, 1.0, 3.0]);
    let z = y.iter().flat_map(|y| x.iter().map(|x| height(*x, *y)).collect::<Vec<_>>());
    let z = z.collect();
    WaterTable { grid: Some(Box::new(Grid { x, y, z })), ..table(&[]) }
}

#[test]
fn heights_on_a_plane_are_those_of_a_slope() {
    let turn = riprap_geom::Quat::from_scaled_axis(Vec3::new(0.4, -0.7, 1.1));
    let faces = brick(Vec3::new(1.0, 0.5, 0.75), turn);
    let plane = grid(|x, y| 0.3 * x - 0.2 * y + 1.0);
    let steep = 0.13_f64.sqrt();
    let mut slope = table(&[[-60.0, 1.0 - 60.0 * steep], [60.0, 1.0 + 60.0 * steep]]);
    slope.along = [0.3 / steep, -0.2 / steep];
    for centre in [Vec3::new(0.5, 0.4, 1.0), Vec3::new(1.0, 0.5, -9.0), Vec3::new(0.0, 0.0, 9.0)] {
        let (force, moment) = on_faces(&plane, &faces, 3.0, centre);
        let (expected, about) = on_faces(&slope, &faces, 3.0, centre);
        assert!((force - expected).length() < 1e-11 * 3e4, "{force} {expected}");
        assert!((moment - about).length() < 1e-11 * 3e4, "{moment} {about}");
    }
    // Beyond the rim it goes on as the nearest place of the rim.
    for (x, y, height) in [(0.0, 0.0, 1.0), (9.0, 0.5, 2.1), (9.0, -7.0, 2.6), (1.0, 5.0, 0.7)] {
        assert!((plane.level(x, y) - height).abs() < 1e-12, "{x} {y}");
    }
}

/// Sum over many small squares of the faces.
fn by_faces(table: &WaterTable, half: Vec3, turn: riprap_geom::Quat, centre: Vec3) -> (Vec3, Vec3) {
    let n = 200;
    let (mut force, mut moment) = (Vec3::ZERO, Vec3::ZERO);
    for face in brick(half, turn) {
        let (u, v) = (face[1] - face[0], face[3] - face[0]);
        let area = u.cross(v) / f64::from(n * n);
        for i in 0..n {
            for j in 0..n {
                let r =
                    face[0] + ((f64::from(i) + 0.5) * u + (f64::from(j) + 0.5) * v) / f64::from(n);
                let push = -table.pressure(G, centre + r) * area;
                force += push;
                moment += r.cross(push);
            }
        }
    }
    (force, moment)
}

#[test]
fn a_bent_grid_presses_by_the_depth_below_it() {
    let turn = riprap_geom::Quat::from_scaled_axis(Vec3::new(0.4, -0.7, 1.1));
    let half = Vec3::new(1.0, 0.5, 0.75);
    let bent = grid(|x, y| 1.0 + 0.2 * x * y - 0.1 * x * x);
    for centre in [Vec3::new(0.5, 0.4, 0.8), Vec3::new(3.5, 2.5, 0.0), Vec3::new(-1.0, 0.2, 0.3)] {
        let faces = brick(half, turn);
        let (force, moment) = on_faces(&bent, &faces, 3.0, centre);
        let (expected, about) = by_faces(&bent, half, turn, centre);
        assert!(expected.length() > 1e3);
        assert!((force - expected).length() < 1e-4 * 3e4, "{force} {expected}");
        assert!((moment - about).length() < 1e-4 * 3e4, "{moment} {about}");
        // And so do its triangles.
        let (mut sum, mut turning) = (Vec3::ZERO, Vec3::ZERO);
        for face in &faces {
            for k in 2..4 {
                let corners = [face[0], face[k - 1], face[k]];
                let pushes = bent.on_triangle(G, corners.map(|r| centre + r), corners);
                for (r, push) in corners.iter().zip(pushes) {
                    sum += push;
                    turning += r.cross(push);
                }
            }
        }
        assert!((sum - force).length() < 1e-11 * 3e4);
        assert!((turning - moment).length() < 1e-11 * 3e4);
    }
}

/// Two tables, one above the other, and a block that both press on: each on what of the faces lies in its zone.
#[test]
fn tables_act_where_they_say() {
    let zone = |low: f64, high: f64| {
        let wide = Vec3::new(50.0, 50.0, 0.0);
        let (low, high) = (Vec3::Z * low - wide, Vec3::Z * high + wide);
        Some(Zone { low, high })
    };
    let (upper, lower) = (table(&[[0.0, 2.0]]), table(&[[-9.0, 0.0], [9.0, 1.8]]));
    let both = WaterTable {
        parts: vec![
            WaterTable { zone: zone(0.5, 50.0), ..upper },
            WaterTable { zone: zone(-50.0, 0.4), ..lower },
        ],
        ..WaterTable::default()
    };
    let turn = riprap_geom::Quat::from_scaled_axis(Vec3::new(0.4, -0.7, 1.1));
    let half = Vec3::new(1.0, 0.5, 0.75);
    let faces = brick(half, turn);
    for z in [0.3, 0.9, -5.0, 9.0] {
        let centre = Vec3::new(0.5, 0.4, z);
        let (force, moment) = on_faces(&both, &faces, 3.0, centre);
        let (expected, about) = by_faces(&both, half, turn, centre);
        assert!((force - expected).length() < 2e-3 * 3e4, "{force} {expected}");
        assert!((moment - about).length() < 2e-3 * 3e4, "{moment} {about}");
        let mut sum = Vec3::ZERO;
        for face in &faces {
            for k in 2..4 {
                let corners = [face[0], face[k - 1], face[k]].map(|r| centre + r);
                sum += both.on_triangle(G, corners, corners).iter().sum::<Vec3>();
            }
        }
        assert!((sum - force).length() < 1e-11 * 3e4);
    }
    // In the plane, with the height as z.
    let (corners, area) = ell();
    for y in [0.3, 2.0, -9.0] {
        let centre = Vec2::new(0.3, y);
        let (force, moment) = on(&both, &corners, area, centre);
        let (expected, about) = by_edges(&both, &corners, centre);
        assert!((force - expected).length() < 1e-3 * 6e4, "{force} {expected}");
        assert!((moment - about).abs() < 1e-3 * 6e4, "{moment} {about}");
    }
}

/// A joint belongs to the table in whose zone it was, wherever its sides are now.
#[test]
fn both_sides_of_a_joint_go_on_with_one_table() {
    let table = WaterTable {
        zone: Some(Zone { low: Vec3::new(-9.0, -9.0, -1e-6), high: Vec3::splat(9.0) }),
        ..table(&[[0.0, 4.0]])
    };
    let level =
        [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]].map(|[x, y]| Vec3::new(x, y, 0.0));
    let below: Faces = vec![level.to_vec()];
    let sunk = |by: f64| {
        let each = |each: &mut dyn FnMut(&[Vec3])| below.iter().for_each(|face| each(face));
        let at_start = |r: Vec3| r;
        table.on_polyhedron(G, Vec3::new(0.0, 0.0, -by), 2.0, 1.0, each, &at_start).0
    };
    assert!((sunk(0.0).z + 4.0 * 4000.0 * G).abs() < 1e-6);
    assert!((sunk(0.01).z + 4.0 * 4010.0 * G).abs() < 1e-6);
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
                let pushes = bent.on_triangle(G, corners.map(|r| centre + r), corners);
                for (r, push) in corners.iter().zip(pushes) {
                    force += push;
                    moment += r.cross(push);
                }
            }
        }
        let scale = 3e4;
        assert!((force - expected).length() < 1e-11 * scale, "{force} {expected}");
        assert!((moment - about).length() < 1e-11 * scale, "{moment} {about}");
    }
}
