//! Derive macros of `riprap-keys`.

mod docs;
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
    words::derive(&input)
        .unwrap_or_else(syn::Error::into_compile_error)
        .into()
}
