//! Block theory: whether a rigid block between joints can leave the rock, and how a force on it would move it.
//!
//! A block touches its neighbours by planes, given by unit normals into the block. It can go along `d` only if `n . d >= 0` for all of
//! them: these directions are its joint pyramid. It is removable if there is one besides zero, and tapered if not. A force `f` moves it
//! along the direction of the pyramid that is nearest to `f`, the projection of `f` onto it: `f` itself (falling), the projection
//! onto one plane (sliding on it) or onto a line of intersection (sliding on two); where the projection is zero the force
//! presses the block into its place and it stays without friction.
//!
//! Source: R. E. Goodman, G. Shi, Block Theory and Its Application to Rock Engineering (1985), chapters 4 (theorem of removability) and 9 (modes of
//! sliding); P. M. Warburton, Int. J. Rock Mech. Min. Sci. 18 (1981) 415-427.

use riprap_geom::Vec3;
use serde::{Deserialize, Serialize};

/// Sine of the angle below which two normals are one, and directions lie in a plane.
const SAME: f64 = 1e-7;

/// How a force would move a block.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Mode {
    /// It leaves all planes, or slips along some that do not press.
    Falling,
    /// It slides on this plane.
    Sliding(usize),
    /// It slides along the line of intersection of these planes.
    Wedge([usize; 2]),
    /// The force presses it into its place: it stays without friction.
    Held,
}

/// A motion that a force begins, without friction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Motion {
    /// Which planes it slides on.
    pub mode: Mode,
    /// Unit vector along it; zero where the block is held.
    pub direction: Vec3,
    /// Force along it, N.
    pub driving: f64,
    /// What presses the block on the planes it slides on, N; as many as the mode has.
    pub pressing: [f64; 2],
}

/// The different planes among `normals`, and which of them each one is.
#[must_use]
pub fn planes(normals: &[Vec3]) -> (Vec<Vec3>, Vec<usize>) {
    let mut all: Vec<Vec3> = Vec::new();
    let of = normals.iter().map(|n| {
        let known = all.iter().position(|m| n.dot(*m) > 0.0 && n.cross(*m).length() < SAME);
        known.unwrap_or_else(|| {
            all.push(*n);
            all.len() - 1
        })
    });
    let of = of.collect();
    (all, of)
}

/// A direction in which a block can leave these planes (unit normals into it), the middle of its pyramid; `None` if it is tapered.
#[must_use]
pub fn way_out(normals: &[Vec3]) -> Option<Vec3> {
    let opens = |d: Vec3| normals.iter().all(|n| n.dot(d) >= -SAME);
    // A pyramid with a tip is what its edges span.
    let mut middle = Vec3::ZERO;
    for (k, a) in normals.iter().enumerate() {
        for b in &normals[k + 1..] {
            let edge = a.cross(*b);
            if edge.length() > SAME {
                let edge = edge.normalize();
                let open = [edge, -edge].into_iter().filter(|d| opens(*d));
                middle += open.sum::<Vec3>();
            }
        }
    }
    // Away from all planes, for a pyramid without a tip: its edges are a line to both sides, or there are none.
    let away: Vec3 = normals.iter().copied().sum();
    let candidates = [middle + away, middle, away];
    let inside = candidates.into_iter().filter(|d| d.length() > SAME).map(Vec3::normalize);
    let mut inside = inside.filter(|d| opens(*d));
    let some = inside.next().or_else(|| edges(normals).find(|d| opens(*d)));
    some.or_else(|| normals.is_empty().then_some(-Vec3::Z))
}

/// Directions along which planes meet, and in one plane alone.
fn edges(normals: &[Vec3]) -> impl Iterator<Item = Vec3> + '_ {
    let lines = normals.iter().enumerate().flat_map(|(k, a)| {
        normals[k + 1..].iter().map(move |b| a.cross(*b)).filter(|e| e.length() > SAME)
    });
    let within = normals.first().map(|n| n.any_orthonormal_vector());
    lines.map(Vec3::normalize).chain(within).flat_map(|d| [d, -d])
}

/// How `force` (N) would move a block that touches others by planes with these different unit normals into it.
#[must_use]
pub fn motion(normals: &[Vec3], force: Vec3) -> Motion {
    let slack = SAME * force.length();
    let opens = |d: Vec3| normals.iter().all(|n| n.dot(d) >= -slack);
    let moves = |mode, along: Vec3, pressing| {
        let driving = along.length();
        Motion { mode, direction: along / driving, driving, pressing }
    };
    if slack > 0.0 && opens(force) {
        return moves(Mode::Falling, force, [0.0; 2]);
    }
    for (k, n) in normals.iter().enumerate() {
        let pressing = -n.dot(force);
        let along = force + pressing * *n;
        if pressing > slack && along.length() > slack && opens(along) {
            return moves(Mode::Sliding(k), along, [pressing, 0.0]);
        }
    }
    for (k, a) in normals.iter().enumerate() {
        for (l, b) in normals.iter().enumerate().skip(k + 1) {
            let edge = a.cross(*b);
            if edge.length() <= SAME {
                continue;
            }
            let along = force.dot(edge) / edge.length_squared() * edge;
            // `along - force` is what the two planes give back: `p a + q b`.
            let back = along - force;
            let (of_a, of_b, both) = (back.dot(*a), back.dot(*b), a.dot(*b));
            let share = edge.length_squared();
            let pressing = [(of_a - both * of_b) / share, (of_b - both * of_a) / share];
            let presses = pressing.iter().all(|p| *p >= -slack);
            if presses && along.length() > slack && opens(along) {
                return moves(Mode::Wedge([k, l]), along, pressing);
            }
        }
    }
    Motion { mode: Mode::Held, direction: Vec3::ZERO, driving: 0.0, pressing: [0.0; 2] }
}

#[cfg(test)]
mod tests {
    use super::*;

    const WEIGHT: Vec3 = Vec3::new(0.0, 0.0, -1.0);

    /// Three planes that dip by 60 deg and meet above (`up` = 1: they face down) or below a block.
    fn cone(up: f64) -> Vec<Vec3> {
        let side = |k: f64| {
            let (s, c) = libm::sincos(k * 2.0 * std::f64::consts::FRAC_PI_3);
            let dip = std::f64::consts::FRAC_PI_3;
            Vec3::new(libm::sin(dip) * c, libm::sin(dip) * s, -up * libm::cos(dip))
        };
        [0.0, 1.0, 2.0].map(side).to_vec()
    }

    #[test]
    fn a_roof_wedge_falls_and_one_in_the_floor_is_held() {
        let roof = cone(1.0);
        let down = way_out(&roof).unwrap();
        assert!((down - WEIGHT).length() < 1e-9, "{down}");
        assert_eq!(motion(&roof, WEIGHT).mode, Mode::Falling);
        let floor = cone(-1.0);
        assert!((way_out(&floor).unwrap() + WEIGHT).length() < 1e-9);
        assert_eq!(motion(&floor, WEIGHT).mode, Mode::Held);
        // Lifted out by water.
        assert_eq!(motion(&floor, -WEIGHT).mode, Mode::Falling);
    }

    #[test]
    fn a_block_that_tapers_towards_the_free_face_cannot_leave() {
        // A frustum in the roof, wider above: three sides that face up and a top.
        let mut tapered = cone(-1.0);
        tapered.push(-Vec3::Z);
        assert_eq!(way_out(&tapered), None);
        assert_eq!(motion(&tapered, WEIGHT).mode, Mode::Held);
        // One that is surrounded neither.
        let cube = [Vec3::X, -Vec3::X, Vec3::Y, -Vec3::Y, Vec3::Z, -Vec3::Z];
        assert_eq!(way_out(&cube), None);
        // Without one side it can, and only along it.
        assert_eq!(way_out(&cube[1..]), Some(-Vec3::X));
        assert_eq!(way_out(&cube[..5]), Some(Vec3::Z));
        // Between two parallel faces anywhere along them; from one face away, from none anywhere.
        let between = way_out(&cube[..2]).unwrap();
        assert!(between.x.abs() < 1e-12 && (between.length() - 1.0).abs() < 1e-12);
        assert_eq!(way_out(&cube[..1]), Some(Vec3::X));
        assert!(way_out(&[]).is_some());
    }

    #[test]
    fn one_plane_and_two() {
        let (s, c) = libm::sincos(0.6);
        let slope = Vec3::new(s, 0.0, c);
        let slides = motion(&[slope, Vec3::X], WEIGHT);
        assert_eq!(slides.mode, Mode::Sliding(0));
        assert!((slides.driving - s).abs() < 1e-12 && (slides.pressing[0] - c).abs() < 1e-12);
        assert!((slides.direction - Vec3::new(c, 0.0, -s)).length() < 1e-12);
        // A wall in front of it.
        assert_eq!(motion(&[slope, -Vec3::X], WEIGHT).mode, Mode::Held);
        // A trough of two such planes, plunging by 0.3: Hoek & Bray's symmetric wedge.
        let (sp, cp) = libm::sincos(0.3);
        let plunge = |n: Vec3| Vec3::new(n.x, cp * n.y + sp * n.z, -sp * n.y + cp * n.z);
        let trough = [plunge(slope), plunge(Vec3::new(-s, 0.0, c))];
        let slides = motion(&trough, WEIGHT);
        assert_eq!(slides.mode, Mode::Wedge([0, 1]));
        assert!((slides.driving - sp).abs() < 1e-12, "{slides:?}");
        assert!(slides.pressing.iter().all(|p| (p - cp / (2.0 * c)).abs() < 1e-12), "{slides:?}");
    }

    #[test]
    fn equal_normals_are_one_plane() {
        let near = Vec3::new(1e-9, 0.0, 1.0).normalize();
        let (all, of) = planes(&[Vec3::Z, Vec3::X, near, -Vec3::Z]);
        assert_eq!((all.len(), of), (3, vec![0, 1, 0, 2]));
    }
}
