//! Highest frequencies block by block: what stays known of all blocks that a cut does not touch.
//!
//! The highest frequency of a sum of stiffnesses on a sum of masses is at most the highest one of its parts. A part is
//! a block with its tetrahedra, on bonds to fixed places: `(a - b) k (a - b) <= (1 + ma/mb) a k a + (1 + mb/ma) b k b` with
//! the masses `1/ma = sum w²/m` that a point moves on either side, so that two equal blocks, and two masses on one
//! spring, get no more than they have.
//!
//! Source: Irons & Treharne (1971), the bound by parts; the shares of the bonds are derived here.

use crate::exec::Exec;
use crate::lanes::Lanes;
use crate::lanes::Width;
use crate::laws::tetrahedron::Stiffness;
use crate::stable::deformable::MARGIN;
use crate::state::anchor::Anchor;
use crate::state::deform::{Body, Deform, RIGID};
use crate::state::workspace::Workspace;

/// Most steps of Lanczos's method: the value is then known to better than the margin.
const STEPS: usize = 24;
/// Steps after which it is asked, again and again, whether they are enough.
const CHECK_INTERVAL: usize = 4;
/// Share of the value up to which it must be known: a fifth of the margin.
const KNOWN: f64 = 1e-3;
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
    const TAKEN_OVER: u32 = u32::MAX;
    known.resize(deform.bodies.len(), f64::NAN);
    let (mut number, mut todo) = (vec![TAKEN_OVER; known.len()], Vec::new());
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
            if let Some(&to) = number.get(slot as usize).filter(|n| **n != TAKEN_OVER) {
                bonds[to as usize].push((k as u32, side as u8));
            }
        }
    }
    let jobs: Vec<(u32, Vec<(u32, u8)>)> = todo.into_iter().zip(bonds).collect();
    let found = exec.map(&jobs, RUN, |some| {
        let one = |(slot, bonds): &(u32, Vec<(u32, u8)>)| {
            let body = &deform.bodies[*slot as usize];
            highest(deform, work, body, bonds)
        };
        some.iter().map(one).collect::<Vec<f64>>()
    });
    for ((slot, _), square) in jobs.iter().zip(found.into_iter().flatten()) {
        known[*slot as usize] = square;
    }
    (known, jobs.len())
}

/// Square of the highest frequency of a body on its bonds, 1/s².
fn highest(deform: &Deform, work: &Workspace, body: &Body, bonds: &[(u32, u8)]) -> f64 {
    let class = work.class(body);
    let mut matrix = Stiffness::new(&class.mesh, &class.law);
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
            let Anchor::Nodes { nodes, weights } = point.anchors[here] else {
                continue;
            };
            let nodes = nodes.map(|n| n.saturating_sub(body.first));
            let springs = facet.stiffness.map(|k| share * k);
            matrix.add_spring(&nodes, &weights, facet.frame[0], springs);
        }
    }
    let masses = class.masses().iter();
    let roots: Vec<f64> = masses.map(|m| 1.0 / m.sqrt()).collect();
    matrix.scale(&roots);
    let largest = Width::detect().run(
        #[inline(always)]
        || largest(matrix.size(), |x, y| matrix.times(x, y)),
    );
    MARGIN * largest
}

/// Inverse of the mass that a point of a deformable block moves, 1/kg.
fn ease(deform: &Deform, work: &Workspace, block: u32, anchor: &Anchor) -> f64 {
    let Some(body) = deform.body(block as usize) else {
        return 0.0;
    };
    let masses = work.class(body).masses();
    let pairs = anchor.nodes();
    pairs.filter(|(_, w)| *w != 0.0).map(|(n, w)| w * w / masses[(n - body.first) as usize]).sum()
}

/// Largest eigenvalue of a symmetric operator on `size` numbers without negative ones, by Lanczos's method. That
/// round-off makes its vectors less orthogonal does no harm to the largest value.
#[inline(always)]
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
    let mut found = 0.0;
    let most = STEPS.min(size);
    for k in 0..most {
        if k > 0 {
            beside.push(rest);
        }
        let scale = 1.0 / rest;
        q.iter_mut().for_each(|x| *x *= scale);
        times(&q, &mut next);
        let along = dot(&q, &next);
        let back = if k > 0 { rest } else { 0.0 };
        for ((x, q), p) in next.iter_mut().zip(&q).zip(&before) {
            *x -= along * q + back * p;
        }
        on.push(along);
        rest = dot(&next, &next).sqrt();
        let exact = rest <= 1e-12 * on[0];
        if exact || k + 1 == most || (k + 1) % CHECK_INTERVAL == 0 {
            found = top(&on, &beside, found);
            if exact || rest * last(&on, &beside, found) <= KNOWN * found {
                break;
            }
        }
        // The next vector, the present one as the one before, and room.
        std::mem::swap(&mut before, &mut q);
        std::mem::swap(&mut q, &mut next);
    }
    found
}

#[inline(always)]
fn dot(x: &[f64], y: &[f64]) -> f64 {
    let ((x, x_rest), (y, y_rest)) = (x.as_chunks(), y.as_chunks());
    let mut sum = Lanes::default();
    for (x, y) in x.iter().zip(y) {
        sum = sum + Lanes(*x) * Lanes(*y);
    }
    let rest: f64 = x_rest.iter().zip(y_rest).map(|(a, b)| a * b).sum();
    sum.sum() + rest
}

/// Largest eigenvalue of a symmetric tridiagonal matrix, from above by bisection; it is at least `low`.
fn top(on: &[f64], beside: &[f64], low: f64) -> f64 {
    let off = |k: usize| beside.get(k).copied().unwrap_or(0.0);
    let bound = |k: usize| {
        let before = if k == 0 { 0.0 } else { off(k - 1) };
        let after = if k + 1 < on.len() { off(k) } else { 0.0 };
        on[k] + before + after
    };
    let mut high = (0..on.len()).map(bound).fold(0.0, f64::max);
    let mut low = on.iter().copied().fold(low, f64::max);
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

/// Magnitude of the last component of the unit eigenvector of a symmetric tridiagonal matrix for its largest eigenvalue:
/// times the length of what is left over after Lanczos's last step, it is the length by which the vector fails to be one of the operator.
///
/// Source: Parlett (1998), The symmetric eigenvalue problem, section 13.2.
fn last(on: &[f64], beside: &[f64], value: f64) -> f64 {
    // From the last component, taken as 1, to the first.
    let (mut now, mut after, mut squares) = (1.0, 0.0, 1.0);
    for k in (1..on.len()).rev() {
        let up = beside.get(k).copied().unwrap_or(0.0);
        (now, after) = (((value - on[k]) * now - up * after) / beside[k - 1], now);
        squares += now * now;
    }
    1.0 / squares.sqrt()
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
        // The largest one far away from the others is found soon.
        let mut calls = 0;
        let spread = |x: &[f64], y: &mut [f64]| {
            calls += 1;
            for (k, (x, y)) in x.iter().zip(y).enumerate() {
                *y = if k == 7 { 10.0 } else { 1.0 + 0.01 * k as f64 } * x;
            }
        };
        assert!((largest(45, spread) / 10.0 - 1.0).abs() < 1e-5);
        assert!(calls < STEPS, "{calls}");
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
