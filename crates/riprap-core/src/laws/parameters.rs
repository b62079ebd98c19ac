//! Parameters of the contact and bond laws, SI, and the choices that a scenario names by words.

use riprap_keys::Words;
use serde::{Deserialize, Serialize};

use super::behaviour::{JointModel, Law};
use super::mohr_coulomb::Strength;

/// Normal law of a found contact.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Words)]
pub enum NormalLaw {
    /// Potential of the true distance to the boundary; conserves energy.
    ///
    /// The pressure is proportional to the true distance to the other block's whole boundary.
    #[default]
    DistancePotential,
    /// Mutual penetration potentials, as in the source paper.
    ///
    /// Linear between vertices: local, not conservative.
    PenetrationPotential,
}

/// Reading of the penetration depth at a reflex (inward) corner.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Words)]
pub enum Reflex {
    /// The smaller of the distances to the two edge lines.
    ///
    /// Uniform with convex corners.
    #[default]
    Min,
    /// The larger of the distances to the two edge lines.
    Max,
    /// The true distance to the corner.
    True,
}

/// Law of friction of found contacts.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Words)]
pub enum FrictionLaw {
    /// Shear spring with a Coulomb slider: a block can stand still on a slope.
    ///
    /// Incremental, with a dashpot while it sticks.
    #[default]
    ShearSpring,
    /// Full friction against the direction of slip, as in the source paper.
    ///
    /// mu times the normal force, against the sliding direction of each piece.
    RateSign,
    /// Like `rate_sign`, but growing linearly up to `clip_speed`.
    Clipped,
}

/// Law of contacts found from geometry.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct ContactLaw {
    /// Normal law.
    pub normal: NormalLaw,
    /// How the depth at a reflex corner is read, by the penetration potentials.
    pub reflex: Reflex,
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
    /// Sliding speed at which clipped friction is full, m/s; greater than zero where friction is clipped.
    pub clip_speed: f64,
    /// Dashpots, as a share of critical damping for the contact's stiffness and the pair's mass.
    pub damping_ratio: f64,
}

impl ContactLaw {
    /// The law with its strength divided by `factor` (Zienkiewicz, Humpheson and Lewis 1975): cohesion and the tangent of the
    /// friction angle; stiffness and damping stay.
    #[must_use]
    pub fn reduced(mut self, factor: f64) -> Self {
        self.friction /= factor;
        self.cohesion /= factor;
        self
    }

    /// Whether there is anything that [`ContactLaw::reduced`] divides.
    #[must_use]
    pub fn has_strength(&self) -> bool {
        self.friction > 0.0 || self.cohesion > 0.0
    }
}

/// Law of a patch built along an edge shared at the start.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct BondLaw {
    /// Normal stiffness, Pa/m.
    pub normal_stiffness: f64,
    /// Shear stiffness, Pa/m.
    pub shear_stiffness: f64,
    /// Strength.
    pub strength: Strength,
    /// What it does beyond brittle failure and a linear spring.
    pub behaviour: JointModel,
    /// Share of critical damping.
    pub damping_ratio: f64,
    /// Number of points along the edge (Gauss points), 1 to 5.
    pub points: u8,
}

impl BondLaw {
    /// The law with all its strengths divided by `factor`, residual ones too.
    #[must_use]
    pub fn reduced(mut self, factor: f64) -> Self {
        self.strength = self.strength.reduced(factor);
        self.behaviour = self.behaviour.reduced(factor);
        self
    }

    /// Largest stiffness that the normal and the shear spring can reach, Pa/m.
    #[must_use]
    pub fn stiffest(&self) -> [f64; 2] {
        [self.normal_stiffness * self.behaviour.closure.stiffest(), self.shear_stiffness]
    }

    /// The general law, where brittle failure and a linear spring are not all of it.
    #[must_use]
    pub fn law(&self) -> Option<Law<'_>> {
        let plain = self.behaviour.is_plain() && self.strength.dilation == 0.0;
        (!plain).then(|| Law::new(Some(&self.strength), &self.behaviour, self.stiffest()))
    }
}

/// Law of a patch; by default elastic, with the stiffness of the material and without dashpots.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct JointLaw {
    /// Where the stiffness comes from.
    pub stiffness: Stiffness,
    /// Strength; `None` is elastic: it neither opens nor slides.
    pub strength: Option<Strength>,
    /// What it does beyond brittle failure and a linear spring.
    pub behaviour: JointModel,
    /// What fails as one.
    pub failure: Failure,
    /// Where the four points lie.
    pub points: Points,
    /// Dashpots parallel to the springs of closed points: `beta = damping * d / c_P` with d the distance of the
    /// centroids across the patch, so that fine and coarse blocks are damped alike.
    pub damping: f64,
    /// Dashpots of found contacts under this law, as a share of critical damping.
    pub contact_damping: f64,
    /// Speed after an impact over that before it, where the scene gives it: in implicit steps, which no dashpots act in.
    pub rebound: f64,
    /// Where those along the patch act.
    pub dashpots: Dashpots,
    /// Depth of a found contact at which it presses twice as hard as its stiffness says, over the radius of the largest ball in the thinner block; 0:
    /// pressures grow with the depth alone.
    pub stiffening: f64,
}

impl JointLaw {
    /// Whether brittle failure and a linear spring are all of it.
    #[must_use]
    pub fn is_plain(&self) -> bool {
        self.behaviour.is_plain() && self.strength.is_none_or(|s| s.dilation == 0.0)
    }

    /// The general law of a patch with the largest stiffness `stiffest` (normal and shear, Pa/m), where the law is not plain.
    #[must_use]
    pub fn law(&self, stiffest: [f64; 2]) -> Option<Law<'_>> {
        (!self.is_plain()).then(|| Law::new(self.strength.as_ref(), &self.behaviour, stiffest))
    }

    /// The law with all its strengths divided by `factor`, residual ones too.
    #[must_use]
    pub fn reduced(mut self, factor: f64) -> Self {
        self.strength = self.strength.map(|strength| strength.reduced(factor));
        self.behaviour = self.behaviour.reduced(factor);
        self
    }
}

/// Stiffness of a patch per area.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum Stiffness {
    /// Half-block compliances of both sides in series: `Kn = M/d`, `Ks = 2G/d` for equal materials, or `Kn = E/d`.
    Rule(StiffnessRule),
    /// Given.
    Given {
        /// Normal, Pa/m.
        normal: f64,
        /// Shear, Pa/m.
        shear: f64,
    },
}

impl Default for Stiffness {
    fn default() -> Self {
        Self::Rule(StiffnessRule::default())
    }
}

/// What fails as one.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Words)]
pub enum Failure {
    /// Each of the four points of a joint by itself.
    #[default]
    Point,
    /// The whole joint, by the sum of its forces and its torsion.
    Face,
}

/// Where the four points of a joint lie.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Words)]
pub enum Points {
    /// Gauss points: exact bending and torsion.
    #[default]
    Gauss,
    /// Centres of the four quarters, as the source paper has them.
    Quarter,
}

impl Points {
    /// Their distance from the centre along either axis over the radius of gyration of the face: Gauss points lie at the radii
    /// of gyration L/sqrt 12, quarter points at L/4.
    #[must_use]
    pub fn spread(self) -> f64 {
        match self {
            Self::Gauss => 1.0,
            Self::Quarter => 0.75f64.sqrt(),
        }
    }
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

/// Where the stiffness of joints comes from: the elastic half blocks on both sides in series.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Words)]
pub enum StiffnessRule {
    /// Constrained modulus M/d and shear 2G/d, d the distance of the centroids: right wave speeds.
    #[default]
    Material,
    /// Young's modulus E/d and shear 2G/d: right settlement under uniaxial stress, for static
    /// questions.
    Uniaxial,
}

/// How blocks turn.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Words)]
pub enum Kinematics {
    /// Small displacements until a block has turned by `rotation_bound`; from then on finite
    /// rotations for it and the patches it touches.
    #[default]
    Automatic,
    /// Small displacements at all times: lever arms stay as they were.
    Small,
    /// Finite rotations from the start.
    Finite,
}

/// Where the planes of a cut lie.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Words)]
pub enum CutAnchor {
    /// At equal distances.
    #[default]
    Spacing,
    /// One goes through the tip of a crack; only blocks at a tip are cut, and only facets at a tip break.
    Tip,
}
