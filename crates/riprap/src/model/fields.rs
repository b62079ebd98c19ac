//! Fields that histories and checks ask for.

use super::builder::Builder;
use crate::record::field::{FieldError, Part, Shape, Site, find};
use crate::run::plan::Gauge;
use crate::scenario::diagnostic::suggest;
use crate::scenario::quantity::{Angle, Any};
use crate::scenario::units::{self, Dim};
use crate::scenario::{Diagnostic, Name, Names, Quantity};

/// A field at some blocks.
pub(super) struct FieldUse {
    /// Name with its component.
    pub(super) field: String,
    pub(super) unit: &'static str,
    pub(super) of: Vec<u32>,
    pub(super) along: Option<[f64; 3]>,
    /// Whether it still is two numbers.
    pub(super) is_vector: bool,
}

impl FieldUse {
    /// What is read.
    pub(super) fn gauge(self) -> Gauge {
        Gauge {
            field: self.field,
            of: self.of,
            at: None,
            along: self.along,
        }
    }
}

impl Builder<'_> {
    /// Resolves a field, its blocks and its direction; `None` after an error.
    pub(super) fn field(
        &mut self,
        name: &Name,
        of: Option<&Names>,
        along: Option<&Quantity<Angle>>,
    ) -> Option<FieldUse> {
        let fields = self.fields;
        let (info, part) = match find(fields, name.as_str()) {
            Ok(found) => found,
            Err(error) => {
                let (message, help) = match error {
                    FieldError::Unknown { .. } => {
                        let known: Vec<&str> = fields.iter().map(|f| f.name).collect();
                        let help = suggest(name.as_str(), known).unwrap_or_default();
                        (format!("there is no field `{name}`"), help)
                    }
                    FieldError::NoSuchComponent { field, .. } => (
                        format!("`{field}` lies in the plane"),
                        format!("write `{field}.x`, `.y` or `.magnitude`"),
                    ),
                    FieldError::NoComponents { field, .. } => (
                        format!("`{field}` is a single number"),
                        format!("write `{field}`"),
                    ),
                };
                let help = format!("{help}; `riprap fields` lists all");
                self.error_at("field.unknown", name, message, &help);
                return None;
            }
        };
        let vector = info.shape != Shape::Scalar && part == Part::Whole;
        if let Some(angle) = along.filter(|_| !vector) {
            let error = Diagnostic::error("field.direction", format!("`{name}` has no direction"));
            let help = "`along` is for vector fields without component; leave it out";
            self.found.push(error.at(angle.span.clone()).help(help));
            return None;
        }
        let of = self.field_blocks(name, info.site, of)?;
        let direction =
            |angle: &Quantity<Angle>| [libm::cos(angle.si()), libm::sin(angle.si()), 0.0];
        Some(FieldUse {
            field: name.text.clone(),
            unit: info.unit,
            of,
            along: along.map(direction),
            is_vector: vector && along.is_none(),
        })
    }

    /// The blocks a field is read at.
    fn field_blocks(&mut self, name: &Name, site: Site, of: Option<&Names>) -> Option<Vec<u32>> {
        let names: &[Name] = of.map_or(&[], |names| &names.0);
        let (need, example): (usize, &str) = match site {
            Site::Block => (1, "of = \"block\""),
            Site::Pair => (2, "of = [\"a\", \"b\"]"),
            Site::Group => (1, "of = \"group\""),
            Site::Cavity => (1, "of = \"charge\""),
            Site::Model | Site::Energy => (0, ""),
            Site::Contact => {
                let help = "use a `pair` field for the sum over the contacts of two blocks";
                let message = format!("`{name}` has one value per contact");
                self.error_at("field.site", name, message, help);
                return None;
            }
        };
        let mut lists = Vec::new();
        for one in names {
            match self.directory.blocks(one) {
                Ok(blocks) => lists.push((one, blocks)),
                Err(error) => self.found.push(*error),
            }
        }
        if lists.len() < names.len() {
            return None;
        }
        let group = site == Site::Group;
        if names.len() != need && !(group && names.len() > 1) {
            let message = match need {
                0 => format!("`{name}` belongs to the whole model, not to blocks"),
                1 if group => format!("`{name}` needs a group"),
                1 => format!("`{name}` needs one block"),
                _ => format!("`{name}` needs two blocks"),
            };
            let help = if need == 0 {
                "leave out `of`".to_owned()
            } else {
                format!("write {example}")
            };
            let place = names.first().unwrap_or(name);
            self.error_at("field.of", place, message, &help);
            return None;
        }
        let mut all = Vec::new();
        for (one, blocks) in lists {
            if !group && blocks.len() != 1 {
                let count = blocks.len();
                let message = format!("`{one}` is {count} blocks, and `{name}` needs single ones");
                let first = blocks
                    .first()
                    .map(|&b| self.setup.blocks[b as usize].name.clone());
                let first = first.unwrap_or_default();
                self.error_at(
                    "field.of",
                    one,
                    message,
                    &format!("write for example `{first}`"),
                );
                return None;
            }
            all.extend(blocks);
        }
        if group {
            all.sort_unstable();
            all.dedup();
        } else if all.len() == 2 && all[0] == all[1] {
            let message = "these are the same block".to_owned();
            self.error_at(
                "field.of",
                names.last().unwrap_or(name),
                message,
                "name two blocks",
            );
            return None;
        }
        Some(all)
    }

    /// SI value of a quantity that must suit a unit; `None` after an error.
    pub(super) fn in_unit(
        &mut self,
        quantity: &Quantity<Any>,
        unit: &str,
        of: &str,
    ) -> Option<f64> {
        let wanted = units::dimension(unit).unwrap_or(Dim::NONE);
        let (value, dim) = quantity.read().ok()?;
        let bare = dim.is_none() || dim == Some(Dim::NONE);
        let si = self.parsed.scenario.units.is_some();
        if dim == Some(wanted) || (bare && (si || wanted == Dim::NONE)) {
            return Some(value);
        }
        let raw = &quantity.raw;
        let error = if bare {
            Diagnostic::error("unit.missing", format!("{raw} has no unit"))
        } else {
            let what = dim.unwrap_or(Dim::NONE).describe();
            Diagnostic::error("unit.dimension", format!("\"{raw}\" is {what}"))
        };
        let unit = if unit == "-" {
            "a number without unit".to_owned()
        } else {
            format!("in {unit}")
        };
        self.found.push(
            error
                .at(quantity.span.clone())
                .help(format!("{of} is {unit}")),
        );
        None
    }
}
