//! Ctrl-C (and a polite kill): the first asks the run to stop, the second quits.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use crate::diagnostics;
use crate::failure::Failure;

/// A file that would outgrow the limit of the process (`ulimit -f`) is an error of writing, as a full disk is, and not the end
/// by a signal. Called once, before threads are made: they inherit it.
pub fn let_full_files_be_errors() {
    #[cfg(unix)]
    {
        use nix::sys::signal::{SigSet, Signal};
        let mut signals = SigSet::empty();
        signals.add(Signal::SIGXFSZ);
        if let Err(error) = signals.thread_block() {
            diagnostics::print_line(
                "note",
                &format!(
                    "could not block SIGXFSZ, so riprap will be terminated when a file exceeds the size limit: {error}"
                ),
            );
        }
    }
}

/// Whether the user has asked to stop.
#[derive(Clone)]
pub struct Interrupt {
    asked: Arc<AtomicBool>,
    /// Whether there is something to save: before, nothing is lost by quitting at once.
    begun: Arc<AtomicBool>,
}

impl Interrupt {
    /// Starts listening. Called once per process.
    pub fn listen() -> Result<Self, Failure> {
        let interrupt = Self::listen_from_begin(String::new)?;
        interrupt.begin();
        Ok(interrupt)
    }

    /// The same for work that takes long to build: until [`Interrupt::begin`] the first Ctrl-C quits at once, with these words.
    pub fn listen_from_begin(early: impl Fn() -> String + Send + 'static) -> Result<Self, Failure> {
        let interrupt = Self { asked: Arc::default(), begun: Arc::default() };
        let shared = interrupt.clone();
        ctrlc::set_handler(move || {
            if !shared.begun.load(Ordering::SeqCst) {
                diagnostics::say(&format!("\n{}", early()));
                quit();
            }
            if shared.asked.swap(true, Ordering::SeqCst) {
                // The last checkpoint on disk is whole; nothing is lost but the steps since.
                quit();
            }
            diagnostics::say(
                "\nstopping at the next step and writing a checkpoint; press Ctrl-C again to quit at once",
            );
        })
        .map_err(|e| Failure::Input(format!("could not listen for Ctrl-C: {e}")))?;
        Ok(interrupt)
    }

    /// Leaves it to another rank of the run when to stop: a launcher passes the signal on to all.
    pub fn leave_to_another() -> Result<(), Failure> {
        ctrlc::set_handler(|| ())
            .map_err(|e| Failure::Input(format!("could not listen for Ctrl-C: {e}")))
    }

    /// From here on the first Ctrl-C asks, and what has been done is saved.
    pub fn begin(&self) {
        self.begun.store(true, Ordering::SeqCst);
    }

    /// Whether to stop.
    pub fn asked(&self) -> bool {
        self.asked.load(Ordering::SeqCst)
    }
}

fn quit() -> ! {
    std::process::exit(i32::from(crate::failure::INTERRUPTED))
}
