//! Times of the stages, as a manifest has them.

use crate::profile::Spent;
use crate::record::manifest::StageTime;
use crate::run::engine::Engine;

/// What the stages have taken in `calls` steps of this process; last, where there are other ranks, the part of it in which this one has
/// waited for them.
pub(super) fn stages(engine: &Engine, calls: u64) -> Vec<StageTime> {
    let time = |name: &str, Spent { wall, pooled }| {
        let [seconds, pooled] = [wall, pooled].map(|time| time.as_secs_f64());
        StageTime { name: name.to_owned(), seconds, pooled, calls }
    };
    let stages = engine.profile().stages().iter().map(|(name, spent)| time(name, *spent));
    let waiting = engine.exec().peers().map(|peers| {
        let wall = peers.traffic().waiting;
        time("waiting for ranks", Spent { wall, ..Spent::default() })
    });
    stages.chain(waiting).collect()
}
