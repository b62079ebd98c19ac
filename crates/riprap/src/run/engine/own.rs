//! Contacts and joints as a law of code sees them, and the forces that it gives them.

use super::steer::account_of;
use super::{Engine, View};
use crate::dynamics::TimeFunction;
use crate::plan::Damping;
use crate::{Vec2, Vec3};
use crate::{planar, spatial};

/// Force (N; in the plane N/m) and moment about the centroid (N m; N) on each block.
pub(in crate::run) type Wrenches = Vec<[[f64; 3]; 2]>;

/// A contact or a joint of two rigid blocks at an instant. In the plane all is in its plane, and sizes and forces are per metre of thickness.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::run) struct Met {
    /// The blocks.
    pub ends: [u32; 2],
    /// Whether a joint of the start joins them.
    pub joint: bool,
    /// Point of action in the coordinates of the scene, m.
    pub point: [f64; 3],
    /// The same from the centroids, m.
    pub arms: [[f64; 3]; 2],
    /// Unit normal from the first to the second; zero of a touch without one.
    pub normal: [f64; 3],
    /// Area, m²; in the plane length, m.
    pub area: f64,
    /// Velocity of the second against the first at the point in the last half step, m/s.
    pub velocity: [f64; 3],
    /// What the built-in response gives the first, N; in the plane N/m.
    pub force: [f64; 3],
}

fn cross([a, b, c]: [f64; 3], [x, y, z]: [f64; 3]) -> [f64; 3] {
    [b * z - c * y, c * x - a * z, a * y - b * x]
}

/// Force and moment of a force that acts on a block at an arm.
pub(in crate::run) fn wrench(force: [f64; 3], arm: [f64; 3]) -> [[f64; 3]; 2] {
    [force, cross(arm, force)]
}

/// Velocity of the second against the first at a point.
fn relative(rates: [[[f64; 3]; 2]; 2], arms: [[f64; 3]; 2]) -> [f64; 3] {
    let [a, b] = [0, 1].map(|side| {
        let [velocity, spin] = rates[side];
        let turning = cross(spin, arms[side]);
        [0, 1, 2].map(|k| velocity[k] + turning[k])
    });
    [0, 1, 2].map(|k| b[k] - a[k])
}

fn in_space(v: &spatial::view::View<'_>) -> Vec<Met> {
    let (world, origin) = (v.world, v.world.setup.origin);
    let rates = |b: u32| {
        let b = b as usize;
        [world.bodies.velocity(b).to_array(), world.bodies.spin(b).to_array()]
    };
    let met = |ends: [u32; 2], joint: bool, point: Vec3, arms: [Vec3; 2], normal: Vec3| {
        let arms = arms.map(|arm| arm.to_array());
        Met {
            ends,
            joint,
            point: (point + origin).to_array(),
            arms,
            normal: normal.to_array(),
            area: 0.0,
            velocity: relative(ends.map(rates), arms),
            force: [0.0; 3],
        }
    };
    let rigid = |ends: [u32; 2]| {
        ends.into_iter().all(|b| world.alive[b as usize] && !world.deforms(b as usize))
    };
    let mut all = Vec::new();
    for p in (0..world.patches.len()).filter(|p| rigid(world.patches.ends[*p])) {
        let (class, ends) = (v.patch_class(p), world.patches.ends[p]);
        let normal = match &world.turned[ends[0] as usize] {
            Some(turned) => turned.attitude * class.frame[0],
            None => class.frame[0],
        };
        let point = v.patch_place(p);
        let arms = ends.map(|b| point - v.position(b as usize));
        let force = v.patch_resultant(p).force.to_array();
        all.push(Met { area: class.area, force, ..met(ends, true, point, arms, normal) });
    }
    for contact in v.contacts().filter(|contact| rigid(contact.ends)) {
        let point = v.contact_place(&contact);
        let force = (-contact.force).to_array();
        let one = met(contact.ends, false, point, contact.arms, contact.normal);
        all.push(Met { area: contact.area, force, ..one });
    }
    all
}

fn in_plane(v: &planar::view::View<'_>) -> Vec<Met> {
    v.met()
        .into_iter()
        .map(|one| {
            let flat = |v: Vec2| [v.x, v.y, 0.0];
            let arms =
                one.blocks.map(|b| one.place - v.world.bodies[b as usize].position).map(flat);
            let rates = one.blocks.map(|b| {
                let body = &v.world.bodies[b as usize];
                [flat(body.velocity), [0.0, 0.0, body.spin]]
            });
            Met {
                ends: one.blocks,
                joint: one.joint,
                point: flat(one.place + Vec2::from(v.world.setup.origin)),
                arms,
                normal: flat(one.normal),
                area: one.length,
                velocity: relative(rates, arms),
                force: flat(one.force),
            }
        })
        .collect()
}

impl View<'_> {
    /// Contacts and joints of rigid blocks, in an order that depends on the state alone.
    pub(in crate::run) fn met(&self) -> Vec<Met> {
        match self {
            Self::Planar(v) => in_plane(v),
            Self::Spatial(v) => in_space(v),
        }
    }
}

impl Engine {
    /// Makes room for the forces of a law of code on all blocks there are; the number of its account. Blocks are laid out anew where there were
    /// fewer before.
    pub(in crate::run) fn make_room(&mut self, name: &str) -> u16 {
        let time = TimeFunction::Constant(1.0);
        match self {
            Self::Planar(e) => {
                use planar::setup::{Load, LoadKind};
                let count = e.world.alive.len() as u32;
                let (setup, works) = (&mut e.world.setup, &mut e.world.accounts);
                let at = account_of(&mut setup.accounts, works, name);
                let account = Some(at);
                match setup.loads.iter_mut().find(|load| load.account == account) {
                    Some(load) if load.blocks.len() == count as usize => return at,
                    Some(load) => load.blocks = (0..count).collect(),
                    None => setup.loads.push(Load {
                        blocks: (0..count).collect(),
                        kind: LoadKind::Own { wrenches: Vec::new() },
                        time,
                        account,
                    }),
                }
                e.scratch.invalidate(&mut e.world);
                at
            }
            Self::Spatial(e) => {
                use spatial::setup::{Load, LoadKind};
                let count = e.world.alive.len() as u32;
                let (setup, works) = (&mut e.world.setup, &mut e.world.accounts);
                let at = account_of(&mut setup.accounts, works, name);
                let account = Some(at);
                match setup.loads.iter_mut().find(|load| load.account == account) {
                    Some(load) if load.blocks.len() == count as usize => return at,
                    Some(load) => load.blocks = (0..count).collect(),
                    None => setup.loads.push(Load {
                        blocks: (0..count).collect(),
                        kind: LoadKind::Own { wrenches: Vec::new() },
                        time,
                        account,
                    }),
                }
                e.scratch.invalidate(&mut e.world);
                at
            }
        }
    }

    /// As [`Engine::evaluate`], with the forces that `find` gives blocks once contacts and joints are known: those of each account.
    ///
    /// # Errors
    /// A block whose forces are not finite.
    pub(in crate::run) fn evaluate_with(
        &mut self,
        damping: &Damping,
        dt: f64,
        accounts: &[u16],
        find: &mut dyn FnMut(View<'_>) -> Vec<Wrenches>,
    ) -> Result<(), u32> {
        match self {
            Self::Planar(e) => {
                use planar::setup::LoadKind;
                let own = &mut |world: &mut planar::world::World,
                                scratch: &planar::step::Scratch| {
                    let found = find(View::Planar(planar::view::View { world, scratch }));
                    for (account, found) in accounts.iter().zip(found) {
                        let of = |load: &&mut planar::setup::Load| load.account == Some(*account);
                        if let Some(load) = world.setup.loads.iter_mut().find(of) {
                            let flat = |[[x, y, _], [.., m]]: [[f64; 3]; 2]| (Vec2::new(x, y), m);
                            let wrenches = found.into_iter().map(flat).collect();
                            load.kind = LoadKind::Own { wrenches };
                        }
                    }
                };
                let (world, scratch) = (&mut e.world, &mut e.scratch);
                planar::step::evaluate_with(world, scratch, damping, dt, own)
                    .map_err(|wrong| wrong.block)
            }
            Self::Spatial(e) => {
                use spatial::setup::LoadKind;
                let own = &mut |world: &mut spatial::world::World,
                                scratch: &spatial::step::Scratch| {
                    let found = find(View::Spatial(spatial::view::View { world, scratch }));
                    for (account, found) in accounts.iter().zip(found) {
                        let of = |load: &&mut spatial::setup::Load| load.account == Some(*account);
                        if let Some(load) = world.setup.loads.iter_mut().find(of) {
                            let wrenches = found.into_iter().map(|w| w.map(Vec3::from)).collect();
                            load.kind = LoadKind::Own { wrenches };
                        }
                    }
                };
                let (world, scratch) = (&mut e.world, &mut e.scratch);
                spatial::step::evaluate_with(world, scratch, damping, dt, own)
                    .map_err(|wrong| wrong.block)
            }
        }
    }
}
