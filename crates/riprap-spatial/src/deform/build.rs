//! From plain data to deformable blocks: nodes, classes, facets between faces, held nodes, loaded faces.

use std::collections::BTreeMap;

use riprap_geom::Vec3;
use riprap_geom::polyhedron::Tetrahedra;

use crate::accounts;
use crate::accounts::Holder;
use crate::dynamics::{Formula, TimeFunction};
use crate::faces::deformable::{PARALLEL, centred, face_of};
use crate::faces::overlap::Overlap;
use crate::setup::deform::{BondLaw, BondSprings, NodeHold};
use crate::setup::error::BuildError;
use crate::setup::{BoundaryKind, Material, Motion, Setup};
use crate::state::anchor::Anchor;
use crate::state::deform::{Acts, Body, Deform, Facet, Memory, Point, RIGID, State, Surface};
use crate::state::face::Face;
use crate::state::hold::Hold;
use crate::state::workspace::{BlockClass, Workspace};
use crate::state::world::World;

/// Share of a face's area below which a node of it counts as covered.
const COVERED: f64 = 1e-9;

/// The deformable blocks of a world with their nodes, without bonds; `None` if all are rigid.
///
/// # Errors
/// A material without moduli, a block that cannot be divided.
pub fn bodies(world: &World) -> Result<Option<Deform>, BuildError> {
    let setup = &world.setup;
    if setup.deform.sets.iter().all(|s| s.blocks.is_empty()) {
        return Ok(None);
    }
    let mut deform =
        Deform { slot: vec![RIGID; setup.blocks.len()], breaking: true, ..Deform::default() };
    let mut known: BTreeMap<[u64; 4], u32> = BTreeMap::new();
    let mut set_of = vec![usize::MAX; setup.blocks.len()];
    for (k, set) in setup.deform.sets.iter().enumerate() {
        for &b in &set.blocks {
            set_of[b as usize] = k;
        }
    }
    for (b, spec) in setup.blocks.iter().enumerate() {
        let Some(set) = setup.deform.sets.get(set_of[b]) else {
            continue;
        };
        let material = &setup.materials[usize::from(spec.material)];
        needs(material, "its deformable blocks")?;
        let (solid, centre) = centred(&spec.shape);
        let mesh = Tetrahedra::new(&solid).map_err(|error| BuildError::Shape {
            block: world.name(b),
            reason: error.to_string(),
        })?;
        let key = spec.shape.key(u64::from(spec.material));
        let class = key.and_then(|k| known.get(&k).copied()).unwrap_or_else(|| {
            deform.classes.push(b as u32);
            deform.classes.len() as u32 - 1
        });
        if let Some(key) = key {
            known.insert(key, class);
        }
        deform.slot[b] = deform.bodies.len() as u32;
        deform.bodies.push(Body {
            block: b as u32,
            class,
            first: deform.nodes.len() as u32,
            count: mesh.nodes.len() as u32,
            strain: set.strain,
            alive: world.alive[b],
        });
        for node in &mesh.nodes {
            let place = *node + centre;
            let global = place + setup.origin;
            let u = field(&set.displacement, global);
            let v = spec.velocity + spec.spin.cross(*node) + field(&set.velocity, global);
            deform.nodes.place.push(place);
            deform.nodes.displacement.push(u.to_array());
            deform.nodes.velocity.push(v.to_array());
        }
        if let Some(in_situ) = &setup.in_situ {
            deform.start.push(super::in_situ::start(in_situ, &mesh, centre));
        }
    }
    Ok(Some(deform))
}

/// Young's modulus and Poisson's ratio of a material.
fn needs(material: &Material, need: &'static str) -> Result<[f64; 2], BuildError> {
    let moduli = material.young.zip(material.poisson);
    moduli
        .map(|(young, poisson)| [young, poisson])
        .ok_or_else(|| BuildError::NoModulus { material: material.name.clone(), need })
}

/// Value of a vector field at a place (m, global); a component without formula is zero.
fn field(formulas: &[Option<Formula>; 3], at: Vec3) -> Vec3 {
    let value = |f: &Option<Formula>| {
        f.as_ref().map_or(0.0, |f| f.value(&[("x", at.x), ("y", at.y), ("z", at.z)]))
    };
    Vec3::from_array(formulas.each_ref().map(value))
}

/// Joins blocks along the overlaps of their faces, at least one of the two deformable: facets with their points, in
/// the order of the overlaps.
///
/// # Errors
/// No bond law for the two materials, or one that lacks moduli.
pub fn join(
    world: &World,
    deform: &mut Deform,
    classes: &[BlockClass],
    overlaps: &[Overlap],
) -> Result<(), BuildError> {
    for overlap in overlaps {
        let blocks = overlap.blocks.map(|b| b as usize);
        let specs = blocks.map(|b| &world.setup.blocks[b]);
        let materials = specs.map(|s| usize::from(s.material));
        let centre = world.reference[blocks[0]] + overlap.arms[0];
        let row = world.setup.row_at(materials, centre, overlap.frame[0]);
        let law = bond(world, row, overlap.blocks)?;
        let rigid = blocks.map(|b| deform.body(b).is_none());
        let n = overlap.frame[0];
        let depths = [overlap.arms[0].dot(n), -overlap.arms[1].dot(n)];
        let stiffness = stiffness(&world.setup, law, materials, rigid, depths)?;
        let first = deform.points.len() as u32;
        let points = super::overlay::points(world, deform, classes, overlap);
        let starts = super::in_situ::tractions(world, deform, classes, overlap, &points);
        let memory = |start| Memory { start, ..Memory::default() };
        deform.has_history.push(world.setup.in_situ.is_some());
        deform.memory.extend(starts.into_iter().map(memory));
        deform.facets.push(Facet {
            centre: world.reference[blocks[0]] + overlap.arms[0],
            area: points.iter().map(|p| p.area).sum(),
            first,
            count: points.len() as u32,
            ..Facet::new(overlap.blocks, overlap.frame, (row, stiffness), rigid)
        });
        deform.points.extend(points);
    }
    Ok(())
}

/// Bond law of a row of the table of interfaces, for two blocks.
pub(crate) fn bond(world: &World, row: u16, blocks: [u32; 2]) -> Result<&BondLaw, BuildError> {
    let law = &world.setup.interfaces[usize::from(row)];
    law.bond.as_ref().ok_or_else(|| BuildError::NoBond {
        interface: law.name.clone(),
        blocks: blocks.map(|b| world.name(b as usize)),
    })
}

/// Where a point of a facet was at the start on one side, m (local).
#[must_use]
pub fn place(world: &World, deform: &Deform, point: &Point, side: usize) -> Vec3 {
    match point.anchors[side] {
        Anchor::Block { block, arm } => world.reference[block as usize] + arm,
        anchor @ Anchor::Nodes { .. } => {
            let nodes = anchor.nodes();
            nodes.map(|(n, w)| w * deform.nodes.place[n as usize]).sum()
        }
    }
}

/// Breaks the bonds of notches.
///
/// # Errors
/// A notch off every face.
fn notch(world: &World, deform: &mut Deform) -> Result<(), BuildError> {
    let slack = Vec3::splat(1e-6 * world.finest());
    for notch in &world.setup.deform.notches {
        let [min, max] = notch.corners;
        let inside = |at: Vec3| at.cmpge(min - slack).all() && at.cmple(max + slack).all();
        let mut found = false;
        for (k, facet) in deform.facets.iter().enumerate() {
            let whole = !notch.springs && inside(facet.centre);
            for p in facet.points() {
                let own = || inside(place(world, deform, &deform.points[p], 0));
                if whole || (notch.springs && own()) {
                    found = true;
                    deform.has_history[k] = true;
                    deform.memory[p].law.damage = 1.0;
                    deform.memory[p].state = State::Opened;
                }
            }
        }
        if !found {
            let at = (min + world.setup.origin).to_array();
            return Err(BuildError::NoFacet { at });
        }
    }
    Ok(())
}

/// Normal and shear stiffness (Pa/m) of a facet: the bond, and the half blocks of rigid sides, in series.
///
/// A rigid block of a lattice has its own compliance, `h/M` and `h/2G` with h from centroid to face, which a deformable one
/// brings along: without it a P wave would be reflected.
pub(crate) fn stiffness(
    setup: &Setup,
    law: &BondLaw,
    materials: [usize; 2],
    rigid: [bool; 2],
    depths: [f64; 2],
) -> Result<[f64; 2], BuildError> {
    let mut compliance = match law.springs {
        BondSprings::Given(given) if rigid == [false; 2] => return Ok(given),
        BondSprings::Given(given) => given.map(|k| 1.0 / k),
        BondSprings::Thickness { thickness, moduli: Some([e, g]) } => {
            [thickness / e, thickness / g]
        }
        BondSprings::Thickness { moduli: None, .. } => [0.0; 2],
    };
    for side in 0..2 {
        let material = &setup.materials[materials[side]];
        let [young, poisson] = needs(material, "the stiffness of its bonds")?;
        let g = young / (2.0 * (1.0 + poisson));
        if let BondSprings::Thickness { thickness, moduli: None } = law.springs {
            compliance[0] += 0.5 * thickness / young;
            compliance[1] += 0.5 * thickness / g;
        }
        if rigid[side] {
            let m = material.constrained_modulus().unwrap_or(young);
            compliance[0] += depths[side] / m;
            compliance[1] += depths[side] / (2.0 * g);
        }
    }
    Ok(compliance.map(|c| 1.0 / c))
}

/// Gives faces of deformable blocks their conditions, and nodes their supports. Faces that no condition concerns are
/// left out.
///
/// # Errors
/// A box without nodes.
pub fn conditions(
    world: &World,
    deform: &mut Deform,
    classes: &[BlockClass],
    faces: &[Face],
    walls: &[NodalWall],
) -> Result<(), BuildError> {
    let covered = covered(deform);
    for wall in walls {
        let Some(&body) = deform.body(wall.block as usize) else {
            continue;
        };
        let face = face_of(&classes[body.class as usize], wall.normal, wall.arm);
        let surface = free(deform, classes, &covered, body, face, wall.normal);
        // Several removed blocks may share one face.
        let same = |s: &Surface| s.body == surface.body && s.normal.dot(wall.normal) > PARALLEL;
        if deform.surfaces.iter().any(same) {
            continue;
        }
        let acts = Acts::Cavity(wall.source);
        deform.surfaces.push(Surface { acts, ..surface });
    }
    for face in faces {
        let (Some(boundary), Some(&body)) = (face.boundary, deform.body(face.block as usize))
        else {
            continue;
        };
        let normal = face.frame[0];
        let number = face_of(&classes[body.class as usize], normal, face.arm);
        let surface = free(deform, classes, &covered, body, number, normal);
        let acts = Acts::Boundary(boundary);
        let surface = Surface { acts, ..surface };
        // Several free parts of one face make one surface.
        if let Some(last) = deform.surfaces.last_mut()
            && last.body == surface.body
            && last.normal.dot(normal) > PARALLEL
        {
            *last = surface;
            continue;
        }
        deform.surfaces.push(surface);
    }
    for hold in &world.setup.deform.holds {
        if inside(world, deform, hold).is_empty() {
            let at = (hold.min + world.setup.origin).to_array();
            return Err(BuildError::NoNode { at });
        }
    }
    deform.holds = holds(world, deform);
    hold_now(deform, world.time, world.setup.origin);
    Ok(())
}

/// The part of a face of a body that no facet covers.
fn free(
    deform: &Deform,
    classes: &[BlockClass],
    covered: &BTreeMap<(u32, [i64; 3]), f64>,
    body: Body,
    face: usize,
    normal: Vec3,
) -> Surface {
    let mesh = &classes[body.class as usize].mesh;
    let centre = deform.nodes.place[body.nodes().end - 1].z;
    let (nodes, heights) = uncovered(mesh, face, (body.first, centre), |node| {
        covered.get(&(node, axis_key(normal))).copied()
    });
    let body = deform.slot[body.block as usize];
    Surface { body, acts: Acts::Boundary(0), normal, nodes, heights }
}

/// Nodes of a face, from the `first` of their body on, with the area that is not `covered` (m²), and their heights, with that of the centroid
/// `centre` (m, local).
pub(crate) fn uncovered(
    mesh: &Tetrahedra,
    face: usize,
    (first, centre): (u32, f64),
    covered: impl Fn(u32) -> Option<f64>,
) -> (Vec<(u32, f64)>, Vec<f64>) {
    let shares = mesh.tributary(face);
    let whole: f64 = shares.iter().map(|s| s.1).sum();
    let levers = super::in_situ::levers(mesh, face);
    let parts = shares.into_iter().filter_map(|(node, area)| {
        let left = area - covered(first + node).unwrap_or(0.0);
        (left > COVERED * whole).then(|| ((first + node, left), centre + levers[&node].z))
    });
    parts.unzip()
}

/// Prescribed motion of nodes: of those on faces with a condition, of supported blocks, of nodes in boxes.
fn holds(world: &World, deform: &Deform) -> Vec<Hold> {
    let mut holds = Holds::new();
    for surface in &deform.surfaces {
        let Some(boundary) = surface.boundary() else {
            continue;
        };
        let kind = &world.setup.boundaries[boundary].kind;
        let account = account(world, Holder::Boundary(boundary as u16));
        for &(node, _) in &surface.nodes {
            on_surface(hold_of(&mut holds, node), kind, surface.normal, account);
        }
    }
    supports(world, deform, &mut holds);
    for (number, hold) in (0..).zip(&world.setup.deform.holds) {
        let account = account(world, Holder::Nodes(number));
        for node in inside(world, deform, hold) {
            drive(hold_of(&mut holds, node), &hold.velocity, account);
        }
    }
    holds.into_values().filter(|h| !h.is_free()).collect()
}

/// Account on which the work of a condition is booked.
fn account(world: &World, holder: Holder) -> Option<u16> {
    accounts::of(&world.setup.accounts, holder)
}

type Holds = BTreeMap<u32, Hold>;

fn hold_of(holds: &mut Holds, node: u32) -> &mut Hold {
    holds.entry(node).or_insert_with(|| Hold::new(node))
}

/// Finds the prescribed motion of nodes anew, after supports have changed.
pub fn hold_anew(world: &World, deform: &mut Deform) {
    deform.holds = holds(world, deform);
}

/// A rounded normal, to tell the faces of a node apart.
fn axis_key(n: Vec3) -> [i64; 3] {
    n.to_array().map(|c| (c * 1e6).round() as i64)
}

/// Area that facets cover, by node and outward normal.
fn covered(deform: &Deform) -> BTreeMap<(u32, [i64; 3]), f64> {
    let mut sums = BTreeMap::new();
    for facet in &deform.facets {
        for side in (0..2).filter(|s| !facet.rigid[*s]) {
            let normal = if side == 0 { facet.frame[0] } else { -facet.frame[0] };
            for point in &deform.points[facet.points()] {
                let anchor = &point.anchors[side];
                for (node, weight) in anchor.nodes() {
                    if weight != 0.0 {
                        *sums.entry((node, axis_key(normal))).or_insert(0.0) += weight * point.area;
                    }
                }
            }
        }
    }
    sums
}

/// Prescribes what a condition on a face says.
fn on_surface(hold: &mut Hold, kind: &BoundaryKind, normal: Vec3, account: Option<u16>) {
    let mut add = |direction: Vec3, velocity| hold.add(direction, velocity, account);
    match kind {
        BoundaryKind::Held { normal: true, shear: true } => {
            Vec3::AXES.into_iter().for_each(|axis| add(axis, None));
        }
        BoundaryKind::Held { normal: across, shear } => {
            if *across {
                add(normal, None);
            }
            if *shear {
                let (b, c) = normal.any_orthonormal_pair();
                add(b, None);
                add(c, None);
            }
        }
        BoundaryKind::Moved { velocity } => {
            for (axis, f) in Vec3::AXES.into_iter().zip(velocity) {
                if let Some(f) = f {
                    add(axis, Some(f.clone()));
                }
            }
        }
        BoundaryKind::Viscous { .. } | BoundaryKind::Traction { .. } => {}
    }
}

/// Supports of blocks, for all their nodes.
fn supports(world: &World, deform: &Deform, holds: &mut Holds) {
    for body in deform.living() {
        let Some(motion) = world.motion[body.block as usize].as_deref() else {
            continue;
        };
        let still = |held: bool| held.then_some(TimeFunction::Constant(0.0));
        let velocity = match motion {
            Motion::Fixed { translation, .. } => translation.map(still),
            Motion::Velocity { translation, .. } => translation.clone(),
            // Refused when the model is made.
            Motion::Acceleration { .. } => continue,
        };
        // The last support of a block alone acts on it.
        let supports = &world.setup.supports;
        let number = supports.iter().rposition(|s| s.blocks.binary_search(&body.block).is_ok());
        let account = number.and_then(|k| account(world, Holder::Support(k as u16)));
        for node in body.nodes() {
            drive(hold_of(holds, node as u32), &velocity, account);
        }
    }
}

fn drive(hold: &mut Hold, velocity: &[Option<TimeFunction>; 3], account: Option<u16>) {
    for (axis, f) in Vec3::AXES.into_iter().zip(velocity) {
        if let Some(f) = f {
            hold.add(axis, Some(f.clone()), account);
        }
    }
}

/// Nodes of the living blocks that a support means in its box, its surface included.
fn inside(world: &World, deform: &Deform, hold: &NodeHold) -> Vec<u32> {
    let slack = Vec3::splat(1e-6 * world.finest());
    let (min, max) = (hold.min - slack, hold.max + slack);
    let there = |node: &usize| {
        let place = deform.nodes.place[*node];
        place.cmpge(min).all() && place.cmple(max).all()
    };
    let meant = |body: &&Body| {
        (hold.blocks.as_ref()).is_none_or(|blocks| blocks.binary_search(&body.block).is_ok())
    };
    let nodes = deform.living().filter(meant).flat_map(Body::nodes);
    nodes.filter(there).map(|node| node as u32).collect()
}

/// Gives held nodes their prescribed velocities at time `t` (s); `origin` is where the local one lies, m.
pub fn hold_now(deform: &mut Deform, t: f64, origin: Vec3) {
    let dynamic = deform.relax.is_none();
    for hold in &deform.holds {
        let v = Vec3::from_array(deform.nodes.velocity[hold.node as usize]);
        let target = if dynamic {
            hold.velocity(t, deform.nodes.place[hold.node as usize] + origin)
        } else {
            Vec3::ZERO
        };
        deform.nodes.velocity[hold.node as usize] = (hold.free * v + target).to_array();
    }
}

/// A face of a deformable block at a cavity.
#[derive(Clone, Copy, Debug)]
pub struct NodalWall {
    /// Index into `Setup::sources`.
    pub source: u16,
    /// The block.
    pub block: u32,
    /// Unit outward normal.
    pub normal: Vec3,
    /// Centre of the face from the centroid of the block, m.
    pub arm: Vec3,
}

/// Bonds and conditions of a new world; gives back the faces of rigid blocks.
///
/// # Errors
/// As [`join`] and [`conditions`].
pub fn finish(
    world: &mut World,
    overlaps: &[Overlap],
    faces: Vec<Face>,
    walls: &[NodalWall],
) -> Result<Vec<Face>, BuildError> {
    let made = super::beside(world, |world, deform| {
        let work = Workspace::new(&world.setup, deform);
        join(world, deform, &work.classes, overlaps)?;
        notch(world, deform)?;
        conditions(world, deform, &work.classes, &faces, walls)
    });
    made.transpose()?;
    let Some(deform) = &world.deform else {
        return Ok(faces);
    };
    let rigid = |f: &Face| deform.body(f.block as usize).is_none();
    Ok(faces.into_iter().filter(rigid).collect())
}
