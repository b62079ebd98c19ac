//! Discrete-element simulation of blocky rock.
//!
//! `scenario` (what the user said) -> `model` (SI numbers) -> an engine (`planar`) driven by `run`,
//! recorded by `record`. `ARCHITECTURE.md` has the map and the arrows.
//!
//! A program begins with [`run::simulation::Simulation`]: made of a scene as text (`from_toml`) or of a [`setup::Setup`] and a
//! [`plan::Plan`] built by hand, advanced in batches (`advance`, `run_for`, `run`), asked by name (`field`). Runs with a folder,
//! checks and checkpoints are [`run::job`]. [`prelude`] brings what nearly every program needs. Features: `scenario` (the language, and all that runs scene files) and `plot`.
#![cfg_attr(
    not(feature = "scenario"),
    allow(dead_code, reason = "what only scenes and their forecasts ask for")
)]
// What no other crate can name does not look as if it could be.
#![cfg_attr(not(test), warn(unreachable_pub))]
// Tests may compare with the functions of the platform.
#![cfg_attr(test, allow(clippy::disallowed_methods))]

#[cfg(feature = "scenario")]
pub mod model;
pub mod plan;
pub mod prelude;
pub mod run;
pub mod setup;

pub use riprap_core::{
    accounts, dynamics, exec, lanes, laws, ledger, numbers, peers, profile, rhythm,
};
pub use riprap_geom as geom;
pub use riprap_geom::{Vec2, Vec3};
pub use riprap_planar as planar;
/// Figures of runs.
///
/// # Examples
///
/// ```
/// use std::path::Path;
///
/// use riprap::plot;
/// use riprap::record::folder::Existing;
/// use riprap::run::drive::Control;
/// use riprap::run::job;
/// use riprap::run::scene::Scene;
///
/// let path = Path::new("scenes/verify/planar/rest.toml");
/// # let path = &Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(path);
/// # let results = tempfile::tempdir()?;
/// # let results = results.path();
/// let scene = Scene::load(path, &[])?;
/// let job = scene.prepare(&scene.plain())?.job();
/// let folder = results.join("rest.run");
/// job::run(job, &folder, Existing::Refuse, 1, &mut |_| Control::Continue)?;
/// let written = plot::energy(&folder, &results.join("energy.svg"))?;
/// assert!(written.iter().all(|file| file.exists()));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[cfg(feature = "plot")]
pub use riprap_plot as plot;
pub use riprap_record as record;
#[cfg(feature = "scenario")]
pub use riprap_scenario as scenario;
pub use riprap_spatial as spatial;
