//! Values as the user wrote them: text or number, with the place in the file.
//!
//! A [`Quantity`] is converted when it is read, but an unreadable one is no parse error: the
//! reason is kept and reported by [`super::parse`], which collects all of them. After a check
//! without errors every [`Quantity::si`] is a finite number inside its range.

use std::borrow::Cow;
use std::fmt;
use std::marker::PhantomData;
use std::ops::Range;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::{Deserialize, Deserializer, Visitor};

use super::diagnostic::Diagnostic;
pub use super::moments::When;
pub use super::names::{Name, Names, Table};
use super::units::{self, Dim, UnitError};
use super::vectors::InSpace;
pub use super::vectors::{Axial, Direction, Down, Edges, Moments, Tensor, Vector};

/// Bytes of the source text.
pub type Span = Range<usize>;

/// Number or text as it stands in the file.
#[derive(Debug, Clone, PartialEq)]
pub enum Raw {
    /// A bare number.
    Number(f64),
    /// A string.
    Text(String),
}

impl fmt::Display for Raw {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Raw::Number(number) => write!(f, "{number}"),
            Raw::Text(text) => write!(f, "{text}"),
        }
    }
}

impl<'de> Deserialize<'de> for Raw {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct RawVisitor;
        impl Visitor<'_> for RawVisitor {
            type Value = Raw;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a number with a unit in quotes")
            }
            fn visit_i64<E>(self, value: i64) -> Result<Raw, E> {
                Ok(Raw::Number(value as f64))
            }
            fn visit_u64<E>(self, value: u64) -> Result<Raw, E> {
                Ok(Raw::Number(value as f64))
            }
            fn visit_f64<E>(self, value: f64) -> Result<Raw, E> {
                Ok(Raw::Number(value))
            }
            fn visit_str<E>(self, value: &str) -> Result<Raw, E> {
                Ok(Raw::Text(value.to_owned()))
            }
        }
        deserializer.deserialize_any(RawVisitor)
    }
}

/// Interval of allowed SI values.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bounds {
    /// Lower end.
    pub low: f64,
    /// Upper end.
    pub high: f64,
    /// Whether the lower end itself is allowed.
    pub low_closed: bool,
    /// Whether the upper end itself is allowed.
    pub high_closed: bool,
    /// The interval in the user's words.
    pub text: &'static str,
}

impl Bounds {
    /// Whether a finite value lies inside.
    pub fn contains(&self, value: f64) -> bool {
        (value > self.low || (self.low_closed && value == self.low))
            && (value < self.high || (self.high_closed && value == self.high))
    }
}

/// What a key expects: dimension, range, and how to say so.
pub trait Kind: fmt::Debug + Clone + PartialEq + JsonSchema + 'static {
    /// Short name, used in the names of schema types.
    const NAME: &'static str;
    /// Expected dimension; `None` takes any (checked later against a field).
    const DIM: Option<Dim>;
    /// Allowed SI values.
    const BOUNDS: Bounds;
    /// "a joint stiffness (pressure per length)".
    const WHAT: &'static str;
    /// A value to copy.
    const EXAMPLE: &'static str;
    /// What it is in `[space.spatial]`, if that differs: in the plane it is per metre of thickness.
    const SPATIAL: Option<Other>;
}

/// What a kind is in the other space.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Other {
    /// Expected dimension.
    pub dim: Dim,
    /// What it is called.
    pub what: &'static str,
    /// A value to copy.
    pub example: &'static str,
}

const ALL: Bounds = Bounds {
    low: f64::NEG_INFINITY,
    high: f64::INFINITY,
    low_closed: false,
    high_closed: false,
    text: "any finite value",
};
const POSITIVE: Bounds = Bounds { low: 0.0, text: "greater than zero", ..ALL };
const NOT_NEGATIVE: Bounds = Bounds { low: 0.0, low_closed: true, text: "zero or more", ..ALL };
const RIGHT_ANGLE: f64 = std::f64::consts::FRAC_PI_2;

/// The constants of a [`Kind`] as data.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct KindInfo {
    /// [`Kind::NAME`]
    pub name: &'static str,
    /// [`Kind::DIM`]
    pub dim: Option<Dim>,
    /// [`Kind::BOUNDS`]
    pub bounds: Bounds,
    /// [`Kind::WHAT`]
    pub what: &'static str,
    /// [`Kind::EXAMPLE`]
    pub example: &'static str,
    /// [`Kind::SPATIAL`]
    pub spatial: Option<Other>,
}

impl KindInfo {
    const fn of<K: Kind>() -> Self {
        KindInfo {
            name: K::NAME,
            dim: K::DIM,
            bounds: K::BOUNDS,
            what: K::WHAT,
            example: K::EXAMPLE,
            spatial: K::SPATIAL,
        }
    }

    /// The kind as it is in a space.
    #[must_use]
    pub fn in_space(mut self, space: Option<InSpace>) -> Self {
        if let (Some(InSpace::Spatial), Some(other)) = (space, self.spatial) {
            self.dim = Some(other.dim);
            self.what = other.what;
            self.example = other.example;
        }
        self
    }

    /// The kind of that name.
    pub fn named(name: &str) -> Option<&'static KindInfo> {
        KINDS.iter().find(|kind| kind.name == name)
    }
}

macro_rules! kinds {
    ($($(#[$doc:meta])* $name:ident: $dim:expr, $bounds:expr, $what:literal, $example:literal
        $(, in space $other:expr, $other_what:literal, $other_example:literal)?;)*) => {$(
        $(#[$doc])*
        #[derive(Debug, Clone, Copy, PartialEq)]
        pub enum $name {}
        impl Kind for $name {
            const NAME: &'static str = stringify!($name);
            const DIM: Option<Dim> = $dim;
            const BOUNDS: Bounds = $bounds;
            const WHAT: &'static str = $what;
            const EXAMPLE: &'static str = $example;
            const SPATIAL: Option<Other> = kinds!(@other $($other, $other_what, $other_example)?);
        }
        impl JsonSchema for $name {
            fn schema_name() -> Cow<'static, str> {
                Cow::Borrowed(stringify!($name))
            }
            fn json_schema(_: &mut SchemaGenerator) -> Schema {
                quantity_schema::<$name>()
            }
        }
    )*
    /// All kinds.
    pub const KINDS: &[KindInfo] = &[$(KindInfo::of::<$name>()),*];
    };
    (@other) => { None };
    (@other $dim:expr, $what:literal, $example:literal) => {
        Some(Other { dim: $dim, what: $what, example: $example })
    };
}

kinds! {
    /// Any dimension; compared later with the unit of a field or key.
    Any: None, ALL, "a quantity", "0.1 m";
    /// A number, a quantity, or a key of the scenario whose SI value is taken.
    NumberOrKey: None, ALL, "a number, a value with unit or a key", "9.81";
    /// A number without unit.
    Plain: Some(Dim::NONE), ALL, "a number without unit", "1.0";
    /// A number > 0 without unit.
    PositivePlain: Some(Dim::NONE), POSITIVE, "a number without unit", "1e-5";
    /// A number >= 0 without unit.
    NotNegativePlain: Some(Dim::NONE), NOT_NEGATIVE, "a number without unit", "0.2";
    /// A share, 0 < x <= 1.
    Share: Some(Dim::NONE), Bounds { low: 0.0, high: 1.0, low_closed: false, high_closed: true, text: "greater than 0 and at most 1" }, "a number without unit", "1.0";
    /// A share, 0 <= x < 1.
    ShareBelowOne: Some(Dim::NONE), Bounds { low: 0.0, high: 1.0, low_closed: true, high_closed: false, text: "at least 0 and less than 1" }, "a number without unit", "0.7";
    /// A coefficient of restitution, 0.01 <= x <= 1 (`LEAST_RESTITUTION` of the law of dashpots).
    Restitution: Some(Dim::NONE), Bounds { low: riprap_core::laws::damping::LEAST_RESTITUTION, high: 1.0, low_closed: true, high_closed: true, text: "at least 0.01 and at most 1" }, "a number without unit", "0.3";
    /// Poisson's ratio, -1 < x < 0.5.
    Poisson: Some(Dim::NONE), Bounds { low: -1.0, high: 0.5, low_closed: false, high_closed: false, text: "greater than -1 and less than 0.5" }, "a number without unit", "0.25";
    /// A joint roughness coefficient, 0 to 20.
    JointRoughness: Some(Dim::NONE), Bounds { low: 0.0, high: 20.0, low_closed: true, high_closed: true, text: "at least 0 and at most 20" }, "a number without unit", "10";
    /// A factor of 1 or more.
    AtLeastOne: Some(Dim::NONE), Bounds { low: 1.0, low_closed: true, text: "1 or more", ..ALL }, "a number without unit", "25";
    /// A strength > 0, Pa.
    PositiveStrength: Some(Dim::PRESSURE), POSITIVE, "a strength (force per area)", "100 MPa";
    /// A length or coordinate, m.
    Length: Some(Dim::LENGTH), ALL, "a length", "1.5 m";
    /// A length > 0, m.
    PositiveLength: Some(Dim::LENGTH), POSITIVE, "a length", "0.5 m";
    /// A length >= 0, m.
    NotNegativeLength: Some(Dim::LENGTH), NOT_NEGATIVE, "a length", "0.02 m";
    /// An angle, rad.
    Angle: Some(Dim::ANGLE), ALL, "an angle", "30 deg";
    /// An angle >= 0, rad.
    NotNegativeAngle: Some(Dim::ANGLE), NOT_NEGATIVE, "an angle", "2 deg";
    /// Half the opening of an arch, 0 < x <= 180 deg, rad.
    HalfAngle: Some(Dim::ANGLE), Bounds { low: 0.0, high: std::f64::consts::PI, low_closed: false, high_closed: true, text: "greater than 0 deg and at most 180 deg" }, "an angle", "90 deg";
    /// A friction angle, 0 <= x < 90 deg, rad.
    FrictionAngle: Some(Dim::ANGLE), Bounds { low: 0.0, high: RIGHT_ANGLE, low_closed: true, high_closed: false, text: "at least 0 deg and less than 90 deg" }, "a friction angle", "30 deg";
    /// Mass density, kg/m3.
    Density: Some(Dim::DENSITY), POSITIVE, "a density (mass per volume)", "2600 kg/m3";
    /// Young's modulus, Pa.
    Modulus: Some(Dim::PRESSURE), POSITIVE, "a modulus", "10 GPa";
    /// A stress, traction or pressure, Pa.
    Pressure: Some(Dim::PRESSURE), ALL, "a pressure", "1 MPa";
    /// A pressure >= 0, Pa.
    NotNegativePressure: Some(Dim::PRESSURE), NOT_NEGATIVE, "a pressure", "0.1 MPa";
    /// A dynamic viscosity > 0, Pa s.
    Viscosity: Some(Dim::VISCOSITY), POSITIVE, "a viscosity", "1e-3 Pa s";
    /// A strength >= 0, Pa.
    Strength: Some(Dim::PRESSURE), NOT_NEGATIVE, "a strength (force per area)", "2 MPa";
    /// A joint or contact stiffness per area, Pa/m.
    StiffnessPerArea: Some(Dim::STIFFNESS_PER_AREA), POSITIVE, "a joint stiffness (pressure per length)", "10 GPa/m";
    /// A time, s.
    Time: Some(Dim::TIME), ALL, "a time", "1.5 s";
    /// A time > 0, s.
    PositiveTime: Some(Dim::TIME), POSITIVE, "a time", "1.5 s";
    /// A time step > 0, s.
    TimeStep: Some(Dim::TIME), POSITIVE, "a time", "10 us";
    /// A time >= 0, s.
    NotNegativeTime: Some(Dim::TIME), NOT_NEGATIVE, "a time", "0.5 s";
    /// A velocity, m/s.
    Velocity: Some(Dim::VELOCITY), ALL, "a velocity", "0.1 m/s";
    /// A speed > 0, m/s.
    Speed: Some(Dim::VELOCITY), POSITIVE, "a speed", "1 mm/s";
    /// A rate of turning, rad/s, anticlockwise.
    Spin: Some(Dim::SPIN), ALL, "a spin (angle per time)", "0.1 rad/s";
    /// A rate of change of spin, rad/s2.
    SpinAcceleration: Some(Dim::SPIN_ACCELERATION), ALL, "an angular acceleration", "0.1 rad/s2";
    /// An acceleration, m/s2.
    Acceleration: Some(Dim::ACCELERATION), ALL, "an acceleration", "-9.81 m/s2";
    /// A force per metre of thickness, N/m.
    ForcePerLength: Some(Dim::FORCE_PER_LENGTH), ALL, "a force per metre of thickness (2D)", "-10 kN/m", in space Dim::FORCE, "a force", "-10 kN";
    /// A moment per metre of thickness, N (= N m/m).
    MomentPerLength: Some(Dim::FORCE), ALL, "a moment per metre of thickness (N m/m = N)", "3 N", in space Dim::ENERGY, "a moment", "3 N m";
    /// A frequency > 0, Hz.
    Frequency: Some(Dim::RATE), POSITIVE, "a frequency", "2 Hz";
    /// A rate > 0, 1/s.
    PositiveRate: Some(Dim::RATE), POSITIVE, "a rate", "1500 1/s";
    /// A force > 0, N, in the plane too.
    PositiveForce: Some(Dim::FORCE), POSITIVE, "a force", "200 kN";
    /// Cross-section, m2.
    PositiveArea: Some(Dim::AREA), POSITIVE, "an area", "490 mm2";
    /// Shear stiffness of grout, N/m for each metre.
    BondStiffness: Some(Dim::PRESSURE), POSITIVE, "a force per length and slip", "1 GN/m2";
    /// Shear strength of grout, N/m.
    BondStrength: Some(Dim::FORCE_PER_LENGTH), POSITIVE, "a force per length", "200 kN/m";
    /// Stiffness of a single spring, N/m.
    SpringStiffness: Some(Dim::FORCE_PER_LENGTH), POSITIVE, "a force per displacement", "100 MN/m";
    /// A fracture energy > 0, J/m2.
    FractureEnergy: Some(Dim::FORCE_PER_LENGTH), POSITIVE, "a fracture energy (energy per area)", "50 J/m2";
    /// A mass > 0, kg.
    Mass: Some(Dim::MASS), POSITIVE, "a mass", "0.03 kg";
    /// A mass per metre of thickness > 0, kg/m.
    MassPerLength: Some(Dim([1, -1, 0, 0])), POSITIVE, "a mass per metre of thickness (2D)", "400 kg/m", in space Dim::MASS, "a mass", "400 kg";
    /// A moment of inertia per metre of thickness, kg m.
    InertiaPerLength: Some(Dim([1, 1, 0, 0])), ALL, "a moment of inertia per metre of thickness (2D)", "20 kg m", in space Dim([1, 2, 0, 0]), "a moment of inertia", "20 kg m2";
    /// Energy per mass, J/kg.
    SpecificEnergy: Some(Dim::SPECIFIC_ENERGY), POSITIVE, "an energy per mass", "4180 kJ/kg";
    /// Change of a pressure with depth, Pa/m.
    PressureGradient: Some(Dim::STIFFNESS_PER_AREA), ALL, "a pressure per length", "26 kPa/m";
    /// An angle > 0, rad.
    PositiveAngle: Some(Dim::ANGLE), POSITIVE, "an angle", "0.01 rad";
    /// A rate >= 0, 1/s.
    Rate: Some(Dim::RATE), NOT_NEGATIVE, "a rate", "5 1/s";
    /// An energy per metre of thickness > 0, J/m.
    EnergyPerLength: Some(Dim::FORCE), POSITIVE, "an energy per metre of thickness", "1 J/m", in space Dim::ENERGY, "an energy", "1 J";
}

/// A value of one kind, with its place in the file.
#[derive(Debug, Clone, PartialEq)]
pub struct Quantity<K: Kind> {
    /// What was written.
    pub raw: Raw,
    /// Where.
    pub span: Span,
    kind: PhantomData<K>,
}

impl<K: Kind> Quantity<K> {
    /// A quantity as it stands in the file.
    pub fn new(raw: Raw, span: Span) -> Self {
        Quantity { raw, span, kind: PhantomData }
    }

    /// A quantity from text, at no place; for tests and defaults.
    pub fn from_text(text: &str) -> Self {
        Quantity { raw: Raw::Text(text.to_owned()), span: 0..0, kind: PhantomData }
    }

    /// SI value and dimension without looking at the range. A bare number has dimension `None`:
    /// it is whatever the key expects (allowed when the file says `units = "SI"`).
    pub fn read(&self) -> Result<(f64, Option<Dim>), UnitError> {
        match &self.raw {
            Raw::Number(value) => Ok((*value, None)),
            Raw::Text(text) => units::parse(text).map(|(value, dim)| (value, Some(dim))),
        }
    }

    /// SI value as a number in the unit of a field, for example `"N/m"` (`"-"` for none).
    /// `bare_is_si`: the file says `units = "SI"`.
    ///
    /// # Errors
    /// Another dimension, with the place and what to write.
    pub fn in_unit(&self, unit: &str, bare_is_si: bool) -> Result<f64, Diagnostic> {
        let expected = units::dimension(unit).unwrap_or(Dim::NONE);
        let wrong = |label: String| {
            Diagnostic::error("unit.dimension", "the unit does not suit the field")
                .at(self.span.clone())
                .label(label)
                .help(if expected == Dim::NONE {
                    "write a number without unit".to_owned()
                } else {
                    format!("the unit of the field is {unit}: write for example \"0.1 {unit}\"")
                })
        };
        match self.read() {
            Ok((value, None)) if bare_is_si || expected == Dim::NONE => Ok(value),
            Ok((_, None)) => Err(wrong("the unit is missing".to_owned())),
            Ok((value, Some(dim))) if dim == expected => Ok(value),
            Ok((_, Some(dim))) => Err(wrong(format!(
                "this is {}, {} is expected",
                dim.describe(),
                expected.describe()
            ))),
            Err(error) => Err(wrong(error.message)),
        }
    }

    /// The unit that was written, and what one of it is in SI; `None` for bare numbers and what cannot be read.
    pub fn unit(&self) -> Option<(&str, f64)> {
        match &self.raw {
            Raw::Number(_) => None,
            Raw::Text(text) => units::unit_of(text),
        }
    }

    /// SI value; NaN where [`super::parse`] would report an error.
    pub fn si(&self) -> f64 {
        self.read().map_or(f64::NAN, |(value, _)| value)
    }
}

impl Quantity<FrictionAngle> {
    /// The coefficient of friction. Laws of sliding know no angle, and this is the only place that makes their number of one; where a
    /// formula is in angles (Barton and Bandis, the plane of a cut, what is shown of a default) the angle is made of it again.
    pub fn tangent(&self) -> f64 {
        libm::tan(self.si())
    }
}

impl<'de, K: Kind> Deserialize<'de> for Quantity<K> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let raw = toml::Spanned::<Raw>::deserialize(deserializer)?;
        let span = raw.span();
        Ok(Quantity { raw: raw.into_inner(), span, kind: PhantomData })
    }
}

impl<K: Kind> JsonSchema for Quantity<K> {
    fn schema_name() -> Cow<'static, str> {
        Cow::Borrowed(K::NAME)
    }
    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        quantity_schema::<K>()
    }
}

fn quantity_schema<K: Kind>() -> Schema {
    let description = match K::DIM {
        Some(dim) if dim == Dim::NONE => format!("A number without unit, {}.", K::BOUNDS.text),
        Some(_) => {
            let other = K::SPATIAL.map_or_else(String::new, |other| {
                format!(" In [space.spatial] {}, for example \"{}\".", other.what, other.example)
            });
            format!(
                "{}, for example \"{}\"; {}.{other}",
                capital(K::WHAT),
                K::EXAMPLE,
                K::BOUNDS.text
            )
        }
        None => "A number with a unit; the unit must suit what it is compared with.".to_owned(),
    };
    let mut schema = json_schema!({ "type": ["string", "number"], "description": description });
    let bounds = K::BOUNDS;
    // Of bare numbers, which are SI; in texts the unit decides.
    for (end, closed, word, open_word) in [
        (bounds.low, bounds.low_closed, "minimum", "exclusiveMinimum"),
        (bounds.high, bounds.high_closed, "maximum", "exclusiveMaximum"),
    ] {
        if end.is_finite() {
            schema.insert((if closed { word } else { open_word }).to_owned(), end.into());
        }
    }
    schema
}

/// First letter in upper case.
fn capital(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bare_numbers_have_their_range_in_the_schema() {
        let range = |schema: Schema| {
            let words = ["minimum", "exclusiveMinimum", "maximum", "exclusiveMaximum"];
            words.map(|word| schema.get(word).and_then(serde_json::Value::as_f64))
        };
        assert_eq!(range(quantity_schema::<Poisson>()), [None, Some(-1.0), None, Some(0.5)]);
        assert_eq!(range(quantity_schema::<Share>()), [None, Some(0.0), Some(1.0), None]);
        assert_eq!(
            range(quantity_schema::<FrictionAngle>()),
            [Some(0.0), None, None, Some(RIGHT_ANGLE)]
        );
        assert_eq!(range(quantity_schema::<Length>()), [None; 4]);
    }
}
