//! Elements of a .msh file.

use std::collections::BTreeSet;

use super::reader::{Coding, FileError, Reader};
use super::{File, Version};
use riprap_geom::Vec3;
use riprap_geom::polyhedron::{Polyhedron, SolidError};

/// Shape of a volume element.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum CellKind {
    /// 4 nodes.
    Tetrahedron,
    /// 5 nodes.
    Pyramid,
    /// 6 nodes.
    Prism,
    /// 8 nodes.
    Hexahedron,
}

impl CellKind {
    /// Number of nodes.
    #[must_use]
    pub fn nodes(self) -> usize {
        match self {
            Self::Tetrahedron => 4,
            Self::Pyramid => 5,
            Self::Prism => 6,
            Self::Hexahedron => 8,
        }
    }

    /// Corners of the faces, anticlockwise seen from outside an element with positive volume.
    #[must_use]
    pub fn faces(self) -> &'static [&'static [u32]] {
        match self {
            Self::Tetrahedron => &[&[0, 2, 1], &[0, 1, 3], &[1, 2, 3], &[0, 3, 2]],
            Self::Pyramid => &[&[0, 3, 2, 1], &[0, 1, 4], &[1, 2, 4], &[2, 3, 4], &[3, 0, 4]],
            Self::Prism => &[&[0, 2, 1], &[3, 4, 5], &[0, 1, 4, 3], &[1, 2, 5, 4], &[2, 0, 3, 5]],
            Self::Hexahedron => &[
                &[0, 3, 2, 1],
                &[4, 5, 6, 7],
                &[0, 1, 5, 4],
                &[1, 2, 6, 5],
                &[2, 3, 7, 6],
                &[3, 0, 4, 7],
            ],
        }
    }
}

/// A volume element.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Cell {
    /// Shape.
    pub kind: CellKind,
    /// Nodes in the order of Gmsh; those past the number of the shape are 0.
    pub nodes: [u32; 8],
    /// Its physical groups: place in [`super::Mesh::sets`].
    pub set: u32,
}

impl Cell {
    /// Its nodes.
    #[must_use]
    pub fn nodes(&self) -> &[u32] {
        &self.nodes[..self.kind.nodes()]
    }

    /// The element as a solid, at the nodes `at` of the mesh.
    ///
    /// # Errors
    /// It is not a convex solid with flat faces: a twisted hexahedron, for example.
    pub fn solid(&self, at: &[[f64; 3]]) -> Result<Polyhedron, SolidError> {
        let corners = self.nodes().iter().map(|&k| Vec3::from_array(at[k as usize]));
        let faces = self.kind.faces().iter().map(|f| f.to_vec());
        Polyhedron::new(corners.collect(), faces.collect())
    }
}

/// A triangle or quadrangle of a physical surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Facet {
    /// Nodes; of a triangle the last is repeated.
    pub nodes: [u32; 4],
    /// Its physical groups, one at least: place in [`super::Mesh::sets`].
    pub set: u32,
}

/// What an element type of Gmsh is to us.
enum Kind {
    Cell(CellKind),
    /// With 3 or 4 nodes.
    Facet(usize),
    /// Points and lines, with so many nodes.
    Passed(usize),
}

fn kind(reader: &Reader, number: i32) -> Result<Kind, FileError> {
    Ok(match number {
        1 => Kind::Passed(2),
        2 => Kind::Facet(3),
        3 => Kind::Facet(4),
        4 => Kind::Cell(CellKind::Tetrahedron),
        5 => Kind::Cell(CellKind::Hexahedron),
        6 => Kind::Cell(CellKind::Prism),
        7 => Kind::Cell(CellKind::Pyramid),
        15 => Kind::Passed(1),
        8..=14 | 16..=31 => {
            return Err(reader.wrong(format!(
                "elements of type {number} are of higher order; save the mesh with Mesh.ElementOrder = 1"
            )));
        }
        other => {
            return Err(reader.wrong(format!("unknown element type {other}")));
        }
    })
}

pub(super) fn read(
    file: &mut File,
    reader: &mut Reader,
    version: Version,
) -> Result<(), FileError> {
    match version {
        Version::Two => match reader.coding {
            Coding::Text => two_text(file, reader),
            Coding::Binary { .. } => two_binary(file, reader),
        },
        Version::Four => four(file, reader),
    }
}

fn two_text(file: &mut File, reader: &mut Reader) -> Result<(), FileError> {
    let count = reader.size("the number of elements")?;
    for _ in 0..reader.room(count, 6, "elements")? {
        reader.int("the number of an element")?;
        let number = reader.int("the type of an element")?;
        let kind = kind(reader, number)?;
        let tags = reader.int("a number of tags")?;
        let group = first_tag(reader, tags)?;
        element(file, reader, &kind, group.as_slice(), true)?;
    }
    Ok(())
}

fn two_binary(file: &mut File, reader: &mut Reader) -> Result<(), FileError> {
    let count = reader.as_text(|r| r.size("the number of elements"))?;
    let mut left = reader.room(count, 8, "elements")?;
    reader.skip_to_data();
    while left > 0 {
        let number = reader.int("the type of elements")?;
        let kind = kind(reader, number)?;
        let here = reader.int("a number of elements")?;
        let tags = reader.int("a number of tags")?;
        let here = usize::try_from(here)
            .ok()
            .filter(|here| (1..=left).contains(here))
            .ok_or_else(|| reader.wrong(format!("{here} elements where at most {left} remain")))?;
        for _ in 0..here {
            reader.int("the number of an element")?;
            let group = first_tag(reader, tags)?;
            element(file, reader, &kind, group.as_slice(), true)?;
        }
        left -= here;
    }
    Ok(())
}

/// Reads the tags of an element of format 2.2; the first is the physical group, 0: none.
fn first_tag(reader: &mut Reader, tags: i32) -> Result<Option<i32>, FileError> {
    let count = u64::try_from(tags).map_err(|_| reader.wrong(format!("{tags} tags")))?;
    let mut group = None;
    for k in 0..reader.room(count, 2, "tags")? {
        // The sign is the orientation of the element.
        let tag = reader.int("a tag")?.saturating_abs();
        if k == 0 && tag != 0 {
            group = Some(tag);
        }
    }
    Ok(group)
}

fn four(file: &mut File, reader: &mut Reader) -> Result<(), FileError> {
    reader.skip_to_data();
    let blocks = reader.size("the number of element blocks")?;
    let count = reader.size("the number of elements")?;
    reader.size("the lowest element number")?;
    reader.size("the highest element number")?;
    reader.room(count, 4, "elements")?;
    for _ in 0..reader.room(blocks, 8, "element blocks")? {
        let dimension = reader.int("the dimension of an entity")?;
        let entity = reader.int("the number of an entity")?;
        let number = reader.int("the type of elements")?;
        let kind = kind(reader, number)?;
        let here = reader.size("a number of elements")?;
        let dimension = u8::try_from(dimension)
            .map_err(|_| reader.wrong(format!("an entity of dimension {dimension}")))?;
        let tags = file.physical.get(&(dimension, entity));
        let tags = tags.cloned().unwrap_or_default();
        for _ in 0..reader.room(here, 4, "elements")? {
            reader.size("the number of an element")?;
            element(file, reader, &kind, &tags, false)?;
        }
    }
    Ok(())
}

/// Reads the nodes of an element; `short`: numbers of 4 bytes.
fn element(
    file: &mut File,
    reader: &mut Reader,
    kind: &Kind,
    tags: &[i32],
    short: bool,
) -> Result<(), FileError> {
    let count = match kind {
        Kind::Cell(cell) => cell.nodes(),
        Kind::Facet(count) | Kind::Passed(count) => *count,
    };
    let mut nodes = [0; 8];
    for node in &mut nodes[..count] {
        let tag = if short {
            let tag = reader.int("a node of an element")?;
            u64::try_from(tag)
                .map_err(|_| reader.wrong(format!("an element with the node {tag}")))?
        } else {
            reader.size("a node of an element")?
        };
        *node = file.find(reader, tag)?;
    }
    match kind {
        Kind::Cell(kind) => {
            let set = file.set(3, tags);
            let kind = *kind;
            file.mesh.cells.push(Cell { kind, nodes, set });
        }
        Kind::Facet(count) => {
            file.mesh.others += 1;
            if !tags.is_empty() {
                let set = file.set(2, tags);
                let last = nodes[*count - 1];
                let nodes = [nodes[0], nodes[1], nodes[2], last];
                file.mesh.facets.push(Facet { nodes, set });
            }
        }
        Kind::Passed(_) => file.mesh.others += 1,
    }
    Ok(())
}

/// Takes elements that are there more than once as one: format 2.2 repeats an element for each of its physical groups. The
/// first one stays and has the groups of all.
pub(super) fn join_repeated(file: &mut File) {
    let cells = &file.mesh.cells;
    let mut order: Vec<([u32; 8], usize)> = cells
        .iter()
        .enumerate()
        .map(|(place, cell)| {
            let mut nodes = cell.nodes;
            nodes[..cell.kind.nodes()].sort_unstable();
            (nodes, place)
        })
        .collect();
    // Among equals by their place in the file, so that the first one stays.
    order.sort_unstable();
    let mut repeated = vec![false; cells.len()];
    // Each repetition behind the first one.
    let mut again: Vec<(usize, usize)> = Vec::new();
    let mut first = 0;
    for pair in order.windows(2) {
        let [before, here] = [pair[0].1, pair[1].1];
        if pair[0].0 == pair[1].0 && cells[before].kind == cells[here].kind {
            first = if repeated[before] { first } else { before };
            repeated[here] = true;
            again.push((first, here));
        }
    }
    for list in again.chunk_by(|a, b| a.0 == b.0) {
        let first = list[0].0;
        let mut groups = file.mesh.groups_of(file.mesh.cells[first].set).to_vec();
        let mut known: BTreeSet<u32> = groups.iter().copied().collect();
        for (_, here) in list {
            let more = file.mesh.groups_of(file.mesh.cells[*here].set);
            groups.extend(more.iter().filter(|group| known.insert(**group)));
        }
        file.mesh.cells[first].set = file.set_of(groups);
    }
    let mut place = 0;
    file.mesh.cells.retain(|_| {
        place += 1;
        !repeated[place - 1]
    });
}
