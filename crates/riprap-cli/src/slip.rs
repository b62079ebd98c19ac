//! Words on the command line that are none of ours: what is said to them.

use clap::CommandFactory;
use clap::error::{ContextKind, ContextValue, Error, ErrorKind};
use riprap::record::field::nearest;

use crate::args::Cli;
use crate::diagnostics;
use crate::failure::BAD_INPUT;

/// What other programs call our verbs.
const ELSEWHERE: [(&str, &str); 21] = [
    ("solve", "run"),
    ("cycle", "run"),
    ("start", "run"),
    ("go", "run"),
    ("continue", "resume"),
    ("restart", "resume"),
    ("restore", "resume"),
    ("fos", "safety"),
    ("factor-of-safety", "safety"),
    ("init", "new"),
    ("create", "new"),
    ("template", "new"),
    ("templates", "new"),
    ("lint", "check"),
    ("validate", "check"),
    ("show", "view"),
    ("test", "verify"),
    ("diff", "compare"),
    ("export", "paraview"),
    ("info", "doctor"),
    ("describe", "explain"),
];

/// Prints what clap says, and for a verb that it knows nothing near of the one that was meant; ends the program.
pub fn exit(error: &Error) -> ! {
    let wrong = match error.get(ContextKind::InvalidSubcommand) {
        Some(ContextValue::String(word)) if error.kind() == ErrorKind::InvalidSubcommand => word,
        _ => error.exit(),
    };
    diagnostics::print_line("error", &unknown(wrong));
    std::process::exit(i32::from(BAD_INPUT));
}

/// What is said to a verb that does not exist.
fn unknown(word: &str) -> String {
    let command = Cli::command();
    let verbs: Vec<&str> = command
        .get_subcommands()
        .filter(|verb| !verb.is_hide_set())
        .map(clap::Command::get_name)
        .collect();
    let lower = word.to_lowercase();
    let meant = ELSEWHERE
        .iter()
        .find(|(theirs, _)| *theirs == lower)
        .map(|(_, ours)| *ours)
        .or_else(|| turned(&lower, &verbs))
        .or_else(|| nearest(&lower, verbs.iter().copied()));
    if word.ends_with(".toml") {
        return format!("{word:?} is not a command; to run a scene write: riprap run {word}");
    }
    match meant {
        Some(verb) => format!(
            "unknown command {word:?}; did you mean `riprap {verb}`? `riprap --help` lists all commands"
        ),
        None => format!("unknown command {word:?}; valid commands: {}", verbs.join(", ")),
    }
}

/// A verb of the same letters: `rnu`.
fn turned<'a>(word: &str, verbs: &[&'a str]) -> Option<&'a str> {
    let sorted = |text: &str| {
        let mut letters: Vec<char> = text.chars().collect();
        letters.sort_unstable();
        letters
    };
    verbs.iter().copied().find(|verb| sorted(verb) == sorted(word))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slips_and_words_of_other_programs_lead_to_a_verb() {
        for (word, verb) in [
            ("rnu", "run"),
            ("chekc", "check"),
            ("Solve", "run"),
            ("fos", "safety"),
            ("restart", "resume"),
            ("plots", "plot"),
        ] {
            let said = unknown(word);
            assert!(said.contains(&format!("`riprap {verb}`")), "{word}: {said}");
        }
        assert!(unknown("hill.toml").contains("riprap run hill.toml"));
        assert!(unknown("xyzzy").contains("bisect, safety"));
    }

    #[test]
    fn every_word_of_others_leads_to_a_verb_of_ours() {
        let command = Cli::command();
        for (theirs, ours) in ELSEWHERE {
            let there = |word: &str| command.get_subcommands().any(|v| v.get_name() == word);
            assert!(there(ours) && !there(theirs), "{theirs} -> {ours}");
        }
    }
}
