//! A joint whose four points fail together, in an implicit step.
//!
//! ```text
//!   holds:   all points as their springs have it, until mean traction and torsion are beyond the strength
//!   failed:  n: min(t(end), 0) of each point    mean b, mean c and torsion over r: y min(1, R/|y|),  R = c_r + p tan(phi_r)
//! ```
//!
//! with the mean pressure p of the solution before, and r the distance of the points from the middle. That is the law of [`crate::laws::face_joint::face`], which
//! sees the same displacements in the next evaluation and keeps the memory.

use riprap_geom::Vec3;

use crate::implicit::joint::{BESIDE, End, Joint, add_square};
use crate::implicit::patch::{Stepping, Twist};
use crate::laws::behaviour::{JointModel, Law};
use crate::laws::face_joint::{SIGNS, Sums, Traction};
use crate::laws::norm;

/// Friction of a failed face at the end of a step.
struct Rubbing {
    sums: Sums,
    /// Share of it that is carried.
    keep: f64,
    /// Direction of the mean shear along b and c and of the torsion, nil where it sticks.
    unit: [f64; 3],
}

impl Joint {
    fn has_failed(&self) -> bool {
        self.points.iter().all(|point| point.failed)
    }

    /// Tractions of all points at the end of the step, without failure.
    fn all_moved(&self, twist: &Twist, step: &Stepping) -> [Traction; 4] {
        if let Some(model) = &self.model {
            let ways = self.points.each_ref().map(|point| self.way(point, twist, step));
            return self.told_as_face(model, &ways);
        }
        self.points.each_ref().map(|point| self.moved(point, twist, step))
    }

    /// Tractions after ways (m) by the law of the joint. What is brittle holds until it has failed.
    fn told_as_face(&self, model: &JointModel, ways: &[[f64; 3]; 4]) -> [Traction; 4] {
        let holds = self.is_brittle() && !self.has_failed();
        let strength = self.strength.as_ref().filter(|_| !holds);
        let law = Law::new(strength, model, self.springs);
        let mut memory = self.points.map(|point| point.memory);
        for (memory, point) in memory.iter_mut().zip(&self.points) {
            memory.broken |= point.failed;
        }
        let start = self.points.map(|point| point.start);
        let at: [[f64; 3]; 4] =
            std::array::from_fn(|p| [0, 1, 2].map(|k| self.points[p].at[k] + ways[p][k]));
        law.face(&start, &at, ways, self.whole.unwrap_or_default(), &mut memory).0
    }

    /// Utilisation of the face at the end of the step; 0 where it does not fail at once, or has failed.
    pub(super) fn used_as_face(&self, twist: &Twist, step: &Stepping) -> f64 {
        let (Some(strength), Some(half)) = (&self.strength, self.whole) else { return 0.0 };
        if self.has_failed() || !self.is_brittle() {
            return 0.0;
        }
        let sums = Sums::of(&self.all_moved(twist, step), half);
        strength.utilisation(&[sums.normal, sums.shear_measure(half), 0.0]).0
    }

    /// Friction of a failed face whose points have these tractions before it slides.
    fn rubbing_of_face(&self, tractions: &[Traction; 4]) -> Rubbing {
        let half = self.whole.unwrap_or_default();
        let pressure = 0.25 * self.points.iter().map(|point| point.pressure).sum::<f64>();
        let limit = match &self.strength {
            Some(strength) if pressure > 0.0 => strength.residual(-pressure),
            _ => 0.0,
        };
        let sums = Sums::of(tractions, half);
        let measure = sums.shear_measure(half);
        if measure <= limit {
            return Rubbing { sums, keep: 1.0, unit: [0.0; 3] };
        }
        let [b, c] = sums.shear;
        let torsion = sums.twist * norm(half[0], half[1]);
        Rubbing { sums, keep: limit / measure, unit: [b, c, torsion].map(|y| y / measure) }
    }

    /// What all points carry at the end of the step.
    pub(super) fn ends_of_face(&self, twist: &Twist, step: &Stepping, rates: bool) -> [End; 4] {
        if let Some(model) = &self.model {
            return self.told_ends(model, twist, step, rates);
        }
        let mut tractions = self.all_moved(twist, step);
        if !self.has_failed() {
            return tractions.map(|traction| End { traction, share: [1.0; 3] });
        }
        let half = self.whole.unwrap_or_default();
        let Rubbing { sums, keep, .. } = self.rubbing_of_face(&tractions);
        for (p, t) in tractions.iter_mut().enumerate() {
            t[0] = t[0].min(0.0);
            if keep < 1.0 {
                let [b, c] = [SIGNS[0][p] * half[0], SIGNS[1][p] * half[1]];
                t[1] = keep * (sums.shear[0] - sums.twist * c);
                t[2] = keep * (sums.shear[1] + sums.twist * b);
            }
        }
        // Rates along the face belong to all points together.
        tractions.map(|traction| {
            let across = if traction[0] < 0.0 { 1.0 } else { 0.0 };
            End { traction, share: [across, 0.0, 0.0] }
        })
    }

    /// The same where the joint has a model; rates over those of the springs by differences, of each point across and of all along the face.
    fn told_ends(
        &self,
        model: &JointModel,
        twist: &Twist,
        step: &Stepping,
        rates: bool,
    ) -> [End; 4] {
        let ways = self.points.each_ref().map(|point| self.way(point, twist, step));
        let tractions = self.told_as_face(model, &ways);
        if !rates {
            return tractions.map(|traction| End { traction, share: [1.0; 3] });
        }
        let mean = |t: &[Traction; 4]| -> [f64; 3] {
            [0, 1, 2].map(|k| 0.25 * t.iter().map(|t| t[k]).sum::<f64>())
        };
        let [_, b, c] = mean(&tractions);
        let size = norm(b, c);
        let along = if size > 0.0 { [0.0, b / size, c / size] } else { [0.0, 1.0, 0.0] };
        let beside = |axis: &[f64; 3]| {
            let moved = ways.map(|way| [0, 1, 2].map(|k| way[k] + BESIDE * axis[k]));
            self.told_as_face(model, &moved)
        };
        let share = |axis: [f64; 3]| {
            let (then, now) = (mean(&beside(&axis)), mean(&tractions));
            let more: f64 = (0..3).map(|k| axis[k] * (then[k] - now[k])).sum();
            (more / (BESIDE * self.springs[1])).clamp(0.0, 1.0)
        };
        let shear = [share(along), share([0.0, -along[2], along[1]])];
        let normal = beside(&[1.0, 0.0, 0.0]);
        std::array::from_fn(|p| {
            let more = normal[p][0] - tractions[p][0];
            let across = (more / (BESIDE * self.springs[0])).clamp(0.0, 1.0);
            End { traction: tractions[p], share: [across, shear[0], shear[1]] }
        })
    }

    /// Adds the rate of the friction of a failed face; nothing for other joints.
    pub(super) fn add_rubbing_of_face(
        &self,
        twist: &Twist,
        step: &Stepping,
        soft: f64,
        rate: &mut [Twist; 6],
    ) {
        let Some(half) = self.whole.filter(|_| self.model.is_none() && self.has_failed()) else {
            return;
        };
        let Rubbing { keep, unit, .. } = self.rubbing_of_face(&self.all_moved(twist, step));
        let middle = 0.25 * self.points.iter().map(|point| point.arm).sum::<Vec3>();
        let [n, b, c] = self.frame;
        // Mean shear along b and c at the middle, and torsion over the distance of the points.
        let turning = norm(half[0], half[1]) * n;
        let screws = [(b, middle.cross(b)), (c, middle.cross(c)), (Vec3::ZERO, turning)];
        let scale = 4.0 * soft * step.span * step.dt * self.area * self.springs[1] * keep;
        for (direction, moment) in screws {
            add_square(rate, scale, direction, moment);
        }
        let sum = |of: [Vec3; 3]| unit[0] * of[0] + unit[1] * of[1] + unit[2] * of[2];
        let (direction, moment) = (sum(screws.map(|s| s.0)), sum(screws.map(|s| s.1)));
        add_square(rate, -scale, direction, moment);
    }
}
