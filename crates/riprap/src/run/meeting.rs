//! What of a model can meet in space, and what passes through: in words, for `check` and for the end of a run.

use super::engine::View;
use crate::spatial::contacts;

/// That found contact is off, where there are blocks that no joint holds together.
pub(super) fn off(view: &View<'_>) -> Option<String> {
    let view = view.spatial()?;
    let meeting = contacts::meeting(view.world);
    let loose = meeting.seekers > 0 && view.living().nth(1).is_some();
    (loose && !meeting.on).then(|| {
        format!(
            "found contact is off (`space.spatial.found_contacts`): {} blocks that are not joined to the others, or no longer, pass through them",
            meeting.seekers
        )
    })
}

/// What a user must know of blocks that do not act on each other, or act otherwise than one would think.
pub(super) fn words(view: &View<'_>) -> Vec<String> {
    let mut found: Vec<String> = off(view).into_iter().collect();
    let Some(world) = view.spatial().map(|v| v.world) else {
        return found;
    };
    let meeting = contacts::meeting(world);
    if !meeting.on {
        return found;
    }
    if meeting.seekers > 0 && world.setup.periodic.iter().any(Option::is_some) {
        found.push(
            "blocks that come loose do not meet across the ends of the periodic model: they pass through each other there".to_owned(),
        );
    }
    if meeting.seekers > 0 && !meeting.sticking.is_empty() {
        found.push(format!(
            "blocks that meet under {} never slide on each other: an elastic interface says nothing of friction; give its `friction_angle`",
            meeting.sticking.join(", ")
        ));
    }
    found
}
