//! What a step works with: data that can be dropped and rebuilt without changing a result.
//!
//! It stands below all that fills or reads it; [`super::step`] has the functions.

use riprap_core::profile::Profile;
use riprap_geom::Vec2;

use super::convex::Turned;
use super::depths::Kinks;
use super::loads::Applied;
use super::pieces::Piece;
use super::potential::Local;
use super::search::Candidates;
use super::setup::ContactLaw;
use super::shapes::Shapes;
use super::world::{Region, Wrench};
use crate::accounts::Entries;
use crate::exec::Exec;
use crate::laws::bolt::BoltScratch;
use crate::ledger::Works;

/// Everything that can be dropped and rebuilt without changing a result.
#[derive(Debug)]
pub struct Scratch {
    /// Body geometry.
    pub shapes: Shapes,
    /// Thread pool.
    pub exec: Exec,
    /// Stage timers.
    pub profile: Profile,
    /// Candidate pairs.
    pub candidates: Candidates,
    /// Edges at the present angles.
    pub turned: Vec<Turned>,
    /// Wrench of each convex pair, then each general pair, then each bond, then each tie of a bolt.
    pub slots: Vec<Wrench>,
    /// Blocks that bolts tie together, one pair for each of their slots.
    pub(crate) ties: Vec<(u32, u32)>,
    /// What bolts are solved with.
    pub(crate) bolts: Vec<BoltScratch>,
    /// For block `b` the entries `incidence[first_entry[b]..first_entry[b + 1]]`.
    pub(crate) first_entry: Vec<u32>,
    /// Slot number times two, plus one for the second block of the pair.
    pub(crate) incidence: Vec<u32>,
    /// Velocity changes of the coming kick.
    pub changes: Vec<Change>,
    /// Length of the step that the kick was found for, s.
    pub coming_dt: f64,
    /// Sums of forces, without damping and supports.
    pub net: Vec<Net>,
    /// External loads.
    pub applied: Vec<Applied>,
    /// Works of the half step after the present time, booked by `advance`.
    pub(crate) departure: Works,
    /// Works of single conditions.
    pub(crate) entries: Entries,
    /// Contact laws by row.
    pub(crate) laws: Vec<ContactLaw>,
    pub(crate) partial: Vec<Partial>,
    pub(crate) workspaces: Vec<Workspace>,
    pub(crate) stale: bool,
    /// Candidate lists built since the start.
    pub rebuilds: u64,
    /// Smallest time in which a block crosses the reach of its neighbourhood, s.
    pub transit: f64,
}

/// Sums of one group.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Partial {
    pub arrival: Works,
    pub departure: Works,
    pub bad: Option<u32>,
    pub moved: bool,
    pub transit: f64,
}

impl Default for Partial {
    fn default() -> Self {
        Self {
            arrival: Works::default(),
            departure: Works::default(),
            bad: None,
            moved: false,
            transit: f64::INFINITY,
        }
    }
}

/// A block whose state is no longer finite.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("the forces on block {block} are not finite")]
pub struct NonFinite {
    /// Index of the block.
    pub block: u32,
}

/// Velocity change of one block in the coming kick.
#[derive(Clone, Copy, Debug, Default)]
pub struct Change {
    /// m/s.
    pub velocity: Vec2,
    /// rad/s.
    pub spin: f64,
}

/// Sum of all forces on a block but damping and the reaction of supports.
#[derive(Clone, Copy, Debug, Default)]
pub struct Net {
    /// N/m.
    pub force: Vec2,
    /// About the centroid, N.
    pub moment: f64,
}

/// What the general kernel of contacts works in.
#[derive(Clone, Debug, Default)]
pub(crate) struct Workspace {
    pub pieces: Vec<Piece>,
    pub cuts: Vec<(f64, Option<u16>)>,
    pub kinks: Kinks,
    pub local: Local,
    pub old: Vec<Region>,
}
