//! Where a state has left what its laws mean: blocks that have turned too far for small kinematics, tetrahedra that are inside out or strained
//! beyond their law, bolts that are drawn out without an end or tie nothing, and dashpots that carry what nothing else does.
//!
//! Nothing here changes a state. What it finds the run notes, warns of or stops for.

use riprap_geom::{Mat3, Vec3};

use crate::laws::bolt::BarState;
use crate::laws::tetrahedron::{Gradient, Strain, tensor};
use crate::push::bolts::install;
use crate::push::boundary::Context;
use crate::query::view::View;
use crate::read::fields::principal;
use crate::read::tetrahedra::strain;
use crate::setup::{BoundaryKind, Kinematics};
use crate::state::bolts::{Bolt, chord};

/// Share of the weight that a support along some direction must bear to count as one.
const BORNE: f64 = 0.1;

/// A tetrahedron that is strained most for its law.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Strained {
    /// Its block.
    pub block: u32,
    /// Where its centroid is, m (global).
    pub at: Vec3,
    /// Its volume over that at the start: not above zero where it is inside out.
    pub volume: f64,
    /// Largest magnitude of a principal strain by the measure of the block.
    pub strain: f64,
    /// Shortening along the direction that is shortened most: 1 for nothing left; with a measure for small strain, the same as `strain`.
    pub shortening: f64,
    /// The measure.
    pub measure: Strain,
}

/// A bolt that has been drawn out.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Drawn {
    /// Number in the setup.
    pub bolt: u32,
    /// How much farther its points in the rock lie apart along it than when it was installed, m; bars that have broken do not count.
    pub by: f64,
    /// Its length, m.
    pub length: f64,
    /// Largest force that it pulls with, N.
    pub force: f64,
}

impl View<'_> {
    /// The block that has turned farthest (rad) of those whose motion is exact for small rotations only.
    #[must_use]
    pub fn turned_most(&self) -> Option<(u32, f64)> {
        let small = self.world.setup.kinematics == Kinematics::Small;
        let angle = |b: usize| match self.deformable(b) {
            Some(body) if body.body.strain == Strain::Small => Some(body.rotation().length()),
            None if small => Some(self.world.bodies.rotation(b).length()),
            Some(_) | None => None,
        };
        if !small && self.world.deform.is_none() {
            return None;
        }
        let all = self.living().filter_map(|b| Some((b as u32, angle(b)?)));
        all.max_by(|a, b| a.1.total_cmp(&b.1))
    }

    /// The tetrahedron whose volume is smallest over that at the start, and the one that is strained most for its law.
    #[must_use]
    pub fn most_strained(&self) -> Option<[Strained; 2]> {
        let (deform, work) = self.deformables()?;
        let bodies: Vec<_> = deform.living().collect();
        let worst = |get: &(dyn Fn(&Strained) -> f64 + Sync)| {
            self.scratch.exec.largest(bodies.len(), |k| {
                let body = bodies[k];
                let (class, u) = (work.class(body), deform.displacement(body));
                let tets = (0..class.mesh.tets.len()).map(|tet| {
                    let nodes = class.mesh.tets[tet].map(|n| (body.first + n) as usize);
                    let place = |n: usize| {
                        deform.nodes.place[n] + Vec3::from_array(deform.nodes.displacement[n])
                    };
                    let centre = 0.25 * nodes.map(place).into_iter().sum::<Vec3>();
                    let h = class.groups.gradient(tet, u);
                    let at = centre + self.world.setup.origin;
                    strained(body.block, at, body.strain, &h)
                });
                let all = tets.map(|of| (get(&of), of));
                all.max_by(|a, b| a.0.total_cmp(&b.0))
            })
        };
        let smallest = worst(&|of| -of.volume)?.1;
        let most = worst(&|of| of.beyond())?.1;
        Some([smallest, most])
    }

    /// The bolt that has been drawn out by most of its length.
    #[must_use]
    pub fn most_drawn(&self) -> Option<Drawn> {
        let freedoms = self.world.all_freedoms();
        let one = |bolt: &Bolt| {
            let bars = (0..bolt.chain.bars.len())
                .filter(|k| bolt.stretches(*k) && bolt.chain.state(*k) != BarState::Broken);
            let parted = bars.map(|k| chord(&bolt.pins[k], &bolt.pins[k + 1], &freedoms).1);
            let [head, toe] = [bolt.pins.first()?, bolt.pins.last()?].map(|pin| pin.along);
            Some(Drawn {
                bolt: bolt.number,
                by: parted.sum(),
                length: toe - head,
                force: bolt.chain.largest_force(),
            })
        };
        let all = self.world.bolts.iter().filter_map(one);
        all.max_by(|a, b| (a.by / a.length).total_cmp(&(b.by / b.length)))
    }

    /// Bolts that tie nothing to anything, with the block that all of them lies in: those that are installed, and those that would be if the
    /// rock stayed as it is. None where blocks may be split while the model runs.
    #[must_use]
    pub fn idle_bolts(&self) -> Vec<(u32, u32)> {
        let world = self.world;
        if world.setup.refinements.iter().any(|r| r.during.is_some()) {
            return Vec::new();
        }
        let idle = |bolt: &Bolt| {
            let bars = 0..bolt.chain.bars.len();
            let ties = bars.clone().any(|k| bolt.stretches(k)) || !bolt.dowels.is_empty();
            let block = bolt.pins.first().map(|pin| pin.block)?;
            (!ties).then_some((bolt.number, block))
        };
        let installed = world.bolts.iter().filter_map(idle);
        let later = (0..world.setup.bolts.len() as u32)
            .filter(|n| world.bolts.iter().all(|bolt| bolt.number != *n))
            .filter_map(|n| idle(&install::as_it_is(world, n)?));
        let mut all: Vec<_> = installed.chain(later).collect();
        all.sort_unstable();
        all
    }

    /// What dashpots of viscous faces carry, N, summed over the faces, and the condition whose faces carry most. Stress that the rock has at the
    /// start and that such faces take up is none of it.
    #[must_use]
    pub fn carried_by_dashpots(&self) -> Option<(f64, u16)> {
        let context = Context::new(self.world);
        let mut carried = vec![0.0; self.world.setup.boundaries.len()];
        for face in &self.world.faces {
            let Some(boundary) = face.boundary else {
                continue;
            };
            let kind = &self.world.setup.boundaries[usize::from(boundary)].kind;
            let b = face.block as usize;
            let viscous = matches!(kind, BoundaryKind::Viscous { .. });
            if viscous && self.world.alive[b] && self.world.is_free(b) {
                carried[usize::from(boundary)] += context.dragged(face);
            }
        }
        let most = (0u16..).zip(&carried).max_by(|a, b| a.1.total_cmp(b.1))?;
        let all: f64 = carried.iter().sum();
        (all > 0.0).then_some((all, most.0))
    }

    /// The viscous boundary that the model sinks into: neither supports carry its weight nor a stress at the start that such faces take
    /// up.
    #[must_use]
    pub fn sinks_into(&self) -> Option<&str> {
        let world = self.world;
        // A ramp may begin without any.
        let now = world.gravity.try_normalize();
        let down = now.or_else(|| world.setup.gravity.try_normalize())?;
        if world.deform.as_ref().is_some_and(|d| !d.holds.is_empty())
            || (0..world.alive.len()).any(|b| world.is_terrain(b))
        {
            return None;
        }
        let borne = |b: usize| {
            let held = Vec3::ONE - world.freedoms(b)[0];
            world.alive[b] && (held * down).length() > BORNE
        };
        if (0..world.alive.len()).any(borne) {
            return None;
        }
        let mut viscous = None;
        for face in world.faces.iter().filter(|f| world.alive[f.block as usize]) {
            let Some(boundary) = face.boundary.map(|k| &world.setup.boundaries[usize::from(k)])
            else {
                continue;
            };
            let along = face.frame[0].dot(down).abs();
            let across = (1.0 - along * along).max(0.0).sqrt();
            let holds = match &boundary.kind {
                BoundaryKind::Viscous { .. } => {
                    viscous = viscous.or(Some(boundary.name.as_str()));
                    boundary.in_situ && world.setup.in_situ.is_some()
                }
                BoundaryKind::Held { normal, shear } => {
                    *normal && along > BORNE || *shear && across > BORNE
                }
                BoundaryKind::Moved { velocity } => {
                    (0..3).any(|k| velocity[k].is_some() && down[k].abs() > BORNE)
                }
                // It may be what carries the weight.
                BoundaryKind::Traction { .. } => true,
            };
            if holds {
                return None;
            }
        }
        viscous
    }
}

impl Strained {
    /// How far it is beyond its law, to compare: a measure for small strain by the strain, one for large strain by the shortening, of which
    /// its law bears more.
    #[must_use]
    pub fn beyond(&self) -> f64 {
        match self.measure {
            Strain::Small => self.strain / SMALL,
            Strain::Large => self.shortening / SHORTENED,
        }
    }
}

/// Strain from which on a law for small strain is wrong by about as much as that strain.
pub const SMALL: f64 = 0.1;
/// Shortening from which on the law for large strain means nothing: under a pressure along one axis St. Venant-Kirchhoff is stiffest at the start
/// and gives way at a stretch of `1/sqrt 3`, where 0.42 are gone; a third is before that.
pub const SHORTENED: f64 = 1.0 / 3.0;

fn strained(block: u32, at: Vec3, measure: Strain, h: &Gradient) -> Strained {
    let of = principal(&tensor(strain(measure, h)));
    let (low, high) = of
        .iter()
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), e| (low.min(*e), high.max(*e)));
    let shortening = match measure {
        Strain::Small => (-low).max(0.0),
        Strain::Large => 1.0 - (1.0 + 2.0 * low).max(0.0).sqrt(),
    };
    let column = |k: usize| Vec3::new(h[0][k], h[1][k], h[2][k]) + Vec3::AXES[k];
    Strained {
        block,
        at,
        volume: Mat3::from_cols(column(0), column(1), column(2)).determinant(),
        strain: high.max(-low),
        shortening,
        measure,
    }
}
