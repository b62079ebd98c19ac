//! Without friction: a brick down a slope, bricks whose sides pass each other as they collide, a corner that strikes at an angle.

use super::*;

/// `g sin(slope)` at once and for ever, nothing across, no turning; the note has 4e-13 from it.
#[test]
fn brick_on_a_smooth_slope() {
    for azimuth in [0.0_f64, 0.7] {
        let mut block = Free::brick(Vec3::new(1.0, 0.8, 0.5), 2500.0);
        block.pose.rotation = Quat::from_rotation_z(0.3);
        let floor = Free::fixed(Vec3::new(8.0, 8.0, 1.0));
        let mut two = Two::new([floor, block], law(1e10, 0.0, 0.2));
        let (s, c) = libm::sincos(30_f64.to_radians());
        let down = Vec3::new(libm::cos(azimuth), libm::sin(azimuth), 0.0);
        two.gravity = 10.0 * (s * down - c * Vec3::Z);
        two.blocks[1].pose.position.z = 0.75 - 2500.0 * 0.5 * 10.0 * c / 1e10;
        let (dt, steps) = (1e-4, 3000);
        for n in 0..steps {
            two.step(dt, n == 0);
        }
        let block = &two.blocks[1];
        // Velocities are those of half a step before the end: the first kick was half a step.
        let acceleration = block.velocity / (dt * (f64::from(steps) - 0.5));
        println!("{:e}", acceleration.dot(down) / (10.0 * s) - 1.0);
        assert!((acceleration.dot(down) / (10.0 * s) - 1.0).abs() < 1e-12);
        assert!(acceleration.dot(Vec3::Z.cross(down)).abs() < 1e-12);
        assert!(block.spin().length() < 1e-12, "{}", block.spin());
    }
}

/// Two bricks of 1 x 0.7 x 0.5 m that meet face to face at 1 m/s and pass each other at `sideways` (m/s) so that their sides are in one
/// plane when they lie deepest; change of the energy over that of the way across.
fn pass(sideways: f64, dt: f64) -> f64 {
    let size = Vec3::new(1.0, 0.7, 0.5);
    let mut pair = [(); 2].map(|()| Free::brick(size, 2500.0));
    let gap = 1e-3;
    // Half a swing of the reduced mass on kn A.
    let swing = std::f64::consts::PI * (0.5 * pair[0].mass / (1e10 * 0.7)).sqrt();
    let before = sideways * (gap + 0.5 * swing);
    for (block, sign) in pair.iter_mut().zip([-0.5, 0.5]) {
        block.pose.position = Vec3::new(-sign * before, 0.0, sign * (0.5 + gap));
        block.velocity = Vec3::new(sign * sideways, 0.0, -sign);
    }
    let mut two = Two::new(pair, law(1e10, 0.0, 0.0));
    let energy = two.energy();
    two.collide(dt);
    let [a, b] = &two.blocks;
    // They have passed.
    assert!(sideways == 0.0 || a.pose.position.x < b.pose.position.x);
    let across = 0.5 * 0.5 * a.mass;
    (two.energy() - energy).abs() / across
}

/// In steps of dt a block enters the stiffness kn A in the middle of a step and leaves it in that of another: its speed is kept to
/// `cos(p)/cos(q)` with phases p and q of up to half a step, `w dt/2` with `w² = kn A/m`, its energy to `(w dt)²/4`: 6e-5, 2e-5, 4e-6, of
/// which the note had met 3e-5, 5e-6, 2e-6. Sides that pass add no more: the force aside changes from `-kn b d²/2` to `kn b d²/2`
/// within a step, in which the bricks move by v dt.
#[test]
fn sides_that_pass_each_other_keep_the_energy() {
    for dt in [4e-6_f64, 2e-6, 1e-6] {
        let straight = pass(0.0, dt);
        let bound = (4000.0 * dt) * (4000.0 * dt) / 4.0;
        for sideways in [0.05, 0.5] {
            let passing = pass(sideways, dt);
            let depth = 1.0 / 4000.0;
            let jump = 1e10 * 0.7 * depth * depth * sideways * dt / 218.75;
            println!(
                "{sideways} m/s, {dt:e} s: {passing:.2e}, straight {straight:.2e}, jump {jump:.1e}, bound {bound:.1e}"
            );
            assert!(passing < bound + jump, "{passing:e}");
            assert!((passing - straight).abs() < jump, "{passing:e} {straight:e}");
        }
    }
}

/// A box on its corner, 2.5 m/s down: `J = 2 v/(1/m + (r x n) . I^-1 (r x n))` if it did not turn in the contact. It turns by the time that
/// takes, which is the depth over v: J is too large by a series in `kn^(-1/4)`, and its limit is that of the rigid blow.
#[test]
fn corner_that_strikes_at_an_angle() {
    let speed = 2.5;
    let turn = Quat::from_rotation_z(25_f64.to_radians())
        * Quat::from_rotation_y(-15_f64.to_radians())
        * Quat::from_rotation_x(35_f64.to_radians());
    let thrown = || {
        let mut block = Free::brick(Vec3::new(0.8, 0.6, 1.1), 2600.0);
        block.pose.rotation = turn;
        block.velocity = -speed * Vec3::Z;
        block
    };
    let block = thrown();
    let corners = block.shape.vertices.iter().map(|v| turn * *v);
    let lowest = corners.min_by(|a, b| a.z.total_cmp(&b.z)).unwrap();
    let arm = lowest.cross(Vec3::Z);
    let turns = turn * (block.inertia.inverse() * (turn.inverse() * arm));
    let blow = 2.0 * speed / (1.0 / block.mass + arm.dot(turns));
    // The numbers of the note.
    assert!((blow - 4637.530).abs() < 5e-4, "{blow}");
    assert!((blow / block.mass - speed - 0.878_154).abs() < 5e-7);
    assert!((blow * turns - Vec3::new(-0.605_477, 6.860_154, -2.053_563)).length() < 1e-6);
    let stiffnesses: [f64; 4] = [1e10, 1e11, 1e12, 1e13];
    // Of the blow and of the spin after it.
    let errors = stiffnesses.map(|stiffness| {
        let mut block = thrown();
        block.pose.position.z = 0.5 - lowest.z + 1e-6;
        let floor = Free::fixed(Vec3::new(4.0, 4.0, 1.0));
        let mut two = Two::new([floor, block], law(stiffness, 0.0, 0.0));
        let before = two.energy();
        // The contact lasts some 0.02 s at 1e10 Pa/m.
        two.collide(1e-5 * libm::pow(1e10 / stiffness, 0.25));
        assert!((two.energy() / before - 1.0).abs() < 1e-7);
        let block = &two.blocks[1];
        assert!(block.velocity.truncate().length() < 1e-12);
        let found = block.mass * (block.velocity.z + speed);
        let spin = (block.spin() - blow * turns) / (blow * turns.length());
        (found / blow - 1.0, spin)
    });
    println!("{errors:.5?}");
    // As measured with another program, to its digits.
    for ((found, _), (wanted, digit)) in
        errors.iter().zip([(2.6e-2, 5e-4), (1.3e-2, 5e-4), (6.7e-3, 5e-5), (3.6e-3, 5e-5)])
    {
        assert!((found - wanted).abs() < 1.2 * digit, "{found} {wanted}");
    }
    // Three powers of kn^(-1/4) taken out one after the other: the fourth is 3e-4 at 1e10 and 3e-7 at 1e13 times a factor of some ten.
    let mut limit = errors.to_vec();
    for power in 1..4 {
        let ratio = libm::pow(10.0, -0.25 * f64::from(power));
        let without = |fine: f64, coarse: f64| (fine - ratio * coarse) / (1.0 - ratio);
        limit = (limit.windows(2))
            .map(|pair| {
                let (coarse, fine) = (pair[0], pair[1]);
                let spin = (fine.1 - ratio * coarse.1) / (1.0 - ratio);
                (without(fine.0, coarse.0), spin)
            })
            .collect();
        println!("without {power} powers: {limit:.6?}");
    }
    let (blow, spin) = limit[0];
    assert!(blow.abs() < 2e-5, "{blow:e}");
    assert!(spin.length() < 1e-4, "{spin}");
}
