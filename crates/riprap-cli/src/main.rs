//! The `riprap` command: what the user typed goes to the library, what the library says goes to
//! the screen. No mechanics and no decisions about scenes live here.

#![allow(
    dead_code,
    reason = "the verbs that use the rest arrive with the engine"
)]

mod args;
mod commands;
mod diagnostics;
mod failure;
mod interrupt;
mod numbers;
mod progress;
mod scenes;
mod screen;
mod templates;

use std::process::ExitCode;

use clap::Parser;

use args::{Cli, Verb};
use failure::Failure;

fn main() -> ExitCode {
    let cli = Cli::parse();
    let style = diagnostics::Style::for_stderr(cli.color);
    match dispatch(cli.verb) {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            let code = failure.code();
            failure.print(style);
            ExitCode::from(code)
        }
    }
}

fn dispatch(verb: Verb) -> Result<(), Failure> {
    match verb {
        Verb::New(args) => commands::new::run(&args),
        Verb::Doctor(_) => commands::doctor::run(),
        Verb::Explain(args) => commands::language::explain(&args),
        Verb::Schema(args) => commands::language::schema(&args),
        Verb::Check(_)
        | Verb::Run(_)
        | Verb::Resume(_)
        | Verb::Sweep(_)
        | Verb::Bisect(_)
        | Verb::Compare(_)
        | Verb::ProbeContact(_)
        | Verb::Verify(_)
        | Verb::Plot(_)
        | Verb::Fields(_)
        | Verb::Hash(_) => Err(Failure::Input("this verb is not built in yet".to_owned())),
    }
}
