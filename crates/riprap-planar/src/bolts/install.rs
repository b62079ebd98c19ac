//! Bolts come into the rock as it is now, and go with the blocks that are taken out.

use riprap_geom::Vec2;

use super::place::spans;
use crate::laws::bolt::lay;
use crate::laws::bolt::place::{self, Misplaced};
use crate::setup::Bolt as Spec;
use crate::shapes::Shapes;
use crate::world::{Bolt, Dowel, Pin, World};

/// Why a bolt could not be installed.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("bolt `{name}` cannot be installed: {reason}")]
pub struct InstallError {
    /// Its name.
    pub name: String,
    /// What is wrong.
    pub reason: Misplaced,
}

/// Installs bolts of the setup: where blocks are now, without force but for what they are stretched to. The candidate lists must be marked as out
/// of date and forces evaluated anew afterwards.
///
/// # Errors
/// A bolt that is not in rock.
pub fn install(world: &mut World, shapes: &Shapes, numbers: &[u32]) -> Result<(), InstallError> {
    for &number in numbers {
        let spec = world.setup.bolts[number as usize].clone();
        let bolt = one(world, shapes, number, &spec)
            .map_err(|reason| InstallError { name: spec.name.clone(), reason })?;
        world.bolts.push(bolt);
    }
    Ok(())
}

/// A bolt as it would be installed in the rock as it is; `None` where it could not.
pub(crate) fn as_it_is(world: &World, shapes: &Shapes, number: u32) -> Option<Bolt> {
    one(world, shapes, number, world.setup.bolts.get(number as usize)?).ok()
}

fn one(world: &World, shapes: &Shapes, number: u32, spec: &Spec) -> Result<Bolt, Misplaced> {
    let length = (spec.toe - spec.head).length();
    let axis = (spec.toe - spec.head) / length;
    let range = place::range(length);
    let middle = 0.5 * (spec.head + spec.toe);
    let mut found = Vec::new();
    for b in (0..world.alive.len()).filter(|b| world.alive[*b]) {
        let reach = shapes.radius[b] + 0.51 * length;
        if (middle - world.bodies[b].position).length_squared() > reach * reach {
            continue;
        }
        // The line where the block was drawn.
        let from = shapes.centroid[b] + into_body(world, b, spec.head);
        let along = turned_back(world, b, axis);
        let corners = &world.setup.blocks[b].vertices;
        found.extend(spans(corners, from, along, range).into_iter().map(|span| (span, b as u32)));
    }
    let design = &spec.design;
    let found = place::order(found, length, design.grouted, design.plate.is_some())?;
    let lengths: Vec<[f64; 2]> = found.iter().map(|s| s.0).collect();
    let mut laid = lay(design, length, &lengths);
    let pin = |along: f64, span: usize| {
        let block = found[span].1;
        let place = spec.head + along * axis;
        Pin { block, arm: into_body(world, block as usize, place), along, place }
    };
    let nodes = laid.along.iter().zip(&laid.span);
    let pins: Vec<Pin> = nodes.map(|(along, span)| pin(*along, *span)).collect();
    let dowels = laid.joints.iter().map(|&(bar, along)| Dowel {
        bar: bar as u32,
        sides: [bar, bar + 1].map(|node| pin(along, laid.span[node])),
        slip: Vec2::ZERO,
        force: Vec2::ZERO,
    });
    let dowels = dowels.collect();
    let toll = laid.tighten(design);
    Ok(Bolt { number, chain: laid.chain, pins, dowels, axis, toll })
}

/// A direction in the frame of a block.
fn turned_back(world: &World, b: usize, v: Vec2) -> Vec2 {
    let (s, c) = libm::sincos(world.bodies[b].angle);
    Vec2::new(c * v.x + s * v.y, c * v.y - s * v.x)
}

/// Where a place is on a block: from its centroid, in its frame, m.
fn into_body(world: &World, b: usize, place: Vec2) -> Vec2 {
    turned_back(world, b, place - world.bodies[b].position)
}

/// Takes nodes out of blocks that are gone, and bolts of which fewer than two are left. The candidate lists must be marked as out of date
/// afterwards.
pub fn follow(world: &mut World) {
    let alive = &world.alive;
    let here = |pin: &Pin| alive[pin.block as usize];
    for bolt in &mut world.bolts {
        let stays: Vec<bool> = bolt.pins.iter().map(here).collect();
        if stays.iter().all(|s| *s) {
            continue;
        }
        let kept = bolt.chain.keep(&stays);
        bolt.dowels.retain_mut(|dowel| {
            let new = kept.bar(dowel.bar as usize);
            let new = new.filter(|_| dowel.sides.iter().all(here));
            dowel.bar = new.unwrap_or(0) as u32;
            new.is_some()
        });
        bolt.chain = kept.chain;
        bolt.pins.retain(here);
    }
    world.bolts.retain(|bolt| bolt.pins.len() > 1);
}
