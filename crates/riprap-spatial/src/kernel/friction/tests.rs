//! Friction: what turns together does not slide.

use super::*;

/// Two blocks that turn together about an axis far away do not slide on each other.
#[test]
fn blocks_that_turn_together_do_not_slide() {
    let (spin, dt) = (2.0 * Vec3::Z, 1e-3);
    let places = [Vec3::ZERO, Vec3::new(5.0, 0.0, 1.0)];
    // Velocities of the middle of the step, in which the blocks have moved by half of it less.
    let motion = places.map(|now| Motion {
        velocity: spin.cross(now - 0.5 * dt * spin.cross(now)),
        spin,
        inverse_mass: 1.0,
    });
    let at = Vec3::new(5.0, 0.0, 0.5);
    let arms = places.map(|centre| at - centre);
    let contact = Contact {
        normal: Vec3::Z,
        elastic: 1.0,
        point: at,
        area: 1.0,
        polar: 1.0,
        spread: Mat3::IDENTITY,
        gyration: 1.0,
        hold: 1.0,
    };
    let slip = |arms| relative(&contact, motion, arms).along.length();
    // Half a step of the centripetal acceleration.
    assert!((slip(arms) - 0.5 * dt * 4.0 * 5.0).abs() < 1e-12);
    assert!(slip(midway(arms, motion, dt)) < 1e-5);
}
