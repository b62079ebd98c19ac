//! Meshes of Gmsh: `.msh` files of the formats 2.2 and 4.1, text and binary, with physical groups.
//!
//! Read are the nodes, the volume elements of first order (tetrahedra, hexahedra, prisms, pyramids) as blocks and
//! triangles and quadrangles of physical surfaces. Other elements and sections are passed over. A broken file gives
//! an error with its line or byte; no count in it is trusted with more memory than the file itself has.
//!
//! Source: Gmsh reference manual, chapter "Gmsh file formats".

use std::collections::BTreeMap;

mod elements;
mod reader;
#[cfg(test)]
mod tests;

pub use elements::{Cell, CellKind, Facet};
pub use reader::{FileError, Place};

use reader::{Coding, Reader};

/// Most physical groups of an entity: each of its elements is in all of them.
const MOST_GROUPS: u64 = 32;

/// Largest file accepted, bytes.
pub const MAX_MSH_SIZE: u64 = 1 << 30;

/// A mesh.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// Places of the nodes, in the length unit of the file.
    pub nodes: Vec<[f64; 3]>,
    /// Volume elements: the blocks.
    pub cells: Vec<Cell>,
    /// Triangles and quadrangles of physical surfaces.
    pub facets: Vec<Facet>,
    /// Elements that are no volumes: surfaces, lines and points.
    pub others: usize,
    /// Sets of groups that cells and facets are in: places in `groups`, each once. The first set is empty.
    pub sets: Vec<Vec<u32>>,
    /// Physical groups of volumes and surfaces, by dimension (2 or 3) and tag, and their names (the tag where the file
    /// has none).
    pub groups: Vec<Group>,
}

impl Mesh {
    /// Physical groups of a cell or facet with this set: places in `groups`.
    #[must_use]
    pub fn groups_of(&self, set: u32) -> &[u32] {
        self.sets.get(set as usize).map_or(&[], Vec::as_slice)
    }
}

/// A physical group.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Group {
    /// 3: of volumes, 2: of surfaces.
    pub dimension: u8,
    /// Number in Gmsh.
    pub tag: i32,
    /// Name.
    pub name: String,
}

/// The mesh that the bytes of a file describe.
///
/// # Errors
/// The first thing that is wrong, with its place.
pub fn parse_msh(bytes: &[u8]) -> Result<Mesh, FileError> {
    let mut reader = Reader::new(bytes);
    let mut file = File::default();
    let version = header(&mut reader)?;
    while let Some(name) = reader.section()? {
        match name {
            "PhysicalNames" => file.names(&mut reader)?,
            "Entities" if version == Version::Four => file.entities(&mut reader)?,
            "Nodes" => file.nodes(&mut reader, version)?,
            "Elements" => elements::read(&mut file, &mut reader, version)?,
            other => {
                reader.skip(other)?;
                continue;
            }
        }
        reader.end(name)?;
    }
    file.finish(&reader)
}

/// Formats that can be read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Version {
    Two,
    Four,
}

fn header(reader: &mut Reader) -> Result<Version, FileError> {
    if reader.word() != Some("$MeshFormat") {
        return Err(reader.wrong("this is not a .msh file: it does not begin with $MeshFormat"));
    }
    let version = reader.word().unwrap_or_default().to_owned();
    let version = match version.as_str() {
        "2.2" | "2.1" | "2" => Version::Two,
        "4.1" => Version::Four,
        other => {
            let shown: String = other.chars().take(20).collect();
            return Err(reader.wrong(format!(
                "the format is {shown:?}, but only 4.1 and 2.2 can be read; save the mesh with -format msh41 or msh22"
            )));
        }
    };
    let kind = reader.int("the kind of file")?;
    let size = reader.int("the size of a number")?;
    if size != 8 {
        return Err(reader.wrong(format!("numbers have {size} bytes; they must have 8")));
    }
    match kind {
        0 => {}
        1 => {
            reader.next_line();
            reader.coding = Coding::Binary { swapped: false };
            let one = reader.int("the number 1")?;
            if one == 1_i32.swap_bytes() {
                reader.coding = Coding::Binary { swapped: true };
            } else if one != 1 {
                return Err(reader.wrong("the number 1 that defines the byte order is missing"));
            }
        }
        other => {
            return Err(reader
                .wrong(format!("the kind of file is {other}; it must be 0 (text) or 1 (binary)")));
        }
    }
    reader.end("MeshFormat")?;
    Ok(version)
}

/// What has been read so far.
#[derive(Default)]
struct File {
    mesh: Mesh,
    /// Tag and place of each node, sorted by tag.
    tags: Vec<(u64, u32)>,
    /// Physical groups of each entity of format 4.1, by dimension and tag.
    physical: BTreeMap<(u8, i32), Vec<i32>>,
    names: BTreeMap<(u8, i32), String>,
    /// Place of each group in the mesh, by dimension and tag.
    groups: BTreeMap<(u8, i32), u32>,
    /// Place of each set of groups in the mesh.
    sets: BTreeMap<Vec<u32>, u32>,
    seen_nodes: bool,
}

impl File {
    fn names(&mut self, reader: &mut Reader) -> Result<(), FileError> {
        reader.as_text(|reader| {
            let count = reader.size("the number of names")?;
            for _ in 0..reader.room(count, 6, "names")? {
                let dimension = reader.int("the dimension of a group")?;
                let tag = reader.int("the number of a group")?;
                let quoted = reader.line();
                let name = quoted.trim_matches('"').to_owned();
                if let Ok(dimension @ 0..=3) = u8::try_from(dimension) {
                    self.names.insert((dimension, tag), name);
                } else {
                    return Err(reader.wrong(format!("a group of dimension {dimension}")));
                }
            }
            Ok(())
        })
    }

    fn entities(&mut self, reader: &mut Reader) -> Result<(), FileError> {
        reader.skip_to_data();
        let mut counts = [0; 4];
        for count in &mut counts {
            *count = reader.size("a number of entities")?;
        }
        for (dimension, count) in (0_u8..4).zip(counts) {
            for _ in 0..reader.room(count, 8, "entities")? {
                let tag = reader.int("the number of an entity")?;
                for _ in 0..if dimension == 0 { 3 } else { 6 } {
                    reader.number("a bound of an entity")?;
                }
                let groups = reader.size("a number of groups")?;
                if groups > MOST_GROUPS {
                    return Err(reader.wrong(format!(
                        "an entity is in {groups} physical groups; at most {MOST_GROUPS} are allowed"
                    )));
                }
                for _ in 0..reader.room(groups, 2, "groups")? {
                    // A negative number tells the orientation of the entity, not another group.
                    let group = reader.int("the number of a group")?.saturating_abs();
                    let known = self.physical.entry((dimension, tag)).or_default();
                    if !known.contains(&group) {
                        known.push(group);
                    }
                }
                if dimension > 0 {
                    let bounds = reader.size("a number of bounding entities")?;
                    for _ in 0..reader.room(bounds, 2, "bounding entities")? {
                        reader.int("a bounding entity")?;
                    }
                }
            }
        }
        Ok(())
    }

    fn nodes(&mut self, reader: &mut Reader, version: Version) -> Result<(), FileError> {
        if std::mem::replace(&mut self.seen_nodes, true) {
            return Err(reader.wrong("a second section $Nodes"));
        }
        match version {
            Version::Two => {
                let count = reader.as_text(|r| r.size("the number of nodes"))?;
                let count = reader.room(count, 8, "nodes")?;
                reader.skip_to_data();
                for _ in 0..count {
                    let tag = reader.int("the number of a node")?;
                    let tag = u64::try_from(tag)
                        .map_err(|_| reader.wrong(format!("a node with the number {tag}")))?;
                    self.node(reader, tag)?;
                }
            }
            Version::Four => {
                reader.skip_to_data();
                let blocks = reader.size("the number of node blocks")?;
                let count = reader.size("the number of nodes")?;
                reader.size("the lowest node number")?;
                reader.size("the highest node number")?;
                // Looked at only: each block says again how many it has.
                reader.room(count, 8, "nodes")?;
                let mut tags = Vec::new();
                for _ in 0..reader.room(blocks, 8, "node blocks")? {
                    let dimension = reader.int("the dimension of an entity")?;
                    reader.int("the number of an entity")?;
                    let parametric = reader.int("a sign for parameters")? != 0;
                    let here = reader.size("a number of nodes")?;
                    let here = reader.room(here, 8, "nodes")?;
                    tags.clear();
                    for _ in 0..here {
                        tags.push(reader.size("the number of a node")?);
                    }
                    for &tag in &tags {
                        self.node(reader, tag)?;
                        if parametric {
                            for _ in 0..dimension.clamp(0, 3) {
                                reader.number("a parameter of a node")?;
                            }
                        }
                    }
                }
            }
        }
        // Searched, since numbers may be anything: a table up to the largest could be longer than memory.
        self.tags.sort_unstable();
        if let Some(pair) = self.tags.windows(2).find(|pair| pair[0].0 == pair[1].0) {
            return Err(reader.wrong(format!("two nodes have the number {}", pair[0].0)));
        }
        Ok(())
    }

    fn node(&mut self, reader: &mut Reader, tag: u64) -> Result<(), FileError> {
        let mut at = [0.0; 3];
        for x in &mut at {
            *x = reader.number("a coordinate")?;
        }
        self.tags.push((tag, self.mesh.nodes.len() as u32));
        self.mesh.nodes.push(at);
        Ok(())
    }

    /// Place of the node with a tag.
    fn find(&self, reader: &Reader, tag: u64) -> Result<u32, FileError> {
        match self.tags.binary_search_by_key(&tag, |(tag, _)| *tag) {
            Ok(place) => Ok(self.tags[place].1),
            Err(_) => {
                Err(reader.wrong(format!("an element uses node {tag}, which does not exist")))
            }
        }
    }

    /// Number of the group with a tag, which is added if it is new.
    fn group(&mut self, dimension: u8, tag: i32) -> u32 {
        let groups = &mut self.mesh.groups;
        let names = &self.names;
        *self.groups.entry((dimension, tag)).or_insert_with(|| {
            let name = names.get(&(dimension, tag));
            groups.push(Group {
                dimension,
                tag,
                name: name.cloned().unwrap_or_else(|| tag.to_string()),
            });
            groups.len() as u32 - 1
        })
    }

    /// The set of the groups with these tags.
    fn set(&mut self, dimension: u8, tags: &[i32]) -> u32 {
        let groups: Vec<u32> = tags.iter().map(|tag| self.group(dimension, *tag)).collect();
        self.set_of(groups)
    }

    /// The set of these groups, each of which is there once.
    fn set_of(&mut self, groups: Vec<u32>) -> u32 {
        let sets = &mut self.mesh.sets;
        if sets.is_empty() {
            // That of no groups.
            sets.push(Vec::new());
        }
        if groups.is_empty() {
            return 0;
        }
        if let Some(set) = self.sets.get(&groups) {
            return *set;
        }
        sets.push(groups.clone());
        let set = sets.len() as u32 - 1;
        self.sets.insert(groups, set);
        set
    }

    fn finish(mut self, reader: &Reader) -> Result<Mesh, FileError> {
        elements::join_repeated(&mut self);
        if self.mesh.cells.is_empty() {
            return Err(reader.wrong(
                "the mesh has no volume elements; mesh in 3 dimensions, and if there are physical groups, put the volumes into one",
            ));
        }
        Ok(self.mesh)
    }
}
