//! What the tests of the planar engine share: small models by hand, poses, random polygons.

use riprap::Vec2;
use riprap::exec::Exec;
use riprap::ledger::Balance;
use riprap::planar::setup::{
    BlockSpec, ContactLaw, FrictionLaw, Interface, Motion, NormalLaw, Reflex, Setup, Support,
};
use riprap::planar::step::{Damping, Scratch, advance, evaluate};
use riprap::planar::view::View;
use riprap::planar::world::{World, Wrench};

pub const DISTANCE: NormalLaw = NormalLaw::DistancePotential;
pub const SOURCE: NormalLaw = NormalLaw::PenetrationPotential;

/// Frictionless, undamped.
pub fn law(normal: NormalLaw, stiffness: f64) -> ContactLaw {
    ContactLaw {
        normal,
        reflex: Reflex::Min,
        normal_stiffness: stiffness,
        shear_stiffness: stiffness,
        friction: 0.0,
        cohesion: 0.0,
        friction_law: FrictionLaw::ShearSpring,
        clip_speed: 0.0,
        damping_ratio: 0.0,
    }
}

/// The same law on the road for any polygons: only the fast kernel knows no rate friction.
pub fn general(mut law: ContactLaw) -> ContactLaw {
    law.friction_law = FrictionLaw::RateSign;
    law
}

pub fn block(vertices: &[Vec2]) -> BlockSpec {
    BlockSpec {
        name: String::new(),
        vertices: vertices.to_vec(),
        material: 0,
        density: 2500.0,
        velocity: Vec2::ZERO,
        spin: 0.0,
    }
}

/// No gravity, no supports.
pub fn setup(blocks: Vec<BlockSpec>, contact: ContactLaw) -> Setup {
    Setup {
        materials: vec!["rock".into()],
        blocks,
        interfaces: vec![Interface { name: "default".into(), contact, bond: None }],
        pair_table: vec![0],
        ..Setup::default()
    }
}

pub const HELD: Motion = Motion::Fixed { x: true, y: true, rotation: true };

pub fn hold(setup: &mut Setup, blocks: &[u32]) {
    setup.supports.push(Support { blocks: blocks.to_vec(), motion: HELD });
}

pub fn rectangle(x0: f64, y0: f64, x1: f64, y1: f64) -> Vec<Vec2> {
    points(&[(x0, y0), (x1, y0), (x1, y1), (x0, y1)])
}

pub fn points(list: &[(f64, f64)]) -> Vec<Vec2> {
    list.iter().map(|&(x, y)| Vec2::new(x, y)).collect()
}

pub fn turned(v: Vec2, angle: f64) -> Vec2 {
    let (s, c) = libm::sincos(angle);
    Vec2::new(c * v.x - s * v.y, s * v.x + c * v.y)
}

/// Every vertex turned about the origin, then shifted.
pub fn moved(vertices: &[Vec2], angle: f64, shift: Vec2) -> Vec<Vec2> {
    vertices.iter().map(|&v| turned(v, angle) + shift).collect()
}

/// A model with its forces evaluated.
pub struct Model {
    pub world: World,
    pub scratch: Scratch,
    pub damping: Damping,
}

impl Model {
    pub fn new(setup: Setup) -> Self {
        Self::on(setup, Exec::serial())
    }

    pub fn on(setup: Setup, exec: Exec) -> Self {
        let (world, scratch) = World::new(setup, exec);
        Self { world, scratch, damping: Damping::default() }
    }

    /// A model that goes on from a state, as from a checkpoint.
    pub fn on_world(mut world: World) -> Self {
        let scratch = Scratch::new(&mut world, Exec::serial());
        Self { world, scratch, damping: Damping::default() }
    }

    /// Two blocks at rest, forces evaluated.
    pub fn pair(a: &[Vec2], b: &[Vec2], law: ContactLaw) -> Self {
        let mut model = Self::new(setup(vec![block(a), block(b)], law));
        model.evaluate(1e-9);
        model
    }

    pub fn evaluate(&mut self, dt: f64) {
        evaluate(&mut self.world, &mut self.scratch, &self.damping, dt).unwrap();
        if self.world.start_energy.is_none() {
            self.world.start_energy = Some(self.balance().total());
        }
    }

    pub fn step(&mut self, dt: f64) {
        self.evaluate(dt);
        advance(&mut self.world, &mut self.scratch, dt);
    }

    /// Steps, then evaluates, so that the state can be read.
    pub fn run(&mut self, dt: f64, steps: usize) {
        for _ in 0..steps {
            self.step(dt);
        }
        self.evaluate(dt);
    }

    pub fn view(&self) -> View<'_> {
        View { world: &self.world, scratch: &self.scratch }
    }

    pub fn balance(&self) -> Balance {
        self.view().balance()
    }

    /// Puts block `b` somewhere else and evaluates; contact memory starts anew from the poses.
    pub fn place(&mut self, b: usize, position: Vec2, angle: f64) {
        self.world.bodies[b].position = position;
        self.world.bodies[b].angle = angle;
        let range = self.scratch.shapes.range(b);
        for k in range {
            let edge = &self.scratch.shapes.edges[k];
            let (start, normal) = (edge.start, edge.normal);
            let (s, c) = libm::sincos(angle);
            let turn = |v: Vec2| Vec2::new(c * v.x - s * v.y, s * v.x + c * v.y);
            self.scratch.turned[k].start = turn(start);
            self.scratch.turned[k].normal = turn(normal);
        }
        self.scratch.invalidate(&mut self.world);
        self.evaluate(1e-9);
    }

    /// Wrench on the first block of the pair.
    pub fn wrench(&self) -> Wrench {
        self.view().pair_wrench(0, 1)
    }

    /// Moment of the pair's forces about the origin: of both blocks together, and its scale.
    pub fn leftover_moment(&self) -> (f64, f64) {
        let w = self.wrench();
        let (i, j) = (self.world.bodies[0].position, self.world.bodies[1].position);
        let first = i.perp_dot(w.force) + w.moment_i;
        let second = -j.perp_dot(w.force) + w.moment_j;
        (first + second, w.force.length() * (i.length() + j.length() + 1.0) + w.moment_i.abs())
    }

    pub fn momentum(&self) -> Vec2 {
        let view = self.view();
        view.living().map(|b| self.scratch.shapes.mass[b] * view.velocity(b)).sum()
    }
}

/// Deterministic random numbers (splitmix64).
pub struct Random(pub u64);

impl Random {
    pub fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    }

    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    /// Convex polygon of 3 to 7 corners about the origin, roughly `size` across.
    pub fn convex(&mut self, size: f64) -> Vec<Vec2> {
        let n = 3 + (self.unit() * 5.0) as usize;
        let (rx, ry) = (0.5 * size * self.between(0.7, 1.0), 0.5 * size * self.between(0.5, 1.0));
        let turn = self.between(0.0, std::f64::consts::TAU);
        (0..n)
            .map(|k| {
                let share = (k as f64 + 0.7 * self.unit()) / n as f64;
                let a = std::f64::consts::TAU * share;
                turned(Vec2::new(rx * libm::cos(a), ry * libm::sin(a)), turn)
            })
            .collect()
    }
}

pub fn l_shape() -> Vec<Vec2> {
    points(&[(0.0, 0.0), (1.0, 0.0), (1.0, 0.4), (0.4, 0.4), (0.4, 1.0), (0.0, 1.0)])
}

pub fn notched() -> Vec<Vec2> {
    points(&[(0.0, 0.0), (1.2, 0.0), (1.2, 0.6), (0.8, 0.6), (0.6, 0.3), (0.4, 0.6), (0.0, 0.6)])
}

/// Teeth point down.
pub fn comb() -> Vec<Vec2> {
    points(&[
        (0.0, 0.0),
        (0.2, 0.0),
        (0.2, 0.3),
        (0.5, 0.3),
        (0.5, 0.0),
        (0.7, 0.0),
        (0.7, 0.3),
        (1.0, 0.3),
        (1.0, 0.0),
        (1.2, 0.0),
        (1.2, 0.6),
        (0.0, 0.6),
    ])
}

/// Open at the top.
pub fn u_shape() -> Vec<Vec2> {
    points(&[
        (0.0, 0.0),
        (1.2, 0.0),
        (1.2, 0.9),
        (0.9, 0.9),
        (0.9, 0.3),
        (0.3, 0.3),
        (0.3, 0.9),
        (0.0, 0.9),
    ])
}

/// Quantile `share` of a list.
pub fn quantile(list: &[f64], share: f64) -> f64 {
    let mut sorted = list.to_vec();
    sorted.sort_by(f64::total_cmp);
    sorted[((sorted.len() - 1) as f64 * share).round() as usize]
}
