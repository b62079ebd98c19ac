//! Grids of bricks: whole cells, and cells that were fitted to a charge.

use riprap_geom::Vec3;

use super::{global, triple};
use crate::model::builder::Builder;
use crate::scenario::Quantity;
use crate::scenario::language::{Block, Geometry, Grid, GridBox};
use crate::scenario::read::{Provenance, with_unit};

/// Most bricks that a grid may have.
const MOST: f64 = 2e7;
/// A size is whole cells if it is so to this share of a cell.
const WHOLE: f64 = 1e-6;

/// A box of equal bricks in the coordinates of the file.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Lattice {
    /// Corner with the lowest coordinates, shift included, m.
    pub(super) corner: Vec3,
    /// Edges of a cell, m.
    pub(super) cell: Vec3,
    /// Cells along x, y, z.
    pub(super) count: [u32; 3],
}

impl Lattice {
    /// Lengths of the edges of the box, m.
    pub(super) fn size(&self) -> Vec3 {
        let [x, y, z] = self.count.map(f64::from);
        self.cell * Vec3::new(x, y, z)
    }
}

/// The grid of each `[[blocks]]` table that is one.
pub(super) type Grids = Vec<Option<Lattice>>;

/// The grid of a table.
pub(super) fn grid_of(block: &Block) -> Option<&GridBox> {
    match block.geometry()? {
        Geometry::Grid(Grid::Box(grid)) => Some(grid),
        Geometry::Polygon(_)
        | Geometry::Polygons(_)
        | Geometry::Rectangle(_)
        | Geometry::Regular(_)
        | Geometry::Wall(_)
        | Geometry::Arch(_)
        | Geometry::Cut(_)
        | Geometry::Voronoi(_)
        | Geometry::Pour(_)
        | Geometry::Brick(_)
        | Geometry::Grid(Grid::Cells(_))
        | Geometry::Polyhedron(_)
        | Geometry::Parts(_)
        | Geometry::Mesh(_)
        | Geometry::Terrain(_)
        | Geometry::Masonry(_)
        | Geometry::Vault(_)
        | Geometry::Dome(_) => None,
    }
}

/// Size of the box as given, m.
pub(super) fn said_size(grid: &GridBox) -> Vec3 {
    grid.size.each_ref().map(Quantity::si).into()
}

/// Corner of the box as given, shift included, m.
pub(super) fn said_corner(block: &Block, grid: &GridBox) -> Vec3 {
    let shift = block.shift.as_ref().map_or(Vec3::ZERO, |s| s.xyz().into());
    let corner = match (&grid.corner, &grid.centre) {
        (Some(corner), _) => global(corner),
        (None, Some(centre)) => global(centre) - 0.5 * said_size(grid),
        (None, None) => Vec3::ZERO,
    };
    corner + shift
}

impl Builder<'_> {
    /// All grids, those around fitted charges with the cells that fit.
    pub(super) fn grids(&mut self) -> Grids {
        let fitted = self.fit_charges();
        let blocks = &self.parsed.scenario.blocks;
        let mut grids = Grids::new();
        for (block, fitted) in blocks.iter().zip(fitted) {
            let lattice = match (grid_of(block), fitted) {
                (None, _) => None,
                (Some(_), Some(lattice)) => self.counted(block, lattice),
                (Some(grid), None) => {
                    self.whole_cells(block, grid).and_then(|lattice| self.counted(block, lattice))
                }
            };
            grids.push(lattice);
        }
        grids
    }

    /// A grid as given, if its size is whole cells.
    fn whole_cells(&mut self, block: &Block, grid: &GridBox) -> Option<Lattice> {
        let (size, cell) = (said_size(grid).to_array(), grid.cell.xyz());
        let mut count = [0; 3];
        let mut sound = true;
        for k in 0..3 {
            let cells = size[k] / cell[k];
            let whole = cells.round();
            if whole >= 1.0 && (cells - whole).abs() <= WHOLE {
                count[k] = whole.min(f64::from(u32::MAX)) as u32;
                continue;
            }
            sound = false;
            let axis = ["x", "y", "z"][k];
            let fits = |cells: f64| with_unit(cells * cell[k], "m");
            let below = cells.floor();
            let message =
                format!("the grid of `{}` is {cells:.6} cells long along {axis}", block.name);
            let help = if below >= 1.0 {
                format!(
                    "the size must be a multiple of the cell size: {} or {} would fit",
                    fits(below),
                    fits(below + 1.0)
                )
            } else {
                format!("the size must be a multiple of the cell size: {} would fit", fits(1.0))
            };
            self.error_at("grid.cells", grid.size[k].span.clone(), message, help);
        }
        sound.then(|| Lattice { corner: said_corner(block, grid), cell: cell.into(), count })
    }

    /// The grid, if it is not too large.
    fn counted(&mut self, block: &Block, lattice: Lattice) -> Option<Lattice> {
        let total: f64 = lattice.count.map(f64::from).iter().product();
        let [x, y, z] = lattice.count;
        let key = format!("blocks.{}.grid.box", block.name);
        let why = format!("{x} x {y} x {z} cells of {}", triple(lattice.cell, "m"));
        let text = format!("{total}");
        self.explain(format!("{key}.cells"), text, Provenance::Derived, &why);
        if total > MOST {
            let message = format!("`{}` would have {x} x {y} x {z} bricks", block.name);
            let help = "use larger cells or a smaller box; [[refine]] gives small bricks only where they are needed";
            self.error_at("geometry.count", &block.name, message, help);
            return None;
        }
        let span = grid_of(block).map_or(&block.name.span, |grid| &grid.cell.span);
        self.has_memory(block, total, span).then_some(lattice)
    }
}
