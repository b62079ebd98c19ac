//! Verbs that set up a shell.

use std::path::PathBuf;

use clap::Args;
use clap_complete::Shell;

/// Print the completion script for a shell.
///
/// With it the tab key completes commands, options and files.
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  riprap completions bash > ~/.local/share/bash-completion/completions/riprap
  riprap completions zsh > ~/.zfunc/_riprap          with fpath+=~/.zfunc before compinit
  riprap completions fish > ~/.config/fish/completions/riprap.fish")]
pub struct Completions {
    /// Shell to complete for
    #[arg(value_name = "SHELL", value_enum)]
    pub shell: Shell,
}

/// Print the manual page, or write the pages of all commands.
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  riprap man | man -l -
  riprap man --out ~/.local/share/man/man1          then: man riprap-run")]
pub struct Man {
    /// Folder to write riprap.1, riprap-run.1, ... into
    #[arg(short, long, value_name = "FOLDER")]
    pub out: Option<PathBuf>,
}
