//! Axis arithmetic: ranges, round ticks, labels.

/// Linear or decadic axis over a range.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Scale {
    pub(super) low: f64,
    pub(super) high: f64,
    pub(super) log: bool,
}

impl Scale {
    /// Covers all finite values, ends at round numbers. Nothing to cover gives 0..1.
    pub(super) fn covering(values: impl IntoIterator<Item = f64>) -> Self {
        let (low, high) = range(values).unwrap_or((0.0, 1.0));
        let (low, high) = opened(low, high);
        let step = round_step(high - low, 6);
        Scale { low: (low / step).floor() * step, high: (high / step).ceil() * step, log: false }
    }

    /// Covers exactly the range of the values, opened if it is a point.
    pub(super) fn exact(values: impl IntoIterator<Item = f64>) -> Self {
        let (low, high) = range(values).unwrap_or((0.0, 1.0));
        let (low, high) = opened(low, high);
        Scale { low, high, log: false }
    }

    /// Covers the positive values by whole decades, 12 at most (the upper ones).
    pub(super) fn decades(values: impl IntoIterator<Item = f64>) -> Self {
        let positive = values.into_iter().filter(|v| *v > 0.0);
        let (low, high) = range(positive).unwrap_or((0.1, 1.0));
        let high = high.log10().ceil();
        let low = low.log10().floor().min(high - 1.0).max(high - 12.0);
        Scale { low: 10f64.powf(low), high: 10f64.powf(high), log: true }
    }

    /// Covers the positive values on a logarithmic axis whose ends are 1, 2 or 5 times a power of ten.
    pub(super) fn log_covering(values: impl IntoIterator<Item = f64>) -> Self {
        let positive = values.into_iter().filter(|v| *v > 0.0);
        let (low, high) = range(positive).unwrap_or((0.1, 1.0));
        let last = |v: f64, fits: &dyn Fn(f64) -> bool| {
            let power = v.log10().floor() as i32;
            round_numbers(power - 1, power + 1).into_iter().filter(|n| fits(*n)).collect::<Vec<_>>()
        };
        let below = last(low, &|n| n <= low * 1.000_001);
        let above = last(high, &|n| n >= high * 0.999_999);
        let low = below.last().copied().unwrap_or(low);
        let high = above.first().copied().unwrap_or(high);
        Scale { low, high: if high > low { high } else { 10.0 * low }, log: true }
    }

    /// Places of fine lines between the ticks of a logarithmic axis of few decades: 2, 3, ... 9 times powers of ten.
    pub(super) fn fine(&self) -> Vec<f64> {
        if !self.log || self.high > 1e5 * self.low {
            return Vec::new();
        }
        let (first, last) = (self.low.log10().floor() as i32, self.high.log10().ceil() as i32);
        (first..last)
            .flat_map(|n| (2..10).map(move |k| f64::from(k) * 10f64.powi(n)))
            .filter(|v| (self.low..=self.high).contains(v))
            .collect()
    }

    /// Where a value stands between the ends, 0..1.
    pub(super) fn share(&self, v: f64) -> f64 {
        if self.log {
            // What a logarithmic axis cannot show lies on its lower end.
            (v.max(self.low).log10() - self.low.log10()) / (self.high.log10() - self.low.log10())
        } else {
            (v - self.low) / (self.high - self.low)
        }
    }

    /// What is taken off the labels before [`Scale::power`]: a round number below a short range far from zero.
    pub(super) fn offset(&self) -> f64 {
        let (size, width) = (self.low.abs().max(self.high.abs()), self.high - self.low);
        if self.log || size < 1000.0 * width {
            return 0.0;
        }
        let round = 10f64.powf(width.log10().ceil());
        (self.low / round).floor() * round
    }

    /// Power of ten (a multiple of 3) to take out of the labels; 0 for ordinary sizes and log axes.
    pub(super) fn power(&self) -> i32 {
        let offset = self.offset();
        let size = (self.low - offset).abs().max((self.high - offset).abs());
        if self.log || size == 0.0 || (1e-2..1e4).contains(&size) {
            return 0;
        }
        (size.log10() / 3.0).floor() as i32 * 3
    }

    /// About `count` ticks: values and labels, the labels less [`Scale::offset`], divided by 10^[`Scale::power`].
    pub(super) fn ticks(&self, count: usize) -> Vec<(f64, String)> {
        if self.log {
            let (low, high) = (
                (self.low.log10() - 1e-9).ceil() as i32,
                (self.high.log10() + 1e-9).floor() as i32,
            );
            if self.high < 500.0 * self.low {
                return round_numbers(low - 1, high)
                    .into_iter()
                    .filter(|v| (0.999_999 * self.low..=1.000_001 * self.high).contains(v))
                    .map(|v| (v, plain(v)))
                    .collect();
            }
            let every = ((high - low).max(0) as usize).div_ceil(count.max(1)).max(1);
            return (low..=high)
                .step_by(every)
                .map(|n| (10f64.powi(n), format!("10{}", superscript(n))))
                .collect();
        }
        let step = round_step(self.high - self.low, count);
        let (unit, offset) = (10f64.powi(self.power()), self.offset());
        // The logarithm of a power of ten is off by a rounding, which would add a decimal.
        let decimals = (-(step / unit).log10() - 1e-9).ceil().clamp(0.0, 9.0) as usize;
        let (first, last) =
            ((self.low / step - 1e-6).ceil() as i64, (self.high / step + 1e-6).floor() as i64);
        // A range beyond the precision of its own ends has no ticks worth counting.
        (first..=last.min(first.saturating_add(50)))
            .map(|n| {
                let v = n as f64 * step;
                let text = format!("{:.decimals$}", (v - offset) / unit);
                (v, text.replacen('-', "\u{2212}", 1))
            })
            .collect()
    }
}

fn range(values: impl IntoIterator<Item = f64>) -> Option<(f64, f64)> {
    values.into_iter().filter(|v| v.is_finite()).fold(None, |r: Option<(f64, f64)>, v| {
        Some(r.map_or((v, v), |(low, high)| (low.min(v), high.max(v))))
    })
}

/// A point or a range lost in rounding gets a width.
fn opened(low: f64, high: f64) -> (f64, f64) {
    let size = low.abs().max(high.abs());
    if high - low > 1e-12 * size {
        return (low, high);
    }
    if size == 0.0 { (-1.0, 1.0) } else { (low - 0.05 * size, high + 0.05 * size) }
}

/// 1, 2 or 5 times a power of ten, about `width / count`.
fn round_step(width: f64, count: usize) -> f64 {
    let rough = (width / count.max(1) as f64).max(f64::MIN_POSITIVE);
    let power = 10f64.powf(rough.log10().floor());
    let factor = [1.0, 2.0, 5.0].into_iter().find(|f| f * power >= rough * 0.999).unwrap_or(10.0);
    factor * power
}

/// 1, 2 and 5 times the powers of ten from `first` to `last`.
fn round_numbers(first: i32, last: i32) -> Vec<f64> {
    (first..=last).flat_map(|n| [1.0, 2.0, 5.0].map(|f| f * 10f64.powi(n))).collect()
}

/// A round number without noise in its last digits: `0.02`, `500`, `2e-7`.
fn plain(v: f64) -> String {
    let power = (v.log10() + 1e-9).floor() as i32;
    if (-4..5).contains(&power) {
        format!("{v:.*}", (-power).max(0) as usize)
    } else {
        format!("{:.0}e{power}", v / 10f64.powi(power))
    }
}

/// An integer in raised digits.
pub(super) fn superscript(n: i32) -> String {
    n.to_string()
        .chars()
        .map(|c| match c {
            '-' => '\u{207b}',
            '1' => '\u{b9}',
            '2' => '\u{b2}',
            '3' => '\u{b3}',
            c => c.to_digit(10).and_then(|d| char::from_u32(0x2070 + d)).unwrap_or(c),
        })
        .collect()
}

/// Title of an axis: name, what was taken off its labels, unit: `x − 456780 [m]`, `energy [10³ J/m]`.
pub(super) fn label(name: &str, unit: &str, scale: &Scale) -> String {
    let offset = scale.offset();
    let name = if offset == 0.0 {
        name.to_owned()
    } else if offset > 0.0 {
        format!("{name} \u{2212} {offset}")
    } else {
        format!("{name} + {}", -offset)
    };
    let unit = if unit == "-" { "" } else { unit };
    match (scale.power(), unit) {
        (0, "") => name,
        (0, u) => format!("{name} [{u}]"),
        (p, "") => format!("{name} [10{}]", superscript(p)),
        (p, u) => format!("{name} [10{} {u}]", superscript(p)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn texts(s: Scale, n: usize) -> Vec<String> {
        s.ticks(n).into_iter().map(|t| t.1).collect()
    }

    #[test]
    fn round_ticks() {
        let s = Scale::covering([0.0, 5.31]);
        assert_eq!(texts(s, 6), ["0", "1", "2", "3", "4", "5", "6"]);
        let s = Scale::covering([-0.0123, 0.031]);
        assert_eq!(
            texts(s, 6),
            ["\u{2212}0.02", "\u{2212}0.01", "0.00", "0.01", "0.02", "0.03", "0.04"]
        );
    }

    #[test]
    fn powers_are_taken_out() {
        let s = Scale::covering([0.0, 15.2e6]);
        assert_eq!(s.power(), 6);
        assert_eq!(texts(s, 4).last().unwrap(), "20");
        assert_eq!(label("energy", "J/m", &s), "energy [10⁶ J/m]");
        assert_eq!(Scale::covering([0.0, 3e-7]).power(), -9);
    }

    #[test]
    fn far_from_zero() {
        let s = Scale::covering([5_123_456.0, 5_123_460.0]);
        assert_eq!(label("y", "m", &s), "y \u{2212} 5123450 [m]");
        assert_eq!(texts(s, 4), ["6", "7", "8", "9", "10"]);
    }

    #[test]
    fn short_logarithmic_ranges() {
        let s = Scale::log_covering([0.7, 31.0, -2.0]);
        assert_eq!((s.low, s.high), (0.5, 50.0));
        assert_eq!(texts(s, 6), ["0.5", "1", "2", "5", "10", "20", "50"]);
        assert_eq!(s.fine().len(), 4 + 8 + 4 + 1);
        let s = Scale::log_covering([0.02, 700.0]);
        assert_eq!(texts(s, 6), ["10⁻¹", "10⁰", "10¹", "10²", "10³"]);
        let s = Scale::log_covering([3e-7, 3e-7]);
        assert_eq!(texts(s, 6), ["2e-7", "5e-7"]);
        assert!(Scale::log_covering([]).high > Scale::log_covering([]).low);
    }

    #[test]
    fn odd_ranges() {
        assert!(Scale::covering([2.0, 2.0]).share(2.0).is_finite());
        assert_eq!(Scale::covering([f64::NAN]), Scale { low: 0.0, high: 1.0, log: false });
        for s in [
            Scale::covering([0.0, 0.0]),
            Scale::exact([1e300, 1e300]),
            Scale::exact([5e5, 5e5 + 1e-9]),
        ] {
            assert!(s.high > s.low);
            assert!(s.ticks(5).len() < 60);
        }
        let s = Scale::decades([1e-7, 0.3, 0.0]);
        assert_eq!((s.low, s.high), (1e-7, 1.0));
        assert_eq!(texts(s, 8)[0], "10⁻⁷");
    }
}
