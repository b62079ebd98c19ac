//! External loads: forces and moments on blocks, per step.

use riprap_geom::Vec2;

use super::search::segment_distance;
use super::setup::{Load, LoadKind};
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

/// Sums all loads in the kick before a step of `dt` (s) into `applied` (one entry per block), but those that are found later in the evaluation.
pub(crate) fn apply(world: &World, shapes: &Shapes, dt: f64, applied: &mut [Applied]) {
    applied.fill(Applied::default());
    each(world, shapes, dt, |of, b, load| {
        if matches!(of.kind, LoadKind::Own { .. }) {
            return;
        }
        let slot = &mut applied[b];
        slot.force += load.force;
        slot.moment += load.moment;
    });
}

/// Adds what laws of code have found.
pub(crate) fn apply_own(world: &World, applied: &mut [Applied]) {
    for load in &world.setup.loads {
        if let LoadKind::Own { wrenches } = &load.kind {
            let there = applied.iter_mut().zip(wrenches).zip(&world.alive);
            for ((to, (force, moment)), _) in there.filter(|(_, alive)| **alive) {
                to.force += *force;
                to.moment += moment;
            }
        }
    }
}

/// Hands over every load in the kick before a step of `dt` (s) with each block that it acts on.
pub(crate) fn each(
    world: &World,
    shapes: &Shapes,
    dt: f64,
    mut put: impl FnMut(&Load, usize, Applied),
) {
    let half = [0.5 * world.last_dt, 0.5 * dt];
    for load in &world.setup.loads {
        let factor = load.time.in_kick(world.time, half);
        // What was released by and by is gone.
        if factor == 0.0 {
            continue;
        }
        let there = load.blocks.iter().map(|b| *b as usize);
        for b in there.filter(|b| world.alive[*b]) {
            put(load, b, on_block(world, shapes, &load.kind, factor, b));
        }
    }
}

/// What a load does to a block.
fn on_block(world: &World, shapes: &Shapes, kind: &LoadKind, factor: f64, b: usize) -> Applied {
    let (s, c) = libm::sincos(world.bodies[b].angle);
    let turn = |v: Vec2| Vec2::new(c * v.x - s * v.y, s * v.x + c * v.y);
    let body = |p: Vec2| p - shapes.centroid[b];
    match kind {
        LoadKind::Point { force, at, follows } => {
            let force = factor * if *follows { turn(*force) } else { *force };
            let moment = at.map_or(0.0, |at| turn(body(at)).perp_dot(force));
            Applied { force, moment }
        }
        LoadKind::Edge { from, to, traction, pressure } => {
            let ends = [*from, *to].map(body);
            let edge = EdgeTraction::new(shapes, b, ends, (*traction, *pressure), factor, turn);
            // Moment of a linear pressure: mean part at the middle, slope about it.
            let slope = edge.pressure_change / 12.0 * edge.along.perp_dot(edge.inward)
                + factor * edge.along.length() / 12.0 * edge.along.perp_dot(edge.traction_change);
            Applied { force: edge.push, moment: edge.middle.perp_dot(edge.push) + slope }
        }
        LoadKind::Moment { moment } => Applied { force: Vec2::ZERO, moment: factor * moment },
        LoadKind::Own { wrenches } => {
            let (force, moment) = wrenches.get(b).copied().unwrap_or_default();
            Applied { force, moment }
        }
        LoadKind::BodyForce { acceleration } => {
            Applied { force: factor * shapes.mass[b] * *acceleration, moment: 0.0 }
        }
    }
}

/// A load on an edge of a block that varies linearly along it, at the block's present attitude.
struct EdgeTraction {
    /// Middle of the edge from the centroid, m.
    middle: Vec2,
    /// From its first end to its second, m.
    along: Vec2,
    /// Into the block across the edge, as long as it, m.
    inward: Vec2,
    /// Resultant, N/m.
    push: Vec2,
    /// Pressure at the second end less that at the first, Pa, at this time.
    pressure_change: f64,
    /// The same of the traction, before its function of time.
    traction_change: Vec2,
}

impl EdgeTraction {
    /// `ends`: from the centroid in the body frame, m.
    fn new(
        shapes: &Shapes,
        b: usize,
        ends: [Vec2; 2],
        ([t0, t1], pressure): ([Vec2; 2], [f64; 2]),
        factor: f64,
        turn: impl Fn(Vec2) -> Vec2,
    ) -> Self {
        let [p, q] = ends.map(&turn);
        let along = q - p;
        let inward = along.length() * turn(-edge_normal(shapes, b, ends[0], ends[1]));
        let [p0, p1] = pressure.map(|x| x * factor);
        let mean = 0.5 * (t0 + t1);
        Self {
            middle: 0.5 * (p + q),
            along,
            inward,
            push: 0.5 * (p0 + p1) * inward + factor * along.length() * mean,
            pressure_change: p1 - p0,
            traction_change: t1 - t0,
        }
    }
}

/// Hands over block, arm from its centroid (m) and force (N/m) of all loads at points and edges. The variation along an edge is a
/// pair of its own, the edge with a twelfth of the change: `sum arm (x) force` is then the integral over the edge.
pub(crate) fn pushes(world: &World, shapes: &Shapes, put: &mut dyn FnMut(usize, Vec2, Vec2)) {
    for load in &world.setup.loads {
        let factor = load.time.at(world.time);
        let there = load.blocks.iter().map(|b| *b as usize);
        for b in there.filter(|b| factor != 0.0 && world.alive[*b]) {
            let (s, c) = libm::sincos(world.bodies[b].angle);
            let turn = |v: Vec2| Vec2::new(c * v.x - s * v.y, s * v.x + c * v.y);
            let body = |p: Vec2| p - shapes.centroid[b];
            match &load.kind {
                LoadKind::Point { force, at, follows } => {
                    let force = factor * if *follows { turn(*force) } else { *force };
                    if let Some(at) = at {
                        put(b, turn(body(*at)), force);
                    }
                }
                LoadKind::Edge { from, to, traction, pressure } => {
                    let ends = [*from, *to].map(body);
                    let edge =
                        EdgeTraction::new(shapes, b, ends, (*traction, *pressure), factor, turn);
                    put(b, edge.middle, edge.push);
                    let change = edge.pressure_change * edge.inward
                        + factor * edge.along.length() * edge.traction_change;
                    put(b, edge.along, change / 12.0);
                }
                LoadKind::Moment { .. } | LoadKind::BodyForce { .. } | LoadKind::Own { .. } => {}
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
