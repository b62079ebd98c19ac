//! What a thread has computed: time that neither another load of the machine nor a clock that is set changes.

use std::time::Duration;

/// CPU time of the present thread since [`Work::begin`]. Where the system has no clock for it (any but Unix), time that has passed.
#[derive(Clone, Copy, Debug)]
pub struct Work {
    begun: Moment,
}

impl Work {
    /// Begins to count.
    #[must_use]
    pub fn begin() -> Self {
        Self { begun: now() }
    }

    /// What this thread has computed since. Of another thread than that which began it means nothing.
    #[must_use]
    pub fn done(&self) -> Duration {
        since(self.begun)
    }
}

#[cfg(unix)]
type Moment = Duration;
#[cfg(not(unix))]
type Moment = std::time::Instant;

/// POSIX has had the clock since 2001; a system that refuses it has counted nothing, which the caller must bear with.
#[cfg(unix)]
fn now() -> Moment {
    use nix::time::{ClockId, clock_gettime};
    clock_gettime(ClockId::CLOCK_THREAD_CPUTIME_ID).map_or(Duration::ZERO, Duration::from)
}

#[cfg(unix)]
fn since(begun: Moment) -> Duration {
    now().saturating_sub(begun)
}

#[cfg(not(unix))]
fn now() -> Moment {
    std::time::Instant::now()
}

#[cfg(not(unix))]
fn since(begun: Moment) -> Duration {
    begun.elapsed()
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
