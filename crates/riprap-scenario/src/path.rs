//! Keys written with dots: `interfaces.default.friction_angle`, `blocks.slope.velocity`,
//! `blocks.0.name`. Entries of a list are named by index from 0 or by their `name`.

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::diagnostic::{short, suggest};
use super::schema::Node;

/// Longest key accepted, bytes.
const MAX_LENGTH: usize = 500;

/// A key that leads nowhere.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct PathError {
    /// What is wrong.
    pub message: String,
    /// What there is instead.
    pub help: Option<String>,
}

/// Where a key leads.
#[derive(Debug, Clone, Copy)]
pub(super) struct Place<'a, 'i> {
    /// What the language expects there.
    pub node: Node,
    /// What the file says there.
    pub value: Option<&'a Spanned<DeValue<'i>>>,
}

/// Words of a key; a word in double quotes may contain dots.
pub(crate) fn split(path: &str) -> Result<Vec<String>, PathError> {
    let wrong = |message: &str| PathError {
        message: format!("`{}` {message}", short(path)),
        help: Some("write a key with dots, for example `materials.rock.density`".to_owned()),
    };
    if path.len() > MAX_LENGTH {
        return Err(wrong("is too long for a key"));
    }
    let mut words = Vec::new();
    let mut word = String::new();
    let mut quoted = false;
    for c in path.trim().chars() {
        match c {
            '"' => quoted = !quoted,
            '.' if !quoted => words.push(std::mem::take(&mut word)),
            c => word.push(c),
        }
    }
    words.push(word);
    if quoted || words.iter().any(String::is_empty) {
        return Err(wrong("is not a key"));
    }
    Ok(words)
}

/// Follows a key through the file and the language.
///
/// Tables with fixed keys may be absent from the file (the key could be added there); free names
/// (materials, interfaces, ...) and list entries must exist.
pub(super) fn resolve<'a, 'i>(
    root: &'a DeTable<'i>,
    path: &str,
) -> Result<Place<'a, 'i>, PathError> {
    let words = split(path)?;
    let mut node = Node::root();
    let mut table: Option<&'a DeTable<'i>> = Some(root);
    let mut value: Option<&'a Spanned<DeValue<'i>>> = None;
    let mut walked: Vec<&str> = Vec::new();
    for word in &words {
        let here = if walked.is_empty() { "the scenario".to_owned() } else { walked.join(".") };
        node = node.towards(word);
        let variants = node.variants();
        if let Some((_, schema)) = node.properties().find(|(key, _)| key == word) {
            node = Node::resolve(schema);
            value = table.and_then(|table| table.get(word.as_str()));
        } else if let Some((_, schema, _)) = variants.iter().find(|(key, _, _)| key == word) {
            node = Node::resolve(schema);
            value = table.and_then(|table| table.get(word.as_str()));
        } else if let Some(schema) = node.free_values() {
            value = table.and_then(|table| table.get(word.as_str()));
            if value.is_none() {
                let known: Vec<&str> =
                    table.into_iter().flatten().map(|(key, _)| key.get_ref().as_ref()).collect();
                return Err(PathError {
                    message: format!("there is no `{}` in {here}", short(word)),
                    help: suggest(word, known),
                });
            }
            node = Node::resolve(schema);
        } else if let Some(schema) = node.value.get("items") {
            let items = value.and_then(|value| value.get_ref().as_array());
            let entries: Vec<&Spanned<DeValue<'i>>> = items.into_iter().flatten().collect();
            value = find_entry(&entries, word);
            if value.is_none() {
                let names: Vec<String> = (0..entries.len())
                    .map(|index| entry_name(entries[index]).unwrap_or(index.to_string()))
                    .collect();
                return Err(PathError {
                    message: format!("there is no `{}` in {here}", short(word)),
                    help: suggest(word, names.iter().map(String::as_str)),
                });
            }
            node = Node::resolve(schema);
        } else {
            let known: Vec<&str> = node
                .properties()
                .map(|(key, _)| key)
                .chain(variants.iter().map(|(key, _, _)| *key))
                .collect();
            return Err(PathError {
                message: format!("there is no key `{}` in {here}", short(word)),
                help: suggest(word, known),
            });
        }
        table = value.and_then(|value| value.get_ref().as_table());
        walked.push(word);
    }
    Ok(Place { node, value })
}

fn entry_name(entry: &Spanned<DeValue<'_>>) -> Option<String> {
    let table = entry.get_ref().as_table()?;
    table.get("name").and_then(|name| name.get_ref().as_str()).map(str::to_owned)
}

fn find_entry<'a, 'i>(
    entries: &[&'a Spanned<DeValue<'i>>],
    word: &str,
) -> Option<&'a Spanned<DeValue<'i>>> {
    // A name first, so that an entry whose name is a number can be reached.
    let named = entries.iter().find(|entry| entry_name(entry).as_deref() == Some(word));
    named.copied().or_else(|| entries.get(word.parse::<usize>().ok()?).copied())
}

/// A TOML value as comparable plain data.
pub(super) fn plain(value: &DeValue<'_>) -> Option<toml::Value> {
    Some(match value {
        DeValue::String(text) => toml::Value::String(text.to_string()),
        DeValue::Integer(number) => {
            toml::Value::Integer(i64::from_str_radix(number.as_str(), number.radix()).ok()?)
        }
        DeValue::Float(number) => toml::Value::Float(number.as_str().parse().ok()?),
        DeValue::Boolean(value) => toml::Value::Boolean(*value),
        DeValue::Datetime(value) => toml::Value::Datetime(*value),
        DeValue::Array(items) => toml::Value::Array(
            items.iter().map(|item| plain(item.get_ref())).collect::<Option<Vec<_>>>()?,
        ),
        DeValue::Table(table) => toml::Value::Table(
            table
                .iter()
                .map(|(key, value)| Some((key.get_ref().to_string(), plain(value.get_ref())?)))
                .collect::<Option<toml::Table>>()?,
        ),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn splits_keys() {
        assert_eq!(split("a.b.0").unwrap(), ["a", "b", "0"]);
        assert_eq!(split("blocks.\"wall.3\".name").unwrap(), ["blocks", "wall.3", "name"]);
        for bad in ["", ".", "a..b", "a.", "a.\"b"] {
            assert!(split(bad).is_err(), "{bad}");
        }
    }

    #[test]
    fn finds_places() {
        let text = "[materials.rock]\ndensity = \"1 kg/m3\"\n[[blocks]]\nname = \"slope\"\n";
        let root = DeTable::parse(text).unwrap();
        let root = root.get_ref();
        assert!(resolve(root, "materials.rock.density").unwrap().value.is_some());
        assert!(resolve(root, "materials.rock.young").unwrap().value.is_none());
        assert!(resolve(root, "blocks.slope.name").unwrap().value.is_some());
        assert!(resolve(root, "blocks.0.velocity").unwrap().value.is_none());
        let error = resolve(root, "materials.rok.density").unwrap_err();
        assert_eq!(error.help.as_deref(), Some("did you mean `rock`?"));
        let error = resolve(root, "materials.rock.densty").unwrap_err();
        assert_eq!(error.help.as_deref(), Some("did you mean `density`?"));
        assert!(resolve(root, "blocks.1.name").is_err());
        assert!(resolve(root, "title.x").is_err());
    }
}
