//! Ranks that a launcher has started, by MPI (`mpirun -n 4 riprap run scene.toml`).
//!
//! MPI is asked from the main thread alone. A rank that is killed is noticed by the launcher, which ends the others and says which it was.

use std::sync::Arc;

use mpi::environment::Universe;
use mpi::topology::SimpleCommunicator;
use mpi::traits::{Communicator, Destination, Source};
use mpi::{Count, Threading};
use riprap::peers::{Gone, Link, Message, Peers};

use crate::failure::Failure;

/// MPI, until it is dropped.
pub struct World {
    universe: Universe,
}

impl World {
    /// The ranks that a launcher has started; `None` where there is this one alone.
    ///
    /// # Errors
    /// MPI does not start.
    pub fn join() -> Result<Option<Self>, Failure> {
        let begun = mpi::initialize_with_threading(Threading::Funneled);
        let Some((universe, _)) = begun else {
            return Err(Failure::Input("MPI did not start: it has been started before".to_owned()));
        };
        let world = Self { universe };
        Ok((world.universe.world().size() > 1).then_some(world))
    }

    /// The ranks.
    pub fn peers(&self) -> Arc<Peers> {
        Arc::new(Peers::new(Box::new(ByMpi)))
    }

    /// Whether this is the rank that speaks with the user.
    pub fn speaks(&self) -> bool {
        self.universe.world().rank() == 0
    }

    /// Ends all ranks with an exit code: others may wait for this one.
    pub fn abort(&self, code: u8) -> ! {
        self.universe.world().abort(i32::from(code))
    }
}

/// Messages longer than this go in parts: the numbers of MPI are of 32 bits.
const PART: usize = 1 << 30;

#[derive(Debug)]
struct ByMpi;

impl ByMpi {
    fn world() -> SimpleCommunicator {
        SimpleCommunicator::world()
    }

    /// The message in parts, of which the last alone is shorter than a whole one.
    fn parts(message: &Message) -> impl Iterator<Item = &[u8]> {
        let count = message.len() / PART + 1;
        (0..count).map(|k| &message[k * PART..message.len().min((k + 1) * PART)])
    }
}

impl Link for ByMpi {
    fn rank(&self) -> usize {
        Self::world().rank().unsigned_abs() as usize
    }

    fn size(&self) -> usize {
        Self::world().size().unsigned_abs() as usize
    }

    fn send(&self, to: usize, message: &Message) -> Result<(), Gone> {
        // The receiver waits for it: only rank 0 sends, and the others have nothing else to do.
        for part in Self::parts(message) {
            Self::world().process_at_rank(to as Count).send(part);
        }
        Ok(())
    }

    fn receive(&self, from: usize) -> Result<Message, Gone> {
        let mut message = Vec::new();
        loop {
            let (mut part, _) = Self::world().process_at_rank(from as Count).receive_vec::<u8>();
            let last = part.len() < PART;
            if message.is_empty() {
                message = part;
            } else {
                message.append(&mut part);
            }
            if last {
                return Ok(Arc::new(message));
            }
        }
    }

    fn exchange(&self, to: &[Message]) -> Result<Vec<Message>, usize> {
        let (rank, size) = (self.rank(), self.size());
        let world = Self::world();
        let others = || (1..size).map(|k| (rank + k) % size);
        mpi::request::scope(|scope| {
            let mut sends = Vec::new();
            for other in others() {
                for part in Self::parts(&to[other]) {
                    sends.push(world.process_at_rank(other as Count).immediate_send(scope, part));
                }
            }
            let from = |other: usize| match other == rank {
                true => Ok(to[rank].clone()),
                false => self.receive(other).map_err(|Gone| other),
            };
            let received = (0..size).map(from).collect();
            for send in sends {
                send.wait();
            }
            received
        })
    }
}
