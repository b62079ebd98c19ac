//! A study: many runs of one scene.
//!
//! Every study is a list of *variants* of a scene, an *executor* that makes their runs, and a *reduction* of what came of them:
//!
//! | study | variants | which of them run | reduction |
//! |---|---|---|---|
//! | [`sweep`] | cases: variants and swept values | all | a table, a row a case |
//! | [`monte_carlo`] | samples of random values | all | probability of failure, influences |
//! | [`verify`] | cases of many scenes | all | verdicts of checks |
//! | [`trust`] | step, stiffness, damping, size, seed changed one at a time | all that fit into the budget | error of each result |
//! | [`laws`] | a case under both normal laws | all | differences ([`compare`]) |
//! | [`bisect`] | values of a key | those that narrow a [`bracket`] | the limit |
//! | [`find`] | values of a key | those that narrow a [`bracket`] | the value at which a result is as wanted |
//! | [`safety`] | factors of strength, or values of a key | those that narrow a [`bracket`] | the limit, the mechanism |
//!
//! * A variant is a [`Case`](crate::scenario::Case): a name and overrides. [`range`] makes those of a key. A factor of strength is no key:
//!   its variant is the plan of the model with a reduction.
//! * The [`Executor`] hands each variant to a function and takes what came of it in the order of the list, whatever the number of
//!   threads. It alone knows where runs are made and whether somebody wants them to stop. A function is given the variant and
//!   nothing of other runs, except in a bracket what the nearest one that holds has left; its result is plain data. So a process
//!   of a cluster that makes the same list needs the number of a variant alone.
//! * A bracket asks for its variants one after the other; what it may ask for next is run ahead on threads that are
//!   left, and cancelled where it turns out to be useless. Its trials are the same for any number of threads.
//! * A variant that fails is a result: a row, a verdict, a trial. An error ends a study only where nothing can be
//!   said without that variant.
//!
//! Not here: one run with its folder, its resuming and its progress ([`job`](super::job), [`drive`](super::drive)), and the repeat of a
//! stopped stretch with half the step, which a run does for itself (`drive/repeat.rs`): it goes on from a state, not from a scene.

pub mod bracket;
pub mod compare;
mod error;
pub mod safety;

#[cfg(feature = "scenario")]
pub mod bisect;
#[cfg(feature = "scenario")]
pub mod find;
#[cfg(feature = "scenario")]
pub mod laws;
#[cfg(feature = "scenario")]
pub mod monte_carlo;
#[cfg(feature = "scenario")]
pub mod range;
#[cfg(feature = "scenario")]
pub mod sweep;
#[cfg(feature = "scenario")]
pub mod trust;
#[cfg(feature = "scenario")]
pub mod verify;

#[cfg(feature = "scenario")]
pub use error::RangeError;
pub use error::StudyError;

use super::drive::Control;
use crate::exec::side_by_side;

/// Makes the runs of a study: on threads of this process, until somebody wants to stop.
#[derive(Clone, Copy)]
pub struct Executor<'a> {
    /// Threads of all runs together.
    pub threads: usize,
    /// Whether to stop; asked about ten times a second by each run.
    pub stop: &'a (dyn Fn() -> bool + Sync),
}

impl Executor<'_> {
    /// One thread that nobody stops.
    pub const ALONE: Executor<'static> = Executor { threads: 1, stop: &|| false };

    /// The same on that number of threads.
    #[must_use]
    pub fn on(self, threads: usize) -> Self {
        Self { threads, ..self }
    }

    /// Makes the runs of `variants`, one on each thread, and hands what came of them to `done` in the order of the list.
    pub fn each<T: Sync, R: Send>(
        &self,
        variants: &[T],
        one: impl Fn(&T) -> R + Sync,
        done: impl FnMut(R),
    ) {
        side_by_side(self.threads, variants, one, done);
    }

    /// What a run is to do that looks up now.
    #[must_use]
    pub fn control(&self) -> Control {
        Control::stop_if((self.stop)())
    }
}
