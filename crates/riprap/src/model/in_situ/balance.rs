//! Whether the stress at the start is in balance: with who carries it at the sides of the model, and with gravity.

use riprap_geom::{Mat3, Vec3};

use crate::laws::in_situ::InSitu;
use crate::model::builder::Builder;
use crate::plan::PhaseKind;
use crate::planar::setup::Motion;
use crate::scenario::Diagnostic;
use crate::scenario::Span;
use crate::scenario::read::with_unit;
use crate::scenario::vectors::InSpace;

/// Stress on a free face, as a share of the largest in the model, that is worth a word.
const WARNED: f64 = 1e-3;
/// Share that is refused where the first phase is dynamic.
const REFUSED: f64 = 0.1;
/// A block ends on a side of the model if it is nearer than this share of the model.
const AT_SIDE: f64 = 1e-6;

impl Builder<'_> {
    /// In-situ stress must be carried by somebody on every side of the model, and by gravity inside.
    pub(in crate::model) fn stress_balance(&mut self) {
        let (stress, axes) = match self.space {
            InSpace::Planar => (self.setup.in_situ, 2),
            InSpace::Spatial => (self.spatial.in_situ, 3),
        };
        let Some(stress) = stress else {
            return;
        };
        let (up, (min, max)) = (self.up(), self.extent());
        let heights = [min[up], max[up]];
        let size = |t: Mat3| {
            let all = [t.x_axis, t.y_axis, t.z_axis].into_iter();
            all.fold(0.0_f64, |most, axis| most.max(axis.abs().max_element()))
        };
        let largest = heights.iter().map(|&z| size(stress.at(z)));
        let largest = largest.fold(0.0, f64::max);
        if largest == 0.0 {
            return;
        }
        let settles = self.plan.phases.first().is_some_and(|phase| phase.kind == PhaseKind::Static);
        for axis in 0..axes {
            for sign in [-1.0, 1.0] {
                let normal = sign * Vec3::AXES[axis];
                let offset = if sign > 0.0 { max[axis] } else { -min[axis] };
                if self.is_carried(axis, normal, offset) {
                    continue;
                }
                let levels = if axis == up { vec![sign * offset] } else { heights.to_vec() };
                let pull = levels.iter().map(|&z| stress.traction(z, normal).length());
                let share = pull.fold(0.0, f64::max) / largest;
                if share > WARNED {
                    self.unbalanced(axis, sign, share, largest, settles);
                }
            }
        }
        self.weight_balance(&stress);
    }

    fn unbalanced(&mut self, axis: usize, sign: f64, share: f64, largest: f64, settles: bool) {
        let word = ["x", "y", "z"][axis];
        let end = if sign > 0.0 { "max" } else { "min" };
        let message = format!(
            "the in-situ stress on side {word}-{end} is not balanced by any boundary: {}",
            with_unit(share * largest, "Pa")
        );
        let conditions = match self.space {
            InSpace::Planar => "in_situ = true, or fixed blocks there",
            InSpace::Spatial => "held, roller or viscous, or in_situ = true alone",
        };
        let help = format!(
            "add [[boundaries]] with on = {{ plane = \"{word}-{end}\" }} and {conditions}; or bring the model to equilibrium in a first phase with \
             kind = \"static\""
        );
        let refused = share > REFUSED && !settles;
        let note = if refused {
            Diagnostic::error("in_situ.unbalanced", message)
        } else {
            Diagnostic::warning("in_situ.unbalanced", message)
        };
        let span = self.stress_span();
        self.found.push(note.at(span).help(help));
    }

    fn stress_span(&self) -> Span {
        let said = self.parsed.scenario.in_situ.as_ref();
        said.map_or(0..0, super::place)
    }

    /// Whether a condition, a period or fixed blocks take the stress on a side of the model.
    fn is_carried(&self, axis: usize, normal: Vec3, offset: f64) -> bool {
        match self.space {
            InSpace::Planar => self.is_carried_in_plane(axis, normal[axis], offset),
            InSpace::Spatial => {
                self.spatial.periodic[axis].is_some() || self.carried(normal, offset)
            }
        }
    }

    fn is_carried_in_plane(&self, axis: usize, sign: f64, offset: f64) -> bool {
        let open = self.open_sides();
        if open.iter().any(|(s, ..)| s.axis == axis && s.sign == sign) {
            return true;
        }
        let (min, max) = self.extent();
        let slack = AT_SIDE * (max - min).max_element();
        let fixed = |block: u32| {
            let supports = self.setup.supports.iter();
            let mut of_block = supports.filter(|s| s.blocks.contains(&block));
            of_block.any(|s| match s.motion {
                Motion::Fixed { x, y, .. } => [x, y][axis],
                Motion::Velocity { .. } | Motion::Acceleration { .. } => true,
            })
        };
        let mut blocks = (0..).zip(&self.setup.blocks).filter(|(_, block)| {
            let mut reaches = block.vertices.iter().map(|v| sign * v[axis]);
            reaches.any(|reach| (reach - offset).abs() <= slack)
        });
        blocks.all(|(number, _)| fixed(number))
    }

    /// The growth of the vertical stress with depth should be the weight of the rock.
    fn weight_balance(&mut self, stress: &InSitu) {
        let (up, gravity) = (self.up(), self.gravity_at_start());
        let densities = self.densities();
        let (Some(least), Some(most)) = (densities.first(), densities.last()) else {
            return;
        };
        // The stress grows upwards by minus its gradient: what is left over is the force per volume of both.
        let growth = stress.upward() * Vec3::AXES[up];
        let left = |density: f64| (growth + density * gravity).length();
        let weight = most * gravity.length();
        let scale = weight.max(growth.abs().max_element());
        let worst = left(*least).max(left(*most));
        if scale > 0.0 && worst > WARNED * scale {
            let message = format!(
                "the in-situ stress and gravity are not in equilibrium: {} is unbalanced",
                with_unit(worst, "N/m3")
            );
            let help = "the vertical stress should increase with depth by density times gravity; in_situ.gravity_k0 does this";
            let note = Diagnostic::warning("in_situ.weight", message).help(help);
            let span = self.stress_span();
            self.found.push(note.at(span));
        }
    }
}
