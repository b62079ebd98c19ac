//! Enums whose variants are words.

use std::fmt;
use std::marker::PhantomData;

use serde::de::{self, DeserializeSeed, Deserializer, EnumAccess, VariantAccess, Visitor};
use serde::ser::Serializer;

/// An enum whose variants are words of the scenario language; see the derive macro of this name.
///
/// The derive macro also makes the enum readable and writable by serde: as its word where a format
/// has words, as the number of the variant where it has not.
pub trait Words: Copy + Eq + fmt::Debug + 'static {
    /// Name of the type, for schemas.
    const NAME: &'static str;
    /// What the choice is about, one line.
    const MEANING: &'static str;
    /// All variants, in the order of the enum.
    const ALL: &'static [Self];
    /// The words, in the same order.
    const NAMES: &'static [&'static str];
    /// The words with their meaning, in the same order.
    const WORDS: &'static [(&'static str, &'static str)];

    /// The word of this variant.
    #[must_use]
    fn word(self) -> &'static str {
        let number = Self::ALL.iter().position(|one| *one == self);
        number.map_or("", |number| Self::NAMES[number])
    }

    /// The variant of a word.
    #[must_use]
    fn named(word: &str) -> Option<Self> {
        let number = Self::NAMES.iter().position(|one| *one == word)?;
        Some(Self::ALL[number])
    }
}

/// Writes a word.
///
/// # Errors
/// Those of the format.
pub fn serialize<W: Words, S: Serializer>(word: W, serializer: S) -> Result<S::Ok, S::Error> {
    let number = W::ALL.iter().position(|one| *one == word).unwrap_or(0);
    serializer.serialize_unit_variant(W::NAME, number as u32, W::NAMES[number])
}

/// Reads a word.
///
/// # Errors
/// Those of the format; a word that is none of the allowed ones.
pub fn deserialize<'de, W: Words, D: Deserializer<'de>>(deserializer: D) -> Result<W, D::Error> {
    deserializer.deserialize_enum(W::NAME, W::NAMES, OneOf::<W>(PhantomData))
}

struct OneOf<W>(PhantomData<W>);

impl<'de, W: Words> Visitor<'de> for OneOf<W> {
    type Value = W;
    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "one of {}", W::NAMES.join(", "))
    }
    fn visit_enum<A: EnumAccess<'de>>(self, data: A) -> Result<W, A::Error> {
        let (word, rest) = data.variant_seed(Variant::<W>(PhantomData))?;
        rest.unit_variant()?;
        Ok(word)
    }
}

struct Variant<W>(PhantomData<W>);

impl<'de, W: Words> DeserializeSeed<'de> for Variant<W> {
    type Value = W;
    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<W, D::Error> {
        deserializer.deserialize_identifier(self)
    }
}

impl<W: Words> Visitor<'_> for Variant<W> {
    type Value = W;
    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "one of {}", W::NAMES.join(", "))
    }
    fn visit_u64<E: de::Error>(self, number: u64) -> Result<W, E> {
        let variant = usize::try_from(number).ok().and_then(|k| W::ALL.get(k));
        variant.copied().ok_or_else(|| {
            E::invalid_value(de::Unexpected::Unsigned(number), &"the number of a variant")
        })
    }
    fn visit_str<E: de::Error>(self, word: &str) -> Result<W, E> {
        W::named(word).ok_or_else(|| E::unknown_variant(word, W::NAMES))
    }
}

/// JSON schema of an enum of words.
#[cfg(feature = "schema")]
#[must_use]
pub fn schema<W: Words>() -> schemars::Schema {
    let words: Vec<serde_json::Value> = W::WORDS
        .iter()
        .map(|(word, meaning)| {
            serde_json::json!({ "type": "string", "const": word, "description": meaning })
        })
        .collect();
    schemars::json_schema!({ "description": W::MEANING, "oneOf": words })
}

/// Gives a type its JSON schema, where there are schemas.
#[cfg(feature = "schema")]
#[doc(hidden)]
#[macro_export]
macro_rules! word_schema {
    ($name:ident) => {
        impl $crate::derived::schemars::JsonSchema for $name {
            fn schema_name() -> ::std::borrow::Cow<'static, str> {
                ::std::borrow::Cow::Borrowed(stringify!($name))
            }
            fn schema_id() -> ::std::borrow::Cow<'static, str> {
                ::std::borrow::Cow::Borrowed(concat!(module_path!(), "::", stringify!($name)))
            }
            fn json_schema(
                _: &mut $crate::derived::schemars::SchemaGenerator,
            ) -> $crate::derived::schemars::Schema {
                $crate::derived::schema::<$name>()
            }
        }
    };
}

/// There are no schemas without the feature `schema`.
#[cfg(not(feature = "schema"))]
#[doc(hidden)]
#[macro_export]
macro_rules! word_schema {
    ($name:ident) => {};
}
