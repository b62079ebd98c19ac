//! `riprap paraview`.

use riprap::plot::paraview::{self, View};

use super::run_folder;
use crate::args::Paraview;
use crate::failure::Failure;
use crate::screen;

pub fn run(args: &Paraview) -> Result<(), Failure> {
    run_folder(&args.run, "paraview")?;
    let view = View { by: &args.by, exaggeration: args.exaggerate };
    let path = paraview::write(&args.run, view)?;
    screen::line(&path.display().to_string());
    Ok(())
}
