//! Rules of supports, loads and phases.

use riprap_core::laws::parameters::FrictionLaw;

use super::{Rules, above, target_span};
use crate::diagnostic::Diagnostic;
use crate::language::{EdgeLoad, Load, Motion, MotionComponents, Phase, Support, Target};
use crate::quantity::{Kind, NotNegativeTime, Quantity, Span};
use crate::time_function::{OF_PLACE_AND_TIME, OF_TIME, TimeFunction};
use crate::values::short;
use crate::vectors::InSpace;

impl Rules {
    pub(super) fn support(&mut self, support: &Support) {
        let span = target_span(&support.on);
        let keys = [("fixed", support.fixed.is_some()), ("motion", support.motion.is_some())];
        self.one_of(&span, "a support", &keys);
        if let Target::Box(region) = &support.on {
            self.region(region);
        }
        self.nodes(support);
        let any = match &support.motion {
            Some(Motion::Velocity(motion)) if matches!(support.on, Target::Nodes(_)) => {
                self.turns(&span, "nodes", motion)
                    || self.components(&span, motion, &OF_PLACE_AND_TIME)
            }
            Some(Motion::Velocity(motion)) => {
                self.turns_as_one(&span, motion);
                self.components(&span, motion, &OF_TIME)
            }
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
                self.components(&span, motion, &OF_TIME)
            }
            None => true,
        };
        if !any {
            let axes = match self.space {
                InSpace::Planar => "`x`, `y`, `spin`",
                InSpace::Spatial => "`x`, `y`, `z`, `spin_x`, `spin_y`, `spin_z`",
            };
            let message = format!("a motion needs at least one of {axes}");
            let help = "write for example x = { constant = \"0.1 m/s\" }";
            self.error("key.one_of", &span, message, help);
        }
    }

    /// Whether points are told to turn, which is reported.
    pub(super) fn turns<L: Kind, R: Kind>(
        &mut self,
        span: &Span,
        points: &str,
        motion: &MotionComponents<L, R>,
    ) -> bool {
        let spins = [&motion.spin_x, &motion.spin_y, &motion.spin_z];
        let turns = spins.iter().any(|spin| spin.is_some())
            || motion.about.is_some()
            || motion.each.is_some();
        if turns {
            let message = format!("{points} are moved along x, y, z and do not turn");
            let help = "leave out `about`, `each` and the spins: formulas of x, y, z turn them, for example \
                        x = { formula = \"0.1*(z - 2)\" }";
            self.error("key.forbidden", span, message, help);
        }
        turns
    }

    /// How the blocks of a support turn together.
    fn turns_as_one<L: Kind, R: Kind>(&mut self, span: &Span, motion: &MotionComponents<L, R>) {
        let spins = [&motion.spin, &motion.spin_x, &motion.spin_y, &motion.spin_z];
        let each = motion.each == Some(true);
        if let (Some(about), true) = (&motion.about, each) {
            let message = "a motion has `about` and `each`".to_owned();
            let help = "keep `about` for one body, or `each` for every block by itself";
            self.error("key.one_of", &about.span, message, help);
        }
        if spins.iter().any(|spin| spin.is_some()) {
            return;
        }
        let given = [("about", motion.about.is_some()), ("each", each)];
        for (key, _) in given.into_iter().filter(|(_, given)| *given) {
            let message = format!("`{key}` of a motion has no effect");
            let note = Diagnostic::warning("key.unused", message).at(span.clone());
            self.found.push(note.help("it belongs to a spin, and none is given"));
        }
    }

    /// Looks at all components of a motion, whose formulas use the names `known`; whether there are any.
    pub(super) fn components<L: Kind, R: Kind>(
        &mut self,
        span: &Span,
        motion: &MotionComponents<L, R>,
        known: &[&str],
    ) -> bool {
        let linear = [&motion.x, &motion.y, &motion.z];
        let turning = [&motion.spin, &motion.spin_x, &motion.spin_y, &motion.spin_z];
        for function in linear {
            self.function_of(span, function.as_ref(), known);
        }
        for function in turning {
            self.time_function(span, function.as_ref());
        }
        linear.iter().any(|f| f.is_some()) || turning.iter().any(|f| f.is_some())
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
        self.one_of(
            &span,
            "a load",
            &[
                ("point", load.point.is_some()),
                ("edge", load.edge.is_some()),
                ("moment", load.moment.is_some()),
                ("body", load.body.is_some()),
            ],
        );
        if let Some(EdgeLoad { pressure, traction, .. }) = &load.edge {
            let keys = [("pressure", pressure.is_some()), ("traction", traction.is_some())];
            self.one_of(&span, "an edge load", &keys);
        }
        self.time_function(&span, load.time.as_ref());
        self.loaded(load);
    }

    pub(super) fn phase(&mut self, phase: &Phase) {
        let span = &phase.name.span;
        let of = format!("phase `{}`", short(phase.name.as_str()));
        self.name(&phase.name, "a phase");
        let until = &phase.until;
        if until.time.is_none()
            && until.unbalanced.is_none()
            && until.kinetic.is_none()
            && until.steps.is_none()
        {
            let message = format!("{of} never ends");
            let help = "give `until` at least one of `time`, `unbalanced`, `kinetic`, `steps`";
            self.error("key.one_of", span, message, help);
        }
        if until.steps == Some(0) {
            let message = format!("{of} has no steps");
            self.error("value.range", span, message, "`steps` is at least 1");
        }
        if let Some(ramp) = &phase.removal_ramp {
            self.removal_ramp(phase, ramp);
        }
        if let (Some(_), Some(safety)) = (&phase.time_step, &phase.safety) {
            self.found.push(
                Diagnostic::warning("key.unused", format!("`safety` of {of} has no effect"))
                    .at(safety.span.clone())
                    .help("it belongs to the automatic time step; here `time_step` is given"),
            );
        }
        self.relaxing(phase);
        for (name, change) in phase.interfaces.iter() {
            let of = format!("phases.{}.interfaces.{name}", phase.name);
            if let (Some(_), Some(second)) = (&change.friction_angle, &change.friction_coefficient)
            {
                let message = format!("{of} has `friction_angle` and `friction_coefficient`");
                self.error("key.one_of", &second.span, message, "keep one of them");
            }
            self.rebound(&of, &change.damping_ratio, &change.restitution);
            // A speed without the law may be meant: the law may be clipped from the start.
            if change.friction_law == Some(FrictionLaw::Clipped) && change.clip_speed.is_none() {
                self.friction_law(&name.span, &of, change.friction_law, false);
            }
        }
    }

    /// Forces fade after blocks are taken out, and before the phase ends.
    fn removal_ramp(&mut self, phase: &Phase, ramp: &Quantity<NotNegativeTime>) {
        let of = format!("phase `{}`", short(phase.name.as_str()));
        if phase.remove.is_empty() {
            let message = format!("`removal_ramp` of {of} has no effect");
            let help = "nothing is taken out in this phase: give `remove`";
            let note = Diagnostic::warning("key.unused", message).at(ramp.span.clone());
            self.found.push(note.help(help));
        }
        let until = phase.until.time.as_ref();
        if let Some(until) = until.filter(|until| above(ramp.si(), until.si())) {
            let message = format!("{of} ends before its `removal_ramp`");
            let help = "make `until.time` at least as long, or the ramp shorter";
            self.error("value.range", &until.span, message, help);
        }
    }
}
