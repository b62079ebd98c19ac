//! Rules of checks and of the search for a limit.

use super::Rules;
use crate::diagnostic::{Diagnostic, short};
use crate::language::{Check, Criterion, Moment, Reduce};
use crate::quantity::When;

impl Rules {
    pub(super) fn criterion(&mut self, criterion: &Criterion) {
        if let Some(Reduce::FirstAbove | Reduce::FirstBelow | Reduce::ShareAbove) = criterion.reduce
        {
            let message = "fails_when cannot use `first_above` or `share_above`".to_owned();
            self.error("value.word", &criterion.field.span, message, "use max, min, mean or range");
        }
    }

    pub(super) fn check(&mut self, check: &Check) {
        let of = format!("check `{}`", short(check.name.as_str()));
        self.name(&check.name, "a check");
        let timed = match check.at.as_ref().map(Moment::read) {
            Some(When::Time(_)) => true,
            Some(When::Start | When::End) | None => false,
        };
        if let Some(phase) = check.phase.as_ref().filter(|_| timed) {
            let message = format!("{of} has `phase` and a time");
            let help = "keep one of them: at = \"start\" and \"end\" go with `phase`, and `reduce`";
            self.error("key.one_of", &phase.span, message, help);
        }
        if check.field.as_str().starts_with("energy.residual")
            && matches!(check.reduce, Some(Reduce::Max | Reduce::Min))
        {
            let message = format!("{of} sees one sign of the residual only");
            let note = Diagnostic::warning("check.one_sided", message).at(check.field.span.clone());
            self.found.push(note.help("use reduce = \"range\": the residual begins at 0"));
        }
        if let Some([first, last]) = &check.over {
            self.in_order(first, last, false, "`over` is [first time, last time]");
        }
        if let Some([low, high]) = &check.between {
            self.in_order(low, high, true, "`between` is [lowest, highest]");
            self.same_dimension(&[low, high], "between");
        }
        if let Some(reason) = check.known.as_ref().filter(|reason| reason.text.trim().is_empty()) {
            let message = "a known failure needs its reason".to_owned();
            self.error("name.form", &reason.span, message, "say in one line why it fails");
        }
        let mut known = vec!["t"];
        for (name, _) in check.names.iter() {
            let plain = name.text.chars().all(|c| c.is_ascii_alphanumeric() || c == '_')
                && name.text.starts_with(|c: char| c.is_ascii_alphabetic());
            if !plain || ["t", "pi", "deg", "e", "E", "PI", "TAU"].contains(&name.as_str()) {
                let message = format!("`{}` cannot be a name in `let`", short(&name.text));
                let help = "use letters, digits and _; t, pi, deg, E, PI and TAU have a meaning";
                self.error("name.form", &name.span, message, help);
            }
            known.push(name.as_str());
        }
        if let Some(formula) = &check.formula {
            self.formula(formula, &known);
        }
    }
}
