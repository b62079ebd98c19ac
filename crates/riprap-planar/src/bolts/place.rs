//! Where a line passes through polygons.

use riprap_geom::Vec2;

/// From where to where a line is inside a polygon (corners in order, m): distances (m) from `from` along the unit direction `along`, within
/// `range`, in order. A reflex polygon may have several.
#[must_use]
pub fn spans(corners: &[Vec2], from: Vec2, along: Vec2, range: [f64; 2]) -> Vec<[f64; 2]> {
    let mut crossings: Vec<f64> = Vec::new();
    let last = corners.last().copied().unwrap_or_default();
    let starts = std::iter::once(last).chain(corners.iter().copied());
    for (a, b) in starts.zip(corners.iter().copied()) {
        let [before, after] = [a, b].map(|p| along.perp_dot(p - from));
        // A corner on the line belongs to its right-hand side, so that it is crossed once.
        if (before > 0.0) != (after > 0.0) {
            let at = a + (before / (before - after)) * (b - a);
            crossings.push((at - from).dot(along));
        }
    }
    crossings.sort_by(f64::total_cmp);
    let pairs = crossings.chunks_exact(2).map(|pair| {
        let [low, high] = range;
        [pair[0].max(low), pair[1].min(high)]
    });
    pairs.filter(|[low, high]| high > low).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_passes_a_reflex_polygon_in_parts() {
        // A U: two legs of 1 m with a gap of 1 m between them.
        let corners = [
            [0.0, 0.0],
            [3.0, 0.0],
            [3.0, 2.0],
            [2.0, 2.0],
            [2.0, 1.0],
            [1.0, 1.0],
            [1.0, 2.0],
            [0.0, 2.0],
        ]
        .map(Vec2::from);
        let through = |y: f64, range| spans(&corners, Vec2::new(-1.0, y), Vec2::X, range);
        let far = [-9.0, 9.0];
        assert_eq!(through(1.5, far), [[1.0, 2.0], [3.0, 4.0]]);
        assert_eq!(through(0.5, far), [[1.0, 4.0]]);
        assert_eq!(through(1.5, [1.5, 3.5]), [[1.5, 2.0], [3.0, 3.5]]);
        assert!(through(2.5, far).is_empty());
        // Along an edge and through corners the number of crossings is even.
        for y in [0.0, 1.0, 2.0] {
            for [low, high] in through(y, far) {
                assert!(low >= 1.0 && high <= 4.0);
            }
        }
        let across = Vec2::new(1.0, 1.0).normalize();
        let [span] = spans(&corners, Vec2::new(-1.0, -1.0), across, far)[..] else {
            panic!("one part");
        };
        assert!((span[0] - 2f64.sqrt()).abs() < 1e-12 && (span[1] - 8f64.sqrt()).abs() < 1e-12);
    }
}
