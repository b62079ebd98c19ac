//! What happened in an engine, in the words of `events.jsonl` and of the manifest.

use crate::record::manifest::{Place as Spot, Source};
use crate::spatial::setup::{CavityPressure, Place};
use crate::spatial::topology::EditKind;
use crate::{Vec3, planar, spatial};

/// Joints that have broken since the last look.
pub(super) fn planar_events(v: &planar::view::View<'_>) -> Vec<serde_json::Value> {
    let world = v.world;
    let name = |b: u32| &world.setup.blocks[b as usize].name;
    world
        .bonds
        .iter()
        .filter(|b| b.broken_at == Some(world.step))
        .map(|bond| {
            serde_json::json!({
                "event": "joint_broken",
                "step": world.step,
                "time": world.time,
                "blocks": [name(bond.i), name(bond.j)],
                "length": bond.length,
            })
        })
        .collect()
}

/// A cavity as the manifest lists it, global coordinates.
pub(super) fn source(v: &spatial::view::View<'_>, cavity: &spatial::charge::Cavity) -> Source {
    let setup = &v.world.setup;
    let source = &setup.sources[cavity.source as usize];
    let global = |p: Vec3| (p + setup.origin).to_array();
    let profile = v.profile(cavity);
    let place = match &source.place {
        Place::Point { centre } => Spot::Centre(global(*centre)),
        Place::Line { from, to } => Spot::Line([global(*from), global(*to)]),
        Place::Blocks { .. } => Spot::Centre(global(v.charge_centre(cavity))),
    };
    Source {
        name: source.name.clone(),
        place,
        delay: source.delay,
        mass: match source.push {
            CavityPressure::Gas { mass, .. } => Some(mass),
            CavityPressure::Pressure { .. } => None,
        },
        charge_volume: cavity.gas.map(|_| cavity.charge_volume()),
        cavity_volume: cavity.removed,
        depth: Some(profile.depth).filter(|d| *d > 0.0),
    }
}

/// A facet of bonds that broke.
pub(super) fn break_event(
    v: &spatial::view::View<'_>,
    event: &spatial::deform::store::Break,
) -> serde_json::Value {
    let blocks = v.deformables().map(|(deform, _)| {
        let facet = &deform.facets[event.facet as usize];
        facet.blocks.map(|b| v.name(b as usize))
    });
    serde_json::json!({
        "event": "bond_broken", "step": event.step, "time": event.time,
        "blocks": blocks, "facet": event.facet,
        "area_tension": event.area[0], "area_shear": event.area[1],
        "utilisation": event.utilisation, "released": event.released,
    })
}

/// A block split, cut or removed, a charge fired or vented.
pub(super) fn spatial_event(
    v: &spatial::view::View<'_>,
    event: &spatial::topology::EditEvent,
) -> serde_json::Value {
    let (step, time) = (event.step, event.time);
    let source = || {
        let cavity = &v.world.cavities[event.subject as usize];
        &v.world.setup.sources[cavity.source as usize].name
    };
    let children =
        || -> Vec<String> { event.children.iter().map(|&b| v.name(b as usize)).collect() };
    match event.kind {
        EditKind::Split => serde_json::json!({
            "event": "block_split", "step": step, "time": time,
            "block": v.name(event.subject as usize),
            "children": children(),
            "patches_before": event.patches[0], "patches_after": event.patches[1],
        }),
        EditKind::Cut => {
            let note = event.cut.as_ref();
            serde_json::json!({
                "event": "block_cut", "step": step, "time": time,
                "block": v.name(event.subject as usize),
                "children": children(),
                "normal": note.map(|n| n.normal.to_array()),
                "mode": note.map(|n| n.mode),
                "excess": note.map(|n| n.excess),
                "facets_before": event.patches[0], "facets_after": event.patches[1],
            })
        }
        EditKind::Removed => serde_json::json!({
            "event": "block_removed", "step": step, "time": time,
            "block": v.name(event.subject as usize),
        }),
        EditKind::Ignited => serde_json::json!({
            "event": "charge_fired", "step": step, "time": time, "source": source(),
        }),
        EditKind::Vented => serde_json::json!({
            "event": "gas_vented", "step": step, "time": time, "source": source(),
        }),
        EditKind::LeftTerrain => serde_json::json!({
            "event": "block_left_terrain", "step": step, "time": time,
            "block": v.name(event.subject as usize),
        }),
    }
}
