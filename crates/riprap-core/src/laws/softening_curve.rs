//! Softening curves by points, of bonds and of joints.

use serde::{Deserialize, Serialize};

/// Most points of a [`Curve`].
pub const MOST_POINTS: usize = 8;

/// A softening curve of straight lines between points (share of the softening length, share of the strength): from (0, 1) down to (1, 0).
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Curve {
    points: [[f64; 2]; MOST_POINTS],
    count: u8,
}

/// What is wrong with the points of a [`Curve`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum CurveError {
    /// Two to eight.
    #[error("it has {count} points; 2 to {MOST_POINTS} are allowed")]
    Count {
        /// Points given.
        count: usize,
    },
    /// The first point is (0, 1).
    #[error("it does not begin at [0, 1], the full strength")]
    Start,
    /// The last point has no strength left.
    #[error("it does not end at a strength of 0")]
    End,
    /// Openings ascend.
    #[error("the opening of point {point} does not exceed that of the previous point")]
    Order {
        /// Counted from 1.
        point: usize,
    },
    /// Strength falls.
    #[error("the strength of point {point} exceeds that of the previous point")]
    Rise {
        /// Counted from 1.
        point: usize,
    },
}

impl Curve {
    /// The curve through points `[opening, share of the strength]`; openings in any one unit.
    ///
    /// # Errors
    /// The first thing that is wrong with them.
    pub fn new(given: &[[f64; 2]]) -> Result<Self, CurveError> {
        let count = given.len();
        if !(2..=MOST_POINTS).contains(&count) {
            return Err(CurveError::Count { count });
        }
        if given[0] != [0.0, 1.0] {
            return Err(CurveError::Start);
        }
        for (k, two) in given.windows(2).enumerate() {
            let [[from, high], [to, low]] = [two[0], two[1]];
            // Written so that a NaN is out of order too.
            if !(to > from && to.is_finite()) {
                return Err(CurveError::Order { point: k + 2 });
            }
            if low.is_nan() || low > high {
                return Err(CurveError::Rise { point: k + 2 });
            }
        }
        let [end, left] = given[count - 1];
        if left != 0.0 {
            return Err(CurveError::End);
        }
        let mut points = [[0.0; 2]; MOST_POINTS];
        for (point, [opening, share]) in points.iter_mut().zip(given) {
            *point = [opening / end, *share];
        }
        Ok(Self { points, count: count as u8 })
    }

    /// Its points.
    #[must_use]
    pub fn points(&self) -> &[[f64; 2]] {
        &self.points[..usize::from(self.count)]
    }

    /// Share of the strength at the share `x` of the length.
    #[must_use]
    pub fn at(&self, x: f64) -> f64 {
        let past = self.points().windows(2).find(|two| x < two[1][0]);
        past.map_or(0.0, |two| {
            let [[from, high], [to, low]] = [two[0], two[1]];
            high + (low - high) * (x - from) / (to - from)
        })
    }

    /// Area under it.
    #[must_use]
    pub fn area(&self) -> f64 {
        let lines = self.points().windows(2);
        lines.map(|two| 0.5 * (two[0][1] + two[1][1]) * (two[1][0] - two[0][0])).sum()
    }

    /// Its steepest fall, share of the strength over share of the length.
    #[must_use]
    pub fn steepest(&self) -> f64 {
        let falls = self.points().windows(2);
        let falls = falls.map(|two| (two[0][1] - two[1][1]) / (two[1][0] - two[0][0]));
        falls.fold(0.0, f64::max)
    }
}
