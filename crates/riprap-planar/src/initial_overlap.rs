//! What overlaps at the start hold under a law without potential.
//!
//! The distance potential knows the energy of any overlap. The source's law has none: its normal energy is
//! the work done on it since the blocks met. Blocks that overlap when a model begins have met before; what their
//! contact will give back is then taken along the straightest way out: the first block moves away
//! along the resultant of the region, without turning, until the force is gone. Without this the first rebound would
//! be energy from nowhere.

use riprap_geom::Vec2;

use super::contact::{self, Context, Relative};
use super::scratch::Workspace;
use super::search::Candidate;
use super::world::Wrench;

/// Moves over the depth of a region.
const STRIDES: u32 = 64;

/// Moves after which the force is taken as it is: a force that lasts over many depths holds no more than
/// the strides up to there.
const MOST: u32 = 8 * STRIDES;

/// For each region of a pair the bits of its edges and the work its normal force does while the pair
/// parts straight along it, J/m.
pub(crate) fn energies(
    context: &Context<'_>,
    candidate: &Candidate,
    relative: &Relative,
) -> Vec<(u64, f64)> {
    let mut workspace = Workspace::default();
    contact::press_general(context, candidate, relative, &mut workspace)
        .into_iter()
        .map(|(pressed, edges)| {
            let out = pressed.normal.force.normalize_or_zero();
            let stride = pressed.depth / f64::from(STRIDES);
            let mut before = pressed.normal.force.dot(out);
            let mut work = 0.0;
            // Strides below the round-off of the place go nowhere: there the force is known.
            let mut known: Option<(Vec2, f64)> = None;
            for k in 1..=MOST {
                if before <= 0.0 {
                    break;
                }
                let shift = relative.shift + f64::from(k) * stride * out;
                let force = match known {
                    Some((place, force)) if place == shift => force,
                    _ => {
                        let apart = Relative { shift, ..*relative };
                        contact::press_general(context, candidate, &apart, &mut workspace)
                            .iter()
                            .filter(|(_, e)| e & edges != 0)
                            .fold(Wrench::default(), |sum, (p, _)| sum.plus(&p.normal))
                            .force
                            .dot(out)
                            .max(0.0)
                    }
                };
                known = Some((shift, force));
                work += 0.5 * stride * (before + force);
                before = force;
            }
            (edges, work)
        })
        .collect()
}
