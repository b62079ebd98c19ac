//! Blocks that have eight parts similar to themselves: bricks, and parallelepipeds in any attitude.
//!
//! Source: Tian & Li, eq. (4): child centroid = parent's corner + n L/4 with n = 1 or 3, here along the edges of the parent; their
//! assumptions 1 and 5: children have the attitude of their parent, cuts the strike and dip of the joints.

use riprap_geom::Vec3;
use riprap_geom::polyhedron::{Parallelepiped, Polyhedron};

use crate::faces::region::{Bounds, Extent};
use crate::setup::{Region, Shape, Solid};

/// A block that eight halves of itself fill.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Divisible {
    /// A brick.
    Brick(Bounds),
    /// A parallelepiped in any attitude.
    Leaning(Parallelepiped),
}

impl Divisible {
    /// What a shape is; `None` for all others.
    #[must_use]
    pub fn of(shape: &Shape) -> Option<Self> {
        match shape {
            Shape::Brick { .. } => Some(Self::Brick(Bounds::of(shape))),
            Shape::Polyhedron(solid) => {
                Parallelepiped::of(&solid.vertices, &solid.faces).map(Self::Leaning)
            }
            Shape::Terrain(_) | Shape::Glued(_) => None,
        }
    }

    /// Part `octant`.
    #[must_use]
    pub fn part(&self, octant: u8) -> Self {
        match self {
            Self::Brick(Bounds { centre, half }) => {
                let sign = |bit: u8| if octant & bit != 0 { 0.5 } else { -0.5 };
                let side = Vec3::new(sign(1), sign(2), sign(4));
                Self::Brick(Bounds { centre: *centre + side * *half, half: 0.5 * *half })
            }
            Self::Leaning(solid) => Self::Leaning(solid.octant(octant)),
        }
    }

    /// The part that holds a point; of several the upper one.
    #[must_use]
    pub fn part_of(&self, point: Vec3) -> u8 {
        match self {
            Self::Brick(Bounds { centre, .. }) => {
                let bit = |a: usize| u8::from(point[a] >= centre[a]) << a;
                bit(0) + bit(1) + bit(2)
            }
            Self::Leaning(solid) => solid.octant_of(point),
        }
    }

    /// Blocks that splitting around a region makes of one, without those that the balance with its neighbours adds: where all of it lies in the
    /// region by a power of eight, else by trying, until there are more than `most`.
    #[must_use]
    pub fn parts_around(&self, region: &Region, levels: u8, most: f64) -> f64 {
        if levels == 0 || !self.extent().touches(region) {
            return 1.0;
        }
        if matches!(region, Region::All) {
            return (0..levels).fold(1.0, |parts, _| 8.0 * parts);
        }
        let mut count = 0.0;
        for octant in 0..8 {
            count += self.part(octant).parts_around(region, levels - 1, most - count);
            if count > most {
                break;
            }
        }
        count
    }

    /// Centroid, m.
    #[must_use]
    pub fn centre(&self) -> Vec3 {
        match self {
            Self::Brick(bounds) => bounds.centre,
            Self::Leaning(solid) => solid.centre,
        }
    }

    /// How far it reaches from its centroid along a unit direction, m.
    #[must_use]
    pub fn reach(&self, along: Vec3) -> f64 {
        match self {
            Self::Brick(bounds) => bounds.half.dot(along.abs()),
            Self::Leaning(solid) => solid.half.iter().map(|h| h.dot(along).abs()).sum(),
        }
    }

    /// Area of the surface, m².
    #[must_use]
    pub fn surface(&self) -> f64 {
        match self {
            Self::Brick(Bounds { half: h, .. }) => 8.0 * (h.x * h.y + h.y * h.z + h.z * h.x),
            Self::Leaning(solid) => solid.surface(),
        }
    }

    /// As the shape of a block.
    #[must_use]
    pub fn shape(&self) -> Shape {
        match self {
            Self::Brick(Bounds { centre, half }) => Shape::Brick { centre: *centre, half: *half },
            Self::Leaning(solid) => {
                let Polyhedron { vertices, faces } = solid.solid();
                Shape::Polyhedron(Box::new(Solid { vertices, faces }))
            }
        }
    }

    /// What it fills.
    #[must_use]
    pub fn extent(&self) -> Extent {
        match self {
            Self::Brick(bounds) => Extent::Box(*bounds),
            Self::Leaning(solid) => {
                let solid = solid.solid();
                let bounds = Bounds::around(&solid.vertices);
                Extent::Solid(solid, bounds)
            }
        }
    }
}
