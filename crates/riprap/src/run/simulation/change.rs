//! Edits by code in the loop: what the beginning of a phase can change, and forces and velocities, at any step.
//!
//! A change is made at the present instant within the present phase. It goes through what a phase goes through when it begins
//! (`Simulation::apply`): the motion is ended with its half kick where forces jump, the edit is made, and the energy that it adds is booked as
//! edit defect. All that a change leaves is in the world and in the plan, so that a checkpoint holds it.

use riprap_core::condition::Condition;
use thiserror::Error;

use super::{RunError, Simulation};
use crate::plan::Phase;
use crate::record::field::nearest;
use crate::run::engine::{Engine, Kind, NewBolt, Nodes};
use crate::spatial::setup::Material;

/// A change in numbers.
#[derive(Clone, Debug, PartialEq)]
pub struct Change {
    /// What is edited now: the lists and laws of a phase.
    pub edits: Phase,
    /// The present phase with its rules from now on.
    pub rules: Phase,
    /// The phases after it, with laws that know of the change.
    pub later: Vec<Phase>,
}

/// Why something cannot be changed.
#[derive(Debug, Error)]
pub enum ChangeError {
    /// Keys of a phase that are wrong, at their places.
    #[cfg(feature = "scenario")]
    #[error("{0}")]
    Keys(crate::scenario::Diagnostics),
    /// A key that cannot change within a phase.
    #[error("`{key}` cannot change within a phase; valid keys: {known}")]
    Forbidden {
        /// The key.
        key: String,
        /// What can.
        known: String,
    },
    /// A name of nothing.
    #[error("{key}: there is no block or group {name:?}{}",
        near.as_ref().map_or(String::new(), |n| format!("; did you mean {n:?}?")))]
    Unknown {
        /// Where it stands.
        key: String,
        /// The name.
        name: String,
        /// The nearest there is.
        near: Option<String>,
    },
    /// A condition that cannot be read, or that holds for no block.
    #[error("{key}: {text:?}: {why}")]
    Condition {
        /// Where it stands.
        key: String,
        /// The condition.
        text: String,
        /// What is wrong.
        why: String,
    },
    /// Blocks that have been removed.
    #[error("{key}: {name:?} has been removed")]
    Removed {
        /// Where it stands.
        key: String,
        /// The block or group.
        name: String,
    },
    /// A bolt that is there already, or that there is not.
    #[error("{key}: {why}")]
    Bolt {
        /// Where it stands.
        key: String,
        /// What is wrong.
        why: String,
    },
    /// Not a number.
    #[error("{key} is not finite")]
    NotFinite {
        /// What was given.
        key: &'static str,
    },
    /// Motion of nodes, or one that a support prescribes.
    #[error("the velocity of {name:?} cannot be set: {why}")]
    Held {
        /// The block.
        name: String,
        /// Why.
        why: &'static str,
    },
    /// Nodes that there are not, or what they do not take.
    #[error("nodes of {name:?} cannot be pushed: {why}")]
    Nodes {
        /// The block.
        name: String,
        /// Why not.
        why: String,
    },
    /// A charge that cannot be.
    #[error("the source {name:?} cannot be charged: {why}")]
    Charge {
        /// The source.
        name: String,
        /// Why not.
        why: String,
    },
    /// A block that cannot be added.
    #[error("the block {name:?} cannot be added: {why}")]
    Block {
        /// Its name.
        name: String,
        /// Why not.
        why: String,
    },
    /// A material that cannot be changed.
    #[error("the material {name:?} cannot be changed: {why}")]
    Material {
        /// Its name.
        name: String,
        /// Why not.
        why: String,
    },
    /// A law of code that cannot be.
    #[error("the contact law {name:?} cannot act: {why}")]
    Law {
        /// Its name.
        name: String,
        /// Why not.
        why: String,
    },
    /// No phase is left.
    #[error("the run has ended: there is nothing left to change")]
    Ended,
    /// The run does not know its scene.
    #[error("this run was not begun from a scene in this process, which the keys of a change need")]
    NoScene,
    /// The physics.
    #[error(transparent)]
    Physics(#[from] RunError),
}

impl Simulation {
    /// Makes a change now.
    ///
    /// # Errors
    /// A bolt that cannot be installed, forces that are not finite; the run may not go on then, but can be
    /// [resumed](Simulation::resume) from a snapshot.
    pub fn change(&mut self, change: Change) -> Result<(), ChangeError> {
        let Change { edits, rules, later } = change;
        self.begin_present()?;
        let now = self.cursor.phase;
        let before = self.plan.phases[now].clone();
        self.plan.phases.truncate(now);
        self.plan.phases.push(rules);
        self.plan.phases.extend(later);
        if let Some(gravity) = edits.gravity {
            self.cursor.gravity_after = gravity;
        }
        if self.view().last_dt() > 0.0 {
            self.end_motion(Some(before), &edits)?;
        }
        self.apply(edits)?;
        self.forget();
        Ok(())
    }

    /// Enters a bolt and makes the change that installs it.
    pub(in crate::run) fn install_bolt(
        &mut self,
        bolt: NewBolt,
        change: Change,
    ) -> Result<(), ChangeError> {
        self.engine.add_bolt(bolt);
        self.change(change)
    }

    /// Sets the force (N) and the moment (N m; in the plane about z, per metre of thickness) that code puts on each block of a name, from now on until it is set again:
    /// beside the loads of the scene. Their work is that of the load `force on NAME`.
    ///
    /// # Errors
    /// A name of nothing, blocks that have been removed, numbers that are none.
    ///
    /// # Examples
    ///
    /// ```
    /// use riprap::run::simulation::Simulation;
    ///
    /// # let text = r#"
    /// # riprap = 1
    /// # title = "a stone in the void"
    /// # [space.planar]
    /// # gravity = ["0 m/s2", "0 m/s2"]
    /// # [materials.rock]
    /// # density = "2500 kg/m3"
    /// # [interfaces.default]
    /// # normal_stiffness = "1 GPa/m"
    /// # friction_angle = "30 deg"
    /// # [[blocks]]
    /// # name = "stone"
    /// # material = "rock"
    /// # rectangle = { size = ["1 m", "1 m"], corner = ["0 m", "0 m"] }
    /// # [[phases]]
    /// # name = "go"
    /// # until = { time = "1 s" }
    /// # time_step = "1 ms"
    /// # "#;
    /// let mut simulation = Simulation::from_toml(text)?;
    /// simulation.set_force("stone", [2500.0, 0.0, 0.0], [0.0; 3])?;
    /// simulation.run()?;
    /// assert!((simulation.field("block.velocity.x", &["stone"])? - 1.0).abs() < 1e-3);
    /// assert!(simulation.set_force("stoen", [0.0; 3], [0.0; 3]).is_err());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn set_force(
        &mut self,
        of: &str,
        force: [f64; 3],
        moment: [f64; 3],
    ) -> Result<(), ChangeError> {
        if !force.iter().chain(&moment).all(|x| x.is_finite()) {
            return Err(ChangeError::NotFinite { key: "the force" });
        }
        let blocks = self.blocks_of("set_force", of)?;
        if moment != [0.0; 3] && blocks.iter().any(|b| self.engine.nodes(*b).is_some()) {
            let why = "it deforms, and nodes take no moment: set forces on its nodes";
            return Err(ChangeError::Nodes { name: of.to_owned(), why: why.to_owned() });
        }
        self.engine.push(&format!("force on {of}"), &blocks, force, moment);
        self.forget();
        Ok(())
    }

    /// Nodes of a deformable block at the present instant.
    ///
    /// # Errors
    /// A name of nothing, of several blocks or of a rigid one, a block that has been removed.
    pub fn nodes(&self, of: &str) -> Result<Nodes, ChangeError> {
        let block = self.deformable("nodes", of)?;
        self.engine.nodes(block).ok_or(ChangeError::Ended)
    }

    /// Sets the forces (N) that code puts on nodes of a deformable block, from now on until they are set again: beside the loads of the scene, in
    /// place of those that were set on its nodes before. Their work is that of the load `force on nodes of NAME`. Where the block is cut, they
    /// act at the same places of its parts.
    ///
    /// # Errors
    /// A name of nothing, of several blocks or of a rigid one, a block that has been removed, nodes that there are not or that are named twice, numbers that
    /// are none.
    pub fn set_node_forces(
        &mut self,
        of: &str,
        forces: &[(u32, [f64; 3])],
    ) -> Result<(), ChangeError> {
        let block = self.deformable("set_node_forces", of)?;
        let count = self.engine.nodes(block).map_or(0, |nodes| nodes.masses.len());
        let wrong = |why: String| Err(ChangeError::Nodes { name: of.to_owned(), why });
        let mut there = vec![false; count];
        for (node, force) in forces {
            match there.get_mut(*node as usize) {
                None => return wrong(format!("it has nodes 0 to {}, not {node}", count - 1)),
                Some(true) => return wrong(format!("node {node} is named twice")),
                Some(new) => *new = true,
            }
            if !force.iter().all(|x| x.is_finite()) {
                return wrong(format!("the force on node {node} is not finite"));
            }
        }
        self.engine.push_nodes(&format!("force on nodes of {of}"), block, forces);
        self.forget();
        Ok(())
    }

    /// Number of the one deformable block of a name.
    fn deformable(&self, key: &str, of: &str) -> Result<u32, ChangeError> {
        let blocks = self.blocks_of(key, of)?;
        let wrong = |why: &str| ChangeError::Nodes { name: of.to_owned(), why: why.to_owned() };
        let [block] = blocks[..] else {
            return Err(wrong("it names several blocks, whose nodes have numbers of their own"));
        };
        match self.engine.nodes(block) {
            Some(_) => Ok(block),
            None => Err(wrong("it is rigid; use `set_force`")),
        }
    }

    /// Sets the velocity (m/s), the spin (rad/s; in the plane about z) or both of each block of a name at the present instant; what is not given
    /// stays. The energy that this adds is booked as an edit.
    ///
    /// # Errors
    /// A name of nothing, blocks that have been removed, deform or are held, numbers that are none, a spin out of the plane.
    pub fn set_velocity(
        &mut self,
        of: &str,
        velocity: Option<[f64; 3]>,
        spin: Option<[f64; 3]>,
    ) -> Result<(), ChangeError> {
        for (key, of) in [("the velocity", velocity), ("the spin", spin)] {
            if !of.iter().flatten().all(|x| x.is_finite()) {
                return Err(ChangeError::NotFinite { key });
            }
        }
        let in_plane = self.kind() != Kind::Spatial;
        if in_plane && spin.is_some_and(|[x, y, _]| x != 0.0 || y != 0.0) {
            let why = "a block of the plane spins about z alone";
            return Err(ChangeError::Held { name: of.to_owned(), why });
        }
        let blocks = self.blocks_of("set_velocity", of)?;
        for &b in &blocks {
            if let Some(why) = self.engine.bound(b) {
                return Err(ChangeError::Held { name: self.view().name(b), why });
            }
        }
        self.begin_present()?;
        self.booked(|engine| engine.set_velocity(&blocks, velocity, spin))
    }

    /// Gives a material (by its number) another density and in space other moduli at the present instant: of tetrahedra, bonds, joints and contacts whose
    /// stiffness comes of them. Displacements and velocities stay; what is stored changes with the stiffness, kinetic energy and weight with the mass, which is booked as an edit.
    ///
    /// # Errors
    /// Ranks, a phase that relaxes deformable blocks, boundaries and bonds that keep the stiffness they had.
    pub fn set_material(&mut self, row: u16, material: Material) -> Result<(), ChangeError> {
        self.begin_present()?;
        let name = material.name.clone();
        let wrong = |why: String| ChangeError::Material { name: name.clone(), why };
        if let Some(why) = self.engine.material_obstacle(row, &material) {
            return Err(wrong(why));
        }
        let mut done = Ok(());
        self.booked(|engine| done = engine.set_material(row, material))?;
        done.map_err(wrong)
    }

    /// Ends the motion at the present instant and makes an edit, whose energy is booked.
    pub(super) fn booked(&mut self, edit: impl FnOnce(&mut Engine)) -> Result<(), ChangeError> {
        let phase = self.plan.phases[self.cursor.phase].clone();
        let damping = phase.damping_in(self.engine.is_implicit());
        if self.view().last_dt() > 0.0 {
            self.meet_laws(&damping)?;
            let ended = self.engine.end_motion(&damping);
            ended.map_err(|block| self.no_force(block))?;
        }
        self.evaluate(&damping, 0.0)?;
        let before = self.view().balance().residual();
        edit(&mut self.engine);
        self.evaluate(&damping, 0.0)?;
        let after = self.view().balance().residual();
        self.engine.works().edit_defect += after - before;
        self.forget();
        Ok(())
    }

    /// Charges the hole of a source that has not gone off with a mass (kg), to go off `delay` (s) from now. Explosive, place and stemming are
    /// those of the scene, which gives the hole a `delay` beyond the end of the run where code decides when it is fired.
    ///
    /// # Errors
    /// A name of no source, a charge that has gone off, a pressure history, numbers that are none or below zero.
    pub fn charge(&mut self, of: &str, mass: f64, delay: f64) -> Result<(), ChangeError> {
        let wrong = |why: String| ChangeError::Charge { name: of.to_owned(), why };
        if !(mass.is_finite() && mass > 0.0) {
            return Err(wrong(format!("a mass of {mass} kg is none")));
        }
        if !(delay.is_finite() && delay >= 0.0) {
            return Err(wrong(format!("a delay of {delay} s is none")));
        }
        self.begin_present()?;
        let time = self.time() + delay;
        self.engine.charge(of, mass, time).map_err(wrong)?;
        self.forget();
        Ok(())
    }

    /// Enters the present phase, where that has not been done yet.
    pub(super) fn begin_present(&mut self) -> Result<(), ChangeError> {
        if self.phase().is_none() {
            return Err(ChangeError::Ended);
        }
        if !self.cursor.entered {
            self.enter_phase()?;
        }
        Ok(())
    }

    /// Blocks of the block or the group of a name.
    pub(super) fn named(&self, name: &str) -> Option<Vec<u32>> {
        let view = self.view();
        let groups = self.engine.groups();
        let group = groups.iter().find(|(known, _)| *known == name).map(|(_, all)| all.to_vec());
        let one = || (0..view.all_blocks() as u32).find(|b| view.name(*b) == name);
        group.or_else(|| one().map(|b| vec![b]))
    }

    /// Blocks for which a condition holds.
    fn fulfil(&self, key: &str, text: &str) -> Result<Vec<u32>, ChangeError> {
        let wrong = |why: String| {
            let (key, text) = (key.to_owned(), text.to_owned());
            ChangeError::Condition { key, text, why }
        };
        let condition = Condition::read(text).map_err(|fault| {
            wrong(format!("{}, behind {:?}", fault.why, &text[..fault.at.start]))
        })?;
        let mut sets = Vec::new();
        for word in &condition.names {
            let mut set = vec![false; self.view().all_blocks()];
            let named = self.named(&word.text).or_else(|| self.engine.of_material(&word.text));
            for b in named.ok_or_else(|| self.no_block(key, &word.text))? {
                set[b as usize] = true;
            }
            sets.push(set);
        }
        let holds = |b: &u32| condition.holds_by(&|k| sets[k][*b as usize]);
        let all: Vec<u32> = (0..self.view().all_blocks() as u32).filter(holds).collect();
        if all.is_empty() { Err(wrong("no block fulfils it".to_owned())) } else { Ok(all) }
    }

    fn no_block(&self, key: &str, name: &str) -> ChangeError {
        let view = self.view();
        let names: Vec<String> = (0..view.all_blocks() as u32).map(|b| view.name(b)).collect();
        let groups = self.engine.groups();
        let known = names.iter().map(String::as_str).chain(groups.iter().map(|(name, _)| *name));
        let near = nearest(name, known).map(str::to_owned);
        ChangeError::Unknown { key: key.to_owned(), name: name.to_owned(), near }
    }

    /// What was found for the state before a change.
    fn forget(&mut self) {
        self.standing = false;
        self.stable = None;
        self.cursor.stable = None;
        self.reason = None;
    }

    /// Blocks that are left of the block, the group or the condition of a name, which stands at `key`.
    pub(crate) fn blocks_of(&self, key: &str, name: &str) -> Result<Vec<u32>, ChangeError> {
        let all = match self.named(name) {
            Some(all) => all,
            None if Condition::is_meant(name) => self.fulfil(key, name)?,
            None => return Err(self.no_block(key, name)),
        };
        let left: Vec<u32> = all.into_iter().filter(|b| self.engine.is_alive(*b)).collect();
        if left.is_empty() {
            return Err(ChangeError::Removed { key: key.to_owned(), name: name.to_owned() });
        }
        Ok(left)
    }
}
