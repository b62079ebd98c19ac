//! Writing on a thread of its own: who encodes a state does not wait for the disk, and the disk begins before all is encoded.

use std::fs::File;
use std::io::{self, Write};
use std::panic::resume_unwind;
use std::sync::mpsc::{Receiver, Sender, SyncSender, channel, sync_channel};
use std::thread;

/// Pieces that may wait for the disk.
const AHEAD: usize = 4;
/// Bytes after which the disk is asked to write what it has, so that little remains at the end.
const PORTION: usize = 64 << 20;

/// A file that is written by another thread.
pub(super) struct Behind {
    full: SyncSender<Vec<u8>>,
    /// Pieces that have been written, to be filled again.
    empty: Receiver<Vec<u8>>,
}

impl Write for Behind {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let mut piece = self.empty.try_recv().unwrap_or_default();
        piece.clear();
        piece.extend_from_slice(bytes);
        match self.full.send(piece) {
            Ok(()) => Ok(bytes.len()),
            // Its own error is what is reported.
            Err(_) => Err(io::ErrorKind::BrokenPipe.into()),
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

/// Lets `make` write into a file; returns when all of it has been written.
pub(super) fn behind<T>(
    file: &mut File,
    make: impl FnOnce(&mut Behind) -> io::Result<T>,
) -> io::Result<T> {
    let (full, pieces) = sync_channel(AHEAD);
    let (back, empty) = channel();
    thread::scope(|scope| {
        let disk = thread::Builder::new()
            .name("checkpoint".to_owned())
            .spawn_scoped(scope, move || take(file, &pieces, &back))?;
        let mut writer = Behind { full, empty };
        let made = make(&mut writer);
        // The end, for the other thread.
        drop(writer);
        disk.join().unwrap_or_else(|panic| resume_unwind(panic))?;
        made
    })
}

fn take(file: &mut File, pieces: &Receiver<Vec<u8>>, back: &Sender<Vec<u8>>) -> io::Result<()> {
    let mut waiting = 0;
    for piece in pieces {
        file.write_all(&piece)?;
        waiting += piece.len();
        if waiting >= PORTION {
            file.sync_data()?;
            waiting = 0;
        }
        // Nobody may want it any more.
        let _ = back.send(piece);
    }
    Ok(())
}
