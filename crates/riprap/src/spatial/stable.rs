//! Stable time step: which block sets it, and why.
//!
//! Power iteration for the highest frequency of the present springs (patches, boundary springs) with their masses.
//! The leapfrog with the velocity of half a step before in the dashpots is stable up to
//! `dt = 2/w (sqrt(1 + z²) - z)`, `z = beta w / 2`, with the largest ratio `beta` of dashpot and spring.

use riprap_geom::Vec3;

use super::setup::BoundaryKind;
use super::step::Scratch;
use super::world::{PatchClass, World};
use crate::laws::face_joint::SIGNS;

/// Sweeps of the power iteration.
const SWEEPS: usize = 60;
/// The estimate comes from below; what is added to it.
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
pub fn stable_step(world: &World, _scratch: &Scratch, stiffness_damping: f64) -> Stable {
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
    let mut omega2 = 0.0_f64;
    for _ in 0..SWEEPS {
        springs.times(world, &x, &mut y);
        let norm = |x: &[[Vec3; 2]]| x.iter().flatten().map(|v| v.length_squared()).sum::<f64>();
        let dot: f64 = x
            .iter()
            .zip(&y)
            .map(|(a, b)| a[0].dot(b[0]) + a[1].dot(b[1]))
            .sum();
        let length = norm(&x);
        if length == 0.0 {
            break;
        }
        omega2 = dot / length;
        let scale = norm(&y).sqrt();
        if scale == 0.0 {
            break;
        }
        for (a, b) in x.iter_mut().zip(&y) {
            *a = b.map(|v| v / scale);
        }
    }
    finish(world, &springs, &x, omega2 * MARGIN, stiffness_damping)
}

fn finish(
    world: &World,
    springs: &Springs,
    x: &[[Vec3; 2]],
    omega2: f64,
    stiffness_damping: f64,
) -> Stable {
    if omega2 <= 0.0 {
        return Stable {
            dt: f64::INFINITY,
            block: None,
            why: "nothing holds the blocks",
        };
    }
    let size = |v: &[Vec3; 2]| v[0].length_squared() + v[1].length_squared();
    let mut block = 0;
    for (b, v) in x.iter().enumerate() {
        if size(v) > size(&x[block]) {
            block = b;
        }
    }
    let used = world
        .patches
        .class
        .iter()
        .map(|c| world.classes[*c as usize].beta);
    let beta = used.fold(0.0, f64::max) + stiffness_damping;
    let omega = omega2.sqrt();
    let z = 0.5 * beta * omega;
    let (turning, moving) = (x[block][1].length_squared(), x[block][0].length_squared());
    let why = if springs.faces.iter().any(|f| f.block as usize == block) {
        "springs of patches and of a boundary"
    } else if turning > moving {
        "rotation against the springs of its patches"
    } else {
        "translation against the springs of its patches"
    };
    Stable {
        dt: 2.0 / omega * ((1.0 + z * z).sqrt() - z),
        block: Some(block as u32),
        why,
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
}

impl Springs {
    fn new(world: &World) -> Self {
        let root = (0..world.alive.len())
            .map(|b| {
                if !world.alive[b] || world.motion[b].is_some() {
                    return [Vec3::ZERO; 2];
                }
                let solid = world.solid_of(b);
                // Principal axes near the axes of space: the diagonal bounds nothing off it for bricks.
                let inverse = solid.inverse;
                let diagonal = Vec3::new(
                    inverse.col(0).abs().element_sum(),
                    inverse.col(1).abs().element_sum(),
                    inverse.col(2).abs().element_sum(),
                );
                [
                    Vec3::splat(1.0 / solid.mass.sqrt()),
                    Vec3::new(diagonal.x.sqrt(), diagonal.y.sqrt(), diagonal.z.sqrt()),
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
                let stiffness = match &boundary.kind {
                    BoundaryKind::Held { normal, shear } => [
                        if *normal { kn } else { 0.0 },
                        if *shear { ks } else { 0.0 },
                    ],
                    BoundaryKind::Moved { .. } | BoundaryKind::Viscous { half_cell: true } => {
                        [kn, ks]
                    }
                    BoundaryKind::Viscous { half_cell: false } | BoundaryKind::Traction { .. } => {
                        return None;
                    }
                };
                Some(FaceSpring {
                    block: f.block,
                    frame: f.frame,
                    arm: f.arm,
                    area: f.area,
                    reach: f.reach,
                    stiffness,
                })
            })
            .collect();
        Self { root, faces }
    }

    /// `y = M^(-1/2) K M^(-1/2) x`.
    fn times(&self, world: &World, x: &[[Vec3; 2]], y: &mut [[Vec3; 2]]) {
        y.fill([Vec3::ZERO; 2]);
        let at = |b: usize| [0, 1].map(|k| self.root[b][k] * x[b][k]);
        let list = &world.patches;
        for (ends, class) in list.ends.iter().zip(&list.class) {
            let k: &PatchClass = &world.classes[*class as usize];
            let [i, j] = ends.map(|b| b as usize);
            let (a, b) = (at(i), at(j));
            let d = b[0] - a[0] + b[1].cross(k.arms[1]) - a[1].cross(k.arms[0]);
            let (f, m) = pull(&k.frame, k.area, k.reach, k.stiffness, d, b[1] - a[1]);
            y[i][0] -= f;
            y[i][1] -= k.arms[0].cross(f) + m;
            y[j][0] += f;
            y[j][1] += k.arms[1].cross(f) + m;
        }
        for s in &self.faces {
            let b = s.block as usize;
            let a = at(b);
            let d = a[0] + a[1].cross(s.arm);
            let (f, m) = pull(&s.frame, s.area, s.reach, s.stiffness, d, a[1]);
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
