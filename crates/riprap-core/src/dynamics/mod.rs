//! Clock, integrators, damping, time functions, convergence.

pub mod damping;
pub mod formula;
pub mod kick;
pub mod relaxation;
pub mod time_function;

pub use formula::{Formula, FormulaError};
pub use time_function::TimeFunction;
