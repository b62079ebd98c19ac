//! Who may use whom: the arrows between the rooms of `crates/riprap/src`, and words that engines
//! may not contain. The compiler cannot know these rules, so this file is their only home.
//!
//! A room is a folder or file directly under `crates/riprap/src`. Test modules (`#[cfg(test)]`, at
//! the bottom of each file by convention) are free.

use std::path::Path;

use crate::source_tree::{files, shown};

/// Services every room may use.
const SERVICES: [&str; 9] = [
    "error", "exec", "geom", "ids", "lanes", "ledger", "profile", "Vec2", "Vec3",
];

/// Room, the rooms it may use besides the services, and why not more.
const ARROWS: [(&str, &[&str], &str); 8] = [
    ("laws", &[], "laws are pure functions on numbers"),
    (
        "dynamics",
        &["laws"],
        "clocks and integrators know no world",
    ),
    (
        "scenario",
        &["dynamics"],
        "the scenario is what the user said; it knows no engine",
    ),
    (
        "planar",
        &["laws", "dynamics", "record::field", "record::frame"],
        "an engine knows neither files nor scenarios nor the other engine",
    ),
    (
        "spatial",
        &["laws", "dynamics", "record::field", "record::frame"],
        "an engine knows neither files nor scenarios nor the other engine",
    ),
    (
        "record",
        &["dynamics"],
        "outputs read plain tables, never the inside of an engine",
    ),
    (
        "model",
        &[
            "scenario",
            "planar::setup",
            "spatial::setup",
            "run::plan",
            "run::checks",
            "record::field",
            "laws",
            "dynamics",
        ],
        "the model only fills the plain data that engines and the run loop declare",
    ),
    (
        "run",
        &[
            "record", "model", "scenario", "planar", "spatial", "laws", "dynamics",
        ],
        "the run loop joins everything",
    ),
];

/// Rooms in which the order of every sum matters.
const ENGINES: [&str; 4] = ["laws", "dynamics", "planar", "spatial"];

/// Word, rooms in which it is forbidden (empty: all), files that may, and why.
const FORBIDDEN: [(&str, &[&str], &[&str], &str); 10] = [
    (
        "mul_add",
        &[],
        &[],
        "rounds differently on machines with and without the instruction",
    ),
    (
        "HashMap",
        &ENGINES,
        &[],
        "its order differs from run to run",
    ),
    (
        "HashSet",
        &ENGINES,
        &[],
        "its order differs from run to run",
    ),
    (
        "rayon",
        &[],
        &["exec.rs"],
        "only exec.rs names the thread pool",
    ),
    (
        "thread::spawn",
        &[],
        &["exec.rs"],
        "only exec.rs names the thread pool",
    ),
    (
        "thread::scope",
        &[],
        &["exec.rs"],
        "only exec.rs names the thread pool",
    ),
    (
        "thread::Builder",
        &[],
        &["exec.rs"],
        "only exec.rs names the thread pool",
    ),
    (
        "AtomicF",
        &[],
        &[],
        "sums of atomic floats depend on the threads",
    ),
    (
        "atomic_float",
        &[],
        &[],
        "sums of atomic floats depend on the threads",
    ),
    (
        "thread_rng",
        &[],
        &[],
        "every random number comes from a seed in the scene",
    ),
];

/// What the viewer may use of the library: the readers of run folders, and vectors.
const OF_THE_VIEWER: [&str; 3] = ["record", "geom", "Vec3"];

/// Prints every breach; returns how many there are.
pub fn check(root: &Path) -> Result<u64, String> {
    let source = root.join("crates/riprap/src");
    let paths = files(&source, &["rs"]);
    if paths.is_empty() {
        return Err(format!("no sources under {}", source.display()));
    }
    let mut breaches = 0;
    for path in &paths {
        let text = std::fs::read_to_string(path).map_err(|e| format!("{}: {e}", path.display()))?;
        let inside = path.strip_prefix(&source).unwrap_or(path);
        // Tests kept beside a long file, by convention in `tests.rs` or a folder `tests`.
        if inside.ends_with("tests.rs") || inside.iter().any(|part| part == "tests") {
            continue;
        }
        for (line, message) in breaches_in(inside, &text) {
            println!("{}:{line}: {message}", shown(root, path));
            breaches += 1;
        }
    }
    let viewer = files(&root.join("crates/riprap-view/src"), &["rs"]);
    for path in &viewer {
        let text = std::fs::read_to_string(path).map_err(|e| format!("{}: {e}", path.display()))?;
        for (line, message) in breaches_of_the_viewer(&text) {
            println!("{}:{line}: {message}", shown(root, path));
            breaches += 1;
        }
    }
    println!("{} files, {breaches} breaches", paths.len() + viewer.len());
    Ok(breaches)
}

/// Uses of the library, in a file of the viewer, other than reading run folders.
fn breaches_of_the_viewer(text: &str) -> Vec<(usize, String)> {
    let code = without_comments_and_strings(text);
    paths_of(&code, "riprap::")
        .into_iter()
        .filter(|(_, used)| !OF_THE_VIEWER.contains(&used.split("::").next().unwrap_or(used)))
        .map(|(at, used)| {
            let line = code[..at].matches('\n').count() + 1;
            let why = "the viewer reads the run folder and nothing else";
            (line, format!("the viewer may not use `{used}`: {why}"))
        })
        .collect()
}

/// Breaches of one file (`inside`: path below `src`): line number and message.
fn breaches_in(inside: &Path, text: &str) -> Vec<(usize, String)> {
    let code = without_comments_and_strings(text);
    let code = code
        .find("#[cfg(test)]")
        .map_or(code.as_str(), |end| &code[..end]);
    let first = inside
        .iter()
        .next()
        .map(|p| p.to_string_lossy().into_owned())
        .unwrap_or_default();
    let room = first.trim_end_matches(".rs");
    let mut found = Vec::new();
    let line_of = |at: usize| code[..at].matches('\n').count() + 1;

    for (at, used) in crate_paths(code) {
        if let Some(why) = forbidden_arrow(room, &used) {
            found.push((line_of(at), format!("`{room}` may not use `{used}`: {why}")));
        }
    }
    for (word, rooms, allowed_files, why) in FORBIDDEN {
        let here = rooms.is_empty() || rooms.contains(&room);
        if !here || allowed_files.iter().any(|f| inside == Path::new(f)) {
            continue;
        }
        for (at, _) in code.match_indices(word) {
            found.push((line_of(at), format!("`{word}` is not allowed here: {why}")));
        }
    }
    found.sort();
    found
}

/// Why `room` may not use the path `used` (such as `planar::world`), or `None`.
fn forbidden_arrow(room: &str, used: &str) -> Option<&'static str> {
    let head = used.split("::").next().unwrap_or(used);
    if head == room || SERVICES.contains(&head) {
        return None;
    }
    if let Some((_, allowed, why)) = ARROWS.iter().find(|(name, _, _)| *name == room) {
        let within = |a: &str| used == a || used.starts_with(&format!("{a}::"));
        return if allowed.iter().any(|a| within(a)) {
            None
        } else {
            Some(why)
        };
    }
    let is_room = ARROWS.iter().any(|(name, _, _)| *name == head);
    (SERVICES.contains(&room) && is_room).then_some("services are used by rooms, not the reverse")
}

/// Every `crate::…` path in `code`, groups opened: offset and path without `crate::`.
fn crate_paths(code: &str) -> Vec<(usize, String)> {
    paths_of(code, "crate::")
}

/// Every path in `code` that begins with `root` (such as `crate::`), groups opened: offset and path without `root`.
fn paths_of(code: &str, root: &str) -> Vec<(usize, String)> {
    let mut found = Vec::new();
    for (at, _) in code.match_indices(root) {
        if at > 0 && code[..at].ends_with(|c: char| c.is_alphanumeric() || c == '_' || c == '$') {
            continue;
        }
        for path in open_group(&code[at + root.len()..], "") {
            found.push((at, path));
        }
    }
    found
}

/// Reads one use-path after `prefix`; `a::{b, c::d}` gives `a::b` and `a::c::d`.
fn open_group(text: &str, prefix: &str) -> Vec<String> {
    let text = text.trim_start();
    if let Some(inner) = text.strip_prefix('{') {
        let mut depth = 1;
        let mut start = 0;
        let mut paths = Vec::new();
        for (at, letter) in inner.char_indices() {
            match letter {
                '{' => depth += 1,
                '}' => depth -= 1,
                _ => {}
            }
            if depth == 0 || (depth == 1 && letter == ',') {
                let part = inner[start..at].trim();
                if !part.is_empty() {
                    paths.extend(open_group(part, prefix));
                }
                start = at + 1;
            }
            if depth == 0 {
                break;
            }
        }
        return paths;
    }
    let end = text
        .find(|c: char| !c.is_alphanumeric() && c != '_')
        .unwrap_or(text.len());
    let here = if prefix.is_empty() {
        text[..end].to_owned()
    } else {
        format!("{prefix}::{}", &text[..end])
    };
    match text[end..].strip_prefix("::") {
        Some(rest) => open_group(rest, &here),
        None => vec![here],
    }
}

/// `text` with comments, strings and character literals blanked (newlines kept).
fn without_comments_and_strings(text: &str) -> String {
    let letters: Vec<char> = text.chars().collect();
    let mut out = String::with_capacity(text.len());
    let mut i = 0;
    let blank = |out: &mut String, c: char| out.push(if c == '\n' { '\n' } else { ' ' });
    while i < letters.len() {
        let rest = &letters[i..];
        let length = if rest.starts_with(&['/', '/']) {
            rest.iter().position(|c| *c == '\n').unwrap_or(rest.len())
        } else if rest.starts_with(&['/', '*']) {
            rest.windows(2)
                .skip(2)
                .position(|w| w == ['*', '/'])
                .map_or(rest.len(), |p| p + 4)
        } else if rest[0] == '"' {
            string_length(rest)
        } else if let Some(n) = raw_string_length(rest, i.checked_sub(1).map(|p| letters[p])) {
            n
        } else {
            character_length(rest)
        };
        if length == 0 {
            out.push(letters[i]);
            i += 1;
        } else {
            for c in &rest[..length.min(rest.len())] {
                blank(&mut out, *c);
            }
            i += length;
        }
    }
    out
}

fn string_length(rest: &[char]) -> usize {
    let mut i = 1;
    while i < rest.len() {
        match rest[i] {
            '\\' => i += 2,
            '"' => return i + 1,
            _ => i += 1,
        }
    }
    rest.len()
}

fn raw_string_length(rest: &[char], before: Option<char>) -> Option<usize> {
    if rest[0] != 'r' || before.is_some_and(|c| c.is_alphanumeric() || c == '_') {
        return None;
    }
    let hashes = rest[1..].iter().take_while(|c| **c == '#').count();
    if rest.get(1 + hashes) != Some(&'"') {
        return None;
    }
    let mut close = vec!['"'];
    close.extend(std::iter::repeat_n('#', hashes));
    let body = 2 + hashes;
    let end = rest[body..].windows(close.len()).position(|w| w == close);
    Some(end.map_or(rest.len(), |p| body + p + close.len()))
}

/// Length of a character literal at the start of `rest`; 0 for a lifetime or anything else.
fn character_length(rest: &[char]) -> usize {
    match rest {
        ['\'', '\\', ..] => rest
            .iter()
            .skip(3)
            .position(|c| *c == '\'')
            .map_or(rest.len(), |p| p + 4),
        ['\'', _, '\'', ..] => 3,
        _ => 0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn messages(file: &str, text: &str) -> Vec<String> {
        breaches_in(Path::new(file), text)
            .into_iter()
            .map(|(l, m)| format!("{l}: {m}"))
            .collect()
    }

    #[test]
    fn a_forbidden_arrow_is_found_in_every_spelling() {
        for text in [
            "use crate::planar::World;",
            "use crate::{laws::x, planar::{World, step}};",
            "fn f() { crate::planar::step() }",
            "use crate::{\n    error::Error,\n    planar,\n};",
        ] {
            let found = messages("record/vtu.rs", text);
            assert!(
                found
                    .iter()
                    .any(|m| m.contains("`record` may not use `planar")),
                "{text}: {found:?}"
            );
        }
    }

    #[test]
    fn allowed_arrows_comments_strings_and_tests_are_left_alone() {
        let text = "//! uses crate::planar and mul_add\nuse crate::{laws, dynamics::TimeFunction, exec};\n\
                    const A: &str = \"crate::spatial HashMap\"; const B: char = '\"'; /* rayon */\n\
                    #[cfg(test)]\nmod tests { use crate::scenario::Scenario; use std::collections::HashMap; }";
        assert_eq!(messages("planar/step.rs", text), Vec::<String>::new());
    }

    #[test]
    fn the_model_sees_only_the_declared_part_of_an_engine() {
        assert_eq!(
            messages("model/build.rs", "use crate::planar::setup::Setup;").len(),
            0
        );
        assert_eq!(
            messages("model/build.rs", "use crate::planar::world::World;").len(),
            1
        );
        assert_eq!(
            messages("planar/world.rs", "use crate::spatial::World;").len(),
            1
        );
        assert_eq!(messages("ledger.rs", "use crate::planar::World;").len(), 1);
        assert_eq!(messages("lib.rs", "use crate::planar::World;").len(), 0);
    }

    #[test]
    fn the_viewer_only_reads() {
        let found = |text: &str| breaches_of_the_viewer(text).len();
        assert_eq!(
            found("use riprap::{Vec3, geom::Quat, record::{Frame, vtu}};"),
            0
        );
        assert_eq!(
            found("use riprap::run::job;\nuse riprap::{record::Frame, planar};"),
            2
        );
    }

    #[test]
    fn words_are_forbidden_where_the_table_says() {
        assert_eq!(
            messages("planar/a.rs", "\nlet m: HashMap<u8, u8>;")[0]
                .split(':')
                .next(),
            Some("2")
        );
        assert_eq!(
            messages("scenario/a.rs", "let m: HashMap<u8, u8>;").len(),
            0
        );
        assert_eq!(messages("exec.rs", "use rayon::prelude::*;").len(), 0);
        assert_eq!(messages("run/mod.rs", "use rayon::prelude::*;").len(), 1);
    }
}
