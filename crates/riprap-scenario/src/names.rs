//! Names with their place in the file, and tables with free names as keys.

use std::borrow::Cow;
use std::fmt;
use std::marker::PhantomData;
use std::ops::Range;

use riprap_core::condition::Fault;
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::{Deserialize, Deserializer, Error as _, MapAccess, Visitor};

use super::diagnostic::{Diagnostic, short, suggest};
use super::quantity::Span;

/// A word that refers to something (material, block, group, field, file), with its place.
#[derive(Debug, Clone)]
pub struct Name {
    /// The word.
    pub text: String,
    /// Where it stands.
    pub span: Span,
}

impl Diagnostic {
    /// A name that is not one of `known`, with the nearest of them.
    pub fn unknown<'a>(
        what: &str,
        name: &Name,
        known: impl IntoIterator<Item = &'a str> + Clone,
    ) -> Self {
        let message = format!("there is no {what} `{}`", short(&name.text));
        let help = suggest(&name.text, known);
        Diagnostic { help, ..Self::error("name.unknown", message).at(name.span.clone()) }
    }
}

impl Diagnostic {
    /// A condition on blocks that cannot be read, at the word where it cannot.
    pub fn no_condition(text: &Name, fault: &Fault) -> Self {
        let usual = "write names with `and`, `or`, `not` and parentheses, for example \"roof and not (ore or key)\"";
        Self::error("group.where", fault.why.clone()).at(text.within(&fault.at)).help(usual)
    }
}

impl From<&Name> for Span {
    fn from(name: &Name) -> Span {
        name.span.clone()
    }
}

impl Name {
    /// The word.
    pub fn as_str(&self) -> &str {
        &self.text
    }

    /// Place of the character behind `bytes` of the word; all of it where quotes and escapes hide the place.
    pub fn place(&self, bytes: usize) -> Span {
        let rest = self.text.get(bytes..).unwrap_or_default();
        self.within(&(bytes..bytes + rest.chars().next().map_or(1, char::len_utf8)))
    }

    /// Place of some bytes of the word, at its end of the quote behind it; all of it where quotes and escapes hide the place.
    pub fn within(&self, bytes: &Range<usize>) -> Span {
        let plain = self.span.len() == self.text.len() + 2;
        if !plain || bytes.start > self.text.len() {
            return self.span.clone();
        }
        let begin = self.span.start + 1 + bytes.start;
        begin..begin + bytes.len().max(1)
    }
}

impl PartialEq for Name {
    fn eq(&self, other: &Self) -> bool {
        self.text == other.text
    }
}

impl fmt::Display for Name {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text)
    }
}

impl From<&str> for Name {
    fn from(text: &str) -> Self {
        Name { text: text.to_owned(), span: 0..0 }
    }
}

impl<'de> Deserialize<'de> for Name {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let text = toml::Spanned::<String>::deserialize(deserializer)?;
        let span = text.span();
        Ok(Name { text: text.into_inner(), span })
    }
}

impl JsonSchema for Name {
    fn inline_schema() -> bool {
        true
    }
    fn schema_name() -> Cow<'static, str> {
        Cow::Borrowed("Name")
    }
    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({ "type": "string" })
    }
}

/// One name or a list of names: `of = "block"` or `of = ["a", "b"]`.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Names(pub Vec<Name>);

impl<'de> Deserialize<'de> for Names {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct NamesVisitor;
        impl<'de> Visitor<'de> for NamesVisitor {
            type Value = Vec<(String, Span)>;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a name or a list of names")
            }
            fn visit_str<E>(self, value: &str) -> Result<Self::Value, E> {
                // A single name stands where the whole value does.
                Ok(vec![(value.to_owned(), 0..0)])
            }
            fn visit_seq<A: serde::de::SeqAccess<'de>>(
                self,
                mut seq: A,
            ) -> Result<Self::Value, A::Error> {
                let mut names = Vec::new();
                while let Some(name) = seq.next_element::<Name>()? {
                    names.push((name.text, name.span));
                }
                Ok(names)
            }
        }
        struct Inner(Vec<(String, Span)>);
        impl<'de> Deserialize<'de> for Inner {
            fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
                deserializer.deserialize_any(NamesVisitor).map(Inner)
            }
        }
        let whole = toml::Spanned::<Inner>::deserialize(deserializer)?;
        let span = whole.span();
        let place = |inner: Span| {
            if inner.is_empty() { span.clone() } else { inner }
        };
        let names = whole.into_inner().0;
        Ok(Names(
            names.into_iter().map(|(text, inner)| Name { text, span: place(inner) }).collect(),
        ))
    }
}

impl JsonSchema for Names {
    fn schema_name() -> Cow<'static, str> {
        Cow::Borrowed("Names")
    }
    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({
            "description": "A name or a list of names.",
            "anyOf": [{ "type": "string" }, { "type": "array", "items": { "type": "string" } }]
        })
    }
}

/// A TOML table with free keys, in file order; keys keep their place.
#[derive(Debug, Clone, PartialEq)]
pub struct Table<T>(pub Vec<(Name, T)>);

impl<T> Default for Table<T> {
    fn default() -> Self {
        Table(Vec::new())
    }
}

impl<T> Table<T> {
    /// The entry of that name.
    pub fn get(&self, name: &str) -> Option<&T> {
        self.0.iter().find(|(key, _)| key.text == name).map(|(_, value)| value)
    }
    /// Entries in file order.
    pub fn iter(&self) -> impl Iterator<Item = (&Name, &T)> {
        self.0.iter().map(|(name, value)| (name, value))
    }
    /// Keys in file order.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        self.0.iter().map(|(name, _)| name.text.as_str())
    }
    /// Number of entries.
    pub fn len(&self) -> usize {
        self.0.len()
    }
    /// Whether there is no entry.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }
}

impl<'de, T: Deserialize<'de>> Deserialize<'de> for Table<T> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct TableVisitor<T>(PhantomData<T>);
        impl<'de, T: Deserialize<'de>> Visitor<'de> for TableVisitor<T> {
            type Value = Table<T>;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a table")
            }
            fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Table<T>, A::Error> {
                let mut entries: Vec<(Name, T)> = Vec::new();
                while let Some(key) = map.next_key::<Name>()? {
                    if entries.iter().any(|(other, _)| other.text == key.text) {
                        return Err(A::Error::custom(format!("`{key}` stands twice")));
                    }
                    let value = map.next_value()?;
                    entries.push((key, value));
                }
                // The parser sorts keys; the file order is in their places.
                entries.sort_by_key(|(name, _)| name.span.start);
                Ok(Table(entries))
            }
        }
        deserializer.deserialize_map(TableVisitor(PhantomData))
    }
}

impl<T: JsonSchema> JsonSchema for Table<T> {
    fn inline_schema() -> bool {
        true
    }
    fn schema_name() -> Cow<'static, str> {
        Cow::Owned(format!("Table_{}", T::schema_name()))
    }
    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        json_schema!({ "type": "object", "additionalProperties": generator.subschema_for::<T>() })
    }
}
