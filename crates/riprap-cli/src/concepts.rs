//! What speaks of a concept: verbs, keys, fields, pages and scenes that hold a word or one of the same meaning.

use clap::CommandFactory;
use riprap::record::Shape;
use riprap::record::field::find as find_field;
use riprap::run::engine::Kind;
use riprap::scenario::{self, KeyDoc};

use crate::args::Cli;

/// A page or a scene: where it is, what it is about, which words stand in it how often.
struct Text {
    path: &'static str,
    about: &'static str,
    words: &'static str,
}

include!(concat!(env!("OUT_DIR"), "/index.rs"));

/// Words of one meaning, as their beginnings.
const SAME: &[&[&str]] = &[
    &["water", "pore", "fluid", "piezometr", "groundwater"],
    &["bolt", "rockbolt", "cable", "dowel"],
    &["liner", "lining", "shotcrete"],
    &["earthquake", "shaking", "seismic", "tremor"],
    &["explosive", "charge", "blast"],
    &["crack", "fracture"],
    &["joint", "discontinuit", "dfn"],
    &["fos", "safety"],
    &["keyblock", "removable", "wedge"],
    &["terrain", "topograph"],
    &["rebound", "restitution", "bounce"],
];
/// Words of other programs and of the trade, and what they are called here.
const CALLED: &[(&str, &[&str])] = &[
    ("jkn", &["normal", "stiffness"]),
    ("jks", &["shear", "stiffness"]),
    ("ucs", &["compressive", "strength"]),
];
/// Words that say nothing of what is looked for.
const SMALL: &[&str] = &["a", "an", "and", "for", "in", "of", "on", "the", "to"];
/// Most lines of each kind.
const MOST: usize = 12;

/// What speaks of `query`, as text to print; `None` where nothing does.
pub fn find(query: &str) -> Option<String> {
    let wanted: Vec<Vec<String>> = query
        .split(|c: char| c.is_whitespace() || c == '_')
        .filter(|word| !word.is_empty())
        .map(str::to_lowercase)
        .filter(|word| !SMALL.contains(&word.as_str()))
        .flat_map(|word| match CALLED.iter().find(|(there, _)| *there == word) {
            Some((_, here)) => here.iter().map(|word| meanings(word)).collect(),
            None => vec![meanings(&word)],
        })
        .collect();
    if wanted.is_empty() {
        return None;
    }
    let mut text = String::new();
    section(&mut text, "commands (riprap COMMAND --help)", verbs(&wanted));
    section(&mut text, "keys (riprap explain KEY)", keys(&wanted));
    section(&mut text, "fields (riprap fields)", fields(&wanted));
    section(&mut text, "pages", texts(PAGES, &wanted));
    section(&mut text, "scenes", texts(SCENES, &wanted));
    (!text.is_empty()).then_some(text)
}

/// Beginnings that a word may have: itself without the plural, and others of its meaning.
fn meanings(word: &str) -> Vec<String> {
    let lower = word.to_lowercase();
    let stem = match lower.strip_suffix('s') {
        Some(stem) if stem.len() > 2 && !stem.ends_with('s') => stem.to_owned(),
        Some(_) | None => lower,
    };
    let others = SAME
        .iter()
        .filter(|same| same.iter().any(|one| stem.starts_with(one)))
        .flat_map(|same| same.iter().map(|one| (*one).to_owned()));
    std::iter::once(stem.clone()).chain(others).collect()
}

/// How well a text says all that is wanted: how often the rarest of it is there.
fn count<'a>(words: impl Iterator<Item = (&'a str, u32)> + Clone, wanted: &[Vec<String>]) -> u32 {
    let of = |meanings: &[String]| {
        let fits = |word: &str| meanings.iter().any(|stem| word.starts_with(stem.as_str()));
        words.clone().filter(|(word, _)| fits(word)).map(|(_, n)| n).sum::<u32>()
    };
    wanted.iter().map(|meanings| of(meanings)).min().unwrap_or(0)
}

/// The words of a short text, each once.
fn split(text: &str) -> Vec<(String, u32)> {
    let words = text.split(|c: char| !c.is_alphanumeric());
    words.filter(|w| !w.is_empty()).map(|w| (w.to_lowercase(), 1)).collect()
}

fn count_in(text: &str, wanted: &[Vec<String>]) -> u32 {
    let words = split(text);
    count(words.iter().map(|(word, n)| (word.as_str(), *n)), wanted)
}

/// Rows to show and how many there were.
type Rows = (Vec<[String; 2]>, usize);

/// The best of rows with a mark each; equal ones stay in their order.
fn best(mut rows: Vec<(u32, [String; 2])>) -> Rows {
    rows.sort_by_key(|(mark, _)| std::cmp::Reverse(*mark));
    let all = rows.len();
    (rows.into_iter().take(MOST).map(|(_, row)| row).collect(), all)
}

fn keys(wanted: &[Vec<String>]) -> Rows {
    let mut rows: Vec<(u32, [String; 2])> = Vec::new();
    for key in shortest(scenario::keys()) {
        let last = key.path.rsplit('.').find(|word| *word != "*").unwrap_or("");
        let mark = 100 * count_in(last, wanted)
            + 10 * count_in(&key.path, wanted)
            + count_in(&key.text, wanted);
        if mark > 0 {
            rows.push((mark, [key.path.clone(), first_sentence(&key.text)]));
        }
    }
    best(rows)
}

/// A key that several tables take stands there once, where its path is shortest.
fn shortest(mut all: Vec<KeyDoc>) -> Vec<KeyDoc> {
    all.sort_by_key(|key| key.path.len());
    let mut seen = std::collections::BTreeSet::new();
    let last = |key: &KeyDoc| key.path.rsplit('.').next().unwrap_or("").to_owned();
    all.retain(|key| seen.insert((last(key), key.text.clone())));
    all
}

/// A field by its name, with or without a component, as text to print; `None` for any other word.
pub fn field(name: &str) -> Option<String> {
    let mut text = String::new();
    for (space, kind) in [("planar", Kind::Planar), ("spatial", Kind::Spatial)] {
        let Ok((info, _)) = find_field(kind.fields(), name) else {
            continue;
        };
        let parts = match info.shape {
            Shape::Scalar => "a scalar",
            Shape::Vector => "a vector: .x, .y, .magnitude",
            Shape::Vector3 => "a vector: .x, .y, .z, .magnitude",
        };
        text.push_str(&format!(
            "{} [{}], a field of [space.{space}]: {parts}\n  {}\n",
            info.name, info.unit, info.meaning
        ));
    }
    if text.is_empty() {
        return None;
    }
    text.push_str(
        "\nFields are read by outputs.*.history and by checks; riprap fields lists all.\n",
    );
    Some(text)
}

fn verbs(wanted: &[Vec<String>]) -> Rows {
    let mut rows: Vec<(u32, [String; 2])> = Vec::new();
    for verb in Cli::command().get_subcommands() {
        let about = verb.get_about().map_or_else(String::new, ToString::to_string);
        let mark = count_in(&format!("{} {about}", verb.get_name()), wanted);
        if mark > 0 {
            rows.push((mark, [format!("riprap {}", verb.get_name()), about]));
        }
    }
    best(rows)
}

fn fields(wanted: &[Vec<String>]) -> Rows {
    let mut rows: Vec<(u32, [String; 2])> = Vec::new();
    for kind in [Kind::Planar, Kind::Spatial] {
        for field in kind.fields() {
            let mark = 10 * count_in(field.name, wanted) + count_in(field.meaning, wanted);
            if mark > 0 && rows.iter().all(|(_, [name, _])| name != field.name) {
                rows.push((mark, [field.name.to_owned(), first_sentence(field.meaning)]));
            }
        }
    }
    best(rows)
}

fn texts(all: &[Text], wanted: &[Vec<String>]) -> Rows {
    let mut rows: Vec<(u32, [String; 2])> = Vec::new();
    for text in all {
        let mut words = Vec::new();
        let mut parts = text.words.split(' ');
        while let (Some(word), Some(n)) = (parts.next(), parts.next()) {
            words.push((word, n.parse().unwrap_or(1)));
        }
        let inside = count(words.iter().copied(), wanted);
        let about = count_in(text.about, wanted) + count_in(text.path, wanted);
        if about > 0 || inside > 0 {
            let mark = 1000 * about + inside;
            rows.push((mark, [text.path.to_owned(), text.about.to_owned()]));
        }
    }
    best(rows)
}

fn first_sentence(text: &str) -> String {
    let flat = text.split_whitespace().collect::<Vec<_>>().join(" ");
    match flat.split_once(". ") {
        Some((first, _)) => format!("{first}."),
        None => flat,
    }
}

fn section(text: &mut String, head: &str, (rows, all): Rows) {
    if rows.is_empty() {
        return;
    }
    let more = match all - rows.len() {
        0 => String::new(),
        n => format!(", the first {} of {}", rows.len(), n + rows.len()),
    };
    if !text.is_empty() {
        text.push('\n');
    }
    text.push_str(&format!("{head}{more}:\n"));
    let width = rows.iter().map(|[name, _]| name.len()).max().unwrap_or(0).min(60);
    for [name, about] in rows {
        text.push_str(&format!("  {name:<width$}  {about}\n"));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn concepts_lead_to_keys_fields_pages_and_scenes() {
        let friction = find("friction").expect("friction");
        for part in [
            "interfaces.*.friction_angle",
            "energy.friction",
            "docs/src/theory-planar.md",
            "scenes/",
        ] {
            assert!(friction.contains(part), "{part}\n{friction}");
        }
        for word in ["water", "bolts", "pore pressure", "earthquake", "Gravity"] {
            let said = find(word).unwrap_or_else(|| panic!("{word}"));
            assert!(said.contains("docs/src/"), "{word}\n{said}");
        }
        let shaking = find("earthquake").expect("earthquake");
        assert!(shaking.contains("scenes/planar/shaking.toml"), "{shaking}");
        assert!(find("xyzzy").is_none() && find("  ").is_none());
        // One mention on the front page is no answer.
        assert!(find("nonsense").is_none());
    }

    #[test]
    fn words_of_the_trade_lead_to_verbs_and_keys() {
        for (word, part) in [
            ("factor of safety", "riprap safety"),
            ("fos", "riprap safety"),
            ("jkn", "interfaces.*.normal_stiffness"),
            ("JKS", "interfaces.*.shear_stiffness"),
            ("dfn", "joint_sets"),
            ("ucs", "strength"),
        ] {
            let said = find(word).unwrap_or_else(|| panic!("{word}"));
            assert!(said.contains(part), "{word}\n{said}");
        }
    }

    #[test]
    fn a_field_is_shown_in_both_spaces() {
        let said = field("block.velocity.x").expect("field");
        assert!(said.contains("space.planar") && said.contains(".z, .magnitude"), "{said}");
        assert!(field("block.velocit").is_none());
    }

    #[test]
    fn several_words_must_all_be_there() {
        let both = find("friction gravity").expect("both");
        assert!(both.lines().count() < find("friction").expect("one").lines().count());
    }
}
