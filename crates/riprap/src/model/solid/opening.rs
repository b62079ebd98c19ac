//! Tunnels, shafts and pits: a profile along a line, its walls as joints, ramps, and bolts across walls.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use riprap_geom::polygon;
use riprap_geom::polyhedron::joints::{Extent, Joint};
use riprap_geom::{Vec2, Vec3};

use super::global;
use crate::model::builder::Builder;
use crate::scenario::language::{
    BenchRamp, BenchesProfile, CircleProfile, CutAlong, Excavation, Group, HorseshoeProfile,
    span_of,
};
use crate::scenario::{Diagnostic, Name, Quantity};
use crate::spatial::setup::{Bridges, Ended};

/// A count that is whole up to this is whole.
const WHOLE: f64 = 1e-9;

/// A profile along a straight line.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::model) struct Opening {
    from: Vec3,
    /// Unit vectors of the profile, to the right and up as seen along the line, and of the line.
    axes: [Vec3; 3],
    /// m.
    length: f64,
    /// Corners, anticlockwise as seen along the line, m.
    profile: Vec<Vec2>,
    /// Whether a side, from each corner to the next, can have bolts.
    walls: Vec<bool>,
    /// Equal parts along the line.
    rounds: u32,
    ramps: Vec<Way>,
}

/// A ramp: rock that is left between the face of a bench and a plane beside it.
#[derive(Clone, Debug, PartialEq)]
struct Way {
    /// Foot of the face in the profile, m.
    toe: Vec2,
    /// Height of the bench, and how far its face goes back on it, m.
    height: f64,
    back: f64,
    /// m.
    width: f64,
    /// Where along the line it begins to fall and where it is down, m.
    fall: [f64; 2],
}

impl Way {
    fn new(said: &BenchRamp, of: &BenchesProfile) -> Self {
        let (height, back) = height_and_back(of);
        let below = (said.bench_or_default() - 1) as f64;
        let start = said.start.as_ref().map_or(0.0, Quantity::si);
        Self {
            toe: Vec2::new(-below * (back + of.berm.si()), below * height),
            height,
            back,
            width: said.width.si(),
            fall: [start, start + height / said.grade.si()],
        }
    }

    /// Whether a point of the profile, m, at a distance along the line, m, is in it or on its face.
    fn holds(&self, point: Vec2, distance: f64) -> bool {
        let [start, end] = self.fall;
        let top = self.height * ((end - distance) / (end - start)).clamp(0.0, 1.0);
        let from = point - self.toe;
        let across = from.x + from.y * self.back / self.height;
        let slack = WHOLE * self.width;
        (0.0..top).contains(&from.y) && (-slack..=self.width).contains(&across)
    }

    /// Its top and its free side: corners in the profile, m, with the distance along the line, m.
    fn sides(&self) -> Vec<Vec<(Vec2, f64)>> {
        let [start, end] = self.fall;
        let corner =
            |across: f64, up: f64| self.toe + Vec2::new(across - up * self.back / self.height, up);
        let (wide, high) = (self.width, self.height);
        let edge = |at: f64, up: f64| [(corner(0.0, up), at), (corner(wide, up), at)];
        let [a, b] = edge(start, high);
        let [c, d] = edge(end, 0.0);
        let mut side = vec![(corner(wide, 0.0), 0.0), d, b];
        let mut all = vec![vec![a, b, d, c]];
        if start > 0.0 {
            let [e, f] = edge(0.0, high);
            side.push(f);
            all.push(vec![e, f, b, a]);
        }
        all.push(side);
        all
    }
}

/// Height of a bench and how far its face goes back on it, m.
fn height_and_back(said: &BenchesProfile) -> (f64, f64) {
    let (height, angle) = (said.height.si(), said.face_angle.si());
    (height, height * libm::cos(angle) / libm::sin(angle))
}

/// A regular polygon with the area of a circle, which stands on a side.
fn circle(said: &CircleProfile) -> Vec<Vec2> {
    let sides = said.sides_or_default();
    let step = TAU / sides as f64;
    let radius = said.radius.si() * (step / libm::sin(step)).sqrt();
    let corner = |k: u64| {
        let angle = -FRAC_PI_2 + (k as f64 + 0.5) * step;
        radius * Vec2::new(libm::cos(angle), libm::sin(angle))
    };
    (0..sides).map(corner).collect()
}

fn horseshoe(said: &HorseshoeProfile) -> Vec<Vec2> {
    let (half, sides) = (0.5 * said.width.si(), said.sides_or_default());
    let spring = (said.height.si() - half).max(0.0);
    let floor = [Vec2::new(-half, 0.0), Vec2::new(half, 0.0)];
    let corner = |k: u64| {
        let angle = PI * k as f64 / sides as f64;
        Vec2::new(half * libm::cos(angle), spring + half * libm::sin(angle))
    };
    let mut all: Vec<Vec2> = floor.into_iter().chain((0..=sides).map(corner)).collect();
    if spring <= WHOLE * half {
        // The arch begins at the floor.
        all.remove(2);
        all.pop();
    }
    all
}

/// The corners, and which sides are faces of benches.
fn benches(said: &BenchesProfile) -> (Vec<Vec2>, Vec<bool>) {
    let (height, back) = height_and_back(said);
    let count = said.count as usize;
    let top = count as f64 * height;
    let mut corners = vec![Vec2::new(said.floor.si(), 0.0), Vec2::new(said.floor.si(), top)];
    let mut faces = vec![false; 2];
    for k in (0..count).rev() {
        let toe = -(k as f64) * (back + said.berm.si());
        corners.push(Vec2::new(toe - back, (k + 1) as f64 * height));
        corners.push(Vec2::new(toe, k as f64 * height));
        faces.extend([true, false]);
    }
    (corners, faces)
}

impl Opening {
    /// What a table says, in coordinates shifted by `shift`, with the profile of its drawing; `None` where its polygon is none.
    fn new(said: &Excavation, drawn: Option<Vec<Vec2>>, shift: Vec3) -> Option<Self> {
        let (from, to) = (global(&said.from) + shift, global(&said.to) + shift);
        let along = (to - from).normalize();
        let level = along.cross(Vec3::Z);
        let axes = if level.length() > 1e-6 {
            let across = level.normalize();
            [across, across.cross(along), along]
        } else {
            // A shaft: north is up.
            [along.cross(Vec3::Y).normalize(), Vec3::Y, along]
        };
        let mut faces = None;
        let mut profile = if let Some(drawn) = drawn {
            drawn
        } else if let Some(said) = &said.circle {
            circle(said)
        } else if let Some(said) = &said.horseshoe {
            horseshoe(said)
        } else if let Some(said) = &said.benches {
            let (corners, of) = benches(said);
            faces = Some(of);
            corners
        } else {
            let points = said.polygon.iter().flatten();
            points.map(|[u, v]| Vec2::new(u.si(), v.si())).collect()
        };
        polygon::validate(&profile).ok()?;
        if polygon::signed_area(&profile) < 0.0 {
            profile.reverse();
        }
        let walls = faces.unwrap_or_else(|| vec![true; profile.len()]);
        let rounds = said.rounds_or_default() as u32;
        let ramps =
            said.benches.iter().flat_map(|of| of.ramps.iter().map(|ramp| Way::new(ramp, of)));
        let ramps = ramps.collect();
        Some(Self { from, axes, length: from.distance(to), profile, walls, rounds, ramps })
    }

    /// A point of the profile, m, at a distance along the line, m.
    fn at(&self, corner: Vec2, distance: f64) -> Vec3 {
        let [across, up, along] = self.axes;
        self.from + corner.x * across + corner.y * up + distance * along
    }

    /// The part along the line in which a point lies, from 0.
    pub(in crate::model) fn round_of(&self, point: Vec3) -> Option<u32> {
        let arm = point - self.from;
        let [u, v, distance] = self.axes.map(|axis| arm.dot(axis));
        let place = Vec2::new(u, v);
        let inside = (0.0..=self.length).contains(&distance)
            && polygon::contains(&self.profile, place)
            && !self.on_ramp(place, distance);
        let part = (f64::from(self.rounds) * distance / self.length) as u32;
        inside.then_some(part.min(self.rounds - 1))
    }

    fn on_ramp(&self, place: Vec2, distance: f64) -> bool {
        self.ramps.iter().any(|ramp| ramp.holds(place, distance))
    }

    /// Number of its parts along the line.
    pub(in crate::model) fn rounds(&self) -> u32 {
        self.rounds
    }

    /// The middle of it, m.
    pub(in crate::model) fn middle(&self) -> Vec3 {
        let bounds = polygon::Aabb::of(&self.profile);
        self.at(bounds.centre(), 0.5 * self.length)
    }

    /// Its surface, and the faces between its parts, as joints.
    pub(super) fn surface(&self) -> Result<Vec<Joint>, &'static str> {
        let sides = polygon::edges(&self.profile).map(|(a, b)| {
            let ends = [0.0, self.length];
            Joint::polygon(&[
                self.at(a, ends[0]),
                self.at(b, ends[0]),
                self.at(b, ends[1]),
                self.at(a, ends[1]),
            ])
        });
        let bounds = polygon::Aabb::of(&self.profile);
        let (low, high) = (bounds.min, bounds.max);
        let across = |distance: f64| {
            let corner = |corner: &Vec2| self.at(*corner, distance);
            let outline: Vec<Vec3> = if polygon::is_convex(&self.profile) {
                self.profile.iter().map(corner).collect()
            } else {
                // Joints are convex.
                let corners = [low, Vec2::new(high.x, low.y), high, Vec2::new(low.x, high.y)];
                corners.iter().map(corner).collect()
            };
            Joint::polygon(&outline)
        };
        let parts =
            (0..=self.rounds).map(|k| across(self.length * f64::from(k) / f64::from(self.rounds)));
        let ramps = self.ramps.iter().flat_map(Way::sides).map(|side| {
            let corners = side.iter().map(|(corner, distance)| self.at(*corner, *distance));
            Joint::polygon(&corners.collect::<Vec<_>>())
        });
        sides.chain(parts).chain(ramps).collect()
    }

    /// Places of bolts on the wall of the profile (m), with the direction into the rock, for walls at most `half_angle` (rad) from
    /// the upward direction.
    fn row(&self, spacing: f64, half_angle: f64) -> Vec<(Vec2, Vec2)> {
        let sides: Vec<(Vec2, Vec2)> = polygon::edges(&self.profile).collect();
        let count = sides.len();
        let outward = |k: usize| {
            let way = (sides[k].1 - sides[k].0).normalize();
            Vec2::new(way.y, -way.x)
        };
        let taken =
            |k: usize| self.walls[k] && outward(k).y >= libm::cos(half_angle.min(PI)) - WHOLE;
        // Walls that follow each other are one: it begins behind a side without bolts, if there is one.
        let start = (0..count).find(|k| !taken(*k)).map_or(0, |k| k + 1);
        let order: Vec<usize> = (start..start + count).map(|k| k % count).collect();
        let mut row = Vec::new();
        for wall in order.chunk_by(|a, b| taken(*a) == taken(*b)).filter(|w| taken(w[0])) {
            let length = |k: &usize| sides[*k].0.distance(sides[*k].1);
            let whole: f64 = wall.iter().map(length).sum();
            // A closed wall has no ends.
            let closed = wall.len() == count;
            let n = match closed {
                true => (whole / spacing).round().max(1.0),
                false => (whole / spacing + WHOLE).floor().max(1.0),
            };
            let step = if closed { whole / n } else { spacing };
            let first = 0.5 * (whole - (n - 1.0) * step);
            let (mut side, mut passed) = (0, 0.0);
            for k in 0..n as u64 {
                let place = first + k as f64 * step;
                while side + 1 < wall.len() && place > passed + length(&wall[side]) {
                    passed += length(&wall[side]);
                    side += 1;
                }
                let (a, b) = sides[wall[side]];
                row.push((a + (place - passed) * (b - a).normalize(), outward(wall[side])));
            }
        }
        row
    }

    /// Heads and toes of bolts across the walls, m: at these distances along the wall and along the line, of this length.
    pub(in crate::model) fn bolts(
        &self,
        [spacing, rows, length]: [f64; 3],
        half_angle: f64,
    ) -> Vec<(Vec3, Vec3)> {
        let row = self.row(spacing, half_angle);
        // The first row stands half of `rows` behind the beginning; in a shorter opening the one row is in its middle.
        let short = self.length < 0.5 * rows;
        let first = if short { 0.5 * self.length } else { 0.5 * rows };
        // None stands at the very end.
        let count = ((self.length - first) / rows - WHOLE).ceil().max(1.0);
        let lines = (0..count as u64).flat_map(|k| {
            let distance = first + k as f64 * rows;
            let free = row.iter().filter(move |(place, _)| !self.on_ramp(*place, distance));
            free.map(move |(place, into)| {
                (self.at(*place, distance), self.at(*place + length * *into, distance))
            })
        });
        lines.collect()
    }

    /// About how many bolts that are.
    pub(in crate::model) fn bolts_about(&self, spacing: f64, rows: f64) -> f64 {
        let around: f64 = polygon::edges(&self.profile).map(|(a, b)| a.distance(b)).sum();
        (around / spacing).max(1.0) * (self.length / rows).max(1.0)
    }
}

impl Builder<'_> {
    /// The excavation of a group in coordinates shifted by `shift`; `None` after an error.
    pub(in crate::model) fn opening(&mut self, said: &Excavation, shift: Vec3) -> Option<Opening> {
        let drawn = match &said.profile {
            Some(said) => Some(self.drawn_profile(said)?),
            None => None,
        };
        let opening = Opening::new(said, drawn, shift);
        if opening.is_none() {
            let at = said.polygon.as_ref().and_then(|p| p.first()).map(|p| p[0].span.clone());
            let help = "list at least three corners in order along the boundary, which must not cross itself";
            let at = at.unwrap_or_else(|| span_of(&said.from));
            self.error_at("polygon.crossing", at, "the profile is no polygon", help);
        }
        opening
    }

    /// Joints along the surfaces of groups; rock that is still whole where there is an interface for it. `None` after an error.
    pub(super) fn joints_along(&mut self, said: &CutAlong, shift: Vec3) -> Option<Vec<Joint>> {
        let mut joints = Vec::new();
        for name in &said.groups {
            let groups = &self.parsed.scenario.groups;
            let Some(group) = groups.get(name.as_str()) else {
                let known: Vec<&str> = groups.names().collect();
                self.found.push(Diagnostic::unknown("group in [groups]", name, known));
                return None;
            };
            joints.extend(self.surface_of(name, group, shift)?);
        }
        if let Some(name) = &said.interface {
            let whole = joints.iter().map(|joint| {
                let size = match &joint.extent {
                    Extent::Polygon(corners) => {
                        corners.iter().map(|c| c.distance(joint.at)).fold(0.0, f64::max)
                    }
                    Extent::Whole | Extent::Partly(_) | Extent::Disk(_) => 1.0,
                };
                Ended::none(joint.normal, joint.at, size)
            });
            let whole = whole.collect();
            let row = self.interface_row(name)?;
            self.spatial.bridges.push(Bridges::new(row, whole));
        }
        Some(joints)
    }

    /// The surface of the region of a group; `None` after an error.
    fn surface_of(&mut self, name: &Name, group: &Group, shift: Vec3) -> Option<Vec<Joint>> {
        let made = if let Some(said) = &group.excavation {
            self.opening(said, shift)?.surface()
        } else if let Some(said) = &group.region {
            Ok(walls_of_box(Vec3::from(said.min.xyz()) + shift, Vec3::from(said.max.xyz()) + shift))
        } else if let Some(said) = &group.half_space {
            let normal = Vec3::from(said.normal.xyz()).normalize();
            let at = Vec3::from(said.at.xyz()) + shift;
            Ok(vec![Joint { normal, at, extent: Extent::Whole }])
        } else {
            let message = format!("group `{name}` has no surface to cut along");
            let help = "give it an `excavation`, a `box` or a `half_space`";
            self.error_at("group.surface", name, message, help);
            return None;
        };
        match made {
            Ok(joints) => Some(joints),
            Err(what) => {
                let message = format!("a wall of `{name}` {what}");
                self.error_at("group.surface", name, message, "check the profile and its units");
                None
            }
        }
    }

    /// Number of an interface; `None` after an error.
    pub(super) fn interface_row(&mut self, name: &Name) -> Option<u16> {
        let table = &self.parsed.scenario.interfaces;
        let row = table.names().position(|one| one == name.as_str());
        if row.is_none() {
            let known: Vec<&str> = table.names().collect();
            self.found.push(Diagnostic::unknown("interface", name, known));
        }
        row.map(|row| row as u16)
    }
}

/// The six faces of a box.
fn walls_of_box(min: Vec3, max: Vec3) -> Vec<Joint> {
    let mut walls = Vec::with_capacity(6);
    let (middle, half) = (0.5 * (min + max), 0.5 * (max - min));
    for k in 0..3 {
        let (a, b) = (Vec3::AXES[(k + 1) % 3], Vec3::AXES[(k + 2) % 3]);
        for side in [-1.0, 1.0] {
            let at = middle + side * half.dot(Vec3::AXES[k]) * Vec3::AXES[k];
            let (a, b) = (half.dot(a) * a, half.dot(b) * b);
            let corners = vec![at - a - b, at + a - b, at + a + b, at - a + b];
            let extent = Extent::Polygon(corners);
            walls.push(Joint { normal: Vec3::AXES[k], at, extent });
        }
    }
    walls
}

#[cfg(test)]
mod tests {
    use super::*;

    fn round(sides: usize) -> Opening {
        let step = TAU / sides as f64;
        let corner = |k: usize| {
            let angle = -FRAC_PI_2 + (k as f64 + 0.5) * step;
            2.0 * Vec2::new(libm::cos(angle), libm::sin(angle))
        };
        Opening {
            from: Vec3::ZERO,
            axes: [Vec3::X, Vec3::Z, Vec3::Y],
            length: 6.0,
            profile: (0..sides).map(corner).collect(),
            walls: vec![true; sides],
            rounds: 3,
            ramps: Vec::new(),
        }
    }

    #[test]
    fn bolts_stand_across_the_walls_that_face_up() {
        let tunnel = round(12);
        // All around: they divide the wall evenly.
        assert_eq!(tunnel.bolts([1.0, 2.0, 3.0], PI).len(), 12 * 3);
        // Rows of 6 m in length, each half of their distance from the beginning and less than it from the end.
        for (rows, at) in
            [(4.0, vec![2.0]), (3.9, vec![1.95, 5.85]), (9.0, vec![4.5]), (30.0, vec![3.0])]
        {
            let mut places: Vec<f64> =
                tunnel.bolts([1.0, rows, 3.0], PI).iter().map(|(head, _)| head.y).collect();
            places.dedup();
            assert_eq!(places.len(), at.len(), "{places:?}");
            assert!(places.iter().zip(&at).all(|(a, b)| (a - b).abs() < 1e-9), "{places:?}");
        }
        for (head, toe) in tunnel.bolts([0.8, 2.0, 3.0], 0.6) {
            assert!((head.distance(toe) - 3.0).abs() < 1e-12 && head.y == toe.y);
            let into = (toe - head) / 3.0;
            assert!(into.z >= libm::cos(0.6), "{into}");
            // On a side of the profile, whose middle is cos(15 deg) of the radius away.
            assert!((head.dot(into) - 2.0 * libm::cos(PI / 12.0)).abs() < 1e-12);
        }
    }

    #[test]
    fn parts_follow_each_other_along_the_line() {
        let tunnel = round(8);
        let at = |y: f64| tunnel.round_of(Vec3::new(0.5, y, -0.5));
        assert_eq!([at(-0.1), at(0.1), at(2.1), at(6.0)], [None, Some(0), Some(1), Some(2)]);
        assert_eq!(tunnel.round_of(Vec3::new(0.0, 1.0, 2.1)), None);
        assert_eq!(tunnel.surface().unwrap().len(), 8 + 4);
    }

    #[test]
    fn joints_of_a_box_enclose_it() {
        let joints = walls_of_box(Vec3::ZERO, Vec3::new(1.0, 2.0, 3.0));
        for joint in &joints {
            let Extent::Polygon(corners) = &joint.extent else { panic!("a polygon") };
            let same = Joint::polygon(corners).unwrap();
            assert!((same.normal - joint.normal).length() < 1e-12, "anticlockwise");
        }
        assert_eq!(joints.len(), 6);
    }
}
