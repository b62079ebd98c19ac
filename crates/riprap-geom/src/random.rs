//! The one source of chance: PCG-64 with a seed, and the two distributions needed.

use rand::{Rng as _, SeedableRng as _};
use rand_pcg::Pcg64;

/// A seeded stream of numbers, the same on every machine.
pub struct Chance(Pcg64);

impl Chance {
    /// The stream of a seed.
    #[must_use]
    pub fn new(seed: u64) -> Self {
        Chance(Pcg64::seed_from_u64(seed))
    }

    /// Uniform in [0, 1), from the upper 53 bits.
    pub fn unit(&mut self) -> f64 {
        (self.0.next_u64() >> 11) as f64 * (1.0 / (1u64 << 53) as f64)
    }

    /// Uniform in [low, high).
    pub(crate) fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    /// Normal with mean 0 and deviation 1 (Box and Muller's cosine half; two draws each).
    pub(crate) fn normal(&mut self) -> f64 {
        // In (0, 1]: the logarithm of 0 would be infinite.
        let u = 1.0 - self.unit();
        let v = self.unit();
        libm::sqrt(-2.0 * libm::log(u)) * libm::cos(std::f64::consts::TAU * v)
    }

    /// Uniform whole number from low to high, both included.
    pub fn whole(&mut self, low: usize, high: usize) -> usize {
        let span = (high - low + 1) as u128;
        // The upper half of the product: one draw each, and a bias of span/2^64 at most.
        low + ((u128::from(self.0.next_u64()) * span) >> 64) as usize
    }
}
