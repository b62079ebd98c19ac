//! The state hash: blake3 over the bits of all that decides how a model goes on.

/// Takes in numbers, one after the other.
#[derive(Debug, Default)]
pub struct StateHash {
    hasher: blake3::Hasher,
    /// Bytes not yet handed on: blake3 is fast on many at once.
    waiting: Vec<u8>,
}

impl StateHash {
    const MANY: usize = 1 << 16;

    /// Takes in a number, bit by bit.
    pub fn number(&mut self, x: f64) {
        self.count(x.to_bits());
    }

    /// Takes in numbers.
    pub fn numbers<'a>(&mut self, list: impl IntoIterator<Item = &'a f64>) {
        for x in list {
            self.number(*x);
        }
    }

    /// Takes in a whole number: an index, a length, bits.
    pub fn count(&mut self, n: u64) {
        self.waiting.extend_from_slice(&n.to_le_bytes());
        if self.waiting.len() >= Self::MANY {
            self.hasher.update(&self.waiting);
            self.waiting.clear();
        }
    }

    /// Takes in two numbers of blocks, or of what else comes in pairs.
    pub fn pair(&mut self, [a, b]: [u32; 2]) {
        self.count(u64::from(a) << 32 | u64::from(b));
    }

    /// The hash of all that was taken in, in hexadecimal digits.
    #[must_use]
    pub fn finish(mut self) -> String {
        self.hasher.update(&self.waiting);
        self.hasher.finalize().to_hex().to_string()
    }
}

#[cfg(test)]
mod tests {
    use super::StateHash;

    #[test]
    fn every_bit_counts_however_many_there_are() {
        let hash = |last: f64, n: usize| {
            let mut hash = StateHash::default();
            hash.numbers(&vec![1.0; n]);
            hash.number(last);
            hash.finish()
        };
        for n in [0, 1, 8191, 8192, 20_000] {
            assert_eq!(hash(0.0, n), hash(0.0, n));
            assert_ne!(hash(0.0, n), hash(-0.0, n));
            assert_ne!(hash(0.0, n), hash(0.0, n + 1));
        }
    }
}
