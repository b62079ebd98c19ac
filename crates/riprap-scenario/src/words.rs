//! Values that are a word or a table: `coupling = "coupled"` or `coupling = { scaled = 0.5 }`.

use std::borrow::Cow;
use std::fmt;
use std::marker::PhantomData;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::value::MapAccessDeserializer;
use serde::de::{Deserialize, Deserializer, Error as _, MapAccess, Visitor};

use super::quantity::{Name, Span};

/// What a word may be.
pub trait Word: Sized + fmt::Debug + Clone + PartialEq + 'static {
    /// Name in the names of schema types.
    const NAME: &'static str;
    /// The allowed words with their meaning; empty allows any.
    const WORDS: &'static [(&'static str, &'static str)];
    /// The word at its place; `None` if it is none of the allowed ones.
    fn read(text: &str, span: &Span) -> Option<Self>;
}

impl Word for Name {
    const NAME: &'static str = "Name";
    const WORDS: &'static [(&'static str, &'static str)] = &[];
    fn read(text: &str, span: &Span) -> Option<Self> {
        Some(Name { text: text.to_owned(), span: span.clone() })
    }
}

impl<W: riprap_keys::Words> Word for W {
    const NAME: &'static str = <W as riprap_keys::Words>::NAME;
    const WORDS: &'static [(&'static str, &'static str)] = <W as riprap_keys::Words>::WORDS;
    fn read(text: &str, _: &Span) -> Option<Self> {
        W::named(text)
    }
}

/// A word or a table.
#[derive(Debug, Clone, PartialEq)]
pub enum WordOr<W, T> {
    /// A word.
    Word(W, Span),
    /// A table.
    Table(T, Span),
}

impl<W, T> WordOr<W, T> {
    /// Where it stands.
    pub fn span(&self) -> &Span {
        match self {
            WordOr::Word(_, span) | WordOr::Table(_, span) => span,
        }
    }
}

enum Read<T> {
    Word(String),
    Table(T),
}

impl<'de, T: Deserialize<'de>> Deserialize<'de> for Read<T> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct ReadVisitor<T>(PhantomData<T>);
        impl<'de, T: Deserialize<'de>> Visitor<'de> for ReadVisitor<T> {
            type Value = Read<T>;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a word or a table")
            }
            fn visit_str<E>(self, value: &str) -> Result<Self::Value, E> {
                Ok(Read::Word(value.to_owned()))
            }
            fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<Self::Value, A::Error> {
                T::deserialize(MapAccessDeserializer::new(map)).map(Read::Table)
            }
        }
        deserializer.deserialize_any(ReadVisitor(PhantomData))
    }
}

impl<'de, W: Word, T: Deserialize<'de>> Deserialize<'de> for WordOr<W, T> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let whole = toml::Spanned::<Read<T>>::deserialize(deserializer)?;
        let span = whole.span();
        match whole.into_inner() {
            Read::Table(table) => Ok(WordOr::Table(table, span)),
            Read::Word(text) => match W::read(&text, &span) {
                Some(word) => Ok(WordOr::Word(word, span)),
                None => Err(D::Error::custom(format!("`{text}` is not possible here"))),
            },
        }
    }
}

impl<W: Word, T: JsonSchema> JsonSchema for WordOr<W, T> {
    fn schema_name() -> Cow<'static, str> {
        Cow::Owned(format!("{}Or{}", W::NAME, T::schema_name()))
    }
    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        json_schema!({ "anyOf": [word_schema::<W>(), generator.subschema_for::<T>()] })
    }
}

fn word_schema<W: Word>() -> Schema {
    if W::WORDS.is_empty() {
        return json_schema!({ "type": "string" });
    }
    let words: Vec<serde_json::Value> = W::WORDS
        .iter()
        .map(|(word, meaning)| {
            serde_json::json!({ "type": "string", "const": word, "description": meaning })
        })
        .collect();
    json_schema!({ "type": "string", "oneOf": words })
}

/// A word alone, for enums declared with `words`.
#[derive(Debug, Clone, PartialEq)]
pub struct OneWord<W>(pub W, pub Span);

impl<'de, W: Word> Deserialize<'de> for OneWord<W> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let text = toml::Spanned::<String>::deserialize(deserializer)?;
        let span = text.span();
        match W::read(text.get_ref(), &span) {
            Some(word) => Ok(OneWord(word, span)),
            None => Err(D::Error::custom(format!("`{}` is not possible here", text.get_ref()))),
        }
    }
}

impl<W: Word> JsonSchema for OneWord<W> {
    fn schema_name() -> Cow<'static, str> {
        Cow::Borrowed(W::NAME)
    }
    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        word_schema::<W>()
    }
}
