//! Which module uses which, and the circles among them.

use std::collections::{BTreeMap, BTreeSet};

use super::source::{Crate, Import, Words};

/// For each module those whose items it uses.
pub type Graph = BTreeMap<Words, BTreeSet<Words>>;

/// Where a path leads inside the crate.
#[derive(Clone, Debug, PartialEq)]
struct Place {
    /// The module that defines what the path names.
    module: Words,
    /// Whether it names that module itself, not an item in it.
    whole: bool,
    /// Modules that hand the name on, on the way to it.
    through: Vec<Words>,
}

/// The arrows between the modules of a crate.
///
/// An arrow goes to the module that *defines* what is used, through all that hand the name on. Handing on alone
/// (`pub use child::Item`) is no use: whoever takes the name gets the arrow. What a type's methods need follows the
/// module where the type is named, not the one where an `impl` stands: a path is all that can be seen here.
pub fn graph(modules: &Crate) -> Graph {
    let mut arrows = Graph::new();
    for (here, module) in modules {
        let mut to = BTreeSet::new();
        for import in module.imports.iter().filter(|i| !i.handed_on) {
            to.extend(place(modules, here, &import.from, &mut Vec::new()).map(|p| p.module));
        }
        for words in module.mentions.keys() {
            to.extend(mentioned(modules, here, words).map(|p| p.module));
        }
        to.remove(here);
        arrows.insert(here.clone(), to);
    }
    arrows
}

/// All modules that each module names, with the line of the first time: those that define what is used,
/// those that hand it on, and those whose items are handed on.
pub fn named(modules: &Crate) -> BTreeMap<(&Words, Words), usize> {
    let mut found = BTreeMap::new();
    for (here, module) in modules {
        let imports =
            module.imports.iter().map(|i| (place(modules, here, &i.from, &mut Vec::new()), i.line));
        let mentions =
            module.mentions.iter().map(|(words, line)| (mentioned(modules, here, words), *line));
        for (place, line) in imports.chain(mentions) {
            for to in place.into_iter().flat_map(|p| p.through.into_iter().chain([p.module])) {
                let first = found.entry((here, to)).or_insert(line);
                *first = line.min(*first);
            }
        }
    }
    found
}

/// Where a path in the code of module `here` leads.
fn mentioned(modules: &Crate, here: &Words, words: &Words) -> Option<Place> {
    // A single word may be a variable that is called like a module.
    place(modules, here, words, &mut Vec::new()).filter(|p| words.len() > 1 || !p.whole)
}

/// Where `words`, written in module `here`, lead; `None` leaves the crate (or names what is no item).
fn place(
    modules: &Crate,
    here: &Words,
    words: &[String],
    tried: &mut Vec<(Words, String)>,
) -> Option<Place> {
    let (first, rest) = words.split_first()?;
    match first.as_str() {
        "crate" | "$crate" => walk(modules, vec!["crate".to_owned()], rest, tried),
        "self" => walk(modules, here.clone(), rest, tried),
        "super" => {
            let above = &here[..here.len().checked_sub(1)?];
            match rest.first() {
                Some(next) if next == "super" => place(modules, &above.to_vec(), rest, tried),
                Some(_) | None => walk(modules, above.to_vec(), rest, tried),
            }
        }
        _ => walk(modules, here.clone(), words, tried),
    }
}

/// Goes down from module `at`.
fn walk(
    modules: &Crate,
    at: Words,
    words: &[String],
    tried: &mut Vec<(Words, String)>,
) -> Option<Place> {
    let module = modules.get(&at)?;
    let Some((word, rest)) = words.split_first() else {
        return Some(Place { module: at, whole: true, through: Vec::new() });
    };
    if module.children.contains(word) {
        let below = [at.as_slice(), std::slice::from_ref(word)].concat();
        // A module of tests alone is not read.
        if modules.contains_key(&below) {
            return walk(modules, below, rest, tried);
        }
    }
    if module.items.contains(word) {
        return Some(Place { module: at, whole: false, through: Vec::new() });
    }
    let mark = (at.clone(), word.clone());
    if tried.contains(&mark) {
        return None;
    }
    tried.push(mark);
    let by_name = |i: &&Import| i.name.as_deref() == Some(word);
    let named = module.imports.iter().filter(by_name).map(|i| (i, rest));
    let all = module.imports.iter().filter(|i| i.name.is_none()).map(|i| (i, words));
    for (import, rest) in named.chain(all) {
        let whole = [import.from.as_slice(), rest].concat();
        if let Some(mut found) = place(modules, &at, &whole, tried) {
            found.through.push(at);
            return Some(found);
        }
    }
    None
}

/// The circles: sets of more than one module that all reach each other, the largest first (Tarjan, SIAM J. Comput. 1
/// (1972) 146).
pub fn circles(graph: &Graph) -> Vec<Vec<Words>> {
    let names: Vec<&Words> = graph.keys().collect();
    let number = |name: &Words| names.binary_search(&name).ok();
    let arrows: Vec<Vec<usize>> =
        graph.values().map(|to| to.iter().filter_map(number).collect()).collect();
    let mut search = Search {
        arrows: &arrows,
        index: vec![None; names.len()],
        low: vec![0; names.len()],
        on_stack: vec![false; names.len()],
        stack: Vec::new(),
        next: 0,
        found: Vec::new(),
    };
    for node in 0..names.len() {
        if search.index[node].is_none() {
            search.visit(node);
        }
    }
    let mut found: Vec<Vec<Words>> = search
        .found
        .into_iter()
        .filter(|c| c.len() > 1)
        .map(|mut c| {
            c.sort_unstable();
            c.into_iter().map(|k| names[k].clone()).collect()
        })
        .collect();
    found.sort_by_key(|c: &Vec<Words>| (std::cmp::Reverse(c.len()), c[0].clone()));
    found
}

struct Search<'a> {
    arrows: &'a [Vec<usize>],
    index: Vec<Option<usize>>,
    low: Vec<usize>,
    on_stack: Vec<bool>,
    stack: Vec<usize>,
    next: usize,
    found: Vec<Vec<usize>>,
}

impl Search<'_> {
    fn visit(&mut self, node: usize) {
        let own = self.next;
        self.index[node] = Some(own);
        self.low[node] = own;
        self.next += 1;
        self.stack.push(node);
        self.on_stack[node] = true;
        for &to in &self.arrows[node] {
            match self.index[to] {
                None => {
                    self.visit(to);
                    self.low[node] = self.low[node].min(self.low[to]);
                }
                Some(index) if self.on_stack[to] => self.low[node] = self.low[node].min(index),
                Some(_) => {}
            }
        }
        if self.low[node] == own {
            let mut circle = Vec::new();
            while let Some(top) = self.stack.pop() {
                self.on_stack[top] = false;
                circle.push(top);
                if top == node {
                    break;
                }
            }
            self.found.push(circle);
        }
    }
}
