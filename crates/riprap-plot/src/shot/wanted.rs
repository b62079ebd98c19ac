//! What is to be drawn, and from where.

use riprap_geom::Vec3;
use riprap_record::contacts::STATES;

use super::super::PlotError;
use super::super::drawing::{BlockOptions, Normal};
use super::camera;

/// Points of the drawing along a side of a point of the picture.
pub(super) const FINE: usize = 2;
/// Room for the title, pixels.
pub(super) const TITLE: f64 = 34.0;
/// Most points along a side of the picture.
const MOST: u32 = 8000;
/// Least and greatest angle of view, deg.
const ANGLES: std::ops::RangeInclusive<f64> = 1.0..=150.0;

/// From where a model is seen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Eye {
    /// All of the model from a direction.
    From {
        /// Where the eye stands: clockwise from north (y), and above the horizon, deg.
        direction: [f64; 2],
        /// Angle of view between the upper and the lower edge of the picture, deg; `None`: a parallel projection.
        angle: Option<f64>,
    },
    /// In perspective from a place.
    At {
        /// Where the eye is, m.
        place: [f64; 3],
        /// What lies in the middle of the picture, m.
        target: [f64; 3],
        /// What is upwards in the picture.
        up: [f64; 3],
        /// Angle of view between the upper and the lower edge of the picture, deg.
        angle: f64,
    },
}

/// A plane; the side that its normal points to is cut away.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cut {
    /// Its normal, of any length but zero.
    pub normal: [f64; 3],
    /// Place along the normal: `normal . p = at`.
    pub at: f64,
}

impl Cut {
    /// A plane across an axis at a place, m; the side nearer to the eye is cut away.
    #[must_use]
    pub fn nearer(axis: Normal, at: f64, eye: &Eye) -> Self {
        let normal = Vec3::AXES[axis.index()];
        let side = if camera::towards(eye).dot(normal) < 0.0 { -1.0 } else { 1.0 };
        Self { normal: (side * normal).to_array(), at: side * at }
    }
}

/// What is drawn, and from where.
#[derive(Clone, Debug, PartialEq)]
pub struct Shot {
    /// Field that colours the blocks.
    pub field: String,
    /// From where.
    pub eye: Eye,
    /// Width and height of the model's part of the picture, pixels.
    pub size: [u32; 2],
    /// What is cut away.
    pub cut: Option<Cut>,
    /// Bolts as rods in front of the blocks.
    pub bolts: bool,
    /// Shadows of the sun, and darker hollows.
    pub shadows: bool,
    /// Contact forces as tubes from block to block.
    pub chains: bool,
    /// Contacts as points: which of their states, by their numbers.
    pub contacts: Option<[bool; STATES.len()]>,
    /// The ways that blocks have taken up to the frame.
    pub trails: Option<Trails>,
    /// A field of vectors, drawn as arrows from the middles of the blocks.
    pub vectors: Option<String>,
    /// Texts at places of the model.
    pub notes: Vec<Note>,
    /// Of these range, percentiles, scale and exaggeration.
    pub options: BlockOptions,
}

impl Default for Shot {
    fn default() -> Self {
        Self {
            field: "displacement".to_owned(),
            eye: Eye::From { direction: [215.0, 28.0], angle: None },
            size: [1000, 700],
            cut: None,
            bolts: true,
            shadows: true,
            chains: false,
            contacts: None,
            trails: None,
            vectors: None,
            notes: Vec::new(),
            options: BlockOptions::default(),
        }
    }
}

/// Which ways of blocks are drawn, and how.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Trails {
    /// Coloured by block; else by mean speed from frame to frame.
    pub by_block: bool,
    /// Number of the only block whose way is drawn; `None`: all that moved by a quarter of a usual block.
    pub only: Option<u32>,
}

/// States of contacts that are drawn where none are named: all but touching ones.
pub const CHANGED: [bool; STATES.len()] = [false, true, true, true, true, true, true, true];

/// A text at a place of the model.
#[derive(Clone, Debug, PartialEq)]
pub struct Note {
    /// What is written.
    pub text: String,
    /// Where it points to, m; on a block: where that is at rest.
    pub at: [f64; 3],
    /// Number of its block; `None`: it stays where it is.
    pub block: Option<u32>,
}

pub(super) fn failed(reason: impl std::fmt::Display) -> PlotError {
    PlotError::Render { reason: reason.to_string() }
}

impl Shot {
    pub(super) fn checked(&self) -> Result<(), PlotError> {
        self.options.checked()?;
        let wrong = |option, given, wanted| Err(PlotError::Option { option, given, wanted });
        let angle = match self.eye {
            Eye::From { direction: [azimuth, above], angle } => {
                if !azimuth.is_finite() || !(-90.0..=90.0).contains(&above) {
                    let given = format!("{azimuth} {above}");
                    let wanted = "give an azimuth and an elevation from -90 to 90 degrees";
                    return wrong("view", given, wanted);
                }
                angle
            }
            Eye::At { place, target, up, angle } => {
                let [eye, target, up] = [place, target, up].map(Vec3::from);
                let across = (eye - target).cross(up).length();
                let least = 1e-9 * (eye - target).length() * up.length();
                if !across.is_finite() || across <= least {
                    let given = format!("{place:?}");
                    let wanted =
                        "the eye must be away from the target, and not straight above or below it";
                    return wrong("eye", given, wanted);
                }
                Some(angle)
            }
        };
        if let Some(angle) = angle.filter(|angle| !ANGLES.contains(angle)) {
            return wrong("perspective", angle.to_string(), "give an angle from 1 to 150 degrees");
        }
        if self.size.iter().any(|side| !(16..=MOST).contains(side)) {
            let given = format!("{} {}", self.size[0], self.size[1]);
            return wrong("size", given, "give a width and a height from 16 to 8000 pixels");
        }
        match self.cut {
            Some(Cut { normal, at }) if !at.is_finite() || Vec3::from(normal).length() == 0.0 => {
                wrong("at", at.to_string(), "give a position along the normal in m")
            }
            Some(_) | None => Ok(()),
        }
    }
}

/// Red, green and blue of `#rrggbb`.
pub(super) fn rgb(colour: &str) -> [f64; 3] {
    [1, 3, 5].map(|k| {
        let part = colour.get(k..k + 2).and_then(|part| u8::from_str_radix(part, 16).ok());
        f64::from(part.unwrap_or(255))
    })
}
