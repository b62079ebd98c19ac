//! Tractions and dashpots on faces of deformable blocks.

use riprap_geom::{Mat3, Vec3};

use crate::push::traction::{Spot, traction};
use crate::setup::{BoundaryKind, Setup};
use crate::state::deform::{Deform, Surface};
use crate::state::push::Account;
use crate::state::workspace::Dashpot;
use crate::state::world::World;

/// Dashpots of viscous faces (Lysmer & Kuhlemeyer 1969), by node.
///
/// Nodes lie on the face itself, so there is no half block in between as with rigid blocks.
#[must_use]
pub(crate) fn dashpots(setup: &Setup, deform: &Deform) -> Vec<Dashpot> {
    let mut found: Vec<Dashpot> = Vec::new();
    each_dashpot(setup, deform, |_, dashpot| found.push(dashpot));
    // The order of equal nodes stays that of the surfaces.
    found.sort_by_key(|d| d.node);
    found.dedup_by(|later, first| {
        let same = later.node == first.node;
        if same {
            first.matrix += later.matrix;
        }
        same
    });
    found
}

/// Hands over the dashpots of each viscous face on each of its nodes, `A (rho c_P n n^T + rho c_S (1 - n n^T))`, with the number of
/// the boundary.
pub(crate) fn each_dashpot(setup: &Setup, deform: &Deform, mut put: impl FnMut(usize, Dashpot)) {
    for surface in &deform.surfaces {
        let viscous = |k: &usize| matches!(setup.boundaries[*k].kind, BoundaryKind::Viscous { .. });
        let Some(boundary) = surface.boundary().filter(viscous) else {
            continue;
        };
        let block = deform.bodies[surface.body as usize].block as usize;
        let material = &setup.materials[usize::from(setup.blocks[block].material)];
        let moduli = material.constrained_modulus().zip(material.shear_modulus());
        let Some((m, g)) = moduli else { continue };
        let [p, s] = [m, g].map(|modulus| (material.density * modulus).sqrt());
        let n = surface.normal;
        let dyad = Mat3::from_cols(n.x * n, n.y * n, n.z * n);
        let per_area = p * dyad + s * (Mat3::IDENTITY - dyad);
        for &(node, area) in &surface.nodes {
            let matrix = area * per_area;
            put(boundary, Dashpot { node, matrix });
        }
    }
}

/// Pushes the nodes of faces with a condition with the given tractions.
pub(crate) fn apply(world: &World, deform: &Deform, half: [f64; 2], loads: &mut Account) {
    each(world, deform, half, |_, node, force| {
        loads.need_nodes(deform.nodes.len());
        loads.on_node(node, force);
    });
}

/// Hands over the number of the boundary, a node and a force (N) of the given tractions on it, in the kick that spans the `half` steps (s)
/// before and after the present time.
pub(crate) fn each(
    world: &World,
    deform: &Deform,
    half: [f64; 2],
    mut put: impl FnMut(usize, u32, Vec3),
) {
    let given = |k: &usize| {
        let boundary = &world.setup.boundaries[*k];
        boundary.in_situ || matches!(boundary.kind, BoundaryKind::Traction { .. })
    };
    for surface in &deform.surfaces {
        let Some(boundary) = surface.boundary().filter(given) else {
            continue;
        };
        for (k, &(node, area)) in surface.nodes.iter().enumerate() {
            let t = at_node(world, deform, surface, k, half);
            if t != Vec3::ZERO {
                put(boundary, node, area * t);
            }
        }
    }
}

/// Traction (Pa) on node number `k` of a surface in a kick.
fn at_node(world: &World, deform: &Deform, surface: &Surface, k: usize, half: [f64; 2]) -> Vec3 {
    let Some(boundary) = surface.boundary().map(|b| &world.setup.boundaries[b]) else {
        return Vec3::ZERO;
    };
    let spot = Spot {
        start: surface.normal,
        // The pressure keeps the direction of the start: faces of deformable blocks turn little.
        normal: surface.normal,
        stress_at: surface.heights[k],
        pressure_at: deform.nodes.place[surface.nodes[k].0 as usize].z,
    };
    let when = (world.time, half);
    traction(boundary, world.setup.in_situ.as_ref(), &spot, when)
}

/// Sum of the tractions on a surface, N.
#[must_use]
pub(crate) fn total(world: &World, deform: &Deform, surface: &Surface) -> Vec3 {
    let nodes = surface.nodes.iter().enumerate();
    nodes.map(|(k, (_, area))| *area * at_node(world, deform, surface, k, [0.0; 2])).sum()
}
