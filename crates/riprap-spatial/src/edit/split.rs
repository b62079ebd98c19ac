//! Splitting blocks 1 to 8 during a run.

use std::collections::{BTreeMap, BTreeSet};

use riprap_geom::{Mat3, Vec3};

use super::error::EditError;
use super::patches::{self, Old};
use crate::build::{self, ClassTable};
use crate::cavity::walls;
use crate::laws::face_joint::SIGNS;
use crate::meet::{self, Cell, Free};
use crate::overlap;
use crate::patch::turned_inertia;
use crate::read::view::View;
use crate::refine;
use crate::setup::{BoundaryKind, Shape};
use crate::state::cavity::Wall;
use crate::state::event::{EditEvent, EditKind};
use crate::state::face::Face;
use crate::state::interface::Origin;
use crate::world::{Turned, World};

/// What must stay the same may change by this share: a few roundings.
const EXACT: f64 = 1e-12;

/// All that is needed of the state before.
pub(super) struct Plan<'a> {
    /// Parents in order; children may be named by their future number.
    splits: &'a [u32],
    /// Number of blocks before.
    blocks: usize,
    /// Patches of split blocks.
    old: BTreeMap<(u32, u32, u8), Old>,
    /// Average stress of the split blocks in the frame of the start, Pa.
    stress: BTreeMap<u32, Mat3>,
    /// Number of patches of the split blocks.
    count: BTreeMap<u32, u32>,
}

impl<'a> Plan<'a> {
    pub(super) fn new(view: &View, splits: &'a [u32]) -> Self {
        let world = view.world;
        let blocks = world.alive.len();
        let mut plan = Self {
            splits,
            blocks,
            old: BTreeMap::new(),
            stress: BTreeMap::new(),
            count: BTreeMap::new(),
        };
        let stresses = view.stresses();
        for &b in splits.iter().filter(|b| (**b as usize) < blocks) {
            let turn = world.turned[b as usize]
                .as_ref()
                .map_or(Mat3::IDENTITY, |t| Mat3::from_quat(t.attitude));
            let stress = turn.transpose() * stresses[b as usize] * turn;
            plan.stress.insert(b, stress);
            plan.count.insert(b, 0);
        }
        for (p, &ends) in world.patches.ends.iter().enumerate() {
            if !ends.iter().any(|b| plan.stress.contains_key(b)) {
                continue;
            }
            let old = Old::new(view, p);
            plan.old.insert((ends[0], ends[1], old.axis()), old);
            for b in ends {
                if let Some(count) = plan.count.get_mut(&b) {
                    *count += 1;
                }
            }
        }
        plan
    }

    /// The block that existed before and holds block `b`.
    fn root(&self, world: &World, b: u32) -> u32 {
        let mut b = b;
        while b as usize >= self.blocks {
            b = world.lineage[b as usize].parent;
        }
        b
    }

    fn is_new(&self, b: u32) -> bool {
        b as usize >= self.blocks
    }
}

/// Does it all but the evaluation.
pub(super) fn apply(world: &mut World, plan: &Plan) -> Result<(), EditError> {
    refine::append_children(&mut world.setup, &mut world.lineage, plan.splits);
    refine::follow(&mut world.setup, &world.lineage, plan.splits);
    for (k, &parent) in plan.splits.iter().enumerate() {
        let first = plan.blocks + 8 * k;
        for child in first..first + 8 {
            add_child(world, parent as usize, child);
        }
        world.alive[parent as usize] = false;
    }
    let tolerance = build::GAP * world.finest();
    let (cells, charges) = neighbourhood(world, plan);
    let (shared, free) = meet::meet(&cells, world.setup.periodic, tolerance);
    let turned = turned_walls(world);
    forget(world);
    let parents: BTreeMap<u32, Vec<Face>> = take_faces(world);
    let mut after: BTreeMap<u32, u32> = BTreeMap::new();
    let mut table = ClassTable::new(world, world.finest());
    for s in &shared {
        let blocks = [cells[s.low].block, cells[s.high].block];
        if !blocks.iter().any(|b| plan.is_new(*b)) {
            continue;
        }
        let overlap = overlap::overlap(&cells, s);
        let owner = |k: usize| charges.get(&blocks[k]).copied();
        if let Some((side, cavity)) = [(1, owner(0)), (0, owner(1))]
            .into_iter()
            .find_map(|(side, owner)| owner.map(|cavity| (side, cavity)))
        {
            let mut wall = Wall::new(&world.setup, &world.reference, &overlap, side);
            if let Some(parent) = turned.get(&(plan.root(world, wall.block), wall.behind)) {
                walls::divide(world, &mut wall, parent);
            }
            world.cavities[cavity].walls.push(wall);
            continue;
        }
        let roots = blocks.map(|b| plan.root(world, b));
        let inside = roots[0] == roots[1] && lies_inside(world, roots[0], &cells[s.low], s.axis);
        let old = plan.old.get(&(roots[0], roots[1], s.axis as u8));
        if !inside && old.is_none() {
            // Neighbours of the start whose joint has given way: the faces of the parts are as bare as those of the parents.
            for (cell, upward) in [(s.low, true), (s.high, false)] {
                let side = Free {
                    cell,
                    axis: s.axis,
                    upward,
                    part: s.part,
                };
                lay_bare(world, plan, &parents, overlap::face(&cells, &side))?;
            }
            continue;
        }
        let p = world.patches.len();
        world.add_patch(&mut table, &overlap)?;
        for root in if roots[0] == roots[1] {
            &roots[..1]
        } else {
            &roots[..]
        } {
            *after.entry(*root).or_default() += 1;
        }
        if inside {
            let finite = world.turned[roots[0] as usize].is_some();
            patches::inside(world, p, &plan.stress[&roots[0]], finite);
            world.patches.set_origin(p, Origin::Cut);
        } else if let Some(old) = old {
            old.hand_on(world, p);
        }
    }
    for f in &free {
        let block = cells[f.cell].block;
        if plan.is_new(block) {
            let mut face = overlap::face(&cells, f);
            inherit(world, &mut face, &parents, plan.root(world, block));
            world.faces.push(face);
        }
    }
    world.faces.sort_by_key(|f| f.block);
    world.patches.sort(&world.classes);
    let mut cavities = std::mem::take(&mut world.cavities);
    for cavity in &mut cavities {
        cavity.walls.sort_by_key(|w| (w.block, w.behind));
        cavity.renew_surface(world);
    }
    world.cavities = cavities;
    report(world, plan, &after);
    Ok(())
}

fn missing(world: &World, block: u32, area: f64) -> EditError {
    EditError::Audit {
        what: "the area of patches",
        block: world.name(block as usize),
        before: 0.0,
        after: area,
    }
}

/// Appends a child to the lists of the world; it moves with the rigid body that its parent is.
fn add_child(world: &mut World, parent: usize, child: usize) {
    let Shape::Brick { centre, .. } = world.setup.blocks[child].shape else {
        unreachable!("only bricks are split")
    };
    let start = centre - world.reference[parent];
    let whole = *world.solid_of(parent);
    let mut part = whole;
    part.mass /= 8.0;
    part.volume /= 8.0;
    part.inertia = whole.inertia * (1.0 / 32.0);
    part.inverse = whole.inverse * 32.0;
    part.half = 0.5 * whole.half;
    part.radius = 0.5 * whole.radius;
    let class = world.solids.iter().position(|s| *s == part);
    let class = class.unwrap_or_else(|| {
        world.solids.push(part);
        world.solids.len() - 1
    });
    let (u, turn) = (
        world.bodies.displacement(parent),
        world.bodies.rotation(parent),
    );
    let (v, mut w) = (world.bodies.velocity(parent), world.bodies.spin(parent));
    let (mut moved, mut arm, mut turned) = (turn.cross(start), start, None);
    if let Some(state) = world.turned[parent].as_deref() {
        let q = state.attitude;
        arm = q * start;
        moved = arm - start;
        w = turned_inertia(&whole.inverse, q) * state.momentum;
        turned = Some(Box::new(Turned {
            attitude: q,
            momentum: turned_inertia(&part.inertia, q) * w,
        }));
    }
    world.bodies.push([u + moved, turn], [v + w.cross(arm), w]);
    if !world.datum.is_empty() {
        let [shift, turn] = world.datum(parent);
        world.datum.resize(child, [Vec3::ZERO; 2]);
        world.datum.push([shift + turn.cross(start), turn]);
    }
    world.reference.push(centre);
    world.solid.push(class as u32);
    world.turned.push(turned);
    world.alive.push(true);
    world.motion.push(world.motion[parent].clone());
    world
        .peak_speed_squared
        .push(world.peak_speed_squared[parent]);
}

/// New blocks, the blocks around them, and the removed blocks behind walls of cavities, with the number of the cavity.
fn neighbourhood(world: &World, plan: &Plan) -> (Vec<Cell>, BTreeMap<u32, usize>) {
    let mut near: BTreeSet<u32> = (plan.blocks..world.alive.len()).map(|b| b as u32).collect();
    near.extend(plan.old.values().flat_map(|old| old.ends));
    near.retain(|&b| world.alive[b as usize]);
    let mut charges = BTreeMap::new();
    for (k, cavity) in world.cavities.iter().enumerate() {
        for wall in &cavity.walls {
            if plan.stress.contains_key(&wall.block) {
                charges.insert(wall.behind, k);
                near.insert(wall.behind);
            }
        }
    }
    let cells = near
        .iter()
        .map(|&block| Cell {
            block,
            centre: world.reference[block as usize],
            half: world.solid_of(block as usize).half,
        })
        .collect();
    (cells, charges)
}

/// Walls of dead blocks that have turned with them, by block and removed block.
fn turned_walls(world: &World) -> BTreeMap<(u32, u32), Wall> {
    let walls = world.cavities.iter().flat_map(|c| &c.walls);
    let gone = walls.filter(|w| w.turned.is_some() && !world.alive[w.block as usize]);
    gone.map(|w| ((w.block, w.behind), *w)).collect()
}

/// Drops patches and walls of dead blocks.
fn forget(world: &mut World) {
    let list = &world.patches;
    let alive = |b: &u32| world.alive[*b as usize];
    let keep: Vec<u32> = (0..list.len() as u32)
        .filter(|&p| list.ends[p as usize].iter().all(alive))
        .collect();
    world.patches.keep(&keep);
    for cavity in &mut world.cavities {
        cavity.walls.retain(|w| world.alive[w.block as usize]);
    }
}

/// Takes the faces of dead blocks out of the list, by block.
fn take_faces(world: &mut World) -> BTreeMap<u32, Vec<Face>> {
    let mut parents: BTreeMap<u32, Vec<Face>> = BTreeMap::new();
    for face in std::mem::take(&mut world.faces) {
        if world.alive[face.block as usize] {
            world.faces.push(face);
        } else {
            parents.entry(face.block).or_default().push(face);
        }
    }
    parents
}

/// Whether a patch at the upper side of `low` lies inside the block that was split.
fn lies_inside(world: &World, root: u32, low: &Cell, axis: usize) -> bool {
    let root = root as usize;
    let half = world.solid_of(root).half[axis];
    let plane = low.centre[axis] + low.half[axis] - world.reference[root][axis];
    plane.abs() < 0.999 * half
}

/// Adds a face that a neighbour of the start faces, to which no joint of the parent led any more.
fn lay_bare(
    world: &mut World,
    plan: &Plan,
    parents: &BTreeMap<u32, Vec<Face>>,
    mut face: Face,
) -> Result<(), EditError> {
    if !plan.is_new(face.block) {
        return Ok(()); // It has its face already.
    }
    let root = plan.root(world, face.block);
    inherit(world, &mut face, parents, root);
    if !face.parted {
        return Err(missing(world, root, face.area));
    }
    world.faces.push(face);
    Ok(())
}

/// A free face of a child takes the condition of the parent's face; springs keep their stress at their new stiffness.
fn inherit(world: &World, face: &mut Face, parents: &BTreeMap<u32, Vec<Face>>, root: u32) {
    let reference = |b: u32| world.reference[b as usize];
    let centre = reference(face.block) + face.arm;
    let Some(parent) = parents.get(&root).and_then(|faces| {
        faces.iter().find(|f| {
            let [n, b, c] = f.frame;
            let from = centre - (reference(root) + f.arm);
            // Half edges are sqrt(3) radii of gyration.
            n.dot(face.frame[0]) > 0.5
                && from.dot(b).abs() < 1.8 * f.half_spacing[0]
                && from.dot(c).abs() < 1.8 * f.half_spacing[1]
        })
    }) else {
        return;
    };
    face.parted = parent.parted;
    let Some(index) = parent.boundary else {
        return;
    };
    face.boundary = Some(index);
    let depth = |f: &Face| f.arm.dot(f.frame[0]);
    let ratio = depth(parent) / depth(face);
    face.stiffness = parent.stiffness.map(|k| ratio * k);
    face.impedance = parent.impedance;
    if matches!(
        world.setup.boundaries[index as usize].kind,
        BoundaryKind::Traction { .. }
    ) {
        return;
    }
    for p in 0..4 {
        let at = face.place(p);
        let from = reference(face.block) + at - (reference(root) + parent.arm);
        let side = |k: usize| from.dot(parent.frame[k + 1]) >= 0.0;
        let nearest = (0..4)
            .find(|&q| (0..2).all(|k| (SIGNS[k][q] > 0.0) == side(k)))
            .unwrap_or(0);
        let own = moved(world, face.block, at);
        let theirs = moved(world, root, parent.place(nearest));
        let stretch = theirs - parent.anchor[nearest];
        face.anchor[p] = own - stretch / ratio;
    }
}

/// Displacement of a point of a block given from its centroid at the start, m.
fn moved(world: &World, block: u32, arm: Vec3) -> Vec3 {
    let b = block as usize;
    let turned = match &world.turned[b] {
        Some(turned) => turned.attitude * arm - arm,
        None => world.bodies.rotation(b).cross(arm),
    };
    world.bodies.displacement(b) + turned
}

fn report(world: &mut World, plan: &Plan, after: &BTreeMap<u32, u32>) {
    for (k, &parent) in plan.splits.iter().enumerate() {
        let first = (plan.blocks + 8 * k) as u32;
        let counts = [plan.count.get(&parent), after.get(&parent)];
        let event = EditEvent {
            children: (first..first + 8).collect(),
            patches: counts.map(|c| c.copied().unwrap_or(0)),
            ..world.event(EditKind::Split, parent)
        };
        world.events.push(event);
    }
}

/// Sums over blocks about one point.
#[derive(Clone, Copy, Default)]
struct Sums {
    mass: f64,
    momentum: Vec3,
    spin: Vec3,
    kinetic: f64,
}

impl Sums {
    fn add(&mut self, world: &World, b: usize, about: usize) {
        let solid = world.solid_of(b);
        let q = world.turned[b].as_ref().map(|t| t.attitude);
        let arm = world.reference[b] - world.reference[about];
        let arm = q.map_or(arm, |q| q * arm);
        let inertia = q.map_or(solid.inertia, |q| turned_inertia(&solid.inertia, q));
        let inverse = q.map_or(solid.inverse, |q| turned_inertia(&solid.inverse, q));
        let own = match &world.turned[b] {
            Some(turned) => turned.momentum,
            None => inertia * world.bodies.spin(b),
        };
        let v = world.bodies.velocity(b);
        self.mass += solid.mass;
        self.momentum += solid.mass * v;
        self.spin += arm.cross(solid.mass * v) + own;
        self.kinetic += 0.5 * (solid.mass * v.length_squared() + own.dot(inverse * own));
    }
}

/// Checks that the children of each block have its mass, momenta and energy of motion, and that their surface is covered.
pub(super) fn audit(world: &World, plan: &Plan) -> Result<(), EditError> {
    let mut parts: BTreeMap<u32, Sums> = BTreeMap::new();
    for b in plan.blocks..world.alive.len() {
        if world.alive[b] {
            let root = plan.root(world, b as u32);
            parts.entry(root).or_default().add(world, b, root as usize);
        }
    }
    for (&root, after) in &parts {
        let mut before = Sums::default();
        before.add(world, root as usize, root as usize);
        let scale = before.mass * (2.0 * before.kinetic / before.mass).sqrt();
        let radius = world.solid_of(root as usize).radius;
        let check = |what, before: f64, after: f64, scale: f64| {
            if (after - before).abs() <= EXACT * scale.abs().max(f64::MIN_POSITIVE) {
                return Ok(());
            }
            let block = world.name(root as usize);
            Err(EditError::Audit {
                what,
                block,
                before,
                after,
            })
        };
        check("the mass", before.mass, after.mass, before.mass)?;
        check(
            "the energy of motion",
            before.kinetic,
            after.kinetic,
            before.kinetic,
        )?;
        for k in 0..3 {
            check("the momentum", before.momentum[k], after.momentum[k], scale)?;
            let moment = scale * radius;
            check(
                "the angular momentum",
                before.spin[k],
                after.spin[k],
                moment,
            )?;
        }
    }
    surfaces(world, plan)
}

/// Every face of every new block is covered by patches, walls and free faces.
fn surfaces(world: &World, plan: &Plan) -> Result<(), EditError> {
    let mut covered = vec![0.0; world.alive.len() - plan.blocks];
    let mut cover = |b: u32, area: f64| {
        if plan.is_new(b) {
            covered[b as usize - plan.blocks] += area;
        }
    };
    for (ends, class) in world.patches.ends.iter().zip(&world.patches.class) {
        for &b in ends {
            cover(b, world.classes[*class as usize].area);
        }
    }
    for face in &world.faces {
        cover(face.block, face.area);
    }
    for wall in world.cavities.iter().flat_map(|c| &c.walls) {
        cover(wall.block, wall.area);
    }
    for (k, &after) in covered.iter().enumerate() {
        let b = plan.blocks + k;
        let h = world.solid_of(b).half;
        let before = 8.0 * (h.x * h.y + h.y * h.z + h.z * h.x);
        if world.alive[b] && (after - before).abs() > 1e-6 * before {
            return Err(EditError::Audit {
                what: "the covered surface",
                block: world.name(b),
                before,
                after,
            });
        }
    }
    Ok(())
}
