//! A simulation advanced bit by bit.

use std::path::PathBuf;
use std::sync::Mutex;

use pyo3::exceptions::{PyRuntimeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use riprap::ledger;
use riprap::run::ask;
use riprap::run::drive::{DriveError, Ending, Pause};
use riprap::run::engine::steer::Steered;
use riprap::run::engine::{NewBlock, Reading, View};
use riprap::run::job::{JobError, Live, Outcome};
use riprap::run::simulation::ChangeError;

use crate::arrays;
use crate::errors;
use crate::law::{Law, Raised};
use crate::look::Look;
use crate::runs::existing;
use crate::scene::{Scene, json};

/// A run under way.
#[pyclass(frozen, module = "riprap._riprap")]
pub struct Simulation {
    live: Mutex<Option<Live>>,
    /// What a contact law raised.
    raised: Raised,
}

impl Simulation {
    fn of(live: Live) -> Self {
        Self { live: Mutex::new(Some(live)), raised: Raised::default() }
    }

    /// What a contact law raised in place of what the run says of it.
    fn raised_or(&self, py: Python<'_>, error: PyErr) -> PyErr {
        let raised = self.raised.lock().ok().and_then(|mut raised| raised.take());
        match raised {
            Some(raised) => {
                // Where it was, as a note under its traceback.
                let _ = raised.value(py).call_method1("add_note", (error.to_string(),));
                raised
            }
            None => error,
        }
    }

    /// Works on the run without the interpreter. A second caller (another thread, a callback) is turned away.
    fn with<T: Send>(
        &self,
        py: Python<'_>,
        work: impl FnOnce(&mut Option<Live>) -> PyResult<T> + Send,
    ) -> PyResult<T> {
        py.detach(|| match self.live.try_lock() {
            Ok(mut live) => work(&mut live),
            Err(_) => Err(PyRuntimeError::new_err(
                "the simulation is advancing; wait until `advance` returns",
            )),
        })
    }

    /// Edits the run; what is wrong with an edit is the caller's.
    fn edited<T: Send>(
        &self,
        py: Python<'_>,
        edit: impl FnOnce(&mut Live) -> Result<T, JobError> + Send,
    ) -> PyResult<T> {
        let edited = self.with(py, |live| {
            edit(open(live)?).map_err(|wrong| {
                Python::attach(|py| match wrong {
                    JobError::Drive(DriveError::Change(ChangeError::Keys(found))) => {
                        errors::scenario(py, &found)
                    }
                    JobError::Drive(DriveError::Change(wrong)) => {
                        PyValueError::new_err(wrong.to_string())
                    }
                    wrong => errors::job(py, &wrong),
                })
            })
        });
        edited.map_err(|error| self.raised_or(py, error))
    }

    fn read<T: Send>(
        &self,
        py: Python<'_>,
        get: impl FnOnce(&Live) -> PyResult<T> + Send,
    ) -> PyResult<T> {
        self.with(py, |live| get(open(live)?))
    }
}

fn open(live: &mut Option<Live>) -> PyResult<&mut Live> {
    live.as_mut().ok_or_else(|| PyValueError::new_err("the simulation is closed"))
}

/// `running`, or how it ended, and one sentence more.
fn state(live: &Live) -> (&'static str, String) {
    match live.ending() {
        None | Some(Ending::Stopped) => ("running", String::new()),
        Some(Ending::Finished) => ("finished", String::new()),
        Some(Ending::Unstable(why)) => ("unstable", why.to_string()),
    }
}

#[pymethods]
impl Simulation {
    /// Builds the model; with a folder everything is recorded as by a run.
    #[new]
    fn new(
        py: Python<'_>,
        scene: &Scene,
        case: Option<&str>,
        folder: Option<PathBuf>,
        existing_folder: &str,
        threads: usize,
    ) -> PyResult<Self> {
        let existing = existing(existing_folder)?;
        let prepared = scene.prepare(py, case)?;
        let parsed = prepared.parsed.clone();
        let job = prepared.job();
        let begun = py.detach(|| {
            let mut live = match &folder {
                Some(folder) => Live::begin(job, folder, existing, threads)?,
                None => Live::unrecorded(job, threads)?,
            };
            // Forces at the start.
            let here = Pause { step: Some(0), time: None };
            live.advance(here, &mut |_| riprap::run::drive::Control::Continue)?;
            Ok(live)
        });
        match begun {
            Ok(live) => Ok(Self::of(live)),
            Err(error) => Err(errors::job_of(py, &error, &parsed)),
        }
    }

    /// Reopens the run of a folder at its last checkpoint; forces are found by the first advance.
    #[staticmethod]
    fn reopen(py: Python<'_>, folder: PathBuf, threads: usize) -> PyResult<Self> {
        let live = py.detach(|| Live::reopen(&folder, threads));
        live.map(Self::of).map_err(|error| errors::job(py, &error))
    }

    /// Puts a law on the contacts of a group or between two.
    fn contact_law(
        &self,
        py: Python<'_>,
        name: &str,
        of: Vec<String>,
        function: Py<PyAny>,
        memory: usize,
    ) -> PyResult<()> {
        let law = Law::new(function, memory, self.raised.clone());
        let of: Vec<&str> = of.iter().map(String::as_str).collect();
        self.edited(py, |live| live.contact_law(name, &of, Box::new(law)))
    }

    /// What contact laws have cost: name, calls, seconds.
    #[getter]
    fn law_costs(&self, py: Python<'_>) -> PyResult<Vec<(String, u64, f64)>> {
        self.read(py, |live| {
            let costs = live.simulation().law_costs().into_iter();
            Ok(costs.map(|cost| (cost.name, cost.calls, cost.seconds)).collect())
        })
    }

    /// Changes density and moduli of a material, given as the TOML text of its keys.
    fn set_material(&self, py: Python<'_>, name: &str, keys: &str) -> PyResult<()> {
        self.edited(py, |live| live.set_material(name, keys))
    }

    /// Installs a bolt, given as the TOML text of its keys.
    fn install_bolt(&self, py: Python<'_>, keys: &str) -> PyResult<()> {
        self.edited(py, |live| live.install_bolt(keys))
    }

    /// Goes on by a number of steps or a span of model time, or to the end; the state it is in then.
    #[pyo3(signature = (steps, time, callback))]
    fn advance(
        &self,
        py: Python<'_>,
        steps: Option<u64>,
        time: Option<f64>,
        callback: Option<Py<PyAny>>,
    ) -> PyResult<(&'static str, String)> {
        let mut look = Look::new(callback);
        let asked = &mut look;
        let result = self.with(py, |live| {
            let live = open(live)?;
            let now = live.simulation();
            let pause = Pause {
                step: steps.map(|n| now.steps().saturating_add(n)),
                time: time.map(|span| now.time() + span),
            };
            let ended = live.advance(pause, &mut |progress| asked.ask(progress));
            ended.map(|_| state(live)).map_err(|error| Python::attach(|py| errors::job(py, &error)))
        });
        match look.raised {
            Some(raised) => Err(raised),
            None => result.map_err(|error| self.raised_or(py, error)),
        }
    }

    /// Gives a load (by a factor) or a support (by a velocity) another value from now on.
    #[pyo3(signature = (name, factor=None, velocity=None))]
    fn steer(
        &self,
        py: Python<'_>,
        name: &str,
        factor: Option<f64>,
        velocity: Option<[f64; 3]>,
    ) -> PyResult<()> {
        let to = match (factor, velocity) {
            (Some(factor), None) => Steered::Factor(factor),
            (None, Some(velocity)) => Steered::Velocity(velocity),
            (Some(_), Some(_)) | (None, None) => {
                return Err(PyValueError::new_err(
                    "give `factor` for a load, or `velocity` for a support",
                ));
            }
        };
        self.with(py, |live| match open(live)?.steer(name, to) {
            Ok(()) => Ok(()),
            Err(JobError::Drive(DriveError::Steer(wrong))) => {
                Err(PyValueError::new_err(wrong.to_string()))
            }
            Err(wrong) => Err(Python::attach(|py| errors::job(py, &wrong))),
        })
    }

    /// Makes a change, given as the TOML text of keys of a phase.
    fn change(&self, py: Python<'_>, keys: &str) -> PyResult<()> {
        self.edited(py, |live| live.change(keys))
    }

    /// Sets force and moment on each block of a name.
    fn set_force(
        &self,
        py: Python<'_>,
        of: &str,
        force: [f64; 3],
        moment: [f64; 3],
    ) -> PyResult<()> {
        self.edited(py, |live| live.set_force(of, force, moment))
    }

    /// Sets forces on nodes of a deformable block.
    fn set_node_forces(
        &self,
        py: Python<'_>,
        of: &str,
        forces: Vec<(u32, [f64; 3])>,
    ) -> PyResult<()> {
        self.edited(py, |live| live.set_node_forces(of, &forces))
    }

    /// Nodes of a deformable block: places, displacements, velocities, masses.
    fn nodes<'py>(&self, py: Python<'py>, of: &str) -> PyResult<[Bound<'py, PyAny>; 4]> {
        let nodes = self.read(py, |live| {
            live.simulation().nodes(of).map_err(|wrong| PyValueError::new_err(wrong.to_string()))
        })?;
        arrays::nodes(py, nodes)
    }

    /// Sets velocity, spin or both of each block of a name.
    #[pyo3(signature = (of, velocity=None, spin=None))]
    fn set_velocity(
        &self,
        py: Python<'_>,
        of: &str,
        velocity: Option<[f64; 3]>,
        spin: Option<[f64; 3]>,
    ) -> PyResult<()> {
        self.edited(py, |live| live.set_velocity(of, velocity, spin))
    }

    /// Charges the hole of a source.
    fn charge(&self, py: Python<'_>, of: &str, mass: f64, delay: f64) -> PyResult<()> {
        self.edited(py, |live| live.charge(of, mass, delay))
    }

    /// Adds a block; its mass.
    #[pyo3(signature = (name, shape, material, groups, motion))]
    fn add_block(
        &self,
        py: Python<'_>,
        name: String,
        shape: (Vec<[f64; 3]>, Vec<Vec<u32>>),
        material: String,
        groups: Vec<String>,
        motion: [[f64; 3]; 2],
    ) -> PyResult<f64> {
        let ((vertices, faces), [velocity, spin]) = (shape, motion);
        let new = NewBlock { name, material, groups, vertices, faces, velocity, spin };
        self.edited(py, |live| live.add_block(&new))
    }

    /// Closes the ledger: the manifest as JSON text. What has not ended can be resumed.
    fn close(&self, py: Python<'_>) -> PyResult<Option<String>> {
        let closed = self.with(py, |live| Ok(live.take().map(Live::close)))?;
        match closed {
            None => Ok(None),
            Some(Ok(Outcome { manifest, .. })) => json(&manifest).map(Some),
            Some(Err(error)) => Err(errors::job(py, &error)),
        }
    }

    /// `running`, `finished` or `unstable`, and one sentence more.
    #[getter]
    fn state(&self, py: Python<'_>) -> PyResult<(&'static str, String)> {
        self.read(py, |live| Ok(state(live)))
    }

    /// Step, time, next time step, phase.
    #[getter]
    fn now(&self, py: Python<'_>) -> PyResult<(u64, f64, f64, String)> {
        self.read(py, |live| {
            let s = live.simulation();
            let phase = s.phase().map_or_else(String::new, |p| p.name.clone());
            Ok((s.steps(), s.time(), s.dt(), phase))
        })
    }

    /// Hash of the state.
    #[getter]
    fn state_hash(&self, py: Python<'_>) -> PyResult<String> {
        self.read(py, |live| Ok(live.simulation().engine().hash()))
    }

    /// Names of all blocks ever, by number.
    #[getter]
    fn names(&self, py: Python<'_>) -> PyResult<Vec<String>> {
        self.read(py, |live| Ok(names(&live.simulation().view())))
    }

    /// A snapshot of blocks and contacts.
    fn frame<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let frame = self.read(py, |live| {
            let s = live.simulation();
            let phase = s.phase().map_or("", |p| p.name.as_str());
            Ok(s.view().frame(phase))
        })?;
        arrays::frame(py, frame)
    }

    /// The energy ledger: (name, value), and the unit.
    fn energy(&self, py: Python<'_>) -> PyResult<(Vec<(&'static str, f64)>, &'static str)> {
        self.read(py, |live| {
            let s = live.simulation();
            let balance = s.view().balance().times(s.view().slice());
            let all = ledger::COLUMNS.iter().map(|(name, get)| (*name, get(&balance)));
            Ok((all.collect(), s.kind().energy_unit()))
        })
    }

    /// The histories of the scenario now: (name, value, unit).
    fn histories(&self, py: Python<'_>) -> PyResult<Vec<(String, f64, &'static str)>> {
        self.read(py, |live| {
            let s = live.simulation();
            let view = s.view();
            let one = |h: &riprap::plan::History| {
                let reading = Reading::new(s.kind(), &h.gauge)
                    .map_err(|e| PyValueError::new_err(e.to_string()))?;
                Ok((h.name.clone(), reading.value(&view), reading.info().unit))
            };
            s.plan().histories.iter().map(one).collect()
        })
    }

    /// A field now, of blocks given by name: the value and its unit.
    fn value(
        &self,
        py: Python<'_>,
        name: &str,
        of: Vec<String>,
        along: Option<[f64; 3]>,
    ) -> PyResult<(f64, &'static str)> {
        self.read(py, |live| {
            let s = live.simulation();
            let view = s.view();
            let mut gauge =
                ask::gauge(&view, name, &of).map_err(|e| PyValueError::new_err(e.to_string()))?;
            gauge.along = along.map(unit).transpose()?;
            let reading =
                Reading::new(s.kind(), &gauge).map_err(|e| PyValueError::new_err(e.to_string()))?;
            Ok((reading.value(&view), reading.info().unit))
        })
    }
}

fn names(view: &View<'_>) -> Vec<String> {
    let count = match view {
        View::Planar(v) => v.world.setup.blocks.len(),
        View::Spatial(v) => v.world.alive.len(),
    };
    (0..count as u32).map(|b| view.name(b)).collect()
}

fn unit(v: [f64; 3]) -> PyResult<[f64; 3]> {
    let length = v.iter().map(|x| x * x).sum::<f64>().sqrt();
    if length > 0.0 && length.is_finite() {
        Ok(v.map(|x| x / length))
    } else {
        Err(PyValueError::new_err("`along` has zero length"))
    }
}
