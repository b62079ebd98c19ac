//! Bolts come into the rock as it is now.

use riprap_geom::{Quat, Vec3};

use crate::laws::bolt::lay;
use crate::laws::bolt::place;
use crate::laws::bolt::place::Misplaced;
use crate::push::bolts::inside::TetFan;
use crate::push::bolts::place::span;
use crate::setup::Bolt as Spec;
use crate::state::anchor::Inside;
use crate::state::bolts::{Bolt, Dowel, Pin};
use crate::state::world::World;

/// Why a bolt could not be installed.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("bolt `{name}` cannot be installed: {reason}")]
pub struct InstallError {
    /// Its name.
    pub name: String,
    /// What is wrong.
    pub reason: Misplaced,
}

/// Installs bolts of the setup: where blocks are now, without force but for what they are stretched to. Forces must be evaluated anew
/// afterwards.
///
/// # Errors
/// A bolt that is not in rock.
pub fn install(world: &mut World, numbers: &[u32]) -> Result<(), InstallError> {
    for &number in numbers {
        let spec = world.setup.bolts[number as usize].clone();
        let bolt = one(world, number, &spec)
            .map_err(|reason| InstallError { name: spec.name.clone(), reason })?;
        world.bolts.push(bolt);
    }
    Ok(())
}

/// A bolt as it would be installed in the rock as it is; `None` where it could not.
pub(crate) fn as_it_is(world: &World, number: u32) -> Option<Bolt> {
    one(world, number, world.setup.bolts.get(number as usize)?).ok()
}

fn one(world: &World, number: u32, spec: &Spec) -> Result<Bolt, Misplaced> {
    let length = spec.head.distance(spec.toe);
    let axis = (spec.toe - spec.head) / length;
    let range = place::range(length);
    let middle = 0.5 * (spec.head + spec.toe);
    let mut spans = Vec::new();
    let mut stars: Vec<(u32, TetFan)> = Vec::new();
    for b in (0..world.alive.len()).filter(|b| world.alive[*b]) {
        if let Some(star) = TetFan::now(world, b, [spec.head, spec.toe]) {
            let found = star.spans(spec.head, axis, range);
            spans.extend(found.into_iter().map(|span| (span, b as u32)));
            stars.push((b as u32, star));
            continue;
        }
        let (shift, back) = pose(world, b);
        let centre = world.reference[b] + shift;
        let reach = world.solid_of(b).radius + 0.51 * length;
        let rigid = !world.deforms(b) && !world.is_terrain(b);
        if rigid && (middle - centre).length_squared() <= reach * reach {
            let from = world.reference[b] + back * (spec.head - centre);
            let shape = &world.setup.blocks[b].shape;
            let span = span(shape, from, back * axis, range);
            spans.extend(span.map(|span| (span, b as u32)));
        }
    }
    let spans = place::order(spans, length, spec.design.grouted, spec.design.plate.is_some())?;
    let lengths: Vec<[f64; 2]> = spans.iter().map(|s| s.0).collect();
    let mut laid = lay(&spec.design, length, &lengths);
    let pin = |along: f64, span: usize| {
        let block = spans[span].1;
        let star = stars.binary_search_by_key(&block, |s| s.0);
        let star = star.ok().map(|k| &stars[k].1);
        pin(world, (block, star), spec.head + along * axis, along)
    };
    let nodes = laid.along.iter().zip(&laid.span);
    let pins: Vec<Pin> = nodes.map(|(along, span)| pin(*along, *span)).collect();
    let block = |node: usize| spans[laid.span[node]].1;
    let joints = laid.joints.iter();
    // Where a line meets a bent block twice there is no joint between.
    let joints = joints.filter(|(bar, _)| block(*bar) != block(bar + 1));
    let dowels = joints.map(|&(bar, along)| Dowel {
        bar: bar as u32,
        sides: [bar, bar + 1].map(|node| pin(along, laid.span[node])),
        slip: Vec3::ZERO,
        force: Vec3::ZERO,
    });
    let dowels = dowels.collect();
    let toll = laid.tighten(&spec.design);
    Ok(Bolt { number, chain: laid.chain, pins, dowels, axis, toll })
}

/// Displacement of a block's centroid, and the turn back to its start.
fn pose(world: &World, b: usize) -> (Vec3, Quat) {
    let shift = world.all_freedoms().displacement(&world.centroid(b as u32));
    let back = world.turned[b].as_ref();
    (shift, back.map_or(Quat::IDENTITY, |t| t.attitude.conjugate()))
}

/// The point of a block that lies at a place now; `star` is the shape of one that deforms.
fn pin(world: &World, (block, star): (u32, Option<&TetFan>), place: Vec3, along: f64) -> Pin {
    let anchor = match star.and_then(|star| star.point(place)) {
        Some((inside, _)) => inside,
        None => {
            let b = block as usize;
            let (shift, back) = pose(world, b);
            let arm = back * (place - world.reference[b] - shift);
            Inside::Block { block, arm }
        }
    };
    Pin { block, anchor, along, place, base: world.all_freedoms().displacement_inside(&anchor) }
}
