//! Splitting blocks 1 to 8: who is split, where the children lie, and what follows them.
//!
//! Bricks and parallelepipeds in any attitude can be split ([`Divisible`]). Octant `k` of a block has the bits `x + 2 y + 4 z`: bit set
//! means the upper half along that axis, of a parallelepiped along that edge (`Parallelepiped::of` says which). Split blocks
//! stay in the list without being alive and children are appended, eight for each split block in octant order, so
//! block numbers are stable. Balance: blocks that share a face never differ by more than one level;
//! the planner splits more blocks until that holds, also across a periodic wrap.
//!
//! Source: Tian & Li, section 2.

use crate::setup::error::{MAX_BLOCKS, MAX_LEVELS, RefineError};
use crate::state::lineage::name;
use crate::topology::family::{self, Family};
use riprap_geom::Vec3;
use riprap_geom::polyhedron::{Parallelepiped, Polyhedron};

use crate::faces::divisible::Divisible;
use crate::faces::region::{Bins, Bounds, Extent, TOUCH};
use crate::faces::solids::share_face;
use crate::setup::{BlockSpec, Refinement, Region, Setup};
pub(crate) use crate::state::lineage::Origin;

/// Blocks as a forest of octrees; finds neighbours and keeps the balance.
#[derive(Debug)]
pub(crate) struct Forest {
    cells: Vec<Cell>,
    bins: Bins,
    periodic: [Option<f64>; 3],
    splits: Vec<u32>,
    found: Vec<u32>,
}

#[derive(Debug)]
struct Cell {
    bounds: Bounds,
    level: u8,
    kind: Kind,
    alive: bool,
    /// First child; 0 for none (block 0 is nobody's child).
    children: u32,
}

#[derive(Debug)]
enum Kind {
    Brick,
    Leaning(Box<Parallelepiped>),
    /// It cannot be divided.
    Whole(Box<Extent>),
}

impl From<Divisible> for Kind {
    fn from(part: Divisible) -> Self {
        match part {
            Divisible::Brick(_) => Self::Brick,
            Divisible::Leaning(solid) => Self::Leaning(Box::new(solid)),
        }
    }
}

impl Cell {
    fn divisible(&self) -> Option<Divisible> {
        match &self.kind {
            Kind::Brick => Some(Divisible::Brick(self.bounds)),
            Kind::Leaning(solid) => Some(Divisible::Leaning(**solid)),
            Kind::Whole(_) => None,
        }
    }

    fn extent(&self) -> Extent {
        match &self.kind {
            Kind::Brick => Extent::Box(self.bounds),
            Kind::Leaning(solid) => Divisible::Leaning(**solid).extent(),
            Kind::Whole(extent) => (**extent).clone(),
        }
    }
}

impl Forest {
    /// The blocks of a model; `alive` is false for blocks that were split or removed.
    #[must_use]
    pub(crate) fn new(setup: &Setup, lineage: &[Origin], alive: &[bool]) -> Self {
        let blocks = setup.blocks.iter().zip(lineage).zip(alive);
        let cell = |((block, origin), &alive): ((&BlockSpec, &Origin), &bool)| Cell {
            bounds: Bounds::of(&block.shape),
            level: origin.level,
            kind: match Divisible::of(&block.shape) {
                Some(part) => part.into(),
                None => Kind::Whole(Box::new(Extent::of(&block.shape))),
            },
            // Terrain is never divided, nor a neighbour of who is.
            alive: alive && !block.shape.is_terrain(),
            children: 0,
        };
        let mut cells: Vec<Cell> = blocks.map(cell).collect();
        for (b, origin) in lineage.iter().enumerate() {
            if origin.parent != Origin::NONE && origin.octant == 0 {
                cells[origin.parent as usize].children = b as u32;
            }
        }
        // Blocks as given alone: their parts lie in them, so that splitting leaves the bins as they are.
        let (mut boxes, mut numbers) = (Vec::new(), Vec::new());
        for (b, origin) in lineage.iter().enumerate() {
            if origin.parent == Origin::NONE {
                boxes.push(cells[b].bounds);
                numbers.push(b as u32);
            }
        }
        let bins = Bins::new(&boxes, &numbers);
        let (splits, found) = (Vec::new(), Vec::new());
        let mut forest = Self { bins, cells, periodic: setup.periodic, splits, found };
        // Blocks that bend are cut and not split.
        let bend = setup.deform.sets.iter().flat_map(|set| &set.blocks);
        bend.for_each(|&b| forest.keep_whole(b));
        // Nor are blocks that were added: they are no neighbours of the start.
        let added = (0..).zip(lineage).filter(|(_, origin)| **origin == Origin::ADDED);
        added.for_each(|(b, _)| forest.keep_whole(b));
        forest
    }

    /// Leaves a block whole and out of the balance.
    pub(crate) fn keep_whole(&mut self, b: u32) {
        let cell = &mut self.cells[b as usize];
        cell.kind = Kind::Whole(Box::new(cell.extent()));
    }

    /// Parents in the order of splitting; the children of the `k`-th are the blocks `8 k` to `8 k + 7` after the
    /// blocks that existed before.
    #[must_use]
    pub(crate) fn into_splits(self) -> Vec<u32> {
        self.splits
    }

    /// Living blocks below `levels` that touch the region, ascending.
    #[must_use]
    pub(crate) fn touching(&self, region: &Region, levels: u8) -> Vec<u32> {
        self.leaves()
            .filter(|&b| {
                let cell = &self.cells[b as usize];
                cell.level < levels && cell.bounds.touches(region) && cell.extent().touches(region)
            })
            .collect()
    }

    /// Living blocks, ascending.
    pub(crate) fn leaves(&self) -> impl Iterator<Item = u32> + '_ {
        (0..self.cells.len() as u32).filter(|&b| self.cells[b as usize].alive)
    }

    /// Splits what one refinement asks for.
    ///
    /// # Errors
    /// `Err(Some(block))` for one in the region that cannot be divided, `Err(None)` for too many blocks.
    fn refine(&mut self, region: &Region, levels: u8) -> Result<(), Option<u32>> {
        for level in 1..=levels {
            for b in self.touching(region, level) {
                self.split(b)?;
            }
        }
        Ok(())
    }

    /// Splits a block if it is still whole, its coarser neighbours before it.
    ///
    /// # Errors
    /// As `refine`: the block cannot be divided, or there would be too many.
    pub(crate) fn split(&mut self, b: u32) -> Result<(), Option<u32>> {
        let &Cell { level, alive, .. } = &self.cells[b as usize];
        if !alive {
            return Ok(());
        }
        let Some(divisible) = self.cells[b as usize].divisible() else {
            return Err(Some(b));
        };
        loop {
            let coarser = self.face_neighbours(b).into_iter().find(|&n| {
                let other = &self.cells[n as usize];
                !matches!(other.kind, Kind::Whole(_)) && other.level < level
            });
            match coarser {
                // Its parts may still be coarser than this block: the neighbours are looked for again.
                Some(n) => self.split(n)?,
                None => break,
            }
        }
        if self.cells.len() + 8 > MAX_BLOCKS {
            return Err(None);
        }
        self.cells[b as usize].alive = false;
        self.cells[b as usize].children = self.cells.len() as u32;
        self.splits.push(b);
        for octant in 0..8 {
            let part = divisible.part(octant);
            self.cells.push(Cell {
                bounds: *part.extent().bounds(),
                level: level + 1,
                kind: part.into(),
                alive: true,
                children: 0,
            });
        }
        Ok(())
    }

    /// Living blocks that share part of a face with block `b`, ascending.
    pub(crate) fn face_neighbours(&mut self, b: u32) -> Vec<u32> {
        let own = &self.cells[b as usize];
        let mut neighbours = Vec::new();
        let mut roots = std::mem::take(&mut self.found);
        for shift in images(self.periodic) {
            let image = Image {
                bounds: Bounds { centre: own.bounds.centre + shift, ..own.bounds },
                solid: match &own.kind {
                    Kind::Brick => None,
                    Kind::Leaning(_) | Kind::Whole(_) => Some(own.extent().solid(shift)),
                },
            };
            self.bins.near(&image.bounds, &mut roots);
            for &root in &roots {
                self.descend(root, &image, &mut neighbours);
            }
        }
        self.found = roots;
        neighbours.sort_unstable();
        neighbours.dedup();
        neighbours
    }

    fn descend(&self, b: u32, image: &Image, out: &mut Vec<u32>) {
        let cell = &self.cells[b as usize];
        if cell.alive {
            if self.share_face(b, image) {
                out.push(b);
            }
        } else if cell.children != 0
            && cell.bounds.gaps(&image.bounds).max_element()
                <= TOUCH * image.bounds.half.max_element()
        {
            for k in 0..8 {
                self.descend(cell.children + k, image, out);
            }
        }
    }

    fn share_face(&self, b: u32, image: &Image) -> bool {
        let cell = &self.cells[b as usize];
        let solid = match (&image.solid, &cell.kind) {
            (None, Kind::Brick) => return cell.bounds.share_face(&image.bounds),
            (None, Kind::Leaning(_) | Kind::Whole(_)) => {
                &Extent::Box(image.bounds).solid(Vec3::ZERO)
            }
            (Some(solid), _) => solid,
        };
        let gap = TOUCH * cell.bounds.half.min(image.bounds.half).min_element();
        cell.bounds.gaps(&image.bounds).max_element() <= gap
            && share_face(&cell.extent().solid(Vec3::ZERO), solid, gap)
    }
}

/// A block, or its image across the wrap.
struct Image {
    bounds: Bounds,
    /// As a solid; `None` for a brick.
    solid: Option<Polyhedron>,
}

/// Shifts under which a block meets its images across the wrap, no shift first.
fn images(periodic: [Option<f64>; 3]) -> Vec<Vec3> {
    let mut shifts = vec![Vec3::ZERO];
    // One axis at a time: across two of them blocks share an edge and no face.
    for (a, period) in periodic.iter().enumerate() {
        if let Some(period) = period {
            let mut one = Vec3::ZERO;
            one[a] = *period;
            shifts.extend([one, -one]);
        }
    }
    shifts
}

/// Splits all blocks that the refinements before the first step ask for; returns where each block comes from.
///
/// Split blocks stay in the list (they are the parents of others). Groups, supports, loads, boundaries and sources
/// of a split block go over to its children.
///
/// # Errors
/// Polyhedra in a region, too many levels or blocks.
pub(crate) fn before_run(setup: &mut Setup) -> Result<Vec<Origin>, RefineError> {
    let mut lineage = vec![Origin::GIVEN; setup.blocks.len()];
    let alive = vec![true; setup.blocks.len()];
    let asked: Vec<Refinement> =
        setup.refinements.iter().filter(|r| r.during.is_none()).cloned().collect();
    if asked.is_empty() {
        return Ok(lineage);
    }
    let mut forest = Forest::new(setup, &lineage, &alive);
    for refinement in &asked {
        if refinement.levels > MAX_LEVELS {
            return Err(RefineError::TooDeep { levels: refinement.levels });
        }
        forest
            .refine(&refinement.around, refinement.levels)
            .map_err(|block| why(setup, &lineage, block))?;
    }
    let splits = forest.into_splits();
    append_children(setup, &mut lineage, &splits);
    Ok(lineage)
}

/// The error of a forest in words.
#[must_use]
pub(crate) fn why(setup: &Setup, lineage: &[Origin], block: Option<u32>) -> RefineError {
    match block {
        None => RefineError::TooMany,
        Some(b) => RefineError::Indivisible { name: name(setup, lineage, b as usize) },
    }
}

/// Appends the children of the split blocks, with the rigid motion of their parent at the start; lists that name blocks follow.
pub(crate) fn append_children(setup: &mut Setup, lineage: &mut Vec<Origin>, splits: &[u32]) {
    let families = in_eight(splits, lineage.len());
    for &parent in splits {
        let spec = &setup.blocks[parent as usize];
        let Some(whole) = Divisible::of(&spec.shape) else {
            unreachable!("only blocks with eight similar parts are split")
        };
        let (velocity, spin) = (spec.velocity, spec.spin);
        for octant in 0..8 {
            let part = whole.part(octant);
            let velocity = velocity + spin.cross(part.centre() - whole.centre());
            family::describe(setup, lineage, (parent, octant), (part.shape(), velocity));
        }
    }
    family::follow(setup, &families);
}

/// The families of blocks that are split in this order, with `blocks` blocks before.
pub(super) fn in_eight(splits: &[u32], blocks: usize) -> Vec<Family<'static>> {
    let firsts = (blocks as u32..).step_by(8);
    let one = |(&parent, first)| Family { parent, first, parts: &[], note: None };
    splits.iter().zip(firsts).map(one).collect()
}

#[cfg(test)]
mod tests;
