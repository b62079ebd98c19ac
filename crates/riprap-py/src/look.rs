//! What Python hears of a run while it goes on, and how it stops it.

use pyo3::prelude::*;
use riprap::run::drive::{self, Control};

/// A look at a run; a callback gets one about ten times a second.
#[pyclass(frozen, get_all, module = "riprap")]
pub struct Progress {
    /// Name of the phase.
    phase: String,
    /// Number of the phase, from 1.
    phase_number: usize,
    /// Number of phases.
    phases: usize,
    /// Share of the phase that is done, 0 to 1, or None where its end is not known.
    share: Option<f64>,
    /// Steps done.
    step: u64,
    /// Model time (s).
    time: f64,
    /// Time step (s).
    dt: f64,
    /// Steps per second of wall time.
    steps_per_second: f64,
    /// Expected wall time to the end of the phase (s), or None.
    remaining: Option<f64>,
    /// Kinetic energy, in `energy_unit`.
    kinetic: f64,
    /// Unit of energies: J, or J/m in the plane.
    energy_unit: &'static str,
    /// Energy residual over the largest energy that moved when the ledger was last drawn up, or None before.
    residual: Option<f64>,
    /// Unbalanced-force ratio.
    unbalanced: f64,
    /// Number of contacts.
    contacts: usize,
    /// Largest overlap over the smaller inscribed radius of its pair.
    worst_overlap: f64,
    /// Fastest block and its speed [m/s], or None.
    fastest: Option<(String, f64)>,
}

#[pymethods]
impl Progress {
    fn __repr__(&self) -> String {
        let share = self.share.map_or("?".to_owned(), |s| format!("{:.0}", 100.0 * s));
        format!(
            "Progress(phase={:?}, step={}, time={:e}, share={share} %)",
            self.phase, self.step, self.time
        )
    }
}

impl From<&mut drive::Look<'_>> for Progress {
    fn from(look: &mut drive::Look<'_>) -> Self {
        let m = look.measured().clone();
        let p = &look.progress;
        Self {
            phase: p.phase.clone(),
            phase_number: p.phase_number,
            phases: p.phases,
            share: p.share,
            step: p.step,
            time: p.time,
            dt: p.dt,
            steps_per_second: p.steps_per_second,
            remaining: p.remaining,
            kinetic: m.kinetic,
            energy_unit: p.energy_unit,
            residual: m.residual,
            unbalanced: m.unbalanced,
            contacts: m.contacts,
            worst_overlap: m.worst_overlap,
            fastest: m.fastest,
        }
    }
}

/// Whether the answer of a callback is to go on. A function without `return` means nothing by it.
pub fn goes_on(said: &Bound<'_, PyAny>) -> PyResult<bool> {
    Ok(said.is_none() || said.is_truthy()?)
}

/// Asks Python whether to go on: pending signals first, then the callback. Returning False or raising stops the run.
pub struct Look {
    callback: Option<Py<PyAny>>,
    /// What was raised; the run has been stopped for it.
    pub raised: Option<PyErr>,
}

impl Look {
    pub fn new(callback: Option<Py<PyAny>>) -> Self {
        Self { callback, raised: None }
    }

    pub fn ask(&mut self, look: &mut drive::Look<'_>) -> Control {
        let answer = Python::attach(|py| -> PyResult<bool> {
            py.check_signals()?;
            let Some(callback) = &self.callback else {
                return Ok(true);
            };
            goes_on(&callback.bind(py).call1((Progress::from(look),))?)
        });
        match answer {
            Ok(true) => Control::Continue,
            Ok(false) => Control::Stop,
            Err(error) => {
                self.raised.get_or_insert(error);
                Control::Stop
            }
        }
    }
}
