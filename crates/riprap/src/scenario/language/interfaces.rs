//! Laws of contact between materials, and how phases change them.

use schemars::JsonSchema;
use serde::Deserialize;

use crate::scenario::quantity::{
    FrictionAngle, Name, NotNegativePlain, Quantity, Speed, StiffnessPerArea, Strength,
};

/// The law of contact between two materials.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Interface {
    /// The two materials that meet, for example `["rock", "steel"]`. Required, except in
    /// `default`, where it is forbidden.
    pub between: Option<[Name; 2]>,
    /// Normal law of found contacts. Default `distance_potential`.
    pub law: Option<NormalLaw>,
    /// How `penetration_potential` treats a reflex (inward) corner. Default `min`.
    pub reflex: Option<Reflex>,
    /// Normal stiffness per area of contact, Pa/m; greater than zero. Default
    /// 10 (K + 4G/3)/L from `young` and `poisson` of the materials, L the median block size.
    pub normal_stiffness: Option<Quantity<StiffnessPerArea>>,
    /// Shear stiffness per area of contact, Pa/m; greater than zero. Default half the normal one.
    pub shear_stiffness: Option<Quantity<StiffnessPerArea>>,
    /// Angle of friction, at least 0 and less than 90 deg. Give this or `friction_coefficient`.
    pub friction_angle: Option<Quantity<FrictionAngle>>,
    /// Tangent of the friction angle, zero or more. Give this or `friction_angle`.
    pub friction_coefficient: Option<Quantity<NotNegativePlain>>,
    /// Cohesion of found contacts, Pa; zero or more. Default 0 Pa.
    pub cohesion: Option<Quantity<Strength>>,
    /// Law of friction. Default `shear_spring`.
    pub friction_law: Option<FrictionLaw>,
    /// Slip speed below which `clipped` friction grows linearly, m/s. Needed by `clipped` only.
    pub clip_speed: Option<Quantity<Speed>>,
    /// Damping of the contact as a share of critical damping; zero or more. Default 0.2.
    pub damping_ratio: Option<Quantity<NotNegativePlain>>,
    /// Joins blocks that share an edge at the start with patches that can break.
    pub bond: Option<Bond>,
}

/// Normal law of a found contact.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum NormalLaw {
    /// Potential of the true distance to the boundary; conserves energy.
    DistancePotential,
    /// Mutual penetration potentials, as in the source paper.
    PenetrationPotential,
}

/// Reading of the penetration depth at a reflex (inward) corner.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Reflex {
    /// The smaller of the distances to the two edge lines.
    Min,
    /// The larger of the distances to the two edge lines.
    Max,
    /// The true distance to the corner.
    True,
}

/// Law of friction of found contacts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum FrictionLaw {
    /// Shear spring with a Coulomb slider: a block can stand still on a slope.
    ShearSpring,
    /// Full friction against the direction of slip, as in the source paper.
    RateSign,
    /// Like `rate_sign`, but growing linearly up to `clip_speed`.
    Clipped,
}

/// Patches along edges that two blocks share at the start.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Bond {
    /// Normal stiffness per area, Pa/m; greater than zero. Default that of the contact.
    pub normal_stiffness: Option<Quantity<StiffnessPerArea>>,
    /// Shear stiffness per area, Pa/m; greater than zero. Default that of the contact.
    pub shear_stiffness: Option<Quantity<StiffnessPerArea>>,
    /// Tensile strength, Pa; zero or more.
    pub tension: Quantity<Strength>,
    /// Cohesion, Pa; zero or more.
    pub cohesion: Quantity<Strength>,
    /// Angle of friction while unbroken, at least 0 and less than 90 deg. Default that of the
    /// contact.
    pub friction_angle: Option<Quantity<FrictionAngle>>,
    /// Angle of friction once broken. Default `friction_angle`.
    pub residual_friction_angle: Option<Quantity<FrictionAngle>>,
    /// Cohesion left once broken, Pa; zero or more. Default 0 Pa.
    pub residual_cohesion: Option<Quantity<Strength>>,
    /// Damping as a share of critical damping; zero or more. Default 0.2.
    pub damping_ratio: Option<Quantity<NotNegativePlain>>,
    /// Points along a shared edge at which the law is evaluated, 1 to 5. Default 2.
    pub points: Option<u8>,
}

/// Keys of an interface that change when a phase begins; all others stay.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct InterfaceChange {
    /// Normal law of found contacts.
    pub law: Option<NormalLaw>,
    /// How `penetration_potential` treats a reflex (inward) corner.
    pub reflex: Option<Reflex>,
    /// Normal stiffness per area of contact, Pa/m; greater than zero.
    pub normal_stiffness: Option<Quantity<StiffnessPerArea>>,
    /// Shear stiffness per area of contact, Pa/m; greater than zero.
    pub shear_stiffness: Option<Quantity<StiffnessPerArea>>,
    /// Angle of friction, at least 0 and less than 90 deg.
    pub friction_angle: Option<Quantity<FrictionAngle>>,
    /// Tangent of the friction angle, zero or more.
    pub friction_coefficient: Option<Quantity<NotNegativePlain>>,
    /// Cohesion of found contacts, Pa; zero or more.
    pub cohesion: Option<Quantity<Strength>>,
    /// Law of friction.
    pub friction_law: Option<FrictionLaw>,
    /// Slip speed below which `clipped` friction grows linearly, m/s.
    pub clip_speed: Option<Quantity<Speed>>,
    /// Damping of the contact as a share of critical damping; zero or more.
    pub damping_ratio: Option<Quantity<NotNegativePlain>>,
}
