//! What the user said: the TOML scenario with units and spans. No physics, no hidden defaults.
//!
//! ```text
//! file --load--> text --overrides--> text --parse--> Parsed { Scenario, Source, warnings }
//!                                      |
//!            syntax, validate (schema, units, ranges, rules of keys), rules (values, references)
//!                                      v
//!                                 Diagnostics (all that is wrong, each with its place)
//! ```
//!
//! The structs in [`language`] are the language; the JSON schema made from them drives the
//! validation, `riprap explain KEY` and the reference page. Values keep their place in the file.
//! Geometry, mechanics and files that a scenario names are the business of `model`.

// What no other crate can name does not look as if it could be.
#![cfg_attr(not(test), warn(unreachable_pub))]
// Tests may compare with the functions of the platform.
#![cfg_attr(test, allow(clippy::disallowed_methods))]

pub mod csv_columns;
pub mod diagnostic;
pub mod foreign;
pub mod language;
mod load;
mod moments;
pub mod msh;
mod names;
mod overrides;
mod path;
mod plain_file;
pub mod quantity;
pub mod read;
mod references;
mod replaced;
mod rule;
mod rules;
mod samples;
mod schema;
pub mod time_function;
pub mod units;
mod validate;
mod values;
pub mod vectors;
pub mod words;

pub use diagnostic::{Diagnostic, Diagnostics, Severity, Source};
pub use language::Scenario;
pub use load::{Parsed, load, parse, parse_changed, parse_with};
pub use overrides::{Case, apply_overrides, cases, varied_and_set};
pub use quantity::{Name, Names, Quantity, Span, Table};
pub use references::NO_WATER;
pub use replaced::{TABLE_REPLACED, fallen_away};
pub use rule::no_effect;
pub use rules::{read_formula, target_span};
pub use samples::{sampled_number, samples};
pub use schema::{KeyDoc, explain_key, keys, markdown, schema_text};
pub use time_function::TimeFunction;
