//! What can be read from deformable blocks.

use riprap_geom::{Mat3, Vec3};

use crate::deform::bonds;
use crate::laws::bond;
use crate::laws::tetrahedron::Gradient;
use crate::query::view::View;
use crate::state::anchor::Anchor;
use crate::state::deform::{Body, Deform, Facet};
use crate::state::workspace::{BlockClass, Workspace};

/// A deformable block with all that is known of it.
#[derive(Clone, Copy)]
pub struct DeformableView<'a> {
    /// All deformable blocks.
    pub deform: &'a Deform,
    /// Their scratch data.
    pub work: &'a Workspace,
    /// The block.
    pub body: &'a Body,
    /// Its shape and elements.
    pub kind: &'a BlockClass,
    /// Share of the coming kick that lies before the present time.
    past: f64,
}

impl<'a> DeformableView<'a> {
    /// Sum over its nodes of mass (kg) times a function of the node's number.
    fn sum(&self, get: impl Fn(usize) -> Vec3) -> Vec3 {
        let masses = self.kind.masses();
        self.body.nodes().zip(masses).map(|(node, m)| *m * get(node)).sum()
    }

    fn mass(&self) -> f64 {
        self.kind.masses().iter().sum()
    }

    /// Displacement of a node, m.
    #[must_use]
    pub fn node_displacement(&self, node: usize) -> Vec3 {
        Vec3::from_array(self.deform.nodes.displacement[node])
    }

    /// Velocity of a node at the present time, m/s; zero while relaxing, where rates mean nothing.
    #[must_use]
    pub fn node_velocity(&self, node: usize) -> Vec3 {
        if self.deform.relax.is_some() {
            return Vec3::ZERO;
        }
        let change = self.past * Vec3::from_array(self.work.change[node]);
        Vec3::from_array(self.deform.nodes.velocity[node]) + change
    }

    /// Displacement of its centre of mass, m.
    #[must_use]
    pub fn displacement(&self) -> Vec3 {
        self.sum(|n| self.node_displacement(n)) / self.mass()
    }

    /// Velocity of its centre of mass, m/s.
    #[must_use]
    pub fn velocity(&self) -> Vec3 {
        self.sum(|n| self.node_velocity(n)) / self.mass()
    }

    /// Mean stress (Pa, tension-positive).
    #[must_use]
    pub fn stress(&self) -> Mat3 {
        self.deform.average(self.work, self.body).0
    }

    /// Mean displacement gradient.
    #[must_use]
    pub fn gradient(&self) -> Gradient {
        self.deform.average(self.work, self.body).1
    }

    /// Rotation vector of the mean displacement gradient (its axial vector: exact for small rotations), rad.
    #[must_use]
    pub fn rotation(&self) -> Vec3 {
        axial(&self.gradient())
    }

    /// Spin with the true angular momentum, rad/s.
    #[must_use]
    pub fn spin(&self, inverse: &Mat3) -> Vec3 {
        let centre = self.centre();
        let v = self.velocity();
        let momentum = self.sum(|n| (self.place(n) - centre).cross(self.node_velocity(n) - v));
        *inverse * momentum
    }

    /// Present place of a node, m (local).
    #[must_use]
    pub fn place(&self, node: usize) -> Vec3 {
        self.deform.nodes.place[node] + self.node_displacement(node)
    }

    fn centre(&self) -> Vec3 {
        self.sum(|n| self.place(n)) / self.mass()
    }

    /// Angular momentum about the local origin, N m s.
    #[must_use]
    pub fn angular_momentum(&self, present: bool) -> Vec3 {
        self.sum(|n| {
            let place = if present { self.place(n) } else { self.deform.nodes.place[n] };
            place.cross(self.node_velocity(n))
        })
    }

    /// Time-centred kinetic energy, J; while relaxing that of the fictitious masses. A given velocity stays until the present time
    /// ([`crate::dynamics::kick::Support`]).
    #[must_use]
    pub fn kinetic(&self) -> f64 {
        // The velocity now is `v + past dv`: of the two about it the later one is as far from it as v.
        let whole = 2.0 * self.past;
        self.weighted(|v, dv| v.dot(v + whole * dv))
    }

    /// Sum of `m dv²` of the coming kick, J.
    #[must_use]
    pub fn half_kick(&self) -> f64 {
        2.0 * self.weighted(|_, dv| dv.length_squared())
    }

    /// Half the sum of the masses that move now times a function of velocity and change, this without what is given.
    fn weighted(&self, get: impl Fn(Vec3, Vec3) -> f64) -> f64 {
        let masses = self.kind.masses();
        let fictitious = &self.work.fictitious;
        let nodes = self.body.nodes().zip(masses);
        let holds = &self.deform.holds;
        let first = holds.partition_point(|hold| (hold.node as usize) < self.body.first as usize);
        let mut holds = holds[first..].iter().peekable();
        let terms = nodes.map(|(n, m)| {
            let m = fictitious.get(n).unwrap_or(m);
            let v = Vec3::from_array(self.deform.nodes.velocity[n]);
            let mut change = Vec3::from_array(self.work.change[n]);
            if let Some(hold) = holds.next_if(|hold| hold.node as usize == n) {
                change = hold.free * change;
            }
            m * get(v, change)
        });
        0.5 * terms.sum::<f64>()
    }

    /// Node of the block that lay nearest to a point (m, local) at the start.
    #[must_use]
    pub fn nearest(&self, at: Vec3) -> usize {
        let places = &self.deform.nodes.place;
        let mut best = self.body.first as usize;
        for node in self.body.nodes() {
            if places[node].distance_squared(at) < places[best].distance_squared(at) {
                best = node;
            }
        }
        best
    }
}

/// Axial vector of the skew part of a displacement gradient, rad.
#[must_use]
pub(crate) fn axial(h: &Gradient) -> Vec3 {
    0.5 * Vec3::new(h[2][1] - h[1][2], h[0][2] - h[2][0], h[1][0] - h[0][1])
}

/// What is read at a node.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Motion {
    /// m.
    Displacement,
    /// m/s.
    Velocity,
}

impl<'a> View<'a> {
    /// Number by which [`View::at_node`] knows the place `at` (m, local) of block `b`: its nearest node; of a rigid block
    /// the centroid is read.
    #[must_use]
    pub fn spot(&self, b: u32, at: Vec3) -> u32 {
        self.deformable(b as usize).map_or(u32::MAX, |deformable| deformable.nearest(at) as u32)
    }

    /// Motion of a node: block and the number of [`View::spot`].
    #[must_use]
    pub fn at_node(&self, of: &[u32], what: Motion) -> Vec3 {
        let &[b, node] = of else {
            return Vec3::NAN;
        };
        match (self.deformable(b as usize), what) {
            (Some(deformable), Motion::Displacement) => deformable.node_displacement(node as usize),
            (Some(deformable), Motion::Velocity) => deformable.node_velocity(node as usize),
            (None, Motion::Displacement) => self.displacement(b as usize),
            (None, Motion::Velocity) => self.velocity(b as usize),
        }
    }

    /// Mean displacement (m) and force (N) of the faces of deformable blocks that boundary number `k` acts on.
    #[must_use]
    pub fn on_boundary(&self, k: usize) -> (Vec3, Vec3) {
        let Some((deform, work)) = self.deformables() else {
            return (Vec3::NAN, Vec3::NAN);
        };
        let (mut displacement, mut area, mut force) = (Vec3::ZERO, 0.0, Vec3::ZERO);
        let mut seen = std::collections::BTreeSet::new();
        for surface in deform.surfaces.iter().filter(|s| s.boundary() == Some(k)) {
            for &(node, share) in &surface.nodes {
                displacement += share * Vec3::from_array(deform.nodes.displacement[node as usize]);
                area += share;
                if let Ok(hold) = deform.holds.binary_search_by_key(&node, |h| h.node)
                    // A node at the rim of a face is in several surfaces, but is held once.
                    && seen.insert(node)
                {
                    let net = Vec3::from_array(work.net[node as usize]);
                    // What holds a node takes the net force along the directions that are not free.
                    force -= net - deform.holds[hold].free * net;
                }
            }
            force += crate::push::surface::total(self.world, deform, surface);
        }
        (displacement / area, force)
    }

    /// Block `b` if it is deformable.
    #[must_use]
    pub fn deformable(&self, b: usize) -> Option<DeformableView<'a>> {
        let (deform, work) = self.deformables()?;
        let body = deform.body(b)?;
        Some(DeformableView { deform, work, body, kind: work.class(body), past: self.past() })
    }

    /// The deformable blocks, if there are any.
    #[must_use]
    pub fn deformables(&self) -> Option<(&'a Deform, &'a Workspace)> {
        self.world.deform.as_deref().zip(self.scratch.deform.as_deref())
    }

    /// Force of the bonds of block b on block a, one of them deformable, N.
    #[must_use]
    pub fn facet_force(&self, (a, b): (u32, u32)) -> Vec3 {
        let mut sum = Vec3::ZERO;
        if let Some((deform, work)) = self.deformables() {
            for facet in &deform.facets {
                let sign = match facet.blocks {
                    blocks if blocks == [a, b] => 1.0,
                    blocks if blocks == [b, a] => -1.0,
                    _ => continue,
                };
                for p in facet.points() {
                    sum += sign * Vec3::from_array(work.slots[p]);
                }
            }
        }
        sum
    }

    /// Number of broken points of a facet.
    #[must_use]
    pub fn broken_points(&self, facet: &Facet) -> u32 {
        self.world.deform.as_ref().map_or(0, |deform| deform.failed_points(facet) as u32)
    }

    /// Forces of bonds on rigid blocks: block, present arm from its centroid (m), force (N).
    pub fn bond_forces(&self) -> impl Iterator<Item = (usize, Vec3, Vec3)> + 'a {
        let (world, deformables) = (self.world, self.deformables());
        deformables.into_iter().flat_map(move |(deform, work)| {
            let freedoms = world.freedoms_with(deform);
            let sides = deform.facets.iter().flat_map(|f| [(f, 0), (f, 1)]);
            let rigid = sides.filter(|(f, side)| f.rigid[*side]);
            rigid.flat_map(move |(facet, side)| {
                let b = facet.blocks[side] as usize;
                let sign = if side == 0 { 1.0 } else { -1.0 };
                facet.points().filter_map(move |p| {
                    let Anchor::Block { block, arm } = deform.points[p].anchors[side] else {
                        return None;
                    };
                    let force = sign * Vec3::from_array(work.slots[p]);
                    Some((b, freedoms.arm(block, arm), force))
                })
            })
        })
    }

    /// Elastic energy of the deformable blocks, J.
    #[must_use]
    pub fn strain_energy(&self) -> f64 {
        let Some((deform, work)) = self.deformables() else {
            return 0.0;
        };
        let bodies: Vec<&Body> = deform.living().collect();
        let one = |k: usize| deform.strain_energy(work, bodies[k]);
        self.scratch.exec.sum(bodies.len(), one)
    }

    /// Elastic energy of the normal and of the shear springs of bonds, J.
    #[must_use]
    pub fn bond_energy(&self) -> [f64; 2] {
        let Some((deform, _)) = self.deformables() else {
            return [0.0; 2];
        };
        let freedoms = self.world.freedoms_with(deform);
        let interfaces = &self.world.setup.interfaces;
        let one = |k: usize| {
            let (facet, has_history) = (&deform.facets[k], deform.has_history[k]);
            let law = interfaces[usize::from(facet.row)].bond.as_ref();
            let linear = !has_history && law.is_none_or(|l| l.cohesive.is_none());
            let points = &deform.points[facet.points()];
            let mut sum = [0.0; 2];
            if facet.parted {
                return sum;
            }
            for (point, memory) in points.iter().zip(&deform.memory[facet.points()]) {
                let jump = freedoms.jump(&point.anchors);
                let at = facet.now.map(|e| e.dot(jump));
                let state = match law {
                    Some(law) if !linear => {
                        bonds::respond(law, facet.stiffness, memory, &at, false).1
                    }
                    Some(_) | None => memory.law,
                };
                let all = bond::stored(facet.stiffness, &memory.start, &at, &state);
                // Both springs are in one sum: without shear it is the normal part.
                let across = [at[0], 0.0, 0.0];
                let still = bond::State { slip: [0.0; 2], ..state };
                let start = [memory.start[0], 0.0, 0.0];
                let normal = bond::stored(facet.stiffness, &start, &across, &still);
                sum[0] += point.area * normal;
                sum[1] += point.area * (all - normal + memory.unbooked);
            }
            sum
        };
        self.scratch.exec.sums(deform.facets.len(), one)
    }

    /// Ratio of the net forces on free nodes to the external forces or the reactions.
    #[must_use]
    pub fn deformable_unbalanced(&self) -> Option<f64> {
        let (_, work) = self.deformables()?;
        let [net, reactions, external] = work.norms;
        Some(if net == 0.0 { 0.0 } else { net / reactions.max(external) })
    }
}
