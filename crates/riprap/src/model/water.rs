//! Water tables, and which of them stands in a phase.

use super::builder::Builder;
use crate::laws::seepage::{self, Steady};
use crate::laws::water::{Grid, WaterTable, Zone};
use crate::scenario::language::{BoxRegion, Phase, Seepage, Side, Space, Water};
use crate::scenario::read::Provenance;
use crate::scenario::vectors::InSpace;
use crate::scenario::{Diagnostic, NO_WATER, Name, Names, Quantity, Span};
use crate::spatial::setup::{Shape, Solid};
use riprap_geom::polyhedron::BRICK_FACES;
use riprap_geom::{Vec2, Vec3};

/// A component of a direction below this is round-off of its angle.
const ROUND_OFF: f64 = 1e-15;
/// How far beyond its faces a zone reaches, over the size of the model: faces that lie in them are in it.
const SLACK: f64 = 1e-7;
/// Share of a face in two zones from which both claim it.
const CLAIMED: f64 = 1e-4;

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
            // Places of a table are distances along its direction, so the origin counts with its own.
            let shift = along[0] * origin[0] + along[1] * origin[1];
            let corner = |[d, z]: &[Quantity<_>; 2]| [d.si() - shift, z.si() - height];
            let (mut points, mut grid) = (Vec::new(), None);
            match (&said.level, &said.points, &said.csv) {
                (Some(level), ..) => points.push([0.0, level.si() - height]),
                (None, Some(said), _) => points.extend(said.iter().map(corner)),
                (None, None, Some(file)) => match self.heights(name, file) {
                    Some(read) => grid = Some(Box::new(read)),
                    None => continue,
                },
                // Reported by the rules of the language.
                (None, None, None) => continue,
            }
            let zone = said.within.as_ref().map(|said| self.zone(name, said));
            let seepage = said.seepage.as_ref().map(|s| self.seepage(name, s));
            let tables = match self.space {
                InSpace::Planar => &mut self.setup.water,
                InSpace::Spatial => &mut self.spatial.water,
            };
            tables.push(WaterTable {
                name: name.text.clone(),
                density,
                along,
                points,
                grid,
                zone,
                seepage,
                parts: Vec::new(),
            });
        }
    }

    /// A table from heights on a grid; `None` after an error.
    fn heights(&mut self, name: &Name, file: &Name) -> Option<Grid> {
        let shift = -self.spatial.origin;
        let read = self.grid_of_csv(file, shift, "file.water")?;
        let wide = read.x.len();
        if let Some(missing) = read.z.iter().position(Option::is_none) {
            let [x, y] = [read.x[missing % wide] - shift.x, read.y[missing / wide] - shift.y];
            let message = format!("`{file}` has no height at ({x} m, {y} m)");
            let help = "a water table needs a height at every point of its grid";
            self.error_at("file.water", file, message, help);
            return None;
        }
        if wide < 2 || read.y.len() < 2 {
            let message = format!("`{file}` has only one grid line");
            let help = "at least two grid lines are needed in x and in y";
            self.error_at("file.water", file, message, help);
            return None;
        }
        let grid = Grid { x: read.x, y: read.y, z: read.z.into_iter().flatten().collect() };
        let (low, high) = self.extent();
        let room = 1e-6 * (high - low).length();
        let ends = |list: &[f64]| list.first().copied().zip(list.last().copied());
        let short = [(ends(&grid.x), low.x, high.x), (ends(&grid.y), low.y, high.y)];
        let short = short.into_iter().filter_map(|(ends, low, high)| {
            let (first, last) = ends?;
            Some((first - low).max(high - last))
        });
        let short = short.fold(0.0, f64::max);
        if short > room {
            let message = format!("the grid of water.{name} ends {short:.3} m inside the model");
            let help = "beyond the grid the table keeps the height at its rim; give a larger grid";
            self.warn_at("water.extent", file.span.clone(), message, help);
        }
        Some(grid)
    }

    /// Where a table acts, with room for faces that lie in its surface.
    fn zone(&mut self, name: &Name, said: &BoxRegion) -> Zone {
        let (min, max) = (said.min.xyz(), said.max.xyz());
        let axes = match self.space {
            InSpace::Planar => 2,
            InSpace::Spatial => 3,
        };
        if (0..axes).any(|k| min[k] >= max[k]) {
            let message = format!("the box of water.{name} is empty");
            let help = "each coordinate of `min` must be below that of `max`";
            self.error_at("value.range", said.min.span.clone(), message, help);
        }
        let [low, high] = [min, max].map(|at| match self.space {
            InSpace::Planar => Vec3::new(at[0] - self.origin.x, 0.0, at[1] - self.origin.y),
            InSpace::Spatial => Vec3::from_array(at) - self.spatial.origin,
        });
        let (least, most) = self.extent();
        let mut slack = Vec3::splat(SLACK * (most - least).length());
        if axes == 2 {
            // Heights are z here and y is nothing: it must not bound.
            slack.y = f64::INFINITY;
        }
        Zone { low: low - slack, high: high + slack }
    }

    /// Rules of seepage.
    fn seepage(&mut self, name: &Name, said: &Seepage) -> Steady {
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
                // Refused in the plane by the rules of the language.
                Side::ZMin => (2, low.z),
                Side::ZMax => (2, high.z),
            };
            seepage::Side { axis, at }
        };
        let floor = match self.space {
            InSpace::Planar => &[Side::YMin],
            InSpace::Spatial => &[Side::ZMin],
        };
        let closed = said.closed.as_deref().unwrap_or(floor);
        let mut rules = Steady {
            viscosity,
            aperture,
            limits: [least, most],
            every,
            closed: closed.iter().map(side).collect(),
            ..Steady::default()
        };
        for drain in &said.drains {
            let [from, to] = [&drain.from, &drain.to].map(|at| Vec3::from_array(at.xyz()));
            let flat = |at: Vec3| [at.x - self.origin.x, at.y - self.origin.y];
            let head = |up: f64| drain.head.as_ref().map(|h| h.si() - up);
            match &drain.row_end {
                Some(end) => rules.curtains.push(seepage::Curtain {
                    from: (from - self.spatial.origin).into(),
                    hole: (to - from).into(),
                    row: (Vec3::from_array(end.xyz()) - from).into(),
                    head: head(self.spatial.origin.z),
                }),
                None => rules.drains.push(seepage::Drain {
                    from: flat(from),
                    to: flat(to),
                    head: head(self.origin.y),
                }),
            }
        }
        self.can_seep(name);
        rules
    }

    /// Refuses seepage in models in space that it does not know.
    fn can_seep(&mut self, name: &Name) {
        let soft = !self.spatial.deform.sets.is_empty();
        let periodic = self.spatial.periodic.iter().any(Option::is_some);
        let why = match (self.space, soft, periodic) {
            (InSpace::Spatial, true, _) => "models with deformable blocks",
            (InSpace::Spatial, _, true) => "periodic models",
            _ => return,
        };
        let message = format!("seepage of water.{name} is not possible in {why}");
        let help = "in space seepage needs rigid blocks and a model without periods; leave `seepage` out, and the table gives the head everywhere";
        self.error_at("water.seepage", name, message, help);
    }

    /// Direction in which distances grow, horizontal, length 1.
    fn along(&mut self, name: &str, said: &Water) -> [f64; 2] {
        // A level table and one of a grid have no distances.
        if self.space == InSpace::Planar || said.points.is_none() {
            return [1.0, 0.0];
        }
        let azimuth = self.reading(format!("water.{name}"), said).azimuth();
        let (sin, cos) = libm::sincos(azimuth);
        [sin, cos].map(|c| if c.abs() < ROUND_OFF { 0.0 } else { c })
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
            let help = "leave out `tilt` and the other components of `gravity`, here and in phases, or the water";
            let message = format!("water needs gravity along -{axis}");
            self.error_at("water.gravity", span.clone(), message, help);
        }
    }

    /// What a phase changes: the first one sets the only table unless it says otherwise.
    pub(super) fn table_of(&mut self, said: &Phase) -> Option<Option<u16>> {
        let scenario = &self.parsed.scenario;
        let first = scenario.phases.first().is_some_and(|p| p.name == said.name);
        match &said.water {
            Some(Names(names)) => match names.as_slice() {
                [name] if name.as_str() == NO_WATER => Some(None),
                [name] => Some(self.table_named(name)),
                names => Some(self.together(names)),
            },
            None if first && scenario.water.len() == 1 => Some(Some(0)),
            None => None,
        }
    }

    fn tables(&mut self) -> &mut Vec<WaterTable> {
        match self.space {
            InSpace::Planar => &mut self.setup.water,
            InSpace::Spatial => &mut self.spatial.water,
        }
    }

    fn table_named(&mut self, name: &Name) -> Option<u16> {
        let tables = self.tables().iter();
        // Several tables as one were made here and have no name that a phase could say.
        let single = tables.map(|t| t.parts.is_empty().then_some(t.name.as_str()));
        let number = single.into_iter().position(|one| one == Some(name.as_str()));
        number.map(|k| k as u16)
    }

    /// Several tables as one; no face may lie in the zones of two.
    fn together(&mut self, names: &[Name]) -> Option<u16> {
        let numbers: Option<Vec<u16>> = names.iter().map(|n| self.table_named(n)).collect();
        let tables = self.tables();
        let numbers = numbers?.into_iter();
        let parts: Vec<WaterTable> = numbers.map(|k| tables[usize::from(k)].clone()).collect();
        let everywhere = Zone { low: Vec3::NEG_INFINITY, high: Vec3::INFINITY };
        let faces = self.all_faces();
        for (k, later) in parts.iter().enumerate() {
            for (earlier, name) in parts[..k].iter().zip(names) {
                let [a, b] = [earlier, later].map(|t| t.zone.unwrap_or(everywhere));
                let Some(both) = a.common(&b) else {
                    continue;
                };
                if let Some((block, _)) = faces.iter().find(|(_, f)| claims(&both, f)) {
                    let block = self.directory.name(*block);
                    let message = format!(
                        "water tables `{name}` and `{}` both act on faces of block `{block}`",
                        names[k]
                    );
                    let help = "give each table a box (`within`) that shares no face with the boxes of the others";
                    self.error_at("water.claimed", names[k].span.clone(), message, help);
                    return None;
                }
            }
        }
        let name = names.iter().map(Name::as_str).collect::<Vec<_>>().join(", ");
        let whole = WaterTable { name, parts, ..WaterTable::default() };
        let tables = self.tables();
        let known = tables.iter().position(|t| *t == whole);
        if known.is_none() {
            tables.push(whole);
        }
        Some(known.unwrap_or(self.tables().len() - 1) as u16)
    }

    /// Faces of all blocks but terrain with their blocks, local, m; edges in the plane, with the height as z.
    fn all_faces(&self) -> Vec<(u32, Vec<Vec3>)> {
        let mut faces = Vec::new();
        for (b, block) in (0..).zip(&self.setup.blocks) {
            let up = |v: &Vec2| Vec3::new(v.x, 0.0, v.y);
            let n = block.vertices.len();
            let edge = |k: usize| vec![up(&block.vertices[k]), up(&block.vertices[(k + 1) % n])];
            faces.extend((0..n).map(|k| (b, edge(k))));
        }
        for (b, block) in (0..).zip(&self.spatial.blocks) {
            let of = |body: &Solid| {
                let outlines =
                    (0..body.faces.len()).map(|face| (b, body.polyhedron().outline(face)));
                outlines.collect::<Vec<_>>()
            };
            match &block.shape {
                Shape::Brick { centre, half } => {
                    let sign = |k: u8, bit: u8| if k & bit == 0 { -1.0 } else { 1.0 };
                    let corner =
                        |k: u8| *centre + Vec3::new(sign(k, 1), sign(k, 2), sign(k, 4)) * *half;
                    faces.extend(BRICK_FACES.map(|f| (b, f.map(corner).to_vec())));
                }
                Shape::Polyhedron(body) => faces.extend(of(body)),
                Shape::Glued(parts) => faces.extend(parts.iter().flat_map(of)),
                Shape::Terrain(_) => {}
            }
        }
        faces
    }

    /// Warns of tables below which there is nothing; one that seeps there is an error.
    pub(super) fn dry_tables(&mut self) {
        let corners = self.corners();
        let tables = match self.space {
            InSpace::Planar => &self.setup.water,
            InSpace::Spatial => &self.spatial.water,
        };
        let dry = |t: &WaterTable| {
            let below = |c: &Vec3| t.level(c.x, c.y) > c.z;
            t.parts.is_empty() && !corners.iter().any(below)
        };
        let spans: Vec<(String, Span, bool)> = tables
            .iter()
            .filter(|t| dry(t))
            .filter_map(|t| {
                let said = self.parsed.scenario.water.iter();
                let mut named = said.filter(|(name, _)| name.as_str() == t.name);
                Some((t.name.clone(), named.next()?.0.span.clone(), t.seepage.is_some()))
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

/// Whether a zone has a part of a face that counts.
fn claims(zone: &Zone, face: &[Vec3]) -> bool {
    if let [from, to] = face {
        let flat = |at: &Vec3| Vec2::new(at.x, at.z);
        let [s, t] = zone.shares(flat(from), flat(to));
        return t - s > CLAIMED;
    }
    let area = |face: &[Vec3]| {
        let spans = (2..face.len()).map(|k| (face[k - 1] - face[0]).cross(face[k] - face[0]));
        spans.sum::<Vec3>().length()
    };
    area(&zone.clip(face, &|r| r)) > CLAIMED * area(face)
}
