//! Where a crack ends: the front of the broken facets.

use std::collections::BTreeMap;

use riprap_geom::Vec3;
use riprap_geom::polyhedron::Polyhedron;

use crate::deform::area::Area;
use crate::faces::deformable::{centred, outline};
use crate::setup::deform::CutAnchor as Anchor;
use crate::state::deform::Deform;
use crate::state::lineage::ancestor;
use crate::state::world::World;

/// Distance below which a point is on a face, over the edge of a cube of the mean volume: above what snapping moves a plane by.
const NEAR: f64 = 1e-2;
/// Cosine of the angle to the heading of a crack below which something does not lie ahead of it.
const AHEAD: f64 = 0.2;

/// The front of cracks.
pub struct Front {
    /// Where broken facets end inside the rock.
    pub tips: Vec<Tip>,
    near: f64,
}

/// A place at which a crack ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tip {
    /// Middle of the edge of the last broken facet, m (local).
    pub at: Vec3,
    /// Unit vector from that facet to it.
    pub heading: Vec3,
}

impl Tip {
    /// Whether a place lies ahead.
    #[must_use]
    pub fn leads_to(&self, place: Vec3) -> bool {
        self.heading.dot((place - self.at).normalize_or_zero()) > AHEAD
    }
}

impl Front {
    /// Finds the front of what is broken.
    #[must_use]
    pub fn new(world: &World, deform: &Deform) -> Self {
        let near = near(world, deform);
        let areas: Vec<Area> =
            deform.facets.iter().map(|f| Area::new(outline(world, f), f.frame[0])).collect();
        let broken: Vec<usize> = broken(deform).collect();
        let mut of: BTreeMap<u32, Vec<usize>> = BTreeMap::new();
        for (k, facet) in deform.facets.iter().enumerate() {
            for b in facet.blocks {
                of.entry(b).or_default().push(k);
            }
        }
        let mut tips: Vec<Tip> = Vec::new();
        for &k in &broken {
            let corners = &areas[k].corners;
            for c in 0..corners.len() {
                let at = 0.5 * (corners[c] + corners[(c + 1) % corners.len()]);
                let goes_on = broken.iter().any(|j| *j != k && areas[*j].holds(at, near));
                let ends = deform.facets[k].blocks;
                let n = areas[k].normal;
                let inside = || ends.iter().all(|b| covered(world, *b, at, n, near, &of, &areas));
                if !goes_on && inside() && !tips.iter().any(|t| t.at.distance(at) <= near) {
                    let heading = (at - areas[k].middle()).normalize_or_zero();
                    tips.push(Tip { at, heading });
                }
            }
        }
        Self { tips, near }
    }

    /// The first tip that a block touches and from which no facet between parts of the same block leads on.
    #[must_use]
    pub fn touching(&self, world: &World, deform: &Deform, block: u32) -> Option<Tip> {
        if self.tips.is_empty() {
            return None;
        }
        let (solid, centre) = centred(&world.setup.blocks[block as usize].shape);
        let beyond = |at: Vec3| {
            let planes = (0..solid.faces.len()).map(|f| solid.plane(f));
            planes.map(|(n, d)| n.dot(at - centre) - d).fold(f64::NEG_INFINITY, f64::max)
        };
        let touched = self.tips.iter().filter(|t| beyond(t.at) <= self.near);
        let root = root(world, deform, block);
        touched.copied().find(|tip| !self.leads_on(world, deform, tip, root))
    }

    /// Whether a facet that is not broken, between parts of the block `root`, leads on from a tip.
    fn leads_on(&self, world: &World, deform: &Deform, tip: &Tip, root: u32) -> bool {
        let mut facets = deform.facets.iter().enumerate();
        facets.any(|(k, facet)| {
            let inside = facet.blocks[0] != facet.blocks[1]
                && facet.blocks.iter().all(|b| self::root(world, deform, *b) == root);
            if !inside || is_broken(deform, k) || !tip.leads_to(facet.centre) {
                return false;
            }
            Area::new(outline(world, facet), facet.frame[0]).holds(tip.at, self.near)
        })
    }
}

/// The given block that a part comes from.
fn root(world: &World, deform: &Deform, block: u32) -> u32 {
    ancestor(&world.lineage, block, deform.given.unwrap_or(u32::MAX))
}

/// Length below which points are the same, m.
pub(crate) fn near(world: &World, deform: &Deform) -> f64 {
    let given = deform.given.unwrap_or(u32::MAX);
    // Of blocks as given: the length must not shrink as they are cut.
    let bodies = deform.bodies.iter().filter(|b| b.block < given);
    let volumes = bodies.map(|b| world.solid_of(b.block as usize).volume);
    let (count, sum) = volumes.fold((0.0, 0.0), |(n, s), v| (n + 1.0, s + v));
    NEAR * libm::cbrt(sum / f64::max(count, 1.0))
}

/// Numbers of the broken facets.
pub fn broken(deform: &Deform) -> impl Iterator<Item = usize> + '_ {
    (0..deform.facets.len()).filter(|k| is_broken(deform, *k))
}

/// Whether more than half of the points of facet `k` are broken.
#[must_use]
pub fn is_broken(deform: &Deform, k: usize) -> bool {
    let points = &deform.memory[deform.facets[k].points()];
    2 * points.iter().filter(|m| m.state.is_broken()).count() > points.len()
}

/// Whether all faces of a block at a point, but those along the crack with the normal `n`, are shared with others there.
fn covered(
    world: &World,
    block: u32,
    at: Vec3,
    n: Vec3,
    near: f64,
    of: &BTreeMap<u32, Vec<usize>>,
    areas: &[Area],
) -> bool {
    let (solid, centre) = centred(&world.setup.blocks[block as usize].shape);
    let solid: Polyhedron = solid;
    (0..solid.faces.len()).all(|f| {
        let (normal, offset) = solid.plane(f);
        let away = (normal.dot(at - centre) - offset).abs() > near;
        let along = normal.dot(n).abs() > 1.0 - 1e-6;
        let shared = || {
            let own = of.get(&block).into_iter().flatten();
            own.copied()
                .any(|k| areas[k].normal.dot(normal).abs() > 0.999 && areas[k].holds(at, near))
        };
        away || along || shared()
    })
}

/// Facets that may break now and the tips that they hold, where breaking is for tips only; `None` where all may.
#[must_use]
pub fn may_break(world: &World, deform: &Deform) -> Option<BTreeMap<u32, Vec<usize>>> {
    let rules = deform.cutting?.rules;
    match rules.anchor {
        Anchor::Spacing => return None,
        Anchor::Tip => {}
    }
    let front = Front::new(world, deform);
    let siblings = |[a, b]: [u32; 2]| root(world, deform, a) == root(world, deform, b);
    let mut chosen: BTreeMap<u32, Vec<usize>> = BTreeMap::new();
    // Tips from which a facet made by cutting leads on: a crack along an old face, which cannot be cut, has none.
    let mut led = vec![false; front.tips.len()];
    for (k, facet) in deform.facets.iter().enumerate() {
        let area = Area::new(outline(world, facet), facet.frame[0]);
        let held = |n: &usize| area.holds(front.tips[*n].at, front.near);
        let tips: Vec<usize> = (0..front.tips.len()).filter(held).collect();
        if tips.is_empty() || is_broken(deform, k) {
            continue;
        }
        if siblings(facet.blocks) {
            for n in &tips {
                led[*n] |= front.tips[*n].leads_to(facet.centre);
            }
        }
        chosen.insert(k as u32, tips);
    }
    if rules.only_cut {
        for (k, tips) in &mut chosen {
            let cut = siblings(deform.facets[*k as usize].blocks);
            tips.retain(|n| cut || !led[*n]);
        }
        chosen.retain(|_, tips| !tips.is_empty());
    }
    Some(chosen)
}
