//! Stable time step: which block sets it, and why.
//!
//! With the velocity of half a step before in the dashpots the leapfrog is stable while
//! `x . (dt² K + 2 dt C) x <= 4 x . M x` for every motion x. Power iteration finds the motion that comes nearest, with the
//! springs and dashpots of all patches and boundaries and their masses. One damping ratio for the whole model would
//! let the dashpots of its coarsest blocks shorten the step of its finest.

use riprap_geom::Vec3;

use super::deform;
use super::setup::BoundaryKind;
use super::state::scratch::Scratch;
use super::world::{PatchClass, World};
use crate::laws::face_joint::SIGNS;

/// Sweeps of the power iteration for the springs alone.
const SWEEPS: usize = 60;
/// Rounds that bring in the dashpots, and sweeps in each.
const ROUNDS: (usize, usize) = (6, 12);
/// The estimate of the highest squared frequency comes from below; what is added to it.
const MARGIN: f64 = 1.005;

/// The largest stable step and the block that sets it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stable {
    /// Stable time step (safety 1), s; infinite when nothing holds the blocks.
    pub dt: f64,
    /// Index of the block that moves most in the fastest mode.
    pub block: Option<u32>,
    /// What makes the mode fast.
    pub why: &'static str,
}

/// Finds the stable step of the patches and boundaries as they were built; `stiffness_damping` is that of the
/// phase, s.
#[must_use]
pub fn stable_step(world: &World, scratch: &Scratch, stiffness_damping: f64) -> Stable {
    let rigid = rigid_step(world, stiffness_damping);
    let (Some(deform), Some(work)) = (world.deform.as_deref(), scratch.deform.as_deref()) else {
        return rigid;
    };
    let (square, block) = deform::stable::highest(world, deform, work, &scratch.exec);
    if square == 0.0 {
        return rigid;
    }
    let square = square + deform::stable::on_bonds(world, deform);
    // The largest eigenvalue of a sum is at most the sum of the largest ones.
    let dt = 2.0 / (square + (2.0 / rigid.dt).powi(2)).sqrt();
    if 2.0 / square.sqrt() > rigid.dt {
        return Stable { dt, ..rigid };
    }
    Stable {
        dt,
        block,
        why: "nodes against their bonds and tetrahedra",
    }
}

/// The same for the rigid blocks and their patches.
fn rigid_step(world: &World, stiffness_damping: f64) -> Stable {
    let n = world.alive.len();
    let springs = Springs::new(world);
    // A start that has a part of every mode: no symmetry, no zeros.
    let mut seed = 0x9e37_79b9_7f4a_7c15_u64;
    let mut draw = || {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        (seed >> 11) as f64 / (1u64 << 53) as f64 - 0.5
    };
    let mut x: Vec<[Vec3; 2]> = (0..n)
        .map(|_| [0, 1].map(|_| Vec3::new(draw(), draw(), draw())))
        .collect();
    let mut y = vec![[Vec3::ZERO; 2]; n];
    let ck = stiffness_damping;
    for _ in 0..SWEEPS {
        springs.times(world, Weights::SPRINGS, &x, &mut y);
        if !normalise(&mut x, &y) {
            return Stable {
                dt: f64::INFINITY,
                block: None,
                why: "nothing holds the blocks",
            };
        }
    }
    springs.times(world, Weights::SPRINGS, &x, &mut y);
    let mut dt = 2.0 / (MARGIN * dot(&x, &y)).sqrt();
    if springs.damped(world, ck) {
        for _ in 0..ROUNDS.0 {
            for _ in 0..ROUNDS.1 {
                springs.times(world, Weights::step(dt, ck), &x, &mut y);
                normalise(&mut x, &y);
            }
            springs.times(world, Weights::SPRINGS, &x, &mut y);
            let k = MARGIN * dot(&x, &y);
            springs.times(world, Weights::dashpots(ck), &x, &mut y);
            let c = MARGIN * dot(&x, &y);
            // k dt² + 2 c dt = 4, in the form without cancellation.
            dt = 4.0 / (c + (c * c + 4.0 * k).sqrt());
        }
    }
    name(world, &springs, &x, dt)
}

/// x <- y / |y|; false when y is nil.
fn normalise(x: &mut [[Vec3; 2]], y: &[[Vec3; 2]]) -> bool {
    let scale = dot(y, y).sqrt();
    if scale == 0.0 {
        return false;
    }
    for (a, b) in x.iter_mut().zip(y) {
        *a = b.map(|v| v / scale);
    }
    true
}

fn dot(x: &[[Vec3; 2]], y: &[[Vec3; 2]]) -> f64 {
    let one = |(a, b): (&[Vec3; 2], &[Vec3; 2])| a[0].dot(b[0]) + a[1].dot(b[1]);
    x.iter().zip(y).map(one).sum()
}

/// Says which block moves most in the fastest motion.
fn name(world: &World, springs: &Springs, x: &[[Vec3; 2]], dt: f64) -> Stable {
    let size = |v: &[Vec3; 2]| v[0].length_squared() + v[1].length_squared();
    let mut block = 0;
    for (b, v) in x.iter().enumerate() {
        if world.alive[b] && size(v) > size(&x[block]) {
            block = b;
        }
    }
    let (turning, moving) = (x[block][1].length_squared(), x[block][0].length_squared());
    let why = if springs.faces.iter().any(|f| f.block as usize == block) {
        "springs of patches and of a boundary"
    } else if turning > moving {
        "rotation against the springs of its patches"
    } else {
        "translation against the springs of its patches"
    };
    Stable {
        dt,
        block: Some(block as u32),
        why,
    }
}

/// What of springs and dashpots goes into a matrix: `spring K + dashpot C`.
#[derive(Clone, Copy)]
struct Weights {
    spring: f64,
    dashpot: f64,
    /// Stiffness-proportional damping of the phase, s.
    ck: f64,
}

impl Weights {
    const SPRINGS: Self = Self {
        spring: 1.0,
        dashpot: 0.0,
        ck: 0.0,
    };

    fn dashpots(ck: f64) -> Self {
        Self {
            spring: 0.0,
            dashpot: 1.0,
            ck,
        }
    }

    fn step(dt: f64, ck: f64) -> Self {
        Self {
            spring: dt * dt,
            dashpot: 2.0 * dt,
            ck,
        }
    }

    /// For a spring with a dashpot of `beta` times its stiffness.
    fn of(self, beta: f64) -> f64 {
        self.spring + self.dashpot * (beta + self.ck)
    }
}

/// All springs, scaled by the roots of the masses so that the matrix is symmetric.
struct Springs {
    /// 1/sqrt(m) and 1/sqrt(I) per block; 0 for what cannot move.
    root: Vec<[Vec3; 2]>,
    faces: Vec<FaceSpring>,
}

struct FaceSpring {
    block: u32,
    frame: [Vec3; 3],
    arm: Vec3,
    area: f64,
    reach: [f64; 2],
    stiffness: [f64; 2],
    /// Dashpots on the velocity of the face, Pa s/m.
    impedance: [f64; 2],
}

impl Springs {
    fn new(world: &World) -> Self {
        let root = (0..world.alive.len())
            .map(|b| {
                if !world.alive[b] || world.deforms(b) {
                    return [Vec3::ZERO; 2];
                }
                let [move_free, turn_free] = world.freedoms(b);
                let solid = world.solid_of(b);
                // Principal axes near the axes of space: the diagonal bounds nothing off it for bricks.
                let inverse = solid.inverse;
                let diagonal = Vec3::new(
                    inverse.col(0).abs().element_sum(),
                    inverse.col(1).abs().element_sum(),
                    inverse.col(2).abs().element_sum(),
                );
                [
                    move_free / solid.mass.sqrt(),
                    turn_free * Vec3::from_array(diagonal.to_array().map(f64::sqrt)),
                ]
            })
            .collect();
        let boundaries = &world.setup.boundaries;
        let faces = world
            .faces
            .iter()
            .filter_map(|f| {
                let boundary = &boundaries[f.boundary? as usize];
                let [kn, ks] = f.stiffness;
                let none = [0.0; 2];
                let (stiffness, impedance) = match &boundary.kind {
                    BoundaryKind::Held { normal, shear } => {
                        let kn = if *normal { kn } else { 0.0 };
                        ([kn, if *shear { ks } else { 0.0 }], none)
                    }
                    BoundaryKind::Moved { .. } | BoundaryKind::Viscous { half_cell: true } => {
                        ([kn, ks], none)
                    }
                    BoundaryKind::Viscous { half_cell: false } => (none, f.impedance),
                    BoundaryKind::Traction { .. } => return None,
                };
                Some(FaceSpring {
                    block: f.block,
                    frame: f.frame,
                    arm: f.arm,
                    area: f.area,
                    reach: f.reach,
                    stiffness,
                    impedance,
                })
            })
            .collect();
        Self { root, faces }
    }

    /// Whether there are dashpots at all.
    fn damped(&self, world: &World, ck: f64) -> bool {
        ck > 0.0
            || self.faces.iter().any(|f| f.impedance != [0.0; 2])
            || world.classes.iter().any(|c| c.beta > 0.0)
    }

    /// `y = M^(-1/2) A M^(-1/2) x` with A the weighted sum of springs and dashpots.
    fn times(&self, world: &World, weights: Weights, x: &[[Vec3; 2]], y: &mut [[Vec3; 2]]) {
        y.fill([Vec3::ZERO; 2]);
        let at = |b: usize| [0, 1].map(|k| self.root[b][k] * x[b][k]);
        let list = &world.patches;
        for (ends, class) in list.ends.iter().zip(&list.class) {
            let k: &PatchClass = &world.classes[*class as usize];
            let [i, j] = ends.map(|b| b as usize);
            let (a, b) = (at(i), at(j));
            let d = b[0] - a[0] + b[1].cross(k.arms[1]) - a[1].cross(k.arms[0]);
            let stiffness = k.stiffness.map(|s| weights.of(k.beta) * s);
            let (f, m) = pull(&k.frame, k.area, k.reach, stiffness, d, b[1] - a[1]);
            y[i][0] -= f;
            y[i][1] -= k.arms[0].cross(f) + m;
            y[j][0] += f;
            y[j][1] += k.arms[1].cross(f) + m;
        }
        for s in &self.faces {
            let b = s.block as usize;
            let a = at(b);
            let d = a[0] + a[1].cross(s.arm);
            // Springs of boundaries have no dashpots parallel to them.
            let stiffness =
                [0, 1].map(|k| weights.spring * s.stiffness[k] + weights.dashpot * s.impedance[k]);
            let (f, m) = pull(&s.frame, s.area, s.reach, stiffness, d, a[1]);
            y[b][0] += f;
            y[b][1] += s.arm.cross(f) + m;
        }
        for (v, root) in y.iter_mut().zip(&self.root) {
            for k in 0..2 {
                v[k] *= root[k];
            }
        }
    }
}

/// Force and moment about the centre of four springs for a displacement `d` of the centre and a rotation
/// `w`.
fn pull(
    frame: &[Vec3; 3],
    area: f64,
    reach: [f64; 2],
    stiffness: [f64; 2],
    d: Vec3,
    w: Vec3,
) -> (Vec3, Vec3) {
    let d = frame.map(|e| e.dot(d));
    let w = frame.map(|e| e.dot(w));
    let (mut force, mut moment) = ([0.0; 3], [0.0; 3]);
    for (sign_b, sign_c) in SIGNS[0].into_iter().zip(SIGNS[1]) {
        let (b, c) = (sign_b * reach[0], sign_c * reach[1]);
        let t = [
            stiffness[0] * (d[0] + w[1] * c - w[2] * b),
            stiffness[1] * (d[1] - w[0] * c),
            stiffness[1] * (d[2] + w[0] * b),
        ];
        for k in 0..3 {
            force[k] += t[k];
        }
        moment[0] += b * t[2] - c * t[1];
        moment[1] += c * t[0];
        moment[2] -= b * t[0];
    }
    let share = 0.25 * area;
    let global = |v: [f64; 3]| share * (v[0] * frame[0] + v[1] * frame[1] + v[2] * frame[2]);
    (global(force), global(moment))
}
