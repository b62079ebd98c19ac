//! What a value may be, in words and by an example.

use serde_json::Value;

use super::Node;
use crate::diagnostic;
use crate::quantity::KindInfo;
use crate::vectors::{FormInfo, InSpace};

/// A value to copy, if one can be made up.
pub(crate) fn example(node: Node) -> Option<String> {
    if let Some(kind) = node.kind() {
        let bare = kind.example.parse::<f64>().is_ok();
        return Some(if bare { kind.example.to_owned() } else { format!("\"{}\"", kind.example) });
    }
    if let Some((word, _)) = node.words().first() {
        return Some(format!("\"{word}\""));
    }
    let count = node.value.get("minItems").and_then(Value::as_u64)?;
    let of = Node::resolve(node.value.get("items")?);
    let item = example(of)?;
    let mut items = vec![item; count.min(3) as usize];
    // A vector along its last axis, where components may be nothing: gravity does not pull askew.
    if let Some(kind) = of.kind().filter(|kind| kind.bounds.contains(0.0))
        && let Some((_, unit)) = kind.example.split_once(' ')
        && let Some((_, others)) = items.split_last_mut()
    {
        others.fill(format!("\"0 {unit}\""));
    }
    Some(format!("[{}]", items.join(", ")))
}

/// What a value may be, in a few words.
pub(crate) fn takes(node: Node) -> String {
    if let Some(kind) = node.kind() {
        return takes_quantity(kind);
    }
    match node.type_name {
        Some("Every") => return "a time, a number of steps, \"1 phase\" or \"never\"".to_owned(),
        Some("Moment") => return "a time, \"start\" or \"end\"".to_owned(),
        Some("Names") => return "a name or a list of names".to_owned(),
        Some("Period") => return "a length or \"none\"".to_owned(),
        _ => {}
    }
    if let Some((form, _)) = node.type_name.and_then(FormInfo::of_type) {
        return takes_form(node, form);
    }
    let alternatives = node.alternatives();
    if !alternatives.is_empty() {
        let texts: Vec<String> = alternatives.into_iter().map(takes).collect();
        return texts.join("; or ");
    }
    let words = node.words();
    if !words.is_empty() {
        let words: Vec<&str> = words.iter().map(|(word, _)| *word).collect();
        return diagnostic::one_of(&words);
    }
    let variants = node.variants();
    if !variants.is_empty() {
        let keys: Vec<&str> = variants.iter().map(|(key, _, _)| *key).collect();
        return format!("a table with {}", diagnostic::one_of(&keys));
    }
    if node.allows("array") {
        let items = node.value.get("items").map(Node::resolve);
        let of = items.map(takes).unwrap_or_default();
        return match node.value.get("minItems").and_then(Value::as_u64) {
            Some(count) if count > 0 => format!("a list of {count}: each {of}"),
            _ => format!("a list: each {of}"),
        };
    }
    plain(node, ["a table", "a text", "a whole number", "true or false", "a number"])
}

/// The word for a value that is an object, a string, an integer, a boolean or a number.
pub(super) fn plain(node: Node, words: [&str; 5]) -> String {
    let mut types = ["object", "string", "integer", "boolean", "number"].into_iter().zip(words);
    types.find(|(json, _)| node.allows(json)).map_or("any value", |(_, word)| word).to_owned()
}

/// What a number, with or without a unit, may be.
fn takes_quantity(kind: &KindInfo) -> String {
    let other = kind.spatial.map_or_else(String::new, |other| {
        let (what, example) = (other.what, other.example);
        format!(" (in [space.spatial] {what}, \"{example}\")")
    });
    let (what, range, example) = (kind.what, kind.bounds.text, kind.example);
    match kind.dim {
        Some(dim) if dim == crate::units::Dim::NONE => format!("a number, {range}"),
        Some(_) if kind.bounds.low.is_infinite() => {
            format!("{what}, for example \"{example}\"{other}")
        }
        Some(_) => format!("{what}, {range}, for example \"{example}\"{other}"),
        None => format!("{what}, for example \"{example}\""),
    }
}

/// What a value with components may be, in both spaces.
fn takes_form(node: Node, form: &FormInfo) -> String {
    let of = |space: InSpace| {
        let accepts = form.accepts(space);
        let single = accepts.single.then(|| node.single()).flatten();
        let single = single.map(|kind| kind.in_space(Some(space)).what.to_owned());
        let items = node.items().map(Node::resolve).and_then(Node::kind);
        let items = items.filter(|_| accepts.list > 0);
        let list = items.map(|kind| {
            let what = kind.in_space(Some(space)).what;
            let axes = ["x", "y", "z"][..accepts.list.min(3)].join(", ");
            format!("[{axes}], each {what}")
        });
        let both: Vec<String> = single.into_iter().chain(list).collect();
        both.join(" or ")
    };
    let (planar, spatial) = (of(InSpace::Planar), of(InSpace::Spatial));
    format!("in [space.planar] {planar}; in [space.spatial] {spatial}")
}
