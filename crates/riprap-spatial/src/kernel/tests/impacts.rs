//! Two blocks in motion under a small leapfrog of their own: impacts, friction and spinning against closed forms.

use riprap_geom::polyhedron::Polyhedron;
use riprap_geom::{Mat3, Quat, Vec3};

use crate::kernel::friction::ContactOutput;
use crate::kernel::kit::{Chance, KINDS, Kind, Placed, block};
use crate::kernel::offset::{Carried, Offset};
use crate::kernel::surface::Walker;
use crate::kernel::{
    ContactInput, ContactLaw, Found, Memory, Motion, Pose, Shape, contact_force, part,
};

mod frictionless;

/// A block that moves freely, or stands still when its mass is infinite.
struct Free {
    shape: Shape,
    mass: f64,
    inertia: Mat3,
    pose: Pose,
    velocity: Vec3,
    /// Angular momentum, N m s.
    momentum: Vec3,
}

impl Free {
    fn new(shape: Shape, solid: &Polyhedron, density: f64) -> Self {
        let moments = solid.moments();
        Self {
            shape,
            mass: density * moments.volume,
            inertia: moments.inertia * density,
            pose: Pose::at(Vec3::ZERO),
            velocity: Vec3::ZERO,
            momentum: Vec3::ZERO,
        }
    }

    fn brick(size: Vec3, density: f64) -> Self {
        let solid = Polyhedron::brick(Vec3::ZERO, 0.5 * size);
        Self::new(Shape::new(&solid, Vec3::ZERO).unwrap(), &solid, density)
    }

    fn fixed(size: Vec3) -> Self {
        let mut block = Self::brick(size, 1.0);
        block.mass = f64::INFINITY;
        block
    }

    fn spin_with(&self, rotation: Quat) -> Vec3 {
        if self.mass.is_infinite() {
            return Vec3::ZERO;
        }
        rotation * (self.inertia.inverse() * (rotation.inverse() * self.momentum))
    }

    fn spin(&self) -> Vec3 {
        self.spin_with(self.pose.rotation)
    }

    fn set_spin(&mut self, spin: Vec3) {
        let r = self.pose.rotation;
        self.momentum = r * (self.inertia * (r.inverse() * spin));
    }

    fn energy(&self) -> f64 {
        if self.mass.is_infinite() {
            return 0.0;
        }
        0.5 * self.mass * self.velocity.length_squared() + 0.5 * self.momentum.dot(self.spin())
    }

    fn motion(&self) -> Motion {
        Motion { velocity: self.velocity, spin: self.spin(), inverse_mass: 1.0 / self.mass }
    }

    fn kick(&mut self, force: Vec3, moment: Vec3, dt: f64) {
        if self.mass.is_finite() {
            self.velocity += force * (dt / self.mass);
            self.momentum += moment * dt;
        }
    }

    fn drift(&mut self, dt: f64) {
        self.pose.position += self.velocity * dt;
        let half = Quat::from_scaled_axis(0.5 * dt * self.spin()) * self.pose.rotation;
        let spin = self.spin_with(half);
        self.pose.rotation = (Quat::from_scaled_axis(dt * spin) * self.pose.rotation).normalize();
    }
}

/// A and B with their contact.
struct Two {
    blocks: [Free; 2],
    law: ContactLaw,
    memory: Memory,
    offset: Option<Box<Offset>>,
    /// What the contact was booked to store beyond what its forces took up, J.
    booked: f64,
    gravity: Vec3,
    walker: Walker,
    lowest: f64,
    touched: bool,
    /// Friction and damping so far, J.
    lost: f64,
}

impl Two {
    fn new(blocks: [Free; 2], law: ContactLaw) -> Self {
        Self {
            blocks,
            law,
            memory: Memory::default(),
            offset: None,
            booked: 0.0,
            gravity: Vec3::ZERO,
            walker: Walker::default(),
            lowest: f64::INFINITY,
            touched: false,
            lost: 0.0,
        }
    }

    /// Forces now; `dt` has passed since the last time.
    fn reply(&mut self, dt: f64) -> Option<ContactOutput> {
        let placed = Placed::new(
            [&self.blocks[0].shape, &self.blocks[1].shape],
            [self.blocks[0].pose, self.blocks[1].pose],
        );
        let Found::Touching(sums) = placed.find_all(&mut self.walker) else {
            let motion = [0, 1].map(|s| self.blocks[s].motion());
            self.booked += part(self.offset.take(), &motion, &self.memory, dt);
            self.memory = Memory::default();
            return None;
        };
        self.touched = true;
        self.lowest = self.lowest.min(self.blocks[1].pose.position.z);
        let falls = self.walker.falling(&self.law, &sums);
        let question = ContactInput {
            sums: &sums,
            pieces: &|show| self.walker.rubbing(show),
            origin: placed.origin(),
            centres: [0, 1].map(|s| self.blocks[s].pose.position),
            motion: [0, 1].map(|s| self.blocks[s].motion()),
            radius: self.blocks[0].shape.radius.min(self.blocks[1].shape.radius),
            dt,
            last_dt: dt,
            shared: None,
            falls,
        };
        let reply = contact_force(&self.law, &question, &mut self.memory, &mut self.offset);
        self.booked += reply.booked;
        self.lost += reply.friction - reply.damping * dt;
        Some(reply)
    }

    /// One step; `first` kicks by half.
    fn step(&mut self, dt: f64, first: bool) -> Option<ContactOutput> {
        let reply = self.reply(if first { 0.0 } else { dt });
        let kick = if first { 0.5 * dt } else { dt };
        if let Some(r) = &reply {
            let w = r.wrench;
            self.blocks[0].kick(-w.force, w.moment_a, kick);
            self.blocks[1].kick(w.force, w.moment_b, kick);
        }
        for block in &mut self.blocks {
            if block.mass.is_finite() {
                block.velocity += self.gravity * kick;
            }
            block.drift(dt);
        }
        reply
    }

    /// Until they have touched and parted.
    fn collide(&mut self, dt: f64) {
        for n in 0..2_000_000 {
            let apart = self.step(dt, n == 0).is_none();
            if self.touched && apart {
                return;
            }
        }
        panic!("they never part");
    }

    fn energy(&self) -> f64 {
        self.blocks[0].energy() + self.blocks[1].energy()
    }
}

fn law(stiffness: f64, friction: f64, damping_ratio: f64) -> ContactLaw {
    ContactLaw {
        normal_stiffness: stiffness,
        shear_stiffness: 0.5 * stiffness,
        friction,
        cohesion: 0.0,
        damping_ratio,
        rebound: 0.0,
        growth: 0.0,
    }
}

fn elastic_loss(kind: Kind, seed: u64, dt: f64) -> f64 {
    let mut chance = Chance::new(seed);
    let mut two = Two::new(
        [0, 1].map(|_| {
            let (shape, solid) = block(kind, &mut chance);
            Free::new(shape, &solid, 2500.0)
        }),
        law(1e9, 0.0, 0.0),
    );
    let direction = chance.direction();
    let away = two.blocks[0].shape.radius + two.blocks[1].shape.radius;
    for (s, sign) in [(0, -0.5), (1, 0.5)] {
        let aside = 0.1 * chance.direction();
        let spin = chance.between(0.0, 2.0) * chance.direction();
        let rotation = chance.rotation();
        let block = &mut two.blocks[s];
        block.pose = Pose { position: sign * away * direction + aside, rotation };
        block.velocity = -2.0 * sign * direction;
        block.set_spin(spin);
    }
    let before = two.energy();
    let linear = |two: &Two| {
        let [a, b] = &two.blocks;
        a.velocity * a.mass + b.velocity * b.mass
    };
    let angular = |two: &Two| {
        let part = |f: &Free| f.momentum + f.pose.position.cross(f.velocity) * f.mass;
        part(&two.blocks[0]) + part(&two.blocks[1])
    };
    let (p, l) = (linear(&two), angular(&two));
    two.collide(dt);
    let scale = two.blocks[0].mass + two.blocks[1].mass;
    assert!((linear(&two) - p).length() < 1e-12 * scale, "{kind:?}");
    assert!((angular(&two) - l).length() < 1e-11 * scale, "{kind:?}");
    ((two.energy() - before) / before).abs()
}

fn median(mut list: Vec<f64>) -> f64 {
    list.sort_by(f64::total_cmp);
    list[list.len() / 2]
}

#[test]
fn elastic_collisions_keep_energy_to_second_order() {
    for kind in KINDS {
        let losses =
            |dt: f64| -> Vec<f64> { (1..=8).map(|seed| elastic_loss(kind, seed, dt)).collect() };
        let (coarse, fine) = (losses(1.6e-4), losses(8e-5));
        let worst = coarse.iter().copied().fold(0.0, f64::max);
        let (coarse, fine) = (median(coarse), median(fine));
        println!("{kind:?}: median {coarse:.1e}, {fine:.1e}, worst {worst:.1e}");
        assert!(coarse < 1e-8 && worst < 1e-4);
        assert!(fine < 0.45 * coarse);
    }
}

#[test]
fn restitution_of_a_flat_face() {
    for (xi, exact) in [(0.05, 0.858_76), (0.2, 0.571_74), (0.5, 0.298_44)] {
        let mut brick = Free::brick(Vec3::ONE, 2500.0);
        brick.pose.position = Vec3::new(0.0, 0.0, 1.0005);
        brick.velocity = Vec3::new(0.0, 0.0, -0.1);
        let floor = Free::fixed(Vec3::new(4.0, 4.0, 1.0));
        let mut two = Two::new([floor, brick], law(1e9, 0.0, xi));
        let critical = 2.0 * (2500.0 / 1e9_f64).sqrt();
        two.collide(0.01 * critical);
        let e = two.blocks[1].velocity.z / 0.1;
        assert!((e - exact).abs() < 0.01 * exact, "{e} for {exact}");
    }
}

#[test]
fn impact_of_a_cube_on_its_corner() {
    let fall = |xi: f64, speed: f64| {
        let mut cube = Free::brick(Vec3::ONE, 2500.0);
        let upright = Quat::from_rotation_arc(Vec3::ONE.normalize(), Vec3::Z);
        cube.pose =
            Pose { position: Vec3::new(0.0, 0.0, 0.5 + 0.75_f64.sqrt() + 1e-4), rotation: upright };
        cube.velocity = Vec3::new(0.0, 0.0, -speed);
        let floor = Free::fixed(Vec3::new(4.0, 4.0, 1.0));
        let mut two = Two::new([floor, cube], law(1e10, 0.0, xi));
        two.collide(2e-5);
        let depth = 0.5 + 0.75_f64.sqrt() - two.lowest;
        (two.blocks[1].velocity.z / speed, depth)
    };
    let (e, depth) = fall(0.0, 2.0);
    let exact = (2500.0_f64 * 4.0 / (2.0 * 0.158_493_649_05 * 1e10)).powf(0.25);
    assert!((depth / exact - 1.0).abs() < 1e-5, "{depth} {exact}");
    assert!((e - 1.0).abs() < 1e-7, "{e}");
    for speed in [0.5, 2.0, 8.0] {
        let (e, _) = fall(0.2, speed);
        assert!((e - 0.465).abs() < 0.005, "{e} at {speed}");
    }
}

#[test]
fn aligned_bricks_stay_aligned() {
    let mut a = Free::brick(Vec3::new(1.0, 0.7, 0.5), 2500.0);
    let mut b = Free::brick(Vec3::new(1.0, 0.7, 0.5), 2500.0);
    a.velocity = Vec3::new(0.0, 0.0, 0.5);
    b.pose.position = Vec3::new(0.0, 0.0, 0.5 + 1e-3);
    b.velocity = Vec3::new(0.0, 0.0, -0.5);
    let mut two = Two::new([a, b], law(1e10, 0.0, 0.0));
    two.collide(4e-6);
    for block in &two.blocks {
        assert!(block.velocity.truncate().length() < 1e-12);
        assert!(block.spin().length() < 1e-12);
        // The step meets the jump in stiffness at the touch within half its length.
        assert!((block.velocity.z.abs() - 0.5).abs() < 1e-3, "{}", block.velocity);
    }
}

/// Slides down after the springs have loaded, whatever the azimuth; stays when friction is enough.
#[test]
fn brick_on_a_slope() {
    for azimuth in [0.0_f64, 0.7] {
        let slide = |angle_of_friction: f64, time: f64| {
            let brick = |size| Free::brick(size, 2500.0);
            let mut block = brick(Vec3::new(1.0, 0.8, 0.5));
            block.pose.rotation = Quat::from_rotation_z(0.3);
            let floor = Free::fixed(Vec3::new(8.0, 8.0, 1.0));
            let mut two =
                Two::new([floor, block], law(1e10, libm::tan(angle_of_friction.to_radians()), 0.2));
            // The slope is turned into the horizontal, gravity out of the vertical.
            let (s, c) = libm::sincos(30_f64.to_radians());
            let down = Vec3::new(libm::cos(azimuth), libm::sin(azimuth), 0.0);
            two.gravity = 10.0 * (s * down - c * Vec3::Z);
            let depth = 2500.0 * 0.5 * 10.0 * c / 1e10;
            two.blocks[1].pose.position.z = 0.75 - depth;
            let dt = 1e-4;
            let steps = (time / dt) as usize;
            let mut half = (0.0, Vec3::ZERO);
            for n in 0..steps {
                two.step(dt, n == 0);
                if n + 1 == steps / 2 {
                    half = (dt * (steps - steps / 2) as f64, two.blocks[1].velocity);
                }
            }
            let acceleration = (two.blocks[1].velocity - half.1) / half.0;
            (acceleration, down, two.blocks[1].pose.position)
        };
        let (acceleration, down, at) = slide(20.0, 0.3);
        let exact = 10.0 * (0.5 - 30_f64.to_radians().cos() * 20_f64.to_radians().tan());
        assert!((acceleration.dot(down) / exact - 1.0).abs() < 1e-5, "{acceleration}");
        assert!(at.dot(Vec3::Z.cross(down)).abs() < 1e-6, "{at}");
        let (_, _, early) = slide(31.0, 0.1);
        let (_, _, late) = slide(31.0, 0.2);
        assert!((late - early).truncate().length() < 1e-9, "{}", late - early);
    }
}

/// A plate that spins on a floor under its weight stops after `w0 I / (mu m g r_m)`.
#[test]
fn spinning_plates() {
    for (length, ratio) in [(1.0, 0.9372), (2.0, 0.9190), (10.0, 0.8727)] {
        let size = Vec3::new(length, 1.0, 0.2);
        let mut plate = Free::brick(size, 2500.0);
        let (mass, polar) = (plate.mass, plate.inertia.z_axis.z);
        let depth = 2500.0 * 0.2 * 10.0 / 1e10;
        plate.pose.position = Vec3::new(0.0, 0.0, 0.6 - depth);
        plate.set_spin(Vec3::new(0.0, 0.0, 2.0));
        let floor = Free::fixed(Vec3::new(30.0, 30.0, 1.0));
        let mut two = Two::new([floor, plate], law(1e10, 0.5, 0.2));
        two.gravity = Vec3::new(0.0, 0.0, -10.0);
        let gyration = ((length * length + 1.0) / 12.0).sqrt();
        let exact = 2.0 * polar / (0.5 * mass * 10.0 * ratio * gyration);
        let dt = 1e-4;
        let mut time = 0.0;
        while two.blocks[1].spin().z > 0.0 && time < 5.0 {
            two.step(dt, time == 0.0);
            time += dt;
        }
        println!("{length}: {}", time / exact - 1.0);
        assert!((time / exact - 1.0).abs() < 2e-3, "{time} {exact}");
        assert!(two.blocks[1].pose.position.truncate().length() < 1e-9);
    }
}

/// Coulomb's law at every point of a square of uniform pressure that slides and spins, by Runge-Kutta steps of 0.5 ms on 240 x 240 points: after
/// 0.5 s it has gone 0.486419 m, slides at 0.436942 m/s and spins at 2.164327 1/s; it stops at 0.6925 s after 0.529046 m.
#[test]
fn slide_and_spin_stop_together() {
    let (side, thick) = (0.6, 0.02);
    let (friction, gravity) = (0.4, 9.81);
    let mut plate = Free::brick(Vec3::new(side, side, thick), 2500.0);
    plate.pose.position.z = 0.5 + 0.5 * thick - 2500.0 * thick * gravity / 1e10;
    plate.velocity = Vec3::new(1.5, 0.0, 0.0);
    plate.set_spin(Vec3::new(0.0, 0.0, 8.0));
    let floor = Free::fixed(Vec3::new(4.0, 4.0, 1.0));
    let mut two = Two::new([floor, plate], law(1e10, friction, 0.2));
    two.gravity = Vec3::new(0.0, 0.0, -gravity);
    let dt = 2e-5;
    let near = |found: f64, exact: f64, slack: f64| {
        assert!((found / exact - 1.0).abs() < slack, "{found} {exact}");
    };
    let mut stopped = 0.0;
    for step in 1..=36_000 {
        let lost = two.lost;
        two.step(dt, step == 1);
        let time = dt * f64::from(step);
        let plate = &two.blocks[1];
        if step == 25_000 {
            near(plate.velocity.x, 0.436_942, 2e-3);
            near(plate.spin().z, 2.164_327, 2e-3);
            near(plate.pose.position.x, 0.486_419, 1e-3);
        }
        let moves = plate.velocity.length() > 1e-3 || plate.spin().z > 1e-2;
        if moves {
            assert!(two.lost > lost - 1e-9, "friction gives {}", lost - two.lost);
            stopped = time;
        }
    }
    near(stopped, 0.6925, 3e-3);
    let plate = &two.blocks[1];
    near(plate.pose.position.x, 0.529_046, 1e-3);
    assert!(plate.velocity.length() < 1e-6 && plate.spin().length() < 1e-6);
}

/// What a sliding and spinning brick loses is what the contact books.
#[test]
fn friction_and_damping_are_what_is_lost() {
    let mut brick = Free::brick(Vec3::new(1.0, 0.7, 0.5), 2500.0);
    let depth = 2500.0 * 0.5 * 10.0 / 1e9;
    brick.pose.position = Vec3::new(0.0, 0.0, 0.75 - depth);
    brick.velocity = Vec3::new(1.5, 0.2, 0.0);
    brick.set_spin(Vec3::new(0.0, 0.0, 4.0));
    let floor = Free::fixed(Vec3::new(8.0, 8.0, 1.0));
    let mut two = Two::new([floor, brick], law(1e9, 0.5, 0.2));
    two.gravity = Vec3::new(0.0, 0.0, -10.0);
    let before = two.energy();
    for n in 0..8000 {
        two.step(1e-4, n == 0);
    }
    assert!(two.energy() < 1e-3, "{}", two.energy());
    assert!((two.lost / before - 1.0).abs() < 2e-3, "{} of {before}", two.lost);
}

/// A cube of 1 m that lies 1 mm deep in a fixed plate; the joint that has let go carried `share` of the pressure there, with springs
/// `softness` times as stiff as those of the law.
fn released_pair(share: f64, softness: f64, velocity: Vec3) -> (Two, f64) {
    let (stiffness, depth) = (1e9, 1e-3);
    let mut cube = Free::brick(Vec3::ONE, 2500.0);
    cube.pose.position = Vec3::new(0.0, 0.0, 1.0 - depth);
    cube.velocity = velocity;
    let floor = Free::fixed(Vec3::new(4.0, 4.0, 1.0));
    let mut two = Two::new([floor, cube], law(stiffness, 0.0, 0.0));
    let normal = share * stiffness * depth;
    let energy = 0.5 * normal * normal / (softness * stiffness);
    two.offset = Some(Box::new(Offset::new(Carried {
        normal,
        rocking: Vec3::ZERO,
        at: Vec3::new(0.0, 0.0, 0.5),
        energy,
    })));
    (two, energy)
}

/// Blocks that lie deeper in each other than any force has pressed them gain nothing from that depth, however far they slide.
#[test]
fn what_a_joint_did_not_carry_gives_no_energy() {
    // 1 m along the plate, ten times the way over which what is too much fades.
    let (mut two, _) = released_pair(0.0, 1.0, Vec3::new(1.0, 0.0, 0.0));
    let before = two.energy();
    for n in 0..10_000 {
        two.step(1e-4, n == 0);
    }
    let cube = &two.blocks[1];
    assert!((cube.pose.position.z - 0.999).abs() < 1e-9, "{}", cube.pose.position);
    assert!((two.energy() / before - 1.0).abs() < 1e-9);
    assert!(two.offset.is_some());
    // Over the edge of the plate, where its overlap ends.
    for _ in 0..30_000 {
        two.step(1e-4, false);
    }
    assert!((two.energy() / before - 1.0).abs() < 1e-9);
    assert!(two.offset.is_none() && two.booked.abs() < 1e-9 * before);
}

/// A joint that pressed half as hard gives back what its springs had stored, whether it was as stiff as the law or half as stiff, and a
/// blow from outside the same energy again.
#[test]
fn a_joint_that_pressed_softer_gives_back_what_it_had_stored() {
    for softness in [1.0, 0.5] {
        let (mut two, energy) = released_pair(0.5, softness, Vec3::ZERO);
        two.collide(2e-5);
        let gained = two.energy() / energy;
        assert!((gained - 1.0).abs() < 5e-3, "{softness}: {gained}");
        // All of it came from the joint: what it brought was booked, and nothing was left at the end.
        let made = two.booked / energy - 1.0;
        assert!(made.abs() < 5e-3, "{softness}: {made}");
        // Pressed further in, it takes up energy and gives the same again.
        let (mut two, energy) = released_pair(0.5, softness, Vec3::new(0.0, 0.0, -0.5));
        let before = two.energy();
        two.collide(2e-5);
        let gained = (two.energy() - before) / energy;
        assert!((gained - 1.0).abs() < 1e-2, "{softness}: {gained}");
    }
}
