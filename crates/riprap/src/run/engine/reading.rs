//! One number of a model, read again and again.

use super::{Kind, View};
use crate::plan::Gauge;
use crate::record::field::{FieldError, FieldInfo};
use crate::{Vec3, planar, spatial};

/// One number that is read again and again.
#[derive(Clone, Debug, PartialEq)]
pub enum Reading {
    /// From the planar engine.
    Planar(planar::fields::Reading),
    /// From the spatial engine.
    Spatial(spatial::fields::Reading),
}

impl Reading {
    /// A reading of one engine.
    ///
    /// # Errors
    /// Unknown names and parts of scalars.
    pub fn new(kind: Kind, gauge: &Gauge) -> Result<Self, FieldError> {
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

    /// Table entry.
    #[must_use]
    pub fn info(&self) -> &'static FieldInfo {
        either!(self, r => r.info())
    }

    /// Whether reading it costs as much as a step.
    #[must_use]
    pub fn costly(&self) -> bool {
        either!(self, r => r.costly())
    }

    /// The number; NaN from a view of another engine.
    #[must_use]
    pub fn value(&self, view: &View<'_>) -> f64 {
        match (self, view) {
            (Self::Planar(r), View::Planar(v)) => r.value(v),
            (Self::Spatial(r), View::Spatial(v)) => r.value(v),
            (Self::Planar(_), View::Spatial(_)) | (Self::Spatial(_), View::Planar(_)) => f64::NAN,
        }
    }
}
