//! A region cut into blocks by sets of joints.
//!
//! Every set is a family of parallel lines at a regular spacing, with normal scatter of place and
//! angle, and with a persistence: the share of each line that is open. A line of persistence below
//! 1 is a row of traces of equal length with rock bridges of equal length between them, starting at
//! a random place. Traces that end inside a block do not cut it (`arrangement` removes dead ends).

use crate::arrangement::{Cut, cut_region_within};
use crate::error::demand;
use crate::heal::{Blocks, heal};
use crate::polygon::{self, Aabb};
use crate::random::Chance;
use crate::shapes::{capped, unit};
use crate::{GeomError, Vec2, tol};

/// One set of parallel joints.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct JointSet {
    /// Direction of the traces, anticlockwise from +x, rad.
    pub angle: f64,
    /// Distance between neighbouring lines, m.
    pub spacing: f64,
    /// Standard deviation of the distance between neighbouring lines, m. The place of each line is
    /// scattered by this over sqrt 2, and by no more than 0.45 spacings, so lines keep their order.
    pub spacing_scatter: f64,
    /// Standard deviation of the direction of each trace, rad; at most 3 of them.
    pub angle_scatter: f64,
    /// Share of each line that is open, above 0, up to 1.
    pub persistence: f64,
    /// Length of the traces, m; needed when the persistence is below 1, unused when it is 1.
    pub trace_length: Option<f64>,
    /// Distance from the origin of coordinates to one line of the set, along the normal (`angle`
    /// turned by +90 degrees), m; the others follow at multiples of the spacing.
    pub offset: f64,
}

/// Cut a simple anticlockwise region by single traces (their two ends, m) and by joint sets, and merge blocks with edges
/// below `smallest_edge` (0: none) into neighbours. With single traces, points within `tol::DRAWN` of the region's
/// size are one point.
///
/// *Errors*: a region that is not simple, parameters out of range, more than `tol::MAX_BLOCKS` blocks
/// or traces (estimated before any work), cuts too close together to tell apart.
pub fn cut(
    region: &[Vec2],
    single: &[[Vec2; 2]],
    sets: &[JointSet],
    seed: u64,
    smallest_edge: f64,
) -> Result<Blocks, GeomError> {
    polygon::validate(region)?;
    demand("smallest_edge", smallest_edge, smallest_edge >= 0.0, "0 or more")?;
    sets.iter().try_for_each(check)?;
    capped("blocks", estimate(region, sets))?;
    let mut chance = Chance::new(seed);
    let mut cuts: Vec<Cut> =
        single.iter().map(|&[from, to]| Cut { from, to, family: None }).collect();
    for (family, set) in sets.iter().enumerate() {
        traces(region, set, family as u32, &mut chance, &mut cuts)?;
    }
    // Mapped traces come with the round-off of a drawing: what should be one point may be nanometres apart.
    let snap = if single.is_empty() { tol::SNAP } else { tol::DRAWN };
    Ok(heal(cut_region_within(region, &cuts, snap)?, smallest_edge))
}

fn check(set: &JointSet) -> Result<(), GeomError> {
    demand("the angle of a joint set", set.angle, true, "finite")?;
    demand("the offset of a joint set", set.offset, set.offset.abs() < 1e150, "finite")?;
    demand("the spacing of a joint set", set.spacing, set.spacing > 0.0, "above 0")?;
    let scatter = set.spacing_scatter;
    demand("the spacing scatter of a joint set", scatter, scatter >= 0.0, "0 or more")?;
    let scatter = set.angle_scatter;
    demand("the angle scatter of a joint set", scatter, scatter >= 0.0, "0 or more")?;
    let p = set.persistence;
    demand("the persistence of a joint set", p, p > 0.0 && p <= 1.0, "above 0 and at most 1")?;
    if p < 1.0 {
        let length = set.trace_length.unwrap_or(f64::NAN);
        demand(
            "the trace length of a joint set",
            length,
            length > 0.0,
            "given and above 0 where the persistence is below 1",
        )?;
    }
    Ok(())
}

/// About how many blocks through-going joints would make: one, and one more for every line and every
/// crossing.
fn estimate(region: &[Vec2], sets: &[JointSet]) -> f64 {
    let area = polygon::signed_area(region).abs();
    let mut count = 1.0;
    for (i, a) in sets.iter().enumerate() {
        let (low, high) = reach(region, a.angle);
        count += (high - low) / a.spacing * a.persistence;
        for b in &sets[..i] {
            let open = a.persistence * b.persistence;
            count += open * area * libm::sin(a.angle - b.angle).abs() / (a.spacing * b.spacing);
        }
    }
    count
}

/// Smallest and largest distance of the region from the origin along a set's normal.
fn reach(region: &[Vec2], angle: f64) -> (f64, f64) {
    let normal = unit(angle).perp();
    let heights = || region.iter().map(|&v| v.dot(normal));
    (heights().fold(f64::INFINITY, f64::min), heights().fold(f64::NEG_INFINITY, f64::max))
}

fn traces(
    region: &[Vec2],
    set: &JointSet,
    family: u32,
    chance: &mut Chance,
    cuts: &mut Vec<Cut>,
) -> Result<(), GeomError> {
    let (low, high) = reach(region, set.angle);
    let direction = unit(set.angle);
    let normal = direction.perp();
    let bounds = Aabb::of(region);
    // More than half the diagonal: lines about the centre end outside.
    let (centre, half) = (bounds.centre(), 0.6 * bounds.size());
    // One line more on either side, since scatter may bring it in.
    let first = ((low - set.offset) / set.spacing).floor() - 1.0;
    let last = ((high - set.offset) / set.spacing).ceil() + 1.0;
    if !(first.abs() < 1e15 && last.abs() < 1e15) {
        let what = "the offset of a joint set over its spacing";
        return Err(GeomError::BadNumber { what, value: first, need: "below 1e15 at the region" });
    }
    let row = if set.persistence < 1.0 { set.trace_length } else { None };
    let period = row.map_or(f64::INFINITY, |length| length / set.persistence);
    let number = (last - first + 1.0) * (2.0 * half / period + 2.0);
    capped("joint traces", number + cuts.len() as f64)?;
    // Traces of one set are parallel and apart unless their angles scatter.
    let family = (set.angle_scatter == 0.0).then_some(family);
    for k in 0..=(last - first) as usize {
        // A spacing has the scatter of both its lines.
        let jitter = set.spacing_scatter * std::f64::consts::FRAC_1_SQRT_2 * chance.normal();
        let limit = 0.45 * set.spacing;
        let height = set.offset + (first + k as f64) * set.spacing + jitter.clamp(-limit, limit);
        let foot = centre + (height - centre.dot(normal)) * normal;
        let mut trace = |from: f64, to: f64, chance: &mut Chance| {
            let turned = set.angle_scatter * chance.normal().clamp(-3.0, 3.0);
            let along = if turned == 0.0 { direction } else { unit(set.angle + turned) };
            let middle = foot + 0.5 * (from + to) * direction;
            let reach = 0.5 * (to - from) * along;
            cuts.push(Cut { from: middle - reach, to: middle + reach, family });
        };
        match row {
            None => {
                // Long enough to cross the region whatever the scatter makes of its direction.
                let most = libm::cos((3.0 * set.angle_scatter).min(1.4));
                trace(-half / most, half / most, chance);
            }
            Some(length) => {
                let mut start = -half - chance.unit() * period;
                while start < half {
                    trace(start, start + length, chance);
                    start += period;
                }
            }
        }
    }
    debug_assert!(cuts.len() <= tol::MAX_BLOCKS);
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shapes::rectangle;
    use proptest::prelude::*;

    fn plain(angle: f64, spacing: f64) -> JointSet {
        JointSet {
            angle,
            spacing,
            spacing_scatter: 0.0,
            angle_scatter: 0.0,
            persistence: 1.0,
            trace_length: None,
            offset: 0.0,
        }
    }

    fn area(blocks: &Blocks) -> f64 {
        blocks.polygons.iter().map(|p| polygon::signed_area(p)).sum()
    }

    #[test]
    fn two_sets_make_a_grid_of_equal_blocks() {
        let region = rectangle(Vec2::ZERO, Vec2::new(10.0, 5.0));
        let sets = [plain(0.0, 1.0), plain(std::f64::consts::FRAC_PI_2, 1.0)];
        let blocks = cut(&region, &[], &sets, 1, 0.0).unwrap();
        assert_eq!(blocks.polygons.len(), 50);
        assert!(blocks.polygons.iter().all(|b| b.len() == 4));
        assert!((area(&blocks) / 50.0 - 1.0).abs() < 1e-14);
        // From bottom to top and left to right.
        assert_eq!(polygon::centroid(&blocks.polygons[1]).round(), Vec2::new(2.0, 1.0));
    }

    /// A trace across, one that meets it and runs on for a while, and one that ends in the rock on both sides.
    #[test]
    fn single_traces_divide_as_far_as_they_meet() {
        let region = rectangle(Vec2::ZERO, Vec2::new(4.0, 4.0));
        let trace = |a: [f64; 2], b: [f64; 2]| [Vec2::from(a), Vec2::from(b)];
        let traces = [
            trace([-1.0, 2.0], [5.0, 2.0]),
            trace([2.0, -1.0], [2.0, 2.5]),
            trace([1.0, 3.0], [3.0, 3.5]),
        ];
        let blocks = cut(&region, &traces, &[], 1, 0.0).unwrap();
        let areas: Vec<f64> = blocks.polygons.iter().map(|p| polygon::signed_area(p)).collect();
        assert_eq!(areas, [4.0, 4.0, 8.0]);
    }

    #[test]
    fn traces_that_miss_each_other_by_nanometres_meet() {
        let region = rectangle(Vec2::ZERO, Vec2::new(10.0, 10.0));
        let trace = |a: [f64; 2], b: [f64; 2]| [Vec2::from(a), Vec2::from(b)];
        let lengths = |traces: &[[Vec2; 2]]| {
            let blocks = cut(&region, traces, &[], 1, 0.0).unwrap();
            let shortest = blocks
                .polygons
                .iter()
                .flat_map(|p| polygon::edges(p).map(|(a, b)| a.distance(b)).collect::<Vec<_>>());
            assert!((area(&blocks) / 100.0 - 1.0).abs() < 1e-9);
            (blocks.polygons.len(), shortest.fold(f64::INFINITY, f64::min))
        };
        let across = trace([-1.0, 5.0], [11.0, 5.0]);
        for miss in [3e-9, -3e-9, 0.0, 6e-8] {
            // Ends short of the other trace, or behind it.
            let (count, shortest) = lengths(&[across, trace([4.0, 11.0], [4.0, 5.0 + miss])]);
            assert_eq!(count, 3, "{miss}");
            assert!(shortest > 0.9, "{miss}: {shortest}");
            // Three traces through one point but for nanometres: six blocks, no triangle between.
            let third = trace([1.0 + miss, 10.0], [7.0 + miss, 0.0]);
            let (count, shortest) = lengths(&[across, trace([4.0, 11.0], [4.0, -1.0]), third]);
            assert_eq!(count, 6, "{miss}");
            assert!(shortest > 0.9, "{miss}: {shortest}");
            // A trace drawn twice.
            let (count, _) = lengths(&[across, trace([-1.0, 5.0 + miss], [11.0, 5.0 + miss])]);
            assert_eq!(count, 2, "{miss}");
        }
        // What is drawn a tenth of a millimetre apart is apart.
        let (count, shortest) = lengths(&[across, trace([-1.0, 5.0001], [11.0, 5.0001])]);
        assert_eq!(count, 3);
        assert!((shortest / 1e-4 - 1.0).abs() < 1e-6);
        let (count, _) = lengths(&[across, trace([4.0, 11.0], [4.0, 5.0001])]);
        assert_eq!(count, 2);
    }

    #[test]
    fn a_far_region_is_cut_like_a_near_one() {
        let shift = Vec2::new(5e5, 5.2e6);
        let near = rectangle(Vec2::ZERO, Vec2::new(20.0, 10.0));
        let far: Vec<Vec2> = near.iter().map(|&v| v + shift).collect();
        let sets = |origin: Vec2| {
            [0.3, 1.9].map(|a| JointSet { offset: origin.dot(unit(a).perp()), ..plain(a, 1.3) })
        };
        let a = cut(&near, &[], &sets(Vec2::ZERO), 1, 0.01).unwrap();
        let b = cut(&far, &[], &sets(shift), 1, 0.01).unwrap();
        assert_eq!(a.polygons.len(), b.polygons.len());
        for (p, q) in a.polygons.iter().zip(&b.polygons) {
            assert_eq!(p.len(), q.len());
            let back: Vec<Vec2> = q.iter().map(|&v| v - shift).collect();
            assert!(polygon::centroid(p).distance(polygon::centroid(&back)) < 1e-7);
        }
    }

    #[test]
    fn persistence_leaves_bridges() {
        let region = rectangle(Vec2::ZERO, Vec2::new(20.0, 20.0));
        let count = |persistence: f64| {
            let set =
                |angle| JointSet { persistence, trace_length: Some(4.0), ..plain(angle, 1.0) };
            let blocks = cut(&region, &[], &[set(0.2), set(1.6)], 5, 0.0).unwrap();
            assert!((area(&blocks) / 400.0 - 1.0).abs() < 1e-12);
            (blocks.polygons.len(), blocks.removed.dead_ends)
        };
        let (full, none) = count(1.0);
        let (some, dead) = count(0.8);
        let (few, _) = count(0.3);
        assert!(full > 380 && none == 0, "{full} {none}");
        assert!(some < full && few < some && dead > 0, "{full} {some} {few} {dead}");
    }

    #[test]
    fn silly_numbers_are_errors_at_once() {
        let region = rectangle(Vec2::ZERO, Vec2::splat(1000.0));
        let bad = |set: JointSet| cut(&region, &[], &[set], 1, 0.0).unwrap_err();
        let error = bad(plain(0.0, 1e-12));
        assert!(matches!(error, GeomError::TooMany { count, .. } if count > 9e14), "{error}");
        assert!(matches!(bad(plain(f64::NAN, 1.0)), GeomError::BadNumber { .. }));
        assert!(matches!(bad(plain(0.0, -1.0)), GeomError::BadNumber { .. }));
        assert!(matches!(
            bad(JointSet { offset: 1e149, ..plain(0.0, 1.0) }),
            GeomError::BadNumber { .. }
        ));
        assert!(matches!(
            bad(JointSet { persistence: 0.5, ..plain(0.0, 1.0) }),
            GeomError::BadNumber { .. }
        ));
        let dust = JointSet { persistence: 0.5, trace_length: Some(1e-9), ..plain(0.0, 10.0) };
        assert!(matches!(bad(dust), GeomError::TooMany { .. }));
        let pair = [plain(0.0, 0.1), plain(1.0, 0.1)];
        assert!(matches!(cut(&region, &[], &pair, 1, 0.0), Err(GeomError::TooMany { .. })));
        let wild = JointSet { angle_scatter: 1e300, spacing_scatter: 1e300, ..plain(0.0, 100.0) };
        assert!(cut(&region, &[], &[wild], 1, 0.0).is_ok());
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(48))]
        #[test]
        fn joints_fill_the_region_the_same_way_each_time(
            angles in prop::collection::vec(-3.2..3.2f64, 1..4),
            spacing in 0.6..3.0f64,
            scatter in 0.0..0.3f64,
            persistence in 0.3..1.3f64,
            smallest in 0.0..0.1f64,
            seed in any::<u64>(),
        ) {
            let region: Vec<Vec2> = [(0., 0.), (12., 0.), (12., 4.), (6., 5.), (5., 10.), (0., 9.)]
                .map(Vec2::from).to_vec();
            let sets: Vec<JointSet> = angles.iter().map(|&angle| JointSet {
                spacing_scatter: scatter,
                angle_scatter: 0.2 * scatter,
                persistence: f64::min(persistence, 1.0),
                trace_length: Some(3.0),
                ..plain(angle, spacing)
            }).collect();
            let blocks = cut(&region, &[], &sets, seed, smallest).unwrap();
            prop_assert_eq!(&blocks, &cut(&region, &[], &sets, seed, smallest).unwrap());
            prop_assert!((area(&blocks) / polygon::signed_area(&region) - 1.0).abs() < 1e-12);
            let boxes: Vec<Aabb> = blocks.polygons.iter().map(|b| Aabb::of(b)).collect();
            for b in &blocks.polygons {
                prop_assert_eq!(polygon::validate(b), Ok(()));
            }
            for (i, j) in crate::pairs::touching_boxes(&boxes, 1_000_000).unwrap() {
                let (a, b) = (&blocks.polygons[i as usize], &blocks.polygons[j as usize]);
                prop_assert!(crate::clip::overlap_depth(a, b).depth < 1e-9);
            }
        }
    }
}
