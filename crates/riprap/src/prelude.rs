//! What nearly every program that runs a model needs: `use riprap::prelude::*`.
//!
//! A model built by hand takes its parts from [`crate::planar::setup`] or [`crate::spatial::setup`] besides.
//!
//! ```
//! use riprap::prelude::*;
//!
//! let text = r#"
//! riprap = 1
//! title = "a stone falls"
//! space.planar.gravity = ["0 m/s2", "-10 m/s2"]
//! materials.rock.density = "2500 kg/m3"
//! interfaces.default = { friction_angle = "30 deg", normal_stiffness = "1 GPa/m" }
//! [[blocks]]
//! name = "stone"
//! material = "rock"
//! rectangle = { size = ["1 m", "1 m"], centre = ["0 m", "9 m"] }
//! [[phases]]
//! name = "fall"
//! time_step = "1 ms"
//! until.time = "1 s"
//! "#;
//! let mut fall = Simulation::from_toml(text)?;
//! fall.run_for(0.5)?;
//! assert!((fall.time() - 0.5).abs() < 1e-9);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub use crate::exec::{Exec, side_by_side};
pub use crate::plan::{Phase, Plan, TimeStep};
pub use crate::run::engine::NewBlock;
#[cfg(feature = "scenario")]
pub use crate::run::scene::Scene;
pub use crate::run::simulation::{ContactLaw, Contacts, Reached, Simulation};
pub use crate::setup::Setup;
pub use crate::{Vec2, Vec3};
