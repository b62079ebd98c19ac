//! Adding a block between two steps.

use riprap_core::condition::Condition;

use super::{ChangeError, Simulation};
use crate::run::engine::{Addition, NewBlock};

/// Characters of a name at most.
const LONGEST: usize = 200;

impl Simulation {
    /// Adds a rigid block at the present instant, where it lies in no other one; its mass, kg (in the plane kg/m).
    ///
    /// It has no joints and meets all others by contact under the interface of the two materials. Displacements count from where it is put, and its
    /// weight does no work before: what it adds to the energy, its energy of motion, is booked as an edit. A checkpoint holds it.
    ///
    /// # Errors
    /// A name that is taken, materials and groups that are none, a shape that is no convex solid (in the plane no polygon), a block in its way, contact
    /// that is switched off, ranks, water that seeps through joints, a phase that relaxes deformable blocks, the end of the run. Nothing has changed then.
    ///
    /// # Examples
    ///
    /// ```
    /// use riprap::run::engine::NewBlock;
    /// use riprap::run::simulation::Simulation;
    ///
    /// # let text = r#"
    /// # riprap = 1
    /// # title = "a floor"
    /// # [space.planar]
    /// # gravity = ["0 m/s2", "-9.81 m/s2"]
    /// # [materials.rock]
    /// # density = "2500 kg/m3"
    /// # [interfaces.default]
    /// # normal_stiffness = "1 GPa/m"
    /// # friction_angle = "30 deg"
    /// # [[blocks]]
    /// # name = "floor"
    /// # material = "rock"
    /// # rectangle = { size = ["9 m", "1 m"], corner = ["0 m", "-1 m"] }
    /// # [[supports]]
    /// # on = { block = "floor" }
    /// # fixed = {}
    /// # [[phases]]
    /// # name = "go"
    /// # until = { time = "1 s" }
    /// # "#;
    /// let mut simulation = Simulation::from_toml(text)?;
    /// simulation.run_for(0.1)?;
    /// let stone = NewBlock {
    ///     name: "stone".to_owned(),
    ///     material: "rock".to_owned(),
    ///     vertices: vec![[4.0, 1.0, 0.0], [5.0, 1.0, 0.0], [5.0, 2.0, 0.0], [4.0, 2.0, 0.0]],
    ///     ..NewBlock::default()
    /// };
    /// assert_eq!(simulation.add_block(&stone)?, 2500.0);
    /// simulation.run_for(0.1)?;
    /// assert!((simulation.field("block.velocity.y", &["stone"])? + 0.981).abs() < 1e-2);
    /// assert!(simulation.add_block(&stone).is_err(), "the name is taken");
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn add_block(&mut self, new: &NewBlock) -> Result<f64, ChangeError> {
        self.begin_present()?;
        let addition = self.plan_block(new)?;
        let mass = addition.mass();
        self.booked(|engine| engine.add_block(addition))?;
        Ok(mass)
    }

    /// Looks at a block that is to be added.
    pub(in crate::run) fn plan_block(&self, new: &NewBlock) -> Result<Addition, ChangeError> {
        let wrong = |why: String| ChangeError::Block { name: new.name.clone(), why };
        let name = new.name.as_str();
        let bad = name.trim().is_empty()
            || name.chars().count() > LONGEST
            || name.chars().any(char::is_control);
        if bad {
            return Err(wrong("its name is empty, too long or has control characters".to_owned()));
        }
        if name.contains('/') || Condition::is_meant(name) {
            let why = "its name reads as a part of a block or as a condition; use letters, digits, spaces, `_`, `-` and `.`";
            return Err(wrong(why.to_owned()));
        }
        if self.named(name).is_some() {
            return Err(wrong("a block or group has this name".to_owned()));
        }
        if self.relaxes() {
            return Err(wrong("the phase relaxes deformable blocks".to_owned()));
        }
        self.engine.plan_block(new).map_err(wrong)
    }
}
