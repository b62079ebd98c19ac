//! Distance potential between two convex blocks: the fast kernel.
//!
//! On an edge of block i, the depth below the boundary of a convex block j is the smallest of the
//! depths below its edge lines, a concave piecewise linear function of the position on the edge.
//! Where it is positive the point is inside j and feels the pressure `kn/2 * depth`. So the force
//! is the exact integral of the positive part of a lower envelope of lines: no overlap polygon, no
//! contact types, and nothing depends on which block is asked first.

use riprap_geom::Vec2;

use super::shapes::Edge;

/// An edge turned to the block's present angle.
#[derive(Clone, Copy, Debug, Default)]
pub struct Turned {
    /// Start corner relative to the centroid, m.
    pub start: Vec2,
    /// Outward unit normal.
    pub normal: Vec2,
}

/// What the geometry of a contact region gives to the law.
#[derive(Clone, Copy, Debug, Default)]
pub struct Overlap {
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

/// One side of a pair: the block's edges, turned edges and which of them matter.
#[derive(Clone, Copy)]
pub struct Side<'a> {
    /// Body constants.
    pub edges: &'a [Edge],
    /// Present directions.
    pub turned: &'a [Turned],
    /// Edges that can reach the other block.
    pub active: &'a [u16],
    /// Edges that can be the nearest boundary for the other block.
    pub nearest: &'a [u16],
}

/// Most nearest edges the kernel keeps on the stack; longer lists take the slow road.
pub const MAX_NEAREST: usize = 16;

/// Overlap of blocks i and j; `shift` is the centroid of i minus the centroid of j, m.
#[must_use]
pub fn overlap(i: Side<'_>, j: Side<'_>, shift: Vec2) -> Overlap {
    let mut sum = Overlap::default();
    let on_i = pieces(i, j, shift);
    if on_i.weight == 0.0 {
        return sum;
    }
    let on_j = pieces(j, i, -shift);
    // j's pieces push i the other way, at the same points, seen from i's centroid.
    sum.force = on_i.force - on_j.force;
    sum.moment = on_i.moment - on_j.moment + shift.perp_dot(on_j.force);
    sum.weight = on_i.weight + on_j.weight;
    sum.weighted = on_i.weighted + on_j.weighted - on_j.weight * shift;
    sum.chord = on_i.chord - on_j.chord;
    sum.depth = on_i.depth.max(on_j.depth);
    sum
}

/// Pressure on the edges of `own` inside `other`, about the centroid of `own`.
fn pieces(own: Side<'_>, other: Side<'_>, shift: Vec2) -> Overlap {
    let mut sum = Overlap::default();
    let count = other.nearest.len().min(MAX_NEAREST);
    // Depth of a point x (relative to own centroid) below line m: line[m].0 - normal . x.
    let mut lines = [(0.0, Vec2::ZERO); MAX_NEAREST];
    for (line, &m) in lines.iter_mut().zip(other.nearest) {
        let normal = other.turned[m as usize].normal;
        *line = (other.edges[m as usize].offset - normal.dot(shift), normal);
    }
    for &k in own.active {
        let k = k as usize;
        let next = if k + 1 == own.turned.len() { 0 } else { k + 1 };
        let (p, q) = (own.turned[k].start, own.turned[next].start);
        let Some(profile) = envelope(&lines[..count], p, q) else {
            continue;
        };
        if profile.integral <= 0.0 {
            continue;
        }
        let (edge, normal) = (&own.edges[k], own.turned[k].normal);
        let weight = edge.length * profile.integral;
        let xi = profile.first_moment / profile.integral;
        sum.force -= weight * normal;
        // start x normal is a body constant; along the edge, direction x normal is -1.
        sum.moment -= weight * (edge.along - xi * edge.length);
        sum.weight += weight;
        sum.weighted += weight * (p + xi * (q - p));
        sum.chord += (profile.end - profile.start) * (q - p);
        sum.depth = sum.depth.max(profile.peak);
    }
    sum
}

/// Integral of the positive part of the lower envelope along a segment, parameter 0..1.
struct Profile {
    start: f64,
    end: f64,
    integral: f64,
    first_moment: f64,
    peak: f64,
}

/// Lower envelope of the depths below `lines` on the segment `p q`, where positive.
fn envelope(lines: &[(f64, Vec2)], p: Vec2, q: Vec2) -> Option<Profile> {
    let mut depth = [(0.0, 0.0); MAX_NEAREST];
    let (mut start, mut end) = (0.0_f64, 1.0_f64);
    for (d, (offset, normal)) in depth.iter_mut().zip(lines) {
        let (a, b) = (offset - normal.dot(p), offset - normal.dot(q));
        if a <= 0.0 && b <= 0.0 {
            return None;
        }
        if a < 0.0 {
            start = start.max(a / (a - b));
        }
        if b < 0.0 {
            end = end.min(a / (a - b));
        }
        *d = (a, b - a);
    }
    if start >= end || lines.is_empty() {
        return None;
    }
    let depth = &depth[..lines.len()];
    // The lowest line at the start; of equal ones the one that falls fastest.
    let mut at = start;
    let mut now = 0;
    let mut height = f64::INFINITY;
    for (m, &(a, slope)) in depth.iter().enumerate() {
        let h = a + slope * at;
        if h < height || (h == height && slope < depth[now].1) {
            (now, height) = (m, h);
        }
    }
    height = height.max(0.0);
    let (mut integral, mut first_moment, mut peak) = (0.0, 0.0, height);
    // Each change goes to a line with a smaller slope, so there are at most `lines` changes.
    for _ in 0..lines.len() {
        let (a, slope) = depth[now];
        let (mut until, mut next) = (end, now);
        for (m, &(am, sm)) in depth.iter().enumerate() {
            if sm < slope {
                let cross = (am - a) / (slope - sm);
                if cross < until || (cross == until && next != now && sm < depth[next].1) {
                    (until, next) = (cross.max(at), m);
                }
            }
        }
        let there = (a + slope * until).max(0.0);
        let width = until - at;
        integral += 0.5 * width * (height + there);
        first_moment +=
            width * (at * 0.5 * (height + there) + width * (height + 2.0 * there) / 6.0);
        peak = peak.max(there);
        (at, height) = (until, there);
        if next == now || at >= end {
            break;
        }
        now = next;
    }
    Some(Profile {
        start,
        end,
        integral,
        first_moment,
        peak,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::laws::potential::{corner_force, flat_force};
    use crate::planar::setup::{BlockSpec, Setup};
    use crate::planar::shapes::Shapes;

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
        let turned: Vec<Turned> = s
            .edges
            .iter()
            .map(|e| Turned {
                start: e.start,
                normal: e.normal,
            })
            .collect();
        let all: Vec<u16> = (0..8).collect();
        let side = |b: usize| Side {
            edges: s.of(b),
            turned: &turned[s.range(b)],
            active: &all[..s.of(b).len()],
            nearest: &all[..s.of(b).len()],
        };
        overlap(side(0), side(1), s.centroid[0] - s.centroid[1])
    }

    fn rectangle(x0: f64, y0: f64, x1: f64, y1: f64) -> Vec<Vec2> {
        [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]
            .map(|(x, y)| Vec2::new(x, y))
            .to_vec()
    }

    #[test]
    fn flat_contact_has_the_closed_form() {
        let d = 1e-3;
        let o = run(
            rectangle(0.0, -d, 1.0, 1.0),
            rectangle(-5.0, -3.0, 6.0, 0.0),
        );
        assert!(
            (0.5 * o.force.y - flat_force(1.0, 1.0, d)).abs() < 1e-15,
            "{o:?}"
        );
        assert!(o.force.x.abs() < 1e-15 && o.moment.abs() < 1e-15);
        assert!((o.chord.length() - 2.0).abs() < 1e-2 && (o.depth - d).abs() < 1e-15);
    }

    #[test]
    fn corner_has_the_closed_form() {
        let (d, h) = (1e-3, 0.5);
        let corner = vec![
            Vec2::new(0.0, -d),
            Vec2::new(h, h - d),
            Vec2::new(-h, h - d),
        ];
        let o = run(corner, rectangle(-5.0, -3.0, 5.0, 0.0));
        let exact = corner_force(1.0, std::f64::consts::FRAC_PI_4, d);
        assert!(
            (0.5 * o.force.y / exact - 1.0).abs() < 1e-12,
            "{} {exact}",
            0.5 * o.force.y
        );
    }

    #[test]
    fn swapping_the_blocks_turns_the_force() {
        let a = vec![
            Vec2::new(0.1, -0.02),
            Vec2::new(0.9, 0.3),
            Vec2::new(0.2, 0.7),
        ];
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
