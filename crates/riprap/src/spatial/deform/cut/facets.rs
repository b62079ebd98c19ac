//! Bonds of cut blocks: with neighbours and between parts, by overlay, with the stretch they had.

use std::collections::{BTreeMap, BTreeSet};

use riprap_geom::Vec3;
use riprap_geom::face_overlay::{self, Fan, JointPoint};
use riprap_geom::polyhedron::cut::FaceOrigin;
use riprap_geom::polyhedron::{Tetrahedra, frame};

use super::pressed::Pressed;
use super::stretch::Stretch;
use super::{AREA, Family};
use crate::spatial::build::BuildError;
use crate::spatial::deform::bonds::Anchors;
use crate::spatial::deform::build::{face_with, place, stiffness};
use crate::spatial::deform::fracture::LOOK;
use crate::spatial::deform::in_situ::levers;
use crate::spatial::deform::store::{Anchor, Body, Deform, Facet, Memory, Point, Surface};
use crate::spatial::deform::workspace::{Workspace, centred};
use crate::spatial::edit::EditError;
use crate::spatial::world::World;

/// Share of a face below which faces share nothing.
const SLIVER: f64 = 1e-9;

/// A face of a block now, with its nodes in the lists of the model (numbers of its own for rigid blocks).
struct Piece {
    block: u32,
    /// Number of the face of a part.
    face: usize,
    fan: Fan,
}

/// Lists under construction.
#[derive(Default)]
struct Lists {
    facets: Vec<Facet>,
    worn: Vec<bool>,
    points: Vec<Point>,
    memory: Vec<Memory>,
    /// Area of new facets by block, face and node, m².
    covered: BTreeMap<(u32, usize, u32), f64>,
}

/// Makes the facets and surfaces of all families anew; returns the number of facets of each before and after.
pub(super) fn rebuild(
    world: &World,
    deform: &mut Deform,
    work: &Workspace,
    families: &[Family],
) -> Result<Vec<[u32; 2]>, EditError> {
    let of: BTreeMap<u32, usize> = families
        .iter()
        .enumerate()
        .map(|(k, f)| (f.cut.block, k))
        .collect();
    let mut counts = vec![[0; 2]; families.len()];
    let mut lists = Lists::default();
    let mut open = Vec::new();
    for (k, facet) in deform.facets.iter().enumerate() {
        let cut = facet.blocks.map(|b| of.get(&b).copied());
        if cut == [None; 2] {
            lists.keep(deform, k);
        } else {
            open.push(k);
        }
        for k in cut.into_iter().flatten() {
            counts[k][0] += 1;
        }
    }
    let maker = Maker {
        world,
        deform,
        work,
        families,
        of: &of,
    };
    for k in open {
        let made = maker.anew(&mut lists, k)?;
        for k in deform.facets[k].blocks.iter().filter_map(|b| of.get(b)) {
            counts[*k][1] += made;
        }
    }
    for (family, counts) in families.iter().zip(&mut counts) {
        counts[1] += maker.inside(&mut lists, family)?;
    }
    let surfaces = maker.surfaces(&lists);
    deform.facets = lists.facets;
    deform.worn = lists.worn;
    deform.points = lists.points;
    deform.memory = lists.memory;
    let gone: BTreeSet<u32> = families.iter().map(|f| f.slot).collect();
    deform.surfaces.retain(|s| !gone.contains(&s.body));
    deform.surfaces.extend(surfaces);
    Ok(counts)
}

impl Lists {
    fn keep(&mut self, deform: &Deform, k: usize) {
        let facet = &deform.facets[k];
        self.facets.push(Facet {
            first: self.points.len() as u32,
            ..*facet
        });
        self.worn.push(deform.worn[k]);
        self.points
            .extend_from_slice(&deform.points[facet.points()]);
        self.memory
            .extend_from_slice(&deform.memory[facet.points()]);
    }
}

struct Maker<'a> {
    world: &'a World,
    deform: &'a Deform,
    work: &'a Workspace,
    families: &'a [Family<'a>],
    of: &'a BTreeMap<u32, usize>,
}

impl Maker<'_> {
    /// The facets that take the place of facet `k`; their number.
    fn anew(&self, lists: &mut Lists, k: usize) -> Result<u32, EditError> {
        let old = &self.deform.facets[k];
        let n = old.frame[0];
        let shift = self.shift(old);
        let place = |point: &Point| place(self.world, self.deform, old, point, 0);
        let stretch = Stretch::new(self.world, self.deform, old, place);
        let sides = [0, 1].map(|side| self.pieces(old, side));
        let (mut made, mut area) = (0, 0.0);
        for a in &sides[0] {
            for b in &sides[1] {
                let mut beside = b.fan.clone();
                beside.at.iter_mut().for_each(|at| *at += shift);
                let smallest = SLIVER * a.fan.area().min(b.fan.area());
                let joints = face_overlay::overlay(&a.fan, &beside, n, smallest);
                if joints.is_empty() {
                    continue;
                }
                let facet = Facet {
                    blocks: [a.block, b.block],
                    ..*old
                };
                let (facet, points) = self.place(lists, facet, &joints, shift);
                let anchors = Anchors::new(self.world, self.deform);
                for (joint, point) in joints.iter().zip(&points) {
                    let jump = anchors.jump(&facet, point);
                    let at = facet.now.map(|e| e.dot(jump));
                    lists.memory.push(stretch.memory(&facet, joint.at, &at));
                }
                lists.cover([a, b], &points);
                lists.points.extend(points);
                area += facet.area;
                made += 1;
            }
        }
        if (area - old.area).abs() > AREA * old.area {
            let cut = old.blocks.iter().find(|b| self.of.contains_key(b));
            return Err(EditError::Audit {
                what: "the area of a facet",
                block: self.world.name(cut.map_or(0, |b| *b as usize)),
                before: old.area,
                after: area,
            });
        }
        Ok(made)
    }

    /// Appends a facet; its points are returned and must be appended with their memory.
    fn place(
        &self,
        lists: &mut Lists,
        facet: Facet,
        joints: &[JointPoint],
        shift: Vec3,
    ) -> (Facet, Vec<Point>) {
        let anchor = |joint: &JointPoint, side: usize| {
            if facet.rigid[side] {
                let back = if side == 0 { Vec3::ZERO } else { shift };
                let arm = joint.at - back - self.world.reference[facet.blocks[side] as usize];
                return Anchor {
                    nodes: [0; 3],
                    weights: arm.to_array(),
                };
            }
            Anchor {
                nodes: joint.sides[side].nodes,
                weights: joint.sides[side].weights,
            }
        };
        let points: Vec<Point> = joints
            .iter()
            .map(|j| Point {
                anchors: [anchor(j, 0), anchor(j, 1)],
                area: j.area,
            })
            .collect();
        let area: f64 = joints.iter().map(|j| j.area).sum();
        let first: Vec3 = joints.iter().map(|j| j.area * j.at).sum();
        let whole_until = match self.deform.relax {
            Some(_) => 0,
            None => self.world.step + LOOK,
        };
        let facet = Facet {
            whole_until,
            centre: first / area,
            area,
            first: lists.points.len() as u32,
            count: points.len() as u32,
            ..facet
        };
        lists.facets.push(facet);
        lists.worn.push(true);
        (facet, points)
    }

    /// What takes the place of one side of an old facet.
    fn pieces(&self, facet: &Facet, side: usize) -> Vec<Piece> {
        let block = facet.blocks[side];
        if facet.rigid[side] {
            let (solid, centre) = centred(&self.world.setup.blocks[block as usize].shape);
            let Ok(mesh) = Tetrahedra::new(&solid) else {
                return Vec::new();
            };
            let n = facet.frame[0];
            let (outward, at) = match side {
                0 => (n, facet.centre),
                _ => (-n, facet.centre - self.shift(facet)),
            };
            let face = face_with(&mesh, solid.faces.len(), outward, at - centre);
            let fan = moved(mesh.face_fan(face), centre, 0);
            return vec![Piece { block, face, fan }];
        }
        let Some(body) = self.deform.body(block as usize) else {
            return Vec::new();
        };
        let nodes: BTreeSet<u32> = self.deform.points[facet.points()]
            .iter()
            .map(|p| &p.anchors[side])
            .flat_map(|a| a.nodes.iter().zip(a.weights))
            .filter(|(_, w)| *w != 0.0)
            .map(|(n, _)| n - body.first)
            .collect();
        let face = self.face(body, &nodes);
        self.now(body, face)
    }

    /// Face of a body that has most of the nodes (numbers within the body).
    fn face(&self, body: &Body, nodes: &BTreeSet<u32>) -> usize {
        let kind = self.work.kind(body);
        let middle = (kind.mesh.nodes.len() - 1 - kind.faces.len()) as u32;
        let shared = |f: usize| {
            let own = kind.faces[f].iter().filter(|n| nodes.contains(n)).count();
            own + 2 * usize::from(nodes.contains(&(middle + f as u32)))
        };
        // The first of the best.
        (0..kind.faces.len())
            .rev()
            .max_by_key(|f| shared(*f))
            .unwrap_or(0)
    }

    /// A face of a body as it is now: itself, or what the parts of the body have of it.
    fn now(&self, body: &Body, face: usize) -> Vec<Piece> {
        let centre = self.deform.nodes.place[body.nodes().end - 1];
        let Some(&k) = self.of.get(&body.block) else {
            let fan = self.work.kind(body).mesh.face_fan(face);
            let fan = moved(fan, centre, body.first);
            let block = body.block;
            return vec![Piece { block, face, fan }];
        };
        self.made_by(&self.families[k], FaceOrigin::Parent(face as u32))
    }

    /// Faces of the parts of a family that come from `origin`.
    fn made_by(&self, family: &Family, origin: FaceOrigin) -> Vec<Piece> {
        let centre = self.world.reference[family.cut.block as usize];
        let mut found = Vec::new();
        for (part, block) in family.cut.parts.iter().zip(family.children()) {
            let Some(body) = self.deform.body(block as usize) else {
                continue;
            };
            let faces = part.origins.iter().enumerate();
            for (face, _) in faces.filter(|(_, o)| **o == origin) {
                let fan = moved(part.mesh.face_fan(face), centre, body.first);
                found.push(Piece { block, face, fan });
            }
        }
        found
    }

    /// By how much side B of a facet is an image, m.
    fn shift(&self, facet: &Facet) -> Vec3 {
        let Some(point) = self.deform.points[facet.points()].first() else {
            return Vec3::ZERO;
        };
        let at = |side| place(self.world, self.deform, facet, point, side);
        let shift = at(0) - at(1);
        if self.world.setup.periodic == [None; 3] {
            Vec3::ZERO
        } else {
            shift
        }
    }

    /// Facets between the parts of a block, under the traction of its stress; their number.
    fn inside(&self, lists: &mut Lists, family: &Family) -> Result<u32, EditError> {
        let parent = &self.deform.bodies[family.slot as usize];
        let m = self.world.setup.blocks[parent.block as usize].material;
        let materials = [usize::from(m); 2];
        let row = materials[0] * self.world.setup.materials.len() + materials[0];
        let row = self.world.setup.pair_table[row];
        let Some(Some(law)) = self.world.setup.deform.bonds.get(usize::from(row)) else {
            return Err(EditError::Build(BuildError::NoBond {
                interface: self.world.setup.interfaces[usize::from(row)].name.clone(),
                blocks: [family.first, family.first + 1].map(|b| self.world.name(b as usize)),
            }));
        };
        let springs = stiffness(&self.world.setup, law, materials, [false; 2], [0.0; 2])?;
        let centre = self.world.reference[parent.block as usize];
        let stress = Pressed::new(self.deform, self.work, parent);
        let turn = super::super::turn::rotation(self.deform, self.work, parent);
        let mut made = 0;
        for plane in 0..family.cut.parts.len() as u32 - 1 {
            let sides = self.made_by(family, FaceOrigin::Plane(plane));
            let [a, b] = &sides[..] else { continue };
            let n = a.fan.area_vector().normalize();
            let smallest = SLIVER * a.fan.area();
            let joints = face_overlay::overlay(&a.fan, &b.fan, n, smallest);
            if joints.is_empty() {
                continue;
            }
            let facet = Facet {
                blocks: [a.block, b.block],
                frame: frame(n),
                now: super::super::turn::turned(frame(n), &[turn]),
                centre: Vec3::ZERO,
                area: 0.0,
                first: 0,
                count: 0,
                stiffness: springs,
                row,
                rigid: [false; 2],
                whole_until: 0,
            };
            let (facet, points) = self.place(lists, facet, &joints, Vec3::ZERO);
            let anchors = Anchors::new(self.world, self.deform);
            for (joint, point) in joints.iter().zip(&points) {
                let t = stress.at(joint.at - centre) * n;
                let jump = anchors.jump(&facet, point);
                let [kn, ks] = springs;
                let start = std::array::from_fn(|k| {
                    let stiff = if k == 0 { kn } else { ks };
                    facet.now[k].dot(t) - stiff * facet.now[k].dot(jump)
                });
                lists.memory.push(Memory {
                    start,
                    ..Memory::default()
                });
            }
            lists.cover([a, b], &points);
            lists.points.extend(points);
            made += 1;
        }
        Ok(made)
    }

    /// Free parts of the faces of parts that have a condition.
    fn surfaces(&self, lists: &Lists) -> Vec<Surface> {
        let mut made = Vec::new();
        for surface in &self.deform.surfaces {
            let body = &self.deform.bodies[surface.body as usize];
            if !self.of.contains_key(&body.block) {
                continue;
            }
            let nodes = surface.nodes.iter().map(|n| n.0 - body.first).collect();
            let face = self.face(body, &nodes);
            for piece in self.now(body, face) {
                let slot = self.deform.slot[piece.block as usize];
                let first = self.deform.bodies[slot as usize].first;
                let k = self.of[&body.block];
                let part =
                    &self.families[k].cut.parts[(piece.block - self.families[k].first) as usize];
                let shares = part.mesh.tributary(piece.face);
                let whole: f64 = shares.iter().map(|s| s.1).sum();
                let levers = levers(&part.mesh, piece.face);
                let centre = self.world.reference[body.block as usize].z;
                let (mut nodes, mut heights) = (Vec::new(), Vec::new());
                for (node, area) in shares {
                    let key = (piece.block, piece.face, first + node);
                    let left = area - lists.covered.get(&key).copied().unwrap_or(0.0);
                    if left > SLIVER * whole {
                        nodes.push((first + node, left));
                        heights.push(centre + levers[&node].z);
                    }
                }
                if !nodes.is_empty() {
                    made.push(Surface {
                        body: slot,
                        nodes,
                        heights,
                        ..surface.clone()
                    });
                }
            }
        }
        made
    }
}

impl Lists {
    fn cover(&mut self, pieces: [&Piece; 2], points: &[Point]) {
        for (side, piece) in pieces.into_iter().enumerate() {
            for point in points {
                let anchor = &point.anchors[side];
                for (node, weight) in anchor.nodes.iter().zip(anchor.weights) {
                    let key = (piece.block, piece.face, *node);
                    *self.covered.entry(key).or_insert(0.0) += weight * point.area;
                }
            }
        }
    }
}

fn moved(mut fan: Fan, by: Vec3, first: u32) -> Fan {
    fan.at.iter_mut().for_each(|at| *at += by);
    fan.nodes.iter_mut().for_each(|n| *n += first);
    fan
}
