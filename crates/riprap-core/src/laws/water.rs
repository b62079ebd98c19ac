//! Standing water: the pressure below a water table, and what it does to blocks.
//!
//! ```text
//! p(x, z) = rho g max(0, h(x) - z)           h: height of the table above x
//! ```
//!
//! acts on all of the surface of a block, in joints from both sides and in the open: a joint therefore carries what of the total
//! normal stress the water does not (Terzaghi's effective stress), and uplift is balanced. By the theorem of Gauss the sum over the surface is
//!
//! ```text
//! F = - int grad p dV        M = - int r x grad p dV        over the part of the block below the table
//! ```
//!
//! `h` is linear in each [`Strip`], so that `grad p = rho g (h', -1)` is constant there, and a block that lies in one strip and
//! below the table is pushed by `rho g V (-h', 1)` at its centroid. The force has the potential `int p dV`.
//!
//! A table may be heights on a grid ([`Grid`]), act only in a [`Zone`], or be several tables of which each has its zone. Which faces lie in a zone is
//! decided where blocks are at the start, so that both sides of a joint belong to the same table however they move; the pressure is that of where they are.
//!
//! Source: E. Hoek and J. W. Bray, Rock Slope Engineering, chapter 7 (pressures by depth below the phreatic surface).

mod grid;
mod zone;

use riprap_geom::{Vec2, Vec3};
use serde::{Deserialize, Serialize};

use super::seepage::Steady;
pub use grid::Grid;
pub use zone::Zone;

/// A water table: its height over the distance along one horizontal direction, or on a grid; or several tables.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct WaterTable {
    /// Name used in the scenario.
    pub name: String,
    /// Density of the water, kg/m³.
    pub density: f64,
    /// Unit vector of the direction in which the distance is measured: x and y in space, `[1, 0]` in the plane.
    pub along: [f64; 2],
    /// Distance and height of each corner, m; at least one, distances strictly ascending. The table goes on level beyond both ends.
    pub points: Vec<[f64; 2]>,
    /// Heights on a grid, instead of `points`.
    pub grid: Option<Box<Grid>>,
    /// Where it acts; everywhere if `None`.
    pub zone: Option<Zone>,
    /// Rules of seepage: the table is then the head on open faces alone. `None` where water stands.
    pub seepage: Option<Steady>,
    /// The tables of which this one is made, each with its zone; all else but the name is then without meaning. Empty for one table.
    pub parts: Vec<WaterTable>,
}

/// A stretch of a water table that is a straight line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Strip {
    /// Where it begins, m; may be infinite.
    pub from: f64,
    /// Where it ends, m; may be infinite.
    pub to: f64,
    /// A corner: distance and height, m.
    pub corner: [f64; 2],
    /// Rise over run.
    pub slope: f64,
}

impl Strip {
    /// Height of its line at a distance, m.
    #[must_use]
    pub fn height(&self, distance: f64) -> f64 {
        self.corner[1] + self.slope * (distance - self.corner[0])
    }
}

/// Where a block is as to a strip of the table.
enum Depth {
    Above,
    Below,
    Across,
}

/// Calls what it is given with the corners of each face of a block.
type Faces<'a> = &'a dyn Fn(&mut dyn FnMut(&[Vec3]));
/// Takes a wet part of a face, and the depth below the table over it, m.
type Press<'a> = &'a mut dyn FnMut(&[Vec3], &dyn Fn(Vec3) -> f64);
/// A place on a block, from its centroid now, to where it was at the start (both m).
pub type Start<'a, P> = &'a dyn Fn(P) -> P;

impl WaterTable {
    /// The tables of which it is made; itself if it is one.
    pub fn single(&self) -> impl Iterator<Item = &WaterTable> {
        let own = self.parts.is_empty().then_some(self);
        own.into_iter().chain(&self.parts)
    }

    /// Height of a single table above a place, m.
    #[must_use]
    pub fn level(&self, x: f64, y: f64) -> f64 {
        match &self.grid {
            Some(grid) => grid.height(x, y),
            None => self.height(self.distance(x, y)),
        }
    }

    /// Distance of a place along the table, m.
    #[must_use]
    pub fn distance(&self, x: f64, y: f64) -> f64 {
        self.along[0] * x + self.along[1] * y
    }

    /// The strips that overlap the distances from `low` to `high`, ascending.
    pub fn strips(&self, low: f64, high: f64) -> impl Iterator<Item = Strip> + '_ {
        // Strip k ends at corner k; the last one has no end.
        let first = match self.points.len() {
            // A level one has no corner at which anything changes.
            1 => 1,
            _ => self.points.partition_point(|p| p[0] <= low),
        };
        (first..=self.points.len())
            .map(|k| self.strip(k))
            .take_while(move |s| s.from < high || s.from == f64::NEG_INFINITY)
    }

    fn strip(&self, k: usize) -> Strip {
        let n = self.points.len();
        let corner = self.points[k.min(n - 1)];
        if k == 0 || k == n {
            let (from, to) = match (n, k) {
                (1, _) => (f64::NEG_INFINITY, f64::INFINITY),
                (_, 0) => (f64::NEG_INFINITY, corner[0]),
                _ => (corner[0], f64::INFINITY),
            };
            return Strip { from, to, corner, slope: 0.0 };
        }
        let before = self.points[k - 1];
        Strip {
            from: before[0],
            to: corner[0],
            corner: before,
            slope: (corner[1] - before[1]) / (corner[0] - before[0]),
        }
    }

    /// Height of a table of `points` at a distance, m.
    #[must_use]
    pub fn height(&self, distance: f64) -> f64 {
        self.strip(self.points.partition_point(|p| p[0] <= distance)).height(distance)
    }

    /// Largest change of pressure over a length in any direction, Pa/m: stiffness of what floats over the area that the table cuts.
    #[must_use]
    pub fn stiffness(&self, gravity: f64) -> f64 {
        let one = |table: &WaterTable| {
            if table.seepage.is_some() {
                return table.density * gravity;
            }
            let steepest = match &table.grid {
                Some(grid) => grid.steepest(),
                None => {
                    let slopes = (0..=table.points.len()).map(|k| table.strip(k).slope.abs());
                    slopes.fold(0.0, f64::max)
                }
            };
            table.density * gravity * (1.0 + steepest * steepest).sqrt()
        };
        self.single().map(one).fold(0.0, f64::max)
    }

    /// Pressure at a place (m; in the plane y is nothing), Pa, under gravity `gravity` (m/s², positive downwards).
    #[must_use]
    pub fn pressure(&self, gravity: f64, at: Vec3) -> f64 {
        let here = |table: &&WaterTable| table.zone.is_none_or(|zone| zone.holds(at));
        let one = |table: &WaterTable| {
            table.density * gravity * (table.level(at.x, at.y) - at.z).max(0.0)
        };
        self.single().filter(here).map(one).fold(0.0, f64::max)
    }

    /// Force (N/m) and moment about the centroid (N) of the water on a polygon of area `area` (m²) at `centre` (m). `corner(k)` is its
    /// corner `k` from the centroid, one of `count` in anticlockwise order, none of them farther away than `radius` (m).
    #[must_use]
    #[allow(clippy::too_many_arguments)]
    pub fn on_polygon(
        &self,
        gravity: f64,
        centre: Vec2,
        radius: f64,
        area: f64,
        count: usize,
        corner: impl Fn(usize) -> Vec2,
        start: Start<'_, Vec2>,
    ) -> (Vec2, f64) {
        let (mut force, mut moment) = (Vec2::ZERO, 0.0);
        for table in self.single() {
            let share = match table.zone {
                None => zone::Share::All,
                Some(zone) => {
                    let at = start(Vec2::ZERO);
                    zone.share(Vec3::new(at.x, 0.0, at.y), radius)
                }
            };
            let (f, m) = match share {
                zone::Share::Nothing => continue,
                zone::Share::All => {
                    table.on_polygon_anywhere(gravity, centre, radius, area, count, &corner)
                }
                zone::Share::Part(zone) => {
                    let corners: Vec<Vec2> = (0..count).map(&corner).collect();
                    table.on_edges(gravity, centre, &corners, zone, start)
                }
            };
            force += f;
            moment += m;
        }
        (force, moment)
    }

    fn on_polygon_anywhere(
        &self,
        gravity: f64,
        centre: Vec2,
        radius: f64,
        area: f64,
        count: usize,
        corner: &dyn Fn(usize) -> Vec2,
    ) -> (Vec2, f64) {
        let weight = self.density * gravity;
        let (low, high) = (centre.x - radius, centre.x + radius);
        let (mut force, mut moment) = (Vec2::ZERO, 0.0);
        for strip in self.strips(low, high) {
            let depth = strip.height(centre.x) - centre.y;
            let whole = strip.from <= low && strip.to >= high;
            let (area, middle) = match (strip.depth(depth, radius), whole) {
                (Depth::Above, _) => continue,
                (Depth::Below, true) => (area, Vec2::ZERO),
                (Depth::Below, false) | (Depth::Across, _) => {
                    let corners: Vec<Vec2> = (0..count).map(corner).collect();
                    let ends = [strip.from - centre.x, strip.to - centre.x];
                    wet_part(&corners, ends, strip.slope, depth)
                }
            };
            let push = weight * area * Vec2::new(-strip.slope, 1.0);
            force += push;
            moment += middle.perp_dot(push);
        }
        (force, moment)
    }

    /// Force (N) and moment about the centroid (N m) of the water on a polyhedron of volume `volume` (m³) at `centre` (m). `faces` calls
    /// what it is given with the corners of each face from the centroid, anticlockwise seen from outside, none of them farther away than `radius` (m).
    #[must_use]
    pub fn on_polyhedron(
        &self,
        gravity: f64,
        centre: Vec3,
        radius: f64,
        volume: f64,
        faces: impl Fn(&mut dyn FnMut(&[Vec3])),
        start: Start<'_, Vec3>,
    ) -> (Vec3, Vec3) {
        let (mut force, mut moment) = (Vec3::ZERO, Vec3::ZERO);
        for table in self.single() {
            let share = match table.zone {
                None => zone::Share::All,
                Some(zone) => zone.share(start(Vec3::ZERO), radius),
            };
            let (f, m) = match (share, &table.grid) {
                (zone::Share::Nothing, _) => continue,
                (zone::Share::All, None) => {
                    table.on_polyhedron_anywhere(gravity, centre, radius, volume, &faces)
                }
                (zone::Share::All, Some(grid)) => {
                    let weight = table.density * gravity;
                    grid.on_polyhedron(weight, centre, radius, volume, &faces)
                }
                (zone::Share::Part(zone), _) => {
                    let mut sum = (Vec3::ZERO, Vec3::ZERO);
                    faces(&mut |face| {
                        let part = zone.clip(face, start);
                        let (f, m) = table.on_face(gravity, centre, &part);
                        sum.0 += f;
                        sum.1 += m;
                    });
                    sum
                }
            };
            force += f;
            moment += m;
        }
        (force, moment)
    }

    /// Force (N) and moment about `centre` (N m) of the water under a single table on a flat convex polygon whose corners are given from `centre`, m,
    /// anticlockwise seen from the water.
    #[must_use]
    pub fn on_face(&self, gravity: f64, centre: Vec3, face: &[Vec3]) -> (Vec3, Vec3) {
        let weight = self.density * gravity;
        if let Some(grid) = &self.grid {
            return grid.on_face(weight, centre, face);
        }
        let along = Vec3::new(self.along[0], self.along[1], 0.0);
        let place = self.distance(centre.x, centre.y);
        let distances = face.iter().map(|r| place + along.dot(*r));
        let (low, high) =
            distances.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), d| (l.min(d), h.max(d)));
        let (mut force, mut moment) = (Vec3::ZERO, Vec3::ZERO);
        for strip in self.strips(low, high) {
            let depth = strip.height(place) - centre.z;
            let (f, m) = strip.pressed(face, along, place, depth, [low, high]);
            force -= weight * f;
            moment -= weight * m;
        }
        (force, moment)
    }

    fn on_polyhedron_anywhere(
        &self,
        gravity: f64,
        centre: Vec3,
        radius: f64,
        volume: f64,
        faces: Faces<'_>,
    ) -> (Vec3, Vec3) {
        let weight = self.density * gravity;
        let along = Vec3::new(self.along[0], self.along[1], 0.0);
        let place = self.distance(centre.x, centre.y);
        let (low, high) = (place - radius, place + radius);
        let (mut force, mut moment) = (Vec3::ZERO, Vec3::ZERO);
        for strip in self.strips(low, high) {
            let depth = strip.height(place) - centre.z;
            let whole = strip.from <= low && strip.to >= high;
            match (strip.depth(depth, radius), whole) {
                (Depth::Above, _) => {}
                (Depth::Below, true) => {
                    force += weight * volume * (Vec3::Z - strip.slope * along);
                }
                (Depth::Below, false) | (Depth::Across, _) => faces(&mut |face| {
                    let (f, m) = strip.pressed(face, along, place, depth, [low, high]);
                    force -= weight * f;
                    moment -= weight * m;
                }),
            }
        }
        (force, moment)
    }

    /// Forces (N) of the water on the three corners of a triangle of the surface of a body that deforms, `- int N_a p n dA` with the
    /// linear shape functions `N_a`; places in m, now and at the start, anticlockwise seen from outside. Over a closed surface they are the slope of
    /// `int p dV` by the corners.
    #[must_use]
    pub fn on_triangle(&self, gravity: f64, corners: [Vec3; 3], start: [Vec3; 3]) -> [Vec3; 3] {
        let mut forces = [Vec3::ZERO; 3];
        for table in self.single() {
            let one = match (table.zone, &table.grid) {
                (None, None) => table.on_triangle_anywhere(gravity, corners),
                (zone, _) => table.on_part_of_triangle(gravity, corners, start, zone),
            };
            for (to, force) in forces.iter_mut().zip(one) {
                *to += force;
            }
        }
        forces
    }

    /// The same of a table on a grid or in a zone: flat pieces of the triangle, each with its linear pressure.
    fn on_part_of_triangle(
        &self,
        gravity: f64,
        corners: [Vec3; 3],
        start: [Vec3; 3],
        zone: Option<Zone>,
    ) -> [Vec3; 3] {
        let weight = self.density * gravity;
        let [o, e, f] = [0, 1, 2].map(|k| corners[k] - corners[0]);
        let normal = e.cross(f);
        let per = 1.0 / normal.dot(normal);
        let shape = |r: Vec3| {
            let [b, c] = [r.cross(f), e.cross(r)].map(|v| per * v.dot(normal));
            [1.0 - b - c, b, c]
        };
        let at_start = |r: Vec3| {
            let n = shape(r);
            n[0] * start[0] + n[1] * start[1] + n[2] * start[2]
        };
        let part = match zone {
            None => vec![o, e, f],
            Some(zone) => zone.clip(&[o, e, f], &at_start),
        };
        let mut forces = [Vec3::ZERO; 3];
        let mut press = |wet: &[Vec3], depth: &dyn Fn(Vec3) -> f64| {
            for k in 2..wet.len() {
                let part = [wet[0], wet[k - 1], wet[k]];
                let area = 0.5 * (part[1] - part[0]).cross(part[2] - part[0]);
                let (p, n) = (part.map(depth), part.map(shape));
                let sum = p[0] + p[1] + p[2];
                for (a, to) in forces.iter_mut().enumerate() {
                    let shares = n[0][a] + n[1][a] + n[2][a];
                    let products = n[0][a] * p[0] + n[1][a] * p[1] + n[2][a] * p[2];
                    *to -= weight / 12.0 * (shares * sum + products) * area;
                }
            }
        };
        if let Some(grid) = &self.grid {
            grid.each_wet(corners[0], &part, &mut press);
            return forces;
        }
        let place = self.distance(corners[0].x, corners[0].y);
        let distance = |r: Vec3| place + self.distance(r.x, r.y);
        let ends = part.iter().map(|r| distance(*r));
        let (low, high) =
            ends.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), d| (l.min(d), h.max(d)));
        for strip in self.strips(low, high) {
            let depth = |r: Vec3| strip.height(distance(r)) - (corners[0].z + r.z);
            let mut wet = keep(&part, &depth);
            if strip.from > low {
                wet = keep(&wet, &|r| distance(r) - strip.from);
            }
            if strip.to < high {
                wet = keep(&wet, &|r| strip.to - distance(r));
            }
            press(&wet, &depth);
        }
        forces
    }

    fn on_triangle_anywhere(&self, gravity: f64, corners: [Vec3; 3]) -> [Vec3; 3] {
        let weight = self.density * gravity;
        let place = corners.map(|c| self.distance(c.x, c.y));
        let (low, high) =
            (place[0].min(place[1]).min(place[2]), place[0].max(place[1]).max(place[2]));
        let [start, e, f] = [0, 1, 2].map(|k| corners[k] - corners[0]);
        let normal = e.cross(f);
        let mut forces = [Vec3::ZERO; 3];
        for strip in self.strips(low, high) {
            let depths = [0, 1, 2].map(|k| strip.height(place[k]) - corners[k].z);
            let whole = strip.from <= low && strip.to >= high;
            if whole && depths.iter().all(|d| *d >= 0.0) {
                let sum = depths[0] + depths[1] + depths[2];
                for (to, depth) in forces.iter_mut().zip(depths) {
                    *to -= weight / 24.0 * (sum + depth) * normal;
                }
                continue;
            }
            if depths.iter().all(|d| *d <= 0.0) {
                continue;
            }
            // Weights of a place of the triangle, from its first corner.
            let per = 1.0 / normal.dot(normal);
            let shape = |r: Vec3| {
                let [b, c] = [r.cross(f), e.cross(r)].map(|v| per * v.dot(normal));
                [1.0 - b - c, b, c]
            };
            let depth = |r: Vec3| {
                let n = shape(r);
                n[0] * depths[0] + n[1] * depths[1] + n[2] * depths[2]
            };
            let distance = |r: Vec3| place[0] + self.distance(r.x, r.y);
            let mut wet = keep(&[start, e, f], &depth);
            if strip.from > low {
                wet = keep(&wet, &|r| distance(r) - strip.from);
            }
            if strip.to < high {
                wet = keep(&wet, &|r| strip.to - distance(r));
            }
            for k in 2..wet.len() {
                let part = [wet[0], wet[k - 1], wet[k]];
                let area = 0.5 * (part[1] - part[0]).cross(part[2] - part[0]);
                let (p, n) = (part.map(depth), part.map(shape));
                let sum = p[0] + p[1] + p[2];
                for (a, to) in forces.iter_mut().enumerate() {
                    let shares = n[0][a] + n[1][a] + n[2][a];
                    let products = n[0][a] * p[0] + n[1][a] * p[1] + n[2][a] * p[2];
                    *to -= weight / 12.0 * (shares * sum + products) * area;
                }
            }
        }
        forces
    }
}

impl WaterTable {
    /// Force (N/m) and moment about `centre` (N) on those parts of the edges of a polygon that lie in a zone; corners from `centre`, m, anticlockwise.
    fn on_edges(
        &self,
        gravity: f64,
        centre: Vec2,
        corners: &[Vec2],
        zone: Zone,
        start: Start<'_, Vec2>,
    ) -> (Vec2, f64) {
        let weight = self.density * gravity;
        let (mut force, mut moment) = (Vec2::ZERO, 0.0);
        for (k, &a) in corners.iter().enumerate() {
            let along = corners[(k + 1) % corners.len()] - a;
            let [from, to] = zone.shares(start(a), start(a + along));
            let ends = [from, to].map(|s| centre.x + a.x + s * along.x);
            let (low, high) = (ends[0].min(ends[1]), ends[0].max(ends[1]));
            for strip in self.strips(low, high) {
                // The stretch of the edge in the strip, then its wet part.
                let (mut s, mut t) = (from, to);
                for (bound, is_low) in [(strip.from, true), (strip.to, false)] {
                    let cut = (bound - centre.x - a.x) / along.x;
                    if !cut.is_finite() {
                        continue;
                    }
                    if is_low == (along.x > 0.0) {
                        s = s.max(cut);
                    } else {
                        t = t.min(cut);
                    }
                }
                let depth = |s: f64| {
                    let r = a + s * along;
                    strip.height(centre.x + r.x) - (centre.y + r.y)
                };
                let (d, e) = (depth(s), depth(t));
                if s >= t || d <= 0.0 && e <= 0.0 {
                    continue;
                }
                let zero = s + (t - s) * d / (d - e);
                if d < 0.0 {
                    s = zero;
                }
                if e < 0.0 {
                    t = zero;
                }
                let (p, q) = (weight * d.max(0.0), weight * e.max(0.0));
                let (b, c) = (a + s * along, a + t * along);
                let inward = (c - b).perp();
                let push = 0.5 * (p + q) * inward;
                force += push;
                // Mean part at the middle, slope about it.
                moment +=
                    (0.5 * (b + c)).perp_dot(push) + (q - p) / 12.0 * (c - b).perp_dot(inward);
            }
        }
        (force, moment)
    }
}

impl Strip {
    /// Where a block of this radius is whose centre lies `depth` below the line of the strip.
    fn depth(&self, depth: f64, radius: f64) -> Depth {
        let reach = radius * (1.0 + self.slope * self.slope).sqrt();
        if depth <= -reach {
            Depth::Above
        } else if depth >= reach {
            Depth::Below
        } else {
            Depth::Across
        }
    }

    /// Force and moment, per weight of water, on the wet part of a face under the strip. The origin of the face lies at the distance `place`
    /// and `depth` below the line there (m); the block reaches over the distances `[low, high]`.
    fn pressed(
        &self,
        face: &[Vec3],
        along: Vec3,
        place: f64,
        depth: f64,
        [low, high]: [f64; 2],
    ) -> (Vec3, Vec3) {
        let below = |r: Vec3| depth + self.slope * along.dot(r) - r.z;
        let mut wet = keep(face, &below);
        if self.from > low {
            wet = keep(&wet, &|r: Vec3| place + along.dot(r) - self.from);
        }
        if self.to < high {
            wet = keep(&wet, &|r: Vec3| self.to - place - along.dot(r));
        }
        pressed(&wet, &below)
    }
}

/// Area (m²) and centroid (m) of the part of a polygon between two distances and below a line, `depth` (m) above the origin there.
fn wet_part(corners: &[Vec2], [from, to]: [f64; 2], slope: f64, depth: f64) -> (f64, Vec2) {
    let mut part = keep(corners, &|r: Vec2| depth + slope * r.x - r.y);
    if from > f64::NEG_INFINITY {
        part = keep(&part, &|r: Vec2| r.x - from);
    }
    if to < f64::INFINITY {
        part = keep(&part, &|r: Vec2| to - r.x);
    }
    let (mut twice, mut first) = (0.0, Vec2::ZERO);
    for (k, &a) in part.iter().enumerate() {
        let b = part[(k + 1) % part.len()];
        let cross = a.perp_dot(b);
        twice += cross;
        first += cross * (a + b);
    }
    if twice > 0.0 { (0.5 * twice, first / (3.0 * twice)) } else { (0.0, Vec2::ZERO) }
}

/// The part of a polygon on which a linear function is positive (Sutherland & Hodgman 1974). Of a polygon that is not convex, parts may
/// hang together by edges that are run through twice: integrals do not feel them.
fn keep<P>(corners: &[P], side: &dyn Fn(P) -> f64) -> Vec<P>
where
    P: Copy
        + std::ops::Add<Output = P>
        + std::ops::Sub<Output = P>
        + std::ops::Mul<f64, Output = P>,
{
    let mut kept = Vec::with_capacity(corners.len() + 1);
    for (k, &b) in corners.iter().enumerate() {
        let a = corners[(k + corners.len() - 1) % corners.len()];
        let (at_a, at_b) = (side(a), side(b));
        if (at_a > 0.0) != (at_b > 0.0) {
            kept.push(a + (b - a) * (at_a / (at_a - at_b)));
        }
        if at_b > 0.0 {
            kept.push(b);
        }
    }
    kept
}

/// `int p n dA` (N) and `int p r x n dA` (N m) of a pressure (Pa) that is linear over a flat polygon, over the part of it where the pressure is positive;
/// `n` is its normal, about which its corners (m) go anticlockwise.
#[must_use]
pub fn pressed_where_positive(face: &[Vec3], pressure: &dyn Fn(Vec3) -> f64) -> (Vec3, Vec3) {
    let at = |corner: &Vec3| pressure(*corner);
    if face.iter().all(|corner| at(corner) <= 0.0) {
        return (Vec3::ZERO, Vec3::ZERO);
    }
    if face.iter().all(|corner| at(corner) >= 0.0) {
        return pressed(face, pressure);
    }
    pressed(&keep(face, pressure), pressure)
}

/// `int p n dA` and `int p r x n dA` of a pressure that is linear over a flat polygon, `n` being its normal.
fn pressed(face: &[Vec3], pressure: &dyn Fn(Vec3) -> f64) -> (Vec3, Vec3) {
    let (mut force, mut moment) = (Vec3::ZERO, Vec3::ZERO);
    for k in 2..face.len() {
        let corners = [face[0], face[k - 1], face[k]];
        let area = 0.5 * (corners[1] - corners[0]).cross(corners[2] - corners[0]);
        let p = corners.map(pressure);
        let (sum, middle) = (p[0] + p[1] + p[2], corners[0] + corners[1] + corners[2]);
        let weighted = p[0] * corners[0] + p[1] * corners[1] + p[2] * corners[2];
        force += sum / 3.0 * area;
        moment += ((weighted + sum * middle) / 12.0).cross(area);
    }
    (force, moment)
}

#[cfg(test)]
mod tests;
