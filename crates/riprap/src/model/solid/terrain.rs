//! Terrain: the surfaces of files, and blocks that start below or beside them.

use riprap_geom::Vec3;
use riprap_geom::height_field::{Bins, HeightField, HeightFieldError};
use riprap_geom::polyhedron::Polyhedron;

use super::shapes::{bounds, solid};
use super::triple;
use crate::model::builder::Builder;
use crate::scenario::csv_columns::Column;
use crate::scenario::foreign::asc::parse_asc;
use crate::scenario::foreign::stl::parse_surface;
use crate::scenario::language::{self, Block, Space};
use crate::scenario::read::{Provenance, with_unit};
use crate::scenario::units::Dim;
use crate::scenario::{Diagnostic, Name, Quantity};
use crate::spatial::setup::{Shape, Solid, Surface};

/// Most triangles of a terrain.
const MOST: usize = 8_000_000;
/// Depth at the start that needs no reason, over the size of the block.
const ACCEPTED: f64 = 1e-6;
/// Blocks named one by one.
const NAMED: usize = 10;
/// A file with fewer places than this share of its grid is none.
const SCATTERED: f64 = 0.25;

/// Columns of places on a grid.
const GRID: [Column; 3] = [
    Column::needed(&["x", "easting", "east"], Dim::LENGTH, "m"),
    Column::needed(&["y", "northing", "north"], Dim::LENGTH, "m"),
    Column::needed(&["z", "elevation", "elev", "height", "altitude"], Dim::LENGTH, "m"),
];

/// A file and the surface in it, which may be wrong; none after an error of the file itself.
type FileOfGrid<'s> = (&'s Name, Option<Result<HeightField, HeightFieldError>>);

/// Heights on a grid.
pub(in crate::model) struct GridHeights {
    /// Its lines along x and y, m, ascending.
    pub x: Vec<f64>,
    pub y: Vec<f64>,
    /// Height at `(x[i], y[j])` in `z[j * x.len() + i]`, m; places may lack one.
    pub z: Vec<Option<f64>>,
}

/// Why a file is no terrain.
struct Refused {
    message: String,
    help: &'static str,
}

impl Builder<'_> {
    /// The surface of a file in local coordinates; `None` after an error.
    pub(super) fn terrain(
        &mut self,
        block: &Block,
        said: &language::Terrain,
        shift: Vec3,
    ) -> Option<Shape> {
        let unit = match &said.csv {
            Some(_) => 1.0,
            None => (self.reading(format!("blocks.{}.terrain", block.name), said)).unit(),
        };
        let (file, made) = if let Some((file, made)) =
            self.grid_file([said.asc.as_ref(), said.csv.as_ref()], unit, shift)
        {
            (file, made?)
        } else {
            let file = said.stl.as_ref()?;
            let help = "save it as ASCII or binary STL";
            let (points, triangles, flat) = self.foreign_file(file, parse_surface, help)?;
            self.note_import(file, &triangles_text(triangles.len(), flat));
            if triangles.len() > MOST {
                let message = format!("`{file}` has {} triangles", triangles.len());
                let help = format!("at most {MOST} are allowed; use a coarser surface");
                self.error_at("file.terrain", file, message, &help);
                return None;
            }
            let points = points.iter();
            let points = points.map(|p| unit * Vec3::from_array(*p) + shift);
            (file, HeightField::new(points.collect(), triangles))
        };
        let field = match made {
            Ok(field) => field,
            Err(error) => {
                let refused = self.refused(file, &error);
                self.error_at("file.terrain", file, refused.message, refused.help);
                return None;
            }
        };
        let key = format!("blocks.{}.terrain", block.name);
        let count = field.triangles.len().to_string();
        self.explain(key, count, Provenance::Derived, "triangles of the file");
        self.tell_terrain(block, &field);
        Some(Shape::Terrain(Box::new(Surface { points: field.points, triangles: field.triangles })))
    }

    /// The surface of an ASCII grid or a CSV file in local coordinates, with its file; `None` after an error.
    pub(in crate::model) fn grid_surface<'s>(
        &mut self,
        files: [Option<&'s Name>; 2],
        unit: f64,
        shift: Vec3,
    ) -> Option<(&'s Name, HeightField)> {
        let (file, made) = self.grid_file(files, unit, shift)?;
        match made? {
            Ok(field) => Some((file, field)),
            Err(error) => {
                let refused = self.refused(file, &error);
                self.error_at("file.terrain", file, refused.message, refused.help);
                None
            }
        }
    }

    /// The surface of an ASCII grid or a CSV file, if one of them is there, and none in it after an error.
    fn grid_file<'s>(
        &mut self,
        [asc, csv]: [Option<&'s Name>; 2],
        unit: f64,
        shift: Vec3,
    ) -> Option<FileOfGrid<'s>> {
        if let Some(file) = asc {
            let help = "correct this line; GIS programs export this format as ASCII grid (AAIGrid)";
            let Some(read) = self.foreign_file(file, parse_asc, help) else {
                return Some((file, None));
            };
            let (all, none) = (read.z.len(), read.z.iter().filter(|z| z.is_none()).count());
            let left = match none {
                0 => String::new(),
                none => format!("; left out {none} without height"),
            };
            self.note_import(file, &format!("read {} of {all} cells{left}", all - none));
            let wide = read.x.len();
            let [x, y] = [(&read.x, shift.x), (&read.y, shift.y)]
                .map(|(list, shift)| list.iter().map(|at| unit * at + shift).collect::<Vec<_>>());
            let height = |i: usize, j: usize| read.z[j * wide + i].map(|z| unit * z + shift.z);
            return Some((file, Some(HeightField::grid(&x, &y, height))));
        }
        let file = csv?;
        let read = self.grid_of_csv(file, shift, "file.terrain");
        let made = read.map(|read| {
            let wide = read.x.len();
            HeightField::grid(&read.x, &read.y, |i, j| read.z[j * wide + i])
        });
        Some((file, made))
    }

    /// What `check` says about a terrain.
    fn tell_terrain(&mut self, block: &Block, field: &HeightField) {
        let origin = self.spatial.origin;
        let (low, high) = field.bounds();
        let (low, high) = (low + origin, high + origin);
        let (angle, at) = field.steepest();
        let at = at + origin;
        self.summary.terrain.push(format!(
            "{}: {} triangles, x {} to {} m, y {} to {} m, z {} to {} m; steepest {:.1} deg near ({:.6}, {:.6}) m",
            block.name,
            field.triangles.len(),
            low.x,
            high.x,
            low.y,
            high.y,
            low.z,
            high.z,
            angle.to_degrees(),
            at.x,
            at.y,
        ));
    }

    /// Heights on a rectangular grid from its places in any order, shifted; `None` after an error with `code`.
    pub(in crate::model) fn grid_of_csv(
        &mut self,
        file: &Name,
        shift: Vec3,
        code: &'static str,
    ) -> Option<GridHeights> {
        let table = self.table(file, &GRID)?;
        let [x, y, z] = std::array::from_fn(|k| table.values(k));
        let lines = |list: &[f64]| {
            // Zero with either sign is one line: the sum makes -0 a 0, which the total order tells apart.
            let mut lines: Vec<f64> = list.iter().map(|v| v + 0.0).collect();
            lines.sort_by(f64::total_cmp);
            lines.dedup();
            lines
        };
        let (columns, rows) = (lines(x), lines(y));
        let all = columns.len() as f64 * rows.len() as f64;
        // A cell of the grid has two triangles.
        if (x.len() as f64) < SCATTERED * all || all > 0.5 * MOST as f64 {
            let message = format!(
                "`{file}` is not a grid, or is too large: {} points have {} different x and {} different y",
                x.len(),
                columns.len(),
                rows.len()
            );
            let help = "list all points of a rectangular grid (for scattered points give triangles in an STL file)";
            self.error_at(code, file, message, help);
            return None;
        }
        let mut heights: Vec<Option<f64>> = vec![None; columns.len() * rows.len()];
        let place = |lines: &[f64], at: f64| lines.partition_point(|line| *line < at);
        for (((x, y), z), line) in x.iter().zip(y).zip(z).zip(&table.lines) {
            let k = place(&rows, *y) * columns.len() + place(&columns, *x);
            if heights[k].replace(z + shift.z).is_some() {
                let message = format!("`{file}`, line {line}: a second height at ({x} m, {y} m)");
                let help = "remove one of them";
                self.error_at(code, file, message, help);
                return None;
            }
        }
        let [x, y] = [(columns, shift.x), (rows, shift.y)]
            .map(|(lines, shift)| lines.into_iter().map(|at| at + shift).collect::<Vec<_>>());
        Some(GridHeights { x, y, z: heights })
    }

    /// An error of a surface, its place in the coordinates of the scenario.
    fn refused(&self, file: &Name, error: &HeightFieldError) -> Refused {
        let origin = self.spatial.origin;
        let there = |[x, y]: [f64; 2]| [x + origin.x, y + origin.y];
        let mut error = error.clone();
        let help = match &mut error {
            HeightFieldError::Empty => "at least two grid lines are needed in x and in y",
            HeightFieldError::NonFinite { .. } | HeightFieldError::NoSuchCorner { .. } => {
                "correct the file"
            }
            HeightFieldError::Upright { at } => {
                *at = there(*at);
                "incline the wall slightly, or build it of bricks"
            }
            HeightFieldError::Folded { at } | HeightFieldError::SharedEdge { at } => {
                *at = there(*at);
                "remove overhangs, or build them of polyhedra"
            }
            HeightFieldError::Hole { at, .. } => {
                *at = there(*at);
                "fill the hole with heights"
            }
            HeightFieldError::Parts { at, .. } => {
                *at = there(*at);
                "join the parts, or give each as a separate terrain"
            }
        };
        Refused { message: format!("`{file}` is not a terrain: {error}"), help }
    }

    /// Blocks that can move must start on or above terrain, and found contact must be on.
    pub(super) fn on_terrain(&mut self) {
        let blocks = (0_u32..).zip(&self.spatial.blocks);
        let grounds: Vec<(u32, HeightField, Bins)> = blocks
            .filter_map(|(b, block)| match &block.shape {
                Shape::Terrain(surface) => {
                    let field = surface.field();
                    let bins = Bins::new(&field);
                    Some((b, field, bins))
                }
                Shape::Brick { .. } | Shape::Polyhedron(_) | Shape::Glued(_) => None,
            })
            .collect();
        let Some((first, ..)) = grounds.first() else {
            return;
        };
        if !self.spatial.found_contacts {
            let message = "terrain needs contact detection, which is switched off";
            let help = "remove `found_contacts = false` from [space.spatial]";
            self.error_at("terrain.contacts", self.table_span(*first), message, help);
        }
        let wrong = self.wrong_starts(&grounds);
        let count = wrong.len();
        for (b, message) in wrong.into_iter().take(NAMED) {
            let help = "move it above the surface, hold it by [[supports]], or accept the depth with \
                        allow_overlap = \"...\" in [space.spatial]";
            self.error_at("terrain.start", self.table_span(b), message, help);
        }
        if count > NAMED {
            let message =
                format!("{} more blocks start in the terrain or outside its rim", count - NAMED);
            self.found.push(Diagnostic::error("terrain.start", message));
        }
    }

    /// Blocks that start below the surface or beyond the rim of terrain, and what to say of each.
    fn wrong_starts(&self, grounds: &[(u32, HeightField, Bins)]) -> Vec<(u32, String)> {
        let accepted = match &self.parsed.scenario.space {
            Space::Spatial(space) => space.allow_overlap.as_ref().map_or(0.0, Quantity::si),
            Space::Planar(_) => 0.0,
        };
        let mut wrong = Vec::new();
        for (b, block) in (0_u32..).zip(&self.spatial.blocks) {
            if block.shape.is_terrain() || self.held(b) {
                continue;
            }
            let (low, high) = bounds(&block.shape);
            let accepted = accepted.max(ACCEPTED * (high - low).min_element());
            let deepest = grounds
                .iter()
                .filter_map(|(t, field, bins)| Some((depth(&block.shape, field, bins)?, *t)))
                .max_by(|a, b| a.0.total_cmp(&b.0));
            let name = self.directory.name(b);
            let message = match deepest {
                None => format!(
                    "block `{name}` starts outside the rim of the terrain and would fall without end"
                ),
                Some((depth, terrain)) if depth > accepted => format!(
                    "block `{name}` starts {} below the surface of terrain `{}`, near {}",
                    with_unit(depth, "m"),
                    self.directory.name(terrain),
                    triple(0.5 * (low + high) + self.spatial.origin, "m")
                ),
                Some(_) => continue,
            };
            wrong.push((b, message));
        }
        wrong
    }
}

/// What became of the triangles of a file.
fn triangles_text(read: usize, flat: usize) -> String {
    let left = match flat {
        0 => String::new(),
        flat => format!("; left out {flat} without area"),
    };
    format!("read {read} of {} triangles{left}", read + flat)
}

/// How deep a block lies in a surface, m, negative above it. `None` where it is beside the surface as a whole.
fn depth(shape: &Shape, field: &HeightField, bins: &Bins) -> Option<f64> {
    match shape {
        Shape::Glued(parts) => {
            let parts = parts.iter().map(Solid::polyhedron);
            let depths = parts.filter_map(|part| depth_of(&part, field, bins));
            depths.max_by(f64::total_cmp)
        }
        Shape::Brick { .. } | Shape::Polyhedron(_) | Shape::Terrain(_) => {
            depth_of(&solid(shape), field, bins)
        }
    }
}

/// The same of a convex body: the deepest of its corners and of the corners of the surface in it.
fn depth_of(body: &Polyhedron, field: &HeightField, bins: &Bins) -> Option<f64> {
    let corners = body.vertices.iter();
    let depths = corners.filter_map(|v| Some(field.height(bins, v.x, v.y)? - v.z));
    let (low, high) = body.bounds();
    let mut near = Vec::new();
    bins.near([low.x, low.y], [high.x, high.y], &mut near);
    // A peak of the surface can be in a face of the block whose corners are all above it.
    let points = near.iter().flat_map(|t| field.corners(*t as usize));
    let inside = points.filter_map(|p| {
        let room = (0..body.faces.len()).map(|face| {
            let (normal, offset) = body.plane(face);
            offset - normal.dot(p)
        });
        let room = room.fold(f64::INFINITY, f64::min);
        (room >= 0.0).then_some(room)
    });
    depths.chain(inside).max_by(f64::total_cmp)
}
