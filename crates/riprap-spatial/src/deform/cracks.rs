//! Cracks as surfaces: the outlines of facets that have lost bonds, with area, mode, time and opening.

use riprap_geom::Vec3;
use riprap_geom::face_overlap::face_overlap;

use super::store::{Deform, Facet, State};
use crate::deform::shape::centred;
use crate::fields::View;
use crate::frame::{Column, Surfaces};
use crate::world::World;

/// Facets with broken points; `None` if no block is deformable.
#[must_use]
pub fn surfaces(view: &View<'_>) -> Option<Surfaces> {
    let (deform, _) = view.softs()?;
    let world = view.world;
    let mut out = Surfaces::default();
    let mut rows: Vec<[f64; 8]> = Vec::new();
    for (k, facet) in deform.facets.iter().enumerate() {
        if view.broken_points(facet) == 0 {
            continue;
        }
        let outline = outline(world, facet);
        // Between the two sides, as they are now.
        let [a, b] = facet.blocks.map(|b| b as usize);
        let moved =
            0.5 * (view.position(a) - world.reference[a] + view.position(b) - world.reference[b]);
        for place in outline {
            let place = place + moved + world.setup.origin;
            out.points.push(place.to_array());
        }
        out.ends.push(out.points.len() as u32);
        rows.push(row(world, deform, k));
    }
    let names = [
        ("facet", "-"),
        ("block_a", "-"),
        ("block_b", "-"),
        ("area", "m2"),
        ("mode", "-"),
        ("time", "s"),
        ("opening", "m"),
        ("slip", "m"),
    ];
    out.columns = names
        .iter()
        .enumerate()
        .map(|(k, (name, unit))| Column::scalar(name, unit, rows.iter().map(|r| r[k]).collect()))
        .collect();
    Some(out)
}

/// Facet, blocks, broken area (m²), mode (1 tension, 2 shear, by area), time of the first break (s), mean opening and
/// sliding of the broken points (m).
fn row(world: &World, deform: &Deform, k: usize) -> [f64; 8] {
    let facet = &deform.facets[k];
    let freedoms = world.freedoms_with(deform);
    let (mut areas, mut time) = ([0.0; 2], f64::INFINITY);
    let (mut opening, mut slip) = (0.0, 0.0);
    for p in facet.points() {
        let (point, memory) = (&deform.points[p], &deform.memory[p]);
        match memory.state {
            State::Bonded => continue,
            State::Opened => areas[0] += point.area,
            State::Sheared => areas[1] += point.area,
        }
        time = time.min(memory.broken_at);
        let jump = freedoms.jump(&point.anchors);
        let across = jump.dot(facet.now[0]);
        opening += point.area * across;
        slip += point.area * (jump - across * facet.now[0]).length();
    }
    let area = areas[0] + areas[1];
    let mode = if areas[1] > areas[0] { 2.0 } else { 1.0 };
    [
        k as f64,
        f64::from(facet.blocks[0]),
        f64::from(facet.blocks[1]),
        area,
        mode,
        time,
        opening / area,
        slip / area,
    ]
}

/// Corners of the part that the faces of two blocks share at the start, m (local).
pub(super) fn outline(world: &World, facet: &Facet) -> Vec<Vec3> {
    let n = facet.frame[0];
    let faces = [0, 1].map(|side: usize| {
        let (solid, centroid) = centred(&world.setup.blocks[facet.blocks[side] as usize].shape);
        let outward = if side == 0 { n } else { -n };
        let facing = |f: &usize| solid.plane(*f).0.dot(outward);
        let best = (0..solid.faces.len()).max_by(|a, b| facing(a).total_cmp(&facing(b)));
        let corners = solid.outline(best.unwrap_or(0));
        let places: Vec<Vec3> = corners.into_iter().map(|c| c + centroid).collect();
        places
    });
    // In a periodic model the faces lie a period apart: then the first is as good.
    match face_overlap(&faces[0], &faces[1], n, 0.0) {
        Some(shared) => shared.outline,
        None => faces[0].clone(),
    }
}
