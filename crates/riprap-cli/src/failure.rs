//! Why a command did not do what was asked, and the exit code that says so.

use riprap::run::given_step::RefusedStep;
use riprap::run::job::JobError;
use riprap::scenario::{Diagnostics, Parsed};

use crate::diagnostics::{self, Style};

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
    /// Bad input, with places in a file.
    Scene(Diagnostics),
    /// Results could not be written.
    Output(String),
    /// The ranks of a run could not go on together.
    Ranks(String),
    /// Stopped by the user.
    Interrupted(String),
}

impl Failure {
    /// The exit code.
    pub fn code(&self) -> u8 {
        match self {
            Failure::Physics(_) | Failure::Ranks(_) | Failure::Checks => STOPPED,
            Failure::Input(_) | Failure::Scene(_) => BAD_INPUT,
            Failure::Output(_) => NOT_WRITTEN,
            Failure::Interrupted(_) => INTERRUPTED,
        }
    }

    /// A step that cannot be made, at its place in the scene.
    pub fn step(error: &RefusedStep, scene: &Parsed) -> Self {
        Failure::Scene(error.at(scene))
    }

    /// A run that could not be carried out, at its place in the scene where it has one.
    pub fn of_job(error: JobError, scene: &Parsed) -> Self {
        match &error {
            JobError::Step(step) => Failure::step(step, scene),
            _ => error.into(),
        }
    }

    /// Says on stderr what has not been said yet.
    pub fn print(&self, style: Style) {
        match self {
            Failure::Checks => {}
            Failure::Scene(all) => diagnostics::print(all, style),
            Failure::Physics(text)
            | Failure::Input(text)
            | Failure::Output(text)
            | Failure::Ranks(text) => {
                diagnostics::print_line("error", text);
            }
            Failure::Interrupted(text) => diagnostics::print_line("stopped", text),
        }
    }
}

impl std::fmt::Display for Failure {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Failure::Checks => f.write_str("checks failed"),
            Failure::Scene(all) => f.write_str(&all.render()),
            Failure::Physics(text)
            | Failure::Input(text)
            | Failure::Output(text)
            | Failure::Ranks(text)
            | Failure::Interrupted(text) => f.write_str(text),
        }
    }
}

impl From<Diagnostics> for Failure {
    fn from(all: Diagnostics) -> Self {
        Failure::Scene(all)
    }
}

impl From<JobError> for Failure {
    fn from(error: JobError) -> Self {
        let text = match &error {
            JobError::Folder(_) if !error.is_output() => format!("{error} (--out, --force)"),
            _ => error.to_string(),
        };
        if error.is_output() {
            Failure::Output(text)
        } else if error.ranks().is_some() {
            Failure::Ranks(text)
        } else {
            Failure::Input(text)
        }
    }
}
