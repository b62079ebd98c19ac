//! Arches over the openings of walls: wedges between joints that meet in one point, with a level top, and the bricks beside them.

use riprap_geom::Vec2;

use super::masonry::{Gap, SHORTEST, WHOLE};
use crate::model::builder::Builder;
use crate::scenario::language::{Masonry, OpeningArch, WallOpening};
use crate::scenario::read::with_unit;

/// Largest rise over the width: a half angle of 75 deg, tan(75 deg / 2) / 2.
const STEEPEST: f64 = 0.383;

impl Builder<'_> {
    /// Outlines of the stones of an arch along the wall, [x, z] anticlockwise as seen along y (m), and what it takes of the rows; `None` after
    /// an error. `spring`: the row from which it springs.
    ///
    /// With the width w and the rise f the underside is of the radius r = (w^2/4 + f^2)/(2 f), its centre lies r - f below the springing. The stones
    /// have plane undersides, with their corners on the circle.
    pub(super) fn arch_of_wall(
        &mut self,
        wall: &Masonry,
        opening: &WallOpening,
        said: &OpeningArch,
        spring: u64,
    ) -> Option<(Vec<[Vec2; 4]>, Vec<Gap>)> {
        let high = wall.brick[2].si();
        let rows = self.whole_rows(said.height.si(), high, &said.height.span)?;
        let (width, rise, height) = (opening.width.si(), said.rise.si(), said.height.si());
        let fault = if rise > STEEPEST * width {
            let most = with_unit(STEEPEST * width, "m");
            Some((
                &said.rise,
                format!("an arch {} wide rises by at most {most}", with_unit(width, "m")),
            ))
        } else if height <= rise * (1.0 + WHOLE) {
            Some((&said.height, "the arch has no thickness at its crown".to_owned()))
        } else {
            None
        };
        if let Some((at, fault)) = fault {
            let help = "give a smaller `rise`, or a `height` of more rows; a round arch without a wall is a `vault`";
            self.error_at("wall.arch", at.span.clone(), fault, help);
            return None;
        }
        let radius = (0.25 * width * width + rise * rise) / (2.0 * rise);
        let half = libm::asin(0.5 * width / radius);
        let middle = opening.left.si() + 0.5 * width;
        let foot = spring as f64 * high;
        let centre = foot + rise - radius;
        // Where a joint meets a height, from the middle.
        let across = |angle: f64, up: f64| (up - centre) * libm::tan(angle);
        let top = foot + rows as f64 * high;
        let count = said.voussoirs;
        let joint = |k: u32| {
            let angle = half * (2.0 * f64::from(k) / f64::from(count) - 1.0);
            let inner = Vec2::new(radius * libm::sin(angle), centre + radius * libm::cos(angle));
            [inner, Vec2::new(across(angle, top), top)].map(|p| Vec2::new(middle + p.x, p.y))
        };
        let stones = (0..count).map(|k| {
            let ([a, d], [b, c]) = (joint(k), joint(k + 1));
            [a, b, c, d]
        });
        let beside = (0..rows).map(|row| {
            let [low, up] = [row, row + 1].map(|r| across(half, foot + r as f64 * high));
            Gap {
                rows: [spring + row, spring + row + 1],
                along: [middle - up, middle + up],
                slant: up - low,
            }
        });
        Some((stones.collect(), beside.collect()))
    }

    /// Whether arches lie within the wall, with bricks between them and openings, lintels and each other; `None` after an error.
    pub(super) fn arches_are_apart(
        &mut self,
        wall: &Masonry,
        gaps: &[Gap],
        arches: &[Gap],
    ) -> Option<()> {
        let (length, least) = (wall.length.si(), SHORTEST * wall.brick[0].si());
        let apart = |(k, arch): (usize, &Gap)| {
            let clear = |other: &Gap| {
                other.rows[0] >= arch.rows[1]
                    || other.rows[1] <= arch.rows[0]
                    || other.along[0] >= arch.along[1] + least
                    || other.along[1] <= arch.along[0] - least
            };
            let others = arches.iter().enumerate().filter(|(j, _)| *j != k).map(|(_, gap)| gap);
            arch.rows[1] <= wall.courses
                && arch.along[0] >= least
                && arch.along[1] <= length - least
                && gaps.iter().chain(others).all(clear)
        };
        if arches.iter().enumerate().all(apart) {
            return Some(());
        }
        let at = wall.openings.iter().find_map(|opening| opening.arch.as_ref());
        let span = at.map_or(wall.length.span.clone(), |arch| arch.rise.span.clone());
        let message =
            "an arch reaches beyond the wall, or meets an opening, a lintel or another arch";
        let help = "leave a third of a brick beside the arch at its top, and rows above it; a smaller `rise` makes it narrower";
        self.error_at("wall.arch", span, message, help);
        None
    }
}
