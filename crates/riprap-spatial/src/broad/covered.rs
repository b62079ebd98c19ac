//! Faces that other blocks cover, and what of them a pair sees.

/// A part of a face that lies on another block.
#[derive(Clone, Copy, Debug)]
pub struct Cover {
    /// The block and the one that covers.
    pub ends: [u32; 2],
    /// Face of the block.
    pub face: usize,
    /// m².
    pub area: f64,
    /// Whether this is where the two blocks touch, and not only an edge that they share.
    pub touch: bool,
}

/// Covered faces of all blocks.
#[derive(Clone, Debug, Default)]
pub struct Covered {
    /// A bit for each of the first 64 faces, per block; empty where no face is covered. Of other faces nothing is said.
    bits: Vec<u64>,
    /// Block, the one that covers, and faces of the block on which they touch; ascending.
    by: Vec<([u32; 2], u64)>,
}

/// No face of any block.
pub(crate) static NO_FACE: Covered = Covered { bits: Vec::new(), by: Vec::new() };

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
        covers.sort_by_key(|cover| (cover.ends[0], cover.face));
        for of_face in covers.chunk_by(|a, b| (a.ends[0], a.face) == (b.ends[0], b.face)) {
            let Cover { ends: [block, _], face, .. } = of_face[0];
            let sum: f64 = of_face.iter().map(|cover| cover.area).sum();
            if sum >= (1.0 - bare) * area(block, face) {
                found.bits.resize(blocks, 0);
                found.bits[block as usize] |= 1_u64 << face;
                let touching = of_face.iter().filter(|cover| cover.touch);
                found.by.extend(touching.map(|cover| (cover.ends, 1_u64 << face)));
            }
        }
        found.by.sort_unstable();
        found.by.dedup_by(|next, kept| {
            let same = next.0 == kept.0;
            if same {
                kept.1 |= next.1;
            }
            same
        });
        found
    }

    /// Covered faces of both blocks of a pair; not those on which they cover each other, which are where the pair touches.
    ///
    /// Two blocks that both have covered faces, but do not lie on each other, meet at an edge or a corner among their neighbours: below what is left of
    /// their surfaces a sliver would be as deep as a block. They keep all their faces.
    #[must_use]
    pub fn of_pair(&self, [i, j]: [u32; 2]) -> [u64; 2] {
        let both = [i, j].map(|b| self.bits.get(b as usize).copied().unwrap_or(0));
        if both == [0; 2] {
            return both;
        }
        let shared = [[i, j], [j, i]].map(|ends| {
            let at = self.by.binary_search_by_key(&ends, |(ends, _)| *ends);
            at.map_or(0, |k| self.by[k].1)
        });
        let others = [0, 1].map(|side| both[side] & !shared[side]);
        if others.contains(&0) || shared != [0; 2] { others } else { [0; 2] }
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
    fn a_face_is_covered_when_all_of_it_is_and_not_in_the_pairs_that_cover_it() {
        let cover = |ends, face, area| Cover { ends, face, area, touch: true };
        // Block 0 has two blocks on its face 2, which is 2 m² large, and half a block on face 3.
        let covers = vec![
            cover([0, 1], 2, 1.0),
            cover([0, 2], 2, 1.0),
            cover([0, 3], 3, 1.0),
            cover([1, 0], 0, 2.0),
        ];
        let covered = Covered::new(covers, 6, |_, _| 2.0, 1e-6);
        assert_eq!(covered.of_pair([0, 1]), [0, 0]);
        assert_eq!(covered.of_pair([0, 2]), [0, 0]);
        assert_eq!(covered.of_pair([0, 3]), [1 << 2, 0]);
        assert_eq!(covered.of_pair([1, 3]), [1, 0]);
        assert_eq!(NO_FACE.of_pair([1, 3]), [0, 0]);
        assert!(has(1 << 63, 63) && !has(u64::MAX, 64) && !has(1 << 2, 3));
    }

    #[test]
    fn blocks_that_meet_at_an_edge_keep_their_faces_and_those_on_each_other_do_not() {
        // Four blocks about an edge: 0 and 3 lie on 1 and 2.
        let sides = [[0, 1], [0, 2], [1, 3], [2, 3]];
        let face = |of: usize, on: usize| 1 + (of + on) % 2;
        let covers = sides.iter().flat_map(|[i, j]| {
            let cover = |of: usize, on: usize| Cover {
                ends: [of as u32, on as u32],
                face: face(of, on),
                area: 1.0,
                touch: true,
            };
            [cover(*i, *j), cover(*j, *i)]
        });
        let covered = Covered::new(covers.collect(), 4, |_, _| 1.0, 1e-6);
        assert_eq!(covered.of_pair([0, 3]), [0, 0]);
        let bit = |of, on| 1_u64 << face(of, on);
        assert_eq!(covered.of_pair([0, 1]), [bit(0, 2), bit(1, 3)]);
    }
}
