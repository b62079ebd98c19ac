//! A facet as a polygon: what lies on it, and how far away it is.

use riprap_geom::Vec3;

/// Outline of a facet.
pub(crate) struct Area {
    pub(crate) corners: Vec<Vec3>,
    pub(crate) normal: Vec3,
    low: Vec3,
    high: Vec3,
}

impl Area {
    /// The polygon with these corners (m) in the plane with this unit normal.
    pub(crate) fn new(corners: Vec<Vec3>, normal: Vec3) -> Self {
        let low = corners.iter().fold(Vec3::INFINITY, |m, p| m.min(*p));
        let high = corners.iter().fold(Vec3::NEG_INFINITY, |m, p| m.max(*p));
        Self { corners, normal, low, high }
    }

    /// Whether a point is on it, its rim included.
    pub(crate) fn holds(&self, at: Vec3, near: f64) -> bool {
        let slack = Vec3::splat(near);
        if at.cmplt(self.low - slack).any() || at.cmpgt(self.high + slack).any() {
            return false;
        }
        let count = self.corners.len();
        (self.normal.dot(at - self.corners[0])).abs() <= near
            && (0..count).all(|k| {
                let (p, q) = (self.corners[k], self.corners[(k + 1) % count]);
                let inward = self.normal.cross(q - p).normalize_or_zero();
                inward.dot(at - p) >= -near
            })
    }

    /// Mean of the corners, m.
    pub(crate) fn middle(&self) -> Vec3 {
        self.corners.iter().copied().sum::<Vec3>() / self.corners.len() as f64
    }

    /// Distance of a point, m.
    pub(crate) fn distance(&self, at: Vec3) -> f64 {
        let Some(&first) = self.corners.first() else {
            return f64::INFINITY;
        };
        let foot = at - self.normal.dot(at - first) * self.normal;
        if self.holds(foot, 0.0) {
            return foot.distance(at);
        }
        let count = self.corners.len();
        let edges = (0..count).map(|k| {
            let (p, q) = (self.corners[k], self.corners[(k + 1) % count]);
            let along = q - p;
            let share = (at - p).dot(along) / along.length_squared().max(f64::MIN_POSITIVE);
            at.distance(p + share.clamp(0.0, 1.0) * along)
        });
        edges.fold(f64::INFINITY, f64::min)
    }
}
