//! What depends on a clock or on the user is decided by rank 0; the others do as it says. A run that is not shared is its own rank 0.

use std::time::{Duration, Instant};

use serde::{Deserialize, Serialize};

use super::look::afford;
use super::{AUTOSAVE, Control, Drive, DriveError, Look};
use crate::peers::Peers;

/// What comes between two steps.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub(super) enum Order {
    /// The next step.
    GoOn,
    /// A checkpoint, because the last one was long ago.
    Save,
    /// A checkpoint, and the end.
    Stop,
}

impl Drive {
    fn peers(&self) -> Option<&Peers> {
        self.simulation.engine().exec().peers().map(|peers| &**peers)
    }

    /// Whether this is the rank that writes the results and speaks with the user.
    pub(super) fn writes(&self) -> bool {
        self.peers().is_none_or(|peers| peers.rank() == 0)
    }

    /// # Errors
    /// The ranks cannot go on together.
    pub(super) fn sound(&self) -> Result<(), DriveError> {
        let trouble = self.peers().and_then(Peers::trouble);
        trouble.map_or(Ok(()), |trouble| Err(trouble.into()))
    }

    /// Makes sure that all ranks have the same state, bit for bit, before it is saved.
    ///
    /// # Errors
    /// Those that differ.
    pub(super) fn agree(&self) -> Result<(), DriveError> {
        if let Some(peers) = self.peers() {
            let what = format!(
                "the state at step {} is not the same bits, and is not saved; earlier checkpoints stay",
                self.simulation.steps()
            );
            peers.agree(&what, &self.simulation.engine().hash());
        }
        self.sound()
    }

    /// A look of the caller at the end of the run.
    pub(super) fn show(&mut self, look: &mut dyn FnMut(&mut Look<'_>) -> Control) {
        if self.writes() {
            if self.simulation.is_shared() {
                // All know the end of a phase.
                self.clock.permit(Some(Duration::ZERO));
            }
            self.clock.look(&self.simulation, look);
        }
    }

    /// Whether nobody reads the present state, once its forces are found, but those who look every now and then: only several ranks gain
    /// by that.
    pub(super) fn passes_unread(&self) -> bool {
        let simulation = &self.simulation;
        simulation.is_shared()
            && !self.told
            && self.recorder.as_ref().is_none_or(|recorder| !recorder.is_due(simulation))
            && self.watched.iter().all(|watched| !watched.is_due(simulation, false, false))
    }

    /// What is to be done before the next step. The word of rank 0 says too before which step nobody asks again, so that most steps
    /// need none.
    pub(super) fn order(
        &mut self,
        look: &mut dyn FnMut(&mut Look<'_>) -> Control,
    ) -> Result<Order, DriveError> {
        let step = self.simulation.steps();
        if step < self.clock.next() {
            return Ok(Order::GoOn);
        }
        let due = self
            .writes()
            .then(|| (self.clock.due(step), self.clock.may_measure(), self.clock.next()));
        let due = match self.peers() {
            Some(peers) => peers.order(due),
            None => due,
        };
        self.sound()?;
        let Some((true, measures, _)) = due else {
            self.clock.set_next(due.map_or(step, |(_, _, next)| next));
            return Ok(Order::GoOn);
        };
        if self.simulation.is_shared() {
            // Measuring needs the whole state, which ranks must help each other to know.
            let begun = Instant::now();
            if measures {
                self.simulation.settle();
            }
            self.clock.permit(measures.then(|| begun.elapsed()));
        }
        let own = self.writes().then(|| (self.decide(look), self.clock.next()));
        let Some(peers) = self.peers() else {
            return Ok(own.map_or(Order::GoOn, |(order, _)| order));
        };
        let word = peers.order(own);
        self.sound()?;
        let (order, next) = word.unwrap_or((Order::GoOn, step));
        self.clock.set_next(next);
        Ok(order)
    }

    fn decide(&mut self, look: &mut dyn FnMut(&mut Look<'_>) -> Control) -> Order {
        let control = self.clock.look(&self.simulation, look);
        let pause = AUTOSAVE.max(afford(self.saving));
        match control {
            Control::Stop => Order::Stop,
            Control::Continue if self.recorder.is_some() && self.saved.elapsed() >= pause => {
                Order::Save
            }
            Control::Continue => Order::GoOn,
        }
    }
}
