//! The stress of a block as a linear field.

use super::Symmetric;
use crate::Vec3;
use crate::geom::Mat3;
use crate::geom::polyhedron::Tetrahedra;

/// The linear field that comes nearest to the stresses of the tetrahedra of a block: the integral of the squared
/// difference over the block is smallest.
///
/// It has their mean and first moments. Nearest in this norm is nearest in the energy `1/2 S : C^-1 : S` too, because `C`
/// is the same in the whole block; so the field has no more energy than the stresses, and its means over parts have no
/// more than the field.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LinearStress {
    centre: Vec3,
    /// Mean over the block, Pa.
    mean: Symmetric,
    /// Slope of each component, Pa/m.
    slopes: [Vec3; 6],
}

impl LinearStress {
    /// From the stresses (Pa) of the tetrahedra of a block. *Shape* `[n_tets]`.
    #[must_use]
    pub fn new(block: &Tetrahedra, stresses: &[Symmetric]) -> Self {
        let tets = || block.tets.iter().zip(&block.volumes);
        let corners = |tet: &[u32; 4]| tet.map(|k| block.nodes[k as usize]);
        let (mut volume, mut first, mut mean) = (0.0, Vec3::ZERO, [0.0; 6]);
        for ((tet, v), s) in tets().zip(stresses) {
            let [a, b, c, d] = corners(tet);
            volume += v;
            first += 0.25 * v * (a + b + c + d);
            for (sum, x) in mean.iter_mut().zip(s) {
                *sum += v * x;
            }
        }
        let centre = first / volume;
        // int r r^T and int S r over the block.
        let (mut second, mut moments) = (Mat3::ZERO, [Vec3::ZERO; 6]);
        for ((tet, v), s) in tets().zip(stresses) {
            let arms = corners(tet).map(|x| x - centre);
            let sum = arms[0] + arms[1] + arms[2] + arms[3];
            // Over a tetrahedron: V/20 (sum of r r^T of its corners + s s^T), s the sum of their arms.
            for r in [arms[0], arms[1], arms[2], arms[3], sum] {
                let r_v = 0.05 * v * r;
                second += Mat3::from_cols(r.x * r_v, r.y * r_v, r.z * r_v);
            }
            for (moment, x) in moments.iter_mut().zip(s) {
                *moment += 0.25 * v * x * sum;
            }
        }
        let inverse = second.inverse();
        Self {
            centre,
            mean: mean.map(|x| x / volume),
            slopes: moments.map(|moment| inverse * moment),
        }
    }

    /// Stress at a point (m, in the coordinates of the block), Pa.
    #[must_use]
    pub fn at(&self, place: Vec3) -> Symmetric {
        let r = place - self.centre;
        std::array::from_fn(|k| self.mean[k] + self.slopes[k].dot(r))
    }

    /// Means over the tetrahedra of a part, in the same coordinates, Pa. *Shape* `[n_tets]`.
    #[must_use]
    pub fn means(&self, part: &Tetrahedra) -> Vec<Symmetric> {
        let centres = part.tets.iter().map(|tet| {
            let [a, b, c, d] = tet.map(|k| part.nodes[k as usize]);
            0.25 * (a + b + c + d)
        });
        centres.map(|at| self.at(at)).collect()
    }
}
