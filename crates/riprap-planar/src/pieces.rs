//! Boundary pieces of one block inside another, for any simple polygons, and their regions.
//!
//! Inside or outside is decided by the nearest feature of the other boundary: inside means behind
//! the nearest edge, or nearest to a reflex corner. So only nearby edges are ever looked at. A point
//! on the wrong side by round-off has a depth of round-off and carries no force; vertex on vertex
//! and collinear edges need no special case.

use riprap_geom::Vec2;

use super::convex::Side;

/// Distances below this, over the length of an edge, are round-off of positions.
pub(crate) const TOUCH: f64 = 1e-10;

/// A part of an edge that lies inside the other block.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Piece {
    /// Whether the edge belongs to the second block.
    pub second: bool,
    /// The edge, or the first of several on one line ([`straighten`]).
    pub edge: u16,
    /// The last of them.
    pub last: u16,
    /// Start and end as parameters on the edge.
    pub t: [f64; 2],
    /// Start and end, relative to the centroid of the first block, m.
    pub ends: [Vec2; 2],
    /// Edge of the other block that cuts the piece off at its start and end; `None` at a corner.
    pub cut: [Option<u16>; 2],
    /// Depth of its middle below the other block's boundary, m.
    pub depth: f64,
    /// Edge of the other block that is nearest to its middle.
    pub facing: u16,
    /// Place on that edge that is nearest, from its start, m.
    pub foot: f64,
    /// Region number.
    pub region: u16,
}

/// Where a point is relative to a block, by the nearest feature of its boundary.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Nearest {
    /// Distance from the boundary, positive inside, m.
    pub depth: f64,
    /// The nearest edge.
    pub edge: u16,
    /// The nearest place on it, from its start, m.
    pub foot: f64,
}

/// Nearest feature of the listed edges to `x` (relative to the block's centroid).
#[must_use]
pub(crate) fn nearest(block: Side<'_>, x: Vec2) -> Nearest {
    let n = block.turned.len();
    let mut best = Nearest { depth: f64::NEG_INFINITY, edge: 0, foot: 0.0 };
    let mut least = f64::INFINITY;
    for &m in block.nearest {
        let m = m as usize;
        let (p, normal) = (block.turned[m].start, block.turned[m].normal);
        let length = block.turned[m].length;
        let along = normal.perp().dot(x - p);
        let (distance, sign) = if along < 0.0 {
            corner(block, m, x)
        } else if along > length {
            corner(block, (m + 1) % n, x)
        } else {
            let depth = normal.dot(p - x);
            (depth.abs(), if depth >= 0.0 { 1.0 } else { -1.0 })
        };
        if distance < least {
            least = distance;
            best =
                Nearest { depth: sign * distance, edge: m as u16, foot: along.clamp(0.0, length) };
        }
    }
    best
}

/// Distance of `x` from the start corner of edge `m`, and 1 where the corner faces a point inside,
/// -1 where it faces one outside: told by the mean of the normals on both sides, which also holds
/// where they are equal (a vertex within a straight side) and round-off would decide on reflex.
fn corner(block: Side<'_>, m: usize, x: Vec2) -> (f64, f64) {
    let before = &block.turned[(m + block.turned.len() - 1) % block.turned.len()];
    let here = &block.turned[m];
    let to_corner = here.start - x;
    let inside = (before.normal + here.normal).dot(to_corner) >= 0.0;
    (to_corner.length(), if inside { 1.0 } else { -1.0 })
}

/// Finds all pieces of both boundaries; `shift` is the centroid of i minus that of j. `cuts` is
/// scratch. The pieces come in a fixed order: edges of i, then edges of j, along each edge.
pub(crate) fn find(
    i: Side<'_>,
    j: Side<'_>,
    shift: Vec2,
    pieces: &mut Vec<Piece>,
    cuts: &mut Vec<(f64, Option<u16>)>,
) {
    pieces.clear();
    collect(i, j, shift, false, pieces, cuts);
    collect(j, i, -shift, true, pieces, cuts);
}

fn collect(
    own: Side<'_>,
    other: Side<'_>,
    shift: Vec2,
    second: bool,
    pieces: &mut Vec<Piece>,
    cuts: &mut Vec<(f64, Option<u16>)>,
) {
    let n = own.turned.len();
    for &k in own.active {
        let (p, q) = (own.turned[k as usize].start, own.turned[(k as usize + 1) % n].start);
        // Ends relative to the other centroid.
        let (p, q) = (p + shift, q + shift);
        cuts.clear();
        cuts.push((0.0, None));
        for &e in other.nearest {
            cuts.extend(crossing(other, e, p, q).map(|t| (t, Some(e))));
        }
        cuts.push((1.0, None));
        let last = cuts.len() - 1;
        cuts[1..last].sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        for w in cuts.windows(2) {
            let ((t0, c0), (t1, c1)) = (w[0], w[1]);
            if t1 <= t0 {
                continue;
            }
            let (x0, x1) = (p + t0 * (q - p), p + t1 * (q - p));
            // Between two cuts an edge is inside or outside as a whole, and its middle tells it most surely.
            let middle = nearest(other, 0.5 * (x0 + x1));
            if middle.depth <= 0.0 {
                continue;
            }
            // Positions relative to the first block's centroid.
            let back = if second { Vec2::ZERO } else { -shift };
            pieces.push(Piece {
                second,
                edge: k,
                last: k,
                t: [t0, t1],
                ends: [x0 + back, x1 + back],
                cut: [c0, c1],
                depth: middle.depth,
                facing: middle.edge,
                foot: middle.foot,
                region: 0,
            });
        }
    }
}

/// Where the line from `p` to `q` crosses edge `e`, as a share of its length.
#[inline]
fn crossing(block: Side<'_>, e: u16, p: Vec2, q: Vec2) -> Option<f64> {
    let (k, m) = (e as usize, block.turned.len());
    let (a, b) = (block.turned[k].start, block.turned[(k + 1) % m].start);
    let normal = block.turned[k].normal;
    let (dp, dq) = (normal.dot(p - a), normal.dot(q - a));
    if (dp > 0.0) == (dq > 0.0) {
        return None;
    }
    let t = dp / (dp - dq);
    let along = normal.perp().dot(p + t * (q - p) - a);
    // A little more than the edge: a crossing at a corner is found at least once.
    let length = (b - a).length();
    let slack = 1e-12 * length;
    (along >= -slack && along <= length + slack).then_some(t)
}

/// Numbers the regions by the order of their first piece; returns how many there are.
///
/// Pieces belong together when they meet in a crossing of the two boundaries or in a corner, when one
/// ends where the other begins, or when the middle of one faces the other across the overlap. The last
/// two hold where sides of the two blocks lie on one line: there round-off decides whether the short
/// pieces that lead from one face to the other are found, and what cuts them.
pub(crate) fn regions(pieces: &mut [Piece], i: Side<'_>, j: Side<'_>) -> usize {
    for (k, piece) in pieces.iter_mut().enumerate() {
        piece.region = k as u16;
    }
    // Union by relabelling: pieces are few.
    for a in 0..pieces.len() {
        for b in a + 1..pieces.len() {
            let (ra, rb) = (pieces[a].region, pieces[b].region);
            if ra != rb && joined(&pieces[a], &pieces[b], i, j) {
                let (low, high) = (ra.min(rb), ra.max(rb));
                for piece in pieces.iter_mut() {
                    if piece.region == high {
                        piece.region = low;
                    }
                }
            }
        }
    }
    let mut count = 0u16;
    for k in 0..pieces.len() {
        if pieces[k].region == k as u16 {
            for piece in &mut pieces[k..] {
                if piece.region == k as u16 {
                    piece.region = count;
                }
            }
            count += 1;
        }
    }
    count as usize
}

/// Joins pieces that meet at a corner without an angle, which is none to a law that looks at their ends and middle.
pub(crate) fn straighten(pieces: &mut Vec<Piece>, i: Side<'_>, j: Side<'_>) {
    let mut at = 0;
    while let Some(&piece) = pieces.get(at) {
        let own = if piece.second { j } else { i };
        let before = previous(own, piece.edge);
        let leads = |a: &Piece| {
            a.second == piece.second
                && a.last == before
                && a.cut[1].is_none()
                && a.edge != piece.edge
        };
        let starts = piece.cut[0].is_none() && straight(own, piece.edge);
        let Some(a) = starts.then(|| pieces.iter().position(leads)).flatten() else {
            at += 1;
            continue;
        };
        let joined = &mut pieces[a];
        joined.last = piece.last;
        joined.ends[1] = piece.ends[1];
        joined.cut[1] = piece.cut[1];
        if piece.depth > joined.depth {
            (joined.depth, joined.facing, joined.foot) = (piece.depth, piece.facing, piece.foot);
        }
        pieces.remove(at);
    }
}

/// The first edge of the straight side that `edge` is a part of.
pub(crate) fn first_of_side(block: Side<'_>, edge: u16) -> u16 {
    // A closed outline has corners with an angle, so this ends.
    let mut first = edge;
    while straight(block, first) {
        first = previous(block, first);
    }
    first
}

fn previous(block: Side<'_>, edge: u16) -> u16 {
    edge.checked_sub(1).unwrap_or(block.turned.len() as u16 - 1)
}

/// Whether the corner at the start of `edge` has no angle, but for round-off.
fn straight(block: Side<'_>, edge: u16) -> bool {
    let [before, after] = [previous(block, edge), edge].map(|e| block.turned[e as usize].normal);
    before.perp_dot(after).abs() <= TOUCH && before.dot(after) > 0.0
}

/// Whether two pieces, the first before the second in the list, touch each other or face each other.
fn joined(a: &Piece, b: &Piece, i: Side<'_>, j: Side<'_>) -> bool {
    let length = |p: &Piece| if p.second { j } else { i }.turned[p.edge as usize].length;
    let touch = TOUCH * length(a).max(length(b));
    let meet = |x: Vec2, y: Vec2| (x - y).length_squared() <= touch * touch;
    if meet(a.ends[1], b.ends[0]) || meet(b.ends[1], a.ends[0]) {
        return true;
    }
    if a.second == b.second {
        let n = if a.second { j } else { i }.turned.len();
        let follows = |x: &Piece, y: &Piece| {
            (x.edge as usize + 1) % n == y.edge as usize && x.cut[1].is_none() && y.cut[0].is_none()
        };
        return follows(a, b) || follows(b, a);
    }
    let crossing = a.cut.iter().flatten().any(|&e| e == b.edge)
        && b.cut.iter().flatten().any(|&e| e == a.edge);
    // Pieces of i come before those of j.
    crossing || faces(a, i, b, j) || faces(b, j, a, i)
}

/// Whether the place nearest to the middle of `a` lies on `b`, whose edge looks the other way: then the
/// overlap reaches from one to the other.
fn faces(a: &Piece, own: Side<'_>, b: &Piece, other: Side<'_>) -> bool {
    if a.facing != b.edge {
        return false;
    }
    let (edge, opposite) = (&own.turned[a.edge as usize], &other.turned[b.edge as usize]);
    let reach = b.t.map(|t| t * opposite.length);
    edge.normal.dot(opposite.normal) < 0.0 && reach[0] <= a.foot && a.foot <= reach[1]
}
