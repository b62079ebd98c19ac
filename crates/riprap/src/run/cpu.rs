//! What a thread has computed: time that neither another load of the machine nor a clock that is set changes.

use std::time::{Duration, Instant};

/// CPU time of the present thread since [`Work::begin`]; time that has passed where the system has no clock for it or refuses it.
#[derive(Clone, Copy, Debug)]
pub struct Work {
    begun: Instant,
    computed: Option<Duration>,
}

impl Work {
    /// Begins to count.
    #[must_use]
    pub fn begin() -> Self {
        Self { begun: Instant::now(), computed: computed() }
    }

    /// What this thread has computed since. Of another thread than that which began it means nothing.
    #[must_use]
    pub fn done(&self) -> Duration {
        match self.computed.zip(computed()) {
            Some((before, now)) => now.saturating_sub(before),
            None => self.begun.elapsed(),
        }
    }
}

/// What this thread has computed so far.
#[cfg(unix)]
fn computed() -> Option<Duration> {
    use nix::time::{ClockId, clock_gettime};
    let now = clock_gettime(ClockId::CLOCK_THREAD_CPUTIME_ID);
    now.ok().map(Duration::from)
}

#[cfg(not(unix))]
fn computed() -> Option<Duration> {
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    #[cfg(unix)]
    fn sleep_is_no_work() {
        let work = Work::begin();
        std::thread::sleep(Duration::from_millis(200));
        let slept = work.done();
        assert!(slept < Duration::from_millis(100), "{slept:?}");
        let mut sum = 0u64;
        while work.done() < slept + Duration::from_millis(20) {
            sum = std::hint::black_box(sum + 1);
        }
        assert!(sum > 0);
    }
}
