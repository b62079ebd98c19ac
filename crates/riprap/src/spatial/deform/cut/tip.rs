//! Where a crack ends: the front of the broken facets.

use std::collections::{BTreeMap, BTreeSet};

use riprap_geom::Vec3;
use riprap_geom::polyhedron::Polyhedron;

use super::Anchor;
use crate::spatial::deform::cracks::outline;
use crate::spatial::deform::store::Deform;
use crate::spatial::deform::workspace::centred;
use crate::spatial::fields::View;
use crate::spatial::world::World;

/// Distance below which a point is on a face, over the edge of a cube of the mean volume.
const NEAR: f64 = 3e-3;

/// Points of the front.
pub struct Front {
    /// Middles of the edges at which broken facets end inside the rock, m (local).
    pub points: Vec<Vec3>,
    near: f64,
}

/// Outline of a facet.
struct Area {
    corners: Vec<Vec3>,
    normal: Vec3,
    low: Vec3,
    high: Vec3,
}

impl Area {
    fn new(corners: Vec<Vec3>, normal: Vec3) -> Self {
        let low = corners.iter().fold(Vec3::INFINITY, |m, p| m.min(*p));
        let high = corners.iter().fold(Vec3::NEG_INFINITY, |m, p| m.max(*p));
        Self {
            corners,
            normal,
            low,
            high,
        }
    }

    /// Whether a point is on it, its rim included.
    fn holds(&self, at: Vec3, near: f64) -> bool {
        let slack = Vec3::splat(near);
        if at.cmplt(self.low - slack).any() || at.cmpgt(self.high + slack).any() {
            return false;
        }
        let count = self.corners.len();
        (self.normal.dot(at - self.corners[0])).abs() <= near
            && (0..count).all(|k| {
                let (p, q) = (self.corners[k], self.corners[(k + 1) % count]);
                let inward = self.normal.cross(q - p).normalize_or_zero();
                inward.dot(at - p) >= -near
            })
    }
}

impl Area {
    /// Distance of a point, m.
    fn distance(&self, at: Vec3) -> f64 {
        let Some(&first) = self.corners.first() else {
            return f64::INFINITY;
        };
        let foot = at - self.normal.dot(at - first) * self.normal;
        if self.holds(foot, 0.0) {
            return foot.distance(at);
        }
        let count = self.corners.len();
        let edges = (0..count).map(|k| {
            let (p, q) = (self.corners[k], self.corners[(k + 1) % count]);
            let along = q - p;
            let share = (at - p).dot(along) / along.length_squared().max(f64::MIN_POSITIVE);
            at.distance(p + share.clamp(0.0, 1.0) * along)
        });
        edges.fold(f64::INFINITY, f64::min)
    }
}

impl Front {
    /// Finds the front of what is broken.
    #[must_use]
    pub fn new(world: &World, deform: &Deform) -> Self {
        let near = near(world, deform);
        let areas: Vec<Area> = deform
            .facets
            .iter()
            .map(|f| Area::new(outline(world, f), f.frame[0]))
            .collect();
        let broken: Vec<usize> = (0..areas.len()).filter(|k| is_broken(deform, *k)).collect();
        let mut of: BTreeMap<u32, Vec<usize>> = BTreeMap::new();
        for (k, facet) in deform.facets.iter().enumerate() {
            for b in facet.blocks {
                of.entry(b).or_default().push(k);
            }
        }
        let mut points: Vec<Vec3> = Vec::new();
        for &k in &broken {
            let corners = &areas[k].corners;
            for c in 0..corners.len() {
                let at = 0.5 * (corners[c] + corners[(c + 1) % corners.len()]);
                let goes_on = broken.iter().any(|j| *j != k && areas[*j].holds(at, near));
                let ends = deform.facets[k].blocks;
                let n = areas[k].normal;
                let inside = || {
                    ends.iter()
                        .all(|b| covered(world, *b, at, n, near, &of, &areas))
                };
                if !goes_on && inside() && !points.iter().any(|p| p.distance(at) <= near) {
                    points.push(at);
                }
            }
        }
        Self { points, near }
    }

    /// The first point of the front that a block touches.
    #[must_use]
    pub fn touching(&self, world: &World, block: u32) -> Option<Vec3> {
        if self.points.is_empty() {
            return None;
        }
        let (solid, centre) = centred(&world.setup.blocks[block as usize].shape);
        let beyond = |at: Vec3| {
            let planes = (0..solid.faces.len()).map(|f| solid.plane(f));
            planes
                .map(|(n, d)| n.dot(at - centre) - d)
                .fold(f64::NEG_INFINITY, f64::max)
        };
        let mut points = self.points.iter().copied();
        points.find(|at| beyond(*at) <= self.near)
    }
}

/// Length below which points are the same, m.
fn near(world: &World, deform: &Deform) -> f64 {
    let given = deform.given.unwrap_or(u32::MAX);
    let bodies = deform.bodies.iter().filter(|b| b.block < given);
    let volumes = bodies.map(|b| world.solid_of(b.block as usize).volume);
    let (count, sum) = volumes.fold((0.0, 0.0), |(n, s), v| (n + 1.0, s + v));
    NEAR * f64::cbrt(sum / f64::max(count, 1.0))
}

fn is_broken(deform: &Deform, k: usize) -> bool {
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

/// Facets that may break now, where breaking is for tips only; `None` where all may.
#[must_use]
pub fn may_break(world: &World, deform: &Deform) -> Option<BTreeSet<u32>> {
    let rules = deform.cutting?.rules;
    let Anchor::Tip { only_cut } = rules.anchor else {
        return None;
    };
    let front = Front::new(world, deform);
    let siblings = |[a, b]: [u32; 2]| {
        let parent = |b: u32| world.lineage[b as usize].parent;
        parent(a) == parent(b) && Some(a) >= deform.given && Some(b) >= deform.given
    };
    let chosen = deform.facets.iter().enumerate().filter(|(_, facet)| {
        if only_cut && !siblings(facet.blocks) {
            return false;
        }
        let area = Area::new(outline(world, facet), facet.frame[0]);
        front.points.iter().any(|at| area.holds(*at, front.near))
    });
    Some(chosen.map(|(k, _)| k as u32).collect())
}

/// Distance (m) of a point (local) from the nearest broken facet, at the start.
#[must_use]
pub fn distance(view: &View<'_>, at: Vec3) -> f64 {
    let Some((deform, _)) = view.softs() else {
        return f64::NAN;
    };
    let broken = (0..deform.facets.len()).filter(|k| is_broken(deform, *k));
    let distances = broken.map(|k| {
        let facet = &deform.facets[k];
        Area::new(outline(view.world, facet), facet.frame[0]).distance(at)
    });
    distances.fold(f64::INFINITY, f64::min)
}
