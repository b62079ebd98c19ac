//! Supports and loads on blocks in space.

use std::collections::BTreeSet;

use riprap_geom::Vec3;

use super::shapes::{centroid, volume};
use crate::accounts::Holder;
use crate::dynamics::TimeFunction;
use crate::model::accounts::condition_name;
use crate::model::builder::Builder;
use crate::model::motion::{as_one, held_if, turns};
use crate::scenario::language::{self, Fixed};
use crate::spatial::setup::{Load, LoadKind, Motion, Support};

/// Whether each direction is held.
pub(super) fn held_along(said: &Fixed) -> [bool; 3] {
    [said.x_or_default(), said.y_or_default(), said.z_or_default()]
}

/// What deformable blocks do not do when a spin is prescribed.
const NO_TURN: &str =
    "cannot be driven by a spin: drive their nodes by formulas of x, y, z (`on.nodes`)";

/// Which freedoms are held.
fn fixed(said: &Fixed) -> Motion {
    let turn = |given: Option<bool>| given.unwrap_or(said.rotation_or_default());
    Motion::Fixed {
        translation: held_along(said),
        rotation: [turn(said.rotation_x), turn(said.rotation_y), turn(said.rotation_z)],
    }
}

impl Builder<'_> {
    pub(super) fn solid_supports(&mut self) {
        let mut supported = BTreeSet::new();
        for (number, support) in self.parsed.scenario.supports.iter().enumerate() {
            if self.node_support(support, number) {
                continue;
            }
            let Some(blocks) = self.target(&support.on) else {
                continue;
            };
            self.tell_second_support(&mut supported, &blocks, &support.on);
            let motion = match (&support.fixed, &support.motion) {
                (Some(said), _) => fixed(said),
                (None, Some(language::Motion::Velocity(m))) => {
                    let translation = [&m.x, &m.y, &m.z].map(|f| self.maybe(f.as_ref()));
                    let spin = [&m.spin_x, &m.spin_y, &m.spin_z].map(|f| self.maybe(f.as_ref()));
                    let turns = spin.iter().flatten().any(turns);
                    if turns && self.any_deforms(&blocks, &support.on, NO_TURN) {
                        continue;
                    }
                    let about = (turns && as_one(m, &blocks)).then(|| {
                        let given = m.about.as_ref().map(|at| self.local(at.xyz()));
                        given.unwrap_or_else(|| self.centroid_of_solids(&blocks))
                    });
                    let held = about.is_some();
                    Motion::Velocity {
                        translation: translation.map(|f| held_if(held, f)),
                        spin: spin.map(|f| held_if(held, f)),
                        about,
                    }
                }
                (None, Some(language::Motion::Acceleration(m))) => Motion::Acceleration {
                    translation: [
                        self.maybe(m.x.as_ref()),
                        self.maybe(m.y.as_ref()),
                        self.maybe(m.z.as_ref()),
                    ],
                },
                // Reported by the rules of the language.
                (None, None) => continue,
            };
            if matches!(motion, Motion::Acceleration { .. })
                && self.any_deforms(&blocks, &support.on, "can only be driven by a velocity")
            {
                continue;
            }
            let name = condition_name(support.name.as_ref(), &support.on, number);
            self.account(name, Holder::Support(self.spatial.supports.len() as u16));
            self.spatial.supports.push(Support { blocks, motion });
        }
    }

    /// Centroid of the masses of some blocks, m (local).
    fn centroid_of_solids(&self, blocks: &[u32]) -> Vec3 {
        let (mut sum, mut all) = (Vec3::ZERO, 0.0);
        for &b in blocks {
            let block = &self.spatial.blocks[b as usize];
            let density = self.spatial.materials[usize::from(block.material)].density;
            let mass = density * volume(&block.shape);
            sum += mass * centroid(&block.shape);
            all += mass;
        }
        sum / all
    }

    /// Whether a support holds a block in all freedoms.
    pub(super) fn held(&self, block: u32) -> bool {
        let terrain = |b: u32| self.spatial.blocks[b as usize].shape.is_terrain();
        terrain(block)
            || self.spatial.supports.iter().any(|support| {
                let all = match support.motion {
                    Motion::Fixed { translation, rotation } => {
                        translation == [true; 3] && rotation == [true; 3]
                    }
                    Motion::Velocity { .. } | Motion::Acceleration { .. } => false,
                };
                all && support.blocks.binary_search(&block).is_ok()
            })
    }

    pub(super) fn solid_loads(&mut self) {
        for (number, load) in self.parsed.scenario.loads.iter().enumerate() {
            let Some(blocks) = self.target(&load.on) else {
                continue;
            };
            let time = match &load.time {
                Some(f) => match self.time_function(f) {
                    Some(time) => time,
                    None => continue,
                },
                None => TimeFunction::Constant(1.0),
            };
            let mut kinds = Vec::new();
            if let Some(point) = &load.point {
                kinds.push(LoadKind::Point {
                    force: point.force.xyz().into(),
                    at: point.at.as_ref().map(|at| self.local(at.xyz())),
                });
            }
            if load.moment.is_some()
                && self.any_deforms(
                    &blocks,
                    &load.on,
                    "cannot carry a moment: apply forces at points",
                )
            {
                continue;
            }
            if let Some(moment) = &load.moment {
                kinds.push(LoadKind::Moment { moment: moment.xyz().into() });
            }
            if let Some(body) = &load.body {
                kinds.push(LoadKind::BodyForce {
                    acceleration: Vec3::from(body.acceleration.xyz()),
                });
            }
            let name = condition_name(load.name.as_ref(), &load.on, number);
            let account = self.account(name, Holder::Load);
            for kind in kinds {
                self.spatial.loads.push(Load {
                    blocks: blocks.clone(),
                    kind,
                    time: time.clone(),
                    account,
                });
            }
        }
    }
}
