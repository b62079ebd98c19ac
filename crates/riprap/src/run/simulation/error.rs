//! Why the physics stops a run.

use thiserror::Error;

use crate::ledger::Unexplained;

/// Why the physics stopped a run.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum RunError {
    /// A block's state is not a number any more.
    #[error("block `{block}`: {what} is not finite at step {step} (t = {time:.6e} s); {why}")]
    NonFinite {
        /// Name of the block.
        block: String,
        /// What of it.
        what: String,
        /// Text of the formula that is to blame, where one is.
        formula: Option<String>,
        /// What is to blame, or what was looked at and ruled out.
        why: String,
        /// Step.
        step: u64,
        /// Model time, s.
        time: f64,
    },
    /// A sum over the model is not a number any more, and no block alone is to blame.
    #[error("{what} is not finite at step {step} (t = {time:.6e} s); {ruled_out}")]
    NoNumber {
        /// What.
        what: String,
        /// What was looked at and ruled out.
        ruled_out: String,
        /// Step.
        step: u64,
        /// Model time, s.
        time: f64,
    },
    /// The time step is not a number above zero.
    #[error(
        "there is no time step at step {step} (t = {time:.6e} s), it came out as {dt:e} s: {}",
        if *.dt == f64::INFINITY {
            "nothing holds the blocks, so that none is the stable one; give `time_step`, or `until.time`"
        } else {
            "a block is too fast, or what the stable step is found from is not finite"
        }
    )]
    NoStep {
        /// What came out, s.
        dt: f64,
        /// Step.
        step: u64,
        /// Model time, s.
        time: f64,
    },
    /// Steady seepage has not been found.
    #[error(
        "the wet part of the joints was not found at step {step} (t = {time:.6e} s): rates miss each other by {left:.0e} of the largest possible one; \
         make apertures less unlike (`water.*.seepage.aperture_min`, `aperture_max`), or move the table off the corners of blocks"
    )]
    NoFlow {
        /// What does not add up.
        left: f64,
        /// Step.
        step: u64,
        /// Model time, s.
        time: f64,
    },
    /// The ledger does not explain where energy has come from or gone to.
    #[error(
        "{what} is {percent:.1} % of the largest energy that moved ({energy:.3e} {unit}) at step {step} \
         (t = {time:.6e} s), {allowed} % are allowed (`phases.*.max_residual`): what has happened is not what the laws say; \
         fastest block `{fastest}`; {ruled_out}"
    )]
    Residual {
        /// What the ledger does not account for.
        what: Unexplained,
        /// It over the largest energy that moved, per cent.
        percent: f64,
        /// What is allowed, per cent.
        allowed: f64,
        /// It, in `unit`.
        energy: f64,
        /// Unit of energies.
        unit: &'static str,
        /// Fastest block.
        fastest: String,
        /// What was looked at and ruled out.
        ruled_out: String,
        /// Step.
        step: u64,
        /// Model time, s.
        time: f64,
    },
    /// Two blocks have gone too far into each other.
    #[error(
        "blocks `{first}` and `{second}` overlap by {percent:.0} % of the smaller one's inscribed \
         radius at step {step} (t = {time:.6e} s): they would pass through each other. What can help: a larger `normal_stiffness`, or larger \
         smallest blocks (`smallest_edge` of the generator); {ruled_out}"
    )]
    Overlap {
        /// One block.
        first: String,
        /// The other.
        second: String,
        /// Depth over inscribed radius, per cent.
        percent: f64,
        /// What was looked at and ruled out.
        ruled_out: String,
        /// Step.
        step: u64,
        /// Model time, s.
        time: f64,
    },
    /// Two blocks in space are about to come out on each other's far side, or one is about to be swallowed by terrain.
    #[error(
        "blocks `{first}` and `{second}` have been pressed {depth:.4e} m into each other at step {step} (t = {time:.6e} s), as far as the largest ball \
         in the thinner one reaches: beyond that nothing holds them apart, and one would pass through the other. What can help: a larger \
         `normal_stiffness` between their materials (where these have a `brittle_bond` and one block deforms: of that, or a smaller \
         `thickness`), or a look at why they meet so fast; {ruled_out}"
    )]
    PassesThrough {
        /// One block.
        first: String,
        /// The other.
        second: String,
        /// Depth, m.
        depth: f64,
        /// What was looked at and ruled out.
        ruled_out: String,
        /// Step.
        step: u64,
        /// Model time, s.
        time: f64,
    },
    /// What a phase begins with failed.
    #[error("phase `{phase}` cannot begin at step {step} (t = {time:.6e} s): {reason}")]
    Phase {
        /// Name of the phase.
        phase: String,
        /// What is wrong.
        reason: String,
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
        "kinetic energy {kinetic:.3e} {unit} at step {step} (t = {time:.6e} s) is {ratio:.1} times all \
         energy put in, fastest block `{block}`; {ruled_out}"
    )]
    BlowUp {
        /// Fastest block.
        block: String,
        /// Kinetic energy, in `unit`.
        kinetic: f64,
        /// Unit of energies.
        unit: &'static str,
        /// Over the energy put in.
        ratio: f64,
        /// What was looked at and ruled out.
        ruled_out: String,
        /// Step.
        step: u64,
        /// Model time, s.
        time: f64,
    },
}

impl RunError {
    /// Adds what was found out after the run had been stopped.
    pub(in crate::run) fn add(&mut self, found: &str) {
        match self {
            Self::NonFinite { why: words, .. }
            | Self::NoNumber {
                ruled_out: words, ..
            }
            | Self::Residual {
                ruled_out: words, ..
            }
            | Self::Overlap {
                ruled_out: words, ..
            }
            | Self::PassesThrough {
                ruled_out: words, ..
            }
            | Self::BlowUp {
                ruled_out: words, ..
            } => {
                words.push_str("; ");
                words.push_str(found);
            }
            Self::NoStep { .. } | Self::NoFlow { .. } | Self::Edit { .. } | Self::Phase { .. } => {}
        }
    }

    /// What has happened, in a few words.
    pub(in crate::run) fn kind(&self) -> &'static str {
        match self {
            Self::NonFinite { .. } | Self::NoNumber { .. } => "something is not finite",
            Self::NoStep { .. } => "there is no time step",
            Self::NoFlow { .. } => "seepage was not found",
            Self::Residual {
                what: Unexplained::Residual,
                ..
            } => "the energy residual",
            Self::Residual {
                what: Unexplained::LawDefect,
                ..
            } => "the defect of the laws",
            Self::Residual {
                what: Unexplained::Steps,
                ..
            } => "the energy that changes of the step made",
            Self::Overlap { .. } | Self::PassesThrough { .. } => "blocks pass through each other",
            Self::Edit { .. } => "a block cannot be split or cut",
            Self::Phase { .. } => "a phase cannot begin",
            Self::BlowUp { .. } => "energy from nowhere",
        }
    }

    /// Whether a shorter step could have avoided it: nothing else has been found to blame, and there was a step.
    pub(in crate::run) fn doubts_the_step(&self) -> bool {
        match self {
            Self::NonFinite { formula, .. } => formula.is_none(),
            Self::NoNumber { .. }
            | Self::Residual { .. }
            | Self::Overlap { .. }
            | Self::PassesThrough { .. }
            | Self::BlowUp { .. } => true,
            Self::NoStep { .. } | Self::NoFlow { .. } | Self::Edit { .. } | Self::Phase { .. } => {
                false
            }
        }
    }

    /// Whether the forces at the state where it stopped the run are known and numbers: a guard has looked at them.
    pub(in crate::run) fn knows_forces(&self) -> bool {
        match self {
            Self::NoFlow { .. }
            | Self::Residual { .. }
            | Self::Overlap { .. }
            | Self::PassesThrough { .. }
            | Self::BlowUp { .. } => true,
            Self::NonFinite { .. }
            | Self::NoNumber { .. }
            | Self::NoStep { .. }
            | Self::Edit { .. }
            | Self::Phase { .. } => false,
        }
    }

    /// Text of the formula that is to blame, where one is.
    #[must_use]
    pub fn formula(&self) -> Option<&str> {
        match self {
            Self::NonFinite { formula, .. } => formula.as_deref(),
            Self::NoNumber { .. }
            | Self::NoStep { .. }
            | Self::NoFlow { .. }
            | Self::Residual { .. }
            | Self::Overlap { .. }
            | Self::PassesThrough { .. }
            | Self::Edit { .. }
            | Self::Phase { .. }
            | Self::BlowUp { .. } => None,
        }
    }
}
