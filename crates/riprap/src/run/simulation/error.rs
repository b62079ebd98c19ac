//! Why the physics stops a run.

use thiserror::Error;

/// Why the physics stopped a run.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum RunError {
    /// A block's state is not a number any more.
    #[error(
        "block `{block}` has forces that are not finite at step {step} (t = {time:.6e} s); \
         the time step is probably too long for the stiffness"
    )]
    NonFinite {
        /// Name of the block.
        block: String,
        /// Step.
        step: u64,
        /// Model time, s.
        time: f64,
    },
    /// Two blocks have gone too far into each other.
    #[error(
        "blocks `{first}` and `{second}` overlap by {percent:.0} % of the smaller one's inscribed \
         radius at step {step} (t = {time:.6e} s); use a stiffer contact, or larger smallest blocks \
         (`smallest_edge` of the generator)"
    )]
    Overlap {
        /// One block.
        first: String,
        /// The other.
        second: String,
        /// Depth over inscribed radius, per cent.
        percent: f64,
        /// Step.
        step: u64,
        /// Model time, s.
        time: f64,
    },
    /// Splitting blocks failed.
    #[error("blocks could not be split at step {step} (t = {time:.6e} s): {reason}")]
    Edit {
        /// What is wrong.
        reason: String,
        /// Step.
        step: u64,
        /// Model time, s.
        time: f64,
    },
    /// Energy came from nowhere.
    #[error(
        "kinetic energy {kinetic:.3e} J at step {step} (t = {time:.6e} s) is {ratio:.1} times all \
         energy put in, fastest block `{block}`; the time step is probably too long"
    )]
    BlowUp {
        /// Fastest block.
        block: String,
        /// Kinetic energy, J (J per metre of thickness in the plane).
        kinetic: f64,
        /// Over the energy put in.
        ratio: f64,
        /// Step.
        step: u64,
        /// Model time, s.
        time: f64,
    },
}
