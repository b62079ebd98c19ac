//! Terrain as cells of a depth, for blocks that carry theirs on tetrahedra.
//!
//! The prism below a triangle is cut into three tetrahedra, all with the depth of the terrain there, so that nothing depends on how it is cut or on how far
//! down it reaches: what lies deeper than any block does is in no overlap.

use riprap_geom::Vec3;

use crate::kernel::cells::TetFan;
use crate::kernel::grid::Box3;
use crate::kernel::terrain::Terrain;
use crate::kernel::tetra;

impl Terrain {
    /// Whether a box reaches below the surface somewhere, as far as the boxes of triangles tell.
    #[must_use]
    pub fn meets(&self, around: &Box3) -> bool {
        self.below(around).next().is_some()
    }

    /// Triangles whose prisms meet a box.
    fn below(&self, around: &Box3) -> impl Iterator<Item = &super::Cell> {
        let (low, high) = (around.low, around.high);
        let mut near = Vec::new();
        self.near.near([low.x, low.y], [high.x, high.y], &mut near);
        let cells = near.into_iter().map(|t| &self.cells[t as usize]);
        cells.filter(move |cell| {
            let [a, b, c] = cell.corners;
            let (least, most) = (a.min(b).min(c), a.max(b).max(c));
            most.cmpge(low).all() && least.truncate().cmple(high.truncate()).all()
        })
    }

    /// The prisms that meet a box, about its middle.
    #[must_use]
    pub fn prisms(&self, around: &Box3) -> TetFan {
        let mut star = TetFan { origin: 0.5 * (around.low + around.high), ..TetFan::default() };
        let height = (around.high - around.low).max_element();
        for cell in self.below(around) {
            let top = cell.corners.map(|corner| corner - star.origin);
            let floor = top.iter().map(|c| c.z).fold(around.low.z - star.origin.z, f64::min);
            let bottom = top.map(|c| Vec3::new(c.x, c.y, floor - height));
            let ([a, b, c], [d, e, f]) = (top, bottom);
            for corners in [[d, a, b, c], [d, e, b, c], [d, e, f, c]] {
                let places = corners.map(|corner| corner + star.origin);
                let depth = tetra::Cell::with_depth(corners, -cell.slope, cell.slope.dot(a));
                star.push(places, depth);
                star.keys.push(cell.facet);
            }
        }
        star
    }
}
