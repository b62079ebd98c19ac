//! A small crate on disk, read back.

use super::*;
use std::collections::BTreeSet;

/// Writes `files` (path and text) into a fresh folder and reads the crate.
fn parsed(test: &str, files: &[(&str, &str)]) -> Crate {
    let folder = std::env::temp_dir().join(format!("riprap-modules-{}-{test}", std::process::id()));
    let _ = std::fs::remove_dir_all(&folder);
    for (name, text) in files {
        let path = folder.join(name);
        std::fs::create_dir_all(path.parent().unwrap()).unwrap();
        std::fs::write(path, text).unwrap();
    }
    let modules = source::read(&folder.join("lib.rs"));
    std::fs::remove_dir_all(&folder).unwrap();
    modules.unwrap()
}

fn arrows(modules: &Crate, from: &str) -> BTreeSet<String> {
    let from: Words = from.split("::").map(str::to_owned).collect();
    graph::graph(modules)[&from].iter().map(|w| w.join("::")).collect()
}

fn set(words: &[&str]) -> BTreeSet<String> {
    words.iter().map(|w| (*w).to_owned()).collect()
}

#[test]
fn every_spelling_of_a_use_is_an_arrow() {
    for (test, body) in [
        "use crate::b::Thing;",
        "use crate::{b::{self, Thing}};",
        "use super::b;",
        "fn f() { let _ = crate::b::THING; }",
        "fn f() { use crate::b::*; }",
        "fn f(x: &crate::b::Thing) {}",
        "fn f() { println!(\"{}\", crate::b::THING) }",
        "fn f() { match 1 { crate::b::THING => {} _ => {} } }",
        "#[cfg(not(test))] use crate::b::Thing;",
    ]
    .into_iter()
    .enumerate()
    {
        let files = [
            ("lib.rs", "mod a; mod b;"),
            ("a.rs", body),
            ("b.rs", "pub struct Thing; pub const THING: i32 = 1;"),
        ];
        let modules = parsed(&format!("spelling{test}"), &files);
        assert_eq!(arrows(&modules, "crate::a"), set(&["crate::b"]), "{body}");
    }
}

#[test]
fn tests_comments_and_strings_are_none() {
    let a = "//! crate::b::Thing\nconst A: &str = \"crate::b::Thing\";\n\
             #[cfg(test)] use crate::b::Thing;\n\
             impl X { #[cfg(test)] fn f() { crate::b::g() } }\nstruct X;\n\
             #[cfg(test)] mod tests { use crate::b::Thing; }\n\
             #[cfg(all(test, unix))] fn h() { crate::b::g() }\nfn after() { crate::c::g() }";
    let files = [
        ("lib.rs", "mod a; mod b; mod c;"),
        ("a.rs", a),
        ("b.rs", "pub struct Thing; pub fn g() {}"),
        ("c.rs", "pub fn g() {}"),
    ];
    // What follows a test module is read like the rest.
    assert_eq!(arrows(&parsed("tests", &files), "crate::a"), set(&["crate::c"]));
}

#[test]
fn an_arrow_goes_through_names_handed_on() {
    let files = [
        ("lib.rs", "mod a; mod b; pub use b::Thing; pub use b::deep as shallow;"),
        ("a.rs", "use crate::Thing; fn f() { crate::shallow::g() }"),
        ("b.rs", "pub mod deep; pub use deep::inner::*;"),
        ("b/deep/mod.rs", "pub mod inner; pub fn g() {}"),
        ("b/deep/inner.rs", "pub struct Thing;"),
    ];
    let modules = parsed("handed", &files);
    assert_eq!(arrows(&modules, "crate::a"), set(&["crate::b::deep", "crate::b::deep::inner"]));
    assert_eq!(arrows(&modules, "crate"), set(&[]));
    assert_eq!(arrows(&modules, "crate::b"), set(&[]));
}

#[test]
fn circles_are_found_and_variables_are_no_modules() {
    let files = [
        ("lib.rs", "mod a; mod b; mod c; mod step;"),
        ("a.rs", "use crate::b::B; pub struct A;"),
        ("b.rs", "use crate::c::C; pub struct B;"),
        ("c.rs", "use super::a::A; pub struct C; fn f(step: f64) -> f64 { step }"),
        ("step.rs", "use crate::a::A;"),
    ];
    let modules = parsed("circles", &files);
    let circles = graph::circles(&graph::graph(&modules));
    let sizes: Vec<usize> = circles.iter().map(Vec::len).collect();
    assert_eq!(sizes, [3]);
    assert_eq!(too_large("riprap-core", &modules), 0);
}

#[test]
fn a_circle_of_ten_is_refused() {
    let names: Vec<String> = (0..10).map(|k| format!("m{k}")).collect();
    let root: String = names.iter().map(|n| format!("mod {n};")).collect();
    let texts: Vec<(String, String)> = (0..10)
        .map(|k| {
            let text = format!("pub struct T; fn f(_: crate::m{}::T) {{}}", (k + 1) % 10);
            (format!("m{k}.rs"), text)
        })
        .collect();
    let mut files = vec![("lib.rs", root.as_str())];
    files.extend(texts.iter().map(|(n, t)| (n.as_str(), t.as_str())));
    assert_eq!(too_large("riprap-core", &parsed("ten", &files)), 1);
}

#[test]
fn arrows_between_crates_are_those_of_the_table() {
    let manifest = "[package]\nname = \"x\"\n[dependencies]\nriprap-core.workspace = true\nriprap-spatial = { path = \"../x\" }\n\
                    [dev-dependencies]\nriprap.workspace = true\n";
    let found = forbidden_arrows("riprap-planar", manifest);
    assert_eq!(found.len(), 1, "{found:?}");
    assert!(found[0].contains("may not use `riprap-spatial`"), "{found:?}");
    assert_eq!(forbidden_arrows("riprap-cli", manifest).len(), 0);
}

#[test]
fn words_are_forbidden_where_the_table_says() {
    let found = |name: &str, text: &str| {
        let modules = parsed("words", &[("lib.rs", text)]);
        forbidden_words(Path::new("/"), name, &modules).len()
    };
    assert_eq!(found("riprap-planar", "fn f(m: std::collections::HashMap<u8, u8>) {}"), 1);
    assert_eq!(found("riprap-scenario", "use std::collections::HashMap;"), 0);
    assert_eq!(found("riprap-scenario", "fn f(x: f64) { x.mul_add(x, x); }"), 1);
    assert_eq!(found("riprap-plot", "fn f(x: f64) { assert!(x.mul_add(x, x) > 0.0); }"), 1);
    assert_eq!(found("riprap", "use rayon::prelude::*;"), 1);
    assert_eq!(found("riprap-core", "fn f() { std::thread::spawn(|| ()); }"), 1);
    assert_eq!(found("riprap-core", "#[cfg(test)] mod tests { use rayon::x; }"), 0);
}
