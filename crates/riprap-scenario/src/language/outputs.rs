//! What is written to the run folder, and how often.

use riprap_core::rhythm;
use riprap_keys::Keys;
use schemars::JsonSchema;
use serde::Deserialize;

use crate::moments::{read_interval, read_period};
use crate::quantity::{Direction, Length, Name, Names, Raw, Span, Vector, When};

/// Something that is written to the run folder.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Output {
    /// A column of `histories.csv`.
    History(Box<History>),
    /// Pictures of the whole model for ParaView.
    Frames(Pictures),
    /// States from which a run can be resumed; there is always one at the end of a phase.
    Checkpoints(Schedule),
}

/// A column of `histories.csv`.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
#[keys(at_most_one("of", "at_point", "pins"))]
pub struct History {
    /// Name of the column, once in the file.
    pub name: Name,
    /// Field, for example `block.displacement`; `riprap fields` lists them.
    pub field: Name,
    /// Block, two blocks of a pair, group or source; not for fields of the whole model.
    pub of: Option<Names>,
    /// Instead of a block: the point, m, that lies in it at the start.
    pub at_point: Option<Vector<Length>>,
    /// Two points of the rock, m, in place of two blocks: for `pair.convergence`, `displacement`, `velocity`.
    pub pins: Option<[Vector<Length>; 2]>,
    /// Blocks and groups whose mean displacement or velocity is taken off: for `displacement` and `velocity` of blocks,
    /// groups and nodes.
    pub relative_to: Option<Names>,
    /// Direction in which a vector is measured: in the plane an angle from the x axis, in space a
    /// vector such as `[0, 0, 1]`.
    pub along: Option<Direction>,
    /// How often, for example `"1 ms"` or `"10 steps"`.
    pub every: Every,
}

/// How often.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
pub struct Schedule {
    /// How often, for example `"50 ms"`, `"10 steps"` or `"1 phase"`.
    pub every: Every,
}

/// Pictures.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
pub struct Pictures {
    /// How often besides the first and the last state of each phase; `"never"` writes none.
    pub every: Every,
    /// Fields of the blocks that are written; the number and the material of each block always are. Default: all. Pictures and plots draw
    /// only what is written.
    pub fields: Option<Names>,
    /// Whether contacts and joints are written, with forces and states. Default true.
    pub contacts: Option<bool>,
    /// Whether the tetrahedra of deformable blocks are written too, with their stresses and strains. Default false.
    #[serde(default)]
    #[key(space = "spatial")]
    pub tetrahedra: bool,
}

/// An interval: model time (`"1 ms"`), steps (`"10 steps"`), `"1 phase"` or `"never"`.
#[derive(Debug, Clone, PartialEq)]
pub struct Every {
    /// What was written.
    pub raw: Raw,
    /// Where.
    pub span: Span,
}

impl Every {
    /// The interval; `Never` where a check reports an error.
    pub fn read(&self) -> rhythm::Every {
        read_interval(&self.raw).unwrap_or(rhythm::Every::Never)
    }
}

/// A moment: model time (`"1.5 s"`), `"start"` or `"end"`.
#[derive(Debug, Clone, PartialEq)]
pub struct Moment {
    /// What was written.
    pub raw: Raw,
    /// Where.
    pub span: Span,
}

impl Moment {
    /// The moment; `End` where a check reports an error.
    pub fn read(&self) -> When {
        When::read(&self.raw, true).unwrap_or(When::End)
    }
}

/// A period along one axis: a length, or `"none"`.
#[derive(Debug, Clone, PartialEq)]
pub struct Period {
    /// What was written.
    pub raw: Raw,
    /// Where.
    pub span: Span,
}

impl Period {
    /// The period, m; `None` for none and where a check reports an error.
    pub fn read(&self) -> Option<f64> {
        read_period(&self.raw, true).ok().flatten()
    }
}

macro_rules! raw_with_place {
    ($name:ident, $description:literal) => {
        impl<'de> Deserialize<'de> for $name {
            fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
                let raw = toml::Spanned::<Raw>::deserialize(deserializer)?;
                let span = raw.span();
                Ok($name { raw: raw.into_inner(), span })
            }
        }
        impl JsonSchema for $name {
            fn schema_name() -> std::borrow::Cow<'static, str> {
                stringify!($name).into()
            }
            fn json_schema(_: &mut schemars::SchemaGenerator) -> schemars::Schema {
                schemars::json_schema!({ "type": ["string", "number"], "description": $description })
            }
        }
    };
}

raw_with_place!(
    Every,
    "A time (\"1 ms\"), a number of steps (\"10 steps\"), \"1 phase\" or \"never\"."
);
raw_with_place!(Period, "A length (\"32 m\") or \"none\".");
raw_with_place!(Moment, "A time (\"1.5 s\"), \"start\" or \"end\".");
