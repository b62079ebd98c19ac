//! Motion of the nodes of parts: that of the tetrahedra of the parent, with its momenta.
//!
//! Interpolation alone loses angular momentum: the moment of inertia of node masses depends on where the nodes are. A rigid
//! motion is added so that momentum and angular momentum are those of the parent; where the kinetic energy would rise, the
//! motion beyond the rigid one is scaled down.

use riprap_geom::polyhedron::Tetrahedra;
use riprap_geom::{Mat3, Vec3};

use super::Family;
use crate::laws::tetrahedron::{Groups, StartStress};
use crate::spatial::deform::store::{Body, Deform};
use crate::spatial::deform::workspace::Workspace;
use crate::spatial::world::World;

/// A weight above this is inside.
const INSIDE: f64 = -1e-9;

/// Halvings in the search for a scale.
const HALVINGS: usize = 20;

/// Sums over the nodes of a body or of its parts, about one point.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Sums {
    pub(super) mass: f64,
    /// Point, m.
    pub(super) centre: Vec3,
    pub(super) momentum: Vec3,
    /// Angular momentum about the point, N m s.
    pub(super) spin: Vec3,
    pub(super) kinetic: f64,
}

/// A node with its mass, kg, present place, m, and velocity, m/s.
type Moving = (f64, Vec3, Vec3);

impl Sums {
    fn of(nodes: &[Moving], centre: Vec3) -> Self {
        let mut sums = Self {
            centre,
            ..Self::default()
        };
        for &(m, at, v) in nodes {
            sums.mass += m;
            sums.momentum += m * v;
            sums.spin += m * (at - centre).cross(v);
            sums.kinetic += 0.5 * m * v.length_squared();
        }
        sums
    }

    /// Of a body, about its centre of mass.
    pub(super) fn of_body(deform: &Deform, work: &Workspace, slot: u32) -> Self {
        let body = &deform.bodies[slot as usize];
        let nodes = moving(deform, body, work.kind(body).masses(deform.masses));
        let mass: f64 = nodes.iter().map(|n| n.0).sum();
        let first: Vec3 = nodes.iter().map(|n| n.0 * n.1).sum();
        Self::of(&nodes, first / mass)
    }

    /// Of the parts of a family.
    pub(super) fn of_parts(world: &World, deform: &Deform, family: &Family, centre: Vec3) -> Self {
        Self::of(&parts(world, deform, family), centre)
    }
}

fn moving(deform: &Deform, body: &Body, masses: &[f64]) -> Vec<Moving> {
    body.nodes()
        .zip(masses)
        .map(|(n, m)| {
            let at = deform.nodes.place[n] + Vec3::from_array(deform.nodes.moved[n]);
            (*m, at, Vec3::from_array(deform.nodes.rate[n]))
        })
        .collect()
}

fn parts(world: &World, deform: &Deform, family: &Family) -> Vec<Moving> {
    let spec = &world.setup.blocks[family.cut.block as usize];
    let density = world.setup.materials[usize::from(spec.material)].density;
    let mut all = Vec::new();
    for (part, child) in family.cut.parts.iter().zip(family.children()) {
        let shares = match deform.masses {
            crate::spatial::deform::store::Masses::Lumped => part.mesh.lumped(),
            crate::spatial::deform::store::Masses::Inertia => part.mesh.inertial(),
        };
        let masses: Vec<f64> = shares.into_iter().map(|v| density * v).collect();
        let body = &deform.bodies[deform.slot[child as usize] as usize];
        all.extend(moving(deform, body, &masses));
    }
    all
}

/// Tetrahedra (number, weights of its nodes) that hold a point in the coordinates of the mesh; several where it lies between
/// them, the nearest where it lies outside by round-off.
pub(super) fn holders(mesh: &Tetrahedra, at: Vec3) -> Vec<(usize, [f64; 4])> {
    let mut inside = Vec::new();
    let mut nearest = (0, [0.0; 4], f64::NEG_INFINITY);
    for (tet, (nodes, g)) in mesh.tets.iter().zip(&mesh.gradients).enumerate() {
        let r = at - mesh.nodes[nodes[0] as usize];
        let n = g.map(|g| g.dot(r));
        let weights = [1.0 - n[0] - n[1] - n[2], n[0], n[1], n[2]];
        let least = weights.iter().copied().fold(f64::INFINITY, f64::min);
        if least >= INSIDE {
            inside.push((tet, weights));
        }
        if least > nearest.2 {
            nearest = (tet, weights, least);
        }
    }
    if inside.is_empty() {
        inside.push((nearest.0, nearest.1));
    }
    inside
}

/// Value of a field with the values `of` at the nodes of a mesh.
fn value(mesh: &Tetrahedra, at: Vec3, of: &[[f64; 3]]) -> Vec3 {
    let (tet, weights) = holders(mesh, at)[0];
    let nodes = mesh.tets[tet].iter().zip(weights);
    nodes
        .map(|(n, w)| w * Vec3::from_array(of[*n as usize]))
        .sum()
}

/// Gives the nodes of all parts their motion.
pub(super) fn motion(
    world: &World,
    deform: &mut Deform,
    work: &Workspace,
    families: &[Family],
    before: &[Sums],
) {
    for (family, before) in families.iter().zip(before) {
        let parent = deform.bodies[family.slot as usize];
        let mesh = &work.kind(&parent).mesh;
        for (part, child) in family.cut.parts.iter().zip(family.children()) {
            let first = deform.bodies[deform.slot[child as usize] as usize].first as usize;
            for (k, node) in part.mesh.nodes.iter().enumerate() {
                let moved = value(mesh, *node, &deform.nodes.moved[parent.nodes()]);
                let rate = value(mesh, *node, &deform.nodes.rate[parent.nodes()]);
                deform.nodes.moved[first + k] = moved.to_array();
                deform.nodes.rate[first + k] = rate.to_array();
            }
        }
        limit_strain(deform, work, family);
        if before.kinetic > 0.0 {
            keep_momenta(world, deform, family, before);
        }
    }
}

/// Where interpolation would raise the strain energy, scales the displacements beyond the mean gradient of the parent down so
/// that it stays. (The energy of the mean alone is never above that of the parent, so there is such a scale.) Bonds keep their stretch
/// whatever the displacements are. Blocks with held nodes are left as they are.
fn limit_strain(deform: &mut Deform, work: &Workspace, family: &Family) {
    let parent = deform.bodies[family.slot as usize];
    let held = |n: usize| {
        let found = deform.holds.binary_search_by_key(&(n as u32), |h| h.node);
        found.is_ok()
    };
    if parent.nodes().any(held) {
        return;
    }
    let kind = work.kind(&parent);
    let before = deform.strain_energy(work, &parent);
    let (_, gradient) = deform.average(work, &parent);
    let whole: f64 = kind.lumped.iter().sum();
    let nodes = parent.nodes().zip(&kind.lumped);
    let mean = nodes
        .map(|(n, m)| m / whole * Vec3::from_array(deform.nodes.moved[n]))
        .sum::<Vec3>();
    let affine =
        |at: Vec3| mean + Vec3::from_array(gradient.map(|row| Vec3::from_array(row).dot(at)));
    let start = StartStress::default();
    let parts: Vec<(Groups, Vec<Vec3>, Vec<Vec3>)> = family
        .cut
        .parts
        .iter()
        .zip(family.children())
        .map(|(part, child)| {
            let body = &deform.bodies[deform.slot[child as usize] as usize];
            let base: Vec<Vec3> = part.mesh.nodes.iter().map(|at| affine(*at)).collect();
            let own = deform.nodes.moved[body.nodes()].iter();
            let rest = own.zip(&base).map(|(u, b)| Vec3::from_array(*u) - *b);
            let rest = rest.collect();
            (Groups::new(&part.mesh), base, rest)
        })
        .collect();
    let scaled = |(_, base, rest): &(Groups, Vec<Vec3>, Vec<Vec3>), s: f64| -> Vec<[f64; 3]> {
        let pairs = base.iter().zip(rest);
        pairs.map(|(b, r)| (*b + s * *r).to_array()).collect()
    };
    let energy = |s: f64| -> f64 {
        let of = |part: &(Groups, Vec<Vec3>, Vec<Vec3>)| {
            let u = scaled(part, s);
            part.0.energy(&kind.law, parent.strain, &start, &u)
        };
        parts.iter().map(of).sum()
    };
    if energy(1.0) <= before {
        return;
    }
    let (mut low, mut high) = (0.0, 1.0);
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if energy(middle) <= before {
            low = middle;
        } else {
            high = middle;
        }
    }
    for (part, child) in parts.iter().zip(family.children()) {
        let body = deform.bodies[deform.slot[child as usize] as usize];
        deform.nodes.moved[body.nodes()].copy_from_slice(&scaled(part, low));
    }
}

/// Adds the rigid motion that the momenta lack and takes off what kinetic energy is too much.
fn keep_momenta(world: &World, deform: &mut Deform, family: &Family, before: &Sums) {
    let nodes = parts(world, deform, family);
    let after = Sums::of(&nodes, before.centre);
    let mut inertia = Mat3::ZERO;
    let mut first = Vec3::ZERO;
    for &(m, at, _) in &nodes {
        let r = at - before.centre;
        let dyad = Mat3::from_cols(r.x * r, r.y * r, r.z * r);
        inertia += m * (r.length_squared() * Mat3::IDENTITY - dyad);
        first += m * r;
    }
    // About the centre of mass of the parts, which is that of the parent up to what interpolation has moved.
    let offset = first / after.mass;
    let dyad = Mat3::from_cols(offset.x * offset, offset.y * offset, offset.z * offset);
    inertia -= after.mass * (offset.length_squared() * Mat3::IDENTITY - dyad);
    let about = |s: &Sums| s.spin - offset.cross(s.momentum);
    let inverse = inertia.inverse();
    let velocity = before.momentum / after.mass;
    let turn = inverse * about(before);
    let (slide, whirl) = (after.momentum / after.mass, inverse * about(&after));
    let centre = before.centre + offset;
    let own: Vec<Vec3> = nodes
        .iter()
        .map(|(_, at, v)| *v - slide - whirl.cross(*at - centre))
        .collect();
    let rigid = 0.5 * (after.mass * velocity.length_squared() + turn.dot(inertia * turn));
    let rest: f64 = nodes
        .iter()
        .zip(&own)
        .map(|(n, v)| 0.5 * n.0 * v.length_squared())
        .sum();
    let spare = (before.kinetic - rigid).max(0.0);
    let scale = if rest > spare {
        (spare / rest).sqrt()
    } else {
        1.0
    };
    let mut k = 0;
    for child in family.children() {
        let body = deform.bodies[deform.slot[child as usize] as usize];
        for node in body.nodes() {
            let v = velocity + turn.cross(nodes[k].1 - centre) + scale * own[k];
            deform.nodes.rate[node] = v.to_array();
            k += 1;
        }
    }
}
