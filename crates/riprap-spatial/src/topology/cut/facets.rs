//! Bonds of cut blocks: with neighbours and between parts, by overlay, with the stretch they had.

use std::collections::BTreeMap;

use riprap_geom::Vec3;
use riprap_geom::face_overlay::{self, Fan, JointPoint};
use riprap_geom::polyhedron::cut::FaceOrigin;
use riprap_geom::polyhedron::frame;

use crate::deform::build::{bond, place, stiffness, uncovered};
use crate::deform::overlay::{self, moved};
use crate::deform::turn::{rotation, turned};
use crate::exec::Exec;
use crate::state::anchor::Anchor;
use crate::state::deform::{Body, Deform, Facet, Memory, Point, Surface};
use crate::state::interface::Origin;
use crate::state::workspace::Workspace;
use crate::state::world::World;
use crate::topology::audit::unchanged;
use crate::topology::cut::pressed::Pressed;
use crate::topology::cut::stretch::Stretch;
use crate::topology::error::EditError;
use crate::topology::family::Family;
use crate::topology::fracture::CHECK_INTERVAL;

/// Share of a face below which faces share nothing.
const SLIVER: f64 = 1e-9;
/// Share by which the shared area may change: crooked faces.
const AREA: f64 = 1e-3;

/// A face of a block now, with its nodes in the lists of the model (numbers of its own for rigid blocks).
struct Piece {
    block: u32,
    /// Number of the face of a deformable one.
    face: usize,
    fan: Fan,
}

/// New facets and what belongs to them.
#[derive(Default)]
struct Lists {
    facets: Vec<Facet>,
    points: Vec<Point>,
    memory: Vec<Memory>,
    /// Area of new facets by block, face and node, m², where a face may have a condition.
    covered: Vec<(Spot, f64)>,
}

/// Block, face and node.
type Spot = (u32, usize, u32);

/// Not cut.
const WHOLE: u32 = u32::MAX;
/// Facets, and blocks, that one thread works on at a time.
const RUN: usize = 32;

/// Makes the facets and surfaces of all families anew, at the end of the lists; others stay as they are, in their order.
/// Returns the number of facets of each family before and after, and how many were made.
pub(super) fn rebuild(
    world: &World,
    deform: &mut Deform,
    work: &Workspace,
    families: &[Family],
    exec: &Exec,
) -> Result<(Vec<[u32; 2]>, usize), EditError> {
    let mut of = vec![WHOLE; world.alive.len()];
    for (k, family) in (0..).zip(families) {
        of[family.parent as usize] = k;
        of[family.first as usize..family.children().end as usize].fill(k);
    }
    let mut conditioned = vec![false; families.len()];
    for surface in &deform.surfaces {
        let block = deform.bodies[surface.body as usize].block;
        if let Some(set) = conditioned.get_mut(of[block as usize] as usize) {
            *set = true;
        }
    }
    let is_open = |facet: &Facet| facet.blocks.iter().any(|b| of[*b as usize] != WHOLE);
    let facets = deform.facets.iter().enumerate();
    let open: Vec<usize> = facets.filter(|(_, f)| is_open(f)).map(|(k, _)| k).collect();
    let mut counts = vec![[0; 2]; families.len()];
    let mut count = |when: usize, blocks: &[u32]| {
        for b in blocks {
            if let Some(counts) = counts.get_mut(of[*b as usize] as usize) {
                counts[when] += 1;
            }
        }
    };
    open.iter().for_each(|k| count(0, &deform.facets[*k].blocks));
    let maker = Maker { world, deform, work, families, of: &of, conditioned: &conditioned };
    let mut lists = Lists::default();
    // Runs come back in their order, so that the lists are the same on any number of threads.
    for some in exec.map(&open, RUN, |some| made_of(some, |lists, k| maker.anew(lists, *k))) {
        lists.append(some?);
    }
    lists.facets.iter().for_each(|facet| count(1, &facet.blocks));
    let between = lists.facets.len();
    for some in exec.map(families, RUN, |some| made_of(some, |lists, f| maker.inside(lists, f))) {
        lists.append(some?);
    }
    lists.facets[between..].iter().for_each(|facet| count(1, &facet.blocks[..1]));
    let surfaces = maker.surfaces(&lists);
    let bodies = &deform.bodies;
    let stays = |s: &Surface| of[bodies[s.body as usize].block as usize] == WHOLE;
    deform.surfaces.retain(stays);
    deform.surfaces.extend(surfaces);
    deform.drop_facets(is_open);
    let made = lists.facets.len();
    lists.hand_over(deform);
    Ok((counts, made))
}

/// The facets that `make` makes of some items.
fn made_of<T>(
    some: &[T],
    make: impl Fn(&mut Lists, &T) -> Result<(), EditError>,
) -> Result<Lists, EditError> {
    let mut lists = Lists::default();
    some.iter().try_for_each(|item| make(&mut lists, item))?;
    Ok(lists)
}

impl Lists {
    fn append(&mut self, new: Self) {
        let first = self.points.len() as u32;
        self.facets.extend(new.facets.into_iter().map(|f| Facet { first: first + f.first, ..f }));
        self.points.extend(new.points);
        self.memory.extend(new.memory);
        self.covered.extend(new.covered);
    }

    /// Appends everything to the lists of the model. New facets are joined under load.
    fn hand_over(self, deform: &mut Deform) {
        let first = deform.points.len() as u32;
        deform
            .facets
            .extend(self.facets.into_iter().map(|f| Facet { first: first + f.first, ..f }));
        deform.has_history.resize(deform.facets.len(), true);
        deform.points.extend(self.points);
        deform.memory.extend(self.memory);
    }

    fn cover(&mut self, side: usize, piece: &Piece, points: &[Point]) {
        for point in points {
            let anchor = &point.anchors[side];
            for (node, weight) in anchor.nodes() {
                let spot = (piece.block, piece.face, node);
                self.covered.push((spot, weight * point.area));
            }
        }
    }
}

struct Maker<'a> {
    world: &'a World,
    deform: &'a Deform,
    work: &'a Workspace,
    families: &'a [Family<'a>],
    /// Family of each block; [`WHOLE`] for those that are not cut.
    of: &'a [u32],
    /// Families with faces that have a condition.
    conditioned: &'a [bool],
}

impl Maker<'_> {
    /// Number of the family of a block.
    fn family(&self, block: u32) -> Option<usize> {
        let k = self.of[block as usize];
        (k != WHOLE).then_some(k as usize)
    }

    /// The facets that take the place of facet `k`.
    fn anew(&self, lists: &mut Lists, k: usize) -> Result<(), EditError> {
        let old = &self.deform.facets[k];
        let n = old.frame[0];
        let shift = self.shift(old);
        let place = |point: &Point| place(self.world, self.deform, point, 0);
        let stretch = Stretch::new(self.world, self.deform, old, place);
        let mut sides = [0, 1].map(|side| self.pieces(old, side));
        // An overlay needs both sides in one place.
        if shift != Vec3::ZERO {
            for piece in &mut sides[1] {
                piece.fan.at.iter_mut().for_each(|at| *at += shift);
            }
        }
        let areas = |pieces: &[Piece]| pieces.iter().map(|p| p.fan.area()).collect::<Vec<f64>>();
        let areas = sides.each_ref().map(|pieces| areas(pieces));
        let cut = old.blocks.map(|b| self.family(b));
        let conditioned = cut.map(|k| k.is_some_and(|k| self.conditioned[k]));
        let mut area = 0.0;
        for (a, area_a) in sides[0].iter().zip(&areas[0]) {
            for (b, area_b) in sides[1].iter().zip(&areas[1]) {
                let smallest = SLIVER * area_a.min(*area_b);
                let joints = face_overlay::overlay(&a.fan, &b.fan, n, smallest);
                if joints.is_empty() {
                    continue;
                }
                let facet = Facet { blocks: [a.block, b.block], ..*old };
                let (facet, points) = self.place(lists, facet, &joints, shift);
                let freedoms = self.world.freedoms_with(self.deform);
                for (joint, point) in joints.iter().zip(&points) {
                    let jump = freedoms.jump(&point.anchors);
                    let at = facet.now.map(|e| e.dot(jump));
                    lists.memory.push(stretch.memory(&facet, joint.at, &at));
                }
                for (side, piece) in [a, b].into_iter().enumerate() {
                    if conditioned[side] {
                        lists.cover(side, piece, &points);
                    }
                }
                lists.points.extend(points);
                area += facet.area;
            }
        }
        let cut = old.blocks.into_iter().find(|b| self.family(*b).is_some()).unwrap_or(0);
        unchanged(self.world, cut, "the area of a facet", [old.area, area], AREA * old.area)
    }

    /// Appends a facet; its points are returned and must be appended with their memory.
    fn place(
        &self,
        lists: &mut Lists,
        facet: Facet,
        joints: &[JointPoint],
        shift: Vec3,
    ) -> (Facet, Vec<Point>) {
        let points = overlay::hang(self.world, (facet.blocks, facet.rigid), shift, joints);
        let area: f64 = joints.iter().map(|j| j.area).sum();
        let first: Vec3 = joints.iter().map(|j| j.area * j.at).sum();
        let intact_until_step = match self.deform.relax {
            Some(_) => 0,
            None => self.world.step + CHECK_INTERVAL,
        };
        let facet = Facet {
            intact_until_step,
            centre: first / area,
            area,
            first: lists.points.len() as u32,
            count: points.len() as u32,
            ..facet
        };
        lists.facets.push(facet);
        (facet, points)
    }

    /// What takes the place of one side of an old facet.
    fn pieces(&self, facet: &Facet, side: usize) -> Vec<Piece> {
        let block = facet.blocks[side];
        if facet.rigid[side] {
            let n = facet.frame[0];
            let (outward, at) = match side {
                0 => (n, facet.centre),
                _ => (-n, facet.centre - self.shift(facet)),
            };
            let arm = at - self.world.reference[block as usize];
            let fan = overlay::rigid_fan(self.world, block as usize, outward, arm);
            return fan.map(|fan| Piece { block, face: 0, fan }).into_iter().collect();
        }
        let Some(body) = self.deform.body(block as usize) else {
            return Vec::new();
        };
        let mut nodes: Vec<u32> = self.deform.points[facet.points()]
            .iter()
            .map(|p| &p.anchors[side])
            .flat_map(Anchor::nodes)
            .filter(|(_, w)| *w != 0.0)
            .map(|(n, _)| n - body.first)
            .collect();
        nodes.sort_unstable();
        nodes.dedup();
        let face = self.face(body, &nodes);
        self.now(body, face)
    }

    /// Face of a body that has most of the nodes (numbers within the body, sorted).
    fn face(&self, body: &Body, nodes: &[u32]) -> usize {
        let has = |node: &u32| nodes.binary_search(node).is_ok();
        let kind = self.work.class(body);
        let middle = (kind.mesh.nodes.len() - 1 - kind.faces.len()) as u32;
        let shared = |f: usize| {
            let own = kind.faces[f].iter().filter(|n| has(n)).count();
            // Corners are of several faces, the centre is of this one alone.
            own + 2 * usize::from(has(&(middle + f as u32)))
        };
        // The first of the best.
        (0..kind.faces.len()).rev().max_by_key(|f| shared(*f)).unwrap_or(0)
    }

    /// A face of a body as it is now: itself, or what the parts of the body have of it.
    fn now(&self, body: &Body, face: usize) -> Vec<Piece> {
        let centre = self.deform.nodes.place[body.nodes().end - 1];
        let Some(k) = self.family(body.block) else {
            let fan = self.work.class(body).mesh.face_fan(face);
            let fan = moved(fan, centre, body.first);
            return vec![Piece { block: body.block, face, fan }];
        };
        self.made_by(&self.families[k], FaceOrigin::Parent(face as u32))
    }

    /// Faces of the parts of a family that come from `origin`.
    fn made_by(&self, family: &Family, origin: FaceOrigin) -> Vec<Piece> {
        let centre = self.world.reference[family.parent as usize];
        let mut found = Vec::new();
        for (part, block) in family.parts.iter().zip(family.children()) {
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
        let at = |side| place(self.world, self.deform, point, side);
        let shift = at(0) - at(1);
        if self.world.setup.periodic == [None; 3] { Vec3::ZERO } else { shift }
    }

    /// Facets between the parts of a block, under the traction of its stress.
    fn inside(&self, lists: &mut Lists, family: &Family) -> Result<(), EditError> {
        let setup = &self.world.setup;
        let Some(parent) = self.deform.body(family.parent as usize) else {
            return Ok(());
        };
        let materials = [usize::from(setup.blocks[parent.block as usize].material); 2];
        let row = setup.row_of(materials);
        let law = bond(self.world, row, [family.first, family.first + 1])?;
        let springs = stiffness(setup, law, materials, [false; 2], [0.0; 2])?;
        let centre = self.world.reference[parent.block as usize];
        let stress = Pressed::new(self.deform, self.work, parent);
        let turn = rotation(self.deform, self.work, parent);
        for plane in 0..family.parts.len() as u32 - 1 {
            let sides = self.made_by(family, FaceOrigin::Plane(plane));
            // Planes are parallel: each has one part on either side.
            let [a, b] = &sides[..] else { continue };
            let n = a.fan.area_vector().normalize();
            let smallest = SLIVER * a.fan.area();
            let joints = face_overlay::overlay(&a.fan, &b.fan, n, smallest);
            if joints.is_empty() {
                continue;
            }
            let facet = Facet {
                now: turned(frame(n), &[turn]),
                origin: Origin::Cut,
                ..Facet::new([a.block, b.block], frame(n), (row, springs), [false; 2])
            };
            let (facet, points) = self.place(lists, facet, &joints, Vec3::ZERO);
            let freedoms = self.world.freedoms_with(self.deform);
            for (joint, point) in joints.iter().zip(&points) {
                let t = stress.at(joint.at - centre) * n;
                let jump = freedoms.jump(&point.anchors);
                let [kn, ks] = springs;
                // The springs are stretched by the jump that is there already: less
                // their pull, so that the whole is the stress.
                let start = std::array::from_fn(|k| {
                    let stiff = if k == 0 { kn } else { ks };
                    facet.now[k].dot(t) - stiff * facet.now[k].dot(jump)
                });
                lists.memory.push(Memory { start, ..Memory::default() });
            }
            lists.points.extend(points);
        }
        Ok(())
    }

    /// Free parts of the faces of parts that have a condition.
    fn surfaces(&self, lists: &Lists) -> Vec<Surface> {
        let mut covered: BTreeMap<Spot, f64> = BTreeMap::new();
        for (spot, area) in &lists.covered {
            *covered.entry(*spot).or_insert(0.0) += area;
        }
        let mut made = Vec::new();
        for surface in &self.deform.surfaces {
            let body = &self.deform.bodies[surface.body as usize];
            let Some(k) = self.family(body.block) else {
                continue;
            };
            let mut nodes: Vec<u32> = surface.nodes.iter().map(|n| n.0 - body.first).collect();
            nodes.sort_unstable();
            let face = self.face(body, &nodes);
            for piece in self.now(body, face) {
                let slot = self.deform.slot[piece.block as usize];
                let first = self.deform.bodies[slot as usize].first;
                let family = &self.families[k];
                let mesh = &family.parts[(piece.block - family.first) as usize].mesh;
                let centre = self.world.reference[body.block as usize].z;
                let (nodes, heights) = uncovered(mesh, piece.face, (first, centre), |node| {
                    covered.get(&(piece.block, piece.face, node)).copied()
                });
                if !nodes.is_empty() {
                    let (acts, normal) = (surface.acts, surface.normal);
                    made.push(Surface { body: slot, acts, normal, nodes, heights });
                }
            }
        }
        made
    }
}
