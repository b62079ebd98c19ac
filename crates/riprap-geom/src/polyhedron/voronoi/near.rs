//! Sites in order of their distance from a place: a tree of halves, since graded sites are a thousand times denser in one
//! place than in another.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use crate::Vec3;

/// Sites in a leaf, at most.
const LEAF: usize = 8;

/// A node: a leaf with sites, or two halves.
struct Node {
    low: Vec3,
    high: Vec3,
    /// Range of `Tree::order` in a leaf.
    sites: std::ops::Range<usize>,
    /// The first of the two halves, which stand side by side.
    halves: Option<usize>,
}

/// Sites in space, to be asked which are near.
pub(super) struct Tree {
    places: Vec<Vec3>,
    /// Numbers of the sites, those of a node together.
    order: Vec<u32>,
    nodes: Vec<Node>,
}

/// What waits in a search: the bits of a square of a distance (not negative, so that bits are in the order of numbers), whether it is
/// a site, and its number.
type Waiting = Reverse<(u64, bool, u32)>;

/// Space for a search, for use again.
#[derive(Default)]
pub(super) struct Search {
    heap: BinaryHeap<Waiting>,
}

impl Tree {
    /// A tree of the sites with these numbers.
    pub(super) fn new(sites: &[Vec3], numbers: impl Iterator<Item = u32>) -> Self {
        let mut order: Vec<u32> = numbers.collect();
        let root = Node { low: Vec3::ZERO, high: Vec3::ZERO, sites: 0..order.len(), halves: None };
        let mut nodes = vec![root];
        let mut at = 0;
        while at < nodes.len() {
            let range = nodes[at].sites.clone();
            let own = &mut order[range.clone()];
            let start = (Vec3::INFINITY, Vec3::NEG_INFINITY);
            let box_of = |(low, high): (Vec3, Vec3), k: &u32| {
                let site = sites[*k as usize];
                (low.min(site), high.max(site))
            };
            let (low, high) = own.iter().fold(start, box_of);
            (nodes[at].low, nodes[at].high) = (low, high);
            if own.len() > LEAF {
                let axis = (0..3).fold(0, |best, a| {
                    let longer = (high - low)[a] > (high - low)[best];
                    if longer { a } else { best }
                });
                let middle = own.len() / 2;
                own.select_nth_unstable_by(middle, |a, b| {
                    let along = |k: u32| sites[k as usize][axis];
                    along(*a).total_cmp(&along(*b)).then(a.cmp(b))
                });
                nodes[at].halves = Some(nodes.len());
                let cut = range.start + middle;
                for sites in [range.start..cut, cut..range.end] {
                    nodes.push(Node { low, high, sites, halves: None });
                }
            }
            at += 1;
        }
        let places = order.iter().map(|k| sites[*k as usize]).collect();
        Self { places, order, nodes }
    }

    /// Hands the sites over by their distance from a place, equal ones by number, until `go_on` (number, square of the distance)
    /// says no.
    pub(super) fn by_distance(
        &self,
        from: Vec3,
        search: &mut Search,
        mut go_on: impl FnMut(u32, f64) -> bool,
    ) {
        let heap = &mut search.heap;
        heap.clear();
        // A node before a site that is as far: it may hold one with a lower number.
        let wait = |heap: &mut BinaryHeap<Waiting>, square: f64, site, number| {
            heap.push(Reverse((square.to_bits(), site, number)));
        };
        wait(heap, 0.0, false, 0);
        while let Some(Reverse((bits, site, number))) = heap.pop() {
            if site {
                if !go_on(number, f64::from_bits(bits)) {
                    return;
                }
                continue;
            }
            let node = &self.nodes[number as usize];
            match node.halves {
                Some(first) => {
                    for half in [first, first + 1] {
                        let Node { low, high, .. } = self.nodes[half];
                        let square = (from - from.clamp(low, high)).length_squared();
                        wait(heap, square, false, half as u32);
                    }
                }
                None => {
                    for k in node.sites.clone() {
                        wait(heap, (self.places[k] - from).length_squared(), true, self.order[k]);
                    }
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::Chance;

    /// The order is that of a sort, also of sites that lie together.
    #[test]
    fn all_sites_come_in_order() {
        let mut chance = Chance::new(5);
        let mut sites: Vec<Vec3> = (0..300)
            .map(|_| {
                Vec3::from_array(
                    [0; 3].map(|_| chance.between(0.0, 1.0) * chance.between(0.0, 1.0)),
                )
            })
            .collect();
        sites.extend_from_within(0..40);
        let tree = Tree::new(&sites, 0..sites.len() as u32);
        for from in [Vec3::ZERO, sites[17], Vec3::new(0.3, 2.0, 0.1)] {
            let mut found = Vec::new();
            tree.by_distance(from, &mut Search::default(), |k, _| {
                found.push(k);
                true
            });
            let mut sorted: Vec<u32> = (0..sites.len() as u32).collect();
            let square = |k: u32| (sites[k as usize] - from).length_squared();
            sorted.sort_by(|a, b| square(*a).total_cmp(&square(*b)).then(a.cmp(b)));
            assert_eq!(found, sorted);
        }
    }
}
