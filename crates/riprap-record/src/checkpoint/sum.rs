//! The blake3 of a head that is known last and of a payload that comes before it.
//!
//! blake3 is a tree over chunks of 1024 bytes: the head lies in the first one, and the subtrees beside the path from the root to
//! that chunk begin after 1, 2, 4, 8, ... chunks and are as long as what stands before them. Each is summed as it comes, and joined
//! when the head is there.

use blake3::hazmat::{
    ChainingValue, HasherExt, Mode, merge_subtrees_non_root, merge_subtrees_root,
};
use blake3::{CHUNK_LEN, Hasher};

pub(super) struct Sum {
    /// What follows the head in the first chunk.
    first: Vec<u8>,
    /// Bytes of the first chunk that are not of the head.
    room: usize,
    /// Whole subtrees, in order.
    beside: Vec<ChainingValue>,
    /// The subtree that grows, and its bytes so far.
    growing: Hasher,
    bytes: u64,
}

impl Sum {
    /// A sum in which `head` bytes, less than a chunk, are left out for now.
    pub(super) fn after(head: usize) -> Self {
        Self {
            first: Vec::new(),
            room: CHUNK_LEN - head,
            beside: Vec::new(),
            growing: Hasher::new(),
            bytes: 0,
        }
    }

    /// Adds what follows.
    pub(super) fn update(&mut self, bytes: &[u8]) {
        let (first, mut rest) = bytes.split_at(bytes.len().min(self.room - self.first.len()));
        self.first.extend_from_slice(first);
        while !rest.is_empty() {
            let length = (CHUNK_LEN as u64) << self.beside.len();
            if self.bytes == 0 {
                self.growing = Hasher::new();
                self.growing.set_input_offset(length);
            }
            let room = usize::try_from(length - self.bytes).unwrap_or(usize::MAX);
            let (now, later) = rest.split_at(rest.len().min(room));
            self.growing.update(now);
            self.bytes += now.len() as u64;
            if self.bytes == length {
                self.beside.push(self.growing.finalize_non_root());
                self.bytes = 0;
            }
            rest = later;
        }
    }

    /// The sum with its head.
    pub(super) fn finish(mut self, head: &[u8]) -> [u8; 32] {
        if self.bytes > 0 {
            self.beside.push(self.growing.finalize_non_root());
        }
        let mut chunk = Hasher::new();
        chunk.update(head).update(&self.first);
        let Some(last) = self.beside.pop() else {
            return *chunk.finalize().as_bytes();
        };
        let before = (self.beside.iter()).fold(chunk.finalize_non_root(), |left, right| {
            merge_subtrees_non_root(&left, right, Mode::Hash)
        });
        *merge_subtrees_root(&before, &last, Mode::Hash).as_bytes()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Lengths about all edges of chunks and subtrees, in pieces of any size.
    #[test]
    fn a_head_that_comes_last_does_not_change_the_sum() {
        let all: Vec<u8> =
            (0..100_000u32).map(|i| (i.wrapping_mul(2_654_435_761) >> 24) as u8).collect();
        for head in [1, 44, 1000] {
            let edges = (0..7).flat_map(|k| {
                let edge = CHUNK_LEN << k;
                [edge - 1, edge, edge + 1, edge + CHUNK_LEN, edge + edge / 2]
            });
            for length in edges.chain([head, head + 1]).filter(|n| *n >= head) {
                for piece in [1, 7, 1024, 5000, 100_000] {
                    let (before, after) = all[..length].split_at(head);
                    let mut sum = Sum::after(head);
                    after.chunks(piece).for_each(|bytes| sum.update(bytes));
                    assert_eq!(
                        sum.finish(before),
                        *blake3::hash(&all[..length]).as_bytes(),
                        "{head} of {length} bytes in pieces of {piece}"
                    );
                }
            }
        }
    }
}
