//! Water tables, and which of them stands in a phase.

use super::builder::Builder;
use crate::laws::seepage::{self, Steady};
use crate::laws::water::WaterTable;
use crate::scenario::language::{self, Phase, Seepage, Side, Space, Water};
use crate::scenario::read::Provenance;
use crate::scenario::vectors::InSpace;
use crate::scenario::{Diagnostic, NO_WATER, Quantity, Span};
use crate::spatial::setup::Shape;
use riprap_geom::Vec3;

/// A component of a direction below this is round-off of its angle.
const ROUND_OFF: f64 = 1e-15;

impl Builder<'_> {
    /// All water tables; the blocks must be known.
    pub(super) fn water(&mut self) {
        let scenario = &self.parsed.scenario;
        if scenario.water.is_empty() {
            return;
        }
        self.vertical_gravity();
        let (origin, height) = match self.space {
            InSpace::Planar => ([self.origin.x, 0.0], self.origin.y),
            InSpace::Spatial => {
                let o = self.spatial.origin;
                ([o.x, o.y], o.z)
            }
        };
        for (name, said) in scenario.water.iter() {
            let density = self.reading(format!("water.{name}"), said).density();
            let along = self.along(name.as_str(), said);
            let shift = along[0] * origin[0] + along[1] * origin[1];
            let corner = |[d, z]: &[Quantity<_>; 2]| [d.si() - shift, z.si() - height];
            let points = match (&said.level, &said.points) {
                (Some(level), _) => vec![[0.0, level.si() - height]],
                (None, Some(points)) => points.iter().map(corner).collect(),
                // Reported by the rules of the language.
                (None, None) => continue,
            };
            let seepage = said
                .seepage
                .as_ref()
                .map(|s| self.seepage(name.as_str(), s));
            let tables = match self.space {
                InSpace::Planar => &mut self.setup.water,
                InSpace::Spatial => &mut self.spatial.water,
            };
            tables.push(WaterTable {
                name: name.text.clone(),
                density,
                along,
                points,
                seepage,
            });
        }
    }

    /// Rules of seepage in the plane.
    fn seepage(&mut self, name: &str, said: &Seepage) -> Steady {
        let mut read = self.reading(format!("water.{name}.seepage"), said);
        let aperture = said.aperture.si();
        let (from, why) = (Provenance::Derived, "of `aperture`");
        let least = read.aperture_min_or(0.1 * aperture, from, why);
        let most = read.aperture_max_or(10.0 * aperture, from, why);
        let (viscosity, every) = (read.viscosity(), read.every());
        let (low, high) = self.extent();
        let side = |word: &Side| {
            let (axis, at) = match word {
                Side::XMin => (0, low.x),
                Side::XMax => (0, high.x),
                Side::YMin => (1, low.y),
                Side::YMax => (1, high.y),
                // Refused by the rules of the language.
                Side::ZMin | Side::ZMax => return None,
            };
            Some(seepage::Side { axis, at })
        };
        let closed = said.closed.as_deref().unwrap_or(&[Side::YMin]);
        let drain = |said: &language::Drain| seepage::Drain {
            from: self.point(&said.from).into(),
            to: self.point(&said.to).into(),
            head: said.head.as_ref().map(|h| h.si() - self.origin.y),
        };
        Steady {
            viscosity,
            aperture,
            limits: [least, most],
            every,
            closed: closed.iter().filter_map(side).collect(),
            drains: said.drains.iter().map(drain).collect(),
        }
    }

    fn along(&mut self, name: &str, said: &Water) -> [f64; 2] {
        let direction = match (&said.azimuth, self.space) {
            (Some(azimuth), _) => {
                let (sin, cos) = libm::sincos(azimuth.si());
                return [sin, cos].map(|c| if c.abs() < ROUND_OFF { 0.0 } else { c });
            }
            (None, InSpace::Planar) => return [1.0, 0.0],
            (None, InSpace::Spatial) => [1.0, 0.0],
        };
        if said.points.is_some() {
            let key = format!("water.{name}.azimuth");
            self.explain(key, "90 deg", Provenance::Default, "");
        }
        direction
    }

    /// Water stands level under gravity alone: its direction must be that of the heights.
    fn vertical_gravity(&mut self) {
        let scenario = &self.parsed.scenario;
        let first = scenario.water.iter().next().map(|(name, _)| &name.span);
        let Some(span) = first else {
            return;
        };
        let start = match self.space {
            InSpace::Planar => [self.setup.gravity[0], self.setup.gravity[1], 0.0],
            InSpace::Spatial => self.spatial.gravity.into(),
        };
        let later = scenario.phases.iter().filter_map(|p| p.gravity.as_ref());
        let mut all = vec![start];
        all.extend(later.map(|g| self.gravity(g)));
        let up = match (&scenario.space, self.space) {
            (Space::Planar(_), _) | (_, InSpace::Planar) => 1,
            (Space::Spatial(_), InSpace::Spatial) => 2,
        };
        let slanted = |g: &[f64; 3]| (0..3).any(|k| k != up && g[k] != 0.0);
        if all.iter().any(|g| slanted(g) || g[up] > 0.0) {
            let axis = ["y", "z"][up - 1];
            let error = Diagnostic::error(
                "water.gravity",
                format!("water needs gravity that points down, along -{axis}"),
            );
            let help = "leave out `tilt` and the other components of `gravity`, here and in phases, or the water";
            self.found.push(error.at(span.clone()).help(help));
        }
    }

    /// What a phase changes: the first one sets the only table unless it says otherwise.
    pub(super) fn table_of(&self, said: &Phase) -> Option<Option<u16>> {
        let scenario = &self.parsed.scenario;
        let first = scenario.phases.first().is_some_and(|p| p.name == said.name);
        let number = |name: &str| scenario.water.names().position(|one| one == name);
        match &said.water {
            Some(name) if name.as_str() == NO_WATER => Some(None),
            Some(name) => Some(number(name.as_str()).map(|k| k as u16)),
            None if first && scenario.water.len() == 1 => Some(Some(0)),
            None => None,
        }
    }

    /// Warns of tables below which there is nothing; one that seeps there is an error.
    pub(super) fn dry_tables(&mut self) {
        let corners = self.corners();
        let tables = match self.space {
            InSpace::Planar => &self.setup.water,
            InSpace::Spatial => &self.spatial.water,
        };
        let dry = |t: &WaterTable| {
            let below = |c: &Vec3| t.height(t.distance(c.x, c.y)) > c.z;
            !corners.iter().any(below)
        };
        let spans: Vec<(String, Span, bool)> = tables
            .iter()
            .filter(|t| dry(t))
            .filter_map(|t| {
                let said = self.parsed.scenario.water.iter();
                let mut named = said.filter(|(name, _)| name.as_str() == t.name);
                Some((
                    t.name.clone(),
                    named.next()?.0.span.clone(),
                    t.seepage.is_some(),
                ))
            })
            .collect();
        for (name, span, seeps) in spans {
            let message = format!("water.{name} has no effect: it lies below all blocks");
            let help = "heights are along y in the plane and along z in space; check the units";
            let note = if seeps {
                Diagnostic::error("water.dry", message)
            } else {
                Diagnostic::warning("water.dry", message)
            };
            self.found.push(note.at(span).help(help));
        }
    }

    /// Corners of all blocks, in the plane with the height as z, local, m.
    fn corners(&self) -> Vec<Vec3> {
        let flat = self.setup.blocks.iter().flat_map(|b| &b.vertices);
        let mut corners: Vec<Vec3> = flat.map(|v| Vec3::new(v.x, 0.0, v.y)).collect();
        for block in &self.spatial.blocks {
            match &block.shape {
                Shape::Brick { centre, half } => corners.extend((0..8).map(|k| {
                    let sign = |bit: u32| if k & bit == 0 { -1.0 } else { 1.0 };
                    *centre + Vec3::new(sign(1), sign(2), sign(4)) * *half
                })),
                Shape::Polyhedron(solid) => corners.extend(&solid.vertices),
                Shape::Glued(parts) => {
                    corners.extend(parts.iter().flat_map(|part| &part.vertices));
                }
                Shape::Terrain(_) => {}
            }
        }
        corners
    }
}
