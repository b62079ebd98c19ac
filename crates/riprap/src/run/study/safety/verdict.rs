//! Whether a trial is failing, and how.

use serde::Serialize;

use crate::plan::PhaseKind;
use crate::run::engine::Movement;
use crate::run::simulation::{Simulation, Spent, middle_size};
use crate::run::study::bracket::State;

/// Share of the size of the middle one of the blocks that counts as moved where nothing else is said.
const MOVED: f64 = 1e-3;

/// Growth of the mean kinetic energy from one quarter of a trial to the next that tells of a mechanism: a steady pull gives 2.7 and
/// 1.9, what swings and calms down less than 1.
const GROWTH: f64 = 1.3;
/// Share of the displacement that counts as moved beyond which blocks may have been driven into each other ([`Spent::strays`]).
const STRAYED: f64 = 0.05;
/// Looks before anything is said, and steps of Newton's method that a mechanism goes on for.
const FEWEST: usize = 12;
/// Way of a block in such a step, over half its shortest edge, from which on blocks move as far as steps allow.
const FAST: f64 = 0.0125;
/// Share of the unbalanced forces that is left by a mechanism that moves slowly, after so many steps.
const LEFT: f64 = 0.98;
/// Share of the farthest displacement from which on a block belongs to the mechanism.
const MOVING: f64 = 0.3;

/// How the blocks of a mechanism move.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Mechanism {
    /// They only slide or fall: turning moves their edges by less than a tenth of the displacement.
    Sliding,
    /// They only turn: edges move by more than the displacement of the centroids.
    Turning,
    /// Both.
    Both,
}

/// One look at a trial.
pub(super) struct Look {
    /// Steps since the trial began.
    steps: u64,
    /// Kinetic energy, J or J/m.
    kinetic: f64,
    /// Way of a block in the last step over half its shortest edge, and the ratio of unbalanced forces, where steps seek an equilibrium.
    seeking: Option<[f64; 2]>,
    /// Free blocks since the trial began.
    movements: Vec<Movement>,
}

impl Look {
    /// At the present, prepared state; the trial began at step `begin`.
    pub(super) fn of(simulation: &Simulation, begin: u64) -> Self {
        let view = simulation.view();
        Self {
            steps: simulation.steps() - begin,
            kinetic: view.kinetic(),
            seeking: seeks(simulation)
                .then(|| [simulation.engine().settling_way(), view.unbalanced()]),
            movements: view.movements(),
        }
    }
}

/// Whether the present phase seeks its equilibrium by Newton's method.
pub(super) fn seeks(simulation: &Simulation) -> bool {
    let quiet = simulation.phase().is_some_and(|phase| phase.kind == PhaseKind::Static);
    quiet && simulation.engine().is_implicit()
}

/// What has been seen of a trial.
pub(super) struct Watch {
    moved: Option<f64>,
    looks: Vec<(u64, f64)>,
    /// Way, unbalanced forces and farthest displacement (m) after each step of Newton's method.
    sought: Vec<[f64; 3]>,
    movements: Vec<Movement>,
    /// Displacements that blocks had before, m.
    base: Vec<(u32, [f64; 3])>,
}

impl Watch {
    /// Nothing yet; `moved` as in the rules, m.
    pub(super) fn new(moved: Option<f64>) -> Self {
        let (looks, sought) = (Vec::new(), Vec::new());
        Self { moved, looks, sought, movements: Vec::new(), base: Vec::new() }
    }

    /// Nothing yet, of blocks that have moved before: what counts is how far they come from there.
    pub(super) fn from(moved: Option<f64>, before: &Look) -> Self {
        let all = before.movements.iter();
        Self { base: all.map(|m| (m.block, m.shift)).collect(), ..Self::new(moved) }
    }

    /// Adds a look.
    pub(super) fn look(&mut self, look: Look) {
        self.looks.push((look.steps, look.kinetic));
        self.movements = look.movements;
        // Both lists are in the order of the blocks.
        let mut base = self.base.iter().peekable();
        for movement in &mut self.movements {
            while base.peek().is_some_and(|(block, _)| *block < movement.block) {
                base.next();
            }
            if let Some((block, shift)) = base.peek()
                && *block == movement.block
            {
                movement.shift = [0, 1, 2].map(|k| movement.shift[k] - shift[k]);
            }
        }
        if let Some([way, unbalanced]) = look.seeking {
            let moved = self.farthest().map_or(0.0, |(moved, _)| moved);
            self.sought.push([way, unbalanced, moved]);
        }
    }

    /// The block that has come farthest, and how far, m.
    pub(super) fn farthest(&self) -> Option<(f64, u32)> {
        let all = self.movements.iter().map(|m| (length(m.shift), m.block));
        all.fold(None, |far, one| {
            if far.is_none_or(|far: (f64, u32)| one.0 > far.0) { Some(one) } else { far }
        })
    }

    /// Displacement from which on a block counts as moved, m: as in the rules, or with a share that of the size of the middle one of the blocks.
    fn limit(&self, share: Option<f64>) -> f64 {
        let of_size = |share: f64| share * middle_size(&self.movements);
        match (share, self.moved) {
            (None, Some(moved)) => moved,
            (Some(share), _) => of_size(share),
            (None, None) => of_size(MOVED),
        }
    }

    /// Whether it has moved far enough to be asked; with a share, farther than that share of the size of the middle one of the blocks.
    pub(super) fn has_moved(&self, share: Option<f64>) -> bool {
        self.farthest().is_some_and(|(moved, _)| moved > self.limit(share))
    }

    /// Whether blocks have slid by more than their springs give, so that long steps may have wedged them between others; `spent` since it began.
    pub(super) fn has_strayed(&self, spent: Spent) -> bool {
        let moved = self.farthest().is_some_and(|(moved, _)| moved > STRAYED * self.limit(None));
        moved && spent.strays()
    }

    /// Whether it moves on and on.
    pub(super) fn is_failing(&self) -> bool {
        let goes_on = match self.sought.is_empty() {
            true => grows(&self.looks),
            false => goes_on(&self.sought),
        };
        self.looks.len() >= FEWEST && self.has_moved(None) && goes_on
    }

    /// What it is when it ends without balance: failing if it was at its end, else undecided.
    pub(super) fn stopped(&self) -> State {
        if self.is_failing() { State::Failing } else { State::Undecided }
    }

    /// Blocks of the mechanism, the farthest first.
    pub(super) fn moving(&self) -> Vec<Movement> {
        let far = self.farthest().map_or(0.0, |(far, _)| far);
        let mut moving: Vec<Movement> = self
            .movements
            .iter()
            .filter(|m| far > 0.0 && length(m.shift) >= MOVING * far)
            .copied()
            .collect();
        moving.sort_by(|a, b| {
            length(b.shift).total_cmp(&length(a.shift)).then(a.block.cmp(&b.block))
        });
        moving
    }
}

/// Whether the mean kinetic energy grows from quarter to quarter of the steps.
fn grows(looks: &[(u64, f64)]) -> bool {
    let Some(&(last, _)) = looks.last() else {
        return false;
    };
    let mean = |quarter: u64| {
        let inside = |step: u64| 4 * step > quarter * last && 4 * step <= (quarter + 1) * last;
        let (sum, count) = (looks.iter().filter(|(step, _)| inside(*step)))
            .fold((0.0, 0u32), |(sum, count), (_, kinetic)| (sum + kinetic, count + 1));
        sum / f64::from(count.max(1))
    };
    let [second, third, fourth] = [1, 2, 3].map(mean);
    third > GROWTH * second && fourth > GROWTH * third
}

/// Whether blocks move on and on in steps that forget velocities: as far as steps allow, or under forces that do not fall.
fn goes_on(sought: &[[f64; 3]]) -> bool {
    let farther = |of: &[[f64; 3]]| of.windows(2).all(|two| two[1][2] > two[0][2]);
    let last = |n: usize| sought.len().checked_sub(n).map(|from| &sought[from..]);
    let fast = last(FEWEST).is_some_and(|of| farther(of) && of.iter().all(|[way, ..]| *way > FAST));
    let steady = last(2 * FEWEST).is_some_and(|of| {
        let (before, after) = of.split_at(FEWEST);
        let most = before.iter().map(|[_, left, _]| *left).fold(0.0, f64::max);
        farther(of) && after.iter().all(|[_, left, _]| *left > LEFT * most)
    });
    fast || steady
}

/// Length of a vector.
pub(super) fn length(v: [f64; 3]) -> f64 {
    v.iter().map(|x| x * x).sum::<f64>().sqrt()
}

/// How the blocks of a mechanism move; `None` without any.
pub(super) fn mechanism(moving: &[Movement]) -> Option<Mechanism> {
    if moving.is_empty() {
        return None;
    }
    let edges = |m: &Movement| 0.5 * m.size * length(m.turn);
    if moving.iter().all(|m| edges(m) < 0.1 * length(m.shift)) {
        Some(Mechanism::Sliding)
    } else if moving.iter().all(|m| edges(m) > length(m.shift)) {
        Some(Mechanism::Turning)
    } else {
        Some(Mechanism::Both)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn looks(kinetic: impl Fn(f64) -> f64) -> Vec<(u64, f64)> {
        (0..=40).map(|k| (50 * k, kinetic(50.0 * k as f64))).collect()
    }

    #[test]
    fn a_steady_pull_grows_and_swings_do_not() {
        assert!(grows(&looks(|t| t * t)));
        assert!(grows(&looks(|t| libm::exp(t / 300.0))));
        // With the ripple of an elastic vibration on top.
        assert!(grows(&looks(|t| t * t * (1.0 + 0.5 * libm::sin(t / 37.0)))));
        for period in [60.0, 300.0, 900.0] {
            let swing =
                |t: f64| libm::exp(-t / 2000.0) * libm::sin(t / period) * libm::sin(t / period);
            assert!(!grows(&looks(swing)), "{period}");
        }
        assert!(!grows(&looks(|_| 1.0)));
        assert!(!grows(&[]));
    }

    #[test]
    fn steps_that_lead_on_and_on_are_a_mechanism() {
        let steps = |way: &dyn Fn(f64) -> f64, left: &dyn Fn(f64) -> f64| -> Vec<[f64; 3]> {
            let mut moved = 0.0;
            let one = |k: u32| {
                let k = f64::from(k);
                moved += way(k);
                [way(k), left(k), moved]
            };
            (0..30).map(one).collect()
        };
        // As far as a step may go, or slowly under a force that stays.
        assert!(goes_on(&steps(&|_| 0.05, &|_| 0.1)));
        assert!(goes_on(&steps(&|_| 1e-3, &|_| 2e-3)));
        assert!(goes_on(&steps(&|k| 1e-3 * (1.0 + 0.01 * k), &|k| 2e-3 * (1.0 + 0.01 * k))));
        // What comes to rest.
        let falls = |k: f64| 0.02 * libm::exp(-k / 10.0);
        assert!(!goes_on(&steps(&falls, &falls)));
        let slowly = |k: f64| 1e-3 * libm::exp(-k / 400.0);
        assert!(!goes_on(&steps(&slowly, &slowly)));
        assert!(!goes_on(&[]));
    }

    fn movement(shift: f64, turn: f64) -> Movement {
        Movement {
            block: 0,
            shift: [shift, 0.0, 0.0],
            turn: [0.0, 0.0, turn],
            size: 2.0,
            speed: 0.0,
        }
    }

    #[test]
    fn modes_in_words() {
        assert_eq!(mechanism(&[]), None);
        assert_eq!(mechanism(&[movement(1.0, 0.01)]), Some(Mechanism::Sliding));
        assert_eq!(mechanism(&[movement(0.1, 0.2)]), Some(Mechanism::Turning));
        assert_eq!(mechanism(&[movement(1.0, 0.01), movement(1.0, 0.5)]), Some(Mechanism::Both));
    }
}
