//! Fields that histories and checks ask for.

use riprap_geom::{Vec2, polygon};

use super::builder::Builder;
use crate::plan::{Against, Gauge, Pin};
use crate::record::field::{FieldError, Part, Shape, Site, find};
use crate::scenario::diagnostic::suggest;
use crate::scenario::quantity::{Any, Direction, Length, Vector};
use crate::scenario::units::{self, Dim};
use crate::scenario::vectors::InSpace;
use crate::scenario::{Diagnostic, Name, Names, Quantity};

/// A field at some blocks.
pub(super) struct FieldUse {
    /// Name with its component.
    pub(super) field: String,
    pub(super) unit: &'static str,
    pub(super) of: Vec<u32>,
    pub(super) groups: Vec<String>,
    pub(super) at: Option<[f64; 3]>,
    pub(super) along: Option<[f64; 3]>,
    pub(super) against: Option<Against>,
    pub(super) pins: Option<[Pin; 2]>,
    /// Suffixes of what it still is made of; one empty one for a number.
    pub(super) suffixes: &'static [&'static str],
}

/// Where and how a field is read, as the scenario says it.
#[derive(Clone, Copy)]
pub(super) struct Said<'a> {
    pub(super) of: Option<&'a Names>,
    pub(super) point: Option<&'a Vector<Length>>,
    pub(super) pins: Option<&'a [Vector<Length>; 2]>,
    pub(super) along: Option<&'a Direction>,
    pub(super) relative_to: Option<&'a Names>,
}

impl FieldUse {
    /// Whether it is more than one number.
    pub(super) fn is_vector(&self) -> bool {
        self.suffixes.len() > 1
    }

    /// What is read.
    pub(super) fn gauge(self) -> Gauge {
        Gauge {
            field: self.field,
            of: self.of,
            groups: self.groups,
            at: self.at,
            along: self.along,
            against: self.against,
            pins: self.pins,
        }
    }
}

impl Builder<'_> {
    /// Resolves a field, its blocks and its direction; `None` after an error.
    pub(super) fn field(&mut self, name: &Name, said: Said<'_>) -> Option<FieldUse> {
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
                    FieldError::NoComponents { field, .. } => {
                        (format!("`{field}` is a scalar"), format!("write `{field}`"))
                    }
                };
                let help = format!("{help}; `riprap fields` lists all");
                self.error_at("field.unknown", name, message, &help);
                return None;
            }
        };
        let vector = info.shape != Shape::Scalar && part == Part::Whole;
        if let Some(direction) = said.along.filter(|_| !vector) {
            let help = "`along` applies to a vector field named without component; leave it out";
            let message = format!("`{name}` has no direction");
            self.error_at("field.direction", direction.span.clone(), message, help);
            return None;
        }
        let along = match said.along.map(|along| (along.unit(), along)) {
            Some((None, along)) => {
                let help = "at least one component must be non-zero, for example [0, 0, 1]";
                let message = "the direction has zero length";
                self.error_at("value.direction", along.span.clone(), message, help);
                return None;
            }
            Some((unit, _)) => unit,
            None => None,
        };
        let pins = match said.pins {
            Some(pins) => Some(self.pins(name, info.name, pins)?),
            None => None,
        };
        let (of, at) = match said.point {
            Some(point) => self.field_point(name, info.site, point)?,
            None if pins.is_some() => (Vec::new(), None),
            None => (self.field_blocks(name, info.site, said.of)?, None),
        };
        let against = match said.relative_to {
            Some(names) => Some(self.against(name, info.name, names)?),
            None => None,
        };
        let whole = vector && along.is_none();
        let names = said.of.filter(|_| info.site == Site::Group).map_or(&[][..], |of| &of.0);
        let groups = names.iter().filter(|name| self.directory.is_group(name.as_str()));
        Some(FieldUse {
            field: name.text.clone(),
            unit: info.unit,
            of,
            groups: groups.map(|name| name.text.clone()).collect(),
            at,
            along,
            against,
            pins,
            suffixes: if whole { info.shape.suffixes() } else { &[""] },
        })
    }

    /// What a field is relative to; `None` after an error. `base`: the field without component.
    fn against(&mut self, name: &Name, base: &str, names: &Names) -> Option<Against> {
        if Against::counterpart(base).is_none() {
            let message = format!("`{name}` is not read relative to other blocks");
            let help = "`relative_to` applies to `displacement` and `velocity` of a block, a node or a group; leave it out";
            let at = names.0.first().unwrap_or(name);
            self.error_at("field.relative", at, message, help);
            return None;
        }
        let lists = self.blocks_of_each(&names.0)?;
        let mut of: Vec<u32> = lists.into_iter().flat_map(|(_, blocks)| blocks).collect();
        of.sort_unstable();
        of.dedup();
        if of.is_empty() {
            let message = format!("`{name}` is relative to no block");
            self.error_at("field.relative", name, message, "name a block or a group with blocks");
            return None;
        }
        let groups = names.0.iter().filter(|name| self.directory.is_group(name.as_str()));
        Some(Against { of, groups: groups.map(|name| name.text.clone()).collect() })
    }

    /// The block that holds a point: its number in the plane, the point itself in space, where
    /// blocks may be split.
    fn field_point(
        &mut self,
        name: &Name,
        site: Site,
        point: &Vector<Length>,
    ) -> Option<(Vec<u32>, Option<[f64; 3]>)> {
        let error = |code: &'static str, message: &str, help: &str| {
            Diagnostic::error(code, message).at(point.span.clone()).help(help)
        };
        if site != Site::Block {
            let message = format!("`{name}` is not read at a point");
            let help = "`at_point` applies to fields of a block";
            self.found.push(error("field.of", &message, help));
            return None;
        }
        let found = match self.space {
            InSpace::Planar => {
                let at = Vec2::from(point.xy()) - self.origin;
                let mut blocks = (0u32..).zip(&self.setup.blocks);
                let holder = blocks.find(|(_, b)| polygon::contains(&b.vertices, at));
                holder.map(|(block, _)| (vec![block], None))
            }
            InSpace::Spatial => {
                let at = self.local(point.xyz());
                self.holder(at).map(|_| (Vec::new(), Some(at.into())))
            }
        };
        if found.is_none() {
            let message = "no block contains this point at the start";
            let help = "give a point inside a block, in the coordinates of the scene";
            self.found.push(error("field.point", message, help));
        }
        found
    }

    /// The blocks a field is read at.
    fn field_blocks(&mut self, name: &Name, site: Site, of: Option<&Names>) -> Option<Vec<u32>> {
        let names: &[Name] = of.map_or(&[], |names| &names.0);
        if site == Site::Cavity {
            return self.field_source(name, names);
        }
        if site == Site::Bolt {
            return self.field_bolts(name, names);
        }
        if matches!(site, Site::Boundary | Site::Support | Site::Load) {
            return self.field_condition(name, site, names);
        }
        let (need, example): (usize, &str) = match site {
            Site::Block => (1, "of = \"block\""),
            Site::Pair => (2, "of = [\"a\", \"b\"]"),
            Site::Group => (1, "of = \"group\""),
            Site::Cavity | Site::Boundary | Site::Support | Site::Load | Site::Bolt => (1, ""),
            Site::Model | Site::Energy => (0, ""),
            Site::Contact => {
                let help = "use a `pair` field for the sum over the contacts of two blocks";
                let message = format!("`{name}` has one value per contact");
                self.error_at("field.site", name, message, help);
                return None;
            }
        };
        let lists = self.blocks_of_each(names)?;
        let group = site == Site::Group;
        if names.len() != need && !(group && names.len() > 1) {
            let message = match need {
                0 => format!("`{name}` is a field of the whole model, not of blocks"),
                1 if group => format!("`{name}` needs a group"),
                1 => format!("`{name}` needs one block"),
                _ => format!("`{name}` needs two blocks"),
            };
            let help =
                if need == 0 { "leave out `of`".to_owned() } else { format!("write {example}") };
            let place = names.first().unwrap_or(name);
            self.error_at("field.of", place, message, &help);
            return None;
        }
        if group {
            let mut all: Vec<u32> = lists.into_iter().flat_map(|(_, blocks)| blocks).collect();
            all.sort_unstable();
            all.dedup();
            return Some(all);
        }
        self.single_blocks(name, lists)
    }

    /// The blocks of each name; `None` where one is not known.
    fn blocks_of_each<'n>(&mut self, names: &'n [Name]) -> Option<Vec<(&'n Name, Vec<u32>)>> {
        let mut lists = Vec::new();
        for one in names {
            match self.directory.blocks(one) {
                Ok(blocks) => lists.push((one, blocks)),
                Err(error) => self.found.push(*error),
            }
        }
        (lists.len() == names.len()).then_some(lists)
    }

    /// One block for each name; two must differ.
    fn single_blocks(&mut self, field: &Name, lists: Vec<(&Name, Vec<u32>)>) -> Option<Vec<u32>> {
        let mut all: Vec<u32> = Vec::new();
        for (one, blocks) in lists {
            let [block] = blocks[..] else {
                let count = blocks.len();
                let message =
                    format!("`{one}` stands for {count} blocks, but `{field}` needs single blocks");
                let first = blocks.first().map(|&b| self.directory.name(b));
                let help = format!("write for example `{}`", first.unwrap_or_default());
                self.error_at("field.of", one, message, help);
                return None;
            };
            if all.contains(&block) {
                let message = "both names refer to the same block";
                self.error_at("field.of", one, message, "name two different blocks");
                return None;
            }
            all.push(block);
        }
        Some(all)
    }

    /// The source a field is read at.
    fn field_source(&mut self, name: &Name, names: &[Name]) -> Option<Vec<u32>> {
        let [one] = names else {
            let message = format!("`{name}` needs one source");
            let place = names.first().unwrap_or(name);
            self.error_at("field.of", place, message, "write of = \"charge\"");
            return None;
        };
        let sources = &self.directory.sources;
        if let Some(number) = sources.iter().position(|source| *source == one.text) {
            return Some(vec![number as u32]);
        }
        let known = sources.iter().map(String::as_str);
        self.found.push(Diagnostic::unknown("source", one, known));
        None
    }

    /// The bolts a field is read at.
    fn field_bolts(&mut self, name: &Name, names: &[Name]) -> Option<Vec<u32>> {
        if names.is_empty() {
            let message = format!("`{name}` needs a bolt");
            self.error_at("field.of", name, message, "write of = \"bolt\"");
            return None;
        }
        let mut all = Vec::new();
        for one in names {
            let found = self.directory.bolts_of(one.as_str());
            if found.is_empty() {
                let message = format!("there is no bolt `{one}`");
                let mut error = Diagnostic::error("name.unknown", message).at(one.span.clone());
                error.help = suggest(one.as_str(), self.directory.bolts.iter().map(String::as_str));
                self.found.push(error);
                return None;
            }
            all.extend(found);
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
            Diagnostic::error("unit.missing", format!("{raw} needs a unit"))
        } else {
            let what = dim.unwrap_or(Dim::NONE).describe();
            Diagnostic::error("unit.dimension", format!("\"{raw}\" is {what}"))
        };
        let unit =
            if unit == "-" { "a number without unit".to_owned() } else { format!("in {unit}") };
        self.found.push(error.at(quantity.span.clone()).help(format!("{of} is {unit}")));
        None
    }
}
