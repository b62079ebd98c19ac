//! The text against the schema: unknown and missing keys, wrong types, wrong words, and every
//! quantity with its unit and range. Collects everything that is wrong, with its place.
//!
//! The parser's own errors stop at the first; here the user sees all of them at once. What the
//! schema cannot say (values that depend on each other, references between tables) is in [`super::rules`].

mod forms;

use serde_json::Value;
use toml::Spanned;
use toml::de::{DeString, DeTable, DeValue};

use super::diagnostic::{Diagnostic, closest, list, one_of, short, suggest};
use super::moments::{read_interval, read_period};
use super::path::resolve;
use super::quantity::{KindInfo, Raw, Span, When};
use super::rule::Checked;
use super::schema::{Node, description, example, takes};
use super::units;
use super::values::{assignment, check_quantity};
use super::vectors::{FormInfo, InSpace};

/// More remarks than this help nobody.
const MOST: usize = 50;
/// Unknown keys of one table for which the known ones are listed.
const LISTED: usize = 10;

/// Everything that is wrong with a parsed text; and what the rules of its tables find, for a text whose keys and values are
/// otherwise those of the language.
pub(super) fn validate(root: &Spanned<DeTable<'_>>) -> [Vec<Diagnostic>; 2] {
    let table = root.get_ref();
    let si = table.get("units").and_then(|units| units.get_ref().as_str()) == Some("SI");
    let space = forms::space(table);
    let mut walk = Walk { si, space, path: Vec::new(), found: Vec::new(), by_rules: Vec::new() };
    let place = 0..0;
    walk.object(table, &place, Node::root());
    // Changed scenes are read as a whole, each by itself.
    let by_rules = std::mem::take(&mut walk.by_rules);
    walk.changes(table);
    [walk.found, by_rules]
}

struct Walk {
    si: bool,
    /// The space of the scene, if it names one.
    space: Option<InSpace>,
    path: Vec<String>,
    found: Vec<Diagnostic>,
    by_rules: Vec<Diagnostic>,
}

impl Walk {
    /// Enough was found; looking on would only cost time.
    fn full(&self) -> bool {
        self.found.len() >= MOST
    }

    fn report(&mut self, diagnostic: Diagnostic) {
        if !self.full() {
            self.found.push(diagnostic);
        }
    }

    /// The innermost key with a name, for "write for example key = ...".
    fn key(&self) -> &str {
        self.path
            .iter()
            .rev()
            .map(String::as_str)
            .find(|word| !word.starts_with(|c: char| c.is_ascii_digit()))
            .unwrap_or("value")
    }

    fn here(&self) -> String {
        let words: Vec<String> = self.path.iter().map(|word| short(word)).collect();
        if words.is_empty() { "the scenario".to_owned() } else { words.join(".") }
    }

    /// Keys and values of `sweep`, `variants`, `distributions`, `bisect` and `when`.
    fn changes(&mut self, root: &DeTable<'_>) {
        let table = |name: &str| root.get(name).and_then(|value| value.get_ref().as_table());
        for (key, values) in table("sweep").into_iter().flatten() {
            let values = values.get_ref().as_array();
            if values.is_some_and(|values| values.is_empty()) {
                let message = format!("the sweep over `{}` has no values", short(key.get_ref()));
                self.report(Diagnostic::error("sweep.empty", message).at(key.span()));
            }
            self.change(root, key, values.into_iter().flatten());
        }
        for (_, variant) in table("variants").into_iter().flatten() {
            for (key, value) in variant.get_ref().as_table().into_iter().flatten() {
                self.change(root, key, std::iter::once(value));
            }
        }
        for (key, said) in table("distributions").into_iter().flatten() {
            let Some(said) = said.get_ref().as_table() else { continue };
            let of = |at: &str| said.get(at).map(Spanned::get_ref);
            let inner = |at: &str, key: &str| of(at).and_then(|of| of.get(key));
            let between = inner("beta", "between").map(Spanned::get_ref);
            let lists = [of("uniform"), of("triangular"), of("whole"), between];
            let values = lists.into_iter().flatten().filter_map(DeValue::as_array).flatten();
            let means = [inner("normal", "mean"), inner("lognormal", "mean")];
            self.change(root, key, values.chain(means.into_iter().flatten()));
        }
        if let Some(bisect) = table("bisect") {
            let ends = ["low", "high"].iter().filter_map(|end| bisect.get(*end));
            if let Some(key) = bisect.get("key")
                && let Some(text) = key.get_ref().as_str()
            {
                let key = Spanned::new(key.span(), text.into());
                self.change(root, &key, ends);
            }
        }
        let checks = root.get("checks").and_then(|checks| checks.get_ref().as_array());
        for check in checks.into_iter().flatten() {
            let when = check.get_ref().get("when").and_then(|when| when.get_ref().as_table());
            for (key, values) in when.into_iter().flatten() {
                let values = values.get_ref().as_array();
                self.change(root, key, values.into_iter().flatten());
            }
        }
    }

    fn change<'a, 'i: 'a>(
        &mut self,
        root: &DeTable<'_>,
        key: &Spanned<DeString<'_>>,
        values: impl Iterator<Item = &'a Spanned<DeValue<'i>>>,
    ) {
        let path = key.get_ref().as_ref();
        match resolve(root, path) {
            Ok(place) => {
                let outer = std::mem::replace(&mut self.path, vec![path.to_owned()]);
                for value in values {
                    self.node(value, place.node);
                }
                self.path = outer;
            }
            Err(error) => {
                let mut diagnostic = Diagnostic::error("key.path", error.message).at(key.span());
                diagnostic.help = error.help;
                self.report(diagnostic);
            }
        }
    }

    fn value(&mut self, value: &Spanned<DeValue<'_>>, schema: &'static Value) {
        self.node(value, Node::resolve(schema));
    }

    fn node(&mut self, value: &Spanned<DeValue<'_>>, node: Node) {
        if self.full() {
            return;
        }
        let span = value.span();
        if node.value.is_boolean() {
            return; // any value
        }
        if let Some(kind) = node.kind() {
            return self.quantity(value, kind);
        }
        match node.type_name {
            Some("Every") => return self.interval(value),
            Some("Moment") => return self.moment(value),
            Some("Period") => return self.period(value),
            _ => {}
        }
        if let Some((form, _)) = node.type_name.and_then(FormInfo::of_type) {
            return self.form(value, node, form);
        }
        if let Some(alternatives) = node.value.get("anyOf").and_then(Value::as_array) {
            let json_type = json_type(value.get_ref());
            let fitting = alternatives.iter().find(|one| {
                let node = Node::resolve(one); // by the outer type only
                node.allows(json_type) || (json_type == "object" && !node.variants().is_empty())
            });
            return match fitting {
                Some(one) => self.value(value, one),
                None => self.wrong_type(value, node),
            };
        }
        let words = node.words();
        if !words.is_empty() {
            let words: Vec<&str> = words.iter().map(|(word, _)| *word).collect();
            return self.word(value, &words, node);
        }
        let variants = node.variants();
        if !variants.is_empty() {
            return self.variant(value, node);
        }
        match value.get_ref() {
            DeValue::Table(table) if node.allows("object") => self.object(table, &span, node),
            DeValue::Array(items) if node.allows("array") => {
                self.count(items.len(), &span, node);
                if let Some(schema) = node.value.get("items") {
                    self.items(items, schema);
                }
            }
            DeValue::Integer(_) if node.allows("integer") => self.integer(value, node),
            other => {
                if !node.allows(json_type(other)) {
                    self.wrong_type(value, node);
                }
            }
        }
    }

    fn items(&mut self, items: &[Spanned<DeValue<'_>>], schema: &'static Value) {
        for (index, item) in items.iter().enumerate() {
            let name = item.get_ref().get("name").and_then(|n| n.get_ref().as_str());
            self.path.push(name.map_or_else(|| index.to_string(), str::to_owned));
            self.value(item, schema);
            self.path.pop();
        }
    }

    fn object(&mut self, table: &DeTable<'_>, span: &Span, node: Node) {
        let free = node.free_values();
        let mut mistyped: Vec<String> = Vec::new();
        let mut unknown = 0;
        for (key, value) in table {
            if self.full() {
                return;
            }
            let name = key.get_ref().as_ref();
            let fixed = node.properties().find(|(known, _)| *known == name);
            match fixed.map(|(_, schema)| schema).or(free) {
                Some(schema) if self.in_other_space(schema, key) => {}
                Some(schema) => {
                    self.path.push(name.to_owned());
                    self.value(value, schema);
                    self.path.pop();
                }
                None => {
                    let known = node.properties().map(|(known, _)| known);
                    unknown += 1;
                    // A long list of keys helps once, not fifty times.
                    let near = closest(name, known.clone());
                    let help = if unknown <= LISTED {
                        suggest(name, known)
                    } else {
                        near.as_ref().map(|key| format!("did you mean `{key}`?"))
                    };
                    mistyped.extend(near);
                    let message = format!("unknown key `{}` in {}", short(name), self.here());
                    let mut diagnostic = Diagnostic::error("key.unknown", message)
                        .at(key.span())
                        .label("not a key of this table");
                    diagnostic.help = help;
                    self.report(diagnostic);
                }
            }
        }
        if node.value.get("x-rules").is_some() && self.by_rules.len() < MOST {
            let (of, span) = (self.here(), span.clone());
            let checked = Checked { table, node, space: self.space, of, span };
            self.by_rules.extend(checked.rules());
        }
        for key in node.required().filter(|key| !table.contains_key(*key)) {
            // Said already: "did you mean ...".
            if !mistyped.iter().any(|one| one == key) {
                self.missing(key, span, node);
            }
        }
    }

    fn missing(&mut self, key: &str, span: &Span, node: Node) {
        let schema = node.properties().find(|(known, _)| *known == key);
        let target = schema.map(|(_, schema)| Node::resolve(schema));
        let meaning = schema.map(|(_, schema)| description(schema).replace('\n', " "));
        let help = match (target.and_then(Node::kind), meaning) {
            (Some(kind), _) => format!("write for example {}", assignment(key, kind.example)),
            (None, Some(meaning)) if !meaning.is_empty() => format!("{key}: {meaning}"),
            _ => format!("add `{key}`"),
        };
        let message = format!("the key `{key}` is missing in {}", self.here());
        self.report(Diagnostic::error("key.missing", message).at(span.clone()).help(help));
    }

    fn count(&mut self, count: usize, span: &Span, node: Node) {
        let bound = |key: &str| node.value.get(key).and_then(Value::as_u64);
        let low = bound("minItems").unwrap_or(0);
        let high = bound("maxItems").unwrap_or(u64::MAX);
        let count = count as u64;
        if count < low || count > high {
            let message = format!("`{}` is a list of {low}, this one has {count}", self.key());
            let help = format!("write {}", takes(node));
            self.report(Diagnostic::error("value.count", message).at(span.clone()).help(help));
        }
    }

    fn integer(&mut self, value: &Spanned<DeValue<'_>>, node: Node) {
        let DeValue::Integer(written) = value.get_ref() else {
            return;
        };
        let bound = |key: &str| node.value.get(key).and_then(Value::as_f64);
        let number = i64::from_str_radix(written.as_str(), written.radix()).ok();
        let low = bound("minimum").unwrap_or(i64::MIN as f64);
        let format_high = match node.value.get("format").and_then(Value::as_str) {
            Some("uint8") => f64::from(u8::MAX),
            Some("uint32") => f64::from(u32::MAX),
            _ => i64::MAX as f64,
        };
        let high = bound("maximum").unwrap_or(format_high);
        if number.is_none_or(|number| (number as f64) < low || number as f64 > high) {
            let message = format!("`{}` is out of range", self.key());
            let help = format!("a whole number from {low} to {high} is expected");
            self.report(Diagnostic::error("value.range", message).at(value.span()).help(help));
        }
    }

    fn word(&mut self, value: &Spanned<DeValue<'_>>, words: &[&'static str], node: Node) {
        let Some(word) = value.get_ref().as_str() else {
            return self.wrong_type(value, node);
        };
        if !words.contains(&word) {
            let message = format!("`{}` cannot be \"{}\"", self.key(), short(word));
            let mut diagnostic = Diagnostic::error("value.word", message)
                .at(value.span())
                .label(format!("{} is expected", one_of(words)));
            diagnostic.help =
                closest(word, words.iter().copied()).map(|word| format!("did you mean `{word}`?"));
            self.report(diagnostic);
        }
    }

    fn variant(&mut self, value: &Spanned<DeValue<'_>>, node: Node) {
        let variants = node.variants();
        let keys: Vec<&'static str> = variants.iter().map(|(key, _, _)| *key).collect();
        let DeValue::Table(table) = value.get_ref() else {
            return self.wrong_type(value, node);
        };
        let mut known = 0;
        for (key, inner) in table {
            if self.full() {
                return;
            }
            let name = key.get_ref().as_ref();
            if let Some((_, schema, _)) = variants.iter().find(|(known, _, _)| *known == name) {
                known += 1;
                if known == 2 {
                    let message = format!("{} takes only one of {}", self.here(), list(&keys));
                    self.report(
                        Diagnostic::error("key.one_of", message)
                            .at(key.span())
                            .label("one too many")
                            .help("keep one and remove the others"),
                    );
                }
                self.path.push(name.to_owned());
                self.value(inner, schema);
                self.path.pop();
            } else {
                known += 2; // said enough about this table
                let message = format!("unknown key `{}` in {}", short(name), self.here());
                let mut diagnostic = Diagnostic::error("key.unknown", message)
                    .at(key.span())
                    .label(format!("{} is expected", one_of(&keys)));
                diagnostic.help =
                    closest(name, keys.iter().copied()).map(|key| format!("did you mean `{key}`?"));
                self.report(diagnostic);
            }
        }
        if table.is_empty() {
            let message = format!("{} is empty", self.here());
            self.report(
                Diagnostic::error("key.one_of", message)
                    .at(value.span())
                    .help(format!("give {}", one_of(&keys))),
            );
        }
    }

    fn wrong_type(&mut self, value: &Spanned<DeValue<'_>>, node: Node) {
        let message = format!("`{}` cannot be {}", self.key(), type_text(value.get_ref()));
        let expected = takes(node);
        let mut diagnostic = Diagnostic::error("value.type", message)
            .at(value.span())
            .label(format!("{} is expected", expected.split(", for example").next().unwrap_or("")));
        diagnostic.help = if self.path.len() == 1 && forms::lacks_brackets(value.get_ref(), node) {
            Some(format!("write [[{}]]", self.key()))
        } else {
            example(node).map(|example| format!("write for example {} = {example}", self.key()))
        };
        self.report(diagnostic);
    }

    fn raw(value: &DeValue<'_>) -> Option<Raw> {
        match value {
            DeValue::String(text) => Some(Raw::Text(text.to_string())),
            DeValue::Integer(number) => {
                // Too many digits: reported as not finite.
                let number = i64::from_str_radix(number.as_str(), number.radix())
                    .map_or(f64::INFINITY, |number| number as f64);
                Some(Raw::Number(number))
            }
            DeValue::Float(number) => number.as_str().parse().ok().map(Raw::Number),
            DeValue::Boolean(_) | DeValue::Datetime(_) | DeValue::Array(_) | DeValue::Table(_) => {
                None
            }
        }
    }

    fn quantity(&mut self, value: &Spanned<DeValue<'_>>, kind: &KindInfo) {
        let kind = &kind.in_space(self.space);
        let Some(raw) = Self::raw(value.get_ref()) else {
            let message = format!("`{}` cannot be {}", self.key(), type_text(value.get_ref()));
            let help = format!("write for example {}", assignment(self.key(), kind.example));
            return self.report(
                Diagnostic::error("value.type", message)
                    .at(value.span())
                    .label(format!("{} is expected", kind.what))
                    .help(help),
            );
        };
        if let Some(diagnostic) = check_quantity(&raw, value.span(), kind, self.key(), self.si) {
            self.report(diagnostic);
        }
    }

    fn interval(&mut self, value: &Spanned<DeValue<'_>>) {
        let result = Self::raw(value.get_ref()).map(|raw| read_interval(&raw));
        self.text_with_time(value, result.map(Result::err));
    }

    fn moment(&mut self, value: &Spanned<DeValue<'_>>) {
        let result = Self::raw(value.get_ref()).map(|raw| When::read(&raw, self.si));
        self.text_with_time(value, result.map(Result::err));
    }

    fn period(&mut self, value: &Spanned<DeValue<'_>>) {
        let result = Self::raw(value.get_ref()).map(|raw| read_period(&raw, self.si));
        self.text_with_time(value, result.map(Result::err));
    }

    fn text_with_time(
        &mut self,
        value: &Spanned<DeValue<'_>>,
        error: Option<Option<units::UnitError>>,
    ) {
        let key = self.key();
        let diagnostic = match error {
            Some(None) => return,
            Some(Some(error)) => {
                let mut diagnostic =
                    Diagnostic::error("value.time", format!("`{key}`: {}", error.message));
                diagnostic.help = error.help;
                diagnostic
            }
            None => Diagnostic::error(
                "value.type",
                format!("`{key}` cannot be {}", type_text(value.get_ref())),
            )
            .help("write a text, for example \"1 ms\" or \"1 m\""),
        };
        self.report(diagnostic.at(value.span()));
    }
}

fn json_type(value: &DeValue<'_>) -> &'static str {
    match value {
        DeValue::String(_) => "string",
        DeValue::Datetime(_) => "date",
        DeValue::Integer(_) => "integer",
        DeValue::Float(_) => "number",
        DeValue::Boolean(_) => "boolean",
        DeValue::Array(_) => "array",
        DeValue::Table(_) => "object",
    }
}

fn type_text(value: &DeValue<'_>) -> &'static str {
    match value {
        DeValue::String(_) => "a text",
        DeValue::Integer(_) => "a number",
        DeValue::Float(_) => "a decimal number",
        DeValue::Boolean(_) => "true or false",
        DeValue::Datetime(_) => "a date",
        DeValue::Array(_) => "a list",
        DeValue::Table(_) => "a table",
    }
}
