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
    /// `offset + amplitude sin(2 pi f t + phase)`; after `cycles` periods it is `offset`.
    Sine {
        /// Amplitude.
        amplitude: f64,
        /// Frequency, Hz.
        frequency: f64,
        /// Phase, rad.
        phase: f64,
        /// Mean value.
        offset: f64,
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
    /// A formula in `t`.
    Formula(Formula),
}

impl TimeFunction {
    /// Value at time `t` (s).
    #[must_use]
    pub fn at(&self, t: f64) -> f64 {
        match self {
            Self::Constant(value) => *value,
            Self::Ramp {
                from,
                to,
                start,
                end,
            } => {
                if t <= *start {
                    *from
                } else if t >= *end {
                    *to
                } else {
                    from + (to - from) * (t - start) / (end - start)
                }
            }
            Self::Sine {
                amplitude,
                frequency,
                phase,
                offset,
                cycles,
            } => {
                if cycles.is_some_and(|n| t * frequency >= n) {
                    return *offset;
                }
                let angle = 2.0 * std::f64::consts::PI * frequency * t + phase;
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
        }
    }

    /// Whether it is zero at all times as far as its form tells.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        matches!(self, Self::Constant(value) if *value == 0.0)
    }
}

fn table_at(times: &[f64], values: &[f64], t: f64) -> f64 {
    let n = times.len().min(values.len());
    if n == 0 {
        return 0.0;
    }
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
    fn table_is_linear_inside_and_constant_outside() {
        let f = TimeFunction::Table {
            t: vec![1.0, 2.0, 4.0],
            v: vec![0.0, 10.0, -10.0],
        };
        assert_eq!(f.at(0.0), 0.0);
        assert_eq!(f.at(1.5), 5.0);
        assert_eq!(f.at(3.0), 0.0);
        assert_eq!(f.at(9.0), -10.0);
    }

    #[test]
    fn sine_stops_after_its_cycles() {
        let f = TimeFunction::Sine {
            amplitude: 3.0,
            frequency: 2.0,
            phase: 0.0,
            offset: 0.5,
            cycles: Some(5.0),
        };
        assert!((f.at(0.125) - 3.5).abs() < 1e-12);
        assert_eq!(f.at(2.5), 0.5);
    }
}
