//! A block of convex parts glued face to face, as the contact law sees it.
//!
//! Its depth is the sum with signs of the depths of convex terms ([`riprap_geom::polyhedron::glued`]). The smaller one of two depths is
//! then the sum over all pairs of terms of both blocks, and so are energy, pressure and every integral over the surface of equal
//! pressure: where a term is nearest without being so in the whole, another one with the other sign takes it away, face by face.
//! Each pair of terms is a pair of convex blocks.

use std::ops::Range;

use riprap_geom::polyhedron::{FLAT, GluedError, Polyhedron, glued};
use riprap_geom::{Mat3, Vec3};

use crate::kernel::shape::{Body, Pose, Shape, ShapeError, turn};
use crate::kernel::sums::Sums;
use crate::kernel::surface::{Found, Pair, Walker};
use crate::kernel::terrain::Reached;

/// A sum of pressures of both signs that is below this share of them is what round-off leaves of nothing.
pub(crate) const CANCELLED: f64 = 1e-9;
/// Faces whose normals differ by more (cosine) are never taken for one plane, however small they are.
const SAME_SIDE: f64 = 0.9;
/// What rounding may add to the distance of two balls, over it.
const ROUNDING: f64 = 1e-9;

/// Why parts take no part in contact.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum PartsError {
    /// They make no solid.
    #[error(transparent)]
    Glued(#[from] GluedError),
    /// A term has no room for a ball.
    #[error(transparent)]
    Shape(#[from] ShapeError),
}

/// A convex term.
#[derive(Clone, Debug, PartialEq)]
pub struct Term {
    /// Its shape about its own centroid, in the frame of the block.
    pub shape: Shape,
    /// Its centroid from that of the block, m.
    pub centre: Vec3,
    /// How often it counts.
    pub sign: f64,
    /// Numbers of all of its faces.
    faces: Vec<u16>,
    /// Number of the plane of each face among all planes of the block.
    planes: Vec<u16>,
}

impl Term {
    fn new(shape: Shape, centre: Vec3, sign: f64) -> Self {
        let faces = (0..shape.faces() as u16).collect();
        Self { shape, centre, sign, faces, planes: Vec::new() }
    }

    /// Number of the plane of a face: terms share planes, since all of them are those of faces of the block.
    #[must_use]
    pub fn plane(&self, face: usize) -> u16 {
        self.planes[face]
    }

    /// Where its frame stands, by that of the block.
    #[must_use]
    pub fn pose(&self, block: &Pose) -> Pose {
        Pose { position: block.place(self.centre), rotation: block.rotation }
    }
}

/// A block by its terms.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Glued {
    /// All terms, piece by piece; the first of each piece is the piece itself.
    pub terms: Vec<Term>,
    /// Where each piece begins; one entry more.
    first: Vec<usize>,
    /// Radius of the largest ball in the thinnest piece, m.
    pub inradius: f64,
    /// Half the surface of all pieces: no contact can have more, m².
    pub half_surface: f64,
    /// Largest face of a piece, m².
    pub largest: f64,
}

impl Glued {
    /// The block of these parts about `centre`.
    ///
    /// # Errors
    /// What is wrong with the parts.
    pub fn new(parts: &[Polyhedron], centre: Vec3) -> Result<Self, PartsError> {
        let mut made = Self::default();
        for term in glued::terms(parts)? {
            if made.first.len() == usize::from(term.piece) {
                made.first.push(made.terms.len());
            }
            let own = term.solid.moments().centroid;
            let shape = Shape::new(&term.solid, own)?;
            made.terms.push(Term::new(shape, own - centre, term.sign));
        }
        made.finish();
        Ok(made)
    }

    /// A convex block.
    #[must_use]
    pub fn convex(shape: &Shape) -> Self {
        let mut made = Self {
            terms: vec![Term::new(shape.clone(), Vec3::ZERO, 1.0)],
            first: vec![0],
            ..Self::default()
        };
        made.finish();
        made
    }

    /// Numbers the planes of the faces of all terms, the largest face of each first: it knows its plane best.
    fn number_planes(&mut self) {
        let faces = self.terms.iter().enumerate().flat_map(|(t, term)| {
            term.shape.areas.iter().enumerate().map(move |(f, area)| (t, f, *area))
        });
        let mut faces: Vec<(usize, usize, f64)> = faces.collect();
        faces.sort_by(|a, b| b.2.total_cmp(&a.2).then((a.0, a.1).cmp(&(b.0, b.1))));
        let reach = |term: &Term| term.centre.length() + term.shape.radius;
        let size = self.terms.iter().map(reach).fold(0.0, f64::max);
        let mut planes: Vec<(Vec3, f64)> = Vec::new();
        for term in &mut self.terms {
            term.planes = vec![0; term.faces.len()];
        }
        for (t, f, _) in faces {
            let term = &self.terms[t];
            let normal = term.shape.normals[f];
            let on = |(n, d): &(Vec3, f64)| {
                let mut corners = term.shape.outline(f).iter();
                let height = |v: &u16| n.dot(term.shape.vertices[usize::from(*v)] + term.centre);
                n.dot(normal) > SAME_SIDE && corners.all(|v| (height(v) - d).abs() <= FLAT * size)
            };
            let known = planes.iter().position(on).unwrap_or_else(|| {
                planes.push((normal, term.shape.offsets[f] + normal.dot(term.centre)));
                planes.len() - 1
            });
            self.terms[t].planes[f] = known as u16;
        }
    }

    fn finish(&mut self) {
        self.number_planes();
        self.first.push(self.terms.len());
        self.inradius = f64::INFINITY;
        for piece in 0..self.pieces() {
            let shape = &self.terms[self.first[piece]].shape;
            self.inradius = self.inradius.min(shape.inradius);
            self.half_surface += 0.5 * shape.areas.iter().sum::<f64>();
            self.largest = shape.areas.iter().copied().fold(self.largest, f64::max);
        }
    }

    /// Whether it is one convex block.
    #[must_use]
    pub fn is_convex(&self) -> bool {
        self.terms.len() == 1
    }

    /// Number of pieces.
    #[must_use]
    pub fn pieces(&self) -> usize {
        self.first.len() - 1
    }

    /// A piece and what it has in common with earlier ones.
    #[must_use]
    pub fn piece(&self, piece: usize) -> &[Term] {
        &self.terms[self.first[piece]..self.first[piece + 1]]
    }

    /// The convex pieces themselves.
    pub fn convex_pieces(&self) -> impl Iterator<Item = &Term> {
        (0..self.pieces()).map(|piece| &self.piece(piece)[0])
    }
}

/// What was found of a pair of pieces.
#[expect(
    clippy::large_enum_variant,
    reason = "it lives on the stack of one evaluation; a box would take memory in every step"
)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Touch {
    /// They do not touch; at least so far apart, m.
    Apart(f64),
    /// They overlap, but earlier pieces of the blocks have all of it.
    Covered,
    /// They overlap: the sums over their own share of the surface, about the origin in space, m.
    Touching(Sums, Vec3),
    /// One lies in the other so deep that no force can be given; radius of the largest ball in both, m.
    FullyPenetrated(f64),
}

/// Workspace for evaluating pairs one after the other.
#[derive(Clone, Debug, Default)]
pub struct Gluer {
    /// Walks over the surface of the pieces themselves: the largest part of the pair of pieces evaluated last is in it.
    pub walker: Walker,
    /// Walks over what they have in common with earlier ones.
    pub other: Walker,
    turned: Turned,
}

/// The terms of two blocks, turned into space.
#[derive(Clone, Debug, Default)]
struct Turned {
    normals: [Vec<Vec3>; 2],
    first: [Vec<usize>; 2],
    turns: [Mat3; 2],
}

/// Two terms that have a surface with their faces further out: their pieces are those that the walker has kept.
pub(crate) struct Shown<'a> {
    /// Numbers of the pieces of the blocks that they belong to.
    pub pieces: [usize; 2],
    /// The terms.
    pub terms: [&'a Term; 2],
    /// Whether they are these pieces themselves.
    pub leads: bool,
    /// Sums over their surface.
    pub sums: &'a Sums,
    /// Origin of their planes in space, m.
    pub origin: Vec3,
}

/// Two blocks where they are.
#[derive(Clone, Copy, Debug)]
pub struct Placed<'a> {
    /// Their terms.
    pub blocks: [&'a Glued; 2],
    /// Where they stand.
    pub poses: [Pose; 2],
}

impl Gluer {
    /// Turns the terms of two blocks to where they are; comes before their pieces are looked at.
    pub fn place(&mut self, placed: &Placed) {
        for side in 0..2 {
            let Turned { normals, first, turns } = &mut self.turned;
            normals[side].clear();
            first[side].clear();
            let rotation = placed.poses[side].rotation;
            for term in &placed.blocks[side].terms {
                first[side].push(normals[side].len());
                turns[side] = turn(&term.shape, rotation, &mut normals[side]);
            }
        }
    }

    /// Shows the terms of two blocks that have a surface with all faces `by` (m) further out, piece by piece; what is known of the blocks. Where pieces
    /// have none, their common parts have none.
    pub(crate) fn find_inflated(
        &mut self,
        placed: &Placed,
        by: f64,
        mut each: impl FnMut(&mut Walker, &Shown),
    ) -> Reached {
        let (mut gap, mut touching) = (f64::INFINITY, false);
        for a in 0..placed.blocks[0].pieces() {
            for b in 0..placed.blocks[1].pieces() {
                let numbers = placed.numbers([a, b]);
                let whole = [numbers[0].start, numbers[1].start];
                let all = numbers[0].clone().flat_map(|m| numbers[1].clone().map(move |n| [m, n]));
                for of in all {
                    let (found, origin, _) =
                        self.turned.look(placed, &mut self.walker, of, Some(by));
                    match found {
                        Found::Apart(found) if of == whole => {
                            gap = gap.min(found);
                            break;
                        }
                        Found::Apart(_) => {}
                        Found::FullyPenetrated(radius) => return Reached::FullyPenetrated(radius),
                        Found::Touching(sums) => {
                            touching = true;
                            let terms = [0, 1].map(|side| &placed.blocks[side].terms[of[side]]);
                            let (pieces, leads) = ([a, b], of == whole);
                            let sums = &sums;
                            each(&mut self.walker, &Shown { pieces, terms, leads, sums, origin });
                        }
                    }
                }
            }
        }
        if touching { Reached::Touching } else { Reached::Apart(gap) }
    }

    /// Finds what pieces `pieces` of two blocks share and no earlier ones do.
    pub fn find(&mut self, placed: &Placed, pieces: [usize; 2]) -> Touch {
        let Self { walker, other, turned } = self;
        let numbers = placed.numbers(pieces);
        let whole = [numbers[0].start, numbers[1].start];
        let (found, origin, _) = turned.look(placed, walker, whole, None);
        let mut sums = match found {
            Found::Apart(gap) => return Touch::Apart(gap),
            Found::FullyPenetrated(radius) => return Touch::FullyPenetrated(radius),
            Found::Touching(sums) => sums,
        };
        let mut all = sums.weight;
        for m in numbers[0].clone() {
            for n in numbers[1].clone() {
                if [m, n] == whole {
                    continue;
                }
                match turned.look(placed, other, [m, n], None) {
                    (Found::Apart(_), ..) => {}
                    (Found::FullyPenetrated(radius), ..) => return Touch::FullyPenetrated(radius),
                    (Found::Touching(own), at, sign) => {
                        all += sign.abs() * own.weight;
                        sums.plus(&own, sign, at - origin);
                    }
                }
            }
        }
        if sums.weight <= CANCELLED * all {
            return Touch::Covered;
        }
        Touch::Touching(sums, origin)
    }
}

impl Placed<'_> {
    /// Numbers of the terms of these pieces.
    fn numbers(&self, pieces: [usize; 2]) -> [Range<usize>; 2] {
        [0, 1].map(|side| {
            let first = &self.blocks[side].first;
            first[pieces[side]]..first[pieces[side] + 1]
        })
    }
}

impl Turned {
    fn body<'a>(&'a self, placed: &Placed<'a>, side: usize, number: usize) -> (Body<'a>, &'a Term) {
        let term = &placed.blocks[side].terms[number];
        let start = self.first[side][number];
        let own = Body {
            shape: &term.shape,
            normals: &self.normals[side][start..start + term.shape.faces()],
            turn: self.turns[side],
            position: placed.poses[side].position + self.turns[side] * term.centre,
        };
        (own, term)
    }

    /// What two terms share, where their planes are counted from, and the sign of both. `out`: with faces so far further out, m.
    fn look(
        &self,
        placed: &Placed,
        walker: &mut Walker,
        [m, n]: [usize; 2],
        out: Option<f64>,
    ) -> (Found, Vec3, f64) {
        let [(a, of_a), (b, of_b)] = [self.body(placed, 0, m), self.body(placed, 1, n)];
        let origin = super::planes::origin(&a, &b);
        let apart = (a.position - b.position).length();
        let gap = apart - (a.shape.radius + b.shape.radius);
        let sign = of_a.sign * of_b.sign;
        let beside = 2.0 * out.unwrap_or(0.0);
        // Balls about both tell it without a walk, less what rounding may have added to their distance.
        if gap - beside > ROUNDING * apart {
            return (Found::Apart(gap - ROUNDING * apart), origin, sign);
        }
        let pair = Pair {
            bodies: [&a, &b],
            faces: [&of_a.faces, &of_b.faces],
            ties: true,
            hint: None,
            covered: [0; 2],
            witnesses: &[],
        };
        let found = match out {
            None => walker.find(&pair),
            Some(by) => match walker.find_inflated(&pair, by) {
                Found::Apart(gap) => Found::Apart(gap + beside),
                found => found,
            },
        };
        (found, origin, sign)
    }
}
