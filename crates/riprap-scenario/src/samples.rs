//! Samples of the random values of a scene: cases with values drawn from `[distributions]`.

use std::path::Path;

use riprap_core::distribution::{self, Distribution, unit_samples};
use toml::de::DeTable;

use super::csv_columns::{Column, csv_table};
use super::diagnostic::{Diagnostic, Diagnostics, short};
use super::language::{MeasuredValues, Moments, RandomValue, Sampling};
use super::load::Parsed;
use super::overrides::Case;
use super::path::resolve;
use super::quantity::{Any, KindInfo, Name, Quantity};
use super::units::{self, Dim};
use super::vectors::InSpace;
use crate::language::Space;

/// A unit with its SI value.
type Unit = (String, f64);

/// A key with the distribution of its values, ready to be drawn from.
struct Variable<'a> {
    key: &'a Name,
    distribution: Distribution,
    /// Shares between which the distribution is cut off.
    shares: [f64; 2],
    /// The unit that the scene gives values in, and its SI value; none for plain numbers.
    unit: Option<Unit>,
    /// What the key may be.
    kind: Option<KindInfo>,
}

/// The samples of a scene: the case `of` with values drawn for every key of `[distributions]`, in the order in which they are drawn.
/// The same scene gives the same samples.
///
/// # Errors
/// A scene without distributions; a file that cannot be read; correlations that contradict each other; a value that its key
/// cannot have.
pub fn samples(parsed: &Parsed, of: &Case) -> Result<Vec<Case>, Diagnostics> {
    drawn(parsed, of).map_err(|wrong| Diagnostics::new(parsed.source.clone(), vec![*wrong]))
}

fn drawn(parsed: &Parsed, of: &Case) -> Result<Vec<Case>, Box<Diagnostic>> {
    let scenario = &parsed.scenario;
    let Some(wanted) = scenario.monte_carlo.as_ref().filter(|_| !scenario.distributions.is_empty())
    else {
        let message = "the scene has no [distributions]: nothing is random".to_owned();
        let help = "add [distributions] and [monte_carlo]; `riprap explain distributions` says what to write";
        return Err(Box::new(Diagnostic::error("distributions.none", message).help(help)));
    };
    let root = DeTable::parse(&parsed.source.text).ok();
    let root = root.as_ref().map(toml::Spanned::get_ref);
    let variables: Vec<Variable<'_>> = scenario
        .distributions
        .iter()
        .map(|(key, said)| Variable::read(parsed, root, key, said))
        .collect::<Result<_, _>>()?;
    let place = |name: &Name| variables.iter().position(|variable| variable.key == name);
    let pairs: Vec<(usize, usize, f64)> = wanted
        .correlations
        .iter()
        .filter_map(|pair| {
            let [first, second] = [place(&pair.between[0])?, place(&pair.between[1])?];
            Some((first, second, pair.coefficient.si()))
        })
        .collect();
    let count = wanted.samples as usize;
    let sampling = match wanted.sampling.unwrap_or_default() {
        Sampling::LatinHypercube => distribution::Sampling::LatinHypercube,
        Sampling::Random => distribution::Sampling::Random,
    };
    let seed = wanted.seed.unwrap_or(1);
    let shares = unit_samples(variables.len(), count, seed, sampling, &pairs).map_err(|_| {
        let message =
            "these correlations contradict each other: no values have them all".to_owned();
        let at = wanted.correlations[0].between[0].span.clone();
        let help = "make the coefficients smaller, or leave a pair out";
        Box::new(Diagnostic::error("distributions.correlations", message).at(at).help(help))
    })?;
    let digits = count.to_string().len();
    let mut cases = Vec::with_capacity(count);
    for k in 0..count {
        let mut case = of.clone();
        case.name = format!("sample-{:0digits$}", k + 1);
        for (variable, shares) in variables.iter().zip(&shares) {
            let text = variable.value(shares[k], &case.name)?;
            case.changes.push((variable.key.text.clone(), text));
        }
        cases.push(case);
    }
    Ok(cases)
}

impl<'a> Variable<'a> {
    fn read(
        parsed: &Parsed,
        root: Option<&DeTable<'_>>,
        key: &'a Name,
        said: &RandomValue,
    ) -> Result<Self, Box<Diagnostic>> {
        let space = match parsed.scenario.space {
            Space::Planar(_) => InSpace::Planar,
            Space::Spatial(_) => InSpace::Spatial,
        };
        let place = root.and_then(|root| resolve(root, key.as_str()).ok());
        let kind = place.and_then(|place| place.node.kind()).map(|kind| kind.in_space(Some(space)));
        let dim = kind.and_then(|kind| kind.dim).unwrap_or(Dim::NONE);
        let (distribution, mut unit) = distribution(&parsed.folder, said, dim)?;
        if unit.is_none() && dim != Dim::NONE && said.whole.is_none() {
            unit = Some((dim.unit(), 1.0));
        }
        let end = |end: &Option<Quantity<Any>>, none: f64| {
            end.as_ref().map_or(none, |end| distribution.cumulative(end.si()))
        };
        let shares = [end(&said.above, 0.0), end(&said.below, 1.0)];
        if shares[1] - shares[0] < 1e-9 {
            let message = format!("no value of `{}` lies in its bounds", short(&key.text));
            let help = "move `above` and `below`, or the distribution";
            let wrong = Diagnostic::error("distributions.empty", message);
            return Err(Box::new(wrong.at(key.span.clone()).help(help)));
        }
        Ok(Variable { key, distribution, shares, unit, kind })
    }

    /// The value at a share of what may be drawn, as TOML.
    fn value(&self, share: f64, sample: &str) -> Result<String, Box<Diagnostic>> {
        let [low, high] = self.shares;
        let si = self.distribution.quantile(low + share * (high - low));
        let (text, shown) = match (&self.distribution, &self.unit) {
            (Distribution::Whole { .. }, _) => (format!("{si:.0}"), format!("{si:.0}")),
            (_, Some((unit, one))) => {
                let shown = format!("{} {unit}", si / one);
                (format!("{shown:?}"), shown)
            }
            (_, None) => (format!("{si:?}"), format!("{si}")),
        };
        match self.kind.filter(|kind| !kind.bounds.contains(si)) {
            None => Ok(text),
            Some(kind) => {
                let key = short(&self.key.text);
                let message = format!(
                    "`{key}` would be {shown} in {sample}: it must be {}",
                    kind.bounds.text
                );
                let help = "cut the distribution off with `above` or `below`, or take one that has no such values: \
                            lognormal, triangular, beta";
                let wrong = Diagnostic::error("value.range", message);
                Err(Box::new(wrong.at(self.key.span.clone()).help(help)))
            }
        }
    }
}

/// A distribution in SI with the unit that it was given in; `dim`: the dimension of a column without unit.
fn distribution(
    folder: &Path,
    said: &RandomValue,
    dim: Dim,
) -> Result<(Distribution, Option<Unit>), Box<Diagnostic>> {
    let unit = |of: &Quantity<Any>| of.unit().map(|(unit, one)| (unit.to_owned(), one));
    let moments = |said: &Moments| {
        let mean = said.mean.si();
        let share = said.variation.as_ref().map_or(0.0, Quantity::si);
        (mean, said.deviation.as_ref().map_or(share * mean.abs(), Quantity::si))
    };
    Ok(if let Some(of) = &said.normal {
        let (mean, deviation) = moments(of);
        (Distribution::Normal { mean, deviation }, unit(&of.mean))
    } else if let Some(of) = &said.lognormal {
        let (mean, deviation) = moments(of);
        (Distribution::Lognormal { mean, deviation }, unit(&of.mean))
    } else if let Some([low, high]) = &said.uniform {
        (Distribution::Uniform { low: low.si(), high: high.si() }, unit(low))
    } else if let Some([low, mode, high]) = &said.triangular {
        let ends = Distribution::Triangular { low: low.si(), mode: mode.si(), high: high.si() };
        (ends, unit(low))
    } else if let Some(of) = &said.beta {
        let [low, high] = [&of.between[0], &of.between[1]].map(Quantity::si);
        let (alpha, beta) = (of.alpha.si(), of.beta.si());
        (Distribution::Beta { low, high, alpha, beta }, unit(&of.between[0]))
    } else if let Some([low, high]) = said.whole {
        (Distribution::Whole { low, high }, None)
    } else if let Some(of) = &said.csv {
        (Distribution::Measured(measured(folder, of, dim)?), None)
    } else {
        // Refused by the rules of the table.
        (Distribution::Whole { low: 0, high: 0 }, None)
    })
}

/// The values of a column in growing order, SI.
fn measured(folder: &Path, of: &MeasuredValues, dim: Dim) -> Result<Vec<f64>, Box<Diagnostic>> {
    let (name, si) = ([of.column.as_str()], dim.unit());
    let columns = [Column::chosen(&name, dim, &si)];
    let table = csv_table(&folder.join(of.file.as_str()), &columns).map_err(|error| {
        let wrong = Diagnostic::error("file.csv", error.message).at(of.file.span.clone());
        Box::new(Diagnostic { help: error.help, ..wrong })
    })?;
    let mut values = table.values(0).to_vec();
    values.sort_by(f64::total_cmp);
    if values.len() < 2 || values.first() == values.last() {
        let message =
            format!("`{}` has a single value: nothing is random", short(of.column.as_str()));
        let wrong = Diagnostic::error("file.csv", message).at(of.column.span.clone());
        return Err(Box::new(wrong.help("give at least two different values")));
    }
    Ok(values)
}

/// SI value of a sampled text, as a case has it.
#[must_use]
pub fn sampled_number(text: &str) -> Option<f64> {
    units::parse(text.trim_matches('"')).ok().map(|(value, _)| value)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diagnostic::Source;
    use crate::load::parse;

    const SCENE: &str = "riprap = 1\ntitle = \"a\"\n[space.planar]\ngravity = [\"0 m/s2\", \"-10 m/s2\"]\n\
        [materials.rock]\ndensity = \"2500 kg/m3\"\n\
        [interfaces.default]\nnormal_stiffness = \"1 GPa/m\"\nfriction_angle = \"30 deg\"\ncohesion = \"10 kPa\"\n\
        [[blocks]]\nname = \"stone\"\nmaterial = \"rock\"\nrectangle = { size = [\"1 m\", \"1 m\"], corner = [\"0 m\", \"0 m\"] }\n\
        [[phases]]\nname = \"a\"\nuntil = { time = \"1 s\" }\n";

    fn of(more: &str) -> Result<Vec<Case>, String> {
        let source = Source::new("a.toml", format!("{SCENE}{more}"));
        let parsed = parse(source).map_err(|wrong| wrong.render())?;
        let plain = Case {
            name: "default".to_owned(),
            variant: "default".to_owned(),
            changes: Vec::new(),
            trial: Vec::new(),
        };
        samples(&parsed, &plain).map_err(|wrong| wrong.render())
    }

    const PHI: &str = "\"interfaces.default.friction_angle\"";
    const COHESION: &str = "\"interfaces.default.cohesion\"";

    #[test]
    fn values_are_drawn_in_the_unit_of_the_scene() {
        let text = format!(
            "[distributions]\n{PHI} = {{ normal = {{ mean = \"30 deg\", deviation = \"2 deg\" }}, above = \"28 deg\" }}\n\
             {COHESION} = {{ lognormal = {{ mean = \"10 kPa\", variation = 0.4 }} }}\n\
             [monte_carlo]\nsamples = 200\ncorrelations = [{{ between = [{PHI}, {COHESION}], coefficient = -0.5 }}]\n"
        );
        let cases = of(&text).unwrap();
        assert_eq!((cases.len(), &cases[6].name[..]), (200, "sample-007"));
        let column = |k: usize| -> Vec<f64> {
            cases.iter().map(|case| sampled_number(&case.changes[k].1).unwrap()).collect()
        };
        let (phi, cohesion) = (column(0), column(1));
        assert!(cases[0].changes[0].1.ends_with(" deg\""), "{:?}", cases[0].changes);
        assert!(phi.iter().all(|value| *value > 28f64.to_radians()));
        let mean = cohesion.iter().sum::<f64>() / 200.0;
        assert!((mean / 10e3 - 1.0).abs() < 0.02, "{mean}");
        let together = distribution::rank_correlation(&phi, &cohesion).unwrap();
        assert!((together + 0.48).abs() < 0.08, "{together}");
        assert_eq!(of(&text).unwrap(), cases);
    }

    #[test]
    fn what_cannot_be_drawn_is_refused_at_its_place() {
        let wrong = |distributions: &str, monte_carlo: &str| {
            of(&format!("[distributions]\n{distributions}\n[monte_carlo]\n{monte_carlo}\n"))
                .unwrap_err()
        };
        let angle = |of: &str| format!("{PHI} = {{ {of} }}");
        let ten = "samples = 10";
        for (distributions, monte_carlo, words) in [
            (angle("uniform = [\"20 deg\", \"100 deg\"]"), ten, "less than 90 deg"),
            (angle("uniform = [\"30 deg\", \"20 deg\"]"), ten, "must increase"),
            (angle("uniform = [\"30 deg\", \"1 m\"]"), ten, "angle"),
            (angle("normal = { mean = \"30 deg\", deviation = 2 }"), ten, "unit"),
            (
                angle("normal = { mean = \"30 deg\", deviation = \"0 deg\" }"),
                ten,
                "greater than zero",
            ),
            (angle("normal = { mean = \"80 deg\", deviation = \"9 deg\" }"), ten, "would be"),
            (
                angle("normal = { mean = \"30 deg\", deviation = \"2 deg\" }, above = \"70 deg\""),
                ten,
                "no value",
            ),
            (angle("normal = { mean = \"30 deg\" }"), ten, "deviation"),
            (angle("csv = { file = \"none.csv\", column = \"phi\" }"), ten, "none.csv"),
            (angle("uniform = [\"20 deg\", \"30 deg\"]"), "samples = 0", "from 2 to 10000"),
            ("\"interfaces.default.frction\" = { whole = [1, 2] }".to_owned(), ten, "there is no"),
            ("\"blocks.stone.material\" = { whole = [1, 2] }".to_owned(), ten, "text"),
        ] {
            let found = wrong(&distributions, monte_carlo);
            assert!(found.contains(words), "{distributions}: {found}");
        }
        let two = format!(
            "{}\n{COHESION} = {{ uniform = [\"1 kPa\", \"2 kPa\"] }}",
            angle("uniform = [\"20 deg\", \"30 deg\"]")
        );
        let pair = |of: &str| wrong(&two, &format!("{ten}\ncorrelations = [{{ {of} }}]"));
        let found = pair(&format!("between = [{PHI}, {COHESION}], coefficient = 1"));
        assert!(found.contains("less than 1"), "{found}");
        let found = pair(&format!("between = [{PHI}, \"a\"], coefficient = 0.1"));
        assert!(found.contains("`a`"), "{found}");
        let found = of(&format!("[distributions]\n{two}\n")).unwrap_err();
        assert!(found.contains("[monte_carlo]"), "{found}");
        assert!(of("").unwrap_err().contains("nothing is random"));
    }

    #[test]
    fn seeds_are_whole_numbers_and_measured_values_come_from_a_file() {
        let folder = tempfile::tempdir().unwrap();
        std::fs::write(folder.path().join("shear.csv"), "phi [deg]\n31\n29\n35\n").unwrap();
        let text = format!(
            "{SCENE}[distributions]\n{PHI} = {{ csv = {{ file = \"shear.csv\", column = \"phi\" }} }}\n\
             \"interfaces.default.normal_stiffness\" = {{ uniform = [\"1 GPa/m\", \"2 GPa/m\"] }}\n\
             [monte_carlo]\nsamples = 40\nsampling = \"random\"\n"
        );
        let mut parsed = parse(Source::new("a.toml", text)).map_err(|w| w.render()).unwrap();
        parsed.folder = folder.path().to_owned();
        let plain = Case {
            name: "default".to_owned(),
            variant: "default".to_owned(),
            changes: Vec::new(),
            trial: Vec::new(),
        };
        let cases = samples(&parsed, &plain).map_err(|wrong| wrong.render()).unwrap();
        for case in &cases {
            let phi = sampled_number(&case.changes[0].1).unwrap().to_degrees();
            assert!((28.999..35.001).contains(&phi), "{phi}");
        }
    }
}
