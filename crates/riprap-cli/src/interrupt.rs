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
                &format!("files that are too large will end riprap by a signal: {error}"),
            );
        }
    }
}

/// Whether the user has asked to stop.
#[derive(Clone)]
pub struct Interrupt(Arc<AtomicBool>);

impl Interrupt {
    /// Starts listening. Called once per process.
    pub fn listen() -> Result<Self, Failure> {
        let asked = Arc::new(AtomicBool::new(false));
        let flag = Arc::clone(&asked);
        ctrlc::set_handler(move || {
            if flag.swap(true, Ordering::SeqCst) {
                // The last checkpoint on disk is whole; nothing is lost but the steps since.
                std::process::exit(i32::from(crate::failure::INTERRUPTED));
            }
            diagnostics::say(
                "\nstopping at the next step with a checkpoint; Ctrl-C again quits at once",
            );
        })
        .map_err(|e| Failure::Input(format!("could not listen for Ctrl-C: {e}")))?;
        Ok(Interrupt(asked))
    }

    /// Whether to stop.
    pub fn asked(&self) -> bool {
        self.0.load(Ordering::SeqCst)
    }
}
