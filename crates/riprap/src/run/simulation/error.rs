//! Why the physics stops a run.

use std::cmp::Ordering;

use thiserror::Error;

use super::cursor::Into;
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
    /// A law of code has failed; the run can go on from its checkpoint.
    #[error("contact law `{law}` at step {step} (t = {time:.6e} s): {why}")]
    Law {
        /// Its name.
        law: String,
        /// What is wrong, in words.
        why: String,
        /// Step.
        step: u64,
        /// Model time, s.
        time: f64,
    },
    /// The time step is not a number above zero.
    #[error(
        "no valid time step at step {step} (t = {time:.6e} s){}",
        if *.dt == f64::INFINITY {
            ": no two blocks interact, so there is no stable step; give `time_step`, or `until.time`".to_owned()
        } else {
            format!(", computed as {dt:e} s: a block is too fast, or an input of the stable step is not finite", dt = .dt)
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
    /// The contacts of an implicit step have not come to balance.
    #[error(
        "the implicit step did not converge at step {step} (t = {time:.6e} s, time step {dt:.3e} s): after {rounds} iterations the contact between \
         blocks `{}` and `{}` is not in balance; use a shorter `time_step`, or `integration = \"explicit\"` for this phase",
        .blocks[0], .blocks[1]
    )]
    NotSolved {
        /// Names of the blocks whose contact changes most.
        blocks: [String; 2],
        /// Iterations of Newton's method.
        rounds: usize,
        /// Length of the step, s.
        dt: f64,
        /// Step.
        step: u64,
        /// Model time, s.
        time: f64,
    },
    /// Steady seepage has not been found.
    #[error(
        "seepage did not converge at step {step} (t = {time:.6e} s): flow rates are out of balance by {left:.0e} of the largest possible rate; \
         reduce the contrast of apertures (`water.*.seepage.aperture_min`, `aperture_max`), or move the water table away from block corners"
    )]
    NoFlow {
        /// What does not add up.
        left: f64,
        /// Step.
        step: u64,
        /// Model time, s.
        time: f64,
    },
    /// A servo that cannot act.
    #[error("the control of `{name}` cannot act at step {step} (t = {time:.6e} s): {reason}")]
    Control {
        /// The load or support.
        name: String,
        /// Why.
        reason: String,
        /// Step.
        step: u64,
        /// Model time, s.
        time: f64,
    },
    /// The flow of gas in cracks has not been found.
    #[error(
        "the flow of gas in cracks did not converge at step {step} (t = {time:.6e} s): {place} is out of balance by {left:.0e} of what it holds; \
         use a shorter `time_step`, or reduce the contrast of apertures (`venting.cracks.aperture`, `aperture_max`)"
    )]
    NoGasFlow {
        /// The crack or cavity that is farthest out of balance.
        place: String,
        /// What does not add up.
        left: f64,
        /// Step.
        step: u64,
        /// Model time, s.
        time: f64,
    },
    /// The ledger does not explain where energy has come from or gone to.
    #[error(
        "{what} is {percent:.1} % of the largest energy exchanged ({energy:.3e} {unit}) at step {step} (t = {time:.6e} s); the limit is {allowed} % \
         (`phases.*.max_residual`). The motion does not follow the laws. Fastest block `{fastest}`; {ruled_out}"
    )]
    Residual {
        /// What the ledger does not account for.
        what: Unexplained,
        /// It over the largest energy exchanged, per cent.
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
        "blocks `{first}` and `{second}` overlap by {percent:.0} % of the smaller one's inscribed radius at step {step} (t = {time:.6e} s): they \
         would pass through each other. Possible remedies: a larger `normal_stiffness`, or a larger `smallest_edge` of the generator; {ruled_out}"
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
        "blocks `{first}` and `{second}` have been pressed {depth:.4e} m into each other at step {step} (t = {time:.6e} s), beyond the inscribed \
         radius of the thinner one ({reach:.4e} m): they would pass through each other. Possible remedies: a larger `normal_stiffness` between their \
         materials (with a `brittle_bond` where one block is deformable: that of the bond, or a smaller `thickness`), `stiffening_depth = 0.2` for \
         contacts of rigid blocks, or a smaller impact velocity; \
         {ruled_out}"
    )]
    PassesThrough {
        /// One block.
        first: String,
        /// The other.
        second: String,
        /// Depth, m.
        depth: f64,
        /// Radius of the largest ball in the thinner one, m; no larger than the depth.
        reach: f64,
        /// What was looked at and ruled out.
        ruled_out: String,
        /// Step.
        step: u64,
        /// Model time, s.
        time: f64,
    },
    /// A block in space has been pressed through what holds one of its faces.
    #[error(
        "block `{block}` has been pressed {depth:.4e} m into boundary `{boundary}` at step {step} (t = {time:.6e} s), beyond its inscribed radius \
         ({reach:.4e} m): it would pass through. The stiffness of the boundary is that of the half block behind the face. Possible remedies: a \
         larger `young` of the block, a smaller load, or a larger block there; {ruled_out}"
    )]
    PressedOut {
        /// The block.
        block: String,
        /// The condition on its face.
        boundary: String,
        /// Depth, m.
        depth: f64,
        /// Radius of the largest ball in the block, m; no larger than the depth.
        reach: f64,
        /// What was looked at and ruled out.
        ruled_out: String,
        /// Step.
        step: u64,
        /// Model time, s.
        time: f64,
    },
    /// Two blocks overlap, and the surface on which they press each other was not found.
    #[error(
        "no contact surface was found between blocks `{first}` and `{second}` at step {step} (t = {time:.6e} s), although they overlap by \
         {depth:.4e} m (inscribed radius of the thinner one {reach:.4e} m): the force is undefined. The surface was lost to round-off; the scene is \
         not at fault. Possible remedies: another `seed`, or blocks that are not aligned to the last digit. Please report it with the checkpoint; \
         {ruled_out}"
    )]
    NoSurface {
        /// One block.
        first: String,
        /// The other.
        second: String,
        /// Depth, m.
        depth: f64,
        /// Radius of the largest ball in the thinner one, m; larger than the depth.
        reach: f64,
        /// What was looked at and ruled out.
        ruled_out: String,
        /// Step.
        step: u64,
        /// Model time, s.
        time: f64,
    },
    /// A deformable block has been turned inside out.
    #[error(
        "deformable block `{block}` is inverted at ({:.4}, {:.4}, {:.4}) m: a tetrahedron there has {volume:.2} times its initial volume (step \
         {step}, t = {time:.6e} s), outside the range of its law. Possible remedies: check `young` and its unit; use a larger `young`, or a smaller \
         load; {ruled_out}",
        .at[0], .at[1], .at[2]
    )]
    InsideOut {
        /// The block.
        block: String,
        /// Where, m.
        at: [f64; 3],
        /// Volume over that at the start.
        volume: f64,
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
        "kinetic energy {kinetic:.3e} {unit} at step {step} (t = {time:.6e} s) is {ratio:.1} times the total energy input; fastest block `{block}`; \
         {ruled_out}"
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
    /// The error for blocks that are pressed too deep (m) for the radius of the largest ball in the thinner one (m), or that overlap without a
    /// surface: its words are those that its numbers bear out.
    pub(super) fn pressed(
        [first, second]: [String; 2],
        into: Into,
        [depth, reach]: [f64; 2],
        at: impl FnOnce() -> (String, u64, f64),
    ) -> Self {
        let (ruled_out, step, time) = at();
        match into {
            // Not a number is no proof of a depth.
            Into::Block if depth.partial_cmp(&reach).is_none_or(Ordering::is_lt) => {
                Self::NoSurface { first, second, depth, reach, ruled_out, step, time }
            }
            Into::Block => {
                Self::PassesThrough { first, second, depth, reach, ruled_out, step, time }
            }
            Into::Condition => Self::PressedOut {
                block: first,
                boundary: second,
                depth,
                reach,
                ruled_out,
                step,
                time,
            },
        }
    }

    /// Adds what was found out after the run had been stopped.
    pub(in crate::run) fn add(&mut self, found: &str) {
        match self {
            Self::NonFinite { why: words, .. }
            | Self::NoNumber { ruled_out: words, .. }
            | Self::Residual { ruled_out: words, .. }
            | Self::Overlap { ruled_out: words, .. }
            | Self::PassesThrough { ruled_out: words, .. }
            | Self::PressedOut { ruled_out: words, .. }
            | Self::NoSurface { ruled_out: words, .. }
            | Self::InsideOut { ruled_out: words, .. }
            | Self::BlowUp { ruled_out: words, .. } => {
                words.push_str("; ");
                words.push_str(found);
            }
            Self::NoStep { .. }
            | Self::Law { .. }
            | Self::NotSolved { .. }
            | Self::NoFlow { .. }
            | Self::NoGasFlow { .. }
            | Self::Control { .. }
            | Self::Edit { .. }
            | Self::Phase { .. } => {}
        }
    }

    /// What has happened, in a few words.
    pub(in crate::run) fn kind(&self) -> &'static str {
        self.judged().0
    }

    /// Whether a shorter step could have avoided it: nothing else has been found to blame, and there was a step.
    pub(in crate::run) fn doubts_the_step(&self) -> bool {
        self.judged().1 && self.formula().is_none()
    }

    /// Whether the forces at the state where it stopped the run are known and numbers: a guard has looked at them.
    pub(in crate::run) fn knows_forces(&self) -> bool {
        self.judged().2
    }

    /// What has happened, whether the step may be to blame, and whether forces are known.
    fn judged(&self) -> (&'static str, bool, bool) {
        match self {
            Self::NonFinite { .. } | Self::NoNumber { .. } => {
                ("a value is not finite", true, false)
            }
            Self::NoStep { .. } => ("no valid time step", false, false),
            Self::NotSolved { .. } => ("an implicit step did not converge", false, false),
            Self::NoFlow { .. } => ("seepage did not converge", false, true),
            Self::Law { .. } => ("a contact law failed", false, false),
            Self::Control { .. } => ("a control cannot act", false, false),
            Self::NoGasFlow { .. } => ("the flow of gas did not converge", true, true),
            Self::Residual { what: Unexplained::Residual, .. } => {
                ("the energy residual", true, true)
            }
            Self::Residual { what: Unexplained::LawDefect, .. } => {
                ("the defect of the contact laws", true, true)
            }
            Self::Residual { what: Unexplained::Steps, .. } => {
                ("the energy created by changes of the step", true, true)
            }
            Self::Overlap { .. } | Self::PassesThrough { .. } => {
                ("blocks pass through each other", true, true)
            }
            Self::PressedOut { .. } => ("a block is pressed through a boundary", true, true),
            Self::NoSurface { .. } => ("no contact surface was found", false, false),
            Self::InsideOut { .. } => ("a deformable block is inverted", true, true),
            Self::Edit { .. } => ("a block cannot be split or cut", false, false),
            Self::Phase { .. } => ("a phase cannot begin", false, false),
            Self::BlowUp { .. } => ("unexplained kinetic energy", true, true),
        }
    }

    /// Text of the formula that is to blame, where one is.
    #[must_use]
    pub fn formula(&self) -> Option<&str> {
        if let Self::NonFinite { formula, .. } = self { formula.as_deref() } else { None }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_of_a_depth_are_those_that_its_numbers_bear_out() {
        let names = || ["a", "b"].map(str::to_owned);
        let of = |depth: f64, reach: f64| {
            RunError::pressed(names(), Into::Block, [depth, reach], || (String::new(), 1, 0.1))
        };
        // As a run was stopped: micrometres, where balls of 0.21 m fit into the thinner one.
        let lost = of(2.6e-6, 0.21);
        assert!(matches!(lost, RunError::NoSurface { .. }));
        let words = lost.to_string();
        assert!(words.contains("2.6000e-6 m") && words.contains("2.1000e-1 m"), "{words}");
        assert!(!words.contains("beyond the inscribed radius") && !lost.doubts_the_step());
        for deep in [0.21, 0.42] {
            let through = of(deep, 0.21);
            assert!(matches!(through, RunError::PassesThrough { .. }));
            assert!(
                through.to_string().contains("inscribed radius of the thinner one (2.1000e-1 m)")
            );
        }
        assert!(matches!(of(f64::NAN, 0.21), RunError::NoSurface { .. }));
    }
}
