//! Messages to the user: with a place in a file, drawn by miette on a terminal and as plain lines
//! elsewhere (the library's own form, which begins like a compiler message).

use std::io::{IsTerminal, Write};

use miette::{
    GraphicalReportHandler, GraphicalTheme, LabeledSpan, MietteDiagnostic, NamedSource, Report,
};
use riprap::scenario::{Diagnostic, Diagnostics, Severity};

use crate::args::ColorChoice;
use crate::numbers::counted;

/// Longest line that is drawn; longer ones (rubbish, data) would flood the screen.
const LONGEST_DRAWN_LINE: usize = 200;

/// How messages are printed.
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

/// Prints one line without a place to stderr: `error: …`.
pub fn print_line(word: &str, text: &str) {
    say(&format!("{word}: {text}"));
}

/// One line to stderr. Nobody can be told that it cannot be written; a reader that has gone must not stop a run.
pub fn say(line: &str) {
    let _ = writeln!(std::io::stderr(), "{line}");
}

/// Most errors, or warnings where there are no errors, that are printed one by one.
const MOST: usize = 20;

/// Prints `diagnostics` to stderr, and how many there are when there are several.
pub fn print(diagnostics: &Diagnostics, style: Style) {
    let (first, left) = first_of(diagnostics);
    say(rendered(&first, style).trim_end());
    let (errors, warnings) = (diagnostics.errors(), diagnostics.warnings());
    if errors + warnings > 1 {
        let rest = match left {
            0 => String::new(),
            n => format!("; {n} of them not shown"),
        };
        say(&format!("\n{}: {}{rest}", diagnostics.source.name, tally(errors, warnings)));
    }
}

/// The first remarks, errors before warnings, in the order of the text, and how many are left out: a fault in the making of
/// thousands of blocks must not bury the line that says what is wrong.
fn first_of(all: &Diagnostics) -> (Diagnostics, usize) {
    if all.list.len() <= MOST {
        return (all.clone(), 0);
    }
    let is_error = |d: &&Diagnostic| d.severity == Severity::Error;
    let errors = all.list.iter().filter(is_error);
    let others = all.list.iter().filter(|d| !is_error(d));
    let first = errors.chain(others).take(MOST).cloned().collect();
    let first = Diagnostics::new(all.source.clone(), first);
    (first, all.list.len() - MOST)
}

/// `2 errors, 1 warning`.
fn tally(errors: usize, warnings: usize) -> String {
    match (errors, warnings) {
        (e, 0) => counted(e, "error"),
        (0, w) => counted(w, "warning"),
        (e, w) => format!("{}, {}", counted(e, "error"), counted(w, "warning")),
    }
}

/// All messages as text.
pub fn rendered(diagnostics: &Diagnostics, style: Style) -> String {
    let text = &diagnostics.source.text;
    let strange = |line: &str| {
        line.len() > LONGEST_DRAWN_LINE || line.chars().any(|c| c.is_control() && c != '\t')
    };
    let theme = match style {
        Style::Coloured => GraphicalTheme::unicode(),
        Style::Drawn => GraphicalTheme::unicode_nocolor(),
        Style::Plain => return diagnostics.render(),
    };
    if text.lines().any(strange) {
        return diagnostics.render();
    }
    let handler = GraphicalReportHandler::new_themed(theme);
    let mut out = String::new();
    for diagnostic in &diagnostics.list {
        if !out.is_empty() {
            out.push('\n');
        }
        let report = report(diagnostic, diagnostics);
        if handler.render_report(&mut out, report.as_ref()).is_err() {
            return diagnostics.render();
        }
    }
    out
}

fn report(diagnostic: &Diagnostic, all: &Diagnostics) -> Report {
    let severity = match diagnostic.severity {
        Severity::Error => miette::Severity::Error,
        Severity::Warning => miette::Severity::Warning,
    };
    let mut report = MietteDiagnostic::new(diagnostic.message.clone())
        .with_code(diagnostic.code)
        .with_severity(severity);
    if let Some(help) = &diagnostic.help {
        report = report.with_help(help.clone());
    }
    let Some(span) = &diagnostic.span else {
        report.message = format!("{}: {}", all.source.name, report.message);
        return Report::new(report);
    };
    let length = all.source.text.len();
    let start = span.start.min(length);
    let end = span.end.clamp(start, length);
    report = report.with_label(LabeledSpan::new(diagnostic.label.clone(), start, end - start));
    Report::new(report)
        .with_source_code(NamedSource::new(&all.source.name, all.source.text.clone()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use riprap::scenario::Source;

    fn dimension_error() -> Diagnostics {
        let source = Source::new("slope.toml", "[materials.rock]\ndensity = \"30 deg\"\n");
        let diagnostic = Diagnostic::error("unit.dimension", "a density is expected")
            .at(27..35)
            .label("an angle")
            .help("write for example \"2600 kg/m3\"");
        Diagnostics::new(source, vec![diagnostic])
    }

    #[test]
    fn drawn_messages_show_the_source_without_colours() {
        let text = rendered(&dimension_error(), Style::Drawn);
        assert!(text.contains("slope.toml:2:11") && text.contains("an angle"), "{text}");
        assert!(!text.contains('\u{1b}'), "{text:?}");
        assert!(rendered(&dimension_error(), Style::Coloured).contains('\u{1b}'));
    }

    #[test]
    fn plain_messages_begin_like_a_compiler() {
        let text = rendered(&dimension_error(), Style::Plain);
        assert!(text.starts_with("error[unit.dimension]: a density is expected"), "{text}");
        assert!(text.contains("--> slope.toml:2:11"), "{text}");
    }

    #[test]
    fn strange_texts_and_places_do_no_harm() {
        let texts = ["", "é\n", "abc", "a\n", "\u{7}bell", &"x".repeat(100_000)];
        for text in texts {
            for (start, end) in [(0, 0), (1, 2), (2, 1), (3, 900)] {
                let source = Source::new("x", text);
                let list = vec![Diagnostic::error("a", "wrong here").at(start..end)];
                let odd = Diagnostics::new(source, list);
                for style in [Style::Plain, Style::Drawn] {
                    let shown = rendered(&odd, style);
                    assert!(shown.contains("wrong here") && shown.len() < 2000, "{shown}");
                }
            }
        }
    }

    #[test]
    fn of_many_remarks_the_first_errors_are_shown() {
        let source = Source::new("x", "a".repeat(100));
        let remark = |at: usize| match at {
            0..50 => Diagnostic::warning("w", "a warning").at(at..at + 1),
            _ => Diagnostic::error("e", "an error").at(at..at + 1),
        };
        let few = Diagnostics::new(source.clone(), (40..60).map(remark).collect());
        assert_eq!(first_of(&few), (few.clone(), 0));
        let many = Diagnostics::new(source, (0..60).map(remark).collect());
        let (first, left) = first_of(&many);
        assert_eq!((first.errors(), first.warnings(), left), (10, 10, 40));
        assert_eq!(first.list[0], many.list[0]);
    }

    #[test]
    fn counts_are_in_words() {
        assert_eq!(tally(1, 0), "1 error");
        assert_eq!(tally(2, 1), "2 errors, 1 warning");
        assert_eq!(tally(0, 3), "3 warnings");
    }
}
