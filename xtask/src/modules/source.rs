//! What the modules of a crate say they use: parsed with `syn`, tests left out by their attribute.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use proc_macro2::{TokenStream, TokenTree};
use syn::spanned::Spanned;
use syn::visit::Visit;
use syn::{Attribute, Item, UseTree, Visibility};

/// A path as written, `crate::a::B`, or a single word.
pub type Words = Vec<String>;

/// One name that a `use` brings in.
#[derive(Clone, Debug)]
pub struct Import {
    /// What it is here; `None` for `*`.
    pub name: Option<String>,
    /// Where it comes from, as written.
    pub from: Words,
    /// Handed on to others (`pub`, `pub(crate)`, ...).
    pub handed_on: bool,
    /// Line in the file.
    pub line: usize,
}

/// A module of a crate.
#[derive(Debug, Default)]
pub struct Module {
    /// Its file.
    pub file: PathBuf,
    /// Names of the modules in it.
    pub children: BTreeSet<String>,
    /// Names of the items it defines.
    pub items: BTreeSet<String>,
    /// What its `use` lines bring in, those inside functions too.
    pub imports: Vec<Import>,
    /// Paths of its code, with the words of macros; the line of the first of each.
    pub mentions: BTreeMap<Words, usize>,
}

/// The modules of a crate by their path; the root is `crate`.
pub type Crate = BTreeMap<Words, Module>;

/// Reads the crate whose root file is `root` (`lib.rs` or `main.rs`).
pub fn read(root: &Path) -> Result<Crate, String> {
    let mut modules = Crate::new();
    let folder = root.parent().unwrap_or(root).to_path_buf();
    read_file(root, &folder, vec!["crate".to_owned()], &mut modules)?;
    Ok(modules)
}

/// `folder`: where the files of the modules in it are.
fn read_file(file: &Path, folder: &Path, path: Words, into: &mut Crate) -> Result<(), String> {
    let text = std::fs::read_to_string(file).map_err(|e| format!("{}: {e}", file.display()))?;
    let parsed = syn::parse_file(&text).map_err(|e| {
        let place = e.span().start();
        format!("{}:{}: {e}", file.display(), place.line)
    })?;
    // A file that is all tests.
    if parsed.attrs.iter().any(is_test) {
        return Ok(());
    }
    read_items(&parsed.items, file, folder, path, into)
}

fn read_items(
    items: &[Item],
    file: &Path,
    folder: &Path,
    path: Words,
    into: &mut Crate,
) -> Result<(), String> {
    let mut reader = Reader { module: Module { file: file.to_path_buf(), ..Module::default() } };
    for item in items {
        if attributes(item).iter().any(is_test) {
            continue;
        }
        reader.module.items.extend(name_of(item));
        let Item::Mod(inner) = item else {
            reader.visit_item(item);
            continue;
        };
        let name = inner.ident.to_string();
        if inner.attrs.iter().any(|a| a.path().is_ident("path")) {
            return Err(format!("{}: `#[path]` on `mod {name}` is not understood", file.display()));
        }
        reader.module.children.insert(name.clone());
        let mut below = path.clone();
        below.push(name.clone());
        let inside = folder.join(&name);
        match &inner.content {
            Some((_, items)) => read_items(items, file, &inside, below, into)?,
            None => {
                let beside = folder.join(format!("{name}.rs"));
                let own = if beside.exists() { beside } else { inside.join("mod.rs") };
                read_file(&own, &inside, below, into)?;
            }
        }
    }
    into.insert(path, reader.module);
    Ok(())
}

/// `#[test]`, `#[cfg(test)]`, `#[cfg(all(test, ...))]`.
fn is_test(attribute: &Attribute) -> bool {
    if attribute.path().is_ident("test") {
        return true;
    }
    let Ok(list) = attribute.meta.require_list() else {
        return false;
    };
    attribute.path().is_ident("cfg") && holds_only_in_tests(list.tokens.clone())
}

/// Whether the condition of a `cfg` can hold in tests only: `test`, or `all` of which one is such a condition.
fn holds_only_in_tests(condition: TokenStream) -> bool {
    let tokens: Vec<TokenTree> = condition.into_iter().collect();
    match tokens.as_slice() {
        [TokenTree::Ident(word)] => word == "test",
        [TokenTree::Ident(word), TokenTree::Group(group)] if word == "all" => {
            let inner: Vec<TokenTree> = group.stream().into_iter().collect();
            inner
                .split(|t| matches!(t, TokenTree::Punct(p) if p.as_char() == ','))
                .any(|part| holds_only_in_tests(part.iter().cloned().collect()))
        }
        _ => false,
    }
}

fn attributes(item: &Item) -> &[Attribute] {
    match item {
        Item::Const(x) => &x.attrs,
        Item::Enum(x) => &x.attrs,
        Item::ExternCrate(x) => &x.attrs,
        Item::Fn(x) => &x.attrs,
        Item::ForeignMod(x) => &x.attrs,
        Item::Impl(x) => &x.attrs,
        Item::Macro(x) => &x.attrs,
        Item::Mod(x) => &x.attrs,
        Item::Static(x) => &x.attrs,
        Item::Struct(x) => &x.attrs,
        Item::Trait(x) => &x.attrs,
        Item::TraitAlias(x) => &x.attrs,
        Item::Type(x) => &x.attrs,
        Item::Union(x) => &x.attrs,
        Item::Use(x) => &x.attrs,
        // Tokens that syn does not understand have no attributes to look at.
        _ => &[],
    }
}

fn name_of(item: &Item) -> Option<String> {
    let ident = match item {
        Item::Const(x) => &x.ident,
        Item::Enum(x) => &x.ident,
        Item::Fn(x) => &x.sig.ident,
        Item::Macro(x) => x.ident.as_ref()?,
        Item::Static(x) => &x.ident,
        Item::Struct(x) => &x.ident,
        Item::Trait(x) => &x.ident,
        Item::TraitAlias(x) => &x.ident,
        Item::Type(x) => &x.ident,
        Item::Union(x) => &x.ident,
        _ => return None,
    };
    Some(ident.to_string())
}

/// Collects the paths of one module; modules inside are read apart.
struct Reader {
    module: Module,
}

impl Reader {
    fn imports(&mut self, tree: &UseTree, before: &Words, handed_on: bool) {
        let line = tree.span().start().line;
        let mut put = |name: Option<String>, from: Words| {
            self.module.imports.push(Import { name, from, handed_on, line });
        };
        match tree {
            UseTree::Path(path) => {
                let mut here = before.clone();
                here.push(path.ident.to_string());
                self.imports(&path.tree, &here, handed_on);
            }
            UseTree::Name(name) if name.ident == "self" => {
                put(before.last().cloned(), before.clone());
            }
            UseTree::Name(name) => {
                let word = name.ident.to_string();
                put(Some(word.clone()), [before.as_slice(), &[word]].concat());
            }
            UseTree::Rename(both) => {
                let word = both.ident.to_string();
                let from = if word == "self" {
                    before.clone()
                } else {
                    [before.as_slice(), &[word]].concat()
                };
                put(Some(both.rename.to_string()), from);
            }
            UseTree::Glob(_) => put(None, before.clone()),
            UseTree::Group(group) => {
                for tree in &group.items {
                    self.imports(tree, before, handed_on);
                }
            }
        }
    }

    /// Paths among the words of a macro, which nothing has parsed.
    fn words_of(&mut self, tokens: TokenStream) {
        let mut path: Words = Vec::new();
        let mut colons = 0;
        let mut line = 0;
        for token in tokens {
            let here = token.span().start().line;
            match token {
                TokenTree::Ident(word) => {
                    if colons != 2 {
                        self.keep(&mut path, line);
                    }
                    if path.is_empty() {
                        line = here;
                    }
                    path.push(word.to_string());
                    colons = 0;
                }
                TokenTree::Punct(p) if p.as_char() == ':' => colons += 1,
                TokenTree::Group(group) => {
                    self.keep(&mut path, line);
                    colons = 0;
                    self.words_of(group.stream());
                }
                TokenTree::Punct(_) | TokenTree::Literal(_) => {
                    self.keep(&mut path, line);
                    colons = 0;
                }
            }
        }
        self.keep(&mut path, line);
    }

    fn keep(&mut self, path: &mut Words, line: usize) {
        if !path.is_empty() {
            self.mention(std::mem::take(path), line);
        }
    }

    fn mention(&mut self, words: Words, line: usize) {
        self.module.mentions.entry(words).or_insert(line);
    }
}

impl<'a> Visit<'a> for Reader {
    fn visit_item(&mut self, item: &'a Item) {
        if !attributes(item).iter().any(is_test) {
            syn::visit::visit_item(self, item);
        }
    }

    fn visit_item_use(&mut self, item: &'a syn::ItemUse) {
        let handed_on = !matches!(item.vis, Visibility::Inherited);
        self.imports(&item.tree, &Words::new(), handed_on);
    }

    fn visit_impl_item_fn(&mut self, item: &'a syn::ImplItemFn) {
        if !item.attrs.iter().any(is_test) {
            syn::visit::visit_impl_item_fn(self, item);
        }
    }

    fn visit_path(&mut self, path: &'a syn::Path) {
        let words = path.segments.iter().map(|s| s.ident.to_string()).collect();
        self.mention(words, path.span().start().line);
        syn::visit::visit_path(self, path);
    }

    fn visit_expr_method_call(&mut self, call: &'a syn::ExprMethodCall) {
        // For the forbidden words; a method has no path.
        self.mention(vec![call.method.to_string()], call.method.span().start().line);
        syn::visit::visit_expr_method_call(self, call);
    }

    fn visit_macro(&mut self, call: &'a syn::Macro) {
        syn::visit::visit_macro(self, call);
        self.words_of(call.tokens.clone());
    }

    fn visit_item_macro(&mut self, item: &'a syn::ItemMacro) {
        self.visit_macro(&item.mac);
    }
}
