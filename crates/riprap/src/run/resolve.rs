//! From the checks of a scene to checks with block numbers and SI values.

use crate::dynamics::Formula;
use crate::planar::setup::Setup;
use crate::record::field::{self, FieldInfo, Part, Shape, Site, nearest};
use crate::run::checks::{Check, Expected, Reduce, Window};
use crate::scenario::language::{self, Criterion};
use crate::scenario::quantity::{Angle, Any, Kind, NumberOrKey, Raw, When};
use crate::scenario::units;
use crate::scenario::{Diagnostic, Diagnostics, Name, Names, Parsed, Quantity, Span, csv_columns};

/// What is read during a run: a field, its blocks and a direction.
#[derive(Clone, Debug, PartialEq)]
pub struct Target {
    /// Field with its component.
    pub field: String,
    /// Blocks.
    pub of: Vec<u32>,
    /// Unit direction.
    pub along: Option<[f64; 2]>,
    /// Unit as printed.
    pub unit: String,
}

/// Resolves the checks of a scene that belong to `variant` and to the present values of its keys.
///
/// # Errors
/// Unknown fields and blocks, units that do not suit the field, CSV files, formulas.
pub fn checks(
    parsed: &Parsed,
    variant: &str,
    setup: &Setup,
    table: &[FieldInfo],
) -> Result<Vec<Check>, Diagnostics> {
    let mut found = Vec::new();
    let mut wrong = Vec::new();
    for check in &parsed.scenario.checks {
        let meant = check.only.is_empty() || check.only.iter().any(|name| name.text == variant);
        if !meant || !parsed.check_applies(check) {
            continue;
        }
        match resolve(parsed, check, setup, table) {
            Ok(check) => found.push(check),
            Err(diagnostic) => wrong.push(*diagnostic),
        }
    }
    if wrong.is_empty() {
        Ok(found)
    } else {
        Err(Diagnostics::new(parsed.source.clone(), wrong))
    }
}

/// Resolves the criterion of a bisection into a check that passes while the scene holds.
///
/// # Errors
/// As [`checks`].
pub fn limit(
    parsed: &Parsed,
    criterion: &Criterion,
    setup: &Setup,
    table: &[FieldInfo],
) -> Result<Check, Diagnostics> {
    let resolved = (|| {
        let target = target(
            &criterion.field,
            criterion.of.as_ref(),
            criterion.along.as_ref(),
            setup,
            table,
        )?;
        let window = match criterion.reduce {
            None => Window::End,
            Some(how) => Window::Over {
                from: 0.0,
                to: f64::INFINITY,
                reduce: reduce(how, None, &target)?,
            },
        };
        let side = |limit: &Option<Quantity<Any>>, open: f64| match limit {
            Some(value) => si_in(value, &target.unit),
            None => Ok(open),
        };
        let low = side(&criterion.below, f64::NEG_INFINITY)?;
        let high = side(&criterion.above, f64::INFINITY)?;
        Ok(Check {
            name: format!("{} stays within its limit", target.field),
            field: target.field,
            of: target.of,
            along: target.along,
            unit: target.unit,
            window,
            expected: Expected::Between(low, high),
            relative: None,
            absolute: None,
            known: None,
        })
    })();
    resolved.map_err(|one: Wrong| Diagnostics::new(parsed.source.clone(), vec![*one]))
}

type Wrong = Box<Diagnostic>;

fn wrong(code: &'static str, span: &Span, message: impl Into<String>) -> Diagnostic {
    Diagnostic::error(code, message).at(span.clone())
}

/// Finds field, blocks and direction.
///
/// # Errors
/// Names that stand for nothing, and blocks that do not suit the field.
pub fn target(
    name: &Name,
    of: Option<&Names>,
    along: Option<&Quantity<Angle>>,
    setup: &Setup,
    table: &[FieldInfo],
) -> Result<Target, Wrong> {
    let (info, part) = field::find(table, name.as_str())
        .map_err(|error| Box::new(wrong("field.unknown", &name.span, error.to_string())))?;
    let names: &[Name] = of.map_or(&[], |names| &names.0);
    let blocks = blocks(info, names, setup, &name.span)?;
    if along.is_some() && (info.shape == Shape::Scalar || part != Part::Whole) {
        let message = format!("`along` needs a vector, and `{name}` is a single number");
        return Err(Box::new(wrong("check.along", &name.span, message)));
    }
    if along.is_none() && info.shape == Shape::Vector && part == Part::Whole {
        let message = format!("`{name}` is a vector, and one number is wanted");
        let help = format!("write `{name}.x`, `.y` or `.magnitude`, or give `along`");
        return Err(Box::new(
            wrong("check.vector", &name.span, message).help(help),
        ));
    }
    Ok(Target {
        field: name.text.clone(),
        of: blocks,
        along: along.map(|angle| [angle.si().cos(), angle.si().sin()]),
        unit: info.unit.to_owned(),
    })
}

/// The blocks that a field of this kind is read at.
fn blocks(info: &FieldInfo, names: &[Name], setup: &Setup, at: &Span) -> Result<Vec<u32>, Wrong> {
    let need = |count: usize, what: &str| {
        if names.len() == count {
            return Ok(());
        }
        let message = format!(
            "`{}` needs {what} in `of`, here are {}",
            info.name,
            names.len()
        );
        Err(Box::new(wrong("check.of", at, message)))
    };
    match info.site {
        Site::Block => need(1, "one block")?,
        Site::Pair | Site::Contact => need(2, "two blocks")?,
        Site::Model | Site::Energy => need(0, "nothing")?,
        Site::Group => {
            let mut all = Vec::new();
            for name in names {
                match setup.groups.iter().find(|group| group.name == name.text) {
                    Some(group) => all.extend(&group.blocks),
                    None => all.push(block(setup, name)?),
                }
            }
            all.sort_unstable();
            all.dedup();
            if all.is_empty() {
                need(1, "a group or blocks")?;
            }
            return Ok(all);
        }
    }
    names.iter().map(|name| block(setup, name)).collect()
}

/// The block of that name; the name of a group of one block will do.
fn block(setup: &Setup, name: &Name) -> Result<u32, Wrong> {
    if let Some(index) = setup
        .blocks
        .iter()
        .position(|block| block.name == name.text)
    {
        return Ok(index as u32);
    }
    let group = setup.groups.iter().find(|group| group.name == name.text);
    if let Some([only]) = group.map(|group| group.blocks.as_slice()) {
        return Ok(*only);
    }
    let message = match group {
        Some(group) => {
            format!(
                "`{name}` is a group of {} blocks, one is needed",
                group.blocks.len()
            )
        }
        None => format!("there is no block `{name}`"),
    };
    let known = setup.blocks.iter().map(|block| block.name.as_str());
    let mut diagnostic = wrong("name.unknown", &name.span, message);
    diagnostic.help = match group {
        Some(_) => Some(format!("its blocks are called `{name}.1`, `{name}.2`, ...")),
        None => nearest(&name.text, known).map(|near| format!("did you mean `{near}`?")),
    };
    Err(Box::new(diagnostic))
}

fn resolve(
    parsed: &Parsed,
    check: &language::Check,
    setup: &Setup,
    table: &[FieldInfo],
) -> Result<Check, Wrong> {
    let target = target(
        &check.field,
        check.of.as_ref(),
        check.along.as_ref(),
        setup,
        table,
    )?;
    let window = window(check, &target)?;
    let unit = match window {
        Window::Over {
            reduce: Reduce::FirstAbove(_),
            ..
        } => "s",
        Window::Over {
            reduce: Reduce::ShareAbove(_),
            ..
        } => "-",
        Window::Start | Window::At(_) | Window::End | Window::Over { .. } => target.unit.as_str(),
    };
    let expected = expected(parsed, check, unit)?;
    let absolute = check
        .absolute
        .as_ref()
        .map(|value| si_in(value, unit))
        .transpose()?;
    Ok(Check {
        name: check.name.text.clone(),
        field: target.field,
        of: target.of,
        along: target.along,
        unit: target.unit,
        window,
        expected,
        relative: check.relative.as_ref().map(Quantity::si),
        absolute,
        known: check.known.as_ref().map(|reason| reason.text.clone()),
    })
}

fn window(check: &language::Check, target: &Target) -> Result<Window, Wrong> {
    if let Some(how) = check.reduce {
        let (from, to) = match &check.over {
            Some([from, to]) => (from.si(), to.si()),
            None => (0.0, f64::INFINITY),
        };
        let reduce = reduce(how, check.threshold.as_ref(), target)?;
        return Ok(Window::Over { from, to, reduce });
    }
    let Some(moment) = &check.at else {
        return Ok(Window::End);
    };
    Ok(match moment.read() {
        When::Start => Window::Start,
        When::End => Window::End,
        When::Time(time) => Window::At(time),
    })
}

fn reduce(
    how: language::Reduce,
    threshold: Option<&Quantity<Any>>,
    target: &Target,
) -> Result<Reduce, Wrong> {
    let threshold = match threshold {
        Some(value) => si_in(value, &target.unit)?,
        None => 0.0,
    };
    Ok(match how {
        language::Reduce::Max => Reduce::Max,
        language::Reduce::Min => Reduce::Min,
        language::Reduce::Mean => Reduce::Mean,
        language::Reduce::Range => Reduce::Range,
        language::Reduce::FirstAbove => Reduce::FirstAbove(threshold),
        language::Reduce::ShareAbove => Reduce::ShareAbove(threshold),
    })
}

fn expected(parsed: &Parsed, check: &language::Check, unit: &str) -> Result<Expected, Wrong> {
    if let Some(value) = &check.value {
        return Ok(Expected::Value(si_in(value, unit)?));
    }
    if let Some([low, high]) = &check.between {
        return Ok(Expected::Between(si_in(low, unit)?, si_in(high, unit)?));
    }
    if let Some(text) = &check.formula {
        let names = constants(parsed, check)?;
        let known: Vec<&str> = std::iter::once("t")
            .chain(names.iter().map(|(name, _)| name.as_str()))
            .collect();
        let formula = Formula::new(text.as_str(), &known)
            .map_err(|error| Box::new(wrong("formula", &text.span, error.to_string())))?;
        return Ok(Expected::Formula { formula, names });
    }
    let Some(csv) = &check.csv else {
        let message = "the check does not say what it expects";
        return Err(Box::new(wrong("check.expected", &check.name.span, message)));
    };
    let path = parsed.folder.join(csv.file.as_str());
    let columns = csv_columns(&path, &[csv.time.as_str(), csv.column.as_str()]);
    let columns = columns.map_err(|error| {
        let mut diagnostic = wrong("csv", &csv.file.span, error.message);
        diagnostic.help = error.help;
        Box::new(diagnostic)
    })?;
    let scale = csv.scale.as_ref().map_or(1.0, Quantity::si);
    let mut columns = columns.into_iter();
    match (columns.next(), columns.next()) {
        (Some(t), Some(v)) => Ok(Expected::Table {
            t,
            v: v.into_iter().map(|x| scale * x).collect(),
        }),
        _ => Err(Box::new(wrong(
            "csv",
            &csv.file.span,
            "the file has no such columns",
        ))),
    }
}

/// The names of a formula with their SI values.
fn constants(parsed: &Parsed, check: &language::Check) -> Result<Vec<(String, f64)>, Wrong> {
    check
        .names
        .iter()
        .map(|(name, value)| {
            let number = match &value.raw {
                Raw::Number(number) => *number,
                Raw::Text(text) if is_key::<NumberOrKey>(value) => parsed
                    .key_si(text)
                    .map_err(|why| Box::new(wrong("key.path", &value.span, why)))?,
                Raw::Text(_) => value.si(),
            };
            Ok((name.text.clone(), number))
        })
        .collect()
}

/// Whether a value is the name of a key and not a number with a unit.
fn is_key<K: Kind>(value: &Quantity<K>) -> bool {
    value.read().is_err()
}

/// SI value of a quantity that is compared with a field in `unit`.
fn si_in(value: &Quantity<Any>, unit: &str) -> Result<f64, Wrong> {
    let fail = |message: String| Box::new(wrong("unit.dimension", &value.span, message));
    let (number, dim) = value.read().map_err(|error| fail(error.message))?;
    let Some(dim) = dim else { return Ok(number) };
    let expected = units::dimension(unit).map_err(|error| fail(error.message))?;
    // A length of arc or a ratio of lengths may be written either way.
    if dim != expected {
        let message = format!(
            "this is {}, and what it is compared with is {} ({unit})",
            dim.describe(),
            expected.describe()
        );
        return Err(fail(message));
    }
    Ok(number)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Vec2;
    use crate::planar::setup::{BlockSpec, Group};
    use crate::run::checks::{Status, Watch};
    use crate::scenario::{self, Source};

    const TABLE: &[FieldInfo] = &[
        FieldInfo {
            name: "block.displacement",
            unit: "m",
            site: Site::Block,
            shape: Shape::Vector,
            meaning: "",
        },
        FieldInfo {
            name: "model.kinetic",
            unit: "J/m",
            site: Site::Model,
            shape: Shape::Scalar,
            meaning: "",
        },
        FieldInfo {
            name: "group.max_displacement",
            unit: "m",
            site: Site::Group,
            shape: Shape::Scalar,
            meaning: "",
        },
    ];

    fn setup() -> Setup {
        let block = |name: &str| BlockSpec {
            name: name.to_owned(),
            vertices: vec![Vec2::ZERO, Vec2::X, Vec2::Y],
            material: 0,
            density: 1.0,
            velocity: Vec2::ZERO,
            spin: 0.0,
        };
        Setup {
            blocks: ["slope", "wall.1", "wall.2"].map(block).to_vec(),
            groups: vec![
                Group {
                    name: "slope".to_owned(),
                    blocks: vec![0],
                },
                Group {
                    name: "wall".to_owned(),
                    blocks: vec![1, 2],
                },
            ],
            ..Setup::default()
        }
    }

    fn scene(check: &str) -> Parsed {
        let text = format!(
            "riprap = 1\ntitle = \"t\"\n[space.planar]\ngravity = [\"0 m/s2\", \"-9.81 m/s2\"]\n\
             [materials.rock]\ndensity = \"2600 kg/m3\"\n\
             [interfaces.default]\nnormal_stiffness = \"10 GPa/m\"\nfriction_angle = \"30 deg\"\n\
             [[blocks]]\nname = \"slope\"\nmaterial = \"rock\"\n\
             rectangle = {{ size = [\"1 m\", \"1 m\"], corner = [\"0 m\", \"0 m\"] }}\n\
             [[blocks]]\nname = \"wall\"\nmaterial = \"rock\"\n\
             rectangle = {{ size = [\"1 m\", \"1 m\"], corner = [\"2 m\", \"0 m\"] }}\n\
             copies = {{ count = 2, step = [\"1 m\", \"0 m\"] }}\n\
             [[phases]]\nname = \"go\"\nuntil = {{ time = \"1 s\" }}\n\
             [[checks]]\nname = \"c\"\n{check}\n"
        );
        match scenario::parse(Source::new("t.toml", text)) {
            Ok(parsed) => parsed,
            Err(wrong) => panic!("{wrong}"),
        }
    }

    fn resolved(check: &str) -> Result<Check, String> {
        let all = checks(&scene(check), "default", &setup(), TABLE);
        all.map(|mut list| list.remove(0))
            .map_err(|wrong| wrong.render())
    }

    #[test]
    fn a_formula_takes_values_of_keys() {
        let check = resolved(
            "field = \"block.displacement\"\nof = \"slope\"\nalong = \"-35 deg\"\nat = \"0.5 s\"\n\
             formula = \"tan(phi)*g*t\"\nrelative = 1e-9\n\
             let = { phi = \"interfaces.default.friction_angle\", g = 10 }",
        )
        .unwrap();
        assert_eq!(
            (check.of.as_slice(), check.window),
            ([0].as_slice(), Window::At(0.5))
        );
        assert!((check.along.unwrap()[1] + 35f64.to_radians().sin()).abs() < 1e-12);
        let mut watch = Watch::new(check);
        watch.observe(0.5, 30f64.to_radians().tan() * 5.0);
        assert_eq!(watch.finish("", "", false).status, Status::Passed);
    }

    #[test]
    fn groups_units_and_reductions() {
        let check = resolved(
            "field = \"group.max_displacement\"\nof = \"wall\"\nover = [\"0 s\", \"1 s\"]\n\
             reduce = \"first_above\"\nthreshold = \"1 mm\"\nbetween = [\"0 ms\", \"200 ms\"]",
        )
        .unwrap();
        assert_eq!(check.of, [1, 2]);
        let reduce = Reduce::FirstAbove(1e-3);
        assert_eq!(
            check.window,
            Window::Over {
                from: 0.0,
                to: 1.0,
                reduce
            }
        );
        assert!(
            matches!(check.expected, Expected::Between(low, high) if low == 0.0 && high == 0.2)
        );
    }

    #[test]
    fn mistakes_are_pointed_at() {
        let base = "value = \"1 m\"\nrelative = 0.1";
        for (check, part) in [
            (
                "field = \"block.displacment.x\"\nof = \"slope\"",
                "did you mean `block.displacement`",
            ),
            (
                "field = \"block.displacement.x\"\nof = \"wall\"",
                "group of 2 blocks",
            ),
            (
                "field = \"block.displacement\"\nof = \"slope\"",
                "is a vector",
            ),
            (
                "field = \"block.displacement.x\"\nof = [\"slope\", \"wall.1\"]",
                "needs one block",
            ),
            ("field = \"block.displacement.x\"", "needs one block"),
            ("field = \"model.kinetic\"", "this is a length"),
        ] {
            let text = resolved(&format!("{check}\n{base}")).unwrap_err();
            assert!(
                text.contains(part) && text.contains("t.toml:"),
                "{part}: {text}"
            );
        }
    }
}
