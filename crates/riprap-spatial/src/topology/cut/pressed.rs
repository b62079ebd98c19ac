//! Traction in a block that is cut.

use riprap_geom::polyhedron::Tetrahedra;
use riprap_geom::{Mat3, Vec3};

use crate::laws::tetrahedron::{Strain, tensor};
use crate::laws::transfer::{WELL_INSIDE, weights};
use crate::state::deform::{Body, Deform};
use crate::state::workspace::Workspace;

/// A weight above this is inside.
const INSIDE: f64 = -1e-9;

/// Nominal stress of a body, tetrahedron by tetrahedron.
pub(super) struct Pressed<'a> {
    mesh: &'a Tetrahedra,
    stress: Vec<Mat3>,
}

impl<'a> Pressed<'a> {
    pub(super) fn new(deform: &Deform, work: &'a Workspace, body: &Body) -> Self {
        let kind = work.class(body);
        let u = deform.displacement(body);
        let start = work.start_of(deform.slot[body.block as usize] as usize);
        let all = kind.groups.stresses(&kind.law, body.strain, start, u);
        let stress = all.into_iter().enumerate().map(|(tet, s)| {
            let s = tensor(s);
            match body.strain {
                Strain::Small => s,
                Strain::Large => {
                    // First Piola-Kirchhoff: J sigma F^-T.
                    let rows = kind.groups.gradient(tet, u).map(Vec3::from_array);
                    let f = Mat3::from_cols(rows[0], rows[1], rows[2]).transpose() + Mat3::IDENTITY;
                    f.determinant() * s * f.inverse().transpose()
                }
            }
        });
        Self { mesh: &kind.mesh, stress: stress.collect() }
    }

    /// At a point about the centroid; the mean of several where it lies between tetrahedra.
    pub(super) fn at(&self, place: Vec3) -> Mat3 {
        let holders = holders(self.mesh, place);
        let sum: Mat3 = holders.iter().fold(Mat3::ZERO, |m, k| m + self.stress[*k]);
        sum * (1.0 / holders.len() as f64)
    }
}

/// Tetrahedra that hold a point in the coordinates of the mesh; several where it lies between them, the nearest where it
/// lies outside by round-off.
fn holders(mesh: &Tetrahedra, at: Vec3) -> Vec<usize> {
    let mut inside = Vec::new();
    let mut nearest = (0, f64::NEG_INFINITY);
    for tet in 0..mesh.tets.len() {
        let (_, least) = weights(mesh, tet, at);
        if least > WELL_INSIDE {
            return vec![tet];
        }
        if least >= INSIDE {
            inside.push(tet);
        }
        if least > nearest.1 {
            nearest = (tet, least);
        }
    }
    if inside.is_empty() {
        inside.push(nearest.0);
    }
    inside
}
