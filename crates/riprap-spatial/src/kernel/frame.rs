//! Planes of pieces with two axes in each: of one, or of eight side by side, by the same arithmetic.

use riprap_geom::Vec3;

use crate::kernel::planes::Planes;
use crate::lanes::{LANES, Lanes, Number, Vectors, cross, dot, minus, scaled};

/// Normals that differ by less are parallel: their faces share no piece.
pub(crate) const PARALLEL: f64 = 2e-7;
/// A plane farther from the origin than this, times the radius of the smaller block, has no point in it.
const OUT_OF_REACH: f64 = 1.0 + 1e-9;

/// Plane of a piece with two axes in it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Frame {
    /// Unit normal, from A to B.
    pub normal: Vec3,
    /// Foot of the origin on the plane, m.
    pub foot: Vec3,
    /// Axes in the plane.
    pub axes: [Vec3; 2],
}

/// Where the depths below a face of A and one of B are equal.
struct Middle<T> {
    /// Square of the difference of the normals.
    squared: T,
    normal: [T; 3],
    /// Of the plane above the origin, m.
    height: T,
}

impl<T: Number> Middle<T> {
    /// Of planes with these normals, that of A farther from the origin by `rise` (m).
    #[inline(always)]
    fn new(a: &[T; 3], b: &[T; 3], rise: T) -> Self {
        let difference = minus(a, b);
        let squared = dot(&difference, &difference);
        let inverse = T::constant(1.0) / squared.root();
        Self { squared, normal: scaled(inverse, &difference), height: rise * inverse }
    }

    /// Two axes in the plane, the first across `axis`.
    #[inline(always)]
    fn axes(&self, axis: &[T; 3]) -> [[T; 3]; 2] {
        let first = cross(axis, &self.normal);
        let first = scaled(T::constant(1.0) / dot(&first, &first).root(), &first);
        [first, cross(&self.normal, &first)]
    }
}

/// The axis of space that a normal with these magnitudes is farthest from.
#[inline(always)]
fn farthest([x, y, z]: [f64; 3]) -> [f64; 3] {
    if x <= y && x <= z {
        [1.0, 0.0, 0.0]
    } else if y <= z {
        [0.0, 1.0, 0.0]
    } else {
        [0.0, 0.0, 1.0]
    }
}

/// Whether normals that differ by so much (squared) share a piece, in a plane at this height over `reach` (both m).
#[inline(always)]
fn is_there(squared: f64, height: f64, reach: f64) -> bool {
    squared >= PARALLEL * PARALLEL && height.abs() <= OUT_OF_REACH * reach
}

impl Frame {
    /// The plane where the depths below planes `f` and `g` are equal; `None` for parallel ones and where it is out of `reach`.
    #[must_use]
    pub fn between(planes: &Planes, f: usize, g: usize, reach: f64) -> Option<Self> {
        let [a, b] = [f, g].map(|k| planes.normal(k).to_array());
        let middle = Middle::new(&a, &b, planes.d[f] - planes.d[g]);
        if !is_there(middle.squared, middle.height, reach) {
            return None;
        }
        let axes = middle.axes(&farthest(middle.normal.map(f64::abs)));
        Some(Self {
            normal: Vec3::from_array(middle.normal),
            foot: Vec3::from_array(scaled(middle.height, &middle.normal)),
            axes: axes.map(Vec3::from_array),
        })
    }

    /// Point with plane coordinates s, t, m.
    #[must_use]
    pub fn point(&self, s: f64, t: f64) -> Vec3 {
        self.foot + s * self.axes[0] + t * self.axes[1]
    }
}

/// Frames of pieces side by side, each in a lane.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Frames {
    /// As of one.
    pub normal: Vectors,
    /// As of one.
    pub foot: Vectors,
    /// As of one.
    pub axes: [Vectors; 2],
    there: [bool; LANES],
}

impl Frames {
    /// The planes of pieces (f, g), numbers in `planes`, at most as many as lanes.
    #[inline(always)]
    #[must_use]
    pub(crate) fn between(planes: &Planes, pieces: &[[usize; 2]], reach: f64) -> Self {
        let (mut a, mut b, mut rise) = (Vectors::default(), Vectors::default(), [0.0; LANES]);
        for (lane, &[f, g]) in pieces.iter().enumerate() {
            for (of, k) in [(&mut a, f), (&mut b, g)] {
                of[0].0[lane] = planes.x[k];
                of[1].0[lane] = planes.y[k];
                of[2].0[lane] = planes.z[k];
            }
            rise[lane] = planes.d[f] - planes.d[g];
        }
        let middle = Middle::new(&a, &b, Lanes(rise));
        let mut axis = Vectors::default();
        let mut there = [false; LANES];
        let size = middle.normal.map(|x| x.abs().0);
        for lane in 0..LANES {
            let [x, y, z] = farthest(size.map(|of| of[lane]));
            (axis[0].0[lane], axis[1].0[lane], axis[2].0[lane]) = (x, y, z);
            there[lane] = is_there(middle.squared.0[lane], middle.height.0[lane], reach);
        }
        Self {
            normal: middle.normal,
            foot: scaled(middle.height, &middle.normal),
            axes: middle.axes(&axis),
            there,
        }
    }

    /// That of a lane; `None` for parallel planes and where it is out of reach.
    #[inline]
    #[must_use]
    pub(crate) fn get(&self, lane: usize) -> Option<Frame> {
        let vector = |of: &Vectors| Vec3::new(of[0].0[lane], of[1].0[lane], of[2].0[lane]);
        self.there[lane].then(|| Frame {
            normal: vector(&self.normal),
            foot: vector(&self.foot),
            axes: self.axes.each_ref().map(vector),
        })
    }
}
