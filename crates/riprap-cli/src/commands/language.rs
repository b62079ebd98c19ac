//! `riprap explain` and `riprap schema`: what the language says of itself.

use std::path::Path;

use riprap::scenario;

use crate::args::{Explain, Schema};
use crate::failure::Failure;
use crate::{scenes, screen};

/// `riprap schema`.
pub fn schema(args: &Schema) -> Result<(), Failure> {
    let text = if args.markdown {
        scenario::markdown()
    } else {
        scenario::schema_text()
    };
    screen::line(text.trim_end());
    Ok(())
}

/// `riprap explain`.
pub fn explain(args: &Explain) -> Result<(), Failure> {
    let path = Path::new(&args.what);
    // A key never contains these; a file that does not exist deserves a message about files.
    let names_a_file = path.exists() || args.what.contains('/') || args.what.ends_with(".toml");
    if !names_a_file {
        screen::line(
            scenario::explain_key(&args.what)
                .map_err(Failure::Input)?
                .trim_end(),
        );
        return Ok(());
    }
    let parsed = scenes::load_changed(path, &args.change)?;
    screen::print(&parsed.source.text);
    Ok(())
}
