//! Messages with a place in a file: drawn by miette on a terminal, as plain lines elsewhere.
//!
//! The plain form begins like a compiler message, so that editors and log readers find
//! `file:line:column`.

use std::fmt::Write as _;
use std::io::IsTerminal;

use miette::{
    GraphicalReportHandler, GraphicalTheme, LabeledSpan, MietteDiagnostic, NamedSource, Report,
};

use crate::args::ColorChoice;

/// How serious a note is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Severity {
    Error,
    Warning,
    Remark,
}

/// A part of a text: its file, the whole text and the bytes meant.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Place {
    /// File as the user named it.
    pub file: String,
    /// All of its text.
    pub text: String,
    /// First byte.
    pub start: usize,
    /// Number of bytes.
    pub length: usize,
    /// What is said right at the place; may be empty.
    pub label: String,
}

/// One message to the user.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Note {
    pub severity: Severity,
    /// Short name of the rule, such as `units::dimension`; may be empty.
    pub code: String,
    pub message: String,
    pub place: Option<Place>,
    pub help: Option<String>,
}

impl Note {
    /// An error without a place.
    pub fn error(message: String) -> Self {
        let severity = Severity::Error;
        Note {
            severity,
            code: String::new(),
            message,
            place: None,
            help: None,
        }
    }

    /// A remark without a place.
    pub fn remark(message: String) -> Self {
        Note {
            severity: Severity::Remark,
            ..Note::error(message)
        }
    }
}

/// How notes are printed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Style {
    /// Drawn, with colours.
    Coloured,
    /// Drawn, without colours.
    Drawn,
    /// Plain lines.
    Plain,
}

impl Style {
    /// The style for stderr.
    pub fn for_stderr(choice: ColorChoice) -> Self {
        let terminal = std::io::stderr().is_terminal();
        let no_color = std::env::var_os("NO_COLOR").is_some_and(|v| !v.is_empty());
        match (choice, terminal) {
            (ColorChoice::Always, _) => Style::Coloured,
            (ColorChoice::Auto, true) if !no_color => Style::Coloured,
            (ColorChoice::Auto | ColorChoice::Never, true) => Style::Drawn,
            (ColorChoice::Auto | ColorChoice::Never, false) => Style::Plain,
        }
    }
}

/// Prints `notes` to stderr.
pub fn print(notes: &[Note], style: Style) {
    for note in notes {
        eprintln!("{}", rendered(note, style).trim_end());
    }
}

/// One note as text.
pub fn rendered(note: &Note, style: Style) -> String {
    let theme = match style {
        Style::Coloured => GraphicalTheme::unicode(),
        Style::Drawn => GraphicalTheme::unicode_nocolor(),
        Style::Plain => return plain(note),
    };
    let mut text = String::new();
    let handler = GraphicalReportHandler::new_themed(theme);
    match handler.render_report(&mut text, report(note).as_ref()) {
        Ok(()) => text,
        Err(std::fmt::Error) => plain(note),
    }
}

fn report(note: &Note) -> Report {
    let severity = match note.severity {
        Severity::Error => miette::Severity::Error,
        Severity::Warning => miette::Severity::Warning,
        Severity::Remark => miette::Severity::Advice,
    };
    let mut diagnostic = MietteDiagnostic::new(note.message.clone()).with_severity(severity);
    if !note.code.is_empty() {
        diagnostic = diagnostic.with_code(note.code.clone());
    }
    if let Some(help) = &note.help {
        diagnostic = diagnostic.with_help(help.clone());
    }
    let Some(place) = &note.place else {
        return Report::new(diagnostic);
    };
    let label = if place.label.is_empty() {
        None
    } else {
        Some(place.label.clone())
    };
    diagnostic = diagnostic.with_label(LabeledSpan::new(label, place.start, place.length));
    Report::new(diagnostic).with_source_code(NamedSource::new(&place.file, place.text.clone()))
}

/// Line and column (from 1, columns in characters) of byte `at`.
pub fn line_column(text: &str, at: usize) -> (usize, usize) {
    let mut at = at.min(text.len());
    while !text.is_char_boundary(at) {
        at -= 1;
    }
    let before = &text[..at];
    let line_start = before.rfind('\n').map_or(0, |p| p + 1);
    (
        before.matches('\n').count() + 1,
        before[line_start..].chars().count() + 1,
    )
}

fn plain(note: &Note) -> String {
    let word = match note.severity {
        Severity::Error => "error",
        Severity::Warning => "warning",
        Severity::Remark => "note",
    };
    let mut out = String::new();
    let code = if note.code.is_empty() {
        String::new()
    } else {
        format!(" [{}]", note.code)
    };
    // Writing to a String cannot fail.
    let _ = writeln!(out, "{word}: {}{code}", note.message);
    if let Some(place) = &note.place {
        let (line, column) = line_column(&place.text, place.start);
        let _ = writeln!(out, "  --> {}:{line}:{column}", place.file);
        if let Some(source) = place.text.lines().nth(line - 1) {
            // Very long lines (rubbish, minified data) would drown the message.
            let shown: String = source.chars().take(160).collect();
            let number = line.to_string();
            let room = shown.chars().count().saturating_sub(column - 1).max(1);
            let length = place.text.get(place.start..place.start + place.length);
            let length = length.map_or(1, |t| t.lines().next().unwrap_or("").chars().count());
            let marks = "^".repeat(length.clamp(1, room));
            let _ = writeln!(out, " {number} | {shown}");
            if column <= 160 {
                let before: String = shown
                    .chars()
                    .take(column - 1)
                    .map(|c| if c == '\t' { c } else { ' ' })
                    .collect();
                let gap = " ".repeat(number.len());
                let _ = writeln!(out, " {gap} | {before}{marks} {}", place.label);
            }
        }
    }
    if let Some(help) = &note.help {
        let _ = writeln!(out, "  help: {help}");
    }
    out.lines().map(|l| format!("{}\n", l.trim_end())).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn note() -> Note {
        let text = "[materials.rock]\ndensity = \"30 deg\"\n".to_owned();
        let start = text.find("\"30").unwrap();
        let label = "an angle".to_owned();
        let place = Place {
            file: "slope.toml".to_owned(),
            text,
            start,
            length: 8,
            label,
        };
        Note {
            severity: Severity::Error,
            code: "units::dimension".to_owned(),
            message: "this is an angle, a density is expected".to_owned(),
            place: Some(place),
            help: Some("write for example \"2600 kg/m3\"".to_owned()),
        }
    }

    #[test]
    fn plain_notes_read_like_a_compiler() {
        let expected = "\
error: this is an angle, a density is expected [units::dimension]
  --> slope.toml:2:11
 2 | density = \"30 deg\"
   |           ^^^^^^^^ an angle
  help: write for example \"2600 kg/m3\"
";
        assert_eq!(rendered(&note(), Style::Plain), expected);
    }

    #[test]
    fn drawn_notes_show_the_source_without_colours() {
        let text = rendered(&note(), Style::Drawn);
        assert!(
            text.contains("slope.toml:2:11") && text.contains("an angle"),
            "{text}"
        );
        assert!(!text.contains('\u{1b}'), "{text:?}");
        assert!(rendered(&note(), Style::Coloured).contains('\u{1b}'));
    }

    #[test]
    fn strange_places_do_no_harm() {
        for (text, start, length) in [("", 0, 0), ("é\n", 1, 5), ("abc", 3, 9), ("a\n", 2, 0)] {
            let place = Place {
                file: "x".to_owned(),
                text: text.to_owned(),
                start,
                length,
                label: String::new(),
            };
            let odd = Note {
                place: Some(place),
                ..note()
            };
            for style in [Style::Plain, Style::Drawn] {
                assert!(rendered(&odd, style).contains("this is an angle"));
            }
        }
    }
}
