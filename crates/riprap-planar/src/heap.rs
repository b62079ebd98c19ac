//! The outline of a heap and its angle of repose.

use riprap_geom::Vec2;

use super::view::View;

/// Bins across the heap.
const BINS: usize = 60;

/// Least share of the mass of the group that makes a heap; less are grains that rolled away.
const HEAP: f64 = 0.05;

/// Mean slope of both flanks of a heap made of the given blocks, rad; 0 without living blocks. Heaps that stand apart, by more
/// than the width of the widest block, are measured one by one: the mean of their angles, weighted by mass.
pub(crate) fn repose_angle(view: &View<'_>, of: &[u32]) -> f64 {
    let scratch = view.scratch;
    let mut outlines = Vec::new();
    for &b in of.iter().filter(|&&b| view.world.alive[b as usize]) {
        let at = view.world.bodies[b as usize].position;
        let edges = &scratch.turned[scratch.shapes.range(b as usize)];
        outlines
            .push((scratch.shapes.mass[b as usize], edges.iter().map(|t| at + t.start).collect()));
    }
    let total: f64 = outlines.iter().map(|(mass, _)| mass).sum();
    let (mut sum, mut counted) = (0.0, 0.0);
    for heap in heaps(outlines) {
        let mass: f64 = heap.iter().map(|(mass, _)| mass).sum();
        if mass >= HEAP * total {
            sum += mass * flank_angle(&heap);
            counted += mass;
        }
    }
    if counted > 0.0 { sum / counted } else { 0.0 }
}

/// A polygon: its weight (mass) and its corners.
type Outline = (f64, Vec<Vec2>);

/// Sorts polygons into heaps with a gap in x between them that is wider than the widest polygon.
fn heaps(outlines: Vec<Outline>) -> Vec<Vec<Outline>> {
    let mut spans: Vec<([f64; 2], Outline)> = outlines
        .into_iter()
        .map(|outline| {
            let xs = outline.1.iter().map(|p| p.x);
            let low = xs.clone().fold(f64::INFINITY, f64::min);
            let high = xs.fold(f64::NEG_INFINITY, f64::max);
            ([low, high], outline)
        })
        .collect();
    spans.sort_by(|a, b| a.0[0].total_cmp(&b.0[0]));
    let gap = spans.iter().map(|([l, h], _)| h - l).fold(0.0, f64::max);
    let mut found: Vec<Vec<Outline>> = Vec::new();
    let mut reach = f64::NEG_INFINITY;
    for ([low, high], outline) in spans {
        match found.last_mut() {
            Some(heap) if low <= reach + gap => heap.push(outline),
            _ => found.push(vec![outline]),
        }
        reach = reach.max(high);
    }
    found
}

/// Mean slope of the flanks of polygons, each with its weight (mass) and corners.
///
/// The heap reaches from the 1st to the 99th percentile of the mass in x, so that grains that rolled
/// away do not count. Its outline is the highest point in each of 60 columns, above the lowest point
/// of all. A straight line is fitted to each flank where the outline lies between 20 % and 80 % of its
/// height (toe and crest are rounded); the angle belongs to the mean of both slopes.
fn flank_angle(outlines: &[Outline]) -> f64 {
    let mut places: Vec<(f64, f64)> = outlines
        .iter()
        .map(|(mass, v)| (v.iter().map(|p| p.x).sum::<f64>() / v.len() as f64, *mass))
        .collect();
    places.sort_by(|a, b| a.0.total_cmp(&b.0));
    let total: f64 = places.iter().map(|(_, m)| m).sum();
    let quantile = |share: f64| {
        let mut sum = 0.0;
        let found = places.iter().find(|(_, m)| {
            sum += m;
            sum >= share * total
        });
        found.map_or(0.0, |(x, _)| *x)
    };
    let (left, right) = (quantile(0.01), quantile(0.99));
    if right <= left {
        return 0.0;
    }
    let floor = outlines.iter().flat_map(|(_, v)| v).map(|p| p.y).fold(f64::INFINITY, f64::min);
    let width = (right - left) / BINS as f64;
    let mut tops = vec![0.0_f64; BINS];
    for (_, v) in outlines {
        for (a, b) in v.iter().zip(v.iter().cycle().skip(1)) {
            raise(&mut tops, left, width, floor, *a, *b);
        }
    }
    // The crest is where the mean of three columns is highest: one grain on edge is no crest.
    let mean = |k: usize| (tops[k - 1] + tops[k] + tops[k + 1]) / 3.0;
    let crest = (1..BINS - 1).max_by(|&a, &b| mean(a).total_cmp(&mean(b))).unwrap_or(BINS / 2);
    let height = mean(crest);
    let slope = |bins: &mut dyn Iterator<Item = usize>| {
        let flank: Vec<(f64, f64)> = bins
            .map(|k| (left + (k as f64 + 0.5) * width, tops[k]))
            .filter(|(_, y)| (0.2 * height..=0.8 * height).contains(y))
            .collect();
        fitted_slope(&flank)
    };
    let slopes = [slope(&mut (0..crest)), slope(&mut (crest..BINS))];
    let found: Vec<f64> = slopes.into_iter().flatten().map(f64::abs).collect();
    if found.is_empty() {
        return 0.0;
    }
    libm::atan(found.iter().sum::<f64>() / found.len() as f64)
}

/// Raises the columns that an edge crosses to the edge's height at their middles.
fn raise(tops: &mut [f64], left: f64, width: f64, floor: f64, a: Vec2, b: Vec2) {
    let (low, high) = (a.x.min(b.x), a.x.max(b.x));
    let first = ((low - left) / width - 0.5).ceil().max(0.0) as usize;
    for (k, top) in tops.iter_mut().enumerate().skip(first) {
        let x = left + (k as f64 + 0.5) * width;
        if x > high {
            break;
        }
        let y = if b.x == a.x { a.y.max(b.y) } else { a.y + (b.y - a.y) * (x - a.x) / (b.x - a.x) };
        *top = top.max(y - floor);
    }
}

/// Slope of the least-squares line; `None` for fewer than three points.
fn fitted_slope(points: &[(f64, f64)]) -> Option<f64> {
    if points.len() < 3 {
        return None;
    }
    let n = points.len() as f64;
    let (mx, my) =
        (points.iter().map(|p| p.0).sum::<f64>() / n, points.iter().map(|p| p.1).sum::<f64>() / n);
    let sxy: f64 = points.iter().map(|p| (p.0 - mx) * (p.1 - my)).sum();
    let sxx: f64 = points.iter().map(|p| (p.0 - mx) * (p.0 - mx)).sum();
    (sxx > 0.0).then(|| sxy / sxx)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A triangular heap of small squares, lying skew on purpose: one flank 30 deg, the other 20.
    #[test]
    fn a_triangular_heap_has_its_angle() {
        let (steep, flat) = (30f64.to_radians().tan(), 20f64.to_radians().tan());
        let side = 0.05;
        let mut outlines = Vec::new();
        for i in -400..600 {
            for j in 0..100 {
                let (x, y) = (f64::from(i) * side, f64::from(j) * side);
                let under = if x < 0.0 { 4.0 + x * steep } else { 4.0 - x * flat };
                if y + 0.5 * side < under {
                    let corner = |dx: f64, dy: f64| Vec2::new(x + dx * side, y + dy * side);
                    let corners = vec![
                        corner(-0.5, 0.0),
                        corner(0.5, 0.0),
                        corner(0.5, 1.0),
                        corner(-0.5, 1.0),
                    ];
                    outlines.push((1.0, corners));
                }
            }
        }
        // A grain far away must not count.
        outlines
            .push((1.0, vec![Vec2::new(90.0, 0.0), Vec2::new(90.1, 0.0), Vec2::new(90.0, 0.1)]));
        let expected = (0.5 * (steep + flat)).atan();
        let found = flank_angle(&outlines);
        assert!((found - expected).abs() < 0.3f64.to_radians(), "{found} {expected}");
    }

    /// Two heaps and a lost grain between them.
    #[test]
    fn heaps_that_stand_apart_are_told_apart() {
        let square = |x: f64| {
            let corner = |dx: f64, dy: f64| Vec2::new(x + dx, dy);
            let corners = vec![corner(0.0, 0.0), corner(1.0, 0.0), corner(1.0, 1.0)];
            (1.0, corners)
        };
        let at = [0.0, 1.5, 20.0, 3.0, 10.0, 21.9];
        let found = heaps(at.into_iter().map(square).collect());
        let sizes: Vec<usize> = found.iter().map(Vec::len).collect();
        assert_eq!(sizes, [3, 1, 2]);
        assert!(heaps(Vec::new()).is_empty());
    }

    #[test]
    fn nothing_is_flat() {
        assert_eq!(flank_angle(&[]), 0.0);
    }
}
