//! Closed forms.

use super::*;
use crate::laws::explosive::{Adiabat, Explosive, TwoStage};
use crate::laws::jwl::Jwl;

fn near(a: f64, b: f64, tolerance: f64) {
    assert!((a / b - 1.0).abs() <= tolerance, "{a} {b} {:e}", a / b - 1.0);
}

/// `p = p0 (rho/rho0)^g` at all densities.
fn power(p0: f64, rho0: f64, gamma: f64) -> Fluid {
    let adiabat =
        TwoStage { p0, v0: 1.0 / rho0, pk: 0.0, vk: f64::INFINITY, gamma, gamma_low: 1.4 };
    Fluid { adiabat: Adiabat::TwoStage(adiabat), mass: 1.0 }
}

/// A slot of length 1 m and width 1 m in `n` cells between a large tank and the air: cell `n` is the tank.
struct Slot {
    network: Network,
    volumes: Vec<f64>,
    apertures: Vec<f64>,
    masses: Vec<f64>,
    fluxes: Vec<f64>,
}

fn slot(n: u32, w: f64, tank: f64) -> Slot {
    let path = 0.5 / f64::from(n);
    let port = |cell| Port { cell, length: 1.0, path };
    let mut network = Network { cells: n + 1, ..Network::default() };
    network.first.push(0);
    for j in 0..=n {
        network.ends.push(match j {
            0 => End::Cell(n),
            j if j == n => End::Air,
            _ => End::Inside,
        });
        network.ports.extend((j > 0).then(|| port(j - 1)));
        network.ports.extend((j < n).then(|| port(j)));
        network.first.push(network.ports.len() as u32);
    }
    let mut volumes = vec![w / f64::from(n); n as usize];
    volumes.push(tank);
    let [apertures, masses] = [w, 0.0].map(|x| vec![x; n as usize + 1]);
    Slot::new(network, volumes, apertures, masses)
}

impl Slot {
    fn new(network: Network, volumes: Vec<f64>, apertures: Vec<f64>, masses: Vec<f64>) -> Self {
        let fluxes = vec![0.0; network.ports.len()];
        Self { network, volumes, apertures, masses, fluxes }
    }

    fn advance(&mut self, fluid: &Fluid, friction: &Friction, air: f64, dt: f64) -> Flowed {
        self.advance_on(&Exec::serial(), fluid, (friction, air), dt)
    }

    fn advance_on(&mut self, exec: &Exec, fluid: &Fluid, how: (&Friction, f64), dt: f64) -> Flowed {
        let mut cells = Cells {
            volumes: &self.volumes,
            apertures: &self.apertures,
            masses: &mut self.masses,
            fluxes: &mut self.fluxes,
        };
        let mut desk = Desk::default();
        self.network.advance(fluid, how, &mut cells, dt, (exec, &mut desk)).unwrap()
    }

    /// Steady rate through the slot, kg/s, from a tank at `inlet` (Pa), and the pressure at half way.
    fn steady(
        &mut self,
        fluid: &Fluid,
        friction: &Friction,
        [inlet, outlet]: [f64; 2],
        dt: f64,
    ) -> [f64; 2] {
        let n = self.masses.len() - 1;
        self.masses[n] = self.volumes[n] * fluid.density(inlet);
        let mut flowed = Flowed::default();
        for step in 0..60 {
            // By and by, so that the front passes a few cells in a step.
            let dt = if step < 40 { dt * 0.7_f64.powi(40 - step) } else { dt };
            flowed = self.advance(fluid, friction, outlet, dt);
        }
        let at = |c: usize| fluid.potential(self.masses[c] / self.volumes[c]);
        // Psi is linear along a slot.
        let middle = 0.5 * (at(n / 2 - 1) + at(n / 2));
        let (mut low, mut high) = (0.0, fluid.density(inlet));
        for _ in 0..200 {
            let density = 0.5 * (low + high);
            if fluid.potential(density) < middle { low = density } else { high = density }
        }
        [flowed.vented / dt, fluid.pressure(low)]
    }
}

const RT: f64 = 86_100.0;
const GAS: Friction = Friction { viscosity: 2e-5, roughness: 0.0, inertia: false };
const ROUGH_WALLS: Friction = Friction { roughness: 1e-4, ..GAS };

#[test]
fn laminar_isothermal_gas() {
    let fluid = power(1e7, 1e7 / RT, 1.0);
    // M = w^3/(24 mu RT) (p1^2 - p2^2)/L.
    for n in [4, 40] {
        let [rate, middle] = slot(n, 1e-3, 1e7).steady(&fluid, &GAS, [1e7, 1e5], 1e-3);
        // One step of Newton's method after 0.2 % of the flow leaves one or two millionths.
        near(rate, 2419.425, 2e-6);
        near(middle, 7.071_421e6, 1e-6);
    }
}

#[test]
fn gas_of_a_stiff_adiabat() {
    let fluid = power(1e8, 1000.0, 3.0);
    let [rate, middle] = slot(4, 1e-3, 1e7).steady(&fluid, &GAS, [1e8, 1e7], 1e-3);
    near(rate, 297_995.0, 5e-6);
    near(middle, 61.518_501e6, 2e-6);
}

#[test]
fn fast_gas_between_rough_walls() {
    let fluid = power(1e7, 1e7 / RT, 1.0);
    // The cap at the velocity of sound is off where it is not reached: p_e of the choked outlet is 1.25 MPa.
    let [rate, _] = slot(4, 1e-3, 1e7).steady(&fluid, &ROUGH_WALLS, [1e7, 2e6], 1.0);
    let [a, b] = ROUGH_WALLS.at(1e-3);
    let gradient = 0.5 * (1e14 - 4e12) / RT;
    near(rate, 1e-3 * 2.0 * gradient / (a + (a * a + 4.0 * b * gradient).sqrt()), 1e-6);
    // Choked: of first order in the length of the last cell.
    for (n, tolerance) in [(10, 0.01), (80, 0.004)] {
        let [rate, middle] = slot(n, 1e-3, 1e7).steady(&fluid, &ROUGH_WALLS, [1e7, 1e5], 1.0);
        near(rate, 4.248_106, tolerance);
        near(middle, 7.125_791e6, tolerance);
    }
}

#[test]
fn a_tank_blows_down() {
    let fluid = power(1e7, 1e7 / RT, 1.0);
    // A slot 0.1 m wide, whose volume counts for a thousandth.
    let mut slot = slot(20, 1e-3, 0.01);
    slot.network.ports.iter_mut().for_each(|p| p.length = 0.1);
    slot.volumes.iter_mut().take(20).for_each(|v| *v = 1e-4 / 20.0 * 1e-3);
    slot.masses[20] = 0.01 * 1e7 / RT;
    for _ in 0..1000 {
        slot.advance(&fluid, &GAS, 0.0, 1e-6);
    }
    near(fluid.pressure(slot.masses[20] / 0.01), 8.275_862e6, 1e-3);
}

/// 3 joints each way between heads 1 and 0: conductance 3/4 of a patch; with the middle right one closed 182/281.
#[test]
fn a_lattice_of_joints_has_its_conductance() {
    let fluid = power(1e8, 1000.0, 3.0);
    for (closed, conductance) in [(false, 0.75), (true, 182.0 / 281.0)] {
        // Nine crossings, twelve joints between them (six each way), three that come in and three that go out.
        let at = |x: u32, y: u32| 3 * y + x;
        let mut joints: Vec<[Option<u32>; 2]> = Vec::new();
        for y in 0..3 {
            joints.push([None, Some(at(0, y))]);
            joints.push([Some(at(0, y)), Some(at(1, y))]);
            joints.push([Some(at(1, y)), Some(at(2, y))]);
            joints.push([Some(at(2, y)), None]);
        }
        for x in 0..3 {
            joints.push([Some(at(x, 0)), Some(at(x, 1))]);
            joints.push([Some(at(x, 1)), Some(at(x, 2))]);
        }
        let n = joints.len() as u32;
        let mut network = Network { cells: n + 1, first: vec![0], ..Network::default() };
        // Junction 9 is the tank, 10 the air.
        for j in 0..11 {
            network.ends.push(match j {
                9 => End::Cell(n),
                10 => End::Air,
                _ => End::Inside,
            });
            for (cell, ends) in (0..).zip(&joints) {
                let here = [ends[0].unwrap_or(9), ends[1].unwrap_or(10)];
                network.ports.extend(here.contains(&j).then_some(Port {
                    cell,
                    length: 1.0,
                    path: 0.5,
                }));
            }
            network.first.push(network.ports.len() as u32);
        }
        let mut volumes = vec![1e-3; n as usize];
        volumes.push(1e7);
        let mut apertures = vec![1e-3; n as usize + 1];
        if closed {
            // The middle one of those that go out.
            apertures[7] = 0.0;
        }
        let mut masses = vec![0.0; n as usize + 1];
        masses[n as usize] = 1e7 * fluid.density(1e8);
        let mut slot = Slot::new(network, volumes, apertures, masses);
        let [rate, _] = slot.steady(&fluid, &GAS, [1e8, 0.0], 1e-3);
        let patch = 1e-9 / (12.0 * GAS.viscosity) * fluid.potential(1000.0);
        near(rate, conductance * patch, 5e-6);
    }
}

fn charges() -> [Fluid; 2] {
    let explosive = Explosive {
        density: 1000.0,
        detonation_velocity: 4000.0,
        heat: 4.18e6,
        gamma: 3.0,
        gamma_low: 4.0 / 3.0,
    };
    let two = Adiabat::TwoStage(explosive.adiabat(2.0).unwrap());
    let jwl = Adiabat::Jwl(Jwl::ANFO.isentrope(2.0 / Jwl::ANFO.density));
    [two, jwl].map(|adiabat| Fluid { adiabat, mass: 2.0 })
}

#[test]
fn the_potential_is_the_integral_of_the_density_over_the_pressure() {
    for fluid in charges() {
        for density in [1.0, 300.0, 900.0] {
            let step = 1e-5 * density;
            let [low, high] = [density - step, density + step];
            let slope = (fluid.potential(high) - fluid.potential(low)) / (2.0 * step);
            near(fluid.bulk(density), slope, 1e-6);
            let pressure = (fluid.pressure(high) - fluid.pressure(low)) / (2.0 * step);
            near(fluid.bulk(density), density * pressure, 1e-6);
            let energy = (fluid.energy(high) - fluid.energy(low)) / (2.0 * step);
            near(energy, fluid.pressure(density) / (density * density), 1e-6);
            near(fluid.density(fluid.pressure(density)), density, 1e-12);
        }
    }
}

/// A nozzle of a gas with a constant exponent, choked and not.
#[test]
fn gas_leaves_through_a_nozzle_at_the_velocity_of_sound() {
    let [fluid, _] = charges();
    // On the second stage of the adiabat.
    let (g, density) = (4.0 / 3.0, 10.0);
    let pressure = fluid.pressure(density);
    let sound = density * (g * pressure / density).sqrt();
    let choked = sound * libm::pow(2.0 / (g + 1.0), (g + 1.0) / (2.0 * (g - 1.0)));
    near(fluid.nozzle(density, 0.0), choked, 1e-9);
    near(fluid.nozzle(density, 0.1 * pressure), choked, 1e-9);
    let ratio: f64 = 0.9;
    let slow = 2.0 / (g - 1.0) * (1.0 - libm::pow(ratio, (g - 1.0) / g));
    let slow = sound * libm::pow(ratio, 1.0 / g) * slow.sqrt();
    near(fluid.nozzle(density, ratio * pressure), slow, 1e-9);
    assert_eq!(fluid.nozzle(density, 1.1 * pressure), 0.0);
}

/// A charge fills rigid cracks that lead nowhere: it ends on its adiabat, with all of its mass, and the energy is that of the friction.
#[test]
fn closed_cracks_keep_mass_and_adiabat() {
    for fluid in charges() {
        for dt in [1e-6, 1e-5, 1e-4] {
            let mut slot = slot(12, 5e-4, 3e-3);
            // Closed at its end.
            *slot.network.ends.last_mut().unwrap() = End::Inside;
            slot.masses[12] = 2.0;
            let volume: f64 = slot.volumes.iter().sum();
            let energy = |slot: &Slot| {
                let cells = slot.masses.iter().zip(&slot.volumes);
                cells.map(|(m, v)| m * fluid.energy(m / v)).sum::<f64>()
            };
            let start = energy(&slot);
            let mut lost = Flowed::default();
            // By and by into steps in which all becomes even.
            for step in 0..60 {
                let dt = dt * 1.3_f64.powi(step);
                let flowed = slot.advance(&fluid, &ROUGH_WALLS, 0.0, dt);
                assert!(flowed.numerical >= -1e-9 * start && flowed.friction >= -1e-9 * start);
                lost.friction += flowed.friction;
                lost.numerical += flowed.numerical;
            }
            assert!((slot.masses.iter().sum::<f64>() / 2.0 - 1.0).abs() < 1e-14);
            let pressure = fluid.adiabat.pressure(volume);
            for (m, v) in slot.masses.iter().zip(&slot.volumes) {
                near(fluid.pressure(m / v), pressure, 5e-8);
            }
            near(start, energy(&slot) + lost.friction + lost.numerical, 1e-12);
        }
    }
}

/// What backward Euler loses beside the friction is of first order in the step.
#[test]
fn what_the_integration_loses_goes_with_the_step() {
    let [fluid, _] = charges();
    let run = |steps: i32| {
        let mut slot = slot(8, 5e-4, 3e-3);
        slot.masses[8] = 2.0;
        let mut lost = 0.0;
        for _ in 0..steps {
            lost += slot.advance(&fluid, &ROUGH_WALLS, 1e5, 1e-3 / f64::from(steps)).numerical;
        }
        lost
    };
    let [coarse, fine] = [200, 400].map(run);
    assert!((1.7..2.3).contains(&(coarse / fine)), "{coarse} {fine}");
}

/// Two tanks and the gas in a slot between them swing as Helmholtz says: `w² = c² A/L (1/V1 + 1/V2)`.
#[test]
fn gas_with_inertia_swings_between_two_tanks() {
    let fluid = power(1e7, 1e7 / RT, 1.0);
    let (n, w, tank) = (10_u32, 1e-2, 1.0);
    let mut slot = slot(n, w, tank);
    // The other end leads into a tank of its own.
    *slot.network.ends.last_mut().unwrap() = End::Cell(n + 1);
    slot.network.cells += 1;
    slot.volumes.push(tank);
    slot.apertures.push(w);
    slot.masses.push(0.0);
    let density = fluid.density(1e7);
    for (m, v) in slot.masses.iter_mut().zip(&slot.volumes) {
        *m = v * density;
    }
    slot.masses[n as usize] *= 1.001;
    slot.masses[n as usize + 1] *= 0.999;
    // With half of the slot at each end of the way.
    let period = 2.0 * std::f64::consts::PI / (RT * w * 2.0 / (tank + 0.5 * w)).sqrt();
    let steps = 2000;
    let friction = Friction { viscosity: 1e-12, inertia: true, ..GAS };
    let mut crossed = Vec::new();
    let mut last = 1.0;
    for step in 1..=2 * steps {
        slot.advance(&fluid, &friction, 0.0, period / f64::from(steps));
        let now = slot.masses[n as usize] - slot.masses[n as usize + 1];
        if now * last < 0.0 {
            crossed.push(f64::from(step));
        }
        last = now;
    }
    assert_eq!(crossed.len(), 4);
    near(crossed[3] - crossed[1], f64::from(steps), 0.005);
}

#[test]
fn threads_leave_every_bit() {
    let [fluid, _] = charges();
    let friction = Friction { inertia: true, ..ROUGH_WALLS };
    let run = |threads| {
        let exec = Exec::new(threads).unwrap();
        // More junctions than one thread takes at once.
        let mut slot = slot(1500, 5e-4, 3e-3);
        slot.masses[1500] = 2.0;
        for c in 0..1500 {
            slot.masses[c] = slot.volumes[c] * (1 + c % 7) as f64;
        }
        for _ in 0..4 {
            slot.advance_on(&exec, &fluid, (&friction, 1e5), 2e-5);
        }
        let all = slot.masses.iter().chain(&slot.fluxes);
        all.map(|x| x.to_bits()).collect::<Vec<_>>()
    };
    assert_eq!(run(1), run(2));
    assert_eq!(run(1), run(3));
}

/// Random networks: no mass is made, nothing is below nothing, and every step is found.
#[test]
fn random_networks_keep_their_mass() {
    for inertia in [false, true] {
        random_networks(Friction { inertia, ..ROUGH_WALLS });
    }
}

fn random_networks(friction: Friction) {
    let [fluid, _] = charges();
    let mut state = 12345_u64;
    let mut random = move || {
        state =
            state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1_u64 << 53) as f64
    };
    for _ in 0..6 {
        let (n, junctions) = (30_u32, 25);
        let mut network = Network { cells: n + 1, first: vec![0], ..Network::default() };
        for j in 0..junctions {
            network.ends.push(if j < 3 { End::Cell(n) } else { End::Inside });
            for _ in 0..4 {
                let cell = (random() * f64::from(n)) as u32;
                network.ports.push(Port { cell, length: 0.1, path: 0.05 });
            }
            network.first.push(network.ports.len() as u32);
        }
        let apertures: Vec<f64> = (0..=n).map(|_| libm::pow(10.0, -4.5 + 2.0 * random())).collect();
        let mut volumes: Vec<f64> = apertures.iter().map(|w| 0.01 * w).collect();
        volumes[n as usize] = 2.5e-3;
        let mut masses = vec![0.0; n as usize + 1];
        masses[n as usize] = 2.0;
        let mut slot = Slot::new(network, volumes, apertures, masses);
        for dt in [1e-7, 1e-6, 1e-5, 1e-5, 1e-4, 1e-3] {
            for _ in 0..5 {
                slot.advance(&fluid, &friction, 0.0, dt);
                assert!(slot.masses.iter().all(|m| *m >= 0.0));
            }
        }
        near(slot.masses.iter().sum::<f64>(), 2.0, 1e-13);
    }
}
