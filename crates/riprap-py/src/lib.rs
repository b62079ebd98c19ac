//! `riprap._riprap`: scenes in, arrays out. What users see is written in Python, in `python/riprap`.
//!
//! Nothing here computes. Long calls let go of the interpreter and come back about ten times a second for
//! signals and callbacks; errors become the exceptions of `riprap.errors`.

mod arrays;
mod document;
mod errors;
mod law;
mod live;
mod look;
mod plots;
mod results;
mod runs;
mod safety;
mod scene;
mod shapes;
mod sweeps;
mod trust;

use pyo3::prelude::*;

/// The compiled half of the package `riprap`.
#[pymodule]
mod _riprap {
    #[pymodule_export]
    use crate::arrays::{read_frame, read_table};
    #[pymodule_export]
    use crate::document::{to_toml, to_value, with_table};
    #[pymodule_export]
    use crate::live::Simulation;
    #[pymodule_export]
    use crate::look::Progress;
    #[pymodule_export]
    use crate::plots::{plot, shot};
    #[pymodule_export]
    use crate::results::{muckpile, removable, runout, strength};
    #[pymodule_export]
    use crate::runs::{resume, run};
    #[pymodule_export]
    use crate::safety::safety;
    #[pymodule_export]
    use crate::scene::{Scene, explain, fields, free_folder, schema, si, version};
    #[pymodule_export]
    use crate::shapes::{read_dxf, read_stl, read_tess};
    #[pymodule_export]
    use crate::sweeps::{merged, sweep};
    #[pymodule_export]
    use crate::trust::{find, trust};
}
