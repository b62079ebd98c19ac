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

/// Four rooms on three floors: `top` names `state` through the root, `read` hands on what `state` defines.
const ROOMS: [(&str, &str); 6] = [
    (
        "lib.rs",
        "mod setup; mod state; mod contact; mod read; pub use read::view; use state::World;",
    ),
    ("setup.rs", "pub struct Setup;"),
    ("state.rs", "use crate::setup::Setup; pub struct World(Setup);"),
    ("contact.rs", "mod law;"),
    ("contact/law.rs", "\nuse crate::{state::World,\n  setup::Setup};\nfn f(w: World) {}"),
    (
        "read.rs",
        "pub use crate::state::World as Kept; pub mod view { pub struct View(crate::World); pub const VIEW: u8 = 1; }",
    ),
];

/// The sample with the text of one file appended.
fn with(test: &str, file: &str, more: &str) -> Crate {
    let files = ROOMS.map(|(name, text)| {
        (name, if name == file { format!("{text}\n{more}") } else { text.to_owned() })
    });
    let files: Vec<(&str, &str)> = files.iter().map(|(n, t)| (*n, t.as_str())).collect();
    parsed(test, &files)
}

#[test]
fn rooms_name_only_what_is_below_and_to_the_left() {
    let sample = parsed("floors", &ROOMS);
    for floors in ["setup\nstate\ncontact\nread", "setup state # both\n\nread contact\n"] {
        assert_eq!(floors::tests::breaches(&sample, floors), (vec![], vec![]), "{floors}");
    }
    let (wrong, _) = floors::tests::breaches(&sample, "state setup\ncontact read");
    assert_eq!(wrong, ["state.rs:1: state names setup (to its right on floor 1)"]);
    let (wrong, _) = floors::tests::breaches(&sample, "setup\ncontact\nstate\nread");
    assert_eq!(wrong, ["contact/law.rs:2: contact names state (floor 3 above 2)"]);
}

#[test]
fn a_room_is_named_by_paths_macros_and_names_handed_on() {
    let floors = "setup\nstate\ncontact\nread";
    for (test, more) in [
        ("floors-path", "fn g(v: &crate::read::view::View) {}"),
        ("floors-macro", "fn g() { println!(\"{}\", crate::read::view::VIEW) }"),
        ("floors-root", "fn g(v: super::super::view::View) {}"),
        // The item is of `state`, the name of `read`.
        ("floors-on", "pub(crate) use crate::read::Kept;"),
    ] {
        let (wrong, circles) = floors::tests::breaches(&with(test, "contact/law.rs", more), floors);
        assert_eq!(wrong, ["contact/law.rs:5: contact names read (floor 4 above 3)"], "{more}");
        assert!(circles.is_empty());
    }
    let test = "#[cfg(test)] mod tests { use crate::read::view::View; }\n#[test] fn t() { crate::read::view::f() }";
    let sample = with("floors-test", "contact/law.rs", test);
    assert_eq!(floors::tests::breaches(&sample, floors), (vec![], vec![]));
    // What is named is a circle too, whatever the floors admit.
    let sample = with("floors-circle", "state.rs", "fn g(x: crate::read::view::View) {}");
    let admitted = format!("{floors}\nallow state -> read");
    assert_eq!(
        floors::tests::breaches(&sample, &admitted),
        (vec![], vec!["read state".to_owned()])
    );
}

#[test]
fn the_list_of_floors_is_true_itself() {
    let sample = parsed("floors-list", &ROOMS);
    for (floors, wrong) in [
        ("setup\nstate\nread", "floors.txt: no floor has the room `contact`"),
        ("setup\nstate\ncontact\nread\ngas", "floors.txt: the crate has no room `gas`"),
        ("setup\nstate\ncontact\nread setup", "floors.txt:4: `setup` has a floor already"),
        ("setup\nstate\ncontact\nread\nallow state", "floors.txt:5: write `allow room -> room`"),
        (
            "setup\nstate\ncontact\nread\nallow contact -> read",
            "floors.txt:5: contact names nothing above it in read: take this line out",
        ),
        (
            "setup\nstate\ncontact\nread\nallow read -> state",
            "floors.txt:5: read names nothing above it in state: take this line out",
        ),
    ] {
        assert!(floors::tests::breaches(&sample, floors).0.contains(&wrong.to_owned()), "{floors}");
    }
}
