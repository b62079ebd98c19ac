//! A block of convex parts glued face to face, as the contact law sees it.
//!
//! Its depth is the sum with signs of the depths of convex terms ([`riprap_geom::polyhedron::glued`]). The smaller one of two depths is
//! then the sum over all pairs of terms of both blocks, and so are energy, pressure and every integral over the surface of equal
//! pressure: where a term is nearest without being so in the whole, another one with the other sign takes it away, face by face.
//! Each pair of terms is a pair of convex blocks.

use riprap_geom::polyhedron::{GluedError, Polyhedron, glued};
use riprap_geom::{Mat3, Vec3};

use crate::kernel::shape::{Body, Pose, Shape, ShapeError, turn};
use crate::kernel::sums::Sums;
use crate::kernel::surface::{Found, Pair, Walker};

/// A sum of pressures of both signs that is below this share of them is what round-off leaves of nothing.
pub(super) const CANCELLED: f64 = 1e-9;

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
}

impl Term {
    fn new(shape: Shape, centre: Vec3, sign: f64) -> Self {
        let faces = (0..shape.faces() as u16).collect();
        Self { shape, centre, sign, faces }
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

    fn finish(&mut self) {
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
    normals: [Vec<Vec3>; 2],
    first: [Vec<usize>; 2],
    turns: [Mat3; 2],
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
            self.normals[side].clear();
            self.first[side].clear();
            let rotation = placed.poses[side].rotation;
            for term in &placed.blocks[side].terms {
                self.first[side].push(self.normals[side].len());
                self.turns[side] = turn(&term.shape, rotation, &mut self.normals[side]);
            }
        }
    }

    /// Finds what pieces `pieces` of two blocks share and no earlier ones do.
    pub fn find(&mut self, placed: &Placed, pieces: [usize; 2]) -> Touch {
        let Self { walker, other, normals, first, turns } = self;
        let body = |side: usize, number: usize| -> (Body<'_>, &Term) {
            let term = &placed.blocks[side].terms[number];
            let start = first[side][number];
            let own = Body {
                shape: &term.shape,
                normals: &normals[side][start..start + term.shape.faces()],
                turn: turns[side],
                position: placed.poses[side].position + turns[side] * term.centre,
            };
            (own, term)
        };
        let numbers = [0, 1].map(|side| {
            let first = &placed.blocks[side].first;
            first[pieces[side]]..first[pieces[side] + 1]
        });
        let look = |walker: &mut Walker, [m, n]: [usize; 2]| -> (Found, Vec3, f64) {
            let [(a, of_a), (b, of_b)] = [body(0, m), body(1, n)];
            let origin = super::planes::origin(&a, &b);
            let apart = (a.position - b.position).length();
            let gap = apart - (a.shape.radius + b.shape.radius);
            let sign = of_a.sign * of_b.sign;
            // Balls about both tell it without a walk, less what rounding may have added to their distance.
            if gap > 1e-9 * apart {
                return (Found::Apart(gap - 1e-9 * apart), origin, sign);
            }
            let found = walker.find(&Pair {
                bodies: [&a, &b],
                faces: [&of_a.faces, &of_b.faces],
                ties: true,
                hint: None,
                witnesses: &[],
            });
            (found, origin, sign)
        };
        let whole = [numbers[0].start, numbers[1].start];
        let (found, origin, _) = look(walker, whole);
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
                match look(other, [m, n]) {
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
