//! Rules of deformable blocks and their bonds.

use super::Rules;
use crate::language::{
    Block, BrittleBond, Cohesive, Cutting, Load, Mechanics, Phase, Scenario, Support, Target, curve,
};
use crate::quantity::{NotNegativePlain, Quantity, Span};

/// Most parts that a block may be cut into.
const MOST_PARTS: u64 = 4096;

impl Rules {
    /// A deformable block needs elastic constants, and formulas that make sense.
    pub(super) fn deformable(&mut self, block: &Block, scenario: &Scenario) {
        let Some(Mechanics::Deformable(said)) = &block.mechanics else {
            return;
        };
        let material = scenario.materials.get(block.material.as_str());
        if let Some(material) = material
            && (material.young.is_none() || material.poisson.is_none())
        {
            let message = format!("the deformable block `{}` has no elasticity", block.name);
            let help = format!("give materials.{} `young` and `poisson`", block.material);
            self.error("key.missing", &block.material.span, message, &help);
        }
        for field in [&said.displacement, &said.velocity].into_iter().flatten() {
            for formula in field {
                self.formula(formula, &["x", "y", "z"]);
            }
        }
    }

    /// Bonds of an interface.
    pub(super) fn bond(&mut self, of: &str, bond: &BrittleBond, materials: &[(f64, f64)]) {
        let of = format!("{of}.brittle_bond");
        if bond.elastic {
            return;
        }
        if self.values_sound {
            self.cut_off(&of, bond);
            self.toughness(&of, bond, materials);
        }
    }

    /// Beyond the tip of the cone a bond in tension would have no shear strength.
    fn cut_off(&mut self, of: &str, bond: &BrittleBond) {
        let (Some(tension), Some(cohesion), Some(angle)) =
            (&bond.tension, &bond.cohesion, &bond.friction_angle)
        else {
            return;
        };
        // A tension calculated as cohesion/tan(friction_angle) lies a rounding to either side of the tip.
        if tension.si() * angle.tangent() > cohesion.si() * (1.0 + 1e-12) {
            let message = format!(
                "the tensile strength of {of} lies beyond the tip of the Mohr-Coulomb cone, {:.4} MPa",
                1e-6 * cohesion.si() / angle.tangent()
            );
            let help = "tension is cut off below cohesion / tan(friction_angle): lower `tension`, or raise `cohesion`";
            self.error("value.tip", &tension.span, message, help);
        }
    }

    /// Softening must need more energy than the bond holds when it begins.
    fn toughness(&mut self, of: &str, bond: &BrittleBond, materials: &[(f64, f64)]) {
        let Some(cohesive) = &bond.cohesive else {
            return;
        };
        self.curve(of, cohesive);
        let [normal, shear] = least_stiffness(bond, materials);
        for (key, energy, strength, stiffness) in [
            ("mode_1", &cohesive.mode_1, &bond.tension, normal),
            ("mode_2", &cohesive.mode_2, &bond.cohesion, shear),
        ] {
            let Some(strength) = strength.as_ref().map(Quantity::si) else {
                continue;
            };
            // What a spring holds at its peak: with less to lose, its curve would have to run back.
            let least = strength * strength / (2.0 * stiffness);
            if stiffness.is_finite() && energy.si() <= least {
                let message = format!(
                    "`{key}` of {of} is below what its springs hold when softening begins, {least:.4} J/m2"
                );
                let help = "raise it, or make the bond stiffer (a smaller `thickness`): the least is \
                            strength^2 / (2 stiffness)";
                self.error("value.range", &energy.span, message, help);
            }
        }
    }

    /// The curve of bonds has a name or points.
    fn curve(&mut self, of: &str, cohesive: &Cohesive) {
        let Some(curve) = &cohesive.curve else {
            return;
        };
        let span = curve.first().map_or(&cohesive.mode_1.span, |point| &point[0].span);
        self.points_of_curve(of, curve, span);
    }

    /// Points of a softening curve go down from the whole strength to nothing.
    pub(super) fn points_of_curve(
        &mut self,
        of: &str,
        points: &[[Quantity<NotNegativePlain>; 2]],
        span: &Span,
    ) {
        if let Err(error) = curve(points) {
            let message = format!("the softening `curve` of {of} cannot be used: {error}");
            let help = "list points [opening, share of the strength] from [0, 1] to [.., 0], openings \
                        ascending, shares falling, as in [[0, 1], [0.22, 0.33], [1, 0]]";
            self.error("value.order", span, message, help);
        }
    }

    /// Nodes can be held and driven, not loaded.
    pub(super) fn nodes(&mut self, support: &Support) {
        let Target::Nodes(nodes) = &support.on else {
            return;
        };
        self.corners_of_box(&nodes.min, &nodes.max);
    }

    /// See [`Rules::nodes`].
    pub(super) fn loaded(&mut self, load: &Load) {
        if let Target::Nodes(nodes) = &load.on {
            let message = "a load acts on blocks, not on single nodes".to_owned();
            let help = "use point = { force = [...], at = [...] } on the block: the nodes around the point take it";
            self.error("key.forbidden", &nodes.min.span, message, help);
        }
    }

    /// Keys of phases that only deformable blocks have.
    pub(super) fn relaxing(&mut self, phase: &Phase) {
        let of = format!("phase `{}`", phase.name);
        if let Some(cut) = &phase.cut {
            self.cutting(&phase.name.span, &of, cut);
        }
    }

    /// Limits of cutting that would explode the number of blocks.
    fn cutting(&mut self, span: &Span, of: &str, cut: &Cutting) {
        let of = format!("{of}.cut");
        let (planes, generations) = (cut.planes_or_default(), cut.generations_or_default());
        let parts = planes
            .saturating_add(1)
            // So that it fits into the exponent; so many generations are too many whatever `planes` is.
            .checked_pow(generations.min(64) as u32);
        // Any other number of planes has been refused by the schema.
        if (1..=7).contains(&planes) && parts.is_none_or(|parts| parts > MOST_PARTS) {
            let message = format!(
                "{of}: {planes} planes in {generations} generations make {}^{generations} parts of one block",
                planes + 1
            );
            let help = "(planes + 1)^generations may be 4096 at most: take fewer `planes` or `generations`";
            self.error("value.range", span, message, help);
        }
    }
}

/// Least stiffness of a bond across and along it, Pa/m: as given, or that of the softest material; infinite where it has none.
fn least_stiffness(bond: &BrittleBond, materials: &[(f64, f64)]) -> [f64; 2] {
    let thickness = match (&bond.normal_stiffness, &bond.thickness) {
        (Some(normal), _) => {
            let normal = normal.si();
            return [normal, bond.shear_stiffness.as_ref().map_or(0.5 * normal, Quantity::si)];
        }
        (None, Some(thickness)) => thickness.si(),
        (None, None) => return [f64::INFINITY; 2],
    };
    let own = bond.young.as_ref().zip(bond.poisson.as_ref());
    let own = own.map(|(e, nu)| vec![(e.si(), nu.si())]);
    let softest = own.unwrap_or_else(|| materials.to_vec());
    let young = softest.iter().map(|m| m.0);
    let shear = softest.iter().map(|m| 0.5 * m.0 / (1.0 + m.1));
    [
        young.fold(f64::INFINITY, f64::min) / thickness,
        shear.fold(f64::INFINITY, f64::min) / thickness,
    ]
}
