//! Blocks of glued parts: what they weigh, what is refused, what is reported.

use super::*;

/// A floor, and an L on it of two bricks; the second one is `upper`.
fn ell(upper: &str) -> String {
    format!(
        r#"
[[blocks]]
name = "floor"
material = "rock"
brick = {{ size = ["9 m", "9 m", "1 m"], corner = ["-3 m", "-3 m", "-1 m"] }}
[[blocks]]
name = "ell"
material = "rock"
parts = [
  {{ brick = {{ size = ["3 m", "1 m", "1 m"], corner = ["0 m", "0 m", "0 m"] }} }},
  {{ brick = {{ size = ["1 m", "1 m", "2 m"], corner = {upper} }} }},
]
[[supports]]
on.block = "floor"
fixed = {{}}
"#
    )
}

fn wrong(middle: &str) -> String {
    let refused = try_solid(&format!("{SPACE}{middle}{TAIL}"));
    let Err(wrong) = refused else {
        panic!("{middle}");
    };
    wrong.to_string()
}

#[test]
fn parts_are_one_block_with_the_volume_of_all() {
    let (setup, model) = solid(&ell(r#"["0 m", "0 m", "1 m"]"#));
    assert_eq!(setup.blocks.len(), 2);
    assert!(setup.blocks[1].shape.is_glued());
    let mass = 2000.0 * (81.0 + 3.0 + 2.0);
    assert!((model.summary.mass - mass).abs() < 1e-9 * mass);
    assert!(model.warnings.is_empty(), "{:?}", model.warnings);
}

#[test]
fn what_is_convex_is_a_plain_block() {
    let (setup, _) = solid(&ell(r#"["-1 m", "0 m", "0 m"]"#).replace("\"2 m\"]", "\"1 m\"]"));
    assert!(!setup.blocks[1].shape.is_glued());
}

#[test]
fn parts_that_overlap_or_do_not_hang_together_are_named() {
    let overlap = wrong(&ell(r#"["0 m", "0 m", "0.5 m"]"#));
    assert!(overlap.contains("parts 1 and 2 overlap") && overlap.contains("ell"), "{overlap}");
    for apart in [r#"["0 m", "0 m", "1.5 m"]"#, r#"["3 m", "0 m", "1 m"]"#] {
        let apart = wrong(&ell(apart));
        assert!(apart.contains("parts 1 and 2 are not connected"), "{apart}");
    }
}

#[test]
fn strengths_that_do_not_act_on_glued_parts_are_told() {
    let weak = ell(r#"["0 m", "0 m", "1 m"]"#);
    let told = |space: &str, middle: &str| {
        let model = try_solid(&format!("{space}{middle}{TAIL}")).unwrap();
        model.warnings.iter().map(|w| w.message.clone()).collect::<Vec<_>>().join("\n")
    };
    let strong = SPACE.replace("friction_angle", "cohesion = \"1 MPa\"\nfriction_angle");
    let words = told(&strong, &weak);
    assert!(words.contains("cohesion and tension do not act between `ell` and `floor`"), "{words}");
    // It hangs in the air.
    let shifted = weak.replace("[[supports]]", "[[blocks]]\nname = \"other\"\nmaterial = \"rock\"\nbrick = { size = [\"1 m\", \"1 m\", \"1 m\"], corner = [\"0 m\", \"20 m\", \"0 m\"] }\n[[supports]]");
    let shifted =
        shifted.replace("name = \"ell\"", "name = \"ell\"\nshift = [\"0 m\", \"0 m\", \"1 m\"]");
    assert!(!told(&strong, &shifted).contains("cohesion and tension do not act"));
}

#[test]
fn a_block_of_no_parts_or_of_too_many_is_refused() {
    let none = wrong(
        "[[blocks]]\nname = \"ell\"\nmaterial = \"rock\"\nparts = []\n[[supports]]\non.block = \"ell\"\nfixed = {}\n",
    );
    assert!(
        none.contains("`parts` in blocks.ell is empty") && none.contains("`brick`, `grid`"),
        "{none}"
    );
}

#[test]
fn each_glued_block_names_the_first_block_that_it_touches() {
    let strong = SPACE.replace("friction_angle", "cohesion = \"1 MPa\"\nfriction_angle");
    let row = ell(r#"["0 m", "0 m", "1 m"]"#).replace(
        "name = \"ell\"",
        "name = \"ell\"\ncopies = { count = 3, step = [\"0 m\", \"1.5 m\", \"0 m\"] }",
    );
    let model = try_solid(&format!("{strong}{row}{TAIL}")).unwrap();
    let words: Vec<&str> = model
        .warnings
        .iter()
        .map(|w| w.message.as_str())
        .filter(|w| w.contains("do not act between"))
        .collect();
    assert_eq!(words.len(), 3, "{words:?}");
    assert!(words.iter().all(|w| w.contains("and `floor`")), "{words:?}");
}
