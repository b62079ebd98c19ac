//! The network of joints: where blocks touch along edges at the start, and where edges are free.
//!
//! It is a function of the blocks as they were built, of which of them are there, and of the water table: where blocks have moved to
//! since does not matter.
//!
//! What blocks that were taken out leave open is drained: a seepage face, whatever the table says. Water comes out where it can and never goes in, and
//! nothing presses on it; so it is no [`OpenFace`].

use std::collections::BTreeMap;

use riprap_geom::Vec2;
use riprap_geom::pairs::touching_boxes;
use riprap_geom::polygon::Aabb;

use super::state::{Conduit, Node, OpenFace, Seepage};
use crate::laws::seepage::{Drain, Edge};
use crate::laws::water::WaterTable;
use crate::setup::Setup;
use crate::shapes::Shapes;

/// Distance, as a share of a block, within which edges lie on one line, places are one, and a drain meets a joint.
const SAME: f64 = 1e-6;

/// A straight stretch at the start between two places, m.
#[derive(Clone, Copy)]
struct Stretch {
    from: Vec2,
    to: Vec2,
}

impl Stretch {
    /// Of edge `k` of block `b`, between two distances from its start, m.
    fn of(shapes: &Shapes, b: usize, k: usize, [low, high]: [f64; 2]) -> Self {
        let edge = &shapes.edges[k];
        let (start, along) = (edge.start + shapes.centroid[b], edge.normal.perp());
        Self { from: start + low * along, to: start + high * along }
    }

    fn at(&self, share: f64) -> Vec2 {
        self.from + share * (self.to - self.from)
    }

    /// Where it is cut by a drain, as a share of its length.
    fn crossing(&self, drain: &Drain) -> Option<f64> {
        let (from, to) = (Vec2::from(drain.from), Vec2::from(drain.to));
        let (d, e) = (self.to - self.from, to - from);
        let across = d.perp_dot(e);
        if across.abs() <= SAME * d.length() * e.length() {
            return None;
        }
        let gap = from - self.from;
        let (s, t) = (gap.perp_dot(e) / across, gap.perp_dot(d) / across);
        let slack = SAME * d.length() / e.length().max(f64::MIN_POSITIVE);
        (s > 0.0 && s < 1.0 && t >= -slack && t <= 1.0 + slack).then_some(s)
    }

    /// Its parts between these shares of its length.
    fn parts(self, mut shares: Vec<f64>) -> impl Iterator<Item = Stretch> {
        shares.retain(|s| *s > SAME && *s < 1.0 - SAME);
        shares.extend([0.0, 1.0]);
        shares.sort_by(f64::total_cmp);
        shares.dedup_by(|a, b| *a - *b <= SAME);
        (1..shares.len())
            .map(move |k| Stretch { from: self.at(shares[k - 1]), to: self.at(shares[k]) })
    }
}

/// Nodes, found by their places.
struct Nodes {
    list: Vec<Node>,
    cells: BTreeMap<[i64; 2], Vec<u32>>,
    size: f64,
}

impl Nodes {
    /// The node at a place; a new one if there is none.
    fn at(&mut self, place: Vec2) -> u32 {
        let cell = [place.x, place.y].map(|x| (x / self.size).floor() as i64);
        // Places that are one can lie on two sides of a border between cells.
        for dx in -1..=1 {
            for dy in -1..=1 {
                let near = self.cells.get(&[cell[0] + dx, cell[1] + dy]);
                let mut near = near.into_iter().flatten();
                let same = |n: &&u32| self.list[**n as usize].place.distance(place) <= self.size;
                if let Some(n) = near.find(same) {
                    return *n;
                }
            }
        }
        let number = self.list.len() as u32;
        self.list.push(Node { place, edge: Edge::Inside });
        self.cells.entry(cell).or_default().push(number);
        number
    }
}

/// Stretches of each edge, from its start, m.
type Stretches = Vec<Vec<[f64; 2]>>;

/// The network of the living blocks under a table that seeps; heads are not known yet.
pub(super) fn build(setup: &Setup, shapes: &Shapes, alive: &[bool], table: &WaterTable) -> Seepage {
    let Some(rules) = &table.seepage else {
        return Seepage::default();
    };
    let radii = shapes.radius.iter().zip(alive).filter(|(_, a)| **a);
    let smallest = radii.map(|(r, _)| *r).fold(f64::INFINITY, f64::min);
    let mut nodes = Nodes { list: Vec::new(), cells: BTreeMap::new(), size: SAME * smallest };
    let mut out = Seepage::default();
    // Stretches of each edge that another block covers, and that one covered which was taken out.
    let mut covered: Stretches = vec![Vec::new(); shapes.edges.len()];
    let mut bared = covered.clone();
    for (i, j) in neighbours(setup, alive) {
        let blocks = [i as usize, j as usize];
        let [a, b] = blocks;
        let is_joint = alive[a] && alive[b];
        let stretches = if is_joint { &mut covered } else { &mut bared };
        for (ka, kb) in shapes.range(a).flat_map(|k| shapes.range(b).map(move |l| (k, l))) {
            let Some([on_a, on_b]) = common(shapes, blocks, [ka, kb]) else {
                continue;
            };
            stretches[ka].push(on_a);
            stretches[kb].push(on_b);
            if !is_joint {
                continue;
            }
            let whole = Stretch::of(shapes, a, ka, on_a);
            let cuts = rules.drains.iter().filter_map(|d| whole.crossing(d));
            for part in whole.parts(cuts.collect()) {
                let places = [part.from, part.to];
                out.conduits.push(Conduit {
                    blocks: [i, j],
                    nodes: places.map(|p| nodes.at(p)),
                    on: blocks.map(|c| places.map(|p| p - shapes.centroid[c])),
                });
            }
        }
    }
    let mut seeps = Vec::new();
    for b in (0..shapes.len()).filter(|b| alive[*b]) {
        for k in shapes.range(b) {
            for bare in &bared[k] {
                let bare = Stretch::of(shapes, b, k, *bare);
                seeps.extend([bare.from, bare.to].map(|p| nodes.at(p)));
            }
            // Bare stretches are none of the open faces.
            covered[k].append(&mut bared[k]);
            let open = gaps(&mut covered[k], shapes.edges[k].length, SAME * shapes.radius[b]);
            for ends in open {
                open_faces(table, shapes, b, Stretch::of(shapes, b, k, ends), &mut nodes, &mut out);
            }
        }
    }
    out.nodes = nodes.list;
    hold(&mut out, &seeps, table, nodes.size);
    out
}

/// The stretch that the edges `[ka, kb]` of two blocks share at the start, on either of them.
fn common(shapes: &Shapes, [a, b]: [usize; 2], [ka, kb]: [usize; 2]) -> Option<[[f64; 2]; 2]> {
    let (ea, eb) = (&shapes.edges[ka], &shapes.edges[kb]);
    let tolerance = SAME * shapes.radius[a].min(shapes.radius[b]);
    let apart = (eb.start + shapes.centroid[b]) - (ea.start + shapes.centroid[a]);
    let opposite = eb.normal.dot(ea.normal) < -1.0 + 1e-9;
    if !opposite || ea.normal.dot(apart).abs() > tolerance {
        return None;
    }
    let begins = ea.normal.perp().dot(apart);
    // The other edge runs the other way: from where it begins back by its length.
    let (low, high) = ((begins - eb.length).max(0.0), begins.min(ea.length));
    (high - low > tolerance).then_some([[low, high], [begins - high, begins - low]])
}

/// Adds the open faces of a bare stretch of block `b`, but for one that lies on a closed line.
fn open_faces(
    table: &WaterTable,
    shapes: &Shapes,
    b: usize,
    whole: Stretch,
    nodes: &mut Nodes,
    out: &mut Seepage,
) {
    let closed = || table.seepage.iter().flat_map(|rules| &rules.closed);
    let is_closed = |p: Vec2| closed().any(|line| line.holds(p.into(), nodes.size));
    // An edge with one end on a closed line leads away from it.
    if is_closed(whole.from) && is_closed(whole.to) {
        return;
    }
    let run = whole.to.x - whole.from.x;
    // Heads are linear between nodes: a corner of the table must be one.
    let corners = table.points.iter().map(|c| (c[0] - whole.from.x) / run);
    let corners = corners.filter(|s| s.is_finite()).collect();
    for part in whole.parts(corners) {
        let places = [part.from, part.to];
        out.faces.push(OpenFace {
            block: b as u32,
            nodes: places.map(|p| nodes.at(p)),
            on: places.map(|p| p - shapes.centroid[b]),
        });
    }
}

/// Pairs of blocks whose boxes touch at the start, one of them living at least.
fn neighbours(setup: &Setup, alive: &[bool]) -> Vec<(u32, u32)> {
    let padded = |vertices: &[Vec2]| {
        let tight = Aabb::of(vertices);
        let slack = Vec2::splat(SAME * tight.size());
        Aabb { min: tight.min - slack, max: tight.max + slack }
    };
    let boxes = setup.blocks.iter().map(|b| padded(&b.vertices));
    let boxes: Vec<Aabb> = boxes.collect();
    let mut pairs = touching_boxes(&boxes, usize::MAX).unwrap_or_default();
    pairs.retain(|(i, j)| alive[*i as usize] || alive[*j as usize]);
    pairs
}

/// What of an edge no other block covers.
fn gaps(covered: &mut [[f64; 2]], length: f64, tolerance: f64) -> Vec<[f64; 2]> {
    covered.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let mut gaps = Vec::new();
    let mut reached = 0.0;
    for &[low, high] in covered.iter() {
        if low - reached > tolerance {
            gaps.push([reached, low]);
        }
        reached = high.max(reached);
    }
    if length - reached > tolerance {
        gaps.push([reached, length]);
    }
    gaps
}

/// Heads on open faces below the table, outlets above it, on faces that were bared (`seeps`) and at drains.
fn hold(out: &mut Seepage, seeps: &[u32], table: &WaterTable, size: f64) {
    for n in seeps {
        let node = &mut out.nodes[*n as usize];
        node.edge = Edge::Outlet(node.place.y);
    }
    for face in &out.faces {
        for n in face.nodes {
            let node = &mut out.nodes[n as usize];
            let (head, height) = (table.height(node.place.x), node.place.y);
            // At the table itself water stands, whatever round-off says.
            node.edge = if head >= height - size {
                Edge::Head(head.max(height))
            } else {
                Edge::Outlet(height)
            };
        }
    }
    let drains = table.seepage.iter().flat_map(|rules| &rules.drains);
    for drain in drains {
        for node in out.nodes.iter_mut().filter(|n| drain.distance(n.place.into()) <= 10.0 * size) {
            if node.edge == Edge::Inside {
                node.edge = Edge::Outlet(drain.head.map_or(node.place.y, |h| h.max(node.place.y)));
            }
        }
    }
}
