//! Blocks that go and the parts that take their places: what splitting and cutting have in common.

use std::collections::BTreeMap;
use std::ops::Range;

use riprap_geom::Vec3;
use riprap_geom::polyhedron::Tetrahedra;
use riprap_geom::polyhedron::cut::Part;

use crate::faces::deformable::centred;
use crate::faces::divisible::Divisible;
use crate::setup::{BlockSpec, Load, LoadKind, Setup, Shape};
use crate::state::bodies::Turned;
use crate::state::event::{EditEvent, EditKind, Note};
use crate::state::lineage::Origin;
use crate::state::world::World;

/// A block that is divided.
#[derive(Clone, Copy)]
pub(super) struct Family<'a> {
    pub(super) parent: u32,
    /// Number of the first part; the others follow.
    pub(super) first: u32,
    /// The parts, about the centroid of the block; none where it is split in eight.
    pub(super) parts: &'a [Part],
    /// Why and how it is cut.
    pub(super) note: Option<Note>,
}

impl Family<'_> {
    pub(super) fn children(&self) -> Range<u32> {
        self.first..self.first + if self.parts.is_empty() { 8 } else { self.parts.len() as u32 }
    }

    /// Parts that share a force or a moment on the whole, with the share of each.
    fn shares(&self) -> Vec<(Vec<u32>, f64)> {
        if self.parts.is_empty() {
            return vec![(self.children().collect(), 1.0 / 8.0)];
        }
        let volumes = || self.parts.iter().map(|p| p.mesh.volume());
        let whole: f64 = volumes().sum();
        self.children().zip(volumes()).map(|(b, volume)| (vec![b], volume / whole)).collect()
    }

    /// The part that holds a point, or comes nearest to it.
    fn holder(&self, setup: &Setup, point: Vec3) -> u32 {
        let shape = &setup.blocks[self.parent as usize].shape;
        if self.parts.is_empty() {
            return self.first + Divisible::of(shape).map_or(0, |w| u32::from(w.part_of(point)));
        }
        let (_, centre) = centred(shape);
        let beyond = |part: &Part| {
            let planes = (0..part.solid.faces.len()).map(|f| part.solid.plane(f));
            let heights = planes.map(|(n, d)| n.dot(point - centre) - d);
            heights.fold(f64::NEG_INFINITY, f64::max)
        };
        let parts = self.children().zip(self.parts);
        let nearest = parts.min_by(|a, b| beyond(a.1).total_cmp(&beyond(b.1)));
        nearest.map_or(self.first, |(b, _)| b)
    }

    /// The loads that take the place of one on the block.
    fn loads(&self, setup: &Setup, load: &Load) -> Vec<Load> {
        let on =
            |blocks, kind| Load { blocks, kind, time: load.time.clone(), account: load.account };
        let each = |kind: &dyn Fn(f64) -> LoadKind| {
            self.shares().into_iter().map(|(blocks, share)| on(blocks, kind(share))).collect()
        };
        match load.kind {
            LoadKind::Point { at: Some(point), .. } => {
                vec![on(vec![self.holder(setup, point)], load.kind.clone())]
            }
            LoadKind::Point { force, at: None } => {
                each(&|share| LoadKind::Point { force: share * force, at: None })
            }
            LoadKind::Moment { moment } => {
                each(&|share| LoadKind::Moment { moment: share * moment })
            }
            LoadKind::BodyForce { .. } | LoadKind::Own { .. } => Vec::new(),
            // The places of its nodes, where parts of it lie now.
            LoadKind::Nodes { ref forces } => {
                let shape = &setup.blocks[self.parent as usize].shape;
                let (solid, centre) = centred(shape);
                let Ok(mesh) = Tetrahedra::new(&solid) else { return Vec::new() };
                let at = |(node, force): &(u32, Vec3)| {
                    let place = centre + mesh.nodes[*node as usize];
                    let kind = LoadKind::Point { force: *force, at: Some(place) };
                    on(vec![self.holder(setup, place)], kind)
                };
                forces.iter().map(at).collect()
            }
        }
    }
}

/// Lets the lists of the setup follow: what names a divided block names its parts too. A force at a point goes to the part that holds it, one
/// at the centroid and a moment to all parts by volume.
pub(super) fn follow(setup: &mut Setup, families: &[Family]) {
    if families.is_empty() {
        return;
    }
    let of: BTreeMap<u32, &Family> = families.iter().map(|f| (f.parent, f)).collect();
    let extend = |blocks: &mut Vec<u32>| {
        let mut k = 0;
        // Parts can be divided in their turn.
        while let Some(b) = blocks.get(k) {
            let parts = of.get(b).map(|family| family.children());
            blocks.extend(parts.into_iter().flatten());
            k += 1;
        }
        blocks.sort_unstable();
        blocks.dedup();
    };
    setup.block_lists().for_each(extend);
    let mut k = 0;
    while let Some(load) = setup.loads.get_mut(k) {
        if let LoadKind::BodyForce { .. } | LoadKind::Own { .. } = load.kind {
            extend(&mut load.blocks);
        } else {
            let load = load.clone();
            let divided = load.blocks.iter().filter_map(|b| of.get(b));
            let made: Vec<Load> = divided.flat_map(|family| family.loads(setup, &load)).collect();
            setup.loads[k].blocks.retain(|b| !of.contains_key(b));
            setup.loads.extend(made);
        }
        k += 1;
    }
    setup.loads.retain(|load| !load.blocks.is_empty());
}

/// Appends part `octant` of a block to a setup, and where it comes from.
pub(super) fn describe(
    setup: &mut Setup,
    lineage: &mut Vec<Origin>,
    (parent, octant): (u32, u8),
    (shape, velocity): (Shape, Vec3),
) {
    let BlockSpec { name, material, spin, .. } = setup.blocks[parent as usize];
    setup.blocks.push(BlockSpec { shape, name, material, velocity, spin });
    let level = lineage[parent as usize].level + 1;
    lineage.push(Origin { parent, octant, level });
}

/// Motion and mass of a part.
pub(super) struct Moving {
    /// Index into `World::solids`.
    pub(super) solid: usize,
    /// From the centroid of the block to that of the part at the start, m; zero where nodes have the motion.
    pub(super) lever: Vec3,
    pub(super) centre: Vec3,
    pub(super) displacement: [Vec3; 2],
    pub(super) velocity: [Vec3; 2],
    pub(super) turned: Option<Box<Turned>>,
}

/// Appends a part of a block, which has been described, to the lists of the world.
pub(super) fn append(world: &mut World, parent: usize, part: Moving) {
    let child = world.bodies.push(part.displacement, part.velocity);
    if !world.datum.is_empty() {
        let [shift, turn] = world.datum(parent);
        let shift = if part.lever == Vec3::ZERO { shift } else { shift + turn.cross(part.lever) };
        world.datum.resize(child, [Vec3::ZERO; 2]);
        world.datum.push([shift, turn]);
    }
    world.reference.push(part.centre);
    world.solid.push(part.solid as u32);
    world.turned.push(part.turned);
    world.alive.push(true);
    world.motion.push(world.motion[parent].clone());
    world.peak_speed_squared.push(world.peak_speed_squared[parent]);
}

/// Notes that a block has been divided; `patches` counts those of the block before and of its parts after.
pub(super) fn record(world: &mut World, family: &Family, patches: [u32; 2]) {
    let kind = if family.note.is_some() { EditKind::Cut } else { EditKind::Split };
    let event = EditEvent {
        children: family.children().collect(),
        patches,
        cut: family.note,
        ..world.event(kind, family.parent)
    };
    world.events.push(event);
}
