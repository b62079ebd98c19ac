//! JSON schema of the language, and the documentation of its keys that is made from it.

use std::sync::LazyLock;

use serde_json::Value;

use super::diagnostic::closest;
use super::language::Scenario;
use super::quantity::KindInfo;

/// The schema is a constant of the program; it is built once when first needed.
static SCHEMA: LazyLock<Value> = LazyLock::new(|| {
    let mut schema = schemars::schema_for!(Scenario).to_value();
    if let Some(object) = schema.as_object_mut() {
        object.insert("title".to_owned(), Value::from("riprap scenario"));
    }
    schema
});

/// The JSON schema as a value.
pub fn schema() -> &'static Value {
    &SCHEMA
}

/// The JSON schema as text, for editors (`#:schema ./riprap.schema.json`).
pub fn schema_text() -> String {
    // A Value always has a text.
    serde_json::to_string_pretty(schema()).unwrap_or_default()
}

/// A schema with references followed.
#[derive(Debug, Clone, Copy)]
pub(super) struct Node {
    /// The schema itself.
    pub value: &'static Value,
    /// Name of the quantity kind or special text type that was referred to.
    pub type_name: Option<&'static str>,
}

impl Node {
    /// Schema of the whole file.
    pub fn root() -> Self {
        Node {
            value: schema(),
            type_name: None,
        }
    }

    /// Follows references and strips "or null".
    pub fn resolve(value: &'static Value) -> Self {
        let mut node = Node {
            value,
            type_name: None,
        };
        // References are never deeper than a few; the bound only guards against a loop.
        for _ in 0..8 {
            if let Some(name) = node.value.get("$ref").and_then(Value::as_str) {
                let name = name.trim_start_matches("#/$defs/");
                let Some(target) = schema().get("$defs").and_then(|defs| defs.get(name)) else {
                    break;
                };
                node = Node {
                    value: target,
                    type_name: Some(name),
                };
            } else if let Some(inner) = only_alternative(node.value) {
                node = Node {
                    value: inner,
                    type_name: None,
                };
            } else {
                break;
            }
        }
        node
    }

    /// The kind of quantity expected here.
    pub fn kind(self) -> Option<&'static KindInfo> {
        KindInfo::named(self.type_name?)
    }

    /// The schema of a key of a table with fixed keys.
    pub fn properties(self) -> impl Iterator<Item = (&'static str, &'static Value)> + Clone {
        self.value
            .get("properties")
            .and_then(Value::as_object)
            .into_iter()
            .flatten()
            .map(|(key, value)| (key.as_str(), value))
    }

    /// The schema of the values of a table with free keys.
    pub fn free_values(self) -> Option<&'static Value> {
        match self.value.get("additionalProperties") {
            None | Some(Value::Bool(false)) => None,
            Some(schema) => Some(schema),
        }
    }

    /// Keys that must be there.
    pub fn required(self) -> impl Iterator<Item = &'static str> {
        self.value
            .get("required")
            .and_then(Value::as_array)
            .into_iter()
            .flatten()
            .filter_map(Value::as_str)
    }

    /// Variants that are tables of one key: (key, schema of its value, description).
    pub fn variants(self) -> Vec<(&'static str, &'static Value, &'static Value)> {
        let alternatives = self.value.get("oneOf").and_then(Value::as_array);
        alternatives
            .into_iter()
            .flatten()
            .filter_map(|alternative| {
                let (key, value) = alternative.get("properties")?.as_object()?.iter().next()?;
                Some((key.as_str(), value, alternative))
            })
            .collect()
    }

    /// Words that may stand here: (word, description).
    pub fn words(self) -> Vec<(&'static str, &'static str)> {
        if let Some(words) = self.value.get("enum").and_then(Value::as_array) {
            return words
                .iter()
                .filter_map(|word| Some((word.as_str()?, "")))
                .collect();
        }
        if let Some(word) = self.value.get("const").and_then(Value::as_str) {
            return vec![(word, description(self.value))];
        }
        let alternatives = self.value.get("oneOf").and_then(Value::as_array);
        alternatives
            .into_iter()
            .flatten()
            .flat_map(|alternative| {
                Node {
                    value: alternative,
                    type_name: None,
                }
                .words()
            })
            .collect()
    }

    /// Whether a JSON type is allowed.
    pub fn allows(self, json_type: &str) -> bool {
        match self.value.get("type") {
            Some(Value::String(only)) => only == json_type,
            Some(Value::Array(types)) => types.iter().any(|one| one == json_type),
            _ => false,
        }
    }
}

fn only_alternative(value: &'static Value) -> Option<&'static Value> {
    let alternatives = value.get("anyOf")?.as_array()?;
    let is_null = |schema: &Value| schema.get("type").is_some_and(|kind| kind == "null");
    let mut rest = alternatives.iter().filter(|schema| !is_null(schema));
    match (rest.next(), rest.next()) {
        (Some(only), None) => Some(only),
        _ => None,
    }
}

/// The doc comment of a schema, on one line.
pub(super) fn description(value: &'static Value) -> &'static str {
    value
        .get("description")
        .and_then(Value::as_str)
        .unwrap_or_default()
}

fn flat(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// One key of the language.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct KeyDoc {
    /// Path with dots; `*` stands for a free name or an index.
    pub path: String,
    /// What it takes, in a few words.
    pub takes: String,
    /// What it means.
    pub text: String,
    /// Whether its table must have it.
    pub required: bool,
    /// Allowed words, with their meaning.
    pub words: Vec<(String, String)>,
}

/// Every key of the language; tables in alphabetical order.
pub fn keys() -> Vec<KeyDoc> {
    let mut out = Vec::new();
    collect(Node::root(), "", &mut out);
    out
}

fn collect(node: Node, path: &str, out: &mut Vec<KeyDoc>) {
    // Deeper paths would only repeat; the language is at most this deep.
    if path.matches('.').count() > 12 {
        return;
    }
    let join = |key: &str| {
        if path.is_empty() {
            key.to_owned()
        } else {
            format!("{path}.{key}")
        }
    };
    let required: Vec<&str> = node.required().collect();
    for (key, value) in node.properties() {
        add(value, value, &join(key), required.contains(&key), out);
    }
    for (key, value, alternative) in node.variants() {
        add(value, alternative, &join(key), false, out);
    }
    if let Some(value) = node.free_values() {
        let inner = Node::resolve(value);
        add(value, inner.value, &join("*"), false, out);
    }
}

fn add(
    value: &'static Value,
    documented: &'static Value,
    path: &str,
    required: bool,
    out: &mut Vec<KeyDoc>,
) {
    let node = Node::resolve(value);
    let own = flat(description(documented));
    let of_type = flat(description(node.value));
    let text = match (own.is_empty(), of_type.is_empty() || of_type == own) {
        (true, _) => of_type,
        (false, true) => own,
        // Only what the text of the key cannot know: "Exactly one of ...".
        (false, false) => match of_type.split_once(". ") {
            Some((_, more)) if node.kind().is_none() && !own.contains(more) => {
                format!("{own} {more}")
            }
            _ => own,
        },
    };
    let words = node.words();
    // A free name without text of its own is documented by the key above it.
    if !text.is_empty() || !path.ends_with('*') {
        out.push(KeyDoc {
            path: path.to_owned(),
            takes: takes(node),
            text,
            required,
            words: words
                .into_iter()
                .map(|(word, text)| (word.to_owned(), flat(text)))
                .collect(),
        });
    }
    collect(node, path, out);
    if let Some(items) = node.value.get("items") {
        let items = Node::resolve(items);
        if items.allows("object") || !items.variants().is_empty() {
            collect(items, &format!("{path}.*"), out);
        }
    }
}

/// A value to copy, if one can be made up.
pub(super) fn example(node: Node) -> Option<String> {
    if let Some(kind) = node.kind() {
        let bare = kind.example.parse::<f64>().is_ok();
        return Some(if bare {
            kind.example.to_owned()
        } else {
            format!("\"{}\"", kind.example)
        });
    }
    if let Some((word, _)) = node.words().first() {
        return Some(format!("\"{word}\""));
    }
    let count = node.value.get("minItems").and_then(Value::as_u64)?;
    let item = example(Node::resolve(node.value.get("items")?))?;
    Some(format!(
        "[{}]",
        vec![item; count.min(3) as usize].join(", ")
    ))
}

/// What a value may be, in a few words.
pub(super) fn takes(node: Node) -> String {
    if let Some(kind) = node.kind() {
        return match kind.dim {
            Some(dim) if dim == super::units::Dim::NONE => {
                format!("a number, {}", kind.bounds.text)
            }
            Some(_) if kind.bounds.low.is_infinite() => {
                format!("{}, for example \"{}\"", kind.what, kind.example)
            }
            Some(_) => {
                format!(
                    "{}, {}, for example \"{}\"",
                    kind.what, kind.bounds.text, kind.example
                )
            }
            None => format!("{}, for example \"{}\"", kind.what, kind.example),
        };
    }
    match node.type_name {
        Some("Every") => return "a time, a number of steps, \"1 phase\" or \"never\"".to_owned(),
        Some("Moment") => return "a time, \"start\" or \"end\"".to_owned(),
        Some("Names") => return "a name or a list of names".to_owned(),
        _ => {}
    }
    let words = node.words();
    if !words.is_empty() {
        let words: Vec<&str> = words.iter().map(|(word, _)| *word).collect();
        return super::diagnostic::one_of(&words);
    }
    let variants = node.variants();
    if !variants.is_empty() {
        let keys: Vec<&str> = variants.iter().map(|(key, _, _)| *key).collect();
        return format!("a table with {}", super::diagnostic::one_of(&keys));
    }
    if node.allows("array") {
        let items = node.value.get("items").map(Node::resolve);
        let of = items.map(takes).unwrap_or_default();
        return match node.value.get("minItems").and_then(Value::as_u64) {
            Some(count) if count > 0 => format!("a list of {count}: each {of}"),
            _ => format!("a list: each {of}"),
        };
    }
    for (json, text) in [
        ("object", "a table"),
        ("string", "a text"),
        ("integer", "a whole number"),
        ("boolean", "true or false"),
        ("number", "a number"),
    ] {
        if node.allows(json) {
            return text.to_owned();
        }
    }
    "any value".to_owned()
}

fn fits(pattern: &str, path: &str) -> bool {
    let (pattern, path): (Vec<&str>, Vec<&str>) =
        (pattern.split('.').collect(), path.split('.').collect());
    pattern.len() == path.len() && pattern.iter().zip(&path).all(|(p, k)| *p == "*" || p == k)
}

/// Documentation of a key written with dots, such as `interfaces.default.normal_stiffness`.
/// Free names and indices may be anything or left out; a last word alone finds all its places.
///
/// # Errors
/// No such key; the text says which one is close.
pub fn explain_key(path: &str) -> Result<String, String> {
    let all = keys();
    let wanted: String = path
        .replace("[[", "")
        .replace("]]", "")
        .replace(['[', ']', '"'], "");
    let wanted = wanted.trim().trim_matches('.');
    if wanted.is_empty() || wanted.len() > 300 {
        return Err("write a key with dots, for example `materials.rock.density`".to_owned());
    }
    let without_stars = |key: &KeyDoc| key.path.replace(".*", "");
    let mut found: Vec<&KeyDoc> = all.iter().filter(|key| fits(&key.path, wanted)).collect();
    // `x.*` also fits a fixed key of the same place; the fixed one is meant.
    found.sort_by_key(|key| key.path.matches('*').count());
    found.truncate(1);
    if found.is_empty() {
        found = all
            .iter()
            .filter(|key| without_stars(key) == wanted)
            .collect();
    }
    if found.is_empty() {
        let ending = format!(".{wanted}");
        found = all
            .iter()
            .filter(|key| without_stars(key).ends_with(&ending))
            .collect();
    }
    if found.is_empty() {
        let last = wanted.rsplit('.').next().unwrap_or(wanted);
        let lasts: Vec<&str> = all
            .iter()
            .filter_map(|key| key.path.rsplit('.').find(|word| *word != "*"))
            .collect();
        let mut help = String::new();
        if let Some(word) = closest(last, lasts) {
            let ending = format!(".{word}");
            let places: Vec<&str> = all
                .iter()
                .map(|key| key.path.as_str())
                .filter(|path| *path == word || path.ends_with(&ending))
                .take(5)
                .collect();
            help = format!("; did you mean {}?", places.join(" or "));
        }
        return Err(format!("there is no key `{wanted}`{help}"));
    }
    let mut text = String::new();
    for key in found {
        if !text.is_empty() {
            text.push('\n');
        }
        text.push_str(&key_text(key, &all));
    }
    Ok(text)
}

fn key_text(key: &KeyDoc, all: &[KeyDoc]) -> String {
    let need = if key.required { " (required)" } else { "" };
    let mut text = format!(
        "{}{need}\n  {}\n  Takes {}.\n",
        key.path, key.text, key.takes
    );
    for (word, meaning) in key.words.iter().filter(|(_, meaning)| !meaning.is_empty()) {
        text.push_str(&format!("    {word}: {meaning}\n"));
    }
    let start = format!("{}.", key.path);
    let inside: Vec<&str> = all
        .iter()
        .filter_map(|other| other.path.strip_prefix(&start))
        .map(|rest| rest.trim_start_matches("*."))
        .filter(|rest| !rest.contains('.') && *rest != "*")
        .collect();
    if !inside.is_empty() {
        text.push_str(&format!("  Keys: {}.\n", inside.join(", ")));
    }
    text
}

/// The reference page of the language, made from the schema.
pub fn markdown() -> String {
    let mut text = String::from(
        "# Scenario reference\n\n\
         Generated by `riprap schema --markdown`; do not edit. `*` stands for a free name or for \
         an entry of a list.\n",
    );
    let mut section = "";
    let all = keys();
    for key in &all {
        let head = key.path.split('.').next().unwrap_or_default();
        if head != section {
            section = head;
            text.push_str(&format!("\n## {head}\n\n"));
        }
        let need = if key.required { ", required" } else { "" };
        text.push_str(&format!(
            "- **`{}`**{need}: {} Takes {}.\n",
            key.path, key.text, key.takes
        ));
        for (word, meaning) in key.words.iter().filter(|(_, meaning)| !meaning.is_empty()) {
            text.push_str(&format!("  - `{word}`: {meaning}\n"));
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_key_is_documented() {
        let keys = keys();
        assert!(keys.len() > 200, "{}", keys.len());
        for key in &keys {
            assert!(!key.text.is_empty(), "{} has no text", key.path);
            assert!(
                key.takes != "any value" || key.path.contains('*'),
                "{}",
                key.path
            );
        }
    }

    #[test]
    fn explains_keys() {
        let text = explain_key("interfaces.default.normal_stiffness").unwrap();
        assert!(text.contains("Pa/m") && text.contains("10 GPa/m"), "{text}");
        let text = explain_key("blocks.slope.arch.radius").unwrap();
        assert!(text.contains("centre line"), "{text}");
        let text = explain_key("blocks.arch.radius").unwrap();
        assert!(text.contains("centre line"), "{text}");
        let text = explain_key("joint_sets").unwrap();
        assert!(text.contains("persistence"), "{text}");
        let text = explain_key("interfaces.default.law").unwrap();
        assert!(text.contains("conserves energy"), "{text}");
        let error = explain_key("interfaces.default.normal_stifness").unwrap_err();
        assert!(error.contains("interfaces.*.normal_stiffness"), "{error}");
        assert!(explain_key("").is_err());
    }
}
