//! Which tetrahedra of a block share volume with one of a part, and how much.
//!
//! Every part meets all tetrahedra of its block, nearly all of them not at all: a node of the part gets one bit for each
//! plane of the block that it lies below, and only tetrahedra with a node below all four planes of another are cut
//! by it, and only by the planes that it is not wholly below. The bits have a margin, so that the volumes are those that cutting
//! every pair by all planes would give.

use crate::Vec3;
use crate::geom::polyhedron::Tetrahedra;
use crate::lanes::Width;

/// Tetrahedra whose bits make up a word.
const PER_WORD: usize = 16;
/// Heights below this, times the size of the block, count as below a plane, and ones above minus this not as well below.
const MARGIN: f64 = 1e-9;

/// The tetrahedra of a block, prepared to be compared with those of its parts.
pub struct Cells {
    cells: Vec<Cell>,
    /// Normals and offsets of the planes of all cells, one list per component.
    planes: [Vec<f64>; 4],
    /// What heights over these planes must exceed to tell.
    margins: Vec<f64>,
}

/// A tetrahedron.
struct Cell {
    low: Vec3,
    high: Vec3,
    /// Normals away from the cell and a point of each face.
    faces: [[Vec3; 2]; 4],
}

/// Shares of the tetrahedra of a block in each tetrahedron of a part: `(the block's, volume over the part's volume)`,
/// which add up to 1.
pub struct Shares {
    first: Vec<u32>,
    list: Vec<(u32, f64)>,
}

impl Shares {
    /// Those of each tetrahedron of the part, in order.
    pub fn rows(&self) -> impl Iterator<Item = &[(u32, f64)]> {
        let ends = self.first.windows(2);
        ends.map(|w| &self.list[w[0] as usize..w[1] as usize])
    }
}

impl Cells {
    /// Those of a block.
    #[must_use]
    pub fn new(block: &Tetrahedra) -> Self {
        // Each face with the vertex opposite on its inner side.
        const FACES: [[usize; 3]; 4] = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]];
        let mut cells = Vec::with_capacity(block.tets.len());
        let count = 4 * block.tets.len();
        let mut planes: [Vec<f64>; 4] = std::array::from_fn(|_| Vec::with_capacity(count));
        let mut margins = Vec::with_capacity(count);
        let (low, high) = block
            .nodes
            .iter()
            .fold((Vec3::INFINITY, Vec3::NEG_INFINITY), |(low, high), at| {
                (low.min(*at), high.max(*at))
            });
        let reach = (high - low).length() + low.abs().max(high.abs()).max_element();
        for tet in &block.tets {
            let at = tet.map(|k| block.nodes[k as usize]);
            let (low, high) = bounds(&at);
            let faces = FACES.map(|face| {
                let [p, q, r] = face.map(|k| at[k]);
                [(q - p).cross(r - p), p]
            });
            for [normal, origin] in faces {
                for (list, x) in planes.iter_mut().zip(normal.to_array()) {
                    list.push(x);
                }
                planes[3].push(normal.dot(origin));
                margins.push(MARGIN * reach * normal.length());
            }
            cells.push(Cell { low, high, faces });
        }
        Self {
            cells,
            planes,
            margins,
        }
    }

    /// Where the nodes of a part lie.
    #[must_use]
    pub fn sides<'a>(&self, part: &'a Tetrahedra) -> Sides<'a> {
        let words = self.cells.len().div_ceil(PER_WORD);
        let mut sides = Vec::with_capacity(part.nodes.len() * words);
        let [x, y, z, offset] = &self.planes;
        let mut heights = vec![0.0; offset.len()];
        Width::detect().run(
            #[inline(always)]
            || {
                for at in &part.nodes {
                    for (k, height) in heights.iter_mut().enumerate() {
                        *height = x[k] * at.x + y[k] * at.y + z[k] * at.z - offset[k];
                    }
                    let runs = heights.chunks(4 * PER_WORD);
                    sides.extend(runs.zip(self.margins.chunks(4 * PER_WORD)).map(|run| Side {
                        below: bits(run, |height, margin| height < margin),
                        inside: bits(run, |height, margin| height < -margin),
                    }));
                }
            },
        );
        Sides { part, words, sides }
    }

    /// Shares of these cells in the tetrahedra of a part.
    #[must_use]
    pub fn shares(&self, sides: &Sides) -> Shares {
        let part = sides.part;
        let mut out = Shares {
            first: Vec::with_capacity(part.tets.len() + 1),
            list: Vec::with_capacity(8 * part.tets.len()),
        };
        let mut scratch = [Vec::new(), Vec::new()];
        out.first.push(0);
        for tet in &part.tets {
            let own = tet.map(|k| part.nodes[k as usize]);
            let (low, high) = bounds(&own);
            let begin = out.list.len();
            for word in 0..sides.words {
                let of = tet.map(|k| sides.sides[k as usize * sides.words + word]);
                let some = of[0].below | of[1].below | of[2].below | of[3].below;
                let all = of[0].inside & of[1].inside & of[2].inside & of[3].inside;
                for k in full(some) {
                    let cell = &self.cells[word * PER_WORD + k];
                    if low.cmpge(cell.high).any() || cell.low.cmpge(high).any() {
                        continue;
                    }
                    let volume = cell.common(&own, all >> (4 * k), &mut scratch);
                    if volume > 0.0 {
                        out.list.push(((word * PER_WORD + k) as u32, volume));
                    }
                }
            }
            let row = &mut out.list[begin..];
            let sum: f64 = row.iter().map(|(_, v)| v).sum();
            for (_, v) in row {
                *v /= sum;
            }
            out.first.push(out.list.len() as u32);
        }
        out
    }
}

/// Where the nodes of a part lie in a block.
pub struct Sides<'a> {
    part: &'a Tetrahedra,
    /// Words for each node.
    words: usize,
    sides: Vec<Side>,
}

impl Sides<'_> {
    /// Tetrahedra of the block that may hold a node, ascending.
    pub fn holders(&self, node: usize) -> impl Iterator<Item = usize> {
        let own = &self.sides[node * self.words..(node + 1) * self.words];
        let words = own.iter().enumerate();
        words.flat_map(|(word, side)| full(side.below).map(move |k| word * PER_WORD + k))
    }
}

/// Numbers of the groups of four bits that are all set, ascending.
fn full(bits: u64) -> impl Iterator<Item = usize> {
    let mut left = bits & (bits >> 1) & (bits >> 2) & (bits >> 3) & 0x1111_1111_1111_1111;
    std::iter::from_fn(move || {
        let next = (left != 0).then(|| left.trailing_zeros() as usize / 4);
        left &= left.wrapping_sub(1);
        next
    })
}

/// One bit for each of up to 64 pairs.
#[inline(always)]
fn bits((a, b): (&[f64], &[f64]), test: impl Fn(f64, f64) -> bool) -> u64 {
    let mut all = 0;
    for (k, (a, b)) in a.chunks(8).zip(b.chunks(8)).enumerate() {
        let mut byte = 0;
        for (bit, (a, b)) in a.iter().zip(b).enumerate() {
            byte |= u64::from(test(*a, *b)) << bit;
        }
        all |= byte << (8 * k);
    }
    all
}

/// Bits of a place, four for each cell.
#[derive(Clone, Copy, Default)]
struct Side {
    /// Not above the plane by more than the margin.
    below: u64,
    /// Below it by more.
    inside: u64,
}

impl Cell {
    /// Volume that a tetrahedron shares with this one, m³: it is cut by the faces of this one, but those that it is well below
    /// (one bit each).
    fn common(&self, own: &[Vec3; 4], below: u64, [pieces, next]: &mut [Vec<[Vec3; 4]>; 2]) -> f64 {
        pieces.clear();
        pieces.push(*own);
        for (face, [normal, origin]) in self.faces.iter().enumerate() {
            if (below >> face) & 1 == 1 {
                continue;
            }
            next.clear();
            for piece in pieces.iter() {
                keep_inside(piece, *normal, *origin, next);
            }
            std::mem::swap(pieces, next);
        }
        pieces.iter().map(volume).sum()
    }
}

fn volume(t: &[Vec3; 4]) -> f64 {
    (t[1] - t[0]).dot((t[2] - t[0]).cross(t[3] - t[0])).abs() / 6.0
}

fn bounds(t: &[Vec3; 4]) -> (Vec3, Vec3) {
    let low = t[0].min(t[1]).min(t[2].min(t[3]));
    (low, t[0].max(t[1]).max(t[2].max(t[3])))
}

/// Adds the tetrahedra that make up the part of one on the inner side of a plane.
fn keep_inside(tet: &[Vec3; 4], normal: Vec3, origin: Vec3, to: &mut Vec<[Vec3; 4]>) {
    let height = tet.map(|p| normal.dot(p - origin));
    // Vertices on either side, in order.
    let (mut inner, mut outer) = ([0; 4], [0; 4]);
    let (mut ins, mut outs) = (0, 0);
    for (k, height) in height.iter().enumerate() {
        if *height < 0.0 {
            inner[ins] = k;
            ins += 1;
        } else {
            outer[outs] = k;
            outs += 1;
        }
    }
    let cut = |i: usize, o: usize| {
        let share = height[i] / (height[i] - height[o]);
        tet[i] + share * (tet[o] - tet[i])
    };
    match (&inner[..ins], &outer[..outs]) {
        ([], _) => {}
        (_, []) => to.push(*tet),
        ([i], [a, b, c]) => to.push([tet[*i], cut(*i, *a), cut(*i, *b), cut(*i, *c)]),
        ([i, j], [a, b]) => {
            // A wedge between the triangles (i, ia, ib) and (j, ja, jb).
            wedge(
                [tet[*i], cut(*i, *a), cut(*i, *b)],
                [tet[*j], cut(*j, *a), cut(*j, *b)],
                to,
            );
        }
        ([i, j, k], [a]) => wedge(
            [tet[*i], tet[*j], tet[*k]],
            [cut(*i, *a), cut(*j, *a), cut(*k, *a)],
            to,
        ),
        // Four vertices are shared out in no other way.
        _ => {}
    }
}

/// Three tetrahedra of a prism between two triangles.
fn wedge([a, b, c]: [Vec3; 3], [d, e, f]: [Vec3; 3], to: &mut Vec<[Vec3; 4]>) {
    to.push([a, b, c, d]);
    to.push([b, c, d, e]);
    to.push([c, d, e, f]);
}
