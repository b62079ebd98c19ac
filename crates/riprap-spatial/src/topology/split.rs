//! Splitting blocks 1 to 8 during a run.

use crate::faces::overlap::GAP;
use std::collections::{BTreeMap, BTreeSet};

use riprap_geom::{Mat3, Vec3};

use crate::faces::divisible::Divisible;
use crate::faces::overlap;
use crate::faces::overlap::Overlap;
use crate::joint::classes::ClassTable;
use crate::joint::patch::turned_inertia;
use crate::joint::reading::Reading;
use crate::push::charge;
use crate::push::charge::walls;
use crate::query::view::View;
use crate::state::anchor::Anchor;
use crate::state::bodies::Turned;
use crate::state::cavity::Wall;
use crate::state::face::{Face, HalfBlock};
use crate::state::interface::Origin;
use crate::state::lineage;
use crate::state::world::World;
use crate::topology::audit;
use crate::topology::error::EditError;
use crate::topology::family::{self, Moving};
use crate::topology::patches;
use crate::topology::refine;
use crate::topology::remove::orphans;

/// Least cosine between the normals of a face and of its part.
const ALIKE: f64 = 0.999;
/// Farther than this from the centre of a rectangle along an axis, in radii of gyration, lies no point of it (half edges are sqrt(3)).
const IN_RECTANGLE: f64 = 1.8;
/// The same for a parallelogram along its principal axes (half diagonals of a rhombus are sqrt(6)).
const IN_PARALLELOGRAM: f64 = 2.5;

/// What is split, and what is needed of the state before.
pub(super) struct Plan<'a> {
    /// Parents in order; children may be named by their future number.
    splits: &'a [u32],
    /// Number of blocks before.
    pub(super) blocks: usize,
    /// Patches of split blocks, by the lower and the higher block; they stay in the list until their parts have taken over.
    old: BTreeMap<[u32; 2], Vec<usize>>,
    /// Average stress of the split blocks in the frame of the start, Pa.
    stress: BTreeMap<u32, Mat3>,
}

impl<'a> Plan<'a> {
    pub(super) fn new(view: &View, splits: &'a [u32]) -> Self {
        let world = view.world;
        let blocks = world.alive.len();
        let stresses = view.stresses();
        let stress = splits.iter().filter(|b| (**b as usize) < blocks).map(|&b| {
            let turned = world.turned[b as usize].as_ref();
            let turn = turned.map_or(Mat3::IDENTITY, |t| Mat3::from_quat(t.attitude));
            (b, turn.transpose() * stresses[b as usize] * turn)
        });
        let stress: BTreeMap<u32, Mat3> = stress.collect();
        let mut old: BTreeMap<_, Vec<usize>> = BTreeMap::new();
        for (p, &[i, j]) in world.patches.ends.iter().enumerate() {
            if stress.contains_key(&i) || stress.contains_key(&j) {
                old.entry([i.min(j), i.max(j)]).or_default().push(p);
            }
        }
        Self { splits, blocks, old, stress }
    }

    /// Blocks of the old patches.
    fn old_ends(&self, world: &World) -> impl Iterator<Item = u32> {
        self.old.values().flatten().flat_map(|p| world.patches.ends[*p])
    }

    /// The block that existed before and holds block `b`.
    pub(super) fn root(&self, world: &World, b: u32) -> u32 {
        lineage::ancestor(&world.lineage, b, self.blocks as u32)
    }

    pub(super) fn is_new(&self, b: u32) -> bool {
        b as usize >= self.blocks
    }

    /// The patch that parts of the blocks `roots` share in an overlap, and whether its blocks stand the other way round there.
    fn old_of(&self, world: &World, roots: [u32; 2], overlap: &Overlap) -> Option<(usize, bool)> {
        let pair = [roots[0].min(roots[1]), roots[0].max(roots[1])];
        let same = |p: usize, back: bool| {
            let sign = if back { -1.0 } else { 1.0 };
            let ends = if back { [roots[1], roots[0]] } else { roots };
            let normal = Reading { world, p }.class().frame[0];
            world.patches.ends[p] == ends && sign * normal.dot(overlap.frame[0]) > ALIKE
        };
        let olds = self.old.get(&pair).into_iter().flatten();
        // Parts can share their face in the other order than the patch of their parents has it.
        olds.flat_map(|&p| [(p, false), (p, true)]).find(|(p, back)| same(*p, *back))
    }
}

/// Does it all but the evaluation.
pub(super) fn apply(world: &mut World, plan: &Plan) -> Result<(), EditError> {
    refine::append_children(&mut world.setup, &mut world.lineage, plan.splits);
    let families = refine::in_eight(plan.splits, plan.blocks);
    for family in &families {
        for child in family.children() {
            add_child(world, family.parent as usize, child as usize);
        }
        world.alive[family.parent as usize] = false;
    }
    let (near, charges) = neighbourhood(world, plan);
    let (overlaps, free) = overlap::touching(world, &near, GAP * world.finest());
    let turned = turned_walls(world);
    let World { cavities, alive, .. } = &mut *world;
    cavities.iter_mut().for_each(|c| c.walls.retain(|wall| alive[wall.block as usize]));
    let parents: BTreeMap<u32, Vec<Face>> = take_faces(world);
    let mut table = ClassTable::new(world, world.finest());
    let mut counts: BTreeMap<u32, [u32; 2]> = BTreeMap::new();
    plan.old_ends(world).for_each(|b| counts.entry(b).or_default()[0] += 1);
    for overlap in overlaps.iter().filter(|o| o.blocks.iter().any(|b| plan.is_new(*b))) {
        let owner = |side: usize| charges.get(&overlap.blocks[1 - side]);
        if let Some((side, &cavity)) = [1, 0].into_iter().find_map(|k| Some((k, owner(k)?))) {
            let mut wall = Wall::new(&world.setup, &world.reference, overlap, side);
            if let Some(parent) = turned.get(&(plan.root(world, wall.block), wall.behind)) {
                walls::divide(world, &mut wall, parent);
            }
            let source = &world.setup.sources[world.cavities[cavity].source as usize];
            wall.wait_for(source, world.reference[wall.block as usize] + wall.arm);
            world.cavities[cavity].walls.push(wall);
            continue;
        }
        let roots = overlap.blocks.map(|b| plan.root(world, b));
        if join(world, plan, &mut table, overlap, roots)? {
            let once = usize::from(roots[0] == roots[1]);
            roots[once..].iter().for_each(|root| counts.entry(*root).or_default()[1] += 1);
        } else {
            // Neighbours of the start whose joint has given way: the faces of the parts are as bare as those of the parents.
            for side in [0, 1] {
                lay_bare(world, plan, &parents, overlap.side(side))?;
            }
        }
    }
    for mut face in free.into_iter().filter(|face| plan.is_new(face.block)) {
        let root = plan.root(world, face.block);
        inherit(world, &mut face, &parents, root);
        world.faces.push(face);
    }
    world.faces.sort_by_key(|f| f.block);
    world.patches.drop_some(&orphans(world));
    world.patches.sort(&world.classes);
    for cavity in &mut world.cavities {
        cavity.walls.sort_by_key(|w| (w.block, w.behind));
    }
    charge::renew_surfaces(world);
    for family in &families {
        family::record(world, family, counts.get(&family.parent).copied().unwrap_or_default());
    }
    Ok(())
}

/// Adds the patch of parts of the blocks `roots`: one inside a block, or a part of one that was there; false where neither is.
fn join(
    world: &mut World,
    plan: &Plan,
    table: &mut ClassTable,
    overlap: &Overlap,
    roots: [u32; 2],
) -> Result<bool, EditError> {
    let p = world.patches.len();
    if roots[0] == roots[1] && lies_inside(world, roots[0], overlap) {
        world.add_patch(table, overlap)?;
        let finite = world.turned[roots[0] as usize].is_some();
        patches::inside(world, p, &plan.stress[&roots[0]], finite);
        world.patches.set_origin(p, Origin::Cut);
    } else if let Some((old, back)) = plan.old_of(world, roots, overlap) {
        // What a patch remembers is along its own axes, from its own block i to its block j.
        let overlap = if back { &overlap.reversed() } else { overlap };
        world.add_patch(table, overlap)?;
        patches::hand_on(world, p, old);
    } else {
        return Ok(false);
    }
    Ok(true)
}

/// Appends a child to the lists of the world; it moves with the rigid body that its parent is.
fn add_child(world: &mut World, parent: usize, child: usize) {
    let Some(shape) = Divisible::of(&world.setup.blocks[child].shape) else {
        unreachable!("only blocks with eight similar parts are split")
    };
    let centre = shape.centre();
    let start = centre - world.reference[parent];
    let whole = *world.solid_of(parent);
    let mut part = whole;
    part.mass /= 8.0;
    part.volume /= 8.0;
    // An eighth of the mass at half the distances.
    part.inertia = whole.inertia * (1.0 / 32.0);
    part.inverse = whole.inverse * 32.0;
    part.half = 0.5 * whole.half;
    part.radius = 0.5 * whole.radius;
    let class = match shape {
        Divisible::Brick(_) => world.solids.iter().position(|s| *s == part),
        // The corners of others are alike only up to round-off.
        Divisible::Leaning(_) => None,
    };
    let class = class.unwrap_or_else(|| {
        world.solids.push(part);
        world.solids.len() - 1
    });
    let there = Anchor::Block { block: parent as u32, arm: start };
    let u = world.all_freedoms().displacement(&there);
    let (v, mut w) = (world.bodies.velocity(parent), world.bodies.spin(parent));
    let (mut arm, mut turned) = (start, None);
    if let Some(state) = world.turned[parent].as_deref() {
        let q = state.attitude;
        arm = q * start;
        w = turned_inertia(&whole.inverse, q) * state.momentum;
        turned =
            Some(Box::new(Turned { attitude: q, momentum: turned_inertia(&part.inertia, q) * w }));
    }
    let part = Moving {
        solid: class,
        lever: start,
        centre,
        displacement: [u, world.bodies.rotation(parent)],
        velocity: [v + w.cross(arm), w],
        turned,
    };
    family::append(world, parent, part);
}

/// New blocks, the blocks around them, and the removed blocks behind walls of cavities, with the number of the cavity.
fn neighbourhood(world: &World, plan: &Plan) -> (Vec<u32>, BTreeMap<u32, usize>) {
    let mut near: BTreeSet<u32> = (plan.blocks..world.alive.len()).map(|b| b as u32).collect();
    near.extend(plan.old_ends(world));
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
    (near.into_iter().collect(), charges)
}

/// Walls of dead blocks that have turned with them, by block and removed block.
fn turned_walls(world: &World) -> BTreeMap<(u32, u32), Wall> {
    let walls = world.cavities.iter().flat_map(|c| &c.walls);
    let gone = walls.filter(|w| w.turned.is_some() && !world.alive[w.block as usize]);
    gone.map(|w| ((w.block, w.behind), *w)).collect()
}

/// Takes the faces of dead blocks out of the list, by block.
fn take_faces(world: &mut World) -> BTreeMap<u32, Vec<Face>> {
    let faces = std::mem::take(&mut world.faces).into_iter();
    let (living, dead): (Vec<Face>, _) = faces.partition(|face| world.alive[face.block as usize]);
    world.faces = living;
    let mut parents: BTreeMap<u32, Vec<Face>> = BTreeMap::new();
    let mut add = |face: Face| parents.entry(face.block).or_default().push(face);
    dead.into_iter().for_each(&mut add);
    parents
}

/// Whether an overlap of two parts of a block that was split lies inside it, and not where the block meets itself across a period.
fn lies_inside(world: &World, root: u32, overlap: &Overlap) -> bool {
    let n = overlap.frame[0];
    let height = n.dot(overlap.centre(&world.reference) - world.reference[root as usize]);
    let reach = match Divisible::of(&world.setup.blocks[root as usize].shape) {
        Some(whole) => whole.reach(n),
        None => return false,
    };
    height.abs() < ALIKE * reach
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
        audit::unchanged(world, root, "the area of patches", [0.0, face.area], 0.0)?;
    }
    world.faces.push(face);
    Ok(())
}

/// A free face of a child takes the condition of the parent's face; springs keep their stress at their new stiffness.
fn inherit(world: &World, face: &mut Face, parents: &BTreeMap<u32, Vec<Face>>, root: u32) {
    let reference = |b: u32| world.reference[b as usize];
    let centre = reference(face.block) + face.arm;
    let within = match Divisible::of(&world.setup.blocks[root as usize].shape) {
        Some(Divisible::Brick(_)) => IN_RECTANGLE,
        Some(Divisible::Leaning(_)) | None => IN_PARALLELOGRAM,
    };
    // How far the centre is from that of a face of the parent, in radii of gyration.
    let far = |f: &Face| {
        let [n, b, c] = f.frame;
        let from = centre - (reference(root) + f.arm);
        let share = [from.dot(b) / f.half_spacing[0], from.dot(c) / f.half_spacing[1]];
        let along = n.dot(face.frame[0]) > ALIKE;
        along.then(|| share[0].abs().max(share[1].abs()))
    };
    let faces = parents.get(&root).into_iter().flatten();
    let Some((_, parent)) = faces
        .filter_map(|f| Some((far(f).filter(|far| *far < within)?, f)))
        .min_by(|a, b| a.0.total_cmp(&b.0))
    else {
        return;
    };
    face.parted = parent.parted;
    let Some(index) = parent.boundary else {
        return;
    };
    face.boundary = Some(index);
    let depth = |f: &Face| f.arm.dot(f.frame[0]);
    // A part is less deep behind the face than the whole, and stiffer by as much.
    let ratio = depth(parent) / depth(face);
    let Some(behind) = &parent.half_block else {
        return;
    };
    let freedoms = world.all_freedoms();
    let moved = |block: u32, arm: Vec3| freedoms.displacement(&Anchor::Block { block, arm });
    let mut half = HalfBlock {
        stiffness: behind.stiffness.map(|k| ratio * k),
        impedance: behind.impedance,
        ..HalfBlock::default()
    };
    for p in 0..4 {
        let at = face.place(p);
        let from = reference(face.block) + at - (reference(root) + parent.arm);
        let nearest = patches::nearest([from.dot(parent.frame[1]), from.dot(parent.frame[2])]);
        let own = moved(face.block, at);
        let stretch = moved(root, parent.place(nearest)) - behind.anchor[nearest];
        // With the stretch divided by what the stiffness is multiplied with the stress goes on.
        half.anchor[p] = own - stretch / ratio;
    }
    face.half_block = Some(Box::new(half));
}
