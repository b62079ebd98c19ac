//! Models before their first step, as run folders to be looked at.

use std::path::Path;

use super::{Job, JobError, Live, Pause};
use crate::exec::Exec;
use crate::plan::Every;
use crate::record::folder::Existing;
use crate::record::frame::Column;
use crate::record::manifest::FieldNote;
use crate::run::drive::Control;
use crate::run::engine::View;
#[cfg(feature = "scenario")]
use crate::run::forecast::doubts;

/// Writes the model as it stands before its first step into `folder`, to be looked at. It stays in use as long as what is
/// returned lives.
///
/// # Errors
/// As [`super::run`].
pub fn preview(mut job: Job, folder: &Path) -> Result<Live, JobError> {
    if job.plan.frames == Some(Every::Never) {
        job.plan.frames = None;
    }
    let mut live = begun(job, folder, Existing::Force)?;
    // The page lists what `riprap check` would say of a scene.
    #[cfg(feature = "scenario")]
    {
        let stable = live.drive.stable();
        let simulation = live.drive.simulation();
        let doubts = doubts(simulation, simulation.plan(), stable);
        live.manifest.warnings.extend(doubts);
    }
    if let Some(recorder) = live.drive.recorder() {
        recorder.folder.write_manifest(&live.manifest)?;
    }
    Ok(live)
}

/// Writes one picture of the model as its first phase begins, with further columns of its blocks, their meaning beside them.
///
/// # Errors
/// As [`super::run`].
pub(in crate::run) fn picture(
    mut job: Job,
    folder: &Path,
    existing: Existing,
    columns: &dyn Fn(&View<'_>) -> Vec<(Column, &'static str)>,
) -> Result<(), JobError> {
    job.plan.frames = Some(Every::Never);
    job.plan.histories.clear();
    let mut live = begun(job, folder, existing)?;
    let simulation = live.drive.simulation();
    let view = simulation.view();
    let mut frame = view.frame(simulation.phase().map_or("", |phase| phase.name.as_str()));
    for (column, meaning) in columns(&view) {
        let (name, unit) = (column.name.clone(), column.unit.clone());
        live.manifest.fields.push(FieldNote { name, unit, meaning: meaning.to_owned() });
        frame.block_columns.push(column);
    }
    if let Some(recorder) = live.drive.recorder() {
        recorder.folder.frame(&frame, &Exec::serial())?;
        recorder.folder.write_manifest(&live.manifest)?;
    }
    Ok(())
}

/// A run that stands at the beginning of its first phase.
fn begun(mut job: Job, folder: &Path, existing: Existing) -> Result<Live, JobError> {
    job.manifest.preview = true;
    job.checks.clear();
    let mut live = Live::begin(job, folder, existing, 1)?;
    let first = Pause { step: Some(0), time: None };
    live.advance(first, &mut |_| Control::Continue)?;
    Ok(live)
}
