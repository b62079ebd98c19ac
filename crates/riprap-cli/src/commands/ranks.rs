//! How many ranks compute a run, and what a launcher of ranks (`mpirun`, `srun`) has started.

#[cfg(feature = "mpi")]
pub mod by_mpi;

use std::path::Path;

use riprap::record::folder::Existing;
use riprap::run::drive::{Control, Look};
use riprap::run::job::{self, Job, JobError, Live, Outcome};

use crate::args::{How, Ranks};
use crate::commands::cores;
use crate::diagnostics::print_line;
use crate::failure::Failure;

/// Who computes a run.
pub struct Crew {
    /// Ranks that are threads of this process, and threads of each.
    each: [usize; 2],
    #[cfg(feature = "mpi")]
    world: Option<by_mpi::World>,
}

impl Crew {
    /// Those that the user or a launcher asks for.
    ///
    /// # Errors
    /// A launcher has started several of this program, and it knows no MPI: they would be equal runs that write into one folder.
    pub fn of(verb: &str, ranks: &Ranks, how: &How) -> Result<Self, Failure> {
        let size = ranks.ranks.map_or(1, usize::from);
        let threads = how.threads.map_or_else(|| (cores() / size).max(1), usize::from);
        let each = [size, threads];
        let launched = launched(|name| std::env::var(name).ok());
        #[cfg(feature = "mpi")]
        {
            let _ = verb;
            let world = if launched.is_some() { by_mpi::World::join()? } else { None };
            Ok(Self { each, world })
        }
        #[cfg(not(feature = "mpi"))]
        match launched {
            None => Ok(Self { each }),
            Some((name, value)) => Err(Failure::Input(format!(
                "a launcher has started several of this program ({name}={value}), and all would write into the same folder: this riprap is built \
                 without MPI. Build it with `cargo build --release -p riprap-cli --features mpi`, run `riprap {verb}` once with --threads, or, for \
                 runs that are independent and have folders of their own, put `env -u {name}` in front of it"
            ))),
        }
    }

    /// Whether one rank computes all.
    pub fn is_alone(&self) -> bool {
        #[cfg(feature = "mpi")]
        if self.world.is_some() {
            return false;
        }
        self.each[0] == 1
    }

    /// Whether this program speaks with the user: one rank of many does.
    pub fn speaks(&self) -> bool {
        #[cfg(feature = "mpi")]
        if let Some(world) = &self.world {
            return world.speaks();
        }
        true
    }

    /// Runs a job.
    ///
    /// # Errors
    /// As [`job::run`].
    pub fn run(
        &self,
        job: Job,
        folder: &Path,
        existing: Existing,
        look: &mut dyn FnMut(&mut Look<'_>) -> Control,
    ) -> Result<Outcome, JobError> {
        let [size, threads] = self.each;
        #[cfg(feature = "mpi")]
        if let Some(world) = &self.world {
            return job::run_among(job, folder, existing, world.peers(), threads, look);
        }
        match size {
            1 => job::run(job, folder, existing, threads, look),
            _ => job::run_ranks(job, folder, existing, [size, threads], look),
        }
    }

    /// Goes on with a run.
    ///
    /// # Errors
    /// As [`job::resume`].
    pub fn resume(
        &self,
        folder: &Path,
        look: &mut dyn FnMut(&mut Look<'_>) -> Control,
    ) -> Result<Outcome, JobError> {
        let [size, threads] = self.each;
        #[cfg(feature = "mpi")]
        if let Some(world) = &self.world {
            return job::resume_among(folder, world.peers(), threads, look);
        }
        if size > 1 {
            return job::resume_ranks(folder, [size, threads], look);
        }
        let live = Live::reopen(folder, threads)?;
        // Before the run, which may take days.
        for note in live.notes() {
            print_line("warning", note);
        }
        live.finish(look)
    }

    /// What comes of a run that could not be carried out: the other ranks of a launcher may wait for this one, and end with it.
    pub fn end<T>(&self, done: Result<T, Failure>) -> Result<T, Failure> {
        #[cfg(feature = "mpi")]
        if let (Some(world), Err(failure)) = (&self.world, &done) {
            // The others meet the same wall or miss this one: one of them says so.
            if world.speaks() {
                failure
                    .print(crate::diagnostics::Style::for_stderr(crate::args::ColorChoice::Auto));
            }
            world.abort(failure.code());
        }
        done
    }
}

/// How many programs a launcher has started: OpenMPI, MPICH and its kin, a step of Slurm. A batch job of Slurm that has room for several tasks
/// and has started none of them has no step.
const SIZES: [&str; 4] =
    ["OMPI_COMM_WORLD_SIZE", "MPI_LOCALNRANKS", "PMI_SIZE", "SLURM_STEP_NUM_TASKS"];
/// Which one of them this is, from 0.
const NUMBERS: [&str; 1] = ["PMIX_RANK"];

/// The variable by which a launcher says that it has started several programs, and its value.
fn launched(variable: impl Fn(&str) -> Option<String>) -> Option<(&'static str, String)> {
    let sizes = SIZES.map(|name| (name, 2));
    let numbers = NUMBERS.map(|name| (name, 1));
    sizes.into_iter().chain(numbers).find_map(|(name, least)| {
        let value = variable(name)?;
        (value.trim().parse::<u64>().ok()? >= least).then_some((name, value))
    })
}

#[cfg(test)]
mod tests {
    use super::launched;

    #[test]
    fn several_programs_of_a_launcher_are_seen_and_single_ones_are_not() {
        let of = |given: &'static [(&str, &str)]| {
            let find = |name: &str| given.iter().find(|(n, _)| *n == name);
            launched(move |name| find(name).map(|(_, value)| (*value).to_owned()))
        };
        for given in [
            &[("OMPI_COMM_WORLD_SIZE", "4"), ("OMPI_COMM_WORLD_RANK", "0")][..],
            &[("PMI_SIZE", "2"), ("PMI_RANK", "1")],
            &[("PMIX_RANK", "3")],
            &[("SLURM_NTASKS", "8"), ("SLURM_STEP_NUM_TASKS", "8")],
        ] {
            assert!(of(given).is_some(), "{given:?}");
        }
        for given in [
            &[][..],
            // A batch job with room for eight, one of an array, and a step of one.
            &[("SLURM_NTASKS", "8"), ("SLURM_PROCID", "0"), ("SLURM_JOB_ID", "7")],
            &[("SLURM_ARRAY_TASK_ID", "3"), ("SLURM_STEP_NUM_TASKS", "1"), ("PMIX_RANK", "0")],
            &[("OMPI_COMM_WORLD_SIZE", "1")],
        ] {
            assert_eq!(of(given), None, "{given:?}");
        }
    }
}
