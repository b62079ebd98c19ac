//! Rules of joints that soften, are rough, close along a curve or dilate.

use super::Rules;
use crate::language::{BartonBandis, Interface, JointSoftening, curve};
use crate::quantity::{FrictionAngle, Quantity, Span};
use crate::vectors::InSpace;

/// What the joints of an interface have, in either space: those of the plane are its `bond`.
struct Joint {
    /// Pa/m, where given.
    normal: Option<f64>,
    shear: Option<f64>,
    /// Pa.
    tension: f64,
    cohesion: f64,
    residual_cohesion: f64,
    /// rad, where given.
    friction: Option<f64>,
    residual: Option<(f64, Span)>,
}

impl Joint {
    fn of(space: InSpace, interface: &Interface) -> Self {
        let si = |of: &Option<_>| of.as_ref().map_or(0.0, Quantity::si);
        let angle = |of: &Option<Quantity<FrictionAngle>>| of.as_ref().map(Quantity::si);
        let given = |of: &Option<Quantity<FrictionAngle>>| {
            of.as_ref().map(|angle| (angle.si(), angle.span.clone()))
        };
        let stiffness = |of: &Option<Quantity<_>>| of.as_ref().map(Quantity::si);
        let contact =
            [stiffness(&interface.normal_stiffness), stiffness(&interface.shear_stiffness)];
        // The default of the language for the shear stiffness.
        let half = |[normal, shear]: [Option<f64>; 2]| shear.or(normal.map(|k| 0.5 * k));
        match (space, &interface.bond) {
            (InSpace::Planar, Some(bond)) => {
                let normal = stiffness(&bond.normal_stiffness).or(contact[0]);
                Self {
                    normal,
                    shear: stiffness(&bond.shear_stiffness).or(half(contact)),
                    tension: bond.tension.si(),
                    cohesion: bond.cohesion.si(),
                    residual_cohesion: si(&bond.residual_cohesion),
                    friction: angle(&bond.friction_angle).or(angle(&interface.friction_angle)),
                    residual: given(&bond.residual_friction_angle),
                }
            }
            (InSpace::Planar, None) | (InSpace::Spatial, _) => Self {
                normal: contact[0],
                shear: half(contact),
                tension: si(&interface.tension),
                cohesion: si(&interface.cohesion),
                residual_cohesion: si(&interface.residual_cohesion),
                friction: angle(&interface.friction_angle),
                residual: given(&interface.residual_friction_angle),
            },
        }
    }
}

impl Rules {
    pub(super) fn behaviour(&mut self, of: &str, interface: &Interface) {
        if self.space == InSpace::Planar && interface.bond.is_none() {
            return;
        }
        self.dilation(of, interface);
        if !self.values_sound {
            return;
        }
        let joint = Joint::of(self.space, interface);
        self.flow(of, interface, &joint);
        if let Some(softening) = &interface.softening {
            self.softening(of, softening, &joint);
        }
        if let Some(rough) = &interface.barton_bandis {
            self.rough(of, rough, interface, &joint);
        }
    }

    /// Sliding loses `normal stress x (tan(friction) - tan(dilation))` per slip: with more dilation than friction it would make energy.
    fn flow(&mut self, of: &str, interface: &Interface, joint: &Joint) {
        let Some(angle) = &interface.dilation_angle else {
            return;
        };
        let coefficient = interface.friction_coefficient.as_ref();
        let peak = joint
            .friction
            // Dilation is an angle, so that friction is compared as one however it was given.
            .or(coefficient.map(|friction| libm::atan(friction.si())));
        let residual = joint.residual.as_ref().map(|(angle, _)| *angle);
        let least = peak.into_iter().chain(residual).fold(f64::INFINITY, f64::min);
        if angle.si() > least {
            let message = format!(
                "the dilation angle of {of} is above its friction angle: sliding would make energy"
            );
            let help = format!(
                "at most that of the smaller one of friction and residual friction, {:.4} deg",
                least.to_degrees()
            );
            self.error("value.order", &angle.span, message, &help);
        }
    }

    fn softening(&mut self, of: &str, said: &JointSoftening, joint: &Joint) {
        if joint.residual_cohesion > joint.cohesion {
            let message = format!("the residual cohesion of {of} is above its cohesion");
            let help = "softening goes from the peak down: lower `residual_cohesion`";
            self.error("value.order", &said.slip.span, message, help);
        }
        if let (Some(peak), Some((residual, at))) = (joint.friction, &joint.residual)
            && *residual > peak
        {
            let message = format!("the residual friction angle of {of} is above that of the peak");
            let help = "softening goes from the peak down: lower `residual_friction_angle`";
            self.error("value.order", at, message, help);
        }
        let points = said.curve.as_deref().unwrap_or_default();
        if let Some([first, _]) = points.first() {
            self.points_of_curve(of, points, &first.span);
        }
        // Steeper than its own springs a point would jump: two answers to one displacement.
        let steepest = curve(points).map_or(1.0, |curve| curve.steepest());
        let drop = steepest * (joint.cohesion - joint.residual_cohesion);
        if let Some(shear) = joint.shear
            && said.slip.si() * shear <= drop
        {
            let least = 1e3 * drop / shear;
            let message =
                format!("the shear strength of {of} softens faster than its springs give way");
            let help = format!(
                "above (cohesion - residual_cohesion)/shear_stiffness = {least:.3} mm the curve can be followed; raise \
                 `slip` or the stiffness, or leave `softening` out: then joints fail at once"
            );
            self.error("value.range", &said.slip.span, message, &help);
        }
        let opening = said.opening.as_ref().unwrap_or(&said.slip);
        if let Some(normal) = joint.normal
            && opening.si() * normal <= steepest * joint.tension
        {
            let least = 1e3 * steepest * joint.tension / normal;
            let message =
                format!("the tensile strength of {of} softens faster than its springs give way");
            let help = format!(
                "above tension/normal_stiffness = {least:.3} mm the curve can be followed; raise `opening` or the stiffness"
            );
            self.error("value.range", &opening.span, message, &help);
        }
    }

    fn rough(&mut self, of: &str, said: &BartonBandis, interface: &Interface, joint: &Joint) {
        if joint.tension > 0.0 || joint.cohesion > 0.0 {
            let message = format!("{of} has `barton_bandis` and a cohesion or a tensile strength");
            let help =
                "rough joints have friction alone: set `tension` and `cohesion` to \"0 MPa\"";
            self.error("value.range", &said.jrc.span, message, help);
        }
        if let Some(angle) = interface.dilation_angle.as_ref().filter(|a| a.si() > 0.0) {
            let message = format!("{of} has `barton_bandis` and `dilation_angle`");
            let help = "rough joints dilate by half of the angle that roughness adds: leave `dilation_angle` out";
            self.error("key.forbidden", &angle.span, message, help);
        }
    }
}
