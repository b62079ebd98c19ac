//! Outlines of the blocks of one `[[blocks]]` table.

use riprap_geom::cut::{self, JointSet};
use riprap_geom::heal::Blocks;
use riprap_geom::measure::SliverReport;
use riprap_geom::pack::{self, Pour};
use riprap_geom::polygon::{self, Aabb, Collinear};
use riprap_geom::shapes::{self, Arch, Wall};
use riprap_geom::voronoi::{self, Cells};
use riprap_geom::{GeomError, Vec2};

use super::builder::{Builder, global};
use super::generated::Generated;
use super::summary::Region;
use crate::scenario::csv_columns::Column;
use crate::scenario::language::{
    Block, Cut, Geometry, Point, Polygon, Rectangle, Voronoi, WallBond,
};
use crate::scenario::read::{Provenance, with_unit};
use crate::scenario::units::Dim;
use crate::scenario::{Diagnostic, Name, Quantity, Span};

/// Points that show where a table's blocks are, in the coordinates of the file.
pub(super) fn places(block: &Block) -> Vec<Vec2> {
    let all = |points: &[Point]| points.iter().map(global).collect();
    match block.geometry() {
        None
        | Some(
            Geometry::Polygon(Polygon::Csv(_))
            // Read before the origin is found.
            | Geometry::Polygons(_)
            | Geometry::Brick(_)
            | Geometry::Grid(_)
            | Geometry::Polyhedron(_)
            | Geometry::Parts(_)
            | Geometry::Mesh(_)
            | Geometry::Terrain(_)
            | Geometry::Masonry(_)
            | Geometry::Vault(_)
            | Geometry::Dome(_),
        ) => Vec::new(),
        Some(Geometry::Polygon(Polygon::Points(points))) => all(points),
        Some(Geometry::Rectangle(r)) => r.corner.iter().chain(&r.centre).map(global).collect(),
        Some(Geometry::Regular(r)) => vec![global(&r.centre)],
        Some(Geometry::Wall(w)) => vec![global(&w.corner)],
        Some(Geometry::Arch(a)) => vec![global(&a.centre)],
        Some(Geometry::Cut(c)) => c.region.iter().flatten().map(global).collect(),
        Some(Geometry::Voronoi(v)) => all(&v.region),
        Some(Geometry::Pour(p)) => p.region.iter().map(|c| c.xy().into()).collect(),
    }
}

/// Code and help of cells whose edges stay too short.
pub(super) const SHORT_EDGES: (&str, &str) = (
    "geometry.edges",
    "give a smaller `smallest_edge` (at most a tenth of `cell` is attainable), or more rounds of `relax`",
);

/// Columns of the corners of a polygon.
const CORNER: [Column; 2] = [
    Column::needed(&["x", "easting", "east"], Dim::LENGTH, "m"),
    Column::needed(&["y", "northing", "north"], Dim::LENGTH, "m"),
];

impl Builder<'_> {
    /// The blocks of one table, turned, shifted and copied; `None` after an error.
    pub(super) fn generate(&mut self, block: &Block) -> Option<Generated> {
        let mut made = match block.geometry()? {
            Geometry::Polygon(Polygon::Points(points)) => {
                let outline: Vec<Vec2> = points.iter().map(|p| self.point(p)).collect();
                let spans = |k: usize| points.get(k).map(|[x, y]| x.span.start..y.span.end);
                self.outline(block, outline, &spans).map(Generated::single)?
            }
            Geometry::Polygon(Polygon::Csv(file)) => self.polygon_of_csv(block, file)?,
            Geometry::Polygons(said) => self.polygons(block, said)?,
            Geometry::Rectangle(shape) => Generated::single(self.rectangle(shape)),
            Geometry::Regular(r) => {
                let centre = self.point(&r.centre);
                Generated::single(shapes::regular(r.sides as usize, r.radius.si(), centre))
            }
            Geometry::Wall(w) => {
                let wall = Wall {
                    corner: self.point(&w.corner),
                    block: Vec2::new(w.block[0].si(), w.block[1].si()),
                    courses: w.courses as usize,
                    per_course: w.per_course as usize,
                    running: w.bond.unwrap_or_default() == WallBond::Running,
                    half_blocks: w.half_blocks,
                };
                self.made(block, shapes::wall(&wall)).map(Generated::several)?
            }
            Geometry::Arch(a) => {
                let arch = Arch {
                    centre: self.point(&a.centre),
                    radius: a.radius.si(),
                    thickness: a.thickness.si(),
                    half_angle: a.half_angle.si(),
                    voussoirs: a.voussoirs as usize,
                };
                self.made(block, shapes::arch(&arch)).map(Generated::several)?
            }
            Geometry::Cut(c) => self.cut(block, c)?,
            // Refused by the language: shapes of the other space.
            Geometry::Brick(_)
            | Geometry::Grid(_)
            | Geometry::Polyhedron(_)
            | Geometry::Parts(_)
            | Geometry::Mesh(_)
            | Geometry::Terrain(_)
            | Geometry::Masonry(_)
            | Geometry::Vault(_)
            | Geometry::Dome(_) => return None,
            Geometry::Voronoi(v) => self.voronoi(block, v)?,
            Geometry::Pour(said) => self.poured(block, said)?,
        };
        self.place(block, &mut made.outlines);
        self.copy(block, &mut made);
        let wrong = made.outlines.iter().find_map(|o| polygon::validate(o).err());
        if let Some(error) = wrong {
            // A shape of ours that is no polygon: sizes or places beyond the range of numbers.
            self.geometry_error(block, &error, None);
            return None;
        }
        Some(made)
    }

    fn polygon_of_csv(&mut self, block: &Block, file: &Name) -> Option<Generated> {
        let table = self.table(file, &CORNER)?;
        let corners = table.values(0).iter().zip(table.values(1));
        let outline = corners.map(|(x, y)| Vec2::new(*x, *y) - self.origin).collect();
        let span = |_| Some(file.span.clone());
        self.outline(block, outline, &span).map(Generated::single)
    }

    fn poured(
        &mut self,
        block: &Block,
        said: &crate::scenario::language::Pour,
    ) -> Option<Generated> {
        let mut read = self.reading(format!("blocks.{}.pour", block.name), said);
        let ([few, many], seed) = (read.vertices(), read.seed());
        let [min, max] = [0, 1].map(|end| Vec2::from(said.region[end].xy()) - self.origin);
        let pour = Pour {
            region: Aabb { min, max },
            count: said.count as usize,
            size: (said.size[0].si(), said.size[1].si()),
            vertices: (few as usize, many as usize),
            seed,
        };
        self.made(block, pack::pour(&pour)).map(Generated::several)
    }

    fn rectangle(&self, shape: &Rectangle) -> Vec<Vec2> {
        let size = Vec2::new(shape.size[0].si(), shape.size[1].si());
        let corner = match (&shape.corner, &shape.centre) {
            (Some(corner), _) => self.point(corner),
            (None, Some(centre)) => self.point(centre) - 0.5 * size,
            (None, None) => -self.origin,
        };
        shapes::rectangle(corner, size)
    }

    /// Turns and moves.
    fn place(&self, block: &Block, outlines: &mut [Vec<Vec2>]) {
        if let Some(rotate) = &block.rotate {
            let about = rotate
                .about
                .as_ref()
                .map_or_else(|| common_centroid(outlines), |p| Vec2::from(p.xy()) - self.origin);
            let angle = rotate.angle.as_ref().map_or(0.0, Quantity::si);
            let (sin, cos) = (libm::sin(angle), libm::cos(angle));
            for v in outlines.iter_mut().flatten() {
                let arm = *v - about;
                *v = about + Vec2::new(cos * arm.x - sin * arm.y, sin * arm.x + cos * arm.y);
            }
        }
        if let Some(shift) = &block.shift {
            let shift = Vec2::from(shift.xy());
            outlines.iter_mut().flatten().for_each(|v| *v += shift);
        }
    }

    fn copy(&mut self, block: &Block, made: &mut Generated) {
        let Some(copies) = &block.copies else { return };
        let total = u64::from(copies.count) * made.outlines.len() as u64;
        if total > riprap_geom::tol::MAX_BLOCKS as u64 {
            let error = GeomError::TooMany {
                what: "copies",
                count: total as f64,
                cap: riprap_geom::tol::MAX_BLOCKS,
            };
            self.geometry_error(block, &error, None);
            return;
        }
        if !self.has_memory(block, total as f64, &copies.step.span) {
            return;
        }
        let step = Vec2::from(copies.step.xy());
        let first = std::mem::take(&mut made.outlines);
        made.numbered = true;
        for k in 0..copies.count {
            let shift = f64::from(k) * step;
            let moved = |outline: &Vec<Vec2>| outline.iter().map(|&v| v + shift).collect();
            made.outlines.extend(first.iter().map(moved));
        }
    }

    /// A polygon as the user gave it, cleaned and turned anticlockwise. `span` finds a corner.
    fn outline(
        &mut self,
        block: &Block,
        raw: Vec<Vec2>,
        span: &dyn Fn(usize) -> Option<Span>,
    ) -> Option<Vec<Vec2>> {
        // Corners on straight sides stay: they are the user's, and some laws feel them.
        let (clean, changes) = polygon::normalise(&raw, Collinear::Keep);
        // Errors count corners as the user does, as far as none was dropped.
        let counted = if changes.repeated == 0 { &raw } else { &clean };
        if let Err(error) = polygon::validate(counted) {
            let corner = match error {
                GeomError::NonFinite { vertex, .. } | GeomError::Spike { vertex, .. } => {
                    Some(vertex)
                }
                GeomError::SelfIntersecting { edge_a, .. } => Some(edge_a),
                GeomError::TooFewVertices { .. }
                | GeomError::TooManyVertices { .. }
                | GeomError::ZeroArea { .. }
                | GeomError::BadNumber { .. }
                | GeomError::TooMany { .. }
                | GeomError::DoesNotFit { .. }
                | GeomError::ShortEdges { .. }
                | GeomError::Arrangement { .. } => None,
            };
            let at = corner.filter(|_| changes.repeated == 0).and_then(span);
            self.geometry_error(block, &error, at);
            return None;
        }
        let mut note = |message: String| {
            let note = Diagnostic::warning("geometry.changed", message);
            self.found.push(note.at(block.name.span.clone()));
        };
        if changes.reversed {
            note(format!(
                "the corners of `{}` run clockwise; their order was reversed",
                block.name
            ));
        }
        if changes.repeated > 0 {
            let count = changes.repeated;
            note(format!(
                "`{}` repeats {count} corner(s) within 1e-8 of its size; they were dropped",
                block.name
            ));
        }
        Some(clean)
    }

    /// Corners of a region to be divided.
    fn region(&mut self, block: &Block, points: &[Point]) -> Option<Vec<Vec2>> {
        let spans = |k: usize| points.get(k).map(|[x, y]| x.span.start..y.span.end);
        self.outline(block, points.iter().map(|p| self.point(p)).collect(), &spans)
    }

    fn cut(&mut self, block: &Block, cut: &Cut) -> Option<Generated> {
        let region = self.region(block, cut.region.as_deref().unwrap_or_default())?;
        let traces = self.traces(block, cut)?;
        let origin = self.origin;
        let mut read = self.reading(format!("blocks.{}.cut", block.name), cut);
        let sets: Vec<JointSet> = (0..)
            .zip(&cut.joint_sets)
            .map(|(number, set)| {
                let mut read = read.within(&format!("joint_sets.{number}"), set);
                let angle = read.dip();
                let normal = shapes::unit(angle).perp();
                JointSet {
                    angle,
                    spacing: read.spacing(),
                    spacing_scatter: read.spacing_scatter(),
                    angle_scatter: read.angle_scatter(),
                    persistence: read.persistence(),
                    trace_length: read.trace_length(),
                    // Measured from the origin of the file.
                    offset: read.offset() - origin.dot(normal),
                }
            })
            .collect();
        let seed = read.seed();
        let smallest = read.smallest_edge_or(0.0, Provenance::Default, "");
        let blocks = self.made(block, cut::cut(&region, &traces, &sets, seed, smallest))?;
        Some(self.divided(block, blocks, smallest))
    }

    fn voronoi(&mut self, block: &Block, v: &Voronoi) -> Option<Generated> {
        let region = self.region(block, &v.region)?;
        let mut read = self.reading(format!("blocks.{}.voronoi", block.name), v);
        let cells = Cells {
            relax: read.relax() as usize,
            cell_size: read.cell_size(),
            seed: read.seed(),
            smallest_edge: read.smallest_edge_or(0.0, Provenance::Default, ""),
        };
        let blocks = self.made(block, voronoi::voronoi(&region, &cells))?;
        Some(self.divided(block, blocks, cells.smallest_edge))
    }

    /// A divided region, with a warning for bad blocks that could not be merged.
    fn divided(&mut self, block: &Block, blocks: Blocks, smallest: f64) -> Generated {
        let name = &block.name;
        if let Some(worst) = blocks.left.iter().min_by(|a, b| a.edge.total_cmp(&b.edge)) {
            let count = blocks.left.len();
            let message = format!(
                "`{name}`: {count} block(s) keep an edge below {}; the shortest is {} ({})",
                with_unit(smallest, "m"),
                with_unit(worst.edge, "m"),
                self.at_text(worst),
            );
            let help = "merging them would join large blocks; change the seed, an offset or a spacing slightly, or accept the smaller time step";
            let note = Diagnostic::warning("geometry.sliver", message).help(help);
            self.found.push(note.at(name.span.clone()));
        }
        let region = Region {
            name: name.text.clone(),
            blocks: blocks.polygons.len(),
            dead_ends: blocks.removed.dead_ends,
            islands: blocks.removed.islands,
            collapsed: blocks.collapsed,
            merged: blocks.merged,
        };
        Generated {
            outlines: blocks.polygons,
            numbered: true,
            region: Some(region),
            groups: Vec::new(),
        }
    }

    /// "near (x, y)" in the coordinates of the file.
    pub(super) fn at_text(&self, report: &SliverReport) -> String {
        let [x, y] = (Vec2::from(report.at) + self.origin).to_array();
        format!("near ({}, {})", with_unit(x, "m"), with_unit(y, "m"))
    }

    fn made<T>(&mut self, block: &Block, result: Result<T, GeomError>) -> Option<T> {
        match result {
            Ok(value) => Some(value),
            Err(error) => {
                self.geometry_error(block, &error, None);
                None
            }
        }
    }

    fn geometry_error(&mut self, block: &Block, error: &GeomError, at: Option<Span>) {
        let (code, help): (&'static str, &str) = match error {
            GeomError::TooFewVertices { .. } => {
                ("polygon.corners", "a polygon needs at least three distinct corners")
            }
            GeomError::TooManyVertices { .. } => {
                ("polygon.corners", "remove redundant corners, or divide the block")
            }
            GeomError::NonFinite { .. } => ("polygon.number", "give finite coordinates in metres"),
            GeomError::ZeroArea { .. } => ("polygon.area", "check the coordinates and their units"),
            GeomError::SelfIntersecting { .. } => {
                ("polygon.crossing", "list the corners in order along the boundary")
            }
            GeomError::Spike { .. } => ("polygon.spike", "remove the corner at the tip"),
            GeomError::BadNumber { .. } => ("value.range", "change the value"),
            GeomError::TooMany { .. } => {
                ("geometry.count", "use a larger spacing or size, or a smaller region")
            }
            GeomError::DoesNotFit { .. } => {
                ("geometry.fit", "use a larger region, or a smaller `count` or `size`")
            }
            GeomError::ShortEdges { .. } => SHORT_EDGES,
            GeomError::Arrangement { .. } => ("geometry.joints", "change the seed or a spacing"),
        };
        // Places are reported in the coordinates of the file.
        let mut error = error.clone();
        match &mut error {
            GeomError::SelfIntersecting { at, .. }
            | GeomError::Spike { at, .. }
            | GeomError::Arrangement { at } => *at += self.origin,
            GeomError::NonFinite { .. }
            | GeomError::TooFewVertices { .. }
            | GeomError::TooManyVertices { .. }
            | GeomError::ZeroArea { .. }
            | GeomError::BadNumber { .. }
            | GeomError::TooMany { .. }
            | GeomError::DoesNotFit { .. }
            | GeomError::ShortEdges { .. } => {}
        }
        let message = format!("block `{}`: {error}", block.name);
        let span = at.unwrap_or_else(|| block.name.span.clone());
        self.found.push(Diagnostic::error(code, message).at(span).help(help));
    }
}

/// Centroid of all outlines together.
fn common_centroid(outlines: &[Vec<Vec2>]) -> Vec2 {
    let Some(&start) = outlines.first().and_then(|o| o.first()) else {
        return Vec2::ZERO;
    };
    let (mut area, mut first) = (0.0, Vec2::ZERO);
    for m in outlines.iter().map(|o| polygon::mass_properties(o)) {
        area += m.area;
        first += m.area * (m.centroid - start);
    }
    if area == 0.0 { start } else { start + first / area }
}
