//! Memory that a model needs: the least, before it is made, and what a run of it will take.

use super::builder::Builder;
use crate::scenario::language::{Block, Mechanics};
use crate::scenario::{Diagnostic, Span};

/// Bytes of a program without blocks.
const PROGRAM: f64 = 20e6;
/// Bytes of a brick with its joints, of any block where nothing more is known of it.
const BRICK: f64 = 1500.0;
/// Of each corner of another block in space, of each joint of such blocks.
const CORNER: f64 = 700.0;
const JOINT: f64 = 800.0;
/// Of a block that can meet others, of each pair that is near.
const MEETS: f64 = 850.0;
const NEAR: f64 = 1000.0;
/// Of a deformable block with its nodes and tetrahedra, of each bond of its faces.
const DEFORMABLE: f64 = 4000.0;
/// Of each corner of a deformable block that is no brick: its tetrahedra are its own, no other block shares them.
const OWN_CORNER: f64 = 2800.0;
const BOND: f64 = 1700.0;
/// In the plane of each corner, of each pair that is near.
const FLAT_CORNER: f64 = 350.0;
const FLAT_NEAR: f64 = 600.0;
/// What writing a picture or a checkpoint takes for a while: bytes of a rigid and of a deformable block, and the most that stays.
const WRITTEN: [f64; 2] = [1200.0, 3000.0];
const WRITTEN_MOST: f64 = 25e6;

/// Of each piece of a bolt.
const BOLT_PIECE: f64 = 400.0;

/// What of a model takes memory.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Parts {
    /// Bricks that do not deform.
    pub bricks: usize,
    /// Other rigid blocks in space.
    pub solids: usize,
    /// Corners of those.
    pub corners: usize,
    /// Joints in space.
    pub joints: usize,
    /// Rigid blocks that can meet others.
    pub meeting: usize,
    /// Pairs of those near each other.
    pub near: usize,
    /// Deformable blocks.
    pub deformable: usize,
    /// Corners of those that are no bricks.
    pub deformable_corners: usize,
    /// Bonds of those.
    pub bonds: usize,
    /// Blocks in the plane.
    pub flat: usize,
    /// Corners of those.
    pub flat_corners: usize,
    /// Pairs of those near each other.
    pub flat_near: usize,
    /// Pieces of all bolts.
    pub bolt_pieces: f64,
}

/// Most memory that a run will hold at a time, B. `blocks` that are split while it runs, and pairs that come near, are not in it.
///
/// Told and measured (MB, peak of `riprap run` on 2 threads): bricks in a lattice 8,000: 42 and 38, 64,000: 141 and 124, 512,000: 813 and
/// 631, 1,000,000: 1545 and 1228 (where most joints give way 47, 151, and 1785 for the million); random cells 1,331: 51 and 48, 8,000: 208 and 211; polyhedra poured 5,005: 119 and 108; dry wall of 4,801: 67 and 67; deformable bricks
/// 8,000: 114 and 123, 27,000: 285 and 268; deformable random cells 512: 61 and 60, 2,197: 208 and 209; deformable tetrahedra of a mesh 105,456:
/// 2000 and 1561; a bolt of 1,000,000 pieces: 420 and 392; slope in the plane of 12,581: 93 and 99, wall of 10,001: 64 and 68, of 100,001: 362 and 315.
pub(crate) fn expected(parts: &Parts) -> f64 {
    let n = |count: usize| count as f64;
    let rigid = parts.bricks + parts.solids + parts.flat;
    // Those of bricks are in `BRICK`, and joints are not counted by what they join: the more frequent shape decides.
    let of_others = if parts.solids > parts.bricks { JOINT } else { 0.0 };
    let written = WRITTEN[0] * n(rigid) + WRITTEN[1] * n(parts.deformable);
    PROGRAM
        + written.min(WRITTEN_MOST)
        + BRICK * n(parts.bricks)
        + CORNER * n(parts.corners)
        + of_others * n(parts.joints)
        + MEETS * n(parts.meeting)
        + NEAR * n(parts.near)
        + DEFORMABLE * n(parts.deformable)
        + OWN_CORNER * n(parts.deformable_corners)
        + BOND * n(parts.bonds)
        + FLAT_CORNER * n(parts.flat_corners)
        + FLAT_NEAR * n(parts.flat_near)
        + BOLT_PIECE * parts.bolt_pieces
}

/// Most bricks that free memory holds; infinite where nobody says how much there is.
pub(super) fn most_bricks() -> f64 {
    available().map_or(f64::INFINITY, |free| free / BRICK)
}

/// Whether free memory holds so many pieces of bolts.
pub(super) fn holds_pieces(count: f64) -> bool {
    available().is_none_or(|free| BOLT_PIECE * count <= free)
}

impl Builder<'_> {
    /// Whether the machine can hold that many blocks of a table more; an error at `span` if not.
    pub(super) fn has_memory(&mut self, block: &Block, count: f64, span: &Span) -> bool {
        let sets = self.spatial.deform.sets.iter();
        let deformable: usize = sets.map(|set| set.blocks.len()).sum();
        // Deformable blocks are among those in space.
        let rigid = self.spatial.blocks.len() + self.setup.blocks.len() - deformable;
        let per = match &block.mechanics {
            Some(Mechanics::Deformable(_)) => DEFORMABLE,
            Some(Mechanics::Rigid(_)) | None => BRICK,
        };
        // Neither bonds nor pictures nor pairs that come near, so that what fits is hardly ever refused: a million bricks take 1.23 GB,
        // 1.79 when most of their joints have given way.
        let before = BRICK * rigid as f64 + DEFORMABLE * deformable as f64;
        let Some(refusal) = refusal(count, before + per * count, available()) else {
            return true;
        };
        let help = "use larger blocks, a smaller model or a machine with more memory; in space [[refine]] gives small bricks only where they are \
                    needed";
        let error = Diagnostic::error("memory", refusal).at(span.clone());
        self.found.push(error.help(help));
        false
    }
}

/// Why so many blocks more are too many where that many bytes are needed for them and those before, and so many are free.
fn refusal(blocks: f64, needed: f64, available: Option<f64>) -> Option<String> {
    let free = available.filter(|free| needed > *free)?;
    Some(format!(
        "a model of {blocks:.0} blocks needs about {:.1} GB of memory; {:.1} GB are free",
        1e-9 * needed,
        1e-9 * free
    ))
}

/// Free bytes: of the machine, and of what limits this process; `None` where nobody says.
fn available() -> Option<f64> {
    let read = |path: &str| std::fs::read_to_string(path).unwrap_or_default();
    let machine = free_of(&read("/proc/meminfo"));
    let limit = limit_of(&read("/proc/self/limits"));
    let group =
        group_of(&read("/sys/fs/cgroup/memory.max"), &read("/sys/fs/cgroup/memory.current"));
    [machine, limit, group].into_iter().flatten().reduce(f64::min)
}

/// `MemAvailable` of `/proc/meminfo`.
fn free_of(text: &str) -> Option<f64> {
    let line = text.lines().find_map(|l| l.strip_prefix("MemAvailable:"))?;
    let kib: f64 = line.split_whitespace().next()?.parse().ok()?;
    Some(1024.0 * kib)
}

/// The limit of the address space of `/proc/self/limits` (`ulimit -v`).
fn limit_of(text: &str) -> Option<f64> {
    let line = text.lines().find_map(|l| l.strip_prefix("Max address space"))?;
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

    /// Within -10 % and +30 % of what runs have taken (MB, see [`expected`]).
    #[test]
    fn memory_is_told_as_it_was_measured() {
        let bricks = |bricks, joints| Parts { bricks, joints, ..Parts::default() };
        let solids = |solids, corners, joints, meeting, near| Parts {
            solids,
            corners,
            joints,
            meeting,
            near,
            ..Parts::default()
        };
        let deformable = |deformable, bonds| Parts { deformable, bonds, ..Parts::default() };
        let flat = |flat, flat_corners, flat_near| Parts {
            flat,
            flat_corners,
            flat_near,
            ..Parts::default()
        };
        let wall = Parts { meeting: 4800, near: 29_908, ..bricks(4801, 0) };
        let bolted = Parts { bolt_pieces: 1e6, ..bricks(1, 0) };
        for (parts, measured) in [
            (bricks(8000, 22_800), 38.2),
            (bricks(64_000, 187_200), 124.0),
            (bricks(64_000, 187_200), 151.0),
            (bricks(97_336, 285_660), 187.0),
            (bricks(512_000, 1_516_800), 631.0),
            (bricks(1_000_000, 2_970_000), 1228.0),
            (solids(1331, 30_754, 8670, 0, 0), 48.0),
            (solids(8000, 190_000, 56_168, 0, 0), 211.0),
            (solids(2005, 51_104, 4, 2000, 10), 59.0),
            (wall, 67.0),
            (deformable(1000, 2700), 34.0),
            (deformable(8000, 22_800), 123.0),
            (deformable(27_000, 78_300), 268.0),
            (flat(973, 3894, 4799), 24.0),
            (flat(3548, 14_200, 18_327), 39.0),
            (flat(12_581, 50_414, 66_722), 98.7),
            (flat(1001, 4004, 2911), 22.0),
            (flat(10_001, 40_004, 29_461), 68.4),
            (flat(100_001, 400_004, 294_961), 315.0),
            (flat(20_003, 110_061, 2), 73.8),
            (bolted, 392.0),
        ] {
            let told = 1e-6 * expected(&parts);
            let ratio = told / measured;
            assert!((0.9..1.3).contains(&ratio), "{told} {measured} {parts:?}");
        }
    }

    #[test]
    fn what_does_not_fit_is_refused_with_numbers() {
        let text = refusal(15_625_000.0, 23.4e9, Some(4e9)).unwrap();
        assert_eq!(
            text,
            "a model of 15625000 blocks needs about 23.4 GB of memory; 4.0 GB are free"
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
        assert_eq!(limit_of("Max address space   unlimited   unlimited   bytes"), None);
        assert_eq!(group_of("max\n", "5\n"), None);
        assert_eq!(group_of("2000\n", "500\n"), Some(1500.0));
    }
}
