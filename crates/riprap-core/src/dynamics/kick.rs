//! The leapfrog kick: local and mass-proportional damping, prescribed motion and what holds it.
//!
//! Velocities belong to half steps. A kick at time t turns the velocity v of half a step before into `v + dv`, over the span
//! between the two half steps; works are those of the half step before with v and of the half step after with `v + dv`, so that
//! their sum is the change of `m v(n-1/2).v(n+1/2)/2`. The functions serve blocks in the plane, rigid blocks in space and nodes; V is
//! a number or a vector.

use std::ops::{Add, Div, Mul, Sub};

use super::TimeFunction;

/// Local damping of a freedom (Cundall 1987): a `share` of the unbalanced `force` (N) against the `velocity` (m/s), N.
#[inline(always)]
#[must_use]
pub fn local_drag(share: f64, force: f64, velocity: f64) -> f64 {
    if velocity == 0.0 || share == 0.0 { 0.0 } else { -share * force.abs() * velocity.signum() }
}

/// What mass damping of rate `alpha` (1/s) makes of a kick over `span` (s): half the share of the velocity that it takes.
#[inline(always)]
#[must_use]
pub fn fade(alpha: f64, span: f64) -> f64 {
    0.5 * alpha * span
}

/// Share of a kick that lies before the present time: velocities are those of half a step before, the kick spans both halves. `before` and
/// `after` are the lengths of the last and of the coming step, s. Before the first step velocities are those of the present time already:
/// then it is 0.
#[inline(always)]
#[must_use]
pub fn past(before: f64, after: f64) -> f64 {
    if before > 0.0 { before / (before + after) } else { 0.0 }
}

/// Velocity change under `force`, with `ease` the span over the inertia: mass damping acts on the mean of the velocities before and
/// after (implicit, stable).
#[inline(always)]
#[must_use]
pub fn change<V>(ease: f64, force: V, fade: f64, velocity: V) -> V
where
    V: Sub<Output = V> + Mul<f64, Output = V> + Div<f64, Output = V>,
{
    (force * ease - velocity * (2.0 * fade)) / (1.0 + fade)
}

/// Force of mass damping, against the mean of the velocities before and after: to be taken from other damping forces.
#[inline(always)]
#[must_use]
pub fn mass_drag<V>(alpha: f64, inertia: f64, velocity: V, change: V) -> V
where
    V: Add<Output = V> + Mul<f64, Output = V>,
{
    (velocity + change * 0.5) * (alpha * inertia)
}

/// Force of what prescribes a motion: makes the difference `gap` between the velocity change that there is and the one that
/// would be without it.
#[inline(always)]
#[must_use]
pub fn reaction<V>(inertia: f64, fade: f64, span: f64, gap: V) -> V
where
    V: Mul<f64, Output = V>,
{
    gap * ((1.0 + fade) * inertia / span)
}

/// Works before and after the present time of what prescribes a motion: `reaction` is its force over the whole span, `blow` the
/// momentum that the freedoms with a given velocity change by. These keep their velocity until the present time and have the new one from
/// then on: so much of the reaction as balances all other forces acts in the halves of the steps, the rest is a blow between them. A
/// velocity that jumps where the step changes would leave work that nobody has done else.
#[derive(Clone, Copy, Debug, Default)]
pub struct Support<V> {
    /// Force in both halves, N; a moment, N m.
    pub steady: V,
    /// Impulse at the present time, N s; of a moment, N m s.
    pub blow: V,
}

impl<V> Support<V>
where
    V: Copy + Add<Output = V> + Sub<Output = V> + Mul<f64, Output = V> + Div<f64, Output = V>,
{
    /// Of a `reaction` over `span` (s).
    #[inline(always)]
    #[must_use]
    pub fn of(reaction: V, blow: V, span: f64) -> Self {
        let steady = reaction - blow / span;
        Self { steady, blow }
    }

    /// Works in the `half` steps (s) before and after the present time, with the velocities there; of the blow after it.
    #[inline(always)]
    #[must_use]
    pub fn works(&self, half: [f64; 2], [v, after]: [V; 2], dot: impl Fn(V, V) -> f64) -> [f64; 2] {
        [
            half[0] * dot(self.steady, v),
            half[1] * dot(self.steady, after) + 0.5 * dot(self.blow, v + after),
        ]
    }
}

/// What is prescribed for a freedom.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Target<'a> {
    /// Nothing.
    Free,
    /// It stands still.
    Still,
    /// Its velocity.
    Velocity(&'a TimeFunction),
    /// Its acceleration.
    Acceleration(&'a TimeFunction),
}

impl<'a> Target<'a> {
    /// Still, or nothing.
    #[must_use]
    pub fn held(held: bool) -> Self {
        if held { Self::Still } else { Self::Free }
    }

    /// A velocity, or nothing.
    #[must_use]
    pub fn velocity(given: Option<&'a TimeFunction>) -> Self {
        given.map_or(Self::Free, Self::Velocity)
    }

    /// An acceleration, or nothing.
    #[must_use]
    pub fn acceleration(given: Option<&'a TimeFunction>) -> Self {
        given.map_or(Self::Free, Self::Acceleration)
    }

    /// Whether nothing is prescribed.
    #[must_use]
    pub fn is_free(&self) -> bool {
        matches!(self, Self::Free)
    }

    /// Whether its velocity is given: what the kick makes of it is a jump, whatever the span.
    #[must_use]
    pub fn gives_velocity(&self) -> bool {
        matches!(self, Self::Still | Self::Velocity(_))
    }

    /// Velocity change in a kick at `time` (s) before a step of twice `half` (s), over `span` (s): a prescribed velocity is met in
    /// the middle of the step. `velocity`: before the kick; `free`: the change if nothing is prescribed.
    #[must_use]
    pub fn change(&self, velocity: f64, free: f64, time: f64, half: f64, span: f64) -> f64 {
        match self {
            Self::Free => free,
            Self::Still => -velocity,
            Self::Velocity(f) => f.at(time + half) - velocity,
            Self::Acceleration(f) => span * f.at(time),
        }
    }

    /// Velocity at `time` (s) of a freedom that has the `velocity` before anything is prescribed.
    #[must_use]
    pub fn at(&self, time: f64, velocity: f64) -> f64 {
        match self {
            Self::Free | Self::Acceleration(_) => velocity,
            Self::Still => 0.0,
            Self::Velocity(f) => f.at(time),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn works_of_both_halves_are_the_change_of_the_kinetic_energy() {
        // m (v- v+) / 2 before and after: with equal steps the force, damping and reaction do all of it.
        let (m, v, f, span, alpha) = (3.0, 0.7, -5.0, 0.02, 4.0);
        let fade = fade(alpha, span);
        let free = change(span / m, f, fade, v);
        let velocity = TimeFunction::Constant(1.3);
        let dv = Target::Velocity(&velocity).change(v, free, 0.0, 0.5 * span, span);
        assert!((v + dv - 1.3).abs() < 1e-15);
        let support = reaction(m, fade, span, dv - free);
        let all = f + support - mass_drag(alpha, m, v, dv);
        assert!((all * span - m * dv).abs() < 1e-14);
        let work = 0.5 * span * all * v + 0.5 * span * all * (v + dv);
        let kinetic = 0.5 * m * ((v + dv) * (v + dv) - v * v);
        assert!((work - kinetic).abs() < 1e-14);
    }

    #[test]
    fn a_velocity_that_jumps_where_the_step_changes_makes_no_energy() {
        // Steps of 10 and 30 ms: the kinetic energies before and after the present time are those of the two velocities.
        let (m, v, f, half, alpha) = (3.0, 0.7, -5.0, [0.005, 0.015], 4.0);
        let span = half[0] + half[1];
        let fade = fade(alpha, span);
        let free = change(span / m, f, fade, v);
        let velocity = TimeFunction::Constant(9.3);
        let target = Target::Velocity(&velocity);
        assert!(target.gives_velocity() && !Target::Free.gives_velocity());
        let dv = target.change(v, free, 0.0, half[1], span);
        let support = Support::of(reaction(m, fade, span, dv - free), m * dv, span);
        let other = f - mass_drag(alpha, m, v, dv);
        let works = support.works(half, [v, v + dv], |a, b| a * b);
        assert!((works[0] + half[0] * other * v).abs() < 1e-14);
        let kinetic = 0.5 * m * ((v + dv) * (v + dv) - v * v);
        let after = works[1] + half[1] * other * (v + dv);
        assert!((after - kinetic).abs() < 1e-12 * kinetic);
    }

    #[test]
    fn damping_never_turns_a_motion_round() {
        // Implicit: however strong, the velocity only falls to its negative at most, and local damping is below the force.
        for alpha in [0.0, 1.0, 1e3, 1e9] {
            let dv = change(0.0, 0.0, fade(alpha, 0.1), 2.0);
            assert!(dv <= 0.0 && (2.0 + dv).abs() <= 2.0);
        }
        assert_eq!(local_drag(0.8, -10.0, 3.0), -8.0);
        assert_eq!(local_drag(0.8, 10.0, -3.0), 8.0);
        assert_eq!(local_drag(0.8, 10.0, 0.0), 0.0);
    }

    #[test]
    fn targets_say_what_a_freedom_does() {
        let f = TimeFunction::Constant(2.0);
        let change = |t: Target| t.change(0.5, 0.1, 0.0, 0.0, 0.25);
        assert_eq!(change(Target::held(false)), 0.1);
        assert_eq!(change(Target::held(true)), -0.5);
        assert_eq!(change(Target::velocity(Some(&f))), 1.5);
        assert_eq!(change(Target::acceleration(Some(&f))), 0.5);
        assert_eq!(Target::acceleration(Some(&f)).at(0.0, 0.5), 0.5);
        assert_eq!(Target::velocity(Some(&f)).at(0.0, 0.5), 2.0);
        assert!(Target::velocity(None).is_free() && !Target::held(true).is_free());
    }
}
