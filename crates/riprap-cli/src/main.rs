//! The `riprap` command: what the user typed goes to the library, what the library says goes to
//! the screen. No mechanics and no decisions about scenes live here.

mod args;
mod commands;
mod concepts;
mod diagnostics;
mod failure;
mod interrupt;
mod numbers;
mod progress;
mod scenes;
mod screen;
mod slip;
mod templates;

use std::process::ExitCode;

use clap::Parser;

use args::{Cli, Verb};
use diagnostics::Style;
use failure::Failure;

fn main() -> ExitCode {
    interrupt::let_full_files_be_errors();
    let cli = Cli::try_parse().unwrap_or_else(|error| slip::exit(&error));
    let style = Style::for_stderr(cli.color);
    match dispatch(cli.verb, style) {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            let code = failure.code();
            failure.print(style);
            ExitCode::from(code)
        }
    }
}

fn dispatch(verb: Verb, style: Style) -> Result<(), Failure> {
    match verb {
        Verb::New(args) => commands::new::run(&args),
        Verb::Check(args) => commands::check::run(&args, style),
        Verb::Run(args) => commands::run::run(&args, style),
        Verb::Resume(args) => commands::run::resume(&args),
        Verb::Sweep(args) => commands::sweep::sweep(&args.cases),
        Verb::MonteCarlo(args) => commands::sweep::monte_carlo(&args.cases),
        Verb::Bisect(args) => commands::trials::bisect(&args),
        Verb::Safety(args) => commands::safety::run(&args, style),
        Verb::Trust(args) => commands::trust::run(&args, style),
        Verb::Removable(args) => commands::removable::run(&args, style),
        Verb::Sizes(args) => commands::sizes::run(&args, style),
        Verb::Runout(args) => commands::runout::run(&args),
        Verb::Muckpile(args) => commands::muckpile::run(&args),
        Verb::Strength(args) => commands::strength::run(&args),
        Verb::Compare(args) => commands::trials::compare(&args),
        Verb::ProbeContact(args) => commands::probe::run(&args, style),
        Verb::Verify(args) => commands::verify::run(&args),
        Verb::Plot(args) => commands::plot::run(&args),
        Verb::Shot(args) => commands::shot::run(&args),
        Verb::View(args) => commands::view::run(&args, style),
        Verb::Report(args) => commands::report::run(&args),
        Verb::Paraview(args) => commands::paraview::run(&args),
        Verb::Fields(args) => commands::language::fields(&args),
        Verb::Explain(args) => commands::language::explain(&args, style),
        Verb::Schema(args) => commands::language::schema(&args),
        Verb::Hash(args) => commands::language::hash(&args, style),
        Verb::Doctor(_) => commands::doctor::run(),
        Verb::SelfTest(_) => commands::self_test::run(),
        Verb::Completions(args) => {
            commands::shell::completions(&args);
            Ok(())
        }
        Verb::Man(args) => commands::shell::man(&args),
    }
}
