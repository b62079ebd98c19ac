//! Values with components: how many there are depends on the space of the scene.
//!
//! One Rust type for all forms; the form says what each space accepts. The walk over the text in
//! `super::validate` compares, so that the error stands at the value and names the space.

use std::borrow::Cow;
use std::fmt;
use std::marker::PhantomData;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::{Deserialize, Deserializer, SeqAccess, Visitor};

use super::quantity::{Angle, Kind, Plain, Quantity, Raw, Span};

/// The space of a scene, as far as it decides about values.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum InSpace {
    /// `[space.planar]`
    Planar,
    /// `[space.spatial]`
    Spatial,
}

impl InSpace {
    /// As the word stands in the file.
    pub fn word(self) -> &'static str {
        match self {
            InSpace::Planar => "planar",
            InSpace::Spatial => "spatial",
        }
    }

    /// The space of that word.
    pub fn named(word: &str) -> Option<Self> {
        match word {
            "planar" => Some(InSpace::Planar),
            "spatial" => Some(InSpace::Spatial),
            _ => None,
        }
    }
}

/// What one space accepts for a form.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Accepts {
    /// Whether a single value will do.
    pub single: bool,
    /// Number of components of a list; 0 where a list will not do.
    pub list: usize,
}

/// How a value with components is written in each space.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct FormInfo {
    /// First part of the names of schema types.
    pub name: &'static str,
    /// In the plane.
    pub planar: Accepts,
    /// In space.
    pub spatial: Accepts,
}

impl FormInfo {
    /// Form and kind of value of a schema type such as `Vector_Length`.
    pub fn of_type(type_name: &str) -> Option<(&'static FormInfo, &str)> {
        let (form, kind) = type_name.split_once('_')?;
        let info = FORMS.iter().find(|info| info.name == form)?;
        Some((info, kind))
    }

    /// What a space accepts.
    pub fn accepts(&self, space: InSpace) -> Accepts {
        match space {
            InSpace::Planar => self.planar,
            InSpace::Spatial => self.spatial,
        }
    }
}

const fn single() -> Accepts {
    Accepts { single: true, list: 0 }
}

const fn list(list: usize) -> Accepts {
    Accepts { single: false, list }
}

/// All forms.
pub const FORMS: &[FormInfo] = &[
    FormInfo { name: "Vector", planar: list(2), spatial: list(3) },
    FormInfo { name: "Axial", planar: single(), spatial: list(3) },
    FormInfo { name: "Down", planar: list(2), spatial: Accepts { single: true, list: 3 } },
    FormInfo { name: "Tensor", planar: list(3), spatial: list(6) },
    FormInfo { name: "Moments", planar: single(), spatial: list(6) },
    FormInfo { name: "Direction", planar: single(), spatial: list(3) },
];

/// A form as a type.
pub trait Form: fmt::Debug + Clone + PartialEq + 'static {
    /// [`FormInfo::name`]
    const NAME: &'static str;
}

/// Form of [`Vector`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum VectorForm {}
impl Form for VectorForm {
    const NAME: &'static str = "Vector";
}
/// Form of [`Axial`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum AxialForm {}
impl Form for AxialForm {
    const NAME: &'static str = "Axial";
}
/// Form of [`Down`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum DownForm {}
impl Form for DownForm {
    const NAME: &'static str = "Down";
}

/// Form of [`Tensor`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum TensorForm {}
impl Form for TensorForm {
    const NAME: &'static str = "Tensor";
}

/// Form of [`Moments`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum MomentsForm {}
impl Form for MomentsForm {
    const NAME: &'static str = "Moments";
}

/// Moments of inertia: one value in the plane, [xx, yy, zz, yz, zx, xy] in space.
pub type Moments<K> = Components<K, MomentsForm>;
/// A symmetric tensor: [xx, yy, xy] in the plane, [xx, yy, zz, yz, zx, xy] in space.
pub type Tensor<K> = Components<K, TensorForm>;
/// A vector: [x, y] in the plane, [x, y, z] in space.
pub type Vector<K> = Components<K, VectorForm>;
/// Something about an axis: one value (anticlockwise) in the plane; [x, y, z], right-handed, in
/// space.
pub type Axial<K> = Components<K, AxialForm>;
/// A vector that is usually vertical: [x, y] in the plane; in space [x, y, z] or the one value
/// that points downwards.
pub type Down<K> = Components<K, DownForm>;

/// One value or a list of them, each with its place.
#[derive(Debug, Clone, PartialEq)]
pub struct Components<K: Kind, F: Form> {
    /// The values.
    pub items: Vec<Quantity<K>>,
    /// Whether it is one value and no list.
    pub is_single: bool,
    /// Where it stands.
    pub span: Span,
    form: PhantomData<F>,
}

impl<K: Kind, F: Form> Components<K, F> {
    /// A list of values.
    pub fn list(items: Vec<Quantity<K>>, span: Span) -> Self {
        Components { items, is_single: false, span, form: PhantomData }
    }

    fn part(&self, k: usize) -> f64 {
        self.items.get(k).map_or(0.0, Quantity::si)
    }

    /// SI value of a single one.
    pub fn single(&self) -> Option<f64> {
        self.is_single.then(|| self.part(0))
    }

    /// First two components, SI; missing ones are 0.
    pub fn xy(&self) -> [f64; 2] {
        [self.part(0), self.part(1)]
    }

    /// Three components, SI; missing ones are 0.
    pub fn xyz(&self) -> [f64; 3] {
        [self.part(0), self.part(1), self.part(2)]
    }

    /// xx, yy, zz, yz, zx, xy of a tensor, SI; those of the plane that it has not are 0.
    pub fn symmetric(&self) -> [f64; 6] {
        let all = [0, 1, 2, 3, 4, 5].map(|k| self.part(k));
        match self.items.len() {
            3 => [all[0], all[1], 0.0, 0.0, 0.0, all[2]],
            _ => all,
        }
    }

    /// As it was written.
    pub fn raw(&self) -> String {
        raw(&self.items, self.is_single)
    }
}

fn raw<K: Kind>(items: &[Quantity<K>], is_single: bool) -> String {
    let words: Vec<String> = items.iter().map(|item| item.raw.to_string()).collect();
    if is_single { words.join("") } else { format!("[{}]", words.join(", ")) }
}

/// What stands in the text: a single value or a list.
enum Either<S: Kind, L: Kind> {
    Single(Raw, PhantomData<S>),
    List(Vec<Quantity<L>>),
}

impl<'de, S: Kind, L: Kind> Deserialize<'de> for Either<S, L> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct EitherVisitor<S, L>(PhantomData<(S, L)>);
        impl<'de, S: Kind, L: Kind> Visitor<'de> for EitherVisitor<S, L> {
            type Value = Either<S, L>;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a value with a unit or a list of them")
            }
            fn visit_i64<E>(self, value: i64) -> Result<Self::Value, E> {
                Ok(Either::Single(Raw::Number(value as f64), PhantomData))
            }
            fn visit_u64<E>(self, value: u64) -> Result<Self::Value, E> {
                Ok(Either::Single(Raw::Number(value as f64), PhantomData))
            }
            fn visit_f64<E>(self, value: f64) -> Result<Self::Value, E> {
                Ok(Either::Single(Raw::Number(value), PhantomData))
            }
            fn visit_str<E>(self, value: &str) -> Result<Self::Value, E> {
                Ok(Either::Single(Raw::Text(value.to_owned()), PhantomData))
            }
            fn visit_seq<A: SeqAccess<'de>>(self, mut seq: A) -> Result<Self::Value, A::Error> {
                let mut items = Vec::new();
                while let Some(item) = seq.next_element()? {
                    items.push(item);
                }
                Ok(Either::List(items))
            }
        }
        deserializer.deserialize_any(EitherVisitor(PhantomData))
    }
}

impl<'de, K: Kind, F: Form> Deserialize<'de> for Components<K, F> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let whole = toml::Spanned::<Either<K, K>>::deserialize(deserializer)?;
        let span = whole.span();
        let (items, is_single) = match whole.into_inner() {
            Either::Single(raw, _) => (vec![Quantity::new(raw, span.clone())], true),
            Either::List(items) => (items, false),
        };
        Ok(Components { items, is_single, span, form: PhantomData })
    }
}

impl<K: Kind, F: Form> JsonSchema for Components<K, F> {
    fn schema_name() -> Cow<'static, str> {
        Cow::Owned(format!("{}_{}", F::NAME, K::NAME))
    }
    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let one = generator.subschema_for::<K>();
        form_schema(F::NAME, one.clone(), one)
    }
}

/// Schema of a form: an array, or a single value or an array.
fn form_schema(name: &str, single: Schema, item: Schema) -> Schema {
    let info = FORMS.iter().find(|info| info.name == name);
    let counts: Vec<usize> = info
        .map(|info| [info.planar.list, info.spatial.list])
        .into_iter()
        .flatten()
        .filter(|count| *count > 0)
        .collect();
    let low = counts.iter().min().copied().unwrap_or(0);
    let high = counts.iter().max().copied().unwrap_or(0);
    let array = json_schema!({ "type": "array", "items": item, "minItems": low, "maxItems": high });
    if info.is_some_and(|info| info.planar.single || info.spatial.single) {
        json_schema!({ "anyOf": [single, array] })
    } else {
        array
    }
}

/// A direction: in the plane an angle, anticlockwise from the x axis; in space a vector of any
/// length, for example `[0, 0, 1]`.
#[derive(Debug, Clone, PartialEq)]
pub struct Direction {
    /// The angle.
    pub angle: Option<Quantity<Angle>>,
    /// The components.
    pub axes: Vec<Quantity<Plain>>,
    /// Where it stands.
    pub span: Span,
}

impl Direction {
    /// Unit vector; `None` if all components are 0.
    pub fn unit(&self) -> Option<[f64; 3]> {
        if let Some(angle) = &self.angle {
            return Some([libm::cos(angle.si()), libm::sin(angle.si()), 0.0]);
        }
        unit(&self.axes)
    }
}

/// Unit vector of three plain numbers; `None` if all are 0.
pub fn unit(axes: &[Quantity<Plain>]) -> Option<[f64; 3]> {
    let part = |k: usize| axes.get(k).map_or(0.0, Quantity::si);
    let v = [part(0), part(1), part(2)];
    // Scaled first, so that neither large nor small numbers overflow.
    let most = v.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    let v = v.map(|x| x / most);
    let length = v.iter().map(|x| x * x).sum::<f64>().sqrt();
    (most > 0.0 && length.is_finite()).then(|| v.map(|x| x / length))
}

impl<'de> Deserialize<'de> for Direction {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let whole = toml::Spanned::<Either<Angle, Plain>>::deserialize(deserializer)?;
        let span = whole.span();
        let (angle, axes) = match whole.into_inner() {
            Either::Single(raw, _) => (Some(Quantity::new(raw, span.clone())), Vec::new()),
            Either::List(axes) => (None, axes),
        };
        Ok(Direction { angle, axes, span })
    }
}

impl JsonSchema for Direction {
    fn schema_name() -> Cow<'static, str> {
        // In two parts like the other forms.
        Cow::Borrowed("Direction_Angle")
    }
    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let (angle, plain) =
            (generator.subschema_for::<Angle>(), generator.subschema_for::<Plain>());
        form_schema("Direction", angle, plain)
    }
}

/// One value or one for each of three axes: the edge of a cubic cell, or three of them.
#[derive(Debug, Clone, PartialEq)]
pub struct Edges<K: Kind> {
    /// One value or three.
    pub items: Vec<Quantity<K>>,
    /// Where it stands.
    pub span: Span,
}

impl<K: Kind> Edges<K> {
    /// Three values, SI.
    pub fn xyz(&self) -> [f64; 3] {
        let last = self.items.len().saturating_sub(1);
        [0, 1, 2].map(|k: usize| self.items.get(k.min(last)).map_or(f64::NAN, Quantity::si))
    }

    /// As it was written.
    pub fn raw(&self) -> String {
        raw(&self.items, self.items.len() == 1)
    }
}

impl<'de, K: Kind> Deserialize<'de> for Edges<K> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let whole = toml::Spanned::<Either<K, K>>::deserialize(deserializer)?;
        let span = whole.span();
        let items = match whole.into_inner() {
            Either::Single(raw, _) => vec![Quantity::new(raw, span.clone())],
            Either::List(items) => items,
        };
        Ok(Edges { items, span })
    }
}

impl<K: Kind> JsonSchema for Edges<K> {
    fn schema_name() -> Cow<'static, str> {
        Cow::Owned(format!("Edges_{}", K::NAME))
    }
    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let one = generator.subschema_for::<K>();
        json_schema!({ "anyOf": [
            one.clone(), { "type": "array", "items": one, "minItems": 3, "maxItems": 3 }
        ] })
    }
}
