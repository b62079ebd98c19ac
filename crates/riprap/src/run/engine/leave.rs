//! Blocks that leave a model.

use serde::{Deserialize, Serialize};

use super::Engine;
use crate::plan::Leavers;
use crate::{Vec2, Vec3};
use crate::{planar, spatial};

/// A block that has left the model.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Departed {
    /// Its name.
    pub block: String,
    /// Step.
    pub step: u64,
    /// Model time, s.
    pub time: f64,
    /// Its centroid, m.
    pub at: [f64; 3],
    /// kg; in the plane kg/m.
    pub mass: f64,
    /// m/s.
    pub velocity: [f64; 3],
}

impl Departed {
    /// As a line of `events.jsonl`.
    #[must_use]
    pub fn event(&self) -> serde_json::Value {
        let mut event = serde_json::json!(self);
        event["event"] = "block_left".into();
        event
    }
}

impl Engine {
    /// Free rigid blocks that lie where blocks leave, by number.
    #[must_use]
    pub fn leaving(&self, bounds: &Leavers) -> Vec<u32> {
        match self {
            Self::Planar(e) => {
                let world = &e.world;
                let goes = |b: &usize| {
                    let Vec2 { x, y } = world.bodies[*b].position;
                    world.alive[*b]
                        && world.motion[*b].is_none()
                        && bounds.take(Vec3::new(x, y, 0.0))
                };
                (0..world.alive.len()).filter(goes).map(|b| b as u32).collect()
            }
            Self::Spatial(e) => {
                let (world, view) = (&e.world, e.view());
                let goes = |b: &usize| {
                    world.alive[*b]
                        && world.motion[*b].is_none()
                        && !world.deforms(*b)
                        && !world.is_terrain(*b)
                        && bounds.take(view.position(*b))
                };
                (0..world.alive.len()).filter(goes).map(|b| b as u32).collect()
            }
        }
    }

    /// Takes these blocks out and books what they take along but for the energy; forces must be re-evaluated afterwards.
    pub fn let_leave(&mut self, blocks: &[u32]) -> Vec<Departed> {
        let told: Vec<Departed> = blocks.iter().map(|b| self.departed(*b)).collect();
        let left = either!(self, e => &mut e.world.left);
        told.iter().for_each(|one| left.book(one.mass, one.velocity));
        match self {
            Self::Planar(e) => {
                planar::removal::take_out(&mut e.world, blocks);
                planar::bolts::follow(&mut e.world);
                e.scratch.invalidate(&mut e.world);
            }
            Self::Spatial(e) => {
                // They are told as blocks that have left, and not as removed ones.
                let told = e.world.events.len();
                spatial::topology::remove(&mut e.world, blocks);
                e.world.events.truncate(told);
                e.scratch.invalidate(&mut e.world);
            }
        }
        told
    }

    fn departed(&self, block: u32) -> Departed {
        let b = block as usize;
        let (at, mass, velocity) = match self {
            Self::Planar(e) => {
                let at = e.world.bodies[b].position + Vec2::from(e.world.setup.origin);
                let v = e.view().velocity(b);
                ([at.x, at.y, 0.0], e.scratch.shapes.mass[b], [v.x, v.y, 0.0])
            }
            Self::Spatial(e) => {
                let at = e.view().position(b) + e.world.setup.origin;
                let v = e.view().velocity(b);
                (at.to_array(), e.world.solid_of(b).mass, v.to_array())
            }
        };
        let (step, time) = either!(self, e => (e.world.step, e.world.time));
        Departed { block: self.view().name(block), step, time, at, mass, velocity }
    }
}
