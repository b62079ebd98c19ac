//! What is wrong with a scenario, where, and what to do about it.

use std::fmt::Write as _;
use std::ops::Range;

/// How bad it is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Severity {
    /// The scenario cannot be used.
    Error,
    /// It can, but probably not as meant.
    Warning,
}

/// One remark about a scenario.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Diagnostic {
    /// How bad it is.
    pub severity: Severity,
    /// Stable name of the kind of remark, such as `unit.missing`.
    pub code: &'static str,
    /// What is wrong, one sentence without full stop.
    pub message: String,
    /// Bytes of the source text, if it is about a place.
    pub span: Option<Range<usize>>,
    /// A few words for the place itself.
    pub label: Option<String>,
    /// What to do.
    pub help: Option<String>,
}

impl Diagnostic {
    /// An error without place.
    pub fn error(code: &'static str, message: impl Into<String>) -> Self {
        Diagnostic {
            severity: Severity::Error,
            code,
            message: message.into(),
            span: None,
            label: None,
            help: None,
        }
    }

    /// A warning without place.
    pub fn warning(code: &'static str, message: impl Into<String>) -> Self {
        Diagnostic { severity: Severity::Warning, ..Self::error(code, message) }
    }

    /// The place it is about.
    #[must_use]
    pub fn at(mut self, span: Range<usize>) -> Self {
        self.span = Some(span);
        self
    }

    /// A few words for the place.
    #[must_use]
    pub fn label(mut self, label: impl Into<String>) -> Self {
        self.label = Some(label.into());
        self
    }

    /// What to do.
    #[must_use]
    pub fn help(mut self, help: impl Into<String>) -> Self {
        self.help = Some(help.into());
        self
    }
}

/// A text and what to call it.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Source {
    /// Path or other name.
    pub name: String,
    /// The text.
    pub text: String,
}

impl Source {
    /// A text with a name.
    pub fn new(name: impl Into<String>, text: impl Into<String>) -> Self {
        Source { name: name.into(), text: text.into() }
    }

    /// Line and column of a byte, both from 1; columns count characters.
    pub fn line_column(&self, byte: usize) -> (usize, usize) {
        let byte = self.floor(byte);
        let before = &self.text[..byte];
        let line_start = before.rfind('\n').map_or(0, |at| at + 1);
        (before.matches('\n').count() + 1, before[line_start..].chars().count() + 1)
    }

    /// The last character boundary at or before a byte.
    fn floor(&self, byte: usize) -> usize {
        let mut byte = byte.min(self.text.len());
        while !self.text.is_char_boundary(byte) {
            byte -= 1;
        }
        byte
    }
}

/// Remarks about one text.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Diagnostics {
    /// The text they are about.
    pub source: Source,
    /// The remarks, in the order of the text.
    pub list: Vec<Diagnostic>,
}

impl Diagnostics {
    /// Remarks about a text, sorted by place.
    pub fn new(source: Source, mut list: Vec<Diagnostic>) -> Self {
        list.sort_by_key(|diagnostic| diagnostic.span.as_ref().map_or(0, |span| span.start));
        Diagnostics { source, list }
    }

    /// Number of errors.
    pub fn errors(&self) -> usize {
        self.list.iter().filter(|diagnostic| diagnostic.severity == Severity::Error).count()
    }

    /// Number of warnings.
    pub fn warnings(&self) -> usize {
        self.list.len() - self.errors()
    }

    /// Plain text: one block for each remark, with the line and a mark under the place.
    pub fn render(&self) -> String {
        let mut text = String::new();
        for diagnostic in &self.list {
            if !text.is_empty() {
                text.push('\n');
            }
            self.render_one(diagnostic, &mut text);
        }
        text
    }

    fn render_one(&self, diagnostic: &Diagnostic, out: &mut String) {
        let severity = match diagnostic.severity {
            Severity::Error => "error",
            Severity::Warning => "warning",
        };
        // Writing to a String cannot fail.
        let _ = writeln!(out, "{severity}[{}]: {}", diagnostic.code, diagnostic.message);
        let Some(span) = &diagnostic.span else {
            let _ = writeln!(out, "  --> {}", self.source.name);
            if let Some(help) = &diagnostic.help {
                let _ = writeln!(out, "  help: {help}");
            }
            return;
        };
        let (line, column) = self.source.line_column(span.start);
        let _ = writeln!(out, "  --> {}:{line}:{column}", self.source.name);
        let (shown, mark_at, mark_length) = self.excerpt(span);
        let number = line.to_string();
        let gap = " ".repeat(number.len());
        let _ = writeln!(out, "{gap} |");
        let _ = writeln!(out, "{number} | {shown}");
        let label = diagnostic.label.as_deref().unwrap_or_default();
        let mark =
            format!("{gap} | {}{} {label}", " ".repeat(mark_at), "^".repeat(mark_length.max(1)));
        let _ = writeln!(out, "{}", mark.trim_end());
        if let Some(help) = &diagnostic.help {
            let _ = writeln!(out, "{gap} = help: {help}");
        }
    }

    /// The line of a span, cut to a readable width, with the start and length of the mark.
    fn excerpt(&self, span: &Range<usize>) -> (String, usize, usize) {
        const BEFORE: usize = 60;
        const WIDTH: usize = 110;
        let text = &self.source.text;
        let start = self.source.floor(span.start);
        let line_start = text[..start].rfind('\n').map_or(0, |at| at + 1);
        let line_end = text[start..].find('\n').map_or(text.len(), |at| start + at);
        let end = self.source.floor(span.end).clamp(start, line_end);
        let before: Vec<char> = text[line_start..start].chars().rev().take(BEFORE).collect();
        let cut_left = text[line_start..start].chars().nth(BEFORE).is_some();
        let mut shown = String::from(if cut_left { "..." } else { "" });
        shown.extend(before.iter().rev().copied().map(printable));
        let mark_at = shown.chars().count();
        let room = WIDTH.saturating_sub(mark_at);
        shown.extend(text[start..line_end].chars().take(room).map(printable));
        let cut_right = text[start..line_end].chars().nth(room).is_some();
        let mark_length = text[start..end].chars().take(room).count();
        let mut shown = shown.trim_end().to_owned();
        if cut_right {
            shown.push_str("...");
        }
        (shown, mark_at, mark_length)
    }
}

/// Control characters would spoil a terminal; tabs would shift the mark.
fn printable(c: char) -> char {
    match c {
        '\t' => ' ',
        c if c.is_control() => '\u{fffd}',
        c => c,
    }
}

impl std::fmt::Display for Diagnostics {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&self.render())
    }
}

impl std::error::Error for Diagnostics {}

/// Words that many write first, and the one that is meant where it is known.
const MEANT: &[(&str, &str)] = &[
    ("friction", "friction_angle"),
    ("jfriction", "friction_angle"),
    ("stiffness", "normal_stiffness"),
    ("jkn", "normal_stiffness"),
    ("jks", "shear_stiffness"),
    ("jcohesion", "cohesion"),
    ("jtension", "tension"),
];

/// The known word that is most like a mistyped one, if any is close enough.
pub fn closest<'a>(word: &str, known: impl IntoIterator<Item = &'a str>) -> Option<String> {
    // Comparing is quadratic in the length of the words.
    if word.len() > 60 {
        return None;
    }
    let lower = word.to_lowercase();
    let known: Vec<&str> = known.into_iter().collect();
    let meant = MEANT.iter().find(|(written, _)| *written == lower);
    if let Some((_, meant)) = meant.filter(|(_, meant)| known.contains(meant)) {
        return Some((*meant).to_owned());
    }
    let mut best: Option<(f64, &str)> = None;
    for candidate in known {
        let other = candidate.to_lowercase();
        let distance = strsim::damerau_levenshtein(&lower, &other);
        let longest = lower.chars().count().max(other.chars().count());
        let close = distance * 3 <= longest.max(3) && distance < longest;
        let begins = lower.chars().count() >= 3 && other.starts_with(&lower);
        let likeness = strsim::jaro_winkler(&lower, &other);
        if (close || begins) && best.is_none_or(|(known, _)| likeness > known) {
            best = Some((likeness, candidate));
        }
    }
    best.map(|(_, word)| word.to_owned())
}

/// "did you mean `x`?" or the list of valid names.
pub fn suggest<'a>(word: &str, known: impl IntoIterator<Item = &'a str> + Clone) -> Option<String> {
    if let Some(word) = closest(word, known.clone()) {
        return Some(format!("did you mean `{word}`?"));
    }
    let all: Vec<&str> = known.into_iter().collect();
    match all.len() {
        0 => None,
        1..=30 => Some(format!("valid names: {}", list(&all))),
        more => Some(format!("valid names: {}, ... (20 of {more})", list(&all[..20]))),
    }
}

/// "one of `a`, `b`", or "`a`" if there is only one.
pub fn one_of(words: &[&str]) -> String {
    if words.len() == 1 { list(words) } else { format!("one of {}", list(words)) }
}

/// The beginning of a long word, without control characters.
pub(crate) fn short(word: &str) -> String {
    let mut text: String = word.chars().filter(|c| !c.is_control()).take(40).collect();
    if word.chars().nth(40).is_some() {
        text.push_str("...");
    }
    text
}

/// `a`, `b`, `c`
pub fn list(words: &[&str]) -> String {
    words.iter().map(|word| format!("`{word}`")).collect::<Vec<_>>().join(", ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn marks_the_place() {
        let source = Source::new("a.toml", "x = 1\n\työung = \"30 deg\"\n");
        let at = source.text.find('"').unwrap();
        let list = vec![
            Diagnostic::error("unit.dimension", "wrong").at(at..at + 8).label("angle").help("do"),
        ];
        let text = Diagnostics::new(source, list).render();
        assert_eq!(
            text,
            "error[unit.dimension]: wrong\n  --> a.toml:2:10\n  |\n2 |  yöung = \"30 deg\"\n  |          ^^^^^^^^ angle\n  = help: do\n"
        );
    }

    #[test]
    fn the_word_that_is_meant_comes_before_the_nearest_one() {
        let known = ["friction_law", "friction_angle"];
        assert_eq!(closest("friction", known).as_deref(), Some("friction_angle"));
        assert_eq!(closest("friction_lw", known).as_deref(), Some("friction_law"));
        assert_eq!(closest("jkn", known), None);
    }

    #[test]
    fn survives_odd_places() {
        let source = Source::new("a", "ä".repeat(100_000));
        for span in [
            0..0,
            1..2,
            Range { start: 99_999, end: 5 },
            usize::MAX - 1..usize::MAX,
            200_000..200_000,
        ] {
            let list = vec![Diagnostic::error("x", "y").at(span)];
            assert!(Diagnostics::new(source.clone(), list).render().len() < 1500);
        }
    }

    #[test]
    fn suggests_only_what_is_close() {
        let known = ["friction_angle", "cohesion", "density"];
        assert_eq!(closest("fricton_angle", known).as_deref(), Some("friction_angle"));
        assert_eq!(closest("friction", known).as_deref(), Some("friction_angle"));
        assert_eq!(closest("wall", known), None);
        assert_eq!(suggest("wall", ["a", "b"]).as_deref(), Some("valid names: `a`, `b`"));
    }
}
