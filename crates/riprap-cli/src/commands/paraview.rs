//! `riprap paraview`.

use riprap::plot::paraview::{self, View};

use crate::args::Paraview;
use crate::failure::Failure;
use crate::screen;

pub fn run(args: &Paraview) -> Result<(), Failure> {
    let view = View {
        by: &args.by,
        exaggeration: args.exaggerate,
    };
    let path = paraview::write(&args.run, view)?;
    screen::line(&path.display().to_string());
    Ok(())
}
