//! A cell as its planes and the corners where three of them meet: quick to cut, and it knows whose planes make a corner.
//!
//! Cutting takes away the corners beyond the plane; along every edge that leaves the rest the plane makes a corner with the two
//! planes of the edge (the way of Ray, Sokolov, Lefebvre & Lévy 2018, ACM Trans. Graph. 37(6)). A plane that only touches is left out, so
//! that every corner has three planes.

use super::super::Polyhedron;
use crate::{Mat3, Vec3};

/// A plane nearer than this, times its distance from the site, to a corner goes through it: where sites stand in rows a fourth plane goes
/// through the lines in which two others meet, and makes no corner with these.
const TOUCH: f64 = 1e-9;

/// A plane `normal . x = offset` of a cell; the normal has any length, places are from the site of the cell.
#[derive(Clone, Copy, Debug)]
pub(super) struct Plane {
    pub(super) normal: Vec3,
    pub(super) offset: f64,
    /// The site beyond it; a face of the whole solid has none.
    pub(super) site: Option<u32>,
}

/// Where three planes meet, anticlockwise as seen from outside, and where that is.
#[derive(Clone, Copy, Debug)]
pub(super) struct Corner {
    pub(super) planes: [u16; 3],
    pub(super) at: Vec3,
}

/// A convex cell, places from its site.
#[derive(Clone, Debug, Default)]
pub(super) struct Cell {
    pub(super) planes: Vec<Plane>,
    pub(super) corners: Vec<Corner>,
    /// Square of the distance of the farthest corner from the site, m².
    pub(super) reach: f64,
}

/// Corners of a solid whose corners are each on three faces, as a start of cells.
pub(super) struct Whole {
    /// Outward unit normals and offsets of the faces.
    pub(super) planes: Vec<(Vec3, f64)>,
    corners: Vec<([u16; 3], Vec3)>,
}

impl Whole {
    /// `None` if some corner is not on three faces.
    pub(super) fn new(solid: &Polyhedron) -> Option<Self> {
        let planes: Vec<(Vec3, f64)> = (0..solid.faces.len()).map(|f| solid.plane(f)).collect();
        let mut corners = Vec::with_capacity(solid.vertices.len());
        for (number, at) in (0u32..).zip(&solid.vertices) {
            let on = (0u16..).zip(&solid.faces).filter(|(_, face)| face.contains(&number));
            let [a, b, c] = *on.map(|(face, _)| face).collect::<Vec<_>>() else { return None };
            let normal = |face: u16| planes[usize::from(face)].0;
            let turns = normal(a).cross(normal(b)).dot(normal(c)) > 0.0;
            corners.push((if turns { [a, b, c] } else { [b, a, c] }, *at));
        }
        Some(Self { planes, corners })
    }

    pub(super) fn holds(&self, point: Vec3) -> bool {
        self.planes.iter().all(|(normal, offset)| normal.dot(point) < *offset)
    }
}

/// Volume and centroid of a cell, and `int (x - centroid)(x - centroid)^T dV`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Spread {
    pub(super) volume: f64,
    pub(super) centroid: Vec3,
    pub(super) second: Mat3,
}

impl Cell {
    /// The whole solid as the cell of a site.
    pub(super) fn start(&mut self, whole: &Whole, site: Vec3) {
        self.planes.clear();
        self.corners.clear();
        let from_site = |&(normal, offset): &(Vec3, f64)| {
            let offset = offset - normal.dot(site);
            Plane { normal, offset, site: None }
        };
        self.planes.extend(whole.planes.iter().map(from_site));
        let corners = whole.corners.iter();
        self.corners.extend(corners.map(|&(planes, at)| Corner { planes, at: at - site }));
        self.measure();
    }

    fn measure(&mut self) {
        let squares = self.corners.iter().map(|corner| corner.at.length_squared());
        self.reach = squares.fold(0.0, f64::max);
    }

    /// Cuts away what lies beyond a plane; whether there was anything.
    pub(super) fn cut(&mut self, plane: Plane, removed: &mut Vec<[u16; 3]>) -> bool {
        removed.clear();
        let limit = plane.offset * (1.0 + TOUCH);
        let beyond = |corner: &Corner| plane.normal.dot(corner.at) > limit;
        self.corners.retain(|corner| {
            let goes = beyond(corner);
            if goes {
                removed.push(corner.planes);
            }
            !goes
        });
        if removed.is_empty() {
            return false;
        }
        let new = self.planes.len() as u16;
        self.planes.push(plane);
        for &[a, b, c] in &*removed {
            for (from, to) in [(a, b), (b, c), (c, a)] {
                // The corner at the other end of this edge has its planes in the other order.
                let twin = |[a, b, c]: [u16; 3]| [(a, b), (b, c), (c, a)].contains(&(to, from));
                if removed.iter().any(|other| twin(*other)) {
                    continue;
                }
                let planes = [from, to, new];
                self.corners.push(Corner { planes, at: self.meeting(planes) });
            }
        }
        self.measure();
        true
    }

    fn meeting(&self, planes: [u16; 3]) -> Vec3 {
        let [a, b, c] = planes.map(|k| self.planes[usize::from(k)]);
        let [ab, bc, ca] =
            [a.normal.cross(b.normal), b.normal.cross(c.normal), c.normal.cross(a.normal)];
        (a.offset * bc + b.offset * ca + c.offset * ab) / a.normal.dot(bc)
    }

    /// Directed edges of the faces: the face, the plane beside it, and the corners at both ends.
    pub(super) fn edges(&self) -> Vec<(u16, u16, usize, usize)> {
        let planes = self.planes.len();
        let pair = |a: u16, b: u16| usize::from(a) * planes + usize::from(b);
        // The corner where one plane follows another.
        let mut follows = vec![u16::MAX; planes * planes];
        for (number, corner) in (0u16..).zip(&self.corners) {
            let [a, b, c] = corner.planes;
            for at in [pair(a, b), pair(b, c), pair(c, a)] {
                follows[at] = number;
            }
        }
        let mut edges = Vec::with_capacity(3 * self.corners.len());
        for (from, corner) in self.corners.iter().enumerate() {
            let [a, b, c] = corner.planes;
            // In the face, anticlockwise, the next corner is that where `beside` follows the face.
            for (face, beside) in [(a, c), (b, a), (c, b)] {
                let to = follows[pair(face, beside)];
                if to != u16::MAX {
                    edges.push((face, beside, from, usize::from(to)));
                }
            }
        }
        edges
    }

    /// Volume, centroid and second moments: sums over tetrahedra from the site, as for a solid.
    pub(super) fn spread(&self) -> Spread {
        let mut first_of = vec![u32::MAX; self.planes.len()];
        let (mut six_volumes, mut first, mut second) = (0.0, Vec3::ZERO, Mat3::ZERO);
        for (face, _, from, to) in self.edges() {
            let fan = &mut first_of[usize::from(face)];
            if *fan == u32::MAX {
                *fan = from as u32;
            }
            let [a, b, c] = [*fan as usize, from, to].map(|k| self.corners[k].at);
            let six = a.dot(b.cross(c));
            let sum = a + b + c;
            six_volumes += six;
            first += six * sum;
            second += six * (outer(a) + outer(b) + outer(c) + outer(sum));
        }
        let volume = six_volumes / 6.0;
        let centroid = first / (4.0 * six_volumes);
        let second = second * (1.0 / 120.0) - outer(centroid) * volume;
        Spread { volume, centroid, second }
    }
}

fn outer(v: Vec3) -> Mat3 {
    Mat3::from_cols(v.x * v, v.y * v, v.z * v)
}

#[cfg(test)]
mod tests {
    use super::super::super::{Sliced, slice};
    use super::*;
    use crate::random::Chance;

    /// Planes through a box leave the solid that slicing leaves, and its moments.
    #[test]
    fn cuts_are_those_of_slices() {
        let mut chance = Chance::new(11);
        let solid = Polyhedron::brick(Vec3::new(0.1, -0.2, 0.0), Vec3::new(1.0, 0.7, 0.5));
        let whole = Whole::new(&solid).unwrap();
        for _ in 0..50 {
            let site = Vec3::from_array([0; 3].map(|_| chance.between(-0.3, 0.3)));
            let (mut cell, mut sliced) = (Cell::default(), solid.clone());
            cell.start(&whole, site);
            for _ in 0..20 {
                let away = Vec3::from_array([0; 3].map(|_| chance.between(-1.0, 1.0)));
                let normal = away.normalize();
                let offset = chance.between(0.2, 0.8);
                let cuts = cell.cut(Plane { normal, offset, site: None }, &mut Vec::new());
                match slice(&sliced, normal, offset + normal.dot(site)) {
                    Sliced::Part(part) => sliced = part,
                    Sliced::Whole => assert!(!cuts),
                    Sliced::Nothing => unreachable!("the site stays inside"),
                }
            }
            let (own, wanted) = (cell.spread(), sliced.moments());
            assert!((own.volume / wanted.volume - 1.0).abs() < 1e-12);
            assert!((own.centroid + site - wanted.centroid).length() < 1e-12);
            let second = own.second;
            let trace = second.x_axis.x + second.y_axis.y + second.z_axis.z;
            let inertia = Mat3::IDENTITY * trace - second;
            let off = (inertia - wanted.inertia).to_cols_array();
            assert!(off.iter().all(|x| x.abs() < 1e-12));
            assert_eq!(cell.corners.len(), sliced.vertices.len());
        }
    }
}
