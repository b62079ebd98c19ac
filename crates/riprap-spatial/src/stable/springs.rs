//! Multiplication by the matrix of all springs, on all threads and eight patches at a time.
//!
//! Blocks are cut into pieces of a fixed number. A piece adds up, in the order of the list of patches, what all patches
//! with an end in it do to its blocks; a patch between two pieces is computed in both. So every block has its sum in
//! the order of the list, whatever the threads and the width.

use riprap_geom::Vec3;

use crate::lanes::{LANES, Lanes, Vectors, Width, cross, dot, minus, plus, same};
use crate::setup::BoundaryKind;
use crate::state::patches::PatchClass;
use crate::state::tiles::GROUP;
use crate::state::world::World;

/// Blocks of a piece.
pub(super) const PIECE: usize = 64 * GROUP;

/// Translations and rotations of a [`GROUP`] of blocks by component, so that what is next to each other can be read eight at a time;
/// numbers beyond the last block are 0.
pub(super) type Part = [[f64; GROUP]; 6];

/// Parts of a model of so many blocks, at rest.
pub(super) fn parts(blocks: usize) -> Vec<Part> {
    vec![[[0.0; GROUP]; 6]; blocks.div_ceil(GROUP)]
}

/// Translation and rotation of a block.
pub(super) fn of(parts: &[Part], block: u32) -> [Vec3; 2] {
    let (part, k) = (&parts[block as usize / GROUP], block as usize % GROUP);
    [0, 3].map(|c| Vec3::new(part[c][k], part[c + 1][k], part[c + 2][k]))
}

/// Adds to the translation and rotation of a block.
pub(super) fn add(parts: &mut [Part], block: u32, v: [Vec3; 2]) {
    let (part, k) = (&mut parts[block as usize / GROUP], block as usize % GROUP);
    for (c, v) in v.iter().flat_map(Vec3::to_array).enumerate() {
        part[c][k] += v;
    }
}

/// What of springs and dashpots goes into a matrix: `spring K + dashpot C`.
#[derive(Clone, Copy)]
pub(super) struct Weights {
    spring: f64,
    dashpot: f64,
    /// Stiffness-proportional damping of the phase, s.
    ck: f64,
}

impl Weights {
    pub(super) const SPRINGS: Self = Self { spring: 1.0, dashpot: 0.0, ck: 0.0 };

    pub(super) fn dashpots(ck: f64) -> Self {
        Self { spring: 0.0, dashpot: 1.0, ck }
    }

    pub(super) fn step(dt: f64, ck: f64) -> Self {
        Self {
            // With dashpots at the velocity of half a step before, a mode
            // is stable while `dt² k + 2 dt c` is below 4.
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
    pub(super) root: Vec<Part>,
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
        let mut root = parts(world.alive.len());
        for b in (0..world.alive.len()).filter(|&b| world.alive[b] && !world.deforms(b)) {
            let [move_free, turn_free] = world.freedoms(b);
            let solid = world.solid_of(b);
            // Principal axes near the axes of space: the diagonal bounds nothing off it for bricks.
            let inverse = solid.inverse;
            let diagonal = [0, 1, 2].map(|k| inverse.col(k).abs().element_sum().sqrt());
            let roots = [move_free / solid.mass.sqrt(), turn_free * Vec3::from_array(diagonal)];
            add(&mut root, b as u32, roots);
        }
        let boundaries = &world.setup.boundaries;
        let faces: Vec<FaceSpring> = world
            .faces
            .iter()
            .filter_map(|f| {
                let boundary = &boundaries[f.boundary? as usize];
                let behind = f.behind();
                let [kn, ks] = behind.stiffness;
                let none = [0.0; 2];
                let (stiffness, impedance) = match &boundary.kind {
                    BoundaryKind::Held { normal, shear } => {
                        let kn = if *normal { kn } else { 0.0 };
                        ([kn, if *shear { ks } else { 0.0 }], none)
                    }
                    BoundaryKind::Moved { .. } | BoundaryKind::Viscous { half_cell: true } => {
                        ([kn, ks], none)
                    }
                    BoundaryKind::Viscous { half_cell: false } => (none, behind.impedance),
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
        Self { root, faces, pieces }
    }

    /// Smallest and largest ratio of dashpots to springs of patches, s; from 0 to infinity where boundaries have dashpots alone.
    pub(super) fn ratios(&self, world: &World, ck: f64) -> [f64; 2] {
        if self.faces.iter().any(|f| f.impedance != [0.0; 2]) {
            return [0.0, f64::INFINITY];
        }
        let ratios = world.classes.iter().map(|class| class.beta + ck);
        let most = ratios.clone().fold(ck, f64::max);
        [ratios.fold(most, f64::min), most]
    }

    /// Number of the pieces.
    pub(super) fn pieces(&self) -> usize {
        self.pieces.len()
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

/// One multiplication.
pub(super) struct Step<'a> {
    pub(super) world: &'a World,
    pub(super) springs: &'a Springs,
    pub(super) weights: Weights,
    /// True displacements and rotations.
    pub(super) at: &'a [Part],
    /// What bolts do to each block; empty without any.
    pub(super) bolted: &'a [Part],
    pub(super) width: Width,
}

impl Step<'_> {
    /// Writes what springs and dashpots do to the blocks of a piece, times the inverse roots of the masses. Sums of the product of that with
    /// what is multiplied, group by group.
    pub(super) fn piece(&self, number: usize, sum: &mut [Part], products: &mut [f64]) {
        let base = number * PIECE / GROUP;
        let piece = &self.springs.pieces[number];
        sum.as_flattened_mut().as_flattened_mut().fill(0.0);
        self.width.run(
            #[inline(always)]
            || self.patches(&piece.patches, base, sum),
        );
        for &k in &piece.faces {
            let s = &self.springs.faces[k as usize];
            let a = of(self.at, s.block);
            let d = a[0] + a[1].cross(s.arm);
            let weights = self.weights;
            // Springs of boundaries have no dashpots parallel to them.
            let stiffness =
                [0, 1].map(|k| weights.spring * s.stiffness[k] + weights.dashpot * s.impedance[k]);
            let springs = springs(s.area, s.half_spacing, stiffness);
            let (f, m) = pull(&s.frame, &springs, d, a[1]);
            add(sum, s.block - (base * GROUP) as u32, [f, s.arm.cross(f) + m]);
        }
        if let Some(bolted) = self.bolted.get(base..) {
            for (y, f) in each(sum).zip(each_of(bolted)) {
                *y += self.weights.spring * f;
            }
        }
        let (at, root) = (&self.at[base..], &self.springs.root[base..]);
        for (((y, at), root), product) in sum.iter_mut().zip(at).zip(root).zip(products) {
            self.width.run(
                #[inline(always)]
                || *product = scale(y, at, root),
            );
        }
    }

    /// Adds what patches do to the groups from `base` on.
    #[inline(always)]
    fn patches(&self, list: &[u32], base: usize, sum: &mut [Part]) {
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
                let i = Side::new(&ends, 0);
                let j = Side::new(&ends, 1);
                let motion = [i.read(self.at), j.read(self.at)];
                let [f, on_i, on_j] = eight(class, stiffness, &motion);
                i.add::<true>(sum, base, &f, &on_i);
                j.add::<false>(sum, base, &f, &on_j);
                rest = &rest[LANES..];
            } else {
                let ends = patches.ends[first as usize];
                let (f, [on_i, on_j]) = one(class, stiffness, ends.map(|b| of(self.at, b)));
                for (b, push) in ends.into_iter().zip([[-f, -on_i], [f, on_j]]) {
                    // Groups before `base` wrap to numbers beyond the end: another piece has them.
                    let group = (b as usize / GROUP).wrapping_sub(base);
                    if group < sum.len() {
                        add(&mut sum[group..=group], b % GROUP as u32, push);
                    }
                }
                rest = &rest[1..];
            }
        }
    }
}

/// All numbers of some parts.
fn each(parts: &mut [Part]) -> impl Iterator<Item = &mut f64> {
    parts.as_flattened_mut().as_flattened_mut().iter_mut()
}

fn each_of(parts: &[Part]) -> impl Iterator<Item = &f64> {
    parts.as_flattened().as_flattened().iter()
}

/// Sum of the products of two parts, and the first of them times the third.
#[inline(always)]
fn scale(y: &mut Part, at: &Part, root: &Part) -> f64 {
    let mut sum = Lanes::default();
    for ((y, at), root) in y.iter_mut().zip(at).zip(root) {
        for k in (0..GROUP).step_by(LANES) {
            let now = Lanes::at(y, k);
            sum = sum + now * Lanes::at(at, k);
            y[k..k + LANES].copy_from_slice(&(now * Lanes::at(root, k)).0);
        }
    }
    sum.sum()
}

/// Blocks on one side of eight patches.
struct Side {
    blocks: [u32; LANES],
    /// Whether they follow each other within a group.
    runs: bool,
}

impl Side {
    #[inline(always)]
    fn new(ends: &[[u32; 2]; LANES], side: usize) -> Self {
        let mut blocks = [0; LANES];
        for (block, ends) in blocks.iter_mut().zip(ends) {
            *block = ends[side];
        }
        let mut runs = blocks[0] as usize % GROUP <= GROUP - LANES;
        for (k, b) in blocks.iter().enumerate() {
            runs &= *b == blocks[0] + k as u32;
        }
        Self { blocks, runs }
    }

    /// Translations and rotations. Written out here and below, so that components stay in registers.
    #[inline(always)]
    fn read(&self, at: &[Part]) -> [Vectors; 2] {
        if self.runs {
            let first = self.blocks[0] as usize;
            let (part, k) = (&at[first / GROUP], first % GROUP);
            return [
                [Lanes::at(&part[0], k), Lanes::at(&part[1], k), Lanes::at(&part[2], k)],
                [Lanes::at(&part[3], k), Lanes::at(&part[4], k), Lanes::at(&part[5], k)],
            ];
        }
        let mut all = [Vectors::default(); 2];
        for (lane, block) in self.blocks.iter().enumerate() {
            let (part, k) = (&at[*block as usize / GROUP], *block as usize % GROUP);
            for c in 0..3 {
                all[0][c].0[lane] = part[c][k];
                all[1][c].0[lane] = part[3 + c][k];
            }
        }
        all
    }

    /// Adds forces and moments, or what is opposite to them, where blocks are among the groups from `base` on.
    #[inline(always)]
    fn add<const OPPOSITE: bool>(
        &self,
        sum: &mut [Part],
        base: usize,
        force: &Vectors,
        moment: &Vectors,
    ) {
        if self.runs {
            let first = self.blocks[0] as usize;
            let Some(part) = sum.get_mut((first / GROUP).wrapping_sub(base)) else {
                return;
            };
            let k = first % GROUP;
            for c in 0..3 {
                for (to, push) in [(c, force[c]), (3 + c, moment[c])] {
                    let before = Lanes::at(&part[to], k);
                    let after = if OPPOSITE { before - push } else { before + push };
                    part[to][k..k + LANES].copy_from_slice(&after.0);
                }
            }
            return;
        }
        for (lane, block) in self.blocks.iter().enumerate() {
            let (group, k) = (*block as usize / GROUP, *block as usize % GROUP);
            if let Some(part) = sum.get_mut(group.wrapping_sub(base)) {
                for c in 0..3 {
                    for (to, push) in [(c, force[c].0[lane]), (3 + c, moment[c].0[lane])] {
                        part[to][k] += if OPPOSITE { -push } else { push };
                    }
                }
            }
        }
    }
}

/// Springs of a face against displacement of its centre along n, b and c (N/m) and rotation about them (N m), for its
/// `stiffness` along and across the normal (Pa/m): that of four springs at `half_spacing` to either side of the centre.
#[inline(always)]
fn springs(area: f64, half_spacing: [f64; 2], stiffness: [f64; 2]) -> [Vec3; 2] {
    let [kn, ks] = stiffness.map(|k| area * k);
    let [bb, cc] = half_spacing.map(|s| s * s);
    let turn = Vec3::new(ks * (bb + cc), kn * cc, kn * bb);
    [Vec3::new(kn, ks, ks), turn]
}

/// Force of a patch on block j, and the moments about the centroids: opposite of that on i, and that on j.
#[inline(always)]
fn one(class: &PatchClass, stiffness: [f64; 2], [a, b]: [[Vec3; 2]; 2]) -> (Vec3, [Vec3; 2]) {
    let d = b[0] - a[0] + b[1].cross(class.arms[1]) - a[1].cross(class.arms[0]);
    let springs = springs(class.area, class.half_spacing, stiffness);
    let (f, m) = pull(&class.frame, &springs, d, b[1] - a[1]);
    (f, class.arms.map(|arm| arm.cross(f) + m))
}

/// As [`one`] for eight patches of a class, with the same operations in the same order: force, moments.
#[inline(always)]
fn eight(class: &PatchClass, stiffness: [f64; 2], [a, b]: &[[Vectors; 2]; 2]) -> [Vectors; 3] {
    let arms = [same(&class.arms[0].to_array()), same(&class.arms[1].to_array())];
    let frame = [
        same(&class.frame[0].to_array()),
        same(&class.frame[1].to_array()),
        same(&class.frame[2].to_array()),
    ];
    let d = minus(&plus(&minus(&b[0], &a[0]), &cross(&b[1], &arms[1])), &cross(&a[1], &arms[0]));
    let w = minus(&b[1], &a[1]);
    let [along, about] = springs(class.area, class.half_spacing, stiffness);
    let f = pulled(&frame, along, &d);
    let m = pulled(&frame, about, &w);
    let on_i = plus(&cross(&arms[0], &f), &m);
    let on_j = plus(&cross(&arms[1], &f), &m);
    [f, on_i, on_j]
}

#[inline(always)]
fn pulled(frame: &[Vectors; 3], springs: Vec3, v: &Vectors) -> Vectors {
    let x = Lanes::all(springs.x) * dot(&frame[0], v);
    let y = Lanes::all(springs.y) * dot(&frame[1], v);
    let z = Lanes::all(springs.z) * dot(&frame[2], v);
    [
        x * frame[0][0] + y * frame[1][0] + z * frame[2][0],
        x * frame[0][1] + y * frame[1][1] + z * frame[2][1],
        x * frame[0][2] + y * frame[1][2] + z * frame[2][2],
    ]
}

/// Force and moment about the centre of a face with [`springs`] for a displacement `d` of the centre and a rotation `w`.
#[inline(always)]
fn pull(frame: &[Vec3; 3], springs: &[Vec3; 2], d: Vec3, w: Vec3) -> (Vec3, Vec3) {
    let pulled = |springs: Vec3, v: Vec3| {
        let local = springs * Vec3::from_array(frame.map(|e| e.dot(v)));
        local.x * frame[0] + local.y * frame[1] + local.z * frame[2]
    };
    (pulled(springs[0], d), pulled(springs[1], w))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::laws::face_joint::SIGNS;
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
            for runs in [false, true] {
                let mut at = parts(32);
                for block in 0..32 {
                    add(&mut at, block, [vector(), vector()]);
                }
                // Blocks that follow each other, and others.
                let other = |k: u32| if runs { k + 9 } else { 3 * k + 1 };
                let ends: [[u32; 2]; LANES] = std::array::from_fn(|k| [k as u32, other(k as u32)]);
                for width in [Width::PLAIN, Width::detect()] {
                    let all = width.run(
                        #[inline(always)]
                        || {
                            let motion = [0, 1].map(|side| Side::new(&ends, side).read(&at));
                            eight(&class, class.stiffness, &motion)
                        },
                    );
                    for (lane, ends) in ends.iter().enumerate() {
                        let of_lane = |v: &Vectors| [0, 1, 2].map(|k| v[k].0[lane]);
                        let (f, m) = one(&class, class.stiffness, ends.map(|b| of(&at, b)));
                        assert_eq!(of_lane(&all[0]), f.to_array());
                        assert_eq!([of_lane(&all[1]), of_lane(&all[2])], m.map(|m| m.to_array()));
                    }
                }
            }
        }
    }

    /// Six springs about the centre are the four at the points.
    #[test]
    fn a_face_has_the_springs_of_its_points() {
        let frame = [Vec3::X, Vec3::Y, Vec3::Z];
        let (area, half, stiffness) = (0.7, [0.21, 0.34], [3.1e9, 1.7e9]);
        let (d, w) = (Vec3::new(0.3, -0.8, 0.5), Vec3::new(-0.4, 0.9, 0.2));
        let (mut force, mut moment) = (Vec3::ZERO, Vec3::ZERO);
        for (b, c) in SIGNS[0].into_iter().zip(SIGNS[1]) {
            let arm = Vec3::new(0.0, b * half[0], c * half[1]);
            let moved = d + w.cross(arm);
            let [kn, ks] = stiffness.map(|k| 0.25 * area * k);
            let f = Vec3::new(kn, ks, ks) * moved;
            force += f;
            moment += arm.cross(f);
        }
        let (f, m) = pull(&frame, &springs(area, half, stiffness), d, w);
        assert!((f - force).length() < 1e-14 * force.length());
        assert!((m - moment).length() < 1e-14 * moment.length());
    }
}
