//! Two pins, and how they move against each other.

use riprap_geom::{Vec2, Vec3};

use super::{Kind, View};
use crate::plan::{Gauge, Pin};
use crate::record::field::{FieldError, Part, Shape, find};

/// What is read between two pins.
#[derive(Clone, Copy, Debug, PartialEq)]
enum What {
    Convergence,
    Displacement,
    Velocity,
}

/// A field of pairs that is read between two pins.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct PinReading {
    pins: [Pin; 2],
    what: What,
    part: Part,
    along: Option<[f64; 3]>,
}

impl PinReading {
    /// `None` where the gauge has no pins, or no field of pins.
    pub(super) fn new(kind: Kind, gauge: &Gauge) -> Result<Option<Self>, FieldError> {
        let (info, part) = find(kind.fields(), &gauge.field)?;
        let (Some(pins), Some(what)) = (gauge.pins, What::of(info.name)) else {
            return Ok(None);
        };
        Ok(Some(Self { pins, what, part, along: gauge.along }))
    }

    /// NaN where a block is gone.
    pub(super) fn value(&self, view: &View<'_>) -> f64 {
        let (Some(a), Some(b)) = (view.pinned(&self.pins[0]), view.pinned(&self.pins[1])) else {
            return f64::NAN;
        };
        let [before, now, velocity] = [0, 1, 2].map(|k| a[k] - b[k]);
        let vector = match self.what {
            What::Convergence => return before.length() - now.length(),
            What::Displacement => now - before,
            What::Velocity => velocity,
        };
        self.part.read(Shape::Vector3, vector.to_array(), self.along)
    }
}

impl What {
    fn of(field: &str) -> Option<Self> {
        match field {
            "pair.convergence" => Some(Self::Convergence),
            "pair.displacement" => Some(Self::Displacement),
            "pair.velocity" => Some(Self::Velocity),
            _ => None,
        }
    }
}

impl View<'_> {
    /// Where a pin was when displacements began to be measured, where it is (m, local), and its velocity (m/s); `None` where its block is gone.
    #[must_use]
    pub fn pinned(&self, pin: &Pin) -> Option<[Vec3; 3]> {
        match self {
            Self::Planar(v) => {
                let found = v.pinned(pin.block, Vec2::new(pin.at[0], pin.at[1]))?;
                Some(found.map(|p| Vec3::new(p.x, p.y, 0.0)))
            }
            Self::Spatial(v) => v.pinned(pin.block, Vec3::from(pin.at)),
        }
    }
}
