//! Rules of random values and of the samples drawn from them.

use super::Rules;
use crate::diagnostic::{Diagnostic, short};
use crate::language::{Moments, MonteCarlo, RandomValue, Scenario};
use crate::quantity::{Any, Name, Quantity};

impl Rules {
    pub(super) fn samples(&mut self, scenario: &Scenario) {
        for (key, said) in scenario.distributions.iter() {
            self.random_value(key, said);
        }
        match (&scenario.monte_carlo, scenario.distributions.names().next()) {
            (Some(wanted), first) => {
                if let Some(criterion) = &wanted.fails_when {
                    self.criterion(criterion);
                }
                // A case of a scene has values in place of their distributions.
                if first.is_some() {
                    self.correlations(scenario, wanted);
                }
            }
            (None, Some(_)) => {
                let message = "[distributions] needs [monte_carlo]".to_owned();
                let help = "add [monte_carlo] with samples = 500";
                let span =
                    scenario.distributions.iter().next().map_or(0..0, |(key, _)| key.span.clone());
                self.error("key.needs", &span, message, help);
            }
            (None, None) => {}
        }
    }

    fn random_value(&mut self, key: &Name, said: &RandomValue) {
        let of_moments = |of: &Option<Moments>| {
            of.as_ref().map_or_else(Vec::new, |of| {
                std::iter::once(of.mean.clone()).chain(of.deviation.clone()).collect()
            })
        };
        let mut values: Vec<Quantity<Any>> = of_moments(&said.normal);
        values.extend(of_moments(&said.lognormal));
        values.extend(said.uniform.iter().flatten().cloned());
        values.extend(said.triangular.iter().flatten().cloned());
        values.extend(said.beta.iter().flat_map(|of| of.between.clone()));
        values.extend([&said.above, &said.below].into_iter().flatten().cloned());
        if !self.values_sound {
            return;
        }
        let all: Vec<&Quantity<Any>> = values.iter().collect();
        self.same_dimension(&all, key.as_str());
        self.all_with_units(&all, key);
        for moments in [&said.normal, &said.lognormal].into_iter().flatten() {
            if let Some(of) = moments.deviation.as_ref().filter(|of| of.si() <= 0.0) {
                let message = "a standard deviation must be greater than zero".to_owned();
                self.error("value.range", &of.span, message, "give a positive value");
            }
        }
        if let Some(of) = said.lognormal.as_ref().filter(|of| of.mean.si() <= 0.0) {
            let message =
                "the mean of a lognormal distribution must be greater than zero".to_owned();
            self.error("value.range", &of.mean.span, message, "take another distribution");
        }
        let pairs = [
            said.uniform.as_ref().map(|[low, high]| [low, high]),
            said.beta.as_ref().map(|of| [&of.between[0], &of.between[1]]),
            said.triangular.as_ref().map(|[low, _, high]| [low, high]),
            said.above.as_ref().zip(said.below.as_ref()).map(|(low, high)| [low, high]),
        ];
        let mode = said.triangular.as_ref().map(|[low, mode, high]| [[low, mode], [mode, high]]);
        let increasing = pairs.into_iter().flatten().all(|[low, high]| low.si() < high.si());
        let inside = mode.into_iter().flatten().all(|[low, high]| low.si() <= high.si());
        if !increasing || !inside {
            let message = format!("the values of `{}` must increase", short(&key.text));
            self.error("value.order", &key.span, message, "give the lowest first");
        }
        if said.whole.is_some_and(|[low, high]| low > high || high >= 1 << 53) {
            let message = format!("the whole numbers of `{}` must increase", short(&key.text));
            self.error("value.order", &key.span, message, "give the first one first; at most 2^53");
        }
    }

    /// Of values that need a unit each must have one: a bare deviation would be one in SI.
    fn all_with_units(&mut self, values: &[&Quantity<Any>], key: &Name) {
        let some = values.iter().any(|value| value.unit().is_some());
        let bare = values.iter().find(|value| value.unit().is_none());
        if let Some(bare) = bare.filter(|_| some) {
            let message = format!("values of `{}` with and without a unit", short(&key.text));
            let wrong = Diagnostic::error("unit.missing", message).at(bare.span.clone());
            self.found.push(wrong.help("write the unit at each of them"));
        }
    }

    fn correlations(&mut self, scenario: &Scenario, wanted: &MonteCarlo) {
        let known: Vec<&str> = scenario.distributions.names().collect();
        let mut before: Vec<[&str; 2]> = Vec::new();
        for pair in &wanted.correlations {
            for name in &pair.between {
                if !known.contains(&name.as_str()) {
                    self.found.push(Diagnostic::unknown(
                        "distribution of",
                        name,
                        known.iter().copied(),
                    ));
                }
            }
            let mut both = [pair.between[0].as_str(), pair.between[1].as_str()];
            both.sort_unstable();
            if both[0] == both[1] || before.contains(&both) {
                let span = &pair.between[1].span;
                let message = "a correlation needs two keys, and each pair once".to_owned();
                self.error("value.order", span, message, "leave it out");
            }
            before.push(both);
            if self.values_sound && pair.coefficient.si().abs() >= 1.0 {
                let message =
                    "a coefficient of correlation is greater than -1 and less than 1".to_owned();
                let help = "values that follow from each other are one variable";
                self.error("value.range", &pair.coefficient.span, message, help);
            }
        }
    }
}
