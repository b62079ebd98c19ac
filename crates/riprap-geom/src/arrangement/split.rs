//! Segments to edges: clipping to the region, splitting where they meet.

use std::collections::BTreeMap;

use super::{Cut, PointStore};
use crate::polygon::{self, Aabb, Side};
use crate::{GeomError, Vec2};

/// More comparisons of a segment with a region edge or another segment than this are refused (about
/// ten seconds of work).
const MAX_TESTS: usize = 1_000_000_000;

/// A piece of a cut inside the region, and the points on it.
struct Piece {
    from: Vec2,
    to: Vec2,
    family: Option<u32>,
    /// Position along the piece (0 to 1) and point number.
    on: Vec<(f64, u32)>,
}

/// Position along a cut (0 to 1), and the number of the point if it is on the outline.
type Stop = (f64, Option<u32>);

/// Edges of the arrangement: pairs of point numbers, smaller first, with whether they belong to the
/// region's outline. Points are in local coordinates; the first `region.len()` are the outline's.
pub(super) fn split(
    region: &[Vec2],
    cuts: &[Cut],
    points: &mut PointStore,
) -> Result<BTreeMap<(u32, u32), bool>, GeomError> {
    check_tests("comparisons of a joint with an edge of the region", region.len() * cuts.len())?;
    let n = region.len();
    let mut outline: Vec<Vec<(f64, u32)>> =
        (0..n).map(|i| vec![(0.0, i as u32), (1.0, ((i + 1) % n) as u32)]).collect();
    let mut pieces: Vec<Piece> = Vec::new();
    for cut in cuts {
        clip_to_region(region, cut, points, &mut outline, &mut pieces);
    }
    // Ends inside the region come after all points on the outline.
    for piece in &mut pieces {
        for (t, p) in [(0.0, piece.from), (1.0, piece.to)] {
            if !piece.on.iter().any(|&(s, _)| s == t) {
                let number = points.place(p);
                piece.on.push((t, number));
            }
        }
    }
    cross_pieces(&mut pieces, points)?;
    let mut edges = BTreeMap::new();
    let chains = outline.into_iter().map(|on| (on, true));
    for (mut on, is_outline) in chains.chain(pieces.into_iter().map(|p| (p.on, false))) {
        on.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        on.dedup_by_key(|(_, number)| *number);
        for pair in on.windows(2) {
            let (a, b) = (pair[0].1, pair[1].1);
            if a != b {
                *edges.entry((a.min(b), a.max(b))).or_insert(false) |= is_outline;
            }
        }
    }
    Ok(edges)
}

fn check_tests(what: &'static str, count: usize) -> Result<(), GeomError> {
    if count > MAX_TESTS {
        return Err(GeomError::TooMany { what, count: count as f64, cap: MAX_TESTS });
    }
    Ok(())
}

/// The pieces of a cut inside the region; crossing points go on the outline's edges.
fn clip_to_region(
    region: &[Vec2],
    cut: &Cut,
    points: &mut PointStore,
    outline: &mut [Vec<(f64, u32)>],
    pieces: &mut Vec<Piece>,
) {
    let near = points.distance;
    let along = cut.to - cut.from;
    let length = along.length();
    if length <= near {
        return;
    }
    let mut stops: Vec<Stop> = vec![(0.0, None), (1.0, None)];
    for (edge, (a, b)) in polygon::edges(region).enumerate() {
        let side = b - a;
        let side_length = side.length();
        let height = |p: Vec2| side.perp_dot(p - a) / side_length;
        let (h0, h1) = (height(cut.from), height(cut.to));
        let (on0, on1) = (h0.abs() <= near, h1.abs() <= near);
        if on0 && on1 {
            // Along the edge: stop at its ends, so that what lies on it is a stretch of its own.
            for (p, number) in [(a, edge), (b, (edge + 1) % region.len())] {
                let t = (p - cut.from).dot(along) / (length * length);
                if (0.0..=1.0).contains(&t) {
                    stops.push((t, Some(number as u32)));
                }
            }
            continue;
        }
        if (h0 > near && h1 > near) || (h0 < -near && h1 < -near) {
            continue;
        }
        let t = match (on0, on1) {
            (true, _) => 0.0,
            (false, true) => 1.0,
            (false, false) => h0 / (h0 - h1),
        };
        let s = (cut.from + t * along - a).dot(side) / (side_length * side_length);
        let slack = near / side_length;
        if s >= -slack && s <= 1.0 + slack {
            let s = s.clamp(0.0, 1.0);
            let number = points.place(a + s * side);
            outline[edge].push((s, number));
            stops.push((t, Some(number)));
        }
    }
    merge_stops(&mut stops, length, near);
    pieces.extend(stops.windows(2).filter_map(|w| piece(region, cut, points, [w[0], w[1]])));
}

/// The piece of a cut between two stops, if it is inside the region.
fn piece(region: &[Vec2], cut: &Cut, points: &PointStore, stops: [Stop; 2]) -> Option<Piece> {
    let ([(t0, start), (t1, end)], along) = (stops, cut.to - cut.from);
    let middle = cut.from + 0.5 * (t0 + t1) * along;
    if polygon::locate(region, middle) != Side::Inside
        || polygon::distance_to_boundary(region, middle) <= points.distance
    {
        return None;
    }
    let place = |t: f64, number: Option<u32>| {
        number.map_or(cut.from + t * along, |i| points.points[i as usize])
    };
    let on = start.map(|i| (0.0, i)).into_iter().chain(end.map(|i| (1.0, i)));
    let (from, to) = (place(t0, start), place(t1, end));
    Some(Piece { from, to, family: cut.family, on: on.collect() })
}

/// Sorts the stops of a cut of this length along it, and joins those nearer than `near`.
fn merge_stops(stops: &mut Vec<Stop>, length: f64, near: f64) {
    // At equal places the one on the outline comes first and wins.
    stops.sort_by(|x, y| {
        x.0.total_cmp(&y.0).then(y.1.is_some().cmp(&x.1.is_some())).then(x.1.cmp(&y.1))
    });
    stops.dedup_by(|next, kept| {
        let same = (next.0 - kept.0) * length <= near || (next.1.is_some() && next.1 == kept.1);
        if same && kept.1.is_none() {
            *kept = *next;
        }
        same
    });
}

/// Put the crossing and touching points of all pairs of pieces on both.
fn cross_pieces(pieces: &mut [Piece], points: &mut PointStore) -> Result<(), GeomError> {
    let cells = bins(pieces, points.distance)?;
    let tests: usize = cells.values().map(|c| c.len() * c.len() / 2).sum();
    if cells.values().any(|c| several_families(pieces, c)) {
        check_tests("comparisons of a joint with another", tests)?;
    }
    for cell in cells.values() {
        if !several_families(pieces, cell) {
            continue;
        }
        for (k, &i) in cell.iter().enumerate() {
            for &j in &cell[k + 1..] {
                let (i, j) = (i as usize, j as usize);
                if pieces[i].family.is_none() || pieces[i].family != pieces[j].family {
                    meet(pieces, i, j, points);
                }
            }
        }
    }
    Ok(())
}

fn several_families(pieces: &[Piece], cell: &[u32]) -> bool {
    let family = |i: u32| pieces[i as usize].family;
    cell.len() > 1
        && (family(cell[0]).is_none() || cell.iter().any(|&i| family(i) != family(cell[0])))
}

/// Pieces by square of a grid about as fine as the pieces are long.
fn bins(pieces: &[Piece], near: f64) -> Result<BTreeMap<(i32, i32), Vec<u32>>, GeomError> {
    let mut cells: BTreeMap<(i32, i32), Vec<u32>> = BTreeMap::new();
    let ends: Vec<Vec2> = pieces.iter().flat_map(|p| [p.from, p.to]).collect();
    if ends.is_empty() {
        return Ok(cells);
    }
    let bounds = Aabb::of(&ends);
    let mean = pieces.iter().map(|p| p.from.distance(p.to)).sum::<f64>() / pieces.len() as f64;
    let side = mean.max(bounds.size() / 2048.0).max(8.0 * near);
    for (i, piece) in pieces.iter().enumerate() {
        let (a, b) = (piece.from - bounds.min, piece.to - bounds.min);
        let (left, right) = if a.x <= b.x { (a, b) } else { (b, a) };
        let slope = (right.y - left.y) / (right.x - left.x);
        let column = |x: f64| (x / side).floor() as i32;
        for cx in column(left.x - near)..=column(right.x + near) {
            let x0 = (f64::from(cx) * side - near).clamp(left.x, right.x);
            let x1 = (f64::from(cx + 1) * side + near).clamp(left.x, right.x);
            let y = |x: f64| {
                if x > left.x { left.y + slope * (x - left.x) } else { left.y }
            };
            let (y0, y1) = if x1 > x0 { (y(x0), y(x1)) } else { (left.y, right.y) };
            for cy in column(y0.min(y1) - near)..=column(y0.max(y1) + near) {
                cells.entry((cx, cy)).or_default().push(i as u32);
            }
        }
    }
    Ok(cells)
}

/// The common points of two pieces.
fn meet(pieces: &mut [Piece], i: usize, j: usize, points: &mut PointStore) {
    let near = points.distance;
    let (a, b) = (pieces[i].from, pieces[i].to);
    let (c, d) = (pieces[j].from, pieces[j].to);
    let apart =
        |p: f64, q: f64, r: f64, s: f64| p.max(q) + near < r.min(s) || r.max(s) + near < p.min(q);
    if apart(a.x, b.x, c.x, d.x) || apart(a.y, b.y, c.y, d.y) {
        return;
    }
    let (u, w) = (b - a, d - c);
    let height = |p: Vec2, from: Vec2, along: Vec2| along.perp_dot(p - from) / along.length();
    let place = |p: Vec2, from: Vec2, along: Vec2| (p - from).dot(along) / along.length_squared();
    let (hc, hd) = (height(c, a, u), height(d, a, u));
    let (ha, hb) = (height(a, c, w), height(b, c, w));
    let mut touched = false;
    // Ends on the other piece; the end's point is the common one.
    let ends = [
        (c, hc, 0.0, i, j, a, u),
        (d, hd, 1.0, i, j, a, u),
        (a, ha, 0.0, j, i, c, w),
        (b, hb, 1.0, j, i, c, w),
    ];
    for (end, h, at, host, guest, from, along) in ends {
        let t = place(end, from, along);
        let slack = near / along.length();
        if h.abs() <= near && t >= -slack && t <= 1.0 + slack {
            touched = true;
            let number =
                pieces[guest].on.iter().find(|&&(s, _)| s == at).map(|&(_, number)| number);
            if let Some(number) = number {
                pieces[host].on.push((t.clamp(0.0, 1.0), number));
            }
        }
    }
    if touched || hc * hd >= 0.0 || ha * hb >= 0.0 {
        return;
    }
    let s = hc / (hc - hd);
    let number = points.place(c + s * w);
    let p = points.points[number as usize];
    let t = place(p, a, u).clamp(0.0, 1.0);
    pieces[i].on.push((t, number));
    pieces[j].on.push((place(p, c, w).clamp(0.0, 1.0), number));
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cut_through_a_corner_uses_the_corner() {
        let region = crate::shapes::rectangle(Vec2::ZERO, Vec2::splat(2.0));
        let mut points = PointStore::new(1e-10);
        for &v in &region {
            points.place(v);
        }
        let cut = Cut { from: Vec2::new(-1.0, -1.0), to: Vec2::new(3.0, 3.0), family: None };
        let edges = split(&region, &[cut], &mut points).unwrap();
        assert_eq!(points.points.len(), 4);
        assert_eq!(
            edges.keys().copied().collect::<Vec<_>>(),
            [(0, 1), (0, 2), (0, 3), (1, 2), (2, 3)]
        );
        assert!(!edges[&(0, 2)]);
    }

    #[test]
    fn refuses_too_many_tests() {
        assert!(check_tests("tests", MAX_TESTS).is_ok());
        assert!(check_tests("tests", MAX_TESTS + 1).is_err());
    }
}
