//! Craters and bulges: how far the free surface has risen around a charge.
//!
//! A run has no final crater: blocks keep the neighbours of the start and fall back into place. What is read
//! is a snapshot by a stated criterion: the mean uplift of the surface blocks in rings about the charge.

use riprap_geom::Vec3;

use crate::query::view::View;
use crate::state::cavity::Cavity;

/// Uplift over the depth of the charge that bounds a crater.
pub const UPLIFT: f64 = 0.02;

/// Rings of the free surface about the axis of a charge, from the inside outwards.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CraterProfile {
    /// Depth of the charge below the free surface over it, m.
    pub depth: f64,
    /// Mean distance from the axis (m) and mean uplift (m) of the blocks of each ring.
    pub rings: Vec<[f64; 2]>,
}

impl CraterProfile {
    /// Uplift of the innermost ring, m.
    #[must_use]
    pub fn dome(&self) -> f64 {
        self.rings.first().map_or(0.0, |r| r[1])
    }

    /// Distance from the axis within which the uplift is above `uplift` (m), linear between rings, m.
    #[must_use]
    pub fn radius(&self, uplift: f64) -> f64 {
        let Some(outside) = self.rings.iter().position(|r| r[1] < uplift) else {
            return self.rings.last().map_or(0.0, |r| r[0]);
        };
        if outside == 0 {
            return 0.0;
        }
        let ([x0, y0], [x1, y1]) = (self.rings[outside - 1], self.rings[outside]);
        x0 + (x1 - x0) * (y0 - uplift) / (y0 - y1)
    }
}

impl View<'_> {
    /// Uplift of the free surface about a cavity. Rings are as wide as the narrowest surface block.
    #[must_use]
    pub fn profile(&self, cavity: &Cavity) -> CraterProfile {
        let world = self.world;
        let up = self.up();
        let centre = self.charge_centre(cavity);
        // Distance from the axis, uplift, height of the top above the charge.
        let mut found: Vec<[f64; 3]> = Vec::new();
        let mut width = f64::INFINITY;
        for (b, _) in self.surface().iter().enumerate().filter(|(_, s)| **s) {
            let half = world.solid_of(b).half;
            let arm = world.reference[b] - centre;
            let height = arm.dot(up) + half.dot(up.abs());
            let across = arm - arm.dot(up) * up;
            let flat = half - half * up.abs();
            let sides = flat.to_array().into_iter().filter(|h| *h > 0.0);
            width = sides.fold(width, |w, h| w.min(2.0 * h));
            found.push([across.length(), self.displacement(b).dot(up), height]);
        }
        let rings = rings(&mut found, width);
        CraterProfile { depth: found.first().map_or(0.0, |f| f[2]), rings }
    }

    /// Centre of the removed blocks of a cavity, weighted by volume, m (local).
    #[must_use]
    pub fn charge_centre(&self, cavity: &Cavity) -> Vec3 {
        let (mut sum, mut volume) = (Vec3::ZERO, 0.0);
        for &b in &cavity.blocks {
            let v = self.world.solid_of(b as usize).volume;
            sum += v * self.world.reference[b as usize];
            volume += v;
        }
        sum / f64::max(volume, f64::MIN_POSITIVE)
    }
}

/// Sorts by distance and averages over rings of a width.
fn rings(found: &mut [[f64; 3]], width: f64) -> Vec<[f64; 2]> {
    found.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
    found
        .chunk_by(|a, b| (a[0] / width).floor() == (b[0] / width).floor())
        .map(|ring| {
            let mean = |k: usize| ring.iter().map(|f| f[k]).sum::<f64>() / ring.len() as f64;
            [mean(0), mean(1)]
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn radius_is_read_between_rings() {
        let profile = CraterProfile {
            depth: 2.0,
            rings: vec![[0.5, 0.10], [1.5, 0.06], [2.5, 0.02], [3.5, 0.05]],
        };
        assert_eq!(profile.dome(), 0.10);
        assert!((profile.radius(0.04) - 2.0).abs() < 1e-12);
        assert_eq!(profile.radius(0.2), 0.0);
        assert_eq!(profile.radius(0.01), 3.5);
    }

    #[test]
    fn rings_average_what_lies_in_them() {
        let mut found = [[1.9, 3.0, 0.0], [0.7, 1.0, 0.0], [1.1, 1.0, 0.0]];
        assert_eq!(rings(&mut found, 1.0), vec![[0.7, 1.0], [1.5, 2.0]]);
    }
}
