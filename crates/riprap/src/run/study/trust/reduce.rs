//! From what runs gave to values with errors.
//!
//! Of three runs whose cause halves from one to the next, `a`, `b`, `c`, the order is `p = log2((a - b)/(b - c))` and the limit
//! `L = c + (c - b)/(2^p - 1)` (Richardson 1911). Step and size have a limit that is the answer: the value moves there, and what is left as error is
//! 1.25 `|L - c|`, the grid convergence index of Roache (1994) for three grids. Stiffness and damping are numbers of the scene: the value stays, and
//! the error is the way to their limit. Without an order the error is three times what a half changes, Roache's factor for two grids; a run whose steps
//! did not become shorter by as much as was asked for (fast blocks bound them) counts by what they did.

use super::causes::{JITTER, Keys};
use super::{Cause, Check, Part, Result, Spread, Trial};
use crate::plan::shown::Shown;

/// Factor on what an order leaves.
const SEEN: f64 = 1.25;
/// Factor on what a half changes, without an order.
const UNSEEN: f64 = 3.0;
/// Halvings of the step that make that many times more steps are halvings.
const HALVED: [f64; 2] = [1.6, 2.5];
/// A step that is shorter by less than this share says nothing.
const LEAST: f64 = 0.02;
/// Differences fall to less than one over these from run to run where an order is believed: orders of a quarter to five.
const FALL: [f64; 2] = [1.19, 32.0];
/// A change of a thousandth of the step that does this share of what half the step does, and this share of the result, is chaos.
const CHAOS: [f64; 2] = [0.25, 1e-2];
/// Share of the tolerance of a check below which its result is round-off: what is to be 0 has no size of its own.
const ZERO: f64 = 1e-3;
/// Standard deviations in the interval of random realisations.
const DEVIATIONS: f64 = 2.0;
/// A share of the result above which what moves it is asked to be looked at.
const LARGE: f64 = 0.2;

/// Values of a result over a cause, by factor.
fn values(trials: &[Trial], cause: Cause, k: usize) -> Vec<(f64, f64)> {
    let of = trials.iter().filter(|one| one.cause == Some(cause));
    let found = of.filter_map(|one| Some((one.factor, one.values[k].filter(|v| v.is_finite())?)));
    found.collect()
}

/// Whether the factor is that of a run that shows chaos.
fn is_jitter(factor: f64) -> bool {
    factor < 1.0 && factor > 0.9
}

/// What is round-off of a result whatever its size.
fn zero(ask: &Check) -> f64 {
    ZERO * ask.absolute.unwrap_or(0.0)
}

/// Which results are chaotic.
pub(super) fn chaotic(trials: &[Trial], asks: &[Check]) -> Vec<bool> {
    let is = |(k, ask): (usize, &Check)| {
        let base = trials[0].values[k]?;
        let of = values(trials, Cause::Step, k);
        let at = |factor: f64| of.iter().find(|(f, _)| *f == factor).map(|(_, v)| (v - base).abs());
        let (small, half) = (at(JITTER)?, at(0.5)?);
        Some(small > CHAOS[0] * half && small > (CHAOS[1] * base.abs()).max(zero(ask)))
    };
    asks.iter().enumerate().map(|one| is(one).unwrap_or(false)).collect()
}

/// A result with its error. `target` is what its check expects, `note` why the scene as it stands gives no value.
pub(super) fn result(
    k: usize,
    ask: &Check,
    (target, note): (Option<f64>, &str),
    trials: &[Trial],
    chaotic: bool,
    (keys, size): (&Keys, f64),
) -> Result {
    let unit = ask.window.unit(&ask.unit).to_owned();
    let as_run = trials[0].values[k].unwrap_or(f64::NAN);
    let shown = ask.shown.clone().filter(|_| unit == ask.unit);
    let shown = shown.unwrap_or_else(|| Shown::suited(&unit, as_run));
    let unit = if unit == "-" { String::new() } else { unit };
    let mut result = Result {
        name: ask.name.clone(),
        unit,
        as_run,
        value: as_run,
        error: f64::NAN,
        parts: Vec::new(),
        chaotic: None,
        advice: String::new(),
        expected: target.filter(|target| target.is_finite()),
        tolerance: target.map_or(0.0, |target| {
            let relative = ask.relative.unwrap_or(0.0) * target.abs();
            relative.max(ask.absolute.unwrap_or(0.0))
        }),
        shown,
    };
    if !as_run.is_finite() {
        result.advice = format!("the scene as it stands gives no value: {note}");
        return result;
    }
    result.parts = Cause::ALL.into_iter().filter_map(|cause| part(trials, cause, k)).collect();
    if result.parts.is_empty() {
        result.advice = "nothing was varied: its error is not known".to_owned();
        return result;
    }
    if chaotic {
        let spread = Spread::of(trials, k);
        scatter(&mut result, &spread, trials, k);
        result.error = result.parts.iter().map(|part| part.error).sum();
        result.chaotic = Some(spread);
        result.advice = "chaotic: a step that is 0.1 % shorter changes it as much as half the step; give it as a distribution (more runs \
                         narrow the mean; with a smaller `safety` of its phases the spread may be narrower, which these runs do not show)"
            .to_owned();
        return result;
    }
    let moved: f64 = result.parts.iter().map(|part| part.moved).sum();
    let parts: f64 = result.parts.iter().map(|part| part.error).sum();
    result.value = as_run + moved;
    // Places are as exact as the size of the model allows.
    let size = if result.unit == "m" { as_run.abs().max(size) } else { as_run.abs() };
    result.error = parts + round_off(trials[0].steps, size) + zero(ask);
    result.advice = advice(&result, parts, keys);
    result
}

/// The parts of a chaotic result: the scatter over the steps, and of other causes what goes beyond it.
fn scatter(result: &mut Result, spread: &Spread, trials: &[Trial], k: usize) {
    result.value = spread.mean;
    let band = DEVIATIONS * spread.deviation;
    for part in &mut result.parts {
        (part.moved, part.order) = (0.0, None);
        part.error = match part.cause {
            Cause::Step => band,
            other => (farthest(&values(trials, other, k), spread.mean) - band).max(0.0),
        };
    }
}

/// What adding up numbers of this size loses: half a unit in the last digit with every step, and four digits for what is read.
fn round_off(steps: u64, size: f64) -> f64 {
    (steps as f64 + 1e4) * f64::EPSILON * size
}

/// What a cause adds.
fn part(trials: &[Trial], cause: Cause, k: usize) -> Option<Part> {
    let base = trials[0].values[k]?;
    if cause == Cause::Search {
        let error = trials[0].half?;
        return Some(Part { cause, error, moved: 0.0, order: None });
    }
    let found = values(trials, cause, k);
    if found.is_empty() {
        return None;
    }
    let part = match cause {
        Cause::Step => {
            let (close, far): (Vec<_>, Vec<_>) = found.iter().partition(|(f, _)| is_jitter(*f));
            let noise = farthest(&close, base);
            let mut part = match steps_scale(trials) {
                true => ladder(cause, base, &far, true),
                false => Part { cause, error: by_steps(trials, k), moved: 0.0, order: None },
            };
            // The reading itself may jump with the step: what a thousandth does cannot be extrapolated.
            part.error = part.error.max(UNSEEN * noise);
            part
        }
        Cause::Size => ladder(cause, base, &found, true),
        Cause::Stiffness => {
            let falling: Vec<_> = found.iter().map(|(f, v)| (1.0 / f, *v)).collect();
            ladder(cause, base, &falling, false)
        }
        Cause::Equilibrium | Cause::Damping => ladder(cause, base, &found, false),
        Cause::Seed => {
            let all = found.iter().map(|(_, v)| *v).chain([base]).collect::<Vec<f64>>();
            let error = DEVIATIONS * mean_and_deviation(&all).1;
            Part { cause, error, moved: 0.0, order: None }
        }
        Cause::Search => return None,
    };
    Some(part)
}

/// Runs with a shorter step, and what their steps were over those of the scene as it stands.
fn shorter(trials: &[Trial]) -> impl Iterator<Item = (&Trial, f64)> {
    let base = trials[0].steps as f64;
    let of_step = trials.iter().filter(|one| one.cause == Some(Cause::Step));
    let far = of_step.filter(|one| !is_jitter(one.factor) && one.steps > 0);
    far.map(move |one| (one, base / one.steps as f64))
}

/// Whether runs with half the step have about twice as many.
fn steps_scale(trials: &[Trial]) -> bool {
    shorter(trials).all(|(one, share)| {
        let each = libm::pow(1.0 / share, libm::log(2.0) / -libm::log(one.factor));
        each > HALVED[0] && each < HALVED[1]
    })
}

/// The error of steps that became shorter by other shares than was asked for.
fn by_steps(trials: &[Trial], k: usize) -> f64 {
    let base = trials[0].values[k].unwrap_or(f64::NAN);
    let of = shorter(trials).filter_map(|(one, share)| {
        let differs = (one.values[k]? - base).abs();
        Some(0.5 * UNSEEN * differs / (1.0 - share).max(LEAST))
    });
    of.fold(0.0, f64::max)
}

fn farthest(found: &[(f64, f64)], base: f64) -> f64 {
    found.iter().map(|(_, v)| (v - base).abs()).fold(0.0, f64::max)
}

/// The error of a cause from the values at some factors of it, which falls towards 0; `moves` says that the limit is the answer.
fn ladder(cause: Cause, base: f64, found: &[(f64, f64)], moves: bool) -> Part {
    let mut all = found.to_vec();
    all.push((1.0, base));
    all.sort_by(|a, b| b.0.total_cmp(&a.0));
    let differs = farthest(found, base);
    let plain = Part { cause, error: UNSEEN * differs, moved: 0.0, order: None };
    let halves = |pair: &[(f64, f64)]| (pair[0].0 / pair[1].0 - 2.0).abs() < 1e-9;
    if let [.., (_, a), (_, b), (_, c)] = all[..]
        && all[all.len() - 3..].windows(2).all(halves)
    {
        let fall = (a - b) / (b - c);
        if fall.is_finite() && fall > FALL[0] && fall < FALL[1] {
            let limit = c + (c - b) / (fall - 1.0);
            let error = SEEN * if moves { (limit - c).abs() } else { (limit - base).abs() };
            let moved = if moves { limit - base } else { 0.0 };
            return Part { error, moved, order: Some(libm::log2(fall)), ..plain };
        }
    }
    plain
}

fn mean_and_deviation(all: &[f64]) -> (f64, f64) {
    let n = all.len() as f64;
    let mean = all.iter().sum::<f64>() / n;
    let squares: f64 = all.iter().map(|v| (v - mean) * (v - mean)).sum();
    (mean, libm::sqrt(squares / (n - 1.0).max(1.0)))
}

impl Spread {
    fn of(trials: &[Trial], k: usize) -> Self {
        // Other causes change what the scene is.
        let of_step = trials.iter().filter(|one| matches!(one.cause, None | Some(Cause::Step)));
        let all = of_step.filter_map(|one| one.values[k]).filter(|v| v.is_finite());
        let all: Vec<f64> = all.collect();
        let (mean, deviation) = mean_and_deviation(&all);
        let least = all.iter().copied().fold(f64::INFINITY, f64::min);
        let largest = all.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        Spread { samples: all.len(), mean, deviation, least, largest }
    }
}

/// Which key halves the error.
fn advice(result: &Result, parts: f64, keys: &Keys) -> String {
    let largest = result.parts.iter().max_by(|a, b| a.error.total_cmp(&b.error));
    let Some(largest) = largest.filter(|part| part.error > 0.0 && parts > 0.0) else {
        return String::new();
    };
    let share = largest.error / parts;
    if largest.cause == Cause::Search {
        return format!(
            "half the width of the search halves the share of search ({:.0} %): --width",
            100.0 * share
        );
    }
    let order = largest.order.unwrap_or(1.0);
    let of_scene = matches!(largest.cause, Cause::Stiffness | Cause::Damping);
    if of_scene && largest.error > LARGE * result.as_run.abs() {
        let word = largest.cause.word();
        return format!(
            "it goes with the {word} itself; where that was measured it is no error: leave it out (--without {word})"
        );
    }
    match keys.halving(largest.cause, order) {
        Some(key) => {
            format!("{key} halves the share of {} ({:.0} %)", largest.cause.word(), 100.0 * share)
        }
        None => {
            format!("{:.0} % is the spread of realisations: no key makes it smaller", 100.0 * share)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn points(of: impl Fn(f64) -> f64, factors: &[f64]) -> Vec<(f64, f64)> {
        factors.iter().map(|f| (*f, of(*f))).collect()
    }

    #[test]
    fn an_order_is_seen_and_the_limit_lies_inside() {
        for order in [0.5, 1.0, 2.0, 4.0] {
            let of = |f: f64| 3.0 + 0.1 * f.powf(order) + 0.01 * f.powf(order + 1.0);
            let part = ladder(Cause::Step, of(1.0), &points(of, &[0.5, 0.25]), true);
            assert!((part.order.unwrap() - order).abs() < 0.25, "{part:?}");
            let value = of(1.0) + part.moved;
            assert!((value - 3.0).abs() <= part.error, "{part:?}");
            assert!(part.error < 0.1, "{part:?}");
            // Of a number of the scene the value stays, and the limit is still inside.
            let kept = ladder(Cause::Stiffness, of(1.0), &points(of, &[0.5, 0.25]), false);
            assert!(kept.moved == 0.0 && (of(1.0) - 3.0).abs() <= kept.error, "{kept:?}");
        }
    }

    #[test]
    fn without_an_order_the_largest_difference_counts() {
        let part = ladder(Cause::Step, 1.0, &[(0.5, 1.1), (0.25, 0.9)], true);
        assert!(part.order.is_none() && part.moved == 0.0, "{part:?}");
        assert!((part.error - 0.3).abs() < 1e-12, "{part:?}");
        let two = ladder(Cause::Equilibrium, 1.0, &[(0.25, 1.01)], false);
        assert!((two.error - 0.03).abs() < 1e-12, "{two:?}");
    }

    #[test]
    fn steps_that_something_else_bounds_count_by_what_they_did() {
        let trial = |cause, factor, value, steps| Trial {
            cause,
            factor,
            values: vec![Some(value)],
            steps,
            seconds: 0.0,
            half: None,
            note: String::new(),
        };
        let step = Some(Cause::Step);
        // A tenth more steps for half the safety: the true way to no step at all is eleven times as long.
        let bound = [trial(None, 1.0, 1.0, 1000), trial(step, 0.5, 1.01, 1100)];
        assert!(!steps_scale(&bound));
        assert!((by_steps(&bound, 0) - 1.5 * 0.01 * 11.0).abs() < 1e-9);
        let free = [trial(None, 1.0, 1.0, 1000), trial(step, 0.25, 1.01, 4100)];
        assert!(steps_scale(&free));
    }

    #[test]
    fn a_coarser_and_a_finer_size_are_three_grids() {
        let of = |f: f64| 1.0 - 0.2 * f * f;
        let part = ladder(Cause::Size, of(1.0), &points(of, &[2.0, 0.5]), true);
        assert!((part.order.unwrap() - 2.0).abs() < 1e-9, "{part:?}");
        assert!((of(1.0) + part.moved - 1.0).abs() < 1e-12, "{part:?}");
    }
}
