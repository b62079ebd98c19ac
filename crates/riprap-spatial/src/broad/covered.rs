//! Faces that other blocks cover.

/// A part of a face that lies on another block.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Cover {
    pub block: u32,
    pub face: usize,
    /// m².
    pub area: f64,
}

/// Covered faces of all blocks.
#[derive(Clone, Debug, Default)]
pub struct Covered {
    /// A bit for each of the first 64 faces, per block; empty where no face is covered. Of other faces nothing is said.
    bits: Vec<u64>,
}

/// No face of any block.
pub(crate) static NO_FACE: Covered = Covered { bits: Vec::new() };

impl Covered {
    /// Those of which the parts leave at most the share `bare`; `area` of a face of a block, m².
    pub(crate) fn new(
        mut covers: Vec<Cover>,
        blocks: usize,
        area: impl Fn(u32, usize) -> f64,
        bare: f64,
    ) -> Self {
        covers.retain(|cover| cover.face < u64::BITS as usize);
        let mut found = Self::default();
        // The order of parts stays within a face, so that their sum has the same bits.
        covers.sort_by_key(|cover| (cover.block, cover.face));
        for of_face in covers.chunk_by(|a, b| (a.block, a.face) == (b.block, b.face)) {
            let Cover { block, face, .. } = of_face[0];
            let sum: f64 = of_face.iter().map(|cover| cover.area).sum();
            if sum >= (1.0 - bare) * area(block, face) {
                found.bits.resize(blocks, 0);
                found.bits[block as usize] |= 1_u64 << face;
            }
        }
        found
    }

    /// Covered faces of both blocks of a pair.
    #[must_use]
    pub fn of_pair(&self, ends: [u32; 2]) -> [u64; 2] {
        ends.map(|b| self.bits.get(b as usize).copied().unwrap_or(0))
    }
}

/// Whether a face is one of these bits; beyond them none is.
#[must_use]
pub(crate) fn has(bits: u64, face: usize) -> bool {
    face < u64::BITS as usize && bits >> face & 1 != 0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_face_is_covered_when_all_of_it_is() {
        let cover = |block, face, area| Cover { block, face, area };
        // Block 0 has two blocks on its face 2, which is 2 m² large, and half a block on face 3.
        let covers = vec![cover(0, 2, 1.0), cover(0, 3, 1.0), cover(1, 0, 2.0), cover(0, 2, 1.0)];
        let covered = Covered::new(covers, 4, |_, _| 2.0, 1e-6);
        assert_eq!(covered.of_pair([0, 1]), [1 << 2, 1]);
        assert_eq!(covered.of_pair([2, 3]), [0, 0]);
        assert_eq!(NO_FACE.of_pair([1, 3]), [0, 0]);
        assert!(has(1 << 63, 63) && !has(u64::MAX, 64) && !has(1 << 2, 3));
    }
}
