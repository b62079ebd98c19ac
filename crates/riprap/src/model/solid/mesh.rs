//! Blocks from meshes of Gmsh.

use std::collections::{BTreeMap, BTreeSet};

use riprap_geom::Vec3;

use crate::model::builder::Builder;
use crate::model::explain::Provenance;
use crate::scenario::language::{self, Block};
use crate::scenario::msh::{Mesh, read_msh};
use crate::spatial::setup::{Shape, Solid};

/// Most elements of a mesh.
const MOST: usize = 4_000_000;

/// Groups of a mesh: name, and places of the blocks among those of the table.
type Groups = Vec<(String, Vec<u32>)>;

impl Builder<'_> {
    /// The elements of a mesh as blocks in local coordinates, and the groups they belong to; `None` after an error.
    pub(super) fn mesh(
        &mut self,
        block: &Block,
        said: &language::Mesh,
        shift: Vec3,
    ) -> Option<(Vec<Shape>, Groups)> {
        let help = "save the mesh with `gmsh -3 -format msh41`; paths are seen from the folder of the scenario file";
        let mesh = match read_msh(&self.parsed.folder.join(said.msh.as_str())) {
            Ok(mesh) => mesh,
            Err(message) => {
                self.error_at("file.msh", &said.msh, message, help);
                return None;
            }
        };
        let key = format!("blocks.{}.mesh.unit", block.name);
        let unit = self.or(&key, said.unit.as_ref(), 1.0, "m");
        let chosen = self.chosen(said, &mesh)?;
        if chosen.len() > MOST {
            let message = format!("`{}` has {} elements", said.msh, chosen.len());
            let help = format!("a mesh has {MOST} at most: make it coarser");
            self.error_at("file.msh", &said.msh, message, &help);
            return None;
        }
        let count = chosen.len().to_string();
        let key = format!("blocks.{}.mesh", block.name);
        self.explain(key, count, Provenance::Derived, "volume elements");
        let at: Vec<[f64; 3]> = mesh
            .nodes
            .iter()
            .map(|p| (unit * Vec3::from_array(*p) + shift).to_array())
            .collect();
        let mut shapes = Vec::with_capacity(chosen.len());
        for &k in &chosen {
            match mesh.cells[k].solid(&at) {
                Ok(solid) => shapes.push(Shape::Polyhedron(Box::new(Solid {
                    vertices: solid.vertices,
                    faces: solid.faces,
                }))),
                Err(error) => {
                    let middle = middle(&mesh, k);
                    let message = format!(
                        "`{}`: volume element {} near ({}, {}, {}) cannot be a block: {error}",
                        said.msh,
                        k + 1,
                        middle.x,
                        middle.y,
                        middle.z
                    );
                    let help = "faces must be flat: mesh with tetrahedra, or extrude; and without elements that are \
                                turned inside out";
                    self.error_at("file.msh", &said.msh, message, help);
                    return None;
                }
            }
        }
        let groups = self.physical(block, said, &mesh, &chosen)?;
        Some((shapes, groups))
    }

    /// Elements of the physical volume asked for, or all.
    fn chosen(&mut self, said: &language::Mesh, mesh: &Mesh) -> Option<Vec<usize>> {
        let Some(volume) = &said.volume else {
            return Some((0..mesh.cells.len()).collect());
        };
        let is = |k: u32| {
            let group = &mesh.groups[k as usize];
            group.dimension == 3 && group.name == volume.as_str()
        };
        let cells = mesh.cells.iter().enumerate();
        let chosen: Vec<usize> = cells
            .filter(|(_, c)| c.group.is_some_and(is))
            .map(|(k, _)| k)
            .collect();
        if chosen.is_empty() {
            let volumes = mesh.groups.iter().filter(|g| g.dimension == 3);
            let names: Vec<&str> = volumes.map(|g| g.name.as_str()).collect();
            let message = format!("`{}` has no physical volume `{volume}`", said.msh);
            let help = if names.is_empty() {
                "it has none at all: leave `volume` out".to_owned()
            } else {
                format!("it has {}", names.join(", "))
            };
            self.error_at("file.msh", volume, message, &help);
            return None;
        }
        Some(chosen)
    }

    /// Physical groups with the places of their blocks among the chosen elements.
    fn physical(
        &mut self,
        block: &Block,
        said: &language::Mesh,
        mesh: &Mesh,
        chosen: &[usize],
    ) -> Option<Groups> {
        let mut members: BTreeMap<u32, Vec<u32>> = BTreeMap::new();
        let mut faces: BTreeMap<BTreeSet<u32>, Vec<u32>> = BTreeMap::new();
        for facet in &mesh.facets {
            let nodes: BTreeSet<u32> = facet.nodes.into_iter().collect();
            faces.entry(nodes).or_default().push(facet.group);
        }
        for (place, &k) in (0u32..).zip(chosen) {
            let cell = &mesh.cells[k];
            if let Some(group) = cell.group {
                members.entry(group).or_default().push(place);
            }
            if faces.is_empty() {
                continue;
            }
            for face in cell.kind.faces() {
                let nodes: BTreeSet<u32> = face.iter().map(|c| cell.nodes[*c as usize]).collect();
                for &group in faces.get(&nodes).into_iter().flatten() {
                    members.entry(group).or_default().push(place);
                }
            }
        }
        let taken = |name: &str| {
            let mut blocks = self.parsed.scenario.blocks.iter();
            name != block.name.as_str() && blocks.any(|b| b.name.as_str() == name)
        };
        let mut groups = Vec::new();
        for (k, blocks) in members {
            let name = mesh.groups[k as usize].name.clone();
            if taken(&name) {
                let message = format!(
                    "the physical group `{name}` of `{}` has the name of a [[blocks]] table",
                    said.msh
                );
                let help = "rename one of them";
                self.error_at("file.msh", &said.msh, message, help);
                return None;
            }
            groups.push((name, blocks));
        }
        Some(groups)
    }
}

/// Mean of the nodes of an element, in the unit of the file.
fn middle(mesh: &Mesh, k: usize) -> Vec3 {
    let nodes = mesh.cells[k].nodes();
    let sum: Vec3 = nodes
        .iter()
        .map(|n| Vec3::from_array(mesh.nodes[*n as usize]))
        .sum();
    sum / nodes.len() as f64
}
