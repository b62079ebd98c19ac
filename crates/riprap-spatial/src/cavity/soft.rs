//! Walls on deformable blocks: nodes with their shares of the area.
//!
//! `V = V0 + f sum A_i n.u_i` over the nodes and a force `P f A_i n` on each, so that the work is again `P dV`.

use riprap_geom::Vec3;

use crate::deform::Workspace;
use crate::deform::store::{Acts, Deform, Surface};
use crate::state::cavity::Soft;
use crate::state::push::Account;
use crate::world::World;

impl Soft {
    /// Those of a source.
    #[must_use]
    pub fn of(world: &World, source: usize) -> Self {
        let Some(deform) = world.deform.as_deref() else {
            return Self::default();
        };
        let walls = || surfaces(deform, source as u16);
        if walls().next().is_none() {
            return Self::default();
        }
        let work = Workspace::new(&world.setup, deform);
        let (mut area, mut mobility) = (0.0, 0.0);
        for wall in walls() {
            let body = &deform.bodies[wall.body as usize];
            let spec = &world.setup.blocks[body.block as usize];
            let density = world.setup.materials[usize::from(spec.material)].density;
            // Those of a dynamic phase, whatever phase this is.
            let volumes = work.kind(body).mesh.inertial();
            for &(node, share) in &wall.nodes {
                area += share;
                let mass = density * volumes[(node - body.first) as usize];
                mobility += share * share / mass;
            }
        }
        Self {
            area,
            mobility,
            swept: swept(world, source as u16),
            held: held(world, source as u16),
        }
    }
}

/// Looks at the walls of all cavities on deformable blocks anew, after blocks were cut or taken out: volume and
/// work go on from where they were.
pub fn renew(world: &mut World, before: &[[f64; 2]]) {
    let mut cavities = std::mem::take(&mut world.cavities);
    for (cavity, [volume, work]) in cavities.iter_mut().zip(before) {
        if cavity.soft.area == 0.0 {
            continue;
        }
        cavity.soft = Soft::of(world, usize::from(cavity.source));
        if cavity.ignited.is_some() {
            cavity.base += cavity.soft.swept - volume;
        } else {
            cavity.held += cavity.soft.held - work;
        }
    }
    world.cavities = cavities;
}

/// Displacement of the centroid of a block, rigid or not, m.
pub(super) fn displacement(world: &World, b: usize) -> Vec3 {
    let soft = world.deform.as_deref().and_then(|d| Some((d, d.body(b)?)));
    match soft {
        // The last node is the centroid.
        Some((deform, body)) => Vec3::from_array(deform.nodes.moved[body.nodes().end - 1]),
        None => world.bodies.displacement(b),
    }
}

/// Swept volume (m³) and in-situ work (J) of the walls of all cavities: what [`renew`] must know of before.
#[must_use]
pub fn state(world: &World) -> Vec<[f64; 2]> {
    let of = |k: u16| [swept(world, k), held(world, k)];
    world.cavities.iter().map(|c| of(c.source)).collect()
}

fn surfaces(deform: &Deform, source: u16) -> impl Iterator<Item = &Surface> {
    let own = move |s: &&Surface| s.acts == Acts::Cavity(source);
    deform.surfaces.iter().filter(own)
}

/// Sum over the nodes of the walls of a source.
fn sum(world: &World, source: u16, get: impl Fn(&Surface, usize, Vec3) -> f64) -> f64 {
    let Some(deform) = world.deform.as_deref() else {
        return 0.0;
    };
    let mut sum = 0.0;
    for wall in surfaces(deform, source) {
        for (k, (node, area)) in wall.nodes.iter().enumerate() {
            let moved = Vec3::from_array(deform.nodes.moved[*node as usize]);
            sum += area * get(wall, k, moved);
        }
    }
    sum
}

/// Volume that the walls have swept since the start, m³.
pub(super) fn swept(world: &World, source: u16) -> f64 {
    sum(world, source, |wall, _, u| -wall.normal.dot(u))
}

/// Work of the in-situ tractions since the start, J.
pub(super) fn held(world: &World, source: u16) -> f64 {
    let Some(in_situ) = &world.setup.in_situ else {
        return 0.0;
    };
    let work = |wall: &Surface, k: usize, u| (in_situ.at(wall.heights[k]) * wall.normal).dot(u);
    sum(world, source, work)
}

/// Pushes the nodes with a pressure, Pa.
pub(super) fn push(world: &World, source: u16, pressure: f64, pushes: &mut Account) {
    let Some(deform) = world.deform.as_deref() else {
        return;
    };
    for wall in surfaces(deform, source) {
        for &(node, area) in &wall.nodes {
            pushes.on_node(node, -pressure * area * wall.normal);
        }
    }
}

/// Holds the nodes with the in-situ stress that the charge carried.
pub(super) fn hold(world: &World, source: u16, pushes: &mut Account) {
    let (Some(deform), Some(in_situ)) = (world.deform.as_deref(), &world.setup.in_situ) else {
        return;
    };
    for wall in surfaces(deform, source) {
        for (k, &(node, area)) in wall.nodes.iter().enumerate() {
            let traction = in_situ.at(wall.heights[k]) * wall.normal;
            pushes.on_node(node, area * traction);
        }
    }
}
