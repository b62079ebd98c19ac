//! Rules of supports, loads and phases.

use super::{Rules, above, target_span};
use crate::diagnostic::short;
use crate::language::{Load, Motion, MotionComponents, Phase, Support, Target};
use crate::quantity::{Kind, NotNegativeTime, Quantity, Span};
use crate::time_function::{OF_PLACE_AND_TIME, OF_TIME, TimeFunction};

impl Rules {
    pub(super) fn support(&mut self, support: &Support) {
        let span = target_span(&support.on);
        if let Target::Box(region) = &support.on {
            self.region(region);
        }
        self.nodes(support);
        match &support.motion {
            Some(Motion::Velocity(motion)) if matches!(support.on, Target::Nodes(_)) => {
                self.points_move(&span, "nodes", motion);
            }
            Some(Motion::Velocity(motion)) => self.components(&span, motion, &OF_TIME),
            Some(Motion::Acceleration(motion)) => {
                if motion.about.is_some() {
                    let message = "an acceleration turns no blocks about a point".to_owned();
                    let help = "prescribe the spin by a `velocity`, or leave out `about`";
                    self.error("key.forbidden", &span, message, help);
                }
                let turns = [&motion.spin_x, &motion.spin_y, &motion.spin_z];
                if turns.iter().any(|spin| spin.is_some()) {
                    let message = "an acceleration in [space.spatial] does not turn".to_owned();
                    let help = "prescribe the spin by a `velocity`, or leave it out";
                    self.error("key.forbidden", &span, message, help);
                }
                self.components(&span, motion, &OF_TIME);
            }
            None => {}
        }
    }

    /// Points are moved along x, y, z and cannot turn.
    pub(super) fn points_move<L: Kind, R: Kind>(
        &mut self,
        span: &Span,
        points: &str,
        motion: &MotionComponents<L, R>,
    ) {
        let spins = [&motion.spin_x, &motion.spin_y, &motion.spin_z];
        let turns = spins.iter().any(|spin| spin.is_some())
            || motion.about.is_some()
            || motion.each.is_some();
        if turns {
            let message = format!("{points} are moved along x, y, z and do not turn");
            let help = "leave out `about`, `each` and the spins: formulas of x, y, z turn them, for example \
                        x = { formula = \"0.1*(z - 2)\" }";
            self.error("key.forbidden", span, message, help);
        } else {
            self.components(span, motion, &OF_PLACE_AND_TIME);
        }
    }

    /// Looks at all components of a motion, whose formulas use the names `known`.
    pub(super) fn components<L: Kind, R: Kind>(
        &mut self,
        span: &Span,
        motion: &MotionComponents<L, R>,
        known: &[&str],
    ) {
        let linear = [&motion.x, &motion.y, &motion.z];
        let turning = [&motion.spin, &motion.spin_x, &motion.spin_y, &motion.spin_z];
        for function in linear {
            self.function_of(span, function.as_ref(), known);
        }
        for function in turning {
            self.time_function(span, function.as_ref());
        }
    }

    pub(super) fn time_function<K: Kind>(
        &mut self,
        span: &Span,
        function: Option<&TimeFunction<K>>,
    ) {
        self.function_of(span, function, &OF_TIME);
    }

    fn function_of<K: Kind>(
        &mut self,
        span: &Span,
        function: Option<&TimeFunction<K>>,
        known: &[&str],
    ) {
        match function {
            Some(TimeFunction::Formula(formula)) => self.formula(formula, known),
            Some(TimeFunction::Ramp(ramp)) => {
                let start = ramp.start.as_ref().map_or(0.0, Quantity::si);
                self.end_after(start, ramp.end.si(), &ramp.end.span);
            }
            Some(TimeFunction::Pulse(pulse)) => {
                let start = pulse.start.as_ref().map_or(0.0, Quantity::si);
                self.end_after(start, pulse.end.si(), &pulse.end.span);
            }
            Some(TimeFunction::Duvall(duvall)) => {
                if self.values_sound && duvall.rise.si() <= duvall.decay.si() {
                    let message = "`rise` is not above `decay`".to_owned();
                    let help =
                        "`rise` is the rate of the fast exponential, `decay` of the slow one";
                    self.error("value.order", &duvall.rise.span, message, help);
                }
            }
            Some(TimeFunction::Csv(csv)) => {
                if csv.file.as_str().is_empty() {
                    self.error(
                        "name.form",
                        span,
                        "the CSV file has no name".to_owned(),
                        "give a path",
                    );
                }
            }
            Some(
                TimeFunction::Constant(_)
                | TimeFunction::Sine(_)
                | TimeFunction::Triangle(_)
                | TimeFunction::At2(_),
            )
            | None => {}
        }
    }

    pub(super) fn end_after(&mut self, start: f64, end: f64, span: &Span) {
        if self.values_sound && !above(end, start) {
            let message = "`end` does not come after `start`".to_owned();
            self.error("value.order", span, message, "`start` is 0 s if it is not given");
        }
    }

    pub(super) fn load(&mut self, load: &Load) {
        let span = target_span(&load.on);
        self.time_function(&span, load.time.as_ref());
        self.loaded(load);
    }

    pub(super) fn phase(&mut self, phase: &Phase) {
        self.name(&phase.name, "a phase");
        if let Some(ramp) = &phase.removal_ramp {
            self.removal_ramp(phase, ramp);
        }
        if let Some(region) = phase.leavers.as_ref().and_then(|leavers| leavers.outside.as_ref()) {
            self.region(region);
        }
        self.relaxing(phase);
    }

    /// Forces fade after blocks are taken out, and before the phase ends.
    fn removal_ramp(&mut self, phase: &Phase, ramp: &Quantity<NotNegativeTime>) {
        let of = format!("phase `{}`", short(phase.name.as_str()));
        let until = phase.until.time.as_ref();
        if let Some(until) = until.filter(|until| above(ramp.si(), until.si())) {
            let message = format!("{of} ends before its `removal_ramp`");
            let help = "make `until.time` at least as long, or the ramp shorter";
            self.error("value.range", &until.span, message, help);
        }
    }
}
