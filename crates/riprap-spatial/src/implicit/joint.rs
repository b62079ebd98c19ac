//! A joint of two blocks in an implicit step: springs at four points, which hold, or have failed and press and rub.
//!
//! ```text
//!   t(end) = t + k (dt v)       at each point: n, b, c; tension positive, on the first block
//!
//!   holds:   t(end) as it is                                         a quadratic term
//!   failed:  n: min(t(end), 0)    b, c: within  c_r + p tan(phi_r)   p is the pressure of the solution before
//! ```
//!
//! Failure is no convex law: joints hold while the step is solved, then those that are most beyond their strength fail, and the step is solved
//! again. The law of [`crate::laws::face_joint`] sees the same displacements in the next evaluation, and keeps the memory.
//!
//! A joint that softens, closes along a curve or dilates carries what its own law ([`crate::laws::behaviour`]) says of the end of the step. Its rates are those
//! of each traction with its own displacement, not below zero: where it softens, what is beside it and the masses bring the rounds to their end.
//!
//! A joint that fails as one face asks its mean traction and its torsion ([`super::face`]).

use riprap_geom::Vec3;

use crate::implicit::pair::Answer;
use crate::implicit::patch::{Stepping, Twist};
use crate::laws::behaviour::{JointModel, Law, Weakening};
use crate::laws::face_joint::{Memory, Springs, Traction, stored};
use crate::laws::mohr_coulomb::Strength;
use crate::laws::norm;

/// One joint in a step.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Joint {
    /// Unit vectors n, b, c.
    pub frame: [Vec3; 3],
    /// Area of each point, m².
    pub area: f64,
    /// Pa/m.
    pub springs: Springs,
    /// `None` holds whatever it bears.
    pub strength: Option<Strength>,
    /// How it weakens, closes and dilates, where it is not brittle with straight springs.
    pub model: Option<JointModel>,
    /// Half the distances of its points along b and c (m), where it fails as one face.
    pub whole: Option<[f64; 2]>,
    pub points: [Point; 4],
}

/// A point of a joint.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Point {
    /// Place from the origin of the pair, m.
    pub arm: Vec3,
    /// On the first block where nothing moves in the step (n, b, c), Pa.
    pub traction: Traction,
    /// Whether nothing but pressure and friction holds it.
    pub failed: bool,
    /// Whether it has failed in this step, and is open at its end.
    pub fails: bool,
    pub opens: bool,
    /// Pressure that limits the friction of a failed point, and that of the last solution, Pa.
    pub pressure: f64,
    next: f64,
    /// Where nothing moves in the step (m), its traction without displacement (Pa), and what it remembers: read where the joint has a model.
    pub at: [f64; 3],
    pub start: Traction,
    pub memory: Memory,
}

/// Displacement over which rates are taken, m.
pub(super) const BESIDE: f64 = 1e-9;

/// What a point carries at the end of a step.
pub(super) struct End {
    pub(super) traction: Traction,
    /// Rates of the normal and the shear traction over those of the springs; shear along its direction and across it.
    pub(super) share: [f64; 3],
}

impl Point {
    pub(crate) fn new(arm: Vec3, traction: Traction, failed: bool) -> Self {
        let pressure = if failed { (-traction[0]).max(0.0) } else { 0.0 };
        Self { arm, traction, failed, pressure, next: pressure, ..Self::default() }
    }
}

impl Joint {
    /// Velocity of a point of the second block against the first, m/s.
    fn speed(point: &Point, twist: &Twist) -> Vec3 {
        let [x, y, z, p, q, r] = *twist;
        Vec3::new(x, y, z) + Vec3::new(p, q, r).cross(point.arm)
    }

    /// Way of a point in the step, m.
    pub(super) fn way(&self, point: &Point, twist: &Twist, step: &Stepping) -> [f64; 3] {
        let v = Self::speed(point, twist);
        self.frame.map(|axis| step.dt * axis.dot(v))
    }

    /// Traction of a point at the end of the step, without failure.
    pub(super) fn moved(&self, point: &Point, twist: &Twist, step: &Stepping) -> Traction {
        if let Some(model) = &self.model {
            return self.told(model, point, &self.way(point, twist, step));
        }
        let v = Self::speed(point, twist);
        std::array::from_fn(|k| {
            point.traction[k] + self.springs[k.min(1)] * step.dt * self.frame[k].dot(v)
        })
    }

    /// Whether a point fails at once when it is beyond its strength.
    pub(super) fn is_brittle(&self) -> bool {
        self.model.as_ref().is_none_or(|model| model.weakening == Weakening::Brittle)
    }

    /// Traction after a way (m) by the law of the joint. What is brittle holds until it has failed.
    fn told(&self, model: &JointModel, point: &Point, way: &[f64; 3]) -> Traction {
        let holds = self.is_brittle() && !point.failed;
        let strength = self.strength.as_ref().filter(|_| !holds);
        let law = Law::new(strength, model, self.springs);
        let mut memory = Memory { broken: point.failed || point.memory.broken, ..point.memory };
        let at = [0, 1, 2].map(|k| point.at[k] + way[k]);
        law.point(&point.start, &at, way, &mut memory).0
    }

    /// What the law of the joint says of the end of the step; rates where asked for.
    fn told_end(&self, model: &JointModel, point: &Point, way: &[f64; 3], rates: bool) -> End {
        let traction = self.told(model, point, way);
        let mut share = [1.0; 3];
        if rates {
            let size = norm(traction[1], traction[2]);
            let along = match size > 0.0 {
                true => [0.0, traction[1] / size, traction[2] / size],
                false => [0.0, 1.0, 0.0],
            };
            let across = [0.0, -along[2], along[1]];
            for (k, axis) in [[1.0, 0.0, 0.0], along, across].into_iter().enumerate() {
                let beside = [0, 1, 2].map(|i| way[i] + BESIDE * axis[i]);
                let then = self.told(model, point, &beside);
                let more: f64 = (0..3).map(|i| axis[i] * (then[i] - traction[i])).sum();
                share[k] = (more / (BESIDE * self.springs[k.min(1)])).clamp(0.0, 1.0);
            }
        }
        End { traction, share }
    }

    /// Most shear traction of a failed point, Pa.
    fn limit(&self, point: &Point) -> f64 {
        match &self.strength {
            Some(strength) if point.pressure > 0.0 => strength.residual(-point.pressure),
            _ => 0.0,
        }
    }

    fn end(&self, point: &Point, twist: &Twist, step: &Stepping, rates: bool) -> End {
        if let Some(model) = &self.model {
            return self.told_end(model, point, &self.way(point, twist, step), rates);
        }
        let mut traction = self.moved(point, twist, step);
        if !point.failed {
            return End { traction, share: [1.0; 3] };
        }
        let mut share = [1.0; 3];
        if traction[0] >= 0.0 {
            (traction[0], share[0]) = (0.0, 0.0);
        }
        let (limit, size) = (self.limit(point), norm(traction[1], traction[2]));
        if size > limit {
            let keep = limit / size;
            traction[1] *= keep;
            traction[2] *= keep;
            (share[1], share[2]) = (0.0, keep);
        }
        End { traction, share }
    }

    fn ends(&self, twist: &Twist, step: &Stepping, rates: bool) -> [End; 4] {
        match self.whole {
            Some(_) => self.ends_of_face(twist, step, rates),
            None => self.points.each_ref().map(|point| self.end(point, twist, step, rates)),
        }
    }

    /// Adds what it exerts on the second block about the origin of the pair and, where asked for, the rate of its impulse.
    pub(crate) fn add(
        &self,
        twist: &Twist,
        step: &Stepping,
        soft: f64,
        with_rate: bool,
        answer: &mut Answer,
    ) {
        answer.acts = true;
        if with_rate {
            self.add_rubbing_of_face(twist, step, soft, &mut answer.rate);
        }
        let ends = self.ends(twist, step, with_rate);
        for (point, End { traction, share }) in self.points.iter().zip(ends) {
            let [n, b, c] = self.frame;
            let force = -soft * self.area * (traction[0] * n + traction[1] * b + traction[2] * c);
            let moment = point.arm.cross(force);
            for (k, x) in force.to_array().into_iter().chain(moment.to_array()).enumerate() {
                answer.wrench[k] += x;
            }
            if with_rate {
                let scale = soft * step.span * step.dt * self.area;
                let [kn, ks] = self.springs.map(|k| scale * k);
                // Friction yields along itself alone.
                let size = norm(traction[1], traction[2]);
                let along = match size > 0.0 {
                    true => (traction[1] * b + traction[2] * c) / size,
                    false => b,
                };
                let across = n.cross(along);
                let stiffness = [kn * share[0], ks * share[1], ks * share[2]];
                for (k, direction) in stiffness.into_iter().zip([n, along, across]) {
                    add_square(&mut answer.rate, k, direction, point.arm.cross(direction));
                }
            }
        }
    }

    /// Looks at the pressures of a solution; their forces and by how much these changed, N.
    pub(crate) fn press(&mut self, twist: &Twist, step: &Stepping) -> [f64; 2] {
        let mut sums = [0.0; 2];
        if self.model.is_some() {
            // Its law has the pressure of the solution itself.
            return sums;
        }
        let joint = *self;
        for point in self.points.iter_mut().filter(|point| point.failed) {
            let pressure = (-joint.moved(point, twist, step)[0]).max(0.0);
            sums[0] += joint.area * pressure;
            sums[1] += joint.area * (pressure - point.pressure).abs();
            point.next = pressure;
        }
        sums
    }

    /// Takes the pressures looked at last for the friction of the next solution.
    pub(crate) fn take_pressure(&mut self) {
        for point in &mut self.points {
            point.pressure = point.next;
        }
    }

    /// Utilisation of a point that holds; 0 for others.
    fn used(&self, point: &Point, twist: &Twist, step: &Stepping) -> f64 {
        match &self.strength {
            Some(strength) if !point.failed && self.is_brittle() => {
                strength.utilisation(&self.moved(point, twist, step)).0
            }
            _ => 0.0,
        }
    }

    /// Utilisation of its weakest point at the end of the step.
    pub(crate) fn weakest(&self, twist: &Twist, step: &Stepping) -> f64 {
        if self.whole.is_some() {
            return self.used_as_face(twist, step);
        }
        self.points.iter().map(|point| self.used(point, twist, step)).fold(0.0, f64::max)
    }

    /// Lets the points fail whose utilisation is at least `from`.
    pub(crate) fn fail(&mut self, twist: &Twist, step: &Stepping, from: f64) {
        let joint = *self;
        let together = self.whole.is_some() && self.used_as_face(twist, step) >= from;
        for point in &mut self.points {
            if together || self.whole.is_none() && joint.used(point, twist, step) >= from {
                (point.failed, point.fails) = (true, true);
                point.pressure = (-joint.moved(point, twist, step)[0]).max(0.0);
                point.next = point.pressure;
            }
        }
    }

    /// Looks which of the points that have failed in this step are open at its end.
    pub(crate) fn look_open(&mut self, twist: &Twist, step: &Stepping) {
        let joint = *self;
        for point in self.points.iter_mut().filter(|point| point.fails) {
            // What has failed and has a model is as its law says.
            point.opens = joint.moved(point, twist, step)[0] >= 0.0;
        }
    }

    /// What a point that opens has stored at the start of the step and no law of its own books, J. A face that slides on keeps the shear of its open points.
    pub(crate) fn lost(&self, point: usize) -> f64 {
        if self.whole.is_none() || self.points.iter().all(|point| point.opens) {
            return self.stored(point);
        }
        let tension = self.points[point].traction[0].max(0.0);
        0.5 * self.area * tension * tension / self.springs[0]
    }

    /// Energy in the springs of a point at the start of the step, J.
    fn stored(&self, point: usize) -> f64 {
        let of = &self.points[point];
        let energy = match &self.model {
            Some(model) => {
                let law = Law::new(self.strength.as_ref(), model, self.springs);
                let [normal, shear] = law.energy(&of.start, &of.at, &of.memory);
                normal + shear
            }
            None => stored(self.springs, &of.traction),
        };
        self.area * energy
    }
}

/// Adds `k s s'` with the screw `s` of a direction and its moment.
pub(super) fn add_square(rate: &mut [Twist; 6], k: f64, direction: Vec3, moment: Vec3) {
    if k == 0.0 {
        return;
    }
    let ([x, y, z], [p, q, r]) = (direction.to_array(), moment.to_array());
    let screw = [x, y, z, p, q, r];
    for (row, a) in rate.iter_mut().zip(screw) {
        for (to, b) in row.iter_mut().zip(screw) {
            *to += k * a * b;
        }
    }
}
