//! Which image of a block a pair means in a periodic model.

use riprap_geom::Vec3;
use serde::{Deserialize, Serialize};

/// Periods of a model along x, y, z, m; `None` along axes that have an end.
pub(crate) type Periods = [Option<f64>; 3];

/// How many periods along x, y, z an image of a block lies from the block itself.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub struct Image(pub [i16; 3]);

impl Image {
    /// The block itself.
    pub const SELF: Self = Self([0; 3]);

    /// The one nearest to a way of so many metres.
    #[must_use]
    pub fn nearest(way: Vec3, periods: &Periods) -> Self {
        Self::count(way, periods, f64::round)
    }

    /// The cell that a place (m) lies in.
    #[must_use]
    pub fn cell(at: Vec3, periods: &Periods) -> Self {
        Self::count(at, periods, f64::floor)
    }

    fn count(way: Vec3, periods: &Periods, whole: impl Fn(f64) -> f64) -> Self {
        Self(std::array::from_fn(|k| periods[k].map_or(0, |period| whole(way[k] / period) as i16)))
    }

    /// The way from this image to the other one, in periods.
    #[must_use]
    pub fn to(self, other: Self) -> Self {
        Self(std::array::from_fn(|k| other.0[k].saturating_sub(self.0[k])))
    }

    /// So many periods farther.
    #[must_use]
    pub fn plus(self, way: Self) -> Self {
        Self(std::array::from_fn(|k| self.0[k].saturating_add(way.0[k])))
    }

    /// From the block to this image, m.
    #[must_use]
    pub fn shift(self, periods: &Periods) -> Vec3 {
        let along = |k: usize| f64::from(self.0[k]) * periods[k].unwrap_or_default();
        Vec3::new(along(0), along(1), along(2))
    }

    /// Where a point of the block (m) lies in this image: the same bits for the block itself.
    #[must_use]
    pub fn place(self, at: Vec3, periods: &Periods) -> Vec3 {
        if self == Self::SELF { at } else { at + self.shift(periods) }
    }
}

/// A pair of blocks: the first one where it is, the second one by its image.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub struct PairKey {
    /// The blocks, the smaller number first; equal for a block that meets an image of itself.
    pub ends: [u32; 2],
    /// Image of the second block.
    pub image: Image,
}

impl PairKey {
    /// The pair of block `ends[0]` with an image of block `ends[1]`, and whether the two have changed sides in it. Each pair has one key: of a
    /// block and itself the image whose first component other than 0 is positive.
    #[must_use]
    pub fn sorted(ends: [u32; 2], image: Image) -> (Self, bool) {
        let [i, j] = ends;
        let turned = i > j || (i == j && image < Image::SELF);
        let key = match turned {
            true => Self { ends: [j, i], image: image.to(Image::SELF) },
            false => Self { ends, image },
        };
        (key, turned)
    }

    /// Two blocks where they are, the smaller number first.
    #[must_use]
    pub fn plain(ends: [u32; 2]) -> Self {
        Self { ends, image: Image::SELF }
    }

    /// Where a point (m) of the first (0) or second (1) block lies in this pair.
    #[must_use]
    pub fn place(&self, side: usize, at: Vec3, periods: &Periods) -> Vec3 {
        if side == 0 { at } else { self.image.place(at, periods) }
    }
}
