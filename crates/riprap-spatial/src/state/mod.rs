//! What the engine knows between two steps, and what it can drop and lay out anew: plain data.
//!
//! Nothing here acts. Forces, motion, edits and readings stand in the workspaces above, which use this one and not each other's
//! insides; this one uses the setup, the laws, geometry and the ledger only.

pub mod bodies;
pub mod bolts;
pub mod cavity;
pub mod cutting;
pub mod deform;
pub mod deformable;
pub mod event;
pub mod face;
pub mod found;
mod hash;
pub mod hold;
pub mod interface;
pub mod lineage;
pub mod patches;
pub mod push;
pub mod relax;
pub mod scratch;
pub mod seepage;
pub mod sums;
pub mod workspace;
pub mod world;
