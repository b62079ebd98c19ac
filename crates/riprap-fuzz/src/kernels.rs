//! Kernels of geometry and contact, on shapes made of bytes.
//!
//! Two bytes are a number on a grid of 2^-7 from -1 to 1 (or of 2^-15): coarse ones meet in corners, edges and planes, where such kernels fail.

use riprap::geom::clip::{HalfPlane, clip_simple, intersection_area};
use riprap::geom::polygon::{self, signed_area};
use riprap::geom::polyhedron::cut::{Limits, Planes as Cuts, cut as cut_solid};
use riprap::geom::polyhedron::{Polyhedron, Sliced, hull, slice};
use riprap::geom::{Mat3, Quat, Vec2, Vec3};
use riprap::spatial::{Body, Found, Pair, Shape, Sums, Walker, turn};

/// Numbers from bytes.
struct Numbers<'a> {
    bytes: &'a [u8],
    coarse: bool,
}

impl<'a> Numbers<'a> {
    fn new(bytes: &'a [u8]) -> Self {
        Self {
            coarse: bytes.first().is_none_or(|first| first % 2 == 0),
            bytes: bytes.get(1..).unwrap_or_default(),
        }
    }

    /// A number from -1 to 1.
    fn next(&mut self) -> Option<f64> {
        let (two, rest) = self.bytes.split_at_checked(2)?;
        self.bytes = rest;
        let whole = i16::from_le_bytes([two[0], two[1]]);
        Some(if self.coarse { f64::from(whole >> 8) / 128.0 } else { f64::from(whole) / 32768.0 })
    }

    fn plane(&mut self) -> Option<Vec2> {
        Some(Vec2::new(self.next()?, self.next()?))
    }

    fn space(&mut self) -> Option<Vec3> {
        Some(Vec3::new(self.next()?, self.next()?, self.next()?))
    }

    /// At least `least`, then as many more as the next byte says, up to `most`.
    fn list<T>(
        &mut self,
        least: usize,
        most: usize,
        one: impl Fn(&mut Self) -> Option<T>,
    ) -> Option<Vec<T>> {
        let (first, rest) = self.bytes.split_first()?;
        self.bytes = rest;
        let count = least + usize::from(*first) % (most - least + 1);
        (0..count).map(|_| one(self)).collect()
    }
}

/// An anticlockwise polygon: its corners in the order of their directions from their middle.
fn polygon(numbers: &mut Numbers) -> Option<Vec<Vec2>> {
    let mut corners = numbers.list(3, 12, Numbers::plane)?;
    let middle = corners.iter().sum::<Vec2>() / corners.len() as f64;
    let angle = |v: &Vec2| libm::atan2(v.y - middle.y, v.x - middle.x);
    corners.sort_by(|a, b| angle(a).total_cmp(&angle(b)));
    polygon::validate(&corners).ok()?;
    Some(corners)
}

pub fn clip(bytes: &[u8]) -> bool {
    let mut numbers = Numbers::new(bytes);
    let Some([a, b]) = polygon(&mut numbers).zip(polygon(&mut numbers)).map(<[_; 2]>::from) else {
        return false;
    };
    let (Some(point), Some(direction)) = (numbers.plane(), numbers.plane()) else {
        return false;
    };
    let whole = signed_area(&a);
    let common = intersection_area(&a, &b);
    let back = intersection_area(&b, &a);
    let least = whole.min(signed_area(&b));
    assert!(
        common <= least * (1.0 + 1e-9) + 1e-12,
        "common area {common:e}, smaller polygon {least:e}"
    );
    assert!(
        (common - back).abs() <= 1e-9 * whole + 1e-12,
        "common area {common:e}, the other way {back:e}"
    );
    if direction == Vec2::ZERO {
        return true;
    }
    let half = |direction| clip_simple(&a, HalfPlane { point, direction });
    if let (Ok(left), Ok(right)) = (half(direction), half(-direction)) {
        let sum: f64 = left.iter().chain(&right).map(|p| signed_area(p)).sum();
        assert!((sum - whole).abs() <= 1e-9 * whole + 1e-12, "parts have {sum:e} of {whole:e}");
    }
    true
}

/// A polyhedron with a volume worth the name.
fn solid(numbers: &mut Numbers) -> Option<Polyhedron> {
    let points = numbers.list(4, 16, Numbers::space)?;
    let solid = hull(&points).ok()?;
    (solid.moments().volume > 1e-3).then_some(solid)
}

pub fn cut(bytes: &[u8]) -> bool {
    let mut numbers = Numbers::new(bytes);
    let Some(solid) = solid(&mut numbers) else {
        return false;
    };
    let (Some(normal), Some(at)) = (numbers.space(), numbers.space()) else {
        return false;
    };
    solid.validate().expect("a hull is sound");
    let whole = solid.moments().volume;
    // The faces of a hull are flat within 1e-6 of its size, and a cut divides them into other triangles.
    let slack = 1e-5 * solid.size() * solid.size() * solid.size();
    let count = 1 + u32::from(bytes[0] >> 1) % 7;
    if let Ok(done) = cut_solid(&solid, normal, Cuts::Anchored { count, at }, &Limits::default()) {
        let mut sum = 0.0;
        for part in &done.parts {
            // Corners near a plane count as in it, so that faces may be crooked; the surface is closed all the same.
            let faces = 0..part.solid.faces.len();
            let open: Vec3 = faces.map(|f| part.solid.area_vector(f)).sum();
            assert!(open.length() <= 1e-12, "the surface of a part is open by {:e}", open.length());
            let own = part.mesh.volume();
            assert!(own > 0.0, "a part has the volume {own:e}");
            sum += own;
        }
        assert!((sum - whole).abs() <= slack, "parts have {sum:e} of {whole:e}");
    }
    let unit = normal.normalize_or_zero();
    if unit == Vec3::ZERO {
        return true;
    }
    let volume = |n: Vec3| match slice(&solid, n, n.dot(at)) {
        Sliced::Whole => whole,
        Sliced::Nothing => 0.0,
        Sliced::Part(part) => part.moments().volume,
    };
    let sum = volume(unit) + volume(-unit);
    assert!((sum - whole).abs() <= slack, "halves have {sum:e} of {whole:e}");
    true
}

/// One block at the origin, the other turned and shifted: what is found of them as A and B and as B and A.
pub fn contact(bytes: &[u8]) -> bool {
    let mut numbers = Numbers::new(bytes);
    let Some([a, b]) = solid(&mut numbers).zip(solid(&mut numbers)).map(<[_; 2]>::from) else {
        return false;
    };
    let (Some(shift), Some(axis), Some(angle)) = (numbers.space(), numbers.space(), numbers.next())
    else {
        return false;
    };
    let shapes = [&a, &b].map(|solid| Shape::new(solid, solid.moments().centroid).ok());
    let [Some(a), Some(b)] = &shapes else {
        return false;
    };
    let axis = axis.normalize_or_zero();
    let rotation =
        if axis == Vec3::ZERO { Quat::IDENTITY } else { Quat::from_axis_angle(axis, 3.0 * angle) };
    let place = 2.0 * shift;
    let forth = meet([a, b], [(Quat::IDENTITY, Vec3::ZERO), (rotation, place)]);
    let back = meet([b, a], [(rotation, place), (Quat::IDENTITY, Vec3::ZERO)]);
    if let [Some(forth), Some(back)] = [forth, back] {
        let scale = forth.weight.abs().max(1e-9);
        assert!(forth.unlabelled == 0, "an edge of the surface is of no plane");
        for value in
            [forth.weight, forth.area, forth.depth, forth.force.length(), forth.moment.length()]
        {
            assert!(value.is_finite(), "a sum over the surface is {value}");
        }
        assert!(
            forth.area >= 0.0 && forth.depth >= 0.0,
            "area {:e}, depth {:e}",
            forth.area,
            forth.depth
        );
        assert!(
            (forth.force + back.force).length() <= 1e-6 * scale,
            "{:?} and {:?} do not balance",
            forth.force,
            back.force
        );
    }
    true
}

fn meet(shapes: [&Shape; 2], poses: [(Quat, Vec3); 2]) -> Option<Sums> {
    let mut normals = [Vec::new(), Vec::new()];
    let mut faces = [Vec::new(), Vec::new()];
    for s in 0..2 {
        turn(shapes[s], poses[s].0, &mut normals[s]);
        faces[s] = (0..shapes[s].faces() as u16).collect();
    }
    let bodies = [0, 1].map(|s| Body {
        shape: shapes[s],
        normals: &normals[s],
        turn: Mat3::from_quat(poses[s].0),
        position: poses[s].1,
    });
    let found = Walker::default().find(&Pair {
        bodies: [&bodies[0], &bodies[1]],
        faces: [&faces[0], &faces[1]],
        ties: true,
        hint: None,
        covered: [0; 2],
        witnesses: &[],
    });
    match found {
        Found::Touching(sums) => Some(sums),
        Found::Apart(_) | Found::FullyPenetrated(_) => None,
    }
}
