//! Doc comments, and names as words.

use syn::{Attribute, Expr, ExprLit, Lit, Meta};

/// First paragraph of the doc comment, on one line.
pub fn meaning(attributes: &[Attribute]) -> String {
    let lines = attributes.iter().filter_map(line);
    let first: Vec<String> =
        lines.map(|line| line.trim().to_owned()).take_while(|line| !line.is_empty()).collect();
    first.join(" ")
}

/// The doc comment: lines of a paragraph joined, paragraphs apart.
pub fn paragraphs(attributes: &[Attribute]) -> String {
    let mut text = String::new();
    for line in attributes.iter().filter_map(line) {
        match (line.trim(), text.is_empty() || text.ends_with('\n')) {
            ("", true) => {}
            ("", false) => text.push_str("\n\n"),
            (more, true) => text.push_str(more),
            (more, false) => {
                text.push(' ');
                text.push_str(more);
            }
        }
    }
    text.trim_end().to_owned()
}

fn line(attribute: &Attribute) -> Option<String> {
    let Meta::NameValue(pair) = &attribute.meta else {
        return None;
    };
    let Expr::Lit(ExprLit { lit: Lit::Str(text), .. }) = &pair.value else {
        return None;
    };
    pair.path.is_ident("doc").then(|| text.value())
}

/// `MohrCoulomb` as `mohr_coulomb`.
pub fn snake(name: &str) -> String {
    let mut word = String::new();
    for c in name.chars() {
        if c.is_uppercase() && !word.is_empty() {
            word.push('_');
        }
        word.extend(c.to_lowercase());
    }
    word
}
