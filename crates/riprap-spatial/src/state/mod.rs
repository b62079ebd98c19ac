//! What the engine knows between two steps, and what it can drop and lay out anew: plain data.
//!
//! Nothing here acts. Forces, motion, edits and readings stand in the workspaces above, which use this one and not each other's
//! insides; this one uses the setup, the laws, geometry and the ledger only.

pub(crate) mod anchor;
pub(crate) mod contact_scratch;
pub(crate) mod links;
pub mod tiles;

pub(crate) mod bodies;
pub(crate) mod bolts;
pub(crate) mod cavity;
pub(crate) mod clock;
pub(crate) mod cuts;
pub(crate) mod cutting;
pub mod deform;
pub(crate) mod deformable;
pub(crate) mod event;
pub(crate) mod face;
pub(crate) mod found;
pub(crate) mod gas;
mod hash;
pub mod hold;
pub(crate) mod interface;
pub(crate) mod lineage;
pub(crate) mod patches;
pub(crate) mod push;
pub(crate) mod relax;
pub(crate) mod scratch;
pub(crate) mod seepage;
pub(crate) mod share;
mod sound;
pub mod sums;
pub(crate) mod wide;
pub(crate) mod workspace;
pub mod world;
