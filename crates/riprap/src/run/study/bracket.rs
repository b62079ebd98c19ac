//! Search for the value at which something begins to fail: which value is tried next, and trials side by side.
//!
//! [`Search`] is data: the trials so far say which one comes next, so the trials that are needed do not depend on how many are made
//! at a time. Threads that are left try what may be needed after the present trial, for either outcome; what
//! turns out to be useless is broken off and leaves no trace:
//!
//! ```text
//!   threads   1            2                3
//!   needed    middle       middle           middle
//!   ahead                  left quarter     left and right quarter
//! ```

use std::collections::VecDeque;
use std::sync::atomic::{AtomicBool, Ordering};

use serde::Serialize;

use super::{Executor, StudyError};

/// What came of a trial.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum State {
    /// It holds.
    Stable,
    /// It fails.
    Failing,
    /// Neither could be seen. Never counted as stable: the answer is then a wider range.
    Undecided,
}

/// Where a search begins.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Begin {
    /// At 1: it is doubled until something fails, or halved until something holds, at most by the factor `most`.
    One { most: f64 },
    /// Both ends of an interval, either of which may hold.
    Ends { low: f64, high: f64 },
}

/// A search for the limit between values that hold and values that fail. Assumes one limit; with several it finds one of them.
#[derive(Clone, Debug, PartialEq)]
pub struct Search {
    begin: Begin,
    width: f64,
    trials: Vec<(f64, State)>,
}

/// A search whose numbers are none, or whose width is not above zero.
#[derive(Debug, thiserror::Error, PartialEq, Eq)]
#[error("the ends of the range must differ, and its width must be above zero")]
pub struct NotANumber;

impl Search {
    /// A search from 1 on for a factor: what is above the limit fails.
    ///
    /// # Errors
    /// A width that is no number above zero.
    pub fn from_one(most: f64, width: f64) -> Result<Self, NotANumber> {
        Self::new(Begin::One { most }, width)
    }

    /// A search between two values, one of which should hold and the other fail.
    ///
    /// # Errors
    /// Ends that are no numbers or equal, a width that is no number above zero.
    pub fn between(low: f64, high: f64, width: f64) -> Result<Self, NotANumber> {
        if !low.is_finite() || !high.is_finite() || low == high {
            return Err(NotANumber);
        }
        Self::new(Begin::Ends { low, high }, width)
    }

    fn new(begin: Begin, width: f64) -> Result<Self, NotANumber> {
        if !width.is_finite() || width <= 0.0 {
            return Err(NotANumber);
        }
        Ok(Self { begin, width, trials: Vec::new() })
    }

    /// The trials so far, in order.
    #[must_use]
    pub fn trials(&self) -> &[(f64, State)] {
        &self.trials
    }

    /// Adds what came of a trial.
    pub fn add(&mut self, value: f64, state: State) {
        self.trials.push((value, state));
    }

    /// Number of the trial that holds and is nearest to the limit.
    #[must_use]
    pub fn holding(&self) -> Option<usize> {
        self.nearest(State::Stable, self.fails_above())
    }

    /// Number of the trial that fails and is nearest to the limit.
    #[must_use]
    pub fn failing(&self) -> Option<usize> {
        self.nearest(State::Failing, !self.fails_above())
    }

    /// The value that holds and is nearest to the limit.
    #[must_use]
    pub fn holds_at(&self) -> Option<f64> {
        self.holding().map(|k| self.trials[k].0)
    }

    /// The value that fails and is nearest to the limit.
    #[must_use]
    pub fn fails_at(&self) -> Option<f64> {
        self.failing().map(|k| self.trials[k].0)
    }

    /// The middle between both.
    #[must_use]
    pub fn limit(&self) -> Option<f64> {
        Some(0.5 * (self.holds_at()? + self.fails_at()?))
    }

    /// Whether an undecided trial lies between the two, or where one of them is missing.
    #[must_use]
    pub fn undecided(&self) -> bool {
        let undecided = self.trials.iter().filter(|t| t.1 == State::Undecided);
        let mut inside = undecided.filter(|(value, _)| match (self.holds_at(), self.fails_at()) {
            (Some(a), Some(b)) => *value > a.min(b) && *value < a.max(b),
            (Some(_), None) | (None, Some(_)) | (None, None) => true,
        });
        inside.next().is_some()
    }

    /// Whether values above the limit fail.
    fn fails_above(&self) -> bool {
        let Begin::Ends { low, high } = self.begin else {
            return true;
        };
        let of = |end: f64| self.trials.iter().find(|(value, _)| *value == end);
        let upper = low.max(high);
        let lower = low.min(high);
        match (of(lower), of(upper)) {
            (_, Some((_, State::Failing))) | (Some((_, State::Stable)), _) => true,
            (Some(_) | None, Some(_)) | (Some(_), None) | (None, None) => false,
        }
    }

    /// The trial of that state with the largest or the smallest value; the first of equals.
    fn nearest(&self, state: State, largest: bool) -> Option<usize> {
        let all = self.trials.iter().enumerate().filter(|(_, t)| t.1 == state);
        let better = |a: f64, b: f64| if largest { a > b } else { a < b };
        let found = all.fold(None, |best: Option<(usize, f64)>, (k, (value, _))| match best {
            Some((_, old)) if !better(*value, old) => best,
            Some(_) | None => Some((k, *value)),
        });
        found.map(|(k, _)| k)
    }

    /// The value to be tried next; `None` when there is nothing left to try.
    #[must_use]
    pub fn next(&self) -> Option<f64> {
        match self.begin {
            Begin::One { most } => {
                let (Some((_, first)), Some((last, _))) = (self.trials.first(), self.trials.last())
                else {
                    return Some(1.0);
                };
                match first {
                    State::Stable if self.failing().is_none() => {
                        (*last < most).then_some(2.0 * last)
                    }
                    State::Failing | State::Undecided if self.holding().is_none() => {
                        (*last > 1.0 / most).then_some(0.5 * last)
                    }
                    State::Stable | State::Failing | State::Undecided => self.narrower(),
                }
            }
            Begin::Ends { low, high } => match self.trials.len() {
                0 => Some(low),
                1 => Some(high),
                _ => self.narrower(),
            },
        }
    }

    /// The middle of what lies between the value that holds and the one that fails, until it is not wider than asked.
    fn narrower(&self) -> Option<f64> {
        // With the sign, what holds lies below what fails.
        let sign = if self.fails_above() { 1.0 } else { -1.0 };
        let (low, high) = (sign * self.holds_at()?, sign * self.fails_at()?);
        // Undecided trials divide the range in up to three: of the outer two, the wider one is halved.
        let undecided = self.trials.iter().filter(|t| t.1 == State::Undecided);
        let between =
            undecided.map(|(value, _)| sign * value).filter(|value| *value > low && *value < high);
        let (first, last) =
            between.fold((high, low), |(first, last), value| (first.min(value), last.max(value)));
        let (left, right) = (first - low, if first < high { high - last } else { 0.0 });
        if left.max(right) <= self.width {
            return None;
        }
        let [below, above] = if left >= right { [low, first] } else { [last, high] };
        let middle = 0.5 * (below + above);
        // Else the width is finer than the numbers themselves.
        (middle > below && middle < above).then_some(sign * middle)
    }

    /// Up to `most` values that are needed next or may be needed later, the needed one first.
    ///
    /// Where trials are `chained`, each goes on from the nearest one that holds: what comes after one that is not known to hold cannot be
    /// tried ahead.
    fn ahead(&self, most: usize, chained: bool) -> Vec<f64> {
        let mut futures = VecDeque::from([self.clone()]);
        let mut values = Vec::new();
        // Different futures ask for the same values at times.
        for _ in 0..4 * most {
            let Some(future) = futures.pop_front() else {
                break;
            };
            let Some(value) = future.next() else {
                continue;
            };
            if !values.contains(&value) {
                values.push(value);
            }
            if values.len() >= most {
                break;
            }
            for state in [State::Failing, State::Stable] {
                if !(chained && state == State::Stable) {
                    let mut then = future.clone();
                    then.add(value, state);
                    futures.push_back(then);
                }
            }
        }
        values
    }
}

/// A trial to be made.
pub struct Task<'a, R> {
    /// The value.
    pub value: f64,
    /// What came of the nearest trial that holds, where trials go on from it.
    pub from: Option<(f64, &'a R)>,
    /// Threads for it.
    pub threads: usize,
    /// Whether it is needed whatever happens.
    pub needed: bool,
    /// Whether it is to be broken off: somebody wants to stop, or it has turned out to be of no use.
    pub cancelled: &'a (dyn Fn() -> bool + Sync),
}

impl<R> Task<'_, R> {
    /// # Errors
    /// It is to be broken off.
    pub(super) fn goes_on(&self) -> Result<(), StudyError> {
        if (self.cancelled)() { Err(StudyError::Stopped) } else { Ok(()) }
    }
}

/// What a search found.
pub struct Found<R> {
    /// The search at its end.
    pub search: Search,
    /// What the trial nearest to the limit that holds left.
    pub holding: Option<R>,
    /// What the trial nearest to the limit that fails left.
    pub failing: Option<R>,
}

/// Makes the trials of a search, as many at a time as there are threads; `report` is told each in its order.
///
/// `work` makes a trial, and ends with an error when it is cancelled. Trials that are `chained` are given what the nearest one that holds left.
///
/// # Errors
/// What `work` says of a trial that is needed.
///
/// # Examples
///
/// ```
/// use riprap::run::study::Executor;
/// use riprap::run::study::bracket::{Search, State, drive};
///
/// // A column of width 1 m and height h topples on a slope of 20 degrees when h is greater than 1/tan(20 degrees).
/// let steepness = 20f64.to_radians().tan();
/// let topples = |height: f64| if height * steepness > 1.0 { State::Failing } else { State::Stable };
/// let search = Search::between(1.0, 5.0, 1e-3)?;
/// let found = drive::<(), ()>(search, false, &Executor::ALONE, |task| Ok((topples(task.value), ())), |_, _, _| {}).unwrap();
/// assert!((found.search.limit().unwrap() - 1.0 / steepness).abs() < 1e-3);
/// # Ok::<(), riprap::run::study::bracket::NotANumber>(())
/// ```
pub fn drive<R: Send + Sync, E: Send>(
    search: Search,
    chained: bool,
    executor: &Executor<'_>,
    work: impl Fn(&Task<'_, R>) -> Result<(State, R), E> + Sync,
    mut report: impl FnMut(f64, State, &R),
) -> Result<Found<R>, E> {
    let mut found = Found { search, holding: None, failing: None };
    loop {
        let values = found.search.ahead(executor.threads.max(1), chained);
        if values.is_empty() {
            return Ok(found);
        }
        let from = (found.search.holds_at().filter(|_| chained)).zip(found.holding.as_ref());
        let useless: Vec<AtomicBool> = values.iter().map(|_| AtomicBool::new(false)).collect();
        let is_useless = |k: usize| useless[k].load(Ordering::Relaxed);
        let one = |k: &usize| {
            work(&Task {
                value: values[*k],
                from,
                threads: executor.threads / values.len(),
                needed: *k == 0,
                cancelled: &|| (executor.stop)() || is_useless(*k),
            })
        };
        let mut round = Round::new(&found.search, chained);
        let mut wrong = None;
        let numbers: Vec<usize> = (0..values.len()).collect();
        let mut turn = 0;
        executor.on(values.len()).each(&numbers, one, |result| {
            let value = values[turn];
            match result {
                Ok((state, left)) => round.waiting.push((value, state, left)),
                Err(error) if round.now.next() == Some(value) && !is_useless(turn) => {
                    wrong.get_or_insert(error);
                }
                // Cancelled, or made ahead: it is made again, and told, should it be needed.
                Err(_) => {}
            }
            turn += 1;
            round.take(&mut report);
            let over = wrong.is_some() || round.is_over();
            let still = if over { Vec::new() } else { round.now.ahead(values.len(), chained) };
            for (value, useless) in values.iter().zip(&useless) {
                if !still.contains(value) {
                    useless.store(true, Ordering::Relaxed);
                }
            }
        });
        if let Some(wrong) = wrong {
            return Err(wrong);
        }
        round.end(&mut found);
    }
}

/// Trials made at the same time.
struct Round<R> {
    chained: bool,
    /// The value that held when they began.
    held: Option<f64>,
    /// Number of trials before.
    begin: usize,
    /// The search with those that were needed so far.
    now: Search,
    /// Those that may be needed.
    waiting: Vec<(f64, State, R)>,
    /// What those that were needed left, in their order.
    taken: Vec<R>,
}

impl<R> Round<R> {
    fn new(search: &Search, chained: bool) -> Self {
        Self {
            chained,
            held: search.holds_at(),
            begin: search.trials.len(),
            now: search.clone(),
            waiting: Vec::new(),
            taken: Vec::new(),
        }
    }

    /// Whether nothing more of it can be needed: what goes on from a trial that has held since is not what was tried ahead.
    fn is_over(&self) -> bool {
        self.chained && self.now.holds_at() != self.held
    }

    /// Adds the trials that are there to the search as long as they are those that it asks for.
    fn take(&mut self, report: &mut impl FnMut(f64, State, &R)) {
        while !self.is_over() {
            let Some(k) = self.waiting.iter().position(|w| self.now.next() == Some(w.0)) else {
                break;
            };
            let (value, state, left) = self.waiting.swap_remove(k);
            report(value, state, &left);
            self.now.add(value, state);
            self.taken.push(left);
        }
    }

    /// Leaves the search with what the trials nearest to the limit left.
    fn end(self, found: &mut Found<R>) {
        let [holding, failing] = [self.now.holding(), self.now.failing()];
        for (k, left) in (self.begin..).zip(self.taken) {
            if holding == Some(k) {
                found.holding = Some(left);
            } else if failing == Some(k) {
                found.failing = Some(left);
            }
        }
        found.search = self.now;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A search for the limit `at`, of values above it or below it that fail; those within `unsure` of it are undecided.
    fn run(
        search: Search,
        threads: usize,
        chained: bool,
        state: impl Fn(f64) -> State + Sync,
    ) -> (Search, Vec<f64>) {
        let mut told = Vec::new();
        let found = drive::<f64, ()>(
            search,
            chained,
            &Executor::ALONE.on(threads),
            |task| {
                if let Some((value, left)) = task.from {
                    assert_eq!(value, *left);
                }
                // The later, the sooner done.
                if task.needed {
                    std::thread::sleep(std::time::Duration::from_micros(200));
                }
                Ok((state(task.value), task.value))
            },
            |value, state, left| {
                assert_eq!(value, *left);
                told.push((value, state));
            },
        );
        let found = found.unwrap();
        assert_eq!(told, found.search.trials());
        assert_eq!(found.search.holds_at(), found.holding);
        assert_eq!(found.search.fails_at(), found.failing);
        (found.search, told.into_iter().map(|(v, _)| v).collect())
    }

    fn above(limit: f64) -> impl Fn(f64) -> State + Sync {
        move |x| {
            if x > limit { State::Failing } else { State::Stable }
        }
    }

    #[test]
    fn the_limit_is_found_from_both_sides_with_any_number_of_threads() {
        let below = |x: f64| {
            if x < 0.3 { State::Failing } else { State::Stable }
        };
        for (low, high) in [(0.0, 1.0), (1.0, 0.0)] {
            let between = || Search::between(low, high, 1e-3).unwrap();
            let (one, values) = run(between(), 1, false, below);
            let (holds, fails) = (one.holds_at().unwrap(), one.fails_at().unwrap());
            assert!(holds >= 0.3 && fails < 0.3 && holds - fails <= 1e-3);
            assert_eq!(values.len(), 2 + 10);
            let (other, _) = run(between(), 1, false, above(0.7));
            assert!((other.limit().unwrap() - 0.7).abs() < 1e-3);
            for threads in [2, 3, 8] {
                assert_eq!(run(between(), threads, false, below).0, one);
                assert_eq!(run(between(), threads, true, below).0, one);
            }
        }
    }

    #[test]
    fn a_factor_is_doubled_or_halved_from_one() {
        for limit in [0.07, 0.9, 1.0, 1.37, 40.0] {
            let search = || Search::from_one(64.0, 0.01).unwrap();
            let (one, values) = run(search(), 1, true, above(limit));
            assert_eq!(values[0], 1.0);
            let (holds, fails) = (one.holds_at().unwrap(), one.fails_at().unwrap());
            assert!(holds <= limit && limit < fails && fails - holds <= 0.01);
            for (threads, chained) in [(2, true), (4, true), (3, false), (8, false)] {
                assert_eq!(run(search(), threads, chained, above(limit)).0, one);
            }
        }
        let (none, values) = run(Search::from_one(64.0, 0.01).unwrap(), 2, true, above(1e9));
        assert_eq!((none.holds_at(), none.fails_at()), (Some(64.0), None));
        assert_eq!(values, [1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0]);
        let (none, _) = run(Search::from_one(64.0, 0.01).unwrap(), 2, true, above(0.0));
        assert_eq!((none.holds_at(), none.fails_at()), (None, Some(1.0 / 64.0)));
    }

    #[test]
    fn undecided_trials_widen_the_answer_alone() {
        let state = |x: f64| match x {
            x if x > 1.40 => State::Failing,
            x if x > 1.30 => State::Undecided,
            _ => State::Stable,
        };
        let search = || Search::from_one(64.0, 0.01).unwrap();
        let (one, _) = run(search(), 1, true, state);
        assert!(one.undecided());
        let (holds, fails) = (one.holds_at().unwrap(), one.fails_at().unwrap());
        assert!((1.29..=1.30).contains(&holds), "{holds}");
        assert!((1.40..=1.41).contains(&fails), "{fails}");
        for threads in [2, 5] {
            assert_eq!(run(search(), threads, true, state).0, one);
        }
    }

    #[test]
    fn no_limit_no_number_and_trials_that_break() {
        let (same, values) = run(Search::between(0.0, 1.0, 0.1).unwrap(), 3, false, above(-1.0));
        assert_eq!((same.next(), same.limit()), (None, None));
        assert_eq!(values, [0.0, 1.0]);
        for (low, high, width) in
            [(0.0, 1.0, 0.0), (f64::NAN, 1.0, 0.1), (1.0, 1.0, 0.1), (0.0, 1.0, f64::INFINITY)]
        {
            assert_eq!(Search::between(low, high, width), Err(NotANumber));
        }
        // A trial that cannot be made ends the search where it is needed, not where it is made ahead.
        let search = Search::between(0.0, 1.0, 0.1).unwrap();
        let work = |task: &Task<'_, ()>| {
            if task.value == 0.25 { Err("no") } else { Ok((above(0.6)(task.value), ())) }
        };
        assert!(drive(search.clone(), false, &Executor::ALONE.on(8), work, |_, _, ()| {}).is_ok());
        let work = |task: &Task<'_, ()>| {
            if task.value == 0.75 { Err("no") } else { Ok((above(0.6)(task.value), ())) }
        };
        let ended = drive(search, false, &Executor::ALONE.on(8), work, |_, _, ()| {});
        assert_eq!(ended.err(), Some("no"));
    }

    #[test]
    fn a_width_finer_than_the_numbers_ends() {
        let search = Search::between(0.0, 1.0, f64::MIN_POSITIVE).unwrap();
        let below = |x: f64| {
            if x > 0.7 { State::Failing } else { State::Stable }
        };
        let (found, values) = run(search, 2, false, below);
        assert!(found.limit().is_some() && values.len() < 1100, "{}", values.len());
    }
}
