//! Handing the state of a block on to the parts that it is cut into.
//!
//! Displacements and velocities of new nodes are interpolated in the tetrahedra of the parent ([`locate`]).
//! Interpolated velocities miss momentum and angular momentum, so [`conserve`] adds a rigid motion that restores both
//! and shrinks the rest until no kinetic energy is gained, as far as the rigid motion lets it: with
//! [`Tetrahedra::inertial`] masses the gain is below 0.05 %.
//!
//! Interpolated displacements would also make strain energy (up to a fifth of that of a block). Each new tetrahedron
//! gets the mean of the parent's stress over its volume instead ([`shares`], [`mean_stresses`]), held by a start stress
//! ([`start_stresses`]): the energy `1/2 S : C^-1 : S` of a mean is never above the mean of the energies.
//!
//! Source: derived here; Han, Liu & Li (2010) do not say what they do.

use super::tetrahedron::{Elastic, Groups, StartStress, Strain, Symmetric, second_piola};
use crate::Vec3;
use crate::geom::Mat3;
use crate::geom::polyhedron::Tetrahedra;

#[cfg(test)]
mod tests;

/// A point of a block as a mean of nodes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    /// Nodes of the tetrahedron that holds it.
    pub nodes: [u32; 4],
    /// Their weights, which add up to 1.
    pub weights: [f64; 4],
}

/// Where a point (m) is in a block. One a little outside is taken in the nearest tetrahedron.
#[must_use]
pub fn locate(parent: &Tetrahedra, at: Vec3) -> Place {
    let mut best = Place {
        nodes: [0; 4],
        weights: [1.0, 0.0, 0.0, 0.0],
    };
    let mut inside = f64::NEG_INFINITY;
    for (nodes, gradients) in parent.tets.iter().zip(&parent.gradients) {
        let arm = at - parent.nodes[nodes[0] as usize];
        let [b, c, d] = gradients.map(|g| g.dot(arm));
        let weights = [1.0 - b - c - d, b, c, d];
        let least = weights.into_iter().fold(f64::INFINITY, f64::min);
        if least > inside {
            inside = least;
            best = Place {
                nodes: *nodes,
                weights,
            };
        }
    }
    best
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
#[derive(Clone, Copy, Debug, PartialEq)]
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
    let (mut about_centre, mut inertia) = (Vec3::ZERO, Mat3::ZERO);
    for ((&m, &x), v) in nodes() {
        let r = x - centre;
        about_centre += m * r.cross(Vec3::from_array(*v));
        let outer = Mat3::from_cols(r.x * r, r.y * r, r.z * r);
        inertia += (Mat3::IDENTITY * r.length_squared() - outer) * m;
    }
    Motion {
        mass,
        centre,
        momentum,
        spin: about_centre + centre.cross(momentum),
        inertia,
        kinetic,
    }
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
    let keep = if deforming > room {
        (room / deforming).sqrt()
    } else {
        1.0
    };
    for (x, v) in at.iter().zip(velocities) {
        let rest = keep * Vec3::from_array(*v);
        *v = (rest + velocity + rate.cross(*x - now.centre)).to_array();
    }
    rigid + keep * keep * deforming - before.kinetic
}

/// Shares of the tetrahedra of the parent in each tetrahedron of a part: `(parent's, volume over the part's volume)`,
/// which add up to 1.
#[must_use]
pub fn shares(parent: &Tetrahedra, part: &Tetrahedra) -> Vec<Vec<(u32, f64)>> {
    let corners = |mesh: &Tetrahedra, tet: usize| mesh.tets[tet].map(|k| mesh.nodes[k as usize]);
    let bounds = |t: &[Vec3; 4]| {
        let low = t[0].min(t[1]).min(t[2].min(t[3]));
        (low, t[0].max(t[1]).max(t[2].max(t[3])))
    };
    let theirs: Vec<_> = (0..parent.tets.len())
        .map(|k| {
            let t = corners(parent, k);
            (t, bounds(&t))
        })
        .collect();
    let of = |tet: usize| {
        let own = corners(part, tet);
        let (low, high) = bounds(&own);
        let mut list: Vec<(u32, f64)> = Vec::new();
        for (k, (other, (from, to))) in theirs.iter().enumerate() {
            if low.cmpge(*to).any() || from.cmpge(high).any() {
                continue;
            }
            let volume = common_volume(&own, other);
            if volume > 0.0 {
                list.push((k as u32, volume));
            }
        }
        let sum: f64 = list.iter().map(|(_, v)| v).sum();
        for (_, v) in &mut list {
            *v /= sum;
        }
        list
    };
    (0..part.tets.len()).map(of).collect()
}

/// Volume that two tetrahedra (positive volume) share, m³: one is cut by the faces of the other.
fn common_volume(a: &[Vec3; 4], b: &[Vec3; 4]) -> f64 {
    // Each face with the vertex opposite on its inner side.
    const FACES: [[usize; 3]; 4] = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]];
    let mut pieces = vec![*a];
    let mut next = Vec::new();
    for face in FACES {
        let [p, q, r] = face.map(|k| b[k]);
        let normal = (q - p).cross(r - p);
        for piece in pieces.drain(..) {
            keep_inside(&piece, normal, p, &mut next);
        }
        std::mem::swap(&mut pieces, &mut next);
    }
    let volume = |t: &[Vec3; 4]| (t[1] - t[0]).dot((t[2] - t[0]).cross(t[3] - t[0])).abs() / 6.0;
    pieces.iter().map(volume).sum()
}

/// Adds the tetrahedra that make up the part of one on the inner side of a plane.
fn keep_inside(tet: &[Vec3; 4], normal: Vec3, origin: Vec3, to: &mut Vec<[Vec3; 4]>) {
    let height = tet.map(|p| normal.dot(p - origin));
    let (mut inner, mut outer) = (Vec::with_capacity(4), Vec::with_capacity(4));
    for (k, height) in height.iter().enumerate() {
        if *height < 0.0 {
            inner.push(k);
        } else {
            outer.push(k);
        }
    }
    let cut = |i: usize, o: usize| {
        let share = height[i] / (height[i] - height[o]);
        tet[i] + share * (tet[o] - tet[i])
    };
    match (inner.as_slice(), outer.as_slice()) {
        ([], _) => {}
        (_, []) => to.push(*tet),
        ([i], [a, b, c]) => to.push([tet[*i], cut(*i, *a), cut(*i, *b), cut(*i, *c)]),
        ([i, j], [a, b]) => {
            // A wedge between the triangles (i, ia, ib) and (j, ja, jb).
            wedge(
                [tet[*i], cut(*i, *a), cut(*i, *b)],
                [tet[*j], cut(*j, *a), cut(*j, *b)],
                to,
            );
        }
        ([i, j, k], [a]) => wedge(
            [tet[*i], tet[*j], tet[*k]],
            [cut(*i, *a), cut(*j, *a), cut(*k, *a)],
            to,
        ),
        // Four vertices are shared out in no other way.
        _ => {}
    }
}

/// Three tetrahedra of a prism between two triangles.
fn wedge([a, b, c]: [Vec3; 3], [d, e, f]: [Vec3; 3], to: &mut Vec<[Vec3; 4]>) {
    to.push([a, b, c, d]);
    to.push([b, c, d, e]);
    to.push([c, d, e, f]);
}

/// Means of the parent's stresses over the tetrahedra of a part, with their [`shares`].
#[must_use]
pub fn mean_stresses(shares: &[Vec<(u32, f64)>], stresses: &[Symmetric]) -> Vec<Symmetric> {
    let mean = |list: &Vec<(u32, f64)>| {
        let mut sum = [0.0; 6];
        for (tet, share) in list {
            for (sum, s) in sum.iter_mut().zip(stresses[*tet as usize]) {
                *sum += share * s;
            }
        }
        sum
    };
    shares.iter().map(mean).collect()
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
    let differences: Vec<Symmetric> = wanted
        .iter()
        .zip(&elastic)
        .map(|(w, e)| std::array::from_fn(|k| w[k] - e[k]))
        .collect();
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
