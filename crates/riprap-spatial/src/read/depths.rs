//! How deep blocks have been pressed into each other, in units of the thinner one: the one measure that stops a run, that it is warned by and
//! that `model.max_closing` shows.
//!
//! A block is as thin as the largest ball inside it: of a prop of 0.1 m between blocks of 10 m only that says when the two large ones meet.
//! Found contacts, joints (of rigid and of deformable blocks), terrain and the half block behind a face with a condition are judged alike.

use riprap_geom::Vec3;

use crate::contact::{glued_of, shape_of};
use crate::query::view::View;
use crate::setup::BoundaryKind;
use crate::state::contact_scratch::{Deepest, Pressed};

impl View<'_> {
    /// Radius of the largest ball inside block `b`, of glued parts inside the thinnest piece, m; infinite for terrain, and where there is none
    /// that could be told.
    #[must_use]
    pub fn inradius(&self, b: usize) -> f64 {
        let world = self.world;
        if world.is_terrain(b) {
            return f64::INFINITY;
        }
        let find = || {
            let (shape, centre) = (&world.setup.blocks[b].shape, world.reference[b]);
            let glued = glued_of(shape, centre).ok().flatten().map(|g| g.inradius);
            let whole = || shape_of(shape, centre).map_or(f64::INFINITY, |s| s.inradius);
            glued.unwrap_or_else(whole)
        };
        // Once for all blocks of a class: it takes as long as some contacts.
        match self.scratch.inradii.get(world.solid[b] as usize) {
            Some(known) => *known.get_or_init(find),
            None => find(),
        }
    }

    /// What is deepest for its blocks of all that is pressed.
    #[must_use]
    pub fn deepest(&self) -> Option<Deepest> {
        Deepest::deeper(self.deepest_contact(), self.deepest_joint())
    }

    /// The found contact that is deepest for its blocks: rigid, on terrain, or deformable.
    #[must_use]
    pub fn deepest_contact(&self) -> Option<Deepest> {
        let others = self.deformable_depths();
        others
            .fold(self.scratch.desk.deepest, |deepest, other| Deepest::deeper(deepest, Some(other)))
    }

    /// The joint, or the face with a condition, that is closed deepest for its blocks.
    #[must_use]
    pub fn deepest_joint(&self) -> Option<Deepest> {
        let faces = self.face_depths().map(Some);
        let others = faces.chain([self.deepest_patch(), self.deepest_facet()]);
        others.fold(None, Deepest::deeper)
    }

    /// The joint of rigid blocks that is closed deepest.
    fn deepest_patch(&self) -> Option<Deepest> {
        let list = &self.world.patches;
        let source = !self.world.setup.found_contacts;
        let one = |p: usize| {
            let at = self.patch_points(p).at;
            let depth = at.iter().map(|a| -a[0]).fold(0.0, larger);
            if depth == 0.0 {
                return None;
            }
            let [i, j] = list.ends[p];
            let thinner = self.inradius(i as usize).min(self.inradius(j as usize));
            // Where blocks may pass through each other by a key of the scene, a joint alone is held to be lost where its sides have.
            let half = 0.5 * self.patch_class(p).distance;
            let reach = if source { thinner.max(half) } else { thinner };
            let deep = Deepest::new([i, j], Pressed::Joint, depth, reach);
            Some((deep.ratio, deep))
        };
        let found = self.scratch.exec.largest(list.len(), one);
        found.map(|(_, deep)| deep)
    }

    /// The joint with a deformable block that is closed deepest.
    fn deepest_facet(&self) -> Option<Deepest> {
        let deform = self.world.deform.as_deref()?;
        let freedoms = self.world.freedoms_with(deform);
        let one = |k: usize| {
            let facet = &deform.facets[k];
            if facet.parted {
                return None;
            }
            let anchors = deform.points[facet.points()].iter().map(|p| &p.anchors);
            let depth = anchors.map(|of| -freedoms.jump(of).dot(facet.now[0])).fold(0.0, larger);
            if depth == 0.0 {
                return None;
            }
            let [i, j] = facet.blocks;
            let reach = self.inradius(i as usize).min(self.inradius(j as usize));
            let deep = Deepest::new([i, j], Pressed::Joint, depth, reach);
            Some((deep.ratio, deep))
        };
        let found = self.scratch.exec.largest(deform.facets.len(), one);
        found.map(|(_, deep)| deep)
    }

    /// How far each face with a condition has been pressed into the half block behind it.
    fn face_depths(&self) -> impl Iterator<Item = Deepest> {
        let poses = self.poses();
        self.world.faces.iter().filter_map(move |face| {
            let (half, boundary) = (face.half_block.as_deref()?, face.boundary?);
            let b = face.block as usize;
            let holds = match &self.world.setup.boundaries[usize::from(boundary)].kind {
                BoundaryKind::Held { normal, .. } => *normal,
                BoundaryKind::Moved { velocity } => {
                    let along = |k: usize| velocity[k].is_some() || face.frame[0][k] == 0.0;
                    (0..3).all(along)
                }
                BoundaryKind::Viscous { half_cell } => *half_cell,
                BoundaryKind::Traction { .. } => false,
            };
            if !holds || !self.world.alive[b] || self.world.deforms(b) {
                return None;
            }
            let attitude = self.world.turned[b].as_ref().map(|_| poses.attitude(b));
            let (shift, turn) = (self.world.bodies.displacement(b), self.world.bodies.rotation(b));
            let moved = |arm: Vec3| match attitude {
                Some(q) => shift + (q * arm - arm),
                None => shift + turn.cross(arm),
            };
            let into = |p: usize| face.frame[0].dot(moved(face.place(p)) - half.anchor[p]);
            let depth = (0..4).map(into).fold(0.0, larger);
            let pressed = Pressed::Condition(boundary);
            (depth != 0.0).then(|| Deepest::new([face.block; 2], pressed, depth, self.inradius(b)))
        })
    }

    /// How deep each found contact of deformable blocks is.
    fn deformable_depths(&self) -> impl Iterator<Item = Deepest> {
        let pairs = self.world.found.deformable.pairs.iter();
        pairs
            .zip(&self.scratch.deformable.constants)
            .filter(|(pair, _)| pair.depth > 0.0)
            .map(|(pair, k)| Deepest::new(pair.ends, Pressed::Contact, pair.depth, k.peak))
    }
}

/// The larger of two depths; what is not a number counts as largest, so that it does not pass for shallow.
fn larger(a: f64, b: f64) -> f64 {
    if b > a || b.is_nan() { b } else { a }
}
