//! Facets that turn with their blocks.
//!
//! The rotation of a deformable block with large strain is that of its mean deformation gradient (polar decomposition);
//! rigid blocks have theirs. A facet turns with the mean of the two sides, so that bonds of blocks that turn together stay
//! without force, and broken ones push along the normal that they have now. Both sides still meet at the points of the start: a
//! facet whose sides have slid by more than about 1 % of a block carries less and less what new contacts would.

use riprap_geom::{Mat3, Vec3};

use super::store::{Body, Deform, Facet};
use super::workspace::{BODIES, Workspace};
use crate::exec::{Divide, Exec};
use crate::laws::tetrahedron::Strain;
use crate::spatial::world::World;

/// Rounds of the iteration for the rotation; it converges quadratically.
const ROUNDS: usize = 6;

/// Finds the rotations of all bodies with large strain.
pub(super) fn look(deform: &Deform, work: &mut Workspace, exec: &Exec) {
    if deform.living().all(|b| b.strain == Strain::Small) {
        work.turns.clear();
        return;
    }
    let mut turns = std::mem::take(&mut work.turns);
    turns.resize(deform.bodies.len(), Mat3::IDENTITY);
    let piece = Piece {
        first: 0,
        turns: &mut turns,
    };
    let count = deform.bodies.len().div_ceil(BODIES);
    let known = &*work;
    exec.divided(piece, count, |_, piece| {
        let bodies = &deform.bodies[piece.first..piece.first + piece.turns.len()];
        for (turn, body) in piece.turns.iter_mut().zip(bodies) {
            *turn = rotation(deform, known, body);
        }
    });
    work.turns = turns;
}

struct Piece<'a> {
    first: usize,
    turns: &'a mut [Mat3],
}

impl Divide for Piece<'_> {
    fn divide(self, middle: usize) -> (Self, Self) {
        let (a, b) = self.turns.split_at_mut(middle * BODIES);
        let first = self.first;
        (
            Self { first, turns: a },
            Self {
                first: first + middle * BODIES,
                turns: b,
            },
        )
    }
}

/// Rotation of a body; none with small strain, or where it is dead or crushed.
#[must_use]
pub(super) fn rotation(deform: &Deform, work: &Workspace, body: &Body) -> Mat3 {
    if body.strain == Strain::Small || !body.alive {
        return Mat3::IDENTITY;
    }
    // The mean gradient, by Gauss's theorem from the surface.
    let mut f = Mat3::IDENTITY;
    for (u, slope) in deform.moved(body).iter().zip(&work.kind(body).slopes) {
        let u = Vec3::from_array(*u);
        f += Mat3::from_cols(slope.x * u, slope.y * u, slope.z * u);
    }
    polar(f)
}

/// Rotation of a deformation gradient (Higham 1986: the mean of a matrix and its inverse transposed, again and again).
fn polar(f: Mat3) -> Mat3 {
    let mut r = f;
    for _ in 0..ROUNDS {
        let det = r.determinant();
        if !(det > 0.0 && det.is_finite()) {
            return Mat3::IDENTITY;
        }
        r = 0.5 * (r + r.inverse().transpose());
    }
    r
}

/// A frame turned by the mean of some rotations.
pub(super) fn turned(frame: [Vec3; 3], by: &[Mat3]) -> [Vec3; 3] {
    let mean = |e: Vec3| by.iter().map(|r| *r * e).sum::<Vec3>();
    let n = mean(frame[0]).normalize_or(frame[0]);
    let b = mean(frame[1]);
    let b = (b - b.dot(n) * n).normalize_or(n.any_orthonormal_vector());
    [n, b, n.cross(b)]
}

/// How facets turn.
pub(super) struct Turning<'a> {
    world: &'a World,
    deform: &'a Deform,
    turns: &'a [Mat3],
}

impl<'a> Turning<'a> {
    /// `None` where no block turns. The world is without its deformable part.
    pub(super) fn new(world: &'a World, deform: &'a Deform, turns: &'a [Mat3]) -> Option<Self> {
        let any = !turns.is_empty() || world.turned.iter().any(Option::is_some);
        any.then_some(Self {
            world,
            deform,
            turns,
        })
    }

    /// Turns a facet with its blocks.
    pub(super) fn turn(&self, facet: &mut Facet) {
        let side = |k: usize| {
            let b = facet.blocks[k] as usize;
            if facet.rigid[k] {
                let turned = self.world.turned[b].as_ref();
                return turned.map_or(Mat3::IDENTITY, |t| Mat3::from_quat(t.attitude));
            }
            let slot = self.deform.slot[b] as usize;
            self.turns.get(slot).copied().unwrap_or(Mat3::IDENTITY)
        };
        let sides = [side(0), side(1)];
        if sides != [Mat3::IDENTITY; 2] || facet.now != facet.frame {
            facet.now = turned(facet.frame, &sides);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_rotation_of_a_stretched_turn_is_the_turn() {
        let turn = Mat3::from_quat(riprap_geom::Quat::from_scaled_axis(Vec3::new(
            0.4, -1.1, 0.7,
        )));
        let stretch = Mat3::from_diagonal(Vec3::new(1.02, 0.99, 1.0));
        let found = polar(turn * stretch);
        let off = (found - turn).to_cols_array().into_iter();
        assert!(off.fold(0.0, |m: f64, x| m.max(x.abs())) < 1e-14);
        assert_eq!(polar(Mat3::ZERO), Mat3::IDENTITY);
        let frame = turned([Vec3::X, Vec3::Y, Vec3::Z], &[turn, turn]);
        assert!((frame[0] - turn * Vec3::X).length() < 1e-14);
        assert!((frame[2] - turn * Vec3::Z).length() < 1e-14);
    }
}
