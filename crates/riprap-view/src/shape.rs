//! What does not change from frame to frame: shapes of the blocks at rest, their faces, and which faces touch.
//!
//! A frame holds corners in current position. At rest means: the displacement and rotation that the frame names are
//! taken back, so that the same block has the same shape whichever frame it was read from. Frames whose blocks have the
//! same identities, corners and faces share one [`Shape`]; its `key` says which.

use riprap_geom::Quat;
use riprap_geom::Vec3;
use riprap_record::Frame;
use serde_json::json;
use std::hash::{DefaultHasher, Hash, Hasher};

use crate::parts::in_parts;
use crate::wire::Wire;

/// Faces whose corners lie nearer than this share of the typical block size are the same face: more than what deformable
/// blocks are strained, since only rigid motion can be taken back, and less than an opening that is drawn.
const SAME: f64 = 1e-3;
/// Cells in which faces are looked for, over the distance that counts as none: faces that are the same seldom lie in two.
const CELL: f64 = 60.0;

/// Blocks at rest.
#[derive(Debug, Default)]
pub struct Shape {
    /// Equal keys mean equal blocks, corners and faces.
    pub key: String,
    /// 2 or 3.
    pub dimension: u8,
    /// Shape `[blocks]`: number of each block in the run.
    pub ids: Vec<u32>,
    /// Shape `[blocks + 1]`: corners of each block.
    pub offsets: Vec<u32>,
    /// Corners at rest, m, less `origin`.
    pub points: Vec<Vec3>,
    /// Shape `[blocks]`: mean of each block's corners, less `origin`.
    pub middles: Vec<Vec3>,
    /// Typical size of a block, m.
    pub size: f64,
    /// Middle of the model, m, global axes: kept apart because pages compute in single precision.
    pub origin: Vec3,
    /// Shape `[blocks + 1]`: faces of each block.
    faces_of: Vec<u32>,
    /// Shape `[faces + 1]`: corners of each face.
    face_ends: Vec<u32>,
    /// Corners of the faces, counted over all blocks, anticlockwise seen from outside.
    corners: Vec<u32>,
    /// Faces that are not convex.
    hollow: Vec<u32>,
    /// Shape `[hollow + 1]`: triangles of those.
    hollow_ends: Vec<u32>,
    /// Corners of those triangles.
    hollow_corners: Vec<u32>,
    /// Faces that lie on each other at rest, two by two.
    twins: Vec<[u32; 2]>,
    /// Corners that lie on each other in those, as many as `twin_ends` says.
    pub twin_corners: Vec<[u32; 2]>,
    /// Shape `[twins + 1]`.
    pub twin_ends: Vec<u32>,
}

/// Identities of the blocks of a frame: column `block`, else the place in the frame.
pub fn ids(frame: &Frame) -> Vec<u32> {
    match frame.column("block").filter(|c| c.components == 1) {
        Some(column) => column.data.iter().map(|v| *v as u32).collect(),
        None => (0..frame.blocks() as u32).collect(),
    }
}

/// Key of the shape that a frame has.
pub fn key(frame: &Frame) -> String {
    let mut hasher = DefaultHasher::new();
    ids(frame).hash(&mut hasher);
    frame.offsets.hash(&mut hasher);
    if let Some(s) = &frame.solids {
        (&s.faces, &s.ends, &s.corners).hash(&mut hasher);
    }
    format!("{:016x}", hasher.finish())
}

impl Shape {
    /// The blocks of a frame at rest, positions less `origin`.
    pub fn of(frame: &Frame, origin: Vec3) -> Self {
        let mut shape = Shape {
            key: key(frame),
            dimension: if frame.solids.is_some() { 3 } else { 2 },
            ids: ids(frame),
            offsets: frame.offsets.clone(),
            origin,
            ..Shape::default()
        };
        if shape.offsets.is_empty() {
            shape.offsets.push(0);
        }
        shape.add_faces(frame);
        shape.points = at_rest(frame, &shape).iter().map(|p| *p - origin).collect();
        shape.middles = in_parts(frame.blocks(), |range| {
            range.map(|b| mean(&shape.points[shape.range(b)])).collect()
        });
        shape.size = shape.typical_size();
        shape.triangulate();
        shape.find_twins();
        shape
    }

    /// Corners of block `b`.
    pub fn range(&self, b: usize) -> std::ops::Range<usize> {
        self.offsets[b] as usize..self.offsets[b + 1] as usize
    }

    fn face(&self, f: usize) -> &[u32] {
        &self.corners[self.face_ends[f] as usize..self.face_ends[f + 1] as usize]
    }

    fn faces(&self) -> usize {
        self.face_ends.len() - 1
    }

    fn add_faces(&mut self, frame: &Frame) {
        self.faces_of.push(0);
        self.face_ends.push(0);
        for b in 0..frame.blocks() {
            let first = frame.offsets[b];
            match &frame.solids {
                Some(solids) => {
                    for face in solids.of(b) {
                        self.corners.extend(face.iter().map(|c| first + c));
                        self.face_ends.push(self.corners.len() as u32);
                    }
                }
                None => {
                    self.corners.extend(first..frame.offsets[b + 1]);
                    self.face_ends.push(self.corners.len() as u32);
                }
            }
            self.faces_of.push(self.face_ends.len() as u32 - 1);
        }
    }

    /// Median over the blocks of the diagonal of their boxes, by the square root of the dimension.
    fn typical_size(&self) -> f64 {
        let size = |b: usize| {
            let (low, high) = bounds(&self.points[self.range(b)]);
            (high - low).length() / f64::from(self.dimension).sqrt()
        };
        let mut sizes = in_parts(self.ids.len(), |range| {
            range.map(size).filter(|s| s.is_finite() && *s > 0.0).collect()
        });
        let middle = sizes.len() / 2;
        match sizes.len() {
            0 => 1.0,
            _ => *sizes.select_nth_unstable_by(middle, f64::total_cmp).1,
        }
    }

    /// Cuts faces that are not convex into triangles; convex ones are fans.
    fn triangulate(&mut self) {
        self.hollow_ends.push(0);
        let mut cutter = earcut::Earcut::new();
        let mut triangles: Vec<u32> = Vec::new();
        // Few faces are hollow, and to see that the others are not takes longest.
        let outline = |f: usize| -> Option<Vec<[f64; 2]>> {
            let outline: Vec<Vec3> =
                self.face(f).iter().map(|c| self.points[*c as usize]).collect();
            flattened(&outline).filter(|flat| !convex(flat))
        };
        let found = in_parts(self.faces(), |range| {
            range.filter_map(|f| Some((f, outline(f)?))).collect::<Vec<_>>()
        });
        for (f, flat) in found {
            let face = self.face(f);
            let no_holes: [u32; 0] = [];
            cutter.earcut(flat.iter().copied(), &no_holes, &mut triangles);
            let corners: Vec<u32> = triangles.iter().map(|k| face[*k as usize]).collect();
            self.hollow.push(f as u32);
            self.hollow_corners.extend(corners);
            self.hollow_ends.push(self.hollow_corners.len() as u32);
        }
    }

    /// Finds faces of different blocks with the same corners, in space.
    fn find_twins(&mut self) {
        self.twin_ends.push(0);
        if self.dimension == 2 {
            return;
        }
        let near = SAME * self.size;
        let mut block_of = Vec::with_capacity(self.faces());
        for b in 0..self.ids.len() {
            block_of.resize(self.faces_of[b + 1] as usize, b as u32);
        }
        let cells = self.cells(CELL * near);
        let mut taken = vec![false; self.faces()];
        let mut matched = Vec::new();
        for group in cells.chunk_by(|a, b| a.0 == b.0) {
            for (k, (_, f)) in group.iter().enumerate() {
                // Many faces in one place are rubbish; do not compare them all.
                for (_, g) in group.iter().skip(k + 1).take(16) {
                    let (f, g) = (*f as usize, *g as usize);
                    if taken[f] || taken[g] || block_of[f] == block_of[g] {
                        continue;
                    }
                    if self.same_corners(f, g, near, &mut matched) {
                        (taken[f], taken[g]) = (true, true);
                        self.twins.push([f as u32, g as u32]);
                        self.twin_corners.append(&mut matched);
                        self.twin_ends.push(self.twin_corners.len() as u32);
                    }
                }
            }
        }
    }

    /// Faces with the number of the cell of their middle, sorted so that faces at the same place are neighbours. Two cells may have one
    /// number: the faces are compared in any case.
    fn cells(&self, step: f64) -> Vec<(u64, u32)> {
        // Off by a part of a step, because models like to have their corners at whole numbers of it.
        let cell = |v: f64| (v / step + 0.437).floor() as i64;
        let number = |m: Vec3| {
            // Neighbours in space are neighbours in the list, too, and in memory.
            [m.x, m.y, m.z].iter().fold(0, |sum, v| sum << 21 | (cell(*v) as u64 & 0x1f_ffff))
        };
        let mut parts = in_parts(self.faces(), |range| {
            let mut part: Vec<(u64, u32)> = range
                .map(|f| (self.face_middle(f), f as u32))
                .filter(|(m, _)| m.is_finite())
                .map(|(m, f)| (number(m), f))
                .collect();
            part.sort_unstable();
            part
        });
        // Parts are sorted already, which this makes use of.
        parts.sort();
        parts
    }

    fn face_middle(&self, f: usize) -> Vec3 {
        let face = self.face(f);
        face.iter().map(|c| self.points[*c as usize]).sum::<Vec3>() / face.len().max(1) as f64
    }

    /// Whether each corner of face `f` lies on one of face `g`; which on which.
    fn same_corners(&self, f: usize, g: usize, near: f64, matched: &mut Vec<[u32; 2]>) -> bool {
        let (f, g) = (self.face(f), self.face(g));
        matched.clear();
        if f.len() != g.len() || f.len() > 64 {
            return false;
        }
        for a in f {
            let p = self.points[*a as usize];
            let Some(b) = g.iter().find(|b| p.distance(self.points[**b as usize]) <= near) else {
                return false;
            };
            matched.push([*a, *b]);
        }
        true
    }

    /// The answer `shape`.
    pub fn wire(&self) -> Vec<u8> {
        let (low, high) = bounds(&self.points);
        let flat: Vec<[f32; 3]> = self.points.iter().map(|p| single(*p)).collect();
        Wire::default()
            .u32("ids", &self.ids)
            .u32("offsets", &self.offsets)
            .f32("points", flat.as_flattened())
            .u32("facesOf", &self.faces_of)
            .u32("faceEnds", &self.face_ends)
            .u32("corners", &self.corners)
            .u32("hollow", &self.hollow)
            .u32("hollowEnds", &self.hollow_ends)
            .u32("hollowCorners", &self.hollow_corners)
            .u32("twins", self.twins.as_flattened())
            .finish(&json!({
                "key": self.key,
                "dimension": self.dimension,
                "size": self.size,
                "origin": self.origin.to_array(),
                "low": low.to_array(),
                "high": high.to_array(),
            }))
    }
}

/// Corners with displacement and rotation taken back, global axes.
fn at_rest(frame: &Frame, shape: &Shape) -> Vec<Vec3> {
    let mut points: Vec<Vec3> = frame.points.iter().map(|p| Vec3::from(*p)).collect();
    let vectors = |name: &str| -> Option<Vec<Vec3>> {
        let column = frame.column(name)?;
        Some(match column.components {
            1 => column.data.iter().map(|a| Vec3::new(0.0, 0.0, *a)).collect(),
            2 => column.data.chunks_exact(2).map(|v| Vec3::new(v[0], v[1], 0.0)).collect(),
            _ => column.data.chunks_exact(3).map(|v| Vec3::new(v[0], v[1], v[2])).collect(),
        })
    };
    let Some(displacement) = vectors("displacement") else {
        return points;
    };
    let rotation = vectors("rotation");
    let moved = |b: usize| {
        let shift = displacement[b];
        let turn = rotation.as_ref().map_or(Vec3::ZERO, |r| r[b]);
        let still = (shift == Vec3::ZERO && turn == Vec3::ZERO) || !(shift + turn).is_finite();
        (!still).then(|| (shape.centroid(b, &points), Quat::from_scaled_axis(-turn), shift))
    };
    let moves =
        in_parts(displacement.len().min(frame.blocks()), |range| range.map(moved).collect());
    for (b, there) in moves.iter().enumerate() {
        let Some((centre, back, shift)) = *there else { continue };
        for p in &mut points[shape.range(b)] {
            *p = back * (*p - centre) + centre - shift;
        }
    }
    points
}

impl Shape {
    /// Centroid of area or volume of block `b`, from the signed cones of its faces.
    fn centroid(&self, b: usize, points: &[Vec3]) -> Vec3 {
        // Cones from a place near by: from a far origin their sum would lose its digits.
        let start = mean(&points[self.range(b)]);
        let (mut sum, mut weight) = (Vec3::ZERO, 0.0);
        for f in self.faces_of[b] as usize..self.faces_of[b + 1] as usize {
            let face = self.face(f);
            let at = |k: usize| points[face[k % face.len()] as usize] - start;
            for k in 1..face.len().saturating_sub(1) {
                if self.dimension == 2 {
                    let w = (at(k) - at(0)).cross(at(k + 1) - at(0)).z;
                    sum += w * (at(0) + at(k) + at(k + 1)) / 3.0;
                    weight += w;
                } else {
                    let w = at(0).dot(at(k).cross(at(k + 1)));
                    sum += w * (at(0) + at(k) + at(k + 1)) / 4.0;
                    weight += w;
                }
            }
        }
        let centre = start + sum / weight;
        if centre.is_finite() { centre } else { start }
    }
}

/// Mean of points; zero of none.
pub fn mean(points: &[Vec3]) -> Vec3 {
    points.iter().sum::<Vec3>() / points.len().max(1) as f64
}

/// Box of the finite points; both zero if there are none.
pub fn bounds(points: &[Vec3]) -> (Vec3, Vec3) {
    let mut finite = points.iter().filter(|p| p.is_finite());
    let Some(first) = finite.next() else {
        return (Vec3::ZERO, Vec3::ZERO);
    };
    finite.fold((*first, *first), |(low, high), p| (low.min(*p), high.max(*p)))
}

/// Single precision.
pub fn single(v: Vec3) -> [f32; 3] {
    [v.x as f32, v.y as f32, v.z as f32]
}

/// A face in its own plane, anticlockwise; `None` for what has no area or is a triangle.
fn flattened(outline: &[Vec3]) -> Option<Vec<[f64; 2]>> {
    if outline.len() < 4 {
        return None;
    }
    let start = outline[0];
    let normal: Vec3 = outline.windows(2).map(|w| (w[0] - start).cross(w[1] - start)).sum();
    let normal = normal.try_normalize()?;
    let (e, f) = normal.any_orthonormal_pair();
    Some(outline.iter().map(|p| [(*p - start).dot(e), (*p - start).dot(f)]).collect())
}

fn convex(flat: &[[f64; 2]]) -> bool {
    let n = flat.len();
    (0..n).all(|k| {
        let [a, b, c] = [flat[k], flat[(k + 1) % n], flat[(k + 2) % n]];
        let (u, v) = ([b[0] - a[0], b[1] - a[1]], [c[0] - b[0], c[1] - b[1]]);
        let size = u[0].hypot(u[1]) * v[0].hypot(v[1]);
        u[0] * v[1] - u[1] * v[0] >= -1e-9 * size
    })
}
