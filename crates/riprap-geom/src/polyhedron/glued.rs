//! Solids that are not convex, as convex parts glued face to face.
//!
//! The depth of a point in a glued solid must not know the glued faces. Each part is a set of half spaces; where two parts share a
//! piece of a face, the half spaces of both without the shared plane make a convex piece that bridges it and lies in both. Bridging
//! until nothing new comes makes the largest convex pieces `K` of these planes, which overlap each other. With `phi_K` the depth below the faces of
//! one of them, `phi = max phi_K` is continuous, nil on the true surface alone and, where the solid is convex, its own depth.
//!
//! The larger one of several numbers is a sum with signs of the smaller ones of them, `max(a, b) = a + b - min(a, b)` and so on,
//! and the smaller one of two depths is that in the common part of two pieces. So `phi = sum_T s_T phi_T` over convex *terms* `T`, pieces and their
//! common parts, with whole numbers `s_T`; and so for whatever is linear over the surface of equal depth of two such solids.
//!
//! Source: bridging is the consensus of Quine (1955) for products of half spaces; the sum is inclusion and exclusion.

use std::collections::BTreeSet;

use super::{FLAT, Polyhedron, Sliced, SolidError, from_half_spaces, hull, slice};
use crate::Vec3;

/// Most parts: all pairs of them are looked at.
const MOST_PARTS: usize = 256;
/// Most faces of all parts together: planes are counted in 16 bits.
const MOST_FACES: usize = 10_000;
/// Most convex pieces.
const MOST_PIECES: usize = 64;
/// Most terms.
const MOST_TERMS: usize = 512;
/// Common volume from which two parts overlap, over the volume of the smaller one.
const OVERLAP: f64 = 1e-6;
/// Volume of a piece or term that is lost in round-off, over the volume of all parts.
const NOTHING: f64 = 1e-10;
/// Largest error of the volume of all terms together, over the volume of all parts.
const SURE: f64 = 1e-6;
/// Volume of the hull that the parts do not fill, over theirs, up to which they are convex in sum.
const CONVEX: f64 = 1e-9;
/// Faces whose normals differ by more (cosine) are never taken for one plane, however small they are.
const SAME_PLANE: f64 = 0.9;

/// Why parts make no solid. Parts are counted from 0.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum GluedError {
    /// There are no parts, or more than can be looked at pair by pair.
    #[error(
        "it has {parts} parts with {faces} faces; there must be 1 to {} with at most {}",
        MOST_PARTS,
        MOST_FACES
    )]
    Count {
        /// Number of parts.
        parts: usize,
        /// Number of faces of all parts.
        faces: usize,
    },
    /// A part is no convex solid.
    #[error("part {}: {error}", part + 1)]
    Part {
        /// The part.
        part: usize,
        /// What is wrong with it.
        error: SolidError,
    },
    /// Two parts share volume.
    #[error("parts {} and {} overlap by {volume:.3e} m3", parts[0] + 1, parts[1] + 1)]
    Overlap {
        /// The parts.
        parts: [usize; 2],
        /// Their common volume, m³.
        volume: f64,
    },
    /// It is not one piece.
    #[error("parts {} and {} are not connected: they share no face, directly or through other parts", parts[0] + 1, parts[1] + 1)]
    Apart {
        /// Two parts that nothing joins.
        parts: [usize; 2],
    },
    /// There are too many convex pieces.
    #[error(
        "its {parts} parts give more than {} convex pieces or {} terms",
        MOST_PIECES,
        MOST_TERMS
    )]
    TooMany {
        /// Number of parts.
        parts: usize,
    },
    /// The terms do not add up to the parts.
    #[error("its convex pieces fill {found:.6e} m3, the parts {meant:.6e} m3")]
    Unsure {
        /// Volume of the terms, m³.
        found: f64,
        /// Volume of the parts, m³.
        meant: f64,
    },
}

/// A convex term of a glued solid.
#[derive(Clone, Debug, PartialEq)]
pub struct Term {
    /// Where it is.
    pub solid: Polyhedron,
    /// How often it counts.
    pub sign: f64,
    /// The piece that it belongs to: the piece itself comes first and counts once, what it has in common with earlier ones after it.
    pub piece: u16,
}

/// A side of a plane: its place in the table, and whether the solid lies where `normal . x >= offset`.
type Side = (u16, bool);

/// A convex set by the planes that bound it.
#[derive(Clone, Debug, PartialEq)]
struct Convex {
    sides: BTreeSet<Side>,
    solid: Polyhedron,
    volume: f64,
}

/// All planes of the parts, about their middle.
struct Table {
    planes: Vec<(Vec3, f64)>,
    middle: Vec3,
    size: f64,
    /// Volume of all parts, m³.
    whole: f64,
}

/// The convex terms of parts that touch each other by faces, by piece.
///
/// # Errors
/// No parts or too many; a part that is not convex, two that overlap, two that nothing joins; too many pieces.
///
/// # Examples
///
/// ```
/// use riprap_geom::Vec3;
/// use riprap_geom::polyhedron::{Polyhedron, glued};
///
/// // An L: two cubes on the ground, one on top of the first.
/// let cube = |x: f64, z: f64| Polyhedron::brick(Vec3::new(x, 0.0, z), Vec3::splat(0.5));
/// let terms = glued::terms(&[cube(0.0, 0.0), cube(1.0, 0.0), cube(0.0, 1.0)])?;
/// // Two bars of two cubes, less the cube that both have.
/// let signs: Vec<f64> = terms.iter().map(|t| t.sign).collect();
/// assert_eq!(signs, [1.0, 1.0, -1.0]);
/// # Ok::<(), glued::GluedError>(())
/// ```
pub fn terms(parts: &[Polyhedron]) -> Result<Vec<Term>, GluedError> {
    let faces = parts.iter().map(|part| part.faces.len()).sum();
    if parts.is_empty() || parts.len() > MOST_PARTS || faces > MOST_FACES {
        let parts = parts.len();
        return Err(GluedError::Count { parts, faces });
    }
    for (part, solid) in parts.iter().enumerate() {
        let checked = solid.validate();
        checked.map_err(|error| GluedError::Part { part, error })?;
    }
    let (table, parts_of_planes) = Table::of(parts);
    let convex = table.check(&parts_of_planes)?;
    let bridged = table.bridged(convex, parts.len());
    if bridged.as_ref().is_ok_and(|terms| terms.len() == 1) {
        return bridged;
    }
    match table.convex_whole(parts) {
        Some(solid) => {
            let (sign, piece) = (1.0, 0);
            Ok(vec![Term { solid, sign, piece }])
        }
        None => bridged,
    }
}

impl Table {
    /// The terms of convex sets, bridged.
    fn bridged(&self, convex: Vec<Convex>, parts: usize) -> Result<Vec<Term>, GluedError> {
        let too_many = GluedError::TooMany { parts };
        let pieces = self.pieces(convex).ok_or(too_many.clone())?;
        let terms = self.terms(pieces).ok_or(too_many)?;
        let found: f64 = terms.iter().map(|t| t.sign * t.solid.moments().volume).sum();
        let meant = self.whole;
        if (found - meant).abs() > SURE * meant {
            return Err(GluedError::Unsure { found, meant });
        }
        Ok(terms)
    }

    /// The hull of all parts where they fill it: bridging comes to the same, but where there are many parts by way of more pieces than can
    /// be looked at.
    fn convex_whole(&self, parts: &[Polyhedron]) -> Option<Polyhedron> {
        // Faces cut in two would else come out as two faces, a little askew: rounding to the table's precision joins their corners.
        let mut corners: Vec<Vec3> = Vec::new();
        for corner in parts.iter().flat_map(|part| &part.vertices) {
            let known = |at: &Vec3| at.distance(*corner) <= FLAT * self.size;
            if !corners.iter().any(known) {
                corners.push(*corner);
            }
        }
        let whole = hull(&corners).ok()?;
        let volume = whole.moments().volume;
        ((volume - self.whole).abs() <= CONVEX * self.whole).then_some(whole)
    }

    /// The planes of all faces, those in one plane only once, and the sides of each part.
    fn of(parts: &[Polyhedron]) -> (Self, Vec<BTreeSet<Side>>) {
        let start = (Vec3::INFINITY, Vec3::NEG_INFINITY);
        let (low, high) = (parts.iter().map(Polyhedron::bounds))
            .fold(start, |(low, high), (min, max)| (low.min(min), high.max(max)));
        let mut table = Self {
            planes: Vec::new(),
            middle: 0.5 * (low + high),
            size: (high - low).length(),
            whole: parts.iter().map(|p| p.moments().volume).sum(),
        };
        // Large faces first: they know their plane best.
        let mut faces: Vec<(usize, usize, f64)> = Vec::new();
        for (p, part) in parts.iter().enumerate() {
            let areas = (0..part.faces.len()).map(|f| part.area_vector(f).length());
            faces.extend(areas.enumerate().map(|(f, area)| (p, f, area)));
        }
        faces.sort_by(|a, b| b.2.total_cmp(&a.2).then((a.0, a.1).cmp(&(b.0, b.1))));
        let mut sides = vec![BTreeSet::new(); parts.len()];
        for (p, f, _) in faces {
            let (normal, offset) = parts[p].plane(f);
            let near = |(n, d): &(Vec3, f64)| {
                let mut corners = parts[p].faces[f].iter().map(|v| parts[p].vertices[*v as usize]);
                n.dot(normal).abs() > SAME_PLANE
                    && corners.all(|at| (n.dot(at - table.middle) - d).abs() <= FLAT * table.size)
            };
            let known = table.planes.iter().position(near).unwrap_or_else(|| {
                table.planes.push((normal, offset - normal.dot(table.middle)));
                table.planes.len() - 1
            });
            let above = table.planes[known].0.dot(normal) < 0.0;
            sides[p].insert((known as u16, above));
        }
        (table, sides)
    }

    /// The convex set that these sides have in common, without those that bound nothing; `None` where they have no volume in common.
    fn common(&self, sides: &BTreeSet<Side>) -> Option<Convex> {
        if sides.iter().any(|&(plane, above)| sides.contains(&(plane, !above))) {
            return None;
        }
        let half_space = |&(plane, above): &Side| {
            let (n, d) = self.planes[plane as usize];
            if above { (-n, -d) } else { (n, d) }
        };
        let planes: Vec<(Vec3, f64)> = sides.iter().map(half_space).collect();
        let mut solid = from_half_spaces(&planes, self.size).ok()?;
        let volume = solid.moments().volume;
        if volume.is_nan() || volume <= NOTHING * self.whole {
            return None;
        }
        let on = |face: &Vec<u32>, (n, d): &(Vec3, f64)| -> f64 {
            let heights = face.iter().map(|v| (n.dot(solid.vertices[*v as usize]) - d).abs());
            heights.fold(0.0, f64::max)
        };
        let bounding: BTreeSet<usize> = (solid.faces.iter())
            .filter_map(|face| {
                let of = |k: &usize| on(face, &planes[*k]);
                (0..planes.len()).min_by(|a, b| of(a).total_cmp(&of(b)))
            })
            .collect();
        let sides = (sides.iter().enumerate())
            .filter(|(k, _)| bounding.contains(k))
            .map(|(_, side)| *side)
            .collect();
        solid.vertices.iter_mut().for_each(|v| *v += self.middle);
        Some(Convex { sides, solid, volume })
    }

    /// The parts as convex sets; none overlap, and all hang together.
    fn check(&self, parts: &[BTreeSet<Side>]) -> Result<Vec<Convex>, GluedError> {
        let mut convex = Vec::with_capacity(parts.len());
        for (part, sides) in parts.iter().enumerate() {
            let error = SolidError::ZeroVolume { volume: 0.0 };
            convex.push(self.common(sides).ok_or(GluedError::Part { part, error })?);
        }
        let mut root: Vec<usize> = (0..parts.len()).collect();
        for i in 0..parts.len() {
            for j in i + 1..parts.len() {
                let both: BTreeSet<Side> = parts[i].union(&parts[j]).copied().collect();
                let least = convex[i].volume.min(convex[j].volume);
                if let Some(common) = self.common(&both)
                    && common.volume > OVERLAP * least
                {
                    let volume = common.volume;
                    let parts = [i, j];
                    return Err(GluedError::Overlap { parts, volume });
                }
                if !self.bridges(&convex[i], &convex[j]).is_empty() {
                    let (from, to) = (root[i].max(root[j]), root[i].min(root[j]));
                    root.iter_mut().filter(|r| **r == from).for_each(|r| *r = to);
                }
            }
        }
        if let Some(other) = root.iter().position(|r| *r != 0) {
            return Err(GluedError::Apart { parts: [0, other] });
        }
        Ok(convex)
    }

    /// The convex sets that lie in both of two sets that touch from either side of a plane, and reach across it.
    fn bridges(&self, a: &Convex, b: &Convex) -> Vec<Convex> {
        let mut found = Vec::new();
        for &(plane, above) in &a.sides {
            if !b.sides.contains(&(plane, !above)) {
                continue;
            }
            let all = a.sides.union(&b.sides).copied();
            let sides: BTreeSet<Side> = all.filter(|side| side.0 != plane).collect();
            let Some(bridge) = self.common(&sides) else {
                continue;
            };
            let (n, d) = self.planes[plane as usize];
            let Sliced::Part(below) = slice(&bridge.solid, n, d + n.dot(self.middle)) else {
                continue;
            };
            let share = below.moments().volume;
            let least = NOTHING * self.whole;
            if share > least && bridge.volume - share > least {
                found.push(bridge);
            }
        }
        found
    }

    /// Whether one set lies in another.
    fn within(&self, inner: &Convex, outer: &Convex) -> bool {
        outer.sides.iter().all(|&(plane, above)| {
            let (n, d) = self.planes[plane as usize];
            let mut heights = (inner.solid.vertices.iter()).map(|v| n.dot(*v - self.middle) - d);
            heights.all(|h| if above { -h } else { h } <= FLAT * self.size)
        })
    }

    /// The largest convex pieces, the largest first; `None` where there are too many.
    fn pieces(&self, mut pieces: Vec<Convex>) -> Option<Vec<Convex>> {
        // Pairs of pieces already looked at, by the sides of both.
        let mut looked: BTreeSet<(BTreeSet<Side>, BTreeSet<Side>)> = BTreeSet::new();
        loop {
            let mut new = Vec::new();
            for i in 0..pieces.len() {
                for j in i + 1..pieces.len() {
                    let pair = (pieces[i].sides.clone(), pieces[j].sides.clone());
                    if looked.insert(pair) {
                        new.extend(self.bridges(&pieces[i], &pieces[j]));
                    }
                }
            }
            let mut grown = false;
            for bridge in new {
                if pieces.iter().any(|piece| self.within(&bridge, piece)) {
                    continue;
                }
                // What lies in a larger one is nowhere deeper than that.
                pieces.retain(|piece| !self.within(piece, &bridge));
                pieces.push(bridge);
                grown = true;
            }
            if pieces.len() > MOST_PIECES {
                return None;
            }
            if !grown {
                break;
            }
        }
        pieces.sort_by(|a, b| b.volume.total_cmp(&a.volume).then(a.sides.cmp(&b.sides)));
        Some(pieces)
    }

    /// The terms, piece by piece; `None` where there are too many.
    fn terms(&self, pieces: Vec<Convex>) -> Option<Vec<Term>> {
        let mut terms: Vec<Term> = Vec::new();
        // All terms of the pieces so far, equal ones added up.
        let mut all: Vec<(Convex, f64)> = Vec::new();
        let add = |list: &mut Vec<(Convex, f64)>, convex: Convex, sign: f64| match list
            .iter_mut()
            .find(|(known, _)| known.sides == convex.sides)
        {
            Some((_, count)) => *count += sign,
            None => list.push((convex, sign)),
        };
        for (number, piece) in pieces.into_iter().enumerate() {
            let mut own = vec![(piece.clone(), 1.0)];
            for (term, sign) in &all {
                let sides = term.sides.union(&piece.sides).copied().collect();
                if let Some(common) = self.common(&sides) {
                    // What it has in common with the terms so far would count twice: max(a, b) = a + b - min(a, b).
                    add(&mut own, common, -sign);
                }
            }
            own.retain(|(_, sign)| *sign != 0.0);
            for (convex, sign) in own {
                terms.push(Term { solid: convex.solid.clone(), sign, piece: number as u16 });
                add(&mut all, convex, sign);
            }
            all.retain(|(_, sign)| *sign != 0.0);
            if terms.len() > MOST_TERMS {
                return None;
            }
        }
        Some(terms)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn brick(low: [f64; 3], high: [f64; 3]) -> Polyhedron {
        let (low, high) = (Vec3::from(low), Vec3::from(high));
        Polyhedron::brick(0.5 * (low + high), 0.5 * (high - low))
    }

    /// Depth in a convex solid, below 0 outside.
    fn depth(solid: &Polyhedron, at: Vec3) -> f64 {
        let depths = (0..solid.faces.len()).map(|f| {
            let (n, d) = solid.plane(f);
            d - n.dot(at)
        });
        depths.fold(f64::INFINITY, f64::min)
    }

    /// Depth by the terms.
    fn field(terms: &[Term], at: Vec3) -> f64 {
        let shares = terms.iter().map(|t| t.sign * depth(&t.solid, at).max(0.0));
        shares.sum()
    }

    #[test]
    fn no_parts_and_too_many_are_refused() {
        let count = |parts: usize, faces: usize| Err(GluedError::Count { parts, faces });
        assert_eq!(terms(&[]), count(0, 0));
        let row: Vec<Polyhedron> = (0..257u32)
            .map(|k| brick([f64::from(k), 0.0, 0.0], [f64::from(k) + 1.0, 1.0, 1.0]))
            .collect();
        assert_eq!(terms(&row), count(257, 6 * 257));
        // Not for their number: bridged two by two they are too many pieces on the way. A plain bar needs no bridge.
        let parts = 256;
        assert_eq!(terms(&row[..256]).unwrap().len(), 1);
        let mut stepped = row[..255].to_vec();
        stepped.push(brick([100.0, 0.0, 1.0], [101.0, 1.0, 2.0]));
        assert_eq!(terms(&stepped), Err(GluedError::TooMany { parts }));
    }

    #[test]
    fn many_parts_that_are_convex_in_sum_are_one_solid() {
        // 64 cubes of a large one, and a brick of six tetrahedra, of which no two make a convex solid with a third one.
        let mut cubes = Vec::new();
        for k in 0..64u32 {
            let low = [k % 4, k / 4 % 4, k / 16].map(f64::from);
            cubes.push(brick(low, low.map(|x| x + 1.0)));
        }
        let whole = terms(&cubes).unwrap();
        assert_eq!(whole.len(), 1);
        assert_eq!((whole[0].solid.faces.len(), whole[0].solid.vertices.len()), (6, 8));
        let corner =
            |k: usize| Vec3::new((k & 1) as f64, (k >> 1 & 1) as f64 * 2.0, (k >> 2) as f64);
        let paths = [[1, 3], [1, 5], [2, 3], [2, 6], [4, 5], [4, 6]];
        let tetrahedra = paths.map(|[a, b]| hull(&[0, a, b, 7].map(corner)).unwrap());
        let whole = terms(&tetrahedra).unwrap();
        assert_eq!((whole.len(), whole[0].solid.faces.len()), (1, 6));
        assert!((whole[0].solid.moments().volume - 2.0).abs() < 1e-14);
        // Without one of them it is not convex.
        assert!(terms(&tetrahedra[..5]).unwrap().len() > 1);
    }

    #[test]
    fn halves_of_a_brick_are_the_brick() {
        let halves =
            [brick([0.0, 0.0, 0.0], [1.0, 1.0, 1.0]), brick([1.0, 0.0, 0.0], [3.0, 1.0, 1.0])];
        let terms = terms(&halves).unwrap();
        assert_eq!(terms.len(), 1);
        let moments = terms[0].solid.moments();
        assert!((moments.volume - 3.0).abs() < 1e-14 && terms[0].solid.faces.len() == 6);
    }

    #[test]
    fn four_quarters_about_an_edge_are_the_brick() {
        let quarter = |x: f64, y: f64| brick([x, y, 0.0], [x + 1.0, y + 1.0, 1.0]);
        let quarters = [quarter(0.0, 0.0), quarter(1.0, 0.0), quarter(1.0, 1.0), quarter(0.0, 1.0)];
        let terms = terms(&quarters).unwrap();
        assert_eq!(terms.len(), 1);
        assert!((terms[0].solid.moments().volume - 4.0).abs() < 1e-14);
    }

    #[test]
    fn the_depth_of_an_l_knows_no_glued_face() {
        let l = [brick([0.0, 0.0, 0.0], [3.0, 1.0, 1.0]), brick([0.0, 0.0, 1.0], [1.0, 1.0, 3.0])];
        let terms = terms(&l).unwrap();
        assert_eq!(terms.len(), 3);
        // In the plane y = 1/2 the depth is min(x, z, 3 - x, 3 - z, 1/2, max(1 - x, 1 - z)).
        for i in 0..60 {
            for k in 0..60 {
                let (x, z) = (0.05 * f64::from(i) + 0.013, 0.05 * f64::from(k) + 0.021);
                let exact = (x.min(z).min(3.0 - x).min(3.0 - z).min(0.5))
                    .min((1.0 - x).max(1.0 - z))
                    .max(0.0);
                let found = field(&terms, Vec3::new(x, 0.5, z));
                assert!((found - exact).abs() < 1e-14, "{x} {z}: {found} {exact}");
            }
        }
    }

    #[test]
    fn bricks_in_a_bond_carry_across_their_joint() {
        // Neither glued face is the whole of a face.
        let bond =
            [brick([0.0, 0.0, 0.0], [2.0, 1.0, 1.0]), brick([1.0, 0.0, 1.0], [3.0, 1.0, 2.0])];
        let terms = terms(&bond).unwrap();
        assert_eq!(terms.iter().filter(|t| t.sign > 0.0).count(), 3);
        let at = Vec3::new(1.5, 0.4, 1.0);
        assert!((field(&terms, at) - 0.4).abs() < 1e-14);
        assert_eq!(field(&terms, Vec3::new(0.5, 0.5, 1.0)), 0.0);
    }

    #[test]
    fn a_table_has_a_plate_and_four_legs() {
        let mut parts = vec![brick([0.0, 0.0, 1.0], [3.0, 2.0, 1.2])];
        for (x, y) in [(0.0, 0.0), (2.8, 0.0), (0.0, 1.8), (2.8, 1.8)] {
            parts.push(brick([x, y, 0.0], [x + 0.2, y + 0.2, 1.0]));
        }
        let terms = terms(&parts).unwrap();
        let signs: Vec<f64> = terms.iter().map(|t| t.sign).collect();
        assert_eq!(signs, [1.0, 1.0, -1.0, 1.0, -1.0, 1.0, -1.0, 1.0, -1.0]);
        assert!((field(&terms, Vec3::new(0.1, 0.1, 1.0)) - 0.1).abs() < 1e-14);
    }

    #[test]
    fn what_is_no_solid_is_refused_by_its_parts() {
        let unit = brick([0.0; 3], [1.0; 3]);
        let inside = brick([0.5, 0.0, 0.0], [1.5, 1.0, 1.0]);
        let error = terms(&[unit.clone(), inside]).unwrap_err();
        assert!(error.to_string().starts_with("parts 1 and 2 overlap by 5.000e-1"), "{error}");
        // An edge is no face.
        let beside = brick([1.0, 1.0, 0.0], [2.0, 2.0, 1.0]);
        let error = terms(&[unit.clone(), beside]).unwrap_err();
        assert_eq!(error, GluedError::Apart { parts: [0, 1] });
        let flat = Polyhedron::brick(Vec3::ZERO, Vec3::new(1.0, 1.0, 0.0));
        assert!(matches!(terms(&[unit, flat]), Err(GluedError::Part { part: 1, .. })));
    }
}
