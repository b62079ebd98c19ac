//! Numbers as they are shown: in the unit of whoever wrote the scene, or in one that suits their size, with as many
//! digits as mean something. Files hold SI.

use serde::{Deserialize, Serialize};

/// Digits where nothing asks for more.
const DIGITS: usize = 5;
/// Most digits.
const MOST: usize = 10;

/// A unit for showing.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Shown {
    /// The unit; empty for plain numbers.
    pub unit: String,
    /// What one of it is in SI.
    pub one: f64,
}

impl Shown {
    /// The SI unit itself (`-` or empty for none).
    #[must_use]
    pub fn si(unit: &str) -> Self {
        Self { unit: if unit == "-" { "" } else { unit }.to_owned(), one: 1.0 }
    }

    /// A unit in which a value of that size (SI) reads well: degrees for angles; kPa to GPa, kN to GN, mm, ms and the like.
    #[must_use]
    pub fn suited(unit: &str, value: f64) -> Self {
        if unit == "rad" || unit == "rad/s" {
            return Self { unit: unit.replace("rad", "deg"), one: std::f64::consts::PI / 180.0 };
        }
        let size = value.abs();
        let large = [(1e9, "G"), (1e6, "M"), (1e3, "k")];
        let small = [(1e-3, "m"), (1e-6, "u")];
        let first = |prefixes: &[(f64, &'static str)]| {
            prefixes.iter().copied().find(|(one, _)| size >= *one)
        };
        // `m2`, `kg` and `1/s` take no prefix; metres and seconds none of the large ones.
        let prefix = match unit.split(['/', ' ']).next() {
            Some("Pa" | "N" | "J" | "W") if size >= 1e3 => first(&large),
            Some("Pa" | "N" | "J" | "W" | "m" | "s") if size > 0.0 && size < 0.1 => first(&small),
            Some(_) | None => None,
        };
        match prefix {
            Some((one, prefix)) => Self { unit: format!("{prefix}{unit}"), one },
            None => Self::si(unit),
        }
    }

    /// `40.02 deg`: a value (SI) with that many digits and its unit.
    #[must_use]
    pub fn text(&self, value: f64, digits: usize) -> String {
        let number = self.number(value, digits);
        if self.unit.is_empty() { number } else { format!("{number} {}", self.unit) }
    }

    /// As [`Shown::text`], without the unit.
    #[must_use]
    pub fn number(&self, value: f64, digits: usize) -> String {
        number(value / self.one, digits)
    }
}

/// Digits in which two numbers show that they agree within `tolerance`, a share of their size.
#[must_use]
pub fn digits_for(tolerance: f64) -> usize {
    let (mut digits, mut share) = (1, 1.0);
    while share > 1.5 * tolerance && digits < MOST {
        share *= 0.1;
        digits += 1;
    }
    digits.max(DIGITS)
}

/// A number with that many significant digits, without zeros at the end.
#[must_use]
pub fn number(value: f64, digits: usize) -> String {
    if value == 0.0 || !value.is_finite() {
        return format!("{value}");
    }
    let digits = digits.max(1);
    let scientific = format!("{value:.*e}", digits - 1);
    let (mantissa, power) = scientific.split_once('e').unwrap_or((&scientific, "0"));
    let exponent: i32 = power.parse().unwrap_or(0);
    let bare = |text: &str| {
        if text.contains('.') {
            text.trim_end_matches('0').trim_end_matches('.').to_owned()
        } else {
            text.to_owned()
        }
    };
    if !(-4..7).contains(&exponent) {
        return format!("{}e{exponent}", bare(mantissa));
    }
    let decimals = usize::try_from(digits as i32 - 1 - exponent).unwrap_or(0);
    // Rounded first, so that digits before the point mean something too.
    let rounded: f64 = scientific.parse().unwrap_or(value);
    bare(&format!("{rounded:.decimals$}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_suit_their_values() {
        for (unit, value, text) in [
            ("rad", 0.034_906_585_039_886_59, "2 deg"),
            ("rad/s", 1.0, "57.296 deg/s"),
            ("Pa", 1.031_735e9, "1.0317 GPa"),
            ("Pa/m", 2e9, "2 GPa/m"),
            ("N", -2566.0, "-2.566 kN"),
            ("N m", 12_000.0, "12 kN m"),
            ("J/m", -0.592, "-0.592 J/m"),
            ("J", 0.0042, "4.2 mJ"),
            ("m", 12_345.678, "12346 m"),
            ("m", 0.000_17, "170 um"),
            ("m2", 0.0021, "0.0021 m2"),
            ("kg", 2600.0, "2600 kg"),
            ("m/s", 0.05, "50 mm/s"),
            ("-", 0.25, "0.25"),
            ("-", 1.5e-7, "1.5e-7"),
            ("s", 0.0, "0 s"),
            ("N", f64::NAN, "NaN N"),
        ] {
            assert_eq!(Shown::suited(unit, value).text(value, 5), text, "{unit}");
        }
    }

    #[test]
    fn digits_show_what_the_tolerance_asks() {
        for (tolerance, digits) in [(0.1, 5), (1e-3, 5), (1e-6, 7), (0.0, 10), (f64::NAN, 5)] {
            assert_eq!(digits_for(tolerance), digits, "{tolerance}");
        }
        assert_eq!(number(123_456.7, 3), "123000");
        assert_eq!(number(9.9999, 3), "10");
        assert_eq!(number(1e7, 3), "1e7");
    }
}
