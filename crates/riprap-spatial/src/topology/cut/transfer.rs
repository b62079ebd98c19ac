//! Motion and stress of the parts of a block: `laws::transfer` on the tetrahedra of the parent.

use riprap_geom::Vec3;
use riprap_geom::polyhedron::Tetrahedra;
use riprap_geom::polyhedron::cut::Part;

use crate::laws::tetrahedron::{Elastic, Groups, StartStress, Symmetric};
use crate::laws::transfer;
use crate::laws::transfer::{LinearStress, Motion, PointLocation};
use crate::setup::Shape;
use crate::state::deform::{Body, Deform, Start};
use crate::state::event::Note;
use crate::state::workspace::{BlockClass, Workspace};

/// A block to be cut.
pub(super) struct Cut {
    pub(super) block: u32,
    pub(super) note: Note,
    /// Parts, about the centroid of the block.
    pub(super) parts: Vec<Part>,
    /// Their shapes in the frame of the model.
    pub(super) shapes: Vec<Shape>,
    /// Their classes.
    pub(super) classes: Vec<BlockClass>,
    /// What they take over.
    pub(super) handed: Handed,
}

/// What the parts of a block take over from it.
pub(super) struct Handed {
    /// Displacements of the nodes of all parts, part by part, m.
    pub(super) displacement: Vec<[f64; 3]>,
    /// Their velocities, m/s.
    pub(super) velocity: Vec<[f64; 3]>,
    /// Start stress of each part.
    pub(super) starts: Vec<Start>,
    /// Motion of the block about its centroid at the start.
    pub(super) before: Motion,
    /// Motion of all parts about the same point.
    pub(super) after: Motion,
}

/// Finds what the parts (about the centroid of the block at the start), with their classes, take over.
pub(super) fn hand_on(
    deform: &Deform,
    work: &Workspace,
    body: &Body,
    parts: &[Part],
    classes: &[BlockClass],
) -> Handed {
    let class = work.class(body);
    let (displacement, velocity) =
        (&deform.nodes.displacement[body.nodes()], &deform.nodes.velocity[body.nodes()]);
    let at = |mesh: &Tetrahedra, displacement: &[[f64; 3]]| -> Vec<Vec3> {
        let pairs = mesh.nodes.iter().zip(displacement);
        pairs.map(|(x, u)| *x + Vec3::from_array(*u)).collect()
    };
    let before = transfer::motion(class.masses(), &at(&class.mesh, displacement), velocity);
    let count = parts.iter().map(|p| p.mesh.nodes.len()).sum();
    let (mut u, mut v) = (Vec::with_capacity(count), Vec::with_capacity(count));
    let mut places = Vec::with_capacity(count);
    let mut masses = Vec::with_capacity(count);
    let location = PointLocation::new(&class.mesh);
    for (part, own) in parts.iter().zip(classes) {
        let first = u.len();
        for node in &part.mesh.nodes {
            let place = location.locate(*node);
            u.push(transfer::interpolate(&place, displacement));
            v.push(transfer::interpolate(&place, velocity));
        }
        places.extend(at(&part.mesh, &u[first..]));
        masses.extend_from_slice(own.masses());
    }
    if before.kinetic > 0.0 {
        transfer::conserve(&before, &masses, &places, &mut v);
    }
    let after = transfer::motion(&masses, &places, &v);
    let mut first = 0;
    let parent = Stressed::new(deform, work, body);
    let starts = parts.iter().zip(classes).map(|(part, own)| {
        let nodes = first..first + part.mesh.nodes.len();
        first = nodes.end;
        parent.of(part, own, &u[nodes])
    });
    Handed { starts: starts.collect(), displacement: u, velocity: v, before, after }
}

/// A block with its stress.
struct Stressed<'a> {
    body: &'a Body,
    field: LinearStress,
    /// Energy of the start stress that the block does not count as its own, J/m³.
    apart: f64,
}

impl<'a> Stressed<'a> {
    fn new(deform: &'a Deform, work: &'a Workspace, body: &'a Body) -> Self {
        let class = work.class(body);
        let slot = deform.slot[body.block as usize] as usize;
        let u = deform.displacement(body);
        let start = work.start_of(slot);
        let stresses = transfer::stresses(&class.groups, &class.law, body.strain, start, u);
        let own = deform.start.get(slot).map_or(0.0, |s| s.energy);
        let apart = match deform.start.get(slot).filter(|s| !s.stresses.is_empty()) {
            Some(start) => held(&class.groups, &class.law, &start.stresses) - own,
            None => -own,
        };
        Self {
            body,
            field: LinearStress::new(&class.mesh, &stresses),
            apart: apart / class.mesh.volume(),
        }
    }

    /// Start stress with which a part with displacements `u` has this stress.
    fn of(&self, part: &Part, class: &BlockClass, u: &[[f64; 3]]) -> Start {
        let (law, groups) = (&class.law, &class.groups);
        let wanted = self.field.means(&part.mesh);
        let start: StartStress =
            transfer::start_stresses(groups, law, self.body.strain, u, &wanted);
        let stresses: Vec<_> = (0..groups.tets()).map(|tet| start.one(tet)).collect();
        let energy = held(groups, law, &stresses) - self.apart * part.mesh.volume();
        Start { stresses, energy }
    }
}

/// Energy of start stresses without displacements, J.
fn held(groups: &Groups, law: &Elastic, stresses: &[Symmetric]) -> f64 {
    let one = |(tet, s)| groups.volume_of(tet) * transfer::stress_energy(law, s);
    stresses.iter().enumerate().map(one).sum()
}
