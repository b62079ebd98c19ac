//! The 3D engine: rigid and deformable blocks joined along faces or meeting anew, boundaries, gas cavities, splitting and cutting.
//!
//! [`World::new`](world::World::new) builds a model from a [`Setup`](setup::Setup); [`step::evaluate`] finds forces at the present
//! positions, [`step::advance`] moves, and [`View`](view::View) reads what is there between the two.
//!
//! # Examples
//!
//! A brick that falls 4 cm onto a floor and rests.
//!
//! ```
//! use riprap_core::exec::Exec;
//! use riprap_geom::Vec3;
//! use riprap_spatial::setup::{
//!     BlockName, BlockSpec, InterfaceLaw, JointLaw, Material, Motion, Setup, Shape, Stiffness, Strength, Support,
//! };
//! use riprap_spatial::step::{Damping, advance, evaluate};
//! use riprap_spatial::view::View;
//! use riprap_spatial::world::World;
//!
//! let brick = |number, centre: [f64; 3], half: [f64; 3]| BlockSpec {
//!     name: BlockName { base: 0, number },
//!     shape: Shape::Brick { centre: centre.into(), half: half.into() },
//!     material: 0,
//!     velocity: Vec3::ZERO,
//!     spin: Vec3::ZERO,
//! };
//! let joint = JointLaw {
//!     stiffness: Stiffness::Given { normal: 1e8, shear: 1e8 },
//!     strength: Some(Strength { friction: 0.6, residual_friction: 0.6, ..Strength::default() }),
//!     damping: 0.2,
//!     contact_damping: 0.2,
//!     ..JointLaw::default()
//! };
//! let held = Motion::Fixed { translation: [true; 3], rotation: [true; 3] };
//! let setup = Setup {
//!     gravity: Vec3::new(0.0, 0.0, -9.81),
//!     materials: vec![Material { name: "rock".into(), density: 2500.0, young: None, poisson: None }],
//!     names: vec!["rock".into()],
//!     blocks: vec![brick(1, [0.0, 0.0, -0.5], [2.0, 2.0, 0.5]), brick(2, [0.0, 0.0, 0.29], [0.5, 0.5, 0.25])],
//!     interfaces: vec![InterfaceLaw { name: "default".into(), joint, bond: None, friction: None }],
//!     pair_table: vec![0],
//!     supports: vec![Support { blocks: vec![0], motion: held }],
//!     found_contacts: true,
//!     ..Setup::default()
//! };
//! let (mut world, mut scratch) = World::new(setup, Exec::new(1)?)?;
//! let dt = 1e-4;
//! evaluate(&mut world, &mut scratch, &Damping::default(), dt)?;
//! while world.time < 1.0 {
//!     advance(&mut world, &mut scratch, dt);
//!     evaluate(&mut world, &mut scratch, &Damping::default(), dt)?;
//! }
//! let view = View { world: &world, scratch: &scratch };
//! assert!((view.displacement(1).z + 0.04).abs() < 1e-3);
//! assert!(view.velocity(1).length() < 1e-6);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

// What no other crate can name does not look as if it could be.
#![cfg_attr(not(test), warn(unreachable_pub))]
// Tests may compare with the functions of the platform.
#![cfg_attr(test, allow(clippy::disallowed_methods))]

// Rooms by floors, lowest first (`floors.txt`, kept by `cargo xtask test modules`): a room names only rooms before it.
// Private ones are known outside by what is named below.
pub mod setup;

mod broad;
mod implicit;
mod kernel;

mod faces;
mod joint;
mod push;
mod state;

mod contact;
pub mod deform;
mod query;
mod rigid;
pub mod stable;
pub mod step;

pub mod topology;

pub mod build;
pub mod read;

pub use contact::{Meeting, change_laws, meeting, step_limit};
pub use faces::{divisible, region};
pub use kernel::limits;
pub use kernel::shape::{Body, Shape, turn};
pub use kernel::sums::Sums;
pub use kernel::surface::{Found, Pair, Walker};
pub use push::{bolts, charge};
pub use query::view;
pub use read::fields;
pub use rigid::implicit::choose as choose_integration;
pub use rigid::implicit::obstacle::{Obstacle, obstacle};
pub use rigid::implicit::settling::{settling_step, settling_way};
pub use riprap_core::lanes;
use riprap_core::{accounts, dynamics, exec, failed, field, flow, frame, laws, ledger, profile};
pub use state::contact_scratch::{Deepest, Pressed};
pub use state::scratch::NotSolved;
pub use state::share::apart::settle;
pub use state::share::{Part, parts};
pub use state::{sums, tiles, world};
