//! The targets of `riprap-fuzz`, called by libFuzzer: which bytes come next is guided by the code that earlier ones reached.
//!
//! `cargo fuzz run -s none TARGET` builds and runs them with the toolchain of the repository and a C++ compiler, without `-s none` with the
//! sanitizers of a nightly one.
//! Each file of `fuzz_targets` is the same line: what a target does, and what it starts from, stands in `riprap-fuzz` alone.

use riprap_fuzz::damage::Chance;
use riprap_fuzz::{Target, altered, seeds, target};

/// Makes a program of the target that has its name.
#[macro_export]
macro_rules! guided {
    () => {
        static GUIDED: std::sync::LazyLock<$crate::Guided> =
            std::sync::LazyLock::new(|| $crate::Guided::new(env!("CARGO_BIN_NAME")));

        libfuzzer_sys::fuzz_target!(|bytes: &[u8]| GUIDED.run(bytes));

        libfuzzer_sys::fuzz_mutator!(|data: &mut [u8], size: usize, max_size: usize, seed: u32| {
            GUIDED.mutate(data, size, max_size, seed)
        });
    };
}

/// A target with the inputs that it starts from.
pub struct Guided {
    target: &'static Target,
    seeds: Vec<Vec<u8>>,
}

impl Guided {
    /// # Panics
    /// No target has that name, or the files of its corpus cannot be read.
    #[must_use]
    pub fn new(name: &str) -> Self {
        let target = target(name).expect("programs are called as targets are");
        let files = seeds(target).expect("the corpus lies beside the sources").files;
        let seeds = files.into_iter().map(|(_, bytes)| bytes).collect();
        Self { target, seeds }
    }

    /// Tries an input.
    ///
    /// # Panics
    /// What the target panics with; or an input was taken that had to be refused.
    pub fn run(&self, bytes: &[u8]) {
        let taken = (self.target.run)(bytes);
        assert!(
            !(taken && self.target.sealed) || self.seeds.iter().any(|seed| seed == bytes),
            "a damaged one was taken"
        );
    }

    /// The next input: changed as libFuzzer does, or as texts and numbers are damaged, or one of the seeds, which are so reached without
    /// a folder that is given too. Returns its length.
    pub fn mutate(&self, data: &mut [u8], size: usize, max_size: usize, seed: u32) -> usize {
        let mut chance = Chance::new(seed.into());
        let again = size < 2 || chance.below(2000) == 0;
        let next = if again && !self.seeds.is_empty() {
            chance.of(&self.seeds).clone()
        } else if chance.below(2) == 0 {
            altered(self.target, &data[..size], &mut chance)
        } else {
            return libfuzzer_sys::fuzzer_mutate(data, size, max_size);
        };
        let length = next.len().min(max_size);
        data[..length].copy_from_slice(&next[..length]);
        length
    }
}
