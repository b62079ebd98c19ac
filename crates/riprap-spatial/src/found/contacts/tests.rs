//! Piles of cubes under a small leapfrog: the same bits for any number of threads and after a restart, the laws of
//! conservation, and what stops a run.

use riprap_geom::Quat;

use super::super::kit::Chance;
use super::super::{Role, Shape};
use super::*;

const LAW: ContactLaw = ContactLaw {
    normal_stiffness: 1e9,
    shear_stiffness: 5e8,
    friction: 0.5,
    cohesion: 0.0,
    damping_ratio: 0.2,
};

/// Cubes of one size, each of 2500 kg/m³; the inertia of a cube is the same about all axes.
#[derive(Clone)]
struct Pile {
    shapes: [Shape; 2],
    shape: Vec<u32>,
    roles: Vec<Role>,
    inverse_mass: Vec<f64>,
    inverse_inertia: Vec<f64>,
    pose: Vec<Pose>,
    velocity: Vec<Vec3>,
    spin: Vec<Vec3>,
    gravity: Vec3,
    law: ContactLaw,
    elapsed: f64,
    contacts: Contacts,
    friction: f64,
    damping: f64,
    gained: f64,
}

impl Pile {
    /// A floor that stands still, its top at z = 0, and cubes with these edges and centres.
    fn new(edge: f64, centres: &[Vec3]) -> Self {
        let count = centres.len() + 1;
        let mass = 2500.0 * edge * edge * edge;
        let mut pile = Self {
            shapes: [
                Shape::brick(Vec3::new(10.0, 10.0, 0.5)).unwrap(),
                Shape::brick(Vec3::splat(0.5 * edge)).unwrap(),
            ],
            shape: vec![1; count],
            roles: vec![Role::Seeker; count],
            inverse_mass: vec![1.0 / mass; count],
            inverse_inertia: vec![6.0 / (mass * edge * edge); count],
            pose: [Vec3::new(0.0, 0.0, -0.5)]
                .iter()
                .chain(centres)
                .map(|c| Pose::at(*c))
                .collect(),
            velocity: vec![Vec3::ZERO; count],
            spin: vec![Vec3::ZERO; count],
            gravity: -9.81 * Vec3::Z,
            law: LAW,
            elapsed: 0.0,
            contacts: Contacts::default(),
            friction: 0.0,
            damping: 0.0,
            gained: 0.0,
        };
        pile.shape[0] = 0;
        pile.roles[0] = Role::Target;
        pile.inverse_mass[0] = 0.0;
        pile.inverse_inertia[0] = 0.0;
        pile
    }

    /// Many cubes, not quite in order, turned and thrown.
    fn heap(across: usize, chance: &mut Chance) -> Self {
        let mut centres = Vec::new();
        for k in 0..across * across * across {
            let [x, y, z] = [k % across, k / across % across, k / across / across]
                .map(|n| 0.105 * n as f64 + 0.052);
            centres.push(Vec3::new(x, y, z) + 0.003 * chance.direction());
        }
        let mut pile = Self::new(0.1, &centres);
        for b in 1..pile.pose.len() {
            pile.velocity[b] = 0.5 * chance.direction();
            pile.spin[b] = 3.0 * chance.direction();
        }
        pile
    }

    fn evaluate(&mut self, room: &mut Room, dt: f64, exec: &Exec) -> Outcome {
        let (pose, velocity, spin) = (&self.pose, &self.velocity, &self.spin);
        let (inverse, law) = (&self.inverse_mass, self.law);
        room.evaluate(
            &mut self.contacts,
            &Scene {
                blocks: Blocks {
                    shapes: &self.shapes,
                    shape: &self.shape,
                    roles: &self.roles,
                },
                standing: |b: usize| Standing {
                    pose: pose[b],
                    motion: Motion {
                        velocity: velocity[b],
                        spin: spin[b],
                        inverse_mass: inverse[b],
                    },
                },
                law: |_: u32, _: u32| law,
                excluded: |_: u32, _: u32| false,
                elapsed: self.elapsed,
                coming: dt,
                lookahead: 50.0 * dt,
                exec,
            },
        )
    }

    /// One step; returns the total of the time-centred energy before the kick.
    fn step(&mut self, room: &mut Room, dt: f64, exec: &Exec) -> (Outcome, f64) {
        let outcome = self.evaluate(room, dt, exec);
        self.friction += outcome.friction;
        let before = self.elapsed;
        let mut kinetic = 0.0;
        for b in 0..self.pose.len() {
            if self.inverse_mass[b] == 0.0 {
                continue;
            }
            let on = room.on_block(b);
            let weight = self.gravity / self.inverse_mass[b];
            let span = 0.5 * (before + dt);
            let old = [self.velocity[b], self.spin[b]];
            self.velocity[b] += (on.force + on.drag + weight) * (span * self.inverse_mass[b]);
            self.spin[b] += (on.moment + on.drag_moment) * (span * self.inverse_inertia[b]);
            let new = [self.velocity[b], self.spin[b]];
            // Works of the half steps before and after.
            let centred = [0, 1].map(|k: usize| 0.5 * (before * old[k] + dt * new[k]));
            self.damping -= on.drag.dot(centred[0]) + on.drag_moment.dot(centred[1]);
            self.gained += weight.dot(centred[0]);
            kinetic += 0.5 * old[0].dot(new[0]) / self.inverse_mass[b]
                + 0.5 * old[1].dot(new[1]) / self.inverse_inertia[b];
            self.pose[b].position += dt * new[0];
            let turned = Quat::from_scaled_axis(dt * new[1]) * self.pose[b].rotation;
            self.pose[b].rotation = turned.normalize();
        }
        self.elapsed = dt;
        (outcome, kinetic)
    }

    fn bits(&self) -> Vec<u64> {
        let parts = self.pose.iter().zip(&self.velocity).zip(&self.spin);
        parts
            .flat_map(|((pose, v), w)| {
                let q = pose.rotation.to_array();
                [pose.position, *v, *w]
                    .into_iter()
                    .flat_map(|p| p.to_array())
                    .chain(q)
                    .map(f64::to_bits)
            })
            .collect()
    }
}

#[test]
fn a_heap_is_the_same_bits_for_any_number_of_threads_and_after_a_restart() {
    let start = Pile::heap(9, &mut Chance::new(2));
    let run = |threads: usize, restart: bool| {
        let exec = Exec::new(threads).unwrap();
        let (mut pile, mut room) = (start.clone(), Room::default());
        let (mut renewed, mut touching) = (0, 0);
        for step in 0..60 {
            if restart && step % 7 == 3 {
                room = Room::default();
            }
            let (outcome, _) = pile.step(&mut room, 1e-4, &exec);
            assert_eq!(outcome.trouble, None);
            renewed += usize::from(outcome.renewed);
            touching = touching.max(outcome.touching);
        }
        assert!(renewed > 1 && touching > 200, "{renewed} {touching}");
        (pile.bits(), pile.contacts)
    };
    let plain = run(1, false);
    assert!(plain == run(3, false));
    assert!(plain == run(2, true));
}

#[test]
fn evaluating_twice_changes_nothing() {
    let mut pile = Pile::heap(4, &mut Chance::new(4));
    let (mut room, exec) = (Room::default(), Exec::serial());
    for _ in 0..100 {
        pile.step(&mut room, 1e-4, &exec);
    }
    pile.evaluate(&mut room, 1e-4, &exec);
    pile.elapsed = 0.0;
    let state = pile.contacts.clone();
    let forces: Vec<OnBlock> = (0..pile.pose.len()).map(|b| room.on_block(b)).collect();
    let outcome = pile.evaluate(&mut room, 1e-4, &exec);
    assert_eq!((outcome.friction, pile.contacts.clone()), (0.0, state));
    let again: Vec<OnBlock> = (0..pile.pose.len()).map(|b| room.on_block(b)).collect();
    assert_eq!(forces, again);
    assert!(forces.iter().any(|f| f.force.length() > 1.0));
}

#[test]
fn momenta_are_kept_and_energy_is_accounted_for() {
    let mut chance = Chance::new(6);
    let mut pile = Pile::heap(3, &mut chance);
    // No floor: nothing outside acts.
    pile.roles[0] = Role::Absent;
    pile.gravity = Vec3::ZERO;
    for b in 1..pile.pose.len() {
        pile.velocity[b] -= 2.0 * (pile.pose[b].position - Vec3::splat(0.15));
    }
    let momentum = |pile: &Pile| {
        let mut sums = [Vec3::ZERO; 2];
        for b in 1..pile.pose.len() {
            let p = pile.velocity[b] / pile.inverse_mass[b];
            sums[0] += p;
            sums[1] += pile.pose[b].position.cross(p) + pile.spin[b] / pile.inverse_inertia[b];
        }
        sums
    };
    let before = momentum(&pile);
    let (mut room, exec) = (Room::default(), Exec::serial());
    let (mut total, mut touched, mut stored) = (Vec::new(), 0, 0.0f64);
    for _ in 0..400 {
        let (outcome, kinetic) = pile.step(&mut room, 1e-4, &exec);
        let held: f64 = pile.contacts.stored(|_, _| LAW).iter().sum();
        // Damping of the half step after is not part of this instant.
        total.push((kinetic, held, pile.friction));
        touched = touched.max(outcome.touching);
        stored = stored.max(held);
    }
    let after = momentum(&pile);
    let scale: f64 = (1..pile.pose.len())
        .map(|b| pile.velocity[b].length() / pile.inverse_mass[b])
        .sum();
    assert!((after[0] - before[0]).length() < 1e-12 * scale);
    assert!((after[1] - before[1]).length() < 1e-11 * scale);
    assert!(touched > 10 && stored > 0.1, "{touched} {stored}");
    assert!(pile.friction > 0.0 && pile.damping > 0.0);
    let (first, last) = (total[0], total[total.len() - 1]);
    let lost = first.0 + first.1 - last.0 - last.1;
    let booked = pile.friction + pile.damping;
    assert!((lost - booked).abs() < 2e-3 * lost, "{lost} {booked}");
}

#[test]
fn a_cube_comes_to_rest_on_the_floor_with_its_weight_on_it() {
    let mut pile = Pile::new(0.5, &[Vec3::new(1.0, 2.0, 0.26)]);
    let (mut room, exec) = (Room::default(), Exec::serial());
    let mut asleep = 0;
    for _ in 0..6000 {
        let (outcome, _) = pile.step(&mut room, 1e-4, &exec);
        assert_eq!(outcome.trouble, None);
        asleep += usize::from(outcome.touching == 0);
    }
    assert!(asleep > 300 && asleep < 3000, "{asleep}");
    let weight = 9.81 / pile.inverse_mass[1];
    let on = room.on_block(1);
    assert!((on.force.z + on.drag.z - weight).abs() < 1e-6 * weight);
    assert!((pile.pose[1].position - Vec3::new(1.0, 2.0, 0.25)).length() < 2e-5);
    // What it has fallen is lost in dashpots and a little in friction.
    let gone = pile.friction + pile.damping;
    assert!(
        (gone / pile.gained - 1.0).abs() < 1e-2,
        "{gone} {}",
        pile.gained
    );
}

#[test]
fn too_deep_and_too_fast_are_told() {
    let (mut room, exec) = (Room::default(), Exec::serial());
    let mut deep = Pile::new(0.5, &[Vec3::new(0.0, 0.0, -0.01)]);
    let outcome = deep.evaluate(&mut room, 1e-4, &exec);
    assert!(
        matches!(outcome.trouble, Some(Trouble::TooDeep { pair: [0, 1], depth, .. }) if depth > 0.25),
        "{outcome:?}"
    );
    let (mut room, mut fast) = (Room::default(), Pile::new(0.5, &[Vec3::new(0.0, 0.0, 0.6)]));
    fast.velocity[1] = -300.0 * Vec3::Z;
    let mut troubles = Vec::new();
    for _ in 0..40 {
        troubles.extend(fast.step(&mut room, 1e-4, &exec).0.trouble);
    }
    assert!(
        matches!(troubles.first(), Some(Trouble::TooFast { pair: [0, 1], way, .. }) if (way - 0.03).abs() < 1e-3),
        "{troubles:?}"
    );
}
