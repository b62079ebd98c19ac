//! Blocks in space: bricks, grids, polyhedra.

use riprap_geom::polyhedron::{
    Polyhedron, SolidError, cells_within, hull, lattice_sites, random_sites, regular_prism,
};
use riprap_geom::{GeomError, Vec3};

use super::global;
use super::grid::{Grids, Lattice};
use super::mesh::Made;
use super::turn::{Turn, copies};
use crate::model::blocks::SHORT_EDGES;
use crate::model::builder::Builder;
use crate::model::names::Entry;
use crate::scenario::foreign::obj::{Obj, parse_obj};
use crate::scenario::language::{self, Block, Brick, Geometry, Grid, GridCells, span_of};
use crate::scenario::{Diagnostic, Name, Quantity, Span};
use crate::spatial::setup::{BlockName, BlockSpec, Shape, Solid};

/// Most cells of a box.
pub(super) const MOST_CELLS: f64 = 1e6;

/// Centre and half the edges of a brick, m.
pub(super) fn brick(brick: &Brick) -> (Vec3, Vec3) {
    let half = 0.5 * Vec3::from(brick.size.each_ref().map(Quantity::si));
    let centre = match (&brick.corner, &brick.centre) {
        (Some(corner), _) => global(corner) + half,
        (None, Some(centre)) => global(centre),
        (None, None) => half,
    };
    (centre, half)
}

/// Lowest and highest corner of a box of cells, m.
pub(super) fn box_of(said: &GridCells) -> (Vec3, Vec3) {
    let min = said.corner.as_ref().map_or(Vec3::ZERO, global);
    (min, min + Vec3::from(said.size.each_ref().map(Quantity::si)))
}

/// What is divided into cells.
pub(super) fn whole(said: &GridCells) -> Result<Polyhedron, GeomError> {
    let (min, max) = box_of(said);
    match said.sides {
        None => Ok(Polyhedron::brick(0.5 * (min + max), 0.5 * (max - min))),
        Some(sides) => regular_prism(min, max, sides as u32),
    }
}

/// Points that show where a table's blocks are, in the coordinates of the file.
pub(super) fn corners(block: &Block, grids: &Grids) -> Vec<Vec3> {
    let mut places = unturned_corners(block, grids);
    // About the centroid of the shape they stay near where they are.
    if let Some((rotate, about)) = block.rotate.as_ref().and_then(|r| Some((r, r.about.as_ref()?)))
    {
        let shift = block.shift.as_ref().map_or(Vec3::ZERO, |s| s.xyz().into());
        let turn = Turn::new(rotate, Vec3::from(about.xyz()) + shift);
        places.iter_mut().for_each(|place| *place = turn.of(*place));
    }
    places
}

fn unturned_corners(block: &Block, grids: &Grids) -> Vec<Vec3> {
    let shift = block.shift.as_ref().map_or(Vec3::ZERO, |s| s.xyz().into());
    match block.geometry() {
        Some(Geometry::Brick(b)) => {
            let (centre, half) = brick(b);
            vec![centre - half + shift, centre + half + shift]
        }
        Some(Geometry::Grid(Grid::Cells(said))) => {
            let (min, max) = box_of(said);
            vec![min + shift, max + shift]
        }
        Some(Geometry::Grid(Grid::Box(_))) => grids
            .iter()
            .flatten()
            .flat_map(|l| [l.corner, l.corner + l.size()])
            .collect(),
        Some(Geometry::Polyhedron(p)) => {
            let vertices = p.vertices.iter().flatten();
            vertices.map(|v| global(v) + shift).collect()
        }
        Some(Geometry::Parts(parts)) => {
            let bricks = parts.iter().filter_map(|part| part.brick.as_ref());
            let corners = bricks.flat_map(|said| {
                let (centre, half) = brick(said);
                [centre - half + shift, centre + half + shift]
            });
            let solids = parts.iter().filter_map(|part| part.polyhedron.as_ref());
            let vertices = solids.flat_map(|p| p.vertices.iter().flatten());
            corners
                .chain(vertices.map(|v| global(v) + shift))
                .collect()
        }
        Some(Geometry::Masonry(said)) => {
            let corner = said.corner.as_ref().map_or(Vec3::ZERO, global) + shift;
            vec![corner, corner + Vec3::new(said.length.si(), 0.0, 0.0)]
        }
        Some(Geometry::Vault(said)) => [&said.from, &said.to].map(|p| global(p) + shift).into(),
        Some(Geometry::Dome(said)) => vec![said.centre.as_ref().map_or(Vec3::ZERO, global) + shift],
        Some(Geometry::Pour(p)) => {
            let corners = p.region.iter();
            corners.map(|c| Vec3::from(c.xyz()) + shift).collect()
        }
        Some(
            Geometry::Polygon(_)
            | Geometry::Polygons(_)
            | Geometry::Rectangle(_)
            | Geometry::Regular(_)
            | Geometry::Wall(_)
            | Geometry::Arch(_)
            | Geometry::Cut(_)
            | Geometry::Voronoi(_)
            // Its nodes are in a file, which is read later: what it says is local from the start.
            | Geometry::Mesh(_)
            | Geometry::Terrain(_),
        )
        | None => Vec::new(),
    }
}

impl Builder<'_> {
    pub(super) fn solid_blocks(&mut self, grids: &Grids) {
        let scenario = &self.parsed.scenario;
        if scenario.blocks.len() > usize::from(u16::MAX) || scenario.materials.len() > 1000 {
            let message = "there are too many [[blocks]] tables or materials";
            let error = Diagnostic::error("geometry.count", message);
            self.found.push(error.help("make identical blocks with `grid` or `copies`"));
            return;
        }
        for (block, lattice) in scenario.blocks.iter().zip(grids) {
            let shift = block.shift.as_ref().map_or(Vec3::ZERO, |s| s.xyz().into());
            let shift = shift - self.spatial.origin;
            let made = match block.geometry() {
                Some(Geometry::Brick(said)) => {
                    let (centre, half) = brick(said);
                    self.with_volume(block, 8.0 * half.element_product())
                        .then(|| vec![Shape::Brick { centre: centre + shift, half }])
                }
                Some(Geometry::Grid(Grid::Cells(said))) => self.cells(block, said, shift),
                Some(Geometry::Grid(Grid::Box(_))) => lattice
                    .as_ref()
                    .filter(|l| self.with_volume(block, l.cell.element_product()))
                    .map(|lattice| bricks(lattice, self.spatial.origin)),
                Some(Geometry::Polyhedron(said)) => {
                    let made = self.polyhedra(block, said, shift);
                    self.enter_made(block, made, shift);
                    continue;
                }
                Some(Geometry::Pour(said)) => self.pour(block, said, shift),
                Some(Geometry::Masonry(said)) => {
                    let made = self.masonry(block, said, shift);
                    self.enter_made(block, made, shift);
                    continue;
                }
                Some(Geometry::Vault(said)) => self.vault(block, said, shift),
                Some(Geometry::Dome(said)) => self.dome(block, said, shift),
                Some(Geometry::Parts(said)) => {
                    self.parts(block, said, shift).map(|shape| vec![shape])
                }
                Some(Geometry::Mesh(said)) => {
                    let made = self.mesh(block, said, shift);
                    let made = if said.glued == Some(true) {
                        made.and_then(|made| self.glued_mesh(block, made))
                    } else {
                        made
                    };
                    self.enter_made(block, made, shift);
                    continue;
                }
                Some(Geometry::Terrain(said)) => {
                    self.terrain(block, said, shift).map(|shape| vec![shape])
                }
                // Refused by the language: shapes of the other space.
                Some(
                    Geometry::Polygon(_)
                    | Geometry::Polygons(_)
                    | Geometry::Rectangle(_)
                    | Geometry::Regular(_)
                    | Geometry::Wall(_)
                    | Geometry::Arch(_)
                    | Geometry::Cut(_)
                    | Geometry::Voronoi(_),
                )
                | None => None,
            };
            self.enter_made(block, made.map(Made::of), shift);
        }
    }

    /// Turns, copies and cuts the blocks of a table if that is wanted, and enters them with what is named among them.
    fn enter_made(&mut self, block: &Block, made: Option<Made>, shift: Vec3) {
        let Some(mut made) = made else { return };
        if let Some(rotate) = &block.rotate {
            let about = rotate.about.as_ref().map(|at| Vec3::from(at.xyz()) + shift);
            let about = about.unwrap_or_else(|| common_centroid(&made.shapes));
            made = Turn::new(rotate, about).of_all(made);
        }
        made = copies(block, made);
        if let Some(cut) = &block.cut {
            match self.divide(block, cut, made, shift) {
                Some(divided) => made = divided,
                None => return,
            }
        }
        let first = self.spatial.blocks.len() as u32;
        self.enter_solids(block, made.shapes);
        for (name, members) in made.groups {
            let members = members.into_iter().map(|k| first + k).collect();
            self.directory.extend(&name, members);
        }
        for (name, faces) in made.surfaces {
            let faces = faces.into_iter().map(|(k, n, d)| (first + k, n, d));
            self.surfaces.entry(name).or_default().extend(faces);
        }
    }

    /// The cells of a box; `None` after an error.
    fn cells(&mut self, block: &Block, said: &GridCells, shift: Vec3) -> Option<Vec<Shape>> {
        if let Some(graded) = &said.graded {
            return self.graded(block, said, graded, shift);
        }
        let (min, max) = box_of(said);
        // Reported by the rules of the language.
        let cell_said = said.cell.as_ref()?;
        let cell = cell_said.si();
        let count = (max - min).element_product() / (cell * cell * cell);
        if count.is_nan() || count > MOST_CELLS {
            let message = format!("`{}` would have about {count:.0} cells", block.name);
            let help = "at most 1 million cells are allowed; use a larger `cell`, or `grid.box`";
            self.error_at("geometry.count", cell_said.span.clone(), message, help);
            return None;
        }
        if !self.has_memory(block, count, &cell_said.span) {
            return None;
        }
        let lattice = said.turned.is_some() || said.site.is_some();
        let extent = max - min;
        let square = extent.truncate().length_squared() * extent.z.max(cell) / (cell * cell * cell);
        if lattice && (square.is_nan() || square > 16.0 * MOST_CELLS) {
            let message = format!("`{}` is too slender for a rotated lattice", block.name);
            let help = "use a larger `cell`, or `grid.box`";
            self.error_at("geometry.count", cell_said.span.clone(), message, help);
            return None;
        }
        let (sites, relax, smallest) = if lattice {
            let angle = said.turned.as_ref().map_or(0.0, Quantity::si);
            let site = said.site.as_ref().map_or(0.5 * (min + max), global);
            (lattice_sites(min, max, cell, site, angle), 0, 0.0)
        } else {
            let mut read = self.reading(format!("blocks.{}.grid.cells", block.name), said);
            let (seed, relax) = (read.seed(), read.relax());
            let smallest = read.smallest_edge();
            let sites = random_sites(min, max, cell, seed);
            (sites, relax as usize, smallest)
        };
        let whole = whole(said);
        let made = whole.and_then(|whole| cells_within(&whole, &sites, relax, smallest));
        self.made_cells(block, made, shift)
    }

    /// Cells as shapes; `None` after an error.
    pub(super) fn made_cells(
        &mut self,
        block: &Block,
        made: Result<Vec<Polyhedron>, GeomError>,
        shift: Vec3,
    ) -> Option<Vec<Shape>> {
        let shifted = |mut solid: Polyhedron| {
            solid.vertices.iter_mut().for_each(|v| *v += shift);
            Shape::Polyhedron(Box::new(Solid { vertices: solid.vertices, faces: solid.faces }))
        };
        match made {
            Ok(cells) => Some(cells.into_iter().map(shifted).collect()),
            Err(error) => {
                let message = format!("the cells of `{}`: {error}", block.name);
                let (code, help) = if matches!(error, GeomError::ShortEdges { .. }) {
                    SHORT_EDGES
                } else {
                    let help = "check size, cell and units; `site` must lie near the box";
                    ("geometry.cells", help)
                };
                self.error_at(code, &block.name, message, help);
                None
            }
        }
    }

    /// Whether a brick has a volume that numbers can hold.
    pub(super) fn with_volume(&mut self, block: &Block, volume: f64) -> bool {
        let sound = volume.is_normal() && volume > 0.0;
        if !sound {
            let message = format!("the bricks of `{}` have no volume", block.name);
            self.error_at("geometry.volume", &block.name, message, "check sizes and units");
        }
        sound
    }

    fn enter_solids(&mut self, block: &Block, shapes: Vec<Shape>) {
        let materials = &self.parsed.scenario.materials;
        let material = materials.names().position(|m| m == block.material.as_str());
        let material = material.unwrap_or(0) as u16;
        let base = self.spatial.names.len() as u16;
        self.spatial.names.push(block.name.text.clone());
        // An OBJ file may hold several.
        let numbered = block.is_generator() || shapes.len() > 1;
        let entry = Entry {
            name: block.name.text.clone(),
            first: self.spatial.blocks.len() as u32,
            count: shapes.len() as u32,
            numbered,
        };
        self.directory.add(entry, &block.groups);
        let velocity = block.velocity.as_ref().map_or(Vec3::ZERO, |v| v.xyz().into());
        let spin = block.spin.as_ref().map_or(Vec3::ZERO, |s| s.xyz().into());
        // Copies and poured blocks are stones of their own, everything else that a table makes spins as one body.
        let one = block.copies.is_none()
            && block.pour.is_none()
            && shapes.len() > 1
            && spin != Vec3::ZERO;
        let about = one.then(|| common_centroid(&shapes));
        self.spatial.blocks.reserve(shapes.len());
        let first = self.spatial.blocks.len() as u32;
        for (number, shape) in (1u32..).zip(shapes) {
            let centroid = centroid(&shape);
            let swing = about.map_or(Vec3::ZERO, |about| spin.cross(centroid - about));
            self.directory.centroids.push(centroid.into());
            self.spatial.blocks.push(BlockSpec {
                name: BlockName { base, number: if numbered { number } else { 0 } },
                shape,
                material,
                velocity: velocity + swing,
                spin,
            });
        }
        self.given_bodies(block, first);
        self.enter_deformable(block, first);
    }

    /// A checked convex solid in local coordinates.
    pub(super) fn polyhedron(
        &mut self,
        block: &Block,
        said: &language::Polyhedron,
        shift: Vec3,
    ) -> Option<Solid> {
        let (vertices, faces) = match (&said.vertices, &said.obj) {
            (Some(vertices), _) => {
                let vertices: Vec<Vec3> = vertices.iter().map(global).collect();
                (vertices, said.faces.clone())
            }
            (None, Some(file)) => {
                let obj = self.obj(file)?;
                if let Some(solids) = obj.solids().ok().filter(|solids| solids.len() > 1) {
                    let message =
                        format!("`{file}` contains {} solids instead of one", solids.len());
                    let help = "a part must be one solid; save each in a separate file, or use `mesh.obj` with `glued = true`";
                    self.error_at("file.obj", file, message, help);
                    return None;
                }
                let vertices = obj.points.iter().map(|p| Vec3::from_array(*p)).collect();
                (vertices, Some(obj.faces()).filter(|faces| !faces.is_empty()))
            }
            (None, None) => return None, // reported by the rules of the language
        };
        let moved = vertices.iter().map(|v: &Vec3| *v + shift).collect::<Vec<_>>();
        let made = match faces {
            Some(faces) => Polyhedron::new(moved, faces),
            None => hull(&moved),
        };
        match made {
            Ok(solid) => Some(Solid { vertices: solid.vertices, faces: solid.faces }),
            Err(error) => {
                let (vertex, help) = reason(&error);
                let span = vertex
                    .and_then(|k| said.vertices.as_ref()?.get(k).map(span_of))
                    .unwrap_or_else(|| block.name.span.clone());
                self.solid_error(block, &error, span, help);
                None
            }
        }
    }

    fn solid_error(&mut self, block: &Block, error: &SolidError, span: Span, help: &str) {
        let message = format!("block `{}`: {error}", block.name);
        self.error_at("polyhedron", span, message, help);
    }

    /// What an OBJ file holds; `None` after an error.
    pub(super) fn obj(&mut self, file: &Name) -> Option<Obj> {
        self.foreign_file(file, parse_obj, "correct this line, or export the file again as OBJ")
    }

    /// The blocks of a table with an OBJ file: one as it stands in the file, or one of each closed part.
    fn polyhedra(
        &mut self,
        block: &Block,
        said: &language::Polyhedron,
        shift: Vec3,
    ) -> Option<Made> {
        if let Some(file) = &said.obj {
            let obj = self.obj(file)?;
            if let Some(solids) = obj.solids().ok().filter(|solids| solids.len() > 1) {
                return self.obj_solids(block, file, &obj, solids, 1.0, shift);
            }
        }
        let solid = self.polyhedron(block, said, shift)?;
        Some(Made::of(vec![Shape::Polyhedron(Box::new(solid))]))
    }
}

/// Corner that an error is about, and what to do.
fn reason(error: &SolidError) -> (Option<usize>, &'static str) {
    match error {
        SolidError::NotConvex { vertex, .. } => {
            (Some(*vertex as usize), "divide the block into convex blocks that share faces")
        }
        SolidError::NonFinite { vertex, .. } | SolidError::Unused { vertex } => {
            (Some(*vertex), "correct or remove this corner")
        }
        SolidError::CrookedFace { vertex, .. } => (
            Some(*vertex as usize),
            "move the corner into the plane, or divide the face into triangles",
        ),
        SolidError::Open { .. } => (None, "add the missing face"),
        SolidError::ZeroVolume { .. } => (None, "check the coordinates and their units"),
        SolidError::TooFewVertices { .. }
        | SolidError::TooManyVertices { .. }
        | SolidError::NoSuchVertex { .. }
        | SolidError::FlatFace { .. }
        | SolidError::Unbounded { .. }
        | SolidError::Nothing { .. } => (None, "check corners and faces"),
        SolidError::WrongWay { .. } => {
            (None, "list the corners of every face anticlockwise as seen from outside")
        }
    }
}

/// Bricks of a lattice, x fastest.
fn bricks(lattice: &Lattice, origin: Vec3) -> Vec<Shape> {
    let [nx, ny, nz] = lattice.count;
    let half = 0.5 * lattice.cell;
    let corner = lattice.corner - origin;
    let mut shapes = Vec::with_capacity(nx as usize * ny as usize * nz as usize);
    for k in 0..nz {
        for j in 0..ny {
            for i in 0..nx {
                let at = Vec3::new(f64::from(i), f64::from(j), f64::from(k)) + 0.5;
                shapes.push(Shape::Brick { centre: corner + at * lattice.cell, half });
            }
        }
    }
    shapes
}

/// The solid of a shape.
pub(super) fn solid(shape: &Shape) -> Polyhedron {
    match shape {
        Shape::Brick { centre, half } => Polyhedron::brick(*centre, *half),
        Shape::Polyhedron(solid) => {
            Polyhedron { vertices: solid.vertices.clone(), faces: solid.faces.clone() }
        }
        Shape::Glued(parts) => Solid::all(parts).polyhedron(),
        Shape::Terrain(surface) => {
            let body = surface.body();
            Polyhedron { vertices: body.vertices, faces: body.faces }
        }
    }
}

/// Lowest and highest corner of the box around a shape.
pub(in crate::model) fn bounds(shape: &Shape) -> (Vec3, Vec3) {
    match shape {
        Shape::Brick { centre, half } => (*centre - *half, *centre + *half),
        Shape::Polyhedron(solid) => {
            let start = (Vec3::INFINITY, Vec3::NEG_INFINITY);
            let vertices = solid.vertices.iter();
            vertices.fold(start, |(min, max), v| (min.min(*v), max.max(*v)))
        }
        Shape::Glued(_) => solid(shape).bounds(),
        Shape::Terrain(surface) => surface.field().bounds(),
    }
}

/// Volume, m³.
pub(in crate::model) fn volume(shape: &Shape) -> f64 {
    match shape {
        Shape::Brick { half, .. } => 8.0 * half.element_product(),
        Shape::Polyhedron(_) | Shape::Terrain(_) | Shape::Glued(_) => solid(shape).moments().volume,
    }
}

/// Centroid, m (local).
pub(super) fn centroid(shape: &Shape) -> Vec3 {
    match shape {
        Shape::Brick { centre, .. } => *centre,
        Shape::Polyhedron(_) | Shape::Terrain(_) | Shape::Glued(_) => {
            solid(shape).moments().centroid
        }
    }
}

/// Centroid of all shapes of a table.
fn common_centroid(shapes: &[Shape]) -> Vec3 {
    let mut volume_sum = 0.0;
    let mut sum = Vec3::ZERO;
    for shape in shapes {
        let volume = volume(shape);
        volume_sum += volume;
        sum += volume * centroid(shape);
    }
    sum / volume_sum
}
