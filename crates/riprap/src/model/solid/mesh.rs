//! Blocks from meshes of Gmsh, tessellations of Neper and surfaces in STL.

use std::collections::{BTreeMap, BTreeSet};

use riprap_geom::Vec3;
use riprap_geom::polyhedron::{Polyhedron, hull};

use crate::model::builder::Builder;
use crate::scenario::Name;
use crate::scenario::foreign;
use crate::scenario::foreign::obj::{self, Obj};
use crate::scenario::foreign::stl::{Part, parse_stl};
use crate::scenario::foreign::tess::{Cells, parse_tess};
use crate::scenario::language::{self, Block};
use crate::scenario::msh::{MAX_MSH_SIZE, Mesh, parse_msh};
use crate::scenario::read::Provenance;
use crate::spatial::setup::{Shape, Solid};

/// Most elements of a mesh.
const MOST: usize = 4_000_000;
/// A node of a facet is in the plane of a face if it is nearer than this share of its block.
const IN_PLANE: f64 = 1e-6;

/// Groups of a mesh: name, and places of the blocks among those of the table.
type Groups = Vec<(String, Vec<u32>)>;
/// Faces of a mesh by name: place of the block, unit outward normal, distance from the local origin along it (m).
pub(super) type Surfaces = Vec<(String, Vec<(u32, Vec3, f64)>)>;

/// What a table makes in space.
#[derive(Default)]
pub(super) struct Made {
    pub(super) shapes: Vec<Shape>,
    pub(super) groups: Groups,
    pub(super) surfaces: Surfaces,
}

impl Made {
    pub(super) fn of(shapes: Vec<Shape>) -> Self {
        Made { shapes, ..Made::default() }
    }
}

/// A solid as a shape.
pub(super) fn shape_of(solid: Polyhedron) -> Shape {
    Shape::Polyhedron(Box::new(Solid { vertices: solid.vertices, faces: solid.faces }))
}

impl Builder<'_> {
    /// The cells of a file as blocks in local coordinates, and what is named there; `None` after an error.
    pub(super) fn mesh(
        &mut self,
        block: &Block,
        said: &language::Mesh,
        shift: Vec3,
    ) -> Option<Made> {
        let mut read = self.reading(format!("blocks.{}.mesh", block.name), said);
        let unit = read.unit_or(1.0, Provenance::Default, "");
        let made = if let Some(file) = &said.tess {
            Made::of(self.tess(file, unit, shift)?)
        } else if let Some(file) = &said.stl {
            Made::of(self.stl(file, unit, shift)?)
        } else if let Some(file) = &said.obj {
            let obj = self.obj(file)?;
            let help = "each part of each object must be a closed convex surface";
            let solids = self.foreign_file(file, |_| obj.solids(), help)?;
            self.obj_solids(block, file, &obj, solids, unit, shift)?
        } else {
            self.msh(block, said, said.msh.as_ref()?, unit, shift)?
        };
        let count = made.shapes.len().to_string();
        let key = format!("blocks.{}.mesh", block.name);
        self.explain(key, count, Provenance::Derived, "cells of the file");
        Some(made)
    }

    fn tess(&mut self, file: &Name, unit: f64, shift: Vec3) -> Option<Vec<Shape>> {
        let cells = self.foreign_file(file, parse_tess, "save it with `neper -T`")?;
        let Cells::Space(cells) = cells else {
            let message = format!("`{file}` is a two-dimensional tessellation");
            let help =
                "use `polygons.tess` in [space.planar], or generate it with `neper -T -dim 3`";
            self.error_at("file.tess", file, message, help);
            return None;
        };
        self.note_import(file, &format!("read {0} of {0} cells", cells.len()));
        let mut shapes = Vec::with_capacity(cells.len());
        for cell in cells {
            let places = cell.vertices.iter();
            let places = places.map(|p| unit * Vec3::from_array(*p) + shift);
            match Polyhedron::new(places.collect(), cell.faces) {
                Ok(solid) => shapes.push(shape_of(solid)),
                Err(error) => {
                    let message = format!(
                        "`{file}`, line {}: cell {} cannot be a block: {error}",
                        cell.line, cell.number
                    );
                    let help = "cells must be convex with flat faces; generate them without regularisation (`-reg 0`)";
                    self.error_at("file.tess", file, message, help);
                    return None;
                }
            }
        }
        Some(shapes)
    }

    /// The parts of an OBJ file as blocks; those of each name are a group.
    pub(super) fn obj_solids(
        &mut self,
        block: &Block,
        file: &Name,
        obj: &Obj,
        solids: Vec<obj::Solid>,
        unit: f64,
        shift: Vec3,
    ) -> Option<Made> {
        let left = match obj.others {
            0 => String::new(),
            others => format!("; left out {others} because they are points, lines or curves"),
        };
        let count = obj.count();
        let words = format!(
            "read {count} of {} entities as {} solids{left}",
            count + obj.others,
            solids.len()
        );
        self.note_import(file, &words);
        let (mut shapes, mut groups) = (Vec::new(), BTreeMap::<String, Vec<u32>>::new());
        for solid in solids {
            let named = groups.entry(solid.name.clone().unwrap_or_default());
            named.or_default().push(shapes.len() as u32);
            let what = solid.name.unwrap_or_else(|| format!("part {}", shapes.len() + 1));
            shapes.push(self.hull_of(file, &solid.part, &what, unit, shift)?);
        }
        groups.remove("");
        for name in groups.keys() {
            self.group_of_file(block, file, name)?;
        }
        Some(Made { shapes, groups: groups.into_iter().collect(), ..Made::default() })
    }

    /// A closed convex part of a file as a block; `None` after an error.
    fn hull_of(
        &mut self,
        file: &Name,
        part: &Part,
        what: &str,
        unit: f64,
        shift: Vec3,
    ) -> Option<Shape> {
        let places = part.points.iter();
        let places: Vec<Vec3> = places.map(|p| unit * Vec3::from_array(*p) + shift).collect();
        match hull(&places) {
            Ok(solid) => Some(shape_of(solid)),
            Err(error) => {
                let message =
                    format!("`{file}`, {}: {what} cannot be a block: {error}", part.place);
                let help = "each connected part must be a closed convex surface";
                self.error_at("file.shape", file, message, help);
                None
            }
        }
    }

    fn stl(&mut self, file: &Name, unit: f64, shift: Vec3) -> Option<Vec<Shape>> {
        let parts = self.foreign_file(file, parse_stl, "save it as ASCII or binary STL")?;
        self.note_import(file, &format!("read {0} of {0} parts", parts.len()));
        let parts = (1..).zip(&parts);
        parts
            .map(|(number, part)| self.hull_of(file, part, &format!("part {number}"), unit, shift))
            .collect()
    }

    /// The elements of a mesh of Gmsh.
    fn msh(
        &mut self,
        block: &Block,
        said: &language::Mesh,
        file: &Name,
        unit: f64,
        shift: Vec3,
    ) -> Option<Made> {
        let path = self.parsed.folder.join(file.as_str());
        let mesh = match foreign::read_up_to(&path, MAX_MSH_SIZE, parse_msh) {
            Ok(mesh) => mesh,
            Err(refused) => {
                let help = "save the mesh with `gmsh -3 -format msh41`".to_owned();
                let help = refused.help.unwrap_or(help);
                self.error_at("file.msh", file, refused.message, &help);
                return None;
            }
        };
        let chosen = self.chosen(said, file, &mesh)?;
        self.note_import(file, &elements_text(&mesh, chosen.len()));
        if chosen.len() > MOST {
            let message = format!("`{file}` has {} elements", chosen.len());
            let help = format!("at most {MOST} are allowed; use a coarser mesh");
            self.error_at("file.msh", file, message, &help);
            return None;
        }
        let at: Vec<[f64; 3]> =
            mesh.nodes.iter().map(|p| (unit * Vec3::from_array(*p) + shift).to_array()).collect();
        let mut solids = Vec::with_capacity(chosen.len());
        for &k in &chosen {
            match mesh.cells[k].solid(&at) {
                Ok(solid) => solids.push(solid),
                Err(error) => {
                    let middle = middle(&mesh, k);
                    let message = format!(
                        "`{file}`: volume element {} near ({}, {}, {}) cannot be a block: {error}",
                        k + 1,
                        middle.x,
                        middle.y,
                        middle.z
                    );
                    let help = "faces must be flat and elements must not be inverted; mesh with tetrahedra, or extrude";
                    self.error_at("file.msh", file, message, help);
                    return None;
                }
            }
        }
        let (groups, surfaces) = physical(&mesh, &chosen, &solids, &at);
        for (name, _) in &groups {
            self.group_of_file(block, file, name)?;
        }
        Some(Made { shapes: solids.into_iter().map(shape_of).collect(), groups, surfaces })
    }

    /// Elements of the physical volume asked for, or all.
    fn chosen(&mut self, said: &language::Mesh, file: &Name, mesh: &Mesh) -> Option<Vec<usize>> {
        let Some(volume) = &said.volume else {
            return Some((0..mesh.cells.len()).collect());
        };
        let is = |k: u32| {
            let group = &mesh.groups[k as usize];
            group.dimension == 3 && group.name == volume.as_str()
        };
        let cells = mesh.cells.iter().enumerate();
        let chosen: Vec<usize> = cells
            .filter(|(_, c)| mesh.groups_of(c.set).iter().any(|k| is(*k)))
            .map(|(k, _)| k)
            .collect();
        if chosen.is_empty() {
            let volumes = mesh.groups.iter().filter(|g| g.dimension == 3);
            let names: Vec<&str> = volumes.map(|g| g.name.as_str()).collect();
            let message = format!("`{file}` has no physical volume `{volume}`");
            let help = if names.is_empty() {
                "it has no physical volumes; leave `volume` out".to_owned()
            } else {
                format!("valid names: {}", names.join(", "))
            };
            self.error_at("file.msh", volume, message, &help);
            return None;
        }
        Some(chosen)
    }
}

/// What became of the elements of a mesh.
fn elements_text(mesh: &Mesh, chosen: usize) -> String {
    let all = mesh.cells.len() + mesh.others;
    let mut words = format!("read {chosen} of {all} elements as blocks");
    if mesh.others > 0 {
        let others = mesh.others;
        words.push_str(&format!("; left out {others} because they are surfaces, lines or points"));
    }
    if mesh.cells.len() > chosen {
        let beside = mesh.cells.len() - chosen;
        words.push_str(&format!("; left out {beside} because they are in other volumes"));
    }
    words
}

/// Physical groups with the places of their blocks among the chosen elements, and the faces of physical surfaces.
fn physical(
    mesh: &Mesh,
    chosen: &[usize],
    solids: &[Polyhedron],
    at: &[[f64; 3]],
) -> (Groups, Surfaces) {
    let mut members: BTreeMap<u32, Vec<u32>> = BTreeMap::new();
    let mut sides: BTreeMap<u32, Vec<(u32, Vec3, f64)>> = BTreeMap::new();
    let mut facets: BTreeMap<BTreeSet<u32>, Vec<u32>> = BTreeMap::new();
    for facet in &mesh.facets {
        // As sets: a facet and the face of an element may begin at different nodes and go round the other way.
        let nodes: BTreeSet<u32> = facet.nodes.into_iter().collect();
        let groups = mesh.groups_of(facet.set);
        facets.entry(nodes).or_default().extend(groups);
    }
    for ((place, &k), solid) in (0u32..).zip(chosen).zip(solids) {
        let cell = &mesh.cells[k];
        for &group in mesh.groups_of(cell.set) {
            members.entry(group).or_default().push(place);
        }
        if facets.is_empty() {
            continue;
        }
        for face in cell.kind.faces() {
            let nodes: BTreeSet<u32> = face.iter().map(|c| cell.nodes[*c as usize]).collect();
            for &group in facets.get(&nodes).into_iter().flatten() {
                members.entry(group).or_default().push(place);
                let plane = plane_of(solid, nodes.iter().map(|n| at[*n as usize].into()));
                let plane = plane.map(|(normal, offset)| (place, normal, offset));
                sides.entry(group).or_default().extend(plane);
            }
        }
    }
    let name = |k: u32| mesh.groups[k as usize].name.clone();
    let groups = members.into_iter().map(|(k, blocks)| (name(k), blocks));
    let surfaces = sides.into_iter().map(|(k, faces)| (name(k), faces));
    (groups.collect(), surfaces.collect())
}

/// Plane of the face of a solid that holds some points.
fn plane_of(solid: &Polyhedron, points: impl Iterator<Item = Vec3> + Clone) -> Option<(Vec3, f64)> {
    let slack = IN_PLANE * solid.size();
    let planes = (0..solid.faces.len()).map(|face| solid.plane(face));
    let distance = |(normal, offset): (Vec3, f64)| {
        let heights = points.clone().map(|p| (normal.dot(p) - offset).abs());
        heights.fold(0.0, f64::max)
    };
    planes
        .map(|plane| (plane, distance(plane)))
        .filter(|(_, distance)| *distance <= slack)
        .min_by(|a, b| a.1.total_cmp(&b.1))
        .map(|(plane, _)| plane)
}

/// Mean of the nodes of an element, in the unit of the file.
fn middle(mesh: &Mesh, k: usize) -> Vec3 {
    let nodes = mesh.cells[k].nodes();
    let sum: Vec3 = nodes.iter().map(|n| Vec3::from_array(mesh.nodes[*n as usize])).sum();
    sum / nodes.len() as f64
}
