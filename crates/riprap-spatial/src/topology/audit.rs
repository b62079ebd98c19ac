//! What must stay as it was when blocks are split: mass, momenta and energy of motion, and a surface that is covered.

use std::collections::BTreeMap;

use riprap_geom::Vec3;

use crate::faces::divisible::Divisible;
use crate::joint::patch::turned_inertia;
use crate::state::world::World;
use crate::topology::error::EditError;
use crate::topology::split::Plan;

/// What must stay the same may change by this share: a few roundings.
const EXACT: f64 = 1e-12;
/// The same for parallelepipeds, which are given by their corners: these are where three pairs of parallel faces would have them
/// only up to `SKEW` (1e-10) of their size.
const ALMOST: f64 = 1e-9;

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
pub(super) fn splits(world: &World, plan: &Plan) -> Result<(), EditError> {
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
        let exact = match Divisible::of(&world.setup.blocks[root as usize].shape) {
            Some(Divisible::Brick(_)) => EXACT,
            Some(Divisible::Leaning(_)) | None => ALMOST,
        };
        let check = |what, before: f64, after: f64, scale: f64| {
            unchanged(world, root, what, [before, after], exact * scale)
        };
        check("the mass", before.mass, after.mass, before.mass)?;
        check("the kinetic energy", before.kinetic, after.kinetic, before.kinetic)?;
        for k in 0..3 {
            check("the momentum", before.momentum[k], after.momentum[k], scale)?;
            let moment = scale * radius;
            check("the angular momentum", before.spin[k], after.spin[k], moment)?;
        }
    }
    surfaces(world, plan)
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
        let whole = Divisible::of(&world.setup.blocks[b].shape);
        let before = whole.map_or(0.0, |whole| whole.surface());
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
