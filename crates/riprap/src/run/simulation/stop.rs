//! When a phase is over, and when a run is stopped.

use super::cause;
use super::cursor::{Deep, Into, Reason};
use super::{Rules, RunError, Simulation};
use crate::ledger::{COLUMNS, Unexplained};
use crate::plan::{PhaseKind, Relaxing};
use crate::planar::setup::NormalLaw;
use crate::run::engine::View;
use crate::spatial::limits;
use crate::spatial::limits::Depth;
use crate::spatial::{Deepest, Pressed};

/// Overlap over the smaller inscribed radius at which a run is stopped: beyond 1 blocks pass through.
const WORST_OVERLAP: f64 = 0.5;
/// Share of its neighbourhood's inscribed radius that a block crosses at most between two looks at overlaps: a fast block would
/// come out on the far side of another one between looks that only steps bring about.
const CROSSED: f64 = 0.2;
/// Steps between two looks at guards and at costly stop criteria.
const CHECK_INTERVAL: u64 = 50;
/// Steps between two drawings of the ledger: one costs as much as some steps.
const LEDGER: u64 = 1000;
/// Residual over the largest energy exchanged above which a run is warned of.
const NOTED: f64 = 0.01;
/// The same of what a law without potential makes by itself.
const TOLD: f64 = 0.1;
/// Kinetic energy over the energy put in at which a run is stopped.
const BLOW_UP: f64 = 5.0;
/// Share of the largest work so far that kinetic energy may have besides: what was put in may be next to nothing at this moment, where
/// a block that fell is back at its height. What is missing by then is judged by the ledger.
const LEFT_TO_LEDGER: f64 = 0.1;
/// Steps of balance by dashpots after which a static phase is taken to sink for ever.
const SINKING: u64 = 1000;
/// Share of what they carried that dashpots must still carry then.
const STILL_BORNE: f64 = 0.9;
/// Energies below that of the whole model at this speed (m/s) are round-off, and no residual is judged by them.
const STILL: f64 = 1e-6;

/// Whether something that is looked at every `rhythm` steps is due after `step` steps; at the start more often, since what
/// is wrong from the beginning shows there: after 1, `growth`, `growth`², ... steps.
fn due(step: u64, rhythm: u64, growth: u32) -> bool {
    let early = || (0..).map(|n| u64::from(growth).saturating_pow(n)).take_while(|s| *s < rhythm);
    step.is_multiple_of(rhythm) || (step < rhythm && early().any(|s| s == step))
}

/// What is no number of a block and `other`.
fn how_deep(other: &str) -> String {
    format!("its overlap with block `{other}`")
}

impl Simulation {
    /// Why the present phase is over, if it is.
    pub(super) fn phase_over(&self, phase: &Rules) -> Option<Reason> {
        let until = &phase.until;
        let steps = self.steps() - self.cursor.start_step;
        if until.steps.is_some_and(|n| steps >= n) {
            return Some(Reason::Steps);
        }
        if let Some(rules) = phase.relax {
            return self.relaxed(phase, rules);
        }
        let elapsed = self.elapsed();
        // Times are sums of steps: one that ends a phase may fall short of its span by round-off.
        if until.time.is_some_and(|t| elapsed >= t - 1e-9 * self.dt) {
            return Some(Reason::Time);
        }
        // Not at its first state: the phase before may have left that in balance, and what this one changes has had no step
        // to act.
        let settled = steps > 0 && (phase.settles || steps.is_multiple_of(CHECK_INTERVAL));
        let ramped = phase.ramp.is_none_or(|ramp| elapsed >= ramp);
        if !settled || !ramped {
            return None;
        }
        if let Some(wanted) = until.unbalanced
            && self.view().unbalanced() <= wanted
            // A long step is short of the balance of where it leads by little, however far that is.
            && (!phase.settles || self.engine.settling_way() <= wanted)
        {
            // Forces of dashpots are there only as long as something moves: balance by them is no rest.
            match self.sinking().filter(|(share, _)| *share > wanted) {
                None => return Some(Reason::Balanced),
                Some(_) if self.sinks_for_ever() => return Some(Reason::Sinking),
                Some(_) => {}
            }
        }
        let at_rest = until.kinetic.is_some_and(|x| self.view().kinetic() <= x);
        // Rest that the phase before has seen does not count: this one may have removed what held.
        let since = self.cursor.resting_since.map(|since| since.max(self.cursor.start_time));
        let rests = until.rest.zip(since).is_some_and(|(rest, t)| self.time() - t >= rest.hold);
        (at_rest || rests).then_some(Reason::AtRest)
    }

    /// Whether the end of a phase, or a guard, reads the present state.
    pub(super) fn looks_at(&self, phase: &Rules) -> bool {
        let (step, until) = (self.steps(), &phase.until);
        let steps = step - self.cursor.start_step;
        let ends = until.steps.is_some_and(|n| steps >= n)
            || until.time.is_some_and(|t| self.elapsed() >= t - 1e-9 * self.dt);
        let waits = until.unbalanced.is_some() || until.kinetic.is_some() || until.rest.is_some();
        let judged = waits && steps.is_multiple_of(CHECK_INTERVAL);
        // A phase begins with a state that is written.
        steps == 0 || ends || judged || due(step, CHECK_INTERVAL, 2) || due(step, LEDGER, 8)
    }

    /// Notes the largest kinetic energy, and since when the model rests as the phase asks.
    fn note_rest(&mut self) {
        let kinetic = self.view().kinetic();
        self.cursor.kinetic_peak = self.cursor.kinetic_peak.max(kinetic);
        let rests = self.phase().and_then(|phase| phase.until.rest).is_some_and(|rest| {
            let view = self.view();
            let waits = view.spatial().is_some_and(|v| {
                let mut cavities = v.world.cavities.iter();
                cavities.any(|cavity| cavity.ignited.is_none())
            });
            !waits
                && kinetic <= rest.share * self.cursor.kinetic_peak
                && view.fastest().is_none_or(|(_, speed)| speed <= rest.speed)
        });
        let since = self.cursor.resting_since.unwrap_or(self.time());
        self.cursor.resting_since = rests.then_some(since);
    }

    /// Whether what the dashpots of a static phase carry has hardly fallen in many steps of balance.
    fn sinks_for_ever(&self) -> bool {
        let (now, noted) = (self.sinking(), self.cursor.noted.sinking);
        let (Some((share, _)), Some((since, then))) = (now, noted) else {
            return false;
        };
        self.steps() >= since + SINKING && share > STILL_BORNE * then
    }

    /// Notes since when the forces of a static phase are balanced by dashpots; anew where these have given up much of what they carried.
    fn note_sinking(&mut self) {
        let wanted = self.phase().and_then(|p| p.until.unbalanced);
        // Asked last: it costs as much as a step.
        let balanced = || wanted.is_some_and(|x| self.view().unbalanced() <= x);
        let now = self.sinking().filter(|_| balanced());
        let noted = self.cursor.noted.sinking;
        self.cursor.noted.sinking = match (now, noted) {
            (None, _) => None,
            (Some((share, _)), Some((since, then))) if share > STILL_BORNE * then => {
                Some((since, then))
            }
            (Some((share, _)), _) => Some((self.steps(), share)),
        };
    }

    /// Whether a relaxing phase is over: all its time has passed and nothing moves or breaks any more, or it does
    /// not converge.
    fn relaxed(&self, phase: &Rules, rules: Relaxing) -> Option<Reason> {
        let Some(now) = self.engine.relaxing() else {
            return Some(Reason::Balanced);
        };
        let all = phase.until.time.is_none_or(|span| self.elapsed() >= span * (1.0 - 1e-9));
        if now.converged && all {
            Some(Reason::Balanced)
        } else {
            (now.iterations >= rules.iterations).then_some(Reason::Iterations)
        }
    }

    /// Stops runs that have left the range in which they mean anything; `over`: the phase has come to its end.
    pub(super) fn guard(&mut self, over: bool) -> Result<(), RunError> {
        let step = self.steps();
        self.look_at_depth()?;
        self.look_at_seepage()?;
        self.look_at_controls()?;
        let due = over || due(step, CHECK_INTERVAL, 2);
        if due || self.cursor.crossed >= CROSSED {
            // Every look counts, whatever it was due for: the way is that since the last one.
            self.cursor.crossed = 0.0;
            self.look_at_overlap()?;
        }
        if due {
            self.look_at_motion()?;
            self.note_motion();
            self.note_sinking();
            self.note_rest();
        }
        if over || self::due(step, LEDGER, 8) {
            self.look_at_strain(over)?;
            // Works of steps that forget velocities are those of a way in straight lines, and no measure of an error.
            if !self.phase().is_some_and(|phase| self.settles(phase)) {
                self.look_at_ledger(over)?;
            }
        }
        Ok(())
    }

    /// Stops a run whose seepage was not found.
    fn look_at_seepage(&self) -> Result<(), RunError> {
        let view = self.view();
        let left = match &view {
            View::Planar(v) => v.world.seepage.as_ref().map(|f| (f.left, f.is_found())),
            View::Spatial(v) => v.world.seepage.as_ref().map(|f| (f.left, f.is_found())),
        };
        match left.and_then(|(left, found)| (!found).then_some(left)) {
            Some(left) => Err(RunError::NoFlow { left, step: self.steps(), time: self.time() }),
            None => self.look_at_gas(),
        }
    }

    /// Stops a run whose gas has not found its way through the cracks.
    fn look_at_gas(&self) -> Result<(), RunError> {
        let View::Spatial(view) = self.view() else { return Ok(()) };
        match view.stuck_gas() {
            Some((place, left)) => {
                Err(RunError::NoGasFlow { place, left, step: self.steps(), time: self.time() })
            }
            None => Ok(()),
        }
    }

    /// Notes how deep found contacts are, and stops a run in which two blocks would come out on each other's far side; at every step,
    /// since a few steps can be enough.
    fn look_at_depth(&mut self) -> Result<(), RunError> {
        match self.view().deepest_contact() {
            Some(found) => self.judge(&found),
            None => Ok(()),
        }
    }

    /// Stops a run for a depth, or notes it.
    fn judge(&mut self, found: &Deepest) -> Result<(), RunError> {
        if !found.depth.is_finite() {
            let [block, other] = found.ends;
            return Err(self.not_finite(block, &how_deep(&self.view().name(other))));
        }
        match limits::judge(found.ratio, 1.0) {
            Depth::TooDeep => return Err(self.too_deep(found)),
            // Only the deepest one is reported at the end, so that a long run leaves one warning and not thousands.
            Depth::Deep if found.ratio > self.cursor.deepest.as_ref().map_or(0.0, |d| d.ratio) => {
                let (names, into) = self.pressed(found);
                self.cursor.deepest = Some(Deep {
                    ratio: found.ratio,
                    depth: found.depth,
                    blocks: names,
                    into,
                    step: self.steps(),
                    time: self.time(),
                });
            }
            Depth::Deep | Depth::Fine => {}
        }
        Ok(())
    }

    /// Names of what is pressed, and what the second one is.
    fn pressed(&self, found: &Deepest) -> ([String; 2], Into) {
        let view = self.view();
        let names = found.ends.map(|b| view.name(b));
        match found.pressed {
            Pressed::Contact | Pressed::NoSurface | Pressed::Joint => (names, Into::Block),
            Pressed::Condition(k) => {
                let [block, _] = names;
                let name = view.spatial().map_or_else(String::new, |v| {
                    v.world.setup.boundaries[usize::from(k)].name.clone()
                });
                ([block, name], Into::Condition)
            }
        }
    }

    /// The error for two blocks that lie too deep in each other, or have no surface on which they could press each other.
    fn too_deep(&self, found: &Deepest) -> RunError {
        let (names, into) = self.pressed(found);
        RunError::pressed(names, into, [found.depth, found.reach], || {
            (cause::of_step(self), self.steps(), self.time())
        })
    }

    /// The error for forces on a block that are no numbers: two blocks so deep in each other that none can be found, or what is to
    /// blame otherwise.
    pub(super) fn no_force(&self, block: u32) -> RunError {
        if let Some(failed) = self.engine.not_solved().filter(|failed| failed.rounds > 0) {
            let blocks = failed.blocks.map(|b| self.view().name(b));
            let (step, time) = (self.steps(), self.time());
            return RunError::NotSolved { blocks, rounds: failed.rounds, dt: self.dt, step, time };
        }
        let deepest = self.view().deepest_contact();
        let without = |d: &Deepest| d.pressed == Pressed::NoSurface;
        let blamed = |d: &Deepest| limits::judge(d.ratio, 1.0) == Depth::TooDeep || without(d);
        match deepest.filter(|d| d.depth.is_finite() && blamed(d)) {
            Some(found) => self.too_deep(&found),
            None => (self.turned_inside_out(block))
                .unwrap_or_else(|| self.not_finite(block, "the force on it")),
        }
    }

    /// Stops a run in which two blocks lie too deep in each other. A model that is built so has its first steps to push them apart.
    fn look_at_overlap(&mut self) -> Result<(), RunError> {
        let (step, time) = (self.steps(), self.time());
        let view = self.view();
        let view = match view {
            View::Planar(_) => view,
            // Closings on the way to an equilibrium mean nothing.
            View::Spatial(_) if self.relaxes() && !self.settled() => return Ok(()),
            // Found contacts are looked at in every step.
            View::Spatial(v) => {
                return match v.deepest_joint() {
                    Some(found) => self.judge(&found),
                    None => Ok(()),
                };
            }
        };
        let Some((ratio, i, j)) = view.worst_overlap() else {
            return Ok(());
        };
        if !ratio.is_finite() {
            return Err(self.not_finite(i, &how_deep(&view.name(j))));
        }
        let given = step < CHECK_INTERVAL && self.cursor.overlap_at_start > WORST_OVERLAP;
        if step > 0 && ratio > WORST_OVERLAP && !given {
            return Err(RunError::Overlap {
                first: view.name(i),
                second: view.name(j),
                percent: 100.0 * ratio,
                ruled_out: cause::of_step(self),
                step,
                time,
            });
        }
        if step == 0 {
            self.cursor.overlap_at_start = ratio;
        }
        Ok(())
    }

    /// That all numbers are numbers is looked at from the first state on; how large they are only when the model had some
    /// steps to come to itself.
    fn look_at_motion(&self) -> Result<(), RunError> {
        let (step, time) = (self.steps(), self.time());
        let judged = step >= CHECK_INTERVAL;
        let view = self.view();
        let kinetic = view.kinetic();
        if !kinetic.is_finite() {
            return Err(self.no_number("the kinetic energy"));
        }
        let mut put_in = view.put_in();
        if self.phase().is_some_and(|phase| phase.kind == PhaseKind::Static) {
            // In a static phase blocks that were built into each other push apart and
            // are damped: no fault, and no load has put that in.
            put_in += view.released_by_overlaps();
        }
        if !put_in.is_finite() {
            return Err(self.no_number("the energy input of loads, supports and gravity"));
        }
        let bearable = BLOW_UP * put_in + LEFT_TO_LEDGER * view.largest_work();
        // Where nothing has been put in and nothing has worked the bound is zero, and round-off alone is above that.
        if judged && kinetic > bearable + 1e-12 {
            return Err(RunError::BlowUp {
                block: view.fastest().map_or_else(String::new, |(name, _)| name),
                kinetic: kinetic * view.slice(),
                unit: self.kind().energy_unit(),
                ratio: kinetic / put_in.max(f64::MIN_POSITIVE),
                ruled_out: cause::of_step(self),
                step,
                time,
            });
        }
        Ok(())
    }

    /// Draws up the ledger: all its terms are numbers, and what it cannot explain is small.
    fn look_at_ledger(&mut self, over: bool) -> Result<(), RunError> {
        let balance = self.balance();
        for (name, get) in COLUMNS {
            if !get(&balance).is_finite() {
                return Err(self.no_number(&format!("the energy `{name}`")));
            }
        }
        let rhythm = over || self.steps() >= LEDGER;
        if !rhythm || self.relaxes() && !over {
            // In the first steps next to nothing has moved; on the way to an equilibrium the kinetic energy is that of
            // fictitious masses.
            return Ok(());
        }
        let (step, time) = (self.steps(), self.time());
        let allowed = self.phase().map_or(f64::INFINITY, |p| p.max_residual);
        for (k, what) in Unexplained::ALL.into_iter().enumerate() {
            let (energy, share) = (what.of(&balance), balance.share(what));
            // What contacts make or lose between iterations is damped away on the way to an equilibrium that is none of a motion.
            let of_way =
                self.relaxes() && matches!(what, Unexplained::LawDefect | Unexplained::Steps);
            if of_way || !self.judged(energy) {
                continue;
            }
            let largest = &mut self.cursor.unexplained[k];
            if share.abs() > largest.share.abs() {
                *largest = super::cursor::Residual { share, step, time };
            }
            if share.abs() > allowed && self.forbids(what) {
                let view = self.view();
                return Err(RunError::Residual {
                    what,
                    percent: 100.0 * share,
                    allowed: 100.0 * allowed,
                    energy,
                    unit: self.kind().energy_unit(),
                    fastest: view.fastest().map_or_else(String::new, |(name, _)| name),
                    ruled_out: cause::of_step(self),
                    step,
                    time,
                });
            }
        }
        Ok(())
    }

    /// Whether a run is stopped for it. The penetration potential of the plane makes and loses energy by itself, whatever the step: that is
    /// told.
    fn forbids(&self, what: Unexplained) -> bool {
        match what {
            Unexplained::Residual | Unexplained::Steps => true,
            Unexplained::LawDefect => self.view().planar().is_none_or(|view| {
                let interfaces = &view.world.setup.interfaces;
                interfaces.iter().all(|i| i.contact.normal == NormalLaw::DistancePotential)
            }),
        }
    }

    /// Share of the largest energy exchanged above which it is reported: where no run is stopped for it, only what would stop one else.
    pub(super) fn noted(&self, what: Unexplained) -> f64 {
        if self.forbids(what) { NOTED } else { TOLD }
    }

    /// Whether an energy that the ledger does not account for is more than round-off: that of energies, and that of places. A block that creeps by less in a step than the digits of its
    /// coordinates hold stays where it is, while its weight and what carries it work on its speed.
    fn judged(&self, energy: f64) -> bool {
        let view = self.view();
        let mass = view.mass() * view.slice();
        let gravity = self.engine.gravity().map(f64::abs).into_iter().sum::<f64>();
        let lost = self.steps() as f64 * f64::EPSILON * view.reach();
        energy.abs() > mass * (0.5 * STILL * STILL + gravity * lost)
    }

    /// The error for a sum over the model that is no number: names the first block that is to blame.
    fn no_number(&self, what: &str) -> RunError {
        match cause::first_block(&self.view()) {
            Some(block) => self.not_finite(block, "its motion"),
            None => RunError::NoNumber {
                what: what.to_owned(),
                ruled_out: match cause::of_functions(self) {
                    Some(cause) => cause.words,
                    None => format!(
                        "positions and velocities of all blocks are finite; {}",
                        cause::of_step(self)
                    ),
                },
                step: self.steps(),
                time: self.time(),
            },
        }
    }

    /// The error for a block of which something is no number.
    pub(super) fn not_finite(&self, block: u32, what: &str) -> RunError {
        let view = self.view();
        let cause = cause::of_block(self, block);
        RunError::NonFinite {
            block: view.name(block),
            what: what.to_owned(),
            formula: cause.formula,
            why: cause.words,
            step: self.steps(),
            time: self.time(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn looks_are_close_together_at_first() {
        let steps: Vec<u64> = (0..=200).filter(|s| due(*s, 50, 2)).collect();
        assert_eq!(steps, [0, 1, 2, 4, 8, 16, 32, 50, 100, 150, 200]);
        let steps: Vec<u64> = (0..=2000).filter(|s| due(*s, 1000, 8)).collect();
        assert_eq!(steps, [0, 1, 8, 64, 512, 1000, 2000]);
    }
}
