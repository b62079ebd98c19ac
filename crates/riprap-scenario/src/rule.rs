//! Rules about keys of one table, as `#[derive(Keys)]` takes them from the attributes of keys: which go together, which
//! do not, which need others, and which have no effect.
//!
//! They stand in the schema (`x-rules`), from where validation reads them, and as sentences behind the meaning of the key or
//! table, from where `riprap explain`, the schema and the reference page have them. A key counts as given unless it is `false`
//! or an empty list. Rules about values, other tables or more than a condition can say are in [`crate::rules`].

use serde_json::{Map, Value, json};
use toml::de::{DeTable, DeValue};

use crate::diagnostic::{Diagnostic, list};
use crate::quantity::Span;
use crate::schema::{Node, example, only_space};
use crate::vectors::InSpace;

/// A rule as it is declared.
pub(crate) struct Rule {
    /// Word of the attribute.
    pub kind: &'static str,
    pub keys: Vec<&'static str>,
    /// Condition; empty for none.
    pub when: &'static str,
    /// Remedy; empty for that of the kind.
    pub help: &'static str,
    /// The only space in which it holds; empty for both.
    pub space: &'static str,
}

/// A warning about keys without effect.
#[must_use]
pub fn no_effect(of: &str, keys: &[&str], span: Span, help: &str) -> Diagnostic {
    let verb = if keys.len() == 1 { "has" } else { "have" };
    let message = format!("{} in {of} {verb} no effect", list(keys));
    Diagnostic::warning("key.unused", message).at(span).help(help)
}

impl Rule {
    pub(crate) fn to_json(&self) -> Value {
        json!({ "kind": self.kind, "keys": self.keys, "when": self.when, "help": self.help, "space": self.space })
    }

    /// Adds the rule to the description of its key, or of the table if it has several.
    pub(crate) fn describe(&self, table: &mut Map<String, Value>, keys: &mut Map<String, Value>) {
        let key = match self.keys[..] {
            [one] => keys.get_mut(one).and_then(Value::as_object_mut),
            _ => None,
        };
        let object = key.unwrap_or(table);
        // Long lists and conditions are in the texts of keys themselves; a changed form refers to its table.
        let most = match self.kind {
            "one_of" => usize::MAX,
            "at_most_one" | "any_of" => 6,
            _ => 2,
        };
        let long = self.keys.len() > most || self.when.matches('|').count() > 2;
        if long || object.contains_key("x-change-of") {
            return;
        }
        if let Some(Value::String(text)) = object.get_mut("description") {
            *text = format!("{text} {}", self.sentence());
        }
    }

    fn sentence(&self) -> String {
        let all = list(&self.keys.iter().map(|key| bare(key)).collect::<Vec<_>>());
        let when = described(self.when);
        let bare_when = when.strip_prefix("with ").unwrap_or(&when);
        let text = match (self.kind, self.when) {
            ("one_of", "") => format!("One of {all}"),
            ("one_of", _) => format!("One of {all}, needed {when}"),
            ("at_most_one", _) => format!("One at most: {all}"),
            ("any_of", _) => format!("At least one of {all} {when}").trim_end().to_owned(),
            ("needs", _) => format!("Needs {bare_when}"),
            ("excludes", _) => format!("Not {when}"),
            ("only_with", _) => format!("Only {when}"),
            _ => format!("Required {when}").trim_end().to_owned(),
        };
        let in_space = if self.space.is_empty() {
            String::new()
        } else {
            format!(" in `[space.{}]`", self.space)
        };
        let of_keys = self.keys.len() > 1 && !self.kind.contains("one") && self.kind != "any_of";
        let of_keys = if of_keys { format!(": {all}") } else { String::new() };
        format!("{text}{in_space}{of_keys}.")
    }
}

/// A key without the space in which alone it belongs to a group.
fn bare(key: &str) -> &str {
    key.split('@').next().unwrap_or(key)
}

/// One term of a condition.
struct Term<'a> {
    wanted: bool,
    key: &'a str,
    words: Vec<&'a str>,
}

/// The alternatives of a condition, each a list of terms that hold together.
fn alternatives(condition: &str) -> impl Iterator<Item = Vec<Term<'_>>> {
    condition.split('|').map(|terms| {
        let terms = terms.split('&').map(str::trim);
        terms
            .map(|term| {
                let (key, words) = term.split_once('=').unwrap_or((term, ""));
                let words = words.split(',').map(str::trim).filter(|word| !word.is_empty());
                let (key, wanted) = (key.trim().trim_start_matches('!'), !term.starts_with('!'));
                Term { wanted, key, words: words.collect() }
            })
            .collect()
    })
}

/// A condition in words: "with `a` or without `b`".
fn described(condition: &str) -> String {
    let mut text = String::new();
    let mut before = None;
    for terms in alternatives(condition).filter(|_| !condition.is_empty()) {
        for (place, term) in terms.iter().enumerate() {
            if before.is_some() {
                text.push_str(if place == 0 { " or " } else { " and " });
            }
            if before != Some(term.wanted) {
                text.push_str(if term.wanted { "with " } else { "without " });
            }
            text.push_str(&term.said());
            before = Some(term.wanted);
        }
    }
    text
}

impl Term<'_> {
    fn said(&self) -> String {
        let words: Vec<String> = self.words.iter().map(|word| format!("\"{word}\"")).collect();
        if words.is_empty() {
            format!("`{}`", self.key)
        } else {
            format!("{} = {}", self.key, words.join(" or "))
        }
    }
}

/// A table of the file that is checked.
pub(crate) struct Checked<'a, 'i> {
    pub table: &'a DeTable<'i>,
    pub node: Node,
    pub space: Option<InSpace>,
    /// Its path, for messages.
    pub of: String,
    pub span: Span,
}

impl Checked<'_, '_> {
    /// What the rules of the table find.
    pub(crate) fn rules(&self) -> Vec<Diagnostic> {
        let rules = self.node.value.get("x-rules").and_then(Value::as_array);
        rules.into_iter().flatten().filter_map(|rule| self.rule(rule)).collect()
    }

    fn rule(&self, rule: &'static Value) -> Option<Diagnostic> {
        let text = |name: &str| rule.get(name).and_then(Value::as_str).unwrap_or_default();
        let keys = rule.get("keys").and_then(Value::as_array)?.iter().filter_map(Value::as_str);
        let (when, help) = (text("when"), text("help"));
        let (kind, space) = (text("kind"), text("space"));
        if !space.is_empty() && self.space.is_none_or(|here| here.word() != space) {
            return None;
        }
        let or = |other: String| if help.is_empty() { other } else { help.to_owned() };
        let error = |code, message, place: Span, help: String| {
            Some(Diagnostic::error(code, message).at(place).help(or(help)))
        };
        let possible: Vec<&str> = keys.clone().filter(|key| self.of_space(key)).map(bare).collect();
        let given: Vec<&str> = keys.map(bare).filter(|key| self.has(key)).collect();
        let holds = when.is_empty() || self.condition(when).is_some();
        let of = &self.of;
        match kind {
            "one_of" | "at_most_one" | "any_of" => {
                // A key of the other space has been refused.
                if given.iter().any(|key| !possible.contains(key)) || possible.is_empty() {
                    return None;
                }
                let lacks = given.is_empty() && kind != "at_most_one" && holds;
                let (message, place, remedy) = if lacks {
                    self.lacks(&possible, kind)
                } else {
                    let second = given.get(1).filter(|_| kind != "any_of")?;
                    let message = format!("{of} has {}: only one is possible", list(&given));
                    let remedy = "keep one and remove the others".to_owned();
                    (message, self.place_of(second), remedy)
                };
                error("key.one_of", message, place, remedy)
            }
            "needs" if !holds => {
                let (key, needed) = (*given.first()?, described(when));
                let needed = needed.strip_prefix("with ").unwrap_or(&needed);
                let message = format!("`{key}` in {of} needs {needed}");
                error("key.missing", message, self.place_of(key), self.remedy(when))
            }
            "excludes" => {
                let key = *given.first()?;
                let with = described(self.condition(when)?);
                let message = format!("{} in {of} cannot be used {with}", list(&given));
                error("key.forbidden", message, self.place_of(key), "keep one of them".to_owned())
            }
            "only_with" if !holds => {
                let key = *given.first()?;
                let help = or(format!("it applies only {}", described(when)));
                Some(no_effect(of, &given, self.place_of(key), &help))
            }
            "required" if holds => {
                let lacking = possible.into_iter().filter(|key| !given.contains(key));
                let lacking: Vec<&str> = lacking.collect();
                let first = *lacking.first()?;
                let message = match lacking[..] {
                    [key] => format!("the key `{key}` is missing in {of}"),
                    _ => format!("the keys {} are missing in {of}", list(&lacking)),
                };
                error("key.missing", message, self.place(), self.remedy(first))
            }
            _ => None,
        }
    }

    /// Message, place and remedy where none of several keys is given.
    fn lacks(&self, possible: &[&str], kind: &str) -> (String, Span, String) {
        let (of, choice) = (&self.of, choice(possible, kind));
        // An empty list gives nothing, but it was meant.
        match possible.iter().find(|key| self.value(key).is_some()) {
            Some(empty) => (
                format!("`{empty}` in {of} is empty"),
                self.place_of(empty),
                format!("give it entries, or {choice}"),
            ),
            None => (format!("{of} needs {choice}"), self.place(), format!("give {choice}")),
        }
    }

    /// "write for example key = value", for the first key of a condition.
    fn remedy(&self, condition: &str) -> String {
        let term = alternatives(condition).flatten().find(|term| term.wanted);
        let Some(term) = term else { return "leave it out".to_owned() };
        if !term.words.is_empty() {
            return format!("give {}", term.said());
        }
        let schema = self.node.properties().find(|(known, _)| *known == term.key);
        let value = schema.and_then(|(_, schema)| example(Node::resolve(schema)));
        value.map_or_else(
            || format!("give {}", term.said()),
            |value| format!("write for example {} = {value}", term.key),
        )
    }

    /// The first alternative that holds.
    fn condition<'c>(&self, condition: &'c str) -> Option<&'c str> {
        let holds = |term: Term<'_>| self.term(&term) == term.wanted;
        condition.split('|').find(|one| alternatives(one).flatten().all(holds))
    }

    fn term(&self, term: &Term<'_>) -> bool {
        let value = self.value(term.key);
        let word = value.and_then(|value| value.as_str());
        value.is_some_and(is_given)
            && (term.words.is_empty() || word.is_some_and(|word| term.words.contains(&word)))
    }

    fn has(&self, key: &str) -> bool {
        self.value(key).is_some_and(is_given)
    }

    fn value(&self, path: &str) -> Option<&DeValue<'_>> {
        let mut words = path.split('.');
        let mut value = self.table.get(words.next()?)?.get_ref();
        for word in words {
            value = value.as_table()?.get(word)?.get_ref();
        }
        Some(value)
    }

    /// Whether the space of the scene has a key of a group.
    fn of_space(&self, key: &str) -> bool {
        let Some(here) = self.space else { return true };
        let (key, only) = key.split_once('@').unwrap_or((key, here.word()));
        let schema = self.node.properties().find(|(known, _)| *known == key);
        let own = schema.and_then(|(_, schema)| only_space(schema));
        only == here.word() && own.is_none_or(|own| own == here)
    }

    fn place_of(&self, key: &str) -> Span {
        self.table.get_key_value(key).map_or_else(|| self.place(), |(key, _)| key.span())
    }

    /// The name of the table where it has one.
    fn place(&self) -> Span {
        self.table.get("name").map_or_else(|| self.span.clone(), toml::Spanned::span)
    }
}

fn choice(keys: &[&str], kind: &str) -> String {
    match (keys.len(), kind) {
        (1, _) => list(keys),
        (_, "any_of") => format!("at least one of {}", list(keys)),
        _ => format!("one of {}", list(keys)),
    }
}

fn is_given(value: &DeValue<'_>) -> bool {
    match value {
        DeValue::Boolean(given) => *given,
        DeValue::Array(items) => !items.is_empty(),
        DeValue::String(_)
        | DeValue::Integer(_)
        | DeValue::Float(_)
        | DeValue::Datetime(_)
        | DeValue::Table(_) => true,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::schema::schema;

    /// A rule with a slip of the pen would never hold.
    #[test]
    fn rules_name_keys_and_words_of_their_table() {
        let mut count = 0;
        for (name, definition) in schema()["$defs"].as_object().unwrap() {
            let node = Node { value: definition, type_name: None };
            for rule in definition["x-rules"].as_array().into_iter().flatten() {
                count += 1;
                let keys =
                    rule["keys"].as_array().unwrap().iter().map(|k| bare(k.as_str().unwrap()));
                let keys: Vec<&str> = keys.collect();
                assert!(!keys.is_empty(), "{name}: {rule}");
                let when = rule["when"].as_str().unwrap();
                let terms: Vec<Term<'_>> = if when.is_empty() {
                    Vec::new()
                } else {
                    alternatives(when).flatten().collect()
                };
                for key in keys.into_iter().chain(terms.iter().map(|term| term.key)) {
                    let mut node = node;
                    for word in key.split('.') {
                        let variants = node.variants();
                        let variant = variants.iter().find(|(known, _, _)| *known == word);
                        let schema = node.properties().find(|(known, _)| *known == word);
                        let schema = schema.map(|(_, schema)| schema);
                        let schema = schema.or(variant.map(|(_, schema, _)| *schema));
                        let schema =
                            schema.unwrap_or_else(|| panic!("{name} has no {key}: {rule}"));
                        node = Node::resolve(schema);
                    }
                    let term = terms.iter().find(|term| term.key == key);
                    for word in term.iter().flat_map(|term| &term.words) {
                        let known = node.words().iter().any(|(known, _)| known == word);
                        assert!(known, "{name}: {key} cannot be {word}");
                    }
                }
            }
        }
        assert!(count > 60, "{count} rules");
    }
}
