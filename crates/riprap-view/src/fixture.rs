//! Runs for tests.

use riprap_record::exec::Exec;
use riprap_record::{Column, Ended, Existing, Frame, Manifest, RunFolder};
use std::path::Path;

/// A run of one triangle that moves, with so many frames.
pub(crate) fn write_run(path: &Path, frames: usize) {
    let mut manifest = Manifest::default();
    let mut run = RunFolder::create(path, Existing::Refuse, &manifest).unwrap();
    for k in 0..frames {
        let shift = 0.1 * k as f64;
        let frame = Frame {
            step: 10 * k as u64,
            time: 1e-3 * k as f64,
            points: vec![[shift, 0.0, 0.0], [shift + 1.0, 0.0, 0.0], [shift, 1.0, 0.0]],
            offsets: vec![0, 3],
            block_columns: vec![
                Column::scalar("block", "-", vec![0.0]),
                Column::vector("displacement", "m", [[shift, 0.0]]),
            ],
            ..Frame::default()
        };
        run.frame(&frame, &Exec::serial()).unwrap();
    }
    manifest.ended = Ended::Finished;
    run.write_manifest(&manifest).unwrap();
}
