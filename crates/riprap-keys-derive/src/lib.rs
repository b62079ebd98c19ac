//! Derive macros of `riprap-keys`.

mod docs;
mod keys;
mod rules;
mod words;

use proc_macro::TokenStream;
use syn::{DeriveInput, parse_macro_input};

/// Makes the variants of an enum words of the scenario language.
///
/// The word of a variant is its name in snake case, or that of `#[word("...")]`; its meaning is the
/// first paragraph of its documentation. Implements `riprap_keys::Words`, `serde::Serialize`,
/// `serde::Deserialize` and, with the feature `schema` of `riprap-keys`, `schemars::JsonSchema`.
#[proc_macro_derive(Words, attributes(word))]
pub fn words(input: TokenStream) -> TokenStream {
    let input = parse_macro_input!(input as DeriveInput);
    words::derive(&input).unwrap_or_else(syn::Error::into_compile_error).into()
}

/// Makes the fields of a struct keys of a table of the scenario language.
///
/// For structs of `riprap-scenario`, beside `Deserialize` with `deny_unknown_fields`. The word of a key is the name of its
/// field (or that of `#[serde(rename = "...")]`), its meaning the documentation. What else there is to say stands in
/// `#[key(...)]`:
///
/// - `default = "0 Pa"` for a quantity, `default = 3` for a number or a list, `default` for an enum of words (its default
///   variant), `planar = "0.2", spatial = "0.1"` for a quantity with a default in each space;
/// - `space = "planar"`: the only space that has the key, `instead = "..."`: what to do in the other one;
/// - `min = 3`, `max = 1000`: the range of a whole number;
/// - `told`: it is written down as it stands, for values with components;
/// - `changes`: phases may change it;
/// - `needs("plate")`, `excludes("csv")`, `only_with("kind = static")` (else it has no effect), `required("!csv")`: rules, read
///   by the validation and by the documentation of the key. A condition joins keys, `!key` and `key = word, word` by
///   `&` and `|`; `space = "..."` limits the rule to one space, `help = "..."` is the remedy of its message.
///
/// `#[keys(one_of("a", "b"))]`, `at_most_one`, `any_of` and the rules above with `when = "..."` stand at the table.
///
/// The sentence about the default is added to the documentation. Implements `schemars::JsonSchema` and, for
/// `read::Read` of the table, a method for each key that gives its SI value, default included, and writes down where it
/// came from. `#[keys(change = Name, path = "interfaces.*")]` makes the struct `Name` of the keys that phases may change.
#[proc_macro_derive(Keys, attributes(key, keys, schemars))]
pub fn keys(input: TokenStream) -> TokenStream {
    let input = parse_macro_input!(input as DeriveInput);
    keys::derive(&input).unwrap_or_else(syn::Error::into_compile_error).into()
}
