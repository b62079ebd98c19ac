//! What names a block that is split names its parts from then on.

use crate::faces::divisible::Divisible;
use crate::setup::{Load, LoadKind, Setup};
use crate::state::lineage::Origin;

/// Lets the lists of the setup follow splits: who named a split block names its children too.
///
/// A force at a point goes to the child that holds the point, a force at the centroid and a moment to all eight in
/// equal parts.
pub(crate) fn follow(setup: &mut Setup, lineage: &[Origin], splits: &[u32]) {
    if splits.is_empty() {
        return;
    }
    let mut first_child = vec![0u32; setup.blocks.len()];
    let start = lineage.len() - 8 * splits.len();
    for (k, &parent) in splits.iter().enumerate() {
        first_child[parent as usize] = (start + 8 * k) as u32;
    }
    let extend = |blocks: &mut Vec<u32>| {
        let mut k = 0;
        while k < blocks.len() {
            let first = first_child[blocks[k] as usize];
            if first != 0 {
                blocks.extend(first..first + 8);
            }
            k += 1;
        }
        blocks.sort_unstable();
        blocks.dedup();
    };
    setup.block_lists().for_each(extend);
    let mut k = 0;
    while k < setup.loads.len() {
        match setup.loads[k].kind {
            LoadKind::BodyForce { .. } => extend(&mut setup.loads[k].blocks),
            LoadKind::Point { .. } | LoadKind::Moment { .. } => {
                let made = shares(setup, &setup.loads[k], &first_child);
                setup.loads[k].blocks.retain(|&b| first_child[b as usize] == 0);
                setup.loads.extend(made);
            }
        }
        k += 1;
    }
    setup.loads.retain(|l| !l.blocks.is_empty());
}

/// The parts of a load that go to the children of its split blocks.
fn shares(setup: &Setup, load: &Load, first_child: &[u32]) -> Vec<Load> {
    let mut made = Vec::new();
    for &b in &load.blocks {
        let first = first_child[b as usize];
        if first == 0 {
            continue;
        }
        let all: Vec<u32> = (first..first + 8).collect();
        let (blocks, kind) = match load.kind {
            LoadKind::Point { force, at: Some(point) } => {
                let whole = Divisible::of(&setup.blocks[b as usize].shape);
                let part = whole.map_or(0, |whole| whole.part_of(point));
                (vec![first + u32::from(part)], LoadKind::Point { force, at: Some(point) })
            }
            LoadKind::Point { force, at: None } => {
                (all, LoadKind::Point { force: force / 8.0, at: None })
            }
            LoadKind::Moment { moment } => (all, LoadKind::Moment { moment: moment / 8.0 }),
            LoadKind::BodyForce { .. } => continue,
        };
        made.push(Load { blocks, kind, time: load.time.clone(), account: load.account });
    }
    made
}
