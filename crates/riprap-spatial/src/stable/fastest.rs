//! The fastest motion of a sum of springs and dashpots.
//!
//! The locally optimal method of conjugate gradients: each sweep takes the best motion in the space of the present one, the last
//! change and the residual. It comes as near as Lanczos's method in as many sweeps, about as the square of their
//! number where the highest frequencies lie close together, keeps the motion itself and can go on from it when dashpots come in.
//!
//! Source: Knyazev (2001), Toward the optimal preconditioned eigensolver, SIAM J. Sci. Comput. 23, algorithm 4.1 with one vector
//! and no preconditioner.

use riprap_geom::symmetric::principal_axes;
use riprap_geom::{Mat3, Vec3};

use crate::exec::{Divide, Exec};
use crate::lanes::{LANES, Lanes, Width};
use crate::push::bolts::stiffness::BoltSprings;
use crate::stable::springs::{PIECE, Part, Springs, Step, Weights, add, of, parts};
use crate::state::tiles::GROUP;
use crate::state::world::World;
use riprap_core::sums::tree;

/// Residual, over the value, below which the motion counts as found: the value is then known to the square of it.
const FOUND: f64 = 1e-7;

/// Blocks of a group in the motions of the method, all times the roots of the masses. `A` is the matrix of springs and dashpots.
#[derive(Clone, Copy)]
struct Rows {
    /// The motion, of length one.
    x: Part,
    /// The last change of it, of length one, perpendicular to it.
    p: Part,
    ax: Part,
    ap: Part,
    /// Products of the parts of this group.
    sums: Sums,
}

/// The entries of a motion in eight lanes of [`Rows`].
#[derive(Clone, Copy)]
struct Entry {
    x: Lanes,
    p: Lanes,
    ax: Lanes,
    ap: Lanes,
    /// `A` times what was multiplied last.
    image: Lanes,
}

impl Entry {
    /// `A x - value x`.
    #[inline(always)]
    fn residual(&self, value: Lanes) -> Lanes {
        self.ax - value * self.x
    }
}

/// A motion of all blocks that comes nearer to the fastest one with every sweep.
pub(super) struct Fastest<'a> {
    world: &'a World,
    springs: &'a Springs,
    exec: &'a Exec,
    width: Width,
    bolts: BoltSprings<'a>,
    weights: Weights,
    rows: Vec<Rows>,
    /// What is multiplied, over the roots of the masses: true displacements and rotations.
    at: Vec<Part>,
    /// `A` times that.
    image: Vec<Part>,
    /// The products of both, group by group.
    products: Vec<f64>,
    /// `x . A x`: the value of the motion.
    value: f64,
    /// Scalar products of the motion, the last change and the residual.
    sum: Sums,
}

/// Scalar products of x, p, r with x, p, r or their images: `xx, xp, pp, xr, pr, rr`.
type Products = [f64; 6];

/// Scalar products of x, p, r.
#[derive(Clone, Copy, Default)]
struct Sums {
    /// Among themselves.
    among: Products,
    /// With their images, but for that of r.
    images: Products,
}

impl Sums {
    fn add(&mut self, other: &Self) {
        for k in 0..6 {
            self.among[k] += other.among[k];
            self.images[k] += other.images[k];
        }
    }
}

/// Their matrix for the vectors times `scale`.
fn matrix([xx, xp, pp, xr, pr, rr]: Products, scale: Vec3) -> Mat3 {
    let rows = [[xx, xp, xr], [xp, pp, pr], [xr, pr, rr]];
    let scaled = Mat3::from_diagonal(scale);
    scaled * Mat3::from_cols_array_2d(&rows) * scaled
}

/// The best motion that x, p and r make, with their products among themselves and with their images: its value, and the factors of the
/// three in it and in the change that it is of x, both of length one and perpendicular to each other.
fn best(among: Products, images: Products) -> (f64, [Vec3; 2]) {
    let length = Vec3::new(among[0], among[2], among[5]).map(f64::sqrt);
    // Before the first change there is no p.
    let scale = length.map(|l| if l > 0.0 { 1.0 / l } else { 0.0 });
    let g = matrix(among, scale);
    let (xp, xr, pr) = (g.y_axis.x, g.z_axis.x, g.z_axis.y);
    // They are perpendicular up to round-off, which would grow from sweep to sweep: Cholesky's factor of their products.
    let pp = (1.0 - xp * xp).sqrt();
    let rp = (pr - xp * xr) / pp;
    let rr = (1.0 - xr * xr - rp * rp).sqrt();
    let factor =
        Mat3::from_cols(Vec3::new(1.0, xp, xr), Vec3::new(0.0, pp, rp), Vec3::new(0.0, 0.0, rr));
    let frame = factor.inverse();
    let inside = frame * matrix(images, scale) * frame.transpose();
    let ([value, ..], [x, ..]) = principal_axes(&inside);
    let went = Vec3::new(0.0, x.y, x.z);
    let p = (went - went.dot(x) * x).normalize_or_zero();
    (value, [x, p].map(|v| scale * (frame.transpose() * v)))
}

impl<'a> Fastest<'a> {
    /// A start that has a part of every mode: no symmetry, no zeros.
    pub(super) fn new(
        world: &'a World,
        springs: &'a Springs,
        exec: &'a Exec,
        width: Width,
    ) -> Self {
        let mut seed = 0x9e37_79b9_7f4a_7c15_u64;
        let mut draw = || {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            (seed >> 11) as f64 / (1u64 << 53) as f64 - 0.5
        };
        let n = world.alive.len();
        let mut new = Self {
            world,
            springs,
            exec,
            width,
            bolts: BoltSprings::new(world),
            weights: Weights::SPRINGS,
            rows: vec![
                Rows {
                    x: [[0.0; GROUP]; 6],
                    p: [[0.0; GROUP]; 6],
                    ax: [[0.0; GROUP]; 6],
                    ap: [[0.0; GROUP]; 6],
                    sums: Sums::default(),
                };
                n.div_ceil(GROUP)
            ],
            at: parts(n),
            image: parts(n),
            products: vec![0.0; n.div_ceil(GROUP)],
            value: 0.0,
            sum: Sums::default(),
        };
        let mut squares = 0.0;
        for (rows, root) in new.rows.iter_mut().zip(&springs.root) {
            let roots = root.as_flattened();
            for (x, root) in rows.x.as_flattened_mut().iter_mut().zip(roots) {
                let drawn = draw();
                // What cannot move takes no part.
                *x = if *root > 0.0 { drawn } else { 0.0 };
                squares += *x * *x;
            }
        }
        if squares > 0.0 {
            let scale = 1.0 / squares.sqrt();
            for x in new.rows.iter_mut().flat_map(|rows| rows.x.as_flattened_mut()) {
                *x *= scale;
            }
        }
        new
    }

    /// The motion of a block, times the roots of the masses.
    pub(super) fn of(&self, block: usize) -> [Vec3; 2] {
        let (x, k) = (&self.rows[block / GROUP].x, block % GROUP);
        [0, 3].map(|c| Vec3::new(x[c][k], x[c + 1][k], x[c + 2][k]))
    }

    /// `x . A x`: comes from below to the largest eigenvalue.
    pub(super) fn value(&self) -> f64 {
        self.value
    }

    /// Goes on with other springs and dashpots from the motion that was reached.
    pub(super) fn start(&mut self, weights: Weights) {
        self.weights = weights;
        self.value = self.quotient(weights);
        self.pass(
            self.value,
            #[inline(always)]
            |e| Entry { p: Lanes::default(), ax: e.image, ap: Lanes::default(), ..e },
        );
    }

    /// One sweep; false when the motion is found.
    pub(super) fn improve(&mut self) -> bool {
        if self.sum.among[5].sqrt() <= FOUND * self.value {
            return false;
        }
        let mut images = self.sum.images;
        images[5] = self.times(self.weights);
        let (value, [x, p]) = best(self.sum.among, images);
        let before = Lanes::all(self.value);
        let [x, p] = [x, p].map(|by| by.to_array().map(Lanes::all));
        self.value = value;
        self.pass(
            value,
            #[inline(always)]
            |e| {
                let r = e.residual(before);
                Entry {
                    x: x[0] * e.x + x[1] * e.p + x[2] * r,
                    p: p[0] * e.x + p[1] * e.p + p[2] * r,
                    ax: x[0] * e.ax + x[1] * e.ap + x[2] * e.image,
                    ap: p[0] * e.ax + p[1] * e.ap + p[2] * e.image,
                    image: e.image,
                }
            },
        );
        true
    }

    /// `x . B x` for other weights. Sweeps go on after [`Self::start`].
    pub(super) fn quotient(&mut self, weights: Weights) -> f64 {
        let motions = self.rows.iter().map(|rows| &rows.x);
        for ((at, root), x) in self.at.iter_mut().zip(&self.springs.root).zip(motions) {
            let of = root.as_flattened().iter().zip(x.as_flattened());
            for (at, (root, x)) in at.as_flattened_mut().iter_mut().zip(of) {
                *at = root * x;
            }
        }
        self.times(weights)
    }

    /// Changes all rows and takes their residuals as what is to be multiplied next.
    fn pass(&mut self, value: f64, change: impl Fn(Entry) -> Entry + Sync) {
        let (root, image, width) = (&self.springs.root, &self.image, self.width);
        let value = Lanes::all(value);
        let work = Groups(&mut self.rows, &mut self.at);
        self.exec.divided(work, self.springs.pieces(), |number, Groups(rows, at)| {
            let base = number * PIECE / GROUP;
            let given = image[base..].iter().zip(&root[base..]);
            for ((rows, at), (image, root)) in rows.iter_mut().zip(at).zip(given) {
                width.run(
                    #[inline(always)]
                    || group(rows, at, (image, root), value, &change),
                );
            }
        });
        let mut sums: Vec<Sums> = self.rows.iter().map(|rows| rows.sums).collect();
        tree(&mut sums, Sums::add);
        self.sum = sums.first().copied().unwrap_or_default();
    }

    /// Multiplies; the product of what is multiplied with its image.
    fn times(&mut self, weights: Weights) -> f64 {
        let n = self.world.alive.len() as u32;
        let mut bolted = Vec::new();
        if !self.world.bolts.is_empty() {
            let at: Vec<[Vec3; 2]> = (0..n).map(|b| of(&self.at, b)).collect();
            let mut sum = vec![[Vec3::ZERO; 2]; at.len()];
            self.bolts.pull(&at, &mut sum);
            bolted = packed(&sum);
        }
        let step = Step {
            world: self.world,
            springs: self.springs,
            weights,
            at: &self.at,
            bolted: &bolted,
            width: self.width,
        };
        let work = Groups(&mut self.image, &mut self.products);
        self.exec.divided(work, self.springs.pieces(), |number, Groups(image, sums)| {
            step.piece(number, image, sums);
        });
        tree(&mut self.products, |a, b| *a += b);
        self.products.first().copied().unwrap_or_default()
    }
}

#[inline(always)]
fn put(list: &mut [f64; GROUP], first: usize, lanes: Lanes) {
    list[first..first + LANES].copy_from_slice(&lanes.0);
}

/// Changes a group and writes its residual, over the roots of the masses, to `at`.
#[inline(always)]
fn group(
    rows: &mut Rows,
    at: &mut Part,
    (image, root): (&Part, &Part),
    value: Lanes,
    change: &impl Fn(Entry) -> Entry,
) {
    let (mut among, mut images) = ([Lanes::default(); 6], [Lanes::default(); 6]);
    for c in 0..6 {
        for k in (0..GROUP).step_by(LANES) {
            let e = change(Entry {
                x: Lanes::at(&rows.x[c], k),
                p: Lanes::at(&rows.p[c], k),
                ax: Lanes::at(&rows.ax[c], k),
                ap: Lanes::at(&rows.ap[c], k),
                image: Lanes::at(&image[c], k),
            });
            let r = e.residual(value);
            put(&mut rows.x[c], k, e.x);
            put(&mut rows.p[c], k, e.p);
            put(&mut rows.ax[c], k, e.ax);
            put(&mut rows.ap[c], k, e.ap);
            put(&mut at[c], k, Lanes::at(&root[c], k) * r);
            among[0] = among[0] + e.x * e.x;
            among[1] = among[1] + e.x * e.p;
            among[2] = among[2] + e.p * e.p;
            among[3] = among[3] + e.x * r;
            among[4] = among[4] + e.p * r;
            among[5] = among[5] + r * r;
            images[0] = images[0] + e.x * e.ax;
            images[1] = images[1] + e.x * e.ap;
            images[2] = images[2] + e.p * e.ap;
            // The matrix is symmetric: x . A r = A x . r.
            images[3] = images[3] + e.ax * r;
            images[4] = images[4] + e.ap * r;
        }
    }
    rows.sums = Sums { among: among.map(Lanes::sum), images: images.map(Lanes::sum) };
}

/// Parts of a list of motions.
fn packed(list: &[[Vec3; 2]]) -> Vec<Part> {
    let mut all = parts(list.len());
    for (b, v) in list.iter().enumerate() {
        add(&mut all, b as u32, *v);
    }
    all
}

/// Groups of some pieces.
struct Groups<'a, A, B>(&'a mut [A], &'a mut [B]);

impl<A: Send, B: Send> Divide for Groups<'_, A, B> {
    fn divide(self, middle: usize) -> (Self, Self) {
        let groups = middle * PIECE / GROUP;
        let ((a0, a1), (b0, b1)) = (self.0.split_at_mut(groups), self.1.split_at_mut(groups));
        (Groups(a0, b0), Groups(a1, b1))
    }
}
