//! Amplitude spectrum of a history.

use super::{FitError, mean, usable};
use rustfft::FftPlanner;
use rustfft::num_complex::Complex;

/// More even samples than this are not made; the step grows instead.
const MOST: usize = 1 << 20;
/// Share of the record that the window tapers at each end.
const TAPER: f64 = 0.05;

/// Fourier amplitudes of a history.
#[derive(Debug, Clone, PartialEq)]
pub struct Spectrum {
    /// Frequencies above zero up to half the sampling rate, Hz.
    pub frequency: Vec<f64>,
    /// `|sum v(t) exp(-2 pi i f t) dt|`, unit of the values times s.
    pub amplitude: Vec<f64>,
    /// Frequency of the largest amplitude, between the bins by a parabola, Hz.
    pub dominant: f64,
    /// Distance of frequencies that the record tells apart: 1/duration, Hz.
    pub resolution: f64,
    /// Even step to which the samples were interpolated, s.
    pub step: f64,
}

/// Amplitude spectrum of samples over time.
///
/// The samples are interpolated linearly to even steps (the median of theirs), their mean is taken off, a Tukey window
/// tapers 5 % of the record at each end by half a cosine, and zeros are added up to a power of two at least twice
/// their number. The amplitude is the Fourier integral, so that a longer quiet record of the same pulse has the same
/// spectrum. The dominant frequency is looked for from 1/duration on.
///
/// # Errors
/// Fewer than 16 samples, times that do not ascend, values that are all the same.
pub fn amplitude_spectrum(time: &[f64], values: &[f64]) -> Result<Spectrum, FitError> {
    let (t, y) = usable(time, values, |_, _| true);
    let (found, needed) = (t.len(), 16);
    if found < needed {
        return Err(FitError::TooFew { found, needed });
    }
    let mut steps: Vec<f64> = t.windows(2).map(|w| w[1] - w[0]).collect();
    steps.sort_by(f64::total_cmp);
    if steps[0] <= 0.0 {
        return Err(FitError::NotAscending);
    }
    if y.iter().all(|v| *v == y[0]) {
        return Err(FitError::Constant { what: "values" });
    }
    let duration = t[found - 1] - t[0];
    // The usual step, so that a few short or long ones do not decide over all.
    let count = (duration / steps[steps.len() / 2]).round() + 1.0;
    let count = (count as usize).clamp(needed, MOST);
    let step = duration / (count - 1) as f64;
    let mut even = interpolated(&t, &y, count, step);
    let middle = mean(&even);
    for (i, v) in even.iter_mut().enumerate() {
        *v = (*v - middle) * window(i as f64 / (count - 1) as f64);
    }
    let amplitude = transformed(&even, step);
    let width = 1.0 / (2 * amplitude.len()) as f64 / step;
    let frequency: Vec<f64> = (1..=amplitude.len()).map(|k| k as f64 * width).collect();
    let dominant = peak(&frequency, &amplitude, 1.0 / duration);
    Ok(Spectrum { frequency, amplitude, dominant, resolution: 1.0 / duration, step })
}

/// Amplitudes of the frequencies above zero up to half the sampling rate.
fn transformed(even: &[f64], step: f64) -> Vec<f64> {
    // As many zeros again: the peak is then seen between the frequencies of the record alone.
    let length = (2 * even.len()).next_power_of_two();
    let mut wave: Vec<Complex<f64>> = even.iter().map(|v| Complex::new(*v, 0.0)).collect();
    wave.resize(length, Complex::new(0.0, 0.0));
    FftPlanner::new().plan_fft_forward(length).process(&mut wave);
    wave[1..=length / 2].iter().map(|c| step * libm::hypot(c.re, c.im)).collect()
}

fn interpolated(t: &[f64], y: &[f64], count: usize, step: f64) -> Vec<f64> {
    let mut at = 0;
    (0..count)
        .map(|i| {
            let now = t[0] + i as f64 * step;
            while at + 2 < t.len() && t[at + 1] < now {
                at += 1;
            }
            let share = ((now - t[at]) / (t[at + 1] - t[at])).clamp(0.0, 1.0);
            y[at] + share * (y[at + 1] - y[at])
        })
        .collect()
}

/// Tukey's window at a share 0..1 of the record.
fn window(share: f64) -> f64 {
    let edge = share.min(1.0 - share) / TAPER;
    if edge >= 1.0 { 1.0 } else { 0.5 - 0.5 * libm::cos(std::f64::consts::PI * edge) }
}

fn peak(frequency: &[f64], amplitude: &[f64], lowest: f64) -> f64 {
    let first = frequency.partition_point(|f| *f < lowest);
    let top = (first..amplitude.len()).fold(first.min(amplitude.len() - 1), |best, k| {
        if amplitude[k] > amplitude[best] { k } else { best }
    });
    if top == 0 || top + 1 >= amplitude.len() {
        return frequency[top];
    }
    let (l, m, r) = (amplitude[top - 1], amplitude[top], amplitude[top + 1]);
    // The top of the parabola through the largest and its neighbours.
    let bend = l - 2.0 * m + r;
    let shift = if bend < 0.0 { 0.5 * (l - r) / bend } else { 0.0 };
    frequency[top] + shift.clamp(-0.5, 0.5) * (frequency[1] - frequency[0])
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    #[test]
    fn a_tone_has_its_frequency_and_size() {
        // A bin of the padded transform, so that its height is that of the line.
        let f = 153.0 / 4.096;
        let t: Vec<f64> = (0..2001).map(|i| f64::from(i) * 1e-3).collect();
        let y: Vec<f64> = t.iter().map(|t| 0.2 + 3.0 * (2.0 * PI * f * t).sin()).collect();
        let s = amplitude_spectrum(&t, &y).unwrap();
        assert!((s.dominant - f).abs() < 0.02, "{}", s.dominant);
        assert!((s.step - 1e-3).abs() < 1e-15 && (s.resolution - 0.5).abs() < 1e-12);
        let top = s.amplitude.iter().copied().fold(0.0, f64::max);
        // Half the amplitude times the area of the window, 2 s less half of what is tapered.
        assert!((top / (1.5 * 1.9) - 1.0).abs() < 0.01, "{top}");
        assert!((s.frequency.last().unwrap() - 500.0).abs() < 1e-9);
    }

    #[test]
    fn a_pulse_has_the_spectrum_of_its_formula() {
        // Derivative of a Gaussian: |V(f)| = 2 pi f s sqrt(2 pi) exp(-(2 pi f s)^2 / 2) s, largest at f = 1/(2 pi s).
        let s = 2e-3;
        let t: Vec<f64> = (0..4001).map(|i| f64::from(i) * 1e-4).collect();
        let y: Vec<f64> = t
            .iter()
            .map(|t| {
                let x = (t - 0.15) / s;
                -x * (-0.5 * x * x).exp()
            })
            .collect();
        let got = amplitude_spectrum(&t, &y).unwrap();
        assert!((got.dominant * 2.0 * PI * s - 1.0).abs() < 1e-3);
        for (f, a) in got.frequency.iter().zip(&got.amplitude) {
            let w = 2.0 * PI * f * s;
            let wanted = w * (2.0 * PI).sqrt() * (-0.5 * w * w).exp() * s;
            assert!((a - wanted).abs() < 1e-6 * s, "{f} {a} {wanted}");
        }
    }

    #[test]
    fn uneven_steps_and_gaps() {
        let t: Vec<f64> =
            (0..3000).map(|i| f64::from(i) * 1e-3 + 3e-4 * f64::from(i).sin()).collect();
        let mut y: Vec<f64> = t.iter().map(|t| (2.0 * PI * 12.0 * t).cos()).collect();
        y[100] = f64::NAN;
        let s = amplitude_spectrum(&t, &y).unwrap();
        assert!((s.dominant - 12.0).abs() < 0.02, "{}", s.dominant);
        assert!(amplitude_spectrum(&t[..10], &y[..10]).is_err());
        assert!(amplitude_spectrum(&t, &vec![1.0; 3000]).is_err());
        let back: Vec<f64> = t.iter().rev().copied().collect();
        assert_eq!(amplitude_spectrum(&back, &y), Err(FitError::NotAscending));
    }
}
