//! What acts on nodes from outside: tractions and pressures on faces, forces, accelerations, viscous faces.

use riprap_geom::{Mat3, Vec3};

use super::store::{Deform, Surface};
use crate::setup::{BoundaryKind, Load, LoadKind, Setup};
use crate::state::workspace::{Dashpot, Kind, Workspace};
use crate::world::World;

/// Dashpots of viscous faces (Lysmer & Kuhlemeyer 1969), by node: `A (rho c_P n n^T + rho c_S (1 - n n^T))`.
///
/// Nodes lie on the face itself, so there is no half block in between as with rigid blocks.
#[must_use]
pub fn dashpots(setup: &Setup, deform: &Deform) -> Vec<Dashpot> {
    let mut found: Vec<Dashpot> = Vec::new();
    for surface in &deform.surfaces {
        let viscous = |k: usize| matches!(setup.boundaries[k].kind, BoundaryKind::Viscous { .. });
        if !surface.boundary().is_some_and(viscous) {
            continue;
        }
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
            found.push(Dashpot { node, matrix });
        }
    }
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

/// Whether anything but gravity acts on nodes.
fn any(world: &World, deform: &Deform) -> bool {
    let traction = |k: usize| {
        let boundary = &world.setup.boundaries[k];
        boundary.in_situ || matches!(boundary.kind, BoundaryKind::Traction { .. })
    };
    let mut surfaces = deform.surfaces.iter();
    surfaces.any(|s| s.boundary().is_some_and(traction))
        || world
            .setup
            .loads
            .iter()
            .any(|l| l.blocks.iter().any(|b| deform.body(*b as usize).is_some()))
}

/// Sums all loads on nodes at the world's present time.
pub fn apply(world: &World, deform: &Deform, work: &mut Workspace) {
    if !any(world, deform) {
        work.loads = Vec::new();
        return;
    }
    let mut loads = std::mem::take(&mut work.loads);
    loads.clear();
    loads.resize(deform.nodes.len(), [0.0; 3]);
    for load in &world.setup.loads {
        let factor = load.time.at(world.time);
        for &b in &load.blocks {
            on_block(deform, work, load, factor, b, &mut loads);
        }
    }
    for surface in &deform.surfaces {
        for (k, &(node, area)) in surface.nodes.iter().enumerate() {
            let t = traction_at(world, deform, surface, k);
            if t != Vec3::ZERO {
                add(&mut loads[node as usize], area * t);
            }
        }
    }
    work.loads = loads;
}

/// Traction (Pa) that acts on node number `k` of a surface now, that of the stress at the start included.
fn traction_at(world: &World, deform: &Deform, surface: &Surface, k: usize) -> Vec3 {
    let Some(boundary) = surface.boundary().map(|b| &world.setup.boundaries[b]) else {
        return Vec3::ZERO;
    };
    let start = match (boundary.in_situ, &world.setup.in_situ) {
        (true, Some(in_situ)) => in_situ.at(surface.heights[k]) * surface.normal,
        (true, None) | (false, _) => Vec3::ZERO,
    };
    match &boundary.kind {
        BoundaryKind::Traction {
            traction,
            pressure,
            gradient,
            datum,
            time,
        } => {
            let z = deform.nodes.place[surface.nodes[k].0 as usize].z;
            // The pressure keeps the direction of the start: faces of deformable blocks turn little.
            let push = *traction - (pressure + gradient * (datum - z)) * surface.normal;
            start + time.at(world.time) * push
        }
        BoundaryKind::Held { .. } | BoundaryKind::Moved { .. } | BoundaryKind::Viscous { .. } => {
            start
        }
    }
}

/// Sum of the tractions on a surface, N.
#[must_use]
pub fn traction(world: &World, deform: &Deform, surface: &Surface) -> Vec3 {
    let nodes = surface.nodes.iter().enumerate();
    nodes
        .map(|(k, (_, area))| *area * traction_at(world, deform, surface, k))
        .sum()
}

/// Adds a vector to a node's.
#[inline]
pub fn add(to: &mut [f64; 3], v: Vec3) {
    for k in 0..3 {
        to[k] += v[k];
    }
}

/// A load on a block: an acceleration or a force without a point is shared by mass, a force at a point goes to the
/// tetrahedron that holds it.
fn on_block(
    deform: &Deform,
    work: &Workspace,
    load: &Load,
    factor: f64,
    b: u32,
    loads: &mut [[f64; 3]],
) {
    let Some(body) = deform.body(b as usize).filter(|body| body.alive) else {
        return;
    };
    let kind = work.kind(body);
    let (first, masses) = (body.first as usize, kind.masses());
    match &load.kind {
        LoadKind::BodyForce { acceleration } => {
            for (k, m) in masses.iter().enumerate() {
                add(&mut loads[first + k], factor * *m * *acceleration);
            }
        }
        LoadKind::Point { force, at: None } => {
            let total: f64 = masses.iter().sum();
            for (k, m) in masses.iter().enumerate() {
                add(&mut loads[first + k], factor * *m / total * *force);
            }
        }
        LoadKind::Point {
            force,
            at: Some(at),
        } => {
            let centre = deform.nodes.place[first + kind.mesh.nodes.len() - 1];
            for (node, weight) in holder(kind, *at - centre) {
                add(&mut loads[first + node as usize], factor * weight * *force);
            }
        }
        // Refused when the model is made: nodes take no moment.
        LoadKind::Moment { .. } => {}
    }
}

/// Nodes and weights of the tetrahedron that holds a point (from the centroid, m), or comes nearest to it.
fn holder(kind: &Kind, at: Vec3) -> [(u32, f64); 4] {
    let mesh = &kind.mesh;
    let mut best = ([(0, 0.0); 4], f64::NEG_INFINITY);
    for (tet, g) in mesh.tets.iter().zip(&mesh.gradients) {
        let r = at - mesh.nodes[tet[0] as usize];
        let n = g.map(|g| g.dot(r));
        let weights = [1.0 - n[0] - n[1] - n[2], n[0], n[1], n[2]];
        let least = weights.iter().copied().fold(f64::INFINITY, f64::min);
        if least > best.1 {
            best = (std::array::from_fn(|k| (tet[k], weights[k])), least);
        }
    }
    best.0
}
