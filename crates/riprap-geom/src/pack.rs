//! Loose packings: random convex polygons that do not overlap, ready to be poured.

use crate::error::demand;
use crate::polygon::Aabb;
use crate::random::Chance;
use crate::shapes::{capped, unit};
use crate::{GeomError, Vec2};

/// What to pour.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pour {
    /// Rectangle to fill from below, m.
    pub region: Aabb,
    /// Number of blocks.
    pub count: usize,
    /// Smallest and largest diameter of the circle through the corners, m.
    pub size: (f64, f64),
    /// Fewest and most corners.
    pub vertices: (usize, usize),
    /// Seed.
    pub seed: u64,
}

/// Gap between the circles round neighbouring blocks, of the largest diameter.
const GAP: f64 = 0.02;

/// Random convex polygons on a lattice of squares, row by row from below: corners on a circle of
/// random diameter, each within 0.3 of its share of the circle, turned at random, placed at random
/// within its square. Circles do not touch, so blocks do not.
pub fn pour(pour: &Pour) -> Result<Vec<Vec<Vec2>>, GeomError> {
    let Pour { region, count, size: (small, large), vertices: (few, many), seed } = *pour;
    demand("the smallest size", small, small > 0.0, "above 0")?;
    demand("the largest size", large, large >= small, "at least the smallest")?;
    demand("the fewest corners", few as f64, few >= 3, "at least 3")?;
    demand("the most corners", many as f64, many >= few, "at least the fewest")?;
    demand("the most corners", many as f64, many <= 1000, "at most 1000")?;
    capped("blocks", count as f64)?;
    let extent = region.max - region.min;
    demand("the width of the region", extent.x, extent.x > 0.0, "above 0")?;
    demand("the height of the region", extent.y, extent.y > 0.0, "above 0")?;
    let pitch = large * (1.0 + GAP);
    let fit = |length: f64| (length / pitch).floor();
    let (columns, rows) = (fit(extent.x), fit(extent.y));
    if columns * rows < count as f64 {
        let capacity = (columns * rows) as usize;
        return Err(GeomError::DoesNotFit { wanted: count, size: large, capacity });
    }
    // Whatever the pitch leaves over is spread between the columns. At least one column fits
    // whenever a block is wanted; with more columns than blocks, only the row is longer.
    let columns = (columns as usize).max(1);
    let width = extent.x / columns as f64;
    let mut chance = Chance::new(seed);
    let mut blocks = Vec::with_capacity(count);
    for k in 0..count {
        let radius = 0.5 * chance.between(small, large);
        let cell = Vec2::new((k % columns) as f64 * width, (k / columns) as f64 * pitch);
        let middle = cell + 0.5 * Vec2::new(width, pitch);
        let play = (0.5 * Vec2::new(width, pitch) - Vec2::splat(radius + 0.5 * GAP * large))
            .max(Vec2::ZERO);
        let jitter = Vec2::new(chance.between(-play.x, play.x), chance.between(-play.y, play.y));
        let corners = chance.whole(few, many);
        let turned = chance.between(0.0, std::f64::consts::TAU);
        let share = std::f64::consts::TAU / corners as f64;
        let centre = region.min + middle + jitter;
        let corner = |i: usize, chance: &mut Chance| {
            let angle = turned + share * (i as f64 + chance.between(-0.3, 0.3));
            centre + radius * unit(angle)
        };
        blocks.push((0..corners).map(|i| corner(i, &mut chance)).collect());
    }
    Ok(blocks)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pairs::touching_boxes;
    use crate::polygon::{is_convex, validate};
    use proptest::prelude::*;

    fn example() -> Pour {
        Pour {
            region: Aabb { min: Vec2::ZERO, max: Vec2::new(10.0, 20.0) },
            count: 800,
            size: (0.2, 0.4),
            vertices: (4, 7),
            seed: 3,
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(16))]
        #[test]
        fn blocks_are_convex_inside_and_apart(seed in any::<u64>()) {
            let what = Pour { seed, ..example() };
            let blocks = pour(&what).unwrap();
            prop_assert_eq!(&blocks, &pour(&what).unwrap());
            prop_assert_eq!(blocks.len(), 800);
            let boxes: Vec<Aabb> = blocks.iter().map(|b| Aabb::of(b)).collect();
            for (block, bounds) in blocks.iter().zip(&boxes) {
                prop_assert!(validate(block).is_ok() && is_convex(block));
                prop_assert!(bounds.min.cmpge(what.region.min).all());
                prop_assert!(bounds.max.cmple(what.region.max).all());
            }
            for (i, j) in touching_boxes(&boxes, 1_000_000).unwrap() {
                let (a, b) = (&blocks[i as usize], &blocks[j as usize]);
                prop_assert_eq!(crate::clip::intersection_area(a, b), 0.0);
            }
        }
    }

    #[test]
    fn says_when_they_do_not_fit() {
        let error = pour(&Pour { count: 2000, ..example() }).unwrap_err();
        assert_eq!(error, GeomError::DoesNotFit { wanted: 2000, size: 0.4, capacity: 24 * 49 });
        for (count, size) in
            [(1, (f64::NAN, 1.0)), (usize::MAX, (0.2, 0.4)), (1, (1e-300, 50.0)), (1, (0.0, 0.0))]
        {
            assert!(pour(&Pour { count, size, ..example() }).is_err());
        }
        assert!(pour(&Pour { vertices: (2, 3), ..example() }).is_err());
        assert_eq!(pour(&Pour { count: 0, ..example() }).unwrap().len(), 0);
    }
}
