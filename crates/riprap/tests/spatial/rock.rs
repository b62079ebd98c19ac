//! Models of the source's rock: rho 2400 kg/m3, E 18 GPa, nu 0.25, so that c_P = 3000 and c_S = 1732 m/s.

use riprap::Vec3;
use riprap::exec::Exec;
use riprap::ledger::Balance;
use riprap::spatial::setup::{
    BlockName, BlockSpec, InterfaceLaw, JointLaw, Kinematics, Material, Points, Setup, Shape,
    Strength,
};
use riprap::spatial::step::{Damping, Scratch, advance, evaluate};
use riprap::spatial::view::View;
use riprap::spatial::world::World;

pub const DENSITY: f64 = 2400.0;
pub const CP: f64 = 3000.0;

pub fn elastic() -> JointLaw {
    JointLaw { points: Points::Quarter, ..JointLaw::default() }
}

pub fn strength(cohesion: f64, phi_deg: f64, tension: f64) -> Strength {
    let mu = phi_deg.to_radians().tan();
    Strength {
        cohesion,
        tension,
        friction: mu,
        residual_friction: mu,
        residual_cohesion: 0.0,
        dilation: 0.0,
        dilation_end: 0.0,
    }
}

pub fn brick(centre: Vec3, half: Vec3) -> BlockSpec {
    BlockSpec {
        name: BlockName { base: 0, number: 0 },
        shape: Shape::Brick { centre, half },
        material: 0,
        velocity: Vec3::ZERO,
        spin: Vec3::ZERO,
    }
}

/// Cubes of edge `a` in `n` cells along the axes, x fastest, lowest corner at the origin.
pub fn lattice(n: [usize; 3], a: f64) -> Vec<BlockSpec> {
    let mut blocks = Vec::new();
    for z in 0..n[2] {
        for y in 0..n[1] {
            for x in 0..n[0] {
                let centre = Vec3::new(x as f64 + 0.5, y as f64 + 0.5, z as f64 + 0.5) * a;
                let mut block = brick(centre, Vec3::splat(0.5 * a));
                block.name.number = blocks.len() as u32 + 1;
                blocks.push(block);
            }
        }
    }
    blocks
}

pub fn rock(blocks: Vec<BlockSpec>, joint: JointLaw) -> Setup {
    Setup {
        materials: vec![Material {
            name: "rock".into(),
            density: DENSITY,
            young: Some(18e9),
            poisson: Some(0.25),
        }],
        names: vec!["rock".into()],
        blocks,
        interfaces: vec![InterfaceLaw {
            name: "default".into(),
            bond: None,
            friction: None,
            joint,
        }],
        pair_table: vec![0],
        kinematics: Kinematics::Small,
        ..Setup::default()
    }
}

pub struct Run {
    pub world: World,
    pub scratch: Scratch,
    pub damping: Damping,
}

impl Run {
    pub fn new(setup: Setup) -> Self {
        Self::on(setup, Exec::serial())
    }

    pub fn on(setup: Setup, exec: Exec) -> Self {
        let (world, scratch) = World::new(setup, exec).expect("the model can be built");
        Self { world, scratch, damping: Damping::default() }
    }

    pub fn evaluate(&mut self, dt: f64) {
        evaluate(&mut self.world, &mut self.scratch, &self.damping, dt).expect("finite forces");
        if self.world.start_energy.is_none() {
            let view = self.view();
            // The ledger begins with the half kick behind them.
            let start = view.balance().total() - 0.5 * view.half_kick();
            self.world.start_energy = Some(start);
        }
    }

    pub fn steps(&mut self, count: usize, dt: f64) {
        for _ in 0..count {
            self.evaluate(dt);
            advance(&mut self.world, &mut self.scratch, dt);
        }
        self.evaluate(dt);
    }

    pub fn view(&self) -> View<'_> {
        View { world: &self.world, scratch: &self.scratch }
    }

    pub fn balance(&self) -> Balance {
        self.view().balance()
    }

    /// Energy at half steps of the motion that begins now, with half a kick, J: an edit ends the one before.
    pub fn beginning(&mut self, dt: f64) -> f64 {
        self.evaluate(dt);
        self.balance().total() - 0.5 * self.view().half_kick()
    }
}

/// Numbers between -1 and 1, the same in each run.
pub struct Draws(u64);

impl Draws {
    pub fn new(seed: u64) -> Self {
        Self(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1)
    }

    pub fn number(&mut self) -> f64 {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }

    pub fn vector(&mut self) -> Vec3 {
        Vec3::new(self.number(), self.number(), self.number())
    }
}
