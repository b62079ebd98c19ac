//! Pins that fields are read between: which block each of them moves with.

use riprap_geom::{Vec2, Vec3, polygon};

use super::builder::Builder;
use crate::plan::Pin;
use crate::scenario::quantity::{Length, Vector};
use crate::scenario::read::with_unit;
use crate::scenario::vectors::InSpace;
use crate::scenario::{Diagnostic, Name};
use crate::spatial::setup::{Shape, Solid};

/// What is nearer to a block than this share of its size lies on it.
const ON: f64 = 1e-6;

impl Builder<'_> {
    /// The pins of a field, and the blocks that they move with; `None` after an error. `base`: the field without component.
    pub(super) fn pins(
        &mut self,
        name: &Name,
        base: &str,
        said: &[Vector<Length>; 2],
    ) -> Option<[Pin; 2]> {
        if !Pin::FIELDS.contains(&base) {
            let message = format!("`{name}` is not read between two pins");
            let help =
                format!("`pins` applies to {}", Pin::FIELDS.map(|f| format!("`{f}`")).join(", "));
            self.error_at("field.pins", said[0].span.clone(), message, help);
            return None;
        }
        let there = self.never_removed();
        let [a, b] = [self.pin(&said[0], &there), self.pin(&said[1], &there)];
        let pins = [a?, b?];
        if pins[0].at == pins[1].at {
            let message = "both pins are at the same place";
            self.error_at("field.pins", said[1].span.clone(), message, "give two different points");
            return None;
        }
        Some(pins)
    }

    /// Blocks that no phase removes: a pin on the wall of a tunnel is in the rock that stays.
    fn never_removed(&self) -> Vec<bool> {
        let mut there = vec![true; self.spatial.blocks.len().max(self.setup.blocks.len())];
        for phase in &self.parsed.scenario.phases {
            for b in self.directory.all(&phase.remove).unwrap_or_default() {
                there[b as usize] = false;
            }
        }
        there
    }

    /// The block that a point lies on or nearest to, the first of several.
    fn pin(&mut self, said: &Vector<Length>, there: &[bool]) -> Option<Pin> {
        let at = match self.space {
            InSpace::Planar => {
                let [x, y] = said.xy();
                Vec3::new(x - self.origin.x, y - self.origin.y, 0.0)
            }
            InSpace::Spatial => Vec3::from(self.local3(said.xyz())),
        };
        let count = there.len() as u32;
        let mut best: Option<([f64; 2], u32)> = None;
        for block in (0..count).filter(|b| there[*b as usize]) {
            let Some([distance, size]) = self.off(block, at) else { continue };
            // Round-off does not choose among those that share the point.
            let distance = if distance <= ON * size { 0.0 } else { distance };
            if best.is_none_or(|([least, _], _)| distance < least) {
                best = Some(([distance, size], block));
            }
        }
        let Some(([distance, size], block)) = best else {
            let message = "there is no block that a pin could move with";
            let help = "all blocks are removed by phases, or are terrain";
            self.error_at("field.pins", said.span.clone(), message, help);
            return None;
        };
        let (name, far) = (self.directory.name(block), with_unit(distance, "m"));
        if distance > size {
            let message = format!("the pin is {far} from the nearest block that stays, `{name}`");
            let help =
                "give a point on or near the wall, at the start, in the coordinates of the scene";
            self.error_at("field.pins", said.span.clone(), message, help);
            return None;
        }
        if distance > 0.0 {
            let message = format!("the pin is {far} off the rock; it moves with `{name}`");
            let note = Diagnostic::warning("field.pins", message);
            self.found.push(note.at(said.span.clone()));
        }
        Some(Pin { block, at: at.to_array() })
    }

    /// How far a point is from a block (0 inside), and the size of this, m.
    fn off(&self, block: u32, at: Vec3) -> Option<[f64; 2]> {
        let b = block as usize;
        if self.space == InSpace::Planar {
            let corners = &self.setup.blocks[b].vertices;
            let size = libm::sqrt(polygon::mass_properties(corners).area);
            let at = Vec2::new(at.x, at.y);
            if polygon::contains(corners, at) {
                return Some([0.0, size]);
            }
            let ends = corners.iter().zip(corners.iter().cycle().skip(1));
            let gaps = ends.map(|(p, q)| {
                let share = (at - *p).dot(*q - *p) / p.distance_squared(*q);
                at.distance(p.lerp(*q, share.clamp(0.0, 1.0)))
            });
            return Some([gaps.fold(f64::INFINITY, f64::min), size]);
        }
        match &self.spatial.blocks[b].shape {
            Shape::Brick { centre, half } => {
                let out = ((at - *centre).abs() - *half).max(Vec3::ZERO);
                Some([out.length(), 2.0 * half.max_element()])
            }
            Shape::Polyhedron(solid) => Some(off_convex(solid, at)),
            Shape::Glued(parts) => {
                let all = parts.iter().map(|part| off_convex(part, at));
                all.min_by(|a, b| a[0].total_cmp(&b[0]))
            }
            Shape::Terrain(_) => None,
        }
    }
}

/// Largest height of a point over the planes of the faces, 0 inside, and the largest distance from corner to corner along an axis, m.
fn off_convex(solid: &Solid, at: Vec3) -> [f64; 2] {
    let height = |face: &Vec<u32>| {
        let corner = |k: usize| solid.vertices[face[k] as usize];
        let normal = (corner(1) - corner(0)).cross(corner(2) - corner(0)).normalize_or_zero();
        normal.dot(at - corner(0))
    };
    let out = solid.faces.iter().map(height).fold(0.0, f64::max);
    let (mut low, mut high) = (Vec3::INFINITY, Vec3::NEG_INFINITY);
    for corner in &solid.vertices {
        (low, high) = (low.min(*corner), high.max(*corner));
    }
    [out, (high - low).max_element()]
}
