//! `riprap view`.

use std::path::Path;

use riprap_view::{Server, ServerError};

use crate::args::View;
use crate::diagnostics;
use crate::failure::Failure;
use crate::screen;

pub fn run(args: &View) -> Result<(), Failure> {
    let runs: Vec<_> = [Some(&args.run), args.other.as_ref()]
        .into_iter()
        .flatten()
        .cloned()
        .collect();
    for run in &runs {
        exists(run)?;
    }
    let server = Server::bind(&runs, args.port)?;
    let url = server.url();
    screen::line(&format!("{url}  (Ctrl-C ends it)"));
    if !args.no_open && open::that_detached(&url).is_err() {
        diagnostics::print_line("note", "no browser was found; open the address by hand");
    }
    Ok(server.run()?)
}

/// A folder that is broken is told about on the page; one that does not exist is a slip of the pen.
fn exists(run: &Path) -> Result<(), Failure> {
    if run.is_dir() {
        return Ok(());
    }
    let what = if run.exists() {
        "is a file, not a run folder"
    } else {
        "does not exist"
    };
    Err(Failure::Input(format!(
        "{} {what}; name what `riprap run` wrote, for example: riprap view hill.run",
        run.display()
    )))
}

impl From<ServerError> for Failure {
    fn from(error: ServerError) -> Self {
        match error {
            ServerError::Listen { .. } => Failure::Input(format!("{error} (--port)")),
            ServerError::Serve(_) => Failure::Output(error.to_string()),
        }
    }
}
