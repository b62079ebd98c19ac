//! One plane piece of the surface between two blocks as a term of the implicit step.
//!
//! ```text
//!      phi = h0 + h1 u + h2 v          depth below either face, in the frame of the piece; below 0 where the blocks are apart
//!      P b = 2 kn phi - dt kappa vn    pressure at the end of the step, b = (1, u, v)
//!
//!            +----------------+
//!            |   dry    . wet |        only where P b > 0: the toe of a block is found within the solve
//!            |      P b = 0   |
//!            +----------------+
//! ```
//!
//! Over the wet part `Phi = span/(2 dt kappa) P' G P` with the moments `G` of `b b'`: convex, with a continuous slope, and exact for a
//! pressure that is linear. One piece is one contact of three numbers, whatever its polygon: no points, no quadrature.
//!
//! Source: own derivation (the family of convex steps for contact of Castro et al., 2020 and 2022); pieces as in [`crate::kernel::surface`].

#![expect(clippy::needless_range_loop, reason = "indices are rows and columns of several matrices")]

use std::ops::Range;

use riprap_geom::Vec3;

/// Relative motion of the second block against the first at the origin of their pair: velocity (m/s) and spin (rad/s).
pub(crate) type Twist = [f64; 6];

/// The part of a twist or wrench that pressure knows: along the direction of the pair, and about two axes across it.
pub(crate) type Normal = [f64; 3];

/// The direction of a pair and two unit vectors across it.
pub(crate) type Basis = [Vec3; 3];

/// What of a twist changes the pressure.
pub(crate) fn normal_part([n, a, b]: &Basis, twist: &Twist) -> Normal {
    let [x, y, z, p, q, r] = *twist;
    let (v, w) = (Vec3::new(x, y, z), Vec3::new(p, q, r));
    [v.dot(*n), w.dot(*a), w.dot(*b)]
}

/// The whole twist or wrench of a part.
pub(crate) fn whole([n, a, b]: &Basis, [along, first, second]: Normal) -> Twist {
    let (force, moment) = (along * *n, first * *a + second * *b);
    [force.x, force.y, force.z, moment.x, moment.y, moment.z]
}

fn dot3(a: &Normal, b: &Normal) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(crate) fn dot(a: &Twist, b: &Twist) -> f64 {
    let mut sum = 0.0;
    for k in 0..6 {
        sum += a[k] * b[k];
    }
    sum
}

/// What all pieces of a pair share.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Stepping {
    /// Time over which forces change the velocities, s: the mean of the last step and this one.
    pub span: f64,
    /// Length of the step, s.
    pub dt: f64,
}

/// One piece.
#[derive(Clone, Debug)]
pub(crate) struct Piece {
    /// Pressure where nothing moves: `2 kn (h0, h1, h2)`, Pa and Pa/m.
    pressure: [f64; 3],
    /// Change of the pressure with the twist, over `-dt kappa`.
    screws: [Normal; 3],
    /// Stiffness along the direction of the pair, Pa/m.
    kappa: f64,
    /// Share of its area that counts, and how far it faces the direction of the pair.
    weight: f64,
    /// A point of it and two axes in it.
    frame: [Vec3; 3],
    /// Its corners among those of the pair, in its own frame, m, anticlockwise.
    corners: Range<usize>,
    /// Further polygons in the same frame with the same pressure, and how often they count: of terms of glued parts. What all of them make is a part of
    /// the plane, counted once.
    more: Vec<(Range<usize>, f64)>,
}

/// Moments of `b b'` over an area: 1, u, v, uu, uv, vv.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Moments([f64; 6]);

impl Moments {
    fn is_dry(&self) -> bool {
        self.0[0] == 0.0
    }

    /// Area, m².
    pub(crate) fn area(&self) -> f64 {
        self.0[0]
    }

    /// Adds those of another area that counts `factor` times.
    fn add(&mut self, other: &Self, factor: f64) {
        for (to, x) in self.0.iter_mut().zip(other.0) {
            *to += factor * x;
        }
    }

    /// Of a convex polygon, by a fan from its first corner.
    pub(crate) fn of(corners: &[[f64; 2]]) -> Self {
        let mut sum = [0.0; 6];
        let Some((&[u0, v0], rest)) = corners.split_first() else {
            return Self(sum);
        };
        for side in rest.windows(2) {
            let ([u1, v1], [u2, v2]) = (side[0], side[1]);
            let twice = (u1 - u0) * (v2 - v0) - (u2 - u0) * (v1 - v0);
            let (su, sv) = (u0 + u1 + u2, v0 + v1 + v2);
            let area = 0.5 * twice;
            sum[0] += area;
            sum[1] += area * su / 3.0;
            sum[2] += area * sv / 3.0;
            let twelfth = area / 12.0;
            sum[3] += twelfth * (su * su + u0 * u0 + u1 * u1 + u2 * u2);
            sum[4] += twelfth * (su * sv + u0 * v0 + u1 * v1 + u2 * v2);
            sum[5] += twelfth * (sv * sv + v0 * v0 + v1 * v1 + v2 * v2);
        }
        Self(sum)
    }

    /// `G p`.
    pub(crate) fn times(&self, p: &[f64; 3]) -> [f64; 3] {
        let [one, u, v, uu, uv, vv] = self.0;
        [
            one * p[0] + u * p[1] + v * p[2],
            u * p[0] + uu * p[1] + uv * p[2],
            v * p[0] + uv * p[1] + vv * p[2],
        ]
    }

    pub(crate) fn scaled(&self, share: f64) -> [f64; 6] {
        self.0.map(|x| share * x)
    }

    fn entry(&self, a: usize, b: usize) -> f64 {
        const AT: [[usize; 3]; 3] = [[0, 1, 2], [1, 3, 4], [2, 4, 5]];
        self.0[AT[a][b]]
    }
}

/// What is asked of a piece in one look at it.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Pressed {
    /// Moments of the wet part.
    pub moments: Moments,
    /// `G P`: force along the direction of the pair over the weight, N, and its moments in the frame of the piece, N m.
    pub load: [f64; 3],
    /// Pressure in the frame of the piece at the end of the step.
    pub pressure: [f64; 3],
}

impl Pressed {
    /// Whether nothing presses.
    pub(crate) fn is_dry(&self) -> bool {
        self.moments.is_dry()
    }
}

impl Piece {
    /// A piece with its own `normal` and axes about `foot` (m, from the origin of the pair), the depth `[h0, h1, h2]` in it, on faces whose
    /// outward normals have the components `facing` along (first) and against (second block) the direction of the pair.
    pub(crate) fn new(
        basis: &Basis,
        stiffness: f64,
        facing: [f64; 2],
        weight: f64,
        place: (Vec3, [Vec3; 2]),
        depth: [f64; 3],
        corners: Range<usize>,
    ) -> Self {
        let (foot, [along, across]) = place;
        let [f, g] = facing;
        let [n, first, second] = *basis;
        let screw = |force: f64, arm: Vec3| {
            let turn = arm.cross(n);
            [force, turn.dot(first), turn.dot(second)]
        };
        Self {
            pressure: depth.map(|h| 2.0 * stiffness * h),
            screws: [screw(1.0, foot), screw(0.0, along), screw(0.0, across)],
            kappa: 2.0 * stiffness * f * g / (f + g),
            weight,
            frame: [foot, along, across],
            corners,
            more: Vec::new(),
        }
    }

    /// Adds a polygon in its frame that counts `factor` times its own.
    pub(crate) fn add_polygon(&mut self, corners: Range<usize>, factor: f64) {
        self.more.push((corners, factor));
    }

    pub(crate) fn weight(&self) -> f64 {
        self.weight
    }

    pub(crate) fn frame(&self) -> [Vec3; 3] {
        self.frame
    }

    /// Its pressure where nothing moves, Pa and Pa/m.
    pub(crate) fn at_rest(&self) -> &[f64; 3] {
        &self.pressure
    }

    /// The same with so much less pressure (Pa).
    pub(crate) fn relieved(&self, by: f64) -> Self {
        let [p, along, across] = self.pressure;
        Self { pressure: [p - by, along, across], ..self.clone() }
    }

    /// Its pressure and wet part at a twist; `soft` scales its stiffness, `corners` are those of the pair.
    pub(crate) fn press(
        &self,
        corners: &[[f64; 2]],
        twist: &Normal,
        step: &Stepping,
        soft: f64,
        spare: &mut Vec<[f64; 2]>,
    ) -> Pressed {
        let mut pressure = [0.0; 3];
        for (p, (at_rest, screw)) in pressure.iter_mut().zip(self.pressure.iter().zip(&self.screws))
        {
            *p = soft * (at_rest - step.dt * self.kappa * dot3(screw, twist));
        }
        let mut moments = wet_moments(&corners[self.corners.clone()], &pressure, spare);
        for (own, factor) in &self.more {
            moments.add(&wet_moments(&corners[own.clone()], &pressure, spare), *factor);
        }
        let load = moments.times(&pressure).map(|x| self.weight * x);
        Pressed { moments, load, pressure }
    }

    /// Makes it an impact with the share `rebound` of the approach at the start, as hard as `harder` times its stiffness; `twists` are those of the
    /// solution without it and of the start. It presses where it does in that solution.
    pub(crate) fn strike(
        &mut self,
        corners: &mut Vec<[f64; 2]>,
        [end, start]: [Normal; 2],
        rebound: f64,
        harder: f64,
        step: &Stepping,
        spare: &mut Vec<[f64; 2]>,
    ) {
        let Pressed { pressure, .. } = self.press(corners, &end, step, 1.0, spare);
        let more = self.more.iter_mut().map(|(own, _)| own);
        for own in [&mut self.corners].into_iter().chain(more) {
            wet(&corners[own.clone()], &pressure, spare);
            let from = corners.len();
            corners.extend_from_slice(spare);
            *own = from..corners.len();
        }
        self.kappa *= harder;
        let kappa = self.kappa;
        self.pressure = self.screws.map(|screw| -step.dt * kappa * rebound * dot3(&screw, &start));
    }

    /// Energy in its pressure where nothing moves, J.
    pub(crate) fn stored(&self, corners: &[[f64; 2]], spare: &mut Vec<[f64; 2]>) -> f64 {
        let at_rest = Stepping { span: 0.0, dt: 0.0 };
        let Pressed { load, pressure, .. } = self.press(corners, &[0.0; 3], &at_rest, 1.0, spare);
        let mut sum = 0.0;
        for (load, p) in load.iter().zip(&pressure) {
            sum += load * p;
        }
        0.5 * sum / self.kappa
    }

    /// Largest of a pressure in its polygon, Pa.
    pub(crate) fn most(&self, corners: &[[f64; 2]], pressure: &[f64; 3]) -> f64 {
        let at = |corner: &[f64; 2]| pressure_at(pressure, *corner);
        let more = self.more.iter().filter(|(_, factor)| *factor > 0.0).map(|(own, _)| own);
        let all = [&self.corners].into_iter().chain(more);
        all.flat_map(|own| &corners[own.clone()]).map(at).fold(0.0, f64::max)
    }

    /// Adds the wrench on the second block about the origin of the pair.
    pub(crate) fn add_wrench(&self, pressed: &Pressed, to: &mut Normal) {
        for (load, screw) in pressed.load.iter().zip(&self.screws) {
            for k in 0..3 {
                to[k] += load * screw[k];
            }
        }
    }

    /// Adds the rate of the impulse with the twist: `span dt kappa sum G_ab j_a j_b'`.
    pub(crate) fn add_rate(
        &self,
        pressed: &Pressed,
        step: &Stepping,
        soft: f64,
        to: &mut [Normal; 3],
    ) {
        let scale = soft * step.span * step.dt * self.kappa * self.weight;
        for a in 0..3 {
            let mut row = [0.0; 3];
            for b in 0..3 {
                let g = scale * pressed.moments.entry(a, b);
                for k in 0..3 {
                    row[k] += g * self.screws[b][k];
                }
            }
            for i in 0..3 {
                for k in 0..3 {
                    to[i][k] += self.screws[a][i] * row[k];
                }
            }
        }
    }
}

fn pressure_at(p: &[f64; 3], [u, v]: [f64; 2]) -> f64 {
    p[0] + p[1] * u + p[2] * v
}

/// Moments of the part of a polygon where a linear pressure is above zero.
fn wet_moments(corners: &[[f64; 2]], p: &[f64; 3], spare: &mut Vec<[f64; 2]>) -> Moments {
    let pressed = corners.iter().filter(|c| pressure_at(p, **c) > 0.0).count();
    if pressed == 0 {
        Moments::default()
    } else if pressed == corners.len() {
        Moments::of(corners)
    } else {
        wet(corners, p, spare);
        Moments::of(spare)
    }
}

/// The part of a polygon where a linear pressure is above zero.
fn wet(corners: &[[f64; 2]], p: &[f64; 3], to: &mut Vec<[f64; 2]>) {
    to.clear();
    let at = |corner: [f64; 2]| pressure_at(p, corner);
    let Some(&last) = corners.last() else {
        return;
    };
    let (mut from, mut before) = (last, at(last));
    for &corner in corners {
        let here = at(corner);
        if (before > 0.0) != (here > 0.0) {
            let share = before / (before - here);
            to.push([
                from[0] + share * (corner[0] - from[0]),
                from[1] + share * (corner[1] - from[1]),
            ]);
        }
        if here > 0.0 {
            to.push(corner);
        }
        (from, before) = (corner, here);
    }
}
