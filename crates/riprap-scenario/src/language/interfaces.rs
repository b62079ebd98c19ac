//! Laws of contact between materials, and how phases change them.

use riprap_keys::Keys;
use serde::Deserialize;

use crate::quantity::{
    AtLeastOne, FractureEnergy, FrictionAngle, JointRoughness, Modulus, Name, NotNegativePlain,
    Poisson, PositiveLength, PositiveStrength, Quantity, Restitution, Share, Speed,
    StiffnessPerArea, Strength,
};
use riprap_core::laws::bond::Softening;
use riprap_core::laws::parameters::{
    BondFailure, Dashpots, Failure, FrictionLaw, NormalLaw, Points, Reflex, StiffnessRule,
};
use riprap_core::laws::softening_curve::{Curve, CurveError};

/// The law of contact between two materials.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
#[keys(change = InterfaceChange, path = "interfaces.*")]
#[keys(one_of("friction_angle", "friction_coefficient", when = "!elastic & !brittle_bond"))]
#[keys(at_most_one("stiffness", "normal_stiffness"))]
#[keys(at_most_one("softening", "barton_bandis"))]
#[keys(at_most_one(
    "damping_ratio",
    "restitution",
    help = "keep one of them: dashpots of found contacts follow from either"
))]
#[keys(only_with(
    reader = "sliding",
    when = "!elastic",
    help = "an elastic joint neither opens nor slides"
))]
#[keys(needs(
    "dilation_angle",
    "softening",
    "barton_bandis",
    "closure",
    when = "bond",
    space = "planar",
    help = "found contacts in the plane are linear springs with Coulomb friction; give the interface `bond`, which makes joints \
            of shared edges"
))]
pub struct Interface {
    /// The two materials that meet, for example `["rock", "steel"]`. Required, except in
    /// `default`, where it is forbidden.
    pub between: Option<[Name; 2]>,
    /// Normal law of found contacts.
    #[key(space = "planar", instead = "joints are elastic up to their strength; leave it out")]
    #[key(default, changes)]
    pub law: Option<NormalLaw>,
    /// How a reflex (inward) corner acts.
    #[key(space = "planar")]
    #[key(default, changes)]
    #[key(only_with("law = penetration_potential"))]
    pub reflex: Option<Reflex>,
    /// Where the stiffness of joints comes from, without `normal_stiffness`.
    #[key(
        space = "spatial",
        instead = "give `normal_stiffness`, or the elastic constants of the materials"
    )]
    #[key(default, read_by("joints"))]
    pub stiffness: Option<StiffnessRule>,
    /// Normal stiffness per area of contact, Pa/m. Default in `[space.planar]`
    /// 10 (K + 4G/3)/L from `young` and `poisson` of the materials, L the median block size; in
    /// `[space.spatial]` by `stiffness`.
    #[key(changes, read_by("joints"))]
    pub normal_stiffness: Option<Quantity<StiffnessPerArea>>,
    /// Shear stiffness per area of contact, Pa/m. Default half the normal one.
    #[key(needs(
        "normal_stiffness",
        space = "spatial",
        help = "give both, or neither: then they come from the materials"
    ))]
    #[key(changes, read_by("joints"))]
    pub shear_stiffness: Option<Quantity<StiffnessPerArea>>,
    /// Whether joints neither open nor slide; found contacts do, by the friction given. Default false: Mohr-Coulomb, tension
    /// cut-off.
    #[key(space = "spatial", instead = "use `bond` with a high strength")]
    #[serde(default)]
    #[key(read_by("joints"))]
    pub elastic: bool,
    /// Angle of friction.
    #[key(changes, read_by("joints"))]
    pub friction_angle: Option<Quantity<FrictionAngle>>,
    /// Tangent of the friction angle.
    #[key(changes, read_by("joints"))]
    pub friction_coefficient: Option<Quantity<NotNegativePlain>>,
    /// Cohesion, Pa.
    #[key(default = "0 Pa", changes, read_by("joints", "sliding"))]
    pub cohesion: Option<Quantity<Strength>>,
    /// Tensile strength of joints, Pa.
    #[key(space = "spatial", instead = "it belongs into `bond`")]
    #[key(default = "0 Pa", changes, read_by("joints", "sliding"))]
    pub tension: Option<Quantity<Strength>>,
    /// Angle of friction of joints that have failed. Default `friction_angle`.
    #[key(space = "spatial", instead = "it belongs into `bond`")]
    #[key(changes, read_by("joints", "sliding"))]
    pub residual_friction_angle: Option<Quantity<FrictionAngle>>,
    /// Cohesion of joints that have failed, Pa.
    #[key(space = "spatial", instead = "it belongs into `bond`")]
    #[key(default = "0 Pa", changes, read_by("joints", "sliding"))]
    pub residual_cohesion: Option<Quantity<Strength>>,
    /// Angle of dilation of joints that slide; in the plane of `bond`.
    #[key(default = "0 deg", read_by("joints", "sliding"))]
    pub dilation_angle: Option<Quantity<FrictionAngle>>,
    /// Slip at which dilation ends, m, needed where the angle is more than 0; joints that slide back close again.
    #[key(read_by("joints"))]
    #[key(only_with("dilation_angle"))]
    pub dilation_end: Option<Quantity<PositiveLength>>,
    /// Lets joints (in the plane `bond`) weaken gradually.
    #[key(read_by("sliding"))]
    pub softening: Option<JointSoftening>,
    /// Friction of rough joints (in the plane `bond`): tan(phi_r + JRC log10(JCS/s)), phi_r the residual friction angle.
    #[key(read_by("sliding"))]
    pub barton_bandis: Option<BartonBandis>,
    /// Lets joints (in the plane `bond`) stiffen under pressure; `normal_stiffness` is the initial one.
    pub closure: Option<Closure>,
    /// What fails as one.
    #[key(space = "spatial")]
    #[key(default, read_by("joints", "sliding"))]
    pub failure: Option<Failure>,
    /// Where the four points of a joint lie.
    #[key(space = "spatial")]
    #[key(default, read_by("joints"))]
    pub points: Option<Points>,
    /// Law of friction.
    #[key(space = "planar")]
    #[key(default, changes)]
    pub friction_law: Option<FrictionLaw>,
    /// Slip speed below which `clipped` friction grows linearly, m/s.
    #[key(space = "planar")]
    #[key(changes)]
    #[key(required("friction_law = clipped"))]
    #[key(only_with("friction_law = clipped"))]
    pub clip_speed: Option<Quantity<Speed>>,
    /// Share of critical damping of found contacts; of closed joints in `[space.spatial]` dashpots with the time
    /// constant `damping_ratio` times distance of the centroids over c_P, that of the materials where `young` and `poisson` are
    /// given, else that of a lattice with the stiffness of the joint, the root of kn d / density.
    #[key(planar = "0.2", spatial = "0.1", changes, read_by("joints"))]
    pub damping_ratio: Option<Quantity<NotNegativePlain>>,
    /// Share of its speed left by a flat impact, less by corners; in place of `damping_ratio`. Without either 0.2 in space.
    #[key(changes)]
    pub restitution: Option<Quantity<Restitution>>,
    /// Depth of an overlap of rigid blocks at which it presses twice as hard as `normal_stiffness` says, over the radius of the largest ball in the
    /// thinner block: p = k d (1 + (d/D)^2). Blocks that gas or a fast impact drives on an edge are stopped. Without it p = k d.
    #[key(space = "spatial", instead = "give a larger `normal_stiffness`")]
    #[key(read_by("joints"))]
    pub stiffening_depth: Option<Quantity<Share>>,
    /// Points of a joint on which its dashpots and those of `damping.stiffness` act along it; across it on all closed ones.
    #[key(space = "spatial")]
    #[key(default, read_by("joints", "sliding"))]
    pub dashpots: Option<Dashpots>,
    /// Joins blocks that share an edge at the start with patches that can break.
    #[key(
        space = "planar",
        instead = "give `tension`, `cohesion`, ... of the interface itself: blocks that share a face are joined"
    )]
    pub bond: Option<Bond>,
    /// Bonds between deformable blocks, and between a deformable and a rigid one. Strengths that the interface itself
    /// does not give are also those of its joints between rigid blocks.
    #[key(space = "spatial", instead = "use `bond`")]
    pub brittle_bond: Option<BrittleBond>,
}

/// Change from peak to residual strength, by slip over `slip` plus opening over `opening`: linear, or along `curve`.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
pub struct JointSoftening {
    /// Plastic slip at which the residual strength is left, m; above (peak - residual)/shear stiffness.
    pub slip: Quantity<PositiveLength>,
    /// Opening at which no tensile strength is left, m; above tension/normal stiffness. Default `slip`.
    pub opening: Option<Quantity<PositiveLength>>,
    /// Curve by points [share of slip and opening, share of the loss of strength that is left], from [0, 1] down to [.., 0], 2 to 8.
    /// Default a straight line.
    pub curve: Option<Vec<[Quantity<NotNegativePlain>; 2]>>,
}

/// Roughness of laboratory samples of 0.1 m, or of the joint itself.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
pub struct BartonBandis {
    /// Joint roughness coefficient.
    pub jrc: Quantity<JointRoughness>,
    /// Compressive strength of the walls, Pa.
    pub jcs: Quantity<PositiveStrength>,
    /// Length of the joint, m: JRC and JCS are scaled to it, and `peak_slip` follows.
    pub length: Option<Quantity<PositiveLength>>,
    /// Slip at the peak, m: strength is mobilised towards it and falls beyond. Without it and `length` the peak strength acts
    /// throughout.
    pub peak_slip: Option<Quantity<PositiveLength>>,
}

/// Pressure k V/(1 - V/limit) at the closure V.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
pub struct Closure {
    /// Largest closure, m.
    pub limit: Quantity<PositiveLength>,
    /// Largest stiffness over the initial one: it sets the time step, and the curve is straight from there on.
    #[key(default = "25")]
    pub stiffest: Option<Quantity<AtLeastOne>>,
}

/// Springs over the shared part of two faces that break by Mohr-Coulomb with a tension cut-off; what is broken is a contact with
/// friction.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
#[keys(one_of(
    "thickness",
    "normal_stiffness",
    help = "springs follow from thickness = \"0.3 mm\" and moduli, or are given as normal_stiffness = \"10 GPa/m\""
))]
#[keys(required(
    "tension",
    "cohesion",
    "friction_angle",
    when = "!elastic",
    help = "give its strength, for example tension = \"2 MPa\", cohesion = \"10 MPa\", friction_angle = \"30 deg\"; or elastic = true"
))]
#[keys(only_with(
    "tension",
    "cohesion",
    "friction_angle",
    "residual_friction_angle",
    "residual_cohesion",
    "cohesive",
    "failure",
    when = "!elastic",
    help = "an elastic bond never breaks"
))]
pub struct BrittleBond {
    /// Thickness L of the interface, m: springs E/L and G/L per area. One for all facets; 0.01 of the smallest block
    /// adds 1 % of compliance.
    #[key(read_by("bonds"))]
    pub thickness: Option<Quantity<PositiveLength>>,
    /// Young's modulus of the interface, Pa. Default those of the two materials in series.
    #[key(read_by("bonds"))]
    #[key(needs(
        "poisson",
        help = "give both, or neither: then they are those of the two materials"
    ))]
    pub young: Option<Quantity<Modulus>>,
    /// Poisson's ratio of the interface.
    #[key(read_by("bonds"))]
    #[key(needs(
        "young",
        help = "give both, or neither: then they are those of the two materials"
    ))]
    pub poisson: Option<Quantity<Poisson>>,
    /// Normal stiffness per area, Pa/m.
    #[key(read_by("bonds"))]
    #[key(excludes("young", "poisson", help = "moduli go with `thickness`: leave them out"))]
    pub normal_stiffness: Option<Quantity<StiffnessPerArea>>,
    /// Shear stiffness per area, Pa/m. Default half `normal_stiffness`.
    #[key(needs("normal_stiffness", help = "give both, in place of `thickness`"))]
    #[key(read_by("bonds"))]
    pub shear_stiffness: Option<Quantity<StiffnessPerArea>>,
    /// Whether bonds never break. Default false.
    #[serde(default)]
    pub elastic: bool,
    /// Tensile strength, Pa.
    pub tension: Option<Quantity<Strength>>,
    /// Cohesion, Pa.
    pub cohesion: Option<Quantity<Strength>>,
    /// Angle of friction.
    pub friction_angle: Option<Quantity<FrictionAngle>>,
    /// Angle of friction of broken bonds. Default `friction_angle`.
    pub residual_friction_angle: Option<Quantity<FrictionAngle>>,
    /// Cohesion of broken bonds under pressure, Pa.
    #[key(excludes(
        "cohesive",
        help = "a bond that softens loses all of its cohesion: leave one out"
    ))]
    #[key(default = "0 Pa", read_by("bonds"))]
    pub residual_cohesion: Option<Quantity<Strength>>,
    /// Lets bonds soften: the work of separation is then that of the material and not of the mesh.
    #[key(read_by("bonds"))]
    #[key(excludes(
        "failure = facet, block_stress & !elastic",
        help = "bonds that soften do so spring by spring: leave out `failure`"
    ))]
    pub cohesive: Option<Cohesive>,
    /// What fails as one.
    #[key(default, read_by("bonds"))]
    pub failure: Option<BondFailure>,
}

/// Energies of separation of softening bonds.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
#[keys(at_most_one("softening", "curve"))]
pub struct Cohesive {
    /// Fracture energy of opening, J/m2 = N/m; above tension^2 thickness/(2 E), below which the bond cannot resolve it.
    pub mode_1: Quantity<FractureEnergy>,
    /// Fracture energy of sliding, J/m2 = N/m; above cohesion^2 thickness/(2 G).
    pub mode_2: Quantity<FractureEnergy>,
    /// Curve from the peak to nothing.
    #[key(default)]
    pub softening: Option<Softening>,
    /// Curve by points [opening past the peak in any unit, share of the strength], from [0, 1] down to [.., 0], 2 to 8; with two lines
    /// it is bilinear. Its length follows from the fracture energy.
    pub curve: Option<Vec<[Quantity<NotNegativePlain>; 2]>>,
}

/// The softening curve through points.
///
/// # Errors
/// Points that are no curve from the whole strength down to nothing.
pub fn curve(points: &[[Quantity<NotNegativePlain>; 2]]) -> Result<Curve, CurveError> {
    let points: Vec<[f64; 2]> = points.iter().map(|[x, y]| [x.si(), y.si()]).collect();
    Curve::new(&points)
}

/// Patches along edges that two blocks share at the start.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
pub struct Bond {
    /// Normal stiffness per area, Pa/m. Default that of the contact.
    pub normal_stiffness: Option<Quantity<StiffnessPerArea>>,
    /// Shear stiffness per area, Pa/m. Default that of the contact.
    pub shear_stiffness: Option<Quantity<StiffnessPerArea>>,
    /// Tensile strength, Pa.
    pub tension: Quantity<Strength>,
    /// Cohesion, Pa.
    pub cohesion: Quantity<Strength>,
    /// Angle of friction while unbroken. Default that of the contact.
    pub friction_angle: Option<Quantity<FrictionAngle>>,
    /// Angle of friction once broken. Default `friction_angle`.
    pub residual_friction_angle: Option<Quantity<FrictionAngle>>,
    /// Cohesion left once broken, Pa.
    #[key(default = "0 Pa")]
    pub residual_cohesion: Option<Quantity<Strength>>,
    /// Damping as a share of critical damping.
    #[key(default = "0.2")]
    pub damping_ratio: Option<Quantity<NotNegativePlain>>,
    /// Points along a shared edge at which the law is evaluated, 1 to 5.
    #[key(default = 2, min = 1, max = 5)]
    pub points: Option<u8>,
}
