//! Times the step of a settled running-bond wall: `wall BLOCKS THREADS STEPS`.

use riprap::Vec2;
use riprap::exec::Exec;
use riprap::planar::fields::View;
use riprap::planar::setup::{
    BlockSpec, ContactLaw, FrictionLaw, Interface, Motion, NormalLaw, Setup, Support,
};
use riprap::planar::step::{Damping, advance, evaluate};
use riprap::planar::world::World;

fn main() {
    let mut args = std::env::args()
        .skip(1)
        .filter_map(|a| a.parse::<usize>().ok());
    let blocks = args.next().unwrap_or(10_000);
    let threads = args.next().unwrap_or(1);
    let steps = args.next().unwrap_or(200);
    let rows = (blocks as f64 / 2.0).sqrt().round() as usize;
    let per_row = blocks / rows;
    let rect = |x0: f64, y0: f64, x1: f64, y1: f64| {
        vec![
            Vec2::new(x0, y0),
            Vec2::new(x1, y0),
            Vec2::new(x1, y1),
            Vec2::new(x0, y1),
        ]
    };
    let mut list = vec![rect(-5.0, -1.0, per_row as f64 + 5.0, 0.0)];
    let mut sunk = 0.0;
    for r in 0..rows {
        sunk += (rows - r) as f64 * 2600.0 * 0.5 * 9.81 / 1e10;
        for c in 0..per_row {
            let x = c as f64 + 0.5 * (r % 2) as f64;
            // Static overlap: the courses above rest on two half edges.
            let y = 0.5 * r as f64 - sunk;
            list.push(rect(x, y, x + 1.0, y + 0.5));
        }
    }
    let setup = Setup {
        gravity: [0.0, -9.81],
        materials: vec!["rock".into()],
        blocks: list
            .into_iter()
            .enumerate()
            .map(|(k, vertices)| BlockSpec {
                name: k.to_string(),
                vertices,
                material: 0,
                density: 2600.0,
                velocity: Vec2::ZERO,
                spin: 0.0,
            })
            .collect(),
        interfaces: vec![Interface {
            name: "default".into(),
            contact: ContactLaw {
                normal: NormalLaw::DistancePotential,
                normal_stiffness: 1e10,
                shear_stiffness: 5e9,
                friction: 0.6,
                cohesion: 0.0,
                friction_law: FrictionLaw::ShearSpring,
                damping_ratio: 0.2,
            },
            bond: None,
        }],
        pair_table: vec![0],
        supports: vec![Support {
            blocks: vec![0],
            motion: Motion::Fixed {
                x: true,
                y: true,
                rotation: true,
            },
        }],
        ..Setup::default()
    };
    let (mut world, mut scratch) = World::new(setup, Exec::new(threads).expect("threads"));
    let damping = Damping {
        local: 0.7,
        ..Damping::default()
    };
    let dt = 2e-5;
    for _ in 0..300 {
        evaluate(&mut world, &mut scratch, &damping, dt).expect("finite");
        advance(&mut world, &mut scratch, dt);
    }
    evaluate(&mut world, &mut scratch, &damping, dt).expect("finite");
    let view = View {
        world: &world,
        scratch: &scratch,
    };
    let contacts = view.contacts().count();
    let candidates = scratch.candidates.convex.len() + scratch.candidates.general.len();
    let before = scratch.profile.seconds();
    let cpu = cpu_seconds();
    let start = std::time::Instant::now();
    for _ in 0..steps {
        evaluate(&mut world, &mut scratch, &damping, dt).expect("finite");
        advance(&mut world, &mut scratch, dt);
    }
    let seconds = start.elapsed().as_secs_f64();
    let cpu = cpu_seconds() - cpu;
    let rate = contacts as f64 * steps as f64 / cpu;
    println!(
        "{} blocks {contacts} contacts {candidates} candidates {threads} threads: {:.3} ms/step wall, {:.3} cpu, {:.2} M contacts/s, {:.0} ns/block-step, rebuilds {}",
        world.bodies.len(),
        1e3 * seconds / steps as f64,
        1e3 * cpu / steps as f64,
        1e-6 * rate,
        1e9 * cpu / steps as f64 / world.bodies.len() as f64,
        scratch.rebuilds,
    );
    for ((name, b), (_, a)) in before.iter().zip(scratch.profile.seconds()) {
        println!("  {name:10} {:.1} %", 100.0 * (a - b) / seconds);
    }
}

/// Processor time of this process, s.
fn cpu_seconds() -> f64 {
    let text = std::fs::read_to_string("/proc/self/schedstat").unwrap_or_default();
    text.split_whitespace()
        .next()
        .and_then(|x| x.parse::<f64>().ok())
        .unwrap_or(0.0)
        * 1e-9
}
