//! The surface of a heap: its angle of repose and its swell.

use riprap_geom::pairs::touching_boxes;
use riprap_geom::polygon::Aabb;
use riprap_geom::{Vec2, Vec3};

use crate::faces::deformable::centred;
use crate::query::view::View;
use crate::setup::Shape;

/// Rings about the axis of a heap.
const RINGS: usize = 30;
/// Places in each ring at which the surface is looked at.
const PLACES: usize = 72;
/// Columns of the grid in which the volume under a surface is measured, each way.
const COLUMNS: usize = 300;
/// Least share of the mass of the group that makes a heap; less are stones that rolled away.
const HEAP: f64 = 0.05;
/// Most pairs of neighbours that are looked at for heaps that stand apart; where there are more, all is one heap.
const MOST_NEIGHBOURS: usize = 50_000_000;

/// A block seen from above: two coordinates across the vertical and the height, m.
#[derive(Clone, Debug)]
struct Stone {
    mass: f64,
    centroid: Vec3,
    vertices: Vec<Vec3>,
    faces: Vec<Vec<u32>>,
}

impl Stone {
    fn bounds(&self) -> Aabb {
        let flat = self.vertices.iter().map(|v| v.truncate());
        let start = Aabb { min: Vec2::INFINITY, max: Vec2::NEG_INFINITY };
        flat.fold(start, |b, p| Aabb { min: b.min.min(p), max: b.max.max(p) })
    }

    /// Height of its highest point over a place; `None` beside it.
    fn top(&self, at: Vec2) -> Option<f64> {
        let triangles = self.faces.iter().flat_map(|face| {
            let corner = |k: usize| self.vertices[face[k] as usize];
            (1..face.len().saturating_sub(1)).map(move |k| [corner(0), corner(k), corner(k + 1)])
        });
        triangles.filter_map(|t| height(t, at)).reduce(f64::max)
    }
}

/// Height of a triangle over a place; `None` beside it and for one on edge.
fn height([a, b, c]: [Vec3; 3], at: Vec2) -> Option<f64> {
    let (p, q, r) = (a.truncate(), b.truncate(), c.truncate());
    let twice = (q - p).perp_dot(r - p);
    if twice == 0.0 {
        return None;
    }
    let v = (at - p).perp_dot(r - p) / twice;
    let w = (q - p).perp_dot(at - p) / twice;
    (v >= 0.0 && w >= 0.0 && v + w <= 1.0).then_some(a.z + v * (b.z - a.z) + w * (c.z - a.z))
}

/// Slope of the surface of a heap made of the given blocks, rad; 0 without blocks. Heaps that stand apart, by more than the width of
/// the widest block, are measured one by one: the mean of their angles, weighted by mass.
pub(super) fn repose_angle(view: &View<'_>, of: impl Iterator<Item = usize>) -> f64 {
    let up = view.up();
    let across = up.any_orthonormal_vector();
    let axes = [across, up.cross(across), up];
    let stones = of.filter_map(|b| stone(view, b, axes)).collect();
    angle_of(stones)
}

/// Volume under the surface of the given blocks, seen from above, down to the lowest of their corners, over their own volume: of a heap on level ground.
/// Hollows below the surface count, as in a survey; 0 without blocks.
pub(super) fn swell(view: &View<'_>, of: impl Iterator<Item = usize>) -> f64 {
    let up = view.up();
    let across = up.any_orthonormal_vector();
    let axes = [across, up.cross(across), up];
    let (mut stones, mut volume) = (Vec::new(), 0.0);
    for b in of {
        if let Some(stone) = stone(view, b, axes) {
            stones.push(stone);
            volume += view.world.solid_of(b).volume;
        }
    }
    if volume > 0.0 { under(&stones) / volume } else { 0.0 }
}

/// Volume between the surface of the stones and their lowest corner, m³.
fn under(stones: &[Stone]) -> f64 {
    if stones.is_empty() {
        return 0.0;
    }
    let heights = stones.iter().flat_map(|s| &s.vertices).map(|v| v.z);
    let floor = heights.fold(f64::INFINITY, f64::min);
    let start = Aabb { min: Vec2::INFINITY, max: Vec2::NEG_INFINITY };
    let boxes: Vec<Aabb> = stones.iter().map(Stone::bounds).collect();
    let all =
        boxes.iter().fold(start, |a, b| Aabb { min: a.min.min(b.min), max: a.max.max(b.max) });
    let cell = (all.max - all.min) / COLUMNS as f64;
    let mut tops = vec![0.0_f64; COLUMNS * COLUMNS];
    for (stone, bounds) in stones.iter().zip(boxes) {
        let [from, to] = [bounds.min, bounds.max].map(|at| (at - all.min) / cell);
        let range = |from: f64, to: f64| from as usize..COLUMNS.min(to as usize + 1);
        for i in range(from.x, to.x) {
            for j in range(from.y, to.y) {
                let at = all.min + cell * Vec2::new(i as f64 + 0.5, j as f64 + 0.5);
                let top = &mut tops[i * COLUMNS + j];
                *top = top.max(stone.top(at).map_or(0.0, |z| z - floor));
            }
        }
    }
    tops.iter().sum::<f64>() * cell.x * cell.y
}

/// A block at its present place; `None` for terrain.
fn stone(view: &View<'_>, b: usize, axes: [Vec3; 3]) -> Option<Stone> {
    let world = view.world;
    if matches!(world.setup.blocks[b].shape, Shape::Terrain(_)) {
        return None;
    }
    let centroid = view.position(b);
    let attitude = world.pose(b).rotation;
    let (body, _) = centred(&world.setup.blocks[b].shape);
    let seen = |at: Vec3| Vec3::from_array(axes.map(|axis| axis.dot(at)));
    let deformable = view.deformable(b);
    let place = |(k, arm): (usize, Vec3)| match &deformable {
        Some(deformable) => seen(deformable.place(deformable.body.first as usize + k)),
        None => seen(centroid + attitude * arm),
    };
    Some(Stone {
        mass: world.solid_of(b).mass,
        centroid: seen(centroid),
        vertices: body.vertices.into_iter().enumerate().map(place).collect(),
        faces: body.faces,
    })
}

/// Mean angle of the heaps that the stones make, rad.
fn angle_of(stones: Vec<Stone>) -> f64 {
    let total: f64 = stones.iter().map(|s| s.mass).sum();
    let (mut sum, mut counted) = (0.0, 0.0);
    for heap in heaps(stones) {
        let mass: f64 = heap.iter().map(|s| s.mass).sum();
        if mass >= HEAP * total {
            sum += mass * slope_angle(&heap);
            counted += mass;
        }
    }
    if counted > 0.0 { sum / counted } else { 0.0 }
}

/// Sorts stones into heaps: within one, the boxes about the stones seen from above come nearer to each other than the widest is wide.
fn heaps(stones: Vec<Stone>) -> Vec<Vec<Stone>> {
    let boxes: Vec<Aabb> = stones.iter().map(Stone::bounds).collect();
    let widths = boxes.iter().map(|b| (b.max - b.min).max_element());
    let reach = Vec2::splat(0.5 * widths.fold(0.0, f64::max));
    let wide: Vec<Aabb> =
        boxes.iter().map(|b| Aabb { min: b.min - reach, max: b.max + reach }).collect();
    let Some(pairs) = touching_boxes(&wide, MOST_NEIGHBOURS) else {
        return vec![stones];
    };
    // Every stone points to one of its heap with a smaller number, the first to itself.
    let mut leads: Vec<usize> = (0..stones.len()).collect();
    for (i, j) in pairs {
        let [i, j] = [i, j].map(|k| leader(&mut leads, k as usize));
        // The smaller number leads, so that heaps come in one order.
        leads[i.max(j)] = i.min(j);
    }
    let mut found: Vec<Vec<Stone>> = vec![Vec::new(); stones.len()];
    for (k, stone) in stones.into_iter().enumerate() {
        found[leader(&mut leads, k)].push(stone);
    }
    found.retain(|heap| !heap.is_empty());
    found
}

fn leader(leads: &mut [usize], mut k: usize) -> usize {
    while leads[k] != k {
        leads[k] = leads[leads[k]];
        k = leads[k];
    }
    k
}

/// Slope of one heap, rad.
///
/// Its axis is the vertical through the mean of the centroids, weighted with mass and height above the lowest point, so that stones that
/// rolled away hardly count. It reaches to the radius that holds 99 % of the mass, in [`RINGS`] rings. The profile is the
/// height of the highest point over [`PLACES`] places of each ring, averaged over the ring. A straight line is fitted to it where it lies
/// between 20 % and 80 % of the height of the heap (toe and crest are rounded), outside of the crest: the highest mean of three rings.
fn slope_angle(stones: &[Stone]) -> f64 {
    let heights = stones.iter().flat_map(|s| &s.vertices).map(|v| v.z);
    let floor = heights.fold(f64::INFINITY, f64::min);
    let weight = |s: &Stone| s.mass * (s.centroid.z - floor);
    let all: f64 = stones.iter().map(weight).sum();
    let axis = stones.iter().map(|s| weight(s) * s.centroid.truncate());
    let axis = axis.sum::<Vec2>() / all;
    let radius = reach(stones, axis);
    if radius.is_nan() || radius <= 0.0 {
        return 0.0;
    }
    let width = radius / RINGS as f64;
    let at = |k: usize, place: usize| {
        let angle = std::f64::consts::TAU * (place as f64 + 0.5) / PLACES as f64;
        axis + (k as f64 + 0.5) * width * Vec2::new(libm::cos(angle), libm::sin(angle))
    };
    let places: Vec<Vec2> = (0..RINGS * PLACES).map(|k| at(k / PLACES, k % PLACES)).collect();
    let mut tops = vec![0.0_f64; places.len()];
    for stone in stones {
        let Aabb { min, max } = stone.bounds();
        for (place, top) in places.iter().zip(&mut tops) {
            if place.cmpge(min).all() && place.cmple(max).all() {
                *top = top.max(stone.top(*place).map_or(0.0, |z| z - floor));
            }
        }
    }
    let mean = |ring: &[f64]| ring.iter().sum::<f64>() / PLACES as f64;
    let profile: Vec<f64> = tops.chunks(PLACES).map(mean).collect();
    let three = |k: usize| (profile[k - 1] + profile[k] + profile[k + 1]) / 3.0;
    let highest = (1..RINGS - 1).max_by(|&a, &b| three(a).total_cmp(&three(b)));
    let crest = highest.unwrap_or(1);
    let height = three(crest);
    let flank: Vec<Vec2> = (crest..RINGS)
        .map(|k| Vec2::new((k as f64 + 0.5) * width, profile[k]))
        .filter(|p| (0.2 * height..=0.8 * height).contains(&p.y))
        .collect();
    // The profile falls outward.
    fitted_slope(&flank).map_or(0.0, |slope| libm::atan(-slope))
}

/// Distance from the axis within which 99 % of the mass lies, by centroids, m.
fn reach(stones: &[Stone], axis: Vec2) -> f64 {
    let distance = |s: &Stone| (s.centroid.truncate().distance(axis), s.mass);
    let mut places: Vec<(f64, f64)> = stones.iter().map(distance).collect();
    places.sort_by(|a, b| a.0.total_cmp(&b.0));
    let total: f64 = places.iter().map(|(_, mass)| mass).sum();
    let mut sum = 0.0;
    let found = places.iter().find(|(_, mass)| {
        sum += mass;
        sum >= 0.99 * total
    });
    found.map_or(0.0, |(distance, _)| *distance)
}

/// Slope of the least-squares line; `None` for fewer than three points.
fn fitted_slope(points: &[Vec2]) -> Option<f64> {
    if points.len() < 3 {
        return None;
    }
    let mean = points.iter().sum::<Vec2>() / points.len() as f64;
    let sxy: f64 = points.iter().map(|p| (p.x - mean.x) * (p.y - mean.y)).sum();
    let sxx: f64 = points.iter().map(|p| (p.x - mean.x) * (p.x - mean.x)).sum();
    (sxx > 0.0).then(|| sxy / sxx)
}

#[cfg(test)]
mod tests {
    use super::*;
    use riprap_geom::polyhedron::Polyhedron;

    /// Pillars whose tops make a cone of that slope about a place.
    fn cone(slope: f64, middle: Vec2) -> Vec<Stone> {
        let half = 0.05;
        let mut stones = Vec::new();
        for i in -60..=60 {
            for j in -60..=60 {
                let at = 2.0 * half * Vec2::new(f64::from(i), f64::from(j));
                let height = 0.5 * (3.0 - slope * at.length());
                if height > 0.0 {
                    stones.push(pillar(middle + at, half, height));
                }
            }
        }
        stones
    }

    /// A pillar from the floor to twice the height given.
    fn pillar(at: Vec2, half: f64, height: f64) -> Stone {
        let centre = at.extend(height);
        let Polyhedron { vertices, faces } =
            Polyhedron::brick(centre, Vec3::new(half, half, height));
        Stone { mass: height, centroid: centre, vertices, faces }
    }

    #[test]
    fn a_cone_has_its_angle_wherever_it_stands() {
        for degrees in [20.0, 30.0, 40.0] {
            let slope = f64::to_radians(degrees).tan();
            let mut stones = cone(slope, Vec2::new(30.0, -20.0));
            // One that has rolled away, though not out of reach of the heap's neighbours, must not count.
            stones.push(pillar(Vec2::new(39.0, -20.0), 0.05, 0.01));
            let found = angle_of(stones).to_degrees();
            assert!((found - degrees).abs() < 0.4, "{found} {degrees}");
        }
    }

    #[test]
    fn heaps_that_stand_apart_count_by_their_mass() {
        let slope = |degrees: f64| degrees.to_radians().tan();
        let mut stones = cone(slope(25.0), Vec2::ZERO);
        let first: f64 = stones.iter().map(|s| s.mass).sum();
        stones.extend(cone(slope(35.0), Vec2::new(20.0, 0.0)));
        let all: f64 = stones.iter().map(|s| s.mass).sum();
        assert_eq!(heaps(stones.clone()).len(), 2);
        let wanted = 35.0 - 10.0 * first / all;
        let found = angle_of(stones).to_degrees();
        assert!((found - wanted).abs() < 0.4, "{found} {wanted}");
    }

    #[test]
    fn what_lies_under_a_surface_counts_with_its_hollows() {
        // A bridge: a plate of 0.5 m on two pillars of 1 m, 3 m by 1 m; and a stone beside it.
        let slab = |middle: Vec3, half: Vec3| {
            let Polyhedron { vertices, faces } = Polyhedron::brick(middle, half);
            Stone { mass: 1.0, centroid: middle, vertices, faces }
        };
        let bridge = vec![
            slab(Vec3::new(-1.25, 0.0, 0.5), Vec3::new(0.25, 0.5, 0.5)),
            slab(Vec3::new(1.25, 0.0, 0.5), Vec3::new(0.25, 0.5, 0.5)),
            slab(Vec3::new(0.0, 0.0, 1.25), Vec3::new(1.5, 0.5, 0.25)),
            slab(Vec3::new(4.0, 0.0, 0.25), Vec3::new(0.5, 0.5, 0.25)),
        ];
        let found = under(&bridge);
        assert!((found / (4.5 + 0.5) - 1.0).abs() < 0.01, "{found}");
        assert_eq!(under(&[]), 0.0);
    }

    #[test]
    fn nothing_is_flat() {
        assert_eq!(angle_of(Vec::new()), 0.0);
        assert_eq!(angle_of(vec![pillar(Vec2::ZERO, 1.0, 1.0)]), 0.0);
    }
}
