//! Arches over the openings of walls, and the bricks beside them: segmental ones with a level top, round and pointed ones whose upper side goes in
//! steps of whole rows, so that no brick is cut:
//!
//! ```text
//!   ___________________              _________
//!   \   \   |   /   /            ___|\   |   /|___      a stone goes up from the end of its
//!    \___\__|__/___/            |__/  \__|__/  \__|     lower joint to the row of its upper
//!                               |_|             |_|     one, and level from there
//! ```

use riprap_geom::Vec2;

use super::masonry::{Gap, SHORTEST, WHOLE};
use crate::model::builder::Builder;
use crate::scenario::language::{Masonry, OpeningArch, WallOpening};
use crate::scenario::read::with_unit;

/// Largest rise over the width of a segmental arch: a half angle of 75 deg, tan(75 deg / 2) / 2.
const STEEPEST: f64 = 0.383;
/// Least and largest thickness of a round or pointed arch at a joint, over that at its crown.
const THICKNESS: [f64; 2] = [0.5, 3.0];

/// Stones of an arch, their outlines along the wall [x, z], anticlockwise as seen along y (m), and what the arch takes of the rows.
type Made = (Vec<Vec<Vec2>>, Vec<Gap>);

impl Builder<'_> {
    /// The arch over an opening; `None` after an error. `spring`: the row from which it springs.
    pub(super) fn arch_of_wall(
        &mut self,
        wall: &Masonry,
        opening: &WallOpening,
        said: &OpeningArch,
        spring: u64,
    ) -> Option<Made> {
        let high = wall.brick[2].si();
        let rows = self.whole_rows(said.height.si(), high, &said.height.span)?;
        let (width, rise) = (opening.width.si(), said.rise.si());
        let segmental = rise <= STEEPEST * width;
        let pointed = rise > 0.5 * width * (1.0 + WHOLE);
        let round = !pointed && rise >= 0.5 * width * (1.0 - WHOLE);
        let count = said.voussoirs;
        let made = if said.height.si() <= rise * (1.0 + WHOLE) {
            Err((
                &said.height,
                "the arch has no thickness at its crown".to_owned(),
                "give a smaller `rise`, or a `height` of more rows",
            ))
        } else if segmental {
            Ok(segmental_arch(opening, said, spring, [rows as f64 * high, high]))
        } else if !round && !pointed {
            let [wide, most, half] = [1.0, STEEPEST, 0.5].map(|f| with_unit(f * width, "m"));
            Err((
                &said.rise,
                format!(
                    "an arch {wide} wide rises by at most {most}, or by {half} (round) or more (pointed)"
                ),
                "between them bricks beside the arch would be too thin where it springs",
            ))
        } else if count < 2 || pointed && count % 2 == 1 {
            Err((
                &said.rise,
                format!("{count} stones make no such arch"),
                "a round arch has two `voussoirs` or more, a pointed one, with a joint at its crown, an even number",
            ))
        } else {
            stepped_arch(opening, said, spring, (rows, high)).ok_or_else(|| {
                let help = "give a larger `height`, another number of `voussoirs`, or lower bricks";
                (&said.height, "the steps of the arch do not fit the rows".to_owned(), help)
            })
        };
        match made {
            Ok(made) => Some(made),
            Err((at, fault, help)) => {
                self.error_at("wall.arch", at.span.clone(), fault, help);
                None
            }
        }
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

/// With the width w and the rise f the underside is of the radius r = (w^2/4 + f^2)/(2 f), its centre lies r - f below the springing. All joints meet there and
/// end at the level top. The stones have plane undersides, with their corners on the circle.
fn segmental_arch(
    opening: &WallOpening,
    said: &OpeningArch,
    spring: u64,
    [height, high]: [f64; 2],
) -> Made {
    let (width, rise) = (opening.width.si(), said.rise.si());
    let rows = (height / high).round() as u64;
    let radius = (0.25 * width * width + rise * rise) / (2.0 * rise);
    let half = libm::asin(0.5 * width / radius);
    let middle = opening.left.si() + 0.5 * width;
    let foot = spring as f64 * high;
    let centre = foot + rise - radius;
    // Where a joint meets a height, from the middle.
    let across = |angle: f64, up: f64| (up - centre) * libm::tan(angle);
    let top = foot + height;
    let count = said.voussoirs;
    let joint = |k: u32| {
        let angle = half * (2.0 * f64::from(k) / f64::from(count) - 1.0);
        let inner = Vec2::new(radius * libm::sin(angle), centre + radius * libm::cos(angle));
        [inner, Vec2::new(across(angle, top), top)].map(|p| Vec2::new(middle + p.x, p.y))
    };
    let stones = (0..count).map(|k| {
        let ([a, d], [b, c]) = (joint(k), joint(k + 1));
        vec![a, b, c, d]
    });
    let beside = (0..rows).map(|row| {
        let [low, up] = [row, row + 1].map(|r| across(half, foot + r as f64 * high));
        Gap {
            rows: [spring + row, spring + row + 1],
            along: [middle - up, middle + up],
            slant: up - low,
        }
    });
    (stones.collect(), beside.collect())
}

/// A joint of the right half of an arch: its ends from the middle of the springing line (m), and the row on whose top it ends.
#[derive(Clone, Copy)]
struct Joint {
    inner: Vec2,
    outer: Vec2,
    row: u64,
}

/// Joints of the right half of a round or a pointed arch, from its springing up. It has two arcs about centres on the springing line,
/// d = (f^2 - w^2/4)/w beyond the middle (round: d = 0). Joints are equal angles apart and end at the top of the row that is nearest to the outer arc,
/// which goes through the middle of the top. `None` where the arch would be too thin or too thick there, or
/// grow wider upwards.
fn joints_up([half, rise]: [f64; 2], count: u32, (rows, high): (u64, f64)) -> Option<Vec<Joint>> {
    let top = rows as f64 * high;
    let beyond = ((rise * rise - half * half) / (2.0 * half)).max(0.0);
    let [inside, outside] = [half + beyond, libm::sqrt(beyond * beyond + top * top)];
    let [thin, thick] = THICKNESS.map(|share| inside + share * (outside - inside));
    let crown = Joint { inner: Vec2::new(0.0, rise), outer: Vec2::new(0.0, top), row: rows };
    // From the crown down: a joint ends no higher, and no nearer to the middle, than the next one.
    let (mut joints, mut above) = (Vec::new(), crown);
    for k in (1..=count / 2).rev() {
        let angle = libm::atan2(rise, beyond) * 2.0 * f64::from(k) / f64::from(count);
        let (sin, cos) = (libm::sin(angle), libm::cos(angle));
        if 2 * k < count {
            let least = (thin * sin).max((above.outer.x + beyond) * sin / cos) / high;
            let row = (outside * sin / high).round().max((least - WHOLE).ceil()) as u64;
            let up = row as f64 * high;
            if row > above.row || up > thick * sin {
                return None;
            }
            let inner = Vec2::new(inside * cos - beyond, inside * sin);
            above = Joint { inner, outer: Vec2::new(up * cos / sin - beyond, up), row };
        }
        joints.push(above);
    }
    // The lowest stone has no step that is narrower than a third of its thickness.
    let (foot, least) = (outside - beyond, SHORTEST * (outside - inside));
    let foot = if foot < above.outer.x + least { above.outer.x } else { foot };
    joints.push(Joint { inner: Vec2::new(half, 0.0), outer: Vec2::new(foot, 0.0), row: 0 });
    joints.reverse();
    Some(joints)
}

/// A round or a pointed arch. A stone goes up from the end of its lower joint to the row of its upper one, and level from there.
fn stepped_arch(
    opening: &WallOpening,
    said: &OpeningArch,
    spring: u64,
    (rows, high): (u64, f64),
) -> Option<Made> {
    let half = 0.5 * opening.width.si();
    let joints = joints_up([half, said.rise.si()], said.voussoirs, (rows, high))?;
    let at = Vec2::new(opening.left.si() + half, spring as f64 * high);
    let mirrored = |outline: &[Vec2]| -> Vec<Vec2> {
        outline.iter().rev().map(|p| Vec2::new(-p.x, p.y)).collect()
    };
    let (mut stones, mut gaps) = (Vec::new(), Vec::new());
    let mut beside = |from: &Joint, to: u64| {
        let along = [at.x - from.outer.x, at.x + from.outer.x];
        if from.row < to {
            gaps.push(Gap { rows: [spring + from.row, spring + to], along, slant: 0.0 });
        }
    };
    for pair in joints.windows(2) {
        let [from, to] = [pair[0], pair[1]];
        let mut outline = vec![from.inner, from.outer];
        if to.row > from.row && to.outer.x < from.outer.x {
            outline.push(Vec2::new(from.outer.x, to.outer.y));
        }
        outline.extend([to.outer, to.inner]);
        stones.push(mirrored(&outline));
        stones.push(outline);
        beside(&from, to.row);
    }
    if said.voussoirs % 2 == 1 {
        let last = joints[joints.len() - 1];
        let mut key = vec![last.inner, last.outer];
        if last.row < rows {
            key.push(Vec2::new(last.outer.x, rows as f64 * high));
        }
        key.extend(mirrored(&key));
        stones.push(key);
        beside(&last, rows);
    }
    let placed = stones.iter().map(|outline| outline.iter().map(|p| at + *p).collect());
    Some((placed.collect(), gaps))
}
