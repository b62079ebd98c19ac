//! Multiplication by the matrix of all springs, on all threads and eight patches at a time.
//!
//! Blocks are cut into pieces of a fixed number. A piece adds up, in the order of the list of patches, what all patches
//! with an end in it do to its blocks; a patch between two pieces is computed in both. So every block has its sum in
//! the order of the list, whatever the threads and the width.

use riprap_geom::Vec3;

use crate::bolts::stiffness::BoltSprings;
use crate::exec::{Divide, Exec};
use crate::lanes::{LANES, Lanes, Vectors, Width, cross, dot, minus, plus, same};
use crate::laws::face_joint::SIGNS;
use crate::setup::BoundaryKind;
use crate::world::{PatchClass, World};

/// Blocks of a piece.
const PIECE: usize = 4096;

/// Translation and rotation of a block, times the roots of its mass and its moments of inertia.
type Shift = [Vec3; 2];

/// What of springs and dashpots goes into a matrix: `spring K + dashpot C`.
#[derive(Clone, Copy)]
pub(super) struct Weights {
    spring: f64,
    dashpot: f64,
    /// Stiffness-proportional damping of the phase, s.
    ck: f64,
}

impl Weights {
    pub(super) const SPRINGS: Self = Self {
        spring: 1.0,
        dashpot: 0.0,
        ck: 0.0,
    };

    pub(super) fn dashpots(ck: f64) -> Self {
        Self {
            spring: 0.0,
            dashpot: 1.0,
            ck,
        }
    }

    pub(super) fn step(dt: f64, ck: f64) -> Self {
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
pub(super) struct Springs {
    /// 1/sqrt(m) and 1/sqrt(I) per block; 0 for what cannot move.
    root: Vec<[Vec3; 2]>,
    pub(super) faces: Vec<FaceSpring>,
    pieces: Vec<Piece>,
}

pub(super) struct FaceSpring {
    pub(super) block: u32,
    frame: [Vec3; 3],
    arm: Vec3,
    area: f64,
    half_spacing: [f64; 2],
    stiffness: [f64; 2],
    /// Dashpots on the velocity of the face, Pa s/m.
    impedance: [f64; 2],
}

impl Springs {
    pub(super) fn new(world: &World) -> Self {
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
        let faces: Vec<FaceSpring> = world
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
                    half_spacing: f.half_spacing,
                    stiffness,
                    impedance,
                })
            })
            .collect();
        let pieces = pieces(world, &faces);
        Self {
            root,
            faces,
            pieces,
        }
    }

    /// Whether there are dashpots at all.
    pub(super) fn damped(&self, world: &World, ck: f64) -> bool {
        ck > 0.0
            || self.faces.iter().any(|f| f.impedance != [0.0; 2])
            || world.classes.iter().any(|c| c.beta > 0.0)
    }
}

/// What acts on the blocks of a piece.
#[derive(Default)]
struct Piece {
    /// Patches, ascending.
    patches: Vec<u32>,
    /// Entries of [`Springs::faces`], ascending.
    faces: Vec<u32>,
}

fn pieces(world: &World, faces: &[FaceSpring]) -> Vec<Piece> {
    let mut pieces = Vec::new();
    pieces.resize_with(world.alive.len().div_ceil(PIECE), Piece::default);
    for (p, ends) in world.patches.ends.iter().enumerate() {
        let [i, j] = ends.map(|b| b as usize / PIECE);
        pieces[i].patches.push(p as u32);
        if j != i {
            pieces[j].patches.push(p as u32);
        }
    }
    for (k, face) in faces.iter().enumerate() {
        pieces[face.block as usize / PIECE].faces.push(k as u32);
    }
    pieces
}

/// A motion of all blocks that comes nearer to the fastest one with every iteration.
pub(super) struct Motion<'a> {
    world: &'a World,
    springs: &'a Springs,
    exec: &'a Exec,
    width: Width,
    bolts: BoltSprings<'a>,
    /// What bolts do to each block; empty without any.
    bolted: Vec<Shift>,
    shape: Vec<Shift>,
    /// `shape` over the roots of the masses: true displacements and rotations.
    at: Vec<Shift>,
    /// Scalar product of each block.
    product: Vec<f64>,
}

impl<'a> Motion<'a> {
    /// A start that has a part of every mode: no symmetry, no zeros.
    pub(super) fn new(
        world: &'a World,
        springs: &'a Springs,
        exec: &'a Exec,
        width: Width,
    ) -> Self {
        let mut seed = 0x9e37_79b9_7f4a_7c15_u64;
        let mut draw = || {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            (seed >> 11) as f64 / (1u64 << 53) as f64 - 0.5
        };
        let n = world.alive.len();
        let shape: Vec<Shift> = (0..n)
            .map(|_| [0, 1].map(|_| Vec3::new(draw(), draw(), draw())))
            .collect();
        let roots = shape.iter().zip(&springs.root);
        let at = roots
            .map(|(x, root)| [0, 1].map(|k| root[k] * x[k]))
            .collect();
        Self {
            world,
            springs,
            exec,
            width,
            bolts: BoltSprings::new(world),
            bolted: Vec::new(),
            shape,
            at,
            product: vec![0.0; n],
        }
    }

    /// The motion, times the roots of the masses.
    pub(super) fn shape(&self) -> &[Shift] {
        &self.shape
    }

    /// `x <- A x / |A x|` with `A = M^(-1/2) (weighted sum of springs and dashpots) M^(-1/2)`; false when `A x` is nil.
    pub(super) fn iterate(&mut self, weights: Weights) -> bool {
        let scale = self.times(weights, true).sqrt();
        if scale == 0.0 {
            return false;
        }
        let root = &self.springs.root;
        let (shape, at) = (&mut self.shape, &mut self.at);
        let mut none = vec![(); shape.len().div_ceil(crate::exec::CHUNK)];
        self.exec
            .chunks2(shape, at, &mut none, |first, shape, at, ()| {
                for ((x, at), root) in shape.iter_mut().zip(at).zip(&root[first..]) {
                    *x = x.map(|v| v / scale);
                    *at = [0, 1].map(|k| root[k] * x[k]);
                }
            });
        true
    }

    /// `x . A x`.
    pub(super) fn quotient(&mut self, weights: Weights) -> f64 {
        self.times(weights, false)
    }

    /// Finds `y = A x`. With `replace` the motion becomes `y` (not yet of length one) and the result is `y . y`, without it
    /// `x . y`.
    fn times(&mut self, weights: Weights, replace: bool) -> f64 {
        if !self.world.bolts.is_empty() {
            self.bolted.clear();
            self.bolted.resize(self.at.len(), [Vec3::ZERO; 2]);
            self.bolts.pull(&self.at, &mut self.bolted);
        }
        let step = Step {
            world: self.world,
            springs: self.springs,
            weights,
            at: &self.at,
            bolted: &self.bolted,
            replace,
            width: self.width,
        };
        let work = Work {
            shape: &mut self.shape,
            product: &mut self.product,
        };
        let count = self.springs.pieces.len();
        self.exec
            .divided(work, count, |piece, work| step.piece(piece, work));
        // In the order of the blocks, whatever the pieces.
        self.product.iter().sum()
    }
}

/// The blocks of some pieces.
struct Work<'a> {
    shape: &'a mut [Shift],
    product: &'a mut [f64],
}

impl Divide for Work<'_> {
    fn divide(self, middle: usize) -> (Self, Self) {
        let (s0, s1) = self.shape.split_at_mut(middle * PIECE);
        let (p0, p1) = self.product.split_at_mut(middle * PIECE);
        let half = |shape, product| Work { shape, product };
        (half(s0, p0), half(s1, p1))
    }
}

/// One multiplication.
struct Step<'a> {
    world: &'a World,
    springs: &'a Springs,
    weights: Weights,
    at: &'a [Shift],
    bolted: &'a [Shift],
    replace: bool,
    width: Width,
}

impl Step<'_> {
    fn piece(&self, number: usize, work: Work<'_>) {
        let base = number * PIECE;
        let piece = &self.springs.pieces[number];
        let mut sum = vec![[Vec3::ZERO; 2]; work.shape.len()];
        self.width.run(
            #[inline(always)]
            || self.patches(&piece.patches, base, &mut sum),
        );
        for &k in &piece.faces {
            let s = &self.springs.faces[k as usize];
            let a = self.at[s.block as usize];
            let d = a[0] + a[1].cross(s.arm);
            let weights = self.weights;
            // Springs of boundaries have no dashpots parallel to them.
            let stiffness =
                [0, 1].map(|k| weights.spring * s.stiffness[k] + weights.dashpot * s.impedance[k]);
            let (f, m) = pull(&s.frame, s.area, s.half_spacing, stiffness, d, a[1]);
            let y = &mut sum[s.block as usize - base];
            y[0] += f;
            y[1] += s.arm.cross(f) + m;
        }
        if let Some(bolted) = self.bolted.get(base..) {
            for (y, f) in sum.iter_mut().zip(bolted) {
                for part in 0..2 {
                    y[part] += self.weights.spring * f[part];
                }
            }
        }
        let roots = &self.springs.root[base..];
        let blocks = work.shape.iter_mut().zip(work.product);
        for (((x, product), y), root) in blocks.zip(&sum).zip(roots) {
            let y = [0, 1].map(|k| y[k] * root[k]);
            let other = if self.replace { y } else { *x };
            *product = other[0].dot(y[0]) + other[1].dot(y[1]);
            if self.replace {
                *x = y;
            }
        }
    }

    /// Adds what patches do to the blocks from `base` on.
    #[inline(always)]
    fn patches(&self, list: &[u32], base: usize, sum: &mut [Shift]) {
        let patches = &self.world.patches;
        let class_of = |p: u32| patches.class[p as usize];
        let mut rest = list;
        while let Some(&first) = rest.first() {
            let number = class_of(first);
            let class = &self.world.classes[number as usize];
            let stiffness = class.stiffness.map(|s| self.weights.of(class.beta) * s);
            let packet = rest.first_chunk::<LANES>();
            if let Some(packet) = packet.filter(|run| run.iter().all(|p| class_of(*p) == number)) {
                let ends = packet.map(|p| patches.ends[p as usize]);
                let pushes = eight(class, stiffness, self.at, &ends);
                for (lane, ends) in ends.into_iter().enumerate() {
                    let of = |v: &Vectors| Vec3::new(v[0].0[lane], v[1].0[lane], v[2].0[lane]);
                    add(
                        ends,
                        base,
                        sum,
                        of(&pushes[0]),
                        [of(&pushes[1]), of(&pushes[2])],
                    );
                }
                rest = &rest[LANES..];
            } else {
                let ends = patches.ends[first as usize];
                let (f, moments) = one(class, stiffness, self.at, ends);
                add(ends, base, sum, f, moments);
                rest = &rest[1..];
            }
        }
    }
}

/// Adds a force on block j, its opposite on i, and the moments of both, where they are among the blocks from `base` on.
#[inline(always)]
fn add(ends: [u32; 2], base: usize, sum: &mut [Shift], f: Vec3, moments: [Vec3; 2]) {
    let [i, j] = ends.map(|b| (b as usize).wrapping_sub(base));
    if let Some(y) = sum.get_mut(i) {
        y[0] -= f;
        y[1] -= moments[0];
    }
    if let Some(y) = sum.get_mut(j) {
        y[0] += f;
        y[1] += moments[1];
    }
}

/// Force of a patch on block j, and the moments about the centroids: opposite of that on i, and that on j.
#[inline(always)]
fn one(class: &PatchClass, stiffness: [f64; 2], at: &[Shift], ends: [u32; 2]) -> (Vec3, [Vec3; 2]) {
    let [a, b] = ends.map(|b| &at[b as usize]);
    let d = b[0] - a[0] + b[1].cross(class.arms[1]) - a[1].cross(class.arms[0]);
    let turn = b[1] - a[1];
    let (f, m) = pull(
        &class.frame,
        class.area,
        class.half_spacing,
        stiffness,
        d,
        turn,
    );
    let moments = [class.arms[0].cross(f) + m, class.arms[1].cross(f) + m];
    (f, moments)
}

/// As [`one`] for eight patches of a class, with the same operations in the same order: force, moments.
#[inline(always)]
fn eight(
    class: &PatchClass,
    stiffness: [f64; 2],
    at: &[Shift],
    ends: &[[u32; 2]; LANES],
) -> [Vectors; 3] {
    let mut motion = [[Vectors::default(); 2]; 2];
    for (lane, ends) in ends.iter().enumerate() {
        for (side, b) in ends.iter().enumerate() {
            let shift = &at[*b as usize];
            for part in 0..2 {
                let v = shift[part];
                motion[side][part][0].0[lane] = v.x;
                motion[side][part][1].0[lane] = v.y;
                motion[side][part][2].0[lane] = v.z;
            }
        }
    }
    let [a, b] = &motion;
    let arms = class.arms.map(|arm| same(&arm.to_array()));
    let frame = class.frame.map(|e| same(&e.to_array()));
    let moved = plus(&minus(&b[0], &a[0]), &cross(&b[1], &arms[1]));
    let d = minus(&moved, &cross(&a[1], &arms[0]));
    let w = minus(&b[1], &a[1]);
    let d = [0, 1, 2].map(|k| dot(&frame[k], &d));
    let w = [0, 1, 2].map(|k| dot(&frame[k], &w));
    let [kn, ks] = stiffness.map(Lanes::all);
    let [rb, rc] = class.half_spacing.map(Lanes::all);
    // The four points in the order of `SIGNS`: (-, -), (+, -), (+, +), (-, +).
    let (p, q) = (w[1] * rc, w[2] * rb);
    let (low, high) = (d[0] - p, d[0] + p);
    let n = [
        kn * (low + q),
        kn * (low - q),
        kn * (high - q),
        kn * (high + q),
    ];
    let (r, s) = (w[0] * rc, w[0] * rb);
    let [below, above] = [ks * (d[1] + r), ks * (d[1] - r)];
    let [left, right] = [ks * (d[2] - s), ks * (d[2] + s)];
    let force = [
        n[0] + n[1] + n[2] + n[3],
        below + below + above + above,
        left + right + right + left,
    ];
    let (cb, ca) = (rc * below, rc * above);
    let (bl, br) = (rb * left, rb * right);
    let moment = [
        (cb - bl) + (br + cb) + (br - ca) + (-bl - ca),
        -(rc * n[0]) - rc * n[1] + rc * n[2] + rc * n[3],
        rb * n[0] - rb * n[1] - rb * n[2] + rb * n[3],
    ];
    let share = Lanes::all(0.25 * class.area);
    let global = |v: &Vectors| {
        [0, 1, 2].map(|k| share * (v[0] * frame[0][k] + v[1] * frame[1][k] + v[2] * frame[2][k]))
    };
    let (f, m) = (global(&force), global(&moment));
    [
        f,
        plus(&cross(&arms[0], &f), &m),
        plus(&cross(&arms[1], &f), &m),
    ]
}

/// Force and moment about the centre of four springs for a displacement `d` of the centre and a rotation
/// `w`.
fn pull(
    frame: &[Vec3; 3],
    area: f64,
    half_spacing: [f64; 2],
    stiffness: [f64; 2],
    d: Vec3,
    w: Vec3,
) -> (Vec3, Vec3) {
    let d = frame.map(|e| e.dot(d));
    let w = frame.map(|e| e.dot(w));
    let (mut force, mut moment) = ([0.0; 3], [0.0; 3]);
    for (sign_b, sign_c) in SIGNS[0].into_iter().zip(SIGNS[1]) {
        let (b, c) = (sign_b * half_spacing[0], sign_c * half_spacing[1]);
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

#[cfg(test)]
mod tests {
    use super::*;
    use riprap_geom::Mat3;

    /// A packet of eight patches and eight single ones: the same bits, for frames along the axes and for any other.
    #[test]
    fn packets_have_the_bits_of_single_patches() {
        let mut seed = 7_u64;
        let mut draw = || {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            (seed >> 11) as f64 / (1u64 << 53) as f64 - 0.5
        };
        for turned in [false, true] {
            let mut vector = || Vec3::new(draw(), draw(), draw());
            let turn = if turned {
                Mat3::from_axis_angle(vector().normalize(), 0.7)
            } else {
                Mat3::IDENTITY
            };
            let class = PatchClass {
                frame: [turn.x_axis, turn.y_axis, turn.z_axis],
                area: 0.7,
                half_spacing: [0.21, 0.34],
                arms: [vector(), vector()],
                stiffness: [3.1e9, 1.7e9],
                beta: 1e-5,
                materials: [0; 2],
                row: 0,
                axis: if turned { 3 } else { 0 },
                distance: 1.0,
                slope: [[0.0; 3]; 2],
            };
            let at: Vec<Shift> = (0..9).map(|_| [vector(), vector()]).collect();
            let ends: [[u32; 2]; LANES] = std::array::from_fn(|k| [k as u32, k as u32 + 1]);
            for width in [Width::Plain, Width::detect()] {
                let all = width.run(
                    #[inline(always)]
                    || eight(&class, class.stiffness, &at, &ends),
                );
                for (lane, ends) in ends.iter().enumerate() {
                    let of = |v: &Vectors| [0, 1, 2].map(|k| v[k].0[lane]);
                    let (f, m) = one(&class, class.stiffness, &at, *ends);
                    assert_eq!(of(&all[0]), f.to_array());
                    assert_eq!([of(&all[1]), of(&all[2])], m.map(|m| m.to_array()));
                }
            }
        }
    }
}
