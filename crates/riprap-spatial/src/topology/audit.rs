//! What must stay as it was when blocks are split: mass, momenta and energy of motion, and a surface that is covered.

use std::collections::BTreeMap;

use crate::faces::divisible::Divisible;
use crate::joint::patch::turned_inertia;
use crate::laws::transfer::Motion;
use crate::state::lineage::ancestor;
use crate::state::world::World;
use crate::topology::error::EditError;

/// What must stay the same may change by this share: a few roundings.
const EXACT: f64 = 1e-12;
/// The same for parallelepipeds, which are given by their corners: these are where three pairs of parallel faces would have them
/// only up to `SKEW` (1e-10) of their size.
const ALMOST: f64 = 1e-9;

/// Adds the motion of block `b` to that of other parts, about the centroid of block `about`.
fn add(sum: &mut Motion, world: &World, b: usize, about: usize) {
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
    sum.mass += solid.mass;
    sum.momentum += solid.mass * v;
    sum.spin += arm.cross(solid.mass * v) + own;
    sum.kinetic += 0.5 * (solid.mass * v.length_squared() + own.dot(inverse * own));
}

/// Checks that the children of each block, appended to the `blocks` that there were, have its mass, momenta and energy of motion, and
/// that their surface is covered.
pub(super) fn splits(world: &World, blocks: usize) -> Result<(), EditError> {
    let mut parts: BTreeMap<u32, Motion> = BTreeMap::new();
    for b in blocks..world.alive.len() {
        if world.alive[b] {
            let root = ancestor(&world.lineage, b as u32, blocks as u32);
            add(parts.entry(root).or_default(), world, b, root as usize);
        }
    }
    for (&root, after) in &parts {
        let mut before = Motion::default();
        add(&mut before, world, root as usize, root as usize);
        let exact = match Divisible::of(&world.setup.blocks[root as usize].shape) {
            Some(Divisible::Brick(_)) => EXACT,
            Some(Divisible::Leaning(_)) | None => ALMOST,
        };
        motion(world, root, [&before, after], exact, world.solid_of(root as usize).radius)?;
        let kinetic = [before.kinetic, after.kinetic];
        unchanged(world, root, "the kinetic energy", kinetic, exact * before.kinetic)?;
    }
    surfaces(world, blocks)
}

/// Checks that the parts of a block, which reaches this far (m) from where moments are taken about, have its mass and momenta.
pub(super) fn motion(
    world: &World,
    block: u32,
    [before, after]: [&Motion; 2],
    exact: f64,
    reach: f64,
) -> Result<(), EditError> {
    let scale = before.mass * (2.0 * before.kinetic / before.mass).sqrt();
    let check = |what, quantity: &dyn Fn(&Motion) -> f64, scale: f64| {
        unchanged(world, block, what, [quantity(before), quantity(after)], exact * scale)
    };
    check("the mass", &|m| m.mass, before.mass)?;
    for k in 0..3 {
        check("the momentum", &|m| m.momentum[k], scale)?;
        check("the angular momentum", &|m| m.spin[k], scale * reach)?;
    }
    Ok(())
}

/// An error if a quantity of a block has changed by more than is allowed between the first value and the second.
pub(crate) fn unchanged(
    world: &World,
    block: u32,
    what: &'static str,
    [before, after]: [f64; 2],
    allowed: f64,
) -> Result<(), EditError> {
    if (after - before).abs() <= allowed.abs().max(f64::MIN_POSITIVE) {
        return Ok(());
    }
    let block = world.name(block as usize);
    Err(EditError::Audit { what, block, before, after })
}

/// Every face of every new block is covered by patches, walls and free faces.
fn surfaces(world: &World, blocks: usize) -> Result<(), EditError> {
    let mut covered = vec![0.0; world.alive.len() - blocks];
    let mut cover = |b: u32, area: f64| {
        if let Some(k) = (b as usize).checked_sub(blocks) {
            covered[k] += area;
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
        let b = blocks + k;
        let whole = Divisible::of(&world.setup.blocks[b].shape);
        let before = whole.map_or(0.0, |whole| whole.surface());
        if world.alive[b] {
            unchanged(world, b as u32, "the covered surface", [before, after], 1e-6 * before)?;
        }
    }
    Ok(())
}
