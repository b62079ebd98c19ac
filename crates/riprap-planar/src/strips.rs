//! Depth integrals over the overlap of any simple blocks, from the strips between the pieces of one
//! boundary and the boundary of the other.
//!
//! `int phi dA` over the overlap, `phi` the depth below the boundary of a block, is the flux of a field
//! whose divergence is `phi`: `phi²/2` away from a side, `r²/3` away from a reflex corner. On the block's own
//! boundary the flux is zero, on the pieces of the other one that lie inside it is a closed form of the depth
//! there. Where the nearest feature changes along them the foot jumps along the block's boundary; the
//! part of the block between both feet and the place of the jump is added for each jump back and taken off for
//! each jump ahead.
//!
//! So nothing is joined to outlines, and each term is of the order of a depth: pieces that round-off finds or
//! loses where boundaries coincide change the sum by round-off, however many corners they share.

use riprap_geom::Vec2;

use super::convex::Side;
use super::depths::{self, Kinks, Span};
use super::pieces::{Piece, TOUCH};

/// Integral over the overlap of the depth below the boundary of the first block of a pair or the `second`,
/// m³; `shift` is the first centroid minus the second.
#[must_use]
pub(crate) fn depth_integral(
    pair: [Side<'_>; 2],
    second: bool,
    shift: Vec2,
    pieces: &[Piece],
) -> f64 {
    let block = pair[usize::from(second)];
    let (sum, jumps) = flux(pair, second, shift, pieces);
    let own = pieces.iter().filter(|p| p.second == second);
    if jumps.is_empty() && own.clone().all(|p| p.depth <= touch(block, p)) {
        return sum;
    }
    let outline = Outline::new(block, own);
    let ahead: f64 = jumps
        .iter()
        .map(|jump| {
            let [from, to] = jump.edges.map(|e| outline.foot(e, jump.place));
            if to.along < from.along {
                outline.between(to, from, jump.place)
            } else {
                -outline.between(from, to, jump.place)
            }
        })
        .sum();
    let whole = if outline.swallowed { outline.whole() } else { 0.0 };
    sum + ahead + whole
}

/// Depth of a piece that is round-off, m.
fn touch(block: Side<'_>, piece: &Piece) -> f64 {
    TOUCH * block.turned[piece.edge as usize].length
}

/// A place where the nearest feature changes.
struct Jump {
    /// Edge that is nearest before and after.
    edges: [u16; 2],
    /// The place, relative to the centroid of the block.
    place: Vec2,
}

/// Flux through the pieces of the other boundary, and the places on them where the nearest feature changes.
fn flux(pair: [Side<'_>; 2], second: bool, shift: Vec2, pieces: &[Piece]) -> (f64, Vec<Jump>) {
    let (block, other) = (pair[usize::from(second)], pair[usize::from(!second)]);
    let shift = if second { shift } else { Vec2::ZERO };
    let (mut sum, mut jumps, mut kinks) = (0.0, Vec::new(), Kinks::default());
    let inside: Vec<&Piece> = pieces.iter().filter(|p| p.second != second).collect();
    // The edges at the start and at the end of each piece.
    let mut ends: Vec<[u16; 2]> = Vec::with_capacity(inside.len());
    for piece in &inside {
        let [p, q] = piece.ends.map(|x| x + shift);
        let mut seen: Option<[u16; 2]> = None;
        depths::spans(block, p, q, &mut kinks, |span| {
            sum += span_flux(block, &span, p, q);
            let first = seen.map_or(span.edge, |[first, last]| {
                if last != span.edge {
                    let place = p + span.s[0] * (q - p);
                    jumps.push(Jump { edges: [last, span.edge], place });
                }
                first
            });
            seen = Some([first, span.edge]);
        });
        ends.push(seen.unwrap_or([piece.facing; 2]));
    }
    // From piece to piece around a corner; the pieces of a block come in the order of its edges.
    for (k, piece) in inside.iter().enumerate() {
        let next = (k + 1) % inside.len();
        let after = inside[next];
        let goes_on = piece.cut[1].is_none()
            && after.cut[0].is_none()
            && (piece.edge as usize + 1) % other.turned.len() == after.edge as usize;
        let edges = [ends[k][1], ends[next][0]];
        if goes_on && edges[0] != edges[1] {
            jumps.push(Jump { edges, place: after.ends[0] + shift });
        }
    }
    (sum, jumps)
}

/// Flux through one span of the piece `p q`, whose own block is to the left.
fn span_flux(block: Side<'_>, span: &Span, p: Vec2, q: Vec2) -> f64 {
    // Outward normal of the piece times its length.
    let outward = -(q - p).perp();
    let edge = &block.turned[span.edge as usize];
    if span.at_corner() {
        let middle = p + 0.5 * (span.s[0] + span.s[1]) * (q - p);
        let next = (span.edge as usize + 1) % block.turned.len();
        let before = edge.normal.perp().dot(middle - edge.start) <= 0.0;
        let corner = if before { edge.start } else { block.turned[next].start };
        return (p - corner).dot(outward) * span.integral() / 3.0;
    }
    let [a, b] = span.depths();
    let width = span.s[1] - span.s[0];
    -edge.normal.dot(outward) * width * (a * a + a * b + b * b) / 6.0
}

/// A place on the boundary of a block.
#[derive(Clone, Copy, Debug)]
struct Foot {
    edge: usize,
    /// Distance from the start of the edge, m.
    on_edge: f64,
    /// Distance along the boundary from the origin of the outline, m.
    along: f64,
}

/// The boundary of a block, measured along from an origin where the other block is not.
struct Outline<'a> {
    block: Side<'a>,
    /// Distance of the start of each edge from that of edge 0, m.
    starts: Vec<f64>,
    total: f64,
    /// The origin, from the start of edge 0.
    origin: f64,
    /// Whether there is no such origin: the whole boundary is inside the other block.
    swallowed: bool,
}

impl<'a> Outline<'a> {
    /// `own` are the pieces of the block's boundary inside the other block.
    fn new<'p>(block: Side<'a>, own: impl Iterator<Item = &'p Piece> + Clone) -> Self {
        let mut total = 0.0;
        let starts = block
            .turned
            .iter()
            .map(|edge| {
                let start = total;
                total += edge.length;
                start
            })
            .collect();
        let mut outline = Self { block, starts, total, origin: 0.0, swallowed: false };
        let (gap, place) = outline.widest_gap(own.clone());
        outline.origin = place;
        if gap <= TOUCH * total {
            // None but by round-off.
            let deepest = own.max_by(|a, b| a.depth.total_cmp(&b.depth));
            if let Some(piece) = deepest.filter(|p| p.depth > touch(block, p)) {
                let edge = piece.edge as usize;
                let middle = 0.5 * (piece.t[0] + piece.t[1]);
                outline.origin = outline.starts[edge] + middle * block.turned[edge].length;
                outline.swallowed = true;
            }
        }
        outline
    }

    /// The longest part of an edge outside the other block: its length and the place of its middle.
    fn widest_gap<'p>(&self, own: impl Iterator<Item = &'p Piece> + Clone) -> (f64, f64) {
        let mut widest = (0.0, 0.0);
        let mut consider = |edge: usize, from: f64, to: f64| {
            let length = self.block.turned[edge].length;
            if (to - from) * length > widest.0 {
                let middle = self.starts[edge] + 0.5 * (from + to) * length;
                widest = ((to - from) * length, middle);
            }
        };
        let mut pieces = own.peekable();
        for edge in 0..self.starts.len() {
            let mut from = 0.0;
            while let Some(piece) = pieces.next_if(|p| p.edge as usize == edge) {
                consider(edge, from, piece.t[0]);
                from = piece.t[1];
            }
            consider(edge, from, 1.0);
        }
        widest
    }

    /// The place of `edge` that is nearest to `x`.
    fn foot(&self, edge: u16, x: Vec2) -> Foot {
        let edge = edge as usize;
        let side = &self.block.turned[edge];
        let on_edge = side.normal.perp().dot(x - side.start).clamp(0.0, side.length);
        let from_zero = self.starts[edge] + on_edge - self.origin;
        let along = if from_zero < 0.0 { from_zero + self.total } else { from_zero };
        Foot { edge, on_edge, along }
    }

    /// Depth integral over the part of the block between its boundary from foot `a` ahead to foot `b`
    /// and the place `x`, which is equally far from both.
    fn between(&self, a: Foot, b: Foot, x: Vec2) -> f64 {
        let n = self.starts.len();
        if a.edge == b.edge || b.along - a.along <= 4.0 * f64::EPSILON * self.total {
            return 0.0;
        }
        let (first, last) = (&self.block.turned[a.edge], &self.block.turned[b.edge]);
        let place = |f: Foot| {
            let side = &self.block.turned[f.edge];
            side.start + f.on_edge * side.normal.perp()
        };
        let left = first.length - a.on_edge;
        if last.reflex && (a.edge + 1) % n == b.edge {
            // Both feet are the corner between, but for round-off.
            return 0.0;
        }
        let corners = a.on_edge == 0.0 || b.on_edge >= last.length;
        if (a.edge + 1) % n == b.edge && !corners {
            // Two triangles that meet on the bisector of the corner.
            let depth = [a, b].map(|f| (place(f) - x).length_squared());
            return (depth[0] * left + depth[1] * b.on_edge) / 6.0;
        }
        self.chain(a, b, x)
    }

    /// As [`Self::between`], for feet with whole edges or reflex corners between them: rib by rib.
    fn chain(&self, a: Foot, b: Foot, x: Vec2) -> f64 {
        let n = self.starts.len();
        let count = (b.edge + n - a.edge) % n + 1;
        let ribs = Ribs { block: self.block, first: a.edge, count };
        let (first, last) = (&self.block.turned[a.edge], &self.block.turned[b.edge]);
        let mut sum = ribs.side(a.edge, a.on_edge, first.length);
        // Where a foot is a reflex corner its fan begins or ends with the way from `x`.
        if a.on_edge == 0.0 {
            sum += ribs.fan(first.start, first.start - x, first.normal);
        }
        if b.on_edge >= last.length {
            let end = last.start + last.length * last.normal.perp();
            sum += ribs.fan(end, last.normal, end - x);
        }
        for k in 1..count {
            let edge = (a.edge + k) % n;
            let side = &self.block.turned[edge];
            let (is_last, way) = (k + 1 == count, side.start - x);
            let from = if k == 1 && a.on_edge >= first.length {
                way
            } else {
                self.block.turned[(edge + n - 1) % n].normal
            };
            let to = if is_last && b.on_edge <= 0.0 { way } else { side.normal };
            sum += ribs.fan(side.start, from, to);
            sum += ribs.side(edge, 0.0, if is_last { b.on_edge } else { side.length });
        }
        sum
    }

    /// Depth integral over the whole block.
    fn whole(&self) -> f64 {
        let n = self.starts.len();
        let ribs = Ribs { block: self.block, first: 0, count: n };
        (0..n)
            .map(|edge| {
                let side = &self.block.turned[edge];
                let before = self.block.turned[(edge + n - 1) % n].normal;
                ribs.fan(side.start, before, side.normal) + ribs.side(edge, 0.0, side.length)
            })
            .sum()
    }
}

/// The ways from the boundary inward, up to where another of the listed edges is nearer.
struct Ribs<'a> {
    block: Side<'a>,
    /// First edge of the list.
    first: usize,
    /// Number of edges, one after the other.
    count: usize,
}

impl Ribs<'_> {
    /// Depth integral over the ribs of a side between two places, m from its start.
    fn side(&self, edge: usize, from: f64, to: f64) -> f64 {
        let side = self.block.turned[edge];
        let along = side.normal.perp();
        integrate(from, to, |u| {
            let h = self.length(side.start + u * along, -side.normal);
            0.5 * h * h
        })
    }

    /// Depth integral over the ribs of the reflex corner at `corner` between two outward directions; 0
    /// where they turn the other way (a convex corner has no ribs).
    fn fan(&self, corner: Vec2, from: Vec2, to: Vec2) -> f64 {
        let (from, to) = (from.normalize_or_zero(), to.normalize_or_zero());
        let angle = libm::atan2(-from.perp_dot(to), from.dot(to));
        // No wider than round-off of the directions.
        if angle <= 4.0 * f64::EPSILON {
            return 0.0;
        }
        integrate(0.0, angle, |turn| {
            let (s, c) = libm::sincos(-turn);
            let way = -Vec2::new(c * from.x - s * from.y, s * from.x + c * from.y);
            let h = self.length(corner, way);
            h * h * h / 3.0
        })
    }

    /// Length of the rib from the place `y` of the boundary along the unit vector `way`.
    fn length(&self, y: Vec2, way: Vec2) -> f64 {
        let n = self.block.turned.len();
        let mut least = f64::INFINITY;
        // The end of the last edge is the start of the next one.
        for k in 0..=self.count {
            let edge = &self.block.turned[(self.first + k) % n];
            let w = edge.start - y;
            // As near to the corner as to `y`.
            let toward = way.dot(w);
            if toward > 0.0 {
                least = least.min(0.5 * w.length_squared() / toward);
            }
            if k == self.count {
                break;
            }
            // As near to the line, if the foot is on the edge and `y` is not on the line.
            let below = edge.normal.dot(w);
            let h = below / (1.0 + edge.normal.dot(way));
            let round_off = 64.0 * f64::EPSILON * (edge.start.length() + y.length());
            if below > round_off && h < least {
                let foot = edge.normal.perp().dot(h * way - w);
                if foot >= 0.0 && foot <= edge.length {
                    least = h;
                }
            }
        }
        if least.is_finite() { least } else { 0.0 }
    }
}

/// Halvings after which the sum is taken as it is.
const MOST_HALVINGS: u32 = 400;

/// Integral of a function that is smooth but for kinks, to a relative 1e-12.
fn integrate(from: f64, to: f64, mut f: impl FnMut(f64) -> f64) -> f64 {
    let size = rule(&mut f, from, to).abs();
    let mut budget = MOST_HALVINGS;
    halving(&mut f, from, to, 1e-12 * size, 0, &mut budget)
}

/// Three-point Gauss rule.
fn rule(f: &mut impl FnMut(f64) -> f64, a: f64, b: f64) -> f64 {
    let (middle, half) = (0.5 * (a + b), 0.5 * (b - a));
    let reach = half * 0.774_596_669_241_483_4;
    half * (5.0 * (f(middle - reach) + f(middle + reach)) + 8.0 * f(middle)) / 9.0
}

/// Integral of `f` from `a` to `b`, halving until two levels agree or the budget is spent.
fn halving(
    f: &mut impl FnMut(f64) -> f64,
    a: f64,
    b: f64,
    tolerance: f64,
    level: u32,
    budget: &mut u32,
) -> f64 {
    let middle = 0.5 * (a + b);
    let (whole, parts) = (rule(f, a, b), rule(f, a, middle) + rule(f, middle, b));
    // The first level always looks at both halves: a kink may hide from one look.
    let agreed = level > 0 && (whole - parts).abs() <= tolerance;
    if level >= 24 || agreed || *budget == 0 {
        return parts;
    }
    *budget -= 1;
    halving(f, a, middle, 0.5 * tolerance, level + 1, budget)
        + halving(f, middle, b, 0.5 * tolerance, level + 1, budget)
}
