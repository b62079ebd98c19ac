//! Rules of checks and of the search for a limit.

use super::Rules;
use crate::diagnostic::Diagnostic;
use crate::language::{Check, Criterion, Moment, Reduce};
use crate::quantity::{Length, Names, Span, Vector, When};
use crate::values::short;

impl Rules {
    pub(super) fn criterion(&mut self, criterion: &Criterion) {
        let keys = [("above", criterion.above.is_some()), ("below", criterion.below.is_some())];
        self.one_of(&criterion.field.span, "fails_when", &keys);
        let at = (criterion.of.as_ref(), criterion.at_point.as_ref());
        self.of_or_point(at, &criterion.field.span);
        if let Some(Reduce::FirstAbove | Reduce::FirstBelow | Reduce::ShareAbove) = criterion.reduce
        {
            let message = "fails_when cannot use `first_above` or `share_above`".to_owned();
            self.error("value.word", &criterion.field.span, message, "use max, min, mean or range");
        }
    }

    /// A field is read at something named or at a point.
    pub(super) fn of_or_point(
        &mut self,
        (of, point): (Option<&Names>, Option<&Vector<Length>>),
        span: &Span,
    ) {
        if of.is_some() && point.is_some() {
            let message = "`of` and `at_point` say both where".to_owned();
            self.error("key.one_of", span, message, "keep one of them");
        }
    }

    pub(super) fn check(&mut self, check: &Check) {
        let span = &check.name.span;
        let of = format!("check `{}`", short(check.name.as_str()));
        self.name(&check.name, "a check");
        self.of_or_point((check.of.as_ref(), check.at_point.as_ref()), span);
        self.one_of(
            span,
            &of,
            &[
                ("value", check.value.is_some()),
                ("formula", check.formula.is_some()),
                ("csv", check.csv.is_some()),
                ("between", check.between.is_some()),
            ],
        );
        if check.at.is_some() && check.over.is_some() {
            let message = format!("{of} has `at` and `over`");
            self.error("key.one_of", span, message, "keep one of them");
        }
        let timed = match check.at.as_ref().map(Moment::read) {
            Some(When::Time(_)) => true,
            Some(When::Start | When::End) | None => check.over.is_some(),
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
        if check.over.is_some() && check.reduce.is_none() {
            let message = format!("{of} has `over` without `reduce`");
            let help = "say how the values become one number, for example reduce = \"max\"";
            self.error("key.missing", span, message, help);
        }
        if let Some([first, last]) = &check.over {
            self.in_order(first, last, false, "`over` is [first time, last time]");
        }
        let needs = match check.reduce {
            Some(Reduce::FirstAbove | Reduce::FirstBelow | Reduce::ShareAbove) => true,
            Some(Reduce::Max | Reduce::Min | Reduce::Mean | Reduce::Rms | Reduce::Range) | None => {
                false
            }
        };
        if needs != check.threshold.is_some() {
            let message = if needs {
                format!("the key `threshold` is missing in {of}")
            } else {
                format!("{of} has a `threshold` that nothing uses")
            };
            let help = "`threshold` belongs to reduce = \"first_above\", \"first_below\" and \"share_above\"";
            self.error("key.missing", span, message, help);
        }
        if let Some([low, high]) = &check.between {
            self.in_order(low, high, true, "`between` is [lowest, highest]");
            self.same_dimension(&[low, high], "between");
        } else if check.relative.is_none() && check.absolute.is_none() {
            let message = format!("{of} has no tolerance");
            self.error("key.missing", span, message, "write for example relative = 1e-3");
        }
        if check.known.is_some() && check.exact {
            let message = format!("{of} is exact and cannot be marked as known to fail");
            self.error("key.forbidden", span, message, "remove `known` and mend the cause");
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
