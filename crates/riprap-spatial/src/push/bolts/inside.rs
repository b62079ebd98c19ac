//! Points inside deformable blocks: the tetrahedron that holds them, and where a line passes through.
//!
//! A deformable block is a star of tetrahedra, at its start as in its present shape; a bolt is straight when it is installed, so it is
//! the present shape that counts then. What is left of a block that is cut is looked at in its shape at the start.

use riprap_geom::Vec3;
use riprap_geom::polyhedron::Tetrahedra;

use crate::faces::deformable::centred;
use crate::state::anchor::Inside;
use crate::state::world::World;

/// Share of the size of a block by which its tetrahedra count as larger: a line can run along a face or an edge that they share, and rounding
/// would then leave it in neither.
const TOUCH: f64 = 1e-10;

/// The tetrahedra of a deformable block with corners at some time.
pub struct TetFan {
    /// Nodes of each, in the list of the world.
    nodes: Vec<[u32; 4]>,
    /// Places of these, m.
    corners: Vec<[Vec3; 4]>,
}

impl TetFan {
    /// The present shape of a block; `None` of a rigid one, and of one that is not near a line between two places.
    #[must_use]
    pub fn now(world: &World, block: usize, [from, to]: [Vec3; 2]) -> Option<Self> {
        let deform = world.deform.as_deref()?;
        let nodes = &deform.nodes;
        let place = |n: usize| nodes.place[n] + Vec3::from_array(nodes.displacement[n]);
        let own = deform.body(block)?.nodes();
        let centre = place(own.end - 1);
        let far = own.map(|n| place(n).distance_squared(centre));
        let radius = far.fold(0.0, f64::max).sqrt();
        let along = to - from;
        let share = (centre - from).dot(along) / along.length_squared();
        let nearest = from + share.clamp(0.0, 1.0) * along;
        if nearest.distance(centre) > (1.0 + TOUCH) * radius {
            return None;
        }
        Self::of(world, block, place)
    }

    /// The shape of a block at its start; `None` of a rigid one.
    #[must_use]
    pub fn at_start(world: &World, block: usize) -> Option<Self> {
        let nodes = &world.deform.as_deref()?.nodes;
        Self::of(world, block, |n| nodes.place[n])
    }

    fn of(world: &World, block: usize, place: impl Fn(usize) -> Vec3) -> Option<Self> {
        let body = world.deform.as_deref()?.body(block)?;
        let (solid, _) = centred(&world.setup.blocks[block].shape);
        // It was divided when the block was made.
        let mesh = Tetrahedra::new(&solid).ok()?;
        let nodes: Vec<[u32; 4]> = mesh.tets.iter().map(|t| t.map(|n| n + body.first)).collect();
        let corners = nodes.iter().map(|t| t.map(|n| place(n as usize))).collect();
        Some(Self { nodes, corners })
    }

    /// From where to where a line is inside: distances (m) from `from` along the unit direction `along`, within `range`, in order. A block that
    /// has bent can be met more than once.
    #[must_use]
    pub fn spans(&self, from: Vec3, along: Vec3, range: [f64; 2]) -> Vec<[f64; 2]> {
        let centre = self.corners.first().map_or(Vec3::ZERO, |t| t[0]);
        let all = self.corners.iter().flatten();
        let far = all.map(|p| p.distance_squared(centre)).fold(0.0, f64::max);
        let near = TOUCH * far.sqrt();
        let each = self.corners.iter();
        let mut found: Vec<[f64; 2]> =
            each.filter_map(|corners| clipped(corners, from, along, range, near)).collect();
        found.sort_by(|a, b| a[0].total_cmp(&b[0]));
        let mut spans: Vec<[f64; 2]> = Vec::new();
        for [low, high] in found {
            match spans.last_mut() {
                Some(last) if low <= last[1] => last[1] = last[1].max(high),
                _ => spans.push([low, high]),
            }
        }
        spans
    }

    /// The point at a place (m) in the tetrahedron that holds it or comes nearest to it, and its least weight there: below zero outside.
    #[must_use]
    pub fn point(&self, at: Vec3) -> Option<(Inside, f64)> {
        let mut best = None;
        for (nodes, corners) in self.nodes.iter().zip(&self.corners) {
            let Some(weights) = weights(corners, at) else {
                continue;
            };
            let least = weights.into_iter().fold(f64::INFINITY, f64::min);
            if best.is_none_or(|(_, most)| least > most) {
                let nodes = *nodes;
                best = Some((Inside::Tetrahedron { nodes, weights }, least));
            }
        }
        best
    }
}

/// Weights of the corners at a place; `None` where the tetrahedron has no volume.
fn weights(corners: &[Vec3; 4], at: Vec3) -> Option<[f64; 4]> {
    let [b, c, d, r] = [corners[1], corners[2], corners[3], at].map(|x| x - corners[0]);
    let six = b.cross(c).dot(d);
    let [p, q, s] = [c.cross(d), d.cross(b), b.cross(c)].map(|n| n.dot(r) / six);
    let all = [1.0 - p - q - s, p, q, s];
    all.iter().all(|w| w.is_finite()).then_some(all)
}

/// The part of a line inside a tetrahedron; what is less than `near` (m) outside a face counts as inside.
fn clipped(
    corners: &[Vec3; 4],
    from: Vec3,
    along: Vec3,
    [mut low, mut high]: [f64; 2],
    near: f64,
) -> Option<[f64; 2]> {
    for k in 0..4 {
        let [a, b, c] = [1, 2, 3].map(|j| corners[(k + j) % 4]);
        let normal = (b - a).cross(c - a).normalize_or_zero();
        // Outward: the corner left over lies behind.
        let normal = match normal.dot(corners[k] - a) > 0.0 {
            true => -normal,
            false => normal,
        };
        let (height, rate) = (normal.dot(from - a), normal.dot(along));
        let gap = height - near;
        if rate > 0.0 {
            high = high.min(-gap / rate);
        } else if rate < 0.0 {
            low = low.max(-gap / rate);
        } else if gap > 0.0 {
            return None;
        }
    }
    (high > low).then_some([low, high])
}

#[cfg(test)]
mod tests {
    use super::*;
    use riprap_geom::polyhedron::Polyhedron;

    fn star(half: Vec3, place: impl Fn(Vec3) -> Vec3) -> TetFan {
        let mesh = Tetrahedra::new(&Polyhedron::brick(Vec3::ZERO, half)).unwrap();
        let corners = mesh.tets.iter();
        TetFan {
            corners: corners.map(|t| t.map(|n| place(mesh.nodes[n as usize]))).collect(),
            nodes: mesh.tets,
        }
    }

    #[test]
    fn a_line_through_nodes_edges_and_faces_is_in_one_piece() {
        let half = Vec3::new(0.3, 0.5, 1.0);
        let moved = Vec3::new(31.7, -2.9, 7.3);
        let block = star(half, |x| x + moved);
        for to in [
            Vec3::Z,
            Vec3::new(0.3, 0.5, 1.0),
            Vec3::new(0.3, 0.0, 1.0),
            Vec3::new(0.0, 0.25, 1.0),
            Vec3::new(0.1, -0.2, 0.9),
        ] {
            let along = to.normalize();
            let spans = block.spans(moved - 5.0 * along, along, [0.0, 10.0]);
            let reach = (half / along.abs()).min_element();
            assert_eq!(spans.len(), 1, "{to} {spans:?}");
            let [low, high] = spans[0];
            assert!((low - 5.0 + reach).abs() < 1e-9 && (high - 5.0 - reach).abs() < 1e-9);
        }
        let beside = block.spans(moved + 0.6 * Vec3::Y, Vec3::Z, [-10.0, 10.0]);
        assert_eq!(beside, Vec::<[f64; 2]>::new());
    }

    #[test]
    fn a_point_of_a_sheared_block_is_that_of_the_block_before() {
        let half = Vec3::new(0.3, 0.5, 1.0);
        let shear = |x: Vec3| x + Vec3::new(0.2 * x.z, 0.0, 0.1 * x.x);
        let (before, after) = (star(half, |x| x), star(half, shear));
        for at in [Vec3::new(0.1, -0.2, 0.6), Vec3::new(-0.25, 0.4, -0.9), Vec3::ZERO] {
            let (one, least) = before.point(at).unwrap();
            let (two, _) = after.point(shear(at)).unwrap();
            assert!(least > -1e-12);
            let place = |inside: &Inside| -> Vec3 {
                let mesh = Tetrahedra::new(&Polyhedron::brick(Vec3::ZERO, half)).unwrap();
                inside.nodes().map(|(n, w)| w * mesh.nodes[n as usize]).sum()
            };
            assert!((place(&one) - at).length() < 1e-14);
            assert!((place(&two) - at).length() < 1e-14);
        }
        let (_, least) = before.point(Vec3::new(0.31, 0.0, 0.0)).unwrap();
        assert!(least < 0.0);
    }
}
