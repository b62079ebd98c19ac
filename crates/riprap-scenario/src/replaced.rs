//! What a changed key takes away: a variant, a sweep or `--set` puts a whole table in the place of another one.

use toml::de::{DeTable, DeValue};
use toml_edit::{InlineTable, Value};

use super::diagnostic::{Diagnostic, Source, list};
use super::overrides::apply_overrides;
use super::path::{resolve, split};

/// Tables of properties: a key that is not given has a default there, so that its loss goes unseen.
const PROPERTIES: [&str; 2] = ["interfaces", "materials"];

/// Code of the warnings of [`fallen_away`].
pub const TABLE_REPLACED: &str = "set.table";

/// A warning for each change of a table of properties that loses keys of the table it replaces. Keys that lead nowhere
/// are left to [`apply_overrides`].
#[must_use]
pub fn fallen_away(source: &Source, changes: &[(String, String)]) -> Vec<Diagnostic> {
    let mut found = Vec::new();
    let mut current = source.clone();
    for change in changes {
        found.extend(lost(&current, &change.0, &change.1));
        let Ok(next) = apply_overrides(&current, std::slice::from_ref(change)) else {
            return found;
        };
        current = next;
    }
    found
}

fn lost(source: &Source, key: &str, value: &str) -> Option<Diagnostic> {
    let Ok(Value::InlineTable(new)) = value.trim().parse::<Value>() else {
        return None;
    };
    let words = split(key).ok()?;
    if !PROPERTIES.contains(&words.first()?.as_str()) {
        return None;
    }
    let root = DeTable::parse(&source.text).ok()?;
    let place = resolve(root.get_ref(), key).ok()?;
    let DeValue::Table(old) = place.value?.get_ref() else {
        return None;
    };
    // Of a table that holds one of several forms, the other form is to go.
    if !place.node.variants().is_empty() {
        return None;
    }
    // `interfaces.default = {...}` without quotes is a new table `interfaces` with one entry.
    let levels = 2_usize.saturating_sub(words.len());
    let mut gone = Vec::new();
    missing(old, &new, "", levels, &mut gone);
    let gone: Vec<&str> = gone.iter().map(String::as_str).collect();
    if gone.is_empty() {
        return None;
    }
    let message = format!(
        "the new `{key}` takes the place of the whole table: {} of the scene {} away",
        list(&gone),
        if gone.len() == 1 { "falls" } else { "fall" }
    );
    let warning = Diagnostic::warning(TABLE_REPLACED, message);
    let mut instead = Vec::new();
    key_by_key(&new, key, levels, &mut instead);
    Some(match &instead[..] {
        [] => warning,
        _ => warning.help(format!("to keep them write key by key: {}", instead.join(", "))),
    })
}

/// Keys of the old table that the new one lacks, seen from the table; `levels` deep into tables that both have.
fn missing(
    old: &DeTable<'_>,
    new: &InlineTable,
    under: &str,
    levels: usize,
    gone: &mut Vec<String>,
) {
    for (name, value) in old {
        let name = name.get_ref();
        let inner = new.get(name.as_ref()).map(Value::as_inline_table);
        match (value.get_ref(), inner) {
            (_, None) => gone.push(format!("{under}{name}")),
            (DeValue::Table(old), Some(Some(new))) if levels > 0 => {
                missing(old, new, &format!("{under}{name}."), levels - 1, gone);
            }
            _ => {}
        }
    }
}

/// The new table as single changes.
fn key_by_key(new: &InlineTable, under: &str, levels: usize, instead: &mut Vec<String>) {
    for (name, value) in new {
        let path = format!("{under}.{name}");
        match value.as_inline_table() {
            Some(inner) if levels > 0 => key_by_key(inner, &path, levels - 1, instead),
            _ => instead.push(format!("\"{path}\" = {}", value.to_string().trim())),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_table_in_the_place_of_another_names_what_is_gone() {
        let text =
            "[interfaces.default]\nnormal_stiffness = \"1 GPa/m\"\nfriction_angle = \"30 deg\"\n";
        let source = Source::new("a.toml", text);
        let of = |key: &str, value: &str| {
            let found = fallen_away(&source, &[(key.to_owned(), value.to_owned())]);
            found
                .into_iter()
                .map(|d| format!("{}\n{}", d.message, d.help.unwrap_or_default()))
                .collect::<Vec<_>>()
        };
        let said = of("interfaces.default", "{ friction_angle = \"20 deg\" }");
        assert_eq!(said.len(), 1);
        assert!(said[0].contains("`normal_stiffness` of the scene falls away"), "{said:?}");
        assert!(said[0].contains("\"interfaces.default.friction_angle\" = \"20 deg\""), "{said:?}");
        let bare = of("interfaces", "{ default = { friction_angle = \"20 deg\" } }");
        assert!(bare[0].contains("`default.normal_stiffness` of the scene falls"), "{bare:?}");
        assert!(bare[0].contains("\"interfaces.default.friction_angle\" = \"20 deg\""), "{bare:?}");
        for (key, value) in [
            ("interfaces.default.friction_angle", "\"20 deg\""),
            (
                "interfaces.default",
                "{ friction_angle = \"20 deg\", normal_stiffness = \"2 GPa/m\" }",
            ),
            ("interfaces.default.bond", "{ tension = \"1 MPa\" }"),
            ("interfaces.nowhere", "{ tension = \"1 MPa\" }"),
        ] {
            assert!(of(key, value).is_empty(), "{key}");
        }
    }
}
