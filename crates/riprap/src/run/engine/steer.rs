//! What code in the loop changes between two steps: loads and the motion of supports, by the names that the scene gives them.

use riprap_core::accounts::{Account, Condition, Holder};
use thiserror::Error;

use super::{Engine, State};
use crate::dynamics::TimeFunction;
use crate::record::field::nearest;
use crate::{Vec2, Vec3};
use crate::{planar, spatial};

/// The new value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Steered {
    /// Of a load: the factor on it, in place of its function of time.
    Factor(f64),
    /// Of a support that moves its blocks: the velocity, m/s (in the plane without z). Components that the support does not prescribe are 0.
    Velocity([f64; 3]),
}

/// Why something cannot be steered.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum SteerError {
    /// Nothing has the name.
    #[error(
        "there is no load or support {name:?}{}; give it a `name` in the scene",
        near.as_ref().map_or(String::new(), |n| format!(" (did you mean {n:?}?)"))
    )]
    Unknown {
        /// The name.
        name: String,
        /// The nearest that there is.
        near: Option<String>,
    },
    /// A factor of a support, or a velocity of a load.
    #[error("{name:?} is a {word}: it is steered by {by}")]
    Other {
        /// The name.
        name: String,
        /// What it is.
        word: &'static str,
        /// What it takes.
        by: &'static str,
    },
    /// A support that does not prescribe that.
    #[error(
        "the support {name:?} prescribes no velocity along {axis}; give it `motion = {{ velocity = ... }}` in the scene"
    )]
    Free {
        /// The name.
        name: String,
        /// The axis.
        axis: char,
    },
    /// A support of nodes or of deformable blocks, or a boundary.
    #[error("{name:?} holds nodes or faces; loads and supports of rigid blocks can be steered")]
    Nodes {
        /// The name.
        name: String,
    },
    /// A support whose blocks have all been removed, released or fixed.
    #[error(
        "the support {name:?} moves no block any more: its blocks were removed, released or fixed"
    )]
    Idle {
        /// The name.
        name: String,
    },
    /// Not a number.
    #[error("the value for {name:?} is not finite")]
    NotFinite {
        /// The name.
        name: String,
    },
}

/// Changes the loads of that name; of a support gives its number and the velocity.
fn change<'a>(
    accounts: &[Condition],
    loads: impl Iterator<Item = (Option<u16>, &'a mut TimeFunction)>,
    name: &str,
    to: Steered,
) -> Result<Option<(usize, [f64; 3])>, SteerError> {
    let own = || name.to_owned();
    let finite = match to {
        Steered::Factor(factor) => factor.is_finite(),
        Steered::Velocity(velocity) => velocity.iter().all(|v| v.is_finite()),
    };
    if !finite {
        return Err(SteerError::NotFinite { name: own() });
    }
    let Some(at) = accounts.iter().position(|of| of.name == name) else {
        let known = accounts.iter().map(|of| of.name.as_str());
        let near = nearest(name, known).map(str::to_owned);
        return Err(SteerError::Unknown { name: own(), near });
    };
    match (accounts[at].holder, to) {
        (Holder::Load, Steered::Factor(factor)) => {
            let of_name = loads.filter(|(account, _)| account.map(usize::from) == Some(at));
            of_name.for_each(|(_, time)| *time = TimeFunction::Constant(factor));
            Ok(None)
        }
        (Holder::Support(k), Steered::Velocity(v)) => Ok(Some((usize::from(k), v))),
        (Holder::Load, Steered::Velocity(_)) => {
            Err(SteerError::Other { name: own(), word: "load", by: "a factor" })
        }
        (Holder::Support(_), Steered::Factor(_)) => {
            Err(SteerError::Other { name: own(), word: "support", by: "a velocity" })
        }
        (Holder::Nodes(_) | Holder::Boundary(_), _) => Err(SteerError::Nodes { name: own() }),
    }
}

/// Prescribes the velocity along the axes for which the support has a function.
fn prescribe(
    functions: &mut [&mut Option<TimeFunction>],
    velocity: [f64; 3],
    name: &str,
) -> Result<(), SteerError> {
    for (k, axis) in ['x', 'y', 'z'].into_iter().enumerate() {
        match functions.get_mut(k) {
            Some(Some(function)) => *function = TimeFunction::Constant(velocity[k]),
            Some(None) | None if velocity[k] == 0.0 => {}
            Some(None) | None => return Err(SteerError::Free { name: name.to_owned(), axis }),
        }
    }
    Ok(())
}

impl Engine {
    /// Gives a load or a support another value from now on; forces must be re-evaluated afterwards.
    ///
    /// # Errors
    /// A name of nothing, a value that it does not take.
    pub fn steer(&mut self, name: &str, to: Steered) -> Result<(), SteerError> {
        match self {
            Self::Planar(e) => planar(&mut e.world, name, to),
            Self::Spatial(e) => spatial(&mut e.world, name, to),
        }
    }
}

impl Engine {
    /// The constant factor of the load of that name; `None` where it has none.
    pub(in crate::run) fn factor(&self, name: &str) -> Option<f64> {
        either!(self, e => {
            let setup = &e.world.setup;
            let at = setup.accounts.iter().position(|of| of.name == name)?;
            let of_name = |account: Option<u16>| account.map(usize::from) == Some(at);
            let load = setup.loads.iter().find(|load| of_name(load.account))?;
            if let TimeFunction::Constant(factor) = load.time { Some(factor) } else { None }
        })
    }
}

impl State {
    /// Gives a load or a support another value.
    ///
    /// # Errors
    /// A name of nothing, a value that it does not take.
    pub(in crate::run) fn steer(&mut self, name: &str, to: Steered) -> Result<(), SteerError> {
        match self {
            Self::Planar(world) => planar(world, name, to),
            Self::Spatial(world) => spatial(world, name, to),
        }
    }
}

/// Steers the motion of a support, and those of its blocks that still have it: a phase may have fixed some. `give` is `None` of a motion that has no
/// velocity.
fn steer_all<'a, M: 'a>(
    own: &'a mut M,
    of_blocks: impl Iterator<Item = &'a mut M>,
    name: &str,
    mut give: impl FnMut(&mut M) -> Option<Result<(), SteerError>>,
) -> Result<(), SteerError> {
    let Some(done) = give(own) else {
        return Err(SteerError::Free { name: name.to_owned(), axis: 'x' });
    };
    done?;
    let mut moves = false;
    for motion in of_blocks {
        if let Some(done) = give(motion) {
            done?;
            moves = true;
        }
    }
    if moves { Ok(()) } else { Err(SteerError::Idle { name: name.to_owned() }) }
}

fn planar(world: &mut planar::world::World, name: &str, to: Steered) -> Result<(), SteerError> {
    use planar::setup::Motion;
    let loads = world.setup.loads.iter_mut().map(|load| (load.account, &mut load.time));
    let Some((k, velocity)) = change(&world.setup.accounts, loads, name, to)? else {
        return Ok(());
    };
    let mut moved: Vec<usize> = world.held_by(k).collect();
    moved.sort_unstable();
    let of_blocks = world.motion.iter_mut().enumerate();
    let of_blocks = of_blocks
        .filter(|(b, _)| moved.binary_search(b).is_ok())
        .filter_map(|(_, m)| m.as_deref_mut());
    steer_all(&mut world.setup.supports[k].motion, of_blocks, name, |motion| match motion {
        Motion::Velocity { x, y, .. } => Some(prescribe(&mut [x, y], velocity, name)),
        Motion::Fixed { .. } | Motion::Acceleration { .. } => None,
    })
}

fn spatial(world: &mut spatial::world::World, name: &str, to: Steered) -> Result<(), SteerError> {
    use spatial::setup::Motion;
    let loads = world.setup.loads.iter_mut().map(|load| (load.account, &mut load.time));
    let Some((k, velocity)) = change(&world.setup.accounts, loads, name, to)? else {
        return Ok(());
    };
    let held: Vec<usize> = world.held_by(k).collect();
    if held.iter().any(|b| world.deforms(*b)) {
        return Err(SteerError::Nodes { name: name.to_owned() });
    }
    let of_blocks = world.motion.iter_mut().enumerate();
    let of_blocks = of_blocks
        .filter(|(b, _)| held.binary_search(b).is_ok())
        .filter_map(|(_, m)| m.as_deref_mut());
    steer_all(&mut world.setup.supports[k].motion, of_blocks, name, |motion| match motion {
        Motion::Velocity { translation: [x, y, z], .. } => {
            Some(prescribe(&mut [x, y, z], velocity, name))
        }
        Motion::Fixed { .. } | Motion::Acceleration { .. } => None,
    })
}

/// Number of the account of a load that code puts on blocks; a new one where there is none yet.
pub(super) fn account_of(
    accounts: &mut Vec<Condition>,
    works: &mut Vec<Account>,
    name: &str,
) -> u16 {
    let is = |of: &Condition| of.holder == Holder::Load && of.name == name;
    let at = accounts.iter().position(is).unwrap_or_else(|| {
        accounts.push(Condition { name: name.to_owned(), holder: Holder::Load });
        works.push(Account::default());
        accounts.len() - 1
    });
    at as u16
}

impl Engine {
    /// Puts a force (N) and a moment (N m) on each of some blocks, in place of those that had this name; forces must be re-evaluated
    /// afterwards.
    pub(in crate::run) fn push(
        &mut self,
        name: &str,
        blocks: &[u32],
        force: [f64; 3],
        moment: [f64; 3],
    ) {
        match self {
            Self::Planar(e) => {
                use planar::setup::{Load, LoadKind};
                let (setup, works) = (&mut e.world.setup, &mut e.world.accounts);
                let account = Some(account_of(&mut setup.accounts, works, name));
                setup.loads.retain(|load| load.account != account);
                let force = Vec2::new(force[0], force[1]);
                let kinds = [
                    LoadKind::Point { force, at: None, follows: false },
                    LoadKind::Moment { moment: moment[2] },
                ];
                let time = TimeFunction::Constant(1.0);
                setup.loads.extend(kinds.map(|kind| Load {
                    blocks: blocks.to_vec(),
                    kind,
                    time: time.clone(),
                    account,
                }));
                e.scratch.invalidate(&mut e.world);
            }
            Self::Spatial(e) => {
                use spatial::setup::{Load, LoadKind};
                let (setup, works) = (&mut e.world.setup, &mut e.world.accounts);
                let account = Some(account_of(&mut setup.accounts, works, name));
                let had = |load: &Load| load.account == account;
                let same = setup
                    .loads
                    .iter()
                    .find(|load| had(load))
                    .is_some_and(|load| load.blocks == blocks);
                setup.loads.retain(|load| !had(load));
                let kinds = [
                    LoadKind::Point { force: Vec3::from(force), at: None },
                    LoadKind::Moment { moment: Vec3::from(moment) },
                ];
                let time = TimeFunction::Constant(1.0);
                setup.loads.extend(kinds.map(|kind| Load {
                    blocks: blocks.to_vec(),
                    kind,
                    time: time.clone(),
                    account,
                }));
                // Which blocks are pushed at all is known beforehand.
                if !same {
                    e.scratch.invalidate(&mut e.world);
                }
            }
        }
    }

    /// Charges the hole of a source with a mass (kg), to go off at `time` (s).
    pub(in crate::run) fn charge(&mut self, of: &str, mass: f64, time: f64) -> Result<(), String> {
        let Self::Spatial(e) = self else {
            return Err("there are no charges in the plane".to_owned());
        };
        let name = |source: u16| &e.world.setup.sources[usize::from(source)].name;
        match e.world.cavities.iter().position(|cavity| name(cavity.source) == of) {
            Some(k) => {
                spatial::charge::charge(&mut e.world, k, mass, time).map_err(|why| why.to_string())
            }
            None => {
                let near = nearest(of, e.world.setup.sources.iter().map(|s| s.name.as_str()));
                let near = near.map_or(String::new(), |near| format!("; did you mean {near:?}?"));
                Err(format!("there is no such source{near}"))
            }
        }
    }

    /// Sets the velocity (m/s) and the spin (rad/s) of some rigid blocks, what is given of them; those at the present instant must be in the state.
    pub(in crate::run) fn set_velocity(
        &mut self,
        blocks: &[u32],
        velocity: Option<[f64; 3]>,
        spin: Option<[f64; 3]>,
    ) {
        match self {
            Self::Planar(e) => {
                for b in blocks {
                    let body = &mut e.world.bodies[*b as usize];
                    if let Some([x, y, _]) = velocity {
                        body.velocity = Vec2::new(x, y);
                    }
                    if let Some([.., z]) = spin {
                        body.spin = z;
                    }
                }
                e.world.last_dt = 0.0;
            }
            Self::Spatial(e) => {
                for b in blocks.iter().map(|b| *b as usize) {
                    let velocity = velocity.map_or(e.world.bodies.velocity(b), Vec3::from);
                    match spin {
                        Some(spin) => e.world.set_spin(b, velocity, Vec3::from(spin)),
                        None => {
                            let spin = e.world.bodies.spin(b);
                            e.world.bodies.set_velocity(b, velocity, spin);
                        }
                    }
                }
                e.world.last_dt = 0.0;
            }
        }
    }

    /// Why the velocity of a block is not free to be set, if it is not.
    pub(in crate::run) fn bound(&self, block: u32) -> Option<&'static str> {
        let b = block as usize;
        let moved = "it is held or moved by a support; `release` it, or steer the support";
        match self {
            Self::Planar(e) => e.world.motion[b].is_some().then_some(moved),
            Self::Spatial(e) if e.world.deforms(b) => Some("it deforms"),
            Self::Spatial(e) => e.world.motion[b].is_some().then_some(moved),
        }
    }

    /// Names of groups with their blocks.
    pub(in crate::run) fn groups(&self) -> Vec<(&str, &[u32])> {
        self.view().groups()
    }

    /// Whether what a servo of that name acts on is still there: a block on which the load acts, or one that the support moves.
    pub(in crate::run) fn acts(&self, name: &str) -> bool {
        either!(self, e => {
            let world = &e.world;
            let setup = &world.setup;
            let Some(at) = setup.accounts.iter().position(|of| of.name == name) else {
                return false;
            };
            match setup.accounts[at].holder {
                Holder::Load => {
                    let of_name = |account: Option<u16>| account.map(usize::from) == Some(at);
                    let mut loads = setup.loads.iter().filter(|load| of_name(load.account));
                    loads.any(|load| load.blocks.iter().any(|b| world.alive[*b as usize]))
                }
                Holder::Support(k) => {
                    let held: Vec<usize> = world.held_by(usize::from(k)).collect();
                    held.iter().any(|b| world.motion[*b].iter().any(|motion| motion.is_driven()))
                }
                Holder::Nodes(_) | Holder::Boundary(_) => false,
            }
        })
    }

    /// Whether a block has not been removed.
    pub(in crate::run) fn is_alive(&self, block: u32) -> bool {
        either!(self, e => e.world.alive.get(block as usize).copied().unwrap_or(false))
    }

    /// Numbers of the bolts that have been installed.
    pub(in crate::run) fn installed(&self) -> Vec<u32> {
        either!(self, e => e.world.bolts.iter().map(|bolt| bolt.number).collect())
    }
}
