//! What is left of a run after its trial.

use super::trial::Mark;
use super::{may_rest, relaxing};
use crate::plan::{Integration, Phase, Plan};

/// Steps that are still to come and the CPU time that they take, s.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Ahead {
    pub(super) steps: f64,
    pub(super) cpu: f64,
    /// Whether a phase that is still to come may end before: the numbers are then the most.
    pub(super) at_most: bool,
}

/// Touching contacts for each loose block once all of them rest: 1 where rocks lie scattered on a slope, 2.5 in a heap.
const RESTING: f64 = 1.5;
/// Touching contacts from which what they cost is read off the trial.
const FEW: f64 = 2.0;

/// What is known of a run beside its trial.
#[derive(Clone, Copy, Debug)]
pub(super) struct Known {
    /// Blocks that are apart at the start and will come to rest on others.
    pub(super) falling: usize,
    /// Step that contacts leave at the end of the trial, s, which they will leave in the phases to come.
    pub(super) contacts: f64,
    /// When a phase that goes on until the model rests is taken to end, s after its beginning.
    pub(super) rest: Option<f64>,
}

impl Known {
    /// When a phase is taken to end by rest, s after its beginning.
    fn rest_of(&self, phase: &Phase) -> Option<f64> {
        self.rest.filter(|_| phase.until.rest.is_some())
    }
}

/// Reckons the rest of a run from the later half of what was tried of the present phase; none where a phase has no end that can be seen
/// from there. `wanted` is the step that the plan asks for, s.
pub(super) fn ahead(
    plan: &Plan,
    marks: &[Mark],
    wanted: &dyn Fn(&Phase) -> f64,
    known: Known,
) -> Option<Ahead> {
    let last = marks.last()?;
    let Some(phase) = plan.phases.get(last.phase) else {
        return Some(Ahead::default());
    };
    let from = later_half(marks, last)?;
    let (steps, cpu) = ((last.steps - from.steps) as f64, last.cpu - from.cpu);
    if steps == 0.0 || cpu <= 0.0 {
        return None;
    }
    let by_rest = known.rest_of(phase).and_then(|rest| until_rest(rest, marks, &from, last));
    let times = match (by_rest, repeats(phase, &from, last)) {
        (Some(rest), others) => (others.map_or(rest, |(times, _)| rest.min(times)), false),
        (None, others) => others?,
    };
    let falling = known.falling;
    let dearer = if is_explicit(phase) { resting(marks, &from, last, falling) } else { 1.0 };
    let cost = dearer * cpu / steps;
    let (times, at_most) = times;
    let mut ahead = Ahead { steps: times * steps, cpu: times * steps * cost, at_most };
    for phase in &plan.phases[last.phase + 1..] {
        let limit = if is_explicit(phase) { known.contacts } else { f64::INFINITY };
        let step = wanted(phase).min(limit);
        let span = phase.until.time.filter(|_| relaxing(phase).is_none());
        let rest = known.rest_of(phase);
        let span = span.into_iter().chain(rest).reduce(f64::min);
        let by_time = span.map_or(f64::INFINITY, |span| (span / step).ceil());
        let by_count = phase.until.steps.map_or(f64::INFINITY, |n| n as f64);
        let steps = by_time.min(by_count);
        if !steps.is_finite() {
            return None;
        }
        ahead.at_most |= may_rest(phase) && rest.is_none();
        ahead.steps += steps;
        ahead.cpu += steps * cost;
    }
    Some(ahead)
}

/// The last mark of the first half of the CPU time that was spent on the present phase; a phase that has just begun is told by all.
fn later_half(marks: &[Mark], last: &Mark) -> Option<Mark> {
    let mut own = marks.iter().filter(|mark| mark.phase == last.phase);
    let first = own.next()?;
    let middle = 0.5 * (first.cpu + last.cpu);
    Some(*own.take_while(|mark| mark.cpu <= middle).last().unwrap_or(first))
}

/// How many times more a step costs once so many blocks rest, by what the contacts cost that touch between two marks.
fn resting(marks: &[Mark], from: &Mark, last: &Mark, falling: usize) -> f64 {
    let cost = |from: &Mark, last: &Mark| (last.cpu - from.cpu) / (last.steps - from.steps) as f64;
    let own = marks.iter().filter(|mark| mark.steps > from.steps && mark.steps <= last.steps);
    let own: Vec<f64> = own.map(|mark| mark.contacts as f64).collect();
    let touching = own.iter().sum::<f64>() / own.len().max(1) as f64;
    let then = RESTING * falling as f64;
    if touching < FEW || then <= touching {
        return 1.0;
    }
    // What a step costs without contacts: as long as there were none.
    let free = marks.iter().take_while(|mark| mark.contacts == 0).last();
    let free = free.filter(|mark| mark.steps > marks[0].steps);
    let free = free.map_or(0.0, |mark| cost(&marks[0], mark));
    let now = cost(from, last);
    (free + (now - free).max(0.0) * then / touching) / now
}

/// How many times what lies between two marks of a phase is still to come: by its time, its count of steps or the unbalanced force,
/// which falls by the same factor in each.
/// With it whether the phase may end before.
fn repeats(phase: &Phase, from: &Mark, last: &Mark) -> Option<(f64, bool)> {
    // Iterations of load steps are no shares of anything.
    if relaxing(phase).is_some() {
        return None;
    }
    let grown =
        |[from, last]: [f64; 2]| (last > from).then(|| (1.0 - last).max(0.0) / (last - from));
    let by_share = from.share.zip(last.share).and_then(|(a, b)| grown([a, b]));
    let fallen = |((wanted, from), last): ((f64, f64), f64)| {
        let falls = last < 0.9 * from && wanted > 0.0;
        falls.then(|| (libm::log(last / wanted) / libm::log(from / last)).max(0.0))
    };
    let by_force =
        phase.until.unbalanced.zip(from.unbalanced).zip(last.unbalanced).and_then(fallen);
    match (by_share, by_force) {
        (Some(a), Some(b)) => Some((a.min(b), false)),
        (None, Some(b)) => Some((b, false)),
        (a, None) => a.map(|a| (a, may_rest(phase))),
    }
}

/// How many times what lies between two marks of a phase is still to come until it rests so long after its beginning (s), a tenth of that at least.
fn until_rest(rest: f64, marks: &[Mark], from: &Mark, last: &Mark) -> Option<f64> {
    let begun = marks.iter().find(|mark| mark.phase == last.phase)?.time;
    let left = (rest - (last.time - begun)).max(0.1 * rest);
    (last.time > from.time).then(|| left / (last.time - from.time))
}

fn is_explicit(phase: &Phase) -> bool {
    phase.integration != Integration::Implicit
}
