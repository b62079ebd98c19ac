//! Charges and other cavities that push on the rock around them, and the splitting of blocks.

use std::borrow::Cow;
use std::fmt;

use riprap_core::laws::jwl::Jwl;
use riprap_keys::{Keys, Words};
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::Deserialize;
use serde::de::value::MapAccessDeserializer;
use serde::de::{Deserializer, MapAccess, SeqAccess, Visitor};

use super::outputs::Every;
use super::points::Point3;
use super::solids::{Ball, BoxRegion, Empty, Plane, Segment};
use crate::quantity::{
    Angle, Density, Length, Mass, Modulus, Name, NotNegativeLength, NotNegativePlain,
    NotNegativePressure, NotNegativeTime, Plain, PositiveLength, PositivePlain, PositiveRate,
    Pressure, Quantity, Share, Span, SpecificEnergy, Speed, Strength, Vector, Viscosity,
};
use crate::time_function::TimeFunction;
use crate::words::WordOr;

/// A cavity that pushes on the faces around it.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Source {
    /// Detonation gas on its adiabat, in balance with the volume of the cavity.
    GasCavity(Box<GasCavity>),
    /// A pressure over time that does not depend on the volume of the cavity.
    PressureCavity(Box<PressureCavity>),
}

/// A charge of explosive. The blocks that it touches are removed at the start, after splitting; the
/// faces that they shared with others are pushed.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
#[keys(one_of("centre", "line", "group", "pattern"))]
pub struct GasCavity {
    /// Centre of a concentrated charge [x, y, z], m.
    pub centre: Option<Point3>,
    /// Axis of an elongated charge.
    pub line: Option<Segment>,
    /// All blocks of a group, or one block.
    pub group: Option<Name>,
    /// Many holes, from a CSV file or in rows; the sources are called name.1, name.2, ...
    pub pattern: Option<Pattern>,
    /// Charges one behind the other in the hole along `line`, which then is the whole hole, with stemming that stays between them; the
    /// sources are called name.1, name.2, ... in their order.
    #[key(needs(
        "line",
        help = "decks are parts of a hole: give its collar and its toe as `line`"
    ))]
    pub decks: Option<Vec<Deck>>,
    /// Mass of the charge, kg.
    #[key(excludes(
        "pattern",
        help = "a pattern has the masses: column charge_kg of a file, `charge` of a grid"
    ))]
    #[key(excludes("decks", help = "each deck has a `mass` of its own"))]
    #[key(required("!pattern & !decks"))]
    pub mass: Option<Quantity<Mass>>,
    /// The explosive: a name from `[explosives]`, or its constants.
    pub explosive: WordOr<Name, Explosive>,
    /// How the volume of the charge and that of the removed blocks are matched. Default `fitted`
    /// with `centre`, else `{ scaled = 0.6667 }`.
    pub coupling: Option<WordOr<CouplingWord, CouplingScale>>,
    /// Time at which it goes off, s. With `pattern` it is added to the delays of the holes.
    #[key(default = "0 s")]
    pub delay: Option<Quantity<NotNegativeTime>>,
    /// How the gas escapes. Default: it stays in.
    pub venting: Option<Venting>,
    /// Detonation that runs along the charge. Default: all of it turns to gas at once.
    #[key(needs(
        "line | pattern",
        help = "a detonation runs along a charge with a `line` or a `pattern`"
    ))]
    pub detonation: Option<Detonation>,
    /// Stemming above the charge, which the gas may blow out. Default: the hole stays closed.
    #[key(needs(
        "line | pattern",
        help = "stemming stands in a hole: give the charge a `line` or a `pattern`"
    ))]
    pub stemming: Option<Stemming>,
}

impl GasCavity {
    /// Whether the cells of the grid are to fit the charge.
    pub fn is_fitted(&self) -> bool {
        let word = match &self.coupling {
            None => CouplingWord::Fitted,
            Some(WordOr::Word(word, _)) => *word,
            Some(WordOr::Table(..)) => return false,
        };
        self.centre.is_some() && word == CouplingWord::Fitted
    }
}

/// One of the charges of a hole.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
pub struct Deck {
    /// Distance of its upper end from the collar, along the hole, m.
    pub from: Quantity<NotNegativeLength>,
    /// Distance of its lower end from the collar, m.
    pub to: Quantity<PositiveLength>,
    /// Mass of the charge, kg.
    pub mass: Quantity<Mass>,
    /// Time at which it goes off, after `delay` of the hole, s.
    #[key(default = "0 s")]
    pub delay: Option<Quantity<NotNegativeTime>>,
}

/// A detonation that runs along a charge, both ways from its primer. Walls are pushed once it has passed them.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
pub struct Detonation {
    /// The end of the charge at which the primer lies.
    #[key(excludes("at", help = "`at` says where the primer lies"))]
    #[key(default)]
    pub primer: Option<Primer>,
    /// Where the primer lies [x, y, z], m; on the line of a single charge.
    pub at: Option<Point3>,
    /// Its velocity, m/s. Default that of the explosive; with `jwl` that of its state of Chapman and Jouguet.
    pub velocity: Option<Quantity<Speed>>,
}

/// An end of a charge.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Words)]
pub enum Primer {
    /// The lower end, `to` of a line.
    #[default]
    Toe,
    /// The upper end, `from` of a line.
    Collar,
}

/// A column of stemming above a charge, with inertia and friction. Once the gas has driven it out of its hole, gas leaves there.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
pub struct Stemming {
    /// Its length, m. With `decks` up to the collar by default, with `pattern` the column `stemming_m` of the file, or the `stemming` of the grid.
    pub length: Option<Quantity<PositiveLength>>,
    /// Diameter of the hole, m.
    pub diameter: Quantity<PositiveLength>,
    /// Its density, kg/m3.
    #[key(default = "1800 kg/m3")]
    pub density: Option<Quantity<Density>>,
    /// Shear stress with which its side resists, Pa; 0 Pa: inertia alone.
    pub friction: Quantity<NotNegativePressure>,
}

/// An explosive by the equation of state of its gas.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
pub struct Explosive {
    /// Density of the charge, kg/m3. A published set of `jwl` has its own.
    #[key(required("!jwl"))]
    pub density: Option<Quantity<Density>>,
    /// Velocity of detonation, m/s. With `jwl` it is compared with that of the constants.
    #[key(required("!jwl"))]
    pub detonation_velocity: Option<Quantity<Speed>>,
    /// Heat of explosion, J/kg.
    #[key(excludes(
        "jwl",
        help = "it belongs to the two-stage adiabat; `jwl` has constants of its own"
    ))]
    #[key(required("!jwl"))]
    pub heat_of_explosion: Option<Quantity<SpecificEnergy>>,
    /// Exponent of the adiabat above the transition pressure.
    #[key(excludes(
        "jwl",
        help = "it belongs to the two-stage adiabat; `jwl` has constants of its own"
    ))]
    #[key(default = "3")]
    pub gamma: Option<Quantity<PositivePlain>>,
    /// Exponent below the transition pressure. Default 4/3.
    #[key(excludes(
        "jwl",
        help = "it belongs to the two-stage adiabat; `jwl` has constants of its own"
    ))]
    pub gamma_low: Option<Quantity<PositivePlain>>,
    /// Equation of state of Jones, Wilkins and Lee instead of the two-stage adiabat: a published set, or constants.
    pub jwl: Option<WordOr<JwlSet, JwlConstants>>,
}

impl Explosive {
    /// Density of the charge, kg/m³, where it is known.
    pub fn charge_density(&self) -> Option<f64> {
        match (&self.density, &self.jwl) {
            (Some(density), _) => Some(density.si()),
            (None, Some(WordOr::Word(set, _))) => Some(set.constants().density),
            (None, Some(WordOr::Table(..)) | None) => None,
        }
    }
}

/// Published constants of the equation of state of Jones, Wilkins and Lee.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Words)]
pub enum JwlSet {
    /// TNT, 1630 kg/m3.
    Tnt,
    /// ANFO, 931 kg/m3.
    Anfo,
    /// Gassed emulsion, 1310 kg/m3.
    Emulsion,
}

impl JwlSet {
    /// In numbers.
    pub fn constants(self) -> Jwl {
        match self {
            Self::Tnt => Jwl::TNT,
            Self::Anfo => Jwl::ANFO,
            Self::Emulsion => Jwl::EMULSION,
        }
    }
}

/// Constants of the equation of state of Jones, Wilkins and Lee.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
pub struct JwlConstants {
    /// A, Pa.
    pub a: Quantity<Modulus>,
    /// B, Pa.
    pub b: Quantity<Modulus>,
    /// R1.
    pub r1: Quantity<PositivePlain>,
    /// R2.
    pub r2: Quantity<PositivePlain>,
    /// Omega.
    pub omega: Quantity<PositivePlain>,
    /// Energy of detonation per volume, J/m3 (1 kJ/cm3 is 1 GPa).
    pub energy: Quantity<Modulus>,
}

/// How the volume of a charge and that of the removed blocks are matched, as a word.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Words)]
pub enum CouplingWord {
    /// The cells of the grid are changed so that the finest ones around the charge have its volume; for `centre` inside a grid that is split around it.
    Fitted,
    /// The gas starts with the volume of the charge, whatever the blocks are.
    Coupled,
    /// The gas starts expanded to the volume of the removed blocks.
    Decoupled,
}

/// How the volume of a charge and that of the removed blocks are matched, by a factor.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
pub struct CouplingScale {
    /// Faces count with the factor (volume of the charge / volume of the blocks) to this power: 2/3
    /// keeps the force on the wall, 1/2 the elastic plateau, 1 keeps pressure times volume.
    pub scaled: Quantity<NotNegativePlain>,
}

/// How gas escapes.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Venting {
    /// At once, when the blocks above the charge have risen by this height on average, m.
    Heave(Quantity<PositiveLength>),
    /// From a time after the detonation on.
    Time(VentingTime),
    /// Through the joints that it breaks: it enters them, drives them open, and leaves where they reach a free face.
    Cracks(VentingCracks),
}

/// Gas escapes over a span of time.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
pub struct VentingTime {
    /// Time after the detonation at which it begins, s.
    pub start: Quantity<NotNegativeTime>,
    /// Time over which the pressure falls to zero, s; 0 s: at once.
    #[key(default = "0 s")]
    pub span: Option<Quantity<NotNegativeTime>>,
}

/// Gas enters the joints that it breaks: a network of cracks between rigid blocks, with the mass of the gas in each. Faces with a condition
/// of the model are closed to it, others open to the air.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
pub struct VentingCracks {
    /// Viscosity of the gas, Pa s.
    #[key(default = "2e-5 Pa s")]
    pub viscosity: Option<Quantity<Viscosity>>,
    /// Roughness of the walls, m, for the friction of fast flow, and the flow ends at the velocity of sound; 0 m: laminar at any speed.
    #[key(default = "0.1 mm")]
    pub roughness: Option<Quantity<NotNegativeLength>>,
    /// Whether the gas has inertia: pressures in wide cracks then become even at the velocity of sound; without it, at once, which takes more time to compute.
    #[key(default = true)]
    pub inertia: Option<bool>,
    /// Aperture of a broken joint whose sides touch, m; its opening adds to it.
    #[key(default = "0.1 mm")]
    pub aperture: Option<Quantity<PositiveLength>>,
    /// Largest aperture that counts for the flow, m: wider cracks conduct as if they had this one.
    #[key(default = "20 mm")]
    pub aperture_max: Option<Quantity<PositiveLength>>,
    /// Pressure of the air, Pa: gas pushes with what it has above that, and leaves until it has come down to it.
    #[key(default = "0.1 MPa")]
    pub air_pressure: Option<Quantity<NotNegativePressure>>,
}

/// Holes of a blast, from a CSV file or in rows.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
#[keys(one_of("csv", "grid"))]
pub struct Pattern {
    /// Path of the CSV file. Columns, each with its unit behind an
    /// underscore (`collar_x_m`, `delay_ms`): `collar_x`, `collar_y`, `collar_z`, `toe_x`, `toe_y`,
    /// `toe_z`, `delay`; `charge` (mass) or `diameter` of the hole; optional `stemming` (length
    /// without explosive below the collar).
    pub csv: Option<Name>,
    /// Rows of equal holes, numbered row by row.
    pub grid: Option<PatternGrid>,
}

/// Equal holes in rows. The first row is the front one; the others lie behind it, to the left of who looks along a row.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
#[keys(one_of("charge", "diameter"))]
pub struct PatternGrid {
    /// Collar of the first hole of the front row [x, y, z], m.
    pub collar: Point3,
    /// Level direction of the rows, of any length. Default `[1, 0, 0]`: rows lie behind each other along y.
    pub along: Option<Vector<Plain>>,
    /// Number of rows.
    #[key(default = 1, min = 1, max = 1000)]
    pub rows: Option<u64>,
    /// Number of holes in a row.
    #[key(min = 1, max = 1000)]
    pub holes: u64,
    /// Distance of the holes of a row, m.
    pub spacing: Quantity<PositiveLength>,
    /// Distance of the rows, m.
    pub burden: Quantity<PositiveLength>,
    /// Whether every second row is shifted by half of the spacing, along the row. Default false: a square pattern.
    #[serde(default)]
    pub staggered: bool,
    /// Length of a hole from its collar to its toe, m.
    pub length: Quantity<PositiveLength>,
    /// Angle between holes and the vertical: the toes lie to the front of the collars.
    #[key(default = "0 deg")]
    pub inclination: Option<Quantity<Angle>>,
    /// Length of a hole without explosive below the collar, m.
    #[key(default = "0 m")]
    pub stemming: Option<Quantity<NotNegativeLength>>,
    /// Mass of the charge of a hole, kg.
    pub charge: Option<Quantity<Mass>>,
    /// Diameter of the holes, m: the mass is that of the explosive which fills them.
    pub diameter: Option<Quantity<PositiveLength>>,
    /// Time from one hole of a row to the next, s.
    #[key(default = "0 s")]
    pub delay_holes: Option<Quantity<NotNegativeTime>>,
    /// Time from the first hole of a row to that of the next row, s.
    #[key(default = "0 s")]
    pub delay_rows: Option<Quantity<NotNegativeTime>>,
}

/// A cavity with a given pressure.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
#[keys(one_of("centre", "line", "group"))]
pub struct PressureCavity {
    /// Centre [x, y, z], m: the blocks that touch it are removed.
    pub centre: Option<Point3>,
    /// Axis: the blocks that touch it are removed.
    pub line: Option<Segment>,
    /// All blocks of a group, or one block.
    pub group: Option<Name>,
    /// Pressure over the time since `delay`, Pa.
    pub pressure: TimeFunction<Pressure>,
    /// Time at which it begins, s.
    #[key(default = "0 s")]
    pub delay: Option<Quantity<NotNegativeTime>>,
}

/// Splits bricks and parallelepipeds into eight, again and again, around something. Neighbours never differ by more
/// than one level: more blocks are split where that needs it.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
pub struct Refine {
    /// Where, and how often.
    pub octree: Octree,
    /// Splits while the model runs, where a criterion is met. Default: before the first step,
    /// everywhere in the place.
    pub during: Option<During>,
}

/// Where blocks are split, and how often.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
pub struct Octree {
    /// What blocks must touch to be split: the name of a source, a point [x, y, z], or a place; or the blocks of a group, a block or a condition.
    pub around: Around,
    /// How often a block is split: each level halves the edges. 0 (not at all) to 12. Default around a charge
    /// with fitted coupling: the number for which the cell changes least.
    #[key(max = 12)]
    pub levels: Option<u8>,
}

/// A place in space.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Place {
    /// A piece of a line.
    Line(Segment),
    /// A plane.
    Plane(Plane),
    /// A ball.
    Ball(Ball),
    /// A box.
    Box(BoxRegion),
    /// Everywhere: `all = {}`.
    All(Empty),
}

/// The name of a source, a point, or a place.
#[derive(Debug, Clone, PartialEq)]
pub enum Around {
    /// A source.
    Source(Name),
    /// A point.
    Point(Vector<Length>),
    /// Another place.
    Place(Box<Place>, Span),
}

impl Around {
    /// Where it stands.
    pub fn span(&self) -> &Span {
        match self {
            Around::Source(name) => &name.span,
            Around::Point(point) => &point.span,
            Around::Place(_, span) => span,
        }
    }
}

impl<'de> Deserialize<'de> for Around {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        enum Read {
            Word(String),
            Point(Vec<Quantity<Length>>),
            Place(Box<Place>),
        }
        struct AroundVisitor;
        impl<'de> Visitor<'de> for AroundVisitor {
            type Value = Read;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("the name of a source, a point or a place")
            }
            fn visit_str<E>(self, value: &str) -> Result<Read, E> {
                Ok(Read::Word(value.to_owned()))
            }
            fn visit_seq<A: SeqAccess<'de>>(self, mut seq: A) -> Result<Read, A::Error> {
                let mut items = Vec::new();
                while let Some(item) = seq.next_element()? {
                    items.push(item);
                }
                Ok(Read::Point(items))
            }
            fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<Read, A::Error> {
                let place = Place::deserialize(MapAccessDeserializer::new(map))?;
                Ok(Read::Place(Box::new(place)))
            }
        }
        impl<'de> Deserialize<'de> for Read {
            fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
                deserializer.deserialize_any(AroundVisitor)
            }
        }
        let whole = toml::Spanned::<Read>::deserialize(deserializer)?;
        let span = whole.span();
        Ok(match whole.into_inner() {
            Read::Word(text) => Around::Source(Name { text, span }),
            Read::Point(items) => Around::Point(Vector::list(items, span)),
            Read::Place(place) => Around::Place(place, span),
        })
    }
}

impl JsonSchema for Around {
    fn schema_name() -> Cow<'static, str> {
        Cow::Borrowed("Around")
    }
    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        json_schema!({ "anyOf": [
            { "type": "string" },
            generator.subschema_for::<Vector<Length>>(),
            generator.subschema_for::<Place>(),
        ] })
    }
}

/// Criterion of splitting while the model runs.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
#[keys(one_of("stress", "strain_rate", "broken"))]
pub struct During {
    /// Splits where the largest magnitude of a principal stress is above this, Pa.
    pub stress: Option<Quantity<Strength>>,
    /// Splits where the relative velocity across a joint over the distance of the centroids is
    /// above this, 1/s.
    pub strain_rate: Option<Quantity<PositiveRate>>,
    /// Splits where more than this share of the points of a block's joints has failed.
    pub broken: Option<Quantity<Share>>,
    /// How often it is looked at, in steps: for example `"50 steps"`. Default 50 steps.
    pub every: Option<Every>,
}
