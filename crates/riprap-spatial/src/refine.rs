//! Splitting bricks 1 to 8: who is split, where the children lie, and what follows them.
//!
//! Octant `k` of a block has the bits `x + 2 y + 4 z`: bit set means the upper half along that axis. Split blocks
//! stay in the list without being alive and children are appended, eight for each split block in octant order, so
//! block numbers are stable. Balance: blocks that share a face never differ by more than one level;
//! the planner splits more blocks until that holds, also across a periodic wrap.
//!
//! Source: Tian & Li, eq. (4): child centroid = parent's corner + n L/4 with n = 1 or 3.

use riprap_geom::Vec3;

use super::region::{Bins, Bounds};
use super::setup::{BlockSpec, Load, LoadKind, Refinement, Region, Setup, Shape};
pub use super::state::lineage::Origin;

/// Most levels below the blocks as given: with more, the smallest edges come near the round-off of coordinates.
pub const MAX_LEVELS: u8 = 16;
/// Most blocks that splitting may make.
pub const MAX_BLOCKS: usize = 100_000_000;

/// Why blocks cannot be split.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum RefineError {
    /// Only bricks have eight similar parts.
    #[error(
        "block {name} is a polyhedron; only bricks can be split 1 to 8 (make the region smaller)"
    )]
    NotBrick {
        /// Its name.
        name: String,
    },
    /// More levels than coordinates can resolve.
    #[error("{levels} levels are asked for; at most {MAX_LEVELS} can be told apart")]
    TooDeep {
        /// Levels asked for.
        levels: u8,
    },
    /// Too many blocks.
    #[error(
        "the refinement makes more than {MAX_BLOCKS} blocks; use fewer levels or a smaller region"
    )]
    TooMany,
}

/// Name of block `b`: `rock.17/3` is octant 3 of `rock.17`.
#[must_use]
pub fn name(setup: &Setup, lineage: &[Origin], b: usize) -> String {
    let spec = setup.blocks[b].name;
    let mut text = setup
        .names
        .get(spec.base as usize)
        .cloned()
        .unwrap_or_default();
    if spec.number > 0 {
        text.push_str(&format!(".{}", spec.number));
    }
    let mut octants = Vec::new();
    let mut origin = lineage.get(b).copied().unwrap_or(Origin::GIVEN);
    while origin.parent != Origin::NONE {
        octants.push(origin.octant);
        origin = lineage[origin.parent as usize];
    }
    for octant in octants.iter().rev() {
        text.push_str(&format!("/{octant}"));
    }
    text
}

/// Centre and half edges of octant `octant` of a brick, m.
#[must_use]
pub fn child(centre: Vec3, half: Vec3, octant: u8) -> (Vec3, Vec3) {
    let sign = |bit: u8| if octant & bit != 0 { 0.5 } else { -0.5 };
    let side = Vec3::new(sign(1), sign(2), sign(4));
    (centre + side * half, 0.5 * half)
}

/// Bricks as a forest of octrees; finds neighbours and keeps the balance.
#[derive(Debug)]
pub struct Forest {
    cells: Vec<Cell>,
    bins: Bins,
    periodic: [Option<f64>; 3],
    splits: Vec<u32>,
    found: Vec<u32>,
}

#[derive(Clone, Copy, Debug)]
struct Cell {
    bounds: Bounds,
    level: u8,
    brick: bool,
    alive: bool,
    /// First child; 0 for none (block 0 is nobody's child).
    children: u32,
}

impl Forest {
    /// The blocks of a model; `alive` is false for blocks that were split or removed.
    #[must_use]
    pub fn new(setup: &Setup, lineage: &[Origin], alive: &[bool]) -> Self {
        let mut cells: Vec<Cell> = setup
            .blocks
            .iter()
            .zip(lineage)
            .zip(alive)
            .map(|((block, origin), &alive)| Cell {
                bounds: Bounds::of(&block.shape),
                level: origin.level,
                brick: matches!(block.shape, Shape::Brick { .. }),
                // Terrain is never divided, nor a neighbour of who is.
                alive: alive && !block.shape.is_terrain(),
                children: 0,
            })
            .collect();
        for (b, origin) in lineage.iter().enumerate() {
            if origin.parent != Origin::NONE && origin.octant == 0 {
                cells[origin.parent as usize].children = b as u32;
            }
        }
        let (mut boxes, mut numbers) = (Vec::new(), Vec::new());
        for (b, origin) in lineage.iter().enumerate() {
            if origin.parent == Origin::NONE {
                boxes.push(cells[b].bounds);
                numbers.push(b as u32);
            }
        }
        Self {
            bins: Bins::new(&boxes, &numbers),
            cells,
            periodic: setup.periodic,
            splits: Vec::new(),
            found: Vec::new(),
        }
    }

    /// Leaves a brick whole and out of the balance.
    pub fn freeze(&mut self, b: u32) {
        self.cells[b as usize].brick = false;
    }

    /// Parents in the order of splitting; the children of the `k`-th are the blocks `8 k` to `8 k + 7` after the
    /// blocks that existed before.
    #[must_use]
    pub fn into_splits(self) -> Vec<u32> {
        self.splits
    }

    /// Living blocks below `levels` that touch the region, ascending.
    #[must_use]
    pub fn touching(&self, region: &Region, levels: u8) -> Vec<u32> {
        self.leaves()
            .filter(|&b| {
                let cell = &self.cells[b as usize];
                cell.level < levels && cell.bounds.touches(region)
            })
            .collect()
    }

    /// Living blocks, ascending.
    pub fn leaves(&self) -> impl Iterator<Item = u32> + '_ {
        (0..self.cells.len() as u32).filter(|&b| self.cells[b as usize].alive)
    }

    /// Splits what one refinement asks for.
    ///
    /// # Errors
    /// `Err(Some(block))` for a polyhedron in the region, `Err(None)` for too many blocks.
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
    /// As `refine`: the block is a polyhedron, or there would be too many.
    pub fn split(&mut self, b: u32) -> Result<(), Option<u32>> {
        let cell = self.cells[b as usize];
        if !cell.alive {
            return Ok(());
        }
        if !cell.brick {
            return Err(Some(b));
        }
        loop {
            let coarser = self.face_neighbours(b).into_iter().find(|&n| {
                let other = &self.cells[n as usize];
                other.brick && other.level < cell.level
            });
            match coarser {
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
            let (centre, half) = child(cell.bounds.centre, cell.bounds.half, octant);
            self.cells.push(Cell {
                bounds: Bounds { centre, half },
                level: cell.level + 1,
                children: 0,
                ..cell
            });
        }
        Ok(())
    }

    /// Living blocks that share part of a face with block `b`, ascending.
    pub fn face_neighbours(&mut self, b: u32) -> Vec<u32> {
        let own = self.cells[b as usize].bounds;
        let mut neighbours = Vec::new();
        let mut roots = std::mem::take(&mut self.found);
        for shift in images(self.periodic) {
            let image = Bounds {
                centre: own.centre + shift,
                ..own
            };
            self.bins.near(&image, &mut roots);
            for &root in &roots {
                self.descend(root, &image, &mut neighbours);
            }
        }
        self.found = roots;
        neighbours.sort_unstable();
        neighbours.dedup();
        neighbours
    }

    fn descend(&self, b: u32, image: &Bounds, out: &mut Vec<u32>) {
        let cell = &self.cells[b as usize];
        if cell.alive {
            if cell.bounds.share_face(image) {
                out.push(b);
            }
        } else if cell.children != 0
            && cell.bounds.gaps(image).max_element()
                <= super::region::TOUCH * image.half.max_element()
        {
            for k in 0..8 {
                self.descend(cell.children + k, image, out);
            }
        }
    }
}

/// Shifts under which a block meets its images across the wrap, no shift first.
fn images(periodic: [Option<f64>; 3]) -> Vec<Vec3> {
    let mut shifts = vec![Vec3::ZERO];
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
pub fn before_run(setup: &mut Setup) -> Result<Vec<Origin>, RefineError> {
    let mut lineage = vec![Origin::GIVEN; setup.blocks.len()];
    let alive = vec![true; setup.blocks.len()];
    let asked: Vec<Refinement> = setup
        .refinements
        .iter()
        .filter(|r| r.during.is_none())
        .cloned()
        .collect();
    if asked.is_empty() {
        return Ok(lineage);
    }
    let mut forest = Forest::new(setup, &lineage, &alive);
    for refinement in &asked {
        if refinement.levels > MAX_LEVELS {
            return Err(RefineError::TooDeep {
                levels: refinement.levels,
            });
        }
        forest
            .refine(&refinement.around, refinement.levels)
            .map_err(|block| why(setup, &lineage, block))?;
    }
    let splits = forest.into_splits();
    append_children(setup, &mut lineage, &splits);
    follow(setup, &lineage, &splits);
    Ok(lineage)
}

/// The error of a forest in words.
#[must_use]
pub fn why(setup: &Setup, lineage: &[Origin], block: Option<u32>) -> RefineError {
    match block {
        None => RefineError::TooMany,
        Some(b) => RefineError::NotBrick {
            name: name(setup, lineage, b as usize),
        },
    }
}

/// Appends the children of the split blocks; they move with the rigid motion of their parent at the start.
pub fn append_children(setup: &mut Setup, lineage: &mut Vec<Origin>, splits: &[u32]) {
    for &parent in splits {
        let spec = setup.blocks[parent as usize].clone();
        let Shape::Brick { centre, half } = spec.shape else {
            unreachable!("only bricks are split")
        };
        let level = lineage[parent as usize].level + 1;
        for octant in 0..8 {
            let (at, size) = child(centre, half, octant);
            setup.blocks.push(BlockSpec {
                shape: Shape::Brick {
                    centre: at,
                    half: size,
                },
                velocity: spec.velocity + spec.spin.cross(at - centre),
                ..spec.clone()
            });
            lineage.push(Origin {
                parent,
                octant,
                level,
            });
        }
    }
}

/// Lets the lists of the setup follow splits: who named a split block names its children too.
///
/// A force at a point goes to the child that holds the point, a force at the centroid and a moment to all eight in
/// equal parts.
pub fn follow(setup: &mut Setup, lineage: &[Origin], splits: &[u32]) {
    if splits.is_empty() {
        return;
    }
    let mut first_child = vec![0u32; setup.blocks.len()];
    let start = lineage.len() - 8 * splits.len();
    for (k, &parent) in splits.iter().enumerate() {
        first_child[parent as usize] = (start + 8 * k) as u32;
    }
    let extend = |blocks: &mut Vec<u32>| {
        let mut k = 0;
        while k < blocks.len() {
            let first = first_child[blocks[k] as usize];
            if first != 0 {
                blocks.extend(first..first + 8);
            }
            k += 1;
        }
        blocks.sort_unstable();
        blocks.dedup();
    };
    setup.block_lists().for_each(extend);
    let mut k = 0;
    while k < setup.loads.len() {
        match setup.loads[k].kind {
            LoadKind::BodyForce { .. } => extend(&mut setup.loads[k].blocks),
            LoadKind::Point { .. } | LoadKind::Moment { .. } => {
                let made = shares(setup, &setup.loads[k], &first_child);
                setup.loads[k]
                    .blocks
                    .retain(|&b| first_child[b as usize] == 0);
                setup.loads.extend(made);
            }
        }
        k += 1;
    }
    setup.loads.retain(|l| !l.blocks.is_empty());
}

/// The parts of a load that go to the children of its split blocks.
fn shares(setup: &Setup, load: &Load, first_child: &[u32]) -> Vec<Load> {
    let mut made = Vec::new();
    for &b in &load.blocks {
        let first = first_child[b as usize];
        if first == 0 {
            continue;
        }
        let all: Vec<u32> = (first..first + 8).collect();
        let (blocks, kind) = match load.kind {
            LoadKind::Point {
                force,
                at: Some(point),
            } => {
                let centre = Bounds::of(&setup.blocks[b as usize].shape).centre;
                let bit = |a: usize| u32::from(point[a] >= centre[a]) << a;
                (
                    vec![first + bit(0) + bit(1) + bit(2)],
                    LoadKind::Point {
                        force,
                        at: Some(point),
                    },
                )
            }
            LoadKind::Point { force, at: None } => (
                all,
                LoadKind::Point {
                    force: force / 8.0,
                    at: None,
                },
            ),
            LoadKind::Moment { moment } => (
                all,
                LoadKind::Moment {
                    moment: moment / 8.0,
                },
            ),
            LoadKind::BodyForce { .. } => continue,
        };
        made.push(Load {
            blocks,
            kind,
            time: load.time.clone(),
        });
    }
    made
}

#[cfg(test)]
mod tests;
