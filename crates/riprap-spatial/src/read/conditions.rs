//! What holds, moves and loads a model in space, as pictures show it.

use riprap_geom::Vec3;

use crate::frame::conditions::{
    Conditions, FaceCondition, FaceKind, GivenLoad, LoadKind as Kind, Support, Table,
};
use crate::query::view::View;
use crate::setup::{BoundaryKind, LoadKind};

/// Conditions on the blocks with numbers from `first` on. What is not about single blocks is told with the first of them.
#[must_use]
pub fn conditions(view: &View<'_>, first: usize) -> Conditions {
    let mut out = Conditions {
        blocks: view.world.alive.len(),
        faces: faces(view, first),
        ..Conditions::default()
    };
    out.thin();
    if first > 0 {
        return out;
    }
    let setup = &view.world.setup;
    out.loads = loads(view);
    out.supports = setup
        .supports
        .iter()
        .map(|s| Support { driven: s.motion.is_driven(), blocks: s.blocks.clone() })
        .collect();
    let tables = setup.water.iter();
    let tables = tables.map(|table| Table::of(table, setup.origin, false));
    out.water = tables.collect();
    out.interfaces = setup.interfaces.iter().map(|i| i.name.clone()).collect();
    out.pairs.clone_from(&setup.pair_table);
    out
}

fn faces(view: &View<'_>, first: usize) -> Vec<FaceCondition> {
    let world = view.world;
    let boundaries = world.setup.boundaries.iter();
    let mut all: Vec<FaceCondition> = boundaries
        .map(|b| FaceCondition {
            name: b.name.clone(),
            kind: kind(&b.kind),
            count: 0,
            blocks: Vec::new(),
            centres: Vec::new(),
            tractions: Vec::new(),
        })
        .collect();
    for face in world.faces.iter().filter(|f| f.block as usize >= first) {
        let Some(number) = face.boundary else {
            continue;
        };
        let condition = &mut all[usize::from(number)];
        condition.count += 1;
        condition.blocks.push(face.block);
        let centre = world.reference[face.block as usize] + face.arm;
        condition.centres.push((centre + world.setup.origin).to_array());
        if let BoundaryKind::Traction { traction, pressure, gradient, datum, time: _ } =
            &world.setup.boundaries[usize::from(number)].kind
        {
            let pressure = pressure + gradient * (datum - centre.z);
            let acts = *traction - pressure * face.frame[0];
            condition.tractions.push(acts.to_array());
        }
    }
    all
}

fn kind(kind: &BoundaryKind) -> FaceKind {
    match kind {
        BoundaryKind::Held { normal, shear } => match (normal, shear) {
            (true, false) => FaceKind::Roller,
            (false, true) => FaceKind::HeldAlong,
            (true, true) | (false, false) => FaceKind::Held,
        },
        BoundaryKind::Moved { .. } => FaceKind::Moved,
        BoundaryKind::Viscous { .. } => FaceKind::Viscous,
        BoundaryKind::Traction { .. } => FaceKind::Loaded,
    }
}

fn loads(view: &View<'_>) -> Vec<GivenLoad> {
    let world = view.world;
    let origin = world.setup.origin;
    let mut out = Vec::new();
    for load in &world.setup.loads {
        let mut put = |kind: Kind, unit: &str, block: u32, at: Vec3, vector: Vec3| {
            out.push(GivenLoad {
                kind,
                unit: unit.to_owned(),
                block,
                at: (at + origin).to_array(),
                vector: vector.to_array(),
            });
        };
        let centre = |b: u32| world.reference[b as usize];
        match &load.kind {
            LoadKind::Point { force, at } => {
                for &b in &load.blocks {
                    put(Kind::Force, "N", b, at.unwrap_or(centre(b)), *force);
                }
            }
            LoadKind::Moment { moment } => {
                for &b in &load.blocks {
                    put(Kind::Moment, "N m", b, centre(b), *moment);
                }
            }
            LoadKind::Nodes { forces } => {
                let deform = world.deform.as_deref();
                let block = load.blocks.first().copied().unwrap_or_default();
                let body = deform.and_then(|d| d.body(block as usize));
                for (node, force) in forces {
                    let place = deform.zip(body);
                    let place = place.map(|(d, body)| d.nodes.place[(body.first + node) as usize]);
                    put(Kind::Force, "N", block, place.unwrap_or(centre(block)), *force);
                }
            }
            // Between blocks, not given by the scene.
            LoadKind::Own { .. } => {}
            LoadKind::BodyForce { acceleration } => {
                if let Some(&first) = load.blocks.first() {
                    let sum: Vec3 = load.blocks.iter().map(|b| centre(*b)).sum();
                    let middle = sum / load.blocks.len() as f64;
                    put(Kind::Acceleration, "m/s2", first, middle, *acceleration);
                }
            }
        }
    }
    out
}
