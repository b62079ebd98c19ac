//! Facets that turn with their blocks.
//!
//! The rotation of a deformable block with large strain is that of its mean deformation gradient (polar decomposition);
//! rigid blocks have theirs. A facet turns with the mean of the two sides, so that bonds of blocks that turn together stay
//! without force, and broken ones push along the normal that they have now. Both sides still meet at the points of the start: a
//! facet whose sides have slid by more than about 1 % of a block carries less and less what new contacts would.

use riprap_core::cut;
use riprap_geom::{Mat3, Vec3};

use crate::exec::{Divide, Exec};
use crate::lanes::{LANES, Lanes, Vectors, Width, cross, dot, minus, plus, scaled};
use crate::laws::tetrahedron::Strain;
use crate::state::bodies::Turned;
use crate::state::deform::{Body, Deform, Facet};
use crate::state::workspace::{BODIES, Slopes, Workspace};

/// Rounds of the iteration for the rotation; it converges quadratically.
const ROUNDS: usize = 6;

/// Finds the rotations of all bodies with large strain.
pub(super) fn look(deform: &Deform, work: &mut Workspace, exec: &Exec, width: Width) {
    if deform.living().all(|b| b.strain == Strain::Small) {
        work.turns.clear();
        return;
    }
    work.turns.resize(deform.bodies.len(), Mat3::IDENTITY);
    let piece = Piece { first: 0, turns: &mut work.turns };
    let count = deform.bodies.len().div_ceil(BODIES);
    let slopes = Slopes { classes: &work.classes, slopes: &work.slopes };
    exec.divided(piece, count, |_, piece| {
        let bodies = &deform.bodies[piece.first..piece.first + piece.turns.len()];
        for (turn, body) in piece.turns.iter_mut().zip(bodies) {
            *turn = gradient(deform, slopes.of(body), body);
        }
        width.run(
            #[inline(always)]
            || {
                // A loop and no iterator: what goes through one may be compiled for narrower registers.
                for turns in piece.turns.chunks_mut(LANES) {
                    polar_eight(turns);
                }
            },
        );
    });
}

struct Piece<'a> {
    first: usize,
    turns: &'a mut [Mat3],
}

impl Divide for Piece<'_> {
    fn divide(self, middle: usize) -> (Self, Self) {
        cut!(self, first: middle * BODIES, turns: middle * BODIES)
    }
}

/// Rotation of a body; none with small strain, or where it is dead or crushed.
#[must_use]
pub(crate) fn rotation(deform: &Deform, work: &Workspace, body: &Body) -> Mat3 {
    let mut one = [gradient(deform, work.slopes().of(body), body)];
    polar_eight(&mut one);
    one[0]
}

/// Mean deformation gradient of a body, by Gauss's theorem from the surface; the identity with small strain, or where it
/// is dead.
fn gradient(deform: &Deform, slopes: &[Vec3], body: &Body) -> Mat3 {
    let mut f = Mat3::IDENTITY;
    if body.strain == Strain::Small || !body.alive {
        return f;
    }
    for (u, slope) in deform.displacement(body).iter().zip(slopes) {
        let u = Vec3::from_array(*u);
        f += Mat3::from_cols(slope.x * u, slope.y * u, slope.z * u);
    }
    f
}

/// Replaces up to eight deformation gradients by their rotations (Higham 1986: the mean of a matrix and its inverse
/// transposed, again and again); by the identity where a block is crushed.
#[inline(always)]
fn polar_eight(list: &mut [Mat3]) {
    let mut columns = [Vectors::default(); 3];
    for k in 0..LANES {
        let f = list.get(k).unwrap_or(&Mat3::IDENTITY).to_cols_array_2d();
        for (column, x) in columns.iter_mut().zip(f) {
            for axis in 0..3 {
                column[axis].0[k] = x[axis];
            }
        }
    }
    let half = Lanes::all(0.5);
    let mut crushed = [false; LANES];
    // A stretch s goes to (s + 1/s)/2: from a third or from 3 six rounds reach 1 to round-off.
    for _ in 0..ROUNDS {
        let [x, y, z] = &columns;
        let minors = [cross(y, z), cross(z, x), cross(x, y)];
        let det = dot(x, &minors[0]);
        for (crushed, det) in crushed.iter_mut().zip(det.0) {
            // Written so that what is not a number counts as crushed.
            *crushed |= !(det > 0.0 && det.is_finite());
        }
        let over = Lanes::all(1.0) / det;
        for (column, minor) in columns.iter_mut().zip(&minors) {
            *column = scaled(half, &plus(column, &scaled(over, minor)));
        }
    }
    for (k, (turn, crushed)) in list.iter_mut().zip(crushed).enumerate() {
        let [x, y, z] = &columns;
        *turn = match crushed {
            true => Mat3::IDENTITY,
            false => Mat3::from_cols(of_lane(x, k), of_lane(y, k), of_lane(z, k)),
        };
    }
}

/// A frame turned by the mean of some rotations.
pub(crate) fn turned(frame: [Vec3; 3], by: &[Mat3]) -> [Vec3; 3] {
    let mean = |e: Vec3| by.iter().map(|r| *r * e).sum::<Vec3>();
    let n = mean(frame[0]).normalize_or(frame[0]);
    let b = mean(frame[1]);
    // The means of two turned axes are not square to each other by themselves.
    let b = (b - b.dot(n) * n).normalize_or(n.any_orthonormal_vector());
    [n, b, n.cross(b)]
}

/// How facets turn.
pub(super) struct Turning<'a> {
    turned: &'a [Option<Box<Turned>>],
    slot: &'a [u32],
    turns: &'a [Mat3],
}

impl<'a> Turning<'a> {
    /// From the finite rotations of rigid blocks, the place of deformable ones in the list of bodies and their rotations; `None`
    /// where no block turns.
    pub(super) fn new(
        turned: &'a [Option<Box<Turned>>],
        slot: &'a [u32],
        turns: &'a [Mat3],
    ) -> Option<Self> {
        let any = !turns.is_empty() || turned.iter().any(Option::is_some);
        any.then_some(Self { turned, slot, turns })
    }

    /// Rotation of a side of a facet.
    #[inline(always)]
    fn of(&self, facet: &Facet, side: usize) -> Mat3 {
        let b = facet.blocks[side] as usize;
        if facet.rigid[side] {
            let turned = self.turned[b].as_ref();
            return turned.map_or(Mat3::IDENTITY, |t| Mat3::from_quat(t.attitude));
        }
        let slot = self.slot[b] as usize;
        self.turns.get(slot).copied().unwrap_or(Mat3::IDENTITY)
    }

    /// Turns facets with their blocks.
    pub(super) fn turn(&self, facets: &mut [Facet], width: Width) {
        width.run(
            #[inline(always)]
            || {
                for facets in facets.chunks_mut(LANES) {
                    let mut sides = [[Mat3::IDENTITY; 2]; LANES];
                    // Eight at once where all eight turn; a facet that never turned keeps its frame, bit by bit.
                    let mut turning = facets.len() == LANES;
                    for (sides, facet) in sides.iter_mut().zip(&*facets) {
                        *sides = [self.of(facet, 0), self.of(facet, 1)];
                        turning &= turns(facet, sides);
                    }
                    if turning && turned_eight(facets, &sides) {
                        continue;
                    }
                    for (facet, sides) in facets.iter_mut().zip(&sides) {
                        if turns(facet, sides) {
                            facet.now = turned(facet.frame, sides);
                        }
                    }
                }
            },
        );
    }
}

/// Whether a facet turns or has turned.
#[inline(always)]
fn turns(facet: &Facet, sides: &[Mat3; 2]) -> bool {
    *sides != [Mat3::IDENTITY; 2] || facet.now != facet.frame
}

/// As [`turned`] for eight facets, to the same bits; false, and nothing done, where a mean vanishes.
#[inline(always)]
pub(crate) fn turned_eight(facets: &mut [Facet], sides: &[[Mat3; 2]; LANES]) -> bool {
    let mut axes = [Vectors::default(); 2];
    let mut columns = [[Vectors::default(); 3]; 2];
    for (k, (facet, sides)) in facets.iter().zip(sides).enumerate() {
        for (axis, e) in axes.iter_mut().zip(&facet.frame) {
            put(axis, k, *e);
        }
        for (columns, r) in columns.iter_mut().zip(sides) {
            put(&mut columns[0], k, r.x_axis);
            put(&mut columns[1], k, r.y_axis);
            put(&mut columns[2], k, r.z_axis);
        }
    }
    let mut means = [Vectors::default(); 2];
    for (mean, e) in means.iter_mut().zip(&axes) {
        for [x, y, z] in &columns {
            let turned = plus(&plus(&scaled(e[0], x), &scaled(e[1], y)), &scaled(e[2], z));
            *mean = plus(mean, &turned);
        }
    }
    let [n, b] = means;
    let over = Lanes::all(1.0) / dot(&n, &n).sqrt();
    let n = scaled(over, &n);
    let b = minus(&b, &scaled(dot(&b, &n), &n));
    let over_b = Lanes::all(1.0) / dot(&b, &b).sqrt();
    let sound = |x: &f64| x.is_finite() && *x > 0.0;
    if !over.0.iter().chain(&over_b.0).all(sound) {
        return false;
    }
    let b = scaled(over_b, &b);
    let c = cross(&n, &b);
    for (k, facet) in facets.iter_mut().enumerate().take(LANES) {
        // One by one: `map` of arrays became a call for each facet, half of the time of all this.
        facet.now = [of_lane(&n, k), of_lane(&b, k), of_lane(&c, k)];
    }
    true
}

/// The vector of a lane.
#[inline(always)]
fn of_lane(v: &Vectors, lane: usize) -> Vec3 {
    Vec3::new(v[0].0[lane], v[1].0[lane], v[2].0[lane])
}

/// Sets the vector of a lane.
#[inline(always)]
fn put(to: &mut Vectors, lane: usize, v: Vec3) {
    for (to, x) in to.iter_mut().zip(v.to_array()) {
        to.0[lane] = x;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_rotation_of_a_stretched_turn_is_the_turn() {
        let turn = Mat3::from_quat(riprap_geom::Quat::from_scaled_axis(Vec3::new(0.4, -1.1, 0.7)));
        let stretch = Mat3::from_diagonal(Vec3::new(1.02, 0.99, 1.0));
        let mut found = [turn * stretch, Mat3::ZERO, turn * stretch];
        polar_eight(&mut found);
        for k in [0, 2] {
            let off = (found[k] - turn).to_cols_array().into_iter();
            assert!(off.fold(0.0, |m: f64, x| m.max(x.abs())) < 1e-14);
        }
        assert_eq!(found[1], Mat3::IDENTITY);
        let frame = turned([Vec3::X, Vec3::Y, Vec3::Z], &[turn, turn]);
        assert!((frame[0] - turn * Vec3::X).length() < 1e-14);
        assert!((frame[2] - turn * Vec3::Z).length() < 1e-14);
    }

    #[test]
    fn eight_facets_turn_like_single_ones() {
        let spin = |k: usize| {
            let x = 0.1 + k as f64;
            Mat3::from_quat(riprap_geom::Quat::from_scaled_axis(Vec3::new(
                x.sin(),
                0.3 * x,
                -x.cos(),
            )))
        };
        let facet = |k: usize| Facet {
            blocks: [0, 1],
            frame: [Vec3::X, Vec3::Y, Vec3::Z].map(|e| spin(k + 20) * e),
            now: [Vec3::X, Vec3::Y, Vec3::Z],
            centre: Vec3::ZERO,
            area: 1.0,
            first: 0,
            count: 0,
            stiffness: [1.0; 2],
            row: 0,
            rigid: [false; 2],
            origin: Default::default(),
            intact_until_step: 0,
            parted: false,
        };
        let mut facets: Vec<Facet> = (0..LANES).map(facet).collect();
        let sides: [[Mat3; 2]; LANES] = std::array::from_fn(|k| [spin(k), spin(k) * spin(7)]);
        assert!(turned_eight(&mut facets, &sides));
        for (facet, sides) in facets.iter().zip(&sides) {
            assert_eq!(facet.now, turned(facet.frame, sides));
        }
        // Opposite halves of a turn leave no mean.
        let half = Mat3::from_diagonal(Vec3::new(-1.0, -1.0, 1.0));
        let frame = [Vec3::X, Vec3::Y, Vec3::Z];
        let mut facets: Vec<Facet> = (0..LANES).map(|k| Facet { frame, ..facet(k) }).collect();
        assert!(!turned_eight(&mut facets, &[[half, Mat3::IDENTITY]; LANES]));
    }
}
