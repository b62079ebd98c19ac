//! What the softness of a joint takes from the load that tilts the blocks on it.

use riprap_geom::Vec3;

use crate::frame::fragments::{Fragments, Member};
use crate::query::view::View;

/// Cosine between gravity and the normal of a joint on which blocks stand.
const LEVEL: f64 = 0.99;
/// Way within which ends of patches are at the same edge, m over the height of the centre above it.
const SAME_EDGE: f64 = 1e-6;

/// Where blocks that stand together lose most.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Toe {
    /// A block at the edge.
    pub block: u32,
    /// Row of the law of its joint in `Setup::interfaces`.
    pub row: u16,
    /// Normal stiffness of the joint, Pa/m.
    pub stiffness: f64,
    /// Share of the load on the mass of these blocks with which they would tilt about the edge of hard ground.
    pub share: f64,
}

/// A patch between a free block and one that is held: half its sides along its axes.
struct Base {
    block: u32,
    centre: Vec3,
    sides: [Vec3; 2],
    row: u16,
    stiffness: f64,
}

impl Base {
    /// How far it reaches along a direction from its centre, m.
    fn reach(&self, along: Vec3) -> f64 {
        self.sides.iter().map(|side| along.dot(*side).abs()).sum()
    }
}

impl View<'_> {
    /// The largest share of a tilting load that softness takes from free rigid blocks which stand on held ones, joined with each other as
    /// they are now, under gravity (m/s²): with the weight W, the centre h above and b from an edge of the length L, and the stiffness k it is
    /// `(3/b) (h W/(18 k L))^(1/3)`. `None` where nothing stands so.
    ///
    /// Source: equilibrium on a triangle of pressure (`docs/src/how-to/choose.md`); joints between these blocks take more.
    #[must_use]
    pub fn softest_toe(&self, gravity: Vec3) -> Option<Toe> {
        let world = self.world;
        let up = -gravity.normalize_or_zero();
        let free = |b: u32| world.is_free(b as usize) && !world.deforms(b as usize);
        let members: Vec<_> = (0..world.alive.len())
            .map(|b| {
                world.alive[b].then(|| Member {
                    size: world.solid_of(b).mass,
                    centre: self.position(b).to_array(),
                    held: false,
                })
            })
            .collect();
        let pairs = world.patches.ends.iter().copied();
        let together =
            Fragments::new(&members, pairs.filter(|ends| ends.map(free) == [true; 2]), false);
        let mut bases: Vec<Vec<Base>> = together.list.iter().map(|_| Vec::new()).collect();
        for (p, ends) in world.patches.ends.iter().enumerate() {
            let class = self.patch_class(p);
            let block = match ends.map(free) {
                [true, false] => ends[0],
                [false, true] => ends[1],
                _ => continue,
            };
            let stands = class.frame[0].dot(up).abs() > LEVEL;
            if let Some(of) = together.of[block as usize].filter(|_| stands) {
                // The points of a patch lie where those of Gauss do.
                let side = |k: usize| 3.0_f64.sqrt() * class.half_spacing[k] * class.frame[k + 1];
                bases[of as usize].push(Base {
                    block,
                    centre: self.patch_place(p),
                    sides: [side(0), side(1)],
                    row: class.row,
                    stiffness: class.stiffness[0],
                });
            }
        }
        let toes = together.list.iter().zip(&bases).filter_map(|(fragment, bases)| {
            let centre = Vec3::from_array(fragment.centre);
            toe(bases, centre, up, fragment.size * gravity.length())
        });
        toes.max_by(|a, b| a.share.total_cmp(&b.share))
    }
}

/// The edge at which blocks with this centre (m) and weight (N) lose most.
fn toe(bases: &[Base], centre: Vec3, up: Vec3, weight: f64) -> Option<Toe> {
    let first = bases.first()?;
    let axes = first.sides.map(Vec3::normalize_or_zero);
    let ways = [axes[0], -axes[0], axes[1], -axes[1]];
    let toes = ways.into_iter().filter_map(|way| {
        let end = |base: &Base| way.dot(base.centre - centre) + base.reach(way);
        let last = bases.iter().max_by(|a, b| end(a).total_cmp(&end(b)))?;
        let (arm, height) = (end(last), up.dot(centre - last.centre));
        let at_edge = bases.iter().filter(|base| end(base) > arm - SAME_EDGE * height);
        let length: f64 = at_edge.map(|base| 2.0 * base.reach(up.cross(way))).sum();
        let share = 3.0 / arm * libm::cbrt(height * weight / (18.0 * last.stiffness * length));
        // What leans over its edge does not stand, and what is wider than high slides before it tilts.
        (arm > 0.0 && height > arm && share.is_finite()).then_some(Toe {
            block: last.block,
            row: last.row,
            stiffness: last.stiffness,
            share,
        })
    });
    toes.max_by(|a, b| a.share.total_cmp(&b.share))
}
