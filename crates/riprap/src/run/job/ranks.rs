//! A run by several ranks: each computes the same run, rank 0 alone reads and writes the folder and speaks with the user.

use std::path::Path;
use std::sync::Arc;

use super::{Job, JobError, Live, Outcome};
use crate::exec::{Exec, ranks};
use crate::peers::{Peers, Trouble};
use crate::record::RunFolder;
use crate::record::folder::Existing;
use crate::run::drive::{Control, DriveError, Look};
use crate::run::recorder::{Checkpoint, Recorder};
use crate::run::simulation::Simulation;

/// As [`super::run`] by `size` ranks, threads of this process with `threads` threads each: the same bytes in the folder, but for
/// the times in the manifest.
///
/// # Errors
/// As [`super::run`]; ranks that are gone or differ.
pub fn run_ranks(
    job: Job,
    folder: &Path,
    existing: Existing,
    [size, threads]: [usize; 2],
    look: &mut dyn FnMut(&mut Look<'_>) -> Control,
) -> Result<Outcome, JobError> {
    let jobs = |_| job.clone();
    run_each(&jobs, folder, existing, [size, threads], look)
}

/// [`run_ranks`] with the job that each rank makes of the scene.
pub(super) fn run_each(
    job: &(dyn Fn(usize) -> Job + Sync),
    folder: &Path,
    existing: Existing,
    [size, threads]: [usize; 2],
    look: &mut dyn FnMut(&mut Look<'_>) -> Control,
) -> Result<Outcome, JobError> {
    let lead = |peers| run_among(job(0), folder, existing, peers, threads, look);
    outcome(ranks(size, lead, |peers: Arc<Peers>| {
        run_among(job(peers.rank()), folder, existing, peers, threads, &mut nothing)
    }))
}

/// As [`super::resume`] by `size` ranks, threads of this process with `threads` threads each, however many have computed it so far.
///
/// # Errors
/// As [`super::resume`]; ranks that are gone or differ.
pub fn resume_ranks(
    folder: &Path,
    [size, threads]: [usize; 2],
    look: &mut dyn FnMut(&mut Look<'_>) -> Control,
) -> Result<Outcome, JobError> {
    let lead = |peers| resume_among(folder, peers, threads, look);
    outcome(ranks(size, lead, |peers| resume_among(folder, peers, threads, &mut nothing)))
}

/// As [`super::run`] for one of several ranks, which all must call it with the same job.
///
/// # Errors
/// As [`super::run`]; ranks that are gone or differ.
pub fn run_among(
    job: Job,
    folder: &Path,
    existing: Existing,
    peers: Arc<Peers>,
    threads: usize,
    look: &mut dyn FnMut(&mut Look<'_>) -> Control,
) -> Result<Outcome, JobError> {
    Live::begin_on(job, folder, existing, Exec::among(peers, threads)?)?.finish(look)
}

/// As [`super::resume`] for one of several ranks, which all must call it.
///
/// # Errors
/// As [`super::resume`]; ranks that are gone or differ.
pub fn resume_among(
    folder: &Path,
    peers: Arc<Peers>,
    threads: usize,
    look: &mut dyn FnMut(&mut Look<'_>) -> Control,
) -> Result<Outcome, JobError> {
    Live::reopen_on(folder, Exec::among(peers, threads)?)?.finish(look)
}

fn nothing(_: &mut Look<'_>) -> Control {
    Control::Continue
}

/// How the run of a rank ended.
type Ended = Result<Outcome, JobError>;

/// What rank 0 says; where it missed another rank, what that one says.
fn outcome((lead, others): (Ended, Vec<Option<Ended>>)) -> Result<Outcome, JobError> {
    let gone = match &lead {
        Err(JobError::Drive(DriveError::Ranks(Trouble::Gone { rank, .. }))) => *rank,
        Ok(_) | Err(_) => return lead,
    };
    let said = others.into_iter().nth(gone.wrapping_sub(1)).flatten();
    match said {
        Some(Err(why)) if why.ranks().is_none() => Err(why),
        Some(_) | None => lead,
    }
}

impl JobError {
    /// Why the ranks of the run could not go on together, if that is why.
    #[must_use]
    pub fn ranks(&self) -> Option<&Trouble> {
        match self {
            Self::Drive(DriveError::Ranks(trouble)) => Some(trouble),
            _ => None,
        }
    }
}

/// Whether this rank computes for another one that writes.
pub(super) fn follows(exec: &Exec) -> bool {
    exec.peers().is_some_and(|peers| peers.rank() > 0)
}

fn sound(exec: &Exec) -> Result<(), JobError> {
    let trouble = exec.peers().and_then(|peers| peers.trouble());
    trouble.map_or(Ok(()), |trouble| Err(DriveError::from(trouble).into()))
}

/// Makes sure that all ranks are the same program and have read the same scene.
pub(super) fn greet(exec: &Exec, job: &Job) -> Result<(), JobError> {
    if let Some(peers) = exec.peers() {
        peers.agree("another version of riprap", env!("CARGO_PKG_VERSION"));
        peers.agree("the scene or a file that it reads is not the same", &job.manifest.input_hash);
    }
    sound(exec)
}

/// Gives the checkpoint that rank 0 has read to all.
pub(super) fn hand_out(exec: &Exec, found: Checkpoint) -> Result<Checkpoint, JobError> {
    let Some(peers) = exec.peers() else {
        return Ok(found);
    };
    peers.agree("another version of riprap", env!("CARGO_PKG_VERSION"));
    let found = peers.order(Some(found));
    let size = peers.size();
    found.ok_or_else(|| {
        let trouble = peers.trouble().unwrap_or(Trouble::Gone { rank: 0, size });
        DriveError::from(trouble).into()
    })
}

impl Live {
    /// A run that goes on from the checkpoint that rank 0 hands out.
    pub(super) fn follow(exec: Exec) -> Result<Self, JobError> {
        let mut found = None;
        if let Some(peers) = exec.peers() {
            peers.agree("another version of riprap", env!("CARGO_PKG_VERSION"));
            found = peers.order::<Checkpoint>(None);
        }
        sound(&exec)?;
        let Some(Checkpoint { origin, snapshot, marks, counts, watches }) = found else {
            return Err(DriveError::from(Trouble::Gone { rank: 0, size: 1 }).into());
        };
        let simulation = Simulation::resume(snapshot, exec);
        let (kind, plan) = (simulation.kind(), simulation.plan());
        let folder = RunFolder::silent(marks.frames);
        let recorder = Recorder::new(folder, origin, kind, plan, Some(counts))?;
        Self::new(simulation, Some(recorder), watches, super::Manifest::default())
    }
}
