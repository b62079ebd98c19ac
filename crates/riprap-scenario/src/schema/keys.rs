//! The keys of the language and their documentation.

use serde_json::Value;

use super::{FoundKey, Node, description, takes};
use crate::diagnostic::closest;

/// A text on one line.
pub(super) fn flat(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// One key of the language.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct KeyDoc {
    /// Path with dots; `*` stands for a free name or an index.
    pub path: String,
    /// What it takes, in a few words.
    pub takes: String,
    /// What it means.
    pub text: String,
    /// Whether its table must have it.
    pub required: bool,
    /// Allowed words, with their meaning.
    pub words: Vec<(String, String)>,
}

/// Every key of the language; tables in alphabetical order.
pub fn keys() -> Vec<KeyDoc> {
    let mut out = Vec::new();
    collect(Node::root(), "", &mut out);
    out
}

fn collect(node: Node, path: &str, out: &mut Vec<KeyDoc>) {
    // Deeper paths would only repeat; the language is at most this deep.
    if path.matches('.').count() > 12 {
        return;
    }
    node.each_key(path, &|_| true, &mut |key, path| add(key, path, out));
}

/// What a key means: its own text, and what that of its type adds.
pub(super) fn meaning(documented: &'static Value, node: Node) -> String {
    let own = flat(description(documented));
    let of_type = flat(description(node.value));
    match (own.is_empty(), of_type.is_empty() || of_type == own) {
        (true, _) => of_type,
        (false, true) => own,
        // Only what the text of the key cannot know: "Exactly one of ...".
        (false, false) => match of_type.split_once(". ") {
            Some((_, more)) if node.kind().is_none() && !own.contains(more) => {
                format!("{own} {more}")
            }
            _ => own,
        },
    }
}

fn add(key: FoundKey, path: &str, out: &mut Vec<KeyDoc>) {
    let node = Node::resolve(key.value);
    let text = meaning(key.documented, node);
    let words = node.words();
    // A free name without text of its own is documented by the key above it.
    if !text.is_empty() || !path.ends_with('*') {
        out.push(KeyDoc {
            path: path.to_owned(),
            takes: takes(node),
            text,
            required: key.required,
            words: words.into_iter().map(|(word, text)| (word.to_owned(), flat(text))).collect(),
        });
    }
    collect(node, path, out);
    if let Some(items) = node.value.get("items") {
        let items = Node::resolve(items);
        if items.allows("object") || !items.variants().is_empty() {
            collect(items, &format!("{path}.*"), out);
        }
    }
}

fn fits(pattern: &str, path: &str) -> bool {
    let (pattern, path): (Vec<&str>, Vec<&str>) =
        (pattern.split('.').collect(), path.split('.').collect());
    pattern.len() == path.len() && pattern.iter().zip(&path).all(|(p, k)| *p == "*" || p == k)
}

/// Documentation of a key written with dots, such as `interfaces.default.normal_stiffness`.
/// Free names and indices may be anything or left out; a last word alone finds all its places.
///
/// # Errors
/// No such key; the text says which one is close.
pub fn explain_key(path: &str) -> Result<String, String> {
    let all = keys();
    let wanted: String = path.replace("[[", "").replace("]]", "").replace(['[', ']', '"'], "");
    let wanted = wanted.trim().trim_matches('.');
    if wanted.is_empty() || wanted.len() > 300 {
        return Err("write a key with dots, for example `materials.rock.density`".to_owned());
    }
    let without_stars = |key: &KeyDoc| key.path.replace(".*", "");
    let mut found: Vec<&KeyDoc> = all.iter().filter(|key| fits(&key.path, wanted)).collect();
    // `x.*` also fits a fixed key of the same place; the fixed one is meant.
    found.sort_by_key(|key| key.path.matches('*').count());
    found.truncate(1);
    if found.is_empty() {
        found = all.iter().filter(|key| without_stars(key) == wanted).collect();
    }
    if found.is_empty() {
        let ending = format!(".{wanted}");
        found = all.iter().filter(|key| without_stars(key).ends_with(&ending)).collect();
    }
    if found.is_empty() {
        let last = wanted.rsplit('.').next().unwrap_or(wanted);
        let lasts: Vec<&str> =
            all.iter().filter_map(|key| key.path.rsplit('.').find(|word| *word != "*")).collect();
        let mut help = String::new();
        if let Some(word) = closest(last, lasts) {
            let ending = format!(".{word}");
            let places: Vec<&str> = all
                .iter()
                .map(|key| key.path.as_str())
                .filter(|path| *path == word || path.ends_with(&ending))
                .take(5)
                .collect();
            help = format!("; did you mean {}?", places.join(" or "));
        }
        return Err(format!("there is no key `{wanted}`{help}"));
    }
    let mut text = String::new();
    for key in found {
        if !text.is_empty() {
            text.push('\n');
        }
        text.push_str(&key_text(key, &all));
    }
    Ok(text)
}

fn key_text(key: &KeyDoc, all: &[KeyDoc]) -> String {
    let need = if key.required { " (required)" } else { "" };
    let mut text = format!("{}{need}\n  {}\n  Takes {}.\n", key.path, key.text, key.takes);
    for (word, meaning) in key.words.iter().filter(|(_, meaning)| !meaning.is_empty()) {
        text.push_str(&format!("    {word}: {meaning}\n"));
    }
    let start = format!("{}.", key.path);
    let inside: Vec<&str> = all
        .iter()
        .filter_map(|other| other.path.strip_prefix(&start))
        .map(|rest| rest.trim_start_matches("*."))
        .filter(|rest| !rest.contains('.') && *rest != "*")
        .collect();
    if !inside.is_empty() {
        text.push_str(&format!("  Keys: {}.\n", inside.join(", ")));
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_key_is_documented() {
        let keys = keys();
        assert!(keys.len() > 200, "{}", keys.len());
        for key in &keys {
            assert!(!key.text.is_empty(), "{} has no text", key.path);
            assert!(key.takes != "any value" || key.path.contains('*'), "{}", key.path);
        }
    }

    #[test]
    fn explains_keys() {
        let text = explain_key("interfaces.default.normal_stiffness").unwrap();
        assert!(text.contains("Pa/m") && text.contains("10 GPa/m"), "{text}");
        let text = explain_key("blocks.slope.arch.radius").unwrap();
        assert!(text.contains("centre line"), "{text}");
        let text = explain_key("blocks.arch.radius").unwrap();
        assert!(text.contains("centre line"), "{text}");
        let text = explain_key("joint_sets").unwrap();
        assert!(text.contains("persistence"), "{text}");
        let text = explain_key("interfaces.default.law").unwrap();
        assert!(text.contains("conserves energy"), "{text}");
        let error = explain_key("interfaces.default.normal_stifness").unwrap_err();
        assert!(error.contains("interfaces.*.normal_stiffness"), "{error}");
        assert!(explain_key("").is_err());
    }
}
