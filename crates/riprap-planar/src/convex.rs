//! Distance potential between two convex blocks: the fast kernel.
//!
//! On an edge of block i, the depth below the boundary of a convex block j is the smallest of the
//! depths below its edge lines, a concave piecewise linear function of the position on the edge.
//! Where it is positive the point is inside j and feels the pressure `kn/2 * depth`. So the force
//! is the exact integral of the positive part of a lower envelope of lines: no overlap polygon, no
//! contact types, and nothing depends on which block is asked first.

use riprap_geom::Vec2;

use super::shapes::Edge;

/// An edge turned to the block's present angle: all that pairs read of it, in one cache line.
#[derive(Clone, Copy, Debug, Default)]
#[repr(align(64))]
pub struct Turned {
    /// Start corner relative to the centroid, m.
    pub start: Vec2,
    /// Outward unit normal.
    pub normal: Vec2,
    /// Distance of the edge line from the centroid along the normal, m.
    pub offset: f64,
    /// Length, m.
    pub length: f64,
    /// `start x normal`, m.
    pub along: f64,
    /// Whether the start corner is reflex.
    pub reflex: bool,
}

impl Turned {
    /// The edge turned by an angle with this cosine and sine.
    #[must_use]
    pub fn new(edge: &Edge, cos: f64, sin: f64) -> Self {
        let mut turned = Self {
            offset: edge.normal.dot(edge.start),
            length: edge.length,
            along: edge.start.perp_dot(edge.normal),
            reflex: edge.reflex,
            ..Self::default()
        };
        turned.turn(edge, cos, sin);
        turned
    }

    /// Sets start and normal to the edge's, turned; the rest does not depend on the angle.
    pub fn turn(&mut self, edge: &Edge, cos: f64, sin: f64) {
        let turn = |v: Vec2| Vec2::new(cos * v.x - sin * v.y, sin * v.x + cos * v.y);
        self.start = turn(edge.start);
        self.normal = turn(edge.normal);
    }
}

/// What the geometry of a contact region gives to the law.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Overlap {
    /// Pressure resultant on the first block over `kn / 2`, m².
    pub force: Vec2,
    /// Moment of the same about the first block's centroid, m³.
    pub moment: f64,
    /// Sum of the pressure magnitudes, m².
    pub weight: f64,
    /// Sum of pressure magnitude times position relative to the first centroid, m³.
    pub weighted: Vec2,
    /// Twice the chord of the region, from the pieces of both boundaries, m.
    pub chord: Vec2,
    /// Largest depth, m.
    pub depth: f64,
}

/// One side of a pair: the block's edges and which of them matter.
#[derive(Clone, Copy)]
pub(crate) struct Side<'a> {
    /// Edges at the present angle.
    pub turned: &'a [Turned],
    /// Edges that can reach the other block.
    pub active: &'a [u16],
    /// Edges that can be the nearest boundary for the other block.
    pub nearest: &'a [u16],
}

/// Most nearest edges the kernel takes; longer lists take the general road.
pub(crate) const MAX_NEAREST: usize = 8;

/// Overlap of blocks i and j; `shift` is the centroid of i minus the centroid of j, m.
#[must_use]
pub(crate) fn overlap(i: Side<'_>, j: Side<'_>, shift: Vec2) -> Overlap {
    let on_i = pieces(i, j, shift);
    let on_j = pieces(j, i, -shift);
    // j's pieces push i the other way, at the same points, seen from i's centroid.
    Overlap {
        force: on_i.force - on_j.force,
        moment: on_i.moment - on_j.moment + shift.perp_dot(on_j.force),
        weight: on_i.weight + on_j.weight,
        weighted: on_i.weighted + on_j.weighted - on_j.weight * shift,
        chord: on_i.chord - on_j.chord,
        depth: on_i.depth.max(on_j.depth),
    }
}

/// Depth below one line at both ends of an edge.
#[derive(Clone, Copy, Default)]
struct Line {
    at_start: f64,
    at_end: f64,
}

impl Line {
    #[inline]
    fn at(self, s: f64) -> f64 {
        self.at_start + (self.at_end - self.at_start) * s
    }

    #[inline]
    fn slope(self) -> f64 {
        self.at_end - self.at_start
    }
}

/// Smaller of two numbers that are no NaN: one instruction, unlike `f64::min`.
#[inline]
fn least(a: f64, b: f64) -> f64 {
    if a < b { a } else { b }
}

/// Larger of two numbers that are no NaN.
#[inline]
fn most(a: f64, b: f64) -> f64 {
    if a > b { a } else { b }
}

/// Pressure on the edges of `own` inside `other`, about the centroid of `own`.
fn pieces(own: Side<'_>, other: Side<'_>, shift: Vec2) -> Overlap {
    let mut sum = Overlap::default();
    // Depth of a point x (relative to own centroid) below a line: offset - normal . x.
    let mut walls = [(Vec2::ZERO, 0.0); MAX_NEAREST];
    let mut lines = [Line::default(); MAX_NEAREST];
    let count = other.nearest.len().min(MAX_NEAREST);
    let (walls, lines) = (&mut walls[..count], &mut lines[..count]);
    for (wall, &m) in walls.iter_mut().zip(other.nearest) {
        let edge = &other.turned[m as usize];
        *wall = (edge.normal, edge.offset - edge.normal.dot(shift));
    }
    for &k in own.active {
        let k = k as usize;
        let next = if k + 1 == own.turned.len() { 0 } else { k + 1 };
        let edge = &own.turned[k];
        let (p, q) = (edge.start, own.turned[next].start);
        let Some((start, end)) = inside(walls, p, q, lines) else {
            continue;
        };
        let profile = envelope(lines, start, end);
        if profile.integral <= 0.0 {
            continue;
        }
        let weight = edge.length * profile.integral;
        let xi = profile.first_moment / profile.integral;
        sum.force -= weight * edge.normal;
        // start x normal is a body constant; along the edge, direction x normal is -1.
        sum.moment -= weight * (edge.along - xi * edge.length);
        sum.weight += weight;
        sum.weighted += weight * (p + xi * (q - p));
        sum.chord += (end - start) * (q - p);
        sum.depth = most(sum.depth, profile.peak);
    }
    sum
}

/// The part (as parameters) of the segment `p q` that is above no wall, and the depths at its ends.
#[inline]
fn inside(walls: &[(Vec2, f64)], p: Vec2, q: Vec2, lines: &mut [Line]) -> Option<(f64, f64)> {
    let (mut start, mut end) = (0.0_f64, 1.0_f64);
    for ((normal, offset), line) in walls.iter().zip(lines) {
        let (a, b) = (offset - normal.dot(p), offset - normal.dot(q));
        if a <= 0.0 {
            if b <= 0.0 {
                return None;
            }
            start = most(start, a / (a - b));
        } else if b < 0.0 {
            end = least(end, a / (a - b));
        }
        *line = Line { at_start: a, at_end: b };
    }
    (start < end && !walls.is_empty()).then_some((start, end))
}

/// Integrals of the depth along a segment, parameter 0..1.
#[derive(Default)]
struct DepthProfile {
    integral: f64,
    first_moment: f64,
    peak: f64,
}

impl DepthProfile {
    /// Adds a linear part from `(s0, f0)` to `(s1, f1)`.
    #[inline]
    fn add(&mut self, s0: f64, f0: f64, s1: f64, f1: f64) {
        let width = s1 - s0;
        let part = 0.5 * width * (f0 + f1);
        self.integral += part;
        self.first_moment += s0 * part + width * width * (f0 + 2.0 * f1) * (1.0 / 6.0);
        self.peak = most(self.peak, most(f0, f1));
    }
}

/// Integrals of the lower envelope of the lines from `start` to `end`.
#[inline]
fn envelope(lines: &[Line], start: f64, end: f64) -> DepthProfile {
    // The lowest line at either end; of equal ones the one that is lower inside.
    let (mut first, mut last) = (0, 0);
    let (mut low_first, mut low_last) = (lines[0].at(start), lines[0].at(end));
    for (m, line) in lines.iter().enumerate().skip(1) {
        let (s, e) = (line.at(start), line.at(end));
        if s < low_first || (s == low_first && line.slope() < lines[first].slope()) {
            (first, low_first) = (m, s);
        }
        if e < low_last || (e == low_last && line.slope() > lines[last].slope()) {
            (last, low_last) = (m, e);
        }
    }
    let mut profile = DepthProfile::default();
    let (low_first, low_last) = (most(low_first, 0.0), most(low_last, 0.0));
    let (falling, rising) = (lines[last], lines[first]);
    let fall = rising.slope() - falling.slope();
    if first == last || fall <= 0.0 {
        // One line is lowest at both ends, so everywhere between.
        profile.add(start, low_first, end, low_last);
        return profile;
    }
    let cross = most(start, least(end, (falling.at_start - rising.at_start) / fall));
    let there = rising.at(cross);
    let lower = |(m, line): (usize, &Line)| m != first && m != last && line.at(cross) < there;
    if lines.len() > 2 && lines.iter().enumerate().any(lower) {
        return walk(lines, (start, low_first), (end, low_last), rising, falling);
    }
    let there = most(there, 0.0);
    profile.add(start, low_first, cross, there);
    profile.add(cross, there, end, low_last);
    profile
}

/// The envelope by walking from change to change; each goes to a line with a smaller slope.
#[cold]
fn walk(lines: &[Line], from: (f64, f64), to: (f64, f64), first: Line, last: Line) -> DepthProfile {
    let mut profile = DepthProfile::default();
    let (mut at, mut height) = from;
    let mut now = first;
    for _ in 1..lines.len() {
        if now.slope() <= last.slope() {
            break;
        }
        let (mut until, mut next) = (to.0, last);
        for &line in lines.iter().filter(|line| line.slope() < now.slope()) {
            let cross = (line.at_start - now.at_start) / (now.slope() - line.slope());
            if cross < until || (cross == until && line.slope() < next.slope()) {
                (until, next) = (most(cross, at), line);
            }
        }
        let there = most(now.at(until), 0.0);
        profile.add(at, height, until, there);
        (at, height, now) = (until, there, next);
    }
    profile.add(at, height, to.0, to.1);
    profile
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::laws::potential::{corner_force, flat_force};
    use crate::setup::{BlockSpec, Setup};
    use crate::shapes::Shapes;

    fn shapes(polygons: &[Vec<Vec2>]) -> Shapes {
        Shapes::new(&Setup {
            blocks: polygons
                .iter()
                .map(|p| BlockSpec {
                    name: String::new(),
                    vertices: p.clone(),
                    material: 0,
                    density: 1.0,
                    velocity: Vec2::ZERO,
                    spin: 0.0,
                })
                .collect(),
            ..Setup::default()
        })
    }

    fn run(a: Vec<Vec2>, b: Vec<Vec2>) -> Overlap {
        let s = shapes(&[a, b]);
        let turned: Vec<Turned> = s.edges.iter().map(|e| Turned::new(e, 1.0, 0.0)).collect();
        let all: Vec<u16> = (0..8).collect();
        let side = |b: usize| Side {
            turned: &turned[s.range(b)],
            active: &all[..s.of(b).len()],
            nearest: &all[..s.of(b).len()],
        };
        overlap(side(0), side(1), s.centroid[0] - s.centroid[1])
    }

    fn rectangle(x0: f64, y0: f64, x1: f64, y1: f64) -> Vec<Vec2> {
        [(x0, y0), (x1, y0), (x1, y1), (x0, y1)].map(|(x, y)| Vec2::new(x, y)).to_vec()
    }

    #[test]
    fn flat_contact_has_the_closed_form() {
        let d = 1e-3;
        let o = run(rectangle(0.0, -d, 1.0, 1.0), rectangle(-5.0, -3.0, 6.0, 0.0));
        assert!((0.5 * o.force.y - flat_force(1.0, 1.0, d)).abs() < 1e-15, "{o:?}");
        assert!(o.force.x.abs() < 1e-15 && o.moment.abs() < 1e-15);
        assert!((o.chord.length() - 2.0).abs() < 1e-2 && (o.depth - d).abs() < 1e-15);
    }

    #[test]
    fn corner_has_the_closed_form() {
        let (d, h) = (1e-3, 0.5);
        let corner = vec![Vec2::new(0.0, -d), Vec2::new(h, h - d), Vec2::new(-h, h - d)];
        let o = run(corner, rectangle(-5.0, -3.0, 5.0, 0.0));
        let exact = corner_force(1.0, std::f64::consts::FRAC_PI_4, d);
        assert!((0.5 * o.force.y / exact - 1.0).abs() < 1e-12, "{} {exact}", 0.5 * o.force.y);
    }

    #[test]
    fn swapping_the_blocks_turns_the_force() {
        let a = vec![Vec2::new(0.1, -0.02), Vec2::new(0.9, 0.3), Vec2::new(0.2, 0.7)];
        let b = rectangle(-0.4, -1.0, 0.6, 0.03);
        let (ab, ba) = (run(a.clone(), b.clone()), run(b, a));
        assert!((ab.force + ba.force).length() <= 1e-15 * ab.force.length());
    }

    #[test]
    fn touching_faces_feel_nothing() {
        let o = run(rectangle(0.0, 0.0, 1.0, 1.0), rectangle(1.0, 0.0, 2.0, 1.0));
        assert_eq!(o.force, Vec2::ZERO);
    }
}
