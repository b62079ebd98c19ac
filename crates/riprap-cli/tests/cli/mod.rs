//! Drives the real binary, as a person or a script would.

mod bench;
mod beyond;
mod blast;
#[cfg(unix)]
mod faults;
mod guards;
mod many;
mod runs;
mod searches;
mod templates;
mod told;
mod verbs;
mod words;
