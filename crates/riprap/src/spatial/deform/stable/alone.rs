//! Highest frequencies block by block: what stays known of all blocks that a cut does not touch.
//!
//! The highest frequency of a sum of stiffnesses on a sum of masses is at most the highest one of its parts. A part is
//! a block with its tetrahedra, on bonds to fixed places: `(a - b) k (a - b) <= (1 + ma/mb) a k a + (1 + mb/ma) b k b` with
//! the masses `1/ma = sum w²/m` that a point moves on either side, so that two equal blocks, and two masses on one
//! spring, get no more than they have.
//!
//! Source: Irons & Treharne (1971), the bound by parts; the shares of the bonds are derived here.

use riprap_geom::Vec3;

use super::MARGIN;
use crate::exec::Exec;
use crate::laws::tetrahedron::{StartStress, Strain};
use crate::spatial::deform::elements;
use crate::spatial::deform::store::{Anchor, Body, Deform, RIGID};
use crate::spatial::deform::workspace::{Kind, Workspace};
use crate::spatial::lanes::Width;

/// Steps of Lanczos's method: the value is then known to better than the margin.
const STEPS: usize = 24;
/// Blocks that one thread works on at a time.
const RUN: usize = 16;

/// Squares of the highest angular frequencies (1/s²) of all bodies, each alone, 0 for those that are gone. Numbers in `known`
/// are taken over where they are not NaN. Also returns how many were found anew.
#[must_use]
pub fn each(
    deform: &Deform,
    work: &Workspace,
    mut known: Vec<f64>,
    exec: &Exec,
) -> (Vec<f64>, usize) {
    const KNOWN: u32 = u32::MAX;
    known.resize(deform.bodies.len(), f64::NAN);
    let (mut number, mut todo) = (vec![KNOWN; known.len()], Vec::new());
    for (slot, body) in deform.bodies.iter().enumerate() {
        if !body.alive {
            known[slot] = 0.0;
        } else if known[slot].is_nan() {
            number[slot] = todo.len() as u32;
            todo.push(slot as u32);
        }
    }
    // Facets of the bodies to be done, with the side.
    let mut bonds: Vec<Vec<(u32, u8)>> = vec![Vec::new(); todo.len()];
    for (k, facet) in deform.facets.iter().enumerate() {
        for (side, block) in facet.blocks.into_iter().enumerate() {
            let slot = deform.slot.get(block as usize).copied().unwrap_or(RIGID);
            if let Some(&to) = number.get(slot as usize).filter(|n| **n != KNOWN) {
                bonds[to as usize].push((k as u32, side as u8));
            }
        }
    }
    let jobs: Vec<(u32, Vec<(u32, u8)>)> = todo.into_iter().zip(bonds).collect();
    let found = exec.map(&jobs, RUN, |some| {
        let one = |(slot, bonds): &(u32, Vec<(u32, u8)>)| {
            let body = &deform.bodies[*slot as usize];
            Alone::new(deform, work, body, bonds).highest()
        };
        some.iter().map(one).collect::<Vec<f64>>()
    });
    for ((slot, _), square) in jobs.iter().zip(found.into_iter().flatten()) {
        known[*slot as usize] = square;
    }
    (known, jobs.len())
}

/// A point of a bond.
struct Spring {
    /// Nodes of the block and their weights.
    anchor: Anchor,
    normal: Vec3,
    /// Normal and shear stiffness, N/m.
    stiff: [f64; 2],
}

/// A block on its bonds.
struct Alone<'a> {
    kind: &'a Kind,
    /// `1/sqrt(m)` of each node.
    roots: Vec<f64>,
    springs: Vec<Spring>,
}

impl<'a> Alone<'a> {
    fn new(deform: &Deform, work: &'a Workspace, body: &Body, bonds: &[(u32, u8)]) -> Self {
        let kind = work.kind(body);
        let roots = kind.masses(deform.masses).iter().map(|m| 1.0 / m.sqrt());
        let mut springs = Vec::new();
        for &(k, side) in bonds {
            let facet = &deform.facets[k as usize];
            let (here, there) = (usize::from(side), 1 - usize::from(side));
            for point in &deform.points[facet.points()] {
                let own = ease(deform, work, facet.blocks[here], &point.anchors[here]);
                // Rigid blocks count as fixed here.
                let other = if facet.rigid[there] {
                    0.0
                } else {
                    ease(deform, work, facet.blocks[there], &point.anchors[there])
                };
                let share = point.area * (1.0 + other / own);
                let mut anchor = point.anchors[here];
                for node in &mut anchor.nodes {
                    *node = node.saturating_sub(body.first);
                }
                springs.push(Spring {
                    anchor,
                    normal: facet.frame[0],
                    stiff: facet.stiffness.map(|k| share * k),
                });
            }
        }
        Self {
            kind,
            roots: roots.collect(),
            springs,
        }
    }

    /// Square of the highest frequency, 1/s².
    fn highest(&self) -> f64 {
        let width = Width::detect();
        let mut u = vec![[0.0; 3]; self.roots.len()];
        MARGIN
            * largest(3 * self.roots.len(), |x, y| {
                self.times(width, &mut u, x, y);
            })
    }

    /// `y = M^(-1/2) K M^(-1/2) x`.
    fn times(&self, width: Width, u: &mut [[f64; 3]], x: &[f64], y: &mut [f64]) {
        for ((u, x), root) in u.iter_mut().zip(x.as_chunks::<3>().0).zip(&self.roots) {
            *u = x.map(|c| c * root);
        }
        y.fill(0.0);
        let (f, none) = (y.as_chunks_mut::<3>().0, StartStress::none());
        width.run(
            #[inline(always)]
            || elements::add_forces(self.kind, Strain::Small, &none, u, f),
        );
        for spring in &self.springs {
            let pairs = || spring.anchor.nodes.iter().zip(spring.anchor.weights);
            let d: Vec3 = pairs()
                .map(|(n, w)| w * Vec3::from_array(u[*n as usize]))
                .sum();
            let ([kn, ks], n) = (spring.stiff, spring.normal);
            let t = ks * d + ((kn - ks) * d.dot(n)) * n;
            for (node, weight) in pairs() {
                for (f, t) in f[*node as usize].iter_mut().zip(t.to_array()) {
                    *f -= weight * t;
                }
            }
        }
        for (f, root) in f.iter_mut().zip(&self.roots) {
            *f = f.map(|c| -c * root);
        }
    }
}

/// Inverse of the mass that a point of a deformable block moves, 1/kg.
fn ease(deform: &Deform, work: &Workspace, block: u32, anchor: &Anchor) -> f64 {
    let Some(body) = deform.body(block as usize) else {
        return 0.0;
    };
    let masses = work.kind(body).masses(deform.masses);
    let pairs = anchor.nodes.iter().zip(anchor.weights);
    pairs
        .filter(|(_, w)| *w != 0.0)
        .map(|(n, w)| w * w / masses[(n - body.first) as usize])
        .sum()
}

/// Largest eigenvalue of a symmetric operator on `size` numbers without negative ones, by Lanczos's method. That
/// round-off makes its vectors less orthogonal does no harm to the largest value.
fn largest(size: usize, mut times: impl FnMut(&[f64], &mut [f64])) -> f64 {
    // A start that has a part of every mode: no symmetry, no zeros.
    let mut seed = 0x9e37_79b9_7f4a_7c15_u64;
    let mut draw = |_| {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        (seed >> 11) as f64 / (1u64 << 53) as f64 - 0.5
    };
    let mut q: Vec<f64> = (0..size).map(&mut draw).collect();
    let (mut before, mut next) = (vec![0.0; size], vec![0.0; size]);
    let (mut on, mut beside) = (Vec::with_capacity(STEPS), Vec::with_capacity(STEPS));
    let mut rest = dot(&q, &q).sqrt();
    for k in 0..STEPS.min(size) {
        if k > 0 {
            beside.push(rest);
        }
        q.iter_mut().for_each(|x| *x /= rest);
        times(&q, &mut next);
        let along = dot(&q, &next);
        let back = if k > 0 { rest } else { 0.0 };
        for ((x, q), p) in next.iter_mut().zip(&q).zip(&before) {
            *x -= along * q + back * p;
        }
        on.push(along);
        rest = dot(&next, &next).sqrt();
        if rest <= 1e-12 * on[0] {
            break;
        }
        // The next vector, the present one as the one before, and room.
        std::mem::swap(&mut before, &mut q);
        std::mem::swap(&mut q, &mut next);
    }
    top(&on, &beside)
}

fn dot(x: &[f64], y: &[f64]) -> f64 {
    x.iter().zip(y).map(|(a, b)| a * b).sum()
}

/// Largest eigenvalue of a symmetric tridiagonal matrix, from above by bisection.
fn top(on: &[f64], beside: &[f64]) -> f64 {
    let off = |k: usize| beside.get(k).copied().unwrap_or(0.0);
    let bound = |k: usize| {
        let before = if k == 0 { 0.0 } else { off(k - 1) };
        let after = if k + 1 < on.len() { off(k) } else { 0.0 };
        on[k] + before + after
    };
    let mut high = (0..on.len()).map(bound).fold(0.0, f64::max);
    let mut low = on.iter().copied().fold(0.0, f64::max);
    // Whether all eigenvalues are below: all pivots of `x - T` are positive.
    let all_below = |x: f64| {
        let mut pivot = x - on[0];
        (1..on.len()).all(|k| {
            let sound = pivot > 0.0;
            pivot = x - on[k] - off(k - 1) * off(k - 1) / pivot;
            sound
        }) && pivot > 0.0
    };
    while high - low > 1e-9 * high {
        let middle = 0.5 * (low + high);
        if all_below(middle) {
            high = middle;
        } else {
            low = middle;
        }
    }
    high
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lanczos_finds_the_largest_eigenvalue() {
        // 1, 4, 9, ...: eigenvalues of a diagonal matrix, and of a chain 2 - 2 cos(k pi/(n + 1)).
        let squares = |x: &[f64], y: &mut [f64]| {
            for (k, (x, y)) in x.iter().zip(y).enumerate() {
                *y = ((k + 1) * (k + 1)) as f64 * x;
            }
        };
        assert!((largest(60, squares) / 3600.0 - 1.0).abs() < 2e-3);
        assert!((largest(3, squares) / 9.0 - 1.0).abs() < 1e-8);
        let n = 20;
        let chain = |x: &[f64], y: &mut [f64]| {
            for k in 0..n {
                let of = |k: usize| x.get(k).copied().unwrap_or(0.0);
                y[k] = 2.0 * x[k] - of(k + 1) - if k == 0 { 0.0 } else { of(k - 1) };
            }
        };
        let angle = std::f64::consts::PI * n as f64 / (n + 1) as f64;
        let exact = 2.0 - 2.0 * angle.cos();
        assert!((largest(n, chain) / exact - 1.0).abs() < 1e-8);
    }
}
