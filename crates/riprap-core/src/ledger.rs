//! The energy ledger: where every joule is, came from and went, J per metre of thickness in 2D.
//!
//! Stored: kinetic, gravity (minus the work of gravity), contact normal and shear, bonds.
//! Put in: work of loads, supports and gas. Taken out: friction, damping, fracture, absorbed at viscous
//! boundaries; taken along by blocks that leave the model. Booked apart: the
//! energy a non-conservative contact law makes or loses (`law_defect`), what edits of the
//! model add (`edit_defect`), and what changes of the step add (`step_change`). What is left over is the **residual**.
//!
//! Works are trapezoidal over each step, with the half-step velocity of the leapfrog: the sum over
//! all forces is then exactly the change of the time-centred kinetic energy `m v(n-1/2)·v(n+1/2)/2`,
//! so that the residual measures contact energies against their true potential, and nothing else.
//!
//! That energy is `m v²/2 - m (h a)²/8` with the velocity `v` and the acceleration `a` of the instant and the step `h`: the same state has
//! less of it before a long step than before a short one. Where `h` changes (at the start it grows from nothing) or the forces jump,
//! the difference is booked as `step_change`. A shorter step gives back what a longer one has held back; what comes beyond that is an error of
//! the motion, and is judged ([`Works::by_steps`]).

use serde::{Deserialize, Serialize};

/// Running sums of work and dissipation since the start, J/m.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Works {
    /// Work of gravity.
    pub gravity: f64,
    /// Work of external loads.
    pub loads: f64,
    /// Work of supports (prescribed motion).
    pub supports: f64,
    /// Elastic normal work of found contacts that have no potential (penetration-potential law).
    pub contact_path: f64,
    /// Dissipated by friction, the sticking dashpot included.
    pub friction: f64,
    /// Dissipated by contact, bond, mass and local damping.
    pub damping: f64,
    /// The part of `damping` that local damping has taken. It acts against the velocity of half a step before the force, so that in a
    /// step in which a motion turns round it gives some back: that is its own work, and no error of a contact.
    pub local: f64,
    /// Released by bond failure.
    pub fracture: f64,
    /// Absorbed by viscous boundaries.
    pub absorbed: f64,
    /// Dissipated in bolts: yield of bars, slip of grout and dowels, rupture.
    pub bolts: f64,
    /// Done by the gas of cavities and other pressures in them.
    pub gas: f64,
    /// Taken by the integration itself in implicit phases: what contacts have taken up in a step and do not store at its end. With half the
    /// step it is half as much.
    pub integrator: f64,
    /// Taken along by blocks that have left the model: their energy of motion, and what their contacts and joints stored.
    pub left: f64,
    /// Made (+) or lost (-) by a contact law without potential, booked when a contact ends; or by steps too long for contacts and joints.
    pub law_defect: f64,
    /// Added by edits: removed blocks, velocities set to zero, hand-over of bonds.
    pub edit_defect: f64,
    /// Added by changes of the step (the first one grows from nothing) and by forces that jump between two steps.
    pub step_change: f64,
    /// The part of `step_change` since the present motion began with half a kick.
    pub motion: f64,
    /// What motions before it have left of that, where it was more than they held back.
    pub made: f64,
    /// Largest magnitude that a work above has had at the end of a step: the scale of the residual.
    /// Not a sum.
    pub peak: f64,
    /// What friction, damping (but for local damping), fracture, absorption and bolts have taken at most: none of them falls below it. Not
    /// a sum.
    pub floor: [f64; 5],
}

impl Works {
    /// Closes the books of an instant, once all its forces have done their work: where a line of dissipation has fallen, the step has *made*
    /// energy. That is an error of the laws (a trapezoid over a reversal, a spring that turned in one step), and the line stays
    /// where it was. Doing it again changes nothing.
    pub fn settle(&mut self) {
        self.damping -= self.local;
        let lines = [
            &mut self.friction,
            &mut self.damping,
            &mut self.fracture,
            &mut self.absorbed,
            &mut self.bolts,
        ];
        for (line, floor) in lines.into_iter().zip(&mut self.floor) {
            if *line < *floor {
                self.law_defect += *floor - *line;
                *line = *floor;
            } else {
                *floor = *line;
            }
        }
        self.damping += self.local;
    }

    /// Books what friction and fracture have taken in a step. Where the ledger of a law says that it has *made* energy, the step was too
    /// long for it: that is an error of the law, and dissipation never shrinks.
    pub fn dissipate(&mut self, friction: f64, fracture: f64) {
        for (line, lost) in [(&mut self.friction, friction), (&mut self.fracture, fracture)] {
            if lost < 0.0 {
                self.law_defect -= lost;
            } else {
                *line += lost;
            }
        }
    }

    /// Books what a change of the step adds to the energy of motion at half steps; `begins`: a motion begins with half a kick.
    pub fn change_step(&mut self, energy: f64, begins: bool) {
        if begins {
            self.made += self.motion.max(0.0);
            self.motion = 0.0;
        }
        self.step_change += energy;
        self.motion += energy;
    }

    /// What changes of the step have made: beyond what the first step of the motion, and longer ones since, have held back. What they hold back
    /// and do not give again is no error that grows: the energy of the instant swings about that of the half steps, by as much.
    #[must_use]
    pub fn by_steps(&self) -> f64 {
        self.made + self.motion.max(0.0)
    }

    /// Notes how large the sums are now.
    pub fn note_peak(&mut self) {
        // What cannot be accounted for is not in it: a defect would make itself small.
        self.peak = [
            self.gravity,
            self.loads,
            self.supports,
            self.friction,
            self.damping,
            self.fracture,
            self.absorbed,
            self.bolts,
            self.gas,
        ]
        .into_iter()
        .fold(self.peak, |peak, work| peak.max(work.abs()));
    }

    /// Adds the works of the half step after an instant, once, and notes how large the sums are then.
    pub fn depart(&mut self, departure: &mut Self) {
        self.add(&std::mem::take(departure));
        self.note_peak();
    }

    /// The energy at the start and all that gravity, loads, supports and edits have put in since, as
    /// magnitudes: what kinetic energy can be judged against.
    #[must_use]
    pub fn put_in(&self, start: f64) -> f64 {
        start.abs()
            // What has risen has taken energy out.
            + self.gravity.max(0.0)
            + self.loads.abs()
            + self.supports.abs()
            + self.gas.abs()
            + self.edit_defect.abs()
    }

    /// All sums times a factor.
    #[must_use]
    pub fn times(&self, factor: f64) -> Self {
        Self {
            gravity: factor * self.gravity,
            loads: factor * self.loads,
            supports: factor * self.supports,
            contact_path: factor * self.contact_path,
            friction: factor * self.friction,
            damping: factor * self.damping,
            local: factor * self.local,
            fracture: factor * self.fracture,
            absorbed: factor * self.absorbed,
            bolts: factor * self.bolts,
            gas: factor * self.gas,
            integrator: factor * self.integrator,
            left: factor * self.left,
            law_defect: factor * self.law_defect,
            edit_defect: factor * self.edit_defect,
            step_change: factor * self.step_change,
            motion: factor * self.motion,
            made: factor * self.made,
            peak: factor * self.peak,
            floor: self.floor.map(|floor| factor * floor),
        }
    }

    /// Adds another set of sums.
    pub fn add(&mut self, other: &Self) {
        // Peak and floor belong to the sums since the start, not to what is added.
        self.gravity += other.gravity;
        self.loads += other.loads;
        self.supports += other.supports;
        self.contact_path += other.contact_path;
        self.friction += other.friction;
        self.damping += other.damping;
        self.local += other.local;
        self.fracture += other.fracture;
        self.absorbed += other.absorbed;
        self.bolts += other.bolts;
        self.gas += other.gas;
        self.integrator += other.integrator;
        self.left += other.left;
        self.law_defect += other.law_defect;
        self.edit_defect += other.edit_defect;
        self.step_change += other.step_change;
    }
}

/// Blocks that have left the model, and what they took along besides the energy [`Works::left`].
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Left {
    /// Their number.
    pub blocks: u64,
    /// kg; in the plane kg/m.
    pub mass: f64,
    /// N s; in the plane N s/m.
    pub momentum: [f64; 3],
}

impl Left {
    /// Books one more.
    pub fn book(&mut self, mass: f64, velocity: [f64; 3]) {
        self.blocks += 1;
        self.mass += mass;
        for (sum, v) in self.momentum.iter_mut().zip(velocity) {
            *sum += mass * v;
        }
    }
}

/// The ledger at one instant, J/m.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Balance {
    /// Kinetic energy, time-centred.
    pub kinetic: f64,
    /// Potential energy of gravity, relative to the start.
    pub gravity: f64,
    /// Elastic energy in the normal direction of found contacts.
    pub contact_normal: f64,
    /// Elastic energy of the shear springs.
    pub contact_shear: f64,
    /// Elastic energy of bonds; of the springs of boundaries in 3D.
    pub bond: f64,
    /// Elastic energy of bolts: bars, grout, plates, dowels.
    pub bolts: f64,
    /// The running sums.
    pub works: Works,
    /// Kinetic + stored energy at the start.
    pub start: f64,
}

impl Balance {
    /// Kinetic and all stored energy.
    #[must_use]
    pub fn total(&self) -> f64 {
        self.kinetic
            + self.gravity
            + self.contact_normal
            + self.contact_shear
            + self.bond
            + self.bolts
    }

    /// The energy of the state that a run begins with, where this is its first evaluation: joints that are stressed beyond their strength give
    /// way in it before anything moves, and what they dissipate was stored until then.
    #[must_use]
    pub fn at_start(&self) -> f64 {
        let w = &self.works;
        self.total() + w.friction + w.damping + w.fracture + w.absorbed + w.bolts
    }

    /// All energies times a factor: those of a slice of that thickness from those per metre.
    #[must_use]
    pub fn times(&self, factor: f64) -> Self {
        Self {
            kinetic: factor * self.kinetic,
            gravity: factor * self.gravity,
            contact_normal: factor * self.contact_normal,
            contact_shear: factor * self.contact_shear,
            bond: factor * self.bond,
            bolts: factor * self.bolts,
            works: self.works.times(factor),
            start: factor * self.start,
        }
    }

    /// What the ledger does not explain: positive means energy came from nowhere.
    #[must_use]
    pub fn residual(&self) -> f64 {
        let w = &self.works;
        // `contact_path` is not among these: it is told as stored, in `contact_normal`.
        let booked = w.law_defect + w.edit_defect + w.step_change;
        let expected = self.start + w.loads + w.supports + w.gas + booked
            - w.friction
            - w.damping
            - w.fracture
            - w.absorbed
            - w.bolts
            - w.integrator
            - w.left;
        self.total() - expected
    }

    /// The largest energy that has moved so far.
    #[must_use]
    pub fn scale(&self) -> f64 {
        let stored = self.contact_normal + self.contact_shear + self.bond + self.bolts;
        [self.kinetic, stored, self.start, self.works.peak]
            .into_iter()
            .fold(0.0_f64, |m, x| m.max(x.abs()))
    }

    /// The residual over the largest energy that has moved so far, so that it can be judged; 0 when
    /// nothing has moved.
    #[must_use]
    pub fn residual_relative(&self) -> f64 {
        self.share(Unexplained::Residual)
    }

    /// The same of what is not accounted for in either way.
    #[must_use]
    pub fn share(&self, what: Unexplained) -> f64 {
        let scale = self.scale();
        if scale > 0.0 { what.of(self) / scale } else { 0.0 }
    }
}

/// What a ledger cannot account for, and what runs are warned of and stopped for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Unexplained {
    /// [`Balance::residual`].
    Residual,
    /// What contacts and joints have made or lost beside their laws: a step that is too long for them.
    LawDefect,
    /// [`Works::by_steps`].
    Steps,
}

impl Unexplained {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Residual, Self::LawDefect, Self::Steps];

    /// How much of it there is, J/m.
    #[must_use]
    pub fn of(self, balance: &Balance) -> f64 {
        match self {
            Self::Residual => balance.residual(),
            Self::LawDefect => balance.works.law_defect,
            Self::Steps => balance.works.by_steps(),
        }
    }
}

impl std::fmt::Display for Unexplained {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::Residual => "the energy residual",
            Self::LawDefect => "the energy created or lost by contacts and joints (`law_defect`)",
            Self::Steps => "the energy created by changes of the time step (`step_change`)",
        })
    }
}

/// A term of the ledger.
pub type Term = fn(&Balance) -> f64;

/// Columns of `energy.csv`: name (behind `energy.` in the field table) and how it is read.
pub const COLUMNS: [(&str, Term); 20] = [
    ("kinetic", |b| b.kinetic),
    ("gravity", |b| b.gravity),
    ("contact_normal", |b| b.contact_normal),
    ("contact_shear", |b| b.contact_shear),
    ("joints", |b| b.bond),
    ("bolts", |b| b.bolts),
    ("loads", |b| b.works.loads),
    ("supports", |b| b.works.supports),
    ("gas", |b| b.works.gas),
    ("friction", |b| b.works.friction),
    ("damping", |b| b.works.damping),
    ("fracture", |b| b.works.fracture),
    ("absorbed", |b| b.works.absorbed),
    ("bolt_loss", |b| b.works.bolts),
    ("integrator", |b| b.works.integrator),
    ("left", |b| b.works.left),
    ("law_defect", |b| b.works.law_defect),
    ("edit_defect", |b| b.works.edit_defect),
    ("step_change", |b| b.works.step_change),
    ("residual", Balance::residual),
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_a_long_step_holds_back_is_no_error_and_more_than_that_is() {
        let mut works = Works::default();
        // A fall in long steps that are made shorter before the ground.
        works.change_step(-75.0, true);
        works.change_step(74.0, false);
        assert_eq!((works.by_steps(), works.step_change), (0.0, -1.0));
        // A jump into a contact with a step that is too long for it, and a motion after it that holds back more.
        works.change_step(6.0, false);
        assert_eq!(works.by_steps(), 5.0);
        works.change_step(-20.0, true);
        assert_eq!((works.by_steps(), works.step_change), (5.0, -15.0));
        works.change_step(21.0, false);
        assert_eq!(works.by_steps(), 6.0);
    }

    #[test]
    fn local_damping_may_give_back_and_a_dashpot_may_not() {
        let mut works = Works { damping: 5.0, local: 5.0, ..Works::default() };
        works.settle();
        (works.damping, works.local) = (4.0, 4.0);
        works.settle();
        assert_eq!((works.damping, works.law_defect), (4.0, 0.0));
        // Of a dashpot the same is energy that a step has made.
        works.damping += 2.0;
        works.settle();
        works.damping -= 0.5;
        works.settle();
        assert_eq!((works.damping, works.law_defect), (6.0, 0.5));
    }

    #[test]
    fn the_columns_leave_the_residual() {
        let works = Works { loads: 3.0, friction: 1.0, step_change: -0.5, ..Works::default() };
        let balance = Balance { kinetic: 1.0, works, ..Balance::default() };
        assert_eq!(balance.residual(), 1.0 - (3.0 - 1.0 - 0.5));
    }
}
