//! Terrain in a step: what it does to each block that can be moved.
//!
//! Every such block has a state of its own, [`OnTerrain`]: how far it can go before it can touch, and its springs on each facet. Terrain
//! needs no candidate list; a block looks at the triangles near it when it has gone far enough.

use riprap_core::sums::{GROUP, tree};
use riprap_geom::Vec3;

use crate::contact::constants::{inverse_mass, law};
use crate::contact::{make_shapes, pose};
use crate::kernel::frame::Frame;
use crate::kernel::glued::Glued;
use crate::kernel::piece::Polygon;
use crate::kernel::{
    Body, ContactInput, ContactLaw, Motion, Pieces, Reached, Shape, Sums, Terrain, Wrench, respond,
    turn,
};
use crate::laws::damping::stable_share;
use crate::setup;
use crate::state::bodies::{Bodies, Turned};
use crate::state::contact_scratch::{Acting, ContactScratch, TerrainWorkspace};
use crate::state::event::EditKind;
use crate::state::found::{FacetContact, OnTerrain};
use crate::state::scratch::Scratch;
use crate::state::world::World;

/// How far a block looks for terrain, over its radius.
const REACH: f64 = 1.0;
/// Share of the stable step: the stiffness grows with the area. In the square not much more than half of that of pairs (0.56), since a block may lie
/// on terrain and on others at once and both limits are found apart.
const SAFETY: f64 = 0.15;
/// The same of the step that is stable with strong dashpots.
const DAMPED: f64 = 0.375;
/// Share of the time until a block can touch that a step may take.
const APPROACH: f64 = 0.25;

impl World {
    /// Whether there is terrain that blocks can meet.
    #[must_use]
    pub fn has_terrain(&self) -> bool {
        !self.found.terrain.is_empty()
    }

    /// Whether terrain acts on block `b`.
    pub(crate) fn meets_terrain(&self, b: usize) -> bool {
        self.alive[b] && self.is_free(b) && !self.deforms(b) && !self.is_terrain(b)
    }
}

/// Finds what terrain does to all blocks.
pub(crate) fn act(world: &mut World, scratch: &mut Scratch) {
    let n = world.alive.len();
    let ContactScratch { shapes, glued, terrain: desk, .. } = &mut scratch.desk;
    world.found.terrain.resize_with(n, OnTerrain::default);
    desk.exerted.resize(n, Acting::default());
    desk.workspaces.resize_with(scratch.exec.workspaces(n), TerrainWorkspace::default);
    for workspace in &mut desk.workspaces {
        workspace.left.clear();
    }
    desk.sums.clear();
    desk.sums.resize(n.div_ceil(GROUP), 0.0);
    let evaluation = Evaluation {
        bodies: &world.bodies,
        turned: &world.turned,
        reference: &world.reference,
        solid: &world.solid,
        shapes,
        glued,
        grounds: &desk.grounds,
        laws: &desk.laws,
        inverse_masses: &desk.inverse_masses,
        dt: world.pending,
        last_dt: world.last_dt,
    };
    let width = scratch.width;
    scratch.exec.groups2(
        &mut world.found.terrain,
        &mut desk.exerted,
        &mut desk.sums,
        &mut desk.workspaces,
        |first, states, exerted, friction, workspace| {
            workspace.friction = 0.0;
            workspace.under.limit_width(width);
            for (k, (state, exerted)) in states.iter_mut().zip(exerted).enumerate() {
                evaluation.block(first + k, state, exerted, workspace);
            }
            *friction = workspace.friction;
        },
    );
    tree(&mut desk.sums, |sum, other| *sum += other);
    world.works.friction += desk.sums.first().copied().unwrap_or(0.0);
    let mut left: Vec<u32> = desk.workspaces.iter().flat_map(|of| of.left.clone()).collect();
    // Which thread has seen which of them is chance.
    left.sort_unstable();
    for b in left {
        let event = world.event(EditKind::LeftTerrain, b);
        world.events.push(event);
    }
    let limit = longest_step(world, &scratch.desk);
    world.found.longest_step = world.found.longest_step.map(|step| step.min(limit));
}

/// Lays out what evaluation works with, after an edit or a change of laws anew. Comes before the sums of dashpots are laid out.
pub(crate) fn prepare(world: &mut World, scratch: &mut Scratch) {
    let n = world.alive.len();
    if !world.has_terrain() {
        return;
    }
    make_shapes(world, &mut scratch.desk);
    if !world.fresh && scratch.desk.terrain.laws.len() == n {
        return;
    }
    let inradii: Vec<f64> = (0..n).map(|b| scratch.desk.inradius(world.solid[b])).collect();
    let desk = &mut scratch.desk.terrain;
    let there = |b: &usize| world.alive[*b] && world.is_terrain(*b);
    let blocks: Vec<u32> = (0..n).filter(there).map(|b| b as u32).collect();
    if blocks != desk.blocks {
        desk.grounds = blocks.iter().map(|b| ground(world, *b)).collect();
        desk.blocks = blocks;
    }
    desk.laws.clear();
    desk.inverse_masses.clear();
    desk.inverse_masses.extend((0..n).map(|b| inverse_mass(world, b)));
    desk.damped = false;
    for (b, inradius) in inradii.into_iter().enumerate() {
        let laws = desk.blocks.iter().map(|&terrain| {
            // Behind terrain there is no centroid: it counts as deep as the block.
            law(&world.setup, [terrain, b as u32], [inradius; 2])
        });
        let laws: Vec<ContactLaw> =
            if world.meets_terrain(b) { laws.collect() } else { Vec::new() };
        desk.damped |= laws.iter().any(|law| law.damping_ratio > 0.0);
        desk.laws.push(laws);
    }
    if world.fresh {
        world.found.terrain.resize_with(n, OnTerrain::default);
        for state in &mut world.found.terrain {
            state.clear = 0.0;
        }
    }
    scratch.tiles.make_rows(world);
}

/// The surface of a terrain block, ready for contact.
fn ground(world: &World, b: u32) -> Terrain {
    match &world.setup.blocks[b as usize].shape {
        setup::Shape::Terrain(surface) => Terrain::new(surface.field()),
        setup::Shape::Brick { .. } | setup::Shape::Polyhedron(_) | setup::Shape::Glued(_) => {
            Terrain::default()
        }
    }
}

struct Evaluation<'a> {
    bodies: &'a Bodies,
    turned: &'a [Option<Box<Turned>>],
    reference: &'a [Vec3],
    /// Index into `shapes`, per block.
    solid: &'a [u32],
    shapes: &'a [Shape],
    /// As `shapes`; empty where no block has parts.
    glued: &'a [Glued],
    grounds: &'a [Terrain],
    /// The law of each block on each of the grounds; none for blocks that do not meet terrain.
    laws: &'a [Vec<ContactLaw>],
    /// 1/kg.
    inverse_masses: &'a [f64],
    dt: f64,
    /// Length of the last step, s.
    last_dt: f64,
}

impl Evaluation<'_> {
    fn block(
        &self,
        b: usize,
        state: &mut OnTerrain,
        exerted: &mut Acting,
        workspace: &mut TerrainWorkspace,
    ) {
        *exerted = Acting::default();
        if self.laws[b].is_empty() {
            for facet in std::mem::take(&mut state.facets) {
                workspace.friction += facet.stored;
            }
            return;
        }
        let shape = &self.shapes[self.solid[b] as usize];
        let motion = Motion {
            velocity: self.bodies.velocity(b),
            spin: self.bodies.spin(b),
            inverse_mass: self.inverse_masses[b],
        };
        let way = motion.velocity.length() + motion.spin.length() * shape.radius;
        state.clear -= way * self.dt;
        if state.clear > 0.0 && state.facets.is_empty() {
            return;
        }
        let pose = pose(self.bodies, self.turned, self.reference, b);
        workspace.normals.clear();
        let turn = turn(shape, pose.rotation, &mut workspace.normals);
        workspace.old.clear();
        workspace.old.append(&mut state.facets);
        let glued = self.glued.get(self.solid[b] as usize);
        let glued = glued.filter(|glued| !glued.is_convex());
        let mut clear = f64::INFINITY;
        for (k, terrain) in self.grounds.iter().enumerate() {
            let body = Body { shape, normals: &workspace.normals, turn, position: pose.position };
            let reached = match glued {
                Some(glued) => workspace.under.find_glued(terrain, glued, &pose, REACH),
                None => workspace.under.find(terrain, &body, REACH),
            };
            match reached {
                Reached::Apart(gap) => clear = clear.min(gap),
                Reached::FullyPenetrated(_) => {
                    // No force can be given: not a number stops the run with the name of the block.
                    exerted.elastic.force = Vec3::NAN;
                    clear = 0.0;
                }
                Reached::Touching => {
                    clear = 0.0;
                    let law = &self.laws[b][k];
                    let here = Here {
                        terrain: k,
                        law,
                        radius: shape.radius,
                        motion,
                        position: pose.position,
                        dt: self.dt,
                        last_dt: self.last_dt,
                    };
                    here.facets(state, exerted, workspace);
                }
            }
        }
        state.clear = clear;
        let beside = |terrain: &Terrain| terrain.depth(pose.position).is_none();
        if !state.left && self.grounds.iter().all(beside) {
            state.left = true;
            workspace.left.push(b as u32);
        }
        // What is left has parted.
        let still = Motion::default();
        for gone in workspace.old.drain(..) {
            workspace.friction += gone.memory.work(&[still, motion], self.dt) + gone.stored;
        }
    }
}

/// A block on terrain at this instant.
struct Here<'a> {
    /// Number of the terrain.
    terrain: usize,
    law: &'a ContactLaw,
    /// Of the block, m.
    radius: f64,
    motion: Motion,
    /// Its centroid, m.
    position: Vec3,
    dt: f64,
    /// Length of the last step, s.
    last_dt: f64,
}

impl Here<'_> {
    fn facets(
        &self,
        state: &mut OnTerrain,
        exerted: &mut Acting,
        workspace: &mut TerrainWorkspace,
    ) {
        let areas = workspace.under.facets.iter();
        let whole: f64 = areas.map(|on| on.sums.vector_area.length()).sum();
        let none = |_: &mut dyn FnMut(&Polygon, &Frame)| ();
        if let Some(on) = workspace.under.facets.first() {
            let asked = self.question(&on.sums, &none);
            workspace.ridges.find(self.law, &asked, &workspace.under.facets);
        }
        for (k, on) in workspace.under.facets.iter().enumerate() {
            let key = FacetContact::key(self.terrain, on.piece, on.facet);
            let old = workspace.old.iter().position(|f| f.key == key);
            let mut contact = old.map_or_else(
                || FacetContact { key, ..FacetContact::default() },
                |k| workspace.old.remove(k),
            );
            let law = self.law.part(on.sums.vector_area.length() / whole);
            let pieces = |show: &mut dyn FnMut(&Polygon, &Frame)| workspace.under.rubbing(on, show);
            let question = ContactInput {
                shared: workspace.ridges.shared(k),
                ..self.question(&on.sums, &pieces)
            };
            let reply = respond(&law, &question, &mut contact.memory, &mut None);
            workspace.friction += reply.friction;
            contact.stored = contact.memory.stored(law.shear_stiffness);
            contact.force = reply.wrench.force;
            contact.depth = on.sums.depth;
            contact.area = reply.area;
            add(exerted, &reply.elastic, &reply.spring, &reply.drag);
            state.facets.push(contact);
        }
        for rocking in workspace.ridges.rocking() {
            exerted.drag.add(rocking, true);
        }
    }

    fn question<'q>(&self, sums: &'q Sums, pieces: &'q Pieces<'q>) -> ContactInput<'q> {
        ContactInput {
            sums,
            pieces,
            origin: self.position,
            centres: [self.position; 2],
            motion: [Motion::default(), self.motion],
            radius: self.radius,
            dt: self.dt,
            last_dt: self.last_dt,
            shared: None,
            falls: 0.0,
        }
    }
}

fn add(exerted: &mut Acting, elastic: &Wrench, spring: &Wrench, drag: &Wrench) {
    exerted.elastic.add(elastic, true);
    exerted.spring.add(spring, true);
    exerted.drag.add(drag, true);
}

/// Share of the undamped stable step on ground with this law: dashpots shorten it where it would come too near to what is stable with them.
pub(crate) fn share(law: &ContactLaw) -> f64 {
    SAFETY.min(DAMPED * stable_share(law.damping_ratio))
}

/// Longest step, s: what is near counts with its largest face flat on the ground, what falls with a share of the time until it can touch.
fn longest_step(world: &World, desk: &ContactScratch) -> f64 {
    let gravity = world.gravity.length();
    let mut longest = f64::INFINITY;
    for (b, state) in world.found.terrain.iter().enumerate() {
        let Some(laws) = desk.terrain.laws.get(b).filter(|laws| !laws.is_empty()) else {
            continue;
        };
        let shape = &desk.shapes[world.solid[b] as usize];
        let touching: f64 = state.facets.iter().map(|f| f.area).sum();
        let area = shape.areas.iter().copied().fold(touching, f64::max);
        // Faces in a hollow are no faces of the hull.
        let glued = desk.glued.get(world.solid[b] as usize);
        let area = glued.map_or(area, |glued| area.max(glued.largest));
        let ease = super::limit::InverseInertia::of(world, &desk.shapes, b).of_area(area);
        let mut stable = f64::INFINITY;
        for law in laws {
            let stiffness = 2.0 * law.normal_stiffness.max(law.shear_stiffness);
            stable = stable.min(share(law) * 2.0 / (stiffness * area * ease).sqrt());
        }
        let meet = if state.clear > 0.0 {
            let speed =
                world.bodies.velocity(b).length() + world.bodies.spin(b).length() * shape.radius;
            // v t + g t²/2 = way, in the form without cancellation.
            let way = state.clear;
            APPROACH * 2.0 * way / (speed + (speed * speed + 2.0 * gravity * way).sqrt())
        } else {
            0.0
        };
        // What cannot touch yet may go a share of the way there, however stiff the ground is.
        longest = longest.min(stable.max(meet));
    }
    longest
}

#[cfg(test)]
pub(super) mod tests;
