//! Eight numbers at a time, the choice of the instruction set, and data asked for ahead.
//!
//! Lanes are plain arrays: the compiler turns loops over them into vector instructions of the width that the
//! calling function is compiled for. No fused multiply-add is allowed, so the width does not change a bit.

use std::ops::{Add, Div, Mul, Neg, Sub};

/// Lanes in a packet.
pub const LANES: usize = 8;

/// One number per lane.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(align(64))]
pub struct Lanes(pub [f64; LANES]);

impl Lanes {
    /// The same number in all lanes.
    #[inline(always)]
    #[must_use]
    pub fn all(x: f64) -> Self {
        Self([x; LANES])
    }

    /// Eight neighbours of a list.
    #[inline(always)]
    #[must_use]
    pub fn at(list: &[f64], first: usize) -> Self {
        let mut lanes = [0.0; LANES];
        lanes.copy_from_slice(&list[first..first + LANES]);
        Self(lanes)
    }

    /// Entries of a list by index.
    #[inline(always)]
    #[must_use]
    pub fn pick(list: &[f64], index: &[usize; LANES]) -> Self {
        let mut lanes = [0.0; LANES];
        for (x, k) in lanes.iter_mut().zip(index) {
            *x = list[*k];
        }
        Self(lanes)
    }

    /// Magnitudes.
    #[inline(always)]
    #[must_use]
    pub fn abs(self) -> Self {
        self.each(f64::abs)
    }

    /// Square roots.
    #[inline(always)]
    #[must_use]
    pub fn sqrt(self) -> Self {
        self.each(f64::sqrt)
    }

    /// Larger of two, lane by lane.
    #[inline(always)]
    #[must_use]
    pub fn max(self, other: Self) -> Self {
        // One instruction; `f64::max` must mind NaN.
        self.with(other, |a, b| if b > a { b } else { a })
    }

    /// Sum over the lanes, in pairs.
    #[inline(always)]
    #[must_use]
    pub fn sum(self) -> f64 {
        let [a, b, c, d, e, f, g, h] = self.0;
        ((a + b) + (c + d)) + ((e + f) + (g + h))
    }

    #[inline(always)]
    fn each(self, f: impl Fn(f64) -> f64) -> Self {
        let mut out = self;
        for a in &mut out.0 {
            *a = f(*a);
        }
        out
    }

    /// A function of two, lane by lane.
    #[inline(always)]
    #[must_use]
    pub fn with(self, other: Self, f: impl Fn(f64, f64) -> f64) -> Self {
        let mut out = self;
        for (a, b) in out.0.iter_mut().zip(other.0) {
            *a = f(*a, b);
        }
        out
    }
}

impl Add for Lanes {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        self.with(other, |a, b| a + b)
    }
}

impl Sub for Lanes {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self.with(other, |a, b| a - b)
    }
}

impl Mul for Lanes {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        self.with(other, |a, b| a * b)
    }
}

impl Div for Lanes {
    type Output = Self;
    #[inline(always)]
    fn div(self, other: Self) -> Self {
        self.with(other, |a, b| a / b)
    }
}

impl Neg for Lanes {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        self.each(|a| -a)
    }
}

/// What arithmetic is written for once: a number, or one in each lane.
pub trait Number:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self>
{
    /// A constant.
    fn constant(x: f64) -> Self;
    /// Square root.
    #[must_use]
    fn root(self) -> Self;
}

impl Number for f64 {
    #[inline(always)]
    fn constant(x: f64) -> Self {
        x
    }
    #[inline(always)]
    fn root(self) -> Self {
        self.sqrt()
    }
}

impl Number for Lanes {
    #[inline(always)]
    fn constant(x: f64) -> Self {
        Self::all(x)
    }
    #[inline(always)]
    fn root(self) -> Self {
        self.sqrt()
    }
}

/// One vector per lane.
pub type Vectors = [Lanes; 3];

/// The same vector in all lanes.
#[inline(always)]
#[must_use]
pub fn same(v: &[f64; 3]) -> Vectors {
    [Lanes::all(v[0]), Lanes::all(v[1]), Lanes::all(v[2])]
}

/// Eight neighbours of a list of vectors.
#[inline(always)]
#[must_use]
pub fn vectors(list: &[[f64; 3]; LANES]) -> Vectors {
    let mut v = Vectors::default();
    for (lane, x) in list.iter().enumerate() {
        for axis in 0..3 {
            v[axis].0[lane] = x[axis];
        }
    }
    v
}

/// Writes the vectors of the lanes to eight neighbours of a list.
#[inline(always)]
pub fn write(v: &Vectors, list: &mut [[f64; 3]; LANES]) {
    for (lane, x) in list.iter_mut().enumerate() {
        *x = [v[0].0[lane], v[1].0[lane], v[2].0[lane]];
    }
}

/// Scalar product.
#[inline(always)]
#[must_use]
pub fn dot<T: Number>(a: &[T; 3], b: &[T; 3]) -> T {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// A vector times a factor.
#[inline(always)]
#[must_use]
pub fn scaled<T: Number>(factor: T, v: &[T; 3]) -> [T; 3] {
    [factor * v[0], factor * v[1], factor * v[2]]
}

/// Cross product.
#[inline(always)]
#[must_use]
pub fn cross<T: Number>(a: &[T; 3], b: &[T; 3]) -> [T; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// Sum.
#[inline(always)]
#[must_use]
pub fn plus<T: Number>(a: &[T; 3], b: &[T; 3]) -> [T; 3] {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

/// Difference.
#[inline(always)]
#[must_use]
pub fn minus<T: Number>(a: &[T; 3], b: &[T; 3]) -> [T; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// Product of components, lane by lane.
#[inline(always)]
#[must_use]
pub fn times(a: &Vectors, b: &Vectors) -> Vectors {
    [a[0] * b[0], a[1] * b[1], a[2] * b[2]]
}

/// Asks for the cache line of an entry of a list some time before it is needed; does nothing where there is no such entry.
#[inline(always)]
pub fn fetch<T>(list: &[T], at: usize) {
    #[cfg(target_arch = "x86_64")]
    if let Some(entry) = list.get(at) {
        use std::arch::x86_64::{_MM_HINT_T0, _mm_prefetch};
        // Safety: a hint, which changes nothing and faults nowhere; every machine of the kind has it.
        unsafe { _mm_prefetch::<_MM_HINT_T0>(std::ptr::from_ref(entry).cast()) };
    }
    #[cfg(not(target_arch = "x86_64"))]
    let _ = (list, at);
}

/// Instruction set that wide code runs on. Every value is one that this machine has: there is no other way to one than [`Width::detect`].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct Width(Set);

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
enum Set {
    #[default]
    Plain,
    Four,
    Eight,
}

impl Width {
    /// What every machine of the kind has.
    pub const PLAIN: Self = Self(Set::Plain);

    /// The widest set of this machine: AVX-512, AVX2 or neither.
    #[must_use]
    pub fn detect() -> Self {
        #[cfg(target_arch = "x86_64")]
        {
            if is_x86_feature_detected!("avx512f") && is_x86_feature_detected!("avx512dq") {
                return Self(Set::Eight);
            }
            if is_x86_feature_detected!("avx2") {
                return Self(Set::Four);
            }
        }
        Self::PLAIN
    }

    /// The widest set up to this one with no more than so many numbers in a register.
    #[must_use]
    pub fn at_most(self, numbers: usize) -> Self {
        let limit = match numbers {
            0..4 => Set::Plain,
            4..8 => Set::Four,
            _ => Set::Eight,
        };
        Self(self.0.min(limit))
    }

    /// Whether registers hold eight numbers.
    #[must_use]
    pub fn is_eight(self) -> bool {
        self.0 == Set::Eight
    }

    /// Runs `f` compiled for this width. `f` must be small enough to be inlined whole.
    #[inline]
    pub fn run<R>(self, f: impl FnOnce() -> R) -> R {
        match self.0 {
            Set::Plain => f(),
            #[cfg(target_arch = "x86_64")]
            // Safety: `detect` has seen that the machine has these instructions.
            Set::Four => unsafe { four(f) },
            #[cfg(target_arch = "x86_64")]
            // Safety: as above.
            Set::Eight => unsafe { eight(f) },
            #[cfg(not(target_arch = "x86_64"))]
            Set::Four | Set::Eight => f(),
        }
    }
}

#[cfg(target_arch = "x86_64")]
// Without `fma`: with it the compiler could be told to fuse, and bits would depend on the machine.
#[target_feature(enable = "avx2")]
fn four<R>(f: impl FnOnce() -> R) -> R {
    f()
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx512f,avx512dq")]
fn eight<R>(f: impl FnOnce() -> R) -> R {
    f()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fetching_changes_nothing_and_fails_nowhere() {
        let list = [1.0, 2.0, 3.0];
        for at in [0, 2, 3, usize::MAX] {
            fetch(&list, at);
            fetch::<f64>(&[], at);
            fetch(&[(); 2], at);
        }
        assert_eq!(list, [1.0, 2.0, 3.0]);
    }
}
