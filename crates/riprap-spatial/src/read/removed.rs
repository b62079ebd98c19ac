//! What has been taken out of the model, and how far two blocks have come together.

use crate::query::view::View;
use crate::state::lineage::Origin;

/// Blocks that were removed, ascending: those that are gone without having become others by splitting.
fn gone<'a>(v: &'a View<'_>) -> impl Iterator<Item = usize> + 'a {
    let mut split = vec![false; v.world.alive.len()];
    for origin in v.world.lineage.iter().filter(|origin| origin.parent != Origin::NONE) {
        split[origin.parent as usize] = true;
    }
    (0..split.len()).filter(move |&b| !v.world.alive[b] && !split[b])
}

/// Mass of all removed blocks, kg.
pub(super) fn mass_of_all(v: &View<'_>) -> f64 {
    gone(v).map(|b| v.world.solid_of(b).mass).sum()
}

/// Mass of the blocks of a group (ascending), and of those that its split blocks have become, that have been removed, kg.
pub(super) fn mass(v: &View<'_>, of: &[u32]) -> f64 {
    let belongs = |b: &usize| {
        let mut ancestor = *b as u32;
        while of.binary_search(&ancestor).is_err() {
            ancestor = v.world.lineage[ancestor as usize].parent;
            if ancestor == Origin::NONE {
                return false;
            }
        }
        true
    };
    gone(v).filter(belongs).map(|b| v.world.solid_of(b).mass).sum()
}

/// A share of nothing is zero.
pub(super) fn part(of: f64, all: f64) -> f64 {
    if all > 0.0 { of / all } else { 0.0 }
}

/// By how much the centroids of two blocks have come nearer to each other, m.
pub(super) fn convergence(v: &View<'_>, (a, b): (u32, u32)) -> f64 {
    let [a, b] = [a, b].map(|b| b as usize);
    let now = v.position(a) - v.position(b);
    let before = now - (v.displacement(a) - v.displacement(b));
    before.length() - now.length()
}
