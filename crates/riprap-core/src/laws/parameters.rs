//! Parameters of the contact and bond laws, SI.

use riprap_keys::Words;
use serde::{Deserialize, Serialize};

/// Normal law of a found contact.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum NormalLaw {
    /// Pressure proportional to the true distance to the other block's whole boundary (conservative).
    DistancePotential,
    /// The source's mutual penetration potentials, linear between vertices (local, not conservative).
    PenetrationPotential {
        /// How the depth at a reflex corner is read.
        reflex: Reflex,
    },
}

/// Reading of the penetration depth at a reflex (inward) corner.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Words)]
pub enum Reflex {
    /// The smaller of the distances to the two edge lines.
    ///
    /// Uniform with convex corners.
    Min,
    /// The larger of the distances to the two edge lines.
    Max,
    /// The true distance to the corner.
    True,
}

/// Friction law of a found contact.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum FrictionLaw {
    /// Incremental shear spring with a Coulomb slider and a sticking dashpot.
    ShearSpring,
    /// The source's law: mu times the normal force, against the sliding direction of each piece.
    RateSign,
    /// As `RateSign`, smoothed to `v / speed` below `speed` (m/s).
    Clip {
        /// Sliding speed at which full friction is reached, m/s.
        speed: f64,
    },
}

/// Law of contacts found from geometry.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct ContactLaw {
    /// Normal law.
    pub normal: NormalLaw,
    /// Normal stiffness kn (pn in the source), Pa/m.
    pub normal_stiffness: f64,
    /// Shear stiffness ks, Pa/m.
    pub shear_stiffness: f64,
    /// Friction coefficient, tan(phi).
    pub friction: f64,
    /// Cohesion on the contact length, Pa.
    pub cohesion: f64,
    /// Friction law.
    pub friction_law: FrictionLaw,
    /// Dashpots, as a share of critical damping for the contact's stiffness and the pair's mass.
    pub damping_ratio: f64,
}

/// Law of a patch built along an edge shared at the start.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct BondLaw {
    /// Normal stiffness, Pa/m.
    pub normal_stiffness: f64,
    /// Shear stiffness, Pa/m.
    pub shear_stiffness: f64,
    /// Tensile strength, Pa.
    pub tension: f64,
    /// Cohesion before failure, Pa.
    pub cohesion: f64,
    /// Friction coefficient before failure, tan(phi).
    pub friction: f64,
    /// Friction coefficient after failure.
    pub residual_friction: f64,
    /// Cohesion after failure, Pa.
    pub residual_cohesion: f64,
    /// Share of critical damping.
    pub damping_ratio: f64,
    /// Number of points along the edge (Gauss points), 1 to 5.
    pub points: u8,
}

/// What fails as one.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Words)]
pub enum Failure {
    /// Each of the four points of a joint by itself.
    Point,
    /// The whole joint, by the sum of its forces and its torsion.
    Face,
}

/// Where the four points of a joint lie.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Words)]
pub enum Points {
    /// Gauss points: exact bending and torsion.
    Gauss,
    /// Centres of the four quarters, as the source paper has them.
    Quarter,
}

/// Points of a joint on which its dashpots act along it.
///
/// Those across it act on all closed points.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Words)]
pub enum Dashpots {
    /// Closed points that do not slide: blocks slide with friction alone.
    ///
    /// Deviation: the source has them on all closed points. There they add `beta ks v` to the friction, which grows with
    /// the speed and stops what should slide.
    #[default]
    Sticking,
    /// All closed points, as in the source paper: they hold sliding blocks back.
    Closed,
}

/// What fails as one.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Words)]
pub enum BondFailure {
    /// Each spring by its own traction (the source).
    #[default]
    Spring,
    /// A facet by the mean traction of its springs.
    Facet,
    /// A facet by the mean of the average stresses of its two blocks: does not depend on the size of the facet.
    BlockStress,
}
