//! Discrete-element simulation of blocky rock.
//!
//! `scenario` (what the user said) -> `model` (SI numbers) -> an engine (`planar`) driven by `run`,
//! recorded by `record`. `ARCHITECTURE.md` has the map and the arrows.
//!
//! A program begins with [`run::simulation::Simulation`]: made of a scene as text (`from_toml`) or of a [`setup::Setup`] and a
//! [`plan::Plan`] built by hand, advanced in batches (`advance`, `run_for`, `run`), asked by name (`field`). Runs with a folder,
//! checks and checkpoints are [`run::job`]. [`prelude`] brings what nearly every program needs. Features: `scenario` (the language, and all that runs scene files) and `plot`.

// Tests may compare with the functions of the platform.
#![cfg_attr(test, allow(clippy::disallowed_methods))]

#[cfg(feature = "scenario")]
pub mod model;
pub mod plan;
pub mod prelude;
pub mod run;
pub mod setup;

pub use riprap_core::{accounts, dynamics, exec, lanes, laws, ledger, profile, rhythm};
pub use riprap_geom as geom;
pub use riprap_geom::{Vec2, Vec3};
pub use riprap_planar as planar;
#[cfg(feature = "plot")]
pub use riprap_plot as plot;
pub use riprap_record as record;
#[cfg(feature = "scenario")]
pub use riprap_scenario as scenario;
pub use riprap_spatial as spatial;
