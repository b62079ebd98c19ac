//! Planes that separate blocks: shared faces (in the plane shared edges) of a frame, and what has broken.

use super::PlotError;
use super::run::numbers;
use riprap_geom::face_overlap::face_overlap;
use riprap_geom::{Vec2, Vec3};
use riprap_record::frame::Frame;
use riprap_record::vtu;
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

/// Two faces lie in one plane if their distance is below this share of their size.
const APART: f64 = 2e-3;
/// ... and the cosine between their normals is above this.
const PARALLEL: f64 = 0.9999;
/// Shared parts below this share of the smaller face count as a touch at an edge.
const SMALLEST: f64 = 1e-4;
/// Faces over more cells of the grid than this are compared with all others.
const MANY_CELLS: f64 = 200.0;

/// A piece of a plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Plane {
    /// Numbers of the blocks on both sides.
    pub(super) blocks: [u32; 2],
    /// Unit normal, from the first to the second block.
    pub(super) normal: Vec3,
    /// Area in m²; in the plane length in m.
    pub(super) area: f64,
}

/// One face: outline, outward normal, block.
struct Face {
    block: u32,
    normal: Vec3,
    outline: Vec<Vec3>,
    low: Vec3,
    high: Vec3,
}

/// The shared parts of the faces of neighbours.
pub(super) fn shared(frame: &Frame) -> Vec<Plane> {
    let faces = faces(frame);
    let flat = frame.solids.is_none();
    let mut out = Vec::new();
    for (i, j) in neighbours(&faces) {
        let (a, b) = (&faces[i], &faces[j]);
        let area = if flat {
            edge_overlap(a, b)
        } else {
            let least = SMALLEST * area(&a.outline).min(area(&b.outline));
            face_overlap(&a.outline, &b.outline, a.normal, least).map(|o| o.area)
        };
        if let Some(area) = area {
            out.push(Plane { blocks: [a.block, b.block], normal: a.normal, area });
        }
    }
    out.sort_by_key(|p| p.blocks);
    out
}

fn area(outline: &[Vec3]) -> f64 {
    0.5 * area_vector(outline).length()
}

/// Newell's normal: twice the area vector.
fn area_vector(outline: &[Vec3]) -> Vec3 {
    let Some(&origin) = outline.first() else {
        return Vec3::ZERO;
    };
    let fan = outline.windows(2).skip(1);
    fan.map(|p| (p[0] - origin).cross(p[1] - origin)).sum()
}

/// All faces of a frame; in the plane all edges.
fn faces(frame: &Frame) -> Vec<Face> {
    let ids = frame.column("block").filter(|c| c.components == 1);
    let mut out = Vec::new();
    for i in 0..frame.blocks() {
        let block = ids.map_or(i as u32, |c| c.data[i] as u32);
        let points: Vec<Vec3> = frame.outline(i).iter().map(|p| Vec3::from(*p)).collect();
        let mut put = |outline: Vec<Vec3>, normal: Vec3| {
            let size = normal.length();
            if size > 0.0 && size.is_finite() {
                let low = outline.iter().fold(Vec3::INFINITY, |l, p| l.min(*p));
                let high = outline.iter().fold(Vec3::NEG_INFINITY, |h, p| h.max(*p));
                out.push(Face { block, normal: normal / size, outline, low, high });
            }
        };
        if let Some(solids) = &frame.solids {
            for face in solids.of(i) {
                let outline: Vec<Vec3> = face.iter().map(|&c| points[c as usize]).collect();
                let normal = area_vector(&outline);
                put(outline, normal);
            }
        } else {
            for (k, &p) in points.iter().enumerate() {
                let q = points[(k + 1) % points.len()];
                // Outlines run anticlockwise: outside is to the right.
                put(vec![p, q], Vec3::new(q.y - p.y, p.x - q.x, 0.0));
            }
        }
    }
    out
}

/// Length of the common part of two edges.
fn edge_overlap(a: &Face, b: &Face) -> Option<f64> {
    let along = a.outline[1] - a.outline[0];
    let length = along.length();
    let at = |p: Vec3| (p - a.outline[0]).dot(along / length);
    let (s, t) = (at(b.outline[0]), at(b.outline[1]));
    let common = s.max(t).min(length) - s.min(t).max(0.0);
    let least = SMALLEST * length.min((b.outline[1] - b.outline[0]).length());
    (common > least).then_some(common)
}

/// Pairs of faces of different blocks that look at each other in one plane, each once; the one whose normal points to
/// the other first.
fn neighbours(faces: &[Face]) -> Vec<(usize, usize)> {
    let mut sizes: Vec<f64> = faces.iter().map(|f| (f.high - f.low).max_element()).collect();
    sizes.sort_by(f64::total_cmp);
    let side = 2.0 * sizes.get(sizes.len() / 2).copied().unwrap_or(1.0);
    let corner = faces.iter().fold(Vec3::INFINITY, |c, f| c.min(f.low));
    let cell = |p: Vec3| ((p - corner) / side).floor();
    let slack = |f: &Face| Vec3::splat(APART * (f.high - f.low).max_element());
    let (mut cells, mut large): (BTreeMap<[i64; 3], Vec<usize>>, Vec<usize>) = Default::default();
    for (i, f) in faces.iter().enumerate() {
        let (low, high) = (cell(f.low - slack(f)), cell(f.high + slack(f)));
        let across = high - low + Vec3::ONE;
        let count = across.x * across.y * across.z;
        if count > MANY_CELLS || count.is_nan() {
            large.push(i);
            continue;
        }
        for x in low.x as i64..=high.x as i64 {
            for y in low.y as i64..=high.y as i64 {
                for z in low.z as i64..=high.z as i64 {
                    cells.entry([x, y, z]).or_default().push(i);
                }
            }
        }
    }
    let mut out = Vec::new();
    for (place, group) in &cells {
        for (k, &i) in group.iter().enumerate() {
            for &j in &group[k + 1..] {
                let (a, b) = (&faces[i], &faces[j]);
                if !facing(a, b) {
                    continue;
                }
                // Of the cells that both are in, the one with the lowest corner of their common part.
                let first = cell((a.low - slack(a)).max(b.low - slack(b)));
                if [first.x as i64, first.y as i64, first.z as i64] == *place {
                    out.push((i, j));
                }
            }
        }
    }
    for (k, &i) in large.iter().enumerate() {
        for j in 0..faces.len() {
            // Two large ones meet once, from the earlier.
            if large[..=k].binary_search(&j).is_err() && facing(&faces[i], &faces[j]) {
                out.push((i.min(j), i.max(j)));
            }
        }
    }
    out.sort_unstable();
    out
}

/// Whether two faces of different blocks lie in one plane with opposite normals, and their boxes touch.
fn facing(a: &Face, b: &Face) -> bool {
    if a.block == b.block || a.normal.dot(b.normal) > -PARALLEL {
        return false;
    }
    let size = (a.high - a.low).max_element().min((b.high - b.low).max_element());
    let slack = Vec3::splat(APART * size);
    let touching =
        (a.low - slack).cmple(b.high + slack).all() && (b.low - slack).cmple(a.high + slack).all();
    let middle = |f: &Face| f.outline.iter().sum::<Vec3>() / f.outline.len() as f64;
    touching && a.normal.dot(middle(b) - middle(a)).abs() <= APART * size
}

/// Something that has broken.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Crack {
    pub(super) normal: Vec3,
    /// m²; in the plane m.
    pub(super) area: f64,
    /// By shear more than by tension, where the run tells.
    pub(super) sheared: Option<bool>,
}

/// Cracks of a frame in space: the surfaces between deformable blocks, and failed patches of rigid ones. `between`: only those between
/// two blocks of the frame.
pub(super) fn cracks(
    frame: &Frame,
    surfaces: Option<&Path>,
    between: bool,
) -> Result<Vec<Crack>, PlotError> {
    let there: BTreeSet<u32> =
        if between { numbers(frame).into_iter().collect() } else { BTreeSet::new() };
    let (mut out, mut pairs) = (Vec::new(), BTreeSet::new());
    if let Some(path) = surfaces.filter(|p| p.exists()) {
        let file = vtu::read(path)?;
        let column = |name: &str| file.cell_columns.iter().find(|c| c.name == name);
        let (areas, modes) = (column("area"), column("mode"));
        let mut first = 0;
        for (k, &end) in file.offsets.iter().enumerate() {
            let points: Vec<Vec3> =
                file.points[first..end as usize].iter().map(|p| Vec3::from(*p)).collect();
            first = end as usize;
            let sides = column("block_a").zip(column("block_b"));
            let sides = sides.map(|(a, b)| [a.data[k] as u32, b.data[k] as u32]);
            if between && sides.is_some_and(|pair| pair.iter().any(|n| !there.contains(n))) {
                continue;
            }
            let normal = area_vector(&points);
            out.push(Crack {
                normal: normal.normalize_or_zero(),
                area: areas.map_or(0.5 * normal.length(), |c| c.data[k]),
                sheared: modes.map(|c| c.data[k] > 1.5),
            });
            pairs.extend(sides);
        }
    }
    out.extend(failed_patches(frame, &pairs));
    out.retain(|c| c.normal != Vec3::ZERO && c.area > 0.0);
    Ok(out)
}

/// Patches of a frame, points of which have failed, without those of `shown` pairs.
fn failed_patches(frame: &Frame, shown: &BTreeSet<[u32; 2]>) -> Vec<Crack> {
    let column = |name: &str, n: usize| {
        let found = frame.contact_columns.iter().find(|c| c.name == name);
        found.filter(|c| c.components == n)
    };
    let (Some(normals), Some(failed)) = (column("normal", 3), column("failed_area", 1)) else {
        return Vec::new();
    };
    let (Some(a), Some(b)) = (column("block_a", 1), column("block_b", 1)) else {
        return Vec::new();
    };
    (0..failed.len())
        .filter(|&k| failed.data[k] > 0.0 && !shown.contains(&[a.data[k] as u32, b.data[k] as u32]))
        .map(|k| Crack {
            normal: Vec3::from_slice(&normals.data[3 * k..3 * k + 3]),
            area: failed.data[k],
            sheared: None,
        })
        .collect()
}

/// Dip and dip direction of a plane.
///
/// x points east, y north, z up. *Units*: degrees; dip 0 to 90, dip direction 0 to 360 clockwise from north. The dip
/// direction of a vertical plane is the one below 180.
pub(super) fn dip(normal: Vec3) -> [f64; 2] {
    let n = if normal.z < 0.0 { -normal } else { normal };
    let dip = libm::atan2(n.x.hypot(n.y), n.z).to_degrees();
    let direction = libm::atan2(n.x, n.y).to_degrees().rem_euclid(360.0);
    if dip > 90.0 - 1e-6 {
        [90.0, direction % 180.0]
    } else if dip < 1e-6 {
        [0.0, 0.0]
    } else {
        [dip, direction]
    }
}

/// Angle of the trace of a joint in the plane, anticlockwise from x. *Units*: degrees, 0 to 180.
pub(super) fn trace_angle(normal: Vec3) -> f64 {
    let along = Vec2::new(-normal.y, normal.x);
    libm::atan2(along.y, along.x).to_degrees().rem_euclid(180.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use riprap_testkit::{sample, solid_sample};

    #[test]
    fn dips_of_known_planes() {
        let close = |n: Vec3, want: [f64; 2]| {
            let got = dip(n);
            assert!(
                (got[0] - want[0]).abs() < 1e-9 && (got[1] - want[1]).abs() < 1e-9,
                "{n}: {got:?}"
            );
        };
        close(Vec3::Z, [0.0, 0.0]);
        close(Vec3::X, [90.0, 90.0]);
        close(-Vec3::X, [90.0, 90.0]);
        close(Vec3::Y, [90.0, 0.0]);
        // A plane falling to the east at 45 degrees: its upward normal leans east.
        close(Vec3::new(1.0, 0.0, 1.0), [45.0, 90.0]);
        close(Vec3::new(-1.0, 0.0, -1.0), [45.0, 90.0]);
        close(Vec3::new(-1.0, 0.0, 1.0), [45.0, 270.0]);
        close(Vec3::new(0.0, -1.0, 3f64.sqrt()), [30.0, 180.0]);
    }

    #[test]
    fn traces() {
        assert!(trace_angle(Vec3::Y) < 1e-9);
        assert!((trace_angle(Vec3::X) - 90.0).abs() < 1e-9);
        assert!((trace_angle(Vec3::new(-1.0, 1.0, 0.0)) - 45.0).abs() < 1e-9);
        assert!((trace_angle(Vec3::new(1.0, -1.0, 0.0)) - 45.0).abs() < 1e-9);
    }

    #[test]
    fn the_shared_edge_of_two_polygons() {
        let found = shared(&sample());
        assert_eq!(found.len(), 1);
        assert_eq!(found[0].blocks, [0, 1]);
        assert!((found[0].area - 1.0).abs() < 1e-12);
        assert!((found[0].normal - Vec3::X).length() < 1e-12);
    }

    #[test]
    fn the_shared_face_of_a_brick_and_a_tetrahedron() {
        let found = shared(&solid_sample());
        assert_eq!(found.len(), 1);
        assert!((found[0].area - 0.5).abs() < 1e-12, "{found:?}");
        assert!((found[0].normal - Vec3::X).length() < 1e-12);
    }
}
