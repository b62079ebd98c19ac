//! Walls of cavities: faces of rigid blocks, and nodes of deformable ones with their shares of the area.
//!
//! Both are points with an anchor, an area A and an outward normal n, into the cavity. `V = V0 - f sum A n.u` and a force `-P f A n` on each, so that
//! the work is `P dV`. In-situ tractions that the charge carried are given forces, as moments too on rigid blocks.
//!
//! A wall of a block with finite rotations turns with it: the push stays normal to the face and at its centre, and the volume follows from
//! `dV = -A n.dx` along its way, with the mean of `A n` before and after a step. A face that has turned by more than `TURNING` from its start
//! is less and less of a wall, by the cosine, and none from a right angle on: it no longer looks into the cavity. (No wall becomes of the
//! other faces of a block that turns so far.)

use riprap_geom::Vec3;

use crate::state::anchor::{Anchor, Freedoms};
use crate::state::cavity::{Cavity, NodalWalls, TurnedWall, Wall};
use crate::state::deform::{Acts, Deform, Surface};
use crate::state::workspace::Workspace;
use crate::state::world::World;

/// Cosine of the angle by which a face may turn from its start and still is a whole wall: 60 degrees.
const TURNING: f64 = 0.5;

/// A point of the walls.
#[derive(Clone, Copy, Debug)]
pub struct Spot {
    /// The point.
    pub anchor: Anchor,
    /// Its share of the area, m².
    pub area: f64,
    /// Unit outward normal of the block, into the cavity; that of the start where rotations are small.
    pub normal: Vec3,
}

/// Walls on rigid blocks that the gas has reached, each with the time from the ignition until then (s).
pub fn on_blocks(cavity: &Cavity) -> impl Iterator<Item = (Spot, f64)> + '_ {
    cavity.walls.iter().filter(|wall| cavity.reached(wall)).map(|wall| {
        let (normal, area) = wall.now();
        (Spot { anchor: centre(wall), area, normal }, wall.after)
    })
}

/// The centre of a wall.
fn centre(wall: &Wall) -> Anchor {
    Anchor::Block { block: wall.block, arm: wall.arm }
}

/// Takes the walls of blocks with finite rotations of cavity `k` along to where they are now.
///
/// Calling it again without moving changes nothing.
pub(crate) fn follow(world: &mut World, k: usize) {
    if world.turned.iter().all(Option::is_none) {
        return;
    }
    let World { cavities, bodies, turned, deform, .. } = world;
    let freedoms = Freedoms::new(bodies, turned, deform.as_deref().map(|d| &d.nodes));
    for wall in &mut cavities[k].walls {
        let Some(block) = &turned[wall.block as usize] else {
            continue;
        };
        let displacement = freedoms.displacement(&centre(wall));
        let normal = block.attitude * wall.normal;
        let share = (normal.dot(wall.normal) / TURNING).clamp(0.0, 1.0);
        let area = share * wall.area;
        // A volume that follows from a turning normal depends on the way, so it is summed up;
        // as long as nothing has turned it follows from where the wall is.
        let swept = match &wall.turned {
            Some(before) => {
                let mean = 0.5 * (before.area * before.normal + area * normal);
                before.swept - mean.dot(displacement - before.displacement)
            }
            None => swept_by(wall, &freedoms),
        };
        wall.turned = Some(TurnedWall { normal, area, displacement, swept });
    }
}

/// Makes `wall` a part of that of the block it comes from: normal and share of the area go on, and the parts of a wall have swept together
/// what the whole has.
pub(crate) fn divide(world: &World, wall: &mut Wall, whole: &Wall) {
    // Its own centre has moved by something else than that of the whole.
    let share = wall.area / whole.area;
    let displacement = world.all_freedoms().displacement(&centre(wall));
    wall.turned = whole.turned.map(|turned| TurnedWall {
        area: share * turned.area,
        swept: share * turned.swept,
        displacement,
        ..turned
    });
}

/// Volume that a wall has swept since the start, m³.
fn swept_by(wall: &Wall, freedoms: &Freedoms) -> f64 {
    match &wall.turned {
        Some(turned) => turned.swept,
        None => wall.area * -wall.normal.dot(freedoms.displacement(&centre(wall))),
    }
}

/// Walls of a source on deformable blocks.
pub fn on_nodes(world: &World, source: u16) -> impl Iterator<Item = Spot> + '_ {
    let deform = world.deform.as_deref().into_iter();
    deform.flat_map(move |d| surfaces(d, source)).flat_map(|s| {
        let spot = |&(node, area): &(u32, f64)| Spot {
            anchor: Anchor::node(node),
            area,
            normal: s.normal,
        };
        s.nodes.iter().map(spot)
    })
}

fn surfaces(deform: &Deform, source: u16) -> impl Iterator<Item = &Surface> {
    let own = move |s: &&Surface| s.acts == Acts::Cavity(source);
    deform.surfaces.iter().filter(own)
}

/// Volume that the walls of a cavity have swept since the start, m³.
#[must_use]
pub fn swept(world: &World, cavity: &Cavity) -> f64 {
    let freedoms = world.all_freedoms();
    let reached = cavity.walls.iter().filter(|wall| cavity.reached(wall));
    let on_blocks = reached.map(|wall| swept_by(wall, &freedoms));
    on_blocks.sum::<f64>() + volume(world, on_nodes(world, cavity.source))
}

fn volume(world: &World, walls: impl Iterator<Item = Spot>) -> f64 {
    let freedoms = world.all_freedoms();
    let share = |w: Spot| w.area * -w.normal.dot(freedoms.displacement(&w.anchor));
    walls.map(share).sum()
}

/// Volume that the walls of dead rigid blocks have swept, m³.
#[must_use]
pub fn lost(world: &World, cavity: &Cavity) -> f64 {
    let freedoms = world.all_freedoms();
    let dead = |w: &&Wall| !world.alive[w.block as usize] && cavity.reached(w);
    let dead = cavity.walls.iter().filter(dead);
    dead.map(|wall| swept_by(wall, &freedoms)).sum()
}

/// Tractions (Pa) of the stress at the start on the nodes of the walls of a source: node, area (m²), traction.
fn tractions(world: &World, source: u16) -> impl Iterator<Item = (u32, f64, Vec3)> + '_ {
    let both = world.deform.as_deref().zip(world.setup.in_situ.as_ref());
    both.into_iter().flat_map(move |(deform, in_situ)| {
        surfaces(deform, source).flat_map(move |wall| {
            let nodes = wall.nodes.iter().zip(&wall.heights);
            nodes.map(move |(&(node, area), z)| (node, area, in_situ.at(*z) * wall.normal))
        })
    })
}

/// Forces (N) of the stress at the start on the nodes of the walls of a cavity.
pub fn held_nodes<'a>(
    world: &'a World,
    cavity: &Cavity,
) -> impl Iterator<Item = (u32, Vec3)> + use<'a> {
    tractions(world, cavity.source).map(|(node, area, t)| (node, area * t))
}

/// Work of the stress at the start on the walls of a cavity that the gas has not reached, since then, J.
#[must_use]
pub fn held(world: &World, cavity: &Cavity) -> f64 {
    let on_blocks = cavity.walls.iter().filter(|w| cavity.holds(w)).map(|w| {
        let b = w.block as usize;
        w.hold.dot(world.bodies.displacement(b)) + w.hold_moment.dot(world.bodies.rotation(b))
    });
    on_blocks.sum::<f64>() + held_by_nodes(world, cavity.source)
}

fn held_by_nodes(world: &World, source: u16) -> f64 {
    let freedoms = world.all_freedoms();
    let work = |(node, area, t): (u32, f64, Vec3)| {
        area * t.dot(freedoms.displacement(&Anchor::node(node)))
    };
    tractions(world, source).map(work).sum()
}

impl NodalWalls {
    /// Those of a source.
    #[must_use]
    pub fn of(world: &World, source: u16) -> Self {
        let Some(deform) = world.deform.as_deref() else {
            return Self::default();
        };
        if surfaces(deform, source).next().is_none() {
            return Self::default();
        }
        let work = Workspace::new(&world.setup, deform);
        let (mut area, mut mobility) = (0.0, 0.0);
        for wall in surfaces(deform, source) {
            let body = &deform.bodies[wall.body as usize];
            let spec = &world.setup.blocks[body.block as usize];
            let density = world.setup.materials[usize::from(spec.material)].density;
            // Those of a dynamic phase, whatever phase this is.
            let volumes = work.class(body).mesh.inertial();
            for &(node, share) in &wall.nodes {
                area += share;
                let mass = density * volumes[(node - body.first) as usize];
                mobility += share * share / mass;
            }
        }
        Self {
            area,
            mobility,
            swept: volume(world, on_nodes(world, source)),
            held: held_by_nodes(world, source),
        }
    }
}

/// Swept volume (m³) and in-situ work (J) of the nodal walls of all cavities: what [`renew`] must know of before.
#[must_use]
pub fn state(world: &World) -> Vec<[f64; 2]> {
    let of = |k: u16| [volume(world, on_nodes(world, k)), held_by_nodes(world, k)];
    world.cavities.iter().map(|c| of(c.source)).collect()
}

/// Looks at the walls of all cavities on deformable blocks anew, after blocks were cut or taken out: volume and
/// work go on from where they were.
pub fn renew(world: &mut World, before: &[[f64; 2]]) {
    for (k, [volume, work]) in before.iter().enumerate() {
        if world.cavities[k].nodal.area == 0.0 {
            continue;
        }
        let walls = NodalWalls::of(world, world.cavities[k].source);
        let cavity = &mut world.cavities[k];
        cavity.nodal = walls;
        if cavity.ignited.is_some() {
            cavity.base += walls.swept - volume;
        } else {
            cavity.held += walls.held - work;
        }
    }
}
