//! Which pairs can touch, and with which edges: the candidate list.
//!
//! The list is built from the poses in `World::search_pose` alone, so that it can be dropped and
//! rebuilt at any time. It stays valid while no block has moved (or turned, at its radius) by more
//! than its margin. Blocks go into grids of doubling cell size by their own size; each block looks
//! into the grids of its own level and above, so that cost grows linearly however mixed the sizes.
//!
//! For every pair the edges that can reach the other block's margin box are listed, and of the
//! other block the edges that can be the nearest boundary anywhere in that box. The lists are
//! conservative: leaving an edge out never changes a result.

use riprap_geom::Vec2;

use super::convex::MAX_NEAREST;
use super::setup::{FrictionLaw, Motion, NormalLaw, Setup};
use super::shapes::{Edge, Shapes};
use super::world::{Contact, GeneralState, PairState, Region, World};
use crate::dynamics::kick::Target;
use crate::laws::damping;

/// Margin of a block over its size (the smaller of its radius and twice the median radius).
const MARGIN: f64 = 0.08;

/// A pair that can touch, with the ranges of its edge lists in [`Candidates::lists`].
#[derive(Clone, Copy, Debug)]
pub struct Candidate {
    /// First block; the smaller index.
    pub i: u32,
    /// Second block.
    pub j: u32,
    /// Row of the interface table.
    pub row: u16,
    /// Numbers of: edges of i, nearest edges of j, edges of j, nearest edges of i.
    counts: [u16; 4],
    start: u32,
    /// Dashpot coefficients across and along the contact over the root of its length.
    pub dashpots: [f64; 2],
    /// Upper bound of the contact length, m.
    pub longest: f64,
}

impl Candidate {
    /// The four edge lists: edges of i, nearest edges of j, edges of j, nearest edges of i.
    #[must_use]
    pub fn lists<'a>(&self, all: &'a [u16]) -> [&'a [u16]; 4] {
        let mut at = self.start as usize;
        self.counts.map(|n| {
            let list = &all[at..at + n as usize];
            at += n as usize;
            list
        })
    }
}

/// All candidate pairs.
#[derive(Clone, Debug, Default)]
pub struct Candidates {
    /// Pairs of convex blocks under the distance potential, sorted by (i, j).
    pub convex: Vec<Candidate>,
    /// All other pairs, sorted by (i, j).
    pub general: Vec<Candidate>,
    /// Edge lists.
    pub lists: Vec<u16>,
    /// Margin of each block, m.
    pub margin: Vec<f64>,
    /// The smallest inradius of each block and its partners, m.
    pub reach: Vec<f64>,
}

/// Whether a block's translation is prescribed in both directions.
#[must_use]
pub(crate) fn is_driven(motion: Option<&Motion>) -> bool {
    motion.is_some_and(|m| m.targets()[..2].iter().all(|t| !t.is_free()))
}

/// Whether a block is fixed in all three freedoms: two such blocks never act on each other.
pub(crate) fn is_fixed(motion: Option<&Motion>) -> bool {
    motion.is_some_and(|m| m.targets() == [Target::Still; 3])
}

/// Whether all three freedoms of a block are prescribed.
#[must_use]
pub(crate) fn is_held(motion: Option<&Motion>) -> bool {
    motion.is_some_and(|m| m.targets().iter().all(|t| !t.is_free()))
}

#[derive(Clone, Copy)]
struct Box2 {
    low: Vec2,
    high: Vec2,
}

impl Box2 {
    fn meets(&self, other: &Self) -> bool {
        self.low.x <= other.high.x
            && other.low.x <= self.high.x
            && self.low.y <= other.high.y
            && other.low.y <= self.high.y
    }

    fn corners(&self) -> [Vec2; 4] {
        [
            self.low,
            Vec2::new(self.high.x, self.low.y),
            self.high,
            Vec2::new(self.low.x, self.high.y),
        ]
    }
}

/// Corners and normals of a block at a pose, relative to `origin`.
struct Placed {
    start: Vec<Vec2>,
    normal: Vec<Vec2>,
    offset: Vec<f64>,
}

fn place(edges: &[Edge], pose: (Vec2, f64), origin: Vec2) -> Placed {
    let (s, c) = libm::sincos(pose.1);
    let turn = |v: Vec2| Vec2::new(c * v.x - s * v.y, s * v.x + c * v.y);
    let shift = pose.0 - origin;
    let normal: Vec<Vec2> = edges.iter().map(|e| turn(e.normal)).collect();
    Placed {
        start: edges.iter().map(|e| turn(e.start) + shift).collect(),
        offset: edges
            .iter()
            .zip(&normal)
            .map(|(e, n)| e.normal.dot(e.start) + n.dot(shift))
            .collect(),
        normal,
    }
}

/// Builds the list from `world.search_pose` and moves the contact states over to it.
pub(crate) fn rebuild(world: &mut World, shapes: &Shapes, candidates: &mut Candidates) {
    candidates.margin = margins(world, shapes);
    candidates.reach.clone_from(&shapes.inradius);
    candidates.convex.clear();
    candidates.general.clear();
    candidates.lists.clear();

    let boxes = boxes(world, shapes, &candidates.margin);
    let bonded = bonded_pairs(world);
    for (i, j) in close_pairs(&boxes, &world.alive, shapes) {
        if bonded.binary_search(&(i, j)).is_ok() {
            continue;
        }
        let (a, b) = (i as usize, j as usize);
        if is_fixed(world.motion[a].as_deref()) && is_fixed(world.motion[b].as_deref()) {
            continue;
        }
        add_pair(world, shapes, candidates, &boxes, a, b);
    }
    carry_states(world, candidates);
}

/// Pairs of living blocks that are near each other at the search poses, sorted, held ones too.
#[must_use]
pub(crate) fn near_pairs(world: &World, shapes: &Shapes) -> Vec<(u32, u32)> {
    close_pairs(&boxes(world, shapes, &margins(world, shapes)), &world.alive, shapes)
}

/// Margin of each block, m.
fn margins(world: &World, shapes: &Shapes) -> Vec<f64> {
    let living = (0..shapes.len()).filter(|&b| world.alive[b]);
    let mut radii: Vec<f64> = living.map(|b| shapes.radius[b]).collect();
    radii.sort_by(f64::total_cmp);
    let median = radii.get(radii.len() / 2).copied().unwrap_or(0.0);
    shapes.radius.iter().map(|r| MARGIN * r.min(2.0 * median)).collect()
}

fn boxes(world: &World, shapes: &Shapes, margin: &[f64]) -> Vec<Box2> {
    (0..shapes.len())
        .map(|b| {
            let (position, angle) = world.search_pose[b];
            let (s, c) = libm::sincos(angle);
            let (mut low, mut high) = (Vec2::INFINITY, Vec2::NEG_INFINITY);
            for e in shapes.of(b) {
                let v = Vec2::new(c * e.start.x - s * e.start.y, s * e.start.x + c * e.start.y);
                low = low.min(v);
                high = high.max(v);
            }
            let grow = Vec2::splat(margin[b]);
            Box2 { low: position + low - grow, high: position + high + grow }
        })
        .collect()
}

fn bonded_pairs(world: &World) -> Vec<(u32, u32)> {
    let mut pairs: Vec<(u32, u32)> =
        world.bonds.iter().filter(|b| b.active).map(|b| (b.i, b.j)).collect();
    pairs.sort_unstable();
    pairs.dedup();
    pairs
}

/// Pairs of living blocks whose boxes meet, sorted.
fn close_pairs(boxes: &[Box2], alive: &[bool], shapes: &Shapes) -> Vec<(u32, u32)> {
    let size = |b: usize| {
        let d = boxes[b].high - boxes[b].low;
        d.x.max(d.y)
    };
    let living: Vec<usize> = (0..shapes.len()).filter(|&b| alive[b]).collect();
    let smallest = living.iter().map(|&b| size(b)).fold(f64::INFINITY, f64::min);
    if !smallest.is_finite() || smallest <= 0.0 {
        return Vec::new();
    }
    let level_of = |b: usize| libm::log2(size(b) / smallest).ceil().max(0.0) as usize;
    let levels = living.iter().map(|&b| level_of(b)).max().unwrap_or(0) + 1;
    // Entry: cell row, cell column, block; sorted, so that a row of cells is one range.
    let mut grids: Vec<Vec<(i64, i64, u32)>> = vec![Vec::new(); levels];
    // Beyond 63 bits there is no shift.
    let cell = |level: usize| smallest * (1u64 << level.min(60)) as f64;
    for &b in &living {
        let level = level_of(b);
        let centre = 0.5 * (boxes[b].low + boxes[b].high) / cell(level);
        grids[level].push((centre.y.floor() as i64, centre.x.floor() as i64, b as u32));
    }
    for grid in &mut grids {
        grid.sort_unstable();
    }
    let mut pairs = Vec::new();
    for &b in &living {
        let own = level_of(b);
        for (level, grid) in grids.iter().enumerate().skip(own) {
            if grid.is_empty() {
                continue;
            }
            // A block of this level reaches at most half a cell from its centre.
            let half = Vec2::splat(0.5 * cell(level));
            let low = (boxes[b].low - half) / cell(level);
            let high = (boxes[b].high + half) / cell(level);
            let (x0, x1) = (low.x.floor() as i64, high.x.floor() as i64);
            for y in low.y.floor() as i64..=high.y.floor() as i64 {
                let from = grid.partition_point(|&(gy, gx, _)| (gy, gx) < (y, x0));
                for &(_, _, other) in
                    grid[from..].iter().take_while(|&&(gy, gx, _)| gy == y && gx <= x1)
                {
                    let o = other as usize;
                    // Of two of one level the smaller number looks, of two levels the smaller block.
                    if (level == own && o <= b) || !boxes[b].meets(&boxes[o]) {
                        continue;
                    }
                    pairs.push(((b as u32).min(other), (b as u32).max(other)));
                }
            }
        }
    }
    pairs.sort_unstable();
    pairs
}

fn add_pair(
    world: &World,
    shapes: &Shapes,
    candidates: &mut Candidates,
    boxes: &[Box2],
    a: usize,
    b: usize,
) {
    let origin = world.search_pose[a].0;
    let pa = place(shapes.of(a), world.search_pose[a], origin);
    let pb = place(shapes.of(b), world.search_pose[b], origin);
    let gap = candidates.margin[a] + candidates.margin[b];
    if separated(&pa, &pb, shapes.convex[b], gap) || separated(&pb, &pa, shapes.convex[a], gap) {
        return;
    }
    let region = Box2 {
        low: boxes[a].low.max(boxes[b].low) - origin,
        high: boxes[a].high.min(boxes[b].high) - origin,
    };
    let start = candidates.lists.len();
    let (counts, longest) = list_edges(shapes, candidates, &region, [a, b], [&pa, &pb]);
    if counts[0] == 0 || counts[2] == 0 {
        candidates.lists.truncate(start);
        return;
    }
    let row = row_of(&world.setup, a, b);
    let mass = pair_mass(&world.motion, shapes, [a, b]);
    let law = &world.setup.interfaces[row as usize].contact;
    let candidate = Candidate {
        i: a as u32,
        j: b as u32,
        row,
        counts,
        start: start as u32,
        dashpots: [law.normal_stiffness, law.shear_stiffness]
            .map(|k| damping::dashpot(law.damping_ratio, k, mass)),
        longest: longest[0].min(longest[1]).min((region.high - region.low).length()),
    };
    let fast = shapes.convex[a]
        && shapes.convex[b]
        && counts[1] as usize <= MAX_NEAREST
        && counts[3] as usize <= MAX_NEAREST
        && law.normal == NormalLaw::DistancePotential
        && law.friction_law == FrictionLaw::ShearSpring;
    if fast {
        candidates.convex.push(candidate);
    } else {
        candidates.general.push(candidate);
    }
    let reach = shapes.inradius[a].min(shapes.inradius[b]);
    for block in [a, b] {
        candidates.reach[block] = candidates.reach[block].min(reach);
    }
}

/// Lists the edges of either block that can meet the region, and those of the other that can be nearest there: their numbers, as in
/// [`Candidate`], and the longest edge of each block, m.
fn list_edges(
    shapes: &Shapes,
    candidates: &mut Candidates,
    region: &Box2,
    blocks: [usize; 2],
    placed: [&Placed; 2],
) -> ([u16; 4], [f64; 2]) {
    let (mut counts, mut longest) = ([0u16; 4], [0.0_f64; 2]);
    let gap = candidates.margin[blocks[0]] + candidates.margin[blocks[1]];
    let lists = &mut candidates.lists;
    for side in 0..2 {
        let before = lists.len();
        let (block, start) = (blocks[side], &placed[side].start);
        for (k, edge) in shapes.of(block).iter().enumerate() {
            let (p, q) = (start[k], start[(k + 1) % start.len()]);
            if segment_meets(p, q, region, candidates.margin[block]) {
                lists.push(k as u16);
                longest[side] = longest[side].max(edge.length);
            }
        }
        counts[2 * side] = (lists.len() - before) as u16;
        let before = lists.len();
        nearest_edges(placed[1 - side], shapes.convex[blocks[1 - side]], region, gap, lists);
        counts[2 * side + 1] = (lists.len() - before) as u16;
    }
    (counts, longest)
}

/// Mass that the dashpots between two blocks are tuned to, kg/m; one that is driven does not yield.
pub(crate) fn pair_mass(
    motion: &[Option<Box<Motion>>],
    shapes: &Shapes,
    [a, b]: [usize; 2],
) -> f64 {
    let inverse = |block: usize| {
        if is_driven(motion[block].as_deref()) { 0.0 } else { 1.0 / shapes.mass[block] }
    };
    let sum = inverse(a) + inverse(b);
    // Where nothing can move either, the dashpot still needs a mass to be tuned to.
    if sum > 0.0 { 1.0 / sum } else { shapes.mass[a].min(shapes.mass[b]) }
}

/// Row of the interface table for two blocks.
#[must_use]
pub(crate) fn row_of(setup: &Setup, a: usize, b: usize) -> u16 {
    let (ma, mb) = (setup.blocks[a].material as usize, setup.blocks[b].material as usize);
    setup.pair_table[ma * setup.materials.len() + mb]
}

/// Whether an edge line of a convex `wall` has all of `block` beyond it by more than `gap`.
fn separated(block: &Placed, wall: &Placed, convex: bool, gap: f64) -> bool {
    convex
        && wall
            .normal
            .iter()
            .zip(&wall.offset)
            .any(|(n, d)| block.start.iter().all(|p| d - n.dot(*p) < -gap))
}

/// Whether the segment comes within `margin` of the box (conservative).
fn segment_meets(p: Vec2, q: Vec2, region: &Box2, margin: f64) -> bool {
    let grow = Vec2::splat(margin);
    let (low, high) = (region.low - grow, region.high + grow);
    if p.max(q).cmplt(low).any() || p.min(q).cmpgt(high).any() {
        return false;
    }
    // All corners of the grown box on one side of the line?
    let normal = (q - p).perp();
    let side = |c: Vec2| normal.dot(c - p);
    let corners = Box2 { low, high }.corners().map(side);
    !(corners.iter().all(|&s| s > 0.0) || corners.iter().all(|&s| s < 0.0))
}

/// Edges of `wall` that can be the nearest boundary somewhere in `region`, also after both blocks
/// have moved by their margins (`gap` is the sum).
fn nearest_edges(wall: &Placed, convex: bool, region: &Box2, gap: f64, list: &mut Vec<u16>) {
    let corners = region.corners();
    let n = wall.start.len();
    if convex {
        let depth = |m: usize, x: Vec2| wall.offset[m] - wall.normal[m].dot(x);
        for m in 0..n {
            // Each depth may have changed by all that both blocks have moved, and in opposite ways.
            let never = (0..n)
                .any(|k| k != m && corners.iter().all(|&x| depth(k, x) - depth(m, x) < -2.0 * gap));
            if !never {
                list.push(m as u16);
            }
        }
        return;
    }
    let distance = |m: usize, x: Vec2| segment_distance(wall.start[m], wall.start[(m + 1) % n], x);
    // The distance to a segment is convex, so its largest value in the box is at a corner.
    let bound = (0..n)
        .map(|m| corners.iter().map(|&x| distance(m, x)).fold(0.0, f64::max))
        .fold(f64::INFINITY, f64::min)
        + 2.0 * gap;
    for m in 0..n {
        if segment_box_distance(wall.start[m], wall.start[(m + 1) % n], region) <= bound {
            list.push(m as u16);
        }
    }
}

/// Distance of `x` from the segment `p q`.
#[must_use]
pub(crate) fn segment_distance(p: Vec2, q: Vec2, x: Vec2) -> f64 {
    let d = q - p;
    let t = ((x - p).dot(d) / d.dot(d)).clamp(0.0, 1.0);
    (x - p - t * d).length()
}

/// A lower bound of the distance of a segment from a box.
fn segment_box_distance(p: Vec2, q: Vec2, region: &Box2) -> f64 {
    let centre = 0.5 * (region.low + region.high);
    let half = 0.5 * (region.high - region.low).length();
    (segment_distance(p, q, centre) - half).max(0.0)
}

/// Moves the states of contacts to the new list; the others start empty. A pair whose nearest edges
/// have become too many for the convex kernel, or few enough again, takes its state along.
fn carry_states(world: &mut World, candidates: &Candidates) {
    let convex = std::mem::take(&mut world.pairs);
    let mut general = std::mem::take(&mut world.general);
    let in_convex = |c: &Candidate| convex.binary_search_by_key(&(c.i, c.j), |p| (p.i, p.j));
    world.pairs = candidates
        .convex
        .iter()
        .map(|c| {
            let contact = in_convex(c).map_or_else(
                |_| {
                    let old = general.binary_search_by_key(&(c.i, c.j), |g| (g.i, g.j));
                    let region = old.ok().and_then(|k| general[k].regions.first());
                    region.map_or_else(Contact::default, |r| r.contact)
                },
                |k| convex[k].contact,
            );
            PairState { i: c.i, j: c.j, contact }
        })
        .collect();
    world.general = candidates
        .general
        .iter()
        .map(|c| {
            let old = general.binary_search_by_key(&(c.i, c.j), |g| (g.i, g.j));
            let regions = match (old, in_convex(c)) {
                (Ok(k), _) => std::mem::take(&mut general[k].regions),
                (_, Ok(k)) if convex[k].contact != Contact::default() => vec![Region {
                    // It has noted no edges: whatever region there is goes on from it.
                    edges: u64::MAX,
                    contact: convex[k].contact,
                }],
                _ => Vec::new(),
            };
            GeneralState { i: c.i, j: c.j, regions }
        })
        .collect();
}
