//! Numbers with units: text -> SI value and dimension.
//!
//! A text is a number and a unit expression: factors joined by a space, `*` or `/`, each with an
//! optional power (`m2`, `m^2`, `m²`, `s^-1`). A `/` divides by the one factor that follows it.
//! Angles have a dimension of their own, so that an angle is never mistaken for a number.

mod number;

use number::split_number;

/// Exponents of kilogram, metre, second and radian.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Dim(pub [i8; 4]);

impl Dim {
    /// Pure number.
    pub const NONE: Dim = Dim([0, 0, 0, 0]);
    /// kg
    pub const MASS: Dim = Dim([1, 0, 0, 0]);
    /// m
    pub const LENGTH: Dim = Dim([0, 1, 0, 0]);
    /// m2
    pub const AREA: Dim = Dim([0, 2, 0, 0]);
    /// m3
    pub const VOLUME: Dim = Dim([0, 3, 0, 0]);
    /// rad
    pub const ANGLE: Dim = Dim([0, 0, 0, 1]);
    /// kg/m3
    pub const DENSITY: Dim = Dim([1, -3, 0, 0]);
    /// Pa
    pub const PRESSURE: Dim = Dim([1, -1, -2, 0]);
    /// Pa s
    pub const VISCOSITY: Dim = Dim([1, -1, -1, 0]);
    /// Pa/m
    pub const STIFFNESS_PER_AREA: Dim = Dim([1, -2, -2, 0]);
    /// s
    pub const TIME: Dim = Dim([0, 0, 1, 0]);
    /// m/s
    pub const VELOCITY: Dim = Dim([0, 1, -1, 0]);
    /// m/s2
    pub const ACCELERATION: Dim = Dim([0, 1, -2, 0]);
    /// rad/s
    pub const SPIN: Dim = Dim([0, 0, -1, 1]);
    /// rad/s2
    pub const SPIN_ACCELERATION: Dim = Dim([0, 0, -2, 1]);
    /// N, also J/m and N m/m
    pub const FORCE: Dim = Dim([1, 1, -2, 0]);
    /// N/m
    pub const FORCE_PER_LENGTH: Dim = Dim([1, 0, -2, 0]);
    /// J, also N m
    pub const ENERGY: Dim = Dim([1, 2, -2, 0]);
    /// J/kg
    pub const SPECIFIC_ENERGY: Dim = Dim([0, 2, -2, 0]);
    /// W
    pub const POWER: Dim = Dim([1, 2, -3, 0]);
    /// 1/s
    pub const RATE: Dim = Dim([0, 0, -1, 0]);
    /// kg m/s
    pub const MOMENTUM: Dim = Dim([1, 1, -1, 0]);

    /// "a pressure", or the base units of a dimension without a name.
    pub fn describe(self) -> String {
        let named = [
            (Dim::NONE, "a number without unit"),
            (Dim::MASS, "a mass"),
            (Dim::LENGTH, "a length"),
            (Dim::AREA, "an area"),
            (Dim::VOLUME, "a volume"),
            (Dim::ANGLE, "an angle"),
            (Dim::DENSITY, "a density (mass per volume)"),
            (Dim::PRESSURE, "a pressure (force per area)"),
            (Dim::STIFFNESS_PER_AREA, "a pressure per length (or unit weight)"),
            (Dim::VISCOSITY, "a viscosity (pressure times time)"),
            (Dim::TIME, "a time"),
            (Dim::VELOCITY, "a velocity"),
            (Dim::ACCELERATION, "an acceleration"),
            (Dim::SPIN, "a spin (angle per time)"),
            (Dim::SPIN_ACCELERATION, "an angular acceleration"),
            (Dim::FORCE, "a force"),
            (Dim::FORCE_PER_LENGTH, "a force per length"),
            (Dim::ENERGY, "an energy or moment"),
            (Dim::SPECIFIC_ENERGY, "an energy per mass"),
            (Dim::POWER, "a power"),
            (Dim::RATE, "a rate (1 per time)"),
            (Dim::MOMENTUM, "a momentum"),
        ];
        match named.iter().find(|(dim, _)| *dim == self) {
            Some((_, name)) => (*name).to_owned(),
            None => format!("a quantity in {self}"),
        }
    }

    /// SI unit, for numbers that are shown; nothing for a pure number.
    pub fn unit(self) -> String {
        let named = [
            (Dim::NONE, ""),
            (Dim::DENSITY, "kg/m3"),
            (Dim::PRESSURE, "Pa"),
            (Dim::VISCOSITY, "Pa s"),
            (Dim::STIFFNESS_PER_AREA, "Pa/m"),
            (Dim::VELOCITY, "m/s"),
            (Dim::ACCELERATION, "m/s2"),
            (Dim::SPIN, "rad/s"),
            (Dim::SPIN_ACCELERATION, "rad/s2"),
            (Dim::FORCE, "N"),
            (Dim::FORCE_PER_LENGTH, "N/m"),
            (Dim::ENERGY, "J"),
            (Dim::SPECIFIC_ENERGY, "J/kg"),
            (Dim::POWER, "W"),
            (Dim::RATE, "1/s"),
        ];
        match named.iter().find(|(dim, _)| *dim == self) {
            Some((_, unit)) => (*unit).to_owned(),
            None => self.to_string(),
        }
    }

    fn times(self, other: Dim, power: i32) -> Option<Dim> {
        let mut exponents = self.0;
        for (exponent, factor) in exponents.iter_mut().zip(other.0) {
            let sum = i32::from(*exponent) + i32::from(factor) * power;
            *exponent = i8::try_from(sum).ok()?;
        }
        Some(Dim(exponents))
    }
}

impl std::fmt::Display for Dim {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let mut first = true;
        for (exponent, unit) in self.0.iter().zip(["kg", "m", "s", "rad"]) {
            if *exponent != 0 {
                if !first {
                    f.write_str(" ")?;
                }
                f.write_str(unit)?;
                if *exponent != 1 {
                    write!(f, "^{exponent}")?;
                }
                first = false;
            }
        }
        if first { f.write_str("1") } else { Ok(()) }
    }
}

/// A quantity to copy where it is not known which one is expected.
pub const ANY_EXAMPLE: &str = "\"10 MPa\"";

/// Why a text is no quantity.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct UnitError {
    /// What is wrong.
    pub message: String,
    /// What to write instead.
    pub help: Option<String>,
}

impl UnitError {
    fn new(message: impl Into<String>, help: impl Into<String>) -> Self {
        UnitError { message: message.into(), help: Some(help.into()) }
    }
}

impl std::fmt::Display for UnitError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&self.message)
    }
}

impl std::error::Error for UnitError {}

/// A named unit.
#[derive(Debug, Clone, Copy)]
pub struct Unit {
    /// As written.
    pub name: &'static str,
    /// SI value of 1.
    pub factor: f64,
    /// Dimension.
    pub dim: Dim,
    /// Prefixes that may stand before it.
    prefixes: &'static str,
}

const DEG: f64 = std::f64::consts::PI / 180.0;
const TURN: f64 = std::f64::consts::TAU;

const fn unit(name: &'static str, factor: f64, dim: Dim, prefixes: &'static str) -> Unit {
    Unit { name, factor, dim, prefixes }
}

/// Units without prefixes; a prefix is one of `n u µ m c d k M G T` where the unit allows it.
pub const UNITS: &[Unit] = &[
    unit("m", 1.0, Dim::LENGTH, "nuµmcdk"),
    unit("in", 0.0254, Dim::LENGTH, ""),
    unit("ft", 0.3048, Dim::LENGTH, ""),
    unit("g", 1e-3, Dim::MASS, "uµmkM"),
    unit("t", 1e3, Dim::MASS, "k"),
    unit("lb", 0.453_592_37, Dim::MASS, ""),
    unit("s", 1.0, Dim::TIME, "nuµm"),
    unit("min", 60.0, Dim::TIME, ""),
    unit("h", 3600.0, Dim::TIME, ""),
    unit("d", 86_400.0, Dim::TIME, ""),
    unit("day", 86_400.0, Dim::TIME, ""),
    unit("rad", 1.0, Dim::ANGLE, "umµ"),
    unit("deg", DEG, Dim::ANGLE, ""),
    unit("°", DEG, Dim::ANGLE, ""),
    unit("gon", TURN / 400.0, Dim::ANGLE, ""),
    unit("turn", TURN, Dim::ANGLE, ""),
    unit("rev", TURN, Dim::ANGLE, ""),
    unit("rpm", TURN / 60.0, Dim::SPIN, ""),
    unit("Hz", 1.0, Dim::RATE, "mkM"),
    unit("N", 1.0, Dim::FORCE, "uµmkMG"),
    unit("kgf", 9.806_65, Dim::FORCE, ""),
    unit("tf", 9_806.65, Dim::FORCE, ""),
    unit("lbf", 4.448_221_615_260_5, Dim::FORCE, ""),
    unit("Pa", 1.0, Dim::PRESSURE, "kMGT"),
    unit("bar", 1e5, Dim::PRESSURE, "mkM"),
    unit("atm", 101_325.0, Dim::PRESSURE, ""),
    unit("psi", 6_894.757_293_168_361, Dim::PRESSURE, ""),
    unit("ksi", 6_894_757.293_168_361, Dim::PRESSURE, ""),
    unit("J", 1.0, Dim::ENERGY, "uµmkMG"),
    unit("W", 1.0, Dim::POWER, "mkMG"),
    unit("l", 1e-3, Dim::VOLUME, "m"),
    unit("L", 1e-3, Dim::VOLUME, "m"),
    unit("%", 0.01, Dim::NONE, ""),
];

fn prefix_factor(prefix: char) -> f64 {
    match prefix {
        'n' => 1e-9,
        'u' | 'µ' => 1e-6,
        'm' => 1e-3,
        'c' => 1e-2,
        'd' => 1e-1,
        'k' => 1e3,
        'M' => 1e6,
        'G' => 1e9,
        'T' => 1e12,
        _ => 1.0,
    }
}

/// Every unit as it can be written, prefix included.
pub fn all_names() -> Vec<String> {
    let mut names = Vec::new();
    for unit in UNITS {
        names.push(unit.name.to_owned());
        names.extend(unit.prefixes.chars().map(|prefix| format!("{prefix}{}", unit.name)));
    }
    names
}

fn find_unit(name: &str) -> Option<(f64, Dim)> {
    if let Some(unit) = UNITS.iter().find(|unit| unit.name == name) {
        return Some((unit.factor, unit.dim));
    }
    let first = name.chars().next()?;
    let rest = &name[first.len_utf8()..];
    // The other letter that Unicode has for "micro".
    let prefix = if first == 'μ' { 'µ' } else { first };
    UNITS
        .iter()
        .find(|unit| unit.name == rest && unit.prefixes.contains(prefix))
        .map(|unit| (prefix_factor(prefix) * unit.factor, unit.dim))
}

/// Words of units as people write them, and how they are written here.
const LONG_FORMS: &[(&str, &str)] = &[
    ("metre", "m"),
    ("meter", "m"),
    ("metres", "m"),
    ("meters", "m"),
    ("second", "s"),
    ("seconds", "s"),
    ("sec", "s"),
    ("secs", "s"),
    ("msec", "ms"),
    ("msecs", "ms"),
    ("millisecond", "ms"),
    ("milliseconds", "ms"),
    ("usec", "us"),
    ("microseconds", "us"),
    ("degree", "deg"),
    ("degrees", "deg"),
    ("radian", "rad"),
    ("radians", "rad"),
    ("newton", "N"),
    ("pascal", "Pa"),
    ("joule", "J"),
    ("hertz", "Hz"),
    ("hour", "h"),
    ("hours", "h"),
    ("minute", "min"),
    ("minutes", "min"),
    ("days", "day"),
    ("tonne", "t"),
    ("micron", "um"),
    ("cps", "Hz"),
    ("degs", "deg"),
    ("feet", "ft"),
    ("foot", "ft"),
    ("inch", "in"),
    ("inches", "in"),
    ("millimetre", "mm"),
    ("millimetres", "mm"),
    ("millimeter", "mm"),
    ("millimeters", "mm"),
    ("centimetres", "cm"),
    ("centimeters", "cm"),
    ("kilometres", "km"),
    ("kilometers", "km"),
    ("usecs", "us"),
    ("hr", "h"),
    ("hrs", "h"),
    ("tons", "t"),
    ("tonnes", "t"),
    ("gal", "cm/s2"),
    ("gals", "cm/s2"),
];

/// A unit expression with words that are spelled out (`sec`, `metres`) or in other capitals (`MM`) as they are written here.
#[must_use]
pub fn spelled(text: &str) -> String {
    let mut out = String::new();
    let mut rest = text;
    while let Some(first) = rest.chars().next() {
        let end = rest.find(|c: char| !c.is_alphabetic()).unwrap_or(rest.len());
        let (word, after) = rest.split_at(end.max(first.len_utf8()));
        let lower = word.to_lowercase();
        let long = LONG_FORMS.iter().find(|(long, _)| *long == lower);
        let long = long.map(|(_, short)| (*short).to_owned());
        let alike: Vec<String> = match find_unit(word) {
            Some(_) => Vec::new(),
            None => {
                (all_names().into_iter()).filter(|known| known.to_lowercase() == lower).collect()
            }
        };
        out.push_str(match (&long, &alike[..]) {
            (Some(long), _) => long,
            (None, [one]) => one,
            (None, _) => word,
        });
        rest = after;
    }
    out
}

fn unknown_unit(name: &str) -> UnitError {
    let names = all_names();
    let lower = name.to_lowercase();
    let same_letters = names.iter().find(|known| known.to_lowercase() == lower);
    let long_form = LONG_FORMS.iter().find(|(long, _)| *long == lower);
    let long_form = long_form.map(|(_, short)| (*short).to_owned());
    let suggestion = same_letters
        .cloned()
        .or(long_form)
        .or_else(|| super::diagnostic::closest(name, names.iter().map(String::as_str)));
    match suggestion {
        Some(known) => {
            UnitError::new(format!("unknown unit `{name}`"), format!("did you mean `{known}`?"))
        }
        None => UnitError::new(
            format!("unknown unit `{name}`"),
            "known units are m, mm, kg, t, s, ms, us, deg, rad, N, kN, MN, Pa, kPa, MPa, GPa, J, \
             Hz, rpm, ... and products such as kg/m3, GPa/m, m/s2",
        ),
    }
}

/// SI value and dimension of a text such as `"16 GPa"`.
///
/// # Errors
/// No number, a number that is not finite, or an unknown or unreadable unit.
pub fn parse(text: &str) -> Result<(f64, Dim), UnitError> {
    let text = text.trim();
    if text.len() > 100 {
        return Err(UnitError::new(
            "this is too long for a number with a unit",
            format!("write for example {ANY_EXAMPLE}"),
        ));
    }
    let (number, rest) = split_number(text)?;
    let (factor, dim) = parse_unit(rest.trim())?;
    let value = number * factor;
    if value.is_finite() {
        Ok((value, dim))
    } else {
        Err(UnitError::new("this is not a finite number", "write a finite number"))
    }
}

/// Value of a text in a unit, `-` for none: a plain number is in it already, a quantity must have its dimension. `None` for all others.
#[must_use]
pub fn value_in(text: &str, unit: &str) -> Option<f64> {
    if let Ok(plain) = text.trim().parse::<f64>() {
        return Some(plain).filter(|value| value.is_finite());
    }
    let (value, dim) = parse(text).ok()?;
    let (one, wanted) = if unit == "-" { (1.0, Dim::NONE) } else { parse_unit(unit).ok()? };
    (dim == wanted).then_some(value / one)
}

/// Dimension of a unit expression such as `"N/m"`; `"-"` and the empty text are pure numbers.
///
/// # Errors
/// An unknown or unreadable unit.
pub fn dimension(unit: &str) -> Result<Dim, UnitError> {
    if unit == "-" { Ok(Dim::NONE) } else { parse_unit(unit).map(|(_, dim)| dim) }
}

/// The unit of a text such as `"16 GPa"`, and what one of it is in SI; `None` without unit.
#[must_use]
pub fn unit_of(text: &str) -> Option<(&str, f64)> {
    let (_, rest) = split_number(text.trim()).ok()?;
    let unit = rest.trim();
    let (one, _) = parse_unit(unit).ok()?;
    (!unit.is_empty()).then_some((unit, one))
}

fn parse_unit(text: &str) -> Result<(f64, Dim), UnitError> {
    let mut factor = 1.0;
    let mut dim = Dim::NONE;
    let mut rest = text;
    let mut divide = false;
    let mut open = false; // an operator waits for its factor
    loop {
        rest = rest.trim_start_matches(' ');
        let Some(first) = rest.chars().next() else {
            break;
        };
        match first {
            '/' | '*' | '·' => {
                if open || (first != '/' && rest.len() == text.len()) {
                    return Err(bad_expression(text));
                }
                divide = first == '/';
                open = true;
                rest = &rest[first.len_utf8()..];
                continue;
            }
            '1' if !rest[1..].starts_with(|c: char| c.is_ascii_digit() || c == '.') => {
                // "1/s": the one is a factor like any other.
                rest = &rest[1..];
                (divide, open) = (false, false);
                continue;
            }
            _ => {}
        }
        let end =
            rest.find(|c: char| !(c.is_alphabetic() || c == '°' || c == '%')).unwrap_or(rest.len());
        if end == 0 {
            return Err(bad_expression(text));
        }
        let name = &rest[..end];
        let (power, after) = split_power(&rest[end..]).ok_or_else(|| bad_expression(text))?;
        let (unit_factor, unit_dim) = find_unit(name).ok_or_else(|| unknown_unit(name))?;
        let power = if divide { -power } else { power };
        factor *= whole_power(unit_factor, power);
        dim = dim.times(unit_dim, power).ok_or_else(|| bad_expression(text))?;
        (divide, open) = (false, false);
        rest = after;
    }
    if open { Err(bad_expression(text)) } else { Ok((factor, dim)) }
}

fn bad_expression(text: &str) -> UnitError {
    UnitError::new(
        format!("`{text}` is not a unit"),
        "a unit is written like \"kg/m3\", \"m/s^2\" or \"kN/m\"; no brackets",
    )
}

/// Power after a unit name: `2`, `^2`, `^-2`, `-1`, `²`, `³`; 1 if there is none.
fn split_power(text: &str) -> Option<(i32, &str)> {
    for (sign, power) in [("²", 2), ("³", 3), ("⁻¹", -1), ("⁻²", -2)] {
        if let Some(rest) = text.strip_prefix(sign) {
            return Some((power, rest));
        }
    }
    let (caret, rest) = match text.strip_prefix('^').or_else(|| text.strip_prefix("**")) {
        Some(rest) => (true, rest),
        None => (false, text),
    };
    let length = usize::from(rest.starts_with('-'));
    let digits = rest[length..].bytes().take_while(u8::is_ascii_digit).count();
    if digits == 0 {
        return if caret || length == 1 { None } else { Some((1, rest)) };
    }
    let end = length + digits;
    let power: i32 = rest[..end].parse().ok()?;
    (-9..=9).contains(&power).then_some((power, &rest[end..]))
}

/// `x^n` by products, the same bits on every machine.
fn whole_power(x: f64, n: i32) -> f64 {
    let power = (0..n.unsigned_abs()).fold(1.0, |p, _| p * x);
    if n < 0 { 1.0 / power } else { power }
}

#[cfg(test)]
mod tests;
