//! Which boxes of a list overlap: a grid. For checks at input, not the search of an engine.

use crate::Vec2;
use crate::polygon::Aabb;

/// A box over more squares than this is compared with all others instead.
const MANY_SQUARES: f64 = 64.0;

/// All pairs `(i, j)`, `i < j`, whose boxes overlap or touch, sorted; `None` if there are more than
/// `cap`. Boxes that are not finite touch nothing.
///
/// *Cost*: boxes plus pairs, and boxes times those much larger than the median.
pub fn touching_boxes(boxes: &[Aabb], cap: usize) -> Option<Vec<(u32, u32)>> {
    let finite = |b: &Aabb| b.min.is_finite() && b.max.is_finite();
    let mut extents: Vec<f64> =
        boxes.iter().filter(|b| finite(b)).map(|b| (b.max - b.min).max_element()).collect();
    extents.sort_by(f64::total_cmp);
    let corner = boxes.iter().filter(|b| finite(b)).fold(Vec2::MAX, |c, b| c.min(b.min));
    let far = boxes.iter().filter(|b| finite(b)).fold(Vec2::MIN, |c, b| c.max(b.max));
    let median = extents.get(extents.len() / 2).copied().unwrap_or(0.0);
    // Squares of about two boxes; never so small that their numbers lose digits.
    let side = (2.0 * median).max(1e-9 * (far - corner).max_element()).max(f64::MIN_POSITIVE);
    let square = |p: Vec2| ((p - corner) / side).floor();
    let (mut entries, mut large): (Vec<([i64; 2], u32)>, Vec<u32>) = (Vec::new(), Vec::new());
    for (i, b) in boxes.iter().enumerate().filter(|(_, b)| finite(b)) {
        let (low, high) = (square(b.min), square(b.max));
        let across = high - low + Vec2::ONE;
        if across.x * across.y > MANY_SQUARES {
            large.push(i as u32);
            continue;
        }
        for x in low.x as i64..=high.x as i64 {
            entries.extend((low.y as i64..=high.y as i64).map(|y| ([x, y], i as u32)));
        }
    }
    entries.sort_unstable();
    let mut pairs = Vec::new();
    for group in entries.chunk_by(|a, b| a.0 == b.0) {
        for (k, &(cell, i)) in group.iter().enumerate() {
            for &(_, j) in &group[k + 1..] {
                let (a, b) = (&boxes[i as usize], &boxes[j as usize]);
                // Of the squares that both are in, the one with the corner of their common part.
                let first = square(a.min.max(b.min));
                if a.touches(b) && [first.x as i64, first.y as i64] == cell {
                    pairs.push((i, j));
                }
            }
            if pairs.len() > cap {
                return None;
            }
        }
    }
    for (k, &i) in large.iter().enumerate() {
        for j in 0..boxes.len() as u32 {
            // Two large ones are met once, from the earlier.
            let met = large[..=k].binary_search(&j).is_ok();
            if !met && boxes[i as usize].touches(&boxes[j as usize]) {
                pairs.push((i.min(j), i.max(j)));
            }
        }
        if pairs.len() > cap {
            return None;
        }
    }
    pairs.sort_unstable();
    Some(pairs)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn boxes(list: &[(f64, f64, f64, f64)]) -> Vec<Aabb> {
        let make = |&(x, y, w, h): &(f64, f64, f64, f64)| {
            let corner = Vec2::new(x, y);
            Aabb { min: corner, max: corner + Vec2::new(w, h) }
        };
        list.iter().map(make).collect()
    }

    proptest! {
        #[test]
        fn finds_what_the_double_loop_finds(
            list in prop::collection::vec((-9.0..9.0f64, -9.0..9.0f64, 0.0..1.0f64, 0.0..2.0f64), 0..60),
            long in prop::collection::vec((-9.0..9.0f64, -9.0..9.0f64, 0.0..90.0f64, 0.0..90.0f64), 0..4),
        ) {
            let mut all = boxes(&list);
            all.extend(boxes(&long));
            let mut plain = Vec::new();
            for i in 0..all.len() {
                for j in i + 1..all.len() {
                    if all[i].touches(&all[j]) {
                        plain.push((i as u32, j as u32));
                    }
                }
            }
            prop_assert_eq!(touching_boxes(&all, 10_000), Some(plain));
        }
    }

    #[test]
    fn heaps_and_towers_end() {
        let heap = boxes(&[(0.0, 0.0, 1.0, 1.0); 3000]);
        assert_eq!(touching_boxes(&heap, 1000), None);
        let tower: Vec<(f64, f64, f64, f64)> =
            (0..50_000).map(|k| (0.0, f64::from(k), 1.0, 1.0)).collect();
        assert_eq!(touching_boxes(&boxes(&tower), 200_000).map(|p| p.len()), Some(49_999));
        let points =
            boxes(&[(0.0, 0.0, 0.0, 0.0), (0.0, 0.0, 0.0, 0.0), (f64::NAN, 0.0, 1.0, 1.0)]);
        assert_eq!(touching_boxes(&points, 10), Some(vec![(0, 1)]));
        assert_eq!(touching_boxes(&[], 10), Some(Vec::new()));
    }
}
