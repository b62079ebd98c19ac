//! Rotations of a block that are prescribed in part, about axes of space.
//!
//! With the angular momentum `L = I w` at the attitude of now, F the free axes and C the prescribed ones, supports give a moment about C
//! alone. So `L_F` follows the moments that act, `w_C` is what is prescribed, and the free spin solves
//!
//! ```text
//!     I_FF w_F = L_F - I_FC w_C
//! ```
//!
//! It is not `(I^-1 L)_F`, which is the spin of a block that is free about all axes, unless the axes are principal ones. What is held does no
//! work; what is driven does `w_C` times the moment about C.

use riprap_geom::{Mat3, Quat, Vec3};

use crate::joint::patch::turned_inertia;
use crate::setup::Motion;
use crate::setup::rotation::rotation;

/// Rounds of the midpoint after which it is taken as it is.
const ROUNDS: usize = 50;

/// Which rotations are prescribed, and the tensor of inertia at an attitude, space frame.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Bound {
    held: [bool; 3],
    inertia: Mat3,
}

impl Bound {
    /// Of a motion at a tensor of inertia (kg m²); none where all rotations are free.
    pub(crate) fn of(motion: &Motion, inertia: Mat3) -> Option<Self> {
        let [_, held] = motion.prescribes();
        held.contains(&true).then_some(Self { held, inertia })
    }

    /// 1 for each axis about which the rotation is prescribed, else 0.
    pub(crate) fn axes(&self) -> Vec3 {
        Vec3::from_array(self.held.map(|held| f64::from(u8::from(held))))
    }

    /// Whether a prescribed rotation has a part in a free one.
    pub(crate) fn couples(&self) -> bool {
        let pairs = [[0, 1], [0, 2], [1, 2]];
        let coupled =
            |&[k, l]: &[usize; 2]| self.held[k] != self.held[l] && self.inertia.col(l)[k] != 0.0;
        pairs.iter().any(coupled)
    }

    /// The spin with the prescribed parts of `given` and the free parts that the angular momentum asks for (or the change of
    /// one of the other); parts of the momentum about prescribed axes do not count.
    pub(crate) fn spin(&self, given: Vec3, momentum: Vec3) -> Vec3 {
        let given = self.axes() * given;
        let mut right = momentum - self.inertia * given;
        let mut columns = [self.inertia.col(0), self.inertia.col(1), self.inertia.col(2)];
        for k in (0..3).filter(|k| self.held[*k]) {
            for (l, column) in columns.iter_mut().enumerate() {
                column[k] = 0.0;
                if l == k {
                    *column = Vec3::ZERO;
                    column[k] = 1.0;
                }
            }
            right[k] = 0.0;
        }
        let free = Mat3::from_cols(columns[0], columns[1], columns[2]).inverse() * right;
        // The round-off of the inverse must not move what is held.
        Vec3::from_array([0, 1, 2].map(|k| if self.held[k] { given[k] } else { free[k] }))
    }

    /// Attitude after `dt` (s) and the spin on the way, which has the prescribed parts of `start` and keeps the angular momentum
    /// about the free axes: implicit midpoint. `inertia`: in the frame of the start. A rotation about one axis is exact.
    pub(crate) fn turn(
        &self,
        attitude: Quat,
        start: Vec3,
        momentum: Vec3,
        inertia: &Mat3,
        dt: f64,
    ) -> (Quat, Vec3) {
        let mut spin = start;
        let mut last = f64::INFINITY;
        for _ in 0..if self.held == [true; 3] { 0 } else { ROUNDS } {
            let middle = rotation(0.5 * dt * spin) * attitude;
            let there = Self { inertia: turned_inertia(inertia, middle), ..*self };
            let next = there.spin(start, momentum);
            let change = (next - spin).length();
            spin = next;
            // Each round gains a factor of about the angle of the step, down to round-off.
            if change <= 1e-15 * next.length() || change >= last {
                break;
            }
            last = change;
        }
        if spin == Vec3::ZERO {
            return (attitude, spin);
        }
        // Products of rotations lose their length by round-off, step after step.
        ((rotation(dt * spin) * attitude).normalize(), spin)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn tilted() -> (Mat3, Quat) {
        let brick = Mat3::from_diagonal(Vec3::new(800.0, 640.0, 300.0));
        (brick, rotation(Vec3::new(0.6, 0.25, -0.2)))
    }

    fn held(rotation: [bool; 3]) -> Motion {
        Motion::Fixed { translation: [true; 3], rotation }
    }

    #[test]
    fn the_free_spin_follows_the_free_part_of_the_inertia() {
        let (brick, q) = tilted();
        let inertia = turned_inertia(&brick, q);
        for rotation in [[true, false, true], [false, false, true], [false, true, false]] {
            let bound = Bound::of(&held(rotation), inertia).expect("something is held");
            assert!(bound.couples());
            let (given, momentum) = (Vec3::new(0.3, -0.2, 0.7), Vec3::new(5.0, 100.0, -30.0));
            let spin = bound.spin(given, momentum);
            let left = inertia * spin - momentum;
            for k in 0..3 {
                if rotation[k] {
                    assert_eq!(spin[k], given[k]);
                } else {
                    assert!(left[k].abs() < 1e-12 * momentum.length(), "{left}");
                }
            }
        }
        // What is free about all axes has nothing to do with it, and principal axes do not couple.
        assert!(Bound::of(&held([false; 3]), inertia).is_none());
        let straight = Bound::of(&held([true, false, true]), brick).expect("something is held");
        assert!(!straight.couples());
    }

    #[test]
    fn a_rotation_about_one_axis_keeps_its_spin_and_its_axis() {
        let (brick, start) = tilted();
        let bound = |q| Bound::of(&held([true, false, true]), turned_inertia(&brick, q));
        let mut attitude = start;
        let mut spin = Vec3::new(0.0, 2.0, 0.0);
        for _ in 0..1000 {
            let bound = bound(attitude).expect("something is held");
            let momentum = turned_inertia(&brick, attitude) * spin;
            (attitude, spin) = bound.turn(attitude, spin, momentum, &brick, 1e-3);
        }
        assert!((spin - Vec3::new(0.0, 2.0, 0.0)).length() < 1e-12, "{spin}");
        let wanted = rotation(Vec3::new(0.0, 2.0, 0.0)) * start;
        assert!((attitude * Vec3::X - wanted * Vec3::X).length() < 1e-12);
        assert!((attitude * Vec3::Z - wanted * Vec3::Z).length() < 1e-12);
    }

    #[test]
    fn with_one_axis_held_the_energy_stays_to_second_order_of_the_step() {
        let (brick, start) = tilted();
        let drift = |dt: f64| {
            let (mut attitude, momentum) = (start, Vec3::new(0.0, 700.0, 500.0));
            let of = |q| Bound::of(&held([true, false, false]), turned_inertia(&brick, q));
            let energy = |q: Quat| {
                let spin = of(q).expect("held").spin(Vec3::ZERO, momentum);
                0.5 * spin.dot(turned_inertia(&brick, q) * spin)
            };
            let first = energy(attitude);
            let mut most = 0.0_f64;
            for _ in 0..(4.0 / dt).round() as usize {
                let bound = of(attitude).expect("held");
                let now = bound.spin(Vec3::ZERO, momentum);
                attitude = bound.turn(attitude, now, momentum, &brick, dt).0;
                most = most.max((energy(attitude) / first - 1.0).abs());
            }
            most
        };
        let [coarse, fine] = [drift(0.02), drift(0.01)];
        assert!(coarse < 1e-3 && fine < 0.3 * coarse, "{coarse} {fine}");
    }
}
