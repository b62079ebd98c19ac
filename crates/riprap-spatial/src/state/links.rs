//! What a step reads of points and nodes, close together in memory.
//!
//! [`Facet`] and [`Point`] say everything about a bond; a step of whole bonds needs a fifth of it. A point whose anchors are
//! single nodes (faces that match) is a [`Link`]; other points are looked up in the full lists.

use crate::state::deform::{Anchor, Deform, Facet, Point};

/// A facet as a step sees it while it is whole.
#[derive(Clone, Copy, Debug)]
pub struct PackedFacet {
    /// Unit normal now, from A to B.
    pub normal: [f64; 3],
    /// Normal and shear stiffness per area, Pa/m.
    pub stiffness: [f64; 2],
    /// Step before which it does not break.
    pub intact_until_step: u64,
    /// First point.
    pub first: u32,
    /// Number of points.
    pub count: u32,
    /// Index into `Setup::interfaces`.
    pub row: u16,
    /// Whether both anchors of all points are single nodes.
    pub plain: bool,
}

impl PackedFacet {
    fn new(facet: &Facet, points: &[Point]) -> Self {
        let mut anchors = points.iter().flat_map(|p| &p.anchors);
        let plain = anchors.all(|a| a.single().is_some());
        Self {
            normal: facet.now[0].to_array(),
            stiffness: facet.stiffness,
            intact_until_step: facet.intact_until_step,
            first: facet.first,
            count: facet.count,
            row: facet.row,
            plain,
        }
    }

    /// Its points.
    #[must_use]
    pub fn points(&self) -> std::ops::Range<usize> {
        self.first as usize..(self.first + self.count) as usize
    }
}

/// A point between two nodes.
#[derive(Clone, Copy, Debug)]
pub struct Link {
    /// First nodes of its anchors on A and B.
    pub nodes: [u32; 2],
    /// Its share of the area, m².
    pub area: f64,
}

/// A point of a facet as a body sees it.
#[derive(Clone, Copy, Debug)]
pub struct Hook {
    /// The point.
    pub point: u32,
    /// The node of the body, by its number there, or [`Hook::MANY`]; the highest bit is set on the side of B.
    to: u32,
}

impl Hook {
    /// Instead of a node: the anchor has several.
    pub const MANY: u32 = (1 << 31) - 1;

    /// How the body whose first node is `first` sees side `side` of a point.
    #[must_use]
    pub fn new(point: u32, side: usize, anchor: &Anchor, first: u32) -> Self {
        let node = anchor.single().map_or(Self::MANY, |node| node - first);
        let to = node | (side as u32) << 31;
        Self { point, to }
    }

    /// 0 on the side of A, 1 on that of B.
    #[inline(always)]
    #[must_use]
    pub fn side(&self) -> usize {
        (self.to >> 31) as usize
    }

    /// The node of the body, by its number there, or [`Hook::MANY`].
    #[inline(always)]
    #[must_use]
    pub fn node(&self) -> u32 {
        self.to & Self::MANY
    }
}

/// The lists of a step that only depend on how bodies are joined.
#[derive(Debug, Default)]
pub struct Links {
    /// *Shape* `[n_facets]`.
    pub sheets: Vec<PackedFacet>,
    /// *Shape* `[n_points]`.
    pub links: Vec<Link>,
    /// Points of each body: body `k` has `hooks[hooked[k]..hooked[k + 1]]`, in the order of the points.
    pub hooks: Vec<Hook>,
    /// See `hooks`.
    pub hooked: Vec<u32>,
    /// Facets with a rigid side.
    pub on_rigid: Vec<u32>,
}

impl Links {
    /// Lays out the lists for the bodies and bonds there are.
    #[must_use]
    pub fn new(deform: &Deform) -> Self {
        let sheet = |f: &Facet| PackedFacet::new(f, &deform.points[f.points()]);
        let link = |p: &Point| Link {
            nodes: p.anchors.map(|a| a.nodes().next().map_or(0, |(node, _)| node)),
            area: p.area,
        };
        let facets = deform.facets.iter().enumerate();
        let mut links = Self {
            sheets: deform.facets.iter().map(sheet).collect(),
            links: deform.points.iter().map(link).collect(),
            on_rigid: facets
                .filter(|(_, f)| f.rigid != [false; 2])
                .map(|(k, _)| k as u32)
                .collect(),
            ..Self::default()
        };
        links.hook(deform);
        links
    }

    fn hook(&mut self, deform: &Deform) {
        let mut counts = vec![0u32; deform.bodies.len() + 1];
        let sides = |visit: &mut dyn FnMut(usize, Hook)| {
            for facet in &deform.facets {
                for side in 0..2 {
                    if facet.rigid[side] {
                        continue;
                    }
                    let slot = deform.slot[facet.blocks[side] as usize] as usize;
                    let first = deform.bodies[slot].first;
                    for p in facet.points() {
                        let anchor = &deform.points[p].anchors[side];
                        visit(slot, Hook::new(p as u32, side, anchor, first));
                    }
                }
            }
        };
        sides(&mut |slot, _| counts[slot + 1] += 1);
        for k in 1..counts.len() {
            counts[k] += counts[k - 1];
        }
        let mut next = counts.clone();
        let total = counts.last().copied().unwrap_or(0) as usize;
        self.hooks = vec![Hook { point: 0, to: 0 }; total];
        sides(&mut |slot, hook| {
            self.hooks[next[slot] as usize] = hook;
            next[slot] += 1;
        });
        self.hooked = counts;
    }

    /// Points of body `k`.
    #[must_use]
    pub fn hooks_of(&self, k: usize) -> &[Hook] {
        &self.hooks[self.hooked[k] as usize..self.hooked[k + 1] as usize]
    }
}
