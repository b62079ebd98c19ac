//! Ranks: programs that compute one model together, each with the whole model in its memory.
//!
//! A [`Link`] carries messages between them: channels between threads of one process ([`channels`]), or MPI. [`Peers`] is
//! what the program calls: gathering, an order from rank 0, agreement. A rank that is gone is noted once and ends the run: from
//! then on nothing is sent or waited for, and whoever drives the run asks for the [`Trouble`] before anything of the
//! state is written. So stages need no error of their own.

use std::fmt::Debug;
use std::sync::mpsc::{Receiver, Sender, channel};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

use serde::Serialize;
use serde::de::DeserializeOwned;

/// Bytes on their way; shared, since the same ones often go to all.
pub type Message = Arc<Vec<u8>>;

/// Carries messages between ranks. Messages from one rank to another arrive in the order in which they were sent.
pub trait Link: Debug + Send + Sync {
    /// Number of this rank, from 0.
    fn rank(&self) -> usize;

    /// Number of ranks.
    fn size(&self) -> usize;

    /// Sends without waiting for the receiver.
    ///
    /// # Errors
    /// The other rank is gone.
    fn send(&self, to: usize, message: &Message) -> Result<(), Gone>;

    /// Waits for the next message of a rank.
    ///
    /// # Errors
    /// The other rank is gone.
    fn receive(&self, from: usize) -> Result<Message, Gone>;

    /// Sends `to[r]` to each rank r and waits for the message of each; its own for this one.
    ///
    /// # Errors
    /// The number of a rank that is gone.
    fn exchange(&self, to: &[Message]) -> Result<Vec<Message>, usize> {
        let (rank, size) = (self.rank(), self.size());
        // Not all to rank 0 first.
        for other in (1..size).map(|k| (rank + k) % size) {
            self.send(other, &to[other]).map_err(|Gone| other)?;
        }
        let from = |other: usize| match other == rank {
            true => Ok(to[rank].clone()),
            false => self.receive(other).map_err(|Gone| other),
        };
        (0..size).map(from).collect()
    }
}

/// The other rank no longer answers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Gone;

/// Why ranks cannot go on together.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum Trouble {
    /// A rank has ended.
    #[error(
        "rank {rank} of {size} no longer answers; what it wrote before it ended says why, if anything does; the last checkpoint is whole"
    )]
    Gone {
        /// Which.
        rank: usize,
        /// Of how many.
        size: usize,
    },
    /// Ranks do not agree.
    #[error("{}: {what}", differ(.ranks, *.size))]
    Differs {
        /// Those that differ from most others.
        ranks: Vec<usize>,
        /// Of how many.
        size: usize,
        /// In what.
        what: String,
    },
    /// A message cannot be read: another program has sent it.
    #[error("a message of rank {rank} cannot be read: it is not the same program")]
    Unreadable {
        /// Of which.
        rank: usize,
    },
}

/// `rank 2 of 3 differs from the others`.
fn differ(ranks: &[usize], size: usize) -> String {
    let numbers: Vec<String> = ranks.iter().map(usize::to_string).collect();
    let (s, differ) = if ranks.len() == 1 { ("", "differs") } else { ("s", "differ") };
    format!("rank{s} {} of {size} {differ} from the others", numbers.join(", "))
}

/// What has been sent by one rank.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Traffic {
    /// Messages.
    pub messages: u64,
    /// Bytes in them.
    pub bytes: u64,
    /// Time spent sending and waiting for others.
    pub waiting: Duration,
    /// Number of ranks.
    pub ranks: usize,
}

#[derive(Debug, Default)]
struct State {
    trouble: Option<Trouble>,
    traffic: Traffic,
}

/// The ranks that compute a model together, as one of them sees them.
#[derive(Debug)]
pub struct Peers {
    link: Box<dyn Link>,
    state: Mutex<State>,
}

impl Peers {
    /// Ranks behind a link.
    #[must_use]
    pub fn new(link: Box<dyn Link>) -> Self {
        Self { link, state: Mutex::default() }
    }

    /// Number of this rank, from 0.
    #[must_use]
    pub fn rank(&self) -> usize {
        self.link.rank()
    }

    /// Number of ranks.
    #[must_use]
    pub fn size(&self) -> usize {
        self.link.size()
    }

    /// Why they cannot go on, if they cannot.
    #[must_use]
    pub fn trouble(&self) -> Option<Trouble> {
        self.state().trouble.clone()
    }

    /// What this rank has sent so far.
    #[must_use]
    pub fn traffic(&self) -> Traffic {
        Traffic { ranks: self.size(), ..self.state().traffic }
    }

    /// The message of each rank to all, in the order of the ranks; `None` once there is trouble.
    #[must_use]
    pub fn gather(&self, own: Vec<u8>) -> Option<Vec<Message>> {
        let own: Message = Arc::new(own);
        let to: Vec<Message> = (0..self.size()).map(|_| own.clone()).collect();
        self.exchange(to)
    }

    /// Sends `to[r]` to each rank r, and gives what each has sent to this one, in the order of the ranks; `None` once there is trouble.
    ///
    /// # Panics
    /// Without a message for each rank.
    #[must_use]
    pub fn exchange(&self, to: Vec<Message>) -> Option<Vec<Message>> {
        assert_eq!(to.len(), self.size(), "a message for each rank");
        if self.state().trouble.is_some() {
            return None;
        }
        let begun = Instant::now();
        let from = self.link.exchange(&to);
        let rank = self.rank();
        for (_, message) in to.iter().enumerate().filter(|(other, _)| *other != rank) {
            self.book(message);
        }
        self.state().traffic.waiting += begun.elapsed();
        from.map_err(|rank| self.note(Trouble::Gone { rank, size: self.size() })).ok()
    }

    /// What rank 0 says: the others get `order` of rank 0 in place of theirs, which they need not have; `None` once there is trouble.
    pub fn order<T: Serialize + DeserializeOwned>(&self, order: Option<T>) -> Option<T> {
        if self.state().trouble.is_some() {
            return None;
        }
        if self.rank() > 0 {
            let begun = Instant::now();
            let received = self.link.receive(0);
            let message = self.noted(0, received)?;
            self.state().traffic.waiting += begun.elapsed();
            return self.read(0, &message);
        }
        let order = order?;
        let message: Message = Arc::new(bytes_of(&order));
        for other in 1..self.size() {
            let sent = self.link.send(other, &message);
            self.book(&message);
            self.noted(other, sent)?;
        }
        Some(order)
    }

    /// Waits until all have come so far.
    pub fn meet(&self) {
        let _ = self.gather(Vec::new());
    }

    /// Looks whether all ranks have the same `value`; those that differ from most (from rank 0, where none is in the majority) are named in the trouble,
    /// with `what` they differ in.
    pub fn agree(&self, what: &str, value: &str) {
        let Some(all) = self.gather(value.as_bytes().to_vec()) else {
            return;
        };
        let count = |one: &Message| all.iter().filter(|other| *other == one).count();
        // The first of the most frequent.
        let most = all.iter().rev().max_by_key(|one| count(one));
        let ranks: Vec<usize> = (0..all.len()).filter(|r| Some(&all[*r]) != most).collect();
        if !ranks.is_empty() {
            let (size, what) = (self.size(), what.to_owned());
            self.note(Trouble::Differs { ranks, size, what });
        }
    }

    /// A value in a message of a rank; `None` and trouble where it cannot be read.
    pub fn read<T: DeserializeOwned>(&self, from: usize, message: &[u8]) -> Option<T> {
        let value = value_of(message);
        if value.is_none() {
            self.note(Trouble::Unreadable { rank: from });
        }
        value
    }

    /// Notes the first trouble: what comes later follows from it.
    pub fn note(&self, trouble: Trouble) {
        self.state().trouble.get_or_insert(trouble);
    }

    fn noted<T>(&self, rank: usize, result: Result<T, Gone>) -> Option<T> {
        if result.is_err() {
            self.note(Trouble::Gone { rank, size: self.size() });
        }
        result.ok()
    }

    fn book(&self, message: &Message) {
        let mut state = self.state();
        state.traffic.messages += 1;
        state.traffic.bytes += message.len() as u64;
    }

    fn state(&self) -> MutexGuard<'_, State> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// A value as a message.
#[must_use]
pub fn bytes_of<T: Serialize>(value: &T) -> Vec<u8> {
    // What is sent are numbers and lists, which always can be written.
    postcard::to_stdvec(value).unwrap_or_default()
}

/// The value in a message of [`bytes_of`], if there is one.
#[must_use]
pub fn value_of<T: DeserializeOwned>(message: &[u8]) -> Option<T> {
    postcard::from_bytes(message).ok()
}

/// Appends numbers to a message.
pub fn put(message: &mut Vec<u8>, numbers: &[f64]) {
    // Room first: appending one by one takes several times as long.
    let at = message.len();
    message.resize(at + 8 * numbers.len(), 0);
    for (bytes, x) in message[at..].as_chunks_mut().0.iter_mut().zip(numbers) {
        *bytes = x.to_le_bytes();
    }
}

/// Takes numbers from the front of a message; those that it does not have stay as they are.
pub fn take(message: &mut &[u8], numbers: &mut [f64]) {
    let (own, rest) = message.split_at((8 * numbers.len()).min(message.len()));
    for (x, bytes) in numbers.iter_mut().zip(own.as_chunks().0) {
        *x = f64::from_le_bytes(*bytes);
    }
    *message = rest;
}

/// Threads of one process as ranks.
#[derive(Debug)]
struct Channels {
    rank: usize,
    /// To each rank, this one included.
    to: Vec<Sender<Message>>,
    from: Vec<Mutex<Receiver<Message>>>,
}

impl Link for Channels {
    fn rank(&self) -> usize {
        self.rank
    }

    fn size(&self) -> usize {
        self.to.len()
    }

    fn send(&self, to: usize, message: &Message) -> Result<(), Gone> {
        self.to[to].send(message.clone()).map_err(|_| Gone)
    }

    fn receive(&self, from: usize) -> Result<Message, Gone> {
        let from = self.from[from].lock().unwrap_or_else(PoisonError::into_inner);
        from.recv().map_err(|_| Gone)
    }
}

/// Links between `size` threads of one process, one for each.
#[must_use]
pub fn channels(size: usize) -> Vec<Box<dyn Link>> {
    let mut to: Vec<Vec<Sender<Message>>> = (0..size).map(|_| Vec::new()).collect();
    let mut from: Vec<Vec<Mutex<Receiver<Message>>>> = (0..size).map(|_| Vec::new()).collect();
    for sender in &mut to {
        for receiver in &mut from {
            let (send, receive) = channel();
            sender.push(send);
            receiver.push(Mutex::new(receive));
        }
    }
    let ends = to.into_iter().zip(from).enumerate();
    ends.map(|(rank, (to, from))| -> Box<dyn Link> { Box::new(Channels { rank, to, from }) })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn each<R: Send>(size: usize, work: impl Fn(Peers) -> R + Sync) -> Vec<R> {
        std::thread::scope(|scope| {
            let run = |link| scope.spawn(|| work(Peers::new(link)));
            let threads: Vec<_> = channels(size).into_iter().map(run).collect();
            threads.into_iter().map(|thread| thread.join().unwrap()).collect()
        })
    }

    #[test]
    fn all_get_what_each_has_sent() {
        for size in [1, 2, 5] {
            let seen = each(size, |peers| {
                let all = peers.gather(vec![peers.rank() as u8; peers.rank()]).unwrap();
                let order = peers.order((peers.rank() == 0).then_some(0.1)).unwrap();
                let mut message = Vec::new();
                put(&mut message, &[order, f64::NAN]);
                let mut back = [0.0; 3];
                take(&mut &message[..], &mut back);
                assert_eq!(back.map(f64::to_bits), [0.1, f64::NAN, 0.0].map(f64::to_bits));
                peers.agree("the same", "x");
                assert_eq!(peers.trouble(), None);
                let sent = peers.traffic().messages as usize;
                let orders = if peers.rank() == 0 { size - 1 } else { 0 };
                assert_eq!(sent, 2 * (size - 1) + orders);
                all.iter().map(|m| m.len()).collect::<Vec<_>>()
            });
            assert!(seen.iter().all(|lengths| *lengths == (0..size).collect::<Vec<_>>()));
        }
    }

    #[test]
    fn a_rank_that_is_gone_or_differs_is_named() {
        let troubles = each(3, |peers| {
            if peers.rank() == 1 {
                return None;
            }
            while peers.gather(vec![1]).is_some() {}
            // Nobody waits any more.
            assert!(peers.order(Some(1u8)).is_none());
            peers.trouble()
        });
        assert_eq!(troubles[0], Some(Trouble::Gone { rank: 1, size: 3 }));
        assert!(
            troubles[0].as_ref().unwrap().to_string().starts_with("rank 1 of 3 no longer answers")
        );
        let troubles = each(3, |peers| {
            peers.agree("the state", if peers.rank() == 2 { "b" } else { "a" });
            peers.trouble().map(|t| t.to_string())
        });
        let words = "rank 2 of 3 differs from the others: the state";
        assert!(troubles.iter().all(|t| t.as_deref() == Some(words)), "{troubles:?}");
    }
}
