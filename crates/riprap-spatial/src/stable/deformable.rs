//! Stable step of the deformable blocks: the highest frequency, by power iteration over blocks and bonds; once blocks have been
//! cut, from above, block by block ([`alone`]).

pub mod alone;

use crate::deform::elements;
use crate::exec::Exec;
use crate::lanes::Width;
use crate::laws::tetrahedron::{StartStress, Strain};
use crate::state::anchor::Anchor;
use crate::state::anchor::Freedoms;
use crate::state::bodies::{Bodies, Turned};
use crate::state::deform::Deform;
use crate::state::workspace::Workspace;
use crate::state::world::World;
use riprap_geom::Vec3;

/// Sweeps of the power iteration.
const SWEEPS: usize = 150;
/// The estimate comes from below; what is added to it.
const MARGIN: f64 = 1.005;

/// Square of the highest angular frequency (1/s²) of nodes on their tetrahedra and bonds, rigid blocks held, and
/// the block that moves most in that mode. Bonds count as they were built. After cuts a bound, of the block with the highest.
#[must_use]
pub fn highest(
    world: &World,
    deform: &Deform,
    work: &Workspace,
    exec: &Exec,
) -> (f64, Option<u32>) {
    let n = deform.nodes.len();
    if n == 0 {
        return (0.0, None);
    }
    if deform.given.is_some_and(|given| deform.slot.len() > given as usize) {
        let found;
        let all = if work.alone.len() == deform.bodies.len() {
            &work.alone
        } else {
            found = alone::each(deform, work, Vec::new(), exec).0;
            &found
        };
        let worst = (0..all.len()).rev().max_by(|a, b| all[*a].total_cmp(&all[*b]));
        return worst.map_or((0.0, None), |k| (all[k], Some(deform.bodies[k].block)));
    }
    let roots = roots(deform, work);
    let mut seed = 0x9e37_79b9_7f4a_7c15_u64;
    let mut draw = || {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        (seed >> 11) as f64 / (1u64 << 53) as f64 - 0.5
    };
    let mut x: Vec<[f64; 3]> = (0..n).map(|_| [draw(), draw(), draw()]).collect();
    let mut y = vec![[0.0; 3]; n];
    let mut square = 0.0;
    let at_rest = Bodies::at_rest(world.alive.len());
    let straight = vec![None; world.alive.len()];
    for _ in 0..SWEEPS {
        let held = (&at_rest, straight.as_slice());
        times(deform, work, held, &roots, &x, &mut y);
        let size = dot(&y, &y).sqrt();
        if size == 0.0 {
            return (0.0, None);
        }
        square = dot(&x, &y) / dot(&x, &x);
        for (x, y) in x.as_flattened_mut().iter_mut().zip(y.as_flattened()) {
            *x = y / size;
        }
    }
    let size = |v: &[f64; 3]| v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
    let mut most = 0;
    for (k, v) in x.iter().enumerate() {
        if size(v) > size(&x[most]) {
            most = k;
        }
    }
    let body = deform.bodies.partition_point(|b| b.first + b.count <= most as u32);
    (MARGIN * square, deform.bodies.get(body).map(|b| b.block))
}

/// Bound of the squared frequency (1/s²) of rigid blocks on the bonds that join them to deformable ones: the largest
/// sum of `k A (1/m + r²/I)` of a block.
#[must_use]
pub fn on_bonds(world: &World, deform: &Deform) -> f64 {
    let mut sums = vec![0.0; world.alive.len()];
    for facet in &deform.facets {
        let stiff = facet.stiffness[0].max(facet.stiffness[1]);
        for side in (0..2).filter(|s| facet.rigid[*s]) {
            let b = facet.blocks[side] as usize;
            if world.motion[b].is_some() {
                continue;
            }
            let solid = world.solid_of(b);
            let inverse = solid.inverse;
            let turn = (0..3).map(|k| inverse.col(k).abs().element_sum()).fold(0.0, f64::max);
            for point in &deform.points[facet.points()] {
                let Anchor::Block { arm, .. } = point.anchors[side] else {
                    continue;
                };
                let ease = 1.0 / solid.mass + arm.length_squared() * turn;
                sums[b] += point.area * stiff * ease;
            }
        }
    }
    sums.into_iter().fold(0.0, f64::max)
}

fn dot(x: &[[f64; 3]], y: &[[f64; 3]]) -> f64 {
    let (x, y) = (x.as_flattened(), y.as_flattened());
    x.iter().zip(y).map(|(a, b)| a * b).sum()
}

/// `1/sqrt(m)` of each node; 0 for what cannot move.
fn roots(deform: &Deform, work: &Workspace) -> Vec<f64> {
    let mut roots = vec![0.0; deform.nodes.len()];
    for body in deform.living() {
        let masses = work.class(body).masses();
        for (root, m) in roots[body.nodes()].iter_mut().zip(masses) {
            *root = 1.0 / m.sqrt();
        }
    }
    roots
}

/// `y = M^(-1/2) K M^(-1/2) x`.
fn times(
    deform: &Deform,
    work: &Workspace,
    (bodies, turned): (&Bodies, &[Option<Box<Turned>>]),
    roots: &[f64],
    x: &[[f64; 3]],
    y: &mut [[f64; 3]],
) {
    let mut nodes = crate::state::deform::Nodes { displacement: x.to_vec(), ..Default::default() };
    for (u, root) in nodes.displacement.iter_mut().zip(roots) {
        *u = u.map(|c| c * root);
    }
    y.fill([0.0; 3]);
    Width::detect().run(
        #[inline(always)]
        || {
            for body in deform.living() {
                let here = body.nodes();
                let f = &mut y[here.clone()];
                let (class, none) = (work.class(body), StartStress::none());
                elements::add_forces(class, Strain::Small, &none, &nodes.displacement[here], f);
            }
        },
    );
    let freedoms = Freedoms::new(bodies, turned, Some(&nodes));
    for facet in &deform.facets {
        let n = facet.frame[0];
        let [kn, ks] = facet.stiffness;
        for point in &deform.points[facet.points()] {
            let d = freedoms.jump(&point.anchors);
            let f: Vec3 = point.area * (ks * d + ((kn - ks) * d.dot(n)) * n);
            for (side, sign) in [(0, 1.0), (1, -1.0)] {
                if facet.rigid[side] {
                    continue;
                }
                let anchor = &point.anchors[side];
                for (node, weight) in anchor.nodes() {
                    let to = &mut y[node as usize];
                    *to = (Vec3::from_array(*to) + sign * weight * f).to_array();
                }
            }
        }
    }
    for hold in &deform.holds {
        let at = hold.node as usize;
        y[at] = (hold.free * Vec3::from_array(y[at])).to_array();
    }
    for (f, root) in y.iter_mut().zip(roots) {
        *f = f.map(|c| -c * root);
    }
}
