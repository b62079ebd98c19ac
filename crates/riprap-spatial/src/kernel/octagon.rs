//! Polygons of at most eight corners in vector registers (AVX-512): the same operations as the plain form, so the same bits.
//!
//! A lane is a corner. A line cuts in three steps, none of which knows how many corners there are:
//!
//! ```text
//!   corners  s t label      0  1  2  3  4  -  -  -        distance q of all to the line; inside: 1 1 0 0 1
//!   crossings of the edges  .  x  .  x  .  -  -  -        where q changes its sign from a corner to the next, of all edges at once
//!   picked by a row of the table of (corners, inside):    0  1  x1  x3  4
//! ```
//!
//! The row lists what the loop of the plain form would write, corner by corner. A piece that would have more corners, or a pair
//! with more planes than [`PLANES`], is left to the plain form.

use std::arch::x86_64::{
    __m128i, __m512d, __m512i, _CMP_GT_OQ, _CMP_LE_OQ, _mm_set_epi64x, _mm512_add_pd,
    _mm512_cmp_pd_mask, _mm512_cvtepi64_epi16, _mm512_cvtepu8_epi64, _mm512_div_pd,
    _mm512_mask_blend_epi64, _mm512_mask_blend_pd, _mm512_mul_pd, _mm512_permutex2var_epi64,
    _mm512_permutex2var_pd, _mm512_permutexvar_pd, _mm512_set1_epi64, _mm512_set1_pd,
    _mm512_setzero_pd, _mm512_shuffle_f64x2, _mm512_sub_pd, _mm512_unpackhi_pd, _mm512_unpacklo_pd,
};

use riprap_geom::Vec3;

use crate::kernel::frame::Frame;
use crate::kernel::piece::{BOUNDARY, Few, OPEN, Polygon};
use crate::kernel::planes::Planes;
use crate::lanes::{LANES, Lanes};

/// Most planes of a pair.
pub(super) const PLANES: usize = 32;

/// What a cut leaves: where each corner comes from (0 to 7: a corner, 8 to 15: the crossing of an edge), and how many there are.
#[derive(Clone, Copy)]
struct Row {
    from: [u8; LANES],
    len: u8,
}

/// More corners than lanes.
const TOO_MANY: u8 = u8::MAX;

/// Rows by [`first_row`] of the number of corners and by which of them are inside, as bits.
static ROWS: [Row; 504] = rows();

/// Where the corners after each are, by their number.
static NEXT: [[u8; LANES]; LANES + 1] = places(1, 0);
/// Where the corners themselves are, the last one in all lanes behind it.
static OWN: [[u8; LANES]; LANES + 1] = places(0, LANES);

const fn first_row(corners: usize) -> usize {
    // From 3 corners on, with 2^3, 2^4, ... rows.
    (1 << corners) - 8
}

const fn rows() -> [Row; 504] {
    let mut rows = [Row { from: [0; LANES], len: 0 }; 504];
    let mut corners = 3;
    while corners <= LANES {
        let mut inside = 0;
        while inside < 1 << corners {
            let row = &mut rows[first_row(corners) + inside];
            let mut i = 0;
            while i < corners {
                let next = if i + 1 < corners { i + 1 } else { 0 };
                let (here, there) = (inside >> i & 1 == 1, inside >> next & 1 == 1);
                if here {
                    push(row, i);
                }
                if here != there {
                    push(row, LANES + i);
                }
                i += 1;
            }
            inside += 1;
        }
        corners += 1;
    }
    rows
}

const fn push(row: &mut Row, from: usize) {
    if (row.len as usize) < LANES {
        row.from[row.len as usize] = from as u8;
        row.len += 1;
    } else {
        row.len = TOO_MANY;
    }
}

/// The place `on` further than each lane, by the number of corners; that of the last corner, or of the first (`behind` 0), behind them.
const fn places(on: u8, behind: usize) -> [[u8; LANES]; LANES + 1] {
    let mut places = [[0; LANES]; LANES + 1];
    let mut corners = 1;
    while corners <= LANES {
        let mut i = 0;
        while i < LANES {
            let at = i as u8 + on;
            let last = if behind == 0 { 0 } else { corners as u8 - 1 };
            places[corners][i] = if (at as usize) < corners { at } else { last };
            i += 1;
        }
        corners += 1;
    }
    places
}

fn pack(lanes: &[f64; LANES]) -> __m512d {
    // Safety: eight numbers are as large as a register, and each bit pattern is one of both.
    unsafe { std::mem::transmute::<[f64; LANES], __m512d>(*lanes) }
}

fn unpack(register: __m512d) -> [f64; LANES] {
    // Safety: as in `pack`.
    unsafe { std::mem::transmute::<__m512d, [f64; LANES]>(register) }
}

#[target_feature(enable = "avx512f,avx512dq")]
#[inline]
fn index(lanes: [u8; LANES]) -> __m512i {
    _mm512_cvtepu8_epi64(_mm_set_epi64x(0, i64::from_le_bytes(lanes)))
}

/// The registers of a polygon.
#[derive(Clone, Copy)]
struct Corners {
    s: __m512d,
    t: __m512d,
    label: __m512i,
    len: usize,
}

impl Corners {
    /// Keeps what lies where `a s + b t <= c`; whether anything does, `None` where it has too many corners.
    #[target_feature(enable = "avx512f,avx512dq")]
    #[inline]
    fn cut(&mut self, [a, b, c]: [f64; 3], label: u16) -> Option<bool> {
        let (s, t) = (self.s, self.t);
        let sum =
            _mm512_add_pd(_mm512_mul_pd(_mm512_set1_pd(a), s), _mm512_mul_pd(_mm512_set1_pd(b), t));
        let q = _mm512_sub_pd(sum, _mm512_set1_pd(c));
        let zero = _mm512_setzero_pd();
        let corners = (1_u32 << self.len) - 1;
        // Asked both ways, as in the plain form: what is not a number is neither inside nor outside there too.
        let inside = u32::from(_mm512_cmp_pd_mask::<_CMP_LE_OQ>(q, zero)) & corners;
        let outside = u32::from(_mm512_cmp_pd_mask::<_CMP_GT_OQ>(q, zero)) & corners;
        if outside == 0 || inside == 0 {
            return Some(inside != 0);
        }
        let row = &ROWS[first_row(self.len) + inside as usize];
        if row.len == TOO_MANY {
            return None;
        }
        let next = index(NEXT[self.len]);
        let after = |x: __m512d| _mm512_permutexvar_pd(next, x);
        // From the start of the edge, as in the plain form.
        let share = _mm512_div_pd(q, _mm512_sub_pd(q, after(q)));
        let crossing =
            |x: __m512d| _mm512_add_pd(x, _mm512_mul_pd(share, _mm512_sub_pd(after(x), x)));
        let (across_s, across_t) = (crossing(s), crossing(t));
        let label = _mm512_set1_epi64(i64::from(label));
        let made = _mm512_mask_blend_epi64(inside as u8, self.label, label);
        let from = index(row.from);
        self.s = _mm512_permutex2var_pd(s, from, across_s);
        self.t = _mm512_permutex2var_pd(t, from, across_t);
        self.label = _mm512_permutex2var_epi64(self.label, from, made);
        self.len = usize::from(row.len);
        Some(self.len >= 3)
    }
}

/// Makes piece (f, g) in the plane of `frame` from a square with half the side `square` (m); whether anything is left, `None` where
/// the plain form must do it. `spared` has a bit for each plane that does not cut.
#[target_feature(enable = "avx512f,avx512dq")]
pub(super) fn make(
    lines: &mut Lines,
    planes: &Planes,
    frame: &Frame,
    [f, g]: [usize; 2],
    square: f64,
    spared: u32,
    polygon: &mut Polygon,
) -> Option<bool> {
    let [u, v, w] = lines.find(planes, frame, [f, g]);
    let r = square;
    let mut corners = Corners {
        s: pack(&[-r, r, r, -r, 0.0, 0.0, 0.0, 0.0]),
        t: pack(&[-r, -r, r, r, 0.0, 0.0, 0.0, 0.0]),
        label: _mm512_set1_epi64(i64::from(OPEN)),
        len: 4,
    };
    if !corners.cut([u, v, w], BOUNDARY)? {
        return Some(false);
    }
    // In 64 bits, since 32 planes would shift all of 32 bits out.
    let all = ((1_u64 << planes.len()) - 1) as u32;
    let mut left = all & !(spared | 1 << f | 1 << g);
    while left != 0 {
        let k = left.trailing_zeros() as usize;
        left &= left - 1;
        if !corners.cut([lines.a[k], lines.b[k], lines.c[k]], k as u16)? {
            return Some(false);
        }
    }
    let own = index(OWN[corners.len]);
    let s = _mm512_permutexvar_pd(own, corners.s);
    let t = _mm512_permutexvar_pd(own, corners.t);
    let slope = |x: f64, of: __m512d| _mm512_mul_pd(_mm512_set1_pd(x), of);
    let depth = _mm512_sub_pd(_mm512_sub_pd(_mm512_set1_pd(w), slope(u, s)), slope(v, t));
    let lists = [Lanes(unpack(s)), Lanes(unpack(t)), Lanes(unpack(depth))];
    // Safety: both are eight numbers of 16 bits.
    let label =
        unsafe { std::mem::transmute::<__m128i, [u16; 8]>(_mm512_cvtepi64_epi16(corners.label)) };
    polygon.fill(corners.len, [w, u, v], Few { lists, label });
    Some(true)
}

/// Exchanges rows and columns of eight lists of eight numbers.
#[target_feature(enable = "avx512f,avx512dq")]
#[inline]
pub(super) fn transpose(rows: &[Lanes; LANES]) -> [Lanes; LANES] {
    let mut row = [_mm512_setzero_pd(); LANES];
    for (register, lanes) in row.iter_mut().zip(rows) {
        *register = pack(&lanes.0);
    }
    // Pairs of numbers, then of pairs: each register ends up with one number of every row.
    let mut two = row;
    for k in [0, 2, 4, 6] {
        two[k] = _mm512_unpacklo_pd(row[k], row[k + 1]);
        two[k + 1] = _mm512_unpackhi_pd(row[k], row[k + 1]);
    }
    let mut four = two;
    for (k, at) in [(0, 0), (1, 1), (4, 4), (5, 5)] {
        four[at] = _mm512_shuffle_f64x2::<0x88>(two[k], two[k + 2]);
        four[at + 2] = _mm512_shuffle_f64x2::<0xdd>(two[k], two[k + 2]);
    }
    let mut out = [Lanes::default(); LANES];
    for (k, [low, high]) in [(0, [0, 4]), (1, [1, 5]), (2, [2, 6]), (3, [3, 7])] {
        out[k] = Lanes(unpack(_mm512_shuffle_f64x2::<0x88>(four[low], four[high])));
        out[k + 4] = Lanes(unpack(_mm512_shuffle_f64x2::<0xdd>(four[low], four[high])));
    }
    out
}

/// What cuts a piece, in the coordinates of its frame: `a s + b t <= c` for each plane.
#[derive(Clone, Debug)]
pub(super) struct Lines {
    a: [f64; PLANES],
    b: [f64; PLANES],
    c: [f64; PLANES],
}

impl Default for Lines {
    fn default() -> Self {
        Self { a: [0.0; PLANES], b: [0.0; PLANES], c: [0.0; PLANES] }
    }
}

impl Lines {
    /// Finds the lines of all planes less that of their block's own face; returns that of `f` itself. There are at most [`PLANES`].
    ///
    /// Eight planes at a time; what stands in the lists behind the last one is found with them, and cuts nothing.
    #[target_feature(enable = "avx512f,avx512dq")]
    #[inline]
    fn find(&mut self, planes: &Planes, frame: &Frame, [f, g]: [usize; 2]) -> [f64; 3] {
        let own = [line(planes, frame, f), line(planes, frame, g)];
        let [e, h, o] = [all(frame.axes[0]), all(frame.axes[1]), all(frame.foot)];
        for from in (0..planes.len()).step_by(LANES) {
            let normal = [load(&planes.x, from), load(&planes.y, from), load(&planes.z, from)];
            let of_first = planes.split.saturating_sub(from).min(LANES);
            let of_second = !(((1_u32 << of_first) - 1) as u8);
            let w = _mm512_sub_pd(load(&planes.d, from), dot(&normal, &o));
            store(&mut self.a, from, less(dot(&normal, &e), own, 0, of_second));
            store(&mut self.b, from, less(dot(&normal, &h), own, 1, of_second));
            store(&mut self.c, from, less(w, own, 2, of_second));
        }
        own[0]
    }
}

/// The same vector in all lanes.
#[target_feature(enable = "avx512f,avx512dq")]
#[inline]
fn all(v: Vec3) -> [__m512d; 3] {
    [_mm512_set1_pd(v.x), _mm512_set1_pd(v.y), _mm512_set1_pd(v.z)]
}

#[target_feature(enable = "avx512f,avx512dq")]
#[inline]
fn dot([x, y, z]: &[__m512d; 3], [a, b, c]: &[__m512d; 3]) -> __m512d {
    let two = _mm512_add_pd(_mm512_mul_pd(*x, *a), _mm512_mul_pd(*y, *b));
    _mm512_add_pd(two, _mm512_mul_pd(*z, *c))
}

/// Less entry `k` of the line of the face of the own block: of the second in lanes with a bit.
#[target_feature(enable = "avx512f,avx512dq")]
#[inline]
fn less(x: __m512d, own: [[f64; 3]; 2], k: usize, of_second: u8) -> __m512d {
    let [first, second] = [_mm512_set1_pd(own[0][k]), _mm512_set1_pd(own[1][k])];
    _mm512_sub_pd(x, _mm512_mask_blend_pd(of_second, first, second))
}

#[inline(always)]
fn store(list: &mut [f64; PLANES], from: usize, lanes: __m512d) {
    list[from..from + LANES].copy_from_slice(&unpack(lanes));
}

#[inline(always)]
fn load(list: &[f64], from: usize) -> __m512d {
    pack(&Lanes::at(list, from).0)
}

/// Plane `k` in the coordinates of the frame: `u s + v t <= w`.
#[inline(always)]
fn line(planes: &Planes, frame: &Frame, k: usize) -> [f64; 3] {
    let (n, [e, h]) = (planes.normal(k), frame.axes);
    [n.dot(e), n.dot(h), planes.d[k] - n.dot(frame.foot)]
}
