//! Memory that a model needs, before it is made.

use super::builder::Builder;
use crate::scenario::language::{Block, Mechanics};
use crate::scenario::{Diagnostic, Span};

/// Bytes of a rigid block in a run: a lower bound, so that what fits is never refused (a lattice of a million bricks takes
/// 1,650 in `check` and more in a run).
const PER_BLOCK: f64 = 1500.0;
/// The same of a deformable block, whose nodes, tetrahedra and bonds count: bricks take 6,300 in `check` and in a run.
const PER_DEFORMABLE: f64 = 6000.0;

impl Builder<'_> {
    /// Whether the machine can hold that many blocks of a table more; an error at `span` if not.
    pub(super) fn has_memory(&mut self, block: &Block, count: f64, span: &Span) -> bool {
        let sets = self.spatial.deform.sets.iter();
        let deformable: usize = sets.map(|set| set.blocks.len()).sum();
        let rigid = self.spatial.blocks.len() + self.setup.blocks.len() - deformable;
        let per = match &block.mechanics {
            Some(Mechanics::Deformable(_)) => PER_DEFORMABLE,
            Some(Mechanics::Rigid(_)) | None => PER_BLOCK,
        };
        let before = PER_BLOCK * rigid as f64 + PER_DEFORMABLE * deformable as f64;
        let Some(refusal) = refusal(count, before + per * count, available()) else {
            return true;
        };
        let help = "make the blocks larger or the model smaller, or use a machine with more memory; in space [[refine]] \
                    gives small bricks where they are needed";
        let error = Diagnostic::error("memory", refusal).at(span.clone());
        self.found.push(error.help(help));
        false
    }
}

/// Why so many blocks more are too many where that many bytes are needed for them and those before, and so many are free.
fn refusal(blocks: f64, needed: f64, available: Option<f64>) -> Option<String> {
    let free = available.filter(|free| needed > *free)?;
    Some(format!(
        "with these {blocks:.0} blocks the model needs at least {:.1} GB of memory, {:.1} GB are free",
        1e-9 * needed,
        1e-9 * free
    ))
}

/// Free bytes: of the machine, and of what limits this process; `None` where nobody says.
fn available() -> Option<f64> {
    let read = |path: &str| std::fs::read_to_string(path).unwrap_or_default();
    let machine = free_of(&read("/proc/meminfo"));
    let limit = limit_of(&read("/proc/self/limits"));
    let group = group_of(
        &read("/sys/fs/cgroup/memory.max"),
        &read("/sys/fs/cgroup/memory.current"),
    );
    [machine, limit, group]
        .into_iter()
        .flatten()
        .reduce(f64::min)
}

/// `MemAvailable` of `/proc/meminfo`.
fn free_of(text: &str) -> Option<f64> {
    let line = text.lines().find_map(|l| l.strip_prefix("MemAvailable:"))?;
    let kib: f64 = line.split_whitespace().next()?.parse().ok()?;
    Some(1024.0 * kib)
}

/// The limit of the address space of `/proc/self/limits` (`ulimit -v`).
fn limit_of(text: &str) -> Option<f64> {
    let line = text
        .lines()
        .find_map(|l| l.strip_prefix("Max address space"))?;
    line.split_whitespace().next()?.parse().ok()
}

/// What a control group (a container) may still take.
fn group_of(most: &str, used: &str) -> Option<f64> {
    let [most, used] = [most, used].map(|text| text.trim().parse::<f64>().ok());
    Some((most? - used?).max(0.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_does_not_fit_is_refused_with_numbers() {
        let text = refusal(15_625_000.0, 23.4e9, Some(4e9)).unwrap();
        assert_eq!(
            text,
            "with these 15625000 blocks the model needs at least 23.4 GB of memory, 4.0 GB are free"
        );
        assert_eq!(refusal(1e6, 1.5e9, Some(4e9)), None);
        assert_eq!(refusal(1e12, 1.5e15, None), None);
    }

    #[test]
    fn free_memory_is_read_from_the_system() {
        let text = "MemTotal:       24000000 kB\nMemAvailable:   1000 kB\n";
        assert_eq!(free_of(text), Some(1_024_000.0));
        let text = "Limit  Soft Limit  Hard Limit  Units\nMax address space   4096000000   unlimited   bytes\n";
        assert_eq!(limit_of(text), Some(4.096e9));
        assert_eq!(
            limit_of("Max address space   unlimited   unlimited   bytes"),
            None
        );
        assert_eq!(group_of("max\n", "5\n"), None);
        assert_eq!(group_of("2000\n", "500\n"), Some(1500.0));
    }
}
