//! The network of joints in space: the parts of faces that blocks share at the start, and the lines along which these meet or end.
//!
//! ```text
//!        B  |  D          Four blocks about a line: the joints AB, BD, DC and CA have a stretch of their rims there. It is a node, and
//!      -----o-----        water goes from each of the four to the others. Around it the angles of A, B, C and D are 360 deg: it is inside.
//!        A  |  C          Without D the angles are 270 deg: the node is in the open, and the table gives its head.
//! ```
//!
//! It is a function of the blocks as they were built, of which of them are there, and of the water table: where blocks have moved to since does not
//! matter. Corners of one rim that lie on a stretch of another one divide it, so that every stretch has one set of joints along all of its length.
//!
//! A line that would be inside if blocks had not been taken out is drained: a seepage face, whatever the table says.

use std::collections::{BTreeMap, BTreeSet};
use std::f64::consts::PI;

use riprap_geom::polyhedron::area_vector;
use riprap_geom::{Vec2, Vec3};

use crate::faces::overlap;
use crate::faces::overlap::GAP;
use crate::faces::region::Extent;
use crate::laws::seepage::sheet::{Rim, sheet};
use crate::laws::seepage::{Curtain, Edge, Steady};
use crate::laws::water::WaterTable;
use crate::state::lineage::Origin;
use crate::state::seepage::{Bare, Joint, Node, Seepage};
use crate::state::world::World;

/// Distance, as a share of the shortest half edge of a block, within which places are one.
const SAME: f64 = 1e-6;
/// Angle around a line that is missing where it is in the open, rad.
const OPEN: f64 = 1e-6;
/// Share of the surface of a block that is left over by round-off.
const NOTHING: f64 = 1e-9;
/// Cells in which corners are looked for, over the distance within which they are one.
const CELL: f64 = 1e3;

/// A part of a face that two blocks share; corners anticlockwise about the outward normal of the first.
pub(crate) struct Part {
    pub blocks: [u32; 2],
    pub outline: Vec<Vec3>,
}

/// Joints of the living blocks and the lines along which they meet or end.
pub(crate) struct Mesh {
    /// By pairs of blocks, ascending, with the stretches of their rims.
    pub joints: Vec<(Part, Stretches)>,
    /// Parts of faces behind which a block was taken out.
    bare: Vec<Bare>,
    pub lines: Lines,
}

impl Mesh {
    /// That of the living blocks, with joints divided where `curtains` cross them.
    pub(crate) fn of(world: &World, curtains: &[Curtain]) -> Self {
        let size = SAME * world.finest();
        let chosen = chosen(world);
        let alive = |b: u32| world.alive[b as usize];
        let mut joints = Vec::new();
        let mut bare = Vec::new();
        // Blocks at the stretches of bare parts, for what is around a line.
        let mut drained = Vec::new();
        for (blocks, outline) in overlap::outlines(world, &chosen, GAP * world.finest()) {
            match blocks.map(alive) {
                [true, true] => joints.push(ordered(blocks, outline)),
                [false, false] => {}
                [first, _] => {
                    let seen = if first { outline.clone() } else { reversed(&outline) };
                    let block = if first { blocks[0] } else { blocks[1] };
                    bare.push(Bare { block, outline: seen });
                    drained.push(Part { blocks, outline });
                }
            }
        }
        for curtain in curtains {
            joints = joints.into_iter().flat_map(|part| divided(part, curtain, size)).collect();
        }
        joints.sort_by_key(|part| part.blocks);
        let mut lines = Lines::of(&joints, &drained, curtains, size);
        let with_rim = |part: Part| {
            let rim = lines.rim(&part.outline);
            (part, rim)
        };
        let joints: Vec<(Part, Stretches)> = joints.into_iter().map(with_rim).collect();
        for part in &drained {
            let rim = lines.rim(&part.outline);
            lines.beside(&rim.nodes, part.blocks);
        }
        for (part, rim) in &joints {
            lines.beside(&rim.nodes, part.blocks);
        }
        Self { joints, bare, lines }
    }
}

/// The network of the living blocks under a table that seeps; pressures are not known yet.
pub(super) fn build(world: &World, table: &WaterTable, rules: &Steady) -> Seepage {
    let Mesh { joints, mut bare, lines } = Mesh::of(world, &rules.curtains);
    let size = lines.corners.size;
    for b in chosen(world).into_iter().filter(|b| world.alive[*b as usize]) {
        let solid = Extent::of(&world.setup.blocks[b as usize].shape).solid(Vec3::ZERO);
        for outline in (0..solid.faces.len()).map(|face| solid.outline(face)) {
            let on = |at: &Vec3, side: usize| rules.closed[side].holds(at.to_array(), size);
            // No water stands at a closed side: as a bare part it loses the push of standing water again.
            if (0..rules.closed.len()).any(|side| outline.iter().all(|at| on(at, side))) {
                bare.push(Bare { block: b, outline });
            }
        }
    }
    let mut out = Seepage {
        blocks: [world.alive.len(), world.alive.iter().filter(|a| **a).count()],
        ..Seepage::default()
    };
    for (part, rim) in joints {
        let (joint, lost) = joint(part, &rim);
        if lost > out.lost.0 {
            out.lost = (lost, joint.blocks);
        }
        out.joints.push(joint);
    }
    out.nodes = lines.nodes(world, table, rules);
    out.bare = bare;
    press(&mut out, world);
    out
}

/// Blocks with joints that are there, or were taken out: not those that were divided.
fn chosen(world: &World) -> Vec<u32> {
    let parents = world.lineage.iter().map(|origin| origin.parent);
    let parents: BTreeSet<u32> = parents.filter(|p| *p != Origin::NONE).collect();
    let all = 0..world.alive.len();
    let joined = |b: &usize| !world.is_terrain(*b) && !world.is_glued(*b) && !world.deforms(*b);
    all.filter(joined)
        .map(|b| b as u32)
        .filter(|b| world.alive[*b as usize] || !parents.contains(b))
        .collect()
}

fn reversed(outline: &[Vec3]) -> Vec<Vec3> {
    outline.iter().rev().copied().collect()
}

fn ordered(blocks: [u32; 2], outline: Vec<Vec3>) -> Part {
    let [i, j] = blocks;
    if i <= j {
        return Part { blocks, outline };
    }
    Part { blocks: [j, i], outline: reversed(&outline) }
}

/// Both sides of a joint at a curtain of drains that crosses it.
fn divided(part: Part, curtain: &Curtain, size: f64) -> Vec<Part> {
    let normal = unit_normal(curtain);
    let heights: Vec<f64> = (part.outline.iter())
        .map(|at| normal.dot(*at - Vec3::from(curtain.from)))
        .map(|height| if height.abs() <= size { 0.0 } else { height })
        .collect();
    let crosses = heights.iter().any(|h| *h > 0.0) && heights.iter().any(|h| *h < 0.0);
    if !crosses || chord(&part.outline, &heights).is_none_or(|c| reach(curtain, c, size).is_none())
    {
        return vec![part];
    }
    let side = |sign: f64| -> Vec<Vec3> {
        let n = part.outline.len();
        let mut kept = Vec::with_capacity(n + 1);
        for k in 0..n {
            let next = (k + 1) % n;
            let (s, t) = (sign * heights[k], sign * heights[next]);
            if s >= 0.0 {
                kept.push(part.outline[k]);
            }
            if s * t < 0.0 {
                let along = part.outline[next] - part.outline[k];
                kept.push(part.outline[k] + s / (s - t) * along);
            }
        }
        kept
    };
    let blocks = part.blocks;
    [1.0, -1.0].map(|sign| Part { blocks, outline: side(sign) }).into()
}

fn unit_normal(curtain: &Curtain) -> Vec3 {
    Vec3::from(curtain.hole).cross(Vec3::from(curtain.row)).normalize_or_zero()
}

/// Where the plane of the heights crosses an outline.
fn chord(outline: &[Vec3], heights: &[f64]) -> Option<[Vec3; 2]> {
    let n = outline.len();
    let mut ends = Vec::new();
    for k in 0..n {
        let (s, t) = (heights[k], heights[(k + 1) % n]);
        if s == 0.0 {
            ends.push(outline[k]);
        } else if s * t < 0.0 {
            ends.push(outline[k] + s / (s - t) * (outline[(k + 1) % n] - outline[k]));
        }
    }
    match ends[..] {
        [a, b] => Some([a, b]),
        _ => None,
    }
}

/// The part of a line in the plane of a curtain that lies in it, as shares of its length; `None` where it misses it.
fn reach(curtain: &Curtain, [a, b]: [Vec3; 2], size: f64) -> Option<[f64; 2]> {
    let (hole, row) = (Vec3::from(curtain.hole), Vec3::from(curtain.row));
    let normal = hole.cross(row);
    let shares = |at: Vec3| {
        let from = at - Vec3::from(curtain.from);
        let per = 1.0 / normal.length_squared();
        [per * from.cross(row).dot(normal), per * hole.cross(from).dot(normal)]
    };
    let (start, end) = (shares(a), shares(b));
    let [mut low, mut high] = [0.0_f64, 1.0];
    for ((s, t), along) in start.into_iter().zip(end).zip([hole, row]) {
        let slack = size / along.length();
        let (s, t) = (s + slack, t + slack);
        let (least, most) = (0.0, 1.0 + 2.0 * slack);
        if (t - s).abs() <= f64::EPSILON {
            if s < least || s > most {
                return None;
            }
            continue;
        }
        let (u, v) = ((least - s) / (t - s), (most - s) / (t - s));
        low = low.max(u.min(v));
        high = high.min(u.max(v));
    }
    ((high - low) * a.distance(b) > 2.0 * size).then_some([low, high])
}

/// A joint whose rim has these nodes, and what its shape leaves out. Nodes stand for stretches between the corners of `rim`.
fn joint(part: Part, rim: &Stretches) -> (Joint, f64) {
    let Part { blocks, outline } = part;
    let (centre, normal, area) = middle(&outline);
    let across = (outline[1] - outline[0]).normalize_or_zero();
    let along = normal.cross(across);
    let flat = |v: Vec3| Vec2::new(v.dot(across), v.dot(along));
    let outward = |[from, to]: [Vec3; 2]| (to - from).cross(normal);
    let of_rim: Vec<Rim> = (rim.ends.iter())
        .map(|ends| Rim {
            middle: flat(0.5 * (ends[0] + ends[1]) - centre),
            normal: flat(outward(*ends)),
        })
        .collect();
    let sheet = sheet(&of_rim, area);
    // By Gauss's theorem the slope of a linear quantity is the sum of its values on the rim times these.
    let levers = rim.ends.iter().map(|ends| outward(*ends) / area);
    let joint = Joint {
        blocks,
        outline,
        centre,
        normal,
        rim: rim.nodes.iter().copied().zip(levers).collect(),
        pipes: sheet.pipes,
        shares: shares(&of_rim),
    };
    (joint, sheet.lost)
}

/// Centroid (m), normal and area (m²) of a flat outline.
pub(crate) fn middle(outline: &[Vec3]) -> (Vec3, Vec3, f64) {
    let twice = area_vector(outline);
    let (area, normal) = (twice.length(), twice.normalize_or_zero());
    let first = outline[0];
    let centre = (2..outline.len())
        .map(|k| {
            let (a, b) = (outline[k - 1] - first, outline[k] - first);
            a.cross(b).dot(normal) / 6.0 * (a + b)
        })
        .sum::<Vec3>();
    (first + centre / area, normal, area)
}

/// Shares of the stretches of a rim in a linear quantity at the centroid: the smallest.
fn shares(rim: &[Rim]) -> Vec<f64> {
    let sum = |get: &dyn Fn(&Rim) -> f64| rim.iter().map(get).sum::<f64>();
    let (xx, xy, yy) = (
        sum(&|r| r.middle.x * r.middle.x),
        sum(&|r| r.middle.x * r.middle.y),
        sum(&|r| r.middle.y * r.middle.y),
    );
    let (x, y) = (sum(&|r| r.middle.x), sum(&|r| r.middle.y));
    let per = 1.0 / (xx * yy - xy * xy);
    let slope = Vec2::new(per * (yy * x - xy * y), per * (xx * y - xy * x));
    let raw: Vec<f64> = rim.iter().map(|r| 1.0 - slope.dot(r.middle)).collect();
    let whole: f64 = raw.iter().sum();
    raw.into_iter().map(|share| share / whole).collect()
}

/// The stretches of one rim: nodes, and their ends on the way around.
pub(crate) struct Stretches {
    pub nodes: Vec<u32>,
    pub ends: Vec<[Vec3; 2]>,
}

/// All stretches between corners, found by these.
pub(crate) struct Lines {
    corners: Corners,
    /// Corners inside the edge between two corners, from the first.
    inside: BTreeMap<[u32; 2], Vec<u32>>,
    nodes: BTreeMap<[u32; 2], u32>,
    /// Ends of the nodes, and the blocks around them.
    ends: Vec<[u32; 2]>,
    around: Vec<Vec<u32>>,
}

impl Lines {
    /// Ends of each node, m, and the blocks around it, those behind bare parts included.
    pub(crate) fn around(&self) -> impl Iterator<Item = ([Vec3; 2], &[u32])> {
        let ends = self.ends.iter().map(|ends| ends.map(|k| self.corners.list[k as usize]));
        ends.zip(self.around.iter().map(Vec::as_slice))
    }

    /// Distance within which places are one, m.
    pub(crate) fn size(&self) -> f64 {
        self.corners.size
    }

    fn of(joints: &[Part], drained: &[Part], curtains: &[Curtain], size: f64) -> Self {
        let mut corners = Corners { list: Vec::new(), cells: BTreeMap::new(), size };
        let mut edges = BTreeSet::new();
        for part in joints.iter().chain(drained) {
            let ids: Vec<u32> = part.outline.iter().map(|at| corners.at(*at)).collect();
            let next = |k: usize| ids[(k + 1) % ids.len()];
            edges.extend((0..ids.len()).map(|k| key(ids[k], next(k))));
        }
        edges.retain(|[a, b]| a != b);
        // Where a curtain ends on an edge.
        for [a, b] in &edges {
            let ends = [a, b].map(|k| corners.list[*k as usize]);
            for curtain in curtains {
                let normal = unit_normal(curtain);
                let off = |at: Vec3| normal.dot(at - Vec3::from(curtain.from)).abs() > 10.0 * size;
                if ends.into_iter().any(off) {
                    continue;
                }
                for share in reach(curtain, ends, size).into_iter().flatten() {
                    corners.at(ends[0] + share * (ends[1] - ends[0]));
                }
            }
        }
        let inside = divide(&corners, &edges);
        Self { corners, inside, nodes: BTreeMap::new(), ends: Vec::new(), around: Vec::new() }
    }

    /// The stretches of a rim; nodes that are new are made.
    fn rim(&mut self, outline: &[Vec3]) -> Stretches {
        let ids: Vec<u32> = outline.iter().map(|at| self.corners.at(*at)).collect();
        let mut rim = Stretches { nodes: Vec::new(), ends: Vec::new() };
        for k in 0..ids.len() {
            let (a, b) = (ids[k], ids[(k + 1) % ids.len()]);
            if a == b {
                continue;
            }
            let mut way = vec![a];
            let between = self.inside.get(&key(a, b)).map_or(&[][..], |list| list);
            // Corners inside an edge are listed from its lower number.
            if a < b {
                way.extend(between);
            } else {
                way.extend(between.iter().rev());
            }
            way.push(b);
            for pair in way.windows(2) {
                let ends = key(pair[0], pair[1]);
                let fresh = self.ends.len() as u32;
                let node = *self.nodes.entry(ends).or_insert(fresh);
                if node == fresh {
                    self.ends.push(ends);
                    self.around.push(Vec::new());
                }
                rim.nodes.push(node);
                let at = |k: u32| self.corners.list[k as usize];
                rim.ends.push([at(pair[0]), at(pair[1])]);
            }
        }
        rim
    }

    fn beside(&mut self, nodes: &[u32], blocks: [u32; 2]) {
        for node in nodes {
            let around = &mut self.around[*node as usize];
            for b in blocks {
                if !around.contains(&b) {
                    around.push(b);
                }
            }
        }
    }

    /// The nodes, with what holds there.
    fn nodes(&self, world: &World, table: &WaterTable, rules: &Steady) -> Vec<Node> {
        let size = self.corners.size;
        let planes: Vec<Vec<(Vec3, f64)>> = (0..world.alive.len())
            .map(|b| {
                if world.is_terrain(b) || world.is_glued(b) {
                    return Vec::new();
                }
                let solid = Extent::of(&world.setup.blocks[b].shape).solid(Vec3::ZERO);
                (0..solid.faces.len()).map(|face| solid.plane(face)).collect()
            })
            .collect();
        let nodes = self.ends.iter().zip(&self.around);
        nodes
            .map(|(ends, around)| {
                let ends = ends.map(|k| self.corners.list[k as usize]);
                let place = 0.5 * (ends[0] + ends[1]);
                let angle = |counts: &dyn Fn(u32) -> bool| {
                    let blocks = around.iter().filter(|b| counts(**b));
                    blocks.map(|b| angle_of(&planes[*b as usize], place, 10.0 * size)).sum::<f64>()
                };
                let full = |angle: f64| angle > 2.0 * PI - OPEN;
                let closed = rules
                    .closed
                    .iter()
                    .any(|side| ends.iter().all(|at| side.holds(at.to_array(), 10.0 * size)));
                let head = table.level(place.x, place.y);
                let mut edge = if full(angle(&|b| world.alive[b as usize])) {
                    Edge::Inside
                } else if full(angle(&|_| true)) {
                    Edge::Outlet(place.z)
                } else if closed {
                    Edge::Inside
                } else if head >= place.z - size {
                    Edge::Head(head.max(place.z))
                } else {
                    Edge::Outlet(place.z)
                };
                for curtain in &rules.curtains {
                    let normal = unit_normal(curtain);
                    let on =
                        |at: &Vec3| normal.dot(*at - Vec3::from(curtain.from)).abs() <= 10.0 * size;
                    if edge == Edge::Inside
                        && ends.iter().all(on)
                        && reach(curtain, ends, size).is_some_and(|[s, t]| t - s > 0.5)
                    {
                        edge = Edge::Outlet(curtain.head.map_or(place.z, |h| h.max(place.z)));
                    }
                }
                Node { place, edge }
            })
            .collect()
    }
}

/// Angle that a convex block with these planes fills around a line through a place on its surface, rad.
fn angle_of(planes: &[(Vec3, f64)], at: Vec3, slack: f64) -> f64 {
    let on = planes.iter().filter(|(n, d)| (n.dot(at) - d).abs() <= slack);
    let normals: Vec<Vec3> = on.map(|(n, _)| *n).collect();
    let bends = normals.iter().enumerate().flat_map(|(k, n)| {
        let others = normals[..k].iter();
        // From sine and cosine: the cosine alone has lost half of the digits where faces go on flat or turn back.
        others.map(move |m| libm::atan2(n.cross(*m).length(), n.dot(*m)))
    });
    match normals.len() {
        0 => 0.0,
        _ => PI - bends.fold(0.0, f64::max),
    }
}

fn key(a: u32, b: u32) -> [u32; 2] {
    [a.min(b), a.max(b)]
}

/// Corners inside each edge, in their order.
fn divide(corners: &Corners, edges: &BTreeSet<[u32; 2]>) -> BTreeMap<[u32; 2], Vec<u32>> {
    let at = |k: u32| corners.list[k as usize];
    let lengths = edges.iter().map(|[a, b]| at(*a).distance(at(*b)));
    let cell = (lengths.sum::<f64>() / edges.len().max(1) as f64).max(corners.size);
    let of = |v: Vec3| v.to_array().map(|x| (x / cell).floor() as i64);
    let mut bins: BTreeMap<[i64; 3], Vec<u32>> = BTreeMap::new();
    for (k, place) in (0..).zip(&corners.list) {
        bins.entry(of(*place)).or_default().push(k);
    }
    let mut inside = BTreeMap::new();
    for &[a, b] in edges {
        let (start, along) = (at(a), at(b) - at(a));
        let slack = Vec3::splat(corners.size);
        let low = of(start.min(at(b)) - slack);
        let high = of(start.max(at(b)) + slack);
        let mut found: Vec<(f64, u32)> = Vec::new();
        for x in low[0]..=high[0] {
            for y in low[1]..=high[1] {
                for z in low[2]..=high[2] {
                    for &k in bins.get(&[x, y, z]).into_iter().flatten() {
                        let share = (at(k) - start).dot(along) / along.length_squared();
                        let off = (at(k) - start - share * along).length();
                        if k != a && k != b && off <= corners.size && share > 0.0 && share < 1.0 {
                            found.push((share, k));
                        }
                    }
                }
            }
        }
        if !found.is_empty() {
            found.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
            inside.insert([a, b], found.into_iter().map(|(_, k)| k).collect());
        }
    }
    inside
}

/// Places, found by where they are.
struct Corners {
    list: Vec<Vec3>,
    cells: BTreeMap<[i64; 3], Vec<u32>>,
    size: f64,
}

impl Corners {
    /// The corner at a place; a new one if there is none.
    fn at(&mut self, place: Vec3) -> u32 {
        let cell = CELL * self.size;
        let of = |v: Vec3| v.to_array().map(|x| (x / cell).floor() as i64);
        let (low, high) = (of(place - self.size), of(place + self.size));
        for x in low[0]..=high[0] {
            for y in low[1]..=high[1] {
                for z in low[2]..=high[2] {
                    let near = self.cells.get(&[x, y, z]).into_iter().flatten();
                    let mut near = near.copied();
                    let same = |k: &u32| self.list[*k as usize].distance(place) <= self.size;
                    if let Some(k) = near.find(same) {
                        return k;
                    }
                }
            }
        }
        let number = self.list.len() as u32;
        self.list.push(place);
        self.cells.entry(of(place)).or_default().push(number);
        number
    }
}

/// What presses on each block, and which of them are in the open.
fn press(out: &mut Seepage, world: &World) {
    let n = world.alive.len();
    let joints = out.joints.len() as u32;
    let sides = (0..).zip(&out.joints).flat_map(|(k, joint)| {
        let [i, j] = joint.blocks;
        [(i, 2 * k), (j, 2 * k + 1)]
    });
    let bare = (joints..).zip(&out.bare).map(|(k, bare)| (bare.block, 2 * k));
    let mut all: Vec<(u32, u32)> = sides.chain(bare).collect();
    all.sort_unstable();
    out.first = (0..=n as u32).map(|b| all.partition_point(|entry| entry.0 < b) as u32).collect();
    out.entries = all.iter().map(|entry| entry.1).collect();
    let mut covered = vec![0.0; n];
    let area = |outline: &[Vec3]| area_vector(outline).length();
    for joint in &out.joints {
        for b in joint.blocks {
            covered[b as usize] += area(&joint.outline);
        }
    }
    for bare in &out.bare {
        covered[bare.block as usize] += area(&bare.outline);
    }
    out.open = (0..n)
        .map(|b| {
            if !world.alive[b] || world.is_terrain(b) || world.is_glued(b) {
                return true;
            }
            let solid = Extent::of(&world.setup.blocks[b].shape).solid(Vec3::ZERO);
            let whole: f64 = (0..solid.faces.len()).map(|f| solid.area_vector(f).length()).sum();
            covered[b] < (1.0 - NOTHING) * whole
        })
        .collect();
}
