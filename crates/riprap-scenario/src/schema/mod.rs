//! JSON schema of the language, and the documentation of its keys that is made from it.

mod keys;
mod reference;
mod takes;

use std::sync::LazyLock;

use serde_json::Value;

use super::language::Scenario;
use super::quantity::KindInfo;
use super::vectors::InSpace;
pub use keys::{KeyDoc, explain_key, keys};
pub use reference::markdown;
pub(super) use takes::{example, takes};

/// The schema is a constant of the program; it is built once when first needed.
static SCHEMA: LazyLock<Value> = LazyLock::new(|| {
    let mut schema = schemars::schema_for!(Scenario).to_value();
    if let Some(object) = schema.as_object_mut() {
        object.insert("title".to_owned(), Value::from("riprap scenario"));
    }
    say_spaces(&mut schema);
    schema
});

/// Tells readers of descriptions which keys belong to one space only.
fn say_spaces(schema: &mut Value) {
    match schema {
        Value::Object(object) => {
            if let Some(space) = object.get("x-space").and_then(Value::as_str) {
                let only = format!("Only in [space.{space}].");
                let text = match object.get("description").and_then(Value::as_str) {
                    Some(text) => format!("{text} {only}"),
                    None => only,
                };
                object.insert("description".to_owned(), Value::from(text));
            }
            object.values_mut().for_each(say_spaces);
        }
        Value::Array(items) => items.iter_mut().for_each(say_spaces),
        Value::Null | Value::Bool(_) | Value::Number(_) | Value::String(_) => {}
    }
}

/// The only space that has a key, if there is one.
pub(super) fn only_space(schema: &Value) -> Option<InSpace> {
    InSpace::named(schema.get("x-space")?.as_str()?)
}

/// What to do in the other space.
pub(super) fn instead(schema: &'static Value) -> Option<&'static str> {
    schema.get("x-instead")?.as_str()
}

/// The JSON schema as a value.
pub(crate) fn schema() -> &'static Value {
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

/// A key as [`Node::each_key`] finds it.
#[derive(Clone, Copy)]
pub(crate) struct FoundKey {
    /// Schema of its value.
    pub value: &'static Value,
    /// Schema that has its text.
    pub documented: &'static Value,
    /// Whether it must be there.
    pub required: bool,
}

impl Node {
    /// Schema of the whole file.
    pub(crate) fn root() -> Self {
        Node { value: schema(), type_name: None }
    }

    /// Follows references and strips "or null".
    pub(crate) fn resolve(value: &'static Value) -> Self {
        let mut node = Node { value, type_name: None };
        // References are never deeper than a few; the bound only guards against a loop.
        for _ in 0..8 {
            if let Some(name) = node.value.get("$ref").and_then(Value::as_str) {
                let name = name.trim_start_matches("#/$defs/");
                let Some(target) = schema().get("$defs").and_then(|defs| defs.get(name)) else {
                    break;
                };
                node = Node { value: target, type_name: Some(name) };
            } else if let Some(inner) = only_alternative(node.value) {
                node = Node { value: inner, type_name: None };
            } else {
                break;
            }
        }
        node
    }

    /// The kind of quantity expected here.
    pub(crate) fn kind(self) -> Option<&'static KindInfo> {
        KindInfo::named(self.type_name?)
    }

    /// The schema of a key of a table with fixed keys.
    pub(crate) fn properties(self) -> impl Iterator<Item = (&'static str, &'static Value)> + Clone {
        self.value
            .get("properties")
            .and_then(Value::as_object)
            .into_iter()
            .flatten()
            .map(|(key, value)| (key.as_str(), value))
    }

    /// The schema of the values of a table with free keys.
    pub(crate) fn free_values(self) -> Option<&'static Value> {
        match self.value.get("additionalProperties") {
            None | Some(Value::Bool(false)) => None,
            Some(schema) => Some(schema),
        }
    }

    /// Calls `found` for each key that stands right below this node, with its path below `path`, and goes on into those of its
    /// alternatives that `enters` names.
    pub(crate) fn each_key(
        self,
        path: &str,
        enters: &impl Fn(Node) -> bool,
        found: &mut impl FnMut(FoundKey, &str),
    ) {
        let join = |key: &str| {
            if path.is_empty() { key.to_owned() } else { format!("{path}.{key}") }
        };
        let required: Vec<&str> = self.required().collect();
        for (key, value) in self.properties() {
            let key_found =
                FoundKey { value, documented: value, required: required.contains(&key) };
            found(key_found, &join(key));
        }
        let mut others: Vec<(&str, &'static Value, &'static Value)> = self.variants();
        if let Some(value) = self.free_values() {
            others.push(("*", value, Node::resolve(value).value));
        }
        for (key, value, documented) in others {
            let key_found = FoundKey { value, documented, required: false };
            found(key_found, &join(key));
        }
        for alternative in self.alternatives() {
            if enters(alternative) {
                alternative.each_key(path, enters, found);
            }
        }
    }

    /// Keys that must be there.
    pub(crate) fn required(self) -> impl Iterator<Item = &'static str> {
        self.value
            .get("required")
            .and_then(Value::as_array)
            .into_iter()
            .flatten()
            .filter_map(Value::as_str)
    }

    /// Variants that are tables of one key: (key, schema of its value, description).
    pub(crate) fn variants(self) -> Vec<(&'static str, &'static Value, &'static Value)> {
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
    pub(crate) fn words(self) -> Vec<(&'static str, &'static str)> {
        if let Some(words) = self.value.get("enum").and_then(Value::as_array) {
            return words.iter().filter_map(|word| Some((word.as_str()?, ""))).collect();
        }
        if let Some(word) = self.value.get("const").and_then(Value::as_str) {
            return vec![(word, description(self.value))];
        }
        let alternatives = self.value.get("oneOf").and_then(Value::as_array);
        alternatives
            .into_iter()
            .flatten()
            .flat_map(|alternative| Node { value: alternative, type_name: None }.words())
            .collect()
    }

    /// Alternatives of different types; empty if there is only one.
    pub(crate) fn alternatives(self) -> Vec<Node> {
        let alternatives = self.value.get("anyOf").and_then(Value::as_array);
        alternatives.into_iter().flatten().map(Node::resolve).collect()
    }

    /// The alternative in which a word leads on; itself if there are none.
    pub(crate) fn towards(self, word: &str) -> Node {
        let leads = |node: &Node| {
            let known = node.properties().any(|(key, _)| key == word)
                || node.variants().iter().any(|(key, _, _)| *key == word);
            known || (word.parse::<usize>().is_ok() && node.value.get("items").is_some())
        };
        self.alternatives().into_iter().find(leads).unwrap_or(self)
    }

    /// Schema of the entries of a list, also where a list is only one alternative.
    pub(crate) fn items(self) -> Option<&'static Value> {
        self.value.get("items").or_else(|| {
            let lists = self.alternatives();
            lists.into_iter().find_map(|node| node.value.get("items"))
        })
    }

    /// Kind of a single value where that is one alternative.
    pub(crate) fn single(self) -> Option<&'static KindInfo> {
        self.alternatives().into_iter().find_map(Node::kind)
    }

    /// Whether a JSON type is allowed.
    pub(crate) fn allows(self, json_type: &str) -> bool {
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
    value.get("description").and_then(Value::as_str).unwrap_or_default()
}
