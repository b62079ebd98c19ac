//! Dashpots across of facets that meet in a ridge under a block.
//!
//! ```text
//!     ridge: one dashpot            notch: one for each flank
//!       _______________                 \  |    |  /
//!            /  \                        \ |    | /
//!           /    \                        \|____|/
//!          /      \                        \__/
//! ```
//!
//! A block that slides over a ridge goes into one flank as it leaves the other: dashpots of each flank would hold it back, where a brick of
//! this shape has one contact with one normal and does not. In a notch both flanks are pressed in places of their own. Which of both it is
//! tell the planes: where the block presses on one facet of a ridge, the plane of the other lies above the ground. What hangs together by ridges
//! shares: a plate on two crests has one dashpot, though the flanks between them make a notch.

use riprap_geom::Vec3;

use crate::kernel::friction::{
    ContactInput, ContactLaw, Pressing, Shared, Wrench, pressing, share,
};
use crate::kernel::sums::Sums;
use crate::kernel::terrain::OnFacet;

/// Facets under one block that share dashpots; kept, so that a block takes no memory.
#[derive(Debug, Default)]
pub struct Ridges {
    /// What each facet presses with.
    pressing: Vec<Option<Pressing>>,
    /// The first facet of the ridge of each.
    first: Vec<usize>,
    /// Dashpots of the ridge that begins with each.
    dashpots: Vec<Option<Shared>>,
}

impl Ridges {
    /// Finds the ridges among these facets, and their dashpots; `asked` but for its sums, and with the law of a contact on all facets.
    pub fn find(&mut self, law: &ContactLaw, asked: &ContactInput, facets: &[OnFacet]) {
        self.pressing.clear();
        self.first.clear();
        self.dashpots.clear();
        if facets.len() < 2 || law.damping_ratio == 0.0 {
            return;
        }
        let of_facet = |on: &OnFacet| {
            let sums = &on.sums;
            pressing(law, &ContactInput { sums, ..*asked })
        };
        self.pressing.extend(facets.iter().map(of_facet));
        self.first.extend(0..facets.len());
        self.dashpots.resize(facets.len(), None);
        for k in 1..facets.len() {
            for other in 0..k {
                if self.first[k] != self.first[other] && self.is_ridge(facets, [k, other]) {
                    let (from, to) = (self.first[k], self.first[other]);
                    let [from, to] = [from.max(to), from.min(to)];
                    self.first.iter_mut().filter(|f| **f == from).for_each(|f| *f = to);
                }
            }
        }
        let of = |first: usize| {
            let members = self.first.iter().enumerate().filter(move |(_, f)| **f == first);
            members.map(|(k, _)| k)
        };
        let sums = |first: usize| {
            let mut sums = Sums::default();
            for k in of(first) {
                sums.plus(&facets[k].sums, 1.0, Vec3::ZERO);
                sums.depth = sums.depth.max(facets[k].sums.depth);
            }
            sums
        };
        let firsts = || (0..facets.len()).filter(|k| self.first[*k] == *k);
        let whole: f64 = firsts().map(|k| sums(k).vector_area.length()).sum();
        for first in firsts().filter(|k| of(*k).nth(1).is_some()) {
            let sums = sums(first);
            let members = of(first).filter_map(|k| self.pressing[k]);
            let power = members.map(|p| p.force * p.parting).sum();
            let law = law.part(sums.vector_area.length() / whole);
            let sums = &sums;
            self.dashpots[first] = share(&law, &ContactInput { sums, ..*asked }, power);
        }
    }

    /// Whether the ground between two facets is convex; so it is between two pieces of a block on one facet.
    fn is_ridge(&self, facets: &[OnFacet], [a, b]: [usize; 2]) -> bool {
        if facets[a].facet == facets[b].facet {
            return self.pressing[a].is_some() && self.pressing[b].is_some();
        }
        let above = |plane: usize, place: usize| {
            self.pressing[place]
                .is_some_and(|p| facets[plane].depth(p.point) >= facets[place].depth(p.point))
        };
        above(a, b) && above(b, a)
    }

    /// What dashpots of its ridge add to the pressure of facet `k`, over it; `None` where it has its own.
    #[must_use]
    pub fn shared(&self, k: usize) -> Option<f64> {
        let dashpots = self.dashpots[*self.first.get(k)?];
        dashpots.map(|shared| shared.ratio)
    }

    /// What acts against rocking on each ridge.
    pub fn rocking(&self) -> impl Iterator<Item = &Wrench> {
        self.dashpots.iter().flatten().map(|shared| &shared.rocking)
    }
}
