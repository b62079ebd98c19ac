//! Cracks as surfaces: the outlines of facets that have lost bonds, with area, mode, time and opening.

use riprap_geom::Vec3;

use crate::deform::area::Area;
use crate::faces::deformable::outline;
use crate::frame::{Column, Surfaces};
use crate::query::view::View;
use crate::state::deform::{Deform, Facet, State};
use crate::state::world::World;
use crate::topology::cut::tip::{broken, near};

/// Facets with broken points; `None` if no block is deformable.
#[must_use]
pub fn surfaces(view: &View<'_>) -> Option<Surfaces> {
    let (deform, _) = view.deformables()?;
    let world = view.world;
    let mut out = Surfaces::default();
    let mut rows: Vec<[f64; 9]> = Vec::new();
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
        ("origin", "-"),
    ];
    out.columns = names
        .iter()
        .enumerate()
        .map(|(k, (name, unit))| Column::scalar(name, unit, rows.iter().map(|r| r[k]).collect()))
        .collect();
    Some(out)
}

/// Mean over the area of broken facets of the squared components of their normals.
#[must_use]
pub fn fabric(deform: &Deform) -> Vec3 {
    mean_of_broken(deform, |facet| facet.area * facet.frame[0] * facet.frame[0])
}

/// Mean over the area of broken facets of the distances of their centres from the planes x = 0, y = 0 and z = 0 of the
/// file, m; `origin` is that of the local frame.
#[must_use]
pub fn away(deform: &Deform, origin: Vec3) -> Vec3 {
    mean_of_broken(deform, |facet| facet.area * (facet.centre + origin).abs())
}

/// Sum over the broken facets over their area.
fn mean_of_broken(deform: &Deform, get: impl Fn(&Facet) -> Vec3) -> Vec3 {
    let (mut sum, mut area) = (Vec3::ZERO, 0.0);
    for facet in broken(deform).map(|k| &deform.facets[k]) {
        sum += get(facet);
        area += facet.area;
    }
    sum / area
}

/// Distance (m) of a point (local) from the nearest broken facet, at the start.
#[must_use]
pub fn distance(view: &View<'_>, at: Vec3) -> f64 {
    let Some((deform, _)) = view.deformables() else {
        return f64::NAN;
    };
    let distances = broken(deform).map(|k| {
        let facet = &deform.facets[k];
        Area::new(outline(view.world, facet), facet.frame[0]).distance(at)
    });
    distances.fold(f64::INFINITY, f64::min)
}

/// Distance (m) from a point (local) along a unit vector to the nearest broken facet that the line meets, at the start;
/// infinite where there is none.
#[must_use]
pub fn offset(view: &View<'_>, at: Vec3, along: Vec3) -> f64 {
    let Some((deform, _)) = view.deformables() else {
        return f64::NAN;
    };
    let near = near(view.world, deform);
    let hits = broken(deform).filter_map(|k| {
        let facet = &deform.facets[k];
        let area = Area::new(outline(view.world, facet), facet.frame[0]);
        let slope = area.normal.dot(along);
        let first = *area.corners.first()?;
        let s = area.normal.dot(first - at) / slope;
        // Along the facet the slope is zero, and nothing is met.
        (s.is_finite() && area.holds(at + s * along, near)).then_some(s)
    });
    hits.fold(f64::INFINITY, |best, s| if s.abs() < best.abs() { s } else { best })
}

/// Facet, blocks, broken area (m²), mode (1 tension, 2 shear, by area), time of the first break (s), mean opening and
/// sliding of the broken points (m), where the facet comes from ([`Origin::code`](crate::state::interface::Origin::code)).
fn row(world: &World, deform: &Deform, k: usize) -> [f64; 9] {
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
        f64::from(facet.origin.code()),
    ]
}
