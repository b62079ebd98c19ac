//! The field vocabulary: every number that can be asked for has one entry.
//!
//! An engine publishes a `&'static [FieldInfo]`; frames, histories, checks, plots, `riprap fields` and the
//! documentation all read that one table. Names are `site.quantity`; a vector takes `.x`, `.y` or `.magnitude`.

use std::borrow::Cow;

use serde::Serialize;

/// Where a field sits.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Site {
    /// One value per block.
    Block,
    /// One value per contact (a region in 2D, a patch in 3D).
    Contact,
    /// One value for a named pair of blocks: the sum over their contacts.
    Pair,
    /// One value for a named group of blocks.
    Group,
    /// One value for the whole model.
    Model,
    /// One value for a charge or another cavity.
    Cavity,
    /// One value for a condition on free faces, in the plane for a side of the model.
    Boundary,
    /// One value for a support.
    Support,
    /// One value for a load.
    Load,
    /// One value for a bolt, or for several.
    Bolt,
    /// One term of the energy ledger.
    Energy,
}

impl Site {
    /// The word in front of the dot in a field name.
    pub fn word(self) -> &'static str {
        match self {
            Site::Block => "block",
            Site::Contact => "contact",
            Site::Pair => "pair",
            Site::Group => "group",
            Site::Model => "model",
            Site::Cavity => "cavity",
            Site::Boundary => "boundary",
            Site::Support => "support",
            Site::Load => "load",
            Site::Bolt => "bolt",
            Site::Energy => "energy",
        }
    }
}

/// Number or vector.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Shape {
    /// One number.
    Scalar,
    /// Two numbers, x and y, in global axes.
    Vector,
    /// Three numbers, x, y and z, in global axes.
    Vector3,
}

impl Shape {
    /// Number of components.
    pub fn components(self) -> usize {
        match self {
            Shape::Scalar => 1,
            Shape::Vector => 2,
            Shape::Vector3 => 3,
        }
    }

    /// Suffixes of the components of a vector; one empty one for a scalar.
    pub fn suffixes(self) -> &'static [&'static str] {
        match self {
            Shape::Scalar => &[""],
            Shape::Vector => &[".x", ".y"],
            Shape::Vector3 => &[".x", ".y", ".z"],
        }
    }

    /// Whether a value of this shape has that part.
    pub fn has(self, part: Part) -> bool {
        match (self, part) {
            (Shape::Scalar, p) => p == Part::Whole,
            (Shape::Vector, p) => p != Part::Z,
            (Shape::Vector3, _) => true,
        }
    }
}

/// One entry of a field table.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub struct FieldInfo {
    /// `site.quantity`, for example `block.displacement`.
    pub name: &'static str,
    /// Unit as printed, `-` for none.
    pub unit: &'static str,
    /// Where it sits.
    pub site: Site,
    /// Number or vector.
    pub shape: Shape,
    /// One sentence for the user.
    pub meaning: &'static str,
}

/// How an engine reads a field. `G` is the function that does: from a view of the model and the numbers of the blocks, or of what else the
/// field is asked of ([`first`], [`pair`]), to its one, two or three numbers.
pub struct Reader<G> {
    /// The function.
    pub get: G,
    /// Whether reading it costs as much as a step (exact energies, sums over all contacts).
    pub costly: bool,
}

/// Makes the table of an engine from the type of its getters and rows of name, unit, site, shape, whether reading is costly, meaning and getter:
/// `INFOS` and, in the same order, `READERS`.
#[macro_export]
macro_rules! fields {
    ($getter:ty; $($name:literal $unit:literal $site:ident $shape:ident $costly:literal $meaning:literal $get:expr;)*) => {
        /// Names, units and meanings, in the order of the documentation.
        pub const INFOS: &[$crate::field::FieldInfo] = &[$($crate::field::FieldInfo {
            name: $name,
            unit: $unit,
            site: $crate::field::Site::$site,
            shape: $crate::field::Shape::$shape,
            meaning: $meaning,
        }),*];
        const READERS: &[$crate::field::Reader<$getter>] = &[$($crate::field::Reader {
            get: $get,
            costly: $costly,
        }),*];
    };
}

/// The block, or what else one thing of its kind, that a field is asked of.
#[must_use]
pub fn first(of: &[u32]) -> usize {
    of.first().map_or(0, |&b| b as usize)
}

/// The two blocks that a field is asked of.
#[must_use]
pub fn pair(of: &[u32]) -> (u32, u32) {
    (of.first().copied().unwrap_or(0), of.get(1).copied().unwrap_or(0))
}

/// The blocks that a field of groups is read of, ascending: those that were there when the reading was made, and those that have
/// joined its groups since. Their numbers are larger than all before.
#[must_use]
pub fn joined<'a>(of: &'a [u32], groups: impl Iterator<Item = &'a [u32]>) -> Cow<'a, [u32]> {
    let last = of.last().copied();
    let late = |all: &'a [u32]| &all[last.map_or(0, |last| all.partition_point(|b| *b <= last))..];
    let mut more: Vec<u32> = groups.flat_map(late).copied().collect();
    if more.is_empty() {
        return Cow::Borrowed(of);
    }
    more.sort_unstable();
    more.dedup();
    Cow::Owned([of, &more].concat())
}

/// The part of a field that a name asks for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Part {
    /// The field as it is.
    Whole,
    /// First component of a vector.
    X,
    /// Second component of a vector.
    Y,
    /// Third component of a vector.
    Z,
    /// Length of a vector.
    Magnitude,
}

impl Part {
    /// The suffix with its dot, empty for the whole field.
    pub fn suffix(self) -> &'static str {
        match self {
            Part::Whole => "",
            Part::X => ".x",
            Part::Y => ".y",
            Part::Z => ".z",
            Part::Magnitude => ".magnitude",
        }
    }

    /// One number out of a vector of two or three; `None` for [`Part::Whole`], which is no number.
    pub fn of(self, v: &[f64]) -> Option<f64> {
        let part = |k: usize| Some(v.get(k).copied().unwrap_or(0.0));
        match self {
            Part::Whole => None,
            Part::X => part(0),
            Part::Y => part(1),
            Part::Z => part(2),
            Part::Magnitude => Some(match *v {
                [x, y] => (x * x + y * y).sqrt(),
                _ => v.iter().map(|x| x * x).sum::<f64>().sqrt(),
            }),
        }
    }

    /// The number that a reading of a field gives: `values` are those of the field, one of a scalar. A vector without part gives its component
    /// in the direction `along`, or its length.
    #[must_use]
    pub fn read<const N: usize>(
        self,
        shape: Shape,
        values: [f64; N],
        along: Option<[f64; N]>,
    ) -> f64 {
        match (shape, self, along) {
            (Shape::Scalar, ..) => values.first().copied().unwrap_or(f64::NAN),
            (_, Part::Whole, Some(along)) => {
                let terms = values.iter().zip(along).map(|(v, c)| v * c);
                terms.reduce(|sum, term| sum + term).unwrap_or(f64::NAN)
            }
            (_, Part::Whole, None) => Part::Magnitude.of(&values).unwrap_or(f64::NAN),
            (_, part, _) => part.of(&values).unwrap_or(f64::NAN),
        }
    }

    /// Splits `block.velocity.x` into `block.velocity` and [`Part::X`].
    pub fn split(name: &str) -> (&str, Part) {
        for part in [Part::X, Part::Y, Part::Z, Part::Magnitude] {
            if let Some(stem) = name.strip_suffix(part.suffix()) {
                return (stem, part);
            }
        }
        (name, Part::Whole)
    }
}

/// A name that no entry of the table answers to.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum FieldError {
    /// No such field.
    #[error("there is no field `{name}`{}; fields are: {}", did_you_mean(suggestion.as_deref()), known.join(", "))]
    Unknown {
        /// What was asked for.
        name: String,
        /// The nearest name there is, if any is near.
        suggestion: Option<String>,
        /// All names.
        known: Vec<String>,
    },
    /// `.x` and so on asked of a number.
    #[error("`{name}` names a component, but `{field}` is a scalar; write `{field}`")]
    NoComponents {
        /// What was asked for.
        name: String,
        /// The field without the suffix.
        field: String,
    },
    /// `.z` asked of a vector in the plane.
    #[error(
        "`{name}` names a third component, but `{field}` is a vector in the plane; write `{field}.x`, `.y` or `.magnitude`"
    )]
    NoSuchComponent {
        /// What was asked for.
        name: String,
        /// The field without the suffix.
        field: String,
    },
}

fn did_you_mean(suggestion: Option<&str>) -> String {
    suggestion.map_or_else(String::new, |s| format!(" (did you mean `{s}`?)"))
}

/// Finds a field and the part of it that `name` asks for.
///
/// # Errors
/// Unknown names, with the nearest known one, and components of scalars.
pub fn find<'a>(table: &'a [FieldInfo], name: &str) -> Result<(&'a FieldInfo, Part), FieldError> {
    place(table, name).map(|(k, part)| (&table[k], part))
}

/// As [`find`], with the place of the field in the table.
///
/// # Errors
/// The same.
pub fn place(table: &[FieldInfo], name: &str) -> Result<(usize, Part), FieldError> {
    let of = |name: &str| table.iter().position(|f| f.name == name);
    if let Some(k) = of(name) {
        return Ok((k, Part::Whole));
    }
    let (stem, part) = Part::split(name);
    match of(stem) {
        Some(k) if table[k].shape.has(part) => Ok((k, part)),
        Some(k) if table[k].shape != Shape::Scalar => {
            Err(FieldError::NoSuchComponent { name: name.to_owned(), field: stem.to_owned() })
        }
        Some(_) => Err(FieldError::NoComponents { name: name.to_owned(), field: stem.to_owned() }),
        None => {
            let known: Vec<String> = table.iter().map(|f| f.name.to_owned()).collect();
            let suggestion = nearest(stem, known.iter().map(String::as_str)).map(str::to_owned);
            Err(FieldError::Unknown { name: name.to_owned(), suggestion, known })
        }
    }
}

/// The candidate most like `name`, if any is like it at all; the first one wins a tie.
pub fn nearest<'a>(name: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let wanted = name.to_lowercase();
    let mut best: Option<(f64, &str)> = None;
    for candidate in candidates {
        let lower = candidate.to_lowercase();
        // `velocity` for `block.velocity` is the commonest slip and far in edit distance.
        let tail = lower.rsplit('.').next().unwrap_or(&lower);
        let score = strsim::jaro_winkler(&wanted, &lower)
            .max(strsim::normalized_damerau_levenshtein(&wanted, &lower))
            .max(if tail == wanted { 0.99 } else { 0.0 });
        if score > best.map_or(0.0, |b| b.0) {
            best = Some((score, candidate));
        }
    }
    best.filter(|b| b.0 >= 0.75).map(|b| b.1)
}

/// Written in a column head: `slip [m]`, or `ratio` when the unit is `-` or empty.
pub fn with_unit(name: &str, unit: &str) -> String {
    if unit.is_empty() || unit == "-" { name.to_owned() } else { format!("{name} [{unit}]") }
}

/// Takes a column head apart: `slip [m]` gives `("slip", "m")`, `step` gives `("step", "-")`.
pub fn split_unit(head: &str) -> (&str, &str) {
    match head.rsplit_once(" [") {
        Some((name, rest)) => match rest.strip_suffix(']') {
            Some(unit) => (name, unit),
            None => (head, "-"),
        },
        None => (head, "-"),
    }
}

/// The shortest text that reads back as the same number.
#[must_use]
pub fn number(v: f64) -> String {
    let size = v.abs();
    if v == 0.0 || !v.is_finite() || (1e-4..1e15).contains(&size) {
        format!("{v}")
    } else {
        format!("{v:e}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TABLE: &[FieldInfo] = &[
        FieldInfo {
            name: "block.velocity",
            unit: "m/s",
            site: Site::Block,
            shape: Shape::Vector,
            meaning: "velocity of the centroid",
        },
        FieldInfo {
            name: "block.rotation",
            unit: "rad",
            site: Site::Block,
            shape: Shape::Scalar,
            meaning: "rotation since the start",
        },
    ];

    #[test]
    fn components_are_found() {
        assert_eq!(find(TABLE, "block.velocity").unwrap().1, Part::Whole);
        assert_eq!(find(TABLE, "block.velocity.y").unwrap().1, Part::Y);
        assert_eq!(find(TABLE, "block.velocity.magnitude").unwrap().1, Part::Magnitude);
        assert_eq!(Part::Magnitude.of(&[3.0, -4.0]), Some(5.0));
        assert_eq!(Part::Whole.of(&[3.0, -4.0]), None);
    }

    #[test]
    fn readings_are_one_number() {
        let plane = |part: Part, along| part.read(Shape::Vector, [3.0, -4.0], along);
        assert_eq!(plane(Part::Whole, None), 5.0);
        assert_eq!(plane(Part::Magnitude, None), 5.0);
        assert_eq!(plane(Part::Y, None), -4.0);
        assert_eq!(plane(Part::Whole, Some([0.0, -1.0])), 4.0);
        let space = [2.0, 3.0, -6.0];
        assert_eq!(Part::Whole.read(Shape::Vector3, space, None), 7.0);
        assert_eq!(Part::Whole.read(Shape::Scalar, space, None), 2.0);
        assert_eq!((first(&[]), first(&[4, 5])), (0, 4));
        assert_eq!((pair(&[4]), pair(&[4, 5])), ((4, 0), (4, 5)));
    }

    #[test]
    fn wrong_names_are_explained() {
        let message = find(TABLE, "block.velocty.x").unwrap_err().to_string();
        assert!(message.contains("did you mean `block.velocity`"), "{message}");
        assert!(message.contains("block.rotation"), "{message}");
        let message = find(TABLE, "block.rotation.x").unwrap_err().to_string();
        assert!(message.contains("write `block.rotation`"), "{message}");
        assert_eq!(nearest("rotation", TABLE.iter().map(|f| f.name)), Some("block.rotation"));
        assert_eq!(nearest("qqqq", TABLE.iter().map(|f| f.name)), None);
    }

    #[test]
    fn heads_round_trip() {
        for (name, unit) in [("slip", "m"), ("a [b]", "m/s2"), ("ratio", "-")] {
            assert_eq!(split_unit(&with_unit(name, unit)), (name, unit));
        }
    }
}
