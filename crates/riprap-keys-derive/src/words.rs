//! `#[derive(Words)]`.

use proc_macro2::TokenStream;
use quote::quote;
use syn::{Data, DeriveInput, Error, Fields, LitStr, Result, Variant};

use crate::docs::{meaning, snake};

pub fn derive(input: &DeriveInput) -> Result<TokenStream> {
    let Data::Enum(data) = &input.data else {
        return Err(Error::new_spanned(&input.ident, "words are variants of an enum"));
    };
    if !input.generics.params.is_empty() {
        return Err(Error::new_spanned(&input.generics, "an enum of words is not generic"));
    }
    let name = &input.ident;
    let about = documented(&input.ident, meaning(&input.attrs))?;
    let mut variants = Vec::new();
    let mut words = Vec::new();
    let mut meanings = Vec::new();
    for variant in &data.variants {
        if !matches!(variant.fields, Fields::Unit) {
            return Err(Error::new_spanned(variant, "a word has no fields"));
        }
        variants.push(&variant.ident);
        words.push(word(variant)?);
        meanings.push(documented(&variant.ident, meaning(&variant.attrs))?);
    }
    Ok(quote! {
        impl ::riprap_keys::Words for #name {
            const NAME: &'static str = stringify!(#name);
            const MEANING: &'static str = #about;
            const ALL: &'static [Self] = &[#(Self::#variants),*];
            const NAMES: &'static [&'static str] = &[#(#words),*];
            const WORDS: &'static [(&'static str, &'static str)] = &[#((#words, #meanings)),*];
        }
        impl ::riprap_keys::derived::serde::Serialize for #name {
            fn serialize<S: ::riprap_keys::derived::serde::Serializer>(
                &self,
                serializer: S,
            ) -> ::std::result::Result<S::Ok, S::Error> {
                ::riprap_keys::derived::serialize(*self, serializer)
            }
        }
        impl<'de> ::riprap_keys::derived::serde::Deserialize<'de> for #name {
            fn deserialize<D: ::riprap_keys::derived::serde::Deserializer<'de>>(
                deserializer: D,
            ) -> ::std::result::Result<Self, D::Error> {
                ::riprap_keys::derived::deserialize(deserializer)
            }
        }
        ::riprap_keys::word_schema!(#name);
    })
}

fn word(variant: &Variant) -> Result<String> {
    for attribute in &variant.attrs {
        if attribute.path().is_ident("word") {
            return Ok(attribute.parse_args::<LitStr>()?.value());
        }
    }
    Ok(snake(&variant.ident.to_string()))
}

fn documented(of: &syn::Ident, text: String) -> Result<String> {
    if text.is_empty() {
        let message = "the documentation is what users read: say what this means";
        return Err(Error::new_spanned(of, message));
    }
    Ok(text)
}
