//! A simulation advanced by hand: batches of steps with nothing read between, and fields by name.

use super::{RunError, Simulation, Stage};
use crate::run::ask::{AskError, gauge};
use crate::run::engine::Reading;

/// Where an advance came to a stop.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reached {
    /// As far as was asked.
    Asked,
    /// At the end of the plan before.
    End,
}

impl Simulation {
    /// Does `steps` steps, through phases, with nothing read between; then finds the forces, so that fields can be read.
    ///
    /// The steps are those of a run: advancing 2 and 3 steps gives the bits of advancing 5.
    ///
    /// # Errors
    /// The physics stopped the run; the state is still the last one.
    ///
    /// # Examples
    ///
    /// A block of 1 m falls for a hundred steps of 1 ms; the model is built without a scene file.
    ///
    /// ```
    /// use riprap::Vec2;
    /// use riprap::exec::Exec;
    /// use riprap::planar::setup::{BlockSpec, ContactLaw, FrictionLaw, Interface, NormalLaw, Reflex, Setup};
    /// use riprap::plan::{Plan, Phase, TimeStep};
    /// use riprap::run::simulation::{Reached, Simulation};
    ///
    /// let corners = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    /// let block = BlockSpec {
    ///     name: "stone".to_owned(),
    ///     vertices: corners.map(Vec2::from).to_vec(),
    ///     material: 0,
    ///     density: 2500.0,
    ///     velocity: Vec2::ZERO,
    ///     spin: 0.0,
    /// };
    /// let contact = ContactLaw {
    ///     normal: NormalLaw::DistancePotential,
    ///     reflex: Reflex::Min,
    ///     normal_stiffness: 1e9,
    ///     shear_stiffness: 1e9,
    ///     friction: 0.6,
    ///     cohesion: 0.0,
    ///     friction_law: FrictionLaw::ShearSpring,
    ///     clip_speed: 0.0,
    ///     damping_ratio: 0.1,
    /// };
    /// let setup = Setup {
    ///     gravity: [0.0, -10.0],
    ///     materials: vec!["rock".to_owned()],
    ///     blocks: vec![block],
    ///     interfaces: vec![Interface { name: "default".to_owned(), contact, bond: None }],
    ///     pair_table: vec![0],
    ///     ..Setup::default()
    /// };
    /// let fall = Phase {
    ///     time_step: TimeStep::Given { dt: 1e-3 },
    ///     ..Phase::dynamic("fall", 1.0)
    /// };
    /// let plan = Plan { phases: vec![fall], ..Plan::default() };
    ///
    /// let mut simulation = Simulation::new(setup, plan, Exec::serial())?;
    /// assert_eq!(simulation.advance(100)?, Reached::Asked);
    /// let fallen = simulation.field("block.displacement.y", &["stone"])?;
    /// assert!((fallen + 0.5 * 10.0 * 0.1 * 0.1).abs() < 1e-6);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn advance(&mut self, steps: u64) -> Result<Reached, RunError> {
        self.advance_until(self.steps().saturating_add(steps), f64::INFINITY)
    }

    /// Goes on for a span of model time, s, to the first state that is not before its end; as [`Simulation::advance`].
    ///
    /// # Errors
    /// As [`Simulation::advance`].
    pub fn run_for(&mut self, seconds: f64) -> Result<Reached, RunError> {
        self.advance_until(u64::MAX, self.time() + seconds)
    }

    /// Goes on to the end of the plan; as [`Simulation::advance`].
    ///
    /// # Errors
    /// As [`Simulation::advance`].
    pub fn run(&mut self) -> Result<(), RunError> {
        self.advance_until(u64::MAX, f64::INFINITY).map(|_| ())
    }

    fn advance_until(&mut self, step: u64, time: f64) -> Result<Reached, RunError> {
        loop {
            if !self.standing {
                match self.prepare()? {
                    Stage::Within => self.standing = true,
                    Stage::PhaseEnd => {
                        // Kept in the cursor, for who asks.
                        self.note_unconverged();
                        self.note_end();
                        let last = self.cursor.phase + 1 >= self.plan.phases.len();
                        self.next_phase();
                        if last {
                            return Ok(Reached::End);
                        }
                        continue;
                    }
                    Stage::Done => return Ok(Reached::End),
                }
            }
            if self.steps() >= step || self.time() >= time - 1e-9 * self.dt {
                return Ok(Reached::Asked);
            }
            self.step();
        }
    }

    /// A field now, SI, with its component where it is a vector (`block.velocity.x`; without one its magnitude): of the
    /// blocks or the source called `of`, of nothing for fields of the whole model (`riprap fields` lists them).
    ///
    /// To be read after an advance, or after [`Simulation::prepare`].
    ///
    /// # Errors
    /// Unknown fields and names, a wrong number of names.
    pub fn field<S: AsRef<str>>(&self, field: &str, of: &[S]) -> Result<f64, AskError> {
        let view = self.view();
        let reading = Reading::new(self.kind(), &gauge(&view, field, of)?)?;
        Ok(reading.value(&view))
    }
}
