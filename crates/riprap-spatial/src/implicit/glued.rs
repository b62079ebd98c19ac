//! Blocks of glued parts in the implicit step: the polygons of all of their terms, plane by plane.
//!
//! ```text
//!   surface of two blocks = sum over pairs of terms with signs     (crate::kernel::glued)
//!
//!     +---------------+                 a polygon with a minus lies in one with a plus in the same plane, where both have
//!     |  +1    +------|-------+         the same pressure; so what counts of a plane is a part of it, counted once, and
//!     |        |  -1  |   +1  |         its term of the step is convex like that of one polygon
//!     +--------|------+       |
//!              +--------------+
//! ```
//!
//! Polygons in one plane that overlap are one piece, which belongs to the pair of convex parts that has it first. Each two parts have a direction, friction and
//! a memory of their own, as in explicit phases.

use riprap_geom::Vec3;

use crate::implicit::geometry::Reach;
use crate::implicit::pair::Pair;
use crate::implicit::patch::Moments;
use crate::kernel::frame::Frame;
use crate::kernel::friction::hold;
use crate::kernel::glued::{CANCELLED, Glued, Gluer, Placed};
use crate::kernel::piece::Polygon;
use crate::kernel::terrain::Under;
use crate::kernel::{ContactLaw, Pose, Reached, Terrain};

/// Polygons with signs that overlap in one plane.
struct Flat {
    /// Which patch it belongs to, and its planes.
    key: [u32; 2],
    planes: [u32; 2],
    /// About the origin of all.
    frame: Frame,
    /// Change of the depth below the first face with the way outward, and normal of the second one.
    faces: [Vec3; 2],
    /// Depth in the frame, faces further out.
    depth: [f64; 3],
    /// How much of its first polygon counts.
    share: f64,
    /// Polygons, and how often they count.
    polygons: Vec<(Vec<[f64; 2]>, f64)>,
    /// Rectangles about them, m.
    bounds: Vec<[[f64; 2]; 2]>,
}

/// A polygon of a pair of terms.
struct Face<'a> {
    key: [u32; 2],
    planes: [u32; 2],
    faces: [Vec3; 2],
    frame: &'a Frame,
    /// From the origin of all to that of its frame, m.
    shift: Vec3,
    polygon: &'a Polygon,
    /// How often it counts.
    count: f64,
}

/// All of them of two blocks.
#[derive(Default)]
struct Flats(Vec<Flat>);

impl Flat {
    fn begin(face: &Face) -> Self {
        let frame = Frame { foot: face.frame.foot + face.shift, ..*face.frame };
        let [w, u, v] = face.polygon.slope;
        Self {
            key: face.key,
            planes: face.planes,
            frame,
            faces: face.faces,
            depth: [w, u, v],
            share: face.count,
            polygons: Vec::new(),
            bounds: Vec::new(),
        }
    }

    /// Corners of a polygon in its frame, m.
    fn corners(&self, face: &Face) -> Vec<[f64; 2]> {
        let own = face.polygon.s().iter().zip(face.polygon.t());
        own.map(|(s, t)| {
            let at = face.frame.point(*s, *t) + face.shift - self.frame.foot;
            self.frame.axes.map(|axis| axis.dot(at))
        })
        .collect()
    }

    fn overlaps(&self, bounds: &[[f64; 2]; 2]) -> bool {
        let [low, high] = bounds;
        let apart = |[l, h]: &[[f64; 2]; 2]| (0..2).any(|k| l[k] >= high[k] || low[k] >= h[k]);
        self.bounds.iter().any(|own| !apart(own))
    }

    /// Area that counts over the area of all, and the force of the pressure along its normal over twice the stiffness, faces further out, m³.
    fn counts(&self) -> (f64, f64) {
        let (mut area, mut all, mut force) = (0.0, 0.0, 0.0);
        let [w, u, v] = self.depth;
        for (corners, count) in &self.polygons {
            let moments = Moments::of(corners);
            area += count * moments.area();
            all += count.abs() * moments.area();
            force += count * moments.times(&[w, -u, -v])[0];
        }
        (if all > 0.0 { area / all } else { 0.0 }, force)
    }

    /// Gives it to a pair.
    fn give(&self, near: &mut Pair, out: f64) {
        let Some(((first, _), rest)) = self.polygons.split_first() else { return };
        let direction = near.direction;
        let facing = [self.faces[0].dot(direction), -self.faces[1].dot(direction)];
        if !near.add_piece(facing, self.share, &self.frame, self.depth, first.iter().copied(), out)
        {
            return;
        }
        for (corners, count) in rest {
            let from = near.corners.len();
            near.corners.extend(corners);
            let own = from..near.corners.len();
            if let Some(piece) = near.pieces.last_mut() {
                piece.add_polygon(own, count / self.share);
            }
        }
    }
}

/// A rectangle about a polygon, m.
fn rectangle(corners: &[[f64; 2]]) -> [[f64; 2]; 2] {
    let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
    for corner in corners {
        for k in 0..2 {
            low[k] = low[k].min(corner[k]);
            high[k] = high[k].max(corner[k]);
        }
    }
    [low, high]
}

impl Flats {
    fn add(&mut self, face: &Face) {
        let mut home: Option<usize> = None;
        let mut k = 0;
        while k < self.0.len() {
            let flat = &self.0[k];
            let own = flat.planes == face.planes && flat.overlaps(&rectangle(&flat.corners(face)));
            match home {
                _ if !own => k += 1,
                None => {
                    home = Some(k);
                    k += 1;
                }
                Some(first) => {
                    // It joins two that were apart.
                    let joined = self.0.remove(k);
                    self.join(first, joined);
                }
            }
        }
        if home.is_none() && face.count > 0.0 {
            self.0.push(Flat::begin(face));
            home = Some(self.0.len() - 1);
        }
        // What rounding leaves of a minus alone is nothing.
        let Some(flat) = home.map(|k| &mut self.0[k]) else { return };
        let corners = flat.corners(face);
        flat.bounds.push(rectangle(&corners));
        flat.polygons.push((corners, face.count));
    }

    /// Adds the polygons of another one in the same planes.
    fn join(&mut self, to: usize, other: Flat) {
        let to = &mut self.0[to];
        for (corners, count) in other.polygons {
            let moved: Vec<[f64; 2]> = corners
                .iter()
                .map(|[s, t]| {
                    let at = other.frame.point(*s, *t) - to.frame.foot;
                    to.frame.axes.map(|axis| axis.dot(at))
                })
                .collect();
            to.bounds.push(rectangle(&moved));
            to.polygons.push((moved, count));
        }
    }

    /// Puts them into `near`, a pair for each patch that the blocks share; how many there are. `begin` gets the key of a patch and the sum of its forces.
    fn give(
        &mut self,
        near: &mut Vec<Pair>,
        out: f64,
        begin: impl Fn([u32; 2], Vec3, &mut Pair) -> bool,
    ) -> usize {
        self.0.retain(|flat| flat.counts().0 > CANCELLED);
        let mut keys: Vec<[u32; 2]> = self.0.iter().map(|flat| flat.key).collect();
        keys.sort_unstable();
        keys.dedup();
        let mut count = 0;
        for key in keys {
            if near.len() == count {
                near.push(Pair::default());
            }
            let of = || self.0.iter().filter(|flat| flat.key == key);
            let force: Vec3 = of().map(|flat| flat.counts().1 * flat.frame.normal).sum();
            let pair = &mut near[count];
            if !begin(key, force, pair) {
                continue;
            }
            pair.key = key;
            of().for_each(|flat| flat.give(pair, out));
            count += usize::from(!pair.pieces.is_empty());
        }
        count
    }
}

/// Pieces of two blocks of which one at least is made of glued parts, with faces `out` (m) further out: a pair for each two parts, put into `near`,
/// and how many there are.
pub(crate) fn reach_glued(
    gluer: &mut Gluer,
    placed: &Placed,
    out: f64,
    law: ContactLaw,
    near: &mut Vec<Pair>,
) -> (Reach, usize) {
    let mut flats = Flats::default();
    let mut holds: Vec<([u32; 2], f64)> = Vec::new();
    let mut from: Option<Vec3> = None;
    gluer.place(placed);
    let reached = gluer.find_inflated(placed, out, |walker, shown| {
        let from = *from.get_or_insert(shown.origin);
        let key = shown.pieces.map(|piece| piece as u32);
        if shown.leads {
            let area = shown.sums.vector_area.length();
            let falls = walker.falling(&law, shown.sums);
            holds.push((key, if area > 0.0 { hold(&law, falls / area) } else { 1.0 }));
        }
        let [a, b] = shown.terms;
        let planes = &walker.planes;
        for ([f, g], frame, polygon, share) in walker.kept() {
            flats.add(&Face {
                key,
                planes: [a.plane(f), b.plane(g - planes.split)].map(u32::from),
                faces: [planes.normal(f), planes.normal(g)],
                frame,
                shift: shown.origin - from,
                polygon,
                count: a.sign * b.sign * share,
            });
        }
    });
    match reached {
        Reached::Apart(gap) => return (Reach::Apart(gap), 0),
        Reached::FullyPenetrated(_) => return (Reach::Lost, 0),
        Reached::Touching => {}
    }
    let from = from.unwrap_or_default();
    let centres = placed.poses.map(|pose| pose.position - from);
    let count = flats.give(near, out, |key, force, pair| {
        let size = force.length();
        if size > 0.0 {
            let hold = holds.iter().find(|(of, _)| *of == key).map_or(1.0, |(_, hold)| *hold);
            let shear_stiffness = hold * law.shear_stiffness;
            pair.begin(force / size, centres, ContactLaw { shear_stiffness, ..law });
        }
        size > 0.0
    });
    (Reach::Near(None), count)
}

/// Pieces of a block of glued parts on each facet of terrain near it, the surface and its faces `out` (m) further out: a pair for each part and facet,
/// put into `near`, and how many there are.
pub(crate) fn reach_ground_glued(
    under: &mut Under,
    terrain: &Terrain,
    (block, pose): (&Glued, &Pose),
    out: f64,
    law: ContactLaw,
    near: &mut Vec<Pair>,
) -> (Reach, usize) {
    let mut flats = Flats::default();
    let mut slopes: Vec<(u32, Vec3)> = Vec::new();
    let reached = under.find_inflated_glued(terrain, block, pose, out, |treader, on| {
        slopes.push((on.facet, on.slope));
        for (face, frame, polygon) in treader.pieces(on.facet) {
            flats.add(&Face {
                key: [on.piece as u32, on.facet],
                planes: [on.facet, u32::from(on.term.plane(face))],
                faces: [on.slope, on.normals[face]],
                frame,
                shift: on.centre,
                polygon,
                count: on.term.sign,
            });
        }
    });
    match reached {
        Reached::Apart(gap) => return (Reach::Apart(gap), 0),
        Reached::FullyPenetrated(_) => return (Reach::Lost, 0),
        Reached::Touching => {}
    }
    let count = flats.give(near, out, |[_, facet], _, pair| {
        let slope = slopes.iter().find(|(of, _)| *of == facet).map(|(_, slope)| *slope);
        pair.begin(slope.unwrap_or(Vec3::Z).normalize(), [Vec3::ZERO; 2], law);
        true
    });
    (Reach::Near(None), count)
}
