//! Loose packings of solids: random convex polyhedra that do not overlap, ready to be poured.

use super::{Polyhedron, voronoi};
use crate::error::demand;
use crate::random::Chance;
use crate::shapes::capped;
use crate::{GeomError, Quat, Vec3};

/// What to pour.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pour {
    /// Lowest and highest corner of the box to fill from below, m.
    pub region: (Vec3, Vec3),
    /// Number of blocks.
    pub count: usize,
    /// Smallest and largest diameter of the sphere about the centroid that holds a block, m.
    pub size: (f64, f64),
    /// Seed.
    pub seed: u64,
}

/// Gap between the spheres round neighbouring blocks, of the largest diameter.
const GAP: f64 = 0.02;
/// Most different shapes; beyond them shapes come again, with other sizes and attitudes.
const SHAPES: usize = 500;
/// Lloyd iterations: cells of random points are splintery, relaxed ones are like blocks of rock.
const RELAX: usize = 3;

/// Cells of a Voronoi tessellation of random points, each of random size and attitude, on a lattice of cubes filled layer by layer
/// from below, at a random place within its cube. The spheres about the blocks do not touch, so blocks do not.
///
/// *Errors*: sizes out of order, a box without volume, blocks that do not fit.
pub fn pour(pour: &Pour) -> Result<Vec<Polyhedron>, GeomError> {
    let Pour { region: (min, max), count, size: (small, large), seed } = *pour;
    demand("the smallest size", small, small > 0.0, "above 0")?;
    let ordered = large >= small;
    demand("the largest size", large, ordered, "at least the smallest")?;
    capped("blocks", count as f64)?;
    let extent = max - min;
    let shortest = extent.min_element();
    let sound = shortest > 0.0;
    demand("the shortest edge of the box", shortest, sound, "above 0")?;
    let pitch = large * (1.0 + GAP);
    let fits = (extent / pitch).floor();
    if fits.element_product() < count as f64 {
        return Err(GeomError::DoesNotFit {
            wanted: count,
            size: large,
            capacity: fits.element_product() as usize,
        });
    }
    if count == 0 {
        return Ok(Vec::new());
    }
    // Whatever the pitch leaves over along x and y is spread between the blocks.
    let [columns, rows] = [fits.x, fits.y].map(|n| (n as usize).clamp(1, count));
    let cube = Vec3::new(extent.x / columns as f64, extent.y / rows as f64, pitch);
    let shapes = shapes(count.min(SHAPES), seed)?;
    let mut chance = Chance::new(seed);
    let blocks = (0..count).map(|k| {
        let radius = 0.5 * chance.between(small, large);
        let play = (0.5 * cube - Vec3::splat(radius + 0.5 * GAP * large)).max(Vec3::ZERO);
        let jitter = Vec3::from_array([0, 1, 2].map(|a| chance.between(-play[a], play[a])));
        let place = [k % columns, k / columns % rows, k / (columns * rows)];
        let place = Vec3::from_array(place.map(|n| n as f64 + 0.5));
        let (centre, turn) = (min + place * cube + jitter, attitude(&mut chance));
        let shape = &shapes[k % shapes.len()];
        Polyhedron {
            vertices: (shape.vertices.iter().map(|v| centre + radius * (turn * *v))).collect(),
            faces: shape.faces.clone(),
        }
    });
    Ok(blocks.collect())
}

/// So many cells that do not touch the box they were cut from, each about its centroid, in a sphere of radius 1.
fn shapes(count: usize, seed: u64) -> Result<Vec<Polyhedron>, GeomError> {
    // A cell at the box is no rarer than two layers a side; half a cell more is for cells that reach inwards.
    let mut edge = libm::cbrt(count as f64).ceil() + 2.0;
    loop {
        let half = Vec3::splat(0.5 * edge);
        let cells = voronoi(-half, half, 1.0, seed, RELAX)?;
        let inside = |c: &Polyhedron| {
            let reach = c.vertices.iter().map(|v| v.abs().max_element());
            reach.fold(0.0, f64::max) < 0.5 * edge * (1.0 - 1e-9)
        };
        let found: Vec<Polyhedron> = cells.into_iter().filter(inside).take(count).collect();
        if found.len() == count {
            return Ok(found.into_iter().map(within_unit_sphere).collect());
        }
        edge += 1.0;
    }
}

fn within_unit_sphere(mut cell: Polyhedron) -> Polyhedron {
    let centroid = cell.moments().centroid;
    cell.vertices.iter_mut().for_each(|v| *v -= centroid);
    let farthest = cell.vertices.iter().map(|v| v.length());
    let radius = farthest.fold(0.0, f64::max);
    cell.vertices.iter_mut().for_each(|v| *v /= radius);
    cell
}

/// A random attitude, all alike likely (Shoemake 1992, Graphics Gems III, Uniform random rotations).
fn attitude(chance: &mut Chance) -> Quat {
    let share = chance.unit();
    let [a, b] = [0, 1].map(|_| std::f64::consts::TAU * chance.unit());
    let (p, q) = ((1.0 - share).sqrt(), share.sqrt());
    Quat::from_xyzw(p * libm::sin(a), p * libm::cos(a), q * libm::sin(b), q * libm::cos(b))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn example() -> Pour {
        Pour {
            region: (Vec3::ZERO, Vec3::new(3.0, 4.0, 5.0)),
            count: 500,
            size: (0.2, 0.4),
            seed: 3,
        }
    }

    #[test]
    fn blocks_are_sound_inside_apart_and_of_the_size_asked_for() {
        for seed in [1, 2, 77] {
            let what = Pour { seed, ..example() };
            let blocks = pour(&what).unwrap();
            assert_eq!(blocks, pour(&what).unwrap());
            assert_eq!(blocks.len(), 500);
            let spheres: Vec<(Vec3, f64)> = blocks
                .iter()
                .map(|block| {
                    block.validate().unwrap();
                    let (low, high) = block.bounds();
                    assert!(low.cmpge(what.region.0).all() && high.cmple(what.region.1).all());
                    let centroid = block.moments().centroid;
                    let reach = block.vertices.iter().map(|v| v.distance(centroid));
                    (centroid, reach.fold(0.0, f64::max))
                })
                .collect();
            for (k, (at, radius)) in spheres.iter().enumerate() {
                assert!((0.1..0.2).contains(radius), "{radius}");
                for (other, reach) in &spheres[..k] {
                    assert!(at.distance(*other) > radius + reach);
                }
            }
            let faces: usize = blocks.iter().map(|b| b.faces.len()).sum();
            let mean = faces as f64 / 500.0;
            assert!((13.0..16.0).contains(&mean), "{mean} faces");
        }
    }

    /// The mean of a turned unit vector is nil and its square a third along each axis.
    #[test]
    fn attitudes_prefer_no_direction() {
        let mut chance = Chance::new(5);
        let turned: Vec<Vec3> = (0..4000).map(|_| attitude(&mut chance) * Vec3::X).collect();
        let mean = turned.iter().sum::<Vec3>() / 4000.0;
        let square = turned.iter().map(|v| *v * *v).sum::<Vec3>() / 4000.0;
        assert!(mean.length() < 0.03, "{mean}");
        assert!((square - Vec3::splat(1.0 / 3.0)).length() < 0.02, "{square}");
        assert!(turned.iter().all(|v| (v.length() - 1.0).abs() < 1e-12));
    }

    #[test]
    fn says_when_they_do_not_fit() {
        let error = pour(&Pour { count: 2000, ..example() });
        let capacity = 7 * 9 * 12;
        assert_eq!(error.unwrap_err(), GeomError::DoesNotFit { wanted: 2000, size: 0.4, capacity });
        for (count, size) in
            [(1, (f64::NAN, 1.0)), (usize::MAX, (0.2, 0.4)), (1, (1e-300, 50.0)), (1, (0.0, 0.0))]
        {
            let what = Pour { count, size, ..example() };
            assert!(pour(&what).is_err());
        }
        let nothing = Pour { count: 0, ..example() };
        assert_eq!(pour(&nothing).unwrap().len(), 0);
    }
}
