//! What a run leaves behind: field table, frames, run folder, checkpoints.
//!
//! Plain data in, files out. This crate knows no engine: whoever advances the world fills a [`Frame`], a row of
//! numbers or a serialisable state, and hands it over. Nothing here decides *when* something is written.
//!
//! - [`field`]: the vocabulary (name, unit, where it sits, meaning) that engines publish as a table;
//! - [`frame`]: one picture of the blocks with columns of numbers;
//! - [`folder`]: the run folder, the contract of `docs/src/run-folder.md`;
//! - [`manifest`]: what was run, with what, and how it ended;
//! - [`names`]: what blocks and groups are called;
//! - [`conditions`]: what holds, moves and loads the model, for pictures;
//! - [`contacts`]: whether contacts slide, have broken or are open;
//! - [`checkpoint`]: the state to resume from, guarded against every kind of damage;
//! - [`vtu`]: VTK files for ParaView, written and read back;
//! - [`table`]: reader of the CSV files;
//!
//! Invariant: whatever moment the process dies, each file is either the last complete version (written
//! aside, synced and renamed) or an append-only file of which all but the last line is complete.

// What no other crate can name does not look as if it could be.
#![cfg_attr(not(test), warn(unreachable_pub))]
// Tests may compare with the functions of the platform.
#![cfg_attr(test, allow(clippy::disallowed_methods))]

pub mod checkpoint;
pub mod conditions;
pub mod contacts;
pub mod folder;
pub mod manifest;
pub mod names;
pub mod table;
pub mod vtu;

mod disk;

pub use riprap_core::{exec, field, frame};

pub use disk::{OutputError, open_plain, read_plain, read_plain_text, write_whole};
pub use field::{FieldError, FieldInfo, Part, Shape, Site};
pub use folder::{Existing, FolderError, FrameEntry, Marks, RunFolder};
pub use frame::{Column, Frame};
pub use manifest::{Ended, Manifest, Place, Source};
