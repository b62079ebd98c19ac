//! A point that fails by itself.

use super::{BEYOND, Law, Loss, Memory, Traction, divided, lost, norm};

impl Law<'_> {
    /// Traction at the relative displacement `at` (n, b, c, m) with the memory that a point has; `start` (Pa) is that at zero displacement.
    #[must_use]
    pub fn carried(&self, start: &Traction, at: &[f64; 3], memory: &Memory) -> Traction {
        self.look(start, at, memory, self.dilated(memory.slip, memory)).1
    }

    /// Energy in the normal and in the shear spring, J/m².
    #[must_use]
    pub fn energy(&self, start: &Traction, at: &[f64; 3], memory: &Memory) -> [f64; 2] {
        let (w, t) = self.look(start, at, memory, self.dilated(memory.slip, memory));
        self.parts(w, &t)
    }

    /// Opening that a point has with its memory, m; negative where it is closed.
    #[must_use]
    pub fn opening_of(&self, start: &Traction, at: &[f64; 3], memory: &Memory) -> f64 {
        self.base(start, at, memory) - self.dilated(memory.slip, memory)
    }

    /// Energy in the normal and in the shear spring at the opening `w`, J/m².
    pub(super) fn parts(&self, w: f64, t: &Traction) -> [f64; 2] {
        let normal = self.stored(w, &[t[0], 0.0, 0.0]);
        [normal, self.stored(w, t) - normal]
    }

    /// Opening and traction with the memory that a point has.
    pub(super) fn look(
        &self,
        start: &Traction,
        at: &[f64; 3],
        memory: &Memory,
        dilated: f64,
    ) -> (f64, Traction) {
        let w = self.base(start, at, memory) - dilated;
        if memory.open {
            return (w, [0.0; 3]);
        }
        let damage = self.damage(memory, memory.accumulated_slip);
        let [b, c] = self.shear(start, at, memory);
        (w, [self.normal(w, damage, memory.parted), b, c])
    }

    /// Opening without dilation, m.
    pub(super) fn base(&self, start: &Traction, at: &[f64; 3], memory: &Memory) -> f64 {
        at[0] - memory.normal_offset + self.opening(start[0])
    }

    /// Traction of the shear spring, Pa.
    pub(super) fn shear(&self, start: &Traction, at: &[f64; 3], memory: &Memory) -> [f64; 2] {
        [0, 1].map(|k| start[k + 1] + self.springs[1] * (at[k + 1] - memory.slip[k]))
    }

    /// Lets the shear spring of an open point start anew from where it was a step ago.
    pub(super) fn start_anew(
        &self,
        start: &Traction,
        at: &[f64; 3],
        moved: &[f64; 3],
        memory: &mut Memory,
    ) {
        memory.slip = [0, 1].map(|k| at[k + 1] - moved[k + 1] + start[k + 1] / self.springs[1]);
    }

    /// One point: updates its memory, returns traction and losses.
    ///
    /// `at` is the relative displacement (m), `moved` its change in the last step (m), `start` the traction at zero displacement (Pa).
    #[must_use]
    pub fn point(
        &self,
        start: &Traction,
        at: &[f64; 3],
        moved: &[f64; 3],
        memory: &mut Memory,
    ) -> (Traction, Loss) {
        // The state of a step ago, against which all losses are booked.
        let old = [0, 1, 2].map(|k| at[k] - moved[k]);
        let (w, t) = self.look(start, &old, memory, self.dilated(memory.slip, memory));
        let before = (t, if memory.open { 0.0 } else { self.stored(w, &t) });
        let (whole, parted) = (!memory.broken, memory.parted);
        let account =
            |w: f64, t: &Traction| lost((&before.0, before.1), (t, self.stored(w, t)), moved);
        memory.sliding = false;
        if memory.open {
            memory.open = false;
            self.start_anew(start, at, moved, memory);
        }
        let base = self.base(start, at, memory);
        let w = base - self.dilated(memory.slip, memory);
        self.part(w, memory);
        let opens = |memory: &mut Memory, whole: bool| {
            memory.open = true;
            let all = account(0.0, &[0.0; 3]);
            ([0.0; 3], divided(all, if whole { all } else { 0.0 }))
        };
        if memory.broken && w >= 0.0 {
            return opens(memory, whole);
        }
        let accumulated = memory.accumulated_slip;
        let mut damage = self.damage(memory, accumulated);
        let sigma = self.normal(w, damage, memory.parted);
        let trial = self.shear(start, at, memory);
        let tau = norm(trial[0], trial[1]);
        let stays = |damage: f64| tau <= BEYOND * self.limit(sigma, damage, accumulated);
        let fails = !stays(damage);
        if fails && self.is_brittle() && whole {
            memory.broken = true;
            if w > 0.0 {
                return opens(memory, true);
            }
            damage = 1.0;
        }
        if !fails || stays(damage) {
            let t = [sigma, trial[0], trial[1]];
            // What has softened across the joint is lost without any slip.
            let all = if memory.parted > parted { account(w, &t) } else { 0.0 };
            return (t, divided(all, all));
        }
        let direction = trial.map(|x| x / tau);
        let [plastic, dilated] =
            self.flow(tau, (memory.slip, direction), memory, |dilated, damage| {
                self.normal(base - dilated, damage, memory.parted)
            });
        let above = self.above_residual(sigma, damage, accumulated);
        self.slid(plastic, memory, dilated);
        let accumulated = memory.accumulated_slip;
        let damage = self.damage(memory, accumulated);
        let w = base - dilated;
        let sigma = self.normal(w, damage, memory.parted);
        // The spring gives way by the plastic slip along the trial direction.
        let keep = (1.0 - self.springs[1] * plastic / tau).max(0.0);
        memory.slip = [0, 1].map(|k| memory.slip[k] + plastic * direction[k]);
        let t = [sigma, keep * trial[0], keep * trial[1]];
        // By the trapezoidal rule: the strength above the residual one changes along the slip.
        let separation = 0.5 * plastic * (above + self.above_residual(sigma, damage, accumulated));
        (t, divided(account(w, &t), separation))
    }
}
