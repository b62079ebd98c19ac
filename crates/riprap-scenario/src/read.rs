//! Values of a table in SI, with where each came from.
//!
//! `#[derive(Keys)]` makes the methods of [`Read`] from the keys of a table: what is read is written down once, at the
//! place where it is used, and a default stands once, at the key.

use std::fmt::Debug;

use riprap_keys::Words;
use schemars::Schema;
use serde::Serialize;
use serde_json::{Map, Value, json};

use crate::language::Period;
use crate::quantity::{Kind, Quantity};
use crate::rule::Rule;
use crate::units::Dim;
use crate::vectors::{Components, Form, InSpace};

/// Where a value came from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Provenance {
    /// The scenario says so.
    Given,
    /// Nobody said anything.
    Default,
    /// Computed from other values.
    Derived,
}

impl Provenance {
    /// Given or default.
    #[must_use]
    pub fn given(there: bool) -> Self {
        if there { Self::Given } else { Self::Default }
    }
}

/// One resolved key.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Explained {
    /// Key as in the scenario, `interfaces.default.normal_stiffness`; blocks, phases and checks by
    /// name.
    pub key: String,
    /// Value with its unit; as written if it was given.
    pub value: String,
    /// Where it came from.
    pub from: Provenance,
    /// How it was derived, or what the default means; may be empty.
    pub why: String,
}

/// A number with its unit, short.
#[must_use]
pub fn with_unit(value: f64, unit: &str) -> String {
    let size = value.abs();
    let number = if value != 0.0 && !(1e-3..1e6).contains(&size) {
        format!("{value:.6e}")
    } else {
        // At most six digits after the point, without trailing zeros.
        let text = format!("{value:.6}");
        text.trim_end_matches('0').trim_end_matches('.').to_owned()
    };
    if unit.is_empty() || unit == "-" { number } else { format!("{number} {unit}") }
}

/// A value in the unit of its kind; angles in degrees.
fn in_unit<K: Kind>(value: f64) -> String {
    let dim = K::DIM.unwrap_or(Dim::NONE);
    if dim == Dim::ANGLE {
        return with_unit(value.to_degrees(), "deg");
    }
    with_unit(value, &dim.unit())
}

/// A table being read.
#[derive(Debug)]
pub struct Read<'a, T> {
    said: &'a T,
    space: InSpace,
    path: String,
    explained: &'a mut Vec<Explained>,
}

impl<'a, T> Read<'a, T> {
    /// The table `said` at `path`; what is read from it is added to `explained`.
    pub fn new(
        said: &'a T,
        space: InSpace,
        path: impl Into<String>,
        explained: &'a mut Vec<Explained>,
    ) -> Self {
        let path = path.into();
        Read { said, space, path, explained }
    }

    /// A table within this one.
    pub fn within<'b, U>(&'b mut self, word: &str, said: &'b U) -> Read<'b, U> {
        Read::new(said, self.space, format!("{}.{word}", self.path), self.explained)
    }

    /// What the file says.
    #[must_use]
    pub fn said(&self) -> &'a T {
        self.said
    }

    /// The space of the scene.
    #[must_use]
    pub fn space(&self) -> InSpace {
        self.space
    }

    /// Writes down a value of this table.
    pub fn note(&mut self, word: &str, value: impl Into<String>, from: Provenance, why: &str) {
        let key =
            if self.path.is_empty() { word.to_owned() } else { format!("{}.{word}", self.path) };
        self.explained.push(Explained { key, value: value.into(), from, why: why.to_owned() });
    }

    /// Says how the value that was written down last was derived, or what it means.
    pub fn because(&mut self, why: &str) {
        if let Some(last) = self.explained.last_mut() {
            why.clone_into(&mut last.why);
        }
    }

    pub(crate) fn required<K: Kind>(&mut self, word: &str, given: &Quantity<K>) -> f64 {
        self.note(word, given.raw.to_string(), Provenance::Given, "");
        given.si()
    }

    pub(crate) fn given<K: Kind>(
        &mut self,
        word: &str,
        given: Option<&Quantity<K>>,
    ) -> Option<f64> {
        given.map(|given| self.required(word, given))
    }

    pub(crate) fn quantity<K: Kind>(
        &mut self,
        word: &str,
        given: Option<&Quantity<K>>,
        default: &str,
    ) -> f64 {
        self.given(word, given).unwrap_or_else(|| {
            self.note(word, default, Provenance::Default, "");
            Quantity::<K>::from_text(default).si()
        })
    }

    /// SI value of a key, or a value that comes from elsewhere; written down.
    pub fn or<K: Kind>(
        &mut self,
        word: &str,
        given: Option<&Quantity<K>>,
        value: f64,
        from: Provenance,
        why: &str,
    ) -> f64 {
        self.given(word, given).unwrap_or_else(|| {
            self.note(word, in_unit::<K>(value), from, why);
            value
        })
    }

    pub(crate) fn word<W: Words + Default>(&mut self, word: &str, given: Option<W>) -> W {
        let value = given.unwrap_or_default();
        self.note(word, value.word(), Provenance::given(given.is_some()), "");
        value
    }

    /// Truth values, whole numbers, and lists of them: their debug form is how the file says them.
    pub(crate) fn plain<V: Debug + Copy>(&mut self, word: &str, given: Option<V>, default: V) -> V {
        self.plain_or(word, given, default, Provenance::Default, "")
    }

    pub(crate) fn plain_or<V: Debug + Copy>(
        &mut self,
        word: &str,
        given: Option<V>,
        value: V,
        from: Provenance,
        why: &str,
    ) -> V {
        let (value, from, why) = given.map_or((value, from, why), |v| (v, Provenance::Given, ""));
        self.note(word, format!("{value:?}"), from, why);
        value
    }

    pub(crate) fn told(&mut self, word: &str, said: &impl Told) {
        self.note(word, said.told(), Provenance::Given, "");
    }
}

/// A value that is written down as it stands in the file.
pub trait Told {
    /// As it stands.
    fn told(&self) -> String;
}

impl<K: Kind> Told for Quantity<K> {
    fn told(&self) -> String {
        self.raw.to_string()
    }
}

impl Told for Period {
    fn told(&self) -> String {
        self.raw.to_string()
    }
}

impl<K: Kind, F: Form> Told for Components<K, F> {
    fn told(&self) -> String {
        self.raw()
    }
}

impl<T: Told, const N: usize> Told for [T; N] {
    fn told(&self) -> String {
        let parts = self.each_ref().map(Told::told);
        format!("[{}]", parts.join(", "))
    }
}

/// The value of a key that may be there.
pub trait Given {
    /// SI value, or the one that holds without the key.
    #[must_use]
    fn si_or(&self, old: f64) -> f64;
}

impl<K: Kind> Given for Option<Quantity<K>> {
    fn si_or(&self, old: f64) -> f64 {
        self.as_ref().map_or(old, Quantity::si)
    }
}

/// One key of a [`TableSchema`].
pub(crate) struct KeySchema {
    pub word: &'static str,
    pub schema: Schema,
    pub meaning: &'static str,
    /// The sentence about the default, or nothing.
    pub default: String,
    /// The defaults of a quantity as the file would say them, one or one for each space.
    pub texts: &'static [&'static str],
    /// The only space that has it.
    pub space: Option<&'static str>,
    /// What to do in the other space.
    pub instead: Option<&'static str>,
    pub required: bool,
    /// Lowest and highest whole number.
    pub range: [Option<u64>; 2],
}

/// JSON schema of a table with fixed keys.
pub(crate) struct TableSchema {
    head: Map<String, Value>,
    keys: Map<String, Value>,
    required: Vec<&'static str>,
}

impl TableSchema {
    pub(crate) fn new(meaning: &str, change_of: Option<&str>) -> Self {
        let mut head = Map::new();
        head.insert("description".to_owned(), json!(meaning));
        head.insert("type".to_owned(), json!("object"));
        head.insert("additionalProperties".to_owned(), json!(false));
        if let Some(of) = change_of {
            head.insert("x-change-of".to_owned(), json!(of));
        }
        TableSchema { head, keys: Map::new(), required: Vec::new() }
    }

    pub(crate) fn key(&mut self, key: KeySchema) {
        let mut schema = key.schema.to_value();
        if let Some(object) = schema.as_object_mut() {
            let text = format!("{}{}", key.meaning, key.default);
            object.insert("description".to_owned(), json!(text));
            if !key.texts.is_empty() {
                object.insert("x-default".to_owned(), json!(key.texts));
            }
            if let Some(space) = key.space {
                object.insert("x-space".to_owned(), json!(space));
            }
            if let Some(instead) = key.instead {
                object.insert("x-instead".to_owned(), json!(instead));
            }
            for (word, end) in ["minimum", "maximum"].into_iter().zip(key.range) {
                if let Some(end) = end {
                    object.insert(word.to_owned(), json!(end));
                }
            }
        }
        self.keys.insert(key.word.to_owned(), schema);
        if key.required {
            self.required.push(key.word);
        }
    }

    pub(crate) fn finish(mut self, rules: Vec<Rule>) -> Schema {
        // A key that is required under a condition has no need of "only with" the same.
        let said = |rule: &&Rule| {
            let same = |one: &Rule| one.keys == rule.keys && one.when == rule.when;
            rule.kind == "required" || !rules.iter().any(|one| one.kind == "required" && same(one))
        };
        for rule in rules.iter().filter(said) {
            rule.describe(&mut self.head, &mut self.keys);
        }
        if !rules.is_empty() {
            let rules: Vec<Value> = rules.iter().map(Rule::to_json).collect();
            self.head.insert("x-rules".to_owned(), json!(rules));
        }
        self.head.insert("properties".to_owned(), Value::Object(self.keys));
        if !self.required.is_empty() {
            self.head.insert("required".to_owned(), json!(self.required));
        }
        Schema::from(self.head)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::language::{Damping, Interface, InterfaceChange};
    use crate::quantity::{KindInfo, Raw};
    use crate::schema::schema;
    use crate::values::check_quantity;

    fn of_kind(schema: &Value) -> Option<&'static KindInfo> {
        let text = schema.to_string();
        let name = text.split("#/$defs/").nth(1)?.split('"').next()?;
        KindInfo::named(name)
    }

    /// (defaults checked, wrong ones).
    fn look(schema: &Value, found: &mut (usize, Vec<String>)) {
        if let (Some(defaults), Some(kind)) =
            (schema.get("x-default").and_then(Value::as_array), of_kind(schema))
        {
            for text in defaults.iter().filter_map(Value::as_str) {
                found.0 += 1;
                let raw = Raw::Text(text.to_owned());
                if let Some(wrong) = check_quantity(&raw, 0..0, kind, "default", false) {
                    found.1.push(format!("{text}: {}", wrong.message));
                }
            }
        }
        match schema {
            Value::Object(object) => object.values().for_each(|value| look(value, found)),
            Value::Array(items) => items.iter().for_each(|value| look(value, found)),
            Value::Null | Value::Bool(_) | Value::Number(_) | Value::String(_) => {}
        }
    }

    #[test]
    fn every_default_is_a_value_that_its_key_takes() {
        let mut found = (0, Vec::new());
        look(schema(), &mut found);
        assert!(found.0 > 15, "{} defaults", found.0);
        assert!(found.1.is_empty(), "{:?}", found.1);
    }

    #[test]
    fn what_is_read_is_written_down_with_its_source() {
        let said: Interface = toml::from_str("cohesion = \"2 kPa\"\npoints = \"quarter\"").unwrap();
        for (space, damping) in [(InSpace::Planar, 0.2), (InSpace::Spatial, 0.1)] {
            let mut notes = Vec::new();
            let mut read = Read::new(&said, space, "interfaces.x", &mut notes);
            assert_eq!(read.cohesion(), 2000.0);
            assert_eq!(read.tension(), 0.0);
            assert_eq!(read.points().word(), "quarter");
            assert_eq!(read.failure().word(), "point");
            assert_eq!(read.damping_ratio(), damping);
            assert_eq!(read.normal_stiffness(), None);
            let why = "half the normal stiffness";
            let half = read.shear_stiffness_or(5e8, Provenance::Derived, why);
            assert_eq!(half, 5e8);
            let lines: Vec<String> = notes
                .iter()
                .map(|n| format!("{} = {} {:?} {}", n.key, n.value, n.from, n.why))
                .collect();
            assert_eq!(
                lines,
                [
                    "interfaces.x.cohesion = 2 kPa Given ".to_owned(),
                    "interfaces.x.tension = 0 Pa Default ".to_owned(),
                    "interfaces.x.points = quarter Given ".to_owned(),
                    "interfaces.x.failure = point Default ".to_owned(),
                    format!("interfaces.x.damping_ratio = {damping} Default "),
                    format!("interfaces.x.shear_stiffness = 5.000000e8 Pa/m Derived {why}"),
                ]
            );
        }
    }

    #[test]
    fn angles_are_shown_in_degrees() {
        let said: Interface = toml::from_str("").unwrap();
        let mut notes = Vec::new();
        let mut read = Read::new(&said, InSpace::Spatial, "i", &mut notes);
        read.residual_friction_angle_or(30f64.to_radians(), Provenance::Default, "");
        assert_eq!(notes[0].value, "30 deg");
    }

    /// What phases may change is a part of what the interface has, with the same types and without defaults.
    #[test]
    fn changes_are_some_keys_of_the_table() {
        let change: InterfaceChange =
            toml::from_str("cohesion = \"1 kPa\"\nfriction_law = \"clipped\"").unwrap();
        assert_eq!(change.cohesion.si_or(0.0), 1000.0);
        assert_eq!(change.tension.si_or(7.0), 7.0);
        assert_eq!(change.friction_law.map(Words::word), Some("clipped"));
        assert!(toml::from_str::<InterfaceChange>("elastic = true").is_err());
        let schema = schema();
        let of = |name: &str, key: &str| schema["$defs"][name]["properties"][key].clone();
        let keys = schema["$defs"]["InterfaceChange"]["properties"].as_object().unwrap();
        for key in keys.keys() {
            assert_eq!(of("InterfaceChange", key)["anyOf"], of("Interface", key)["anyOf"], "{key}");
            assert!(of("InterfaceChange", key).get("x-default").is_none(), "{key}");
        }
        let text = of("Interface", "cohesion")["description"].clone();
        assert_eq!(text, "Cohesion, Pa. Default 0 Pa.");
        let text = of("InterfaceChange", "cohesion")["description"].clone();
        assert_eq!(text, "Cohesion, Pa.");
    }

    #[test]
    fn tables_without_keys_have_their_defaults() {
        let none = Damping::default();
        let mut notes = Vec::new();
        let mut read = Read::new(&none, InSpace::Spatial, "phases.p.damping", &mut notes);
        let all = [read.mass(), read.stiffness(), read.local()];
        assert_eq!((all, read.rotation()), ([0.0; 3], None));
    }
}
