//! A run that code steers between steps: other values, changes as of a phase, forces and velocities.

use super::{JobError, Live};
use crate::run::drive::{Control, DriveError, Ending, Pause};
use crate::run::engine::NewBlock;
use crate::run::engine::steer::Steered;
use crate::run::simulation::{ChangeError, ContactLaw, Simulation};

impl Live {
    /// Gives a load or a support that the scene names another value from the present instant on.
    ///
    /// # Errors
    /// As [`crate::run::drive::Drive::steer`].
    pub fn steer(&mut self, name: &str, to: Steered) -> Result<(), JobError> {
        Ok(self.drive.steer(name, to)?)
    }

    /// Makes a change at the present instant, written as the keys of a phase in TOML: `remove`, `removal_ramp`, `fix`, `release`, `gravity`, `water`,
    /// `reset`, `interfaces`, `install` (names of bolts), and the rules `until`, `time_step`, `safety`, `damping`, `max_residual` of the
    /// present phase. What it adds to the energy is booked as an edit, an event of the run says what was changed, and the same changes
    /// at the same steps give the same bits.
    ///
    /// # Errors
    /// Keys that are wrong or that cannot change within a phase, blocks that are not there any more; the run stays as it was then.
    ///
    /// # Examples
    ///
    /// ```
    /// use riprap::run::drive::{Control, Pause};
    /// use riprap::run::job::Live;
    /// use riprap::run::scene::Scene;
    /// use riprap::scenario::Source;
    ///
    /// // A stone on a slope of 30 degrees, friction angle 40 degrees.
    /// # let text = r#"
    /// # riprap = 1
    /// # title = "a stone on a slope"
    /// # [space.planar]
    /// # gravity = ["0 m/s2", "-9.81 m/s2"]
    /// # tilt = "30 deg"
    /// # [materials.rock]
    /// # density = "2500 kg/m3"
    /// # [interfaces.default]
    /// # normal_stiffness = "1 GPa/m"
    /// # friction_angle = "40 deg"
    /// # [[blocks]]
    /// # name = "slope"
    /// # material = "rock"
    /// # rectangle = { size = ["20 m", "1 m"], corner = ["-10 m", "-1 m"] }
    /// # [[blocks]]
    /// # name = "stone"
    /// # material = "rock"
    /// # rectangle = { size = ["2 m", "1 m"], corner = ["0 m", "0 m"] }
    /// # [[supports]]
    /// # on = { block = "slope" }
    /// # fixed = {}
    /// # [[phases]]
    /// # name = "slide"
    /// # until = { time = "1 s" }
    /// # "#;
    /// let scene = Scene::parse(Source::new("slope.toml", text), ".".into(), &[])?;
    /// let mut live = Live::unrecorded(scene.prepare(&scene.plain())?.job(), 1)?;
    /// live.advance(Pause { time: Some(0.5), step: None }, &mut |_| Control::Continue)?;
    /// assert!(live.simulation().field("block.speed", &["stone"])? < 0.1);
    /// live.change("interfaces.default.friction_angle = \"10 deg\"")?;
    /// live.advance(Pause { time: Some(0.9), step: None }, &mut |_| Control::Continue)?;
    /// assert!(live.simulation().field("block.speed", &["stone"])? > 1.0);
    /// assert!(live.change("remove = [\"stoen\"]").is_err());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[cfg(feature = "scenario")]
    pub fn change(&mut self, keys: &str) -> Result<(), JobError> {
        self.not_ended()?;
        let scene = self.scene.as_ref().ok_or(ChangeError::NoScene).map_err(DriveError::from)?;
        let keys = crate::run::change::parse(keys).map_err(DriveError::from)?;
        let read = scene.read(&keys, self.drive.simulation());
        let (change, scene) = read.map_err(DriveError::from)?;
        let event = serde_json::json!({ "event": "changed", "keys": keys });
        self.edit(event, |simulation| simulation.change(change.clone()))?;
        self.scene = Some(scene);
        Ok(())
    }

    /// Changes a material at the present instant, written as its keys in TOML (`density`; in space also `young`, `poisson`): masses, tetrahedra, bonds, joints and
    /// contacts whose stiffness comes of them; velocities stay. What it adds to the energy is booked as an edit, and an event of the run says what was changed.
    ///
    /// # Errors
    /// Keys that are wrong or that cannot change; as [`Simulation::set_material`]. The run stays as it was then.
    #[cfg(feature = "scenario")]
    pub fn set_material(&mut self, name: &str, keys: &str) -> Result<(), JobError> {
        self.not_ended()?;
        let scene = self.scene.as_ref().ok_or(ChangeError::NoScene).map_err(DriveError::from)?;
        let keys = crate::run::change::parse(keys).map_err(DriveError::from)?;
        let read = scene.read_material(name, &keys, self.drive.simulation());
        let (row, material, scene) = read.map_err(DriveError::from)?;
        let event = serde_json::json!({ "event": "material changed", "of": name, "keys": keys });
        self.edit(event, |simulation| simulation.set_material(row, material.clone()))?;
        self.scene = Some(scene);
        Ok(())
    }

    /// Installs a bolt that the scene does not have, in the rock as it is now: keys of a table of `[[bolts]]` in TOML, `head` and `toe` in the coordinates of the
    /// scene, and either `like = "BOLT"`, a bolt of the scene whose steel, grout and plate it takes over where it does not say its own, or all of them.
    /// Without a `name` it is called `bolt by code 1`, ... It has no force but for its `pretension`; an event of the run says what was installed.
    ///
    /// # Errors
    /// Keys that are wrong, a name that is taken, a bolt that is not in rock. The run stays as it was then.
    #[cfg(feature = "scenario")]
    pub fn install_bolt(&mut self, keys: &str) -> Result<(), JobError> {
        self.not_ended()?;
        let scene = self.scene.as_ref().ok_or(ChangeError::NoScene).map_err(DriveError::from)?;
        let keys = crate::run::change::parse(keys).map_err(DriveError::from)?;
        let read = scene.read_bolt(&keys, self.drive.simulation()).map_err(DriveError::from)?;
        let event =
            serde_json::json!({ "event": "bolt installed", "name": read.name, "keys": keys });
        self.edit(event, |simulation| {
            simulation.install_bolt(read.bolt.clone(), read.change.clone())
        })?;
        self.scene = Some(read.scene);
        Ok(())
    }

    /// Changes keys of an interface at the present instant, written in TOML (`friction_angle = "20 deg"`): as [`Live::change`] with them under
    /// `interfaces.NAME`.
    ///
    /// # Errors
    /// As there; keys that have no effect.
    #[cfg(feature = "scenario")]
    pub fn set_interface(&mut self, name: &str, keys: &str) -> Result<(), JobError> {
        let keys = crate::run::change::parse(keys).map_err(DriveError::from)?;
        let all = toml::Table::from_iter([(name.to_owned(), keys.into())]);
        self.change(&toml::Table::from_iter([("interfaces".to_owned(), all.into())]).to_string())
    }

    /// As [`Simulation::set_force`]; an event of the run says so.
    ///
    /// # Errors
    /// As there, and the disk.
    pub fn set_force(
        &mut self,
        of: &str,
        force: [f64; 3],
        moment: [f64; 3],
    ) -> Result<(), JobError> {
        self.not_ended()?;
        let event = serde_json::json!({
            "event": "force set", "of": of, "force": force, "moment": moment,
        });
        self.edit(event, |simulation| simulation.set_force(of, force, moment))
    }

    /// As [`Simulation::set_velocity`]; an event of the run says so.
    ///
    /// # Errors
    /// As there, and the disk.
    pub fn set_velocity(
        &mut self,
        of: &str,
        velocity: Option<[f64; 3]>,
        spin: Option<[f64; 3]>,
    ) -> Result<(), JobError> {
        self.not_ended()?;
        let mut event = serde_json::json!({ "event": "velocity set", "of": of });
        for (key, value) in [("velocity", velocity), ("spin", spin)] {
            if let Some(value) = value {
                event[key] = value.to_vec().into();
            }
        }
        self.edit(event, |simulation| simulation.set_velocity(of, velocity, spin))
    }

    /// As [`Simulation::set_node_forces`]; an event of the run says so.
    ///
    /// # Errors
    /// As there, and the disk.
    pub fn set_node_forces(
        &mut self,
        of: &str,
        forces: &[(u32, [f64; 3])],
    ) -> Result<(), JobError> {
        self.not_ended()?;
        let nodes: Vec<u32> = forces.iter().map(|(node, _)| *node).collect();
        let values: Vec<[f64; 3]> = forces.iter().map(|(_, force)| *force).collect();
        let event = serde_json::json!({
            "event": "node forces set", "of": of, "nodes": nodes, "forces": values,
        });
        self.edit(event, |simulation| simulation.set_node_forces(of, forces))
    }

    /// As [`Simulation::charge`]; an event of the run says so, and the manifest has the charge.
    ///
    /// # Errors
    /// As there, and the disk.
    pub fn charge(&mut self, of: &str, mass: f64, delay: f64) -> Result<(), JobError> {
        self.not_ended()?;
        let event = serde_json::json!({
            "event": "charged", "of": of, "mass": mass, "delay": delay,
        });
        self.edit(event, |simulation| simulation.charge(of, mass, delay))
    }

    /// As [`Simulation::add_block`]; an event of the run says so.
    ///
    /// # Errors
    /// As there, and the disk.
    pub fn add_block(&mut self, new: &NewBlock) -> Result<f64, JobError> {
        self.not_ended()?;
        let planned = self.simulation().plan_block(new).map_err(DriveError::from)?;
        let mass = planned.mass();
        let event = serde_json::json!({
            "event": "block_added", "block": new.name, "material": new.material, "groups": new.groups,
            "mass": mass, "velocity": new.velocity, "spin": new.spin,
            "vertices": new.vertices, "faces": new.faces,
        });
        self.edit(event, |simulation| simulation.add_block(new).map(drop))?;
        #[cfg(feature = "scenario")]
        if let Some(scene) = &mut self.scene {
            scene.added(&new.name);
        }
        Ok(mass)
    }

    /// As [`Simulation::contact_law`]; an event of the run says so. A run that is reopened is given the law again before it goes on.
    ///
    /// # Errors
    /// As there, and the disk.
    pub fn contact_law(
        &mut self,
        name: &str,
        of: &[&str],
        law: Box<dyn ContactLaw>,
    ) -> Result<(), JobError> {
        self.not_ended()?;
        let width = law.memory();
        let event = serde_json::json!({
            "event": "contact law", "law": name, "of": of, "memory": width,
        });
        self.drive.set_law(name, Some(law))?;
        let begun = self.edit(event, |simulation| simulation.begin_law(name, of, width));
        if let Err(JobError::Drive(DriveError::Change(_))) = &begun {
            self.drive.set_law(name, None)?;
        }
        begun
    }

    fn not_ended(&self) -> Result<(), DriveError> {
        match self.ending {
            Some(Ending::Finished | Ending::Unstable(_)) => Err(ChangeError::Ended.into()),
            Some(Ending::Stopped) | None => Ok(()),
        }
    }

    /// Edits the simulation, and finds the forces of the present instant, so that they can be read, whether it was edited or not.
    fn edit(
        &mut self,
        event: serde_json::Value,
        edit: impl Fn(&mut Simulation) -> Result<(), ChangeError>,
    ) -> Result<(), JobError> {
        let edited = self.drive.edit(event, edit);
        let here = Pause { step: Some(self.simulation().steps()), time: None };
        self.advance(here, &mut |_| Control::Continue)?;
        Ok(edited?)
    }
}
