//! Changed keys: `--set key=value`, sweeps and variants. The text is edited, so comments and
//! order stay, and the result can be written down as `scenario.resolved.toml`.

use toml::de::DeTable;
use toml_edit::{DocumentMut, Item, Value};

use super::diagnostic::{Diagnostic, Diagnostics, Source, short};
use super::language::Scenario;
use super::load::syntax_error;
use super::path::{resolve, split};

/// Most cases that one scenario may expand to.
pub(crate) const MAX_CASES: usize = 1000;

/// Longest value of `--set`, bytes.
const MAX_VALUE: usize = 100_000;

/// One run of a sweep.
#[derive(Debug, Clone, PartialEq)]
pub struct Case {
    /// Unique name, fit for a folder.
    pub name: String,
    /// Name of the variant, `default` for the scene as it stands.
    pub variant: String,
    /// Changed keys and their TOML values, variant first.
    pub changes: Vec<(String, String)>,
    /// Keys that a search or a comparison sets itself: after everything else, `--set` included.
    pub trial: Vec<(String, String)>,
}

impl Case {
    /// Whether it is the scene as it stands.
    #[must_use]
    pub fn is_plain(&self) -> bool {
        self.changes.is_empty() && self.trial.is_empty()
    }

    /// The text of this case: changes made, `[sweep]`, `[variants]`, `[distributions]` and the checks of other
    /// variants taken out. `set` (the changes of the command line) wins over variant and sweep.
    ///
    /// # Errors
    /// A key that leads nowhere.
    pub fn source(&self, source: &Source, set: &[(String, String)]) -> Result<Source, Diagnostics> {
        let mut resolved = source.clone();
        if !self.is_plain() {
            for changes in [&self.changes[..], set, &self.trial] {
                resolved = apply_overrides(&resolved, changes)?;
            }
        }
        let mut document = edit(&resolved)?;
        for table in ["sweep", "variants", "distributions"] {
            document.remove(table);
        }
        if let Some(checks) = document.get_mut("checks") {
            self.keep_own_checks(checks);
        }
        resolved.text = document.to_string();
        Ok(resolved)
    }

    /// Without `[variants]` their names mean nothing: `only` goes, and with it the checks of others.
    fn keep_own_checks(&self, checks: &mut Item) {
        let own = |only: Option<&Value>| {
            let Some(names) = only.and_then(Value::as_array) else {
                return true;
            };
            names.is_empty() || names.iter().any(|name| name.as_str() == Some(&self.variant))
        };
        if let Some(tables) = checks.as_array_of_tables_mut() {
            tables.retain(|check| own(check.get("only").and_then(Item::as_value)));
            tables.iter_mut().for_each(|check| drop(check.remove("only")));
        }
        // The same written in one line: `checks = [{ ... }]`.
        if let Some(list) = checks.as_array_mut() {
            list.retain(|check| own(check.as_inline_table().and_then(|t| t.get("only"))));
            let tables = list.iter_mut().filter_map(Value::as_inline_table_mut);
            tables.for_each(|check| drop(check.remove("only")));
        }
    }
}

fn edit(source: &Source) -> Result<DocumentMut, Diagnostics> {
    source.text.parse::<DocumentMut>().map_err(|error| {
        let diagnostic = syntax_error(&source.text, error.message(), error.span());
        Diagnostics::new(source.clone(), vec![diagnostic])
    })
}

/// The text with changed keys. A value is read as TOML; what is no TOML value is a text, so that
/// `30 deg` needs no quotes.
///
/// # Errors
/// The text is no TOML, or a key leads nowhere.
pub fn apply_overrides(
    source: &Source,
    changes: &[(String, String)],
) -> Result<Source, Diagnostics> {
    if changes.is_empty() {
        return Ok(source.clone());
    }
    let mut text = source.text.clone();
    for (key, value) in changes {
        let current = Source::new(source.name.clone(), text);
        let document = set(&current, key, value)?;
        text = document.to_string();
    }
    Ok(Source::new(source.name.clone(), text))
}

/// Refuses changes of the command line that reach what the scene varies (the keys of `[sweep]` or of `[distributions]`): they win over
/// it, and its cases would all be the same under different names.
///
/// # Errors
/// The first such change.
pub fn varied_and_set(
    source: &Source,
    (table, keys): (&str, &[&str]),
    changes: &[(String, String)],
) -> Result<(), Diagnostics> {
    let root: toml::Value =
        toml::from_str(&source.text).unwrap_or_else(|_| toml::Table::new().into());
    for varied in keys {
        let words = places(&root, varied);
        for (key, value) in changes {
            let set = places(&root, key);
            if !(set.starts_with(&words) || words.starts_with(&set)) {
                continue;
            }
            let message = format!(
                "`--set {}` fixes what the scene varies: `{table}.\"{varied}\"`",
                short(&format!("{key}={value}"))
            );
            let error = Diagnostic::error("set.swept", message).help(
                format!("leave `--set` out; or run the scene once with it: `riprap run`; the values that are varied stand in `[{table}]`"),
            );
            // The change stands on the command line: no place in the file can be shown.
            let nowhere = Source::new(source.name.clone(), "");
            return Err(Diagnostics::new(nowhere, vec![error]));
        }
    }
    Ok(())
}

/// The words of a key, entries of lists by their number where the file has them.
fn places(root: &toml::Value, key: &str) -> Vec<String> {
    let mut here = Some(root);
    let mut words = split(key).unwrap_or_else(|_| vec![key.to_owned()]);
    for word in &mut words {
        here = match here {
            Some(toml::Value::Table(table)) => table.get(word.as_str()),
            Some(toml::Value::Array(items)) => {
                let name = |item: &toml::Value| {
                    item.get("name").and_then(toml::Value::as_str) == Some(word.as_str())
                };
                let at = items.iter().position(name).or_else(|| word.parse().ok());
                at.and_then(|at| {
                    *word = at.to_string();
                    items.get(at)
                })
            }
            Some(_) | None => None,
        };
    }
    words
}

fn set(source: &Source, key: &str, value: &str) -> Result<DocumentMut, Diagnostics> {
    let fail = |diagnostic: Diagnostic| {
        Diagnostics::new(Source::new(source.name.clone(), ""), vec![diagnostic])
    };
    if value.len() > MAX_VALUE {
        return Err(fail(Diagnostic::error(
            "set.value",
            format!("the value of `{key}` is too long"),
        )));
    }
    let root = DeTable::parse(&source.text).map_err(|error| {
        let diagnostic = syntax_error(&source.text, error.message(), error.span());
        Diagnostics::new(source.clone(), vec![diagnostic])
    })?;
    let unknown = |error: super::path::PathError| {
        let mut diagnostic =
            Diagnostic::error("set.key", format!("cannot set `{key}`: {}", error.message));
        diagnostic.help = error.help;
        fail(diagnostic)
    };
    resolve(root.get_ref(), key).map_err(unknown)?;
    let words = split(key).map_err(unknown)?;
    let mut document = edit(source)?;
    let value: Value = value.trim().parse().unwrap_or_else(|_| Value::from(value.trim()));
    if put(document.as_item_mut(), &words, value).is_none() {
        let message = format!("cannot set `{key}`: a value stands where a table is needed");
        return Err(fail(Diagnostic::error("set.key", message)));
    }
    Ok(document)
}

/// Puts a value at the end of a path, making tables on the way.
fn put(item: &mut Item, words: &[String], value: Value) -> Option<()> {
    let [first, rest @ ..] = words else {
        return None;
    };
    if let Item::ArrayOfTables(tables) = item {
        let index = position(tables.iter().map(|table| table.get("name")), first)?;
        // A table of the list, seen as an item like all others.
        let table = tables.get_mut(index)?;
        let mut inner = Item::Table(std::mem::take(table));
        let done = put(&mut inner, rest, value);
        if let Item::Table(changed) = inner {
            *table = changed;
        }
        return done;
    }
    if let Item::Value(Value::Array(array)) = item {
        let names: Vec<Option<Item>> = array
            .iter()
            .map(|entry| entry.as_inline_table()?.get("name").cloned().map(Item::Value))
            .collect();
        let index = position(names.iter().map(Option::as_ref), first)?;
        let entry = array.get_mut(index)?;
        let mut inner = Item::Value(entry.clone());
        if rest.is_empty() {
            *entry = value;
            return Some(());
        }
        put(&mut inner, rest, value)?;
        *entry = inner.into_value().ok()?;
        return Some(());
    }
    let table = item.as_table_like_mut()?;
    if rest.is_empty() {
        let mut value = value;
        match table.get_mut(first) {
            Some(old) => {
                if let Some(old) = old.as_value() {
                    *value.decor_mut() = old.decor().clone();
                }
                *old = Item::Value(value);
            }
            None => {
                table.insert(first, Item::Value(value));
            }
        }
        return Some(());
    }
    if table.get(first).is_none() {
        let mut new = toml_edit::Table::new();
        // No head of its own in the text, where it only holds other tables.
        new.set_implicit(true);
        table.insert(first, Item::Table(new));
    }
    put(table.get_mut(first)?, rest, value)
}

fn position<'a>(names: impl Iterator<Item = Option<&'a Item>>, word: &str) -> Option<usize> {
    let mut count = 0;
    for (index, name) in names.enumerate() {
        if name.and_then(Item::as_str) == Some(word) {
            return Some(index);
        }
        count = index + 1;
    }
    word.parse::<usize>().ok().filter(|index| *index < count)
}

/// The cases of a scenario: every variant with every combination of swept values. A scenario
/// without sweep and variants has one case without changes, called `default`.
///
/// # Errors
/// More than a thousand cases.
pub fn cases(source: &Source, scenario: &Scenario) -> Result<Vec<Case>, Diagnostics> {
    let plain: Vec<(String, String)> = Vec::new();
    let mut variants: Vec<(String, Vec<(String, String)>)> = Vec::new();
    if scenario.variants.get("default").is_none() {
        variants.push(("default".to_owned(), plain));
    }
    for (name, changes) in scenario.variants.iter() {
        let changes =
            changes.iter().map(|(key, value)| (key.text.clone(), value.to_string())).collect();
        variants.push((name.text.clone(), changes));
    }
    let mut count = variants.len();
    for (key, values) in scenario.sweep.iter() {
        count = count.saturating_mul(values.len());
        if count > MAX_CASES {
            let diagnostic = Diagnostic::error(
                "sweep.size",
                format!("the sweep has more than {MAX_CASES} cases"),
            )
            .at(key.span.clone())
            .help("sweep over fewer values, or split the sweep in several files");
            return Err(Diagnostics::new(source.clone(), vec![diagnostic]));
        }
    }
    let mut cases: Vec<Case> = variants
        .into_iter()
        .map(|(variant, changes)| Case {
            name: variant.clone(),
            variant,
            changes,
            trial: Vec::new(),
        })
        .collect();
    let name_variant = cases.len() > 1;
    let lasts: Vec<&str> =
        scenario.sweep.names().map(|key| key.rsplit('.').next().unwrap_or(key)).collect();
    for (index, (key, values)) in scenario.sweep.iter().enumerate() {
        let last = lasts[index];
        // The last word of a key will do as long as no other swept key ends with it.
        let unique = lasts.iter().filter(|other| **other == last).count() == 1;
        let label = if unique { last } else { key.as_str() };
        let named = index > 0 || name_variant;
        let pairs = cases.iter().flat_map(|case| values.iter().map(move |value| (case, value)));
        let swept = pairs.map(|(case, value)| {
            let mut case = case.clone();
            let shown = value.as_str().map_or_else(|| value.to_string(), str::to_owned);
            let part = folder_name(&format!("{label}={shown}"));
            case.name = if named { format!("{}_{part}", case.name) } else { part };
            case.changes.push((key.text.clone(), value.to_string()));
            case
        });
        cases = swept.collect();
    }
    make_unique(&mut cases);
    Ok(cases)
}

/// Numbers cases whose names would be those of one folder.
fn make_unique(cases: &mut [Case]) {
    let mut used = std::collections::BTreeSet::new();
    for case in cases {
        let base = folder_name(&case.name);
        case.name.clone_from(&base);
        let mut number = 2;
        while !used.insert(case.name.clone()) {
            case.name = format!("{base}-{number}");
            number += 1;
        }
    }
}

/// Letters, digits and `. _ = + -` only, of bounded length.
fn folder_name(text: &str) -> String {
    let kept: String = text
        .chars()
        .filter(|c| !c.is_whitespace())
        .map(|c| if c.is_ascii_alphanumeric() || "._=+-".contains(c) { c } else { '-' })
        .take(120)
        .collect();
    if kept.trim_matches('.').is_empty() { "case".to_owned() } else { kept }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "title = \"a\" # keep\n[materials.rock]\ndensity = \"1 kg/m3\" # this\n\
        [interfaces.default]\n[[blocks]]\nname = \"slope\"\nrectangle = { size = [\"1 m\", \"2 m\"] }\n";

    fn with(changes: &[(&str, &str)]) -> Result<String, String> {
        let changes: Vec<(String, String)> =
            changes.iter().map(|(k, v)| ((*k).to_owned(), (*v).to_owned())).collect();
        apply_overrides(&Source::new("a.toml", TEXT), &changes)
            .map(|source| source.text)
            .map_err(|diagnostics| diagnostics.render())
    }

    #[test]
    fn the_text_of_a_case_has_its_own_checks_alone() {
        let text = "title = \"a\"\n[variants.b]\n\"title\" = \"b\"\n[[checks]]\nname = \"x\"\nonly = [\"b\"]\n\
            [[checks]]\nname = \"y\"\nonly = [\"default\"]\n[[checks]]\nname = \"z\"\n";
        let case = Case {
            name: "b".to_owned(),
            variant: "b".to_owned(),
            changes: vec![("title".to_owned(), "\"b\"".to_owned())],
            trial: Vec::new(),
        };
        let source = Source::new("a.toml", text);
        let text = case.source(&source, &[]).unwrap().text;
        assert_eq!(text, "title = \"b\"\n[[checks]]\nname = \"x\"\n[[checks]]\nname = \"z\"\n");
        // The command line wins over the variant, a trial of a search over both.
        let set = [("title".to_owned(), "\"c\"".to_owned())];
        let text = case.source(&source, &set).unwrap().text;
        assert!(text.starts_with("title = \"c\"\n"), "{text}");
        let trial = vec![("title".to_owned(), "\"d\"".to_owned())];
        let text = Case { trial, ..case }.source(&source, &set).unwrap().text;
        assert!(text.starts_with("title = \"d\"\n"), "{text}");
    }

    /// Such a case was refused: there was no variant of the name in `only` any more.
    #[test]
    fn checks_in_one_line_are_those_of_the_case_too() {
        let text = "checks = [{ name = \"x\", only = [\"b\"] }, { name = \"y\", only = [\"default\"] }, { name = \"z\" }]\n\
            [variants.b]\n\"title\" = \"b\"\n";
        let case = Case {
            name: "b".to_owned(),
            variant: "b".to_owned(),
            changes: Vec::new(),
            trial: Vec::new(),
        };
        let text = case.source(&Source::new("a.toml", text), &[]).unwrap().text;
        let read: toml::Table = toml::from_str(&text).unwrap();
        let checks = read["checks"].as_array().unwrap();
        let names: Vec<&str> = checks.iter().filter_map(|c| c["name"].as_str()).collect();
        assert_eq!(names, ["x", "z"], "{text}");
        assert!(!text.contains("only"), "{text}");
    }

    #[test]
    fn edits_keys_and_keeps_comments() {
        let text = with(&[
            ("materials.rock.density", "2600 kg/m3"),
            ("materials.rock.poisson", "0.25"),
            ("interfaces.default.friction_angle", "\"5 deg\""),
            ("interfaces.default.bond.tension", "1 MPa"),
            ("blocks.slope.rectangle.size", "[\"3 m\", \"4 m\"]"),
            ("blocks.slope.rectangle.size.1", "5 m"),
            ("blocks.0.velocity", "[\"1 m/s\", \"0 m/s\"]"),
        ])
        .unwrap();
        assert!(text.contains("density = \"2600 kg/m3\" # this"), "{text}");
        assert!(text.contains("poisson = 0.25"), "{text}");
        assert!(text.contains("friction_angle = \"5 deg\""), "{text}");
        assert!(text.contains("tension = \"1 MPa\""), "{text}");
        assert!(text.contains("[\"3 m\", \"5 m\"]"), "{text}");
        assert!(text.contains("velocity = [\"1 m/s\", \"0 m/s\"]"), "{text}");
        assert!(text.contains("# keep"), "{text}");
    }

    #[test]
    fn refuses_keys_that_lead_nowhere() {
        let error = with(&[("materials.rok.density", "1 kg/m3")]).unwrap_err();
        assert!(error.contains("did you mean `rock`?"), "{error}");
        let error = with(&[("materials.rock.densty", "1 kg/m3")]).unwrap_err();
        assert!(error.contains("did you mean `density`?"), "{error}");
        let error = with(&[("blocks.slop.name", "x")]).unwrap_err();
        assert!(error.contains("did you mean `slope`?"), "{error}");
        assert!(with(&[("", "x")]).is_err());
        assert!(with(&[("blocks.7.name", "x")]).is_err());
    }
}
