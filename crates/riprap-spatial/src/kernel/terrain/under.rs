//! What lies under a block, convex or of glued parts.
//!
//! The smaller one of two depths is linear over the signed terms of a block of glued parts (see [`crate::kernel::glued`]), whatever the other depth
//! is: so is the surface on each facet of terrain. Each piece has springs of its own on each facet, with what it has there and no earlier piece does.

use riprap_geom::Vec3;

use crate::kernel::frame::Frame;
use crate::kernel::glued::{CANCELLED, Glued, Term};
use crate::kernel::piece::Polygon;
use crate::kernel::shape::{Body, Pose, turn};
use crate::kernel::sums::Sums;
use crate::kernel::terrain::{OnFacet, Reached, Terrain, Treader};
use crate::lanes::Width;

/// Workspace for evaluating blocks one after the other; kept, so that a block takes no memory.
#[derive(Clone, Debug, Default)]
pub struct Under {
    /// What the block evaluated last has on each facet: by piece, then by number.
    pub facets: Vec<OnFacet>,
    /// One for each piece; a convex block has one piece.
    treaders: Vec<Treader>,
    /// Centres of the pieces from the centroid of the block, m.
    centres: Vec<Vec3>,
    /// For what a piece has in common with earlier ones.
    common: Treader,
    normals: Vec<Vec3>,
    /// How fast pressures grow beyond the depth, 1/m².
    growth: f64,
    width: Width,
}

/// What a term of a block of glued parts has on a facet.
pub(crate) struct Trodden<'a> {
    /// Number of the piece of the block that it belongs to.
    pub piece: usize,
    pub facet: u32,
    /// Depth below the facet over the way.
    pub slope: Vec3,
    pub term: &'a Term,
    /// Normals of its faces in space.
    pub normals: &'a [Vec3],
    /// Its centroid from that of the block, m.
    pub centre: Vec3,
}

impl Under {
    /// Uses no wider instructions than `width` from now on.
    pub fn limit_width(&mut self, width: Width) {
        self.width = width;
        for treader in self.treaders.iter_mut().chain([&mut self.common]) {
            treader.cutter.limit_width(width);
        }
    }

    /// Lets pressures grow beyond the depth so fast (1/m²) from now on.
    pub fn stiffen(&mut self, growth: f64) {
        self.growth = growth;
    }

    fn begin(&mut self, pieces: usize) {
        self.facets.clear();
        self.centres.clear();
        while self.treaders.len() < pieces {
            let mut treader = Treader::default();
            treader.cutter.limit_width(self.width);
            self.treaders.push(treader);
        }
        for treader in self.treaders.iter_mut().chain([&mut self.common]) {
            treader.growth = self.growth;
        }
    }

    /// Finds the surface of a convex block. Of what is apart, nothing farther than `reach` times its radius is looked at.
    pub fn find(&mut self, terrain: &Terrain, body: &Body, reach: f64) -> Reached {
        self.begin(1);
        self.centres.push(Vec3::ZERO);
        let reached = self.treaders[0].find(terrain, body, reach * body.shape.radius);
        self.facets.extend_from_slice(&self.treaders[0].facets);
        reached
    }

    /// As [`Under::find`] for a convex block and what lies within its radius, with the surface and all faces `by` (m) further out.
    pub(crate) fn find_inflated(&mut self, terrain: &Terrain, body: &Body, by: f64) -> Reached {
        self.begin(1);
        self.centres.push(Vec3::ZERO);
        let reached = self.treaders[0].find_inflated(terrain, body, body.shape.radius + by, by);
        self.facets.extend_from_slice(&self.treaders[0].facets);
        reached
    }

    /// The same of a block of glued parts: shows what each of its terms has on each facet, piece by piece.
    pub(crate) fn find_inflated_glued(
        &mut self,
        terrain: &Terrain,
        block: &Glued,
        pose: &Pose,
        by: f64,
        mut each: impl FnMut(&Treader, &Trodden),
    ) -> Reached {
        self.begin(block.pieces());
        let mut nearest = f64::INFINITY;
        for piece in 0..block.pieces() {
            for (k, term) in block.piece(piece).iter().enumerate() {
                let (body, centre) = place(term, pose, &mut self.normals);
                let treader = &mut self.common;
                match treader.find_inflated(terrain, &body, body.shape.radius + by, by) {
                    Reached::Apart(gap) if k == 0 => {
                        nearest = nearest.min(gap);
                        break;
                    }
                    Reached::Apart(_) => {}
                    Reached::FullyPenetrated(depth) => return Reached::FullyPenetrated(depth),
                    Reached::Touching => {
                        nearest = 0.0;
                        let normals = body.normals;
                        for on in &treader.facets {
                            let (facet, slope) = (on.facet, on.slope);
                            each(treader, &Trodden { piece, facet, slope, term, normals, centre });
                        }
                    }
                }
            }
        }
        if nearest > 0.0 { Reached::Apart(nearest) } else { Reached::Touching }
    }

    /// The pieces of a convex block on a facet: its face, the plane and the polygon.
    pub(crate) fn pieces(&self, facet: u32) -> impl Iterator<Item = (usize, &Frame, &Polygon)> {
        self.treaders[0].pieces(facet)
    }

    /// The same for a block of glued parts.
    pub fn find_glued(
        &mut self,
        terrain: &Terrain,
        block: &Glued,
        pose: &Pose,
        reach: f64,
    ) -> Reached {
        self.begin(block.pieces());
        let mut nearest = f64::INFINITY;
        for piece in 0..block.pieces() {
            let first = self.facets.len();
            for (k, term) in block.piece(piece).iter().enumerate() {
                let (body, centre) = place(term, pose, &mut self.normals);
                let treader = if k == 0 {
                    self.centres.push(centre);
                    &mut self.treaders[piece]
                } else {
                    &mut self.common
                };
                match treader.find(terrain, &body, reach * body.shape.radius) {
                    Reached::Apart(gap) => {
                        if k == 0 {
                            nearest = nearest.min(gap);
                            // So is all that it has in common with others.
                            break;
                        }
                    }
                    Reached::FullyPenetrated(depth) => return Reached::FullyPenetrated(depth),
                    Reached::Touching => {
                        nearest = 0.0;
                        let facets = treader.facets.iter();
                        let own = facets.map(|on| about_block(on, piece, centre, term.sign));
                        add(&mut self.facets, first, own);
                    }
                }
            }
        }
        // What earlier pieces have as well is left by round-off.
        let found = &mut self.facets;
        found.retain(|on| on.sums.weight > CANCELLED * on.all);
        if nearest > 0.0 { Reached::Apart(nearest) } else { Reached::Touching }
    }

    /// Shows the pieces that rub on a facet: those of the face of the piece of the block that carries most there.
    pub fn rubbing(&self, on: &OnFacet, show: &mut dyn FnMut(&Polygon, &Frame)) {
        self.treaders[usize::from(on.piece)].rubbing(on.facet, show);
    }
}

/// A term where it is, and its centre from the centroid of the block, m.
fn place<'a>(term: &'a Term, pose: &Pose, normals: &'a mut Vec<Vec3>) -> (Body<'a>, Vec3) {
    normals.clear();
    let turn = turn(&term.shape, pose.rotation, normals);
    let centre = turn * term.centre;
    let body = Body { shape: &term.shape, normals, turn, position: pose.position + centre };
    (body, centre)
}

/// What a term has on a facet, counted `sign` times, about the centroid of its block.
fn about_block(on: &OnFacet, piece: usize, centre: Vec3, sign: f64) -> OnFacet {
    let mut sums = Sums { depth: on.sums.depth, ..Sums::default() };
    sums.plus(&on.sums, sign, centre);
    OnFacet {
        piece: piece as u16,
        sums,
        all: sign.abs() * on.sums.weight,
        offset: on.offset + on.slope.dot(centre),
        ..*on
    }
}

/// Adds what a term has to the facets of its piece, which begin at `first`.
fn add(facets: &mut Vec<OnFacet>, first: usize, own: impl Iterator<Item = OnFacet>) {
    for on in own {
        match facets[first..].iter_mut().find(|f| f.facet == on.facet) {
            Some(known) => {
                known.sums.plus(&on.sums, 1.0, Vec3::ZERO);
                known.all += on.all;
            }
            None => facets.push(on),
        }
    }
}
