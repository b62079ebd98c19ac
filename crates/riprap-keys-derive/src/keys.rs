//! `#[derive(Keys)]`.

use proc_macro2::TokenStream;
use quote::{format_ident, quote};
use syn::ext::IdentExt;
use syn::punctuated::Punctuated;
use syn::{
    Attribute, Data, DeriveInput, Error, Expr, ExprLit, Fields, GenericArgument, GenericParam,
    Ident, Lit, LitStr, PathArguments, Result, Token, Type, parenthesized, parse_quote,
};

use crate::docs::paragraphs;
use crate::rules::Rule;

/// What a key is when the file does not have it.
enum Default {
    /// Nothing: the key is required, or absent.
    None,
    /// One text in all spaces.
    Text(String),
    /// One text in the plane, another one in space.
    Spaces(String, String),
    /// The default variant of an enum of words.
    Word,
    /// A number, a truth value or a list of them.
    Plain(Expr),
}

/// One key.
struct Key<'a> {
    ident: &'a Ident,
    ty: &'a Type,
    word: String,
    meaning: String,
    default: Default,
    space: Option<String>,
    instead: Option<String>,
    /// Whether phases may change it.
    changes: bool,
    /// Whether it is written down as it stands, components and all.
    told: bool,
    /// What reads it.
    readers: Vec<String>,
    /// Lowest and highest whole number.
    range: [Option<Expr>; 2],
    /// The type whose schema is taken instead of its own.
    schema_of: Option<Type>,
    /// Whether the file may leave it out.
    optional: bool,
    rules: Vec<Rule>,
    serde: Vec<&'a Attribute>,
}

pub fn derive(input: &DeriveInput) -> Result<TokenStream> {
    let Data::Struct(data) = &input.data else {
        return Err(Error::new_spanned(&input.ident, "keys are fields of a struct"));
    };
    let Fields::Named(fields) = &data.fields else {
        return Err(Error::new_spanned(&input.ident, "keys are fields with names"));
    };
    let keys: Vec<Key<'_>> = fields.named.iter().map(Key::new).collect::<Result<_>>()?;
    let table = TableAttributes::new(input, &keys)?;
    let schema = schema(input, &keys, &table)?;
    let read = read(input, &keys)?;
    let change = table.change.map(|(name, of)| changed_form(&name, &of, &keys, &table.rules));
    Ok(quote! { #schema #read #change })
}

/// What `#[keys(...)]` at the table says.
struct TableAttributes {
    /// `change = Name, path = "..."`: the form of the table in which a phase changes it, and where the table itself stands.
    change: Option<(Ident, String)>,
    /// `change_of = "..."` on that form: the table that it changes.
    change_of: Option<String>,
    /// Rules of the table, then those of its keys.
    rules: Vec<Rule>,
}

impl TableAttributes {
    fn new(input: &DeriveInput, keys: &[Key<'_>]) -> Result<Self> {
        let (mut name, mut path, mut change_of, mut rules) = (None, None, None, Vec::new());
        for attribute in input.attrs.iter().filter(|a| a.path().is_ident("keys")) {
            attribute.parse_nested_meta(|meta| {
                if meta.path.is_ident("change") {
                    name = Some(meta.value()?.parse::<Ident>()?);
                } else if meta.path.is_ident("path") {
                    path = Some(meta.value()?.parse::<LitStr>()?.value());
                } else if meta.path.is_ident("change_of") {
                    change_of = Some(meta.value()?.parse::<LitStr>()?.value());
                } else if let Some(rule) = Rule::parse(&meta, None)? {
                    let readers = keys.iter().map(|k| (k.word.as_str(), k.readers.as_slice()));
                    rules.push(rule.with_readers(readers));
                } else {
                    return Err(meta.error("`change`, `path`, `change_of` or a rule is expected"));
                }
                Ok(())
            })?;
        }
        rules.extend(keys.iter().flat_map(|key| key.rules.iter().cloned()));
        Ok(Self { change: name.zip(path), change_of, rules })
    }
}

impl<'a> Key<'a> {
    fn new(field: &'a syn::Field) -> Result<Self> {
        let ident = field.ident.as_ref().expect("named fields have names");
        let mut key = Key {
            ident,
            ty: &field.ty,
            word: ident.unraw().to_string(),
            meaning: paragraphs(&field.attrs),
            default: Default::None,
            space: None,
            instead: None,
            changes: false,
            told: false,
            readers: Vec::new(),
            range: [None, None],
            schema_of: None,
            optional: inner(&field.ty, "Option").is_some(),
            rules: Vec::new(),
            serde: field.attrs.iter().filter(|a| a.path().is_ident("serde")).collect(),
        };
        for attribute in &field.attrs {
            if attribute.path().is_ident("serde") {
                attribute.parse_nested_meta(|meta| {
                    if meta.path.is_ident("rename") {
                        key.word = meta.value()?.parse::<LitStr>()?.value();
                    } else if meta.path.is_ident("default") {
                        key.optional = true;
                    }
                    Ok(())
                })?;
            } else if attribute.path().is_ident("schemars") {
                attribute.parse_nested_meta(|meta| {
                    if !meta.path.is_ident("with") {
                        return Err(
                            meta.error("only `with` is known; say the rest in `#[key(...)]`")
                        );
                    }
                    let text = meta.value()?.parse::<LitStr>()?;
                    key.schema_of = Some(text.parse::<Type>()?);
                    Ok(())
                })?;
            } else if attribute.path().is_ident("key") {
                key.attribute(attribute)?;
            }
        }
        if key.meaning.is_empty() {
            let message = "the documentation is what users read: say what this means";
            return Err(Error::new_spanned(ident, message));
        }
        Ok(key)
    }

    fn attribute(&mut self, attribute: &Attribute) -> Result<()> {
        let (mut planar, mut spatial) = (None, None);
        attribute.parse_nested_meta(|meta| {
            let path = &meta.path;
            if path.is_ident("default") {
                self.default = match meta.value() {
                    Err(_) => Default::Word,
                    Ok(value) => match value.parse::<Expr>()? {
                        Expr::Lit(ExprLit {
                            lit: Lit::Str(text),
                            ..
                        }) => Default::Text(text.value()),
                        other => Default::Plain(other),
                    },
                };
            } else if path.is_ident("planar") {
                planar = Some(meta.value()?.parse::<LitStr>()?.value());
            } else if path.is_ident("spatial") {
                spatial = Some(meta.value()?.parse::<LitStr>()?.value());
            } else if path.is_ident("space") {
                self.space = Some(meta.value()?.parse::<LitStr>()?.value());
            } else if path.is_ident("instead") {
                self.instead = Some(meta.value()?.parse::<LitStr>()?.value());
            } else if path.is_ident("changes") {
                self.changes = true;
            } else if path.is_ident("told") {
                self.told = true;
            } else if path.is_ident("read_by") {
                let names;
                parenthesized!(names in meta.input);
                let names = Punctuated::<LitStr, Token![,]>::parse_terminated(&names)?;
                self.readers = names.iter().map(LitStr::value).collect();
            } else if path.is_ident("min") {
                self.range[0] = Some(meta.value()?.parse::<Expr>()?);
            } else if path.is_ident("max") {
                self.range[1] = Some(meta.value()?.parse::<Expr>()?);
            } else if let Some(rule) = Rule::parse(&meta, Some(&self.word))? {
                self.rules.push(rule);
            } else {
                return Err(meta.error(
                    "`default`, `planar`, `spatial`, `space`, `instead`, `min`, `max`, `told`, `read_by`, `changes` or a rule is expected",
                ));
            }
            Ok(())
        })?;
        if let Some((planar, spatial)) = planar.zip(spatial) {
            self.default = Default::Spaces(planar, spatial);
        }
        Ok(())
    }

    /// The defaults of a quantity, one or one for each space.
    fn texts(&self) -> Vec<&str> {
        match &self.default {
            Default::Text(text) => vec![text],
            Default::Spaces(planar, spatial) => vec![planar, spatial],
            Default::None | Default::Word | Default::Plain(_) => Vec::new(),
        }
    }

    /// The sentence about the default.
    fn sentence(&self) -> TokenStream {
        let text = match &self.default {
            Default::None => String::new(),
            Default::Text(text) => format!(" Default {text}."),
            Default::Spaces(planar, spatial) => {
                format!(" Default {planar} in `[space.planar]` and {spatial} in `[space.spatial]`.")
            }
            Default::Plain(Expr::Lit(ExprLit { lit: Lit::Int(number), .. })) => {
                format!(" Default {}.", number.base10_digits())
            }
            Default::Plain(value) => return quote! { format!(" Default {:?}.", #value) },
            Default::Word => {
                let ty = inner(self.ty, "Option").unwrap_or(self.ty);
                return quote! {
                    format!(" Default `{}`.", ::riprap_keys::Words::word(<#ty as ::std::default::Default>::default()))
                };
            }
        };
        quote! { #text.to_owned() }
    }
}

/// The JSON schema of the table.
fn schema(input: &DeriveInput, keys: &[Key<'_>], table: &TableAttributes) -> Result<TokenStream> {
    let name = &input.ident;
    let about = paragraphs(&input.attrs);
    if about.is_empty() {
        return Err(Error::new_spanned(
            name,
            "the documentation is what users read: say what this means",
        ));
    }
    let change_of = option(table.change_of.as_deref());
    let rules = table.rules.iter().map(Rule::tokens);
    let each = keys.iter().map(|key| {
        let ty = key.schema_of.as_ref().unwrap_or(key.ty);
        let (word, meaning, sentence) = (&key.word, &key.meaning, key.sentence());
        let range = key.range.iter().map(|end| match end {
            Some(end) => quote! { Some::<u64>(#end) },
            None => quote! { None },
        });
        let (space, instead) = (option(key.space.as_deref()), option(key.instead.as_deref()));
        let (required, texts) = (!key.optional, key.texts());
        quote! {
            table.key(crate::read::KeySchema {
                word: #word,
                schema: generator.subschema_for::<#ty>(),
                meaning: #meaning,
                default: #sentence,
                texts: &[#(#texts),*],
                space: #space,
                instead: #instead,
                required: #required,
                range: [#(#range),*],
            });
        }
    });
    let mut generics = input.generics.clone();
    for parameter in generics.type_params_mut() {
        parameter.bounds.push(parse_quote!(::schemars::JsonSchema));
    }
    let (head, types, conditions) = generics.split_for_impl();
    let of: Vec<&Ident> = generics.type_params().map(|p| &p.ident).collect();
    Ok(quote! {
        impl #head ::schemars::JsonSchema for #name #types #conditions {
            // Types that differ in a parameter only get numbers behind this name.
            fn schema_name() -> ::std::borrow::Cow<'static, str> {
                ::std::borrow::Cow::Borrowed(stringify!(#name))
            }
            fn schema_id() -> ::std::borrow::Cow<'static, str> {
                let parameters: &[::std::borrow::Cow<'static, str>] =
                    &[#(<#of as ::schemars::JsonSchema>::schema_id()),*];
                let id = concat!(module_path!(), "::", stringify!(#name));
                ::std::borrow::Cow::Owned(format!("{id}<{}>", parameters.join(",")))
            }
            fn json_schema(generator: &mut ::schemars::SchemaGenerator) -> ::schemars::Schema {
                let mut table = crate::read::TableSchema::new(#about, #change_of);
                #(#each)*
                table.finish(vec![#(#rules),*])
            }
        }
    })
}

/// The values of the table in SI, each written down when it is read.
fn read(input: &DeriveInput, keys: &[Key<'_>]) -> Result<TokenStream> {
    let mut methods = Vec::new();
    for key in keys {
        methods.push(reader(key)?);
    }
    let name = &input.ident;
    let (plain, types, conditions) = input.generics.split_for_impl();
    let values = keys.iter().filter_map(or_default);
    let read_by = read_by(keys)?;
    let mut generics = input.generics.clone();
    generics.params.insert(0, GenericParam::Lifetime(parse_quote!('said)));
    let (head, _, _) = generics.split_for_impl();
    Ok(quote! {
        impl #head crate::read::Read<'said, #name #types> #conditions {
            #(#methods)*
        }
        impl #plain #name #types #conditions {
            #(#values)*
            #read_by
        }
    })
}

fn reader(key: &Key<'_>) -> Result<Option<TokenStream>> {
    let (ident, word, ty) = (key.ident, &key.word, key.ty);
    let quantity = inner(inner(ty, "Option").unwrap_or(ty), "Quantity");
    let optional = inner(ty, "Option");
    let (mut name, mut doc) = (ident.clone(), format!("`{word}` in SI, written down."));
    let (mut arguments, mut more) = (TokenStream::new(), None);
    let (result, body) = match (&key.default, quantity, optional) {
        (Default::Text(text), Some(_), Some(_)) => {
            more = Some(other(key));
            (quote! { f64 }, quote! { self.quantity(#word, self.said().#ident.as_ref(), #text) })
        }
        (Default::Spaces(planar, spatial), Some(_), Some(_)) => {
            let body = quote! {
                let default = match self.space() {
                    crate::vectors::InSpace::Planar => #planar,
                    crate::vectors::InSpace::Spatial => #spatial,
                };
                self.quantity(#word, self.said().#ident.as_ref(), default)
            };
            (quote! { f64 }, body)
        }
        (Default::None, Some(_), None) => {
            (quote! { f64 }, quote! { self.required(#word, &self.said().#ident) })
        }
        (Default::None, Some(_), Some(_)) => {
            more = Some(other(key));
            (quote! { Option<f64> }, quote! { self.given(#word, self.said().#ident.as_ref()) })
        }
        (Default::Word, None, Some(inner)) => {
            (quote! { #inner }, quote! { self.word(#word, self.said().#ident) })
        }
        (Default::Plain(value), None, Some(inner)) => {
            (quote! { #inner }, quote! { self.plain(#word, self.said().#ident, #value) })
        }
        (Default::None, None, None) if key.told => {
            doc = format!("`{word}` as it stands, written down.");
            let body = quote! {
                let said = &self.said().#ident;
                self.told(#word, said);
                said
            };
            (quote! { &'said #ty }, body)
        }
        (Default::None, None, Some(inner)) if key.told => {
            doc = format!("`{word}` as it stands, if it does; written down.");
            let body = quote! {
                let said = self.said().#ident.as_ref()?;
                self.told(#word, said);
                Some(said)
            };
            (quote! { Option<&'said #inner> }, body)
        }
        (Default::None, None, Some(inner)) if is_plain(inner) => {
            name = format_ident!("{}_or", ident);
            doc = format!("`{word}`, or a value that comes from elsewhere; written down.");
            arguments = quote! { value: #inner, from: crate::read::Provenance, why: &str };
            let body = quote! { self.plain_or(#word, self.said().#ident, value, from, why) };
            (quote! { #inner }, body)
        }
        (Default::None, None, _) => return Ok(None),
        (_, _, _) => {
            return Err(Error::new_spanned(
                ident,
                "this default does not suit the type of the key",
            ));
        }
    };
    Ok(Some(quote! {
        #[doc = #doc]
        pub fn #name(&mut self, #arguments) -> #result {
            #body
        }
        #more
    }))
}

/// The keys that something of the model reads, for messages about keys without effect.
fn read_by(keys: &[Key<'_>]) -> Result<Option<TokenStream>> {
    let mut rows = Vec::new();
    for key in keys.iter().filter(|key| !key.readers.is_empty()) {
        let (ident, word, readers) = (key.ident, &key.word, &key.readers);
        let given = match key.ty {
            ty if inner(ty, "Option").is_some() => quote! { self.#ident.is_some() },
            Type::Path(path) if path.path.is_ident("bool") => quote! { self.#ident },
            other => {
                let message = "only a key that can be left out has readers";
                return Err(Error::new_spanned(other, message));
            }
        };
        rows.push(quote! { (#word, #given, &[#(#readers),*]) });
    }
    if rows.is_empty() {
        return Ok(None);
    }
    Ok(Some(quote! {
        /// The keys that `reader` reads, in the order of the table, and whether each is given.
        pub fn read_by(&self, reader: &str) -> Vec<(&'static str, bool)> {
            let keys: &[(&'static str, bool, &[&str])] = &[#(#rows),*];
            let keys = keys.iter().filter(|(_, _, readers)| readers.contains(&reader));
            keys.map(|&(word, given, _)| (word, given)).collect()
        }
    }))
}

/// The value of a number, for those who do not build the model: nothing is written down.
fn or_default(key: &Key<'_>) -> Option<TokenStream> {
    let Default::Plain(value) = &key.default else {
        return None;
    };
    let (ident, inner) = (key.ident, inner(key.ty, "Option")?);
    let name = format_ident!("{}_or_default", ident);
    let doc = format!("`{}`, default included.", key.word);
    Some(quote! {
        #[doc = #doc]
        pub fn #name(&self) -> #inner {
            self.#ident.unwrap_or(#value)
        }
    })
}

/// A method for a value that comes from elsewhere where the key is not given.
fn other(key: &Key<'_>) -> TokenStream {
    let (ident, word) = (key.ident, &key.word);
    let name = format_ident!("{}_or", ident);
    let doc = format!("`{word}` in SI, or a value that comes from elsewhere; written down.");
    quote! {
        #[doc = #doc]
        pub fn #name(&mut self, value: f64, from: crate::read::Provenance, why: &str) -> f64 {
            self.or(#word, self.said().#ident.as_ref(), value, from, why)
        }
    }
}

/// The keys that a phase may change, all optional.
fn changed_form(name: &Ident, of: &str, keys: &[Key<'_>], rules: &[Rule]) -> TokenStream {
    let changes = |word: &str| keys.iter().any(|key| key.changes && key.word == word);
    let rules = rules.iter().filter_map(|rule| rule.of_change(&changes));
    let about = format!("Keys of `{of}` that change when a phase begins; all others stay.");
    let fields = keys.iter().filter(|key| key.changes).map(|key| {
        let (ident, meaning, serde) = (key.ident, &key.meaning, &key.serde);
        let ty = inner(key.ty, "Option").unwrap_or(key.ty);
        let space = key.space.as_ref().map(|space| quote! { #[key(space = #space)] });
        let readers = (!key.readers.is_empty()).then(|| {
            let readers = &key.readers;
            quote! { #[key(read_by(#(#readers),*))] }
        });
        quote! {
            #[doc = #meaning]
            #(#serde)*
            #space
            #readers
            pub #ident: Option<#ty>,
        }
    });
    quote! {
        #[doc = #about]
        #[derive(Debug, Clone, PartialEq, ::serde::Deserialize, ::riprap_keys::Keys)]
        #[serde(deny_unknown_fields)]
        #[keys(change_of = #of)]
        #(#rules)*
        pub struct #name {
            #(#fields)*
        }
    }
}

fn option(text: Option<&str>) -> TokenStream {
    match text {
        Some(text) => quote! { Some(#text) },
        None => quote! { None },
    }
}

/// Whether a type is a truth value or a whole number.
fn is_plain(ty: &Type) -> bool {
    let Type::Path(path) = ty else { return false };
    ["bool", "u8", "u32", "u64"].iter().any(|plain| path.path.is_ident(plain))
}

/// `T` of `Name<T>`.
fn inner<'a>(ty: &'a Type, name: &str) -> Option<&'a Type> {
    let Type::Path(path) = ty else { return None };
    let last = path.path.segments.last().filter(|last| last.ident == name)?;
    let PathArguments::AngleBracketed(arguments) = &last.arguments else {
        return None;
    };
    arguments.args.iter().find_map(|argument| match argument {
        GenericArgument::Type(ty) => Some(ty),
        _ => None,
    })
}
