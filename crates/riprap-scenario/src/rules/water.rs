//! Rules of water tables.

use super::{Rules, above};
use crate::language::{Scenario, Seepage, Side, Water};
use crate::names::{Name, Names};
use crate::references::NO_WATER;
use crate::vectors::{Components, InSpace};

/// Sine of the angle between a drain hole and its row below which they lie on one line: coordinates are rounded.
const ON_LINE: f64 = 1e-9;

impl Rules {
    pub(super) fn water(&mut self, scenario: &Scenario) {
        for (name, water) in scenario.water.iter() {
            let of = format!("water.{name}");
            self.name(name, "a water table");
            if name.as_str() == NO_WATER {
                let message = format!("a water table cannot be called `{NO_WATER}`");
                let help = "it is the word of phases without water: give another name";
                self.error("name.form", &name.span, message, help);
            }
            if let Some(seepage) = &water.seepage {
                self.seepage(&of, seepage);
            }
            let Some(points) = &water.points else {
                continue;
            };
            if points.len() < 2 {
                let message = format!("`points` of {of} has fewer than two corners");
                let help = "give at least two, for example [[\"0 m\", \"4 m\"], [\"10 m\", \"1 m\"]]; a level table is `level`";
                self.error("value.range", &name.span, message, help);
            }
            for pair in points.windows(2) {
                let help = "write the corners in the order of their distances, each once";
                self.in_order(&pair[0][0], &pair[1][0], false, help);
            }
        }
        // With several tables the first phase must choose.
        if let Some(first) = scenario.phases.first()
            && first.water.is_none()
            && scenario.water.len() > 1
        {
            let message = format!("phase `{}` does not say which water table stands", first.name);
            let help = "there are several: give it `water` with the name of one, a list of names, or \"none\"";
            self.error("key.missing", &first.name.span, message, help);
        }
        for phase in &scenario.phases {
            if let Some(Names(names)) = &phase.water {
                self.together(scenario, &phase.name, names);
            }
        }
    }

    /// Tables that stand at the same time.
    fn together(&mut self, scenario: &Scenario, phase: &Name, names: &[Name]) {
        if names.is_empty() {
            let message = format!("`water` of phase `{phase}` is an empty list");
            let help = format!("give a name, or \"{NO_WATER}\"");
            self.error("value.range", &phase.span, message, &help);
        }
        for (k, name) in names.iter().enumerate().filter(|_| names.len() > 1) {
            let seeps = |w: &Water| w.seepage.is_some();
            let (message, help) = if name.as_str() == NO_WATER {
                let help = "give the tables that stand, or this word alone";
                (format!("`{NO_WATER}` stands beside other water tables"), help)
            } else if names[..k].contains(name) {
                (format!("water table `{name}` stands twice in a list"), "give each once")
            } else if scenario.water.get(name.as_str()).is_some_and(seeps) {
                let help = "one table that seeps stands alone: its `points` can have steps between different heads";
                (format!("water table `{name}` seeps and stands beside others"), help)
            } else {
                continue;
            };
            self.error("water.several", &name.span, message, help);
        }
    }

    fn seepage(&mut self, of: &str, said: &Seepage) {
        let least = said.aperture_min.as_ref();
        let most = said.aperture_max.as_ref();
        let aperture = said.aperture.si();
        let wrong = least.filter(|q| above(q.si(), aperture));
        if let Some(wrong) = wrong.or(most.filter(|q| above(aperture, q.si()))) {
            let message = format!("`aperture` of {of}.seepage lies outside of its limits");
            let help = "aperture_min <= aperture <= aperture_max";
            self.error("value.range", &wrong.span, message, help);
        }
        for side in said.closed.iter().flatten() {
            let of_space = matches!(side, Side::ZMin | Side::ZMax);
            if of_space && self.space == InSpace::Planar {
                let message = format!("`closed` of {of}.seepage names a side of space");
                let help = "in the plane sides are x-min, x-max, y-min, y-max";
                self.error("value.word", &said.aperture.span, message, help);
            }
        }
        for drain in &said.drains {
            let [from, to] = [&drain.from, &drain.to].map(Components::xyz);
            if from == to {
                let message = format!("a drain of {of}.seepage has no length");
                let help = "give the two ends of the line of holes";
                self.error("value.range", &drain.from.span, message, help);
            }
            if self.space == InSpace::Planar {
                continue;
            }
            let Some(end) = &drain.row_end else {
                let message = format!("a drain of {of}.seepage is a single hole");
                let help = "what a hole draws hangs on the size of blocks: give `row_end`, where the last hole of its row begins";
                self.error("key.missing", &drain.from.span, message, help);
                continue;
            };
            let way = |at: [f64; 3]| [0, 1, 2].map(|k| at[k] - from[k]);
            let ([a, b, c], [d, e, f]) = (way(to), way(end.xyz()));
            let length = |v: [f64; 3]| v.iter().map(|x| x * x).sum::<f64>().sqrt();
            let across = length([b * f - c * e, c * d - a * f, a * e - b * d]);
            if across <= ON_LINE * length([a, b, c]) * length([d, e, f]) {
                let message = format!("the drain holes of a row of {of}.seepage lie on one line");
                let help =
                    "`row_end` is where the last hole begins, beside the line from `from` to `to`";
                self.error("value.range", &end.span, message, help);
            }
        }
    }
}
