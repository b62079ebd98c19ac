//! `riprap completions` and `riprap man`.

use std::path::Path;

use clap::CommandFactory;

use crate::args::{Cli, Completions, Man};
use crate::failure::Failure;
use crate::screen;

/// `riprap completions`.
pub fn completions(args: &Completions) {
    let mut text = Vec::new();
    clap_complete::generate(args.shell, &mut Cli::command(), "riprap", &mut text);
    screen::print(&String::from_utf8_lossy(&text));
}

/// `riprap man`.
pub fn man(args: &Man) -> Result<(), Failure> {
    let mut all = Cli::command();
    // So that the pages of verbs know their whole names.
    all.build();
    let Some(folder) = &args.out else {
        screen::print(&page(&all)?);
        return Ok(());
    };
    std::fs::create_dir_all(folder).map_err(|e| unwritten(folder, &e))?;
    let verbs = all.get_subcommands().filter(|verb| !verb.is_hide_set());
    for command in std::iter::once(&all).chain(verbs) {
        let name = match command.get_name() {
            "riprap" => "riprap.1".to_owned(),
            verb => format!("riprap-{verb}.1"),
        };
        let path = folder.join(name);
        std::fs::write(&path, page(command)?).map_err(|e| unwritten(&path, &e))?;
        screen::line(&path.display().to_string());
    }
    Ok(())
}

fn page(command: &clap::Command) -> Result<String, Failure> {
    let mut text = Vec::new();
    clap_mangen::Man::new(command.clone())
        .render(&mut text)
        .map_err(|e| Failure::Output(format!("could not write the manual page: {e}")))?;
    Ok(String::from_utf8_lossy(&text).into_owned())
}

fn unwritten(path: &Path, error: &std::io::Error) -> Failure {
    Failure::Output(format!("could not write {}: {error}", path.display()))
}
