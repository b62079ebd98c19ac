//! Standing water: its push on blocks, and its pressure at interfaces ([`crate::laws::water`]).
//!
//! The push is given by the present place of a block alone and is a given force: the kick books its work as that of loads.

use crate::setup::rotation::rotation;
use riprap_geom::Vec3;
use riprap_geom::polyhedron::BRICK_FACES;

use crate::push::seepage;
use crate::setup::{Shape, WaterTable};
use crate::state::deform::{Body, Deform};
use crate::state::scratch::Scratch;
use crate::state::workspace::{BlockClass, Workspace};
use crate::state::world::World;

impl World {
    /// The water table that stands now.
    #[must_use]
    pub fn table(&self) -> Option<&WaterTable> {
        self.setup.water.get(usize::from(self.water?))
    }

    /// Pressure of the water at a place (local, m), Pa; 0 above the table and without one.
    #[must_use]
    pub fn pore_pressure(&self, at: Vec3) -> f64 {
        let table = self.table();
        table.map_or(0.0, |table| table.pressure(-self.gravity.z, at))
    }
}

/// Pushes all blocks with the water.
pub(crate) fn apply(world: &World, scratch: &mut Scratch) {
    let Some(table) = world.table() else {
        return;
    };
    scratch.pushes.wet = true;
    let loads = &mut scratch.pushes.loads;
    loads.need_blocks(world.alive.len());
    scratch.exec.chunks(&mut loads.blocks, |first, list| {
        for (k, wrench) in list.iter_mut().enumerate() {
            let b = first + k;
            if world.alive[b] && !world.is_terrain(b) && !world.deforms(b) {
                let (force, moment) = on_block_of(world, table, b);
                wrench.force += force;
                wrench.moment += moment;
            }
        }
    });
    if let (Some(deform), Some(work)) = (world.deform.as_deref(), scratch.deform.as_deref()) {
        loads.need_nodes(deform.nodes.len());
        for body in deform.living() {
            let push = |node, force| loads.on_node(node, force);
            on_nodes(table, -world.gravity.z, deform, body, work.class(body), push);
        }
    }
}

/// Force (N) on a block; nothing without a table.
#[must_use]
pub(crate) fn on_block(world: &World, work: Option<&Workspace>, b: usize) -> Vec3 {
    let Some(table) = world.table().filter(|_| !world.is_terrain(b)) else {
        return Vec3::ZERO;
    };
    let with_nodes = world.deform.as_deref().zip(work);
    let nodal = with_nodes.and_then(|(deform, work)| Some((deform, deform.body(b)?, work)));
    match nodal {
        None => on_block_of(world, table, b).0,
        Some((deform, body, work)) => {
            let mut force = Vec3::ZERO;
            on_nodes(table, -world.gravity.z, deform, body, work.class(body), |_, push| {
                force += push;
            });
            force
        }
    }
}

/// Force (N) and moment about the centroid (N m) on a rigid block.
fn on_block_of(world: &World, table: &WaterTable, b: usize) -> (Vec3, Vec3) {
    if table.seepage.is_some() {
        seepage::on_block(world, table, b)
    } else {
        on_rigid(world, table, b)
    }
}

/// The same of water that stands.
pub(crate) fn on_rigid(world: &World, table: &WaterTable, b: usize) -> (Vec3, Vec3) {
    let solid = world.solid_of(b);
    let start = world.reference[b];
    let turn = || match &world.turned[b] {
        Some(turned) => turned.attitude,
        None => rotation(world.bodies.rotation(b)),
    };
    let centre = start + world.bodies.displacement(b);
    table.on_polyhedron(
        -world.gravity.z,
        centre,
        solid.radius,
        solid.volume,
        |each| {
            let attitude = turn();
            let solids = match &world.setup.blocks[b].shape {
                Shape::Brick { half, .. } => {
                    let sign = |k: u8, bit: u8| if k & bit == 0 { -1.0 } else { 1.0 };
                    for face in BRICK_FACES {
                        let corner = |k: u8| Vec3::new(sign(k, 1), sign(k, 2), sign(k, 4)) * *half;
                        each(&face.map(|k| attitude * corner(k)));
                    }
                    return;
                }
                Shape::Polyhedron(body) => std::slice::from_ref(&**body),
                // What acts on glued faces cancels.
                Shape::Glued(parts) => &parts[..],
                Shape::Terrain(_) => return,
            };
            for solid in solids {
                for face in &solid.faces {
                    let corner = |k: &u32| attitude * (solid.vertices[*k as usize] - start);
                    let corners: Vec<Vec3> = face.iter().map(corner).collect();
                    each(&corners);
                }
            }
        },
        &|r| start + turn().inverse() * r,
    )
}

/// Calls `push(node, force)` with the push on the nodes of a deformable block, by the triangles of its faces where they are now.
fn on_nodes(
    table: &WaterTable,
    gravity: f64,
    deform: &Deform,
    body: &Body,
    kind: &BlockClass,
    mut push: impl FnMut(u32, Vec3),
) {
    let nodes = &deform.nodes;
    let start = |node: u32| nodes.place[node as usize];
    let place = |node: u32| start(node) + Vec3::from_array(nodes.displacement[node as usize]);
    for face in 0..kind.faces.len() {
        for triangle in kind.mesh.fan(face) {
            let corners = triangle.map(|k| body.first + k);
            let pushes = table.on_triangle(gravity, corners.map(place), corners.map(start));
            for (node, force) in corners.into_iter().zip(pushes) {
                push(node, force);
            }
        }
    }
}
