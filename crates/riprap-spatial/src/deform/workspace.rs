//! Lays out the workspace of deformable blocks.

use riprap_geom::Vec3;
use riprap_geom::polyhedron::Tetrahedra;

use crate::exec::Exec;
use crate::faces::deformable::centred;
use crate::laws::tetrahedron::{Elastic, Groups, StartStress, Stiffness, Strain, row_sums};
use crate::setup::{Setup, Shape};
use crate::state::deform::{Deform, Masses};
use crate::state::links::Links;
use crate::state::workspace::{BODIES, BlockClass, BondWorks, FACETS, KickSums, Workspace};

impl BlockClass {
    /// The class that blocks of a shape and a material have, with what the present phase needs; `shared` by several.
    pub(crate) fn new(
        setup: &Setup,
        deform: &Deform,
        (shape, material): (&Shape, u16),
        shared: bool,
    ) -> Self {
        let material = &setup.materials[usize::from(material)];
        let (solid, _) = centred(shape);
        // Both were looked at when the block was made.
        let (Ok(mesh), Some(young), Some(poisson)) =
            (Tetrahedra::new(&solid), material.young, material.poisson)
        else {
            unreachable!("a class of deformable block that cannot be built")
        };
        let law = Elastic::new(young, poisson);
        let scale = |shares: Vec<f64>| shares.iter().map(|v| material.density * v).collect();
        Self {
            faces: solid.faces,
            depths: Default::default(),
            groups: Groups::new(&mesh),
            stiffness: shared.then(|| Stiffness::new(&mesh, &law)),
            law,
            lumped: scale(mesh.lumped()),
            inertial: match deform.masses {
                Masses::Lumped => None,
                Masses::Inertia => Some(scale(mesh.inertial())),
            },
            row_sums: match deform.relax {
                Some(_) => row_sums(&mesh, &law),
                None => Vec::new(),
            },
            first_slope: 0,
            mesh,
        }
    }
}

impl Workspace {
    /// Lays out everything for the bodies and bonds there are.
    #[must_use]
    pub fn new(setup: &Setup, deform: &Deform) -> Self {
        Self::grown(setup, deform, Vec::new(), &Exec::serial())
    }

    /// As [`Workspace::new`] with the first classes as they were: classes are only ever added.
    #[must_use]
    pub fn grown(setup: &Setup, deform: &Deform, old: Vec<BlockClass>, exec: &Exec) -> Self {
        let nodes = deform.nodes.len();
        let mut work = Self {
            classes: classes(setup, deform, old, exec),
            slots: vec![[0.0; 3]; deform.points.len()],
            net: vec![[0.0; 3]; nodes],
            change: vec![[0.0; 3]; nodes],
            ..Self::default()
        };
        work.slopes = work.classes.iter().flat_map(|k| slopes(&k.mesh)).collect();
        work.links = Links::new(deform);
        for body in &deform.bodies {
            let own = work.classes[body.class as usize].masses();
            work.masses.extend_from_slice(own);
        }
        work.start(setup, deform);
        work.speeds = vec![0.0; deform.bodies.len()];
        work.dashpots = crate::push::surface::dashpots(setup, deform);
        if deform.relax.is_some() {
            work.fictitious = super::relax::masses(deform, &work.classes);
        }
        let pieces = deform.bodies.len().div_ceil(BODIES);
        work.partial = vec![KickSums::default(); pieces];
        let pieces = deform.facets.len().div_ceil(FACETS);
        work.bond_works = vec![BondWorks::default(); pieces];
        work
    }

    /// Lays out the start stresses.
    fn start(&mut self, setup: &Setup, deform: &Deform) {
        if deform.start.iter().all(|s| s.stresses.is_empty()) {
            return;
        }
        self.starts.resize(deform.bodies.len(), StartStress::default());
        self.start_forces.resize(deform.nodes.len(), [0.0; 3]);
        for (k, (body, start)) in deform.bodies.iter().zip(&deform.start).enumerate() {
            if !body.alive || start.stresses.is_empty() {
                continue;
            }
            self.starts[k] = StartStress::new(&start.stresses);
            if body.strain == Strain::Small {
                let groups = &self.classes[body.class as usize].groups;
                let law = Elastic { lambda: 0.0, mu: 0.0 };
                let still = vec![[0.0; 3]; body.count as usize];
                let on = &mut self.start_forces[body.nodes()];
                groups.add_forces(&law, Strain::Small, &self.starts[k], &still, on);
            }
            // The weights of dynamic phases are not those that balance the stress: a part of them sits on the centroid.
            let given = deform.given.is_none_or(|first| body.block < first);
            let Some(in_situ) = setup.in_situ.filter(|_| given) else {
                continue;
            };
            let spec = &setup.blocks[body.block as usize];
            let density = setup.materials[usize::from(spec.material)].density;
            let force = in_situ.upward() * Vec3::Z / density;
            let class = &self.classes[body.class as usize];
            let masses = class.masses().iter().zip(&class.lumped);
            for (f, (now, lumped)) in self.start_forces[body.nodes()].iter_mut().zip(masses) {
                *f = (Vec3::from_array(*f) + (now - lumped) * force).to_array();
            }
        }
    }
}

/// Sums over the triangles at each node of a third of the area vector, over the volume: by Gauss's theorem.
fn slopes(mesh: &Tetrahedra) -> Vec<Vec3> {
    let mut sums = vec![Vec3::ZERO; mesh.nodes.len()];
    let volume = mesh.volume();
    for face in 0..mesh.first.len() - 1 {
        for triangle in mesh.fan(face) {
            let [m, a, b] = triangle.map(|k| mesh.nodes[k as usize]);
            let share = (a - m).cross(b - m) / (6.0 * volume);
            for node in triangle {
                sums[node as usize] += share;
            }
        }
    }
    sums
}

/// Kinds of which one thread makes so many at a time.
const KINDS: usize = 64;

/// All classes, the first of them as they were.
fn classes(setup: &Setup, deform: &Deform, old: Vec<BlockClass>, exec: &Exec) -> Vec<BlockClass> {
    let mut shared = vec![0u32; deform.classes.len()];
    for body in &deform.bodies {
        shared[body.class as usize] += 1;
    }
    let mut classes = old;
    let new: Vec<(u32, u32)> = deform.classes.iter().copied().zip(shared).collect();
    let new = &new[classes.len()..];
    let made = exec.map(new, KINDS, |some| {
        let some = some.iter();
        some.map(|&(block, shared)| {
            let spec = &setup.blocks[block as usize];
            BlockClass::new(setup, deform, (&spec.shape, spec.material), shared > 1)
        })
        .collect::<Vec<_>>()
    });
    classes.extend(made.into_iter().flatten());
    let mut sum = 0;
    for class in &mut classes {
        class.first_slope = sum;
        sum += class.mesh.nodes.len();
    }
    Groups::pack(classes.iter_mut().map(|k| &mut k.groups));
    classes
}
