//! External loads: forces and moments on blocks, per step.

use riprap_geom::Vec2;

use super::search::segment_distance;
use super::setup::LoadKind;
use super::shapes::Shapes;
use super::world::World;

/// External force and moment on a block.
#[derive(Clone, Copy, Debug, Default)]
pub struct Applied {
    /// Force, N/m.
    pub force: Vec2,
    /// Moment about the centroid, N.
    pub moment: f64,
}

/// Sums all loads at the world's present time into `applied` (one entry per block).
pub fn apply(world: &World, shapes: &Shapes, applied: &mut [Applied]) {
    applied.fill(Applied::default());
    for load in &world.setup.loads {
        let factor = load.time.at(world.time);
        // What was released by and by is gone.
        if factor == 0.0 {
            continue;
        }
        for &b in &load.blocks {
            let b = b as usize;
            if !world.alive[b] {
                continue;
            }
            let (s, c) = libm::sincos(world.bodies[b].angle);
            let turn = |v: Vec2| Vec2::new(c * v.x - s * v.y, s * v.x + c * v.y);
            let body = |p: Vec2| p - shapes.centroid[b];
            let slot = &mut applied[b];
            match &load.kind {
                LoadKind::Point { force, at, follows } => {
                    let force = factor * if *follows { turn(*force) } else { *force };
                    slot.force += force;
                    if let Some(at) = at {
                        slot.moment += turn(body(*at)).perp_dot(force);
                    }
                }
                LoadKind::Edge {
                    from,
                    to,
                    traction,
                    pressure,
                } => {
                    let (p, q) = (turn(body(*from)), turn(body(*to)));
                    let along = q - p;
                    let inward =
                        along.length() * turn(-edge_normal(shapes, b, body(*from), body(*to)));
                    let [p0, p1] = pressure.map(|x| x * factor);
                    let [t0, t1] = *traction;
                    let mean = 0.5 * (t0 + t1);
                    let push = 0.5 * (p0 + p1) * inward + factor * along.length() * mean;
                    // Moment of a linear pressure: mean part at the middle, slope about it.
                    let slope = (p1 - p0) / 12.0 * along.perp_dot(inward)
                        + factor * along.length() / 12.0 * along.perp_dot(t1 - t0);
                    slot.force += push;
                    slot.moment += (0.5 * (p + q)).perp_dot(push) + slope;
                }
                LoadKind::Moment { moment } => slot.moment += factor * moment,
                LoadKind::BodyForce { acceleration } => {
                    slot.force += factor * shapes.mass[b] * *acceleration;
                }
            }
        }
    }
}

/// Outward normal (body frame) of the edge of block `b` that lies nearest to the segment `p q`.
pub(crate) fn edge_normal(shapes: &Shapes, b: usize, p: Vec2, q: Vec2) -> Vec2 {
    let middle = 0.5 * (p + q);
    let direction = (q - p).normalize_or_zero();
    let mut best = (f64::INFINITY, Vec2::ZERO);
    for edge in shapes.of(b) {
        let end = edge.start + edge.length * edge.normal.perp();
        // Askew edges count as farther away by what they miss over the segment's length.
        let skew = direction.dot(edge.normal).abs() * (q - p).length();
        let far = segment_distance(edge.start, end, middle) + skew;
        if far < best.0 {
            best = (far, edge.normal);
        }
    }
    best.1
}
