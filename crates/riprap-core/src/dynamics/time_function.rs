//! Functions of time that drive supports and loads.

use serde::{Deserialize, Serialize};

use super::Formula;

/// A number that depends on time; argument in s, value in the SI unit of what it drives.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum TimeFunction {
    /// The same at all times.
    Constant(f64),
    /// `from` until `start`, then linear to `to` at `end`, then `to`.
    Ramp {
        /// Value before `start`.
        from: f64,
        /// Value after `end`.
        to: f64,
        /// Start of the ramp, s.
        start: f64,
        /// End of the ramp, s.
        end: f64,
    },
    /// `offset + amplitude sin(2 pi f (t - start) + phase)`; before `start` and after `cycles` periods it is `offset`.
    Sine {
        /// Amplitude.
        amplitude: f64,
        /// Frequency, Hz.
        frequency: f64,
        /// Phase, rad.
        phase: f64,
        /// Mean value.
        offset: f64,
        /// Begin, s.
        start: f64,
        /// Number of periods after which it stops; `None` goes on.
        cycles: Option<f64>,
    },
    /// `value` from `start` (included) to `end` (excluded), else 0.
    Pulse {
        /// Value within the pulse.
        value: f64,
        /// Start, s.
        start: f64,
        /// End, s.
        end: f64,
    },
    /// Linear between the given times, constant outside.
    Table {
        /// Times, s, ascending.
        t: Vec<f64>,
        /// Values.
        v: Vec<f64>,
    },
    /// A formula in `t`; where a motion is prescribed point by point in x, y, z too ([`TimeFunction::at_place`]).
    Formula(Formula),
    /// `amplitude (exp(-decay t) - exp(-rise t))` from time 0, before that 0 (Duvall 1953); see
    /// [`TimeFunction::duvall`].
    Duvall {
        /// Value that the difference of the exponentials is multiplied by; larger than the peak.
        amplitude: f64,
        /// Rate of the slow exponential, 1/s.
        decay: f64,
        /// Rate of the fast exponential, 1/s; above `decay`.
        rise: f64,
    },
}

impl TimeFunction {
    /// Value at time `t` (s).
    #[must_use]
    pub fn at(&self, t: f64) -> f64 {
        match self {
            Self::Constant(value) => *value,
            Self::Ramp { from, to, start, end } => {
                if t <= *start {
                    *from
                } else if t >= *end {
                    *to
                } else {
                    from + (to - from) * (t - start) / (end - start)
                }
            }
            Self::Sine { amplitude, frequency, phase, offset, start, cycles } => {
                let since = t - start;
                if since < 0.0 || cycles.is_some_and(|n| since * frequency >= n) {
                    return *offset;
                }
                let angle = 2.0 * std::f64::consts::PI * frequency * since + phase;
                offset + amplitude * libm::sin(angle)
            }
            Self::Pulse { value, start, end } => {
                if t >= *start && t < *end {
                    *value
                } else {
                    0.0
                }
            }
            Self::Table { t: times, v } => table_at(times, v, t),
            Self::Formula(formula) => formula.value(&[("t", t)]),
            Self::Duvall { amplitude, decay, rise } => {
                if t > 0.0 {
                    amplitude * (libm::exp(-decay * t) - libm::exp(-rise * t))
                } else {
                    0.0
                }
            }
        }
    }

    /// Value at time `t` (s) for a point that was at `place` (m, global) at the start.
    ///
    /// # Examples
    ///
    /// ```
    /// use riprap_core::dynamics::{Formula, TimeFunction};
    ///
    /// let shear = TimeFunction::Formula(Formula::new("0.1*z*t", &["t", "x", "y", "z"])?);
    /// assert_eq!(shear.at_place(2.0, [0.0, 0.0, 5.0]), 1.0);
    /// # Ok::<(), riprap_core::dynamics::formula::FormulaError>(())
    /// ```
    #[must_use]
    pub fn at_place(&self, t: f64, [x, y, z]: [f64; 3]) -> f64 {
        match self {
            Self::Formula(formula) => formula.value(&[("t", t), ("x", x), ("y", y), ("z", z)]),
            Self::Constant(_)
            | Self::Ramp { .. }
            | Self::Sine { .. }
            | Self::Pulse { .. }
            | Self::Table { .. }
            | Self::Duvall { .. } => self.at(t),
        }
    }

    /// Value for a kick at time `t` (s) that spans the `half` steps (s) before and after it: where the function jumps in between, the values
    /// before and after the jump count with their times, so that the impulse is right wherever the jump falls in a step. Jumps of formulas are
    /// not known.
    #[must_use]
    pub fn in_kick(&self, t: f64, half: [f64; 2]) -> f64 {
        let (start, end) = (t - half[0], t + half[1]);
        let mut value = self.at(t);
        self.jumps(&mut |at, by| {
            if at > start && at <= t {
                value -= by * (at - start) / (end - start);
            } else if at > t && at < end {
                value += by * (end - at) / (end - start);
            }
        });
        value
    }

    /// Hands over the times (s) at which it jumps, each with what it jumps by; from that time on it has the new value.
    fn jumps(&self, put: &mut dyn FnMut(f64, f64)) {
        match self {
            Self::Pulse { value, start, end } => {
                put(*start, *value);
                put(*end, -value);
            }
            Self::Sine { amplitude, frequency, phase, start, cycles, .. } => {
                put(*start, amplitude * libm::sin(*phase));
                if let Some(n) = cycles {
                    let angle = 2.0 * std::f64::consts::PI * n + phase;
                    put(start + n / frequency, -amplitude * libm::sin(angle));
                }
            }
            Self::Table { t, v } => {
                let pairs = t.windows(2).zip(v.windows(2));
                for (t, v) in pairs.filter(|(t, _)| t[0] == t[1]) {
                    put(t[0], v[1] - v[0]);
                }
            }
            Self::Constant(_) | Self::Ramp { .. } | Self::Duvall { .. } | Self::Formula(_) => {}
        }
    }

    /// The two-exponential history with the given largest value, reached at `ln(rise/decay)/(rise - decay)`.
    ///
    /// Rates in 1/s, `rise > decay > 0`.
    #[must_use]
    pub fn duvall(peak: f64, decay: f64, rise: f64) -> Self {
        let top = libm::log(rise / decay) / (rise - decay);
        Self::Duvall {
            amplitude: peak / (libm::exp(-decay * top) - libm::exp(-rise * top)),
            decay,
            rise,
        }
    }

    /// Zero until time 0, straight up to `peak` at `rise` (s), straight down to zero at `rise + fall`.
    #[must_use]
    pub fn triangle(peak: f64, rise: f64, fall: f64) -> Self {
        Self::Table { t: vec![0.0, rise, rise + fall], v: vec![0.0, peak, 0.0] }
    }

    /// One until `start` (s), straight down to zero over `span` (s).
    #[must_use]
    pub fn fade(start: f64, span: f64) -> Self {
        Self::Table { t: vec![start, start + span], v: vec![1.0, 0.0] }
    }
}

fn table_at(times: &[f64], values: &[f64], t: f64) -> f64 {
    let n = times.len().min(values.len());
    if n == 0 {
        return 0.0;
    }
    // Of two entries at one time the later one holds from there on: a jump.
    let k = times[..n].partition_point(|&x| x <= t);
    if k == 0 {
        values[0]
    } else if k == n {
        values[n - 1]
    } else {
        let (t0, t1) = (times[k - 1], times[k]);
        values[k - 1] + (values[k] - values[k - 1]) * (t - t0) / (t1 - t0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_jump_within_a_step_has_its_impulse_wherever_it_falls() {
        let table = |at: f64| TimeFunction::Table {
            t: vec![0.0, at, at, 1.0],
            v: vec![0.0, 0.0, 4.0, 4.0],
        };
        let pulse = |at: f64| TimeFunction::Pulse { value: 4.0, start: at, end: 1.0 };
        for at in [0.31, 0.35, 0.399, 0.4, 0.401, 0.45] {
            for function in [table(at), pulse(at)] {
                // Kicks at 0, 0.1, ... 0.9 s in steps of 0.1 s: the first one spans half a step.
                let kick = |n: i32| {
                    let half = [if n == 0 { 0.0 } else { 0.05 }, 0.05];
                    (half[0] + half[1]) * function.in_kick(0.1 * f64::from(n), half)
                };
                let impulse: f64 = (0..10).map(kick).sum();
                assert!((impulse - 4.0 * (0.95 - at)).abs() < 1e-14, "{at}");
            }
        }
        // Without a jump in its span a kick has the very value of its instant, and no span asks for nothing else.
        assert_eq!(pulse(0.4).in_kick(0.7, [0.05; 2]), 4.0);
        assert_eq!(pulse(0.4).in_kick(0.4, [0.0; 2]), 4.0);
        // The end of a motion at the instant of a jump feels what was before, the next one what comes.
        assert_eq!(pulse(0.4).in_kick(0.4, [0.05, 0.0]), 0.0);
        assert_eq!(pulse(0.4).in_kick(0.4, [0.0, 0.05]), 4.0);
    }

    #[test]
    fn table_is_linear_inside_and_constant_outside() {
        let f = TimeFunction::Table { t: vec![1.0, 2.0, 4.0], v: vec![0.0, 10.0, -10.0] };
        assert_eq!(f.at(0.0), 0.0);
        assert_eq!(f.at(1.5), 5.0);
        assert_eq!(f.at(3.0), 0.0);
        assert_eq!(f.at(9.0), -10.0);
    }

    /// Catalogue F2: rates 1500 and 6000 1/s peak at 0.308065 ms with 0.472470 of the amplitude.
    #[test]
    fn two_exponentials_peak_where_they_shall() {
        let f = TimeFunction::duvall(0.472_470, 1500.0, 6000.0);
        let TimeFunction::Duvall { amplitude, .. } = f else { panic!("another form") };
        assert!((amplitude - 1.0).abs() < 2e-6, "{amplitude}");
        assert!((f.at(0.308_065e-3) - 0.472_470).abs() < 1e-12);
        assert!(f.at(0.3e-3) < 0.472_470 && f.at(0.316e-3) < 0.472_470);
        assert_eq!((f.at(-1.0), f.at(0.0)), (0.0, 0.0));
        let f = TimeFunction::triangle(2.0, 1.0, 4.0);
        assert_eq!((f.at(0.5), f.at(3.0), f.at(6.0)), (1.0, 1.0, 0.0));
    }

    #[test]
    fn sine_stops_after_its_cycles() {
        let f = TimeFunction::Sine {
            amplitude: 3.0,
            frequency: 2.0,
            phase: 0.0,
            offset: 0.5,
            start: 0.0,
            cycles: Some(5.0),
        };
        assert!((f.at(0.125) - 3.5).abs() < 1e-12);
        assert_eq!(f.at(2.5), 0.5);
    }

    #[test]
    fn a_sine_begins_at_its_start() {
        let f = TimeFunction::Sine {
            amplitude: 3.0,
            frequency: 2.0,
            phase: std::f64::consts::FRAC_PI_2,
            offset: 0.5,
            start: 1.0,
            cycles: Some(5.0),
        };
        assert_eq!((f.at(0.0), f.at(0.999)), (0.5, 0.5));
        assert!((f.at(1.0) - 3.5).abs() < 1e-12);
        assert!((f.at(1.25) + 2.5).abs() < 1e-12);
        // Waves are counted from the start.
        assert!((f.at(3.4) - 0.5).abs() > 0.1);
        assert_eq!(f.at(3.5), 0.5);
    }
}
