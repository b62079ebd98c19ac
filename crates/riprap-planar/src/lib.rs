//! The 2D engine: rigid polygons with mutual-potential contact.
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
//! use riprap_geom::Vec2;
//! use riprap_planar::setup::{
//!     BlockSpec, ContactLaw, FrictionLaw, Interface, Motion, NormalLaw, Reflex, Setup, Support,
//! };
//! use riprap_planar::step::{Damping, advance, evaluate};
//! use riprap_planar::view::View;
//! use riprap_planar::world::World;
//!
//! let block = |name: &str, low: [f64; 2], high: [f64; 2]| BlockSpec {
//!     name: name.into(),
//!     vertices: [low, [high[0], low[1]], high, [low[0], high[1]]].map(Vec2::from).to_vec(),
//!     material: 0,
//!     density: 2500.0,
//!     velocity: Vec2::ZERO,
//!     spin: 0.0,
//! };
//! let contact = ContactLaw {
//!     normal: NormalLaw::DistancePotential,
//!     reflex: Reflex::Min,
//!     normal_stiffness: 1e8,
//!     shear_stiffness: 1e8,
//!     friction: 0.6,
//!     cohesion: 0.0,
//!     friction_law: FrictionLaw::ShearSpring,
//!     clip_speed: 0.0,
//!     damping_ratio: 0.2,
//! };
//! let held = Motion::Fixed { x: true, y: true, rotation: true };
//! let setup = Setup {
//!     gravity: [0.0, -9.81],
//!     materials: vec!["rock".into()],
//!     blocks: vec![block("floor", [-2.0, -1.0], [2.0, 0.0]), block("brick", [-0.5, 0.04], [0.5, 0.54])],
//!     interfaces: vec![Interface { name: "default".into(), contact, bond: None }],
//!     pair_table: vec![0],
//!     supports: vec![Support { blocks: vec![0], motion: held }],
//!     ..Setup::default()
//! };
//! let (mut world, mut scratch) = World::new(setup, Exec::new(1)?);
//! let dt = 1e-4;
//! evaluate(&mut world, &mut scratch, &Damping::default(), dt)?;
//! while world.time < 1.0 {
//!     advance(&mut world, &mut scratch, dt);
//!     evaluate(&mut world, &mut scratch, &Damping::default(), dt)?;
//! }
//! let view = View { world: &world, scratch: &scratch };
//! assert!((view.displacement(1).y + 0.04).abs() < 1e-3);
//! assert!(view.velocity(1).length() < 1e-6);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

// What no other crate can name does not look as if it could be.
#![cfg_attr(not(test), warn(unreachable_pub))]
// Tests may compare with the functions of the platform.
#![cfg_attr(test, allow(clippy::disallowed_methods))]

pub mod addition;
pub mod bolts;
pub mod bond;
pub mod classify;
pub mod conditions;
mod contact;
mod convex;
pub mod density;
mod depths;
mod energy;
pub mod fields;
mod fragments;
mod handover;
mod hash;
mod heap;
mod initial_overlap;
mod loads;
pub mod picture;
mod pieces;
mod pins;
mod potential;
pub mod removal;
mod scratch;
mod search;
mod seepage;
pub mod setup;
pub mod shapes;
mod sound;
pub mod stable;
mod states;
pub mod step;
mod stress;
mod strips;
mod supports;
pub mod view;
mod water;
pub mod world;

pub use contact::change_laws;

use riprap_core::{accounts, dynamics, exec, failed, field, frame, laws, ledger, sums};
