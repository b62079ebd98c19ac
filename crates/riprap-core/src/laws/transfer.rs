//! Handing the state of a block on to the parts that it is cut into.
//!
//! Displacements and velocities of new nodes are interpolated in the tetrahedra of the parent ([`PointLocation`]).
//! Interpolated velocities miss momentum and angular momentum, so [`conserve`] adds a rigid motion that restores both
//! and shrinks the rest until no kinetic energy is gained, as far as the rigid motion lets it: with
//! [`Tetrahedra::inertial`] masses the gain is below 0.05 %.
//!
//! Interpolated displacements would also make strain energy (up to a fifth of that of a block). Each new tetrahedron
//! gets its mean of the linear field nearest to the parent's stresses instead ([`LinearStress`]), held by a start stress
//! ([`start_stresses`]): the strain energy is never above that of the parent, for any displacements.
//!
//! The mean of the parent's own, piecewise constant stress has that property too, but the volumes that all pairs of
//! tetrahedra share took 45 % of the time of a cut and left larger forces over (0.0226 of the load against 0.0209 in
//! `fracture/uniaxial_cut`, 0.322 against 0.319 at the crack tips of `fracture/long/notched_beam`): the steps between the
//! tetrahedra of a block are errors of the elements.
//!
//! Source: derived here; Han, Liu & Li (2010) do not say what they do.

use super::tetrahedron::{Elastic, Groups, StartStress, Strain, Symmetric, second_piola};
use crate::Vec3;
use crate::geom::Mat3;
use crate::geom::polyhedron::Tetrahedra;

mod linear;
#[cfg(test)]
mod tests;

pub use linear::LinearStress;

/// A point of a block as a mean of nodes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    /// Nodes of the tetrahedron that holds it.
    pub nodes: [u32; 4],
    /// Their weights, which add up to 1.
    pub weights: [f64; 4],
}

/// A point with weights above this is in no other tetrahedron.
pub const WELL_INSIDE: f64 = 1e-3;

/// Finds the tetrahedra of a block that hold points.
pub struct PointLocation<'a> {
    mesh: &'a Tetrahedra,
    /// Normal of each face over its distance from the centroid, 1/m. *Shape* `[n_faces]`.
    faces: Vec<Vec3>,
}

impl<'a> PointLocation<'a> {
    /// For a block whose tetrahedra have their gradients.
    #[must_use]
    pub fn new(mesh: &'a Tetrahedra) -> Self {
        let firsts = mesh.first[..mesh.first.len() - 1].iter();
        let faces = firsts.map(|&first| mesh.gradients[first as usize].iter().sum());
        Self { mesh, faces: faces.collect() }
    }

    /// Where a point (m) is. One a little outside is taken in the nearest tetrahedron.
    #[must_use]
    pub fn locate(&self, at: Vec3) -> Place {
        // The face through which the ray from the centroid leaves the block.
        let r = at - self.mesh.nodes[self.mesh.nodes.len() - 1];
        let (mut face, mut most) = (0, f64::NEG_INFINITY);
        for (k, normal) in self.faces.iter().enumerate() {
            let reach = normal.dot(r);
            if reach > most {
                (face, most) = (k, reach);
            }
        }
        let range = self.mesh.first[face] as usize..self.mesh.first[face + 1] as usize;
        let (place, inside) = nearest(self.mesh, at, range);
        // Faces may be a little crooked.
        if inside < -WELL_INSIDE {
            return nearest(self.mesh, at, 0..self.mesh.tets.len()).0;
        }
        place
    }
}

/// A point (m) by the nodes of a tetrahedron, and its least weight: below zero outside.
#[must_use]
pub fn weights(mesh: &Tetrahedra, tet: usize, at: Vec3) -> (Place, f64) {
    let nodes = mesh.tets[tet];
    let arm = at - mesh.nodes[nodes[0] as usize];
    let [b, c, d] = mesh.gradients[tet].map(|g| g.dot(arm));
    let weights = [1.0 - b - c - d, b, c, d];
    (Place { nodes, weights }, weights.into_iter().fold(f64::INFINITY, f64::min))
}

/// The first of some tetrahedra whose least weight at a point is largest, and that weight.
#[must_use]
pub fn nearest(parent: &Tetrahedra, at: Vec3, some: std::ops::Range<usize>) -> (Place, f64) {
    let mut best = Place { nodes: [0; 4], weights: [1.0, 0.0, 0.0, 0.0] };
    let mut inside = f64::NEG_INFINITY;
    for tet in some {
        let (place, least) = weights(parent, tet, at);
        if least > inside {
            inside = least;
            best = place;
            if least > WELL_INSIDE {
                break;
            }
        }
    }
    (best, inside)
}

/// Value of a nodal field of the parent at a place.
#[must_use]
pub fn interpolate(place: &Place, field: &[[f64; 3]]) -> [f64; 3] {
    [0, 1, 2].map(|k| {
        let term = |n: usize| place.weights[n] * field[place.nodes[n] as usize][k];
        term(0) + term(1) + term(2) + term(3)
    })
}

/// Motion of a set of nodes as a whole.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Motion {
    /// Mass, kg.
    pub mass: f64,
    /// Centre of mass, m.
    pub centre: Vec3,
    /// Momentum, kg m/s.
    pub momentum: Vec3,
    /// Angular momentum about the origin of coordinates, kg m²/s.
    pub spin: Vec3,
    /// Inertia tensor about the centre, kg m².
    pub inertia: Mat3,
    /// Kinetic energy, J.
    pub kinetic: f64,
}

/// Motion of nodes with masses (kg), places (m) and velocities (m/s). *Shapes* `[n_nodes]`.
#[must_use]
pub fn motion(masses: &[f64], at: &[Vec3], velocities: &[[f64; 3]]) -> Motion {
    let nodes = || masses.iter().zip(at).zip(velocities);
    let (mut mass, mut first, mut momentum, mut kinetic) = (0.0, Vec3::ZERO, Vec3::ZERO, 0.0);
    for ((&m, &x), v) in nodes() {
        let v = Vec3::from_array(*v);
        mass += m;
        first += m * x;
        momentum += m * v;
        kinetic += 0.5 * m * v.length_squared();
    }
    let centre = first / mass;
    // About the centre, then shifted: about a far origin the sums would lose their digits.
    let (mut about_centre, mut inertia) = (Vec3::ZERO, Mat3::ZERO);
    for ((&m, &x), v) in nodes() {
        let r = x - centre;
        about_centre += m * r.cross(Vec3::from_array(*v));
        let outer = Mat3::from_cols(r.x * r, r.y * r, r.z * r);
        inertia += (Mat3::IDENTITY * r.length_squared() - outer) * m;
    }
    Motion { mass, centre, momentum, spin: about_centre + centre.cross(momentum), inertia, kinetic }
}

/// Changes the velocities of all nodes of the parts of a block so that momentum and angular momentum are those of
/// the block before; returns the gain of kinetic energy, J, which is above 0 only where the rigid motion alone has
/// more than the block had.
pub fn conserve(before: &Motion, masses: &[f64], at: &[Vec3], velocities: &mut [[f64; 3]]) -> f64 {
    let now = motion(masses, at, velocities);
    let velocity = before.momentum / now.mass;
    let turning = now.inertia.inverse();
    let spin = before.spin - now.centre.cross(before.momentum);
    let rate = turning * spin;
    let now_rate = turning * (now.spin - now.centre.cross(now.momentum));
    let now_velocity = now.momentum / now.mass;
    // What is left without the rigid motion that fits best has neither momentum nor angular momentum.
    let mut deforming = 0.0;
    for ((m, x), v) in masses.iter().zip(at).zip(&mut *velocities) {
        let rest = Vec3::from_array(*v) - now_velocity - now_rate.cross(*x - now.centre);
        deforming += 0.5 * m * rest.length_squared();
        *v = rest.to_array();
    }
    let rigid = 0.5 * (before.momentum.dot(velocity) + spin.dot(rate));
    let room = (before.kinetic - rigid).max(0.0);
    let keep = if deforming > room { (room / deforming).sqrt() } else { 1.0 };
    for (x, v) in at.iter().zip(velocities) {
        let rest = keep * Vec3::from_array(*v);
        *v = (rest + velocity + rate.cross(*x - now.centre)).to_array();
    }
    rigid + keep * keep * deforming - before.kinetic
}

/// Second Piola-Kirchhoff stress of each tetrahedron of a block (with small strain just the stress), Pa: what is to be
/// averaged.
#[must_use]
pub fn stresses(
    groups: &Groups,
    law: &Elastic,
    strain: Strain,
    start: &StartStress,
    u: &[[f64; 3]],
) -> Vec<Symmetric> {
    (0..groups.tets())
        .map(|tet| second_piola(law, strain, &start.one(tet), &groups.gradient(tet, u)))
        .collect()
}

/// Start stresses with which the tetrahedra of a part carry the stresses `wanted` at the displacements `u`.
#[must_use]
pub fn start_stresses(
    groups: &Groups,
    law: &Elastic,
    strain: Strain,
    u: &[[f64; 3]],
    wanted: &[Symmetric],
) -> StartStress {
    let none = StartStress::default();
    let elastic = stresses(groups, law, strain, &none, u);
    let differences: Vec<Symmetric> =
        wanted.iter().zip(&elastic).map(|(w, e)| std::array::from_fn(|k| w[k] - e[k])).collect();
    StartStress::new(&differences)
}

/// Energy `1/2 S : C^-1 : S` of a stress (Pa), J/m³.
#[must_use]
pub fn stress_energy(law: &Elastic, s: &Symmetric) -> f64 {
    let trace = s[0] + s[1] + s[2];
    let squares = s[0] * s[0] + s[1] * s[1] + s[2] * s[2];
    let shears = s[3] * s[3] + s[4] * s[4] + s[5] * s[5];
    let part = law.lambda / (3.0 * law.lambda + 2.0 * law.mu) * trace * trace;
    (squares + 2.0 * shears - part) / (4.0 * law.mu)
}
