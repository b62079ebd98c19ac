//! Why a command did not do what was asked, and the exit code that says so.

use crate::diagnostics::Note;

/// Exit code: the physics stopped the run, or a check failed.
pub const STOPPED: u8 = 1;
/// Exit code: bad input.
pub const BAD_INPUT: u8 = 2;
/// Exit code: results could not be written.
pub const NOT_WRITTEN: u8 = 3;
/// Exit code: stopped by Ctrl-C (128 + SIGINT, as shells expect).
pub const INTERRUPTED: u8 = 130;

/// Why a command ends without success.
#[derive(Debug)]
pub enum Failure {
    /// The physics stopped the run.
    Physics(String),
    /// Checks failed; they have been printed.
    Checks,
    /// Bad input, in one sentence.
    Input(String),
    /// Bad input, with places in files.
    Notes(Vec<Note>),
    /// Results could not be written.
    Output(String),
    /// Stopped by the user.
    Interrupted(String),
}

impl Failure {
    /// The exit code.
    pub fn code(&self) -> u8 {
        match self {
            Failure::Physics(_) | Failure::Checks => STOPPED,
            Failure::Input(_) | Failure::Notes(_) => BAD_INPUT,
            Failure::Output(_) => NOT_WRITTEN,
            Failure::Interrupted(_) => INTERRUPTED,
        }
    }

    /// What to print besides what has been printed already.
    pub fn notes(self) -> Vec<Note> {
        match self {
            Failure::Checks => Vec::new(),
            Failure::Notes(notes) => notes,
            Failure::Physics(text) | Failure::Input(text) | Failure::Output(text) => {
                vec![Note::error(text)]
            }
            Failure::Interrupted(text) => vec![Note::remark(text)],
        }
    }
}
