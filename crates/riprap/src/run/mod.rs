//! Simulation loop: phases, schedule, stop criteria, checks; many runs of one scene ([`study`]).

/// The same of either engine: `either!(self, v => v.time())`, of another enum than that of the method `either!(setup: Setup, s => ...)`.
macro_rules! either {
    ($of:ident, $it:ident => $all:expr) => {
        either!($of: Self, $it => $all)
    };
    ($of:ident: $kind:ident, $it:ident => $all:expr) => {
        match $of {
            $kind::Planar($it) => $all,
            $kind::Spatial($it) => $all,
        }
    };
}

pub mod ask;
#[cfg(feature = "scenario")]
mod change;
pub mod checks;
pub mod cpu;
pub mod drive;
pub mod engine;
#[cfg(feature = "scenario")]
pub mod forecast;
pub mod given_step;
pub mod job;
pub mod meeting;
#[cfg(feature = "scenario")]
pub mod muckpile;
pub mod origin;
mod overruled;
pub mod probe;
pub mod recorder;
pub mod removable;
mod rough;
#[cfg(feature = "scenario")]
pub mod runout;
#[cfg(feature = "scenario")]
pub mod scene;
pub mod simulation;
#[cfg(feature = "scenario")]
pub mod sizes;
#[cfg(feature = "scenario")]
pub mod strength;
pub mod study;

pub use study::{bracket, compare, safety};
#[cfg(feature = "scenario")]
pub use study::{sweep, verify};
