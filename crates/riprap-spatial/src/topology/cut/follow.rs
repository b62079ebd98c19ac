//! Lists of the setup that name blocks: who named a cut block names its parts.

use std::collections::BTreeMap;

use riprap_geom::polyhedron::cut::Part;

use crate::faces::deformable::centred;
use crate::setup::{Load, LoadKind, Setup};
use crate::topology::cut::plan::Family;

/// Lets groups, supports, boundaries, sources and loads follow. A force at a point goes to the part that holds it, one without a point
/// to all parts by volume.
pub(super) fn follow(setup: &mut Setup, families: &[Family]) {
    let of: BTreeMap<u32, &Family> = families.iter().map(|f| (f.cut.block, f)).collect();
    let extend = |blocks: &mut Vec<u32>| {
        let found: Vec<u32> =
            blocks.iter().filter_map(|b| of.get(b)).flat_map(|f| f.children()).collect();
        blocks.extend(found);
        blocks.sort_unstable();
        blocks.dedup();
    };
    setup.block_lists().for_each(extend);
    let (mut loads, mut made) = (Vec::new(), Vec::new());
    for load in &setup.loads {
        let mut left = load.clone();
        if let LoadKind::BodyForce { .. } = load.kind {
            extend(&mut left.blocks);
        } else {
            left.blocks.retain(|b| !of.contains_key(b));
            for family in load.blocks.iter().filter_map(|b| of.get(b)) {
                shares(setup, load, family, &mut made);
            }
        }
        if !left.blocks.is_empty() {
            loads.push(left);
        }
    }
    loads.extend(made);
    setup.loads = loads;
}

/// The loads of the parts that take the place of one on their parent.
fn shares(setup: &Setup, load: &Load, family: &Family, made: &mut Vec<Load>) {
    let parts = &family.cut.parts;
    let mut push = |k: usize, kind: LoadKind| {
        made.push(Load {
            blocks: vec![family.first + k as u32],
            kind,
            time: load.time.clone(),
            account: load.account,
        });
    };
    match &load.kind {
        LoadKind::Point { force, at: Some(point) } => {
            let (_, centre) = centred(&setup.blocks[family.cut.block as usize].shape);
            let beyond = |part: &Part| {
                let planes = (0..part.solid.faces.len()).map(|f| part.solid.plane(f));
                let heights = planes.map(|(n, d)| n.dot(*point - centre) - d);
                heights.fold(f64::NEG_INFINITY, f64::max)
            };
            // The part that holds it, or comes nearest to it.
            let nearest = |a: &usize, b: &usize| beyond(&parts[*a]).total_cmp(&beyond(&parts[*b]));
            let holder = (0..parts.len()).min_by(nearest).unwrap_or(0);
            let kind = LoadKind::Point { force: *force, at: Some(*point) };
            push(holder, kind);
        }
        LoadKind::Point { force, at: None } => {
            let volumes: Vec<f64> = parts.iter().map(|p| p.mesh.volume()).collect();
            let whole: f64 = volumes.iter().sum();
            for (k, volume) in volumes.iter().enumerate() {
                let force = volume / whole * *force;
                push(k, LoadKind::Point { force, at: None });
            }
        }
        LoadKind::Moment { .. } | LoadKind::BodyForce { .. } => {}
    }
}
