//! One number of a model, read again and again.

use super::pins::PinReading;
use super::{Kind, View};
use crate::plan::{Against, Gauge};
use crate::record::field::{FieldError, FieldInfo, Part, Shape, find};
use crate::{Vec3, planar, spatial};

/// One number that is read again and again.
#[derive(Clone, Debug, PartialEq)]
pub struct Reading {
    own: One,
    /// Of a number between two pins.
    pins: Option<PinReading>,
    /// Of a number that is relative to other blocks: its components, and those of the mean that is taken off them.
    relative: Vec<[One; 2]>,
}

/// A reading of one engine.
#[derive(Clone, Debug, PartialEq)]
enum One {
    Planar(planar::fields::Reading),
    Spatial(spatial::fields::Reading),
}

impl One {
    fn new(kind: Kind, gauge: &Gauge) -> Result<Self, FieldError> {
        match kind {
            Kind::Planar | Kind::Slice => {
                let along = gauge.along.map(|[x, y, _z]| [x, y]);
                let reading = planar::fields::Reading::new(&gauge.field, &gauge.of, along)?;
                let reading = reading.with_groups(&gauge.groups);
                Ok(Self::Planar(match kind {
                    Kind::Slice => reading.of_slice(),
                    Kind::Planar | Kind::Spatial => reading,
                }))
            }
            Kind::Spatial => {
                let (at, along) = (gauge.at.map(Vec3::from), gauge.along.map(Vec3::from));
                let reading = spatial::fields::Reading::new(&gauge.field, &gauge.of, at, along)?;
                Ok(Self::Spatial(reading.with_groups(&gauge.groups)))
            }
        }
    }

    fn value(&self, view: &View<'_>) -> f64 {
        match (self, view) {
            (Self::Planar(r), View::Planar(v)) => r.value(v),
            (Self::Spatial(r), View::Spatial(v)) => r.value(v),
            (Self::Planar(_), View::Spatial(_)) | (Self::Spatial(_), View::Planar(_)) => f64::NAN,
        }
    }
}

/// The parts of a number that is relative to other blocks.
fn relative(kind: Kind, gauge: &Gauge) -> Result<Vec<[One; 2]>, FieldError> {
    let (info, part) = find(kind.fields(), &gauge.field)?;
    let Some((against, mean)) = gauge.against.as_ref().zip(Against::counterpart(info.name)) else {
        return Ok(Vec::new());
    };
    let parts: &[Part] = match part {
        Part::X | Part::Y | Part::Z => &[part],
        Part::Whole if gauge.along.is_some() => &[Part::Whole],
        // A length is that of the difference.
        Part::Whole | Part::Magnitude if info.shape == Shape::Vector3 => {
            &[Part::X, Part::Y, Part::Z]
        }
        Part::Whole | Part::Magnitude => &[Part::X, Part::Y],
    };
    let pair = |part: &Part| {
        let own = Gauge {
            field: format!("{}{}", info.name, part.suffix()),
            against: None,
            ..gauge.clone()
        };
        let of_mean = Gauge {
            field: format!("{mean}{}", part.suffix()),
            of: against.of.clone(),
            groups: against.groups.clone(),
            along: gauge.along,
            ..Gauge::default()
        };
        Ok([One::new(kind, &own)?, One::new(kind, &of_mean)?])
    };
    parts.iter().map(pair).collect()
}

impl Reading {
    /// A reading of one engine.
    ///
    /// # Errors
    /// Unknown names and parts of scalars.
    pub fn new(kind: Kind, gauge: &Gauge) -> Result<Self, FieldError> {
        let pins = PinReading::new(kind, gauge)?;
        Ok(Self { own: One::new(kind, gauge)?, pins, relative: relative(kind, gauge)? })
    }

    /// Table entry.
    #[must_use]
    pub fn info(&self) -> &'static FieldInfo {
        match &self.own {
            One::Planar(r) => r.info(),
            One::Spatial(r) => r.info(),
        }
    }

    /// Whether reading it costs as much as a step.
    #[must_use]
    pub fn costly(&self) -> bool {
        match &self.own {
            One::Planar(r) => r.costly(),
            One::Spatial(r) => r.costly(),
        }
    }

    /// The number; NaN from a view of another engine.
    #[must_use]
    pub fn value(&self, view: &View<'_>) -> f64 {
        if let Some(pins) = &self.pins {
            return pins.value(view);
        }
        let difference = |[own, mean]: &[One; 2]| own.value(view) - mean.value(view);
        let square = |pair: &[One; 2]| {
            let part = difference(pair);
            part * part
        };
        match &self.relative[..] {
            [] => self.own.value(view),
            [one] => difference(one),
            all => all.iter().map(square).sum::<f64>().sqrt(),
        }
    }
}
