//! What the user said: the TOML scenario with units and spans. No physics, no hidden defaults.

pub mod language;
pub mod quantity;
pub mod time_function;
pub mod units;

pub use language::Scenario;
pub use quantity::{Name, Names, Quantity, Span, Table};
pub use time_function::TimeFunction;
