//! What holds, moves and loads a model in the plane, as pictures show it.

use riprap_geom::{Vec2, Vec3};

use super::loads::edge_normal;
use super::setup::LoadKind;
use super::view::View;
use crate::frame::conditions::{Conditions, GivenLoad, LoadKind as Kind, Support, Table};

/// Arrows along a loaded edge.
const ARROWS: usize = 7;

/// Conditions on all blocks, if `first` is 0: blocks of the plane are not divided.
#[must_use]
pub fn conditions(view: &View<'_>, first: usize) -> Conditions {
    let setup = &view.world.setup;
    let mut out = Conditions { blocks: setup.blocks.len(), ..Conditions::default() };
    if first > 0 {
        return out;
    }
    out.loads = loads(view);
    out.supports = setup
        .supports
        .iter()
        .map(|s| Support { driven: s.motion.is_driven(), blocks: s.blocks.clone() })
        .collect();
    let [x, y] = setup.origin;
    let tables = setup.water.iter();
    let tables = tables.map(|table| Table::of(table, Vec3::new(x, 0.0, y), true));
    out.water = tables.collect();
    out.interfaces = setup.interfaces.iter().map(|i| i.name.clone()).collect();
    out.pairs.clone_from(&setup.pair_table);
    out
}

fn loads(view: &View<'_>) -> Vec<GivenLoad> {
    let (world, shapes) = (view.world, &view.scratch.shapes);
    let origin = Vec2::from(world.setup.origin);
    let mut out = Vec::new();
    for load in &world.setup.loads {
        let mut put = |kind: Kind, unit: &str, block: u32, at: Vec2, vector: [f64; 3]| {
            let at = at + origin;
            out.push(GivenLoad {
                kind,
                unit: unit.to_owned(),
                block,
                at: [at.x, at.y, 0.0],
                vector,
            });
        };
        let centre = |b: u32| shapes.centroid[b as usize];
        match &load.kind {
            LoadKind::Point { force, at, follows: _ } => {
                for &b in &load.blocks {
                    let vector = [force.x, force.y, 0.0];
                    put(Kind::Force, "N/m", b, at.unwrap_or(centre(b)), vector);
                }
            }
            LoadKind::Edge { from, to, traction, pressure } => {
                for &b in &load.blocks {
                    let body = |p: Vec2| p - centre(b);
                    let inward = -edge_normal(shapes, b as usize, body(*from), body(*to));
                    for k in 0..ARROWS {
                        let s = k as f64 / (ARROWS - 1) as f64;
                        let value = (1.0 - s) * pressure[0] + s * pressure[1];
                        let across = (1.0 - s) * traction[0] + s * traction[1];
                        let acts = value * inward + across;
                        let at = *from + s * (*to - *from);
                        put(Kind::Pressure, "Pa", b, at, [acts.x, acts.y, 0.0]);
                    }
                }
            }
            LoadKind::Moment { moment } => {
                for &b in &load.blocks {
                    put(Kind::Moment, "N", b, centre(b), [0.0, 0.0, *moment]);
                }
            }
            // Between blocks, not given by the scene.
            LoadKind::Own { .. } => {}
            LoadKind::BodyForce { acceleration } => {
                if let Some(&first) = load.blocks.first() {
                    let sum: Vec2 = load.blocks.iter().map(|b| centre(*b)).sum();
                    let middle = sum / load.blocks.len() as f64;
                    let vector = [acceleration.x, acceleration.y, 0.0];
                    put(Kind::Acceleration, "m/s2", first, middle, vector);
                }
            }
        }
    }
    out
}
