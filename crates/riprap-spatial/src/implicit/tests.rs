//! Blocks stepped by the implicit law alone, without a world: slopes, stacks, columns.

use riprap_geom::{Mat3, Quat, Vec3};

use crate::implicit::geometry::{Reach, reach};
use crate::implicit::memory::Kept;
use crate::implicit::pair::Pair;
use crate::implicit::patch::Stepping;
use crate::implicit::solve::{Body, Effort, Solver};
use crate::kernel::kit::{Placed, all_faces};
use crate::kernel::surface::{self, Walker};
use crate::kernel::{ContactLaw, PairKey, Pose, Shape};

struct Block {
    shape: Shape,
    pose: Pose,
    held: bool,
    mass: f64,
    inertia: Vec3,
    motion: [Vec3; 2],
}

struct Model {
    blocks: Vec<Block>,
    gravity: Vec3,
    law: ContactLaw,
    kept: Vec<Kept>,
    solver: Solver,
    walker: Walker,
    effort: Effort,
    rounds: usize,
}

fn brick(size: [f64; 3], centre: Vec3, held: bool) -> Block {
    let [a, b, c] = size;
    let mass = 2000.0 * a * b * c;
    Block {
        shape: Shape::brick(0.5 * Vec3::new(a, b, c)).unwrap(),
        pose: Pose::at(centre),
        held,
        mass,
        inertia: mass / 12.0 * Vec3::new(b * b + c * c, c * c + a * a, a * a + b * b),
        motion: [Vec3::ZERO; 2],
    }
}

fn law(stiffness: f64, friction: f64) -> ContactLaw {
    ContactLaw {
        normal_stiffness: stiffness,
        shear_stiffness: stiffness,
        friction,
        cohesion: 0.0,
        damping_ratio: 0.0,
        rebound: 0.0,
        growth: 0.0,
    }
}

impl Model {
    fn new(blocks: Vec<Block>, gravity: Vec3, law: ContactLaw) -> Self {
        Self {
            blocks,
            gravity,
            law,
            kept: Vec::new(),
            solver: Solver::default(),
            walker: Walker::default(),
            effort: Effort::default(),
            rounds: 0,
        }
    }

    fn step(&mut self, dt: f64) {
        let n = self.blocks.len();
        let mut place = vec![None; n];
        self.solver.bodies.clear();
        self.solver.motion.clear();
        for (b, block) in self.blocks.iter().enumerate().filter(|(_, block)| !block.held) {
            place[b] = Some(self.solver.bodies.len() as u32);
            let turn = Mat3::from_quat(block.pose.rotation);
            let inertia = turn * Mat3::from_diagonal(block.inertia) * turn.transpose();
            let [v, w] = block.motion;
            let free = [v + dt * self.gravity, w];
            let held = [false; 6];
            self.solver.bodies.push(Body { mass: block.mass, inertia, free, held });
            self.solver.motion.push([v.x, v.y, v.z, w.x, w.y, w.z]);
        }
        self.solver.pairs.clear();
        let mut ends = Vec::new();
        for i in 0..n {
            for j in i + 1..n {
                let (a, b) = (&self.blocks[i], &self.blocks[j]);
                if a.held && b.held {
                    continue;
                }
                let speed =
                    |k: &Block| k.motion[0].length() + k.motion[1].length() * k.shape.radius;
                let most = 0.5 * a.shape.inradius.min(b.shape.inradius);
                let out = (20e-6 + 0.7 * dt * (speed(a) + speed(b))).min(most);
                let apart = (a.pose.position - b.pose.position).length();
                if apart > a.shape.radius + b.shape.radius + 2.0 * out {
                    continue;
                }
                let placed = Placed::new([&a.shape, &b.shape], [a.pose, b.pose]);
                let lists = [all_faces(&a.shape), all_faces(&b.shape)];
                let [x, y] = placed.bodies();
                let faces = [&lists[0][..], &lists[1][..]];
                let surface = surface::Pair {
                    bodies: [&x, &y],
                    faces,
                    ties: true,
                    hint: None,
                    covered: [0; 2],
                    witnesses: &[],
                };
                let mut pair = Pair::default();
                match reach(&mut self.walker, &surface, out, self.law, &mut pair) {
                    Reach::Near(_) => {}
                    Reach::Apart(_) => continue,
                    Reach::Lost => panic!("{i} and {j} have no surface"),
                }
                pair.ends = [place[i], place[j]];
                pair.given = [a.motion, b.motion];
                let numbers = PairKey::plain([i as u32, j as u32]);
                if let Some(old) = self.kept.iter().find(|k| k.pair == numbers) {
                    old.recall(&mut pair, &mut Vec::new());
                }
                ends.push(numbers);
                self.solver.pairs.push(pair);
            }
        }
        let stepping = Stepping { span: dt, dt };
        let fall = self.gravity.length() * dt + 1e-4;
        self.effort = self.solver.solve(&stepping, fall, 1e-5 * fall).unwrap();
        self.rounds += self.effort.rounds;
        let pairs = self.solver.pairs.iter().zip(&self.solver.replies).zip(ends);
        self.kept = pairs
            .filter_map(|((pair, reply), key)| Kept::of(key, pair, reply.shear, reply.torsion))
            .collect();
        for (b, place) in place.iter().enumerate() {
            let block = &mut self.blocks[b];
            if let Some(at) = place {
                let [x, y, z, p, q, r] = self.solver.motion[*at as usize];
                block.motion = [Vec3::new(x, y, z), Vec3::new(p, q, r)];
            }
            let [v, w] = block.motion;
            block.pose.position += dt * v;
            block.pose.rotation = (rotation(dt * w) * block.pose.rotation).normalize();
        }
    }
}

fn rotation(vector: Vec3) -> Quat {
    crate::setup::rotation::rotation(vector)
}

/// Weight turned by the angle of a slope whose tangent is `share` of the friction: a brick on a slab.
fn slope(share: f64, stiffness: f64, dt: f64) -> Model {
    let friction: f64 = 0.6;
    let angle = (share * friction).atan();
    let gravity = 10.0 * Vec3::new(angle.sin(), 0.0, -angle.cos());
    let blocks = vec![
        brick([20.0, 4.0, 1.0], Vec3::new(0.0, 0.0, -0.5), true),
        brick([0.25, 0.12, 0.065], Vec3::new(0.0, 0.0, 0.0325), false),
    ];
    let mut model = Model::new(blocks, gravity, law(stiffness, friction));
    for _ in 0..(1.0 / dt).round() as usize {
        model.step(dt);
    }
    model
}

#[test]
fn a_block_below_its_angle_of_friction_stays() {
    for stiffness in [1e10, 1e12] {
        for dt in [1e-3, 5e-3] {
            let model = slope(0.98, stiffness, dt);
            let block = &model.blocks[1];
            let way = block.pose.position.x.abs();
            assert!(way < 3e3 / stiffness, "{stiffness:e} {dt}: {way:e}");
            assert!(block.motion[0].length() < 1e-12, "{stiffness:e} {dt}: {:?}", block.motion);
        }
    }
}

#[test]
fn a_block_above_it_slides_as_coulomb_says() {
    for stiffness in [1e10, 1e12] {
        for dt in [1e-3, 5e-3] {
            let model = slope(1.02, stiffness, dt);
            let way = model.blocks[1].pose.position.x;
            let angle: f64 = (1.02_f64 * 0.6).atan();
            let exact = 0.5 * 10.0 * (angle.sin() - 0.6 * angle.cos()) * (1.0 + dt);
            assert!((way / exact - 1.0).abs() < 2e-3, "{stiffness:e} {dt}: {way} for {exact}");
        }
    }
}

#[test]
fn twenty_bricks_rest_on_each_other() {
    for dt in [1e-3_f64, 5e-3] {
        let mut blocks = vec![brick([4.0, 4.0, 1.0], Vec3::new(0.0, 0.0, -0.5), true)];
        for k in 0..20 {
            let at = Vec3::new(0.0, 0.0, 0.0325 + 0.065 * k as f64);
            blocks.push(brick([0.25, 0.12, 0.065], at, false));
        }
        let mut model = Model::new(blocks, Vec3::new(0.0, 0.0, -10.0), law(1e12, 0.6));
        for _ in 0..(1.0 / dt).round() as usize {
            model.step(dt);
        }
        for kept in &model.kept {
            let [below, above] = kept.pair.ends;
            if above != below + 1 {
                continue;
            }
            let weight = (20 - below) as f64 * 2000.0 * 0.25 * 0.12 * 0.065 * 10.0;
            let error = kept.force / weight - 1.0;
            assert!(error.abs() < 1e-5, "{dt} {:?}: {error:e}", kept.pair.ends);
        }
        let top = &model.blocks[20];
        assert!(top.pose.position.truncate().length() < 1e-8);
        assert!((model.rounds as f64) < 1.2 / dt, "{dt}: {} rounds", model.rounds);
    }
}
