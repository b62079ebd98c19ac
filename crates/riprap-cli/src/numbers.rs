//! Numbers as people read them: SI prefixes, thin groups, durations.

/// `value` with an SI prefix and three or four digits: `12.4 kJ/m`, `10 us`, `0 m`.
pub fn si(value: f64, unit: &str) -> String {
    const PREFIXES: [(f64, &str); 9] = [
        (1e12, "T"),
        (1e9, "G"),
        (1e6, "M"),
        (1e3, "k"),
        (1.0, ""),
        (1e-3, "m"),
        (1e-6, "u"),
        (1e-9, "n"),
        (1e-12, "p"),
    ];
    if value == 0.0 {
        return format!("0 {unit}");
    }
    if !value.is_finite() {
        return format!("{value} {unit}");
    }
    let size = value.abs();
    // What would be rounded to 1000 has the next prefix already.
    match PREFIXES.iter().find(|(scale, _)| size >= *scale * 0.9999) {
        Some((scale, prefix)) if size < 1e15 => {
            format!("{} {prefix}{unit}", digits(value / scale))
        }
        _ => format!("{value:.2e} {unit}"),
    }
}

/// Three significant digits for 1 to 1000, without trailing zeros.
fn digits(value: f64) -> String {
    // The bounds of what is rounded: 9.996 is written 10.
    let decimals = match value.abs() {
        v if v < 9.995 => 2,
        v if v < 99.95 => 1,
        _ => 0,
    };
    decimal(value, decimals)
}

/// At most so many decimals, without trailing zeros.
fn decimal(value: f64, decimals: usize) -> String {
    let text = format!("{value:.decimals$}");
    let text =
        if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { &text };
    if text == "-0" { "0" } else { text }.to_owned()
}

/// A coordinate, to a hundred-thousandth of the size of what it belongs to: `-1.10594`, `20`.
pub fn coordinate(value: f64, size: f64) -> String {
    let mut decimals = 0;
    let mut last = 1.0;
    // A power of ten is off by round-off.
    let enough = 1e-5 * size * (1.0 + 1e-9);
    while last > enough && decimals < 12 {
        last *= 0.1;
        decimals += 1;
    }
    decimal(value, decimals)
}

/// A ratio: `3.1e-4`, `0.25`, `0`.
pub fn ratio(value: f64) -> String {
    if value == 0.0 || (1e-2..1e4).contains(&value.abs()) {
        digits(value)
    } else {
        format!("{value:.1e}")
    }
}

/// A whole number in groups of three: `41 200`.
pub fn grouped(number: u64) -> String {
    let plain = number.to_string();
    let mut text = String::new();
    for (i, digit) in plain.chars().enumerate() {
        if i > 0 && (plain.len() - i).is_multiple_of(3) {
            text.push(' ');
        }
        text.push(digit);
    }
    text
}

/// A number of things in words: `1 pair`, `12 345 pairs`.
pub fn counted(number: usize, one: &str) -> String {
    let many = if number == 1 { "" } else { "s" };
    format!("{} {one}{many}", grouped(number as u64))
}

/// A wall time: `under 0.1 s`, `0.4 s`, `42 s`, `6 min 40 s`, `3 h 05 min`.
pub fn duration(seconds: f64) -> String {
    if !seconds.is_finite() {
        return "?".to_owned();
    }
    let whole = seconds.max(0.0).round() as u64;
    match whole {
        0 if seconds < 0.05 => "under 0.1 s".to_owned(),
        0..10 => format!("{seconds:.1} s"),
        10..60 => format!("{whole} s"),
        60..3600 => format!("{} min {:02} s", whole / 60, whole % 60),
        _ => format!("{} h {:02} min", whole / 3600, whole / 60 % 60),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn si_prefixes() {
        for (value, text) in [
            (0.0, "0 J/m"),
            (12_400.0, "12.4 kJ/m"),
            (1e-5, "10 uJ/m"),
            (0.412, "412 mJ/m"),
            (1.0, "1 J/m"),
            (-2.5e6, "-2.5 MJ/m"),
            (999.0, "999 J/m"),
            (3e-15, "3.00e-15 J/m"),
            (f64::NAN, "NaN J/m"),
        ] {
            assert_eq!(si(value, "J/m"), text);
        }
    }

    #[test]
    fn coordinates_have_the_digits_of_their_model() {
        for (value, size, text) in [
            (-1.105_940_262_464_515, 6.8, "-1.10594"),
            (20.0, 20.0, "20"),
            (0.1 + 0.2, 1.0, "0.3"),
            (-1e-17, 1.0, "0"),
            (4_500_000.257_8, 1000.0, "4500000.26"),
            (1.25e-5, 2e-5, "0.0000125"),
        ] {
            assert_eq!(coordinate(value, size), text);
        }
    }

    #[test]
    fn counts_ratios_and_durations() {
        assert_eq!(grouped(7), "7");
        assert_eq!(grouped(41_200), "41 200");
        assert_eq!(grouped(1_000_000), "1 000 000");
        assert_eq!(ratio(3.14e-4), "3.1e-4");
        assert_eq!(ratio(0.25), "0.25");
        assert_eq!(ratio(0.0), "0");
        assert_eq!(duration(0.04), "under 0.1 s");
        assert_eq!(duration(0.44), "0.4 s");
        assert_eq!(duration(42.2), "42 s");
        assert_eq!(duration(400.0), "6 min 40 s");
        assert_eq!(duration(11_100.0), "3 h 05 min");
        assert_eq!(duration(f64::INFINITY), "?");
    }
}
