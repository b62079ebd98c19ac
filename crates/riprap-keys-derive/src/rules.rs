//! Rules about keys of one table: `#[key(needs("plate"))]` at a key, `#[keys(one_of("a", "b"))]` at the table.

use proc_macro2::TokenStream;
use quote::{format_ident, quote};
use syn::meta::ParseNestedMeta;
use syn::parse::{Parse, ParseStream};
use syn::{Ident, LitStr, Result, Token, parenthesized};

/// The words of rules; `riprap_scenario::rule::Kind` has a variant for each.
const KINDS: [&str; 7] =
    ["one_of", "at_most_one", "any_of", "needs", "excludes", "only_with", "required"];

/// One rule.
#[derive(Clone)]
pub struct Rule {
    kind: &'static str,
    keys: Vec<String>,
    when: String,
    help: String,
    /// The only space in which it holds; empty for both.
    space: String,
    /// Stands for all keys with this reader.
    reader: Option<String>,
}

/// `"a", "b", when = "...", help = "..."`
#[derive(Default)]
struct Arguments {
    texts: Vec<String>,
    named: Vec<(Ident, String)>,
}

impl Parse for Arguments {
    fn parse(input: ParseStream<'_>) -> Result<Self> {
        let mut all = Self::default();
        while !input.is_empty() {
            if input.peek(LitStr) {
                all.texts.push(input.parse::<LitStr>()?.value());
            } else {
                let name = input.parse::<Ident>()?;
                input.parse::<Token![=]>()?;
                all.named.push((name, input.parse::<LitStr>()?.value()));
            }
            if !input.is_empty() {
                input.parse::<Token![,]>()?;
            }
        }
        Ok(all)
    }
}

impl Rule {
    /// The rule that an attribute gives, if its word is that of one; texts are conditions at a key, keys at a table.
    pub fn parse(meta: &ParseNestedMeta<'_>, key: Option<&str>) -> Result<Option<Self>> {
        let Some(kind) = KINDS.into_iter().find(|kind| meta.path.is_ident(kind)) else {
            return Ok(None);
        };
        let content;
        parenthesized!(content in meta.input);
        let all = content.parse::<Arguments>()?;
        let (keys, when) = match key {
            Some(key) => (vec![key.to_owned()], all.texts.join(" | ")),
            None => (all.texts, String::new()),
        };
        let mut rule =
            Rule { kind, keys, when, help: String::new(), space: String::new(), reader: None };
        for (name, text) in all.named {
            match name.to_string().as_str() {
                "when" => rule.when = text,
                "help" => rule.help = text,
                "space" => rule.space = text,
                "reader" => rule.reader = Some(text),
                _ => {
                    return Err(syn::Error::new(
                        name.span(),
                        "`when`, `help`, `space` or `reader`",
                    ));
                }
            }
        }
        Ok(Some(rule))
    }

    /// Puts in the keys of the reader.
    pub fn with_readers<'k>(
        mut self,
        readers: impl Iterator<Item = (&'k str, &'k [String])>,
    ) -> Self {
        if let Some(reader) = &self.reader {
            let read = readers.filter(|(_, readers)| readers.contains(reader));
            self.keys.extend(read.map(|(key, _)| key.to_owned()));
        }
        self
    }

    pub fn tokens(&self) -> TokenStream {
        let Rule { kind, keys, when, help, space, .. } = self;
        quote! {
            crate::rule::Rule { kind: #kind, keys: vec![#(#keys),*], when: #when, help: #help, space: #space }
        }
    }

    /// What of the rule holds where a phase changes some of the keys: absent ones keep a value of their own.
    pub fn of_change(&self, changes: &impl Fn(&str) -> bool) -> Option<TokenStream> {
        let words = self.when.split(['|', '&']).map(|term| term.trim().trim_start_matches('!'));
        let mut words = words.map(|term| term.split([' ', '.', '=']).next().unwrap_or_default());
        let keys: Vec<&String> = self.keys.iter().filter(|key| changes(key)).collect();
        let (kind, least, conditions) = match self.kind {
            "one_of" | "at_most_one" => ("at_most_one", 2, true),
            "excludes" | "required" => (self.kind, 1, words.all(changes)),
            _ => return None,
        };
        let kind = format_ident!("{kind}");
        let Rule { help, space, .. } = self;
        // Which keys are needed, the table says that is changed.
        let when = if least > 1 { "" } else { self.when.as_str() };
        (keys.len() >= least && conditions).then(
            || quote! { #[keys(#kind(#(#keys),*, when = #when, help = #help, space = #space))] },
        )
    }
}
