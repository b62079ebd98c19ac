//! Coulomb friction of surfaces that slide and turn on each other at once.
//!
//! A surface that slips by `a` (two numbers in its plane) and turns by `w` about its normal rubs away the work `D(a, w) = int p |a + w n x r| dS`,
//! convex and of degree 1. Its gradient is what friction carries, a force and a moment on the *limit surface*, with the slip normal to it
//! (Goyal, Ruina and Papadopoulos 1991). Springs that would carry more than that slip until they are on it:
//!
//! ```text
//! minimum over slip q of   (q - q_0) . K (q - q_0)/2 + D(q),   carried = K (q_0 - q),
//! ```
//!
//! with `K q_0` what they would carry without slip: the nearest point of the limit surface, so friction never gives energy. All is
//! written without units: forces over the largest force N, moments over N times a length, slip over the largest force over the stiffness.

use crate::kernel::lever::Lever;
use crate::lanes::Lanes;

/// A slip, or a force and a moment, without units.
pub(crate) type Three = [f64; 3];

/// What a surface rubs away at a slip: work, its gradient and its second derivatives by columns.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Rub {
    pub(crate) work: f64,
    pub(crate) carried: Three,
    pub(crate) second: [Three; 3],
}

impl Rub {
    /// What slides by `a` while it turns by `w`, about the centre of rotation `(-a_t, a_s)/w` in its plane: from `value`, `pull` and `stiffness`
    /// there (see [`super::lever`]) of all its parts together.
    pub(crate) fn about(a: [f64; 2], w: f64, sum: &Lever) -> Self {
        let sign = if w < 0.0 { -1.0 } else { 1.0 };
        let centre = [-a[1] / w, a[0] / w];
        let Lever { value, pull, stiffness } = sum;
        let moment = sign * (value + centre[0] * pull[0] + centre[1] * pull[1]);
        let carried = [-sign * pull[1], sign * pull[0], moment];
        // Nothing changes along the slip itself: the derivatives with the turning follow from those with the sliding.
        let [ss, st, tt] = stiffness.map(|x| x / w.abs());
        let along = [-(ss * a[0] + st * a[1]) / w, -(st * a[0] + tt * a[1]) / w];
        let turning = -(along[0] * a[0] + along[1] * a[1]) / w;
        Self {
            work: carried[0] * a[0] + carried[1] * a[1] + carried[2] * w,
            carried,
            second: [[ss, st, along[0]], [st, tt, along[1]], [along[0], along[1], turning]],
        }
    }
}

impl Rub {
    /// Adds a share of the force at a place that turning moves by `lever`, and that rubs over a width (squared) when it stays where it is.
    pub(crate) fn add(&mut self, share: f64, [s, t, w]: Three, lever: [f64; 2], width: f64) {
        let v = [s + w * lever[0], t + w * lever[1]];
        let speed = (v[0] * v[0] + v[1] * v[1] + w * w * width).sqrt();
        if speed.is_nan() || speed <= 0.0 {
            return;
        }
        // Speed times its gradient, and half the second derivatives of its square.
        let g = [v[0], v[1], v[0] * lever[0] + v[1] * lever[1] + w * width];
        let turning = lever[0] * lever[0] + lever[1] * lever[1] + width;
        let square = [[1.0, 0.0, lever[0]], [0.0, 1.0, lever[1]], [lever[0], lever[1], turning]];
        self.work += share * speed;
        for i in 0..3 {
            self.carried[i] += share * g[i] / speed;
            for (k, entry) in self.second[i].iter_mut().enumerate() {
                *entry += share * (square[i][k] - g[i] * g[k] / (speed * speed)) / speed;
            }
        }
    }
}

/// A sum of [`Rub::add`] over points by eights, a lane each.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Rubbing {
    work: Lanes,
    carried: [Lanes; 3],
    /// The upper triangle by rows.
    second: [Lanes; 6],
}

impl Rubbing {
    /// Adds eight points: what each carries, and how turning moves it.
    #[inline(always)]
    pub(crate) fn add(&mut self, share: Lanes, q: Three, lever: [Lanes; 2]) {
        let (s, t, w) = (Lanes::all(q[0]), Lanes::all(q[1]), Lanes::all(q[2]));
        let v = [s + w * lever[0], t + w * lever[1]];
        let speed = (v[0] * v[0] + v[1] * v[1]).sqrt();
        // A place that does not move rubs nothing.
        let inverse = speed.with(speed, |speed, _| if speed > 0.0 { 1.0 / speed } else { 0.0 });
        let way = [v[0] * inverse, v[1] * inverse];
        let slope = [way[0], way[1], way[0] * lever[0] + way[1] * lever[1]];
        let rate = share * inverse;
        self.work = self.work + share * speed;
        for (sum, slope) in self.carried.iter_mut().zip(slope) {
            *sum = *sum + share * slope;
        }
        let [x, y, z] = slope;
        let (one, none) = (Lanes::all(1.0), Lanes::default());
        let turning = lever[0] * lever[0] + lever[1] * lever[1];
        let second = [
            one - x * x,
            none - x * y,
            lever[0] - x * z,
            one - y * y,
            lever[1] - y * z,
            turning - z * z,
        ];
        for (sum, of) in self.second.iter_mut().zip(second) {
            *sum = *sum + rate * of;
        }
    }

    /// Adds the sums over the lanes to others.
    pub(crate) fn give(&self, to: &mut Rub) {
        to.work += self.work.sum();
        for (sum, of) in to.carried.iter_mut().zip(&self.carried) {
            *sum += of.sum();
        }
        let [ss, st, sw, tt, tw, ww] = self.second.map(Lanes::sum);
        for (column, of) in to.second.iter_mut().zip([[ss, st, sw], [st, tt, tw], [sw, tw, ww]]) {
            for (entry, x) in column.iter_mut().zip(of) {
                *entry += x;
            }
        }
    }
}

/// A surface with friction.
pub(crate) trait Rubs {
    /// What it rubs away at this slip, which is not nil.
    fn rub(&self, q: Three) -> Rub;
}

/// Steps of Newton's method at most; three or four are enough.
const STEPS: usize = 40;
/// Promised decrease, over the largest force, below which the minimum is found.
const FOUND: f64 = 1e-13;
/// Share of what a step promises that it has to keep.
const LESS: f64 = 0.1;
/// Differences below this share of a value are round-off.
const HIDDEN: f64 = 1e-12;
/// Promises below this, of a work of 1, are kept within a factor of two.
const SURE: f64 = 0.05;
/// A load this much nearer to the limit than 1 is on it.
const NEAR: f64 = 1e-13;

/// What springs carry that would carry `trial`: `None` where that is no more than friction holds, and they stick.
///
/// `turn` is the stiffness against turning over that against sliding; `motion` the slip of this step if nothing sticks, from which the search
/// starts.
pub(crate) fn hold(surface: &impl Rubs, trial: Three, turn: f64, motion: Three) -> Option<Three> {
    let start = start(surface, trial, turn, motion)
        .or_else(|| outside(surface, trial).and_then(|q| start(surface, trial, turn, q)))?;
    Some(nearest(surface, trial, turn, start))
}

/// The best slip in this direction; `None` where none in it is better than to stick.
fn start(surface: &impl Rubs, trial: Three, turn: f64, way: Three) -> Option<Three> {
    let driven = dot(way, trial);
    if driven.is_nan() || driven <= 0.0 {
        return None;
    }
    let spare = driven - surface.rub(way).work;
    let stiff = way[0] * way[0] + way[1] * way[1] + turn * way[2] * way[2];
    (spare > NEAR * driven).then(|| way.map(|x| x * (spare / stiff)))
}

/// A slip at which `trial` does more work than is rubbed away, from the least of this work among the slips at which `trial` does the work
/// 1; `None` where there is none: `trial` is within the limit.
fn outside(surface: &impl Rubs, trial: Three) -> Option<Three> {
    let norm = dot(trial, trial);
    let mut q = trial.map(|x| x / norm);
    let mut here = surface.rub(q);
    for _ in 0..STEPS {
        if here.work < 1.0 - NEAR {
            return Some(q);
        }
        // Second derivatives vanish along q, which this lifts; the steps below keep the work of `trial`.
        let mut lifted = here.second;
        for (column, x) in lifted.iter_mut().zip(trial) {
            for (entry, y) in column.iter_mut().zip(trial) {
                *entry += x * y;
            }
        }
        let [down, aside] = [here.carried, trial].map(|b| solve(lifted, b));
        let share = dot(trial, down) / dot(trial, aside);
        let step = [0, 1, 2].map(|i| share * aside[i] - down[i]);
        let promised = -dot(here.carried, step);
        // About half of what is promised is left to win. Where all of it would not do, the load is held.
        let held = promised < SURE && promised < here.work - 1.0;
        if promised.is_nan() || promised <= FOUND || held {
            return None;
        }
        let work = |_, rub: &Rub| (rub.work, rub.carried);
        (q, here) = search(surface, (q, &here), step, work)?;
    }
    None
}

/// The minimum, from a slip that is better than none.
fn nearest(surface: &impl Rubs, trial: Three, turn: f64, start: Three) -> Three {
    let stiffness = [1.0, 1.0, turn];
    let free = [trial[0], trial[1], trial[2] / turn];
    let energy = |q: Three, rub: &Rub| {
        let left = [0, 1, 2].map(|i| q[i] - free[i]);
        let spring = [0, 1, 2].map(|i| stiffness[i] * left[i]);
        let slope = [0, 1, 2].map(|i| spring[i] + rub.carried[i]);
        (0.5 * dot(left, spring) + rub.work, slope)
    };
    let mut q = start;
    let mut here = surface.rub(q);
    for _ in 0..STEPS {
        let (_, slope) = energy(q, &here);
        let mut second = here.second;
        for (i, column) in second.iter_mut().enumerate() {
            column[i] += stiffness[i];
        }
        let step = solve(second, slope).map(|x| -x);
        let promised = -dot(slope, step);
        if promised.is_nan() {
            break;
        }
        if promised <= FOUND * dot(q, q).sqrt() {
            // The last step squares what is left: without it, the error of 1e-7 would depend on the axes.
            here = surface.rub([0, 1, 2].map(|i| q[i] + step[i]));
            break;
        }
        let Some(found) = search(surface, (q, &here), step, energy) else {
            break;
        };
        (q, here) = found;
    }
    here.carried
}

/// The longest of the steps 1, 1/2, 1/4 ... that makes less of something convex, whose value and slope are given; `None` where none does.
///
/// Near the minimum round-off hides what a step makes less. There the slope along it decides, as in the approximate condition of Hager and
/// Zhang (2005).
fn search(
    surface: &impl Rubs,
    (q, here): (Three, &Rub),
    step: Three,
    of: impl Fn(Three, &Rub) -> (f64, Three),
) -> Option<(Three, Rub)> {
    let (now, slope) = of(q, here);
    let promised = -dot(slope, step);
    let hidden = now + HIDDEN * now.abs();
    let mut share = 1.0;
    for _ in 0..STEPS {
        let next = [0, 1, 2].map(|i| q[i] + share * step[i]);
        let rub = surface.rub(next);
        let (value, slope) = of(next, &rub);
        let less = value <= now - LESS * share * promised;
        let flat = value <= hidden && dot(slope, step) <= (1.0 - 2.0 * LESS) * promised;
        if less || flat {
            return Some((next, rub));
        }
        share *= 0.5;
    }
    None
}

fn dot(a: Three, b: Three) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Solution of a symmetric positive system, by its factors.
fn solve(m: [Three; 3], b: Three) -> Three {
    let d0 = m[0][0];
    let (l10, l20) = (m[0][1] / d0, m[0][2] / d0);
    let d1 = m[1][1] - l10 * m[0][1];
    let l21 = (m[1][2] - l10 * m[0][2]) / d1;
    let d2 = m[2][2] - l20 * m[0][2] - l21 * l21 * d1;
    let y0 = b[0];
    let y1 = b[1] - l10 * y0;
    let y2 = b[2] - l20 * y0 - l21 * y1;
    let x2 = y2 / d2;
    let x1 = y1 / d1 - l21 * x2;
    [y0 / d0 - l10 * x1 - l20 * x2, x1, x2]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::kernel::kit::Chance;
    use crate::kernel::lever::{FAR, for_points, lever};
    use crate::kernel::piece::Polygon;

    /// What a polygon rubs about the origin, by points.
    fn points(polygon: &Polygon, ratio: f64, q: Three) -> Rub {
        let (mut rubbing, mut sum) = (Rubbing::default(), Rub::default());
        for_points(polygon, ratio, [0.0; 2], [1.0, 0.0], |share, [x, y]| {
            rubbing.add(share, q, [-y, x]);
        });
        rubbing.give(&mut sum);
        sum
    }

    /// A polygon with the centre of its traction at the origin, and all of it 1.
    struct Flat(Polygon);

    impl Rubs for Flat {
        fn rub(&self, [s, t, w]: Three) -> Rub {
            let way = (s * s + t * t).sqrt();
            let corners = self.0.s().iter().zip(self.0.t());
            let reach = corners.map(|(x, y)| x * x + y * y).fold(0.0, f64::max);
            let ratio = w.abs() * reach.sqrt() / way;
            if ratio > FAR {
                return Rub::about([s, t], w, &lever(&self.0, [-t / w, s / w], [1.0, 0.0]));
            }
            points(&self.0, ratio, [s, t, w])
        }
    }

    fn faces() -> Vec<Flat> {
        let rectangle = |a: f64, b: f64, slope: f64| {
            let (x, y) = (0.5 * a, 0.5 * b);
            // The centre of p = p_0 (1 + slope x) lies at slope x²/3.
            let at = slope * x * x / 3.0;
            let corners = [[-x - at, -y], [x - at, -y], [x - at, y], [-x - at, y]];
            let level = 1.0 / (a * b);
            Flat(Polygon::of(corners, [level * (1.0 + slope * at), -level * slope, 0.0]))
        };
        let third = 3.0_f64.sqrt() / 6.0;
        let triangle = [[-0.5, -third], [0.5, -third], [0.0, 2.0 * third], [0.0, 2.0 * third]];
        vec![
            rectangle(1.0, 1.0, 0.0),
            rectangle(2.0, 1.0, 0.0),
            rectangle(10.0, 1.0, 0.0),
            rectangle(1.0, 0.01, 0.0),
            rectangle(1.0, 1.0, 1.9),
            Flat(Polygon::of(triangle, [1.0 / (1.5 * third), 0.0, 0.0])),
        ]
    }

    /// Three spots of some width.
    struct Spots;

    impl Rubs for Spots {
        fn rub(&self, q: Three) -> Rub {
            let mut sum = Rub::default();
            for (share, lever) in [(0.5, [0.0, 0.4]), (0.3, [0.2, -0.4]), (0.2, [-0.3, -0.4])] {
                sum.add(share, q, lever, 0.05);
            }
            sum
        }
    }

    /// What is rubbed away has the gradient and the second derivatives that are given.
    #[test]
    fn derivatives_are_those_of_the_work() {
        let mut chance = Chance::new(11);
        let mut all: Vec<Box<dyn Rubs>> = vec![Box::new(Spots)];
        all.extend(faces().into_iter().map(|face| Box::new(face) as Box<dyn Rubs>));
        for face in all {
            for _ in 0..50 {
                let q = [0, 1, 2].map(|_| 2.0 * chance.unit() - 1.0);
                let here = face.rub(q);
                for i in 0..3 {
                    let step = 1e-5;
                    let [less, more] = [-step, step].map(|d| {
                        let mut q = q;
                        q[i] += d;
                        face.rub(q)
                    });
                    let slope = (more.work - less.work) / (2.0 * step);
                    assert!((slope - here.carried[i]).abs() < 1e-5, "{slope} {here:?}");
                    for k in 0..3 {
                        let second = (more.carried[k] - less.carried[k]) / (2.0 * step);
                        let scale = 1e-3 * (1.0 + second.abs());
                        assert!((second - here.second[i][k]).abs() < scale, "{second} {here:?}");
                    }
                }
            }
        }
    }

    /// Points give what the integrals about a centre give, where both are good.
    #[test]
    fn a_far_centre_goes_over_into_a_near_one() {
        for Flat(face) in faces() {
            for angle in [0.3_f64, 1.2, 4.0] {
                let a = [libm::cos(angle), libm::sin(angle)];
                for (w, ratio) in [(0.13, 0.3), (0.09, 0.166), (-0.04, 0.07), (0.015, 0.0178)] {
                    let centre = [-a[1] / w, a[0] / w];
                    let near = Rub::about(a, w, &lever(&face, centre, [1.0, 0.0]));
                    let far = points(&face, ratio, [a[0], a[1], w]);
                    assert!((far.work - near.work).abs() < 1e-9, "{far:?} {near:?}");
                    for i in 0..3 {
                        let off = (far.carried[i] - near.carried[i]).abs();
                        assert!(off < 1e-7, "{far:?} {near:?}");
                    }
                }
            }
        }
    }

    /// Springs go to the nearest point of the limit, friction never gives energy, and what is within sticks.
    #[test]
    fn springs_slip_to_the_nearest_point() {
        let mut chance = Chance::new(5);
        let (mut slid, mut stuck) = (0, 0);
        for face in faces() {
            for _ in 0..400 {
                let trial = [1.6, 1.6, 0.8].map(|x| x * (2.0 * chance.unit() - 1.0));
                let motion = [0, 1, 2].map(|_| 2.0 * chance.unit() - 1.0);
                let turn = 0.2 + chance.unit();
                let held = hold(&face, trial, turn, motion);
                assert_eq!(held.is_none(), hold(&face, trial, turn, [0.0; 3]).is_none());
                let Some(held) = held else {
                    stuck += 1;
                    // No slip does more work than is rubbed away.
                    for _ in 0..50 {
                        let q = [0, 1, 2].map(|_| 2.0 * chance.unit() - 1.0);
                        let work = face.rub(q).work;
                        assert!(dot(q, trial) < work * (1.0 + 1e-6), "{trial:?} {q:?}");
                    }
                    continue;
                };
                slid += 1;
                let slip = [0, 1, 2].map(|i| (trial[i] - held[i]) / [1.0, 1.0, turn][i]);
                let rub = face.rub(slip);
                assert!(dot(held, slip) > 0.0, "{trial:?} {held:?} {turn} {motion:?}");
                // A slip that is off by 1e-6 changes what a strip of 1:100 carries by 1e-4.
                for i in 0..3 {
                    assert!((held[i] - rub.carried[i]).abs() < 5e-4, "{held:?} {rub:?}");
                }
            }
        }
        assert!(slid > 500 && stuck > 200, "{slid} {stuck}");
    }
}
