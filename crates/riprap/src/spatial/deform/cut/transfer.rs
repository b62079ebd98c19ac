//! Motion and stress of the parts of a block: `laws::transfer` on the tetrahedra of the parent.

use riprap_geom::Vec3;
use riprap_geom::polyhedron::Tetrahedra;
use riprap_geom::polyhedron::cut::Part;

use crate::laws::tetrahedron::{Groups, StartStress};
use crate::laws::transfer::{self, Cells, Motion, Sides};
use crate::spatial::deform::store::{Body, Deform, Masses, Start};
use crate::spatial::deform::workspace::Workspace;
use crate::spatial::world::World;

/// What the parts of a block take over from it.
pub(super) struct Handed {
    /// Displacements of the nodes of all parts, part by part, m.
    pub(super) moved: Vec<[f64; 3]>,
    /// Their velocities, m/s.
    pub(super) rates: Vec<[f64; 3]>,
    /// Start stress of each part.
    pub(super) starts: Vec<Start>,
    /// Motion of the block about its centroid at the start.
    pub(super) before: Motion,
    /// Motion of all parts about the same point.
    pub(super) after: Motion,
}

/// Finds what the parts (about the centroid of the block at the start) take over.
pub(super) fn hand_on(
    world: &World,
    deform: &Deform,
    work: &Workspace,
    body: &Body,
    parts: &[Part],
) -> Handed {
    let kind = work.kind(body);
    let (moved, rates) = (
        &deform.nodes.moved[body.nodes()],
        &deform.nodes.rate[body.nodes()],
    );
    let at = |mesh: &Tetrahedra, moved: &[[f64; 3]]| -> Vec<Vec3> {
        let pairs = mesh.nodes.iter().zip(moved);
        pairs.map(|(x, u)| *x + Vec3::from_array(*u)).collect()
    };
    let before = transfer::motion(kind.masses(deform.masses), &at(&kind.mesh, moved), rates);
    let material = world.setup.blocks[body.block as usize].material;
    let density = world.setup.materials[usize::from(material)].density;
    let (mut u, mut v) = (Vec::new(), Vec::new());
    let (mut places, mut masses) = (Vec::new(), Vec::new());
    let mut starts = Vec::with_capacity(parts.len());
    let parent = Stressed::new(deform, work, body);
    for part in parts {
        let first = u.len();
        let sides = parent.cells.sides(&part.mesh);
        for node in 0..part.mesh.nodes.len() {
            let place = transfer::locate_node(&kind.mesh, &part.mesh, &sides, node);
            u.push(transfer::interpolate(&place, moved));
            v.push(transfer::interpolate(&place, rates));
        }
        places.extend(at(&part.mesh, &u[first..]));
        masses.extend(shares(&part.mesh, deform.masses).map(|share| density * share));
        starts.push(parent.of(part, &sides, &u[first..]));
    }
    if before.kinetic > 0.0 {
        transfer::conserve(&before, &masses, &places, &mut v);
    }
    let after = transfer::motion(&masses, &places, &v);
    Handed {
        moved: u,
        rates: v,
        starts,
        before,
        after,
    }
}

/// Volumes that the nodes of a mesh stand for, m³.
fn shares(mesh: &Tetrahedra, rule: Masses) -> impl Iterator<Item = f64> {
    let shares = match rule {
        Masses::Lumped => mesh.lumped(),
        Masses::Inertia => mesh.inertial(),
    };
    shares.into_iter()
}

/// A block with the stresses of its tetrahedra.
struct Stressed<'a> {
    kind: &'a crate::spatial::deform::workspace::Kind,
    body: &'a Body,
    cells: Cells,
    stresses: Vec<crate::laws::tetrahedron::Symmetric>,
    /// Energy of the start stress that the block does not count as its own, J/m³.
    apart: f64,
}

impl<'a> Stressed<'a> {
    fn new(deform: &'a Deform, work: &'a Workspace, body: &'a Body) -> Self {
        let kind = work.kind(body);
        let slot = deform.slot[body.block as usize] as usize;
        let u = deform.moved(body);
        let start = work.start_of(slot);
        let stresses = transfer::stresses(&kind.groups, &kind.law, body.strain, start, u);
        let own = deform.start.get(slot).map_or(0.0, |s| s.energy);
        let apart = match deform.start.get(slot).filter(|s| !s.stresses.is_empty()) {
            Some(start) => held(&kind.groups, &kind.law, &start.stresses) - own,
            None => -own,
        };
        Self {
            kind,
            body,
            cells: Cells::new(&kind.mesh),
            stresses,
            apart: apart / kind.mesh.volume(),
        }
    }

    /// Start stress with which a part with displacements `u` has the mean of these stresses.
    fn of(&self, part: &Part, sides: &Sides, u: &[[f64; 3]]) -> Start {
        let (law, strain) = (&self.kind.law, self.body.strain);
        let groups = Groups::new(&part.mesh);
        let shares = self.cells.shares(sides);
        let wanted = transfer::mean_stresses(&shares, &self.stresses);
        let start: StartStress = transfer::start_stresses(&groups, law, strain, u, &wanted);
        let stresses: Vec<_> = (0..groups.tets()).map(|tet| start.one(tet)).collect();
        let energy = held(&groups, law, &stresses) - self.apart * part.mesh.volume();
        Start { stresses, energy }
    }
}

/// Energy of start stresses without displacements, J.
fn held(
    groups: &Groups,
    law: &crate::laws::tetrahedron::Elastic,
    stresses: &[crate::laws::tetrahedron::Symmetric],
) -> f64 {
    let one = |(tet, s)| groups.volume_of(tet) * transfer::stress_energy(law, s);
    stresses.iter().enumerate().map(one).sum()
}
