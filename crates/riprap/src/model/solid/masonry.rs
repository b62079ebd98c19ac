//! Walls with openings and buttresses, vaults, domes.

use std::f64::consts::TAU;

use riprap_geom::shapes::{Arch, arch};
use riprap_geom::{Vec2, Vec3};

use super::global;
use super::mesh::Made;
use crate::model::builder::Builder;
use crate::scenario::language::{
    self, Block, Buttress, Dome, MasonryBond, Vault, VaultBond, WallOpening, span_of,
};
use crate::scenario::read::with_unit;
use crate::scenario::{Quantity, Span};
use crate::spatial::setup::{Shape, Solid};

/// A height is whole rows if it is so to this share of a row.
pub(super) const WHOLE: f64 = 1e-6;
/// Bricks are not cut shorter than this share; their neighbours are longer instead.
pub(super) const SHORTEST: f64 = 0.3;

/// Most stones of one table.
const MOST: f64 = 1e6;

/// What interrupts the rows of a wall: an opening or a lintel.
pub(super) struct Gap {
    /// Rows, the first and the one behind the last.
    pub(super) rows: [u64; 2],
    /// From where to where along the wall, m; of what is narrower below at the top of its row.
    pub(super) along: [f64; 2],
    /// How much farther bricks on both sides reach into it at the bottom of the row, m.
    pub(super) slant: f64,
}

/// Pieces of a row between its ends and what interrupts it: `first` is the length of the first brick, `brick` that of the others, m.
fn pieces(length: f64, first: f64, brick: f64, mut gaps: Vec<[f64; 2]>) -> Vec<[f64; 2]> {
    gaps.sort_by(|a, b| a[0].total_cmp(&b[0]));
    gaps.push([length, length]);
    let least = SHORTEST * brick;
    let (mut all, mut from) = (Vec::new(), 0.0);
    for [gap, behind] in gaps {
        let mut start = from;
        // The last joint that may still come before the gap.
        let most = ((length - first) / brick).ceil().max(0.0) as u64;
        for k in 0..=most {
            let joint = first + k as f64 * brick;
            if joint > start + least && joint < gap - least {
                all.push([start, joint]);
                start = joint;
            }
        }
        if gap - start > WHOLE * brick {
            all.push([start, gap]);
        }
        from = behind;
    }
    all
}

/// The rows of a wall.
struct Rows {
    /// Lowest corner, m.
    corner: Vec3,
    /// m.
    length: f64,
    /// Length, thickness and height of a brick, m.
    brick: [f64; 3],
    leaves: u64,
    bond: MasonryBond,
}

impl Rows {
    /// A brick from where to where along and across the wall, m, and in rows.
    fn brick(&self, [x0, x1]: [f64; 2], [y0, y1]: [f64; 2], [r0, r1]: [u64; 2]) -> Shape {
        let high = self.brick[2];
        let low = self.corner + Vec3::new(x0, y0, r0 as f64 * high);
        let top = self.corner + Vec3::new(x1, y1, r1 as f64 * high);
        Shape::Brick { centre: 0.5 * (low + top), half: 0.5 * (top - low) }
    }

    /// A brick of a row; beside an arch it reaches farther at its foot.
    fn beside(&self, piece: [f64; 2], across: [f64; 2], row: u64, gaps: &[&Gap]) -> Shape {
        let slant = |k: usize| {
            gaps.iter().find(|gap| gap.along[1 - k] == piece[k]).map_or(0.0, |gap| gap.slant)
        };
        let slants = [0, 1].map(slant);
        if slants == [0.0; 2] {
            return self.brick(piece, across, [row, row + 1]);
        }
        let [low, up] = [row, row + 1].map(|r| r as f64 * self.brick[2]);
        let feet = [piece[0] - slants[0], piece[1] + slants[1]];
        let outline = [(feet[0], low), (feet[1], low), (piece[1], up), (piece[0], up)];
        prism(&outline.map(|(x, z)| across.map(|y| self.corner + Vec3::new(x, y, z))))
    }

    /// The bricks of a row between what interrupts it.
    fn row(&self, row: u64, gaps: &[Gap]) -> Vec<Shape> {
        let [long, thick, _] = self.brick;
        let odd = row % 2 == 1;
        let here = gaps.iter().filter(|gap| (gap.rows[0]..gap.rows[1]).contains(&row));
        let here: Vec<&Gap> = here.collect();
        let headers = odd && self.bond == MasonryBond::English;
        let (first, step) = match self.bond {
            // Joints over the middle of stretchers and headers: a closer at the ends.
            _ if headers => (0.5 * thick, thick),
            MasonryBond::Running if odd => (0.5 * long, long),
            MasonryBond::Running | MasonryBond::Stack | MasonryBond::English => (long, long),
        };
        let along = here.iter().map(|gap| gap.along).collect();
        let mut shapes = Vec::new();
        for piece in pieces(self.length, first, step, along) {
            let through = [0.0, thick * self.leaves as f64];
            if headers {
                shapes.push(self.beside(piece, through, row, &here));
                continue;
            }
            for leaf in 0..self.leaves {
                let across = [leaf, leaf + 1].map(|k| k as f64 * thick);
                shapes.push(self.beside(piece, across, row, &here));
            }
        }
        shapes
    }
}

impl Builder<'_> {
    /// Bricks and lintels of a wall, in local coordinates; `None` after an error.
    pub(super) fn masonry(
        &mut self,
        block: &Block,
        wall: &language::Masonry,
        shift: Vec3,
    ) -> Option<Made> {
        let corner = wall.corner.as_ref().map_or(Vec3::ZERO, global) + shift;
        let [long, thick, high] = wall.brick.each_ref().map(Quantity::si);
        let length = wall.length.si();
        let mut read = self.reading(format!("blocks.{}.masonry", block.name), wall);
        let (leaves, bond) = (read.leaves(), read.bond());
        let count = (length / long + 1.0) * wall.courses as f64 * leaves as f64;
        if count > MOST {
            let message = format!("the wall `{}` would have about {count:.0} bricks", block.name);
            let help = "use larger bricks, or a smaller wall";
            self.error_at("geometry.count", &block.name, message, help);
            return None;
        }
        if !self.has_memory(block, count, &wall.length.span) {
            return None;
        }
        let depth = thick * leaves as f64;
        let rows = Rows { corner, length, brick: [long, thick, high], leaves, bond };
        let (mut gaps, mut arches) = (Vec::new(), Vec::new());
        let (mut lintels, mut voussoirs) = (Vec::new(), Vec::new());
        for opening in &wall.openings {
            let of = self.opening_of_wall(wall, opening, [length, high])?;
            if let Some(lintel) = of.get(1) {
                lintels.push(rows.brick(lintel.along, [0.0, depth], lintel.rows));
            }
            let spring = of[0].rows[1];
            gaps.extend(of);
            if let Some(said) = &opening.arch {
                let (stones, beside) = self.arch_of_wall(wall, opening, said, spring)?;
                let place = |p: &Vec2| [0.0, depth].map(|y| corner + Vec3::new(p.x, y, p.y));
                voussoirs
                    .extend(stones.iter().map(|o| prism(&o.iter().map(place).collect::<Vec<_>>())));
                arches.extend(beside);
            }
        }
        self.arches_are_apart(wall, &gaps, &arches)?;
        gaps.extend(arches);
        let mut piers = Vec::new();
        for said in &wall.buttresses {
            let (stones, headers) = self.buttress(wall, said, &gaps, [depth, high])?;
            piers.extend(stones.iter().map(|outline| {
                let ends = |p: Vec2| {
                    [0.0, said.width.si()].map(|x| corner + Vec3::new(said.left.si() + x, p.x, p.y))
                };
                prism(&outline.map(ends))
            }));
            gaps.extend(headers);
        }
        let mut shapes: Vec<Shape> =
            (0..wall.courses).flat_map(|row| rows.row(row, &gaps)).collect();
        let bricks = shapes.len() as u32;
        let beams = (bricks..bricks + lintels.len() as u32).collect();
        shapes.extend(lintels);
        let behind = shapes.len() as u32;
        let leaning = (behind..behind + piers.len() as u32).collect();
        shapes.extend(piers);
        let behind = shapes.len() as u32;
        let wedges: Vec<u32> = (behind..behind + voussoirs.len() as u32).collect();
        shapes.extend(voussoirs);
        let mut made = Made::of(shapes);
        if !wall.openings.is_empty() {
            made.groups.push((format!("{}_lintels", block.name), beams));
        }
        if !wedges.is_empty() {
            made.groups.push((format!("{}_arches", block.name), wedges));
        }
        if !wall.buttresses.is_empty() {
            made.groups.push((format!("{}_buttresses", block.name), leaning));
        }
        Some(made)
    }

    /// A height (m) in rows of the height `high` (m); `None` after an error.
    pub(super) fn whole_rows(&mut self, height: f64, high: f64, span: &Span) -> Option<u64> {
        let count = height / high;
        let whole = count.round();
        if (count - whole).abs() <= WHOLE {
            return Some(whole as u64);
        }
        let message = format!("{} are {count:.6} rows", with_unit(height, "m"));
        let fits = [count.floor(), count.floor() + 1.0].map(|n| with_unit(n * high, "m"));
        let help = format!("give a height of whole rows: {} or {}", fits[0], fits[1]);
        self.error_at("wall.rows", span.clone(), message, help);
        None
    }

    /// Outlines of the stones of a buttress across the wall, [y, z] anticlockwise as seen along x (m), and what its headers take of the
    /// rows of the wall; `None` after an error.
    fn buttress(
        &mut self,
        wall: &language::Masonry,
        said: &Buttress,
        gaps: &[Gap],
        [depth, high]: [f64; 2],
    ) -> Option<(Vec<[Vec2; 4]>, Vec<Gap>)> {
        let rows = match &said.height {
            Some(height) => self.whole_rows(height.si(), high, &height.span)?,
            None => wall.courses,
        };
        let (foot, top) = (said.foot.si(), said.top.si());
        let along = [said.left.si(), said.left.si() + said.width.si()];
        let meets =
            |gap: &Gap| gap.rows[0] < rows && gap.along[0] < along[1] && gap.along[1] > along[0];
        let fault = if along[1] > wall.length.si() * (1.0 + WHOLE) || rows > wall.courses {
            Some("a buttress reaches beyond the wall")
        } else if gaps.iter().any(meets) {
            Some("a buttress stands before an opening, a lintel or another buttress")
        } else if top > foot {
            Some("a buttress is deeper at its top than at its foot")
        } else {
            None
        };
        if let Some(fault) = fault {
            let help = "change `left`, `width`, `height`, `foot` or `top` of the buttress";
            self.error_at("wall.buttress", said.left.span.clone(), fault.to_owned(), help);
            return None;
        }
        let headers = |row: u64| row % 2 == 1;
        let outlines = (0..rows).map(|row| {
            let [low, up] = [row, row + 1].map(|r| r as f64 / rows as f64);
            let [z0, z1] = [row, row + 1].map(|r| r as f64 * high);
            let [y0, y1] = [low, up].map(|share| -(foot + share * (top - foot)));
            let inner = if headers(row) { depth } else { 0.0 };
            // Seen along x, y points to the left.
            [Vec2::new(y0, z0), Vec2::new(y1, z1), Vec2::new(inner, z1), Vec2::new(inner, z0)]
        });
        let taken = (0..rows).filter(|row| headers(*row));
        let taken = taken.map(|row| Gap { rows: [row, row + 1], along, slant: 0.0 });
        Some((outlines.collect(), taken.collect()))
    }

    /// An opening, and the lintel over it; `None` after an error.
    fn opening_of_wall(
        &mut self,
        wall: &language::Masonry,
        said: &WallOpening,
        [length, high]: [f64; 2],
    ) -> Option<Vec<Gap>> {
        let mut rows = |height: f64, span: &Span| self.whole_rows(height, high, span);
        let sill = match &said.sill {
            Some(sill) => rows(sill.si(), &sill.span)?,
            None => 0,
        };
        let top = sill + rows(said.height.si(), &said.height.span)?;
        let (left, right) = (said.left.si(), said.left.si() + said.width.si());
        let mut all = vec![Gap { rows: [sill, top], along: [left, right], slant: 0.0 }];
        if let Some(lintel) = &said.lintel {
            let over = top + rows(lintel.height.si(), &lintel.height.span)?;
            let bearing = lintel.bearing.si();
            let along = [left - bearing, right + bearing];
            all.push(Gap { rows: [top, over], along, slant: 0.0 });
        }
        let slack = WHOLE * length;
        let inside = |gap: &Gap| {
            gap.along[0] >= -slack && gap.along[1] <= length + slack && gap.rows[1] <= wall.courses
        };
        if !all.iter().all(inside) {
            let message = "an opening, or its lintel, reaches beyond the wall".to_owned();
            let size = with_unit(wall.courses as f64 * high, "m");
            let help = format!("the wall is {} long and {size} high", with_unit(length, "m"));
            self.error_at("wall.opening", said.left.span.clone(), message, help);
            return None;
        }
        Some(all)
    }

    /// The stones of a vault, in local coordinates; `None` after an error.
    pub(super) fn vault(&mut self, block: &Block, said: &Vault, shift: Vec3) -> Option<Vec<Shape>> {
        let (from, to) = (global(&said.from) + shift, global(&said.to) + shift);
        let along = to - from;
        let across = along.cross(Vec3::Z);
        let length = along.length();
        // Also false where the ends are one point.
        let level = across.length() > 0.0 && along.z.abs() <= WHOLE * length;
        if !level {
            let message = format!("the axis of the vault `{}` is not level", block.name);
            let help =
                "give `from` and `to` the same z, and different places; `rotate` turns a vault";
            self.error_at("geometry.vault", span_of(&said.to), message, help);
            return None;
        }
        let mut read = self.reading(format!("blocks.{}.vault", block.name), said);
        let (rings, bond) = (read.rings(), read.bond());
        let count = f64::from(said.voussoirs) * f64::from(rings);
        if count > MOST {
            let message = format!("the vault `{}` would have {count:.0} stones", block.name);
            self.error_at("geometry.count", &block.name, message, "use fewer stones");
            return None;
        }
        if !self.has_memory(block, count, &block.name.span) {
            return None;
        }
        let outlines = arch(&Arch {
            centre: Vec2::ZERO,
            radius: said.radius.si(),
            thickness: said.thickness.si(),
            half_angle: said.half_angle.si(),
            voussoirs: said.voussoirs as usize,
        });
        let outlines = match outlines {
            Ok(outlines) => outlines,
            Err(error) => {
                let message = format!("block `{}`: {error}", block.name);
                let help = "check radius, thickness and their units";
                self.error_at("value.range", &block.name, message, help);
                return None;
            }
        };
        let [across, along] = [across.normalize(), along / length];
        let place = |p: Vec2, distance: f64| from + p.x * across + p.y * Vec3::Z + distance * along;
        let stone = length / f64::from(rings);
        let mut shapes = Vec::new();
        for (row, outline) in outlines.iter().enumerate() {
            let half = row % 2 == 1 && bond == VaultBond::Running;
            let first = if half { 0.5 * stone } else { stone };
            for [start, end] in pieces(length, first, stone, Vec::new()) {
                let ends = outline.iter().map(|p| [place(*p, start), place(*p, end)]);
                shapes.push(prism(&ends.collect::<Vec<_>>()));
            }
        }
        Some(shapes)
    }

    /// The stones of a dome, in local coordinates, from its crown down: frusta of pyramids with their tip at the centre, whose faces are plane.
    pub(super) fn dome(&mut self, block: &Block, said: &Dome, shift: Vec3) -> Option<Vec<Shape>> {
        let (rings, around) = (said.rings, said.voussoirs);
        let count = f64::from(rings) * f64::from(around);
        if count > MOST {
            let message = format!("the dome `{}` would have {count:.0} stones", block.name);
            self.error_at("geometry.count", &block.name, message, "use fewer stones");
            return None;
        }
        if !self.has_memory(block, count, &block.name.span) {
            return None;
        }
        let centre = said.centre.as_ref().map_or(Vec3::ZERO, global) + shift;
        let half = 0.5 * said.thickness.si();
        let radii = [said.radius.si() - half, said.radius.si() + half];
        let spring = said.half_angle.si();
        let key = 0.5 * spring / (f64::from(rings) + 0.5);
        let crown = said.oculus.as_ref().map_or(key, Quantity::si);
        // A corner of a ring's upper edge, inside and outside.
        let ends = |ring: u32, k: u32| {
            let polar = crown + (spring - crown) * f64::from(ring) / f64::from(rings);
            let azimuth = TAU * f64::from(k % around) / f64::from(around);
            let level = libm::sin(polar);
            let [x, y] = [libm::cos(azimuth), libm::sin(azimuth)].map(|part| level * part);
            radii.map(|radius| centre + radius * Vec3::new(x, y, libm::cos(polar)))
        };
        let mut shapes = Vec::new();
        if said.oculus.is_none() {
            let rim: Vec<[Vec3; 2]> = (0..around).rev().map(|k| ends(0, k)).collect();
            shapes.push(prism(&rim));
        }
        for ring in 0..rings {
            for k in 0..around {
                let stone = [(ring, k), (ring, k + 1), (ring + 1, k + 1), (ring + 1, k)];
                shapes.push(prism(&stone.map(|(ring, k)| ends(ring, k))));
            }
        }
        Some(shapes)
    }
}

/// A prism or a frustum: places of the corners of its two ends (m), anticlockwise as seen from the first end to the second.
fn prism(corners: &[[Vec3; 2]]) -> Shape {
    let n = corners.len() as u32;
    let vertices = corners.iter().map(|c| c[0]).chain(corners.iter().map(|c| c[1])).collect();
    let mut faces = vec![(0..n).collect(), (n..2 * n).rev().collect()];
    for k in 0..n {
        let next = (k + 1) % n;
        faces.push(vec![k, k + n, next + n, next]);
    }
    Shape::Polyhedron(Box::new(Solid { vertices, faces }))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_are_cut_to_their_ends_and_openings() {
        let plain = pieces(1.0, 0.4, 0.4, Vec::new());
        // The rest of 0.2 is half a brick.
        assert_eq!(plain, [[0.0, 0.4], [0.4, 0.8], [0.8, 1.0]]);
        // A rest of a quarter goes to its neighbour.
        assert_eq!(pieces(0.9, 0.4, 0.4, Vec::new()), [[0.0, 0.4], [0.4, 0.9]]);
        let shifted = pieces(1.2, 0.2, 0.4, vec![[0.5, 0.9]]);
        assert_eq!(shifted, [[0.0, 0.2], [0.2, 0.5], [0.9, 1.2]]);
        assert_eq!(pieces(1.0, 0.4, 0.4, vec![[0.0, 1.0]]), Vec::<[f64; 2]>::new());
    }
}
