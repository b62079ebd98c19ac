//! The distance potential is a potential: forces are its gradient, loops cost nothing, both kernels agree,
//! elastic collisions keep their energy. The source's law is measured beside it.

use crate::common::{
    DISTANCE, Model, Random, SOURCE, block, comb, general, l_shape, law, moved, notched, points,
    quantile, rectangle, setup, u_shape,
};
use riprap::Vec2;
use riprap::planar::setup::NormalLaw;
use riprap::planar::world::Wrench;

/// Two convex polygons pushed a little into each other.
fn overlapping(random: &mut Random) -> (Vec<Vec2>, Vec<Vec2>) {
    let a = random.convex(1.0);
    let direction = random.between(0.0, std::f64::consts::TAU);
    let toward = Vec2::from_angle(direction);
    let b = random.convex(1.0);
    // Moved apart until the extents along the direction overlap by a little.
    let reach = |p: &[Vec2], d: Vec2| p.iter().map(|v| v.dot(d)).fold(f64::MIN, f64::max);
    let gap = reach(&a, toward) + reach(&b, -toward);
    let b = moved(&b, 0.0, (gap - random.between(0.01, 0.05)) * toward);
    (a, b)
}

#[test]
fn both_kernels_agree_on_convex_pairs() {
    let mut random = Random(1);
    let mut touching = 0;
    for _ in 0..300 {
        let (a, b) = overlapping(&mut random);
        let fast = Model::pair(&a, &b, law(DISTANCE, 1e9)).wrench();
        let slow = Model::pair(&a, &b, general(law(DISTANCE, 1e9))).wrench();
        let scale = slow.force.length();
        touching += usize::from(scale > 0.0);
        assert!((fast.force - slow.force).length() <= 1e-11 * scale + 1e-6, "{fast:?} {slow:?}");
        assert!((fast.moment_i - slow.moment_i).abs() <= 1e-11 * scale + 1e-6);
        assert!((fast.moment_j - slow.moment_j).abs() <= 1e-11 * scale + 1e-6);
    }
    assert!(touching > 100, "only {touching} pairs touch");
}

#[test]
fn the_force_is_minus_the_gradient_of_the_energy() {
    let mut random = Random(2);
    let concave = [
        (moved(&l_shape(), 0.3, Vec2::new(0.55, 0.43)), notched()),
        (moved(&comb(), 0.01, Vec2::new(0.0, 0.595)), rectangle(-1.0, -1.0, 2.0, 0.6)),
        (moved(&rectangle(-0.31, 0.0, 0.31, 0.9), 0.02, Vec2::new(0.6, 0.28)), u_shape()),
    ];
    let convex = (0..40).map(|_| overlapping(&mut random));
    for (k, (a, b)) in convex.chain(concave).enumerate() {
        let mut model = Model::pair(&a, &b, law(DISTANCE, 1e9));
        let w = model.wrench();
        let (h, tolerance) = if k < 40 { (2e-7, 1e-6) } else { (1e-6, 1e-5) };
        let x = model.world.bodies[0].position;
        let mut energy = |dx: Vec2, da: f64| {
            model.place(0, x + dx, da);
            model.balance().contact_normal
        };
        let slope = |up: f64, down: f64| -(up - down) / (2.0 * h);
        let fx = slope(energy(Vec2::X * h, 0.0), energy(Vec2::X * -h, 0.0));
        let fy = slope(energy(Vec2::Y * h, 0.0), energy(Vec2::Y * -h, 0.0));
        let m = slope(energy(Vec2::ZERO, h), energy(Vec2::ZERO, -h));
        let scale = w.force.length() + w.moment_i.abs() + 1.0;
        for (found, exact) in [(fx, w.force.x), (fy, w.force.y), (m, w.moment_i)] {
            assert!(
                (found - exact).abs() <= tolerance * scale,
                "case {k}: {found} {exact} of {scale}"
            );
        }
    }
}

/// A line across a square of 10 m that wanders by midpoint displacement: `2^levels` pieces, mm coordinates.
fn trace(random: &mut Random, levels: u32, wiggle: f64) -> Vec<Vec2> {
    let mut line = vec![Vec2::new(0.0, 5.0), Vec2::new(10.0, 5.0)];
    for level in 0..levels {
        let size = wiggle * libm::pow(0.55, f64::from(level));
        let mut finer = vec![line[0]];
        for w in line.windows(2) {
            let off = Vec2::new(0.3 * random.between(-size, size), random.between(-size, size));
            let middle = 0.5 * (w[0] + w[1]) + off;
            finer.extend([(1e3 * middle).round() / 1e3, w[1]]);
        }
        line = finer;
    }
    line
}

/// The blocks above and below a trace, both turned and moved.
fn halves(trace: &[Vec2], angle: f64, shift: Vec2) -> [Vec<Vec2>; 2] {
    let mut upper = trace.to_vec();
    upper.extend(points(&[(10.0, 10.0), (0.0, 10.0)]));
    let mut lower: Vec<Vec2> = trace.iter().rev().copied().collect();
    lower.extend(points(&[(0.0, 0.0), (10.0, 0.0)]));
    [moved(&upper, angle, shift), moved(&lower, angle, shift)]
}

/// Largest fault of the force against the slope of the energy, over the force, of the first block moved by `by`.
fn gradient_fault(model: &mut Model, by: Vec2, step: f64) -> f64 {
    let x = model.world.bodies[0].position + by;
    model.place(0, x, 0.0);
    let w = model.wrench();
    let arm = 3.0;
    let mut slope = |to: Vec2, turn: f64| {
        let mut at = |k: f64| {
            model.place(0, x + k * step * to, k * step * turn);
            model.balance().contact_normal
        };
        -(at(1.0) - at(-1.0)) / (2.0 * step)
    };
    let found = [
        (slope(Vec2::X, 0.0), w.force.x),
        (slope(Vec2::Y, 0.0), w.force.y),
        (slope(Vec2::ZERO, 1.0 / arm), w.moment_i / arm),
    ];
    let scale = w.force.length().max(w.moment_i.abs() / arm);
    found.iter().map(|(a, b)| (a - b).abs() / scale).fold(0.0, f64::max)
}

#[test]
fn outlines_that_coincide_over_many_corners_hold_no_energy_and_keep_the_gradient() {
    let mut random = Random(5);
    for case in 0..24 {
        let line = trace(&mut random, 2 + case % 5, 0.6);
        // As drawn, turned by anything, and far from the origin.
        let angle = if case % 3 == 0 { 0.0 } else { random.between(-3.1, 3.1) };
        let far = if case % 4 == 3 { 3e4 } else { 0.0 };
        let [upper, lower] = halves(&line, angle, Vec2::new(far, -far));
        let mut model = Model::pair(&upper, &lower, law(DISTANCE, 1e9));
        // Round-off of coordinates, m.
        let noise = 4.0 * f64::EPSILON * (10.0 + far);
        let touching = model.balance().contact_normal;
        assert!(touching.abs() <= 1e9 * 20.0 * noise * noise, "case {case}: {touching} J/m");
        for depth in [1e-12, 1e-10, 1e-8, 1e-6, 1e-4, 1e-3] {
            // Of the depth, and well above round-off.
            let share = (20.0 * noise / depth).max(2e-3);
            if share > 0.2 {
                continue;
            }
            // Mostly into the face, so that all of the trace is pressed, or any way.
            let lean = random.between(-1.4, 1.4);
            let by = depth * crate::common::turned(Vec2::new(0.0, -1.0), angle + lean);
            let origin = model.world.bodies[0].position;
            let fault = gradient_fault(&mut model, by, share * depth);
            model.place(0, origin, 0.0);
            // Sides that begin to touch within the step, and round-off of the places over it.
            let most = 0.25 * share + 0.5 * noise / (share * depth);
            assert!(fault <= most, "case {case}, {depth} m: {fault}, {most} allowed");
        }
    }
}

#[test]
fn a_trace_pressed_together_has_the_energy_of_its_sides() {
    let mut random = Random(6);
    for case in 0..12 {
        let line = trace(&mut random, 3 + case % 4, 0.3);
        let depth = 1e-7;
        let [upper, lower] = halves(&line, 0.0, Vec2::ZERO);
        let upper = moved(&upper, 0.0, Vec2::new(0.0, -depth));
        let model = Model::pair(&upper, &lower, law(DISTANCE, 1e9));
        // A side as long as `l` that leans by `a` is a strip `depth cos a` thick: `kn/2 l t²`.
        let strips = line.windows(2).map(|w| {
            let d = w[1] - w[0];
            0.5e9 * (depth * d.x) * (depth * d.x) / d.length()
        });
        let (exact, found) = (strips.sum::<f64>(), model.balance().contact_normal);
        assert!((found / exact - 1.0).abs() < 1e-4, "case {case}: {found}, {exact}");
    }
}

#[test]
fn a_block_in_a_reflex_corner_holds_no_energy_without_overlap() {
    let mut random = Random(3);
    for case in 0..300 {
        // The base has its reflex corner at the origin; the block has corners on both of its sides or leans
        // away from the wall's top.
        let base =
            points(&[(-7.0, -1.0), (2.0, -1.0), (2.0, 4.0), (0.0, 4.0), (0.0, 0.0), (-7.0, 0.0)]);
        let (w, h) = (random.between(0.5, 3.0), random.between(0.5, 3.0));
        let (u, v) = (random.between(0.2, 0.8), random.between(0.2, 0.8));
        let block = if case % 2 == 0 {
            points(&[(-w, 0.0), (-u * w, 0.0), (0.0, 0.0), (0.0, v * h), (0.0, h), (-w, h)])
        } else {
            points(&[(-w, 0.0), (0.0, 0.0), (0.0, h), (-1.2 * w, 1.1 * h)])
        };
        let far = libm::pow(10.0, random.between(0.0, 4.0));
        let shift = Vec2::new(random.between(-5.0, 5.0) * far, random.between(-500.0, 500.0));
        let angle = random.between(-3.1, 3.1);
        let (base, block) = (moved(&base, angle, shift), moved(&block, angle, shift));
        let noise = 4.0 * f64::EPSILON * (10.0 + shift.length());
        for normal in [DISTANCE, SOURCE] {
            for (a, b) in [(&base, &block), (&block, &base)] {
                let energy = Model::pair(a, b, law(normal, 1e9)).balance().contact_normal;
                let most = 1e9 * 20.0 * noise * noise;
                assert!(energy.abs() <= most, "case {case}, {normal:?}: {energy}, {most} allowed");
            }
        }
    }
}

/// Work of the pair's force on the first block around a loop in (x, y, angle), over the sum of |dW|.
fn loop_work(a: &[Vec2], b: &[Vec2], normal: NormalLaw) -> f64 {
    let mut model = Model::pair(a, b, law(normal, 1e9));
    let start = model.world.bodies[0].position;
    let steps = 4000;
    let pose = |k: usize| {
        let t = std::f64::consts::TAU * k as f64 / steps as f64;
        (start + 0.01 * Vec2::new(t.sin(), 1.0 - t.cos()), 0.02 * (2.0 * t).sin())
    };
    let (mut work, mut all) = (0.0, 0.0);
    let mut last: Option<(Vec2, f64, Wrench)> = None;

    for k in 0..=steps {
        let (x, angle) = pose(k);
        model.place(0, x, angle);
        let w = model.wrench();
        if let Some((x0, a0, w0)) = last {
            let mean = w0.plus(&w).times(0.5);
            let part = mean.force.dot(x - x0) + mean.moment_i * (angle - a0);
            work += part;
            all += part.abs();
        }
        last = Some((x, angle, w));
    }
    if all > 0.0 { work.abs() / all } else { 0.0 }
}

#[test]
fn closed_loops_cost_nothing() {
    let mut random = Random(3);
    let (mut distance, mut source) = (Vec::new(), Vec::new());
    for _ in 0..60 {
        let (a, b) = overlapping(&mut random);
        distance.push(loop_work(&a, &b, DISTANCE));
        source.push(loop_work(&a, &b, SOURCE));
    }
    eprintln!(
        "loops: distance median {:.1e} max {:.1e}; source median {:.1e} max {:.1e}",
        quantile(&distance, 0.5),
        quantile(&distance, 1.0),
        quantile(&source, 0.5),
        quantile(&source, 1.0)
    );
    // The trapezoidal rule over a closed loop is very good for smooth integrands; the kinks where an
    // edge comes into or out of the overlap leave what is seen here.
    assert!(quantile(&distance, 0.5) < 1e-7 && quantile(&distance, 1.0) < 1e-5);
    assert!(quantile(&source, 0.5) > 1e-3, "the source's law is not expected to be conservative");
}

/// Relative change of kinetic energy in elastic collisions of random pairs.
fn collisions(normal: NormalLaw, stiffness: f64, dt: f64, count: usize) -> Vec<f64> {
    let mut random = Random(11);
    (0..count)
        .map(|_| {
            let a = random.convex(0.8);
            let b = moved(&random.convex(0.8), 0.0, Vec2::new(0.86, random.between(-0.2, 0.2)));
            let mut setup = setup(vec![block(&a), block(&b)], law(normal, stiffness));
            setup.blocks[0].velocity = Vec2::new(1.0, 0.0);
            setup.blocks[1].velocity = Vec2::new(-1.0, 0.0);
            setup.blocks[0].spin = random.between(-1.0, 1.0);
            setup.blocks[1].spin = random.between(-1.0, 1.0);
            let mut model = Model::new(setup);
            model.evaluate(dt);
            let (before, p0) = (model.balance().kinetic, model.momentum());
            let l0 = model.view().angular_momentum();
            // Until apart again, at most half a second.
            let mut touched = false;
            for k in 0..(0.5 / dt) as usize {
                model.step(dt);
                if k % 64 == 0 {
                    let touching = model.world.pairs.iter().any(|p| p.contact.touches())
                        || model.world.general.iter().any(|g| !g.regions.is_empty());
                    if touched && !touching && k as f64 * dt > 0.2 {
                        break;
                    }
                    touched |= touching;
                }
            }
            model.evaluate(dt);
            let momentum = (model.momentum() - p0).length();
            assert!(momentum < 1e-9, "momentum drifts by {momentum}");
            let turn = (model.view().angular_momentum() - l0).abs();
            assert!(turn < 1e-7 * (1.0 + l0.abs()), "angular momentum drifts by {turn}");
            (model.balance().total() / before - 1.0).abs()
        })
        .collect()
}

#[test]
fn elastic_collisions_keep_their_energy() {
    let distance = collisions(DISTANCE, 2e9, 1e-5, 120);
    let source = collisions(SOURCE, 1e9, 4e-5, 120);
    for (name, list) in [("distance", &distance), ("source", &source)] {
        eprintln!(
            "collisions, {name}: median {:.1e}, 95 % {:.1e}, max {:.1e}",
            quantile(list, 0.5),
            quantile(list, 0.95),
            quantile(list, 1.0)
        );
    }
    assert!(quantile(&distance, 0.5) < 1e-8 && quantile(&distance, 1.0) < 1e-5);
    assert!(quantile(&source, 0.5) > 1e-5);
}
